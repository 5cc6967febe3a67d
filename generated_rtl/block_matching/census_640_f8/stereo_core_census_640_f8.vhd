-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration census_640_f8: 640x480, 64 disparities, window 9x9, 1 pixel pair a clock.
-- Options: window_px 9, reference left, cost census, census_width_px 9, census_height_px 3,
--   left_right_threshold 1, uniqueness_percent 5, subpixel true, median true, aggregation recursive,
--   slice_disparities 16, clocks_per_pixel 8.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config census_640_f8
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_census_640_f8 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 576;
    latency_clocks : positive := 28;
    flush_groups : positive := 5061;
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
  assert width_px = 640 report "stereo_core_census_640_f8: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_census_640_f8: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 64 report "stereo_core_census_640_f8: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_census_640_f8: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_census_640_f8: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 576 report "stereo_core_census_640_f8: output_width_px is " & integer'image(output_width_px) & " but this core has 576" severity failure;
  assert latency_clocks = 28 report "stereo_core_census_640_f8: latency_clocks is " & integer'image(latency_clocks) & " but this core has 28" severity failure;
  assert flush_groups = 5061 report "stereo_core_census_640_f8: flush_groups is " & integer'image(flush_groups) & " but this core has 5061" severity failure;
  assert gap_groups = 2560 report "stereo_core_census_640_f8: gap_groups is " & integer'image(gap_groups) & " but this core has 2560" severity failure;
end entity;

architecture rtl of stereo_core_census_640_f8 is
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
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_16777215_1d is array (natural range <>) of natural range 0 to 16777215;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_26_2d is array (natural range <>, natural range <>) of natural range 0 to 26;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_3_1d is array (natural range <>) of natural range 0 to 3;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_4095_2d is array (natural range <>, natural range <>) of natural range 0 to 4095;
  type natural_4097_to_16382_1d is array (natural range <>) of natural range 4097 to 16382;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_67108863_1d is array (natural range <>) of natural range 0 to 67108863;
  type natural_67108863_2d is array (natural range <>, natural range <>) of natural range 0 to 67108863;
  type natural_7_1d is array (natural range <>) of natural range 0 to 7;
  type unsigned_16_1d is array (natural range <>) of unsigned(15 downto 0);
  type unsigned_26_1d is array (natural range <>) of unsigned(25 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type tag_5 is record
    valid, first_group, output_column, first_column, start_of_frame : boolean;
  end record;
  type tag_10 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column, output_column : boolean;
    first_column, end_of_line : boolean;
  end record;
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, map_column, output_column : boolean;
    first_column : boolean;
  end record;
  type tag_8 is record
    valid, first_group, border_column, first_cost, leaves_window, map_column, output_column, first_column : boolean;
  end record;
  type tag_6 is record
    valid, first_cost, leaves_window, map_column, output_column, first_column : boolean;
  end record;
  type tag_5_b is record
    valid, first_cost, map_column, output_column, first_column : boolean;
  end record;
  type tag_4 is record
    valid, map_column, output_column, first_column : boolean;
  end record;
  type tag_3 is record
    valid, map_column, first_column : boolean;
  end record;
  type tag_4_b is record
    valid, map_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_5_c is record
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
  signal delay_tag : tag_5;
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
  signal rows_read_tag : tag_5;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_5;
  -- passes
  signal passes_row, passes_coming_first_group, passes_coming_output, passes_coming_starts, passes_row_ended,
    passes_arrived, passes_shows, passes_showing_first_group, passes_showing_output, passes_showing_starts,
    passes_pass_ends, passes_last_pass, passes_leaving_starts : boolean;
  signal passes_read_tag : tag_10;
  signal passes_tag : tag_9;
  signal passes_write_address, passes_search_address, passes_reference_address : natural range 0 to 2047;
  signal passes_write_search, passes_write_reference, passes_search, passes_reference : natural_67108863_1d(0 to 1);
  signal passes_pass : natural range 0 to 7;
  signal passes_column : natural range 0 to 1023;
  signal passes_search_start : natural range 0 to 1016;
  signal passes_read_search, passes_read_reference : unsigned_26_1d(0 to 1);
  -- slice0shift
  signal slice0shift_search : natural_67108863_2d(0 to 1, 0 to 7);
  signal slice0shift_reference : natural_67108863_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 7, 0 to 7);  -- _#_#_count_#
  signal slice0cost_pixels_first_count_8 : natural_2_2d(0 to 1, 0 to 7);  -- _#_#_count_8
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag : tag_8;
  signal slice0cost_tag : tag_6;
  signal slice0cost_pixels_cost : natural_26_2d(0 to 1, 0 to 7);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 8191;
  signal slice0cost_read_words : unsigned_16_1d(0 to 3);
  signal slice0cost_change_0 : integer_minus_26_to_26_1d(0 to 7);
  signal slice0cost_ready_words, slice0cost_write_words : natural_65535_1d(0 to 3);
  signal slice0cost_column_0 : natural_255_1d(0 to 7);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving : unsigned_32_1d(0 to 1);
  signal slice0window_entering_0 : natural_255_1d(0 to 7);
  signal slice0window_entering_tag : tag_6;
  signal slice0window_change_tag : tag_5_b;
  signal slice0window_centre_map_column, slice0window_centre_output_column,
    slice0window_centre_first_column : boolean_1d(0 to 3);
  signal slice0window_tag : tag_4;
  signal slice0window_change_0 : integer_minus_255_to_255_1d(0 to 7);
  signal slice0window_sum_0 : natural_4095_1d(0 to 7);
  -- slice0other
  signal slice0other_cost_0 : natural_4095_1d(0 to 7);
  signal slice0other_cost_out_0 : natural range 0 to 4095;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0 : natural_7_1d(2 to 7);  -- _# up to 2, 3 .. 7
  -- slice0winner1
  signal slice0winner1_held_0 : natural_4095_1d(0 to 7);
  signal slice0winner1_best_cost_0, slice0winner1_best_below_0, slice0winner1_best_above_0,
    slice0winner1_best_late_cost_0, slice0winner1_best_but_first_0,
    slice0winner1_best_but_last_0 : natural_4095_1d(0 to 3);
  signal slice0winner1_best_index_0_0, slice0winner1_best_place_0_2 : boolean;
  signal slice0winner1_tag : tag_3;
  signal slice0winner1_best_index_0 : natural_7_1d(1 to 3);  -- _# up to 3, 5, 7
  -- slice0winner2
  signal slice0winner2_best_cost_0, slice0winner2_best_below_0, slice0winner2_best_above_0, slice0winner2_best_first_0,
    slice0winner2_best_last_0, slice0winner2_best_late_cost_0, slice0winner2_best_second_0,
    slice0winner2_best_but_first_0, slice0winner2_best_but_last_0 : natural_4095_1d(0 to 1);
  signal slice0winner2_best_index_0 : natural_7_1d(0 to 1);  -- _# up to 3, 7
  signal slice0winner2_best_place_0, slice0winner2_best_at_start_0, slice0winner2_best_at_end_0 : boolean_1d(0 to 1);
  signal slice0winner2_tag : tag_3;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_below_0_0, slice0winner3_best_above_0_0,
    slice0winner3_best_first_0_0, slice0winner3_best_last_0_0, slice0winner3_best_late_cost_0_0,
    slice0winner3_best_second_0_0, slice0winner3_best_but_first_0_0,
    slice0winner3_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_place_0_0, slice0winner3_best_at_start_0_0, slice0winner3_best_at_end_0_0 : boolean;
  signal slice0winner3_tag : tag_3;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 7;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_first_0_0, slice0_best_last_0_0,
    slice0_best_late_cost_0_0, slice0_best_second_0_0, slice0_best_but_first_0_0,
    slice0_best_but_last_0_0 : natural range 0 to 4095;
  signal slice0_best_tag : tag_3;
  -- best
  signal best_read_index_0_0, best_waiting_index_0_0, best_ready_index_0_0, best_pass : natural range 0 to 7;
  signal best_read_below_0_0, best_read_above_0_0, best_read_first_0_0, best_read_last_0_0, best_read_late_cost_0_0,
    best_read_second_0_0, best_read_but_first_0_0, best_read_but_last_0_0, best_waiting_below_0_0,
    best_waiting_above_0_0, best_waiting_first_0_0, best_waiting_last_0_0, best_waiting_late_cost_0_0,
    best_waiting_second_0_0, best_waiting_but_first_0_0, best_waiting_but_last_0_0, best_ready_below_0_0,
    best_ready_above_0_0, best_ready_first_0_0, best_ready_last_0_0, best_ready_late_cost_0_0, best_ready_second_0_0,
    best_ready_but_first_0_0, best_ready_but_last_0_0, best_ready_words_2, best_compared_below_0_0,
    best_compared_above_0_0, best_compared_first_0_0, best_compared_last_0_0, best_compared_late_cost_0_0,
    best_compared_second_0_0, best_compared_but_first_0_0, best_compared_but_last_0_0 : natural range 0 to 4095;
  signal best_compared_words : natural_16777215_1d(1 to 2);  -- _# up to 16777215, 4095
  signal best_best_cost_0_0, best_best_below_0_0, best_best_above_0_0, best_best_last_0_0, best_best_late_cost_0_0,
    best_best_second_0_0, best_best_but_last_0_0, best_kept_cost : natural range 0 to 4095;
  signal best_read_tag, best_waiting_tag, best_ready_tag, best_compared_tag : tag_3;
  signal best_first_pass, best_last_pass, best_here_wins, best_here_is_first, best_before_is_last, best_best_place_0_0,
    best_best_at_start_0_0, best_best_at_end_0_0 : boolean;
  signal best_best_tag : tag_3;
  signal best_was_first : boolean;
  signal best_column, best_late_column, best_place_column, best_write_column,
    best_late_write_column : natural range 0 to 1023;
  signal best_read_words_0 : unsigned(19 downto 0);
  signal best_read_words_1, best_read_losers_0 : unsigned(23 downto 0);
  signal best_read_words_2 : unsigned(11 downto 0);
  signal best_ready_words_0 : natural range 0 to 1048575;
  signal best_ready_words_1, best_ready_losers_0, best_compared_losers_0 : natural range 0 to 16777215;
  signal best_base, best_compared_index_0_0, best_best_index_0_0 : natural range 0 to 255;
  signal best_last_before : natural range 7 to 255;
  -- refinement
  signal refinement_disparity_0 : natural_255_1d(0 to 11);  -- _#_0
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- _#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- _#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- _#_map_column
  signal refinement_tag_first_column : boolean_1d(0 to 11);  -- _#_first_column
  signal refinement_alone_0 : boolean_1d(0 to 1);  -- _#_0
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- _#_0
  signal refinement_gap_0, refinement_lowest_0, refinement_scaled_cost_0, refinement_below_0, refinement_above_0,
    refinement_u_0, refinement_v_0 : natural range 0 to 4095;
  signal refinement_remainder_0, refinement_divisor_0 : natural_4095_1d(0 to 7);  -- _#_0
  signal refinement_scaled_gap_0 : natural range 0 to 81900;
  signal refinement_difference_0 : integer range -4095 to 4095;
  -- winners
  signal winners_row : boolean;
  signal winners_read_tag : tag_4_b;
  signal winners_winners_passed_0 : boolean;
  signal winners_winners_tag : tag_4_b;
  signal winners_column : natural range 0 to 1023;
  signal winners_write_address, winners_read_address, winners_address_out : natural range 0 to 2047;
  signal winners_write_word_0 : natural range 0 to 4095;
  signal winners_read_word_0 : unsigned(11 downto 0);
  signal winners_winners_disparity_0 : natural range 0 to 63;
  signal winners_winners_fraction_0 : natural range 0 to 31;
  -- check
  signal check_read_winner, check_base, check_waiting_winner, check_ready_winner, check_winner : natural range 0 to 255;
  signal check_read_place, check_columns, check_waiting_place, check_ready_place,
    check_write_place : natural range 0 to 1023;
  signal check_read_counts, check_read_has_before, check_read_row, check_waiting_counts, check_waiting_has_before,
    check_waiting_row, check_ready_counts, check_ready_has_before, check_ready_row, check_asking_passed_0 : boolean;
  signal check_asking_tag : tag_4_b;
  signal check_answered_passed_0 : boolean;
  signal check_answered_tag : tag_4_b;
  signal check_checked_passed_0 : boolean;
  signal check_checked_tag : tag_5_c;
  signal check_pass : natural range 0 to 7;
  signal check_first : natural range 0 to 1016;
  signal check_waiting_cost, check_ready_cost, check_cost : natural range 0 to 4095;
  signal check_read_words_0 : unsigned(19 downto 0);
  signal check_ready_words_0 : natural range 0 to 1048575;
  signal check_write_address, check_address : natural range 0 to 2047;
  signal check_asking_disparity_0, check_answered_disparity_0, check_checked_disparity_0 : natural range 0 to 63;
  signal check_asking_fraction_0, check_answered_fraction_0, check_checked_fraction_0 : natural range 0 to 31;
  signal check_found_0 : unsigned(7 downto 0);
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
  signal other_3 : natural range 0 to 67108863;
  signal other_4 : unsigned(25 downto 0);
  signal other_5 : natural range 0 to 255;
  signal other_6 : natural range 0 to 254;
  signal other_7 : natural range 0 to 252;
  signal other_8 : natural range 0 to 248;
  signal other_9 : natural range 0 to 240;
  signal other_10 : natural range 0 to 224;
  signal other_11 : natural range 0 to 192;
  signal other_12 : natural range 0 to 128;
  signal other_13 : natural range 0 to 4095;

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

  other_4_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(map_counter_column, 10);
    write_address <= to_unsigned(map_at_column, 10);
    write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
    cell : entity work.line_memory generic map (576, 26, 10)
      port map (clock, true, read_address, other_4, write_address, write_data);
  end block;

  check_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(check_read_place, 10);
    write_address <= to_unsigned(check_write_place, 10);
    write_data <= to_unsigned(check_winner, 8) & to_unsigned(check_cost, 12);
    cell : entity work.line_memory generic map (1024, 20, 10)
      port map (clock, true, read_address, check_read_words_0, write_address, write_data);
  end block;

  check_found_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(check_address, 11);
    write_address <= to_unsigned(check_write_address, 11);
    write_data <= to_unsigned(check_winner, 8);
    cell : entity work.line_memory generic map (2048, 8, 11)
      port map (clock, true, read_address, check_found_0, write_address, write_data);
  end block;

  winners_read_word_0_memory : block
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(passes_write_address, 11);
    write_address <= to_unsigned(winners_write_address, 11);
    write_data <= to_unsigned(winners_write_word_0, 12);
    cell : entity work.line_memory generic map (2048, 12, 11)
      port map (clock, true, read_address, winners_read_word_0, write_address, write_data);
  end block;

  best_read_words_2_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(11 downto 0);
  begin
    read_address <= to_unsigned(best_column, 10);
    write_address <= to_unsigned(best_write_column, 10);
    write_data <= to_unsigned(best_best_last_0_0, 12);
    cell : entity work.line_memory generic map (1024, 12, 10)
      port map (clock, true, read_address, best_read_words_2, write_address, write_data);
  end block;

  best_read_words_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(best_column, 10);
    write_address <= to_unsigned(best_write_column, 10);
    write_data <= to_unsigned(best_best_above_0_0, 12) & to_unsigned(best_best_below_0_0, 12);
    cell : entity work.line_memory generic map (1024, 24, 10)
      port map (clock, true, read_address, best_read_words_1, write_address, write_data);
  end block;

  best_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(19 downto 0);
  begin
    read_address <= to_unsigned(best_column, 10);
    write_address <= to_unsigned(best_write_column, 10);
    write_data <= to_unsigned(best_best_index_0_0, 8) & to_unsigned(best_best_cost_0_0, 12);
    cell : entity work.line_memory generic map (1024, 20, 10)
      port map (clock, true, read_address, best_read_words_0, write_address, write_data);
  end block;

  best_read_losers_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(best_late_column, 10);
    write_address <= to_unsigned(best_late_write_column, 10);
    write_data <= to_unsigned(best_best_but_last_0_0, 12) & to_unsigned(best_best_second_0_0, 12);
    cell : entity work.line_memory generic map (1024, 24, 10)
      port map (clock, true, read_address, best_read_losers_0, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 1 downto 0 generate
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
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 13);
    write_address <= to_unsigned(slice0cost_write_column, 13);
    write_data <= to_unsigned(slice0cost_write_words(i), 16);
    cell : entity work.line_memory generic map (4711, 16, 13)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  passes_read_search_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(passes_search_address, 11);
    write_address <= to_unsigned(passes_write_address, 11);
    write_data <= to_unsigned(passes_write_search(i), 26);
    cell : entity work.line_memory generic map (2048, 26, 11)
      port map (clock, true, read_address, passes_read_search(i), write_address, write_data);
  end generate;

  passes_read_reference_memory : for i in 1 downto 0 generate
    signal read_address, write_address : unsigned(10 downto 0);
    signal write_data : unsigned(25 downto 0);
  begin
    read_address <= to_unsigned(passes_reference_address, 11);
    write_address <= to_unsigned(passes_write_address, 11);
    write_data <= to_unsigned(passes_write_reference(i), 26);
    cell : entity work.line_memory generic map (2048, 26, 11)
      port map (clock, true, read_address, passes_read_reference(i), write_address, write_data);
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
    variable transform_counter_group_is_equals, check_checked_tag_row_start_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_first_column_is_equal, passes_row_is_equal, passes_row_ended_all, passes_shows_any,
      passes_showing_first_group_differs, passes_read_tag_leaves_window_differs, passes_read_tag_map_column_is_equal,
      passes_read_tag_map_column_choice, slice0winner3_best_cost_0_0_is_less, slice0winner3_best_below_0_0_is_equal,
      slice0winner3_best_above_0_0_is_equal, best_base_any, best_base_is_equal, best_first_pass_is_equal,
      refinement_divisor_0_0_is_less, winners_row_differs, winners_column_any, check_read_has_before_is_less,
      check_read_has_before_value, check_cost_any, check_checked_tag_row_start_differs, map_counter_group_is_equal,
      map_line_ended_choice, map_at_arrives_value, map_window_complete_is_equal, map_window_complete_choice : boolean;
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices, map_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 212);
    variable transform_left_filter_feature_0_choice_201, transform_right_filter_feature_0_choice_201,
      refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable transform_left_filter_feature_0_choice_202,
      transform_right_filter_feature_0_choice_202 : natural range 0 to 63;
    variable transform_left_filter_feature_0_choice_203,
      transform_right_filter_feature_0_choice_203 : natural range 0 to 511;
    variable transform_left_filter_feature_0_choice_204, transform_right_filter_feature_0_choice_204,
      slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice, best_best_below_0_0_choice,
      best_best_above_0_0_choice, refinement_divisor_0_0_choice, map_of_column_0_a_choice : natural range 0 to 4095;
    variable transform_left_filter_feature_0_choice_213,
      transform_right_filter_feature_0_choice_213 : natural range 0 to 8191;
    variable transform_left_filter_feature_0_choice_214,
      transform_right_filter_feature_0_choice_214 : natural range 0 to 131071;
    variable transform_left_filter_feature_0_choice_215,
      transform_right_filter_feature_0_choice_215 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_216,
      transform_right_filter_feature_0_choice_216 : natural range 0 to 8388607;
    variable transform_counter_next_frame_choices, passes_coming_first_group_choices, passes_coming_output_choices,
      passes_coming_starts_choices, passes_showing_output_choices, passes_leaving_starts_choices : boolean_1d(1 to 2);  -- _choice_#
    variable passes_pass_ends_choice : natural range 586 to 593;
    variable passes_search_start_choices : natural_127_1d(1 to 2);  -- _choice_#
    variable passes_search_address_value, check_read_counts_sum, check_read_counts_choice : natural range 0 to 1024;
    variable passes_search_address_choice, check_read_place_choice, check_first_choice : natural range 0 to 127;
    variable passes_search_address_choice_2, passes_reference_address_choice, winners_column_choice,
      check_write_place_choice : natural range 0 to 1023;
    variable slice0cost_column_0_choice : natural_255_2d(0 to 7, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice : natural_255_1d(0 to 7);  -- _#_choice
    variable slice0window_sum_0_choice : natural_4095_1d(0 to 7);  -- _#_choice
    variable slice0other_cost_0_all : boolean_1d(1 to 7);  -- _#_all
    variable slice0other_cost_0_choice : boolean_1d(1 to 6);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less : boolean_1d(0 to 3);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
    variable slice0winner2_best_below_0_is_equal : boolean_1d(0 to 1);  -- _#_is_equal
    variable slice0winner2_best_below_0_choice, slice0winner2_best_above_0_choice : natural_4095_1d(0 to 1);  -- _#_choice
    variable slice0winner2_best_second_0_choice : natural_4095_2d(0 to 1, 1 to 4);  -- _#_choice_#
    variable slice0winner3_best_second_0_0_choices : natural_4095_1d(1 to 4);  -- _choice_#
    variable best_base_choices, check_read_winner_choices : natural_31_1d(1 to 2);  -- _choice_#
    variable best_before_is_last_values : boolean_1d(1 to 2);  -- _value_#
    variable best_before_is_last_choices, check_read_has_before_choices : boolean_1d(1 to 7);  -- _choice_#
    variable best_before_is_last_values_from_3 : natural_3_1d(3 to 4);  -- _value_#
    variable best_best_second_0_0_choices : natural_4095_1d(1 to 6);  -- _choice_#
    variable best_best_second_0_0_choice_3 : unsigned(59 downto 0);
    variable best_write_column_choices : natural_1023_1d(1 to 2);  -- _choice_#
    variable refinement_remainder_1_0_difference : natural range 4097 to 12287;
    variable refinement_remainder_0_difference : natural_4097_to_16382_1d(2 to 7);  -- _#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable check_read_winner_alls, check_checked_tag_row_start_alls : boolean_1d(1 to 2);  -- _all_#
    variable check_read_has_before_sum : natural range 1 to 8;
    variable check_checked_passed_0_difference : integer range -254 to 64;
    variable check_checked_tag_row_start_choices : boolean_1d(1 to 3);  -- _choice_#
    variable map_of_column_0_c_choice, map_low_0_0_choice, map_middle_0_0_choice,
      map_high_0_0_choice : natural range 0 to 32767;
    variable map_sorted_low_0_choices, map_sorted_middle_0_choices, map_sorted_high_0_choices,
      map_largest_low_0_choices, map_smallest_high_0_choices : natural_32767_1d(1 to 2);  -- _choice_#
    variable map_median_middle_0_choices, map_out_disparity_0_choices : natural_32767_1d(1 to 4);  -- _choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- _#_0_all
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    best_best_second_0_0_choices := (others => 0); slice0other_cost_0_all := (others => false);
    transform_left_filter_feature_0_choice := (others => false);
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
    transform_columns_column_inside(0 to 3) <= transform_ready_column_inside(0 to 3);
    transform_columns_column_inside(4) <= refinement_passed_0(1);
    transform_columns_column_inside(5 to 8) <= transform_ready_column_inside(5 to 8);
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_filtering_0_column_inside(0 to 3) <= transform_columns_column_inside(0 to 3);
    transform_filtering_0_column_inside(4) <= refinement_passed_0(2);
    transform_filtering_0_column_inside(5 to 8) <= transform_columns_column_inside(5 to 8);
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
    delay_tag_first_column_is_equal := raster_place_column = 1;
    delay_ahead_0 <= raster_features_reference_0;
    delay_delayed_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 9) and (raster_place_group < 489);
    delay_row_inside(1) <= raster_place_group < 480;
    delay_tag.valid <= raster_features_valid;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
      480) and (raster_place_column >= 1) and (raster_place_column < 640);
    delay_tag.first_column <= delay_tag_first_column_is_equal;
    delay_tag.start_of_frame <= (raster_place_group = 4) and delay_tag_first_column_is_equal;
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
    -- passes
    passes_row_is_equal := rows_write_column = 639;
    if rows_tag.valid then
      passes_row <= passes_row_is_equal /= passes_row;
      passes_write_address <= rows_write_column + (as_number(passes_row) * 1024);
      passes_write_search <= rows_search;
      passes_write_reference <= rows_reference;
    end if;
    passes_coming_first_group_choices(1) := choice(rows_tag.first_column, passes_coming_first_group or rows_tag.valid,
      passes_coming_first_group);
    passes_coming_first_group_choices(2) := choice(rows_tag.first_column, passes_coming_first_group and (not
      rows_tag.valid), passes_coming_first_group);
    passes_coming_output_choices(1) := choice(rows_tag.first_column, passes_coming_output or rows_tag.valid,
      passes_coming_output);
    passes_coming_output_choices(2) := choice(rows_tag.first_column, passes_coming_output and (not rows_tag.valid),
      passes_coming_output);
    passes_coming_starts_choices(1) := choice(rows_tag.first_column, passes_coming_starts or rows_tag.valid,
      passes_coming_starts);
    passes_coming_starts_choices(2) := choice(rows_tag.first_column, passes_coming_starts and (not rows_tag.valid),
      passes_coming_starts);
    passes_row_ended_all := rows_tag.valid and passes_row_is_equal;
    passes_shows_any := (not passes_pass_ends) or (not passes_last_pass);
    passes_showing_first_group_differs := rows_write_column /= 639;
    passes_showing_output_choices(1) := choice(rows_tag.valid, passes_row_is_equal or passes_showing_output,
      passes_showing_output);
    passes_showing_output_choices(2) := choice(rows_tag.valid, passes_showing_first_group_differs and
      passes_showing_output, passes_showing_output);
    passes_pass_ends_choice := choice(passes_last_pass, 593, 586);
    passes_search_start_choices(1) := choice(passes_shows_any, ((passes_search_start / 8) + 127) mod 128, 6);
    passes_search_start_choices(2) := choice(passes_pass_ends, passes_search_start_choices(1), passes_search_start / 8);
    passes_search_address_value := as_number((not passes_row)) * 1024;
    passes_search_address_choice := choice(passes_shows_any, passes_search_start / 8, 7);
    passes_search_address_choice_2 := choice(passes_pass_ends, passes_search_address_choice * 8, (passes_search_address
      + as_number(passes_shows)) mod 1024);
    passes_reference_address_choice := choice(passes_pass_ends, 56, (passes_reference_address +
      as_number(passes_shows)) mod 1024);
    passes_leaving_starts_choices(1) := choice(rows_tag.valid, passes_row_is_equal or passes_leaving_starts,
      passes_leaving_starts);
    passes_leaving_starts_choices(2) := choice(rows_tag.valid, passes_showing_first_group_differs and
      passes_leaving_starts, passes_leaving_starts);
    passes_read_tag_leaves_window_differs := passes_column /= 0;
    passes_read_tag_map_column_is_equal := passes_column = 8;
    passes_read_tag_map_column_choice := choice(passes_read_tag.map_column, passes_read_tag_map_column_is_equal or (not
      passes_read_tag.end_of_line), passes_read_tag_map_column_is_equal);
    passes_row_ended <= passes_row_ended_all;
    passes_arrived <= rows_tag.valid;
    passes_pass_ends <= passes_column = passes_pass_ends_choice;
    passes_last_pass <= passes_pass = 7;
    passes_search_start <= passes_search_start_choices(2) * 8;
    passes_search_address <= passes_search_address_value + passes_search_address_choice_2;
    passes_reference_address <= passes_search_address_value + passes_reference_address_choice;
    passes_read_tag.valid <= passes_shows;
    passes_read_tag.row_start <= to_integer(((to_unsigned(passes_pass, 10)) or (to_unsigned(passes_column, 10)))) = 0;
    passes_read_tag.first_group <= passes_showing_first_group;
    passes_read_tag.border_column <= (passes_column /= 7) and (passes_read_tag.border_column or (passes_column = 0) or
      (passes_column = 584));
    passes_read_tag.first_cost <= passes_column = 7;
    passes_read_tag.map_column <= passes_read_tag_map_column_choice;
    passes_read_tag.output_column <= passes_showing_output and passes_read_tag_map_column_choice;
    passes_read_tag.first_column <= passes_read_tag.first_cost;
    passes_read_tag.end_of_line <= passes_column = 583;
    passes_search(0) <= to_integer(passes_read_search(0));
    passes_search(1) <= to_integer(passes_read_search(1));
    passes_reference(0) <= to_integer(passes_read_reference(0));
    passes_reference(1) <= to_integer(passes_read_reference(1));
    passes_tag.valid <= passes_read_tag.valid;
    passes_tag.row_start <= passes_read_tag.row_start;
    passes_tag.first_group <= passes_read_tag.first_group;
    passes_tag.border_column <= passes_read_tag.border_column;
    passes_tag.first_cost <= passes_read_tag_map_column_is_equal;
    passes_tag.leaves_window <= passes_read_tag.leaves_window;
    passes_tag.map_column <= passes_read_tag.map_column;
    passes_tag.output_column <= passes_read_tag.output_column;
    passes_tag.first_column <= passes_read_tag.first_column;
    passes_coming_first_group <= choice(rows_tag.first_group, passes_coming_first_group_choices(1),
      passes_coming_first_group_choices(2));
    passes_coming_output <= choice(rows_tag.output_column, passes_coming_output_choices(1),
      passes_coming_output_choices(2));
    passes_coming_starts <= choice(rows_tag.start_of_frame, passes_coming_starts_choices(1),
      passes_coming_starts_choices(2));
    passes_shows <= choice(passes_row_ended, (not passes_shows) or (not passes_pass_ends) or (not passes_last_pass),
      passes_shows and passes_shows_any);
    passes_showing_first_group <= choice(passes_showing_first_group, passes_coming_first_group or (not rows_tag.valid)
      or passes_showing_first_group_differs, passes_coming_first_group and rows_tag.valid and passes_row_is_equal);
    passes_showing_output <= choice(passes_coming_output, passes_showing_output_choices(1),
      passes_showing_output_choices(2));
    passes_showing_starts <= choice(passes_coming_starts, passes_showing_starts or passes_row_ended_all,
      passes_showing_starts and ((not rows_tag.valid) or passes_showing_first_group_differs));
    passes_column <= choice(passes_pass_ends, 0, (passes_column + as_number(passes_shows)) mod 1024);
    passes_leaving_starts <= choice(passes_showing_starts, passes_leaving_starts_choices(1),
      passes_leaving_starts_choices(2));
    passes_read_tag.leaves_window <= choice(passes_read_tag.leaves_window, passes_read_tag_leaves_window_differs,
      (passes_column = 16) and passes_read_tag_leaves_window_differs);
    if passes_pass_ends then passes_pass <= choice(passes_shows_any, (passes_pass + 1) mod 8, 0); end if;
    -- slice0shift
    if passes_tag.valid then
      for i in 0 to 1 loop
        slice0shift_search(i, 0) <= passes_search(i);
        for j in 1 to 7 loop slice0shift_search(i, j) <= slice0shift_search(i, j - 1); end loop;
      end loop;
    end if;
    slice0shift_reference <= passes_reference;
    slice0shift_tag <= passes_tag;
    -- slice0cost
    for i in 0 to 3 loop
      slice0cost_column_0_choice(2 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        256);
      slice0cost_column_0_choice(2 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2 * i)
        + slice0cost_column_0_choice(2 * i, 1)) mod 256);
      slice0cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 256);
      slice0cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2
        * i + 1) + slice0cost_column_0_choice(2 * i + 1, 1)) mod 256);
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
      for j in 1 to 7 loop
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
    slice0cost_pixels_first_tag.valid <= slice0shift_tag.valid;
    slice0cost_pixels_first_tag.first_group <= slice0shift_tag.first_group;
    slice0cost_pixels_first_tag.border_column <= slice0shift_tag.border_column;
    slice0cost_pixels_first_tag.first_cost <= slice0shift_tag.first_cost;
    slice0cost_pixels_first_tag.leaves_window <= slice0shift_tag.leaves_window;
    slice0cost_pixels_first_tag.map_column <= slice0shift_tag.map_column;
    slice0cost_pixels_first_tag.output_column <= slice0shift_tag.output_column;
    slice0cost_pixels_first_tag.first_column <= slice0shift_tag.first_column;
    for i in 0 to 1 loop
      for j in 0 to 7 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 6) + slice0cost_pixels_first_count(i, j, 0)
          + slice0cost_pixels_first_count(i, j, 1) + slice0cost_pixels_first_count(i, j, 3) +
          slice0cost_pixels_first_count_8(i, j) + slice0cost_pixels_first_count(i, j, 4) +
          slice0cost_pixels_first_count(i, j, 5) + slice0cost_pixels_first_count(i, j, 7) +
          slice0cost_pixels_first_count(i, j, 2);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    slice0cost_change_column <= slice0cost_read_column;
    for i in 0 to 7 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    slice0cost_ready_words(0) <= to_integer(slice0cost_read_words(0));
    slice0cost_ready_words(1) <= to_integer(slice0cost_read_words(1));
    slice0cost_ready_words(2) <= to_integer(slice0cost_read_words(2));
    slice0cost_ready_words(3) <= to_integer(slice0cost_read_words(3));
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 7 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_tag.valid <= slice0cost_ready_tag.valid;
    slice0cost_tag.first_cost <= slice0cost_ready_tag.first_cost;
    slice0cost_tag.leaves_window <= slice0cost_ready_tag.leaves_window;
    slice0cost_tag.map_column <= slice0cost_ready_tag.map_column;
    slice0cost_tag.output_column <= slice0cost_ready_tag.output_column;
    slice0cost_tag.first_column <= slice0cost_ready_tag.first_column;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 8192);
    end if;
    if slice0cost_ready_tag.valid then
      slice0cost_write_column <= slice0cost_ready_column;
      for i in 0 to 3 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(2 * i + 1, 2) * 256) + slice0cost_column_0_choice(2 *
          i, 2);
      end loop;
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 9, 0, (slice0window_ring_read_address +
        1) mod 16);
    end if;
    for i in 0 to 1 loop
      for j in 0 to 3 loop
        slice0window_change_0_choice(4 * i + j) := choice(slice0window_entering_tag.leaves_window,
          to_integer(slice0window_leaving(i)(8 * j + 7 downto 8 * j)), 0);
      end loop;
    end loop;
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag.valid <= slice0cost_tag.valid;
    slice0window_entering_tag.first_cost <= slice0cost_tag.first_cost;
    slice0window_entering_tag.leaves_window <= slice0cost_tag.leaves_window;
    slice0window_entering_tag.map_column <= slice0cost_tag.map_column;
    slice0window_entering_tag.output_column <= slice0cost_tag.output_column;
    slice0window_entering_tag.first_column <= slice0window_entering_tag.first_cost;
    for i in 0 to 7 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag.valid <= slice0window_entering_tag.valid;
    slice0window_change_tag.first_cost <= slice0cost_tag.first_column;
    slice0window_change_tag.map_column <= slice0window_entering_tag.map_column;
    slice0window_change_tag.output_column <= slice0window_entering_tag.output_column;
    slice0window_change_tag.first_column <= slice0window_entering_tag.first_column;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    slice0window_tag.map_column <= slice0window_centre_map_column(3);
    slice0window_tag.output_column <= slice0window_centre_output_column(3);
    slice0window_tag.first_column <= slice0window_centre_first_column(3);
    for i in 0 to 7 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 7 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 4096;
      end loop;
      slice0window_centre_map_column(0) <= slice0window_change_tag.map_column;
      slice0window_centre_map_column(1 to 3) <= slice0window_centre_map_column(0 to 2);
      slice0window_centre_output_column(0) <= slice0window_change_tag.output_column;
      slice0window_centre_output_column(1 to 3) <= slice0window_centre_output_column(0 to 2);
      slice0window_centre_first_column(0) <= slice0window_change_tag.first_column;
      slice0window_centre_first_column(1 to 3) <= slice0window_centre_first_column(0 to 2);
    end if;
    -- slice0other
    slice0other_cost_0_all(1) := slice0window_tag.output_column and slice0window_tag.first_column;
    for i in 1 to 6 loop
      slice0other_cost_0_choice(i) := choice((slice0window_sum_0(i) - slice0other_cost_0(i - 1)) < 0,
        slice0window_tag.output_column, slice0other_cost_0_all(1));
    end loop;
    slice0other_cost_0_all(7) := slice0window_tag.output_column and (((slice0window_sum_0(7) - slice0other_cost_0(6)) <
      0) or slice0window_tag.first_column);
    if slice0window_tag.valid then
      slice0other_winner_0_1 <= slice0other_cost_0_choice(1);
      slice0other_cost_0(0) <= choice(slice0window_tag.output_column, slice0window_sum_0(0), 0);
      slice0other_cost_0(1) <= choice(slice0other_cost_0_choice(1), slice0window_sum_0(1), slice0other_cost_0(0));
      slice0other_cost_0(2) <= choice(slice0other_cost_0_choice(2), slice0window_sum_0(2), slice0other_cost_0(1));
      slice0other_winner_0(2) <= choice(slice0other_cost_0_choice(2), 2, as_number(slice0other_winner_0_1));
      for i in 3 to 6 loop
        slice0other_cost_0(i) <= choice(slice0other_cost_0_choice(i), slice0window_sum_0(i), slice0other_cost_0(i - 1));
        slice0other_winner_0(i) <= choice(slice0other_cost_0_choice(i), i, slice0other_winner_0(i - 1));
      end loop;
      slice0other_cost_0(7) <= choice(slice0other_cost_0_all(7), slice0window_sum_0(7), slice0other_cost_0(6));
      slice0other_winner_0(7) <= choice(slice0other_cost_0_all(7), 7, slice0other_winner_0(6));
    end if;
    slice0other_cost_out_0 <= slice0other_cost_0(7);
    -- slice0winner1
    slice0winner1_best_cost_0_is_less(0) := (slice0window_sum_0(1) - slice0window_sum_0(0)) < 0;
    slice0winner1_best_cost_0_is_less(1) := (slice0window_sum_0(3) - slice0window_sum_0(2)) < 0;
    slice0winner1_best_cost_0_is_less(2) := (slice0window_sum_0(5) - slice0window_sum_0(4)) < 0;
    slice0winner1_best_cost_0_is_less(3) := (slice0window_sum_0(7) - slice0window_sum_0(6)) < 0;
    slice0winner1_held_0 <= slice0window_sum_0;
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_place_0_2 <= slice0winner1_best_cost_0_is_less(2);
    slice0winner1_best_late_cost_0 <= slice0winner1_best_cost_0;
    slice0winner1_best_but_first_0(0) <= slice0winner1_held_0(1);
    slice0winner1_best_but_first_0(1) <= slice0winner1_held_0(3);
    slice0winner1_best_but_first_0(2) <= slice0winner1_held_0(5);
    slice0winner1_best_but_first_0(3) <= slice0winner1_held_0(7);
    slice0winner1_best_but_last_0(0) <= slice0winner1_held_0(0);
    slice0winner1_best_but_last_0(1) <= slice0winner1_held_0(2);
    slice0winner1_best_but_last_0(2) <= slice0winner1_held_0(4);
    slice0winner1_best_but_last_0(3) <= slice0winner1_held_0(6);
    slice0winner1_tag.valid <= slice0window_tag.valid;
    slice0winner1_tag.map_column <= slice0window_tag.map_column;
    slice0winner1_tag.first_column <= slice0window_tag.first_column;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 0 to 2 loop
      slice0winner1_best_below_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i), 0);
      slice0winner1_best_above_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 0, slice0window_sum_0(2 * i + 1));
      slice0winner1_best_cost_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), slice0window_sum_0(2 * i +
        3), slice0window_sum_0(2 * i + 2));
      slice0winner1_best_index_0(i + 1) <= choice(slice0winner1_best_cost_0_is_less(i + 1), 2 * i + 3, 2 * i + 2);
    end loop;
    slice0winner1_best_below_0(3) <= choice(slice0winner1_best_cost_0_is_less(3), slice0window_sum_0(6), 0);
    slice0winner1_best_above_0(3) <= choice(slice0winner1_best_cost_0_is_less(3), 0, slice0window_sum_0(7));
    -- slice0winner2
    slice0winner2_best_cost_0_is_less(0) := (slice0winner1_best_cost_0(1) - slice0winner1_best_cost_0(0)) < 0;
    slice0winner2_best_cost_0_is_less(1) := (slice0winner1_best_cost_0(3) - slice0winner1_best_cost_0(2)) < 0;
    slice0winner2_best_below_0_is_equal(0) := slice0winner1_best_index_0(1) = 2;
    slice0winner2_best_below_0_choice(0) := choice(slice0winner2_best_below_0_is_equal(0), slice0winner1_held_0(1),
      slice0winner1_best_below_0(1));
    slice0winner2_best_below_0_is_equal(1) := slice0winner1_best_index_0(3) = 6;
    slice0winner2_best_below_0_choice(1) := choice(slice0winner2_best_below_0_is_equal(1), slice0winner1_held_0(5),
      slice0winner1_best_below_0(3));
    slice0winner2_best_above_0_choice(0) := choice(slice0winner1_best_index_0_0, slice0winner1_held_0(2),
      slice0winner1_best_above_0(0));
    slice0winner2_best_above_0_choice(1) := choice(slice0winner1_best_place_0_2, slice0winner1_held_0(6),
      slice0winner1_best_above_0(2));
    for i in 0 to 1 loop
      slice0winner2_best_second_0_choice(i, 1) := choice(slice0winner2_best_place_0(i), 4095,
        slice0winner1_best_late_cost_0(2 * i + 1));
      slice0winner2_best_second_0_choice(i, 2) := choice(slice0winner2_best_at_end_0(i),
        slice0winner1_best_but_first_0(2 * i + 1), slice0winner2_best_second_0_choice(i, 1));
      slice0winner2_best_second_0_choice(i, 3) := choice(slice0winner2_best_place_0(i),
        slice0winner1_best_late_cost_0(2 * i), 4095);
      slice0winner2_best_second_0_choice(i, 4) := choice(slice0winner2_best_at_start_0(i),
        slice0winner1_best_but_last_0(2 * i), slice0winner2_best_second_0_choice(i, 3));
    end loop;
    slice0winner2_best_first_0(0) <= slice0winner1_held_0(0);
    slice0winner2_best_first_0(1) <= slice0winner1_held_0(4);
    slice0winner2_best_last_0(0) <= slice0winner1_held_0(3);
    slice0winner2_best_last_0(1) <= slice0winner1_held_0(7);
    slice0winner2_best_place_0 <= slice0winner2_best_cost_0_is_less;
    slice0winner2_best_at_start_0(0) <= slice0winner2_best_cost_0_is_less(0) and slice0winner2_best_below_0_is_equal(0);
    slice0winner2_best_at_start_0(1) <= slice0winner2_best_cost_0_is_less(1) and slice0winner2_best_below_0_is_equal(1);
    slice0winner2_best_at_end_0(0) <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0(1) -
      slice0winner1_best_cost_0(0)) >= 0);
    slice0winner2_best_at_end_0(1) <= slice0winner1_best_place_0_2 and ((slice0winner1_best_cost_0(3) -
      slice0winner1_best_cost_0(2)) >= 0);
    slice0winner2_best_late_cost_0 <= slice0winner2_best_cost_0;
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    slice0winner2_best_below_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner2_best_below_0_choice(0),
      slice0winner1_best_below_0(0));
    slice0winner2_best_above_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_above_0(1),
      slice0winner2_best_above_0_choice(0));
    slice0winner2_best_cost_0(1) <= choice(slice0winner2_best_cost_0_is_less(1), slice0winner1_best_cost_0(3),
      slice0winner1_best_cost_0(2));
    slice0winner2_best_index_0(1) <= choice(slice0winner2_best_cost_0_is_less(1), slice0winner1_best_index_0(3),
      slice0winner1_best_index_0(2));
    slice0winner2_best_below_0(1) <= choice(slice0winner2_best_cost_0_is_less(1), slice0winner2_best_below_0_choice(1),
      slice0winner1_best_below_0(2));
    slice0winner2_best_above_0(1) <= choice(slice0winner2_best_cost_0_is_less(1), slice0winner1_best_above_0(3),
      slice0winner2_best_above_0_choice(1));
    slice0winner2_best_second_0(0) <= smaller(slice0winner2_best_second_0_choice(0, 2),
      slice0winner2_best_second_0_choice(0, 4));
    slice0winner2_best_second_0(1) <= smaller(slice0winner2_best_second_0_choice(1, 2),
      slice0winner2_best_second_0_choice(1, 4));
    slice0winner2_best_but_first_0(0) <= smaller(slice0winner1_best_late_cost_0(1), slice0winner1_best_but_first_0(0));
    slice0winner2_best_but_first_0(1) <= smaller(slice0winner1_best_late_cost_0(3), slice0winner1_best_but_first_0(2));
    slice0winner2_best_but_last_0(0) <= smaller(slice0winner1_best_but_last_0(1), slice0winner1_best_late_cost_0(0));
    slice0winner2_best_but_last_0(1) <= smaller(slice0winner1_best_but_last_0(3), slice0winner1_best_late_cost_0(2));
    -- slice0winner3
    slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_below_0_0_is_equal := slice0winner2_best_index_0(1) = 4;
    slice0winner3_best_below_0_0_choice := choice(slice0winner3_best_below_0_0_is_equal, slice0winner2_best_last_0(0),
      slice0winner2_best_below_0(1));
    slice0winner3_best_above_0_0_is_equal := slice0winner2_best_index_0(0) = 3;
    slice0winner3_best_above_0_0_choice := choice(slice0winner3_best_above_0_0_is_equal, slice0winner2_best_first_0(1),
      slice0winner2_best_above_0(0));
    slice0winner3_best_second_0_0_choices(1) := choice(slice0winner3_best_place_0_0, slice0winner2_best_second_0(1),
      slice0winner2_best_late_cost_0(1));
    slice0winner3_best_second_0_0_choices(2) := choice(slice0winner3_best_at_end_0_0,
      slice0winner2_best_but_first_0(1), slice0winner3_best_second_0_0_choices(1));
    slice0winner3_best_second_0_0_choices(3) := choice(slice0winner3_best_place_0_0, slice0winner2_best_late_cost_0(0),
      slice0winner2_best_second_0(0));
    slice0winner3_best_second_0_0_choices(4) := choice(slice0winner3_best_at_start_0_0,
      slice0winner2_best_but_last_0(0), slice0winner3_best_second_0_0_choices(3));
    slice0winner3_best_first_0_0 <= slice0winner2_best_first_0(0);
    slice0winner3_best_last_0_0 <= slice0winner2_best_last_0(1);
    slice0winner3_best_place_0_0 <= slice0winner3_best_cost_0_0_is_less;
    slice0winner3_best_at_start_0_0 <= slice0winner3_best_cost_0_0_is_less and slice0winner3_best_below_0_0_is_equal;
    slice0winner3_best_at_end_0_0 <= ((slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) >= 0) and
      slice0winner3_best_above_0_0_is_equal;
    slice0winner3_best_late_cost_0_0 <= slice0winner3_best_cost_0_0;
    slice0winner3_tag <= slice0winner2_tag;
    slice0winner3_best_cost_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_cost_0(1),
      slice0winner2_best_cost_0(0));
    slice0winner3_best_index_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_index_0(1),
      slice0winner2_best_index_0(0));
    slice0winner3_best_below_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner3_best_below_0_0_choice,
      slice0winner2_best_below_0(0));
    slice0winner3_best_above_0_0 <= choice(slice0winner3_best_cost_0_0_is_less, slice0winner2_best_above_0(1),
      slice0winner3_best_above_0_0_choice);
    slice0winner3_best_second_0_0 <= smaller(slice0winner3_best_second_0_0_choices(2),
      slice0winner3_best_second_0_0_choices(4));
    slice0winner3_best_but_first_0_0 <= smaller(slice0winner2_best_late_cost_0(1), slice0winner2_best_but_first_0(0));
    slice0winner3_best_but_last_0_0 <= smaller(slice0winner2_best_but_last_0(1), slice0winner2_best_late_cost_0(0));
    -- slice0
    slice0_best_index_0_0 <= slice0winner3_best_index_0_0;
    slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
    slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
    slice0_best_first_0_0 <= slice0winner3_best_first_0_0;
    slice0_best_last_0_0 <= slice0winner3_best_last_0_0;
    slice0_best_late_cost_0_0 <= slice0winner3_best_late_cost_0_0;
    slice0_best_second_0_0 <= slice0winner3_best_second_0_0;
    slice0_best_but_first_0_0 <= slice0winner3_best_but_first_0_0;
    slice0_best_but_last_0_0 <= slice0winner3_best_but_last_0_0;
    slice0_best_tag <= slice0winner3_tag;
    -- best
    best_base_any := (not best_waiting_tag.valid) or (not best_waiting_tag.first_column);
    best_base_is_equal := best_pass = 7;
    best_base_choices(1) := choice(best_base_is_equal, 0, ((best_base / 8) + 1) mod 32);
    best_base_choices(2) := choice(best_base_any, best_base / 8, best_base_choices(1));
    best_first_pass_is_equal := best_pass = 0;
    best_before_is_last_values(1) := is_set(best_last_before, 6);
    best_before_is_last_choices(1) := choice(best_before_is_last_values(1), (best_ready_words_0 / 262144) = 3,
      (best_ready_words_0 / 262144) = 2);
    best_before_is_last_choices(2) := choice(best_before_is_last_values(1), (best_ready_words_0 / 262144) = 1,
      (best_ready_words_0 / 262144) = 0);
    best_before_is_last_choices(3) := choice(is_set(best_last_before, 7), best_before_is_last_choices(1),
      best_before_is_last_choices(2));
    best_before_is_last_values(2) := is_set(best_last_before, 4);
    best_before_is_last_values_from_3(3) := (best_ready_words_0 / 65536) mod 4;
    best_before_is_last_choices(4) := choice(best_before_is_last_values(2), best_before_is_last_values_from_3(3) = 3,
      best_before_is_last_values_from_3(3) = 2);
    best_before_is_last_choices(5) := choice(best_before_is_last_values(2), best_before_is_last_values_from_3(3) = 1,
      best_before_is_last_values_from_3(3) = 0);
    best_before_is_last_choices(6) := choice(is_set(best_last_before, 5), best_before_is_last_choices(4),
      best_before_is_last_choices(5));
    best_before_is_last_values_from_3(4) := (best_ready_words_0 / 16384) mod 4;
    best_before_is_last_choices(7) := choice(is_set(best_last_before, 3), best_before_is_last_values_from_3(4) = 3,
      best_before_is_last_values_from_3(4) = 1);
    best_best_below_0_0_choice := choice(best_here_is_first, best_compared_words(2), best_compared_below_0_0);
    best_best_above_0_0_choice := choice(best_before_is_last, best_compared_first_0_0, best_compared_words(1) / 4096);
    best_best_second_0_0_choices(1) := choice(best_best_place_0_0, best_compared_second_0_0,
      best_compared_late_cost_0_0);
    best_best_second_0_0_choices(2) := choice(best_best_at_end_0_0, best_compared_but_first_0_0,
      best_best_second_0_0_choices(1));
    if best_was_first then
      best_best_second_0_0_choice_3 := to_unsigned(4095, 12) & to_unsigned(4095, 16) & to_unsigned(4095, 16) &
        to_unsigned(4095, 16);
    else
      best_best_second_0_0_choice_3 := to_unsigned((best_compared_losers_0 / 4096), 12) & to_unsigned(4095, 16) &
        to_unsigned((best_compared_losers_0 mod 4096), 16) & to_unsigned(best_kept_cost, 16);
    end if;
    best_best_second_0_0_choices(4) := choice(best_was_first, 4095, best_kept_cost);
    best_best_second_0_0_choices(5) := choice(best_best_place_0_0, best_best_second_0_0_choices(4),
      to_integer(best_best_second_0_0_choice_3(27 downto 16)));
    best_best_second_0_0_choices(6) := choice(best_best_at_start_0_0, to_integer(best_best_second_0_0_choice_3(59
      downto 48)), best_best_second_0_0_choices(5));
    best_write_column_choices(1) := choice(best_compared_tag.first_column, 0, (best_place_column + 1) mod 1024);
    best_write_column_choices(2) := choice(best_compared_tag.valid, best_write_column_choices(1), best_place_column);
    best_read_index_0_0 <= slice0_best_index_0_0;
    best_read_below_0_0 <= slice0_best_below_0_0;
    best_read_above_0_0 <= slice0_best_above_0_0;
    best_read_first_0_0 <= slice0_best_first_0_0;
    best_read_last_0_0 <= slice0_best_last_0_0;
    best_read_late_cost_0_0 <= slice0_best_late_cost_0_0;
    best_read_second_0_0 <= slice0_best_second_0_0;
    best_read_but_first_0_0 <= slice0_best_but_first_0_0;
    best_read_but_last_0_0 <= slice0_best_but_last_0_0;
    best_read_tag <= slice0_best_tag;
    best_late_column <= best_column;
    best_waiting_index_0_0 <= best_read_index_0_0;
    best_waiting_below_0_0 <= best_read_below_0_0;
    best_waiting_above_0_0 <= best_read_above_0_0;
    best_waiting_first_0_0 <= best_read_first_0_0;
    best_waiting_last_0_0 <= best_read_last_0_0;
    best_waiting_late_cost_0_0 <= best_read_late_cost_0_0;
    best_waiting_second_0_0 <= best_read_second_0_0;
    best_waiting_but_first_0_0 <= best_read_but_first_0_0;
    best_waiting_but_last_0_0 <= best_read_but_last_0_0;
    best_waiting_tag <= best_read_tag;
    best_ready_index_0_0 <= best_waiting_index_0_0;
    best_ready_below_0_0 <= best_waiting_below_0_0;
    best_ready_above_0_0 <= best_waiting_above_0_0;
    best_ready_first_0_0 <= best_waiting_first_0_0;
    best_ready_last_0_0 <= best_waiting_last_0_0;
    best_ready_late_cost_0_0 <= best_waiting_late_cost_0_0;
    best_ready_second_0_0 <= best_waiting_second_0_0;
    best_ready_but_first_0_0 <= best_waiting_but_first_0_0;
    best_ready_but_last_0_0 <= best_waiting_but_last_0_0;
    best_ready_tag <= best_waiting_tag;
    best_ready_words_0 <= to_integer(best_read_words_0);
    best_ready_words_1 <= to_integer(best_read_words_1);
    best_ready_words_2 <= to_integer(best_read_words_2);
    best_ready_losers_0 <= to_integer(best_read_losers_0);
    best_base <= best_base_choices(2) * 8;
    best_compared_index_0_0 <= ((best_base / 8) * 8) + best_ready_index_0_0;
    best_compared_below_0_0 <= best_ready_below_0_0;
    best_compared_above_0_0 <= best_ready_above_0_0;
    best_compared_first_0_0 <= best_ready_first_0_0;
    best_compared_last_0_0 <= best_ready_last_0_0;
    best_compared_late_cost_0_0 <= best_ready_late_cost_0_0;
    best_compared_second_0_0 <= best_ready_second_0_0;
    best_compared_but_first_0_0 <= best_ready_but_first_0_0;
    best_compared_but_last_0_0 <= best_ready_but_last_0_0;
    best_compared_tag <= best_ready_tag;
    best_compared_words(1) <= best_ready_words_1;
    best_compared_words(2) <= best_ready_words_2;
    best_compared_losers_0 <= best_ready_losers_0;
    best_first_pass <= best_first_pass_is_equal;
    best_last_pass <= best_base_is_equal;
    best_here_wins <= ((best_waiting_late_cost_0_0 - (best_ready_words_0 mod 4096)) < 0) or best_first_pass_is_equal;
    best_here_is_first <= best_ready_index_0_0 = 0;
    best_before_is_last <= best_before_is_last_choices(3) and best_before_is_last_choices(6) and
      best_before_is_last_choices(7) and (((best_ready_words_0 / 4096) mod 4) = 3);
    best_best_last_0_0 <= best_compared_last_0_0;
    best_best_place_0_0 <= best_here_wins;
    best_best_at_start_0_0 <= (not best_first_pass) and best_here_is_first and best_here_wins;
    best_best_at_end_0_0 <= best_before_is_last and (not best_here_wins);
    best_best_late_cost_0_0 <= best_best_cost_0_0;
    best_best_tag.valid <= best_compared_tag.valid;
    best_best_tag.map_column <= best_last_pass and best_compared_tag.map_column;
    best_best_tag.first_column <= best_last_pass and best_compared_tag.first_column;
    best_late_write_column <= best_write_column;
    best_kept_cost <= other_13;
    best_was_first <= best_first_pass;
    best_best_cost_0_0 <= choice(best_here_wins, best_ready_late_cost_0_0, other_13);
    best_best_index_0_0 <= choice(best_here_wins, best_compared_index_0_0, other_5);
    best_best_below_0_0 <= choice(best_here_wins, best_best_below_0_0_choice, best_compared_words(1) mod 4096);
    best_best_above_0_0 <= choice(best_here_wins, best_compared_above_0_0, best_best_above_0_0_choice);
    best_best_second_0_0 <= smaller(best_best_second_0_0_choices(2), best_best_second_0_0_choices(6));
    best_best_but_last_0_0 <= smaller(best_compared_but_last_0_0, best_best_second_0_0_choices(4));
    best_write_column <= choice((not best_compared_tag.map_column) or (not best_compared_tag.valid), 1023,
      best_write_column_choices(2));
    if slice0_best_tag.valid then
      best_column <= choice(slice0_best_tag.first_column, 0, (best_column + 1) mod 1024);
    end if;
    if not best_base_any then
      best_pass <= choice(best_base_is_equal, 0, (best_pass + 1) mod 8);
      best_last_before <= choice(best_base_is_equal, 255, ((((best_last_before / 8) + 1) mod 32) * 8) + 7);
    end if;
    if best_compared_tag.valid then best_place_column <= best_write_column_choices(1); end if;
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
    refinement_disparity_0(0) <= best_best_index_0_0;
    refinement_disparity_0(1 to 11) <= refinement_disparity_0(0 to 10);
    refinement_passed_0(0) <= true;
    refinement_passed_0(1) <= refinement_passed_0(0);
    refinement_passed_0(2) <= transform_ready_column_inside(4);
    refinement_passed_0(4 to 11) <= refinement_passed_0(3 to 10);
    refinement_tag_valid(0) <= best_best_tag.valid;
    refinement_tag_map_column(0) <= best_best_tag.map_column;
    refinement_tag_first_column(0) <= best_best_tag.first_column;
    for i in 1 to 11 loop
      refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
      refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
      refinement_tag_first_column(i) <= refinement_tag_first_column(i - 1);
    end loop;
    refinement_alone_0(0) <= best_best_second_0_0 = 4095;
    refinement_alone_0(1) <= refinement_alone_0(0);
    refinement_gap_0 <= (best_best_second_0_0 - best_best_late_cost_0_0) mod 4096;
    refinement_lowest_0 <= best_best_late_cost_0_0;
    refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
    refinement_scaled_cost_0 <= refinement_lowest_0;
    refinement_u_0 <= (refinement_below_0 - best_best_late_cost_0_0) mod 4096;
    refinement_v_0 <= (refinement_above_0 - best_best_late_cost_0_0) mod 4096;
    refinement_difference_0 <= refinement_above_0 - refinement_below_0;
    refinement_remainder_0(0) <= magnitude(refinement_difference_0);
    refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 12)) or
      (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 12))));
    refinement_divisor_0(1 to 7) <= refinement_divisor_0(0 to 6);
    refinement_quotient_8_0 <= ((((8192 - refinement_divisor_0(7)) / 2) + refinement_remainder_0(7)) / 4096) +
      ((other_6 / 2) * 2);
    refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
    refinement_negative_0(1 to 8) <= refinement_negative_0(0 to 7);
    refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
    refinement_passed_0(3) <= choice(refinement_alone_0(1), transform_columns_column_inside(4),
      transform_columns_column_inside(4) and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0));
    refinement_below_0 <= choice(best_best_index_0_0 = 0, best_best_above_0_0, best_best_below_0_0);
    refinement_above_0 <= choice(best_best_index_0_0 = 63, best_best_below_0_0, best_best_above_0_0);
    refinement_remainder_0(1) <= choice(is_set(refinement_remainder_1_0_difference, 13),
      refinement_remainder_1_0_difference mod 4096, refinement_remainder_0(0));
    for i in 2 to 7 loop
      refinement_remainder_0(i) <= choice(is_set(refinement_remainder_0_difference(i), 13),
        refinement_remainder_0_difference(i) mod 4096, (refinement_remainder_0(i - 1) mod 2048) * 2);
    end loop;
    -- winners
    winners_row_differs := winners_row /= refinement_tag_first_column(11);
    if refinement_tag_map_column(11) then
      winners_row <= choice(refinement_tag_valid(11), winners_row_differs, winners_row);
    end if;
    winners_column_choice := choice(refinement_tag_first_column(11), 0, winners_column);
    winners_column_any := (not refinement_tag_map_column(11)) or (not refinement_tag_valid(11));
    if not winners_column_any then winners_column <= (winners_column_choice + 1) mod 1024; end if;
    winners_write_word_0 <= to_integer(((to_unsigned(as_number(refinement_passed_0(11)), 1) &
      to_unsigned(refinement_disparity_0(11), 11)) or (to_unsigned((refinement_fraction_0 mod 64), 6) & to_unsigned(0,
      6))));
    winners_read_tag.valid <= passes_arrived;
    winners_read_tag.map_column <= (passes_write_address mod 1024) < 576;
    winners_read_tag.start_of_frame <= ((passes_write_address mod 1024) = 0) and passes_leaving_starts;
    winners_read_tag.end_of_line <= (passes_write_address mod 1024) = 575;
    winners_read_address <= passes_write_address;
    winners_winners_disparity_0 <= to_integer(winners_read_word_0(5 downto 0));
    winners_winners_fraction_0 <= to_integer(winners_read_word_0(10 downto 6));
    winners_winners_passed_0 <= winners_read_word_0(11) = '1';
    winners_winners_tag <= winners_read_tag;
    winners_address_out <= winners_read_address;
    winners_write_address <= choice(winners_column_any, 2047, (as_number(winners_row_differs) * 1024) +
      winners_column_choice);
    -- check
    check_read_winner_alls(1) := slice0winner1_tag.valid and slice0winner1_tag.first_column;
    check_read_winner_alls(2) := slice0winner1_tag.valid and slice0winner1_tag.first_column and (check_pass = 7);
    check_read_winner_choices(1) := choice(check_read_winner_alls(2), 0, ((check_base / 8) + 1) mod 32);
    check_read_winner_choices(2) := choice(check_read_winner_alls(1), check_read_winner_choices(1), check_base / 8);
    check_read_place_choice := choice(check_read_winner_alls(2), 7, ((check_first / 8) + 127) mod 128);
    check_read_counts_sum := check_columns + as_number((check_columns /= 583));
    check_read_counts_choice := choice(check_read_winner_alls(1), 0, check_read_counts_sum);
    check_read_has_before_sum := check_pass + 1;
    check_read_has_before_choices(1) := choice(check_read_winner_alls(1), ((check_read_has_before_sum mod 8) / 4) = 1,
      is_set(check_pass, 2));
    check_read_has_before_choices(2) := choice(check_read_winner_alls(2), (not check_read_winner_alls(1)) and
      is_set(check_pass, 2), check_read_has_before_choices(1));
    check_read_has_before_is_less := 7 < check_read_counts_choice;
    check_read_has_before_value := is_set(check_pass, 1);
    check_read_has_before_choices(3) := choice(check_read_winner_alls(1), (((check_read_has_before_sum mod 8) / 2) mod
      2) = 1, check_read_has_before_value);
    check_read_has_before_choices(4) := choice(check_read_winner_alls(2), (not check_read_winner_alls(1)) and
      check_read_has_before_value, check_read_has_before_choices(3));
    check_read_has_before_choices(5) := choice(check_read_winner_alls(1), is_set(check_read_has_before_sum, 0),
      is_set(check_pass, 0));
    check_read_has_before_choices(6) := choice(check_read_winner_alls(2), (not check_read_winner_alls(1)) and
      is_set(check_pass, 0), check_read_has_before_choices(5));
    check_read_has_before_choices(7) := choice(check_read_has_before_choices(4), check_read_has_before_is_less,
      check_read_has_before_choices(6) and check_read_has_before_is_less);
    check_first_choice := choice(check_read_winner_alls(1), check_read_place_choice, check_first / 8);
    check_cost_any := ((check_ready_cost - (check_ready_words_0 mod 4096)) < 0) or (not check_ready_has_before);
    check_write_place_choice := choice(check_ready_counts, check_ready_place, 1023);
    check_checked_passed_0_difference := (check_answered_disparity_0 + 1) - to_integer(check_found_0);
    check_checked_tag_row_start_differs := map_counter_group /= 481;
    check_checked_tag_row_start_is_equals(1) := map_counter_column = 575;
    check_checked_tag_row_start_choices(1) := choice(check_checked_tag_row_start_is_equals(1),
      check_checked_tag.row_start and (map_counter_group /= 480), check_checked_tag.row_start);
    check_checked_tag_row_start_choices(2) := choice(check_checked_tag_row_start_differs,
      check_checked_tag_row_start_choices(1), check_checked_tag.row_start);
    check_checked_tag_row_start_is_equals(2) := map_counter_group = 479;
    check_checked_tag_row_start_alls(1) := check_checked_tag_row_start_is_equals(2) and
      check_checked_tag_row_start_is_equals(1);
    check_checked_tag_row_start_choices(3) := choice(check_checked_tag_row_start_choices(2), (not
      check_checked_tag.start_of_frame) or check_checked_tag_row_start_alls(1), check_checked_tag.start_of_frame and
      check_checked_tag_row_start_is_equals(2) and check_checked_tag_row_start_is_equals(1));
    check_checked_tag_row_start_alls(2) := check_checked_tag.valid and check_checked_tag.map_column;
    check_read_winner <= (check_read_winner_choices(2) * 8) + slice0other_winner_0(7);
    check_read_counts <= (check_read_counts_choice < 583) and slice0winner1_tag.valid;
    check_read_row <= check_read_winner_alls(2) /= check_read_row;
    check_base <= check_read_winner_choices(2) * 8;
    check_first <= check_first_choice * 8;
    check_waiting_cost <= slice0other_cost_out_0;
    check_waiting_winner <= check_read_winner;
    check_waiting_place <= check_read_place;
    check_waiting_counts <= check_read_counts;
    check_waiting_has_before <= check_read_has_before;
    check_waiting_row <= check_read_row;
    check_ready_cost <= check_waiting_cost;
    check_ready_winner <= check_waiting_winner;
    check_ready_place <= check_waiting_place;
    check_ready_counts <= check_waiting_counts;
    check_ready_has_before <= check_waiting_has_before;
    check_ready_row <= check_waiting_row;
    check_ready_words_0 <= to_integer(check_read_words_0);
    check_write_place <= check_write_place_choice;
    check_write_address <= check_write_place_choice + (as_number(check_ready_row) * 1024);
    check_asking_disparity_0 <= winners_winners_disparity_0;
    check_asking_fraction_0 <= winners_winners_fraction_0;
    check_asking_passed_0 <= winners_winners_passed_0;
    check_asking_tag <= winners_winners_tag;
    check_address <= (winners_address_out + (63 - winners_winners_disparity_0)) mod 2048;
    check_answered_disparity_0 <= check_asking_disparity_0;
    check_answered_fraction_0 <= check_asking_fraction_0;
    check_answered_passed_0 <= check_asking_passed_0;
    check_answered_tag <= check_asking_tag;
    check_checked_disparity_0 <= check_answered_disparity_0;
    check_checked_fraction_0 <= check_answered_fraction_0;
    check_checked_passed_0 <= (check_checked_passed_0_difference >= 0) and (check_checked_passed_0_difference < 3) and
      check_answered_passed_0;
    check_checked_tag.valid <= check_answered_tag.valid;
    check_checked_tag.map_column <= check_answered_tag.map_column;
    check_checked_tag.start_of_frame <= check_answered_tag.start_of_frame;
    check_checked_tag.end_of_line <= check_answered_tag.end_of_line;
    check_read_place <= choice(check_read_winner_alls(1), check_read_place_choice * 8, (check_read_place +
      as_number(slice0winner1_tag.valid)) mod 1024);
    check_read_has_before <= choice(check_read_has_before_choices(2), check_read_has_before_is_less,
      check_read_has_before_choices(7));
    check_cost <= choice(check_cost_any, check_ready_cost, check_ready_words_0 mod 4096);
    check_winner <= choice(check_cost_any, check_ready_winner, check_ready_words_0 / 4096);
    check_checked_tag.row_start <= choice(check_checked_tag_row_start_choices(3), check_checked_tag.row_start or
      check_checked_tag_row_start_alls(2), check_checked_tag.row_start and ((not check_checked_tag.valid) or (not
      check_checked_tag.map_column)));
    if check_read_winner_alls(1) then
      check_pass <= choice(check_read_winner_alls(2), 0, check_read_has_before_sum mod 8);
    end if;
    if slice0winner1_tag.valid then
      check_columns <= choice(check_read_winner_alls(1), 0, check_read_counts_sum mod 1024);
    end if;
    -- map
    if check_checked_tag_row_start_alls(2) then
      map_counter_column <= choice(check_checked_tag.start_of_frame or check_checked_tag_row_start_is_equals(1), 0,
        (map_counter_column + 1) mod 1024);
    end if;
    map_counter_group_choice := choice(check_checked_tag_row_start_alls(1), 15, 0);
    map_counter_group_is_equal := map_counter_group = 480;
    map_counter_group_choices(2) := choice(check_checked_tag.row_start and map_counter_group_is_equal, 1,
      (map_counter_group + 1) mod 512);
    map_counter_group_choices(3) := choice(check_checked_tag_row_start_differs and
      check_checked_tag_row_start_is_equals(1) and check_checked_tag.valid and check_checked_tag.map_column,
      map_counter_group_choices(2), map_counter_group);
    map_line_ended_choice := choice(check_checked_tag.valid, check_checked_tag.map_column, map_line_ended);
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
    map_newest_0 <= ((((((((check_checked_disparity_0 + 4095) mod 2048) * 2) + (check_checked_fraction_0 / 8) + 1) mod
      4096) * 8) + (check_checked_fraction_0 mod 8)) * 2) + as_number(check_checked_passed_0);
    map_arrives <= check_checked_tag_row_start_alls(2);
    map_behind <= map_line_ended and check_checked_tag.valid;
    map_rows_read_newest_0 <= map_newest_0;
    map_rows_ready_newest_0 <= map_rows_read_newest_0;
    map_write_column <= to_integer(other_0(9 downto 0));
    map_column_1 <= other_3 / 8192;
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
    map_counter_group <= choice(check_checked_tag.start_of_frame and check_checked_tag.valid and
      check_checked_tag.map_column, map_counter_group_choice * 32, map_counter_group_choices(3));
    map_line_ended <= choice(check_checked_tag.end_of_line, map_line_ended_choice, map_line_ended and (not
      check_checked_tag.valid));
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
      map_rows_write_words_0 <= (other_3 / 8192) + (map_rows_ready_newest_0 * 8192);
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
    other_1 <= ((other_3 mod 8192) / 2) * 2;
    other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
      to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
      to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) & to_unsigned(map_counter_column,
      16);
    other_3 <= to_integer(other_4);
    other_5 <= best_ready_words_0 / 4096;
    other_6 <= ((refinement_remainder_0_difference(7) / 8192) * 2) + ((other_7 / 4) * 4);
    other_7 <= ((refinement_remainder_0_difference(6) / 8192) * 4) + ((other_8 / 8) * 8);
    other_8 <= ((refinement_remainder_0_difference(5) / 8192) * 8) + ((other_9 / 16) * 16);
    other_9 <= ((refinement_remainder_0_difference(4) / 8192) * 16) + ((other_10 / 32) * 32);
    other_10 <= ((refinement_remainder_0_difference(3) / 8192) * 32) + ((other_11 / 64) * 64);
    other_11 <= ((refinement_remainder_0_difference(2) / 8192) * 64) + ((other_12 / 128) * 128);
    other_12 <= (refinement_remainder_1_0_difference / 8192) * 128;
    other_13 <= best_ready_words_0 mod 4096;
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 481;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 484; delay_column <= 0; delay_tag.valid <= false; delay_tag.first_column <= false;
      delay_tag.start_of_frame <= false; rows_read_column <= 0; rows_read_tag.valid <= false;
      rows_read_tag.first_column <= false; rows_read_tag.start_of_frame <= false; rows_ready_column <= 0;
      rows_ready_tag.valid <= false; rows_ready_tag.first_column <= false; rows_ready_tag.start_of_frame <= false;
      rows_write_column <= 0; rows_tag.valid <= false; rows_tag.first_column <= false; rows_tag.start_of_frame <= false;
      passes_row <= false; passes_coming_starts <= false; passes_row_ended <= false; passes_arrived <= false;
      passes_write_address <= 0; passes_shows <= false; passes_showing_starts <= false; passes_pass <= 0;
      passes_column <= 0; passes_pass_ends <= false; passes_last_pass <= false; passes_search_start <= 48;
      passes_search_address <= 56; passes_reference_address <= 56; passes_leaving_starts <= false;
      passes_read_tag.valid <= false; passes_read_tag.row_start <= false; passes_read_tag.map_column <= false;
      passes_read_tag.end_of_line <= false; passes_tag.valid <= false; passes_tag.row_start <= false;
      passes_tag.first_cost <= false; passes_tag.map_column <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.row_start <= false; slice0shift_tag.first_cost <= false; slice0shift_tag.map_column <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.first_cost <= false;
      slice0cost_pixels_first_tag.map_column <= false; slice0cost_pixels_tag.valid <= false;
      slice0cost_pixels_tag.first_cost <= false; slice0cost_pixels_tag.map_column <= false; slice0cost_read_column <= 0;
      slice0cost_change_column <= 0; slice0cost_ready_column <= 0; slice0cost_ready_tag.valid <= false;
      slice0cost_ready_tag.first_cost <= false; slice0cost_ready_tag.map_column <= false; slice0cost_write_column <= 0;
      slice0cost_tag.valid <= false; slice0cost_tag.first_cost <= false; slice0cost_tag.map_column <= false;
      slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_tag.valid <= false; slice0window_entering_tag.first_cost <= false;
      slice0window_entering_tag.map_column <= false; slice0window_entering_tag.first_column <= false;
      slice0window_change_tag.valid <= false; slice0window_change_tag.map_column <= false;
      slice0window_change_tag.first_column <= false; slice0window_centre_map_column <= (others => false);
      slice0window_centre_first_column <= (others => false); slice0window_tag.valid <= false;
      slice0window_tag.map_column <= false; slice0window_tag.first_column <= false;
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0_best_tag <= (others => false); best_read_tag <= (others => false);
      best_column <= 0; best_late_column <= 0; best_waiting_tag <= (others => false);
      best_ready_tag <= (others => false); best_pass <= 7; best_compared_tag <= (others => false);
      best_last_pass <= false; best_best_tag <= (others => false); best_place_column <= 0; best_write_column <= 0;
      best_late_write_column <= 0;
      for i in 0 to 11 loop
        refinement_tag_valid(i) <= false; refinement_tag_map_column(i) <= false;
        refinement_tag_first_column(i) <= false;
      end loop;
      winners_row <= true; winners_column <= 0; winners_write_address <= 0; winners_read_tag <= (others => false);
      winners_winners_tag <= (others => false); check_read_place <= 0; check_read_counts <= false;
      check_read_row <= true; check_pass <= 7; check_first <= 0; check_columns <= 0; check_waiting_place <= 0;
      check_waiting_counts <= false; check_waiting_row <= true; check_ready_place <= 0; check_ready_counts <= false;
      check_ready_row <= true; check_write_place <= 0; check_write_address <= 0; check_asking_tag <= (others => false);
      check_answered_tag <= (others => false); check_checked_tag <= (others => false); map_counter_column <= 0;
      map_counter_group <= 481; map_arrives <= false; map_behind <= false; map_line_ended <= false;
      map_write_column <= 0; map_at_column <= 0; map_at_arrives <= false; map_at_behind <= false; map_at_top <= false;
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
