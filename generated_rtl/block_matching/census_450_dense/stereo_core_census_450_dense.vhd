-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_450_dense: 450x375, 48 disparities, window 9x9, 1 pixel pair a clock.
-- Options: disparities 48, window_px 9, reference left, cost census, census_width_px 9, census_pattern
--   even_columns, left_right_threshold 1, subpixel true, median true, full_width true, support_threshold 10,
--   confidence true, margin_shift 3, margin_weight 1, support_weight 6, fill_holes true, aggregation
--   recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_450_dense
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_450_dense is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 48;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 24;
    output_width_px : positive := 442;
    latency_clocks : positive := 73;
    flush_groups : positive := 4558;
    gap_groups : positive := 1800
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(23 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 450 report "stereo_core_census_450_dense: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_census_450_dense: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 48 report "stereo_core_census_450_dense: disparities is " & integer'image(disparities) & " but this core has 48" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_450_dense: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 24 report "stereo_core_census_450_dense: disparity_bits is " & integer'image(disparity_bits) & " but this core has 24" severity failure;
  assert output_width_px = 442 report "stereo_core_census_450_dense: output_width_px is " & integer'image(output_width_px) & " but this core has 442" severity failure;
  assert latency_clocks = 73 report "stereo_core_census_450_dense: latency_clocks is " & integer'image(latency_clocks) & " but this core has 73" severity failure;
  assert flush_groups = 4558 report "stereo_core_census_450_dense: flush_groups is " & integer'image(flush_groups) & " but this core has 4558" severity failure;
  assert gap_groups = 1800 report "stereo_core_census_450_dense: gap_groups is " & integer'image(gap_groups) & " but this core has 1800" severity failure;
end entity;

architecture rtl of stereo_core_census_450_dense is
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

  function smaller(a : integer; b : integer) return integer is
  begin
    if (a - b) < 0 then
      return a;
    end if;
    return b;
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
  type integer_minus_24_to_24_1d is array (natural range <>) of integer range -24 to 24;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_16777215_2d is array (natural range <>, natural range <>) of natural range 0 to 16777215;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2047_2d is array (natural range <>, natural range <>) of natural range 0 to 2047;
  type natural_2049_to_8190_1d is array (natural range <>) of natural range 2049 to 8190;
  type natural_24_2d is array (natural range <>, natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4096_1d is array (natural range <>) of natural range 0 to 4096;
  type natural_47_1d is array (natural range <>) of natural range 0 to 47;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_to_127_1d is array (natural range <>) of natural range 63 to 127;
  type unsigned_24_1d is array (natural range <>) of unsigned(23 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_9 is record
    valid, row_start, first_group, leaves_window, map_column, output_column, first_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8 is record
    valid, row_start, leaves_window, map_column, output_column, first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, first_column, start_of_frame : boolean;
  end record;
  type tag_6 is record
    valid, map_column, output_column, first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5 is record
    valid, map_column, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4_b is record
    row_start, leaves_window, output_column, first_column : boolean;
  end record;
  type tag_2 is record
    output_column, first_column : boolean;
  end record;
  type tag_3 is record
    row_start, output_column, first_column : boolean;
  end record;
  type tag_4_c is record
    valid, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5_b is record
    valid, row_start, map_column, start_of_frame, end_of_line : boolean;
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
  signal transform_filtering_0_column_inside : boolean_1d(0 to 4);  -- _2#
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
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag, slice0cost_tag : tag_9;
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
  signal slice0window_entering_tag : tag_9;
  signal slice0window_change_tag : tag_8;
  signal slice0window_centre_map_column_0 : boolean;
  signal slice0window_centre_output_column, slice0window_centre_first_column : boolean_1d(0 to 3);
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_3,
    slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice0window_sum_0 : natural_2047_1d(0 to 15);
  -- slice0mask
  signal slice0mask_inside : boolean_1d(0 to 15);
  signal slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 511;
  -- slice0other
  signal slice0other_cost_0 : natural_2047_1d(0 to 15);
  signal slice0other_cost_out_0 : natural range 0 to 2047;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0 : natural_15_1d(2 to 15);  -- _# up to 2, 3 .. 15
  signal slice0other_winner_out_0 : natural range 0 to 15;
  -- slice0winner1
  signal slice0winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_late_cost_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_but_first_0 : natural_2047_1d(1 to 7);
  signal slice0winner1_best_but_last_0 : natural_2047_1d(0 to 7);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice0winner1_tag : tag_6;
  signal slice0winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_2047_1d(1 to 3);
  signal slice0winner2_best_last_0, slice0winner2_best_late_cost_0,
    slice0winner2_best_second_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_but_first_0 : natural_2047_1d(1 to 3);
  signal slice0winner2_best_but_last_0 : natural_2047_1d(0 to 3);
  signal slice0winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice0winner2_best_place_0, slice0winner2_best_at_start_0, slice0winner2_best_at_end_0 : boolean_1d(0 to 3);
  signal slice0winner2_tag : tag_6;
  -- slice0winner3
  signal slice0winner3_best_cost_0, slice0winner3_best_below_0, slice0winner3_best_above_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_last_0, slice0winner3_best_late_cost_0,
    slice0winner3_best_second_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_but_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_but_last_0 : natural_2047_1d(0 to 1);
  signal slice0winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice0winner3_best_place_0, slice0winner3_best_at_start_0, slice0winner3_best_at_end_0 : boolean_1d(0 to 1);
  signal slice0winner3_tag : tag_5;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0, slice0winner4_best_above_0_0,
    slice0winner4_best_last_0_0, slice0winner4_best_late_cost_0_0, slice0winner4_best_second_0_0,
    slice0winner4_best_but_last_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_place_0_0, slice0winner4_best_at_start_0_0, slice0winner4_best_at_end_0_0 : boolean;
  signal slice0winner4_tag : tag_5;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0, slice0_best_late_cost_0_0,
    slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 2047;
  signal slice0_best_place_0 : boolean;
  signal slice0_best_tag : tag_5;
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
  signal slice1window_change_tag : tag_4_b;
  signal slice1window_centre_map_column_0 : boolean;
  signal slice1window_centre_output_column, slice1window_centre_first_column : boolean_1d(0 to 3);
  signal slice1window_centre_start_of_frame_0, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_tag : tag_2;
  signal slice1window_sum_0 : natural_2047_1d(0 to 15);
  -- slice1mask
  signal slice1mask_inside : boolean_1d(0 to 15);
  signal slice1mask_left_out : boolean;
  -- slice1other
  signal slice1other_cost_0 : natural_2047_1d(0 to 15);
  signal slice1other_cost_out_0 : natural range 0 to 2047;
  signal slice1other_winner_0 : natural_31_1d(0 to 15);  -- _# up to 16, 17 .. 31
  signal slice1other_winner_out_0 : natural range 0 to 31;
  -- slice1winner1
  signal slice1winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0,
    slice1winner1_best_late_cost_0, slice1winner1_best_but_first_0,
    slice1winner1_best_but_last_0 : natural_2047_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice1winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0, slice1winner2_best_first_0,
    slice1winner2_best_last_0, slice1winner2_best_late_cost_0, slice1winner2_best_second_0,
    slice1winner2_best_but_first_0, slice1winner2_best_but_last_0 : natural_2047_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice1winner2_best_place_0, slice1winner2_best_at_start_0, slice1winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice1winner3
  signal slice1winner3_best_cost_0, slice1winner3_best_below_0, slice1winner3_best_above_0, slice1winner3_best_first_0,
    slice1winner3_best_last_0, slice1winner3_best_late_cost_0, slice1winner3_best_second_0,
    slice1winner3_best_but_first_0, slice1winner3_best_but_last_0 : natural_2047_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice1winner3_best_place_0, slice1winner3_best_at_start_0, slice1winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0, slice1winner4_best_above_0_0,
    slice1winner4_best_first_0_0, slice1winner4_best_last_0_0, slice1winner4_best_late_cost_0_0,
    slice1winner4_best_second_0_0, slice1winner4_best_but_first_0_0,
    slice1winner4_best_but_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_place_0_0, slice1winner4_best_at_start_0_0, slice1winner4_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0, slice1_best_last_0_0,
    slice1_best_late_cost_0_0, slice1_best_second_0_0, slice1_best_but_last_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0 : boolean;
  signal slice1_best_tag : tag_5;
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
  signal slice2window_change_tag : tag_3;
  signal slice2window_centre_map_column, slice2window_centre_output_column,
    slice2window_centre_first_column : boolean_1d(0 to 2);
  signal slice2window_centre_start_of_frame_0 : boolean;
  signal slice2window_centre_end_of_line : boolean_1d(0 to 2);
  signal slice2window_sum_0 : natural_2047_1d(0 to 15);
  -- slice2mask
  signal slice2mask_inside : boolean_1d(0 to 15);
  -- slice2other
  signal slice2other_cost_0 : natural_2047_1d(0 to 14);
  signal slice2other_winner_0 : natural_47_1d(0 to 15);  -- _# up to 32, 33 .. 47
  signal slice2other_winner_out_0 : natural range 0 to 47;
  -- slice2winner1
  signal slice2winner1_held_0 : natural_2047_1d(0 to 15);
  signal slice2winner1_best_cost_0, slice2winner1_best_below_0, slice2winner1_best_above_0,
    slice2winner1_best_late_cost_0, slice2winner1_best_but_first_0 : natural_2047_1d(0 to 7);
  signal slice2winner1_best_but_last_0 : natural_2047_1d(0 to 6);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice2winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice2winner2
  signal slice2winner2_best_cost_0, slice2winner2_best_below_0, slice2winner2_best_above_0,
    slice2winner2_best_first_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_last_0 : natural_2047_1d(0 to 2);
  signal slice2winner2_best_late_cost_0, slice2winner2_best_second_0,
    slice2winner2_best_but_first_0 : natural_2047_1d(0 to 3);
  signal slice2winner2_best_but_last_0 : natural_2047_1d(0 to 2);
  signal slice2winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice2winner2_best_place_0, slice2winner2_best_at_start_0, slice2winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice2winner3
  signal slice2winner3_best_cost_0, slice2winner3_best_below_0, slice2winner3_best_above_0,
    slice2winner3_best_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_late_cost_0, slice2winner3_best_second_0,
    slice2winner3_best_but_first_0 : natural_2047_1d(0 to 1);
  signal slice2winner3_best_but_last_0_0 : natural range 0 to 2047;
  signal slice2winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice2winner3_best_place_0, slice2winner3_best_at_start_0, slice2winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0, slice2winner4_best_above_0_0,
    slice2winner4_best_first_0_0, slice2winner4_best_late_cost_0_0, slice2winner4_best_second_0_0,
    slice2winner4_best_but_first_0_0 : natural range 0 to 2047;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_place_0_0, slice2winner4_best_at_start_0_0, slice2winner4_best_at_end_0_0 : boolean;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0, slice2_best_late_cost_0_0,
    slice2_best_second_0_0 : natural range 0 to 2047;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0 : boolean;
  signal slice2_best_tag : tag_5;
  -- refinement
  signal refinement_disparity_0 : natural_47_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_alone_0_0 : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_gap_0, refinement_below_0, refinement_above_0, refinement_u_0,
    refinement_v_0 : natural range 0 to 2047;
  signal refinement_remainder_0, refinement_divisor_0 : natural_2047_1d(0 to 7);  -- _#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- _#_0
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_0 : natural_47_1d(1 to 15);  -- _#_0
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_position, leftright_held_position,
    leftright_address_0, leftright_asking_disparity_0, leftright_asking_margin_0, leftright_answered_disparity_0,
    leftright_answered_margin_0, leftright_checked_disparity_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0 : boolean;
  signal leftright_asking_tag : tag_4_c;
  signal leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag : tag_4_c;
  signal leftright_checked_passed_0 : boolean;
  signal leftright_checked_tag : tag_5_b;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1, leftright_found_0 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0,
    leftright_checked_fraction_0 : natural range 0 to 31;
  -- support
  signal support_counter_column, support_counter_group, support_read_column, support_ready_column,
    support_write_column : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- _#_0
  signal support_newest_rest_0, support_rest_rows_read_newest_0, support_rest_rows_ready_newest_0,
    support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- _#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- _#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_moves, support_arrives, support_last, support_read_moves, support_read_arrives, support_read_above2,
    support_read_above1, support_read_below1, support_read_below2, support_read_first, support_read_last,
    support_ready_moves, support_ready_arrives, support_ready_above2, support_ready_above1, support_ready_below1,
    support_ready_below2, support_ready_first, support_ready_last, support_at_moves, support_at_arrives,
    support_at_first, support_at_last : boolean;
  signal support_row_tag : boolean_1d(0 to 12);
  signal support_moment_map_column : boolean_1d(0 to 6);  -- _#_map_column
  signal support_moment_start_of_frame : boolean_1d(0 to 6);  -- _#_start_of_frame
  signal support_moment_last : boolean_1d(0 to 6);  -- _#_last
  signal support_next_tag, support_moved : boolean;
  signal support_like_0 : boolean_2d(0 to 6, 0 to 4);
  signal support_enough_0 : boolean;
  signal support_centre_moment_map_column : boolean_1d(0 to 3);  -- _#_map_column
  signal support_centre_moment_start_of_frame : boolean_1d(0 to 3);  -- _#_start_of_frame
  signal support_centre_moment_last : boolean_1d(0 to 3);  -- _#_last
  signal support_centre_moved : boolean_1d(0 to 3);
  signal support_out_passed_0 : boolean;
  signal support_out_tag : tag_5_b;
  signal support_rows_read_words_0 : unsigned(27 downto 0);
  signal support_rows_ready_words_0, support_rows_write_words_0 : natural range 0 to 268435455;
  signal support_rest_rows_read_words_0 : unsigned(19 downto 0);
  signal support_rest_rows_ready_words_0, support_rest_rows_write_words_0 : natural range 0 to 1048575;
  signal support_partial_0 : natural_5_1d(0 to 6);
  signal support_count_0 : natural range 0 to 35;
  signal support_sum_0 : natural range 0 to 273;
  signal support_out_sure_0 : natural range 0 to 255;
  -- fill
  signal fill_counter_column, fill_counter_group, fill_read_column, fill_ready_column, fill_write_column,
    fill_at_column : natural range 0 to 511;
  signal fill_asking_at_column : natural_511_1d(0 to 1);  -- _#_column
  signal fill_known_at_column, fill_beside_0_left_column, fill_beside_0_right_column, fill_measured_at_column,
    fill_measured_beside_0_right_column, fill_width_0, fill_chosen_at_column,
    fill_write_above_column : natural range 0 to 511;
  signal fill_newest_disparity_0, fill_pixel_0_disparity : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- _#_0_disparity
  signal fill_known_0_disparity, fill_beside_0_left, fill_beside_0_right, fill_measured_0_disparity,
    fill_measured_beside_0_left, fill_measured_beside_0_right, fill_chosen_0_disparity, fill_chosen_beside_0_left,
    fill_chosen_beside_0_right : natural range 0 to 1023;
  signal fill_newest_passed_0, fill_moves, fill_arrives, fill_last, fill_read_moves, fill_read_arrives, fill_read_top,
    fill_read_last, fill_ready_moves, fill_ready_arrives, fill_ready_top, fill_ready_last, fill_ends_open_0,
    fill_pixel_0_passed, fill_at_moves, fill_at_arrives, fill_at_top, fill_at_last, fill_in_hole_0 : boolean;
  signal fill_asking_0_passed : boolean_1d(0 to 1);  -- _#_0_passed
  signal fill_asking_at_moves : boolean_1d(0 to 1);  -- _#_moves
  signal fill_asking_at_arrives : boolean_1d(0 to 1);  -- _#_arrives
  signal fill_asking_at_top : boolean_1d(0 to 1);  -- _#_top
  signal fill_asking_at_last : boolean_1d(0 to 1);  -- _#_last
  signal fill_hole_starts_0 : boolean_1d(0 to 1);  -- _#_0
  signal fill_known_0_passed, fill_known_at_moves, fill_known_at_arrives, fill_known_at_top, fill_known_at_last,
    fill_beside_0_has_left, fill_beside_0_has_right, fill_measured_0_passed, fill_measured_at_moves,
    fill_measured_at_arrives, fill_measured_at_top, fill_measured_at_last, fill_measured_beside_0_has_left,
    fill_measured_beside_0_has_right, fill_rises_0, fill_chosen_0_passed, fill_chosen_at_moves, fill_chosen_at_arrives,
    fill_chosen_at_top, fill_chosen_at_last, fill_chosen_beside_0_has_left, fill_chosen_beside_0_has_right,
    fill_takes_left_0, fill_out_passed_0, fill_out_filled_0 : boolean;
  signal fill_out_tag : tag_5_b;
  signal fill_has_values, fill_had_values : boolean;
  signal fill_newest_sure_0, fill_ends_next_place_0, fill_ends_row_place_0, fill_ends_row_above_place_0,
    fill_ends_write_place_0, fill_ends_read_place_0, fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- _#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0,
    fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 1048575;
  signal fill_ends_read_words_0 : unsigned(19 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_counter_group, median_read_column, median_ready_column, median_write_column,
    median_at_column, median_comparing_column, median_sorted_column, median_beside_newest_0,
    median_beside_rows_read_newest_0, median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0,
    median_beside_rows_write_words_0, median_beside_column_0 : natural range 0 to 511;
  signal median_beside_of_column_0, median_beside_in_window_0 : natural_511_1d(0 to 1);  -- _#_0
  signal median_beside_waiting_0 : natural_511_1d(0 to 2);  -- _#_0
  signal median_counter_next_frame, median_arrives, median_behind, median_line_ended, median_read_arrives,
    median_read_behind, median_read_top, median_read_bottom, median_read_output, median_ready_arrives,
    median_ready_behind, median_ready_top, median_ready_output, median_at_arrives, median_at_behind, median_at_top,
    median_at_output, median_of_column_0_b_below_a, median_of_column_0_c_below_a,
    median_of_column_0_c_below_b : boolean;
  signal median_column_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal median_comparing_arrives, median_comparing_behind, median_comparing_top, median_comparing_output,
    median_sorted_arrives, median_sorted_behind, median_sorted_top, median_sorted_output : boolean;
  signal median_passed_0 : boolean_1d(0 to 1);  -- _#_0
  signal median_window_complete, median_window_first, median_window_last, median_of_low_0_b_below_a,
    median_of_low_0_c_below_a, median_of_low_0_c_below_b, median_of_middle_0_b_below_a, median_of_middle_0_c_below_a,
    median_of_middle_0_c_below_b, median_of_high_0_b_below_a, median_of_high_0_c_below_a, median_of_high_0_c_below_b,
    median_of_all_0_b_below_a, median_of_all_0_c_below_a, median_of_all_0_c_below_b : boolean;
  signal median_waiting_complete : boolean_1d(0 to 2);  -- _#_complete
  signal median_waiting_first : boolean_1d(0 to 2);  -- _#_first
  signal median_waiting_last : boolean_1d(0 to 2);  -- _#_last
  signal median_waiting_passed_0 : boolean_1d(0 to 2);  -- _#_0
  signal median_out_passed_0, median_out_filled_0, median_out_valid, median_out_start_of_frame,
    median_out_end_of_line : boolean;
  signal median_newest_0, median_rows_read_newest_0, median_rows_ready_newest_0,
    median_column_2 : natural range 0 to 65535;
  signal median_rows_read_words_0 : unsigned(25 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 67108863;
  signal median_rows_write_words_0 : natural range 0 to 536870911;
  signal median_column_1 : natural range 0 to 8191;
  signal median_of_column_0_a, median_of_column_0_b : natural range 0 to 4095;
  signal median_of_column_0_c, median_sorted_low_0, median_sorted_middle_0,
    median_sorted_high_0 : natural range 0 to 32767;
  signal median_low_0, median_middle_0, median_high_0 : natural_32767_1d(0 to 2);  -- _#_0
  signal median_of_low_0_a, median_of_low_0_b, median_of_low_0_c, median_of_middle_0_a, median_of_middle_0_b,
    median_of_middle_0_c, median_of_high_0_a, median_of_high_0_b, median_of_high_0_c, median_largest_low_0,
    median_median_middle_0, median_smallest_high_0, median_of_all_0_a, median_of_all_0_b, median_of_all_0_c,
    median_out_disparity_0 : natural range 0 to 32767;
  signal median_beside_rows_read_words_0 : unsigned(8 downto 0);
  signal median_out_confidence_0 : natural range 0 to 255;
  -- other
  signal other_0 : boolean;
  signal other_1 : natural range 0 to 8190;
  signal other_2 : natural range 0 to 15;
  signal other_3 : natural range 0 to 63;
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;
  signal other : natural_4096_1d(11 to 22);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(unsigned'(to_unsigned(median_out_confidence_0, 8) & to_unsigned(as_number(median_out_filled_0), 1) & to_unsigned(median_out_disparity_0, 15)));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

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

  median_beside_rows_read_words_0_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 9);
    write_address <= to_unsigned(median_at_column, 9);
    write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
    cell : entity work.line_memory generic map (442, 9, 9)
      port map (clock, true, read_address, median_beside_rows_read_words_0, write_address, write_data);
  end block;

  median_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(median_counter_column, 9);
    write_address <= to_unsigned(median_at_column, 9);
    write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (442, 26, 9)
      port map (clock, true, read_address, median_rows_read_words_0, write_address, write_data);
  end block;

  fill_above_read_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(fill_known_at_column, 9);
    write_address <= to_unsigned(fill_write_above_column, 9);
    write_data <= to_unsigned(fill_write_above_0, 16);
    cell : entity work.line_memory generic map (442, 16, 9)
      port map (clock, true, read_address, fill_above_read_0, write_address, write_data);
  end block;

  fill_ends_read_words_0_memory : block
    signal read_address, write_address : unsigned(7 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(fill_ends_read_place_0, 8);
    write_address <= to_unsigned(fill_ends_write_place_0, 8);
    write_data <= to_unsigned(fill_ends_write_words_0, 20);
    cell : entity work.line_memory generic map (225, 20, 8)
      port map (clock, true, read_address, fill_ends_read_words_0, write_address, write_data);
  end block;

  fill_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(18 downto 0);
  begin
    read_address <= to_unsigned(fill_counter_column, 9);
    write_address <= to_unsigned(fill_at_column, 9);
    write_data <= to_unsigned(fill_rows_write_words_0, 19);
    cell : entity work.line_memory generic map (442, 19, 9)
      port map (clock, true, read_address, fill_rows_read_words_0, write_address, write_data);
  end block;

  support_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 9);
    write_address <= to_unsigned(support_write_column, 9);
    write_data <= to_unsigned(support_rows_write_words_0, 28);
    cell : entity work.line_memory generic map (442, 28, 9)
      port map (clock, true, read_address, support_rows_read_words_0, write_address, write_data);
  end block;

  support_rest_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(support_counter_column, 9);
    write_address <= to_unsigned(support_write_column, 9);
    write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
    cell : entity work.line_memory generic map (442, 20, 9)
      port map (clock, true, read_address, support_rest_rows_read_words_0, write_address, write_data);
  end block;

  leftright_found_0_memory : block
    signal read_address, write_address, write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(leftright_address_0, 6);
    write_address <= to_unsigned(leftright_position, 6);
    write_data <= to_unsigned(leftright_other_0(15), 6);
    cell : entity work.line_memory generic map (64, 6, 6)
      port map (clock, true, read_address, leftright_found_0, write_address, write_data);
  end block;

  leftright_held_1_memory : block
    signal read_address, write_address, write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(leftright_ring_read_address, 6);
    write_address <= to_unsigned(leftright_ring_write_address, 6);
    write_data <= to_unsigned(refinement_margin_0(9), 6);
    cell : entity work.line_memory generic map (48, 6, 6)
      port map (clock, true, read_address, leftright_held_1, write_address, write_data);
  end block;

  leftright_held_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(leftright_ring_read_address, 6);
    write_address <= to_unsigned(leftright_ring_write_address, 6);
    write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned((other(11) / 4096), 1) &
      to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) &
      to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) &
      to_unsigned(as_number(refinement_tag_output_column(11)), 1) &
      to_unsigned(as_number(refinement_tag_map_column(11)), 1);
    cell : entity work.line_memory generic map (48, 18, 6)
      port map (clock, true, read_address, leftright_held_0, write_address, write_data);
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
    read_address <= to_unsigned(slice0cost_ready_column, 9);
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
    write_address <= to_unsigned(slice2cost_ready_column, 9);
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
    write_address <= to_unsigned(slice2cost_change_column, 9);
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
    variable transform_counter_group_is_equals, leftright_checked_tag_row_start_is_equals,
      support_out_tag_row_start_is_equals, fill_out_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_map_column_is_less, delay_tag_first_column_is_equal, slice0other_cost_0_15_all,
      slice0winner4_best_cost_0_0_is_less, slice0winner4_best_below_0_0_is_equal,
      slice0winner4_best_above_0_0_is_equal, slice1mask_inside_0_all, slice1other_cost_0_15_all,
      slice1winner4_best_cost_0_0_is_less, slice1winner4_best_below_0_0_is_equal,
      slice1winner4_best_above_0_0_is_equal, slice1_best_cost_0_0_is_less, slice1_best_below_0_0_is_equal,
      slice1_best_above_0_0_is_equal, slice2mask_inside_0_all, slice2other_winner_0_15_choice,
      slice2winner4_best_cost_0_0_is_less, slice2winner4_best_below_0_0_is_equal,
      slice2winner4_best_above_0_0_is_equal, slice2_best_cost_0_0_is_less, slice2_best_below_0_0_is_equal,
      slice2_best_above_0_0_is_equal, refinement_below_0_differs, refinement_below_0_choice,
      refinement_above_0_differs, refinement_above_0_choice, refinement_divisor_0_0_is_less,
      leftright_holds_winners_choice, leftright_checked_tag_row_start_differs, support_moment_0_start_of_frame_choice,
      support_out_tag_row_start_differs, fill_ends_read_place_0_is_equal, fill_ends_read_place_0_choice,
      fill_out_filled_0_is_equal, fill_out_filled_0_choice, fill_out_tag_row_start_differs, fill_ends_row_place_0_all,
      fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice, median_window_complete_is_equal,
      median_window_complete_choice : boolean;
    variable transform_counter_group_choice, support_counter_group_choice, fill_counter_group_choice,
      median_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices, support_counter_group_choices, fill_counter_group_choices,
      median_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(7 to 193);
    variable transform_counter_next_frame_choices, support_next_tag_choices,
      fill_ends_next_place_0_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice0window_change_0_choice, slice1cost_column_0_choice,
      slice1window_change_0_choice, slice2cost_column_0_choice, slice2window_change_0_choice : natural_255_1d(0 to 15);  -- _#_choice
    variable slice0cost_column_0_value, slice1cost_column_0_value, slice2cost_column_0_value : natural_255_1d(0 to 15);  -- _#_value
    variable slice0window_sum_0_choice, slice0winner1_held_0_choice, slice1window_sum_0_choice,
      slice1winner1_held_0_choice, slice2window_sum_0_choice, slice2winner1_held_0_choice : natural_2047_1d(0 to 15);  -- _#_choice
    variable slice0mask_inside_choice, slice1mask_inside_choice, slice1other_cost_0_choice,
      slice2mask_inside_choice : boolean_1d(0 to 15);  -- _#_choice
    variable slice0other_cost_0_choice : boolean_1d(1 to 15);  -- _#_choice
    variable slice0winner1_held_0_any, slice1winner1_held_0_any, slice2winner1_held_0_any : natural_2047_1d(0 to 15);  -- _#_any
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less,
      slice2winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less,
      slice2winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable slice0winner2_best_below_0_is_equal, slice1winner2_best_below_0_is_equal,
      slice2winner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- _#_is_equal
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice, slice1winner2_best_below_0_choice,
      slice1winner2_best_above_0_choice, slice2winner2_best_below_0_choice,
      slice2winner2_best_above_0_choice : natural_2047_1d(0 to 3);  -- _#_choice
    variable slice0winner2_best_second_0_choice, slice1winner2_best_second_0_choice,
      slice2winner2_best_second_0_choice : natural_2047_2d(0 to 3, 1 to 4);  -- _#_choice_#
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less,
      slice2winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable slice0winner3_best_below_0_is_equal, slice0winner3_best_above_0_is_equal,
      slice1winner3_best_below_0_is_equal, slice1winner3_best_above_0_is_equal, slice2winner3_best_below_0_is_equal,
      slice2winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable slice0winner3_best_below_0_choice, slice0winner3_best_above_0_choice, slice1winner3_best_below_0_choice,
      slice1winner3_best_above_0_choice, slice2winner3_best_below_0_choice,
      slice2winner3_best_above_0_choice : natural_2047_1d(0 to 1);  -- _#_choice
    variable slice0winner3_best_second_0_choice, slice1winner3_best_second_0_choice,
      slice2winner3_best_second_0_choice : natural_2047_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice,
      slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice, slice1_best_below_0_0_choice,
      slice1_best_above_0_0_choice, slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice,
      slice2_best_below_0_0_choice, slice2_best_above_0_0_choice,
      refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable slice0winner4_best_second_0_0_choices, slice1winner4_best_second_0_0_choices,
      slice1_best_second_0_0_choices, slice2winner4_best_second_0_0_choices,
      slice2_best_second_0_0_choices : natural_2047_1d(1 to 4);  -- _choice_#
    variable slice2other_cost_0_choice : boolean_1d(0 to 14);  -- _#_choice
    variable refinement_below_0_values : boolean_1d(1 to 2);  -- _value_#
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_0_difference : natural_2049_to_8190_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice, support_out_sure_0_choice, fill_takes_left_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -62 to 64;
    variable leftright_checked_tag_row_start_choices, support_out_tag_row_start_choices,
      fill_out_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable leftright_checked_tag_row_start_alls, support_out_tag_row_start_alls, fill_out_disparity_0_alls,
      fill_out_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- _#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- _#_#_value
    variable support_like_0_0_choice : boolean_1d(0 to 6);  -- _#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 6);  -- _#_1_differs
    variable fill_ends_read_place_0_choices : natural_255_1d(2 to 3);  -- _choice_#
    variable fill_takes_left_0_choice_2 : natural range 0 to 511;
    variable fill_out_disparity_0_choice : natural range 0 to 1023;
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice, median_low_0_0_choice,
      median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
    variable fill_write_above_0_choice : natural range 0 to 65535;
    variable median_of_column_0_a_choice : natural range 0 to 4095;
    variable median_sorted_low_0_choices, median_sorted_middle_0_choices, median_sorted_high_0_choices,
      median_largest_low_0_choices, median_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable median_median_middle_0_choices, median_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable median_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    support_like_0_0_choice := (others => false); support_like_0_1_differs := (others => false);
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
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
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
    delay_tag_map_column_is_less := (((((raster_place_column / 4) + 16383) mod 16384) * 4) + (raster_place_column mod
      4)) < 442;
    delay_tag_first_column_is_equal := raster_place_column = 4;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 384);
    delay_row_inside(1) <= raster_place_group < 375;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.leaves_window <= (raster_place_column >= 9) and (raster_place_column < 450);
    delay_tag.map_column <= delay_tag_map_column_is_less;
    delay_tag.output_column <= delay_tag_map_column_is_less and ((((((raster_place_group / 4) + 16383) mod 16384) * 4)
      + (raster_place_group mod 4)) < 375);
    delay_tag.first_column <= delay_tag_first_column_is_equal;
    delay_tag.start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 4);
    delay_tag.end_of_line <= raster_place_column = 445;
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
        slice0cost_column_0_choice(4 * i + j) := choice(slice0cost_ready_tag.first_group, 0,
          to_integer(slice0cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice0cost_column_0_value(4 * i + j) := (slice0cost_change_0(4 * i + j) + slice0cost_column_0_choice(4 * i +
          j)) mod 256;
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
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    slice0cost_column_0 <= slice0cost_column_0_value;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag <= slice0cost_ready_tag;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 512);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        512);
    end if;
    if slice0cost_pixels_tag.valid then
      slice0cost_ready_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice0cost_ready_column + 1) mod 512);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 3 loop
        slice0cost_write_words(i) <= to_unsigned(slice0cost_column_0_value(4 * i + 3), 8) &
          to_unsigned(slice0cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice0cost_column_0_value(4 * i + 1), 8) &
          to_unsigned(slice0cost_column_0_value(4 * i), 8);
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
    slice0window_change_tag.row_start <= slice0window_entering_tag.row_start;
    slice0window_change_tag.leaves_window <= slice0window_entering_tag.leaves_window;
    slice0window_change_tag.map_column <= slice0window_entering_tag.map_column;
    slice0window_change_tag.output_column <= slice0window_entering_tag.output_column;
    slice0window_change_tag.first_column <= slice0window_entering_tag.first_column;
    slice0window_change_tag.start_of_frame <= slice0window_entering_tag.start_of_frame;
    slice0window_change_tag.end_of_line <= slice0window_entering_tag.end_of_line;
    slice0window_centre_map_column_0 <= slice0window_change_tag.map_column;
    slice0window_centre_start_of_frame_0 <= slice0window_change_tag.start_of_frame;
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    slice0window_tag.output_column <= slice0window_centre_output_column(3);
    slice0window_tag.first_column <= slice0window_centre_first_column(3);
    for i in 0 to 15 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.row_start, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 15 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 2048;
      end loop;
      slice0window_centre_output_column(0) <= slice0window_change_tag.output_column;
      slice0window_centre_output_column(1 to 3) <= slice0window_centre_output_column(0 to 2);
      slice0window_centre_first_column(0) <= slice0window_change_tag.first_column;
      slice0window_centre_first_column(1 to 3) <= slice0window_centre_first_column(0 to 2);
    end if;
    if slice0winner1_tag.valid then
      slice0window_centre_start_of_frame_3 <= slice2window_centre_start_of_frame_0;
      slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame_3;
    end if;
    -- slice0mask
    slice0mask_inside_choice(0) := choice(slice0window_change_tag.valid, slice0window_centre_first_column(3),
      slice0mask_inside(0));
    for i in 1 to 15 loop
      slice0mask_inside_choice(i) := choice(slice0window_change_tag.valid, slice0mask_inside(i - 1),
        slice0mask_inside(i));
    end loop;
    slice0mask_left_out <= slice0mask_inside(15);
    slice0mask_inside(0) <= choice(slice0mask_column < 441, slice0mask_inside(0) or slice0window_change_tag.valid,
      slice0mask_inside_choice(0));
    for i in 1 to 15 loop
      slice0mask_inside(i) <= choice(slice0window_centre_first_column(3), slice0mask_inside(i) and (not
        slice0window_change_tag.valid), slice0mask_inside_choice(i));
    end loop;
    if slice0window_change_tag.valid then
      slice0mask_column <= choice(slice0window_centre_first_column(3), 0, (slice0mask_column + 1) mod 512);
    end if;
    -- slice0other
    for i in 1 to 14 loop
      slice0other_cost_0_choice(i) := choice((slice0window_sum_0(i) - slice0other_cost_0(i - 1)) < 0,
        slice0window_tag.output_column and slice0mask_inside(i), slice0window_tag.output_column and
        slice0window_tag.first_column and slice0mask_inside(i));
    end loop;
    slice0other_cost_0_choice(15) := choice((slice0window_sum_0(15) - slice0other_cost_0(14)) < 0,
      slice0mask_inside(15), slice0window_tag.first_column and slice0mask_inside(15));
    slice0other_cost_0_15_all := slice0window_tag.output_column and slice0other_cost_0_choice(15);
    if slice0window_tag.valid then
      slice0other_winner_0_1 <= slice0other_cost_0_choice(1);
      slice0other_cost_0(0) <= choice(slice0window_tag.output_column and slice0mask_inside(0), slice0window_sum_0(0),
        0);
      slice0other_cost_0(1) <= choice(slice0other_cost_0_choice(1), slice0window_sum_0(1), slice0other_cost_0(0));
      slice0other_cost_0(2) <= choice(slice0other_cost_0_choice(2), slice0window_sum_0(2), slice0other_cost_0(1));
      slice0other_winner_0(2) <= choice(slice0other_cost_0_choice(2), 2, as_number(slice0other_winner_0_1));
      for i in 3 to 14 loop
        slice0other_cost_0(i) <= choice(slice0other_cost_0_choice(i), slice0window_sum_0(i), slice0other_cost_0(i - 1));
        slice0other_winner_0(i) <= choice(slice0other_cost_0_choice(i), i, slice0other_winner_0(i - 1));
      end loop;
      slice0other_cost_0(15) <= choice(slice0other_cost_0_15_all, slice0window_sum_0(15), slice0other_cost_0(14));
      slice0other_winner_0(15) <= choice(slice0other_cost_0_15_all, 15, slice0other_winner_0(14));
    end if;
    slice0other_cost_out_0 <= slice0other_cost_0(15);
    slice0other_winner_out_0 <= slice0other_winner_0(15);
    -- slice0winner1
    for i in 0 to 15 loop
      slice0winner1_held_0_choice(i) := choice(slice0mask_inside(i), 0, 2047);
      slice0winner1_held_0_any(i) := to_integer(((to_unsigned(slice0window_sum_0(i), 11)) or
        (to_unsigned(slice0winner1_held_0_choice(i), 11))));
    end loop;
    for i in 0 to 7 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0winner1_held_0_any(2 * i + 1) - slice0winner1_held_0_any(2 * i)) <
        0;
    end loop;
    slice0winner1_held_0 <= slice0winner1_held_0_any;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_place_0(1) <= slice0winner1_best_cost_0_is_less(2);
    slice0winner1_best_place_0(2) <= slice0winner1_best_cost_0_is_less(4);
    slice0winner1_best_place_0(3) <= slice0winner1_best_cost_0_is_less(6);
    slice0winner1_best_late_cost_0 <= slice0winner1_best_cost_0;
    for i in 1 to 7 loop slice0winner1_best_but_first_0(i) <= slice0winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice0winner1_best_but_last_0(i) <= slice0winner1_held_0(2 * i); end loop;
    slice0winner1_tag.valid <= slice0window_tag.valid;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0winner1_held_0_any(1),
      slice0winner1_held_0_any(0));
    for i in 0 to 6 loop
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0winner1_held_0_any(2 * i), 0);
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 0, slice0winner1_held_0_any(2 * i +
        1));
      slice0winner1_best_cost_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), slice0winner1_held_0_any(2 *
        i + 3), slice0winner1_held_0_any(2 * i + 2));
      slice0winner1_best_index_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice0winner1_best_below_0(7) <= choice(slice0winner1_best_cost_0_is_less(7), slice0winner1_held_0_any(14), 0);
    slice0winner1_best_above_0(7) <= choice(slice0winner1_best_cost_0_is_less(7), 0, slice0winner1_held_0_any(15));
    if slice0winner1_tag.valid then
      slice0winner1_tag.map_column <= slice2window_centre_map_column(2);
      slice0winner1_tag.output_column <= slice2window_centre_output_column(2);
      slice0winner1_tag.first_column <= slice2window_centre_first_column(2);
      slice0winner1_tag.start_of_frame <= slice0window_tag.start_of_frame;
      slice0winner1_tag.end_of_line <= slice2window_centre_end_of_line(2);
    end if;
    -- slice0winner2
    for i in 0 to 3 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_below_0_is_equal(0) := slice0winner1_best_index_0(1) = 2;
    slice0winner2_best_below_0_choice(0) := choice(slice0winner2_best_below_0_is_equal(0), slice0winner1_held_0(1),
      slice0winner1_best_below_0(1));
    slice0winner2_best_below_0_is_equal(1) := slice0winner1_best_index_0(3) = 6;
    slice0winner2_best_below_0_choice(1) := choice(slice0winner2_best_below_0_is_equal(1), slice0winner1_held_0(5),
      slice0winner1_best_below_0(3));
    slice0winner2_best_below_0_is_equal(2) := (slice0winner1_best_index_0(5) mod 4) = 2;
    slice0winner2_best_below_0_choice(2) := choice(is_set(slice0winner1_best_index_0(5), 3) and
      slice0winner2_best_below_0_is_equal(2), slice0winner1_held_0(9), slice0winner1_best_below_0(5));
    slice0winner2_best_below_0_is_equal(3) := slice0winner1_best_index_0(7) = 14;
    slice0winner2_best_below_0_choice(3) := choice(slice0winner2_best_below_0_is_equal(3), slice0winner1_held_0(13),
      slice0winner1_best_below_0(7));
    slice0winner2_best_above_0_choice(0) := choice(slice0winner1_best_index_0_0, slice0winner1_held_0(2),
      slice0winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice0winner2_best_above_0_choice(i) := choice(slice0winner1_best_place_0(i), slice0winner1_held_0(4 * i + 2),
        slice0winner1_best_above_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice0winner2_best_second_0_choice(i, 1) := choice(slice0winner2_best_place_0(i), 2047,
        slice0winner1_best_late_cost_0(2 * i + 1));
      slice0winner2_best_second_0_choice(i, 2) := choice(slice0winner2_best_at_end_0(i),
        slice0winner1_best_but_first_0(2 * i + 1), slice0winner2_best_second_0_choice(i, 1));
      slice0winner2_best_second_0_choice(i, 3) := choice(slice0winner2_best_place_0(i),
        slice0winner1_best_late_cost_0(2 * i), 2047);
      slice0winner2_best_second_0_choice(i, 4) := choice(slice0winner2_best_at_start_0(i),
        slice0winner1_best_but_last_0(2 * i), slice0winner2_best_second_0_choice(i, 3));
    end loop;
    slice0winner2_best_first_0(1) <= slice0winner1_held_0(4);
    slice0winner2_best_first_0(2) <= slice0winner1_held_0(8);
    slice0winner2_best_first_0(3) <= slice0winner1_held_0(12);
    slice0winner2_best_last_0(0) <= slice0winner1_held_0(3);
    slice0winner2_best_last_0(1) <= slice0winner1_held_0(7);
    slice0winner2_best_last_0(2) <= slice0winner1_held_0(11);
    slice0winner2_best_last_0(3) <= slice0winner1_held_0(15);
    slice0winner2_best_place_0 <= slice0winner2_best_cost_0_is_less;
    slice0winner2_best_at_start_0(0) <= slice0winner2_best_cost_0_is_less(0) and slice0winner2_best_below_0_is_equal(0);
    slice0winner2_best_at_start_0(1) <= slice0winner2_best_cost_0_is_less(1) and slice0winner2_best_below_0_is_equal(1);
    slice0winner2_best_at_start_0(2) <= slice0winner2_best_cost_0_is_less(2) and is_set(slice0winner1_best_index_0(5),
      3) and slice0winner2_best_below_0_is_equal(2);
    slice0winner2_best_at_start_0(3) <= slice0winner2_best_below_0_is_equal(3) and slice0winner2_best_cost_0_is_less(3);
    slice0winner2_best_at_end_0(0) <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0(1) -
      slice0winner1_best_cost_0(0)) >= 0);
    for i in 1 to 3 loop
      slice0winner2_best_at_end_0(i) <= slice0winner1_best_place_0(i) and ((slice0winner1_best_cost_0(2 * i + 1) -
        slice0winner1_best_cost_0(2 * i)) >= 0);
    end loop;
    slice0winner2_best_late_cost_0 <= slice0winner2_best_cost_0;
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
    for i in 0 to 3 loop
      slice0winner2_best_second_0(i) <= smaller(slice0winner2_best_second_0_choice(i, 2),
        slice0winner2_best_second_0_choice(i, 4));
    end loop;
    for i in 1 to 3 loop
      slice0winner2_best_but_first_0(i) <= smaller(slice0winner1_best_late_cost_0(2 * i + 1),
        slice0winner1_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice0winner2_best_but_last_0(i) <= smaller(slice0winner1_best_but_last_0(2 * i + 1),
        slice0winner1_best_late_cost_0(2 * i));
    end loop;
    -- slice0winner3
    slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
    slice0winner3_best_below_0_is_equal(0) := slice0winner2_best_index_0(1) = 4;
    slice0winner3_best_below_0_choice(0) := choice(slice0winner3_best_below_0_is_equal(0),
      slice0winner2_best_last_0(0), slice0winner2_best_below_0(1));
    slice0winner3_best_below_0_is_equal(1) := slice0winner2_best_index_0(3) = 12;
    slice0winner3_best_below_0_choice(1) := choice(slice0winner3_best_below_0_is_equal(1),
      slice0winner2_best_last_0(2), slice0winner2_best_below_0(3));
    slice0winner3_best_above_0_is_equal(0) := slice0winner2_best_index_0(0) = 3;
    slice0winner3_best_above_0_choice(0) := choice(slice0winner3_best_above_0_is_equal(0),
      slice0winner2_best_first_0(1), slice0winner2_best_above_0(0));
    slice0winner3_best_above_0_is_equal(1) := (slice0winner2_best_index_0(2) mod 4) = 3;
    slice0winner3_best_above_0_choice(1) := choice(is_set(slice0winner2_best_index_0(2), 3) and
      slice0winner3_best_above_0_is_equal(1), slice0winner2_best_first_0(3), slice0winner2_best_above_0(2));
    for i in 0 to 1 loop
      slice0winner3_best_second_0_choice(i, 1) := choice(slice0winner3_best_place_0(i), slice0winner2_best_second_0(2 *
        i + 1), slice0winner2_best_late_cost_0(2 * i + 1));
      slice0winner3_best_second_0_choice(i, 2) := choice(slice0winner3_best_at_end_0(i),
        slice0winner2_best_but_first_0(2 * i + 1), slice0winner3_best_second_0_choice(i, 1));
      slice0winner3_best_second_0_choice(i, 3) := choice(slice0winner3_best_place_0(i),
        slice0winner2_best_late_cost_0(2 * i), slice0winner2_best_second_0(2 * i));
      slice0winner3_best_second_0_choice(i, 4) := choice(slice0winner3_best_at_start_0(i),
        slice0winner2_best_but_last_0(2 * i), slice0winner3_best_second_0_choice(i, 3));
    end loop;
    slice0winner3_best_first_0_1 <= slice0winner2_best_first_0(2);
    slice0winner3_best_last_0(0) <= slice0winner2_best_last_0(1);
    slice0winner3_best_last_0(1) <= slice0winner2_best_last_0(3);
    slice0winner3_best_place_0 <= slice0winner3_best_cost_0_is_less;
    slice0winner3_best_at_start_0(0) <= slice0winner3_best_cost_0_is_less(0) and slice0winner3_best_below_0_is_equal(0);
    slice0winner3_best_at_start_0(1) <= slice0winner3_best_below_0_is_equal(1) and slice0winner3_best_cost_0_is_less(1);
    slice0winner3_best_at_end_0(0) <= ((slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) >= 0) and
      slice0winner3_best_above_0_is_equal(0);
    slice0winner3_best_at_end_0(1) <= ((slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) >= 0) and
      is_set(slice0winner2_best_index_0(2), 3) and slice0winner3_best_above_0_is_equal(1);
    slice0winner3_best_late_cost_0 <= slice0winner3_best_cost_0;
    slice0winner3_tag.valid <= slice0winner2_tag.valid;
    slice0winner3_tag.map_column <= slice0winner2_tag.map_column;
    slice0winner3_tag.output_column <= slice0winner2_tag.output_column;
    slice0winner3_tag.start_of_frame <= slice0winner2_tag.start_of_frame;
    slice0winner3_tag.end_of_line <= slice0winner2_tag.end_of_line;
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
    slice0winner3_best_second_0(0) <= smaller(slice0winner3_best_second_0_choice(0, 2),
      slice0winner3_best_second_0_choice(0, 4));
    slice0winner3_best_second_0(1) <= smaller(slice0winner3_best_second_0_choice(1, 2),
      slice0winner3_best_second_0_choice(1, 4));
    slice0winner3_best_but_first_0_1 <= smaller(slice0winner2_best_late_cost_0(3), slice0winner2_best_but_first_0(2));
    slice0winner3_best_but_last_0(0) <= smaller(slice0winner2_best_but_last_0(1), slice0winner2_best_late_cost_0(0));
    slice0winner3_best_but_last_0(1) <= smaller(slice0winner2_best_but_last_0(3), slice0winner2_best_late_cost_0(2));
    -- slice0winner4
    slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_below_0_0_is_equal := slice0winner3_best_index_0(1) = 8;
    slice0winner4_best_below_0_0_choice := choice(slice0winner4_best_below_0_0_is_equal, slice0winner3_best_last_0(0),
      slice0winner3_best_below_0(1));
    slice0winner4_best_above_0_0_is_equal := slice0winner3_best_index_0(0) = 7;
    slice0winner4_best_above_0_0_choice := choice(slice0winner4_best_above_0_0_is_equal, slice0winner3_best_first_0_1,
      slice0winner3_best_above_0(0));
    slice0winner4_best_second_0_0_choices(1) := choice(slice0winner4_best_place_0_0, slice0winner3_best_second_0(1),
      slice0winner3_best_late_cost_0(1));
    slice0winner4_best_second_0_0_choices(2) := choice(slice0winner4_best_at_end_0_0, slice0winner3_best_but_first_0_1,
      slice0winner4_best_second_0_0_choices(1));
    slice0winner4_best_second_0_0_choices(3) := choice(slice0winner4_best_place_0_0, slice0winner3_best_late_cost_0(0),
      slice0winner3_best_second_0(0));
    slice0winner4_best_second_0_0_choices(4) := choice(slice0winner4_best_at_start_0_0,
      slice0winner3_best_but_last_0(0), slice0winner4_best_second_0_0_choices(3));
    slice0winner4_best_last_0_0 <= slice0winner3_best_last_0(1);
    slice0winner4_best_place_0_0 <= slice0winner4_best_cost_0_0_is_less;
    slice0winner4_best_at_start_0_0 <= slice0winner4_best_below_0_0_is_equal and slice0winner4_best_cost_0_0_is_less;
    slice0winner4_best_at_end_0_0 <= ((slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) >= 0) and
      slice0winner4_best_above_0_0_is_equal;
    slice0winner4_best_late_cost_0_0 <= slice0winner4_best_cost_0_0;
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_cost_0(1),
      slice0winner3_best_cost_0(0));
    slice0winner4_best_index_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_index_0(1),
      slice0winner3_best_index_0(0));
    slice0winner4_best_below_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner4_best_below_0_0_choice,
      slice0winner3_best_below_0(0));
    slice0winner4_best_above_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_above_0(1),
      slice0winner4_best_above_0_0_choice);
    slice0winner4_best_second_0_0 <= smaller(slice0winner4_best_second_0_0_choices(2),
      slice0winner4_best_second_0_0_choices(4));
    slice0winner4_best_but_last_0_0 <= smaller(slice0winner3_best_but_last_0(1), slice0winner3_best_late_cost_0(0));
    -- slice0
    slice0_best_index_0_0 <= slice0winner4_best_index_0_0;
    slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
    slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
    slice0_best_last_0_0 <= slice0winner4_best_last_0_0;
    slice0_best_place_0 <= median_read_bottom;
    slice0_best_late_cost_0_0 <= slice0winner4_best_late_cost_0_0;
    slice0_best_second_0_0 <= slice0winner4_best_second_0_0;
    slice0_best_but_last_0_0 <= slice0winner4_best_but_last_0_0;
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
        slice1cost_column_0_choice(4 * i + j) := choice(slice0cost_tag.first_group, 0,
          to_integer(slice1cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice1cost_column_0_value(4 * i + j) := (slice1cost_change_0(4 * i + j) + slice1cost_column_0_choice(4 * i +
          j)) mod 256;
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
    slice1cost_change_column <= slice0cost_change_column;
    for i in 0 to 15 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    slice1cost_ready_words <= slice1cost_read_words;
    slice1cost_ready_column <= slice1cost_change_column;
    slice1cost_column_0 <= slice1cost_column_0_value;
    slice1cost_write_column <= slice0cost_write_column;
    if slice0cost_tag.valid then
      for i in 0 to 3 loop
        slice1cost_write_words(i) <= to_unsigned(slice1cost_column_0_value(4 * i + 3), 8) &
          to_unsigned(slice1cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice1cost_column_0_value(4 * i + 1), 8) &
          to_unsigned(slice1cost_column_0_value(4 * i), 8);
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
    slice1window_change_tag.row_start <= slice0window_change_tag.row_start;
    slice1window_change_tag.leaves_window <= slice0window_change_tag.leaves_window;
    slice1window_change_tag.output_column <= slice0window_change_tag.output_column;
    slice1window_change_tag.first_column <= slice0window_change_tag.first_column;
    slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
    slice1window_centre_output_column(0) <= slice1window_change_tag.output_column;
    slice1window_centre_first_column(0) <= slice1window_change_tag.first_column;
    slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    slice1window_tag.output_column <= slice1window_centre_output_column(3);
    slice1window_tag.first_column <= slice1window_centre_first_column(3);
    for i in 0 to 15 loop
      slice1window_sum_0_choice(i) := choice(slice1window_change_tag.row_start, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 15 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 2048;
      end loop;
      slice1window_centre_output_column(1) <= slice2window_change_tag.output_column;
      slice1window_centre_output_column(2 to 3) <= slice1window_centre_output_column(1 to 2);
      slice1window_centre_first_column(1) <= slice2window_change_tag.first_column;
      slice1window_centre_first_column(2 to 3) <= slice1window_centre_first_column(1 to 2);
    end if;
    -- slice1mask
    slice1mask_inside_0_all := (not slice0window_tag.valid) and slice1mask_inside(0);
    slice1mask_inside_choice(0) := choice(slice1window_centre_first_column(3), slice1mask_inside_0_all,
      slice0window_tag.valid or slice1mask_inside(0));
    for i in 1 to 15 loop
      slice1mask_inside_choice(i) := choice(slice0window_tag.valid, slice1mask_inside(i - 1), slice1mask_inside(i));
    end loop;
    slice1mask_left_out <= slice1mask_inside(15);
    slice1mask_inside(0) <= choice(slice0mask_left_out, slice1mask_inside_choice(0), slice1mask_inside_0_all);
    for i in 1 to 15 loop
      slice1mask_inside(i) <= choice(slice1window_centre_first_column(3), (not slice0window_tag.valid) and
        slice1mask_inside(i), slice1mask_inside_choice(i));
    end loop;
    -- slice1other
    slice1other_cost_0_choice(0) := choice((slice1window_sum_0(0) - slice0other_cost_out_0) < 0,
      slice1window_tag.output_column and slice1mask_inside(0), slice1window_tag.output_column and
      slice1window_tag.first_column and slice1mask_inside(0));
    for i in 1 to 14 loop
      slice1other_cost_0_choice(i) := choice((slice1window_sum_0(i) - slice1other_cost_0(i - 1)) < 0,
        slice1window_tag.output_column and slice1mask_inside(i), slice1window_tag.output_column and
        slice1window_tag.first_column and slice1mask_inside(i));
    end loop;
    slice1other_cost_0_choice(15) := choice(slice1window_tag.first_column, slice1mask_inside(15),
      ((slice1window_sum_0(15) - slice1other_cost_0(14)) < 0) and slice1mask_inside(15));
    slice1other_cost_0_15_all := slice1window_tag.output_column and slice1other_cost_0_choice(15);
    if slice0winner1_tag.valid then
      slice1other_cost_0(0) <= choice(slice1other_cost_0_choice(0), slice1window_sum_0(0), slice0other_cost_out_0);
      slice1other_winner_0(0) <= choice(slice1other_cost_0_choice(0), 16, slice0other_winner_out_0);
      for i in 1 to 14 loop
        slice1other_cost_0(i) <= choice(slice1other_cost_0_choice(i), slice1window_sum_0(i), slice1other_cost_0(i - 1));
        slice1other_winner_0(i) <= choice(slice1other_cost_0_choice(i), i + 16, slice1other_winner_0(i - 1));
      end loop;
      slice1other_cost_0(15) <= choice(slice1other_cost_0_15_all, slice1window_sum_0(15), slice1other_cost_0(14));
      slice1other_winner_0(15) <= choice(slice1other_cost_0_15_all, 31, slice1other_winner_0(14));
    end if;
    slice1other_cost_out_0 <= slice1other_cost_0(15);
    slice1other_winner_out_0 <= slice1other_winner_0(15);
    -- slice1winner1
    for i in 0 to 15 loop
      slice1winner1_held_0_choice(i) := choice(slice1mask_inside(i), 0, 2047);
      slice1winner1_held_0_any(i) := to_integer(((to_unsigned(slice1window_sum_0(i), 11)) or
        (to_unsigned(slice1winner1_held_0_choice(i), 11))));
    end loop;
    for i in 0 to 7 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1winner1_held_0_any(2 * i + 1) - slice1winner1_held_0_any(2 * i)) <
        0;
    end loop;
    slice1winner1_held_0 <= slice1winner1_held_0_any;
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_place_0(1) <= slice1winner1_best_cost_0_is_less(2);
    slice1winner1_best_place_0(2) <= slice1winner1_best_cost_0_is_less(4);
    slice1winner1_best_place_0(3) <= slice1winner1_best_cost_0_is_less(6);
    slice1winner1_best_late_cost_0 <= slice1winner1_best_cost_0;
    for i in 0 to 7 loop slice1winner1_best_but_first_0(i) <= slice1winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice1winner1_best_but_last_0(i) <= slice1winner1_held_0(2 * i); end loop;
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1winner1_held_0_any(1),
      slice1winner1_held_0_any(0));
    for i in 0 to 6 loop
      slice1winner1_best_below_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1winner1_held_0_any(2 * i), 0);
      slice1winner1_best_above_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 0, slice1winner1_held_0_any(2 * i +
        1));
      slice1winner1_best_cost_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), slice1winner1_held_0_any(2 *
        i + 3), slice1winner1_held_0_any(2 * i + 2));
      slice1winner1_best_index_0(i + 1) <= choice(slice1winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice1winner1_best_below_0(7) <= choice(slice1winner1_best_cost_0_is_less(7), slice1winner1_held_0_any(14), 0);
    slice1winner1_best_above_0(7) <= choice(slice1winner1_best_cost_0_is_less(7), 0, slice1winner1_held_0_any(15));
    -- slice1winner2
    for i in 0 to 3 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_below_0_is_equal(0) := slice1winner1_best_index_0(1) = 2;
    slice1winner2_best_below_0_choice(0) := choice(slice1winner2_best_below_0_is_equal(0), slice1winner1_held_0(1),
      slice1winner1_best_below_0(1));
    slice1winner2_best_below_0_is_equal(1) := slice1winner1_best_index_0(3) = 6;
    slice1winner2_best_below_0_choice(1) := choice(slice1winner2_best_below_0_is_equal(1), slice1winner1_held_0(5),
      slice1winner1_best_below_0(3));
    slice1winner2_best_below_0_is_equal(2) := (slice1winner1_best_index_0(5) mod 4) = 2;
    slice1winner2_best_below_0_choice(2) := choice(is_set(slice1winner1_best_index_0(5), 3) and
      slice1winner2_best_below_0_is_equal(2), slice1winner1_held_0(9), slice1winner1_best_below_0(5));
    slice1winner2_best_below_0_is_equal(3) := slice1winner1_best_index_0(7) = 14;
    slice1winner2_best_below_0_choice(3) := choice(slice1winner2_best_below_0_is_equal(3), slice1winner1_held_0(13),
      slice1winner1_best_below_0(7));
    slice1winner2_best_above_0_choice(0) := choice(slice1winner1_best_index_0_0, slice1winner1_held_0(2),
      slice1winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice1winner2_best_above_0_choice(i) := choice(slice1winner1_best_place_0(i), slice1winner1_held_0(4 * i + 2),
        slice1winner1_best_above_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice1winner2_best_second_0_choice(i, 1) := choice(slice1winner2_best_place_0(i), 2047,
        slice1winner1_best_late_cost_0(2 * i + 1));
      slice1winner2_best_second_0_choice(i, 2) := choice(slice1winner2_best_at_end_0(i),
        slice1winner1_best_but_first_0(2 * i + 1), slice1winner2_best_second_0_choice(i, 1));
      slice1winner2_best_second_0_choice(i, 3) := choice(slice1winner2_best_place_0(i),
        slice1winner1_best_late_cost_0(2 * i), 2047);
      slice1winner2_best_second_0_choice(i, 4) := choice(slice1winner2_best_at_start_0(i),
        slice1winner1_best_but_last_0(2 * i), slice1winner2_best_second_0_choice(i, 3));
    end loop;
    slice1winner2_best_first_0(0) <= slice1winner1_held_0(0);
    slice1winner2_best_first_0(1) <= slice1winner1_held_0(4);
    slice1winner2_best_first_0(2) <= slice1winner1_held_0(8);
    slice1winner2_best_first_0(3) <= slice1winner1_held_0(12);
    slice1winner2_best_last_0(0) <= slice1winner1_held_0(3);
    slice1winner2_best_last_0(1) <= slice1winner1_held_0(7);
    slice1winner2_best_last_0(2) <= slice1winner1_held_0(11);
    slice1winner2_best_last_0(3) <= slice1winner1_held_0(15);
    slice1winner2_best_place_0 <= slice1winner2_best_cost_0_is_less;
    slice1winner2_best_at_start_0(0) <= slice1winner2_best_cost_0_is_less(0) and slice1winner2_best_below_0_is_equal(0);
    slice1winner2_best_at_start_0(1) <= slice1winner2_best_cost_0_is_less(1) and slice1winner2_best_below_0_is_equal(1);
    slice1winner2_best_at_start_0(2) <= slice1winner2_best_cost_0_is_less(2) and is_set(slice1winner1_best_index_0(5),
      3) and slice1winner2_best_below_0_is_equal(2);
    slice1winner2_best_at_start_0(3) <= slice1winner2_best_below_0_is_equal(3) and slice1winner2_best_cost_0_is_less(3);
    slice1winner2_best_at_end_0(0) <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0(1) -
      slice1winner1_best_cost_0(0)) >= 0);
    for i in 1 to 3 loop
      slice1winner2_best_at_end_0(i) <= slice1winner1_best_place_0(i) and ((slice1winner1_best_cost_0(2 * i + 1) -
        slice1winner1_best_cost_0(2 * i)) >= 0);
    end loop;
    slice1winner2_best_late_cost_0 <= slice1winner2_best_cost_0;
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
    for i in 0 to 3 loop
      slice1winner2_best_second_0(i) <= smaller(slice1winner2_best_second_0_choice(i, 2),
        slice1winner2_best_second_0_choice(i, 4));
    end loop;
    for i in 0 to 3 loop
      slice1winner2_best_but_first_0(i) <= smaller(slice1winner1_best_late_cost_0(2 * i + 1),
        slice1winner1_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice1winner2_best_but_last_0(i) <= smaller(slice1winner1_best_but_last_0(2 * i + 1),
        slice1winner1_best_late_cost_0(2 * i));
    end loop;
    -- slice1winner3
    slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
    slice1winner3_best_below_0_is_equal(0) := slice1winner2_best_index_0(1) = 4;
    slice1winner3_best_below_0_choice(0) := choice(slice1winner3_best_below_0_is_equal(0),
      slice1winner2_best_last_0(0), slice1winner2_best_below_0(1));
    slice1winner3_best_below_0_is_equal(1) := slice1winner2_best_index_0(3) = 12;
    slice1winner3_best_below_0_choice(1) := choice(slice1winner3_best_below_0_is_equal(1),
      slice1winner2_best_last_0(2), slice1winner2_best_below_0(3));
    slice1winner3_best_above_0_is_equal(0) := slice1winner2_best_index_0(0) = 3;
    slice1winner3_best_above_0_choice(0) := choice(slice1winner3_best_above_0_is_equal(0),
      slice1winner2_best_first_0(1), slice1winner2_best_above_0(0));
    slice1winner3_best_above_0_is_equal(1) := (slice1winner2_best_index_0(2) mod 4) = 3;
    slice1winner3_best_above_0_choice(1) := choice(is_set(slice1winner2_best_index_0(2), 3) and
      slice1winner3_best_above_0_is_equal(1), slice1winner2_best_first_0(3), slice1winner2_best_above_0(2));
    for i in 0 to 1 loop
      slice1winner3_best_second_0_choice(i, 1) := choice(slice1winner3_best_place_0(i), slice1winner2_best_second_0(2 *
        i + 1), slice1winner2_best_late_cost_0(2 * i + 1));
      slice1winner3_best_second_0_choice(i, 2) := choice(slice1winner3_best_at_end_0(i),
        slice1winner2_best_but_first_0(2 * i + 1), slice1winner3_best_second_0_choice(i, 1));
      slice1winner3_best_second_0_choice(i, 3) := choice(slice1winner3_best_place_0(i),
        slice1winner2_best_late_cost_0(2 * i), slice1winner2_best_second_0(2 * i));
      slice1winner3_best_second_0_choice(i, 4) := choice(slice1winner3_best_at_start_0(i),
        slice1winner2_best_but_last_0(2 * i), slice1winner3_best_second_0_choice(i, 3));
    end loop;
    slice1winner3_best_first_0(0) <= slice1winner2_best_first_0(0);
    slice1winner3_best_first_0(1) <= slice1winner2_best_first_0(2);
    slice1winner3_best_last_0(0) <= slice1winner2_best_last_0(1);
    slice1winner3_best_last_0(1) <= slice1winner2_best_last_0(3);
    slice1winner3_best_place_0 <= slice1winner3_best_cost_0_is_less;
    slice1winner3_best_at_start_0(0) <= slice1winner3_best_cost_0_is_less(0) and slice1winner3_best_below_0_is_equal(0);
    slice1winner3_best_at_start_0(1) <= slice1winner3_best_below_0_is_equal(1) and slice1winner3_best_cost_0_is_less(1);
    slice1winner3_best_at_end_0(0) <= ((slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) >= 0) and
      slice1winner3_best_above_0_is_equal(0);
    slice1winner3_best_at_end_0(1) <= ((slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) >= 0) and
      is_set(slice1winner2_best_index_0(2), 3) and slice1winner3_best_above_0_is_equal(1);
    slice1winner3_best_late_cost_0 <= slice1winner3_best_cost_0;
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
    slice1winner3_best_second_0(0) <= smaller(slice1winner3_best_second_0_choice(0, 2),
      slice1winner3_best_second_0_choice(0, 4));
    slice1winner3_best_second_0(1) <= smaller(slice1winner3_best_second_0_choice(1, 2),
      slice1winner3_best_second_0_choice(1, 4));
    slice1winner3_best_but_first_0(0) <= smaller(slice1winner2_best_late_cost_0(1), slice1winner2_best_but_first_0(0));
    slice1winner3_best_but_first_0(1) <= smaller(slice1winner2_best_late_cost_0(3), slice1winner2_best_but_first_0(2));
    slice1winner3_best_but_last_0(0) <= smaller(slice1winner2_best_but_last_0(1), slice1winner2_best_late_cost_0(0));
    slice1winner3_best_but_last_0(1) <= smaller(slice1winner2_best_but_last_0(3), slice1winner2_best_late_cost_0(2));
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_below_0_0_is_equal := slice1winner3_best_index_0(1) = 8;
    slice1winner4_best_below_0_0_choice := choice(slice1winner4_best_below_0_0_is_equal, slice1winner3_best_last_0(0),
      slice1winner3_best_below_0(1));
    slice1winner4_best_above_0_0_is_equal := slice1winner3_best_index_0(0) = 7;
    slice1winner4_best_above_0_0_choice := choice(slice1winner4_best_above_0_0_is_equal, slice1winner3_best_first_0(1),
      slice1winner3_best_above_0(0));
    slice1winner4_best_second_0_0_choices(1) := choice(slice1winner4_best_place_0_0, slice1winner3_best_second_0(1),
      slice1winner3_best_late_cost_0(1));
    slice1winner4_best_second_0_0_choices(2) := choice(slice1winner4_best_at_end_0_0,
      slice1winner3_best_but_first_0(1), slice1winner4_best_second_0_0_choices(1));
    slice1winner4_best_second_0_0_choices(3) := choice(slice1winner4_best_place_0_0, slice1winner3_best_late_cost_0(0),
      slice1winner3_best_second_0(0));
    slice1winner4_best_second_0_0_choices(4) := choice(slice1winner4_best_at_start_0_0,
      slice1winner3_best_but_last_0(0), slice1winner4_best_second_0_0_choices(3));
    slice1winner4_best_first_0_0 <= slice1winner3_best_first_0(0);
    slice1winner4_best_last_0_0 <= slice1winner3_best_last_0(1);
    slice1winner4_best_place_0_0 <= slice1winner4_best_cost_0_0_is_less;
    slice1winner4_best_at_start_0_0 <= slice1winner4_best_below_0_0_is_equal and slice1winner4_best_cost_0_0_is_less;
    slice1winner4_best_at_end_0_0 <= ((slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) >= 0) and
      slice1winner4_best_above_0_0_is_equal;
    slice1winner4_best_late_cost_0_0 <= slice1winner4_best_cost_0_0;
    slice1winner4_best_cost_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    slice1winner4_best_below_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner4_best_below_0_0_choice,
      slice1winner3_best_below_0(0));
    slice1winner4_best_above_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_above_0(1),
      slice1winner4_best_above_0_0_choice);
    slice1winner4_best_second_0_0 <= smaller(slice1winner4_best_second_0_0_choices(2),
      slice1winner4_best_second_0_0_choices(4));
    slice1winner4_best_but_first_0_0 <= smaller(slice1winner3_best_late_cost_0(1), slice1winner3_best_but_first_0(0));
    slice1winner4_best_but_last_0_0 <= smaller(slice1winner3_best_but_last_0(1), slice1winner3_best_late_cost_0(0));
    -- slice1
    slice1_best_cost_0_0_is_less := (slice1winner4_best_cost_0_0 - slice0winner4_best_late_cost_0_0) < 0;
    slice1_best_below_0_0_is_equal := slice1winner4_best_index_0_0 = 0;
    slice1_best_below_0_0_choice := choice(slice1_best_below_0_0_is_equal, slice0_best_last_0_0,
      slice1winner4_best_below_0_0);
    slice1_best_above_0_0_is_equal := slice0_best_index_0_0 = 15;
    slice1_best_above_0_0_choice := choice(slice1_best_above_0_0_is_equal, slice1winner4_best_first_0_0,
      slice0_best_above_0_0);
    slice1_best_second_0_0_choices(1) := choice(slice1_best_place_0_0, slice1winner4_best_second_0_0,
      slice1winner4_best_late_cost_0_0);
    slice1_best_second_0_0_choices(2) := choice(slice1_best_at_end_0_0, slice1winner4_best_but_first_0_0,
      slice1_best_second_0_0_choices(1));
    slice1_best_second_0_0_choices(3) := choice(slice1_best_place_0_0, slice0_best_late_cost_0_0,
      slice0_best_second_0_0);
    slice1_best_second_0_0_choices(4) := choice(slice1_best_at_start_0_0, slice0_best_but_last_0_0,
      slice1_best_second_0_0_choices(3));
    slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
    slice1_best_place_0_0 <= slice1_best_cost_0_0_is_less;
    slice1_best_at_start_0_0 <= slice1_best_below_0_0_is_equal and slice1_best_cost_0_0_is_less;
    slice1_best_at_end_0_0 <= slice1_best_above_0_0_is_equal and ((slice1winner4_best_cost_0_0 -
      slice0winner4_best_late_cost_0_0) >= 0);
    slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_cost_0_0,
      slice0winner4_best_late_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_index_0_0 + 16,
      slice0_best_index_0_0);
    slice1_best_below_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1_best_below_0_0_choice, slice0_best_below_0_0);
    slice1_best_above_0_0 <= choice(slice1_best_cost_0_0_is_less, slice1winner4_best_above_0_0,
      slice1_best_above_0_0_choice);
    slice1_best_second_0_0 <= smaller(slice1_best_second_0_0_choices(2), slice1_best_second_0_0_choices(4));
    slice1_best_but_last_0_0 <= smaller(slice1winner4_best_but_last_0_0, slice0_best_late_cost_0_0);
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
        slice2cost_column_0_choice(4 * i + j) := choice(slice0window_entering_tag.first_group, 0,
          to_integer(slice2cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice2cost_column_0_value(4 * i + j) := (slice2cost_change_0(4 * i + j) + slice2cost_column_0_choice(4 * i +
          j)) mod 256;
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
    slice2cost_read_column <= slice1cost_read_column;
    for i in 0 to 15 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    slice2cost_ready_words <= slice2cost_read_words;
    slice2cost_column_0 <= slice2cost_column_0_value;
    if slice0cost_ready_tag.valid then slice2cost_change_column <= slice2cost_read_column; end if;
    if slice0cost_tag.valid then slice2cost_ready_column <= slice1cost_ready_column; end if;
    if slice0window_entering_tag.valid then
      slice2cost_write_column <= slice1cost_write_column;
      for i in 0 to 3 loop
        slice2cost_write_words(i) <= to_unsigned(slice2cost_column_0_value(4 * i + 3), 8) &
          to_unsigned(slice2cost_column_0_value(4 * i + 2), 8) & to_unsigned(slice2cost_column_0_value(4 * i + 1), 8) &
          to_unsigned(slice2cost_column_0_value(4 * i), 8);
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
    slice2window_change_tag.row_start <= slice1window_change_tag.row_start;
    if slice0window_tag.valid then
      slice2window_change_tag.output_column <= slice1window_change_tag.output_column;
      slice2window_change_tag.first_column <= slice1window_change_tag.first_column;
    end if;
    for i in 0 to 15 loop
      slice2window_sum_0_choice(i) := choice(slice2window_change_tag.row_start, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag.valid then
      for i in 0 to 15 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 2048;
      end loop;
      slice2window_centre_map_column(0) <= slice1window_centre_map_column_0;
      slice2window_centre_map_column(1 to 2) <= slice2window_centre_map_column(0 to 1);
      slice2window_centre_output_column(0) <= slice1window_centre_output_column(0);
      slice2window_centre_output_column(1 to 2) <= slice2window_centre_output_column(0 to 1);
      slice2window_centre_first_column(0) <= slice1window_centre_first_column(0);
      slice2window_centre_first_column(1 to 2) <= slice2window_centre_first_column(0 to 1);
      slice2window_centre_start_of_frame_0 <= slice1window_centre_start_of_frame_0;
      slice2window_centre_end_of_line(0) <= slice1window_centre_end_of_line_0;
      slice2window_centre_end_of_line(1 to 2) <= slice2window_centre_end_of_line(0 to 1);
    end if;
    -- slice2mask
    slice2mask_inside_0_all := (not slice0winner1_tag.valid) and slice2mask_inside(0);
    slice2mask_inside_choice(0) := choice(slice0winner1_tag.first_column, slice2mask_inside_0_all,
      slice0winner1_tag.valid or slice2mask_inside(0));
    for i in 1 to 15 loop
      slice2mask_inside_choice(i) := choice(slice0winner1_tag.valid, slice2mask_inside(i - 1), slice2mask_inside(i));
    end loop;
    slice2mask_inside(0) <= choice(slice1mask_left_out, slice2mask_inside_choice(0), slice2mask_inside_0_all);
    for i in 1 to 15 loop
      slice2mask_inside(i) <= choice(slice0winner1_tag.first_column, (not slice0winner1_tag.valid) and
        slice2mask_inside(i), slice2mask_inside_choice(i));
    end loop;
    -- slice2other
    slice2other_cost_0_choice(0) := choice((slice2window_sum_0(0) - slice1other_cost_out_0) < 0,
      slice0winner2_tag.output_column and slice2mask_inside(0), slice0winner2_tag.output_column and
      slice0winner2_tag.first_column and slice2mask_inside(0));
    for i in 1 to 14 loop
      slice2other_cost_0_choice(i) := choice((slice2window_sum_0(i) - slice2other_cost_0(i - 1)) < 0,
        slice0winner2_tag.output_column and slice2mask_inside(i), slice0winner2_tag.output_column and
        slice0winner2_tag.first_column and slice2mask_inside(i));
    end loop;
    slice2other_winner_0_15_choice := choice(slice0winner2_tag.first_column, slice2mask_inside(15),
      ((slice2window_sum_0(15) - slice2other_cost_0(14)) < 0) and slice2mask_inside(15));
    if slice0winner2_tag.valid then
      slice2other_cost_0(0) <= choice(slice2other_cost_0_choice(0), slice2window_sum_0(0), slice1other_cost_out_0);
      slice2other_winner_0(0) <= choice(slice2other_cost_0_choice(0), 32, slice1other_winner_out_0);
      for i in 1 to 14 loop
        slice2other_cost_0(i) <= choice(slice2other_cost_0_choice(i), slice2window_sum_0(i), slice2other_cost_0(i - 1));
        slice2other_winner_0(i) <= choice(slice2other_cost_0_choice(i), i + 32, slice2other_winner_0(i - 1));
      end loop;
      slice2other_winner_0(15) <= choice(slice0winner2_tag.output_column and slice2other_winner_0_15_choice, 47,
        slice2other_winner_0(14));
    end if;
    slice2other_winner_out_0 <= slice2other_winner_0(15);
    -- slice2winner1
    for i in 0 to 15 loop
      slice2winner1_held_0_choice(i) := choice(slice2mask_inside(i), 0, 2047);
      slice2winner1_held_0_any(i) := to_integer(((to_unsigned(slice2window_sum_0(i), 11)) or
        (to_unsigned(slice2winner1_held_0_choice(i), 11))));
    end loop;
    for i in 0 to 7 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2winner1_held_0_any(2 * i + 1) - slice2winner1_held_0_any(2 * i)) <
        0;
    end loop;
    slice2winner1_held_0 <= slice2winner1_held_0_any;
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    slice2winner1_best_place_0(1) <= slice2winner1_best_cost_0_is_less(2);
    slice2winner1_best_place_0(2) <= slice2winner1_best_cost_0_is_less(4);
    slice2winner1_best_place_0(3) <= slice2winner1_best_cost_0_is_less(6);
    slice2winner1_best_late_cost_0 <= slice2winner1_best_cost_0;
    for i in 0 to 7 loop slice2winner1_best_but_first_0(i) <= slice2winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 6 loop slice2winner1_best_but_last_0(i) <= slice2winner1_held_0(2 * i); end loop;
    slice2winner1_best_cost_0(0) <= choice(slice2winner1_best_cost_0_is_less(0), slice2winner1_held_0_any(1),
      slice2winner1_held_0_any(0));
    for i in 0 to 6 loop
      slice2winner1_best_below_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), slice2winner1_held_0_any(2 * i), 0);
      slice2winner1_best_above_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), 0, slice2winner1_held_0_any(2 * i +
        1));
      slice2winner1_best_cost_0(i + 1) <= choice(slice2winner1_best_cost_0_is_less(i + 1), slice2winner1_held_0_any(2 *
        i + 3), slice2winner1_held_0_any(2 * i + 2));
      slice2winner1_best_index_0(i + 1) <= choice(slice2winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice2winner1_best_below_0(7) <= choice(slice2winner1_best_cost_0_is_less(7), slice2winner1_held_0_any(14), 0);
    slice2winner1_best_above_0(7) <= choice(slice2winner1_best_cost_0_is_less(7), 0, slice2winner1_held_0_any(15));
    -- slice2winner2
    for i in 0 to 3 loop
      slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner2_best_below_0_is_equal(0) := slice2winner1_best_index_0(1) = 2;
    slice2winner2_best_below_0_choice(0) := choice(slice2winner2_best_below_0_is_equal(0), slice2winner1_held_0(1),
      slice2winner1_best_below_0(1));
    slice2winner2_best_below_0_is_equal(1) := slice2winner1_best_index_0(3) = 6;
    slice2winner2_best_below_0_choice(1) := choice(slice2winner2_best_below_0_is_equal(1), slice2winner1_held_0(5),
      slice2winner1_best_below_0(3));
    slice2winner2_best_below_0_is_equal(2) := (slice2winner1_best_index_0(5) mod 4) = 2;
    slice2winner2_best_below_0_choice(2) := choice(is_set(slice2winner1_best_index_0(5), 3) and
      slice2winner2_best_below_0_is_equal(2), slice2winner1_held_0(9), slice2winner1_best_below_0(5));
    slice2winner2_best_below_0_is_equal(3) := slice2winner1_best_index_0(7) = 14;
    slice2winner2_best_below_0_choice(3) := choice(slice2winner2_best_below_0_is_equal(3), slice2winner1_held_0(13),
      slice2winner1_best_below_0(7));
    slice2winner2_best_above_0_choice(0) := choice(slice2winner1_best_index_0_0, slice2winner1_held_0(2),
      slice2winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice2winner2_best_above_0_choice(i) := choice(slice2winner1_best_place_0(i), slice2winner1_held_0(4 * i + 2),
        slice2winner1_best_above_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice2winner2_best_second_0_choice(i, 1) := choice(slice2winner2_best_place_0(i), 2047,
        slice2winner1_best_late_cost_0(2 * i + 1));
      slice2winner2_best_second_0_choice(i, 2) := choice(slice2winner2_best_at_end_0(i),
        slice2winner1_best_but_first_0(2 * i + 1), slice2winner2_best_second_0_choice(i, 1));
      slice2winner2_best_second_0_choice(i, 3) := choice(slice2winner2_best_place_0(i),
        slice2winner1_best_late_cost_0(2 * i), 2047);
      slice2winner2_best_second_0_choice(i, 4) := choice(slice2winner2_best_at_start_0(i),
        slice2winner1_best_but_last_0(2 * i), slice2winner2_best_second_0_choice(i, 3));
    end loop;
    slice2winner2_best_first_0(0) <= slice2winner1_held_0(0);
    slice2winner2_best_first_0(1) <= slice2winner1_held_0(4);
    slice2winner2_best_first_0(2) <= slice2winner1_held_0(8);
    slice2winner2_best_first_0(3) <= slice2winner1_held_0(12);
    slice2winner2_best_last_0(0) <= slice2winner1_held_0(3);
    slice2winner2_best_last_0(1) <= slice2winner1_held_0(7);
    slice2winner2_best_last_0(2) <= slice2winner1_held_0(11);
    slice2winner2_best_place_0 <= slice2winner2_best_cost_0_is_less;
    slice2winner2_best_at_start_0(0) <= slice2winner2_best_cost_0_is_less(0) and slice2winner2_best_below_0_is_equal(0);
    slice2winner2_best_at_start_0(1) <= slice2winner2_best_cost_0_is_less(1) and slice2winner2_best_below_0_is_equal(1);
    slice2winner2_best_at_start_0(2) <= slice2winner2_best_cost_0_is_less(2) and is_set(slice2winner1_best_index_0(5),
      3) and slice2winner2_best_below_0_is_equal(2);
    slice2winner2_best_at_start_0(3) <= slice2winner2_best_below_0_is_equal(3) and slice2winner2_best_cost_0_is_less(3);
    slice2winner2_best_at_end_0(0) <= slice2winner1_best_index_0_0 and ((slice2winner1_best_cost_0(1) -
      slice2winner1_best_cost_0(0)) >= 0);
    for i in 1 to 3 loop
      slice2winner2_best_at_end_0(i) <= slice2winner1_best_place_0(i) and ((slice2winner1_best_cost_0(2 * i + 1) -
        slice2winner1_best_cost_0(2 * i)) >= 0);
    end loop;
    slice2winner2_best_late_cost_0 <= slice2winner2_best_cost_0;
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
    for i in 0 to 3 loop
      slice2winner2_best_second_0(i) <= smaller(slice2winner2_best_second_0_choice(i, 2),
        slice2winner2_best_second_0_choice(i, 4));
    end loop;
    for i in 0 to 3 loop
      slice2winner2_best_but_first_0(i) <= smaller(slice2winner1_best_late_cost_0(2 * i + 1),
        slice2winner1_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 2 loop
      slice2winner2_best_but_last_0(i) <= smaller(slice2winner1_best_but_last_0(2 * i + 1),
        slice2winner1_best_late_cost_0(2 * i));
    end loop;
    -- slice2winner3
    slice2winner3_best_cost_0_is_less(0) := (slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) < 0;
    slice2winner3_best_cost_0_is_less(1) := (slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) < 0;
    slice2winner3_best_below_0_is_equal(0) := slice2winner2_best_index_0(1) = 4;
    slice2winner3_best_below_0_choice(0) := choice(slice2winner3_best_below_0_is_equal(0),
      slice2winner2_best_last_0(0), slice2winner2_best_below_0(1));
    slice2winner3_best_below_0_is_equal(1) := slice2winner2_best_index_0(3) = 12;
    slice2winner3_best_below_0_choice(1) := choice(slice2winner3_best_below_0_is_equal(1),
      slice2winner2_best_last_0(2), slice2winner2_best_below_0(3));
    slice2winner3_best_above_0_is_equal(0) := slice2winner2_best_index_0(0) = 3;
    slice2winner3_best_above_0_choice(0) := choice(slice2winner3_best_above_0_is_equal(0),
      slice2winner2_best_first_0(1), slice2winner2_best_above_0(0));
    slice2winner3_best_above_0_is_equal(1) := (slice2winner2_best_index_0(2) mod 4) = 3;
    slice2winner3_best_above_0_choice(1) := choice(is_set(slice2winner2_best_index_0(2), 3) and
      slice2winner3_best_above_0_is_equal(1), slice2winner2_best_first_0(3), slice2winner2_best_above_0(2));
    for i in 0 to 1 loop
      slice2winner3_best_second_0_choice(i, 1) := choice(slice2winner3_best_place_0(i), slice2winner2_best_second_0(2 *
        i + 1), slice2winner2_best_late_cost_0(2 * i + 1));
      slice2winner3_best_second_0_choice(i, 2) := choice(slice2winner3_best_at_end_0(i),
        slice2winner2_best_but_first_0(2 * i + 1), slice2winner3_best_second_0_choice(i, 1));
      slice2winner3_best_second_0_choice(i, 3) := choice(slice2winner3_best_place_0(i),
        slice2winner2_best_late_cost_0(2 * i), slice2winner2_best_second_0(2 * i));
      slice2winner3_best_second_0_choice(i, 4) := choice(slice2winner3_best_at_start_0(i),
        slice2winner2_best_but_last_0(2 * i), slice2winner3_best_second_0_choice(i, 3));
    end loop;
    slice2winner3_best_first_0(0) <= slice2winner2_best_first_0(0);
    slice2winner3_best_first_0(1) <= slice2winner2_best_first_0(2);
    slice2winner3_best_last_0_0 <= slice2winner2_best_last_0(1);
    slice2winner3_best_place_0 <= slice2winner3_best_cost_0_is_less;
    slice2winner3_best_at_start_0(0) <= slice2winner3_best_cost_0_is_less(0) and slice2winner3_best_below_0_is_equal(0);
    slice2winner3_best_at_start_0(1) <= slice2winner3_best_below_0_is_equal(1) and slice2winner3_best_cost_0_is_less(1);
    slice2winner3_best_at_end_0(0) <= ((slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) >= 0) and
      slice2winner3_best_above_0_is_equal(0);
    slice2winner3_best_at_end_0(1) <= ((slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) >= 0) and
      is_set(slice2winner2_best_index_0(2), 3) and slice2winner3_best_above_0_is_equal(1);
    slice2winner3_best_late_cost_0 <= slice2winner3_best_cost_0;
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
    slice2winner3_best_second_0(0) <= smaller(slice2winner3_best_second_0_choice(0, 2),
      slice2winner3_best_second_0_choice(0, 4));
    slice2winner3_best_second_0(1) <= smaller(slice2winner3_best_second_0_choice(1, 2),
      slice2winner3_best_second_0_choice(1, 4));
    slice2winner3_best_but_first_0(0) <= smaller(slice2winner2_best_late_cost_0(1), slice2winner2_best_but_first_0(0));
    slice2winner3_best_but_first_0(1) <= smaller(slice2winner2_best_late_cost_0(3), slice2winner2_best_but_first_0(2));
    slice2winner3_best_but_last_0_0 <= smaller(slice2winner2_best_but_last_0(1), slice2winner2_best_late_cost_0(0));
    -- slice2winner4
    slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0(1) = 8;
    slice2winner4_best_below_0_0_choice := choice(slice2winner4_best_below_0_0_is_equal, slice2winner3_best_last_0_0,
      slice2winner3_best_below_0(1));
    slice2winner4_best_above_0_0_is_equal := slice2winner3_best_index_0(0) = 7;
    slice2winner4_best_above_0_0_choice := choice(slice2winner4_best_above_0_0_is_equal, slice2winner3_best_first_0(1),
      slice2winner3_best_above_0(0));
    slice2winner4_best_second_0_0_choices(1) := choice(slice2winner4_best_place_0_0, slice2winner3_best_second_0(1),
      slice2winner3_best_late_cost_0(1));
    slice2winner4_best_second_0_0_choices(2) := choice(slice2winner4_best_at_end_0_0,
      slice2winner3_best_but_first_0(1), slice2winner4_best_second_0_0_choices(1));
    slice2winner4_best_second_0_0_choices(3) := choice(slice2winner4_best_place_0_0, slice2winner3_best_late_cost_0(0),
      slice2winner3_best_second_0(0));
    slice2winner4_best_second_0_0_choices(4) := choice(slice2winner4_best_at_start_0_0,
      slice2winner3_best_but_last_0_0, slice2winner4_best_second_0_0_choices(3));
    slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
    slice2winner4_best_place_0_0 <= slice2winner4_best_cost_0_0_is_less;
    slice2winner4_best_at_start_0_0 <= slice2winner4_best_below_0_0_is_equal and slice2winner4_best_cost_0_0_is_less;
    slice2winner4_best_at_end_0_0 <= ((slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) >= 0) and
      slice2winner4_best_above_0_0_is_equal;
    slice2winner4_best_late_cost_0_0 <= slice2winner4_best_cost_0_0;
    slice2winner4_best_cost_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_cost_0(1),
      slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_index_0(1),
      slice2winner3_best_index_0(0));
    slice2winner4_best_below_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner4_best_below_0_0_choice,
      slice2winner3_best_below_0(0));
    slice2winner4_best_above_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_above_0(1),
      slice2winner4_best_above_0_0_choice);
    slice2winner4_best_second_0_0 <= smaller(slice2winner4_best_second_0_0_choices(2),
      slice2winner4_best_second_0_0_choices(4));
    slice2winner4_best_but_first_0_0 <= smaller(slice2winner3_best_late_cost_0(1), slice2winner3_best_but_first_0(0));
    -- slice2
    slice2_best_cost_0_0_is_less := (slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) < 0;
    slice2_best_below_0_0_is_equal := slice2winner4_best_index_0_0 = 0;
    slice2_best_below_0_0_choice := choice(slice2_best_below_0_0_is_equal, slice1_best_last_0_0,
      slice2winner4_best_below_0_0);
    slice2_best_above_0_0_is_equal := slice1_best_index_0_0 = 31;
    slice2_best_above_0_0_choice := choice(slice2_best_above_0_0_is_equal, slice2winner4_best_first_0_0,
      slice1_best_above_0_0);
    slice2_best_second_0_0_choices(1) := choice(slice2_best_place_0_0, slice2winner4_best_second_0_0,
      slice2winner4_best_late_cost_0_0);
    slice2_best_second_0_0_choices(2) := choice(slice2_best_at_end_0_0, slice2winner4_best_but_first_0_0,
      slice2_best_second_0_0_choices(1));
    slice2_best_second_0_0_choices(3) := choice(slice2_best_place_0_0, slice1_best_late_cost_0_0,
      slice1_best_second_0_0);
    slice2_best_second_0_0_choices(4) := choice(slice2_best_at_start_0_0, slice1_best_but_last_0_0,
      slice2_best_second_0_0_choices(3));
    slice2_best_place_0_0 <= slice2_best_cost_0_0_is_less;
    slice2_best_at_start_0_0 <= slice2_best_below_0_0_is_equal and slice2_best_cost_0_0_is_less;
    slice2_best_at_end_0_0 <= ((slice2winner4_best_cost_0_0 - slice1_best_cost_0_0) >= 0) and
      slice2_best_above_0_0_is_equal;
    slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_cost_0_0, slice1_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_index_0_0 + 32,
      slice1_best_index_0_0);
    slice2_best_below_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2_best_below_0_0_choice, slice1_best_below_0_0);
    slice2_best_above_0_0 <= choice(slice2_best_cost_0_0_is_less, slice2winner4_best_above_0_0,
      slice2_best_above_0_0_choice);
    slice2_best_second_0_0 <= smaller(slice2_best_second_0_0_choices(2), slice2_best_second_0_0_choices(4));
    -- refinement
    refinement_below_0_differs := slice2_best_below_0_0 /= 2047;
    refinement_below_0_values(1) := is_set(slice2_best_index_0_0, 4);
    refinement_below_0_values(2) := is_set(slice2_best_index_0_0, 3);
    refinement_below_0_choice := choice((not is_set(slice2_best_index_0_0, 5)) and ((slice2_best_index_0_0 mod 8) = 0),
      refinement_below_0_differs and (refinement_below_0_values(1) or refinement_below_0_values(2)),
      refinement_below_0_differs);
    refinement_above_0_differs := slice2_best_above_0_0 /= 2047;
    refinement_above_0_choice := choice(is_set(slice2_best_index_0_0, 5) and ((slice2_best_index_0_0 mod 8) = 7),
      refinement_above_0_differs and (refinement_below_0_values(1) or (not refinement_below_0_values(2))),
      refinement_above_0_differs);
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
    refinement_tag_valid(0) <= slice2_best_tag.valid;
    refinement_tag_map_column(0) <= slice2_best_tag.map_column;
    refinement_tag_output_column(0) <= slice2_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= slice2_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= slice2_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_alone_0_0 <= slice2_best_second_0_0 = 2047;
    refinement_gap_0 <= (slice2_best_second_0_0 - slice2_best_late_cost_0_0) mod 2048;
    refinement_margin_0(1 to 9) <= refinement_margin_0(0 to 8);
    refinement_u_0 <= (refinement_below_0 - slice2_best_late_cost_0_0) mod 2048;
    refinement_v_0 <= (refinement_above_0 - slice2_best_late_cost_0_0) mod 2048;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((4096 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 2048) +
      ((other_4 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
    refinement_margin_0(0) <= choice((not refinement_alone_0_0) and (511 >= refinement_gap_0), (refinement_gap_0 / 8)
      mod 64, 63);
    refinement_below_0 <= choice(refinement_below_0_choice, slice2_best_below_0_0, slice2_best_above_0_0);
    refinement_above_0 <= choice((not refinement_above_0_choice) and (slice2_best_index_0_0 /= 0) and
      refinement_below_0_differs, slice2_best_below_0_0, slice2_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 12),
      refinement_remainder_1_0_difference mod 2048, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 12),
        refinement_remainder_0_difference(i) mod 2048, (refinement_remainder_0(i - 1) mod 1024) * 2);
    end loop;
    -- leftright
    leftright_holds_winners_choice := choice((not is_set(leftright_ring_read_address, 5)) and
      ((leftright_ring_read_address mod 8) = 0), (not leftright_holds_winners) and (is_set(leftright_ring_read_address,
      4) or is_set(leftright_ring_read_address, 3)), not leftright_holds_winners);
    leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
    leftright_checked_tag_row_start_differs := support_counter_group /= 377;
    leftright_checked_tag_row_start_is_equals(1) := support_counter_column = 441;
    leftright_checked_tag_row_start_choices(1) := choice(leftright_checked_tag_row_start_is_equals(1),
      (support_counter_group /= 376) and leftright_checked_tag.row_start, leftright_checked_tag.row_start);
    leftright_checked_tag_row_start_choices(2) := choice(leftright_checked_tag_row_start_differs,
      leftright_checked_tag_row_start_choices(1), leftright_checked_tag.row_start);
    leftright_checked_tag_row_start_is_equals(2) := support_counter_group = 374;
    leftright_checked_tag_row_start_alls(1) := leftright_checked_tag_row_start_is_equals(2) and
      leftright_checked_tag_row_start_is_equals(1);
    leftright_checked_tag_row_start_choices(3) := choice(leftright_checked_tag_row_start_choices(2), (not
      leftright_checked_tag.start_of_frame) or leftright_checked_tag_row_start_alls(1),
      leftright_checked_tag.start_of_frame and leftright_checked_tag_row_start_is_equals(2) and
      leftright_checked_tag_row_start_is_equals(1));
    leftright_checked_tag_row_start_alls(2) := leftright_checked_tag.map_column and leftright_checked_tag.valid;
    leftright_other_0(1) <= slice2other_winner_out_0;
    leftright_other_0(2 to 15) <= leftright_other_0(1 to 14);
    leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 64;
    leftright_held_position <= leftright_position;
    leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
    leftright_address_0 <= (leftright_held_position - to_integer(leftright_held_0(17 downto 4))) mod 64;
    leftright_asking_disparity_0 <= to_integer(leftright_held_0(9 downto 4));
    leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
    leftright_asking_passed_0 <= leftright_held_0(12) = '1';
    leftright_asking_margin_0 <= to_integer(leftright_held_1);
    leftright_asking_tag.valid <= leftright_held_valid;
    leftright_asking_tag.map_column <= leftright_held_0(0) = '1';
    leftright_asking_tag.start_of_frame <= leftright_held_0(2) = '1';
    leftright_asking_tag.end_of_line <= leftright_held_0(3) = '1';
    leftright_answered_disparity_0 <= leftright_asking_disparity_0;
    leftright_answered_fraction_0 <= leftright_asking_fraction_0;
    leftright_answered_passed_0 <= leftright_asking_passed_0;
    leftright_answered_margin_0 <= leftright_asking_margin_0;
    leftright_answered_tag <= leftright_asking_tag;
    leftright_checked_disparity_0 <= leftright_answered_disparity_0;
    leftright_checked_fraction_0 <= leftright_answered_fraction_0;
    leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
      (leftright_checked_passed_0_difference < 3);
    leftright_checked_margin_0 <= leftright_answered_margin_0;
    leftright_checked_tag.valid <= leftright_answered_tag.valid;
    leftright_checked_tag.map_column <= leftright_answered_tag.map_column;
    leftright_checked_tag.start_of_frame <= leftright_answered_tag.start_of_frame;
    leftright_checked_tag.end_of_line <= leftright_answered_tag.end_of_line;
    leftright_holds_winners <= choice(leftright_holds_winners_choice, (not refinement_tag_valid(11)) and
      leftright_holds_winners, refinement_tag_valid(11) or leftright_holds_winners);
    leftright_checked_tag.row_start <= choice(leftright_checked_tag_row_start_choices(3),
      leftright_checked_tag.row_start or leftright_checked_tag_row_start_alls(2), leftright_checked_tag.row_start and
      ((not leftright_checked_tag.map_column) or (not leftright_checked_tag.valid)));
    if refinement_tag_valid(11) then
      leftright_ring_write_address <= leftright_ring_read_address;
      leftright_ring_read_address <= choice(leftright_ring_read_address = 47, 0, (leftright_ring_read_address + 1) mod
        64);
    end if;
    -- support
    if leftright_checked_tag_row_start_alls(2) then
      support_counter_column <= choice(leftright_checked_tag.start_of_frame or
        leftright_checked_tag_row_start_is_equals(1), 0, (support_counter_column + 1) mod 512);
    end if;
    support_counter_group_choice := choice(leftright_checked_tag_row_start_alls(1), 375, 0);
    support_counter_group_choices(2) := choice((support_counter_group = 376) and leftright_checked_tag.row_start, 2,
      (support_counter_group + 1) mod 512);
    support_counter_group_choices(3) := choice(leftright_checked_tag_row_start_differs and
      leftright_checked_tag_row_start_is_equals(1) and leftright_checked_tag.map_column and
      leftright_checked_tag.valid, support_counter_group_choices(2), support_counter_group);
    support_column_choice(0) := choice(support_ready_arrives and support_ready_above2, 127, 63);
    support_column_choice(1) := choice(support_ready_above1 and support_ready_arrives, 127, 63);
    support_column_choice(2) := choice(support_ready_arrives, 127, 63);
    support_column_choice(3) := choice(support_ready_below2 and support_ready_arrives, 127, 63);
    support_column_choice(4) := choice(support_ready_below1 and support_ready_arrives, 127, 63);
    support_moment_0_start_of_frame_choice := choice(support_at_moves, support_at_arrives,
      support_moment_start_of_frame(0));
    support_next_tag_choices(1) := choice(support_row_tag(0), (not support_at_moves) and support_next_tag,
      support_at_moves or support_next_tag);
    support_next_tag_choices(2) := choice(support_at_moves, support_row_tag(0), support_next_tag);
    support_like_0_0_0_difference := 1 - (support_cells(6, 2) mod 64);
    support_like_0_value(0, 0) := ((support_cells(0, 0) mod 64) + support_like_0_0_0_difference) mod 128;
    support_like_0_0_choice(0) := choice(support_row_tag(6), support_next_tag and is_set(support_cells(0, 0), 6), (not
      support_next_tag) and is_set(support_cells(0, 0), 6));
    support_like_0_value(0, 1) := ((support_cells(0, 1) mod 64) + support_like_0_0_0_difference) mod 128;
    support_like_0_1_differs(0) := support_row_tag(6) /= (not support_next_tag);
    for i in 0 to 1 loop
      for j in 2 to 4 loop
        support_like_0_value(i, j) := ((support_cells(2 * i, j) mod 64) + support_like_0_0_0_difference) mod 128;
      end loop;
      support_like_0_value(i + 1, 0) := ((support_cells(2 * i + 2, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_0_choice(i + 1) := choice(support_row_tag(2 * i + 2), is_set(support_cells(2 * i + 2, 0), 6) and
        support_row_tag(6), is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6)));
      support_like_0_value(i + 1, 1) := ((support_cells(2 * i + 2, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
    end loop;
    for i in 2 to 4 loop
      support_like_0_value(2, i) := ((support_cells(4, i) mod 64) + support_like_0_0_0_difference) mod 128;
    end loop;
    support_like_0_value(3, 0) := ((support_cells(6, 0) mod 64) + support_like_0_0_0_difference) mod 128;
    support_like_0_value(3, 1) := ((support_cells(6, 1) mod 64) + support_like_0_0_0_difference) mod 128;
    for i in 3 to 5 loop
      for j in 2 to 4 loop
        support_like_0_value(i, j) := (support_like_0_0_0_difference + (support_cells(2 * i, j) mod 64)) mod 128;
      end loop;
      support_like_0_value(i + 1, 0) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 0) mod 64)) mod 128;
      support_like_0_0_choice(i + 1) := choice(support_row_tag(2 * i + 2), is_set(support_cells(2 * i + 2, 0), 6) and
        support_row_tag(6), is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6)));
      support_like_0_value(i + 1, 1) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 1) mod 64)) mod 128;
      support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
    end loop;
    for i in 2 to 4 loop
      support_like_0_value(6, i) := (support_like_0_0_0_difference + (support_cells(12, i) mod 64)) mod 128;
    end loop;
    support_out_sure_0_choice := choice(support_sum_0 < 255, support_sum_0 mod 256, 255);
    support_out_tag_row_start_differs := fill_counter_group /= 376;
    support_out_tag_row_start_is_equals(1) := fill_counter_column = 441;
    support_out_tag_row_start_choices(1) := choice(support_out_tag_row_start_is_equals(1), (fill_counter_group /= 375)
      and support_out_tag.row_start, support_out_tag.row_start);
    support_out_tag_row_start_choices(2) := choice(support_out_tag_row_start_differs,
      support_out_tag_row_start_choices(1), support_out_tag.row_start);
    support_out_tag_row_start_is_equals(2) := fill_counter_group = 374;
    support_out_tag_row_start_alls(1) := support_out_tag_row_start_is_equals(2) and
      support_out_tag_row_start_is_equals(1);
    support_out_tag_row_start_choices(3) := choice(support_out_tag_row_start_choices(2), (not
      support_out_tag.start_of_frame) or support_out_tag_row_start_alls(1), support_out_tag.start_of_frame and
      support_out_tag_row_start_is_equals(2) and support_out_tag_row_start_is_equals(1));
    support_out_tag_row_start_alls(2) := support_out_tag.map_column and support_out_tag.valid;
    support_newest_0 <= (((((((leftright_checked_disparity_0 + 4095) mod 64) * 2) + (leftright_checked_fraction_0 / 8)
      + 2) mod 128) * 8) / 16) + (as_number(leftright_checked_passed_0) * 64);
    support_newest_rest_0 <= ((((leftright_checked_fraction_0 / 8) + 2) mod 2) * 8) + (leftright_checked_fraction_0 mod
      8) + (leftright_checked_margin_0 * 16);
    support_moves <= leftright_checked_tag.valid;
    support_arrives <= leftright_checked_tag_row_start_alls(2);
    support_last <= leftright_checked_tag.end_of_line and leftright_checked_tag.map_column and
      leftright_checked_tag.valid;
    support_rows_read_newest_0 <= support_newest_0;
    support_rows_ready_words_0 <= to_integer(support_rows_read_words_0);
    support_rows_ready_newest_0 <= support_rows_read_newest_0;
    support_rest_rows_read_newest_0 <= support_newest_rest_0;
    support_rest_rows_ready_words_0 <= to_integer(support_rest_rows_read_words_0);
    support_rest_rows_ready_newest_0 <= support_rest_rows_read_newest_0;
    support_read_column <= support_counter_column;
    support_read_moves <= support_moves;
    support_read_arrives <= support_arrives;
    support_read_above2 <= 3 < support_counter_group;
    support_read_above1 <= 2 < support_counter_group;
    support_read_below1 <= support_counter_group < 375;
    support_read_below2 <= support_counter_group < 376;
    support_read_first <= (support_counter_column = 0) and (support_counter_group = 2);
    support_read_last <= support_last;
    support_ready_column <= support_read_column;
    support_ready_moves <= support_read_moves;
    support_ready_arrives <= support_read_arrives;
    support_ready_above2 <= support_read_above2;
    support_ready_above1 <= support_read_above1;
    support_ready_below1 <= support_read_below1;
    support_ready_below2 <= support_read_below2;
    support_ready_first <= support_read_first;
    support_ready_last <= support_read_last;
    support_column(0) <= to_integer(((to_unsigned(support_column_choice(0), 7)) and
      (to_unsigned((support_rows_ready_words_0 mod 128), 7))));
    support_column(1) <= to_integer(((to_unsigned(support_column_choice(1), 7)) and
      (to_unsigned(((support_rows_ready_words_0 / 128) mod 128), 7))));
    support_column(2) <= to_integer(((to_unsigned(support_column_choice(2), 7)) and
      (to_unsigned(((support_rows_ready_words_0 / 16384) mod 128), 7))));
    support_column(3) <= to_integer(((to_unsigned(support_column_choice(3), 7)) and
      (to_unsigned((support_rows_ready_words_0 / 2097152), 7))));
    support_column(4) <= to_integer(((to_unsigned(support_rows_ready_newest_0, 7)) and
      (to_unsigned(support_column_choice(4), 7))));
    support_column_rest_0 <= support_rest_rows_ready_words_0 mod 1024;
    support_at_moves <= support_ready_moves;
    support_at_arrives <= support_ready_arrives;
    support_at_first <= support_ready_first;
    support_at_last <= support_ready_last;
    support_moved <= support_at_moves;
    for i in 0 to 2 loop
      support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_cells(2 * i, 0) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
        support_like_0_0_choice(i);
      for j in 1 to 4 loop
        support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_cells(2 * i, j) +
          support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
          is_set(support_cells(2 * i, j), 6) and support_like_0_1_differs(i);
      end loop;
    end loop;
    support_like_0(3, 0) <= ((not is_set(support_like_0_value(3, 0), 1)) or (not (((support_cells(6, 0) +
      support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 0) / 4) = 0) and
      is_set(support_cells(6, 0), 6);
    support_like_0(3, 1) <= ((not is_set(support_like_0_value(3, 1), 1)) or (not (((support_cells(6, 1) +
      support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 1) / 4) = 0) and
      is_set(support_cells(6, 1), 6);
    for i in 2 to 4 loop
      support_like_0(3, i) <= ((not is_set(support_like_0_value(3, i), 1)) or (not (((support_like_0_0_0_difference +
        support_cells(6, i)) mod 2) = 1))) and ((support_like_0_value(3, i) / 4) = 0) and is_set(support_cells(6, i),
        6);
    end loop;
    for i in 4 to 6 loop
      support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_like_0_0_0_difference +
        support_cells(2 * i, 0)) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
        support_like_0_0_choice(i);
      for j in 1 to 4 loop
        support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(2 * i, j)) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and is_set(support_cells(2
          * i, j), 6) and support_like_0_1_differs(i);
      end loop;
    end loop;
    for i in 0 to 6 loop
      support_partial_0(i) <= as_number(support_like_0(i, 3)) + as_number(support_like_0(i, 0)) +
        as_number(support_like_0(i, 1)) + as_number(support_like_0(i, 4)) + as_number(support_like_0(i, 2));
    end loop;
    support_count_0 <= support_partial_0(6) + support_partial_0(4) + support_partial_0(3) + support_partial_0(1) +
      support_partial_0(5) + support_partial_0(0) + support_partial_0(2);
    support_sum_0 <= (((support_centre_rest_0(2) / 32) + ((support_count_0 + (support_count_0 / 2)) * 2) +
      (support_count_0 mod 2)) * 2) + ((support_centre_rest_0(2) / 16) mod 2);
    support_centre_0(0) <= support_cells(6, 2);
    support_centre_0(1 to 2) <= support_centre_0(0 to 1);
    support_centre_rest_0(0) <= support_rest_0(6);
    support_centre_rest_0(1 to 2) <= support_centre_rest_0(0 to 1);
    support_centre_moment_map_column(0) <= support_moment_map_column(6);
    support_centre_moment_start_of_frame(0) <= support_moment_start_of_frame(6);
    support_centre_moment_last(0) <= support_moment_last(6);
    for i in 1 to 3 loop
      support_centre_moment_map_column(i) <= support_centre_moment_map_column(i - 1);
      support_centre_moment_start_of_frame(i) <= support_centre_moment_start_of_frame(i - 1);
      support_centre_moment_last(i) <= support_centre_moment_last(i - 1);
    end loop;
    support_centre_moved(0) <= support_moved;
    support_centre_moved(1 to 3) <= support_centre_moved(0 to 2);
    support_out_disparity_0 <= ((((other_3 * 2) + (other_2 / 8) + 127) mod 128) * 8) + (other_2 mod 8);
    support_out_passed_0 <= support_enough_0;
    support_out_tag.valid <= support_centre_moved(3);
    support_out_tag.map_column <= support_centre_moment_map_column(3);
    support_out_tag.start_of_frame <= support_centre_moment_start_of_frame(3);
    support_out_tag.end_of_line <= support_centre_moment_last(3);
    support_counter_group <= choice(leftright_checked_tag.start_of_frame and leftright_checked_tag.map_column and
      leftright_checked_tag.valid, support_counter_group_choice, support_counter_group_choices(3));
    support_row_tag(0) <= choice(support_row_tag(0), (not support_at_arrives) or support_moment_map_column(0) or (not
      support_at_moves), support_at_arrives and (not support_moment_map_column(0)) and support_at_moves);
    support_moment_start_of_frame(0) <= choice(support_at_first, support_moment_0_start_of_frame_choice,
      support_moment_start_of_frame(0) and (not support_at_moves));
    support_next_tag <= choice(support_at_arrives and (not support_moment_map_column(0)), support_next_tag_choices(1),
      support_next_tag_choices(2));
    support_enough_0 <= choice((not is_set(support_count_0, 4)) and ((not is_set(support_count_0, 3)) or
      (((support_count_0 / 2) mod 4) = 0)), is_set(support_centre_0(2), 6) and is_set(support_count_0, 5),
      is_set(support_centre_0(2), 6));
    support_out_sure_0 <= choice(support_enough_0, support_out_sure_0_choice, 0);
    support_out_tag.row_start <= choice(support_out_tag_row_start_choices(3), support_out_tag.row_start or
      support_out_tag_row_start_alls(2), support_out_tag.row_start and ((not support_out_tag.map_column) or (not
      support_out_tag.valid)));
    if support_ready_arrives then
      support_rows_write_words_0 <= (support_rows_ready_words_0 / 128) + (support_rows_ready_newest_0 * 2097152);
      support_rest_rows_write_words_0 <= (support_rest_rows_ready_words_0 / 1024) + (support_rest_rows_ready_newest_0 *
        1024);
      support_write_column <= support_ready_column;
    end if;
    if support_at_moves then
      for i in 0 to 4 loop support_cells(0, i) <= support_column(i); end loop;
      for i in 0 to 5 loop
        for j in 0 to 4 loop support_cells(2 * i + 1, j) <= support_cells(2 * i, j); end loop;
        for j in 0 to 4 loop support_cells(2 * i + 2, j) <= support_cells(2 * i + 1, j); end loop;
      end loop;
      support_row_tag(1) <= support_next_tag;
      support_row_tag(2 to 12) <= support_row_tag(1 to 11);
      support_rest_0(0) <= support_column_rest_0;
      support_rest_0(1 to 6) <= support_rest_0(0 to 5);
      support_moment_map_column(0) <= support_at_arrives;
      support_moment_last(0) <= support_at_last;
      for i in 1 to 6 loop
        support_moment_map_column(i) <= support_moment_map_column(i - 1);
        support_moment_start_of_frame(i) <= support_moment_start_of_frame(i - 1);
        support_moment_last(i) <= support_moment_last(i - 1);
      end loop;
    end if;
    -- fill
    if support_out_tag_row_start_alls(2) then
      fill_counter_column <= choice(support_out_tag.start_of_frame or support_out_tag_row_start_is_equals(1), 0,
        (fill_counter_column + 1) mod 512);
    end if;
    fill_counter_group_choice := choice(support_out_tag_row_start_alls(1), 375, 0);
    fill_counter_group_choices(2) := choice((fill_counter_group = 375) and support_out_tag.row_start, 1,
      (fill_counter_group + 1) mod 512);
    fill_counter_group_choices(3) := choice(support_out_tag_row_start_differs and
      support_out_tag_row_start_is_equals(1) and support_out_tag.map_column and support_out_tag.valid,
      fill_counter_group_choices(2), fill_counter_group);
    fill_ends_read_place_0_is_equal := fill_ready_column = 0;
    fill_ends_read_place_0_choice := choice(other_0, fill_at_arrives and (not fill_pixel_0_passed), fill_at_arrives and
      (not fill_pixel_0_passed) and (not fill_in_hole_0));
    fill_ends_read_place_0_choices(2) := choice(fill_ends_read_place_0 = 224, 0, (fill_ends_read_place_0 + 1) mod 256);
    fill_ends_read_place_0_choices(3) := choice(fill_ends_read_place_0_choice, fill_ends_read_place_0_choices(2),
      fill_ends_read_place_0);
    fill_takes_left_0_choice := choice((fill_step_0 - fill_width_0) < 0, ((fill_width_0 - fill_step_0) mod 512) / 2, 0);
    fill_takes_left_0_choice_2 := choice(fill_rises_0, fill_takes_left_0_choice * 2, fill_width_0);
    fill_out_disparity_0_alls(1) := (not fill_chosen_0_passed) and ((not fill_chosen_at_top) or
      fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left);
    fill_out_disparity_0_alls(2) := (not fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left);
    fill_out_disparity_0_choice := choice(fill_takes_left_0, fill_chosen_beside_0_left, fill_chosen_beside_0_right);
    fill_out_disparity_0_choice_2 := choice(fill_out_disparity_0_alls(2), fill_above_0 mod 32768,
      fill_out_disparity_0_choice);
    fill_out_filled_0_is_equal := fill_chosen_at_column = 0;
    fill_out_filled_0_choice := choice(fill_out_filled_0_is_equal and fill_chosen_at_arrives, fill_has_values and (not
      fill_chosen_at_top), fill_had_values);
    fill_out_tag_row_start_differs := median_counter_group /= 376;
    fill_out_tag_row_start_is_equals(1) := median_counter_column = 441;
    fill_out_tag_row_start_choices(1) := choice(fill_out_tag_row_start_is_equals(1), (median_counter_group /= 375) and
      fill_out_tag.row_start, fill_out_tag.row_start);
    fill_out_tag_row_start_choices(2) := choice(fill_out_tag_row_start_differs, fill_out_tag_row_start_choices(1),
      fill_out_tag.row_start);
    fill_out_tag_row_start_is_equals(2) := median_counter_group = 374;
    fill_out_tag_row_start_alls(1) := fill_out_tag_row_start_is_equals(2) and fill_out_tag_row_start_is_equals(1);
    fill_out_tag_row_start_choices(3) := choice(fill_out_tag_row_start_choices(2), (not fill_out_tag.start_of_frame) or
      fill_out_tag_row_start_alls(1), fill_out_tag.start_of_frame and fill_out_tag_row_start_is_equals(2) and
      fill_out_tag_row_start_is_equals(1));
    fill_out_tag_row_start_alls(2) := fill_out_tag.map_column and fill_out_tag.valid;
    fill_newest_disparity_0 <= support_out_disparity_0;
    fill_newest_passed_0 <= support_out_passed_0;
    fill_newest_sure_0 <= support_out_sure_0;
    fill_moves <= support_out_tag.valid;
    fill_arrives <= support_out_tag_row_start_alls(2);
    fill_last <= support_out_tag.end_of_line and support_out_tag.map_column and support_out_tag.valid;
    fill_rows_read_newest_0 <= (fill_newest_sure_0 * 2048) + (fill_newest_disparity_0 * 2) +
      as_number(fill_newest_passed_0);
    fill_rows_ready_words_0 <= to_integer(fill_rows_read_words_0);
    fill_rows_ready_newest_0 <= fill_rows_read_newest_0;
    fill_read_column <= fill_counter_column;
    fill_read_moves <= fill_moves;
    fill_read_arrives <= fill_arrives;
    fill_read_top <= fill_counter_group = 1;
    fill_read_last <= fill_last;
    fill_ready_column <= fill_read_column;
    fill_ready_moves <= fill_read_moves;
    fill_ready_arrives <= fill_read_arrives;
    fill_ready_top <= fill_read_top;
    fill_ready_last <= fill_read_last;
    fill_write_column <= fill_ready_column;
    fill_ends_write_words_0 <= (fill_counter_column * 1024) + fill_newest_disparity_0 +
      (as_number(fill_newest_passed_0) * 524288);
    fill_ends_write_place_0 <= fill_ends_next_place_0;
    fill_ends_ready_words_0 <= to_integer(fill_ends_read_words_0);
    fill_pixel_0_disparity <= (fill_rows_ready_words_0 mod 2048) / 2;
    fill_pixel_0_passed <= is_set(fill_rows_ready_words_0, 0);
    fill_pixel_0_sure <= fill_rows_ready_words_0 / 2048;
    fill_at_moves <= fill_ready_moves;
    fill_at_arrives <= fill_ready_arrives;
    fill_at_top <= fill_ready_top;
    fill_at_last <= fill_ready_last;
    fill_asking_0_disparity(0) <= fill_pixel_0_disparity;
    fill_asking_0_passed(0) <= fill_pixel_0_passed;
    fill_asking_0_sure(0) <= fill_pixel_0_sure;
    fill_asking_0_disparity(1) <= fill_asking_0_disparity(0);
    fill_asking_0_passed(1) <= fill_asking_0_passed(0);
    fill_asking_0_sure(1) <= fill_asking_0_sure(0);
    fill_asking_at_column(0) <= fill_write_column;
    fill_asking_at_moves(0) <= fill_at_moves;
    fill_asking_at_arrives(0) <= fill_at_arrives;
    fill_asking_at_top(0) <= fill_at_top;
    fill_asking_at_last(0) <= fill_at_last;
    fill_asking_at_column(1) <= fill_asking_at_column(0);
    fill_asking_at_moves(1) <= fill_asking_at_moves(0);
    fill_asking_at_arrives(1) <= fill_asking_at_arrives(0);
    fill_asking_at_top(1) <= fill_asking_at_top(0);
    fill_asking_at_last(1) <= fill_asking_at_last(0);
    fill_hole_starts_0(0) <= fill_ends_read_place_0_choice;
    fill_hole_starts_0(1) <= fill_hole_starts_0(0);
    fill_known_0_disparity <= fill_asking_0_disparity(1);
    fill_known_0_passed <= fill_asking_0_passed(1);
    fill_known_0_sure <= fill_asking_0_sure(1);
    fill_known_at_column <= fill_asking_at_column(1);
    fill_known_at_moves <= fill_asking_at_moves(1);
    fill_known_at_arrives <= fill_asking_at_arrives(1);
    fill_known_at_top <= fill_asking_at_top(1);
    fill_known_at_last <= fill_asking_at_last(1);
    fill_measured_0_disparity <= fill_known_0_disparity;
    fill_measured_0_passed <= fill_known_0_passed;
    fill_measured_0_sure <= fill_known_0_sure;
    fill_measured_at_column <= fill_known_at_column;
    fill_measured_at_moves <= fill_known_at_moves;
    fill_measured_at_arrives <= fill_known_at_arrives;
    fill_measured_at_top <= fill_known_at_top;
    fill_measured_at_last <= fill_known_at_last;
    fill_measured_beside_0_left <= fill_beside_0_left;
    fill_measured_beside_0_right <= fill_beside_0_right;
    fill_measured_beside_0_has_left <= fill_beside_0_has_left;
    fill_measured_beside_0_has_right <= fill_beside_0_has_right;
    fill_measured_beside_0_right_column <= fill_beside_0_right_column;
    fill_width_0 <= (fill_beside_0_right_column + (65535 - fill_beside_0_left_column)) mod 512;
    fill_step_0 <= ((fill_beside_0_right - fill_beside_0_left) mod 2048) / 16;
    fill_rises_0 <= (fill_beside_0_right - fill_beside_0_left) >= 0;
    fill_chosen_0_disparity <= fill_measured_0_disparity;
    fill_chosen_0_passed <= fill_measured_0_passed;
    fill_chosen_0_sure <= fill_measured_0_sure;
    fill_chosen_at_column <= fill_measured_at_column;
    fill_chosen_at_moves <= fill_measured_at_moves;
    fill_chosen_at_arrives <= fill_measured_at_arrives;
    fill_chosen_at_top <= fill_measured_at_top;
    fill_chosen_at_last <= fill_measured_at_last;
    fill_chosen_beside_0_left <= fill_measured_beside_0_left;
    fill_chosen_beside_0_right <= fill_measured_beside_0_right;
    fill_chosen_beside_0_has_left <= fill_measured_beside_0_has_left;
    fill_chosen_beside_0_has_right <= fill_measured_beside_0_has_right;
    fill_takes_left_0 <= fill_measured_beside_0_has_left and ((((fill_measured_at_column + (fill_takes_left_0_choice_2
      / 2)) - fill_measured_beside_0_right_column) < 0) or (not fill_measured_beside_0_has_right));
    fill_above_0 <= to_integer(fill_above_read_0);
    fill_out_passed_0 <= fill_chosen_0_passed;
    fill_out_sure_0 <= fill_chosen_0_sure;
    fill_out_tag.valid <= fill_chosen_at_moves;
    fill_out_tag.map_column <= fill_chosen_at_arrives;
    fill_out_tag.start_of_frame <= fill_out_filled_0_is_equal and fill_chosen_at_arrives and fill_chosen_at_top;
    fill_out_tag.end_of_line <= fill_chosen_at_last;
    fill_counter_group <= choice(support_out_tag.start_of_frame and support_out_tag.map_column and
      support_out_tag.valid, fill_counter_group_choice, fill_counter_group_choices(3));
    fill_ends_open_0 <= choice(fill_newest_passed_0, fill_ends_open_0 and (not fill_arrives), fill_ends_open_0 or
      fill_arrives);
    fill_ends_read_place_0 <= choice(fill_ends_read_place_0_is_equal and fill_ready_arrives,
      fill_ends_row_above_place_0, fill_ends_read_place_0_choices(3));
    fill_beside_0_has_left <= choice(fill_beside_0_has_left, (fill_asking_at_column(1) /= 0) or fill_asking_0_passed(1)
      or (not fill_asking_at_arrives(1)), fill_asking_0_passed(1) and fill_asking_at_arrives(1));
    fill_out_disparity_0 <= choice(fill_out_disparity_0_alls(1), fill_out_disparity_0_choice_2,
      fill_chosen_0_disparity);
    fill_out_filled_0 <= choice(fill_out_filled_0_choice, not fill_chosen_0_passed, (not fill_chosen_0_passed) and
      (fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left));
    fill_out_tag.row_start <= choice(fill_out_tag_row_start_choices(3), fill_out_tag.row_start or
      fill_out_tag_row_start_alls(2), fill_out_tag.row_start and ((not fill_out_tag.map_column) or (not
      fill_out_tag.valid)));
    fill_has_values <= choice((not fill_out_filled_0_choice) and (not fill_chosen_0_passed) and (not
      fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left), fill_has_values and (not
      fill_chosen_at_arrives), fill_has_values or fill_chosen_at_arrives);
    if fill_ready_arrives then
      fill_rows_write_words_0 <= fill_rows_ready_newest_0;
      fill_at_column <= fill_ready_column;
    end if;
    fill_ends_next_place_0_choices(1) := choice(fill_last, fill_arrives, fill_newest_passed_0 and fill_arrives);
    fill_ends_next_place_0_choices(2) := choice(fill_ends_open_0 and ((not fill_arrives) or (fill_counter_column /=
      0)), fill_ends_next_place_0_choices(1), fill_last and (not fill_newest_passed_0) and fill_arrives);
    if fill_ends_next_place_0_choices(2) then
      fill_ends_next_place_0 <= choice(fill_ends_next_place_0 = 224, 0, (fill_ends_next_place_0 + 1) mod 256);
    end if;
    fill_ends_row_place_0_all := fill_arrives and (fill_counter_column = 0);
    if fill_ends_row_place_0_all then
      fill_ends_row_place_0 <= fill_ends_next_place_0;
      fill_ends_row_above_place_0 <= fill_ends_row_place_0;
    end if;
    if fill_at_arrives then fill_in_hole_0 <= not fill_pixel_0_passed; end if;
    fill_beside_0_left_any := (not fill_asking_0_passed(1)) or (not fill_asking_at_arrives(1));
    if not fill_beside_0_left_any then
      fill_beside_0_left <= fill_asking_0_disparity(1);
      fill_beside_0_left_column <= fill_asking_at_column(1);
    end if;
    if fill_hole_starts_0(1) then
      fill_beside_0_right <= fill_ends_ready_words_0 mod 1024;
      fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 19);
      fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 512;
    end if;
    fill_write_above_0_choice := choice(fill_out_disparity_0_alls(2), fill_above_0, fill_out_disparity_0_choice);
    if fill_chosen_at_arrives then
      fill_had_values <= fill_out_filled_0_choice;
      fill_write_above_column <= fill_chosen_at_column;
      fill_write_above_0 <= choice(fill_out_disparity_0_alls(1), fill_write_above_0_choice, fill_chosen_0_disparity);
    end if;
    -- median
    if fill_out_tag_row_start_alls(2) then
      median_counter_column <= choice(fill_out_tag.start_of_frame or fill_out_tag_row_start_is_equals(1), 0,
        (median_counter_column + 1) mod 512);
    end if;
    median_counter_group_choice := choice(fill_out_tag_row_start_alls(1), 375, 0);
    median_counter_group_is_equal := median_counter_group = 375;
    median_counter_group_choices(2) := choice(median_counter_group_is_equal and fill_out_tag.row_start, 1,
      (median_counter_group + 1) mod 512);
    median_counter_group_choices(3) := choice(fill_out_tag_row_start_differs and fill_out_tag_row_start_is_equals(1)
      and fill_out_tag.map_column and fill_out_tag.valid, median_counter_group_choices(2), median_counter_group);
    median_line_ended_choice := choice(fill_out_tag.valid, fill_out_tag.map_column, median_line_ended);
    median_of_column_0_a_choice := choice(median_at_top, median_column_1 / 2, other_1 / 2);
    median_of_column_0_c_choice := choice(median_counter_next_frame, median_column_1 / 2, median_column_2 / 2);
    median_sorted_low_0_choices(1) := choice(median_of_column_0_c_below_b, median_of_column_0_c, median_of_column_0_b);
    median_sorted_low_0_choices(2) := choice(median_of_column_0_c_below_a, median_of_column_0_c, median_of_column_0_a);
    median_sorted_middle_0_choices(1) := choice(median_of_column_0_c_below_b, median_of_column_0_b,
      median_sorted_low_0_choices(2));
    median_sorted_middle_0_choices(2) := choice(median_of_column_0_c_below_a, median_of_column_0_a,
      median_sorted_low_0_choices(1));
    median_sorted_high_0_choices(1) := choice(median_of_column_0_c_below_a, median_of_column_0_a, median_of_column_0_c);
    median_sorted_high_0_choices(2) := choice(median_of_column_0_c_below_b, median_of_column_0_b, median_of_column_0_c);
    median_window_complete_is_equal := median_sorted_column = 0;
    median_window_complete_choice := choice(median_window_complete_is_equal, median_sorted_behind,
      median_sorted_arrives or median_sorted_behind);
    median_largest_low_0_choices(1) := choice(median_of_low_0_c_below_a, median_of_low_0_a, median_of_low_0_c);
    median_largest_low_0_choices(2) := choice(median_of_low_0_c_below_b, median_of_low_0_b, median_of_low_0_c);
    median_median_middle_0_choices(1) := choice(median_of_middle_0_c_below_a, median_of_middle_0_c,
      median_of_middle_0_a);
    median_median_middle_0_choices(2) := choice(median_of_middle_0_c_below_b, median_of_middle_0_b,
      median_median_middle_0_choices(1));
    median_median_middle_0_choices(3) := choice(median_of_middle_0_c_below_b, median_of_middle_0_c,
      median_of_middle_0_b);
    median_median_middle_0_choices(4) := choice(median_of_middle_0_c_below_a, median_of_middle_0_a,
      median_median_middle_0_choices(3));
    median_smallest_high_0_choices(1) := choice(median_of_high_0_c_below_b, median_of_high_0_c, median_of_high_0_b);
    median_smallest_high_0_choices(2) := choice(median_of_high_0_c_below_a, median_of_high_0_c, median_of_high_0_a);
    median_out_disparity_0_choices(1) := choice(median_of_all_0_c_below_a, median_of_all_0_c, median_of_all_0_a);
    median_out_disparity_0_choices(2) := choice(median_of_all_0_c_below_b, median_of_all_0_b,
      median_out_disparity_0_choices(1));
    median_out_disparity_0_choices(3) := choice(median_of_all_0_c_below_b, median_of_all_0_c, median_of_all_0_b);
    median_out_disparity_0_choices(4) := choice(median_of_all_0_c_below_a, median_of_all_0_a,
      median_out_disparity_0_choices(3));
    median_counter_next_frame <= slice0_best_place_0;
    median_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
    median_arrives <= fill_out_tag_row_start_alls(2);
    median_behind <= median_line_ended and fill_out_tag.valid;
    median_rows_read_newest_0 <= median_newest_0;
    median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
    median_rows_ready_newest_0 <= median_rows_read_newest_0;
    median_read_column <= median_counter_column;
    median_read_arrives <= median_arrives;
    median_read_behind <= median_behind;
    median_read_top <= median_counter_group = 1;
    median_read_bottom <= median_counter_group_is_equal;
    median_read_output <= (median_counter_group >= 1) and (median_counter_group < 376);
    median_ready_column <= median_read_column;
    median_ready_arrives <= median_read_arrives;
    median_ready_behind <= median_read_behind;
    median_ready_top <= median_read_top;
    median_ready_output <= median_read_output;
    median_write_column <= median_ready_column;
    median_column_1 <= median_rows_ready_words_0 / 8192;
    median_column_2 <= median_rows_ready_newest_0;
    median_at_arrives <= median_ready_arrives;
    median_at_behind <= median_ready_behind;
    median_at_top <= median_ready_top;
    median_at_output <= median_ready_output;
    median_of_column_0_a <= median_of_column_0_a_choice;
    median_of_column_0_b <= median_column_1 / 2;
    median_of_column_0_c <= median_of_column_0_c_choice;
    median_of_column_0_b_below_a <= ((median_column_1 / 2) - median_of_column_0_a_choice) < 0;
    median_of_column_0_c_below_a <= (median_of_column_0_c_choice - median_of_column_0_a_choice) < 0;
    median_of_column_0_c_below_b <= (median_of_column_0_c_choice - (median_column_1 / 2)) < 0;
    median_column_passed_0(0) <= is_set(median_column_1, 0);
    median_column_passed_0(1) <= median_column_passed_0(0);
    median_comparing_column <= median_write_column;
    median_comparing_arrives <= median_at_arrives;
    median_comparing_behind <= median_at_behind;
    median_comparing_top <= median_at_top;
    median_comparing_output <= median_at_output;
    median_sorted_column <= median_comparing_column;
    median_sorted_arrives <= median_comparing_arrives;
    median_sorted_behind <= median_comparing_behind;
    median_sorted_top <= median_comparing_top;
    median_sorted_output <= median_comparing_output;
    median_window_complete <= median_sorted_output and median_window_complete_choice;
    median_window_first <= median_sorted_top and (median_sorted_column = 1) and median_sorted_arrives;
    median_window_last <= median_sorted_behind;
    median_of_low_0_a <= median_low_0(0);
    median_of_low_0_b <= median_low_0(1);
    median_of_low_0_c <= median_low_0(2);
    median_of_low_0_b_below_a <= (median_low_0(1) - median_low_0(0)) < 0;
    median_of_low_0_c_below_a <= (median_low_0(2) - median_low_0(0)) < 0;
    median_of_low_0_c_below_b <= (median_low_0(2) - median_low_0(1)) < 0;
    median_of_middle_0_a <= median_middle_0(0);
    median_of_middle_0_b <= median_middle_0(1);
    median_of_middle_0_c <= median_middle_0(2);
    median_of_middle_0_b_below_a <= (median_middle_0(1) - median_middle_0(0)) < 0;
    median_of_middle_0_c_below_a <= (median_middle_0(2) - median_middle_0(0)) < 0;
    median_of_middle_0_c_below_b <= (median_middle_0(2) - median_middle_0(1)) < 0;
    median_of_high_0_a <= median_high_0(0);
    median_of_high_0_b <= median_high_0(1);
    median_of_high_0_c <= median_high_0(2);
    median_of_high_0_b_below_a <= (median_high_0(1) - median_high_0(0)) < 0;
    median_of_high_0_c_below_a <= (median_high_0(2) - median_high_0(0)) < 0;
    median_of_high_0_c_below_b <= (median_high_0(2) - median_high_0(1)) < 0;
    median_of_all_0_a <= median_largest_low_0;
    median_of_all_0_b <= median_median_middle_0;
    median_of_all_0_c <= median_smallest_high_0;
    median_of_all_0_b_below_a <= (median_median_middle_0 - median_largest_low_0) < 0;
    median_of_all_0_c_below_a <= (median_smallest_high_0 - median_largest_low_0) < 0;
    median_of_all_0_c_below_b <= (median_smallest_high_0 - median_median_middle_0) < 0;
    median_waiting_complete(0) <= median_window_complete;
    median_waiting_first(0) <= median_window_first;
    median_waiting_last(0) <= median_window_last;
    median_waiting_complete(1) <= median_waiting_complete(0);
    median_waiting_first(1) <= median_waiting_first(0);
    median_waiting_last(1) <= median_waiting_last(0);
    median_waiting_complete(2) <= median_waiting_complete(1);
    median_waiting_first(2) <= median_waiting_first(1);
    median_waiting_last(2) <= median_waiting_last(1);
    median_waiting_passed_0(0) <= median_passed_0(1);
    median_waiting_passed_0(1 to 2) <= median_waiting_passed_0(0 to 1);
    median_beside_newest_0 <= (fill_out_sure_0 * 2) + as_number(fill_out_filled_0);
    median_beside_rows_read_newest_0 <= median_beside_newest_0;
    median_beside_rows_ready_words_0 <= to_integer(median_beside_rows_read_words_0);
    median_beside_rows_ready_newest_0 <= median_beside_rows_read_newest_0;
    median_beside_column_0 <= median_beside_rows_ready_words_0;
    median_beside_of_column_0(0) <= median_beside_column_0;
    median_beside_of_column_0(1) <= median_beside_of_column_0(0);
    median_beside_waiting_0(0) <= median_beside_in_window_0(1);
    median_beside_waiting_0(1 to 2) <= median_beside_waiting_0(0 to 1);
    median_out_passed_0 <= median_waiting_passed_0(2);
    median_out_confidence_0 <= median_beside_waiting_0(2) / 2;
    median_out_filled_0 <= is_set(median_beside_waiting_0(2), 0);
    median_out_valid <= median_waiting_complete(2);
    median_out_start_of_frame <= median_waiting_first(2) and median_waiting_complete(2);
    median_out_end_of_line <= median_waiting_last(2) and median_waiting_complete(2);
    median_counter_group <= choice(fill_out_tag.start_of_frame and fill_out_tag.map_column and fill_out_tag.valid,
      median_counter_group_choice, median_counter_group_choices(3));
    median_line_ended <= choice(fill_out_tag.end_of_line, median_line_ended_choice, median_line_ended and (not
      fill_out_tag.valid));
    median_sorted_low_0 <= choice(median_of_column_0_b_below_a, median_sorted_low_0_choices(1),
      median_sorted_low_0_choices(2));
    median_sorted_middle_0 <= choice(median_of_column_0_b_below_a, median_sorted_middle_0_choices(1),
      median_sorted_middle_0_choices(2));
    median_sorted_high_0 <= choice(median_of_column_0_b_below_a, median_sorted_high_0_choices(1),
      median_sorted_high_0_choices(2));
    median_passed_0(1) <= choice(median_passed_0(0), median_passed_0(1) or median_sorted_arrives or
      median_sorted_behind, median_passed_0(1) and (not median_sorted_arrives) and (not median_sorted_behind));
    median_largest_low_0 <= choice(median_of_low_0_b_below_a, median_largest_low_0_choices(1),
      median_largest_low_0_choices(2));
    median_median_middle_0 <= choice(median_of_middle_0_b_below_a, median_median_middle_0_choices(2),
      median_median_middle_0_choices(4));
    median_smallest_high_0 <= choice(median_of_high_0_b_below_a, median_smallest_high_0_choices(1),
      median_smallest_high_0_choices(2));
    median_out_disparity_0 <= choice(median_of_all_0_b_below_a, median_out_disparity_0_choices(2),
      median_out_disparity_0_choices(4));
    if median_ready_arrives then
      median_rows_write_words_0 <= (median_rows_ready_words_0 / 8192) + (median_rows_ready_newest_0 * 8192);
      median_at_column <= median_ready_column;
      median_beside_rows_write_words_0 <= median_beside_rows_ready_newest_0;
    end if;
    median_low_0_0_choice := choice(median_sorted_behind, median_low_0(0), median_sorted_low_0);
    median_low_0_all(1) := median_window_complete_is_equal and median_sorted_arrives;
    median_middle_0_0_choice := choice(median_sorted_behind, median_middle_0(0), median_sorted_middle_0);
    median_high_0_0_choice := choice(median_sorted_behind, median_high_0(0), median_sorted_high_0);
    median_low_0_all(0) := (not median_sorted_arrives) and (not median_sorted_behind);
    if not median_low_0_all(0) then
      median_low_0(0) <= median_low_0_0_choice;
      median_low_0(2) <= median_low_0(1);
      median_middle_0(0) <= median_middle_0_0_choice;
      median_middle_0(2) <= median_middle_0(1);
      median_high_0(0) <= median_high_0_0_choice;
      median_high_0(2) <= median_high_0(1);
      median_beside_in_window_0(1) <= median_beside_in_window_0(0);
      median_low_0(1) <= choice(median_low_0_all(1), median_low_0_0_choice, median_low_0(0));
      median_middle_0(1) <= choice(median_low_0_all(1), median_middle_0_0_choice, median_middle_0(0));
      median_high_0(1) <= choice(median_low_0_all(1), median_high_0_0_choice, median_high_0(0));
    end if;
    if median_sorted_arrives then
      median_passed_0(0) <= median_column_passed_0(1);
      median_beside_in_window_0(0) <= median_beside_of_column_0(1);
    end if;
    -- other
    other_0 <= fill_ends_read_place_0_is_equal;
    other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
    other_2 <= support_centre_rest_0(2) mod 16;
    other_3 <= support_centre_0(2) mod 64;
    other_4 <= ((refinement_remainder_0_difference(7) / 4096) * 2) + ((other_5 / 4) * 4);
    other_5 <= ((refinement_remainder_0_difference(6) / 4096) * 4) + ((other_6 / 8) * 8);
    other_6 <= ((refinement_remainder_0_difference(5) / 4096) * 8) + ((other_7 / 16) * 16);
    other_7 <= ((refinement_remainder_0_difference(4) / 4096) * 16) + ((other_8 / 32) * 32);
    other_8 <= ((refinement_remainder_0_difference(3) / 4096) * 32) + ((other_9 / 64) * 64);
    other_9 <= ((refinement_remainder_0_difference(2) / 4096) * 64) + ((other_10 / 128) * 128);
    other_10 <= (refinement_remainder_1_0_difference / 4096) * 128;
    other(11 to 21) <= other(12 to 22);
    other(22) <= 4096;
    if reset = '1' then
      transform_left_0 <= 0; transform_right_0 <= 0; transform_valid <= false; transform_counter_column <= 0;
      transform_counter_group <= 377; transform_counter_next_frame <= false; transform_left_rows_read_newest_0 <= 0;
      transform_left_rows_ready_words_0 <= to_unsigned(0, 32); transform_left_rows_ready_newest_0 <= 0;
      transform_left_rows_write_words_0 <= to_unsigned(0, 32); transform_right_rows_read_newest_0 <= 0;
      transform_right_rows_ready_words_0 <= to_unsigned(0, 32); transform_right_rows_ready_newest_0 <= 0;
      transform_right_rows_write_words_0 <= to_unsigned(0, 32); transform_read_column <= 0;
      transform_read_row_inside <= (others => false); transform_read_column_inside <= (others => false);
      transform_read_start_of_frame <= false; transform_read_valid <= false; transform_ready_column <= 0;
      transform_ready_row_inside <= (others => false); transform_ready_column_inside <= (others => false);
      transform_ready_start_of_frame <= false; transform_ready_valid <= false; transform_write_column <= 0;
      transform_left_column <= (others => 0); transform_right_column <= (others => 0);
      transform_columns_row_inside <= (others => false); transform_columns_column_inside <= (others => false);
      transform_columns_start_of_frame <= false; transform_columns_valid <= false;
      transform_left_filter_column <= (others => (others => 0)); transform_left_filter_feature_0 <= 0;
      transform_right_filter_column <= (others => (others => 0)); transform_right_filter_feature_0 <= 0;
      transform_filtering_0_column_inside <= (others => false); transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_search_0 <= 0; raster_features_reference_0 <= 0;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 379; delay_ahead_0 <= 0;
      delay_delayed_0 <= 0; delay_column <= 0; delay_row_inside <= (others => false); delay_tag <= (others => false);
      rows_search_rows_read_newest_0 <= 0; rows_search_rows_ready_words <= (others => 0);
      rows_search_rows_ready_newest_0 <= 0; rows_search_rows_write_words <= (others => 0);
      rows_reference_rows_read_newest_0 <= 0; rows_reference_rows_ready_words <= (others => 0);
      rows_reference_rows_ready_newest_0 <= 0; rows_reference_rows_write_words <= (others => 0); rows_read_column <= 0;
      rows_read_inside <= (others => false); rows_read_tag <= (others => false); rows_ready_column <= 0;
      rows_ready_inside <= (others => false); rows_ready_tag <= (others => false); rows_write_column <= 0;
      rows_search <= (others => 0); rows_reference <= (others => 0); rows_tag <= (others => false);
      slice0shift_search <= (others => (others => 0)); slice0shift_reference <= (others => 0);
      slice0shift_search_out <= (others => 0); slice0shift_tag <= (others => false);
      slice0cost_pixels_first_count <= (others => (others => (others => 0)));
      slice0cost_pixels_first_tag <= (others => false); slice0cost_pixels_cost <= (others => (others => 0));
      slice0cost_pixels_tag <= (others => false); slice0cost_read_column <= 0; slice0cost_change_column <= 0;
      slice0cost_change_0 <= (others => 0); slice0cost_ready_words(0) <= to_unsigned(0, 32);
      slice0cost_ready_words(1) <= to_unsigned(0, 32); slice0cost_ready_words(2) <= to_unsigned(0, 32);
      slice0cost_ready_words(3) <= to_unsigned(0, 32); slice0cost_ready_column <= 0;
      slice0cost_ready_tag <= (others => false); slice0cost_column_0 <= (others => 0); slice0cost_write_column <= 0;
      slice0cost_write_words(0) <= to_unsigned(0, 32); slice0cost_write_words(1) <= to_unsigned(0, 32);
      slice0cost_write_words(2) <= to_unsigned(0, 32); slice0cost_write_words(3) <= to_unsigned(0, 32);
      slice0cost_tag <= (others => false); slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_0 <= (others => 0); slice0window_entering_tag <= (others => false);
      slice0window_change_0 <= (others => 0); slice0window_change_tag <= (others => false);
      slice0window_sum_0 <= (others => 0); slice0window_centre_map_column_0 <= false;
      slice0window_centre_output_column <= (others => false); slice0window_centre_first_column <= (others => false);
      slice0window_centre_start_of_frame_0 <= false; slice0window_centre_start_of_frame_3 <= false;
      slice0window_centre_end_of_line_0 <= false; slice0window_tag <= (others => false);
      slice0mask_inside <= (others => false); slice0mask_left_out <= false; slice0mask_column <= 0;
      slice0other_cost_0 <= (others => 0); slice0other_winner_0_1 <= false; slice0other_winner_0 <= (others => 0);
      slice0other_cost_out_0 <= 0; slice0other_winner_out_0 <= 0; slice0winner1_held_0 <= (others => 0);
      slice0winner1_best_cost_0 <= (others => 0); slice0winner1_best_index_0_0 <= false;
      slice0winner1_best_index_0 <= (others => 0); slice0winner1_best_below_0 <= (others => 0);
      slice0winner1_best_above_0 <= (others => 0); slice0winner1_best_place_0 <= (others => false);
      slice0winner1_best_late_cost_0 <= (others => 0); slice0winner1_best_but_first_0 <= (others => 2047);
      slice0winner1_best_but_last_0 <= (others => 2047); slice0winner1_tag <= (others => false);
      slice0winner2_best_cost_0 <= (others => 0); slice0winner2_best_index_0 <= (others => 0);
      slice0winner2_best_below_0 <= (others => 0); slice0winner2_best_above_0 <= (others => 0);
      slice0winner2_best_first_0 <= (others => 0); slice0winner2_best_last_0 <= (others => 0);
      slice0winner2_best_place_0 <= (others => false); slice0winner2_best_at_start_0 <= (others => false);
      slice0winner2_best_at_end_0 <= (others => false); slice0winner2_best_late_cost_0 <= (others => 0);
      slice0winner2_best_second_0 <= (others => 2047); slice0winner2_best_but_first_0 <= (others => 2047);
      slice0winner2_best_but_last_0 <= (others => 2047); slice0winner2_tag <= (others => false);
      slice0winner3_best_cost_0 <= (others => 0); slice0winner3_best_index_0 <= (others => 0);
      slice0winner3_best_below_0 <= (others => 0); slice0winner3_best_above_0 <= (others => 0);
      slice0winner3_best_first_0_1 <= 0; slice0winner3_best_last_0 <= (others => 0);
      slice0winner3_best_place_0 <= (others => false); slice0winner3_best_at_start_0 <= (others => false);
      slice0winner3_best_at_end_0 <= (others => false); slice0winner3_best_late_cost_0 <= (others => 0);
      slice0winner3_best_second_0 <= (others => 2047); slice0winner3_best_but_first_0_1 <= 2047;
      slice0winner3_best_but_last_0 <= (others => 2047); slice0winner3_tag.valid <= false;
      slice0winner3_tag.map_column <= false; slice0winner3_tag.start_of_frame <= false;
      slice0winner3_tag.end_of_line <= false; slice0winner4_best_cost_0_0 <= 0; slice0winner4_best_index_0_0 <= 0;
      slice0winner4_best_below_0_0 <= 0; slice0winner4_best_above_0_0 <= 0; slice0winner4_best_last_0_0 <= 0;
      slice0winner4_best_place_0_0 <= false; slice0winner4_best_at_start_0_0 <= false;
      slice0winner4_best_at_end_0_0 <= false; slice0winner4_best_late_cost_0_0 <= 0;
      slice0winner4_best_second_0_0 <= 2047; slice0winner4_best_but_last_0_0 <= 2047; slice0winner4_tag.valid <= false;
      slice0winner4_tag.map_column <= false; slice0winner4_tag.start_of_frame <= false;
      slice0winner4_tag.end_of_line <= false; slice0_best_index_0_0 <= 0; slice0_best_below_0_0 <= 0;
      slice0_best_above_0_0 <= 0; slice0_best_last_0_0 <= 0; slice0_best_late_cost_0_0 <= 0;
      slice0_best_second_0_0 <= 2047; slice0_best_but_last_0_0 <= 2047; slice0_best_tag.valid <= false;
      slice0_best_tag.map_column <= false; slice0_best_tag.start_of_frame <= false;
      slice0_best_tag.end_of_line <= false; slice1shift_search <= (others => (others => 0));
      slice1shift_reference <= (others => 0); slice1shift_search_out <= (others => 0);
      slice1cost_pixels_first_count <= (others => (others => (others => 0)));
      slice1cost_pixels_cost <= (others => (others => 0)); slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_change_0 <= (others => 0); slice1cost_ready_words(0) <= to_unsigned(0, 32);
      slice1cost_ready_words(1) <= to_unsigned(0, 32); slice1cost_ready_words(2) <= to_unsigned(0, 32);
      slice1cost_ready_words(3) <= to_unsigned(0, 32); slice1cost_ready_column <= 0;
      slice1cost_column_0 <= (others => 0); slice1cost_write_column <= 0;
      slice1cost_write_words(0) <= to_unsigned(0, 32); slice1cost_write_words(1) <= to_unsigned(0, 32);
      slice1cost_write_words(2) <= to_unsigned(0, 32); slice1cost_write_words(3) <= to_unsigned(0, 32);
      slice1window_ring_read_address <= 1; slice1window_ring_write_address <= 0;
      slice1window_entering_0 <= (others => 0); slice1window_change_0 <= (others => 0);
      slice1window_change_tag <= (others => false); slice1window_sum_0 <= (others => 0);
      slice1window_centre_map_column_0 <= false; slice1window_centre_output_column <= (others => false);
      slice1window_centre_first_column <= (others => false); slice1window_centre_start_of_frame_0 <= false;
      slice1window_centre_end_of_line_0 <= false; slice1window_tag <= (others => false);
      slice1mask_inside <= (others => false); slice1mask_left_out <= false; slice1other_cost_0 <= (others => 0);
      slice1other_winner_0 <= (others => 0); slice1other_cost_out_0 <= 0; slice1other_winner_out_0 <= 0;
      slice1winner1_held_0 <= (others => 0); slice1winner1_best_cost_0 <= (others => 0);
      slice1winner1_best_index_0_0 <= false; slice1winner1_best_index_0 <= (others => 0);
      slice1winner1_best_below_0 <= (others => 0); slice1winner1_best_above_0 <= (others => 0);
      slice1winner1_best_place_0 <= (others => false); slice1winner1_best_late_cost_0 <= (others => 0);
      slice1winner1_best_but_first_0 <= (others => 2047); slice1winner1_best_but_last_0 <= (others => 2047);
      slice1winner2_best_cost_0 <= (others => 0); slice1winner2_best_index_0 <= (others => 0);
      slice1winner2_best_below_0 <= (others => 0); slice1winner2_best_above_0 <= (others => 0);
      slice1winner2_best_first_0 <= (others => 0); slice1winner2_best_last_0 <= (others => 0);
      slice1winner2_best_place_0 <= (others => false); slice1winner2_best_at_start_0 <= (others => false);
      slice1winner2_best_at_end_0 <= (others => false); slice1winner2_best_late_cost_0 <= (others => 0);
      slice1winner2_best_second_0 <= (others => 2047); slice1winner2_best_but_first_0 <= (others => 2047);
      slice1winner2_best_but_last_0 <= (others => 2047); slice1winner3_best_cost_0 <= (others => 0);
      slice1winner3_best_index_0 <= (others => 0); slice1winner3_best_below_0 <= (others => 0);
      slice1winner3_best_above_0 <= (others => 0); slice1winner3_best_first_0 <= (others => 0);
      slice1winner3_best_last_0 <= (others => 0); slice1winner3_best_place_0 <= (others => false);
      slice1winner3_best_at_start_0 <= (others => false); slice1winner3_best_at_end_0 <= (others => false);
      slice1winner3_best_late_cost_0 <= (others => 0); slice1winner3_best_second_0 <= (others => 2047);
      slice1winner3_best_but_first_0 <= (others => 2047); slice1winner3_best_but_last_0 <= (others => 2047);
      slice1winner4_best_cost_0_0 <= 0; slice1winner4_best_index_0_0 <= 0; slice1winner4_best_below_0_0 <= 0;
      slice1winner4_best_above_0_0 <= 0; slice1winner4_best_first_0_0 <= 0; slice1winner4_best_last_0_0 <= 0;
      slice1winner4_best_place_0_0 <= false; slice1winner4_best_at_start_0_0 <= false;
      slice1winner4_best_at_end_0_0 <= false; slice1winner4_best_late_cost_0_0 <= 0;
      slice1winner4_best_second_0_0 <= 2047; slice1winner4_best_but_first_0_0 <= 2047;
      slice1winner4_best_but_last_0_0 <= 2047; slice1_best_cost_0_0 <= 0; slice1_best_index_0_0 <= 0;
      slice1_best_below_0_0 <= 0; slice1_best_above_0_0 <= 0; slice1_best_last_0_0 <= 0; slice1_best_place_0_0 <= false;
      slice1_best_at_start_0_0 <= false; slice1_best_at_end_0_0 <= false; slice1_best_late_cost_0_0 <= 0;
      slice1_best_second_0_0 <= 2047; slice1_best_but_last_0_0 <= 2047; slice1_best_tag.valid <= false;
      slice1_best_tag.map_column <= false; slice1_best_tag.start_of_frame <= false;
      slice1_best_tag.end_of_line <= false; slice2shift_search <= (others => (others => 0));
      slice2shift_reference <= (others => 0); slice2cost_pixels_first_count <= (others => (others => (others => 0)));
      slice2cost_pixels_cost <= (others => (others => 0)); slice2cost_read_column <= 0; slice2cost_change_column <= 0;
      slice2cost_change_0 <= (others => 0); slice2cost_ready_words(0) <= to_unsigned(0, 32);
      slice2cost_ready_words(1) <= to_unsigned(0, 32); slice2cost_ready_words(2) <= to_unsigned(0, 32);
      slice2cost_ready_words(3) <= to_unsigned(0, 32); slice2cost_ready_column <= 0;
      slice2cost_column_0 <= (others => 0); slice2cost_write_column <= 0;
      slice2cost_write_words(0) <= to_unsigned(0, 32); slice2cost_write_words(1) <= to_unsigned(0, 32);
      slice2cost_write_words(2) <= to_unsigned(0, 32); slice2cost_write_words(3) <= to_unsigned(0, 32);
      slice2window_ring_read_address <= 1; slice2window_ring_write_address <= 0;
      slice2window_entering_0 <= (others => 0); slice2window_change_0 <= (others => 0);
      slice2window_change_tag <= (others => false); slice2window_sum_0 <= (others => 0);
      slice2window_centre_map_column <= (others => false); slice2window_centre_output_column <= (others => false);
      slice2window_centre_first_column <= (others => false); slice2window_centre_start_of_frame_0 <= false;
      slice2window_centre_end_of_line <= (others => false); slice2mask_inside <= (others => false);
      slice2other_cost_0 <= (others => 0); slice2other_winner_0 <= (others => 0); slice2other_winner_out_0 <= 0;
      slice2winner1_held_0 <= (others => 0); slice2winner1_best_cost_0 <= (others => 0);
      slice2winner1_best_index_0_0 <= false; slice2winner1_best_index_0 <= (others => 0);
      slice2winner1_best_below_0 <= (others => 0); slice2winner1_best_above_0 <= (others => 0);
      slice2winner1_best_place_0 <= (others => false); slice2winner1_best_late_cost_0 <= (others => 0);
      slice2winner1_best_but_first_0 <= (others => 2047); slice2winner1_best_but_last_0 <= (others => 2047);
      slice2winner2_best_cost_0 <= (others => 0); slice2winner2_best_index_0 <= (others => 0);
      slice2winner2_best_below_0 <= (others => 0); slice2winner2_best_above_0 <= (others => 0);
      slice2winner2_best_first_0 <= (others => 0); slice2winner2_best_last_0 <= (others => 0);
      slice2winner2_best_place_0 <= (others => false); slice2winner2_best_at_start_0 <= (others => false);
      slice2winner2_best_at_end_0 <= (others => false); slice2winner2_best_late_cost_0 <= (others => 0);
      slice2winner2_best_second_0 <= (others => 2047); slice2winner2_best_but_first_0 <= (others => 2047);
      slice2winner2_best_but_last_0 <= (others => 2047); slice2winner3_best_cost_0 <= (others => 0);
      slice2winner3_best_index_0 <= (others => 0); slice2winner3_best_below_0 <= (others => 0);
      slice2winner3_best_above_0 <= (others => 0); slice2winner3_best_first_0 <= (others => 0);
      slice2winner3_best_last_0_0 <= 0; slice2winner3_best_place_0 <= (others => false);
      slice2winner3_best_at_start_0 <= (others => false); slice2winner3_best_at_end_0 <= (others => false);
      slice2winner3_best_late_cost_0 <= (others => 0); slice2winner3_best_second_0 <= (others => 2047);
      slice2winner3_best_but_first_0 <= (others => 2047); slice2winner3_best_but_last_0_0 <= 2047;
      slice2winner4_best_cost_0_0 <= 0; slice2winner4_best_index_0_0 <= 0; slice2winner4_best_below_0_0 <= 0;
      slice2winner4_best_above_0_0 <= 0; slice2winner4_best_first_0_0 <= 0; slice2winner4_best_place_0_0 <= false;
      slice2winner4_best_at_start_0_0 <= false; slice2winner4_best_at_end_0_0 <= false;
      slice2winner4_best_late_cost_0_0 <= 0; slice2winner4_best_second_0_0 <= 2047;
      slice2winner4_best_but_first_0_0 <= 2047; slice2_best_cost_0_0 <= 0; slice2_best_index_0_0 <= 0;
      slice2_best_below_0_0 <= 0; slice2_best_above_0_0 <= 0; slice2_best_place_0_0 <= false;
      slice2_best_at_start_0_0 <= false; slice2_best_at_end_0_0 <= false; slice2_best_late_cost_0_0 <= 0;
      slice2_best_second_0_0 <= 2047; slice2_best_tag.valid <= false; slice2_best_tag.map_column <= false;
      slice2_best_tag.start_of_frame <= false; slice2_best_tag.end_of_line <= false;
      refinement_disparity_0 <= (others => 0);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      refinement_alone_0_0 <= false; refinement_gap_0 <= 0; refinement_margin_0 <= (others => 0);
      refinement_below_0 <= 0; refinement_above_0 <= 0; refinement_u_0 <= 0; refinement_v_0 <= 0;
      refinement_difference_0 <= 0; refinement_remainder_0 <= (others => 0); refinement_divisor_0 <= (others => 1);
      refinement_quotient_8_0 <= 0; refinement_negative_0 <= (others => false); refinement_fraction_0 <= 8;
      leftright_other_0 <= (others => 0); leftright_ring_read_address <= 1; leftright_ring_write_address <= 0;
      leftright_holds_winners <= false; leftright_position <= 0; leftright_held_position <= 0;
      leftright_held_valid <= false; leftright_address_0 <= 0; leftright_asking_disparity_0 <= 0;
      leftright_asking_fraction_0 <= 8; leftright_asking_passed_0 <= true; leftright_asking_margin_0 <= 0;
      leftright_asking_tag <= (others => false); leftright_answered_disparity_0 <= 0;
      leftright_answered_fraction_0 <= 8; leftright_answered_passed_0 <= true; leftright_answered_margin_0 <= 0;
      leftright_answered_tag <= (others => false); leftright_checked_disparity_0 <= 0;
      leftright_checked_fraction_0 <= 8; leftright_checked_passed_0 <= true; leftright_checked_margin_0 <= 0;
      leftright_checked_tag <= (others => false); support_counter_column <= 0; support_counter_group <= 377;
      support_newest_0 <= 0; support_newest_rest_0 <= 0; support_moves <= false; support_arrives <= false;
      support_last <= false; support_rows_read_newest_0 <= 0; support_rows_ready_words_0 <= 0;
      support_rows_ready_newest_0 <= 0; support_rows_write_words_0 <= 0; support_rest_rows_read_newest_0 <= 0;
      support_rest_rows_ready_words_0 <= 0; support_rest_rows_ready_newest_0 <= 0; support_rest_rows_write_words_0 <= 0;
      support_read_column <= 0; support_read_moves <= false; support_read_arrives <= false;
      support_read_above2 <= false; support_read_above1 <= false; support_read_below1 <= false;
      support_read_below2 <= false; support_read_first <= false; support_read_last <= false; support_ready_column <= 0;
      support_ready_moves <= false; support_ready_arrives <= false; support_ready_above2 <= false;
      support_ready_above1 <= false; support_ready_below1 <= false; support_ready_below2 <= false;
      support_ready_first <= false; support_ready_last <= false; support_write_column <= 0;
      support_column <= (others => 0); support_column_rest_0 <= 0; support_at_moves <= false;
      support_at_arrives <= false; support_at_first <= false; support_at_last <= false;
      support_cells <= (others => (others => 0)); support_row_tag <= (others => false); support_rest_0 <= (others => 0);
      for i in 0 to 6 loop
        support_moment_map_column(i) <= false; support_moment_start_of_frame(i) <= false;
        support_moment_last(i) <= false;
      end loop;
      support_next_tag <= false; support_moved <= false; support_like_0 <= (others => (others => false));
      support_partial_0 <= (others => 0); support_count_0 <= 0; support_enough_0 <= false; support_sum_0 <= 0;
      support_centre_0 <= (others => 0); support_centre_rest_0 <= (others => 0);
      for i in 0 to 3 loop
        support_centre_moment_map_column(i) <= false; support_centre_moment_start_of_frame(i) <= false;
        support_centre_moment_last(i) <= false;
      end loop;
      support_centre_moved <= (others => false); support_out_disparity_0 <= 0; support_out_passed_0 <= false;
      support_out_sure_0 <= 0; support_out_tag <= (others => false); fill_counter_column <= 0;
      fill_counter_group <= 376; fill_newest_disparity_0 <= 0; fill_newest_passed_0 <= false; fill_newest_sure_0 <= 0;
      fill_moves <= false; fill_arrives <= false; fill_last <= false; fill_rows_read_newest_0 <= 0;
      fill_rows_ready_words_0 <= 0; fill_rows_ready_newest_0 <= 0; fill_rows_write_words_0 <= 0; fill_read_column <= 0;
      fill_read_moves <= false; fill_read_arrives <= false; fill_read_top <= false; fill_read_last <= false;
      fill_ready_column <= 0; fill_ready_moves <= false; fill_ready_arrives <= false; fill_ready_top <= false;
      fill_ready_last <= false; fill_write_column <= 0; fill_ends_open_0 <= false; fill_pixel_0_passed <= false;
      fill_at_column <= 0; fill_at_moves <= false; fill_at_arrives <= false; fill_at_top <= false;
      fill_at_last <= false; fill_in_hole_0 <= false; fill_asking_0_passed <= (others => false);
      for i in 0 to 1 loop
        fill_asking_at_column(i) <= 0; fill_asking_at_moves(i) <= false; fill_asking_at_arrives(i) <= false;
        fill_asking_at_top(i) <= false; fill_asking_at_last(i) <= false;
      end loop;
      fill_hole_starts_0 <= (others => false); fill_known_at_column <= 0; fill_known_at_moves <= false;
      fill_known_at_arrives <= false; fill_known_at_top <= false; fill_known_at_last <= false;
      fill_measured_at_column <= 0; fill_measured_at_moves <= false; fill_measured_at_arrives <= false;
      fill_measured_at_top <= false; fill_measured_at_last <= false; fill_chosen_at_column <= 0;
      fill_chosen_at_moves <= false; fill_chosen_at_arrives <= false; fill_chosen_at_top <= false;
      fill_chosen_at_last <= false; fill_out_tag <= (others => false); median_counter_column <= 0;
      median_counter_group <= 376; median_arrives <= false; median_behind <= false; median_line_ended <= false;
      median_read_column <= 0; median_read_arrives <= false; median_read_behind <= false; median_read_top <= false;
      median_read_output <= false; median_ready_column <= 0; median_ready_arrives <= false;
      median_ready_behind <= false; median_ready_top <= false; median_ready_output <= false; median_write_column <= 0;
      median_at_arrives <= false; median_at_behind <= false; median_at_top <= false; median_at_output <= false;
      median_comparing_column <= 0; median_comparing_arrives <= false; median_comparing_behind <= false;
      median_comparing_top <= false; median_comparing_output <= false; median_sorted_column <= 0;
      median_sorted_arrives <= false; median_sorted_behind <= false; median_sorted_top <= false;
      median_sorted_output <= false; median_window_complete <= false; median_window_first <= false;
      median_window_last <= false;
      for i in 0 to 2 loop
        median_waiting_complete(i) <= false; median_waiting_first(i) <= false; median_waiting_last(i) <= false;
      end loop;
      median_out_valid <= false; median_out_start_of_frame <= false; median_out_end_of_line <= false; other_0 <= true;
      other_2 <= 0; other_3 <= 0; other_4 <= 0; other_5 <= 0; other_6 <= 0; other_7 <= 0; other_8 <= 0; other_9 <= 0;
      other_10 <= 0; other <= (others => 0);
    end if;
  end process;
end architecture;
