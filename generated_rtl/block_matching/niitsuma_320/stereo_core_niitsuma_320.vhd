-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration niitsuma_320: 320x240, 121 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 121, window_px 7, aggregation recursive.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config niitsuma_320
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_niitsuma_320 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 121;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 199;
    latency_clocks : positive := 23;
    flush_groups : positive := 962;
    gap_groups : positive := 960
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
  assert width_px = 320 report "stereo_core_niitsuma_320: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_niitsuma_320: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 121 report "stereo_core_niitsuma_320: disparities is " & integer'image(disparities) & " but this core has 121" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_niitsuma_320: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_niitsuma_320: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 199 report "stereo_core_niitsuma_320: output_width_px is " & integer'image(output_width_px) & " but this core has 199" severity failure;
  assert latency_clocks = 23 report "stereo_core_niitsuma_320: latency_clocks is " & integer'image(latency_clocks) & " but this core has 23" severity failure;
  assert flush_groups = 962 report "stereo_core_niitsuma_320: flush_groups is " & integer'image(flush_groups) & " but this core has 962" severity failure;
  assert gap_groups = 960 report "stereo_core_niitsuma_320: gap_groups is " & integer'image(gap_groups) & " but this core has 960" severity failure;
end entity;

architecture rtl of stereo_core_niitsuma_320 is
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
  signal raster_features_search_0, raster_features_reference_0, raster_place_group : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 127;
  signal delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_border_column, delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_write_words_0, rows_reference_rows_read_words_0 : unsigned(31 downto 0);
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 255;
  signal rows_search_rows_ready_words_1, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_1, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_row_start : boolean;
  signal rows_read_tag_first_group, rows_read_tag_border_column, rows_read_tag_first_cost : boolean;
  signal rows_read_tag_leaves_window, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_tag_valid : boolean;
  signal rows_ready_tag_row_start, rows_ready_tag_first_group, rows_ready_tag_border_column : boolean;
  signal rows_ready_tag_first_cost, rows_ready_tag_leaves_window, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_row_start : boolean;
  signal rows_tag_first_group, rows_tag_border_column, rows_tag_first_cost, rows_tag_leaves_window : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 255;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_0_8 : natural range 0 to 255;
  signal slice0shift_search_0_9, slice0shift_search_0_10, slice0shift_search_0_11 : natural range 0 to 255;
  signal slice0shift_search_0_12, slice0shift_search_0_13, slice0shift_search_0_14 : natural range 0 to 255;
  signal slice0shift_search_0_15, slice0shift_search_0_16, slice0shift_search_0_17 : natural range 0 to 255;
  signal slice0shift_search_0_18, slice0shift_search_0_19, slice0shift_search_0_20 : natural range 0 to 255;
  signal slice0shift_search_0_21, slice0shift_search_0_22, slice0shift_search_0_23 : natural range 0 to 255;
  signal slice0shift_search_0_24, slice0shift_search_1_0, slice0shift_search_1_1 : natural range 0 to 255;
  signal slice0shift_search_1_2, slice0shift_search_1_3, slice0shift_search_1_4 : natural range 0 to 255;
  signal slice0shift_search_1_5, slice0shift_search_1_6, slice0shift_search_1_7 : natural range 0 to 255;
  signal slice0shift_search_1_8, slice0shift_search_1_9, slice0shift_search_1_10 : natural range 0 to 255;
  signal slice0shift_search_1_11, slice0shift_search_1_12, slice0shift_search_1_13 : natural range 0 to 255;
  signal slice0shift_search_1_14, slice0shift_search_1_15, slice0shift_search_1_16 : natural range 0 to 255;
  signal slice0shift_search_1_17, slice0shift_search_1_18, slice0shift_search_1_19 : natural range 0 to 255;
  signal slice0shift_search_1_20, slice0shift_search_1_21, slice0shift_search_1_22 : natural range 0 to 255;
  signal slice0shift_search_1_23, slice0shift_search_1_24, slice0shift_reference_0 : natural range 0 to 255;
  signal slice0shift_reference_1, slice0shift_search_out_0, slice0shift_search_out_1 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_2, slice0cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_6, slice0cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_8, slice0cost_pixels_first_0_9 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_10, slice0cost_pixels_first_0_11 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_12, slice0cost_pixels_first_0_13 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_14, slice0cost_pixels_first_0_15 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_16, slice0cost_pixels_first_0_17 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_18, slice0cost_pixels_first_0_19 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_20, slice0cost_pixels_first_0_21 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_22, slice0cost_pixels_first_0_23 : integer range -255 to 255;
  signal slice0cost_pixels_first_0_24, slice0cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_1, slice0cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_3, slice0cost_pixels_first_1_4 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_5, slice0cost_pixels_first_1_6 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_7, slice0cost_pixels_first_1_8 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_9, slice0cost_pixels_first_1_10 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_11, slice0cost_pixels_first_1_12 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_13, slice0cost_pixels_first_1_14 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_15, slice0cost_pixels_first_1_16 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_17, slice0cost_pixels_first_1_18 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_19, slice0cost_pixels_first_1_20 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_21, slice0cost_pixels_first_1_22 : integer range -255 to 255;
  signal slice0cost_pixels_first_1_23, slice0cost_pixels_first_1_24, slice0cost_change_0_0 : integer range -255 to 255;
  signal slice0cost_change_0_1, slice0cost_change_0_2, slice0cost_change_0_3 : integer range -255 to 255;
  signal slice0cost_change_0_4, slice0cost_change_0_5, slice0cost_change_0_6 : integer range -255 to 255;
  signal slice0cost_change_0_7, slice0cost_change_0_8, slice0cost_change_0_9 : integer range -255 to 255;
  signal slice0cost_change_0_10, slice0cost_change_0_11, slice0cost_change_0_12 : integer range -255 to 255;
  signal slice0cost_change_0_13, slice0cost_change_0_14, slice0cost_change_0_15 : integer range -255 to 255;
  signal slice0cost_change_0_16, slice0cost_change_0_17, slice0cost_change_0_18 : integer range -255 to 255;
  signal slice0cost_change_0_19, slice0cost_change_0_20, slice0cost_change_0_21 : integer range -255 to 255;
  signal slice0cost_change_0_22, slice0cost_change_0_23, slice0cost_change_0_24 : integer range -255 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_row_start, slice0cost_ready_tag_first_group, slice0cost_ready_tag_border_column : boolean;
  signal slice0cost_ready_tag_first_cost, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_output_column, slice0cost_ready_tag_start_of_frame : boolean;
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_row_start : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_0_8 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_9, slice0cost_pixels_cost_0_10, slice0cost_pixels_cost_0_11 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_12, slice0cost_pixels_cost_0_13, slice0cost_pixels_cost_0_14 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_15, slice0cost_pixels_cost_0_16, slice0cost_pixels_cost_0_17 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_18, slice0cost_pixels_cost_0_19, slice0cost_pixels_cost_0_20 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_21, slice0cost_pixels_cost_0_22, slice0cost_pixels_cost_0_23 : natural range 0 to 255;
  signal slice0cost_pixels_cost_0_24, slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_2, slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_5, slice0cost_pixels_cost_1_6, slice0cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_8, slice0cost_pixels_cost_1_9, slice0cost_pixels_cost_1_10 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_11, slice0cost_pixels_cost_1_12, slice0cost_pixels_cost_1_13 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_14, slice0cost_pixels_cost_1_15, slice0cost_pixels_cost_1_16 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_17, slice0cost_pixels_cost_1_18, slice0cost_pixels_cost_1_19 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_20, slice0cost_pixels_cost_1_21, slice0cost_pixels_cost_1_22 : natural range 0 to 255;
  signal slice0cost_pixels_cost_1_23, slice0cost_pixels_cost_1_24 : natural range 0 to 255;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(21 downto 0);
  signal slice0cost_read_words_3, slice0cost_read_words_4, slice0cost_read_words_5 : unsigned(21 downto 0);
  signal slice0cost_read_words_6, slice0cost_read_words_7, slice0cost_read_words_8 : unsigned(21 downto 0);
  signal slice0cost_read_words_9, slice0cost_read_words_10, slice0cost_read_words_11 : unsigned(21 downto 0);
  signal slice0cost_read_words_12 : unsigned(10 downto 0);
  signal slice0cost_ready_words_0, slice0cost_ready_words_1, slice0cost_ready_words_2 : natural range 0 to 4194303;
  signal slice0cost_ready_words_3, slice0cost_ready_words_4, slice0cost_ready_words_5 : natural range 0 to 4194303;
  signal slice0cost_ready_words_6, slice0cost_ready_words_7, slice0cost_ready_words_8 : natural range 0 to 4194303;
  signal slice0cost_ready_words_9, slice0cost_ready_words_10, slice0cost_ready_words_11 : natural range 0 to 4194303;
  signal slice0cost_write_words_0, slice0cost_write_words_1, slice0cost_write_words_2 : natural range 0 to 4194303;
  signal slice0cost_write_words_3, slice0cost_write_words_4, slice0cost_write_words_5 : natural range 0 to 4194303;
  signal slice0cost_write_words_6, slice0cost_write_words_7, slice0cost_write_words_8 : natural range 0 to 4194303;
  signal slice0cost_write_words_9, slice0cost_write_words_10, slice0cost_write_words_11 : natural range 0 to 4194303;
  signal slice0cost_ready_words_12, slice0cost_column_0_0, slice0cost_column_0_1 : natural range 0 to 2047;
  signal slice0cost_column_0_2, slice0cost_column_0_3, slice0cost_column_0_4 : natural range 0 to 2047;
  signal slice0cost_column_0_5, slice0cost_column_0_6, slice0cost_column_0_7 : natural range 0 to 2047;
  signal slice0cost_column_0_8, slice0cost_column_0_9, slice0cost_column_0_10 : natural range 0 to 2047;
  signal slice0cost_column_0_11, slice0cost_column_0_12, slice0cost_column_0_13 : natural range 0 to 2047;
  signal slice0cost_column_0_14, slice0cost_column_0_15, slice0cost_column_0_16 : natural range 0 to 2047;
  signal slice0cost_column_0_17, slice0cost_column_0_18, slice0cost_column_0_19 : natural range 0 to 2047;
  signal slice0cost_column_0_20, slice0cost_column_0_21, slice0cost_column_0_22 : natural range 0 to 2047;
  signal slice0cost_column_0_23, slice0cost_column_0_24, slice0cost_write_words_12 : natural range 0 to 2047;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(21 downto 0);
  signal slice0window_leaving_3, slice0window_leaving_4, slice0window_leaving_5 : unsigned(21 downto 0);
  signal slice0window_leaving_6, slice0window_leaving_7, slice0window_leaving_8 : unsigned(21 downto 0);
  signal slice0window_leaving_9, slice0window_leaving_10, slice0window_leaving_11 : unsigned(21 downto 0);
  signal slice0window_leaving_12 : unsigned(10 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 2047;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 2047;
  signal slice0window_entering_0_6, slice0window_entering_0_7, slice0window_entering_0_8 : natural range 0 to 2047;
  signal slice0window_entering_0_9, slice0window_entering_0_10, slice0window_entering_0_11 : natural range 0 to 2047;
  signal slice0window_entering_0_12, slice0window_entering_0_13, slice0window_entering_0_14 : natural range 0 to 2047;
  signal slice0window_entering_0_15, slice0window_entering_0_16, slice0window_entering_0_17 : natural range 0 to 2047;
  signal slice0window_entering_0_18, slice0window_entering_0_19, slice0window_entering_0_20 : natural range 0 to 2047;
  signal slice0window_entering_0_21, slice0window_entering_0_22, slice0window_entering_0_23 : natural range 0 to 2047;
  signal slice0window_entering_0_24 : natural range 0 to 2047;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_group : boolean;
  signal slice0window_entering_tag_border_column, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_group : boolean;
  signal slice0window_change_tag_border_column, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_1 : boolean;
  signal slice0window_centre_start_of_frame_2, slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_tag_start_of_frame : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -2047 to 2047;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -2047 to 2047;
  signal slice0window_change_0_6, slice0window_change_0_7, slice0window_change_0_8 : integer range -2047 to 2047;
  signal slice0window_change_0_9, slice0window_change_0_10, slice0window_change_0_11 : integer range -2047 to 2047;
  signal slice0window_change_0_12, slice0window_change_0_13, slice0window_change_0_14 : integer range -2047 to 2047;
  signal slice0window_change_0_15, slice0window_change_0_16, slice0window_change_0_17 : integer range -2047 to 2047;
  signal slice0window_change_0_18, slice0window_change_0_19, slice0window_change_0_20 : integer range -2047 to 2047;
  signal slice0window_change_0_21, slice0window_change_0_22, slice0window_change_0_23 : integer range -2047 to 2047;
  signal slice0window_change_0_24 : integer range -2047 to 2047;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 16383;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 16383;
  signal slice0window_sum_0_6, slice0window_sum_0_7, slice0window_sum_0_8 : natural range 0 to 16383;
  signal slice0window_sum_0_9, slice0window_sum_0_10, slice0window_sum_0_11 : natural range 0 to 16383;
  signal slice0window_sum_0_12, slice0window_sum_0_13, slice0window_sum_0_14 : natural range 0 to 16383;
  signal slice0window_sum_0_15, slice0window_sum_0_16, slice0window_sum_0_17 : natural range 0 to 16383;
  signal slice0window_sum_0_18, slice0window_sum_0_19, slice0window_sum_0_20 : natural range 0 to 16383;
  signal slice0window_sum_0_21, slice0window_sum_0_22, slice0window_sum_0_23 : natural range 0 to 16383;
  signal slice0window_sum_0_24 : natural range 0 to 16383;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_4, slice0winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_6, slice0winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_8, slice0winner1_best_cost_0_9 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_10, slice0winner1_best_cost_0_11 : natural range 0 to 16383;
  signal slice0winner1_best_cost_0_12 : natural range 0 to 16383;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7 : natural range 0 to 15;
  signal slice0winner1_best_index_0_8 : natural range 0 to 17;
  signal slice0winner1_best_index_0_9 : natural range 0 to 19;
  signal slice0winner1_best_index_0_10 : natural range 0 to 21;
  signal slice0winner1_best_index_0_11 : natural range 0 to 23;
  signal slice0winner1_best_index_0_12 : natural range 0 to 24;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner2_best_cost_0_2, slice0winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice0winner2_best_cost_0_4, slice0winner2_best_cost_0_5 : natural range 0 to 16383;
  signal slice0winner2_best_cost_0_6 : natural range 0 to 16383;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3 : natural range 0 to 15;
  signal slice0winner2_best_index_0_4 : natural range 0 to 19;
  signal slice0winner2_best_index_0_5 : natural range 0 to 23;
  signal slice0winner2_best_index_0_6 : natural range 0 to 24;
  signal slice0winner2_tag_valid, slice0winner2_tag_start_of_frame : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner3_best_cost_0_2, slice0winner3_best_cost_0_3 : natural range 0 to 16383;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 15;
  signal slice0winner3_best_index_0_2 : natural range 0 to 23;
  signal slice0winner3_best_index_0_3 : natural range 0 to 24;
  signal slice0winner3_tag_valid, slice0winner3_tag_output_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_cost_0_1 : natural range 0 to 16383;
  signal slice0winner4_best_index_0_0 : natural range 0 to 15;
  signal slice0winner4_best_index_0_1 : natural range 0 to 24;
  signal slice0winner4_tag_valid, slice0winner4_tag_output_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag_valid, slice0winner5_tag_output_column, slice0winner5_tag_start_of_frame : boolean;
  signal slice0winner5_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 16383;
  signal slice0_best_index_0_0 : natural range 0 to 120;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 255;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_0_8 : natural range 0 to 255;
  signal slice1shift_search_0_9, slice1shift_search_0_10, slice1shift_search_0_11 : natural range 0 to 255;
  signal slice1shift_search_0_12, slice1shift_search_0_13, slice1shift_search_0_14 : natural range 0 to 255;
  signal slice1shift_search_0_15, slice1shift_search_0_16, slice1shift_search_0_17 : natural range 0 to 255;
  signal slice1shift_search_0_18, slice1shift_search_0_19, slice1shift_search_0_20 : natural range 0 to 255;
  signal slice1shift_search_0_21, slice1shift_search_0_22, slice1shift_search_0_23 : natural range 0 to 255;
  signal slice1shift_search_0_24, slice1shift_search_1_0, slice1shift_search_1_1 : natural range 0 to 255;
  signal slice1shift_search_1_2, slice1shift_search_1_3, slice1shift_search_1_4 : natural range 0 to 255;
  signal slice1shift_search_1_5, slice1shift_search_1_6, slice1shift_search_1_7 : natural range 0 to 255;
  signal slice1shift_search_1_8, slice1shift_search_1_9, slice1shift_search_1_10 : natural range 0 to 255;
  signal slice1shift_search_1_11, slice1shift_search_1_12, slice1shift_search_1_13 : natural range 0 to 255;
  signal slice1shift_search_1_14, slice1shift_search_1_15, slice1shift_search_1_16 : natural range 0 to 255;
  signal slice1shift_search_1_17, slice1shift_search_1_18, slice1shift_search_1_19 : natural range 0 to 255;
  signal slice1shift_search_1_20, slice1shift_search_1_21, slice1shift_search_1_22 : natural range 0 to 255;
  signal slice1shift_search_1_23, slice1shift_search_1_24, slice1shift_reference_0 : natural range 0 to 255;
  signal slice1shift_reference_1, slice1shift_search_out_0, slice1shift_search_out_1 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_2, slice1cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_6, slice1cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_8, slice1cost_pixels_first_0_9 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_10, slice1cost_pixels_first_0_11 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_12, slice1cost_pixels_first_0_13 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_14, slice1cost_pixels_first_0_15 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_16, slice1cost_pixels_first_0_17 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_18, slice1cost_pixels_first_0_19 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_20, slice1cost_pixels_first_0_21 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_22, slice1cost_pixels_first_0_23 : integer range -255 to 255;
  signal slice1cost_pixels_first_0_24, slice1cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_1, slice1cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_3, slice1cost_pixels_first_1_4 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_5, slice1cost_pixels_first_1_6 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_7, slice1cost_pixels_first_1_8 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_9, slice1cost_pixels_first_1_10 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_11, slice1cost_pixels_first_1_12 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_13, slice1cost_pixels_first_1_14 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_15, slice1cost_pixels_first_1_16 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_17, slice1cost_pixels_first_1_18 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_19, slice1cost_pixels_first_1_20 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_21, slice1cost_pixels_first_1_22 : integer range -255 to 255;
  signal slice1cost_pixels_first_1_23, slice1cost_pixels_first_1_24, slice1cost_change_0_0 : integer range -255 to 255;
  signal slice1cost_change_0_1, slice1cost_change_0_2, slice1cost_change_0_3 : integer range -255 to 255;
  signal slice1cost_change_0_4, slice1cost_change_0_5, slice1cost_change_0_6 : integer range -255 to 255;
  signal slice1cost_change_0_7, slice1cost_change_0_8, slice1cost_change_0_9 : integer range -255 to 255;
  signal slice1cost_change_0_10, slice1cost_change_0_11, slice1cost_change_0_12 : integer range -255 to 255;
  signal slice1cost_change_0_13, slice1cost_change_0_14, slice1cost_change_0_15 : integer range -255 to 255;
  signal slice1cost_change_0_16, slice1cost_change_0_17, slice1cost_change_0_18 : integer range -255 to 255;
  signal slice1cost_change_0_19, slice1cost_change_0_20, slice1cost_change_0_21 : integer range -255 to 255;
  signal slice1cost_change_0_22, slice1cost_change_0_23, slice1cost_change_0_24 : integer range -255 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_6, slice1cost_pixels_cost_0_7, slice1cost_pixels_cost_0_8 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_9, slice1cost_pixels_cost_0_10, slice1cost_pixels_cost_0_11 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_12, slice1cost_pixels_cost_0_13, slice1cost_pixels_cost_0_14 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_15, slice1cost_pixels_cost_0_16, slice1cost_pixels_cost_0_17 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_18, slice1cost_pixels_cost_0_19, slice1cost_pixels_cost_0_20 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_21, slice1cost_pixels_cost_0_22, slice1cost_pixels_cost_0_23 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_24, slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_2, slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_5, slice1cost_pixels_cost_1_6, slice1cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_8, slice1cost_pixels_cost_1_9, slice1cost_pixels_cost_1_10 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_11, slice1cost_pixels_cost_1_12, slice1cost_pixels_cost_1_13 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_14, slice1cost_pixels_cost_1_15, slice1cost_pixels_cost_1_16 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_17, slice1cost_pixels_cost_1_18, slice1cost_pixels_cost_1_19 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_20, slice1cost_pixels_cost_1_21, slice1cost_pixels_cost_1_22 : natural range 0 to 255;
  signal slice1cost_pixels_cost_1_23, slice1cost_pixels_cost_1_24 : natural range 0 to 255;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words_0, slice1cost_read_words_1, slice1cost_read_words_2 : unsigned(21 downto 0);
  signal slice1cost_read_words_3, slice1cost_read_words_4, slice1cost_read_words_5 : unsigned(21 downto 0);
  signal slice1cost_read_words_6, slice1cost_read_words_7, slice1cost_read_words_8 : unsigned(21 downto 0);
  signal slice1cost_read_words_9, slice1cost_read_words_10, slice1cost_read_words_11 : unsigned(21 downto 0);
  signal slice1cost_read_words_12 : unsigned(10 downto 0);
  signal slice1cost_ready_words_0, slice1cost_ready_words_1, slice1cost_ready_words_2 : natural range 0 to 4194303;
  signal slice1cost_ready_words_3, slice1cost_ready_words_4, slice1cost_ready_words_5 : natural range 0 to 4194303;
  signal slice1cost_ready_words_6, slice1cost_ready_words_7, slice1cost_ready_words_8 : natural range 0 to 4194303;
  signal slice1cost_ready_words_9, slice1cost_ready_words_10, slice1cost_ready_words_11 : natural range 0 to 4194303;
  signal slice1cost_write_words_0, slice1cost_write_words_1, slice1cost_write_words_2 : natural range 0 to 4194303;
  signal slice1cost_write_words_3, slice1cost_write_words_4, slice1cost_write_words_5 : natural range 0 to 4194303;
  signal slice1cost_write_words_6, slice1cost_write_words_7, slice1cost_write_words_8 : natural range 0 to 4194303;
  signal slice1cost_write_words_9, slice1cost_write_words_10, slice1cost_write_words_11 : natural range 0 to 4194303;
  signal slice1cost_ready_words_12, slice1cost_column_0_0, slice1cost_column_0_1 : natural range 0 to 2047;
  signal slice1cost_column_0_2, slice1cost_column_0_3, slice1cost_column_0_4 : natural range 0 to 2047;
  signal slice1cost_column_0_5, slice1cost_column_0_6, slice1cost_column_0_7 : natural range 0 to 2047;
  signal slice1cost_column_0_8, slice1cost_column_0_9, slice1cost_column_0_10 : natural range 0 to 2047;
  signal slice1cost_column_0_11, slice1cost_column_0_12, slice1cost_column_0_13 : natural range 0 to 2047;
  signal slice1cost_column_0_14, slice1cost_column_0_15, slice1cost_column_0_16 : natural range 0 to 2047;
  signal slice1cost_column_0_17, slice1cost_column_0_18, slice1cost_column_0_19 : natural range 0 to 2047;
  signal slice1cost_column_0_20, slice1cost_column_0_21, slice1cost_column_0_22 : natural range 0 to 2047;
  signal slice1cost_column_0_23, slice1cost_column_0_24, slice1cost_write_words_12 : natural range 0 to 2047;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(21 downto 0);
  signal slice1window_leaving_3, slice1window_leaving_4, slice1window_leaving_5 : unsigned(21 downto 0);
  signal slice1window_leaving_6, slice1window_leaving_7, slice1window_leaving_8 : unsigned(21 downto 0);
  signal slice1window_leaving_9, slice1window_leaving_10, slice1window_leaving_11 : unsigned(21 downto 0);
  signal slice1window_leaving_12 : unsigned(10 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 2047;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 2047;
  signal slice1window_entering_0_6, slice1window_entering_0_7, slice1window_entering_0_8 : natural range 0 to 2047;
  signal slice1window_entering_0_9, slice1window_entering_0_10, slice1window_entering_0_11 : natural range 0 to 2047;
  signal slice1window_entering_0_12, slice1window_entering_0_13, slice1window_entering_0_14 : natural range 0 to 2047;
  signal slice1window_entering_0_15, slice1window_entering_0_16, slice1window_entering_0_17 : natural range 0 to 2047;
  signal slice1window_entering_0_18, slice1window_entering_0_19, slice1window_entering_0_20 : natural range 0 to 2047;
  signal slice1window_entering_0_21, slice1window_entering_0_22, slice1window_entering_0_23 : natural range 0 to 2047;
  signal slice1window_entering_0_24 : natural range 0 to 2047;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -2047 to 2047;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -2047 to 2047;
  signal slice1window_change_0_6, slice1window_change_0_7, slice1window_change_0_8 : integer range -2047 to 2047;
  signal slice1window_change_0_9, slice1window_change_0_10, slice1window_change_0_11 : integer range -2047 to 2047;
  signal slice1window_change_0_12, slice1window_change_0_13, slice1window_change_0_14 : integer range -2047 to 2047;
  signal slice1window_change_0_15, slice1window_change_0_16, slice1window_change_0_17 : integer range -2047 to 2047;
  signal slice1window_change_0_18, slice1window_change_0_19, slice1window_change_0_20 : integer range -2047 to 2047;
  signal slice1window_change_0_21, slice1window_change_0_22, slice1window_change_0_23 : integer range -2047 to 2047;
  signal slice1window_change_0_24 : integer range -2047 to 2047;
  signal slice1window_change_tag_first_group, slice1window_change_tag_border_column : boolean;
  signal slice1window_change_tag_leaves_window, slice1window_centre_output_column_0 : boolean;
  signal slice1window_centre_first_column_0, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 16383;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 16383;
  signal slice1window_sum_0_6, slice1window_sum_0_7, slice1window_sum_0_8 : natural range 0 to 16383;
  signal slice1window_sum_0_9, slice1window_sum_0_10, slice1window_sum_0_11 : natural range 0 to 16383;
  signal slice1window_sum_0_12, slice1window_sum_0_13, slice1window_sum_0_14 : natural range 0 to 16383;
  signal slice1window_sum_0_15, slice1window_sum_0_16, slice1window_sum_0_17 : natural range 0 to 16383;
  signal slice1window_sum_0_18, slice1window_sum_0_19, slice1window_sum_0_20 : natural range 0 to 16383;
  signal slice1window_sum_0_21, slice1window_sum_0_22, slice1window_sum_0_23 : natural range 0 to 16383;
  signal slice1window_sum_0_24 : natural range 0 to 16383;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_2, slice1winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_4, slice1winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_6, slice1winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_8, slice1winner1_best_cost_0_9 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_10, slice1winner1_best_cost_0_11 : natural range 0 to 16383;
  signal slice1winner1_best_cost_0_12 : natural range 0 to 16383;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  signal slice1winner1_best_index_0_6 : natural range 0 to 13;
  signal slice1winner1_best_index_0_7 : natural range 0 to 15;
  signal slice1winner1_best_index_0_8 : natural range 0 to 17;
  signal slice1winner1_best_index_0_9 : natural range 0 to 19;
  signal slice1winner1_best_index_0_10 : natural range 0 to 21;
  signal slice1winner1_best_index_0_11 : natural range 0 to 23;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner2_best_cost_0_2, slice1winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice1winner2_best_cost_0_4, slice1winner2_best_cost_0_5 : natural range 0 to 16383;
  signal slice1winner2_best_cost_0_6 : natural range 0 to 16383;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  signal slice1winner2_best_index_0_3 : natural range 0 to 15;
  signal slice1winner2_best_index_0_4 : natural range 0 to 19;
  signal slice1winner2_best_index_0_5 : natural range 0 to 23;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner3_best_cost_0_2, slice1winner3_best_cost_0_3 : natural range 0 to 16383;
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 15;
  signal slice1winner3_best_index_0_2 : natural range 0 to 23;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_cost_0_1 : natural range 0 to 16383;
  signal slice1winner4_best_index_0_0 : natural range 0 to 15;
  signal slice1winner4_best_index_0_1 : natural range 0 to 24;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner5_best_index_0_0 : natural range 0 to 24;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 120;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- slice2shift
  signal slice2shift_search_0_0, slice2shift_search_0_1, slice2shift_search_0_2 : natural range 0 to 255;
  signal slice2shift_search_0_3, slice2shift_search_0_4, slice2shift_search_0_5 : natural range 0 to 255;
  signal slice2shift_search_0_6, slice2shift_search_0_7, slice2shift_search_0_8 : natural range 0 to 255;
  signal slice2shift_search_0_9, slice2shift_search_0_10, slice2shift_search_0_11 : natural range 0 to 255;
  signal slice2shift_search_0_12, slice2shift_search_0_13, slice2shift_search_0_14 : natural range 0 to 255;
  signal slice2shift_search_0_15, slice2shift_search_0_16, slice2shift_search_0_17 : natural range 0 to 255;
  signal slice2shift_search_0_18, slice2shift_search_0_19, slice2shift_search_0_20 : natural range 0 to 255;
  signal slice2shift_search_0_21, slice2shift_search_0_22, slice2shift_search_0_23 : natural range 0 to 255;
  signal slice2shift_search_0_24, slice2shift_search_1_0, slice2shift_search_1_1 : natural range 0 to 255;
  signal slice2shift_search_1_2, slice2shift_search_1_3, slice2shift_search_1_4 : natural range 0 to 255;
  signal slice2shift_search_1_5, slice2shift_search_1_6, slice2shift_search_1_7 : natural range 0 to 255;
  signal slice2shift_search_1_8, slice2shift_search_1_9, slice2shift_search_1_10 : natural range 0 to 255;
  signal slice2shift_search_1_11, slice2shift_search_1_12, slice2shift_search_1_13 : natural range 0 to 255;
  signal slice2shift_search_1_14, slice2shift_search_1_15, slice2shift_search_1_16 : natural range 0 to 255;
  signal slice2shift_search_1_17, slice2shift_search_1_18, slice2shift_search_1_19 : natural range 0 to 255;
  signal slice2shift_search_1_20, slice2shift_search_1_21, slice2shift_search_1_22 : natural range 0 to 255;
  signal slice2shift_search_1_23, slice2shift_search_1_24, slice2shift_reference_0 : natural range 0 to 255;
  signal slice2shift_reference_1, slice2shift_search_out_0, slice2shift_search_out_1 : natural range 0 to 255;
  -- slice2cost
  signal slice2cost_pixels_first_0_0, slice2cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_2, slice2cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_4, slice2cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_6, slice2cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_8, slice2cost_pixels_first_0_9 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_10, slice2cost_pixels_first_0_11 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_12, slice2cost_pixels_first_0_13 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_14, slice2cost_pixels_first_0_15 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_16, slice2cost_pixels_first_0_17 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_18, slice2cost_pixels_first_0_19 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_20, slice2cost_pixels_first_0_21 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_22, slice2cost_pixels_first_0_23 : integer range -255 to 255;
  signal slice2cost_pixels_first_0_24, slice2cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_1, slice2cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_3, slice2cost_pixels_first_1_4 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_5, slice2cost_pixels_first_1_6 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_7, slice2cost_pixels_first_1_8 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_9, slice2cost_pixels_first_1_10 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_11, slice2cost_pixels_first_1_12 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_13, slice2cost_pixels_first_1_14 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_15, slice2cost_pixels_first_1_16 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_17, slice2cost_pixels_first_1_18 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_19, slice2cost_pixels_first_1_20 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_21, slice2cost_pixels_first_1_22 : integer range -255 to 255;
  signal slice2cost_pixels_first_1_23, slice2cost_pixels_first_1_24, slice2cost_change_0_0 : integer range -255 to 255;
  signal slice2cost_change_0_1, slice2cost_change_0_2, slice2cost_change_0_3 : integer range -255 to 255;
  signal slice2cost_change_0_4, slice2cost_change_0_5, slice2cost_change_0_6 : integer range -255 to 255;
  signal slice2cost_change_0_7, slice2cost_change_0_8, slice2cost_change_0_9 : integer range -255 to 255;
  signal slice2cost_change_0_10, slice2cost_change_0_11, slice2cost_change_0_12 : integer range -255 to 255;
  signal slice2cost_change_0_13, slice2cost_change_0_14, slice2cost_change_0_15 : integer range -255 to 255;
  signal slice2cost_change_0_16, slice2cost_change_0_17, slice2cost_change_0_18 : integer range -255 to 255;
  signal slice2cost_change_0_19, slice2cost_change_0_20, slice2cost_change_0_21 : integer range -255 to 255;
  signal slice2cost_change_0_22, slice2cost_change_0_23, slice2cost_change_0_24 : integer range -255 to 255;
  signal slice2cost_pixels_cost_0_0, slice2cost_pixels_cost_0_1, slice2cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_3, slice2cost_pixels_cost_0_4, slice2cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_6, slice2cost_pixels_cost_0_7, slice2cost_pixels_cost_0_8 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_9, slice2cost_pixels_cost_0_10, slice2cost_pixels_cost_0_11 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_12, slice2cost_pixels_cost_0_13, slice2cost_pixels_cost_0_14 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_15, slice2cost_pixels_cost_0_16, slice2cost_pixels_cost_0_17 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_18, slice2cost_pixels_cost_0_19, slice2cost_pixels_cost_0_20 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_21, slice2cost_pixels_cost_0_22, slice2cost_pixels_cost_0_23 : natural range 0 to 255;
  signal slice2cost_pixels_cost_0_24, slice2cost_pixels_cost_1_0, slice2cost_pixels_cost_1_1 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_2, slice2cost_pixels_cost_1_3, slice2cost_pixels_cost_1_4 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_5, slice2cost_pixels_cost_1_6, slice2cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_8, slice2cost_pixels_cost_1_9, slice2cost_pixels_cost_1_10 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_11, slice2cost_pixels_cost_1_12, slice2cost_pixels_cost_1_13 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_14, slice2cost_pixels_cost_1_15, slice2cost_pixels_cost_1_16 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_17, slice2cost_pixels_cost_1_18, slice2cost_pixels_cost_1_19 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_20, slice2cost_pixels_cost_1_21, slice2cost_pixels_cost_1_22 : natural range 0 to 255;
  signal slice2cost_pixels_cost_1_23, slice2cost_pixels_cost_1_24 : natural range 0 to 255;
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_read_words_0, slice2cost_read_words_1, slice2cost_read_words_2 : unsigned(21 downto 0);
  signal slice2cost_read_words_3, slice2cost_read_words_4, slice2cost_read_words_5 : unsigned(21 downto 0);
  signal slice2cost_read_words_6, slice2cost_read_words_7, slice2cost_read_words_8 : unsigned(21 downto 0);
  signal slice2cost_read_words_9, slice2cost_read_words_10, slice2cost_read_words_11 : unsigned(21 downto 0);
  signal slice2cost_read_words_12 : unsigned(10 downto 0);
  signal slice2cost_ready_words_0, slice2cost_ready_words_1, slice2cost_ready_words_2 : natural range 0 to 4194303;
  signal slice2cost_ready_words_3, slice2cost_ready_words_4, slice2cost_ready_words_5 : natural range 0 to 4194303;
  signal slice2cost_ready_words_6, slice2cost_ready_words_7, slice2cost_ready_words_8 : natural range 0 to 4194303;
  signal slice2cost_ready_words_9, slice2cost_ready_words_10, slice2cost_ready_words_11 : natural range 0 to 4194303;
  signal slice2cost_write_words_0, slice2cost_write_words_1, slice2cost_write_words_2 : natural range 0 to 4194303;
  signal slice2cost_write_words_3, slice2cost_write_words_4, slice2cost_write_words_5 : natural range 0 to 4194303;
  signal slice2cost_write_words_6, slice2cost_write_words_7, slice2cost_write_words_8 : natural range 0 to 4194303;
  signal slice2cost_write_words_9, slice2cost_write_words_10, slice2cost_write_words_11 : natural range 0 to 4194303;
  signal slice2cost_ready_words_12, slice2cost_column_0_0, slice2cost_column_0_1 : natural range 0 to 2047;
  signal slice2cost_column_0_2, slice2cost_column_0_3, slice2cost_column_0_4 : natural range 0 to 2047;
  signal slice2cost_column_0_5, slice2cost_column_0_6, slice2cost_column_0_7 : natural range 0 to 2047;
  signal slice2cost_column_0_8, slice2cost_column_0_9, slice2cost_column_0_10 : natural range 0 to 2047;
  signal slice2cost_column_0_11, slice2cost_column_0_12, slice2cost_column_0_13 : natural range 0 to 2047;
  signal slice2cost_column_0_14, slice2cost_column_0_15, slice2cost_column_0_16 : natural range 0 to 2047;
  signal slice2cost_column_0_17, slice2cost_column_0_18, slice2cost_column_0_19 : natural range 0 to 2047;
  signal slice2cost_column_0_20, slice2cost_column_0_21, slice2cost_column_0_22 : natural range 0 to 2047;
  signal slice2cost_column_0_23, slice2cost_column_0_24, slice2cost_write_words_12 : natural range 0 to 2047;
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 7;
  signal slice2window_leaving_0, slice2window_leaving_1, slice2window_leaving_2 : unsigned(21 downto 0);
  signal slice2window_leaving_3, slice2window_leaving_4, slice2window_leaving_5 : unsigned(21 downto 0);
  signal slice2window_leaving_6, slice2window_leaving_7, slice2window_leaving_8 : unsigned(21 downto 0);
  signal slice2window_leaving_9, slice2window_leaving_10, slice2window_leaving_11 : unsigned(21 downto 0);
  signal slice2window_leaving_12 : unsigned(10 downto 0);
  signal slice2window_entering_0_0, slice2window_entering_0_1, slice2window_entering_0_2 : natural range 0 to 2047;
  signal slice2window_entering_0_3, slice2window_entering_0_4, slice2window_entering_0_5 : natural range 0 to 2047;
  signal slice2window_entering_0_6, slice2window_entering_0_7, slice2window_entering_0_8 : natural range 0 to 2047;
  signal slice2window_entering_0_9, slice2window_entering_0_10, slice2window_entering_0_11 : natural range 0 to 2047;
  signal slice2window_entering_0_12, slice2window_entering_0_13, slice2window_entering_0_14 : natural range 0 to 2047;
  signal slice2window_entering_0_15, slice2window_entering_0_16, slice2window_entering_0_17 : natural range 0 to 2047;
  signal slice2window_entering_0_18, slice2window_entering_0_19, slice2window_entering_0_20 : natural range 0 to 2047;
  signal slice2window_entering_0_21, slice2window_entering_0_22, slice2window_entering_0_23 : natural range 0 to 2047;
  signal slice2window_entering_0_24 : natural range 0 to 2047;
  signal slice2window_change_0_0, slice2window_change_0_1, slice2window_change_0_2 : integer range -2047 to 2047;
  signal slice2window_change_0_3, slice2window_change_0_4, slice2window_change_0_5 : integer range -2047 to 2047;
  signal slice2window_change_0_6, slice2window_change_0_7, slice2window_change_0_8 : integer range -2047 to 2047;
  signal slice2window_change_0_9, slice2window_change_0_10, slice2window_change_0_11 : integer range -2047 to 2047;
  signal slice2window_change_0_12, slice2window_change_0_13, slice2window_change_0_14 : integer range -2047 to 2047;
  signal slice2window_change_0_15, slice2window_change_0_16, slice2window_change_0_17 : integer range -2047 to 2047;
  signal slice2window_change_0_18, slice2window_change_0_19, slice2window_change_0_20 : integer range -2047 to 2047;
  signal slice2window_change_0_21, slice2window_change_0_22, slice2window_change_0_23 : integer range -2047 to 2047;
  signal slice2window_change_0_24 : integer range -2047 to 2047;
  signal slice2window_change_tag_leaves_window, slice2window_centre_output_column_0 : boolean;
  signal slice2window_centre_first_column_0, slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0_0, slice2window_sum_0_1, slice2window_sum_0_2 : natural range 0 to 16383;
  signal slice2window_sum_0_3, slice2window_sum_0_4, slice2window_sum_0_5 : natural range 0 to 16383;
  signal slice2window_sum_0_6, slice2window_sum_0_7, slice2window_sum_0_8 : natural range 0 to 16383;
  signal slice2window_sum_0_9, slice2window_sum_0_10, slice2window_sum_0_11 : natural range 0 to 16383;
  signal slice2window_sum_0_12, slice2window_sum_0_13, slice2window_sum_0_14 : natural range 0 to 16383;
  signal slice2window_sum_0_15, slice2window_sum_0_16, slice2window_sum_0_17 : natural range 0 to 16383;
  signal slice2window_sum_0_18, slice2window_sum_0_19, slice2window_sum_0_20 : natural range 0 to 16383;
  signal slice2window_sum_0_21, slice2window_sum_0_22, slice2window_sum_0_23 : natural range 0 to 16383;
  signal slice2window_sum_0_24 : natural range 0 to 16383;
  -- slice2winner1
  signal slice2winner1_best_cost_0_0, slice2winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_2, slice2winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_4, slice2winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_6, slice2winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_8, slice2winner1_best_cost_0_9 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_10, slice2winner1_best_cost_0_11 : natural range 0 to 16383;
  signal slice2winner1_best_cost_0_12 : natural range 0 to 16383;
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0_1 : natural range 0 to 3;
  signal slice2winner1_best_index_0_2 : natural range 0 to 5;
  signal slice2winner1_best_index_0_3 : natural range 0 to 7;
  signal slice2winner1_best_index_0_4 : natural range 0 to 9;
  signal slice2winner1_best_index_0_5 : natural range 0 to 11;
  signal slice2winner1_best_index_0_6 : natural range 0 to 13;
  signal slice2winner1_best_index_0_7 : natural range 0 to 15;
  signal slice2winner1_best_index_0_8 : natural range 0 to 17;
  signal slice2winner1_best_index_0_9 : natural range 0 to 19;
  signal slice2winner1_best_index_0_10 : natural range 0 to 21;
  signal slice2winner1_best_index_0_11 : natural range 0 to 23;
  -- slice2winner2
  signal slice2winner2_best_cost_0_0, slice2winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner2_best_cost_0_2, slice2winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice2winner2_best_cost_0_4, slice2winner2_best_cost_0_5 : natural range 0 to 16383;
  signal slice2winner2_best_cost_0_6 : natural range 0 to 16383;
  signal slice2winner2_best_index_0_0 : natural range 0 to 3;
  signal slice2winner2_best_index_0_1 : natural range 0 to 7;
  signal slice2winner2_best_index_0_2 : natural range 0 to 11;
  signal slice2winner2_best_index_0_3 : natural range 0 to 15;
  signal slice2winner2_best_index_0_4 : natural range 0 to 19;
  signal slice2winner2_best_index_0_5 : natural range 0 to 23;
  -- slice2winner3
  signal slice2winner3_best_cost_0_0, slice2winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner3_best_cost_0_2, slice2winner3_best_cost_0_3 : natural range 0 to 16383;
  signal slice2winner3_best_index_0_0 : natural range 0 to 7;
  signal slice2winner3_best_index_0_1 : natural range 0 to 15;
  signal slice2winner3_best_index_0_2 : natural range 0 to 23;
  -- slice2winner4
  signal slice2winner4_best_cost_0_0, slice2winner4_best_cost_0_1 : natural range 0 to 16383;
  signal slice2winner4_best_index_0_0 : natural range 0 to 15;
  signal slice2winner4_best_index_0_1 : natural range 0 to 24;
  -- slice2winner5
  signal slice2winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice2winner5_best_index_0_0 : natural range 0 to 24;
  -- slice2
  signal slice2_best_cost_0_0 : natural range 0 to 16383;
  signal slice2_best_index_0_0 : natural range 0 to 120;
  signal slice2_best_tag_valid, slice2_best_tag_output_column, slice2_best_tag_start_of_frame : boolean;
  signal slice2_best_tag_end_of_line : boolean;
  -- slice3shift
  signal slice3shift_search_0_0, slice3shift_search_0_1, slice3shift_search_0_2 : natural range 0 to 255;
  signal slice3shift_search_0_3, slice3shift_search_0_4, slice3shift_search_0_5 : natural range 0 to 255;
  signal slice3shift_search_0_6, slice3shift_search_0_7, slice3shift_search_0_8 : natural range 0 to 255;
  signal slice3shift_search_0_9, slice3shift_search_0_10, slice3shift_search_0_11 : natural range 0 to 255;
  signal slice3shift_search_0_12, slice3shift_search_0_13, slice3shift_search_0_14 : natural range 0 to 255;
  signal slice3shift_search_0_15, slice3shift_search_0_16, slice3shift_search_0_17 : natural range 0 to 255;
  signal slice3shift_search_0_18, slice3shift_search_0_19, slice3shift_search_0_20 : natural range 0 to 255;
  signal slice3shift_search_0_21, slice3shift_search_0_22, slice3shift_search_0_23 : natural range 0 to 255;
  signal slice3shift_search_0_24, slice3shift_search_1_0, slice3shift_search_1_1 : natural range 0 to 255;
  signal slice3shift_search_1_2, slice3shift_search_1_3, slice3shift_search_1_4 : natural range 0 to 255;
  signal slice3shift_search_1_5, slice3shift_search_1_6, slice3shift_search_1_7 : natural range 0 to 255;
  signal slice3shift_search_1_8, slice3shift_search_1_9, slice3shift_search_1_10 : natural range 0 to 255;
  signal slice3shift_search_1_11, slice3shift_search_1_12, slice3shift_search_1_13 : natural range 0 to 255;
  signal slice3shift_search_1_14, slice3shift_search_1_15, slice3shift_search_1_16 : natural range 0 to 255;
  signal slice3shift_search_1_17, slice3shift_search_1_18, slice3shift_search_1_19 : natural range 0 to 255;
  signal slice3shift_search_1_20, slice3shift_search_1_21, slice3shift_search_1_22 : natural range 0 to 255;
  signal slice3shift_search_1_23, slice3shift_search_1_24, slice3shift_reference_0 : natural range 0 to 255;
  signal slice3shift_reference_1, slice3shift_search_out_0, slice3shift_search_out_1 : natural range 0 to 255;
  -- slice3cost
  signal slice3cost_pixels_first_0_0, slice3cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_2, slice3cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_4, slice3cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_6, slice3cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_8, slice3cost_pixels_first_0_9 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_10, slice3cost_pixels_first_0_11 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_12, slice3cost_pixels_first_0_13 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_14, slice3cost_pixels_first_0_15 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_16, slice3cost_pixels_first_0_17 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_18, slice3cost_pixels_first_0_19 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_20, slice3cost_pixels_first_0_21 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_22, slice3cost_pixels_first_0_23 : integer range -255 to 255;
  signal slice3cost_pixels_first_0_24, slice3cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_1, slice3cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_3, slice3cost_pixels_first_1_4 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_5, slice3cost_pixels_first_1_6 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_7, slice3cost_pixels_first_1_8 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_9, slice3cost_pixels_first_1_10 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_11, slice3cost_pixels_first_1_12 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_13, slice3cost_pixels_first_1_14 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_15, slice3cost_pixels_first_1_16 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_17, slice3cost_pixels_first_1_18 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_19, slice3cost_pixels_first_1_20 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_21, slice3cost_pixels_first_1_22 : integer range -255 to 255;
  signal slice3cost_pixels_first_1_23, slice3cost_pixels_first_1_24, slice3cost_change_0_0 : integer range -255 to 255;
  signal slice3cost_change_0_1, slice3cost_change_0_2, slice3cost_change_0_3 : integer range -255 to 255;
  signal slice3cost_change_0_4, slice3cost_change_0_5, slice3cost_change_0_6 : integer range -255 to 255;
  signal slice3cost_change_0_7, slice3cost_change_0_8, slice3cost_change_0_9 : integer range -255 to 255;
  signal slice3cost_change_0_10, slice3cost_change_0_11, slice3cost_change_0_12 : integer range -255 to 255;
  signal slice3cost_change_0_13, slice3cost_change_0_14, slice3cost_change_0_15 : integer range -255 to 255;
  signal slice3cost_change_0_16, slice3cost_change_0_17, slice3cost_change_0_18 : integer range -255 to 255;
  signal slice3cost_change_0_19, slice3cost_change_0_20, slice3cost_change_0_21 : integer range -255 to 255;
  signal slice3cost_change_0_22, slice3cost_change_0_23, slice3cost_change_0_24 : integer range -255 to 255;
  signal slice3cost_pixels_cost_0_0, slice3cost_pixels_cost_0_1, slice3cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_3, slice3cost_pixels_cost_0_4, slice3cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_6, slice3cost_pixels_cost_0_7, slice3cost_pixels_cost_0_8 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_9, slice3cost_pixels_cost_0_10, slice3cost_pixels_cost_0_11 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_12, slice3cost_pixels_cost_0_13, slice3cost_pixels_cost_0_14 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_15, slice3cost_pixels_cost_0_16, slice3cost_pixels_cost_0_17 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_18, slice3cost_pixels_cost_0_19, slice3cost_pixels_cost_0_20 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_21, slice3cost_pixels_cost_0_22, slice3cost_pixels_cost_0_23 : natural range 0 to 255;
  signal slice3cost_pixels_cost_0_24, slice3cost_pixels_cost_1_0, slice3cost_pixels_cost_1_1 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_2, slice3cost_pixels_cost_1_3, slice3cost_pixels_cost_1_4 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_5, slice3cost_pixels_cost_1_6, slice3cost_pixels_cost_1_7 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_8, slice3cost_pixels_cost_1_9, slice3cost_pixels_cost_1_10 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_11, slice3cost_pixels_cost_1_12, slice3cost_pixels_cost_1_13 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_14, slice3cost_pixels_cost_1_15, slice3cost_pixels_cost_1_16 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_17, slice3cost_pixels_cost_1_18, slice3cost_pixels_cost_1_19 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_20, slice3cost_pixels_cost_1_21, slice3cost_pixels_cost_1_22 : natural range 0 to 255;
  signal slice3cost_pixels_cost_1_23, slice3cost_pixels_cost_1_24 : natural range 0 to 255;
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column : natural range 0 to 511;
  signal slice3cost_write_column : natural range 0 to 511;
  signal slice3cost_read_words_0, slice3cost_read_words_1, slice3cost_read_words_2 : unsigned(21 downto 0);
  signal slice3cost_read_words_3, slice3cost_read_words_4, slice3cost_read_words_5 : unsigned(21 downto 0);
  signal slice3cost_read_words_6, slice3cost_read_words_7, slice3cost_read_words_8 : unsigned(21 downto 0);
  signal slice3cost_read_words_9, slice3cost_read_words_10, slice3cost_read_words_11 : unsigned(21 downto 0);
  signal slice3cost_read_words_12 : unsigned(10 downto 0);
  signal slice3cost_ready_words_0, slice3cost_ready_words_1, slice3cost_ready_words_2 : natural range 0 to 4194303;
  signal slice3cost_ready_words_3, slice3cost_ready_words_4, slice3cost_ready_words_5 : natural range 0 to 4194303;
  signal slice3cost_ready_words_6, slice3cost_ready_words_7, slice3cost_ready_words_8 : natural range 0 to 4194303;
  signal slice3cost_ready_words_9, slice3cost_ready_words_10, slice3cost_ready_words_11 : natural range 0 to 4194303;
  signal slice3cost_write_words_0, slice3cost_write_words_1, slice3cost_write_words_2 : natural range 0 to 4194303;
  signal slice3cost_write_words_3, slice3cost_write_words_4, slice3cost_write_words_5 : natural range 0 to 4194303;
  signal slice3cost_write_words_6, slice3cost_write_words_7, slice3cost_write_words_8 : natural range 0 to 4194303;
  signal slice3cost_write_words_9, slice3cost_write_words_10, slice3cost_write_words_11 : natural range 0 to 4194303;
  signal slice3cost_ready_words_12, slice3cost_column_0_0, slice3cost_column_0_1 : natural range 0 to 2047;
  signal slice3cost_column_0_2, slice3cost_column_0_3, slice3cost_column_0_4 : natural range 0 to 2047;
  signal slice3cost_column_0_5, slice3cost_column_0_6, slice3cost_column_0_7 : natural range 0 to 2047;
  signal slice3cost_column_0_8, slice3cost_column_0_9, slice3cost_column_0_10 : natural range 0 to 2047;
  signal slice3cost_column_0_11, slice3cost_column_0_12, slice3cost_column_0_13 : natural range 0 to 2047;
  signal slice3cost_column_0_14, slice3cost_column_0_15, slice3cost_column_0_16 : natural range 0 to 2047;
  signal slice3cost_column_0_17, slice3cost_column_0_18, slice3cost_column_0_19 : natural range 0 to 2047;
  signal slice3cost_column_0_20, slice3cost_column_0_21, slice3cost_column_0_22 : natural range 0 to 2047;
  signal slice3cost_column_0_23, slice3cost_column_0_24, slice3cost_write_words_12 : natural range 0 to 2047;
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 7;
  signal slice3window_leaving_0, slice3window_leaving_1, slice3window_leaving_2 : unsigned(21 downto 0);
  signal slice3window_leaving_3, slice3window_leaving_4, slice3window_leaving_5 : unsigned(21 downto 0);
  signal slice3window_leaving_6, slice3window_leaving_7, slice3window_leaving_8 : unsigned(21 downto 0);
  signal slice3window_leaving_9, slice3window_leaving_10, slice3window_leaving_11 : unsigned(21 downto 0);
  signal slice3window_leaving_12 : unsigned(10 downto 0);
  signal slice3window_entering_0_0, slice3window_entering_0_1, slice3window_entering_0_2 : natural range 0 to 2047;
  signal slice3window_entering_0_3, slice3window_entering_0_4, slice3window_entering_0_5 : natural range 0 to 2047;
  signal slice3window_entering_0_6, slice3window_entering_0_7, slice3window_entering_0_8 : natural range 0 to 2047;
  signal slice3window_entering_0_9, slice3window_entering_0_10, slice3window_entering_0_11 : natural range 0 to 2047;
  signal slice3window_entering_0_12, slice3window_entering_0_13, slice3window_entering_0_14 : natural range 0 to 2047;
  signal slice3window_entering_0_15, slice3window_entering_0_16, slice3window_entering_0_17 : natural range 0 to 2047;
  signal slice3window_entering_0_18, slice3window_entering_0_19, slice3window_entering_0_20 : natural range 0 to 2047;
  signal slice3window_entering_0_21, slice3window_entering_0_22, slice3window_entering_0_23 : natural range 0 to 2047;
  signal slice3window_entering_0_24 : natural range 0 to 2047;
  signal slice3window_change_0_0, slice3window_change_0_1, slice3window_change_0_2 : integer range -2047 to 2047;
  signal slice3window_change_0_3, slice3window_change_0_4, slice3window_change_0_5 : integer range -2047 to 2047;
  signal slice3window_change_0_6, slice3window_change_0_7, slice3window_change_0_8 : integer range -2047 to 2047;
  signal slice3window_change_0_9, slice3window_change_0_10, slice3window_change_0_11 : integer range -2047 to 2047;
  signal slice3window_change_0_12, slice3window_change_0_13, slice3window_change_0_14 : integer range -2047 to 2047;
  signal slice3window_change_0_15, slice3window_change_0_16, slice3window_change_0_17 : integer range -2047 to 2047;
  signal slice3window_change_0_18, slice3window_change_0_19, slice3window_change_0_20 : integer range -2047 to 2047;
  signal slice3window_change_0_21, slice3window_change_0_22, slice3window_change_0_23 : integer range -2047 to 2047;
  signal slice3window_change_0_24 : integer range -2047 to 2047;
  signal slice3window_change_tag_leaves_window, slice3window_centre_output_column_0 : boolean;
  signal slice3window_centre_first_column_0, slice3window_centre_end_of_line_0 : boolean;
  signal slice3window_sum_0_0, slice3window_sum_0_1, slice3window_sum_0_2 : natural range 0 to 16383;
  signal slice3window_sum_0_3, slice3window_sum_0_4, slice3window_sum_0_5 : natural range 0 to 16383;
  signal slice3window_sum_0_6, slice3window_sum_0_7, slice3window_sum_0_8 : natural range 0 to 16383;
  signal slice3window_sum_0_9, slice3window_sum_0_10, slice3window_sum_0_11 : natural range 0 to 16383;
  signal slice3window_sum_0_12, slice3window_sum_0_13, slice3window_sum_0_14 : natural range 0 to 16383;
  signal slice3window_sum_0_15, slice3window_sum_0_16, slice3window_sum_0_17 : natural range 0 to 16383;
  signal slice3window_sum_0_18, slice3window_sum_0_19, slice3window_sum_0_20 : natural range 0 to 16383;
  signal slice3window_sum_0_21, slice3window_sum_0_22, slice3window_sum_0_23 : natural range 0 to 16383;
  signal slice3window_sum_0_24 : natural range 0 to 16383;
  -- slice3winner1
  signal slice3winner1_best_cost_0_0, slice3winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_2, slice3winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_4, slice3winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_6, slice3winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_8, slice3winner1_best_cost_0_9 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_10, slice3winner1_best_cost_0_11 : natural range 0 to 16383;
  signal slice3winner1_best_cost_0_12 : natural range 0 to 16383;
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0_1 : natural range 0 to 3;
  signal slice3winner1_best_index_0_2 : natural range 0 to 5;
  signal slice3winner1_best_index_0_3 : natural range 0 to 7;
  signal slice3winner1_best_index_0_4 : natural range 0 to 9;
  signal slice3winner1_best_index_0_5 : natural range 0 to 11;
  signal slice3winner1_best_index_0_6 : natural range 0 to 13;
  signal slice3winner1_best_index_0_7 : natural range 0 to 15;
  signal slice3winner1_best_index_0_8 : natural range 0 to 17;
  signal slice3winner1_best_index_0_9 : natural range 0 to 19;
  signal slice3winner1_best_index_0_10 : natural range 0 to 21;
  signal slice3winner1_best_index_0_11 : natural range 0 to 23;
  -- slice3winner2
  signal slice3winner2_best_cost_0_0, slice3winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner2_best_cost_0_2, slice3winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice3winner2_best_cost_0_4, slice3winner2_best_cost_0_5 : natural range 0 to 16383;
  signal slice3winner2_best_cost_0_6 : natural range 0 to 16383;
  signal slice3winner2_best_index_0_0 : natural range 0 to 3;
  signal slice3winner2_best_index_0_1 : natural range 0 to 7;
  signal slice3winner2_best_index_0_2 : natural range 0 to 11;
  signal slice3winner2_best_index_0_3 : natural range 0 to 15;
  signal slice3winner2_best_index_0_4 : natural range 0 to 19;
  signal slice3winner2_best_index_0_5 : natural range 0 to 23;
  -- slice3winner3
  signal slice3winner3_best_cost_0_0, slice3winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner3_best_cost_0_2, slice3winner3_best_cost_0_3 : natural range 0 to 16383;
  signal slice3winner3_best_index_0_0 : natural range 0 to 7;
  signal slice3winner3_best_index_0_1 : natural range 0 to 15;
  signal slice3winner3_best_index_0_2 : natural range 0 to 23;
  -- slice3winner4
  signal slice3winner4_best_cost_0_0, slice3winner4_best_cost_0_1 : natural range 0 to 16383;
  signal slice3winner4_best_index_0_0 : natural range 0 to 15;
  signal slice3winner4_best_index_0_1 : natural range 0 to 24;
  -- slice3winner5
  signal slice3winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice3winner5_best_index_0_0 : natural range 0 to 24;
  -- slice3
  signal slice3_best_cost_0_0 : natural range 0 to 16383;
  signal slice3_best_index_0_0 : natural range 0 to 120;
  signal slice3_best_tag_valid, slice3_best_tag_output_column, slice3_best_tag_start_of_frame : boolean;
  signal slice3_best_tag_end_of_line : boolean;
  -- slice4shift
  signal slice4shift_search_0_0, slice4shift_search_0_1, slice4shift_search_0_2 : natural range 0 to 255;
  signal slice4shift_search_0_3, slice4shift_search_0_4, slice4shift_search_0_5 : natural range 0 to 255;
  signal slice4shift_search_0_6, slice4shift_search_0_7, slice4shift_search_0_8 : natural range 0 to 255;
  signal slice4shift_search_0_9, slice4shift_search_0_10, slice4shift_search_0_11 : natural range 0 to 255;
  signal slice4shift_search_0_12, slice4shift_search_0_13, slice4shift_search_0_14 : natural range 0 to 255;
  signal slice4shift_search_0_15, slice4shift_search_0_16, slice4shift_search_0_17 : natural range 0 to 255;
  signal slice4shift_search_0_18, slice4shift_search_0_19, slice4shift_search_0_20 : natural range 0 to 255;
  signal slice4shift_search_1_0, slice4shift_search_1_1, slice4shift_search_1_2 : natural range 0 to 255;
  signal slice4shift_search_1_3, slice4shift_search_1_4, slice4shift_search_1_5 : natural range 0 to 255;
  signal slice4shift_search_1_6, slice4shift_search_1_7, slice4shift_search_1_8 : natural range 0 to 255;
  signal slice4shift_search_1_9, slice4shift_search_1_10, slice4shift_search_1_11 : natural range 0 to 255;
  signal slice4shift_search_1_12, slice4shift_search_1_13, slice4shift_search_1_14 : natural range 0 to 255;
  signal slice4shift_search_1_15, slice4shift_search_1_16, slice4shift_search_1_17 : natural range 0 to 255;
  signal slice4shift_search_1_18, slice4shift_search_1_19, slice4shift_search_1_20 : natural range 0 to 255;
  signal slice4shift_reference_0, slice4shift_reference_1 : natural range 0 to 255;
  -- slice4cost
  signal slice4cost_pixels_first_0_0, slice4cost_pixels_first_0_1 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_2, slice4cost_pixels_first_0_3 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_4, slice4cost_pixels_first_0_5 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_6, slice4cost_pixels_first_0_7 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_8, slice4cost_pixels_first_0_9 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_10, slice4cost_pixels_first_0_11 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_12, slice4cost_pixels_first_0_13 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_14, slice4cost_pixels_first_0_15 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_16, slice4cost_pixels_first_0_17 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_18, slice4cost_pixels_first_0_19 : integer range -255 to 255;
  signal slice4cost_pixels_first_0_20, slice4cost_pixels_first_1_0 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_1, slice4cost_pixels_first_1_2 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_3, slice4cost_pixels_first_1_4 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_5, slice4cost_pixels_first_1_6 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_7, slice4cost_pixels_first_1_8 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_9, slice4cost_pixels_first_1_10 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_11, slice4cost_pixels_first_1_12 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_13, slice4cost_pixels_first_1_14 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_15, slice4cost_pixels_first_1_16 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_17, slice4cost_pixels_first_1_18 : integer range -255 to 255;
  signal slice4cost_pixels_first_1_19, slice4cost_pixels_first_1_20, slice4cost_change_0_0 : integer range -255 to 255;
  signal slice4cost_change_0_1, slice4cost_change_0_2, slice4cost_change_0_3 : integer range -255 to 255;
  signal slice4cost_change_0_4, slice4cost_change_0_5, slice4cost_change_0_6 : integer range -255 to 255;
  signal slice4cost_change_0_7, slice4cost_change_0_8, slice4cost_change_0_9 : integer range -255 to 255;
  signal slice4cost_change_0_10, slice4cost_change_0_11, slice4cost_change_0_12 : integer range -255 to 255;
  signal slice4cost_change_0_13, slice4cost_change_0_14, slice4cost_change_0_15 : integer range -255 to 255;
  signal slice4cost_change_0_16, slice4cost_change_0_17, slice4cost_change_0_18 : integer range -255 to 255;
  signal slice4cost_change_0_19, slice4cost_change_0_20 : integer range -255 to 255;
  signal slice4cost_pixels_cost_0_0, slice4cost_pixels_cost_0_1, slice4cost_pixels_cost_0_2 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_3, slice4cost_pixels_cost_0_4, slice4cost_pixels_cost_0_5 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_6, slice4cost_pixels_cost_0_7, slice4cost_pixels_cost_0_8 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_9, slice4cost_pixels_cost_0_10, slice4cost_pixels_cost_0_11 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_12, slice4cost_pixels_cost_0_13, slice4cost_pixels_cost_0_14 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_15, slice4cost_pixels_cost_0_16, slice4cost_pixels_cost_0_17 : natural range 0 to 255;
  signal slice4cost_pixels_cost_0_18, slice4cost_pixels_cost_0_19, slice4cost_pixels_cost_0_20 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_0, slice4cost_pixels_cost_1_1, slice4cost_pixels_cost_1_2 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_3, slice4cost_pixels_cost_1_4, slice4cost_pixels_cost_1_5 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_6, slice4cost_pixels_cost_1_7, slice4cost_pixels_cost_1_8 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_9, slice4cost_pixels_cost_1_10, slice4cost_pixels_cost_1_11 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_12, slice4cost_pixels_cost_1_13, slice4cost_pixels_cost_1_14 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_15, slice4cost_pixels_cost_1_16, slice4cost_pixels_cost_1_17 : natural range 0 to 255;
  signal slice4cost_pixels_cost_1_18, slice4cost_pixels_cost_1_19, slice4cost_pixels_cost_1_20 : natural range 0 to 255;
  signal slice4cost_read_column, slice4cost_change_column, slice4cost_ready_column : natural range 0 to 511;
  signal slice4cost_write_column : natural range 0 to 511;
  signal slice4cost_read_words_0, slice4cost_read_words_1, slice4cost_read_words_2 : unsigned(21 downto 0);
  signal slice4cost_read_words_3, slice4cost_read_words_4, slice4cost_read_words_5 : unsigned(21 downto 0);
  signal slice4cost_read_words_6, slice4cost_read_words_7, slice4cost_read_words_8 : unsigned(21 downto 0);
  signal slice4cost_read_words_9 : unsigned(21 downto 0);
  signal slice4cost_read_words_10 : unsigned(10 downto 0);
  signal slice4cost_ready_words_0, slice4cost_ready_words_1, slice4cost_ready_words_2 : natural range 0 to 4194303;
  signal slice4cost_ready_words_3, slice4cost_ready_words_4, slice4cost_ready_words_5 : natural range 0 to 4194303;
  signal slice4cost_ready_words_6, slice4cost_ready_words_7, slice4cost_ready_words_8 : natural range 0 to 4194303;
  signal slice4cost_ready_words_9, slice4cost_write_words_0, slice4cost_write_words_1 : natural range 0 to 4194303;
  signal slice4cost_write_words_2, slice4cost_write_words_3, slice4cost_write_words_4 : natural range 0 to 4194303;
  signal slice4cost_write_words_5, slice4cost_write_words_6, slice4cost_write_words_7 : natural range 0 to 4194303;
  signal slice4cost_write_words_8, slice4cost_write_words_9 : natural range 0 to 4194303;
  signal slice4cost_ready_words_10, slice4cost_column_0_0, slice4cost_column_0_1 : natural range 0 to 2047;
  signal slice4cost_column_0_2, slice4cost_column_0_3, slice4cost_column_0_4 : natural range 0 to 2047;
  signal slice4cost_column_0_5, slice4cost_column_0_6, slice4cost_column_0_7 : natural range 0 to 2047;
  signal slice4cost_column_0_8, slice4cost_column_0_9, slice4cost_column_0_10 : natural range 0 to 2047;
  signal slice4cost_column_0_11, slice4cost_column_0_12, slice4cost_column_0_13 : natural range 0 to 2047;
  signal slice4cost_column_0_14, slice4cost_column_0_15, slice4cost_column_0_16 : natural range 0 to 2047;
  signal slice4cost_column_0_17, slice4cost_column_0_18, slice4cost_column_0_19 : natural range 0 to 2047;
  signal slice4cost_column_0_20, slice4cost_write_words_10 : natural range 0 to 2047;
  -- slice4window
  signal slice4window_ring_read_address, slice4window_ring_write_address : natural range 0 to 7;
  signal slice4window_leaving_0, slice4window_leaving_1, slice4window_leaving_2 : unsigned(21 downto 0);
  signal slice4window_leaving_3, slice4window_leaving_4, slice4window_leaving_5 : unsigned(21 downto 0);
  signal slice4window_leaving_6, slice4window_leaving_7, slice4window_leaving_8 : unsigned(21 downto 0);
  signal slice4window_leaving_9 : unsigned(21 downto 0);
  signal slice4window_leaving_10 : unsigned(10 downto 0);
  signal slice4window_entering_0_0, slice4window_entering_0_1, slice4window_entering_0_2 : natural range 0 to 2047;
  signal slice4window_entering_0_3, slice4window_entering_0_4, slice4window_entering_0_5 : natural range 0 to 2047;
  signal slice4window_entering_0_6, slice4window_entering_0_7, slice4window_entering_0_8 : natural range 0 to 2047;
  signal slice4window_entering_0_9, slice4window_entering_0_10, slice4window_entering_0_11 : natural range 0 to 2047;
  signal slice4window_entering_0_12, slice4window_entering_0_13, slice4window_entering_0_14 : natural range 0 to 2047;
  signal slice4window_entering_0_15, slice4window_entering_0_16, slice4window_entering_0_17 : natural range 0 to 2047;
  signal slice4window_entering_0_18, slice4window_entering_0_19, slice4window_entering_0_20 : natural range 0 to 2047;
  signal slice4window_change_0_0, slice4window_change_0_1, slice4window_change_0_2 : integer range -2047 to 2047;
  signal slice4window_change_0_3, slice4window_change_0_4, slice4window_change_0_5 : integer range -2047 to 2047;
  signal slice4window_change_0_6, slice4window_change_0_7, slice4window_change_0_8 : integer range -2047 to 2047;
  signal slice4window_change_0_9, slice4window_change_0_10, slice4window_change_0_11 : integer range -2047 to 2047;
  signal slice4window_change_0_12, slice4window_change_0_13, slice4window_change_0_14 : integer range -2047 to 2047;
  signal slice4window_change_0_15, slice4window_change_0_16, slice4window_change_0_17 : integer range -2047 to 2047;
  signal slice4window_change_0_18, slice4window_change_0_19, slice4window_change_0_20 : integer range -2047 to 2047;
  signal slice4window_sum_0_0, slice4window_sum_0_1, slice4window_sum_0_2 : natural range 0 to 16383;
  signal slice4window_sum_0_3, slice4window_sum_0_4, slice4window_sum_0_5 : natural range 0 to 16383;
  signal slice4window_sum_0_6, slice4window_sum_0_7, slice4window_sum_0_8 : natural range 0 to 16383;
  signal slice4window_sum_0_9, slice4window_sum_0_10, slice4window_sum_0_11 : natural range 0 to 16383;
  signal slice4window_sum_0_12, slice4window_sum_0_13, slice4window_sum_0_14 : natural range 0 to 16383;
  signal slice4window_sum_0_15, slice4window_sum_0_16, slice4window_sum_0_17 : natural range 0 to 16383;
  signal slice4window_sum_0_18, slice4window_sum_0_19, slice4window_sum_0_20 : natural range 0 to 16383;
  signal slice4window_centre_output_column_0, slice4window_centre_output_column_1 : boolean;
  signal slice4window_centre_end_of_line_0, slice4window_centre_end_of_line_1 : boolean;
  -- slice4winner1
  signal slice4winner1_best_cost_0_0, slice4winner1_best_cost_0_1 : natural range 0 to 16383;
  signal slice4winner1_best_cost_0_2, slice4winner1_best_cost_0_3 : natural range 0 to 16383;
  signal slice4winner1_best_cost_0_4, slice4winner1_best_cost_0_5 : natural range 0 to 16383;
  signal slice4winner1_best_cost_0_6, slice4winner1_best_cost_0_7 : natural range 0 to 16383;
  signal slice4winner1_best_cost_0_8, slice4winner1_best_cost_0_9 : natural range 0 to 16383;
  signal slice4winner1_best_cost_0_10 : natural range 0 to 16383;
  signal slice4winner1_best_index_0_0 : boolean;
  signal slice4winner1_best_index_0_1 : natural range 0 to 3;
  signal slice4winner1_best_index_0_2 : natural range 0 to 5;
  signal slice4winner1_best_index_0_3 : natural range 0 to 7;
  signal slice4winner1_best_index_0_4 : natural range 0 to 9;
  signal slice4winner1_best_index_0_5 : natural range 0 to 11;
  signal slice4winner1_best_index_0_6 : natural range 0 to 13;
  signal slice4winner1_best_index_0_7 : natural range 0 to 15;
  signal slice4winner1_best_index_0_8 : natural range 0 to 17;
  signal slice4winner1_best_index_0_9 : natural range 0 to 19;
  signal slice4winner1_best_index_0_10 : natural range 0 to 20;
  -- slice4winner2
  signal slice4winner2_best_cost_0_0, slice4winner2_best_cost_0_1 : natural range 0 to 16383;
  signal slice4winner2_best_cost_0_2, slice4winner2_best_cost_0_3 : natural range 0 to 16383;
  signal slice4winner2_best_cost_0_4, slice4winner2_best_cost_0_5 : natural range 0 to 16383;
  signal slice4winner2_best_index_0_0 : natural range 0 to 3;
  signal slice4winner2_best_index_0_1 : natural range 0 to 7;
  signal slice4winner2_best_index_0_2 : natural range 0 to 11;
  signal slice4winner2_best_index_0_3 : natural range 0 to 15;
  signal slice4winner2_best_index_0_4 : natural range 0 to 19;
  signal slice4winner2_best_index_0_5 : natural range 0 to 20;
  -- slice4winner3
  signal slice4winner3_best_cost_0_0, slice4winner3_best_cost_0_1 : natural range 0 to 16383;
  signal slice4winner3_best_cost_0_2 : natural range 0 to 16383;
  signal slice4winner3_best_index_0_0 : natural range 0 to 7;
  signal slice4winner3_best_index_0_1 : natural range 0 to 15;
  signal slice4winner3_best_index_0_2 : natural range 0 to 20;
  -- slice4winner4
  signal slice4winner4_best_cost_0_0, slice4winner4_best_cost_0_1 : natural range 0 to 16383;
  signal slice4winner4_best_index_0_0 : natural range 0 to 15;
  signal slice4winner4_best_index_0_1 : natural range 0 to 20;
  -- slice4winner5
  signal slice4winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice4winner5_best_index_0_0 : natural range 0 to 20;
  -- slice4
  signal slice4_best_index_0_0 : natural range 0 to 120;
  signal slice4_best_tag_valid, slice4_best_tag_output_column, slice4_best_tag_start_of_frame : boolean;
  signal slice4_best_tag_end_of_line : boolean;
  signal slice4window_leaving_10_memory_read_enable : boolean;
  signal slice4window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_10_memory_write_data : unsigned(10 downto 0);
  signal slice4window_leaving_9_memory_read_enable : boolean;
  signal slice4window_leaving_9_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_8_memory_read_enable : boolean;
  signal slice4window_leaving_8_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_7_memory_read_enable : boolean;
  signal slice4window_leaving_7_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_6_memory_read_enable : boolean;
  signal slice4window_leaving_6_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_5_memory_read_enable : boolean;
  signal slice4window_leaving_5_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_4_memory_read_enable : boolean;
  signal slice4window_leaving_4_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_3_memory_read_enable : boolean;
  signal slice4window_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_2_memory_read_enable : boolean;
  signal slice4window_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_1_memory_read_enable : boolean;
  signal slice4window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice4window_leaving_0_memory_read_enable : boolean;
  signal slice4window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice4window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice4window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_10_memory_read_enable : boolean;
  signal slice4cost_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_10_memory_write_data : unsigned(10 downto 0);
  signal slice4cost_read_words_9_memory_read_enable : boolean;
  signal slice4cost_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_8_memory_read_enable : boolean;
  signal slice4cost_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_7_memory_read_enable : boolean;
  signal slice4cost_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_6_memory_read_enable : boolean;
  signal slice4cost_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_5_memory_read_enable : boolean;
  signal slice4cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_4_memory_read_enable : boolean;
  signal slice4cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_3_memory_read_enable : boolean;
  signal slice4cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_2_memory_read_enable : boolean;
  signal slice4cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_1_memory_read_enable : boolean;
  signal slice4cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice4cost_read_words_0_memory_read_enable : boolean;
  signal slice4cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice4cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice4cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_12_memory_read_enable : boolean;
  signal slice3window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice3window_leaving_11_memory_read_enable : boolean;
  signal slice3window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_10_memory_read_enable : boolean;
  signal slice3window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_9_memory_read_enable : boolean;
  signal slice3window_leaving_9_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_8_memory_read_enable : boolean;
  signal slice3window_leaving_8_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_7_memory_read_enable : boolean;
  signal slice3window_leaving_7_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_6_memory_read_enable : boolean;
  signal slice3window_leaving_6_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_5_memory_read_enable : boolean;
  signal slice3window_leaving_5_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_4_memory_read_enable : boolean;
  signal slice3window_leaving_4_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_3_memory_read_enable : boolean;
  signal slice3window_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_2_memory_read_enable : boolean;
  signal slice3window_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_1_memory_read_enable : boolean;
  signal slice3window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice3window_leaving_0_memory_read_enable : boolean;
  signal slice3window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice3window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice3window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_12_memory_read_enable : boolean;
  signal slice3cost_read_words_12_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_12_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice3cost_read_words_11_memory_read_enable : boolean;
  signal slice3cost_read_words_11_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_11_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_10_memory_read_enable : boolean;
  signal slice3cost_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_9_memory_read_enable : boolean;
  signal slice3cost_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_8_memory_read_enable : boolean;
  signal slice3cost_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_7_memory_read_enable : boolean;
  signal slice3cost_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_6_memory_read_enable : boolean;
  signal slice3cost_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_5_memory_read_enable : boolean;
  signal slice3cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_4_memory_read_enable : boolean;
  signal slice3cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_3_memory_read_enable : boolean;
  signal slice3cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_2_memory_read_enable : boolean;
  signal slice3cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_1_memory_read_enable : boolean;
  signal slice3cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice3cost_read_words_0_memory_read_enable : boolean;
  signal slice3cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice3cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice3cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_12_memory_read_enable : boolean;
  signal slice2window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice2window_leaving_11_memory_read_enable : boolean;
  signal slice2window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_10_memory_read_enable : boolean;
  signal slice2window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_9_memory_read_enable : boolean;
  signal slice2window_leaving_9_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_8_memory_read_enable : boolean;
  signal slice2window_leaving_8_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_7_memory_read_enable : boolean;
  signal slice2window_leaving_7_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_6_memory_read_enable : boolean;
  signal slice2window_leaving_6_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_5_memory_read_enable : boolean;
  signal slice2window_leaving_5_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_4_memory_read_enable : boolean;
  signal slice2window_leaving_4_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_3_memory_read_enable : boolean;
  signal slice2window_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_2_memory_read_enable : boolean;
  signal slice2window_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_1_memory_read_enable : boolean;
  signal slice2window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice2window_leaving_0_memory_read_enable : boolean;
  signal slice2window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice2window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice2window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_12_memory_read_enable : boolean;
  signal slice2cost_read_words_12_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_12_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice2cost_read_words_11_memory_read_enable : boolean;
  signal slice2cost_read_words_11_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_11_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_10_memory_read_enable : boolean;
  signal slice2cost_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_9_memory_read_enable : boolean;
  signal slice2cost_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_8_memory_read_enable : boolean;
  signal slice2cost_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_7_memory_read_enable : boolean;
  signal slice2cost_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_6_memory_read_enable : boolean;
  signal slice2cost_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_5_memory_read_enable : boolean;
  signal slice2cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_4_memory_read_enable : boolean;
  signal slice2cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_3_memory_read_enable : boolean;
  signal slice2cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_2_memory_read_enable : boolean;
  signal slice2cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_1_memory_read_enable : boolean;
  signal slice2cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice2cost_read_words_0_memory_read_enable : boolean;
  signal slice2cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice2cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_12_memory_read_enable : boolean;
  signal slice1window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice1window_leaving_11_memory_read_enable : boolean;
  signal slice1window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_10_memory_read_enable : boolean;
  signal slice1window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_9_memory_read_enable : boolean;
  signal slice1window_leaving_9_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_8_memory_read_enable : boolean;
  signal slice1window_leaving_8_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_7_memory_read_enable : boolean;
  signal slice1window_leaving_7_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_6_memory_read_enable : boolean;
  signal slice1window_leaving_6_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_5_memory_read_enable : boolean;
  signal slice1window_leaving_5_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_4_memory_read_enable : boolean;
  signal slice1window_leaving_4_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_3_memory_read_enable : boolean;
  signal slice1window_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_12_memory_read_enable : boolean;
  signal slice1cost_read_words_12_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_12_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice1cost_read_words_11_memory_read_enable : boolean;
  signal slice1cost_read_words_11_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_11_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_10_memory_read_enable : boolean;
  signal slice1cost_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_9_memory_read_enable : boolean;
  signal slice1cost_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_8_memory_read_enable : boolean;
  signal slice1cost_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_7_memory_read_enable : boolean;
  signal slice1cost_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_6_memory_read_enable : boolean;
  signal slice1cost_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_5_memory_read_enable : boolean;
  signal slice1cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_4_memory_read_enable : boolean;
  signal slice1cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_3_memory_read_enable : boolean;
  signal slice1cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_12_memory_read_enable : boolean;
  signal slice0window_leaving_12_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_12_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_12_memory_write_data : unsigned(10 downto 0);
  signal slice0window_leaving_11_memory_read_enable : boolean;
  signal slice0window_leaving_11_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_11_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_11_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_10_memory_read_enable : boolean;
  signal slice0window_leaving_10_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_10_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_10_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_9_memory_read_enable : boolean;
  signal slice0window_leaving_9_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_9_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_9_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_8_memory_read_enable : boolean;
  signal slice0window_leaving_8_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_8_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_8_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_7_memory_read_enable : boolean;
  signal slice0window_leaving_7_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_7_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_7_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_6_memory_read_enable : boolean;
  signal slice0window_leaving_6_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_6_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_6_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_5_memory_read_enable : boolean;
  signal slice0window_leaving_5_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_5_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_5_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_4_memory_read_enable : boolean;
  signal slice0window_leaving_4_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_4_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_4_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_3_memory_read_enable : boolean;
  signal slice0window_leaving_3_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_3_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_3_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_2_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(21 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_12_memory_read_enable : boolean;
  signal slice0cost_read_words_12_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_12_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_12_memory_write_data : unsigned(10 downto 0);
  signal slice0cost_read_words_11_memory_read_enable : boolean;
  signal slice0cost_read_words_11_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_11_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_11_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_10_memory_read_enable : boolean;
  signal slice0cost_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_10_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_9_memory_read_enable : boolean;
  signal slice0cost_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_9_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_8_memory_read_enable : boolean;
  signal slice0cost_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_8_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_7_memory_read_enable : boolean;
  signal slice0cost_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_7_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_6_memory_read_enable : boolean;
  signal slice0cost_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_6_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_5_memory_read_enable : boolean;
  signal slice0cost_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_5_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_4_memory_read_enable : boolean;
  signal slice0cost_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_4_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_3_memory_read_enable : boolean;
  signal slice0cost_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_3_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(21 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(21 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(6 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(6 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(7 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice4_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice4_best_tag_valid and slice4_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice4_best_tag_start_of_frame and slice4_best_tag_valid and slice4_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice4_best_tag_end_of_line and slice4_best_tag_valid and slice4_best_tag_output_column);

  slice4window_leaving_10_memory_read_enable <= true;
  slice4window_leaving_10_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_10_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_10_memory_write_data <= to_unsigned(slice4cost_column_0_20, 11);
  slice4window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_10_memory_read_enable,
      read_address => slice4window_leaving_10_memory_read_address, read_data => slice4window_leaving_10,
      write_address => slice4window_leaving_10_memory_write_address, write_data => slice4window_leaving_10_memory_write_data);

  slice4window_leaving_9_memory_read_enable <= true;
  slice4window_leaving_9_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_9_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_9_memory_write_data <= to_unsigned(slice4cost_column_0_19, 11) & to_unsigned(slice4cost_column_0_18, 11);
  slice4window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_9_memory_read_enable,
      read_address => slice4window_leaving_9_memory_read_address, read_data => slice4window_leaving_9,
      write_address => slice4window_leaving_9_memory_write_address, write_data => slice4window_leaving_9_memory_write_data);

  slice4window_leaving_8_memory_read_enable <= true;
  slice4window_leaving_8_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_8_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_8_memory_write_data <= to_unsigned(slice4cost_column_0_17, 11) & to_unsigned(slice4cost_column_0_16, 11);
  slice4window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_8_memory_read_enable,
      read_address => slice4window_leaving_8_memory_read_address, read_data => slice4window_leaving_8,
      write_address => slice4window_leaving_8_memory_write_address, write_data => slice4window_leaving_8_memory_write_data);

  slice4window_leaving_7_memory_read_enable <= true;
  slice4window_leaving_7_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_7_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_7_memory_write_data <= to_unsigned(slice4cost_column_0_15, 11) & to_unsigned(slice4cost_column_0_14, 11);
  slice4window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_7_memory_read_enable,
      read_address => slice4window_leaving_7_memory_read_address, read_data => slice4window_leaving_7,
      write_address => slice4window_leaving_7_memory_write_address, write_data => slice4window_leaving_7_memory_write_data);

  slice4window_leaving_6_memory_read_enable <= true;
  slice4window_leaving_6_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_6_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_6_memory_write_data <= to_unsigned(slice4cost_column_0_13, 11) & to_unsigned(slice4cost_column_0_12, 11);
  slice4window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_6_memory_read_enable,
      read_address => slice4window_leaving_6_memory_read_address, read_data => slice4window_leaving_6,
      write_address => slice4window_leaving_6_memory_write_address, write_data => slice4window_leaving_6_memory_write_data);

  slice4window_leaving_5_memory_read_enable <= true;
  slice4window_leaving_5_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_5_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_5_memory_write_data <= to_unsigned(slice4cost_column_0_11, 11) & to_unsigned(slice4cost_column_0_10, 11);
  slice4window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_5_memory_read_enable,
      read_address => slice4window_leaving_5_memory_read_address, read_data => slice4window_leaving_5,
      write_address => slice4window_leaving_5_memory_write_address, write_data => slice4window_leaving_5_memory_write_data);

  slice4window_leaving_4_memory_read_enable <= true;
  slice4window_leaving_4_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_4_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_4_memory_write_data <= to_unsigned(slice4cost_column_0_9, 11) & to_unsigned(slice4cost_column_0_8, 11);
  slice4window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_4_memory_read_enable,
      read_address => slice4window_leaving_4_memory_read_address, read_data => slice4window_leaving_4,
      write_address => slice4window_leaving_4_memory_write_address, write_data => slice4window_leaving_4_memory_write_data);

  slice4window_leaving_3_memory_read_enable <= true;
  slice4window_leaving_3_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_3_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_3_memory_write_data <= to_unsigned(slice4cost_column_0_7, 11) & to_unsigned(slice4cost_column_0_6, 11);
  slice4window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_3_memory_read_enable,
      read_address => slice4window_leaving_3_memory_read_address, read_data => slice4window_leaving_3,
      write_address => slice4window_leaving_3_memory_write_address, write_data => slice4window_leaving_3_memory_write_data);

  slice4window_leaving_2_memory_read_enable <= true;
  slice4window_leaving_2_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_2_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_2_memory_write_data <= to_unsigned(slice4cost_column_0_5, 11) & to_unsigned(slice4cost_column_0_4, 11);
  slice4window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_2_memory_read_enable,
      read_address => slice4window_leaving_2_memory_read_address, read_data => slice4window_leaving_2,
      write_address => slice4window_leaving_2_memory_write_address, write_data => slice4window_leaving_2_memory_write_data);

  slice4window_leaving_1_memory_read_enable <= true;
  slice4window_leaving_1_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_1_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_1_memory_write_data <= to_unsigned(slice4cost_column_0_3, 11) & to_unsigned(slice4cost_column_0_2, 11);
  slice4window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_1_memory_read_enable,
      read_address => slice4window_leaving_1_memory_read_address, read_data => slice4window_leaving_1,
      write_address => slice4window_leaving_1_memory_write_address, write_data => slice4window_leaving_1_memory_write_data);

  slice4window_leaving_0_memory_read_enable <= true;
  slice4window_leaving_0_memory_read_address <= to_unsigned(slice4window_ring_read_address, 3);
  slice4window_leaving_0_memory_write_address <= to_unsigned(slice4window_ring_write_address, 3);
  slice4window_leaving_0_memory_write_data <= to_unsigned(slice4cost_column_0_1, 11) & to_unsigned(slice4cost_column_0_0, 11);
  slice4window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice4window_leaving_0_memory_read_enable,
      read_address => slice4window_leaving_0_memory_read_address, read_data => slice4window_leaving_0,
      write_address => slice4window_leaving_0_memory_write_address, write_data => slice4window_leaving_0_memory_write_data);

  slice4cost_read_words_10_memory_read_enable <= true;
  slice4cost_read_words_10_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_10_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_10_memory_write_data <= to_unsigned(slice4cost_write_words_10, 11);
  slice4cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 320, width => 11, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_10_memory_read_enable,
      read_address => slice4cost_read_words_10_memory_read_address, read_data => slice4cost_read_words_10,
      write_address => slice4cost_read_words_10_memory_write_address, write_data => slice4cost_read_words_10_memory_write_data);

  slice4cost_read_words_9_memory_read_enable <= true;
  slice4cost_read_words_9_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_9_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_9_memory_write_data <= to_unsigned(slice4cost_write_words_9, 22);
  slice4cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_9_memory_read_enable,
      read_address => slice4cost_read_words_9_memory_read_address, read_data => slice4cost_read_words_9,
      write_address => slice4cost_read_words_9_memory_write_address, write_data => slice4cost_read_words_9_memory_write_data);

  slice4cost_read_words_8_memory_read_enable <= true;
  slice4cost_read_words_8_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_8_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_8_memory_write_data <= to_unsigned(slice4cost_write_words_8, 22);
  slice4cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_8_memory_read_enable,
      read_address => slice4cost_read_words_8_memory_read_address, read_data => slice4cost_read_words_8,
      write_address => slice4cost_read_words_8_memory_write_address, write_data => slice4cost_read_words_8_memory_write_data);

  slice4cost_read_words_7_memory_read_enable <= true;
  slice4cost_read_words_7_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_7_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_7_memory_write_data <= to_unsigned(slice4cost_write_words_7, 22);
  slice4cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_7_memory_read_enable,
      read_address => slice4cost_read_words_7_memory_read_address, read_data => slice4cost_read_words_7,
      write_address => slice4cost_read_words_7_memory_write_address, write_data => slice4cost_read_words_7_memory_write_data);

  slice4cost_read_words_6_memory_read_enable <= true;
  slice4cost_read_words_6_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_6_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_6_memory_write_data <= to_unsigned(slice4cost_write_words_6, 22);
  slice4cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_6_memory_read_enable,
      read_address => slice4cost_read_words_6_memory_read_address, read_data => slice4cost_read_words_6,
      write_address => slice4cost_read_words_6_memory_write_address, write_data => slice4cost_read_words_6_memory_write_data);

  slice4cost_read_words_5_memory_read_enable <= true;
  slice4cost_read_words_5_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_5_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_5_memory_write_data <= to_unsigned(slice4cost_write_words_5, 22);
  slice4cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_5_memory_read_enable,
      read_address => slice4cost_read_words_5_memory_read_address, read_data => slice4cost_read_words_5,
      write_address => slice4cost_read_words_5_memory_write_address, write_data => slice4cost_read_words_5_memory_write_data);

  slice4cost_read_words_4_memory_read_enable <= true;
  slice4cost_read_words_4_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_4_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_4_memory_write_data <= to_unsigned(slice4cost_write_words_4, 22);
  slice4cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_4_memory_read_enable,
      read_address => slice4cost_read_words_4_memory_read_address, read_data => slice4cost_read_words_4,
      write_address => slice4cost_read_words_4_memory_write_address, write_data => slice4cost_read_words_4_memory_write_data);

  slice4cost_read_words_3_memory_read_enable <= true;
  slice4cost_read_words_3_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_3_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_3_memory_write_data <= to_unsigned(slice4cost_write_words_3, 22);
  slice4cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_3_memory_read_enable,
      read_address => slice4cost_read_words_3_memory_read_address, read_data => slice4cost_read_words_3,
      write_address => slice4cost_read_words_3_memory_write_address, write_data => slice4cost_read_words_3_memory_write_data);

  slice4cost_read_words_2_memory_read_enable <= true;
  slice4cost_read_words_2_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_2_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_2_memory_write_data <= to_unsigned(slice4cost_write_words_2, 22);
  slice4cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_2_memory_read_enable,
      read_address => slice4cost_read_words_2_memory_read_address, read_data => slice4cost_read_words_2,
      write_address => slice4cost_read_words_2_memory_write_address, write_data => slice4cost_read_words_2_memory_write_data);

  slice4cost_read_words_1_memory_read_enable <= true;
  slice4cost_read_words_1_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_1_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_1_memory_write_data <= to_unsigned(slice4cost_write_words_1, 22);
  slice4cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_1_memory_read_enable,
      read_address => slice4cost_read_words_1_memory_read_address, read_data => slice4cost_read_words_1,
      write_address => slice4cost_read_words_1_memory_write_address, write_data => slice4cost_read_words_1_memory_write_data);

  slice4cost_read_words_0_memory_read_enable <= true;
  slice4cost_read_words_0_memory_read_address <= to_unsigned(slice3cost_change_column, 9);
  slice4cost_read_words_0_memory_write_address <= to_unsigned(slice4cost_write_column, 9);
  slice4cost_read_words_0_memory_write_data <= to_unsigned(slice4cost_write_words_0, 22);
  slice4cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice4cost_read_words_0_memory_read_enable,
      read_address => slice4cost_read_words_0_memory_read_address, read_data => slice4cost_read_words_0,
      write_address => slice4cost_read_words_0_memory_write_address, write_data => slice4cost_read_words_0_memory_write_data);

  slice3window_leaving_12_memory_read_enable <= true;
  slice3window_leaving_12_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_12_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_12_memory_write_data <= to_unsigned(slice3cost_column_0_24, 11);
  slice3window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_12_memory_read_enable,
      read_address => slice3window_leaving_12_memory_read_address, read_data => slice3window_leaving_12,
      write_address => slice3window_leaving_12_memory_write_address, write_data => slice3window_leaving_12_memory_write_data);

  slice3window_leaving_11_memory_read_enable <= true;
  slice3window_leaving_11_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_11_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_11_memory_write_data <= to_unsigned(slice3cost_column_0_23, 11) & to_unsigned(slice3cost_column_0_22, 11);
  slice3window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_11_memory_read_enable,
      read_address => slice3window_leaving_11_memory_read_address, read_data => slice3window_leaving_11,
      write_address => slice3window_leaving_11_memory_write_address, write_data => slice3window_leaving_11_memory_write_data);

  slice3window_leaving_10_memory_read_enable <= true;
  slice3window_leaving_10_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_10_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_10_memory_write_data <= to_unsigned(slice3cost_column_0_21, 11) & to_unsigned(slice3cost_column_0_20, 11);
  slice3window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_10_memory_read_enable,
      read_address => slice3window_leaving_10_memory_read_address, read_data => slice3window_leaving_10,
      write_address => slice3window_leaving_10_memory_write_address, write_data => slice3window_leaving_10_memory_write_data);

  slice3window_leaving_9_memory_read_enable <= true;
  slice3window_leaving_9_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_9_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_9_memory_write_data <= to_unsigned(slice3cost_column_0_19, 11) & to_unsigned(slice3cost_column_0_18, 11);
  slice3window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_9_memory_read_enable,
      read_address => slice3window_leaving_9_memory_read_address, read_data => slice3window_leaving_9,
      write_address => slice3window_leaving_9_memory_write_address, write_data => slice3window_leaving_9_memory_write_data);

  slice3window_leaving_8_memory_read_enable <= true;
  slice3window_leaving_8_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_8_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_8_memory_write_data <= to_unsigned(slice3cost_column_0_17, 11) & to_unsigned(slice3cost_column_0_16, 11);
  slice3window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_8_memory_read_enable,
      read_address => slice3window_leaving_8_memory_read_address, read_data => slice3window_leaving_8,
      write_address => slice3window_leaving_8_memory_write_address, write_data => slice3window_leaving_8_memory_write_data);

  slice3window_leaving_7_memory_read_enable <= true;
  slice3window_leaving_7_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_7_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_7_memory_write_data <= to_unsigned(slice3cost_column_0_15, 11) & to_unsigned(slice3cost_column_0_14, 11);
  slice3window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_7_memory_read_enable,
      read_address => slice3window_leaving_7_memory_read_address, read_data => slice3window_leaving_7,
      write_address => slice3window_leaving_7_memory_write_address, write_data => slice3window_leaving_7_memory_write_data);

  slice3window_leaving_6_memory_read_enable <= true;
  slice3window_leaving_6_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_6_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_6_memory_write_data <= to_unsigned(slice3cost_column_0_13, 11) & to_unsigned(slice3cost_column_0_12, 11);
  slice3window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_6_memory_read_enable,
      read_address => slice3window_leaving_6_memory_read_address, read_data => slice3window_leaving_6,
      write_address => slice3window_leaving_6_memory_write_address, write_data => slice3window_leaving_6_memory_write_data);

  slice3window_leaving_5_memory_read_enable <= true;
  slice3window_leaving_5_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_5_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_5_memory_write_data <= to_unsigned(slice3cost_column_0_11, 11) & to_unsigned(slice3cost_column_0_10, 11);
  slice3window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_5_memory_read_enable,
      read_address => slice3window_leaving_5_memory_read_address, read_data => slice3window_leaving_5,
      write_address => slice3window_leaving_5_memory_write_address, write_data => slice3window_leaving_5_memory_write_data);

  slice3window_leaving_4_memory_read_enable <= true;
  slice3window_leaving_4_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_4_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_4_memory_write_data <= to_unsigned(slice3cost_column_0_9, 11) & to_unsigned(slice3cost_column_0_8, 11);
  slice3window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_4_memory_read_enable,
      read_address => slice3window_leaving_4_memory_read_address, read_data => slice3window_leaving_4,
      write_address => slice3window_leaving_4_memory_write_address, write_data => slice3window_leaving_4_memory_write_data);

  slice3window_leaving_3_memory_read_enable <= true;
  slice3window_leaving_3_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_3_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_3_memory_write_data <= to_unsigned(slice3cost_column_0_7, 11) & to_unsigned(slice3cost_column_0_6, 11);
  slice3window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_3_memory_read_enable,
      read_address => slice3window_leaving_3_memory_read_address, read_data => slice3window_leaving_3,
      write_address => slice3window_leaving_3_memory_write_address, write_data => slice3window_leaving_3_memory_write_data);

  slice3window_leaving_2_memory_read_enable <= true;
  slice3window_leaving_2_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_2_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_2_memory_write_data <= to_unsigned(slice3cost_column_0_5, 11) & to_unsigned(slice3cost_column_0_4, 11);
  slice3window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_2_memory_read_enable,
      read_address => slice3window_leaving_2_memory_read_address, read_data => slice3window_leaving_2,
      write_address => slice3window_leaving_2_memory_write_address, write_data => slice3window_leaving_2_memory_write_data);

  slice3window_leaving_1_memory_read_enable <= true;
  slice3window_leaving_1_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_1_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_1_memory_write_data <= to_unsigned(slice3cost_column_0_3, 11) & to_unsigned(slice3cost_column_0_2, 11);
  slice3window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_1_memory_read_enable,
      read_address => slice3window_leaving_1_memory_read_address, read_data => slice3window_leaving_1,
      write_address => slice3window_leaving_1_memory_write_address, write_data => slice3window_leaving_1_memory_write_data);

  slice3window_leaving_0_memory_read_enable <= true;
  slice3window_leaving_0_memory_read_address <= to_unsigned(slice3window_ring_read_address, 3);
  slice3window_leaving_0_memory_write_address <= to_unsigned(slice3window_ring_write_address, 3);
  slice3window_leaving_0_memory_write_data <= to_unsigned(slice3cost_column_0_1, 11) & to_unsigned(slice3cost_column_0_0, 11);
  slice3window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice3window_leaving_0_memory_read_enable,
      read_address => slice3window_leaving_0_memory_read_address, read_data => slice3window_leaving_0,
      write_address => slice3window_leaving_0_memory_write_address, write_data => slice3window_leaving_0_memory_write_data);

  slice3cost_read_words_12_memory_read_enable <= true;
  slice3cost_read_words_12_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_12_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_12_memory_write_data <= to_unsigned(slice3cost_write_words_12, 11);
  slice3cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 320, width => 11, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_12_memory_read_enable,
      read_address => slice3cost_read_words_12_memory_read_address, read_data => slice3cost_read_words_12,
      write_address => slice3cost_read_words_12_memory_write_address, write_data => slice3cost_read_words_12_memory_write_data);

  slice3cost_read_words_11_memory_read_enable <= true;
  slice3cost_read_words_11_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_11_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_11_memory_write_data <= to_unsigned(slice3cost_write_words_11, 22);
  slice3cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_11_memory_read_enable,
      read_address => slice3cost_read_words_11_memory_read_address, read_data => slice3cost_read_words_11,
      write_address => slice3cost_read_words_11_memory_write_address, write_data => slice3cost_read_words_11_memory_write_data);

  slice3cost_read_words_10_memory_read_enable <= true;
  slice3cost_read_words_10_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_10_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_10_memory_write_data <= to_unsigned(slice3cost_write_words_10, 22);
  slice3cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_10_memory_read_enable,
      read_address => slice3cost_read_words_10_memory_read_address, read_data => slice3cost_read_words_10,
      write_address => slice3cost_read_words_10_memory_write_address, write_data => slice3cost_read_words_10_memory_write_data);

  slice3cost_read_words_9_memory_read_enable <= true;
  slice3cost_read_words_9_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_9_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_9_memory_write_data <= to_unsigned(slice3cost_write_words_9, 22);
  slice3cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_9_memory_read_enable,
      read_address => slice3cost_read_words_9_memory_read_address, read_data => slice3cost_read_words_9,
      write_address => slice3cost_read_words_9_memory_write_address, write_data => slice3cost_read_words_9_memory_write_data);

  slice3cost_read_words_8_memory_read_enable <= true;
  slice3cost_read_words_8_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_8_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_8_memory_write_data <= to_unsigned(slice3cost_write_words_8, 22);
  slice3cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_8_memory_read_enable,
      read_address => slice3cost_read_words_8_memory_read_address, read_data => slice3cost_read_words_8,
      write_address => slice3cost_read_words_8_memory_write_address, write_data => slice3cost_read_words_8_memory_write_data);

  slice3cost_read_words_7_memory_read_enable <= true;
  slice3cost_read_words_7_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_7_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_7_memory_write_data <= to_unsigned(slice3cost_write_words_7, 22);
  slice3cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_7_memory_read_enable,
      read_address => slice3cost_read_words_7_memory_read_address, read_data => slice3cost_read_words_7,
      write_address => slice3cost_read_words_7_memory_write_address, write_data => slice3cost_read_words_7_memory_write_data);

  slice3cost_read_words_6_memory_read_enable <= true;
  slice3cost_read_words_6_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_6_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_6_memory_write_data <= to_unsigned(slice3cost_write_words_6, 22);
  slice3cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_6_memory_read_enable,
      read_address => slice3cost_read_words_6_memory_read_address, read_data => slice3cost_read_words_6,
      write_address => slice3cost_read_words_6_memory_write_address, write_data => slice3cost_read_words_6_memory_write_data);

  slice3cost_read_words_5_memory_read_enable <= true;
  slice3cost_read_words_5_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_5_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_5_memory_write_data <= to_unsigned(slice3cost_write_words_5, 22);
  slice3cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_5_memory_read_enable,
      read_address => slice3cost_read_words_5_memory_read_address, read_data => slice3cost_read_words_5,
      write_address => slice3cost_read_words_5_memory_write_address, write_data => slice3cost_read_words_5_memory_write_data);

  slice3cost_read_words_4_memory_read_enable <= true;
  slice3cost_read_words_4_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_4_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_4_memory_write_data <= to_unsigned(slice3cost_write_words_4, 22);
  slice3cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_4_memory_read_enable,
      read_address => slice3cost_read_words_4_memory_read_address, read_data => slice3cost_read_words_4,
      write_address => slice3cost_read_words_4_memory_write_address, write_data => slice3cost_read_words_4_memory_write_data);

  slice3cost_read_words_3_memory_read_enable <= true;
  slice3cost_read_words_3_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_3_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_3_memory_write_data <= to_unsigned(slice3cost_write_words_3, 22);
  slice3cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_3_memory_read_enable,
      read_address => slice3cost_read_words_3_memory_read_address, read_data => slice3cost_read_words_3,
      write_address => slice3cost_read_words_3_memory_write_address, write_data => slice3cost_read_words_3_memory_write_data);

  slice3cost_read_words_2_memory_read_enable <= true;
  slice3cost_read_words_2_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_2_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_2_memory_write_data <= to_unsigned(slice3cost_write_words_2, 22);
  slice3cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_2_memory_read_enable,
      read_address => slice3cost_read_words_2_memory_read_address, read_data => slice3cost_read_words_2,
      write_address => slice3cost_read_words_2_memory_write_address, write_data => slice3cost_read_words_2_memory_write_data);

  slice3cost_read_words_1_memory_read_enable <= true;
  slice3cost_read_words_1_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_1_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_1_memory_write_data <= to_unsigned(slice3cost_write_words_1, 22);
  slice3cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_1_memory_read_enable,
      read_address => slice3cost_read_words_1_memory_read_address, read_data => slice3cost_read_words_1,
      write_address => slice3cost_read_words_1_memory_write_address, write_data => slice3cost_read_words_1_memory_write_data);

  slice3cost_read_words_0_memory_read_enable <= true;
  slice3cost_read_words_0_memory_read_address <= to_unsigned(slice3cost_read_column, 9);
  slice3cost_read_words_0_memory_write_address <= to_unsigned(slice4cost_ready_column, 9);
  slice3cost_read_words_0_memory_write_data <= to_unsigned(slice3cost_write_words_0, 22);
  slice3cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice3cost_read_words_0_memory_read_enable,
      read_address => slice3cost_read_words_0_memory_read_address, read_data => slice3cost_read_words_0,
      write_address => slice3cost_read_words_0_memory_write_address, write_data => slice3cost_read_words_0_memory_write_data);

  slice2window_leaving_12_memory_read_enable <= true;
  slice2window_leaving_12_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_12_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_12_memory_write_data <= to_unsigned(slice2cost_column_0_24, 11);
  slice2window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_12_memory_read_enable,
      read_address => slice2window_leaving_12_memory_read_address, read_data => slice2window_leaving_12,
      write_address => slice2window_leaving_12_memory_write_address, write_data => slice2window_leaving_12_memory_write_data);

  slice2window_leaving_11_memory_read_enable <= true;
  slice2window_leaving_11_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_11_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_11_memory_write_data <= to_unsigned(slice2cost_column_0_23, 11) & to_unsigned(slice2cost_column_0_22, 11);
  slice2window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_11_memory_read_enable,
      read_address => slice2window_leaving_11_memory_read_address, read_data => slice2window_leaving_11,
      write_address => slice2window_leaving_11_memory_write_address, write_data => slice2window_leaving_11_memory_write_data);

  slice2window_leaving_10_memory_read_enable <= true;
  slice2window_leaving_10_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_10_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_10_memory_write_data <= to_unsigned(slice2cost_column_0_21, 11) & to_unsigned(slice2cost_column_0_20, 11);
  slice2window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_10_memory_read_enable,
      read_address => slice2window_leaving_10_memory_read_address, read_data => slice2window_leaving_10,
      write_address => slice2window_leaving_10_memory_write_address, write_data => slice2window_leaving_10_memory_write_data);

  slice2window_leaving_9_memory_read_enable <= true;
  slice2window_leaving_9_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_9_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_9_memory_write_data <= to_unsigned(slice2cost_column_0_19, 11) & to_unsigned(slice2cost_column_0_18, 11);
  slice2window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_9_memory_read_enable,
      read_address => slice2window_leaving_9_memory_read_address, read_data => slice2window_leaving_9,
      write_address => slice2window_leaving_9_memory_write_address, write_data => slice2window_leaving_9_memory_write_data);

  slice2window_leaving_8_memory_read_enable <= true;
  slice2window_leaving_8_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_8_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_8_memory_write_data <= to_unsigned(slice2cost_column_0_17, 11) & to_unsigned(slice2cost_column_0_16, 11);
  slice2window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_8_memory_read_enable,
      read_address => slice2window_leaving_8_memory_read_address, read_data => slice2window_leaving_8,
      write_address => slice2window_leaving_8_memory_write_address, write_data => slice2window_leaving_8_memory_write_data);

  slice2window_leaving_7_memory_read_enable <= true;
  slice2window_leaving_7_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_7_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_7_memory_write_data <= to_unsigned(slice2cost_column_0_15, 11) & to_unsigned(slice2cost_column_0_14, 11);
  slice2window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_7_memory_read_enable,
      read_address => slice2window_leaving_7_memory_read_address, read_data => slice2window_leaving_7,
      write_address => slice2window_leaving_7_memory_write_address, write_data => slice2window_leaving_7_memory_write_data);

  slice2window_leaving_6_memory_read_enable <= true;
  slice2window_leaving_6_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_6_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_6_memory_write_data <= to_unsigned(slice2cost_column_0_13, 11) & to_unsigned(slice2cost_column_0_12, 11);
  slice2window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_6_memory_read_enable,
      read_address => slice2window_leaving_6_memory_read_address, read_data => slice2window_leaving_6,
      write_address => slice2window_leaving_6_memory_write_address, write_data => slice2window_leaving_6_memory_write_data);

  slice2window_leaving_5_memory_read_enable <= true;
  slice2window_leaving_5_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_5_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_5_memory_write_data <= to_unsigned(slice2cost_column_0_11, 11) & to_unsigned(slice2cost_column_0_10, 11);
  slice2window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_5_memory_read_enable,
      read_address => slice2window_leaving_5_memory_read_address, read_data => slice2window_leaving_5,
      write_address => slice2window_leaving_5_memory_write_address, write_data => slice2window_leaving_5_memory_write_data);

  slice2window_leaving_4_memory_read_enable <= true;
  slice2window_leaving_4_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_4_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_4_memory_write_data <= to_unsigned(slice2cost_column_0_9, 11) & to_unsigned(slice2cost_column_0_8, 11);
  slice2window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_4_memory_read_enable,
      read_address => slice2window_leaving_4_memory_read_address, read_data => slice2window_leaving_4,
      write_address => slice2window_leaving_4_memory_write_address, write_data => slice2window_leaving_4_memory_write_data);

  slice2window_leaving_3_memory_read_enable <= true;
  slice2window_leaving_3_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_3_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_3_memory_write_data <= to_unsigned(slice2cost_column_0_7, 11) & to_unsigned(slice2cost_column_0_6, 11);
  slice2window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_3_memory_read_enable,
      read_address => slice2window_leaving_3_memory_read_address, read_data => slice2window_leaving_3,
      write_address => slice2window_leaving_3_memory_write_address, write_data => slice2window_leaving_3_memory_write_data);

  slice2window_leaving_2_memory_read_enable <= true;
  slice2window_leaving_2_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_2_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_2_memory_write_data <= to_unsigned(slice2cost_column_0_5, 11) & to_unsigned(slice2cost_column_0_4, 11);
  slice2window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_2_memory_read_enable,
      read_address => slice2window_leaving_2_memory_read_address, read_data => slice2window_leaving_2,
      write_address => slice2window_leaving_2_memory_write_address, write_data => slice2window_leaving_2_memory_write_data);

  slice2window_leaving_1_memory_read_enable <= true;
  slice2window_leaving_1_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_1_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_1_memory_write_data <= to_unsigned(slice2cost_column_0_3, 11) & to_unsigned(slice2cost_column_0_2, 11);
  slice2window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_1_memory_read_enable,
      read_address => slice2window_leaving_1_memory_read_address, read_data => slice2window_leaving_1,
      write_address => slice2window_leaving_1_memory_write_address, write_data => slice2window_leaving_1_memory_write_data);

  slice2window_leaving_0_memory_read_enable <= true;
  slice2window_leaving_0_memory_read_address <= to_unsigned(slice2window_ring_read_address, 3);
  slice2window_leaving_0_memory_write_address <= to_unsigned(slice2window_ring_write_address, 3);
  slice2window_leaving_0_memory_write_data <= to_unsigned(slice2cost_column_0_1, 11) & to_unsigned(slice2cost_column_0_0, 11);
  slice2window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice2window_leaving_0_memory_read_enable,
      read_address => slice2window_leaving_0_memory_read_address, read_data => slice2window_leaving_0,
      write_address => slice2window_leaving_0_memory_write_address, write_data => slice2window_leaving_0_memory_write_data);

  slice2cost_read_words_12_memory_read_enable <= true;
  slice2cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_12_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_12_memory_write_data <= to_unsigned(slice2cost_write_words_12, 11);
  slice2cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 320, width => 11, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_12_memory_read_enable,
      read_address => slice2cost_read_words_12_memory_read_address, read_data => slice2cost_read_words_12,
      write_address => slice2cost_read_words_12_memory_write_address, write_data => slice2cost_read_words_12_memory_write_data);

  slice2cost_read_words_11_memory_read_enable <= true;
  slice2cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_11_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_11_memory_write_data <= to_unsigned(slice2cost_write_words_11, 22);
  slice2cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_11_memory_read_enable,
      read_address => slice2cost_read_words_11_memory_read_address, read_data => slice2cost_read_words_11,
      write_address => slice2cost_read_words_11_memory_write_address, write_data => slice2cost_read_words_11_memory_write_data);

  slice2cost_read_words_10_memory_read_enable <= true;
  slice2cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_10_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_10_memory_write_data <= to_unsigned(slice2cost_write_words_10, 22);
  slice2cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_10_memory_read_enable,
      read_address => slice2cost_read_words_10_memory_read_address, read_data => slice2cost_read_words_10,
      write_address => slice2cost_read_words_10_memory_write_address, write_data => slice2cost_read_words_10_memory_write_data);

  slice2cost_read_words_9_memory_read_enable <= true;
  slice2cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_9_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_9_memory_write_data <= to_unsigned(slice2cost_write_words_9, 22);
  slice2cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_9_memory_read_enable,
      read_address => slice2cost_read_words_9_memory_read_address, read_data => slice2cost_read_words_9,
      write_address => slice2cost_read_words_9_memory_write_address, write_data => slice2cost_read_words_9_memory_write_data);

  slice2cost_read_words_8_memory_read_enable <= true;
  slice2cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_8_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_8_memory_write_data <= to_unsigned(slice2cost_write_words_8, 22);
  slice2cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_8_memory_read_enable,
      read_address => slice2cost_read_words_8_memory_read_address, read_data => slice2cost_read_words_8,
      write_address => slice2cost_read_words_8_memory_write_address, write_data => slice2cost_read_words_8_memory_write_data);

  slice2cost_read_words_7_memory_read_enable <= true;
  slice2cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_7_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_7_memory_write_data <= to_unsigned(slice2cost_write_words_7, 22);
  slice2cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_7_memory_read_enable,
      read_address => slice2cost_read_words_7_memory_read_address, read_data => slice2cost_read_words_7,
      write_address => slice2cost_read_words_7_memory_write_address, write_data => slice2cost_read_words_7_memory_write_data);

  slice2cost_read_words_6_memory_read_enable <= true;
  slice2cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_6_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_6_memory_write_data <= to_unsigned(slice2cost_write_words_6, 22);
  slice2cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_6_memory_read_enable,
      read_address => slice2cost_read_words_6_memory_read_address, read_data => slice2cost_read_words_6,
      write_address => slice2cost_read_words_6_memory_write_address, write_data => slice2cost_read_words_6_memory_write_data);

  slice2cost_read_words_5_memory_read_enable <= true;
  slice2cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_5_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_5_memory_write_data <= to_unsigned(slice2cost_write_words_5, 22);
  slice2cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_5_memory_read_enable,
      read_address => slice2cost_read_words_5_memory_read_address, read_data => slice2cost_read_words_5,
      write_address => slice2cost_read_words_5_memory_write_address, write_data => slice2cost_read_words_5_memory_write_data);

  slice2cost_read_words_4_memory_read_enable <= true;
  slice2cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_4_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_4_memory_write_data <= to_unsigned(slice2cost_write_words_4, 22);
  slice2cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_4_memory_read_enable,
      read_address => slice2cost_read_words_4_memory_read_address, read_data => slice2cost_read_words_4,
      write_address => slice2cost_read_words_4_memory_write_address, write_data => slice2cost_read_words_4_memory_write_data);

  slice2cost_read_words_3_memory_read_enable <= true;
  slice2cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_3_memory_write_data <= to_unsigned(slice2cost_write_words_3, 22);
  slice2cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_3_memory_read_enable,
      read_address => slice2cost_read_words_3_memory_read_address, read_data => slice2cost_read_words_3,
      write_address => slice2cost_read_words_3_memory_write_address, write_data => slice2cost_read_words_3_memory_write_data);

  slice2cost_read_words_2_memory_read_enable <= true;
  slice2cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_2_memory_write_data <= to_unsigned(slice2cost_write_words_2, 22);
  slice2cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_2_memory_read_enable,
      read_address => slice2cost_read_words_2_memory_read_address, read_data => slice2cost_read_words_2,
      write_address => slice2cost_read_words_2_memory_write_address, write_data => slice2cost_read_words_2_memory_write_data);

  slice2cost_read_words_1_memory_read_enable <= true;
  slice2cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_1_memory_write_data <= to_unsigned(slice2cost_write_words_1, 22);
  slice2cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_1_memory_read_enable,
      read_address => slice2cost_read_words_1_memory_read_address, read_data => slice2cost_read_words_1,
      write_address => slice2cost_read_words_1_memory_write_address, write_data => slice2cost_read_words_1_memory_write_data);

  slice2cost_read_words_0_memory_read_enable <= true;
  slice2cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_ready_column, 9);
  slice2cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_write_column, 9);
  slice2cost_read_words_0_memory_write_data <= to_unsigned(slice2cost_write_words_0, 22);
  slice2cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice2cost_read_words_0_memory_read_enable,
      read_address => slice2cost_read_words_0_memory_read_address, read_data => slice2cost_read_words_0,
      write_address => slice2cost_read_words_0_memory_write_address, write_data => slice2cost_read_words_0_memory_write_data);

  slice1window_leaving_12_memory_read_enable <= true;
  slice1window_leaving_12_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_12_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_12_memory_write_data <= to_unsigned(slice1cost_column_0_24, 11);
  slice1window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_12_memory_read_enable,
      read_address => slice1window_leaving_12_memory_read_address, read_data => slice1window_leaving_12,
      write_address => slice1window_leaving_12_memory_write_address, write_data => slice1window_leaving_12_memory_write_data);

  slice1window_leaving_11_memory_read_enable <= true;
  slice1window_leaving_11_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_11_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_11_memory_write_data <= to_unsigned(slice1cost_column_0_23, 11) & to_unsigned(slice1cost_column_0_22, 11);
  slice1window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_11_memory_read_enable,
      read_address => slice1window_leaving_11_memory_read_address, read_data => slice1window_leaving_11,
      write_address => slice1window_leaving_11_memory_write_address, write_data => slice1window_leaving_11_memory_write_data);

  slice1window_leaving_10_memory_read_enable <= true;
  slice1window_leaving_10_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_10_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_10_memory_write_data <= to_unsigned(slice1cost_column_0_21, 11) & to_unsigned(slice1cost_column_0_20, 11);
  slice1window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_10_memory_read_enable,
      read_address => slice1window_leaving_10_memory_read_address, read_data => slice1window_leaving_10,
      write_address => slice1window_leaving_10_memory_write_address, write_data => slice1window_leaving_10_memory_write_data);

  slice1window_leaving_9_memory_read_enable <= true;
  slice1window_leaving_9_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_9_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_9_memory_write_data <= to_unsigned(slice1cost_column_0_19, 11) & to_unsigned(slice1cost_column_0_18, 11);
  slice1window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_9_memory_read_enable,
      read_address => slice1window_leaving_9_memory_read_address, read_data => slice1window_leaving_9,
      write_address => slice1window_leaving_9_memory_write_address, write_data => slice1window_leaving_9_memory_write_data);

  slice1window_leaving_8_memory_read_enable <= true;
  slice1window_leaving_8_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_8_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_8_memory_write_data <= to_unsigned(slice1cost_column_0_17, 11) & to_unsigned(slice1cost_column_0_16, 11);
  slice1window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_8_memory_read_enable,
      read_address => slice1window_leaving_8_memory_read_address, read_data => slice1window_leaving_8,
      write_address => slice1window_leaving_8_memory_write_address, write_data => slice1window_leaving_8_memory_write_data);

  slice1window_leaving_7_memory_read_enable <= true;
  slice1window_leaving_7_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_7_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_7_memory_write_data <= to_unsigned(slice1cost_column_0_15, 11) & to_unsigned(slice1cost_column_0_14, 11);
  slice1window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_7_memory_read_enable,
      read_address => slice1window_leaving_7_memory_read_address, read_data => slice1window_leaving_7,
      write_address => slice1window_leaving_7_memory_write_address, write_data => slice1window_leaving_7_memory_write_data);

  slice1window_leaving_6_memory_read_enable <= true;
  slice1window_leaving_6_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_6_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_6_memory_write_data <= to_unsigned(slice1cost_column_0_13, 11) & to_unsigned(slice1cost_column_0_12, 11);
  slice1window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_6_memory_read_enable,
      read_address => slice1window_leaving_6_memory_read_address, read_data => slice1window_leaving_6,
      write_address => slice1window_leaving_6_memory_write_address, write_data => slice1window_leaving_6_memory_write_data);

  slice1window_leaving_5_memory_read_enable <= true;
  slice1window_leaving_5_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_5_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_5_memory_write_data <= to_unsigned(slice1cost_column_0_11, 11) & to_unsigned(slice1cost_column_0_10, 11);
  slice1window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_5_memory_read_enable,
      read_address => slice1window_leaving_5_memory_read_address, read_data => slice1window_leaving_5,
      write_address => slice1window_leaving_5_memory_write_address, write_data => slice1window_leaving_5_memory_write_data);

  slice1window_leaving_4_memory_read_enable <= true;
  slice1window_leaving_4_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_4_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_4_memory_write_data <= to_unsigned(slice1cost_column_0_9, 11) & to_unsigned(slice1cost_column_0_8, 11);
  slice1window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_4_memory_read_enable,
      read_address => slice1window_leaving_4_memory_read_address, read_data => slice1window_leaving_4,
      write_address => slice1window_leaving_4_memory_write_address, write_data => slice1window_leaving_4_memory_write_data);

  slice1window_leaving_3_memory_read_enable <= true;
  slice1window_leaving_3_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_3_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_3_memory_write_data <= to_unsigned(slice1cost_column_0_7, 11) & to_unsigned(slice1cost_column_0_6, 11);
  slice1window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_3_memory_read_enable,
      read_address => slice1window_leaving_3_memory_read_address, read_data => slice1window_leaving_3,
      write_address => slice1window_leaving_3_memory_write_address, write_data => slice1window_leaving_3_memory_write_data);

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0_5, 11) & to_unsigned(slice1cost_column_0_4, 11);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_3, 11) & to_unsigned(slice1cost_column_0_2, 11);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_1, 11) & to_unsigned(slice1cost_column_0_0, 11);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_12_memory_read_enable <= true;
  slice1cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_12_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_12_memory_write_data <= to_unsigned(slice1cost_write_words_12, 11);
  slice1cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 320, width => 11, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_12_memory_read_enable,
      read_address => slice1cost_read_words_12_memory_read_address, read_data => slice1cost_read_words_12,
      write_address => slice1cost_read_words_12_memory_write_address, write_data => slice1cost_read_words_12_memory_write_data);

  slice1cost_read_words_11_memory_read_enable <= true;
  slice1cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_11_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_11_memory_write_data <= to_unsigned(slice1cost_write_words_11, 22);
  slice1cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_11_memory_read_enable,
      read_address => slice1cost_read_words_11_memory_read_address, read_data => slice1cost_read_words_11,
      write_address => slice1cost_read_words_11_memory_write_address, write_data => slice1cost_read_words_11_memory_write_data);

  slice1cost_read_words_10_memory_read_enable <= true;
  slice1cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_10_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_10_memory_write_data <= to_unsigned(slice1cost_write_words_10, 22);
  slice1cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_10_memory_read_enable,
      read_address => slice1cost_read_words_10_memory_read_address, read_data => slice1cost_read_words_10,
      write_address => slice1cost_read_words_10_memory_write_address, write_data => slice1cost_read_words_10_memory_write_data);

  slice1cost_read_words_9_memory_read_enable <= true;
  slice1cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_9_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_9_memory_write_data <= to_unsigned(slice1cost_write_words_9, 22);
  slice1cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_9_memory_read_enable,
      read_address => slice1cost_read_words_9_memory_read_address, read_data => slice1cost_read_words_9,
      write_address => slice1cost_read_words_9_memory_write_address, write_data => slice1cost_read_words_9_memory_write_data);

  slice1cost_read_words_8_memory_read_enable <= true;
  slice1cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_8_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_8_memory_write_data <= to_unsigned(slice1cost_write_words_8, 22);
  slice1cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_8_memory_read_enable,
      read_address => slice1cost_read_words_8_memory_read_address, read_data => slice1cost_read_words_8,
      write_address => slice1cost_read_words_8_memory_write_address, write_data => slice1cost_read_words_8_memory_write_data);

  slice1cost_read_words_7_memory_read_enable <= true;
  slice1cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_7_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_7_memory_write_data <= to_unsigned(slice1cost_write_words_7, 22);
  slice1cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_7_memory_read_enable,
      read_address => slice1cost_read_words_7_memory_read_address, read_data => slice1cost_read_words_7,
      write_address => slice1cost_read_words_7_memory_write_address, write_data => slice1cost_read_words_7_memory_write_data);

  slice1cost_read_words_6_memory_read_enable <= true;
  slice1cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_6_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_6_memory_write_data <= to_unsigned(slice1cost_write_words_6, 22);
  slice1cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_6_memory_read_enable,
      read_address => slice1cost_read_words_6_memory_read_address, read_data => slice1cost_read_words_6,
      write_address => slice1cost_read_words_6_memory_write_address, write_data => slice1cost_read_words_6_memory_write_data);

  slice1cost_read_words_5_memory_read_enable <= true;
  slice1cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_5_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_5_memory_write_data <= to_unsigned(slice1cost_write_words_5, 22);
  slice1cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_5_memory_read_enable,
      read_address => slice1cost_read_words_5_memory_read_address, read_data => slice1cost_read_words_5,
      write_address => slice1cost_read_words_5_memory_write_address, write_data => slice1cost_read_words_5_memory_write_data);

  slice1cost_read_words_4_memory_read_enable <= true;
  slice1cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_4_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_4_memory_write_data <= to_unsigned(slice1cost_write_words_4, 22);
  slice1cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_4_memory_read_enable,
      read_address => slice1cost_read_words_4_memory_read_address, read_data => slice1cost_read_words_4,
      write_address => slice1cost_read_words_4_memory_write_address, write_data => slice1cost_read_words_4_memory_write_data);

  slice1cost_read_words_3_memory_read_enable <= true;
  slice1cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_3_memory_write_data <= to_unsigned(slice1cost_write_words_3, 22);
  slice1cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_3_memory_read_enable,
      read_address => slice1cost_read_words_3_memory_read_address, read_data => slice1cost_read_words_3,
      write_address => slice1cost_read_words_3_memory_write_address, write_data => slice1cost_read_words_3_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_2_memory_write_data <= to_unsigned(slice1cost_write_words_2, 22);
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words_2,
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words_1, 22);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_ready_column, 9);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words_0, 22);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_12_memory_read_enable <= true;
  slice0window_leaving_12_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_12_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_12_memory_write_data <= to_unsigned(slice0cost_column_0_24, 11);
  slice0window_leaving_12_memory : entity work.line_memory
    generic map (depth => 8, width => 11, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_12_memory_read_enable,
      read_address => slice0window_leaving_12_memory_read_address, read_data => slice0window_leaving_12,
      write_address => slice0window_leaving_12_memory_write_address, write_data => slice0window_leaving_12_memory_write_data);

  slice0window_leaving_11_memory_read_enable <= true;
  slice0window_leaving_11_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_11_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_11_memory_write_data <= to_unsigned(slice0cost_column_0_23, 11) & to_unsigned(slice0cost_column_0_22, 11);
  slice0window_leaving_11_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_11_memory_read_enable,
      read_address => slice0window_leaving_11_memory_read_address, read_data => slice0window_leaving_11,
      write_address => slice0window_leaving_11_memory_write_address, write_data => slice0window_leaving_11_memory_write_data);

  slice0window_leaving_10_memory_read_enable <= true;
  slice0window_leaving_10_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_10_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_10_memory_write_data <= to_unsigned(slice0cost_column_0_21, 11) & to_unsigned(slice0cost_column_0_20, 11);
  slice0window_leaving_10_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_10_memory_read_enable,
      read_address => slice0window_leaving_10_memory_read_address, read_data => slice0window_leaving_10,
      write_address => slice0window_leaving_10_memory_write_address, write_data => slice0window_leaving_10_memory_write_data);

  slice0window_leaving_9_memory_read_enable <= true;
  slice0window_leaving_9_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_9_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_9_memory_write_data <= to_unsigned(slice0cost_column_0_19, 11) & to_unsigned(slice0cost_column_0_18, 11);
  slice0window_leaving_9_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_9_memory_read_enable,
      read_address => slice0window_leaving_9_memory_read_address, read_data => slice0window_leaving_9,
      write_address => slice0window_leaving_9_memory_write_address, write_data => slice0window_leaving_9_memory_write_data);

  slice0window_leaving_8_memory_read_enable <= true;
  slice0window_leaving_8_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_8_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_8_memory_write_data <= to_unsigned(slice0cost_column_0_17, 11) & to_unsigned(slice0cost_column_0_16, 11);
  slice0window_leaving_8_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_8_memory_read_enable,
      read_address => slice0window_leaving_8_memory_read_address, read_data => slice0window_leaving_8,
      write_address => slice0window_leaving_8_memory_write_address, write_data => slice0window_leaving_8_memory_write_data);

  slice0window_leaving_7_memory_read_enable <= true;
  slice0window_leaving_7_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_7_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_7_memory_write_data <= to_unsigned(slice0cost_column_0_15, 11) & to_unsigned(slice0cost_column_0_14, 11);
  slice0window_leaving_7_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_7_memory_read_enable,
      read_address => slice0window_leaving_7_memory_read_address, read_data => slice0window_leaving_7,
      write_address => slice0window_leaving_7_memory_write_address, write_data => slice0window_leaving_7_memory_write_data);

  slice0window_leaving_6_memory_read_enable <= true;
  slice0window_leaving_6_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_6_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_6_memory_write_data <= to_unsigned(slice0cost_column_0_13, 11) & to_unsigned(slice0cost_column_0_12, 11);
  slice0window_leaving_6_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_6_memory_read_enable,
      read_address => slice0window_leaving_6_memory_read_address, read_data => slice0window_leaving_6,
      write_address => slice0window_leaving_6_memory_write_address, write_data => slice0window_leaving_6_memory_write_data);

  slice0window_leaving_5_memory_read_enable <= true;
  slice0window_leaving_5_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_5_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_5_memory_write_data <= to_unsigned(slice0cost_column_0_11, 11) & to_unsigned(slice0cost_column_0_10, 11);
  slice0window_leaving_5_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_5_memory_read_enable,
      read_address => slice0window_leaving_5_memory_read_address, read_data => slice0window_leaving_5,
      write_address => slice0window_leaving_5_memory_write_address, write_data => slice0window_leaving_5_memory_write_data);

  slice0window_leaving_4_memory_read_enable <= true;
  slice0window_leaving_4_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_4_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_4_memory_write_data <= to_unsigned(slice0cost_column_0_9, 11) & to_unsigned(slice0cost_column_0_8, 11);
  slice0window_leaving_4_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_4_memory_read_enable,
      read_address => slice0window_leaving_4_memory_read_address, read_data => slice0window_leaving_4,
      write_address => slice0window_leaving_4_memory_write_address, write_data => slice0window_leaving_4_memory_write_data);

  slice0window_leaving_3_memory_read_enable <= true;
  slice0window_leaving_3_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_3_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_3_memory_write_data <= to_unsigned(slice0cost_column_0_7, 11) & to_unsigned(slice0cost_column_0_6, 11);
  slice0window_leaving_3_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_3_memory_read_enable,
      read_address => slice0window_leaving_3_memory_read_address, read_data => slice0window_leaving_3,
      write_address => slice0window_leaving_3_memory_write_address, write_data => slice0window_leaving_3_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0_5, 11) & to_unsigned(slice0cost_column_0_4, 11);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_3, 11) & to_unsigned(slice0cost_column_0_2, 11);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_1, 11) & to_unsigned(slice0cost_column_0_0, 11);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 8, width => 22, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_12_memory_read_enable <= true;
  slice0cost_read_words_12_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_12_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_12_memory_write_data <= to_unsigned(slice0cost_write_words_12, 11);
  slice0cost_read_words_12_memory : entity work.line_memory
    generic map (depth => 320, width => 11, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_12_memory_read_enable,
      read_address => slice0cost_read_words_12_memory_read_address, read_data => slice0cost_read_words_12,
      write_address => slice0cost_read_words_12_memory_write_address, write_data => slice0cost_read_words_12_memory_write_data);

  slice0cost_read_words_11_memory_read_enable <= true;
  slice0cost_read_words_11_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_11_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_11_memory_write_data <= to_unsigned(slice0cost_write_words_11, 22);
  slice0cost_read_words_11_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_11_memory_read_enable,
      read_address => slice0cost_read_words_11_memory_read_address, read_data => slice0cost_read_words_11,
      write_address => slice0cost_read_words_11_memory_write_address, write_data => slice0cost_read_words_11_memory_write_data);

  slice0cost_read_words_10_memory_read_enable <= true;
  slice0cost_read_words_10_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_10_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_10_memory_write_data <= to_unsigned(slice0cost_write_words_10, 22);
  slice0cost_read_words_10_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_10_memory_read_enable,
      read_address => slice0cost_read_words_10_memory_read_address, read_data => slice0cost_read_words_10,
      write_address => slice0cost_read_words_10_memory_write_address, write_data => slice0cost_read_words_10_memory_write_data);

  slice0cost_read_words_9_memory_read_enable <= true;
  slice0cost_read_words_9_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_9_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_9_memory_write_data <= to_unsigned(slice0cost_write_words_9, 22);
  slice0cost_read_words_9_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_9_memory_read_enable,
      read_address => slice0cost_read_words_9_memory_read_address, read_data => slice0cost_read_words_9,
      write_address => slice0cost_read_words_9_memory_write_address, write_data => slice0cost_read_words_9_memory_write_data);

  slice0cost_read_words_8_memory_read_enable <= true;
  slice0cost_read_words_8_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_8_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_8_memory_write_data <= to_unsigned(slice0cost_write_words_8, 22);
  slice0cost_read_words_8_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_8_memory_read_enable,
      read_address => slice0cost_read_words_8_memory_read_address, read_data => slice0cost_read_words_8,
      write_address => slice0cost_read_words_8_memory_write_address, write_data => slice0cost_read_words_8_memory_write_data);

  slice0cost_read_words_7_memory_read_enable <= true;
  slice0cost_read_words_7_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_7_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_7_memory_write_data <= to_unsigned(slice0cost_write_words_7, 22);
  slice0cost_read_words_7_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_7_memory_read_enable,
      read_address => slice0cost_read_words_7_memory_read_address, read_data => slice0cost_read_words_7,
      write_address => slice0cost_read_words_7_memory_write_address, write_data => slice0cost_read_words_7_memory_write_data);

  slice0cost_read_words_6_memory_read_enable <= true;
  slice0cost_read_words_6_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_6_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_6_memory_write_data <= to_unsigned(slice0cost_write_words_6, 22);
  slice0cost_read_words_6_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_6_memory_read_enable,
      read_address => slice0cost_read_words_6_memory_read_address, read_data => slice0cost_read_words_6,
      write_address => slice0cost_read_words_6_memory_write_address, write_data => slice0cost_read_words_6_memory_write_data);

  slice0cost_read_words_5_memory_read_enable <= true;
  slice0cost_read_words_5_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_5_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_5_memory_write_data <= to_unsigned(slice0cost_write_words_5, 22);
  slice0cost_read_words_5_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_5_memory_read_enable,
      read_address => slice0cost_read_words_5_memory_read_address, read_data => slice0cost_read_words_5,
      write_address => slice0cost_read_words_5_memory_write_address, write_data => slice0cost_read_words_5_memory_write_data);

  slice0cost_read_words_4_memory_read_enable <= true;
  slice0cost_read_words_4_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_4_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_4_memory_write_data <= to_unsigned(slice0cost_write_words_4, 22);
  slice0cost_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_4_memory_read_enable,
      read_address => slice0cost_read_words_4_memory_read_address, read_data => slice0cost_read_words_4,
      write_address => slice0cost_read_words_4_memory_write_address, write_data => slice0cost_read_words_4_memory_write_data);

  slice0cost_read_words_3_memory_read_enable <= true;
  slice0cost_read_words_3_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_3_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_3_memory_write_data <= to_unsigned(slice0cost_write_words_3, 22);
  slice0cost_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_3_memory_read_enable,
      read_address => slice0cost_read_words_3_memory_read_address, read_data => slice0cost_read_words_3,
      write_address => slice0cost_read_words_3_memory_write_address, write_data => slice0cost_read_words_3_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_2_memory_write_data <= to_unsigned(slice0cost_write_words_2, 22);
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 22);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice2cost_change_column, 9);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 22);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 22, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= rows_search_rows_write_words_0;
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= rows_reference_rows_write_words_0;
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 7);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 7);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 8);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 121, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, raster_place_group_choice, delay_tag_first_cost_is_equal : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_0_1_is_less : boolean;
    variable slice0winner1_best_cost_0_2_is_less, slice0winner1_best_cost_0_3_is_less : boolean;
    variable slice0winner1_best_cost_0_4_is_less, slice0winner1_best_cost_0_5_is_less : boolean;
    variable slice0winner1_best_cost_0_6_is_less, slice0winner1_best_cost_0_7_is_less : boolean;
    variable slice0winner1_best_cost_0_8_is_less, slice0winner1_best_cost_0_9_is_less : boolean;
    variable slice0winner1_best_cost_0_10_is_less, slice0winner1_best_cost_0_11_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_cost_0_1_is_less : boolean;
    variable slice0winner2_best_cost_0_2_is_less, slice0winner2_best_cost_0_3_is_less : boolean;
    variable slice0winner2_best_cost_0_4_is_less, slice0winner2_best_cost_0_5_is_less : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner3_best_cost_0_1_is_less : boolean;
    variable slice0winner3_best_cost_0_2_is_less, slice0winner4_best_cost_0_0_is_less : boolean;
    variable slice0winner4_best_cost_0_1_is_less, slice0winner5_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner1_best_cost_0_1_is_less : boolean;
    variable slice1winner1_best_cost_0_2_is_less, slice1winner1_best_cost_0_3_is_less : boolean;
    variable slice1winner1_best_cost_0_4_is_less, slice1winner1_best_cost_0_5_is_less : boolean;
    variable slice1winner1_best_cost_0_6_is_less, slice1winner1_best_cost_0_7_is_less : boolean;
    variable slice1winner1_best_cost_0_8_is_less, slice1winner1_best_cost_0_9_is_less : boolean;
    variable slice1winner1_best_cost_0_10_is_less, slice1winner1_best_cost_0_11_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner2_best_cost_0_1_is_less : boolean;
    variable slice1winner2_best_cost_0_2_is_less, slice1winner2_best_cost_0_3_is_less : boolean;
    variable slice1winner2_best_cost_0_4_is_less, slice1winner2_best_cost_0_5_is_less : boolean;
    variable slice1winner3_best_cost_0_0_is_less, slice1winner3_best_cost_0_1_is_less : boolean;
    variable slice1winner3_best_cost_0_2_is_less, slice1winner4_best_cost_0_0_is_less : boolean;
    variable slice1winner4_best_cost_0_1_is_less, slice1winner5_best_cost_0_0_is_less : boolean;
    variable slice1_best_cost_0_0_is_less, slice2winner1_best_cost_0_0_is_less : boolean;
    variable slice2winner1_best_cost_0_1_is_less, slice2winner1_best_cost_0_2_is_less : boolean;
    variable slice2winner1_best_cost_0_3_is_less, slice2winner1_best_cost_0_4_is_less : boolean;
    variable slice2winner1_best_cost_0_5_is_less, slice2winner1_best_cost_0_6_is_less : boolean;
    variable slice2winner1_best_cost_0_7_is_less, slice2winner1_best_cost_0_8_is_less : boolean;
    variable slice2winner1_best_cost_0_9_is_less, slice2winner1_best_cost_0_10_is_less : boolean;
    variable slice2winner1_best_cost_0_11_is_less, slice2winner2_best_cost_0_0_is_less : boolean;
    variable slice2winner2_best_cost_0_1_is_less, slice2winner2_best_cost_0_2_is_less : boolean;
    variable slice2winner2_best_cost_0_3_is_less, slice2winner2_best_cost_0_4_is_less : boolean;
    variable slice2winner2_best_cost_0_5_is_less, slice2winner3_best_cost_0_0_is_less : boolean;
    variable slice2winner3_best_cost_0_1_is_less, slice2winner3_best_cost_0_2_is_less : boolean;
    variable slice2winner4_best_cost_0_0_is_less, slice2winner4_best_cost_0_1_is_less : boolean;
    variable slice2winner5_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less : boolean;
    variable slice3winner1_best_cost_0_0_is_less, slice3winner1_best_cost_0_1_is_less : boolean;
    variable slice3winner1_best_cost_0_2_is_less, slice3winner1_best_cost_0_3_is_less : boolean;
    variable slice3winner1_best_cost_0_4_is_less, slice3winner1_best_cost_0_5_is_less : boolean;
    variable slice3winner1_best_cost_0_6_is_less, slice3winner1_best_cost_0_7_is_less : boolean;
    variable slice3winner1_best_cost_0_8_is_less, slice3winner1_best_cost_0_9_is_less : boolean;
    variable slice3winner1_best_cost_0_10_is_less, slice3winner1_best_cost_0_11_is_less : boolean;
    variable slice3winner2_best_cost_0_0_is_less, slice3winner2_best_cost_0_1_is_less : boolean;
    variable slice3winner2_best_cost_0_2_is_less, slice3winner2_best_cost_0_3_is_less : boolean;
    variable slice3winner2_best_cost_0_4_is_less, slice3winner2_best_cost_0_5_is_less : boolean;
    variable slice3winner3_best_cost_0_0_is_less, slice3winner3_best_cost_0_1_is_less : boolean;
    variable slice3winner3_best_cost_0_2_is_less, slice3winner4_best_cost_0_0_is_less : boolean;
    variable slice3winner4_best_cost_0_1_is_less, slice3winner5_best_cost_0_0_is_less : boolean;
    variable slice3_best_cost_0_0_is_less, slice4winner1_best_cost_0_0_is_less : boolean;
    variable slice4winner1_best_cost_0_1_is_less, slice4winner1_best_cost_0_2_is_less : boolean;
    variable slice4winner1_best_cost_0_3_is_less, slice4winner1_best_cost_0_4_is_less : boolean;
    variable slice4winner1_best_cost_0_5_is_less, slice4winner1_best_cost_0_6_is_less : boolean;
    variable slice4winner1_best_cost_0_7_is_less, slice4winner1_best_cost_0_8_is_less : boolean;
    variable slice4winner1_best_cost_0_9_is_less, slice4winner2_best_cost_0_0_is_less : boolean;
    variable slice4winner2_best_cost_0_1_is_less, slice4winner2_best_cost_0_2_is_less : boolean;
    variable slice4winner2_best_cost_0_3_is_less, slice4winner2_best_cost_0_4_is_less : boolean;
    variable slice4winner3_best_cost_0_0_is_less, slice4winner3_best_cost_0_1_is_less : boolean;
    variable slice4winner3_best_cost_0_2_is_less, slice4winner4_best_cost_0_0_is_less : boolean;
    variable slice4winner5_best_cost_0_0_is_less : boolean;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_8_choice, slice0cost_column_0_8_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_9_choice, slice0cost_column_0_9_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_10_choice, slice0cost_column_0_10_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_11_choice, slice0cost_column_0_11_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_12_choice, slice0cost_column_0_12_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_13_choice, slice0cost_column_0_13_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_14_choice, slice0cost_column_0_14_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_15_choice, slice0cost_column_0_15_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_16_choice, slice0cost_column_0_16_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_17_choice, slice0cost_column_0_17_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_18_choice, slice0cost_column_0_18_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_19_choice, slice0cost_column_0_19_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_20_choice, slice0cost_column_0_20_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_21_choice, slice0cost_column_0_21_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_22_choice, slice0cost_column_0_22_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_23_choice, slice0cost_column_0_23_choice_2 : natural range 0 to 2047;
    variable slice0cost_column_0_24_choice, slice0cost_column_0_24_choice_2 : natural range 0 to 2047;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 2047;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 2047;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 2047;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 2047;
    variable slice0window_change_0_8_choice, slice0window_change_0_9_choice : natural range 0 to 2047;
    variable slice0window_change_0_10_choice, slice0window_change_0_11_choice : natural range 0 to 2047;
    variable slice0window_change_0_12_choice, slice0window_change_0_13_choice : natural range 0 to 2047;
    variable slice0window_change_0_14_choice, slice0window_change_0_15_choice : natural range 0 to 2047;
    variable slice0window_change_0_16_choice, slice0window_change_0_17_choice : natural range 0 to 2047;
    variable slice0window_change_0_18_choice, slice0window_change_0_19_choice : natural range 0 to 2047;
    variable slice0window_change_0_20_choice, slice0window_change_0_21_choice : natural range 0 to 2047;
    variable slice0window_change_0_22_choice, slice0window_change_0_23_choice : natural range 0 to 2047;
    variable slice0window_change_0_24_choice, slice1cost_column_0_0_choice : natural range 0 to 2047;
    variable slice1cost_column_0_0_choice_2, slice1cost_column_0_1_choice : natural range 0 to 2047;
    variable slice1cost_column_0_1_choice_2, slice1cost_column_0_2_choice : natural range 0 to 2047;
    variable slice1cost_column_0_2_choice_2, slice1cost_column_0_3_choice : natural range 0 to 2047;
    variable slice1cost_column_0_3_choice_2, slice1cost_column_0_4_choice : natural range 0 to 2047;
    variable slice1cost_column_0_4_choice_2, slice1cost_column_0_5_choice : natural range 0 to 2047;
    variable slice1cost_column_0_5_choice_2, slice1cost_column_0_6_choice : natural range 0 to 2047;
    variable slice1cost_column_0_6_choice_2, slice1cost_column_0_7_choice : natural range 0 to 2047;
    variable slice1cost_column_0_7_choice_2, slice1cost_column_0_8_choice : natural range 0 to 2047;
    variable slice1cost_column_0_8_choice_2, slice1cost_column_0_9_choice : natural range 0 to 2047;
    variable slice1cost_column_0_9_choice_2, slice1cost_column_0_10_choice : natural range 0 to 2047;
    variable slice1cost_column_0_10_choice_2, slice1cost_column_0_11_choice : natural range 0 to 2047;
    variable slice1cost_column_0_11_choice_2, slice1cost_column_0_12_choice : natural range 0 to 2047;
    variable slice1cost_column_0_12_choice_2, slice1cost_column_0_13_choice : natural range 0 to 2047;
    variable slice1cost_column_0_13_choice_2, slice1cost_column_0_14_choice : natural range 0 to 2047;
    variable slice1cost_column_0_14_choice_2, slice1cost_column_0_15_choice : natural range 0 to 2047;
    variable slice1cost_column_0_15_choice_2, slice1cost_column_0_16_choice : natural range 0 to 2047;
    variable slice1cost_column_0_16_choice_2, slice1cost_column_0_17_choice : natural range 0 to 2047;
    variable slice1cost_column_0_17_choice_2, slice1cost_column_0_18_choice : natural range 0 to 2047;
    variable slice1cost_column_0_18_choice_2, slice1cost_column_0_19_choice : natural range 0 to 2047;
    variable slice1cost_column_0_19_choice_2, slice1cost_column_0_20_choice : natural range 0 to 2047;
    variable slice1cost_column_0_20_choice_2, slice1cost_column_0_21_choice : natural range 0 to 2047;
    variable slice1cost_column_0_21_choice_2, slice1cost_column_0_22_choice : natural range 0 to 2047;
    variable slice1cost_column_0_22_choice_2, slice1cost_column_0_23_choice : natural range 0 to 2047;
    variable slice1cost_column_0_23_choice_2, slice1cost_column_0_24_choice : natural range 0 to 2047;
    variable slice1cost_column_0_24_choice_2, slice1window_change_0_0_choice : natural range 0 to 2047;
    variable slice1window_change_0_1_choice, slice1window_change_0_2_choice : natural range 0 to 2047;
    variable slice1window_change_0_3_choice, slice1window_change_0_4_choice : natural range 0 to 2047;
    variable slice1window_change_0_5_choice, slice1window_change_0_6_choice : natural range 0 to 2047;
    variable slice1window_change_0_7_choice, slice1window_change_0_8_choice : natural range 0 to 2047;
    variable slice1window_change_0_9_choice, slice1window_change_0_10_choice : natural range 0 to 2047;
    variable slice1window_change_0_11_choice, slice1window_change_0_12_choice : natural range 0 to 2047;
    variable slice1window_change_0_13_choice, slice1window_change_0_14_choice : natural range 0 to 2047;
    variable slice1window_change_0_15_choice, slice1window_change_0_16_choice : natural range 0 to 2047;
    variable slice1window_change_0_17_choice, slice1window_change_0_18_choice : natural range 0 to 2047;
    variable slice1window_change_0_19_choice, slice1window_change_0_20_choice : natural range 0 to 2047;
    variable slice1window_change_0_21_choice, slice1window_change_0_22_choice : natural range 0 to 2047;
    variable slice1window_change_0_23_choice, slice1window_change_0_24_choice : natural range 0 to 2047;
    variable slice2cost_column_0_0_choice, slice2cost_column_0_0_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_1_choice, slice2cost_column_0_1_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_2_choice, slice2cost_column_0_2_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_3_choice, slice2cost_column_0_3_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_4_choice, slice2cost_column_0_4_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_5_choice, slice2cost_column_0_5_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_6_choice, slice2cost_column_0_6_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_7_choice, slice2cost_column_0_7_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_8_choice, slice2cost_column_0_8_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_9_choice, slice2cost_column_0_9_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_10_choice, slice2cost_column_0_10_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_11_choice, slice2cost_column_0_11_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_12_choice, slice2cost_column_0_12_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_13_choice, slice2cost_column_0_13_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_14_choice, slice2cost_column_0_14_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_15_choice, slice2cost_column_0_15_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_16_choice, slice2cost_column_0_16_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_17_choice, slice2cost_column_0_17_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_18_choice, slice2cost_column_0_18_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_19_choice, slice2cost_column_0_19_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_20_choice, slice2cost_column_0_20_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_21_choice, slice2cost_column_0_21_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_22_choice, slice2cost_column_0_22_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_23_choice, slice2cost_column_0_23_choice_2 : natural range 0 to 2047;
    variable slice2cost_column_0_24_choice, slice2cost_column_0_24_choice_2 : natural range 0 to 2047;
    variable slice2window_change_0_0_choice, slice2window_change_0_1_choice : natural range 0 to 2047;
    variable slice2window_change_0_2_choice, slice2window_change_0_3_choice : natural range 0 to 2047;
    variable slice2window_change_0_4_choice, slice2window_change_0_5_choice : natural range 0 to 2047;
    variable slice2window_change_0_6_choice, slice2window_change_0_7_choice : natural range 0 to 2047;
    variable slice2window_change_0_8_choice, slice2window_change_0_9_choice : natural range 0 to 2047;
    variable slice2window_change_0_10_choice, slice2window_change_0_11_choice : natural range 0 to 2047;
    variable slice2window_change_0_12_choice, slice2window_change_0_13_choice : natural range 0 to 2047;
    variable slice2window_change_0_14_choice, slice2window_change_0_15_choice : natural range 0 to 2047;
    variable slice2window_change_0_16_choice, slice2window_change_0_17_choice : natural range 0 to 2047;
    variable slice2window_change_0_18_choice, slice2window_change_0_19_choice : natural range 0 to 2047;
    variable slice2window_change_0_20_choice, slice2window_change_0_21_choice : natural range 0 to 2047;
    variable slice2window_change_0_22_choice, slice2window_change_0_23_choice : natural range 0 to 2047;
    variable slice2window_change_0_24_choice, slice3cost_column_0_0_choice : natural range 0 to 2047;
    variable slice3cost_column_0_0_choice_2, slice3cost_column_0_1_choice : natural range 0 to 2047;
    variable slice3cost_column_0_1_choice_2, slice3cost_column_0_2_choice : natural range 0 to 2047;
    variable slice3cost_column_0_2_choice_2, slice3cost_column_0_3_choice : natural range 0 to 2047;
    variable slice3cost_column_0_3_choice_2, slice3cost_column_0_4_choice : natural range 0 to 2047;
    variable slice3cost_column_0_4_choice_2, slice3cost_column_0_5_choice : natural range 0 to 2047;
    variable slice3cost_column_0_5_choice_2, slice3cost_column_0_6_choice : natural range 0 to 2047;
    variable slice3cost_column_0_6_choice_2, slice3cost_column_0_7_choice : natural range 0 to 2047;
    variable slice3cost_column_0_7_choice_2, slice3cost_column_0_8_choice : natural range 0 to 2047;
    variable slice3cost_column_0_8_choice_2, slice3cost_column_0_9_choice : natural range 0 to 2047;
    variable slice3cost_column_0_9_choice_2, slice3cost_column_0_10_choice : natural range 0 to 2047;
    variable slice3cost_column_0_10_choice_2, slice3cost_column_0_11_choice : natural range 0 to 2047;
    variable slice3cost_column_0_11_choice_2, slice3cost_column_0_12_choice : natural range 0 to 2047;
    variable slice3cost_column_0_12_choice_2, slice3cost_column_0_13_choice : natural range 0 to 2047;
    variable slice3cost_column_0_13_choice_2, slice3cost_column_0_14_choice : natural range 0 to 2047;
    variable slice3cost_column_0_14_choice_2, slice3cost_column_0_15_choice : natural range 0 to 2047;
    variable slice3cost_column_0_15_choice_2, slice3cost_column_0_16_choice : natural range 0 to 2047;
    variable slice3cost_column_0_16_choice_2, slice3cost_column_0_17_choice : natural range 0 to 2047;
    variable slice3cost_column_0_17_choice_2, slice3cost_column_0_18_choice : natural range 0 to 2047;
    variable slice3cost_column_0_18_choice_2, slice3cost_column_0_19_choice : natural range 0 to 2047;
    variable slice3cost_column_0_19_choice_2, slice3cost_column_0_20_choice : natural range 0 to 2047;
    variable slice3cost_column_0_20_choice_2, slice3cost_column_0_21_choice : natural range 0 to 2047;
    variable slice3cost_column_0_21_choice_2, slice3cost_column_0_22_choice : natural range 0 to 2047;
    variable slice3cost_column_0_22_choice_2, slice3cost_column_0_23_choice : natural range 0 to 2047;
    variable slice3cost_column_0_23_choice_2, slice3cost_column_0_24_choice : natural range 0 to 2047;
    variable slice3cost_column_0_24_choice_2, slice3window_change_0_0_choice : natural range 0 to 2047;
    variable slice3window_change_0_1_choice, slice3window_change_0_2_choice : natural range 0 to 2047;
    variable slice3window_change_0_3_choice, slice3window_change_0_4_choice : natural range 0 to 2047;
    variable slice3window_change_0_5_choice, slice3window_change_0_6_choice : natural range 0 to 2047;
    variable slice3window_change_0_7_choice, slice3window_change_0_8_choice : natural range 0 to 2047;
    variable slice3window_change_0_9_choice, slice3window_change_0_10_choice : natural range 0 to 2047;
    variable slice3window_change_0_11_choice, slice3window_change_0_12_choice : natural range 0 to 2047;
    variable slice3window_change_0_13_choice, slice3window_change_0_14_choice : natural range 0 to 2047;
    variable slice3window_change_0_15_choice, slice3window_change_0_16_choice : natural range 0 to 2047;
    variable slice3window_change_0_17_choice, slice3window_change_0_18_choice : natural range 0 to 2047;
    variable slice3window_change_0_19_choice, slice3window_change_0_20_choice : natural range 0 to 2047;
    variable slice3window_change_0_21_choice, slice3window_change_0_22_choice : natural range 0 to 2047;
    variable slice3window_change_0_23_choice, slice3window_change_0_24_choice : natural range 0 to 2047;
    variable slice4cost_column_0_0_choice, slice4cost_column_0_0_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_1_choice, slice4cost_column_0_1_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_2_choice, slice4cost_column_0_2_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_3_choice, slice4cost_column_0_3_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_4_choice, slice4cost_column_0_4_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_5_choice, slice4cost_column_0_5_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_6_choice, slice4cost_column_0_6_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_7_choice, slice4cost_column_0_7_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_8_choice, slice4cost_column_0_8_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_9_choice, slice4cost_column_0_9_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_10_choice, slice4cost_column_0_10_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_11_choice, slice4cost_column_0_11_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_12_choice, slice4cost_column_0_12_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_13_choice, slice4cost_column_0_13_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_14_choice, slice4cost_column_0_14_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_15_choice, slice4cost_column_0_15_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_16_choice, slice4cost_column_0_16_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_17_choice, slice4cost_column_0_17_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_18_choice, slice4cost_column_0_18_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_19_choice, slice4cost_column_0_19_choice_2 : natural range 0 to 2047;
    variable slice4cost_column_0_20_choice, slice4cost_column_0_20_choice_2 : natural range 0 to 2047;
    variable slice4window_change_0_0_choice, slice4window_change_0_1_choice : natural range 0 to 2047;
    variable slice4window_change_0_2_choice, slice4window_change_0_3_choice : natural range 0 to 2047;
    variable slice4window_change_0_4_choice, slice4window_change_0_5_choice : natural range 0 to 2047;
    variable slice4window_change_0_6_choice, slice4window_change_0_7_choice : natural range 0 to 2047;
    variable slice4window_change_0_8_choice, slice4window_change_0_9_choice : natural range 0 to 2047;
    variable slice4window_change_0_10_choice, slice4window_change_0_11_choice : natural range 0 to 2047;
    variable slice4window_change_0_12_choice, slice4window_change_0_13_choice : natural range 0 to 2047;
    variable slice4window_change_0_14_choice, slice4window_change_0_15_choice : natural range 0 to 2047;
    variable slice4window_change_0_16_choice, slice4window_change_0_17_choice : natural range 0 to 2047;
    variable slice4window_change_0_18_choice, slice4window_change_0_19_choice : natural range 0 to 2047;
    variable slice4window_change_0_20_choice : natural range 0 to 2047;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 16383;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 16383;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 16383;
    variable slice0window_sum_0_6_choice, slice0window_sum_0_7_choice : natural range 0 to 16383;
    variable slice0window_sum_0_8_choice, slice0window_sum_0_9_choice : natural range 0 to 16383;
    variable slice0window_sum_0_10_choice, slice0window_sum_0_11_choice : natural range 0 to 16383;
    variable slice0window_sum_0_12_choice, slice0window_sum_0_13_choice : natural range 0 to 16383;
    variable slice0window_sum_0_14_choice, slice0window_sum_0_15_choice : natural range 0 to 16383;
    variable slice0window_sum_0_16_choice, slice0window_sum_0_17_choice : natural range 0 to 16383;
    variable slice0window_sum_0_18_choice, slice0window_sum_0_19_choice : natural range 0 to 16383;
    variable slice0window_sum_0_20_choice, slice0window_sum_0_21_choice : natural range 0 to 16383;
    variable slice0window_sum_0_22_choice, slice0window_sum_0_23_choice : natural range 0 to 16383;
    variable slice0window_sum_0_24_choice, slice1window_sum_0_0_choice : natural range 0 to 16383;
    variable slice1window_sum_0_1_choice, slice1window_sum_0_2_choice : natural range 0 to 16383;
    variable slice1window_sum_0_3_choice, slice1window_sum_0_4_choice : natural range 0 to 16383;
    variable slice1window_sum_0_5_choice, slice1window_sum_0_6_choice : natural range 0 to 16383;
    variable slice1window_sum_0_7_choice, slice1window_sum_0_8_choice : natural range 0 to 16383;
    variable slice1window_sum_0_9_choice, slice1window_sum_0_10_choice : natural range 0 to 16383;
    variable slice1window_sum_0_11_choice, slice1window_sum_0_12_choice : natural range 0 to 16383;
    variable slice1window_sum_0_13_choice, slice1window_sum_0_14_choice : natural range 0 to 16383;
    variable slice1window_sum_0_15_choice, slice1window_sum_0_16_choice : natural range 0 to 16383;
    variable slice1window_sum_0_17_choice, slice1window_sum_0_18_choice : natural range 0 to 16383;
    variable slice1window_sum_0_19_choice, slice1window_sum_0_20_choice : natural range 0 to 16383;
    variable slice1window_sum_0_21_choice, slice1window_sum_0_22_choice : natural range 0 to 16383;
    variable slice1window_sum_0_23_choice, slice1window_sum_0_24_choice : natural range 0 to 16383;
    variable slice2window_sum_0_0_choice, slice2window_sum_0_1_choice : natural range 0 to 16383;
    variable slice2window_sum_0_2_choice, slice2window_sum_0_3_choice : natural range 0 to 16383;
    variable slice2window_sum_0_4_choice, slice2window_sum_0_5_choice : natural range 0 to 16383;
    variable slice2window_sum_0_6_choice, slice2window_sum_0_7_choice : natural range 0 to 16383;
    variable slice2window_sum_0_8_choice, slice2window_sum_0_9_choice : natural range 0 to 16383;
    variable slice2window_sum_0_10_choice, slice2window_sum_0_11_choice : natural range 0 to 16383;
    variable slice2window_sum_0_12_choice, slice2window_sum_0_13_choice : natural range 0 to 16383;
    variable slice2window_sum_0_14_choice, slice2window_sum_0_15_choice : natural range 0 to 16383;
    variable slice2window_sum_0_16_choice, slice2window_sum_0_17_choice : natural range 0 to 16383;
    variable slice2window_sum_0_18_choice, slice2window_sum_0_19_choice : natural range 0 to 16383;
    variable slice2window_sum_0_20_choice, slice2window_sum_0_21_choice : natural range 0 to 16383;
    variable slice2window_sum_0_22_choice, slice2window_sum_0_23_choice : natural range 0 to 16383;
    variable slice2window_sum_0_24_choice, slice3window_sum_0_0_choice : natural range 0 to 16383;
    variable slice3window_sum_0_1_choice, slice3window_sum_0_2_choice : natural range 0 to 16383;
    variable slice3window_sum_0_3_choice, slice3window_sum_0_4_choice : natural range 0 to 16383;
    variable slice3window_sum_0_5_choice, slice3window_sum_0_6_choice : natural range 0 to 16383;
    variable slice3window_sum_0_7_choice, slice3window_sum_0_8_choice : natural range 0 to 16383;
    variable slice3window_sum_0_9_choice, slice3window_sum_0_10_choice : natural range 0 to 16383;
    variable slice3window_sum_0_11_choice, slice3window_sum_0_12_choice : natural range 0 to 16383;
    variable slice3window_sum_0_13_choice, slice3window_sum_0_14_choice : natural range 0 to 16383;
    variable slice3window_sum_0_15_choice, slice3window_sum_0_16_choice : natural range 0 to 16383;
    variable slice3window_sum_0_17_choice, slice3window_sum_0_18_choice : natural range 0 to 16383;
    variable slice3window_sum_0_19_choice, slice3window_sum_0_20_choice : natural range 0 to 16383;
    variable slice3window_sum_0_21_choice, slice3window_sum_0_22_choice : natural range 0 to 16383;
    variable slice3window_sum_0_23_choice, slice3window_sum_0_24_choice : natural range 0 to 16383;
    variable slice4window_sum_0_0_choice, slice4window_sum_0_1_choice : natural range 0 to 16383;
    variable slice4window_sum_0_2_choice, slice4window_sum_0_3_choice : natural range 0 to 16383;
    variable slice4window_sum_0_4_choice, slice4window_sum_0_5_choice : natural range 0 to 16383;
    variable slice4window_sum_0_6_choice, slice4window_sum_0_7_choice : natural range 0 to 16383;
    variable slice4window_sum_0_8_choice, slice4window_sum_0_9_choice : natural range 0 to 16383;
    variable slice4window_sum_0_10_choice, slice4window_sum_0_11_choice : natural range 0 to 16383;
    variable slice4window_sum_0_12_choice, slice4window_sum_0_13_choice : natural range 0 to 16383;
    variable slice4window_sum_0_14_choice, slice4window_sum_0_15_choice : natural range 0 to 16383;
    variable slice4window_sum_0_16_choice, slice4window_sum_0_17_choice : natural range 0 to 16383;
    variable slice4window_sum_0_18_choice, slice4window_sum_0_19_choice : natural range 0 to 16383;
    variable slice4window_sum_0_20_choice : natural range 0 to 16383;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 319;
      if ((raster_place_group mod 16) = 3) and ((raster_place_group / 128) = 1) and (((raster_place_group / 16) mod 4)
        = 3) then
        raster_place_group_choice := raster_place_group_is_equal and in_valid and (not (((raster_place_group / 64) mod
          2) = 1));
      else
        raster_place_group_choice := raster_place_group_is_equal and in_valid;
      end if;
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(raster_place_group_choice)) mod 256;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 120 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 128;
        end if;
      end if;
      delay_tag_first_cost_is_equal := raster_place_column = 120;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 7) and (raster_place_group < 247);
      delay_row_inside_1 <= (not ((raster_place_group / 128) = 1)) or (not (((raster_place_group / 64) mod 2) = 1)) or
        (not (((raster_place_group / 32) mod 2) = 1)) or (not (((raster_place_group / 16) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 120;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_leaves_window <= ((raster_place_column + 65409) mod 65536) < 65412;
      delay_tag_output_column <= (raster_place_group >= 3) and (raster_place_group < 243) and ((((((raster_place_column
        / 8) + 8177) mod 8192) * 8) + (raster_place_column mod 8)) < 199);
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 3);
      delay_tag_end_of_line <= raster_place_column = 318;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= rows_search_rows_read_words_0;
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= rows_reference_rows_read_words_0;
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_first_cost <= delay_tag_first_cost;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_first_cost <= rows_read_tag_first_cost;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_first_cost <= rows_ready_tag_first_cost;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside_0 then
        rows_search_0 <= to_integer(rows_search_rows_ready_words_0(7 downto 0));
        rows_reference_0 <= to_integer(rows_reference_rows_ready_words_0(7 downto 0));
      else
        rows_search_0 <= 0;
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_search_1 <= rows_search_rows_ready_newest_0;
        rows_reference_1 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_1 <= 0;
        rows_reference_1 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= to_unsigned((rows_search_rows_ready_words_1 mod 256), 8) &
          rows_search_rows_ready_words_0(31 downto 8);
        rows_search_rows_write_words_1 <= (rows_search_rows_ready_newest_0 * 65536) + ((rows_search_rows_ready_words_1
          / 65536) * 256) + ((rows_search_rows_ready_words_1 mod 65536) / 256);
        rows_reference_rows_write_words_0 <= to_unsigned((rows_reference_rows_ready_words_1 mod 256), 8) &
          rows_reference_rows_ready_words_0(31 downto 8);
        rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_newest_0 * 65536) +
          ((rows_reference_rows_ready_words_1 / 65536) * 256) + ((rows_reference_rows_ready_words_1 mod 65536) / 256);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= slice0shift_search_0_3;
        slice0shift_search_0_3 <= slice0shift_search_0_4;
        slice0shift_search_0_4 <= slice0shift_search_0_5;
        slice0shift_search_0_5 <= slice0shift_search_0_6;
        slice0shift_search_0_6 <= slice0shift_search_0_7;
        slice0shift_search_0_7 <= slice0shift_search_0_8;
        slice0shift_search_0_8 <= slice0shift_search_0_9;
        slice0shift_search_0_9 <= slice0shift_search_0_10;
        slice0shift_search_0_10 <= slice0shift_search_0_11;
        slice0shift_search_0_11 <= slice0shift_search_0_12;
        slice0shift_search_0_12 <= slice0shift_search_0_13;
        slice0shift_search_0_13 <= slice0shift_search_0_14;
        slice0shift_search_0_14 <= slice0shift_search_0_15;
        slice0shift_search_0_15 <= slice0shift_search_0_16;
        slice0shift_search_0_16 <= slice0shift_search_0_17;
        slice0shift_search_0_17 <= slice0shift_search_0_18;
        slice0shift_search_0_18 <= slice0shift_search_0_19;
        slice0shift_search_0_19 <= slice0shift_search_0_20;
        slice0shift_search_0_20 <= slice0shift_search_0_21;
        slice0shift_search_0_21 <= slice0shift_search_0_22;
        slice0shift_search_0_22 <= slice0shift_search_0_23;
        slice0shift_search_0_23 <= slice0shift_search_0_24;
        slice0shift_search_0_24 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= slice0shift_search_1_3;
        slice0shift_search_1_3 <= slice0shift_search_1_4;
        slice0shift_search_1_4 <= slice0shift_search_1_5;
        slice0shift_search_1_5 <= slice0shift_search_1_6;
        slice0shift_search_1_6 <= slice0shift_search_1_7;
        slice0shift_search_1_7 <= slice0shift_search_1_8;
        slice0shift_search_1_8 <= slice0shift_search_1_9;
        slice0shift_search_1_9 <= slice0shift_search_1_10;
        slice0shift_search_1_10 <= slice0shift_search_1_11;
        slice0shift_search_1_11 <= slice0shift_search_1_12;
        slice0shift_search_1_12 <= slice0shift_search_1_13;
        slice0shift_search_1_13 <= slice0shift_search_1_14;
        slice0shift_search_1_14 <= slice0shift_search_1_15;
        slice0shift_search_1_15 <= slice0shift_search_1_16;
        slice0shift_search_1_16 <= slice0shift_search_1_17;
        slice0shift_search_1_17 <= slice0shift_search_1_18;
        slice0shift_search_1_18 <= slice0shift_search_1_19;
        slice0shift_search_1_19 <= slice0shift_search_1_20;
        slice0shift_search_1_20 <= slice0shift_search_1_21;
        slice0shift_search_1_21 <= slice0shift_search_1_22;
        slice0shift_search_1_22 <= slice0shift_search_1_23;
        slice0shift_search_1_23 <= slice0shift_search_1_24;
        slice0shift_search_1_24 <= rows_search_1;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_row_start <= rows_tag_row_start;
      slice0shift_tag_first_group <= rows_tag_first_group;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0_choice_2 := 0;
      else
        slice0cost_column_0_0_choice_2 := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := slice0cost_ready_words_0 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_1_choice_2 := 0;
      else
        slice0cost_column_0_1_choice_2 := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := slice0cost_ready_words_1 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_2_choice_2 := 0;
      else
        slice0cost_column_0_2_choice_2 := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := slice0cost_ready_words_1 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_3_choice_2 := 0;
      else
        slice0cost_column_0_3_choice_2 := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := slice0cost_ready_words_2 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_4_choice_2 := 0;
      else
        slice0cost_column_0_4_choice_2 := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := slice0cost_ready_words_2 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_5_choice_2 := 0;
      else
        slice0cost_column_0_5_choice_2 := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := slice0cost_ready_words_3 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_6_choice_2 := 0;
      else
        slice0cost_column_0_6_choice_2 := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := slice0cost_ready_words_3 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_7_choice_2 := 0;
      else
        slice0cost_column_0_7_choice_2 := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_8_choice := 0;
      else
        slice0cost_column_0_8_choice := slice0cost_ready_words_4 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_8_choice_2 := 0;
      else
        slice0cost_column_0_8_choice_2 := (slice0cost_change_0_8 + slice0cost_column_0_8_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_9_choice := 0;
      else
        slice0cost_column_0_9_choice := slice0cost_ready_words_4 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_9_choice_2 := 0;
      else
        slice0cost_column_0_9_choice_2 := (slice0cost_change_0_9 + slice0cost_column_0_9_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_10_choice := 0;
      else
        slice0cost_column_0_10_choice := slice0cost_ready_words_5 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_10_choice_2 := 0;
      else
        slice0cost_column_0_10_choice_2 := (slice0cost_change_0_10 + slice0cost_column_0_10_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_11_choice := 0;
      else
        slice0cost_column_0_11_choice := slice0cost_ready_words_5 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_11_choice_2 := 0;
      else
        slice0cost_column_0_11_choice_2 := (slice0cost_change_0_11 + slice0cost_column_0_11_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_12_choice := 0;
      else
        slice0cost_column_0_12_choice := slice0cost_ready_words_6 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_12_choice_2 := 0;
      else
        slice0cost_column_0_12_choice_2 := (slice0cost_change_0_12 + slice0cost_column_0_12_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_13_choice := 0;
      else
        slice0cost_column_0_13_choice := slice0cost_ready_words_6 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_13_choice_2 := 0;
      else
        slice0cost_column_0_13_choice_2 := (slice0cost_change_0_13 + slice0cost_column_0_13_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_14_choice := 0;
      else
        slice0cost_column_0_14_choice := slice0cost_ready_words_7 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_14_choice_2 := 0;
      else
        slice0cost_column_0_14_choice_2 := (slice0cost_change_0_14 + slice0cost_column_0_14_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_15_choice := 0;
      else
        slice0cost_column_0_15_choice := slice0cost_ready_words_7 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_15_choice_2 := 0;
      else
        slice0cost_column_0_15_choice_2 := (slice0cost_change_0_15 + slice0cost_column_0_15_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_16_choice := 0;
      else
        slice0cost_column_0_16_choice := slice0cost_ready_words_8 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_16_choice_2 := 0;
      else
        slice0cost_column_0_16_choice_2 := (slice0cost_change_0_16 + slice0cost_column_0_16_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_17_choice := 0;
      else
        slice0cost_column_0_17_choice := slice0cost_ready_words_8 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_17_choice_2 := 0;
      else
        slice0cost_column_0_17_choice_2 := (slice0cost_change_0_17 + slice0cost_column_0_17_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_18_choice := 0;
      else
        slice0cost_column_0_18_choice := slice0cost_ready_words_9 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_18_choice_2 := 0;
      else
        slice0cost_column_0_18_choice_2 := (slice0cost_change_0_18 + slice0cost_column_0_18_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_19_choice := 0;
      else
        slice0cost_column_0_19_choice := slice0cost_ready_words_9 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_19_choice_2 := 0;
      else
        slice0cost_column_0_19_choice_2 := (slice0cost_change_0_19 + slice0cost_column_0_19_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_20_choice := 0;
      else
        slice0cost_column_0_20_choice := slice0cost_ready_words_10 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_20_choice_2 := 0;
      else
        slice0cost_column_0_20_choice_2 := (slice0cost_change_0_20 + slice0cost_column_0_20_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_21_choice := 0;
      else
        slice0cost_column_0_21_choice := slice0cost_ready_words_10 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_21_choice_2 := 0;
      else
        slice0cost_column_0_21_choice_2 := (slice0cost_change_0_21 + slice0cost_column_0_21_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_22_choice := 0;
      else
        slice0cost_column_0_22_choice := slice0cost_ready_words_11 mod 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_22_choice_2 := 0;
      else
        slice0cost_column_0_22_choice_2 := (slice0cost_change_0_22 + slice0cost_column_0_22_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_23_choice := 0;
      else
        slice0cost_column_0_23_choice := slice0cost_ready_words_11 / 2048;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_23_choice_2 := 0;
      else
        slice0cost_column_0_23_choice_2 := (slice0cost_change_0_23 + slice0cost_column_0_23_choice) mod 2048;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_24_choice := 0;
      else
        slice0cost_column_0_24_choice := slice0cost_ready_words_12;
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_24_choice_2 := 0;
      else
        slice0cost_column_0_24_choice_2 := (slice0cost_change_0_24 + slice0cost_column_0_24_choice) mod 2048;
      end if;
      slice0cost_pixels_first_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_pixels_first_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_pixels_first_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_pixels_first_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_pixels_first_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_pixels_first_0_5 <= slice0shift_search_0_5 - slice0shift_reference_0;
      slice0cost_pixels_first_0_6 <= slice0shift_search_0_6 - slice0shift_reference_0;
      slice0cost_pixels_first_0_7 <= slice0shift_search_0_7 - slice0shift_reference_0;
      slice0cost_pixels_first_0_8 <= slice0shift_search_0_8 - slice0shift_reference_0;
      slice0cost_pixels_first_0_9 <= slice0shift_search_0_9 - slice0shift_reference_0;
      slice0cost_pixels_first_0_10 <= slice0shift_search_0_10 - slice0shift_reference_0;
      slice0cost_pixels_first_0_11 <= slice0shift_search_0_11 - slice0shift_reference_0;
      slice0cost_pixels_first_0_12 <= slice0shift_search_0_12 - slice0shift_reference_0;
      slice0cost_pixels_first_0_13 <= slice0shift_search_0_13 - slice0shift_reference_0;
      slice0cost_pixels_first_0_14 <= slice0shift_search_0_14 - slice0shift_reference_0;
      slice0cost_pixels_first_0_15 <= slice0shift_search_0_15 - slice0shift_reference_0;
      slice0cost_pixels_first_0_16 <= slice0shift_search_0_16 - slice0shift_reference_0;
      slice0cost_pixels_first_0_17 <= slice0shift_search_0_17 - slice0shift_reference_0;
      slice0cost_pixels_first_0_18 <= slice0shift_search_0_18 - slice0shift_reference_0;
      slice0cost_pixels_first_0_19 <= slice0shift_search_0_19 - slice0shift_reference_0;
      slice0cost_pixels_first_0_20 <= slice0shift_search_0_20 - slice0shift_reference_0;
      slice0cost_pixels_first_0_21 <= slice0shift_search_0_21 - slice0shift_reference_0;
      slice0cost_pixels_first_0_22 <= slice0shift_search_0_22 - slice0shift_reference_0;
      slice0cost_pixels_first_0_23 <= slice0shift_search_0_23 - slice0shift_reference_0;
      slice0cost_pixels_first_0_24 <= slice0shift_search_0_24 - slice0shift_reference_0;
      slice0cost_pixels_first_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_pixels_first_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_pixels_first_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_pixels_first_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_pixels_first_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_pixels_first_1_5 <= slice0shift_search_1_5 - slice0shift_reference_1;
      slice0cost_pixels_first_1_6 <= slice0shift_search_1_6 - slice0shift_reference_1;
      slice0cost_pixels_first_1_7 <= slice0shift_search_1_7 - slice0shift_reference_1;
      slice0cost_pixels_first_1_8 <= slice0shift_search_1_8 - slice0shift_reference_1;
      slice0cost_pixels_first_1_9 <= slice0shift_search_1_9 - slice0shift_reference_1;
      slice0cost_pixels_first_1_10 <= slice0shift_search_1_10 - slice0shift_reference_1;
      slice0cost_pixels_first_1_11 <= slice0shift_search_1_11 - slice0shift_reference_1;
      slice0cost_pixels_first_1_12 <= slice0shift_search_1_12 - slice0shift_reference_1;
      slice0cost_pixels_first_1_13 <= slice0shift_search_1_13 - slice0shift_reference_1;
      slice0cost_pixels_first_1_14 <= slice0shift_search_1_14 - slice0shift_reference_1;
      slice0cost_pixels_first_1_15 <= slice0shift_search_1_15 - slice0shift_reference_1;
      slice0cost_pixels_first_1_16 <= slice0shift_search_1_16 - slice0shift_reference_1;
      slice0cost_pixels_first_1_17 <= slice0shift_search_1_17 - slice0shift_reference_1;
      slice0cost_pixels_first_1_18 <= slice0shift_search_1_18 - slice0shift_reference_1;
      slice0cost_pixels_first_1_19 <= slice0shift_search_1_19 - slice0shift_reference_1;
      slice0cost_pixels_first_1_20 <= slice0shift_search_1_20 - slice0shift_reference_1;
      slice0cost_pixels_first_1_21 <= slice0shift_search_1_21 - slice0shift_reference_1;
      slice0cost_pixels_first_1_22 <= slice0shift_search_1_22 - slice0shift_reference_1;
      slice0cost_pixels_first_1_23 <= slice0shift_search_1_23 - slice0shift_reference_1;
      slice0cost_pixels_first_1_24 <= slice0shift_search_1_24 - slice0shift_reference_1;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= (folded(slice0cost_pixels_first_0_0) + as_number((slice0cost_pixels_first_0_0 <
        0))) mod 256;
      slice0cost_pixels_cost_0_1 <= (folded(slice0cost_pixels_first_0_1) + as_number((slice0cost_pixels_first_0_1 <
        0))) mod 256;
      slice0cost_pixels_cost_0_2 <= (folded(slice0cost_pixels_first_0_2) + as_number((slice0cost_pixels_first_0_2 <
        0))) mod 256;
      slice0cost_pixels_cost_0_3 <= (folded(slice0cost_pixels_first_0_3) + as_number((slice0cost_pixels_first_0_3 <
        0))) mod 256;
      slice0cost_pixels_cost_0_4 <= (folded(slice0cost_pixels_first_0_4) + as_number((slice0cost_pixels_first_0_4 <
        0))) mod 256;
      slice0cost_pixels_cost_0_5 <= (folded(slice0cost_pixels_first_0_5) + as_number((slice0cost_pixels_first_0_5 <
        0))) mod 256;
      slice0cost_pixels_cost_0_6 <= (folded(slice0cost_pixels_first_0_6) + as_number((slice0cost_pixels_first_0_6 <
        0))) mod 256;
      slice0cost_pixels_cost_0_7 <= (folded(slice0cost_pixels_first_0_7) + as_number((slice0cost_pixels_first_0_7 <
        0))) mod 256;
      slice0cost_pixels_cost_0_8 <= (folded(slice0cost_pixels_first_0_8) + as_number((slice0cost_pixels_first_0_8 <
        0))) mod 256;
      slice0cost_pixels_cost_0_9 <= (folded(slice0cost_pixels_first_0_9) + as_number((slice0cost_pixels_first_0_9 <
        0))) mod 256;
      slice0cost_pixels_cost_0_10 <= (folded(slice0cost_pixels_first_0_10) + as_number((slice0cost_pixels_first_0_10 <
        0))) mod 256;
      slice0cost_pixels_cost_0_11 <= (folded(slice0cost_pixels_first_0_11) + as_number((slice0cost_pixels_first_0_11 <
        0))) mod 256;
      slice0cost_pixels_cost_0_12 <= (folded(slice0cost_pixels_first_0_12) + as_number((slice0cost_pixels_first_0_12 <
        0))) mod 256;
      slice0cost_pixels_cost_0_13 <= (folded(slice0cost_pixels_first_0_13) + as_number((slice0cost_pixels_first_0_13 <
        0))) mod 256;
      slice0cost_pixels_cost_0_14 <= (folded(slice0cost_pixels_first_0_14) + as_number((slice0cost_pixels_first_0_14 <
        0))) mod 256;
      slice0cost_pixels_cost_0_15 <= (folded(slice0cost_pixels_first_0_15) + as_number((slice0cost_pixels_first_0_15 <
        0))) mod 256;
      slice0cost_pixels_cost_0_16 <= (folded(slice0cost_pixels_first_0_16) + as_number((slice0cost_pixels_first_0_16 <
        0))) mod 256;
      slice0cost_pixels_cost_0_17 <= (folded(slice0cost_pixels_first_0_17) + as_number((slice0cost_pixels_first_0_17 <
        0))) mod 256;
      slice0cost_pixels_cost_0_18 <= (folded(slice0cost_pixels_first_0_18) + as_number((slice0cost_pixels_first_0_18 <
        0))) mod 256;
      slice0cost_pixels_cost_0_19 <= (folded(slice0cost_pixels_first_0_19) + as_number((slice0cost_pixels_first_0_19 <
        0))) mod 256;
      slice0cost_pixels_cost_0_20 <= (folded(slice0cost_pixels_first_0_20) + as_number((slice0cost_pixels_first_0_20 <
        0))) mod 256;
      slice0cost_pixels_cost_0_21 <= (folded(slice0cost_pixels_first_0_21) + as_number((slice0cost_pixels_first_0_21 <
        0))) mod 256;
      slice0cost_pixels_cost_0_22 <= (folded(slice0cost_pixels_first_0_22) + as_number((slice0cost_pixels_first_0_22 <
        0))) mod 256;
      slice0cost_pixels_cost_0_23 <= (folded(slice0cost_pixels_first_0_23) + as_number((slice0cost_pixels_first_0_23 <
        0))) mod 256;
      slice0cost_pixels_cost_0_24 <= (folded(slice0cost_pixels_first_0_24) + as_number((slice0cost_pixels_first_0_24 <
        0))) mod 256;
      slice0cost_pixels_cost_1_0 <= (folded(slice0cost_pixels_first_1_0) + as_number((slice0cost_pixels_first_1_0 <
        0))) mod 256;
      slice0cost_pixels_cost_1_1 <= (folded(slice0cost_pixels_first_1_1) + as_number((slice0cost_pixels_first_1_1 <
        0))) mod 256;
      slice0cost_pixels_cost_1_2 <= (folded(slice0cost_pixels_first_1_2) + as_number((slice0cost_pixels_first_1_2 <
        0))) mod 256;
      slice0cost_pixels_cost_1_3 <= (folded(slice0cost_pixels_first_1_3) + as_number((slice0cost_pixels_first_1_3 <
        0))) mod 256;
      slice0cost_pixels_cost_1_4 <= (folded(slice0cost_pixels_first_1_4) + as_number((slice0cost_pixels_first_1_4 <
        0))) mod 256;
      slice0cost_pixels_cost_1_5 <= (folded(slice0cost_pixels_first_1_5) + as_number((slice0cost_pixels_first_1_5 <
        0))) mod 256;
      slice0cost_pixels_cost_1_6 <= (folded(slice0cost_pixels_first_1_6) + as_number((slice0cost_pixels_first_1_6 <
        0))) mod 256;
      slice0cost_pixels_cost_1_7 <= (folded(slice0cost_pixels_first_1_7) + as_number((slice0cost_pixels_first_1_7 <
        0))) mod 256;
      slice0cost_pixels_cost_1_8 <= (folded(slice0cost_pixels_first_1_8) + as_number((slice0cost_pixels_first_1_8 <
        0))) mod 256;
      slice0cost_pixels_cost_1_9 <= (folded(slice0cost_pixels_first_1_9) + as_number((slice0cost_pixels_first_1_9 <
        0))) mod 256;
      slice0cost_pixels_cost_1_10 <= (folded(slice0cost_pixels_first_1_10) + as_number((slice0cost_pixels_first_1_10 <
        0))) mod 256;
      slice0cost_pixels_cost_1_11 <= (folded(slice0cost_pixels_first_1_11) + as_number((slice0cost_pixels_first_1_11 <
        0))) mod 256;
      slice0cost_pixels_cost_1_12 <= (folded(slice0cost_pixels_first_1_12) + as_number((slice0cost_pixels_first_1_12 <
        0))) mod 256;
      slice0cost_pixels_cost_1_13 <= (folded(slice0cost_pixels_first_1_13) + as_number((slice0cost_pixels_first_1_13 <
        0))) mod 256;
      slice0cost_pixels_cost_1_14 <= (folded(slice0cost_pixels_first_1_14) + as_number((slice0cost_pixels_first_1_14 <
        0))) mod 256;
      slice0cost_pixels_cost_1_15 <= (folded(slice0cost_pixels_first_1_15) + as_number((slice0cost_pixels_first_1_15 <
        0))) mod 256;
      slice0cost_pixels_cost_1_16 <= (folded(slice0cost_pixels_first_1_16) + as_number((slice0cost_pixels_first_1_16 <
        0))) mod 256;
      slice0cost_pixels_cost_1_17 <= (folded(slice0cost_pixels_first_1_17) + as_number((slice0cost_pixels_first_1_17 <
        0))) mod 256;
      slice0cost_pixels_cost_1_18 <= (folded(slice0cost_pixels_first_1_18) + as_number((slice0cost_pixels_first_1_18 <
        0))) mod 256;
      slice0cost_pixels_cost_1_19 <= (folded(slice0cost_pixels_first_1_19) + as_number((slice0cost_pixels_first_1_19 <
        0))) mod 256;
      slice0cost_pixels_cost_1_20 <= (folded(slice0cost_pixels_first_1_20) + as_number((slice0cost_pixels_first_1_20 <
        0))) mod 256;
      slice0cost_pixels_cost_1_21 <= (folded(slice0cost_pixels_first_1_21) + as_number((slice0cost_pixels_first_1_21 <
        0))) mod 256;
      slice0cost_pixels_cost_1_22 <= (folded(slice0cost_pixels_first_1_22) + as_number((slice0cost_pixels_first_1_22 <
        0))) mod 256;
      slice0cost_pixels_cost_1_23 <= (folded(slice0cost_pixels_first_1_23) + as_number((slice0cost_pixels_first_1_23 <
        0))) mod 256;
      slice0cost_pixels_cost_1_24 <= (folded(slice0cost_pixels_first_1_24) + as_number((slice0cost_pixels_first_1_24 <
        0))) mod 256;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_change_0_0 <= slice0cost_pixels_cost_1_0 - slice0cost_pixels_cost_0_0;
      slice0cost_change_0_1 <= slice0cost_pixels_cost_1_1 - slice0cost_pixels_cost_0_1;
      slice0cost_change_0_2 <= slice0cost_pixels_cost_1_2 - slice0cost_pixels_cost_0_2;
      slice0cost_change_0_3 <= slice0cost_pixels_cost_1_3 - slice0cost_pixels_cost_0_3;
      slice0cost_change_0_4 <= slice0cost_pixels_cost_1_4 - slice0cost_pixels_cost_0_4;
      slice0cost_change_0_5 <= slice0cost_pixels_cost_1_5 - slice0cost_pixels_cost_0_5;
      slice0cost_change_0_6 <= slice0cost_pixels_cost_1_6 - slice0cost_pixels_cost_0_6;
      slice0cost_change_0_7 <= slice0cost_pixels_cost_1_7 - slice0cost_pixels_cost_0_7;
      slice0cost_change_0_8 <= slice0cost_pixels_cost_1_8 - slice0cost_pixels_cost_0_8;
      slice0cost_change_0_9 <= slice0cost_pixels_cost_1_9 - slice0cost_pixels_cost_0_9;
      slice0cost_change_0_10 <= slice0cost_pixels_cost_1_10 - slice0cost_pixels_cost_0_10;
      slice0cost_change_0_11 <= slice0cost_pixels_cost_1_11 - slice0cost_pixels_cost_0_11;
      slice0cost_change_0_12 <= slice0cost_pixels_cost_1_12 - slice0cost_pixels_cost_0_12;
      slice0cost_change_0_13 <= slice0cost_pixels_cost_1_13 - slice0cost_pixels_cost_0_13;
      slice0cost_change_0_14 <= slice0cost_pixels_cost_1_14 - slice0cost_pixels_cost_0_14;
      slice0cost_change_0_15 <= slice0cost_pixels_cost_1_15 - slice0cost_pixels_cost_0_15;
      slice0cost_change_0_16 <= slice0cost_pixels_cost_1_16 - slice0cost_pixels_cost_0_16;
      slice0cost_change_0_17 <= slice0cost_pixels_cost_1_17 - slice0cost_pixels_cost_0_17;
      slice0cost_change_0_18 <= slice0cost_pixels_cost_1_18 - slice0cost_pixels_cost_0_18;
      slice0cost_change_0_19 <= slice0cost_pixels_cost_1_19 - slice0cost_pixels_cost_0_19;
      slice0cost_change_0_20 <= slice0cost_pixels_cost_1_20 - slice0cost_pixels_cost_0_20;
      slice0cost_change_0_21 <= slice0cost_pixels_cost_1_21 - slice0cost_pixels_cost_0_21;
      slice0cost_change_0_22 <= slice0cost_pixels_cost_1_22 - slice0cost_pixels_cost_0_22;
      slice0cost_change_0_23 <= slice0cost_pixels_cost_1_23 - slice0cost_pixels_cost_0_23;
      slice0cost_change_0_24 <= slice0cost_pixels_cost_1_24 - slice0cost_pixels_cost_0_24;
      slice0cost_ready_words_0 <= to_integer(slice0cost_read_words_0);
      slice0cost_ready_words_1 <= to_integer(slice0cost_read_words_1);
      slice0cost_ready_words_2 <= to_integer(slice0cost_read_words_2);
      slice0cost_ready_words_3 <= to_integer(slice0cost_read_words_3);
      slice0cost_ready_words_4 <= to_integer(slice0cost_read_words_4);
      slice0cost_ready_words_5 <= to_integer(slice0cost_read_words_5);
      slice0cost_ready_words_6 <= to_integer(slice0cost_read_words_6);
      slice0cost_ready_words_7 <= to_integer(slice0cost_read_words_7);
      slice0cost_ready_words_8 <= to_integer(slice0cost_read_words_8);
      slice0cost_ready_words_9 <= to_integer(slice0cost_read_words_9);
      slice0cost_ready_words_10 <= to_integer(slice0cost_read_words_10);
      slice0cost_ready_words_11 <= to_integer(slice0cost_read_words_11);
      slice0cost_ready_words_12 <= to_integer(slice0cost_read_words_12);
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_ready_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_column_0_0_choice_2;
      slice0cost_column_0_1 <= slice0cost_column_0_1_choice_2;
      slice0cost_column_0_2 <= slice0cost_column_0_2_choice_2;
      slice0cost_column_0_3 <= slice0cost_column_0_3_choice_2;
      slice0cost_column_0_4 <= slice0cost_column_0_4_choice_2;
      slice0cost_column_0_5 <= slice0cost_column_0_5_choice_2;
      slice0cost_column_0_6 <= slice0cost_column_0_6_choice_2;
      slice0cost_column_0_7 <= slice0cost_column_0_7_choice_2;
      slice0cost_column_0_8 <= slice0cost_column_0_8_choice_2;
      slice0cost_column_0_9 <= slice0cost_column_0_9_choice_2;
      slice0cost_column_0_10 <= slice0cost_column_0_10_choice_2;
      slice0cost_column_0_11 <= slice0cost_column_0_11_choice_2;
      slice0cost_column_0_12 <= slice0cost_column_0_12_choice_2;
      slice0cost_column_0_13 <= slice0cost_column_0_13_choice_2;
      slice0cost_column_0_14 <= slice0cost_column_0_14_choice_2;
      slice0cost_column_0_15 <= slice0cost_column_0_15_choice_2;
      slice0cost_column_0_16 <= slice0cost_column_0_16_choice_2;
      slice0cost_column_0_17 <= slice0cost_column_0_17_choice_2;
      slice0cost_column_0_18 <= slice0cost_column_0_18_choice_2;
      slice0cost_column_0_19 <= slice0cost_column_0_19_choice_2;
      slice0cost_column_0_20 <= slice0cost_column_0_20_choice_2;
      slice0cost_column_0_21 <= slice0cost_column_0_21_choice_2;
      slice0cost_column_0_22 <= slice0cost_column_0_22_choice_2;
      slice0cost_column_0_23 <= slice0cost_column_0_23_choice_2;
      slice0cost_column_0_24 <= slice0cost_column_0_24_choice_2;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_row_start <= slice0cost_ready_tag_row_start;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_border_column <= slice0cost_ready_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_ready_tag_first_cost;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_ready_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_ready_tag_end_of_line;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_pixels_tag_valid then
        if slice0cost_pixels_tag_row_start then
          slice0cost_ready_column <= 0;
        else
          slice0cost_ready_column <= (slice0cost_ready_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        slice0cost_write_words_0 <= (slice0cost_column_0_1_choice_2 * 2048) + slice0cost_column_0_0_choice_2;
        slice0cost_write_words_1 <= (slice0cost_column_0_3_choice_2 * 2048) + slice0cost_column_0_2_choice_2;
        slice0cost_write_words_2 <= (slice0cost_column_0_5_choice_2 * 2048) + slice0cost_column_0_4_choice_2;
        slice0cost_write_words_3 <= (slice0cost_column_0_7_choice_2 * 2048) + slice0cost_column_0_6_choice_2;
        slice0cost_write_words_4 <= (slice0cost_column_0_9_choice_2 * 2048) + slice0cost_column_0_8_choice_2;
        slice0cost_write_words_5 <= (slice0cost_column_0_11_choice_2 * 2048) + slice0cost_column_0_10_choice_2;
        slice0cost_write_words_6 <= (slice0cost_column_0_13_choice_2 * 2048) + slice0cost_column_0_12_choice_2;
        slice0cost_write_words_7 <= (slice0cost_column_0_15_choice_2 * 2048) + slice0cost_column_0_14_choice_2;
        slice0cost_write_words_8 <= (slice0cost_column_0_17_choice_2 * 2048) + slice0cost_column_0_16_choice_2;
        slice0cost_write_words_9 <= (slice0cost_column_0_19_choice_2 * 2048) + slice0cost_column_0_18_choice_2;
        slice0cost_write_words_10 <= (slice0cost_column_0_21_choice_2 * 2048) + slice0cost_column_0_20_choice_2;
        slice0cost_write_words_11 <= (slice0cost_column_0_23_choice_2 * 2048) + slice0cost_column_0_22_choice_2;
        slice0cost_write_words_12 <= slice0cost_column_0_24_choice_2;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 7 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(10 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(21 downto 11));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_1(10 downto 0));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_1(21 downto 11));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_2(10 downto 0));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_2(21 downto 11));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_6_choice := to_integer(slice0window_leaving_3(10 downto 0));
      else
        slice0window_change_0_6_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_7_choice := to_integer(slice0window_leaving_3(21 downto 11));
      else
        slice0window_change_0_7_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_8_choice := to_integer(slice0window_leaving_4(10 downto 0));
      else
        slice0window_change_0_8_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_9_choice := to_integer(slice0window_leaving_4(21 downto 11));
      else
        slice0window_change_0_9_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_10_choice := to_integer(slice0window_leaving_5(10 downto 0));
      else
        slice0window_change_0_10_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_11_choice := to_integer(slice0window_leaving_5(21 downto 11));
      else
        slice0window_change_0_11_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_12_choice := to_integer(slice0window_leaving_6(10 downto 0));
      else
        slice0window_change_0_12_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_13_choice := to_integer(slice0window_leaving_6(21 downto 11));
      else
        slice0window_change_0_13_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_14_choice := to_integer(slice0window_leaving_7(10 downto 0));
      else
        slice0window_change_0_14_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_15_choice := to_integer(slice0window_leaving_7(21 downto 11));
      else
        slice0window_change_0_15_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_16_choice := to_integer(slice0window_leaving_8(10 downto 0));
      else
        slice0window_change_0_16_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_17_choice := to_integer(slice0window_leaving_8(21 downto 11));
      else
        slice0window_change_0_17_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_18_choice := to_integer(slice0window_leaving_9(10 downto 0));
      else
        slice0window_change_0_18_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_19_choice := to_integer(slice0window_leaving_9(21 downto 11));
      else
        slice0window_change_0_19_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_20_choice := to_integer(slice0window_leaving_10(10 downto 0));
      else
        slice0window_change_0_20_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_21_choice := to_integer(slice0window_leaving_10(21 downto 11));
      else
        slice0window_change_0_21_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_22_choice := to_integer(slice0window_leaving_11(10 downto 0));
      else
        slice0window_change_0_22_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_23_choice := to_integer(slice0window_leaving_11(21 downto 11));
      else
        slice0window_change_0_23_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_24_choice := to_integer(slice0window_leaving_12);
      else
        slice0window_change_0_24_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_0_3 <= slice0cost_column_0_3;
      slice0window_entering_0_4 <= slice0cost_column_0_4;
      slice0window_entering_0_5 <= slice0cost_column_0_5;
      slice0window_entering_0_6 <= slice0cost_column_0_6;
      slice0window_entering_0_7 <= slice0cost_column_0_7;
      slice0window_entering_0_8 <= slice0cost_column_0_8;
      slice0window_entering_0_9 <= slice0cost_column_0_9;
      slice0window_entering_0_10 <= slice0cost_column_0_10;
      slice0window_entering_0_11 <= slice0cost_column_0_11;
      slice0window_entering_0_12 <= slice0cost_column_0_12;
      slice0window_entering_0_13 <= slice0cost_column_0_13;
      slice0window_entering_0_14 <= slice0cost_column_0_14;
      slice0window_entering_0_15 <= slice0cost_column_0_15;
      slice0window_entering_0_16 <= slice0cost_column_0_16;
      slice0window_entering_0_17 <= slice0cost_column_0_17;
      slice0window_entering_0_18 <= slice0cost_column_0_18;
      slice0window_entering_0_19 <= slice0cost_column_0_19;
      slice0window_entering_0_20 <= slice0cost_column_0_20;
      slice0window_entering_0_21 <= slice0cost_column_0_21;
      slice0window_entering_0_22 <= slice0cost_column_0_22;
      slice0window_entering_0_23 <= slice0cost_column_0_23;
      slice0window_entering_0_24 <= slice0cost_column_0_24;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_first_group <= slice0cost_tag_first_group;
      slice0window_entering_tag_border_column <= slice0cost_tag_border_column;
      slice0window_entering_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_change_0_0 <= slice0window_entering_0_0 - slice0window_change_0_0_choice;
      slice0window_change_0_1 <= slice0window_entering_0_1 - slice0window_change_0_1_choice;
      slice0window_change_0_2 <= slice0window_entering_0_2 - slice0window_change_0_2_choice;
      slice0window_change_0_3 <= slice0window_entering_0_3 - slice0window_change_0_3_choice;
      slice0window_change_0_4 <= slice0window_entering_0_4 - slice0window_change_0_4_choice;
      slice0window_change_0_5 <= slice0window_entering_0_5 - slice0window_change_0_5_choice;
      slice0window_change_0_6 <= slice0window_entering_0_6 - slice0window_change_0_6_choice;
      slice0window_change_0_7 <= slice0window_entering_0_7 - slice0window_change_0_7_choice;
      slice0window_change_0_8 <= slice0window_entering_0_8 - slice0window_change_0_8_choice;
      slice0window_change_0_9 <= slice0window_entering_0_9 - slice0window_change_0_9_choice;
      slice0window_change_0_10 <= slice0window_entering_0_10 - slice0window_change_0_10_choice;
      slice0window_change_0_11 <= slice0window_entering_0_11 - slice0window_change_0_11_choice;
      slice0window_change_0_12 <= slice0window_entering_0_12 - slice0window_change_0_12_choice;
      slice0window_change_0_13 <= slice0window_entering_0_13 - slice0window_change_0_13_choice;
      slice0window_change_0_14 <= slice0window_entering_0_14 - slice0window_change_0_14_choice;
      slice0window_change_0_15 <= slice0window_entering_0_15 - slice0window_change_0_15_choice;
      slice0window_change_0_16 <= slice0window_entering_0_16 - slice0window_change_0_16_choice;
      slice0window_change_0_17 <= slice0window_entering_0_17 - slice0window_change_0_17_choice;
      slice0window_change_0_18 <= slice0window_entering_0_18 - slice0window_change_0_18_choice;
      slice0window_change_0_19 <= slice0window_entering_0_19 - slice0window_change_0_19_choice;
      slice0window_change_0_20 <= slice0window_entering_0_20 - slice0window_change_0_20_choice;
      slice0window_change_0_21 <= slice0window_entering_0_21 - slice0window_change_0_21_choice;
      slice0window_change_0_22 <= slice0window_entering_0_22 - slice0window_change_0_22_choice;
      slice0window_change_0_23 <= slice0window_entering_0_23 - slice0window_change_0_23_choice;
      slice0window_change_0_24 <= slice0window_entering_0_24 - slice0window_change_0_24_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_group <= slice0window_entering_tag_first_group;
      slice0window_change_tag_border_column <= slice0window_entering_tag_border_column;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_first_column_0 <= slice0window_change_tag_first_cost;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
      slice0window_centre_start_of_frame_2 <= slice0window_centre_start_of_frame_1;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_2;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_0_choice := 0;
      else
        slice0window_sum_0_0_choice := slice0window_sum_0_0;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_1_choice := 0;
      else
        slice0window_sum_0_1_choice := slice0window_sum_0_1;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_2_choice := 0;
      else
        slice0window_sum_0_2_choice := slice0window_sum_0_2;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_3_choice := 0;
      else
        slice0window_sum_0_3_choice := slice0window_sum_0_3;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_4_choice := 0;
      else
        slice0window_sum_0_4_choice := slice0window_sum_0_4;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_5_choice := 0;
      else
        slice0window_sum_0_5_choice := slice0window_sum_0_5;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_6_choice := 0;
      else
        slice0window_sum_0_6_choice := slice0window_sum_0_6;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_7_choice := 0;
      else
        slice0window_sum_0_7_choice := slice0window_sum_0_7;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_8_choice := 0;
      else
        slice0window_sum_0_8_choice := slice0window_sum_0_8;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_9_choice := 0;
      else
        slice0window_sum_0_9_choice := slice0window_sum_0_9;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_10_choice := 0;
      else
        slice0window_sum_0_10_choice := slice0window_sum_0_10;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_11_choice := 0;
      else
        slice0window_sum_0_11_choice := slice0window_sum_0_11;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_12_choice := 0;
      else
        slice0window_sum_0_12_choice := slice0window_sum_0_12;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_13_choice := 0;
      else
        slice0window_sum_0_13_choice := slice0window_sum_0_13;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_14_choice := 0;
      else
        slice0window_sum_0_14_choice := slice0window_sum_0_14;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_15_choice := 0;
      else
        slice0window_sum_0_15_choice := slice0window_sum_0_15;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_16_choice := 0;
      else
        slice0window_sum_0_16_choice := slice0window_sum_0_16;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_17_choice := 0;
      else
        slice0window_sum_0_17_choice := slice0window_sum_0_17;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_18_choice := 0;
      else
        slice0window_sum_0_18_choice := slice0window_sum_0_18;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_19_choice := 0;
      else
        slice0window_sum_0_19_choice := slice0window_sum_0_19;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_20_choice := 0;
      else
        slice0window_sum_0_20_choice := slice0window_sum_0_20;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_21_choice := 0;
      else
        slice0window_sum_0_21_choice := slice0window_sum_0_21;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_22_choice := 0;
      else
        slice0window_sum_0_22_choice := slice0window_sum_0_22;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_23_choice := 0;
      else
        slice0window_sum_0_23_choice := slice0window_sum_0_23;
      end if;
      if slice0window_change_tag_first_cost then
        slice0window_sum_0_24_choice := 0;
      else
        slice0window_sum_0_24_choice := slice0window_sum_0_24;
      end if;
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 16384;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 16384;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 16384;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 16384;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 16384;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 16384;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 16384;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 16384;
        slice0window_sum_0_8 <= (slice0window_sum_0_8_choice + slice0window_change_0_8) mod 16384;
        slice0window_sum_0_9 <= (slice0window_sum_0_9_choice + slice0window_change_0_9) mod 16384;
        slice0window_sum_0_10 <= (slice0window_sum_0_10_choice + slice0window_change_0_10) mod 16384;
        slice0window_sum_0_11 <= (slice0window_sum_0_11_choice + slice0window_change_0_11) mod 16384;
        slice0window_sum_0_12 <= (slice0window_sum_0_12_choice + slice0window_change_0_12) mod 16384;
        slice0window_sum_0_13 <= (slice0window_sum_0_13_choice + slice0window_change_0_13) mod 16384;
        slice0window_sum_0_14 <= (slice0window_sum_0_14_choice + slice0window_change_0_14) mod 16384;
        slice0window_sum_0_15 <= (slice0window_sum_0_15_choice + slice0window_change_0_15) mod 16384;
        slice0window_sum_0_16 <= (slice0window_sum_0_16_choice + slice0window_change_0_16) mod 16384;
        slice0window_sum_0_17 <= (slice0window_sum_0_17_choice + slice0window_change_0_17) mod 16384;
        slice0window_sum_0_18 <= (slice0window_sum_0_18_choice + slice0window_change_0_18) mod 16384;
        slice0window_sum_0_19 <= (slice0window_sum_0_19_choice + slice0window_change_0_19) mod 16384;
        slice0window_sum_0_20 <= (slice0window_sum_0_20_choice + slice0window_change_0_20) mod 16384;
        slice0window_sum_0_21 <= (slice0window_sum_0_21_choice + slice0window_change_0_21) mod 16384;
        slice0window_sum_0_22 <= (slice0window_sum_0_22_choice + slice0window_change_0_22) mod 16384;
        slice0window_sum_0_23 <= (slice0window_sum_0_23_choice + slice0window_change_0_23) mod 16384;
        slice0window_sum_0_24 <= (slice0window_sum_0_24_choice + slice0window_change_0_24) mod 16384;
      end if;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_best_cost_0_1_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_best_cost_0_2_is_less := (slice0window_sum_0_5 - slice0window_sum_0_4) < 0;
      slice0winner1_best_cost_0_3_is_less := (slice0window_sum_0_7 - slice0window_sum_0_6) < 0;
      slice0winner1_best_cost_0_4_is_less := (slice0window_sum_0_9 - slice0window_sum_0_8) < 0;
      slice0winner1_best_cost_0_5_is_less := (slice0window_sum_0_11 - slice0window_sum_0_10) < 0;
      slice0winner1_best_cost_0_6_is_less := (slice0window_sum_0_13 - slice0window_sum_0_12) < 0;
      slice0winner1_best_cost_0_7_is_less := (slice0window_sum_0_15 - slice0window_sum_0_14) < 0;
      slice0winner1_best_cost_0_8_is_less := (slice0window_sum_0_17 - slice0window_sum_0_16) < 0;
      slice0winner1_best_cost_0_9_is_less := (slice0window_sum_0_19 - slice0window_sum_0_18) < 0;
      slice0winner1_best_cost_0_10_is_less := (slice0window_sum_0_21 - slice0window_sum_0_20) < 0;
      slice0winner1_best_cost_0_11_is_less := (slice0window_sum_0_23 - slice0window_sum_0_22) < 0;
      slice0winner1_best_cost_0_12 <= slice0window_sum_0_24;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_index_0_12 <= 24;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_3;
        slice0winner1_best_index_0_1 <= 3;
      else
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_index_0_1 <= 2;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_5;
        slice0winner1_best_index_0_2 <= 5;
      else
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_index_0_2 <= 4;
      end if;
      if slice0winner1_best_cost_0_3_is_less then
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_7;
        slice0winner1_best_index_0_3 <= 7;
      else
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_index_0_3 <= 6;
      end if;
      if slice0winner1_best_cost_0_4_is_less then
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_9;
        slice0winner1_best_index_0_4 <= 9;
      else
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_8;
        slice0winner1_best_index_0_4 <= 8;
      end if;
      if slice0winner1_best_cost_0_5_is_less then
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_11;
        slice0winner1_best_index_0_5 <= 11;
      else
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_10;
        slice0winner1_best_index_0_5 <= 10;
      end if;
      if slice0winner1_best_cost_0_6_is_less then
        slice0winner1_best_cost_0_6 <= slice0window_sum_0_13;
        slice0winner1_best_index_0_6 <= 13;
      else
        slice0winner1_best_cost_0_6 <= slice0window_sum_0_12;
        slice0winner1_best_index_0_6 <= 12;
      end if;
      if slice0winner1_best_cost_0_7_is_less then
        slice0winner1_best_cost_0_7 <= slice0window_sum_0_15;
        slice0winner1_best_index_0_7 <= 15;
      else
        slice0winner1_best_cost_0_7 <= slice0window_sum_0_14;
        slice0winner1_best_index_0_7 <= 14;
      end if;
      if slice0winner1_best_cost_0_8_is_less then
        slice0winner1_best_cost_0_8 <= slice0window_sum_0_17;
        slice0winner1_best_index_0_8 <= 17;
      else
        slice0winner1_best_cost_0_8 <= slice0window_sum_0_16;
        slice0winner1_best_index_0_8 <= 16;
      end if;
      if slice0winner1_best_cost_0_9_is_less then
        slice0winner1_best_cost_0_9 <= slice0window_sum_0_19;
        slice0winner1_best_index_0_9 <= 19;
      else
        slice0winner1_best_cost_0_9 <= slice0window_sum_0_18;
        slice0winner1_best_index_0_9 <= 18;
      end if;
      if slice0winner1_best_cost_0_10_is_less then
        slice0winner1_best_cost_0_10 <= slice0window_sum_0_21;
        slice0winner1_best_index_0_10 <= 21;
      else
        slice0winner1_best_cost_0_10 <= slice0window_sum_0_20;
        slice0winner1_best_index_0_10 <= 20;
      end if;
      if slice0winner1_best_cost_0_11_is_less then
        slice0winner1_best_cost_0_11 <= slice0window_sum_0_23;
        slice0winner1_best_index_0_11 <= 23;
      else
        slice0winner1_best_cost_0_11 <= slice0window_sum_0_22;
        slice0winner1_best_index_0_11 <= 22;
      end if;
      if slice0winner3_tag_valid then
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_0_1_is_less := (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0;
      slice0winner2_best_cost_0_2_is_less := (slice0winner1_best_cost_0_5 - slice0winner1_best_cost_0_4) < 0;
      slice0winner2_best_cost_0_3_is_less := (slice0winner1_best_cost_0_7 - slice0winner1_best_cost_0_6) < 0;
      slice0winner2_best_cost_0_4_is_less := (slice0winner1_best_cost_0_9 - slice0winner1_best_cost_0_8) < 0;
      slice0winner2_best_cost_0_5_is_less := (slice0winner1_best_cost_0_11 - slice0winner1_best_cost_0_10) < 0;
      slice0winner2_best_cost_0_6 <= slice0winner1_best_cost_0_12;
      slice0winner2_best_index_0_6 <= slice0winner1_best_index_0_12;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
      end if;
      if slice0winner2_best_cost_0_1_is_less then
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_3;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
      else
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_2;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
      end if;
      if slice0winner2_best_cost_0_2_is_less then
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_5;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
      else
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_4;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
      end if;
      if slice0winner2_best_cost_0_3_is_less then
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_7;
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_7;
      else
        slice0winner2_best_cost_0_3 <= slice0winner1_best_cost_0_6;
        slice0winner2_best_index_0_3 <= slice0winner1_best_index_0_6;
      end if;
      if slice0winner2_best_cost_0_4_is_less then
        slice0winner2_best_cost_0_4 <= slice0winner1_best_cost_0_9;
        slice0winner2_best_index_0_4 <= slice0winner1_best_index_0_9;
      else
        slice0winner2_best_cost_0_4 <= slice0winner1_best_cost_0_8;
        slice0winner2_best_index_0_4 <= slice0winner1_best_index_0_8;
      end if;
      if slice0winner2_best_cost_0_5_is_less then
        slice0winner2_best_cost_0_5 <= slice0winner1_best_cost_0_11;
        slice0winner2_best_index_0_5 <= slice0winner1_best_index_0_11;
      else
        slice0winner2_best_cost_0_5 <= slice0winner1_best_cost_0_10;
        slice0winner2_best_index_0_5 <= slice0winner1_best_index_0_10;
      end if;
      if slice0winner3_tag_valid then
        slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      slice0winner3_best_cost_0_1_is_less := (slice0winner2_best_cost_0_3 - slice0winner2_best_cost_0_2) < 0;
      slice0winner3_best_cost_0_2_is_less := (slice0winner2_best_cost_0_5 - slice0winner2_best_cost_0_4) < 0;
      slice0winner3_best_cost_0_3 <= slice0winner2_best_cost_0_6;
      slice0winner3_best_index_0_3 <= slice0winner2_best_index_0_6;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      if slice0winner3_best_cost_0_0_is_less then
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_1;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
      else
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_0;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
      end if;
      if slice0winner3_best_cost_0_1_is_less then
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_3;
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_3;
      else
        slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_2;
        slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
      end if;
      if slice0winner3_best_cost_0_2_is_less then
        slice0winner3_best_cost_0_2 <= slice0winner2_best_cost_0_5;
        slice0winner3_best_index_0_2 <= slice0winner2_best_index_0_5;
      else
        slice0winner3_best_cost_0_2 <= slice0winner2_best_cost_0_4;
        slice0winner3_best_index_0_2 <= slice0winner2_best_index_0_4;
      end if;
      if slice0winner3_tag_valid then
        slice0winner3_tag_output_column <= slice4window_centre_output_column_1;
        slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
        slice0winner3_tag_end_of_line <= slice4window_centre_end_of_line_1;
      end if;
      -- slice0winner4
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0_1 - slice0winner3_best_cost_0_0) < 0;
      slice0winner4_best_cost_0_1_is_less := (slice0winner3_best_cost_0_3 - slice0winner3_best_cost_0_2) < 0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_output_column <= slice0winner3_tag_output_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if slice0winner4_best_cost_0_0_is_less then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_1;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_0;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
      end if;
      if slice0winner4_best_cost_0_1_is_less then
        slice0winner4_best_cost_0_1 <= slice0winner3_best_cost_0_3;
        slice0winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice0winner4_best_cost_0_1 <= slice0winner3_best_cost_0_2;
        slice0winner4_best_index_0_1 <= slice0winner3_best_index_0_2;
      end if;
      -- slice0winner5
      slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0_1 - slice0winner4_best_cost_0_0) < 0;
      slice0winner5_tag_valid <= slice0winner4_tag_valid;
      slice0winner5_tag_output_column <= slice0winner4_tag_output_column;
      slice0winner5_tag_start_of_frame <= slice0winner4_tag_start_of_frame;
      slice0winner5_tag_end_of_line <= slice0winner4_tag_end_of_line;
      if slice0winner5_best_cost_0_0_is_less then
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0_1;
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_1;
      else
        slice0winner5_best_cost_0_0 <= slice0winner4_best_cost_0_0;
        slice0winner5_best_index_0_0 <= slice0winner4_best_index_0_0;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
      slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 96;
      slice0_best_tag_valid <= slice0winner5_tag_valid;
      slice0_best_tag_output_column <= slice0winner5_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner5_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner5_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice1shift_search_0_3;
        slice1shift_search_0_3 <= slice1shift_search_0_4;
        slice1shift_search_0_4 <= slice1shift_search_0_5;
        slice1shift_search_0_5 <= slice1shift_search_0_6;
        slice1shift_search_0_6 <= slice1shift_search_0_7;
        slice1shift_search_0_7 <= slice1shift_search_0_8;
        slice1shift_search_0_8 <= slice1shift_search_0_9;
        slice1shift_search_0_9 <= slice1shift_search_0_10;
        slice1shift_search_0_10 <= slice1shift_search_0_11;
        slice1shift_search_0_11 <= slice1shift_search_0_12;
        slice1shift_search_0_12 <= slice1shift_search_0_13;
        slice1shift_search_0_13 <= slice1shift_search_0_14;
        slice1shift_search_0_14 <= slice1shift_search_0_15;
        slice1shift_search_0_15 <= slice1shift_search_0_16;
        slice1shift_search_0_16 <= slice1shift_search_0_17;
        slice1shift_search_0_17 <= slice1shift_search_0_18;
        slice1shift_search_0_18 <= slice1shift_search_0_19;
        slice1shift_search_0_19 <= slice1shift_search_0_20;
        slice1shift_search_0_20 <= slice1shift_search_0_21;
        slice1shift_search_0_21 <= slice1shift_search_0_22;
        slice1shift_search_0_22 <= slice1shift_search_0_23;
        slice1shift_search_0_23 <= slice1shift_search_0_24;
        slice1shift_search_0_24 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice1shift_search_1_3;
        slice1shift_search_1_3 <= slice1shift_search_1_4;
        slice1shift_search_1_4 <= slice1shift_search_1_5;
        slice1shift_search_1_5 <= slice1shift_search_1_6;
        slice1shift_search_1_6 <= slice1shift_search_1_7;
        slice1shift_search_1_7 <= slice1shift_search_1_8;
        slice1shift_search_1_8 <= slice1shift_search_1_9;
        slice1shift_search_1_9 <= slice1shift_search_1_10;
        slice1shift_search_1_10 <= slice1shift_search_1_11;
        slice1shift_search_1_11 <= slice1shift_search_1_12;
        slice1shift_search_1_12 <= slice1shift_search_1_13;
        slice1shift_search_1_13 <= slice1shift_search_1_14;
        slice1shift_search_1_14 <= slice1shift_search_1_15;
        slice1shift_search_1_15 <= slice1shift_search_1_16;
        slice1shift_search_1_16 <= slice1shift_search_1_17;
        slice1shift_search_1_17 <= slice1shift_search_1_18;
        slice1shift_search_1_18 <= slice1shift_search_1_19;
        slice1shift_search_1_19 <= slice1shift_search_1_20;
        slice1shift_search_1_20 <= slice1shift_search_1_21;
        slice1shift_search_1_21 <= slice1shift_search_1_22;
        slice1shift_search_1_22 <= slice1shift_search_1_23;
        slice1shift_search_1_23 <= slice1shift_search_1_24;
        slice1shift_search_1_24 <= slice0shift_search_out_1;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_search_out_0 <= slice1shift_search_0_0;
      slice1shift_search_out_1 <= slice1shift_search_1_0;
      -- slice1cost
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := slice1cost_ready_words_0 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0_choice_2 := 0;
      else
        slice1cost_column_0_0_choice_2 := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := slice1cost_ready_words_0 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_1_choice_2 := 0;
      else
        slice1cost_column_0_1_choice_2 := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := slice1cost_ready_words_1 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_2_choice_2 := 0;
      else
        slice1cost_column_0_2_choice_2 := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := slice1cost_ready_words_1 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_3_choice_2 := 0;
      else
        slice1cost_column_0_3_choice_2 := (slice1cost_change_0_3 + slice1cost_column_0_3_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := slice1cost_ready_words_2 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_4_choice_2 := 0;
      else
        slice1cost_column_0_4_choice_2 := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := slice1cost_ready_words_2 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_5_choice_2 := 0;
      else
        slice1cost_column_0_5_choice_2 := (slice1cost_change_0_5 + slice1cost_column_0_5_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_6_choice := 0;
      else
        slice1cost_column_0_6_choice := slice1cost_ready_words_3 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_6_choice_2 := 0;
      else
        slice1cost_column_0_6_choice_2 := (slice1cost_change_0_6 + slice1cost_column_0_6_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_7_choice := 0;
      else
        slice1cost_column_0_7_choice := slice1cost_ready_words_3 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_7_choice_2 := 0;
      else
        slice1cost_column_0_7_choice_2 := (slice1cost_change_0_7 + slice1cost_column_0_7_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_8_choice := 0;
      else
        slice1cost_column_0_8_choice := slice1cost_ready_words_4 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_8_choice_2 := 0;
      else
        slice1cost_column_0_8_choice_2 := (slice1cost_change_0_8 + slice1cost_column_0_8_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_9_choice := 0;
      else
        slice1cost_column_0_9_choice := slice1cost_ready_words_4 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_9_choice_2 := 0;
      else
        slice1cost_column_0_9_choice_2 := (slice1cost_change_0_9 + slice1cost_column_0_9_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_10_choice := 0;
      else
        slice1cost_column_0_10_choice := slice1cost_ready_words_5 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_10_choice_2 := 0;
      else
        slice1cost_column_0_10_choice_2 := (slice1cost_change_0_10 + slice1cost_column_0_10_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_11_choice := 0;
      else
        slice1cost_column_0_11_choice := slice1cost_ready_words_5 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_11_choice_2 := 0;
      else
        slice1cost_column_0_11_choice_2 := (slice1cost_change_0_11 + slice1cost_column_0_11_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_12_choice := 0;
      else
        slice1cost_column_0_12_choice := slice1cost_ready_words_6 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_12_choice_2 := 0;
      else
        slice1cost_column_0_12_choice_2 := (slice1cost_change_0_12 + slice1cost_column_0_12_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_13_choice := 0;
      else
        slice1cost_column_0_13_choice := slice1cost_ready_words_6 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_13_choice_2 := 0;
      else
        slice1cost_column_0_13_choice_2 := (slice1cost_change_0_13 + slice1cost_column_0_13_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_14_choice := 0;
      else
        slice1cost_column_0_14_choice := slice1cost_ready_words_7 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_14_choice_2 := 0;
      else
        slice1cost_column_0_14_choice_2 := (slice1cost_change_0_14 + slice1cost_column_0_14_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_15_choice := 0;
      else
        slice1cost_column_0_15_choice := slice1cost_ready_words_7 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_15_choice_2 := 0;
      else
        slice1cost_column_0_15_choice_2 := (slice1cost_change_0_15 + slice1cost_column_0_15_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_16_choice := 0;
      else
        slice1cost_column_0_16_choice := slice1cost_ready_words_8 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_16_choice_2 := 0;
      else
        slice1cost_column_0_16_choice_2 := (slice1cost_change_0_16 + slice1cost_column_0_16_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_17_choice := 0;
      else
        slice1cost_column_0_17_choice := slice1cost_ready_words_8 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_17_choice_2 := 0;
      else
        slice1cost_column_0_17_choice_2 := (slice1cost_change_0_17 + slice1cost_column_0_17_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_18_choice := 0;
      else
        slice1cost_column_0_18_choice := slice1cost_ready_words_9 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_18_choice_2 := 0;
      else
        slice1cost_column_0_18_choice_2 := (slice1cost_change_0_18 + slice1cost_column_0_18_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_19_choice := 0;
      else
        slice1cost_column_0_19_choice := slice1cost_ready_words_9 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_19_choice_2 := 0;
      else
        slice1cost_column_0_19_choice_2 := (slice1cost_change_0_19 + slice1cost_column_0_19_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_20_choice := 0;
      else
        slice1cost_column_0_20_choice := slice1cost_ready_words_10 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_20_choice_2 := 0;
      else
        slice1cost_column_0_20_choice_2 := (slice1cost_change_0_20 + slice1cost_column_0_20_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_21_choice := 0;
      else
        slice1cost_column_0_21_choice := slice1cost_ready_words_10 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_21_choice_2 := 0;
      else
        slice1cost_column_0_21_choice_2 := (slice1cost_change_0_21 + slice1cost_column_0_21_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_22_choice := 0;
      else
        slice1cost_column_0_22_choice := slice1cost_ready_words_11 mod 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_22_choice_2 := 0;
      else
        slice1cost_column_0_22_choice_2 := (slice1cost_change_0_22 + slice1cost_column_0_22_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_23_choice := 0;
      else
        slice1cost_column_0_23_choice := slice1cost_ready_words_11 / 2048;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_23_choice_2 := 0;
      else
        slice1cost_column_0_23_choice_2 := (slice1cost_change_0_23 + slice1cost_column_0_23_choice) mod 2048;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_24_choice := 0;
      else
        slice1cost_column_0_24_choice := slice1cost_ready_words_12;
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_24_choice_2 := 0;
      else
        slice1cost_column_0_24_choice_2 := (slice1cost_change_0_24 + slice1cost_column_0_24_choice) mod 2048;
      end if;
      slice1cost_pixels_first_0_0 <= slice1shift_search_0_0 - slice1shift_reference_0;
      slice1cost_pixels_first_0_1 <= slice1shift_search_0_1 - slice1shift_reference_0;
      slice1cost_pixels_first_0_2 <= slice1shift_search_0_2 - slice1shift_reference_0;
      slice1cost_pixels_first_0_3 <= slice1shift_search_0_3 - slice1shift_reference_0;
      slice1cost_pixels_first_0_4 <= slice1shift_search_0_4 - slice1shift_reference_0;
      slice1cost_pixels_first_0_5 <= slice1shift_search_0_5 - slice1shift_reference_0;
      slice1cost_pixels_first_0_6 <= slice1shift_search_0_6 - slice1shift_reference_0;
      slice1cost_pixels_first_0_7 <= slice1shift_search_0_7 - slice1shift_reference_0;
      slice1cost_pixels_first_0_8 <= slice1shift_search_0_8 - slice1shift_reference_0;
      slice1cost_pixels_first_0_9 <= slice1shift_search_0_9 - slice1shift_reference_0;
      slice1cost_pixels_first_0_10 <= slice1shift_search_0_10 - slice1shift_reference_0;
      slice1cost_pixels_first_0_11 <= slice1shift_search_0_11 - slice1shift_reference_0;
      slice1cost_pixels_first_0_12 <= slice1shift_search_0_12 - slice1shift_reference_0;
      slice1cost_pixels_first_0_13 <= slice1shift_search_0_13 - slice1shift_reference_0;
      slice1cost_pixels_first_0_14 <= slice1shift_search_0_14 - slice1shift_reference_0;
      slice1cost_pixels_first_0_15 <= slice1shift_search_0_15 - slice1shift_reference_0;
      slice1cost_pixels_first_0_16 <= slice1shift_search_0_16 - slice1shift_reference_0;
      slice1cost_pixels_first_0_17 <= slice1shift_search_0_17 - slice1shift_reference_0;
      slice1cost_pixels_first_0_18 <= slice1shift_search_0_18 - slice1shift_reference_0;
      slice1cost_pixels_first_0_19 <= slice1shift_search_0_19 - slice1shift_reference_0;
      slice1cost_pixels_first_0_20 <= slice1shift_search_0_20 - slice1shift_reference_0;
      slice1cost_pixels_first_0_21 <= slice1shift_search_0_21 - slice1shift_reference_0;
      slice1cost_pixels_first_0_22 <= slice1shift_search_0_22 - slice1shift_reference_0;
      slice1cost_pixels_first_0_23 <= slice1shift_search_0_23 - slice1shift_reference_0;
      slice1cost_pixels_first_0_24 <= slice1shift_search_0_24 - slice1shift_reference_0;
      slice1cost_pixels_first_1_0 <= slice1shift_search_1_0 - slice1shift_reference_1;
      slice1cost_pixels_first_1_1 <= slice1shift_search_1_1 - slice1shift_reference_1;
      slice1cost_pixels_first_1_2 <= slice1shift_search_1_2 - slice1shift_reference_1;
      slice1cost_pixels_first_1_3 <= slice1shift_search_1_3 - slice1shift_reference_1;
      slice1cost_pixels_first_1_4 <= slice1shift_search_1_4 - slice1shift_reference_1;
      slice1cost_pixels_first_1_5 <= slice1shift_search_1_5 - slice1shift_reference_1;
      slice1cost_pixels_first_1_6 <= slice1shift_search_1_6 - slice1shift_reference_1;
      slice1cost_pixels_first_1_7 <= slice1shift_search_1_7 - slice1shift_reference_1;
      slice1cost_pixels_first_1_8 <= slice1shift_search_1_8 - slice1shift_reference_1;
      slice1cost_pixels_first_1_9 <= slice1shift_search_1_9 - slice1shift_reference_1;
      slice1cost_pixels_first_1_10 <= slice1shift_search_1_10 - slice1shift_reference_1;
      slice1cost_pixels_first_1_11 <= slice1shift_search_1_11 - slice1shift_reference_1;
      slice1cost_pixels_first_1_12 <= slice1shift_search_1_12 - slice1shift_reference_1;
      slice1cost_pixels_first_1_13 <= slice1shift_search_1_13 - slice1shift_reference_1;
      slice1cost_pixels_first_1_14 <= slice1shift_search_1_14 - slice1shift_reference_1;
      slice1cost_pixels_first_1_15 <= slice1shift_search_1_15 - slice1shift_reference_1;
      slice1cost_pixels_first_1_16 <= slice1shift_search_1_16 - slice1shift_reference_1;
      slice1cost_pixels_first_1_17 <= slice1shift_search_1_17 - slice1shift_reference_1;
      slice1cost_pixels_first_1_18 <= slice1shift_search_1_18 - slice1shift_reference_1;
      slice1cost_pixels_first_1_19 <= slice1shift_search_1_19 - slice1shift_reference_1;
      slice1cost_pixels_first_1_20 <= slice1shift_search_1_20 - slice1shift_reference_1;
      slice1cost_pixels_first_1_21 <= slice1shift_search_1_21 - slice1shift_reference_1;
      slice1cost_pixels_first_1_22 <= slice1shift_search_1_22 - slice1shift_reference_1;
      slice1cost_pixels_first_1_23 <= slice1shift_search_1_23 - slice1shift_reference_1;
      slice1cost_pixels_first_1_24 <= slice1shift_search_1_24 - slice1shift_reference_1;
      slice1cost_pixels_cost_0_0 <= (folded(slice1cost_pixels_first_0_0) + as_number((slice1cost_pixels_first_0_0 <
        0))) mod 256;
      slice1cost_pixels_cost_0_1 <= (folded(slice1cost_pixels_first_0_1) + as_number((slice1cost_pixels_first_0_1 <
        0))) mod 256;
      slice1cost_pixels_cost_0_2 <= (folded(slice1cost_pixels_first_0_2) + as_number((slice1cost_pixels_first_0_2 <
        0))) mod 256;
      slice1cost_pixels_cost_0_3 <= (folded(slice1cost_pixels_first_0_3) + as_number((slice1cost_pixels_first_0_3 <
        0))) mod 256;
      slice1cost_pixels_cost_0_4 <= (folded(slice1cost_pixels_first_0_4) + as_number((slice1cost_pixels_first_0_4 <
        0))) mod 256;
      slice1cost_pixels_cost_0_5 <= (folded(slice1cost_pixels_first_0_5) + as_number((slice1cost_pixels_first_0_5 <
        0))) mod 256;
      slice1cost_pixels_cost_0_6 <= (folded(slice1cost_pixels_first_0_6) + as_number((slice1cost_pixels_first_0_6 <
        0))) mod 256;
      slice1cost_pixels_cost_0_7 <= (folded(slice1cost_pixels_first_0_7) + as_number((slice1cost_pixels_first_0_7 <
        0))) mod 256;
      slice1cost_pixels_cost_0_8 <= (folded(slice1cost_pixels_first_0_8) + as_number((slice1cost_pixels_first_0_8 <
        0))) mod 256;
      slice1cost_pixels_cost_0_9 <= (folded(slice1cost_pixels_first_0_9) + as_number((slice1cost_pixels_first_0_9 <
        0))) mod 256;
      slice1cost_pixels_cost_0_10 <= (folded(slice1cost_pixels_first_0_10) + as_number((slice1cost_pixels_first_0_10 <
        0))) mod 256;
      slice1cost_pixels_cost_0_11 <= (folded(slice1cost_pixels_first_0_11) + as_number((slice1cost_pixels_first_0_11 <
        0))) mod 256;
      slice1cost_pixels_cost_0_12 <= (folded(slice1cost_pixels_first_0_12) + as_number((slice1cost_pixels_first_0_12 <
        0))) mod 256;
      slice1cost_pixels_cost_0_13 <= (folded(slice1cost_pixels_first_0_13) + as_number((slice1cost_pixels_first_0_13 <
        0))) mod 256;
      slice1cost_pixels_cost_0_14 <= (folded(slice1cost_pixels_first_0_14) + as_number((slice1cost_pixels_first_0_14 <
        0))) mod 256;
      slice1cost_pixels_cost_0_15 <= (folded(slice1cost_pixels_first_0_15) + as_number((slice1cost_pixels_first_0_15 <
        0))) mod 256;
      slice1cost_pixels_cost_0_16 <= (folded(slice1cost_pixels_first_0_16) + as_number((slice1cost_pixels_first_0_16 <
        0))) mod 256;
      slice1cost_pixels_cost_0_17 <= (folded(slice1cost_pixels_first_0_17) + as_number((slice1cost_pixels_first_0_17 <
        0))) mod 256;
      slice1cost_pixels_cost_0_18 <= (folded(slice1cost_pixels_first_0_18) + as_number((slice1cost_pixels_first_0_18 <
        0))) mod 256;
      slice1cost_pixels_cost_0_19 <= (folded(slice1cost_pixels_first_0_19) + as_number((slice1cost_pixels_first_0_19 <
        0))) mod 256;
      slice1cost_pixels_cost_0_20 <= (folded(slice1cost_pixels_first_0_20) + as_number((slice1cost_pixels_first_0_20 <
        0))) mod 256;
      slice1cost_pixels_cost_0_21 <= (folded(slice1cost_pixels_first_0_21) + as_number((slice1cost_pixels_first_0_21 <
        0))) mod 256;
      slice1cost_pixels_cost_0_22 <= (folded(slice1cost_pixels_first_0_22) + as_number((slice1cost_pixels_first_0_22 <
        0))) mod 256;
      slice1cost_pixels_cost_0_23 <= (folded(slice1cost_pixels_first_0_23) + as_number((slice1cost_pixels_first_0_23 <
        0))) mod 256;
      slice1cost_pixels_cost_0_24 <= (folded(slice1cost_pixels_first_0_24) + as_number((slice1cost_pixels_first_0_24 <
        0))) mod 256;
      slice1cost_pixels_cost_1_0 <= (folded(slice1cost_pixels_first_1_0) + as_number((slice1cost_pixels_first_1_0 <
        0))) mod 256;
      slice1cost_pixels_cost_1_1 <= (folded(slice1cost_pixels_first_1_1) + as_number((slice1cost_pixels_first_1_1 <
        0))) mod 256;
      slice1cost_pixels_cost_1_2 <= (folded(slice1cost_pixels_first_1_2) + as_number((slice1cost_pixels_first_1_2 <
        0))) mod 256;
      slice1cost_pixels_cost_1_3 <= (folded(slice1cost_pixels_first_1_3) + as_number((slice1cost_pixels_first_1_3 <
        0))) mod 256;
      slice1cost_pixels_cost_1_4 <= (folded(slice1cost_pixels_first_1_4) + as_number((slice1cost_pixels_first_1_4 <
        0))) mod 256;
      slice1cost_pixels_cost_1_5 <= (folded(slice1cost_pixels_first_1_5) + as_number((slice1cost_pixels_first_1_5 <
        0))) mod 256;
      slice1cost_pixels_cost_1_6 <= (folded(slice1cost_pixels_first_1_6) + as_number((slice1cost_pixels_first_1_6 <
        0))) mod 256;
      slice1cost_pixels_cost_1_7 <= (folded(slice1cost_pixels_first_1_7) + as_number((slice1cost_pixels_first_1_7 <
        0))) mod 256;
      slice1cost_pixels_cost_1_8 <= (folded(slice1cost_pixels_first_1_8) + as_number((slice1cost_pixels_first_1_8 <
        0))) mod 256;
      slice1cost_pixels_cost_1_9 <= (folded(slice1cost_pixels_first_1_9) + as_number((slice1cost_pixels_first_1_9 <
        0))) mod 256;
      slice1cost_pixels_cost_1_10 <= (folded(slice1cost_pixels_first_1_10) + as_number((slice1cost_pixels_first_1_10 <
        0))) mod 256;
      slice1cost_pixels_cost_1_11 <= (folded(slice1cost_pixels_first_1_11) + as_number((slice1cost_pixels_first_1_11 <
        0))) mod 256;
      slice1cost_pixels_cost_1_12 <= (folded(slice1cost_pixels_first_1_12) + as_number((slice1cost_pixels_first_1_12 <
        0))) mod 256;
      slice1cost_pixels_cost_1_13 <= (folded(slice1cost_pixels_first_1_13) + as_number((slice1cost_pixels_first_1_13 <
        0))) mod 256;
      slice1cost_pixels_cost_1_14 <= (folded(slice1cost_pixels_first_1_14) + as_number((slice1cost_pixels_first_1_14 <
        0))) mod 256;
      slice1cost_pixels_cost_1_15 <= (folded(slice1cost_pixels_first_1_15) + as_number((slice1cost_pixels_first_1_15 <
        0))) mod 256;
      slice1cost_pixels_cost_1_16 <= (folded(slice1cost_pixels_first_1_16) + as_number((slice1cost_pixels_first_1_16 <
        0))) mod 256;
      slice1cost_pixels_cost_1_17 <= (folded(slice1cost_pixels_first_1_17) + as_number((slice1cost_pixels_first_1_17 <
        0))) mod 256;
      slice1cost_pixels_cost_1_18 <= (folded(slice1cost_pixels_first_1_18) + as_number((slice1cost_pixels_first_1_18 <
        0))) mod 256;
      slice1cost_pixels_cost_1_19 <= (folded(slice1cost_pixels_first_1_19) + as_number((slice1cost_pixels_first_1_19 <
        0))) mod 256;
      slice1cost_pixels_cost_1_20 <= (folded(slice1cost_pixels_first_1_20) + as_number((slice1cost_pixels_first_1_20 <
        0))) mod 256;
      slice1cost_pixels_cost_1_21 <= (folded(slice1cost_pixels_first_1_21) + as_number((slice1cost_pixels_first_1_21 <
        0))) mod 256;
      slice1cost_pixels_cost_1_22 <= (folded(slice1cost_pixels_first_1_22) + as_number((slice1cost_pixels_first_1_22 <
        0))) mod 256;
      slice1cost_pixels_cost_1_23 <= (folded(slice1cost_pixels_first_1_23) + as_number((slice1cost_pixels_first_1_23 <
        0))) mod 256;
      slice1cost_pixels_cost_1_24 <= (folded(slice1cost_pixels_first_1_24) + as_number((slice1cost_pixels_first_1_24 <
        0))) mod 256;
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice0cost_change_column;
      slice1cost_change_0_0 <= slice1cost_pixels_cost_1_0 - slice1cost_pixels_cost_0_0;
      slice1cost_change_0_1 <= slice1cost_pixels_cost_1_1 - slice1cost_pixels_cost_0_1;
      slice1cost_change_0_2 <= slice1cost_pixels_cost_1_2 - slice1cost_pixels_cost_0_2;
      slice1cost_change_0_3 <= slice1cost_pixels_cost_1_3 - slice1cost_pixels_cost_0_3;
      slice1cost_change_0_4 <= slice1cost_pixels_cost_1_4 - slice1cost_pixels_cost_0_4;
      slice1cost_change_0_5 <= slice1cost_pixels_cost_1_5 - slice1cost_pixels_cost_0_5;
      slice1cost_change_0_6 <= slice1cost_pixels_cost_1_6 - slice1cost_pixels_cost_0_6;
      slice1cost_change_0_7 <= slice1cost_pixels_cost_1_7 - slice1cost_pixels_cost_0_7;
      slice1cost_change_0_8 <= slice1cost_pixels_cost_1_8 - slice1cost_pixels_cost_0_8;
      slice1cost_change_0_9 <= slice1cost_pixels_cost_1_9 - slice1cost_pixels_cost_0_9;
      slice1cost_change_0_10 <= slice1cost_pixels_cost_1_10 - slice1cost_pixels_cost_0_10;
      slice1cost_change_0_11 <= slice1cost_pixels_cost_1_11 - slice1cost_pixels_cost_0_11;
      slice1cost_change_0_12 <= slice1cost_pixels_cost_1_12 - slice1cost_pixels_cost_0_12;
      slice1cost_change_0_13 <= slice1cost_pixels_cost_1_13 - slice1cost_pixels_cost_0_13;
      slice1cost_change_0_14 <= slice1cost_pixels_cost_1_14 - slice1cost_pixels_cost_0_14;
      slice1cost_change_0_15 <= slice1cost_pixels_cost_1_15 - slice1cost_pixels_cost_0_15;
      slice1cost_change_0_16 <= slice1cost_pixels_cost_1_16 - slice1cost_pixels_cost_0_16;
      slice1cost_change_0_17 <= slice1cost_pixels_cost_1_17 - slice1cost_pixels_cost_0_17;
      slice1cost_change_0_18 <= slice1cost_pixels_cost_1_18 - slice1cost_pixels_cost_0_18;
      slice1cost_change_0_19 <= slice1cost_pixels_cost_1_19 - slice1cost_pixels_cost_0_19;
      slice1cost_change_0_20 <= slice1cost_pixels_cost_1_20 - slice1cost_pixels_cost_0_20;
      slice1cost_change_0_21 <= slice1cost_pixels_cost_1_21 - slice1cost_pixels_cost_0_21;
      slice1cost_change_0_22 <= slice1cost_pixels_cost_1_22 - slice1cost_pixels_cost_0_22;
      slice1cost_change_0_23 <= slice1cost_pixels_cost_1_23 - slice1cost_pixels_cost_0_23;
      slice1cost_change_0_24 <= slice1cost_pixels_cost_1_24 - slice1cost_pixels_cost_0_24;
      slice1cost_ready_words_0 <= to_integer(slice1cost_read_words_0);
      slice1cost_ready_words_1 <= to_integer(slice1cost_read_words_1);
      slice1cost_ready_words_2 <= to_integer(slice1cost_read_words_2);
      slice1cost_ready_words_3 <= to_integer(slice1cost_read_words_3);
      slice1cost_ready_words_4 <= to_integer(slice1cost_read_words_4);
      slice1cost_ready_words_5 <= to_integer(slice1cost_read_words_5);
      slice1cost_ready_words_6 <= to_integer(slice1cost_read_words_6);
      slice1cost_ready_words_7 <= to_integer(slice1cost_read_words_7);
      slice1cost_ready_words_8 <= to_integer(slice1cost_read_words_8);
      slice1cost_ready_words_9 <= to_integer(slice1cost_read_words_9);
      slice1cost_ready_words_10 <= to_integer(slice1cost_read_words_10);
      slice1cost_ready_words_11 <= to_integer(slice1cost_read_words_11);
      slice1cost_ready_words_12 <= to_integer(slice1cost_read_words_12);
      slice1cost_ready_column <= slice1cost_change_column;
      slice1cost_column_0_0 <= slice1cost_column_0_0_choice_2;
      slice1cost_column_0_1 <= slice1cost_column_0_1_choice_2;
      slice1cost_column_0_2 <= slice1cost_column_0_2_choice_2;
      slice1cost_column_0_3 <= slice1cost_column_0_3_choice_2;
      slice1cost_column_0_4 <= slice1cost_column_0_4_choice_2;
      slice1cost_column_0_5 <= slice1cost_column_0_5_choice_2;
      slice1cost_column_0_6 <= slice1cost_column_0_6_choice_2;
      slice1cost_column_0_7 <= slice1cost_column_0_7_choice_2;
      slice1cost_column_0_8 <= slice1cost_column_0_8_choice_2;
      slice1cost_column_0_9 <= slice1cost_column_0_9_choice_2;
      slice1cost_column_0_10 <= slice1cost_column_0_10_choice_2;
      slice1cost_column_0_11 <= slice1cost_column_0_11_choice_2;
      slice1cost_column_0_12 <= slice1cost_column_0_12_choice_2;
      slice1cost_column_0_13 <= slice1cost_column_0_13_choice_2;
      slice1cost_column_0_14 <= slice1cost_column_0_14_choice_2;
      slice1cost_column_0_15 <= slice1cost_column_0_15_choice_2;
      slice1cost_column_0_16 <= slice1cost_column_0_16_choice_2;
      slice1cost_column_0_17 <= slice1cost_column_0_17_choice_2;
      slice1cost_column_0_18 <= slice1cost_column_0_18_choice_2;
      slice1cost_column_0_19 <= slice1cost_column_0_19_choice_2;
      slice1cost_column_0_20 <= slice1cost_column_0_20_choice_2;
      slice1cost_column_0_21 <= slice1cost_column_0_21_choice_2;
      slice1cost_column_0_22 <= slice1cost_column_0_22_choice_2;
      slice1cost_column_0_23 <= slice1cost_column_0_23_choice_2;
      slice1cost_column_0_24 <= slice1cost_column_0_24_choice_2;
      slice1cost_write_column <= slice0cost_write_column;
      if slice0cost_tag_valid then
        slice1cost_write_words_0 <= (slice1cost_column_0_1_choice_2 * 2048) + slice1cost_column_0_0_choice_2;
        slice1cost_write_words_1 <= (slice1cost_column_0_3_choice_2 * 2048) + slice1cost_column_0_2_choice_2;
        slice1cost_write_words_2 <= (slice1cost_column_0_5_choice_2 * 2048) + slice1cost_column_0_4_choice_2;
        slice1cost_write_words_3 <= (slice1cost_column_0_7_choice_2 * 2048) + slice1cost_column_0_6_choice_2;
        slice1cost_write_words_4 <= (slice1cost_column_0_9_choice_2 * 2048) + slice1cost_column_0_8_choice_2;
        slice1cost_write_words_5 <= (slice1cost_column_0_11_choice_2 * 2048) + slice1cost_column_0_10_choice_2;
        slice1cost_write_words_6 <= (slice1cost_column_0_13_choice_2 * 2048) + slice1cost_column_0_12_choice_2;
        slice1cost_write_words_7 <= (slice1cost_column_0_15_choice_2 * 2048) + slice1cost_column_0_14_choice_2;
        slice1cost_write_words_8 <= (slice1cost_column_0_17_choice_2 * 2048) + slice1cost_column_0_16_choice_2;
        slice1cost_write_words_9 <= (slice1cost_column_0_19_choice_2 * 2048) + slice1cost_column_0_18_choice_2;
        slice1cost_write_words_10 <= (slice1cost_column_0_21_choice_2 * 2048) + slice1cost_column_0_20_choice_2;
        slice1cost_write_words_11 <= (slice1cost_column_0_23_choice_2 * 2048) + slice1cost_column_0_22_choice_2;
        slice1cost_write_words_12 <= slice1cost_column_0_24_choice_2;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 7 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(10 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(21 downto 11));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_1(10 downto 0));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_1(21 downto 11));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_2(10 downto 0));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_2(21 downto 11));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_6_choice := to_integer(slice1window_leaving_3(10 downto 0));
      else
        slice1window_change_0_6_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_7_choice := to_integer(slice1window_leaving_3(21 downto 11));
      else
        slice1window_change_0_7_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_8_choice := to_integer(slice1window_leaving_4(10 downto 0));
      else
        slice1window_change_0_8_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_9_choice := to_integer(slice1window_leaving_4(21 downto 11));
      else
        slice1window_change_0_9_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_10_choice := to_integer(slice1window_leaving_5(10 downto 0));
      else
        slice1window_change_0_10_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_11_choice := to_integer(slice1window_leaving_5(21 downto 11));
      else
        slice1window_change_0_11_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_12_choice := to_integer(slice1window_leaving_6(10 downto 0));
      else
        slice1window_change_0_12_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_13_choice := to_integer(slice1window_leaving_6(21 downto 11));
      else
        slice1window_change_0_13_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_14_choice := to_integer(slice1window_leaving_7(10 downto 0));
      else
        slice1window_change_0_14_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_15_choice := to_integer(slice1window_leaving_7(21 downto 11));
      else
        slice1window_change_0_15_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_16_choice := to_integer(slice1window_leaving_8(10 downto 0));
      else
        slice1window_change_0_16_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_17_choice := to_integer(slice1window_leaving_8(21 downto 11));
      else
        slice1window_change_0_17_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_18_choice := to_integer(slice1window_leaving_9(10 downto 0));
      else
        slice1window_change_0_18_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_19_choice := to_integer(slice1window_leaving_9(21 downto 11));
      else
        slice1window_change_0_19_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_20_choice := to_integer(slice1window_leaving_10(10 downto 0));
      else
        slice1window_change_0_20_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_21_choice := to_integer(slice1window_leaving_10(21 downto 11));
      else
        slice1window_change_0_21_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_22_choice := to_integer(slice1window_leaving_11(10 downto 0));
      else
        slice1window_change_0_22_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_23_choice := to_integer(slice1window_leaving_11(21 downto 11));
      else
        slice1window_change_0_23_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_24_choice := to_integer(slice1window_leaving_12);
      else
        slice1window_change_0_24_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_0_3 <= slice1cost_column_0_3;
      slice1window_entering_0_4 <= slice1cost_column_0_4;
      slice1window_entering_0_5 <= slice1cost_column_0_5;
      slice1window_entering_0_6 <= slice1cost_column_0_6;
      slice1window_entering_0_7 <= slice1cost_column_0_7;
      slice1window_entering_0_8 <= slice1cost_column_0_8;
      slice1window_entering_0_9 <= slice1cost_column_0_9;
      slice1window_entering_0_10 <= slice1cost_column_0_10;
      slice1window_entering_0_11 <= slice1cost_column_0_11;
      slice1window_entering_0_12 <= slice1cost_column_0_12;
      slice1window_entering_0_13 <= slice1cost_column_0_13;
      slice1window_entering_0_14 <= slice1cost_column_0_14;
      slice1window_entering_0_15 <= slice1cost_column_0_15;
      slice1window_entering_0_16 <= slice1cost_column_0_16;
      slice1window_entering_0_17 <= slice1cost_column_0_17;
      slice1window_entering_0_18 <= slice1cost_column_0_18;
      slice1window_entering_0_19 <= slice1cost_column_0_19;
      slice1window_entering_0_20 <= slice1cost_column_0_20;
      slice1window_entering_0_21 <= slice1cost_column_0_21;
      slice1window_entering_0_22 <= slice1cost_column_0_22;
      slice1window_entering_0_23 <= slice1cost_column_0_23;
      slice1window_entering_0_24 <= slice1cost_column_0_24;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_0_3 <= slice1window_entering_0_3 - slice1window_change_0_3_choice;
      slice1window_change_0_4 <= slice1window_entering_0_4 - slice1window_change_0_4_choice;
      slice1window_change_0_5 <= slice1window_entering_0_5 - slice1window_change_0_5_choice;
      slice1window_change_0_6 <= slice1window_entering_0_6 - slice1window_change_0_6_choice;
      slice1window_change_0_7 <= slice1window_entering_0_7 - slice1window_change_0_7_choice;
      slice1window_change_0_8 <= slice1window_entering_0_8 - slice1window_change_0_8_choice;
      slice1window_change_0_9 <= slice1window_entering_0_9 - slice1window_change_0_9_choice;
      slice1window_change_0_10 <= slice1window_entering_0_10 - slice1window_change_0_10_choice;
      slice1window_change_0_11 <= slice1window_entering_0_11 - slice1window_change_0_11_choice;
      slice1window_change_0_12 <= slice1window_entering_0_12 - slice1window_change_0_12_choice;
      slice1window_change_0_13 <= slice1window_entering_0_13 - slice1window_change_0_13_choice;
      slice1window_change_0_14 <= slice1window_entering_0_14 - slice1window_change_0_14_choice;
      slice1window_change_0_15 <= slice1window_entering_0_15 - slice1window_change_0_15_choice;
      slice1window_change_0_16 <= slice1window_entering_0_16 - slice1window_change_0_16_choice;
      slice1window_change_0_17 <= slice1window_entering_0_17 - slice1window_change_0_17_choice;
      slice1window_change_0_18 <= slice1window_entering_0_18 - slice1window_change_0_18_choice;
      slice1window_change_0_19 <= slice1window_entering_0_19 - slice1window_change_0_19_choice;
      slice1window_change_0_20 <= slice1window_entering_0_20 - slice1window_change_0_20_choice;
      slice1window_change_0_21 <= slice1window_entering_0_21 - slice1window_change_0_21_choice;
      slice1window_change_0_22 <= slice1window_entering_0_22 - slice1window_change_0_22_choice;
      slice1window_change_0_23 <= slice1window_entering_0_23 - slice1window_change_0_23_choice;
      slice1window_change_0_24 <= slice1window_entering_0_24 - slice1window_change_0_24_choice;
      slice1window_change_tag_first_group <= slice0window_change_tag_first_group;
      slice1window_change_tag_border_column <= slice0window_change_tag_border_column;
      slice1window_change_tag_leaves_window <= slice0window_change_tag_leaves_window;
      slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
      slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
      slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_0_choice := 0;
      else
        slice1window_sum_0_0_choice := slice1window_sum_0_0;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_1_choice := 0;
      else
        slice1window_sum_0_1_choice := slice1window_sum_0_1;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_2_choice := 0;
      else
        slice1window_sum_0_2_choice := slice1window_sum_0_2;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_3_choice := 0;
      else
        slice1window_sum_0_3_choice := slice1window_sum_0_3;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_4_choice := 0;
      else
        slice1window_sum_0_4_choice := slice1window_sum_0_4;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_5_choice := 0;
      else
        slice1window_sum_0_5_choice := slice1window_sum_0_5;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_6_choice := 0;
      else
        slice1window_sum_0_6_choice := slice1window_sum_0_6;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_7_choice := 0;
      else
        slice1window_sum_0_7_choice := slice1window_sum_0_7;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_8_choice := 0;
      else
        slice1window_sum_0_8_choice := slice1window_sum_0_8;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_9_choice := 0;
      else
        slice1window_sum_0_9_choice := slice1window_sum_0_9;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_10_choice := 0;
      else
        slice1window_sum_0_10_choice := slice1window_sum_0_10;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_11_choice := 0;
      else
        slice1window_sum_0_11_choice := slice1window_sum_0_11;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_12_choice := 0;
      else
        slice1window_sum_0_12_choice := slice1window_sum_0_12;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_13_choice := 0;
      else
        slice1window_sum_0_13_choice := slice1window_sum_0_13;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_14_choice := 0;
      else
        slice1window_sum_0_14_choice := slice1window_sum_0_14;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_15_choice := 0;
      else
        slice1window_sum_0_15_choice := slice1window_sum_0_15;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_16_choice := 0;
      else
        slice1window_sum_0_16_choice := slice1window_sum_0_16;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_17_choice := 0;
      else
        slice1window_sum_0_17_choice := slice1window_sum_0_17;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_18_choice := 0;
      else
        slice1window_sum_0_18_choice := slice1window_sum_0_18;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_19_choice := 0;
      else
        slice1window_sum_0_19_choice := slice1window_sum_0_19;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_20_choice := 0;
      else
        slice1window_sum_0_20_choice := slice1window_sum_0_20;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_21_choice := 0;
      else
        slice1window_sum_0_21_choice := slice1window_sum_0_21;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_22_choice := 0;
      else
        slice1window_sum_0_22_choice := slice1window_sum_0_22;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_23_choice := 0;
      else
        slice1window_sum_0_23_choice := slice1window_sum_0_23;
      end if;
      if slice0window_centre_first_column_0 then
        slice1window_sum_0_24_choice := 0;
      else
        slice1window_sum_0_24_choice := slice1window_sum_0_24;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 16384;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 16384;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 16384;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 16384;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 16384;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 16384;
        slice1window_sum_0_6 <= (slice1window_sum_0_6_choice + slice1window_change_0_6) mod 16384;
        slice1window_sum_0_7 <= (slice1window_sum_0_7_choice + slice1window_change_0_7) mod 16384;
        slice1window_sum_0_8 <= (slice1window_sum_0_8_choice + slice1window_change_0_8) mod 16384;
        slice1window_sum_0_9 <= (slice1window_sum_0_9_choice + slice1window_change_0_9) mod 16384;
        slice1window_sum_0_10 <= (slice1window_sum_0_10_choice + slice1window_change_0_10) mod 16384;
        slice1window_sum_0_11 <= (slice1window_sum_0_11_choice + slice1window_change_0_11) mod 16384;
        slice1window_sum_0_12 <= (slice1window_sum_0_12_choice + slice1window_change_0_12) mod 16384;
        slice1window_sum_0_13 <= (slice1window_sum_0_13_choice + slice1window_change_0_13) mod 16384;
        slice1window_sum_0_14 <= (slice1window_sum_0_14_choice + slice1window_change_0_14) mod 16384;
        slice1window_sum_0_15 <= (slice1window_sum_0_15_choice + slice1window_change_0_15) mod 16384;
        slice1window_sum_0_16 <= (slice1window_sum_0_16_choice + slice1window_change_0_16) mod 16384;
        slice1window_sum_0_17 <= (slice1window_sum_0_17_choice + slice1window_change_0_17) mod 16384;
        slice1window_sum_0_18 <= (slice1window_sum_0_18_choice + slice1window_change_0_18) mod 16384;
        slice1window_sum_0_19 <= (slice1window_sum_0_19_choice + slice1window_change_0_19) mod 16384;
        slice1window_sum_0_20 <= (slice1window_sum_0_20_choice + slice1window_change_0_20) mod 16384;
        slice1window_sum_0_21 <= (slice1window_sum_0_21_choice + slice1window_change_0_21) mod 16384;
        slice1window_sum_0_22 <= (slice1window_sum_0_22_choice + slice1window_change_0_22) mod 16384;
        slice1window_sum_0_23 <= (slice1window_sum_0_23_choice + slice1window_change_0_23) mod 16384;
        slice1window_sum_0_24 <= (slice1window_sum_0_24_choice + slice1window_change_0_24) mod 16384;
      end if;
      -- slice1winner1
      slice1winner1_best_cost_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_best_cost_0_1_is_less := (slice1window_sum_0_3 - slice1window_sum_0_2) < 0;
      slice1winner1_best_cost_0_2_is_less := (slice1window_sum_0_5 - slice1window_sum_0_4) < 0;
      slice1winner1_best_cost_0_3_is_less := (slice1window_sum_0_7 - slice1window_sum_0_6) < 0;
      slice1winner1_best_cost_0_4_is_less := (slice1window_sum_0_9 - slice1window_sum_0_8) < 0;
      slice1winner1_best_cost_0_5_is_less := (slice1window_sum_0_11 - slice1window_sum_0_10) < 0;
      slice1winner1_best_cost_0_6_is_less := (slice1window_sum_0_13 - slice1window_sum_0_12) < 0;
      slice1winner1_best_cost_0_7_is_less := (slice1window_sum_0_15 - slice1window_sum_0_14) < 0;
      slice1winner1_best_cost_0_8_is_less := (slice1window_sum_0_17 - slice1window_sum_0_16) < 0;
      slice1winner1_best_cost_0_9_is_less := (slice1window_sum_0_19 - slice1window_sum_0_18) < 0;
      slice1winner1_best_cost_0_10_is_less := (slice1window_sum_0_21 - slice1window_sum_0_20) < 0;
      slice1winner1_best_cost_0_11_is_less := (slice1window_sum_0_23 - slice1window_sum_0_22) < 0;
      slice1winner1_best_cost_0_12 <= slice1window_sum_0_24;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      if slice1winner1_best_cost_0_1_is_less then
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_3;
        slice1winner1_best_index_0_1 <= 3;
      else
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_2;
        slice1winner1_best_index_0_1 <= 2;
      end if;
      if slice1winner1_best_cost_0_2_is_less then
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_5;
        slice1winner1_best_index_0_2 <= 5;
      else
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_4;
        slice1winner1_best_index_0_2 <= 4;
      end if;
      if slice1winner1_best_cost_0_3_is_less then
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_7;
        slice1winner1_best_index_0_3 <= 7;
      else
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_6;
        slice1winner1_best_index_0_3 <= 6;
      end if;
      if slice1winner1_best_cost_0_4_is_less then
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_9;
        slice1winner1_best_index_0_4 <= 9;
      else
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_8;
        slice1winner1_best_index_0_4 <= 8;
      end if;
      if slice1winner1_best_cost_0_5_is_less then
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_11;
        slice1winner1_best_index_0_5 <= 11;
      else
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_10;
        slice1winner1_best_index_0_5 <= 10;
      end if;
      if slice1winner1_best_cost_0_6_is_less then
        slice1winner1_best_cost_0_6 <= slice1window_sum_0_13;
        slice1winner1_best_index_0_6 <= 13;
      else
        slice1winner1_best_cost_0_6 <= slice1window_sum_0_12;
        slice1winner1_best_index_0_6 <= 12;
      end if;
      if slice1winner1_best_cost_0_7_is_less then
        slice1winner1_best_cost_0_7 <= slice1window_sum_0_15;
        slice1winner1_best_index_0_7 <= 15;
      else
        slice1winner1_best_cost_0_7 <= slice1window_sum_0_14;
        slice1winner1_best_index_0_7 <= 14;
      end if;
      if slice1winner1_best_cost_0_8_is_less then
        slice1winner1_best_cost_0_8 <= slice1window_sum_0_17;
        slice1winner1_best_index_0_8 <= 17;
      else
        slice1winner1_best_cost_0_8 <= slice1window_sum_0_16;
        slice1winner1_best_index_0_8 <= 16;
      end if;
      if slice1winner1_best_cost_0_9_is_less then
        slice1winner1_best_cost_0_9 <= slice1window_sum_0_19;
        slice1winner1_best_index_0_9 <= 19;
      else
        slice1winner1_best_cost_0_9 <= slice1window_sum_0_18;
        slice1winner1_best_index_0_9 <= 18;
      end if;
      if slice1winner1_best_cost_0_10_is_less then
        slice1winner1_best_cost_0_10 <= slice1window_sum_0_21;
        slice1winner1_best_index_0_10 <= 21;
      else
        slice1winner1_best_cost_0_10 <= slice1window_sum_0_20;
        slice1winner1_best_index_0_10 <= 20;
      end if;
      if slice1winner1_best_cost_0_11_is_less then
        slice1winner1_best_cost_0_11 <= slice1window_sum_0_23;
        slice1winner1_best_index_0_11 <= 23;
      else
        slice1winner1_best_cost_0_11 <= slice1window_sum_0_22;
        slice1winner1_best_index_0_11 <= 22;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_cost_0_1_is_less := (slice1winner1_best_cost_0_3 - slice1winner1_best_cost_0_2) < 0;
      slice1winner2_best_cost_0_2_is_less := (slice1winner1_best_cost_0_5 - slice1winner1_best_cost_0_4) < 0;
      slice1winner2_best_cost_0_3_is_less := (slice1winner1_best_cost_0_7 - slice1winner1_best_cost_0_6) < 0;
      slice1winner2_best_cost_0_4_is_less := (slice1winner1_best_cost_0_9 - slice1winner1_best_cost_0_8) < 0;
      slice1winner2_best_cost_0_5_is_less := (slice1winner1_best_cost_0_11 - slice1winner1_best_cost_0_10) < 0;
      slice1winner2_best_cost_0_6 <= slice1winner1_best_cost_0_12;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
      end if;
      if slice1winner2_best_cost_0_1_is_less then
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_3;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
      else
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_2;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
      end if;
      if slice1winner2_best_cost_0_2_is_less then
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_5;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
      else
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_4;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
      end if;
      if slice1winner2_best_cost_0_3_is_less then
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_7;
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_7;
      else
        slice1winner2_best_cost_0_3 <= slice1winner1_best_cost_0_6;
        slice1winner2_best_index_0_3 <= slice1winner1_best_index_0_6;
      end if;
      if slice1winner2_best_cost_0_4_is_less then
        slice1winner2_best_cost_0_4 <= slice1winner1_best_cost_0_9;
        slice1winner2_best_index_0_4 <= slice1winner1_best_index_0_9;
      else
        slice1winner2_best_cost_0_4 <= slice1winner1_best_cost_0_8;
        slice1winner2_best_index_0_4 <= slice1winner1_best_index_0_8;
      end if;
      if slice1winner2_best_cost_0_5_is_less then
        slice1winner2_best_cost_0_5 <= slice1winner1_best_cost_0_11;
        slice1winner2_best_index_0_5 <= slice1winner1_best_index_0_11;
      else
        slice1winner2_best_cost_0_5 <= slice1winner1_best_cost_0_10;
        slice1winner2_best_index_0_5 <= slice1winner1_best_index_0_10;
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0_1 - slice1winner2_best_cost_0_0) < 0;
      slice1winner3_best_cost_0_1_is_less := (slice1winner2_best_cost_0_3 - slice1winner2_best_cost_0_2) < 0;
      slice1winner3_best_cost_0_2_is_less := (slice1winner2_best_cost_0_5 - slice1winner2_best_cost_0_4) < 0;
      slice1winner3_best_cost_0_3 <= slice1winner2_best_cost_0_6;
      if slice1winner3_best_cost_0_0_is_less then
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_1;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
      else
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
      end if;
      if slice1winner3_best_cost_0_1_is_less then
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_3;
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_3;
      else
        slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_2;
        slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
      end if;
      if slice1winner3_best_cost_0_2_is_less then
        slice1winner3_best_cost_0_2 <= slice1winner2_best_cost_0_5;
        slice1winner3_best_index_0_2 <= slice1winner2_best_index_0_5;
      else
        slice1winner3_best_cost_0_2 <= slice1winner2_best_cost_0_4;
        slice1winner3_best_index_0_2 <= slice1winner2_best_index_0_4;
      end if;
      -- slice1winner4
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0_1 - slice1winner3_best_cost_0_0) < 0;
      slice1winner4_best_cost_0_1_is_less := (slice1winner3_best_cost_0_3 - slice1winner3_best_cost_0_2) < 0;
      if slice1winner4_best_cost_0_0_is_less then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_1;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_0;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
      end if;
      if slice1winner4_best_cost_0_1_is_less then
        slice1winner4_best_cost_0_1 <= slice1winner3_best_cost_0_3;
        slice1winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice1winner4_best_cost_0_1 <= slice1winner3_best_cost_0_2;
        slice1winner4_best_index_0_1 <= slice1winner3_best_index_0_2;
      end if;
      -- slice1winner5
      slice1winner5_best_cost_0_0_is_less := (slice1winner4_best_cost_0_1 - slice1winner4_best_cost_0_0) < 0;
      if slice1winner5_best_cost_0_0_is_less then
        slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0_1;
        slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_1;
      else
        slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0_0;
        slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_0;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner5_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner5_best_index_0_0 + 71;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0_0 <= slice2shift_search_0_1;
        slice2shift_search_0_1 <= slice2shift_search_0_2;
        slice2shift_search_0_2 <= slice2shift_search_0_3;
        slice2shift_search_0_3 <= slice2shift_search_0_4;
        slice2shift_search_0_4 <= slice2shift_search_0_5;
        slice2shift_search_0_5 <= slice2shift_search_0_6;
        slice2shift_search_0_6 <= slice2shift_search_0_7;
        slice2shift_search_0_7 <= slice2shift_search_0_8;
        slice2shift_search_0_8 <= slice2shift_search_0_9;
        slice2shift_search_0_9 <= slice2shift_search_0_10;
        slice2shift_search_0_10 <= slice2shift_search_0_11;
        slice2shift_search_0_11 <= slice2shift_search_0_12;
        slice2shift_search_0_12 <= slice2shift_search_0_13;
        slice2shift_search_0_13 <= slice2shift_search_0_14;
        slice2shift_search_0_14 <= slice2shift_search_0_15;
        slice2shift_search_0_15 <= slice2shift_search_0_16;
        slice2shift_search_0_16 <= slice2shift_search_0_17;
        slice2shift_search_0_17 <= slice2shift_search_0_18;
        slice2shift_search_0_18 <= slice2shift_search_0_19;
        slice2shift_search_0_19 <= slice2shift_search_0_20;
        slice2shift_search_0_20 <= slice2shift_search_0_21;
        slice2shift_search_0_21 <= slice2shift_search_0_22;
        slice2shift_search_0_22 <= slice2shift_search_0_23;
        slice2shift_search_0_23 <= slice2shift_search_0_24;
        slice2shift_search_0_24 <= slice1shift_search_out_0;
        slice2shift_search_1_0 <= slice2shift_search_1_1;
        slice2shift_search_1_1 <= slice2shift_search_1_2;
        slice2shift_search_1_2 <= slice2shift_search_1_3;
        slice2shift_search_1_3 <= slice2shift_search_1_4;
        slice2shift_search_1_4 <= slice2shift_search_1_5;
        slice2shift_search_1_5 <= slice2shift_search_1_6;
        slice2shift_search_1_6 <= slice2shift_search_1_7;
        slice2shift_search_1_7 <= slice2shift_search_1_8;
        slice2shift_search_1_8 <= slice2shift_search_1_9;
        slice2shift_search_1_9 <= slice2shift_search_1_10;
        slice2shift_search_1_10 <= slice2shift_search_1_11;
        slice2shift_search_1_11 <= slice2shift_search_1_12;
        slice2shift_search_1_12 <= slice2shift_search_1_13;
        slice2shift_search_1_13 <= slice2shift_search_1_14;
        slice2shift_search_1_14 <= slice2shift_search_1_15;
        slice2shift_search_1_15 <= slice2shift_search_1_16;
        slice2shift_search_1_16 <= slice2shift_search_1_17;
        slice2shift_search_1_17 <= slice2shift_search_1_18;
        slice2shift_search_1_18 <= slice2shift_search_1_19;
        slice2shift_search_1_19 <= slice2shift_search_1_20;
        slice2shift_search_1_20 <= slice2shift_search_1_21;
        slice2shift_search_1_21 <= slice2shift_search_1_22;
        slice2shift_search_1_22 <= slice2shift_search_1_23;
        slice2shift_search_1_23 <= slice2shift_search_1_24;
        slice2shift_search_1_24 <= slice1shift_search_out_1;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_reference_1 <= slice1shift_reference_1;
      slice2shift_search_out_0 <= slice2shift_search_0_0;
      slice2shift_search_out_1 <= slice2shift_search_1_0;
      -- slice2cost
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_0_choice := 0;
      else
        slice2cost_column_0_0_choice := slice2cost_ready_words_0 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_0_choice_2 := 0;
      else
        slice2cost_column_0_0_choice_2 := (slice2cost_change_0_0 + slice2cost_column_0_0_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_1_choice := 0;
      else
        slice2cost_column_0_1_choice := slice2cost_ready_words_0 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_1_choice_2 := 0;
      else
        slice2cost_column_0_1_choice_2 := (slice2cost_change_0_1 + slice2cost_column_0_1_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_2_choice := 0;
      else
        slice2cost_column_0_2_choice := slice2cost_ready_words_1 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_2_choice_2 := 0;
      else
        slice2cost_column_0_2_choice_2 := (slice2cost_change_0_2 + slice2cost_column_0_2_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_3_choice := 0;
      else
        slice2cost_column_0_3_choice := slice2cost_ready_words_1 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_3_choice_2 := 0;
      else
        slice2cost_column_0_3_choice_2 := (slice2cost_change_0_3 + slice2cost_column_0_3_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_4_choice := 0;
      else
        slice2cost_column_0_4_choice := slice2cost_ready_words_2 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_4_choice_2 := 0;
      else
        slice2cost_column_0_4_choice_2 := (slice2cost_change_0_4 + slice2cost_column_0_4_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_5_choice := 0;
      else
        slice2cost_column_0_5_choice := slice2cost_ready_words_2 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_5_choice_2 := 0;
      else
        slice2cost_column_0_5_choice_2 := (slice2cost_change_0_5 + slice2cost_column_0_5_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_6_choice := 0;
      else
        slice2cost_column_0_6_choice := slice2cost_ready_words_3 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_6_choice_2 := 0;
      else
        slice2cost_column_0_6_choice_2 := (slice2cost_change_0_6 + slice2cost_column_0_6_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_7_choice := 0;
      else
        slice2cost_column_0_7_choice := slice2cost_ready_words_3 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_7_choice_2 := 0;
      else
        slice2cost_column_0_7_choice_2 := (slice2cost_change_0_7 + slice2cost_column_0_7_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_8_choice := 0;
      else
        slice2cost_column_0_8_choice := slice2cost_ready_words_4 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_8_choice_2 := 0;
      else
        slice2cost_column_0_8_choice_2 := (slice2cost_change_0_8 + slice2cost_column_0_8_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_9_choice := 0;
      else
        slice2cost_column_0_9_choice := slice2cost_ready_words_4 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_9_choice_2 := 0;
      else
        slice2cost_column_0_9_choice_2 := (slice2cost_change_0_9 + slice2cost_column_0_9_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_10_choice := 0;
      else
        slice2cost_column_0_10_choice := slice2cost_ready_words_5 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_10_choice_2 := 0;
      else
        slice2cost_column_0_10_choice_2 := (slice2cost_change_0_10 + slice2cost_column_0_10_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_11_choice := 0;
      else
        slice2cost_column_0_11_choice := slice2cost_ready_words_5 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_11_choice_2 := 0;
      else
        slice2cost_column_0_11_choice_2 := (slice2cost_change_0_11 + slice2cost_column_0_11_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_12_choice := 0;
      else
        slice2cost_column_0_12_choice := slice2cost_ready_words_6 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_12_choice_2 := 0;
      else
        slice2cost_column_0_12_choice_2 := (slice2cost_change_0_12 + slice2cost_column_0_12_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_13_choice := 0;
      else
        slice2cost_column_0_13_choice := slice2cost_ready_words_6 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_13_choice_2 := 0;
      else
        slice2cost_column_0_13_choice_2 := (slice2cost_change_0_13 + slice2cost_column_0_13_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_14_choice := 0;
      else
        slice2cost_column_0_14_choice := slice2cost_ready_words_7 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_14_choice_2 := 0;
      else
        slice2cost_column_0_14_choice_2 := (slice2cost_change_0_14 + slice2cost_column_0_14_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_15_choice := 0;
      else
        slice2cost_column_0_15_choice := slice2cost_ready_words_7 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_15_choice_2 := 0;
      else
        slice2cost_column_0_15_choice_2 := (slice2cost_change_0_15 + slice2cost_column_0_15_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_16_choice := 0;
      else
        slice2cost_column_0_16_choice := slice2cost_ready_words_8 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_16_choice_2 := 0;
      else
        slice2cost_column_0_16_choice_2 := (slice2cost_change_0_16 + slice2cost_column_0_16_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_17_choice := 0;
      else
        slice2cost_column_0_17_choice := slice2cost_ready_words_8 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_17_choice_2 := 0;
      else
        slice2cost_column_0_17_choice_2 := (slice2cost_change_0_17 + slice2cost_column_0_17_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_18_choice := 0;
      else
        slice2cost_column_0_18_choice := slice2cost_ready_words_9 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_18_choice_2 := 0;
      else
        slice2cost_column_0_18_choice_2 := (slice2cost_change_0_18 + slice2cost_column_0_18_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_19_choice := 0;
      else
        slice2cost_column_0_19_choice := slice2cost_ready_words_9 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_19_choice_2 := 0;
      else
        slice2cost_column_0_19_choice_2 := (slice2cost_change_0_19 + slice2cost_column_0_19_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_20_choice := 0;
      else
        slice2cost_column_0_20_choice := slice2cost_ready_words_10 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_20_choice_2 := 0;
      else
        slice2cost_column_0_20_choice_2 := (slice2cost_change_0_20 + slice2cost_column_0_20_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_21_choice := 0;
      else
        slice2cost_column_0_21_choice := slice2cost_ready_words_10 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_21_choice_2 := 0;
      else
        slice2cost_column_0_21_choice_2 := (slice2cost_change_0_21 + slice2cost_column_0_21_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_22_choice := 0;
      else
        slice2cost_column_0_22_choice := slice2cost_ready_words_11 mod 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_22_choice_2 := 0;
      else
        slice2cost_column_0_22_choice_2 := (slice2cost_change_0_22 + slice2cost_column_0_22_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_23_choice := 0;
      else
        slice2cost_column_0_23_choice := slice2cost_ready_words_11 / 2048;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_23_choice_2 := 0;
      else
        slice2cost_column_0_23_choice_2 := (slice2cost_change_0_23 + slice2cost_column_0_23_choice) mod 2048;
      end if;
      if slice0window_entering_tag_first_group then
        slice2cost_column_0_24_choice := 0;
      else
        slice2cost_column_0_24_choice := slice2cost_ready_words_12;
      end if;
      if slice0window_entering_tag_border_column then
        slice2cost_column_0_24_choice_2 := 0;
      else
        slice2cost_column_0_24_choice_2 := (slice2cost_change_0_24 + slice2cost_column_0_24_choice) mod 2048;
      end if;
      slice2cost_pixels_first_0_0 <= slice2shift_search_0_0 - slice2shift_reference_0;
      slice2cost_pixels_first_0_1 <= slice2shift_search_0_1 - slice2shift_reference_0;
      slice2cost_pixels_first_0_2 <= slice2shift_search_0_2 - slice2shift_reference_0;
      slice2cost_pixels_first_0_3 <= slice2shift_search_0_3 - slice2shift_reference_0;
      slice2cost_pixels_first_0_4 <= slice2shift_search_0_4 - slice2shift_reference_0;
      slice2cost_pixels_first_0_5 <= slice2shift_search_0_5 - slice2shift_reference_0;
      slice2cost_pixels_first_0_6 <= slice2shift_search_0_6 - slice2shift_reference_0;
      slice2cost_pixels_first_0_7 <= slice2shift_search_0_7 - slice2shift_reference_0;
      slice2cost_pixels_first_0_8 <= slice2shift_search_0_8 - slice2shift_reference_0;
      slice2cost_pixels_first_0_9 <= slice2shift_search_0_9 - slice2shift_reference_0;
      slice2cost_pixels_first_0_10 <= slice2shift_search_0_10 - slice2shift_reference_0;
      slice2cost_pixels_first_0_11 <= slice2shift_search_0_11 - slice2shift_reference_0;
      slice2cost_pixels_first_0_12 <= slice2shift_search_0_12 - slice2shift_reference_0;
      slice2cost_pixels_first_0_13 <= slice2shift_search_0_13 - slice2shift_reference_0;
      slice2cost_pixels_first_0_14 <= slice2shift_search_0_14 - slice2shift_reference_0;
      slice2cost_pixels_first_0_15 <= slice2shift_search_0_15 - slice2shift_reference_0;
      slice2cost_pixels_first_0_16 <= slice2shift_search_0_16 - slice2shift_reference_0;
      slice2cost_pixels_first_0_17 <= slice2shift_search_0_17 - slice2shift_reference_0;
      slice2cost_pixels_first_0_18 <= slice2shift_search_0_18 - slice2shift_reference_0;
      slice2cost_pixels_first_0_19 <= slice2shift_search_0_19 - slice2shift_reference_0;
      slice2cost_pixels_first_0_20 <= slice2shift_search_0_20 - slice2shift_reference_0;
      slice2cost_pixels_first_0_21 <= slice2shift_search_0_21 - slice2shift_reference_0;
      slice2cost_pixels_first_0_22 <= slice2shift_search_0_22 - slice2shift_reference_0;
      slice2cost_pixels_first_0_23 <= slice2shift_search_0_23 - slice2shift_reference_0;
      slice2cost_pixels_first_0_24 <= slice2shift_search_0_24 - slice2shift_reference_0;
      slice2cost_pixels_first_1_0 <= slice2shift_search_1_0 - slice2shift_reference_1;
      slice2cost_pixels_first_1_1 <= slice2shift_search_1_1 - slice2shift_reference_1;
      slice2cost_pixels_first_1_2 <= slice2shift_search_1_2 - slice2shift_reference_1;
      slice2cost_pixels_first_1_3 <= slice2shift_search_1_3 - slice2shift_reference_1;
      slice2cost_pixels_first_1_4 <= slice2shift_search_1_4 - slice2shift_reference_1;
      slice2cost_pixels_first_1_5 <= slice2shift_search_1_5 - slice2shift_reference_1;
      slice2cost_pixels_first_1_6 <= slice2shift_search_1_6 - slice2shift_reference_1;
      slice2cost_pixels_first_1_7 <= slice2shift_search_1_7 - slice2shift_reference_1;
      slice2cost_pixels_first_1_8 <= slice2shift_search_1_8 - slice2shift_reference_1;
      slice2cost_pixels_first_1_9 <= slice2shift_search_1_9 - slice2shift_reference_1;
      slice2cost_pixels_first_1_10 <= slice2shift_search_1_10 - slice2shift_reference_1;
      slice2cost_pixels_first_1_11 <= slice2shift_search_1_11 - slice2shift_reference_1;
      slice2cost_pixels_first_1_12 <= slice2shift_search_1_12 - slice2shift_reference_1;
      slice2cost_pixels_first_1_13 <= slice2shift_search_1_13 - slice2shift_reference_1;
      slice2cost_pixels_first_1_14 <= slice2shift_search_1_14 - slice2shift_reference_1;
      slice2cost_pixels_first_1_15 <= slice2shift_search_1_15 - slice2shift_reference_1;
      slice2cost_pixels_first_1_16 <= slice2shift_search_1_16 - slice2shift_reference_1;
      slice2cost_pixels_first_1_17 <= slice2shift_search_1_17 - slice2shift_reference_1;
      slice2cost_pixels_first_1_18 <= slice2shift_search_1_18 - slice2shift_reference_1;
      slice2cost_pixels_first_1_19 <= slice2shift_search_1_19 - slice2shift_reference_1;
      slice2cost_pixels_first_1_20 <= slice2shift_search_1_20 - slice2shift_reference_1;
      slice2cost_pixels_first_1_21 <= slice2shift_search_1_21 - slice2shift_reference_1;
      slice2cost_pixels_first_1_22 <= slice2shift_search_1_22 - slice2shift_reference_1;
      slice2cost_pixels_first_1_23 <= slice2shift_search_1_23 - slice2shift_reference_1;
      slice2cost_pixels_first_1_24 <= slice2shift_search_1_24 - slice2shift_reference_1;
      slice2cost_pixels_cost_0_0 <= (folded(slice2cost_pixels_first_0_0) + as_number((slice2cost_pixels_first_0_0 <
        0))) mod 256;
      slice2cost_pixels_cost_0_1 <= (folded(slice2cost_pixels_first_0_1) + as_number((slice2cost_pixels_first_0_1 <
        0))) mod 256;
      slice2cost_pixels_cost_0_2 <= (folded(slice2cost_pixels_first_0_2) + as_number((slice2cost_pixels_first_0_2 <
        0))) mod 256;
      slice2cost_pixels_cost_0_3 <= (folded(slice2cost_pixels_first_0_3) + as_number((slice2cost_pixels_first_0_3 <
        0))) mod 256;
      slice2cost_pixels_cost_0_4 <= (folded(slice2cost_pixels_first_0_4) + as_number((slice2cost_pixels_first_0_4 <
        0))) mod 256;
      slice2cost_pixels_cost_0_5 <= (folded(slice2cost_pixels_first_0_5) + as_number((slice2cost_pixels_first_0_5 <
        0))) mod 256;
      slice2cost_pixels_cost_0_6 <= (folded(slice2cost_pixels_first_0_6) + as_number((slice2cost_pixels_first_0_6 <
        0))) mod 256;
      slice2cost_pixels_cost_0_7 <= (folded(slice2cost_pixels_first_0_7) + as_number((slice2cost_pixels_first_0_7 <
        0))) mod 256;
      slice2cost_pixels_cost_0_8 <= (folded(slice2cost_pixels_first_0_8) + as_number((slice2cost_pixels_first_0_8 <
        0))) mod 256;
      slice2cost_pixels_cost_0_9 <= (folded(slice2cost_pixels_first_0_9) + as_number((slice2cost_pixels_first_0_9 <
        0))) mod 256;
      slice2cost_pixels_cost_0_10 <= (folded(slice2cost_pixels_first_0_10) + as_number((slice2cost_pixels_first_0_10 <
        0))) mod 256;
      slice2cost_pixels_cost_0_11 <= (folded(slice2cost_pixels_first_0_11) + as_number((slice2cost_pixels_first_0_11 <
        0))) mod 256;
      slice2cost_pixels_cost_0_12 <= (folded(slice2cost_pixels_first_0_12) + as_number((slice2cost_pixels_first_0_12 <
        0))) mod 256;
      slice2cost_pixels_cost_0_13 <= (folded(slice2cost_pixels_first_0_13) + as_number((slice2cost_pixels_first_0_13 <
        0))) mod 256;
      slice2cost_pixels_cost_0_14 <= (folded(slice2cost_pixels_first_0_14) + as_number((slice2cost_pixels_first_0_14 <
        0))) mod 256;
      slice2cost_pixels_cost_0_15 <= (folded(slice2cost_pixels_first_0_15) + as_number((slice2cost_pixels_first_0_15 <
        0))) mod 256;
      slice2cost_pixels_cost_0_16 <= (folded(slice2cost_pixels_first_0_16) + as_number((slice2cost_pixels_first_0_16 <
        0))) mod 256;
      slice2cost_pixels_cost_0_17 <= (folded(slice2cost_pixels_first_0_17) + as_number((slice2cost_pixels_first_0_17 <
        0))) mod 256;
      slice2cost_pixels_cost_0_18 <= (folded(slice2cost_pixels_first_0_18) + as_number((slice2cost_pixels_first_0_18 <
        0))) mod 256;
      slice2cost_pixels_cost_0_19 <= (folded(slice2cost_pixels_first_0_19) + as_number((slice2cost_pixels_first_0_19 <
        0))) mod 256;
      slice2cost_pixels_cost_0_20 <= (folded(slice2cost_pixels_first_0_20) + as_number((slice2cost_pixels_first_0_20 <
        0))) mod 256;
      slice2cost_pixels_cost_0_21 <= (folded(slice2cost_pixels_first_0_21) + as_number((slice2cost_pixels_first_0_21 <
        0))) mod 256;
      slice2cost_pixels_cost_0_22 <= (folded(slice2cost_pixels_first_0_22) + as_number((slice2cost_pixels_first_0_22 <
        0))) mod 256;
      slice2cost_pixels_cost_0_23 <= (folded(slice2cost_pixels_first_0_23) + as_number((slice2cost_pixels_first_0_23 <
        0))) mod 256;
      slice2cost_pixels_cost_0_24 <= (folded(slice2cost_pixels_first_0_24) + as_number((slice2cost_pixels_first_0_24 <
        0))) mod 256;
      slice2cost_pixels_cost_1_0 <= (folded(slice2cost_pixels_first_1_0) + as_number((slice2cost_pixels_first_1_0 <
        0))) mod 256;
      slice2cost_pixels_cost_1_1 <= (folded(slice2cost_pixels_first_1_1) + as_number((slice2cost_pixels_first_1_1 <
        0))) mod 256;
      slice2cost_pixels_cost_1_2 <= (folded(slice2cost_pixels_first_1_2) + as_number((slice2cost_pixels_first_1_2 <
        0))) mod 256;
      slice2cost_pixels_cost_1_3 <= (folded(slice2cost_pixels_first_1_3) + as_number((slice2cost_pixels_first_1_3 <
        0))) mod 256;
      slice2cost_pixels_cost_1_4 <= (folded(slice2cost_pixels_first_1_4) + as_number((slice2cost_pixels_first_1_4 <
        0))) mod 256;
      slice2cost_pixels_cost_1_5 <= (folded(slice2cost_pixels_first_1_5) + as_number((slice2cost_pixels_first_1_5 <
        0))) mod 256;
      slice2cost_pixels_cost_1_6 <= (folded(slice2cost_pixels_first_1_6) + as_number((slice2cost_pixels_first_1_6 <
        0))) mod 256;
      slice2cost_pixels_cost_1_7 <= (folded(slice2cost_pixels_first_1_7) + as_number((slice2cost_pixels_first_1_7 <
        0))) mod 256;
      slice2cost_pixels_cost_1_8 <= (folded(slice2cost_pixels_first_1_8) + as_number((slice2cost_pixels_first_1_8 <
        0))) mod 256;
      slice2cost_pixels_cost_1_9 <= (folded(slice2cost_pixels_first_1_9) + as_number((slice2cost_pixels_first_1_9 <
        0))) mod 256;
      slice2cost_pixels_cost_1_10 <= (folded(slice2cost_pixels_first_1_10) + as_number((slice2cost_pixels_first_1_10 <
        0))) mod 256;
      slice2cost_pixels_cost_1_11 <= (folded(slice2cost_pixels_first_1_11) + as_number((slice2cost_pixels_first_1_11 <
        0))) mod 256;
      slice2cost_pixels_cost_1_12 <= (folded(slice2cost_pixels_first_1_12) + as_number((slice2cost_pixels_first_1_12 <
        0))) mod 256;
      slice2cost_pixels_cost_1_13 <= (folded(slice2cost_pixels_first_1_13) + as_number((slice2cost_pixels_first_1_13 <
        0))) mod 256;
      slice2cost_pixels_cost_1_14 <= (folded(slice2cost_pixels_first_1_14) + as_number((slice2cost_pixels_first_1_14 <
        0))) mod 256;
      slice2cost_pixels_cost_1_15 <= (folded(slice2cost_pixels_first_1_15) + as_number((slice2cost_pixels_first_1_15 <
        0))) mod 256;
      slice2cost_pixels_cost_1_16 <= (folded(slice2cost_pixels_first_1_16) + as_number((slice2cost_pixels_first_1_16 <
        0))) mod 256;
      slice2cost_pixels_cost_1_17 <= (folded(slice2cost_pixels_first_1_17) + as_number((slice2cost_pixels_first_1_17 <
        0))) mod 256;
      slice2cost_pixels_cost_1_18 <= (folded(slice2cost_pixels_first_1_18) + as_number((slice2cost_pixels_first_1_18 <
        0))) mod 256;
      slice2cost_pixels_cost_1_19 <= (folded(slice2cost_pixels_first_1_19) + as_number((slice2cost_pixels_first_1_19 <
        0))) mod 256;
      slice2cost_pixels_cost_1_20 <= (folded(slice2cost_pixels_first_1_20) + as_number((slice2cost_pixels_first_1_20 <
        0))) mod 256;
      slice2cost_pixels_cost_1_21 <= (folded(slice2cost_pixels_first_1_21) + as_number((slice2cost_pixels_first_1_21 <
        0))) mod 256;
      slice2cost_pixels_cost_1_22 <= (folded(slice2cost_pixels_first_1_22) + as_number((slice2cost_pixels_first_1_22 <
        0))) mod 256;
      slice2cost_pixels_cost_1_23 <= (folded(slice2cost_pixels_first_1_23) + as_number((slice2cost_pixels_first_1_23 <
        0))) mod 256;
      slice2cost_pixels_cost_1_24 <= (folded(slice2cost_pixels_first_1_24) + as_number((slice2cost_pixels_first_1_24 <
        0))) mod 256;
      slice2cost_read_column <= slice1cost_read_column;
      slice2cost_change_0_0 <= slice2cost_pixels_cost_1_0 - slice2cost_pixels_cost_0_0;
      slice2cost_change_0_1 <= slice2cost_pixels_cost_1_1 - slice2cost_pixels_cost_0_1;
      slice2cost_change_0_2 <= slice2cost_pixels_cost_1_2 - slice2cost_pixels_cost_0_2;
      slice2cost_change_0_3 <= slice2cost_pixels_cost_1_3 - slice2cost_pixels_cost_0_3;
      slice2cost_change_0_4 <= slice2cost_pixels_cost_1_4 - slice2cost_pixels_cost_0_4;
      slice2cost_change_0_5 <= slice2cost_pixels_cost_1_5 - slice2cost_pixels_cost_0_5;
      slice2cost_change_0_6 <= slice2cost_pixels_cost_1_6 - slice2cost_pixels_cost_0_6;
      slice2cost_change_0_7 <= slice2cost_pixels_cost_1_7 - slice2cost_pixels_cost_0_7;
      slice2cost_change_0_8 <= slice2cost_pixels_cost_1_8 - slice2cost_pixels_cost_0_8;
      slice2cost_change_0_9 <= slice2cost_pixels_cost_1_9 - slice2cost_pixels_cost_0_9;
      slice2cost_change_0_10 <= slice2cost_pixels_cost_1_10 - slice2cost_pixels_cost_0_10;
      slice2cost_change_0_11 <= slice2cost_pixels_cost_1_11 - slice2cost_pixels_cost_0_11;
      slice2cost_change_0_12 <= slice2cost_pixels_cost_1_12 - slice2cost_pixels_cost_0_12;
      slice2cost_change_0_13 <= slice2cost_pixels_cost_1_13 - slice2cost_pixels_cost_0_13;
      slice2cost_change_0_14 <= slice2cost_pixels_cost_1_14 - slice2cost_pixels_cost_0_14;
      slice2cost_change_0_15 <= slice2cost_pixels_cost_1_15 - slice2cost_pixels_cost_0_15;
      slice2cost_change_0_16 <= slice2cost_pixels_cost_1_16 - slice2cost_pixels_cost_0_16;
      slice2cost_change_0_17 <= slice2cost_pixels_cost_1_17 - slice2cost_pixels_cost_0_17;
      slice2cost_change_0_18 <= slice2cost_pixels_cost_1_18 - slice2cost_pixels_cost_0_18;
      slice2cost_change_0_19 <= slice2cost_pixels_cost_1_19 - slice2cost_pixels_cost_0_19;
      slice2cost_change_0_20 <= slice2cost_pixels_cost_1_20 - slice2cost_pixels_cost_0_20;
      slice2cost_change_0_21 <= slice2cost_pixels_cost_1_21 - slice2cost_pixels_cost_0_21;
      slice2cost_change_0_22 <= slice2cost_pixels_cost_1_22 - slice2cost_pixels_cost_0_22;
      slice2cost_change_0_23 <= slice2cost_pixels_cost_1_23 - slice2cost_pixels_cost_0_23;
      slice2cost_change_0_24 <= slice2cost_pixels_cost_1_24 - slice2cost_pixels_cost_0_24;
      slice2cost_ready_words_0 <= to_integer(slice2cost_read_words_0);
      slice2cost_ready_words_1 <= to_integer(slice2cost_read_words_1);
      slice2cost_ready_words_2 <= to_integer(slice2cost_read_words_2);
      slice2cost_ready_words_3 <= to_integer(slice2cost_read_words_3);
      slice2cost_ready_words_4 <= to_integer(slice2cost_read_words_4);
      slice2cost_ready_words_5 <= to_integer(slice2cost_read_words_5);
      slice2cost_ready_words_6 <= to_integer(slice2cost_read_words_6);
      slice2cost_ready_words_7 <= to_integer(slice2cost_read_words_7);
      slice2cost_ready_words_8 <= to_integer(slice2cost_read_words_8);
      slice2cost_ready_words_9 <= to_integer(slice2cost_read_words_9);
      slice2cost_ready_words_10 <= to_integer(slice2cost_read_words_10);
      slice2cost_ready_words_11 <= to_integer(slice2cost_read_words_11);
      slice2cost_ready_words_12 <= to_integer(slice2cost_read_words_12);
      slice2cost_column_0_0 <= slice2cost_column_0_0_choice_2;
      slice2cost_column_0_1 <= slice2cost_column_0_1_choice_2;
      slice2cost_column_0_2 <= slice2cost_column_0_2_choice_2;
      slice2cost_column_0_3 <= slice2cost_column_0_3_choice_2;
      slice2cost_column_0_4 <= slice2cost_column_0_4_choice_2;
      slice2cost_column_0_5 <= slice2cost_column_0_5_choice_2;
      slice2cost_column_0_6 <= slice2cost_column_0_6_choice_2;
      slice2cost_column_0_7 <= slice2cost_column_0_7_choice_2;
      slice2cost_column_0_8 <= slice2cost_column_0_8_choice_2;
      slice2cost_column_0_9 <= slice2cost_column_0_9_choice_2;
      slice2cost_column_0_10 <= slice2cost_column_0_10_choice_2;
      slice2cost_column_0_11 <= slice2cost_column_0_11_choice_2;
      slice2cost_column_0_12 <= slice2cost_column_0_12_choice_2;
      slice2cost_column_0_13 <= slice2cost_column_0_13_choice_2;
      slice2cost_column_0_14 <= slice2cost_column_0_14_choice_2;
      slice2cost_column_0_15 <= slice2cost_column_0_15_choice_2;
      slice2cost_column_0_16 <= slice2cost_column_0_16_choice_2;
      slice2cost_column_0_17 <= slice2cost_column_0_17_choice_2;
      slice2cost_column_0_18 <= slice2cost_column_0_18_choice_2;
      slice2cost_column_0_19 <= slice2cost_column_0_19_choice_2;
      slice2cost_column_0_20 <= slice2cost_column_0_20_choice_2;
      slice2cost_column_0_21 <= slice2cost_column_0_21_choice_2;
      slice2cost_column_0_22 <= slice2cost_column_0_22_choice_2;
      slice2cost_column_0_23 <= slice2cost_column_0_23_choice_2;
      slice2cost_column_0_24 <= slice2cost_column_0_24_choice_2;
      if slice0cost_ready_tag_valid then
        slice2cost_change_column <= slice2cost_read_column;
      end if;
      if slice0cost_tag_valid then
        slice2cost_ready_column <= slice1cost_ready_column;
      end if;
      if slice0window_entering_tag_valid then
        slice2cost_write_column <= slice1cost_write_column;
        slice2cost_write_words_0 <= (slice2cost_column_0_1_choice_2 * 2048) + slice2cost_column_0_0_choice_2;
        slice2cost_write_words_1 <= (slice2cost_column_0_3_choice_2 * 2048) + slice2cost_column_0_2_choice_2;
        slice2cost_write_words_2 <= (slice2cost_column_0_5_choice_2 * 2048) + slice2cost_column_0_4_choice_2;
        slice2cost_write_words_3 <= (slice2cost_column_0_7_choice_2 * 2048) + slice2cost_column_0_6_choice_2;
        slice2cost_write_words_4 <= (slice2cost_column_0_9_choice_2 * 2048) + slice2cost_column_0_8_choice_2;
        slice2cost_write_words_5 <= (slice2cost_column_0_11_choice_2 * 2048) + slice2cost_column_0_10_choice_2;
        slice2cost_write_words_6 <= (slice2cost_column_0_13_choice_2 * 2048) + slice2cost_column_0_12_choice_2;
        slice2cost_write_words_7 <= (slice2cost_column_0_15_choice_2 * 2048) + slice2cost_column_0_14_choice_2;
        slice2cost_write_words_8 <= (slice2cost_column_0_17_choice_2 * 2048) + slice2cost_column_0_16_choice_2;
        slice2cost_write_words_9 <= (slice2cost_column_0_19_choice_2 * 2048) + slice2cost_column_0_18_choice_2;
        slice2cost_write_words_10 <= (slice2cost_column_0_21_choice_2 * 2048) + slice2cost_column_0_20_choice_2;
        slice2cost_write_words_11 <= (slice2cost_column_0_23_choice_2 * 2048) + slice2cost_column_0_22_choice_2;
        slice2cost_write_words_12 <= slice2cost_column_0_24_choice_2;
      end if;
      -- slice2window
      if slice0window_change_tag_valid then
        slice2window_ring_write_address <= slice2window_ring_read_address;
        if slice2window_ring_read_address = 7 then
          slice2window_ring_read_address <= 0;
        else
          slice2window_ring_read_address <= (slice2window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_0_choice := to_integer(slice2window_leaving_0(10 downto 0));
      else
        slice2window_change_0_0_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_1_choice := to_integer(slice2window_leaving_0(21 downto 11));
      else
        slice2window_change_0_1_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_2_choice := to_integer(slice2window_leaving_1(10 downto 0));
      else
        slice2window_change_0_2_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_3_choice := to_integer(slice2window_leaving_1(21 downto 11));
      else
        slice2window_change_0_3_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_4_choice := to_integer(slice2window_leaving_2(10 downto 0));
      else
        slice2window_change_0_4_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_5_choice := to_integer(slice2window_leaving_2(21 downto 11));
      else
        slice2window_change_0_5_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_6_choice := to_integer(slice2window_leaving_3(10 downto 0));
      else
        slice2window_change_0_6_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_7_choice := to_integer(slice2window_leaving_3(21 downto 11));
      else
        slice2window_change_0_7_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_8_choice := to_integer(slice2window_leaving_4(10 downto 0));
      else
        slice2window_change_0_8_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_9_choice := to_integer(slice2window_leaving_4(21 downto 11));
      else
        slice2window_change_0_9_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_10_choice := to_integer(slice2window_leaving_5(10 downto 0));
      else
        slice2window_change_0_10_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_11_choice := to_integer(slice2window_leaving_5(21 downto 11));
      else
        slice2window_change_0_11_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_12_choice := to_integer(slice2window_leaving_6(10 downto 0));
      else
        slice2window_change_0_12_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_13_choice := to_integer(slice2window_leaving_6(21 downto 11));
      else
        slice2window_change_0_13_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_14_choice := to_integer(slice2window_leaving_7(10 downto 0));
      else
        slice2window_change_0_14_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_15_choice := to_integer(slice2window_leaving_7(21 downto 11));
      else
        slice2window_change_0_15_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_16_choice := to_integer(slice2window_leaving_8(10 downto 0));
      else
        slice2window_change_0_16_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_17_choice := to_integer(slice2window_leaving_8(21 downto 11));
      else
        slice2window_change_0_17_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_18_choice := to_integer(slice2window_leaving_9(10 downto 0));
      else
        slice2window_change_0_18_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_19_choice := to_integer(slice2window_leaving_9(21 downto 11));
      else
        slice2window_change_0_19_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_20_choice := to_integer(slice2window_leaving_10(10 downto 0));
      else
        slice2window_change_0_20_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_21_choice := to_integer(slice2window_leaving_10(21 downto 11));
      else
        slice2window_change_0_21_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_22_choice := to_integer(slice2window_leaving_11(10 downto 0));
      else
        slice2window_change_0_22_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_23_choice := to_integer(slice2window_leaving_11(21 downto 11));
      else
        slice2window_change_0_23_choice := 0;
      end if;
      if slice1window_change_tag_leaves_window then
        slice2window_change_0_24_choice := to_integer(slice2window_leaving_12);
      else
        slice2window_change_0_24_choice := 0;
      end if;
      slice2window_entering_0_0 <= slice2cost_column_0_0;
      slice2window_entering_0_1 <= slice2cost_column_0_1;
      slice2window_entering_0_2 <= slice2cost_column_0_2;
      slice2window_entering_0_3 <= slice2cost_column_0_3;
      slice2window_entering_0_4 <= slice2cost_column_0_4;
      slice2window_entering_0_5 <= slice2cost_column_0_5;
      slice2window_entering_0_6 <= slice2cost_column_0_6;
      slice2window_entering_0_7 <= slice2cost_column_0_7;
      slice2window_entering_0_8 <= slice2cost_column_0_8;
      slice2window_entering_0_9 <= slice2cost_column_0_9;
      slice2window_entering_0_10 <= slice2cost_column_0_10;
      slice2window_entering_0_11 <= slice2cost_column_0_11;
      slice2window_entering_0_12 <= slice2cost_column_0_12;
      slice2window_entering_0_13 <= slice2cost_column_0_13;
      slice2window_entering_0_14 <= slice2cost_column_0_14;
      slice2window_entering_0_15 <= slice2cost_column_0_15;
      slice2window_entering_0_16 <= slice2cost_column_0_16;
      slice2window_entering_0_17 <= slice2cost_column_0_17;
      slice2window_entering_0_18 <= slice2cost_column_0_18;
      slice2window_entering_0_19 <= slice2cost_column_0_19;
      slice2window_entering_0_20 <= slice2cost_column_0_20;
      slice2window_entering_0_21 <= slice2cost_column_0_21;
      slice2window_entering_0_22 <= slice2cost_column_0_22;
      slice2window_entering_0_23 <= slice2cost_column_0_23;
      slice2window_entering_0_24 <= slice2cost_column_0_24;
      slice2window_change_0_0 <= slice2window_entering_0_0 - slice2window_change_0_0_choice;
      slice2window_change_0_1 <= slice2window_entering_0_1 - slice2window_change_0_1_choice;
      slice2window_change_0_2 <= slice2window_entering_0_2 - slice2window_change_0_2_choice;
      slice2window_change_0_3 <= slice2window_entering_0_3 - slice2window_change_0_3_choice;
      slice2window_change_0_4 <= slice2window_entering_0_4 - slice2window_change_0_4_choice;
      slice2window_change_0_5 <= slice2window_entering_0_5 - slice2window_change_0_5_choice;
      slice2window_change_0_6 <= slice2window_entering_0_6 - slice2window_change_0_6_choice;
      slice2window_change_0_7 <= slice2window_entering_0_7 - slice2window_change_0_7_choice;
      slice2window_change_0_8 <= slice2window_entering_0_8 - slice2window_change_0_8_choice;
      slice2window_change_0_9 <= slice2window_entering_0_9 - slice2window_change_0_9_choice;
      slice2window_change_0_10 <= slice2window_entering_0_10 - slice2window_change_0_10_choice;
      slice2window_change_0_11 <= slice2window_entering_0_11 - slice2window_change_0_11_choice;
      slice2window_change_0_12 <= slice2window_entering_0_12 - slice2window_change_0_12_choice;
      slice2window_change_0_13 <= slice2window_entering_0_13 - slice2window_change_0_13_choice;
      slice2window_change_0_14 <= slice2window_entering_0_14 - slice2window_change_0_14_choice;
      slice2window_change_0_15 <= slice2window_entering_0_15 - slice2window_change_0_15_choice;
      slice2window_change_0_16 <= slice2window_entering_0_16 - slice2window_change_0_16_choice;
      slice2window_change_0_17 <= slice2window_entering_0_17 - slice2window_change_0_17_choice;
      slice2window_change_0_18 <= slice2window_entering_0_18 - slice2window_change_0_18_choice;
      slice2window_change_0_19 <= slice2window_entering_0_19 - slice2window_change_0_19_choice;
      slice2window_change_0_20 <= slice2window_entering_0_20 - slice2window_change_0_20_choice;
      slice2window_change_0_21 <= slice2window_entering_0_21 - slice2window_change_0_21_choice;
      slice2window_change_0_22 <= slice2window_entering_0_22 - slice2window_change_0_22_choice;
      slice2window_change_0_23 <= slice2window_entering_0_23 - slice2window_change_0_23_choice;
      slice2window_change_0_24 <= slice2window_entering_0_24 - slice2window_change_0_24_choice;
      slice2window_change_tag_leaves_window <= slice1window_change_tag_leaves_window;
      slice2window_centre_output_column_0 <= slice1window_centre_output_column_0;
      slice2window_centre_first_column_0 <= slice1window_centre_first_column_0;
      slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_0_choice := 0;
      else
        slice2window_sum_0_0_choice := slice2window_sum_0_0;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_1_choice := 0;
      else
        slice2window_sum_0_1_choice := slice2window_sum_0_1;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_2_choice := 0;
      else
        slice2window_sum_0_2_choice := slice2window_sum_0_2;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_3_choice := 0;
      else
        slice2window_sum_0_3_choice := slice2window_sum_0_3;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_4_choice := 0;
      else
        slice2window_sum_0_4_choice := slice2window_sum_0_4;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_5_choice := 0;
      else
        slice2window_sum_0_5_choice := slice2window_sum_0_5;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_6_choice := 0;
      else
        slice2window_sum_0_6_choice := slice2window_sum_0_6;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_7_choice := 0;
      else
        slice2window_sum_0_7_choice := slice2window_sum_0_7;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_8_choice := 0;
      else
        slice2window_sum_0_8_choice := slice2window_sum_0_8;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_9_choice := 0;
      else
        slice2window_sum_0_9_choice := slice2window_sum_0_9;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_10_choice := 0;
      else
        slice2window_sum_0_10_choice := slice2window_sum_0_10;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_11_choice := 0;
      else
        slice2window_sum_0_11_choice := slice2window_sum_0_11;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_12_choice := 0;
      else
        slice2window_sum_0_12_choice := slice2window_sum_0_12;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_13_choice := 0;
      else
        slice2window_sum_0_13_choice := slice2window_sum_0_13;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_14_choice := 0;
      else
        slice2window_sum_0_14_choice := slice2window_sum_0_14;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_15_choice := 0;
      else
        slice2window_sum_0_15_choice := slice2window_sum_0_15;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_16_choice := 0;
      else
        slice2window_sum_0_16_choice := slice2window_sum_0_16;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_17_choice := 0;
      else
        slice2window_sum_0_17_choice := slice2window_sum_0_17;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_18_choice := 0;
      else
        slice2window_sum_0_18_choice := slice2window_sum_0_18;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_19_choice := 0;
      else
        slice2window_sum_0_19_choice := slice2window_sum_0_19;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_20_choice := 0;
      else
        slice2window_sum_0_20_choice := slice2window_sum_0_20;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_21_choice := 0;
      else
        slice2window_sum_0_21_choice := slice2window_sum_0_21;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_22_choice := 0;
      else
        slice2window_sum_0_22_choice := slice2window_sum_0_22;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_23_choice := 0;
      else
        slice2window_sum_0_23_choice := slice2window_sum_0_23;
      end if;
      if slice1window_centre_first_column_0 then
        slice2window_sum_0_24_choice := 0;
      else
        slice2window_sum_0_24_choice := slice2window_sum_0_24;
      end if;
      if slice0winner1_tag_valid then
        slice2window_sum_0_0 <= (slice2window_sum_0_0_choice + slice2window_change_0_0) mod 16384;
        slice2window_sum_0_1 <= (slice2window_sum_0_1_choice + slice2window_change_0_1) mod 16384;
        slice2window_sum_0_2 <= (slice2window_sum_0_2_choice + slice2window_change_0_2) mod 16384;
        slice2window_sum_0_3 <= (slice2window_sum_0_3_choice + slice2window_change_0_3) mod 16384;
        slice2window_sum_0_4 <= (slice2window_sum_0_4_choice + slice2window_change_0_4) mod 16384;
        slice2window_sum_0_5 <= (slice2window_sum_0_5_choice + slice2window_change_0_5) mod 16384;
        slice2window_sum_0_6 <= (slice2window_sum_0_6_choice + slice2window_change_0_6) mod 16384;
        slice2window_sum_0_7 <= (slice2window_sum_0_7_choice + slice2window_change_0_7) mod 16384;
        slice2window_sum_0_8 <= (slice2window_sum_0_8_choice + slice2window_change_0_8) mod 16384;
        slice2window_sum_0_9 <= (slice2window_sum_0_9_choice + slice2window_change_0_9) mod 16384;
        slice2window_sum_0_10 <= (slice2window_sum_0_10_choice + slice2window_change_0_10) mod 16384;
        slice2window_sum_0_11 <= (slice2window_sum_0_11_choice + slice2window_change_0_11) mod 16384;
        slice2window_sum_0_12 <= (slice2window_sum_0_12_choice + slice2window_change_0_12) mod 16384;
        slice2window_sum_0_13 <= (slice2window_sum_0_13_choice + slice2window_change_0_13) mod 16384;
        slice2window_sum_0_14 <= (slice2window_sum_0_14_choice + slice2window_change_0_14) mod 16384;
        slice2window_sum_0_15 <= (slice2window_sum_0_15_choice + slice2window_change_0_15) mod 16384;
        slice2window_sum_0_16 <= (slice2window_sum_0_16_choice + slice2window_change_0_16) mod 16384;
        slice2window_sum_0_17 <= (slice2window_sum_0_17_choice + slice2window_change_0_17) mod 16384;
        slice2window_sum_0_18 <= (slice2window_sum_0_18_choice + slice2window_change_0_18) mod 16384;
        slice2window_sum_0_19 <= (slice2window_sum_0_19_choice + slice2window_change_0_19) mod 16384;
        slice2window_sum_0_20 <= (slice2window_sum_0_20_choice + slice2window_change_0_20) mod 16384;
        slice2window_sum_0_21 <= (slice2window_sum_0_21_choice + slice2window_change_0_21) mod 16384;
        slice2window_sum_0_22 <= (slice2window_sum_0_22_choice + slice2window_change_0_22) mod 16384;
        slice2window_sum_0_23 <= (slice2window_sum_0_23_choice + slice2window_change_0_23) mod 16384;
        slice2window_sum_0_24 <= (slice2window_sum_0_24_choice + slice2window_change_0_24) mod 16384;
      end if;
      -- slice2winner1
      slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0_1 - slice2window_sum_0_0) < 0;
      slice2winner1_best_cost_0_1_is_less := (slice2window_sum_0_3 - slice2window_sum_0_2) < 0;
      slice2winner1_best_cost_0_2_is_less := (slice2window_sum_0_5 - slice2window_sum_0_4) < 0;
      slice2winner1_best_cost_0_3_is_less := (slice2window_sum_0_7 - slice2window_sum_0_6) < 0;
      slice2winner1_best_cost_0_4_is_less := (slice2window_sum_0_9 - slice2window_sum_0_8) < 0;
      slice2winner1_best_cost_0_5_is_less := (slice2window_sum_0_11 - slice2window_sum_0_10) < 0;
      slice2winner1_best_cost_0_6_is_less := (slice2window_sum_0_13 - slice2window_sum_0_12) < 0;
      slice2winner1_best_cost_0_7_is_less := (slice2window_sum_0_15 - slice2window_sum_0_14) < 0;
      slice2winner1_best_cost_0_8_is_less := (slice2window_sum_0_17 - slice2window_sum_0_16) < 0;
      slice2winner1_best_cost_0_9_is_less := (slice2window_sum_0_19 - slice2window_sum_0_18) < 0;
      slice2winner1_best_cost_0_10_is_less := (slice2window_sum_0_21 - slice2window_sum_0_20) < 0;
      slice2winner1_best_cost_0_11_is_less := (slice2window_sum_0_23 - slice2window_sum_0_22) < 0;
      slice2winner1_best_cost_0_12 <= slice2window_sum_0_24;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      if slice2winner1_best_cost_0_0_is_less then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      if slice2winner1_best_cost_0_1_is_less then
        slice2winner1_best_cost_0_1 <= slice2window_sum_0_3;
        slice2winner1_best_index_0_1 <= 3;
      else
        slice2winner1_best_cost_0_1 <= slice2window_sum_0_2;
        slice2winner1_best_index_0_1 <= 2;
      end if;
      if slice2winner1_best_cost_0_2_is_less then
        slice2winner1_best_cost_0_2 <= slice2window_sum_0_5;
        slice2winner1_best_index_0_2 <= 5;
      else
        slice2winner1_best_cost_0_2 <= slice2window_sum_0_4;
        slice2winner1_best_index_0_2 <= 4;
      end if;
      if slice2winner1_best_cost_0_3_is_less then
        slice2winner1_best_cost_0_3 <= slice2window_sum_0_7;
        slice2winner1_best_index_0_3 <= 7;
      else
        slice2winner1_best_cost_0_3 <= slice2window_sum_0_6;
        slice2winner1_best_index_0_3 <= 6;
      end if;
      if slice2winner1_best_cost_0_4_is_less then
        slice2winner1_best_cost_0_4 <= slice2window_sum_0_9;
        slice2winner1_best_index_0_4 <= 9;
      else
        slice2winner1_best_cost_0_4 <= slice2window_sum_0_8;
        slice2winner1_best_index_0_4 <= 8;
      end if;
      if slice2winner1_best_cost_0_5_is_less then
        slice2winner1_best_cost_0_5 <= slice2window_sum_0_11;
        slice2winner1_best_index_0_5 <= 11;
      else
        slice2winner1_best_cost_0_5 <= slice2window_sum_0_10;
        slice2winner1_best_index_0_5 <= 10;
      end if;
      if slice2winner1_best_cost_0_6_is_less then
        slice2winner1_best_cost_0_6 <= slice2window_sum_0_13;
        slice2winner1_best_index_0_6 <= 13;
      else
        slice2winner1_best_cost_0_6 <= slice2window_sum_0_12;
        slice2winner1_best_index_0_6 <= 12;
      end if;
      if slice2winner1_best_cost_0_7_is_less then
        slice2winner1_best_cost_0_7 <= slice2window_sum_0_15;
        slice2winner1_best_index_0_7 <= 15;
      else
        slice2winner1_best_cost_0_7 <= slice2window_sum_0_14;
        slice2winner1_best_index_0_7 <= 14;
      end if;
      if slice2winner1_best_cost_0_8_is_less then
        slice2winner1_best_cost_0_8 <= slice2window_sum_0_17;
        slice2winner1_best_index_0_8 <= 17;
      else
        slice2winner1_best_cost_0_8 <= slice2window_sum_0_16;
        slice2winner1_best_index_0_8 <= 16;
      end if;
      if slice2winner1_best_cost_0_9_is_less then
        slice2winner1_best_cost_0_9 <= slice2window_sum_0_19;
        slice2winner1_best_index_0_9 <= 19;
      else
        slice2winner1_best_cost_0_9 <= slice2window_sum_0_18;
        slice2winner1_best_index_0_9 <= 18;
      end if;
      if slice2winner1_best_cost_0_10_is_less then
        slice2winner1_best_cost_0_10 <= slice2window_sum_0_21;
        slice2winner1_best_index_0_10 <= 21;
      else
        slice2winner1_best_cost_0_10 <= slice2window_sum_0_20;
        slice2winner1_best_index_0_10 <= 20;
      end if;
      if slice2winner1_best_cost_0_11_is_less then
        slice2winner1_best_cost_0_11 <= slice2window_sum_0_23;
        slice2winner1_best_index_0_11 <= 23;
      else
        slice2winner1_best_cost_0_11 <= slice2window_sum_0_22;
        slice2winner1_best_index_0_11 <= 22;
      end if;
      -- slice2winner2
      slice2winner2_best_cost_0_0_is_less := (slice2winner1_best_cost_0_1 - slice2winner1_best_cost_0_0) < 0;
      slice2winner2_best_cost_0_1_is_less := (slice2winner1_best_cost_0_3 - slice2winner1_best_cost_0_2) < 0;
      slice2winner2_best_cost_0_2_is_less := (slice2winner1_best_cost_0_5 - slice2winner1_best_cost_0_4) < 0;
      slice2winner2_best_cost_0_3_is_less := (slice2winner1_best_cost_0_7 - slice2winner1_best_cost_0_6) < 0;
      slice2winner2_best_cost_0_4_is_less := (slice2winner1_best_cost_0_9 - slice2winner1_best_cost_0_8) < 0;
      slice2winner2_best_cost_0_5_is_less := (slice2winner1_best_cost_0_11 - slice2winner1_best_cost_0_10) < 0;
      slice2winner2_best_cost_0_6 <= slice2winner1_best_cost_0_12;
      if slice2winner2_best_cost_0_0_is_less then
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_1;
        slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_1;
      else
        slice2winner2_best_cost_0_0 <= slice2winner1_best_cost_0_0;
        slice2winner2_best_index_0_0 <= as_number(slice2winner1_best_index_0_0);
      end if;
      if slice2winner2_best_cost_0_1_is_less then
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_3;
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_3;
      else
        slice2winner2_best_cost_0_1 <= slice2winner1_best_cost_0_2;
        slice2winner2_best_index_0_1 <= slice2winner1_best_index_0_2;
      end if;
      if slice2winner2_best_cost_0_2_is_less then
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_5;
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_5;
      else
        slice2winner2_best_cost_0_2 <= slice2winner1_best_cost_0_4;
        slice2winner2_best_index_0_2 <= slice2winner1_best_index_0_4;
      end if;
      if slice2winner2_best_cost_0_3_is_less then
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_7;
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_7;
      else
        slice2winner2_best_cost_0_3 <= slice2winner1_best_cost_0_6;
        slice2winner2_best_index_0_3 <= slice2winner1_best_index_0_6;
      end if;
      if slice2winner2_best_cost_0_4_is_less then
        slice2winner2_best_cost_0_4 <= slice2winner1_best_cost_0_9;
        slice2winner2_best_index_0_4 <= slice2winner1_best_index_0_9;
      else
        slice2winner2_best_cost_0_4 <= slice2winner1_best_cost_0_8;
        slice2winner2_best_index_0_4 <= slice2winner1_best_index_0_8;
      end if;
      if slice2winner2_best_cost_0_5_is_less then
        slice2winner2_best_cost_0_5 <= slice2winner1_best_cost_0_11;
        slice2winner2_best_index_0_5 <= slice2winner1_best_index_0_11;
      else
        slice2winner2_best_cost_0_5 <= slice2winner1_best_cost_0_10;
        slice2winner2_best_index_0_5 <= slice2winner1_best_index_0_10;
      end if;
      -- slice2winner3
      slice2winner3_best_cost_0_0_is_less := (slice2winner2_best_cost_0_1 - slice2winner2_best_cost_0_0) < 0;
      slice2winner3_best_cost_0_1_is_less := (slice2winner2_best_cost_0_3 - slice2winner2_best_cost_0_2) < 0;
      slice2winner3_best_cost_0_2_is_less := (slice2winner2_best_cost_0_5 - slice2winner2_best_cost_0_4) < 0;
      slice2winner3_best_cost_0_3 <= slice2winner2_best_cost_0_6;
      if slice2winner3_best_cost_0_0_is_less then
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_1;
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_1;
      else
        slice2winner3_best_cost_0_0 <= slice2winner2_best_cost_0_0;
        slice2winner3_best_index_0_0 <= slice2winner2_best_index_0_0;
      end if;
      if slice2winner3_best_cost_0_1_is_less then
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_3;
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_3;
      else
        slice2winner3_best_cost_0_1 <= slice2winner2_best_cost_0_2;
        slice2winner3_best_index_0_1 <= slice2winner2_best_index_0_2;
      end if;
      if slice2winner3_best_cost_0_2_is_less then
        slice2winner3_best_cost_0_2 <= slice2winner2_best_cost_0_5;
        slice2winner3_best_index_0_2 <= slice2winner2_best_index_0_5;
      else
        slice2winner3_best_cost_0_2 <= slice2winner2_best_cost_0_4;
        slice2winner3_best_index_0_2 <= slice2winner2_best_index_0_4;
      end if;
      -- slice2winner4
      slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0_1 - slice2winner3_best_cost_0_0) < 0;
      slice2winner4_best_cost_0_1_is_less := (slice2winner3_best_cost_0_3 - slice2winner3_best_cost_0_2) < 0;
      if slice2winner4_best_cost_0_0_is_less then
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_1;
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_1;
      else
        slice2winner4_best_cost_0_0 <= slice2winner3_best_cost_0_0;
        slice2winner4_best_index_0_0 <= slice2winner3_best_index_0_0;
      end if;
      if slice2winner4_best_cost_0_1_is_less then
        slice2winner4_best_cost_0_1 <= slice2winner3_best_cost_0_3;
        slice2winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice2winner4_best_cost_0_1 <= slice2winner3_best_cost_0_2;
        slice2winner4_best_index_0_1 <= slice2winner3_best_index_0_2;
      end if;
      -- slice2winner5
      slice2winner5_best_cost_0_0_is_less := (slice2winner4_best_cost_0_1 - slice2winner4_best_cost_0_0) < 0;
      if slice2winner5_best_cost_0_0_is_less then
        slice2winner5_best_cost_0_0 <= slice2winner4_best_cost_0_1;
        slice2winner5_best_index_0_0 <= slice2winner4_best_index_0_1;
      else
        slice2winner5_best_cost_0_0 <= slice2winner4_best_cost_0_0;
        slice2winner5_best_index_0_0 <= slice2winner4_best_index_0_0;
      end if;
      -- slice2
      slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner5_best_cost_0_0) < 0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_cost_0_0_is_less then
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_cost_0_0 <= slice2winner5_best_cost_0_0;
        slice2_best_index_0_0 <= (((slice2winner5_best_index_0_0 / 2) + 23) * 2) + (slice2winner5_best_index_0_0 mod 2);
      end if;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        slice3shift_search_0_0 <= slice3shift_search_0_1;
        slice3shift_search_0_1 <= slice3shift_search_0_2;
        slice3shift_search_0_2 <= slice3shift_search_0_3;
        slice3shift_search_0_3 <= slice3shift_search_0_4;
        slice3shift_search_0_4 <= slice3shift_search_0_5;
        slice3shift_search_0_5 <= slice3shift_search_0_6;
        slice3shift_search_0_6 <= slice3shift_search_0_7;
        slice3shift_search_0_7 <= slice3shift_search_0_8;
        slice3shift_search_0_8 <= slice3shift_search_0_9;
        slice3shift_search_0_9 <= slice3shift_search_0_10;
        slice3shift_search_0_10 <= slice3shift_search_0_11;
        slice3shift_search_0_11 <= slice3shift_search_0_12;
        slice3shift_search_0_12 <= slice3shift_search_0_13;
        slice3shift_search_0_13 <= slice3shift_search_0_14;
        slice3shift_search_0_14 <= slice3shift_search_0_15;
        slice3shift_search_0_15 <= slice3shift_search_0_16;
        slice3shift_search_0_16 <= slice3shift_search_0_17;
        slice3shift_search_0_17 <= slice3shift_search_0_18;
        slice3shift_search_0_18 <= slice3shift_search_0_19;
        slice3shift_search_0_19 <= slice3shift_search_0_20;
        slice3shift_search_0_20 <= slice3shift_search_0_21;
        slice3shift_search_0_21 <= slice3shift_search_0_22;
        slice3shift_search_0_22 <= slice3shift_search_0_23;
        slice3shift_search_0_23 <= slice3shift_search_0_24;
        slice3shift_search_0_24 <= slice2shift_search_out_0;
        slice3shift_search_1_0 <= slice3shift_search_1_1;
        slice3shift_search_1_1 <= slice3shift_search_1_2;
        slice3shift_search_1_2 <= slice3shift_search_1_3;
        slice3shift_search_1_3 <= slice3shift_search_1_4;
        slice3shift_search_1_4 <= slice3shift_search_1_5;
        slice3shift_search_1_5 <= slice3shift_search_1_6;
        slice3shift_search_1_6 <= slice3shift_search_1_7;
        slice3shift_search_1_7 <= slice3shift_search_1_8;
        slice3shift_search_1_8 <= slice3shift_search_1_9;
        slice3shift_search_1_9 <= slice3shift_search_1_10;
        slice3shift_search_1_10 <= slice3shift_search_1_11;
        slice3shift_search_1_11 <= slice3shift_search_1_12;
        slice3shift_search_1_12 <= slice3shift_search_1_13;
        slice3shift_search_1_13 <= slice3shift_search_1_14;
        slice3shift_search_1_14 <= slice3shift_search_1_15;
        slice3shift_search_1_15 <= slice3shift_search_1_16;
        slice3shift_search_1_16 <= slice3shift_search_1_17;
        slice3shift_search_1_17 <= slice3shift_search_1_18;
        slice3shift_search_1_18 <= slice3shift_search_1_19;
        slice3shift_search_1_19 <= slice3shift_search_1_20;
        slice3shift_search_1_20 <= slice3shift_search_1_21;
        slice3shift_search_1_21 <= slice3shift_search_1_22;
        slice3shift_search_1_22 <= slice3shift_search_1_23;
        slice3shift_search_1_23 <= slice3shift_search_1_24;
        slice3shift_search_1_24 <= slice2shift_search_out_1;
      end if;
      slice3shift_reference_0 <= slice2shift_reference_0;
      slice3shift_reference_1 <= slice2shift_reference_1;
      slice3shift_search_out_0 <= slice3shift_search_0_0;
      slice3shift_search_out_1 <= slice3shift_search_1_0;
      -- slice3cost
      if slice0window_change_tag_first_group then
        slice3cost_column_0_0_choice := 0;
      else
        slice3cost_column_0_0_choice := slice3cost_ready_words_0 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_0_choice_2 := 0;
      else
        slice3cost_column_0_0_choice_2 := (slice3cost_change_0_0 + slice3cost_column_0_0_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_1_choice := 0;
      else
        slice3cost_column_0_1_choice := slice3cost_ready_words_0 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_1_choice_2 := 0;
      else
        slice3cost_column_0_1_choice_2 := (slice3cost_change_0_1 + slice3cost_column_0_1_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_2_choice := 0;
      else
        slice3cost_column_0_2_choice := slice3cost_ready_words_1 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_2_choice_2 := 0;
      else
        slice3cost_column_0_2_choice_2 := (slice3cost_change_0_2 + slice3cost_column_0_2_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_3_choice := 0;
      else
        slice3cost_column_0_3_choice := slice3cost_ready_words_1 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_3_choice_2 := 0;
      else
        slice3cost_column_0_3_choice_2 := (slice3cost_change_0_3 + slice3cost_column_0_3_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_4_choice := 0;
      else
        slice3cost_column_0_4_choice := slice3cost_ready_words_2 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_4_choice_2 := 0;
      else
        slice3cost_column_0_4_choice_2 := (slice3cost_change_0_4 + slice3cost_column_0_4_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_5_choice := 0;
      else
        slice3cost_column_0_5_choice := slice3cost_ready_words_2 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_5_choice_2 := 0;
      else
        slice3cost_column_0_5_choice_2 := (slice3cost_change_0_5 + slice3cost_column_0_5_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_6_choice := 0;
      else
        slice3cost_column_0_6_choice := slice3cost_ready_words_3 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_6_choice_2 := 0;
      else
        slice3cost_column_0_6_choice_2 := (slice3cost_change_0_6 + slice3cost_column_0_6_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_7_choice := 0;
      else
        slice3cost_column_0_7_choice := slice3cost_ready_words_3 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_7_choice_2 := 0;
      else
        slice3cost_column_0_7_choice_2 := (slice3cost_change_0_7 + slice3cost_column_0_7_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_8_choice := 0;
      else
        slice3cost_column_0_8_choice := slice3cost_ready_words_4 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_8_choice_2 := 0;
      else
        slice3cost_column_0_8_choice_2 := (slice3cost_change_0_8 + slice3cost_column_0_8_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_9_choice := 0;
      else
        slice3cost_column_0_9_choice := slice3cost_ready_words_4 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_9_choice_2 := 0;
      else
        slice3cost_column_0_9_choice_2 := (slice3cost_change_0_9 + slice3cost_column_0_9_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_10_choice := 0;
      else
        slice3cost_column_0_10_choice := slice3cost_ready_words_5 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_10_choice_2 := 0;
      else
        slice3cost_column_0_10_choice_2 := (slice3cost_change_0_10 + slice3cost_column_0_10_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_11_choice := 0;
      else
        slice3cost_column_0_11_choice := slice3cost_ready_words_5 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_11_choice_2 := 0;
      else
        slice3cost_column_0_11_choice_2 := (slice3cost_change_0_11 + slice3cost_column_0_11_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_12_choice := 0;
      else
        slice3cost_column_0_12_choice := slice3cost_ready_words_6 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_12_choice_2 := 0;
      else
        slice3cost_column_0_12_choice_2 := (slice3cost_change_0_12 + slice3cost_column_0_12_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_13_choice := 0;
      else
        slice3cost_column_0_13_choice := slice3cost_ready_words_6 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_13_choice_2 := 0;
      else
        slice3cost_column_0_13_choice_2 := (slice3cost_change_0_13 + slice3cost_column_0_13_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_14_choice := 0;
      else
        slice3cost_column_0_14_choice := slice3cost_ready_words_7 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_14_choice_2 := 0;
      else
        slice3cost_column_0_14_choice_2 := (slice3cost_change_0_14 + slice3cost_column_0_14_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_15_choice := 0;
      else
        slice3cost_column_0_15_choice := slice3cost_ready_words_7 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_15_choice_2 := 0;
      else
        slice3cost_column_0_15_choice_2 := (slice3cost_change_0_15 + slice3cost_column_0_15_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_16_choice := 0;
      else
        slice3cost_column_0_16_choice := slice3cost_ready_words_8 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_16_choice_2 := 0;
      else
        slice3cost_column_0_16_choice_2 := (slice3cost_change_0_16 + slice3cost_column_0_16_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_17_choice := 0;
      else
        slice3cost_column_0_17_choice := slice3cost_ready_words_8 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_17_choice_2 := 0;
      else
        slice3cost_column_0_17_choice_2 := (slice3cost_change_0_17 + slice3cost_column_0_17_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_18_choice := 0;
      else
        slice3cost_column_0_18_choice := slice3cost_ready_words_9 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_18_choice_2 := 0;
      else
        slice3cost_column_0_18_choice_2 := (slice3cost_change_0_18 + slice3cost_column_0_18_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_19_choice := 0;
      else
        slice3cost_column_0_19_choice := slice3cost_ready_words_9 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_19_choice_2 := 0;
      else
        slice3cost_column_0_19_choice_2 := (slice3cost_change_0_19 + slice3cost_column_0_19_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_20_choice := 0;
      else
        slice3cost_column_0_20_choice := slice3cost_ready_words_10 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_20_choice_2 := 0;
      else
        slice3cost_column_0_20_choice_2 := (slice3cost_change_0_20 + slice3cost_column_0_20_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_21_choice := 0;
      else
        slice3cost_column_0_21_choice := slice3cost_ready_words_10 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_21_choice_2 := 0;
      else
        slice3cost_column_0_21_choice_2 := (slice3cost_change_0_21 + slice3cost_column_0_21_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_22_choice := 0;
      else
        slice3cost_column_0_22_choice := slice3cost_ready_words_11 mod 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_22_choice_2 := 0;
      else
        slice3cost_column_0_22_choice_2 := (slice3cost_change_0_22 + slice3cost_column_0_22_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_23_choice := 0;
      else
        slice3cost_column_0_23_choice := slice3cost_ready_words_11 / 2048;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_23_choice_2 := 0;
      else
        slice3cost_column_0_23_choice_2 := (slice3cost_change_0_23 + slice3cost_column_0_23_choice) mod 2048;
      end if;
      if slice0window_change_tag_first_group then
        slice3cost_column_0_24_choice := 0;
      else
        slice3cost_column_0_24_choice := slice3cost_ready_words_12;
      end if;
      if slice0window_change_tag_border_column then
        slice3cost_column_0_24_choice_2 := 0;
      else
        slice3cost_column_0_24_choice_2 := (slice3cost_change_0_24 + slice3cost_column_0_24_choice) mod 2048;
      end if;
      slice3cost_pixels_first_0_0 <= slice3shift_search_0_0 - slice3shift_reference_0;
      slice3cost_pixels_first_0_1 <= slice3shift_search_0_1 - slice3shift_reference_0;
      slice3cost_pixels_first_0_2 <= slice3shift_search_0_2 - slice3shift_reference_0;
      slice3cost_pixels_first_0_3 <= slice3shift_search_0_3 - slice3shift_reference_0;
      slice3cost_pixels_first_0_4 <= slice3shift_search_0_4 - slice3shift_reference_0;
      slice3cost_pixels_first_0_5 <= slice3shift_search_0_5 - slice3shift_reference_0;
      slice3cost_pixels_first_0_6 <= slice3shift_search_0_6 - slice3shift_reference_0;
      slice3cost_pixels_first_0_7 <= slice3shift_search_0_7 - slice3shift_reference_0;
      slice3cost_pixels_first_0_8 <= slice3shift_search_0_8 - slice3shift_reference_0;
      slice3cost_pixels_first_0_9 <= slice3shift_search_0_9 - slice3shift_reference_0;
      slice3cost_pixels_first_0_10 <= slice3shift_search_0_10 - slice3shift_reference_0;
      slice3cost_pixels_first_0_11 <= slice3shift_search_0_11 - slice3shift_reference_0;
      slice3cost_pixels_first_0_12 <= slice3shift_search_0_12 - slice3shift_reference_0;
      slice3cost_pixels_first_0_13 <= slice3shift_search_0_13 - slice3shift_reference_0;
      slice3cost_pixels_first_0_14 <= slice3shift_search_0_14 - slice3shift_reference_0;
      slice3cost_pixels_first_0_15 <= slice3shift_search_0_15 - slice3shift_reference_0;
      slice3cost_pixels_first_0_16 <= slice3shift_search_0_16 - slice3shift_reference_0;
      slice3cost_pixels_first_0_17 <= slice3shift_search_0_17 - slice3shift_reference_0;
      slice3cost_pixels_first_0_18 <= slice3shift_search_0_18 - slice3shift_reference_0;
      slice3cost_pixels_first_0_19 <= slice3shift_search_0_19 - slice3shift_reference_0;
      slice3cost_pixels_first_0_20 <= slice3shift_search_0_20 - slice3shift_reference_0;
      slice3cost_pixels_first_0_21 <= slice3shift_search_0_21 - slice3shift_reference_0;
      slice3cost_pixels_first_0_22 <= slice3shift_search_0_22 - slice3shift_reference_0;
      slice3cost_pixels_first_0_23 <= slice3shift_search_0_23 - slice3shift_reference_0;
      slice3cost_pixels_first_0_24 <= slice3shift_search_0_24 - slice3shift_reference_0;
      slice3cost_pixels_first_1_0 <= slice3shift_search_1_0 - slice3shift_reference_1;
      slice3cost_pixels_first_1_1 <= slice3shift_search_1_1 - slice3shift_reference_1;
      slice3cost_pixels_first_1_2 <= slice3shift_search_1_2 - slice3shift_reference_1;
      slice3cost_pixels_first_1_3 <= slice3shift_search_1_3 - slice3shift_reference_1;
      slice3cost_pixels_first_1_4 <= slice3shift_search_1_4 - slice3shift_reference_1;
      slice3cost_pixels_first_1_5 <= slice3shift_search_1_5 - slice3shift_reference_1;
      slice3cost_pixels_first_1_6 <= slice3shift_search_1_6 - slice3shift_reference_1;
      slice3cost_pixels_first_1_7 <= slice3shift_search_1_7 - slice3shift_reference_1;
      slice3cost_pixels_first_1_8 <= slice3shift_search_1_8 - slice3shift_reference_1;
      slice3cost_pixels_first_1_9 <= slice3shift_search_1_9 - slice3shift_reference_1;
      slice3cost_pixels_first_1_10 <= slice3shift_search_1_10 - slice3shift_reference_1;
      slice3cost_pixels_first_1_11 <= slice3shift_search_1_11 - slice3shift_reference_1;
      slice3cost_pixels_first_1_12 <= slice3shift_search_1_12 - slice3shift_reference_1;
      slice3cost_pixels_first_1_13 <= slice3shift_search_1_13 - slice3shift_reference_1;
      slice3cost_pixels_first_1_14 <= slice3shift_search_1_14 - slice3shift_reference_1;
      slice3cost_pixels_first_1_15 <= slice3shift_search_1_15 - slice3shift_reference_1;
      slice3cost_pixels_first_1_16 <= slice3shift_search_1_16 - slice3shift_reference_1;
      slice3cost_pixels_first_1_17 <= slice3shift_search_1_17 - slice3shift_reference_1;
      slice3cost_pixels_first_1_18 <= slice3shift_search_1_18 - slice3shift_reference_1;
      slice3cost_pixels_first_1_19 <= slice3shift_search_1_19 - slice3shift_reference_1;
      slice3cost_pixels_first_1_20 <= slice3shift_search_1_20 - slice3shift_reference_1;
      slice3cost_pixels_first_1_21 <= slice3shift_search_1_21 - slice3shift_reference_1;
      slice3cost_pixels_first_1_22 <= slice3shift_search_1_22 - slice3shift_reference_1;
      slice3cost_pixels_first_1_23 <= slice3shift_search_1_23 - slice3shift_reference_1;
      slice3cost_pixels_first_1_24 <= slice3shift_search_1_24 - slice3shift_reference_1;
      slice3cost_pixels_cost_0_0 <= (folded(slice3cost_pixels_first_0_0) + as_number((slice3cost_pixels_first_0_0 <
        0))) mod 256;
      slice3cost_pixels_cost_0_1 <= (folded(slice3cost_pixels_first_0_1) + as_number((slice3cost_pixels_first_0_1 <
        0))) mod 256;
      slice3cost_pixels_cost_0_2 <= (folded(slice3cost_pixels_first_0_2) + as_number((slice3cost_pixels_first_0_2 <
        0))) mod 256;
      slice3cost_pixels_cost_0_3 <= (folded(slice3cost_pixels_first_0_3) + as_number((slice3cost_pixels_first_0_3 <
        0))) mod 256;
      slice3cost_pixels_cost_0_4 <= (folded(slice3cost_pixels_first_0_4) + as_number((slice3cost_pixels_first_0_4 <
        0))) mod 256;
      slice3cost_pixels_cost_0_5 <= (folded(slice3cost_pixels_first_0_5) + as_number((slice3cost_pixels_first_0_5 <
        0))) mod 256;
      slice3cost_pixels_cost_0_6 <= (folded(slice3cost_pixels_first_0_6) + as_number((slice3cost_pixels_first_0_6 <
        0))) mod 256;
      slice3cost_pixels_cost_0_7 <= (folded(slice3cost_pixels_first_0_7) + as_number((slice3cost_pixels_first_0_7 <
        0))) mod 256;
      slice3cost_pixels_cost_0_8 <= (folded(slice3cost_pixels_first_0_8) + as_number((slice3cost_pixels_first_0_8 <
        0))) mod 256;
      slice3cost_pixels_cost_0_9 <= (folded(slice3cost_pixels_first_0_9) + as_number((slice3cost_pixels_first_0_9 <
        0))) mod 256;
      slice3cost_pixels_cost_0_10 <= (folded(slice3cost_pixels_first_0_10) + as_number((slice3cost_pixels_first_0_10 <
        0))) mod 256;
      slice3cost_pixels_cost_0_11 <= (folded(slice3cost_pixels_first_0_11) + as_number((slice3cost_pixels_first_0_11 <
        0))) mod 256;
      slice3cost_pixels_cost_0_12 <= (folded(slice3cost_pixels_first_0_12) + as_number((slice3cost_pixels_first_0_12 <
        0))) mod 256;
      slice3cost_pixels_cost_0_13 <= (folded(slice3cost_pixels_first_0_13) + as_number((slice3cost_pixels_first_0_13 <
        0))) mod 256;
      slice3cost_pixels_cost_0_14 <= (folded(slice3cost_pixels_first_0_14) + as_number((slice3cost_pixels_first_0_14 <
        0))) mod 256;
      slice3cost_pixels_cost_0_15 <= (folded(slice3cost_pixels_first_0_15) + as_number((slice3cost_pixels_first_0_15 <
        0))) mod 256;
      slice3cost_pixels_cost_0_16 <= (folded(slice3cost_pixels_first_0_16) + as_number((slice3cost_pixels_first_0_16 <
        0))) mod 256;
      slice3cost_pixels_cost_0_17 <= (folded(slice3cost_pixels_first_0_17) + as_number((slice3cost_pixels_first_0_17 <
        0))) mod 256;
      slice3cost_pixels_cost_0_18 <= (folded(slice3cost_pixels_first_0_18) + as_number((slice3cost_pixels_first_0_18 <
        0))) mod 256;
      slice3cost_pixels_cost_0_19 <= (folded(slice3cost_pixels_first_0_19) + as_number((slice3cost_pixels_first_0_19 <
        0))) mod 256;
      slice3cost_pixels_cost_0_20 <= (folded(slice3cost_pixels_first_0_20) + as_number((slice3cost_pixels_first_0_20 <
        0))) mod 256;
      slice3cost_pixels_cost_0_21 <= (folded(slice3cost_pixels_first_0_21) + as_number((slice3cost_pixels_first_0_21 <
        0))) mod 256;
      slice3cost_pixels_cost_0_22 <= (folded(slice3cost_pixels_first_0_22) + as_number((slice3cost_pixels_first_0_22 <
        0))) mod 256;
      slice3cost_pixels_cost_0_23 <= (folded(slice3cost_pixels_first_0_23) + as_number((slice3cost_pixels_first_0_23 <
        0))) mod 256;
      slice3cost_pixels_cost_0_24 <= (folded(slice3cost_pixels_first_0_24) + as_number((slice3cost_pixels_first_0_24 <
        0))) mod 256;
      slice3cost_pixels_cost_1_0 <= (folded(slice3cost_pixels_first_1_0) + as_number((slice3cost_pixels_first_1_0 <
        0))) mod 256;
      slice3cost_pixels_cost_1_1 <= (folded(slice3cost_pixels_first_1_1) + as_number((slice3cost_pixels_first_1_1 <
        0))) mod 256;
      slice3cost_pixels_cost_1_2 <= (folded(slice3cost_pixels_first_1_2) + as_number((slice3cost_pixels_first_1_2 <
        0))) mod 256;
      slice3cost_pixels_cost_1_3 <= (folded(slice3cost_pixels_first_1_3) + as_number((slice3cost_pixels_first_1_3 <
        0))) mod 256;
      slice3cost_pixels_cost_1_4 <= (folded(slice3cost_pixels_first_1_4) + as_number((slice3cost_pixels_first_1_4 <
        0))) mod 256;
      slice3cost_pixels_cost_1_5 <= (folded(slice3cost_pixels_first_1_5) + as_number((slice3cost_pixels_first_1_5 <
        0))) mod 256;
      slice3cost_pixels_cost_1_6 <= (folded(slice3cost_pixels_first_1_6) + as_number((slice3cost_pixels_first_1_6 <
        0))) mod 256;
      slice3cost_pixels_cost_1_7 <= (folded(slice3cost_pixels_first_1_7) + as_number((slice3cost_pixels_first_1_7 <
        0))) mod 256;
      slice3cost_pixels_cost_1_8 <= (folded(slice3cost_pixels_first_1_8) + as_number((slice3cost_pixels_first_1_8 <
        0))) mod 256;
      slice3cost_pixels_cost_1_9 <= (folded(slice3cost_pixels_first_1_9) + as_number((slice3cost_pixels_first_1_9 <
        0))) mod 256;
      slice3cost_pixels_cost_1_10 <= (folded(slice3cost_pixels_first_1_10) + as_number((slice3cost_pixels_first_1_10 <
        0))) mod 256;
      slice3cost_pixels_cost_1_11 <= (folded(slice3cost_pixels_first_1_11) + as_number((slice3cost_pixels_first_1_11 <
        0))) mod 256;
      slice3cost_pixels_cost_1_12 <= (folded(slice3cost_pixels_first_1_12) + as_number((slice3cost_pixels_first_1_12 <
        0))) mod 256;
      slice3cost_pixels_cost_1_13 <= (folded(slice3cost_pixels_first_1_13) + as_number((slice3cost_pixels_first_1_13 <
        0))) mod 256;
      slice3cost_pixels_cost_1_14 <= (folded(slice3cost_pixels_first_1_14) + as_number((slice3cost_pixels_first_1_14 <
        0))) mod 256;
      slice3cost_pixels_cost_1_15 <= (folded(slice3cost_pixels_first_1_15) + as_number((slice3cost_pixels_first_1_15 <
        0))) mod 256;
      slice3cost_pixels_cost_1_16 <= (folded(slice3cost_pixels_first_1_16) + as_number((slice3cost_pixels_first_1_16 <
        0))) mod 256;
      slice3cost_pixels_cost_1_17 <= (folded(slice3cost_pixels_first_1_17) + as_number((slice3cost_pixels_first_1_17 <
        0))) mod 256;
      slice3cost_pixels_cost_1_18 <= (folded(slice3cost_pixels_first_1_18) + as_number((slice3cost_pixels_first_1_18 <
        0))) mod 256;
      slice3cost_pixels_cost_1_19 <= (folded(slice3cost_pixels_first_1_19) + as_number((slice3cost_pixels_first_1_19 <
        0))) mod 256;
      slice3cost_pixels_cost_1_20 <= (folded(slice3cost_pixels_first_1_20) + as_number((slice3cost_pixels_first_1_20 <
        0))) mod 256;
      slice3cost_pixels_cost_1_21 <= (folded(slice3cost_pixels_first_1_21) + as_number((slice3cost_pixels_first_1_21 <
        0))) mod 256;
      slice3cost_pixels_cost_1_22 <= (folded(slice3cost_pixels_first_1_22) + as_number((slice3cost_pixels_first_1_22 <
        0))) mod 256;
      slice3cost_pixels_cost_1_23 <= (folded(slice3cost_pixels_first_1_23) + as_number((slice3cost_pixels_first_1_23 <
        0))) mod 256;
      slice3cost_pixels_cost_1_24 <= (folded(slice3cost_pixels_first_1_24) + as_number((slice3cost_pixels_first_1_24 <
        0))) mod 256;
      slice3cost_change_0_0 <= slice3cost_pixels_cost_1_0 - slice3cost_pixels_cost_0_0;
      slice3cost_change_0_1 <= slice3cost_pixels_cost_1_1 - slice3cost_pixels_cost_0_1;
      slice3cost_change_0_2 <= slice3cost_pixels_cost_1_2 - slice3cost_pixels_cost_0_2;
      slice3cost_change_0_3 <= slice3cost_pixels_cost_1_3 - slice3cost_pixels_cost_0_3;
      slice3cost_change_0_4 <= slice3cost_pixels_cost_1_4 - slice3cost_pixels_cost_0_4;
      slice3cost_change_0_5 <= slice3cost_pixels_cost_1_5 - slice3cost_pixels_cost_0_5;
      slice3cost_change_0_6 <= slice3cost_pixels_cost_1_6 - slice3cost_pixels_cost_0_6;
      slice3cost_change_0_7 <= slice3cost_pixels_cost_1_7 - slice3cost_pixels_cost_0_7;
      slice3cost_change_0_8 <= slice3cost_pixels_cost_1_8 - slice3cost_pixels_cost_0_8;
      slice3cost_change_0_9 <= slice3cost_pixels_cost_1_9 - slice3cost_pixels_cost_0_9;
      slice3cost_change_0_10 <= slice3cost_pixels_cost_1_10 - slice3cost_pixels_cost_0_10;
      slice3cost_change_0_11 <= slice3cost_pixels_cost_1_11 - slice3cost_pixels_cost_0_11;
      slice3cost_change_0_12 <= slice3cost_pixels_cost_1_12 - slice3cost_pixels_cost_0_12;
      slice3cost_change_0_13 <= slice3cost_pixels_cost_1_13 - slice3cost_pixels_cost_0_13;
      slice3cost_change_0_14 <= slice3cost_pixels_cost_1_14 - slice3cost_pixels_cost_0_14;
      slice3cost_change_0_15 <= slice3cost_pixels_cost_1_15 - slice3cost_pixels_cost_0_15;
      slice3cost_change_0_16 <= slice3cost_pixels_cost_1_16 - slice3cost_pixels_cost_0_16;
      slice3cost_change_0_17 <= slice3cost_pixels_cost_1_17 - slice3cost_pixels_cost_0_17;
      slice3cost_change_0_18 <= slice3cost_pixels_cost_1_18 - slice3cost_pixels_cost_0_18;
      slice3cost_change_0_19 <= slice3cost_pixels_cost_1_19 - slice3cost_pixels_cost_0_19;
      slice3cost_change_0_20 <= slice3cost_pixels_cost_1_20 - slice3cost_pixels_cost_0_20;
      slice3cost_change_0_21 <= slice3cost_pixels_cost_1_21 - slice3cost_pixels_cost_0_21;
      slice3cost_change_0_22 <= slice3cost_pixels_cost_1_22 - slice3cost_pixels_cost_0_22;
      slice3cost_change_0_23 <= slice3cost_pixels_cost_1_23 - slice3cost_pixels_cost_0_23;
      slice3cost_change_0_24 <= slice3cost_pixels_cost_1_24 - slice3cost_pixels_cost_0_24;
      slice3cost_ready_words_0 <= to_integer(slice3cost_read_words_0);
      slice3cost_ready_words_1 <= to_integer(slice3cost_read_words_1);
      slice3cost_ready_words_2 <= to_integer(slice3cost_read_words_2);
      slice3cost_ready_words_3 <= to_integer(slice3cost_read_words_3);
      slice3cost_ready_words_4 <= to_integer(slice3cost_read_words_4);
      slice3cost_ready_words_5 <= to_integer(slice3cost_read_words_5);
      slice3cost_ready_words_6 <= to_integer(slice3cost_read_words_6);
      slice3cost_ready_words_7 <= to_integer(slice3cost_read_words_7);
      slice3cost_ready_words_8 <= to_integer(slice3cost_read_words_8);
      slice3cost_ready_words_9 <= to_integer(slice3cost_read_words_9);
      slice3cost_ready_words_10 <= to_integer(slice3cost_read_words_10);
      slice3cost_ready_words_11 <= to_integer(slice3cost_read_words_11);
      slice3cost_ready_words_12 <= to_integer(slice3cost_read_words_12);
      slice3cost_ready_column <= slice3cost_change_column;
      slice3cost_column_0_0 <= slice3cost_column_0_0_choice_2;
      slice3cost_column_0_1 <= slice3cost_column_0_1_choice_2;
      slice3cost_column_0_2 <= slice3cost_column_0_2_choice_2;
      slice3cost_column_0_3 <= slice3cost_column_0_3_choice_2;
      slice3cost_column_0_4 <= slice3cost_column_0_4_choice_2;
      slice3cost_column_0_5 <= slice3cost_column_0_5_choice_2;
      slice3cost_column_0_6 <= slice3cost_column_0_6_choice_2;
      slice3cost_column_0_7 <= slice3cost_column_0_7_choice_2;
      slice3cost_column_0_8 <= slice3cost_column_0_8_choice_2;
      slice3cost_column_0_9 <= slice3cost_column_0_9_choice_2;
      slice3cost_column_0_10 <= slice3cost_column_0_10_choice_2;
      slice3cost_column_0_11 <= slice3cost_column_0_11_choice_2;
      slice3cost_column_0_12 <= slice3cost_column_0_12_choice_2;
      slice3cost_column_0_13 <= slice3cost_column_0_13_choice_2;
      slice3cost_column_0_14 <= slice3cost_column_0_14_choice_2;
      slice3cost_column_0_15 <= slice3cost_column_0_15_choice_2;
      slice3cost_column_0_16 <= slice3cost_column_0_16_choice_2;
      slice3cost_column_0_17 <= slice3cost_column_0_17_choice_2;
      slice3cost_column_0_18 <= slice3cost_column_0_18_choice_2;
      slice3cost_column_0_19 <= slice3cost_column_0_19_choice_2;
      slice3cost_column_0_20 <= slice3cost_column_0_20_choice_2;
      slice3cost_column_0_21 <= slice3cost_column_0_21_choice_2;
      slice3cost_column_0_22 <= slice3cost_column_0_22_choice_2;
      slice3cost_column_0_23 <= slice3cost_column_0_23_choice_2;
      slice3cost_column_0_24 <= slice3cost_column_0_24_choice_2;
      slice3cost_write_column <= slice3cost_ready_column;
      if slice0cost_ready_tag_valid then
        if slice0cost_ready_tag_row_start then
          slice3cost_read_column <= 0;
        else
          slice3cost_read_column <= (slice3cost_read_column + 1) mod 512;
        end if;
      end if;
      if slice0cost_tag_valid then
        if slice0cost_tag_row_start then
          slice3cost_change_column <= 0;
        else
          slice3cost_change_column <= (slice3cost_change_column + 1) mod 512;
        end if;
      end if;
      if slice0window_change_tag_valid then
        slice3cost_write_words_0 <= (slice3cost_column_0_1_choice_2 * 2048) + slice3cost_column_0_0_choice_2;
        slice3cost_write_words_1 <= (slice3cost_column_0_3_choice_2 * 2048) + slice3cost_column_0_2_choice_2;
        slice3cost_write_words_2 <= (slice3cost_column_0_5_choice_2 * 2048) + slice3cost_column_0_4_choice_2;
        slice3cost_write_words_3 <= (slice3cost_column_0_7_choice_2 * 2048) + slice3cost_column_0_6_choice_2;
        slice3cost_write_words_4 <= (slice3cost_column_0_9_choice_2 * 2048) + slice3cost_column_0_8_choice_2;
        slice3cost_write_words_5 <= (slice3cost_column_0_11_choice_2 * 2048) + slice3cost_column_0_10_choice_2;
        slice3cost_write_words_6 <= (slice3cost_column_0_13_choice_2 * 2048) + slice3cost_column_0_12_choice_2;
        slice3cost_write_words_7 <= (slice3cost_column_0_15_choice_2 * 2048) + slice3cost_column_0_14_choice_2;
        slice3cost_write_words_8 <= (slice3cost_column_0_17_choice_2 * 2048) + slice3cost_column_0_16_choice_2;
        slice3cost_write_words_9 <= (slice3cost_column_0_19_choice_2 * 2048) + slice3cost_column_0_18_choice_2;
        slice3cost_write_words_10 <= (slice3cost_column_0_21_choice_2 * 2048) + slice3cost_column_0_20_choice_2;
        slice3cost_write_words_11 <= (slice3cost_column_0_23_choice_2 * 2048) + slice3cost_column_0_22_choice_2;
        slice3cost_write_words_12 <= slice3cost_column_0_24_choice_2;
      end if;
      -- slice3window
      if slice0window_tag_valid then
        slice3window_ring_write_address <= slice3window_ring_read_address;
        if slice3window_ring_read_address = 7 then
          slice3window_ring_read_address <= 0;
        else
          slice3window_ring_read_address <= (slice3window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_0_choice := to_integer(slice3window_leaving_0(10 downto 0));
      else
        slice3window_change_0_0_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_1_choice := to_integer(slice3window_leaving_0(21 downto 11));
      else
        slice3window_change_0_1_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_2_choice := to_integer(slice3window_leaving_1(10 downto 0));
      else
        slice3window_change_0_2_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_3_choice := to_integer(slice3window_leaving_1(21 downto 11));
      else
        slice3window_change_0_3_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_4_choice := to_integer(slice3window_leaving_2(10 downto 0));
      else
        slice3window_change_0_4_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_5_choice := to_integer(slice3window_leaving_2(21 downto 11));
      else
        slice3window_change_0_5_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_6_choice := to_integer(slice3window_leaving_3(10 downto 0));
      else
        slice3window_change_0_6_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_7_choice := to_integer(slice3window_leaving_3(21 downto 11));
      else
        slice3window_change_0_7_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_8_choice := to_integer(slice3window_leaving_4(10 downto 0));
      else
        slice3window_change_0_8_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_9_choice := to_integer(slice3window_leaving_4(21 downto 11));
      else
        slice3window_change_0_9_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_10_choice := to_integer(slice3window_leaving_5(10 downto 0));
      else
        slice3window_change_0_10_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_11_choice := to_integer(slice3window_leaving_5(21 downto 11));
      else
        slice3window_change_0_11_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_12_choice := to_integer(slice3window_leaving_6(10 downto 0));
      else
        slice3window_change_0_12_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_13_choice := to_integer(slice3window_leaving_6(21 downto 11));
      else
        slice3window_change_0_13_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_14_choice := to_integer(slice3window_leaving_7(10 downto 0));
      else
        slice3window_change_0_14_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_15_choice := to_integer(slice3window_leaving_7(21 downto 11));
      else
        slice3window_change_0_15_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_16_choice := to_integer(slice3window_leaving_8(10 downto 0));
      else
        slice3window_change_0_16_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_17_choice := to_integer(slice3window_leaving_8(21 downto 11));
      else
        slice3window_change_0_17_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_18_choice := to_integer(slice3window_leaving_9(10 downto 0));
      else
        slice3window_change_0_18_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_19_choice := to_integer(slice3window_leaving_9(21 downto 11));
      else
        slice3window_change_0_19_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_20_choice := to_integer(slice3window_leaving_10(10 downto 0));
      else
        slice3window_change_0_20_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_21_choice := to_integer(slice3window_leaving_10(21 downto 11));
      else
        slice3window_change_0_21_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_22_choice := to_integer(slice3window_leaving_11(10 downto 0));
      else
        slice3window_change_0_22_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_23_choice := to_integer(slice3window_leaving_11(21 downto 11));
      else
        slice3window_change_0_23_choice := 0;
      end if;
      if slice2window_change_tag_leaves_window then
        slice3window_change_0_24_choice := to_integer(slice3window_leaving_12);
      else
        slice3window_change_0_24_choice := 0;
      end if;
      slice3window_entering_0_0 <= slice3cost_column_0_0;
      slice3window_entering_0_1 <= slice3cost_column_0_1;
      slice3window_entering_0_2 <= slice3cost_column_0_2;
      slice3window_entering_0_3 <= slice3cost_column_0_3;
      slice3window_entering_0_4 <= slice3cost_column_0_4;
      slice3window_entering_0_5 <= slice3cost_column_0_5;
      slice3window_entering_0_6 <= slice3cost_column_0_6;
      slice3window_entering_0_7 <= slice3cost_column_0_7;
      slice3window_entering_0_8 <= slice3cost_column_0_8;
      slice3window_entering_0_9 <= slice3cost_column_0_9;
      slice3window_entering_0_10 <= slice3cost_column_0_10;
      slice3window_entering_0_11 <= slice3cost_column_0_11;
      slice3window_entering_0_12 <= slice3cost_column_0_12;
      slice3window_entering_0_13 <= slice3cost_column_0_13;
      slice3window_entering_0_14 <= slice3cost_column_0_14;
      slice3window_entering_0_15 <= slice3cost_column_0_15;
      slice3window_entering_0_16 <= slice3cost_column_0_16;
      slice3window_entering_0_17 <= slice3cost_column_0_17;
      slice3window_entering_0_18 <= slice3cost_column_0_18;
      slice3window_entering_0_19 <= slice3cost_column_0_19;
      slice3window_entering_0_20 <= slice3cost_column_0_20;
      slice3window_entering_0_21 <= slice3cost_column_0_21;
      slice3window_entering_0_22 <= slice3cost_column_0_22;
      slice3window_entering_0_23 <= slice3cost_column_0_23;
      slice3window_entering_0_24 <= slice3cost_column_0_24;
      slice3window_change_0_0 <= slice3window_entering_0_0 - slice3window_change_0_0_choice;
      slice3window_change_0_1 <= slice3window_entering_0_1 - slice3window_change_0_1_choice;
      slice3window_change_0_2 <= slice3window_entering_0_2 - slice3window_change_0_2_choice;
      slice3window_change_0_3 <= slice3window_entering_0_3 - slice3window_change_0_3_choice;
      slice3window_change_0_4 <= slice3window_entering_0_4 - slice3window_change_0_4_choice;
      slice3window_change_0_5 <= slice3window_entering_0_5 - slice3window_change_0_5_choice;
      slice3window_change_0_6 <= slice3window_entering_0_6 - slice3window_change_0_6_choice;
      slice3window_change_0_7 <= slice3window_entering_0_7 - slice3window_change_0_7_choice;
      slice3window_change_0_8 <= slice3window_entering_0_8 - slice3window_change_0_8_choice;
      slice3window_change_0_9 <= slice3window_entering_0_9 - slice3window_change_0_9_choice;
      slice3window_change_0_10 <= slice3window_entering_0_10 - slice3window_change_0_10_choice;
      slice3window_change_0_11 <= slice3window_entering_0_11 - slice3window_change_0_11_choice;
      slice3window_change_0_12 <= slice3window_entering_0_12 - slice3window_change_0_12_choice;
      slice3window_change_0_13 <= slice3window_entering_0_13 - slice3window_change_0_13_choice;
      slice3window_change_0_14 <= slice3window_entering_0_14 - slice3window_change_0_14_choice;
      slice3window_change_0_15 <= slice3window_entering_0_15 - slice3window_change_0_15_choice;
      slice3window_change_0_16 <= slice3window_entering_0_16 - slice3window_change_0_16_choice;
      slice3window_change_0_17 <= slice3window_entering_0_17 - slice3window_change_0_17_choice;
      slice3window_change_0_18 <= slice3window_entering_0_18 - slice3window_change_0_18_choice;
      slice3window_change_0_19 <= slice3window_entering_0_19 - slice3window_change_0_19_choice;
      slice3window_change_0_20 <= slice3window_entering_0_20 - slice3window_change_0_20_choice;
      slice3window_change_0_21 <= slice3window_entering_0_21 - slice3window_change_0_21_choice;
      slice3window_change_0_22 <= slice3window_entering_0_22 - slice3window_change_0_22_choice;
      slice3window_change_0_23 <= slice3window_entering_0_23 - slice3window_change_0_23_choice;
      slice3window_change_0_24 <= slice3window_entering_0_24 - slice3window_change_0_24_choice;
      slice3window_change_tag_leaves_window <= slice2window_change_tag_leaves_window;
      slice3window_centre_output_column_0 <= slice2window_centre_output_column_0;
      slice3window_centre_first_column_0 <= slice2window_centre_first_column_0;
      slice3window_centre_end_of_line_0 <= slice2window_centre_end_of_line_0;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_0_choice := 0;
      else
        slice3window_sum_0_0_choice := slice3window_sum_0_0;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_1_choice := 0;
      else
        slice3window_sum_0_1_choice := slice3window_sum_0_1;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_2_choice := 0;
      else
        slice3window_sum_0_2_choice := slice3window_sum_0_2;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_3_choice := 0;
      else
        slice3window_sum_0_3_choice := slice3window_sum_0_3;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_4_choice := 0;
      else
        slice3window_sum_0_4_choice := slice3window_sum_0_4;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_5_choice := 0;
      else
        slice3window_sum_0_5_choice := slice3window_sum_0_5;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_6_choice := 0;
      else
        slice3window_sum_0_6_choice := slice3window_sum_0_6;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_7_choice := 0;
      else
        slice3window_sum_0_7_choice := slice3window_sum_0_7;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_8_choice := 0;
      else
        slice3window_sum_0_8_choice := slice3window_sum_0_8;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_9_choice := 0;
      else
        slice3window_sum_0_9_choice := slice3window_sum_0_9;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_10_choice := 0;
      else
        slice3window_sum_0_10_choice := slice3window_sum_0_10;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_11_choice := 0;
      else
        slice3window_sum_0_11_choice := slice3window_sum_0_11;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_12_choice := 0;
      else
        slice3window_sum_0_12_choice := slice3window_sum_0_12;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_13_choice := 0;
      else
        slice3window_sum_0_13_choice := slice3window_sum_0_13;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_14_choice := 0;
      else
        slice3window_sum_0_14_choice := slice3window_sum_0_14;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_15_choice := 0;
      else
        slice3window_sum_0_15_choice := slice3window_sum_0_15;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_16_choice := 0;
      else
        slice3window_sum_0_16_choice := slice3window_sum_0_16;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_17_choice := 0;
      else
        slice3window_sum_0_17_choice := slice3window_sum_0_17;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_18_choice := 0;
      else
        slice3window_sum_0_18_choice := slice3window_sum_0_18;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_19_choice := 0;
      else
        slice3window_sum_0_19_choice := slice3window_sum_0_19;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_20_choice := 0;
      else
        slice3window_sum_0_20_choice := slice3window_sum_0_20;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_21_choice := 0;
      else
        slice3window_sum_0_21_choice := slice3window_sum_0_21;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_22_choice := 0;
      else
        slice3window_sum_0_22_choice := slice3window_sum_0_22;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_23_choice := 0;
      else
        slice3window_sum_0_23_choice := slice3window_sum_0_23;
      end if;
      if slice2window_centre_first_column_0 then
        slice3window_sum_0_24_choice := 0;
      else
        slice3window_sum_0_24_choice := slice3window_sum_0_24;
      end if;
      if slice0winner2_tag_valid then
        slice3window_sum_0_0 <= (slice3window_sum_0_0_choice + slice3window_change_0_0) mod 16384;
        slice3window_sum_0_1 <= (slice3window_sum_0_1_choice + slice3window_change_0_1) mod 16384;
        slice3window_sum_0_2 <= (slice3window_sum_0_2_choice + slice3window_change_0_2) mod 16384;
        slice3window_sum_0_3 <= (slice3window_sum_0_3_choice + slice3window_change_0_3) mod 16384;
        slice3window_sum_0_4 <= (slice3window_sum_0_4_choice + slice3window_change_0_4) mod 16384;
        slice3window_sum_0_5 <= (slice3window_sum_0_5_choice + slice3window_change_0_5) mod 16384;
        slice3window_sum_0_6 <= (slice3window_sum_0_6_choice + slice3window_change_0_6) mod 16384;
        slice3window_sum_0_7 <= (slice3window_sum_0_7_choice + slice3window_change_0_7) mod 16384;
        slice3window_sum_0_8 <= (slice3window_sum_0_8_choice + slice3window_change_0_8) mod 16384;
        slice3window_sum_0_9 <= (slice3window_sum_0_9_choice + slice3window_change_0_9) mod 16384;
        slice3window_sum_0_10 <= (slice3window_sum_0_10_choice + slice3window_change_0_10) mod 16384;
        slice3window_sum_0_11 <= (slice3window_sum_0_11_choice + slice3window_change_0_11) mod 16384;
        slice3window_sum_0_12 <= (slice3window_sum_0_12_choice + slice3window_change_0_12) mod 16384;
        slice3window_sum_0_13 <= (slice3window_sum_0_13_choice + slice3window_change_0_13) mod 16384;
        slice3window_sum_0_14 <= (slice3window_sum_0_14_choice + slice3window_change_0_14) mod 16384;
        slice3window_sum_0_15 <= (slice3window_sum_0_15_choice + slice3window_change_0_15) mod 16384;
        slice3window_sum_0_16 <= (slice3window_sum_0_16_choice + slice3window_change_0_16) mod 16384;
        slice3window_sum_0_17 <= (slice3window_sum_0_17_choice + slice3window_change_0_17) mod 16384;
        slice3window_sum_0_18 <= (slice3window_sum_0_18_choice + slice3window_change_0_18) mod 16384;
        slice3window_sum_0_19 <= (slice3window_sum_0_19_choice + slice3window_change_0_19) mod 16384;
        slice3window_sum_0_20 <= (slice3window_sum_0_20_choice + slice3window_change_0_20) mod 16384;
        slice3window_sum_0_21 <= (slice3window_sum_0_21_choice + slice3window_change_0_21) mod 16384;
        slice3window_sum_0_22 <= (slice3window_sum_0_22_choice + slice3window_change_0_22) mod 16384;
        slice3window_sum_0_23 <= (slice3window_sum_0_23_choice + slice3window_change_0_23) mod 16384;
        slice3window_sum_0_24 <= (slice3window_sum_0_24_choice + slice3window_change_0_24) mod 16384;
      end if;
      -- slice3winner1
      slice3winner1_best_cost_0_0_is_less := (slice3window_sum_0_1 - slice3window_sum_0_0) < 0;
      slice3winner1_best_cost_0_1_is_less := (slice3window_sum_0_3 - slice3window_sum_0_2) < 0;
      slice3winner1_best_cost_0_2_is_less := (slice3window_sum_0_5 - slice3window_sum_0_4) < 0;
      slice3winner1_best_cost_0_3_is_less := (slice3window_sum_0_7 - slice3window_sum_0_6) < 0;
      slice3winner1_best_cost_0_4_is_less := (slice3window_sum_0_9 - slice3window_sum_0_8) < 0;
      slice3winner1_best_cost_0_5_is_less := (slice3window_sum_0_11 - slice3window_sum_0_10) < 0;
      slice3winner1_best_cost_0_6_is_less := (slice3window_sum_0_13 - slice3window_sum_0_12) < 0;
      slice3winner1_best_cost_0_7_is_less := (slice3window_sum_0_15 - slice3window_sum_0_14) < 0;
      slice3winner1_best_cost_0_8_is_less := (slice3window_sum_0_17 - slice3window_sum_0_16) < 0;
      slice3winner1_best_cost_0_9_is_less := (slice3window_sum_0_19 - slice3window_sum_0_18) < 0;
      slice3winner1_best_cost_0_10_is_less := (slice3window_sum_0_21 - slice3window_sum_0_20) < 0;
      slice3winner1_best_cost_0_11_is_less := (slice3window_sum_0_23 - slice3window_sum_0_22) < 0;
      slice3winner1_best_cost_0_12 <= slice3window_sum_0_24;
      slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_0_is_less;
      if slice3winner1_best_cost_0_0_is_less then
        slice3winner1_best_cost_0_0 <= slice3window_sum_0_1;
      else
        slice3winner1_best_cost_0_0 <= slice3window_sum_0_0;
      end if;
      if slice3winner1_best_cost_0_1_is_less then
        slice3winner1_best_cost_0_1 <= slice3window_sum_0_3;
        slice3winner1_best_index_0_1 <= 3;
      else
        slice3winner1_best_cost_0_1 <= slice3window_sum_0_2;
        slice3winner1_best_index_0_1 <= 2;
      end if;
      if slice3winner1_best_cost_0_2_is_less then
        slice3winner1_best_cost_0_2 <= slice3window_sum_0_5;
        slice3winner1_best_index_0_2 <= 5;
      else
        slice3winner1_best_cost_0_2 <= slice3window_sum_0_4;
        slice3winner1_best_index_0_2 <= 4;
      end if;
      if slice3winner1_best_cost_0_3_is_less then
        slice3winner1_best_cost_0_3 <= slice3window_sum_0_7;
        slice3winner1_best_index_0_3 <= 7;
      else
        slice3winner1_best_cost_0_3 <= slice3window_sum_0_6;
        slice3winner1_best_index_0_3 <= 6;
      end if;
      if slice3winner1_best_cost_0_4_is_less then
        slice3winner1_best_cost_0_4 <= slice3window_sum_0_9;
        slice3winner1_best_index_0_4 <= 9;
      else
        slice3winner1_best_cost_0_4 <= slice3window_sum_0_8;
        slice3winner1_best_index_0_4 <= 8;
      end if;
      if slice3winner1_best_cost_0_5_is_less then
        slice3winner1_best_cost_0_5 <= slice3window_sum_0_11;
        slice3winner1_best_index_0_5 <= 11;
      else
        slice3winner1_best_cost_0_5 <= slice3window_sum_0_10;
        slice3winner1_best_index_0_5 <= 10;
      end if;
      if slice3winner1_best_cost_0_6_is_less then
        slice3winner1_best_cost_0_6 <= slice3window_sum_0_13;
        slice3winner1_best_index_0_6 <= 13;
      else
        slice3winner1_best_cost_0_6 <= slice3window_sum_0_12;
        slice3winner1_best_index_0_6 <= 12;
      end if;
      if slice3winner1_best_cost_0_7_is_less then
        slice3winner1_best_cost_0_7 <= slice3window_sum_0_15;
        slice3winner1_best_index_0_7 <= 15;
      else
        slice3winner1_best_cost_0_7 <= slice3window_sum_0_14;
        slice3winner1_best_index_0_7 <= 14;
      end if;
      if slice3winner1_best_cost_0_8_is_less then
        slice3winner1_best_cost_0_8 <= slice3window_sum_0_17;
        slice3winner1_best_index_0_8 <= 17;
      else
        slice3winner1_best_cost_0_8 <= slice3window_sum_0_16;
        slice3winner1_best_index_0_8 <= 16;
      end if;
      if slice3winner1_best_cost_0_9_is_less then
        slice3winner1_best_cost_0_9 <= slice3window_sum_0_19;
        slice3winner1_best_index_0_9 <= 19;
      else
        slice3winner1_best_cost_0_9 <= slice3window_sum_0_18;
        slice3winner1_best_index_0_9 <= 18;
      end if;
      if slice3winner1_best_cost_0_10_is_less then
        slice3winner1_best_cost_0_10 <= slice3window_sum_0_21;
        slice3winner1_best_index_0_10 <= 21;
      else
        slice3winner1_best_cost_0_10 <= slice3window_sum_0_20;
        slice3winner1_best_index_0_10 <= 20;
      end if;
      if slice3winner1_best_cost_0_11_is_less then
        slice3winner1_best_cost_0_11 <= slice3window_sum_0_23;
        slice3winner1_best_index_0_11 <= 23;
      else
        slice3winner1_best_cost_0_11 <= slice3window_sum_0_22;
        slice3winner1_best_index_0_11 <= 22;
      end if;
      -- slice3winner2
      slice3winner2_best_cost_0_0_is_less := (slice3winner1_best_cost_0_1 - slice3winner1_best_cost_0_0) < 0;
      slice3winner2_best_cost_0_1_is_less := (slice3winner1_best_cost_0_3 - slice3winner1_best_cost_0_2) < 0;
      slice3winner2_best_cost_0_2_is_less := (slice3winner1_best_cost_0_5 - slice3winner1_best_cost_0_4) < 0;
      slice3winner2_best_cost_0_3_is_less := (slice3winner1_best_cost_0_7 - slice3winner1_best_cost_0_6) < 0;
      slice3winner2_best_cost_0_4_is_less := (slice3winner1_best_cost_0_9 - slice3winner1_best_cost_0_8) < 0;
      slice3winner2_best_cost_0_5_is_less := (slice3winner1_best_cost_0_11 - slice3winner1_best_cost_0_10) < 0;
      slice3winner2_best_cost_0_6 <= slice3winner1_best_cost_0_12;
      if slice3winner2_best_cost_0_0_is_less then
        slice3winner2_best_cost_0_0 <= slice3winner1_best_cost_0_1;
        slice3winner2_best_index_0_0 <= slice3winner1_best_index_0_1;
      else
        slice3winner2_best_cost_0_0 <= slice3winner1_best_cost_0_0;
        slice3winner2_best_index_0_0 <= as_number(slice3winner1_best_index_0_0);
      end if;
      if slice3winner2_best_cost_0_1_is_less then
        slice3winner2_best_cost_0_1 <= slice3winner1_best_cost_0_3;
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_3;
      else
        slice3winner2_best_cost_0_1 <= slice3winner1_best_cost_0_2;
        slice3winner2_best_index_0_1 <= slice3winner1_best_index_0_2;
      end if;
      if slice3winner2_best_cost_0_2_is_less then
        slice3winner2_best_cost_0_2 <= slice3winner1_best_cost_0_5;
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_5;
      else
        slice3winner2_best_cost_0_2 <= slice3winner1_best_cost_0_4;
        slice3winner2_best_index_0_2 <= slice3winner1_best_index_0_4;
      end if;
      if slice3winner2_best_cost_0_3_is_less then
        slice3winner2_best_cost_0_3 <= slice3winner1_best_cost_0_7;
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_7;
      else
        slice3winner2_best_cost_0_3 <= slice3winner1_best_cost_0_6;
        slice3winner2_best_index_0_3 <= slice3winner1_best_index_0_6;
      end if;
      if slice3winner2_best_cost_0_4_is_less then
        slice3winner2_best_cost_0_4 <= slice3winner1_best_cost_0_9;
        slice3winner2_best_index_0_4 <= slice3winner1_best_index_0_9;
      else
        slice3winner2_best_cost_0_4 <= slice3winner1_best_cost_0_8;
        slice3winner2_best_index_0_4 <= slice3winner1_best_index_0_8;
      end if;
      if slice3winner2_best_cost_0_5_is_less then
        slice3winner2_best_cost_0_5 <= slice3winner1_best_cost_0_11;
        slice3winner2_best_index_0_5 <= slice3winner1_best_index_0_11;
      else
        slice3winner2_best_cost_0_5 <= slice3winner1_best_cost_0_10;
        slice3winner2_best_index_0_5 <= slice3winner1_best_index_0_10;
      end if;
      -- slice3winner3
      slice3winner3_best_cost_0_0_is_less := (slice3winner2_best_cost_0_1 - slice3winner2_best_cost_0_0) < 0;
      slice3winner3_best_cost_0_1_is_less := (slice3winner2_best_cost_0_3 - slice3winner2_best_cost_0_2) < 0;
      slice3winner3_best_cost_0_2_is_less := (slice3winner2_best_cost_0_5 - slice3winner2_best_cost_0_4) < 0;
      slice3winner3_best_cost_0_3 <= slice3winner2_best_cost_0_6;
      if slice3winner3_best_cost_0_0_is_less then
        slice3winner3_best_cost_0_0 <= slice3winner2_best_cost_0_1;
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_1;
      else
        slice3winner3_best_cost_0_0 <= slice3winner2_best_cost_0_0;
        slice3winner3_best_index_0_0 <= slice3winner2_best_index_0_0;
      end if;
      if slice3winner3_best_cost_0_1_is_less then
        slice3winner3_best_cost_0_1 <= slice3winner2_best_cost_0_3;
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_3;
      else
        slice3winner3_best_cost_0_1 <= slice3winner2_best_cost_0_2;
        slice3winner3_best_index_0_1 <= slice3winner2_best_index_0_2;
      end if;
      if slice3winner3_best_cost_0_2_is_less then
        slice3winner3_best_cost_0_2 <= slice3winner2_best_cost_0_5;
        slice3winner3_best_index_0_2 <= slice3winner2_best_index_0_5;
      else
        slice3winner3_best_cost_0_2 <= slice3winner2_best_cost_0_4;
        slice3winner3_best_index_0_2 <= slice3winner2_best_index_0_4;
      end if;
      -- slice3winner4
      slice3winner4_best_cost_0_0_is_less := (slice3winner3_best_cost_0_1 - slice3winner3_best_cost_0_0) < 0;
      slice3winner4_best_cost_0_1_is_less := (slice3winner3_best_cost_0_3 - slice3winner3_best_cost_0_2) < 0;
      if slice3winner4_best_cost_0_0_is_less then
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0_1;
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_1;
      else
        slice3winner4_best_cost_0_0 <= slice3winner3_best_cost_0_0;
        slice3winner4_best_index_0_0 <= slice3winner3_best_index_0_0;
      end if;
      if slice3winner4_best_cost_0_1_is_less then
        slice3winner4_best_cost_0_1 <= slice3winner3_best_cost_0_3;
        slice3winner4_best_index_0_1 <= slice0winner3_best_index_0_3;
      else
        slice3winner4_best_cost_0_1 <= slice3winner3_best_cost_0_2;
        slice3winner4_best_index_0_1 <= slice3winner3_best_index_0_2;
      end if;
      -- slice3winner5
      slice3winner5_best_cost_0_0_is_less := (slice3winner4_best_cost_0_1 - slice3winner4_best_cost_0_0) < 0;
      if slice3winner5_best_cost_0_0_is_less then
        slice3winner5_best_cost_0_0 <= slice3winner4_best_cost_0_1;
        slice3winner5_best_index_0_0 <= slice3winner4_best_index_0_1;
      else
        slice3winner5_best_cost_0_0 <= slice3winner4_best_cost_0_0;
        slice3winner5_best_index_0_0 <= slice3winner4_best_index_0_0;
      end if;
      -- slice3
      slice3_best_cost_0_0_is_less := (slice2_best_cost_0_0 - slice3winner5_best_cost_0_0) < 0;
      slice3_best_tag_valid <= slice2_best_tag_valid;
      slice3_best_tag_output_column <= slice2_best_tag_output_column;
      slice3_best_tag_start_of_frame <= slice2_best_tag_start_of_frame;
      slice3_best_tag_end_of_line <= slice2_best_tag_end_of_line;
      if slice3_best_cost_0_0_is_less then
        slice3_best_cost_0_0 <= slice2_best_cost_0_0;
        slice3_best_index_0_0 <= slice2_best_index_0_0;
      else
        slice3_best_cost_0_0 <= slice3winner5_best_cost_0_0;
        slice3_best_index_0_0 <= slice3winner5_best_index_0_0 + 21;
      end if;
      -- slice4shift
      if slice0cost_ready_tag_valid then
        slice4shift_search_0_0 <= slice4shift_search_0_1;
        slice4shift_search_0_1 <= slice4shift_search_0_2;
        slice4shift_search_0_2 <= slice4shift_search_0_3;
        slice4shift_search_0_3 <= slice4shift_search_0_4;
        slice4shift_search_0_4 <= slice4shift_search_0_5;
        slice4shift_search_0_5 <= slice4shift_search_0_6;
        slice4shift_search_0_6 <= slice4shift_search_0_7;
        slice4shift_search_0_7 <= slice4shift_search_0_8;
        slice4shift_search_0_8 <= slice4shift_search_0_9;
        slice4shift_search_0_9 <= slice4shift_search_0_10;
        slice4shift_search_0_10 <= slice4shift_search_0_11;
        slice4shift_search_0_11 <= slice4shift_search_0_12;
        slice4shift_search_0_12 <= slice4shift_search_0_13;
        slice4shift_search_0_13 <= slice4shift_search_0_14;
        slice4shift_search_0_14 <= slice4shift_search_0_15;
        slice4shift_search_0_15 <= slice4shift_search_0_16;
        slice4shift_search_0_16 <= slice4shift_search_0_17;
        slice4shift_search_0_17 <= slice4shift_search_0_18;
        slice4shift_search_0_18 <= slice4shift_search_0_19;
        slice4shift_search_0_19 <= slice4shift_search_0_20;
        slice4shift_search_0_20 <= slice3shift_search_out_0;
        slice4shift_search_1_0 <= slice4shift_search_1_1;
        slice4shift_search_1_1 <= slice4shift_search_1_2;
        slice4shift_search_1_2 <= slice4shift_search_1_3;
        slice4shift_search_1_3 <= slice4shift_search_1_4;
        slice4shift_search_1_4 <= slice4shift_search_1_5;
        slice4shift_search_1_5 <= slice4shift_search_1_6;
        slice4shift_search_1_6 <= slice4shift_search_1_7;
        slice4shift_search_1_7 <= slice4shift_search_1_8;
        slice4shift_search_1_8 <= slice4shift_search_1_9;
        slice4shift_search_1_9 <= slice4shift_search_1_10;
        slice4shift_search_1_10 <= slice4shift_search_1_11;
        slice4shift_search_1_11 <= slice4shift_search_1_12;
        slice4shift_search_1_12 <= slice4shift_search_1_13;
        slice4shift_search_1_13 <= slice4shift_search_1_14;
        slice4shift_search_1_14 <= slice4shift_search_1_15;
        slice4shift_search_1_15 <= slice4shift_search_1_16;
        slice4shift_search_1_16 <= slice4shift_search_1_17;
        slice4shift_search_1_17 <= slice4shift_search_1_18;
        slice4shift_search_1_18 <= slice4shift_search_1_19;
        slice4shift_search_1_19 <= slice4shift_search_1_20;
        slice4shift_search_1_20 <= slice3shift_search_out_1;
      end if;
      slice4shift_reference_0 <= slice3shift_reference_0;
      slice4shift_reference_1 <= slice3shift_reference_1;
      -- slice4cost
      if slice1window_change_tag_first_group then
        slice4cost_column_0_0_choice := 0;
      else
        slice4cost_column_0_0_choice := slice4cost_ready_words_0 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_0_choice_2 := 0;
      else
        slice4cost_column_0_0_choice_2 := (slice4cost_change_0_0 + slice4cost_column_0_0_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_1_choice := 0;
      else
        slice4cost_column_0_1_choice := slice4cost_ready_words_0 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_1_choice_2 := 0;
      else
        slice4cost_column_0_1_choice_2 := (slice4cost_change_0_1 + slice4cost_column_0_1_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_2_choice := 0;
      else
        slice4cost_column_0_2_choice := slice4cost_ready_words_1 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_2_choice_2 := 0;
      else
        slice4cost_column_0_2_choice_2 := (slice4cost_change_0_2 + slice4cost_column_0_2_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_3_choice := 0;
      else
        slice4cost_column_0_3_choice := slice4cost_ready_words_1 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_3_choice_2 := 0;
      else
        slice4cost_column_0_3_choice_2 := (slice4cost_change_0_3 + slice4cost_column_0_3_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_4_choice := 0;
      else
        slice4cost_column_0_4_choice := slice4cost_ready_words_2 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_4_choice_2 := 0;
      else
        slice4cost_column_0_4_choice_2 := (slice4cost_change_0_4 + slice4cost_column_0_4_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_5_choice := 0;
      else
        slice4cost_column_0_5_choice := slice4cost_ready_words_2 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_5_choice_2 := 0;
      else
        slice4cost_column_0_5_choice_2 := (slice4cost_change_0_5 + slice4cost_column_0_5_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_6_choice := 0;
      else
        slice4cost_column_0_6_choice := slice4cost_ready_words_3 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_6_choice_2 := 0;
      else
        slice4cost_column_0_6_choice_2 := (slice4cost_change_0_6 + slice4cost_column_0_6_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_7_choice := 0;
      else
        slice4cost_column_0_7_choice := slice4cost_ready_words_3 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_7_choice_2 := 0;
      else
        slice4cost_column_0_7_choice_2 := (slice4cost_change_0_7 + slice4cost_column_0_7_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_8_choice := 0;
      else
        slice4cost_column_0_8_choice := slice4cost_ready_words_4 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_8_choice_2 := 0;
      else
        slice4cost_column_0_8_choice_2 := (slice4cost_change_0_8 + slice4cost_column_0_8_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_9_choice := 0;
      else
        slice4cost_column_0_9_choice := slice4cost_ready_words_4 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_9_choice_2 := 0;
      else
        slice4cost_column_0_9_choice_2 := (slice4cost_change_0_9 + slice4cost_column_0_9_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_10_choice := 0;
      else
        slice4cost_column_0_10_choice := slice4cost_ready_words_5 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_10_choice_2 := 0;
      else
        slice4cost_column_0_10_choice_2 := (slice4cost_change_0_10 + slice4cost_column_0_10_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_11_choice := 0;
      else
        slice4cost_column_0_11_choice := slice4cost_ready_words_5 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_11_choice_2 := 0;
      else
        slice4cost_column_0_11_choice_2 := (slice4cost_change_0_11 + slice4cost_column_0_11_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_12_choice := 0;
      else
        slice4cost_column_0_12_choice := slice4cost_ready_words_6 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_12_choice_2 := 0;
      else
        slice4cost_column_0_12_choice_2 := (slice4cost_change_0_12 + slice4cost_column_0_12_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_13_choice := 0;
      else
        slice4cost_column_0_13_choice := slice4cost_ready_words_6 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_13_choice_2 := 0;
      else
        slice4cost_column_0_13_choice_2 := (slice4cost_change_0_13 + slice4cost_column_0_13_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_14_choice := 0;
      else
        slice4cost_column_0_14_choice := slice4cost_ready_words_7 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_14_choice_2 := 0;
      else
        slice4cost_column_0_14_choice_2 := (slice4cost_change_0_14 + slice4cost_column_0_14_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_15_choice := 0;
      else
        slice4cost_column_0_15_choice := slice4cost_ready_words_7 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_15_choice_2 := 0;
      else
        slice4cost_column_0_15_choice_2 := (slice4cost_change_0_15 + slice4cost_column_0_15_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_16_choice := 0;
      else
        slice4cost_column_0_16_choice := slice4cost_ready_words_8 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_16_choice_2 := 0;
      else
        slice4cost_column_0_16_choice_2 := (slice4cost_change_0_16 + slice4cost_column_0_16_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_17_choice := 0;
      else
        slice4cost_column_0_17_choice := slice4cost_ready_words_8 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_17_choice_2 := 0;
      else
        slice4cost_column_0_17_choice_2 := (slice4cost_change_0_17 + slice4cost_column_0_17_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_18_choice := 0;
      else
        slice4cost_column_0_18_choice := slice4cost_ready_words_9 mod 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_18_choice_2 := 0;
      else
        slice4cost_column_0_18_choice_2 := (slice4cost_change_0_18 + slice4cost_column_0_18_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_19_choice := 0;
      else
        slice4cost_column_0_19_choice := slice4cost_ready_words_9 / 2048;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_19_choice_2 := 0;
      else
        slice4cost_column_0_19_choice_2 := (slice4cost_change_0_19 + slice4cost_column_0_19_choice) mod 2048;
      end if;
      if slice1window_change_tag_first_group then
        slice4cost_column_0_20_choice := 0;
      else
        slice4cost_column_0_20_choice := slice4cost_ready_words_10;
      end if;
      if slice1window_change_tag_border_column then
        slice4cost_column_0_20_choice_2 := 0;
      else
        slice4cost_column_0_20_choice_2 := (slice4cost_change_0_20 + slice4cost_column_0_20_choice) mod 2048;
      end if;
      slice4cost_pixels_first_0_0 <= slice4shift_search_0_0 - slice4shift_reference_0;
      slice4cost_pixels_first_0_1 <= slice4shift_search_0_1 - slice4shift_reference_0;
      slice4cost_pixels_first_0_2 <= slice4shift_search_0_2 - slice4shift_reference_0;
      slice4cost_pixels_first_0_3 <= slice4shift_search_0_3 - slice4shift_reference_0;
      slice4cost_pixels_first_0_4 <= slice4shift_search_0_4 - slice4shift_reference_0;
      slice4cost_pixels_first_0_5 <= slice4shift_search_0_5 - slice4shift_reference_0;
      slice4cost_pixels_first_0_6 <= slice4shift_search_0_6 - slice4shift_reference_0;
      slice4cost_pixels_first_0_7 <= slice4shift_search_0_7 - slice4shift_reference_0;
      slice4cost_pixels_first_0_8 <= slice4shift_search_0_8 - slice4shift_reference_0;
      slice4cost_pixels_first_0_9 <= slice4shift_search_0_9 - slice4shift_reference_0;
      slice4cost_pixels_first_0_10 <= slice4shift_search_0_10 - slice4shift_reference_0;
      slice4cost_pixels_first_0_11 <= slice4shift_search_0_11 - slice4shift_reference_0;
      slice4cost_pixels_first_0_12 <= slice4shift_search_0_12 - slice4shift_reference_0;
      slice4cost_pixels_first_0_13 <= slice4shift_search_0_13 - slice4shift_reference_0;
      slice4cost_pixels_first_0_14 <= slice4shift_search_0_14 - slice4shift_reference_0;
      slice4cost_pixels_first_0_15 <= slice4shift_search_0_15 - slice4shift_reference_0;
      slice4cost_pixels_first_0_16 <= slice4shift_search_0_16 - slice4shift_reference_0;
      slice4cost_pixels_first_0_17 <= slice4shift_search_0_17 - slice4shift_reference_0;
      slice4cost_pixels_first_0_18 <= slice4shift_search_0_18 - slice4shift_reference_0;
      slice4cost_pixels_first_0_19 <= slice4shift_search_0_19 - slice4shift_reference_0;
      slice4cost_pixels_first_0_20 <= slice4shift_search_0_20 - slice4shift_reference_0;
      slice4cost_pixels_first_1_0 <= slice4shift_search_1_0 - slice4shift_reference_1;
      slice4cost_pixels_first_1_1 <= slice4shift_search_1_1 - slice4shift_reference_1;
      slice4cost_pixels_first_1_2 <= slice4shift_search_1_2 - slice4shift_reference_1;
      slice4cost_pixels_first_1_3 <= slice4shift_search_1_3 - slice4shift_reference_1;
      slice4cost_pixels_first_1_4 <= slice4shift_search_1_4 - slice4shift_reference_1;
      slice4cost_pixels_first_1_5 <= slice4shift_search_1_5 - slice4shift_reference_1;
      slice4cost_pixels_first_1_6 <= slice4shift_search_1_6 - slice4shift_reference_1;
      slice4cost_pixels_first_1_7 <= slice4shift_search_1_7 - slice4shift_reference_1;
      slice4cost_pixels_first_1_8 <= slice4shift_search_1_8 - slice4shift_reference_1;
      slice4cost_pixels_first_1_9 <= slice4shift_search_1_9 - slice4shift_reference_1;
      slice4cost_pixels_first_1_10 <= slice4shift_search_1_10 - slice4shift_reference_1;
      slice4cost_pixels_first_1_11 <= slice4shift_search_1_11 - slice4shift_reference_1;
      slice4cost_pixels_first_1_12 <= slice4shift_search_1_12 - slice4shift_reference_1;
      slice4cost_pixels_first_1_13 <= slice4shift_search_1_13 - slice4shift_reference_1;
      slice4cost_pixels_first_1_14 <= slice4shift_search_1_14 - slice4shift_reference_1;
      slice4cost_pixels_first_1_15 <= slice4shift_search_1_15 - slice4shift_reference_1;
      slice4cost_pixels_first_1_16 <= slice4shift_search_1_16 - slice4shift_reference_1;
      slice4cost_pixels_first_1_17 <= slice4shift_search_1_17 - slice4shift_reference_1;
      slice4cost_pixels_first_1_18 <= slice4shift_search_1_18 - slice4shift_reference_1;
      slice4cost_pixels_first_1_19 <= slice4shift_search_1_19 - slice4shift_reference_1;
      slice4cost_pixels_first_1_20 <= slice4shift_search_1_20 - slice4shift_reference_1;
      slice4cost_pixels_cost_0_0 <= (folded(slice4cost_pixels_first_0_0) + as_number((slice4cost_pixels_first_0_0 <
        0))) mod 256;
      slice4cost_pixels_cost_0_1 <= (folded(slice4cost_pixels_first_0_1) + as_number((slice4cost_pixels_first_0_1 <
        0))) mod 256;
      slice4cost_pixels_cost_0_2 <= (folded(slice4cost_pixels_first_0_2) + as_number((slice4cost_pixels_first_0_2 <
        0))) mod 256;
      slice4cost_pixels_cost_0_3 <= (folded(slice4cost_pixels_first_0_3) + as_number((slice4cost_pixels_first_0_3 <
        0))) mod 256;
      slice4cost_pixels_cost_0_4 <= (folded(slice4cost_pixels_first_0_4) + as_number((slice4cost_pixels_first_0_4 <
        0))) mod 256;
      slice4cost_pixels_cost_0_5 <= (folded(slice4cost_pixels_first_0_5) + as_number((slice4cost_pixels_first_0_5 <
        0))) mod 256;
      slice4cost_pixels_cost_0_6 <= (folded(slice4cost_pixels_first_0_6) + as_number((slice4cost_pixels_first_0_6 <
        0))) mod 256;
      slice4cost_pixels_cost_0_7 <= (folded(slice4cost_pixels_first_0_7) + as_number((slice4cost_pixels_first_0_7 <
        0))) mod 256;
      slice4cost_pixels_cost_0_8 <= (folded(slice4cost_pixels_first_0_8) + as_number((slice4cost_pixels_first_0_8 <
        0))) mod 256;
      slice4cost_pixels_cost_0_9 <= (folded(slice4cost_pixels_first_0_9) + as_number((slice4cost_pixels_first_0_9 <
        0))) mod 256;
      slice4cost_pixels_cost_0_10 <= (folded(slice4cost_pixels_first_0_10) + as_number((slice4cost_pixels_first_0_10 <
        0))) mod 256;
      slice4cost_pixels_cost_0_11 <= (folded(slice4cost_pixels_first_0_11) + as_number((slice4cost_pixels_first_0_11 <
        0))) mod 256;
      slice4cost_pixels_cost_0_12 <= (folded(slice4cost_pixels_first_0_12) + as_number((slice4cost_pixels_first_0_12 <
        0))) mod 256;
      slice4cost_pixels_cost_0_13 <= (folded(slice4cost_pixels_first_0_13) + as_number((slice4cost_pixels_first_0_13 <
        0))) mod 256;
      slice4cost_pixels_cost_0_14 <= (folded(slice4cost_pixels_first_0_14) + as_number((slice4cost_pixels_first_0_14 <
        0))) mod 256;
      slice4cost_pixels_cost_0_15 <= (folded(slice4cost_pixels_first_0_15) + as_number((slice4cost_pixels_first_0_15 <
        0))) mod 256;
      slice4cost_pixels_cost_0_16 <= (folded(slice4cost_pixels_first_0_16) + as_number((slice4cost_pixels_first_0_16 <
        0))) mod 256;
      slice4cost_pixels_cost_0_17 <= (folded(slice4cost_pixels_first_0_17) + as_number((slice4cost_pixels_first_0_17 <
        0))) mod 256;
      slice4cost_pixels_cost_0_18 <= (folded(slice4cost_pixels_first_0_18) + as_number((slice4cost_pixels_first_0_18 <
        0))) mod 256;
      slice4cost_pixels_cost_0_19 <= (folded(slice4cost_pixels_first_0_19) + as_number((slice4cost_pixels_first_0_19 <
        0))) mod 256;
      slice4cost_pixels_cost_0_20 <= (folded(slice4cost_pixels_first_0_20) + as_number((slice4cost_pixels_first_0_20 <
        0))) mod 256;
      slice4cost_pixels_cost_1_0 <= (folded(slice4cost_pixels_first_1_0) + as_number((slice4cost_pixels_first_1_0 <
        0))) mod 256;
      slice4cost_pixels_cost_1_1 <= (folded(slice4cost_pixels_first_1_1) + as_number((slice4cost_pixels_first_1_1 <
        0))) mod 256;
      slice4cost_pixels_cost_1_2 <= (folded(slice4cost_pixels_first_1_2) + as_number((slice4cost_pixels_first_1_2 <
        0))) mod 256;
      slice4cost_pixels_cost_1_3 <= (folded(slice4cost_pixels_first_1_3) + as_number((slice4cost_pixels_first_1_3 <
        0))) mod 256;
      slice4cost_pixels_cost_1_4 <= (folded(slice4cost_pixels_first_1_4) + as_number((slice4cost_pixels_first_1_4 <
        0))) mod 256;
      slice4cost_pixels_cost_1_5 <= (folded(slice4cost_pixels_first_1_5) + as_number((slice4cost_pixels_first_1_5 <
        0))) mod 256;
      slice4cost_pixels_cost_1_6 <= (folded(slice4cost_pixels_first_1_6) + as_number((slice4cost_pixels_first_1_6 <
        0))) mod 256;
      slice4cost_pixels_cost_1_7 <= (folded(slice4cost_pixels_first_1_7) + as_number((slice4cost_pixels_first_1_7 <
        0))) mod 256;
      slice4cost_pixels_cost_1_8 <= (folded(slice4cost_pixels_first_1_8) + as_number((slice4cost_pixels_first_1_8 <
        0))) mod 256;
      slice4cost_pixels_cost_1_9 <= (folded(slice4cost_pixels_first_1_9) + as_number((slice4cost_pixels_first_1_9 <
        0))) mod 256;
      slice4cost_pixels_cost_1_10 <= (folded(slice4cost_pixels_first_1_10) + as_number((slice4cost_pixels_first_1_10 <
        0))) mod 256;
      slice4cost_pixels_cost_1_11 <= (folded(slice4cost_pixels_first_1_11) + as_number((slice4cost_pixels_first_1_11 <
        0))) mod 256;
      slice4cost_pixels_cost_1_12 <= (folded(slice4cost_pixels_first_1_12) + as_number((slice4cost_pixels_first_1_12 <
        0))) mod 256;
      slice4cost_pixels_cost_1_13 <= (folded(slice4cost_pixels_first_1_13) + as_number((slice4cost_pixels_first_1_13 <
        0))) mod 256;
      slice4cost_pixels_cost_1_14 <= (folded(slice4cost_pixels_first_1_14) + as_number((slice4cost_pixels_first_1_14 <
        0))) mod 256;
      slice4cost_pixels_cost_1_15 <= (folded(slice4cost_pixels_first_1_15) + as_number((slice4cost_pixels_first_1_15 <
        0))) mod 256;
      slice4cost_pixels_cost_1_16 <= (folded(slice4cost_pixels_first_1_16) + as_number((slice4cost_pixels_first_1_16 <
        0))) mod 256;
      slice4cost_pixels_cost_1_17 <= (folded(slice4cost_pixels_first_1_17) + as_number((slice4cost_pixels_first_1_17 <
        0))) mod 256;
      slice4cost_pixels_cost_1_18 <= (folded(slice4cost_pixels_first_1_18) + as_number((slice4cost_pixels_first_1_18 <
        0))) mod 256;
      slice4cost_pixels_cost_1_19 <= (folded(slice4cost_pixels_first_1_19) + as_number((slice4cost_pixels_first_1_19 <
        0))) mod 256;
      slice4cost_pixels_cost_1_20 <= (folded(slice4cost_pixels_first_1_20) + as_number((slice4cost_pixels_first_1_20 <
        0))) mod 256;
      slice4cost_read_column <= slice3cost_read_column;
      slice4cost_change_column <= slice4cost_read_column;
      slice4cost_change_0_0 <= slice4cost_pixels_cost_1_0 - slice4cost_pixels_cost_0_0;
      slice4cost_change_0_1 <= slice4cost_pixels_cost_1_1 - slice4cost_pixels_cost_0_1;
      slice4cost_change_0_2 <= slice4cost_pixels_cost_1_2 - slice4cost_pixels_cost_0_2;
      slice4cost_change_0_3 <= slice4cost_pixels_cost_1_3 - slice4cost_pixels_cost_0_3;
      slice4cost_change_0_4 <= slice4cost_pixels_cost_1_4 - slice4cost_pixels_cost_0_4;
      slice4cost_change_0_5 <= slice4cost_pixels_cost_1_5 - slice4cost_pixels_cost_0_5;
      slice4cost_change_0_6 <= slice4cost_pixels_cost_1_6 - slice4cost_pixels_cost_0_6;
      slice4cost_change_0_7 <= slice4cost_pixels_cost_1_7 - slice4cost_pixels_cost_0_7;
      slice4cost_change_0_8 <= slice4cost_pixels_cost_1_8 - slice4cost_pixels_cost_0_8;
      slice4cost_change_0_9 <= slice4cost_pixels_cost_1_9 - slice4cost_pixels_cost_0_9;
      slice4cost_change_0_10 <= slice4cost_pixels_cost_1_10 - slice4cost_pixels_cost_0_10;
      slice4cost_change_0_11 <= slice4cost_pixels_cost_1_11 - slice4cost_pixels_cost_0_11;
      slice4cost_change_0_12 <= slice4cost_pixels_cost_1_12 - slice4cost_pixels_cost_0_12;
      slice4cost_change_0_13 <= slice4cost_pixels_cost_1_13 - slice4cost_pixels_cost_0_13;
      slice4cost_change_0_14 <= slice4cost_pixels_cost_1_14 - slice4cost_pixels_cost_0_14;
      slice4cost_change_0_15 <= slice4cost_pixels_cost_1_15 - slice4cost_pixels_cost_0_15;
      slice4cost_change_0_16 <= slice4cost_pixels_cost_1_16 - slice4cost_pixels_cost_0_16;
      slice4cost_change_0_17 <= slice4cost_pixels_cost_1_17 - slice4cost_pixels_cost_0_17;
      slice4cost_change_0_18 <= slice4cost_pixels_cost_1_18 - slice4cost_pixels_cost_0_18;
      slice4cost_change_0_19 <= slice4cost_pixels_cost_1_19 - slice4cost_pixels_cost_0_19;
      slice4cost_change_0_20 <= slice4cost_pixels_cost_1_20 - slice4cost_pixels_cost_0_20;
      slice4cost_ready_words_0 <= to_integer(slice4cost_read_words_0);
      slice4cost_ready_words_1 <= to_integer(slice4cost_read_words_1);
      slice4cost_ready_words_2 <= to_integer(slice4cost_read_words_2);
      slice4cost_ready_words_3 <= to_integer(slice4cost_read_words_3);
      slice4cost_ready_words_4 <= to_integer(slice4cost_read_words_4);
      slice4cost_ready_words_5 <= to_integer(slice4cost_read_words_5);
      slice4cost_ready_words_6 <= to_integer(slice4cost_read_words_6);
      slice4cost_ready_words_7 <= to_integer(slice4cost_read_words_7);
      slice4cost_ready_words_8 <= to_integer(slice4cost_read_words_8);
      slice4cost_ready_words_9 <= to_integer(slice4cost_read_words_9);
      slice4cost_ready_words_10 <= to_integer(slice4cost_read_words_10);
      slice4cost_column_0_0 <= slice4cost_column_0_0_choice_2;
      slice4cost_column_0_1 <= slice4cost_column_0_1_choice_2;
      slice4cost_column_0_2 <= slice4cost_column_0_2_choice_2;
      slice4cost_column_0_3 <= slice4cost_column_0_3_choice_2;
      slice4cost_column_0_4 <= slice4cost_column_0_4_choice_2;
      slice4cost_column_0_5 <= slice4cost_column_0_5_choice_2;
      slice4cost_column_0_6 <= slice4cost_column_0_6_choice_2;
      slice4cost_column_0_7 <= slice4cost_column_0_7_choice_2;
      slice4cost_column_0_8 <= slice4cost_column_0_8_choice_2;
      slice4cost_column_0_9 <= slice4cost_column_0_9_choice_2;
      slice4cost_column_0_10 <= slice4cost_column_0_10_choice_2;
      slice4cost_column_0_11 <= slice4cost_column_0_11_choice_2;
      slice4cost_column_0_12 <= slice4cost_column_0_12_choice_2;
      slice4cost_column_0_13 <= slice4cost_column_0_13_choice_2;
      slice4cost_column_0_14 <= slice4cost_column_0_14_choice_2;
      slice4cost_column_0_15 <= slice4cost_column_0_15_choice_2;
      slice4cost_column_0_16 <= slice4cost_column_0_16_choice_2;
      slice4cost_column_0_17 <= slice4cost_column_0_17_choice_2;
      slice4cost_column_0_18 <= slice4cost_column_0_18_choice_2;
      slice4cost_column_0_19 <= slice4cost_column_0_19_choice_2;
      slice4cost_column_0_20 <= slice4cost_column_0_20_choice_2;
      if slice0window_change_tag_valid then
        slice4cost_ready_column <= slice4cost_change_column;
      end if;
      if slice0window_tag_valid then
        slice4cost_write_column <= slice3cost_write_column;
        slice4cost_write_words_0 <= (slice4cost_column_0_1_choice_2 * 2048) + slice4cost_column_0_0_choice_2;
        slice4cost_write_words_1 <= (slice4cost_column_0_3_choice_2 * 2048) + slice4cost_column_0_2_choice_2;
        slice4cost_write_words_2 <= (slice4cost_column_0_5_choice_2 * 2048) + slice4cost_column_0_4_choice_2;
        slice4cost_write_words_3 <= (slice4cost_column_0_7_choice_2 * 2048) + slice4cost_column_0_6_choice_2;
        slice4cost_write_words_4 <= (slice4cost_column_0_9_choice_2 * 2048) + slice4cost_column_0_8_choice_2;
        slice4cost_write_words_5 <= (slice4cost_column_0_11_choice_2 * 2048) + slice4cost_column_0_10_choice_2;
        slice4cost_write_words_6 <= (slice4cost_column_0_13_choice_2 * 2048) + slice4cost_column_0_12_choice_2;
        slice4cost_write_words_7 <= (slice4cost_column_0_15_choice_2 * 2048) + slice4cost_column_0_14_choice_2;
        slice4cost_write_words_8 <= (slice4cost_column_0_17_choice_2 * 2048) + slice4cost_column_0_16_choice_2;
        slice4cost_write_words_9 <= (slice4cost_column_0_19_choice_2 * 2048) + slice4cost_column_0_18_choice_2;
        slice4cost_write_words_10 <= slice4cost_column_0_20_choice_2;
      end if;
      -- slice4window
      if slice0winner1_tag_valid then
        slice4window_ring_write_address <= slice4window_ring_read_address;
        if slice4window_ring_read_address = 7 then
          slice4window_ring_read_address <= 0;
        else
          slice4window_ring_read_address <= (slice4window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_0_choice := to_integer(slice4window_leaving_0(10 downto 0));
      else
        slice4window_change_0_0_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_1_choice := to_integer(slice4window_leaving_0(21 downto 11));
      else
        slice4window_change_0_1_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_2_choice := to_integer(slice4window_leaving_1(10 downto 0));
      else
        slice4window_change_0_2_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_3_choice := to_integer(slice4window_leaving_1(21 downto 11));
      else
        slice4window_change_0_3_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_4_choice := to_integer(slice4window_leaving_2(10 downto 0));
      else
        slice4window_change_0_4_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_5_choice := to_integer(slice4window_leaving_2(21 downto 11));
      else
        slice4window_change_0_5_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_6_choice := to_integer(slice4window_leaving_3(10 downto 0));
      else
        slice4window_change_0_6_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_7_choice := to_integer(slice4window_leaving_3(21 downto 11));
      else
        slice4window_change_0_7_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_8_choice := to_integer(slice4window_leaving_4(10 downto 0));
      else
        slice4window_change_0_8_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_9_choice := to_integer(slice4window_leaving_4(21 downto 11));
      else
        slice4window_change_0_9_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_10_choice := to_integer(slice4window_leaving_5(10 downto 0));
      else
        slice4window_change_0_10_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_11_choice := to_integer(slice4window_leaving_5(21 downto 11));
      else
        slice4window_change_0_11_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_12_choice := to_integer(slice4window_leaving_6(10 downto 0));
      else
        slice4window_change_0_12_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_13_choice := to_integer(slice4window_leaving_6(21 downto 11));
      else
        slice4window_change_0_13_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_14_choice := to_integer(slice4window_leaving_7(10 downto 0));
      else
        slice4window_change_0_14_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_15_choice := to_integer(slice4window_leaving_7(21 downto 11));
      else
        slice4window_change_0_15_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_16_choice := to_integer(slice4window_leaving_8(10 downto 0));
      else
        slice4window_change_0_16_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_17_choice := to_integer(slice4window_leaving_8(21 downto 11));
      else
        slice4window_change_0_17_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_18_choice := to_integer(slice4window_leaving_9(10 downto 0));
      else
        slice4window_change_0_18_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_19_choice := to_integer(slice4window_leaving_9(21 downto 11));
      else
        slice4window_change_0_19_choice := 0;
      end if;
      if slice3window_change_tag_leaves_window then
        slice4window_change_0_20_choice := to_integer(slice4window_leaving_10);
      else
        slice4window_change_0_20_choice := 0;
      end if;
      slice4window_entering_0_0 <= slice4cost_column_0_0;
      slice4window_entering_0_1 <= slice4cost_column_0_1;
      slice4window_entering_0_2 <= slice4cost_column_0_2;
      slice4window_entering_0_3 <= slice4cost_column_0_3;
      slice4window_entering_0_4 <= slice4cost_column_0_4;
      slice4window_entering_0_5 <= slice4cost_column_0_5;
      slice4window_entering_0_6 <= slice4cost_column_0_6;
      slice4window_entering_0_7 <= slice4cost_column_0_7;
      slice4window_entering_0_8 <= slice4cost_column_0_8;
      slice4window_entering_0_9 <= slice4cost_column_0_9;
      slice4window_entering_0_10 <= slice4cost_column_0_10;
      slice4window_entering_0_11 <= slice4cost_column_0_11;
      slice4window_entering_0_12 <= slice4cost_column_0_12;
      slice4window_entering_0_13 <= slice4cost_column_0_13;
      slice4window_entering_0_14 <= slice4cost_column_0_14;
      slice4window_entering_0_15 <= slice4cost_column_0_15;
      slice4window_entering_0_16 <= slice4cost_column_0_16;
      slice4window_entering_0_17 <= slice4cost_column_0_17;
      slice4window_entering_0_18 <= slice4cost_column_0_18;
      slice4window_entering_0_19 <= slice4cost_column_0_19;
      slice4window_entering_0_20 <= slice4cost_column_0_20;
      slice4window_change_0_0 <= slice4window_entering_0_0 - slice4window_change_0_0_choice;
      slice4window_change_0_1 <= slice4window_entering_0_1 - slice4window_change_0_1_choice;
      slice4window_change_0_2 <= slice4window_entering_0_2 - slice4window_change_0_2_choice;
      slice4window_change_0_3 <= slice4window_entering_0_3 - slice4window_change_0_3_choice;
      slice4window_change_0_4 <= slice4window_entering_0_4 - slice4window_change_0_4_choice;
      slice4window_change_0_5 <= slice4window_entering_0_5 - slice4window_change_0_5_choice;
      slice4window_change_0_6 <= slice4window_entering_0_6 - slice4window_change_0_6_choice;
      slice4window_change_0_7 <= slice4window_entering_0_7 - slice4window_change_0_7_choice;
      slice4window_change_0_8 <= slice4window_entering_0_8 - slice4window_change_0_8_choice;
      slice4window_change_0_9 <= slice4window_entering_0_9 - slice4window_change_0_9_choice;
      slice4window_change_0_10 <= slice4window_entering_0_10 - slice4window_change_0_10_choice;
      slice4window_change_0_11 <= slice4window_entering_0_11 - slice4window_change_0_11_choice;
      slice4window_change_0_12 <= slice4window_entering_0_12 - slice4window_change_0_12_choice;
      slice4window_change_0_13 <= slice4window_entering_0_13 - slice4window_change_0_13_choice;
      slice4window_change_0_14 <= slice4window_entering_0_14 - slice4window_change_0_14_choice;
      slice4window_change_0_15 <= slice4window_entering_0_15 - slice4window_change_0_15_choice;
      slice4window_change_0_16 <= slice4window_entering_0_16 - slice4window_change_0_16_choice;
      slice4window_change_0_17 <= slice4window_entering_0_17 - slice4window_change_0_17_choice;
      slice4window_change_0_18 <= slice4window_entering_0_18 - slice4window_change_0_18_choice;
      slice4window_change_0_19 <= slice4window_entering_0_19 - slice4window_change_0_19_choice;
      slice4window_change_0_20 <= slice4window_entering_0_20 - slice4window_change_0_20_choice;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_0_choice := 0;
      else
        slice4window_sum_0_0_choice := slice4window_sum_0_0;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_1_choice := 0;
      else
        slice4window_sum_0_1_choice := slice4window_sum_0_1;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_2_choice := 0;
      else
        slice4window_sum_0_2_choice := slice4window_sum_0_2;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_3_choice := 0;
      else
        slice4window_sum_0_3_choice := slice4window_sum_0_3;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_4_choice := 0;
      else
        slice4window_sum_0_4_choice := slice4window_sum_0_4;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_5_choice := 0;
      else
        slice4window_sum_0_5_choice := slice4window_sum_0_5;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_6_choice := 0;
      else
        slice4window_sum_0_6_choice := slice4window_sum_0_6;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_7_choice := 0;
      else
        slice4window_sum_0_7_choice := slice4window_sum_0_7;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_8_choice := 0;
      else
        slice4window_sum_0_8_choice := slice4window_sum_0_8;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_9_choice := 0;
      else
        slice4window_sum_0_9_choice := slice4window_sum_0_9;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_10_choice := 0;
      else
        slice4window_sum_0_10_choice := slice4window_sum_0_10;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_11_choice := 0;
      else
        slice4window_sum_0_11_choice := slice4window_sum_0_11;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_12_choice := 0;
      else
        slice4window_sum_0_12_choice := slice4window_sum_0_12;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_13_choice := 0;
      else
        slice4window_sum_0_13_choice := slice4window_sum_0_13;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_14_choice := 0;
      else
        slice4window_sum_0_14_choice := slice4window_sum_0_14;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_15_choice := 0;
      else
        slice4window_sum_0_15_choice := slice4window_sum_0_15;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_16_choice := 0;
      else
        slice4window_sum_0_16_choice := slice4window_sum_0_16;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_17_choice := 0;
      else
        slice4window_sum_0_17_choice := slice4window_sum_0_17;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_18_choice := 0;
      else
        slice4window_sum_0_18_choice := slice4window_sum_0_18;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_19_choice := 0;
      else
        slice4window_sum_0_19_choice := slice4window_sum_0_19;
      end if;
      if slice3window_centre_first_column_0 then
        slice4window_sum_0_20_choice := 0;
      else
        slice4window_sum_0_20_choice := slice4window_sum_0_20;
      end if;
      if slice0winner3_tag_valid then
        slice4window_sum_0_0 <= (slice4window_sum_0_0_choice + slice4window_change_0_0) mod 16384;
        slice4window_sum_0_1 <= (slice4window_sum_0_1_choice + slice4window_change_0_1) mod 16384;
        slice4window_sum_0_2 <= (slice4window_sum_0_2_choice + slice4window_change_0_2) mod 16384;
        slice4window_sum_0_3 <= (slice4window_sum_0_3_choice + slice4window_change_0_3) mod 16384;
        slice4window_sum_0_4 <= (slice4window_sum_0_4_choice + slice4window_change_0_4) mod 16384;
        slice4window_sum_0_5 <= (slice4window_sum_0_5_choice + slice4window_change_0_5) mod 16384;
        slice4window_sum_0_6 <= (slice4window_sum_0_6_choice + slice4window_change_0_6) mod 16384;
        slice4window_sum_0_7 <= (slice4window_sum_0_7_choice + slice4window_change_0_7) mod 16384;
        slice4window_sum_0_8 <= (slice4window_sum_0_8_choice + slice4window_change_0_8) mod 16384;
        slice4window_sum_0_9 <= (slice4window_sum_0_9_choice + slice4window_change_0_9) mod 16384;
        slice4window_sum_0_10 <= (slice4window_sum_0_10_choice + slice4window_change_0_10) mod 16384;
        slice4window_sum_0_11 <= (slice4window_sum_0_11_choice + slice4window_change_0_11) mod 16384;
        slice4window_sum_0_12 <= (slice4window_sum_0_12_choice + slice4window_change_0_12) mod 16384;
        slice4window_sum_0_13 <= (slice4window_sum_0_13_choice + slice4window_change_0_13) mod 16384;
        slice4window_sum_0_14 <= (slice4window_sum_0_14_choice + slice4window_change_0_14) mod 16384;
        slice4window_sum_0_15 <= (slice4window_sum_0_15_choice + slice4window_change_0_15) mod 16384;
        slice4window_sum_0_16 <= (slice4window_sum_0_16_choice + slice4window_change_0_16) mod 16384;
        slice4window_sum_0_17 <= (slice4window_sum_0_17_choice + slice4window_change_0_17) mod 16384;
        slice4window_sum_0_18 <= (slice4window_sum_0_18_choice + slice4window_change_0_18) mod 16384;
        slice4window_sum_0_19 <= (slice4window_sum_0_19_choice + slice4window_change_0_19) mod 16384;
        slice4window_sum_0_20 <= (slice4window_sum_0_20_choice + slice4window_change_0_20) mod 16384;
        slice4window_centre_output_column_0 <= slice3window_centre_output_column_0;
        slice4window_centre_output_column_1 <= slice4window_centre_output_column_0;
        slice4window_centre_end_of_line_0 <= slice3window_centre_end_of_line_0;
        slice4window_centre_end_of_line_1 <= slice4window_centre_end_of_line_0;
      end if;
      -- slice4winner1
      slice4winner1_best_cost_0_0_is_less := (slice4window_sum_0_1 - slice4window_sum_0_0) < 0;
      slice4winner1_best_cost_0_1_is_less := (slice4window_sum_0_3 - slice4window_sum_0_2) < 0;
      slice4winner1_best_cost_0_2_is_less := (slice4window_sum_0_5 - slice4window_sum_0_4) < 0;
      slice4winner1_best_cost_0_3_is_less := (slice4window_sum_0_7 - slice4window_sum_0_6) < 0;
      slice4winner1_best_cost_0_4_is_less := (slice4window_sum_0_9 - slice4window_sum_0_8) < 0;
      slice4winner1_best_cost_0_5_is_less := (slice4window_sum_0_11 - slice4window_sum_0_10) < 0;
      slice4winner1_best_cost_0_6_is_less := (slice4window_sum_0_13 - slice4window_sum_0_12) < 0;
      slice4winner1_best_cost_0_7_is_less := (slice4window_sum_0_15 - slice4window_sum_0_14) < 0;
      slice4winner1_best_cost_0_8_is_less := (slice4window_sum_0_17 - slice4window_sum_0_16) < 0;
      slice4winner1_best_cost_0_9_is_less := (slice4window_sum_0_19 - slice4window_sum_0_18) < 0;
      slice4winner1_best_cost_0_10 <= slice4window_sum_0_20;
      slice4winner1_best_index_0_0 <= slice4winner1_best_cost_0_0_is_less;
      slice4winner1_best_index_0_10 <= 20;
      if slice4winner1_best_cost_0_0_is_less then
        slice4winner1_best_cost_0_0 <= slice4window_sum_0_1;
      else
        slice4winner1_best_cost_0_0 <= slice4window_sum_0_0;
      end if;
      if slice4winner1_best_cost_0_1_is_less then
        slice4winner1_best_cost_0_1 <= slice4window_sum_0_3;
        slice4winner1_best_index_0_1 <= 3;
      else
        slice4winner1_best_cost_0_1 <= slice4window_sum_0_2;
        slice4winner1_best_index_0_1 <= 2;
      end if;
      if slice4winner1_best_cost_0_2_is_less then
        slice4winner1_best_cost_0_2 <= slice4window_sum_0_5;
        slice4winner1_best_index_0_2 <= 5;
      else
        slice4winner1_best_cost_0_2 <= slice4window_sum_0_4;
        slice4winner1_best_index_0_2 <= 4;
      end if;
      if slice4winner1_best_cost_0_3_is_less then
        slice4winner1_best_cost_0_3 <= slice4window_sum_0_7;
        slice4winner1_best_index_0_3 <= 7;
      else
        slice4winner1_best_cost_0_3 <= slice4window_sum_0_6;
        slice4winner1_best_index_0_3 <= 6;
      end if;
      if slice4winner1_best_cost_0_4_is_less then
        slice4winner1_best_cost_0_4 <= slice4window_sum_0_9;
        slice4winner1_best_index_0_4 <= 9;
      else
        slice4winner1_best_cost_0_4 <= slice4window_sum_0_8;
        slice4winner1_best_index_0_4 <= 8;
      end if;
      if slice4winner1_best_cost_0_5_is_less then
        slice4winner1_best_cost_0_5 <= slice4window_sum_0_11;
        slice4winner1_best_index_0_5 <= 11;
      else
        slice4winner1_best_cost_0_5 <= slice4window_sum_0_10;
        slice4winner1_best_index_0_5 <= 10;
      end if;
      if slice4winner1_best_cost_0_6_is_less then
        slice4winner1_best_cost_0_6 <= slice4window_sum_0_13;
        slice4winner1_best_index_0_6 <= 13;
      else
        slice4winner1_best_cost_0_6 <= slice4window_sum_0_12;
        slice4winner1_best_index_0_6 <= 12;
      end if;
      if slice4winner1_best_cost_0_7_is_less then
        slice4winner1_best_cost_0_7 <= slice4window_sum_0_15;
        slice4winner1_best_index_0_7 <= 15;
      else
        slice4winner1_best_cost_0_7 <= slice4window_sum_0_14;
        slice4winner1_best_index_0_7 <= 14;
      end if;
      if slice4winner1_best_cost_0_8_is_less then
        slice4winner1_best_cost_0_8 <= slice4window_sum_0_17;
        slice4winner1_best_index_0_8 <= 17;
      else
        slice4winner1_best_cost_0_8 <= slice4window_sum_0_16;
        slice4winner1_best_index_0_8 <= 16;
      end if;
      if slice4winner1_best_cost_0_9_is_less then
        slice4winner1_best_cost_0_9 <= slice4window_sum_0_19;
        slice4winner1_best_index_0_9 <= 19;
      else
        slice4winner1_best_cost_0_9 <= slice4window_sum_0_18;
        slice4winner1_best_index_0_9 <= 18;
      end if;
      -- slice4winner2
      slice4winner2_best_cost_0_0_is_less := (slice4winner1_best_cost_0_1 - slice4winner1_best_cost_0_0) < 0;
      slice4winner2_best_cost_0_1_is_less := (slice4winner1_best_cost_0_3 - slice4winner1_best_cost_0_2) < 0;
      slice4winner2_best_cost_0_2_is_less := (slice4winner1_best_cost_0_5 - slice4winner1_best_cost_0_4) < 0;
      slice4winner2_best_cost_0_3_is_less := (slice4winner1_best_cost_0_7 - slice4winner1_best_cost_0_6) < 0;
      slice4winner2_best_cost_0_4_is_less := (slice4winner1_best_cost_0_9 - slice4winner1_best_cost_0_8) < 0;
      slice4winner2_best_cost_0_5 <= slice4winner1_best_cost_0_10;
      slice4winner2_best_index_0_5 <= slice4winner1_best_index_0_10;
      if slice4winner2_best_cost_0_0_is_less then
        slice4winner2_best_cost_0_0 <= slice4winner1_best_cost_0_1;
        slice4winner2_best_index_0_0 <= slice4winner1_best_index_0_1;
      else
        slice4winner2_best_cost_0_0 <= slice4winner1_best_cost_0_0;
        slice4winner2_best_index_0_0 <= as_number(slice4winner1_best_index_0_0);
      end if;
      if slice4winner2_best_cost_0_1_is_less then
        slice4winner2_best_cost_0_1 <= slice4winner1_best_cost_0_3;
        slice4winner2_best_index_0_1 <= slice4winner1_best_index_0_3;
      else
        slice4winner2_best_cost_0_1 <= slice4winner1_best_cost_0_2;
        slice4winner2_best_index_0_1 <= slice4winner1_best_index_0_2;
      end if;
      if slice4winner2_best_cost_0_2_is_less then
        slice4winner2_best_cost_0_2 <= slice4winner1_best_cost_0_5;
        slice4winner2_best_index_0_2 <= slice4winner1_best_index_0_5;
      else
        slice4winner2_best_cost_0_2 <= slice4winner1_best_cost_0_4;
        slice4winner2_best_index_0_2 <= slice4winner1_best_index_0_4;
      end if;
      if slice4winner2_best_cost_0_3_is_less then
        slice4winner2_best_cost_0_3 <= slice4winner1_best_cost_0_7;
        slice4winner2_best_index_0_3 <= slice4winner1_best_index_0_7;
      else
        slice4winner2_best_cost_0_3 <= slice4winner1_best_cost_0_6;
        slice4winner2_best_index_0_3 <= slice4winner1_best_index_0_6;
      end if;
      if slice4winner2_best_cost_0_4_is_less then
        slice4winner2_best_cost_0_4 <= slice4winner1_best_cost_0_9;
        slice4winner2_best_index_0_4 <= slice4winner1_best_index_0_9;
      else
        slice4winner2_best_cost_0_4 <= slice4winner1_best_cost_0_8;
        slice4winner2_best_index_0_4 <= slice4winner1_best_index_0_8;
      end if;
      -- slice4winner3
      slice4winner3_best_cost_0_0_is_less := (slice4winner2_best_cost_0_1 - slice4winner2_best_cost_0_0) < 0;
      slice4winner3_best_cost_0_1_is_less := (slice4winner2_best_cost_0_3 - slice4winner2_best_cost_0_2) < 0;
      slice4winner3_best_cost_0_2_is_less := (slice4winner2_best_cost_0_5 - slice4winner2_best_cost_0_4) < 0;
      if slice4winner3_best_cost_0_0_is_less then
        slice4winner3_best_cost_0_0 <= slice4winner2_best_cost_0_1;
        slice4winner3_best_index_0_0 <= slice4winner2_best_index_0_1;
      else
        slice4winner3_best_cost_0_0 <= slice4winner2_best_cost_0_0;
        slice4winner3_best_index_0_0 <= slice4winner2_best_index_0_0;
      end if;
      if slice4winner3_best_cost_0_1_is_less then
        slice4winner3_best_cost_0_1 <= slice4winner2_best_cost_0_3;
        slice4winner3_best_index_0_1 <= slice4winner2_best_index_0_3;
      else
        slice4winner3_best_cost_0_1 <= slice4winner2_best_cost_0_2;
        slice4winner3_best_index_0_1 <= slice4winner2_best_index_0_2;
      end if;
      if slice4winner3_best_cost_0_2_is_less then
        slice4winner3_best_cost_0_2 <= slice4winner2_best_cost_0_5;
        slice4winner3_best_index_0_2 <= slice4winner2_best_index_0_5;
      else
        slice4winner3_best_cost_0_2 <= slice4winner2_best_cost_0_4;
        slice4winner3_best_index_0_2 <= slice4winner2_best_index_0_4;
      end if;
      -- slice4winner4
      slice4winner4_best_cost_0_0_is_less := (slice4winner3_best_cost_0_1 - slice4winner3_best_cost_0_0) < 0;
      slice4winner4_best_cost_0_1 <= slice4winner3_best_cost_0_2;
      slice4winner4_best_index_0_1 <= slice4winner3_best_index_0_2;
      if slice4winner4_best_cost_0_0_is_less then
        slice4winner4_best_cost_0_0 <= slice4winner3_best_cost_0_1;
        slice4winner4_best_index_0_0 <= slice4winner3_best_index_0_1;
      else
        slice4winner4_best_cost_0_0 <= slice4winner3_best_cost_0_0;
        slice4winner4_best_index_0_0 <= slice4winner3_best_index_0_0;
      end if;
      -- slice4winner5
      slice4winner5_best_cost_0_0_is_less := (slice4winner4_best_cost_0_1 - slice4winner4_best_cost_0_0) < 0;
      if slice4winner5_best_cost_0_0_is_less then
        slice4winner5_best_cost_0_0 <= slice4winner4_best_cost_0_1;
        slice4winner5_best_index_0_0 <= slice4winner4_best_index_0_1;
      else
        slice4winner5_best_cost_0_0 <= slice4winner4_best_cost_0_0;
        slice4winner5_best_index_0_0 <= slice4winner4_best_index_0_0;
      end if;
      -- slice4
      slice4_best_tag_valid <= slice3_best_tag_valid;
      slice4_best_tag_output_column <= slice3_best_tag_output_column;
      slice4_best_tag_start_of_frame <= slice3_best_tag_start_of_frame;
      slice4_best_tag_end_of_line <= slice3_best_tag_end_of_line;
      if (slice3_best_cost_0_0 - slice4winner5_best_cost_0_0) < 0 then
        slice4_best_index_0_0 <= slice3_best_index_0_0;
      else
        slice4_best_index_0_0 <= slice4winner5_best_index_0_0;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 243;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_row_start <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_row_start <= false;
        slice0cost_ready_tag_output_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_row_start <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_output_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_output_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_start_of_frame_2 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_start_of_frame <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_output_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0winner4_tag_valid <= false;
        slice0winner4_tag_output_column <= false;
        slice0winner4_tag_start_of_frame <= false;
        slice0winner4_tag_end_of_line <= false;
        slice0winner5_tag_valid <= false;
        slice0winner5_tag_output_column <= false;
        slice0winner5_tag_start_of_frame <= false;
        slice0winner5_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2cost_read_column <= 0;
        slice2cost_change_column <= 0;
        slice2cost_ready_column <= 0;
        slice2cost_write_column <= 0;
        slice2window_ring_read_address <= 1;
        slice2window_ring_write_address <= 0;
        slice2window_centre_output_column_0 <= false;
        slice2window_centre_end_of_line_0 <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
        slice3cost_read_column <= 0;
        slice3cost_change_column <= 0;
        slice3cost_ready_column <= 0;
        slice3cost_write_column <= 0;
        slice3window_ring_read_address <= 1;
        slice3window_ring_write_address <= 0;
        slice3window_centre_output_column_0 <= false;
        slice3window_centre_end_of_line_0 <= false;
        slice3_best_tag_valid <= false;
        slice3_best_tag_output_column <= false;
        slice3_best_tag_start_of_frame <= false;
        slice3_best_tag_end_of_line <= false;
        slice4cost_read_column <= 0;
        slice4cost_change_column <= 0;
        slice4cost_ready_column <= 0;
        slice4cost_write_column <= 0;
        slice4window_ring_read_address <= 1;
        slice4window_ring_write_address <= 0;
        slice4window_centre_output_column_0 <= false;
        slice4window_centre_output_column_1 <= false;
        slice4window_centre_end_of_line_0 <= false;
        slice4window_centre_end_of_line_1 <= false;
        slice4_best_tag_valid <= false;
        slice4_best_tag_output_column <= false;
        slice4_best_tag_start_of_frame <= false;
        slice4_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
