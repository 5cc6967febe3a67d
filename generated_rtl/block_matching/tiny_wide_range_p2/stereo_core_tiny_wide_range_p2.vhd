-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_wide_range_p2: 32x12, 28 disparities, window 3x3, 2 pixel pairs a clock.
-- Options: disparities 28.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_wide_range_p2
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_wide_range_p2 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 28;
    pixels_per_clock : positive := 2;
    disparity_bits : positive := 8;
    output_width_px : positive := 4;
    latency_clocks : positive := 17;
    flush_groups : positive := 32;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(15 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(15 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(1 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 32 report "stereo_core_tiny_wide_range_p2: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_wide_range_p2: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 28 report "stereo_core_tiny_wide_range_p2: disparities is " & integer'image(disparities) & " but this core has 28" severity failure;
  assert pixels_per_clock = 2 report "stereo_core_tiny_wide_range_p2: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 2" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_wide_range_p2: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 4 report "stereo_core_tiny_wide_range_p2: output_width_px is " & integer'image(output_width_px) & " but this core has 4" severity failure;
  assert latency_clocks = 17 report "stereo_core_tiny_wide_range_p2: latency_clocks is " & integer'image(latency_clocks) & " but this core has 17" severity failure;
  assert flush_groups = 32 report "stereo_core_tiny_wide_range_p2: flush_groups is " & integer'image(flush_groups) & " but this core has 32" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_wide_range_p2: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_wide_range_p2 is
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

  signal in_valid : boolean;
  signal in_start_of_frame : boolean;
  signal in_left_pixel : natural range 0 to 65535;
  signal in_right_pixel : natural range 0 to 65535;
  -- raster
  signal raster_features_search_0, raster_features_search_1 : natural range 0 to 255;
  signal raster_features_reference : natural range 0 to 65535;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 31;
  signal raster_place_group : natural range 0 to 7;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address, delay_column : natural range 0 to 31;
  signal delay_ahead_0, delay_ahead_1 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(15 downto 0);
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_3, delay_tag_valid, delay_tag_border_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_read_newest_1 : natural range 0 to 255;
  signal rows_search_rows_ready_newest_0, rows_search_rows_ready_newest_1 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_read_newest_1 : natural range 0 to 255;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_ready_newest_1, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_search_3, rows_reference_0, rows_reference_1 : natural range 0 to 255;
  signal rows_reference_2, rows_reference_3 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_3, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_3 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
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
  signal slice0shift_search_1_23, slice0shift_search_1_24, slice0shift_search_2_0 : natural range 0 to 255;
  signal slice0shift_search_2_1, slice0shift_search_2_2, slice0shift_search_2_3 : natural range 0 to 255;
  signal slice0shift_search_2_4, slice0shift_search_2_5, slice0shift_search_2_6 : natural range 0 to 255;
  signal slice0shift_search_2_7, slice0shift_search_2_8, slice0shift_search_2_9 : natural range 0 to 255;
  signal slice0shift_search_2_10, slice0shift_search_2_11, slice0shift_search_2_12 : natural range 0 to 255;
  signal slice0shift_search_2_13, slice0shift_search_2_14, slice0shift_search_2_15 : natural range 0 to 255;
  signal slice0shift_search_2_16, slice0shift_search_2_17, slice0shift_search_2_18 : natural range 0 to 255;
  signal slice0shift_search_2_19, slice0shift_search_2_20, slice0shift_search_2_21 : natural range 0 to 255;
  signal slice0shift_search_2_22, slice0shift_search_2_23, slice0shift_search_2_24 : natural range 0 to 255;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 255;
  signal slice0shift_search_3_3, slice0shift_search_3_4, slice0shift_search_3_5 : natural range 0 to 255;
  signal slice0shift_search_3_6, slice0shift_search_3_7, slice0shift_search_3_8 : natural range 0 to 255;
  signal slice0shift_search_3_9, slice0shift_search_3_10, slice0shift_search_3_11 : natural range 0 to 255;
  signal slice0shift_search_3_12, slice0shift_search_3_13, slice0shift_search_3_14 : natural range 0 to 255;
  signal slice0shift_search_3_15, slice0shift_search_3_16, slice0shift_search_3_17 : natural range 0 to 255;
  signal slice0shift_search_3_18, slice0shift_search_3_19, slice0shift_search_3_20 : natural range 0 to 255;
  signal slice0shift_search_3_21, slice0shift_search_3_22, slice0shift_search_3_23 : natural range 0 to 255;
  signal slice0shift_search_3_24, slice0shift_reference_0, slice0shift_reference_1 : natural range 0 to 255;
  signal slice0shift_reference_2, slice0shift_reference_3, slice0shift_search_out_0 : natural range 0 to 255;
  signal slice0shift_search_out_1, slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_0_3, slice0cost_difference_0_4, slice0cost_difference_0_5 : integer range -255 to 255;
  signal slice0cost_difference_0_6, slice0cost_difference_0_7, slice0cost_difference_0_8 : integer range -255 to 255;
  signal slice0cost_difference_0_9, slice0cost_difference_0_10, slice0cost_difference_0_11 : integer range -255 to 255;
  signal slice0cost_difference_0_12, slice0cost_difference_0_13, slice0cost_difference_0_14 : integer range -255 to 255;
  signal slice0cost_difference_0_15, slice0cost_difference_0_16, slice0cost_difference_0_17 : integer range -255 to 255;
  signal slice0cost_difference_0_18, slice0cost_difference_0_19, slice0cost_difference_0_20 : integer range -255 to 255;
  signal slice0cost_difference_0_21, slice0cost_difference_0_22, slice0cost_difference_0_23 : integer range -255 to 255;
  signal slice0cost_difference_0_24, slice0cost_difference_1_0, slice0cost_difference_1_1 : integer range -255 to 255;
  signal slice0cost_difference_1_2, slice0cost_difference_1_3, slice0cost_difference_1_4 : integer range -255 to 255;
  signal slice0cost_difference_1_5, slice0cost_difference_1_6, slice0cost_difference_1_7 : integer range -255 to 255;
  signal slice0cost_difference_1_8, slice0cost_difference_1_9, slice0cost_difference_1_10 : integer range -255 to 255;
  signal slice0cost_difference_1_11, slice0cost_difference_1_12, slice0cost_difference_1_13 : integer range -255 to 255;
  signal slice0cost_difference_1_14, slice0cost_difference_1_15, slice0cost_difference_1_16 : integer range -255 to 255;
  signal slice0cost_difference_1_17, slice0cost_difference_1_18, slice0cost_difference_1_19 : integer range -255 to 255;
  signal slice0cost_difference_1_20, slice0cost_difference_1_21, slice0cost_difference_1_22 : integer range -255 to 255;
  signal slice0cost_difference_1_23, slice0cost_difference_1_24, slice0cost_difference_2_0 : integer range -255 to 255;
  signal slice0cost_difference_2_1, slice0cost_difference_2_2, slice0cost_difference_2_3 : integer range -255 to 255;
  signal slice0cost_difference_2_4, slice0cost_difference_2_5, slice0cost_difference_2_6 : integer range -255 to 255;
  signal slice0cost_difference_2_7, slice0cost_difference_2_8, slice0cost_difference_2_9 : integer range -255 to 255;
  signal slice0cost_difference_2_10, slice0cost_difference_2_11, slice0cost_difference_2_12 : integer range -255 to 255;
  signal slice0cost_difference_2_13, slice0cost_difference_2_14, slice0cost_difference_2_15 : integer range -255 to 255;
  signal slice0cost_difference_2_16, slice0cost_difference_2_17, slice0cost_difference_2_18 : integer range -255 to 255;
  signal slice0cost_difference_2_19, slice0cost_difference_2_20, slice0cost_difference_2_21 : integer range -255 to 255;
  signal slice0cost_difference_2_22, slice0cost_difference_2_23, slice0cost_difference_2_24 : integer range -255 to 255;
  signal slice0cost_difference_3_0, slice0cost_difference_3_1, slice0cost_difference_3_2 : integer range -255 to 255;
  signal slice0cost_difference_3_3, slice0cost_difference_3_4, slice0cost_difference_3_5 : integer range -255 to 255;
  signal slice0cost_difference_3_6, slice0cost_difference_3_7, slice0cost_difference_3_8 : integer range -255 to 255;
  signal slice0cost_difference_3_9, slice0cost_difference_3_10, slice0cost_difference_3_11 : integer range -255 to 255;
  signal slice0cost_difference_3_12, slice0cost_difference_3_13, slice0cost_difference_3_14 : integer range -255 to 255;
  signal slice0cost_difference_3_15, slice0cost_difference_3_16, slice0cost_difference_3_17 : integer range -255 to 255;
  signal slice0cost_difference_3_18, slice0cost_difference_3_19, slice0cost_difference_3_20 : integer range -255 to 255;
  signal slice0cost_difference_3_21, slice0cost_difference_3_22, slice0cost_difference_3_23 : integer range -255 to 255;
  signal slice0cost_difference_3_24 : integer range -255 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_negative_0_3, slice0cost_negative_0_4, slice0cost_negative_0_5 : boolean;
  signal slice0cost_negative_0_6, slice0cost_negative_0_7, slice0cost_negative_0_8, slice0cost_negative_0_9 : boolean;
  signal slice0cost_negative_0_10, slice0cost_negative_0_11, slice0cost_negative_0_12 : boolean;
  signal slice0cost_negative_0_13, slice0cost_negative_0_14, slice0cost_negative_0_15 : boolean;
  signal slice0cost_negative_0_16, slice0cost_negative_0_17, slice0cost_negative_0_18 : boolean;
  signal slice0cost_negative_0_19, slice0cost_negative_0_20, slice0cost_negative_0_21 : boolean;
  signal slice0cost_negative_0_22, slice0cost_negative_0_23, slice0cost_negative_0_24 : boolean;
  signal slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column, slice0cost_pair_tag_output_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_border_column, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 511;
  signal slice0cost_pair_0_4, slice0cost_pair_0_5, slice0cost_pair_0_6, slice0cost_pair_0_7 : natural range 0 to 511;
  signal slice0cost_pair_0_8, slice0cost_pair_0_9, slice0cost_pair_0_10, slice0cost_pair_0_11 : natural range 0 to 511;
  signal slice0cost_pair_0_12, slice0cost_pair_0_13, slice0cost_pair_0_14 : natural range 0 to 511;
  signal slice0cost_pair_0_15, slice0cost_pair_0_16, slice0cost_pair_0_17 : natural range 0 to 511;
  signal slice0cost_pair_0_18, slice0cost_pair_0_19, slice0cost_pair_0_20 : natural range 0 to 511;
  signal slice0cost_pair_0_21, slice0cost_pair_0_22, slice0cost_pair_0_23 : natural range 0 to 511;
  signal slice0cost_pair_0_24 : natural range 0 to 511;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_single_0_3, slice0cost_single_0_4, slice0cost_single_0_5 : natural range 0 to 255;
  signal slice0cost_single_0_6, slice0cost_single_0_7, slice0cost_single_0_8 : natural range 0 to 255;
  signal slice0cost_single_0_9, slice0cost_single_0_10, slice0cost_single_0_11 : natural range 0 to 255;
  signal slice0cost_single_0_12, slice0cost_single_0_13, slice0cost_single_0_14 : natural range 0 to 255;
  signal slice0cost_single_0_15, slice0cost_single_0_16, slice0cost_single_0_17 : natural range 0 to 255;
  signal slice0cost_single_0_18, slice0cost_single_0_19, slice0cost_single_0_20 : natural range 0 to 255;
  signal slice0cost_single_0_21, slice0cost_single_0_22, slice0cost_single_0_23 : natural range 0 to 255;
  signal slice0cost_single_0_24, slice0cost_single_3_0, slice0cost_single_3_1 : natural range 0 to 255;
  signal slice0cost_single_3_2, slice0cost_single_3_3, slice0cost_single_3_4 : natural range 0 to 255;
  signal slice0cost_single_3_5, slice0cost_single_3_6, slice0cost_single_3_7 : natural range 0 to 255;
  signal slice0cost_single_3_8, slice0cost_single_3_9, slice0cost_single_3_10 : natural range 0 to 255;
  signal slice0cost_single_3_11, slice0cost_single_3_12, slice0cost_single_3_13 : natural range 0 to 255;
  signal slice0cost_single_3_14, slice0cost_single_3_15, slice0cost_single_3_16 : natural range 0 to 255;
  signal slice0cost_single_3_17, slice0cost_single_3_18, slice0cost_single_3_19 : natural range 0 to 255;
  signal slice0cost_single_3_20, slice0cost_single_3_21, slice0cost_single_3_22 : natural range 0 to 255;
  signal slice0cost_single_3_23, slice0cost_single_3_24 : natural range 0 to 255;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 767;
  signal slice0cost_column_0_6, slice0cost_column_0_7, slice0cost_column_0_8 : natural range 0 to 767;
  signal slice0cost_column_0_9, slice0cost_column_0_10, slice0cost_column_0_11 : natural range 0 to 767;
  signal slice0cost_column_0_12, slice0cost_column_0_13, slice0cost_column_0_14 : natural range 0 to 767;
  signal slice0cost_column_0_15, slice0cost_column_0_16, slice0cost_column_0_17 : natural range 0 to 767;
  signal slice0cost_column_0_18, slice0cost_column_0_19, slice0cost_column_0_20 : natural range 0 to 767;
  signal slice0cost_column_0_21, slice0cost_column_0_22, slice0cost_column_0_23 : natural range 0 to 767;
  signal slice0cost_column_0_24, slice0cost_column_1_0, slice0cost_column_1_1 : natural range 0 to 767;
  signal slice0cost_column_1_2, slice0cost_column_1_3, slice0cost_column_1_4 : natural range 0 to 767;
  signal slice0cost_column_1_5, slice0cost_column_1_6, slice0cost_column_1_7 : natural range 0 to 767;
  signal slice0cost_column_1_8, slice0cost_column_1_9, slice0cost_column_1_10 : natural range 0 to 767;
  signal slice0cost_column_1_11, slice0cost_column_1_12, slice0cost_column_1_13 : natural range 0 to 767;
  signal slice0cost_column_1_14, slice0cost_column_1_15, slice0cost_column_1_16 : natural range 0 to 767;
  signal slice0cost_column_1_17, slice0cost_column_1_18, slice0cost_column_1_19 : natural range 0 to 767;
  signal slice0cost_column_1_20, slice0cost_column_1_21, slice0cost_column_1_22 : natural range 0 to 767;
  signal slice0cost_column_1_23, slice0cost_column_1_24 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4, slice0window_partial_0_0_5 : natural range 0 to 767;
  signal slice0window_partial_0_0_6, slice0window_partial_0_0_7, slice0window_partial_0_0_8 : natural range 0 to 767;
  signal slice0window_partial_0_0_9, slice0window_partial_0_0_10, slice0window_partial_0_0_11 : natural range 0 to 767;
  signal slice0window_partial_0_0_12, slice0window_partial_0_0_13, slice0window_partial_0_0_14 : natural range 0 to 767;
  signal slice0window_partial_0_0_15, slice0window_partial_0_0_16, slice0window_partial_0_0_17 : natural range 0 to 767;
  signal slice0window_partial_0_0_18, slice0window_partial_0_0_19, slice0window_partial_0_0_20 : natural range 0 to 767;
  signal slice0window_partial_0_0_21, slice0window_partial_0_0_22, slice0window_partial_0_0_23 : natural range 0 to 767;
  signal slice0window_partial_0_0_24, slice0window_partial_1_0_0, slice0window_partial_1_0_1 : natural range 0 to 767;
  signal slice0window_partial_1_0_2, slice0window_partial_1_0_3, slice0window_partial_1_0_4 : natural range 0 to 767;
  signal slice0window_partial_1_0_5, slice0window_partial_1_0_6, slice0window_partial_1_0_7 : natural range 0 to 767;
  signal slice0window_partial_1_0_8, slice0window_partial_1_0_9, slice0window_partial_1_0_10 : natural range 0 to 767;
  signal slice0window_partial_1_0_11, slice0window_partial_1_0_12, slice0window_partial_1_0_13 : natural range 0 to 767;
  signal slice0window_partial_1_0_14, slice0window_partial_1_0_15, slice0window_partial_1_0_16 : natural range 0 to 767;
  signal slice0window_partial_1_0_17, slice0window_partial_1_0_18, slice0window_partial_1_0_19 : natural range 0 to 767;
  signal slice0window_partial_1_0_20, slice0window_partial_1_0_21, slice0window_partial_1_0_22 : natural range 0 to 767;
  signal slice0window_partial_1_0_23, slice0window_partial_1_0_24 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4, slice0window_partial_0_1_5 : natural range 0 to 1534;
  signal slice0window_partial_0_1_6, slice0window_partial_0_1_7, slice0window_partial_0_1_8 : natural range 0 to 1534;
  signal slice0window_partial_0_1_9, slice0window_partial_0_1_10, slice0window_partial_0_1_11 : natural range 0 to 1534;
  signal slice0window_partial_0_1_12, slice0window_partial_0_1_13 : natural range 0 to 1534;
  signal slice0window_partial_0_1_14, slice0window_partial_0_1_15 : natural range 0 to 1534;
  signal slice0window_partial_0_1_16, slice0window_partial_0_1_17 : natural range 0 to 1534;
  signal slice0window_partial_0_1_18, slice0window_partial_0_1_19 : natural range 0 to 1534;
  signal slice0window_partial_0_1_20, slice0window_partial_0_1_21 : natural range 0 to 1534;
  signal slice0window_partial_0_1_22, slice0window_partial_0_1_23 : natural range 0 to 1534;
  signal slice0window_partial_0_1_24, slice0window_partial_1_1_0, slice0window_partial_1_1_1 : natural range 0 to 1534;
  signal slice0window_partial_1_1_2, slice0window_partial_1_1_3, slice0window_partial_1_1_4 : natural range 0 to 1534;
  signal slice0window_partial_1_1_5, slice0window_partial_1_1_6, slice0window_partial_1_1_7 : natural range 0 to 1534;
  signal slice0window_partial_1_1_8, slice0window_partial_1_1_9, slice0window_partial_1_1_10 : natural range 0 to 1534;
  signal slice0window_partial_1_1_11, slice0window_partial_1_1_12 : natural range 0 to 1534;
  signal slice0window_partial_1_1_13, slice0window_partial_1_1_14 : natural range 0 to 1534;
  signal slice0window_partial_1_1_15, slice0window_partial_1_1_16 : natural range 0 to 1534;
  signal slice0window_partial_1_1_17, slice0window_partial_1_1_18 : natural range 0 to 1534;
  signal slice0window_partial_1_1_19, slice0window_partial_1_1_20 : natural range 0 to 1534;
  signal slice0window_partial_1_1_21, slice0window_partial_1_1_22 : natural range 0 to 1534;
  signal slice0window_partial_1_1_23, slice0window_partial_1_1_24 : natural range 0 to 1534;
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 2301;
  signal slice0window_sum_0_6, slice0window_sum_0_7, slice0window_sum_0_8 : natural range 0 to 2301;
  signal slice0window_sum_0_9, slice0window_sum_0_10, slice0window_sum_0_11 : natural range 0 to 2301;
  signal slice0window_sum_0_12, slice0window_sum_0_13, slice0window_sum_0_14 : natural range 0 to 2301;
  signal slice0window_sum_0_15, slice0window_sum_0_16, slice0window_sum_0_17 : natural range 0 to 2301;
  signal slice0window_sum_0_18, slice0window_sum_0_19, slice0window_sum_0_20 : natural range 0 to 2301;
  signal slice0window_sum_0_21, slice0window_sum_0_22, slice0window_sum_0_23 : natural range 0 to 2301;
  signal slice0window_sum_0_24, slice0window_sum_1_0, slice0window_sum_1_1 : natural range 0 to 2301;
  signal slice0window_sum_1_2, slice0window_sum_1_3, slice0window_sum_1_4 : natural range 0 to 2301;
  signal slice0window_sum_1_5, slice0window_sum_1_6, slice0window_sum_1_7 : natural range 0 to 2301;
  signal slice0window_sum_1_8, slice0window_sum_1_9, slice0window_sum_1_10 : natural range 0 to 2301;
  signal slice0window_sum_1_11, slice0window_sum_1_12, slice0window_sum_1_13 : natural range 0 to 2301;
  signal slice0window_sum_1_14, slice0window_sum_1_15, slice0window_sum_1_16 : natural range 0 to 2301;
  signal slice0window_sum_1_17, slice0window_sum_1_18, slice0window_sum_1_19 : natural range 0 to 2301;
  signal slice0window_sum_1_20, slice0window_sum_1_21, slice0window_sum_1_22 : natural range 0 to 2301;
  signal slice0window_sum_1_23, slice0window_sum_1_24 : natural range 0 to 2301;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_4, slice0winner1_best_cost_0_5 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_6, slice0winner1_best_cost_0_7 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_8, slice0winner1_best_cost_0_9 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_10, slice0winner1_best_cost_0_11 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_12, slice0winner1_best_cost_1_0 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_1, slice0winner1_best_cost_1_2 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_3, slice0winner1_best_cost_1_4 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_5, slice0winner1_best_cost_1_6 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_7, slice0winner1_best_cost_1_8 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_9, slice0winner1_best_cost_1_10 : natural range 0 to 2301;
  signal slice0winner1_best_cost_1_11, slice0winner1_best_cost_1_12 : natural range 0 to 2301;
  signal slice0winner1_best_index_0_0, slice0winner1_best_index_1_0, slice0winner1_tag_valid : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1, slice0winner1_best_index_1_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2, slice0winner1_best_index_1_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3, slice0winner1_best_index_1_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4, slice0winner1_best_index_1_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5, slice0winner1_best_index_1_5 : natural range 0 to 11;
  signal slice0winner1_best_index_0_6, slice0winner1_best_index_1_6 : natural range 0 to 13;
  signal slice0winner1_best_index_0_7, slice0winner1_best_index_1_7 : natural range 0 to 15;
  signal slice0winner1_best_index_0_8, slice0winner1_best_index_1_8 : natural range 0 to 17;
  signal slice0winner1_best_index_0_9, slice0winner1_best_index_1_9 : natural range 0 to 19;
  signal slice0winner1_best_index_0_10, slice0winner1_best_index_1_10 : natural range 0 to 21;
  signal slice0winner1_best_index_0_11, slice0winner1_best_index_1_11 : natural range 0 to 23;
  signal slice0winner1_best_index_0_12 : natural range 0 to 24;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 2301;
  signal slice0winner2_best_cost_0_2, slice0winner2_best_cost_0_3 : natural range 0 to 2301;
  signal slice0winner2_best_cost_0_4, slice0winner2_best_cost_0_5 : natural range 0 to 2301;
  signal slice0winner2_best_cost_0_6, slice0winner2_best_cost_1_0 : natural range 0 to 2301;
  signal slice0winner2_best_cost_1_1, slice0winner2_best_cost_1_2 : natural range 0 to 2301;
  signal slice0winner2_best_cost_1_3, slice0winner2_best_cost_1_4 : natural range 0 to 2301;
  signal slice0winner2_best_cost_1_5, slice0winner2_best_cost_1_6 : natural range 0 to 2301;
  signal slice0winner2_best_index_0_0, slice0winner2_best_index_1_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1, slice0winner2_best_index_1_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2, slice0winner2_best_index_1_2 : natural range 0 to 11;
  signal slice0winner2_best_index_0_3, slice0winner2_best_index_1_3 : natural range 0 to 15;
  signal slice0winner2_best_index_0_4, slice0winner2_best_index_1_4 : natural range 0 to 19;
  signal slice0winner2_best_index_0_5, slice0winner2_best_index_1_5 : natural range 0 to 23;
  signal slice0winner2_best_index_0_6 : natural range 0 to 24;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_cost_0_1 : natural range 0 to 2301;
  signal slice0winner3_best_cost_0_2, slice0winner3_best_cost_0_3 : natural range 0 to 2301;
  signal slice0winner3_best_cost_1_0, slice0winner3_best_cost_1_1 : natural range 0 to 2301;
  signal slice0winner3_best_cost_1_2, slice0winner3_best_cost_1_3 : natural range 0 to 2301;
  signal slice0winner3_best_index_0_0, slice0winner3_best_index_1_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1, slice0winner3_best_index_1_1 : natural range 0 to 15;
  signal slice0winner3_best_index_0_2, slice0winner3_best_index_1_2 : natural range 0 to 23;
  signal slice0winner3_best_index_0_3 : natural range 0 to 24;
  signal slice0winner3_tag_valid, slice0winner3_tag_output_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_cost_0_1 : natural range 0 to 2301;
  signal slice0winner4_best_cost_1_0, slice0winner4_best_cost_1_1 : natural range 0 to 2301;
  signal slice0winner4_best_index_0_0, slice0winner4_best_index_1_0 : natural range 0 to 15;
  signal slice0winner4_best_index_0_1, slice0winner4_best_index_1_1 : natural range 0 to 24;
  signal slice0winner4_tag_valid, slice0winner4_tag_output_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0, slice0winner5_best_cost_1_0 : natural range 0 to 2301;
  signal slice0winner5_best_index_0_0, slice0winner5_best_index_1_0 : natural range 0 to 24;
  signal slice0winner5_tag_valid, slice0winner5_tag_output_column, slice0winner5_tag_start_of_frame : boolean;
  signal slice0winner5_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_cost_1_0 : natural range 0 to 2301;
  signal slice0_best_index_0_0, slice0_best_index_1_0 : natural range 0 to 27;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 255;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 255;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 255;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 255;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 255;
  signal slice1shift_reference_3 : natural range 0 to 255;
  -- slice1cost
  signal slice1cost_difference_0_0, slice1cost_difference_0_1, slice1cost_difference_0_2 : integer range -255 to 255;
  signal slice1cost_difference_1_0, slice1cost_difference_1_1, slice1cost_difference_1_2 : integer range -255 to 255;
  signal slice1cost_difference_2_0, slice1cost_difference_2_1, slice1cost_difference_2_2 : integer range -255 to 255;
  signal slice1cost_difference_3_0, slice1cost_difference_3_1, slice1cost_difference_3_2 : integer range -255 to 255;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2 : natural range 0 to 511;
  signal slice1cost_negative_0_0, slice1cost_negative_0_1, slice1cost_negative_0_2 : boolean;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 255;
  signal slice1cost_single_3_0, slice1cost_single_3_1, slice1cost_single_3_2 : natural range 0 to 255;
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
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 2301;
  signal slice1winner1_best_cost_1_0, slice1winner1_best_cost_1_1 : natural range 0 to 2301;
  signal slice1winner1_best_index_0_0, slice1winner1_best_index_1_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 2;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_1_0 : natural range 0 to 2301;
  signal slice1winner2_best_index_0_0, slice1winner2_best_index_1_0 : natural range 0 to 2;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_cost_1_0 : natural range 0 to 2301;
  signal slice1winner3_best_index_0_0, slice1winner3_best_index_1_0 : natural range 0 to 2;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_cost_1_0 : natural range 0 to 2301;
  signal slice1winner4_best_index_0_0, slice1winner4_best_index_1_0 : natural range 0 to 2;
  -- slice1winner5
  signal slice1winner5_best_cost_0_0, slice1winner5_best_cost_1_0 : natural range 0 to 2301;
  signal slice1winner5_best_index_0_0, slice1winner5_best_index_1_0 : natural range 0 to 2;
  -- slice1
  signal slice1_best_index_0_0, slice1_best_index_1_0 : natural range 0 to 27;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(4 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(4 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(4 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(15 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice1_best_index_1_0, 8) & to_unsigned(slice1_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(3, 2));
  disparity_valid <= as_bit(slice1_best_tag_valid and slice1_best_tag_output_column);
  disparity_start_of_frame <= as_bit(slice1_best_tag_start_of_frame and slice1_best_tag_valid and slice1_best_tag_output_column);
  disparity_end_of_line <= as_bit(slice1_best_tag_end_of_line and slice1_best_tag_valid and slice1_best_tag_output_column);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 5);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 5);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 32, width => 24, address_bits => 5)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 5);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 5);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference, 16);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 28, width => 16, address_bits => 5)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  process (clock)
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_next_frame_choice, raster_place_next_frame_choice_2, delay_row_inside_0_value : boolean;
    variable delay_row_inside_0_any, delay_row_inside_1_any, delay_row_inside_1_choice : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_0_1_is_less : boolean;
    variable slice0winner1_best_cost_0_2_is_less, slice0winner1_best_cost_0_3_is_less : boolean;
    variable slice0winner1_best_cost_0_4_is_less, slice0winner1_best_cost_0_5_is_less : boolean;
    variable slice0winner1_best_cost_0_6_is_less, slice0winner1_best_cost_0_7_is_less : boolean;
    variable slice0winner1_best_cost_0_8_is_less, slice0winner1_best_cost_0_9_is_less : boolean;
    variable slice0winner1_best_cost_0_10_is_less, slice0winner1_best_cost_0_11_is_less : boolean;
    variable slice0winner1_best_cost_1_0_is_less, slice0winner1_best_cost_1_1_is_less : boolean;
    variable slice0winner1_best_cost_1_2_is_less, slice0winner1_best_cost_1_3_is_less : boolean;
    variable slice0winner1_best_cost_1_4_is_less, slice0winner1_best_cost_1_5_is_less : boolean;
    variable slice0winner1_best_cost_1_6_is_less, slice0winner1_best_cost_1_7_is_less : boolean;
    variable slice0winner1_best_cost_1_8_is_less, slice0winner1_best_cost_1_9_is_less : boolean;
    variable slice0winner1_best_cost_1_10_is_less, slice0winner1_best_cost_1_11_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_cost_0_1_is_less : boolean;
    variable slice0winner2_best_cost_0_2_is_less, slice0winner2_best_cost_0_3_is_less : boolean;
    variable slice0winner2_best_cost_0_4_is_less, slice0winner2_best_cost_0_5_is_less : boolean;
    variable slice0winner2_best_cost_1_0_is_less, slice0winner2_best_cost_1_1_is_less : boolean;
    variable slice0winner2_best_cost_1_2_is_less, slice0winner2_best_cost_1_3_is_less : boolean;
    variable slice0winner2_best_cost_1_4_is_less, slice0winner2_best_cost_1_5_is_less : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner3_best_cost_0_1_is_less : boolean;
    variable slice0winner3_best_cost_0_2_is_less, slice0winner3_best_cost_1_0_is_less : boolean;
    variable slice0winner3_best_cost_1_1_is_less, slice0winner3_best_cost_1_2_is_less : boolean;
    variable slice0winner4_best_cost_0_0_is_less, slice0winner4_best_cost_0_1_is_less : boolean;
    variable slice0winner4_best_cost_1_0_is_less, slice0winner4_best_cost_1_1_is_less : boolean;
    variable slice0winner5_best_cost_0_0_is_less, slice0winner5_best_cost_1_0_is_less : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner1_best_cost_1_0_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner2_best_cost_1_0_is_less : boolean;
    variable raster_place_group_choice : natural range 0 to 3;
    variable raster_place_group_choice_2, raster_place_group_choice_3 : natural range 0 to 7;
  begin
    if rising_edge(clock) then
      -- raster
      raster_place_group_is_equal := raster_place_column = 31;
      raster_place_group_is_equal_2 := raster_place_group = 5;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 3;
      else
        raster_place_group_choice := 0;
      end if;
      if raster_place_next_frame and (raster_place_group = 6) then
        raster_place_group_choice_2 := 1;
      else
        raster_place_group_choice_2 := (raster_place_group + 1) mod 8;
      end if;
      if raster_place_group_is_equal and (raster_place_group /= 7) and in_valid then
        raster_place_group_choice_3 := raster_place_group_choice_2;
      else
        raster_place_group_choice_3 := raster_place_group;
      end if;
      raster_features_search_0 <= in_left_pixel mod 256;
      raster_features_search_1 <= in_left_pixel / 256;
      raster_features_reference <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_valid and in_start_of_frame then
        raster_place_group <= raster_place_group_choice * 2;
      else
        raster_place_group <= raster_place_group_choice_3;
      end if;
      if (raster_place_group / 2) = 3 then
        raster_place_next_frame_choice := raster_place_next_frame and ((raster_place_group mod 2) = 1);
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_is_equal then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if in_valid then
        if raster_place_group_is_equal or in_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 32;
        end if;
        if raster_place_next_frame_choice_2 then
          raster_place_next_frame <= raster_place_group_all or (not in_start_of_frame);
        else
          raster_place_next_frame <= raster_place_group_is_equal and raster_place_group_is_equal_2 and
            in_start_of_frame;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 27 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 32;
        end if;
      end if;
      delay_row_inside_0_value := ((raster_place_group / 2) mod 2) = 1;
      delay_row_inside_0_any := ((raster_place_group / 4) = 1) or delay_row_inside_0_value;
      delay_row_inside_1_any := (not ((raster_place_group / 4) = 1)) or (not delay_row_inside_0_value);
      if (raster_place_group mod 2) = 1 then
        delay_row_inside_1_choice := delay_row_inside_1_any;
      else
        delay_row_inside_1_choice := delay_row_inside_0_any;
      end if;
      delay_ahead_0 <= raster_features_search_0;
      delay_ahead_1 <= raster_features_search_1;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= delay_row_inside_0_any;
      delay_row_inside_1 <= delay_row_inside_1_choice;
      delay_row_inside_3 <= delay_row_inside_1_any;
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= (not (((raster_place_column / 16) = 1) and ((((raster_place_column / 4) mod 2) = 1) or
        ((raster_place_column mod 4) = 3)))) or (not (((raster_place_column / 8) mod 2) = 1));
      delay_tag_output_column <= (raster_place_column >= 27) and (raster_place_column < 31) and
        delay_row_inside_1_choice;
      delay_tag_start_of_frame <= (raster_place_column = 27) and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 30;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_read_newest_1 <= delay_ahead_1;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_search_rows_ready_newest_1 <= rows_search_rows_read_newest_1;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0(7 downto 0));
      rows_reference_rows_read_newest_1 <= to_integer(delay_delayed_0(15 downto 8));
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_reference_rows_ready_newest_1 <= rows_reference_rows_read_newest_1;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_3 <= delay_row_inside_3;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_border_column <= delay_tag_border_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_border_column <= rows_read_tag_border_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_border_column <= rows_ready_tag_border_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
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
        rows_search_1 <= (rows_search_rows_ready_words_0 / 256) mod 256;
        rows_search_2 <= rows_search_rows_ready_words_0 / 65536;
        rows_reference_1 <= (rows_reference_rows_ready_words_0 / 256) mod 256;
        rows_reference_2 <= rows_reference_rows_ready_words_0 / 65536;
      else
        rows_search_1 <= 0;
        rows_search_2 <= 0;
        rows_reference_1 <= 0;
        rows_reference_2 <= 0;
      end if;
      if rows_ready_inside_3 then
        rows_search_3 <= rows_search_rows_ready_newest_0;
        rows_reference_3 <= rows_reference_rows_ready_newest_0;
      else
        rows_search_3 <= 0;
        rows_reference_3 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 65536) + (rows_search_rows_ready_newest_0 *
          256) + (rows_search_rows_ready_newest_1 * 65536);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 65536) +
          (rows_reference_rows_ready_newest_0 * 256) + (rows_reference_rows_ready_newest_1 * 65536);
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
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= slice0shift_search_2_3;
        slice0shift_search_2_3 <= slice0shift_search_2_4;
        slice0shift_search_2_4 <= slice0shift_search_2_5;
        slice0shift_search_2_5 <= slice0shift_search_2_6;
        slice0shift_search_2_6 <= slice0shift_search_2_7;
        slice0shift_search_2_7 <= slice0shift_search_2_8;
        slice0shift_search_2_8 <= slice0shift_search_2_9;
        slice0shift_search_2_9 <= slice0shift_search_2_10;
        slice0shift_search_2_10 <= slice0shift_search_2_11;
        slice0shift_search_2_11 <= slice0shift_search_2_12;
        slice0shift_search_2_12 <= slice0shift_search_2_13;
        slice0shift_search_2_13 <= slice0shift_search_2_14;
        slice0shift_search_2_14 <= slice0shift_search_2_15;
        slice0shift_search_2_15 <= slice0shift_search_2_16;
        slice0shift_search_2_16 <= slice0shift_search_2_17;
        slice0shift_search_2_17 <= slice0shift_search_2_18;
        slice0shift_search_2_18 <= slice0shift_search_2_19;
        slice0shift_search_2_19 <= slice0shift_search_2_20;
        slice0shift_search_2_20 <= slice0shift_search_2_21;
        slice0shift_search_2_21 <= slice0shift_search_2_22;
        slice0shift_search_2_22 <= slice0shift_search_2_23;
        slice0shift_search_2_23 <= slice0shift_search_2_24;
        slice0shift_search_2_24 <= rows_search_2;
        slice0shift_search_3_0 <= slice0shift_search_3_1;
        slice0shift_search_3_1 <= slice0shift_search_3_2;
        slice0shift_search_3_2 <= slice0shift_search_3_3;
        slice0shift_search_3_3 <= slice0shift_search_3_4;
        slice0shift_search_3_4 <= slice0shift_search_3_5;
        slice0shift_search_3_5 <= slice0shift_search_3_6;
        slice0shift_search_3_6 <= slice0shift_search_3_7;
        slice0shift_search_3_7 <= slice0shift_search_3_8;
        slice0shift_search_3_8 <= slice0shift_search_3_9;
        slice0shift_search_3_9 <= slice0shift_search_3_10;
        slice0shift_search_3_10 <= slice0shift_search_3_11;
        slice0shift_search_3_11 <= slice0shift_search_3_12;
        slice0shift_search_3_12 <= slice0shift_search_3_13;
        slice0shift_search_3_13 <= slice0shift_search_3_14;
        slice0shift_search_3_14 <= slice0shift_search_3_15;
        slice0shift_search_3_15 <= slice0shift_search_3_16;
        slice0shift_search_3_16 <= slice0shift_search_3_17;
        slice0shift_search_3_17 <= slice0shift_search_3_18;
        slice0shift_search_3_18 <= slice0shift_search_3_19;
        slice0shift_search_3_19 <= slice0shift_search_3_20;
        slice0shift_search_3_20 <= slice0shift_search_3_21;
        slice0shift_search_3_21 <= slice0shift_search_3_22;
        slice0shift_search_3_22 <= slice0shift_search_3_23;
        slice0shift_search_3_23 <= slice0shift_search_3_24;
        slice0shift_search_3_24 <= rows_search_3;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_difference_0_0 <= slice0shift_search_0_0 - slice0shift_reference_0;
      slice0cost_difference_0_1 <= slice0shift_search_0_1 - slice0shift_reference_0;
      slice0cost_difference_0_2 <= slice0shift_search_0_2 - slice0shift_reference_0;
      slice0cost_difference_0_3 <= slice0shift_search_0_3 - slice0shift_reference_0;
      slice0cost_difference_0_4 <= slice0shift_search_0_4 - slice0shift_reference_0;
      slice0cost_difference_0_5 <= slice0shift_search_0_5 - slice0shift_reference_0;
      slice0cost_difference_0_6 <= slice0shift_search_0_6 - slice0shift_reference_0;
      slice0cost_difference_0_7 <= slice0shift_search_0_7 - slice0shift_reference_0;
      slice0cost_difference_0_8 <= slice0shift_search_0_8 - slice0shift_reference_0;
      slice0cost_difference_0_9 <= slice0shift_search_0_9 - slice0shift_reference_0;
      slice0cost_difference_0_10 <= slice0shift_search_0_10 - slice0shift_reference_0;
      slice0cost_difference_0_11 <= slice0shift_search_0_11 - slice0shift_reference_0;
      slice0cost_difference_0_12 <= slice0shift_search_0_12 - slice0shift_reference_0;
      slice0cost_difference_0_13 <= slice0shift_search_0_13 - slice0shift_reference_0;
      slice0cost_difference_0_14 <= slice0shift_search_0_14 - slice0shift_reference_0;
      slice0cost_difference_0_15 <= slice0shift_search_0_15 - slice0shift_reference_0;
      slice0cost_difference_0_16 <= slice0shift_search_0_16 - slice0shift_reference_0;
      slice0cost_difference_0_17 <= slice0shift_search_0_17 - slice0shift_reference_0;
      slice0cost_difference_0_18 <= slice0shift_search_0_18 - slice0shift_reference_0;
      slice0cost_difference_0_19 <= slice0shift_search_0_19 - slice0shift_reference_0;
      slice0cost_difference_0_20 <= slice0shift_search_0_20 - slice0shift_reference_0;
      slice0cost_difference_0_21 <= slice0shift_search_0_21 - slice0shift_reference_0;
      slice0cost_difference_0_22 <= slice0shift_search_0_22 - slice0shift_reference_0;
      slice0cost_difference_0_23 <= slice0shift_search_0_23 - slice0shift_reference_0;
      slice0cost_difference_0_24 <= slice0shift_search_0_24 - slice0shift_reference_0;
      slice0cost_difference_1_0 <= slice0shift_search_1_0 - slice0shift_reference_1;
      slice0cost_difference_1_1 <= slice0shift_search_1_1 - slice0shift_reference_1;
      slice0cost_difference_1_2 <= slice0shift_search_1_2 - slice0shift_reference_1;
      slice0cost_difference_1_3 <= slice0shift_search_1_3 - slice0shift_reference_1;
      slice0cost_difference_1_4 <= slice0shift_search_1_4 - slice0shift_reference_1;
      slice0cost_difference_1_5 <= slice0shift_search_1_5 - slice0shift_reference_1;
      slice0cost_difference_1_6 <= slice0shift_search_1_6 - slice0shift_reference_1;
      slice0cost_difference_1_7 <= slice0shift_search_1_7 - slice0shift_reference_1;
      slice0cost_difference_1_8 <= slice0shift_search_1_8 - slice0shift_reference_1;
      slice0cost_difference_1_9 <= slice0shift_search_1_9 - slice0shift_reference_1;
      slice0cost_difference_1_10 <= slice0shift_search_1_10 - slice0shift_reference_1;
      slice0cost_difference_1_11 <= slice0shift_search_1_11 - slice0shift_reference_1;
      slice0cost_difference_1_12 <= slice0shift_search_1_12 - slice0shift_reference_1;
      slice0cost_difference_1_13 <= slice0shift_search_1_13 - slice0shift_reference_1;
      slice0cost_difference_1_14 <= slice0shift_search_1_14 - slice0shift_reference_1;
      slice0cost_difference_1_15 <= slice0shift_search_1_15 - slice0shift_reference_1;
      slice0cost_difference_1_16 <= slice0shift_search_1_16 - slice0shift_reference_1;
      slice0cost_difference_1_17 <= slice0shift_search_1_17 - slice0shift_reference_1;
      slice0cost_difference_1_18 <= slice0shift_search_1_18 - slice0shift_reference_1;
      slice0cost_difference_1_19 <= slice0shift_search_1_19 - slice0shift_reference_1;
      slice0cost_difference_1_20 <= slice0shift_search_1_20 - slice0shift_reference_1;
      slice0cost_difference_1_21 <= slice0shift_search_1_21 - slice0shift_reference_1;
      slice0cost_difference_1_22 <= slice0shift_search_1_22 - slice0shift_reference_1;
      slice0cost_difference_1_23 <= slice0shift_search_1_23 - slice0shift_reference_1;
      slice0cost_difference_1_24 <= slice0shift_search_1_24 - slice0shift_reference_1;
      slice0cost_difference_2_0 <= slice0shift_search_2_0 - slice0shift_reference_2;
      slice0cost_difference_2_1 <= slice0shift_search_2_1 - slice0shift_reference_2;
      slice0cost_difference_2_2 <= slice0shift_search_2_2 - slice0shift_reference_2;
      slice0cost_difference_2_3 <= slice0shift_search_2_3 - slice0shift_reference_2;
      slice0cost_difference_2_4 <= slice0shift_search_2_4 - slice0shift_reference_2;
      slice0cost_difference_2_5 <= slice0shift_search_2_5 - slice0shift_reference_2;
      slice0cost_difference_2_6 <= slice0shift_search_2_6 - slice0shift_reference_2;
      slice0cost_difference_2_7 <= slice0shift_search_2_7 - slice0shift_reference_2;
      slice0cost_difference_2_8 <= slice0shift_search_2_8 - slice0shift_reference_2;
      slice0cost_difference_2_9 <= slice0shift_search_2_9 - slice0shift_reference_2;
      slice0cost_difference_2_10 <= slice0shift_search_2_10 - slice0shift_reference_2;
      slice0cost_difference_2_11 <= slice0shift_search_2_11 - slice0shift_reference_2;
      slice0cost_difference_2_12 <= slice0shift_search_2_12 - slice0shift_reference_2;
      slice0cost_difference_2_13 <= slice0shift_search_2_13 - slice0shift_reference_2;
      slice0cost_difference_2_14 <= slice0shift_search_2_14 - slice0shift_reference_2;
      slice0cost_difference_2_15 <= slice0shift_search_2_15 - slice0shift_reference_2;
      slice0cost_difference_2_16 <= slice0shift_search_2_16 - slice0shift_reference_2;
      slice0cost_difference_2_17 <= slice0shift_search_2_17 - slice0shift_reference_2;
      slice0cost_difference_2_18 <= slice0shift_search_2_18 - slice0shift_reference_2;
      slice0cost_difference_2_19 <= slice0shift_search_2_19 - slice0shift_reference_2;
      slice0cost_difference_2_20 <= slice0shift_search_2_20 - slice0shift_reference_2;
      slice0cost_difference_2_21 <= slice0shift_search_2_21 - slice0shift_reference_2;
      slice0cost_difference_2_22 <= slice0shift_search_2_22 - slice0shift_reference_2;
      slice0cost_difference_2_23 <= slice0shift_search_2_23 - slice0shift_reference_2;
      slice0cost_difference_2_24 <= slice0shift_search_2_24 - slice0shift_reference_2;
      slice0cost_difference_3_0 <= slice0shift_search_3_0 - slice0shift_reference_3;
      slice0cost_difference_3_1 <= slice0shift_search_3_1 - slice0shift_reference_3;
      slice0cost_difference_3_2 <= slice0shift_search_3_2 - slice0shift_reference_3;
      slice0cost_difference_3_3 <= slice0shift_search_3_3 - slice0shift_reference_3;
      slice0cost_difference_3_4 <= slice0shift_search_3_4 - slice0shift_reference_3;
      slice0cost_difference_3_5 <= slice0shift_search_3_5 - slice0shift_reference_3;
      slice0cost_difference_3_6 <= slice0shift_search_3_6 - slice0shift_reference_3;
      slice0cost_difference_3_7 <= slice0shift_search_3_7 - slice0shift_reference_3;
      slice0cost_difference_3_8 <= slice0shift_search_3_8 - slice0shift_reference_3;
      slice0cost_difference_3_9 <= slice0shift_search_3_9 - slice0shift_reference_3;
      slice0cost_difference_3_10 <= slice0shift_search_3_10 - slice0shift_reference_3;
      slice0cost_difference_3_11 <= slice0shift_search_3_11 - slice0shift_reference_3;
      slice0cost_difference_3_12 <= slice0shift_search_3_12 - slice0shift_reference_3;
      slice0cost_difference_3_13 <= slice0shift_search_3_13 - slice0shift_reference_3;
      slice0cost_difference_3_14 <= slice0shift_search_3_14 - slice0shift_reference_3;
      slice0cost_difference_3_15 <= slice0shift_search_3_15 - slice0shift_reference_3;
      slice0cost_difference_3_16 <= slice0shift_search_3_16 - slice0shift_reference_3;
      slice0cost_difference_3_17 <= slice0shift_search_3_17 - slice0shift_reference_3;
      slice0cost_difference_3_18 <= slice0shift_search_3_18 - slice0shift_reference_3;
      slice0cost_difference_3_19 <= slice0shift_search_3_19 - slice0shift_reference_3;
      slice0cost_difference_3_20 <= slice0shift_search_3_20 - slice0shift_reference_3;
      slice0cost_difference_3_21 <= slice0shift_search_3_21 - slice0shift_reference_3;
      slice0cost_difference_3_22 <= slice0shift_search_3_22 - slice0shift_reference_3;
      slice0cost_difference_3_23 <= slice0shift_search_3_23 - slice0shift_reference_3;
      slice0cost_difference_3_24 <= slice0shift_search_3_24 - slice0shift_reference_3;
      slice0cost_difference_tag_valid <= slice0shift_tag_valid;
      slice0cost_difference_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_difference_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_difference_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pair_0_0 <= folded(slice0cost_difference_2_0) + folded(slice0cost_difference_1_0) +
        as_number((slice0cost_difference_1_0 < 0));
      slice0cost_pair_0_1 <= folded(slice0cost_difference_2_1) + folded(slice0cost_difference_1_1) +
        as_number((slice0cost_difference_1_1 < 0));
      slice0cost_pair_0_2 <= folded(slice0cost_difference_2_2) + folded(slice0cost_difference_1_2) +
        as_number((slice0cost_difference_1_2 < 0));
      slice0cost_pair_0_3 <= folded(slice0cost_difference_2_3) + folded(slice0cost_difference_1_3) +
        as_number((slice0cost_difference_1_3 < 0));
      slice0cost_pair_0_4 <= folded(slice0cost_difference_2_4) + folded(slice0cost_difference_1_4) +
        as_number((slice0cost_difference_1_4 < 0));
      slice0cost_pair_0_5 <= folded(slice0cost_difference_2_5) + folded(slice0cost_difference_1_5) +
        as_number((slice0cost_difference_1_5 < 0));
      slice0cost_pair_0_6 <= folded(slice0cost_difference_2_6) + folded(slice0cost_difference_1_6) +
        as_number((slice0cost_difference_1_6 < 0));
      slice0cost_pair_0_7 <= folded(slice0cost_difference_2_7) + folded(slice0cost_difference_1_7) +
        as_number((slice0cost_difference_1_7 < 0));
      slice0cost_pair_0_8 <= folded(slice0cost_difference_2_8) + folded(slice0cost_difference_1_8) +
        as_number((slice0cost_difference_1_8 < 0));
      slice0cost_pair_0_9 <= folded(slice0cost_difference_2_9) + folded(slice0cost_difference_1_9) +
        as_number((slice0cost_difference_1_9 < 0));
      slice0cost_pair_0_10 <= folded(slice0cost_difference_2_10) + folded(slice0cost_difference_1_10) +
        as_number((slice0cost_difference_1_10 < 0));
      slice0cost_pair_0_11 <= folded(slice0cost_difference_2_11) + folded(slice0cost_difference_1_11) +
        as_number((slice0cost_difference_1_11 < 0));
      slice0cost_pair_0_12 <= folded(slice0cost_difference_2_12) + folded(slice0cost_difference_1_12) +
        as_number((slice0cost_difference_1_12 < 0));
      slice0cost_pair_0_13 <= folded(slice0cost_difference_2_13) + folded(slice0cost_difference_1_13) +
        as_number((slice0cost_difference_1_13 < 0));
      slice0cost_pair_0_14 <= folded(slice0cost_difference_2_14) + folded(slice0cost_difference_1_14) +
        as_number((slice0cost_difference_1_14 < 0));
      slice0cost_pair_0_15 <= folded(slice0cost_difference_2_15) + folded(slice0cost_difference_1_15) +
        as_number((slice0cost_difference_1_15 < 0));
      slice0cost_pair_0_16 <= folded(slice0cost_difference_2_16) + folded(slice0cost_difference_1_16) +
        as_number((slice0cost_difference_1_16 < 0));
      slice0cost_pair_0_17 <= folded(slice0cost_difference_2_17) + folded(slice0cost_difference_1_17) +
        as_number((slice0cost_difference_1_17 < 0));
      slice0cost_pair_0_18 <= folded(slice0cost_difference_2_18) + folded(slice0cost_difference_1_18) +
        as_number((slice0cost_difference_1_18 < 0));
      slice0cost_pair_0_19 <= folded(slice0cost_difference_2_19) + folded(slice0cost_difference_1_19) +
        as_number((slice0cost_difference_1_19 < 0));
      slice0cost_pair_0_20 <= folded(slice0cost_difference_2_20) + folded(slice0cost_difference_1_20) +
        as_number((slice0cost_difference_1_20 < 0));
      slice0cost_pair_0_21 <= folded(slice0cost_difference_2_21) + folded(slice0cost_difference_1_21) +
        as_number((slice0cost_difference_1_21 < 0));
      slice0cost_pair_0_22 <= folded(slice0cost_difference_2_22) + folded(slice0cost_difference_1_22) +
        as_number((slice0cost_difference_1_22 < 0));
      slice0cost_pair_0_23 <= folded(slice0cost_difference_2_23) + folded(slice0cost_difference_1_23) +
        as_number((slice0cost_difference_1_23 < 0));
      slice0cost_pair_0_24 <= folded(slice0cost_difference_2_24) + folded(slice0cost_difference_1_24) +
        as_number((slice0cost_difference_1_24 < 0));
      slice0cost_negative_0_0 <= slice0cost_difference_2_0 < 0;
      slice0cost_negative_0_1 <= slice0cost_difference_2_1 < 0;
      slice0cost_negative_0_2 <= slice0cost_difference_2_2 < 0;
      slice0cost_negative_0_3 <= slice0cost_difference_2_3 < 0;
      slice0cost_negative_0_4 <= slice0cost_difference_2_4 < 0;
      slice0cost_negative_0_5 <= slice0cost_difference_2_5 < 0;
      slice0cost_negative_0_6 <= slice0cost_difference_2_6 < 0;
      slice0cost_negative_0_7 <= slice0cost_difference_2_7 < 0;
      slice0cost_negative_0_8 <= slice0cost_difference_2_8 < 0;
      slice0cost_negative_0_9 <= slice0cost_difference_2_9 < 0;
      slice0cost_negative_0_10 <= slice0cost_difference_2_10 < 0;
      slice0cost_negative_0_11 <= slice0cost_difference_2_11 < 0;
      slice0cost_negative_0_12 <= slice0cost_difference_2_12 < 0;
      slice0cost_negative_0_13 <= slice0cost_difference_2_13 < 0;
      slice0cost_negative_0_14 <= slice0cost_difference_2_14 < 0;
      slice0cost_negative_0_15 <= slice0cost_difference_2_15 < 0;
      slice0cost_negative_0_16 <= slice0cost_difference_2_16 < 0;
      slice0cost_negative_0_17 <= slice0cost_difference_2_17 < 0;
      slice0cost_negative_0_18 <= slice0cost_difference_2_18 < 0;
      slice0cost_negative_0_19 <= slice0cost_difference_2_19 < 0;
      slice0cost_negative_0_20 <= slice0cost_difference_2_20 < 0;
      slice0cost_negative_0_21 <= slice0cost_difference_2_21 < 0;
      slice0cost_negative_0_22 <= slice0cost_difference_2_22 < 0;
      slice0cost_negative_0_23 <= slice0cost_difference_2_23 < 0;
      slice0cost_negative_0_24 <= slice0cost_difference_2_24 < 0;
      slice0cost_single_0_0 <= (folded(slice0cost_difference_0_0) + as_number((slice0cost_difference_0_0 < 0))) mod 256;
      slice0cost_single_0_1 <= (folded(slice0cost_difference_0_1) + as_number((slice0cost_difference_0_1 < 0))) mod 256;
      slice0cost_single_0_2 <= (folded(slice0cost_difference_0_2) + as_number((slice0cost_difference_0_2 < 0))) mod 256;
      slice0cost_single_0_3 <= (folded(slice0cost_difference_0_3) + as_number((slice0cost_difference_0_3 < 0))) mod 256;
      slice0cost_single_0_4 <= (folded(slice0cost_difference_0_4) + as_number((slice0cost_difference_0_4 < 0))) mod 256;
      slice0cost_single_0_5 <= (folded(slice0cost_difference_0_5) + as_number((slice0cost_difference_0_5 < 0))) mod 256;
      slice0cost_single_0_6 <= (folded(slice0cost_difference_0_6) + as_number((slice0cost_difference_0_6 < 0))) mod 256;
      slice0cost_single_0_7 <= (folded(slice0cost_difference_0_7) + as_number((slice0cost_difference_0_7 < 0))) mod 256;
      slice0cost_single_0_8 <= (folded(slice0cost_difference_0_8) + as_number((slice0cost_difference_0_8 < 0))) mod 256;
      slice0cost_single_0_9 <= (folded(slice0cost_difference_0_9) + as_number((slice0cost_difference_0_9 < 0))) mod 256;
      slice0cost_single_0_10 <= (folded(slice0cost_difference_0_10) + as_number((slice0cost_difference_0_10 < 0))) mod
        256;
      slice0cost_single_0_11 <= (folded(slice0cost_difference_0_11) + as_number((slice0cost_difference_0_11 < 0))) mod
        256;
      slice0cost_single_0_12 <= (folded(slice0cost_difference_0_12) + as_number((slice0cost_difference_0_12 < 0))) mod
        256;
      slice0cost_single_0_13 <= (folded(slice0cost_difference_0_13) + as_number((slice0cost_difference_0_13 < 0))) mod
        256;
      slice0cost_single_0_14 <= (folded(slice0cost_difference_0_14) + as_number((slice0cost_difference_0_14 < 0))) mod
        256;
      slice0cost_single_0_15 <= (folded(slice0cost_difference_0_15) + as_number((slice0cost_difference_0_15 < 0))) mod
        256;
      slice0cost_single_0_16 <= (folded(slice0cost_difference_0_16) + as_number((slice0cost_difference_0_16 < 0))) mod
        256;
      slice0cost_single_0_17 <= (folded(slice0cost_difference_0_17) + as_number((slice0cost_difference_0_17 < 0))) mod
        256;
      slice0cost_single_0_18 <= (folded(slice0cost_difference_0_18) + as_number((slice0cost_difference_0_18 < 0))) mod
        256;
      slice0cost_single_0_19 <= (folded(slice0cost_difference_0_19) + as_number((slice0cost_difference_0_19 < 0))) mod
        256;
      slice0cost_single_0_20 <= (folded(slice0cost_difference_0_20) + as_number((slice0cost_difference_0_20 < 0))) mod
        256;
      slice0cost_single_0_21 <= (folded(slice0cost_difference_0_21) + as_number((slice0cost_difference_0_21 < 0))) mod
        256;
      slice0cost_single_0_22 <= (folded(slice0cost_difference_0_22) + as_number((slice0cost_difference_0_22 < 0))) mod
        256;
      slice0cost_single_0_23 <= (folded(slice0cost_difference_0_23) + as_number((slice0cost_difference_0_23 < 0))) mod
        256;
      slice0cost_single_0_24 <= (folded(slice0cost_difference_0_24) + as_number((slice0cost_difference_0_24 < 0))) mod
        256;
      slice0cost_single_3_0 <= (folded(slice0cost_difference_3_0) + as_number((slice0cost_difference_3_0 < 0))) mod 256;
      slice0cost_single_3_1 <= (folded(slice0cost_difference_3_1) + as_number((slice0cost_difference_3_1 < 0))) mod 256;
      slice0cost_single_3_2 <= (folded(slice0cost_difference_3_2) + as_number((slice0cost_difference_3_2 < 0))) mod 256;
      slice0cost_single_3_3 <= (folded(slice0cost_difference_3_3) + as_number((slice0cost_difference_3_3 < 0))) mod 256;
      slice0cost_single_3_4 <= (folded(slice0cost_difference_3_4) + as_number((slice0cost_difference_3_4 < 0))) mod 256;
      slice0cost_single_3_5 <= (folded(slice0cost_difference_3_5) + as_number((slice0cost_difference_3_5 < 0))) mod 256;
      slice0cost_single_3_6 <= (folded(slice0cost_difference_3_6) + as_number((slice0cost_difference_3_6 < 0))) mod 256;
      slice0cost_single_3_7 <= (folded(slice0cost_difference_3_7) + as_number((slice0cost_difference_3_7 < 0))) mod 256;
      slice0cost_single_3_8 <= (folded(slice0cost_difference_3_8) + as_number((slice0cost_difference_3_8 < 0))) mod 256;
      slice0cost_single_3_9 <= (folded(slice0cost_difference_3_9) + as_number((slice0cost_difference_3_9 < 0))) mod 256;
      slice0cost_single_3_10 <= (folded(slice0cost_difference_3_10) + as_number((slice0cost_difference_3_10 < 0))) mod
        256;
      slice0cost_single_3_11 <= (folded(slice0cost_difference_3_11) + as_number((slice0cost_difference_3_11 < 0))) mod
        256;
      slice0cost_single_3_12 <= (folded(slice0cost_difference_3_12) + as_number((slice0cost_difference_3_12 < 0))) mod
        256;
      slice0cost_single_3_13 <= (folded(slice0cost_difference_3_13) + as_number((slice0cost_difference_3_13 < 0))) mod
        256;
      slice0cost_single_3_14 <= (folded(slice0cost_difference_3_14) + as_number((slice0cost_difference_3_14 < 0))) mod
        256;
      slice0cost_single_3_15 <= (folded(slice0cost_difference_3_15) + as_number((slice0cost_difference_3_15 < 0))) mod
        256;
      slice0cost_single_3_16 <= (folded(slice0cost_difference_3_16) + as_number((slice0cost_difference_3_16 < 0))) mod
        256;
      slice0cost_single_3_17 <= (folded(slice0cost_difference_3_17) + as_number((slice0cost_difference_3_17 < 0))) mod
        256;
      slice0cost_single_3_18 <= (folded(slice0cost_difference_3_18) + as_number((slice0cost_difference_3_18 < 0))) mod
        256;
      slice0cost_single_3_19 <= (folded(slice0cost_difference_3_19) + as_number((slice0cost_difference_3_19 < 0))) mod
        256;
      slice0cost_single_3_20 <= (folded(slice0cost_difference_3_20) + as_number((slice0cost_difference_3_20 < 0))) mod
        256;
      slice0cost_single_3_21 <= (folded(slice0cost_difference_3_21) + as_number((slice0cost_difference_3_21 < 0))) mod
        256;
      slice0cost_single_3_22 <= (folded(slice0cost_difference_3_22) + as_number((slice0cost_difference_3_22 < 0))) mod
        256;
      slice0cost_single_3_23 <= (folded(slice0cost_difference_3_23) + as_number((slice0cost_difference_3_23 < 0))) mod
        256;
      slice0cost_single_3_24 <= (folded(slice0cost_difference_3_24) + as_number((slice0cost_difference_3_24 < 0))) mod
        256;
      slice0cost_pair_tag_valid <= slice0cost_difference_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_difference_tag_border_column;
      slice0cost_pair_tag_output_column <= slice0cost_difference_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_difference_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_difference_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      if slice0cost_pair_tag_border_column then
        slice0cost_column_0_0 <= 0;
        slice0cost_column_0_1 <= 0;
        slice0cost_column_0_2 <= 0;
        slice0cost_column_0_3 <= 0;
        slice0cost_column_0_4 <= 0;
        slice0cost_column_0_5 <= 0;
        slice0cost_column_0_6 <= 0;
        slice0cost_column_0_7 <= 0;
        slice0cost_column_0_8 <= 0;
        slice0cost_column_0_9 <= 0;
        slice0cost_column_0_10 <= 0;
        slice0cost_column_0_11 <= 0;
        slice0cost_column_0_12 <= 0;
        slice0cost_column_0_13 <= 0;
        slice0cost_column_0_14 <= 0;
        slice0cost_column_0_15 <= 0;
        slice0cost_column_0_16 <= 0;
        slice0cost_column_0_17 <= 0;
        slice0cost_column_0_18 <= 0;
        slice0cost_column_0_19 <= 0;
        slice0cost_column_0_20 <= 0;
        slice0cost_column_0_21 <= 0;
        slice0cost_column_0_22 <= 0;
        slice0cost_column_0_23 <= 0;
        slice0cost_column_0_24 <= 0;
        slice0cost_column_1_0 <= 0;
        slice0cost_column_1_1 <= 0;
        slice0cost_column_1_2 <= 0;
        slice0cost_column_1_3 <= 0;
        slice0cost_column_1_4 <= 0;
        slice0cost_column_1_5 <= 0;
        slice0cost_column_1_6 <= 0;
        slice0cost_column_1_7 <= 0;
        slice0cost_column_1_8 <= 0;
        slice0cost_column_1_9 <= 0;
        slice0cost_column_1_10 <= 0;
        slice0cost_column_1_11 <= 0;
        slice0cost_column_1_12 <= 0;
        slice0cost_column_1_13 <= 0;
        slice0cost_column_1_14 <= 0;
        slice0cost_column_1_15 <= 0;
        slice0cost_column_1_16 <= 0;
        slice0cost_column_1_17 <= 0;
        slice0cost_column_1_18 <= 0;
        slice0cost_column_1_19 <= 0;
        slice0cost_column_1_20 <= 0;
        slice0cost_column_1_21 <= 0;
        slice0cost_column_1_22 <= 0;
        slice0cost_column_1_23 <= 0;
        slice0cost_column_1_24 <= 0;
      else
        slice0cost_column_0_0 <= slice0cost_pair_0_0 + as_number(slice0cost_negative_0_0) + slice0cost_single_0_0;
        slice0cost_column_0_1 <= slice0cost_pair_0_1 + as_number(slice0cost_negative_0_1) + slice0cost_single_0_1;
        slice0cost_column_0_2 <= slice0cost_pair_0_2 + as_number(slice0cost_negative_0_2) + slice0cost_single_0_2;
        slice0cost_column_0_3 <= slice0cost_pair_0_3 + as_number(slice0cost_negative_0_3) + slice0cost_single_0_3;
        slice0cost_column_0_4 <= slice0cost_pair_0_4 + as_number(slice0cost_negative_0_4) + slice0cost_single_0_4;
        slice0cost_column_0_5 <= slice0cost_pair_0_5 + as_number(slice0cost_negative_0_5) + slice0cost_single_0_5;
        slice0cost_column_0_6 <= slice0cost_pair_0_6 + as_number(slice0cost_negative_0_6) + slice0cost_single_0_6;
        slice0cost_column_0_7 <= slice0cost_pair_0_7 + as_number(slice0cost_negative_0_7) + slice0cost_single_0_7;
        slice0cost_column_0_8 <= slice0cost_pair_0_8 + as_number(slice0cost_negative_0_8) + slice0cost_single_0_8;
        slice0cost_column_0_9 <= slice0cost_pair_0_9 + as_number(slice0cost_negative_0_9) + slice0cost_single_0_9;
        slice0cost_column_0_10 <= slice0cost_pair_0_10 + as_number(slice0cost_negative_0_10) + slice0cost_single_0_10;
        slice0cost_column_0_11 <= slice0cost_pair_0_11 + as_number(slice0cost_negative_0_11) + slice0cost_single_0_11;
        slice0cost_column_0_12 <= slice0cost_pair_0_12 + as_number(slice0cost_negative_0_12) + slice0cost_single_0_12;
        slice0cost_column_0_13 <= slice0cost_pair_0_13 + as_number(slice0cost_negative_0_13) + slice0cost_single_0_13;
        slice0cost_column_0_14 <= slice0cost_pair_0_14 + as_number(slice0cost_negative_0_14) + slice0cost_single_0_14;
        slice0cost_column_0_15 <= slice0cost_pair_0_15 + as_number(slice0cost_negative_0_15) + slice0cost_single_0_15;
        slice0cost_column_0_16 <= slice0cost_pair_0_16 + as_number(slice0cost_negative_0_16) + slice0cost_single_0_16;
        slice0cost_column_0_17 <= slice0cost_pair_0_17 + as_number(slice0cost_negative_0_17) + slice0cost_single_0_17;
        slice0cost_column_0_18 <= slice0cost_pair_0_18 + as_number(slice0cost_negative_0_18) + slice0cost_single_0_18;
        slice0cost_column_0_19 <= slice0cost_pair_0_19 + as_number(slice0cost_negative_0_19) + slice0cost_single_0_19;
        slice0cost_column_0_20 <= slice0cost_pair_0_20 + as_number(slice0cost_negative_0_20) + slice0cost_single_0_20;
        slice0cost_column_0_21 <= slice0cost_pair_0_21 + as_number(slice0cost_negative_0_21) + slice0cost_single_0_21;
        slice0cost_column_0_22 <= slice0cost_pair_0_22 + as_number(slice0cost_negative_0_22) + slice0cost_single_0_22;
        slice0cost_column_0_23 <= slice0cost_pair_0_23 + as_number(slice0cost_negative_0_23) + slice0cost_single_0_23;
        slice0cost_column_0_24 <= slice0cost_pair_0_24 + as_number(slice0cost_negative_0_24) + slice0cost_single_0_24;
        slice0cost_column_1_0 <= slice0cost_pair_0_0 + as_number(slice0cost_negative_0_0) + slice0cost_single_3_0;
        slice0cost_column_1_1 <= slice0cost_pair_0_1 + as_number(slice0cost_negative_0_1) + slice0cost_single_3_1;
        slice0cost_column_1_2 <= slice0cost_pair_0_2 + as_number(slice0cost_negative_0_2) + slice0cost_single_3_2;
        slice0cost_column_1_3 <= slice0cost_pair_0_3 + as_number(slice0cost_negative_0_3) + slice0cost_single_3_3;
        slice0cost_column_1_4 <= slice0cost_pair_0_4 + as_number(slice0cost_negative_0_4) + slice0cost_single_3_4;
        slice0cost_column_1_5 <= slice0cost_pair_0_5 + as_number(slice0cost_negative_0_5) + slice0cost_single_3_5;
        slice0cost_column_1_6 <= slice0cost_pair_0_6 + as_number(slice0cost_negative_0_6) + slice0cost_single_3_6;
        slice0cost_column_1_7 <= slice0cost_pair_0_7 + as_number(slice0cost_negative_0_7) + slice0cost_single_3_7;
        slice0cost_column_1_8 <= slice0cost_pair_0_8 + as_number(slice0cost_negative_0_8) + slice0cost_single_3_8;
        slice0cost_column_1_9 <= slice0cost_pair_0_9 + as_number(slice0cost_negative_0_9) + slice0cost_single_3_9;
        slice0cost_column_1_10 <= slice0cost_pair_0_10 + as_number(slice0cost_negative_0_10) + slice0cost_single_3_10;
        slice0cost_column_1_11 <= slice0cost_pair_0_11 + as_number(slice0cost_negative_0_11) + slice0cost_single_3_11;
        slice0cost_column_1_12 <= slice0cost_pair_0_12 + as_number(slice0cost_negative_0_12) + slice0cost_single_3_12;
        slice0cost_column_1_13 <= slice0cost_pair_0_13 + as_number(slice0cost_negative_0_13) + slice0cost_single_3_13;
        slice0cost_column_1_14 <= slice0cost_pair_0_14 + as_number(slice0cost_negative_0_14) + slice0cost_single_3_14;
        slice0cost_column_1_15 <= slice0cost_pair_0_15 + as_number(slice0cost_negative_0_15) + slice0cost_single_3_15;
        slice0cost_column_1_16 <= slice0cost_pair_0_16 + as_number(slice0cost_negative_0_16) + slice0cost_single_3_16;
        slice0cost_column_1_17 <= slice0cost_pair_0_17 + as_number(slice0cost_negative_0_17) + slice0cost_single_3_17;
        slice0cost_column_1_18 <= slice0cost_pair_0_18 + as_number(slice0cost_negative_0_18) + slice0cost_single_3_18;
        slice0cost_column_1_19 <= slice0cost_pair_0_19 + as_number(slice0cost_negative_0_19) + slice0cost_single_3_19;
        slice0cost_column_1_20 <= slice0cost_pair_0_20 + as_number(slice0cost_negative_0_20) + slice0cost_single_3_20;
        slice0cost_column_1_21 <= slice0cost_pair_0_21 + as_number(slice0cost_negative_0_21) + slice0cost_single_3_21;
        slice0cost_column_1_22 <= slice0cost_pair_0_22 + as_number(slice0cost_negative_0_22) + slice0cost_single_3_22;
        slice0cost_column_1_23 <= slice0cost_pair_0_23 + as_number(slice0cost_negative_0_23) + slice0cost_single_3_23;
        slice0cost_column_1_24 <= slice0cost_pair_0_24 + as_number(slice0cost_negative_0_24) + slice0cost_single_3_24;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_0_3 <= slice0cost_column_0_3;
        slice0window_partial_0_0_4 <= slice0cost_column_0_4;
        slice0window_partial_0_0_5 <= slice0cost_column_0_5;
        slice0window_partial_0_0_6 <= slice0cost_column_0_6;
        slice0window_partial_0_0_7 <= slice0cost_column_0_7;
        slice0window_partial_0_0_8 <= slice0cost_column_0_8;
        slice0window_partial_0_0_9 <= slice0cost_column_0_9;
        slice0window_partial_0_0_10 <= slice0cost_column_0_10;
        slice0window_partial_0_0_11 <= slice0cost_column_0_11;
        slice0window_partial_0_0_12 <= slice0cost_column_0_12;
        slice0window_partial_0_0_13 <= slice0cost_column_0_13;
        slice0window_partial_0_0_14 <= slice0cost_column_0_14;
        slice0window_partial_0_0_15 <= slice0cost_column_0_15;
        slice0window_partial_0_0_16 <= slice0cost_column_0_16;
        slice0window_partial_0_0_17 <= slice0cost_column_0_17;
        slice0window_partial_0_0_18 <= slice0cost_column_0_18;
        slice0window_partial_0_0_19 <= slice0cost_column_0_19;
        slice0window_partial_0_0_20 <= slice0cost_column_0_20;
        slice0window_partial_0_0_21 <= slice0cost_column_0_21;
        slice0window_partial_0_0_22 <= slice0cost_column_0_22;
        slice0window_partial_0_0_23 <= slice0cost_column_0_23;
        slice0window_partial_0_0_24 <= slice0cost_column_0_24;
        slice0window_partial_0_1_0 <= slice0cost_column_0_0 + slice0window_partial_0_0_0;
        slice0window_partial_0_1_1 <= slice0cost_column_0_1 + slice0window_partial_0_0_1;
        slice0window_partial_0_1_2 <= slice0cost_column_0_2 + slice0window_partial_0_0_2;
        slice0window_partial_0_1_3 <= slice0cost_column_0_3 + slice0window_partial_0_0_3;
        slice0window_partial_0_1_4 <= slice0cost_column_0_4 + slice0window_partial_0_0_4;
        slice0window_partial_0_1_5 <= slice0cost_column_0_5 + slice0window_partial_0_0_5;
        slice0window_partial_0_1_6 <= slice0cost_column_0_6 + slice0window_partial_0_0_6;
        slice0window_partial_0_1_7 <= slice0cost_column_0_7 + slice0window_partial_0_0_7;
        slice0window_partial_0_1_8 <= slice0cost_column_0_8 + slice0window_partial_0_0_8;
        slice0window_partial_0_1_9 <= slice0cost_column_0_9 + slice0window_partial_0_0_9;
        slice0window_partial_0_1_10 <= slice0cost_column_0_10 + slice0window_partial_0_0_10;
        slice0window_partial_0_1_11 <= slice0cost_column_0_11 + slice0window_partial_0_0_11;
        slice0window_partial_0_1_12 <= slice0cost_column_0_12 + slice0window_partial_0_0_12;
        slice0window_partial_0_1_13 <= slice0cost_column_0_13 + slice0window_partial_0_0_13;
        slice0window_partial_0_1_14 <= slice0cost_column_0_14 + slice0window_partial_0_0_14;
        slice0window_partial_0_1_15 <= slice0cost_column_0_15 + slice0window_partial_0_0_15;
        slice0window_partial_0_1_16 <= slice0cost_column_0_16 + slice0window_partial_0_0_16;
        slice0window_partial_0_1_17 <= slice0cost_column_0_17 + slice0window_partial_0_0_17;
        slice0window_partial_0_1_18 <= slice0cost_column_0_18 + slice0window_partial_0_0_18;
        slice0window_partial_0_1_19 <= slice0cost_column_0_19 + slice0window_partial_0_0_19;
        slice0window_partial_0_1_20 <= slice0cost_column_0_20 + slice0window_partial_0_0_20;
        slice0window_partial_0_1_21 <= slice0cost_column_0_21 + slice0window_partial_0_0_21;
        slice0window_partial_0_1_22 <= slice0cost_column_0_22 + slice0window_partial_0_0_22;
        slice0window_partial_0_1_23 <= slice0cost_column_0_23 + slice0window_partial_0_0_23;
        slice0window_partial_0_1_24 <= slice0cost_column_0_24 + slice0window_partial_0_0_24;
        slice0window_partial_1_0_0 <= slice0cost_column_1_0;
        slice0window_partial_1_0_1 <= slice0cost_column_1_1;
        slice0window_partial_1_0_2 <= slice0cost_column_1_2;
        slice0window_partial_1_0_3 <= slice0cost_column_1_3;
        slice0window_partial_1_0_4 <= slice0cost_column_1_4;
        slice0window_partial_1_0_5 <= slice0cost_column_1_5;
        slice0window_partial_1_0_6 <= slice0cost_column_1_6;
        slice0window_partial_1_0_7 <= slice0cost_column_1_7;
        slice0window_partial_1_0_8 <= slice0cost_column_1_8;
        slice0window_partial_1_0_9 <= slice0cost_column_1_9;
        slice0window_partial_1_0_10 <= slice0cost_column_1_10;
        slice0window_partial_1_0_11 <= slice0cost_column_1_11;
        slice0window_partial_1_0_12 <= slice0cost_column_1_12;
        slice0window_partial_1_0_13 <= slice0cost_column_1_13;
        slice0window_partial_1_0_14 <= slice0cost_column_1_14;
        slice0window_partial_1_0_15 <= slice0cost_column_1_15;
        slice0window_partial_1_0_16 <= slice0cost_column_1_16;
        slice0window_partial_1_0_17 <= slice0cost_column_1_17;
        slice0window_partial_1_0_18 <= slice0cost_column_1_18;
        slice0window_partial_1_0_19 <= slice0cost_column_1_19;
        slice0window_partial_1_0_20 <= slice0cost_column_1_20;
        slice0window_partial_1_0_21 <= slice0cost_column_1_21;
        slice0window_partial_1_0_22 <= slice0cost_column_1_22;
        slice0window_partial_1_0_23 <= slice0cost_column_1_23;
        slice0window_partial_1_0_24 <= slice0cost_column_1_24;
        slice0window_partial_1_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_0_0;
        slice0window_partial_1_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_0_1;
        slice0window_partial_1_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_0_2;
        slice0window_partial_1_1_3 <= slice0cost_column_1_3 + slice0window_partial_1_0_3;
        slice0window_partial_1_1_4 <= slice0cost_column_1_4 + slice0window_partial_1_0_4;
        slice0window_partial_1_1_5 <= slice0cost_column_1_5 + slice0window_partial_1_0_5;
        slice0window_partial_1_1_6 <= slice0cost_column_1_6 + slice0window_partial_1_0_6;
        slice0window_partial_1_1_7 <= slice0cost_column_1_7 + slice0window_partial_1_0_7;
        slice0window_partial_1_1_8 <= slice0cost_column_1_8 + slice0window_partial_1_0_8;
        slice0window_partial_1_1_9 <= slice0cost_column_1_9 + slice0window_partial_1_0_9;
        slice0window_partial_1_1_10 <= slice0cost_column_1_10 + slice0window_partial_1_0_10;
        slice0window_partial_1_1_11 <= slice0cost_column_1_11 + slice0window_partial_1_0_11;
        slice0window_partial_1_1_12 <= slice0cost_column_1_12 + slice0window_partial_1_0_12;
        slice0window_partial_1_1_13 <= slice0cost_column_1_13 + slice0window_partial_1_0_13;
        slice0window_partial_1_1_14 <= slice0cost_column_1_14 + slice0window_partial_1_0_14;
        slice0window_partial_1_1_15 <= slice0cost_column_1_15 + slice0window_partial_1_0_15;
        slice0window_partial_1_1_16 <= slice0cost_column_1_16 + slice0window_partial_1_0_16;
        slice0window_partial_1_1_17 <= slice0cost_column_1_17 + slice0window_partial_1_0_17;
        slice0window_partial_1_1_18 <= slice0cost_column_1_18 + slice0window_partial_1_0_18;
        slice0window_partial_1_1_19 <= slice0cost_column_1_19 + slice0window_partial_1_0_19;
        slice0window_partial_1_1_20 <= slice0cost_column_1_20 + slice0window_partial_1_0_20;
        slice0window_partial_1_1_21 <= slice0cost_column_1_21 + slice0window_partial_1_0_21;
        slice0window_partial_1_1_22 <= slice0cost_column_1_22 + slice0window_partial_1_0_22;
        slice0window_partial_1_1_23 <= slice0cost_column_1_23 + slice0window_partial_1_0_23;
        slice0window_partial_1_1_24 <= slice0cost_column_1_24 + slice0window_partial_1_0_24;
      end if;
      slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_sum_0_3 <= slice0cost_column_0_3 + slice0window_partial_0_1_3;
      slice0window_sum_0_4 <= slice0cost_column_0_4 + slice0window_partial_0_1_4;
      slice0window_sum_0_5 <= slice0cost_column_0_5 + slice0window_partial_0_1_5;
      slice0window_sum_0_6 <= slice0cost_column_0_6 + slice0window_partial_0_1_6;
      slice0window_sum_0_7 <= slice0cost_column_0_7 + slice0window_partial_0_1_7;
      slice0window_sum_0_8 <= slice0cost_column_0_8 + slice0window_partial_0_1_8;
      slice0window_sum_0_9 <= slice0cost_column_0_9 + slice0window_partial_0_1_9;
      slice0window_sum_0_10 <= slice0cost_column_0_10 + slice0window_partial_0_1_10;
      slice0window_sum_0_11 <= slice0cost_column_0_11 + slice0window_partial_0_1_11;
      slice0window_sum_0_12 <= slice0cost_column_0_12 + slice0window_partial_0_1_12;
      slice0window_sum_0_13 <= slice0cost_column_0_13 + slice0window_partial_0_1_13;
      slice0window_sum_0_14 <= slice0cost_column_0_14 + slice0window_partial_0_1_14;
      slice0window_sum_0_15 <= slice0cost_column_0_15 + slice0window_partial_0_1_15;
      slice0window_sum_0_16 <= slice0cost_column_0_16 + slice0window_partial_0_1_16;
      slice0window_sum_0_17 <= slice0cost_column_0_17 + slice0window_partial_0_1_17;
      slice0window_sum_0_18 <= slice0cost_column_0_18 + slice0window_partial_0_1_18;
      slice0window_sum_0_19 <= slice0cost_column_0_19 + slice0window_partial_0_1_19;
      slice0window_sum_0_20 <= slice0cost_column_0_20 + slice0window_partial_0_1_20;
      slice0window_sum_0_21 <= slice0cost_column_0_21 + slice0window_partial_0_1_21;
      slice0window_sum_0_22 <= slice0cost_column_0_22 + slice0window_partial_0_1_22;
      slice0window_sum_0_23 <= slice0cost_column_0_23 + slice0window_partial_0_1_23;
      slice0window_sum_0_24 <= slice0cost_column_0_24 + slice0window_partial_0_1_24;
      slice0window_sum_1_0 <= slice0cost_column_1_0 + slice0window_partial_1_1_0;
      slice0window_sum_1_1 <= slice0cost_column_1_1 + slice0window_partial_1_1_1;
      slice0window_sum_1_2 <= slice0cost_column_1_2 + slice0window_partial_1_1_2;
      slice0window_sum_1_3 <= slice0cost_column_1_3 + slice0window_partial_1_1_3;
      slice0window_sum_1_4 <= slice0cost_column_1_4 + slice0window_partial_1_1_4;
      slice0window_sum_1_5 <= slice0cost_column_1_5 + slice0window_partial_1_1_5;
      slice0window_sum_1_6 <= slice0cost_column_1_6 + slice0window_partial_1_1_6;
      slice0window_sum_1_7 <= slice0cost_column_1_7 + slice0window_partial_1_1_7;
      slice0window_sum_1_8 <= slice0cost_column_1_8 + slice0window_partial_1_1_8;
      slice0window_sum_1_9 <= slice0cost_column_1_9 + slice0window_partial_1_1_9;
      slice0window_sum_1_10 <= slice0cost_column_1_10 + slice0window_partial_1_1_10;
      slice0window_sum_1_11 <= slice0cost_column_1_11 + slice0window_partial_1_1_11;
      slice0window_sum_1_12 <= slice0cost_column_1_12 + slice0window_partial_1_1_12;
      slice0window_sum_1_13 <= slice0cost_column_1_13 + slice0window_partial_1_1_13;
      slice0window_sum_1_14 <= slice0cost_column_1_14 + slice0window_partial_1_1_14;
      slice0window_sum_1_15 <= slice0cost_column_1_15 + slice0window_partial_1_1_15;
      slice0window_sum_1_16 <= slice0cost_column_1_16 + slice0window_partial_1_1_16;
      slice0window_sum_1_17 <= slice0cost_column_1_17 + slice0window_partial_1_1_17;
      slice0window_sum_1_18 <= slice0cost_column_1_18 + slice0window_partial_1_1_18;
      slice0window_sum_1_19 <= slice0cost_column_1_19 + slice0window_partial_1_1_19;
      slice0window_sum_1_20 <= slice0cost_column_1_20 + slice0window_partial_1_1_20;
      slice0window_sum_1_21 <= slice0cost_column_1_21 + slice0window_partial_1_1_21;
      slice0window_sum_1_22 <= slice0cost_column_1_22 + slice0window_partial_1_1_22;
      slice0window_sum_1_23 <= slice0cost_column_1_23 + slice0window_partial_1_1_23;
      slice0window_sum_1_24 <= slice0cost_column_1_24 + slice0window_partial_1_1_24;
      slice0window_tag_valid <= slice0cost_tag_valid;
      if slice0window_tag_valid then
        slice0window_tag_output_column <= slice0window_centre_output_column_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
        slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
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
      slice0winner1_best_cost_1_0_is_less := (slice0window_sum_1_1 - slice0window_sum_1_0) < 0;
      slice0winner1_best_cost_1_1_is_less := (slice0window_sum_1_3 - slice0window_sum_1_2) < 0;
      slice0winner1_best_cost_1_2_is_less := (slice0window_sum_1_5 - slice0window_sum_1_4) < 0;
      slice0winner1_best_cost_1_3_is_less := (slice0window_sum_1_7 - slice0window_sum_1_6) < 0;
      slice0winner1_best_cost_1_4_is_less := (slice0window_sum_1_9 - slice0window_sum_1_8) < 0;
      slice0winner1_best_cost_1_5_is_less := (slice0window_sum_1_11 - slice0window_sum_1_10) < 0;
      slice0winner1_best_cost_1_6_is_less := (slice0window_sum_1_13 - slice0window_sum_1_12) < 0;
      slice0winner1_best_cost_1_7_is_less := (slice0window_sum_1_15 - slice0window_sum_1_14) < 0;
      slice0winner1_best_cost_1_8_is_less := (slice0window_sum_1_17 - slice0window_sum_1_16) < 0;
      slice0winner1_best_cost_1_9_is_less := (slice0window_sum_1_19 - slice0window_sum_1_18) < 0;
      slice0winner1_best_cost_1_10_is_less := (slice0window_sum_1_21 - slice0window_sum_1_20) < 0;
      slice0winner1_best_cost_1_11_is_less := (slice0window_sum_1_23 - slice0window_sum_1_22) < 0;
      slice0winner1_best_cost_0_12 <= slice0window_sum_0_24;
      slice0winner1_best_cost_1_12 <= slice0window_sum_1_24;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_index_0_12 <= 24;
      slice0winner1_best_index_1_0 <= slice0winner1_best_cost_1_0_is_less;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
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
      if slice0winner1_best_cost_1_0_is_less then
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_1;
      else
        slice0winner1_best_cost_1_0 <= slice0window_sum_1_0;
      end if;
      if slice0winner1_best_cost_1_1_is_less then
        slice0winner1_best_cost_1_1 <= slice0window_sum_1_3;
        slice0winner1_best_index_1_1 <= 3;
      else
        slice0winner1_best_cost_1_1 <= slice0window_sum_1_2;
        slice0winner1_best_index_1_1 <= 2;
      end if;
      if slice0winner1_best_cost_1_2_is_less then
        slice0winner1_best_cost_1_2 <= slice0window_sum_1_5;
        slice0winner1_best_index_1_2 <= 5;
      else
        slice0winner1_best_cost_1_2 <= slice0window_sum_1_4;
        slice0winner1_best_index_1_2 <= 4;
      end if;
      if slice0winner1_best_cost_1_3_is_less then
        slice0winner1_best_cost_1_3 <= slice0window_sum_1_7;
        slice0winner1_best_index_1_3 <= 7;
      else
        slice0winner1_best_cost_1_3 <= slice0window_sum_1_6;
        slice0winner1_best_index_1_3 <= 6;
      end if;
      if slice0winner1_best_cost_1_4_is_less then
        slice0winner1_best_cost_1_4 <= slice0window_sum_1_9;
        slice0winner1_best_index_1_4 <= 9;
      else
        slice0winner1_best_cost_1_4 <= slice0window_sum_1_8;
        slice0winner1_best_index_1_4 <= 8;
      end if;
      if slice0winner1_best_cost_1_5_is_less then
        slice0winner1_best_cost_1_5 <= slice0window_sum_1_11;
        slice0winner1_best_index_1_5 <= 11;
      else
        slice0winner1_best_cost_1_5 <= slice0window_sum_1_10;
        slice0winner1_best_index_1_5 <= 10;
      end if;
      if slice0winner1_best_cost_1_6_is_less then
        slice0winner1_best_cost_1_6 <= slice0window_sum_1_13;
        slice0winner1_best_index_1_6 <= 13;
      else
        slice0winner1_best_cost_1_6 <= slice0window_sum_1_12;
        slice0winner1_best_index_1_6 <= 12;
      end if;
      if slice0winner1_best_cost_1_7_is_less then
        slice0winner1_best_cost_1_7 <= slice0window_sum_1_15;
        slice0winner1_best_index_1_7 <= 15;
      else
        slice0winner1_best_cost_1_7 <= slice0window_sum_1_14;
        slice0winner1_best_index_1_7 <= 14;
      end if;
      if slice0winner1_best_cost_1_8_is_less then
        slice0winner1_best_cost_1_8 <= slice0window_sum_1_17;
        slice0winner1_best_index_1_8 <= 17;
      else
        slice0winner1_best_cost_1_8 <= slice0window_sum_1_16;
        slice0winner1_best_index_1_8 <= 16;
      end if;
      if slice0winner1_best_cost_1_9_is_less then
        slice0winner1_best_cost_1_9 <= slice0window_sum_1_19;
        slice0winner1_best_index_1_9 <= 19;
      else
        slice0winner1_best_cost_1_9 <= slice0window_sum_1_18;
        slice0winner1_best_index_1_9 <= 18;
      end if;
      if slice0winner1_best_cost_1_10_is_less then
        slice0winner1_best_cost_1_10 <= slice0window_sum_1_21;
        slice0winner1_best_index_1_10 <= 21;
      else
        slice0winner1_best_cost_1_10 <= slice0window_sum_1_20;
        slice0winner1_best_index_1_10 <= 20;
      end if;
      if slice0winner1_best_cost_1_11_is_less then
        slice0winner1_best_cost_1_11 <= slice0window_sum_1_23;
        slice0winner1_best_index_1_11 <= 23;
      else
        slice0winner1_best_cost_1_11 <= slice0window_sum_1_22;
        slice0winner1_best_index_1_11 <= 22;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_0_1_is_less := (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0;
      slice0winner2_best_cost_0_2_is_less := (slice0winner1_best_cost_0_5 - slice0winner1_best_cost_0_4) < 0;
      slice0winner2_best_cost_0_3_is_less := (slice0winner1_best_cost_0_7 - slice0winner1_best_cost_0_6) < 0;
      slice0winner2_best_cost_0_4_is_less := (slice0winner1_best_cost_0_9 - slice0winner1_best_cost_0_8) < 0;
      slice0winner2_best_cost_0_5_is_less := (slice0winner1_best_cost_0_11 - slice0winner1_best_cost_0_10) < 0;
      slice0winner2_best_cost_1_0_is_less := (slice0winner1_best_cost_1_1 - slice0winner1_best_cost_1_0) < 0;
      slice0winner2_best_cost_1_1_is_less := (slice0winner1_best_cost_1_3 - slice0winner1_best_cost_1_2) < 0;
      slice0winner2_best_cost_1_2_is_less := (slice0winner1_best_cost_1_5 - slice0winner1_best_cost_1_4) < 0;
      slice0winner2_best_cost_1_3_is_less := (slice0winner1_best_cost_1_7 - slice0winner1_best_cost_1_6) < 0;
      slice0winner2_best_cost_1_4_is_less := (slice0winner1_best_cost_1_9 - slice0winner1_best_cost_1_8) < 0;
      slice0winner2_best_cost_1_5_is_less := (slice0winner1_best_cost_1_11 - slice0winner1_best_cost_1_10) < 0;
      slice0winner2_best_cost_0_6 <= slice0winner1_best_cost_0_12;
      slice0winner2_best_cost_1_6 <= slice0winner1_best_cost_1_12;
      slice0winner2_best_index_0_6 <= slice0winner1_best_index_0_12;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
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
      if slice0winner2_best_cost_1_0_is_less then
        slice0winner2_best_cost_1_0 <= slice0winner1_best_cost_1_1;
        slice0winner2_best_index_1_0 <= slice0winner1_best_index_1_1;
      else
        slice0winner2_best_cost_1_0 <= slice0winner1_best_cost_1_0;
        slice0winner2_best_index_1_0 <= as_number(slice0winner1_best_index_1_0);
      end if;
      if slice0winner2_best_cost_1_1_is_less then
        slice0winner2_best_cost_1_1 <= slice0winner1_best_cost_1_3;
        slice0winner2_best_index_1_1 <= slice0winner1_best_index_1_3;
      else
        slice0winner2_best_cost_1_1 <= slice0winner1_best_cost_1_2;
        slice0winner2_best_index_1_1 <= slice0winner1_best_index_1_2;
      end if;
      if slice0winner2_best_cost_1_2_is_less then
        slice0winner2_best_cost_1_2 <= slice0winner1_best_cost_1_5;
        slice0winner2_best_index_1_2 <= slice0winner1_best_index_1_5;
      else
        slice0winner2_best_cost_1_2 <= slice0winner1_best_cost_1_4;
        slice0winner2_best_index_1_2 <= slice0winner1_best_index_1_4;
      end if;
      if slice0winner2_best_cost_1_3_is_less then
        slice0winner2_best_cost_1_3 <= slice0winner1_best_cost_1_7;
        slice0winner2_best_index_1_3 <= slice0winner1_best_index_1_7;
      else
        slice0winner2_best_cost_1_3 <= slice0winner1_best_cost_1_6;
        slice0winner2_best_index_1_3 <= slice0winner1_best_index_1_6;
      end if;
      if slice0winner2_best_cost_1_4_is_less then
        slice0winner2_best_cost_1_4 <= slice0winner1_best_cost_1_9;
        slice0winner2_best_index_1_4 <= slice0winner1_best_index_1_9;
      else
        slice0winner2_best_cost_1_4 <= slice0winner1_best_cost_1_8;
        slice0winner2_best_index_1_4 <= slice0winner1_best_index_1_8;
      end if;
      if slice0winner2_best_cost_1_5_is_less then
        slice0winner2_best_cost_1_5 <= slice0winner1_best_cost_1_11;
        slice0winner2_best_index_1_5 <= slice0winner1_best_index_1_11;
      else
        slice0winner2_best_cost_1_5 <= slice0winner1_best_cost_1_10;
        slice0winner2_best_index_1_5 <= slice0winner1_best_index_1_10;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      slice0winner3_best_cost_0_1_is_less := (slice0winner2_best_cost_0_3 - slice0winner2_best_cost_0_2) < 0;
      slice0winner3_best_cost_0_2_is_less := (slice0winner2_best_cost_0_5 - slice0winner2_best_cost_0_4) < 0;
      slice0winner3_best_cost_1_0_is_less := (slice0winner2_best_cost_1_1 - slice0winner2_best_cost_1_0) < 0;
      slice0winner3_best_cost_1_1_is_less := (slice0winner2_best_cost_1_3 - slice0winner2_best_cost_1_2) < 0;
      slice0winner3_best_cost_1_2_is_less := (slice0winner2_best_cost_1_5 - slice0winner2_best_cost_1_4) < 0;
      slice0winner3_best_cost_0_3 <= slice0winner2_best_cost_0_6;
      slice0winner3_best_cost_1_3 <= slice0winner2_best_cost_1_6;
      slice0winner3_best_index_0_3 <= slice0winner2_best_index_0_6;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
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
      if slice0winner3_best_cost_1_0_is_less then
        slice0winner3_best_cost_1_0 <= slice0winner2_best_cost_1_1;
        slice0winner3_best_index_1_0 <= slice0winner2_best_index_1_1;
      else
        slice0winner3_best_cost_1_0 <= slice0winner2_best_cost_1_0;
        slice0winner3_best_index_1_0 <= slice0winner2_best_index_1_0;
      end if;
      if slice0winner3_best_cost_1_1_is_less then
        slice0winner3_best_cost_1_1 <= slice0winner2_best_cost_1_3;
        slice0winner3_best_index_1_1 <= slice0winner2_best_index_1_3;
      else
        slice0winner3_best_cost_1_1 <= slice0winner2_best_cost_1_2;
        slice0winner3_best_index_1_1 <= slice0winner2_best_index_1_2;
      end if;
      if slice0winner3_best_cost_1_2_is_less then
        slice0winner3_best_cost_1_2 <= slice0winner2_best_cost_1_5;
        slice0winner3_best_index_1_2 <= slice0winner2_best_index_1_5;
      else
        slice0winner3_best_cost_1_2 <= slice0winner2_best_cost_1_4;
        slice0winner3_best_index_1_2 <= slice0winner2_best_index_1_4;
      end if;
      -- slice0winner4
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0_1 - slice0winner3_best_cost_0_0) < 0;
      slice0winner4_best_cost_0_1_is_less := (slice0winner3_best_cost_0_3 - slice0winner3_best_cost_0_2) < 0;
      slice0winner4_best_cost_1_0_is_less := (slice0winner3_best_cost_1_1 - slice0winner3_best_cost_1_0) < 0;
      slice0winner4_best_cost_1_1_is_less := (slice0winner3_best_cost_1_3 - slice0winner3_best_cost_1_2) < 0;
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
      if slice0winner4_best_cost_1_0_is_less then
        slice0winner4_best_cost_1_0 <= slice0winner3_best_cost_1_1;
        slice0winner4_best_index_1_0 <= slice0winner3_best_index_1_1;
      else
        slice0winner4_best_cost_1_0 <= slice0winner3_best_cost_1_0;
        slice0winner4_best_index_1_0 <= slice0winner3_best_index_1_0;
      end if;
      if slice0winner4_best_cost_1_1_is_less then
        slice0winner4_best_cost_1_1 <= slice0winner3_best_cost_1_3;
        slice0winner4_best_index_1_1 <= slice0winner3_best_index_0_3;
      else
        slice0winner4_best_cost_1_1 <= slice0winner3_best_cost_1_2;
        slice0winner4_best_index_1_1 <= slice0winner3_best_index_1_2;
      end if;
      -- slice0winner5
      slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0_1 - slice0winner4_best_cost_0_0) < 0;
      slice0winner5_best_cost_1_0_is_less := (slice0winner4_best_cost_1_1 - slice0winner4_best_cost_1_0) < 0;
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
      if slice0winner5_best_cost_1_0_is_less then
        slice0winner5_best_cost_1_0 <= slice0winner4_best_cost_1_1;
        slice0winner5_best_index_1_0 <= slice0winner4_best_index_1_1;
      else
        slice0winner5_best_cost_1_0 <= slice0winner4_best_cost_1_0;
        slice0winner5_best_index_1_0 <= slice0winner4_best_index_1_0;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
      slice0_best_cost_1_0 <= slice0winner5_best_cost_1_0;
      slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 3;
      slice0_best_index_1_0 <= slice0winner5_best_index_1_0 + 3;
      slice0_best_tag_valid <= slice0winner5_tag_valid;
      slice0_best_tag_output_column <= slice0winner5_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner5_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner5_tag_end_of_line;
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
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
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
      slice1cost_difference_3_0 <= slice1shift_search_3_0 - slice1shift_reference_3;
      slice1cost_difference_3_1 <= slice1shift_search_3_1 - slice1shift_reference_3;
      slice1cost_difference_3_2 <= slice1shift_search_3_2 - slice1shift_reference_3;
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
      slice1cost_single_3_0 <= (folded(slice1cost_difference_3_0) + as_number((slice1cost_difference_3_0 < 0))) mod 256;
      slice1cost_single_3_1 <= (folded(slice1cost_difference_3_1) + as_number((slice1cost_difference_3_1 < 0))) mod 256;
      slice1cost_single_3_2 <= (folded(slice1cost_difference_3_2) + as_number((slice1cost_difference_3_2 < 0))) mod 256;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0 <= 0;
        slice1cost_column_0_1 <= 0;
        slice1cost_column_0_2 <= 0;
        slice1cost_column_1_0 <= 0;
        slice1cost_column_1_1 <= 0;
        slice1cost_column_1_2 <= 0;
      else
        slice1cost_column_0_0 <= slice1cost_pair_0_0 + as_number(slice1cost_negative_0_0) + slice1cost_single_0_0;
        slice1cost_column_0_1 <= slice1cost_pair_0_1 + as_number(slice1cost_negative_0_1) + slice1cost_single_0_1;
        slice1cost_column_0_2 <= slice1cost_pair_0_2 + as_number(slice1cost_negative_0_2) + slice1cost_single_0_2;
        slice1cost_column_1_0 <= slice1cost_pair_0_0 + as_number(slice1cost_negative_0_0) + slice1cost_single_3_0;
        slice1cost_column_1_1 <= slice1cost_pair_0_1 + as_number(slice1cost_negative_0_1) + slice1cost_single_3_1;
        slice1cost_column_1_2 <= slice1cost_pair_0_2 + as_number(slice1cost_negative_0_2) + slice1cost_single_3_2;
      end if;
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
      slice1winner1_best_cost_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_best_cost_1_0_is_less := (slice1window_sum_1_1 - slice1window_sum_1_0) < 0;
      slice1winner1_best_cost_0_1 <= slice1window_sum_0_2;
      slice1winner1_best_cost_1_1 <= slice1window_sum_1_2;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_index_0_1 <= 2;
      slice1winner1_best_index_1_0 <= slice1winner1_best_cost_1_0_is_less;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      if slice1winner1_best_cost_1_0_is_less then
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_1;
      else
        slice1winner1_best_cost_1_0 <= slice1window_sum_1_0;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_cost_1_0_is_less := (slice1winner1_best_cost_1_1 - slice1winner1_best_cost_1_0) < 0;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
      end if;
      if slice1winner2_best_cost_1_0_is_less then
        slice1winner2_best_cost_1_0 <= slice1winner1_best_cost_1_1;
        slice1winner2_best_index_1_0 <= slice1winner1_best_index_0_1;
      else
        slice1winner2_best_cost_1_0 <= slice1winner1_best_cost_1_0;
        slice1winner2_best_index_1_0 <= as_number(slice1winner1_best_index_1_0);
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
      slice1winner3_best_cost_1_0 <= slice1winner2_best_cost_1_0;
      slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
      slice1winner3_best_index_1_0 <= slice1winner2_best_index_1_0;
      -- slice1winner4
      slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_0;
      slice1winner4_best_cost_1_0 <= slice1winner3_best_cost_1_0;
      slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
      slice1winner4_best_index_1_0 <= slice1winner3_best_index_1_0;
      -- slice1winner5
      slice1winner5_best_cost_0_0 <= slice1winner4_best_cost_0_0;
      slice1winner5_best_cost_1_0 <= slice1winner4_best_cost_1_0;
      slice1winner5_best_index_0_0 <= slice1winner4_best_index_0_0;
      slice1winner5_best_index_1_0 <= slice1winner4_best_index_1_0;
      -- slice1
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0 then
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_index_0_0 <= slice1winner5_best_index_0_0;
      end if;
      if (slice0_best_cost_1_0 - slice1winner5_best_cost_1_0) < 0 then
        slice1_best_index_1_0 <= slice0_best_index_1_0;
      else
        slice1_best_index_1_0 <= slice1winner5_best_index_1_0;
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 7;
        raster_place_next_frame <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
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
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
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
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
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
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
      end if;
    end if;
  end process;
end architecture;
