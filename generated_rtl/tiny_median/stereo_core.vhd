-- SPDX-License-Identifier: Apache-2.0
-- Stereo block-matching core, configuration tiny_median: 32x12, 8 disparities, 3x3 window, 1 pixel pairs a clock.
-- Options: right reference, sad cost, direct sums, median.
-- Made from hls/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_median
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core is
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in bits 7 ... 0
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(7 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
end entity;

architecture rtl of stereo_core is
  function magnitude(value : integer) return natural is
  begin
    if value < 0 then
      return -value;
    end if;
    return value;
  end function;

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
  signal raster_search_0, raster_reference_0 : natural range 0 to 255;
  signal raster_valid, raster_next_frame : boolean;
  signal raster_column : natural range 0 to 31;
  signal raster_group : natural range 0 to 15;
  -- delay
  signal delay_read_address, delay_write_address : natural range 0 to 7;
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
  signal slice0cost_reverse_0_0, slice0cost_reverse_0_1, slice0cost_reverse_0_2 : natural range 0 to 255;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_reverse_1_0, slice0cost_reverse_1_1, slice0cost_reverse_1_2 : boolean;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_map_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_pair_1_0, slice0cost_negative_0_0 : boolean;
  signal slice0cost_negative_0_1, slice0cost_negative_0_2, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_map_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 511;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_centre_0_map_column, slice0window_centre_0_start_of_frame : boolean;
  signal slice0window_centre_0_end_of_line, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  -- slice0winner1
  signal slice0winner1_cost_0_0, slice0winner1_cost_0_1 : natural range 0 to 2301;
  signal slice0winner1_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_index_0_1 : natural range 0 to 2;
  -- slice0winner2
  signal slice0winner2_cost_0_0 : natural range 0 to 2301;
  signal slice0winner2_index_0_0 : natural range 0 to 2;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0best
  signal slice0best_cost_0_0 : natural range 0 to 2301;
  signal slice0best_index_0_0 : natural range 0 to 7;
  signal slice0best_tag_valid, slice0best_tag_map_column, slice0best_tag_start_of_frame : boolean;
  signal slice0best_tag_end_of_line : boolean;
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
  signal slice1cost_reverse_0_0, slice1cost_reverse_0_1, slice1cost_reverse_0_2 : natural range 0 to 255;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2 : boolean;
  signal slice1cost_tag_border_column : boolean;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 767;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 767;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 1534;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2301;
  -- slice1winner1
  signal slice1winner1_cost_0_0, slice1winner1_cost_0_1 : natural range 0 to 2301;
  signal slice1winner1_index_0_0 : boolean;
  -- slice1winner2
  signal slice1winner2_cost_0_0 : natural range 0 to 2301;
  signal slice1winner2_index_0_0 : natural range 0 to 2;
  -- slice1best
  signal slice1best_cost_0_0 : natural range 0 to 2301;
  signal slice1best_index_0_0 : natural range 0 to 7;
  signal slice1best_tag_valid, slice1best_tag_map_column, slice1best_tag_start_of_frame : boolean;
  signal slice1best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_1_0 : natural range 0 to 255;
  signal slice2shift_search_1_1, slice2shift_search_2_0, slice2shift_search_2_1 : natural range 0 to 255;
  signal slice2shift_reference_0, slice2shift_reference_1, slice2shift_reference_2 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -255 to 255;
  signal slice2cost_difference_1_1, slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -255 to 255;
  signal slice2cost_reverse_0_0, slice2cost_reverse_0_1, slice2cost_single_0_0 : natural range 0 to 255;
  signal slice2cost_single_0_1 : natural range 0 to 255;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 511;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1 : boolean;
  signal slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 767;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1 : natural range 0 to 767;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1 : natural range 0 to 1534;
  signal slice2window_sum_0_0, slice2window_sum_0_1 : natural range 0 to 2301;
  -- slice2winner1
  signal slice2winner1_cost_0_0 : natural range 0 to 2301;
  signal slice2winner1_index_0_0 : boolean;
  -- slice2winner2
  signal slice2winner2_cost_0_0 : natural range 0 to 2301;
  signal slice2winner2_index_0_0 : boolean;
  -- slice2best
  signal slice2best_index_0_0 : natural range 0 to 7;
  signal slice2best_tag_valid, slice2best_tag_map_column, slice2best_tag_start_of_frame : boolean;
  signal slice2best_tag_end_of_line : boolean;
  -- median
  signal median_counter_column, median_read_column, median_ready_column, median_write_column : natural range 0 to 31;
  signal median_column_1, median_at_column : natural range 0 to 31;
  signal median_counter_group, median_newest_0, median_rows_read_newest_0 : natural range 0 to 15;
  signal median_rows_ready_newest_0, median_column_2 : natural range 0 to 15;
  signal median_arrives, median_behind, median_line_ended, median_read_arrives, median_read_behind : boolean;
  signal median_read_top, median_read_output, median_ready_arrives, median_ready_behind, median_ready_top : boolean;
  signal median_ready_output, median_at_arrives, median_at_behind, median_at_top, median_at_output : boolean;
  signal median_passed_0_0, median_passed_1_0, median_complete, median_first, median_last : boolean;
  signal median_waiting_passed_0, median_waiting_valid, median_waiting_start_of_frame : boolean;
  signal median_waiting_end_of_line, median_out_passed_0, median_out_valid, median_out_start_of_frame : boolean;
  signal median_out_end_of_line : boolean;
  signal median_rows_read_words_0 : unsigned(13 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 16383;
  signal median_rows_write_words_0 : natural range 0 to 7711;
  signal median_column_0_value : natural range 0 to 510;
  signal median_low_0_0, median_low_1_0, median_low_2_0, median_middle_0_0, median_middle_1_0 : natural range 0 to 255;
  signal median_middle_2_0, median_high_0_0, median_high_1_0, median_high_2_0 : natural range 0 to 255;
  signal median_largest_low_0, median_median_middle_0, median_smallest_high_0 : natural range 0 to 255;
  signal median_out_disparity_0 : natural range 0 to 255;
  signal median_rows_read_words_0_memory_write_data : unsigned(13 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(15 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(left_pixel));
  in_right_pixel <= to_integer(unsigned(right_pixel));
  disparity <= std_logic_vector(to_unsigned(median_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

  median_rows_read_words_0_memory_write_data <= to_unsigned(median_rows_write_words_0, 14);
  median_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 14)
    port map (
      clock => clock, read_enable => true,
      read_address => median_counter_column, read_data => median_rows_read_words_0,
      write_address => median_at_column, write_data => median_rows_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 16);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 16)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_search_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 16);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 16)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_reference_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_write_data <= to_unsigned(raster_reference_0, 8);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 8)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_read_address, read_data => delay_delayed_0,
      write_address => delay_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_group_is_equal, raster_group_is_equal_2, raster_group_all, raster_group_is_equal_3 : boolean;
    variable raster_group_choice_2, raster_next_frame_is_equal, raster_next_frame_choice : boolean;
    variable raster_next_frame_choice_2, raster_next_frame_is_equal_2, raster_next_frame_all : boolean;
    variable raster_next_frame_choice_3, raster_next_frame_all_2, slice0cost_reverse_1_1_is_equal : boolean;
    variable slice0cost_reverse_1_0_choice, slice0cost_reverse_1_0_choice_2, slice0winner1_cost_0_0_is_less : boolean;
    variable slice0winner2_cost_0_0_is_less, slice1winner1_cost_0_0_is_less, slice1winner2_cost_0_0_is_less : boolean;
    variable slice1best_cost_0_0_is_less, slice2winner1_cost_0_0_is_less, median_line_ended_choice : boolean;
    variable median_passed_1_0_all, median_passed_1_0_any, median_complete_is_equal : boolean;
    variable median_median_middle_0_is_less, median_out_disparity_0_is_less, median_low_0_0_is_less : boolean;
    variable median_low_1_0_all, median_middle_0_0_is_less : boolean;
    variable raster_group_choice, median_counter_group_choice : natural range 0 to 3;
    variable raster_group_choice_3, raster_group_choice_4, median_counter_group_choice_2 : natural range 0 to 15;
    variable median_counter_group_choice_3, median_low_0_0_choice : natural range 0 to 15;
    variable slice0cost_pair_0_0_choice, slice0cost_pair_0_1_choice : natural range 0 to 255;
    variable slice0cost_pair_0_2_choice, slice1cost_pair_0_0_choice : natural range 0 to 255;
    variable slice1cost_pair_0_1_choice, slice1cost_pair_0_2_choice : natural range 0 to 255;
    variable slice2cost_pair_0_0_choice, slice2cost_pair_0_1_choice : natural range 0 to 255;
    variable median_largest_low_0_choice, median_median_middle_0_choice : natural range 0 to 255;
    variable median_median_middle_0_choice_2, median_median_middle_0_choice_3 : natural range 0 to 255;
    variable median_smallest_high_0_choice, median_out_disparity_0_choice : natural range 0 to 255;
    variable median_out_disparity_0_choice_2, median_out_disparity_0_choice_3 : natural range 0 to 255;
    variable median_low_0_0_choice_2, median_low_0_0_choice_3, median_low_0_0_choice_4 : natural range 0 to 255;
    variable median_low_0_0_choice_5, median_middle_0_0_choice, median_middle_0_0_choice_2 : natural range 0 to 255;
    variable median_middle_0_0_choice_3, median_middle_0_0_choice_4, median_high_0_0_choice : natural range 0 to 255;
    variable median_high_0_0_choice_2 : natural range 0 to 255;
  begin
    if rising_edge(clock) then
      -- raster
      raster_group_is_equal := raster_column = 31;
      raster_group_is_equal_2 := raster_group = 11;
      raster_group_all := raster_group_is_equal and raster_group_is_equal_2;
      raster_group_choice := 3 when raster_group_all else 0;
      raster_group_is_equal_3 := (raster_group / 2) = 6;
      raster_group_choice_2 := raster_group_is_equal and in_valid and (not ((raster_group mod 2) = 1)) when
        raster_group_is_equal_3 else raster_group_is_equal and in_valid;
      raster_group_choice_3 := 1 when slice0cost_reverse_1_0 and (raster_group = 12) else (raster_group + 1) mod 16;
      raster_group_choice_4 := raster_group_choice_3 when raster_group_choice_2 else raster_group;
      raster_next_frame_is_equal := median_counter_column = 23;
      raster_next_frame_choice := (median_counter_group /= 12) and raster_next_frame when raster_next_frame_is_equal
        else raster_next_frame;
      raster_next_frame_choice_2 := raster_next_frame when median_counter_group = 13 else raster_next_frame_choice;
      raster_next_frame_is_equal_2 := median_counter_group = 11;
      raster_next_frame_all := raster_next_frame_is_equal and raster_next_frame_is_equal_2;
      raster_next_frame_choice_3 := raster_next_frame_all or (not slice2best_tag_start_of_frame) when
        raster_next_frame_choice_2 else raster_next_frame_is_equal and raster_next_frame_is_equal_2 and
        slice2best_tag_start_of_frame;
      raster_next_frame_all_2 := slice2best_tag_valid and slice2best_tag_map_column;
      raster_search_0 <= in_left_pixel;
      raster_reference_0 <= in_right_pixel;
      raster_valid <= in_valid;
      raster_group <= raster_group_choice * 4 when in_start_of_frame and in_valid else raster_group_choice_4;
      raster_next_frame <= raster_next_frame or raster_next_frame_all_2 when raster_next_frame_choice_3 else
        raster_next_frame and ((not slice2best_tag_valid) or (not slice2best_tag_map_column));
      if in_valid then
        raster_column <= 0 when raster_group_is_equal or in_start_of_frame else (raster_column + 1) mod 32;
      end if;
      -- delay
      if raster_valid then
        delay_read_address <= 0 when delay_read_address = 7 else (delay_read_address + 1) mod 8;
        delay_write_address <= delay_read_address;
      end if;
      delay_ahead_0 <= raster_search_0;
      delay_column <= raster_column;
      delay_row_inside_0 <= (((((raster_group / 2) + 32767) mod 32768) * 2) + (raster_group mod 2)) < 12;
      delay_row_inside_1 <= ((raster_group + 65535) mod 65536) < 12;
      delay_row_inside_2 <= (not ((raster_group / 8) = 1)) or (not (((raster_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_valid;
      delay_tag_border_column <= (raster_column / 4) = 0 when (raster_column mod 4) = 3 else (raster_column / 8) = 0;
      delay_tag_map_column <= ((raster_column + 65529) mod 65536) < 24;
      delay_tag_start_of_frame <= (raster_column = 7) and (raster_group = 1);
      delay_tag_end_of_line <= raster_column = 30;
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
      rows_search_0 <= rows_search_rows_ready_words_0 mod 256 when rows_ready_inside_0 else 0;
      rows_search_1 <= rows_search_rows_ready_words_0 / 256 when rows_ready_inside_1 else 0;
      rows_search_2 <= rows_search_rows_ready_newest_0 when rows_ready_inside_2 else 0;
      rows_reference_0 <= rows_reference_rows_ready_words_0 mod 256 when rows_ready_inside_0 else 0;
      rows_reference_1 <= rows_reference_rows_ready_words_0 / 256 when rows_ready_inside_1 else 0;
      rows_reference_2 <= rows_reference_rows_ready_newest_0 when rows_ready_inside_2 else 0;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
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
      slice0cost_reverse_1_1_is_equal := median_counter_group = 12;
      slice0cost_pair_0_0_choice := slice0cost_reverse_0_0 when slice0cost_difference_2_0 < 0 else
        positive_part(slice0cost_difference_2_0);
      slice0cost_pair_0_1_choice := slice0cost_reverse_0_1 when slice0cost_difference_2_1 < 0 else
        positive_part(slice0cost_difference_2_1);
      slice0cost_pair_0_2_choice := slice0cost_reverse_0_2 when slice0cost_difference_2_2 < 0 else
        positive_part(slice0cost_difference_2_2);
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_reverse_0_0 <= (slice0shift_reference_2 - slice0shift_search_2_0) mod 256;
      slice0cost_reverse_0_1 <= (slice0shift_reference_2 - slice0shift_search_2_1) mod 256;
      slice0cost_reverse_0_2 <= (slice0shift_reference_2 - slice0shift_search_2_2) mod 256;
      slice0cost_reverse_1_1 <= slice0cost_reverse_1_1_is_equal;
      slice0cost_reverse_1_2 <= slice0cost_reverse_1_1;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pair_0_0_choice + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= slice0cost_pair_0_1_choice + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= slice0cost_pair_0_2_choice + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_pair_1_0 <= slice0cost_reverse_1_2;
      slice0cost_single_0_0 <= folded(slice0cost_difference_0_0);
      slice0cost_single_0_1 <= folded(slice0cost_difference_0_1);
      slice0cost_single_0_2 <= folded(slice0cost_difference_0_2);
      slice0cost_negative_0_0 <= slice0cost_difference_0_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_0_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_0_2 < 0;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_0) +
        slice0cost_pair_0_0 + slice0cost_single_0_0;
      slice0cost_column_0_1 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_1) +
        slice0cost_pair_0_1 + slice0cost_single_0_1;
      slice0cost_column_0_2 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_2) +
        slice0cost_pair_0_2 + slice0cost_single_0_2;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      slice0cost_reverse_1_0_choice := slice0cost_reverse_1_0 and ((raster_group mod 2) = 1) when raster_group_is_equal
        else slice0cost_reverse_1_0;
      slice0cost_reverse_1_0_choice_2 := slice0cost_reverse_1_0_choice when raster_group_is_equal_3 else
        slice0cost_reverse_1_0;
      if in_valid then
        slice0cost_reverse_1_0 <= raster_group_all or (not in_start_of_frame) when slice0cost_reverse_1_0_choice_2 else
          raster_group_is_equal and raster_group_is_equal_2 and in_start_of_frame;
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
      slice0window_centre_0_map_column <= slice0cost_tag_map_column;
      slice0window_centre_0_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_centre_0_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_0_map_column;
      slice0window_tag_start_of_frame <= slice0window_centre_0_start_of_frame;
      slice0window_tag_end_of_line <= slice0window_centre_0_end_of_line;
      -- slice0winner1
      slice0winner1_cost_0_0_is_less := slice0window_sum_0_1 < slice0window_sum_0_0;
      slice0winner1_cost_0_0 <= slice0window_sum_0_1 when slice0winner1_cost_0_0_is_less else slice0window_sum_0_0;
      slice0winner1_cost_0_1 <= slice0window_sum_0_2;
      slice0winner1_index_0_0 <= slice0winner1_cost_0_0_is_less;
      slice0winner1_index_0_1 <= 2;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice0window_tag_map_column;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0winner2
      slice0winner2_cost_0_0_is_less := slice0winner1_cost_0_1 < slice0winner1_cost_0_0;
      slice0winner2_cost_0_0 <= slice0winner1_cost_0_1 when slice0winner2_cost_0_0_is_less else slice0winner1_cost_0_0;
      slice0winner2_index_0_0 <= slice0winner1_index_0_1 when slice0winner2_cost_0_0_is_less else
        as_number(slice0winner1_index_0_0);
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      -- slice0best
      slice0best_cost_0_0 <= slice0winner2_cost_0_0;
      slice0best_index_0_0 <= slice0winner2_index_0_0 + 5;
      slice0best_tag_valid <= slice0winner2_tag_valid;
      slice0best_tag_map_column <= slice0winner2_tag_map_column;
      slice0best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0best_tag_end_of_line <= slice0winner2_tag_end_of_line;
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
      slice1cost_pair_0_0_choice := slice1cost_reverse_0_0 when slice1cost_difference_2_0 < 0 else
        positive_part(slice1cost_difference_2_0);
      slice1cost_pair_0_1_choice := slice1cost_reverse_0_1 when slice1cost_difference_2_1 < 0 else
        positive_part(slice1cost_difference_2_1);
      slice1cost_pair_0_2_choice := slice1cost_reverse_0_2 when slice1cost_difference_2_2 < 0 else
        positive_part(slice1cost_difference_2_2);
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_difference_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_difference_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_reverse_0_0 <= (slice1shift_reference_2 - slice1shift_search_2_0) mod 256;
      slice1cost_reverse_0_1 <= (slice1shift_reference_2 - slice1shift_search_2_1) mod 256;
      slice1cost_reverse_0_2 <= (slice1shift_reference_2 - slice1shift_search_2_2) mod 256;
      slice1cost_pair_0_0 <= slice1cost_pair_0_0_choice + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= slice1cost_pair_0_1_choice + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= slice1cost_pair_0_2_choice + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_single_0_0 <= folded(slice1cost_difference_0_0);
      slice1cost_single_0_1 <= folded(slice1cost_difference_0_1);
      slice1cost_single_0_2 <= folded(slice1cost_difference_0_2);
      slice1cost_negative_0_0 <= slice1cost_difference_0_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_0_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_0_2 < 0;
      slice1cost_column_0_0 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_0) +
        slice1cost_pair_0_0 + slice1cost_single_0_0;
      slice1cost_column_0_1 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_1) +
        slice1cost_pair_0_1 + slice1cost_single_0_1;
      slice1cost_column_0_2 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_2) +
        slice1cost_pair_0_2 + slice1cost_single_0_2;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
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
      slice1winner1_cost_0_0_is_less := slice1window_sum_0_1 < slice1window_sum_0_0;
      slice1winner1_cost_0_0 <= slice1window_sum_0_1 when slice1winner1_cost_0_0_is_less else slice1window_sum_0_0;
      slice1winner1_cost_0_1 <= slice1window_sum_0_2;
      slice1winner1_index_0_0 <= slice1winner1_cost_0_0_is_less;
      -- slice1winner2
      slice1winner2_cost_0_0_is_less := slice1winner1_cost_0_1 < slice1winner1_cost_0_0;
      slice1winner2_cost_0_0 <= slice1winner1_cost_0_1 when slice1winner2_cost_0_0_is_less else slice1winner1_cost_0_0;
      slice1winner2_index_0_0 <= slice0winner1_index_0_1 when slice1winner2_cost_0_0_is_less else
        as_number(slice1winner1_index_0_0);
      -- slice1best
      slice1best_cost_0_0_is_less := slice0best_cost_0_0 < slice1winner2_cost_0_0;
      slice1best_cost_0_0 <= slice0best_cost_0_0 when slice1best_cost_0_0_is_less else slice1winner2_cost_0_0;
      slice1best_index_0_0 <= slice0best_index_0_0 when slice1best_cost_0_0_is_less else (((slice1winner2_index_0_0 /
        2) + 1) * 2) + (slice1winner2_index_0_0 mod 2);
      slice1best_tag_valid <= slice0best_tag_valid;
      slice1best_tag_map_column <= slice0best_tag_map_column;
      slice1best_tag_start_of_frame <= slice0best_tag_start_of_frame;
      slice1best_tag_end_of_line <= slice0best_tag_end_of_line;
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
      slice2cost_pair_0_0_choice := slice2cost_reverse_0_0 when slice2cost_difference_2_0 < 0 else
        positive_part(slice2cost_difference_2_0);
      slice2cost_pair_0_1_choice := slice2cost_reverse_0_1 when slice2cost_difference_2_1 < 0 else
        positive_part(slice2cost_difference_2_1);
      slice2cost_difference_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_difference_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_difference_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_difference_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_difference_2_0 <= slice2shift_search_2_0 - slice2shift_reference_2;
      slice2cost_difference_2_1 <= slice2shift_search_2_1 - slice2shift_reference_2;
      slice2cost_reverse_0_0 <= (slice2shift_reference_2 - slice2shift_search_2_0) mod 256;
      slice2cost_reverse_0_1 <= (slice2shift_reference_2 - slice2shift_search_2_1) mod 256;
      slice2cost_pair_0_0 <= slice2cost_pair_0_0_choice + folded(slice2cost_difference_1_0) +
        as_number((slice2cost_difference_1_0 < 0));
      slice2cost_pair_0_1 <= slice2cost_pair_0_1_choice + folded(slice2cost_difference_1_1) +
        as_number((slice2cost_difference_1_1 < 0));
      slice2cost_single_0_0 <= folded(slice2cost_difference_0_0);
      slice2cost_single_0_1 <= folded(slice2cost_difference_0_1);
      slice2cost_negative_0_0 <= slice2cost_difference_0_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_0_1 < 0;
      slice2cost_column_0_0 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_0_0) +
        slice2cost_pair_0_0 + slice2cost_single_0_0;
      slice2cost_column_0_1 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_0_1) +
        slice2cost_pair_0_1 + slice2cost_single_0_1;
      -- slice2window
      if slice0winner1_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      -- slice2winner1
      slice2winner1_cost_0_0_is_less := slice2window_sum_0_1 < slice2window_sum_0_0;
      slice2winner1_cost_0_0 <= slice2window_sum_0_1 when slice2winner1_cost_0_0_is_less else slice2window_sum_0_0;
      slice2winner1_index_0_0 <= slice2winner1_cost_0_0_is_less;
      -- slice2winner2
      slice2winner2_cost_0_0 <= slice2winner1_cost_0_0;
      slice2winner2_index_0_0 <= slice2winner1_index_0_0;
      -- slice2best
      slice2best_index_0_0 <= slice1best_index_0_0 when slice1best_cost_0_0 < slice2winner2_cost_0_0 else
        as_number(slice2winner2_index_0_0);
      slice2best_tag_valid <= slice1best_tag_valid;
      slice2best_tag_map_column <= slice1best_tag_map_column;
      slice2best_tag_start_of_frame <= slice1best_tag_start_of_frame;
      slice2best_tag_end_of_line <= slice1best_tag_end_of_line;
      -- median
      if raster_next_frame_all_2 then
        median_counter_column <= 0 when raster_next_frame_is_equal or slice2best_tag_start_of_frame else
          (median_counter_column + 1) mod 32;
      end if;
      median_counter_group_choice := 3 when raster_next_frame_all else 0;
      median_counter_group_choice_2 := 1 when slice0cost_reverse_1_1_is_equal and raster_next_frame else
        (median_counter_group + 1) mod 16;
      median_counter_group_choice_3 := median_counter_group_choice_2 when (median_counter_group /= 13) and
        raster_next_frame_is_equal and slice2best_tag_valid and slice2best_tag_map_column else median_counter_group;
      median_line_ended_choice := slice2best_tag_map_column when slice2best_tag_valid else median_line_ended;
      median_passed_1_0_all := (not median_at_arrives) and (not median_at_behind);
      median_passed_1_0_any := median_at_arrives or median_at_behind;
      median_complete_is_equal := median_write_column = 0;
      median_largest_low_0_choice := median_low_0_0 when median_low_1_0 < median_low_0_0 else median_low_1_0;
      median_median_middle_0_is_less := median_middle_1_0 < median_middle_0_0;
      median_median_middle_0_choice := median_middle_0_0 when median_median_middle_0_is_less else median_middle_1_0;
      median_median_middle_0_choice_2 := median_middle_2_0 when median_middle_2_0 < median_median_middle_0_choice else
        median_median_middle_0_choice;
      median_median_middle_0_choice_3 := median_middle_1_0 when median_median_middle_0_is_less else median_middle_0_0;
      median_smallest_high_0_choice := median_high_1_0 when median_high_1_0 < median_high_0_0 else median_high_0_0;
      median_out_disparity_0_is_less := median_median_middle_0 < median_largest_low_0;
      median_out_disparity_0_choice := median_largest_low_0 when median_out_disparity_0_is_less else
        median_median_middle_0;
      median_out_disparity_0_choice_2 := median_smallest_high_0 when median_smallest_high_0 <
        median_out_disparity_0_choice else median_out_disparity_0_choice;
      median_out_disparity_0_choice_3 := median_median_middle_0 when median_out_disparity_0_is_less else
        median_largest_low_0;
      median_counter_group <= median_counter_group_choice * 4 when slice2best_tag_start_of_frame and
        slice2best_tag_valid and slice2best_tag_map_column else median_counter_group_choice_3;
      median_newest_0 <= (slice2best_index_0_0 * 2) + 1;
      median_arrives <= raster_next_frame_all_2;
      median_behind <= median_line_ended and slice2best_tag_valid;
      median_line_ended <= median_line_ended_choice when slice2best_tag_end_of_line else median_line_ended and (not
        slice2best_tag_valid);
      median_rows_read_newest_0 <= median_newest_0;
      median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
      median_rows_ready_newest_0 <= median_rows_read_newest_0;
      median_read_column <= median_counter_column;
      median_read_arrives <= median_arrives;
      median_read_behind <= median_behind;
      median_read_top <= median_counter_group = 1;
      median_read_output <= ((median_counter_group + 65535) mod 65536) < 12;
      median_ready_column <= median_read_column;
      median_ready_arrives <= median_read_arrives;
      median_ready_behind <= median_read_behind;
      median_ready_top <= median_read_top;
      median_ready_output <= median_read_output;
      median_write_column <= median_ready_column;
      median_column_1 <= median_rows_ready_words_0 / 512;
      median_column_2 <= median_rows_ready_newest_0;
      median_column_0_value <= ((median_rows_ready_words_0 mod 512) / 2) * 2;
      median_at_arrives <= median_ready_arrives;
      median_at_behind <= median_ready_behind;
      median_at_top <= median_ready_top;
      median_at_output <= median_ready_output;
      median_passed_1_0 <= median_passed_0_0 or median_passed_1_0_all when median_passed_1_0 else median_passed_0_0 and
        median_passed_1_0_any;
      median_complete <= median_at_output and median_at_behind when median_complete_is_equal else median_at_output and
        median_passed_1_0_any;
      median_first <= median_at_arrives and median_at_top and (median_write_column = 1);
      median_last <= median_at_behind;
      median_largest_low_0 <= median_largest_low_0_choice when median_low_2_0 < median_largest_low_0_choice else
        median_low_2_0;
      median_median_middle_0 <= median_median_middle_0_choice_3 when median_median_middle_0_choice_2 <
        median_median_middle_0_choice_3 else median_median_middle_0_choice_2;
      median_smallest_high_0 <= median_high_2_0 when median_high_2_0 < median_smallest_high_0_choice else
        median_smallest_high_0_choice;
      median_waiting_passed_0 <= median_passed_1_0;
      median_waiting_valid <= median_complete;
      median_waiting_start_of_frame <= median_first and median_complete;
      median_waiting_end_of_line <= median_last and median_complete;
      median_out_disparity_0 <= median_out_disparity_0_choice_3 when median_out_disparity_0_choice_2 <
        median_out_disparity_0_choice_3 else median_out_disparity_0_choice_2;
      median_out_passed_0 <= median_waiting_passed_0;
      median_out_valid <= median_waiting_valid;
      median_out_start_of_frame <= median_waiting_start_of_frame;
      median_out_end_of_line <= median_waiting_end_of_line;
      if median_ready_arrives then
        median_rows_write_words_0 <= (median_rows_ready_words_0 / 512) + (median_rows_ready_newest_0 * 512);
        median_at_column <= median_ready_column;
      end if;
      if slice0cost_pair_1_0 then
        median_low_0_0_choice := median_column_1 / 2;
      else
        median_low_0_0_choice := median_column_2 / 2;
      end if;
      if median_at_top then
        median_low_0_0_choice_2 := median_column_1 / 2;
      else
        median_low_0_0_choice_2 := median_column_0_value / 2;
      end if;
      median_low_0_0_is_less := (median_column_1 / 2) < median_low_0_0_choice_2;
      if median_low_0_0_is_less then
        median_low_0_0_choice_3 := median_column_1 / 2;
      else
        median_low_0_0_choice_3 := median_low_0_0_choice_2;
      end if;
      if median_low_0_0_choice < median_low_0_0_choice_3 then
        median_low_0_0_choice_4 := median_low_0_0_choice;
      else
        median_low_0_0_choice_4 := median_low_0_0_choice_3;
      end if;
      median_low_0_0_choice_5 := median_low_0_0 when median_at_behind else median_low_0_0_choice_4;
      median_low_1_0_all := median_at_arrives and median_complete_is_equal;
      median_middle_0_0_choice := median_low_0_0_choice_2 when median_low_0_0_is_less else median_column_1 / 2;
      median_middle_0_0_is_less := median_low_0_0_choice < median_middle_0_0_choice;
      if median_middle_0_0_is_less then
        median_middle_0_0_choice_2 := median_low_0_0_choice;
      else
        median_middle_0_0_choice_2 := median_middle_0_0_choice;
      end if;
      median_middle_0_0_choice_3 := median_low_0_0_choice_3 when median_middle_0_0_choice_2 < median_low_0_0_choice_3
        else median_middle_0_0_choice_2;
      median_middle_0_0_choice_4 := median_middle_0_0 when median_at_behind else median_middle_0_0_choice_3;
      median_high_0_0_choice := median_middle_0_0_choice when median_middle_0_0_is_less else median_low_0_0_choice;
      median_high_0_0_choice_2 := median_high_0_0 when median_at_behind else median_high_0_0_choice;
      if not median_passed_1_0_all then
        median_low_0_0 <= median_low_0_0_choice_5;
        median_low_1_0 <= median_low_0_0_choice_5 when median_low_1_0_all else median_low_0_0;
        median_low_2_0 <= median_low_1_0;
        median_middle_0_0 <= median_middle_0_0_choice_4;
        median_middle_1_0 <= median_middle_0_0_choice_4 when median_low_1_0_all else median_middle_0_0;
        median_middle_2_0 <= median_middle_1_0;
        median_high_0_0 <= median_high_0_0_choice_2;
        median_high_1_0 <= median_high_0_0_choice_2 when median_low_1_0_all else median_high_0_0;
        median_high_2_0 <= median_high_1_0;
      end if;
      if median_at_arrives then
        median_passed_0_0 <= (median_column_1 mod 2) = 1;
      end if;
      if reset = '1' then
        raster_valid <= false;
        raster_column <= 0;
        raster_group <= 13;
        raster_next_frame <= false;
        delay_read_address <= 1;
        delay_write_address <= 0;
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
        slice0cost_reverse_1_0 <= false;
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
        slice0window_centre_0_map_column <= false;
        slice0window_centre_0_start_of_frame <= false;
        slice0window_centre_0_end_of_line <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0best_tag_valid <= false;
        slice0best_tag_map_column <= false;
        slice0best_tag_start_of_frame <= false;
        slice0best_tag_end_of_line <= false;
        slice1best_tag_valid <= false;
        slice1best_tag_map_column <= false;
        slice1best_tag_start_of_frame <= false;
        slice1best_tag_end_of_line <= false;
        slice2best_tag_valid <= false;
        slice2best_tag_map_column <= false;
        slice2best_tag_start_of_frame <= false;
        slice2best_tag_end_of_line <= false;
        median_counter_column <= 0;
        median_counter_group <= 13;
        median_arrives <= false;
        median_behind <= false;
        median_line_ended <= false;
        median_read_column <= 0;
        median_read_arrives <= false;
        median_read_behind <= false;
        median_read_top <= false;
        median_read_output <= false;
        median_ready_column <= 0;
        median_ready_arrives <= false;
        median_ready_behind <= false;
        median_ready_top <= false;
        median_ready_output <= false;
        median_write_column <= 0;
        median_at_column <= 0;
        median_at_arrives <= false;
        median_at_behind <= false;
        median_at_top <= false;
        median_at_output <= false;
        median_complete <= false;
        median_first <= false;
        median_last <= false;
        median_waiting_valid <= false;
        median_waiting_start_of_frame <= false;
        median_waiting_end_of_line <= false;
        median_out_valid <= false;
        median_out_start_of_frame <= false;
        median_out_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
