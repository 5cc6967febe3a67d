-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration vga_64: 640x480, 64 disparities, window 9x9, 1 pixel pair a clock.
-- Options: window_px 9, reference left, cost census, census_width_px 9, census_height_px 3,
--   left_right_threshold 1, uniqueness_percent 5, subpixel true, median true, aggregation recursive,
--   slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config vga_64
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_vga_64 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 576;
    latency_clocks : positive := 54;
    flush_groups : positive := 3912;
    gap_groups : positive := 2560
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
  assert width_px = 640 report "stereo_core_vga_64: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_vga_64: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 64 report "stereo_core_vga_64: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_vga_64: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_vga_64: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 576 report "stereo_core_vga_64: output_width_px is " & integer'image(output_width_px) & " but this core has 576" severity failure;
  assert latency_clocks = 54 report "stereo_core_vga_64: latency_clocks is " & integer'image(latency_clocks) & " but this core has 54" severity failure;
  assert flush_groups = 3912 report "stereo_core_vga_64: flush_groups is " & integer'image(flush_groups) & " but this core has 3912" severity failure;
  assert gap_groups = 2560 report "stereo_core_vga_64: gap_groups is " & integer'image(gap_groups) & " but this core has 2560" severity failure;
end entity;

architecture rtl of stereo_core_vga_64 is
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
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_26_to_26_1d is array (natural range <>) of integer range -26 to 26;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_26_2d is array (natural range <>, natural range <>) of natural range 0 to 26;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_4097_to_16382_1d is array (natural range <>) of natural range 4097 to 16382;
  type natural_47_1d is array (natural range <>) of natural range 0 to 47;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_67108863_1d is array (natural range <>) of natural range 0 to 67108863;
  type natural_67108863_2d is array (natural range <>, natural range <>) of natural range 0 to 67108863;
  type unsigned_26_1d is array (natural range <>) of unsigned(25 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_11 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column, output_column : boolean;
    first_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_10 is record
    valid, first_group, border_column, first_cost, leaves_window, map_column, output_column, first_column : boolean;
    start_of_frame, end_of_line : boolean;
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
    first_cost, leaves_window, output_column, first_column : boolean;
  end record;
  type tag_2 is record
    output_column, first_column : boolean;
  end record;
  type tag_3 is record
    first_cost, output_column, first_column : boolean;
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
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 2);
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 8, 0 to 2);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 2);
  signal transform_read_column_inside : boolean_1d(0 to 8);
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 2);
  signal transform_ready_column_inside : boolean_1d(0 to 8);
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 2);
  signal transform_columns_column_inside : boolean_1d(0 to 8);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 8);
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 67108863;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 67108863;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 67108863;
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_11;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_26_1d(0 to 8);
  signal rows_search_rows_read_newest_0 : natural range 0 to 67108863;
  signal rows_search_rows_ready_words : natural_67108863_1d(0 to 8);
  signal rows_search_rows_ready_newest_0 : natural range 0 to 67108863;
  signal rows_search_rows_write_words : natural_67108863_1d(0 to 8);
  signal rows_reference_rows_read_newest_0 : natural range 0 to 67108863;
  signal rows_reference_rows_ready_words : natural_67108863_1d(0 to 8);
  signal rows_reference_rows_ready_newest_0 : natural range 0 to 67108863;
  signal rows_reference_rows_write_words : natural_67108863_1d(0 to 8);
  signal rows_search, rows_reference : natural_67108863_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_11;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_11;
  -- slice0shift
  signal slice0shift_search : natural_67108863_2d(0 to 1, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_67108863_1d(0 to 1);
  signal slice0shift_tag : tag_11;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice0cost_pixels_first_count_8 : natural_2_2d(0 to 1, 0 to 15);  -- _#_#_count_8
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag : tag_11;
  signal slice0cost_tag : tag_10;
  signal slice0cost_pixels_cost : natural_26_2d(0 to 1, 0 to 15);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 1023;
  signal slice0cost_read_words, slice0cost_ready_words, slice0cost_write_words : unsigned_32_1d(0 to 3);
  signal slice0cost_change_0 : integer_minus_26_to_26_1d(0 to 15);
  signal slice0cost_column_0 : natural_255_1d(0 to 15);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_32_1d(0 to 3);
  signal slice0window_entering_0 : natural_255_1d(0 to 15);
  signal slice0window_entering_tag, slice0window_change_tag : tag_10;
  signal slice0window_centre_map_column_0 : boolean;
  signal slice0window_centre_output_column, slice0window_centre_first_column,
    slice0window_centre_start_of_frame : boolean_1d(0 to 3);
  signal slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_4;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice0window_sum_0 : natural_4095_1d(0 to 15);
  -- slice0other
  signal slice0other_cost_0 : natural_4095_1d(0 to 15);
  signal slice0other_cost_out_0 : natural range 0 to 4095;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0 : natural_15_1d(2 to 15);  -- _# up to 2, 3 .. 15
  signal slice0other_winner_out_0 : natural range 0 to 15;
  -- slice0winner1
  signal slice0winner1_held_0 : natural_4095_1d(0 to 15);
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_late_cost_0 : natural_4095_1d(0 to 7);
  signal slice0winner1_best_but_first_0 : natural_4095_1d(1 to 7);
  signal slice0winner1_best_but_last_0 : natural_4095_1d(0 to 7);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice0winner1_tag : tag_4;
  signal slice0winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0 : natural_4095_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_4095_1d(1 to 3);
  signal slice0winner2_best_last_0, slice0winner2_best_late_cost_0,
    slice0winner2_best_second_0 : natural_4095_1d(0 to 3);
  signal slice0winner2_best_but_first_0 : natural_4095_1d(1 to 3);
  signal slice0winner2_best_but_last_0 : natural_4095_1d(0 to 3);
  signal slice0winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice0winner2_best_place_0, slice0winner2_best_at_start_0, slice0winner2_best_at_end_0 : boolean_1d(0 to 3);
  signal slice0winner2_tag : tag_6;
  -- slice0winner3
  signal slice0winner3_best_cost_0, slice0winner3_best_below_0, slice0winner3_best_above_0 : natural_4095_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 4095;
  signal slice0winner3_best_last_0, slice0winner3_best_late_cost_0,
    slice0winner3_best_second_0 : natural_4095_1d(0 to 1);
  signal slice0winner3_best_but_first_0_1 : natural range 0 to 4095;
  signal slice0winner3_best_but_last_0 : natural_4095_1d(0 to 1);
  signal slice0winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice0winner3_best_place_0, slice0winner3_best_at_start_0, slice0winner3_best_at_end_0 : boolean_1d(0 to 1);
  signal slice0winner3_tag : tag_6;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0, slice0winner4_best_above_0_0,
    slice0winner4_best_last_0_0, slice0winner4_best_late_cost_0_0, slice0winner4_best_second_0_0,
    slice0winner4_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_place_0_0, slice0winner4_best_at_start_0_0, slice0winner4_best_at_end_0_0 : boolean;
  signal slice0winner4_tag : tag_5;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0, slice0_best_late_cost_0_0,
    slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0_best_tag : tag_5;
  -- slice1shift
  signal slice1shift_search : natural_67108863_2d(0 to 1, 0 to 15);
  signal slice1shift_reference, slice1shift_search_out : natural_67108863_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice1cost_pixels_first_count_8 : natural_2_2d(0 to 1, 0 to 15);  -- _#_#_count_8
  signal slice1cost_pixels_cost : natural_26_2d(0 to 1, 0 to 15);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 1023;
  signal slice1cost_read_words, slice1cost_ready_words, slice1cost_write_words : unsigned_32_1d(0 to 3);
  signal slice1cost_change_0 : integer_minus_26_to_26_1d(0 to 15);
  signal slice1cost_column_0 : natural_255_1d(0 to 15);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_32_1d(0 to 3);
  signal slice1window_entering_0 : natural_255_1d(0 to 15);
  signal slice1window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice1window_change_tag : tag_4_b;
  signal slice1window_centre_map_column_0 : boolean;
  signal slice1window_centre_output_column, slice1window_centre_first_column : boolean_1d(0 to 3);
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_tag : tag_2;
  signal slice1window_sum_0 : natural_4095_1d(0 to 15);
  -- slice1other
  signal slice1other_cost_0 : natural_4095_1d(0 to 15);
  signal slice1other_cost_out_0 : natural range 0 to 4095;
  signal slice1other_winner_0 : natural_31_1d(0 to 15);  -- _# up to 16, 17 .. 31
  signal slice1other_winner_out_0 : natural range 0 to 31;
  -- slice1winner1
  signal slice1winner1_held_0 : natural_4095_1d(0 to 15);
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0,
    slice1winner1_best_late_cost_0, slice1winner1_best_but_first_0,
    slice1winner1_best_but_last_0 : natural_4095_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice1winner1_tag : tag_2;
  signal slice1winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0, slice1winner2_best_first_0,
    slice1winner2_best_last_0, slice1winner2_best_late_cost_0, slice1winner2_best_second_0,
    slice1winner2_best_but_first_0, slice1winner2_best_but_last_0 : natural_4095_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice1winner2_best_place_0, slice1winner2_best_at_start_0, slice1winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice1winner3
  signal slice1winner3_best_cost_0, slice1winner3_best_below_0, slice1winner3_best_above_0, slice1winner3_best_first_0,
    slice1winner3_best_last_0, slice1winner3_best_late_cost_0, slice1winner3_best_second_0,
    slice1winner3_best_but_first_0, slice1winner3_best_but_last_0 : natural_4095_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice1winner3_best_place_0, slice1winner3_best_at_start_0, slice1winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0, slice1winner4_best_above_0_0,
    slice1winner4_best_first_0_0, slice1winner4_best_last_0_0, slice1winner4_best_late_cost_0_0,
    slice1winner4_best_second_0_0, slice1winner4_best_but_first_0_0,
    slice1winner4_best_but_last_0_0 : natural range 0 to 4095;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_place_0_0, slice1winner4_best_at_start_0_0, slice1winner4_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0, slice1_best_last_0_0,
    slice1_best_late_cost_0_0, slice1_best_second_0_0, slice1_best_but_last_0_0 : natural range 0 to 4095;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0 : boolean;
  signal slice1_best_tag : tag_5;
  -- slice2shift
  signal slice2shift_search : natural_67108863_2d(0 to 1, 0 to 15);
  signal slice2shift_reference, slice2shift_search_out : natural_67108863_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice2cost_pixels_first_count_8 : natural_2_2d(0 to 1, 0 to 15);  -- _#_#_count_8
  signal slice2cost_pixels_cost : natural_26_2d(0 to 1, 0 to 15);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column,
    slice2cost_write_column : natural range 0 to 1023;
  signal slice2cost_read_words, slice2cost_ready_words, slice2cost_write_words : unsigned_32_1d(0 to 3);
  signal slice2cost_change_0 : integer_minus_26_to_26_1d(0 to 15);
  signal slice2cost_column_0 : natural_255_1d(0 to 15);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving : unsigned_32_1d(0 to 3);
  signal slice2window_entering_0 : natural_255_1d(0 to 15);
  signal slice2window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice2window_change_tag : tag_4_b;
  signal slice2window_centre_map_column_0 : boolean;
  signal slice2window_centre_output_column, slice2window_centre_first_column : boolean_1d(0 to 2);
  signal slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_4095_1d(0 to 15);
  -- slice2other
  signal slice2other_cost_0 : natural_4095_1d(0 to 15);
  signal slice2other_cost_out_0 : natural range 0 to 4095;
  signal slice2other_winner_0 : natural_47_1d(0 to 15);  -- _# up to 32, 33 .. 47
  signal slice2other_winner_out_0 : natural range 0 to 47;
  -- slice2winner1
  signal slice2winner1_held_0 : natural_4095_1d(0 to 15);
  signal slice2winner1_best_cost_0, slice2winner1_best_below_0, slice2winner1_best_above_0,
    slice2winner1_best_late_cost_0, slice2winner1_best_but_first_0,
    slice2winner1_best_but_last_0 : natural_4095_1d(0 to 7);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice2winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice2winner2
  signal slice2winner2_best_cost_0, slice2winner2_best_below_0, slice2winner2_best_above_0, slice2winner2_best_first_0,
    slice2winner2_best_last_0, slice2winner2_best_late_cost_0, slice2winner2_best_second_0,
    slice2winner2_best_but_first_0, slice2winner2_best_but_last_0 : natural_4095_1d(0 to 3);
  signal slice2winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice2winner2_best_place_0, slice2winner2_best_at_start_0, slice2winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice2winner3
  signal slice2winner3_best_cost_0, slice2winner3_best_below_0, slice2winner3_best_above_0, slice2winner3_best_first_0,
    slice2winner3_best_last_0, slice2winner3_best_late_cost_0, slice2winner3_best_second_0,
    slice2winner3_best_but_first_0, slice2winner3_best_but_last_0 : natural_4095_1d(0 to 1);
  signal slice2winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice2winner3_best_place_0, slice2winner3_best_at_start_0, slice2winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0, slice2winner4_best_above_0_0,
    slice2winner4_best_first_0_0, slice2winner4_best_last_0_0, slice2winner4_best_late_cost_0_0,
    slice2winner4_best_second_0_0, slice2winner4_best_but_first_0_0,
    slice2winner4_best_but_last_0_0 : natural range 0 to 4095;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_place_0_0, slice2winner4_best_at_start_0_0, slice2winner4_best_at_end_0_0 : boolean;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0, slice2_best_last_0_0,
    slice2_best_late_cost_0_0, slice2_best_second_0_0, slice2_best_but_last_0_0 : natural range 0 to 4095;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0 : boolean;
  signal slice2_best_tag : tag_5;
  -- slice3shift
  signal slice3shift_search : natural_67108863_2d(0 to 1, 0 to 15);
  signal slice3shift_reference : natural_67108863_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 15, 0 to 7);  -- _#_#_count_#
  signal slice3cost_pixels_first_count_8 : natural_2_2d(0 to 1, 0 to 15);  -- _#_#_count_8
  signal slice3cost_pixels_cost : natural_26_2d(0 to 1, 0 to 15);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column,
    slice3cost_write_column : natural range 0 to 1023;
  signal slice3cost_read_words, slice3cost_ready_words, slice3cost_write_words : unsigned_32_1d(0 to 3);
  signal slice3cost_change_0 : integer_minus_26_to_26_1d(0 to 15);
  signal slice3cost_column_0 : natural_255_1d(0 to 15);
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 15;
  signal slice3window_leaving : unsigned_32_1d(0 to 3);
  signal slice3window_entering_0 : natural_255_1d(0 to 15);
  signal slice3window_change_0 : integer_minus_255_to_255_1d(0 to 15);
  signal slice3window_change_tag : tag_3;
  signal slice3window_centre_map_column, slice3window_centre_output_column, slice3window_centre_first_column,
    slice3window_centre_end_of_line : boolean_1d(0 to 2);
  signal slice3window_sum_0 : natural_4095_1d(0 to 15);
  -- slice3other
  signal slice3other_cost_0 : natural_4095_1d(0 to 14);
  signal slice3other_winner_0 : natural_63_1d(0 to 15);  -- _# up to 48, 49 .. 63
  signal slice3other_winner_out_0 : natural range 0 to 63;
  -- slice3winner1
  signal slice3winner1_held_0 : natural_4095_1d(0 to 15);
  signal slice3winner1_best_cost_0, slice3winner1_best_below_0, slice3winner1_best_above_0,
    slice3winner1_best_late_cost_0, slice3winner1_best_but_first_0 : natural_4095_1d(0 to 7);
  signal slice3winner1_best_but_last_0 : natural_4095_1d(0 to 6);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_place_0 : boolean_1d(1 to 3);  -- _2#
  signal slice3winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice3winner2
  signal slice3winner2_best_cost_0, slice3winner2_best_below_0, slice3winner2_best_above_0,
    slice3winner2_best_first_0 : natural_4095_1d(0 to 3);
  signal slice3winner2_best_last_0 : natural_4095_1d(0 to 2);
  signal slice3winner2_best_late_cost_0, slice3winner2_best_second_0,
    slice3winner2_best_but_first_0 : natural_4095_1d(0 to 3);
  signal slice3winner2_best_but_last_0 : natural_4095_1d(0 to 2);
  signal slice3winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice3winner2_best_place_0, slice3winner2_best_at_start_0, slice3winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice3winner3
  signal slice3winner3_best_cost_0, slice3winner3_best_below_0, slice3winner3_best_above_0,
    slice3winner3_best_first_0 : natural_4095_1d(0 to 1);
  signal slice3winner3_best_last_0_0 : natural range 0 to 4095;
  signal slice3winner3_best_late_cost_0, slice3winner3_best_second_0,
    slice3winner3_best_but_first_0 : natural_4095_1d(0 to 1);
  signal slice3winner3_best_but_last_0_0 : natural range 0 to 4095;
  signal slice3winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice3winner3_best_place_0, slice3winner3_best_at_start_0, slice3winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice3winner4
  signal slice3winner4_best_cost_0_0, slice3winner4_best_below_0_0, slice3winner4_best_above_0_0,
    slice3winner4_best_first_0_0, slice3winner4_best_late_cost_0_0, slice3winner4_best_second_0_0,
    slice3winner4_best_but_first_0_0 : natural range 0 to 4095;
  signal slice3winner4_best_index_0_0 : natural range 0 to 15;
  signal slice3winner4_best_place_0_0, slice3winner4_best_at_start_0_0, slice3winner4_best_at_end_0_0 : boolean;
  -- slice3
  signal slice3_best_cost_0_0, slice3_best_below_0_0, slice3_best_above_0_0, slice3_best_late_cost_0_0,
    slice3_best_second_0_0 : natural range 0 to 4095;
  signal slice3_best_index_0_0 : natural range 0 to 63;
  signal slice3_best_place_0_0, slice3_best_at_start_0_0, slice3_best_at_end_0_0 : boolean;
  signal slice3_best_tag : tag_5;
  -- refinement
  signal refinement_disparity_0 : natural_63_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_alone_0 : boolean_1d(0 to 1);  -- _#_0
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_gap_0, refinement_lowest_0, refinement_scaled_cost_0, refinement_below_0, refinement_above_0,
    refinement_u_0, refinement_v_0 : natural range 0 to 4095;
  signal refinement_remainder_0, refinement_divisor_0 : natural_4095_1d(0 to 7);  -- _#_0
  signal refinement_scaled_gap_0 : natural range 0 to 81900;
  signal refinement_difference_0 : integer range -4095 to 4095;
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_0 : natural_63_1d(1 to 15);  -- _#_0
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_asking_disparity_0,
    leftright_answered_disparity_0, leftright_checked_disparity_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0 : boolean;
  signal leftright_asking_tag : tag_4_c;
  signal leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag : tag_4_c;
  signal leftright_checked_passed_0 : boolean;
  signal leftright_checked_tag : tag_5_b;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 127;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0,
    leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_found_0 : unsigned(5 downto 0);
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column,
    map_sorted_column : natural range 0 to 1023;
  signal map_counter_group : natural range 0 to 511;
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
  signal other_0, other_2 : unsigned(48 downto 0);
  signal other_1 : natural range 0 to 8190;
  signal other_3 : natural range 0 to 254;
  signal other_4 : natural range 0 to 252;
  signal other_5 : natural range 0 to 248;
  signal other_6 : natural range 0 to 240;
  signal other_7 : natural range 0 to 224;
  signal other_8 : natural range 0 to 192;
  signal other_9 : natural range 0 to 128;

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
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    write_data <= to_unsigned(transform_left_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (640, 16, 10)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address, write_data);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 10);
    write_address <= to_unsigned(transform_write_column, 10);
    write_data <= to_unsigned(transform_right_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (640, 16, 10)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address, write_data);
  end block;

  map_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 10);
    write_address <= to_unsigned(map_at_column, 10);
    write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (576, 26, 10)
      port map (clock, true, read_address, map_rows_read_words_0, write_address, write_data);
  end block;

  leftright_found_0_memory : block
    signal read_address, write_address : unsigned(6 downto 0);
    signal write_data : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(leftright_address_0, 7);
    write_address <= to_unsigned(leftright_position, 7);
    write_data <= to_unsigned(leftright_other_0(15), 6);
    cell : entity work.line_memory generic map (128, 6, 7)
      port map (clock, true, read_address, leftright_found_0, write_address, write_data);
  end block;

  leftright_held_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
    signal write_data : unsigned(17 downto 0);
  begin
    read_address <= to_unsigned(leftright_ring_read_address, 6);
    write_address <= to_unsigned(leftright_ring_write_address, 6);
    write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned(as_number(refinement_passed_0(11)), 1) &
      to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) &
      to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) &
      to_unsigned(as_number(refinement_tag_output_column(11)), 1) &
      to_unsigned(as_number(refinement_tag_map_column(11)), 1);
    cell : entity work.line_memory generic map (64, 18, 6)
      port map (clock, true, read_address, leftright_held_0, write_address, write_data);
  end block;

  slice3window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(31 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 4);
    write_address <= to_unsigned(slice3window_ring_write_address, 4);
    write_data <= to_unsigned(slice3cost_column_0(4 * i + 3), 8) & to_unsigned(slice3cost_column_0(4 * i + 2), 8) &
      to_unsigned(slice3cost_column_0(4 * i + 1), 8) & to_unsigned(slice3cost_column_0(4 * i), 8);
    cell : entity work.line_memory generic map (10, 32, 4)
      port map (clock, true, read_address, slice3window_leaving(i), write_address, write_data);
  end generate;

  slice3cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice3cost_read_column, 10);
    write_address <= to_unsigned(slice3cost_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, slice3cost_read_words(i), write_address, slice3cost_write_words(i));
  end generate;

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
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_ready_column, 10);
    write_address <= to_unsigned(slice2cost_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
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
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 10);
    write_address <= to_unsigned(slice2cost_ready_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
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
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 10);
    write_address <= to_unsigned(slice2cost_change_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, slice0cost_write_words(i));
  end generate;

  rows_search_rows_read_words_memory : for i in 8 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 26);
    cell : entity work.line_memory generic map (640, 26, 10)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_memory : for i in 8 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 26);
    cell : entity work.line_memory generic map (640, 26, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  process
    variable transform_counter_group_is_equals, leftright_checked_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_map_column_is_less, delay_tag_first_column_is_equal, slice0winner4_best_cost_0_0_is_less,
      slice0winner4_best_below_0_0_is_equal, slice0winner4_best_above_0_0_is_equal,
      slice1winner4_best_cost_0_0_is_less, slice1winner4_best_below_0_0_is_equal,
      slice1winner4_best_above_0_0_is_equal, slice1_best_cost_0_0_is_less, slice1_best_below_0_0_is_equal,
      slice1_best_above_0_0_is_equal, slice2winner4_best_cost_0_0_is_less, slice2winner4_best_below_0_0_is_equal,
      slice2winner4_best_above_0_0_is_equal, slice2_best_cost_0_0_is_less, slice2_best_below_0_0_is_equal,
      slice2_best_above_0_0_is_equal, slice3other_cost_0_0_any, slice3winner4_best_cost_0_0_is_less,
      slice3winner4_best_below_0_0_is_equal, slice3winner4_best_above_0_0_is_equal, slice3_best_cost_0_0_is_less,
      slice3_best_below_0_0_is_equal, slice3_best_above_0_0_is_equal, refinement_divisor_0_0_is_less,
      leftright_holds_winners_choice, leftright_checked_tag_row_start_differs, map_counter_group_is_equal,
      map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal, map_window_complete_choice : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices, map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 212);
    variable transform_left_filter_feature_0_choice_201, transform_right_filter_feature_0_choice_201,
      refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice_202, transform_right_filter_feature_0_choice_202,
      leftright_address_0_value : natural range 0 to 63;
    variable transform_left_filter_feature_0_choice_203,
      transform_right_filter_feature_0_choice_203 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_204, transform_right_filter_feature_0_choice_204,
      slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice, slice1winner4_best_below_0_0_choice,
      slice1winner4_best_above_0_0_choice, slice1_best_below_0_0_choice, slice1_best_above_0_0_choice,
      slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice, slice2_best_below_0_0_choice,
      slice2_best_above_0_0_choice, slice3winner4_best_below_0_0_choice, slice3winner4_best_above_0_0_choice,
      slice3_best_below_0_0_choice, slice3_best_above_0_0_choice, refinement_divisor_0_0_choice,
      map_of_column_0_a_choice : natural range 0 to 4095;
    variable transform_left_filter_feature_0_choice_213,
      transform_right_filter_feature_0_choice_213 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_214,
      transform_right_filter_feature_0_choice_214 : natural range 0 to 131071;
    variable transform_left_filter_feature_0_choice_215,
      transform_right_filter_feature_0_choice_215 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_216,
      transform_right_filter_feature_0_choice_216 : natural range 0 to 8388607;
    variable transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice1cost_column_0_choice, slice2cost_column_0_choice,
      slice3cost_column_0_choice : natural_255_2d(0 to 15, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice, slice2window_change_0_choice,
      slice3window_change_0_choice : natural_255_1d(0 to 15);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice, slice2window_sum_0_choice,
      slice3window_sum_0_choice : natural_4095_1d(0 to 15);  -- _#_choice
    variable slice0other_cost_0_all : boolean_1d(1 to 15);  -- _#_all
    variable slice0other_cost_0_choice : boolean_1d(1 to 14);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less, slice2winner1_best_cost_0_is_less,
      slice3winner1_best_cost_0_is_less : boolean_1d(0 to 7);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less, slice2winner2_best_cost_0_is_less,
      slice3winner2_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable slice0winner2_best_below_0_is_equal, slice1winner2_best_below_0_is_equal,
      slice2winner2_best_below_0_is_equal, slice3winner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- _#_is_equal
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice, slice1winner2_best_below_0_choice,
      slice1winner2_best_above_0_choice, slice2winner2_best_below_0_choice, slice2winner2_best_above_0_choice,
      slice3winner2_best_below_0_choice, slice3winner2_best_above_0_choice : natural_4095_1d(0 to 3);  -- _#_choice
    variable slice0winner2_best_second_0_choice, slice1winner2_best_second_0_choice,
      slice2winner2_best_second_0_choice, slice3winner2_best_second_0_choice : natural_4095_2d(0 to 3, 1 to 4);  -- _#_choice_#
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less, slice2winner3_best_cost_0_is_less,
      slice3winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable slice0winner3_best_below_0_is_equal, slice0winner3_best_above_0_is_equal,
      slice1winner3_best_below_0_is_equal, slice1winner3_best_above_0_is_equal, slice2winner3_best_below_0_is_equal,
      slice2winner3_best_above_0_is_equal, slice3winner3_best_below_0_is_equal,
      slice3winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable slice0winner3_best_below_0_choice, slice0winner3_best_above_0_choice, slice1winner3_best_below_0_choice,
      slice1winner3_best_above_0_choice, slice2winner3_best_below_0_choice, slice2winner3_best_above_0_choice,
      slice3winner3_best_below_0_choice, slice3winner3_best_above_0_choice : natural_4095_1d(0 to 1);  -- _#_choice
    variable slice0winner3_best_second_0_choice, slice1winner3_best_second_0_choice,
      slice2winner3_best_second_0_choice, slice3winner3_best_second_0_choice : natural_4095_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable slice0winner4_best_second_0_0_choices, slice1winner4_best_second_0_0_choices,
      slice1_best_second_0_0_choices, slice2winner4_best_second_0_0_choices, slice2_best_second_0_0_choices,
      slice3winner4_best_second_0_0_choices, slice3_best_second_0_0_choices : natural_4095_1d(1 to 4);  -- _choice_#
    variable slice1other_cost_0_any, slice2other_cost_0_any : boolean_1d(0 to 15);  -- _#_any
    variable slice1other_cost_0_choice, slice2other_cost_0_choice, slice3other_cost_0_choice : boolean_1d(0 to 14);  -- _#_choice
    variable refinement_remainder_1_0_difference : natural range 4097 to 12287;
    variable refinement_remainder_0_difference : natural_4097_to_16382_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable leftright_checked_passed_0_difference : integer range -62 to 64;
    variable leftright_checked_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable leftright_checked_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable map_of_column_0_c_choice, map_low_0_0_choice, map_middle_0_0_choice,
      map_high_0_0_choice : natural range 0 to 32767;
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    slice0other_cost_0_all := (others => false); slice1other_cost_0_any := (others => false);
    slice2other_cost_0_any := (others => false); transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 479;
    transform_counter_group_is_equals(2) := transform_counter_column = 639;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 15, 0);
    transform_counter_group_differs := transform_counter_group /= 481;
    transform_counter_group_choices(2) := choice((transform_counter_group = 480) and transform_counter_next_frame, 1,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_is_less := 3 < transform_counter_column;
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(4, 1), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(4, 1), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 1) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 1), i);
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        transform_left_filter_feature_0_choice(24 * i + 8 * j + 8) := is_larger(transform_left_filter_column(8 - i, j),
          transform_left_filter_column(4, 1), 0, 7, false);
      end loop;
    end loop;
    transform_left_filter_feature_0_choice(103) := not is_larger(transform_left_filter_column(4, 2),
      transform_left_filter_column(4, 1), 0, 6, false);
    transform_left_filter_feature_0_choice(104) := choice(transform_left_filter_feature_0_choice(103),
      transform_filtering_0_column_inside(4) and is_set(transform_left_filter_column(4, 2), 7) and (not
      is_set(transform_left_filter_column(4, 1), 7)), transform_filtering_0_column_inside(4) and
      (is_set(transform_left_filter_column(4, 2), 7) or (not is_set(transform_left_filter_column(4, 1), 7))));
    for i in 0 to 2 loop
      transform_left_filter_feature_0_choice(24 * i + 112) := is_larger(transform_left_filter_column(3 - i, 1),
        transform_left_filter_column(4, 1), 0, 7, false);
      transform_left_filter_feature_0_choice(24 * i + 120) := is_larger(transform_left_filter_column(3 - i, 2),
        transform_left_filter_column(4, 1), 0, 7, false);
      transform_left_filter_feature_0_choice(24 * i + 128) := is_larger(transform_left_filter_column(3 - i, 0),
        transform_left_filter_column(4, 1), 0, 7, false);
    end loop;
    transform_left_filter_feature_0_choice(184) := is_larger(transform_left_filter_column(0, 1),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice(192) := is_larger(transform_left_filter_column(0, 2),
      transform_left_filter_column(4, 1), 0, 7, false);
    for i in 7 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
    end loop;
    transform_left_filter_feature_0_choice(200) := not is_larger(transform_left_filter_column(4, 1),
      transform_left_filter_column(0, 0), 0, 7, true);
    transform_left_filter_feature_0_choice_201 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_left_filter_feature_0_choice(184)) * 2) +
      (as_number(transform_left_filter_feature_0_choice(192)) * 4) +
      as_number(transform_left_filter_feature_0_choice(200)), 0);
    transform_left_filter_feature_0_choice_202 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_left_filter_feature_0_choice(160)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(168)) * 32) +
      (as_number(transform_left_filter_feature_0_choice(176)) * 8) + transform_left_filter_feature_0_choice_201,
      transform_left_filter_feature_0_choice_201);
    transform_left_filter_feature_0_choice_203 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_left_filter_feature_0_choice(136)) * 128) +
      (as_number(transform_left_filter_feature_0_choice(144)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(152)) * 64) + transform_left_filter_feature_0_choice_202,
      transform_left_filter_feature_0_choice_202);
    transform_left_filter_feature_0_choice_204 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_left_filter_feature_0_choice(112)) * 1024) +
      (as_number(transform_left_filter_feature_0_choice(120)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(128)) * 512) + transform_left_filter_feature_0_choice_203,
      transform_left_filter_feature_0_choice_203);
    transform_left_filter_feature_0_choice(212) := is_larger(transform_left_filter_column(4, 0),
      transform_left_filter_column(4, 1), 0, 7, false);
    transform_left_filter_feature_0_choice_213 := choice(transform_filtering_0_column_inside(4),
      transform_left_filter_feature_0_choice_204 + (as_number(transform_left_filter_feature_0_choice(212)) * 4096),
      transform_left_filter_feature_0_choice_204);
    transform_left_filter_feature_0_choice_214 := choice(transform_filtering_0_column_inside(5),
      (as_number(transform_left_filter_feature_0_choice(80)) * 16384) +
      (as_number(transform_left_filter_feature_0_choice(88)) * 32768) +
      (as_number(transform_left_filter_feature_0_choice(96)) * 65536) +
      (as_number(transform_left_filter_feature_0_choice(104)) * 8192) + transform_left_filter_feature_0_choice_213,
      (as_number(transform_left_filter_feature_0_choice(104)) * 8192) + transform_left_filter_feature_0_choice_213);
    transform_left_filter_feature_0_choice_215 := choice(transform_filtering_0_column_inside(6),
      (as_number(transform_left_filter_feature_0_choice(56)) * 131072) +
      (as_number(transform_left_filter_feature_0_choice(64)) * 262144) +
      (as_number(transform_left_filter_feature_0_choice(72)) * 524288) + transform_left_filter_feature_0_choice_214,
      transform_left_filter_feature_0_choice_214);
    transform_left_filter_feature_0_choice_216 := choice(transform_filtering_0_column_inside(7),
      (as_number(transform_left_filter_feature_0_choice(32)) * 1048576) +
      (as_number(transform_left_filter_feature_0_choice(40)) * 2097152) +
      (as_number(transform_left_filter_feature_0_choice(48)) * 4194304) + transform_left_filter_feature_0_choice_215,
      transform_left_filter_feature_0_choice_215);
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(4, 1), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(4, 1), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 1) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 1), i);
    end loop;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        transform_right_filter_feature_0_choice(24 * i + 8 * j + 8) := is_larger(transform_right_filter_column(8 - i,
          j), transform_right_filter_column(4, 1), 0, 7, false);
      end loop;
    end loop;
    transform_right_filter_feature_0_choice(103) := not is_larger(transform_right_filter_column(4, 2),
      transform_right_filter_column(4, 1), 0, 6, false);
    transform_right_filter_feature_0_choice(104) := choice(transform_right_filter_feature_0_choice(103),
      transform_filtering_0_column_inside(4) and is_set(transform_right_filter_column(4, 2), 7) and (not
      is_set(transform_right_filter_column(4, 1), 7)), transform_filtering_0_column_inside(4) and
      (is_set(transform_right_filter_column(4, 2), 7) or (not is_set(transform_right_filter_column(4, 1), 7))));
    for i in 0 to 2 loop
      transform_right_filter_feature_0_choice(24 * i + 112) := is_larger(transform_right_filter_column(3 - i, 1),
        transform_right_filter_column(4, 1), 0, 7, false);
      transform_right_filter_feature_0_choice(24 * i + 120) := is_larger(transform_right_filter_column(3 - i, 2),
        transform_right_filter_column(4, 1), 0, 7, false);
      transform_right_filter_feature_0_choice(24 * i + 128) := is_larger(transform_right_filter_column(3 - i, 0),
        transform_right_filter_column(4, 1), 0, 7, false);
    end loop;
    transform_right_filter_feature_0_choice(184) := is_larger(transform_right_filter_column(0, 1),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice(192) := is_larger(transform_right_filter_column(0, 2),
      transform_right_filter_column(4, 1), 0, 7, false);
    for i in 7 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
    end loop;
    transform_right_filter_feature_0_choice(200) := not is_larger(transform_right_filter_column(4, 1),
      transform_right_filter_column(0, 0), 0, 7, true);
    transform_right_filter_feature_0_choice_201 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_right_filter_feature_0_choice(184)) * 2) +
      (as_number(transform_right_filter_feature_0_choice(192)) * 4) +
      as_number(transform_right_filter_feature_0_choice(200)), 0);
    transform_right_filter_feature_0_choice_202 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_right_filter_feature_0_choice(160)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(168)) * 32) +
      (as_number(transform_right_filter_feature_0_choice(176)) * 8) + transform_right_filter_feature_0_choice_201,
      transform_right_filter_feature_0_choice_201);
    transform_right_filter_feature_0_choice_203 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_right_filter_feature_0_choice(136)) * 128) +
      (as_number(transform_right_filter_feature_0_choice(144)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(152)) * 64) + transform_right_filter_feature_0_choice_202,
      transform_right_filter_feature_0_choice_202);
    transform_right_filter_feature_0_choice_204 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_right_filter_feature_0_choice(112)) * 1024) +
      (as_number(transform_right_filter_feature_0_choice(120)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(128)) * 512) + transform_right_filter_feature_0_choice_203,
      transform_right_filter_feature_0_choice_203);
    transform_right_filter_feature_0_choice(212) := is_larger(transform_right_filter_column(4, 0),
      transform_right_filter_column(4, 1), 0, 7, false);
    transform_right_filter_feature_0_choice_213 := choice(transform_filtering_0_column_inside(4),
      transform_right_filter_feature_0_choice_204 + (as_number(transform_right_filter_feature_0_choice(212)) * 4096),
      transform_right_filter_feature_0_choice_204);
    transform_right_filter_feature_0_choice_214 := choice(transform_filtering_0_column_inside(5),
      (as_number(transform_right_filter_feature_0_choice(80)) * 16384) +
      (as_number(transform_right_filter_feature_0_choice(88)) * 32768) +
      (as_number(transform_right_filter_feature_0_choice(96)) * 65536) +
      (as_number(transform_right_filter_feature_0_choice(104)) * 8192) + transform_right_filter_feature_0_choice_213,
      (as_number(transform_right_filter_feature_0_choice(104)) * 8192) + transform_right_filter_feature_0_choice_213);
    transform_right_filter_feature_0_choice_215 := choice(transform_filtering_0_column_inside(6),
      (as_number(transform_right_filter_feature_0_choice(56)) * 131072) +
      (as_number(transform_right_filter_feature_0_choice(64)) * 262144) +
      (as_number(transform_right_filter_feature_0_choice(72)) * 524288) + transform_right_filter_feature_0_choice_214,
      transform_right_filter_feature_0_choice_214);
    transform_right_filter_feature_0_choice_216 := choice(transform_filtering_0_column_inside(7),
      (as_number(transform_right_filter_feature_0_choice(32)) * 1048576) +
      (as_number(transform_right_filter_feature_0_choice(40)) * 2097152) +
      (as_number(transform_right_filter_feature_0_choice(48)) * 4194304) + transform_right_filter_feature_0_choice_215,
      transform_right_filter_feature_0_choice_215);
    transform_left_0 <= in_left_pixel;
    transform_right_0 <= in_right_pixel;
    transform_valid <= in_valid;
    transform_left_rows_read_newest_0 <= transform_left_0;
    transform_left_rows_ready_words_0 <= to_integer(transform_left_rows_read_words_0);
    transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
    transform_right_rows_read_newest_0 <= transform_right_0;
    transform_right_rows_ready_words_0 <= to_integer(transform_right_rows_read_words_0);
    transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
    transform_read_column <= transform_counter_column;
    transform_read_row_inside(0) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 480;
    transform_read_row_inside(1) <= (transform_counter_group >= 1) and (transform_counter_group < 481);
    transform_read_row_inside(2) <= transform_counter_group < 480;
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    transform_read_column_inside(1) <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(2) <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(3) <= transform_counter_column /= 3;
    for i in 4 to 8 loop
      transform_read_column_inside(i) <= (transform_counter_column < i) /= transform_read_column_inside_0_is_less;
    end loop;
    transform_read_start_of_frame <= (transform_counter_group = 1) and (transform_counter_column = 4);
    transform_read_valid <= transform_valid;
    transform_ready_column <= transform_read_column;
    transform_ready_row_inside <= transform_read_row_inside;
    transform_ready_column_inside <= transform_read_column_inside;
    transform_ready_start_of_frame <= transform_read_start_of_frame;
    transform_ready_valid <= transform_read_valid;
    transform_left_column(0) <= transform_left_rows_ready_words_0 mod 256;
    transform_left_column(1) <= transform_left_rows_ready_words_0 / 256;
    transform_left_column(2) <= transform_left_rows_ready_newest_0;
    transform_right_column(0) <= transform_right_rows_ready_words_0 mod 256;
    transform_right_column(1) <= transform_right_rows_ready_words_0 / 256;
    transform_right_column(2) <= transform_right_rows_ready_newest_0;
    transform_columns_row_inside <= transform_ready_row_inside;
    transform_columns_column_inside <= transform_ready_column_inside;
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 32,
      transform_counter_group_choices(3));
    transform_left_filter_feature_0 <= choice(transform_filtering_0_column_inside(8),
      (as_number(transform_left_filter_feature_0_choice(8)) * 8388608) +
      (as_number(transform_left_filter_feature_0_choice(16)) * 16777216) +
      (as_number(transform_left_filter_feature_0_choice(24)) * 33554432) + transform_left_filter_feature_0_choice_216,
      transform_left_filter_feature_0_choice_216);
    transform_right_filter_feature_0 <= choice(transform_filtering_0_column_inside(8),
      (as_number(transform_right_filter_feature_0_choice(8)) * 8388608) +
      (as_number(transform_right_filter_feature_0_choice(16)) * 16777216) +
      (as_number(transform_right_filter_feature_0_choice(24)) * 33554432) +
      transform_right_filter_feature_0_choice_216, transform_right_filter_feature_0_choice_216);
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      480) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 1024);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2), (not in_start_of_frame) or
        transform_counter_group_all, in_start_of_frame and transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2));
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= (transform_left_rows_ready_newest_0 * 256) +
        (transform_left_rows_ready_words_0 / 256);
      transform_right_rows_write_words_0 <= (transform_right_rows_ready_newest_0 * 256) +
        (transform_right_rows_ready_words_0 / 256);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_columns_valid then
      for i in 1 to 8 loop
        transform_left_filter_column(i, 0) <= transform_left_filter_column(i - 1, 0);
        transform_left_filter_column(i, 1) <= transform_left_filter_column(i - 1, 1);
        transform_left_filter_column(i, 2) <= transform_left_filter_column(i - 1, 2);
      end loop;
      for i in 1 to 8 loop
        transform_right_filter_column(i, 0) <= transform_right_filter_column(i - 1, 0);
        transform_right_filter_column(i, 1) <= transform_right_filter_column(i - 1, 1);
        transform_right_filter_column(i, 2) <= transform_right_filter_column(i - 1, 2);
      end loop;
      for i in 0 to 2 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equal := raster_place_column = 639;
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1), 0,
      (raster_place_group + as_number(((raster_place_group /= 484) and transform_filtering_valid(1) and
      raster_place_group_is_equal))) mod 512);
    if transform_filtering_valid(1) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(1), 0,
        (raster_place_column + 1) mod 1024);
    end if;
    -- delay
    delay_tag_map_column_is_less := (((((raster_place_column / 64) + 1023) mod 1024) * 64) + (raster_place_column mod
      64)) < 576;
    delay_tag_first_column_is_equal := raster_place_column = 64;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 489);
    delay_row_inside(1) <= raster_place_group < 480;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 63;
    delay_tag.first_cost <= raster_place_column = 63;
    delay_tag.leaves_window <= (((((raster_place_column / 8) + 8183) mod 8192) * 8) + (raster_place_column mod 8)) <
      65468;
    delay_tag.map_column <= delay_tag_map_column_is_less;
    delay_tag.output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
      480) and delay_tag_map_column_is_less;
    delay_tag.first_column <= delay_tag_first_column_is_equal;
    delay_tag.start_of_frame <= (raster_place_group = 4) and delay_tag_first_column_is_equal;
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
      slice0cost_pixels_first_count_8(i, 0) <= differing(slice0shift_reference(i), slice0shift_search(i, 0), 25) +
        differing(slice0shift_reference(i), slice0shift_search(i, 0), 24);
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
        slice0cost_pixels_first_count_8(i, j) <= differing(slice0shift_search(i, j), slice0shift_reference(i), 25) +
          differing(slice0shift_search(i, j), slice0shift_reference(i), 24);
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 0)
          + slice0cost_pixels_first_count(i, j, 1) + slice0cost_pixels_first_count(i, j, 3) +
          slice0cost_pixels_first_count_8(i, j) + slice0cost_pixels_first_count(i, j, 4) +
          slice0cost_pixels_first_count(i, j, 5) + slice0cost_pixels_first_count(i, j, 7) +
          slice0cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 15 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    slice0cost_ready_words <= slice0cost_read_words;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 15 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag.valid <= slice0cost_ready_tag.valid;
    slice0cost_tag.first_group <= slice0cost_ready_tag.first_group;
    slice0cost_tag.border_column <= slice0cost_ready_tag.border_column;
    slice0cost_tag.first_cost <= slice0cost_ready_tag.first_cost;
    slice0cost_tag.leaves_window <= slice0cost_ready_tag.leaves_window;
    slice0cost_tag.map_column <= slice0cost_ready_tag.map_column;
    slice0cost_tag.output_column <= slice0cost_ready_tag.output_column;
    slice0cost_tag.first_column <= slice0cost_ready_tag.first_column;
    slice0cost_tag.start_of_frame <= slice0cost_ready_tag.start_of_frame;
    slice0cost_tag.end_of_line <= slice0cost_ready_tag.end_of_line;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 1024);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        1024);
    end if;
    if slice0cost_pixels_tag.valid then
      slice0cost_ready_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice0cost_ready_column + 1) mod 1024);
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
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_map_column_0 <= slice0window_change_tag.map_column;
    slice0window_centre_output_column(0) <= slice0window_change_tag.output_column;
    slice0window_centre_first_column(0) <= slice0window_change_tag.first_column;
    slice0window_centre_start_of_frame(0) <= slice0window_change_tag.start_of_frame;
    slice0window_centre_start_of_frame(1 to 2) <= slice0window_centre_start_of_frame(0 to 1);
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    for i in 0 to 15 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 15 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 4096;
      end loop;
      slice0window_centre_output_column(1) <= slice1window_change_tag.output_column;
      slice0window_centre_output_column(2 to 3) <= slice0window_centre_output_column(1 to 2);
      slice0window_centre_first_column(1) <= slice1window_change_tag.first_column;
      slice0window_centre_first_column(2 to 3) <= slice0window_centre_first_column(1 to 2);
    end if;
    if slice0winner2_tag.valid then
      slice0window_centre_start_of_frame(3) <= slice0window_centre_start_of_frame(2);
      slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame(3);
    end if;
    if slice0window_tag.valid then
      slice0window_tag.output_column <= slice1window_centre_output_column(2);
      slice0window_tag.first_column <= slice1window_centre_first_column(2);
    end if;
    -- slice0other
    slice0other_cost_0_all(1) := slice1window_centre_output_column(3) and slice1window_centre_first_column(3);
    for i in 1 to 14 loop
      slice0other_cost_0_choice(i) := choice((slice0window_sum_0(i) - slice0other_cost_0(i - 1)) < 0,
        slice1window_centre_output_column(3), slice0other_cost_0_all(1));
    end loop;
    slice0other_cost_0_all(15) := slice1window_centre_output_column(3) and (((slice0window_sum_0(15) -
      slice0other_cost_0(14)) < 0) or slice1window_centre_first_column(3));
    if slice0window_tag.valid then
      slice0other_winner_0_1 <= slice0other_cost_0_choice(1);
      slice0other_cost_0(0) <= choice(slice1window_centre_output_column(3), slice0window_sum_0(0), 0);
      slice0other_cost_0(1) <= choice(slice0other_cost_0_choice(1), slice0window_sum_0(1), slice0other_cost_0(0));
      slice0other_cost_0(2) <= choice(slice0other_cost_0_choice(2), slice0window_sum_0(2), slice0other_cost_0(1));
      slice0other_winner_0(2) <= choice(slice0other_cost_0_choice(2), 2, as_number(slice0other_winner_0_1));
      for i in 3 to 14 loop
        slice0other_cost_0(i) <= choice(slice0other_cost_0_choice(i), slice0window_sum_0(i), slice0other_cost_0(i - 1));
        slice0other_winner_0(i) <= choice(slice0other_cost_0_choice(i), i, slice0other_winner_0(i - 1));
      end loop;
      slice0other_cost_0(15) <= choice(slice0other_cost_0_all(15), slice0window_sum_0(15), slice0other_cost_0(14));
      slice0other_winner_0(15) <= choice(slice0other_cost_0_all(15), 15, slice0other_winner_0(14));
    end if;
    slice0other_cost_out_0 <= slice0other_cost_0(15);
    slice0other_winner_out_0 <= slice0other_winner_0(15);
    -- slice0winner1
    for i in 0 to 7 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_held_0 <= slice0window_sum_0;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_place_0(1) <= slice0winner1_best_cost_0_is_less(2);
    slice0winner1_best_place_0(2) <= slice0winner1_best_cost_0_is_less(4);
    slice0winner1_best_place_0(3) <= slice0winner1_best_cost_0_is_less(6);
    slice0winner1_best_late_cost_0 <= slice0winner1_best_cost_0;
    for i in 1 to 7 loop slice0winner1_best_but_first_0(i) <= slice0winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice0winner1_best_but_last_0(i) <= slice0winner1_held_0(2 * i); end loop;
    slice0winner1_tag.valid <= slice0window_tag.valid;
    slice0winner1_tag.output_column <= slice0window_tag.output_column;
    slice0winner1_tag.first_column <= slice0window_tag.first_column;
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
    if slice0winner2_tag.valid then slice0winner1_tag.start_of_frame <= slice0window_tag.start_of_frame; end if;
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
      slice0winner2_best_second_0_choice(i, 1) := choice(slice0winner2_best_place_0(i), 4095,
        slice0winner1_best_late_cost_0(2 * i + 1));
      slice0winner2_best_second_0_choice(i, 2) := choice(slice0winner2_best_at_end_0(i),
        slice0winner1_best_but_first_0(2 * i + 1), slice0winner2_best_second_0_choice(i, 1));
      slice0winner2_best_second_0_choice(i, 3) := choice(slice0winner2_best_place_0(i),
        slice0winner1_best_late_cost_0(2 * i), 4095);
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
    slice0winner2_tag.valid <= slice0winner1_tag.valid;
    slice0winner2_tag.output_column <= slice1window_tag.output_column;
    slice0winner2_tag.first_column <= slice1window_tag.first_column;
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
    if slice0winner2_tag.valid then
      slice0winner2_tag.map_column <= slice3window_centre_map_column(2);
      slice0winner2_tag.start_of_frame <= slice0winner1_tag.start_of_frame;
      slice0winner2_tag.end_of_line <= slice3window_centre_end_of_line(2);
    end if;
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
    slice0winner3_tag.output_column <= slice1winner1_tag.output_column;
    slice0winner3_tag.first_column <= slice1winner1_tag.first_column;
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
    slice0winner4_tag.valid <= slice0winner3_tag.valid;
    slice0winner4_tag.map_column <= slice0winner3_tag.map_column;
    slice0winner4_tag.output_column <= slice0winner3_tag.output_column;
    slice0winner4_tag.start_of_frame <= slice0winner3_tag.start_of_frame;
    slice0winner4_tag.end_of_line <= slice0winner3_tag.end_of_line;
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
      slice1cost_pixels_first_count_8(i, 0) <= differing(slice1shift_reference(i), slice1shift_search(i, 0), 25) +
        differing(slice1shift_reference(i), slice1shift_search(i, 0), 24);
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
        slice1cost_pixels_first_count_8(i, j) <= differing(slice1shift_search(i, j), slice1shift_reference(i), 25) +
          differing(slice1shift_search(i, j), slice1shift_reference(i), 24);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 6) + slice1cost_pixels_first_count(i, j, 0)
          + slice1cost_pixels_first_count(i, j, 1) + slice1cost_pixels_first_count(i, j, 3) +
          slice1cost_pixels_first_count_8(i, j) + slice1cost_pixels_first_count(i, j, 4) +
          slice1cost_pixels_first_count(i, j, 5) + slice1cost_pixels_first_count(i, j, 7) +
          slice1cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice0cost_change_column;
    for i in 0 to 15 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    slice1cost_ready_words <= slice1cost_read_words;
    slice1cost_ready_column <= slice1cost_change_column;
    for i in 0 to 15 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    slice1cost_write_column <= slice0cost_write_column;
    if slice0cost_tag.valid then
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
    slice1window_centre_output_column(0) <= slice0window_centre_output_column(0);
    slice1window_centre_output_column(3) <= slice0window_centre_output_column(3);
    slice1window_centre_first_column(0) <= slice0window_centre_first_column(0);
    slice1window_centre_first_column(3) <= slice0window_centre_first_column(3);
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    if slice0window_change_tag.valid then
      slice1window_change_tag.output_column <= slice0window_change_tag.output_column;
      slice1window_change_tag.first_column <= slice0window_change_tag.first_column;
    end if;
    for i in 0 to 15 loop
      slice1window_sum_0_choice(i) := choice(slice1window_change_tag.first_cost, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 15 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 4096;
      end loop;
      slice1window_centre_output_column(1) <= slice2window_change_tag.output_column;
      slice1window_centre_output_column(2) <= slice1window_centre_output_column(1);
      slice1window_centre_first_column(1) <= slice2window_change_tag.first_column;
      slice1window_centre_first_column(2) <= slice1window_centre_first_column(1);
    end if;
    if slice0winner1_tag.valid then
      slice1window_tag.output_column <= slice2window_centre_output_column(2);
      slice1window_tag.first_column <= slice2window_centre_first_column(2);
    end if;
    -- slice1other
    slice1other_cost_0_any(0) := (not slice0winner1_tag.output_column) or (not slice0winner1_tag.first_column);
    slice1other_cost_0_choice(0) := choice((slice1window_sum_0(0) - slice0other_cost_out_0) < 0, not
      slice0winner1_tag.output_column, slice1other_cost_0_any(0));
    for i in 1 to 14 loop
      slice1other_cost_0_choice(i) := choice((slice1window_sum_0(i) - slice1other_cost_0(i - 1)) < 0, not
        slice0winner1_tag.output_column, slice1other_cost_0_any(0));
    end loop;
    slice1other_cost_0_any(15) := (not slice0winner1_tag.output_column) or ((not slice0winner1_tag.first_column) and
      ((slice1window_sum_0(15) - slice1other_cost_0(14)) >= 0));
    if slice0winner1_tag.valid then
      slice1other_cost_0(0) <= choice(slice1other_cost_0_choice(0), slice0other_cost_out_0, slice1window_sum_0(0));
      slice1other_winner_0(0) <= choice(slice1other_cost_0_choice(0), slice0other_winner_out_0, 16);
      for i in 1 to 14 loop
        slice1other_cost_0(i) <= choice(slice1other_cost_0_choice(i), slice1other_cost_0(i - 1), slice1window_sum_0(i));
        slice1other_winner_0(i) <= choice(slice1other_cost_0_choice(i), slice1other_winner_0(i - 1), i + 16);
      end loop;
      slice1other_cost_0(15) <= choice(slice1other_cost_0_any(15), slice1other_cost_0(14), slice1window_sum_0(15));
      slice1other_winner_0(15) <= choice(slice1other_cost_0_any(15), slice1other_winner_0(14), 31);
    end if;
    slice1other_cost_out_0 <= slice1other_cost_0(15);
    slice1other_winner_out_0 <= slice1other_winner_0(15);
    -- slice1winner1
    for i in 0 to 7 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_held_0 <= slice1window_sum_0;
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_place_0(1) <= slice1winner1_best_cost_0_is_less(2);
    slice1winner1_best_place_0(2) <= slice1winner1_best_cost_0_is_less(4);
    slice1winner1_best_place_0(3) <= slice1winner1_best_cost_0_is_less(6);
    slice1winner1_best_late_cost_0 <= slice1winner1_best_cost_0;
    for i in 0 to 7 loop slice1winner1_best_but_first_0(i) <= slice1winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice1winner1_best_but_last_0(i) <= slice1winner1_held_0(2 * i); end loop;
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
    if slice0winner2_tag.valid then
      slice1winner1_tag.output_column <= slice3window_centre_output_column(2);
      slice1winner1_tag.first_column <= slice3window_centre_first_column(2);
    end if;
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
      slice1winner2_best_second_0_choice(i, 1) := choice(slice1winner2_best_place_0(i), 4095,
        slice1winner1_best_late_cost_0(2 * i + 1));
      slice1winner2_best_second_0_choice(i, 2) := choice(slice1winner2_best_at_end_0(i),
        slice1winner1_best_but_first_0(2 * i + 1), slice1winner2_best_second_0_choice(i, 1));
      slice1winner2_best_second_0_choice(i, 3) := choice(slice1winner2_best_place_0(i),
        slice1winner1_best_late_cost_0(2 * i), 4095);
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
    slice2shift_search_out(0) <= slice2shift_search(0, 15);
    slice2shift_search_out(1) <= slice2shift_search(1, 15);
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
      slice2cost_pixels_first_count_8(i, 0) <= differing(slice2shift_reference(i), slice2shift_search(i, 0), 25) +
        differing(slice2shift_reference(i), slice2shift_search(i, 0), 24);
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
        slice2cost_pixels_first_count_8(i, j) <= differing(slice2shift_search(i, j), slice2shift_reference(i), 25) +
          differing(slice2shift_search(i, j), slice2shift_reference(i), 24);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 6) + slice2cost_pixels_first_count(i, j, 0)
          + slice2cost_pixels_first_count(i, j, 1) + slice2cost_pixels_first_count(i, j, 3) +
          slice2cost_pixels_first_count_8(i, j) + slice2cost_pixels_first_count(i, j, 4) +
          slice2cost_pixels_first_count(i, j, 5) + slice2cost_pixels_first_count(i, j, 7) +
          slice2cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice2cost_read_column <= slice1cost_read_column;
    for i in 0 to 15 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    slice2cost_ready_words <= slice2cost_read_words;
    for i in 0 to 15 loop slice2cost_column_0(i) <= slice2cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice2cost_change_column <= slice2cost_read_column; end if;
    if slice0cost_tag.valid then slice2cost_ready_column <= slice1cost_ready_column; end if;
    if slice0window_entering_tag.valid then
      slice2cost_write_column <= slice1cost_write_column;
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
    slice2window_change_tag.first_cost <= slice1window_change_tag.first_cost;
    slice2window_change_tag.leaves_window <= slice1window_change_tag.leaves_window;
    slice2window_centre_map_column_0 <= slice1window_centre_map_column_0;
    slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
    if slice0window_tag.valid then
      slice2window_change_tag.output_column <= slice0window_centre_output_column(0);
      slice2window_change_tag.first_column <= slice0window_centre_first_column(0);
    end if;
    for i in 0 to 15 loop
      slice2window_sum_0_choice(i) := choice(slice2window_change_tag.first_cost, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag.valid then
      for i in 0 to 15 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 4096;
      end loop;
      slice2window_centre_output_column(0) <= slice1window_centre_output_column(0);
      slice2window_centre_output_column(1 to 2) <= slice2window_centre_output_column(0 to 1);
      slice2window_centre_first_column(0) <= slice1window_centre_first_column(0);
      slice2window_centre_first_column(1 to 2) <= slice2window_centre_first_column(0 to 1);
    end if;
    -- slice2other
    slice2other_cost_0_any(0) := (not slice0winner2_tag.output_column) or (not slice0winner2_tag.first_column);
    slice2other_cost_0_choice(0) := choice((slice2window_sum_0(0) - slice1other_cost_out_0) < 0, not
      slice0winner2_tag.output_column, slice2other_cost_0_any(0));
    for i in 1 to 14 loop
      slice2other_cost_0_choice(i) := choice((slice2window_sum_0(i) - slice2other_cost_0(i - 1)) < 0, not
        slice0winner2_tag.output_column, slice2other_cost_0_any(0));
    end loop;
    slice2other_cost_0_any(15) := (not slice0winner2_tag.output_column) or ((not slice0winner2_tag.first_column) and
      ((slice2window_sum_0(15) - slice2other_cost_0(14)) >= 0));
    if slice0winner2_tag.valid then
      slice2other_cost_0(0) <= choice(slice2other_cost_0_choice(0), slice1other_cost_out_0, slice2window_sum_0(0));
      slice2other_winner_0(0) <= choice(slice2other_cost_0_choice(0), slice1other_winner_out_0, 32);
      for i in 1 to 14 loop
        slice2other_cost_0(i) <= choice(slice2other_cost_0_choice(i), slice2other_cost_0(i - 1), slice2window_sum_0(i));
        slice2other_winner_0(i) <= choice(slice2other_cost_0_choice(i), slice2other_winner_0(i - 1), i + 32);
      end loop;
      slice2other_cost_0(15) <= choice(slice2other_cost_0_any(15), slice2other_cost_0(14), slice2window_sum_0(15));
      slice2other_winner_0(15) <= choice(slice2other_cost_0_any(15), slice2other_winner_0(14), 47);
    end if;
    slice2other_cost_out_0 <= slice2other_cost_0(15);
    slice2other_winner_out_0 <= slice2other_winner_0(15);
    -- slice2winner1
    for i in 0 to 7 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
    end loop;
    slice2winner1_held_0 <= slice2window_sum_0;
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    slice2winner1_best_place_0(1) <= slice2winner1_best_cost_0_is_less(2);
    slice2winner1_best_place_0(2) <= slice2winner1_best_cost_0_is_less(4);
    slice2winner1_best_place_0(3) <= slice2winner1_best_cost_0_is_less(6);
    slice2winner1_best_late_cost_0 <= slice2winner1_best_cost_0;
    for i in 0 to 7 loop slice2winner1_best_but_first_0(i) <= slice2winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice2winner1_best_but_last_0(i) <= slice2winner1_held_0(2 * i); end loop;
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
      slice2winner2_best_second_0_choice(i, 1) := choice(slice2winner2_best_place_0(i), 4095,
        slice2winner1_best_late_cost_0(2 * i + 1));
      slice2winner2_best_second_0_choice(i, 2) := choice(slice2winner2_best_at_end_0(i),
        slice2winner1_best_but_first_0(2 * i + 1), slice2winner2_best_second_0_choice(i, 1));
      slice2winner2_best_second_0_choice(i, 3) := choice(slice2winner2_best_place_0(i),
        slice2winner1_best_late_cost_0(2 * i), 4095);
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
    slice2winner2_best_last_0(3) <= slice2winner1_held_0(15);
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
    for i in 0 to 3 loop
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
    slice2winner3_best_last_0(0) <= slice2winner2_best_last_0(1);
    slice2winner3_best_last_0(1) <= slice2winner2_best_last_0(3);
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
    slice2winner3_best_but_last_0(0) <= smaller(slice2winner2_best_but_last_0(1), slice2winner2_best_late_cost_0(0));
    slice2winner3_best_but_last_0(1) <= smaller(slice2winner2_best_but_last_0(3), slice2winner2_best_late_cost_0(2));
    -- slice2winner4
    slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0(1) = 8;
    slice2winner4_best_below_0_0_choice := choice(slice2winner4_best_below_0_0_is_equal, slice2winner3_best_last_0(0),
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
      slice2winner3_best_but_last_0(0), slice2winner4_best_second_0_0_choices(3));
    slice2winner4_best_first_0_0 <= slice2winner3_best_first_0(0);
    slice2winner4_best_last_0_0 <= slice2winner3_best_last_0(1);
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
    slice2winner4_best_but_last_0_0 <= smaller(slice2winner3_best_but_last_0(1), slice2winner3_best_late_cost_0(0));
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
    slice2_best_last_0_0 <= slice2winner4_best_last_0_0;
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
    slice2_best_but_last_0_0 <= smaller(slice2winner4_best_but_last_0_0, slice1_best_late_cost_0_0);
    -- slice3shift
    if slice0cost_pixels_tag.valid then
      for i in 0 to 1 loop
        slice3shift_search(i, 0) <= slice2shift_search_out(i);
        for j in 1 to 15 loop slice3shift_search(i, j) <= slice3shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    -- slice3cost
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice3cost_column_0_choice(4 * i + j, 1) := choice(slice0window_change_tag.first_group, 0,
          to_integer(slice3cost_ready_words(i)(8 * j + 7 downto 8 * j)));
        slice3cost_column_0_choice(4 * i + j, 2) := choice(slice0window_change_tag.border_column, 0,
          (slice3cost_change_0(4 * i + j) + slice3cost_column_0_choice(4 * i + j, 1)) mod 256);
      end loop;
    end loop;
    for i in 0 to 1 loop
      slice3cost_pixels_first_count(i, 0, 0) <= differing(slice3shift_search(i, 0), slice3shift_reference(i), 0) +
        differing(slice3shift_reference(i), slice3shift_search(i, 0), 2) + differing(slice3shift_reference(i),
        slice3shift_search(i, 0), 1);
      slice3cost_pixels_first_count(i, 0, 1) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 3, 5, 4);
      slice3cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, 0) mod 256), 8)) xor
        (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + differing(slice3shift_reference(i),
        slice3shift_search(i, 0), 8) + differing(slice3shift_reference(i), slice3shift_search(i, 0), 6);
      for j in 3 to 7 loop
        slice3cost_pixels_first_count(i, 0, j) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 3 * j,
          3 * j + 2, 3 * j + 1);
      end loop;
      slice3cost_pixels_first_count_8(i, 0) <= differing(slice3shift_reference(i), slice3shift_search(i, 0), 25) +
        differing(slice3shift_reference(i), slice3shift_search(i, 0), 24);
      for j in 1 to 15 loop
        slice3cost_pixels_first_count(i, j, 0) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 0, 2,
          1);
        slice3cost_pixels_first_count(i, j, 1) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 3, 5,
          4);
        slice3cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, j) mod 256), 8)) xor
          (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + differing(slice3shift_search(i, j),
          slice3shift_reference(i), 8) + differing(slice3shift_search(i, j), slice3shift_reference(i), 6);
        for k in 3 to 7 loop
          slice3cost_pixels_first_count(i, j, k) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 3 *
            k, 3 * k + 2, 3 * k + 1);
        end loop;
        slice3cost_pixels_first_count_8(i, j) <= differing(slice3shift_search(i, j), slice3shift_reference(i), 25) +
          differing(slice3shift_search(i, j), slice3shift_reference(i), 24);
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice3cost_pixels_cost(i, j) <= slice3cost_pixels_first_count(i, j, 6) + slice3cost_pixels_first_count(i, j, 0)
          + slice3cost_pixels_first_count(i, j, 1) + slice3cost_pixels_first_count(i, j, 3) +
          slice3cost_pixels_first_count_8(i, j) + slice3cost_pixels_first_count(i, j, 4) +
          slice3cost_pixels_first_count(i, j, 5) + slice3cost_pixels_first_count(i, j, 7) +
          slice3cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice3cost_change_column <= slice3cost_read_column;
    for i in 0 to 15 loop
      slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
    end loop;
    slice3cost_ready_words <= slice3cost_read_words;
    slice3cost_ready_column <= slice3cost_change_column;
    for i in 0 to 15 loop slice3cost_column_0(i) <= slice3cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then
      slice3cost_read_column <= choice(slice0cost_ready_tag.row_start, 0, (slice3cost_read_column + 1) mod 1024);
    end if;
    if slice0window_change_tag.valid then
      slice3cost_write_column <= slice3cost_ready_column;
      for i in 0 to 3 loop
        slice3cost_write_words(i) <= to_unsigned(slice3cost_column_0_choice(4 * i + 3, 2), 8) &
          to_unsigned(slice3cost_column_0_choice(4 * i + 2, 2), 8) & to_unsigned(slice3cost_column_0_choice(4 * i + 1,
          2), 8) & to_unsigned(slice3cost_column_0_choice(4 * i, 2), 8);
      end loop;
    end if;
    -- slice3window
    if slice0window_tag.valid then
      slice3window_ring_write_address <= slice3window_ring_read_address;
      slice3window_ring_read_address <= choice(slice3window_ring_read_address = 9, 0, (slice3window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 3 loop
        slice3window_change_0_choice(4 * i + j) := choice(slice2window_change_tag.leaves_window,
          to_integer(slice3window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice3window_entering_0 <= slice3cost_column_0;
    for i in 0 to 15 loop
      slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
    end loop;
    slice3window_change_tag.first_cost <= slice2window_change_tag.first_cost;
    slice3window_change_tag.output_column <= slice1window_centre_output_column(0);
    slice3window_change_tag.first_column <= slice1window_centre_first_column(0);
    for i in 0 to 15 loop
      slice3window_sum_0_choice(i) := choice(slice3window_change_tag.first_cost, 0, slice3window_sum_0(i));
    end loop;
    if slice0winner2_tag.valid then
      for i in 0 to 15 loop
        slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 4096;
      end loop;
      slice3window_centre_map_column(0) <= slice2window_centre_map_column_0;
      slice3window_centre_map_column(1 to 2) <= slice3window_centre_map_column(0 to 1);
      slice3window_centre_output_column(0) <= slice3window_change_tag.output_column;
      slice3window_centre_output_column(1 to 2) <= slice3window_centre_output_column(0 to 1);
      slice3window_centre_first_column(0) <= slice3window_change_tag.first_column;
      slice3window_centre_first_column(1 to 2) <= slice3window_centre_first_column(0 to 1);
      slice3window_centre_end_of_line(0) <= slice2window_centre_end_of_line_0;
      slice3window_centre_end_of_line(1 to 2) <= slice3window_centre_end_of_line(0 to 1);
    end if;
    -- slice3other
    slice3other_cost_0_0_any := (not slice0winner3_tag.output_column) or (not slice0winner3_tag.first_column);
    slice3other_cost_0_choice(0) := choice((slice3window_sum_0(0) - slice2other_cost_out_0) < 0, not
      slice0winner3_tag.output_column, slice3other_cost_0_0_any);
    for i in 1 to 14 loop
      slice3other_cost_0_choice(i) := choice((slice3window_sum_0(i) - slice3other_cost_0(i - 1)) < 0, not
        slice0winner3_tag.output_column, slice3other_cost_0_0_any);
    end loop;
    if slice0winner3_tag.valid then
      slice3other_cost_0(0) <= choice(slice3other_cost_0_choice(0), slice2other_cost_out_0, slice3window_sum_0(0));
      slice3other_winner_0(0) <= choice(slice3other_cost_0_choice(0), slice2other_winner_out_0, 48);
      for i in 1 to 14 loop
        slice3other_cost_0(i) <= choice(slice3other_cost_0_choice(i), slice3other_cost_0(i - 1), slice3window_sum_0(i));
        slice3other_winner_0(i) <= choice(slice3other_cost_0_choice(i), slice3other_winner_0(i - 1), i + 48);
      end loop;
      slice3other_winner_0(15) <= choice((not slice0winner3_tag.output_column) or ((not slice0winner3_tag.first_column)
        and ((slice3window_sum_0(15) - slice3other_cost_0(14)) >= 0)), slice3other_winner_0(14), 63);
    end if;
    slice3other_winner_out_0 <= slice3other_winner_0(15);
    -- slice3winner1
    for i in 0 to 7 loop
      slice3winner1_best_cost_0_is_less(i) := (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0;
    end loop;
    slice3winner1_held_0 <= slice3window_sum_0;
    slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_is_less(0);
    slice3winner1_best_place_0(1) <= slice3winner1_best_cost_0_is_less(2);
    slice3winner1_best_place_0(2) <= slice3winner1_best_cost_0_is_less(4);
    slice3winner1_best_place_0(3) <= slice3winner1_best_cost_0_is_less(6);
    slice3winner1_best_late_cost_0 <= slice3winner1_best_cost_0;
    for i in 0 to 7 loop slice3winner1_best_but_first_0(i) <= slice3winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 6 loop slice3winner1_best_but_last_0(i) <= slice3winner1_held_0(2 * i); end loop;
    slice3winner1_best_cost_0(0) <= choice(slice3winner1_best_cost_0_is_less(0), slice3window_sum_0(1),
      slice3window_sum_0(0));
    for i in 0 to 6 loop
      slice3winner1_best_below_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), slice3window_sum_0(2 * i), 0);
      slice3winner1_best_above_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), 0, slice3window_sum_0(2 * i + 1));
      slice3winner1_best_cost_0(i + 1) <= choice(slice3winner1_best_cost_0_is_less(i + 1), slice3window_sum_0(2 * i +
        3), slice3window_sum_0(2 * i + 2));
      slice3winner1_best_index_0(i + 1) <= choice(slice3winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice3winner1_best_below_0(7) <= choice(slice3winner1_best_cost_0_is_less(7), slice3window_sum_0(14), 0);
    slice3winner1_best_above_0(7) <= choice(slice3winner1_best_cost_0_is_less(7), 0, slice3window_sum_0(15));
    -- slice3winner2
    for i in 0 to 3 loop
      slice3winner2_best_cost_0_is_less(i) := (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner2_best_below_0_is_equal(0) := slice3winner1_best_index_0(1) = 2;
    slice3winner2_best_below_0_choice(0) := choice(slice3winner2_best_below_0_is_equal(0), slice3winner1_held_0(1),
      slice3winner1_best_below_0(1));
    slice3winner2_best_below_0_is_equal(1) := slice3winner1_best_index_0(3) = 6;
    slice3winner2_best_below_0_choice(1) := choice(slice3winner2_best_below_0_is_equal(1), slice3winner1_held_0(5),
      slice3winner1_best_below_0(3));
    slice3winner2_best_below_0_is_equal(2) := (slice3winner1_best_index_0(5) mod 4) = 2;
    slice3winner2_best_below_0_choice(2) := choice(is_set(slice3winner1_best_index_0(5), 3) and
      slice3winner2_best_below_0_is_equal(2), slice3winner1_held_0(9), slice3winner1_best_below_0(5));
    slice3winner2_best_below_0_is_equal(3) := slice3winner1_best_index_0(7) = 14;
    slice3winner2_best_below_0_choice(3) := choice(slice3winner2_best_below_0_is_equal(3), slice3winner1_held_0(13),
      slice3winner1_best_below_0(7));
    slice3winner2_best_above_0_choice(0) := choice(slice3winner1_best_index_0_0, slice3winner1_held_0(2),
      slice3winner1_best_above_0(0));
    for i in 1 to 3 loop
      slice3winner2_best_above_0_choice(i) := choice(slice3winner1_best_place_0(i), slice3winner1_held_0(4 * i + 2),
        slice3winner1_best_above_0(2 * i));
    end loop;
    for i in 0 to 3 loop
      slice3winner2_best_second_0_choice(i, 1) := choice(slice3winner2_best_place_0(i), 4095,
        slice3winner1_best_late_cost_0(2 * i + 1));
      slice3winner2_best_second_0_choice(i, 2) := choice(slice3winner2_best_at_end_0(i),
        slice3winner1_best_but_first_0(2 * i + 1), slice3winner2_best_second_0_choice(i, 1));
      slice3winner2_best_second_0_choice(i, 3) := choice(slice3winner2_best_place_0(i),
        slice3winner1_best_late_cost_0(2 * i), 4095);
      slice3winner2_best_second_0_choice(i, 4) := choice(slice3winner2_best_at_start_0(i),
        slice3winner1_best_but_last_0(2 * i), slice3winner2_best_second_0_choice(i, 3));
    end loop;
    slice3winner2_best_first_0(0) <= slice3winner1_held_0(0);
    slice3winner2_best_first_0(1) <= slice3winner1_held_0(4);
    slice3winner2_best_first_0(2) <= slice3winner1_held_0(8);
    slice3winner2_best_first_0(3) <= slice3winner1_held_0(12);
    slice3winner2_best_last_0(0) <= slice3winner1_held_0(3);
    slice3winner2_best_last_0(1) <= slice3winner1_held_0(7);
    slice3winner2_best_last_0(2) <= slice3winner1_held_0(11);
    slice3winner2_best_place_0 <= slice3winner2_best_cost_0_is_less;
    slice3winner2_best_at_start_0(0) <= slice3winner2_best_cost_0_is_less(0) and slice3winner2_best_below_0_is_equal(0);
    slice3winner2_best_at_start_0(1) <= slice3winner2_best_cost_0_is_less(1) and slice3winner2_best_below_0_is_equal(1);
    slice3winner2_best_at_start_0(2) <= slice3winner2_best_cost_0_is_less(2) and is_set(slice3winner1_best_index_0(5),
      3) and slice3winner2_best_below_0_is_equal(2);
    slice3winner2_best_at_start_0(3) <= slice3winner2_best_below_0_is_equal(3) and slice3winner2_best_cost_0_is_less(3);
    slice3winner2_best_at_end_0(0) <= slice3winner1_best_index_0_0 and ((slice3winner1_best_cost_0(1) -
      slice3winner1_best_cost_0(0)) >= 0);
    for i in 1 to 3 loop
      slice3winner2_best_at_end_0(i) <= slice3winner1_best_place_0(i) and ((slice3winner1_best_cost_0(2 * i + 1) -
        slice3winner1_best_cost_0(2 * i)) >= 0);
    end loop;
    slice3winner2_best_late_cost_0 <= slice3winner2_best_cost_0;
    slice3winner2_best_cost_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_cost_0(1),
      slice3winner1_best_cost_0(0));
    slice3winner2_best_index_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_index_0(1),
      as_number(slice3winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice3winner2_best_below_0(i) <= choice(slice3winner2_best_cost_0_is_less(i),
        slice3winner2_best_below_0_choice(i), slice3winner1_best_below_0(2 * i));
      slice3winner2_best_above_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_above_0(2 * i +
        1), slice3winner2_best_above_0_choice(i));
      slice3winner2_best_cost_0(i + 1) <= choice(slice3winner2_best_cost_0_is_less(i + 1), slice3winner1_best_cost_0(2
        * i + 3), slice3winner1_best_cost_0(2 * i + 2));
      slice3winner2_best_index_0(i + 1) <= choice(slice3winner2_best_cost_0_is_less(i + 1),
        slice3winner1_best_index_0(2 * i + 3), slice3winner1_best_index_0(2 * i + 2));
    end loop;
    slice3winner2_best_below_0(3) <= choice(slice3winner2_best_cost_0_is_less(3), slice3winner2_best_below_0_choice(3),
      slice3winner1_best_below_0(6));
    slice3winner2_best_above_0(3) <= choice(slice3winner2_best_cost_0_is_less(3), slice3winner1_best_above_0(7),
      slice3winner2_best_above_0_choice(3));
    for i in 0 to 3 loop
      slice3winner2_best_second_0(i) <= smaller(slice3winner2_best_second_0_choice(i, 2),
        slice3winner2_best_second_0_choice(i, 4));
    end loop;
    for i in 0 to 3 loop
      slice3winner2_best_but_first_0(i) <= smaller(slice3winner1_best_late_cost_0(2 * i + 1),
        slice3winner1_best_but_first_0(2 * i));
    end loop;
    for i in 0 to 2 loop
      slice3winner2_best_but_last_0(i) <= smaller(slice3winner1_best_but_last_0(2 * i + 1),
        slice3winner1_best_late_cost_0(2 * i));
    end loop;
    -- slice3winner3
    slice3winner3_best_cost_0_is_less(0) := (slice3winner2_best_cost_0(1) - slice3winner2_best_cost_0(0)) < 0;
    slice3winner3_best_cost_0_is_less(1) := (slice3winner2_best_cost_0(3) - slice3winner2_best_cost_0(2)) < 0;
    slice3winner3_best_below_0_is_equal(0) := slice3winner2_best_index_0(1) = 4;
    slice3winner3_best_below_0_choice(0) := choice(slice3winner3_best_below_0_is_equal(0),
      slice3winner2_best_last_0(0), slice3winner2_best_below_0(1));
    slice3winner3_best_below_0_is_equal(1) := slice3winner2_best_index_0(3) = 12;
    slice3winner3_best_below_0_choice(1) := choice(slice3winner3_best_below_0_is_equal(1),
      slice3winner2_best_last_0(2), slice3winner2_best_below_0(3));
    slice3winner3_best_above_0_is_equal(0) := slice3winner2_best_index_0(0) = 3;
    slice3winner3_best_above_0_choice(0) := choice(slice3winner3_best_above_0_is_equal(0),
      slice3winner2_best_first_0(1), slice3winner2_best_above_0(0));
    slice3winner3_best_above_0_is_equal(1) := (slice3winner2_best_index_0(2) mod 4) = 3;
    slice3winner3_best_above_0_choice(1) := choice(is_set(slice3winner2_best_index_0(2), 3) and
      slice3winner3_best_above_0_is_equal(1), slice3winner2_best_first_0(3), slice3winner2_best_above_0(2));
    for i in 0 to 1 loop
      slice3winner3_best_second_0_choice(i, 1) := choice(slice3winner3_best_place_0(i), slice3winner2_best_second_0(2 *
        i + 1), slice3winner2_best_late_cost_0(2 * i + 1));
      slice3winner3_best_second_0_choice(i, 2) := choice(slice3winner3_best_at_end_0(i),
        slice3winner2_best_but_first_0(2 * i + 1), slice3winner3_best_second_0_choice(i, 1));
      slice3winner3_best_second_0_choice(i, 3) := choice(slice3winner3_best_place_0(i),
        slice3winner2_best_late_cost_0(2 * i), slice3winner2_best_second_0(2 * i));
      slice3winner3_best_second_0_choice(i, 4) := choice(slice3winner3_best_at_start_0(i),
        slice3winner2_best_but_last_0(2 * i), slice3winner3_best_second_0_choice(i, 3));
    end loop;
    slice3winner3_best_first_0(0) <= slice3winner2_best_first_0(0);
    slice3winner3_best_first_0(1) <= slice3winner2_best_first_0(2);
    slice3winner3_best_last_0_0 <= slice3winner2_best_last_0(1);
    slice3winner3_best_place_0 <= slice3winner3_best_cost_0_is_less;
    slice3winner3_best_at_start_0(0) <= slice3winner3_best_cost_0_is_less(0) and slice3winner3_best_below_0_is_equal(0);
    slice3winner3_best_at_start_0(1) <= slice3winner3_best_below_0_is_equal(1) and slice3winner3_best_cost_0_is_less(1);
    slice3winner3_best_at_end_0(0) <= ((slice3winner2_best_cost_0(1) - slice3winner2_best_cost_0(0)) >= 0) and
      slice3winner3_best_above_0_is_equal(0);
    slice3winner3_best_at_end_0(1) <= ((slice3winner2_best_cost_0(3) - slice3winner2_best_cost_0(2)) >= 0) and
      is_set(slice3winner2_best_index_0(2), 3) and slice3winner3_best_above_0_is_equal(1);
    slice3winner3_best_late_cost_0 <= slice3winner3_best_cost_0;
    for i in 0 to 1 loop
      slice3winner3_best_cost_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_cost_0(2 * i +
        1), slice3winner2_best_cost_0(2 * i));
      slice3winner3_best_index_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_index_0(2 * i +
        1), slice3winner2_best_index_0(2 * i));
      slice3winner3_best_below_0(i) <= choice(slice3winner3_best_cost_0_is_less(i),
        slice3winner3_best_below_0_choice(i), slice3winner2_best_below_0(2 * i));
      slice3winner3_best_above_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_above_0(2 * i +
        1), slice3winner3_best_above_0_choice(i));
    end loop;
    slice3winner3_best_second_0(0) <= smaller(slice3winner3_best_second_0_choice(0, 2),
      slice3winner3_best_second_0_choice(0, 4));
    slice3winner3_best_second_0(1) <= smaller(slice3winner3_best_second_0_choice(1, 2),
      slice3winner3_best_second_0_choice(1, 4));
    slice3winner3_best_but_first_0(0) <= smaller(slice3winner2_best_late_cost_0(1), slice3winner2_best_but_first_0(0));
    slice3winner3_best_but_first_0(1) <= smaller(slice3winner2_best_late_cost_0(3), slice3winner2_best_but_first_0(2));
    slice3winner3_best_but_last_0_0 <= smaller(slice3winner2_best_but_last_0(1), slice3winner2_best_late_cost_0(0));
    -- slice3winner4
    slice3winner4_best_cost_0_0_is_less := (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0;
    slice3winner4_best_below_0_0_is_equal := slice3winner3_best_index_0(1) = 8;
    slice3winner4_best_below_0_0_choice := choice(slice3winner4_best_below_0_0_is_equal, slice3winner3_best_last_0_0,
      slice3winner3_best_below_0(1));
    slice3winner4_best_above_0_0_is_equal := slice3winner3_best_index_0(0) = 7;
    slice3winner4_best_above_0_0_choice := choice(slice3winner4_best_above_0_0_is_equal, slice3winner3_best_first_0(1),
      slice3winner3_best_above_0(0));
    slice3winner4_best_second_0_0_choices(1) := choice(slice3winner4_best_place_0_0, slice3winner3_best_second_0(1),
      slice3winner3_best_late_cost_0(1));
    slice3winner4_best_second_0_0_choices(2) := choice(slice3winner4_best_at_end_0_0,
      slice3winner3_best_but_first_0(1), slice3winner4_best_second_0_0_choices(1));
    slice3winner4_best_second_0_0_choices(3) := choice(slice3winner4_best_place_0_0, slice3winner3_best_late_cost_0(0),
      slice3winner3_best_second_0(0));
    slice3winner4_best_second_0_0_choices(4) := choice(slice3winner4_best_at_start_0_0,
      slice3winner3_best_but_last_0_0, slice3winner4_best_second_0_0_choices(3));
    slice3winner4_best_first_0_0 <= slice3winner3_best_first_0(0);
    slice3winner4_best_place_0_0 <= slice3winner4_best_cost_0_0_is_less;
    slice3winner4_best_at_start_0_0 <= slice3winner4_best_below_0_0_is_equal and slice3winner4_best_cost_0_0_is_less;
    slice3winner4_best_at_end_0_0 <= ((slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) >= 0) and
      slice3winner4_best_above_0_0_is_equal;
    slice3winner4_best_late_cost_0_0 <= slice3winner4_best_cost_0_0;
    slice3winner4_best_cost_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner3_best_cost_0(1),
      slice3winner3_best_cost_0(0));
    slice3winner4_best_index_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner3_best_index_0(1),
      slice3winner3_best_index_0(0));
    slice3winner4_best_below_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner4_best_below_0_0_choice,
      slice3winner3_best_below_0(0));
    slice3winner4_best_above_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner3_best_above_0(1),
      slice3winner4_best_above_0_0_choice);
    slice3winner4_best_second_0_0 <= smaller(slice3winner4_best_second_0_0_choices(2),
      slice3winner4_best_second_0_0_choices(4));
    slice3winner4_best_but_first_0_0 <= smaller(slice3winner3_best_late_cost_0(1), slice3winner3_best_but_first_0(0));
    -- slice3
    slice3_best_cost_0_0_is_less := (slice3winner4_best_cost_0_0 - slice2_best_cost_0_0) < 0;
    slice3_best_below_0_0_is_equal := slice3winner4_best_index_0_0 = 0;
    slice3_best_below_0_0_choice := choice(slice3_best_below_0_0_is_equal, slice2_best_last_0_0,
      slice3winner4_best_below_0_0);
    slice3_best_above_0_0_is_equal := slice2_best_index_0_0 = 47;
    slice3_best_above_0_0_choice := choice(slice3_best_above_0_0_is_equal, slice3winner4_best_first_0_0,
      slice2_best_above_0_0);
    slice3_best_second_0_0_choices(1) := choice(slice3_best_place_0_0, slice3winner4_best_second_0_0,
      slice3winner4_best_late_cost_0_0);
    slice3_best_second_0_0_choices(2) := choice(slice3_best_at_end_0_0, slice3winner4_best_but_first_0_0,
      slice3_best_second_0_0_choices(1));
    slice3_best_second_0_0_choices(3) := choice(slice3_best_place_0_0, slice2_best_late_cost_0_0,
      slice2_best_second_0_0);
    slice3_best_second_0_0_choices(4) := choice(slice3_best_at_start_0_0, slice2_best_but_last_0_0,
      slice3_best_second_0_0_choices(3));
    slice3_best_place_0_0 <= slice3_best_cost_0_0_is_less;
    slice3_best_at_start_0_0 <= slice3_best_below_0_0_is_equal and slice3_best_cost_0_0_is_less;
    slice3_best_at_end_0_0 <= ((slice3winner4_best_cost_0_0 - slice2_best_cost_0_0) >= 0) and
      slice3_best_above_0_0_is_equal;
    slice3_best_late_cost_0_0 <= slice3_best_cost_0_0;
    slice3_best_tag <= slice2_best_tag;
    slice3_best_cost_0_0 <= choice(slice3_best_cost_0_0_is_less, slice3winner4_best_cost_0_0, slice2_best_cost_0_0);
    slice3_best_index_0_0 <= choice(slice3_best_cost_0_0_is_less, slice3winner4_best_index_0_0 + 48,
      slice2_best_index_0_0);
    slice3_best_below_0_0 <= choice(slice3_best_cost_0_0_is_less, slice3_best_below_0_0_choice, slice2_best_below_0_0);
    slice3_best_above_0_0 <= choice(slice3_best_cost_0_0_is_less, slice3winner4_best_above_0_0,
      slice3_best_above_0_0_choice);
    slice3_best_second_0_0 <= smaller(slice3_best_second_0_0_choices(2), slice3_best_second_0_0_choices(4));
    -- refinement
    refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 8192) - refinement_divisor_0(0);
    for i in 2 to 7 loop
      refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 8192) - refinement_divisor_0(i -
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
    refinement_disparity_0(0) <= slice3_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= true;
    refinement_passed_0(1 to 2) <= refinement_passed_0(0 to 1);
    refinement_passed_0(4 to 11) <= refinement_passed_0(3 to 10);
    refinement_tag_valid(0) <= slice3_best_tag.valid;
    refinement_tag_map_column(0) <= slice3_best_tag.map_column;
    refinement_tag_output_column(0) <= slice3_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= slice3_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= slice3_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_alone_0(0) <= slice3_best_second_0_0 = 4095;
    refinement_alone_0(1) <= refinement_alone_0(0);
    refinement_gap_0 <= (slice3_best_second_0_0 - slice3_best_late_cost_0_0) mod 4096;
    refinement_lowest_0 <= slice3_best_late_cost_0_0;
    refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
    refinement_scaled_cost_0 <= refinement_lowest_0;
    refinement_u_0 <= (refinement_below_0 - slice3_best_late_cost_0_0) mod 4096;
    refinement_v_0 <= (refinement_above_0 - slice3_best_late_cost_0_0) mod 4096;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 12)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 12))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((8192 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 4096) +
      ((other_3 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
    refinement_passed_0(3) <= choice(refinement_alone_0(1), refinement_passed_0(2), refinement_passed_0(2) and
      ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0));
    refinement_below_0 <= choice(slice3_best_index_0_0 = 0, slice3_best_above_0_0, slice3_best_below_0_0);
    refinement_above_0 <= choice(slice3_best_index_0_0 = 63, slice3_best_below_0_0, slice3_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 13),
      refinement_remainder_1_0_difference mod 4096, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 13),
        refinement_remainder_0_difference(i) mod 4096, (refinement_remainder_0(i - 1) mod 2048) * 2);
    end loop;
    -- leftright
    leftright_holds_winners_choice := choice((not is_set(leftright_ring_read_address, 5)) and
      ((leftright_ring_read_address mod 8) = 0), (not leftright_holds_winners) and (is_set(leftright_ring_read_address,
      4) or is_set(leftright_ring_read_address, 3)), not leftright_holds_winners);
    leftright_address_0_value := to_integer(leftright_held_0(9 downto 4));
    leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
    leftright_checked_tag_row_start_differs := map_counter_group /= 481;
    leftright_checked_tag_row_start_is_equals(1) := map_counter_column = 575;
    leftright_checked_tag_row_start_choices(1) := choice(leftright_checked_tag_row_start_is_equals(1),
      leftright_checked_tag.row_start and (map_counter_group /= 480), leftright_checked_tag.row_start);
    leftright_checked_tag_row_start_choices(2) := choice(leftright_checked_tag_row_start_differs,
      leftright_checked_tag_row_start_choices(1), leftright_checked_tag.row_start);
    leftright_checked_tag_row_start_is_equals(2) := map_counter_group = 479;
    leftright_checked_tag_row_start_alls(1) := leftright_checked_tag_row_start_is_equals(2) and
      leftright_checked_tag_row_start_is_equals(1);
    leftright_checked_tag_row_start_choices(3) := choice(leftright_checked_tag_row_start_choices(2), (not
      leftright_checked_tag.start_of_frame) or leftright_checked_tag_row_start_alls(1),
      leftright_checked_tag.start_of_frame and leftright_checked_tag_row_start_is_equals(2) and
      leftright_checked_tag_row_start_is_equals(1));
    leftright_checked_tag_row_start_alls(2) := leftright_checked_tag.valid and leftright_checked_tag.map_column;
    leftright_other_0(1) <= slice3other_winner_out_0;
    leftright_other_0(2 to 15) <= leftright_other_0(1 to 14);
    leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 128;
    leftright_held_position <= leftright_position;
    leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
    leftright_address_0 <= (leftright_held_position - leftright_address_0_value) mod 128;
    leftright_asking_disparity_0 <= leftright_address_0_value;
    leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
    leftright_asking_passed_0 <= leftright_held_0(12) = '1';
    leftright_asking_tag.valid <= leftright_held_valid;
    leftright_asking_tag.map_column <= leftright_held_0(0) = '1';
    leftright_asking_tag.start_of_frame <= leftright_held_0(2) = '1';
    leftright_asking_tag.end_of_line <= leftright_held_0(3) = '1';
    leftright_answered_disparity_0 <= leftright_asking_disparity_0;
    leftright_answered_fraction_0 <= leftright_asking_fraction_0;
    leftright_answered_passed_0 <= leftright_asking_passed_0;
    leftright_answered_tag <= leftright_asking_tag;
    leftright_checked_disparity_0 <= leftright_answered_disparity_0;
    leftright_checked_fraction_0 <= leftright_answered_fraction_0;
    leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
      (leftright_checked_passed_0_difference < 3);
    leftright_checked_tag.valid <= leftright_answered_tag.valid;
    leftright_checked_tag.map_column <= leftright_answered_tag.map_column;
    leftright_checked_tag.start_of_frame <= leftright_answered_tag.start_of_frame;
    leftright_checked_tag.end_of_line <= leftright_answered_tag.end_of_line;
    leftright_holds_winners <= choice(leftright_holds_winners_choice, (not refinement_tag_valid(11)) and
      leftright_holds_winners, refinement_tag_valid(11) or leftright_holds_winners);
    leftright_checked_tag.row_start <= choice(leftright_checked_tag_row_start_choices(3),
      leftright_checked_tag.row_start or leftright_checked_tag_row_start_alls(2), leftright_checked_tag.row_start and
      ((not leftright_checked_tag.valid) or (not leftright_checked_tag.map_column)));
    if refinement_tag_valid(11) then
      leftright_ring_write_address <= leftright_ring_read_address;
      leftright_ring_read_address <= choice(leftright_ring_read_address = 63, 0, (leftright_ring_read_address + 1) mod
        64);
    end if;
    -- map
    if leftright_checked_tag_row_start_alls(2) then
      map_counter_column <= choice(leftright_checked_tag.start_of_frame or
        leftright_checked_tag_row_start_is_equals(1), 0, (map_counter_column + 1) mod 1024);
    end if;
    map_counter_group_choice := choice(leftright_checked_tag_row_start_alls(1), 15, 0);
    map_counter_group_is_equal := map_counter_group = 480;
    map_counter_group_choices(2) := choice(leftright_checked_tag.row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(leftright_checked_tag_row_start_differs and
      leftright_checked_tag_row_start_is_equals(1) and leftright_checked_tag.valid and
      leftright_checked_tag.map_column, map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(leftright_checked_tag.valid, leftright_checked_tag.map_column, map_line_ended);
    map_at_arrives_value := other_0(16) = '1';
    map_of_column_0_a_choice := choice(map_at_top, map_column_1 / 2, other_1 / 2);
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
    map_counter_next_frame <= other_0(40) = '1';
    map_newest_0 <= ((((((((leftright_checked_disparity_0 + 4095) mod 2048) * 2) + (leftright_checked_fraction_0 / 8) +
      1) mod 4096) * 8) + (leftright_checked_fraction_0 mod 8)) * 2) + as_number(leftright_checked_passed_0);
    map_arrives <= leftright_checked_tag_row_start_alls(2);
    map_behind <= map_line_ended and leftright_checked_tag.valid;
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_write_column <= to_integer(other_0(9 downto 0));
    map_column_1 <= map_rows_ready_words_0 / 8192;
    map_column_2 <= map_rows_ready_newest_0;
    map_at_arrives <= map_at_arrives_value;
    map_at_behind <= other_0(24) = '1';
    map_at_top <= other_0(32) = '1';
    map_at_output <= other_0(48) = '1';
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
    map_counter_group <= choice(leftright_checked_tag.start_of_frame and leftright_checked_tag.valid and
      leftright_checked_tag.map_column, map_counter_group_choice * 32, map_counter_group_choices(3));
    map_line_ended <= choice(leftright_checked_tag.end_of_line, map_line_ended_choice, map_line_ended and (not
      leftright_checked_tag.valid));
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
      map_at_column <= to_integer(other_0(9 downto 0));
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
    other_0 <= other_2;
    other_1 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
    other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    other_3 <= ((refinement_remainder_0_difference(7) / 8192) * 2) + ((other_4 / 4) * 4);
    other_4 <= ((refinement_remainder_0_difference(6) / 8192) * 4) + ((other_5 / 8) * 8);
    other_5 <= ((refinement_remainder_0_difference(5) / 8192) * 8) + ((other_6 / 16) * 16);
    other_6 <= ((refinement_remainder_0_difference(4) / 8192) * 16) + ((other_7 / 32) * 32);
    other_7 <= ((refinement_remainder_0_difference(3) / 8192) * 32) + ((other_8 / 64) * 64);
    other_8 <= ((refinement_remainder_0_difference(2) / 8192) * 64) + ((other_9 / 128) * 128);
    other_9 <= (refinement_remainder_1_0_difference / 8192) * 128;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 481;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 484; delay_column <= 0; delay_tag.valid <= false; delay_tag.row_start <= false;
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
      slice0cost_ready_column <= 0; slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.row_start <= false;
      slice0cost_ready_tag.map_column <= false; slice0cost_ready_tag.start_of_frame <= false;
      slice0cost_ready_tag.end_of_line <= false; slice0cost_write_column <= 0; slice0cost_tag.valid <= false;
      slice0cost_tag.map_column <= false; slice0cost_tag.start_of_frame <= false; slice0cost_tag.end_of_line <= false;
      slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_tag.valid <= false; slice0window_entering_tag.map_column <= false;
      slice0window_entering_tag.start_of_frame <= false; slice0window_entering_tag.end_of_line <= false;
      slice0window_change_tag.valid <= false; slice0window_change_tag.map_column <= false;
      slice0window_change_tag.start_of_frame <= false; slice0window_change_tag.end_of_line <= false;
      slice0window_centre_map_column_0 <= false; slice0window_centre_start_of_frame <= (others => false);
      slice0window_centre_end_of_line_0 <= false; slice0window_tag.valid <= false;
      slice0window_tag.start_of_frame <= false; slice0winner1_tag.valid <= false;
      slice0winner1_tag.start_of_frame <= false; slice0winner2_tag.valid <= false;
      slice0winner2_tag.map_column <= false; slice0winner2_tag.start_of_frame <= false;
      slice0winner2_tag.end_of_line <= false; slice0winner3_tag.valid <= false; slice0winner3_tag.map_column <= false;
      slice0winner3_tag.start_of_frame <= false; slice0winner3_tag.end_of_line <= false;
      slice0winner4_tag.valid <= false; slice0winner4_tag.map_column <= false;
      slice0winner4_tag.start_of_frame <= false; slice0winner4_tag.end_of_line <= false; slice0_best_tag.valid <= false;
      slice0_best_tag.map_column <= false; slice0_best_tag.start_of_frame <= false;
      slice0_best_tag.end_of_line <= false; slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_ready_column <= 0; slice1cost_write_column <= 0; slice1window_ring_read_address <= 1;
      slice1window_ring_write_address <= 0; slice1window_centre_map_column_0 <= false;
      slice1window_centre_end_of_line_0 <= false; slice1_best_tag.valid <= false; slice1_best_tag.map_column <= false;
      slice1_best_tag.start_of_frame <= false; slice1_best_tag.end_of_line <= false; slice2cost_read_column <= 0;
      slice2cost_change_column <= 0; slice2cost_ready_column <= 0; slice2cost_write_column <= 0;
      slice2window_ring_read_address <= 1; slice2window_ring_write_address <= 0;
      slice2window_centre_map_column_0 <= false; slice2window_centre_end_of_line_0 <= false;
      slice2_best_tag.valid <= false; slice2_best_tag.map_column <= false; slice2_best_tag.start_of_frame <= false;
      slice2_best_tag.end_of_line <= false; slice3cost_read_column <= 0; slice3cost_change_column <= 0;
      slice3cost_ready_column <= 0; slice3cost_write_column <= 0; slice3window_ring_read_address <= 1;
      slice3window_ring_write_address <= 0; slice3window_centre_map_column <= (others => false);
      slice3window_centre_end_of_line <= (others => false); slice3_best_tag.valid <= false;
      slice3_best_tag.map_column <= false; slice3_best_tag.start_of_frame <= false;
      slice3_best_tag.end_of_line <= false;
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      leftright_ring_read_address <= 1; leftright_ring_write_address <= 0; leftright_holds_winners <= false;
      leftright_position <= 0; leftright_held_valid <= false; leftright_asking_tag <= (others => false);
      leftright_answered_tag <= (others => false); leftright_checked_tag <= (others => false); map_counter_column <= 0;
      map_counter_group <= 481; map_arrives <= false; map_behind <= false; map_line_ended <= false;
      map_write_column <= 0; map_at_arrives <= false; map_at_behind <= false; map_at_top <= false;
      map_at_output <= false; map_comparing_column <= 0; map_comparing_arrives <= false; map_comparing_behind <= false;
      map_comparing_top <= false; map_comparing_output <= false; map_sorted_column <= 0; map_sorted_arrives <= false;
      map_sorted_behind <= false; map_sorted_top <= false; map_sorted_output <= false; map_window_complete <= false;
      map_window_first <= false; map_window_last <= false;
      for i in 0 to 2 loop
        map_waiting_complete(i) <= false; map_waiting_first(i) <= false; map_waiting_last(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false;
      other_0 <= to_unsigned(0, 49); other_2 <= to_unsigned(0, 49);
    end if;
  end process;
end architecture;
