-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_450: 450x375, 48 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 48, window_px 9, reference left, cost census, census_width_px 9, census_pattern
--   even_columns, subpixel true, median true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_450
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_450 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 48;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 402;
    latency_clocks : positive := 49;
    flush_groups : positive := 3159;
    gap_groups : positive := 1800
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
  assert width_px = 450 report "stereo_core_census_450: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_census_450: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 48 report "stereo_core_census_450: disparities is " & integer'image(disparities) & " but this core has 48" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_450: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_census_450: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 402 report "stereo_core_census_450: output_width_px is " & integer'image(output_width_px) & " but this core has 402" severity failure;
  assert latency_clocks = 49 report "stereo_core_census_450: latency_clocks is " & integer'image(latency_clocks) & " but this core has 49" severity failure;
  assert flush_groups = 3159 report "stereo_core_census_450: flush_groups is " & integer'image(flush_groups) & " but this core has 3159" severity failure;
  assert gap_groups = 1800 report "stereo_core_census_450: gap_groups is " & integer'image(gap_groups) & " but this core has 1800" severity failure;
end entity;

architecture rtl of stereo_core_census_450 is
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
  type integer_minus_24_to_24_1d is array (natural range <>) of integer range -24 to 24;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_47_1d is array (natural range <>) of natural range 0 to 47;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8 is record
    valid, first_group, border_column, first_cost, leaves_window, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_6 is record
    valid, first_cost, leaves_window, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    first_cost, leaves_window : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 8, 0 to 4);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 4);
  signal transform_read_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 4);
  signal transform_ready_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 4);
  signal transform_columns_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_row_inside_4 : boolean_1d(0 to 1);  -- _#_row_inside_4
  signal transform_filtering_0_column_inside : boolean_1d(0 to 4);  -- _2#
  signal transform_filtering_1_column_inside_4 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16777215;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16777215;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16777215;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_24_1d(0 to 8);
  signal rows_search_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words : natural_16777215_1d(0 to 8);
  signal rows_search_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_search_rows_write_words : natural_16777215_1d(0 to 8);
  signal rows_reference_rows_read_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words : natural_16777215_1d(0 to 8);
  signal rows_reference_rows_ready_newest_0 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words : natural_16777215_1d(0 to 8);
  signal rows_search, rows_reference : natural_16777215_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_16777215_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag : tag_9;
  signal slice0cost_ready_tag, slice0cost_tag : tag_8;
  signal slice0cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words, slice0cost_ready_words, slice0cost_write_words : unsigned_32_1d(0 to 3);
  signal slice0cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice0cost_column_0 : natural_255_1d(0 to 15);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_32_1d(0 to 3);
  signal slice0window_entering_0 : natural_255_1d(0 to 15);
  signal slice0window_entering_tag : tag_8;
  signal slice0window_change_tag : tag_6;
  signal slice0window_centre_map_column_0, slice0window_centre_start_of_frame_0, slice0window_centre_end_of_line_0,
    slice0window_tag_valid : boolean;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice0window_sum_0 : natural_2047_1d(0 to 15);
  -- slice0winner1
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_first_0 : natural_2047_1d(1 to 7);
  signal slice0winner1_best_last_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_2047_1d(1 to 3);
  signal slice0winner2_best_last_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0, slice0winner3_best_below_0, slice0winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0, slice0winner4_best_above_0_0,
    slice0winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0,
    slice0_best_last_0_0 : natural range 0 to 2047;
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice1shift_reference, slice1shift_search_out : natural_16777215_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice1cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words, slice1cost_ready_words, slice1cost_write_words : unsigned_32_1d(0 to 3);
  signal slice1cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice1cost_column_0 : natural_255_1d(0 to 15);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_32_1d(0 to 3);
  signal slice1window_entering_0 : natural_255_1d(0 to 15);
  signal slice1window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice1window_change_tag : tag_2;
  signal slice1window_centre_map_column_0, slice1window_centre_start_of_frame_0,
    slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_2047_1d(0 to 15);
  -- slice1winner1
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0, slice1winner1_best_first_0,
    slice1winner1_best_last_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0, slice1winner2_best_first_0,
    slice1winner2_best_last_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  -- slice1winner3
  signal slice1winner3_best_cost_0, slice1winner3_best_below_0, slice1winner3_best_above_0, slice1winner3_best_first_0,
    slice1winner3_best_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0, slice1winner4_best_above_0_0,
    slice1winner4_best_first_0_0, slice1winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0,
    slice1_best_last_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_16777215_2d(0 to 1, 0 to 15);
  signal slice2shift_reference : natural_16777215_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice2cost_pixels_cost : natural_24_2d(0 to 1, 0 to 15);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column,
    slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words, slice2cost_ready_words, slice2cost_write_words : unsigned_32_1d(0 to 3);
  signal slice2cost_change_0 : integer_minus_24_to_24_1d(0 to 15);
  signal slice2cost_column_0 : natural_255_1d(0 to 15);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving : unsigned_32_1d(0 to 3);
  signal slice2window_entering_0 : natural_255_1d(0 to 15);
  signal slice2window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice2window_change_tag_first_cost : boolean;
  signal slice2window_centre_map_column, slice2window_centre_start_of_frame,
    slice2window_centre_end_of_line : boolean_1d(0 to 2);
  signal slice2window_sum_0 : natural_2047_1d(0 to 15);
  -- slice2winner1
  signal slice2winner1_best_cost_0, slice2winner1_best_below_0, slice2winner1_best_above_0,
    slice2winner1_best_first_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_last_0 : natural_2047_1d(0 to 6);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice2winner2
  signal slice2winner2_best_cost_0, slice2winner2_best_below_0, slice2winner2_best_above_0,
    slice2winner2_best_first_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_last_0 : natural_2047_1d(0 to 2);
  signal slice2winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  -- slice2winner3
  signal slice2winner3_best_cost_0, slice2winner3_best_below_0, slice2winner3_best_above_0,
    slice2winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0, slice2winner4_best_above_0_0,
    slice2winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0 : natural range 0 to 2047;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_tag : tag_4;
  -- refinement
  signal refinement_disparity_0 : natural_47_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 3);  -- _#_0
  signal refinement_passed_0s : boolean_1d(5 to 8);  -- _#_0
  signal refinement_passed_11_0 : boolean;
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_tag_11_row_start : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0,
    refinement_v_0 : natural range 0 to 2047;
  signal refinement_remainder_0, refinement_divisor_0 : natural_2047_1d(0 to 7);  -- _#_0
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_counter_column, map_counter_group, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 511;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind, map_at_top,
    map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a, map_of_column_0_c_below_b : boolean;
  signal map_column_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output, map_sorted_arrives,
    map_sorted_behind, map_sorted_top, map_sorted_output : boolean;
  signal map_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal map_window_complete, map_window_first, map_window_last, map_of_low_0_b_below_a, map_of_low_0_c_below_a,
    map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a, map_of_middle_0_c_below_b,
    map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b, map_of_all_0_b_below_a,
    map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_waiting_complete : boolean_1d(0 to 2);  -- _#_complete
  signal map_waiting_first : boolean_1d(0 to 2);  -- _#_first
  signal map_waiting_last : boolean_1d(0 to 2);  -- _#_last
  signal map_waiting_passed_0 : boolean_1d(0 to 2);  -- _#_0
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0, map_column_2 : natural range 0 to 65535;
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_column_1 : natural range 0 to 8191;
  signal map_of_column_0_a, map_of_column_0_b : natural range 0 to 4095;
  signal map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 32767;
  signal map_low_0, map_middle_0, map_high_0 : natural_32767_1d(0 to 2);  -- _#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c,
    map_of_high_0_a, map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0, map_smallest_high_0,
    map_of_all_0_a, map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 32767;
  -- other
  signal other : boolean_1d(0 to 8);
  signal other_9, other_11 : unsigned(48 downto 0);
  signal other_10 : natural range 0 to 8190;
  signal other_12 : natural range 0 to 254;
  signal other_13 : natural range 0 to 252;
  signal other_14 : natural range 0 to 248;
  signal other_15 : natural range 0 to 240;
  signal other_16 : natural range 0 to 224;
  signal other_17 : natural range 0 to 192;
  signal other_18 : natural range 0 to 128;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 9);
    write_address <= to_unsigned(map_at_column, 9);
    write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (402, 26, 9)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  slice2window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 4);
    write_address <= to_unsigned(slice2window_ring_write_address, 4);
    write_data <= to_unsigned(slice2cost_column_0(4 * i + 3), 8) & to_unsigned(slice2cost_column_0(4 * i + 2), 8) &
      to_unsigned(slice2cost_column_0(4 * i + 1), 8) & to_unsigned(slice2cost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, slice2window_leaving(i), write_address, write_data);
  end generate;

  slice2cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_read_column, 9);
    write_address <= to_unsigned(slice2cost_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, slice2cost_read_words(i), write_address, slice2cost_write_words(i));
  end generate;

  slice1window_leaving_memory : for i in 3 downto 0 generate
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

  slice1cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, slice1cost_write_words(i));
  end generate;

  slice0window_leaving_memory : for i in 3 downto 0 generate
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

  slice0cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    cell : entity work.line_memory generic map (450, 32, 9)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, slice0cost_write_words(i));
  end generate;

  rows_search_rows_read_words_memory : for i in 8 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (450, 24, 9)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_memory : for i in 8 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 24);
    cell : entity work.line_memory generic map (450, 24, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  process
    variable transform_counter_group_is_equals, refinement_tag_11_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      slice0winner4_best_cost_0_0_is_less, slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less,
      slice2winner4_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less, refinement_tag_11_row_start_differs,
      refinement_divisor_0_0_is_less, map_counter_group_is_equal, map_line_ended_choice, map_at_arrives_value,
      map_window_complete_is_equal, map_window_complete_choice : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices, map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(7 to 193);
    variable transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice1cost_column_0_choice,
      slice2cost_column_0_choice : natural_255_2d(0 to 15, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice,
      slice2window_change_0_choice : natural_255_1d(0 to 15);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice, slice2window_sum_0_choice : natural_2047_1d(0 to 15);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less,
      slice2winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less,
      slice2winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice, slice1winner2_best_below_0_choice,
      slice1winner2_best_above_0_choice, slice2winner2_best_below_0_choice,
      slice2winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- _#_choice
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less,
      slice2winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable slice0winner3_best_below_0_choice, slice0winner3_best_above_0_choice, slice1winner3_best_below_0_choice,
      slice1winner3_best_above_0_choice, slice2winner3_best_below_0_choice,
      slice2winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- _#_choice
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice,
      slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice, slice1_best_below_0_0_choice,
      slice1_best_above_0_0_choice, slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice,
      slice2_best_below_0_0_choice, slice2_best_above_0_0_choice,
      refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_tag_11_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable refinement_tag_11_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable map_of_column_0_a_choice : natural range 0 to 4095;
    variable map_of_column_0_c_choice, map_low_0_0_choice, map_middle_0_0_choice,
      map_high_0_0_choice : natural range 0 to 32767;
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 374;
    transform_counter_group_is_equals(2) := transform_counter_column = 449;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 375, 0);
    transform_counter_group_differs := transform_counter_group /= 377;
    transform_counter_group_choices(2) := choice((transform_counter_group = 376) and transform_counter_next_frame, 2,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(4, 2), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(4, 2), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 2), i);
    end loop;
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(8 * i + 7) := not is_larger(transform_left_filter_column(0, 2 * i + 1),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(8 * i + 8) := choice(transform_left_filter_feature_0_choice(8 * i + 7),
        transform_filtering_0_column_inside(0) and is_set(transform_left_filter_column(0, 2 * i + 1), 7) and (not
        is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(0) and
        (is_set(transform_left_filter_column(0, 2 * i + 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
    end loop;
    transform_left_filter_feature_0_choice(17) := choice(is_set(transform_left_filter_column(0, 0), 0),
      (transform_left_filter_column(4, 2) mod 4) = 3, transform_left_filter_feature_0_values(1));
    transform_left_filter_feature_0_choice(18) := choice(is_set(transform_left_filter_column(0, 0), 1),
      transform_left_filter_feature_0_choice(17), (not is_set(transform_left_filter_column(0, 0), 0)) or
      transform_left_filter_feature_0_values(1) or is_set(transform_left_filter_column(4, 2), 0));
    transform_left_filter_feature_0_values(7) := is_set(transform_left_filter_column(0, 0), 2);
    transform_left_filter_feature_0_choice(19) := inverted_carry(transform_left_filter_feature_0_choice(18),
      transform_left_filter_feature_0_values(7), not transform_left_filter_feature_0_values(2));
    for i in 8 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
      transform_left_filter_feature_0_choice(i + 12) := carry(transform_left_filter_feature_0_choice(i + 11),
        transform_left_filter_feature_0_values(i), not transform_left_filter_feature_0_values(i - 5));
    end loop;
    transform_left_filter_feature_0_choice(24) := choice(is_set(transform_left_filter_column(0, 0), 7),
      transform_filtering_0_column_inside(0), transform_filtering_0_column_inside(0) and (not
      is_set(transform_left_filter_column(4, 2), 7)));
    transform_left_filter_feature_0_choice(25) := choice(transform_left_filter_feature_0_choice(23),
      transform_left_filter_feature_0_choice(24), is_set(transform_left_filter_column(0, 0), 7) and
      transform_filtering_0_column_inside(0) and (not is_set(transform_left_filter_column(4, 2), 7)));
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(72 * i + 32) := not is_larger(transform_left_filter_column(4 * i, 2 - i),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 33) := choice(transform_left_filter_feature_0_choice(72 * i +
        32), transform_filtering_0_column_inside(2 * i) and is_set(transform_left_filter_column(4 * i, 2 - i), 7) and
        (not is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i) and
        (is_set(transform_left_filter_column(4 * i, 2 - i), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
      transform_left_filter_feature_0_choice(72 * i + 40) := not is_larger(transform_left_filter_column(4 * i, 4),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 41) := choice(transform_left_filter_feature_0_choice(72 * i +
        40), transform_filtering_0_column_inside(2 * i) and is_set(transform_left_filter_column(4 * i, 4), 7) and (not
        is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i) and
        (is_set(transform_left_filter_column(4 * i, 4), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
      transform_left_filter_feature_0_choice(72 * i + 48) := not is_larger(transform_left_filter_column(4 * i + 2, 3),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 49) := choice(transform_left_filter_feature_0_choice(72 * i +
        48), transform_filtering_0_column_inside(2 * i + 1) and is_set(transform_left_filter_column(4 * i + 2, 3), 7)
        and (not is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 1) and
        (is_set(transform_left_filter_column(4 * i + 2, 3), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
      transform_left_filter_feature_0_choice(72 * i + 56) := not is_larger(transform_left_filter_column(4 * i + 2, 1),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 57) := choice(transform_left_filter_feature_0_choice(72 * i +
        56), transform_filtering_0_column_inside(2 * i + 1) and is_set(transform_left_filter_column(4 * i + 2, 1), 7)
        and (not is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 1) and
        (is_set(transform_left_filter_column(4 * i + 2, 1), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
      for j in 0 to 2 loop
        transform_left_filter_feature_0_choice(72 * i + 8 * j + 64) := not is_larger(transform_left_filter_column(4 * i
          + 2, 2 * j), transform_left_filter_column(4, 2), 0, 6, false);
        transform_left_filter_feature_0_choice(72 * i + 8 * j + 65) := choice(transform_left_filter_feature_0_choice(72
          * i + 8 * j + 64), transform_filtering_0_column_inside(2 * i + 1) and is_set(transform_left_filter_column(4 *
          i + 2, 2 * j), 7) and (not is_set(transform_left_filter_column(4, 2), 7)),
          transform_filtering_0_column_inside(2 * i + 1) and (is_set(transform_left_filter_column(4 * i + 2, 2 * j), 7)
          or (not is_set(transform_left_filter_column(4, 2), 7))));
      end loop;
      transform_left_filter_feature_0_choice(72 * i + 88) := not is_larger(transform_left_filter_column(4 * i + 4, 3),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 89) := choice(transform_left_filter_feature_0_choice(72 * i +
        88), transform_filtering_0_column_inside(2 * i + 2) and is_set(transform_left_filter_column(4 * i + 4, 3), 7)
        and (not is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 2) and
        (is_set(transform_left_filter_column(4 * i + 4, 3), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
      transform_left_filter_feature_0_choice(72 * i + 96) := not is_larger(transform_left_filter_column(4 * i + 4, i),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(72 * i + 97) := choice(transform_left_filter_feature_0_choice(72 * i +
        96), transform_filtering_0_column_inside(2 * i + 2) and is_set(transform_left_filter_column(4 * i + 4, i), 7)
        and (not is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 2) and
        (is_set(transform_left_filter_column(4 * i + 4, i), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
    end loop;
    for i in 0 to 2 loop
      transform_left_filter_feature_0_choice(8 * i + 176) := not is_larger(transform_left_filter_column(8, 2 * i),
        transform_left_filter_column(4, 2), 0, 6, false);
      transform_left_filter_feature_0_choice(8 * i + 177) := choice(transform_left_filter_feature_0_choice(8 * i +
        176), transform_filtering_0_column_inside(4) and is_set(transform_left_filter_column(8, 2 * i), 7) and (not
        is_set(transform_left_filter_column(4, 2), 7)), transform_filtering_0_column_inside(4) and
        (is_set(transform_left_filter_column(8, 2 * i), 7) or (not is_set(transform_left_filter_column(4, 2), 7))));
    end loop;
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(4, 2), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(4, 2), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 2) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 2), i);
    end loop;
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(8 * i + 7) := not is_larger(transform_right_filter_column(0, 2 * i + 1),
        transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(8 * i + 8) := choice(transform_right_filter_feature_0_choice(8 * i + 7),
        transform_filtering_0_column_inside(0) and is_set(transform_right_filter_column(0, 2 * i + 1), 7) and (not
        is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(0) and
        (is_set(transform_right_filter_column(0, 2 * i + 1), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
    end loop;
    transform_right_filter_feature_0_choice(17) := choice(is_set(transform_right_filter_column(0, 0), 0),
      (transform_right_filter_column(4, 2) mod 4) = 3, transform_right_filter_feature_0_values(1));
    transform_right_filter_feature_0_choice(18) := choice(is_set(transform_right_filter_column(0, 0), 1),
      transform_right_filter_feature_0_choice(17), (not is_set(transform_right_filter_column(0, 0), 0)) or
      transform_right_filter_feature_0_values(1) or is_set(transform_right_filter_column(4, 2), 0));
    transform_right_filter_feature_0_values(7) := is_set(transform_right_filter_column(0, 0), 2);
    transform_right_filter_feature_0_choice(19) := inverted_carry(transform_right_filter_feature_0_choice(18),
      transform_right_filter_feature_0_values(7), not transform_right_filter_feature_0_values(2));
    for i in 8 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
      transform_right_filter_feature_0_choice(i + 12) := carry(transform_right_filter_feature_0_choice(i + 11),
        transform_right_filter_feature_0_values(i), not transform_right_filter_feature_0_values(i - 5));
    end loop;
    transform_right_filter_feature_0_choice(24) := choice(is_set(transform_right_filter_column(0, 0), 7),
      transform_filtering_0_column_inside(0), transform_filtering_0_column_inside(0) and (not
      is_set(transform_right_filter_column(4, 2), 7)));
    transform_right_filter_feature_0_choice(25) := choice(transform_right_filter_feature_0_choice(23),
      transform_right_filter_feature_0_choice(24), is_set(transform_right_filter_column(0, 0), 7) and
      transform_filtering_0_column_inside(0) and (not is_set(transform_right_filter_column(4, 2), 7)));
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(72 * i + 32) := not is_larger(transform_right_filter_column(4 * i, 2 -
        i), transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 33) := choice(transform_right_filter_feature_0_choice(72 * i +
        32), transform_filtering_0_column_inside(2 * i) and is_set(transform_right_filter_column(4 * i, 2 - i), 7) and
        (not is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i) and
        (is_set(transform_right_filter_column(4 * i, 2 - i), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
      transform_right_filter_feature_0_choice(72 * i + 40) := not is_larger(transform_right_filter_column(4 * i, 4),
        transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 41) := choice(transform_right_filter_feature_0_choice(72 * i +
        40), transform_filtering_0_column_inside(2 * i) and is_set(transform_right_filter_column(4 * i, 4), 7) and (not
        is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i) and
        (is_set(transform_right_filter_column(4 * i, 4), 7) or (not is_set(transform_right_filter_column(4, 2), 7))));
      transform_right_filter_feature_0_choice(72 * i + 48) := not is_larger(transform_right_filter_column(4 * i + 2,
        3), transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 49) := choice(transform_right_filter_feature_0_choice(72 * i +
        48), transform_filtering_0_column_inside(2 * i + 1) and is_set(transform_right_filter_column(4 * i + 2, 3), 7)
        and (not is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 1) and
        (is_set(transform_right_filter_column(4 * i + 2, 3), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
      transform_right_filter_feature_0_choice(72 * i + 56) := not is_larger(transform_right_filter_column(4 * i + 2,
        1), transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 57) := choice(transform_right_filter_feature_0_choice(72 * i +
        56), transform_filtering_0_column_inside(2 * i + 1) and is_set(transform_right_filter_column(4 * i + 2, 1), 7)
        and (not is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 1) and
        (is_set(transform_right_filter_column(4 * i + 2, 1), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
      for j in 0 to 2 loop
        transform_right_filter_feature_0_choice(72 * i + 8 * j + 64) := not is_larger(transform_right_filter_column(4 *
          i + 2, 2 * j), transform_right_filter_column(4, 2), 0, 6, false);
        transform_right_filter_feature_0_choice(72 * i + 8 * j + 65) :=
          choice(transform_right_filter_feature_0_choice(72 * i + 8 * j + 64), transform_filtering_0_column_inside(2 *
          i + 1) and is_set(transform_right_filter_column(4 * i + 2, 2 * j), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 1) and
          (is_set(transform_right_filter_column(4 * i + 2, 2 * j), 7) or (not is_set(transform_right_filter_column(4,
          2), 7))));
      end loop;
      transform_right_filter_feature_0_choice(72 * i + 88) := not is_larger(transform_right_filter_column(4 * i + 4,
        3), transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 89) := choice(transform_right_filter_feature_0_choice(72 * i +
        88), transform_filtering_0_column_inside(2 * i + 2) and is_set(transform_right_filter_column(4 * i + 4, 3), 7)
        and (not is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 2) and
        (is_set(transform_right_filter_column(4 * i + 4, 3), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
      transform_right_filter_feature_0_choice(72 * i + 96) := not is_larger(transform_right_filter_column(4 * i + 4,
        i), transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(72 * i + 97) := choice(transform_right_filter_feature_0_choice(72 * i +
        96), transform_filtering_0_column_inside(2 * i + 2) and is_set(transform_right_filter_column(4 * i + 4, i), 7)
        and (not is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(2 * i + 2) and
        (is_set(transform_right_filter_column(4 * i + 4, i), 7) or (not is_set(transform_right_filter_column(4, 2),
        7))));
    end loop;
    for i in 0 to 2 loop
      transform_right_filter_feature_0_choice(8 * i + 176) := not is_larger(transform_right_filter_column(8, 2 * i),
        transform_right_filter_column(4, 2), 0, 6, false);
      transform_right_filter_feature_0_choice(8 * i + 177) := choice(transform_right_filter_feature_0_choice(8 * i +
        176), transform_filtering_0_column_inside(4) and is_set(transform_right_filter_column(8, 2 * i), 7) and (not
        is_set(transform_right_filter_column(4, 2), 7)), transform_filtering_0_column_inside(4) and
        (is_set(transform_right_filter_column(8, 2 * i), 7) or (not is_set(transform_right_filter_column(4, 2), 7))));
    end loop;
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
      (transform_counter_group mod 4)) < 375;
    transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 378);
    transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 375;
    transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 376);
    transform_read_row_inside(4) <= transform_counter_group < 375;
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    for i in 1 to 4 loop
      transform_read_column_inside(i) <= (transform_counter_column < (2 * i)) /= transform_read_column_inside_0_is_less;
    end loop;
    transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
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
    transform_left_filter_feature_0 <= (as_number(transform_left_filter_feature_0_choice(8)) * 2) +
      (as_number(transform_left_filter_feature_0_choice(16)) * 8) +
      as_number(transform_left_filter_feature_0_choice(25)) + (as_number(transform_left_filter_feature_0_choice(33)) *
      4) + (as_number(transform_left_filter_feature_0_choice(41)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(49)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(57)) * 64) +
      (as_number(transform_left_filter_feature_0_choice(65)) * 32) +
      (as_number(transform_left_filter_feature_0_choice(73)) * 128) +
      (as_number(transform_left_filter_feature_0_choice(81)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(89)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(97)) * 1024) +
      (as_number(transform_left_filter_feature_0_choice(105)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(113)) * 8192) +
      (as_number(transform_left_filter_feature_0_choice(121)) * 131072) +
      (as_number(transform_left_filter_feature_0_choice(129)) * 32768) +
      (as_number(transform_left_filter_feature_0_choice(137)) * 16384) +
      (as_number(transform_left_filter_feature_0_choice(145)) * 65536) +
      (as_number(transform_left_filter_feature_0_choice(153)) * 262144) +
      (as_number(transform_left_filter_feature_0_choice(161)) * 4194304) +
      (as_number(transform_left_filter_feature_0_choice(169)) * 1048576) +
      (as_number(transform_left_filter_feature_0_choice(177)) * 524288) +
      (as_number(transform_left_filter_feature_0_choice(185)) * 2097152) +
      (as_number(transform_left_filter_feature_0_choice(193)) * 8388608);
    transform_right_filter_feature_0 <= (as_number(transform_right_filter_feature_0_choice(8)) * 2) +
      (as_number(transform_right_filter_feature_0_choice(16)) * 8) +
      as_number(transform_right_filter_feature_0_choice(25)) + (as_number(transform_right_filter_feature_0_choice(33))
      * 4) + (as_number(transform_right_filter_feature_0_choice(41)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(49)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(57)) * 64) +
      (as_number(transform_right_filter_feature_0_choice(65)) * 32) +
      (as_number(transform_right_filter_feature_0_choice(73)) * 128) +
      (as_number(transform_right_filter_feature_0_choice(81)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(89)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(97)) * 1024) +
      (as_number(transform_right_filter_feature_0_choice(105)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(113)) * 8192) +
      (as_number(transform_right_filter_feature_0_choice(121)) * 131072) +
      (as_number(transform_right_filter_feature_0_choice(129)) * 32768) +
      (as_number(transform_right_filter_feature_0_choice(137)) * 16384) +
      (as_number(transform_right_filter_feature_0_choice(145)) * 65536) +
      (as_number(transform_right_filter_feature_0_choice(153)) * 262144) +
      (as_number(transform_right_filter_feature_0_choice(161)) * 4194304) +
      (as_number(transform_right_filter_feature_0_choice(169)) * 1048576) +
      (as_number(transform_right_filter_feature_0_choice(177)) * 524288) +
      (as_number(transform_right_filter_feature_0_choice(185)) * 2097152) +
      (as_number(transform_right_filter_feature_0_choice(193)) * 8388608);
    transform_filtering_row_inside_4(0) <= refinement_passed_0s(8);
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_row_inside_4(1) <= transform_filtering_row_inside_4(0);
    transform_filtering_1_column_inside_4 <= refinement_passed_0(3);
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice,
      transform_counter_group_choices(3));
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      376) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 512);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2), (not in_start_of_frame) or
        transform_counter_group_all, in_start_of_frame and transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2));
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
        transform_left_rows_ready_words_0(31 downto 8);
      transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
        transform_right_rows_ready_words_0(31 downto 8);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_columns_valid then
      for i in 0 to 3 loop
        for j in 0 to 4 loop
          transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
        end loop;
        for j in 0 to 4 loop
          transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 3 loop
        for j in 0 to 4 loop
          transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
        end loop;
        for j in 0 to 4 loop
          transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 4 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equal := raster_place_column = 449;
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1), 0,
      (raster_place_group + as_number(((raster_place_group /= 379) and transform_filtering_valid(1) and
      raster_place_group_is_equal))) mod 512);
    if transform_filtering_valid(1) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(1), 0,
        (raster_place_column + 1) mod 512);
    end if;
    -- delay
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 384);
    delay_row_inside(1) <= raster_place_group < 375;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 47;
    delay_tag.first_cost <= raster_place_column = 47;
    delay_tag.leaves_window <= (((((raster_place_column / 8) + 8185) mod 8192) * 8) + (raster_place_column mod 8)) <
      65484;
    delay_tag.map_column <= (((((raster_place_column / 16) + 4093) mod 4096) * 16) + (raster_place_column mod 16)) <
      402;
    delay_tag.start_of_frame <= (raster_place_group = 4) and (raster_place_column = 48);
    delay_tag.end_of_line <= raster_place_group_is_equal;
    -- rows
    rows_search_rows_read_newest_0 <= delay_delayed_0;
    for i in 0 to 8 loop rows_search_rows_ready_words(i) <= to_integer(rows_search_rows_read_words(i)); end loop;
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
    for i in 0 to 8 loop rows_reference_rows_ready_words(i) <= to_integer(rows_reference_rows_read_words(i)); end loop;
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
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0 to 7) <= rows_search_rows_ready_words(1 to 8);
      rows_search_rows_write_words(8) <= rows_search_rows_ready_newest_0;
      rows_reference_rows_write_words(0 to 7) <= rows_reference_rows_ready_words(1 to 8);
      rows_reference_rows_write_words(8) <= rows_reference_rows_ready_newest_0;
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 1 loop
        slice0shift_search(i, 0) <= rows_search(i);
        for j in 1 to 15 loop slice0shift_search(i, j) <= slice0shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 15);
    slice0shift_search_out(1) <= slice0shift_search(1, 15);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice0cost_column_0_choice(4 * i + j, 1) := choice(slice0cost_ready_tag.first_group, 0,
          to_integer(slice0cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice0cost_column_0_choice(4 * i + j, 2) := choice(slice0cost_ready_tag.border_column, 0,
          (slice0cost_change_0(4 * i + j) + slice0cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
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
      for j in 1 to 15 loop
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
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 0) + slice0cost_pixels_first_count(i, j, 2)
          + slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j, 5) +
          slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 4) +
          slice0cost_pixels_first_count(i, j, 7) + slice0cost_pixels_first_count(i, j, 1);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 15 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    slice0cost_ready_words <= slice0cost_read_words;
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag.valid <= slice0cost_pixels_tag.valid;
    slice0cost_ready_tag.first_group <= slice0cost_pixels_tag.first_group;
    slice0cost_ready_tag.border_column <= slice0cost_pixels_tag.border_column;
    slice0cost_ready_tag.first_cost <= slice0cost_pixels_tag.first_cost;
    slice0cost_ready_tag.leaves_window <= slice0cost_pixels_tag.leaves_window;
    slice0cost_ready_tag.map_column <= slice0cost_pixels_tag.map_column;
    slice0cost_ready_tag.start_of_frame <= slice0cost_pixels_tag.start_of_frame;
    slice0cost_ready_tag.end_of_line <= slice0cost_pixels_tag.end_of_line;
    for i in 0 to 15 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
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
      for i in 0 to 3 loop
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
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice0window_change_0_choice(4 * i + j) := choice(slice0window_entering_tag.leaves_window,
          to_integer(slice0window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag <= slice0cost_tag;
    for i in 0 to 15 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag.valid <= slice0window_entering_tag.valid;
    slice0window_change_tag.first_cost <= slice0window_entering_tag.first_cost;
    slice0window_change_tag.leaves_window <= slice0window_entering_tag.leaves_window;
    slice0window_change_tag.map_column <= slice0window_entering_tag.map_column;
    slice0window_change_tag.start_of_frame <= slice0window_entering_tag.start_of_frame;
    slice0window_change_tag.end_of_line <= slice0window_entering_tag.end_of_line;
    slice0window_centre_map_column_0 <= slice0window_change_tag.map_column;
    slice0window_centre_start_of_frame_0 <= slice0window_change_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag_valid <= slice0window_change_tag.valid;
    for i in 0 to 15 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 15 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 2048;
      end loop;
    end if;
    -- slice0winner1
    for i in 0 to 7 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    for i in 1 to 7 loop slice0winner1_best_first_0(i) <= slice0window_sum_0(2 * i); end loop;
    for i in 0 to 7 loop slice0winner1_best_last_0(i) <= slice0window_sum_0(2 * i + 1); end loop;
    slice0winner1_tag.valid <= slice0window_tag_valid;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 0 to 6 loop
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i), 0);
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 0, slice0window_sum_0(2 * i + 1));
      slice0winner1_best_cost_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), slice0window_sum_0(2 * i +
        3), slice0window_sum_0(2 * i + 2));
      slice0winner1_best_index_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice0winner1_best_below_0(7) <= choice(slice0winner1_best_cost_0_is_less(7), slice0window_sum_0(14), 0);
    slice0winner1_best_above_0(7) <= choice(slice0winner1_best_cost_0_is_less(7), 0, slice0window_sum_0(15));
    if slice0winner1_tag.valid then
      slice0winner1_tag.map_column <= slice2window_centre_map_column(2);
      slice0winner1_tag.start_of_frame <= slice2window_centre_start_of_frame(2);
      slice0winner1_tag.end_of_line <= slice2window_centre_end_of_line(2);
    end if;
    -- slice0winner2
    for i in 0 to 3 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_below_0_choice(0) := choice(slice0winner1_best_index_0(1) = 2, slice0winner1_best_last_0(0),
      slice0winner1_best_below_0(1));
    slice0winner2_best_below_0_choice(1) := choice(slice0winner1_best_index_0(3) = 6, slice0winner1_best_last_0(2),
      slice0winner1_best_below_0(3));
    slice0winner2_best_below_0_choice(2) := choice(is_set(slice0winner1_best_index_0(5), 3) and
      ((slice0winner1_best_index_0(5) mod 4) = 2), slice0winner1_best_last_0(4), slice0winner1_best_below_0(5));
    slice0winner2_best_below_0_choice(3) := choice(slice0winner1_best_index_0(7) = 14, slice0winner1_best_last_0(6),
      slice0winner1_best_below_0(7));
    slice0winner2_best_above_0_choice(0) := choice(slice0winner1_best_index_0_0, slice0winner1_best_first_0(1),
      slice0winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice0winner2_best_above_0_choice(i) := choice(other(i + 5), slice0winner1_best_first_0(2 * i + 1),
        slice0winner1_best_above_0(2 * i));
    end loop;
    slice0winner2_best_first_0(1) <= slice0winner1_best_first_0(2);
    slice0winner2_best_first_0(2) <= slice0winner1_best_first_0(4);
    slice0winner2_best_first_0(3) <= slice0winner1_best_first_0(6);
    slice0winner2_best_last_0(0) <= slice0winner1_best_last_0(1);
    slice0winner2_best_last_0(1) <= slice0winner1_best_last_0(3);
    slice0winner2_best_last_0(2) <= slice0winner1_best_last_0(5);
    slice0winner2_best_last_0(3) <= slice0winner1_best_last_0(7);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice0winner2_best_below_0(i) <= choice(slice0winner2_best_cost_0_is_less(i),
        slice0winner2_best_below_0_choice(i), slice0winner1_best_below_0(2 * i));
      slice0winner2_best_above_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_above_0(2 * i +
        1), slice0winner2_best_above_0_choice(i));
      slice0winner2_best_cost_0(i + 1) <= choice(slice0winner2_best_cost_0_is_less(i + 1), slice0winner1_best_cost_0(2
        * i + 3), slice0winner1_best_cost_0(2 * i + 2));
      slice0winner2_best_index_0(i + 1) <= choice(slice0winner2_best_cost_0_is_less(i + 1),
        slice0winner1_best_index_0(2 * i + 3), slice0winner1_best_index_0(2 * i + 2));
    end loop;
    slice0winner2_best_below_0(3) <= choice(slice0winner2_best_cost_0_is_less(3), slice0winner2_best_below_0_choice(3),
      slice0winner1_best_below_0(6));
    slice0winner2_best_above_0(3) <= choice(slice0winner2_best_cost_0_is_less(3), slice0winner1_best_above_0(7),
      slice0winner2_best_above_0_choice(3));
    -- slice0winner3
    slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
    slice0winner3_best_below_0_choice(0) := choice(slice0winner2_best_index_0(1) = 4, slice0winner2_best_last_0(0),
      slice0winner2_best_below_0(1));
    slice0winner3_best_below_0_choice(1) := choice(slice0winner2_best_index_0(3) = 12, slice0winner2_best_last_0(2),
      slice0winner2_best_below_0(3));
    slice0winner3_best_above_0_choice(0) := choice(slice0winner2_best_index_0(0) = 3, slice0winner2_best_first_0(1),
      slice0winner2_best_above_0(0));
    slice0winner3_best_above_0_choice(1) := choice(is_set(slice0winner2_best_index_0(2), 3) and
      ((slice0winner2_best_index_0(2) mod 4) = 3), slice0winner2_best_first_0(3), slice0winner2_best_above_0(2));
    slice0winner3_best_first_0_1 <= slice0winner2_best_first_0(2);
    slice0winner3_best_last_0(0) <= slice0winner2_best_last_0(1);
    slice0winner3_best_last_0(1) <= slice0winner2_best_last_0(3);
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 1 loop
      slice0winner3_best_cost_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_cost_0(2 * i +
        1), slice0winner2_best_cost_0(2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
      slice0winner3_best_below_0(i) <= choice(slice0winner3_best_cost_0_is_less(i),
        slice0winner3_best_below_0_choice(i), slice0winner2_best_below_0(2 * i));
      slice0winner3_best_above_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_above_0(2 * i +
        1), slice0winner3_best_above_0_choice(i));
    end loop;
    -- slice0winner4
    slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_below_0_0_choice := choice(slice0winner3_best_index_0(1) = 8, slice0winner3_best_last_0(0),
      slice0winner3_best_below_0(1));
    slice0winner4_best_above_0_0_choice := choice(slice0winner3_best_index_0(0) = 7, slice0winner3_best_first_0_1,
      slice0winner3_best_above_0(0));
    slice0winner4_best_last_0_0 <= slice0winner3_best_last_0(1);
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
    slice0_best_index_0_0 <= slice0winner4_best_index_0_0;
    slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
    slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
    slice0_best_last_0_0 <= slice0winner4_best_last_0_0;
    slice0_best_tag <= slice0winner4_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        slice1shift_search(i, 0) <= slice0shift_search_out(i);
        for j in 1 to 15 loop slice1shift_search(i, j) <= slice1shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 15);
    slice1shift_search_out(1) <= slice1shift_search(1, 15);
    -- slice1cost
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice1cost_column_0_choice(4 * i + j, 1) := choice(slice0cost_tag.first_group, 0,
          to_integer(slice1cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice1cost_column_0_choice(4 * i + j, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(4 * i
          + j) + slice1cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
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
      for j in 1 to 15 loop
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
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 0) + slice1cost_pixels_first_count(i, j, 2)
          + slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j, 5) +
          slice1cost_pixels_first_count(i, j, 6) + slice1cost_pixels_first_count(i, j, 4) +
          slice1cost_pixels_first_count(i, j, 7) + slice1cost_pixels_first_count(i, j, 1);
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 15 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    slice1cost_ready_words <= slice1cost_read_words;
    for i in 0 to 15 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 3 loop
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
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice1window_change_0_choice(4 * i + j) := choice(slice0window_change_tag.leaves_window,
          to_integer(slice1window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 15 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    slice1window_change_tag.first_cost <= slice0window_change_tag.first_cost;
    slice1window_change_tag.leaves_window <= slice0window_change_tag.leaves_window;
    slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
    slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    for i in 0 to 15 loop
      slice1window_sum_0_choice(i) := choice(slice1window_change_tag.first_cost, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag_valid then
      for i in 0 to 15 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 2048;
      end loop;
    end if;
    -- slice1winner1
    for i in 0 to 7 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    for i in 0 to 7 loop slice1winner1_best_first_0(i) <= slice1window_sum_0(2 * i); end loop;
    for i in 0 to 7 loop slice1winner1_best_last_0(i) <= slice1window_sum_0(2 * i + 1); end loop;
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 0 to 6 loop
      slice1winner1_best_below_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i), 0);
      slice1winner1_best_above_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 0, slice1window_sum_0(2 * i + 1));
      slice1winner1_best_cost_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), slice1window_sum_0(2 * i +
        3), slice1window_sum_0(2 * i + 2));
      slice1winner1_best_index_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice1winner1_best_below_0(7) <= choice(slice1winner1_best_cost_0_is_less(7), slice1window_sum_0(14), 0);
    slice1winner1_best_above_0(7) <= choice(slice1winner1_best_cost_0_is_less(7), 0, slice1window_sum_0(15));
    -- slice1winner2
    for i in 0 to 3 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_below_0_choice(0) := choice(slice1winner1_best_index_0(1) = 2, slice1winner1_best_last_0(0),
      slice1winner1_best_below_0(1));
    slice1winner2_best_below_0_choice(1) := choice(slice1winner1_best_index_0(3) = 6, slice1winner1_best_last_0(2),
      slice1winner1_best_below_0(3));
    slice1winner2_best_below_0_choice(2) := choice(is_set(slice1winner1_best_index_0(5), 3) and
      ((slice1winner1_best_index_0(5) mod 4) = 2), slice1winner1_best_last_0(4), slice1winner1_best_below_0(5));
    slice1winner2_best_below_0_choice(3) := choice(slice1winner1_best_index_0(7) = 14, slice1winner1_best_last_0(6),
      slice1winner1_best_below_0(7));
    slice1winner2_best_above_0_choice(0) := choice(slice1winner1_best_index_0_0, slice1winner1_best_first_0(1),
      slice1winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice1winner2_best_above_0_choice(i) := choice(other(i + 2), slice1winner1_best_first_0(2 * i + 1),
        slice1winner1_best_above_0(2 * i));
    end loop;
    slice1winner2_best_first_0(0) <= slice1winner1_best_first_0(0);
    slice1winner2_best_first_0(1) <= slice1winner1_best_first_0(2);
    slice1winner2_best_first_0(2) <= slice1winner1_best_first_0(4);
    slice1winner2_best_first_0(3) <= slice1winner1_best_first_0(6);
    slice1winner2_best_last_0(0) <= slice1winner1_best_last_0(1);
    slice1winner2_best_last_0(1) <= slice1winner1_best_last_0(3);
    slice1winner2_best_last_0(2) <= slice1winner1_best_last_0(5);
    slice1winner2_best_last_0(3) <= slice1winner1_best_last_0(7);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice1winner2_best_below_0(i) <= choice(slice1winner2_best_cost_0_is_less(i),
        slice1winner2_best_below_0_choice(i), slice1winner1_best_below_0(2 * i));
      slice1winner2_best_above_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_above_0(2 * i +
        1), slice1winner2_best_above_0_choice(i));
      slice1winner2_best_cost_0(i + 1) <= choice(slice1winner2_best_cost_0_is_less(i + 1), slice1winner1_best_cost_0(2
        * i + 3), slice1winner1_best_cost_0(2 * i + 2));
      slice1winner2_best_index_0(i + 1) <= choice(slice1winner2_best_cost_0_is_less(i + 1),
        slice1winner1_best_index_0(2 * i + 3), slice1winner1_best_index_0(2 * i + 2));
    end loop;
    slice1winner2_best_below_0(3) <= choice(slice1winner2_best_cost_0_is_less(3), slice1winner2_best_below_0_choice(3),
      slice1winner1_best_below_0(6));
    slice1winner2_best_above_0(3) <= choice(slice1winner2_best_cost_0_is_less(3), slice1winner1_best_above_0(7),
      slice1winner2_best_above_0_choice(3));
    -- slice1winner3
    slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
    slice1winner3_best_below_0_choice(0) := choice(slice1winner2_best_index_0(1) = 4, slice1winner2_best_last_0(0),
      slice1winner2_best_below_0(1));
    slice1winner3_best_below_0_choice(1) := choice(slice1winner2_best_index_0(3) = 12, slice1winner2_best_last_0(2),
      slice1winner2_best_below_0(3));
    slice1winner3_best_above_0_choice(0) := choice(slice1winner2_best_index_0(0) = 3, slice1winner2_best_first_0(1),
      slice1winner2_best_above_0(0));
    slice1winner3_best_above_0_choice(1) := choice(is_set(slice1winner2_best_index_0(2), 3) and
      ((slice1winner2_best_index_0(2) mod 4) = 3), slice1winner2_best_first_0(3), slice1winner2_best_above_0(2));
    slice1winner3_best_first_0(0) <= slice1winner2_best_first_0(0);
    slice1winner3_best_first_0(1) <= slice1winner2_best_first_0(2);
    slice1winner3_best_last_0(0) <= slice1winner2_best_last_0(1);
    slice1winner3_best_last_0(1) <= slice1winner2_best_last_0(3);
    for i in 0 to 1 loop
      slice1winner3_best_cost_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_cost_0(2 * i +
        1), slice1winner2_best_cost_0(2 * i));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_index_0(2 * i +
        1), slice1winner2_best_index_0(2 * i));
      slice1winner3_best_below_0(i) <= choice(slice1winner3_best_cost_0_is_less(i),
        slice1winner3_best_below_0_choice(i), slice1winner2_best_below_0(2 * i));
      slice1winner3_best_above_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_above_0(2 * i +
        1), slice1winner3_best_above_0_choice(i));
    end loop;
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_below_0_0_choice := choice(slice1winner3_best_index_0(1) = 8, slice1winner3_best_last_0(0),
      slice1winner3_best_below_0(1));
    slice1winner4_best_above_0_0_choice := choice(slice1winner3_best_index_0(0) = 7, slice1winner3_best_first_0(1),
      slice1winner3_best_above_0(0));
    slice1winner4_best_first_0_0 <= slice1winner3_best_first_0(0);
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
    slice1_best_cost_0_0_is_less := (slice1winner4_best_cost_0_0 - slice0_best_cost_0_0) < 0;
    slice1_best_below_0_0_choice := choice(slice1winner4_best_index_0_0 = 0, slice0_best_last_0_0,
      slice1winner4_best_below_0_0);
    slice1_best_above_0_0_choice := choice(slice0_best_index_0_0 = 15, slice1winner4_best_first_0_0,
      slice0_best_above_0_0);
    slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_cost_0_0, slice0_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_index_0_0 + 16,
      slice0_best_index_0_0);
    slice1_best_below_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1_best_below_0_0_choice, slice0_best_below_0_0);
    slice1_best_above_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_above_0_0,
      slice1_best_above_0_0_choice);
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      for i in 0 to 1 loop
        slice2shift_search(i, 0) <= slice1shift_search_out(i);
        for j in 1 to 15 loop slice2shift_search(i, j) <= slice2shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    -- slice2cost
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice2cost_column_0_choice(4 * i + j, 1) := choice(slice0window_entering_tag.first_group, 0,
          to_integer(slice2cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice2cost_column_0_choice(4 * i + j, 2) := choice(slice0window_entering_tag.border_column, 0,
          (slice2cost_change_0(4 * i + j) + slice2cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
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
      for j in 1 to 15 loop
        slice2cost_pixels_first_count(i, j, 0) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 0, 2,
          1);
        slice2cost_pixels_first_count(i, j, 1) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 3, 5,
          4);
        slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + differing(slice2shift_search(i, j),
          slice2shift_reference(i), 8) + differing(slice2shift_search(i, j), slice2shift_reference(i), 6);
        for k in 3 to 7 loop
          slice2cost_pixels_first_count(i, j, k) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 0) + slice2cost_pixels_first_count(i, j, 2)
          + slice2cost_pixels_first_count(i, j, 3) + slice2cost_pixels_first_count(i, j, 5) +
          slice2cost_pixels_first_count(i, j, 6) + slice2cost_pixels_first_count(i, j, 4) +
          slice2cost_pixels_first_count(i, j, 7) + slice2cost_pixels_first_count(i, j, 1);
      end loop;
    end loop;
    slice2cost_change_column <= slice2cost_read_column;
    for i in 0 to 15 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    slice2cost_ready_words <= slice2cost_read_words;
    slice2cost_ready_column <= slice2cost_change_column;
    for i in 0 to 15 loop slice2cost_column_0(i) <= slice2cost_column_0_choice(i, 2); end loop;
    if slice0cost_pixels_tag.valid then
      slice2cost_read_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice2cost_read_column + 1) mod 512);
    end if;
    if slice0window_entering_tag.valid then
      slice2cost_write_column <= slice2cost_ready_column;
      for i in 0 to 3 loop
        slice2cost_write_words(i) <= to_unsigned(slice2cost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(slice2cost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(slice2cost_column_0_choice(4 * i + 1,
          2), 8) & to_unsigned(slice2cost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- slice2window
    if slice0window_change_tag.valid then
      slice2window_ring_write_address <= slice2window_ring_read_address;
      slice2window_ring_read_address <= choice(slice2window_ring_read_address = 9, 0, (slice2window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice2window_change_0_choice(4 * i + j) := choice(slice1window_change_tag.leaves_window,
          to_integer(slice2window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice2window_entering_0 <= slice2cost_column_0;
    for i in 0 to 15 loop
      slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
    end loop;
    slice2window_change_tag_first_cost <= slice1window_change_tag.first_cost;
    for i in 0 to 15 loop
      slice2window_sum_0_choice(i) := choice(slice2window_change_tag_first_cost, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag.valid then
      for i in 0 to 15 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 2048;
      end loop;
      slice2window_centre_map_column(0) <= slice1window_centre_map_column_0;
      slice2window_centre_map_column(1 to 2) <= slice2window_centre_map_column(0 to 1);
      slice2window_centre_start_of_frame(0) <= slice1window_centre_start_of_frame_0;
      slice2window_centre_start_of_frame(1 to 2) <= slice2window_centre_start_of_frame(0 to 1);
      slice2window_centre_end_of_line(0) <= slice1window_centre_end_of_line_0;
      slice2window_centre_end_of_line(1 to 2) <= slice2window_centre_end_of_line(0 to 1);
    end if;
    -- slice2winner1
    for i in 0 to 7 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
    end loop;
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    for i in 0 to 7 loop slice2winner1_best_first_0(i) <= slice2window_sum_0(2 * i); end loop;
    for i in 0 to 6 loop slice2winner1_best_last_0(i) <= slice2window_sum_0(2 * i + 1); end loop;
    slice2winner1_best_cost_0(0) <= choice(slice2winner1_best_cost_0_is_less(0), slice2window_sum_0(1),
      slice2window_sum_0(0));
    for i in 0 to 6 loop
      slice2winner1_best_below_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), slice2window_sum_0(2 * i), 0);
      slice2winner1_best_above_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), 0, slice2window_sum_0(2 * i + 1));
      slice2winner1_best_cost_0(i + 1) <= choice(slice2winner1_best_cost_0_is_less(i + 1), slice2window_sum_0(2 * i +
        3), slice2window_sum_0(2 * i + 2));
      slice2winner1_best_index_0(i + 1) <= choice(slice2winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice2winner1_best_below_0(7) <= choice(slice2winner1_best_cost_0_is_less(7), slice2window_sum_0(14), 0);
    slice2winner1_best_above_0(7) <= choice(slice2winner1_best_cost_0_is_less(7), 0, slice2window_sum_0(15));
    -- slice2winner2
    for i in 0 to 3 loop
      slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner2_best_below_0_choice(0) := choice(slice2winner1_best_index_0(1) = 2, slice2winner1_best_last_0(0),
      slice2winner1_best_below_0(1));
    slice2winner2_best_below_0_choice(1) := choice(slice2winner1_best_index_0(3) = 6, slice2winner1_best_last_0(2),
      slice2winner1_best_below_0(3));
    slice2winner2_best_below_0_choice(2) := choice(is_set(slice2winner1_best_index_0(5), 3) and
      ((slice2winner1_best_index_0(5) mod 4) = 2), slice2winner1_best_last_0(4), slice2winner1_best_below_0(5));
    slice2winner2_best_below_0_choice(3) := choice(slice2winner1_best_index_0(7) = 14, slice2winner1_best_last_0(6),
      slice2winner1_best_below_0(7));
    slice2winner2_best_above_0_choice(0) := choice(slice2winner1_best_index_0_0, slice2winner1_best_first_0(1),
      slice2winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice2winner2_best_above_0_choice(i) := choice(other(i - 1), slice2winner1_best_first_0(2 * i + 1),
        slice2winner1_best_above_0(2 * i));
    end loop;
    slice2winner2_best_first_0(0) <= slice2winner1_best_first_0(0);
    slice2winner2_best_first_0(1) <= slice2winner1_best_first_0(2);
    slice2winner2_best_first_0(2) <= slice2winner1_best_first_0(4);
    slice2winner2_best_first_0(3) <= slice2winner1_best_first_0(6);
    slice2winner2_best_last_0(0) <= slice2winner1_best_last_0(1);
    slice2winner2_best_last_0(1) <= slice2winner1_best_last_0(3);
    slice2winner2_best_last_0(2) <= slice2winner1_best_last_0(5);
    slice2winner2_best_cost_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_cost_0(1),
      slice2winner1_best_cost_0(0));
    slice2winner2_best_index_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_index_0(1),
      as_number(slice2winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice2winner2_best_below_0(i) <= choice(slice2winner2_best_cost_0_is_less(i),
        slice2winner2_best_below_0_choice(i), slice2winner1_best_below_0(2 * i));
      slice2winner2_best_above_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_above_0(2 * i +
        1), slice2winner2_best_above_0_choice(i));
      slice2winner2_best_cost_0(i + 1) <= choice(slice2winner2_best_cost_0_is_less(i + 1), slice2winner1_best_cost_0(2
        * i + 3), slice2winner1_best_cost_0(2 * i + 2));
      slice2winner2_best_index_0(i + 1) <= choice(slice2winner2_best_cost_0_is_less(i + 1),
        slice2winner1_best_index_0(2 * i + 3), slice2winner1_best_index_0(2 * i + 2));
    end loop;
    slice2winner2_best_below_0(3) <= choice(slice2winner2_best_cost_0_is_less(3), slice2winner2_best_below_0_choice(3),
      slice2winner1_best_below_0(6));
    slice2winner2_best_above_0(3) <= choice(slice2winner2_best_cost_0_is_less(3), slice2winner1_best_above_0(7),
      slice2winner2_best_above_0_choice(3));
    -- slice2winner3
    slice2winner3_best_cost_0_is_less(0) := (slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) < 0;
    slice2winner3_best_cost_0_is_less(1) := (slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) < 0;
    slice2winner3_best_below_0_choice(0) := choice(slice2winner2_best_index_0(1) = 4, slice2winner2_best_last_0(0),
      slice2winner2_best_below_0(1));
    slice2winner3_best_below_0_choice(1) := choice(slice2winner2_best_index_0(3) = 12, slice2winner2_best_last_0(2),
      slice2winner2_best_below_0(3));
    slice2winner3_best_above_0_choice(0) := choice(slice2winner2_best_index_0(0) = 3, slice2winner2_best_first_0(1),
      slice2winner2_best_above_0(0));
    slice2winner3_best_above_0_choice(1) := choice(is_set(slice2winner2_best_index_0(2), 3) and
      ((slice2winner2_best_index_0(2) mod 4) = 3), slice2winner2_best_first_0(3), slice2winner2_best_above_0(2));
    slice2winner3_best_first_0(0) <= slice2winner2_best_first_0(0);
    slice2winner3_best_first_0(1) <= slice2winner2_best_first_0(2);
    slice2winner3_best_last_0_0 <= slice2winner2_best_last_0(1);
    for i in 0 to 1 loop
      slice2winner3_best_cost_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_cost_0(2 * i +
        1), slice2winner2_best_cost_0(2 * i));
      slice2winner3_best_index_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_index_0(2 * i +
        1), slice2winner2_best_index_0(2 * i));
      slice2winner3_best_below_0(i) <= choice(slice2winner3_best_cost_0_is_less(i),
        slice2winner3_best_below_0_choice(i), slice2winner2_best_below_0(2 * i));
      slice2winner3_best_above_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_above_0(2 * i +
        1), slice2winner3_best_above_0_choice(i));
    end loop;
    -- slice2winner4
    slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_below_0_0_choice := choice(slice2winner3_best_index_0(1) = 8, slice2winner3_best_last_0_0,
      slice2winner3_best_below_0(1));
    slice2winner4_best_above_0_0_choice := choice(slice2winner3_best_index_0(0) = 7, slice2winner3_best_first_0(1),
      slice2winner3_best_above_0(0));
    slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
    slice2winner4_best_cost_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_cost_0(1),
      slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_index_0(1),
      slice2winner3_best_index_0(0));
    slice2winner4_best_below_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner4_best_below_0_0_choice,
      slice2winner3_best_below_0(0));
    slice2winner4_best_above_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_above_0(1),
      slice2winner4_best_above_0_0_choice);
    -- slice2
    slice2_best_cost_0_0_is_less := (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0;
    slice2_best_below_0_0_choice := choice(slice2winner4_best_index_0_0 = 0, slice1_best_last_0_0,
      slice2winner4_best_below_0_0);
    slice2_best_above_0_0_choice := choice(slice1_best_index_0_0 = 31, slice2winner4_best_first_0_0,
      slice1_best_above_0_0);
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_cost_0_0, slice1_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_index_0_0 + 32,
      slice1_best_index_0_0);
    slice2_best_below_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2_best_below_0_0_choice, slice1_best_below_0_0);
    slice2_best_above_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_above_0_0,
      slice2_best_above_0_0_choice);
    -- refinement
    refinement_tag_11_row_start_differs := map_counter_group /= 376;
    refinement_tag_11_row_start_is_equals(1) := map_counter_column = 401;
    refinement_tag_11_row_start_choices(1) := choice(refinement_tag_11_row_start_is_equals(1),
      refinement_tag_11_row_start and (map_counter_group /= 375), refinement_tag_11_row_start);
    refinement_tag_11_row_start_choices(2) := choice(refinement_tag_11_row_start_differs,
      refinement_tag_11_row_start_choices(1), refinement_tag_11_row_start);
    refinement_tag_11_row_start_is_equals(2) := map_counter_group = 374;
    refinement_tag_11_row_start_alls(1) := refinement_tag_11_row_start_is_equals(2) and
      refinement_tag_11_row_start_is_equals(1);
    refinement_tag_11_row_start_choices(3) := choice(refinement_tag_11_row_start_choices(2), (not
      refinement_tag_start_of_frame(11)) or refinement_tag_11_row_start_alls(1), refinement_tag_start_of_frame(11) and
      refinement_tag_11_row_start_is_equals(2) and refinement_tag_11_row_start_is_equals(1));
    refinement_tag_11_row_start_alls(2) := refinement_tag_valid(11) and refinement_tag_map_column(11);
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
    refinement_disparity_0(0) <= slice2_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= true;
    refinement_passed_0(1 to 3) <= refinement_passed_0(0 to 2);
    refinement_passed_0s(5) <= transform_filtering_1_column_inside_4;
    refinement_passed_0s(6 to 8) <= refinement_passed_0s(5 to 7);
    refinement_passed_11_0 <= transform_filtering_row_inside_4(1);
    refinement_tag_valid(0) <= slice2_best_tag.valid;
    refinement_tag_map_column(0) <= slice2_best_tag.map_column;
    refinement_tag_start_of_frame(0) <= slice2_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= slice2_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_cost_0 <= slice2_best_cost_0_0;
    refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
    refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
      ((other_12 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_tag_11_row_start <= choice(refinement_tag_11_row_start_choices(3), refinement_tag_11_row_start or
      refinement_tag_11_row_start_alls(2), refinement_tag_11_row_start and ((not refinement_tag_valid(11)) or (not
      refinement_tag_map_column(11))));
    refinement_below_0 <= choice(slice2_best_index_0_0 = 0, slice2_best_above_0_0, slice2_best_below_0_0);
    refinement_above_0 <= choice(slice2_best_index_0_0 = 47, slice2_best_below_0_0, slice2_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 12),
      refinement_remainder_1_0_difference mod 2048, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 12),
        refinement_remainder_0_difference(i) mod 2048, (refinement_remainder_0(i - 1) mod 1024) * 2);
    end loop;
    -- map
    if refinement_tag_11_row_start_alls(2) then
      map_counter_column <= choice(refinement_tag_start_of_frame(11) or refinement_tag_11_row_start_is_equals(1), 0,
        (map_counter_column + 1) mod 512);
    end if;
    map_counter_group_choice := choice(refinement_tag_11_row_start_alls(1), 375, 0);
    map_counter_group_is_equal := map_counter_group = 375;
    map_counter_group_choices(2) := choice(refinement_tag_11_row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(refinement_tag_11_row_start_differs and
      refinement_tag_11_row_start_is_equals(1) and refinement_tag_valid(11) and refinement_tag_map_column(11),
      map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(refinement_tag_valid(11), refinement_tag_map_column(11), map_line_ended);
    map_at_arrives_value := other_9(16) = '1';
    map_of_column_0_a_choice := choice(map_at_top, map_column_1 / 2, other_10 / 2);
    map_of_column_0_c_choice := choice(map_counter_next_frame, map_column_1 / 2, map_column_2 / 2);
    map_sorted_low_0_choices(1) := choice(map_of_column_0_c_below_b, map_of_column_0_c, map_of_column_0_b);
    map_sorted_low_0_choices(2) := choice(map_of_column_0_c_below_a, map_of_column_0_c, map_of_column_0_a);
    map_sorted_middle_0_choices(1) := choice(map_of_column_0_c_below_b, map_of_column_0_b, map_sorted_low_0_choices(2));
    map_sorted_middle_0_choices(2) := choice(map_of_column_0_c_below_a, map_of_column_0_a, map_sorted_low_0_choices(1));
    map_sorted_high_0_choices(1) := choice(map_of_column_0_c_below_a, map_of_column_0_a, map_of_column_0_c);
    map_sorted_high_0_choices(2) := choice(map_of_column_0_c_below_b, map_of_column_0_b, map_of_column_0_c);
    map_window_complete_is_equal := map_sorted_column = 0;
    map_window_complete_choice := choice(map_window_complete_is_equal, map_sorted_behind, map_sorted_arrives or
      map_sorted_behind);
    map_largest_low_0_choices(1) := choice(map_of_low_0_c_below_a, map_of_low_0_a, map_of_low_0_c);
    map_largest_low_0_choices(2) := choice(map_of_low_0_c_below_b, map_of_low_0_b, map_of_low_0_c);
    map_median_middle_0_choices(1) := choice(map_of_middle_0_c_below_a, map_of_middle_0_c, map_of_middle_0_a);
    map_median_middle_0_choices(2) := choice(map_of_middle_0_c_below_b, map_of_middle_0_b,
      map_median_middle_0_choices(1));
    map_median_middle_0_choices(3) := choice(map_of_middle_0_c_below_b, map_of_middle_0_c, map_of_middle_0_b);
    map_median_middle_0_choices(4) := choice(map_of_middle_0_c_below_a, map_of_middle_0_a,
      map_median_middle_0_choices(3));
    map_smallest_high_0_choices(1) := choice(map_of_high_0_c_below_b, map_of_high_0_c, map_of_high_0_b);
    map_smallest_high_0_choices(2) := choice(map_of_high_0_c_below_a, map_of_high_0_c, map_of_high_0_a);
    map_out_disparity_0_choices(1) := choice(map_of_all_0_c_below_a, map_of_all_0_c, map_of_all_0_a);
    map_out_disparity_0_choices(2) := choice(map_of_all_0_c_below_b, map_of_all_0_b, map_out_disparity_0_choices(1));
    map_out_disparity_0_choices(3) := choice(map_of_all_0_c_below_b, map_of_all_0_c, map_of_all_0_b);
    map_out_disparity_0_choices(4) := choice(map_of_all_0_c_below_a, map_of_all_0_a, map_out_disparity_0_choices(3));
    map_counter_next_frame <= other_9(40) = '1';
    map_newest_0 <= (((((((refinement_disparity_0(11) + (refinement_fraction_0 / 16)) * 2) + ((refinement_fraction_0
      mod 16) / 8) + 8191) mod 4096) * 8) + (refinement_fraction_0 mod 8)) * 2) + as_number(refinement_passed_11_0);
    map_arrives <= refinement_tag_11_row_start_alls(2);
    map_behind <= map_line_ended and refinement_tag_valid(11);
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_write_column <= to_integer(other_9(8 downto 0));
    map_column_1 <= map_rows_ready_words_0 / 8192;
    map_column_2 <= map_rows_ready_newest_0;
    map_at_arrives <= map_at_arrives_value;
    map_at_behind <= other_9(24) = '1';
    map_at_top <= other_9(32) = '1';
    map_at_output <= other_9(48) = '1';
    map_of_column_0_a <= map_of_column_0_a_choice;
    map_of_column_0_b <= map_column_1 / 2;
    map_of_column_0_c <= map_of_column_0_c_choice;
    map_of_column_0_b_below_a <= ((map_column_1 / 2) - map_of_column_0_a_choice) < 0;
    map_of_column_0_c_below_a <= (map_of_column_0_c_choice - map_of_column_0_a_choice) < 0;
    map_of_column_0_c_below_b <= (map_of_column_0_c_choice - (map_column_1 / 2)) < 0;
    map_column_passed_0(0) <= is_set(map_column_1, 0);
    map_column_passed_0(1) <= map_column_passed_0(0);
    map_comparing_column <= map_write_column;
    map_comparing_arrives <= map_at_arrives;
    map_comparing_behind <= map_at_behind;
    map_comparing_top <= map_at_top;
    map_comparing_output <= map_at_output;
    map_sorted_column <= map_comparing_column;
    map_sorted_arrives <= map_comparing_arrives;
    map_sorted_behind <= map_comparing_behind;
    map_sorted_top <= map_comparing_top;
    map_sorted_output <= map_comparing_output;
    map_window_complete <= map_sorted_output and map_window_complete_choice;
    map_window_first <= map_sorted_top and (map_sorted_column = 1) and map_sorted_arrives;
    map_window_last <= map_sorted_behind;
    map_of_low_0_a <= map_low_0(0);
    map_of_low_0_b <= map_low_0(1);
    map_of_low_0_c <= map_low_0(2);
    map_of_low_0_b_below_a <= (map_low_0(1) - map_low_0(0)) < 0;
    map_of_low_0_c_below_a <= (map_low_0(2) - map_low_0(0)) < 0;
    map_of_low_0_c_below_b <= (map_low_0(2) - map_low_0(1)) < 0;
    map_of_middle_0_a <= map_middle_0(0);
    map_of_middle_0_b <= map_middle_0(1);
    map_of_middle_0_c <= map_middle_0(2);
    map_of_middle_0_b_below_a <= (map_middle_0(1) - map_middle_0(0)) < 0;
    map_of_middle_0_c_below_a <= (map_middle_0(2) - map_middle_0(0)) < 0;
    map_of_middle_0_c_below_b <= (map_middle_0(2) - map_middle_0(1)) < 0;
    map_of_high_0_a <= map_high_0(0);
    map_of_high_0_b <= map_high_0(1);
    map_of_high_0_c <= map_high_0(2);
    map_of_high_0_b_below_a <= (map_high_0(1) - map_high_0(0)) < 0;
    map_of_high_0_c_below_a <= (map_high_0(2) - map_high_0(0)) < 0;
    map_of_high_0_c_below_b <= (map_high_0(2) - map_high_0(1)) < 0;
    map_of_all_0_a <= map_largest_low_0;
    map_of_all_0_b <= map_median_middle_0;
    map_of_all_0_c <= map_smallest_high_0;
    map_of_all_0_b_below_a <= (map_median_middle_0 - map_largest_low_0) < 0;
    map_of_all_0_c_below_a <= (map_smallest_high_0 - map_largest_low_0) < 0;
    map_of_all_0_c_below_b <= (map_smallest_high_0 - map_median_middle_0) < 0;
    map_waiting_complete(0) <= map_window_complete;
    map_waiting_first(0) <= map_window_first;
    map_waiting_last(0) <= map_window_last;
    map_waiting_complete(1) <= map_waiting_complete(0);
    map_waiting_first(1) <= map_waiting_first(0);
    map_waiting_last(1) <= map_waiting_last(0);
    map_waiting_complete(2) <= map_waiting_complete(1);
    map_waiting_first(2) <= map_waiting_first(1);
    map_waiting_last(2) <= map_waiting_last(1);
    map_waiting_passed_0(0) <= map_passed_0(1);
    map_waiting_passed_0(1 to 2) <= map_waiting_passed_0(0 to 1);
    map_out_passed_0 <= map_waiting_passed_0(2);
    map_out_valid <= map_waiting_complete(2);
    map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
    map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
    map_counter_group <= choice(refinement_tag_start_of_frame(11) and refinement_tag_valid(11) and
      refinement_tag_map_column(11), map_counter_group_choice, map_counter_group_choices(3));
    map_line_ended <= choice(refinement_tag_end_of_line(11), map_line_ended_choice, map_line_ended and (not
      refinement_tag_valid(11)));
    map_sorted_low_0 <= choice(map_of_column_0_b_below_a, map_sorted_low_0_choices(1), map_sorted_low_0_choices(2));
    map_sorted_middle_0 <= choice(map_of_column_0_b_below_a, map_sorted_middle_0_choices(1),
      map_sorted_middle_0_choices(2));
    map_sorted_high_0 <= choice(map_of_column_0_b_below_a, map_sorted_high_0_choices(1), map_sorted_high_0_choices(2));
    map_passed_0(1) <= choice(map_passed_0(0), map_passed_0(1) or map_sorted_arrives or map_sorted_behind,
      map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind));
    map_largest_low_0 <= choice(map_of_low_0_b_below_a, map_largest_low_0_choices(1), map_largest_low_0_choices(2));
    map_median_middle_0 <= choice(map_of_middle_0_b_below_a, map_median_middle_0_choices(2),
      map_median_middle_0_choices(4));
    map_smallest_high_0 <= choice(map_of_high_0_b_below_a, map_smallest_high_0_choices(1),
      map_smallest_high_0_choices(2));
    map_out_disparity_0 <= choice(map_of_all_0_b_below_a, map_out_disparity_0_choices(2),
      map_out_disparity_0_choices(4));
    if map_at_arrives_value then
      map_rows_write_words_0 <= (map_rows_ready_words_0 / 8192) + (map_rows_ready_newest_0 * 8192);
      map_at_column <= to_integer(other_9(8 downto 0));
    end if;
    map_low_0_0_choice := choice(map_sorted_behind, map_low_0(0), map_sorted_low_0);
    map_low_0_all(1) := map_window_complete_is_equal and map_sorted_arrives;
    map_middle_0_0_choice := choice(map_sorted_behind, map_middle_0(0), map_sorted_middle_0);
    map_high_0_0_choice := choice(map_sorted_behind, map_high_0(0), map_sorted_high_0);
    map_low_0_all(0) := (not map_sorted_arrives) and (not map_sorted_behind);
    if not map_low_0_all(0) then
      map_low_0(0) <= map_low_0_0_choice;
      map_low_0(2) <= map_low_0(1);
      map_middle_0(0) <= map_middle_0_0_choice;
      map_middle_0(2) <= map_middle_0(1);
      map_high_0(0) <= map_high_0_0_choice;
      map_high_0(2) <= map_high_0(1);
      map_low_0(1) <= choice(map_low_0_all(1), map_low_0_0_choice, map_low_0(0));
      map_middle_0(1) <= choice(map_low_0_all(1), map_middle_0_0_choice, map_middle_0(0));
      map_high_0(1) <= choice(map_low_0_all(1), map_high_0_0_choice, map_high_0(0));
    end if;
    if map_sorted_arrives then map_passed_0(0) <= map_column_passed_0(1); end if;
    -- other
    other(0) <= slice2winner1_best_cost_0_is_less(2);
    other(1) <= slice2winner1_best_cost_0_is_less(4);
    other(2) <= slice2winner1_best_cost_0_is_less(6);
    other(3) <= slice1winner1_best_cost_0_is_less(2);
    other(4) <= slice1winner1_best_cost_0_is_less(4);
    other(5) <= slice1winner1_best_cost_0_is_less(6);
    other(6) <= slice0winner1_best_cost_0_is_less(2);
    other(7) <= slice0winner1_best_cost_0_is_less(4);
    other(8) <= slice0winner1_best_cost_0_is_less(6);
    other_9 <= other_11;
    other_10 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
    other_11 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 376))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    other_12 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_13 / 4) * 4);
    other_13 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_14 / 8) * 8);
    other_14 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_15 / 16) * 16);
    other_15 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_16 / 32) * 32);
    other_16 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_17 / 64) * 64);
    other_17 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_18 / 128) * 128);
    other_18 <= (refinement_remainder_1_0_difference / 4096) * 128;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 377;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 379; delay_column <= 0; delay_tag.valid <= false; delay_tag.row_start <= false;
      delay_tag.map_column <= false; delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false;
      rows_read_column <= 0; rows_read_tag.valid <= false; rows_read_tag.row_start <= false;
      rows_read_tag.map_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false;
      rows_ready_tag.map_column <= false; rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false;
      rows_write_column <= 0; rows_tag.valid <= false; rows_tag.row_start <= false; rows_tag.map_column <= false;
      rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.row_start <= false; slice0shift_tag.map_column <= false; slice0shift_tag.start_of_frame <= false;
      slice0shift_tag.end_of_line <= false; slice0cost_pixels_first_tag.valid <= false;
      slice0cost_pixels_first_tag.row_start <= false; slice0cost_pixels_first_tag.map_column <= false;
      slice0cost_pixels_first_tag.start_of_frame <= false; slice0cost_pixels_first_tag.end_of_line <= false;
      slice0cost_pixels_tag.valid <= false; slice0cost_pixels_tag.row_start <= false;
      slice0cost_pixels_tag.map_column <= false; slice0cost_pixels_tag.start_of_frame <= false;
      slice0cost_pixels_tag.end_of_line <= false; slice0cost_read_column <= 0; slice0cost_change_column <= 0;
      slice0cost_ready_column <= 0; slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.map_column <= false;
      slice0cost_ready_tag.start_of_frame <= false; slice0cost_ready_tag.end_of_line <= false;
      slice0cost_write_column <= 0; slice0cost_tag.valid <= false; slice0cost_tag.map_column <= false;
      slice0cost_tag.start_of_frame <= false; slice0cost_tag.end_of_line <= false; slice0window_ring_read_address <= 1;
      slice0window_ring_write_address <= 0; slice0window_entering_tag.valid <= false;
      slice0window_entering_tag.map_column <= false; slice0window_entering_tag.start_of_frame <= false;
      slice0window_entering_tag.end_of_line <= false; slice0window_change_tag.valid <= false;
      slice0window_change_tag.map_column <= false; slice0window_change_tag.start_of_frame <= false;
      slice0window_change_tag.end_of_line <= false; slice0window_centre_map_column_0 <= false;
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_end_of_line_0 <= false;
      slice0window_tag_valid <= false; slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0winner4_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_ready_column <= 0; slice1cost_write_column <= 0; slice1window_ring_read_address <= 1;
      slice1window_ring_write_address <= 0; slice1window_centre_map_column_0 <= false;
      slice1window_centre_start_of_frame_0 <= false; slice1window_centre_end_of_line_0 <= false;
      slice1_best_tag <= (others => false); slice2cost_read_column <= 0; slice2cost_change_column <= 0;
      slice2cost_ready_column <= 0; slice2cost_write_column <= 0; slice2window_ring_read_address <= 1;
      slice2window_ring_write_address <= 0; slice2window_centre_map_column <= (others => false);
      slice2window_centre_start_of_frame <= (others => false); slice2window_centre_end_of_line <= (others => false);
      slice2_best_tag <= (others => false);
      for i in 0 to 10 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      refinement_tag_valid(11) <= false; refinement_tag_11_row_start <= false; refinement_tag_map_column(11) <= false;
      refinement_tag_start_of_frame(11) <= false; refinement_tag_end_of_line(11) <= false; map_counter_column <= 0;
      map_counter_group <= 376; map_arrives <= false; map_behind <= false; map_line_ended <= false;
      map_write_column <= 0; map_at_column <= 0; map_at_arrives <= false; map_at_behind <= false; map_at_top <= false;
      map_at_output <= false; map_comparing_column <= 0; map_comparing_arrives <= false; map_comparing_behind <= false;
      map_comparing_top <= false; map_comparing_output <= false; map_sorted_column <= 0; map_sorted_arrives <= false;
      map_sorted_behind <= false; map_sorted_top <= false; map_sorted_output <= false; map_window_complete <= false;
      map_window_first <= false; map_window_last <= false;
      for i in 0 to 2 loop
        map_waiting_complete(i) <= false; map_waiting_first(i) <= false; map_waiting_last(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false;
      other_9 <= to_unsigned(0, 49); other_11 <= to_unsigned(0, 49);
    end if;
  end process;
end architecture;
