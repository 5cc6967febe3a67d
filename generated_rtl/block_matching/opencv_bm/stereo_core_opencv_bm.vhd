-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration opencv_bm: 450x375, 64 disparities, window 15x15, 1 pixel pair a clock.
-- Options: window_px 15, reference left, prefilter xsobel, ties largest, uniqueness_percent 15,
--   texture_threshold 10, subpixel true, aggregation recursive, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config opencv_bm
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_opencv_bm is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 386;
    latency_clocks : positive := 41;
    flush_groups : positive := 3608;
    gap_groups : positive := 3150
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
  assert width_px = 450 report "stereo_core_opencv_bm: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_opencv_bm: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 64 report "stereo_core_opencv_bm: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_opencv_bm: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_opencv_bm: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 386 report "stereo_core_opencv_bm: output_width_px is " & integer'image(output_width_px) & " but this core has 386" severity failure;
  assert latency_clocks = 41 report "stereo_core_opencv_bm: latency_clocks is " & integer'image(latency_clocks) & " but this core has 41" severity failure;
  assert flush_groups = 3608 report "stereo_core_opencv_bm: flush_groups is " & integer'image(flush_groups) & " but this core has 3608" severity failure;
  assert gap_groups = 3150 report "stereo_core_opencv_bm: gap_groups is " & integer'image(gap_groups) & " but this core has 3150" severity failure;
end entity;

architecture rtl of stereo_core_opencv_bm is
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

  function smaller(a : integer; b : integer) return integer is
  begin
    if (a - b) < 0 then
      return a;
    end if;
    return b;
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
  type integer_minus_1023_to_1023_1d is array (natural range <>) of integer range -1023 to 1023;
  type integer_minus_127_to_127_2d is array (natural range <>, natural range <>) of integer range -127 to 127;
  type integer_minus_127_to_31_1d is array (natural range <>) of integer range -127 to 31;
  type integer_minus_128_to_128_1d is array (natural range <>) of integer range -128 to 128;
  type natural_1020_1d is array (natural range <>) of natural range 0 to 1020;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_1023_2d is array (natural range <>, natural range <>) of natural range 0 to 1023;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_128_2d is array (natural range <>, natural range <>) of natural range 0 to 128;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_16385_to_65534_1d is array (natural range <>) of natural range 16385 to 65534;
  type natural_254_1d is array (natural range <>) of natural range 0 to 254;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8 is record
    valid, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    first_cost, leaves_window : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 2);
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0, transform_read_row_inside_2,
    transform_read_column_inside_0, transform_read_column_inside_2, transform_read_start_of_frame,
    transform_read_valid, transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_column_inside_0,
    transform_ready_column_inside_2, transform_ready_start_of_frame, transform_ready_valid,
    transform_columns_row_inside_0, transform_columns_row_inside_2, transform_columns_column_inside_0,
    transform_columns_column_inside_2, transform_columns_start_of_frame, transform_columns_valid,
    transform_left_filter_whole, transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 2);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 2);  -- _#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_right_rows_read_words_0 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_write_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : natural range 0 to 65535;
  signal transform_left_filter_column_0, transform_right_filter_column_0 : natural_1020_1d(0 to 2);  -- _#_0
  signal transform_left_filter_slope_0, transform_right_filter_slope_0 : integer range -1020 to 1020;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 127;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 127;
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 127;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words, rows_reference_rows_read_words : unsigned_28_1d(0 to 2);
  signal rows_search_rows_read_words_3, rows_reference_rows_read_words_3 : unsigned(20 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 127;
  signal rows_search, rows_reference : natural_127_1d(0 to 1);
  signal rows_search_rows_ready_words, rows_search_rows_write_words, rows_reference_rows_ready_words,
    rows_reference_rows_write_words : natural_268435455_1d(0 to 2);
  signal rows_search_rows_ready_words_3, rows_search_rows_write_words_3, rows_reference_rows_ready_words_3,
    rows_reference_rows_write_words_3 : natural range 0 to 2097151;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag : tag_9;
  signal rows_inside : boolean_1d(0 to 1);
  signal rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice0shift_reference, slice0shift_search_out : natural_127_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag : tag_9;
  signal slice0cost_tag : tag_8;
  signal slice0cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words : unsigned_30_1d(0 to 4);
  signal slice0cost_read_words_5 : unsigned(9 downto 0);
  signal slice0cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice0cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice0cost_write_words : natural_1073741823_1d(0 to 5);  -- _# up to 1073741823 x 5, 1023
  signal slice0cost_ready_words_5 : natural range 0 to 1023;
  signal slice0cost_column_0 : natural_1023_1d(0 to 15);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_30_1d(0 to 4);
  signal slice0window_leaving_5 : unsigned(9 downto 0);
  signal slice0window_entering_0 : natural_1023_1d(0 to 15);
  signal slice0window_entering_tag, slice0window_change_tag : tag_8;
  signal slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 1);
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice0window_sum_0 : natural_16383_1d(0 to 15);
  -- slice0winner1
  signal slice0winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_late_cost_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_but_first_0 : natural_16383_1d(1 to 7);
  signal slice0winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_first_0 : natural_16383_1d(1 to 3);
  signal slice0winner2_best_last_0, slice0winner2_best_late_cost_0,
    slice0winner2_best_second_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_but_first_0 : natural_16383_1d(1 to 3);
  signal slice0winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice0winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice0winner2_best_place_0, slice0winner2_best_at_start_0, slice0winner2_best_at_end_0 : boolean_1d(0 to 3);
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0, slice0winner3_best_below_0, slice0winner3_best_above_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_first_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_last_0, slice0winner3_best_late_cost_0,
    slice0winner3_best_second_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_but_first_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice0winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice0winner3_best_place_0, slice0winner3_best_at_start_0, slice0winner3_best_at_end_0 : boolean_1d(0 to 1);
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0, slice0winner4_best_above_0_0,
    slice0winner4_best_last_0_0, slice0winner4_best_late_cost_0_0, slice0winner4_best_second_0_0,
    slice0winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_place_0_0, slice0winner4_best_at_start_0_0, slice0winner4_best_at_end_0_0 : boolean;
  signal slice0winner4_tag : tag_4;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 15;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0, slice0_best_late_cost_0_0,
    slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 16383;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice1shift_reference, slice1shift_search_out : natural_127_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice1cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words : unsigned_30_1d(0 to 4);
  signal slice1cost_read_words_5 : unsigned(9 downto 0);
  signal slice1cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice1cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice1cost_write_words : natural_1073741823_1d(0 to 5);  -- _# up to 1073741823 x 5, 1023
  signal slice1cost_ready_words_5 : natural range 0 to 1023;
  signal slice1cost_column_0 : natural_1023_1d(0 to 15);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving : unsigned_30_1d(0 to 4);
  signal slice1window_leaving_5 : unsigned(9 downto 0);
  signal slice1window_entering_0 : natural_1023_1d(0 to 15);
  signal slice1window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice1window_change_tag : tag_2;
  signal slice1window_centre_output_column_0, slice1window_centre_start_of_frame_1 : boolean;
  signal slice1window_centre_start_of_frame : boolean_1d(3 to 5);
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_16383_1d(0 to 15);
  -- slice1winner1
  signal slice1winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice1winner1_best_cost_0, slice1winner1_best_below_0, slice1winner1_best_above_0,
    slice1winner1_best_late_cost_0, slice1winner1_best_but_first_0,
    slice1winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice1winner2
  signal slice1winner2_best_cost_0, slice1winner2_best_below_0, slice1winner2_best_above_0, slice1winner2_best_first_0,
    slice1winner2_best_last_0, slice1winner2_best_late_cost_0, slice1winner2_best_second_0,
    slice1winner2_best_but_first_0, slice1winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice1winner2_best_place_0, slice1winner2_best_at_start_0, slice1winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice1winner3
  signal slice1winner3_best_cost_0, slice1winner3_best_below_0, slice1winner3_best_above_0, slice1winner3_best_first_0,
    slice1winner3_best_last_0, slice1winner3_best_late_cost_0, slice1winner3_best_second_0,
    slice1winner3_best_but_first_0, slice1winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice1winner3_best_place_0, slice1winner3_best_at_start_0, slice1winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0, slice1winner4_best_above_0_0,
    slice1winner4_best_first_0_0, slice1winner4_best_last_0_0, slice1winner4_best_late_cost_0_0,
    slice1winner4_best_second_0_0, slice1winner4_best_but_first_0_0,
    slice1winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_place_0_0, slice1winner4_best_at_start_0_0, slice1winner4_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0, slice1_best_last_0_0,
    slice1_best_late_cost_0_0, slice1_best_second_0_0, slice1_best_but_last_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 31;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0 : boolean;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice2shift_reference, slice2shift_search_out : natural_127_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice2cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column,
    slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words : unsigned_30_1d(0 to 4);
  signal slice2cost_read_words_5 : unsigned(9 downto 0);
  signal slice2cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice2cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice2cost_write_words : natural_1073741823_1d(0 to 5);  -- _# up to 1073741823 x 5, 1023
  signal slice2cost_ready_words_5 : natural range 0 to 1023;
  signal slice2cost_column_0 : natural_1023_1d(0 to 15);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 15;
  signal slice2window_leaving : unsigned_30_1d(0 to 4);
  signal slice2window_leaving_5 : unsigned(9 downto 0);
  signal slice2window_entering_0 : natural_1023_1d(0 to 15);
  signal slice2window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice2window_change_tag : tag_2;
  signal slice2window_centre_output_column_0, slice2window_centre_start_of_frame_1,
    slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_16383_1d(0 to 15);
  -- slice2winner1
  signal slice2winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice2winner1_best_cost_0, slice2winner1_best_below_0, slice2winner1_best_above_0,
    slice2winner1_best_late_cost_0, slice2winner1_best_but_first_0,
    slice2winner1_best_but_last_0 : natural_16383_1d(0 to 7);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice2winner2
  signal slice2winner2_best_cost_0, slice2winner2_best_below_0, slice2winner2_best_above_0, slice2winner2_best_first_0,
    slice2winner2_best_last_0, slice2winner2_best_late_cost_0, slice2winner2_best_second_0,
    slice2winner2_best_but_first_0, slice2winner2_best_but_last_0 : natural_16383_1d(0 to 3);
  signal slice2winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice2winner2_best_place_0, slice2winner2_best_at_start_0, slice2winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice2winner3
  signal slice2winner3_best_cost_0, slice2winner3_best_below_0, slice2winner3_best_above_0, slice2winner3_best_first_0,
    slice2winner3_best_last_0, slice2winner3_best_late_cost_0, slice2winner3_best_second_0,
    slice2winner3_best_but_first_0, slice2winner3_best_but_last_0 : natural_16383_1d(0 to 1);
  signal slice2winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice2winner3_best_place_0, slice2winner3_best_at_start_0, slice2winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_below_0_0, slice2winner4_best_above_0_0,
    slice2winner4_best_first_0_0, slice2winner4_best_last_0_0, slice2winner4_best_late_cost_0_0,
    slice2winner4_best_second_0_0, slice2winner4_best_but_first_0_0,
    slice2winner4_best_but_last_0_0 : natural range 0 to 16383;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_place_0_0, slice2winner4_best_at_start_0_0, slice2winner4_best_at_end_0_0 : boolean;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_below_0_0, slice2_best_above_0_0, slice2_best_last_0_0,
    slice2_best_late_cost_0_0, slice2_best_second_0_0, slice2_best_but_last_0_0 : natural range 0 to 16383;
  signal slice2_best_index_0_0 : natural range 0 to 47;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0 : boolean;
  signal slice2_best_tag : tag_4;
  -- slice3shift
  signal slice3shift_search : natural_127_2d(0 to 1, 0 to 15);
  signal slice3shift_reference : natural_127_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first : integer_minus_127_to_127_2d(0 to 1, 0 to 15);
  signal slice3cost_pixels_cost : natural_128_2d(0 to 1, 0 to 15);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column,
    slice3cost_write_column : natural range 0 to 511;
  signal slice3cost_read_words : unsigned_30_1d(0 to 4);
  signal slice3cost_read_words_5 : unsigned(9 downto 0);
  signal slice3cost_change_0 : integer_minus_128_to_128_1d(0 to 15);
  signal slice3cost_ready_words : natural_1073741823_1d(0 to 4);
  signal slice3cost_write_words : natural_1073741823_1d(0 to 5);  -- _# up to 1073741823 x 5, 1023
  signal slice3cost_ready_words_5 : natural range 0 to 1023;
  signal slice3cost_column_0 : natural_1023_1d(0 to 15);
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 15;
  signal slice3window_leaving : unsigned_30_1d(0 to 4);
  signal slice3window_leaving_5 : unsigned(9 downto 0);
  signal slice3window_entering_0 : natural_1023_1d(0 to 15);
  signal slice3window_change_0 : integer_minus_1023_to_1023_1d(0 to 15);
  signal slice3window_change_tag_first_cost : boolean;
  signal slice3window_centre_output_column : boolean_1d(0 to 5);
  signal slice3window_centre_start_of_frame_1, slice3window_centre_start_of_frame_5 : boolean;
  signal slice3window_centre_end_of_line : boolean_1d(0 to 5);
  signal slice3window_sum_0 : natural_16383_1d(0 to 15);
  -- slice3winner1
  signal slice3winner1_held_0 : natural_16383_1d(0 to 15);
  signal slice3winner1_best_cost_0, slice3winner1_best_below_0, slice3winner1_best_above_0,
    slice3winner1_best_late_cost_0, slice3winner1_best_but_first_0 : natural_16383_1d(0 to 7);
  signal slice3winner1_best_but_last_0 : natural_16383_1d(0 to 6);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0 : natural_15_1d(1 to 7);  -- _# up to 3, 5 .. 15
  -- slice3winner2
  signal slice3winner2_best_cost_0, slice3winner2_best_below_0, slice3winner2_best_above_0,
    slice3winner2_best_first_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_last_0 : natural_16383_1d(0 to 2);
  signal slice3winner2_best_late_cost_0, slice3winner2_best_second_0,
    slice3winner2_best_but_first_0 : natural_16383_1d(0 to 3);
  signal slice3winner2_best_but_last_0 : natural_16383_1d(0 to 2);
  signal slice3winner2_best_index_0 : natural_15_1d(0 to 3);  -- _# up to 3, 7 .. 15
  signal slice3winner2_best_place_0, slice3winner2_best_at_start_0, slice3winner2_best_at_end_0 : boolean_1d(0 to 3);
  -- slice3winner3
  signal slice3winner3_best_cost_0, slice3winner3_best_below_0, slice3winner3_best_above_0,
    slice3winner3_best_first_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_last_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_late_cost_0, slice3winner3_best_second_0,
    slice3winner3_best_but_first_0 : natural_16383_1d(0 to 1);
  signal slice3winner3_best_but_last_0_0 : natural range 0 to 16383;
  signal slice3winner3_best_index_0 : natural_15_1d(0 to 1);  -- _# up to 7, 15
  signal slice3winner3_best_place_0, slice3winner3_best_at_start_0, slice3winner3_best_at_end_0 : boolean_1d(0 to 1);
  -- slice3winner4
  signal slice3winner4_best_cost_0_0, slice3winner4_best_below_0_0, slice3winner4_best_above_0_0,
    slice3winner4_best_first_0_0, slice3winner4_best_late_cost_0_0, slice3winner4_best_second_0_0,
    slice3winner4_best_but_first_0_0 : natural range 0 to 16383;
  signal slice3winner4_best_index_0_0 : natural range 0 to 15;
  signal slice3winner4_best_place_0_0, slice3winner4_best_at_start_0_0, slice3winner4_best_at_end_0_0 : boolean;
  -- slice3
  signal slice3_best_cost_0_0, slice3_best_below_0_0, slice3_best_above_0_0, slice3_best_late_cost_0_0,
    slice3_best_second_0_0 : natural range 0 to 16383;
  signal slice3_best_index_0_0 : natural range 0 to 63;
  signal slice3_best_place_0_0, slice3_best_at_start_0_0, slice3_best_at_end_0_0 : boolean;
  signal slice3_best_tag : tag_4;
  -- texture
  signal texture_taps_search_0 : natural_31_1d(0 to 1);  -- _#_0
  signal texture_passes_0 : boolean_1d(0 to 7);  -- _#_0
  -- texturecost
  signal texturecost_pixels_first_0 : integer_minus_127_to_31_1d(0 to 1);  -- _#_0
  signal texturecost_pixels_cost_0 : natural_127_1d(0 to 1);  -- _#_0
  signal texturecost_read_words_0 : unsigned(9 downto 0);
  signal texturecost_change_0_0 : integer range -127 to 127;
  signal texturecost_ready_words_0, texturecost_column_0_0, texturecost_write_words_0 : natural range 0 to 1023;
  -- texturewindow
  signal texturewindow_leaving_0 : unsigned(9 downto 0);
  signal texturewindow_entering_0_0 : natural range 0 to 1023;
  signal texturewindow_change_0_0 : integer range -1023 to 1023;
  signal texturewindow_sum_0_0 : natural range 0 to 16383;
  -- refinement
  signal refinement_disparity_0 : natural_63_1d(0 to 11);  -- _#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- _#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- _#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- _#_end_of_line
  signal refinement_alone_0 : boolean_1d(0 to 1);  -- _#_0
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_gap_0, refinement_lowest_0, refinement_below_0, refinement_above_0, refinement_u_0,
    refinement_v_0 : natural range 0 to 16383;
  signal refinement_remainder_0, refinement_divisor_0 : natural_16383_1d(0 to 7);  -- _#_0
  signal refinement_scaled_gap_0 : natural range 0 to 327660;
  signal refinement_scaled_cost_0 : natural range 0 to 49149;
  signal refinement_difference_0 : integer range -16383 to 16383;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other : boolean_1d(0 to 5);
  signal others_from_13 : boolean_1d(13 to 22);  -- other_#
  signal others_from_6 : natural_254_1d(6 to 12);  -- other_# up to 254, 252, 248, 240, 224, 192, 128

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

  texturewindow_leaving_0_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(texturecost_column_0_0, 10);
    cell : entity work.line_memory generic map (16, 10, 4)
      port map (clock, true, read_address, texturewindow_leaving_0, write_address, write_data);
  end block;

  texturecost_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(texturecost_write_words_0, 10);
    cell : entity work.line_memory generic map (450, 10, 9)
      port map (clock, true, read_address, texturecost_read_words_0, write_address, write_data);
  end block;

  slice3window_leaving_5_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 4);
    write_address <= to_unsigned(slice3window_ring_write_address, 4);
    write_data <= to_unsigned(slice3cost_column_0(15), 10);
    cell : entity work.line_memory generic map (16, 10, 4)
      port map (clock, true, read_address, slice3window_leaving_5, write_address, write_data);
  end block;

  slice3window_leaving_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 4);
    write_address <= to_unsigned(slice3window_ring_write_address, 4);
    write_data <= to_unsigned(slice3cost_column_0(3 * i + 2), 10) & to_unsigned(slice3cost_column_0(3 * i + 1), 10) &
      to_unsigned(slice3cost_column_0(3 * i), 10);
    cell : entity work.line_memory generic map (16, 30, 4)
      port map (clock, true, read_address, slice3window_leaving(i), write_address, write_data);
  end generate;

  slice3cost_read_words_5_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_change_column, 9);
    write_address <= to_unsigned(slice3cost_write_column, 9);
    write_data <= to_unsigned(slice3cost_write_words(5), 10);
    cell : entity work.line_memory generic map (450, 10, 9)
      port map (clock, true, read_address, slice3cost_read_words_5, write_address, write_data);
  end block;

  slice3cost_read_words_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_change_column, 9);
    write_address <= to_unsigned(slice3cost_write_column, 9);
    write_data <= to_unsigned(slice3cost_write_words(i), 30);
    cell : entity work.line_memory generic map (450, 30, 9)
      port map (clock, true, read_address, slice3cost_read_words(i), write_address, write_data);
  end generate;

  slice2window_leaving_5_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 4);
    write_address <= to_unsigned(slice2window_ring_write_address, 4);
    write_data <= to_unsigned(slice2cost_column_0(15), 10);
    cell : entity work.line_memory generic map (16, 10, 4)
      port map (clock, true, read_address, slice2window_leaving_5, write_address, write_data);
  end block;

  slice2window_leaving_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 4);
    write_address <= to_unsigned(slice2window_ring_write_address, 4);
    write_data <= to_unsigned(slice2cost_column_0(3 * i + 2), 10) & to_unsigned(slice2cost_column_0(3 * i + 1), 10) &
      to_unsigned(slice2cost_column_0(3 * i), 10);
    cell : entity work.line_memory generic map (16, 30, 4)
      port map (clock, true, read_address, slice2window_leaving(i), write_address, write_data);
  end generate;

  slice2cost_read_words_5_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_read_column, 9);
    write_address <= to_unsigned(slice3cost_ready_column, 9);
    write_data <= to_unsigned(slice2cost_write_words(5), 10);
    cell : entity work.line_memory generic map (450, 10, 9)
      port map (clock, true, read_address, slice2cost_read_words_5, write_address, write_data);
  end block;

  slice2cost_read_words_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_read_column, 9);
    write_address <= to_unsigned(slice3cost_ready_column, 9);
    write_data <= to_unsigned(slice2cost_write_words(i), 30);
    cell : entity work.line_memory generic map (450, 30, 9)
      port map (clock, true, read_address, slice2cost_read_words(i), write_address, write_data);
  end generate;

  slice1window_leaving_5_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 4);
    write_address <= to_unsigned(slice1window_ring_write_address, 4);
    write_data <= to_unsigned(slice1cost_column_0(15), 10);
    cell : entity work.line_memory generic map (16, 10, 4)
      port map (clock, true, read_address, slice1window_leaving_5, write_address, write_data);
  end block;

  slice1window_leaving_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 4);
    write_address <= to_unsigned(slice1window_ring_write_address, 4);
    write_data <= to_unsigned(slice1cost_column_0(3 * i + 2), 10) & to_unsigned(slice1cost_column_0(3 * i + 1), 10) &
      to_unsigned(slice1cost_column_0(3 * i), 10);
    cell : entity work.line_memory generic map (16, 30, 4)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_5_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(5), 10);
    cell : entity work.line_memory generic map (450, 10, 9)
      port map (clock, true, read_address, slice1cost_read_words_5, write_address, write_data);
  end block;

  slice1cost_read_words_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(i), 30);
    cell : entity work.line_memory generic map (450, 30, 9)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, write_data);
  end generate;

  slice0window_leaving_5_memory : block
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(slice0cost_column_0(15), 10);
    cell : entity work.line_memory generic map (16, 10, 4)
      port map (clock, true, read_address, slice0window_leaving_5, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(3 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 4);
    write_address <= to_unsigned(slice0window_ring_write_address, 4);
    write_data <= to_unsigned(slice0cost_column_0(3 * i + 2), 10) & to_unsigned(slice0cost_column_0(3 * i + 1), 10) &
      to_unsigned(slice0cost_column_0(3 * i), 10);
    cell : entity work.line_memory generic map (16, 30, 4)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_5_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(5), 10);
    cell : entity work.line_memory generic map (450, 10, 9)
      port map (clock, true, read_address, slice0cost_read_words_5, write_address, write_data);
  end block;

  slice0cost_read_words_memory : for i in 4 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(29 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(i), 30);
    cell : entity work.line_memory generic map (450, 30, 9)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_3_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(20 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words_3, 21);
    cell : entity work.line_memory generic map (450, 21, 9)
      port map (clock, true, read_address, rows_search_rows_read_words_3, write_address, write_data);
  end block;

  rows_search_rows_read_words_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_search_rows_write_words(i), 28);
    cell : entity work.line_memory generic map (450, 28, 9)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address, write_data);
  end generate;

  rows_reference_rows_read_words_3_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(20 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words_3, 21);
    cell : entity work.line_memory generic map (450, 21, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words_3, write_address, write_data);
  end block;

  rows_reference_rows_read_words_memory : for i in 2 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(27 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    write_data <= to_unsigned(rows_reference_rows_write_words(i), 28);
    cell : entity work.line_memory generic map (450, 28, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address, write_data);
  end generate;

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_left_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (450, 16, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address, write_data);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_right_rows_write_words_0, 16);
    cell : entity work.line_memory generic map (450, 16, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address, write_data);
  end block;

  process
    variable transform_counter_group_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_differs, transform_read_column_inside_0_differs,
      transform_left_filter_column_0_0_choice_3, transform_right_filter_column_0_0_choice_3,
      raster_place_group_is_equal, slice0winner1_best_index_0_0_is_not_less, slice0winner2_best_above_0_3_value,
      slice0winner4_best_index_0_0_is_less, slice0winner4_best_below_0_0_is_equal,
      slice0winner4_best_above_0_0_is_equal, slice0winner4_best_place_0_0_is_not_less,
      slice1winner1_best_index_0_0_is_not_less, slice1winner2_best_above_0_3_value,
      slice1winner4_best_index_0_0_is_less, slice1winner4_best_below_0_0_is_equal,
      slice1winner4_best_above_0_0_is_equal, slice1winner4_best_place_0_0_is_not_less, slice1_best_index_0_0_is_less,
      slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal, slice1_best_place_0_0_is_not_less,
      slice2winner1_best_index_0_0_is_not_less, slice2winner2_best_above_0_3_value,
      slice2winner4_best_index_0_0_is_less, slice2winner4_best_below_0_0_is_equal,
      slice2winner4_best_above_0_0_is_equal, slice2winner4_best_place_0_0_is_not_less, slice2_best_index_0_0_is_less,
      slice2_best_below_0_0_is_equal, slice2_best_above_0_0_is_equal, slice2_best_place_0_0_is_not_less,
      slice3winner1_best_index_0_0_is_not_less, slice3winner2_best_above_0_3_value,
      slice3winner4_best_index_0_0_is_less, slice3winner4_best_below_0_0_is_equal,
      slice3winner4_best_above_0_0_is_equal, slice3winner4_best_place_0_0_is_not_less, slice3_best_index_0_0_is_less,
      slice3_best_below_0_0_is_equal, slice3_best_above_0_0_is_equal, slice3_best_place_0_0_is_not_less,
      refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_choices, transform_right_filter_feature_0_choices : natural_127_1d(1 to 2);  -- _choice_#
    variable transform_counter_next_frame_choices : boolean_1d(1 to 3);  -- _choice_#
    variable transform_left_filter_column_0_0_choices,
      transform_right_filter_column_0_0_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice1cost_column_0_choice, slice2cost_column_0_choice,
      slice3cost_column_0_choice : natural_1023_2d(0 to 15, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice, slice2window_change_0_choice,
      slice3window_change_0_choice : natural_1023_1d(0 to 15);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice, slice2window_sum_0_choice,
      slice3window_sum_0_choice : natural_16383_1d(0 to 15);  -- _#_choice
    variable slice0winner1_best_index_0_is_less, slice1winner1_best_index_0_is_less,
      slice2winner1_best_index_0_is_less, slice3winner1_best_index_0_is_less : boolean_1d(1 to 7);  -- _#_is_less
    variable slice0winner2_best_index_0_is_not_less, slice1winner2_best_index_0_is_not_less,
      slice2winner2_best_index_0_is_not_less, slice3winner2_best_index_0_is_not_less : boolean_1d(0 to 3);  -- _#_is_not_less
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice, slice1winner2_best_below_0_choice,
      slice1winner2_best_above_0_choice, slice2winner2_best_below_0_choice, slice2winner2_best_above_0_choice,
      slice3winner2_best_below_0_choice, slice3winner2_best_above_0_choice : natural_16383_1d(0 to 3);  -- _#_choice
    variable slice0winner2_best_second_0_choice, slice1winner2_best_second_0_choice,
      slice2winner2_best_second_0_choice, slice3winner2_best_second_0_choice : natural_16383_2d(0 to 3, 1 to 4);  -- _#_choice_#
    variable slice0winner3_best_index_0_is_not_less, slice1winner3_best_index_0_is_not_less,
      slice2winner3_best_index_0_is_not_less, slice3winner3_best_index_0_is_not_less : boolean_1d(0 to 1);  -- _#_is_not_less
    variable slice0winner3_best_below_0_is_equal, slice0winner3_best_above_0_is_equal,
      slice1winner3_best_below_0_is_equal, slice1winner3_best_above_0_is_equal, slice2winner3_best_below_0_is_equal,
      slice2winner3_best_above_0_is_equal, slice3winner3_best_below_0_is_equal,
      slice3winner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable slice0winner3_best_below_0_choice, slice0winner3_best_above_0_choice, slice1winner3_best_below_0_choice,
      slice1winner3_best_above_0_choice, slice2winner3_best_below_0_choice, slice2winner3_best_above_0_choice,
      slice3winner3_best_below_0_choice, slice3winner3_best_above_0_choice : natural_16383_1d(0 to 1);  -- _#_choice
    variable slice0winner3_best_second_0_choice, slice1winner3_best_second_0_choice,
      slice2winner3_best_second_0_choice, slice3winner3_best_second_0_choice : natural_16383_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice,
      slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice, slice1_best_below_0_0_choice,
      slice1_best_above_0_0_choice, slice2winner4_best_below_0_0_choice, slice2winner4_best_above_0_0_choice,
      slice2_best_below_0_0_choice, slice2_best_above_0_0_choice, slice3winner4_best_below_0_0_choice,
      slice3winner4_best_above_0_0_choice, slice3_best_below_0_0_choice, slice3_best_above_0_0_choice,
      texturewindow_sum_0_0_choice, refinement_divisor_0_0_choice : natural range 0 to 16383;
    variable slice0winner4_best_second_0_0_choices, slice1winner4_best_second_0_0_choices,
      slice1_best_second_0_0_choices, slice2winner4_best_second_0_0_choices, slice2_best_second_0_0_choices,
      slice3winner4_best_second_0_0_choices, slice3_best_second_0_0_choices : natural_16383_1d(1 to 4);  -- _choice_#
    variable texturecost_column_0_0_choices : natural_1023_1d(1 to 2);  -- _choice_#
    variable texturewindow_change_0_0_choice : natural range 0 to 1023;
    variable refinement_remainder_1_0_difference : natural range 16385 to 49151;
    variable refinement_remainder_0_difference : natural_16385_to_65534_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    wait until rising_edge(clock);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 374;
    transform_counter_group_is_equals(2) := transform_counter_column = 449;
    transform_counter_group_choice := choice(transform_counter_group_is_equals(1) and
      transform_counter_group_is_equals(2), 375, 0);
    transform_counter_group_differs := transform_counter_group /= 376;
    transform_counter_group_choices(2) := choice((transform_counter_group = 375) and transform_counter_next_frame, 1,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and
      transform_counter_group_is_equals(2) and in_valid, transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_differs := transform_counter_column /= 0;
    transform_left_filter_feature_0_choices(1) := choice(31 < transform_left_filter_slope_0, 62,
      (transform_left_filter_slope_0 + 31) mod 128);
    transform_left_filter_feature_0_choices(2) := choice(transform_left_filter_slope_0 < (-31), 0,
      transform_left_filter_feature_0_choices(1));
    transform_right_filter_feature_0_choices(1) := choice(31 < transform_right_filter_slope_0, 62,
      (transform_right_filter_slope_0 + 31) mod 128);
    transform_right_filter_feature_0_choices(2) := choice(transform_right_filter_slope_0 < (-31), 0,
      transform_right_filter_feature_0_choices(1));
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
    transform_read_row_inside_0 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 375;
    transform_read_row_inside_2 <= transform_counter_group < 375;
    transform_read_column_inside_0 <= transform_read_column_inside_0_differs;
    transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_differs;
    transform_read_start_of_frame <= (transform_counter_group = 1) and (transform_counter_column = 1);
    transform_read_valid <= transform_valid;
    transform_ready_column <= transform_read_column;
    transform_ready_row_inside_0 <= transform_read_row_inside_0;
    transform_ready_row_inside_2 <= transform_read_row_inside_2;
    transform_ready_column_inside_0 <= transform_read_column_inside_0;
    transform_ready_column_inside_2 <= transform_read_column_inside_2;
    transform_ready_start_of_frame <= transform_read_start_of_frame;
    transform_ready_valid <= transform_read_valid;
    transform_left_column(0) <= transform_left_rows_ready_words_0 mod 256;
    transform_left_column(1) <= transform_left_rows_ready_words_0 / 256;
    transform_left_column(2) <= transform_left_rows_ready_newest_0;
    transform_right_column(0) <= transform_right_rows_ready_words_0 mod 256;
    transform_right_column(1) <= transform_right_rows_ready_words_0 / 256;
    transform_right_column(2) <= transform_right_rows_ready_newest_0;
    transform_columns_row_inside_0 <= transform_ready_row_inside_0;
    transform_columns_row_inside_2 <= transform_ready_row_inside_2;
    transform_columns_column_inside_0 <= transform_ready_column_inside_0;
    transform_columns_column_inside_2 <= transform_ready_column_inside_2;
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_left_filter_slope_0 <= transform_left_filter_column_0(0) - transform_left_filter_column_0(2);
    transform_left_filter_whole <= transform_filtering_0_column_inside_2 and transform_filtering_0_column_inside_0;
    transform_right_filter_slope_0 <= transform_right_filter_column_0(0) - transform_right_filter_column_0(2);
    transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
    transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_filtering_start_of_frame(2) <= transform_filtering_start_of_frame(1);
    transform_filtering_valid(2) <= transform_filtering_valid(1);
    transform_counter_group <= choice(in_start_of_frame and in_valid, transform_counter_group_choice,
      transform_counter_group_choices(3));
    transform_left_filter_feature_0 <= choice(transform_left_filter_whole, transform_left_filter_feature_0_choices(2),
      31);
    transform_right_filter_feature_0 <= choice(transform_left_filter_whole,
      transform_right_filter_feature_0_choices(2), 31);
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      375) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    transform_counter_next_frame_choices(3) := choice(transform_counter_group_is_equals(1),
      transform_counter_group_is_equals(2) or (not in_start_of_frame), not in_start_of_frame);
    if in_valid then
      transform_counter_column <= choice(transform_counter_group_is_equals(2) or in_start_of_frame, 0,
        (transform_counter_column + 1) mod 512);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2),
        transform_counter_next_frame_choices(3), transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2) and in_start_of_frame);
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= (transform_left_rows_ready_newest_0 * 256) +
        (transform_left_rows_ready_words_0 / 256);
      transform_right_rows_write_words_0 <= (transform_right_rows_ready_newest_0 * 256) +
        (transform_right_rows_ready_words_0 / 256);
      transform_write_column <= transform_ready_column;
    end if;
    transform_left_filter_column_0_0_choices(1) := choice(transform_columns_row_inside_0, transform_left_column(0),
      transform_left_column(2));
    transform_left_filter_column_0_0_choices(2) := choice(transform_columns_row_inside_2, transform_left_column(2),
      transform_left_column(0));
    transform_left_filter_column_0_0_choice_3 := choice(transform_columns_row_inside_2,
      is_set(transform_left_column(2), 0), is_set(transform_left_column(0), 0));
    transform_right_filter_column_0_0_choices(1) := choice(transform_columns_row_inside_0, transform_right_column(0),
      transform_right_column(2));
    transform_right_filter_column_0_0_choices(2) := choice(transform_columns_row_inside_2, transform_right_column(2),
      transform_right_column(0));
    transform_right_filter_column_0_0_choice_3 := choice(transform_columns_row_inside_2,
      is_set(transform_right_column(2), 0), is_set(transform_right_column(0), 0));
    if transform_columns_valid then
      transform_left_filter_column_0(0) <= transform_left_filter_column_0_0_choices(1) +
        (((transform_left_filter_column_0_0_choices(2) / 2) + transform_left_column(1)) * 2) +
        as_number(transform_left_filter_column_0_0_choice_3);
      transform_left_filter_column_0(1 to 2) <= transform_left_filter_column_0(0 to 1);
      transform_right_filter_column_0(0) <= transform_right_filter_column_0_0_choices(1) +
        (((transform_right_filter_column_0_0_choices(2) / 2) + transform_right_column(1)) * 2) +
        as_number(transform_right_filter_column_0_0_choice_3);
      transform_right_filter_column_0(1 to 2) <= transform_right_filter_column_0(0 to 1);
    end if;
    -- raster
    raster_place_group_is_equal := raster_place_column = 449;
    raster_features_search_0 <= transform_right_filter_feature_0;
    raster_features_reference_0 <= transform_left_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(2);
    raster_place_group <= choice(transform_filtering_start_of_frame(2) and transform_filtering_valid(2), 0,
      (raster_place_group + as_number(((raster_place_group /= 382) and raster_place_group_is_equal and
      transform_filtering_valid(2)))) mod 512);
    if transform_filtering_valid(2) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(2), 0,
        (raster_place_column + 1) mod 512);
    end if;
    -- delay
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 15) and (raster_place_group < 390);
    delay_row_inside(1) <= raster_place_group < 375;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 63;
    delay_tag.first_cost <= raster_place_column = 63;
    delay_tag.leaves_window <= (((((raster_place_column / 2) + 32729) mod 32768) * 2) + (raster_place_column mod 2)) <
      65465;
    delay_tag.output_column <= (raster_place_group >= 7) and (raster_place_group < 382) and ((((((raster_place_column /
      64) + 1023) mod 1024) * 64) + (raster_place_column mod 64)) < 386);
    delay_tag.start_of_frame <= (raster_place_group = 7) and (raster_place_column = 64);
    delay_tag.end_of_line <= raster_place_group_is_equal;
    -- rows
    rows_search_rows_read_newest_0 <= delay_delayed_0;
    rows_search_rows_ready_words(0) <= to_integer(rows_search_rows_read_words(0));
    rows_search_rows_ready_words(1) <= to_integer(rows_search_rows_read_words(1));
    rows_search_rows_ready_words(2) <= to_integer(rows_search_rows_read_words(2));
    rows_search_rows_ready_words_3 <= to_integer(rows_search_rows_read_words_3);
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_ahead_0;
    rows_reference_rows_ready_words(0) <= to_integer(rows_reference_rows_read_words(0));
    rows_reference_rows_ready_words(1) <= to_integer(rows_reference_rows_read_words(1));
    rows_reference_rows_ready_words(2) <= to_integer(rows_reference_rows_read_words(2));
    rows_reference_rows_ready_words_3 <= to_integer(rows_reference_rows_read_words_3);
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_inside <= rows_ready_inside;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), rows_search_rows_ready_words(0) mod 128, 0);
    rows_reference(0) <= choice(rows_ready_inside(0), rows_reference_rows_ready_words(0) mod 128, 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0) <= (rows_search_rows_ready_words(0) / 128) + ((rows_search_rows_ready_words(1)
        mod 128) * 2097152);
      rows_search_rows_write_words(1) <= (rows_search_rows_ready_words(1) / 128) + ((rows_search_rows_ready_words(2)
        mod 128) * 2097152);
      rows_search_rows_write_words(2) <= (rows_search_rows_ready_words(2) / 128) + ((rows_search_rows_ready_words_3 mod
        128) * 2097152);
      rows_search_rows_write_words_3 <= (rows_search_rows_ready_words_3 / 128) + (rows_search_rows_ready_newest_0 *
        16384);
      rows_reference_rows_write_words(0) <= (rows_reference_rows_ready_words(0) / 128) +
        ((rows_reference_rows_ready_words(1) mod 128) * 2097152);
      rows_reference_rows_write_words(1) <= (rows_reference_rows_ready_words(1) / 128) +
        ((rows_reference_rows_ready_words(2) mod 128) * 2097152);
      rows_reference_rows_write_words(2) <= (rows_reference_rows_ready_words(2) / 128) +
        ((rows_reference_rows_ready_words_3 mod 128) * 2097152);
      rows_reference_rows_write_words_3 <= (rows_reference_rows_ready_words_3 / 128) +
        (rows_reference_rows_ready_newest_0 * 16384);
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
    for i in 0 to 4 loop
      slice0cost_column_0_choice(3 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        1024);
      slice0cost_column_0_choice(3 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3 * i)
        + slice0cost_column_0_choice(3 * i, 1)) mod 1024);
      slice0cost_column_0_choice(3 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0,
        (slice0cost_ready_words(i) / 1024) mod 1024);
      slice0cost_column_0_choice(3 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3
        * i + 1) + slice0cost_column_0_choice(3 * i + 1, 1)) mod 1024);
      slice0cost_column_0_choice(3 * i + 2, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 1048576);
      slice0cost_column_0_choice(3 * i + 2, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3
        * i + 2) + slice0cost_column_0_choice(3 * i + 2, 1)) mod 1024);
    end loop;
    slice0cost_column_0_choice(15, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words_5);
    slice0cost_column_0_choice(15, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(15) +
      slice0cost_column_0_choice(15, 1)) mod 1024);
    for i in 0 to 15 loop
      slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
    end loop;
    for i in 0 to 15 loop
      slice0cost_pixels_first(1, i) <= slice0shift_search(1, i) - slice0shift_reference(1);
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice0cost_pixels_cost(i, j) <= folded(slice0cost_pixels_first(i, j)) + as_number((slice0cost_pixels_first(i,
          j) < 0));
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 15 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 4 loop slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i)); end loop;
    slice0cost_ready_words_5 <= to_integer(slice0cost_read_words_5);
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 15 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag.valid <= slice0cost_ready_tag.valid;
    slice0cost_tag.first_group <= slice0cost_ready_tag.first_group;
    slice0cost_tag.border_column <= slice0cost_ready_tag.border_column;
    slice0cost_tag.first_cost <= slice0cost_ready_tag.first_cost;
    slice0cost_tag.leaves_window <= slice0cost_ready_tag.leaves_window;
    slice0cost_tag.output_column <= slice0cost_ready_tag.output_column;
    slice0cost_tag.start_of_frame <= slice0cost_ready_tag.start_of_frame;
    slice0cost_tag.end_of_line <= slice0cost_ready_tag.end_of_line;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 512);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        512);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 4 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(3 * i + 1, 2) * 1024) + slice0cost_column_0_choice(3 *
          i, 2) + (slice0cost_column_0_choice(3 * i + 2, 2) * 1048576);
      end loop;
      slice0cost_write_words(5) <= slice0cost_column_0_choice(15, 2);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 15, 0, (slice0window_ring_read_address
        + 1) mod 16);
    end if;
    for i in 0 to 4 loop
      for j in 0 to 2 loop
        slice0window_change_0_choice(3 * i + j) := choice(slice0window_entering_tag.leaves_window,
          to_integer(slice0window_leaving(i)(10 * j + 9 downto 10 * j)), 0);
      end loop;
    end loop;
    slice0window_change_0_choice(15) := choice(slice0window_entering_tag.leaves_window,
      to_integer(slice0window_leaving_5), 0);
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag <= slice0cost_tag;
    for i in 0 to 15 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_output_column_0 <= slice0window_change_tag.output_column;
    slice0window_centre_start_of_frame(0) <= slice0window_change_tag.start_of_frame;
    slice0window_centre_start_of_frame(1) <= slice0window_centre_start_of_frame(0);
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag_valid <= slice0window_change_tag.valid;
    for i in 0 to 15 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 15 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice0winner1
    slice0winner1_best_index_0_0_is_not_less := (slice0window_sum_0(0) - slice0window_sum_0(1)) >= 0;
    for i in 1 to 7 loop
      slice0winner1_best_index_0_is_less(i) := (slice0window_sum_0(2 * i) - slice0window_sum_0(2 * i + 1)) < 0;
    end loop;
    slice0winner1_held_0 <= slice0window_sum_0;
    slice0winner1_best_index_0_0 <= slice0winner1_best_index_0_0_is_not_less;
    slice0winner1_best_late_cost_0 <= slice0winner1_best_cost_0;
    for i in 1 to 7 loop slice0winner1_best_but_first_0(i) <= slice0winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice0winner1_best_but_last_0(i) <= slice0winner1_held_0(2 * i); end loop;
    slice0winner1_tag_valid <= slice0window_tag_valid;
    for i in 0 to 7 loop
      slice0winner1_best_cost_0(i) <= smaller(slice0window_sum_0(2 * i + 1), slice0window_sum_0(2 * i));
    end loop;
    for i in 1 to 7 loop
      slice0winner1_best_index_0(i) <= choice(slice0winner1_best_index_0_is_less(i), 2 * i, 2 * i + 1);
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_index_0_is_less(i), 0, slice0window_sum_0(2 * i));
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_index_0_is_less(i), slice0window_sum_0(2 * i + 1), 0);
    end loop;
    slice0winner1_best_below_0(0) <= choice(slice0winner1_best_index_0_0_is_not_less, slice0window_sum_0(0), 0);
    slice0winner1_best_above_0(0) <= choice(slice0winner1_best_index_0_0_is_not_less, 0, slice0window_sum_0(1));
    -- slice0winner2
    for i in 0 to 3 loop
      slice0winner2_best_index_0_is_not_less(i) := (slice0winner1_best_cost_0(2 * i) - slice0winner1_best_cost_0(2 * i
        + 1)) >= 0;
    end loop;
    for i in 0 to 3 loop
      slice0winner2_best_below_0_choice(i) := choice(others_from_13(i + 19), slice0winner1_held_0(4 * i + 1),
        slice0winner1_best_below_0(2 * i + 1));
    end loop;
    slice0winner2_best_above_0_choice(0) := choice(slice0winner1_best_index_0_0, slice0winner1_held_0(2),
      slice0winner1_best_above_0(0));
    slice0winner2_best_above_0_choice(1) := choice(is_set(slice0winner1_best_index_0(2), 2) and
      is_set(slice0winner1_best_index_0(2), 0), slice0winner1_held_0(6), slice0winner1_best_above_0(2));
    slice0winner2_best_above_0_choice(2) := choice(is_set(slice0winner1_best_index_0(4), 3) and
      is_set(slice0winner1_best_index_0(4), 0), slice0winner1_held_0(10), slice0winner1_best_above_0(4));
    slice0winner2_best_above_0_3_value := is_set(slice0winner1_best_index_0(6), 2);
    slice0winner2_best_above_0_choice(3) := choice(is_set(slice0winner1_best_index_0(6), 3) and
      slice0winner2_best_above_0_3_value and is_set(slice0winner1_best_index_0(6), 0), slice0winner1_held_0(14),
      slice0winner1_best_above_0(6));
    for i in 0 to 3 loop
      slice0winner2_best_second_0_choice(i, 1) := choice(slice0winner2_best_place_0(i), 16383,
        slice0winner1_best_late_cost_0(2 * i + 1));
      slice0winner2_best_second_0_choice(i, 2) := choice(slice0winner2_best_at_end_0(i),
        slice0winner1_best_but_first_0(2 * i + 1), slice0winner2_best_second_0_choice(i, 1));
      slice0winner2_best_second_0_choice(i, 3) := choice(slice0winner2_best_place_0(i),
        slice0winner1_best_late_cost_0(2 * i), 16383);
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
    slice0winner2_best_place_0 <= slice0winner2_best_index_0_is_not_less;
    for i in 0 to 3 loop
      slice0winner2_best_at_start_0(i) <= others_from_13(i + 19) and slice0winner2_best_index_0_is_not_less(i);
    end loop;
    slice0winner2_best_at_end_0(0) <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0(0) -
      slice0winner1_best_cost_0(1)) < 0);
    slice0winner2_best_at_end_0(1) <= ((slice0winner1_best_cost_0(2) - slice0winner1_best_cost_0(3)) < 0) and
      is_set(slice0winner1_best_index_0(2), 2) and is_set(slice0winner1_best_index_0(2), 0);
    slice0winner2_best_at_end_0(2) <= ((slice0winner1_best_cost_0(4) - slice0winner1_best_cost_0(5)) < 0) and
      is_set(slice0winner1_best_index_0(4), 3) and is_set(slice0winner1_best_index_0(4), 0);
    slice0winner2_best_at_end_0(3) <= ((slice0winner1_best_cost_0(6) - slice0winner1_best_cost_0(7)) < 0) and
      is_set(slice0winner1_best_index_0(6), 3) and slice0winner2_best_above_0_3_value and
      is_set(slice0winner1_best_index_0(6), 0);
    slice0winner2_best_late_cost_0 <= slice0winner2_best_cost_0;
    slice0winner2_tag.valid <= slice0winner1_tag_valid;
    for i in 0 to 3 loop
      slice0winner2_best_cost_0(i) <= smaller(slice0winner1_best_cost_0(2 * i + 1), slice0winner1_best_cost_0(2 * i));
    end loop;
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_index_0_is_not_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice0winner2_best_below_0(i) <= choice(slice0winner2_best_index_0_is_not_less(i),
        slice0winner2_best_below_0_choice(i), slice0winner1_best_below_0(2 * i));
      slice0winner2_best_above_0(i) <= choice(slice0winner2_best_index_0_is_not_less(i), slice0winner1_best_above_0(2 *
        i + 1), slice0winner2_best_above_0_choice(i));
      slice0winner2_best_index_0(i + 1) <= choice(slice0winner2_best_index_0_is_not_less(i + 1),
        slice0winner1_best_index_0(2 * i + 3), slice0winner1_best_index_0(2 * i + 2));
    end loop;
    slice0winner2_best_below_0(3) <= choice(slice0winner2_best_index_0_is_not_less(3),
      slice0winner2_best_below_0_choice(3), slice0winner1_best_below_0(6));
    slice0winner2_best_above_0(3) <= choice(slice0winner2_best_index_0_is_not_less(3), slice0winner1_best_above_0(7),
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
      slice0winner2_tag.output_column <= slice3window_centre_output_column(5);
      slice0winner2_tag.start_of_frame <= slice3window_centre_start_of_frame_5;
      slice0winner2_tag.end_of_line <= slice3window_centre_end_of_line(5);
    end if;
    -- slice0winner3
    slice0winner3_best_index_0_is_not_less(0) := (slice0winner2_best_cost_0(0) - slice0winner2_best_cost_0(1)) >= 0;
    slice0winner3_best_index_0_is_not_less(1) := (slice0winner2_best_cost_0(2) - slice0winner2_best_cost_0(3)) >= 0;
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
    slice0winner3_best_place_0 <= slice0winner3_best_index_0_is_not_less;
    slice0winner3_best_at_start_0(0) <= slice0winner3_best_index_0_is_not_less(0) and
      slice0winner3_best_below_0_is_equal(0);
    slice0winner3_best_at_start_0(1) <= slice0winner3_best_below_0_is_equal(1) and
      slice0winner3_best_index_0_is_not_less(1);
    slice0winner3_best_at_end_0(0) <= ((slice0winner2_best_cost_0(0) - slice0winner2_best_cost_0(1)) < 0) and
      slice0winner3_best_above_0_is_equal(0);
    slice0winner3_best_at_end_0(1) <= ((slice0winner2_best_cost_0(2) - slice0winner2_best_cost_0(3)) < 0) and
      is_set(slice0winner2_best_index_0(2), 3) and slice0winner3_best_above_0_is_equal(1);
    slice0winner3_best_late_cost_0 <= slice0winner3_best_cost_0;
    slice0winner3_tag <= slice0winner2_tag;
    slice0winner3_best_cost_0(0) <= smaller(slice0winner2_best_cost_0(1), slice0winner2_best_cost_0(0));
    slice0winner3_best_cost_0(1) <= smaller(slice0winner2_best_cost_0(3), slice0winner2_best_cost_0(2));
    for i in 0 to 1 loop
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_index_0_is_not_less(i), slice0winner2_best_index_0(2 *
        i + 1), slice0winner2_best_index_0(2 * i));
      slice0winner3_best_below_0(i) <= choice(slice0winner3_best_index_0_is_not_less(i),
        slice0winner3_best_below_0_choice(i), slice0winner2_best_below_0(2 * i));
      slice0winner3_best_above_0(i) <= choice(slice0winner3_best_index_0_is_not_less(i), slice0winner2_best_above_0(2 *
        i + 1), slice0winner3_best_above_0_choice(i));
    end loop;
    slice0winner3_best_second_0(0) <= smaller(slice0winner3_best_second_0_choice(0, 2),
      slice0winner3_best_second_0_choice(0, 4));
    slice0winner3_best_second_0(1) <= smaller(slice0winner3_best_second_0_choice(1, 2),
      slice0winner3_best_second_0_choice(1, 4));
    slice0winner3_best_but_first_0_1 <= smaller(slice0winner2_best_late_cost_0(3), slice0winner2_best_but_first_0(2));
    slice0winner3_best_but_last_0(0) <= smaller(slice0winner2_best_but_last_0(1), slice0winner2_best_late_cost_0(0));
    slice0winner3_best_but_last_0(1) <= smaller(slice0winner2_best_but_last_0(3), slice0winner2_best_late_cost_0(2));
    -- slice0winner4
    slice0winner4_best_index_0_0_is_less := (slice0winner3_best_cost_0(0) - slice0winner3_best_cost_0(1)) < 0;
    slice0winner4_best_below_0_0_is_equal := slice0winner3_best_index_0(1) = 8;
    slice0winner4_best_below_0_0_choice := choice(slice0winner4_best_below_0_0_is_equal, slice0winner3_best_last_0(0),
      slice0winner3_best_below_0(1));
    slice0winner4_best_above_0_0_is_equal := slice0winner3_best_index_0(0) = 7;
    slice0winner4_best_above_0_0_choice := choice(slice0winner4_best_above_0_0_is_equal, slice0winner3_best_first_0_1,
      slice0winner3_best_above_0(0));
    slice0winner4_best_place_0_0_is_not_less := (slice0winner3_best_cost_0(0) - slice0winner3_best_cost_0(1)) >= 0;
    slice0winner4_best_second_0_0_choices(1) := choice(slice0winner4_best_place_0_0, slice0winner3_best_second_0(1),
      slice0winner3_best_late_cost_0(1));
    slice0winner4_best_second_0_0_choices(2) := choice(slice0winner4_best_at_end_0_0, slice0winner3_best_but_first_0_1,
      slice0winner4_best_second_0_0_choices(1));
    slice0winner4_best_second_0_0_choices(3) := choice(slice0winner4_best_place_0_0, slice0winner3_best_late_cost_0(0),
      slice0winner3_best_second_0(0));
    slice0winner4_best_second_0_0_choices(4) := choice(slice0winner4_best_at_start_0_0,
      slice0winner3_best_but_last_0(0), slice0winner4_best_second_0_0_choices(3));
    slice0winner4_best_last_0_0 <= slice0winner3_best_last_0(1);
    slice0winner4_best_place_0_0 <= slice0winner4_best_place_0_0_is_not_less;
    slice0winner4_best_at_start_0_0 <= slice0winner4_best_below_0_0_is_equal and
      slice0winner4_best_place_0_0_is_not_less;
    slice0winner4_best_at_end_0_0 <= slice0winner4_best_index_0_0_is_less and slice0winner4_best_above_0_0_is_equal;
    slice0winner4_best_late_cost_0_0 <= slice0winner4_best_cost_0_0;
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost_0_0 <= smaller(slice0winner3_best_cost_0(1), slice0winner3_best_cost_0(0));
    slice0winner4_best_index_0_0 <= choice(slice0winner4_best_index_0_0_is_less, slice0winner3_best_index_0(0),
      slice0winner3_best_index_0(1));
    slice0winner4_best_below_0_0 <= choice(slice0winner4_best_index_0_0_is_less, slice0winner3_best_below_0(0),
      slice0winner4_best_below_0_0_choice);
    slice0winner4_best_above_0_0 <= choice(slice0winner4_best_index_0_0_is_less, slice0winner4_best_above_0_0_choice,
      slice0winner3_best_above_0(1));
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
    for i in 0 to 4 loop
      slice1cost_column_0_choice(3 * i, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) mod 1024);
      slice1cost_column_0_choice(3 * i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i) +
        slice1cost_column_0_choice(3 * i, 1)) mod 1024);
      slice1cost_column_0_choice(3 * i + 1, 1) := choice(slice0cost_tag.first_group, 0, (slice1cost_ready_words(i) /
        1024) mod 1024);
      slice1cost_column_0_choice(3 * i + 1, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i +
        1) + slice1cost_column_0_choice(3 * i + 1, 1)) mod 1024);
      slice1cost_column_0_choice(3 * i + 2, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) /
        1048576);
      slice1cost_column_0_choice(3 * i + 2, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i +
        2) + slice1cost_column_0_choice(3 * i + 2, 1)) mod 1024);
    end loop;
    slice1cost_column_0_choice(15, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words_5);
    slice1cost_column_0_choice(15, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(15) +
      slice1cost_column_0_choice(15, 1)) mod 1024);
    for i in 0 to 15 loop
      slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
    end loop;
    for i in 0 to 15 loop
      slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice1cost_pixels_cost(i, j) <= folded(slice1cost_pixels_first(i, j)) + as_number((slice1cost_pixels_first(i,
          j) < 0));
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 15 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 4 loop slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i)); end loop;
    slice1cost_ready_words_5 <= to_integer(slice1cost_read_words_5);
    for i in 0 to 15 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 4 loop
        slice1cost_write_words(i) <= (slice1cost_column_0_choice(3 * i + 1, 2) * 1024) + slice1cost_column_0_choice(3 *
          i, 2) + (slice1cost_column_0_choice(3 * i + 2, 2) * 1048576);
      end loop;
      slice1cost_write_words(5) <= slice1cost_column_0_choice(15, 2);
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 15, 0, (slice1window_ring_read_address
        + 1) mod 16);
    end if;
    for i in 0 to 4 loop
      for j in 0 to 2 loop
        slice1window_change_0_choice(3 * i + j) := choice(slice0window_change_tag.leaves_window,
          to_integer(slice1window_leaving(i)(10 * j + 9 downto 10 * j)), 0);
      end loop;
    end loop;
    slice1window_change_0_choice(15) := choice(slice0window_change_tag.leaves_window,
      to_integer(slice1window_leaving_5), 0);
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 15 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    slice1window_change_tag.first_cost <= slice0window_change_tag.first_cost;
    slice1window_change_tag.leaves_window <= slice0window_change_tag.leaves_window;
    slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
    slice1window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame(1);
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    for i in 0 to 15 loop
      slice1window_sum_0_choice(i) := choice(slice1window_change_tag.first_cost, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag_valid then
      for i in 0 to 15 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
      end loop;
    end if;
    if slice0winner2_tag.valid then
      slice1window_centre_start_of_frame(3) <= slice3window_centre_start_of_frame_1;
      slice1window_centre_start_of_frame(4 to 5) <= slice1window_centre_start_of_frame(3 to 4);
    end if;
    -- slice1winner1
    slice1winner1_best_index_0_0_is_not_less := (slice1window_sum_0(0) - slice1window_sum_0(1)) >= 0;
    for i in 1 to 7 loop
      slice1winner1_best_index_0_is_less(i) := (slice1window_sum_0(2 * i) - slice1window_sum_0(2 * i + 1)) < 0;
    end loop;
    slice1winner1_held_0 <= slice1window_sum_0;
    slice1winner1_best_index_0_0 <= slice1winner1_best_index_0_0_is_not_less;
    slice1winner1_best_late_cost_0 <= slice1winner1_best_cost_0;
    for i in 0 to 7 loop slice1winner1_best_but_first_0(i) <= slice1winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice1winner1_best_but_last_0(i) <= slice1winner1_held_0(2 * i); end loop;
    for i in 0 to 7 loop
      slice1winner1_best_cost_0(i) <= smaller(slice1window_sum_0(2 * i + 1), slice1window_sum_0(2 * i));
    end loop;
    for i in 1 to 7 loop
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_index_0_is_less(i), 2 * i, 2 * i + 1);
      slice1winner1_best_below_0(i) <= choice(slice1winner1_best_index_0_is_less(i), 0, slice1window_sum_0(2 * i));
      slice1winner1_best_above_0(i) <= choice(slice1winner1_best_index_0_is_less(i), slice1window_sum_0(2 * i + 1), 0);
    end loop;
    slice1winner1_best_below_0(0) <= choice(slice1winner1_best_index_0_0_is_not_less, slice1window_sum_0(0), 0);
    slice1winner1_best_above_0(0) <= choice(slice1winner1_best_index_0_0_is_not_less, 0, slice1window_sum_0(1));
    -- slice1winner2
    for i in 0 to 3 loop
      slice1winner2_best_index_0_is_not_less(i) := (slice1winner1_best_cost_0(2 * i) - slice1winner1_best_cost_0(2 * i
        + 1)) >= 0;
    end loop;
    for i in 0 to 3 loop
      slice1winner2_best_below_0_choice(i) := choice(others_from_13(i + 15), slice1winner1_held_0(4 * i + 1),
        slice1winner1_best_below_0(2 * i + 1));
    end loop;
    slice1winner2_best_above_0_choice(0) := choice(slice1winner1_best_index_0_0, slice1winner1_held_0(2),
      slice1winner1_best_above_0(0));
    slice1winner2_best_above_0_choice(1) := choice(is_set(slice1winner1_best_index_0(2), 2) and
      is_set(slice1winner1_best_index_0(2), 0), slice1winner1_held_0(6), slice1winner1_best_above_0(2));
    slice1winner2_best_above_0_choice(2) := choice(is_set(slice1winner1_best_index_0(4), 3) and
      is_set(slice1winner1_best_index_0(4), 0), slice1winner1_held_0(10), slice1winner1_best_above_0(4));
    slice1winner2_best_above_0_3_value := is_set(slice1winner1_best_index_0(6), 2);
    slice1winner2_best_above_0_choice(3) := choice(is_set(slice1winner1_best_index_0(6), 3) and
      slice1winner2_best_above_0_3_value and is_set(slice1winner1_best_index_0(6), 0), slice1winner1_held_0(14),
      slice1winner1_best_above_0(6));
    for i in 0 to 3 loop
      slice1winner2_best_second_0_choice(i, 1) := choice(slice1winner2_best_place_0(i), 16383,
        slice1winner1_best_late_cost_0(2 * i + 1));
      slice1winner2_best_second_0_choice(i, 2) := choice(slice1winner2_best_at_end_0(i),
        slice1winner1_best_but_first_0(2 * i + 1), slice1winner2_best_second_0_choice(i, 1));
      slice1winner2_best_second_0_choice(i, 3) := choice(slice1winner2_best_place_0(i),
        slice1winner1_best_late_cost_0(2 * i), 16383);
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
    slice1winner2_best_place_0 <= slice1winner2_best_index_0_is_not_less;
    for i in 0 to 3 loop
      slice1winner2_best_at_start_0(i) <= others_from_13(i + 15) and slice1winner2_best_index_0_is_not_less(i);
    end loop;
    slice1winner2_best_at_end_0(0) <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0(0) -
      slice1winner1_best_cost_0(1)) < 0);
    slice1winner2_best_at_end_0(1) <= ((slice1winner1_best_cost_0(2) - slice1winner1_best_cost_0(3)) < 0) and
      is_set(slice1winner1_best_index_0(2), 2) and is_set(slice1winner1_best_index_0(2), 0);
    slice1winner2_best_at_end_0(2) <= ((slice1winner1_best_cost_0(4) - slice1winner1_best_cost_0(5)) < 0) and
      is_set(slice1winner1_best_index_0(4), 3) and is_set(slice1winner1_best_index_0(4), 0);
    slice1winner2_best_at_end_0(3) <= ((slice1winner1_best_cost_0(6) - slice1winner1_best_cost_0(7)) < 0) and
      is_set(slice1winner1_best_index_0(6), 3) and slice1winner2_best_above_0_3_value and
      is_set(slice1winner1_best_index_0(6), 0);
    slice1winner2_best_late_cost_0 <= slice1winner2_best_cost_0;
    for i in 0 to 3 loop
      slice1winner2_best_cost_0(i) <= smaller(slice1winner1_best_cost_0(2 * i + 1), slice1winner1_best_cost_0(2 * i));
    end loop;
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_index_0_is_not_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice1winner2_best_below_0(i) <= choice(slice1winner2_best_index_0_is_not_less(i),
        slice1winner2_best_below_0_choice(i), slice1winner1_best_below_0(2 * i));
      slice1winner2_best_above_0(i) <= choice(slice1winner2_best_index_0_is_not_less(i), slice1winner1_best_above_0(2 *
        i + 1), slice1winner2_best_above_0_choice(i));
      slice1winner2_best_index_0(i + 1) <= choice(slice1winner2_best_index_0_is_not_less(i + 1),
        slice1winner1_best_index_0(2 * i + 3), slice1winner1_best_index_0(2 * i + 2));
    end loop;
    slice1winner2_best_below_0(3) <= choice(slice1winner2_best_index_0_is_not_less(3),
      slice1winner2_best_below_0_choice(3), slice1winner1_best_below_0(6));
    slice1winner2_best_above_0(3) <= choice(slice1winner2_best_index_0_is_not_less(3), slice1winner1_best_above_0(7),
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
    slice1winner3_best_index_0_is_not_less(0) := (slice1winner2_best_cost_0(0) - slice1winner2_best_cost_0(1)) >= 0;
    slice1winner3_best_index_0_is_not_less(1) := (slice1winner2_best_cost_0(2) - slice1winner2_best_cost_0(3)) >= 0;
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
    slice1winner3_best_place_0 <= slice1winner3_best_index_0_is_not_less;
    slice1winner3_best_at_start_0(0) <= slice1winner3_best_index_0_is_not_less(0) and
      slice1winner3_best_below_0_is_equal(0);
    slice1winner3_best_at_start_0(1) <= slice1winner3_best_below_0_is_equal(1) and
      slice1winner3_best_index_0_is_not_less(1);
    slice1winner3_best_at_end_0(0) <= ((slice1winner2_best_cost_0(0) - slice1winner2_best_cost_0(1)) < 0) and
      slice1winner3_best_above_0_is_equal(0);
    slice1winner3_best_at_end_0(1) <= ((slice1winner2_best_cost_0(2) - slice1winner2_best_cost_0(3)) < 0) and
      is_set(slice1winner2_best_index_0(2), 3) and slice1winner3_best_above_0_is_equal(1);
    slice1winner3_best_late_cost_0 <= slice1winner3_best_cost_0;
    slice1winner3_best_cost_0(0) <= smaller(slice1winner2_best_cost_0(1), slice1winner2_best_cost_0(0));
    slice1winner3_best_cost_0(1) <= smaller(slice1winner2_best_cost_0(3), slice1winner2_best_cost_0(2));
    for i in 0 to 1 loop
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_index_0_is_not_less(i), slice1winner2_best_index_0(2 *
        i + 1), slice1winner2_best_index_0(2 * i));
      slice1winner3_best_below_0(i) <= choice(slice1winner3_best_index_0_is_not_less(i),
        slice1winner3_best_below_0_choice(i), slice1winner2_best_below_0(2 * i));
      slice1winner3_best_above_0(i) <= choice(slice1winner3_best_index_0_is_not_less(i), slice1winner2_best_above_0(2 *
        i + 1), slice1winner3_best_above_0_choice(i));
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
    slice1winner4_best_index_0_0_is_less := (slice1winner3_best_cost_0(0) - slice1winner3_best_cost_0(1)) < 0;
    slice1winner4_best_below_0_0_is_equal := slice1winner3_best_index_0(1) = 8;
    slice1winner4_best_below_0_0_choice := choice(slice1winner4_best_below_0_0_is_equal, slice1winner3_best_last_0(0),
      slice1winner3_best_below_0(1));
    slice1winner4_best_above_0_0_is_equal := slice1winner3_best_index_0(0) = 7;
    slice1winner4_best_above_0_0_choice := choice(slice1winner4_best_above_0_0_is_equal, slice1winner3_best_first_0(1),
      slice1winner3_best_above_0(0));
    slice1winner4_best_place_0_0_is_not_less := (slice1winner3_best_cost_0(0) - slice1winner3_best_cost_0(1)) >= 0;
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
    slice1winner4_best_place_0_0 <= slice1winner4_best_place_0_0_is_not_less;
    slice1winner4_best_at_start_0_0 <= slice1winner4_best_below_0_0_is_equal and
      slice1winner4_best_place_0_0_is_not_less;
    slice1winner4_best_at_end_0_0 <= slice1winner4_best_index_0_0_is_less and slice1winner4_best_above_0_0_is_equal;
    slice1winner4_best_late_cost_0_0 <= slice1winner4_best_cost_0_0;
    slice1winner4_best_cost_0_0 <= smaller(slice1winner3_best_cost_0(1), slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_index_0_0_is_less, slice1winner3_best_index_0(0),
      slice1winner3_best_index_0(1));
    slice1winner4_best_below_0_0 <= choice(slice1winner4_best_index_0_0_is_less, slice1winner3_best_below_0(0),
      slice1winner4_best_below_0_0_choice);
    slice1winner4_best_above_0_0 <= choice(slice1winner4_best_index_0_0_is_less, slice1winner4_best_above_0_0_choice,
      slice1winner3_best_above_0(1));
    slice1winner4_best_second_0_0 <= smaller(slice1winner4_best_second_0_0_choices(2),
      slice1winner4_best_second_0_0_choices(4));
    slice1winner4_best_but_first_0_0 <= smaller(slice1winner3_best_late_cost_0(1), slice1winner3_best_but_first_0(0));
    slice1winner4_best_but_last_0_0 <= smaller(slice1winner3_best_but_last_0(1), slice1winner3_best_late_cost_0(0));
    -- slice1
    slice1_best_index_0_0_is_less := (slice0winner4_best_late_cost_0_0 - slice1winner4_best_cost_0_0) < 0;
    slice1_best_below_0_0_is_equal := slice1winner4_best_index_0_0 = 0;
    slice1_best_below_0_0_choice := choice(slice1_best_below_0_0_is_equal, slice0_best_last_0_0,
      slice1winner4_best_below_0_0);
    slice1_best_above_0_0_is_equal := slice0_best_index_0_0 = 15;
    slice1_best_above_0_0_choice := choice(slice1_best_above_0_0_is_equal, slice1winner4_best_first_0_0,
      slice0_best_above_0_0);
    slice1_best_place_0_0_is_not_less := (slice0winner4_best_late_cost_0_0 - slice1winner4_best_cost_0_0) >= 0;
    slice1_best_second_0_0_choices(1) := choice(slice1_best_place_0_0, slice1winner4_best_second_0_0,
      slice1winner4_best_late_cost_0_0);
    slice1_best_second_0_0_choices(2) := choice(slice1_best_at_end_0_0, slice1winner4_best_but_first_0_0,
      slice1_best_second_0_0_choices(1));
    slice1_best_second_0_0_choices(3) := choice(slice1_best_place_0_0, slice0_best_late_cost_0_0,
      slice0_best_second_0_0);
    slice1_best_second_0_0_choices(4) := choice(slice1_best_at_start_0_0, slice0_best_but_last_0_0,
      slice1_best_second_0_0_choices(3));
    slice1_best_last_0_0 <= slice1winner4_best_last_0_0;
    slice1_best_place_0_0 <= slice1_best_place_0_0_is_not_less;
    slice1_best_at_start_0_0 <= slice1_best_below_0_0_is_equal and slice1_best_place_0_0_is_not_less;
    slice1_best_at_end_0_0 <= slice1_best_above_0_0_is_equal and slice1_best_index_0_0_is_less;
    slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= smaller(slice1winner4_best_cost_0_0, slice0winner4_best_late_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_index_0_0_is_less, slice0_best_index_0_0, slice1winner4_best_index_0_0
      + 16);
    slice1_best_below_0_0 <= choice(slice1_best_index_0_0_is_less, slice0_best_below_0_0, slice1_best_below_0_0_choice);
    slice1_best_above_0_0 <= choice(slice1_best_index_0_0_is_less, slice1_best_above_0_0_choice,
      slice1winner4_best_above_0_0);
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
    for i in 0 to 4 loop
      slice2cost_column_0_choice(3 * i, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) mod 1024);
      slice2cost_column_0_choice(3 * i, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(3
        * i) + slice2cost_column_0_choice(3 * i, 1)) mod 1024);
      slice2cost_column_0_choice(3 * i + 1, 1) := choice(slice0window_entering_tag.first_group, 0,
        (slice2cost_ready_words(i) / 1024) mod 1024);
      slice2cost_column_0_choice(3 * i + 1, 2) := choice(slice0window_entering_tag.border_column, 0,
        (slice2cost_change_0(3 * i + 1) + slice2cost_column_0_choice(3 * i + 1, 1)) mod 1024);
      slice2cost_column_0_choice(3 * i + 2, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) / 1048576);
      slice2cost_column_0_choice(3 * i + 2, 2) := choice(slice0window_entering_tag.border_column, 0,
        (slice2cost_change_0(3 * i + 2) + slice2cost_column_0_choice(3 * i + 2, 1)) mod 1024);
    end loop;
    slice2cost_column_0_choice(15, 1) := choice(slice0window_entering_tag.first_group, 0, slice2cost_ready_words_5);
    slice2cost_column_0_choice(15, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(15) +
      slice2cost_column_0_choice(15, 1)) mod 1024);
    for i in 0 to 15 loop
      slice2cost_pixels_first(0, i) <= slice2shift_search(0, i) - slice2shift_reference(0);
    end loop;
    for i in 0 to 15 loop
      slice2cost_pixels_first(1, i) <= slice2shift_search(1, i) - slice2shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice2cost_pixels_cost(i, j) <= folded(slice2cost_pixels_first(i, j)) + as_number((slice2cost_pixels_first(i,
          j) < 0));
      end loop;
    end loop;
    for i in 0 to 15 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 4 loop slice2cost_ready_words(i) <= to_integer(slice2cost_read_words(i)); end loop;
    slice2cost_ready_words_5 <= to_integer(slice2cost_read_words_5);
    slice2cost_ready_column <= slice2cost_change_column;
    for i in 0 to 15 loop slice2cost_column_0(i) <= slice2cost_column_0_choice(i, 2); end loop;
    slice2cost_write_column <= slice2cost_ready_column;
    if slice0cost_pixels_tag.valid then
      slice2cost_read_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice2cost_read_column + 1) mod 512);
    end if;
    if slice0cost_ready_tag.valid then
      slice2cost_change_column <= choice(slice0cost_ready_tag.row_start, 0, (slice2cost_change_column + 1) mod 512);
    end if;
    if slice0window_entering_tag.valid then
      for i in 0 to 4 loop
        slice2cost_write_words(i) <= (slice2cost_column_0_choice(3 * i + 1, 2) * 1024) + slice2cost_column_0_choice(3 *
          i, 2) + (slice2cost_column_0_choice(3 * i + 2, 2) * 1048576);
      end loop;
      slice2cost_write_words(5) <= slice2cost_column_0_choice(15, 2);
    end if;
    -- slice2window
    if slice0window_change_tag.valid then
      slice2window_ring_write_address <= slice2window_ring_read_address;
      slice2window_ring_read_address <= choice(slice2window_ring_read_address = 15, 0, (slice2window_ring_read_address
        + 1) mod 16);
    end if;
    for i in 0 to 4 loop
      for j in 0 to 2 loop
        slice2window_change_0_choice(3 * i + j) := choice(slice1window_change_tag.leaves_window,
          to_integer(slice2window_leaving(i)(10 * j + 9 downto 10 * j)), 0);
      end loop;
    end loop;
    slice2window_change_0_choice(15) := choice(slice1window_change_tag.leaves_window,
      to_integer(slice2window_leaving_5), 0);
    slice2window_entering_0 <= slice2cost_column_0;
    for i in 0 to 15 loop
      slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
    end loop;
    slice2window_change_tag <= slice1window_change_tag;
    slice2window_centre_output_column_0 <= slice1window_centre_output_column_0;
    slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
    for i in 0 to 15 loop
      slice2window_sum_0_choice(i) := choice(slice2window_change_tag.first_cost, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag_valid then
      for i in 0 to 15 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 16384;
      end loop;
    end if;
    if slice0winner2_tag.valid then
      slice2window_centre_start_of_frame_1 <= slice1window_centre_start_of_frame_1;
    end if;
    -- slice2winner1
    slice2winner1_best_index_0_0_is_not_less := (slice2window_sum_0(0) - slice2window_sum_0(1)) >= 0;
    for i in 1 to 7 loop
      slice2winner1_best_index_0_is_less(i) := (slice2window_sum_0(2 * i) - slice2window_sum_0(2 * i + 1)) < 0;
    end loop;
    slice2winner1_held_0 <= slice2window_sum_0;
    slice2winner1_best_index_0_0 <= slice2winner1_best_index_0_0_is_not_less;
    slice2winner1_best_late_cost_0 <= slice2winner1_best_cost_0;
    for i in 0 to 7 loop slice2winner1_best_but_first_0(i) <= slice2winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 7 loop slice2winner1_best_but_last_0(i) <= slice2winner1_held_0(2 * i); end loop;
    for i in 0 to 7 loop
      slice2winner1_best_cost_0(i) <= smaller(slice2window_sum_0(2 * i + 1), slice2window_sum_0(2 * i));
    end loop;
    for i in 1 to 7 loop
      slice2winner1_best_index_0(i) <= choice(slice2winner1_best_index_0_is_less(i), 2 * i, 2 * i + 1);
      slice2winner1_best_below_0(i) <= choice(slice2winner1_best_index_0_is_less(i), 0, slice2window_sum_0(2 * i));
      slice2winner1_best_above_0(i) <= choice(slice2winner1_best_index_0_is_less(i), slice2window_sum_0(2 * i + 1), 0);
    end loop;
    slice2winner1_best_below_0(0) <= choice(slice2winner1_best_index_0_0_is_not_less, slice2window_sum_0(0), 0);
    slice2winner1_best_above_0(0) <= choice(slice2winner1_best_index_0_0_is_not_less, 0, slice2window_sum_0(1));
    -- slice2winner2
    for i in 0 to 3 loop
      slice2winner2_best_index_0_is_not_less(i) := (slice2winner1_best_cost_0(2 * i) - slice2winner1_best_cost_0(2 * i
        + 1)) >= 0;
    end loop;
    slice2winner2_best_below_0_choice(0) := choice(other(4), slice2winner1_held_0(1), slice2winner1_best_below_0(1));
    slice2winner2_best_below_0_choice(1) := choice(other(5), slice2winner1_held_0(5), slice2winner1_best_below_0(3));
    slice2winner2_best_below_0_choice(2) := choice(others_from_13(13), slice2winner1_held_0(9),
      slice2winner1_best_below_0(5));
    slice2winner2_best_below_0_choice(3) := choice(others_from_13(14), slice2winner1_held_0(13),
      slice2winner1_best_below_0(7));
    slice2winner2_best_above_0_choice(0) := choice(slice2winner1_best_index_0_0, slice2winner1_held_0(2),
      slice2winner1_best_above_0(0));
    slice2winner2_best_above_0_choice(1) := choice(is_set(slice2winner1_best_index_0(2), 2) and
      is_set(slice2winner1_best_index_0(2), 0), slice2winner1_held_0(6), slice2winner1_best_above_0(2));
    slice2winner2_best_above_0_choice(2) := choice(is_set(slice2winner1_best_index_0(4), 3) and
      is_set(slice2winner1_best_index_0(4), 0), slice2winner1_held_0(10), slice2winner1_best_above_0(4));
    slice2winner2_best_above_0_3_value := is_set(slice2winner1_best_index_0(6), 2);
    slice2winner2_best_above_0_choice(3) := choice(is_set(slice2winner1_best_index_0(6), 3) and
      slice2winner2_best_above_0_3_value and is_set(slice2winner1_best_index_0(6), 0), slice2winner1_held_0(14),
      slice2winner1_best_above_0(6));
    for i in 0 to 3 loop
      slice2winner2_best_second_0_choice(i, 1) := choice(slice2winner2_best_place_0(i), 16383,
        slice2winner1_best_late_cost_0(2 * i + 1));
      slice2winner2_best_second_0_choice(i, 2) := choice(slice2winner2_best_at_end_0(i),
        slice2winner1_best_but_first_0(2 * i + 1), slice2winner2_best_second_0_choice(i, 1));
      slice2winner2_best_second_0_choice(i, 3) := choice(slice2winner2_best_place_0(i),
        slice2winner1_best_late_cost_0(2 * i), 16383);
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
    slice2winner2_best_place_0 <= slice2winner2_best_index_0_is_not_less;
    slice2winner2_best_at_start_0(0) <= other(4) and slice2winner2_best_index_0_is_not_less(0);
    slice2winner2_best_at_start_0(1) <= other(5) and slice2winner2_best_index_0_is_not_less(1);
    slice2winner2_best_at_start_0(2) <= others_from_13(13) and slice2winner2_best_index_0_is_not_less(2);
    slice2winner2_best_at_start_0(3) <= others_from_13(14) and slice2winner2_best_index_0_is_not_less(3);
    slice2winner2_best_at_end_0(0) <= slice2winner1_best_index_0_0 and ((slice2winner1_best_cost_0(0) -
      slice2winner1_best_cost_0(1)) < 0);
    slice2winner2_best_at_end_0(1) <= ((slice2winner1_best_cost_0(2) - slice2winner1_best_cost_0(3)) < 0) and
      is_set(slice2winner1_best_index_0(2), 2) and is_set(slice2winner1_best_index_0(2), 0);
    slice2winner2_best_at_end_0(2) <= ((slice2winner1_best_cost_0(4) - slice2winner1_best_cost_0(5)) < 0) and
      is_set(slice2winner1_best_index_0(4), 3) and is_set(slice2winner1_best_index_0(4), 0);
    slice2winner2_best_at_end_0(3) <= ((slice2winner1_best_cost_0(6) - slice2winner1_best_cost_0(7)) < 0) and
      is_set(slice2winner1_best_index_0(6), 3) and slice2winner2_best_above_0_3_value and
      is_set(slice2winner1_best_index_0(6), 0);
    slice2winner2_best_late_cost_0 <= slice2winner2_best_cost_0;
    for i in 0 to 3 loop
      slice2winner2_best_cost_0(i) <= smaller(slice2winner1_best_cost_0(2 * i + 1), slice2winner1_best_cost_0(2 * i));
    end loop;
    slice2winner2_best_index_0(0) <= choice(slice2winner2_best_index_0_is_not_less(0), slice2winner1_best_index_0(1),
      as_number(slice2winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice2winner2_best_below_0(i) <= choice(slice2winner2_best_index_0_is_not_less(i),
        slice2winner2_best_below_0_choice(i), slice2winner1_best_below_0(2 * i));
      slice2winner2_best_above_0(i) <= choice(slice2winner2_best_index_0_is_not_less(i), slice2winner1_best_above_0(2 *
        i + 1), slice2winner2_best_above_0_choice(i));
      slice2winner2_best_index_0(i + 1) <= choice(slice2winner2_best_index_0_is_not_less(i + 1),
        slice2winner1_best_index_0(2 * i + 3), slice2winner1_best_index_0(2 * i + 2));
    end loop;
    slice2winner2_best_below_0(3) <= choice(slice2winner2_best_index_0_is_not_less(3),
      slice2winner2_best_below_0_choice(3), slice2winner1_best_below_0(6));
    slice2winner2_best_above_0(3) <= choice(slice2winner2_best_index_0_is_not_less(3), slice2winner1_best_above_0(7),
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
    slice2winner3_best_index_0_is_not_less(0) := (slice2winner2_best_cost_0(0) - slice2winner2_best_cost_0(1)) >= 0;
    slice2winner3_best_index_0_is_not_less(1) := (slice2winner2_best_cost_0(2) - slice2winner2_best_cost_0(3)) >= 0;
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
    slice2winner3_best_place_0 <= slice2winner3_best_index_0_is_not_less;
    slice2winner3_best_at_start_0(0) <= slice2winner3_best_index_0_is_not_less(0) and
      slice2winner3_best_below_0_is_equal(0);
    slice2winner3_best_at_start_0(1) <= slice2winner3_best_below_0_is_equal(1) and
      slice2winner3_best_index_0_is_not_less(1);
    slice2winner3_best_at_end_0(0) <= ((slice2winner2_best_cost_0(0) - slice2winner2_best_cost_0(1)) < 0) and
      slice2winner3_best_above_0_is_equal(0);
    slice2winner3_best_at_end_0(1) <= ((slice2winner2_best_cost_0(2) - slice2winner2_best_cost_0(3)) < 0) and
      is_set(slice2winner2_best_index_0(2), 3) and slice2winner3_best_above_0_is_equal(1);
    slice2winner3_best_late_cost_0 <= slice2winner3_best_cost_0;
    slice2winner3_best_cost_0(0) <= smaller(slice2winner2_best_cost_0(1), slice2winner2_best_cost_0(0));
    slice2winner3_best_cost_0(1) <= smaller(slice2winner2_best_cost_0(3), slice2winner2_best_cost_0(2));
    for i in 0 to 1 loop
      slice2winner3_best_index_0(i) <= choice(slice2winner3_best_index_0_is_not_less(i), slice2winner2_best_index_0(2 *
        i + 1), slice2winner2_best_index_0(2 * i));
      slice2winner3_best_below_0(i) <= choice(slice2winner3_best_index_0_is_not_less(i),
        slice2winner3_best_below_0_choice(i), slice2winner2_best_below_0(2 * i));
      slice2winner3_best_above_0(i) <= choice(slice2winner3_best_index_0_is_not_less(i), slice2winner2_best_above_0(2 *
        i + 1), slice2winner3_best_above_0_choice(i));
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
    slice2winner4_best_index_0_0_is_less := (slice2winner3_best_cost_0(0) - slice2winner3_best_cost_0(1)) < 0;
    slice2winner4_best_below_0_0_is_equal := slice2winner3_best_index_0(1) = 8;
    slice2winner4_best_below_0_0_choice := choice(slice2winner4_best_below_0_0_is_equal, slice2winner3_best_last_0(0),
      slice2winner3_best_below_0(1));
    slice2winner4_best_above_0_0_is_equal := slice2winner3_best_index_0(0) = 7;
    slice2winner4_best_above_0_0_choice := choice(slice2winner4_best_above_0_0_is_equal, slice2winner3_best_first_0(1),
      slice2winner3_best_above_0(0));
    slice2winner4_best_place_0_0_is_not_less := (slice2winner3_best_cost_0(0) - slice2winner3_best_cost_0(1)) >= 0;
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
    slice2winner4_best_place_0_0 <= slice2winner4_best_place_0_0_is_not_less;
    slice2winner4_best_at_start_0_0 <= slice2winner4_best_below_0_0_is_equal and
      slice2winner4_best_place_0_0_is_not_less;
    slice2winner4_best_at_end_0_0 <= slice2winner4_best_index_0_0_is_less and slice2winner4_best_above_0_0_is_equal;
    slice2winner4_best_late_cost_0_0 <= slice2winner4_best_cost_0_0;
    slice2winner4_best_cost_0_0 <= smaller(slice2winner3_best_cost_0(1), slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0_0 <= choice(slice2winner4_best_index_0_0_is_less, slice2winner3_best_index_0(0),
      slice2winner3_best_index_0(1));
    slice2winner4_best_below_0_0 <= choice(slice2winner4_best_index_0_0_is_less, slice2winner3_best_below_0(0),
      slice2winner4_best_below_0_0_choice);
    slice2winner4_best_above_0_0 <= choice(slice2winner4_best_index_0_0_is_less, slice2winner4_best_above_0_0_choice,
      slice2winner3_best_above_0(1));
    slice2winner4_best_second_0_0 <= smaller(slice2winner4_best_second_0_0_choices(2),
      slice2winner4_best_second_0_0_choices(4));
    slice2winner4_best_but_first_0_0 <= smaller(slice2winner3_best_late_cost_0(1), slice2winner3_best_but_first_0(0));
    slice2winner4_best_but_last_0_0 <= smaller(slice2winner3_best_but_last_0(1), slice2winner3_best_late_cost_0(0));
    -- slice2
    slice2_best_index_0_0_is_less := (slice1_best_cost_0_0 - slice2winner4_best_cost_0_0) < 0;
    slice2_best_below_0_0_is_equal := slice2winner4_best_index_0_0 = 0;
    slice2_best_below_0_0_choice := choice(slice2_best_below_0_0_is_equal, slice1_best_last_0_0,
      slice2winner4_best_below_0_0);
    slice2_best_above_0_0_is_equal := slice1_best_index_0_0 = 31;
    slice2_best_above_0_0_choice := choice(slice2_best_above_0_0_is_equal, slice2winner4_best_first_0_0,
      slice1_best_above_0_0);
    slice2_best_place_0_0_is_not_less := (slice1_best_cost_0_0 - slice2winner4_best_cost_0_0) >= 0;
    slice2_best_second_0_0_choices(1) := choice(slice2_best_place_0_0, slice2winner4_best_second_0_0,
      slice2winner4_best_late_cost_0_0);
    slice2_best_second_0_0_choices(2) := choice(slice2_best_at_end_0_0, slice2winner4_best_but_first_0_0,
      slice2_best_second_0_0_choices(1));
    slice2_best_second_0_0_choices(3) := choice(slice2_best_place_0_0, slice1_best_late_cost_0_0,
      slice1_best_second_0_0);
    slice2_best_second_0_0_choices(4) := choice(slice2_best_at_start_0_0, slice1_best_but_last_0_0,
      slice2_best_second_0_0_choices(3));
    slice2_best_last_0_0 <= slice2winner4_best_last_0_0;
    slice2_best_place_0_0 <= slice2_best_place_0_0_is_not_less;
    slice2_best_at_start_0_0 <= slice2_best_below_0_0_is_equal and slice2_best_place_0_0_is_not_less;
    slice2_best_at_end_0_0 <= slice2_best_index_0_0_is_less and slice2_best_above_0_0_is_equal;
    slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= smaller(slice2winner4_best_cost_0_0, slice1_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_index_0_0_is_less, slice1_best_index_0_0, slice2winner4_best_index_0_0
      + 32);
    slice2_best_below_0_0 <= choice(slice2_best_index_0_0_is_less, slice1_best_below_0_0, slice2_best_below_0_0_choice);
    slice2_best_above_0_0 <= choice(slice2_best_index_0_0_is_less, slice2_best_above_0_0_choice,
      slice2winner4_best_above_0_0);
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
    for i in 0 to 4 loop
      slice3cost_column_0_choice(3 * i, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words(i)
        mod 1024);
      slice3cost_column_0_choice(3 * i, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(3 *
        i) + slice3cost_column_0_choice(3 * i, 1)) mod 1024);
      slice3cost_column_0_choice(3 * i + 1, 1) := choice(slice0window_change_tag.first_group, 0,
        (slice3cost_ready_words(i) / 1024) mod 1024);
      slice3cost_column_0_choice(3 * i + 1, 2) := choice(slice0window_change_tag.border_column, 0,
        (slice3cost_change_0(3 * i + 1) + slice3cost_column_0_choice(3 * i + 1, 1)) mod 1024);
      slice3cost_column_0_choice(3 * i + 2, 1) := choice(slice0window_change_tag.first_group, 0,
        slice3cost_ready_words(i) / 1048576);
      slice3cost_column_0_choice(3 * i + 2, 2) := choice(slice0window_change_tag.border_column, 0,
        (slice3cost_change_0(3 * i + 2) + slice3cost_column_0_choice(3 * i + 2, 1)) mod 1024);
    end loop;
    slice3cost_column_0_choice(15, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words_5);
    slice3cost_column_0_choice(15, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(15) +
      slice3cost_column_0_choice(15, 1)) mod 1024);
    for i in 0 to 15 loop
      slice3cost_pixels_first(0, i) <= slice3shift_search(0, i) - slice3shift_reference(0);
    end loop;
    for i in 0 to 15 loop
      slice3cost_pixels_first(1, i) <= slice3shift_search(1, i) - slice3shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 15 loop
        slice3cost_pixels_cost(i, j) <= folded(slice3cost_pixels_first(i, j)) + as_number((slice3cost_pixels_first(i,
          j) < 0));
      end loop;
    end loop;
    slice3cost_read_column <= slice2cost_read_column;
    slice3cost_change_column <= slice3cost_read_column;
    for i in 0 to 15 loop
      slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 4 loop slice3cost_ready_words(i) <= to_integer(slice3cost_read_words(i)); end loop;
    slice3cost_ready_words_5 <= to_integer(slice3cost_read_words_5);
    for i in 0 to 15 loop slice3cost_column_0(i) <= slice3cost_column_0_choice(i, 2); end loop;
    if slice0window_entering_tag.valid then slice3cost_ready_column <= slice3cost_change_column; end if;
    if slice0window_change_tag.valid then
      slice3cost_write_column <= slice2cost_write_column;
      for i in 0 to 4 loop
        slice3cost_write_words(i) <= (slice3cost_column_0_choice(3 * i + 1, 2) * 1024) + slice3cost_column_0_choice(3 *
          i, 2) + (slice3cost_column_0_choice(3 * i + 2, 2) * 1048576);
      end loop;
      slice3cost_write_words(5) <= slice3cost_column_0_choice(15, 2);
    end if;
    -- slice3window
    if slice0window_tag_valid then
      slice3window_ring_write_address <= slice3window_ring_read_address;
      slice3window_ring_read_address <= choice(slice3window_ring_read_address = 15, 0, (slice3window_ring_read_address
        + 1) mod 16);
    end if;
    for i in 0 to 4 loop
      for j in 0 to 2 loop
        slice3window_change_0_choice(3 * i + j) := choice(slice2window_change_tag.leaves_window,
          to_integer(slice3window_leaving(i)(10 * j + 9 downto 10 * j)), 0);
      end loop;
    end loop;
    slice3window_change_0_choice(15) := choice(slice2window_change_tag.leaves_window,
      to_integer(slice3window_leaving_5), 0);
    slice3window_entering_0 <= slice3cost_column_0;
    for i in 0 to 15 loop
      slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
    end loop;
    slice3window_change_tag_first_cost <= slice2window_change_tag.first_cost;
    for i in 0 to 15 loop
      slice3window_sum_0_choice(i) := choice(slice3window_change_tag_first_cost, 0, slice3window_sum_0(i));
    end loop;
    if slice0winner2_tag.valid then
      for i in 0 to 15 loop
        slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 16384;
      end loop;
      slice3window_centre_output_column(0) <= slice2window_centre_output_column_0;
      slice3window_centre_output_column(1 to 5) <= slice3window_centre_output_column(0 to 4);
      slice3window_centre_start_of_frame_1 <= slice2window_centre_start_of_frame_1;
      slice3window_centre_start_of_frame_5 <= slice1window_centre_start_of_frame(5);
      slice3window_centre_end_of_line(0) <= slice2window_centre_end_of_line_0;
      slice3window_centre_end_of_line(1 to 5) <= slice3window_centre_end_of_line(0 to 4);
    end if;
    -- slice3winner1
    slice3winner1_best_index_0_0_is_not_less := (slice3window_sum_0(0) - slice3window_sum_0(1)) >= 0;
    for i in 1 to 7 loop
      slice3winner1_best_index_0_is_less(i) := (slice3window_sum_0(2 * i) - slice3window_sum_0(2 * i + 1)) < 0;
    end loop;
    slice3winner1_held_0 <= slice3window_sum_0;
    slice3winner1_best_index_0_0 <= slice3winner1_best_index_0_0_is_not_less;
    slice3winner1_best_late_cost_0 <= slice3winner1_best_cost_0;
    for i in 0 to 7 loop slice3winner1_best_but_first_0(i) <= slice3winner1_held_0(2 * i + 1); end loop;
    for i in 0 to 6 loop slice3winner1_best_but_last_0(i) <= slice3winner1_held_0(2 * i); end loop;
    for i in 0 to 7 loop
      slice3winner1_best_cost_0(i) <= smaller(slice3window_sum_0(2 * i + 1), slice3window_sum_0(2 * i));
    end loop;
    for i in 1 to 7 loop
      slice3winner1_best_index_0(i) <= choice(slice3winner1_best_index_0_is_less(i), 2 * i, 2 * i + 1);
      slice3winner1_best_below_0(i) <= choice(slice3winner1_best_index_0_is_less(i), 0, slice3window_sum_0(2 * i));
      slice3winner1_best_above_0(i) <= choice(slice3winner1_best_index_0_is_less(i), slice3window_sum_0(2 * i + 1), 0);
    end loop;
    slice3winner1_best_below_0(0) <= choice(slice3winner1_best_index_0_0_is_not_less, slice3window_sum_0(0), 0);
    slice3winner1_best_above_0(0) <= choice(slice3winner1_best_index_0_0_is_not_less, 0, slice3window_sum_0(1));
    -- slice3winner2
    for i in 0 to 3 loop
      slice3winner2_best_index_0_is_not_less(i) := (slice3winner1_best_cost_0(2 * i) - slice3winner1_best_cost_0(2 * i
        + 1)) >= 0;
    end loop;
    for i in 0 to 3 loop
      slice3winner2_best_below_0_choice(i) := choice(other(i), slice3winner1_held_0(4 * i + 1),
        slice3winner1_best_below_0(2 * i + 1));
    end loop;
    slice3winner2_best_above_0_choice(0) := choice(slice3winner1_best_index_0_0, slice3winner1_held_0(2),
      slice3winner1_best_above_0(0));
    slice3winner2_best_above_0_choice(1) := choice(is_set(slice3winner1_best_index_0(2), 2) and
      is_set(slice3winner1_best_index_0(2), 0), slice3winner1_held_0(6), slice3winner1_best_above_0(2));
    slice3winner2_best_above_0_choice(2) := choice(is_set(slice3winner1_best_index_0(4), 3) and
      is_set(slice3winner1_best_index_0(4), 0), slice3winner1_held_0(10), slice3winner1_best_above_0(4));
    slice3winner2_best_above_0_3_value := is_set(slice3winner1_best_index_0(6), 2);
    slice3winner2_best_above_0_choice(3) := choice(is_set(slice3winner1_best_index_0(6), 3) and
      slice3winner2_best_above_0_3_value and is_set(slice3winner1_best_index_0(6), 0), slice3winner1_held_0(14),
      slice3winner1_best_above_0(6));
    for i in 0 to 3 loop
      slice3winner2_best_second_0_choice(i, 1) := choice(slice3winner2_best_place_0(i), 16383,
        slice3winner1_best_late_cost_0(2 * i + 1));
      slice3winner2_best_second_0_choice(i, 2) := choice(slice3winner2_best_at_end_0(i),
        slice3winner1_best_but_first_0(2 * i + 1), slice3winner2_best_second_0_choice(i, 1));
      slice3winner2_best_second_0_choice(i, 3) := choice(slice3winner2_best_place_0(i),
        slice3winner1_best_late_cost_0(2 * i), 16383);
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
    slice3winner2_best_place_0 <= slice3winner2_best_index_0_is_not_less;
    slice3winner2_best_at_start_0(0) <= other(0) and slice3winner2_best_index_0_is_not_less(0);
    slice3winner2_best_at_start_0(1) <= other(1) and slice3winner2_best_index_0_is_not_less(1);
    slice3winner2_best_at_start_0(2) <= other(2) and slice3winner2_best_index_0_is_not_less(2);
    slice3winner2_best_at_start_0(3) <= other(3) and slice3winner2_best_index_0_is_not_less(3);
    slice3winner2_best_at_end_0(0) <= slice3winner1_best_index_0_0 and ((slice3winner1_best_cost_0(0) -
      slice3winner1_best_cost_0(1)) < 0);
    slice3winner2_best_at_end_0(1) <= ((slice3winner1_best_cost_0(2) - slice3winner1_best_cost_0(3)) < 0) and
      is_set(slice3winner1_best_index_0(2), 2) and is_set(slice3winner1_best_index_0(2), 0);
    slice3winner2_best_at_end_0(2) <= ((slice3winner1_best_cost_0(4) - slice3winner1_best_cost_0(5)) < 0) and
      is_set(slice3winner1_best_index_0(4), 3) and is_set(slice3winner1_best_index_0(4), 0);
    slice3winner2_best_at_end_0(3) <= ((slice3winner1_best_cost_0(6) - slice3winner1_best_cost_0(7)) < 0) and
      is_set(slice3winner1_best_index_0(6), 3) and slice3winner2_best_above_0_3_value and
      is_set(slice3winner1_best_index_0(6), 0);
    slice3winner2_best_late_cost_0 <= slice3winner2_best_cost_0;
    for i in 0 to 3 loop
      slice3winner2_best_cost_0(i) <= smaller(slice3winner1_best_cost_0(2 * i + 1), slice3winner1_best_cost_0(2 * i));
    end loop;
    slice3winner2_best_index_0(0) <= choice(slice3winner2_best_index_0_is_not_less(0), slice3winner1_best_index_0(1),
      as_number(slice3winner1_best_index_0_0));
    for i in 0 to 2 loop
      slice3winner2_best_below_0(i) <= choice(slice3winner2_best_index_0_is_not_less(i),
        slice3winner2_best_below_0_choice(i), slice3winner1_best_below_0(2 * i));
      slice3winner2_best_above_0(i) <= choice(slice3winner2_best_index_0_is_not_less(i), slice3winner1_best_above_0(2 *
        i + 1), slice3winner2_best_above_0_choice(i));
      slice3winner2_best_index_0(i + 1) <= choice(slice3winner2_best_index_0_is_not_less(i + 1),
        slice3winner1_best_index_0(2 * i + 3), slice3winner1_best_index_0(2 * i + 2));
    end loop;
    slice3winner2_best_below_0(3) <= choice(slice3winner2_best_index_0_is_not_less(3),
      slice3winner2_best_below_0_choice(3), slice3winner1_best_below_0(6));
    slice3winner2_best_above_0(3) <= choice(slice3winner2_best_index_0_is_not_less(3), slice3winner1_best_above_0(7),
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
    slice3winner3_best_index_0_is_not_less(0) := (slice3winner2_best_cost_0(0) - slice3winner2_best_cost_0(1)) >= 0;
    slice3winner3_best_index_0_is_not_less(1) := (slice3winner2_best_cost_0(2) - slice3winner2_best_cost_0(3)) >= 0;
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
    slice3winner3_best_place_0 <= slice3winner3_best_index_0_is_not_less;
    slice3winner3_best_at_start_0(0) <= slice3winner3_best_index_0_is_not_less(0) and
      slice3winner3_best_below_0_is_equal(0);
    slice3winner3_best_at_start_0(1) <= slice3winner3_best_below_0_is_equal(1) and
      slice3winner3_best_index_0_is_not_less(1);
    slice3winner3_best_at_end_0(0) <= ((slice3winner2_best_cost_0(0) - slice3winner2_best_cost_0(1)) < 0) and
      slice3winner3_best_above_0_is_equal(0);
    slice3winner3_best_at_end_0(1) <= ((slice3winner2_best_cost_0(2) - slice3winner2_best_cost_0(3)) < 0) and
      is_set(slice3winner2_best_index_0(2), 3) and slice3winner3_best_above_0_is_equal(1);
    slice3winner3_best_late_cost_0 <= slice3winner3_best_cost_0;
    slice3winner3_best_cost_0(0) <= smaller(slice3winner2_best_cost_0(1), slice3winner2_best_cost_0(0));
    slice3winner3_best_cost_0(1) <= smaller(slice3winner2_best_cost_0(3), slice3winner2_best_cost_0(2));
    for i in 0 to 1 loop
      slice3winner3_best_index_0(i) <= choice(slice3winner3_best_index_0_is_not_less(i), slice3winner2_best_index_0(2 *
        i + 1), slice3winner2_best_index_0(2 * i));
      slice3winner3_best_below_0(i) <= choice(slice3winner3_best_index_0_is_not_less(i),
        slice3winner3_best_below_0_choice(i), slice3winner2_best_below_0(2 * i));
      slice3winner3_best_above_0(i) <= choice(slice3winner3_best_index_0_is_not_less(i), slice3winner2_best_above_0(2 *
        i + 1), slice3winner3_best_above_0_choice(i));
    end loop;
    slice3winner3_best_second_0(0) <= smaller(slice3winner3_best_second_0_choice(0, 2),
      slice3winner3_best_second_0_choice(0, 4));
    slice3winner3_best_second_0(1) <= smaller(slice3winner3_best_second_0_choice(1, 2),
      slice3winner3_best_second_0_choice(1, 4));
    slice3winner3_best_but_first_0(0) <= smaller(slice3winner2_best_late_cost_0(1), slice3winner2_best_but_first_0(0));
    slice3winner3_best_but_first_0(1) <= smaller(slice3winner2_best_late_cost_0(3), slice3winner2_best_but_first_0(2));
    slice3winner3_best_but_last_0_0 <= smaller(slice3winner2_best_but_last_0(1), slice3winner2_best_late_cost_0(0));
    -- slice3winner4
    slice3winner4_best_index_0_0_is_less := (slice3winner3_best_cost_0(0) - slice3winner3_best_cost_0(1)) < 0;
    slice3winner4_best_below_0_0_is_equal := slice3winner3_best_index_0(1) = 8;
    slice3winner4_best_below_0_0_choice := choice(slice3winner4_best_below_0_0_is_equal, slice3winner3_best_last_0_0,
      slice3winner3_best_below_0(1));
    slice3winner4_best_above_0_0_is_equal := slice3winner3_best_index_0(0) = 7;
    slice3winner4_best_above_0_0_choice := choice(slice3winner4_best_above_0_0_is_equal, slice3winner3_best_first_0(1),
      slice3winner3_best_above_0(0));
    slice3winner4_best_place_0_0_is_not_less := (slice3winner3_best_cost_0(0) - slice3winner3_best_cost_0(1)) >= 0;
    slice3winner4_best_second_0_0_choices(1) := choice(slice3winner4_best_place_0_0, slice3winner3_best_second_0(1),
      slice3winner3_best_late_cost_0(1));
    slice3winner4_best_second_0_0_choices(2) := choice(slice3winner4_best_at_end_0_0,
      slice3winner3_best_but_first_0(1), slice3winner4_best_second_0_0_choices(1));
    slice3winner4_best_second_0_0_choices(3) := choice(slice3winner4_best_place_0_0, slice3winner3_best_late_cost_0(0),
      slice3winner3_best_second_0(0));
    slice3winner4_best_second_0_0_choices(4) := choice(slice3winner4_best_at_start_0_0,
      slice3winner3_best_but_last_0_0, slice3winner4_best_second_0_0_choices(3));
    slice3winner4_best_first_0_0 <= slice3winner3_best_first_0(0);
    slice3winner4_best_place_0_0 <= slice3winner4_best_place_0_0_is_not_less;
    slice3winner4_best_at_start_0_0 <= slice3winner4_best_below_0_0_is_equal and
      slice3winner4_best_place_0_0_is_not_less;
    slice3winner4_best_at_end_0_0 <= slice3winner4_best_index_0_0_is_less and slice3winner4_best_above_0_0_is_equal;
    slice3winner4_best_late_cost_0_0 <= slice3winner4_best_cost_0_0;
    slice3winner4_best_cost_0_0 <= smaller(slice3winner3_best_cost_0(1), slice3winner3_best_cost_0(0));
    slice3winner4_best_index_0_0 <= choice(slice3winner4_best_index_0_0_is_less, slice3winner3_best_index_0(0),
      slice3winner3_best_index_0(1));
    slice3winner4_best_below_0_0 <= choice(slice3winner4_best_index_0_0_is_less, slice3winner3_best_below_0(0),
      slice3winner4_best_below_0_0_choice);
    slice3winner4_best_above_0_0 <= choice(slice3winner4_best_index_0_0_is_less, slice3winner4_best_above_0_0_choice,
      slice3winner3_best_above_0(1));
    slice3winner4_best_second_0_0 <= smaller(slice3winner4_best_second_0_0_choices(2),
      slice3winner4_best_second_0_0_choices(4));
    slice3winner4_best_but_first_0_0 <= smaller(slice3winner3_best_late_cost_0(1), slice3winner3_best_but_first_0(0));
    -- slice3
    slice3_best_index_0_0_is_less := (slice2_best_cost_0_0 - slice3winner4_best_cost_0_0) < 0;
    slice3_best_below_0_0_is_equal := slice3winner4_best_index_0_0 = 0;
    slice3_best_below_0_0_choice := choice(slice3_best_below_0_0_is_equal, slice2_best_last_0_0,
      slice3winner4_best_below_0_0);
    slice3_best_above_0_0_is_equal := slice2_best_index_0_0 = 47;
    slice3_best_above_0_0_choice := choice(slice3_best_above_0_0_is_equal, slice3winner4_best_first_0_0,
      slice2_best_above_0_0);
    slice3_best_place_0_0_is_not_less := (slice2_best_cost_0_0 - slice3winner4_best_cost_0_0) >= 0;
    slice3_best_second_0_0_choices(1) := choice(slice3_best_place_0_0, slice3winner4_best_second_0_0,
      slice3winner4_best_late_cost_0_0);
    slice3_best_second_0_0_choices(2) := choice(slice3_best_at_end_0_0, slice3winner4_best_but_first_0_0,
      slice3_best_second_0_0_choices(1));
    slice3_best_second_0_0_choices(3) := choice(slice3_best_place_0_0, slice2_best_late_cost_0_0,
      slice2_best_second_0_0);
    slice3_best_second_0_0_choices(4) := choice(slice3_best_at_start_0_0, slice2_best_but_last_0_0,
      slice3_best_second_0_0_choices(3));
    slice3_best_place_0_0 <= slice3_best_place_0_0_is_not_less;
    slice3_best_at_start_0_0 <= slice3_best_below_0_0_is_equal and slice3_best_place_0_0_is_not_less;
    slice3_best_at_end_0_0 <= slice3_best_index_0_0_is_less and slice3_best_above_0_0_is_equal;
    slice3_best_late_cost_0_0 <= slice3_best_cost_0_0;
    slice3_best_tag <= slice2_best_tag;
    slice3_best_cost_0_0 <= smaller(slice3winner4_best_cost_0_0, slice2_best_cost_0_0);
    slice3_best_index_0_0 <= choice(slice3_best_index_0_0_is_less, slice2_best_index_0_0, slice3winner4_best_index_0_0
      + 48);
    slice3_best_below_0_0 <= choice(slice3_best_index_0_0_is_less, slice2_best_below_0_0, slice3_best_below_0_0_choice);
    slice3_best_above_0_0 <= choice(slice3_best_index_0_0_is_less, slice3_best_above_0_0_choice,
      slice3winner4_best_above_0_0);
    slice3_best_second_0_0 <= smaller(slice3_best_second_0_0_choices(2), slice3_best_second_0_0_choices(4));
    -- texture
    texture_passes_0(0) <= 9 < texturewindow_sum_0_0;
    texture_passes_0(1 to 7) <= texture_passes_0(0 to 6);
    texture_taps_search_0(0) <= choice(rows_inside(0), 31, 0);
    texture_taps_search_0(1) <= choice(rows_inside(1), 31, 0);
    -- texturecost
    texturecost_column_0_0_choices(1) := choice(slice0cost_ready_tag.first_group, 0, texturecost_ready_words_0);
    texturecost_column_0_0_choices(2) := choice(slice0cost_ready_tag.border_column, 0,
      (texturecost_column_0_0_choices(1) + texturecost_change_0_0) mod 1024);
    texturecost_pixels_first_0(0) <= texture_taps_search_0(0) - slice0shift_reference(0);
    texturecost_pixels_first_0(1) <= texture_taps_search_0(1) - slice0shift_reference(1);
    texturecost_pixels_cost_0(0) <= folded(texturecost_pixels_first_0(0)) + as_number((texturecost_pixels_first_0(0) <
      0));
    texturecost_pixels_cost_0(1) <= folded(texturecost_pixels_first_0(1)) + as_number((texturecost_pixels_first_0(1) <
      0));
    texturecost_change_0_0 <= texturecost_pixels_cost_0(1) - texturecost_pixels_cost_0(0);
    texturecost_ready_words_0 <= to_integer(texturecost_read_words_0);
    texturecost_column_0_0 <= texturecost_column_0_0_choices(2);
    if slice0cost_ready_tag.valid then texturecost_write_words_0 <= texturecost_column_0_0_choices(2); end if;
    -- texturewindow
    texturewindow_change_0_0_choice := choice(slice0window_entering_tag.leaves_window,
      to_integer(texturewindow_leaving_0), 0);
    texturewindow_entering_0_0 <= texturecost_column_0_0;
    texturewindow_change_0_0 <= texturewindow_entering_0_0 - texturewindow_change_0_0_choice;
    texturewindow_sum_0_0_choice := choice(slice0window_change_tag.first_cost, 0, texturewindow_sum_0_0);
    if slice0window_change_tag.valid then
      texturewindow_sum_0_0 <= (texturewindow_sum_0_0_choice + texturewindow_change_0_0) mod 16384;
    end if;
    -- refinement
    refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 32768) - refinement_divisor_0(0);
    for i in 2 to 7 loop
      refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 32768) - refinement_divisor_0(i -
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
    refinement_passed_0(0) <= texture_passes_0(7);
    refinement_passed_0(1 to 2) <= refinement_passed_0(0 to 1);
    refinement_passed_0(4 to 11) <= refinement_passed_0(3 to 10);
    refinement_tag_valid(0) <= slice3_best_tag.valid;
    refinement_tag_output_column(0) <= slice3_best_tag.output_column;
    refinement_tag_start_of_frame(0) <= slice3_best_tag.start_of_frame;
    refinement_tag_end_of_line(0) <= slice3_best_tag.end_of_line;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
      refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
      refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
    end loop;
    refinement_alone_0(0) <= slice3_best_second_0_0 = 16383;
    refinement_alone_0(1) <= refinement_alone_0(0);
    refinement_gap_0 <= (slice3_best_second_0_0 - slice3_best_late_cost_0_0) mod 16384;
    refinement_lowest_0 <= slice3_best_late_cost_0_0;
    refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
    refinement_scaled_cost_0 <= ((refinement_lowest_0 + (refinement_lowest_0 / 2)) * 2) + (refinement_lowest_0 mod 2);
    refinement_u_0 <= (refinement_below_0 - slice3_best_late_cost_0_0) mod 16384;
    refinement_v_0 <= (refinement_above_0 - slice3_best_late_cost_0_0) mod 16384;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 14)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 14))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((32768 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 16384) +
      ((others_from_6(6) / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_passed_0(3) <= choice(refinement_alone_0(1), refinement_passed_0(2), refinement_passed_0(2) and
      ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0));
    refinement_below_0 <= choice(slice3_best_index_0_0 = 0, slice3_best_above_0_0, slice3_best_below_0_0);
    refinement_above_0 <= choice(slice3_best_index_0_0 = 63, slice3_best_below_0_0, slice3_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 15),
      refinement_remainder_1_0_difference mod 16384, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 15),
        refinement_remainder_0_difference(i) mod 16384, (refinement_remainder_0(i - 1) mod 8192) * 2);
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
    other(0) <= slice3winner1_best_index_0_is_less(1);
    other(1) <= slice3winner1_best_index_0_is_less(3);
    other(2) <= slice3winner1_best_index_0_is_less(5);
    other(3) <= slice3winner1_best_index_0_is_less(7);
    other(4) <= slice2winner1_best_index_0_is_less(1);
    other(5) <= slice2winner1_best_index_0_is_less(3);
    others_from_6(6) <= ((refinement_remainder_0_difference(7) / 32768) * 2) + ((others_from_6(7) / 4) * 4);
    others_from_6(7) <= ((refinement_remainder_0_difference(6) / 32768) * 4) + ((others_from_6(8) / 8) * 8);
    others_from_6(8) <= ((refinement_remainder_0_difference(5) / 32768) * 8) + ((others_from_6(9) / 16) * 16);
    others_from_6(9) <= ((refinement_remainder_0_difference(4) / 32768) * 16) + ((others_from_6(10) / 32) * 32);
    others_from_6(10) <= ((refinement_remainder_0_difference(3) / 32768) * 32) + ((others_from_6(11) / 64) * 64);
    others_from_6(11) <= ((refinement_remainder_0_difference(2) / 32768) * 64) + ((others_from_6(12) / 128) * 128);
    others_from_6(12) <= (refinement_remainder_1_0_difference / 32768) * 128;
    others_from_13(13) <= slice2winner1_best_index_0_is_less(5);
    others_from_13(14) <= slice2winner1_best_index_0_is_less(7);
    others_from_13(15) <= slice1winner1_best_index_0_is_less(1);
    others_from_13(16) <= slice1winner1_best_index_0_is_less(3);
    others_from_13(17) <= slice1winner1_best_index_0_is_less(5);
    others_from_13(18) <= slice1winner1_best_index_0_is_less(7);
    others_from_13(19) <= slice0winner1_best_index_0_is_less(1);
    others_from_13(20) <= slice0winner1_best_index_0_is_less(3);
    others_from_13(21) <= slice0winner1_best_index_0_is_less(5);
    others_from_13(22) <= slice0winner1_best_index_0_is_less(7);
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 376;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false;
      for i in 0 to 2 loop
        transform_filtering_start_of_frame(i) <= false; transform_filtering_valid(i) <= false;
      end loop;
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 382; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.row_start <= false; delay_tag.output_column <= false;
      delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false; rows_read_column <= 0;
      rows_read_tag.valid <= false; rows_read_tag.row_start <= false; rows_read_tag.output_column <= false;
      rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false; rows_ready_column <= 0;
      rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.row_start <= false; rows_tag.output_column <= false;
      rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.row_start <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.row_start <= false;
      slice0cost_pixels_first_tag.output_column <= false; slice0cost_pixels_first_tag.start_of_frame <= false;
      slice0cost_pixels_first_tag.end_of_line <= false; slice0cost_pixels_tag.valid <= false;
      slice0cost_pixels_tag.row_start <= false; slice0cost_pixels_tag.output_column <= false;
      slice0cost_pixels_tag.start_of_frame <= false; slice0cost_pixels_tag.end_of_line <= false;
      slice0cost_read_column <= 0; slice0cost_change_column <= 0; slice0cost_ready_column <= 0;
      slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.row_start <= false;
      slice0cost_ready_tag.output_column <= false; slice0cost_ready_tag.start_of_frame <= false;
      slice0cost_ready_tag.end_of_line <= false; slice0cost_write_column <= 0; slice0cost_tag.valid <= false;
      slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_tag.valid <= false; slice0window_entering_tag.output_column <= false;
      slice0window_entering_tag.start_of_frame <= false; slice0window_entering_tag.end_of_line <= false;
      slice0window_change_tag.valid <= false; slice0window_change_tag.output_column <= false;
      slice0window_change_tag.start_of_frame <= false; slice0window_change_tag.end_of_line <= false;
      slice0window_centre_output_column_0 <= false; slice0window_centre_start_of_frame <= (others => false);
      slice0window_centre_end_of_line_0 <= false; slice0window_tag_valid <= false; slice0winner1_tag_valid <= false;
      slice0winner2_tag <= (others => false); slice0winner3_tag <= (others => false);
      slice0winner4_tag <= (others => false); slice0_best_tag <= (others => false); slice1cost_read_column <= 0;
      slice1cost_change_column <= 0; slice1cost_ready_column <= 0; slice1cost_write_column <= 0;
      slice1window_ring_read_address <= 1; slice1window_ring_write_address <= 0;
      slice1window_centre_output_column_0 <= false; slice1window_centre_start_of_frame_1 <= false;
      slice1window_centre_start_of_frame <= (others => false); slice1window_centre_end_of_line_0 <= false;
      slice1_best_tag <= (others => false); slice2cost_read_column <= 0; slice2cost_change_column <= 0;
      slice2cost_ready_column <= 0; slice2cost_write_column <= 0; slice2window_ring_read_address <= 1;
      slice2window_ring_write_address <= 0; slice2window_centre_output_column_0 <= false;
      slice2window_centre_start_of_frame_1 <= false; slice2window_centre_end_of_line_0 <= false;
      slice2_best_tag <= (others => false); slice3cost_read_column <= 0; slice3cost_change_column <= 0;
      slice3cost_ready_column <= 0; slice3cost_write_column <= 0; slice3window_ring_read_address <= 1;
      slice3window_ring_write_address <= 0; slice3window_centre_output_column <= (others => false);
      slice3window_centre_start_of_frame_1 <= false; slice3window_centre_start_of_frame_5 <= false;
      slice3window_centre_end_of_line <= (others => false); slice3_best_tag <= (others => false);
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_output_column(i) <= false;
        refinement_tag_start_of_frame(i) <= false; refinement_tag_end_of_line(i) <= false;
      end loop;
      map_out_valid <= false; map_out_start_of_frame <= false; map_out_end_of_line <= false;
    end if;
  end process;
end architecture;
