-- SPDX-License-Identifier: Apache-2.0
-- Stereo block-matching core, configuration tiny_all_p4: 32x12, 8 disparities, 3x3 window, 4 pixel pairs a clock.
-- Options: right reference, sad cost, direct sums, prefilter xsobel with cap 31, left/right check, threshold
--   1, uniqueness check, percent 10, texture check, threshold 30, subpixel, median.
-- Made from hls/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_all_p4
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core is
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(31 downto 0);  -- 8 bits a row, the upper row in bits 7 ... 0
    right_pixel : in std_logic_vector(31 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(63 downto 0);
    pixel_valid : out std_logic_vector(3 downto 0);  -- a bit a row: the disparity has passed every check
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

  signal in_valid : boolean;
  signal in_start_of_frame : boolean;
  signal in_right_pixel : unsigned(31 downto 0);
  signal in_left_pixel : unsigned(31 downto 0);
  -- transform
  signal transform_left_0, transform_left_1, transform_left_2, transform_left_3 : natural range 0 to 255;
  signal transform_right_0, transform_right_1, transform_right_2, transform_right_3 : natural range 0 to 255;
  signal transform_left_rows_read_newest_0, transform_left_rows_read_newest_1 : natural range 0 to 255;
  signal transform_left_rows_read_newest_2, transform_left_rows_read_newest_3 : natural range 0 to 255;
  signal transform_left_rows_ready_words_1, transform_left_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_1, transform_left_rows_ready_newest_2 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_3, transform_left_rows_write_words_1 : natural range 0 to 255;
  signal transform_right_rows_read_newest_0, transform_right_rows_read_newest_1 : natural range 0 to 255;
  signal transform_right_rows_read_newest_2, transform_right_rows_read_newest_3 : natural range 0 to 255;
  signal transform_right_rows_ready_words_1, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_1, transform_right_rows_ready_newest_2 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_3, transform_right_rows_write_words_1 : natural range 0 to 255;
  signal transform_left_column_0, transform_left_column_1, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_3, transform_left_column_4, transform_left_column_5 : natural range 0 to 255;
  signal transform_right_column_0, transform_right_column_1, transform_right_column_2 : natural range 0 to 255;
  signal transform_right_column_3, transform_right_column_4, transform_right_column_5 : natural range 0 to 255;
  signal transform_left_filter_feature_1, transform_left_filter_feature_2 : natural range 0 to 255;
  signal transform_left_filter_feature_3, transform_right_filter_feature_0 : natural range 0 to 255;
  signal transform_right_filter_feature_1, transform_right_filter_feature_2 : natural range 0 to 255;
  signal transform_right_filter_feature_3 : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_1, transform_read_row_inside_5, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_2, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_1, transform_ready_row_inside_5 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_1 : boolean;
  signal transform_columns_row_inside_5, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_start_of_frame, transform_columns_valid, transform_filtering_column_inside_0 : boolean;
  signal transform_filtering_column_inside_2, transform_filtering_start_of_frame, transform_filtering_valid : boolean;
  signal transform_filtered_start_of_frame, transform_filtered_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 31;
  signal transform_write_column : natural range 0 to 31;
  signal transform_counter_group : natural range 0 to 7;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_1, transform_right_rows_read_words_1 : unsigned(7 downto 0);
  signal transform_left_filter_column_0_0, transform_left_filter_column_0_1 : natural range 0 to 1020;
  signal transform_left_filter_column_0_2, transform_left_filter_column_0_3 : natural range 0 to 1020;
  signal transform_left_filter_column_1_0, transform_left_filter_column_1_1 : natural range 0 to 1020;
  signal transform_left_filter_column_1_2, transform_left_filter_column_1_3 : natural range 0 to 1020;
  signal transform_left_filter_column_2_0, transform_left_filter_column_2_1 : natural range 0 to 1020;
  signal transform_left_filter_column_2_2, transform_left_filter_column_2_3 : natural range 0 to 1020;
  signal transform_right_filter_column_0_0, transform_right_filter_column_0_1 : natural range 0 to 1020;
  signal transform_right_filter_column_0_2, transform_right_filter_column_0_3 : natural range 0 to 1020;
  signal transform_right_filter_column_1_0, transform_right_filter_column_1_1 : natural range 0 to 1020;
  signal transform_right_filter_column_1_2, transform_right_filter_column_1_3 : natural range 0 to 1020;
  signal transform_right_filter_column_2_0, transform_right_filter_column_2_1 : natural range 0 to 1020;
  signal transform_right_filter_column_2_2, transform_right_filter_column_2_3 : natural range 0 to 1020;
  signal transform_left_filter_feature_0 : natural range 0 to 63;
  -- raster
  signal raster_search_0 : natural range 0 to 63;
  signal raster_search_1, raster_search_2, raster_search_3, raster_reference_0 : natural range 0 to 255;
  signal raster_reference_1, raster_reference_2, raster_reference_3 : natural range 0 to 255;
  signal raster_valid, raster_next_frame : boolean;
  signal raster_column : natural range 0 to 31;
  signal raster_group : natural range 0 to 7;
  -- delay
  signal delay_read_address, delay_write_address : natural range 0 to 7;
  signal delay_ahead_0 : natural range 0 to 63;
  signal delay_ahead_1, delay_ahead_2, delay_ahead_3 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(27 downto 0);
  signal delay_column : natural range 0 to 31;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_5, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_first_cost, delay_tag_map_column, delay_tag_output_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(6 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_search_1 : natural range 0 to 63;
  signal rows_search_5 : natural range 0 to 63;
  signal rows_search_rows_read_newest_1, rows_search_rows_read_newest_2 : natural range 0 to 255;
  signal rows_search_rows_read_newest_3, rows_search_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_2, rows_search_rows_ready_newest_3 : natural range 0 to 255;
  signal rows_search_rows_write_words_1 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_reference_rows_ready_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_search_rows_ready_words_1, rows_reference_rows_read_newest_0 : natural range 0 to 127;
  signal rows_reference_rows_read_newest_1, rows_reference_rows_read_newest_2 : natural range 0 to 127;
  signal rows_reference_rows_read_newest_3, rows_reference_rows_ready_words_1 : natural range 0 to 127;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_ready_newest_1 : natural range 0 to 127;
  signal rows_reference_rows_ready_newest_2, rows_reference_rows_ready_newest_3 : natural range 0 to 127;
  signal rows_reference_rows_write_words_1, rows_search_0, rows_search_2, rows_search_3 : natural range 0 to 127;
  signal rows_search_4, rows_reference_0, rows_reference_1, rows_reference_2, rows_reference_3 : natural range 0 to 127;
  signal rows_reference_4, rows_reference_5 : natural range 0 to 127;
  signal rows_search_rows_write_words_0 : natural range 0 to 536870911;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_5, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_first_cost, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_5, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_border_column, rows_ready_tag_first_cost, rows_ready_tag_map_column : boolean;
  signal rows_ready_tag_output_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_inside_0, rows_inside_1, rows_inside_5, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_first_cost, rows_tag_map_column, rows_tag_output_column, rows_tag_start_of_frame : boolean;
  signal rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 127;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 127;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 127;
  signal slice0shift_search_4_0, slice0shift_search_4_1, slice0shift_search_4_2 : natural range 0 to 127;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 127;
  signal slice0shift_reference_3, slice0shift_reference_4, slice0shift_reference_5 : natural range 0 to 127;
  signal slice0shift_search_out_0, slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 127;
  signal slice0shift_search_out_4 : natural range 0 to 127;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 63;
  signal slice0shift_search_5_0, slice0shift_search_5_1, slice0shift_search_5_2 : natural range 0 to 63;
  signal slice0shift_search_out_1, slice0shift_search_out_5 : natural range 0 to 63;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -127 to 127;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -127 to 127;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -127 to 127;
  signal slice0cost_difference_4_0, slice0cost_difference_4_1, slice0cost_difference_4_2 : integer range -127 to 127;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -127 to 63;
  signal slice0cost_difference_5_0, slice0cost_difference_5_1, slice0cost_difference_5_2 : integer range -127 to 63;
  signal slice0cost_reverse_0_0, slice0cost_reverse_0_1, slice0cost_reverse_0_2 : natural range 0 to 255;
  signal slice0cost_reverse_1_0, slice0cost_reverse_1_1, slice0cost_reverse_1_2 : natural range 0 to 255;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_1_0 : natural range 0 to 255;
  signal slice0cost_pair_1_1, slice0cost_pair_1_2, slice0cost_column_0_0 : natural range 0 to 255;
  signal slice0cost_column_0_1, slice0cost_column_0_2, slice0cost_column_1_0 : natural range 0 to 255;
  signal slice0cost_column_1_1, slice0cost_column_1_2, slice0cost_column_2_0 : natural range 0 to 255;
  signal slice0cost_column_2_1, slice0cost_column_2_2, slice0cost_column_3_0 : natural range 0 to 255;
  signal slice0cost_column_3_1, slice0cost_column_3_2 : natural range 0 to 255;
  signal slice0cost_reverse_2_0, slice0cost_reverse_2_1, slice0cost_reverse_2_2 : boolean;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_first_cost, slice0cost_difference_tag_map_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_pair_2_0, slice0cost_pair_2_1, slice0cost_pair_2_2 : boolean;
  signal slice0cost_negative_0_0, slice0cost_negative_0_1, slice0cost_negative_0_2, slice0cost_negative_2_0 : boolean;
  signal slice0cost_negative_2_1, slice0cost_negative_2_2, slice0cost_negative_3_0, slice0cost_negative_3_1 : boolean;
  signal slice0cost_negative_3_2, slice0cost_negative_5_0, slice0cost_negative_5_1, slice0cost_negative_5_2 : boolean;
  signal slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column, slice0cost_pair_tag_first_cost : boolean;
  signal slice0cost_pair_tag_map_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_first_cost, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 127;
  signal slice0cost_single_2_0, slice0cost_single_2_1, slice0cost_single_2_2 : natural range 0 to 127;
  signal slice0cost_single_3_0, slice0cost_single_3_1, slice0cost_single_3_2 : natural range 0 to 127;
  signal slice0cost_single_5_0, slice0cost_single_5_1, slice0cost_single_5_2 : natural range 0 to 126;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 255;
  signal slice0window_partial_1_0_0, slice0window_partial_1_0_1, slice0window_partial_1_0_2 : natural range 0 to 255;
  signal slice0window_partial_2_0_0, slice0window_partial_2_0_1, slice0window_partial_2_0_2 : natural range 0 to 255;
  signal slice0window_partial_3_0_0, slice0window_partial_3_0_1, slice0window_partial_3_0_2 : natural range 0 to 255;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 510;
  signal slice0window_partial_1_1_0, slice0window_partial_1_1_1, slice0window_partial_1_1_2 : natural range 0 to 510;
  signal slice0window_partial_2_1_0, slice0window_partial_2_1_1, slice0window_partial_2_1_2 : natural range 0 to 510;
  signal slice0window_partial_3_1_0, slice0window_partial_3_1_1, slice0window_partial_3_1_2 : natural range 0 to 510;
  signal slice0window_centre_0_map_column, slice0window_centre_0_output_column : boolean;
  signal slice0window_centre_0_first_column, slice0window_centre_0_start_of_frame : boolean;
  signal slice0window_centre_0_end_of_line, slice0window_tag_valid, slice0window_tag_row_start : boolean;
  signal slice0window_tag_first_group, slice0window_tag_border_column, slice0window_tag_first_cost : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_first_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 765;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 765;
  signal slice0window_sum_2_0, slice0window_sum_2_1, slice0window_sum_2_2 : natural range 0 to 765;
  signal slice0window_sum_3_0, slice0window_sum_3_1, slice0window_sum_3_2 : natural range 0 to 765;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 765;
  signal slice0other_cost_1_0, slice0other_cost_1_1, slice0other_cost_1_2 : natural range 0 to 765;
  signal slice0other_cost_2_0, slice0other_cost_2_1, slice0other_cost_2_2 : natural range 0 to 765;
  signal slice0other_cost_3_0, slice0other_cost_3_1, slice0other_cost_3_2 : natural range 0 to 765;
  signal slice0other_cost_out_0, slice0other_cost_out_1, slice0other_cost_out_2 : natural range 0 to 765;
  signal slice0other_cost_out_3 : natural range 0 to 765;
  signal slice0other_winner_0_0, slice0other_winner_0_1, slice0other_winner_0_2 : natural range 0 to 7;
  signal slice0other_winner_1_0, slice0other_winner_1_1, slice0other_winner_1_2 : natural range 0 to 7;
  signal slice0other_winner_2_0, slice0other_winner_2_1, slice0other_winner_3_0 : natural range 0 to 7;
  signal slice0other_winner_3_1, slice0other_winner_out_0, slice0other_winner_out_1 : natural range 0 to 7;
  signal slice0other_winner_out_2, slice0other_winner_out_3 : natural range 0 to 7;
  -- slice0winner1
  signal slice0winner1_cost_0_0, slice0winner1_cost_0_1, slice0winner1_cost_1_0 : natural range 0 to 765;
  signal slice0winner1_cost_1_1, slice0winner1_cost_2_0, slice0winner1_cost_2_1 : natural range 0 to 765;
  signal slice0winner1_cost_3_0, slice0winner1_cost_3_1, slice0winner1_below_0_0 : natural range 0 to 765;
  signal slice0winner1_below_1_0, slice0winner1_below_2_0, slice0winner1_below_3_0 : natural range 0 to 765;
  signal slice0winner1_above_0_0, slice0winner1_above_1_0, slice0winner1_above_2_0 : natural range 0 to 765;
  signal slice0winner1_above_3_0, slice0winner1_first_0_0, slice0winner1_first_1_0 : natural range 0 to 765;
  signal slice0winner1_first_2_0, slice0winner1_first_3_0, slice0winner1_last_0_0 : natural range 0 to 765;
  signal slice0winner1_last_1_0, slice0winner1_last_2_0, slice0winner1_last_3_0 : natural range 0 to 765;
  signal slice0winner1_but_first_0_0, slice0winner1_but_first_1_0, slice0winner1_but_first_2_0 : natural range 0 to 765;
  signal slice0winner1_but_first_3_0, slice0winner1_but_last_0_0, slice0winner1_but_last_1_0 : natural range 0 to 765;
  signal slice0winner1_but_last_2_0, slice0winner1_but_last_3_0 : natural range 0 to 765;
  signal slice0winner1_index_0_0, slice0winner1_index_1_0, slice0winner1_index_2_0, slice0winner1_index_3_0 : boolean;
  signal slice0winner1_tag_valid, slice0winner1_tag_map_column, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_first_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_index_0_1 : natural range 0 to 2;
  signal slice0winner1_second_0_0 : natural range 0 to 1023;
  -- slice0winner2
  signal slice0winner2_cost_0_0, slice0winner2_cost_1_0, slice0winner2_cost_2_0 : natural range 0 to 765;
  signal slice0winner2_cost_3_0, slice0winner2_below_0_0, slice0winner2_below_1_0 : natural range 0 to 765;
  signal slice0winner2_below_2_0, slice0winner2_below_3_0, slice0winner2_above_0_0 : natural range 0 to 765;
  signal slice0winner2_above_1_0, slice0winner2_above_2_0, slice0winner2_above_3_0 : natural range 0 to 765;
  signal slice0winner2_first_0_0, slice0winner2_first_1_0, slice0winner2_first_2_0 : natural range 0 to 765;
  signal slice0winner2_first_3_0, slice0winner2_but_first_0_0, slice0winner2_but_first_1_0 : natural range 0 to 765;
  signal slice0winner2_but_first_2_0, slice0winner2_but_first_3_0 : natural range 0 to 765;
  signal slice0winner2_index_0_0, slice0winner2_index_1_0, slice0winner2_index_2_0 : natural range 0 to 2;
  signal slice0winner2_index_3_0 : natural range 0 to 2;
  signal slice0winner2_second_0_0, slice0winner2_second_1_0, slice0winner2_second_2_0 : natural range 0 to 1023;
  signal slice0winner2_second_3_0 : natural range 0 to 1023;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_first_column, slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  -- slice0best
  signal slice0best_cost_0_0, slice0best_cost_1_0, slice0best_cost_2_0, slice0best_cost_3_0 : natural range 0 to 765;
  signal slice0best_below_0_0, slice0best_below_1_0, slice0best_below_2_0 : natural range 0 to 765;
  signal slice0best_below_3_0, slice0best_above_0_0, slice0best_above_1_0 : natural range 0 to 765;
  signal slice0best_above_2_0, slice0best_above_3_0, slice0best_first_0_0 : natural range 0 to 765;
  signal slice0best_first_1_0, slice0best_first_2_0, slice0best_first_3_0 : natural range 0 to 765;
  signal slice0best_but_first_0_0, slice0best_but_first_1_0, slice0best_but_first_2_0 : natural range 0 to 765;
  signal slice0best_but_first_3_0 : natural range 0 to 765;
  signal slice0best_index_0_0, slice0best_index_1_0, slice0best_index_2_0, slice0best_index_3_0 : natural range 0 to 7;
  signal slice0best_second_0_0, slice0best_second_1_0, slice0best_second_2_0 : natural range 0 to 1023;
  signal slice0best_second_3_0 : natural range 0 to 1023;
  signal slice0best_tag_valid, slice0best_tag_map_column, slice0best_tag_output_column : boolean;
  signal slice0best_tag_start_of_frame, slice0best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 127;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 127;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 127;
  signal slice1shift_search_4_0, slice1shift_search_4_1, slice1shift_search_4_2 : natural range 0 to 127;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 127;
  signal slice1shift_reference_3, slice1shift_reference_4, slice1shift_reference_5 : natural range 0 to 127;
  signal slice1shift_search_out_0, slice1shift_search_out_2, slice1shift_search_out_3 : natural range 0 to 127;
  signal slice1shift_search_out_4 : natural range 0 to 127;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 63;
  signal slice1shift_search_5_0, slice1shift_search_5_1, slice1shift_search_5_2 : natural range 0 to 63;
  signal slice1shift_search_out_1, slice1shift_search_out_5 : natural range 0 to 63;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -127 to 127;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -127 to 127;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -127 to 127;
  signal slice1cost_difference_4_0, slice1cost_difference_4_1, slice1cost_difference_4_2 : integer range -127 to 127;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -127 to 63;
  signal slice1cost_difference_5_0, slice1cost_difference_5_1, slice1cost_difference_5_2 : integer range -127 to 63;
  signal slice1cost_reverse_0_0, slice1cost_reverse_0_1, slice1cost_reverse_0_2 : natural range 0 to 255;
  signal slice1cost_reverse_1_0, slice1cost_reverse_1_1, slice1cost_reverse_1_2 : natural range 0 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_1_0 : natural range 0 to 255;
  signal slice1cost_pair_1_1, slice1cost_pair_1_2, slice1cost_column_0_0 : natural range 0 to 255;
  signal slice1cost_column_0_1, slice1cost_column_0_2, slice1cost_column_1_0 : natural range 0 to 255;
  signal slice1cost_column_1_1, slice1cost_column_1_2, slice1cost_column_2_0 : natural range 0 to 255;
  signal slice1cost_column_2_1, slice1cost_column_2_2, slice1cost_column_3_0 : natural range 0 to 255;
  signal slice1cost_column_3_1, slice1cost_column_3_2 : natural range 0 to 255;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 127;
  signal slice1cost_single_2_0, slice1cost_single_2_1, slice1cost_single_2_2 : natural range 0 to 127;
  signal slice1cost_single_3_0, slice1cost_single_3_1, slice1cost_single_3_2 : natural range 0 to 127;
  signal slice1cost_single_5_0, slice1cost_single_5_1, slice1cost_single_5_2 : natural range 0 to 126;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2, slice1cost_negative_2_0 : boolean;
  signal slice1cost_negative_2_1, slice1cost_negative_2_2, slice1cost_negative_3_0, slice1cost_negative_3_1 : boolean;
  signal slice1cost_negative_3_2, slice1cost_negative_5_0, slice1cost_negative_5_1, slice1cost_negative_5_2 : boolean;
  signal slice1cost_tag_border_column, slice1cost_tag_first_cost, slice1cost_tag_output_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 255;
  signal slice1window_partial_1_0_0, slice1window_partial_1_0_1, slice1window_partial_1_0_2 : natural range 0 to 255;
  signal slice1window_partial_2_0_0, slice1window_partial_2_0_1, slice1window_partial_2_0_2 : natural range 0 to 255;
  signal slice1window_partial_3_0_0, slice1window_partial_3_0_1, slice1window_partial_3_0_2 : natural range 0 to 255;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 510;
  signal slice1window_partial_1_1_0, slice1window_partial_1_1_1, slice1window_partial_1_1_2 : natural range 0 to 510;
  signal slice1window_partial_2_1_0, slice1window_partial_2_1_1, slice1window_partial_2_1_2 : natural range 0 to 510;
  signal slice1window_partial_3_1_0, slice1window_partial_3_1_1, slice1window_partial_3_1_2 : natural range 0 to 510;
  signal slice1window_centre_0_output_column, slice1window_centre_0_first_column : boolean;
  signal slice1window_tag_output_column, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 765;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 765;
  signal slice1window_sum_2_0, slice1window_sum_2_1, slice1window_sum_2_2 : natural range 0 to 765;
  signal slice1window_sum_3_0, slice1window_sum_3_1, slice1window_sum_3_2 : natural range 0 to 765;
  -- slice1other
  signal slice1other_cost_0_0, slice1other_cost_0_1, slice1other_cost_0_2 : natural range 0 to 765;
  signal slice1other_cost_1_0, slice1other_cost_1_1, slice1other_cost_1_2 : natural range 0 to 765;
  signal slice1other_cost_2_0, slice1other_cost_2_1, slice1other_cost_2_2 : natural range 0 to 765;
  signal slice1other_cost_3_0, slice1other_cost_3_1, slice1other_cost_3_2 : natural range 0 to 765;
  signal slice1other_cost_out_0, slice1other_cost_out_1, slice1other_cost_out_2 : natural range 0 to 765;
  signal slice1other_cost_out_3 : natural range 0 to 765;
  signal slice1other_winner_0_0, slice1other_winner_0_1, slice1other_winner_0_2 : natural range 0 to 7;
  signal slice1other_winner_1_0, slice1other_winner_1_1, slice1other_winner_1_2 : natural range 0 to 7;
  signal slice1other_winner_2_0, slice1other_winner_2_1, slice1other_winner_2_2 : natural range 0 to 7;
  signal slice1other_winner_3_0, slice1other_winner_3_1, slice1other_winner_3_2 : natural range 0 to 7;
  signal slice1other_winner_out_0, slice1other_winner_out_1, slice1other_winner_out_2 : natural range 0 to 7;
  signal slice1other_winner_out_3 : natural range 0 to 7;
  -- slice1winner1
  signal slice1winner1_cost_0_0, slice1winner1_cost_0_1, slice1winner1_cost_1_0 : natural range 0 to 765;
  signal slice1winner1_cost_1_1, slice1winner1_cost_2_0, slice1winner1_cost_2_1 : natural range 0 to 765;
  signal slice1winner1_cost_3_0, slice1winner1_cost_3_1, slice1winner1_below_0_0 : natural range 0 to 765;
  signal slice1winner1_below_1_0, slice1winner1_below_2_0, slice1winner1_below_3_0 : natural range 0 to 765;
  signal slice1winner1_above_0_0, slice1winner1_above_1_0, slice1winner1_above_2_0 : natural range 0 to 765;
  signal slice1winner1_above_3_0, slice1winner1_first_0_0, slice1winner1_first_1_0 : natural range 0 to 765;
  signal slice1winner1_first_2_0, slice1winner1_first_3_0, slice1winner1_last_0_0 : natural range 0 to 765;
  signal slice1winner1_last_1_0, slice1winner1_last_2_0, slice1winner1_last_3_0 : natural range 0 to 765;
  signal slice1winner1_but_first_0_0, slice1winner1_but_first_1_0, slice1winner1_but_first_2_0 : natural range 0 to 765;
  signal slice1winner1_but_first_3_0, slice1winner1_but_last_0_0, slice1winner1_but_last_1_0 : natural range 0 to 765;
  signal slice1winner1_but_last_2_0, slice1winner1_but_last_3_0 : natural range 0 to 765;
  signal slice1winner1_index_0_0, slice1winner1_index_1_0, slice1winner1_index_2_0, slice1winner1_index_3_0 : boolean;
  -- slice1winner2
  signal slice1winner2_cost_0_0, slice1winner2_cost_1_0, slice1winner2_cost_2_0 : natural range 0 to 765;
  signal slice1winner2_cost_3_0, slice1winner2_below_0_0, slice1winner2_below_1_0 : natural range 0 to 765;
  signal slice1winner2_below_2_0, slice1winner2_below_3_0, slice1winner2_above_0_0 : natural range 0 to 765;
  signal slice1winner2_above_1_0, slice1winner2_above_2_0, slice1winner2_above_3_0 : natural range 0 to 765;
  signal slice1winner2_first_0_0, slice1winner2_first_1_0, slice1winner2_first_2_0 : natural range 0 to 765;
  signal slice1winner2_first_3_0, slice1winner2_last_0_0, slice1winner2_last_1_0 : natural range 0 to 765;
  signal slice1winner2_last_2_0, slice1winner2_last_3_0, slice1winner2_but_first_0_0 : natural range 0 to 765;
  signal slice1winner2_but_first_1_0, slice1winner2_but_first_2_0, slice1winner2_but_first_3_0 : natural range 0 to 765;
  signal slice1winner2_index_0_0, slice1winner2_index_1_0, slice1winner2_index_2_0 : natural range 0 to 2;
  signal slice1winner2_index_3_0 : natural range 0 to 2;
  signal slice1winner2_second_0_0, slice1winner2_second_1_0, slice1winner2_second_2_0 : natural range 0 to 1023;
  signal slice1winner2_second_3_0, slice1winner2_but_last_0_0, slice1winner2_but_last_1_0 : natural range 0 to 1023;
  signal slice1winner2_but_last_2_0, slice1winner2_but_last_3_0 : natural range 0 to 1023;
  -- slice1best
  signal slice1best_cost_0_0, slice1best_cost_1_0, slice1best_cost_2_0, slice1best_cost_3_0 : natural range 0 to 765;
  signal slice1best_below_0_0, slice1best_below_1_0, slice1best_below_2_0 : natural range 0 to 765;
  signal slice1best_below_3_0, slice1best_above_0_0, slice1best_above_1_0 : natural range 0 to 765;
  signal slice1best_above_2_0, slice1best_above_3_0, slice1best_first_0_0 : natural range 0 to 765;
  signal slice1best_first_1_0, slice1best_first_2_0, slice1best_first_3_0 : natural range 0 to 765;
  signal slice1best_but_first_0_0, slice1best_but_first_1_0, slice1best_but_first_2_0 : natural range 0 to 765;
  signal slice1best_but_first_3_0 : natural range 0 to 765;
  signal slice1best_index_0_0, slice1best_index_1_0, slice1best_index_2_0, slice1best_index_3_0 : natural range 0 to 7;
  signal slice1best_second_0_0, slice1best_second_1_0, slice1best_second_2_0 : natural range 0 to 1023;
  signal slice1best_second_3_0 : natural range 0 to 1023;
  signal slice1best_tag_valid, slice1best_tag_map_column, slice1best_tag_output_column : boolean;
  signal slice1best_tag_start_of_frame, slice1best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_2_0 : natural range 0 to 127;
  signal slice2shift_search_2_1, slice2shift_search_3_0, slice2shift_search_3_1 : natural range 0 to 127;
  signal slice2shift_search_4_0, slice2shift_search_4_1, slice2shift_reference_0 : natural range 0 to 127;
  signal slice2shift_reference_1, slice2shift_reference_2, slice2shift_reference_3 : natural range 0 to 127;
  signal slice2shift_reference_4, slice2shift_reference_5 : natural range 0 to 127;
  signal slice2shift_search_1_0, slice2shift_search_1_1, slice2shift_search_5_0 : natural range 0 to 63;
  signal slice2shift_search_5_1 : natural range 0 to 63;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_2_0 : integer range -127 to 127;
  signal slice2cost_difference_2_1, slice2cost_difference_3_0, slice2cost_difference_3_1 : integer range -127 to 127;
  signal slice2cost_difference_4_0, slice2cost_difference_4_1 : integer range -127 to 127;
  signal slice2cost_difference_1_0, slice2cost_difference_1_1, slice2cost_difference_5_0 : integer range -127 to 63;
  signal slice2cost_difference_5_1 : integer range -127 to 63;
  signal slice2cost_reverse_0_0, slice2cost_reverse_0_1, slice2cost_reverse_1_0 : natural range 0 to 255;
  signal slice2cost_reverse_1_1, slice2cost_pair_0_0, slice2cost_pair_0_1, slice2cost_pair_1_0 : natural range 0 to 255;
  signal slice2cost_pair_1_1, slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 255;
  signal slice2cost_column_1_0, slice2cost_column_1_1, slice2cost_column_2_0 : natural range 0 to 255;
  signal slice2cost_column_2_1, slice2cost_column_3_0, slice2cost_column_3_1 : natural range 0 to 255;
  signal slice2cost_single_0_0, slice2cost_single_0_1, slice2cost_single_2_0 : natural range 0 to 127;
  signal slice2cost_single_2_1, slice2cost_single_3_0, slice2cost_single_3_1 : natural range 0 to 127;
  signal slice2cost_single_5_0, slice2cost_single_5_1 : natural range 0 to 126;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1, slice2cost_negative_2_0, slice2cost_negative_2_1 : boolean;
  signal slice2cost_negative_3_0, slice2cost_negative_3_1, slice2cost_negative_5_0, slice2cost_negative_5_1 : boolean;
  signal slice2cost_tag_first_cost, slice2cost_tag_output_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1, slice2window_partial_1_0_0 : natural range 0 to 255;
  signal slice2window_partial_1_0_1, slice2window_partial_2_0_0, slice2window_partial_2_0_1 : natural range 0 to 255;
  signal slice2window_partial_3_0_0, slice2window_partial_3_0_1 : natural range 0 to 255;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_partial_1_1_0 : natural range 0 to 510;
  signal slice2window_partial_1_1_1, slice2window_partial_2_1_0, slice2window_partial_2_1_1 : natural range 0 to 510;
  signal slice2window_partial_3_1_0, slice2window_partial_3_1_1 : natural range 0 to 510;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_1_0 : natural range 0 to 765;
  signal slice2window_sum_1_1, slice2window_sum_2_0, slice2window_sum_2_1 : natural range 0 to 765;
  signal slice2window_sum_3_0, slice2window_sum_3_1 : natural range 0 to 765;
  -- slice2other
  signal slice2other_cost_0_1, slice2other_cost_1_1, slice2other_cost_2_1 : natural range 0 to 765;
  signal slice2other_cost_3_1 : natural range 0 to 765;
  signal slice2other_winner_0_0, slice2other_winner_0_1, slice2other_winner_1_0 : natural range 0 to 7;
  signal slice2other_winner_1_1, slice2other_winner_2_0, slice2other_winner_2_1 : natural range 0 to 7;
  signal slice2other_winner_3_0, slice2other_winner_3_1, slice2other_winner_out_0 : natural range 0 to 7;
  signal slice2other_winner_out_1, slice2other_winner_out_2, slice2other_winner_out_3 : natural range 0 to 7;
  -- slice2winner1
  signal slice2winner1_cost_0_0, slice2winner1_cost_1_0, slice2winner1_cost_2_0 : natural range 0 to 765;
  signal slice2winner1_cost_3_0, slice2winner1_below_0_0, slice2winner1_below_1_0 : natural range 0 to 765;
  signal slice2winner1_below_2_0, slice2winner1_below_3_0, slice2winner1_above_0_0 : natural range 0 to 765;
  signal slice2winner1_above_1_0, slice2winner1_above_2_0, slice2winner1_above_3_0 : natural range 0 to 765;
  signal slice2winner1_first_0_0, slice2winner1_first_1_0, slice2winner1_first_2_0 : natural range 0 to 765;
  signal slice2winner1_first_3_0, slice2winner1_last_0_0, slice2winner1_last_1_0 : natural range 0 to 765;
  signal slice2winner1_last_2_0, slice2winner1_last_3_0 : natural range 0 to 765;
  signal slice2winner1_index_0_0, slice2winner1_index_1_0, slice2winner1_index_2_0, slice2winner1_index_3_0 : boolean;
  -- slice2winner2
  signal slice2winner2_cost_0_0, slice2winner2_cost_1_0, slice2winner2_cost_2_0 : natural range 0 to 765;
  signal slice2winner2_cost_3_0, slice2winner2_below_0_0, slice2winner2_below_1_0 : natural range 0 to 765;
  signal slice2winner2_below_2_0, slice2winner2_below_3_0, slice2winner2_above_0_0 : natural range 0 to 765;
  signal slice2winner2_above_1_0, slice2winner2_above_2_0, slice2winner2_above_3_0 : natural range 0 to 765;
  signal slice2winner2_first_0_0, slice2winner2_first_1_0, slice2winner2_first_2_0 : natural range 0 to 765;
  signal slice2winner2_first_3_0, slice2winner2_last_0_0, slice2winner2_last_1_0 : natural range 0 to 765;
  signal slice2winner2_last_2_0, slice2winner2_last_3_0 : natural range 0 to 765;
  signal slice2winner2_index_0_0, slice2winner2_index_1_0, slice2winner2_index_2_0, slice2winner2_index_3_0 : boolean;
  signal slice2winner2_second_0_0 : natural range 0 to 1023;
  -- slice2best
  signal slice2best_cost_0_0, slice2best_cost_1_0, slice2best_cost_2_0, slice2best_cost_3_0 : natural range 0 to 765;
  signal slice2best_below_0_0, slice2best_below_1_0, slice2best_below_2_0 : natural range 0 to 765;
  signal slice2best_below_3_0, slice2best_above_0_0, slice2best_above_1_0 : natural range 0 to 765;
  signal slice2best_above_2_0, slice2best_above_3_0 : natural range 0 to 765;
  signal slice2best_index_0_0, slice2best_index_1_0, slice2best_index_2_0, slice2best_index_3_0 : natural range 0 to 7;
  signal slice2best_second_0_0, slice2best_second_1_0, slice2best_second_2_0 : natural range 0 to 1023;
  signal slice2best_second_3_0 : natural range 0 to 1023;
  signal slice2best_tag_valid, slice2best_tag_map_column, slice2best_tag_output_column : boolean;
  signal slice2best_tag_start_of_frame, slice2best_tag_end_of_line : boolean;
  -- texture
  signal texture_taps_search_0_0, texture_taps_search_1_0, texture_taps_search_5_0 : natural range 0 to 31;
  signal texture_passes_0_0, texture_passes_0_1, texture_passes_0_2, texture_passes_0_3, texture_passes_1_0 : boolean;
  signal texture_passes_1_1, texture_passes_1_2, texture_passes_1_3, texture_passes_2_0, texture_passes_2_1 : boolean;
  signal texture_passes_2_2, texture_passes_2_3, texture_passes_3_0, texture_passes_3_1, texture_passes_3_2 : boolean;
  signal texture_passes_3_3, texture_passes_4_0, texture_passes_4_1, texture_passes_4_2, texture_passes_4_3 : boolean;
  -- texturecost
  signal texturecost_difference_0_0, texturecost_difference_1_0, texturecost_difference_2_0 : integer range -127 to 31;
  signal texturecost_difference_3_0, texturecost_difference_4_0, texturecost_difference_5_0 : integer range -127 to 31;
  signal texturecost_reverse_0_0, texturecost_reverse_1_0, texturecost_pair_0_0 : natural range 0 to 255;
  signal texturecost_pair_1_0, texturecost_column_0_0, texturecost_column_1_0 : natural range 0 to 255;
  signal texturecost_column_2_0, texturecost_column_3_0 : natural range 0 to 255;
  signal texturecost_single_0_0, texturecost_single_2_0, texturecost_single_3_0 : natural range 0 to 126;
  signal texturecost_single_5_0 : natural range 0 to 126;
  signal texturecost_negative_0_0, texturecost_negative_2_0, texturecost_negative_3_0 : boolean;
  signal texturecost_negative_5_0 : boolean;
  -- texturewindow
  signal texturewindow_partial_0_0_0, texturewindow_partial_1_0_0, texturewindow_partial_2_0_0 : natural range 0 to 255;
  signal texturewindow_partial_3_0_0 : natural range 0 to 255;
  signal texturewindow_partial_0_1_0, texturewindow_partial_1_1_0, texturewindow_partial_2_1_0 : natural range 0 to 510;
  signal texturewindow_partial_3_1_0 : natural range 0 to 510;
  signal texturewindow_sum_0_0, texturewindow_sum_1_0, texturewindow_sum_2_0 : natural range 0 to 765;
  signal texturewindow_sum_3_0 : natural range 0 to 765;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_0_1, refinement_disparity_0_2 : natural range 0 to 7;
  signal refinement_disparity_0_3, refinement_disparity_1_0, refinement_disparity_1_1 : natural range 0 to 7;
  signal refinement_disparity_1_2, refinement_disparity_1_3, refinement_disparity_2_0 : natural range 0 to 7;
  signal refinement_disparity_2_1, refinement_disparity_2_2, refinement_disparity_2_3 : natural range 0 to 7;
  signal refinement_disparity_3_0, refinement_disparity_3_1, refinement_disparity_3_2 : natural range 0 to 7;
  signal refinement_disparity_3_3, refinement_disparity_4_0, refinement_disparity_4_1 : natural range 0 to 7;
  signal refinement_disparity_4_2, refinement_disparity_4_3, refinement_disparity_5_0 : natural range 0 to 7;
  signal refinement_disparity_5_1, refinement_disparity_5_2, refinement_disparity_5_3 : natural range 0 to 7;
  signal refinement_disparity_6_0, refinement_disparity_6_1, refinement_disparity_6_2 : natural range 0 to 7;
  signal refinement_disparity_6_3, refinement_disparity_7_0, refinement_disparity_7_1 : natural range 0 to 7;
  signal refinement_disparity_7_2, refinement_disparity_7_3, refinement_disparity_8_0 : natural range 0 to 7;
  signal refinement_disparity_8_1, refinement_disparity_8_2, refinement_disparity_8_3 : natural range 0 to 7;
  signal refinement_disparity_9_0, refinement_disparity_9_1, refinement_disparity_9_2 : natural range 0 to 7;
  signal refinement_disparity_9_3, refinement_quotient_3_0, refinement_quotient_3_1 : natural range 0 to 7;
  signal refinement_quotient_3_2, refinement_quotient_3_3 : natural range 0 to 7;
  signal refinement_passed_0_0, refinement_passed_0_1, refinement_passed_0_2, refinement_passed_0_3 : boolean;
  signal refinement_passed_1_0, refinement_passed_1_1, refinement_passed_1_2, refinement_passed_1_3 : boolean;
  signal refinement_passed_2_0, refinement_passed_2_1, refinement_passed_2_2, refinement_passed_2_3 : boolean;
  signal refinement_passed_3_0, refinement_passed_3_1, refinement_passed_3_2, refinement_passed_3_3 : boolean;
  signal refinement_passed_4_0, refinement_passed_4_1, refinement_passed_4_2, refinement_passed_4_3 : boolean;
  signal refinement_passed_5_0, refinement_passed_5_1, refinement_passed_5_2, refinement_passed_5_3 : boolean;
  signal refinement_passed_6_0, refinement_passed_6_1, refinement_passed_6_2, refinement_passed_6_3 : boolean;
  signal refinement_passed_7_0, refinement_passed_7_1, refinement_passed_7_2, refinement_passed_7_3 : boolean;
  signal refinement_passed_8_0, refinement_passed_8_1, refinement_passed_8_2, refinement_passed_8_3 : boolean;
  signal refinement_passed_9_0, refinement_passed_9_1, refinement_passed_9_2, refinement_passed_9_3 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_map_column, refinement_tag_0_output_column : boolean;
  signal refinement_tag_0_start_of_frame, refinement_tag_0_end_of_line, refinement_tag_1_valid : boolean;
  signal refinement_tag_1_map_column, refinement_tag_1_output_column, refinement_tag_1_start_of_frame : boolean;
  signal refinement_tag_1_end_of_line, refinement_tag_2_valid, refinement_tag_2_map_column : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_map_column, refinement_tag_3_output_column : boolean;
  signal refinement_tag_3_start_of_frame, refinement_tag_3_end_of_line, refinement_tag_4_valid : boolean;
  signal refinement_tag_4_map_column, refinement_tag_4_output_column, refinement_tag_4_start_of_frame : boolean;
  signal refinement_tag_4_end_of_line, refinement_tag_5_valid, refinement_tag_5_map_column : boolean;
  signal refinement_tag_5_output_column, refinement_tag_5_start_of_frame, refinement_tag_5_end_of_line : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_map_column, refinement_tag_6_output_column : boolean;
  signal refinement_tag_6_start_of_frame, refinement_tag_6_end_of_line, refinement_tag_7_valid : boolean;
  signal refinement_tag_7_map_column, refinement_tag_7_output_column, refinement_tag_7_start_of_frame : boolean;
  signal refinement_tag_7_end_of_line, refinement_tag_8_valid, refinement_tag_8_map_column : boolean;
  signal refinement_tag_8_output_column, refinement_tag_8_start_of_frame, refinement_tag_8_end_of_line : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_map_column, refinement_tag_9_output_column : boolean;
  signal refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line, refinement_quotient_1_0 : boolean;
  signal refinement_quotient_1_1, refinement_quotient_1_2, refinement_quotient_1_3, refinement_negative_0_0 : boolean;
  signal refinement_negative_0_1, refinement_negative_0_2, refinement_negative_0_3, refinement_negative_1_0 : boolean;
  signal refinement_negative_1_1, refinement_negative_1_2, refinement_negative_1_3, refinement_negative_2_0 : boolean;
  signal refinement_negative_2_1, refinement_negative_2_2, refinement_negative_2_3, refinement_negative_3_0 : boolean;
  signal refinement_negative_3_1, refinement_negative_3_2, refinement_negative_3_3, refinement_negative_4_0 : boolean;
  signal refinement_negative_4_1, refinement_negative_4_2, refinement_negative_4_3, refinement_negative_5_0 : boolean;
  signal refinement_negative_5_1, refinement_negative_5_2, refinement_negative_5_3, refinement_negative_6_0 : boolean;
  signal refinement_negative_6_1, refinement_negative_6_2, refinement_negative_6_3, refinement_negative_7_0 : boolean;
  signal refinement_negative_7_1, refinement_negative_7_2, refinement_negative_7_3, refinement_negative_8_0 : boolean;
  signal refinement_negative_8_1, refinement_negative_8_2, refinement_negative_8_3 : boolean;
  signal refinement_cost_0, refinement_cost_1, refinement_cost_2, refinement_cost_3 : natural range 0 to 765;
  signal refinement_gap_0, refinement_gap_1, refinement_gap_2, refinement_gap_3 : natural range 0 to 1023;
  signal refinement_remainder_0_0, refinement_remainder_0_1, refinement_remainder_0_2 : natural range 0 to 1023;
  signal refinement_remainder_0_3, refinement_remainder_1_0, refinement_remainder_1_1 : natural range 0 to 1023;
  signal refinement_remainder_1_2, refinement_remainder_1_3, refinement_remainder_2_0 : natural range 0 to 1023;
  signal refinement_remainder_2_1, refinement_remainder_2_2, refinement_remainder_2_3 : natural range 0 to 1023;
  signal refinement_remainder_3_0, refinement_remainder_3_1, refinement_remainder_3_2 : natural range 0 to 1023;
  signal refinement_remainder_3_3, refinement_remainder_4_0, refinement_remainder_4_1 : natural range 0 to 1023;
  signal refinement_remainder_4_2, refinement_remainder_4_3, refinement_remainder_5_0 : natural range 0 to 1023;
  signal refinement_remainder_5_1, refinement_remainder_5_2, refinement_remainder_5_3 : natural range 0 to 1023;
  signal refinement_remainder_6_0, refinement_remainder_6_1, refinement_remainder_6_2 : natural range 0 to 1023;
  signal refinement_remainder_6_3, refinement_remainder_7_0, refinement_remainder_7_1 : natural range 0 to 1023;
  signal refinement_remainder_7_2, refinement_remainder_7_3, refinement_divisor_0_0 : natural range 0 to 1023;
  signal refinement_divisor_0_1, refinement_divisor_0_2, refinement_divisor_0_3 : natural range 0 to 1023;
  signal refinement_divisor_1_0, refinement_divisor_1_1, refinement_divisor_1_2 : natural range 0 to 1023;
  signal refinement_divisor_1_3, refinement_divisor_2_0, refinement_divisor_2_1 : natural range 0 to 1023;
  signal refinement_divisor_2_2, refinement_divisor_2_3, refinement_divisor_3_0 : natural range 0 to 1023;
  signal refinement_divisor_3_1, refinement_divisor_3_2, refinement_divisor_3_3 : natural range 0 to 1023;
  signal refinement_divisor_4_0, refinement_divisor_4_1, refinement_divisor_4_2 : natural range 0 to 1023;
  signal refinement_divisor_4_3, refinement_divisor_5_0, refinement_divisor_5_1 : natural range 0 to 1023;
  signal refinement_divisor_5_2, refinement_divisor_5_3, refinement_divisor_6_0 : natural range 0 to 1023;
  signal refinement_divisor_6_1, refinement_divisor_6_2, refinement_divisor_6_3 : natural range 0 to 1023;
  signal refinement_divisor_7_0, refinement_divisor_7_1, refinement_divisor_7_2 : natural range 0 to 1023;
  signal refinement_divisor_7_3 : natural range 0 to 1023;
  signal refinement_scaled_gap_0, refinement_scaled_gap_1, refinement_scaled_gap_2 : natural range 0 to 102300;
  signal refinement_scaled_gap_3 : natural range 0 to 102300;
  signal refinement_scaled_cost_0, refinement_scaled_cost_1, refinement_scaled_cost_2 : natural range 0 to 7654;
  signal refinement_scaled_cost_3 : natural range 0 to 7654;
  signal refinement_quotient_2_0, refinement_quotient_2_1, refinement_quotient_2_2 : natural range 0 to 3;
  signal refinement_quotient_2_3 : natural range 0 to 3;
  signal refinement_quotient_4_0, refinement_quotient_4_1, refinement_quotient_4_2 : natural range 0 to 15;
  signal refinement_quotient_4_3 : natural range 0 to 15;
  signal refinement_quotient_5_0, refinement_quotient_5_1, refinement_quotient_5_2 : natural range 0 to 31;
  signal refinement_quotient_5_3 : natural range 0 to 31;
  signal refinement_quotient_6_0, refinement_quotient_6_1, refinement_quotient_6_2 : natural range 0 to 63;
  signal refinement_quotient_6_3 : natural range 0 to 63;
  signal refinement_quotient_7_0, refinement_quotient_7_1, refinement_quotient_7_2 : natural range 0 to 127;
  signal refinement_quotient_7_3 : natural range 0 to 127;
  signal refinement_quotient_8_0, refinement_quotient_8_1, refinement_quotient_8_2 : natural range 0 to 255;
  signal refinement_quotient_8_3, refinement_fraction_0, refinement_fraction_1 : natural range 0 to 255;
  signal refinement_fraction_2, refinement_fraction_3 : natural range 0 to 255;
  -- leftright
  signal leftright_other_1_0, leftright_other_1_1, leftright_other_1_2, leftright_other_1_3 : natural range 0 to 7;
  signal leftright_other_2_0, leftright_other_2_1, leftright_other_2_2, leftright_other_2_3 : natural range 0 to 7;
  signal leftright_other_3_0, leftright_other_3_1, leftright_other_3_2, leftright_other_3_3 : natural range 0 to 7;
  signal leftright_other_4_0, leftright_other_4_1, leftright_other_4_2, leftright_other_4_3 : natural range 0 to 7;
  signal leftright_other_5_0, leftright_other_5_1, leftright_other_5_2, leftright_other_5_3 : natural range 0 to 7;
  signal leftright_other_6_0, leftright_other_6_1, leftright_other_6_2, leftright_other_6_3 : natural range 0 to 7;
  signal leftright_other_7_0, leftright_other_7_1, leftright_other_7_2, leftright_other_7_3 : natural range 0 to 7;
  signal leftright_other_8_0, leftright_other_8_1, leftright_other_8_2, leftright_other_8_3 : natural range 0 to 7;
  signal leftright_other_9_0, leftright_other_9_1, leftright_other_9_2, leftright_other_9_3 : natural range 0 to 7;
  signal leftright_other_10_0, leftright_other_10_1, leftright_other_10_2, leftright_other_10_3 : natural range 0 to 7;
  signal leftright_other_11_0, leftright_other_11_1, leftright_other_11_2, leftright_other_11_3 : natural range 0 to 7;
  signal leftright_read_address, leftright_write_address : natural range 0 to 7;
  signal leftright_position, leftright_held_position, leftright_address_0, leftright_address_1 : natural range 0 to 15;
  signal leftright_address_2, leftright_address_3, leftright_asking_disparity_0 : natural range 0 to 15;
  signal leftright_asking_disparity_1, leftright_asking_disparity_2 : natural range 0 to 15;
  signal leftright_asking_disparity_3, leftright_answered_disparity_0 : natural range 0 to 15;
  signal leftright_answered_disparity_1, leftright_answered_disparity_2 : natural range 0 to 15;
  signal leftright_answered_disparity_3, leftright_checked_disparity_0 : natural range 0 to 15;
  signal leftright_checked_disparity_1, leftright_checked_disparity_2 : natural range 0 to 15;
  signal leftright_checked_disparity_3 : natural range 0 to 15;
  signal leftright_held_0 : unsigned(59 downto 0);
  signal leftright_held_valid, leftright_holds_winners, leftright_asking_passed_0, leftright_asking_passed_1 : boolean;
  signal leftright_asking_passed_2, leftright_asking_passed_3, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_start_of_frame : boolean;
  signal leftright_asking_tag_end_of_line, leftright_answered_passed_0, leftright_answered_passed_1 : boolean;
  signal leftright_answered_passed_2, leftright_answered_passed_3, leftright_answered_tag_valid : boolean;
  signal leftright_answered_tag_map_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_passed_1 : boolean;
  signal leftright_checked_passed_2, leftright_checked_passed_3, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_asking_fraction_0, leftright_asking_fraction_1, leftright_asking_fraction_2 : natural range 0 to 31;
  signal leftright_asking_fraction_3, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_answered_fraction_1, leftright_answered_fraction_2 : natural range 0 to 31;
  signal leftright_answered_fraction_3, leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_1, leftright_checked_fraction_2 : natural range 0 to 31;
  signal leftright_checked_fraction_3 : natural range 0 to 31;
  signal leftright_found_0, leftright_found_1, leftright_found_2, leftright_found_3 : unsigned(2 downto 0);
  -- median
  signal median_counter_column, median_read_column, median_ready_column, median_write_column : natural range 0 to 31;
  signal median_at_column : natural range 0 to 31;
  signal median_counter_group : natural range 0 to 7;
  signal median_newest_0, median_newest_1, median_newest_2, median_newest_3 : natural range 0 to 65535;
  signal median_rows_read_newest_0, median_rows_read_newest_1, median_rows_read_newest_2 : natural range 0 to 65535;
  signal median_rows_read_newest_3, median_rows_ready_newest_0, median_rows_ready_newest_1 : natural range 0 to 65535;
  signal median_rows_ready_newest_2, median_rows_ready_newest_3, median_rows_write_words_2 : natural range 0 to 65535;
  signal median_column_5 : natural range 0 to 65535;
  signal median_arrives, median_behind, median_line_ended, median_read_arrives, median_read_behind : boolean;
  signal median_read_top, median_read_output, median_ready_arrives, median_ready_behind, median_ready_top : boolean;
  signal median_ready_output, median_at_arrives, median_at_behind, median_at_top, median_at_output : boolean;
  signal median_passed_0_0, median_passed_0_1, median_passed_0_2, median_passed_0_3, median_passed_1_0 : boolean;
  signal median_passed_1_1, median_passed_1_2, median_passed_1_3, median_complete, median_first, median_last : boolean;
  signal median_waiting_passed_0, median_waiting_passed_1, median_waiting_passed_2, median_waiting_passed_3 : boolean;
  signal median_waiting_valid, median_waiting_start_of_frame, median_waiting_end_of_line, median_out_passed_0 : boolean;
  signal median_out_passed_1, median_out_passed_2, median_out_passed_3, median_out_valid : boolean;
  signal median_out_start_of_frame, median_out_end_of_line : boolean;
  signal median_rows_read_words_0, median_rows_read_words_1 : unsigned(25 downto 0);
  signal median_rows_read_words_2 : unsigned(12 downto 0);
  signal median_rows_ready_words_0, median_rows_ready_words_1 : natural range 0 to 67108863;
  signal median_rows_ready_words_2, median_column_1, median_column_2, median_column_3 : natural range 0 to 8191;
  signal median_column_4 : natural range 0 to 8191;
  signal median_rows_write_words_0, median_rows_write_words_1 : natural range 0 to 536870911;
  signal median_column_0_value : natural range 0 to 8190;
  signal median_low_0_0, median_low_0_1, median_low_0_2, median_low_0_3, median_low_1_0 : natural range 0 to 4095;
  signal median_low_1_1, median_low_1_2, median_low_1_3, median_low_2_0, median_low_2_1 : natural range 0 to 4095;
  signal median_low_2_2, median_low_2_3, median_middle_0_0, median_middle_0_1 : natural range 0 to 4095;
  signal median_middle_0_2, median_middle_0_3, median_middle_1_0, median_middle_1_1 : natural range 0 to 4095;
  signal median_middle_1_2, median_middle_1_3, median_middle_2_0, median_middle_2_1 : natural range 0 to 4095;
  signal median_middle_2_2, median_middle_2_3, median_high_0_0, median_high_0_1 : natural range 0 to 4095;
  signal median_high_0_2, median_high_1_0, median_high_1_1, median_high_1_2, median_high_2_0 : natural range 0 to 4095;
  signal median_high_2_1, median_high_2_2, median_largest_low_0, median_largest_low_1 : natural range 0 to 4095;
  signal median_largest_low_2, median_largest_low_3, median_median_middle_0 : natural range 0 to 4095;
  signal median_median_middle_1, median_median_middle_2, median_median_middle_3 : natural range 0 to 4095;
  signal median_smallest_high_0, median_smallest_high_1, median_smallest_high_2 : natural range 0 to 4095;
  signal median_out_disparity_0, median_out_disparity_1, median_out_disparity_2 : natural range 0 to 4095;
  signal median_high_0_3, median_high_1_3, median_high_2_3, median_smallest_high_3 : natural range 0 to 32767;
  signal median_out_disparity_3 : natural range 0 to 32767;
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(6 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(6 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(27 downto 0);
  signal transform_left_rows_read_words_1_memory_write_data : unsigned(7 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_1_memory_write_data : unsigned(7 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal median_rows_read_words_2_memory_write_data : unsigned(12 downto 0);
  signal median_rows_read_words_1_memory_write_data : unsigned(25 downto 0);
  signal median_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal leftright_found_3_memory_write_data : unsigned(2 downto 0);
  signal leftright_found_2_memory_write_data : unsigned(2 downto 0);
  signal leftright_found_1_memory_write_data : unsigned(2 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(2 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(59 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= unsigned(right_pixel);
  in_left_pixel <= unsigned(left_pixel);
  disparity <= std_logic_vector(to_unsigned(median_out_disparity_3, 16) & to_unsigned(median_out_disparity_2, 16) & to_unsigned(median_out_disparity_1, 16) & to_unsigned(median_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_3), 1) & to_unsigned(as_number(median_out_passed_2), 1) & to_unsigned(as_number(median_out_passed_1), 1) & to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

  rows_search_rows_read_words_1_memory_write_data <= to_unsigned((rows_search_rows_write_words_1 mod 128), 7);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 7)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_search_rows_read_words_1,
      write_address => rows_write_column, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_write_data <= to_unsigned((rows_search_rows_write_words_0 mod 268435456), 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 28)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_search_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 7);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 7)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_reference_rows_read_words_1,
      write_address => rows_write_column, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 28)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_column, read_data => rows_reference_rows_read_words_0,
      write_address => rows_write_column, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_write_data <= ((((((to_unsigned(raster_reference_2, 14) & to_unsigned(0, 14)) or (to_unsigned((raster_reference_3 mod 128), 7) & to_unsigned(0, 21)))) or (to_unsigned(raster_reference_0, 28)))) or (to_unsigned(raster_reference_1, 21) & to_unsigned(0, 7)));
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 8, width => 28)
    port map (
      clock => clock, read_enable => true,
      read_address => delay_read_address, read_data => delay_delayed_0,
      write_address => delay_write_address, write_data => delay_delayed_0_memory_write_data);

  transform_left_rows_read_words_1_memory_write_data <= to_unsigned(transform_left_rows_write_words_1, 8);
  transform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 8)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_left_rows_read_words_1,
      write_address => transform_write_column, write_data => transform_left_rows_read_words_1_memory_write_data);

  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_left_rows_read_words_0,
      write_address => transform_write_column, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_1_memory_write_data <= to_unsigned(transform_right_rows_write_words_1, 8);
  transform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 32, width => 8)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_right_rows_read_words_1,
      write_address => transform_write_column, write_data => transform_right_rows_read_words_1_memory_write_data);

  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 32)
    port map (
      clock => clock, read_enable => true,
      read_address => transform_counter_column, read_data => transform_right_rows_read_words_0,
      write_address => transform_write_column, write_data => transform_right_rows_read_words_0_memory_write_data);

  median_rows_read_words_2_memory_write_data <= to_unsigned((median_rows_write_words_2 mod 8192), 13);
  median_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 24, width => 13)
    port map (
      clock => clock, read_enable => true,
      read_address => median_counter_column, read_data => median_rows_read_words_2,
      write_address => median_at_column, write_data => median_rows_read_words_2_memory_write_data);

  median_rows_read_words_1_memory_write_data <= to_unsigned((median_rows_write_words_1 mod 67108864), 26);
  median_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 24, width => 26)
    port map (
      clock => clock, read_enable => true,
      read_address => median_counter_column, read_data => median_rows_read_words_1,
      write_address => median_at_column, write_data => median_rows_read_words_1_memory_write_data);

  median_rows_read_words_0_memory_write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
  median_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 24, width => 26)
    port map (
      clock => clock, read_enable => true,
      read_address => median_counter_column, read_data => median_rows_read_words_0,
      write_address => median_at_column, write_data => median_rows_read_words_0_memory_write_data);

  leftright_found_3_memory_write_data <= to_unsigned(leftright_other_11_3, 3);
  leftright_found_3_memory : entity work.line_memory
    generic map (depth => 16, width => 3)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_address_3, read_data => leftright_found_3,
      write_address => leftright_position, write_data => leftright_found_3_memory_write_data);

  leftright_found_2_memory_write_data <= to_unsigned(leftright_other_11_2, 3);
  leftright_found_2_memory : entity work.line_memory
    generic map (depth => 16, width => 3)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_address_2, read_data => leftright_found_2,
      write_address => leftright_position, write_data => leftright_found_2_memory_write_data);

  leftright_found_1_memory_write_data <= to_unsigned(leftright_other_11_1, 3);
  leftright_found_1_memory : entity work.line_memory
    generic map (depth => 16, width => 3)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_address_1, read_data => leftright_found_1,
      write_address => leftright_position, write_data => leftright_found_1_memory_write_data);

  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_11_0, 3);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 3)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_address_0, read_data => leftright_found_0,
      write_address => leftright_position, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_write_data <= ((to_unsigned(as_number(refinement_passed_9_3), 6) & to_unsigned(refinement_disparity_9_3, 8) & to_unsigned(as_number(refinement_passed_9_2), 6) & to_unsigned(refinement_disparity_9_2, 8) & to_unsigned(as_number(refinement_passed_9_1), 6) & to_unsigned(to_integer(((((to_unsigned(refinement_disparity_9_1, 3) & to_unsigned(0, 18)) or (to_unsigned(refinement_fraction_0, 8) & to_unsigned(0, 13)))) or (to_unsigned(as_number(refinement_passed_9_0), 9) & to_unsigned(refinement_disparity_9_0, 8) & to_unsigned(0, 4)))), 26)) or (to_unsigned((refinement_fraction_3 mod 32), 5) & to_unsigned(refinement_fraction_2, 14) & to_unsigned(refinement_fraction_1, 14) & to_unsigned(as_number(refinement_tag_9_end_of_line), 24) & to_unsigned(as_number(refinement_tag_9_start_of_frame), 1) & to_unsigned(as_number(refinement_tag_9_output_column), 1) & to_unsigned(as_number(refinement_tag_9_map_column), 1)));
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 60)
    port map (
      clock => clock, read_enable => true,
      read_address => leftright_read_address, read_data => leftright_held_0,
      write_address => leftright_write_address, write_data => leftright_held_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3 : boolean;
    variable transform_read_row_inside_0_is_equal, transform_read_row_inside_0_value : boolean;
    variable transform_read_row_inside_0_choice, transform_read_column_inside_0_differs : boolean;
    variable transform_left_filter_feature_0_all, transform_left_filter_feature_0_is_less : boolean;
    variable transform_left_filter_feature_1_is_less, transform_left_filter_feature_2_is_less : boolean;
    variable transform_left_filter_feature_3_is_less, transform_right_filter_feature_0_is_less : boolean;
    variable transform_right_filter_feature_1_is_less, transform_right_filter_feature_2_is_less : boolean;
    variable transform_right_filter_feature_3_is_less, transform_counter_next_frame_is_equal : boolean;
    variable transform_counter_next_frame_is_equal_2, transform_counter_next_frame_is_equal_3 : boolean;
    variable transform_counter_next_frame_all, transform_counter_next_frame_choice : boolean;
    variable transform_left_filter_column_0_0_choice_3, transform_left_filter_column_0_1_choice_3 : boolean;
    variable transform_left_filter_column_0_2_choice_3, transform_left_filter_column_0_3_choice_3 : boolean;
    variable transform_right_filter_column_0_0_choice_3, transform_right_filter_column_0_1_choice_3 : boolean;
    variable transform_right_filter_column_0_2_choice_3, transform_right_filter_column_0_3_choice_3 : boolean;
    variable raster_next_frame_choice, delay_row_inside_0_is_equal, delay_row_inside_0_value : boolean;
    variable delay_row_inside_0_choice, delay_tag_first_cost_is_equal, delay_tag_map_column_is_less : boolean;
    variable slice0cost_reverse_2_0_is_equal, slice0cost_pair_0_0_is_less, slice0cost_pair_0_1_is_less : boolean;
    variable slice0cost_pair_0_2_is_less, slice0cost_pair_1_0_is_less, slice0cost_pair_1_1_is_less : boolean;
    variable slice0cost_pair_1_2_is_less, slice0cost_pair_2_0_is_equal, slice0cost_pair_2_0_choice : boolean;
    variable slice0cost_pair_2_0_choice_2, slice0cost_pair_2_0_all, slice0other_cost_0_0_all : boolean;
    variable slice0other_cost_0_0_is_not_less, slice0other_cost_0_0_all_2, slice0other_cost_0_1_is_not_less : boolean;
    variable slice0other_cost_1_0_is_not_less, slice0other_cost_1_1_is_not_less : boolean;
    variable slice0other_cost_2_0_is_not_less, slice0other_cost_2_1_is_not_less : boolean;
    variable slice0other_cost_3_0_is_not_less, slice0winner1_cost_0_0_is_less, slice0winner1_cost_1_0_is_less : boolean;
    variable slice0winner1_cost_2_0_is_less, slice0winner1_cost_3_0_is_less, slice0winner2_cost_0_0_is_less : boolean;
    variable slice0winner2_cost_1_0_is_less, slice0winner2_cost_2_0_is_less, slice0winner2_cost_3_0_is_less : boolean;
    variable slice1cost_pair_0_0_is_less, slice1cost_pair_0_1_is_less, slice1cost_pair_0_2_is_less : boolean;
    variable slice1cost_pair_1_0_is_less, slice1cost_pair_1_1_is_less, slice1cost_pair_1_2_is_less : boolean;
    variable slice1other_cost_0_0_any, slice1other_cost_0_0_is_not_less, slice1other_cost_0_1_is_not_less : boolean;
    variable slice1other_cost_0_2_is_not_less, slice1other_cost_1_0_is_not_less : boolean;
    variable slice1other_cost_1_1_is_not_less, slice1other_cost_1_2_is_not_less : boolean;
    variable slice1other_cost_2_0_is_not_less, slice1other_cost_2_1_is_not_less : boolean;
    variable slice1other_cost_2_2_is_not_less, slice1other_cost_3_0_is_not_less : boolean;
    variable slice1other_cost_3_1_is_not_less, slice1other_cost_3_2_is_not_less : boolean;
    variable slice1winner1_cost_0_0_is_less, slice1winner1_cost_1_0_is_less, slice1winner1_cost_2_0_is_less : boolean;
    variable slice1winner1_cost_3_0_is_less, slice1winner2_cost_0_0_is_less, slice1winner2_cost_1_0_is_less : boolean;
    variable slice1winner2_cost_2_0_is_less, slice1winner2_cost_3_0_is_less, slice1best_cost_0_0_is_less : boolean;
    variable slice1best_cost_1_0_is_less, slice1best_cost_2_0_is_less, slice1best_cost_3_0_is_less : boolean;
    variable slice1best_below_0_0_is_equal, slice1best_below_1_0_is_equal, slice1best_below_2_0_is_equal : boolean;
    variable slice1best_below_3_0_is_equal, slice1best_above_0_0_all, slice1best_above_1_0_all : boolean;
    variable slice1best_above_2_0_all, slice1best_above_3_0_all, slice2cost_pair_0_0_is_less : boolean;
    variable slice2cost_pair_0_1_is_less, slice2cost_pair_1_0_is_less, slice2cost_pair_1_1_is_less : boolean;
    variable slice2other_cost_0_1_all, slice2other_cost_0_1_is_not_less, slice2other_cost_0_1_all_2 : boolean;
    variable slice2other_cost_1_1_is_not_less, slice2other_cost_2_1_is_not_less : boolean;
    variable slice2winner1_cost_0_0_is_less, slice2winner1_cost_1_0_is_less, slice2winner1_cost_2_0_is_less : boolean;
    variable slice2winner1_cost_3_0_is_less, slice2best_cost_0_0_is_less, slice2best_cost_1_0_is_less : boolean;
    variable slice2best_cost_2_0_is_less, slice2best_cost_3_0_is_less, slice2best_below_0_0_is_equal : boolean;
    variable slice2best_below_1_0_is_equal, slice2best_below_2_0_is_equal, slice2best_below_3_0_is_equal : boolean;
    variable texturecost_pair_0_0_is_less, texturecost_pair_1_0_is_less, refinement_remainder_0_0_is_less : boolean;
    variable refinement_remainder_0_1_is_less, refinement_remainder_0_2_is_less : boolean;
    variable refinement_remainder_0_3_is_less, refinement_remainder_1_0_is_not_less : boolean;
    variable refinement_remainder_1_1_is_not_less, refinement_remainder_1_2_is_not_less : boolean;
    variable refinement_remainder_1_3_is_not_less, refinement_remainder_2_0_is_not_less : boolean;
    variable refinement_remainder_2_1_is_not_less, refinement_remainder_2_2_is_not_less : boolean;
    variable refinement_remainder_2_3_is_not_less, refinement_remainder_3_0_is_not_less : boolean;
    variable refinement_remainder_3_1_is_not_less, refinement_remainder_3_2_is_not_less : boolean;
    variable refinement_remainder_3_3_is_not_less, refinement_remainder_4_0_is_not_less : boolean;
    variable refinement_remainder_4_1_is_not_less, refinement_remainder_4_2_is_not_less : boolean;
    variable refinement_remainder_4_3_is_not_less, refinement_remainder_5_0_is_not_less : boolean;
    variable refinement_remainder_5_1_is_not_less, refinement_remainder_5_2_is_not_less : boolean;
    variable refinement_remainder_5_3_is_not_less, refinement_remainder_6_0_is_not_less : boolean;
    variable refinement_remainder_6_1_is_not_less, refinement_remainder_6_2_is_not_less : boolean;
    variable refinement_remainder_6_3_is_not_less, refinement_remainder_7_0_is_not_less : boolean;
    variable refinement_remainder_7_1_is_not_less, refinement_remainder_7_2_is_not_less : boolean;
    variable refinement_remainder_7_3_is_not_less, leftright_held_valid_all, median_line_ended_choice : boolean;
    variable median_passed_1_0_all, median_passed_1_0_any, median_complete_is_equal : boolean;
    variable median_median_middle_0_is_less, median_median_middle_1_is_less, median_median_middle_2_is_less : boolean;
    variable median_median_middle_3_is_less, median_out_disparity_0_is_less, median_out_disparity_1_is_less : boolean;
    variable median_out_disparity_2_is_less, median_out_disparity_3_is_less, median_low_0_0_is_less : boolean;
    variable median_low_0_1_is_less, median_low_0_2_is_less, median_low_0_3_is_less, median_low_1_0_all : boolean;
    variable median_middle_0_0_is_less, median_middle_0_1_is_less, median_middle_0_2_is_less : boolean;
    variable median_middle_0_3_is_less : boolean;
    variable transform_counter_group_choice, raster_group_choice, median_counter_group_choice : natural range 0 to 3;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : natural range 0 to 7;
    variable raster_group_choice_2, raster_group_choice_3, slice0other_winner_0_0_choice : natural range 0 to 7;
    variable slice0other_winner_0_0_choice_2, slice0other_winner_0_0_choice_3 : natural range 0 to 7;
    variable slice0other_winner_0_0_choice_4, slice0other_winner_0_0_choice_5 : natural range 0 to 7;
    variable slice0other_winner_0_0_choice_6, slice0other_winner_0_1_choice : natural range 0 to 7;
    variable slice0other_winner_0_1_choice_2, slice0other_winner_0_1_choice_3 : natural range 0 to 7;
    variable slice0other_winner_0_1_choice_4, slice0other_winner_0_1_choice_5 : natural range 0 to 7;
    variable slice0other_winner_0_1_choice_6, slice0other_winner_1_0_choice : natural range 0 to 7;
    variable slice0other_winner_1_0_choice_2, slice0other_winner_1_0_choice_3 : natural range 0 to 7;
    variable slice0other_winner_1_0_choice_4, slice0other_winner_1_0_choice_5 : natural range 0 to 7;
    variable slice0other_winner_1_0_choice_6, slice0other_winner_1_1_choice : natural range 0 to 7;
    variable slice0other_winner_1_1_choice_2, slice0other_winner_1_1_choice_3 : natural range 0 to 7;
    variable slice0other_winner_1_1_choice_4, slice0other_winner_1_1_choice_5 : natural range 0 to 7;
    variable slice0other_winner_1_1_choice_6, slice0other_winner_1_2_choice : natural range 0 to 7;
    variable slice0other_winner_1_2_choice_2, slice0other_winner_1_2_choice_3 : natural range 0 to 7;
    variable slice0other_winner_1_2_choice_4, slice0other_winner_2_0_choice : natural range 0 to 7;
    variable slice0other_winner_2_0_choice_2, slice0other_winner_2_0_choice_3 : natural range 0 to 7;
    variable slice0other_winner_2_0_choice_4, slice0other_winner_2_0_choice_5 : natural range 0 to 7;
    variable slice0other_winner_2_0_choice_6, slice0other_winner_2_1_choice : natural range 0 to 7;
    variable slice0other_winner_2_1_choice_2, slice0other_winner_2_1_choice_3 : natural range 0 to 7;
    variable slice0other_winner_2_1_choice_4, slice0other_winner_2_1_choice_5 : natural range 0 to 7;
    variable slice0other_winner_2_1_choice_6, slice0other_winner_3_0_choice : natural range 0 to 7;
    variable slice0other_winner_3_0_choice_2, slice0other_winner_3_0_choice_3 : natural range 0 to 7;
    variable slice0other_winner_3_0_choice_4, slice0other_winner_3_0_choice_5 : natural range 0 to 7;
    variable slice0other_winner_3_0_choice_6, slice0other_winner_0_2_choice : natural range 0 to 7;
    variable slice0other_winner_0_2_choice_2, slice0other_winner_3_1_choice : natural range 0 to 7;
    variable slice0other_winner_3_1_choice_2, slice1other_winner_0_0_choice : natural range 0 to 7;
    variable slice1other_winner_0_0_choice_2, slice1other_winner_0_0_choice_3 : natural range 0 to 7;
    variable slice1other_winner_0_0_choice_4, slice1other_winner_0_0_choice_5 : natural range 0 to 7;
    variable slice1other_winner_0_1_choice, slice1other_winner_0_1_choice_2 : natural range 0 to 7;
    variable slice1other_winner_0_1_choice_3, slice1other_winner_0_1_choice_4 : natural range 0 to 7;
    variable slice1other_winner_0_1_choice_5, slice1other_winner_0_2_choice : natural range 0 to 7;
    variable slice1other_winner_0_2_choice_2, slice1other_winner_0_2_choice_3 : natural range 0 to 7;
    variable slice1other_winner_0_2_choice_4, slice1other_winner_0_2_choice_5 : natural range 0 to 7;
    variable slice1other_winner_1_0_choice, slice1other_winner_1_0_choice_2 : natural range 0 to 7;
    variable slice1other_winner_1_0_choice_3, slice1other_winner_1_0_choice_4 : natural range 0 to 7;
    variable slice1other_winner_1_0_choice_5, slice1other_winner_1_1_choice : natural range 0 to 7;
    variable slice1other_winner_1_1_choice_2, slice1other_winner_1_1_choice_3 : natural range 0 to 7;
    variable slice1other_winner_1_1_choice_4, slice1other_winner_1_1_choice_5 : natural range 0 to 7;
    variable slice1other_winner_1_2_choice, slice1other_winner_1_2_choice_2 : natural range 0 to 7;
    variable slice1other_winner_1_2_choice_3, slice1other_winner_1_2_choice_4 : natural range 0 to 7;
    variable slice1other_winner_1_2_choice_5, slice1other_winner_2_0_choice : natural range 0 to 7;
    variable slice1other_winner_2_0_choice_2, slice1other_winner_2_0_choice_3 : natural range 0 to 7;
    variable slice1other_winner_2_0_choice_4, slice1other_winner_2_0_choice_5 : natural range 0 to 7;
    variable slice1other_winner_2_1_choice, slice1other_winner_2_1_choice_2 : natural range 0 to 7;
    variable slice1other_winner_2_1_choice_3, slice1other_winner_2_1_choice_4 : natural range 0 to 7;
    variable slice1other_winner_2_1_choice_5, slice1other_winner_2_2_choice : natural range 0 to 7;
    variable slice1other_winner_2_2_choice_2, slice1other_winner_2_2_choice_3 : natural range 0 to 7;
    variable slice1other_winner_2_2_choice_4, slice1other_winner_2_2_choice_5 : natural range 0 to 7;
    variable slice1other_winner_3_0_choice, slice1other_winner_3_0_choice_2 : natural range 0 to 7;
    variable slice1other_winner_3_0_choice_3, slice1other_winner_3_0_choice_4 : natural range 0 to 7;
    variable slice1other_winner_3_0_choice_5, slice1other_winner_3_1_choice : natural range 0 to 7;
    variable slice1other_winner_3_1_choice_2, slice1other_winner_3_1_choice_3 : natural range 0 to 7;
    variable slice1other_winner_3_1_choice_4, slice1other_winner_3_1_choice_5 : natural range 0 to 7;
    variable slice1other_winner_3_2_choice, slice1other_winner_3_2_choice_2 : natural range 0 to 7;
    variable slice2other_winner_0_0_choice, slice2other_winner_0_0_choice_2 : natural range 0 to 7;
    variable slice2other_winner_0_0_choice_3, slice2other_winner_0_0_choice_4 : natural range 0 to 7;
    variable slice2other_winner_0_0_choice_5, slice2other_winner_0_0_choice_6 : natural range 0 to 7;
    variable slice2other_winner_0_1_choice, slice2other_winner_0_1_choice_2 : natural range 0 to 7;
    variable slice2other_winner_0_1_choice_3, slice2other_winner_0_1_choice_4 : natural range 0 to 7;
    variable slice2other_winner_0_1_choice_5, slice2other_winner_0_1_choice_6 : natural range 0 to 7;
    variable slice2other_winner_1_0_choice, slice2other_winner_1_0_choice_2 : natural range 0 to 7;
    variable slice2other_winner_1_0_choice_3, slice2other_winner_1_0_choice_4 : natural range 0 to 7;
    variable slice2other_winner_1_0_choice_5, slice2other_winner_1_0_choice_6 : natural range 0 to 7;
    variable slice2other_winner_1_1_choice, slice2other_winner_1_1_choice_2 : natural range 0 to 7;
    variable slice2other_winner_1_1_choice_3, slice2other_winner_1_1_choice_4 : natural range 0 to 7;
    variable slice2other_winner_1_1_choice_5, slice2other_winner_1_1_choice_6 : natural range 0 to 7;
    variable slice2other_winner_2_0_choice, slice2other_winner_2_0_choice_2 : natural range 0 to 7;
    variable slice2other_winner_2_0_choice_3, slice2other_winner_2_0_choice_4 : natural range 0 to 7;
    variable slice2other_winner_2_0_choice_5, slice2other_winner_2_0_choice_6 : natural range 0 to 7;
    variable slice2other_winner_2_1_choice, slice2other_winner_2_1_choice_2 : natural range 0 to 7;
    variable slice2other_winner_2_1_choice_3, slice2other_winner_2_1_choice_4 : natural range 0 to 7;
    variable slice2other_winner_2_1_choice_5, slice2other_winner_2_1_choice_6 : natural range 0 to 7;
    variable slice2other_winner_3_0_choice, slice2other_winner_3_0_choice_2 : natural range 0 to 7;
    variable slice2other_winner_3_0_choice_3, slice2other_winner_3_0_choice_4 : natural range 0 to 7;
    variable slice2other_winner_3_0_choice_5, slice2other_winner_3_0_choice_6 : natural range 0 to 7;
    variable slice2other_winner_3_1_choice, slice2other_winner_3_1_choice_2 : natural range 0 to 7;
    variable refinement_fraction_0_choice_2, refinement_fraction_1_choice_2 : natural range 0 to 7;
    variable refinement_fraction_2_choice_2, refinement_fraction_3_choice_2 : natural range 0 to 7;
    variable median_counter_group_choice_2, median_counter_group_choice_3 : natural range 0 to 7;
    variable transform_left_filter_feature_0_difference : integer range -1020 to 1020;
    variable transform_left_filter_feature_0_choice : integer range -1020 to 1020;
    variable transform_left_filter_feature_1_difference : integer range -1020 to 1020;
    variable transform_left_filter_feature_1_choice : integer range -1020 to 1020;
    variable transform_left_filter_feature_2_difference : integer range -1020 to 1020;
    variable transform_left_filter_feature_2_choice : integer range -1020 to 1020;
    variable transform_left_filter_feature_3_difference : integer range -1020 to 1020;
    variable transform_left_filter_feature_3_choice : integer range -1020 to 1020;
    variable transform_right_filter_feature_0_difference : integer range -1020 to 1020;
    variable transform_right_filter_feature_0_choice : integer range -1020 to 1020;
    variable transform_right_filter_feature_1_difference : integer range -1020 to 1020;
    variable transform_right_filter_feature_1_choice : integer range -1020 to 1020;
    variable transform_right_filter_feature_2_difference : integer range -1020 to 1020;
    variable transform_right_filter_feature_2_choice : integer range -1020 to 1020;
    variable transform_right_filter_feature_3_difference : integer range -1020 to 1020;
    variable transform_right_filter_feature_3_choice : integer range -1020 to 1020;
    variable transform_left_filter_feature_0_choice_2, transform_left_filter_feature_0_choice_3 : natural range 0 to 63;
    variable transform_left_filter_feature_1_choice_2 : natural range 0 to 255;
    variable transform_left_filter_feature_1_choice_3 : natural range 0 to 255;
    variable transform_left_filter_feature_2_choice_2 : natural range 0 to 255;
    variable transform_left_filter_feature_2_choice_3 : natural range 0 to 255;
    variable transform_left_filter_feature_3_choice_2 : natural range 0 to 255;
    variable transform_left_filter_feature_3_choice_3 : natural range 0 to 255;
    variable transform_right_filter_feature_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_feature_0_choice_3 : natural range 0 to 255;
    variable transform_right_filter_feature_1_choice_2 : natural range 0 to 255;
    variable transform_right_filter_feature_1_choice_3 : natural range 0 to 255;
    variable transform_right_filter_feature_2_choice_2 : natural range 0 to 255;
    variable transform_right_filter_feature_2_choice_3 : natural range 0 to 255;
    variable transform_right_filter_feature_3_choice_2 : natural range 0 to 255;
    variable transform_right_filter_feature_3_choice_3 : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_left_filter_column_0_1_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_1_choice_2 : natural range 0 to 255;
    variable transform_left_filter_column_0_2_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_2_choice_2 : natural range 0 to 255;
    variable transform_left_filter_column_0_3_choice : natural range 0 to 255;
    variable transform_left_filter_column_0_3_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_0_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_1_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_1_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_2_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_2_choice_2 : natural range 0 to 255;
    variable transform_right_filter_column_0_3_choice : natural range 0 to 255;
    variable transform_right_filter_column_0_3_choice_2, slice0cost_pair_0_0_choice : natural range 0 to 255;
    variable slice0cost_pair_0_1_choice, slice0cost_pair_0_2_choice : natural range 0 to 255;
    variable slice0cost_pair_1_0_choice, slice0cost_pair_1_1_choice : natural range 0 to 255;
    variable slice0cost_pair_1_2_choice, slice1cost_pair_0_0_choice : natural range 0 to 255;
    variable slice1cost_pair_0_1_choice, slice1cost_pair_0_2_choice : natural range 0 to 255;
    variable slice1cost_pair_1_0_choice, slice1cost_pair_1_1_choice : natural range 0 to 255;
    variable slice1cost_pair_1_2_choice, slice2cost_pair_0_0_choice : natural range 0 to 255;
    variable slice2cost_pair_0_1_choice, slice2cost_pair_1_0_choice : natural range 0 to 255;
    variable slice2cost_pair_1_1_choice, texturecost_pair_0_0_choice : natural range 0 to 255;
    variable texturecost_pair_1_0_choice, refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_1_choice, refinement_fraction_2_choice : natural range 0 to 255;
    variable refinement_fraction_3_choice : natural range 0 to 255;
    variable slice0cost_pair_1_0_folded_value, slice0cost_pair_1_1_folded_value : natural range 0 to 127;
    variable slice0cost_pair_1_2_folded_value, slice1cost_pair_1_0_folded_value : natural range 0 to 127;
    variable slice1cost_pair_1_1_folded_value, slice1cost_pair_1_2_folded_value : natural range 0 to 127;
    variable slice2cost_pair_1_0_folded_value, slice2cost_pair_1_1_folded_value : natural range 0 to 127;
    variable slice0other_cost_0_0_choice, slice0other_cost_0_0_choice_2 : natural range 0 to 765;
    variable slice0other_cost_0_0_choice_3, slice0other_cost_0_0_choice_4 : natural range 0 to 765;
    variable slice0other_cost_0_0_choice_5, slice0other_cost_0_0_choice_6 : natural range 0 to 765;
    variable slice0other_cost_0_1_choice, slice0other_cost_0_1_choice_2 : natural range 0 to 765;
    variable slice0other_cost_0_1_choice_3, slice0other_cost_0_1_choice_4 : natural range 0 to 765;
    variable slice0other_cost_0_1_choice_5, slice0other_cost_0_2_choice : natural range 0 to 765;
    variable slice0other_cost_0_2_choice_2, slice0other_cost_0_2_choice_3 : natural range 0 to 765;
    variable slice0other_cost_0_2_choice_4, slice0other_cost_1_0_choice : natural range 0 to 765;
    variable slice0other_cost_1_0_choice_2, slice0other_cost_1_0_choice_3 : natural range 0 to 765;
    variable slice0other_cost_1_0_choice_4, slice0other_cost_1_0_choice_5 : natural range 0 to 765;
    variable slice0other_cost_1_0_choice_6, slice0other_cost_1_1_choice : natural range 0 to 765;
    variable slice0other_cost_1_1_choice_2, slice0other_cost_1_1_choice_3 : natural range 0 to 765;
    variable slice0other_cost_1_1_choice_4, slice0other_cost_1_1_choice_5 : natural range 0 to 765;
    variable slice0other_cost_1_2_choice, slice0other_cost_1_2_choice_2 : natural range 0 to 765;
    variable slice0other_cost_1_2_choice_3, slice0other_cost_1_2_choice_4 : natural range 0 to 765;
    variable slice0other_cost_2_0_choice, slice0other_cost_2_0_choice_2 : natural range 0 to 765;
    variable slice0other_cost_2_0_choice_3, slice0other_cost_2_0_choice_4 : natural range 0 to 765;
    variable slice0other_cost_2_0_choice_5, slice0other_cost_2_0_choice_6 : natural range 0 to 765;
    variable slice0other_cost_2_1_choice, slice0other_cost_2_1_choice_2 : natural range 0 to 765;
    variable slice0other_cost_2_1_choice_3, slice0other_cost_2_1_choice_4 : natural range 0 to 765;
    variable slice0other_cost_2_1_choice_5, slice0other_cost_2_2_choice : natural range 0 to 765;
    variable slice0other_cost_2_2_choice_2, slice0other_cost_2_2_choice_3 : natural range 0 to 765;
    variable slice0other_cost_2_2_choice_4, slice0other_cost_3_0_choice : natural range 0 to 765;
    variable slice0other_cost_3_0_choice_2, slice0other_cost_3_0_choice_3 : natural range 0 to 765;
    variable slice0other_cost_3_0_choice_4, slice0other_cost_3_0_choice_5 : natural range 0 to 765;
    variable slice0other_cost_3_0_choice_6, slice0other_cost_3_1_choice : natural range 0 to 765;
    variable slice0other_cost_3_1_choice_2, slice0other_cost_3_1_choice_3 : natural range 0 to 765;
    variable slice0other_cost_3_1_choice_4, slice0other_cost_3_2_choice : natural range 0 to 765;
    variable slice0other_cost_3_2_choice_2, slice0winner2_above_0_0_choice : natural range 0 to 765;
    variable slice0winner2_above_1_0_choice, slice0winner2_above_2_0_choice : natural range 0 to 765;
    variable slice0winner2_above_3_0_choice, slice1other_cost_0_0_choice : natural range 0 to 765;
    variable slice1other_cost_0_0_choice_2, slice1other_cost_0_0_choice_3 : natural range 0 to 765;
    variable slice1other_cost_0_0_choice_4, slice1other_cost_0_0_choice_5 : natural range 0 to 765;
    variable slice1other_cost_0_1_choice, slice1other_cost_0_1_choice_2 : natural range 0 to 765;
    variable slice1other_cost_0_1_choice_3, slice1other_cost_0_1_choice_4 : natural range 0 to 765;
    variable slice1other_cost_0_1_choice_5, slice1other_cost_0_2_choice : natural range 0 to 765;
    variable slice1other_cost_0_2_choice_2, slice1other_cost_0_2_choice_3 : natural range 0 to 765;
    variable slice1other_cost_0_2_choice_4, slice1other_cost_1_0_choice : natural range 0 to 765;
    variable slice1other_cost_1_0_choice_2, slice1other_cost_1_0_choice_3 : natural range 0 to 765;
    variable slice1other_cost_1_0_choice_4, slice1other_cost_1_0_choice_5 : natural range 0 to 765;
    variable slice1other_cost_1_1_choice, slice1other_cost_1_1_choice_2 : natural range 0 to 765;
    variable slice1other_cost_1_1_choice_3, slice1other_cost_1_1_choice_4 : natural range 0 to 765;
    variable slice1other_cost_1_1_choice_5, slice1other_cost_1_2_choice : natural range 0 to 765;
    variable slice1other_cost_1_2_choice_2, slice1other_cost_1_2_choice_3 : natural range 0 to 765;
    variable slice1other_cost_1_2_choice_4, slice1other_cost_2_0_choice : natural range 0 to 765;
    variable slice1other_cost_2_0_choice_2, slice1other_cost_2_0_choice_3 : natural range 0 to 765;
    variable slice1other_cost_2_0_choice_4, slice1other_cost_2_0_choice_5 : natural range 0 to 765;
    variable slice1other_cost_2_1_choice, slice1other_cost_2_1_choice_2 : natural range 0 to 765;
    variable slice1other_cost_2_1_choice_3, slice1other_cost_2_1_choice_4 : natural range 0 to 765;
    variable slice1other_cost_2_1_choice_5, slice1other_cost_2_2_choice : natural range 0 to 765;
    variable slice1other_cost_2_2_choice_2, slice1other_cost_2_2_choice_3 : natural range 0 to 765;
    variable slice1other_cost_2_2_choice_4, slice1other_cost_3_0_choice : natural range 0 to 765;
    variable slice1other_cost_3_0_choice_2, slice1other_cost_3_0_choice_3 : natural range 0 to 765;
    variable slice1other_cost_3_0_choice_4, slice1other_cost_3_0_choice_5 : natural range 0 to 765;
    variable slice1other_cost_3_1_choice, slice1other_cost_3_1_choice_2 : natural range 0 to 765;
    variable slice1other_cost_3_1_choice_3, slice1other_cost_3_1_choice_4 : natural range 0 to 765;
    variable slice1other_cost_3_1_choice_5, slice1other_cost_3_2_choice : natural range 0 to 765;
    variable slice1other_cost_3_2_choice_2, slice1winner2_above_0_0_choice : natural range 0 to 765;
    variable slice1winner2_above_1_0_choice, slice1winner2_above_2_0_choice : natural range 0 to 765;
    variable slice1winner2_above_3_0_choice, slice1best_below_0_0_choice : natural range 0 to 765;
    variable slice1best_below_1_0_choice, slice1best_below_2_0_choice : natural range 0 to 765;
    variable slice1best_below_3_0_choice, slice1best_above_0_0_choice : natural range 0 to 765;
    variable slice1best_above_1_0_choice, slice1best_above_2_0_choice : natural range 0 to 765;
    variable slice1best_above_3_0_choice, slice1best_second_0_0_choice_3 : natural range 0 to 765;
    variable slice1best_second_1_0_choice_3, slice1best_second_2_0_choice_3 : natural range 0 to 765;
    variable slice1best_second_3_0_choice_3, slice2other_cost_0_1_choice : natural range 0 to 765;
    variable slice2other_cost_0_1_choice_2, slice2other_cost_0_1_choice_3 : natural range 0 to 765;
    variable slice2other_cost_0_1_choice_4, slice2other_cost_0_1_choice_5 : natural range 0 to 765;
    variable slice2other_cost_1_1_choice, slice2other_cost_1_1_choice_2 : natural range 0 to 765;
    variable slice2other_cost_1_1_choice_3, slice2other_cost_1_1_choice_4 : natural range 0 to 765;
    variable slice2other_cost_1_1_choice_5, slice2other_cost_2_1_choice : natural range 0 to 765;
    variable slice2other_cost_2_1_choice_2, slice2other_cost_2_1_choice_3 : natural range 0 to 765;
    variable slice2other_cost_2_1_choice_4, slice2other_cost_2_1_choice_5 : natural range 0 to 765;
    variable slice2other_cost_3_1_choice, slice2other_cost_3_1_choice_2 : natural range 0 to 765;
    variable slice2other_cost_3_1_choice_3, slice2other_cost_3_1_choice_4 : natural range 0 to 765;
    variable slice2best_below_0_0_choice, slice2best_below_1_0_choice : natural range 0 to 765;
    variable slice2best_below_2_0_choice, slice2best_below_3_0_choice : natural range 0 to 765;
    variable slice2best_above_0_0_choice, slice2best_above_1_0_choice : natural range 0 to 765;
    variable slice2best_above_2_0_choice, slice2best_above_3_0_choice : natural range 0 to 765;
    variable slice2best_second_0_0_choice, slice2best_second_0_0_choice_3 : natural range 0 to 765;
    variable slice2best_second_1_0_choice, slice2best_second_1_0_choice_3 : natural range 0 to 765;
    variable slice2best_second_2_0_choice, slice2best_second_2_0_choice_3 : natural range 0 to 765;
    variable slice2best_second_3_0_choice, slice2best_second_3_0_choice_3 : natural range 0 to 765;
    variable refinement_remainder_0_0_choice, refinement_remainder_0_0_choice_2 : natural range 0 to 765;
    variable refinement_remainder_0_1_choice, refinement_remainder_0_1_choice_2 : natural range 0 to 765;
    variable refinement_remainder_0_2_choice, refinement_remainder_0_2_choice_2 : natural range 0 to 765;
    variable refinement_remainder_0_3_choice, refinement_remainder_0_3_choice_2 : natural range 0 to 765;
    variable slice0winner2_second_0_0_choice, slice0winner2_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice0winner2_second_1_0_choice, slice0winner2_second_1_0_choice_2 : natural range 0 to 1023;
    variable slice0winner2_second_2_0_choice, slice0winner2_second_2_0_choice_2 : natural range 0 to 1023;
    variable slice0winner2_second_3_0_choice, slice0winner2_second_3_0_choice_2 : natural range 0 to 1023;
    variable slice1winner2_second_0_0_choice, slice1winner2_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice1winner2_second_1_0_choice, slice1winner2_second_1_0_choice_2 : natural range 0 to 1023;
    variable slice1winner2_second_2_0_choice, slice1winner2_second_2_0_choice_2 : natural range 0 to 1023;
    variable slice1winner2_second_3_0_choice, slice1winner2_second_3_0_choice_2 : natural range 0 to 1023;
    variable slice1best_second_0_0_choice, slice1best_second_0_0_choice_2 : natural range 0 to 1023;
    variable slice1best_second_0_0_choice_4, slice1best_second_1_0_choice : natural range 0 to 1023;
    variable slice1best_second_1_0_choice_2, slice1best_second_1_0_choice_4 : natural range 0 to 1023;
    variable slice1best_second_2_0_choice, slice1best_second_2_0_choice_2 : natural range 0 to 1023;
    variable slice1best_second_2_0_choice_4, slice1best_second_3_0_choice : natural range 0 to 1023;
    variable slice1best_second_3_0_choice_2, slice1best_second_3_0_choice_4 : natural range 0 to 1023;
    variable slice2best_second_0_0_choice_2, slice2best_second_0_0_choice_4 : natural range 0 to 1023;
    variable slice2best_second_1_0_choice_2, slice2best_second_1_0_choice_4 : natural range 0 to 1023;
    variable slice2best_second_2_0_choice_2, slice2best_second_2_0_choice_4 : natural range 0 to 1023;
    variable slice2best_second_3_0_choice_2, slice2best_second_3_0_choice_4 : natural range 0 to 1023;
    variable refinement_remainder_0_0_value, refinement_remainder_0_0_value_2 : natural range 0 to 1023;
    variable refinement_remainder_0_0_choice_3, refinement_remainder_0_0_choice_4 : natural range 0 to 1023;
    variable refinement_remainder_0_1_value, refinement_remainder_0_1_value_2 : natural range 0 to 1023;
    variable refinement_remainder_0_1_choice_3, refinement_remainder_0_1_choice_4 : natural range 0 to 1023;
    variable refinement_remainder_0_2_value, refinement_remainder_0_2_value_2 : natural range 0 to 1023;
    variable refinement_remainder_0_2_choice_3, refinement_remainder_0_2_choice_4 : natural range 0 to 1023;
    variable refinement_remainder_0_3_value, refinement_remainder_0_3_value_2 : natural range 0 to 1023;
    variable refinement_remainder_0_3_choice_3, refinement_remainder_0_3_choice_4 : natural range 0 to 1023;
    variable refinement_remainder_1_0_choice, refinement_remainder_1_1_choice : natural range 0 to 1023;
    variable refinement_remainder_1_2_choice, refinement_remainder_1_3_choice : natural range 0 to 1023;
    variable refinement_remainder_2_0_choice, refinement_remainder_2_1_choice : natural range 0 to 1023;
    variable refinement_remainder_2_2_choice, refinement_remainder_2_3_choice : natural range 0 to 1023;
    variable refinement_remainder_3_0_choice, refinement_remainder_3_1_choice : natural range 0 to 1023;
    variable refinement_remainder_3_2_choice, refinement_remainder_3_3_choice : natural range 0 to 1023;
    variable refinement_remainder_4_0_choice, refinement_remainder_4_1_choice : natural range 0 to 1023;
    variable refinement_remainder_4_2_choice, refinement_remainder_4_3_choice : natural range 0 to 1023;
    variable refinement_remainder_5_0_choice, refinement_remainder_5_1_choice : natural range 0 to 1023;
    variable refinement_remainder_5_2_choice, refinement_remainder_5_3_choice : natural range 0 to 1023;
    variable refinement_remainder_6_0_choice, refinement_remainder_6_1_choice : natural range 0 to 1023;
    variable refinement_remainder_6_2_choice, refinement_remainder_6_3_choice : natural range 0 to 1023;
    variable refinement_remainder_7_0_choice, refinement_remainder_7_1_choice : natural range 0 to 1023;
    variable refinement_remainder_7_2_choice, refinement_remainder_7_3_choice : natural range 0 to 1023;
    variable slice1best_index_0_0_sum, slice1best_index_1_0_sum, slice1best_index_2_0_sum : natural range 1 to 2;
    variable slice1best_index_3_0_sum : natural range 1 to 2;
    variable texturecost_pair_1_0_folded_value : natural range 0 to 126;
    variable refinement_fraction_0_difference, refinement_fraction_1_difference : integer range -15 to 0;
    variable refinement_fraction_2_difference, refinement_fraction_3_difference : integer range -15 to 0;
    variable refinement_fraction_0_value, refinement_fraction_1_value : natural range 0 to 16;
    variable refinement_fraction_2_value, refinement_fraction_3_value : natural range 0 to 16;
    variable leftright_address_0_value, leftright_address_1_value : natural range 0 to 15;
    variable leftright_checked_passed_0_difference, leftright_checked_passed_1_difference : integer range -6 to 16;
    variable leftright_checked_passed_2_difference, leftright_checked_passed_3_difference : integer range -6 to 16;
    variable median_largest_low_0_choice, median_largest_low_1_choice : natural range 0 to 4095;
    variable median_largest_low_2_choice, median_largest_low_3_choice : natural range 0 to 4095;
    variable median_median_middle_0_choice, median_median_middle_0_choice_2 : natural range 0 to 4095;
    variable median_median_middle_0_choice_3, median_median_middle_1_choice : natural range 0 to 4095;
    variable median_median_middle_1_choice_2, median_median_middle_1_choice_3 : natural range 0 to 4095;
    variable median_median_middle_2_choice, median_median_middle_2_choice_2 : natural range 0 to 4095;
    variable median_median_middle_2_choice_3, median_median_middle_3_choice : natural range 0 to 4095;
    variable median_median_middle_3_choice_2, median_median_middle_3_choice_3 : natural range 0 to 4095;
    variable median_smallest_high_0_choice, median_smallest_high_1_choice : natural range 0 to 4095;
    variable median_smallest_high_2_choice, median_out_disparity_0_choice : natural range 0 to 4095;
    variable median_out_disparity_0_choice_2, median_out_disparity_0_choice_3 : natural range 0 to 4095;
    variable median_out_disparity_1_choice, median_out_disparity_1_choice_2 : natural range 0 to 4095;
    variable median_out_disparity_1_choice_3, median_out_disparity_2_choice : natural range 0 to 4095;
    variable median_out_disparity_2_choice_2, median_out_disparity_2_choice_3 : natural range 0 to 4095;
    variable median_out_disparity_3_choice, median_out_disparity_3_choice_3 : natural range 0 to 4095;
    variable median_low_0_0_choice, median_low_0_0_choice_2, median_low_0_0_choice_3 : natural range 0 to 4095;
    variable median_low_0_0_choice_4, median_low_0_1_choice, median_low_0_1_choice_2 : natural range 0 to 4095;
    variable median_low_0_1_choice_3, median_low_0_2_choice, median_low_0_2_choice_2 : natural range 0 to 4095;
    variable median_low_0_2_choice_3, median_low_0_3_choice_2, median_low_0_3_choice_3 : natural range 0 to 4095;
    variable median_low_0_3_choice_4, median_low_0_3_choice_5, median_middle_0_0_choice : natural range 0 to 4095;
    variable median_middle_0_0_choice_2, median_middle_0_0_choice_3 : natural range 0 to 4095;
    variable median_middle_0_0_choice_4, median_middle_0_1_choice, median_middle_0_1_choice_2 : natural range 0 to 4095;
    variable median_middle_0_1_choice_3, median_middle_0_1_choice_4, median_middle_0_2_choice : natural range 0 to 4095;
    variable median_middle_0_2_choice_2, median_middle_0_2_choice_3 : natural range 0 to 4095;
    variable median_middle_0_2_choice_4, median_middle_0_3_choice, median_middle_0_3_choice_2 : natural range 0 to 4095;
    variable median_middle_0_3_choice_3, median_middle_0_3_choice_4, median_high_0_0_choice : natural range 0 to 4095;
    variable median_high_0_0_choice_2, median_high_0_1_choice, median_high_0_1_choice_2 : natural range 0 to 4095;
    variable median_high_0_2_choice, median_high_0_2_choice_2 : natural range 0 to 4095;
    variable median_smallest_high_3_choice, median_out_disparity_3_choice_2 : natural range 0 to 32767;
    variable median_low_0_3_choice, median_high_0_3_choice, median_high_0_3_choice_2 : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 31;
      transform_counter_group_is_equal_2 := transform_counter_group = 2;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      transform_counter_group_choice := 3 when transform_counter_group_all else 0;
      transform_counter_group_is_equal_3 := transform_counter_group = 3;
      transform_counter_group_choice_2 := 1 when raster_next_frame and transform_counter_group_is_equal_3 else
        (transform_counter_group + 1) mod 8;
      transform_counter_group_choice_3 := transform_counter_group_choice_2 when (transform_counter_group /= 4) and
        transform_counter_group_is_equal and in_valid else transform_counter_group;
      transform_read_row_inside_0_is_equal := (transform_counter_group / 2) = 1;
      transform_read_row_inside_0_value := ((transform_counter_group / 2) mod 2) = 1;
      transform_read_row_inside_0_choice := not transform_read_row_inside_0_value when (transform_counter_group / 4) =
        1 else transform_read_row_inside_0_value;
      transform_read_column_inside_0_differs := (transform_counter_column / 2) /= 0;
      transform_left_filter_feature_0_all := transform_filtering_column_inside_2 and
        transform_filtering_column_inside_0;
      transform_left_filter_feature_0_difference := transform_left_filter_column_0_0 - transform_left_filter_column_2_0;
      transform_left_filter_feature_0_is_less := transform_left_filter_feature_0_difference < (-31);
      transform_left_filter_feature_0_choice := -31 when transform_left_filter_feature_0_is_less else
        transform_left_filter_feature_0_difference;
      transform_left_filter_feature_0_choice_2 := 33 when transform_left_filter_feature_0_is_less else
        transform_left_filter_feature_0_difference mod 64;
      transform_left_filter_feature_0_choice_3 := transform_left_filter_feature_0_choice_2 when
        transform_left_filter_feature_0_choice < 31 else 31;
      transform_left_filter_feature_1_difference := transform_left_filter_column_0_1 - transform_left_filter_column_2_1;
      transform_left_filter_feature_1_is_less := transform_left_filter_feature_1_difference < (-31);
      transform_left_filter_feature_1_choice := -31 when transform_left_filter_feature_1_is_less else
        transform_left_filter_feature_1_difference;
      transform_left_filter_feature_1_choice_2 := 225 when transform_left_filter_feature_1_is_less else
        transform_left_filter_feature_1_difference mod 256;
      transform_left_filter_feature_1_choice_3 := transform_left_filter_feature_1_choice_2 when
        transform_left_filter_feature_1_choice < 31 else 31;
      transform_left_filter_feature_2_difference := transform_left_filter_column_0_2 - transform_left_filter_column_2_2;
      transform_left_filter_feature_2_is_less := transform_left_filter_feature_2_difference < (-31);
      transform_left_filter_feature_2_choice := -31 when transform_left_filter_feature_2_is_less else
        transform_left_filter_feature_2_difference;
      transform_left_filter_feature_2_choice_2 := 225 when transform_left_filter_feature_2_is_less else
        transform_left_filter_feature_2_difference mod 256;
      transform_left_filter_feature_2_choice_3 := transform_left_filter_feature_2_choice_2 when
        transform_left_filter_feature_2_choice < 31 else 31;
      transform_left_filter_feature_3_difference := transform_left_filter_column_0_3 - transform_left_filter_column_2_3;
      transform_left_filter_feature_3_is_less := transform_left_filter_feature_3_difference < (-31);
      transform_left_filter_feature_3_choice := -31 when transform_left_filter_feature_3_is_less else
        transform_left_filter_feature_3_difference;
      transform_left_filter_feature_3_choice_2 := 225 when transform_left_filter_feature_3_is_less else
        transform_left_filter_feature_3_difference mod 256;
      transform_left_filter_feature_3_choice_3 := transform_left_filter_feature_3_choice_2 when
        transform_left_filter_feature_3_choice < 31 else 31;
      transform_right_filter_feature_0_difference := transform_right_filter_column_0_0 -
        transform_right_filter_column_2_0;
      transform_right_filter_feature_0_is_less := transform_right_filter_feature_0_difference < (-31);
      transform_right_filter_feature_0_choice := -31 when transform_right_filter_feature_0_is_less else
        transform_right_filter_feature_0_difference;
      transform_right_filter_feature_0_choice_2 := 225 when transform_right_filter_feature_0_is_less else
        transform_right_filter_feature_0_difference mod 256;
      transform_right_filter_feature_0_choice_3 := transform_right_filter_feature_0_choice_2 when
        transform_right_filter_feature_0_choice < 31 else 31;
      transform_right_filter_feature_1_difference := transform_right_filter_column_0_1 -
        transform_right_filter_column_2_1;
      transform_right_filter_feature_1_is_less := transform_right_filter_feature_1_difference < (-31);
      transform_right_filter_feature_1_choice := -31 when transform_right_filter_feature_1_is_less else
        transform_right_filter_feature_1_difference;
      transform_right_filter_feature_1_choice_2 := 225 when transform_right_filter_feature_1_is_less else
        transform_right_filter_feature_1_difference mod 256;
      transform_right_filter_feature_1_choice_3 := transform_right_filter_feature_1_choice_2 when
        transform_right_filter_feature_1_choice < 31 else 31;
      transform_right_filter_feature_2_difference := transform_right_filter_column_0_2 -
        transform_right_filter_column_2_2;
      transform_right_filter_feature_2_is_less := transform_right_filter_feature_2_difference < (-31);
      transform_right_filter_feature_2_choice := -31 when transform_right_filter_feature_2_is_less else
        transform_right_filter_feature_2_difference;
      transform_right_filter_feature_2_choice_2 := 225 when transform_right_filter_feature_2_is_less else
        transform_right_filter_feature_2_difference mod 256;
      transform_right_filter_feature_2_choice_3 := transform_right_filter_feature_2_choice_2 when
        transform_right_filter_feature_2_choice < 31 else 31;
      transform_right_filter_feature_3_difference := transform_right_filter_column_0_3 -
        transform_right_filter_column_2_3;
      transform_right_filter_feature_3_is_less := transform_right_filter_feature_3_difference < (-31);
      transform_right_filter_feature_3_choice := -31 when transform_right_filter_feature_3_is_less else
        transform_right_filter_feature_3_difference;
      transform_right_filter_feature_3_choice_2 := 225 when transform_right_filter_feature_3_is_less else
        transform_right_filter_feature_3_difference mod 256;
      transform_right_filter_feature_3_choice_3 := transform_right_filter_feature_3_choice_2 when
        transform_right_filter_feature_3_choice < 31 else 31;
      transform_left_0 <= to_integer(in_left_pixel(7 downto 0));
      transform_left_1 <= to_integer(in_left_pixel(15 downto 8));
      transform_left_2 <= to_integer(in_left_pixel(23 downto 16));
      transform_left_3 <= to_integer(in_left_pixel(31 downto 24));
      transform_right_0 <= to_integer(in_right_pixel(7 downto 0));
      transform_right_1 <= to_integer(in_right_pixel(15 downto 8));
      transform_right_2 <= to_integer(in_right_pixel(23 downto 16));
      transform_right_3 <= to_integer(in_right_pixel(31 downto 24));
      transform_valid <= in_valid;
      transform_counter_group <= transform_counter_group_choice when in_valid and in_start_of_frame else
        transform_counter_group_choice_3;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_read_newest_1 <= transform_left_1;
      transform_left_rows_read_newest_2 <= transform_left_2;
      transform_left_rows_read_newest_3 <= transform_left_3;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_words_1 <= to_integer(transform_left_rows_read_words_1);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_left_rows_ready_newest_1 <= transform_left_rows_read_newest_1;
      transform_left_rows_ready_newest_2 <= transform_left_rows_read_newest_2;
      transform_left_rows_ready_newest_3 <= transform_left_rows_read_newest_3;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_read_newest_1 <= transform_right_1;
      transform_right_rows_read_newest_2 <= transform_right_2;
      transform_right_rows_read_newest_3 <= transform_right_3;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_words_1 <= to_integer(transform_right_rows_read_words_1);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_right_rows_ready_newest_1 <= transform_right_rows_read_newest_1;
      transform_right_rows_ready_newest_2 <= transform_right_rows_read_newest_2;
      transform_right_rows_ready_newest_3 <= transform_right_rows_read_newest_3;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= transform_read_row_inside_0_is_equal when (transform_counter_group mod 2) = 1 else
        transform_read_row_inside_0_choice;
      transform_read_row_inside_1 <= not ((transform_counter_group / 4) = 1) when (transform_counter_group mod 2) = 1
        else transform_read_row_inside_0_is_equal;
      transform_read_row_inside_5 <= (transform_counter_group / 2) = 0 when (transform_counter_group mod 2) = 1 else
        not ((transform_counter_group / 4) = 1);
      transform_read_column_inside_0 <= transform_read_column_inside_0_differs or ((transform_counter_column mod 2) =
        1);
      transform_read_column_inside_2 <= transform_read_column_inside_0_differs or (not ((transform_counter_column mod
        2) = 1));
      transform_read_start_of_frame <= (transform_counter_column = 1) and (transform_counter_group = 1);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_1 <= transform_read_row_inside_1;
      transform_ready_row_inside_5 <= transform_read_row_inside_5;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column_1 <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column_2 <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column_3 <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column_4 <= transform_left_rows_ready_words_1;
      transform_left_column_5 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_1 <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_3 <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column_4 <= transform_right_rows_ready_words_1;
      transform_right_column_5 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_1 <= transform_ready_row_inside_1;
      transform_columns_row_inside_5 <= transform_ready_row_inside_5;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_3 + 31) mod 64 when
        transform_left_filter_feature_0_all else 31;
      transform_left_filter_feature_1 <= (transform_left_filter_feature_1_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_left_filter_feature_2 <= (transform_left_filter_feature_2_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_left_filter_feature_3 <= (transform_left_filter_feature_3_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_right_filter_feature_1 <= (transform_right_filter_feature_1_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_right_filter_feature_2 <= (transform_right_filter_feature_2_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_right_filter_feature_3 <= (transform_right_filter_feature_3_choice_3 + 31) mod 256 when
        transform_left_filter_feature_0_all else 31;
      transform_filtering_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_valid <= transform_columns_valid;
      transform_filtered_start_of_frame <= transform_filtering_start_of_frame;
      transform_filtered_valid <= transform_filtering_valid;
      if in_valid then
        transform_counter_column <= 0 when transform_counter_group_is_equal or in_start_of_frame else
          (transform_counter_column + 1) mod 32;
      end if;
      transform_counter_next_frame_is_equal := raster_column = 31;
      transform_counter_next_frame_is_equal_2 := raster_group = 3;
      transform_counter_next_frame_is_equal_3 := raster_group = 2;
      transform_counter_next_frame_all := transform_counter_next_frame_is_equal and
        transform_counter_next_frame_is_equal_3;
      transform_counter_next_frame_choice := transform_counter_next_frame_all when transform_filtered_start_of_frame
        else transform_counter_next_frame;
      if transform_filtered_valid then
        transform_counter_next_frame <= transform_counter_next_frame_is_equal and
          transform_counter_next_frame_is_equal_3 and transform_filtered_start_of_frame when
          transform_counter_next_frame_is_equal and transform_counter_next_frame_is_equal_2 else
          transform_counter_next_frame_choice;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_2, 8) &
          to_unsigned(transform_left_rows_ready_newest_1, 8) & to_unsigned(transform_left_rows_ready_newest_0, 8) &
          to_unsigned(transform_left_rows_ready_words_1, 8);
        transform_left_rows_write_words_1 <= transform_left_rows_ready_newest_3;
        transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_2, 8) &
          to_unsigned(transform_right_rows_ready_newest_1, 8) & to_unsigned(transform_right_rows_ready_newest_0, 8) &
          to_unsigned(transform_right_rows_ready_words_1, 8);
        transform_right_rows_write_words_1 <= transform_right_rows_ready_newest_3;
        transform_write_column <= transform_ready_column;
      end if;
      transform_left_filter_column_0_0_choice := transform_left_column_0 when transform_columns_row_inside_0 else
        transform_left_column_2;
      transform_left_filter_column_0_0_choice_2 := transform_left_column_2 when transform_columns_row_inside_1 else
        transform_left_column_0;
      transform_left_filter_column_0_0_choice_3 := (transform_left_column_2 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_left_column_0 mod 2) = 1;
      transform_left_filter_column_0_1_choice := transform_left_column_1 when transform_columns_row_inside_1 else
        transform_left_column_3;
      transform_left_filter_column_0_1_choice_2 := transform_left_column_3 when transform_columns_row_inside_1 else
        transform_left_column_1;
      transform_left_filter_column_0_1_choice_3 := (transform_left_column_3 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_left_column_1 mod 2) = 1;
      transform_left_filter_column_0_2_choice := transform_left_column_2 when transform_columns_row_inside_1 else
        transform_left_column_4;
      transform_left_filter_column_0_2_choice_2 := transform_left_column_4 when transform_columns_row_inside_1 else
        transform_left_column_2;
      transform_left_filter_column_0_2_choice_3 := (transform_left_column_4 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_left_column_2 mod 2) = 1;
      transform_left_filter_column_0_3_choice := transform_left_column_3 when transform_columns_row_inside_1 else
        transform_left_column_5;
      transform_left_filter_column_0_3_choice_2 := transform_left_column_5 when transform_columns_row_inside_5 else
        transform_left_column_3;
      transform_left_filter_column_0_3_choice_3 := (transform_left_column_5 mod 2) = 1 when
        transform_columns_row_inside_5 else (transform_left_column_3 mod 2) = 1;
      transform_right_filter_column_0_0_choice := transform_right_column_0 when transform_columns_row_inside_0 else
        transform_right_column_2;
      transform_right_filter_column_0_0_choice_2 := transform_right_column_2 when transform_columns_row_inside_1 else
        transform_right_column_0;
      transform_right_filter_column_0_0_choice_3 := (transform_right_column_2 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_right_column_0 mod 2) = 1;
      transform_right_filter_column_0_1_choice := transform_right_column_1 when transform_columns_row_inside_1 else
        transform_right_column_3;
      transform_right_filter_column_0_1_choice_2 := transform_right_column_3 when transform_columns_row_inside_1 else
        transform_right_column_1;
      transform_right_filter_column_0_1_choice_3 := (transform_right_column_3 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_right_column_1 mod 2) = 1;
      transform_right_filter_column_0_2_choice := transform_right_column_2 when transform_columns_row_inside_1 else
        transform_right_column_4;
      transform_right_filter_column_0_2_choice_2 := transform_right_column_4 when transform_columns_row_inside_1 else
        transform_right_column_2;
      transform_right_filter_column_0_2_choice_3 := (transform_right_column_4 mod 2) = 1 when
        transform_columns_row_inside_1 else (transform_right_column_2 mod 2) = 1;
      transform_right_filter_column_0_3_choice := transform_right_column_3 when transform_columns_row_inside_1 else
        transform_right_column_5;
      transform_right_filter_column_0_3_choice_2 := transform_right_column_5 when transform_columns_row_inside_5 else
        transform_right_column_3;
      transform_right_filter_column_0_3_choice_3 := (transform_right_column_5 mod 2) = 1 when
        transform_columns_row_inside_5 else (transform_right_column_3 mod 2) = 1;
      if transform_columns_valid then
        transform_left_filter_column_0_0 <= transform_left_filter_column_0_0_choice +
          (((transform_left_filter_column_0_0_choice_2 / 2) + transform_left_column_1) * 2) +
          as_number(transform_left_filter_column_0_0_choice_3);
        transform_left_filter_column_0_1 <= transform_left_filter_column_0_1_choice +
          (((transform_left_filter_column_0_1_choice_2 / 2) + transform_left_column_2) * 2) +
          as_number(transform_left_filter_column_0_1_choice_3);
        transform_left_filter_column_0_2 <= transform_left_filter_column_0_2_choice +
          (((transform_left_filter_column_0_2_choice_2 / 2) + transform_left_column_3) * 2) +
          as_number(transform_left_filter_column_0_2_choice_3);
        transform_left_filter_column_0_3 <= transform_left_filter_column_0_3_choice +
          (((transform_left_filter_column_0_3_choice_2 / 2) + transform_left_column_4) * 2) +
          as_number(transform_left_filter_column_0_3_choice_3);
        transform_left_filter_column_1_0 <= transform_left_filter_column_0_0;
        transform_left_filter_column_1_1 <= transform_left_filter_column_0_1;
        transform_left_filter_column_1_2 <= transform_left_filter_column_0_2;
        transform_left_filter_column_1_3 <= transform_left_filter_column_0_3;
        transform_left_filter_column_2_0 <= transform_left_filter_column_1_0;
        transform_left_filter_column_2_1 <= transform_left_filter_column_1_1;
        transform_left_filter_column_2_2 <= transform_left_filter_column_1_2;
        transform_left_filter_column_2_3 <= transform_left_filter_column_1_3;
        transform_right_filter_column_0_0 <= transform_right_filter_column_0_0_choice +
          (((transform_right_filter_column_0_0_choice_2 / 2) + transform_right_column_1) * 2) +
          as_number(transform_right_filter_column_0_0_choice_3);
        transform_right_filter_column_0_1 <= transform_right_filter_column_0_1_choice +
          (((transform_right_filter_column_0_1_choice_2 / 2) + transform_right_column_2) * 2) +
          as_number(transform_right_filter_column_0_1_choice_3);
        transform_right_filter_column_0_2 <= transform_right_filter_column_0_2_choice +
          (((transform_right_filter_column_0_2_choice_2 / 2) + transform_right_column_3) * 2) +
          as_number(transform_right_filter_column_0_2_choice_3);
        transform_right_filter_column_0_3 <= transform_right_filter_column_0_3_choice +
          (((transform_right_filter_column_0_3_choice_2 / 2) + transform_right_column_4) * 2) +
          as_number(transform_right_filter_column_0_3_choice_3);
        transform_right_filter_column_1_0 <= transform_right_filter_column_0_0;
        transform_right_filter_column_1_1 <= transform_right_filter_column_0_1;
        transform_right_filter_column_1_2 <= transform_right_filter_column_0_2;
        transform_right_filter_column_1_3 <= transform_right_filter_column_0_3;
        transform_right_filter_column_2_0 <= transform_right_filter_column_1_0;
        transform_right_filter_column_2_1 <= transform_right_filter_column_1_1;
        transform_right_filter_column_2_2 <= transform_right_filter_column_1_2;
        transform_right_filter_column_2_3 <= transform_right_filter_column_1_3;
      end if;
      -- raster
      raster_group_choice := 3 when transform_counter_next_frame_all else 0;
      raster_group_choice_2 := 1 when transform_counter_next_frame and transform_counter_next_frame_is_equal_2 else
        (raster_group + 1) mod 8;
      raster_group_choice_3 := raster_group_choice_2 when (raster_group /= 4) and transform_counter_next_frame_is_equal
        and transform_filtered_valid else raster_group;
      raster_search_0 <= transform_left_filter_feature_0;
      raster_search_1 <= transform_left_filter_feature_1;
      raster_search_2 <= transform_left_filter_feature_2;
      raster_search_3 <= transform_left_filter_feature_3;
      raster_reference_0 <= transform_right_filter_feature_0;
      raster_reference_1 <= transform_right_filter_feature_1;
      raster_reference_2 <= transform_right_filter_feature_2;
      raster_reference_3 <= transform_right_filter_feature_3;
      raster_valid <= transform_filtered_valid;
      raster_group <= raster_group_choice when transform_filtered_valid and transform_filtered_start_of_frame else
        raster_group_choice_3;
      if transform_filtered_valid then
        raster_column <= 0 when transform_counter_next_frame_is_equal or transform_filtered_start_of_frame else
          (raster_column + 1) mod 32;
      end if;
      raster_next_frame_choice := transform_counter_group_all when in_start_of_frame else raster_next_frame;
      if in_valid then
        raster_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
          in_start_of_frame when transform_counter_group_is_equal and transform_counter_group_is_equal_3 else
          raster_next_frame_choice;
      end if;
      -- delay
      if raster_valid then
        delay_read_address <= 0 when delay_read_address = 7 else (delay_read_address + 1) mod 8;
        delay_write_address <= delay_read_address;
      end if;
      delay_row_inside_0_is_equal := (raster_group / 2) = 1;
      delay_row_inside_0_value := ((raster_group / 2) mod 2) = 1;
      delay_row_inside_0_choice := not delay_row_inside_0_value when (raster_group / 4) = 1 else
        delay_row_inside_0_value;
      delay_tag_first_cost_is_equal := raster_column = 7;
      delay_tag_map_column_is_less := ((raster_column + 65529) mod 65536) < 24;
      delay_ahead_0 <= raster_search_0;
      delay_ahead_1 <= raster_search_1;
      delay_ahead_2 <= raster_search_2;
      delay_ahead_3 <= raster_search_3;
      delay_column <= raster_column;
      delay_row_inside_0 <= delay_row_inside_0_is_equal when (raster_group mod 2) = 1 else delay_row_inside_0_choice;
      delay_row_inside_1 <= not ((raster_group / 4) = 1) when (raster_group mod 2) = 1 else delay_row_inside_0_is_equal;
      delay_row_inside_5 <= (raster_group / 2) = 0 when (raster_group mod 2) = 1 else not ((raster_group / 4) = 1);
      delay_tag_valid <= raster_valid;
      delay_tag_border_column <= (raster_column / 4) = 0 when (raster_column mod 4) = 3 else (raster_column / 8) = 0;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_less;
      delay_tag_output_column <= (((raster_group + 65535) mod 65536) < 3) and delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_group = 1);
      delay_tag_end_of_line <= raster_column = 30;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_read_newest_1 <= delay_ahead_1;
      rows_search_rows_read_newest_2 <= delay_ahead_2;
      rows_search_rows_read_newest_3 <= delay_ahead_3;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_search_rows_ready_newest_2 <= rows_search_rows_read_newest_2;
      rows_search_rows_ready_newest_3 <= rows_search_rows_read_newest_3;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0(6 downto 0));
      rows_reference_rows_read_newest_1 <= to_integer(delay_delayed_0(13 downto 7));
      rows_reference_rows_read_newest_2 <= to_integer(delay_delayed_0(20 downto 14));
      rows_reference_rows_read_newest_3 <= to_integer(delay_delayed_0(27 downto 21));
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_reference_rows_ready_newest_2 <= rows_reference_rows_read_newest_2;
      rows_reference_rows_ready_newest_3 <= rows_reference_rows_read_newest_3;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_5 <= delay_row_inside_5;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_5 <= rows_read_inside_5;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_first_cost <= rows_read_tag_first_cost;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_search_0 <= rows_search_rows_ready_words_0 mod 128 when rows_ready_inside_0 else 0;
      rows_search_1 <= (rows_search_rows_ready_words_0 / 128) mod 64 when rows_ready_inside_1 else 0;
      rows_search_2 <= (rows_search_rows_ready_words_0 / 16384) mod 128 when rows_ready_inside_1 else 0;
      rows_search_3 <= rows_search_rows_ready_words_0 / 2097152 when rows_ready_inside_1 else 0;
      rows_search_4 <= rows_search_rows_ready_words_1 when rows_ready_inside_1 else 0;
      rows_search_5 <= rows_search_rows_ready_newest_0 when rows_ready_inside_5 else 0;
      rows_reference_0 <= rows_reference_rows_ready_words_0 mod 128 when rows_ready_inside_0 else 0;
      rows_reference_1 <= (rows_reference_rows_ready_words_0 / 128) mod 128 when rows_ready_inside_1 else 0;
      rows_reference_2 <= (rows_reference_rows_ready_words_0 / 16384) mod 128 when rows_ready_inside_1 else 0;
      rows_reference_3 <= rows_reference_rows_ready_words_0 / 2097152 when rows_ready_inside_1 else 0;
      rows_reference_4 <= rows_reference_rows_ready_words_1 when rows_ready_inside_1 else 0;
      rows_reference_5 <= rows_reference_rows_ready_newest_0 when rows_ready_inside_5 else 0;
      rows_inside_0 <= rows_ready_inside_0;
      rows_inside_1 <= rows_ready_inside_1;
      rows_inside_5 <= rows_ready_inside_5;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= to_integer(((((to_unsigned(rows_search_rows_ready_newest_1, 15) &
          to_unsigned(0, 14)) or (to_unsigned(rows_search_rows_ready_newest_2, 8) & to_unsigned(0, 21)))) or
          (to_unsigned(rows_search_rows_ready_newest_0, 22) & to_unsigned(rows_search_rows_ready_words_1, 7))));
        rows_search_rows_write_words_1 <= rows_search_rows_ready_newest_3;
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_newest_1 * 16384) +
          (rows_reference_rows_ready_newest_2 * 2097152) + (rows_reference_rows_ready_newest_0 * 128) +
          rows_reference_rows_ready_words_1;
        rows_reference_rows_write_words_1 <= rows_reference_rows_ready_newest_3;
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
        slice0shift_search_3_0 <= slice0shift_search_3_1;
        slice0shift_search_3_1 <= slice0shift_search_3_2;
        slice0shift_search_3_2 <= rows_search_3;
        slice0shift_search_4_0 <= slice0shift_search_4_1;
        slice0shift_search_4_1 <= slice0shift_search_4_2;
        slice0shift_search_4_2 <= rows_search_4;
        slice0shift_search_5_0 <= slice0shift_search_5_1;
        slice0shift_search_5_1 <= slice0shift_search_5_2;
        slice0shift_search_5_2 <= rows_search_5;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_reference_4 <= rows_reference_4;
      slice0shift_reference_5 <= rows_reference_5;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
      slice0shift_search_out_4 <= slice0shift_search_4_0;
      slice0shift_search_out_5 <= slice0shift_search_5_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_reverse_2_0_is_equal := median_counter_group = 3;
      slice0cost_pair_0_0_is_less := slice0cost_difference_2_0 < 0;
      slice0cost_pair_0_0_choice := slice0cost_reverse_0_0 when slice0cost_pair_0_0_is_less else
        positive_part(slice0cost_difference_2_0);
      slice0cost_pair_0_1_is_less := slice0cost_difference_2_1 < 0;
      slice0cost_pair_0_1_choice := slice0cost_reverse_0_1 when slice0cost_pair_0_1_is_less else
        positive_part(slice0cost_difference_2_1);
      slice0cost_pair_0_2_is_less := slice0cost_difference_2_2 < 0;
      slice0cost_pair_0_2_choice := slice0cost_reverse_0_2 when slice0cost_pair_0_2_is_less else
        positive_part(slice0cost_difference_2_2);
      slice0cost_pair_1_0_choice := slice0cost_reverse_1_0 when slice0cost_difference_4_0 < 0 else
        positive_part(slice0cost_difference_4_0);
      slice0cost_pair_1_0_folded_value := folded(slice0cost_difference_3_0);
      slice0cost_pair_1_0_is_less := slice0cost_difference_3_0 < 0;
      slice0cost_pair_1_1_choice := slice0cost_reverse_1_1 when slice0cost_difference_4_1 < 0 else
        positive_part(slice0cost_difference_4_1);
      slice0cost_pair_1_1_folded_value := folded(slice0cost_difference_3_1);
      slice0cost_pair_1_1_is_less := slice0cost_difference_3_1 < 0;
      slice0cost_pair_1_2_choice := slice0cost_reverse_1_2 when slice0cost_difference_4_2 < 0 else
        positive_part(slice0cost_difference_4_2);
      slice0cost_pair_1_2_folded_value := folded(slice0cost_difference_3_2);
      slice0cost_pair_1_2_is_less := slice0cost_difference_3_2 < 0;
      slice0cost_pair_2_0_is_equal := median_counter_column = 23;
      slice0cost_pair_2_0_choice := not ((median_counter_group mod 2) = 1) when leftright_checked_tag_start_of_frame
        else slice0cost_pair_2_0 and (not ((median_counter_group mod 2) = 1));
      slice0cost_pair_2_0_choice_2 := slice0cost_pair_2_0_choice when slice0cost_pair_2_0_is_equal and
        ((median_counter_group / 2) = 1) else (not leftright_checked_tag_start_of_frame) and slice0cost_pair_2_0;
      slice0cost_pair_2_0_all := leftright_checked_tag_valid and leftright_checked_tag_map_column;
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_difference_3_0 <= slice0shift_search_3_0 - slice0shift_reference_3;
      slice0cost_difference_3_1 <= slice0shift_search_3_1 - slice0shift_reference_3;
      slice0cost_difference_3_2 <= slice0shift_search_3_2 - slice0shift_reference_3;
      slice0cost_difference_4_0 <= slice0shift_search_4_0 - slice0shift_reference_4;
      slice0cost_difference_4_1 <= slice0shift_search_4_1 - slice0shift_reference_4;
      slice0cost_difference_4_2 <= slice0shift_search_4_2 - slice0shift_reference_4;
      slice0cost_difference_5_0 <= slice0shift_search_5_0 - slice0shift_reference_5;
      slice0cost_difference_5_1 <= slice0shift_search_5_1 - slice0shift_reference_5;
      slice0cost_difference_5_2 <= slice0shift_search_5_2 - slice0shift_reference_5;
      slice0cost_reverse_0_0 <= (slice0shift_reference_2 - slice0shift_search_2_0) mod 256;
      slice0cost_reverse_0_1 <= (slice0shift_reference_2 - slice0shift_search_2_1) mod 256;
      slice0cost_reverse_0_2 <= (slice0shift_reference_2 - slice0shift_search_2_2) mod 256;
      slice0cost_reverse_1_0 <= (slice0shift_reference_4 - slice0shift_search_4_0) mod 256;
      slice0cost_reverse_1_1 <= (slice0shift_reference_4 - slice0shift_search_4_1) mod 256;
      slice0cost_reverse_1_2 <= (slice0shift_reference_4 - slice0shift_search_4_2) mod 256;
      slice0cost_reverse_2_0 <= slice0cost_reverse_2_0_is_equal;
      slice0cost_reverse_2_1 <= slice0cost_reverse_2_0;
      slice0cost_reverse_2_2 <= slice0cost_reverse_2_1;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_difference_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= (slice0cost_pair_0_0_choice + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0))) mod 256;
      slice0cost_pair_0_1 <= (slice0cost_pair_0_1_choice + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0))) mod 256;
      slice0cost_pair_0_2 <= (slice0cost_pair_0_2_choice + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0))) mod 256;
      slice0cost_pair_1_0 <= (slice0cost_pair_1_0_choice + slice0cost_pair_1_0_folded_value +
        as_number(slice0cost_pair_1_0_is_less)) mod 256;
      slice0cost_pair_1_1 <= (slice0cost_pair_1_1_choice + slice0cost_pair_1_1_folded_value +
        as_number(slice0cost_pair_1_1_is_less)) mod 256;
      slice0cost_pair_1_2 <= (slice0cost_pair_1_2_choice + slice0cost_pair_1_2_folded_value +
        as_number(slice0cost_pair_1_2_is_less)) mod 256;
      slice0cost_pair_2_0 <= slice0cost_pair_2_0 or slice0cost_pair_2_0_all when slice0cost_pair_2_0_choice_2 else
        slice0cost_pair_2_0 and ((not leftright_checked_tag_valid) or (not leftright_checked_tag_map_column));
      slice0cost_pair_2_1 <= slice0cost_pair_2_2;
      slice0cost_pair_2_2 <= slice2best_second_2_0 = 1023;
      slice0cost_single_0_0 <= folded(slice0cost_difference_0_0);
      slice0cost_single_0_1 <= folded(slice0cost_difference_0_1);
      slice0cost_single_0_2 <= folded(slice0cost_difference_0_2);
      slice0cost_single_2_0 <= folded(slice0cost_difference_2_0);
      slice0cost_single_2_1 <= folded(slice0cost_difference_2_1);
      slice0cost_single_2_2 <= folded(slice0cost_difference_2_2);
      slice0cost_single_3_0 <= slice0cost_pair_1_0_folded_value;
      slice0cost_single_3_1 <= slice0cost_pair_1_1_folded_value;
      slice0cost_single_3_2 <= slice0cost_pair_1_2_folded_value;
      slice0cost_single_5_0 <= folded(slice0cost_difference_5_0);
      slice0cost_single_5_1 <= folded(slice0cost_difference_5_1);
      slice0cost_single_5_2 <= folded(slice0cost_difference_5_2);
      slice0cost_negative_0_0 <= slice0cost_difference_0_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_0_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_0_2 < 0;
      slice0cost_negative_2_0 <= slice0cost_pair_0_0_is_less;
      slice0cost_negative_2_1 <= slice0cost_pair_0_1_is_less;
      slice0cost_negative_2_2 <= slice0cost_pair_0_2_is_less;
      slice0cost_negative_3_0 <= slice0cost_pair_1_0_is_less;
      slice0cost_negative_3_1 <= slice0cost_pair_1_1_is_less;
      slice0cost_negative_3_2 <= slice0cost_pair_1_2_is_less;
      slice0cost_negative_5_0 <= slice0cost_difference_5_0 < 0;
      slice0cost_negative_5_1 <= slice0cost_difference_5_1 < 0;
      slice0cost_negative_5_2 <= slice0cost_difference_5_2 < 0;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_first_cost <= slice0cost_difference_tag_first_cost;
      slice0cost_pair_tag_map_column <= slice0cost_difference_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_0_0) +
        slice0cost_pair_0_0 + slice0cost_single_0_0) mod 256;
      slice0cost_column_0_1 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_0_1) +
        slice0cost_pair_0_1 + slice0cost_single_0_1) mod 256;
      slice0cost_column_0_2 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_0_2) +
        slice0cost_pair_0_2 + slice0cost_single_0_2) mod 256;
      slice0cost_column_1_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_3_0) +
        slice0cost_pair_0_0 + slice0cost_single_3_0) mod 256;
      slice0cost_column_1_1 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_3_1) +
        slice0cost_pair_0_1 + slice0cost_single_3_1) mod 256;
      slice0cost_column_1_2 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_3_2) +
        slice0cost_pair_0_2 + slice0cost_single_3_2) mod 256;
      slice0cost_column_2_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_2_0) +
        slice0cost_pair_1_0 + slice0cost_single_2_0) mod 256;
      slice0cost_column_2_1 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_2_1) +
        slice0cost_pair_1_1 + slice0cost_single_2_1) mod 256;
      slice0cost_column_2_2 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_2_2) +
        slice0cost_pair_1_2 + slice0cost_single_2_2) mod 256;
      slice0cost_column_3_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_5_0) +
        slice0cost_pair_1_0 + slice0cost_single_5_0) mod 256;
      slice0cost_column_3_1 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_5_1) +
        slice0cost_pair_1_1 + slice0cost_single_5_1) mod 256;
      slice0cost_column_3_2 <= 0 when slice0cost_pair_tag_border_column else (as_number(slice0cost_negative_5_2) +
        slice0cost_pair_1_2 + slice0cost_single_5_2) mod 256;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_pair_tag_first_cost;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
        slice0window_partial_1_0_0 <= slice0cost_column_1_0;
        slice0window_partial_1_0_1 <= slice0cost_column_1_1;
        slice0window_partial_1_0_2 <= slice0cost_column_1_2;
        slice0window_partial_1_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_0_0;
        slice0window_partial_1_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_0_1;
        slice0window_partial_1_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_0_2;
        slice0window_partial_2_0_0 <= slice0cost_column_2_0;
        slice0window_partial_2_0_1 <= slice0cost_column_2_1;
        slice0window_partial_2_0_2 <= slice0cost_column_2_2;
        slice0window_partial_2_1_0 <= slice0cost_column_2_0 + slice0window_partial_2_0_0;
        slice0window_partial_2_1_1 <= slice0cost_column_2_1 + slice0window_partial_2_0_1;
        slice0window_partial_2_1_2 <= slice0cost_column_2_2 + slice0window_partial_2_0_2;
        slice0window_partial_3_0_0 <= slice0cost_column_3_0;
        slice0window_partial_3_0_1 <= slice0cost_column_3_1;
        slice0window_partial_3_0_2 <= slice0cost_column_3_2;
        slice0window_partial_3_1_0 <= slice0cost_column_3_0 + slice0window_partial_3_0_0;
        slice0window_partial_3_1_1 <= slice0cost_column_3_1 + slice0window_partial_3_0_1;
        slice0window_partial_3_1_2 <= slice0cost_column_3_2 + slice0window_partial_3_0_2;
        slice0window_centre_0_output_column <= slice0cost_tag_output_column;
        slice0window_centre_0_first_column <= slice0cost_tag_first_cost;
      end if;
      slice0window_centre_0_map_column <= slice0cost_tag_map_column;
      slice0window_centre_0_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_centre_0_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_1_0;
      slice0window_sum_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_1_1;
      slice0window_sum_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_1_2;
      slice0window_sum_2_0 <= slice0cost_column_2_0 + slice0window_partial_2_1_0;
      slice0window_sum_2_1 <= slice0cost_column_2_1 + slice0window_partial_2_1_1;
      slice0window_sum_2_2 <= slice0cost_column_2_2 + slice0window_partial_2_1_2;
      slice0window_sum_3_0 <= slice0cost_column_3_0 + slice0window_partial_3_1_0;
      slice0window_sum_3_1 <= slice0cost_column_3_1 + slice0window_partial_3_1_1;
      slice0window_sum_3_2 <= slice0cost_column_3_2 + slice0window_partial_3_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_row_start <= slice0window_tag_first_group;
      slice0window_tag_first_group <= slice2best_second_1_0 = 1023;
      slice0window_tag_border_column <= slice0window_tag_first_cost;
      slice0window_tag_first_cost <= slice2best_second_0_0 = 1023;
      slice0window_tag_map_column <= slice0window_centre_0_map_column;
      slice0window_tag_output_column <= slice0window_centre_0_output_column;
      slice0window_tag_first_column <= slice0window_centre_0_first_column;
      slice0window_tag_start_of_frame <= slice0window_centre_0_start_of_frame;
      slice0window_tag_end_of_line <= slice0window_centre_0_end_of_line;
      -- slice0other
      slice0other_cost_0_0_all := (slice0other_cost_3_2 < slice0window_sum_3_1) and (not slice0window_tag_first_column)
        and slice0window_tag_output_column;
      slice0other_cost_0_0_is_not_less := slice0other_cost_0_1 >= slice0window_sum_0_0;
      slice0other_cost_0_0_choice := slice0window_sum_0_0 when slice0other_cost_0_0_is_not_less else
        slice0other_cost_0_1;
      slice0other_cost_0_0_choice_2 := slice0other_cost_0_0_choice when slice0window_tag_valid else
        slice0other_cost_0_0;
      slice0other_cost_0_0_all_2 := (slice0other_cost_3_2 >= slice0window_sum_3_1) and (not
        slice0window_tag_first_column) and slice0window_tag_output_column;
      slice0other_cost_0_0_choice_3 := slice0window_sum_0_0 when slice0window_tag_valid else slice0other_cost_0_0;
      slice0other_cost_0_0_choice_4 := slice0other_cost_0_1 when slice0window_tag_valid else slice0other_cost_0_0;
      slice0other_cost_0_0_choice_5 := slice0other_cost_0_0_choice_3 when slice0window_tag_output_column else
        slice0other_cost_0_0_choice_4;
      slice0other_cost_0_0_choice_6 := slice0other_cost_0_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_0_choice_5;
      slice0other_cost_0_1_is_not_less := slice0other_cost_0_2 >= slice0window_sum_0_1;
      slice0other_cost_0_1_choice := slice0window_sum_0_1 when slice0window_tag_valid else slice0other_cost_0_1;
      slice0other_cost_0_1_choice_2 := slice0other_cost_0_2 when slice0window_tag_valid else slice0other_cost_0_1;
      slice0other_cost_0_1_choice_3 := slice0other_cost_0_1_choice when slice0other_cost_0_1_is_not_less else
        slice0other_cost_0_1_choice_2;
      slice0other_cost_0_1_choice_4 := slice0other_cost_0_1_choice when slice0window_tag_output_column else
        slice0other_cost_0_1_choice_2;
      slice0other_cost_0_1_choice_5 := slice0other_cost_0_1_choice_3 when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_1_choice_4;
      slice0other_cost_0_2_choice := slice0window_sum_0_2 when slice0window_tag_valid else slice0other_cost_0_2;
      slice0other_cost_0_2_choice_2 := 0 when slice0window_tag_valid else slice0other_cost_0_2;
      slice0other_cost_0_2_choice_3 := slice0other_cost_0_2_choice when slice0window_tag_output_column else
        slice0other_cost_0_2_choice_2;
      slice0other_cost_0_2_choice_4 := slice0other_cost_0_2_choice when slice0other_cost_0_0_all_2 else
        slice0other_cost_0_2_choice_3;
      slice0other_cost_1_0_is_not_less := slice0other_cost_1_1 >= slice0window_sum_1_0;
      slice0other_cost_1_0_choice := slice0window_sum_1_0 when slice0other_cost_1_0_is_not_less else
        slice0other_cost_1_1;
      slice0other_cost_1_0_choice_2 := slice0other_cost_1_0_choice when slice0window_tag_valid else
        slice0other_cost_1_0;
      slice0other_cost_1_0_choice_3 := slice0window_sum_1_0 when slice0window_tag_valid else slice0other_cost_1_0;
      slice0other_cost_1_0_choice_4 := slice0other_cost_1_1 when slice0window_tag_valid else slice0other_cost_1_0;
      slice0other_cost_1_0_choice_5 := slice0other_cost_1_0_choice_3 when slice0window_tag_output_column else
        slice0other_cost_1_0_choice_4;
      slice0other_cost_1_0_choice_6 := slice0other_cost_1_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_1_0_choice_5;
      slice0other_cost_1_1_is_not_less := slice0other_cost_1_2 >= slice0window_sum_1_1;
      slice0other_cost_1_1_choice := slice0window_sum_1_1 when slice0window_tag_valid else slice0other_cost_1_1;
      slice0other_cost_1_1_choice_2 := slice0other_cost_1_2 when slice0window_tag_valid else slice0other_cost_1_1;
      slice0other_cost_1_1_choice_3 := slice0other_cost_1_1_choice when slice0other_cost_1_1_is_not_less else
        slice0other_cost_1_1_choice_2;
      slice0other_cost_1_1_choice_4 := slice0other_cost_1_1_choice when slice0window_tag_output_column else
        slice0other_cost_1_1_choice_2;
      slice0other_cost_1_1_choice_5 := slice0other_cost_1_1_choice_3 when slice0other_cost_0_0_all_2 else
        slice0other_cost_1_1_choice_4;
      slice0other_cost_1_2_choice := slice0window_sum_1_2 when slice0window_tag_valid else slice0other_cost_1_2;
      slice0other_cost_1_2_choice_2 := 0 when slice0window_tag_valid else slice0other_cost_1_2;
      slice0other_cost_1_2_choice_3 := slice0other_cost_1_2_choice when slice0window_tag_output_column else
        slice0other_cost_1_2_choice_2;
      slice0other_cost_1_2_choice_4 := slice0other_cost_1_2_choice when slice0other_cost_0_0_all_2 else
        slice0other_cost_1_2_choice_3;
      slice0other_cost_2_0_is_not_less := slice0other_cost_2_1 >= slice0window_sum_2_0;
      slice0other_cost_2_0_choice := slice0window_sum_2_0 when slice0other_cost_2_0_is_not_less else
        slice0other_cost_2_1;
      slice0other_cost_2_0_choice_2 := slice0other_cost_2_0_choice when slice0window_tag_valid else
        slice0other_cost_2_0;
      slice0other_cost_2_0_choice_3 := slice0window_sum_2_0 when slice0window_tag_valid else slice0other_cost_2_0;
      slice0other_cost_2_0_choice_4 := slice0other_cost_2_1 when slice0window_tag_valid else slice0other_cost_2_0;
      slice0other_cost_2_0_choice_5 := slice0other_cost_2_0_choice_3 when slice0window_tag_output_column else
        slice0other_cost_2_0_choice_4;
      slice0other_cost_2_0_choice_6 := slice0other_cost_2_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_2_0_choice_5;
      slice0other_cost_2_1_is_not_less := slice0other_cost_2_2 >= slice0window_sum_2_1;
      slice0other_cost_2_1_choice := slice0window_sum_2_1 when slice0window_tag_valid else slice0other_cost_2_1;
      slice0other_cost_2_1_choice_2 := slice0other_cost_2_2 when slice0window_tag_valid else slice0other_cost_2_1;
      slice0other_cost_2_1_choice_3 := slice0other_cost_2_1_choice when slice0other_cost_2_1_is_not_less else
        slice0other_cost_2_1_choice_2;
      slice0other_cost_2_1_choice_4 := slice0other_cost_2_1_choice when slice0window_tag_output_column else
        slice0other_cost_2_1_choice_2;
      slice0other_cost_2_1_choice_5 := slice0other_cost_2_1_choice_3 when slice0other_cost_0_0_all_2 else
        slice0other_cost_2_1_choice_4;
      slice0other_cost_2_2_choice := slice0window_sum_2_2 when slice0window_tag_valid else slice0other_cost_2_2;
      slice0other_cost_2_2_choice_2 := 0 when slice0window_tag_valid else slice0other_cost_2_2;
      slice0other_cost_2_2_choice_3 := slice0other_cost_2_2_choice when slice0window_tag_output_column else
        slice0other_cost_2_2_choice_2;
      slice0other_cost_2_2_choice_4 := slice0other_cost_2_2_choice when slice0other_cost_0_0_all_2 else
        slice0other_cost_2_2_choice_3;
      slice0other_cost_3_0_is_not_less := slice0other_cost_3_1 >= slice0window_sum_3_0;
      slice0other_cost_3_0_choice := slice0window_sum_3_0 when slice0other_cost_3_0_is_not_less else
        slice0other_cost_3_1;
      slice0other_cost_3_0_choice_2 := slice0other_cost_3_0_choice when slice0window_tag_valid else
        slice0other_cost_3_0;
      slice0other_cost_3_0_choice_3 := slice0window_sum_3_0 when slice0window_tag_valid else slice0other_cost_3_0;
      slice0other_cost_3_0_choice_4 := slice0other_cost_3_1 when slice0window_tag_valid else slice0other_cost_3_0;
      slice0other_cost_3_0_choice_5 := slice0other_cost_3_0_choice_3 when slice0window_tag_output_column else
        slice0other_cost_3_0_choice_4;
      slice0other_cost_3_0_choice_6 := slice0other_cost_3_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_3_0_choice_5;
      slice0other_cost_3_1_choice := slice0other_cost_3_2 when slice0window_tag_valid else slice0other_cost_3_1;
      slice0other_cost_3_1_choice_2 := slice0window_sum_3_1 when slice0window_tag_valid else slice0other_cost_3_1;
      slice0other_cost_3_1_choice_3 := slice0other_cost_3_1_choice_2 when slice0window_tag_output_column else
        slice0other_cost_3_1_choice;
      slice0other_cost_3_1_choice_4 := slice0other_cost_3_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_3_1_choice_3;
      slice0other_winner_0_0_choice := 5 when slice0other_cost_0_0_is_not_less else slice0other_winner_0_1;
      slice0other_winner_0_0_choice_2 := slice0other_winner_0_0_choice when slice0window_tag_valid else
        slice0other_winner_0_0;
      slice0other_winner_0_0_choice_3 := 5 when slice0window_tag_valid else slice0other_winner_0_0;
      slice0other_winner_0_0_choice_4 := slice0other_winner_0_1 when slice0window_tag_valid else slice0other_winner_0_0;
      slice0other_winner_0_0_choice_5 := slice0other_winner_0_0_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_0_choice_4;
      slice0other_winner_0_0_choice_6 := slice0other_winner_0_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_0_choice_5;
      slice0other_winner_0_1_choice := 6 when slice0other_cost_0_1_is_not_less else slice0other_winner_1_2;
      slice0other_winner_0_1_choice_2 := slice0other_winner_0_1_choice when slice0window_tag_valid else
        slice0other_winner_0_1;
      slice0other_winner_0_1_choice_3 := 6 when slice0window_tag_valid else slice0other_winner_0_1;
      slice0other_winner_0_1_choice_4 := slice0other_winner_1_2 when slice0window_tag_valid else slice0other_winner_0_1;
      slice0other_winner_0_1_choice_5 := slice0other_winner_0_1_choice_3 when slice0window_tag_output_column else
        slice0other_winner_0_1_choice_4;
      slice0other_winner_0_1_choice_6 := slice0other_winner_0_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_0_1_choice_5;
      slice0other_winner_1_0_choice := 5 when slice0other_cost_1_0_is_not_less else slice0other_winner_1_1;
      slice0other_winner_1_0_choice_2 := slice0other_winner_1_0_choice when slice0window_tag_valid else
        slice0other_winner_1_0;
      slice0other_winner_1_0_choice_3 := 5 when slice0window_tag_valid else slice0other_winner_1_0;
      slice0other_winner_1_0_choice_4 := slice0other_winner_1_1 when slice0window_tag_valid else slice0other_winner_1_0;
      slice0other_winner_1_0_choice_5 := slice0other_winner_1_0_choice_3 when slice0window_tag_output_column else
        slice0other_winner_1_0_choice_4;
      slice0other_winner_1_0_choice_6 := slice0other_winner_1_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_1_0_choice_5;
      slice0other_winner_1_1_choice := 6 when slice0other_cost_1_1_is_not_less else slice0other_winner_1_2;
      slice0other_winner_1_1_choice_2 := slice0other_winner_1_1_choice when slice0window_tag_valid else
        slice0other_winner_1_1;
      slice0other_winner_1_1_choice_3 := 6 when slice0window_tag_valid else slice0other_winner_1_1;
      slice0other_winner_1_1_choice_4 := slice0other_winner_1_2 when slice0window_tag_valid else slice0other_winner_1_1;
      slice0other_winner_1_1_choice_5 := slice0other_winner_1_1_choice_3 when slice0window_tag_output_column else
        slice0other_winner_1_1_choice_4;
      slice0other_winner_1_1_choice_6 := slice0other_winner_1_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_1_1_choice_5;
      slice0other_winner_1_2_choice := 7 when slice0window_tag_valid else slice0other_winner_1_2;
      slice0other_winner_1_2_choice_2 := 0 when slice0window_tag_valid else slice0other_winner_1_2;
      slice0other_winner_1_2_choice_3 := slice0other_winner_1_2_choice when slice0window_tag_output_column else
        slice0other_winner_1_2_choice_2;
      slice0other_winner_1_2_choice_4 := slice0other_winner_1_2_choice when slice0other_cost_0_0_all_2 else
        slice0other_winner_1_2_choice_3;
      slice0other_winner_2_0_choice := 5 when slice0other_cost_2_0_is_not_less else slice0other_winner_2_1;
      slice0other_winner_2_0_choice_2 := slice0other_winner_2_0_choice when slice0window_tag_valid else
        slice0other_winner_2_0;
      slice0other_winner_2_0_choice_3 := 5 when slice0window_tag_valid else slice0other_winner_2_0;
      slice0other_winner_2_0_choice_4 := slice0other_winner_2_1 when slice0window_tag_valid else slice0other_winner_2_0;
      slice0other_winner_2_0_choice_5 := slice0other_winner_2_0_choice_3 when slice0window_tag_output_column else
        slice0other_winner_2_0_choice_4;
      slice0other_winner_2_0_choice_6 := slice0other_winner_2_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_2_0_choice_5;
      slice0other_winner_2_1_choice := 6 when slice0other_cost_2_1_is_not_less else slice0other_winner_1_2;
      slice0other_winner_2_1_choice_2 := slice0other_winner_2_1_choice when slice0window_tag_valid else
        slice0other_winner_2_1;
      slice0other_winner_2_1_choice_3 := 6 when slice0window_tag_valid else slice0other_winner_2_1;
      slice0other_winner_2_1_choice_4 := slice0other_winner_1_2 when slice0window_tag_valid else slice0other_winner_2_1;
      slice0other_winner_2_1_choice_5 := slice0other_winner_2_1_choice_3 when slice0window_tag_output_column else
        slice0other_winner_2_1_choice_4;
      slice0other_winner_2_1_choice_6 := slice0other_winner_2_1_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_2_1_choice_5;
      slice0other_winner_3_0_choice := 5 when slice0other_cost_3_0_is_not_less else slice0other_winner_3_1;
      slice0other_winner_3_0_choice_2 := slice0other_winner_3_0_choice when slice0window_tag_valid else
        slice0other_winner_3_0;
      slice0other_winner_3_0_choice_3 := 5 when slice0window_tag_valid else slice0other_winner_3_0;
      slice0other_winner_3_0_choice_4 := slice0other_winner_3_1 when slice0window_tag_valid else slice0other_winner_3_0;
      slice0other_winner_3_0_choice_5 := slice0other_winner_3_0_choice_3 when slice0window_tag_output_column else
        slice0other_winner_3_0_choice_4;
      slice0other_winner_3_0_choice_6 := slice0other_winner_3_0_choice_2 when slice0other_cost_0_0_all_2 else
        slice0other_winner_3_0_choice_5;
      slice0other_cost_0_0 <= slice0other_cost_0_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_0_0_choice_6;
      slice0other_cost_0_1 <= slice0other_cost_0_1_choice_3 when slice0other_cost_0_0_all else
        slice0other_cost_0_1_choice_5;
      slice0other_cost_0_2 <= slice0other_cost_0_2_choice when slice0other_cost_0_0_all else
        slice0other_cost_0_2_choice_4;
      slice0other_cost_1_0 <= slice0other_cost_1_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_1_0_choice_6;
      slice0other_cost_1_1 <= slice0other_cost_1_1_choice_3 when slice0other_cost_0_0_all else
        slice0other_cost_1_1_choice_5;
      slice0other_cost_1_2 <= slice0other_cost_1_2_choice when slice0other_cost_0_0_all else
        slice0other_cost_1_2_choice_4;
      slice0other_cost_2_0 <= slice0other_cost_2_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_2_0_choice_6;
      slice0other_cost_2_1 <= slice0other_cost_2_1_choice_3 when slice0other_cost_0_0_all else
        slice0other_cost_2_1_choice_5;
      slice0other_cost_2_2 <= slice0other_cost_2_2_choice when slice0other_cost_0_0_all else
        slice0other_cost_2_2_choice_4;
      slice0other_cost_3_0 <= slice0other_cost_3_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_cost_3_0_choice_6;
      slice0other_cost_3_1 <= slice0other_cost_3_1_choice when slice0other_cost_0_0_all else
        slice0other_cost_3_1_choice_4;
      slice0other_winner_0_0 <= slice0other_winner_0_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_0_choice_6;
      slice0other_winner_0_1 <= slice0other_winner_0_1_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_0_1_choice_6;
      slice0other_winner_1_0 <= slice0other_winner_1_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_1_0_choice_6;
      slice0other_winner_1_1 <= slice0other_winner_1_1_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_1_1_choice_6;
      slice0other_winner_1_2 <= slice0other_winner_1_2_choice when slice0other_cost_0_0_all else
        slice0other_winner_1_2_choice_4;
      slice0other_winner_2_0 <= slice0other_winner_2_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_2_0_choice_6;
      slice0other_winner_2_1 <= slice0other_winner_2_1_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_2_1_choice_6;
      slice0other_winner_3_0 <= slice0other_winner_3_0_choice_2 when slice0other_cost_0_0_all else
        slice0other_winner_3_0_choice_6;
      slice0other_cost_out_0 <= slice0other_cost_0_0;
      slice0other_cost_out_1 <= slice0other_cost_1_0;
      slice0other_cost_out_2 <= slice0other_cost_2_0;
      slice0other_cost_out_3 <= slice0other_cost_3_0;
      slice0other_winner_out_0 <= slice0other_winner_0_0;
      slice0other_winner_out_1 <= slice0other_winner_1_0;
      slice0other_winner_out_2 <= slice0other_winner_2_0;
      slice0other_winner_out_3 <= slice0other_winner_3_0;
      slice0other_cost_3_2_choice := slice0window_sum_3_2 when slice0window_tag_output_column else 0;
      slice0other_cost_3_2_choice_2 := slice0window_sum_3_2 when slice0other_cost_0_0_all_2 else
        slice0other_cost_3_2_choice;
      slice0other_winner_0_2_choice := 7 when slice0window_tag_output_column else 0;
      slice0other_winner_0_2_choice_2 := 7 when slice0other_cost_0_0_all_2 else slice0other_winner_0_2_choice;
      slice0other_winner_3_1_choice := 6 when slice0window_tag_output_column else slice0other_winner_0_2;
      slice0other_winner_3_1_choice_2 := 6 when slice0other_cost_0_0_all_2 else slice0other_winner_3_1_choice;
      if slice0window_tag_valid then
        slice0other_cost_3_2 <= slice0window_sum_3_2 when slice0other_cost_0_0_all else slice0other_cost_3_2_choice_2;
        slice0other_winner_0_2 <= 7 when slice0other_cost_0_0_all else slice0other_winner_0_2_choice_2;
        slice0other_winner_3_1 <= slice0other_winner_0_2 when slice0other_cost_0_0_all else
          slice0other_winner_3_1_choice_2;
      end if;
      -- slice0winner1
      slice0winner1_cost_0_0_is_less := slice0window_sum_0_1 < slice0window_sum_0_0;
      slice0winner1_cost_1_0_is_less := slice0window_sum_1_1 < slice0window_sum_1_0;
      slice0winner1_cost_2_0_is_less := slice0window_sum_2_1 < slice0window_sum_2_0;
      slice0winner1_cost_3_0_is_less := slice0window_sum_3_1 < slice0window_sum_3_0;
      slice0winner1_cost_0_0 <= slice0window_sum_0_1 when slice0winner1_cost_0_0_is_less else slice0window_sum_0_0;
      slice0winner1_cost_0_1 <= slice0window_sum_0_2;
      slice0winner1_cost_1_0 <= slice0window_sum_1_1 when slice0winner1_cost_1_0_is_less else slice0window_sum_1_0;
      slice0winner1_cost_1_1 <= slice0window_sum_1_2;
      slice0winner1_cost_2_0 <= slice0window_sum_2_1 when slice0winner1_cost_2_0_is_less else slice0window_sum_2_0;
      slice0winner1_cost_2_1 <= slice0window_sum_2_2;
      slice0winner1_cost_3_0 <= slice0window_sum_3_1 when slice0winner1_cost_3_0_is_less else slice0window_sum_3_0;
      slice0winner1_cost_3_1 <= slice0window_sum_3_2;
      slice0winner1_index_0_0 <= slice0winner1_cost_0_0_is_less;
      slice0winner1_index_0_1 <= 2;
      slice0winner1_index_1_0 <= slice0winner1_cost_1_0_is_less;
      slice0winner1_index_2_0 <= slice0winner1_cost_2_0_is_less;
      slice0winner1_index_3_0 <= slice0winner1_cost_3_0_is_less;
      slice0winner1_below_0_0 <= slice0window_sum_0_0 when slice0winner1_cost_0_0_is_less else 0;
      slice0winner1_below_1_0 <= slice0window_sum_1_0 when slice0winner1_cost_1_0_is_less else 0;
      slice0winner1_below_2_0 <= slice0window_sum_2_0 when slice0winner1_cost_2_0_is_less else 0;
      slice0winner1_below_3_0 <= slice0window_sum_3_0 when slice0winner1_cost_3_0_is_less else 0;
      slice0winner1_above_0_0 <= 0 when slice0winner1_cost_0_0_is_less else slice0window_sum_0_1;
      slice0winner1_above_1_0 <= 0 when slice0winner1_cost_1_0_is_less else slice0window_sum_1_1;
      slice0winner1_above_2_0 <= 0 when slice0winner1_cost_2_0_is_less else slice0window_sum_2_1;
      slice0winner1_above_3_0 <= 0 when slice0winner1_cost_3_0_is_less else slice0window_sum_3_1;
      slice0winner1_first_0_0 <= slice0window_sum_0_0;
      slice0winner1_first_1_0 <= slice0window_sum_1_0;
      slice0winner1_first_2_0 <= slice0window_sum_2_0;
      slice0winner1_first_3_0 <= slice0window_sum_3_0;
      slice0winner1_last_0_0 <= slice0window_sum_0_1;
      slice0winner1_last_1_0 <= slice0window_sum_1_1;
      slice0winner1_last_2_0 <= slice0window_sum_2_1;
      slice0winner1_last_3_0 <= slice0window_sum_3_1;
      slice0winner1_second_0_0 <= 1023;
      slice0winner1_but_first_0_0 <= slice0window_sum_0_1;
      slice0winner1_but_first_1_0 <= slice0window_sum_1_1;
      slice0winner1_but_first_2_0 <= slice0window_sum_2_1;
      slice0winner1_but_first_3_0 <= slice0window_sum_3_1;
      slice0winner1_but_last_0_0 <= slice0window_sum_0_0;
      slice0winner1_but_last_1_0 <= slice0window_sum_1_0;
      slice0winner1_but_last_2_0 <= slice0window_sum_2_0;
      slice0winner1_but_last_3_0 <= slice0window_sum_3_0;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_first_column <= slice1window_centre_0_first_column;
      if slice0winner1_tag_valid then
        slice0winner1_tag_map_column <= slice0window_tag_map_column;
        slice0winner1_tag_output_column <= slice2cost_tag_output_column;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0winner2
      slice0winner2_cost_0_0_is_less := slice0winner1_cost_0_1 < slice0winner1_cost_0_0;
      slice0winner2_cost_1_0_is_less := slice0winner1_cost_1_1 < slice0winner1_cost_1_0;
      slice0winner2_cost_2_0_is_less := slice0winner1_cost_2_1 < slice0winner1_cost_2_0;
      slice0winner2_cost_3_0_is_less := slice0winner1_cost_3_1 < slice0winner1_cost_3_0;
      slice0winner2_above_0_0_choice := slice0winner1_cost_0_1 when slice0winner1_index_0_0 else
        slice0winner1_above_0_0;
      slice0winner2_above_1_0_choice := slice0winner1_cost_1_1 when slice0winner1_index_1_0 else
        slice0winner1_above_1_0;
      slice0winner2_above_2_0_choice := slice0winner1_cost_2_1 when slice0winner1_index_2_0 else
        slice0winner1_above_2_0;
      slice0winner2_above_3_0_choice := slice0winner1_cost_3_1 when slice0winner1_index_3_0 else
        slice0winner1_above_3_0;
      slice0winner2_second_0_0_choice := slice0winner1_second_0_0 when slice0winner1_index_0_0 else
        slice0winner1_cost_0_1;
      slice0winner2_second_0_0_choice_2 := slice0winner1_first_0_0 when slice0winner2_cost_0_0_is_less else
        slice0winner2_second_0_0_choice;
      slice0winner2_second_1_0_choice := slice0winner1_second_0_0 when slice0winner1_index_1_0 else
        slice0winner1_cost_1_1;
      slice0winner2_second_1_0_choice_2 := slice0winner1_first_1_0 when slice0winner2_cost_1_0_is_less else
        slice0winner2_second_1_0_choice;
      slice0winner2_second_2_0_choice := slice0winner1_second_0_0 when slice0winner1_index_2_0 else
        slice0winner1_cost_2_1;
      slice0winner2_second_2_0_choice_2 := slice0winner1_first_2_0 when slice0winner2_cost_2_0_is_less else
        slice0winner2_second_2_0_choice;
      slice0winner2_second_3_0_choice := slice0winner1_second_0_0 when slice0winner1_index_3_0 else
        slice0winner1_cost_3_1;
      slice0winner2_second_3_0_choice_2 := slice0winner1_first_3_0 when slice0winner2_cost_3_0_is_less else
        slice0winner2_second_3_0_choice;
      slice0winner2_cost_0_0 <= slice0winner1_cost_0_1 when slice0winner2_cost_0_0_is_less else slice0winner1_cost_0_0;
      slice0winner2_cost_1_0 <= slice0winner1_cost_1_1 when slice0winner2_cost_1_0_is_less else slice0winner1_cost_1_0;
      slice0winner2_cost_2_0 <= slice0winner1_cost_2_1 when slice0winner2_cost_2_0_is_less else slice0winner1_cost_2_0;
      slice0winner2_cost_3_0 <= slice0winner1_cost_3_1 when slice0winner2_cost_3_0_is_less else slice0winner1_cost_3_0;
      slice0winner2_index_0_0 <= slice0winner1_index_0_1 when slice0winner2_cost_0_0_is_less else
        as_number(slice0winner1_index_0_0);
      slice0winner2_index_1_0 <= slice0winner1_index_0_1 when slice0winner2_cost_1_0_is_less else
        as_number(slice0winner1_index_1_0);
      slice0winner2_index_2_0 <= slice0winner1_index_0_1 when slice0winner2_cost_2_0_is_less else
        as_number(slice0winner1_index_2_0);
      slice0winner2_index_3_0 <= slice0winner1_index_0_1 when slice0winner2_cost_3_0_is_less else
        as_number(slice0winner1_index_3_0);
      slice0winner2_below_0_0 <= slice0winner1_but_first_0_0 when slice0winner2_cost_0_0_is_less else
        slice0winner1_below_0_0;
      slice0winner2_below_1_0 <= slice0winner1_but_first_1_0 when slice0winner2_cost_1_0_is_less else
        slice0winner1_below_1_0;
      slice0winner2_below_2_0 <= slice0winner1_but_first_2_0 when slice0winner2_cost_2_0_is_less else
        slice0winner1_below_2_0;
      slice0winner2_below_3_0 <= slice0winner1_but_first_3_0 when slice0winner2_cost_3_0_is_less else
        slice0winner1_below_3_0;
      slice0winner2_above_0_0 <= 0 when slice0winner2_cost_0_0_is_less else slice0winner2_above_0_0_choice;
      slice0winner2_above_1_0 <= 0 when slice0winner2_cost_1_0_is_less else slice0winner2_above_1_0_choice;
      slice0winner2_above_2_0 <= 0 when slice0winner2_cost_2_0_is_less else slice0winner2_above_2_0_choice;
      slice0winner2_above_3_0 <= 0 when slice0winner2_cost_3_0_is_less else slice0winner2_above_3_0_choice;
      slice0winner2_first_0_0 <= slice0winner1_but_last_0_0;
      slice0winner2_first_1_0 <= slice0winner1_but_last_1_0;
      slice0winner2_first_2_0 <= slice0winner1_but_last_2_0;
      slice0winner2_first_3_0 <= slice0winner1_but_last_3_0;
      slice0winner2_second_0_0 <= slice0winner2_second_0_0_choice_2 when slice0winner2_second_0_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice0winner2_second_1_0 <= slice0winner2_second_1_0_choice_2 when slice0winner2_second_1_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice0winner2_second_2_0 <= slice0winner2_second_2_0_choice_2 when slice0winner2_second_2_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice0winner2_second_3_0 <= slice0winner2_second_3_0_choice_2 when slice0winner2_second_3_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice0winner2_but_first_0_0 <= slice0winner1_cost_0_1 when slice0winner1_cost_0_1 < slice0winner1_last_0_0 else
        slice0winner1_last_0_0;
      slice0winner2_but_first_1_0 <= slice0winner1_cost_1_1 when slice0winner1_cost_1_1 < slice0winner1_last_1_0 else
        slice0winner1_last_1_0;
      slice0winner2_but_first_2_0 <= slice0winner1_cost_2_1 when slice0winner1_cost_2_1 < slice0winner1_last_2_0 else
        slice0winner1_last_2_0;
      slice0winner2_but_first_3_0 <= slice0winner1_cost_3_1 when slice0winner1_cost_3_1 < slice0winner1_last_3_0 else
        slice0winner1_last_3_0;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_first_column <= slice1window_tag_first_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      -- slice0best
      slice0best_cost_0_0 <= slice0winner2_cost_0_0;
      slice0best_cost_1_0 <= slice0winner2_cost_1_0;
      slice0best_cost_2_0 <= slice0winner2_cost_2_0;
      slice0best_cost_3_0 <= slice0winner2_cost_3_0;
      slice0best_index_0_0 <= slice0winner2_index_0_0 + 5;
      slice0best_index_1_0 <= slice0winner2_index_1_0 + 5;
      slice0best_index_2_0 <= slice0winner2_index_2_0 + 5;
      slice0best_index_3_0 <= slice0winner2_index_3_0 + 5;
      slice0best_below_0_0 <= slice0winner2_below_0_0;
      slice0best_below_1_0 <= slice0winner2_below_1_0;
      slice0best_below_2_0 <= slice0winner2_below_2_0;
      slice0best_below_3_0 <= slice0winner2_below_3_0;
      slice0best_above_0_0 <= slice0winner2_above_0_0;
      slice0best_above_1_0 <= slice0winner2_above_1_0;
      slice0best_above_2_0 <= slice0winner2_above_2_0;
      slice0best_above_3_0 <= slice0winner2_above_3_0;
      slice0best_first_0_0 <= slice0winner2_first_0_0;
      slice0best_first_1_0 <= slice0winner2_first_1_0;
      slice0best_first_2_0 <= slice0winner2_first_2_0;
      slice0best_first_3_0 <= slice0winner2_first_3_0;
      slice0best_second_0_0 <= slice0winner2_second_0_0;
      slice0best_second_1_0 <= slice0winner2_second_1_0;
      slice0best_second_2_0 <= slice0winner2_second_2_0;
      slice0best_second_3_0 <= slice0winner2_second_3_0;
      slice0best_but_first_0_0 <= slice0winner2_but_first_0_0;
      slice0best_but_first_1_0 <= slice0winner2_but_first_1_0;
      slice0best_but_first_2_0 <= slice0winner2_but_first_2_0;
      slice0best_but_first_3_0 <= slice0winner2_but_first_3_0;
      slice0best_tag_valid <= slice0winner2_tag_valid;
      slice0best_tag_map_column <= slice0winner2_tag_map_column;
      slice0best_tag_output_column <= slice0winner2_tag_output_column;
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
        slice1shift_search_3_0 <= slice1shift_search_3_1;
        slice1shift_search_3_1 <= slice1shift_search_3_2;
        slice1shift_search_3_2 <= slice0shift_search_out_3;
        slice1shift_search_4_0 <= slice1shift_search_4_1;
        slice1shift_search_4_1 <= slice1shift_search_4_2;
        slice1shift_search_4_2 <= slice0shift_search_out_4;
        slice1shift_search_5_0 <= slice1shift_search_5_1;
        slice1shift_search_5_1 <= slice1shift_search_5_2;
        slice1shift_search_5_2 <= slice0shift_search_out_5;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_reference_4 <= slice0shift_reference_4;
      slice1shift_reference_5 <= slice0shift_reference_5;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      slice1shift_search_out_2 <= slice1shift_search_2_0;
      slice1shift_search_out_3 <= slice1shift_search_3_0;
      slice1shift_search_out_4 <= slice1shift_search_4_0;
      slice1shift_search_out_5 <= slice1shift_search_5_0;
      -- slice1cost
      slice1cost_pair_0_0_is_less := slice1cost_difference_2_0 < 0;
      slice1cost_pair_0_0_choice := slice1cost_reverse_0_0 when slice1cost_pair_0_0_is_less else
        positive_part(slice1cost_difference_2_0);
      slice1cost_pair_0_1_is_less := slice1cost_difference_2_1 < 0;
      slice1cost_pair_0_1_choice := slice1cost_reverse_0_1 when slice1cost_pair_0_1_is_less else
        positive_part(slice1cost_difference_2_1);
      slice1cost_pair_0_2_is_less := slice1cost_difference_2_2 < 0;
      slice1cost_pair_0_2_choice := slice1cost_reverse_0_2 when slice1cost_pair_0_2_is_less else
        positive_part(slice1cost_difference_2_2);
      slice1cost_pair_1_0_choice := slice1cost_reverse_1_0 when slice1cost_difference_4_0 < 0 else
        positive_part(slice1cost_difference_4_0);
      slice1cost_pair_1_0_folded_value := folded(slice1cost_difference_3_0);
      slice1cost_pair_1_0_is_less := slice1cost_difference_3_0 < 0;
      slice1cost_pair_1_1_choice := slice1cost_reverse_1_1 when slice1cost_difference_4_1 < 0 else
        positive_part(slice1cost_difference_4_1);
      slice1cost_pair_1_1_folded_value := folded(slice1cost_difference_3_1);
      slice1cost_pair_1_1_is_less := slice1cost_difference_3_1 < 0;
      slice1cost_pair_1_2_choice := slice1cost_reverse_1_2 when slice1cost_difference_4_2 < 0 else
        positive_part(slice1cost_difference_4_2);
      slice1cost_pair_1_2_folded_value := folded(slice1cost_difference_3_2);
      slice1cost_pair_1_2_is_less := slice1cost_difference_3_2 < 0;
      slice1cost_difference_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_difference_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_difference_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_difference_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_difference_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_difference_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_difference_2_0 <= slice1shift_search_2_0 - slice1shift_reference_2;
      slice1cost_difference_2_1 <= slice1shift_search_2_1 - slice1shift_reference_2;
      slice1cost_difference_2_2 <= slice1shift_search_2_2 - slice1shift_reference_2;
      slice1cost_difference_3_0 <= slice1shift_search_3_0 - slice1shift_reference_3;
      slice1cost_difference_3_1 <= slice1shift_search_3_1 - slice1shift_reference_3;
      slice1cost_difference_3_2 <= slice1shift_search_3_2 - slice1shift_reference_3;
      slice1cost_difference_4_0 <= slice1shift_search_4_0 - slice1shift_reference_4;
      slice1cost_difference_4_1 <= slice1shift_search_4_1 - slice1shift_reference_4;
      slice1cost_difference_4_2 <= slice1shift_search_4_2 - slice1shift_reference_4;
      slice1cost_difference_5_0 <= slice1shift_search_5_0 - slice1shift_reference_5;
      slice1cost_difference_5_1 <= slice1shift_search_5_1 - slice1shift_reference_5;
      slice1cost_difference_5_2 <= slice1shift_search_5_2 - slice1shift_reference_5;
      slice1cost_reverse_0_0 <= (slice1shift_reference_2 - slice1shift_search_2_0) mod 256;
      slice1cost_reverse_0_1 <= (slice1shift_reference_2 - slice1shift_search_2_1) mod 256;
      slice1cost_reverse_0_2 <= (slice1shift_reference_2 - slice1shift_search_2_2) mod 256;
      slice1cost_reverse_1_0 <= (slice1shift_reference_4 - slice1shift_search_4_0) mod 256;
      slice1cost_reverse_1_1 <= (slice1shift_reference_4 - slice1shift_search_4_1) mod 256;
      slice1cost_reverse_1_2 <= (slice1shift_reference_4 - slice1shift_search_4_2) mod 256;
      slice1cost_pair_0_0 <= (slice1cost_pair_0_0_choice + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0))) mod 256;
      slice1cost_pair_0_1 <= (slice1cost_pair_0_1_choice + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0))) mod 256;
      slice1cost_pair_0_2 <= (slice1cost_pair_0_2_choice + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0))) mod 256;
      slice1cost_pair_1_0 <= (slice1cost_pair_1_0_choice + slice1cost_pair_1_0_folded_value +
        as_number(slice1cost_pair_1_0_is_less)) mod 256;
      slice1cost_pair_1_1 <= (slice1cost_pair_1_1_choice + slice1cost_pair_1_1_folded_value +
        as_number(slice1cost_pair_1_1_is_less)) mod 256;
      slice1cost_pair_1_2 <= (slice1cost_pair_1_2_choice + slice1cost_pair_1_2_folded_value +
        as_number(slice1cost_pair_1_2_is_less)) mod 256;
      slice1cost_single_0_0 <= folded(slice1cost_difference_0_0);
      slice1cost_single_0_1 <= folded(slice1cost_difference_0_1);
      slice1cost_single_0_2 <= folded(slice1cost_difference_0_2);
      slice1cost_single_2_0 <= folded(slice1cost_difference_2_0);
      slice1cost_single_2_1 <= folded(slice1cost_difference_2_1);
      slice1cost_single_2_2 <= folded(slice1cost_difference_2_2);
      slice1cost_single_3_0 <= slice1cost_pair_1_0_folded_value;
      slice1cost_single_3_1 <= slice1cost_pair_1_1_folded_value;
      slice1cost_single_3_2 <= slice1cost_pair_1_2_folded_value;
      slice1cost_single_5_0 <= folded(slice1cost_difference_5_0);
      slice1cost_single_5_1 <= folded(slice1cost_difference_5_1);
      slice1cost_single_5_2 <= folded(slice1cost_difference_5_2);
      slice1cost_negative_0_0 <= slice1cost_difference_0_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_0_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_0_2 < 0;
      slice1cost_negative_2_0 <= slice1cost_pair_0_0_is_less;
      slice1cost_negative_2_1 <= slice1cost_pair_0_1_is_less;
      slice1cost_negative_2_2 <= slice1cost_pair_0_2_is_less;
      slice1cost_negative_3_0 <= slice1cost_pair_1_0_is_less;
      slice1cost_negative_3_1 <= slice1cost_pair_1_1_is_less;
      slice1cost_negative_3_2 <= slice1cost_pair_1_2_is_less;
      slice1cost_negative_5_0 <= slice1cost_difference_5_0 < 0;
      slice1cost_negative_5_1 <= slice1cost_difference_5_1 < 0;
      slice1cost_negative_5_2 <= slice1cost_difference_5_2 < 0;
      slice1cost_column_0_0 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_0_0) +
        slice1cost_pair_0_0 + slice1cost_single_0_0) mod 256;
      slice1cost_column_0_1 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_0_1) +
        slice1cost_pair_0_1 + slice1cost_single_0_1) mod 256;
      slice1cost_column_0_2 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_0_2) +
        slice1cost_pair_0_2 + slice1cost_single_0_2) mod 256;
      slice1cost_column_1_0 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_3_0) +
        slice1cost_pair_0_0 + slice1cost_single_3_0) mod 256;
      slice1cost_column_1_1 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_3_1) +
        slice1cost_pair_0_1 + slice1cost_single_3_1) mod 256;
      slice1cost_column_1_2 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_3_2) +
        slice1cost_pair_0_2 + slice1cost_single_3_2) mod 256;
      slice1cost_column_2_0 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_2_0) +
        slice1cost_pair_1_0 + slice1cost_single_2_0) mod 256;
      slice1cost_column_2_1 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_2_1) +
        slice1cost_pair_1_1 + slice1cost_single_2_1) mod 256;
      slice1cost_column_2_2 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_2_2) +
        slice1cost_pair_1_2 + slice1cost_single_2_2) mod 256;
      slice1cost_column_3_0 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_5_0) +
        slice1cost_pair_1_0 + slice1cost_single_5_0) mod 256;
      slice1cost_column_3_1 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_5_1) +
        slice1cost_pair_1_1 + slice1cost_single_5_1) mod 256;
      slice1cost_column_3_2 <= 0 when slice0cost_tag_border_column else (as_number(slice1cost_negative_5_2) +
        slice1cost_pair_1_2 + slice1cost_single_5_2) mod 256;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
      slice1cost_tag_first_cost <= slice0cost_tag_first_cost;
      slice1cost_tag_output_column <= slice0cost_tag_output_column;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_1_0 <= slice1cost_column_0_0 + slice1window_partial_0_0_0;
        slice1window_partial_0_1_1 <= slice1cost_column_0_1 + slice1window_partial_0_0_1;
        slice1window_partial_0_1_2 <= slice1cost_column_0_2 + slice1window_partial_0_0_2;
        slice1window_partial_1_0_0 <= slice1cost_column_1_0;
        slice1window_partial_1_0_1 <= slice1cost_column_1_1;
        slice1window_partial_1_0_2 <= slice1cost_column_1_2;
        slice1window_partial_1_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_0_0;
        slice1window_partial_1_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_0_1;
        slice1window_partial_1_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_0_2;
        slice1window_partial_2_0_0 <= slice1cost_column_2_0;
        slice1window_partial_2_0_1 <= slice1cost_column_2_1;
        slice1window_partial_2_0_2 <= slice1cost_column_2_2;
        slice1window_partial_2_1_0 <= slice1cost_column_2_0 + slice1window_partial_2_0_0;
        slice1window_partial_2_1_1 <= slice1cost_column_2_1 + slice1window_partial_2_0_1;
        slice1window_partial_2_1_2 <= slice1cost_column_2_2 + slice1window_partial_2_0_2;
        slice1window_partial_3_0_0 <= slice1cost_column_3_0;
        slice1window_partial_3_0_1 <= slice1cost_column_3_1;
        slice1window_partial_3_0_2 <= slice1cost_column_3_2;
        slice1window_partial_3_1_0 <= slice1cost_column_3_0 + slice1window_partial_3_0_0;
        slice1window_partial_3_1_1 <= slice1cost_column_3_1 + slice1window_partial_3_0_1;
        slice1window_partial_3_1_2 <= slice1cost_column_3_2 + slice1window_partial_3_0_2;
        slice1window_centre_0_output_column <= slice1cost_tag_output_column;
        slice1window_centre_0_first_column <= slice1cost_tag_first_cost;
      end if;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      slice1window_sum_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_1_0;
      slice1window_sum_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_1_1;
      slice1window_sum_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_1_2;
      slice1window_sum_2_0 <= slice1cost_column_2_0 + slice1window_partial_2_1_0;
      slice1window_sum_2_1 <= slice1cost_column_2_1 + slice1window_partial_2_1_1;
      slice1window_sum_2_2 <= slice1cost_column_2_2 + slice1window_partial_2_1_2;
      slice1window_sum_3_0 <= slice1cost_column_3_0 + slice1window_partial_3_1_0;
      slice1window_sum_3_1 <= slice1cost_column_3_1 + slice1window_partial_3_1_1;
      slice1window_sum_3_2 <= slice1cost_column_3_2 + slice1window_partial_3_1_2;
      slice1window_tag_output_column <= slice1window_centre_0_output_column;
      if slice0winner1_tag_valid then
        slice1window_tag_first_column <= slice2cost_tag_first_cost;
      end if;
      -- slice1other
      slice1other_cost_0_0_any := (not slice0winner1_tag_first_column) or (not slice1window_tag_output_column);
      slice1other_cost_0_0_is_not_less := slice1other_cost_0_1 >= slice1window_sum_0_0;
      slice1other_cost_0_0_choice := slice1window_sum_0_0 when slice1other_cost_0_0_is_not_less else
        slice1other_cost_0_1;
      slice1other_cost_0_0_choice_2 := slice1other_cost_0_0_choice when slice0winner1_tag_valid else
        slice1other_cost_0_0;
      slice1other_cost_0_0_choice_3 := slice1other_cost_0_1 when slice0winner1_tag_valid else slice1other_cost_0_0;
      slice1other_cost_0_0_choice_4 := slice1other_cost_0_0_choice_2 when slice1window_tag_output_column else
        slice1other_cost_0_0_choice_3;
      slice1other_cost_0_0_choice_5 := slice1window_sum_0_0 when slice0winner1_tag_valid else slice1other_cost_0_0;
      slice1other_cost_0_1_is_not_less := slice1other_cost_0_2 >= slice1window_sum_0_1;
      slice1other_cost_0_1_choice := slice1window_sum_0_1 when slice1other_cost_0_1_is_not_less else
        slice1other_cost_0_2;
      slice1other_cost_0_1_choice_2 := slice1other_cost_0_1_choice when slice0winner1_tag_valid else
        slice1other_cost_0_1;
      slice1other_cost_0_1_choice_3 := slice1other_cost_0_2 when slice0winner1_tag_valid else slice1other_cost_0_1;
      slice1other_cost_0_1_choice_4 := slice1other_cost_0_1_choice_2 when slice1window_tag_output_column else
        slice1other_cost_0_1_choice_3;
      slice1other_cost_0_1_choice_5 := slice1window_sum_0_1 when slice0winner1_tag_valid else slice1other_cost_0_1;
      slice1other_cost_0_2_is_not_less := slice0other_cost_out_0 >= slice1window_sum_0_2;
      slice1other_cost_0_2_choice := slice1window_sum_0_2 when slice0winner1_tag_valid else slice1other_cost_0_2;
      slice1other_cost_0_2_choice_2 := slice0other_cost_out_0 when slice0winner1_tag_valid else slice1other_cost_0_2;
      slice1other_cost_0_2_choice_3 := slice1other_cost_0_2_choice when slice1other_cost_0_2_is_not_less else
        slice1other_cost_0_2_choice_2;
      slice1other_cost_0_2_choice_4 := slice1other_cost_0_2_choice_3 when slice1window_tag_output_column else
        slice1other_cost_0_2_choice_2;
      slice1other_cost_1_0_is_not_less := slice1other_cost_1_1 >= slice1window_sum_1_0;
      slice1other_cost_1_0_choice := slice1window_sum_1_0 when slice1other_cost_1_0_is_not_less else
        slice1other_cost_1_1;
      slice1other_cost_1_0_choice_2 := slice1other_cost_1_0_choice when slice0winner1_tag_valid else
        slice1other_cost_1_0;
      slice1other_cost_1_0_choice_3 := slice1other_cost_1_1 when slice0winner1_tag_valid else slice1other_cost_1_0;
      slice1other_cost_1_0_choice_4 := slice1other_cost_1_0_choice_2 when slice1window_tag_output_column else
        slice1other_cost_1_0_choice_3;
      slice1other_cost_1_0_choice_5 := slice1window_sum_1_0 when slice0winner1_tag_valid else slice1other_cost_1_0;
      slice1other_cost_1_1_is_not_less := slice1other_cost_1_2 >= slice1window_sum_1_1;
      slice1other_cost_1_1_choice := slice1window_sum_1_1 when slice1other_cost_1_1_is_not_less else
        slice1other_cost_1_2;
      slice1other_cost_1_1_choice_2 := slice1other_cost_1_1_choice when slice0winner1_tag_valid else
        slice1other_cost_1_1;
      slice1other_cost_1_1_choice_3 := slice1other_cost_1_2 when slice0winner1_tag_valid else slice1other_cost_1_1;
      slice1other_cost_1_1_choice_4 := slice1other_cost_1_1_choice_2 when slice1window_tag_output_column else
        slice1other_cost_1_1_choice_3;
      slice1other_cost_1_1_choice_5 := slice1window_sum_1_1 when slice0winner1_tag_valid else slice1other_cost_1_1;
      slice1other_cost_1_2_is_not_less := slice0other_cost_out_1 >= slice1window_sum_1_2;
      slice1other_cost_1_2_choice := slice1window_sum_1_2 when slice0winner1_tag_valid else slice1other_cost_1_2;
      slice1other_cost_1_2_choice_2 := slice0other_cost_out_1 when slice0winner1_tag_valid else slice1other_cost_1_2;
      slice1other_cost_1_2_choice_3 := slice1other_cost_1_2_choice when slice1other_cost_1_2_is_not_less else
        slice1other_cost_1_2_choice_2;
      slice1other_cost_1_2_choice_4 := slice1other_cost_1_2_choice_3 when slice1window_tag_output_column else
        slice1other_cost_1_2_choice_2;
      slice1other_cost_2_0_is_not_less := slice1other_cost_2_1 >= slice1window_sum_2_0;
      slice1other_cost_2_0_choice := slice1window_sum_2_0 when slice1other_cost_2_0_is_not_less else
        slice1other_cost_2_1;
      slice1other_cost_2_0_choice_2 := slice1other_cost_2_0_choice when slice0winner1_tag_valid else
        slice1other_cost_2_0;
      slice1other_cost_2_0_choice_3 := slice1other_cost_2_1 when slice0winner1_tag_valid else slice1other_cost_2_0;
      slice1other_cost_2_0_choice_4 := slice1other_cost_2_0_choice_2 when slice1window_tag_output_column else
        slice1other_cost_2_0_choice_3;
      slice1other_cost_2_0_choice_5 := slice1window_sum_2_0 when slice0winner1_tag_valid else slice1other_cost_2_0;
      slice1other_cost_2_1_is_not_less := slice1other_cost_2_2 >= slice1window_sum_2_1;
      slice1other_cost_2_1_choice := slice1window_sum_2_1 when slice1other_cost_2_1_is_not_less else
        slice1other_cost_2_2;
      slice1other_cost_2_1_choice_2 := slice1other_cost_2_1_choice when slice0winner1_tag_valid else
        slice1other_cost_2_1;
      slice1other_cost_2_1_choice_3 := slice1other_cost_2_2 when slice0winner1_tag_valid else slice1other_cost_2_1;
      slice1other_cost_2_1_choice_4 := slice1other_cost_2_1_choice_2 when slice1window_tag_output_column else
        slice1other_cost_2_1_choice_3;
      slice1other_cost_2_1_choice_5 := slice1window_sum_2_1 when slice0winner1_tag_valid else slice1other_cost_2_1;
      slice1other_cost_2_2_is_not_less := slice0other_cost_out_2 >= slice1window_sum_2_2;
      slice1other_cost_2_2_choice := slice1window_sum_2_2 when slice0winner1_tag_valid else slice1other_cost_2_2;
      slice1other_cost_2_2_choice_2 := slice0other_cost_out_2 when slice0winner1_tag_valid else slice1other_cost_2_2;
      slice1other_cost_2_2_choice_3 := slice1other_cost_2_2_choice when slice1other_cost_2_2_is_not_less else
        slice1other_cost_2_2_choice_2;
      slice1other_cost_2_2_choice_4 := slice1other_cost_2_2_choice_3 when slice1window_tag_output_column else
        slice1other_cost_2_2_choice_2;
      slice1other_cost_3_0_is_not_less := slice1other_cost_3_1 >= slice1window_sum_3_0;
      slice1other_cost_3_0_choice := slice1window_sum_3_0 when slice1other_cost_3_0_is_not_less else
        slice1other_cost_3_1;
      slice1other_cost_3_0_choice_2 := slice1other_cost_3_0_choice when slice0winner1_tag_valid else
        slice1other_cost_3_0;
      slice1other_cost_3_0_choice_3 := slice1other_cost_3_1 when slice0winner1_tag_valid else slice1other_cost_3_0;
      slice1other_cost_3_0_choice_4 := slice1other_cost_3_0_choice_2 when slice1window_tag_output_column else
        slice1other_cost_3_0_choice_3;
      slice1other_cost_3_0_choice_5 := slice1window_sum_3_0 when slice0winner1_tag_valid else slice1other_cost_3_0;
      slice1other_cost_3_1_is_not_less := slice1other_cost_3_2 >= slice1window_sum_3_1;
      slice1other_cost_3_1_choice := slice1window_sum_3_1 when slice1other_cost_3_1_is_not_less else
        slice1other_cost_3_2;
      slice1other_cost_3_1_choice_2 := slice1other_cost_3_1_choice when slice0winner1_tag_valid else
        slice1other_cost_3_1;
      slice1other_cost_3_1_choice_3 := slice1other_cost_3_2 when slice0winner1_tag_valid else slice1other_cost_3_1;
      slice1other_cost_3_1_choice_4 := slice1other_cost_3_1_choice_2 when slice1window_tag_output_column else
        slice1other_cost_3_1_choice_3;
      slice1other_cost_3_1_choice_5 := slice1window_sum_3_1 when slice0winner1_tag_valid else slice1other_cost_3_1;
      slice1other_winner_0_0_choice := 2 when slice1other_cost_0_0_is_not_less else slice1other_winner_0_1;
      slice1other_winner_0_0_choice_2 := slice1other_winner_0_0_choice when slice0winner1_tag_valid else
        slice1other_winner_0_0;
      slice1other_winner_0_0_choice_3 := slice1other_winner_0_1 when slice0winner1_tag_valid else
        slice1other_winner_0_0;
      slice1other_winner_0_0_choice_4 := slice1other_winner_0_0_choice_2 when slice1window_tag_output_column else
        slice1other_winner_0_0_choice_3;
      slice1other_winner_0_0_choice_5 := 2 when slice0winner1_tag_valid else slice1other_winner_0_0;
      slice1other_winner_0_1_choice := 3 when slice1other_cost_0_1_is_not_less else slice1other_winner_0_2;
      slice1other_winner_0_1_choice_2 := slice1other_winner_0_1_choice when slice0winner1_tag_valid else
        slice1other_winner_0_1;
      slice1other_winner_0_1_choice_3 := slice1other_winner_0_2 when slice0winner1_tag_valid else
        slice1other_winner_0_1;
      slice1other_winner_0_1_choice_4 := slice1other_winner_0_1_choice_2 when slice1window_tag_output_column else
        slice1other_winner_0_1_choice_3;
      slice1other_winner_0_1_choice_5 := 3 when slice0winner1_tag_valid else slice1other_winner_0_1;
      slice1other_winner_0_2_choice := 4 when slice1other_cost_0_2_is_not_less else slice0other_winner_out_0;
      slice1other_winner_0_2_choice_2 := slice1other_winner_0_2_choice when slice0winner1_tag_valid else
        slice1other_winner_0_2;
      slice1other_winner_0_2_choice_3 := slice0other_winner_out_0 when slice0winner1_tag_valid else
        slice1other_winner_0_2;
      slice1other_winner_0_2_choice_4 := slice1other_winner_0_2_choice_2 when slice1window_tag_output_column else
        slice1other_winner_0_2_choice_3;
      slice1other_winner_0_2_choice_5 := 4 when slice0winner1_tag_valid else slice1other_winner_0_2;
      slice1other_winner_1_0_choice := 2 when slice1other_cost_1_0_is_not_less else slice1other_winner_1_1;
      slice1other_winner_1_0_choice_2 := slice1other_winner_1_0_choice when slice0winner1_tag_valid else
        slice1other_winner_1_0;
      slice1other_winner_1_0_choice_3 := slice1other_winner_1_1 when slice0winner1_tag_valid else
        slice1other_winner_1_0;
      slice1other_winner_1_0_choice_4 := slice1other_winner_1_0_choice_2 when slice1window_tag_output_column else
        slice1other_winner_1_0_choice_3;
      slice1other_winner_1_0_choice_5 := 2 when slice0winner1_tag_valid else slice1other_winner_1_0;
      slice1other_winner_1_1_choice := 3 when slice1other_cost_1_1_is_not_less else slice1other_winner_1_2;
      slice1other_winner_1_1_choice_2 := slice1other_winner_1_1_choice when slice0winner1_tag_valid else
        slice1other_winner_1_1;
      slice1other_winner_1_1_choice_3 := slice1other_winner_1_2 when slice0winner1_tag_valid else
        slice1other_winner_1_1;
      slice1other_winner_1_1_choice_4 := slice1other_winner_1_1_choice_2 when slice1window_tag_output_column else
        slice1other_winner_1_1_choice_3;
      slice1other_winner_1_1_choice_5 := 3 when slice0winner1_tag_valid else slice1other_winner_1_1;
      slice1other_winner_1_2_choice := 4 when slice1other_cost_1_2_is_not_less else slice0other_winner_out_1;
      slice1other_winner_1_2_choice_2 := slice1other_winner_1_2_choice when slice0winner1_tag_valid else
        slice1other_winner_1_2;
      slice1other_winner_1_2_choice_3 := slice0other_winner_out_1 when slice0winner1_tag_valid else
        slice1other_winner_1_2;
      slice1other_winner_1_2_choice_4 := slice1other_winner_1_2_choice_2 when slice1window_tag_output_column else
        slice1other_winner_1_2_choice_3;
      slice1other_winner_1_2_choice_5 := 4 when slice0winner1_tag_valid else slice1other_winner_1_2;
      slice1other_winner_2_0_choice := 2 when slice1other_cost_2_0_is_not_less else slice1other_winner_2_1;
      slice1other_winner_2_0_choice_2 := slice1other_winner_2_0_choice when slice0winner1_tag_valid else
        slice1other_winner_2_0;
      slice1other_winner_2_0_choice_3 := slice1other_winner_2_1 when slice0winner1_tag_valid else
        slice1other_winner_2_0;
      slice1other_winner_2_0_choice_4 := slice1other_winner_2_0_choice_2 when slice1window_tag_output_column else
        slice1other_winner_2_0_choice_3;
      slice1other_winner_2_0_choice_5 := 2 when slice0winner1_tag_valid else slice1other_winner_2_0;
      slice1other_winner_2_1_choice := 3 when slice1other_cost_2_1_is_not_less else slice1other_winner_2_2;
      slice1other_winner_2_1_choice_2 := slice1other_winner_2_1_choice when slice0winner1_tag_valid else
        slice1other_winner_2_1;
      slice1other_winner_2_1_choice_3 := slice1other_winner_2_2 when slice0winner1_tag_valid else
        slice1other_winner_2_1;
      slice1other_winner_2_1_choice_4 := slice1other_winner_2_1_choice_2 when slice1window_tag_output_column else
        slice1other_winner_2_1_choice_3;
      slice1other_winner_2_1_choice_5 := 3 when slice0winner1_tag_valid else slice1other_winner_2_1;
      slice1other_winner_2_2_choice := 4 when slice1other_cost_2_2_is_not_less else slice0other_winner_out_2;
      slice1other_winner_2_2_choice_2 := slice1other_winner_2_2_choice when slice0winner1_tag_valid else
        slice1other_winner_2_2;
      slice1other_winner_2_2_choice_3 := slice0other_winner_out_2 when slice0winner1_tag_valid else
        slice1other_winner_2_2;
      slice1other_winner_2_2_choice_4 := slice1other_winner_2_2_choice_2 when slice1window_tag_output_column else
        slice1other_winner_2_2_choice_3;
      slice1other_winner_2_2_choice_5 := 4 when slice0winner1_tag_valid else slice1other_winner_2_2;
      slice1other_winner_3_0_choice := 2 when slice1other_cost_3_0_is_not_less else slice1other_winner_3_1;
      slice1other_winner_3_0_choice_2 := slice1other_winner_3_0_choice when slice0winner1_tag_valid else
        slice1other_winner_3_0;
      slice1other_winner_3_0_choice_3 := slice1other_winner_3_1 when slice0winner1_tag_valid else
        slice1other_winner_3_0;
      slice1other_winner_3_0_choice_4 := slice1other_winner_3_0_choice_2 when slice1window_tag_output_column else
        slice1other_winner_3_0_choice_3;
      slice1other_winner_3_0_choice_5 := 2 when slice0winner1_tag_valid else slice1other_winner_3_0;
      slice1other_winner_3_1_choice := 3 when slice1other_cost_3_1_is_not_less else slice1other_winner_3_2;
      slice1other_winner_3_1_choice_2 := slice1other_winner_3_1_choice when slice0winner1_tag_valid else
        slice1other_winner_3_1;
      slice1other_winner_3_1_choice_3 := slice1other_winner_3_2 when slice0winner1_tag_valid else
        slice1other_winner_3_1;
      slice1other_winner_3_1_choice_4 := slice1other_winner_3_1_choice_2 when slice1window_tag_output_column else
        slice1other_winner_3_1_choice_3;
      slice1other_winner_3_1_choice_5 := 3 when slice0winner1_tag_valid else slice1other_winner_3_1;
      slice1other_cost_0_0 <= slice1other_cost_0_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_0_0_choice_5;
      slice1other_cost_0_1 <= slice1other_cost_0_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_0_1_choice_5;
      slice1other_cost_0_2 <= slice1other_cost_0_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_0_2_choice;
      slice1other_cost_1_0 <= slice1other_cost_1_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_1_0_choice_5;
      slice1other_cost_1_1 <= slice1other_cost_1_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_1_1_choice_5;
      slice1other_cost_1_2 <= slice1other_cost_1_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_1_2_choice;
      slice1other_cost_2_0 <= slice1other_cost_2_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_2_0_choice_5;
      slice1other_cost_2_1 <= slice1other_cost_2_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_2_1_choice_5;
      slice1other_cost_2_2 <= slice1other_cost_2_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_2_2_choice;
      slice1other_cost_3_0 <= slice1other_cost_3_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_3_0_choice_5;
      slice1other_cost_3_1 <= slice1other_cost_3_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_cost_3_1_choice_5;
      slice1other_winner_0_0 <= slice1other_winner_0_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_0_0_choice_5;
      slice1other_winner_0_1 <= slice1other_winner_0_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_0_1_choice_5;
      slice1other_winner_0_2 <= slice1other_winner_0_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_0_2_choice_5;
      slice1other_winner_1_0 <= slice1other_winner_1_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_1_0_choice_5;
      slice1other_winner_1_1 <= slice1other_winner_1_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_1_1_choice_5;
      slice1other_winner_1_2 <= slice1other_winner_1_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_1_2_choice_5;
      slice1other_winner_2_0 <= slice1other_winner_2_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_2_0_choice_5;
      slice1other_winner_2_1 <= slice1other_winner_2_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_2_1_choice_5;
      slice1other_winner_2_2 <= slice1other_winner_2_2_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_2_2_choice_5;
      slice1other_winner_3_0 <= slice1other_winner_3_0_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_3_0_choice_5;
      slice1other_winner_3_1 <= slice1other_winner_3_1_choice_4 when slice1other_cost_0_0_any else
        slice1other_winner_3_1_choice_5;
      slice1other_cost_out_0 <= slice1other_cost_0_0;
      slice1other_cost_out_1 <= slice1other_cost_1_0;
      slice1other_cost_out_2 <= slice1other_cost_2_0;
      slice1other_cost_out_3 <= slice1other_cost_3_0;
      slice1other_winner_out_0 <= slice1other_winner_0_0;
      slice1other_winner_out_1 <= slice1other_winner_1_0;
      slice1other_winner_out_2 <= slice1other_winner_2_0;
      slice1other_winner_out_3 <= slice1other_winner_3_0;
      slice1other_cost_3_2_is_not_less := slice0other_cost_out_3 >= slice1window_sum_3_2;
      slice1other_cost_3_2_choice := slice1window_sum_3_2 when slice1other_cost_3_2_is_not_less else
        slice0other_cost_out_3;
      slice1other_cost_3_2_choice_2 := slice1other_cost_3_2_choice when slice1window_tag_output_column else
        slice0other_cost_out_3;
      slice1other_winner_3_2_choice := 4 when slice1other_cost_3_2_is_not_less else slice0other_winner_out_3;
      slice1other_winner_3_2_choice_2 := slice1other_winner_3_2_choice when slice1window_tag_output_column else
        slice0other_winner_out_3;
      if slice0winner1_tag_valid then
        slice1other_cost_3_2 <= slice1other_cost_3_2_choice_2 when slice1other_cost_0_0_any else slice1window_sum_3_2;
        slice1other_winner_3_2 <= slice1other_winner_3_2_choice_2 when slice1other_cost_0_0_any else 4;
      end if;
      -- slice1winner1
      slice1winner1_cost_0_0_is_less := slice1window_sum_0_1 < slice1window_sum_0_0;
      slice1winner1_cost_1_0_is_less := slice1window_sum_1_1 < slice1window_sum_1_0;
      slice1winner1_cost_2_0_is_less := slice1window_sum_2_1 < slice1window_sum_2_0;
      slice1winner1_cost_3_0_is_less := slice1window_sum_3_1 < slice1window_sum_3_0;
      slice1winner1_cost_0_0 <= slice1window_sum_0_1 when slice1winner1_cost_0_0_is_less else slice1window_sum_0_0;
      slice1winner1_cost_0_1 <= slice1window_sum_0_2;
      slice1winner1_cost_1_0 <= slice1window_sum_1_1 when slice1winner1_cost_1_0_is_less else slice1window_sum_1_0;
      slice1winner1_cost_1_1 <= slice1window_sum_1_2;
      slice1winner1_cost_2_0 <= slice1window_sum_2_1 when slice1winner1_cost_2_0_is_less else slice1window_sum_2_0;
      slice1winner1_cost_2_1 <= slice1window_sum_2_2;
      slice1winner1_cost_3_0 <= slice1window_sum_3_1 when slice1winner1_cost_3_0_is_less else slice1window_sum_3_0;
      slice1winner1_cost_3_1 <= slice1window_sum_3_2;
      slice1winner1_index_0_0 <= slice1winner1_cost_0_0_is_less;
      slice1winner1_index_1_0 <= slice1winner1_cost_1_0_is_less;
      slice1winner1_index_2_0 <= slice1winner1_cost_2_0_is_less;
      slice1winner1_index_3_0 <= slice1winner1_cost_3_0_is_less;
      slice1winner1_below_0_0 <= slice1window_sum_0_0 when slice1winner1_cost_0_0_is_less else 0;
      slice1winner1_below_1_0 <= slice1window_sum_1_0 when slice1winner1_cost_1_0_is_less else 0;
      slice1winner1_below_2_0 <= slice1window_sum_2_0 when slice1winner1_cost_2_0_is_less else 0;
      slice1winner1_below_3_0 <= slice1window_sum_3_0 when slice1winner1_cost_3_0_is_less else 0;
      slice1winner1_above_0_0 <= 0 when slice1winner1_cost_0_0_is_less else slice1window_sum_0_1;
      slice1winner1_above_1_0 <= 0 when slice1winner1_cost_1_0_is_less else slice1window_sum_1_1;
      slice1winner1_above_2_0 <= 0 when slice1winner1_cost_2_0_is_less else slice1window_sum_2_1;
      slice1winner1_above_3_0 <= 0 when slice1winner1_cost_3_0_is_less else slice1window_sum_3_1;
      slice1winner1_first_0_0 <= slice1window_sum_0_0;
      slice1winner1_first_1_0 <= slice1window_sum_1_0;
      slice1winner1_first_2_0 <= slice1window_sum_2_0;
      slice1winner1_first_3_0 <= slice1window_sum_3_0;
      slice1winner1_last_0_0 <= slice1window_sum_0_1;
      slice1winner1_last_1_0 <= slice1window_sum_1_1;
      slice1winner1_last_2_0 <= slice1window_sum_2_1;
      slice1winner1_last_3_0 <= slice1window_sum_3_1;
      slice1winner1_but_first_0_0 <= slice1window_sum_0_1;
      slice1winner1_but_first_1_0 <= slice1window_sum_1_1;
      slice1winner1_but_first_2_0 <= slice1window_sum_2_1;
      slice1winner1_but_first_3_0 <= slice1window_sum_3_1;
      slice1winner1_but_last_0_0 <= slice1window_sum_0_0;
      slice1winner1_but_last_1_0 <= slice1window_sum_1_0;
      slice1winner1_but_last_2_0 <= slice1window_sum_2_0;
      slice1winner1_but_last_3_0 <= slice1window_sum_3_0;
      -- slice1winner2
      slice1winner2_cost_0_0_is_less := slice1winner1_cost_0_1 < slice1winner1_cost_0_0;
      slice1winner2_cost_1_0_is_less := slice1winner1_cost_1_1 < slice1winner1_cost_1_0;
      slice1winner2_cost_2_0_is_less := slice1winner1_cost_2_1 < slice1winner1_cost_2_0;
      slice1winner2_cost_3_0_is_less := slice1winner1_cost_3_1 < slice1winner1_cost_3_0;
      slice1winner2_above_0_0_choice := slice1winner1_cost_0_1 when slice1winner1_index_0_0 else
        slice1winner1_above_0_0;
      slice1winner2_above_1_0_choice := slice1winner1_cost_1_1 when slice1winner1_index_1_0 else
        slice1winner1_above_1_0;
      slice1winner2_above_2_0_choice := slice1winner1_cost_2_1 when slice1winner1_index_2_0 else
        slice1winner1_above_2_0;
      slice1winner2_above_3_0_choice := slice1winner1_cost_3_1 when slice1winner1_index_3_0 else
        slice1winner1_above_3_0;
      slice1winner2_second_0_0_choice := slice0winner1_second_0_0 when slice1winner1_index_0_0 else
        slice1winner1_cost_0_1;
      slice1winner2_second_0_0_choice_2 := slice1winner1_first_0_0 when slice1winner2_cost_0_0_is_less else
        slice1winner2_second_0_0_choice;
      slice1winner2_second_1_0_choice := slice0winner1_second_0_0 when slice1winner1_index_1_0 else
        slice1winner1_cost_1_1;
      slice1winner2_second_1_0_choice_2 := slice1winner1_first_1_0 when slice1winner2_cost_1_0_is_less else
        slice1winner2_second_1_0_choice;
      slice1winner2_second_2_0_choice := slice0winner1_second_0_0 when slice1winner1_index_2_0 else
        slice1winner1_cost_2_1;
      slice1winner2_second_2_0_choice_2 := slice1winner1_first_2_0 when slice1winner2_cost_2_0_is_less else
        slice1winner2_second_2_0_choice;
      slice1winner2_second_3_0_choice := slice0winner1_second_0_0 when slice1winner1_index_3_0 else
        slice1winner1_cost_3_1;
      slice1winner2_second_3_0_choice_2 := slice1winner1_first_3_0 when slice1winner2_cost_3_0_is_less else
        slice1winner2_second_3_0_choice;
      slice1winner2_cost_0_0 <= slice1winner1_cost_0_1 when slice1winner2_cost_0_0_is_less else slice1winner1_cost_0_0;
      slice1winner2_cost_1_0 <= slice1winner1_cost_1_1 when slice1winner2_cost_1_0_is_less else slice1winner1_cost_1_0;
      slice1winner2_cost_2_0 <= slice1winner1_cost_2_1 when slice1winner2_cost_2_0_is_less else slice1winner1_cost_2_0;
      slice1winner2_cost_3_0 <= slice1winner1_cost_3_1 when slice1winner2_cost_3_0_is_less else slice1winner1_cost_3_0;
      slice1winner2_index_0_0 <= slice0winner1_index_0_1 when slice1winner2_cost_0_0_is_less else
        as_number(slice1winner1_index_0_0);
      slice1winner2_index_1_0 <= slice0winner1_index_0_1 when slice1winner2_cost_1_0_is_less else
        as_number(slice1winner1_index_1_0);
      slice1winner2_index_2_0 <= slice0winner1_index_0_1 when slice1winner2_cost_2_0_is_less else
        as_number(slice1winner1_index_2_0);
      slice1winner2_index_3_0 <= slice0winner1_index_0_1 when slice1winner2_cost_3_0_is_less else
        as_number(slice1winner1_index_3_0);
      slice1winner2_below_0_0 <= slice1winner1_but_first_0_0 when slice1winner2_cost_0_0_is_less else
        slice1winner1_below_0_0;
      slice1winner2_below_1_0 <= slice1winner1_but_first_1_0 when slice1winner2_cost_1_0_is_less else
        slice1winner1_below_1_0;
      slice1winner2_below_2_0 <= slice1winner1_but_first_2_0 when slice1winner2_cost_2_0_is_less else
        slice1winner1_below_2_0;
      slice1winner2_below_3_0 <= slice1winner1_but_first_3_0 when slice1winner2_cost_3_0_is_less else
        slice1winner1_below_3_0;
      slice1winner2_above_0_0 <= 0 when slice1winner2_cost_0_0_is_less else slice1winner2_above_0_0_choice;
      slice1winner2_above_1_0 <= 0 when slice1winner2_cost_1_0_is_less else slice1winner2_above_1_0_choice;
      slice1winner2_above_2_0 <= 0 when slice1winner2_cost_2_0_is_less else slice1winner2_above_2_0_choice;
      slice1winner2_above_3_0 <= 0 when slice1winner2_cost_3_0_is_less else slice1winner2_above_3_0_choice;
      slice1winner2_first_0_0 <= slice1winner1_but_last_0_0;
      slice1winner2_first_1_0 <= slice1winner1_but_last_1_0;
      slice1winner2_first_2_0 <= slice1winner1_but_last_2_0;
      slice1winner2_first_3_0 <= slice1winner1_but_last_3_0;
      slice1winner2_last_0_0 <= slice1winner1_cost_0_1;
      slice1winner2_last_1_0 <= slice1winner1_cost_1_1;
      slice1winner2_last_2_0 <= slice1winner1_cost_2_1;
      slice1winner2_last_3_0 <= slice1winner1_cost_3_1;
      slice1winner2_second_0_0 <= slice1winner2_second_0_0_choice_2 when slice1winner2_second_0_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice1winner2_second_1_0 <= slice1winner2_second_1_0_choice_2 when slice1winner2_second_1_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice1winner2_second_2_0 <= slice1winner2_second_2_0_choice_2 when slice1winner2_second_2_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice1winner2_second_3_0 <= slice1winner2_second_3_0_choice_2 when slice1winner2_second_3_0_choice_2 <
        slice0winner1_second_0_0 else slice0winner1_second_0_0;
      slice1winner2_but_first_0_0 <= slice1winner1_cost_0_1 when slice1winner1_cost_0_1 < slice1winner1_last_0_0 else
        slice1winner1_last_0_0;
      slice1winner2_but_first_1_0 <= slice1winner1_cost_1_1 when slice1winner1_cost_1_1 < slice1winner1_last_1_0 else
        slice1winner1_last_1_0;
      slice1winner2_but_first_2_0 <= slice1winner1_cost_2_1 when slice1winner1_cost_2_1 < slice1winner1_last_2_0 else
        slice1winner1_last_2_0;
      slice1winner2_but_first_3_0 <= slice1winner1_cost_3_1 when slice1winner1_cost_3_1 < slice1winner1_last_3_0 else
        slice1winner1_last_3_0;
      slice1winner2_but_last_0_0 <= slice0winner1_second_0_0 when slice0winner1_second_0_0 < slice1winner1_cost_0_0
        else slice1winner1_cost_0_0;
      slice1winner2_but_last_1_0 <= slice0winner1_second_0_0 when slice0winner1_second_0_0 < slice1winner1_cost_1_0
        else slice1winner1_cost_1_0;
      slice1winner2_but_last_2_0 <= slice0winner1_second_0_0 when slice0winner1_second_0_0 < slice1winner1_cost_2_0
        else slice1winner1_cost_2_0;
      slice1winner2_but_last_3_0 <= slice0winner1_second_0_0 when slice0winner1_second_0_0 < slice1winner1_cost_3_0
        else slice1winner1_cost_3_0;
      -- slice1best
      slice1best_cost_0_0_is_less := slice0best_cost_0_0 < slice1winner2_cost_0_0;
      slice1best_cost_1_0_is_less := slice0best_cost_1_0 < slice1winner2_cost_1_0;
      slice1best_cost_2_0_is_less := slice0best_cost_2_0 < slice1winner2_cost_2_0;
      slice1best_cost_3_0_is_less := slice0best_cost_3_0 < slice1winner2_cost_3_0;
      slice1best_index_0_0_sum := (slice1winner2_index_0_0 / 2) + 1;
      slice1best_index_1_0_sum := (slice1winner2_index_1_0 / 2) + 1;
      slice1best_index_2_0_sum := (slice1winner2_index_2_0 / 2) + 1;
      slice1best_index_3_0_sum := (slice1winner2_index_3_0 / 2) + 1;
      slice1best_below_0_0_is_equal := slice0best_index_0_0 = 5;
      slice1best_below_0_0_choice := slice1winner2_last_0_0 when slice1best_below_0_0_is_equal else
        slice0best_below_0_0;
      slice1best_below_1_0_is_equal := slice0best_index_1_0 = 5;
      slice1best_below_1_0_choice := slice1winner2_last_1_0 when slice1best_below_1_0_is_equal else
        slice0best_below_1_0;
      slice1best_below_2_0_is_equal := slice0best_index_2_0 = 5;
      slice1best_below_2_0_choice := slice1winner2_last_2_0 when slice1best_below_2_0_is_equal else
        slice0best_below_2_0;
      slice1best_below_3_0_is_equal := slice0best_index_3_0 = 5;
      slice1best_below_3_0_choice := slice1winner2_last_3_0 when slice1best_below_3_0_is_equal else
        slice0best_below_3_0;
      slice1best_above_0_0_all := (slice1best_index_0_0_sum = 2) and (not ((slice1winner2_index_0_0 mod 2) = 1));
      slice1best_above_0_0_choice := slice0best_first_0_0 when slice1best_above_0_0_all else slice1winner2_above_0_0;
      slice1best_above_1_0_all := (slice1best_index_1_0_sum = 2) and (not ((slice1winner2_index_1_0 mod 2) = 1));
      slice1best_above_1_0_choice := slice0best_first_1_0 when slice1best_above_1_0_all else slice1winner2_above_1_0;
      slice1best_above_2_0_all := (slice1best_index_2_0_sum = 2) and (not ((slice1winner2_index_2_0 mod 2) = 1));
      slice1best_above_2_0_choice := slice0best_first_2_0 when slice1best_above_2_0_all else slice1winner2_above_2_0;
      slice1best_above_3_0_all := (slice1best_index_3_0_sum = 2) and (not ((slice1winner2_index_3_0 mod 2) = 1));
      slice1best_above_3_0_choice := slice0best_first_3_0 when slice1best_above_3_0_all else slice1winner2_above_3_0;
      slice1best_second_0_0_choice := slice1winner2_but_last_0_0 when slice1best_below_0_0_is_equal else
        slice1winner2_cost_0_0;
      slice1best_second_0_0_choice_2 := slice1best_second_0_0_choice when slice1best_second_0_0_choice <
        slice0best_second_0_0 else slice0best_second_0_0;
      slice1best_second_0_0_choice_3 := slice0best_but_first_0_0 when slice1best_above_0_0_all else slice0best_cost_0_0;
      slice1best_second_0_0_choice_4 := slice1best_second_0_0_choice_3 when slice1best_second_0_0_choice_3 <
        slice1winner2_second_0_0 else slice1winner2_second_0_0;
      slice1best_second_1_0_choice := slice1winner2_but_last_1_0 when slice1best_below_1_0_is_equal else
        slice1winner2_cost_1_0;
      slice1best_second_1_0_choice_2 := slice1best_second_1_0_choice when slice1best_second_1_0_choice <
        slice0best_second_1_0 else slice0best_second_1_0;
      slice1best_second_1_0_choice_3 := slice0best_but_first_1_0 when slice1best_above_1_0_all else slice0best_cost_1_0;
      slice1best_second_1_0_choice_4 := slice1best_second_1_0_choice_3 when slice1best_second_1_0_choice_3 <
        slice1winner2_second_1_0 else slice1winner2_second_1_0;
      slice1best_second_2_0_choice := slice1winner2_but_last_2_0 when slice1best_below_2_0_is_equal else
        slice1winner2_cost_2_0;
      slice1best_second_2_0_choice_2 := slice1best_second_2_0_choice when slice1best_second_2_0_choice <
        slice0best_second_2_0 else slice0best_second_2_0;
      slice1best_second_2_0_choice_3 := slice0best_but_first_2_0 when slice1best_above_2_0_all else slice0best_cost_2_0;
      slice1best_second_2_0_choice_4 := slice1best_second_2_0_choice_3 when slice1best_second_2_0_choice_3 <
        slice1winner2_second_2_0 else slice1winner2_second_2_0;
      slice1best_second_3_0_choice := slice1winner2_but_last_3_0 when slice1best_below_3_0_is_equal else
        slice1winner2_cost_3_0;
      slice1best_second_3_0_choice_2 := slice1best_second_3_0_choice when slice1best_second_3_0_choice <
        slice0best_second_3_0 else slice0best_second_3_0;
      slice1best_second_3_0_choice_3 := slice0best_but_first_3_0 when slice1best_above_3_0_all else slice0best_cost_3_0;
      slice1best_second_3_0_choice_4 := slice1best_second_3_0_choice_3 when slice1best_second_3_0_choice_3 <
        slice1winner2_second_3_0 else slice1winner2_second_3_0;
      slice1best_cost_0_0 <= slice0best_cost_0_0 when slice1best_cost_0_0_is_less else slice1winner2_cost_0_0;
      slice1best_cost_1_0 <= slice0best_cost_1_0 when slice1best_cost_1_0_is_less else slice1winner2_cost_1_0;
      slice1best_cost_2_0 <= slice0best_cost_2_0 when slice1best_cost_2_0_is_less else slice1winner2_cost_2_0;
      slice1best_cost_3_0 <= slice0best_cost_3_0 when slice1best_cost_3_0_is_less else slice1winner2_cost_3_0;
      slice1best_index_0_0 <= slice0best_index_0_0 when slice1best_cost_0_0_is_less else (slice1best_index_0_0_sum * 2)
        + (slice1winner2_index_0_0 mod 2);
      slice1best_index_1_0 <= slice0best_index_1_0 when slice1best_cost_1_0_is_less else (slice1best_index_1_0_sum * 2)
        + (slice1winner2_index_1_0 mod 2);
      slice1best_index_2_0 <= slice0best_index_2_0 when slice1best_cost_2_0_is_less else (slice1best_index_2_0_sum * 2)
        + (slice1winner2_index_2_0 mod 2);
      slice1best_index_3_0 <= slice0best_index_3_0 when slice1best_cost_3_0_is_less else (slice1best_index_3_0_sum * 2)
        + (slice1winner2_index_3_0 mod 2);
      slice1best_below_0_0 <= slice1best_below_0_0_choice when slice1best_cost_0_0_is_less else slice1winner2_below_0_0;
      slice1best_below_1_0 <= slice1best_below_1_0_choice when slice1best_cost_1_0_is_less else slice1winner2_below_1_0;
      slice1best_below_2_0 <= slice1best_below_2_0_choice when slice1best_cost_2_0_is_less else slice1winner2_below_2_0;
      slice1best_below_3_0 <= slice1best_below_3_0_choice when slice1best_cost_3_0_is_less else slice1winner2_below_3_0;
      slice1best_above_0_0 <= slice0best_above_0_0 when slice1best_cost_0_0_is_less else slice1best_above_0_0_choice;
      slice1best_above_1_0 <= slice0best_above_1_0 when slice1best_cost_1_0_is_less else slice1best_above_1_0_choice;
      slice1best_above_2_0 <= slice0best_above_2_0 when slice1best_cost_2_0_is_less else slice1best_above_2_0_choice;
      slice1best_above_3_0 <= slice0best_above_3_0 when slice1best_cost_3_0_is_less else slice1best_above_3_0_choice;
      slice1best_first_0_0 <= slice1winner2_first_0_0;
      slice1best_first_1_0 <= slice1winner2_first_1_0;
      slice1best_first_2_0 <= slice1winner2_first_2_0;
      slice1best_first_3_0 <= slice1winner2_first_3_0;
      slice1best_second_0_0 <= slice1best_second_0_0_choice_2 when slice1best_cost_0_0_is_less else
        slice1best_second_0_0_choice_4;
      slice1best_second_1_0 <= slice1best_second_1_0_choice_2 when slice1best_cost_1_0_is_less else
        slice1best_second_1_0_choice_4;
      slice1best_second_2_0 <= slice1best_second_2_0_choice_2 when slice1best_cost_2_0_is_less else
        slice1best_second_2_0_choice_4;
      slice1best_second_3_0 <= slice1best_second_3_0_choice_2 when slice1best_cost_3_0_is_less else
        slice1best_second_3_0_choice_4;
      slice1best_but_first_0_0 <= slice0best_cost_0_0 when slice0best_cost_0_0 < slice1winner2_but_first_0_0 else
        slice1winner2_but_first_0_0;
      slice1best_but_first_1_0 <= slice0best_cost_1_0 when slice0best_cost_1_0 < slice1winner2_but_first_1_0 else
        slice1winner2_but_first_1_0;
      slice1best_but_first_2_0 <= slice0best_cost_2_0 when slice0best_cost_2_0 < slice1winner2_but_first_2_0 else
        slice1winner2_but_first_2_0;
      slice1best_but_first_3_0 <= slice0best_cost_3_0 when slice0best_cost_3_0 < slice1winner2_but_first_3_0 else
        slice1winner2_but_first_3_0;
      slice1best_tag_valid <= slice0best_tag_valid;
      slice1best_tag_map_column <= slice0best_tag_map_column;
      slice1best_tag_output_column <= slice0best_tag_output_column;
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
        slice2shift_search_3_0 <= slice2shift_search_3_1;
        slice2shift_search_3_1 <= slice1shift_search_out_3;
        slice2shift_search_4_0 <= slice2shift_search_4_1;
        slice2shift_search_4_1 <= slice1shift_search_out_4;
        slice2shift_search_5_0 <= slice2shift_search_5_1;
        slice2shift_search_5_1 <= slice1shift_search_out_5;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_reference_2 <= slice1shift_reference_2;
      slice2shift_reference_3 <= slice1shift_reference_3;
      slice2shift_reference_4 <= slice1shift_reference_4;
      slice2shift_reference_5 <= slice1shift_reference_5;
      -- slice2cost
      slice2cost_pair_0_0_is_less := slice2cost_difference_2_0 < 0;
      slice2cost_pair_0_0_choice := slice2cost_reverse_0_0 when slice2cost_pair_0_0_is_less else
        positive_part(slice2cost_difference_2_0);
      slice2cost_pair_0_1_is_less := slice2cost_difference_2_1 < 0;
      slice2cost_pair_0_1_choice := slice2cost_reverse_0_1 when slice2cost_pair_0_1_is_less else
        positive_part(slice2cost_difference_2_1);
      slice2cost_pair_1_0_choice := slice2cost_reverse_1_0 when slice2cost_difference_4_0 < 0 else
        positive_part(slice2cost_difference_4_0);
      slice2cost_pair_1_0_folded_value := folded(slice2cost_difference_3_0);
      slice2cost_pair_1_0_is_less := slice2cost_difference_3_0 < 0;
      slice2cost_pair_1_1_choice := slice2cost_reverse_1_1 when slice2cost_difference_4_1 < 0 else
        positive_part(slice2cost_difference_4_1);
      slice2cost_pair_1_1_folded_value := folded(slice2cost_difference_3_1);
      slice2cost_pair_1_1_is_less := slice2cost_difference_3_1 < 0;
      slice2cost_difference_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_difference_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_difference_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_difference_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_difference_2_0 <= slice2shift_search_2_0 - slice2shift_reference_2;
      slice2cost_difference_2_1 <= slice2shift_search_2_1 - slice2shift_reference_2;
      slice2cost_difference_3_0 <= slice2shift_search_3_0 - slice2shift_reference_3;
      slice2cost_difference_3_1 <= slice2shift_search_3_1 - slice2shift_reference_3;
      slice2cost_difference_4_0 <= slice2shift_search_4_0 - slice2shift_reference_4;
      slice2cost_difference_4_1 <= slice2shift_search_4_1 - slice2shift_reference_4;
      slice2cost_difference_5_0 <= slice2shift_search_5_0 - slice2shift_reference_5;
      slice2cost_difference_5_1 <= slice2shift_search_5_1 - slice2shift_reference_5;
      slice2cost_reverse_0_0 <= (slice2shift_reference_2 - slice2shift_search_2_0) mod 256;
      slice2cost_reverse_0_1 <= (slice2shift_reference_2 - slice2shift_search_2_1) mod 256;
      slice2cost_reverse_1_0 <= (slice2shift_reference_4 - slice2shift_search_4_0) mod 256;
      slice2cost_reverse_1_1 <= (slice2shift_reference_4 - slice2shift_search_4_1) mod 256;
      slice2cost_pair_0_0 <= (slice2cost_pair_0_0_choice + folded(slice2cost_difference_1_0) +
        as_number((slice2cost_difference_1_0 < 0))) mod 256;
      slice2cost_pair_0_1 <= (slice2cost_pair_0_1_choice + folded(slice2cost_difference_1_1) +
        as_number((slice2cost_difference_1_1 < 0))) mod 256;
      slice2cost_pair_1_0 <= (slice2cost_pair_1_0_choice + slice2cost_pair_1_0_folded_value +
        as_number(slice2cost_pair_1_0_is_less)) mod 256;
      slice2cost_pair_1_1 <= (slice2cost_pair_1_1_choice + slice2cost_pair_1_1_folded_value +
        as_number(slice2cost_pair_1_1_is_less)) mod 256;
      slice2cost_single_0_0 <= folded(slice2cost_difference_0_0);
      slice2cost_single_0_1 <= folded(slice2cost_difference_0_1);
      slice2cost_single_2_0 <= folded(slice2cost_difference_2_0);
      slice2cost_single_2_1 <= folded(slice2cost_difference_2_1);
      slice2cost_single_3_0 <= slice2cost_pair_1_0_folded_value;
      slice2cost_single_3_1 <= slice2cost_pair_1_1_folded_value;
      slice2cost_single_5_0 <= folded(slice2cost_difference_5_0);
      slice2cost_single_5_1 <= folded(slice2cost_difference_5_1);
      slice2cost_negative_0_0 <= slice2cost_difference_0_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_0_1 < 0;
      slice2cost_negative_2_0 <= slice2cost_pair_0_0_is_less;
      slice2cost_negative_2_1 <= slice2cost_pair_0_1_is_less;
      slice2cost_negative_3_0 <= slice2cost_pair_1_0_is_less;
      slice2cost_negative_3_1 <= slice2cost_pair_1_1_is_less;
      slice2cost_negative_5_0 <= slice2cost_difference_5_0 < 0;
      slice2cost_negative_5_1 <= slice2cost_difference_5_1 < 0;
      slice2cost_column_0_0 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_0_0) +
        slice2cost_pair_0_0 + slice2cost_single_0_0) mod 256;
      slice2cost_column_0_1 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_0_1) +
        slice2cost_pair_0_1 + slice2cost_single_0_1) mod 256;
      slice2cost_column_1_0 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_3_0) +
        slice2cost_pair_0_0 + slice2cost_single_3_0) mod 256;
      slice2cost_column_1_1 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_3_1) +
        slice2cost_pair_0_1 + slice2cost_single_3_1) mod 256;
      slice2cost_column_2_0 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_2_0) +
        slice2cost_pair_1_0 + slice2cost_single_2_0) mod 256;
      slice2cost_column_2_1 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_2_1) +
        slice2cost_pair_1_1 + slice2cost_single_2_1) mod 256;
      slice2cost_column_3_0 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_5_0) +
        slice2cost_pair_1_0 + slice2cost_single_5_0) mod 256;
      slice2cost_column_3_1 <= 0 when slice1cost_tag_border_column else (as_number(slice2cost_negative_5_1) +
        slice2cost_pair_1_1 + slice2cost_single_5_1) mod 256;
      slice2cost_tag_first_cost <= slice1cost_tag_first_cost;
      slice2cost_tag_output_column <= slice1cost_tag_output_column;
      -- slice2window
      if slice0winner1_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
        slice2window_partial_1_0_0 <= slice2cost_column_1_0;
        slice2window_partial_1_0_1 <= slice2cost_column_1_1;
        slice2window_partial_1_1_0 <= slice2cost_column_1_0 + slice2window_partial_1_0_0;
        slice2window_partial_1_1_1 <= slice2cost_column_1_1 + slice2window_partial_1_0_1;
        slice2window_partial_2_0_0 <= slice2cost_column_2_0;
        slice2window_partial_2_0_1 <= slice2cost_column_2_1;
        slice2window_partial_2_1_0 <= slice2cost_column_2_0 + slice2window_partial_2_0_0;
        slice2window_partial_2_1_1 <= slice2cost_column_2_1 + slice2window_partial_2_0_1;
        slice2window_partial_3_0_0 <= slice2cost_column_3_0;
        slice2window_partial_3_0_1 <= slice2cost_column_3_1;
        slice2window_partial_3_1_0 <= slice2cost_column_3_0 + slice2window_partial_3_0_0;
        slice2window_partial_3_1_1 <= slice2cost_column_3_1 + slice2window_partial_3_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      slice2window_sum_1_0 <= slice2cost_column_1_0 + slice2window_partial_1_1_0;
      slice2window_sum_1_1 <= slice2cost_column_1_1 + slice2window_partial_1_1_1;
      slice2window_sum_2_0 <= slice2cost_column_2_0 + slice2window_partial_2_1_0;
      slice2window_sum_2_1 <= slice2cost_column_2_1 + slice2window_partial_2_1_1;
      slice2window_sum_3_0 <= slice2cost_column_3_0 + slice2window_partial_3_1_0;
      slice2window_sum_3_1 <= slice2cost_column_3_1 + slice2window_partial_3_1_1;
      -- slice2other
      slice2other_cost_0_1_all := (slice1other_cost_out_3 < slice2window_sum_3_1) and (not
        slice0winner2_tag_first_column) and slice0winner2_tag_output_column;
      slice2other_cost_0_1_is_not_less := slice1other_cost_out_0 >= slice2window_sum_0_1;
      slice2other_cost_0_1_choice := slice2window_sum_0_1 when slice0winner2_tag_valid else slice2other_cost_0_1;
      slice2other_cost_0_1_choice_2 := slice1other_cost_out_0 when slice0winner2_tag_valid else slice2other_cost_0_1;
      slice2other_cost_0_1_choice_3 := slice2other_cost_0_1_choice when slice2other_cost_0_1_is_not_less else
        slice2other_cost_0_1_choice_2;
      slice2other_cost_0_1_all_2 := (slice1other_cost_out_3 >= slice2window_sum_3_1) and (not
        slice0winner2_tag_first_column) and slice0winner2_tag_output_column;
      slice2other_cost_0_1_choice_4 := slice2other_cost_0_1_choice when slice0winner2_tag_output_column else
        slice2other_cost_0_1_choice_2;
      slice2other_cost_0_1_choice_5 := slice2other_cost_0_1_choice_3 when slice2other_cost_0_1_all_2 else
        slice2other_cost_0_1_choice_4;
      slice2other_cost_1_1_is_not_less := slice1other_cost_out_1 >= slice2window_sum_1_1;
      slice2other_cost_1_1_choice := slice2window_sum_1_1 when slice0winner2_tag_valid else slice2other_cost_1_1;
      slice2other_cost_1_1_choice_2 := slice1other_cost_out_1 when slice0winner2_tag_valid else slice2other_cost_1_1;
      slice2other_cost_1_1_choice_3 := slice2other_cost_1_1_choice when slice2other_cost_1_1_is_not_less else
        slice2other_cost_1_1_choice_2;
      slice2other_cost_1_1_choice_4 := slice2other_cost_1_1_choice when slice0winner2_tag_output_column else
        slice2other_cost_1_1_choice_2;
      slice2other_cost_1_1_choice_5 := slice2other_cost_1_1_choice_3 when slice2other_cost_0_1_all_2 else
        slice2other_cost_1_1_choice_4;
      slice2other_cost_2_1_is_not_less := slice1other_cost_out_2 >= slice2window_sum_2_1;
      slice2other_cost_2_1_choice := slice2window_sum_2_1 when slice0winner2_tag_valid else slice2other_cost_2_1;
      slice2other_cost_2_1_choice_2 := slice1other_cost_out_2 when slice0winner2_tag_valid else slice2other_cost_2_1;
      slice2other_cost_2_1_choice_3 := slice2other_cost_2_1_choice when slice2other_cost_2_1_is_not_less else
        slice2other_cost_2_1_choice_2;
      slice2other_cost_2_1_choice_4 := slice2other_cost_2_1_choice when slice0winner2_tag_output_column else
        slice2other_cost_2_1_choice_2;
      slice2other_cost_2_1_choice_5 := slice2other_cost_2_1_choice_3 when slice2other_cost_0_1_all_2 else
        slice2other_cost_2_1_choice_4;
      slice2other_cost_3_1_choice := slice1other_cost_out_3 when slice0winner2_tag_valid else slice2other_cost_3_1;
      slice2other_cost_3_1_choice_2 := slice2window_sum_3_1 when slice0winner2_tag_valid else slice2other_cost_3_1;
      slice2other_cost_3_1_choice_3 := slice2other_cost_3_1_choice_2 when slice0winner2_tag_output_column else
        slice2other_cost_3_1_choice;
      slice2other_cost_3_1_choice_4 := slice2other_cost_3_1_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_cost_3_1_choice_3;
      slice2other_winner_0_0_choice := 0 when slice2other_cost_0_1 >= slice2window_sum_0_0 else slice2other_winner_0_1;
      slice2other_winner_0_0_choice_2 := slice2other_winner_0_0_choice when slice0winner2_tag_valid else
        slice2other_winner_0_0;
      slice2other_winner_0_0_choice_3 := 0 when slice0winner2_tag_valid else slice2other_winner_0_0;
      slice2other_winner_0_0_choice_4 := slice2other_winner_0_1 when slice0winner2_tag_valid else
        slice2other_winner_0_0;
      slice2other_winner_0_0_choice_5 := slice2other_winner_0_0_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_0_0_choice_4;
      slice2other_winner_0_0_choice_6 := slice2other_winner_0_0_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_0_0_choice_5;
      slice2other_winner_0_1_choice := 1 when slice2other_cost_0_1_is_not_less else slice1other_winner_out_0;
      slice2other_winner_0_1_choice_2 := slice2other_winner_0_1_choice when slice0winner2_tag_valid else
        slice2other_winner_0_1;
      slice2other_winner_0_1_choice_3 := 1 when slice0winner2_tag_valid else slice2other_winner_0_1;
      slice2other_winner_0_1_choice_4 := slice1other_winner_out_0 when slice0winner2_tag_valid else
        slice2other_winner_0_1;
      slice2other_winner_0_1_choice_5 := slice2other_winner_0_1_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_0_1_choice_4;
      slice2other_winner_0_1_choice_6 := slice2other_winner_0_1_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_0_1_choice_5;
      slice2other_winner_1_0_choice := 0 when slice2other_cost_1_1 >= slice2window_sum_1_0 else slice2other_winner_1_1;
      slice2other_winner_1_0_choice_2 := slice2other_winner_1_0_choice when slice0winner2_tag_valid else
        slice2other_winner_1_0;
      slice2other_winner_1_0_choice_3 := 0 when slice0winner2_tag_valid else slice2other_winner_1_0;
      slice2other_winner_1_0_choice_4 := slice2other_winner_1_1 when slice0winner2_tag_valid else
        slice2other_winner_1_0;
      slice2other_winner_1_0_choice_5 := slice2other_winner_1_0_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_1_0_choice_4;
      slice2other_winner_1_0_choice_6 := slice2other_winner_1_0_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_1_0_choice_5;
      slice2other_winner_1_1_choice := 1 when slice2other_cost_1_1_is_not_less else slice1other_winner_out_1;
      slice2other_winner_1_1_choice_2 := slice2other_winner_1_1_choice when slice0winner2_tag_valid else
        slice2other_winner_1_1;
      slice2other_winner_1_1_choice_3 := 1 when slice0winner2_tag_valid else slice2other_winner_1_1;
      slice2other_winner_1_1_choice_4 := slice1other_winner_out_1 when slice0winner2_tag_valid else
        slice2other_winner_1_1;
      slice2other_winner_1_1_choice_5 := slice2other_winner_1_1_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_1_1_choice_4;
      slice2other_winner_1_1_choice_6 := slice2other_winner_1_1_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_1_1_choice_5;
      slice2other_winner_2_0_choice := 0 when slice2other_cost_2_1 >= slice2window_sum_2_0 else slice2other_winner_2_1;
      slice2other_winner_2_0_choice_2 := slice2other_winner_2_0_choice when slice0winner2_tag_valid else
        slice2other_winner_2_0;
      slice2other_winner_2_0_choice_3 := 0 when slice0winner2_tag_valid else slice2other_winner_2_0;
      slice2other_winner_2_0_choice_4 := slice2other_winner_2_1 when slice0winner2_tag_valid else
        slice2other_winner_2_0;
      slice2other_winner_2_0_choice_5 := slice2other_winner_2_0_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_2_0_choice_4;
      slice2other_winner_2_0_choice_6 := slice2other_winner_2_0_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_2_0_choice_5;
      slice2other_winner_2_1_choice := 1 when slice2other_cost_2_1_is_not_less else slice1other_winner_out_2;
      slice2other_winner_2_1_choice_2 := slice2other_winner_2_1_choice when slice0winner2_tag_valid else
        slice2other_winner_2_1;
      slice2other_winner_2_1_choice_3 := 1 when slice0winner2_tag_valid else slice2other_winner_2_1;
      slice2other_winner_2_1_choice_4 := slice1other_winner_out_2 when slice0winner2_tag_valid else
        slice2other_winner_2_1;
      slice2other_winner_2_1_choice_5 := slice2other_winner_2_1_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_2_1_choice_4;
      slice2other_winner_2_1_choice_6 := slice2other_winner_2_1_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_2_1_choice_5;
      slice2other_winner_3_0_choice := 0 when slice2other_cost_3_1 >= slice2window_sum_3_0 else slice2other_winner_3_1;
      slice2other_winner_3_0_choice_2 := slice2other_winner_3_0_choice when slice0winner2_tag_valid else
        slice2other_winner_3_0;
      slice2other_winner_3_0_choice_3 := 0 when slice0winner2_tag_valid else slice2other_winner_3_0;
      slice2other_winner_3_0_choice_4 := slice2other_winner_3_1 when slice0winner2_tag_valid else
        slice2other_winner_3_0;
      slice2other_winner_3_0_choice_5 := slice2other_winner_3_0_choice_3 when slice0winner2_tag_output_column else
        slice2other_winner_3_0_choice_4;
      slice2other_winner_3_0_choice_6 := slice2other_winner_3_0_choice_2 when slice2other_cost_0_1_all_2 else
        slice2other_winner_3_0_choice_5;
      slice2other_cost_0_1 <= slice2other_cost_0_1_choice_3 when slice2other_cost_0_1_all else
        slice2other_cost_0_1_choice_5;
      slice2other_cost_1_1 <= slice2other_cost_1_1_choice_3 when slice2other_cost_0_1_all else
        slice2other_cost_1_1_choice_5;
      slice2other_cost_2_1 <= slice2other_cost_2_1_choice_3 when slice2other_cost_0_1_all else
        slice2other_cost_2_1_choice_5;
      slice2other_cost_3_1 <= slice2other_cost_3_1_choice when slice2other_cost_0_1_all else
        slice2other_cost_3_1_choice_4;
      slice2other_winner_0_0 <= slice2other_winner_0_0_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_0_0_choice_6;
      slice2other_winner_0_1 <= slice2other_winner_0_1_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_0_1_choice_6;
      slice2other_winner_1_0 <= slice2other_winner_1_0_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_1_0_choice_6;
      slice2other_winner_1_1 <= slice2other_winner_1_1_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_1_1_choice_6;
      slice2other_winner_2_0 <= slice2other_winner_2_0_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_2_0_choice_6;
      slice2other_winner_2_1 <= slice2other_winner_2_1_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_2_1_choice_6;
      slice2other_winner_3_0 <= slice2other_winner_3_0_choice_2 when slice2other_cost_0_1_all else
        slice2other_winner_3_0_choice_6;
      slice2other_winner_out_0 <= slice2other_winner_0_0;
      slice2other_winner_out_1 <= slice2other_winner_1_0;
      slice2other_winner_out_2 <= slice2other_winner_2_0;
      slice2other_winner_out_3 <= slice2other_winner_3_0;
      slice2other_winner_3_1_choice := 1 when slice0winner2_tag_output_column else slice1other_winner_out_3;
      slice2other_winner_3_1_choice_2 := 1 when slice2other_cost_0_1_all_2 else slice2other_winner_3_1_choice;
      if slice0winner2_tag_valid then
        slice2other_winner_3_1 <= slice1other_winner_out_3 when slice2other_cost_0_1_all else
          slice2other_winner_3_1_choice_2;
      end if;
      -- slice2winner1
      slice2winner1_cost_0_0_is_less := slice2window_sum_0_1 < slice2window_sum_0_0;
      slice2winner1_cost_1_0_is_less := slice2window_sum_1_1 < slice2window_sum_1_0;
      slice2winner1_cost_2_0_is_less := slice2window_sum_2_1 < slice2window_sum_2_0;
      slice2winner1_cost_3_0_is_less := slice2window_sum_3_1 < slice2window_sum_3_0;
      slice2winner1_cost_0_0 <= slice2window_sum_0_1 when slice2winner1_cost_0_0_is_less else slice2window_sum_0_0;
      slice2winner1_cost_1_0 <= slice2window_sum_1_1 when slice2winner1_cost_1_0_is_less else slice2window_sum_1_0;
      slice2winner1_cost_2_0 <= slice2window_sum_2_1 when slice2winner1_cost_2_0_is_less else slice2window_sum_2_0;
      slice2winner1_cost_3_0 <= slice2window_sum_3_1 when slice2winner1_cost_3_0_is_less else slice2window_sum_3_0;
      slice2winner1_index_0_0 <= slice2winner1_cost_0_0_is_less;
      slice2winner1_index_1_0 <= slice2winner1_cost_1_0_is_less;
      slice2winner1_index_2_0 <= slice2winner1_cost_2_0_is_less;
      slice2winner1_index_3_0 <= slice2winner1_cost_3_0_is_less;
      slice2winner1_below_0_0 <= slice2window_sum_0_0 when slice2winner1_cost_0_0_is_less else 0;
      slice2winner1_below_1_0 <= slice2window_sum_1_0 when slice2winner1_cost_1_0_is_less else 0;
      slice2winner1_below_2_0 <= slice2window_sum_2_0 when slice2winner1_cost_2_0_is_less else 0;
      slice2winner1_below_3_0 <= slice2window_sum_3_0 when slice2winner1_cost_3_0_is_less else 0;
      slice2winner1_above_0_0 <= 0 when slice2winner1_cost_0_0_is_less else slice2window_sum_0_1;
      slice2winner1_above_1_0 <= 0 when slice2winner1_cost_1_0_is_less else slice2window_sum_1_1;
      slice2winner1_above_2_0 <= 0 when slice2winner1_cost_2_0_is_less else slice2window_sum_2_1;
      slice2winner1_above_3_0 <= 0 when slice2winner1_cost_3_0_is_less else slice2window_sum_3_1;
      slice2winner1_first_0_0 <= slice2window_sum_0_0;
      slice2winner1_first_1_0 <= slice2window_sum_1_0;
      slice2winner1_first_2_0 <= slice2window_sum_2_0;
      slice2winner1_first_3_0 <= slice2window_sum_3_0;
      slice2winner1_last_0_0 <= slice2window_sum_0_1;
      slice2winner1_last_1_0 <= slice2window_sum_1_1;
      slice2winner1_last_2_0 <= slice2window_sum_2_1;
      slice2winner1_last_3_0 <= slice2window_sum_3_1;
      -- slice2winner2
      slice2winner2_cost_0_0 <= slice2winner1_cost_0_0;
      slice2winner2_cost_1_0 <= slice2winner1_cost_1_0;
      slice2winner2_cost_2_0 <= slice2winner1_cost_2_0;
      slice2winner2_cost_3_0 <= slice2winner1_cost_3_0;
      slice2winner2_index_0_0 <= slice2winner1_index_0_0;
      slice2winner2_index_1_0 <= slice2winner1_index_1_0;
      slice2winner2_index_2_0 <= slice2winner1_index_2_0;
      slice2winner2_index_3_0 <= slice2winner1_index_3_0;
      slice2winner2_below_0_0 <= slice2winner1_below_0_0;
      slice2winner2_below_1_0 <= slice2winner1_below_1_0;
      slice2winner2_below_2_0 <= slice2winner1_below_2_0;
      slice2winner2_below_3_0 <= slice2winner1_below_3_0;
      slice2winner2_above_0_0 <= slice2winner1_above_0_0;
      slice2winner2_above_1_0 <= slice2winner1_above_1_0;
      slice2winner2_above_2_0 <= slice2winner1_above_2_0;
      slice2winner2_above_3_0 <= slice2winner1_above_3_0;
      slice2winner2_first_0_0 <= slice2winner1_first_0_0;
      slice2winner2_first_1_0 <= slice2winner1_first_1_0;
      slice2winner2_first_2_0 <= slice2winner1_first_2_0;
      slice2winner2_first_3_0 <= slice2winner1_first_3_0;
      slice2winner2_last_0_0 <= slice2winner1_last_0_0;
      slice2winner2_last_1_0 <= slice2winner1_last_1_0;
      slice2winner2_last_2_0 <= slice2winner1_last_2_0;
      slice2winner2_last_3_0 <= slice2winner1_last_3_0;
      slice2winner2_second_0_0 <= slice0winner1_second_0_0;
      -- slice2best
      slice2best_cost_0_0_is_less := slice1best_cost_0_0 < slice2winner2_cost_0_0;
      slice2best_cost_1_0_is_less := slice1best_cost_1_0 < slice2winner2_cost_1_0;
      slice2best_cost_2_0_is_less := slice1best_cost_2_0 < slice2winner2_cost_2_0;
      slice2best_cost_3_0_is_less := slice1best_cost_3_0 < slice2winner2_cost_3_0;
      slice2best_below_0_0_is_equal := slice1best_index_0_0 = 2;
      slice2best_below_0_0_choice := slice2winner2_last_0_0 when slice2best_below_0_0_is_equal else
        slice1best_below_0_0;
      slice2best_below_1_0_is_equal := slice1best_index_1_0 = 2;
      slice2best_below_1_0_choice := slice2winner2_last_1_0 when slice2best_below_1_0_is_equal else
        slice1best_below_1_0;
      slice2best_below_2_0_is_equal := slice1best_index_2_0 = 2;
      slice2best_below_2_0_choice := slice2winner2_last_2_0 when slice2best_below_2_0_is_equal else
        slice1best_below_2_0;
      slice2best_below_3_0_is_equal := slice1best_index_3_0 = 2;
      slice2best_below_3_0_choice := slice2winner2_last_3_0 when slice2best_below_3_0_is_equal else
        slice1best_below_3_0;
      slice2best_above_0_0_choice := slice1best_first_0_0 when slice2winner2_index_0_0 else slice2winner2_above_0_0;
      slice2best_above_1_0_choice := slice1best_first_1_0 when slice2winner2_index_1_0 else slice2winner2_above_1_0;
      slice2best_above_2_0_choice := slice1best_first_2_0 when slice2winner2_index_2_0 else slice2winner2_above_2_0;
      slice2best_above_3_0_choice := slice1best_first_3_0 when slice2winner2_index_3_0 else slice2winner2_above_3_0;
      slice2best_second_0_0_choice := slice2winner2_first_0_0 when slice2best_below_0_0_is_equal else
        slice2winner2_cost_0_0;
      slice2best_second_0_0_choice_2 := slice2best_second_0_0_choice when slice2best_second_0_0_choice <
        slice1best_second_0_0 else slice1best_second_0_0;
      slice2best_second_0_0_choice_3 := slice1best_but_first_0_0 when slice2winner2_index_0_0 else slice1best_cost_0_0;
      slice2best_second_0_0_choice_4 := slice2best_second_0_0_choice_3 when slice2best_second_0_0_choice_3 <
        slice2winner2_second_0_0 else slice2winner2_second_0_0;
      slice2best_second_1_0_choice := slice2winner2_first_1_0 when slice2best_below_1_0_is_equal else
        slice2winner2_cost_1_0;
      slice2best_second_1_0_choice_2 := slice2best_second_1_0_choice when slice2best_second_1_0_choice <
        slice1best_second_1_0 else slice1best_second_1_0;
      slice2best_second_1_0_choice_3 := slice1best_but_first_1_0 when slice2winner2_index_1_0 else slice1best_cost_1_0;
      slice2best_second_1_0_choice_4 := slice2best_second_1_0_choice_3 when slice2best_second_1_0_choice_3 <
        slice2winner2_second_0_0 else slice2winner2_second_0_0;
      slice2best_second_2_0_choice := slice2winner2_first_2_0 when slice2best_below_2_0_is_equal else
        slice2winner2_cost_2_0;
      slice2best_second_2_0_choice_2 := slice2best_second_2_0_choice when slice2best_second_2_0_choice <
        slice1best_second_2_0 else slice1best_second_2_0;
      slice2best_second_2_0_choice_3 := slice1best_but_first_2_0 when slice2winner2_index_2_0 else slice1best_cost_2_0;
      slice2best_second_2_0_choice_4 := slice2best_second_2_0_choice_3 when slice2best_second_2_0_choice_3 <
        slice2winner2_second_0_0 else slice2winner2_second_0_0;
      slice2best_second_3_0_choice := slice2winner2_first_3_0 when slice2best_below_3_0_is_equal else
        slice2winner2_cost_3_0;
      slice2best_second_3_0_choice_2 := slice2best_second_3_0_choice when slice2best_second_3_0_choice <
        slice1best_second_3_0 else slice1best_second_3_0;
      slice2best_second_3_0_choice_3 := slice1best_but_first_3_0 when slice2winner2_index_3_0 else slice1best_cost_3_0;
      slice2best_second_3_0_choice_4 := slice2best_second_3_0_choice_3 when slice2best_second_3_0_choice_3 <
        slice2winner2_second_0_0 else slice2winner2_second_0_0;
      slice2best_cost_0_0 <= slice1best_cost_0_0 when slice2best_cost_0_0_is_less else slice2winner2_cost_0_0;
      slice2best_cost_1_0 <= slice1best_cost_1_0 when slice2best_cost_1_0_is_less else slice2winner2_cost_1_0;
      slice2best_cost_2_0 <= slice1best_cost_2_0 when slice2best_cost_2_0_is_less else slice2winner2_cost_2_0;
      slice2best_cost_3_0 <= slice1best_cost_3_0 when slice2best_cost_3_0_is_less else slice2winner2_cost_3_0;
      slice2best_index_0_0 <= slice1best_index_0_0 when slice2best_cost_0_0_is_less else
        as_number(slice2winner2_index_0_0);
      slice2best_index_1_0 <= slice1best_index_1_0 when slice2best_cost_1_0_is_less else
        as_number(slice2winner2_index_1_0);
      slice2best_index_2_0 <= slice1best_index_2_0 when slice2best_cost_2_0_is_less else
        as_number(slice2winner2_index_2_0);
      slice2best_index_3_0 <= slice1best_index_3_0 when slice2best_cost_3_0_is_less else
        as_number(slice2winner2_index_3_0);
      slice2best_below_0_0 <= slice2best_below_0_0_choice when slice2best_cost_0_0_is_less else slice2winner2_below_0_0;
      slice2best_below_1_0 <= slice2best_below_1_0_choice when slice2best_cost_1_0_is_less else slice2winner2_below_1_0;
      slice2best_below_2_0 <= slice2best_below_2_0_choice when slice2best_cost_2_0_is_less else slice2winner2_below_2_0;
      slice2best_below_3_0 <= slice2best_below_3_0_choice when slice2best_cost_3_0_is_less else slice2winner2_below_3_0;
      slice2best_above_0_0 <= slice1best_above_0_0 when slice2best_cost_0_0_is_less else slice2best_above_0_0_choice;
      slice2best_above_1_0 <= slice1best_above_1_0 when slice2best_cost_1_0_is_less else slice2best_above_1_0_choice;
      slice2best_above_2_0 <= slice1best_above_2_0 when slice2best_cost_2_0_is_less else slice2best_above_2_0_choice;
      slice2best_above_3_0 <= slice1best_above_3_0 when slice2best_cost_3_0_is_less else slice2best_above_3_0_choice;
      slice2best_second_0_0 <= slice2best_second_0_0_choice_2 when slice2best_cost_0_0_is_less else
        slice2best_second_0_0_choice_4;
      slice2best_second_1_0 <= slice2best_second_1_0_choice_2 when slice2best_cost_1_0_is_less else
        slice2best_second_1_0_choice_4;
      slice2best_second_2_0 <= slice2best_second_2_0_choice_2 when slice2best_cost_2_0_is_less else
        slice2best_second_2_0_choice_4;
      slice2best_second_3_0 <= slice2best_second_3_0_choice_2 when slice2best_cost_3_0_is_less else
        slice2best_second_3_0_choice_4;
      slice2best_tag_valid <= slice1best_tag_valid;
      slice2best_tag_map_column <= slice1best_tag_map_column;
      slice2best_tag_output_column <= slice1best_tag_output_column;
      slice2best_tag_start_of_frame <= slice1best_tag_start_of_frame;
      slice2best_tag_end_of_line <= slice1best_tag_end_of_line;
      -- texture
      texture_taps_search_0_0 <= 31 when rows_inside_0 else 0;
      texture_taps_search_1_0 <= 31 when rows_inside_1 else 0;
      texture_taps_search_5_0 <= 31 when rows_inside_5 else 0;
      texture_passes_0_0 <= 29 < texturewindow_sum_0_0;
      texture_passes_0_1 <= 29 < texturewindow_sum_2_0;
      texture_passes_0_2 <= 29 < texturewindow_sum_1_0;
      texture_passes_0_3 <= 29 < texturewindow_sum_3_0;
      texture_passes_1_0 <= texture_passes_0_0;
      texture_passes_1_1 <= texture_passes_0_1;
      texture_passes_1_2 <= texture_passes_0_2;
      texture_passes_1_3 <= texture_passes_0_3;
      texture_passes_2_0 <= texture_passes_1_0;
      texture_passes_2_1 <= texture_passes_1_1;
      texture_passes_2_2 <= texture_passes_1_2;
      texture_passes_2_3 <= texture_passes_1_3;
      texture_passes_3_0 <= texture_passes_2_0;
      texture_passes_3_1 <= texture_passes_2_1;
      texture_passes_3_2 <= texture_passes_2_2;
      texture_passes_3_3 <= texture_passes_2_3;
      texture_passes_4_0 <= texture_passes_3_0;
      texture_passes_4_1 <= texture_passes_3_1;
      texture_passes_4_2 <= texture_passes_3_2;
      texture_passes_4_3 <= texture_passes_3_3;
      -- texturecost
      texturecost_pair_0_0_is_less := texturecost_difference_2_0 < 0;
      texturecost_pair_0_0_choice := texturecost_reverse_0_0 when texturecost_pair_0_0_is_less else
        positive_part(texturecost_difference_2_0);
      texturecost_pair_1_0_choice := texturecost_reverse_1_0 when texturecost_difference_4_0 < 0 else
        positive_part(texturecost_difference_4_0);
      texturecost_pair_1_0_folded_value := folded(texturecost_difference_3_0);
      texturecost_pair_1_0_is_less := texturecost_difference_3_0 < 0;
      texturecost_difference_0_0 <= texture_taps_search_0_0 - slice0shift_reference_0;
      texturecost_difference_1_0 <= texture_taps_search_1_0 - slice0shift_reference_1;
      texturecost_difference_2_0 <= texture_taps_search_1_0 - slice0shift_reference_2;
      texturecost_difference_3_0 <= texture_taps_search_1_0 - slice0shift_reference_3;
      texturecost_difference_4_0 <= texture_taps_search_1_0 - slice0shift_reference_4;
      texturecost_difference_5_0 <= texture_taps_search_5_0 - slice0shift_reference_5;
      texturecost_reverse_0_0 <= (slice0shift_reference_2 - texture_taps_search_1_0) mod 256;
      texturecost_reverse_1_0 <= (slice0shift_reference_4 - texture_taps_search_1_0) mod 256;
      texturecost_pair_0_0 <= (texturecost_pair_0_0_choice + folded(texturecost_difference_1_0) +
        as_number((texturecost_difference_1_0 < 0))) mod 256;
      texturecost_pair_1_0 <= (texturecost_pair_1_0_choice + texturecost_pair_1_0_folded_value +
        as_number(texturecost_pair_1_0_is_less)) mod 256;
      texturecost_single_0_0 <= folded(texturecost_difference_0_0);
      texturecost_single_2_0 <= folded(texturecost_difference_2_0);
      texturecost_single_3_0 <= texturecost_pair_1_0_folded_value;
      texturecost_single_5_0 <= folded(texturecost_difference_5_0);
      texturecost_negative_0_0 <= texturecost_difference_0_0 < 0;
      texturecost_negative_2_0 <= texturecost_pair_0_0_is_less;
      texturecost_negative_3_0 <= texturecost_pair_1_0_is_less;
      texturecost_negative_5_0 <= texturecost_difference_5_0 < 0;
      texturecost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(texturecost_negative_0_0) +
        texturecost_pair_0_0 + texturecost_single_0_0) mod 256;
      texturecost_column_1_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(texturecost_negative_3_0) +
        texturecost_pair_0_0 + texturecost_single_3_0) mod 256;
      texturecost_column_2_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(texturecost_negative_2_0) +
        texturecost_pair_1_0 + texturecost_single_2_0) mod 256;
      texturecost_column_3_0 <= 0 when slice0cost_pair_tag_border_column else (as_number(texturecost_negative_5_0) +
        texturecost_pair_1_0 + texturecost_single_5_0) mod 256;
      -- texturewindow
      if slice0cost_tag_valid then
        texturewindow_partial_0_0_0 <= texturecost_column_0_0;
        texturewindow_partial_0_1_0 <= texturecost_column_0_0 + texturewindow_partial_0_0_0;
        texturewindow_partial_1_0_0 <= texturecost_column_1_0;
        texturewindow_partial_1_1_0 <= texturecost_column_1_0 + texturewindow_partial_1_0_0;
        texturewindow_partial_2_0_0 <= texturecost_column_2_0;
        texturewindow_partial_2_1_0 <= texturecost_column_2_0 + texturewindow_partial_2_0_0;
        texturewindow_partial_3_0_0 <= texturecost_column_3_0;
        texturewindow_partial_3_1_0 <= texturecost_column_3_0 + texturewindow_partial_3_0_0;
      end if;
      texturewindow_sum_0_0 <= texturecost_column_0_0 + texturewindow_partial_0_1_0;
      texturewindow_sum_1_0 <= texturecost_column_1_0 + texturewindow_partial_1_1_0;
      texturewindow_sum_2_0 <= texturecost_column_2_0 + texturewindow_partial_2_1_0;
      texturewindow_sum_3_0 <= texturecost_column_3_0 + texturewindow_partial_3_1_0;
      -- refinement
      refinement_remainder_0_0_choice := slice2best_above_0_0 when slice2best_index_0_0 = 0 else slice2best_below_0_0;
      refinement_remainder_0_0_value := (refinement_remainder_0_0_choice - slice2best_cost_0_0) mod 1024;
      refinement_remainder_0_0_choice_2 := slice2best_below_0_0 when slice2best_index_0_0 = 7 else slice2best_above_0_0;
      refinement_remainder_0_0_value_2 := (refinement_remainder_0_0_choice_2 - slice2best_cost_0_0) mod 1024;
      refinement_remainder_0_0_is_less := refinement_remainder_0_0_value < refinement_remainder_0_0_value_2;
      refinement_remainder_0_0_choice_3 := refinement_remainder_0_0_value_2 when refinement_remainder_0_0_is_less else
        refinement_remainder_0_0_value;
      refinement_remainder_0_0_choice_4 := refinement_remainder_0_0_value when refinement_remainder_0_0_is_less else
        refinement_remainder_0_0_value_2;
      refinement_remainder_0_1_choice := slice2best_above_1_0 when slice2best_index_1_0 = 0 else slice2best_below_1_0;
      refinement_remainder_0_1_value := (refinement_remainder_0_1_choice - slice2best_cost_1_0) mod 1024;
      refinement_remainder_0_1_choice_2 := slice2best_below_1_0 when slice2best_index_1_0 = 7 else slice2best_above_1_0;
      refinement_remainder_0_1_value_2 := (refinement_remainder_0_1_choice_2 - slice2best_cost_1_0) mod 1024;
      refinement_remainder_0_1_is_less := refinement_remainder_0_1_value < refinement_remainder_0_1_value_2;
      refinement_remainder_0_1_choice_3 := refinement_remainder_0_1_value_2 when refinement_remainder_0_1_is_less else
        refinement_remainder_0_1_value;
      refinement_remainder_0_1_choice_4 := refinement_remainder_0_1_value when refinement_remainder_0_1_is_less else
        refinement_remainder_0_1_value_2;
      refinement_remainder_0_2_choice := slice2best_above_2_0 when slice2best_index_2_0 = 0 else slice2best_below_2_0;
      refinement_remainder_0_2_value := (refinement_remainder_0_2_choice - slice2best_cost_2_0) mod 1024;
      refinement_remainder_0_2_choice_2 := slice2best_below_2_0 when slice2best_index_2_0 = 7 else slice2best_above_2_0;
      refinement_remainder_0_2_value_2 := (refinement_remainder_0_2_choice_2 - slice2best_cost_2_0) mod 1024;
      refinement_remainder_0_2_is_less := refinement_remainder_0_2_value < refinement_remainder_0_2_value_2;
      refinement_remainder_0_2_choice_3 := refinement_remainder_0_2_value_2 when refinement_remainder_0_2_is_less else
        refinement_remainder_0_2_value;
      refinement_remainder_0_2_choice_4 := refinement_remainder_0_2_value when refinement_remainder_0_2_is_less else
        refinement_remainder_0_2_value_2;
      refinement_remainder_0_3_choice := slice2best_above_3_0 when slice2best_index_3_0 = 0 else slice2best_below_3_0;
      refinement_remainder_0_3_value := (refinement_remainder_0_3_choice - slice2best_cost_3_0) mod 1024;
      refinement_remainder_0_3_choice_2 := slice2best_below_3_0 when slice2best_index_3_0 = 7 else slice2best_above_3_0;
      refinement_remainder_0_3_value_2 := (refinement_remainder_0_3_choice_2 - slice2best_cost_3_0) mod 1024;
      refinement_remainder_0_3_is_less := refinement_remainder_0_3_value < refinement_remainder_0_3_value_2;
      refinement_remainder_0_3_choice_3 := refinement_remainder_0_3_value_2 when refinement_remainder_0_3_is_less else
        refinement_remainder_0_3_value;
      refinement_remainder_0_3_choice_4 := refinement_remainder_0_3_value when refinement_remainder_0_3_is_less else
        refinement_remainder_0_3_value_2;
      refinement_remainder_1_0_is_not_less := refinement_remainder_0_0 >= refinement_divisor_0_0;
      refinement_remainder_1_0_choice := refinement_divisor_0_0 when refinement_remainder_1_0_is_not_less else 0;
      refinement_remainder_1_1_is_not_less := refinement_remainder_0_1 >= refinement_divisor_0_1;
      refinement_remainder_1_1_choice := refinement_divisor_0_1 when refinement_remainder_1_1_is_not_less else 0;
      refinement_remainder_1_2_is_not_less := refinement_remainder_0_2 >= refinement_divisor_0_2;
      refinement_remainder_1_2_choice := refinement_divisor_0_2 when refinement_remainder_1_2_is_not_less else 0;
      refinement_remainder_1_3_is_not_less := refinement_remainder_0_3 >= refinement_divisor_0_3;
      refinement_remainder_1_3_choice := refinement_divisor_0_3 when refinement_remainder_1_3_is_not_less else 0;
      refinement_remainder_2_0_is_not_less := (refinement_remainder_1_0 * 2) >= refinement_divisor_1_0;
      refinement_remainder_2_0_choice := refinement_divisor_1_0 when refinement_remainder_2_0_is_not_less else 0;
      refinement_remainder_2_1_is_not_less := (refinement_remainder_1_1 * 2) >= refinement_divisor_1_1;
      refinement_remainder_2_1_choice := refinement_divisor_1_1 when refinement_remainder_2_1_is_not_less else 0;
      refinement_remainder_2_2_is_not_less := (refinement_remainder_1_2 * 2) >= refinement_divisor_1_2;
      refinement_remainder_2_2_choice := refinement_divisor_1_2 when refinement_remainder_2_2_is_not_less else 0;
      refinement_remainder_2_3_is_not_less := (refinement_remainder_1_3 * 2) >= refinement_divisor_1_3;
      refinement_remainder_2_3_choice := refinement_divisor_1_3 when refinement_remainder_2_3_is_not_less else 0;
      refinement_remainder_3_0_is_not_less := (refinement_remainder_2_0 * 2) >= refinement_divisor_2_0;
      refinement_remainder_3_0_choice := refinement_divisor_2_0 when refinement_remainder_3_0_is_not_less else 0;
      refinement_remainder_3_1_is_not_less := (refinement_remainder_2_1 * 2) >= refinement_divisor_2_1;
      refinement_remainder_3_1_choice := refinement_divisor_2_1 when refinement_remainder_3_1_is_not_less else 0;
      refinement_remainder_3_2_is_not_less := (refinement_remainder_2_2 * 2) >= refinement_divisor_2_2;
      refinement_remainder_3_2_choice := refinement_divisor_2_2 when refinement_remainder_3_2_is_not_less else 0;
      refinement_remainder_3_3_is_not_less := (refinement_remainder_2_3 * 2) >= refinement_divisor_2_3;
      refinement_remainder_3_3_choice := refinement_divisor_2_3 when refinement_remainder_3_3_is_not_less else 0;
      refinement_remainder_4_0_is_not_less := (refinement_remainder_3_0 * 2) >= refinement_divisor_3_0;
      refinement_remainder_4_0_choice := refinement_divisor_3_0 when refinement_remainder_4_0_is_not_less else 0;
      refinement_remainder_4_1_is_not_less := (refinement_remainder_3_1 * 2) >= refinement_divisor_3_1;
      refinement_remainder_4_1_choice := refinement_divisor_3_1 when refinement_remainder_4_1_is_not_less else 0;
      refinement_remainder_4_2_is_not_less := (refinement_remainder_3_2 * 2) >= refinement_divisor_3_2;
      refinement_remainder_4_2_choice := refinement_divisor_3_2 when refinement_remainder_4_2_is_not_less else 0;
      refinement_remainder_4_3_is_not_less := (refinement_remainder_3_3 * 2) >= refinement_divisor_3_3;
      refinement_remainder_4_3_choice := refinement_divisor_3_3 when refinement_remainder_4_3_is_not_less else 0;
      refinement_remainder_5_0_is_not_less := (refinement_remainder_4_0 * 2) >= refinement_divisor_4_0;
      refinement_remainder_5_0_choice := refinement_divisor_4_0 when refinement_remainder_5_0_is_not_less else 0;
      refinement_remainder_5_1_is_not_less := (refinement_remainder_4_1 * 2) >= refinement_divisor_4_1;
      refinement_remainder_5_1_choice := refinement_divisor_4_1 when refinement_remainder_5_1_is_not_less else 0;
      refinement_remainder_5_2_is_not_less := (refinement_remainder_4_2 * 2) >= refinement_divisor_4_2;
      refinement_remainder_5_2_choice := refinement_divisor_4_2 when refinement_remainder_5_2_is_not_less else 0;
      refinement_remainder_5_3_is_not_less := (refinement_remainder_4_3 * 2) >= refinement_divisor_4_3;
      refinement_remainder_5_3_choice := refinement_divisor_4_3 when refinement_remainder_5_3_is_not_less else 0;
      refinement_remainder_6_0_is_not_less := (refinement_remainder_5_0 * 2) >= refinement_divisor_5_0;
      refinement_remainder_6_0_choice := refinement_divisor_5_0 when refinement_remainder_6_0_is_not_less else 0;
      refinement_remainder_6_1_is_not_less := (refinement_remainder_5_1 * 2) >= refinement_divisor_5_1;
      refinement_remainder_6_1_choice := refinement_divisor_5_1 when refinement_remainder_6_1_is_not_less else 0;
      refinement_remainder_6_2_is_not_less := (refinement_remainder_5_2 * 2) >= refinement_divisor_5_2;
      refinement_remainder_6_2_choice := refinement_divisor_5_2 when refinement_remainder_6_2_is_not_less else 0;
      refinement_remainder_6_3_is_not_less := (refinement_remainder_5_3 * 2) >= refinement_divisor_5_3;
      refinement_remainder_6_3_choice := refinement_divisor_5_3 when refinement_remainder_6_3_is_not_less else 0;
      refinement_remainder_7_0_is_not_less := (refinement_remainder_6_0 * 2) >= refinement_divisor_6_0;
      refinement_remainder_7_0_choice := refinement_divisor_6_0 when refinement_remainder_7_0_is_not_less else 0;
      refinement_remainder_7_1_is_not_less := (refinement_remainder_6_1 * 2) >= refinement_divisor_6_1;
      refinement_remainder_7_1_choice := refinement_divisor_6_1 when refinement_remainder_7_1_is_not_less else 0;
      refinement_remainder_7_2_is_not_less := (refinement_remainder_6_2 * 2) >= refinement_divisor_6_2;
      refinement_remainder_7_2_choice := refinement_divisor_6_2 when refinement_remainder_7_2_is_not_less else 0;
      refinement_remainder_7_3_is_not_less := (refinement_remainder_6_3 * 2) >= refinement_divisor_6_3;
      refinement_remainder_7_3_choice := refinement_divisor_6_3 when refinement_remainder_7_3_is_not_less else 0;
      refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
      refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_8_0 then
        refinement_fraction_0_choice := refinement_fraction_0_difference mod 256;
      else
        refinement_fraction_0_choice := refinement_fraction_0_value;
      end if;
      if refinement_negative_8_0 then
        refinement_fraction_0_choice_2 := refinement_fraction_0_difference mod 8;
      else
        refinement_fraction_0_choice_2 := refinement_fraction_0_value mod 8;
      end if;
      refinement_fraction_1_difference := 0 - (refinement_quotient_8_1 / 16);
      refinement_fraction_1_value := (refinement_quotient_8_1 + 15) / 16;
      if refinement_negative_8_1 then
        refinement_fraction_1_choice := refinement_fraction_1_difference mod 256;
      else
        refinement_fraction_1_choice := refinement_fraction_1_value;
      end if;
      if refinement_negative_8_1 then
        refinement_fraction_1_choice_2 := refinement_fraction_1_difference mod 8;
      else
        refinement_fraction_1_choice_2 := refinement_fraction_1_value mod 8;
      end if;
      refinement_fraction_2_difference := 0 - (refinement_quotient_8_2 / 16);
      refinement_fraction_2_value := (refinement_quotient_8_2 + 15) / 16;
      if refinement_negative_8_2 then
        refinement_fraction_2_choice := refinement_fraction_2_difference mod 256;
      else
        refinement_fraction_2_choice := refinement_fraction_2_value;
      end if;
      if refinement_negative_8_2 then
        refinement_fraction_2_choice_2 := refinement_fraction_2_difference mod 8;
      else
        refinement_fraction_2_choice_2 := refinement_fraction_2_value mod 8;
      end if;
      refinement_fraction_3_difference := 0 - (refinement_quotient_8_3 / 16);
      refinement_fraction_3_value := (refinement_quotient_8_3 + 15) / 16;
      if refinement_negative_8_3 then
        refinement_fraction_3_choice := refinement_fraction_3_difference mod 256;
      else
        refinement_fraction_3_choice := refinement_fraction_3_value;
      end if;
      if refinement_negative_8_3 then
        refinement_fraction_3_choice_2 := refinement_fraction_3_difference mod 8;
      else
        refinement_fraction_3_choice_2 := refinement_fraction_3_value mod 8;
      end if;
      refinement_disparity_0_0 <= slice2best_index_0_0;
      refinement_disparity_0_1 <= slice2best_index_1_0;
      refinement_disparity_0_2 <= slice2best_index_2_0;
      refinement_disparity_0_3 <= slice2best_index_3_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_1_1 <= refinement_disparity_0_1;
      refinement_disparity_1_2 <= refinement_disparity_0_2;
      refinement_disparity_1_3 <= refinement_disparity_0_3;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_2_1 <= refinement_disparity_1_1;
      refinement_disparity_2_2 <= refinement_disparity_1_2;
      refinement_disparity_2_3 <= refinement_disparity_1_3;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_disparity_3_1 <= refinement_disparity_2_1;
      refinement_disparity_3_2 <= refinement_disparity_2_2;
      refinement_disparity_3_3 <= refinement_disparity_2_3;
      refinement_disparity_4_0 <= refinement_disparity_3_0;
      refinement_disparity_4_1 <= refinement_disparity_3_1;
      refinement_disparity_4_2 <= refinement_disparity_3_2;
      refinement_disparity_4_3 <= refinement_disparity_3_3;
      refinement_disparity_5_0 <= refinement_disparity_4_0;
      refinement_disparity_5_1 <= refinement_disparity_4_1;
      refinement_disparity_5_2 <= refinement_disparity_4_2;
      refinement_disparity_5_3 <= refinement_disparity_4_3;
      refinement_disparity_6_0 <= refinement_disparity_5_0;
      refinement_disparity_6_1 <= refinement_disparity_5_1;
      refinement_disparity_6_2 <= refinement_disparity_5_2;
      refinement_disparity_6_3 <= refinement_disparity_5_3;
      refinement_disparity_7_0 <= refinement_disparity_6_0;
      refinement_disparity_7_1 <= refinement_disparity_6_1;
      refinement_disparity_7_2 <= refinement_disparity_6_2;
      refinement_disparity_7_3 <= refinement_disparity_6_3;
      refinement_disparity_8_0 <= refinement_disparity_7_0;
      refinement_disparity_8_1 <= refinement_disparity_7_1;
      refinement_disparity_8_2 <= refinement_disparity_7_2;
      refinement_disparity_8_3 <= refinement_disparity_7_3;
      refinement_disparity_9_0 <= refinement_disparity_8_0;
      refinement_disparity_9_1 <= refinement_disparity_8_1;
      refinement_disparity_9_2 <= refinement_disparity_8_2;
      refinement_disparity_9_3 <= refinement_disparity_8_3;
      refinement_passed_0_0 <= texture_passes_4_0;
      refinement_passed_0_1 <= texture_passes_4_1;
      refinement_passed_0_2 <= texture_passes_4_2;
      refinement_passed_0_3 <= texture_passes_4_3;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_1_1 <= refinement_passed_0_1;
      refinement_passed_1_2 <= refinement_passed_0_2;
      refinement_passed_1_3 <= refinement_passed_0_3;
      refinement_passed_2_0 <= refinement_passed_1_0 when slice0window_tag_border_column else refinement_passed_1_0 and
        ((refinement_scaled_cost_0 / 2) < (refinement_scaled_gap_0 / 2));
      refinement_passed_2_1 <= refinement_passed_1_2 when slice0window_tag_row_start else refinement_passed_1_2 and
        ((refinement_scaled_cost_1 / 2) < (refinement_scaled_gap_1 / 2));
      refinement_passed_2_2 <= refinement_passed_1_1 when slice0cost_pair_2_1 else refinement_passed_1_1 and
        ((refinement_scaled_cost_2 / 2) < (refinement_scaled_gap_2 / 2));
      refinement_passed_2_3 <= refinement_passed_1_3 and ((refinement_scaled_cost_3 / 2) < (refinement_scaled_gap_3 /
        2));
      refinement_passed_3_0 <= refinement_passed_2_0;
      refinement_passed_3_1 <= refinement_passed_2_1;
      refinement_passed_3_2 <= refinement_passed_2_2;
      refinement_passed_3_3 <= refinement_passed_2_3;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_4_1 <= refinement_passed_3_1;
      refinement_passed_4_2 <= refinement_passed_3_2;
      refinement_passed_4_3 <= refinement_passed_3_3;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_5_1 <= refinement_passed_4_1;
      refinement_passed_5_2 <= refinement_passed_4_2;
      refinement_passed_5_3 <= refinement_passed_4_3;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_6_1 <= refinement_passed_5_1;
      refinement_passed_6_2 <= refinement_passed_5_2;
      refinement_passed_6_3 <= refinement_passed_5_3;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_7_1 <= refinement_passed_6_1;
      refinement_passed_7_2 <= refinement_passed_6_2;
      refinement_passed_7_3 <= refinement_passed_6_3;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_8_1 <= refinement_passed_7_1;
      refinement_passed_8_2 <= refinement_passed_7_2;
      refinement_passed_8_3 <= refinement_passed_7_3;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_9_1 <= refinement_passed_8_1;
      refinement_passed_9_2 <= refinement_passed_8_2;
      refinement_passed_9_3 <= refinement_passed_8_3;
      refinement_tag_0_valid <= slice2best_tag_valid;
      refinement_tag_0_map_column <= slice2best_tag_map_column;
      refinement_tag_0_output_column <= slice2best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice2best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice2best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_map_column <= refinement_tag_0_map_column;
      refinement_tag_1_output_column <= refinement_tag_0_output_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_map_column <= refinement_tag_1_map_column;
      refinement_tag_2_output_column <= refinement_tag_1_output_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_map_column <= refinement_tag_2_map_column;
      refinement_tag_3_output_column <= refinement_tag_2_output_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_map_column <= refinement_tag_3_map_column;
      refinement_tag_4_output_column <= refinement_tag_3_output_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_map_column <= refinement_tag_4_map_column;
      refinement_tag_5_output_column <= refinement_tag_4_output_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_map_column <= refinement_tag_5_map_column;
      refinement_tag_6_output_column <= refinement_tag_5_output_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_map_column <= refinement_tag_6_map_column;
      refinement_tag_7_output_column <= refinement_tag_6_output_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_map_column <= refinement_tag_7_map_column;
      refinement_tag_8_output_column <= refinement_tag_7_output_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_map_column <= refinement_tag_8_map_column;
      refinement_tag_9_output_column <= refinement_tag_8_output_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_cost_0 <= slice2best_cost_0_0;
      refinement_cost_1 <= slice2best_cost_1_0;
      refinement_cost_2 <= slice2best_cost_2_0;
      refinement_cost_3 <= slice2best_cost_3_0;
      refinement_gap_0 <= (slice2best_second_0_0 - slice2best_cost_0_0) mod 1024;
      refinement_gap_1 <= (slice2best_second_1_0 - slice2best_cost_1_0) mod 1024;
      refinement_gap_2 <= (slice2best_second_2_0 - slice2best_cost_2_0) mod 1024;
      refinement_gap_3 <= (slice2best_second_3_0 - slice2best_cost_3_0) mod 1024;
      refinement_scaled_gap_0 <= (refinement_gap_0 * 25) * 4;
      refinement_scaled_gap_1 <= (refinement_gap_1 * 25) * 4;
      refinement_scaled_gap_2 <= (refinement_gap_2 * 25) * 4;
      refinement_scaled_gap_3 <= (refinement_gap_3 * 25) * 4;
      refinement_scaled_cost_0 <= (((refinement_cost_0 + (refinement_cost_0 / 4)) * 4) + (refinement_cost_0 mod 4)) * 2;
      refinement_scaled_cost_1 <= (((refinement_cost_1 + (refinement_cost_1 / 4)) * 4) + (refinement_cost_1 mod 4)) * 2;
      refinement_scaled_cost_2 <= (((refinement_cost_2 + (refinement_cost_2 / 4)) * 4) + (refinement_cost_2 mod 4)) * 2;
      refinement_scaled_cost_3 <= (((refinement_cost_3 + (refinement_cost_3 / 4)) * 4) + (refinement_cost_3 mod 4)) * 2;
      refinement_remainder_0_0 <= (refinement_remainder_0_0_choice_3 - refinement_remainder_0_0_choice_4) mod 1024;
      refinement_remainder_0_1 <= (refinement_remainder_0_1_choice_3 - refinement_remainder_0_1_choice_4) mod 1024;
      refinement_remainder_0_2 <= (refinement_remainder_0_2_choice_3 - refinement_remainder_0_2_choice_4) mod 1024;
      refinement_remainder_0_3 <= (refinement_remainder_0_3_choice_3 - refinement_remainder_0_3_choice_4) mod 1024;
      refinement_remainder_1_0 <= (refinement_remainder_0_0 - refinement_remainder_1_0_choice) mod 1024;
      refinement_remainder_1_1 <= (refinement_remainder_0_1 - refinement_remainder_1_1_choice) mod 1024;
      refinement_remainder_1_2 <= (refinement_remainder_0_2 - refinement_remainder_1_2_choice) mod 1024;
      refinement_remainder_1_3 <= (refinement_remainder_0_3 - refinement_remainder_1_3_choice) mod 1024;
      refinement_remainder_2_0 <= (((refinement_remainder_1_0 mod 512) * 2) - refinement_remainder_2_0_choice) mod 1024;
      refinement_remainder_2_1 <= (((refinement_remainder_1_1 mod 512) * 2) - refinement_remainder_2_1_choice) mod 1024;
      refinement_remainder_2_2 <= (((refinement_remainder_1_2 mod 512) * 2) - refinement_remainder_2_2_choice) mod 1024;
      refinement_remainder_2_3 <= (((refinement_remainder_1_3 mod 512) * 2) - refinement_remainder_2_3_choice) mod 1024;
      refinement_remainder_3_0 <= ((refinement_remainder_2_0 * 2) - refinement_remainder_3_0_choice) mod 1024;
      refinement_remainder_3_1 <= ((refinement_remainder_2_1 * 2) - refinement_remainder_3_1_choice) mod 1024;
      refinement_remainder_3_2 <= ((refinement_remainder_2_2 * 2) - refinement_remainder_3_2_choice) mod 1024;
      refinement_remainder_3_3 <= ((refinement_remainder_2_3 * 2) - refinement_remainder_3_3_choice) mod 1024;
      refinement_remainder_4_0 <= ((refinement_remainder_3_0 * 2) - refinement_remainder_4_0_choice) mod 1024;
      refinement_remainder_4_1 <= ((refinement_remainder_3_1 * 2) - refinement_remainder_4_1_choice) mod 1024;
      refinement_remainder_4_2 <= ((refinement_remainder_3_2 * 2) - refinement_remainder_4_2_choice) mod 1024;
      refinement_remainder_4_3 <= ((refinement_remainder_3_3 * 2) - refinement_remainder_4_3_choice) mod 1024;
      refinement_remainder_5_0 <= ((refinement_remainder_4_0 * 2) - refinement_remainder_5_0_choice) mod 1024;
      refinement_remainder_5_1 <= ((refinement_remainder_4_1 * 2) - refinement_remainder_5_1_choice) mod 1024;
      refinement_remainder_5_2 <= ((refinement_remainder_4_2 * 2) - refinement_remainder_5_2_choice) mod 1024;
      refinement_remainder_5_3 <= ((refinement_remainder_4_3 * 2) - refinement_remainder_5_3_choice) mod 1024;
      refinement_remainder_6_0 <= ((refinement_remainder_5_0 * 2) - refinement_remainder_6_0_choice) mod 1024;
      refinement_remainder_6_1 <= ((refinement_remainder_5_1 * 2) - refinement_remainder_6_1_choice) mod 1024;
      refinement_remainder_6_2 <= ((refinement_remainder_5_2 * 2) - refinement_remainder_6_2_choice) mod 1024;
      refinement_remainder_6_3 <= ((refinement_remainder_5_3 * 2) - refinement_remainder_6_3_choice) mod 1024;
      refinement_remainder_7_0 <= ((refinement_remainder_6_0 * 2) - refinement_remainder_7_0_choice) mod 1024;
      refinement_remainder_7_1 <= ((refinement_remainder_6_1 * 2) - refinement_remainder_7_1_choice) mod 1024;
      refinement_remainder_7_2 <= ((refinement_remainder_6_2 * 2) - refinement_remainder_7_2_choice) mod 1024;
      refinement_remainder_7_3 <= ((refinement_remainder_6_3 * 2) - refinement_remainder_7_3_choice) mod 1024;
      refinement_divisor_0_0 <= 1 when refinement_remainder_0_0_choice_3 = 0 else refinement_remainder_0_0_choice_3;
      refinement_divisor_0_1 <= 1 when refinement_remainder_0_1_choice_3 = 0 else refinement_remainder_0_1_choice_3;
      refinement_divisor_0_2 <= 1 when refinement_remainder_0_2_choice_3 = 0 else refinement_remainder_0_2_choice_3;
      refinement_divisor_0_3 <= 1 when refinement_remainder_0_3_choice_3 = 0 else refinement_remainder_0_3_choice_3;
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_1_1 <= refinement_divisor_0_1;
      refinement_divisor_1_2 <= refinement_divisor_0_2;
      refinement_divisor_1_3 <= refinement_divisor_0_3;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_2_1 <= refinement_divisor_1_1;
      refinement_divisor_2_2 <= refinement_divisor_1_2;
      refinement_divisor_2_3 <= refinement_divisor_1_3;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_3_1 <= refinement_divisor_2_1;
      refinement_divisor_3_2 <= refinement_divisor_2_2;
      refinement_divisor_3_3 <= refinement_divisor_2_3;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_4_1 <= refinement_divisor_3_1;
      refinement_divisor_4_2 <= refinement_divisor_3_2;
      refinement_divisor_4_3 <= refinement_divisor_3_3;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_5_1 <= refinement_divisor_4_1;
      refinement_divisor_5_2 <= refinement_divisor_4_2;
      refinement_divisor_5_3 <= refinement_divisor_4_3;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_6_1 <= refinement_divisor_5_1;
      refinement_divisor_6_2 <= refinement_divisor_5_2;
      refinement_divisor_6_3 <= refinement_divisor_5_3;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_divisor_7_1 <= refinement_divisor_6_1;
      refinement_divisor_7_2 <= refinement_divisor_6_2;
      refinement_divisor_7_3 <= refinement_divisor_6_3;
      refinement_quotient_1_0 <= refinement_remainder_1_0_is_not_less;
      refinement_quotient_1_1 <= refinement_remainder_1_1_is_not_less;
      refinement_quotient_1_2 <= refinement_remainder_1_2_is_not_less;
      refinement_quotient_1_3 <= refinement_remainder_1_3_is_not_less;
      refinement_quotient_2_0 <= (as_number(refinement_quotient_1_0) * 2) +
        as_number(refinement_remainder_2_0_is_not_less);
      refinement_quotient_2_1 <= (as_number(refinement_quotient_1_1) * 2) +
        as_number(refinement_remainder_2_1_is_not_less);
      refinement_quotient_2_2 <= (as_number(refinement_quotient_1_2) * 2) +
        as_number(refinement_remainder_2_2_is_not_less);
      refinement_quotient_2_3 <= (as_number(refinement_quotient_1_3) * 2) +
        as_number(refinement_remainder_2_3_is_not_less);
      refinement_quotient_3_0 <= (refinement_quotient_2_0 * 2) + as_number(refinement_remainder_3_0_is_not_less);
      refinement_quotient_3_1 <= (refinement_quotient_2_1 * 2) + as_number(refinement_remainder_3_1_is_not_less);
      refinement_quotient_3_2 <= (refinement_quotient_2_2 * 2) + as_number(refinement_remainder_3_2_is_not_less);
      refinement_quotient_3_3 <= (refinement_quotient_2_3 * 2) + as_number(refinement_remainder_3_3_is_not_less);
      refinement_quotient_4_0 <= (refinement_quotient_3_0 * 2) + as_number(refinement_remainder_4_0_is_not_less);
      refinement_quotient_4_1 <= (refinement_quotient_3_1 * 2) + as_number(refinement_remainder_4_1_is_not_less);
      refinement_quotient_4_2 <= (refinement_quotient_3_2 * 2) + as_number(refinement_remainder_4_2_is_not_less);
      refinement_quotient_4_3 <= (refinement_quotient_3_3 * 2) + as_number(refinement_remainder_4_3_is_not_less);
      refinement_quotient_5_0 <= (refinement_quotient_4_0 * 2) + as_number(refinement_remainder_5_0_is_not_less);
      refinement_quotient_5_1 <= (refinement_quotient_4_1 * 2) + as_number(refinement_remainder_5_1_is_not_less);
      refinement_quotient_5_2 <= (refinement_quotient_4_2 * 2) + as_number(refinement_remainder_5_2_is_not_less);
      refinement_quotient_5_3 <= (refinement_quotient_4_3 * 2) + as_number(refinement_remainder_5_3_is_not_less);
      refinement_quotient_6_0 <= (refinement_quotient_5_0 * 2) + as_number(refinement_remainder_6_0_is_not_less);
      refinement_quotient_6_1 <= (refinement_quotient_5_1 * 2) + as_number(refinement_remainder_6_1_is_not_less);
      refinement_quotient_6_2 <= (refinement_quotient_5_2 * 2) + as_number(refinement_remainder_6_2_is_not_less);
      refinement_quotient_6_3 <= (refinement_quotient_5_3 * 2) + as_number(refinement_remainder_6_3_is_not_less);
      refinement_quotient_7_0 <= (refinement_quotient_6_0 * 2) + as_number(refinement_remainder_7_0_is_not_less);
      refinement_quotient_7_1 <= (refinement_quotient_6_1 * 2) + as_number(refinement_remainder_7_1_is_not_less);
      refinement_quotient_7_2 <= (refinement_quotient_6_2 * 2) + as_number(refinement_remainder_7_2_is_not_less);
      refinement_quotient_7_3 <= (refinement_quotient_6_3 * 2) + as_number(refinement_remainder_7_3_is_not_less);
      refinement_quotient_8_0 <= (refinement_quotient_7_0 * 2) + as_number(((refinement_remainder_7_0 * 2) >=
        refinement_divisor_7_0));
      refinement_quotient_8_1 <= (refinement_quotient_7_1 * 2) + as_number(((refinement_remainder_7_1 * 2) >=
        refinement_divisor_7_1));
      refinement_quotient_8_2 <= (refinement_quotient_7_2 * 2) + as_number(((refinement_remainder_7_2 * 2) >=
        refinement_divisor_7_2));
      refinement_quotient_8_3 <= (refinement_quotient_7_3 * 2) + as_number(((refinement_remainder_7_3 * 2) >=
        refinement_divisor_7_3));
      refinement_negative_0_0 <= refinement_remainder_0_0_is_less;
      refinement_negative_0_1 <= refinement_remainder_0_1_is_less;
      refinement_negative_0_2 <= refinement_remainder_0_2_is_less;
      refinement_negative_0_3 <= refinement_remainder_0_3_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_1_1 <= refinement_negative_0_1;
      refinement_negative_1_2 <= refinement_negative_0_2;
      refinement_negative_1_3 <= refinement_negative_0_3;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_2_1 <= refinement_negative_1_1;
      refinement_negative_2_2 <= refinement_negative_1_2;
      refinement_negative_2_3 <= refinement_negative_1_3;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_3_1 <= refinement_negative_2_1;
      refinement_negative_3_2 <= refinement_negative_2_2;
      refinement_negative_3_3 <= refinement_negative_2_3;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_4_1 <= refinement_negative_3_1;
      refinement_negative_4_2 <= refinement_negative_3_2;
      refinement_negative_4_3 <= refinement_negative_3_3;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_5_1 <= refinement_negative_4_1;
      refinement_negative_5_2 <= refinement_negative_4_2;
      refinement_negative_5_3 <= refinement_negative_4_3;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_6_1 <= refinement_negative_5_1;
      refinement_negative_6_2 <= refinement_negative_5_2;
      refinement_negative_6_3 <= refinement_negative_5_3;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_7_1 <= refinement_negative_6_1;
      refinement_negative_7_2 <= refinement_negative_6_2;
      refinement_negative_7_3 <= refinement_negative_6_3;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_negative_8_1 <= refinement_negative_7_1;
      refinement_negative_8_2 <= refinement_negative_7_2;
      refinement_negative_8_3 <= refinement_negative_7_3;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      refinement_fraction_1 <= ((((refinement_fraction_1_choice / 8) + 1) mod 32) * 8) + refinement_fraction_1_choice_2;
      refinement_fraction_2 <= ((((refinement_fraction_2_choice / 8) + 1) mod 32) * 8) + refinement_fraction_2_choice_2;
      refinement_fraction_3 <= ((((refinement_fraction_3_choice / 8) + 1) mod 32) * 8) + refinement_fraction_3_choice_2;
      -- leftright
      leftright_held_valid_all := (not leftright_holds_winners) and (((leftright_read_address / 4) = 1) or
        (((leftright_read_address / 2) mod 2) = 1) or ((leftright_read_address mod 2) = 1));
      leftright_address_0_value := to_integer(leftright_held_0(7 downto 4));
      leftright_address_1_value := to_integer(leftright_held_0(21 downto 18));
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_checked_passed_1_difference := (leftright_answered_disparity_1 + 1) - to_integer(leftright_found_1);
      leftright_checked_passed_2_difference := (leftright_answered_disparity_2 + 1) - to_integer(leftright_found_2);
      leftright_checked_passed_3_difference := (leftright_answered_disparity_3 + 1) - to_integer(leftright_found_3);
      leftright_other_1_0 <= slice2other_winner_out_0;
      leftright_other_1_1 <= slice2other_winner_out_1;
      leftright_other_1_2 <= slice2other_winner_out_2;
      leftright_other_1_3 <= slice2other_winner_out_3;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_2_1 <= leftright_other_1_1;
      leftright_other_2_2 <= leftright_other_1_2;
      leftright_other_2_3 <= leftright_other_1_3;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_other_3_1 <= leftright_other_2_1;
      leftright_other_3_2 <= leftright_other_2_2;
      leftright_other_3_3 <= leftright_other_2_3;
      leftright_other_4_0 <= leftright_other_3_0;
      leftright_other_4_1 <= leftright_other_3_1;
      leftright_other_4_2 <= leftright_other_3_2;
      leftright_other_4_3 <= leftright_other_3_3;
      leftright_other_5_0 <= leftright_other_4_0;
      leftright_other_5_1 <= leftright_other_4_1;
      leftright_other_5_2 <= leftright_other_4_2;
      leftright_other_5_3 <= leftright_other_4_3;
      leftright_other_6_0 <= leftright_other_5_0;
      leftright_other_6_1 <= leftright_other_5_1;
      leftright_other_6_2 <= leftright_other_5_2;
      leftright_other_6_3 <= leftright_other_5_3;
      leftright_other_7_0 <= leftright_other_6_0;
      leftright_other_7_1 <= leftright_other_6_1;
      leftright_other_7_2 <= leftright_other_6_2;
      leftright_other_7_3 <= leftright_other_6_3;
      leftright_other_8_0 <= leftright_other_7_0;
      leftright_other_8_1 <= leftright_other_7_1;
      leftright_other_8_2 <= leftright_other_7_2;
      leftright_other_8_3 <= leftright_other_7_3;
      leftright_other_9_0 <= leftright_other_8_0;
      leftright_other_9_1 <= leftright_other_8_1;
      leftright_other_9_2 <= leftright_other_8_2;
      leftright_other_9_3 <= leftright_other_8_3;
      leftright_other_10_0 <= leftright_other_9_0;
      leftright_other_10_1 <= leftright_other_9_1;
      leftright_other_10_2 <= leftright_other_9_2;
      leftright_other_10_3 <= leftright_other_9_3;
      leftright_other_11_0 <= leftright_other_10_0;
      leftright_other_11_1 <= leftright_other_10_1;
      leftright_other_11_2 <= leftright_other_10_2;
      leftright_other_11_3 <= leftright_other_10_3;
      leftright_position <= (leftright_position + as_number(refinement_tag_9_valid)) mod 16;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_held_valid_all) and refinement_tag_9_valid;
      leftright_holds_winners <= (not refinement_tag_9_valid) and leftright_holds_winners when leftright_held_valid_all
        else refinement_tag_9_valid or leftright_holds_winners;
      leftright_address_0 <= (leftright_held_position + leftright_address_0_value + 9) mod 16;
      leftright_address_1 <= (leftright_held_position + leftright_address_1_value + 9) mod 16;
      leftright_address_2 <= (leftright_held_position + to_integer(leftright_held_0(59 downto 32)) + 9) mod 16;
      leftright_address_3 <= (leftright_held_position + to_integer(leftright_held_0(59 downto 46)) + 9) mod 16;
      leftright_asking_disparity_0 <= leftright_address_0_value;
      leftright_asking_disparity_1 <= leftright_address_1_value;
      leftright_asking_disparity_2 <= to_integer(leftright_held_0(35 downto 32));
      leftright_asking_disparity_3 <= to_integer(leftright_held_0(49 downto 46));
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_fraction_1 <= to_integer(leftright_held_0(31 downto 27));
      leftright_asking_fraction_2 <= to_integer(leftright_held_0(45 downto 41));
      leftright_asking_fraction_3 <= to_integer(leftright_held_0(59 downto 55));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_passed_1 <= to_integer(leftright_held_0(26 downto 26)) = 1;
      leftright_asking_passed_2 <= to_integer(leftright_held_0(40 downto 40)) = 1;
      leftright_asking_passed_3 <= to_integer(leftright_held_0(54 downto 54)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= to_integer(leftright_held_0(0 downto 0)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_disparity_1 <= leftright_asking_disparity_1;
      leftright_answered_disparity_2 <= leftright_asking_disparity_2;
      leftright_answered_disparity_3 <= leftright_asking_disparity_3;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_fraction_1 <= leftright_asking_fraction_1;
      leftright_answered_fraction_2 <= leftright_asking_fraction_2;
      leftright_answered_fraction_3 <= leftright_asking_fraction_3;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_passed_1 <= leftright_asking_passed_1;
      leftright_answered_passed_2 <= leftright_asking_passed_2;
      leftright_answered_passed_3 <= leftright_asking_passed_3;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_disparity_1 <= leftright_answered_disparity_1;
      leftright_checked_disparity_2 <= leftright_answered_disparity_2;
      leftright_checked_disparity_3 <= leftright_answered_disparity_3;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_fraction_1 <= leftright_answered_fraction_1;
      leftright_checked_fraction_2 <= leftright_answered_fraction_2;
      leftright_checked_fraction_3 <= leftright_answered_fraction_3;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_passed_1 <= leftright_answered_passed_1 and (leftright_checked_passed_1_difference >= 0) and
        (leftright_checked_passed_1_difference < 3);
      leftright_checked_passed_2 <= leftright_answered_passed_2 and (leftright_checked_passed_2_difference >= 0) and
        (leftright_checked_passed_2_difference < 3);
      leftright_checked_passed_3 <= leftright_answered_passed_3 and (leftright_checked_passed_3_difference >= 0) and
        (leftright_checked_passed_3_difference < 3);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if refinement_tag_9_valid then
        leftright_read_address <= 0 when leftright_read_address = 7 else (leftright_read_address + 1) mod 8;
        leftright_write_address <= leftright_read_address;
      end if;
      -- median
      if slice0cost_pair_2_0_all then
        median_counter_column <= 0 when slice0cost_pair_2_0_is_equal or leftright_checked_tag_start_of_frame else
          (median_counter_column + 1) mod 32;
      end if;
      median_counter_group_choice := 3 when slice0cost_pair_2_0_is_equal and (median_counter_group = 2) else 0;
      median_counter_group_choice_2 := 1 when slice0cost_pair_2_0 and slice0cost_reverse_2_0_is_equal else
        (median_counter_group + 1) mod 8;
      median_counter_group_choice_3 := median_counter_group_choice_2 when (median_counter_group /= 4) and
        slice0cost_pair_2_0_is_equal and leftright_checked_tag_valid and leftright_checked_tag_map_column else
        median_counter_group;
      median_line_ended_choice := leftright_checked_tag_map_column when leftright_checked_tag_valid else
        median_line_ended;
      median_passed_1_0_all := (not median_at_arrives) and (not median_at_behind);
      median_passed_1_0_any := median_at_arrives or median_at_behind;
      median_complete_is_equal := median_write_column = 0;
      median_largest_low_0_choice := median_low_0_0 when median_low_1_0 < median_low_0_0 else median_low_1_0;
      median_largest_low_1_choice := median_low_0_1 when median_low_1_1 < median_low_0_1 else median_low_1_1;
      median_largest_low_2_choice := median_low_0_2 when median_low_1_2 < median_low_0_2 else median_low_1_2;
      median_largest_low_3_choice := median_low_0_3 when median_low_1_3 < median_low_0_3 else median_low_1_3;
      median_median_middle_0_is_less := median_middle_1_0 < median_middle_0_0;
      median_median_middle_0_choice := median_middle_0_0 when median_median_middle_0_is_less else median_middle_1_0;
      median_median_middle_0_choice_2 := median_middle_2_0 when median_middle_2_0 < median_median_middle_0_choice else
        median_median_middle_0_choice;
      median_median_middle_0_choice_3 := median_middle_1_0 when median_median_middle_0_is_less else median_middle_0_0;
      median_median_middle_1_is_less := median_middle_1_1 < median_middle_0_1;
      median_median_middle_1_choice := median_middle_0_1 when median_median_middle_1_is_less else median_middle_1_1;
      median_median_middle_1_choice_2 := median_middle_2_1 when median_middle_2_1 < median_median_middle_1_choice else
        median_median_middle_1_choice;
      median_median_middle_1_choice_3 := median_middle_1_1 when median_median_middle_1_is_less else median_middle_0_1;
      median_median_middle_2_is_less := median_middle_1_2 < median_middle_0_2;
      median_median_middle_2_choice := median_middle_0_2 when median_median_middle_2_is_less else median_middle_1_2;
      median_median_middle_2_choice_2 := median_middle_2_2 when median_middle_2_2 < median_median_middle_2_choice else
        median_median_middle_2_choice;
      median_median_middle_2_choice_3 := median_middle_1_2 when median_median_middle_2_is_less else median_middle_0_2;
      median_median_middle_3_is_less := median_middle_1_3 < median_middle_0_3;
      median_median_middle_3_choice := median_middle_0_3 when median_median_middle_3_is_less else median_middle_1_3;
      median_median_middle_3_choice_2 := median_middle_2_3 when median_middle_2_3 < median_median_middle_3_choice else
        median_median_middle_3_choice;
      median_median_middle_3_choice_3 := median_middle_1_3 when median_median_middle_3_is_less else median_middle_0_3;
      median_smallest_high_0_choice := median_high_1_0 when median_high_1_0 < median_high_0_0 else median_high_0_0;
      median_smallest_high_1_choice := median_high_1_1 when median_high_1_1 < median_high_0_1 else median_high_0_1;
      median_smallest_high_2_choice := median_high_1_2 when median_high_1_2 < median_high_0_2 else median_high_0_2;
      median_smallest_high_3_choice := median_high_1_3 when median_high_1_3 < median_high_0_3 else median_high_0_3;
      median_out_disparity_0_is_less := median_median_middle_0 < median_largest_low_0;
      median_out_disparity_0_choice := median_largest_low_0 when median_out_disparity_0_is_less else
        median_median_middle_0;
      median_out_disparity_0_choice_2 := median_smallest_high_0 when median_smallest_high_0 <
        median_out_disparity_0_choice else median_out_disparity_0_choice;
      median_out_disparity_0_choice_3 := median_median_middle_0 when median_out_disparity_0_is_less else
        median_largest_low_0;
      median_out_disparity_1_is_less := median_median_middle_1 < median_largest_low_1;
      median_out_disparity_1_choice := median_largest_low_1 when median_out_disparity_1_is_less else
        median_median_middle_1;
      median_out_disparity_1_choice_2 := median_smallest_high_1 when median_smallest_high_1 <
        median_out_disparity_1_choice else median_out_disparity_1_choice;
      median_out_disparity_1_choice_3 := median_median_middle_1 when median_out_disparity_1_is_less else
        median_largest_low_1;
      median_out_disparity_2_is_less := median_median_middle_2 < median_largest_low_2;
      median_out_disparity_2_choice := median_largest_low_2 when median_out_disparity_2_is_less else
        median_median_middle_2;
      median_out_disparity_2_choice_2 := median_smallest_high_2 when median_smallest_high_2 <
        median_out_disparity_2_choice else median_out_disparity_2_choice;
      median_out_disparity_2_choice_3 := median_median_middle_2 when median_out_disparity_2_is_less else
        median_largest_low_2;
      median_out_disparity_3_is_less := median_median_middle_3 < median_largest_low_3;
      median_out_disparity_3_choice := median_largest_low_3 when median_out_disparity_3_is_less else
        median_median_middle_3;
      median_out_disparity_3_choice_2 := median_smallest_high_3 when median_smallest_high_3 <
        median_out_disparity_3_choice else median_out_disparity_3_choice;
      median_out_disparity_3_choice_3 := median_median_middle_3 when median_out_disparity_3_is_less else
        median_largest_low_3;
      median_counter_group <= median_counter_group_choice when leftright_checked_tag_start_of_frame and
        leftright_checked_tag_valid and leftright_checked_tag_map_column else median_counter_group_choice_3;
      median_newest_0 <= ((((((((leftright_checked_disparity_0 + 2047) mod 2048) * 2) + (leftright_checked_fraction_0 /
        8) + 1) mod 4096) * 8) + (leftright_checked_fraction_0 mod 8)) * 2) + as_number(leftright_checked_passed_0);
      median_newest_1 <= ((((((((leftright_checked_disparity_1 + 2047) mod 2048) * 2) + (leftright_checked_fraction_1 /
        8) + 1) mod 4096) * 8) + (leftright_checked_fraction_1 mod 8)) * 2) + as_number(leftright_checked_passed_1);
      median_newest_2 <= ((((((((leftright_checked_disparity_2 + 2047) mod 2048) * 2) + (leftright_checked_fraction_2 /
        8) + 1) mod 4096) * 8) + (leftright_checked_fraction_2 mod 8)) * 2) + as_number(leftright_checked_passed_2);
      median_newest_3 <= ((((((((leftright_checked_disparity_3 + 2047) mod 2048) * 2) + (leftright_checked_fraction_3 /
        8) + 1) mod 4096) * 8) + (leftright_checked_fraction_3 mod 8)) * 2) + as_number(leftright_checked_passed_3);
      median_arrives <= slice0cost_pair_2_0_all;
      median_behind <= median_line_ended and leftright_checked_tag_valid;
      median_line_ended <= median_line_ended_choice when leftright_checked_tag_end_of_line else median_line_ended and
        (not leftright_checked_tag_valid);
      median_rows_read_newest_0 <= median_newest_0;
      median_rows_read_newest_1 <= median_newest_1;
      median_rows_read_newest_2 <= median_newest_2;
      median_rows_read_newest_3 <= median_newest_3;
      median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
      median_rows_ready_words_1 <= to_integer(median_rows_read_words_1);
      median_rows_ready_words_2 <= to_integer(median_rows_read_words_2);
      median_rows_ready_newest_0 <= median_rows_read_newest_0;
      median_rows_ready_newest_1 <= median_rows_read_newest_1;
      median_rows_ready_newest_2 <= median_rows_read_newest_2;
      median_rows_ready_newest_3 <= median_rows_read_newest_3;
      median_read_column <= median_counter_column;
      median_read_arrives <= median_arrives;
      median_read_behind <= median_behind;
      median_read_top <= median_counter_group = 1;
      median_read_output <= ((median_counter_group + 65535) mod 65536) < 3;
      median_ready_column <= median_read_column;
      median_ready_arrives <= median_read_arrives;
      median_ready_behind <= median_read_behind;
      median_ready_top <= median_read_top;
      median_ready_output <= median_read_output;
      median_write_column <= median_ready_column;
      median_column_1 <= median_rows_ready_words_0 / 8192;
      median_column_2 <= median_rows_ready_words_1 mod 8192;
      median_column_3 <= median_rows_ready_words_1 / 8192;
      median_column_4 <= median_rows_ready_words_2;
      median_column_5 <= median_rows_ready_newest_0;
      median_column_0_value <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
      median_at_arrives <= median_ready_arrives;
      median_at_behind <= median_ready_behind;
      median_at_top <= median_ready_top;
      median_at_output <= median_ready_output;
      median_passed_1_0 <= median_passed_0_0 or median_passed_1_0_all when median_passed_1_0 else median_passed_0_0 and
        median_passed_1_0_any;
      median_passed_1_1 <= median_passed_0_1 or median_passed_1_0_all when median_passed_1_1 else median_passed_0_1 and
        median_passed_1_0_any;
      median_passed_1_2 <= median_passed_0_2 or median_passed_1_0_all when median_passed_1_2 else median_passed_0_2 and
        median_passed_1_0_any;
      median_passed_1_3 <= median_passed_0_3 or median_passed_1_0_all when median_passed_1_3 else median_passed_0_3 and
        median_passed_1_0_any;
      median_complete <= median_at_output and median_at_behind when median_complete_is_equal else median_at_output and
        median_passed_1_0_any;
      median_first <= median_at_arrives and median_at_top and (median_write_column = 1);
      median_last <= median_at_behind;
      median_largest_low_0 <= median_largest_low_0_choice when median_low_2_0 < median_largest_low_0_choice else
        median_low_2_0;
      median_largest_low_1 <= median_largest_low_1_choice when median_low_2_1 < median_largest_low_1_choice else
        median_low_2_1;
      median_largest_low_2 <= median_largest_low_2_choice when median_low_2_2 < median_largest_low_2_choice else
        median_low_2_2;
      median_largest_low_3 <= median_largest_low_3_choice when median_low_2_3 < median_largest_low_3_choice else
        median_low_2_3;
      median_median_middle_0 <= median_median_middle_0_choice_3 when median_median_middle_0_choice_2 <
        median_median_middle_0_choice_3 else median_median_middle_0_choice_2;
      median_median_middle_1 <= median_median_middle_1_choice_3 when median_median_middle_1_choice_2 <
        median_median_middle_1_choice_3 else median_median_middle_1_choice_2;
      median_median_middle_2 <= median_median_middle_2_choice_3 when median_median_middle_2_choice_2 <
        median_median_middle_2_choice_3 else median_median_middle_2_choice_2;
      median_median_middle_3 <= median_median_middle_3_choice_3 when median_median_middle_3_choice_2 <
        median_median_middle_3_choice_3 else median_median_middle_3_choice_2;
      median_smallest_high_0 <= median_high_2_0 when median_high_2_0 < median_smallest_high_0_choice else
        median_smallest_high_0_choice;
      median_smallest_high_1 <= median_high_2_1 when median_high_2_1 < median_smallest_high_1_choice else
        median_smallest_high_1_choice;
      median_smallest_high_2 <= median_high_2_2 when median_high_2_2 < median_smallest_high_2_choice else
        median_smallest_high_2_choice;
      median_smallest_high_3 <= median_high_2_3 when median_high_2_3 < median_smallest_high_3_choice else
        median_smallest_high_3_choice;
      median_waiting_passed_0 <= median_passed_1_0;
      median_waiting_passed_1 <= median_passed_1_1;
      median_waiting_passed_2 <= median_passed_1_2;
      median_waiting_passed_3 <= median_passed_1_3;
      median_waiting_valid <= median_complete;
      median_waiting_start_of_frame <= median_first and median_complete;
      median_waiting_end_of_line <= median_last and median_complete;
      median_out_disparity_0 <= median_out_disparity_0_choice_3 when median_out_disparity_0_choice_2 <
        median_out_disparity_0_choice_3 else median_out_disparity_0_choice_2;
      median_out_disparity_1 <= median_out_disparity_1_choice_3 when median_out_disparity_1_choice_2 <
        median_out_disparity_1_choice_3 else median_out_disparity_1_choice_2;
      median_out_disparity_2 <= median_out_disparity_2_choice_3 when median_out_disparity_2_choice_2 <
        median_out_disparity_2_choice_3 else median_out_disparity_2_choice_2;
      median_out_disparity_3 <= median_out_disparity_3_choice_3 when median_out_disparity_3_choice_2 <
        median_out_disparity_3_choice_3 else median_out_disparity_3_choice_2;
      median_out_passed_0 <= median_waiting_passed_0;
      median_out_passed_1 <= median_waiting_passed_1;
      median_out_passed_2 <= median_waiting_passed_2;
      median_out_passed_3 <= median_waiting_passed_3;
      median_out_valid <= median_waiting_valid;
      median_out_start_of_frame <= median_waiting_start_of_frame;
      median_out_end_of_line <= median_waiting_end_of_line;
      if median_ready_arrives then
        median_rows_write_words_0 <= median_rows_ready_words_2 + (median_rows_ready_newest_0 * 8192);
        median_rows_write_words_1 <= to_integer(((to_unsigned(median_rows_ready_newest_2, 16) & to_unsigned(0, 13)) or
          (to_unsigned(median_rows_ready_newest_1, 29))));
        median_rows_write_words_2 <= median_rows_ready_newest_3;
        median_at_column <= median_ready_column;
      end if;
      if median_at_top then
        median_low_0_0_choice := median_column_1 / 2;
      else
        median_low_0_0_choice := median_column_0_value / 2;
      end if;
      median_low_0_0_is_less := (median_column_1 / 2) < median_low_0_0_choice;
      if median_low_0_0_is_less then
        median_low_0_0_choice_2 := median_column_1 / 2;
      else
        median_low_0_0_choice_2 := median_low_0_0_choice;
      end if;
      if (median_column_2 / 2) < median_low_0_0_choice_2 then
        median_low_0_0_choice_3 := median_column_2 / 2;
      else
        median_low_0_0_choice_3 := median_low_0_0_choice_2;
      end if;
      median_low_0_0_choice_4 := median_low_0_0 when median_at_behind else median_low_0_0_choice_3;
      median_low_0_1_is_less := (median_column_2 / 2) < (median_column_1 / 2);
      if median_low_0_1_is_less then
        median_low_0_1_choice := median_column_2 / 2;
      else
        median_low_0_1_choice := median_column_1 / 2;
      end if;
      if (median_column_3 / 2) < median_low_0_1_choice then
        median_low_0_1_choice_2 := median_column_3 / 2;
      else
        median_low_0_1_choice_2 := median_low_0_1_choice;
      end if;
      median_low_0_1_choice_3 := median_low_0_1 when median_at_behind else median_low_0_1_choice_2;
      median_low_0_2_is_less := (median_column_3 / 2) < (median_column_2 / 2);
      if median_low_0_2_is_less then
        median_low_0_2_choice := median_column_3 / 2;
      else
        median_low_0_2_choice := median_column_2 / 2;
      end if;
      if (median_column_4 / 2) < median_low_0_2_choice then
        median_low_0_2_choice_2 := median_column_4 / 2;
      else
        median_low_0_2_choice_2 := median_low_0_2_choice;
      end if;
      median_low_0_2_choice_3 := median_low_0_2 when median_at_behind else median_low_0_2_choice_2;
      if slice0cost_reverse_2_2 then
        median_low_0_3_choice := median_column_4 / 2;
      else
        median_low_0_3_choice := median_column_5 / 2;
      end if;
      median_low_0_3_is_less := (median_column_4 / 2) < (median_column_3 / 2);
      if median_low_0_3_is_less then
        median_low_0_3_choice_2 := median_column_4 / 2;
      else
        median_low_0_3_choice_2 := median_column_3 / 2;
      end if;
      if slice0cost_reverse_2_2 then
        median_low_0_3_choice_3 := median_column_4 / 2;
      else
        median_low_0_3_choice_3 := (median_column_5 / 2) mod 4096;
      end if;
      median_low_0_3_choice_4 := median_low_0_3_choice_3 when median_low_0_3_choice < median_low_0_3_choice_2 else
        median_low_0_3_choice_2;
      median_low_0_3_choice_5 := median_low_0_3 when median_at_behind else median_low_0_3_choice_4;
      median_low_1_0_all := median_at_arrives and median_complete_is_equal;
      median_middle_0_0_choice := median_low_0_0_choice when median_low_0_0_is_less else median_column_1 / 2;
      median_middle_0_0_is_less := (median_column_2 / 2) < median_middle_0_0_choice;
      if median_middle_0_0_is_less then
        median_middle_0_0_choice_2 := median_column_2 / 2;
      else
        median_middle_0_0_choice_2 := median_middle_0_0_choice;
      end if;
      median_middle_0_0_choice_3 := median_low_0_0_choice_2 when median_middle_0_0_choice_2 < median_low_0_0_choice_2
        else median_middle_0_0_choice_2;
      median_middle_0_0_choice_4 := median_middle_0_0 when median_at_behind else median_middle_0_0_choice_3;
      if median_low_0_1_is_less then
        median_middle_0_1_choice := median_column_1 / 2;
      else
        median_middle_0_1_choice := median_column_2 / 2;
      end if;
      median_middle_0_1_is_less := (median_column_3 / 2) < median_middle_0_1_choice;
      if median_middle_0_1_is_less then
        median_middle_0_1_choice_2 := median_column_3 / 2;
      else
        median_middle_0_1_choice_2 := median_middle_0_1_choice;
      end if;
      median_middle_0_1_choice_3 := median_low_0_1_choice when median_middle_0_1_choice_2 < median_low_0_1_choice else
        median_middle_0_1_choice_2;
      median_middle_0_1_choice_4 := median_middle_0_1 when median_at_behind else median_middle_0_1_choice_3;
      if median_low_0_2_is_less then
        median_middle_0_2_choice := median_column_2 / 2;
      else
        median_middle_0_2_choice := median_column_3 / 2;
      end if;
      median_middle_0_2_is_less := (median_column_4 / 2) < median_middle_0_2_choice;
      if median_middle_0_2_is_less then
        median_middle_0_2_choice_2 := median_column_4 / 2;
      else
        median_middle_0_2_choice_2 := median_middle_0_2_choice;
      end if;
      median_middle_0_2_choice_3 := median_low_0_2_choice when median_middle_0_2_choice_2 < median_low_0_2_choice else
        median_middle_0_2_choice_2;
      median_middle_0_2_choice_4 := median_middle_0_2 when median_at_behind else median_middle_0_2_choice_3;
      if median_low_0_3_is_less then
        median_middle_0_3_choice := median_column_3 / 2;
      else
        median_middle_0_3_choice := median_column_4 / 2;
      end if;
      median_middle_0_3_is_less := median_low_0_3_choice < median_middle_0_3_choice;
      median_middle_0_3_choice_2 := median_low_0_3_choice_3 when median_middle_0_3_is_less else
        median_middle_0_3_choice;
      median_middle_0_3_choice_3 := median_low_0_3_choice_2 when median_middle_0_3_choice_2 < median_low_0_3_choice_2
        else median_middle_0_3_choice_2;
      median_middle_0_3_choice_4 := median_middle_0_3 when median_at_behind else median_middle_0_3_choice_3;
      median_high_0_0_choice := median_middle_0_0_choice when median_middle_0_0_is_less else median_column_2 / 2;
      median_high_0_0_choice_2 := median_high_0_0 when median_at_behind else median_high_0_0_choice;
      median_high_0_1_choice := median_middle_0_1_choice when median_middle_0_1_is_less else median_column_3 / 2;
      median_high_0_1_choice_2 := median_high_0_1 when median_at_behind else median_high_0_1_choice;
      median_high_0_2_choice := median_middle_0_2_choice when median_middle_0_2_is_less else median_column_4 / 2;
      median_high_0_2_choice_2 := median_high_0_2 when median_at_behind else median_high_0_2_choice;
      if median_middle_0_3_is_less then
        median_high_0_3_choice := median_middle_0_3_choice;
      else
        median_high_0_3_choice := median_low_0_3_choice;
      end if;
      median_high_0_3_choice_2 := median_high_0_3 when median_at_behind else median_high_0_3_choice;
      if median_passed_1_0_any then
        median_low_0_0 <= median_low_0_0_choice_4;
        median_low_0_1 <= median_low_0_1_choice_3;
        median_low_0_2 <= median_low_0_2_choice_3;
        median_low_0_3 <= median_low_0_3_choice_5;
        median_low_1_0 <= median_low_0_0_choice_4 when median_low_1_0_all else median_low_0_0;
        median_low_1_1 <= median_low_0_1_choice_3 when median_low_1_0_all else median_low_0_1;
        median_low_1_2 <= median_low_0_2_choice_3 when median_low_1_0_all else median_low_0_2;
        median_low_1_3 <= median_low_0_3_choice_5 when median_low_1_0_all else median_low_0_3;
        median_low_2_0 <= median_low_1_0;
        median_low_2_1 <= median_low_1_1;
        median_low_2_2 <= median_low_1_2;
        median_low_2_3 <= median_low_1_3;
        median_middle_0_0 <= median_middle_0_0_choice_4;
        median_middle_0_1 <= median_middle_0_1_choice_4;
        median_middle_0_2 <= median_middle_0_2_choice_4;
        median_middle_0_3 <= median_middle_0_3_choice_4;
        median_middle_1_0 <= median_middle_0_0_choice_4 when median_low_1_0_all else median_middle_0_0;
        median_middle_1_1 <= median_middle_0_1_choice_4 when median_low_1_0_all else median_middle_0_1;
        median_middle_1_2 <= median_middle_0_2_choice_4 when median_low_1_0_all else median_middle_0_2;
        median_middle_1_3 <= median_middle_0_3_choice_4 when median_low_1_0_all else median_middle_0_3;
        median_middle_2_0 <= median_middle_1_0;
        median_middle_2_1 <= median_middle_1_1;
        median_middle_2_2 <= median_middle_1_2;
        median_middle_2_3 <= median_middle_1_3;
        median_high_0_0 <= median_high_0_0_choice_2;
        median_high_0_1 <= median_high_0_1_choice_2;
        median_high_0_2 <= median_high_0_2_choice_2;
        median_high_0_3 <= median_high_0_3_choice_2;
        median_high_1_0 <= median_high_0_0_choice_2 when median_low_1_0_all else median_high_0_0;
        median_high_1_1 <= median_high_0_1_choice_2 when median_low_1_0_all else median_high_0_1;
        median_high_1_2 <= median_high_0_2_choice_2 when median_low_1_0_all else median_high_0_2;
        median_high_1_3 <= median_high_0_3_choice_2 when median_low_1_0_all else median_high_0_3;
        median_high_2_0 <= median_high_1_0;
        median_high_2_1 <= median_high_1_1;
        median_high_2_2 <= median_high_1_2;
        median_high_2_3 <= median_high_1_3;
      end if;
      if median_at_arrives then
        median_passed_0_0 <= (median_column_1 mod 2) = 1;
        median_passed_0_1 <= (median_column_2 mod 2) = 1;
        median_passed_0_2 <= (median_column_3 mod 2) = 1;
        median_passed_0_3 <= (median_column_4 mod 2) = 1;
      end if;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_left_1 <= 0;
        transform_left_2 <= 0;
        transform_left_3 <= 0;
        transform_right_0 <= 0;
        transform_right_1 <= 0;
        transform_right_2 <= 0;
        transform_right_3 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 4;
        transform_counter_next_frame <= false;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_read_newest_1 <= 0;
        transform_left_rows_read_newest_2 <= 0;
        transform_left_rows_read_newest_3 <= 0;
        transform_left_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_left_rows_ready_words_1 <= 0;
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_ready_newest_1 <= 0;
        transform_left_rows_ready_newest_2 <= 0;
        transform_left_rows_ready_newest_3 <= 0;
        transform_left_rows_write_words_0 <= to_unsigned(0, 32);
        transform_left_rows_write_words_1 <= 0;
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_read_newest_1 <= 0;
        transform_right_rows_read_newest_2 <= 0;
        transform_right_rows_read_newest_3 <= 0;
        transform_right_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_right_rows_ready_words_1 <= 0;
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_ready_newest_1 <= 0;
        transform_right_rows_ready_newest_2 <= 0;
        transform_right_rows_ready_newest_3 <= 0;
        transform_right_rows_write_words_0 <= to_unsigned(0, 32);
        transform_right_rows_write_words_1 <= 0;
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_row_inside_1 <= false;
        transform_read_row_inside_5 <= false;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_row_inside_0 <= false;
        transform_ready_row_inside_1 <= false;
        transform_ready_row_inside_5 <= false;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_left_column_0 <= 0;
        transform_left_column_1 <= 0;
        transform_left_column_2 <= 0;
        transform_left_column_3 <= 0;
        transform_left_column_4 <= 0;
        transform_left_column_5 <= 0;
        transform_right_column_0 <= 0;
        transform_right_column_1 <= 0;
        transform_right_column_2 <= 0;
        transform_right_column_3 <= 0;
        transform_right_column_4 <= 0;
        transform_right_column_5 <= 0;
        transform_columns_row_inside_0 <= false;
        transform_columns_row_inside_1 <= false;
        transform_columns_row_inside_5 <= false;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_left_filter_column_0_0 <= 0;
        transform_left_filter_column_0_1 <= 0;
        transform_left_filter_column_0_2 <= 0;
        transform_left_filter_column_0_3 <= 0;
        transform_left_filter_column_1_0 <= 0;
        transform_left_filter_column_1_1 <= 0;
        transform_left_filter_column_1_2 <= 0;
        transform_left_filter_column_1_3 <= 0;
        transform_left_filter_column_2_0 <= 0;
        transform_left_filter_column_2_1 <= 0;
        transform_left_filter_column_2_2 <= 0;
        transform_left_filter_column_2_3 <= 0;
        transform_left_filter_feature_0 <= 0;
        transform_left_filter_feature_1 <= 0;
        transform_left_filter_feature_2 <= 0;
        transform_left_filter_feature_3 <= 0;
        transform_right_filter_column_0_0 <= 0;
        transform_right_filter_column_0_1 <= 0;
        transform_right_filter_column_0_2 <= 0;
        transform_right_filter_column_0_3 <= 0;
        transform_right_filter_column_1_0 <= 0;
        transform_right_filter_column_1_1 <= 0;
        transform_right_filter_column_1_2 <= 0;
        transform_right_filter_column_1_3 <= 0;
        transform_right_filter_column_2_0 <= 0;
        transform_right_filter_column_2_1 <= 0;
        transform_right_filter_column_2_2 <= 0;
        transform_right_filter_column_2_3 <= 0;
        transform_right_filter_feature_0 <= 0;
        transform_right_filter_feature_1 <= 0;
        transform_right_filter_feature_2 <= 0;
        transform_right_filter_feature_3 <= 0;
        transform_filtering_column_inside_0 <= false;
        transform_filtering_column_inside_2 <= false;
        transform_filtering_start_of_frame <= false;
        transform_filtering_valid <= false;
        transform_filtered_start_of_frame <= false;
        transform_filtered_valid <= false;
        raster_search_0 <= 0;
        raster_search_1 <= 0;
        raster_search_2 <= 0;
        raster_search_3 <= 0;
        raster_reference_0 <= 0;
        raster_reference_1 <= 0;
        raster_reference_2 <= 0;
        raster_reference_3 <= 0;
        raster_valid <= false;
        raster_column <= 0;
        raster_group <= 4;
        raster_next_frame <= false;
        delay_read_address <= 1;
        delay_write_address <= 0;
        delay_ahead_0 <= 0;
        delay_ahead_1 <= 0;
        delay_ahead_2 <= 0;
        delay_ahead_3 <= 0;
        delay_column <= 0;
        delay_row_inside_0 <= false;
        delay_row_inside_1 <= false;
        delay_row_inside_5 <= false;
        delay_tag_valid <= false;
        delay_tag_border_column <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        rows_search_rows_read_newest_1 <= 0;
        rows_search_rows_read_newest_2 <= 0;
        rows_search_rows_read_newest_3 <= 0;
        rows_search_rows_ready_words_0 <= 0;
        rows_search_rows_ready_words_1 <= 0;
        rows_search_rows_ready_newest_0 <= 0;
        rows_search_rows_ready_newest_1 <= 0;
        rows_search_rows_ready_newest_2 <= 0;
        rows_search_rows_ready_newest_3 <= 0;
        rows_search_rows_write_words_0 <= 0;
        rows_search_rows_write_words_1 <= 0;
        rows_reference_rows_read_newest_0 <= 0;
        rows_reference_rows_read_newest_1 <= 0;
        rows_reference_rows_read_newest_2 <= 0;
        rows_reference_rows_read_newest_3 <= 0;
        rows_reference_rows_ready_words_0 <= 0;
        rows_reference_rows_ready_words_1 <= 0;
        rows_reference_rows_ready_newest_0 <= 0;
        rows_reference_rows_ready_newest_1 <= 0;
        rows_reference_rows_ready_newest_2 <= 0;
        rows_reference_rows_ready_newest_3 <= 0;
        rows_reference_rows_write_words_0 <= 0;
        rows_reference_rows_write_words_1 <= 0;
        rows_read_column <= 0;
        rows_read_inside_0 <= false;
        rows_read_inside_1 <= false;
        rows_read_inside_5 <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_border_column <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside_0 <= false;
        rows_ready_inside_1 <= false;
        rows_ready_inside_5 <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_border_column <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search_0 <= 0;
        rows_search_1 <= 0;
        rows_search_2 <= 0;
        rows_search_3 <= 0;
        rows_search_4 <= 0;
        rows_search_5 <= 0;
        rows_reference_0 <= 0;
        rows_reference_1 <= 0;
        rows_reference_2 <= 0;
        rows_reference_3 <= 0;
        rows_reference_4 <= 0;
        rows_reference_5 <= 0;
        rows_inside_0 <= false;
        rows_inside_1 <= false;
        rows_inside_5 <= false;
        rows_tag_valid <= false;
        rows_tag_border_column <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_search_0_0 <= 0;
        slice0shift_search_0_1 <= 0;
        slice0shift_search_0_2 <= 0;
        slice0shift_search_1_0 <= 0;
        slice0shift_search_1_1 <= 0;
        slice0shift_search_1_2 <= 0;
        slice0shift_search_2_0 <= 0;
        slice0shift_search_2_1 <= 0;
        slice0shift_search_2_2 <= 0;
        slice0shift_search_3_0 <= 0;
        slice0shift_search_3_1 <= 0;
        slice0shift_search_3_2 <= 0;
        slice0shift_search_4_0 <= 0;
        slice0shift_search_4_1 <= 0;
        slice0shift_search_4_2 <= 0;
        slice0shift_search_5_0 <= 0;
        slice0shift_search_5_1 <= 0;
        slice0shift_search_5_2 <= 0;
        slice0shift_reference_0 <= 0;
        slice0shift_reference_1 <= 0;
        slice0shift_reference_2 <= 0;
        slice0shift_reference_3 <= 0;
        slice0shift_reference_4 <= 0;
        slice0shift_reference_5 <= 0;
        slice0shift_search_out_0 <= 0;
        slice0shift_search_out_1 <= 0;
        slice0shift_search_out_2 <= 0;
        slice0shift_search_out_3 <= 0;
        slice0shift_search_out_4 <= 0;
        slice0shift_search_out_5 <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_border_column <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_0_0 <= 0;
        slice0cost_difference_0_1 <= 0;
        slice0cost_difference_0_2 <= 0;
        slice0cost_difference_1_0 <= 0;
        slice0cost_difference_1_1 <= 0;
        slice0cost_difference_1_2 <= 0;
        slice0cost_difference_2_0 <= 0;
        slice0cost_difference_2_1 <= 0;
        slice0cost_difference_2_2 <= 0;
        slice0cost_difference_3_0 <= 0;
        slice0cost_difference_3_1 <= 0;
        slice0cost_difference_3_2 <= 0;
        slice0cost_difference_4_0 <= 0;
        slice0cost_difference_4_1 <= 0;
        slice0cost_difference_4_2 <= 0;
        slice0cost_difference_5_0 <= 0;
        slice0cost_difference_5_1 <= 0;
        slice0cost_difference_5_2 <= 0;
        slice0cost_reverse_0_0 <= 0;
        slice0cost_reverse_0_1 <= 0;
        slice0cost_reverse_0_2 <= 0;
        slice0cost_reverse_1_0 <= 0;
        slice0cost_reverse_1_1 <= 0;
        slice0cost_reverse_1_2 <= 0;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_border_column <= false;
        slice0cost_difference_tag_map_column <= false;
        slice0cost_difference_tag_output_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_0_0 <= 0;
        slice0cost_pair_0_1 <= 0;
        slice0cost_pair_0_2 <= 0;
        slice0cost_pair_1_0 <= 0;
        slice0cost_pair_1_1 <= 0;
        slice0cost_pair_1_2 <= 0;
        slice0cost_pair_2_0 <= false;
        slice0cost_pair_2_1 <= false;
        slice0cost_pair_2_2 <= false;
        slice0cost_single_0_0 <= 0;
        slice0cost_single_0_1 <= 0;
        slice0cost_single_0_2 <= 0;
        slice0cost_single_2_0 <= 0;
        slice0cost_single_2_1 <= 0;
        slice0cost_single_2_2 <= 0;
        slice0cost_single_3_0 <= 0;
        slice0cost_single_3_1 <= 0;
        slice0cost_single_3_2 <= 0;
        slice0cost_single_5_0 <= 0;
        slice0cost_single_5_1 <= 0;
        slice0cost_single_5_2 <= 0;
        slice0cost_negative_0_0 <= false;
        slice0cost_negative_0_1 <= false;
        slice0cost_negative_0_2 <= false;
        slice0cost_negative_2_0 <= false;
        slice0cost_negative_2_1 <= false;
        slice0cost_negative_2_2 <= false;
        slice0cost_negative_3_0 <= false;
        slice0cost_negative_3_1 <= false;
        slice0cost_negative_3_2 <= false;
        slice0cost_negative_5_0 <= false;
        slice0cost_negative_5_1 <= false;
        slice0cost_negative_5_2 <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_border_column <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
        slice0cost_column_2_0 <= 0;
        slice0cost_column_2_1 <= 0;
        slice0cost_column_2_2 <= 0;
        slice0cost_column_3_0 <= 0;
        slice0cost_column_3_1 <= 0;
        slice0cost_column_3_2 <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_border_column <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_partial_0_0_0 <= 0;
        slice0window_partial_0_0_1 <= 0;
        slice0window_partial_0_0_2 <= 0;
        slice0window_partial_0_1_0 <= 0;
        slice0window_partial_0_1_1 <= 0;
        slice0window_partial_0_1_2 <= 0;
        slice0window_partial_1_0_0 <= 0;
        slice0window_partial_1_0_1 <= 0;
        slice0window_partial_1_0_2 <= 0;
        slice0window_partial_1_1_0 <= 0;
        slice0window_partial_1_1_1 <= 0;
        slice0window_partial_1_1_2 <= 0;
        slice0window_partial_2_0_0 <= 0;
        slice0window_partial_2_0_1 <= 0;
        slice0window_partial_2_0_2 <= 0;
        slice0window_partial_2_1_0 <= 0;
        slice0window_partial_2_1_1 <= 0;
        slice0window_partial_2_1_2 <= 0;
        slice0window_partial_3_0_0 <= 0;
        slice0window_partial_3_0_1 <= 0;
        slice0window_partial_3_0_2 <= 0;
        slice0window_partial_3_1_0 <= 0;
        slice0window_partial_3_1_1 <= 0;
        slice0window_partial_3_1_2 <= 0;
        slice0window_centre_0_map_column <= false;
        slice0window_centre_0_start_of_frame <= false;
        slice0window_centre_0_end_of_line <= false;
        slice0window_sum_0_0 <= 0;
        slice0window_sum_0_1 <= 0;
        slice0window_sum_0_2 <= 0;
        slice0window_sum_1_0 <= 0;
        slice0window_sum_1_1 <= 0;
        slice0window_sum_1_2 <= 0;
        slice0window_sum_2_0 <= 0;
        slice0window_sum_2_1 <= 0;
        slice0window_sum_2_2 <= 0;
        slice0window_sum_3_0 <= 0;
        slice0window_sum_3_1 <= 0;
        slice0window_sum_3_2 <= 0;
        slice0window_tag_valid <= false;
        slice0window_tag_row_start <= false;
        slice0window_tag_first_group <= false;
        slice0window_tag_border_column <= false;
        slice0window_tag_first_cost <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_cost_0_0 <= 0;
        slice0winner1_cost_0_1 <= 0;
        slice0winner1_cost_1_0 <= 0;
        slice0winner1_cost_1_1 <= 0;
        slice0winner1_cost_2_0 <= 0;
        slice0winner1_cost_2_1 <= 0;
        slice0winner1_cost_3_0 <= 0;
        slice0winner1_cost_3_1 <= 0;
        slice0winner1_index_0_0 <= false;
        slice0winner1_index_0_1 <= 0;
        slice0winner1_index_1_0 <= false;
        slice0winner1_index_2_0 <= false;
        slice0winner1_index_3_0 <= false;
        slice0winner1_below_0_0 <= 0;
        slice0winner1_below_1_0 <= 0;
        slice0winner1_below_2_0 <= 0;
        slice0winner1_below_3_0 <= 0;
        slice0winner1_above_0_0 <= 0;
        slice0winner1_above_1_0 <= 0;
        slice0winner1_above_2_0 <= 0;
        slice0winner1_above_3_0 <= 0;
        slice0winner1_first_0_0 <= 0;
        slice0winner1_first_1_0 <= 0;
        slice0winner1_first_2_0 <= 0;
        slice0winner1_first_3_0 <= 0;
        slice0winner1_last_0_0 <= 0;
        slice0winner1_last_1_0 <= 0;
        slice0winner1_last_2_0 <= 0;
        slice0winner1_last_3_0 <= 0;
        slice0winner1_second_0_0 <= 0;
        slice0winner1_but_first_0_0 <= 0;
        slice0winner1_but_first_1_0 <= 0;
        slice0winner1_but_first_2_0 <= 0;
        slice0winner1_but_first_3_0 <= 0;
        slice0winner1_but_last_0_0 <= 0;
        slice0winner1_but_last_1_0 <= 0;
        slice0winner1_but_last_2_0 <= 0;
        slice0winner1_but_last_3_0 <= 0;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_output_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_cost_0_0 <= 0;
        slice0winner2_cost_1_0 <= 0;
        slice0winner2_cost_2_0 <= 0;
        slice0winner2_cost_3_0 <= 0;
        slice0winner2_index_0_0 <= 0;
        slice0winner2_index_1_0 <= 0;
        slice0winner2_index_2_0 <= 0;
        slice0winner2_index_3_0 <= 0;
        slice0winner2_below_0_0 <= 0;
        slice0winner2_below_1_0 <= 0;
        slice0winner2_below_2_0 <= 0;
        slice0winner2_below_3_0 <= 0;
        slice0winner2_above_0_0 <= 0;
        slice0winner2_above_1_0 <= 0;
        slice0winner2_above_2_0 <= 0;
        slice0winner2_above_3_0 <= 0;
        slice0winner2_first_0_0 <= 0;
        slice0winner2_first_1_0 <= 0;
        slice0winner2_first_2_0 <= 0;
        slice0winner2_first_3_0 <= 0;
        slice0winner2_second_0_0 <= 0;
        slice0winner2_second_1_0 <= 0;
        slice0winner2_second_2_0 <= 0;
        slice0winner2_second_3_0 <= 0;
        slice0winner2_but_first_0_0 <= 0;
        slice0winner2_but_first_1_0 <= 0;
        slice0winner2_but_first_2_0 <= 0;
        slice0winner2_but_first_3_0 <= 0;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0best_cost_0_0 <= 0;
        slice0best_cost_1_0 <= 0;
        slice0best_cost_2_0 <= 0;
        slice0best_cost_3_0 <= 0;
        slice0best_index_0_0 <= 0;
        slice0best_index_1_0 <= 0;
        slice0best_index_2_0 <= 0;
        slice0best_index_3_0 <= 0;
        slice0best_below_0_0 <= 0;
        slice0best_below_1_0 <= 0;
        slice0best_below_2_0 <= 0;
        slice0best_below_3_0 <= 0;
        slice0best_above_0_0 <= 0;
        slice0best_above_1_0 <= 0;
        slice0best_above_2_0 <= 0;
        slice0best_above_3_0 <= 0;
        slice0best_first_0_0 <= 0;
        slice0best_first_1_0 <= 0;
        slice0best_first_2_0 <= 0;
        slice0best_first_3_0 <= 0;
        slice0best_second_0_0 <= 0;
        slice0best_second_1_0 <= 0;
        slice0best_second_2_0 <= 0;
        slice0best_second_3_0 <= 0;
        slice0best_but_first_0_0 <= 0;
        slice0best_but_first_1_0 <= 0;
        slice0best_but_first_2_0 <= 0;
        slice0best_but_first_3_0 <= 0;
        slice0best_tag_valid <= false;
        slice0best_tag_map_column <= false;
        slice0best_tag_output_column <= false;
        slice0best_tag_start_of_frame <= false;
        slice0best_tag_end_of_line <= false;
        slice1shift_search_0_0 <= 0;
        slice1shift_search_0_1 <= 0;
        slice1shift_search_0_2 <= 0;
        slice1shift_search_1_0 <= 0;
        slice1shift_search_1_1 <= 0;
        slice1shift_search_1_2 <= 0;
        slice1shift_search_2_0 <= 0;
        slice1shift_search_2_1 <= 0;
        slice1shift_search_2_2 <= 0;
        slice1shift_search_3_0 <= 0;
        slice1shift_search_3_1 <= 0;
        slice1shift_search_3_2 <= 0;
        slice1shift_search_4_0 <= 0;
        slice1shift_search_4_1 <= 0;
        slice1shift_search_4_2 <= 0;
        slice1shift_search_5_0 <= 0;
        slice1shift_search_5_1 <= 0;
        slice1shift_search_5_2 <= 0;
        slice1shift_reference_0 <= 0;
        slice1shift_reference_1 <= 0;
        slice1shift_reference_2 <= 0;
        slice1shift_reference_3 <= 0;
        slice1shift_reference_4 <= 0;
        slice1shift_reference_5 <= 0;
        slice1shift_search_out_0 <= 0;
        slice1shift_search_out_1 <= 0;
        slice1shift_search_out_2 <= 0;
        slice1shift_search_out_3 <= 0;
        slice1shift_search_out_4 <= 0;
        slice1shift_search_out_5 <= 0;
        slice1cost_difference_0_0 <= 0;
        slice1cost_difference_0_1 <= 0;
        slice1cost_difference_0_2 <= 0;
        slice1cost_difference_1_0 <= 0;
        slice1cost_difference_1_1 <= 0;
        slice1cost_difference_1_2 <= 0;
        slice1cost_difference_2_0 <= 0;
        slice1cost_difference_2_1 <= 0;
        slice1cost_difference_2_2 <= 0;
        slice1cost_difference_3_0 <= 0;
        slice1cost_difference_3_1 <= 0;
        slice1cost_difference_3_2 <= 0;
        slice1cost_difference_4_0 <= 0;
        slice1cost_difference_4_1 <= 0;
        slice1cost_difference_4_2 <= 0;
        slice1cost_difference_5_0 <= 0;
        slice1cost_difference_5_1 <= 0;
        slice1cost_difference_5_2 <= 0;
        slice1cost_reverse_0_0 <= 0;
        slice1cost_reverse_0_1 <= 0;
        slice1cost_reverse_0_2 <= 0;
        slice1cost_reverse_1_0 <= 0;
        slice1cost_reverse_1_1 <= 0;
        slice1cost_reverse_1_2 <= 0;
        slice1cost_pair_0_0 <= 0;
        slice1cost_pair_0_1 <= 0;
        slice1cost_pair_0_2 <= 0;
        slice1cost_pair_1_0 <= 0;
        slice1cost_pair_1_1 <= 0;
        slice1cost_pair_1_2 <= 0;
        slice1cost_single_0_0 <= 0;
        slice1cost_single_0_1 <= 0;
        slice1cost_single_0_2 <= 0;
        slice1cost_single_2_0 <= 0;
        slice1cost_single_2_1 <= 0;
        slice1cost_single_2_2 <= 0;
        slice1cost_single_3_0 <= 0;
        slice1cost_single_3_1 <= 0;
        slice1cost_single_3_2 <= 0;
        slice1cost_single_5_0 <= 0;
        slice1cost_single_5_1 <= 0;
        slice1cost_single_5_2 <= 0;
        slice1cost_negative_0_0 <= false;
        slice1cost_negative_0_1 <= false;
        slice1cost_negative_0_2 <= false;
        slice1cost_negative_2_0 <= false;
        slice1cost_negative_2_1 <= false;
        slice1cost_negative_2_2 <= false;
        slice1cost_negative_3_0 <= false;
        slice1cost_negative_3_1 <= false;
        slice1cost_negative_3_2 <= false;
        slice1cost_negative_5_0 <= false;
        slice1cost_negative_5_1 <= false;
        slice1cost_negative_5_2 <= false;
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
        slice1cost_column_2_0 <= 0;
        slice1cost_column_2_1 <= 0;
        slice1cost_column_2_2 <= 0;
        slice1cost_column_3_0 <= 0;
        slice1cost_column_3_1 <= 0;
        slice1cost_column_3_2 <= 0;
        slice1cost_tag_border_column <= false;
        slice1cost_tag_output_column <= false;
        slice1window_partial_0_0_0 <= 0;
        slice1window_partial_0_0_1 <= 0;
        slice1window_partial_0_0_2 <= 0;
        slice1window_partial_0_1_0 <= 0;
        slice1window_partial_0_1_1 <= 0;
        slice1window_partial_0_1_2 <= 0;
        slice1window_partial_1_0_0 <= 0;
        slice1window_partial_1_0_1 <= 0;
        slice1window_partial_1_0_2 <= 0;
        slice1window_partial_1_1_0 <= 0;
        slice1window_partial_1_1_1 <= 0;
        slice1window_partial_1_1_2 <= 0;
        slice1window_partial_2_0_0 <= 0;
        slice1window_partial_2_0_1 <= 0;
        slice1window_partial_2_0_2 <= 0;
        slice1window_partial_2_1_0 <= 0;
        slice1window_partial_2_1_1 <= 0;
        slice1window_partial_2_1_2 <= 0;
        slice1window_partial_3_0_0 <= 0;
        slice1window_partial_3_0_1 <= 0;
        slice1window_partial_3_0_2 <= 0;
        slice1window_partial_3_1_0 <= 0;
        slice1window_partial_3_1_1 <= 0;
        slice1window_partial_3_1_2 <= 0;
        slice1window_sum_0_0 <= 0;
        slice1window_sum_0_1 <= 0;
        slice1window_sum_0_2 <= 0;
        slice1window_sum_1_0 <= 0;
        slice1window_sum_1_1 <= 0;
        slice1window_sum_1_2 <= 0;
        slice1window_sum_2_0 <= 0;
        slice1window_sum_2_1 <= 0;
        slice1window_sum_2_2 <= 0;
        slice1window_sum_3_0 <= 0;
        slice1window_sum_3_1 <= 0;
        slice1window_sum_3_2 <= 0;
        slice1winner1_cost_0_0 <= 0;
        slice1winner1_cost_0_1 <= 0;
        slice1winner1_cost_1_0 <= 0;
        slice1winner1_cost_1_1 <= 0;
        slice1winner1_cost_2_0 <= 0;
        slice1winner1_cost_2_1 <= 0;
        slice1winner1_cost_3_0 <= 0;
        slice1winner1_cost_3_1 <= 0;
        slice1winner1_index_0_0 <= false;
        slice1winner1_index_1_0 <= false;
        slice1winner1_index_2_0 <= false;
        slice1winner1_index_3_0 <= false;
        slice1winner1_below_0_0 <= 0;
        slice1winner1_below_1_0 <= 0;
        slice1winner1_below_2_0 <= 0;
        slice1winner1_below_3_0 <= 0;
        slice1winner1_above_0_0 <= 0;
        slice1winner1_above_1_0 <= 0;
        slice1winner1_above_2_0 <= 0;
        slice1winner1_above_3_0 <= 0;
        slice1winner1_first_0_0 <= 0;
        slice1winner1_first_1_0 <= 0;
        slice1winner1_first_2_0 <= 0;
        slice1winner1_first_3_0 <= 0;
        slice1winner1_last_0_0 <= 0;
        slice1winner1_last_1_0 <= 0;
        slice1winner1_last_2_0 <= 0;
        slice1winner1_last_3_0 <= 0;
        slice1winner1_but_first_0_0 <= 0;
        slice1winner1_but_first_1_0 <= 0;
        slice1winner1_but_first_2_0 <= 0;
        slice1winner1_but_first_3_0 <= 0;
        slice1winner1_but_last_0_0 <= 0;
        slice1winner1_but_last_1_0 <= 0;
        slice1winner1_but_last_2_0 <= 0;
        slice1winner1_but_last_3_0 <= 0;
        slice1winner2_cost_0_0 <= 0;
        slice1winner2_cost_1_0 <= 0;
        slice1winner2_cost_2_0 <= 0;
        slice1winner2_cost_3_0 <= 0;
        slice1winner2_index_0_0 <= 0;
        slice1winner2_index_1_0 <= 0;
        slice1winner2_index_2_0 <= 0;
        slice1winner2_index_3_0 <= 0;
        slice1winner2_below_0_0 <= 0;
        slice1winner2_below_1_0 <= 0;
        slice1winner2_below_2_0 <= 0;
        slice1winner2_below_3_0 <= 0;
        slice1winner2_above_0_0 <= 0;
        slice1winner2_above_1_0 <= 0;
        slice1winner2_above_2_0 <= 0;
        slice1winner2_above_3_0 <= 0;
        slice1winner2_first_0_0 <= 0;
        slice1winner2_first_1_0 <= 0;
        slice1winner2_first_2_0 <= 0;
        slice1winner2_first_3_0 <= 0;
        slice1winner2_last_0_0 <= 0;
        slice1winner2_last_1_0 <= 0;
        slice1winner2_last_2_0 <= 0;
        slice1winner2_last_3_0 <= 0;
        slice1winner2_second_0_0 <= 0;
        slice1winner2_second_1_0 <= 0;
        slice1winner2_second_2_0 <= 0;
        slice1winner2_second_3_0 <= 0;
        slice1winner2_but_first_0_0 <= 0;
        slice1winner2_but_first_1_0 <= 0;
        slice1winner2_but_first_2_0 <= 0;
        slice1winner2_but_first_3_0 <= 0;
        slice1winner2_but_last_0_0 <= 0;
        slice1winner2_but_last_1_0 <= 0;
        slice1winner2_but_last_2_0 <= 0;
        slice1winner2_but_last_3_0 <= 0;
        slice1best_cost_0_0 <= 0;
        slice1best_cost_1_0 <= 0;
        slice1best_cost_2_0 <= 0;
        slice1best_cost_3_0 <= 0;
        slice1best_index_0_0 <= 0;
        slice1best_index_1_0 <= 0;
        slice1best_index_2_0 <= 0;
        slice1best_index_3_0 <= 0;
        slice1best_below_0_0 <= 0;
        slice1best_below_1_0 <= 0;
        slice1best_below_2_0 <= 0;
        slice1best_below_3_0 <= 0;
        slice1best_above_0_0 <= 0;
        slice1best_above_1_0 <= 0;
        slice1best_above_2_0 <= 0;
        slice1best_above_3_0 <= 0;
        slice1best_first_0_0 <= 0;
        slice1best_first_1_0 <= 0;
        slice1best_first_2_0 <= 0;
        slice1best_first_3_0 <= 0;
        slice1best_second_0_0 <= 0;
        slice1best_second_1_0 <= 0;
        slice1best_second_2_0 <= 0;
        slice1best_second_3_0 <= 0;
        slice1best_but_first_0_0 <= 0;
        slice1best_but_first_1_0 <= 0;
        slice1best_but_first_2_0 <= 0;
        slice1best_but_first_3_0 <= 0;
        slice1best_tag_valid <= false;
        slice1best_tag_map_column <= false;
        slice1best_tag_output_column <= false;
        slice1best_tag_start_of_frame <= false;
        slice1best_tag_end_of_line <= false;
        slice2shift_search_0_0 <= 0;
        slice2shift_search_0_1 <= 0;
        slice2shift_search_1_0 <= 0;
        slice2shift_search_1_1 <= 0;
        slice2shift_search_2_0 <= 0;
        slice2shift_search_2_1 <= 0;
        slice2shift_search_3_0 <= 0;
        slice2shift_search_3_1 <= 0;
        slice2shift_search_4_0 <= 0;
        slice2shift_search_4_1 <= 0;
        slice2shift_search_5_0 <= 0;
        slice2shift_search_5_1 <= 0;
        slice2shift_reference_0 <= 0;
        slice2shift_reference_1 <= 0;
        slice2shift_reference_2 <= 0;
        slice2shift_reference_3 <= 0;
        slice2shift_reference_4 <= 0;
        slice2shift_reference_5 <= 0;
        slice2cost_difference_0_0 <= 0;
        slice2cost_difference_0_1 <= 0;
        slice2cost_difference_1_0 <= 0;
        slice2cost_difference_1_1 <= 0;
        slice2cost_difference_2_0 <= 0;
        slice2cost_difference_2_1 <= 0;
        slice2cost_difference_3_0 <= 0;
        slice2cost_difference_3_1 <= 0;
        slice2cost_difference_4_0 <= 0;
        slice2cost_difference_4_1 <= 0;
        slice2cost_difference_5_0 <= 0;
        slice2cost_difference_5_1 <= 0;
        slice2cost_reverse_0_0 <= 0;
        slice2cost_reverse_0_1 <= 0;
        slice2cost_reverse_1_0 <= 0;
        slice2cost_reverse_1_1 <= 0;
        slice2cost_pair_0_0 <= 0;
        slice2cost_pair_0_1 <= 0;
        slice2cost_pair_1_0 <= 0;
        slice2cost_pair_1_1 <= 0;
        slice2cost_single_0_0 <= 0;
        slice2cost_single_0_1 <= 0;
        slice2cost_single_2_0 <= 0;
        slice2cost_single_2_1 <= 0;
        slice2cost_single_3_0 <= 0;
        slice2cost_single_3_1 <= 0;
        slice2cost_single_5_0 <= 0;
        slice2cost_single_5_1 <= 0;
        slice2cost_negative_0_0 <= false;
        slice2cost_negative_0_1 <= false;
        slice2cost_negative_2_0 <= false;
        slice2cost_negative_2_1 <= false;
        slice2cost_negative_3_0 <= false;
        slice2cost_negative_3_1 <= false;
        slice2cost_negative_5_0 <= false;
        slice2cost_negative_5_1 <= false;
        slice2cost_column_0_0 <= 0;
        slice2cost_column_0_1 <= 0;
        slice2cost_column_1_0 <= 0;
        slice2cost_column_1_1 <= 0;
        slice2cost_column_2_0 <= 0;
        slice2cost_column_2_1 <= 0;
        slice2cost_column_3_0 <= 0;
        slice2cost_column_3_1 <= 0;
        slice2cost_tag_output_column <= false;
        slice2window_partial_0_0_0 <= 0;
        slice2window_partial_0_0_1 <= 0;
        slice2window_partial_0_1_0 <= 0;
        slice2window_partial_0_1_1 <= 0;
        slice2window_partial_1_0_0 <= 0;
        slice2window_partial_1_0_1 <= 0;
        slice2window_partial_1_1_0 <= 0;
        slice2window_partial_1_1_1 <= 0;
        slice2window_partial_2_0_0 <= 0;
        slice2window_partial_2_0_1 <= 0;
        slice2window_partial_2_1_0 <= 0;
        slice2window_partial_2_1_1 <= 0;
        slice2window_partial_3_0_0 <= 0;
        slice2window_partial_3_0_1 <= 0;
        slice2window_partial_3_1_0 <= 0;
        slice2window_partial_3_1_1 <= 0;
        slice2window_sum_0_0 <= 0;
        slice2window_sum_0_1 <= 0;
        slice2window_sum_1_0 <= 0;
        slice2window_sum_1_1 <= 0;
        slice2window_sum_2_0 <= 0;
        slice2window_sum_2_1 <= 0;
        slice2window_sum_3_0 <= 0;
        slice2window_sum_3_1 <= 0;
        slice2winner1_cost_0_0 <= 0;
        slice2winner1_cost_1_0 <= 0;
        slice2winner1_cost_2_0 <= 0;
        slice2winner1_cost_3_0 <= 0;
        slice2winner1_index_0_0 <= false;
        slice2winner1_index_1_0 <= false;
        slice2winner1_index_2_0 <= false;
        slice2winner1_index_3_0 <= false;
        slice2winner1_below_0_0 <= 0;
        slice2winner1_below_1_0 <= 0;
        slice2winner1_below_2_0 <= 0;
        slice2winner1_below_3_0 <= 0;
        slice2winner1_above_0_0 <= 0;
        slice2winner1_above_1_0 <= 0;
        slice2winner1_above_2_0 <= 0;
        slice2winner1_above_3_0 <= 0;
        slice2winner1_first_0_0 <= 0;
        slice2winner1_first_1_0 <= 0;
        slice2winner1_first_2_0 <= 0;
        slice2winner1_first_3_0 <= 0;
        slice2winner1_last_0_0 <= 0;
        slice2winner1_last_1_0 <= 0;
        slice2winner1_last_2_0 <= 0;
        slice2winner1_last_3_0 <= 0;
        slice2winner2_cost_0_0 <= 0;
        slice2winner2_cost_1_0 <= 0;
        slice2winner2_cost_2_0 <= 0;
        slice2winner2_cost_3_0 <= 0;
        slice2winner2_index_0_0 <= false;
        slice2winner2_index_1_0 <= false;
        slice2winner2_index_2_0 <= false;
        slice2winner2_index_3_0 <= false;
        slice2winner2_below_0_0 <= 0;
        slice2winner2_below_1_0 <= 0;
        slice2winner2_below_2_0 <= 0;
        slice2winner2_below_3_0 <= 0;
        slice2winner2_above_0_0 <= 0;
        slice2winner2_above_1_0 <= 0;
        slice2winner2_above_2_0 <= 0;
        slice2winner2_above_3_0 <= 0;
        slice2winner2_first_0_0 <= 0;
        slice2winner2_first_1_0 <= 0;
        slice2winner2_first_2_0 <= 0;
        slice2winner2_first_3_0 <= 0;
        slice2winner2_last_0_0 <= 0;
        slice2winner2_last_1_0 <= 0;
        slice2winner2_last_2_0 <= 0;
        slice2winner2_last_3_0 <= 0;
        slice2winner2_second_0_0 <= 0;
        slice2best_cost_0_0 <= 0;
        slice2best_cost_1_0 <= 0;
        slice2best_cost_2_0 <= 0;
        slice2best_cost_3_0 <= 0;
        slice2best_index_0_0 <= 0;
        slice2best_index_1_0 <= 0;
        slice2best_index_2_0 <= 0;
        slice2best_index_3_0 <= 0;
        slice2best_below_0_0 <= 0;
        slice2best_below_1_0 <= 0;
        slice2best_below_2_0 <= 0;
        slice2best_below_3_0 <= 0;
        slice2best_above_0_0 <= 0;
        slice2best_above_1_0 <= 0;
        slice2best_above_2_0 <= 0;
        slice2best_above_3_0 <= 0;
        slice2best_second_0_0 <= 0;
        slice2best_second_1_0 <= 0;
        slice2best_second_2_0 <= 0;
        slice2best_second_3_0 <= 0;
        slice2best_tag_valid <= false;
        slice2best_tag_map_column <= false;
        slice2best_tag_output_column <= false;
        slice2best_tag_start_of_frame <= false;
        slice2best_tag_end_of_line <= false;
        texture_taps_search_0_0 <= 0;
        texture_taps_search_1_0 <= 0;
        texture_taps_search_5_0 <= 0;
        texturecost_difference_0_0 <= 0;
        texturecost_difference_1_0 <= 0;
        texturecost_difference_2_0 <= 0;
        texturecost_difference_3_0 <= 0;
        texturecost_difference_4_0 <= 0;
        texturecost_difference_5_0 <= 0;
        texturecost_reverse_0_0 <= 0;
        texturecost_reverse_1_0 <= 0;
        texturecost_pair_0_0 <= 0;
        texturecost_pair_1_0 <= 0;
        texturecost_single_0_0 <= 0;
        texturecost_single_2_0 <= 0;
        texturecost_single_3_0 <= 0;
        texturecost_single_5_0 <= 0;
        texturecost_negative_0_0 <= false;
        texturecost_negative_2_0 <= false;
        texturecost_negative_3_0 <= false;
        texturecost_negative_5_0 <= false;
        texturecost_column_0_0 <= 0;
        texturecost_column_1_0 <= 0;
        texturecost_column_2_0 <= 0;
        texturecost_column_3_0 <= 0;
        texturewindow_partial_0_0_0 <= 0;
        texturewindow_partial_0_1_0 <= 0;
        texturewindow_partial_1_0_0 <= 0;
        texturewindow_partial_1_1_0 <= 0;
        texturewindow_partial_2_0_0 <= 0;
        texturewindow_partial_2_1_0 <= 0;
        texturewindow_partial_3_0_0 <= 0;
        texturewindow_partial_3_1_0 <= 0;
        texturewindow_sum_0_0 <= 0;
        texturewindow_sum_1_0 <= 0;
        texturewindow_sum_2_0 <= 0;
        texturewindow_sum_3_0 <= 0;
        texture_passes_0_0 <= false;
        texture_passes_0_1 <= false;
        texture_passes_0_2 <= false;
        texture_passes_0_3 <= false;
        texture_passes_1_0 <= false;
        texture_passes_1_1 <= false;
        texture_passes_1_2 <= false;
        texture_passes_1_3 <= false;
        texture_passes_2_0 <= false;
        texture_passes_2_1 <= false;
        texture_passes_2_2 <= false;
        texture_passes_2_3 <= false;
        texture_passes_3_0 <= false;
        texture_passes_3_1 <= false;
        texture_passes_3_2 <= false;
        texture_passes_3_3 <= false;
        texture_passes_4_0 <= false;
        texture_passes_4_1 <= false;
        texture_passes_4_2 <= false;
        texture_passes_4_3 <= false;
        refinement_disparity_0_0 <= 0;
        refinement_disparity_0_1 <= 0;
        refinement_disparity_0_2 <= 0;
        refinement_disparity_0_3 <= 0;
        refinement_disparity_1_0 <= 0;
        refinement_disparity_1_1 <= 0;
        refinement_disparity_1_2 <= 0;
        refinement_disparity_1_3 <= 0;
        refinement_disparity_2_0 <= 0;
        refinement_disparity_2_1 <= 0;
        refinement_disparity_2_2 <= 0;
        refinement_disparity_2_3 <= 0;
        refinement_disparity_3_0 <= 0;
        refinement_disparity_3_1 <= 0;
        refinement_disparity_3_2 <= 0;
        refinement_disparity_3_3 <= 0;
        refinement_disparity_4_0 <= 0;
        refinement_disparity_4_1 <= 0;
        refinement_disparity_4_2 <= 0;
        refinement_disparity_4_3 <= 0;
        refinement_disparity_5_0 <= 0;
        refinement_disparity_5_1 <= 0;
        refinement_disparity_5_2 <= 0;
        refinement_disparity_5_3 <= 0;
        refinement_disparity_6_0 <= 0;
        refinement_disparity_6_1 <= 0;
        refinement_disparity_6_2 <= 0;
        refinement_disparity_6_3 <= 0;
        refinement_disparity_7_0 <= 0;
        refinement_disparity_7_1 <= 0;
        refinement_disparity_7_2 <= 0;
        refinement_disparity_7_3 <= 0;
        refinement_disparity_8_0 <= 0;
        refinement_disparity_8_1 <= 0;
        refinement_disparity_8_2 <= 0;
        refinement_disparity_8_3 <= 0;
        refinement_disparity_9_0 <= 0;
        refinement_disparity_9_1 <= 0;
        refinement_disparity_9_2 <= 0;
        refinement_disparity_9_3 <= 0;
        refinement_passed_0_0 <= false;
        refinement_passed_0_1 <= false;
        refinement_passed_0_2 <= false;
        refinement_passed_0_3 <= false;
        refinement_passed_1_0 <= false;
        refinement_passed_1_1 <= false;
        refinement_passed_1_2 <= false;
        refinement_passed_1_3 <= false;
        refinement_passed_2_0 <= false;
        refinement_passed_2_1 <= false;
        refinement_passed_2_2 <= false;
        refinement_passed_2_3 <= false;
        refinement_passed_3_0 <= false;
        refinement_passed_3_1 <= false;
        refinement_passed_3_2 <= false;
        refinement_passed_3_3 <= false;
        refinement_passed_4_0 <= false;
        refinement_passed_4_1 <= false;
        refinement_passed_4_2 <= false;
        refinement_passed_4_3 <= false;
        refinement_passed_5_0 <= false;
        refinement_passed_5_1 <= false;
        refinement_passed_5_2 <= false;
        refinement_passed_5_3 <= false;
        refinement_passed_6_0 <= false;
        refinement_passed_6_1 <= false;
        refinement_passed_6_2 <= false;
        refinement_passed_6_3 <= false;
        refinement_passed_7_0 <= false;
        refinement_passed_7_1 <= false;
        refinement_passed_7_2 <= false;
        refinement_passed_7_3 <= false;
        refinement_passed_8_0 <= false;
        refinement_passed_8_1 <= false;
        refinement_passed_8_2 <= false;
        refinement_passed_8_3 <= false;
        refinement_passed_9_0 <= false;
        refinement_passed_9_1 <= false;
        refinement_passed_9_2 <= false;
        refinement_passed_9_3 <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_map_column <= false;
        refinement_tag_0_output_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_map_column <= false;
        refinement_tag_1_output_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_map_column <= false;
        refinement_tag_2_output_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_map_column <= false;
        refinement_tag_3_output_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_map_column <= false;
        refinement_tag_4_output_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_map_column <= false;
        refinement_tag_5_output_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_map_column <= false;
        refinement_tag_6_output_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_map_column <= false;
        refinement_tag_7_output_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_map_column <= false;
        refinement_tag_8_output_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_map_column <= false;
        refinement_tag_9_output_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_cost_0 <= 0;
        refinement_cost_1 <= 0;
        refinement_cost_2 <= 0;
        refinement_cost_3 <= 0;
        refinement_gap_0 <= 0;
        refinement_gap_1 <= 0;
        refinement_gap_2 <= 0;
        refinement_gap_3 <= 0;
        refinement_scaled_gap_0 <= 0;
        refinement_scaled_gap_1 <= 0;
        refinement_scaled_gap_2 <= 0;
        refinement_scaled_gap_3 <= 0;
        refinement_scaled_cost_0 <= 0;
        refinement_scaled_cost_1 <= 0;
        refinement_scaled_cost_2 <= 0;
        refinement_scaled_cost_3 <= 0;
        refinement_remainder_0_0 <= 0;
        refinement_remainder_0_1 <= 0;
        refinement_remainder_0_2 <= 0;
        refinement_remainder_0_3 <= 0;
        refinement_remainder_1_0 <= 0;
        refinement_remainder_1_1 <= 0;
        refinement_remainder_1_2 <= 0;
        refinement_remainder_1_3 <= 0;
        refinement_remainder_2_0 <= 0;
        refinement_remainder_2_1 <= 0;
        refinement_remainder_2_2 <= 0;
        refinement_remainder_2_3 <= 0;
        refinement_remainder_3_0 <= 0;
        refinement_remainder_3_1 <= 0;
        refinement_remainder_3_2 <= 0;
        refinement_remainder_3_3 <= 0;
        refinement_remainder_4_0 <= 0;
        refinement_remainder_4_1 <= 0;
        refinement_remainder_4_2 <= 0;
        refinement_remainder_4_3 <= 0;
        refinement_remainder_5_0 <= 0;
        refinement_remainder_5_1 <= 0;
        refinement_remainder_5_2 <= 0;
        refinement_remainder_5_3 <= 0;
        refinement_remainder_6_0 <= 0;
        refinement_remainder_6_1 <= 0;
        refinement_remainder_6_2 <= 0;
        refinement_remainder_6_3 <= 0;
        refinement_remainder_7_0 <= 0;
        refinement_remainder_7_1 <= 0;
        refinement_remainder_7_2 <= 0;
        refinement_remainder_7_3 <= 0;
        refinement_divisor_0_0 <= 1;
        refinement_divisor_0_1 <= 1;
        refinement_divisor_0_2 <= 1;
        refinement_divisor_0_3 <= 1;
        refinement_divisor_1_0 <= 1;
        refinement_divisor_1_1 <= 1;
        refinement_divisor_1_2 <= 1;
        refinement_divisor_1_3 <= 1;
        refinement_divisor_2_0 <= 1;
        refinement_divisor_2_1 <= 1;
        refinement_divisor_2_2 <= 1;
        refinement_divisor_2_3 <= 1;
        refinement_divisor_3_0 <= 1;
        refinement_divisor_3_1 <= 1;
        refinement_divisor_3_2 <= 1;
        refinement_divisor_3_3 <= 1;
        refinement_divisor_4_0 <= 1;
        refinement_divisor_4_1 <= 1;
        refinement_divisor_4_2 <= 1;
        refinement_divisor_4_3 <= 1;
        refinement_divisor_5_0 <= 1;
        refinement_divisor_5_1 <= 1;
        refinement_divisor_5_2 <= 1;
        refinement_divisor_5_3 <= 1;
        refinement_divisor_6_0 <= 1;
        refinement_divisor_6_1 <= 1;
        refinement_divisor_6_2 <= 1;
        refinement_divisor_6_3 <= 1;
        refinement_divisor_7_0 <= 1;
        refinement_divisor_7_1 <= 1;
        refinement_divisor_7_2 <= 1;
        refinement_divisor_7_3 <= 1;
        refinement_quotient_1_0 <= false;
        refinement_quotient_1_1 <= false;
        refinement_quotient_1_2 <= false;
        refinement_quotient_1_3 <= false;
        refinement_quotient_2_0 <= 0;
        refinement_quotient_2_1 <= 0;
        refinement_quotient_2_2 <= 0;
        refinement_quotient_2_3 <= 0;
        refinement_quotient_3_0 <= 0;
        refinement_quotient_3_1 <= 0;
        refinement_quotient_3_2 <= 0;
        refinement_quotient_3_3 <= 0;
        refinement_quotient_4_0 <= 0;
        refinement_quotient_4_1 <= 0;
        refinement_quotient_4_2 <= 0;
        refinement_quotient_4_3 <= 0;
        refinement_quotient_5_0 <= 0;
        refinement_quotient_5_1 <= 0;
        refinement_quotient_5_2 <= 0;
        refinement_quotient_5_3 <= 0;
        refinement_quotient_6_0 <= 0;
        refinement_quotient_6_1 <= 0;
        refinement_quotient_6_2 <= 0;
        refinement_quotient_6_3 <= 0;
        refinement_quotient_7_0 <= 0;
        refinement_quotient_7_1 <= 0;
        refinement_quotient_7_2 <= 0;
        refinement_quotient_7_3 <= 0;
        refinement_quotient_8_0 <= 0;
        refinement_quotient_8_1 <= 0;
        refinement_quotient_8_2 <= 0;
        refinement_quotient_8_3 <= 0;
        refinement_negative_0_0 <= false;
        refinement_negative_0_1 <= false;
        refinement_negative_0_2 <= false;
        refinement_negative_0_3 <= false;
        refinement_negative_1_0 <= false;
        refinement_negative_1_1 <= false;
        refinement_negative_1_2 <= false;
        refinement_negative_1_3 <= false;
        refinement_negative_2_0 <= false;
        refinement_negative_2_1 <= false;
        refinement_negative_2_2 <= false;
        refinement_negative_2_3 <= false;
        refinement_negative_3_0 <= false;
        refinement_negative_3_1 <= false;
        refinement_negative_3_2 <= false;
        refinement_negative_3_3 <= false;
        refinement_negative_4_0 <= false;
        refinement_negative_4_1 <= false;
        refinement_negative_4_2 <= false;
        refinement_negative_4_3 <= false;
        refinement_negative_5_0 <= false;
        refinement_negative_5_1 <= false;
        refinement_negative_5_2 <= false;
        refinement_negative_5_3 <= false;
        refinement_negative_6_0 <= false;
        refinement_negative_6_1 <= false;
        refinement_negative_6_2 <= false;
        refinement_negative_6_3 <= false;
        refinement_negative_7_0 <= false;
        refinement_negative_7_1 <= false;
        refinement_negative_7_2 <= false;
        refinement_negative_7_3 <= false;
        refinement_negative_8_0 <= false;
        refinement_negative_8_1 <= false;
        refinement_negative_8_2 <= false;
        refinement_negative_8_3 <= false;
        refinement_fraction_0 <= 8;
        refinement_fraction_1 <= 8;
        refinement_fraction_2 <= 8;
        refinement_fraction_3 <= 8;
        leftright_read_address <= 1;
        leftright_write_address <= 0;
        leftright_position <= 0;
        leftright_held_position <= 0;
        leftright_held_valid <= false;
        leftright_holds_winners <= false;
        leftright_address_0 <= 0;
        leftright_address_1 <= 0;
        leftright_address_2 <= 0;
        leftright_address_3 <= 0;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
        median_counter_column <= 0;
        median_counter_group <= 4;
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
