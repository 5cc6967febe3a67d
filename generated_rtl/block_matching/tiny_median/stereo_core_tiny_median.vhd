-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_median: 32x12, 8 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 8, median true, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_median
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_median is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 27;
    flush_groups : positive := 65;
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
  assert width_px = 32 report "stereo_core_tiny_median: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_median: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny_median: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_median: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_median: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny_median: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 27 report "stereo_core_tiny_median: latency_clocks is " & integer'image(latency_clocks) & " but this core has 27" severity failure;
  assert flush_groups = 65 report "stereo_core_tiny_median: flush_groups is " & integer'image(flush_groups) & " but this core has 65" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_median: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_median is
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

  signal in_start_of_frame : boolean;
  signal in_valid : boolean;
  signal in_left_pixel : natural range 0 to 255;
  signal in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 15;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 7;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_map_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_reference_0, rows_reference_1, rows_reference_2 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 65535;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_map_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_map_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_map_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 255;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 255;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 255;
  signal slice0shift_search_out_0, slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_map_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -255 to 255;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -255 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_map_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column : boolean;
  signal slice0cost_pair_tag_map_column, slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line : boolean;
  signal slice0cost_tag_valid, slice0cost_tag_border_column, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 511;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_centre_map_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  -- slice0winner1
  signal slice0winner1_of_pair_0_0, slice0winner1_of_pair_0_1, slice0winner1_of_pair_0_2 : natural range 0 to 2301;
  signal slice0winner1_of_four_0_0, slice0winner1_of_four_0_1, slice0winner1_of_four_0_2 : natural range 0 to 2301;
  signal slice0winner1_pair_index_0_0, slice0winner1_pair_tag_valid, slice0winner1_pair_tag_map_column : boolean;
  signal slice0winner1_pair_tag_start_of_frame, slice0winner1_pair_tag_end_of_line : boolean;
  signal slice0winner1_four_tag_valid, slice0winner1_four_tag_map_column : boolean;
  signal slice0winner1_four_tag_start_of_frame, slice0winner1_four_tag_end_of_line, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_map_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_pair_index_0_1, slice0winner1_four_index_0_0 : natural range 0 to 2;
  signal slice0winner1_best_index_0_0 : natural range 0 to 2;
  signal slice0winner1_best_cost_0_0 : natural range 0 to 4095;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 4095;
  signal slice0_best_index_0_0 : natural range 0 to 7;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 255;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 255;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 255;
  signal slice1shift_search_out_0, slice1shift_search_out_1, slice1shift_search_out_2 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -255 to 255;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -255 to 255;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -255 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2 : boolean;
  signal slice1cost_tag_border_column : boolean;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 767;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 767;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 1534;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2301;
  -- slice1winner1
  signal slice1winner1_of_pair_0_0, slice1winner1_of_pair_0_1, slice1winner1_of_pair_0_2 : natural range 0 to 2301;
  signal slice1winner1_of_four_0_0, slice1winner1_of_four_0_1, slice1winner1_of_four_0_2 : natural range 0 to 2301;
  signal slice1winner1_pair_index_0_0 : boolean;
  signal slice1winner1_four_index_0_0, slice1winner1_best_index_0_0 : natural range 0 to 2;
  signal slice1winner1_best_cost_0_0 : natural range 0 to 4095;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 4095;
  signal slice1_best_index_0_0 : natural range 0 to 7;
  signal slice1_best_tag_valid, slice1_best_tag_map_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 255;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 255;
  signal slice2shift_reference_0, slice2shift_reference_1, slice2shift_reference_2 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -255 to 255;
  signal slice2cost_difference_1_1, slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -255 to 255;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 511;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1 : boolean;
  signal slice2cost_single_0_0, slice2cost_single_0_1 : natural range 0 to 255;
  signal slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 767;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1 : natural range 0 to 767;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1 : natural range 0 to 1534;
  signal slice2window_sum_0_0, slice2window_sum_0_1 : natural range 0 to 2301;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner1_best_index_0_0 : boolean;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner2_best_index_0_0 : boolean;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner3_best_index_0_0 : boolean;
  -- slice2
  signal slice2_best_index_0_0 : natural range 0 to 7;
  signal slice2_best_tag_valid, slice2_best_tag_row_start, slice2_best_tag_map_column : boolean;
  signal slice2_best_tag_start_of_frame, slice2_best_tag_end_of_line : boolean;
  -- map
  signal map_counter_column, map_write_column, map_column_1, map_at_column : natural range 0 to 31;
  signal map_comparing_column, map_sorted_column : natural range 0 to 31;
  signal map_counter_group, map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 15;
  signal map_column_2, map_of_column_0_a, map_of_column_0_b, map_of_column_0_c : natural range 0 to 15;
  signal map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0, map_low_0_0, map_low_1_0 : natural range 0 to 15;
  signal map_low_2_0, map_middle_0_0, map_middle_1_0, map_middle_2_0, map_high_0_0 : natural range 0 to 15;
  signal map_high_1_0, map_high_2_0, map_of_low_0_a, map_of_low_0_b, map_of_low_0_c : natural range 0 to 15;
  signal map_of_middle_0_a, map_of_middle_0_b, map_of_middle_0_c, map_of_high_0_a : natural range 0 to 15;
  signal map_of_high_0_b, map_of_high_0_c, map_largest_low_0, map_median_middle_0 : natural range 0 to 15;
  signal map_smallest_high_0, map_of_all_0_a, map_of_all_0_b, map_of_all_0_c : natural range 0 to 15;
  signal map_out_disparity_0 : natural range 0 to 15;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b, map_column_passed_0_0, map_column_passed_1_0, map_comparing_arrives : boolean;
  signal map_comparing_behind, map_comparing_top, map_comparing_output, map_sorted_arrives, map_sorted_behind : boolean;
  signal map_sorted_top, map_sorted_output, map_passed_0_0, map_passed_1_0, map_window_complete : boolean;
  signal map_window_first, map_window_last, map_of_low_0_b_below_a, map_of_low_0_c_below_a : boolean;
  signal map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a : boolean;
  signal map_of_middle_0_c_below_b, map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b : boolean;
  signal map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b, map_waiting_0_complete : boolean;
  signal map_waiting_0_first, map_waiting_0_last, map_waiting_1_complete, map_waiting_1_first : boolean;
  signal map_waiting_1_last, map_waiting_2_complete, map_waiting_2_first, map_waiting_2_last : boolean;
  signal map_waiting_passed_0_0, map_waiting_passed_1_0, map_waiting_passed_2_0, map_out_passed_0 : boolean;
  signal map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_rows_read_words_0 : unsigned(13 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 16383;
  signal map_rows_write_words_0 : natural range 0 to 7711;
  -- other
  signal other_0 : natural range 0 to 30;
  signal other_1, other_2 : unsigned(48 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal map_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(13 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(2 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 5);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 5);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 14);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 14, address_bits => 5)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 16);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 16);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 8);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 8, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_group_is_equal_3, raster_place_group_choice_2, raster_place_next_frame_choice : boolean;
    variable raster_place_next_frame_choice_2, raster_place_next_frame_choice_3 : boolean;
    variable raster_place_next_frame_choice_4, slice0winner1_of_pair_0_0_is_less : boolean;
    variable slice0winner1_of_four_0_0_is_less, slice1winner1_of_pair_0_0_is_less : boolean;
    variable slice1winner1_of_four_0_0_is_less, slice1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_0_0_is_less, slice2_best_tag_row_start_is_equal : boolean;
    variable slice2_best_tag_row_start_choice, slice2_best_tag_row_start_choice_2 : boolean;
    variable slice2_best_tag_row_start_is_equal_2, slice2_best_tag_row_start_all : boolean;
    variable slice2_best_tag_row_start_choice_3, slice2_best_tag_row_start_all_2, map_counter_group_is_equal : boolean;
    variable map_line_ended_choice, map_at_arrives_value, map_of_column_0_b_below_a_value : boolean;
    variable map_of_column_0_b_below_a_choice, map_of_column_0_b_below_a_value_2 : boolean;
    variable map_of_column_0_b_below_a_choice_2, map_of_column_0_b_below_a_choice_3 : boolean;
    variable map_of_column_0_b_below_a_choice_4, map_of_column_0_b_below_a_value_3 : boolean;
    variable map_of_column_0_b_below_a_value_4, map_of_column_0_b_below_a_choice_5 : boolean;
    variable map_of_column_0_c_below_a_value, map_of_column_0_c_below_a_choice : boolean;
    variable map_of_column_0_c_below_a_value_2, map_of_column_0_c_below_a_choice_2 : boolean;
    variable map_of_column_0_c_below_a_choice_3, map_of_column_0_c_below_a_choice_4 : boolean;
    variable map_of_column_0_c_below_a_choice_5, map_of_column_0_c_below_a_choice_6 : boolean;
    variable map_of_column_0_c_below_a_choice_7, map_of_column_0_c_below_b_choice : boolean;
    variable map_of_column_0_c_below_b_choice_2, map_window_complete_is_equal, map_of_low_0_b_below_a_value : boolean;
    variable map_of_low_0_b_below_a_choice, map_of_low_0_b_below_a_is_equal, map_of_low_0_b_below_a_choice_2 : boolean;
    variable map_of_low_0_b_below_a_value_2, map_of_low_0_b_below_a_value_3, map_of_low_0_b_below_a_choice_3 : boolean;
    variable map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice, map_of_low_0_c_below_a_choice_2 : boolean;
    variable map_of_low_0_c_below_a_choice_3, map_of_low_0_c_below_b_choice, map_of_low_0_c_below_b_choice_2 : boolean;
    variable map_of_low_0_c_below_b_choice_3, map_of_middle_0_b_below_a_value : boolean;
    variable map_of_middle_0_b_below_a_choice, map_of_middle_0_b_below_a_is_equal : boolean;
    variable map_of_middle_0_b_below_a_choice_2, map_of_middle_0_b_below_a_value_2 : boolean;
    variable map_of_middle_0_b_below_a_value_3, map_of_middle_0_b_below_a_choice_3 : boolean;
    variable map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice : boolean;
    variable map_of_middle_0_c_below_a_choice_2, map_of_middle_0_c_below_a_choice_3 : boolean;
    variable map_of_middle_0_c_below_b_choice, map_of_middle_0_c_below_b_choice_2 : boolean;
    variable map_of_middle_0_c_below_b_choice_3, map_of_high_0_b_below_a_value : boolean;
    variable map_of_high_0_b_below_a_choice, map_of_high_0_b_below_a_is_equal : boolean;
    variable map_of_high_0_b_below_a_choice_2, map_of_high_0_b_below_a_value_2 : boolean;
    variable map_of_high_0_b_below_a_value_3, map_of_high_0_b_below_a_choice_3, map_of_high_0_c_below_a_value : boolean;
    variable map_of_high_0_c_below_a_choice, map_of_high_0_c_below_a_choice_2 : boolean;
    variable map_of_high_0_c_below_a_choice_3, map_of_high_0_c_below_b_choice : boolean;
    variable map_of_high_0_c_below_b_choice_2, map_of_high_0_c_below_b_choice_3, map_of_all_0_b_below_a_value : boolean;
    variable map_of_all_0_b_below_a_choice, map_of_all_0_b_below_a_is_equal, map_of_all_0_b_below_a_choice_2 : boolean;
    variable map_of_all_0_b_below_a_value_2, map_of_all_0_b_below_a_value_3, map_of_all_0_b_below_a_choice_3 : boolean;
    variable map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice, map_of_all_0_c_below_a_choice_2 : boolean;
    variable map_of_all_0_c_below_a_choice_3, map_of_all_0_c_below_b_choice, map_of_all_0_c_below_b_choice_2 : boolean;
    variable map_of_all_0_c_below_b_choice_3, map_low_1_0_all, map_low_0_0_all : boolean;
    variable raster_place_group_choice, map_counter_group_choice : natural range 0 to 3;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable map_counter_group_choice_2, map_counter_group_choice_3, map_sorted_low_0_choice : natural range 0 to 15;
    variable map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 15;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice, map_sorted_high_0_choice_2 : natural range 0 to 15;
    variable map_largest_low_0_choice, map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 15;
    variable map_median_middle_0_choice_2, map_median_middle_0_choice_3 : natural range 0 to 15;
    variable map_median_middle_0_choice_4, map_smallest_high_0_choice : natural range 0 to 15;
    variable map_smallest_high_0_choice_2, map_out_disparity_0_choice : natural range 0 to 15;
    variable map_out_disparity_0_choice_2, map_out_disparity_0_choice_3 : natural range 0 to 15;
    variable map_out_disparity_0_choice_4, map_low_0_0_choice, map_middle_0_0_choice : natural range 0 to 15;
    variable map_high_0_0_choice : natural range 0 to 15;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_is_equal_2 := raster_place_group = 11;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := (raster_place_group / 2) = 6;
      if raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := raster_place_group_is_equal and in_valid and (not ((raster_place_group mod 2) =
          1));
      else
        raster_place_group_choice_2 := raster_place_group_is_equal and in_valid;
      end if;
      if raster_place_next_frame and (raster_place_group = 12) then
        raster_place_group_choice_3 := 1;
      else
        raster_place_group_choice_3 := (raster_place_group + 1) mod 16;
      end if;
      if raster_place_group_choice_2 then
        raster_place_group_choice_4 := raster_place_group_choice_3;
      else
        raster_place_group_choice_4 := raster_place_group;
      end if;
      if raster_place_group_is_equal then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if raster_place_group_all then
        raster_place_next_frame_choice_3 := in_valid;
      else
        raster_place_next_frame_choice_3 := in_valid and (not in_start_of_frame);
      end if;
      if raster_place_next_frame_choice_2 then
        raster_place_next_frame_choice_4 := raster_place_next_frame_choice_3;
      else
        raster_place_next_frame_choice_4 := raster_place_group_is_equal and raster_place_group_is_equal_2 and in_valid
          and in_start_of_frame;
      end if;
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_4 or ((not in_valid) and raster_place_next_frame);
      if in_valid and in_start_of_frame then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choice_4;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 7 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 8;
        end if;
      end if;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside_1 <= (raster_place_group >= 1) and (raster_place_group < 13);
      delay_row_inside_2 <= (not ((raster_place_group / 8) = 1)) or (not (((raster_place_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= (raster_place_column >= 7) and (raster_place_column < 31);
      delay_tag_start_of_frame <= (raster_place_column = 7) and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      if (raster_place_column mod 4) = 3 then
        delay_tag_border_column <= (raster_place_column / 4) = 0;
      else
        delay_tag_border_column <= (raster_place_column / 8) = 0;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0 mod 256;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 256;
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_0 / 256;
        rows_reference_1 <= rows_reference_rows_ready_words_0 / 256;
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_inside_2 then
        rows_search_2 <= rows_search_rows_ready_newest_0;
        rows_reference_2 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_2 <= 0;
        rows_reference_2 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_newest_0 * 256) + (rows_search_rows_ready_words_0 /
          256);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_newest_0 * 256) +
          (rows_reference_rows_ready_words_0 / 256);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= rows_search_1;
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= rows_search_2;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= folded(slice0cost_difference_2_0) + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= folded(slice0cost_difference_2_1) + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= folded(slice0cost_difference_2_2) + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_single_0_0 <= (folded(slice0cost_difference_0_0) + as_number((slice0cost_difference_0_0 < 0))) mod 256;
      slice0cost_single_0_1 <= (folded(slice0cost_difference_0_1) + as_number((slice0cost_difference_0_1 < 0))) mod 256;
      slice0cost_single_0_2 <= (folded(slice0cost_difference_0_2) + as_number((slice0cost_difference_0_2 < 0))) mod 256;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      if slice0cost_pair_tag_border_column then
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
      else
        slice0cost_column_0_0 <= as_number(slice0cost_negative_0_0) + slice0cost_pair_0_0 + slice0cost_single_0_0;
        slice0cost_column_0_1 <= as_number(slice0cost_negative_0_1) + slice0cost_pair_0_1 + slice0cost_single_0_1;
        slice0cost_column_0_2 <= as_number(slice0cost_negative_0_2) + slice0cost_pair_0_2 + slice0cost_single_0_2;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
      end if;
      slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0winner1
      slice0winner1_of_pair_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_of_four_0_0_is_less := (slice0winner1_of_pair_0_2 -
        to_integer(((to_unsigned(slice0winner1_of_pair_0_0, 12)) or (to_unsigned(slice0winner1_of_pair_0_1, 12))))) < 0;
      slice0winner1_of_pair_0_2 <= slice0window_sum_0_2;
      slice0winner1_pair_index_0_0 <= slice0winner1_of_pair_0_0_is_less;
      slice0winner1_pair_index_0_1 <= 2;
      slice0winner1_pair_tag_valid <= slice0window_tag_valid;
      slice0winner1_four_tag_valid <= slice0winner1_pair_tag_valid;
      slice0winner1_four_tag_map_column <= slice0winner1_pair_tag_map_column;
      slice0winner1_four_tag_start_of_frame <= slice0winner1_pair_tag_start_of_frame;
      slice0winner1_four_tag_end_of_line <= slice0winner1_pair_tag_end_of_line;
      slice0winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice0winner1_of_four_0_1, 12)) or
        (to_unsigned(slice0winner1_of_four_0_2, 12)))) or (to_unsigned(slice0winner1_of_four_0_0, 12))));
      slice0winner1_best_index_0_0 <= slice0winner1_four_index_0_0;
      slice0winner1_tag_valid <= slice0winner1_four_tag_valid;
      slice0winner1_tag_map_column <= slice0winner1_four_tag_map_column;
      slice0winner1_tag_start_of_frame <= slice0winner1_four_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0winner1_four_tag_end_of_line;
      if slice0winner1_of_pair_0_0_is_less then
        slice0winner1_of_pair_0_0 <= 0;
        slice0winner1_of_pair_0_1 <= slice0window_sum_0_1;
      else
        slice0winner1_of_pair_0_0 <= slice0window_sum_0_0;
        slice0winner1_of_pair_0_1 <= 0;
      end if;
      if slice0winner1_of_four_0_0_is_less then
        slice0winner1_of_four_0_0 <= 0;
        slice0winner1_of_four_0_1 <= 0;
        slice0winner1_of_four_0_2 <= slice0winner1_of_pair_0_2;
        slice0winner1_four_index_0_0 <= slice0winner1_pair_index_0_1;
      else
        slice0winner1_of_four_0_0 <= slice0winner1_of_pair_0_0;
        slice0winner1_of_four_0_1 <= slice0winner1_of_pair_0_1;
        slice0winner1_of_four_0_2 <= 0;
        slice0winner1_four_index_0_0 <= as_number(slice0winner1_pair_index_0_0);
      end if;
      if slice0winner1_pair_tag_valid then
        slice0winner1_pair_tag_map_column <= slice0window_tag_map_column;
        slice0winner1_pair_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_pair_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner1_best_index_0_0 + 5;
      slice0_best_tag_valid <= slice0winner1_tag_valid;
      slice0_best_tag_map_column <= slice0winner1_tag_map_column;
      slice0_best_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner1_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice0shift_search_out_1;
        slice1shift_search_2_0 <= slice1shift_search_2_1;
        slice1shift_search_2_1 <= slice1shift_search_2_2;
        slice1shift_search_2_2 <= slice0shift_search_out_2;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      slice1shift_search_out_2 <= slice1shift_search_2_0;
      -- slice1cost
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_difference_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_difference_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_pair_0_0 <= folded(slice1cost_difference_2_0) + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= folded(slice1cost_difference_2_1) + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= folded(slice1cost_difference_2_2) + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_negative_0_0 <= slice1cost_difference_2_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_2_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_2_2 < 0;
      slice1cost_single_0_0 <= (folded(slice1cost_difference_0_0) + as_number((slice1cost_difference_0_0 < 0))) mod 256;
      slice1cost_single_0_1 <= (folded(slice1cost_difference_0_1) + as_number((slice1cost_difference_0_1 < 0))) mod 256;
      slice1cost_single_0_2 <= (folded(slice1cost_difference_0_2) + as_number((slice1cost_difference_0_2 < 0))) mod 256;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
      else
        slice1cost_column_0_0 <= as_number(slice1cost_negative_0_0) + slice1cost_pair_0_0 + slice1cost_single_0_0;
        slice1cost_column_0_1 <= as_number(slice1cost_negative_0_1) + slice1cost_pair_0_1 + slice1cost_single_0_1;
        slice1cost_column_0_2 <= as_number(slice1cost_negative_0_2) + slice1cost_pair_0_2 + slice1cost_single_0_2;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_1_0 <= slice1cost_column_0_0 + slice1window_partial_0_0_0;
        slice1window_partial_0_1_1 <= slice1cost_column_0_1 + slice1window_partial_0_0_1;
        slice1window_partial_0_1_2 <= slice1cost_column_0_2 + slice1window_partial_0_0_2;
      end if;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      -- slice1winner1
      slice1winner1_of_pair_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_of_four_0_0_is_less := (slice1winner1_of_pair_0_2 -
        to_integer(((to_unsigned(slice1winner1_of_pair_0_0, 12)) or (to_unsigned(slice1winner1_of_pair_0_1, 12))))) < 0;
      slice1winner1_of_pair_0_2 <= slice1window_sum_0_2;
      slice1winner1_pair_index_0_0 <= slice1winner1_of_pair_0_0_is_less;
      slice1winner1_best_cost_0_0 <= to_integer(((((to_unsigned(slice1winner1_of_four_0_1, 12)) or
        (to_unsigned(slice1winner1_of_four_0_2, 12)))) or (to_unsigned(slice1winner1_of_four_0_0, 12))));
      slice1winner1_best_index_0_0 <= slice1winner1_four_index_0_0;
      if slice1winner1_of_pair_0_0_is_less then
        slice1winner1_of_pair_0_0 <= 0;
        slice1winner1_of_pair_0_1 <= slice1window_sum_0_1;
      else
        slice1winner1_of_pair_0_0 <= slice1window_sum_0_0;
        slice1winner1_of_pair_0_1 <= 0;
      end if;
      if slice1winner1_of_four_0_0_is_less then
        slice1winner1_of_four_0_0 <= 0;
        slice1winner1_of_four_0_1 <= 0;
        slice1winner1_of_four_0_2 <= slice1winner1_of_pair_0_2;
        slice1winner1_four_index_0_0 <= slice0winner1_pair_index_0_1;
      else
        slice1winner1_of_four_0_0 <= slice1winner1_of_pair_0_0;
        slice1winner1_of_four_0_1 <= slice1winner1_of_pair_0_1;
        slice1winner1_of_four_0_2 <= 0;
        slice1winner1_four_index_0_0 <= as_number(slice1winner1_pair_index_0_0);
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner1_best_cost_0_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1_best_index_0_0 <= (((slice1winner1_best_index_0_0 / 2) + 1) * 2) + (slice1winner1_best_index_0_0 mod 2);
      end if;
      -- slice2shift
      if slice0cost_difference_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice1shift_search_out_0;
        slice2shift_search_1_0 <= slice2shift_search_1_1;
        slice2shift_search_1_1 <= slice1shift_search_out_1;
        slice2shift_search_2_0 <= slice2shift_search_2_1;
        slice2shift_search_2_1 <= slice1shift_search_out_2;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      -- slice2cost
      slice2cost_difference_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_difference_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_difference_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_difference_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_difference_2_0 <= slice2shift_search_2_0 - slice2shift_reference_2;
      slice2cost_difference_2_1 <= slice2shift_search_2_1 - slice2shift_reference_2;
      slice2cost_pair_0_0 <= as_number((slice2cost_difference_1_0 < 0)) + folded(slice2cost_difference_1_0) +
        folded(slice2cost_difference_2_0);
      slice2cost_pair_0_1 <= as_number((slice2cost_difference_1_1 < 0)) + folded(slice2cost_difference_1_1) +
        folded(slice2cost_difference_2_1);
      slice2cost_negative_0_0 <= slice2cost_difference_2_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_2_1 < 0;
      slice2cost_single_0_0 <= (folded(slice2cost_difference_0_0) + as_number((slice2cost_difference_0_0 < 0))) mod 256;
      slice2cost_single_0_1 <= (folded(slice2cost_difference_0_1) + as_number((slice2cost_difference_0_1 < 0))) mod 256;
      if slice1cost_tag_border_column then
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
      else
        slice2cost_column_0_0 <= as_number(slice2cost_negative_0_0) + slice2cost_pair_0_0 + slice2cost_single_0_0;
        slice2cost_column_0_1 <= as_number(slice2cost_negative_0_1) + slice2cost_pair_0_1 + slice2cost_single_0_1;
      end if;
      -- slice2window
      if slice0winner1_pair_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      -- slice2winner1
      slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0_1 - slice2window_sum_0_0) < 0;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      if slice2winner1_best_cost_0_0_is_less then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      -- slice2winner2
      slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
      slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_0;
      -- slice2winner3
      slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
      slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
      -- slice2
      slice2_best_tag_row_start_is_equal := map_counter_column = 23;
      if (map_counter_group / 2) = 6 then
        slice2_best_tag_row_start_choice := slice2_best_tag_row_start and ((map_counter_group mod 2) = 1);
      else
        slice2_best_tag_row_start_choice := slice2_best_tag_row_start;
      end if;
      if slice2_best_tag_row_start_is_equal then
        slice2_best_tag_row_start_choice_2 := slice2_best_tag_row_start_choice;
      else
        slice2_best_tag_row_start_choice_2 := slice2_best_tag_row_start;
      end if;
      slice2_best_tag_row_start_is_equal_2 := map_counter_group = 11;
      slice2_best_tag_row_start_all := slice2_best_tag_row_start_is_equal and slice2_best_tag_row_start_is_equal_2;
      if slice2_best_tag_row_start_choice_2 then
        slice2_best_tag_row_start_choice_3 := slice2_best_tag_row_start_all or (not slice2_best_tag_start_of_frame);
      else
        slice2_best_tag_row_start_choice_3 := slice2_best_tag_row_start_is_equal and
          slice2_best_tag_row_start_is_equal_2 and slice2_best_tag_start_of_frame;
      end if;
      slice2_best_tag_row_start_all_2 := slice2_best_tag_valid and slice2_best_tag_map_column;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_map_column <= slice1_best_tag_map_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if (slice1_best_cost_0_0 - slice2winner3_best_cost_0_0) < 0 then
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_index_0_0 <= as_number(slice2winner3_best_index_0_0);
      end if;
      if slice2_best_tag_row_start_choice_3 then
        slice2_best_tag_row_start <= slice2_best_tag_row_start or slice2_best_tag_row_start_all_2;
      else
        slice2_best_tag_row_start <= slice2_best_tag_row_start and ((not slice2_best_tag_valid) or (not
          slice2_best_tag_map_column));
      end if;
      -- map
      if slice2_best_tag_row_start_all_2 then
        if slice2_best_tag_row_start_is_equal or slice2_best_tag_start_of_frame then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 32;
        end if;
      end if;
      if slice2_best_tag_row_start_all then
        map_counter_group_choice := 3;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 12;
      if slice2_best_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 16;
      end if;
      if (map_counter_group /= 13) and slice2_best_tag_row_start_is_equal and slice2_best_tag_valid and
        slice2_best_tag_map_column then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if slice2_best_tag_valid then
        map_line_ended_choice := slice2_best_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_1(16 downto 16)) = 1;
      map_of_column_0_b_below_a_value := ((map_column_1 / 4) mod 2) = 1;
      if map_at_top then
        map_of_column_0_b_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_b_below_a_choice := ((other_0 / 4) mod 2) = 1;
      end if;
      map_of_column_0_b_below_a_value_2 := ((map_column_1 / 2) mod 2) = 1;
      if map_at_top then
        map_of_column_0_b_below_a_choice_2 := map_of_column_0_b_below_a_value_2;
      else
        map_of_column_0_b_below_a_choice_2 := ((other_0 / 2) mod 2) = 1;
      end if;
      if map_of_column_0_b_below_a_choice_2 then
        map_of_column_0_b_below_a_choice_3 := (not map_of_column_0_b_below_a_value) or (not
          map_of_column_0_b_below_a_value_2);
      else
        map_of_column_0_b_below_a_choice_3 := not map_of_column_0_b_below_a_value;
      end if;
      if map_of_column_0_b_below_a_choice then
        map_of_column_0_b_below_a_choice_4 := map_of_column_0_b_below_a_choice_3;
      else
        map_of_column_0_b_below_a_choice_4 := map_of_column_0_b_below_a_choice_2 and (((map_column_1 / 2) mod 4) = 0);
      end if;
      map_of_column_0_b_below_a_value_3 := ((map_column_1 / 8) mod 2) = 1;
      map_of_column_0_b_below_a_value_4 := ((other_0 / 8) mod 2) = 1;
      if map_of_column_0_b_below_a_choice_4 then
        map_of_column_0_b_below_a_choice_5 := map_of_column_0_b_below_a_value_3 and (not
          map_of_column_0_b_below_a_value_4) and (not map_at_top);
      else
        map_of_column_0_b_below_a_choice_5 := map_of_column_0_b_below_a_value_3 or (not
          map_of_column_0_b_below_a_value_4) or map_at_top;
      end if;
      map_of_column_0_c_below_a_value := ((map_column_2 / 4) mod 2) = 1;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_c_below_a_choice := map_of_column_0_c_below_a_value;
      end if;
      map_of_column_0_c_below_a_value_2 := ((map_column_2 / 2) mod 2) = 1;
      if map_of_column_0_c_below_a_value_2 then
        map_of_column_0_c_below_a_choice_2 := (not map_of_column_0_b_below_a_value_2) and map_counter_next_frame;
      else
        map_of_column_0_c_below_a_choice_2 := (not map_of_column_0_b_below_a_value_2) or (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_a_choice then
        map_of_column_0_c_below_a_choice_3 := map_of_column_0_b_below_a_choice_2 and map_of_column_0_c_below_a_choice_2
          and map_of_column_0_b_below_a_choice;
      else
        map_of_column_0_c_below_a_choice_3 := (map_of_column_0_b_below_a_choice_2 and
          map_of_column_0_c_below_a_choice_2) or map_of_column_0_b_below_a_choice;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice_4 := map_of_column_0_b_below_a_value_3;
      else
        map_of_column_0_c_below_a_choice_4 := (map_column_2 / 8) = 1;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_5 := map_of_column_0_b_below_a_value_3;
      else
        map_of_column_0_c_below_a_choice_5 := map_of_column_0_b_below_a_value_4;
      end if;
      if map_of_column_0_c_below_a_choice_3 then
        map_of_column_0_c_below_a_choice_6 := (not map_of_column_0_c_below_a_choice_4) or
          map_of_column_0_c_below_a_choice_5;
      else
        map_of_column_0_c_below_a_choice_6 := (not map_of_column_0_c_below_a_choice_4) and
          map_of_column_0_c_below_a_choice_5;
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choice_7 := (map_column_1 / 16) = 1;
      else
        map_of_column_0_c_below_a_choice_7 := (other_0 / 16) = 1;
      end if;
      if (not map_of_column_0_c_below_a_value_2) and map_of_column_0_b_below_a_value_2 and (not map_counter_next_frame)
        then
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value and (not map_of_column_0_b_below_a_value)
          and (not map_counter_next_frame);
      else
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value or (not map_of_column_0_b_below_a_value) or
          map_counter_next_frame;
      end if;
      if map_of_column_0_c_below_b_choice then
        map_of_column_0_c_below_b_choice_2 := ((map_column_2 / 8) = 1) or (not map_of_column_0_b_below_a_value_3) or
          map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choice_2 := ((map_column_2 / 8) = 1) and (not map_of_column_0_b_below_a_value_3) and
          (not map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_low_0_choice := map_of_column_0_c;
      else
        map_sorted_low_0_choice := map_of_column_0_b;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_low_0_choice_2 := map_of_column_0_c;
      else
        map_sorted_low_0_choice_2 := map_of_column_0_a;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_middle_0_choice := map_of_column_0_b;
      else
        map_sorted_middle_0_choice := map_sorted_low_0_choice_2;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_middle_0_choice_2 := map_of_column_0_a;
      else
        map_sorted_middle_0_choice_2 := map_sorted_low_0_choice;
      end if;
      if map_of_column_0_c_below_a then
        map_sorted_high_0_choice := map_of_column_0_a;
      else
        map_sorted_high_0_choice := map_of_column_0_c;
      end if;
      if map_of_column_0_c_below_b then
        map_sorted_high_0_choice_2 := map_of_column_0_b;
      else
        map_sorted_high_0_choice_2 := map_of_column_0_c;
      end if;
      map_window_complete_is_equal := map_sorted_column = 0;
      map_of_low_0_b_below_a_value := ((map_low_0_0 / 2) mod 2) = 1;
      if (map_low_0_0 mod 2) = 1 then
        map_of_low_0_b_below_a_choice := (not (((map_low_1_0 / 2) mod 2) = 1)) or (not ((map_low_1_0 mod 2) = 1));
      else
        map_of_low_0_b_below_a_choice := not (((map_low_1_0 / 2) mod 2) = 1);
      end if;
      map_of_low_0_b_below_a_is_equal := (map_low_1_0 mod 4) = 0;
      if map_of_low_0_b_below_a_value then
        map_of_low_0_b_below_a_choice_2 := map_of_low_0_b_below_a_choice;
      else
        map_of_low_0_b_below_a_choice_2 := ((map_low_0_0 mod 2) = 1) and map_of_low_0_b_below_a_is_equal;
      end if;
      map_of_low_0_b_below_a_value_2 := ((map_low_0_0 / 4) mod 2) = 1;
      map_of_low_0_b_below_a_value_3 := ((map_low_1_0 / 4) mod 2) = 1;
      if map_of_low_0_b_below_a_choice_2 then
        map_of_low_0_b_below_a_choice_3 := (not map_of_low_0_b_below_a_value_2) and map_of_low_0_b_below_a_value_3;
      else
        map_of_low_0_b_below_a_choice_3 := (not map_of_low_0_b_below_a_value_2) or map_of_low_0_b_below_a_value_3;
      end if;
      map_of_low_0_c_below_a_value := ((map_low_2_0 / 2) mod 2) = 1;
      if (map_low_2_0 mod 2) = 1 then
        map_of_low_0_c_below_a_choice := not map_of_low_0_b_below_a_value;
      else
        map_of_low_0_c_below_a_choice := (map_low_0_0 mod 4) = 0;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_a_choice_2 := ((map_low_2_0 mod 2) = 1) or (not map_of_low_0_b_below_a_value) or (not
          ((map_low_0_0 mod 2) = 1));
      else
        map_of_low_0_c_below_a_choice_2 := map_of_low_0_c_below_a_choice;
      end if;
      if map_of_low_0_c_below_a_choice_2 then
        map_of_low_0_c_below_a_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) and map_of_low_0_b_below_a_value_2;
      else
        map_of_low_0_c_below_a_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) or map_of_low_0_b_below_a_value_2;
      end if;
      if (map_low_2_0 mod 2) = 1 then
        map_of_low_0_c_below_b_choice := not (((map_low_1_0 / 2) mod 2) = 1);
      else
        map_of_low_0_c_below_b_choice := map_of_low_0_b_below_a_is_equal;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_b_choice_2 := ((map_low_2_0 mod 2) = 1) or (not (((map_low_1_0 / 2) mod 2) = 1)) or (not
          ((map_low_1_0 mod 2) = 1));
      else
        map_of_low_0_c_below_b_choice_2 := map_of_low_0_c_below_b_choice;
      end if;
      if map_of_low_0_c_below_b_choice_2 then
        map_of_low_0_c_below_b_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) and map_of_low_0_b_below_a_value_3;
      else
        map_of_low_0_c_below_b_choice_3 := (not (((map_low_2_0 / 4) mod 2) = 1)) or map_of_low_0_b_below_a_value_3;
      end if;
      map_of_middle_0_b_below_a_value := ((map_middle_0_0 / 2) mod 2) = 1;
      if (map_middle_0_0 mod 2) = 1 then
        map_of_middle_0_b_below_a_choice := (not (((map_middle_1_0 / 2) mod 2) = 1)) or (not ((map_middle_1_0 mod 2) =
          1));
      else
        map_of_middle_0_b_below_a_choice := not (((map_middle_1_0 / 2) mod 2) = 1);
      end if;
      map_of_middle_0_b_below_a_is_equal := (map_middle_1_0 mod 4) = 0;
      if map_of_middle_0_b_below_a_value then
        map_of_middle_0_b_below_a_choice_2 := map_of_middle_0_b_below_a_choice;
      else
        map_of_middle_0_b_below_a_choice_2 := ((map_middle_0_0 mod 2) = 1) and map_of_middle_0_b_below_a_is_equal;
      end if;
      map_of_middle_0_b_below_a_value_2 := ((map_middle_0_0 / 4) mod 2) = 1;
      map_of_middle_0_b_below_a_value_3 := ((map_middle_1_0 / 4) mod 2) = 1;
      if map_of_middle_0_b_below_a_choice_2 then
        map_of_middle_0_b_below_a_choice_3 := (not map_of_middle_0_b_below_a_value_2) and
          map_of_middle_0_b_below_a_value_3;
      else
        map_of_middle_0_b_below_a_choice_3 := (not map_of_middle_0_b_below_a_value_2) or
          map_of_middle_0_b_below_a_value_3;
      end if;
      map_of_middle_0_c_below_a_value := ((map_middle_2_0 / 2) mod 2) = 1;
      if (map_middle_2_0 mod 2) = 1 then
        map_of_middle_0_c_below_a_choice := not map_of_middle_0_b_below_a_value;
      else
        map_of_middle_0_c_below_a_choice := (map_middle_0_0 mod 4) = 0;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_a_choice_2 := ((map_middle_2_0 mod 2) = 1) or (not map_of_middle_0_b_below_a_value) or
          (not ((map_middle_0_0 mod 2) = 1));
      else
        map_of_middle_0_c_below_a_choice_2 := map_of_middle_0_c_below_a_choice;
      end if;
      if map_of_middle_0_c_below_a_choice_2 then
        map_of_middle_0_c_below_a_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_2;
      else
        map_of_middle_0_c_below_a_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_2;
      end if;
      if (map_middle_2_0 mod 2) = 1 then
        map_of_middle_0_c_below_b_choice := not (((map_middle_1_0 / 2) mod 2) = 1);
      else
        map_of_middle_0_c_below_b_choice := map_of_middle_0_b_below_a_is_equal;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_b_choice_2 := ((map_middle_2_0 mod 2) = 1) or (not (((map_middle_1_0 / 2) mod 2) = 1))
          or (not ((map_middle_1_0 mod 2) = 1));
      else
        map_of_middle_0_c_below_b_choice_2 := map_of_middle_0_c_below_b_choice;
      end if;
      if map_of_middle_0_c_below_b_choice_2 then
        map_of_middle_0_c_below_b_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) and
          map_of_middle_0_b_below_a_value_3;
      else
        map_of_middle_0_c_below_b_choice_3 := (not (((map_middle_2_0 / 4) mod 2) = 1)) or
          map_of_middle_0_b_below_a_value_3;
      end if;
      map_of_high_0_b_below_a_value := ((map_high_0_0 / 2) mod 2) = 1;
      if (map_high_0_0 mod 2) = 1 then
        map_of_high_0_b_below_a_choice := (not (((map_high_1_0 / 2) mod 2) = 1)) or (not ((map_high_1_0 mod 2) = 1));
      else
        map_of_high_0_b_below_a_choice := not (((map_high_1_0 / 2) mod 2) = 1);
      end if;
      map_of_high_0_b_below_a_is_equal := (map_high_1_0 mod 4) = 0;
      if map_of_high_0_b_below_a_value then
        map_of_high_0_b_below_a_choice_2 := map_of_high_0_b_below_a_choice;
      else
        map_of_high_0_b_below_a_choice_2 := ((map_high_0_0 mod 2) = 1) and map_of_high_0_b_below_a_is_equal;
      end if;
      map_of_high_0_b_below_a_value_2 := ((map_high_0_0 / 4) mod 2) = 1;
      map_of_high_0_b_below_a_value_3 := ((map_high_1_0 / 4) mod 2) = 1;
      if map_of_high_0_b_below_a_choice_2 then
        map_of_high_0_b_below_a_choice_3 := (not map_of_high_0_b_below_a_value_2) and map_of_high_0_b_below_a_value_3;
      else
        map_of_high_0_b_below_a_choice_3 := (not map_of_high_0_b_below_a_value_2) or map_of_high_0_b_below_a_value_3;
      end if;
      map_of_high_0_c_below_a_value := ((map_high_2_0 / 2) mod 2) = 1;
      if (map_high_2_0 mod 2) = 1 then
        map_of_high_0_c_below_a_choice := not map_of_high_0_b_below_a_value;
      else
        map_of_high_0_c_below_a_choice := (map_high_0_0 mod 4) = 0;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_a_choice_2 := ((map_high_2_0 mod 2) = 1) or (not map_of_high_0_b_below_a_value) or (not
          ((map_high_0_0 mod 2) = 1));
      else
        map_of_high_0_c_below_a_choice_2 := map_of_high_0_c_below_a_choice;
      end if;
      if map_of_high_0_c_below_a_choice_2 then
        map_of_high_0_c_below_a_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) and map_of_high_0_b_below_a_value_2;
      else
        map_of_high_0_c_below_a_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) or map_of_high_0_b_below_a_value_2;
      end if;
      if (map_high_2_0 mod 2) = 1 then
        map_of_high_0_c_below_b_choice := not (((map_high_1_0 / 2) mod 2) = 1);
      else
        map_of_high_0_c_below_b_choice := map_of_high_0_b_below_a_is_equal;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_b_choice_2 := ((map_high_2_0 mod 2) = 1) or (not (((map_high_1_0 / 2) mod 2) = 1)) or
          (not ((map_high_1_0 mod 2) = 1));
      else
        map_of_high_0_c_below_b_choice_2 := map_of_high_0_c_below_b_choice;
      end if;
      if map_of_high_0_c_below_b_choice_2 then
        map_of_high_0_c_below_b_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) and map_of_high_0_b_below_a_value_3;
      else
        map_of_high_0_c_below_b_choice_3 := (not (((map_high_2_0 / 4) mod 2) = 1)) or map_of_high_0_b_below_a_value_3;
      end if;
      if map_of_low_0_c_below_a then
        map_largest_low_0_choice := map_of_low_0_a;
      else
        map_largest_low_0_choice := map_of_low_0_c;
      end if;
      if map_of_low_0_c_below_b then
        map_largest_low_0_choice_2 := map_of_low_0_b;
      else
        map_largest_low_0_choice_2 := map_of_low_0_c;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice := map_of_middle_0_c;
      else
        map_median_middle_0_choice := map_of_middle_0_a;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choice_2 := map_of_middle_0_b;
      else
        map_median_middle_0_choice_2 := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choice_3 := map_of_middle_0_c;
      else
        map_median_middle_0_choice_3 := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choice_4 := map_of_middle_0_a;
      else
        map_median_middle_0_choice_4 := map_median_middle_0_choice_3;
      end if;
      if map_of_high_0_c_below_b then
        map_smallest_high_0_choice := map_of_high_0_c;
      else
        map_smallest_high_0_choice := map_of_high_0_b;
      end if;
      if map_of_high_0_c_below_a then
        map_smallest_high_0_choice_2 := map_of_high_0_c;
      else
        map_smallest_high_0_choice_2 := map_of_high_0_a;
      end if;
      map_of_all_0_b_below_a_value := ((map_largest_low_0 / 2) mod 2) = 1;
      if (map_largest_low_0 mod 2) = 1 then
        map_of_all_0_b_below_a_choice := (not (((map_median_middle_0 / 2) mod 2) = 1)) or (not ((map_median_middle_0
          mod 2) = 1));
      else
        map_of_all_0_b_below_a_choice := not (((map_median_middle_0 / 2) mod 2) = 1);
      end if;
      map_of_all_0_b_below_a_is_equal := (map_median_middle_0 mod 4) = 0;
      if map_of_all_0_b_below_a_value then
        map_of_all_0_b_below_a_choice_2 := map_of_all_0_b_below_a_choice;
      else
        map_of_all_0_b_below_a_choice_2 := ((map_largest_low_0 mod 2) = 1) and map_of_all_0_b_below_a_is_equal;
      end if;
      map_of_all_0_b_below_a_value_2 := ((map_largest_low_0 / 4) mod 2) = 1;
      map_of_all_0_b_below_a_value_3 := ((map_median_middle_0 / 4) mod 2) = 1;
      if map_of_all_0_b_below_a_choice_2 then
        map_of_all_0_b_below_a_choice_3 := (not map_of_all_0_b_below_a_value_2) and map_of_all_0_b_below_a_value_3;
      else
        map_of_all_0_b_below_a_choice_3 := (not map_of_all_0_b_below_a_value_2) or map_of_all_0_b_below_a_value_3;
      end if;
      map_of_all_0_c_below_a_value := ((map_smallest_high_0 / 2) mod 2) = 1;
      if (map_smallest_high_0 mod 2) = 1 then
        map_of_all_0_c_below_a_choice := not map_of_all_0_b_below_a_value;
      else
        map_of_all_0_c_below_a_choice := (map_largest_low_0 mod 4) = 0;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_a_choice_2 := ((map_smallest_high_0 mod 2) = 1) or (not map_of_all_0_b_below_a_value) or
          (not ((map_largest_low_0 mod 2) = 1));
      else
        map_of_all_0_c_below_a_choice_2 := map_of_all_0_c_below_a_choice;
      end if;
      if map_of_all_0_c_below_a_choice_2 then
        map_of_all_0_c_below_a_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_2;
      else
        map_of_all_0_c_below_a_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_2;
      end if;
      if (map_smallest_high_0 mod 2) = 1 then
        map_of_all_0_c_below_b_choice := not (((map_median_middle_0 / 2) mod 2) = 1);
      else
        map_of_all_0_c_below_b_choice := map_of_all_0_b_below_a_is_equal;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_b_choice_2 := ((map_smallest_high_0 mod 2) = 1) or (not (((map_median_middle_0 / 2) mod 2)
          = 1)) or (not ((map_median_middle_0 mod 2) = 1));
      else
        map_of_all_0_c_below_b_choice_2 := map_of_all_0_c_below_b_choice;
      end if;
      if map_of_all_0_c_below_b_choice_2 then
        map_of_all_0_c_below_b_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) and
          map_of_all_0_b_below_a_value_3;
      else
        map_of_all_0_c_below_b_choice_3 := (not (((map_smallest_high_0 / 4) mod 2) = 1)) or
          map_of_all_0_b_below_a_value_3;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice := map_of_all_0_c;
      else
        map_out_disparity_0_choice := map_of_all_0_a;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choice_2 := map_of_all_0_b;
      else
        map_out_disparity_0_choice_2 := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choice_3 := map_of_all_0_c;
      else
        map_out_disparity_0_choice_3 := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice_4 := map_of_all_0_a;
      else
        map_out_disparity_0_choice_4 := map_out_disparity_0_choice_3;
      end if;
      map_counter_next_frame <= to_integer(other_1(40 downto 40)) = 1;
      map_newest_0 <= (slice2_best_index_0_0 * 2) + 1;
      map_arrives <= slice2_best_tag_row_start_all_2;
      map_behind <= map_line_ended and slice2_best_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_1(4 downto 0));
      map_column_1 <= map_rows_ready_words_0 / 512;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_1(24 downto 24)) = 1;
      map_at_top <= to_integer(other_1(32 downto 32)) = 1;
      map_at_output <= to_integer(other_1(48 downto 48)) = 1;
      map_of_column_0_b <= map_column_1 / 2;
      map_of_column_0_c_below_b <= (not map_of_column_0_c_below_b_choice_2) or (((map_column_1 / 16) = 1) and (not
        map_counter_next_frame));
      map_column_passed_0_0 <= (map_column_1 mod 2) = 1;
      map_column_passed_1_0 <= map_column_passed_0_0;
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
      map_window_first <= map_sorted_top and map_sorted_arrives and (map_sorted_column = 1);
      map_window_last <= map_sorted_behind;
      map_of_low_0_a <= map_low_0_0;
      map_of_low_0_b <= map_low_1_0;
      map_of_low_0_c <= map_low_2_0;
      map_of_middle_0_a <= map_middle_0_0;
      map_of_middle_0_b <= map_middle_1_0;
      map_of_middle_0_c <= map_middle_2_0;
      map_of_high_0_a <= map_high_0_0;
      map_of_high_0_b <= map_high_1_0;
      map_of_high_0_c <= map_high_2_0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_waiting_0_complete <= map_window_complete;
      map_waiting_0_first <= map_window_first;
      map_waiting_0_last <= map_window_last;
      map_waiting_1_complete <= map_waiting_0_complete;
      map_waiting_1_first <= map_waiting_0_first;
      map_waiting_1_last <= map_waiting_0_last;
      map_waiting_2_complete <= map_waiting_1_complete;
      map_waiting_2_first <= map_waiting_1_first;
      map_waiting_2_last <= map_waiting_1_last;
      map_waiting_passed_0_0 <= map_passed_1_0;
      map_waiting_passed_1_0 <= map_waiting_passed_0_0;
      map_waiting_passed_2_0 <= map_waiting_passed_1_0;
      map_out_passed_0 <= map_waiting_passed_2_0;
      map_out_valid <= map_waiting_2_complete;
      map_out_start_of_frame <= map_waiting_2_first and map_waiting_2_complete;
      map_out_end_of_line <= map_waiting_2_last and map_waiting_2_complete;
      if slice2_best_tag_start_of_frame and slice2_best_tag_valid and slice2_best_tag_map_column then
        map_counter_group <= map_counter_group_choice * 4;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if slice2_best_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not slice2_best_tag_valid);
      end if;
      if map_at_top then
        map_of_column_0_a <= map_column_1 / 2;
      else
        map_of_column_0_a <= other_0 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c <= map_column_1 / 2;
      else
        map_of_column_0_c <= map_column_2 / 2;
      end if;
      if map_of_column_0_b_below_a_choice_5 then
        map_of_column_0_b_below_a <= (not ((map_column_1 / 16) = 1)) and ((other_0 / 16) = 1) and (not map_at_top);
      else
        map_of_column_0_b_below_a <= (not ((map_column_1 / 16) = 1)) or ((other_0 / 16) = 1) or map_at_top;
      end if;
      if map_of_column_0_c_below_a_choice_6 then
        map_of_column_0_c_below_a <= (not (map_counter_next_frame and ((map_column_1 / 16) = 1))) or
          map_of_column_0_c_below_a_choice_7;
      else
        map_of_column_0_c_below_a <= (not (map_counter_next_frame and ((map_column_1 / 16) = 1))) and
          map_of_column_0_c_below_a_choice_7;
      end if;
      if map_of_column_0_b_below_a then
        map_sorted_low_0 <= map_sorted_low_0_choice;
        map_sorted_middle_0 <= map_sorted_middle_0_choice;
        map_sorted_high_0 <= map_sorted_high_0_choice;
      else
        map_sorted_low_0 <= map_sorted_low_0_choice_2;
        map_sorted_middle_0 <= map_sorted_middle_0_choice_2;
        map_sorted_high_0 <= map_sorted_high_0_choice_2;
      end if;
      if map_passed_0_0 then
        map_passed_1_0 <= map_passed_1_0 or map_sorted_arrives or map_sorted_behind;
      else
        map_passed_1_0 <= map_passed_1_0 and (not map_sorted_arrives) and (not map_sorted_behind);
      end if;
      if map_window_complete_is_equal then
        map_window_complete <= map_sorted_output and map_sorted_behind;
      else
        map_window_complete <= map_sorted_output and (map_sorted_arrives or map_sorted_behind);
      end if;
      if map_of_low_0_b_below_a_choice_3 then
        map_of_low_0_b_below_a <= ((map_low_0_0 / 8) = 1) and (not ((map_low_1_0 / 8) = 1));
      else
        map_of_low_0_b_below_a <= ((map_low_0_0 / 8) = 1) or (not ((map_low_1_0 / 8) = 1));
      end if;
      if map_of_low_0_c_below_a_choice_3 then
        map_of_low_0_c_below_a <= (not ((map_low_2_0 / 8) = 1)) or ((map_low_0_0 / 8) = 1);
      else
        map_of_low_0_c_below_a <= (not ((map_low_2_0 / 8) = 1)) and ((map_low_0_0 / 8) = 1);
      end if;
      if map_of_low_0_c_below_b_choice_3 then
        map_of_low_0_c_below_b <= (not ((map_low_2_0 / 8) = 1)) or ((map_low_1_0 / 8) = 1);
      else
        map_of_low_0_c_below_b <= (not ((map_low_2_0 / 8) = 1)) and ((map_low_1_0 / 8) = 1);
      end if;
      if map_of_middle_0_b_below_a_choice_3 then
        map_of_middle_0_b_below_a <= ((map_middle_0_0 / 8) = 1) and (not ((map_middle_1_0 / 8) = 1));
      else
        map_of_middle_0_b_below_a <= ((map_middle_0_0 / 8) = 1) or (not ((map_middle_1_0 / 8) = 1));
      end if;
      if map_of_middle_0_c_below_a_choice_3 then
        map_of_middle_0_c_below_a <= (not ((map_middle_2_0 / 8) = 1)) or ((map_middle_0_0 / 8) = 1);
      else
        map_of_middle_0_c_below_a <= (not ((map_middle_2_0 / 8) = 1)) and ((map_middle_0_0 / 8) = 1);
      end if;
      if map_of_middle_0_c_below_b_choice_3 then
        map_of_middle_0_c_below_b <= (not ((map_middle_2_0 / 8) = 1)) or ((map_middle_1_0 / 8) = 1);
      else
        map_of_middle_0_c_below_b <= (not ((map_middle_2_0 / 8) = 1)) and ((map_middle_1_0 / 8) = 1);
      end if;
      if map_of_high_0_b_below_a_choice_3 then
        map_of_high_0_b_below_a <= ((map_high_0_0 / 8) = 1) and (not ((map_high_1_0 / 8) = 1));
      else
        map_of_high_0_b_below_a <= ((map_high_0_0 / 8) = 1) or (not ((map_high_1_0 / 8) = 1));
      end if;
      if map_of_high_0_c_below_a_choice_3 then
        map_of_high_0_c_below_a <= (not ((map_high_2_0 / 8) = 1)) or ((map_high_0_0 / 8) = 1);
      else
        map_of_high_0_c_below_a <= (not ((map_high_2_0 / 8) = 1)) and ((map_high_0_0 / 8) = 1);
      end if;
      if map_of_high_0_c_below_b_choice_3 then
        map_of_high_0_c_below_b <= (not ((map_high_2_0 / 8) = 1)) or ((map_high_1_0 / 8) = 1);
      else
        map_of_high_0_c_below_b <= (not ((map_high_2_0 / 8) = 1)) and ((map_high_1_0 / 8) = 1);
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choice_2;
      else
        map_median_middle_0 <= map_median_middle_0_choice_4;
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_all_0_b_below_a_choice_3 then
        map_of_all_0_b_below_a <= ((map_largest_low_0 / 8) = 1) and (not ((map_median_middle_0 / 8) = 1));
      else
        map_of_all_0_b_below_a <= ((map_largest_low_0 / 8) = 1) or (not ((map_median_middle_0 / 8) = 1));
      end if;
      if map_of_all_0_c_below_a_choice_3 then
        map_of_all_0_c_below_a <= (not ((map_smallest_high_0 / 8) = 1)) or ((map_largest_low_0 / 8) = 1);
      else
        map_of_all_0_c_below_a <= (not ((map_smallest_high_0 / 8) = 1)) and ((map_largest_low_0 / 8) = 1);
      end if;
      if map_of_all_0_c_below_b_choice_3 then
        map_of_all_0_c_below_b <= (not ((map_smallest_high_0 / 8) = 1)) or ((map_median_middle_0 / 8) = 1);
      else
        map_of_all_0_c_below_b <= (not ((map_smallest_high_0 / 8) = 1)) and ((map_median_middle_0 / 8) = 1);
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choice_2;
      else
        map_out_disparity_0 <= map_out_disparity_0_choice_4;
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
        map_at_column <= to_integer(other_1(4 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0_0;
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_1_0_all := map_sorted_arrives and map_window_complete_is_equal;
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0_0;
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0_0;
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      map_low_0_0_all := (not map_sorted_arrives) and (not map_sorted_behind);
      if not map_low_0_0_all then
        map_low_0_0 <= map_low_0_0_choice;
        map_low_2_0 <= map_low_1_0;
        map_middle_0_0 <= map_middle_0_0_choice;
        map_middle_2_0 <= map_middle_1_0;
        map_high_0_0 <= map_high_0_0_choice;
        map_high_2_0 <= map_high_1_0;
        if map_low_1_0_all then
          map_low_1_0 <= map_low_0_0_choice;
          map_middle_1_0 <= map_middle_0_0_choice;
          map_high_1_0 <= map_high_0_0_choice;
        else
          map_low_1_0 <= map_low_0_0;
          map_middle_1_0 <= map_middle_0_0;
          map_high_1_0 <= map_high_0_0;
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0_0 <= map_column_passed_1_0;
      end if;
      -- other
      other_0 <= (((map_rows_ready_words_0 mod 512) / 2) mod 16) * 2;
      other_1 <= other_2;
      other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 13))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 13;
        raster_place_next_frame <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_map_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_map_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_pair_tag_valid <= false;
        slice0winner1_pair_tag_map_column <= false;
        slice0winner1_pair_tag_start_of_frame <= false;
        slice0winner1_pair_tag_end_of_line <= false;
        slice0winner1_four_tag_valid <= false;
        slice0winner1_four_tag_map_column <= false;
        slice0winner1_four_tag_start_of_frame <= false;
        slice0winner1_four_tag_end_of_line <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_row_start <= false;
        slice2_best_tag_map_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 13;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
        map_at_column <= 0;
        map_at_arrives <= false;
        map_at_behind <= false;
        map_at_top <= false;
        map_at_output <= false;
        map_comparing_column <= 0;
        map_comparing_arrives <= false;
        map_comparing_behind <= false;
        map_comparing_top <= false;
        map_comparing_output <= false;
        map_sorted_column <= 0;
        map_sorted_arrives <= false;
        map_sorted_behind <= false;
        map_sorted_top <= false;
        map_sorted_output <= false;
        map_window_complete <= false;
        map_window_first <= false;
        map_window_last <= false;
        map_waiting_0_complete <= false;
        map_waiting_0_first <= false;
        map_waiting_0_last <= false;
        map_waiting_1_complete <= false;
        map_waiting_1_first <= false;
        map_waiting_1_last <= false;
        map_waiting_2_complete <= false;
        map_waiting_2_first <= false;
        map_waiting_2_last <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_1 <= to_unsigned(0, 49);
        other_2 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
