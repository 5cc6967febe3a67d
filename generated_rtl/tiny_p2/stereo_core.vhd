-- SPDX-License-Identifier: Apache-2.0
-- Stereo block-matching core, configuration tiny_p2: 32x12, 8 disparities, 3x3 window, 2 pixel pairs a clock.
-- Made from hls/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_p2
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core is
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(15 downto 0);  -- 8 bits a row, the upper row in bits 7 ... 0
    right_pixel : in std_logic_vector(15 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(1 downto 0);  -- a bit a row: the disparity has passed every check
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
  signal in_left_pixel : natural range 0 to 65535;
  signal in_right_pixel : natural range 0 to 65535;
  -- raster
  signal raster_left_0, raster_left_1 : natural range 0 to 255;
  signal raster_right : natural range 0 to 65535;
  signal raster_valid, raster_next_frame : boolean;
  signal raster_column : natural range 0 to 31;
  signal raster_group : natural range 0 to 7;
  -- reference
  signal reference_read_address, reference_write_address : natural range 0 to 7;
  signal reference_left_0, reference_left_1 : natural range 0 to 255;
  signal reference_right : unsigned(15 downto 0);
  signal reference_column : natural range 0 to 31;
  signal reference_row_inside_0, reference_row_inside_1, reference_row_inside_3, reference_tag_valid : boolean;
  signal reference_tag_border_column, reference_tag_output_column, reference_tag_start_of_frame : boolean;
  signal reference_tag_end_of_line : boolean;
  -- rows
  signal rows_read_left_word, rows_read_right_word : unsigned(23 downto 0);
  signal rows_read_left_0, rows_read_left_1, rows_read_right_0, rows_read_right_1 : natural range 0 to 255;
  signal rows_ready_left_0, rows_ready_left_1, rows_ready_right_0, rows_ready_right_1 : natural range 0 to 255;
  signal rows_left_0, rows_left_1, rows_left_2, rows_left_3, rows_right_0, rows_right_1 : natural range 0 to 255;
  signal rows_right_2, rows_right_3 : natural range 0 to 255;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_3, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_3 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  signal rows_ready_left_word, rows_ready_right_word, rows_write_left, rows_write_right : natural range 0 to 16777215;
  -- slice0shift
  signal slice0shift_left_0_0, slice0shift_left_0_1, slice0shift_left_0_2 : natural range 0 to 255;
  signal slice0shift_left_1_0, slice0shift_left_1_1, slice0shift_left_1_2 : natural range 0 to 255;
  signal slice0shift_left_2_0, slice0shift_left_2_1, slice0shift_left_2_2 : natural range 0 to 255;
  signal slice0shift_left_3_0, slice0shift_left_3_1, slice0shift_left_3_2, slice0shift_right_0 : natural range 0 to 255;
  signal slice0shift_right_1, slice0shift_right_2, slice0shift_right_3, slice0shift_left_out_0 : natural range 0 to 255;
  signal slice0shift_left_out_1, slice0shift_left_out_2, slice0shift_left_out_3 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -255 to 255;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -255 to 255;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -255 to 255;
  signal slice0cost_reverse_0_0, slice0cost_reverse_0_1, slice0cost_reverse_0_2 : natural range 0 to 255;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_single_3_0, slice0cost_single_3_1, slice0cost_single_3_2 : natural range 0 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_negative_3_0, slice0cost_negative_3_1, slice0cost_negative_3_2 : boolean;
  signal slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 511;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  signal slice0cost_column_1_0, slice0cost_column_1_1, slice0cost_column_1_2 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_1_0_0, slice0window_partial_1_0_1, slice0window_partial_1_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_partial_1_1_0, slice0window_partial_1_1_1, slice0window_partial_1_1_2 : natural range 0 to 1534;
  signal slice0window_centre_0_output_column, slice0window_centre_0_start_of_frame : boolean;
  signal slice0window_centre_0_end_of_line, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  signal slice0window_sum_1_0, slice0window_sum_1_1, slice0window_sum_1_2 : natural range 0 to 2301;
  -- slice0winner1
  signal slice0winner1_cost_0_0, slice0winner1_cost_0_1, slice0winner1_cost_1_0 : natural range 0 to 2301;
  signal slice0winner1_cost_1_1 : natural range 0 to 2301;
  signal slice0winner1_index_0_0, slice0winner1_index_1_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_index_0_1 : natural range 0 to 2;
  -- slice0winner2
  signal slice0winner2_cost_0_0, slice0winner2_cost_1_0 : natural range 0 to 2301;
  signal slice0winner2_index_0_0, slice0winner2_index_1_0 : natural range 0 to 2;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0best
  signal slice0best_cost_0, slice0best_cost_1 : natural range 0 to 2301;
  signal slice0best_disparity_0, slice0best_disparity_1 : natural range 0 to 7;
  signal slice0best_tag_valid, slice0best_tag_output_column, slice0best_tag_start_of_frame : boolean;
  signal slice0best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_left_0_0, slice1shift_left_0_1, slice1shift_left_0_2 : natural range 0 to 255;
  signal slice1shift_left_1_0, slice1shift_left_1_1, slice1shift_left_1_2 : natural range 0 to 255;
  signal slice1shift_left_2_0, slice1shift_left_2_1, slice1shift_left_2_2 : natural range 0 to 255;
  signal slice1shift_left_3_0, slice1shift_left_3_1, slice1shift_left_3_2, slice1shift_right_0 : natural range 0 to 255;
  signal slice1shift_right_1, slice1shift_right_2, slice1shift_right_3, slice1shift_left_out_0 : natural range 0 to 255;
  signal slice1shift_left_out_1, slice1shift_left_out_2, slice1shift_left_out_3 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -255 to 255;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -255 to 255;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -255 to 255;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -255 to 255;
  signal slice1cost_reverse_0_0, slice1cost_reverse_0_1, slice1cost_reverse_0_2 : natural range 0 to 255;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_single_3_0, slice1cost_single_3_1, slice1cost_single_3_2 : natural range 0 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2, slice1cost_negative_3_0 : boolean;
  signal slice1cost_negative_3_1, slice1cost_negative_3_2, slice1cost_tag_border_column : boolean;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 767;
  signal slice1cost_column_1_0, slice1cost_column_1_1, slice1cost_column_1_2 : natural range 0 to 767;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 767;
  signal slice1window_partial_1_0_0, slice1window_partial_1_0_1, slice1window_partial_1_0_2 : natural range 0 to 767;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 1534;
  signal slice1window_partial_1_1_0, slice1window_partial_1_1_1, slice1window_partial_1_1_2 : natural range 0 to 1534;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2301;
  signal slice1window_sum_1_0, slice1window_sum_1_1, slice1window_sum_1_2 : natural range 0 to 2301;
  -- slice1winner1
  signal slice1winner1_cost_0_0, slice1winner1_cost_0_1, slice1winner1_cost_1_0 : natural range 0 to 2301;
  signal slice1winner1_cost_1_1 : natural range 0 to 2301;
  signal slice1winner1_index_0_0, slice1winner1_index_1_0 : boolean;
  -- slice1winner2
  signal slice1winner2_cost_0_0, slice1winner2_cost_1_0 : natural range 0 to 2301;
  signal slice1winner2_index_0_0, slice1winner2_index_1_0 : natural range 0 to 2;
  -- slice1best
  signal slice1best_cost_0, slice1best_cost_1 : natural range 0 to 2301;
  signal slice1best_disparity_0, slice1best_disparity_1 : natural range 0 to 7;
  signal slice1best_tag_valid, slice1best_tag_output_column, slice1best_tag_start_of_frame : boolean;
  signal slice1best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_left_0_0, slice2shift_left_0_1, slice2shift_left_1_0 : natural range 0 to 255;
  signal slice2shift_left_1_1, slice2shift_left_2_0, slice2shift_left_2_1 : natural range 0 to 255;
  signal slice2shift_left_3_0, slice2shift_left_3_1, slice2shift_right_0, slice2shift_right_1 : natural range 0 to 255;
  signal slice2shift_right_2, slice2shift_right_3 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_difference_0_0, slice2cost_difference_0_1, slice2cost_difference_1_0 : integer range -255 to 255;
  signal slice2cost_difference_1_1, slice2cost_difference_2_0, slice2cost_difference_2_1 : integer range -255 to 255;
  signal slice2cost_difference_3_0, slice2cost_difference_3_1 : integer range -255 to 255;
  signal slice2cost_reverse_0_0, slice2cost_reverse_0_1, slice2cost_single_0_0 : natural range 0 to 255;
  signal slice2cost_single_0_1, slice2cost_single_3_0, slice2cost_single_3_1 : natural range 0 to 255;
  signal slice2cost_pair_0_0, slice2cost_pair_0_1 : natural range 0 to 511;
  signal slice2cost_negative_0_0, slice2cost_negative_0_1, slice2cost_negative_3_0, slice2cost_negative_3_1 : boolean;
  signal slice2cost_column_0_0, slice2cost_column_0_1, slice2cost_column_1_0 : natural range 0 to 767;
  signal slice2cost_column_1_1 : natural range 0 to 767;
  -- slice2window
  signal slice2window_partial_0_0_0, slice2window_partial_0_0_1, slice2window_partial_1_0_0 : natural range 0 to 767;
  signal slice2window_partial_1_0_1 : natural range 0 to 767;
  signal slice2window_partial_0_1_0, slice2window_partial_0_1_1, slice2window_partial_1_1_0 : natural range 0 to 1534;
  signal slice2window_partial_1_1_1 : natural range 0 to 1534;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_1_0 : natural range 0 to 2301;
  signal slice2window_sum_1_1 : natural range 0 to 2301;
  -- slice2winner1
  signal slice2winner1_cost_0_0, slice2winner1_cost_1_0 : natural range 0 to 2301;
  signal slice2winner1_index_0_0, slice2winner1_index_1_0 : boolean;
  -- slice2winner2
  signal slice2winner2_cost_0_0, slice2winner2_cost_1_0 : natural range 0 to 2301;
  signal slice2winner2_index_0_0, slice2winner2_index_1_0 : boolean;
  -- slice2best
  signal slice2best_disparity_0, slice2best_disparity_1 : natural range 0 to 7;
  signal slice2best_tag_valid, slice2best_tag_output_column, slice2best_tag_start_of_frame : boolean;
  signal slice2best_tag_end_of_line : boolean;
  signal rows_read_left_word_memory_write_data : unsigned(23 downto 0);
  signal rows_read_right_word_memory_write_data : unsigned(23 downto 0);
  signal reference_right_memory_write_data : unsigned(15 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_left_pixel <= to_integer(unsigned(left_pixel));
  in_right_pixel <= to_integer(unsigned(right_pixel));
  disparity <= std_logic_vector(to_unsigned(slice2best_disparity_1, 8) & to_unsigned(slice2best_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(3, 2));
  disparity_valid <= as_bit(slice2best_tag_valid and slice2best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice2best_tag_start_of_frame and slice2best_tag_valid and slice2best_tag_output_column);
  disparity_end_of_line <= as_bit(slice2best_tag_end_of_line and slice2best_tag_valid and slice2best_tag_output_column);

  rows_read_left_word_memory_write_data <= to_unsigned(rows_write_left, 24);
  rows_read_left_word_memory : entity work.line_memory
    generic map (depth => 32, width => 24)
    port map (
      clock => clock, read_enable => true,
      read_address => reference_column, read_data => rows_read_left_word,
      write_address => rows_write_column, write_data => rows_read_left_word_memory_write_data);

  rows_read_right_word_memory_write_data <= to_unsigned(rows_write_right, 24);
  rows_read_right_word_memory : entity work.line_memory
    generic map (depth => 32, width => 24)
    port map (
      clock => clock, read_enable => true,
      read_address => reference_column, read_data => rows_read_right_word,
      write_address => rows_write_column, write_data => rows_read_right_word_memory_write_data);

  reference_right_memory_write_data <= to_unsigned(raster_right, 16);
  reference_right_memory : entity work.line_memory
    generic map (depth => 8, width => 16)
    port map (
      clock => clock, read_enable => true,
      read_address => reference_read_address, read_data => reference_right,
      write_address => reference_write_address, write_data => reference_right_memory_write_data);

  process (clock)
    variable raster_column_all, raster_column_is_equal, raster_group_is_equal, raster_group_value : boolean;
    variable raster_next_frame_choice, raster_next_frame_choice_2, raster_next_frame_all : boolean;
    variable raster_next_frame_choice_3, raster_next_frame_choice_4, reference_row_inside_0_any : boolean;
    variable reference_row_inside_1_any, reference_tag_border_column_choice, slice0winner1_cost_0_0_is_less : boolean;
    variable slice0winner1_cost_1_0_is_less, slice0winner2_cost_0_0_is_less, slice0winner2_cost_1_0_is_less : boolean;
    variable slice1winner1_cost_0_0_is_less, slice1winner1_cost_1_0_is_less, slice1winner2_cost_0_0_is_less : boolean;
    variable slice1winner2_cost_1_0_is_less, slice1best_cost_0_is_less, slice1best_cost_1_is_less : boolean;
    variable slice2winner1_cost_0_0_is_less, slice2winner1_cost_1_0_is_less : boolean;
    variable raster_column_choice, raster_column_choice_2 : natural range 0 to 31;
    variable raster_group_choice : natural range 0 to 3;
    variable raster_group_choice_2, raster_group_choice_3, raster_group_choice_4 : natural range 0 to 7;
    variable slice0cost_pair_0_0_choice, slice0cost_pair_0_1_choice : natural range 0 to 255;
    variable slice0cost_pair_0_2_choice, slice1cost_pair_0_0_choice : natural range 0 to 255;
    variable slice1cost_pair_0_1_choice, slice1cost_pair_0_2_choice : natural range 0 to 255;
    variable slice2cost_pair_0_0_choice, slice2cost_pair_0_1_choice : natural range 0 to 255;
  begin
    if rising_edge(clock) then
      -- raster
      raster_column_all := in_start_of_frame and in_valid;
      raster_column_is_equal := raster_column = 31;
      raster_column_choice := 0 when raster_column_is_equal else (raster_column + 1) mod 32;
      raster_column_choice_2 := raster_column_choice when in_valid else raster_column;
      raster_group_is_equal := raster_group = 5;
      raster_group_choice := 3 when raster_column_is_equal and raster_group_is_equal else 0;
      raster_group_value := ((raster_group / 2) mod 2) = 1;
      raster_group_choice_2 := 1 when raster_next_frame and (raster_group = 6) else (raster_group + 1) mod 8;
      raster_group_choice_3 := raster_group_choice_2 when raster_column_is_equal and ((not ((raster_group mod 2) = 1))
        or (not ((raster_group / 4) = 1)) or (not raster_group_value)) else raster_group;
      raster_group_choice_4 := raster_group_choice_3 when in_valid else raster_group;
      raster_next_frame_choice := raster_next_frame and ((raster_group mod 2) = 1) when (raster_group / 2) = 3 else
        raster_next_frame;
      raster_next_frame_choice_2 := raster_next_frame_choice when raster_column_is_equal else raster_next_frame;
      raster_next_frame_all := (not in_valid) and raster_next_frame;
      raster_next_frame_choice_3 := raster_next_frame_all when in_start_of_frame else in_valid or raster_next_frame;
      raster_next_frame_choice_4 := raster_next_frame_choice_3 when raster_next_frame_choice_2 else
        raster_next_frame_all;
      raster_left_0 <= in_left_pixel mod 256;
      raster_left_1 <= in_left_pixel / 256;
      raster_right <= in_right_pixel;
      raster_valid <= in_valid;
      raster_column <= 0 when raster_column_all else raster_column_choice_2;
      raster_group <= raster_group_choice * 2 when raster_column_all else raster_group_choice_4;
      raster_next_frame <= raster_next_frame_choice_4 or (raster_column_is_equal and raster_group_is_equal and
        in_start_of_frame and in_valid);
      -- reference
      if raster_valid then
        reference_read_address <= 0 when reference_read_address = 7 else (reference_read_address + 1) mod 8;
        reference_write_address <= reference_read_address;
      end if;
      reference_row_inside_0_any := ((raster_group / 4) = 1) or raster_group_value;
      reference_row_inside_1_any := (not ((raster_group / 4) = 1)) or (not raster_group_value);
      reference_tag_border_column_choice := (raster_column / 4) = 0 when (raster_column mod 4) = 3 else (raster_column
        / 8) = 0;
      reference_left_0 <= raster_left_0;
      reference_left_1 <= raster_left_1;
      reference_column <= raster_column;
      reference_row_inside_0 <= reference_row_inside_0_any;
      reference_row_inside_1 <= reference_row_inside_1_any when (raster_group mod 2) = 1 else
        reference_row_inside_0_any;
      reference_row_inside_3 <= reference_row_inside_1_any;
      reference_tag_valid <= raster_valid;
      reference_tag_border_column <= reference_tag_border_column_choice;
      reference_tag_output_column <= (raster_column /= 31) and (not reference_tag_border_column_choice) and
        (((raster_group + 65529) mod 65536) >= 65530);
      reference_tag_start_of_frame <= (raster_column = 7) and (raster_group = 1);
      reference_tag_end_of_line <= raster_column = 30;
      -- rows
      rows_read_left_0 <= reference_left_0;
      rows_read_left_1 <= reference_left_1;
      rows_read_right_0 <= to_integer(reference_right(7 downto 0));
      rows_read_right_1 <= to_integer(reference_right(15 downto 8));
      rows_read_column <= reference_column;
      rows_read_inside_0 <= reference_row_inside_0;
      rows_read_inside_1 <= reference_row_inside_1;
      rows_read_inside_3 <= reference_row_inside_3;
      rows_read_tag_valid <= reference_tag_valid;
      rows_read_tag_border_column <= reference_tag_border_column;
      rows_read_tag_output_column <= reference_tag_output_column;
      rows_read_tag_start_of_frame <= reference_tag_start_of_frame;
      rows_read_tag_end_of_line <= reference_tag_end_of_line;
      rows_ready_left_word <= to_integer(rows_read_left_word);
      rows_ready_right_word <= to_integer(rows_read_right_word);
      rows_ready_left_0 <= rows_read_left_0;
      rows_ready_left_1 <= rows_read_left_1;
      rows_ready_right_0 <= rows_read_right_0;
      rows_ready_right_1 <= rows_read_right_1;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_left_0 <= rows_ready_left_word mod 256 when rows_ready_inside_0 else 0;
      rows_left_1 <= (rows_ready_left_word / 256) mod 256 when rows_ready_inside_1 else 0;
      rows_left_2 <= rows_ready_left_word / 65536 when rows_ready_inside_1 else 0;
      rows_left_3 <= rows_ready_left_0 when rows_ready_inside_3 else 0;
      rows_right_0 <= rows_ready_right_word mod 256 when rows_ready_inside_0 else 0;
      rows_right_1 <= (rows_ready_right_word / 256) mod 256 when rows_ready_inside_1 else 0;
      rows_right_2 <= rows_ready_right_word / 65536 when rows_ready_inside_1 else 0;
      rows_right_3 <= rows_ready_right_0 when rows_ready_inside_3 else 0;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_tag_valid then
        rows_write_left <= (rows_ready_left_0 * 256) + (rows_ready_left_1 * 65536) + (rows_ready_left_word / 65536);
        rows_write_right <= (rows_ready_right_word / 65536) + (rows_ready_right_0 * 256) + (rows_ready_right_1 * 65536);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_left_0_0 <= slice0shift_left_0_1;
        slice0shift_left_0_1 <= slice0shift_left_0_2;
        slice0shift_left_0_2 <= rows_left_0;
        slice0shift_left_1_0 <= slice0shift_left_1_1;
        slice0shift_left_1_1 <= slice0shift_left_1_2;
        slice0shift_left_1_2 <= rows_left_1;
        slice0shift_left_2_0 <= slice0shift_left_2_1;
        slice0shift_left_2_1 <= slice0shift_left_2_2;
        slice0shift_left_2_2 <= rows_left_2;
        slice0shift_left_3_0 <= slice0shift_left_3_1;
        slice0shift_left_3_1 <= slice0shift_left_3_2;
        slice0shift_left_3_2 <= rows_left_3;
      end if;
      slice0shift_right_0 <= rows_right_0;
      slice0shift_right_1 <= rows_right_1;
      slice0shift_right_2 <= rows_right_2;
      slice0shift_right_3 <= rows_right_3;
      slice0shift_left_out_0 <= slice0shift_left_0_0;
      slice0shift_left_out_1 <= slice0shift_left_1_0;
      slice0shift_left_out_2 <= slice0shift_left_2_0;
      slice0shift_left_out_3 <= slice0shift_left_3_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pair_0_0_choice := slice0cost_reverse_0_0 when slice0cost_difference_2_0 < 0 else
        positive_part(slice0cost_difference_2_0);
      slice0cost_pair_0_1_choice := slice0cost_reverse_0_1 when slice0cost_difference_2_1 < 0 else
        positive_part(slice0cost_difference_2_1);
      slice0cost_pair_0_2_choice := slice0cost_reverse_0_2 when slice0cost_difference_2_2 < 0 else
        positive_part(slice0cost_difference_2_2);
      slice0cost_difference_0_0 <= slice0shift_left_0_0 - slice0shift_right_0;
      slice0cost_difference_0_1 <= slice0shift_left_0_1 - slice0shift_right_0;
      slice0cost_difference_0_2 <= slice0shift_left_0_2 - slice0shift_right_0;
      slice0cost_difference_1_0 <= slice0shift_left_1_0 - slice0shift_right_1;
      slice0cost_difference_1_1 <= slice0shift_left_1_1 - slice0shift_right_1;
      slice0cost_difference_1_2 <= slice0shift_left_1_2 - slice0shift_right_1;
      slice0cost_difference_2_0 <= slice0shift_left_2_0 - slice0shift_right_2;
      slice0cost_difference_2_1 <= slice0shift_left_2_1 - slice0shift_right_2;
      slice0cost_difference_2_2 <= slice0shift_left_2_2 - slice0shift_right_2;
      slice0cost_difference_3_0 <= slice0shift_left_3_0 - slice0shift_right_3;
      slice0cost_difference_3_1 <= slice0shift_left_3_1 - slice0shift_right_3;
      slice0cost_difference_3_2 <= slice0shift_left_3_2 - slice0shift_right_3;
      slice0cost_reverse_0_0 <= (slice0shift_right_2 - slice0shift_left_2_0) mod 256;
      slice0cost_reverse_0_1 <= (slice0shift_right_2 - slice0shift_left_2_1) mod 256;
      slice0cost_reverse_0_2 <= (slice0shift_right_2 - slice0shift_left_2_2) mod 256;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pair_0_0_choice + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= slice0cost_pair_0_1_choice + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= slice0cost_pair_0_2_choice + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_single_0_0 <= folded(slice0cost_difference_0_0);
      slice0cost_single_0_1 <= folded(slice0cost_difference_0_1);
      slice0cost_single_0_2 <= folded(slice0cost_difference_0_2);
      slice0cost_single_3_0 <= folded(slice0cost_difference_3_0);
      slice0cost_single_3_1 <= folded(slice0cost_difference_3_1);
      slice0cost_single_3_2 <= folded(slice0cost_difference_3_2);
      slice0cost_negative_0_0 <= slice0cost_difference_0_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_0_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_0_2 < 0;
      slice0cost_negative_3_0 <= slice0cost_difference_3_0 < 0;
      slice0cost_negative_3_1 <= slice0cost_difference_3_1 < 0;
      slice0cost_negative_3_2 <= slice0cost_difference_3_2 < 0;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_column_0_0 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_0) +
        slice0cost_pair_0_0 + slice0cost_single_0_0;
      slice0cost_column_0_1 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_1) +
        slice0cost_pair_0_1 + slice0cost_single_0_1;
      slice0cost_column_0_2 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_0_2) +
        slice0cost_pair_0_2 + slice0cost_single_0_2;
      slice0cost_column_1_0 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_3_0) +
        slice0cost_pair_0_0 + slice0cost_single_3_0;
      slice0cost_column_1_1 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_3_1) +
        slice0cost_pair_0_1 + slice0cost_single_3_1;
      slice0cost_column_1_2 <= 0 when slice0cost_pair_tag_border_column else as_number(slice0cost_negative_3_2) +
        slice0cost_pair_0_2 + slice0cost_single_3_2;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
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
      end if;
      slice0window_centre_0_output_column <= slice0cost_tag_output_column;
      slice0window_centre_0_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_centre_0_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_1_0;
      slice0window_sum_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_1_1;
      slice0window_sum_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_0_output_column;
      slice0window_tag_start_of_frame <= slice0window_centre_0_start_of_frame;
      slice0window_tag_end_of_line <= slice0window_centre_0_end_of_line;
      -- slice0winner1
      slice0winner1_cost_0_0_is_less := slice0window_sum_0_1 < slice0window_sum_0_0;
      slice0winner1_cost_1_0_is_less := slice0window_sum_1_1 < slice0window_sum_1_0;
      slice0winner1_cost_0_0 <= slice0window_sum_0_1 when slice0winner1_cost_0_0_is_less else slice0window_sum_0_0;
      slice0winner1_cost_0_1 <= slice0window_sum_0_2;
      slice0winner1_cost_1_0 <= slice0window_sum_1_1 when slice0winner1_cost_1_0_is_less else slice0window_sum_1_0;
      slice0winner1_cost_1_1 <= slice0window_sum_1_2;
      slice0winner1_index_0_0 <= slice0winner1_cost_0_0_is_less;
      slice0winner1_index_0_1 <= 2;
      slice0winner1_index_1_0 <= slice0winner1_cost_1_0_is_less;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_tag_valid then
        slice0winner1_tag_output_column <= slice0window_tag_output_column;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0winner2
      slice0winner2_cost_0_0_is_less := slice0winner1_cost_0_1 < slice0winner1_cost_0_0;
      slice0winner2_cost_1_0_is_less := slice0winner1_cost_1_1 < slice0winner1_cost_1_0;
      slice0winner2_cost_0_0 <= slice0winner1_cost_0_1 when slice0winner2_cost_0_0_is_less else slice0winner1_cost_0_0;
      slice0winner2_cost_1_0 <= slice0winner1_cost_1_1 when slice0winner2_cost_1_0_is_less else slice0winner1_cost_1_0;
      slice0winner2_index_0_0 <= slice0winner1_index_0_1 when slice0winner2_cost_0_0_is_less else
        as_number(slice0winner1_index_0_0);
      slice0winner2_index_1_0 <= slice0winner1_index_0_1 when slice0winner2_cost_1_0_is_less else
        as_number(slice0winner1_index_1_0);
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      -- slice0best
      slice0best_cost_0 <= slice0winner2_cost_0_0;
      slice0best_cost_1 <= slice0winner2_cost_1_0;
      slice0best_disparity_0 <= slice0winner2_index_0_0 + 5;
      slice0best_disparity_1 <= slice0winner2_index_1_0 + 5;
      slice0best_tag_valid <= slice0winner2_tag_valid;
      slice0best_tag_output_column <= slice0winner2_tag_output_column;
      slice0best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0best_tag_end_of_line <= slice0winner2_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_left_0_0 <= slice1shift_left_0_1;
        slice1shift_left_0_1 <= slice1shift_left_0_2;
        slice1shift_left_0_2 <= slice0shift_left_out_0;
        slice1shift_left_1_0 <= slice1shift_left_1_1;
        slice1shift_left_1_1 <= slice1shift_left_1_2;
        slice1shift_left_1_2 <= slice0shift_left_out_1;
        slice1shift_left_2_0 <= slice1shift_left_2_1;
        slice1shift_left_2_1 <= slice1shift_left_2_2;
        slice1shift_left_2_2 <= slice0shift_left_out_2;
        slice1shift_left_3_0 <= slice1shift_left_3_1;
        slice1shift_left_3_1 <= slice1shift_left_3_2;
        slice1shift_left_3_2 <= slice0shift_left_out_3;
      end if;
      slice1shift_right_0 <= slice0shift_right_0;
      slice1shift_right_1 <= slice0shift_right_1;
      slice1shift_right_2 <= slice0shift_right_2;
      slice1shift_right_3 <= slice0shift_right_3;
      slice1shift_left_out_0 <= slice1shift_left_0_0;
      slice1shift_left_out_1 <= slice1shift_left_1_0;
      slice1shift_left_out_2 <= slice1shift_left_2_0;
      slice1shift_left_out_3 <= slice1shift_left_3_0;
      -- slice1cost
      slice1cost_pair_0_0_choice := slice1cost_reverse_0_0 when slice1cost_difference_2_0 < 0 else
        positive_part(slice1cost_difference_2_0);
      slice1cost_pair_0_1_choice := slice1cost_reverse_0_1 when slice1cost_difference_2_1 < 0 else
        positive_part(slice1cost_difference_2_1);
      slice1cost_pair_0_2_choice := slice1cost_reverse_0_2 when slice1cost_difference_2_2 < 0 else
        positive_part(slice1cost_difference_2_2);
      slice1cost_difference_0_0 <= slice1shift_left_0_0 - slice1shift_right_0;
      slice1cost_difference_0_1 <= slice1shift_left_0_1 - slice1shift_right_0;
      slice1cost_difference_0_2 <= slice1shift_left_0_2 - slice1shift_right_0;
      slice1cost_difference_1_0 <= slice1shift_left_1_0 - slice1shift_right_1;
      slice1cost_difference_1_1 <= slice1shift_left_1_1 - slice1shift_right_1;
      slice1cost_difference_1_2 <= slice1shift_left_1_2 - slice1shift_right_1;
      slice1cost_difference_2_0 <= slice1shift_left_2_0 - slice1shift_right_2;
      slice1cost_difference_2_1 <= slice1shift_left_2_1 - slice1shift_right_2;
      slice1cost_difference_2_2 <= slice1shift_left_2_2 - slice1shift_right_2;
      slice1cost_difference_3_0 <= slice1shift_left_3_0 - slice1shift_right_3;
      slice1cost_difference_3_1 <= slice1shift_left_3_1 - slice1shift_right_3;
      slice1cost_difference_3_2 <= slice1shift_left_3_2 - slice1shift_right_3;
      slice1cost_reverse_0_0 <= (slice1shift_right_2 - slice1shift_left_2_0) mod 256;
      slice1cost_reverse_0_1 <= (slice1shift_right_2 - slice1shift_left_2_1) mod 256;
      slice1cost_reverse_0_2 <= (slice1shift_right_2 - slice1shift_left_2_2) mod 256;
      slice1cost_pair_0_0 <= slice1cost_pair_0_0_choice + folded(slice1cost_difference_1_0) +
        as_number((slice1cost_difference_1_0 < 0));
      slice1cost_pair_0_1 <= slice1cost_pair_0_1_choice + folded(slice1cost_difference_1_1) +
        as_number((slice1cost_difference_1_1 < 0));
      slice1cost_pair_0_2 <= slice1cost_pair_0_2_choice + folded(slice1cost_difference_1_2) +
        as_number((slice1cost_difference_1_2 < 0));
      slice1cost_single_0_0 <= folded(slice1cost_difference_0_0);
      slice1cost_single_0_1 <= folded(slice1cost_difference_0_1);
      slice1cost_single_0_2 <= folded(slice1cost_difference_0_2);
      slice1cost_single_3_0 <= folded(slice1cost_difference_3_0);
      slice1cost_single_3_1 <= folded(slice1cost_difference_3_1);
      slice1cost_single_3_2 <= folded(slice1cost_difference_3_2);
      slice1cost_negative_0_0 <= slice1cost_difference_0_0 < 0;
      slice1cost_negative_0_1 <= slice1cost_difference_0_1 < 0;
      slice1cost_negative_0_2 <= slice1cost_difference_0_2 < 0;
      slice1cost_negative_3_0 <= slice1cost_difference_3_0 < 0;
      slice1cost_negative_3_1 <= slice1cost_difference_3_1 < 0;
      slice1cost_negative_3_2 <= slice1cost_difference_3_2 < 0;
      slice1cost_column_0_0 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_0) +
        slice1cost_pair_0_0 + slice1cost_single_0_0;
      slice1cost_column_0_1 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_1) +
        slice1cost_pair_0_1 + slice1cost_single_0_1;
      slice1cost_column_0_2 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_0_2) +
        slice1cost_pair_0_2 + slice1cost_single_0_2;
      slice1cost_column_1_0 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_3_0) +
        slice1cost_pair_0_0 + slice1cost_single_3_0;
      slice1cost_column_1_1 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_3_1) +
        slice1cost_pair_0_1 + slice1cost_single_3_1;
      slice1cost_column_1_2 <= 0 when slice0cost_tag_border_column else as_number(slice1cost_negative_3_2) +
        slice1cost_pair_0_2 + slice1cost_single_3_2;
      slice1cost_tag_border_column <= slice0cost_tag_border_column;
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
      end if;
      slice1window_sum_0_0 <= slice1cost_column_0_0 + slice1window_partial_0_1_0;
      slice1window_sum_0_1 <= slice1cost_column_0_1 + slice1window_partial_0_1_1;
      slice1window_sum_0_2 <= slice1cost_column_0_2 + slice1window_partial_0_1_2;
      slice1window_sum_1_0 <= slice1cost_column_1_0 + slice1window_partial_1_1_0;
      slice1window_sum_1_1 <= slice1cost_column_1_1 + slice1window_partial_1_1_1;
      slice1window_sum_1_2 <= slice1cost_column_1_2 + slice1window_partial_1_1_2;
      -- slice1winner1
      slice1winner1_cost_0_0_is_less := slice1window_sum_0_1 < slice1window_sum_0_0;
      slice1winner1_cost_1_0_is_less := slice1window_sum_1_1 < slice1window_sum_1_0;
      slice1winner1_cost_0_0 <= slice1window_sum_0_1 when slice1winner1_cost_0_0_is_less else slice1window_sum_0_0;
      slice1winner1_cost_0_1 <= slice1window_sum_0_2;
      slice1winner1_cost_1_0 <= slice1window_sum_1_1 when slice1winner1_cost_1_0_is_less else slice1window_sum_1_0;
      slice1winner1_cost_1_1 <= slice1window_sum_1_2;
      slice1winner1_index_0_0 <= slice1winner1_cost_0_0_is_less;
      slice1winner1_index_1_0 <= slice1winner1_cost_1_0_is_less;
      -- slice1winner2
      slice1winner2_cost_0_0_is_less := slice1winner1_cost_0_1 < slice1winner1_cost_0_0;
      slice1winner2_cost_1_0_is_less := slice1winner1_cost_1_1 < slice1winner1_cost_1_0;
      slice1winner2_cost_0_0 <= slice1winner1_cost_0_1 when slice1winner2_cost_0_0_is_less else slice1winner1_cost_0_0;
      slice1winner2_cost_1_0 <= slice1winner1_cost_1_1 when slice1winner2_cost_1_0_is_less else slice1winner1_cost_1_0;
      slice1winner2_index_0_0 <= slice0winner1_index_0_1 when slice1winner2_cost_0_0_is_less else
        as_number(slice1winner1_index_0_0);
      slice1winner2_index_1_0 <= slice0winner1_index_0_1 when slice1winner2_cost_1_0_is_less else
        as_number(slice1winner1_index_1_0);
      -- slice1best
      slice1best_cost_0_is_less := slice0best_cost_0 < slice1winner2_cost_0_0;
      slice1best_cost_1_is_less := slice0best_cost_1 < slice1winner2_cost_1_0;
      slice1best_cost_0 <= slice0best_cost_0 when slice1best_cost_0_is_less else slice1winner2_cost_0_0;
      slice1best_cost_1 <= slice0best_cost_1 when slice1best_cost_1_is_less else slice1winner2_cost_1_0;
      slice1best_disparity_0 <= slice0best_disparity_0 when slice1best_cost_0_is_less else (((slice1winner2_index_0_0 /
        2) + 1) * 2) + (slice1winner2_index_0_0 mod 2);
      slice1best_disparity_1 <= slice0best_disparity_1 when slice1best_cost_1_is_less else (((slice1winner2_index_1_0 /
        2) + 1) * 2) + (slice1winner2_index_1_0 mod 2);
      slice1best_tag_valid <= slice0best_tag_valid;
      slice1best_tag_output_column <= slice0best_tag_output_column;
      slice1best_tag_start_of_frame <= slice0best_tag_start_of_frame;
      slice1best_tag_end_of_line <= slice0best_tag_end_of_line;
      -- slice2shift
      if slice0cost_difference_tag_valid then
        slice2shift_left_0_0 <= slice2shift_left_0_1;
        slice2shift_left_0_1 <= slice1shift_left_out_0;
        slice2shift_left_1_0 <= slice2shift_left_1_1;
        slice2shift_left_1_1 <= slice1shift_left_out_1;
        slice2shift_left_2_0 <= slice2shift_left_2_1;
        slice2shift_left_2_1 <= slice1shift_left_out_2;
        slice2shift_left_3_0 <= slice2shift_left_3_1;
        slice2shift_left_3_1 <= slice1shift_left_out_3;
      end if;
      slice2shift_right_0 <= slice1shift_right_0;
      slice2shift_right_1 <= slice1shift_right_1;
      slice2shift_right_2 <= slice1shift_right_2;
      slice2shift_right_3 <= slice1shift_right_3;
      -- slice2cost
      slice2cost_pair_0_0_choice := slice2cost_reverse_0_0 when slice2cost_difference_2_0 < 0 else
        positive_part(slice2cost_difference_2_0);
      slice2cost_pair_0_1_choice := slice2cost_reverse_0_1 when slice2cost_difference_2_1 < 0 else
        positive_part(slice2cost_difference_2_1);
      slice2cost_difference_0_0 <= slice2shift_left_0_0 - slice2shift_right_0;
      slice2cost_difference_0_1 <= slice2shift_left_0_1 - slice2shift_right_0;
      slice2cost_difference_1_0 <= slice2shift_left_1_0 - slice2shift_right_1;
      slice2cost_difference_1_1 <= slice2shift_left_1_1 - slice2shift_right_1;
      slice2cost_difference_2_0 <= slice2shift_left_2_0 - slice2shift_right_2;
      slice2cost_difference_2_1 <= slice2shift_left_2_1 - slice2shift_right_2;
      slice2cost_difference_3_0 <= slice2shift_left_3_0 - slice2shift_right_3;
      slice2cost_difference_3_1 <= slice2shift_left_3_1 - slice2shift_right_3;
      slice2cost_reverse_0_0 <= (slice2shift_right_2 - slice2shift_left_2_0) mod 256;
      slice2cost_reverse_0_1 <= (slice2shift_right_2 - slice2shift_left_2_1) mod 256;
      slice2cost_pair_0_0 <= slice2cost_pair_0_0_choice + folded(slice2cost_difference_1_0) +
        as_number((slice2cost_difference_1_0 < 0));
      slice2cost_pair_0_1 <= slice2cost_pair_0_1_choice + folded(slice2cost_difference_1_1) +
        as_number((slice2cost_difference_1_1 < 0));
      slice2cost_single_0_0 <= folded(slice2cost_difference_0_0);
      slice2cost_single_0_1 <= folded(slice2cost_difference_0_1);
      slice2cost_single_3_0 <= folded(slice2cost_difference_3_0);
      slice2cost_single_3_1 <= folded(slice2cost_difference_3_1);
      slice2cost_negative_0_0 <= slice2cost_difference_0_0 < 0;
      slice2cost_negative_0_1 <= slice2cost_difference_0_1 < 0;
      slice2cost_negative_3_0 <= slice2cost_difference_3_0 < 0;
      slice2cost_negative_3_1 <= slice2cost_difference_3_1 < 0;
      slice2cost_column_0_0 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_0_0) +
        slice2cost_pair_0_0 + slice2cost_single_0_0;
      slice2cost_column_0_1 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_0_1) +
        slice2cost_pair_0_1 + slice2cost_single_0_1;
      slice2cost_column_1_0 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_3_0) +
        slice2cost_pair_0_0 + slice2cost_single_3_0;
      slice2cost_column_1_1 <= 0 when slice1cost_tag_border_column else as_number(slice2cost_negative_3_1) +
        slice2cost_pair_0_1 + slice2cost_single_3_1;
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
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      slice2window_sum_1_0 <= slice2cost_column_1_0 + slice2window_partial_1_1_0;
      slice2window_sum_1_1 <= slice2cost_column_1_1 + slice2window_partial_1_1_1;
      -- slice2winner1
      slice2winner1_cost_0_0_is_less := slice2window_sum_0_1 < slice2window_sum_0_0;
      slice2winner1_cost_1_0_is_less := slice2window_sum_1_1 < slice2window_sum_1_0;
      slice2winner1_cost_0_0 <= slice2window_sum_0_1 when slice2winner1_cost_0_0_is_less else slice2window_sum_0_0;
      slice2winner1_cost_1_0 <= slice2window_sum_1_1 when slice2winner1_cost_1_0_is_less else slice2window_sum_1_0;
      slice2winner1_index_0_0 <= slice2winner1_cost_0_0_is_less;
      slice2winner1_index_1_0 <= slice2winner1_cost_1_0_is_less;
      -- slice2winner2
      slice2winner2_cost_0_0 <= slice2winner1_cost_0_0;
      slice2winner2_cost_1_0 <= slice2winner1_cost_1_0;
      slice2winner2_index_0_0 <= slice2winner1_index_0_0;
      slice2winner2_index_1_0 <= slice2winner1_index_1_0;
      -- slice2best
      slice2best_disparity_0 <= slice1best_disparity_0 when slice1best_cost_0 < slice2winner2_cost_0_0 else
        as_number(slice2winner2_index_0_0);
      slice2best_disparity_1 <= slice1best_disparity_1 when slice1best_cost_1 < slice2winner2_cost_1_0 else
        as_number(slice2winner2_index_1_0);
      slice2best_tag_valid <= slice1best_tag_valid;
      slice2best_tag_output_column <= slice1best_tag_output_column;
      slice2best_tag_start_of_frame <= slice1best_tag_start_of_frame;
      slice2best_tag_end_of_line <= slice1best_tag_end_of_line;
      if reset = '1' then
        raster_valid <= false;
        raster_column <= 0;
        raster_group <= 7;
        raster_next_frame <= false;
        reference_read_address <= 1;
        reference_write_address <= 0;
        reference_column <= 0;
        reference_tag_valid <= false;
        reference_tag_output_column <= false;
        reference_tag_start_of_frame <= false;
        reference_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_tag_valid <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        rows_write_column <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_difference_tag_valid <= false;
        slice0cost_difference_tag_output_column <= false;
        slice0cost_difference_tag_start_of_frame <= false;
        slice0cost_difference_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_centre_0_output_column <= false;
        slice0window_centre_0_start_of_frame <= false;
        slice0window_centre_0_end_of_line <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_output_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0best_tag_valid <= false;
        slice0best_tag_output_column <= false;
        slice0best_tag_start_of_frame <= false;
        slice0best_tag_end_of_line <= false;
        slice1best_tag_valid <= false;
        slice1best_tag_output_column <= false;
        slice1best_tag_start_of_frame <= false;
        slice1best_tag_end_of_line <= false;
        slice2best_tag_valid <= false;
        slice2best_tag_output_column <= false;
        slice2best_tag_start_of_frame <= false;
        slice2best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
