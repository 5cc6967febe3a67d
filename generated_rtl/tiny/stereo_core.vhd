-- SPDX-License-Identifier: Apache-2.0
-- Stereo block-matching core, configuration tiny: 32x12, 8 disparities, 3x3 window.
-- Made from hls/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core is
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with the pixel pair at column 0 of row 0
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(7 downto 0);
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
  signal raster_left, raster_right : natural range 0 to 255;
  signal raster_valid, raster_next_frame : boolean;
  signal raster_column : natural range 0 to 31;
  signal raster_row : natural range 0 to 15;
  -- reference
  signal reference_read_address, reference_write_address : natural range 0 to 7;
  signal reference_left : natural range 0 to 255;
  signal reference_right : unsigned(7 downto 0);
  signal reference_column : natural range 0 to 31;
  signal reference_row_inside_0, reference_row_inside_1, reference_row_inside_2, reference_tag_valid : boolean;
  signal reference_tag_cost_column, reference_tag_output_column, reference_tag_start_of_frame : boolean;
  signal reference_tag_end_of_line : boolean;
  -- rows
  signal rows_word : unsigned(31 downto 0);
  signal rows_newest_left, rows_newest_right, rows_left_0, rows_left_1, rows_left_2 : natural range 0 to 255;
  signal rows_right_0, rows_right_1, rows_right_2 : natural range 0 to 255;
  signal rows_write_column : natural range 0 to 31;
  signal rows_inside_before_0, rows_inside_before_1, rows_inside_before_2, rows_tag_before_valid : boolean;
  signal rows_tag_before_cost_column, rows_tag_before_output_column, rows_tag_before_start_of_frame : boolean;
  signal rows_tag_before_end_of_line, rows_tag_valid, rows_tag_cost_column, rows_tag_output_column : boolean;
  signal rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- shift
  signal shift_left_0_0, shift_left_0_1, shift_left_0_2, shift_left_0_3, shift_left_0_4 : natural range 0 to 255;
  signal shift_left_0_5, shift_left_0_6, shift_left_0_7, shift_left_1_0, shift_left_1_1 : natural range 0 to 255;
  signal shift_left_1_2, shift_left_1_3, shift_left_1_4, shift_left_1_5, shift_left_1_6 : natural range 0 to 255;
  signal shift_left_1_7, shift_left_2_0, shift_left_2_1, shift_left_2_2, shift_left_2_3 : natural range 0 to 255;
  signal shift_left_2_4, shift_left_2_5, shift_left_2_6, shift_left_2_7, shift_right_0 : natural range 0 to 255;
  signal shift_right_1, shift_right_2 : natural range 0 to 255;
  signal shift_tag_valid, shift_tag_cost_column, shift_tag_output_column, shift_tag_start_of_frame : boolean;
  signal shift_tag_end_of_line : boolean;
  -- cost
  signal cost_difference_0_0, cost_difference_0_1, cost_difference_0_2, cost_difference_0_3 : natural range 0 to 255;
  signal cost_difference_0_4, cost_difference_0_5, cost_difference_0_6, cost_difference_0_7 : natural range 0 to 255;
  signal cost_difference_1_0, cost_difference_1_1, cost_difference_1_2, cost_difference_1_3 : natural range 0 to 255;
  signal cost_difference_1_4, cost_difference_1_5, cost_difference_1_6, cost_difference_1_7 : natural range 0 to 255;
  signal cost_difference_2_0, cost_difference_2_1, cost_difference_2_2, cost_difference_2_3 : natural range 0 to 255;
  signal cost_difference_2_4, cost_difference_2_5, cost_difference_2_6, cost_difference_2_7 : natural range 0 to 255;
  signal cost_tag_before_valid, cost_tag_before_cost_column, cost_tag_before_output_column : boolean;
  signal cost_tag_before_start_of_frame, cost_tag_before_end_of_line, cost_tag_valid, cost_tag_output_column : boolean;
  signal cost_tag_start_of_frame, cost_tag_end_of_line : boolean;
  signal cost_column_0, cost_column_1, cost_column_2, cost_column_3, cost_column_4 : natural range 0 to 765;
  signal cost_column_5, cost_column_6, cost_column_7 : natural range 0 to 765;
  -- window
  signal window_history_0_0, window_history_0_1, window_history_0_2, window_history_0_3 : natural range 0 to 765;
  signal window_history_0_4, window_history_0_5, window_history_0_6, window_history_0_7 : natural range 0 to 765;
  signal window_history_1_0, window_history_1_1, window_history_1_2, window_history_1_3 : natural range 0 to 765;
  signal window_history_1_4, window_history_1_5, window_history_1_6, window_history_1_7 : natural range 0 to 765;
  signal window_centre_0_output_column, window_centre_0_start_of_frame, window_centre_0_end_of_line : boolean;
  signal window_tag_valid, window_tag_output_column, window_tag_start_of_frame, window_tag_end_of_line : boolean;
  signal window_sum_0, window_sum_1, window_sum_2, window_sum_3, window_sum_4, window_sum_5 : natural range 0 to 2295;
  signal window_sum_6, window_sum_7 : natural range 0 to 2295;
  -- winner1
  signal winner1_cost_0, winner1_cost_1 : natural range 0 to 2295;
  signal winner1_index_0 : natural range 0 to 3;
  signal winner1_index_1 : natural range 0 to 7;
  signal winner1_tag_valid, winner1_tag_output_column, winner1_tag_start_of_frame, winner1_tag_end_of_line : boolean;
  -- winner2
  signal winner2_index_0 : natural range 0 to 7;
  signal winner2_tag_valid, winner2_tag_output_column, winner2_tag_start_of_frame, winner2_tag_end_of_line : boolean;
  signal rows_memory_write_data : unsigned(31 downto 0);
  signal reference_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(left_pixel));
  in_right_pixel <= to_integer(unsigned(right_pixel));
  disparity <= std_logic_vector(to_unsigned(winner2_index_0, 8));
  disparity_valid <= as_bit(winner2_tag_valid and winner2_tag_output_column);
  disparity_start_of_frame <= as_bit(winner2_tag_start_of_frame and winner2_tag_valid and winner2_tag_output_column);
  disparity_end_of_line <= as_bit(winner2_tag_end_of_line and winner2_tag_valid and winner2_tag_output_column);

  rows_memory_write_data <= rows_word(15 downto 0) & to_unsigned(rows_newest_right, 8) & to_unsigned(rows_newest_left, 8);
  rows_memory : entity work.line_memory
    generic map (depth => 32, width => 32)
    port map (
      clock => clock, read_enable => reference_tag_valid,
      read_address => reference_column, read_data => rows_word,
      write_address => rows_write_column, write_data => rows_memory_write_data);

  reference_memory_write_data <= to_unsigned(raster_right, 8);
  reference_memory : entity work.line_memory
    generic map (depth => 8, width => 8)
    port map (
      clock => clock, read_enable => true,
      read_address => reference_read_address, read_data => reference_right,
      write_address => reference_write_address, write_data => reference_memory_write_data);

  process (clock)
    variable raster_row_differs, raster_row_is_equal, raster_row_is_equal_2, raster_row_all : boolean;
    variable raster_row_is_equal_3, raster_next_frame_choice, reference_row_inside_1_is_less : boolean;
    variable reference_tag_cost_column_is_equal, reference_tag_cost_column_value : boolean;
    variable reference_tag_output_column_choice, winner1_cost_0_is_less, winner1_cost_0_is_less_2 : boolean;
    variable winner1_cost_0_is_less_3, winner1_cost_1_is_less, winner1_cost_1_is_less_2 : boolean;
    variable winner1_cost_1_is_less_3 : boolean;
    variable raster_row_choice : natural range 0 to 3;
    variable raster_row_choice_2, raster_row_choice_3 : natural range 0 to 15;
    variable winner1_cost_0_choice, winner1_cost_0_choice_2, winner1_cost_1_choice : natural range 0 to 2295;
    variable winner1_cost_1_choice_2 : natural range 0 to 2295;
    variable winner1_index_0_choice : natural range 0 to 2;
    variable winner1_index_1_choice : natural range 4 to 5;
    variable winner1_index_1_choice_2 : natural range 4 to 6;
  begin
    if rising_edge(clock) then
      -- raster
      raster_row_differs := raster_row /= 13;
      raster_row_is_equal := raster_row = 11;
      raster_row_is_equal_2 := raster_column = 31;
      raster_row_all := raster_row_differs and raster_row_is_equal and raster_row_is_equal_2;
      raster_row_choice := 3 when raster_row_all else 0;
      raster_row_is_equal_3 := raster_row = 12;
      raster_row_choice_2 := 1 when raster_next_frame and raster_row_is_equal_3 else (raster_row + 1) mod 16;
      raster_row_choice_3 := raster_row_choice_2 when raster_row_differs and raster_row_is_equal_2 and in_valid else
        raster_row;
      raster_left <= in_left_pixel;
      raster_right <= in_right_pixel;
      raster_valid <= in_valid;
      raster_row <= raster_row_choice * 4 when in_start_of_frame and in_valid else raster_row_choice_3;
      raster_next_frame_choice := raster_row_all when in_start_of_frame else raster_next_frame;
      if in_valid then
        raster_column <= 0 when raster_row_is_equal_2 or in_start_of_frame else (raster_column + 1) mod 32;
        raster_next_frame <= raster_row_differs and raster_row_is_equal and raster_row_is_equal_2 and in_start_of_frame
          when raster_row_is_equal_2 and raster_row_is_equal_3 else raster_next_frame_choice;
      end if;
      -- reference
      if raster_valid then
        reference_read_address <= 0 when reference_read_address = 7 else (reference_read_address + 1) mod 8;
        reference_write_address <= reference_read_address;
      end if;
      reference_row_inside_1_is_less := ((raster_row + 65535) mod 65536) < 12;
      reference_tag_cost_column_is_equal := (raster_column mod 4) = 3;
      reference_tag_cost_column_value := ((raster_column / 8) mod 2) = 1;
      reference_tag_output_column_choice := (raster_column / 4) = 0 when reference_tag_cost_column_is_equal else
        (raster_column / 8) = 0;
      reference_left <= raster_left;
      reference_column <= raster_column;
      reference_row_inside_0 <= (not ((raster_row / 8) = 1)) or (not (((raster_row / 4) mod 2) = 1));
      reference_row_inside_1 <= reference_row_inside_1_is_less;
      reference_row_inside_2 <= (((((raster_row / 2) + 32767) mod 32768) * 2) + (raster_row mod 2)) < 12;
      reference_tag_valid <= raster_valid;
      reference_tag_cost_column <= ((raster_column / 16) = 1) or reference_tag_cost_column_value or (((raster_column /
        4) mod 2) = 1) when reference_tag_cost_column_is_equal else ((raster_column / 16) = 1) or
        reference_tag_cost_column_value;
      reference_tag_output_column <= (raster_column /= 31) and (not reference_tag_output_column_choice) and
        reference_row_inside_1_is_less;
      reference_tag_start_of_frame <= (raster_column = 7) and (raster_row = 1);
      reference_tag_end_of_line <= raster_column = 30;
      -- rows
      if reference_tag_valid then
        rows_newest_left <= reference_left;
        rows_newest_right <= to_integer(reference_right);
        rows_write_column <= reference_column;
      end if;
      rows_inside_before_0 <= reference_row_inside_0;
      rows_inside_before_1 <= reference_row_inside_1;
      rows_inside_before_2 <= reference_row_inside_2;
      rows_tag_before_valid <= reference_tag_valid;
      rows_tag_before_cost_column <= reference_tag_cost_column;
      rows_tag_before_output_column <= reference_tag_output_column;
      rows_tag_before_start_of_frame <= reference_tag_start_of_frame;
      rows_tag_before_end_of_line <= reference_tag_end_of_line;
      rows_left_0 <= rows_newest_left when rows_inside_before_0 else 0;
      rows_left_1 <= to_integer(rows_word(7 downto 0)) when rows_inside_before_1 else 0;
      rows_left_2 <= to_integer(rows_word(23 downto 16)) when rows_inside_before_2 else 0;
      rows_right_0 <= rows_newest_right when rows_inside_before_0 else 0;
      rows_right_1 <= to_integer(rows_word(15 downto 8)) when rows_inside_before_1 else 0;
      rows_right_2 <= to_integer(rows_word(31 downto 24)) when rows_inside_before_2 else 0;
      rows_tag_valid <= rows_tag_before_valid;
      rows_tag_cost_column <= rows_tag_before_cost_column;
      rows_tag_output_column <= rows_tag_before_output_column;
      rows_tag_start_of_frame <= rows_tag_before_start_of_frame;
      rows_tag_end_of_line <= rows_tag_before_end_of_line;
      -- shift
      if rows_tag_valid then
        shift_left_0_0 <= shift_left_0_1;
        shift_left_0_1 <= shift_left_0_2;
        shift_left_0_2 <= shift_left_0_3;
        shift_left_0_3 <= shift_left_0_4;
        shift_left_0_4 <= shift_left_0_5;
        shift_left_0_5 <= shift_left_0_6;
        shift_left_0_6 <= shift_left_0_7;
        shift_left_0_7 <= rows_left_0;
        shift_left_1_0 <= shift_left_1_1;
        shift_left_1_1 <= shift_left_1_2;
        shift_left_1_2 <= shift_left_1_3;
        shift_left_1_3 <= shift_left_1_4;
        shift_left_1_4 <= shift_left_1_5;
        shift_left_1_5 <= shift_left_1_6;
        shift_left_1_6 <= shift_left_1_7;
        shift_left_1_7 <= rows_left_1;
        shift_left_2_0 <= shift_left_2_1;
        shift_left_2_1 <= shift_left_2_2;
        shift_left_2_2 <= shift_left_2_3;
        shift_left_2_3 <= shift_left_2_4;
        shift_left_2_4 <= shift_left_2_5;
        shift_left_2_5 <= shift_left_2_6;
        shift_left_2_6 <= shift_left_2_7;
        shift_left_2_7 <= rows_left_2;
      end if;
      shift_right_0 <= rows_right_0;
      shift_right_1 <= rows_right_1;
      shift_right_2 <= rows_right_2;
      shift_tag_valid <= rows_tag_valid;
      shift_tag_cost_column <= rows_tag_cost_column;
      shift_tag_output_column <= rows_tag_output_column;
      shift_tag_start_of_frame <= rows_tag_start_of_frame;
      shift_tag_end_of_line <= rows_tag_end_of_line;
      -- cost
      cost_difference_0_0 <= magnitude(shift_left_0_0 - shift_right_0);
      cost_difference_0_1 <= magnitude(shift_left_0_1 - shift_right_0);
      cost_difference_0_2 <= magnitude(shift_left_0_2 - shift_right_0);
      cost_difference_0_3 <= magnitude(shift_left_0_3 - shift_right_0);
      cost_difference_0_4 <= magnitude(shift_left_0_4 - shift_right_0);
      cost_difference_0_5 <= magnitude(shift_left_0_5 - shift_right_0);
      cost_difference_0_6 <= magnitude(shift_left_0_6 - shift_right_0);
      cost_difference_0_7 <= magnitude(shift_left_0_7 - shift_right_0);
      cost_difference_1_0 <= magnitude(shift_left_1_0 - shift_right_1);
      cost_difference_1_1 <= magnitude(shift_left_1_1 - shift_right_1);
      cost_difference_1_2 <= magnitude(shift_left_1_2 - shift_right_1);
      cost_difference_1_3 <= magnitude(shift_left_1_3 - shift_right_1);
      cost_difference_1_4 <= magnitude(shift_left_1_4 - shift_right_1);
      cost_difference_1_5 <= magnitude(shift_left_1_5 - shift_right_1);
      cost_difference_1_6 <= magnitude(shift_left_1_6 - shift_right_1);
      cost_difference_1_7 <= magnitude(shift_left_1_7 - shift_right_1);
      cost_difference_2_0 <= magnitude(shift_left_2_0 - shift_right_2);
      cost_difference_2_1 <= magnitude(shift_left_2_1 - shift_right_2);
      cost_difference_2_2 <= magnitude(shift_left_2_2 - shift_right_2);
      cost_difference_2_3 <= magnitude(shift_left_2_3 - shift_right_2);
      cost_difference_2_4 <= magnitude(shift_left_2_4 - shift_right_2);
      cost_difference_2_5 <= magnitude(shift_left_2_5 - shift_right_2);
      cost_difference_2_6 <= magnitude(shift_left_2_6 - shift_right_2);
      cost_difference_2_7 <= magnitude(shift_left_2_7 - shift_right_2);
      cost_tag_before_valid <= shift_tag_valid;
      cost_tag_before_cost_column <= shift_tag_cost_column;
      cost_tag_before_output_column <= shift_tag_output_column;
      cost_tag_before_start_of_frame <= shift_tag_start_of_frame;
      cost_tag_before_end_of_line <= shift_tag_end_of_line;
      cost_column_0 <= cost_difference_2_0 + cost_difference_0_0 + cost_difference_1_0 when cost_tag_before_cost_column
        else 0;
      cost_column_1 <= cost_difference_2_1 + cost_difference_0_1 + cost_difference_1_1 when cost_tag_before_cost_column
        else 0;
      cost_column_2 <= cost_difference_2_2 + cost_difference_0_2 + cost_difference_1_2 when cost_tag_before_cost_column
        else 0;
      cost_column_3 <= cost_difference_2_3 + cost_difference_0_3 + cost_difference_1_3 when cost_tag_before_cost_column
        else 0;
      cost_column_4 <= cost_difference_2_4 + cost_difference_0_4 + cost_difference_1_4 when cost_tag_before_cost_column
        else 0;
      cost_column_5 <= cost_difference_2_5 + cost_difference_0_5 + cost_difference_1_5 when cost_tag_before_cost_column
        else 0;
      cost_column_6 <= cost_difference_2_6 + cost_difference_0_6 + cost_difference_1_6 when cost_tag_before_cost_column
        else 0;
      cost_column_7 <= cost_difference_2_7 + cost_difference_0_7 + cost_difference_1_7 when cost_tag_before_cost_column
        else 0;
      cost_tag_valid <= cost_tag_before_valid;
      cost_tag_output_column <= cost_tag_before_output_column;
      cost_tag_start_of_frame <= cost_tag_before_start_of_frame;
      cost_tag_end_of_line <= cost_tag_before_end_of_line;
      -- window
      if cost_tag_valid then
        window_history_0_0 <= cost_column_0;
        window_history_0_1 <= cost_column_1;
        window_history_0_2 <= cost_column_2;
        window_history_0_3 <= cost_column_3;
        window_history_0_4 <= cost_column_4;
        window_history_0_5 <= cost_column_5;
        window_history_0_6 <= cost_column_6;
        window_history_0_7 <= cost_column_7;
        window_history_1_0 <= window_history_0_0;
        window_history_1_1 <= window_history_0_1;
        window_history_1_2 <= window_history_0_2;
        window_history_1_3 <= window_history_0_3;
        window_history_1_4 <= window_history_0_4;
        window_history_1_5 <= window_history_0_5;
        window_history_1_6 <= window_history_0_6;
        window_history_1_7 <= window_history_0_7;
        window_centre_0_output_column <= cost_tag_output_column;
        window_centre_0_start_of_frame <= cost_tag_start_of_frame;
        window_centre_0_end_of_line <= cost_tag_end_of_line;
      end if;
      window_sum_0 <= window_history_1_0 + cost_column_0 + window_history_0_0;
      window_sum_1 <= window_history_1_1 + cost_column_1 + window_history_0_1;
      window_sum_2 <= window_history_1_2 + cost_column_2 + window_history_0_2;
      window_sum_3 <= window_history_1_3 + cost_column_3 + window_history_0_3;
      window_sum_4 <= window_history_1_4 + cost_column_4 + window_history_0_4;
      window_sum_5 <= window_history_1_5 + cost_column_5 + window_history_0_5;
      window_sum_6 <= window_history_1_6 + cost_column_6 + window_history_0_6;
      window_sum_7 <= window_history_1_7 + cost_column_7 + window_history_0_7;
      window_tag_valid <= cost_tag_valid;
      window_tag_output_column <= window_centre_0_output_column;
      window_tag_start_of_frame <= window_centre_0_start_of_frame;
      window_tag_end_of_line <= window_centre_0_end_of_line;
      -- winner1
      winner1_cost_0_is_less := window_sum_1 < window_sum_0;
      winner1_cost_0_choice := window_sum_1 when winner1_cost_0_is_less else window_sum_0;
      winner1_cost_0_is_less_2 := window_sum_2 < winner1_cost_0_choice;
      winner1_cost_0_choice_2 := window_sum_2 when winner1_cost_0_is_less_2 else winner1_cost_0_choice;
      winner1_cost_0_is_less_3 := window_sum_3 < winner1_cost_0_choice_2;
      winner1_cost_1_is_less := window_sum_5 < window_sum_4;
      winner1_cost_1_choice := window_sum_5 when winner1_cost_1_is_less else window_sum_4;
      winner1_cost_1_is_less_2 := window_sum_6 < winner1_cost_1_choice;
      winner1_cost_1_choice_2 := window_sum_6 when winner1_cost_1_is_less_2 else winner1_cost_1_choice;
      winner1_cost_1_is_less_3 := window_sum_7 < winner1_cost_1_choice_2;
      winner1_index_0_choice := 2 when winner1_cost_0_is_less_2 else as_number(winner1_cost_0_is_less);
      winner1_index_1_choice := 5 when winner1_cost_1_is_less else 4;
      winner1_index_1_choice_2 := 6 when winner1_cost_1_is_less_2 else winner1_index_1_choice;
      winner1_cost_0 <= window_sum_3 when winner1_cost_0_is_less_3 else winner1_cost_0_choice_2;
      winner1_cost_1 <= window_sum_7 when winner1_cost_1_is_less_3 else winner1_cost_1_choice_2;
      winner1_index_0 <= 3 when winner1_cost_0_is_less_3 else winner1_index_0_choice;
      winner1_index_1 <= 7 when winner1_cost_1_is_less_3 else winner1_index_1_choice_2;
      winner1_tag_valid <= window_tag_valid;
      winner1_tag_output_column <= window_tag_output_column;
      winner1_tag_start_of_frame <= window_tag_start_of_frame;
      winner1_tag_end_of_line <= window_tag_end_of_line;
      -- winner2
      winner2_index_0 <= winner1_index_1 when winner1_cost_1 < winner1_cost_0 else winner1_index_0;
      winner2_tag_valid <= winner1_tag_valid;
      winner2_tag_output_column <= winner1_tag_output_column;
      winner2_tag_start_of_frame <= winner1_tag_start_of_frame;
      winner2_tag_end_of_line <= winner1_tag_end_of_line;
      if reset = '1' then
        raster_valid <= false;
        raster_column <= 0;
        raster_row <= 13;
        raster_next_frame <= false;
        reference_read_address <= 1;
        reference_write_address <= 0;
        reference_column <= 0;
        reference_tag_valid <= false;
        reference_tag_output_column <= false;
        reference_tag_start_of_frame <= false;
        reference_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_before_valid <= false;
        rows_tag_before_output_column <= false;
        rows_tag_before_start_of_frame <= false;
        rows_tag_before_end_of_line <= false;
        rows_tag_valid <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        shift_tag_valid <= false;
        shift_tag_output_column <= false;
        shift_tag_start_of_frame <= false;
        shift_tag_end_of_line <= false;
        cost_tag_before_valid <= false;
        cost_tag_before_output_column <= false;
        cost_tag_before_start_of_frame <= false;
        cost_tag_before_end_of_line <= false;
        cost_tag_valid <= false;
        cost_tag_output_column <= false;
        cost_tag_start_of_frame <= false;
        cost_tag_end_of_line <= false;
        window_centre_0_output_column <= false;
        window_centre_0_start_of_frame <= false;
        window_centre_0_end_of_line <= false;
        window_tag_valid <= false;
        window_tag_output_column <= false;
        window_tag_start_of_frame <= false;
        window_tag_end_of_line <= false;
        winner1_tag_valid <= false;
        winner1_tag_output_column <= false;
        winner1_tag_start_of_frame <= false;
        winner1_tag_end_of_line <= false;
        winner2_tag_valid <= false;
        winner2_tag_output_column <= false;
        winner2_tag_start_of_frame <= false;
        winner2_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
