-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, phase correlation, configuration tiny_phase_full: 40x18, 12 disparities, window 5x5, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 12, window_px 5, subpixel true, full_width true, slice_disparities 6.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_phase_full
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_phase_full is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 18;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 36;
    latency_clocks : positive := 41;
    flush_groups : positive := 255;
    gap_groups : natural := 0
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
  assert width_px = 40 report "stereo_core_tiny_phase_full: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 18 report "stereo_core_tiny_phase_full: height_px is " & integer'image(height_px) & " but this core has 18" severity failure;
  assert disparities = 12 report "stereo_core_tiny_phase_full: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_phase_full: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_phase_full: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 36 report "stereo_core_tiny_phase_full: output_width_px is " & integer'image(output_width_px) & " but this core has 36" severity failure;
  assert latency_clocks = 41 report "stereo_core_tiny_phase_full: latency_clocks is " & integer'image(latency_clocks) & " but this core has 41" severity failure;
  assert flush_groups = 255 report "stereo_core_tiny_phase_full: flush_groups is " & integer'image(flush_groups) & " but this core has 255" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_phase_full: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_phase_full is
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
  signal in_right_pixel : natural range 0 to 255;
  signal in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_words_2, transform_left_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_rows_write_words_2, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_words_2, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_right_rows_write_words_2, transform_left_column_0, transform_left_column_1 : natural range 0 to 255;
  signal transform_left_column_2, transform_left_column_3, transform_left_column_4 : natural range 0 to 255;
  signal transform_left_column_5, transform_left_column_6, transform_left_column_7 : natural range 0 to 255;
  signal transform_left_column_8, transform_left_column_9, transform_right_column_0 : natural range 0 to 255;
  signal transform_right_column_1, transform_right_column_2, transform_right_column_3 : natural range 0 to 255;
  signal transform_right_column_4, transform_right_column_5, transform_right_column_6 : natural range 0 to 255;
  signal transform_right_column_7, transform_right_column_8, transform_right_column_9 : natural range 0 to 255;
  signal transform_left_code_column_box_0_0_0, transform_left_code_column_box_0_1_0 : natural range 0 to 255;
  signal transform_left_code_column_box_0_2_0, transform_left_code_column_box_0_3_0 : natural range 0 to 255;
  signal transform_left_code_column_box_0_4_0, transform_left_code_column_centre : natural range 0 to 255;
  signal transform_right_code_column_box_0_0_0, transform_right_code_column_box_0_1_0 : natural range 0 to 255;
  signal transform_right_code_column_box_0_2_0, transform_right_code_column_box_0_3_0 : natural range 0 to 255;
  signal transform_right_code_column_box_0_4_0, transform_right_code_column_centre : natural range 0 to 255;
  signal transform_valid, transform_counter_next_frame, transform_from_first_0, transform_from_first_1 : boolean;
  signal transform_up_to_last_0, transform_up_to_last_1, transform_columns_inside_0 : boolean;
  signal transform_columns_inside_1, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_inside_0, transform_filtering_0_inside_1, transform_filtering_0_start_of_frame : boolean;
  signal transform_filtering_0_valid, transform_filtering_1_inside_0, transform_filtering_1_inside_1 : boolean;
  signal transform_filtering_1_start_of_frame, transform_filtering_1_valid, transform_filtering_2_inside_0 : boolean;
  signal transform_filtering_2_inside_1, transform_filtering_2_start_of_frame, transform_filtering_2_valid : boolean;
  signal transform_filtering_3_inside_0, transform_filtering_3_inside_1, transform_filtering_3_start_of_frame : boolean;
  signal transform_filtering_3_valid, transform_filtering_4_inside_0, transform_filtering_4_inside_1 : boolean;
  signal transform_filtering_4_start_of_frame, transform_filtering_4_valid, transform_filtering_5_inside_0 : boolean;
  signal transform_filtering_5_inside_1, transform_filtering_5_start_of_frame, transform_filtering_5_valid : boolean;
  signal transform_filtering_6_inside_0, transform_filtering_6_inside_1, transform_filtering_6_start_of_frame : boolean;
  signal transform_filtering_6_valid, transform_filtering_7_start_of_frame, transform_filtering_7_valid : boolean;
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 63;
  signal transform_write_column, transform_centre_column, transform_left_code_row_signs : natural range 0 to 63;
  signal transform_left_code_earlier_0, transform_left_code_earlier_1, transform_left_code_bits : natural range 0 to 63;
  signal transform_left_code_next_row_signs, transform_left_code_next_bits : natural range 0 to 63;
  signal transform_right_code_row_signs, transform_right_code_earlier_0 : natural range 0 to 63;
  signal transform_right_code_earlier_1, transform_right_code_bits : natural range 0 to 63;
  signal transform_right_code_next_row_signs, transform_right_code_next_bits : natural range 0 to 63;
  signal transform_counter_group : natural range 0 to 31;
  signal transform_left_rows_read_words_0, transform_left_rows_read_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_ready_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_left_rows_write_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0, transform_right_rows_read_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_ready_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_write_words_0, transform_right_rows_write_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_2, transform_right_rows_read_words_2 : unsigned(7 downto 0);
  signal transform_centre_group : natural range 0 to 32;
  signal transform_left_code_column_near, transform_left_code_column_outer : natural range 0 to 510;
  signal transform_left_code_next_column_box_0_0_0, transform_left_code_next_column_box_0_1_0 : natural range 0 to 510;
  signal transform_left_code_next_column_box_0_2_0, transform_left_code_next_column_box_0_3_0 : natural range 0 to 510;
  signal transform_left_code_next_column_box_0_4_0, transform_left_code_next_column_centre : natural range 0 to 510;
  signal transform_right_code_column_near, transform_right_code_column_outer : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_0_0 : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_1_0 : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_2_0 : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_3_0 : natural range 0 to 510;
  signal transform_right_code_next_column_box_0_4_0, transform_right_code_next_column_centre : natural range 0 to 510;
  signal transform_left_code_column_upper, transform_left_code_column_lower : natural range 0 to 765;
  signal transform_right_code_column_upper, transform_right_code_column_lower : natural range 0 to 765;
  signal transform_left_code_column_response_0, transform_left_code_column_response_1 : natural range 0 to 1021;
  signal transform_left_code_row_box_0_0, transform_left_code_row_box_0_1 : natural range 0 to 1021;
  signal transform_left_code_row_column_0_0, transform_left_code_row_column_0_1 : natural range 0 to 1021;
  signal transform_left_code_row_column_0_2, transform_left_code_row_column_0_3 : natural range 0 to 1021;
  signal transform_left_code_row_column_1_0, transform_left_code_row_column_1_1 : natural range 0 to 1021;
  signal transform_left_code_row_column_1_2, transform_left_code_row_column_1_3 : natural range 0 to 1021;
  signal transform_left_code_row_centre_0, transform_left_code_row_centre_1 : natural range 0 to 1021;
  signal transform_right_code_column_response_0, transform_right_code_column_response_1 : natural range 0 to 1021;
  signal transform_right_code_row_box_0_0, transform_right_code_row_box_0_1 : natural range 0 to 1021;
  signal transform_right_code_row_column_0_0, transform_right_code_row_column_0_1 : natural range 0 to 1021;
  signal transform_right_code_row_column_0_2, transform_right_code_row_column_0_3 : natural range 0 to 1021;
  signal transform_right_code_row_column_1_0, transform_right_code_row_column_1_1 : natural range 0 to 1021;
  signal transform_right_code_row_column_1_2, transform_right_code_row_column_1_3 : natural range 0 to 1021;
  signal transform_right_code_row_centre_0, transform_right_code_row_centre_1 : natural range 0 to 1021;
  signal transform_left_code_column_response_2, transform_left_code_row_box_0_2 : natural range 0 to 1530;
  signal transform_left_code_row_column_2_0, transform_left_code_row_column_2_1 : natural range 0 to 1530;
  signal transform_left_code_row_column_2_2, transform_left_code_row_column_2_3 : natural range 0 to 1530;
  signal transform_left_code_row_centre_2, transform_right_code_column_response_2 : natural range 0 to 1530;
  signal transform_right_code_row_box_0_2, transform_right_code_row_column_2_0 : natural range 0 to 1530;
  signal transform_right_code_row_column_2_1, transform_right_code_row_column_2_2 : natural range 0 to 1530;
  signal transform_right_code_row_column_2_3, transform_right_code_row_centre_2 : natural range 0 to 1530;
  signal transform_left_code_row_outer_1, transform_right_code_row_outer_1 : natural range 0 to 2042;
  signal transform_left_code_row_outer_2, transform_right_code_row_outer_2 : natural range 0 to 3060;
  signal transform_left_code_row_before_0, transform_left_code_row_before_1 : natural range 0 to 3063;
  signal transform_left_code_row_after_0, transform_left_code_row_after_1 : natural range 0 to 3063;
  signal transform_right_code_row_before_0, transform_right_code_row_before_1 : natural range 0 to 3063;
  signal transform_right_code_row_after_0, transform_right_code_row_after_1 : natural range 0 to 3063;
  signal transform_left_code_row_before_2, transform_left_code_row_after_2 : natural range 0 to 4591;
  signal transform_right_code_row_before_2, transform_right_code_row_after_2 : natural range 0 to 4591;
  signal transform_left_code_row_even_1, transform_left_code_row_even_2 : natural range 0 to 16383;
  signal transform_left_code_row_odd_1, transform_left_code_row_odd_2 : natural range 0 to 16383;
  signal transform_right_code_row_even_1, transform_right_code_row_even_2 : natural range 0 to 16383;
  signal transform_right_code_row_odd_1, transform_right_code_row_odd_2 : natural range 0 to 16383;
  signal transform_left_code_next_column_near, transform_left_code_next_column_outer : natural range 0 to 1020;
  signal transform_right_code_next_column_near, transform_right_code_next_column_outer : natural range 0 to 1020;
  signal transform_left_code_next_column_upper, transform_left_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_earlier_0_2_0, transform_left_code_next_row_box_0_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_column_2_0, transform_left_code_next_row_column_2_1 : natural range 0 to 65535;
  signal transform_left_code_next_row_column_2_2, transform_left_code_next_row_column_2_3 : natural range 0 to 65535;
  signal transform_left_code_next_row_column_2_4, transform_left_code_next_row_column_2_5 : natural range 0 to 65535;
  signal transform_left_code_next_row_column_2_6, transform_left_code_next_row_column_2_7 : natural range 0 to 65535;
  signal transform_left_code_next_row_outer_2, transform_left_code_next_row_before_2 : natural range 0 to 65535;
  signal transform_left_code_next_row_after_2, transform_left_code_next_row_even_1 : natural range 0 to 65535;
  signal transform_left_code_next_row_even_2, transform_left_code_next_row_odd_0 : natural range 0 to 65535;
  signal transform_left_code_next_row_odd_1, transform_left_code_next_row_odd_2 : natural range 0 to 65535;
  signal transform_right_code_next_column_upper, transform_right_code_next_column_response_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_earlier_0_2_0, transform_right_code_next_row_box_0_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_column_2_0, transform_right_code_next_row_column_2_1 : natural range 0 to 65535;
  signal transform_right_code_next_row_column_2_2, transform_right_code_next_row_column_2_3 : natural range 0 to 65535;
  signal transform_right_code_next_row_column_2_4, transform_right_code_next_row_column_2_5 : natural range 0 to 65535;
  signal transform_right_code_next_row_column_2_6, transform_right_code_next_row_column_2_7 : natural range 0 to 65535;
  signal transform_right_code_next_row_outer_2, transform_right_code_next_row_before_2 : natural range 0 to 65535;
  signal transform_right_code_next_row_after_2, transform_right_code_next_row_even_1 : natural range 0 to 65535;
  signal transform_right_code_next_row_even_2, transform_right_code_next_row_odd_0 : natural range 0 to 65535;
  signal transform_right_code_next_row_odd_1, transform_right_code_next_row_odd_2 : natural range 0 to 65535;
  signal transform_left_code_next_column_lower, transform_right_code_next_column_lower : natural range 0 to 1531;
  signal transform_left_code_next_column_response_0 : natural range 0 to 2041;
  signal transform_left_code_next_column_response_1 : natural range 0 to 2041;
  signal transform_left_code_next_row_earlier_0_0_0 : natural range 0 to 2041;
  signal transform_left_code_next_row_earlier_0_1_0 : natural range 0 to 2041;
  signal transform_right_code_next_column_response_0 : natural range 0 to 2041;
  signal transform_right_code_next_column_response_1 : natural range 0 to 2041;
  signal transform_right_code_next_row_earlier_0_0_0 : natural range 0 to 2041;
  signal transform_right_code_next_row_earlier_0_1_0 : natural range 0 to 2041;
  signal transform_left_code_next_row_box_0_0, transform_left_code_next_row_box_0_1 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_0_0, transform_left_code_next_row_column_0_1 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_0_2, transform_left_code_next_row_column_0_3 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_0_4, transform_left_code_next_row_column_0_5 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_0_6, transform_left_code_next_row_column_0_7 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_1_0, transform_left_code_next_row_column_1_1 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_1_2, transform_left_code_next_row_column_1_3 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_1_4, transform_left_code_next_row_column_1_5 : natural range 0 to 4082;
  signal transform_left_code_next_row_column_1_6, transform_left_code_next_row_column_1_7 : natural range 0 to 4082;
  signal transform_left_code_next_row_centre_0, transform_left_code_next_row_centre_1 : natural range 0 to 4082;
  signal transform_right_code_next_row_box_0_0, transform_right_code_next_row_box_0_1 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_0_0, transform_right_code_next_row_column_0_1 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_0_2, transform_right_code_next_row_column_0_3 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_0_4, transform_right_code_next_row_column_0_5 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_0_6, transform_right_code_next_row_column_0_7 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_1_0, transform_right_code_next_row_column_1_1 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_1_2, transform_right_code_next_row_column_1_3 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_1_4, transform_right_code_next_row_column_1_5 : natural range 0 to 4082;
  signal transform_right_code_next_row_column_1_6, transform_right_code_next_row_column_1_7 : natural range 0 to 4082;
  signal transform_right_code_next_row_centre_0, transform_right_code_next_row_centre_1 : natural range 0 to 4082;
  signal transform_left_code_next_row_centre_2, transform_right_code_next_row_centre_2 : natural range 0 to 32767;
  signal transform_left_code_next_row_outer_0, transform_left_code_next_row_outer_1 : natural range 0 to 8164;
  signal transform_right_code_next_row_outer_0, transform_right_code_next_row_outer_1 : natural range 0 to 8164;
  signal transform_left_code_next_row_before_0, transform_left_code_next_row_before_1 : natural range 0 to 12247;
  signal transform_left_code_next_row_after_0, transform_left_code_next_row_after_1 : natural range 0 to 12247;
  signal transform_right_code_next_row_before_0, transform_right_code_next_row_before_1 : natural range 0 to 12247;
  signal transform_right_code_next_row_after_0, transform_right_code_next_row_after_1 : natural range 0 to 12247;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 4095;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 31;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 15;
  signal delay_ahead_0 : natural range 0 to 4095;
  signal delay_delayed_0 : unsigned(11 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside_0, delay_row_inside_1, delay_row_inside_2, delay_row_inside_3, delay_row_inside_4 : boolean;
  signal delay_tag_valid, delay_tag_output_column, delay_tag_first_column, delay_tag_start_of_frame : boolean;
  signal delay_tag_end_of_line, delay_split_search_inside_0, delay_split_search_inside_1 : boolean;
  signal delay_split_search_inside_2, delay_split_search_inside_3, delay_split_search_inside_4 : boolean;
  signal delay_split_inside_before_0, delay_split_inside_before_1, delay_split_inside_before_2 : boolean;
  signal delay_split_inside_before_3, delay_split_inside_before_4, delay_split_whole_before : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 4095;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 4095;
  signal rows_search_1, rows_search_2, rows_search_3, rows_search_4, rows_reference_0 : natural range 0 to 4095;
  signal rows_reference_1, rows_reference_2, rows_reference_3, rows_reference_4 : natural range 0 to 4095;
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_inside_3, rows_read_inside_4 : boolean;
  signal rows_read_tag_valid, rows_read_tag_output_column, rows_read_tag_first_column : boolean;
  signal rows_read_tag_start_of_frame, rows_read_tag_end_of_line, rows_read_search_inside_0 : boolean;
  signal rows_read_search_inside_1, rows_read_search_inside_2, rows_read_search_inside_3 : boolean;
  signal rows_read_search_inside_4, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2 : boolean;
  signal rows_ready_inside_3, rows_ready_inside_4, rows_ready_tag_valid, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_ready_search_inside_0, rows_ready_search_inside_1, rows_ready_search_inside_2 : boolean;
  signal rows_ready_search_inside_3, rows_ready_search_inside_4, rows_tag_valid, rows_tag_output_column : boolean;
  signal rows_tag_first_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 4095;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 4095;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 4095;
  signal slice0shift_search_1_3, slice0shift_search_1_4, slice0shift_search_1_5 : natural range 0 to 4095;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 4095;
  signal slice0shift_search_2_3, slice0shift_search_2_4, slice0shift_search_2_5 : natural range 0 to 4095;
  signal slice0shift_search_3_0, slice0shift_search_3_1, slice0shift_search_3_2 : natural range 0 to 4095;
  signal slice0shift_search_3_3, slice0shift_search_3_4, slice0shift_search_3_5 : natural range 0 to 4095;
  signal slice0shift_search_4_0, slice0shift_search_4_1, slice0shift_search_4_2 : natural range 0 to 4095;
  signal slice0shift_search_4_3, slice0shift_search_4_4, slice0shift_search_4_5 : natural range 0 to 4095;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 4095;
  signal slice0shift_reference_3, slice0shift_reference_4, slice0shift_search_out_0 : natural range 0 to 4095;
  signal slice0shift_search_out_1, slice0shift_search_out_2, slice0shift_search_out_3 : natural range 0 to 4095;
  signal slice0shift_search_out_4 : natural range 0 to 4095;
  signal slice0shift_tag_valid, slice0shift_tag_output_column, slice0shift_tag_first_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1, slice0cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_3, slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_0, slice0cost_pixels_first_1_1, slice0cost_pixels_first_1_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_3, slice0cost_pixels_first_1_4, slice0cost_pixels_first_1_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_2_0, slice0cost_pixels_first_2_1, slice0cost_pixels_first_2_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_2_3, slice0cost_pixels_first_2_4, slice0cost_pixels_first_2_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_3_0, slice0cost_pixels_first_3_1, slice0cost_pixels_first_3_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_3_3, slice0cost_pixels_first_3_4, slice0cost_pixels_first_3_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_4_0, slice0cost_pixels_first_4_1, slice0cost_pixels_first_4_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_4_3, slice0cost_pixels_first_4_4, slice0cost_pixels_first_4_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_output_column : boolean;
  signal slice0cost_pixels_first_tag_first_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_output_column, slice0cost_pixels_tag_first_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_first_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_first_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_2_0, slice0cost_pixels_cost_2_1, slice0cost_pixels_cost_2_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_2_3, slice0cost_pixels_cost_2_4, slice0cost_pixels_cost_2_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_3_0, slice0cost_pixels_cost_3_1, slice0cost_pixels_cost_3_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_3_3, slice0cost_pixels_cost_3_4, slice0cost_pixels_cost_3_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_4_0, slice0cost_pixels_cost_4_1, slice0cost_pixels_cost_4_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_4_3, slice0cost_pixels_cost_4_4, slice0cost_pixels_cost_4_5 : natural range 0 to 19;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 19;
  signal slice0cost_single_0_3, slice0cost_single_0_4, slice0cost_single_0_5 : natural range 0 to 19;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2, slice0cost_pair_0_3 : natural range 0 to 38;
  signal slice0cost_pair_0_4, slice0cost_pair_0_5, slice0cost_pair_1_0, slice0cost_pair_1_1 : natural range 0 to 38;
  signal slice0cost_pair_1_2, slice0cost_pair_1_3, slice0cost_pair_1_4, slice0cost_pair_1_5 : natural range 0 to 38;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 95;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 95;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 95;
  signal slice0window_partial_0_0_3, slice0window_partial_0_0_4, slice0window_partial_0_0_5 : natural range 0 to 95;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 190;
  signal slice0window_partial_0_1_3, slice0window_partial_0_1_4, slice0window_partial_0_1_5 : natural range 0 to 190;
  signal slice0window_partial_0_2_0, slice0window_partial_0_2_1, slice0window_partial_0_2_2 : natural range 0 to 285;
  signal slice0window_partial_0_2_3, slice0window_partial_0_2_4, slice0window_partial_0_2_5 : natural range 0 to 285;
  signal slice0window_partial_0_3_0, slice0window_partial_0_3_1, slice0window_partial_0_3_2 : natural range 0 to 380;
  signal slice0window_partial_0_3_3, slice0window_partial_0_3_4, slice0window_partial_0_3_5 : natural range 0 to 380;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_first_column_1, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_start_of_frame_1, slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 475;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 475;
  -- slice0mask
  signal slice0mask_inside_0, slice0mask_inside_1, slice0mask_inside_2, slice0mask_inside_3 : boolean;
  signal slice0mask_inside_4, slice0mask_inside_5, slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 63;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1, slice0winner1_best_cost_0_2 : natural range 0 to 511;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 511;
  signal slice0winner1_best_below_0_2, slice0winner1_best_above_0_0 : natural range 0 to 511;
  signal slice0winner1_best_above_0_1, slice0winner1_best_above_0_2 : natural range 0 to 511;
  signal slice0winner1_best_first_0_0, slice0winner1_best_first_0_1 : natural range 0 to 511;
  signal slice0winner1_best_first_0_2, slice0winner1_best_last_0_0 : natural range 0 to 511;
  signal slice0winner1_best_last_0_1 : natural range 0 to 511;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 511;
  signal slice0winner2_best_below_0_0, slice0winner2_best_below_0_1 : natural range 0 to 511;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 511;
  signal slice0winner2_best_first_0_0, slice0winner2_best_first_0_1 : natural range 0 to 511;
  signal slice0winner2_best_last_0_0 : natural range 0 to 511;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 5;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_below_0_0 : natural range 0 to 511;
  signal slice0winner3_best_above_0_0, slice0winner3_best_first_0_0 : natural range 0 to 511;
  signal slice0winner3_best_index_0_0 : natural range 0 to 5;
  signal slice0winner3_tag_valid, slice0winner3_tag_output_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0 : natural range 0 to 511;
  signal slice0_best_first_0_0 : natural range 0 to 511;
  signal slice0_best_index_0_0 : natural range 0 to 11;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 4095;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 4095;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 4095;
  signal slice1shift_search_1_3, slice1shift_search_1_4, slice1shift_search_1_5 : natural range 0 to 4095;
  signal slice1shift_search_2_0, slice1shift_search_2_1, slice1shift_search_2_2 : natural range 0 to 4095;
  signal slice1shift_search_2_3, slice1shift_search_2_4, slice1shift_search_2_5 : natural range 0 to 4095;
  signal slice1shift_search_3_0, slice1shift_search_3_1, slice1shift_search_3_2 : natural range 0 to 4095;
  signal slice1shift_search_3_3, slice1shift_search_3_4, slice1shift_search_3_5 : natural range 0 to 4095;
  signal slice1shift_search_4_0, slice1shift_search_4_1, slice1shift_search_4_2 : natural range 0 to 4095;
  signal slice1shift_search_4_3, slice1shift_search_4_4, slice1shift_search_4_5 : natural range 0 to 4095;
  signal slice1shift_reference_0, slice1shift_reference_1, slice1shift_reference_2 : natural range 0 to 4095;
  signal slice1shift_reference_3, slice1shift_reference_4 : natural range 0 to 4095;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1, slice1cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_3, slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_0, slice1cost_pixels_first_1_1, slice1cost_pixels_first_1_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_3, slice1cost_pixels_first_1_4, slice1cost_pixels_first_1_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_2_0, slice1cost_pixels_first_2_1, slice1cost_pixels_first_2_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_2_3, slice1cost_pixels_first_2_4, slice1cost_pixels_first_2_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_3_0, slice1cost_pixels_first_3_1, slice1cost_pixels_first_3_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_3_3, slice1cost_pixels_first_3_4, slice1cost_pixels_first_3_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_4_0, slice1cost_pixels_first_4_1, slice1cost_pixels_first_4_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_4_3, slice1cost_pixels_first_4_4, slice1cost_pixels_first_4_5 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_2_0, slice1cost_pixels_cost_2_1, slice1cost_pixels_cost_2_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_2_3, slice1cost_pixels_cost_2_4, slice1cost_pixels_cost_2_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_3_0, slice1cost_pixels_cost_3_1, slice1cost_pixels_cost_3_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_3_3, slice1cost_pixels_cost_3_4, slice1cost_pixels_cost_3_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_4_0, slice1cost_pixels_cost_4_1, slice1cost_pixels_cost_4_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_4_3, slice1cost_pixels_cost_4_4, slice1cost_pixels_cost_4_5 : natural range 0 to 19;
  signal slice1cost_single_0_0, slice1cost_single_0_1, slice1cost_single_0_2 : natural range 0 to 19;
  signal slice1cost_single_0_3, slice1cost_single_0_4, slice1cost_single_0_5 : natural range 0 to 19;
  signal slice1cost_pair_0_0, slice1cost_pair_0_1, slice1cost_pair_0_2, slice1cost_pair_0_3 : natural range 0 to 38;
  signal slice1cost_pair_0_4, slice1cost_pair_0_5, slice1cost_pair_1_0, slice1cost_pair_1_1 : natural range 0 to 38;
  signal slice1cost_pair_1_2, slice1cost_pair_1_3, slice1cost_pair_1_4, slice1cost_pair_1_5 : natural range 0 to 38;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 95;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 95;
  signal slice1cost_tag_first_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0_0, slice1window_partial_0_0_1, slice1window_partial_0_0_2 : natural range 0 to 95;
  signal slice1window_partial_0_0_3, slice1window_partial_0_0_4, slice1window_partial_0_0_5 : natural range 0 to 95;
  signal slice1window_partial_0_1_0, slice1window_partial_0_1_1, slice1window_partial_0_1_2 : natural range 0 to 190;
  signal slice1window_partial_0_1_3, slice1window_partial_0_1_4, slice1window_partial_0_1_5 : natural range 0 to 190;
  signal slice1window_partial_0_2_0, slice1window_partial_0_2_1, slice1window_partial_0_2_2 : natural range 0 to 285;
  signal slice1window_partial_0_2_3, slice1window_partial_0_2_4, slice1window_partial_0_2_5 : natural range 0 to 285;
  signal slice1window_partial_0_3_0, slice1window_partial_0_3_1, slice1window_partial_0_3_2 : natural range 0 to 380;
  signal slice1window_partial_0_3_3, slice1window_partial_0_3_4, slice1window_partial_0_3_5 : natural range 0 to 380;
  signal slice1window_centre_output_column_0, slice1window_centre_first_column_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 475;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 475;
  -- slice1mask
  signal slice1mask_inside_0, slice1mask_inside_1, slice1mask_inside_2, slice1mask_inside_3 : boolean;
  signal slice1mask_inside_4, slice1mask_inside_5 : boolean;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1, slice1winner1_best_cost_0_2 : natural range 0 to 511;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 511;
  signal slice1winner1_best_below_0_2, slice1winner1_best_above_0_0 : natural range 0 to 511;
  signal slice1winner1_best_above_0_1, slice1winner1_best_above_0_2 : natural range 0 to 511;
  signal slice1winner1_best_first_0_1, slice1winner1_best_first_0_2 : natural range 0 to 511;
  signal slice1winner1_best_last_0_0, slice1winner1_best_last_0_1, slice1winner1_best_last_0_2 : natural range 0 to 511;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 511;
  signal slice1winner2_best_below_0_0, slice1winner2_best_below_0_1 : natural range 0 to 511;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_0_1 : natural range 0 to 511;
  signal slice1winner2_best_first_0_1, slice1winner2_best_last_0_0 : natural range 0 to 511;
  signal slice1winner2_best_last_0_1 : natural range 0 to 511;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 5;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_below_0_0 : natural range 0 to 511;
  signal slice1winner3_best_above_0_0, slice1winner3_best_last_0_0 : natural range 0 to 511;
  signal slice1winner3_best_index_0_0 : natural range 0 to 5;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 511;
  signal slice1_best_index_0_0 : natural range 0 to 11;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 11;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 11;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 11;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 11;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0 : boolean;
  signal refinement_passed_8_0, refinement_passed_9_0, refinement_passed_10_0, refinement_passed_11_0 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_output_column, refinement_tag_0_start_of_frame : boolean;
  signal refinement_tag_0_end_of_line, refinement_tag_1_valid, refinement_tag_1_output_column : boolean;
  signal refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line, refinement_tag_2_valid : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_output_column, refinement_tag_3_start_of_frame : boolean;
  signal refinement_tag_3_end_of_line, refinement_tag_4_valid, refinement_tag_4_output_column : boolean;
  signal refinement_tag_4_start_of_frame, refinement_tag_4_end_of_line, refinement_tag_5_valid : boolean;
  signal refinement_tag_5_output_column, refinement_tag_5_start_of_frame, refinement_tag_5_end_of_line : boolean;
  signal refinement_tag_6_valid, refinement_tag_6_output_column, refinement_tag_6_start_of_frame : boolean;
  signal refinement_tag_6_end_of_line, refinement_tag_7_valid, refinement_tag_7_output_column : boolean;
  signal refinement_tag_7_start_of_frame, refinement_tag_7_end_of_line, refinement_tag_8_valid : boolean;
  signal refinement_tag_8_output_column, refinement_tag_8_start_of_frame, refinement_tag_8_end_of_line : boolean;
  signal refinement_tag_9_valid, refinement_tag_9_output_column, refinement_tag_9_start_of_frame : boolean;
  signal refinement_tag_9_end_of_line, refinement_tag_10_valid, refinement_tag_10_output_column : boolean;
  signal refinement_tag_10_start_of_frame, refinement_tag_10_end_of_line, refinement_tag_11_valid : boolean;
  signal refinement_tag_11_output_column, refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line : boolean;
  signal refinement_negative_0_0, refinement_negative_1_0, refinement_negative_2_0, refinement_negative_3_0 : boolean;
  signal refinement_negative_4_0, refinement_negative_5_0, refinement_negative_6_0, refinement_negative_7_0 : boolean;
  signal refinement_negative_8_0 : boolean;
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 511;
  signal refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 511;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 511;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 511;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 511;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 511;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 511;
  signal refinement_difference_0 : integer range -511 to 511;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0 : natural range 0 to 254;
  signal other_1 : natural range 0 to 252;
  signal other_2 : natural range 0 to 248;
  signal other_3 : natural range 0 to 240;
  signal other_4 : natural range 0 to 224;
  signal other_5 : natural range 0 to 192;
  signal other_6 : natural range 0 to 128;
  signal other_7 : boolean;
  signal other_8, other_12 : natural range 0 to 65534;
  signal other_9, other_10, other_13, other_14 : natural range 0 to 8192;
  signal other_11, other_15 : natural range 0 to 2042;
  signal other_16, other_17 : natural range 0 to 257;
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(3 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(11 downto 0);
  signal transform_left_rows_read_words_2_memory_read_enable : boolean;
  signal transform_left_rows_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal transform_left_rows_read_words_1_memory_read_enable : boolean;
  signal transform_left_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_2_memory_read_enable : boolean;
  signal transform_right_rows_read_words_2_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_2_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal transform_right_rows_read_words_1_memory_read_enable : boolean;
  signal transform_right_rows_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  rows_search_rows_read_words_1_memory_read_enable <= true;
  rows_search_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_1_memory_write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
  rows_search_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_1_memory_read_enable,
      read_address => rows_search_rows_read_words_1_memory_read_address, read_data => rows_search_rows_read_words_1,
      write_address => rows_search_rows_read_words_1_memory_write_address, write_data => rows_search_rows_read_words_1_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_1_memory_read_enable <= true;
  rows_reference_rows_read_words_1_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_1_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_1_memory_write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
  rows_reference_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_1_memory_read_enable,
      read_address => rows_reference_rows_read_words_1_memory_read_address, read_data => rows_reference_rows_read_words_1,
      write_address => rows_reference_rows_read_words_1_memory_write_address, write_data => rows_reference_rows_read_words_1_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 6);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 6);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 24, address_bits => 6)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 4);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 4);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 12);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 12, width => 12, address_bits => 4)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  transform_left_rows_read_words_2_memory_read_enable <= true;
  transform_left_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_2_memory_write_data <= to_unsigned(transform_left_rows_write_words_2, 8);
  transform_left_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 40, width => 8, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_2_memory_read_enable,
      read_address => transform_left_rows_read_words_2_memory_read_address, read_data => transform_left_rows_read_words_2,
      write_address => transform_left_rows_read_words_2_memory_write_address, write_data => transform_left_rows_read_words_2_memory_write_data);

  transform_left_rows_read_words_1_memory_read_enable <= true;
  transform_left_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_1_memory_write_data <= transform_left_rows_write_words_1;
  transform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_1_memory_read_enable,
      read_address => transform_left_rows_read_words_1_memory_read_address, read_data => transform_left_rows_read_words_1,
      write_address => transform_left_rows_read_words_1_memory_write_address, write_data => transform_left_rows_read_words_1_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_2_memory_read_enable <= true;
  transform_right_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_2_memory_write_data <= to_unsigned(transform_right_rows_write_words_2, 8);
  transform_right_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 40, width => 8, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_2_memory_read_enable,
      read_address => transform_right_rows_read_words_2_memory_read_address, read_data => transform_right_rows_read_words_2,
      write_address => transform_right_rows_read_words_2_memory_write_address, write_data => transform_right_rows_read_words_2_memory_write_data);

  transform_right_rows_read_words_1_memory_read_enable <= true;
  transform_right_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_1_memory_write_data <= transform_right_rows_write_words_1;
  transform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_1_memory_read_enable,
      read_address => transform_right_rows_read_words_1_memory_read_address, read_data => transform_right_rows_read_words_1,
      write_address => transform_right_rows_read_words_1_memory_write_address, write_data => transform_right_rows_read_words_1_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 6);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 6);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 32, address_bits => 6)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_choice_2 : boolean;
    variable transform_counter_group_is_equal_3, transform_centre_column_any, transform_from_first_0_is_equal : boolean;
    variable transform_from_first_0_value, transform_from_first_1_is_equal, transform_from_first_1_value : boolean;
    variable transform_from_first_1_choice, transform_from_first_1_choice_2, transform_up_to_last_0_choice : boolean;
    variable transform_up_to_last_0_is_equal, transform_up_to_last_0_choice_2 : boolean;
    variable transform_counter_next_frame_choice, raster_place_group_is_equal, raster_place_group_is_equal_2 : boolean;
    variable raster_place_group_all, raster_place_group_is_equal_3, raster_place_next_frame_choice : boolean;
    variable raster_place_next_frame_choice_2, raster_place_next_frame_choice_3, delay_row_inside_0_all : boolean;
    variable delay_row_inside_0_all_2, delay_row_inside_0_is_less, delay_row_inside_1_all : boolean;
    variable delay_row_inside_1_all_2, delay_row_inside_2_all, delay_row_inside_2_is_less : boolean;
    variable delay_row_inside_2_choice, delay_row_inside_3_all, delay_row_inside_3_all_2 : boolean;
    variable delay_row_inside_4_all, delay_tag_output_column_all, delay_tag_output_column_is_less : boolean;
    variable delay_tag_first_column_is_equal, delay_split_inside_before_0_all : boolean;
    variable slice0cost_pixels_first_0_0_value, slice0cost_pixels_first_0_0_value_2 : boolean;
    variable slice0cost_pixels_first_0_0_value_3, slice0cost_pixels_first_0_0_value_4 : boolean;
    variable slice0cost_pixels_first_0_0_value_5, slice0cost_pixels_first_0_0_value_6 : boolean;
    variable slice0cost_pixels_first_0_0_value_7, slice0cost_pixels_first_0_0_value_8 : boolean;
    variable slice0cost_pixels_first_0_0_value_9, slice0cost_pixels_first_0_0_value_10 : boolean;
    variable slice0cost_pixels_first_1_0_value, slice0cost_pixels_first_1_0_value_2 : boolean;
    variable slice0cost_pixels_first_1_0_value_3, slice0cost_pixels_first_1_0_value_4 : boolean;
    variable slice0cost_pixels_first_1_0_value_5, slice0cost_pixels_first_1_0_value_6 : boolean;
    variable slice0cost_pixels_first_1_0_value_7, slice0cost_pixels_first_1_0_value_8 : boolean;
    variable slice0cost_pixels_first_1_0_value_9, slice0cost_pixels_first_1_0_value_10 : boolean;
    variable slice0cost_pixels_first_2_0_value, slice0cost_pixels_first_2_0_value_2 : boolean;
    variable slice0cost_pixels_first_2_0_value_3, slice0cost_pixels_first_2_0_value_4 : boolean;
    variable slice0cost_pixels_first_2_0_value_5, slice0cost_pixels_first_2_0_value_6 : boolean;
    variable slice0cost_pixels_first_2_0_value_7, slice0cost_pixels_first_2_0_value_8 : boolean;
    variable slice0cost_pixels_first_2_0_value_9, slice0cost_pixels_first_2_0_value_10 : boolean;
    variable slice0cost_pixels_first_3_0_value, slice0cost_pixels_first_3_0_value_2 : boolean;
    variable slice0cost_pixels_first_3_0_value_3, slice0cost_pixels_first_3_0_value_4 : boolean;
    variable slice0cost_pixels_first_3_0_value_5, slice0cost_pixels_first_3_0_value_6 : boolean;
    variable slice0cost_pixels_first_3_0_value_7, slice0cost_pixels_first_3_0_value_8 : boolean;
    variable slice0cost_pixels_first_3_0_value_9, slice0cost_pixels_first_3_0_value_10 : boolean;
    variable slice0cost_pixels_first_4_0_value, slice0cost_pixels_first_4_0_value_2 : boolean;
    variable slice0cost_pixels_first_4_0_value_3, slice0cost_pixels_first_4_0_value_4 : boolean;
    variable slice0cost_pixels_first_4_0_value_5, slice0cost_pixels_first_4_0_value_6 : boolean;
    variable slice0cost_pixels_first_4_0_value_7, slice0cost_pixels_first_4_0_value_8 : boolean;
    variable slice0cost_pixels_first_4_0_value_9, slice0cost_pixels_first_4_0_value_10 : boolean;
    variable slice0mask_inside_0_choice, slice0mask_inside_1_choice, slice0mask_inside_2_choice : boolean;
    variable slice0mask_inside_3_choice, slice0mask_inside_4_choice, slice0mask_inside_5_choice : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner1_best_cost_0_1_is_less : boolean;
    variable slice0winner1_best_cost_0_2_is_less, slice0winner2_best_cost_0_0_is_less : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice1cost_pixels_first_0_0_value : boolean;
    variable slice1cost_pixels_first_0_0_value_2, slice1cost_pixels_first_0_0_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_value_4, slice1cost_pixels_first_0_0_value_5 : boolean;
    variable slice1cost_pixels_first_0_0_value_6, slice1cost_pixels_first_0_0_value_7 : boolean;
    variable slice1cost_pixels_first_0_0_value_8, slice1cost_pixels_first_0_0_value_9 : boolean;
    variable slice1cost_pixels_first_0_0_value_10, slice1cost_pixels_first_1_0_value : boolean;
    variable slice1cost_pixels_first_1_0_value_2, slice1cost_pixels_first_1_0_value_3 : boolean;
    variable slice1cost_pixels_first_1_0_value_4, slice1cost_pixels_first_1_0_value_5 : boolean;
    variable slice1cost_pixels_first_1_0_value_6, slice1cost_pixels_first_1_0_value_7 : boolean;
    variable slice1cost_pixels_first_1_0_value_8, slice1cost_pixels_first_1_0_value_9 : boolean;
    variable slice1cost_pixels_first_1_0_value_10, slice1cost_pixels_first_2_0_value : boolean;
    variable slice1cost_pixels_first_2_0_value_2, slice1cost_pixels_first_2_0_value_3 : boolean;
    variable slice1cost_pixels_first_2_0_value_4, slice1cost_pixels_first_2_0_value_5 : boolean;
    variable slice1cost_pixels_first_2_0_value_6, slice1cost_pixels_first_2_0_value_7 : boolean;
    variable slice1cost_pixels_first_2_0_value_8, slice1cost_pixels_first_2_0_value_9 : boolean;
    variable slice1cost_pixels_first_2_0_value_10, slice1cost_pixels_first_3_0_value : boolean;
    variable slice1cost_pixels_first_3_0_value_2, slice1cost_pixels_first_3_0_value_3 : boolean;
    variable slice1cost_pixels_first_3_0_value_4, slice1cost_pixels_first_3_0_value_5 : boolean;
    variable slice1cost_pixels_first_3_0_value_6, slice1cost_pixels_first_3_0_value_7 : boolean;
    variable slice1cost_pixels_first_3_0_value_8, slice1cost_pixels_first_3_0_value_9 : boolean;
    variable slice1cost_pixels_first_3_0_value_10, slice1cost_pixels_first_4_0_value : boolean;
    variable slice1cost_pixels_first_4_0_value_2, slice1cost_pixels_first_4_0_value_3 : boolean;
    variable slice1cost_pixels_first_4_0_value_4, slice1cost_pixels_first_4_0_value_5 : boolean;
    variable slice1cost_pixels_first_4_0_value_6, slice1cost_pixels_first_4_0_value_7 : boolean;
    variable slice1cost_pixels_first_4_0_value_8, slice1cost_pixels_first_4_0_value_9 : boolean;
    variable slice1cost_pixels_first_4_0_value_10, slice1mask_inside_0_choice, slice1mask_inside_1_choice : boolean;
    variable slice1mask_inside_2_choice, slice1mask_inside_3_choice, slice1mask_inside_4_choice : boolean;
    variable slice1mask_inside_5_choice, slice1winner1_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_1_is_less, slice1winner1_best_cost_0_2_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner3_best_cost_0_0_is_less : boolean;
    variable slice1_best_cost_0_0_is_less, refinement_below_0_differs, refinement_below_0_differs_2 : boolean;
    variable refinement_below_0_all, refinement_above_0_choice, refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 9;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 31;
    variable raster_place_group_choice_2, raster_place_group_choice_3 : natural range 0 to 31;
    variable transform_centre_column_choice : natural range 9 to 15;
    variable slice0winner1_best_cost_0_0_choice, slice0winner1_best_cost_0_0_any : natural range 0 to 511;
    variable slice0winner1_best_cost_0_0_choice_2, slice0winner1_best_cost_0_0_any_2 : natural range 0 to 511;
    variable slice0winner1_best_cost_0_1_choice, slice0winner1_best_cost_0_1_any : natural range 0 to 511;
    variable slice0winner1_best_cost_0_1_choice_2, slice0winner1_best_cost_0_1_any_2 : natural range 0 to 511;
    variable slice0winner1_best_cost_0_2_choice, slice0winner1_best_cost_0_2_any : natural range 0 to 511;
    variable slice0winner1_best_cost_0_2_choice_2, slice0winner1_best_cost_0_2_any_2 : natural range 0 to 511;
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_above_0_0_choice : natural range 0 to 511;
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice : natural range 0 to 511;
    variable slice1winner1_best_cost_0_0_choice, slice1winner1_best_cost_0_0_any : natural range 0 to 511;
    variable slice1winner1_best_cost_0_0_choice_2, slice1winner1_best_cost_0_0_any_2 : natural range 0 to 511;
    variable slice1winner1_best_cost_0_1_choice, slice1winner1_best_cost_0_1_any : natural range 0 to 511;
    variable slice1winner1_best_cost_0_1_choice_2, slice1winner1_best_cost_0_1_any_2 : natural range 0 to 511;
    variable slice1winner1_best_cost_0_2_choice, slice1winner1_best_cost_0_2_any : natural range 0 to 511;
    variable slice1winner1_best_cost_0_2_choice_2, slice1winner1_best_cost_0_2_any_2 : natural range 0 to 511;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_above_0_0_choice : natural range 0 to 511;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_above_0_0_choice : natural range 0 to 511;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 511;
    variable refinement_divisor_0_0_choice : natural range 0 to 511;
    variable refinement_remainder_1_0_difference : natural range 513 to 1535;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 513 to 2046;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 513 to 2046;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 513 to 2046;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 39;
      transform_counter_group_is_equal_2 := transform_counter_group = 17;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 9;
      else
        transform_counter_group_choice := 0;
      end if;
      if (transform_counter_group / 2) = 11 then
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid and ((transform_counter_group
          mod 2) = 1);
      else
        transform_counter_group_choice_2 := transform_counter_group_is_equal and in_valid;
      end if;
      transform_counter_group_is_equal_3 := transform_counter_group = 21;
      if transform_counter_next_frame and transform_counter_group_is_equal_3 then
        transform_counter_group_choice_3 := 4;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 32;
      end if;
      if transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      transform_centre_column_any := ((transform_counter_column / 32) = 1) or (((transform_counter_column / 16) mod 2)
        = 1) or (((transform_counter_column / 8) mod 2) = 1) or (((transform_counter_column / 4) mod 2) = 1);
      if transform_centre_column_any then
        transform_centre_column_choice := 15;
      else
        transform_centre_column_choice := 9;
      end if;
      transform_from_first_0_is_equal := ((transform_centre_column / 4) mod 8) = 0;
      transform_from_first_0_value := ((transform_centre_column / 2) mod 2) = 1;
      transform_from_first_1_is_equal := ((transform_centre_column / 4) mod 4) = 0;
      transform_from_first_1_value := ((transform_centre_column / 8) mod 2) = 1;
      if transform_from_first_0_value then
        transform_from_first_1_choice := transform_from_first_1_is_equal;
      else
        transform_from_first_1_choice := not transform_from_first_1_value;
      end if;
      if (transform_centre_column mod 2) = 1 then
        transform_from_first_1_choice_2 := transform_from_first_1_is_equal;
      else
        transform_from_first_1_choice_2 := transform_from_first_1_choice;
      end if;
      if transform_from_first_0_value then
        transform_up_to_last_0_choice := transform_from_first_0_is_equal;
      else
        transform_up_to_last_0_choice := ((transform_centre_column / 8) mod 4) = 0;
      end if;
      transform_up_to_last_0_is_equal := (transform_centre_group / 16) = 0;
      if (not (((transform_centre_group / 8) mod 2) = 1)) and ((not (((transform_centre_group / 4) mod 2) = 1)) or
        ((transform_centre_group mod 4) = 0)) then
        transform_up_to_last_0_choice_2 := not ((transform_centre_group / 32) = 1);
      else
        transform_up_to_last_0_choice_2 := transform_up_to_last_0_is_equal;
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_words_1 <= transform_left_rows_read_words_1;
      transform_left_rows_ready_words_2 <= to_integer(transform_left_rows_read_words_2);
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_words_1 <= transform_right_rows_read_words_1;
      transform_right_rows_ready_words_2 <= to_integer(transform_right_rows_read_words_2);
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_ready_column <= transform_read_column;
      transform_centre_column <= (((transform_centre_column_choice + (transform_counter_column / 4)) mod 16) * 4) +
        (transform_counter_column mod 4);
      transform_centre_group <= transform_counter_group + as_number(transform_centre_column_any);
      transform_left_column_0 <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column_1 <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column_2 <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column_3 <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column_4 <= to_integer(transform_left_rows_ready_words_1(7 downto 0));
      transform_left_column_5 <= to_integer(transform_left_rows_ready_words_1(15 downto 8));
      transform_left_column_6 <= to_integer(transform_left_rows_ready_words_1(23 downto 16));
      transform_left_column_7 <= to_integer(transform_left_rows_ready_words_1(31 downto 24));
      transform_left_column_8 <= transform_left_rows_ready_words_2;
      transform_left_column_9 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_1 <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_3 <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column_4 <= to_integer(transform_right_rows_ready_words_1(7 downto 0));
      transform_right_column_5 <= to_integer(transform_right_rows_ready_words_1(15 downto 8));
      transform_right_column_6 <= to_integer(transform_right_rows_ready_words_1(23 downto 16));
      transform_right_column_7 <= to_integer(transform_right_rows_ready_words_1(31 downto 24));
      transform_right_column_8 <= transform_right_rows_ready_words_2;
      transform_right_column_9 <= transform_right_rows_ready_newest_0;
      transform_columns_inside_0 <= transform_up_to_last_0 and transform_from_first_0;
      transform_columns_inside_1 <= transform_up_to_last_1 and transform_from_first_1;
      transform_columns_start_of_frame <= (other_16 mod 2) = 1;
      transform_columns_valid <= (other_16 / 256) = 1;
      transform_left_code_column_box_0_0_0 <= transform_left_column_3;
      transform_left_code_column_box_0_1_0 <= transform_left_column_4;
      transform_left_code_column_box_0_2_0 <= transform_left_column_5;
      transform_left_code_column_box_0_3_0 <= transform_left_column_6;
      transform_left_code_column_box_0_4_0 <= transform_left_column_7;
      transform_left_code_column_centre <= transform_left_code_column_box_0_2_0;
      transform_left_code_column_near <= transform_left_code_column_box_0_1_0 + transform_left_code_column_box_0_3_0;
      transform_left_code_column_outer <= (510 - transform_left_code_column_box_0_4_0) -
        transform_left_code_column_box_0_0_0;
      transform_left_code_column_upper <= 765 - (((transform_left_code_column_box_0_1_0 +
        (transform_left_code_column_box_0_0_0 / 2)) * 2) + (transform_left_code_column_box_0_0_0 mod 2));
      transform_left_code_column_lower <= ((transform_left_code_column_box_0_3_0 +
        (transform_left_code_column_box_0_4_0 / 2)) * 2) + (transform_left_code_column_box_0_4_0 mod 2);
      transform_left_code_column_response_0 <= ((transform_left_code_column_centre + (transform_left_code_column_near /
        2)) * 2) + (transform_left_code_column_near mod 2);
      transform_left_code_column_response_1 <= ((transform_left_code_column_centre + (transform_left_code_column_outer
        / 2)) * 2) + (transform_left_code_column_outer mod 2);
      transform_left_code_column_response_2 <= transform_left_code_column_upper + transform_left_code_column_lower;
      transform_left_code_row_box_0_0 <= transform_left_code_column_response_0;
      transform_left_code_row_box_0_1 <= transform_left_code_column_response_1;
      transform_left_code_row_box_0_2 <= transform_left_code_column_response_2;
      transform_left_code_row_centre_0 <= transform_left_code_row_column_0_1;
      transform_left_code_row_centre_1 <= transform_left_code_row_column_1_1;
      transform_left_code_row_centre_2 <= transform_left_code_row_column_2_1;
      transform_left_code_row_outer_1 <= transform_left_code_row_box_0_1 + transform_left_code_row_column_1_3;
      transform_left_code_row_outer_2 <= transform_left_code_row_box_0_2 + transform_left_code_row_column_2_3;
      transform_left_code_row_before_0 <= ((transform_left_code_row_column_0_2 + (transform_left_code_row_column_0_3 /
        2)) * 2) + (transform_left_code_row_column_0_3 mod 2);
      transform_left_code_row_before_1 <= ((transform_left_code_row_column_1_2 + (transform_left_code_row_column_1_3 /
        2)) * 2) + (transform_left_code_row_column_1_3 mod 2);
      transform_left_code_row_before_2 <= ((transform_left_code_row_column_2_2 + (transform_left_code_row_column_2_3 /
        2)) * 2) + (transform_left_code_row_column_2_3 mod 2);
      transform_left_code_row_after_0 <= (((transform_left_code_row_box_0_0 / 2) + transform_left_code_row_column_0_0)
        * 2) + (transform_left_code_row_box_0_0 mod 2);
      transform_left_code_row_after_1 <= (((transform_left_code_row_box_0_1 / 2) + transform_left_code_row_column_1_0)
        * 2) + (transform_left_code_row_box_0_1 mod 2);
      transform_left_code_row_after_2 <= (((transform_left_code_row_box_0_2 / 2) + transform_left_code_row_column_2_0)
        * 2) + (transform_left_code_row_box_0_2 mod 2);
      transform_left_code_row_even_1 <= ((((transform_left_code_row_outer_1 / 2) - transform_left_code_row_centre_1)
        mod 8192) * 2) + (transform_left_code_row_outer_1 mod 2);
      transform_left_code_row_even_2 <= ((((transform_left_code_row_outer_2 / 2) - transform_left_code_row_centre_2)
        mod 8192) * 2) + (transform_left_code_row_outer_2 mod 2);
      transform_left_code_row_odd_1 <= (transform_left_code_row_before_1 - transform_left_code_row_after_1) mod 16384;
      transform_left_code_row_odd_2 <= (transform_left_code_row_before_2 - transform_left_code_row_after_2) mod 16384;
      transform_left_code_row_signs <= ((other_13 / 8192) * 2) + (other_14 / 8192) + ((((transform_left_code_row_even_2
        + transform_left_code_row_odd_1) mod 16384) / 8192) * 8) + ((((transform_left_code_row_odd_1 -
        transform_left_code_row_even_2) mod 16384) / 8192) * 32) + ((((transform_left_code_row_even_1 -
        transform_left_code_row_odd_2) mod 16384) / 8192) * 4) + ((((transform_left_code_row_even_1 +
        transform_left_code_row_odd_2) mod 16384) / 8192) * 16);
      transform_left_code_next_column_box_0_0_0 <= transform_left_column_0 + transform_left_column_1;
      transform_left_code_next_column_box_0_1_0 <= transform_left_column_2 + transform_left_column_3;
      transform_left_code_next_column_box_0_2_0 <= transform_left_column_4 + transform_left_column_5;
      transform_left_code_next_column_box_0_3_0 <= transform_left_column_6 + transform_left_column_7;
      transform_left_code_next_column_box_0_4_0 <= transform_left_column_8 + transform_left_column_9;
      transform_left_code_next_column_centre <= transform_left_code_next_column_box_0_2_0;
      transform_left_code_next_column_near <= transform_left_code_next_column_box_0_1_0 +
        transform_left_code_next_column_box_0_3_0;
      transform_left_code_next_column_outer <= (1020 - transform_left_code_next_column_box_0_4_0) -
        transform_left_code_next_column_box_0_0_0;
      transform_left_code_next_column_upper <= (1530 - (((transform_left_code_next_column_box_0_1_0 +
        (transform_left_code_next_column_box_0_0_0 / 2)) * 2) + (transform_left_code_next_column_box_0_0_0 mod 2))) mod
        65536;
      transform_left_code_next_column_lower <= ((transform_left_code_next_column_box_0_3_0 +
        (transform_left_code_next_column_box_0_4_0 / 2)) * 2) + (transform_left_code_next_column_box_0_4_0 mod 2);
      transform_left_code_next_column_response_0 <= ((transform_left_code_next_column_centre +
        (transform_left_code_next_column_near / 2)) * 2) + (transform_left_code_next_column_near mod 2);
      transform_left_code_next_column_response_1 <= ((transform_left_code_next_column_centre +
        (transform_left_code_next_column_outer / 2)) * 2) + (transform_left_code_next_column_outer mod 2);
      transform_left_code_next_column_response_2 <= (transform_left_code_next_column_upper +
        transform_left_code_next_column_lower) mod 65536;
      transform_left_code_next_row_box_0_0 <= transform_left_code_next_column_response_0 +
        transform_left_code_next_row_earlier_0_0_0;
      transform_left_code_next_row_box_0_1 <= transform_left_code_next_column_response_1 +
        transform_left_code_next_row_earlier_0_1_0;
      transform_left_code_next_row_box_0_2 <= (transform_left_code_next_column_response_2 +
        transform_left_code_next_row_earlier_0_2_0) mod 65536;
      transform_left_code_next_row_centre_0 <= transform_left_code_next_row_column_0_3;
      transform_left_code_next_row_centre_1 <= transform_left_code_next_row_column_1_3;
      transform_left_code_next_row_centre_2 <= transform_left_code_next_row_column_2_3 mod 32768;
      transform_left_code_next_row_outer_0 <= transform_left_code_next_row_box_0_0 +
        transform_left_code_next_row_column_0_7;
      transform_left_code_next_row_outer_1 <= transform_left_code_next_row_box_0_1 +
        transform_left_code_next_row_column_1_7;
      transform_left_code_next_row_outer_2 <= (transform_left_code_next_row_box_0_2 +
        transform_left_code_next_row_column_2_7) mod 65536;
      transform_left_code_next_row_before_0 <= ((transform_left_code_next_row_column_0_5 +
        (transform_left_code_next_row_column_0_7 / 2)) * 2) + (transform_left_code_next_row_column_0_7 mod 2);
      transform_left_code_next_row_before_1 <= ((transform_left_code_next_row_column_1_5 +
        (transform_left_code_next_row_column_1_7 / 2)) * 2) + (transform_left_code_next_row_column_1_7 mod 2);
      transform_left_code_next_row_before_2 <= (((transform_left_code_next_row_column_2_5 +
        (transform_left_code_next_row_column_2_7 / 2)) mod 32768) * 2) + (transform_left_code_next_row_column_2_7 mod
        2);
      transform_left_code_next_row_after_0 <= (((transform_left_code_next_row_box_0_0 / 2) +
        transform_left_code_next_row_column_0_1) * 2) + (transform_left_code_next_row_box_0_0 mod 2);
      transform_left_code_next_row_after_1 <= (((transform_left_code_next_row_box_0_1 / 2) +
        transform_left_code_next_row_column_1_1) * 2) + (transform_left_code_next_row_box_0_1 mod 2);
      transform_left_code_next_row_after_2 <= ((((transform_left_code_next_row_box_0_2 / 2) +
        transform_left_code_next_row_column_2_1) mod 32768) * 2) + (transform_left_code_next_row_box_0_2 mod 2);
      transform_left_code_next_row_even_1 <= ((((transform_left_code_next_row_outer_1 / 2) -
        transform_left_code_next_row_centre_1) mod 32768) * 2) + (transform_left_code_next_row_outer_1 mod 2);
      transform_left_code_next_row_even_2 <= ((((transform_left_code_next_row_outer_2 / 2) -
        transform_left_code_next_row_centre_2) mod 32768) * 2) + (transform_left_code_next_row_outer_2 mod 2);
      transform_left_code_next_row_odd_0 <= (transform_left_code_next_row_before_0 -
        transform_left_code_next_row_after_0) mod 65536;
      transform_left_code_next_row_odd_1 <= (transform_left_code_next_row_before_1 -
        transform_left_code_next_row_after_1) mod 65536;
      transform_left_code_next_row_odd_2 <= (transform_left_code_next_row_before_2 -
        transform_left_code_next_row_after_2) mod 65536;
      transform_left_code_next_row_signs <= (other_12 / 32768) + ((transform_left_code_next_row_odd_0 / 32768) * 2) +
        ((((transform_left_code_next_row_even_2 + transform_left_code_next_row_odd_1) mod 65536) / 32768) * 8) +
        ((((transform_left_code_next_row_odd_1 - transform_left_code_next_row_even_2) mod 65536) / 32768) * 32) +
        ((((transform_left_code_next_row_even_1 - transform_left_code_next_row_odd_2) mod 65536) / 32768) * 4) +
        ((((transform_left_code_next_row_even_1 + transform_left_code_next_row_odd_2) mod 65536) / 32768) * 16);
      transform_right_code_column_box_0_0_0 <= transform_right_column_3;
      transform_right_code_column_box_0_1_0 <= transform_right_column_4;
      transform_right_code_column_box_0_2_0 <= transform_right_column_5;
      transform_right_code_column_box_0_3_0 <= transform_right_column_6;
      transform_right_code_column_box_0_4_0 <= transform_right_column_7;
      transform_right_code_column_centre <= transform_right_code_column_box_0_2_0;
      transform_right_code_column_near <= transform_right_code_column_box_0_1_0 + transform_right_code_column_box_0_3_0;
      transform_right_code_column_outer <= (510 - transform_right_code_column_box_0_4_0) -
        transform_right_code_column_box_0_0_0;
      transform_right_code_column_upper <= 765 - (((transform_right_code_column_box_0_1_0 +
        (transform_right_code_column_box_0_0_0 / 2)) * 2) + (transform_right_code_column_box_0_0_0 mod 2));
      transform_right_code_column_lower <= ((transform_right_code_column_box_0_3_0 +
        (transform_right_code_column_box_0_4_0 / 2)) * 2) + (transform_right_code_column_box_0_4_0 mod 2);
      transform_right_code_column_response_0 <= ((transform_right_code_column_centre +
        (transform_right_code_column_near / 2)) * 2) + (transform_right_code_column_near mod 2);
      transform_right_code_column_response_1 <= ((transform_right_code_column_centre +
        (transform_right_code_column_outer / 2)) * 2) + (transform_right_code_column_outer mod 2);
      transform_right_code_column_response_2 <= transform_right_code_column_upper + transform_right_code_column_lower;
      transform_right_code_row_box_0_0 <= transform_right_code_column_response_0;
      transform_right_code_row_box_0_1 <= transform_right_code_column_response_1;
      transform_right_code_row_box_0_2 <= transform_right_code_column_response_2;
      transform_right_code_row_centre_0 <= transform_right_code_row_column_0_1;
      transform_right_code_row_centre_1 <= transform_right_code_row_column_1_1;
      transform_right_code_row_centre_2 <= transform_right_code_row_column_2_1;
      transform_right_code_row_outer_1 <= transform_right_code_row_box_0_1 + transform_right_code_row_column_1_3;
      transform_right_code_row_outer_2 <= transform_right_code_row_box_0_2 + transform_right_code_row_column_2_3;
      transform_right_code_row_before_0 <= ((transform_right_code_row_column_0_2 + (transform_right_code_row_column_0_3
        / 2)) * 2) + (transform_right_code_row_column_0_3 mod 2);
      transform_right_code_row_before_1 <= ((transform_right_code_row_column_1_2 + (transform_right_code_row_column_1_3
        / 2)) * 2) + (transform_right_code_row_column_1_3 mod 2);
      transform_right_code_row_before_2 <= ((transform_right_code_row_column_2_2 + (transform_right_code_row_column_2_3
        / 2)) * 2) + (transform_right_code_row_column_2_3 mod 2);
      transform_right_code_row_after_0 <= (((transform_right_code_row_box_0_0 / 2) +
        transform_right_code_row_column_0_0) * 2) + (transform_right_code_row_box_0_0 mod 2);
      transform_right_code_row_after_1 <= (((transform_right_code_row_box_0_1 / 2) +
        transform_right_code_row_column_1_0) * 2) + (transform_right_code_row_box_0_1 mod 2);
      transform_right_code_row_after_2 <= (((transform_right_code_row_box_0_2 / 2) +
        transform_right_code_row_column_2_0) * 2) + (transform_right_code_row_box_0_2 mod 2);
      transform_right_code_row_even_1 <= ((((transform_right_code_row_outer_1 / 2) - transform_right_code_row_centre_1)
        mod 8192) * 2) + (transform_right_code_row_outer_1 mod 2);
      transform_right_code_row_even_2 <= ((((transform_right_code_row_outer_2 / 2) - transform_right_code_row_centre_2)
        mod 8192) * 2) + (transform_right_code_row_outer_2 mod 2);
      transform_right_code_row_odd_1 <= (transform_right_code_row_before_1 - transform_right_code_row_after_1) mod
        16384;
      transform_right_code_row_odd_2 <= (transform_right_code_row_before_2 - transform_right_code_row_after_2) mod
        16384;
      transform_right_code_row_signs <= ((other_9 / 8192) * 2) + (other_10 / 8192) +
        ((((transform_right_code_row_even_2 + transform_right_code_row_odd_1) mod 16384) / 8192) * 8) +
        ((((transform_right_code_row_odd_1 - transform_right_code_row_even_2) mod 16384) / 8192) * 32) +
        ((((transform_right_code_row_even_1 - transform_right_code_row_odd_2) mod 16384) / 8192) * 4) +
        ((((transform_right_code_row_even_1 + transform_right_code_row_odd_2) mod 16384) / 8192) * 16);
      transform_right_code_next_column_box_0_0_0 <= transform_right_column_0 + transform_right_column_1;
      transform_right_code_next_column_box_0_1_0 <= transform_right_column_2 + transform_right_column_3;
      transform_right_code_next_column_box_0_2_0 <= transform_right_column_4 + transform_right_column_5;
      transform_right_code_next_column_box_0_3_0 <= transform_right_column_6 + transform_right_column_7;
      transform_right_code_next_column_box_0_4_0 <= transform_right_column_8 + transform_right_column_9;
      transform_right_code_next_column_centre <= transform_right_code_next_column_box_0_2_0;
      transform_right_code_next_column_near <= transform_right_code_next_column_box_0_1_0 +
        transform_right_code_next_column_box_0_3_0;
      transform_right_code_next_column_outer <= (1020 - transform_right_code_next_column_box_0_4_0) -
        transform_right_code_next_column_box_0_0_0;
      transform_right_code_next_column_upper <= (1530 - (((transform_right_code_next_column_box_0_1_0 +
        (transform_right_code_next_column_box_0_0_0 / 2)) * 2) + (transform_right_code_next_column_box_0_0_0 mod 2)))
        mod 65536;
      transform_right_code_next_column_lower <= ((transform_right_code_next_column_box_0_3_0 +
        (transform_right_code_next_column_box_0_4_0 / 2)) * 2) + (transform_right_code_next_column_box_0_4_0 mod 2);
      transform_right_code_next_column_response_0 <= ((transform_right_code_next_column_centre +
        (transform_right_code_next_column_near / 2)) * 2) + (transform_right_code_next_column_near mod 2);
      transform_right_code_next_column_response_1 <= ((transform_right_code_next_column_centre +
        (transform_right_code_next_column_outer / 2)) * 2) + (transform_right_code_next_column_outer mod 2);
      transform_right_code_next_column_response_2 <= (transform_right_code_next_column_upper +
        transform_right_code_next_column_lower) mod 65536;
      transform_right_code_next_row_box_0_0 <= transform_right_code_next_column_response_0 +
        transform_right_code_next_row_earlier_0_0_0;
      transform_right_code_next_row_box_0_1 <= transform_right_code_next_column_response_1 +
        transform_right_code_next_row_earlier_0_1_0;
      transform_right_code_next_row_box_0_2 <= (transform_right_code_next_column_response_2 +
        transform_right_code_next_row_earlier_0_2_0) mod 65536;
      transform_right_code_next_row_centre_0 <= transform_right_code_next_row_column_0_3;
      transform_right_code_next_row_centre_1 <= transform_right_code_next_row_column_1_3;
      transform_right_code_next_row_centre_2 <= transform_right_code_next_row_column_2_3 mod 32768;
      transform_right_code_next_row_outer_0 <= transform_right_code_next_row_box_0_0 +
        transform_right_code_next_row_column_0_7;
      transform_right_code_next_row_outer_1 <= transform_right_code_next_row_box_0_1 +
        transform_right_code_next_row_column_1_7;
      transform_right_code_next_row_outer_2 <= (transform_right_code_next_row_box_0_2 +
        transform_right_code_next_row_column_2_7) mod 65536;
      transform_right_code_next_row_before_0 <= ((transform_right_code_next_row_column_0_5 +
        (transform_right_code_next_row_column_0_7 / 2)) * 2) + (transform_right_code_next_row_column_0_7 mod 2);
      transform_right_code_next_row_before_1 <= ((transform_right_code_next_row_column_1_5 +
        (transform_right_code_next_row_column_1_7 / 2)) * 2) + (transform_right_code_next_row_column_1_7 mod 2);
      transform_right_code_next_row_before_2 <= (((transform_right_code_next_row_column_2_5 +
        (transform_right_code_next_row_column_2_7 / 2)) mod 32768) * 2) + (transform_right_code_next_row_column_2_7 mod
        2);
      transform_right_code_next_row_after_0 <= (((transform_right_code_next_row_box_0_0 / 2) +
        transform_right_code_next_row_column_0_1) * 2) + (transform_right_code_next_row_box_0_0 mod 2);
      transform_right_code_next_row_after_1 <= (((transform_right_code_next_row_box_0_1 / 2) +
        transform_right_code_next_row_column_1_1) * 2) + (transform_right_code_next_row_box_0_1 mod 2);
      transform_right_code_next_row_after_2 <= ((((transform_right_code_next_row_box_0_2 / 2) +
        transform_right_code_next_row_column_2_1) mod 32768) * 2) + (transform_right_code_next_row_box_0_2 mod 2);
      transform_right_code_next_row_even_1 <= ((((transform_right_code_next_row_outer_1 / 2) -
        transform_right_code_next_row_centre_1) mod 32768) * 2) + (transform_right_code_next_row_outer_1 mod 2);
      transform_right_code_next_row_even_2 <= ((((transform_right_code_next_row_outer_2 / 2) -
        transform_right_code_next_row_centre_2) mod 32768) * 2) + (transform_right_code_next_row_outer_2 mod 2);
      transform_right_code_next_row_odd_0 <= (transform_right_code_next_row_before_0 -
        transform_right_code_next_row_after_0) mod 65536;
      transform_right_code_next_row_odd_1 <= (transform_right_code_next_row_before_1 -
        transform_right_code_next_row_after_1) mod 65536;
      transform_right_code_next_row_odd_2 <= (transform_right_code_next_row_before_2 -
        transform_right_code_next_row_after_2) mod 65536;
      transform_right_code_next_row_signs <= (other_8 / 32768) + ((transform_right_code_next_row_odd_0 / 32768) * 2) +
        ((((transform_right_code_next_row_even_2 + transform_right_code_next_row_odd_1) mod 65536) / 32768) * 8) +
        ((((transform_right_code_next_row_odd_1 - transform_right_code_next_row_even_2) mod 65536) / 32768) * 32) +
        ((((transform_right_code_next_row_even_1 - transform_right_code_next_row_odd_2) mod 65536) / 32768) * 4) +
        ((((transform_right_code_next_row_even_1 + transform_right_code_next_row_odd_2) mod 65536) / 32768) * 16);
      transform_filtering_0_inside_0 <= transform_columns_inside_0;
      transform_filtering_0_inside_1 <= transform_columns_inside_1;
      transform_filtering_0_start_of_frame <= transform_columns_start_of_frame;
      transform_filtering_0_valid <= transform_columns_valid;
      transform_filtering_1_inside_0 <= transform_filtering_0_inside_0;
      transform_filtering_1_inside_1 <= transform_filtering_0_inside_1;
      transform_filtering_1_start_of_frame <= transform_filtering_0_start_of_frame;
      transform_filtering_1_valid <= transform_filtering_0_valid;
      transform_filtering_2_inside_0 <= transform_filtering_1_inside_0;
      transform_filtering_2_inside_1 <= transform_filtering_1_inside_1;
      transform_filtering_2_start_of_frame <= transform_filtering_1_start_of_frame;
      transform_filtering_2_valid <= transform_filtering_1_valid;
      transform_filtering_3_inside_0 <= transform_filtering_2_inside_0;
      transform_filtering_3_inside_1 <= transform_filtering_2_inside_1;
      transform_filtering_3_start_of_frame <= transform_filtering_2_start_of_frame;
      transform_filtering_3_valid <= transform_filtering_2_valid;
      transform_filtering_4_inside_0 <= transform_filtering_3_inside_0;
      transform_filtering_4_inside_1 <= transform_filtering_3_inside_1;
      transform_filtering_4_start_of_frame <= transform_filtering_3_start_of_frame;
      transform_filtering_4_valid <= transform_filtering_3_valid;
      transform_filtering_5_inside_0 <= transform_filtering_4_inside_0;
      transform_filtering_5_inside_1 <= transform_filtering_4_inside_1;
      transform_filtering_5_start_of_frame <= transform_filtering_4_start_of_frame;
      transform_filtering_5_valid <= transform_filtering_4_valid;
      transform_filtering_6_inside_0 <= transform_filtering_5_inside_0;
      transform_filtering_6_inside_1 <= transform_filtering_5_inside_1;
      transform_filtering_6_start_of_frame <= transform_filtering_5_start_of_frame;
      transform_filtering_6_valid <= transform_filtering_5_valid;
      transform_filtering_7_start_of_frame <= transform_filtering_6_start_of_frame;
      transform_filtering_7_valid <= transform_filtering_6_valid;
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 2;
      else
        transform_counter_group <= transform_counter_group_choice_4;
      end if;
      if transform_from_first_0_is_equal then
        transform_from_first_0 <= (not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0))) and (((transform_centre_column / 32) = 1) or
          transform_from_first_0_value);
      else
        transform_from_first_0 <= not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0));
      end if;
      if (not (((transform_centre_group / 16) mod 2) = 1)) and ((not (((transform_centre_group / 8) mod 2) = 1)) or
        (((transform_centre_group / 2) mod 4) = 0)) then
        transform_from_first_1 <= (not (transform_from_first_1_choice_2 and ((transform_centre_column / 16) = 0))) and
          ((transform_centre_group / 32) = 1);
      else
        transform_from_first_1 <= not (transform_from_first_1_choice_2 and ((transform_centre_column / 16) = 0));
      end if;
      if transform_up_to_last_0_choice then
        transform_up_to_last_0 <= transform_up_to_last_0_choice_2;
      else
        transform_up_to_last_0 <= transform_up_to_last_0_choice_2 and (not ((transform_centre_column / 32) = 1));
      end if;
      if ((not (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
        (((transform_centre_group / 4) mod 4) = 0) then
        transform_up_to_last_1 <= (not (((transform_centre_column / 32) = 1) and ((((transform_centre_column / 16) mod
          2) = 1) or transform_from_first_1_value or (((transform_centre_column / 4) mod 2) = 1)))) and (not
          ((transform_centre_group / 32) = 1));
      else
        transform_up_to_last_1 <= (not (((transform_centre_column / 32) = 1) and ((((transform_centre_column / 16) mod
          2) = 1) or transform_from_first_1_value or (((transform_centre_column / 4) mod 2) = 1)))) and
          transform_up_to_last_0_is_equal;
      end if;
      if transform_filtering_6_inside_0 then
        transform_left_code_bits <= transform_left_code_earlier_1;
        transform_right_code_bits <= transform_right_code_earlier_1;
      else
        transform_left_code_bits <= 0;
        transform_right_code_bits <= 0;
      end if;
      if transform_filtering_6_inside_1 then
        transform_left_code_next_bits <= transform_left_code_next_row_signs;
        transform_right_code_next_bits <= transform_right_code_next_row_signs;
      else
        transform_left_code_next_bits <= 0;
        transform_right_code_next_bits <= 0;
      end if;
      if in_start_of_frame then
        transform_counter_next_frame_choice := transform_counter_group_all;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if in_valid then
        if transform_counter_group_is_equal or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
        end if;
        if transform_counter_group_is_equal and transform_counter_group_is_equal_3 then
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        else
          transform_counter_next_frame <= transform_counter_next_frame_choice;
        end if;
      end if;
      if (other_16 / 256) = 1 then
        transform_left_rows_write_words_0 <= transform_left_rows_ready_words_1(7 downto 0) &
          transform_left_rows_ready_words_0(31 downto 8);
        transform_left_rows_write_words_1 <= to_unsigned(transform_left_rows_ready_words_2, 8) &
          transform_left_rows_ready_words_1(31 downto 8);
        transform_left_rows_write_words_2 <= transform_left_rows_ready_newest_0;
        transform_right_rows_write_words_0 <= transform_right_rows_ready_words_1(7 downto 0) &
          transform_right_rows_ready_words_0(31 downto 8);
        transform_right_rows_write_words_1 <= to_unsigned(transform_right_rows_ready_words_2, 8) &
          transform_right_rows_ready_words_1(31 downto 8);
        transform_right_rows_write_words_2 <= transform_right_rows_ready_newest_0;
        transform_write_column <= transform_ready_column;
      end if;
      if transform_filtering_3_valid then
        transform_left_code_row_column_0_0 <= transform_left_code_row_box_0_0;
        transform_left_code_row_column_0_1 <= transform_left_code_row_column_0_0;
        transform_left_code_row_column_0_2 <= transform_left_code_row_column_0_1;
        transform_left_code_row_column_0_3 <= transform_left_code_row_column_0_2;
        transform_left_code_row_column_1_0 <= transform_left_code_row_box_0_1;
        transform_left_code_row_column_1_1 <= transform_left_code_row_column_1_0;
        transform_left_code_row_column_1_2 <= transform_left_code_row_column_1_1;
        transform_left_code_row_column_1_3 <= transform_left_code_row_column_1_2;
        transform_left_code_row_column_2_0 <= transform_left_code_row_box_0_2;
        transform_left_code_row_column_2_1 <= transform_left_code_row_column_2_0;
        transform_left_code_row_column_2_2 <= transform_left_code_row_column_2_1;
        transform_left_code_row_column_2_3 <= transform_left_code_row_column_2_2;
        transform_left_code_next_row_column_0_0 <= transform_left_code_next_row_box_0_0;
        transform_left_code_next_row_column_0_1 <= transform_left_code_next_row_column_0_0;
        transform_left_code_next_row_column_0_2 <= transform_left_code_next_row_column_0_1;
        transform_left_code_next_row_column_0_3 <= transform_left_code_next_row_column_0_2;
        transform_left_code_next_row_column_0_4 <= transform_left_code_next_row_column_0_3;
        transform_left_code_next_row_column_0_5 <= transform_left_code_next_row_column_0_4;
        transform_left_code_next_row_column_0_6 <= transform_left_code_next_row_column_0_5;
        transform_left_code_next_row_column_0_7 <= transform_left_code_next_row_column_0_6;
        transform_left_code_next_row_column_1_0 <= transform_left_code_next_row_box_0_1;
        transform_left_code_next_row_column_1_1 <= transform_left_code_next_row_column_1_0;
        transform_left_code_next_row_column_1_2 <= transform_left_code_next_row_column_1_1;
        transform_left_code_next_row_column_1_3 <= transform_left_code_next_row_column_1_2;
        transform_left_code_next_row_column_1_4 <= transform_left_code_next_row_column_1_3;
        transform_left_code_next_row_column_1_5 <= transform_left_code_next_row_column_1_4;
        transform_left_code_next_row_column_1_6 <= transform_left_code_next_row_column_1_5;
        transform_left_code_next_row_column_1_7 <= transform_left_code_next_row_column_1_6;
        transform_left_code_next_row_column_2_0 <= transform_left_code_next_row_box_0_2;
        transform_left_code_next_row_column_2_1 <= transform_left_code_next_row_column_2_0;
        transform_left_code_next_row_column_2_2 <= transform_left_code_next_row_column_2_1;
        transform_left_code_next_row_column_2_3 <= transform_left_code_next_row_column_2_2;
        transform_left_code_next_row_column_2_4 <= transform_left_code_next_row_column_2_3;
        transform_left_code_next_row_column_2_5 <= transform_left_code_next_row_column_2_4;
        transform_left_code_next_row_column_2_6 <= transform_left_code_next_row_column_2_5;
        transform_left_code_next_row_column_2_7 <= transform_left_code_next_row_column_2_6;
        transform_right_code_row_column_0_0 <= transform_right_code_row_box_0_0;
        transform_right_code_row_column_0_1 <= transform_right_code_row_column_0_0;
        transform_right_code_row_column_0_2 <= transform_right_code_row_column_0_1;
        transform_right_code_row_column_0_3 <= transform_right_code_row_column_0_2;
        transform_right_code_row_column_1_0 <= transform_right_code_row_box_0_1;
        transform_right_code_row_column_1_1 <= transform_right_code_row_column_1_0;
        transform_right_code_row_column_1_2 <= transform_right_code_row_column_1_1;
        transform_right_code_row_column_1_3 <= transform_right_code_row_column_1_2;
        transform_right_code_row_column_2_0 <= transform_right_code_row_box_0_2;
        transform_right_code_row_column_2_1 <= transform_right_code_row_column_2_0;
        transform_right_code_row_column_2_2 <= transform_right_code_row_column_2_1;
        transform_right_code_row_column_2_3 <= transform_right_code_row_column_2_2;
        transform_right_code_next_row_column_0_0 <= transform_right_code_next_row_box_0_0;
        transform_right_code_next_row_column_0_1 <= transform_right_code_next_row_column_0_0;
        transform_right_code_next_row_column_0_2 <= transform_right_code_next_row_column_0_1;
        transform_right_code_next_row_column_0_3 <= transform_right_code_next_row_column_0_2;
        transform_right_code_next_row_column_0_4 <= transform_right_code_next_row_column_0_3;
        transform_right_code_next_row_column_0_5 <= transform_right_code_next_row_column_0_4;
        transform_right_code_next_row_column_0_6 <= transform_right_code_next_row_column_0_5;
        transform_right_code_next_row_column_0_7 <= transform_right_code_next_row_column_0_6;
        transform_right_code_next_row_column_1_0 <= transform_right_code_next_row_box_0_1;
        transform_right_code_next_row_column_1_1 <= transform_right_code_next_row_column_1_0;
        transform_right_code_next_row_column_1_2 <= transform_right_code_next_row_column_1_1;
        transform_right_code_next_row_column_1_3 <= transform_right_code_next_row_column_1_2;
        transform_right_code_next_row_column_1_4 <= transform_right_code_next_row_column_1_3;
        transform_right_code_next_row_column_1_5 <= transform_right_code_next_row_column_1_4;
        transform_right_code_next_row_column_1_6 <= transform_right_code_next_row_column_1_5;
        transform_right_code_next_row_column_1_7 <= transform_right_code_next_row_column_1_6;
        transform_right_code_next_row_column_2_0 <= transform_right_code_next_row_box_0_2;
        transform_right_code_next_row_column_2_1 <= transform_right_code_next_row_column_2_0;
        transform_right_code_next_row_column_2_2 <= transform_right_code_next_row_column_2_1;
        transform_right_code_next_row_column_2_3 <= transform_right_code_next_row_column_2_2;
        transform_right_code_next_row_column_2_4 <= transform_right_code_next_row_column_2_3;
        transform_right_code_next_row_column_2_5 <= transform_right_code_next_row_column_2_4;
        transform_right_code_next_row_column_2_6 <= transform_right_code_next_row_column_2_5;
        transform_right_code_next_row_column_2_7 <= transform_right_code_next_row_column_2_6;
      end if;
      if transform_filtering_6_valid then
        transform_left_code_earlier_0 <= transform_left_code_row_signs;
        transform_left_code_earlier_1 <= transform_left_code_earlier_0;
        transform_right_code_earlier_0 <= transform_right_code_row_signs;
        transform_right_code_earlier_1 <= transform_right_code_earlier_0;
      end if;
      if transform_filtering_2_valid then
        transform_left_code_next_row_earlier_0_0_0 <= transform_left_code_next_column_response_0;
        transform_left_code_next_row_earlier_0_1_0 <= transform_left_code_next_column_response_1;
        transform_left_code_next_row_earlier_0_2_0 <= transform_left_code_next_column_response_2;
        transform_right_code_next_row_earlier_0_0_0 <= transform_right_code_next_column_response_0;
        transform_right_code_next_row_earlier_0_1_0 <= transform_right_code_next_column_response_1;
        transform_right_code_next_row_earlier_0_2_0 <= transform_right_code_next_column_response_2;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 39;
      raster_place_group_is_equal_2 := raster_place_group = 17;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 9;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_is_equal_3 := raster_place_group = 19;
      if raster_place_next_frame and raster_place_group_is_equal_3 then
        raster_place_group_choice_2 := 2;
      else
        raster_place_group_choice_2 := (raster_place_group + 1) mod 32;
      end if;
      if (raster_place_group /= 20) and raster_place_group_is_equal and transform_filtering_7_valid then
        raster_place_group_choice_3 := raster_place_group_choice_2;
      else
        raster_place_group_choice_3 := raster_place_group;
      end if;
      if raster_place_group_is_equal_3 then
        raster_place_next_frame_choice := (raster_place_column /= 39) and raster_place_next_frame;
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_all then
        raster_place_next_frame_choice_2 := transform_filtering_7_valid;
      else
        raster_place_next_frame_choice_2 := transform_filtering_7_valid and (not transform_filtering_7_start_of_frame);
      end if;
      if raster_place_next_frame_choice then
        raster_place_next_frame_choice_3 := raster_place_next_frame_choice_2;
      else
        raster_place_next_frame_choice_3 := raster_place_group_is_equal and raster_place_group_is_equal_2 and
          transform_filtering_7_valid and transform_filtering_7_start_of_frame;
      end if;
      raster_features_search_0 <= (transform_left_code_next_bits * 64) + transform_left_code_bits;
      raster_features_reference_0 <= (transform_right_code_next_bits * 64) + transform_right_code_bits;
      raster_features_valid <= transform_filtering_7_valid;
      raster_place_next_frame <= raster_place_next_frame_choice_3 or ((not transform_filtering_7_valid) and
        raster_place_next_frame);
      if transform_filtering_7_valid and transform_filtering_7_start_of_frame then
        raster_place_group <= raster_place_group_choice * 2;
      else
        raster_place_group <= raster_place_group_choice_3;
      end if;
      if transform_filtering_7_valid then
        if raster_place_group_is_equal or transform_filtering_7_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 11 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 16;
        end if;
      end if;
      delay_row_inside_0_all := (not ((((raster_place_column / 8) mod 2) = 1) and ((((raster_place_column / 4) mod 2) =
        1) or ((raster_place_column mod 4) = 3)))) and ((raster_place_column / 16) = 0);
      delay_row_inside_0_all_2 := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_inside_before_0;
      delay_row_inside_0_is_less := (((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4))
        < 18;
      delay_row_inside_1_all := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_inside_before_1;
      delay_row_inside_1_all_2 := (raster_place_group >= 3) and (raster_place_group < 21);
      delay_row_inside_2_all := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_inside_before_2;
      delay_row_inside_2_is_less := (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2))
        < 18;
      if delay_row_inside_0_all then
        delay_row_inside_2_choice := delay_row_inside_2_all;
      else
        delay_row_inside_2_choice := delay_row_inside_2_is_less;
      end if;
      delay_row_inside_3_all := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_inside_before_3;
      delay_row_inside_3_all_2 := (raster_place_group >= 1) and (raster_place_group < 19);
      delay_row_inside_4_all := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_inside_before_4;
      delay_tag_output_column_all := (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_whole_before;
      delay_tag_output_column_is_less := ((raster_place_column + 65523) mod 65536) < 65532;
      delay_tag_first_column_is_equal := raster_place_column = 13;
      delay_split_inside_before_0_all := raster_place_group_is_equal and raster_features_valid;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_2 <= delay_row_inside_2_choice;
      delay_tag_valid <= raster_features_valid;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 2);
      delay_tag_end_of_line <= (not ((raster_place_column = 0) and (not other_7) and raster_features_valid)) and
        delay_split_whole_before and (raster_place_column = 8);
      delay_split_search_inside_0 <= delay_row_inside_0_is_less;
      delay_split_search_inside_1 <= delay_row_inside_1_all_2;
      delay_split_search_inside_2 <= delay_row_inside_2_is_less;
      delay_split_search_inside_3 <= delay_row_inside_3_all_2;
      delay_split_search_inside_4 <= (not ((raster_place_group / 16) = 1)) or (((raster_place_group / 2) mod 8) = 0);
      delay_split_whole_before <= delay_split_inside_before_0_all or delay_tag_output_column_all;
      if delay_row_inside_0_all then
        delay_row_inside_0 <= delay_row_inside_0_all_2;
        delay_row_inside_1 <= delay_row_inside_1_all;
        delay_row_inside_3 <= delay_row_inside_3_all;
        delay_row_inside_4 <= delay_row_inside_4_all;
      else
        delay_row_inside_0 <= delay_row_inside_0_is_less;
        delay_row_inside_1 <= delay_row_inside_1_all_2;
        delay_row_inside_3 <= delay_row_inside_3_all_2;
        delay_row_inside_4 <= not (((raster_place_group / 16) = 1) and ((((raster_place_group / 8) mod 2) = 1) or
          (((raster_place_group / 4) mod 2) = 1) or (((raster_place_group / 2) mod 2) = 1)));
      end if;
      if delay_tag_output_column_all then
        delay_tag_output_column <= delay_row_inside_2_choice and delay_tag_output_column_is_less;
      else
        delay_tag_output_column <= delay_row_inside_2_choice and (not delay_row_inside_0_all) and
          delay_tag_output_column_is_less;
      end if;
      if delay_split_inside_before_0_all then
        delay_split_inside_before_0 <= delay_row_inside_0_is_less;
        delay_split_inside_before_1 <= delay_row_inside_1_all_2;
        delay_split_inside_before_2 <= delay_row_inside_2_is_less;
        delay_split_inside_before_3 <= delay_row_inside_3_all_2;
        delay_split_inside_before_4 <= not (((raster_place_group / 16) = 1) and ((((raster_place_group / 8) mod 2) = 1)
          or (((raster_place_group / 4) mod 2) = 1) or (((raster_place_group / 2) mod 2) = 1)));
      else
        delay_split_inside_before_0 <= delay_row_inside_0_all_2;
        delay_split_inside_before_1 <= delay_row_inside_1_all;
        delay_split_inside_before_2 <= delay_row_inside_2_all;
        delay_split_inside_before_3 <= delay_row_inside_3_all;
        delay_split_inside_before_4 <= delay_row_inside_4_all;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_inside_2 <= delay_row_inside_2;
      rows_read_inside_3 <= delay_row_inside_3;
      rows_read_inside_4 <= delay_row_inside_4;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_read_search_inside_0 <= delay_split_search_inside_0;
      rows_read_search_inside_1 <= delay_split_search_inside_1;
      rows_read_search_inside_2 <= delay_split_search_inside_2;
      rows_read_search_inside_3 <= delay_split_search_inside_3;
      rows_read_search_inside_4 <= delay_split_search_inside_4;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
      rows_ready_inside_3 <= rows_read_inside_3;
      rows_ready_inside_4 <= rows_read_inside_4;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_ready_search_inside_0 <= rows_read_search_inside_0;
      rows_ready_search_inside_1 <= rows_read_search_inside_1;
      rows_ready_search_inside_2 <= rows_read_search_inside_2;
      rows_ready_search_inside_3 <= rows_read_search_inside_3;
      rows_ready_search_inside_4 <= rows_read_search_inside_4;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_search_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0 mod 4096;
      else
        rows_search_0 <= 0;
      end if;
      if rows_ready_search_inside_1 then
        rows_search_1 <= rows_search_rows_ready_words_0 / 4096;
      else
        rows_search_1 <= 0;
      end if;
      if rows_ready_search_inside_2 then
        rows_search_2 <= rows_search_rows_ready_words_1 mod 4096;
      else
        rows_search_2 <= 0;
      end if;
      if rows_ready_search_inside_3 then
        rows_search_3 <= rows_search_rows_ready_words_1 / 4096;
      else
        rows_search_3 <= 0;
      end if;
      if rows_ready_search_inside_4 then
        rows_search_4 <= rows_search_rows_ready_newest_0;
      else
        rows_search_4 <= 0;
      end if;
      if rows_ready_inside_0 then
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 4096;
      else
        rows_reference_0 <= 0;
      end if;
      if rows_ready_inside_1 then
        rows_reference_1 <= rows_reference_rows_ready_words_0 / 4096;
      else
        rows_reference_1 <= 0;
      end if;
      if rows_ready_inside_2 then
        rows_reference_2 <= rows_reference_rows_ready_words_1 mod 4096;
      else
        rows_reference_2 <= 0;
      end if;
      if rows_ready_inside_3 then
        rows_reference_3 <= rows_reference_rows_ready_words_1 / 4096;
      else
        rows_reference_3 <= 0;
      end if;
      if rows_ready_inside_4 then
        rows_reference_4 <= rows_reference_rows_ready_newest_0;
      else
        rows_reference_4 <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 4096) + ((rows_search_rows_ready_words_1
          mod 4096) * 4096);
        rows_search_rows_write_words_1 <= (rows_search_rows_ready_words_1 / 4096) + (rows_search_rows_ready_newest_0 *
          4096);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 4096) +
          ((rows_reference_rows_ready_words_1 mod 4096) * 4096);
        rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_words_1 / 4096) +
          (rows_reference_rows_ready_newest_0 * 4096);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0_0 <= slice0shift_search_0_1;
        slice0shift_search_0_1 <= slice0shift_search_0_2;
        slice0shift_search_0_2 <= slice0shift_search_0_3;
        slice0shift_search_0_3 <= slice0shift_search_0_4;
        slice0shift_search_0_4 <= slice0shift_search_0_5;
        slice0shift_search_0_5 <= rows_search_0;
        slice0shift_search_1_0 <= slice0shift_search_1_1;
        slice0shift_search_1_1 <= slice0shift_search_1_2;
        slice0shift_search_1_2 <= slice0shift_search_1_3;
        slice0shift_search_1_3 <= slice0shift_search_1_4;
        slice0shift_search_1_4 <= slice0shift_search_1_5;
        slice0shift_search_1_5 <= rows_search_1;
        slice0shift_search_2_0 <= slice0shift_search_2_1;
        slice0shift_search_2_1 <= slice0shift_search_2_2;
        slice0shift_search_2_2 <= slice0shift_search_2_3;
        slice0shift_search_2_3 <= slice0shift_search_2_4;
        slice0shift_search_2_4 <= slice0shift_search_2_5;
        slice0shift_search_2_5 <= rows_search_2;
        slice0shift_search_3_0 <= slice0shift_search_3_1;
        slice0shift_search_3_1 <= slice0shift_search_3_2;
        slice0shift_search_3_2 <= slice0shift_search_3_3;
        slice0shift_search_3_3 <= slice0shift_search_3_4;
        slice0shift_search_3_4 <= slice0shift_search_3_5;
        slice0shift_search_3_5 <= rows_search_3;
        slice0shift_search_4_0 <= slice0shift_search_4_1;
        slice0shift_search_4_1 <= slice0shift_search_4_2;
        slice0shift_search_4_2 <= slice0shift_search_4_3;
        slice0shift_search_4_3 <= slice0shift_search_4_4;
        slice0shift_search_4_4 <= slice0shift_search_4_5;
        slice0shift_search_4_5 <= rows_search_4;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_reference_2 <= rows_reference_2;
      slice0shift_reference_3 <= rows_reference_3;
      slice0shift_reference_4 <= rows_reference_4;
      slice0shift_search_out_0 <= slice0shift_search_0_0;
      slice0shift_search_out_1 <= slice0shift_search_1_0;
      slice0shift_search_out_2 <= slice0shift_search_2_0;
      slice0shift_search_out_3 <= slice0shift_search_3_0;
      slice0shift_search_out_4 <= slice0shift_search_4_0;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pixels_first_0_0_value := ((slice0shift_reference_0 / 8) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_2 := ((slice0shift_reference_0 / 32) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_3 := ((slice0shift_reference_0 / 16) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_4 := ((slice0shift_reference_0 / 4) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_5 := ((slice0shift_reference_0 / 2) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_6 := ((slice0shift_reference_0 / 64) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_7 := ((slice0shift_reference_0 / 256) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_8 := ((slice0shift_reference_0 / 128) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_9 := ((slice0shift_reference_0 / 512) mod 2) = 1;
      slice0cost_pixels_first_0_0_value_10 := ((slice0shift_reference_0 / 1024) mod 2) = 1;
      slice0cost_pixels_first_1_0_value := ((slice0shift_reference_1 / 8) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_2 := ((slice0shift_reference_1 / 32) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_3 := ((slice0shift_reference_1 / 16) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_4 := ((slice0shift_reference_1 / 4) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_5 := ((slice0shift_reference_1 / 2) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_6 := ((slice0shift_reference_1 / 64) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_7 := ((slice0shift_reference_1 / 256) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_8 := ((slice0shift_reference_1 / 128) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_9 := ((slice0shift_reference_1 / 512) mod 2) = 1;
      slice0cost_pixels_first_1_0_value_10 := ((slice0shift_reference_1 / 1024) mod 2) = 1;
      slice0cost_pixels_first_2_0_value := ((slice0shift_reference_2 / 8) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_2 := ((slice0shift_reference_2 / 32) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_3 := ((slice0shift_reference_2 / 16) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_4 := ((slice0shift_reference_2 / 4) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_5 := ((slice0shift_reference_2 / 2) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_6 := ((slice0shift_reference_2 / 64) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_7 := ((slice0shift_reference_2 / 256) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_8 := ((slice0shift_reference_2 / 128) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_9 := ((slice0shift_reference_2 / 512) mod 2) = 1;
      slice0cost_pixels_first_2_0_value_10 := ((slice0shift_reference_2 / 1024) mod 2) = 1;
      slice0cost_pixels_first_3_0_value := ((slice0shift_reference_3 / 8) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_2 := ((slice0shift_reference_3 / 32) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_3 := ((slice0shift_reference_3 / 16) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_4 := ((slice0shift_reference_3 / 4) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_5 := ((slice0shift_reference_3 / 2) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_6 := ((slice0shift_reference_3 / 64) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_7 := ((slice0shift_reference_3 / 256) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_8 := ((slice0shift_reference_3 / 128) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_9 := ((slice0shift_reference_3 / 512) mod 2) = 1;
      slice0cost_pixels_first_3_0_value_10 := ((slice0shift_reference_3 / 1024) mod 2) = 1;
      slice0cost_pixels_first_4_0_value := ((slice0shift_reference_4 / 8) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_2 := ((slice0shift_reference_4 / 32) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_3 := ((slice0shift_reference_4 / 16) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_4 := ((slice0shift_reference_4 / 4) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_5 := ((slice0shift_reference_4 / 2) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_6 := ((slice0shift_reference_4 / 64) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_7 := ((slice0shift_reference_4 / 256) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_8 := ((slice0shift_reference_4 / 128) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_9 := ((slice0shift_reference_4 / 512) mod 2) = 1;
      slice0cost_pixels_first_4_0_value_10 := ((slice0shift_reference_4 / 1024) mod 2) = 1;
      slice0cost_pixels_first_0_0 <= ((as_number((slice0cost_pixels_first_0_0_value /= (((slice0shift_search_0_0 / 8)
        mod 2) = 1))) + as_number((slice0cost_pixels_first_0_0_value_2 /= (((slice0shift_search_0_0 / 32) mod 2) = 1)))
        + as_number((slice0cost_pixels_first_0_0_value_3 /= (((slice0shift_search_0_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice0shift_reference_0 mod 2) = 1) /= ((slice0shift_search_0_0 mod 2) = 1))) +
        as_number((slice0cost_pixels_first_0_0_value_4 /= (((slice0shift_search_0_0 / 4) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_0_0_value_5 /= (((slice0shift_search_0_0 / 2) mod 2) = 1))) +
        ((as_number((slice0cost_pixels_first_0_0_value_6 /= (((slice0shift_search_0_0 / 64) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_0_0_value_7 /= (((slice0shift_search_0_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_0_0_value_8 /= (((slice0shift_search_0_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice0cost_pixels_first_0_0_value_9 /= (((slice0shift_search_0_0 / 512) mod 2) = 1))) +
        as_number((((slice0shift_reference_0 / 2048) = 1) /= ((slice0shift_search_0_0 / 2048) = 1))) +
        as_number((slice0cost_pixels_first_0_0_value_10 /= (((slice0shift_search_0_0 / 1024) mod 2) = 1)))) * 64);
      slice0cost_pixels_first_0_1 <= ((as_number(((((slice0shift_search_0_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_1 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_1 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_1 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_1 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_1 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_2 <= ((as_number(((((slice0shift_search_0_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_2 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_2 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_2 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_2 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_2 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_3 <= ((as_number(((((slice0shift_search_0_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_3 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_3 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_3 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_3 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_3 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_4 <= ((as_number(((((slice0shift_search_0_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_4 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_4 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_4 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_4 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_4 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_5 <= ((as_number(((((slice0shift_search_0_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_5 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_5 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_5 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_5 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_5 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_1_0 <= ((as_number((slice0cost_pixels_first_1_0_value /= (((slice0shift_search_1_0 / 8)
        mod 2) = 1))) + as_number((slice0cost_pixels_first_1_0_value_2 /= (((slice0shift_search_1_0 / 32) mod 2) = 1)))
        + as_number((slice0cost_pixels_first_1_0_value_3 /= (((slice0shift_search_1_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice0shift_reference_1 mod 2) = 1) /= ((slice0shift_search_1_0 mod 2) = 1))) +
        as_number((slice0cost_pixels_first_1_0_value_4 /= (((slice0shift_search_1_0 / 4) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_1_0_value_5 /= (((slice0shift_search_1_0 / 2) mod 2) = 1))) +
        ((as_number((slice0cost_pixels_first_1_0_value_6 /= (((slice0shift_search_1_0 / 64) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_1_0_value_7 /= (((slice0shift_search_1_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_1_0_value_8 /= (((slice0shift_search_1_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice0cost_pixels_first_1_0_value_9 /= (((slice0shift_search_1_0 / 512) mod 2) = 1))) +
        as_number((((slice0shift_reference_1 / 2048) = 1) /= ((slice0shift_search_1_0 / 2048) = 1))) +
        as_number((slice0cost_pixels_first_1_0_value_10 /= (((slice0shift_search_1_0 / 1024) mod 2) = 1)))) * 64);
      slice0cost_pixels_first_1_1 <= ((as_number(((((slice0shift_search_1_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_1 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_1 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_1 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_1 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_1 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_2 <= ((as_number(((((slice0shift_search_1_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_2 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_2 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_2 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_2 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_2 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_3 <= ((as_number(((((slice0shift_search_1_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_3 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_3 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_3 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_3 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_3 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_4 <= ((as_number(((((slice0shift_search_1_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_4 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_4 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_4 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_4 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_4 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_5 <= ((as_number(((((slice0shift_search_1_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_5 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_5 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_5 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_5 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_5 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_2_0 <= ((as_number((slice0cost_pixels_first_2_0_value /= (((slice0shift_search_2_0 / 8)
        mod 2) = 1))) + as_number((slice0cost_pixels_first_2_0_value_2 /= (((slice0shift_search_2_0 / 32) mod 2) = 1)))
        + as_number((slice0cost_pixels_first_2_0_value_3 /= (((slice0shift_search_2_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice0shift_reference_2 mod 2) = 1) /= ((slice0shift_search_2_0 mod 2) = 1))) +
        as_number((slice0cost_pixels_first_2_0_value_4 /= (((slice0shift_search_2_0 / 4) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_2_0_value_5 /= (((slice0shift_search_2_0 / 2) mod 2) = 1))) +
        ((as_number((slice0cost_pixels_first_2_0_value_6 /= (((slice0shift_search_2_0 / 64) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_2_0_value_7 /= (((slice0shift_search_2_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_2_0_value_8 /= (((slice0shift_search_2_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice0cost_pixels_first_2_0_value_9 /= (((slice0shift_search_2_0 / 512) mod 2) = 1))) +
        as_number((((slice0shift_reference_2 / 2048) = 1) /= ((slice0shift_search_2_0 / 2048) = 1))) +
        as_number((slice0cost_pixels_first_2_0_value_10 /= (((slice0shift_search_2_0 / 1024) mod 2) = 1)))) * 64);
      slice0cost_pixels_first_2_1 <= ((as_number(((((slice0shift_search_2_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value)) + as_number(((((slice0shift_search_2_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_2)) + as_number(((((slice0shift_search_2_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice0shift_search_2_1 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_4)) + as_number(((((slice0shift_search_2_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_5)) + ((as_number(((((slice0shift_search_2_1 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_6)) + as_number(((((slice0shift_search_2_1 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_7)) + as_number(((((slice0shift_search_2_1 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice0shift_search_2_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_9)) + as_number((((slice0shift_search_2_1 / 2048) = 1) /=
        ((slice0shift_reference_2 / 2048) = 1))) + as_number(((((slice0shift_search_2_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_10))) * 64);
      slice0cost_pixels_first_2_2 <= ((as_number(((((slice0shift_search_2_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value)) + as_number(((((slice0shift_search_2_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_2)) + as_number(((((slice0shift_search_2_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice0shift_search_2_2 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_4)) + as_number(((((slice0shift_search_2_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_5)) + ((as_number(((((slice0shift_search_2_2 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_6)) + as_number(((((slice0shift_search_2_2 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_7)) + as_number(((((slice0shift_search_2_2 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice0shift_search_2_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_9)) + as_number((((slice0shift_search_2_2 / 2048) = 1) /=
        ((slice0shift_reference_2 / 2048) = 1))) + as_number(((((slice0shift_search_2_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_10))) * 64);
      slice0cost_pixels_first_2_3 <= ((as_number(((((slice0shift_search_2_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value)) + as_number(((((slice0shift_search_2_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_2)) + as_number(((((slice0shift_search_2_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice0shift_search_2_3 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_4)) + as_number(((((slice0shift_search_2_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_5)) + ((as_number(((((slice0shift_search_2_3 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_6)) + as_number(((((slice0shift_search_2_3 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_7)) + as_number(((((slice0shift_search_2_3 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice0shift_search_2_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_9)) + as_number((((slice0shift_search_2_3 / 2048) = 1) /=
        ((slice0shift_reference_2 / 2048) = 1))) + as_number(((((slice0shift_search_2_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_10))) * 64);
      slice0cost_pixels_first_2_4 <= ((as_number(((((slice0shift_search_2_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value)) + as_number(((((slice0shift_search_2_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_2)) + as_number(((((slice0shift_search_2_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice0shift_search_2_4 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_4)) + as_number(((((slice0shift_search_2_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_5)) + ((as_number(((((slice0shift_search_2_4 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_6)) + as_number(((((slice0shift_search_2_4 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_7)) + as_number(((((slice0shift_search_2_4 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice0shift_search_2_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_9)) + as_number((((slice0shift_search_2_4 / 2048) = 1) /=
        ((slice0shift_reference_2 / 2048) = 1))) + as_number(((((slice0shift_search_2_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_10))) * 64);
      slice0cost_pixels_first_2_5 <= ((as_number(((((slice0shift_search_2_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value)) + as_number(((((slice0shift_search_2_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_2)) + as_number(((((slice0shift_search_2_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice0shift_search_2_5 mod 2) = 1) /=
        ((slice0shift_reference_2 mod 2) = 1))) + as_number(((((slice0shift_search_2_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_4)) + as_number(((((slice0shift_search_2_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_5)) + ((as_number(((((slice0shift_search_2_5 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_6)) + as_number(((((slice0shift_search_2_5 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_7)) + as_number(((((slice0shift_search_2_5 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice0shift_search_2_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_9)) + as_number((((slice0shift_search_2_5 / 2048) = 1) /=
        ((slice0shift_reference_2 / 2048) = 1))) + as_number(((((slice0shift_search_2_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_2_0_value_10))) * 64);
      slice0cost_pixels_first_3_0 <= ((as_number((slice0cost_pixels_first_3_0_value /= (((slice0shift_search_3_0 / 8)
        mod 2) = 1))) + as_number((slice0cost_pixels_first_3_0_value_2 /= (((slice0shift_search_3_0 / 32) mod 2) = 1)))
        + as_number((slice0cost_pixels_first_3_0_value_3 /= (((slice0shift_search_3_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice0shift_reference_3 mod 2) = 1) /= ((slice0shift_search_3_0 mod 2) = 1))) +
        as_number((slice0cost_pixels_first_3_0_value_4 /= (((slice0shift_search_3_0 / 4) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_3_0_value_5 /= (((slice0shift_search_3_0 / 2) mod 2) = 1))) +
        ((as_number((slice0cost_pixels_first_3_0_value_6 /= (((slice0shift_search_3_0 / 64) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_3_0_value_7 /= (((slice0shift_search_3_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_3_0_value_8 /= (((slice0shift_search_3_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice0cost_pixels_first_3_0_value_9 /= (((slice0shift_search_3_0 / 512) mod 2) = 1))) +
        as_number((((slice0shift_reference_3 / 2048) = 1) /= ((slice0shift_search_3_0 / 2048) = 1))) +
        as_number((slice0cost_pixels_first_3_0_value_10 /= (((slice0shift_search_3_0 / 1024) mod 2) = 1)))) * 64);
      slice0cost_pixels_first_3_1 <= ((as_number(((((slice0shift_search_3_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value)) + as_number(((((slice0shift_search_3_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_2)) + as_number(((((slice0shift_search_3_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice0shift_search_3_1 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_4)) + as_number(((((slice0shift_search_3_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_5)) + ((as_number(((((slice0shift_search_3_1 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_6)) + as_number(((((slice0shift_search_3_1 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_7)) + as_number(((((slice0shift_search_3_1 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice0shift_search_3_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_9)) + as_number((((slice0shift_search_3_1 / 2048) = 1) /=
        ((slice0shift_reference_3 / 2048) = 1))) + as_number(((((slice0shift_search_3_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_10))) * 64);
      slice0cost_pixels_first_3_2 <= ((as_number(((((slice0shift_search_3_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value)) + as_number(((((slice0shift_search_3_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_2)) + as_number(((((slice0shift_search_3_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice0shift_search_3_2 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_4)) + as_number(((((slice0shift_search_3_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_5)) + ((as_number(((((slice0shift_search_3_2 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_6)) + as_number(((((slice0shift_search_3_2 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_7)) + as_number(((((slice0shift_search_3_2 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice0shift_search_3_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_9)) + as_number((((slice0shift_search_3_2 / 2048) = 1) /=
        ((slice0shift_reference_3 / 2048) = 1))) + as_number(((((slice0shift_search_3_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_10))) * 64);
      slice0cost_pixels_first_3_3 <= ((as_number(((((slice0shift_search_3_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value)) + as_number(((((slice0shift_search_3_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_2)) + as_number(((((slice0shift_search_3_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice0shift_search_3_3 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_4)) + as_number(((((slice0shift_search_3_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_5)) + ((as_number(((((slice0shift_search_3_3 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_6)) + as_number(((((slice0shift_search_3_3 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_7)) + as_number(((((slice0shift_search_3_3 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice0shift_search_3_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_9)) + as_number((((slice0shift_search_3_3 / 2048) = 1) /=
        ((slice0shift_reference_3 / 2048) = 1))) + as_number(((((slice0shift_search_3_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_10))) * 64);
      slice0cost_pixels_first_3_4 <= ((as_number(((((slice0shift_search_3_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value)) + as_number(((((slice0shift_search_3_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_2)) + as_number(((((slice0shift_search_3_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice0shift_search_3_4 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_4)) + as_number(((((slice0shift_search_3_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_5)) + ((as_number(((((slice0shift_search_3_4 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_6)) + as_number(((((slice0shift_search_3_4 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_7)) + as_number(((((slice0shift_search_3_4 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice0shift_search_3_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_9)) + as_number((((slice0shift_search_3_4 / 2048) = 1) /=
        ((slice0shift_reference_3 / 2048) = 1))) + as_number(((((slice0shift_search_3_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_10))) * 64);
      slice0cost_pixels_first_3_5 <= ((as_number(((((slice0shift_search_3_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value)) + as_number(((((slice0shift_search_3_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_2)) + as_number(((((slice0shift_search_3_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice0shift_search_3_5 mod 2) = 1) /=
        ((slice0shift_reference_3 mod 2) = 1))) + as_number(((((slice0shift_search_3_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_4)) + as_number(((((slice0shift_search_3_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_5)) + ((as_number(((((slice0shift_search_3_5 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_6)) + as_number(((((slice0shift_search_3_5 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_7)) + as_number(((((slice0shift_search_3_5 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice0shift_search_3_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_9)) + as_number((((slice0shift_search_3_5 / 2048) = 1) /=
        ((slice0shift_reference_3 / 2048) = 1))) + as_number(((((slice0shift_search_3_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_3_0_value_10))) * 64);
      slice0cost_pixels_first_4_0 <= ((as_number((slice0cost_pixels_first_4_0_value /= (((slice0shift_search_4_0 / 8)
        mod 2) = 1))) + as_number((slice0cost_pixels_first_4_0_value_2 /= (((slice0shift_search_4_0 / 32) mod 2) = 1)))
        + as_number((slice0cost_pixels_first_4_0_value_3 /= (((slice0shift_search_4_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice0shift_reference_4 mod 2) = 1) /= ((slice0shift_search_4_0 mod 2) = 1))) +
        as_number((slice0cost_pixels_first_4_0_value_4 /= (((slice0shift_search_4_0 / 4) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_4_0_value_5 /= (((slice0shift_search_4_0 / 2) mod 2) = 1))) +
        ((as_number((slice0cost_pixels_first_4_0_value_6 /= (((slice0shift_search_4_0 / 64) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_4_0_value_7 /= (((slice0shift_search_4_0 / 256) mod 2) = 1))) +
        as_number((slice0cost_pixels_first_4_0_value_8 /= (((slice0shift_search_4_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice0cost_pixels_first_4_0_value_9 /= (((slice0shift_search_4_0 / 512) mod 2) = 1))) +
        as_number((((slice0shift_reference_4 / 2048) = 1) /= ((slice0shift_search_4_0 / 2048) = 1))) +
        as_number((slice0cost_pixels_first_4_0_value_10 /= (((slice0shift_search_4_0 / 1024) mod 2) = 1)))) * 64);
      slice0cost_pixels_first_4_1 <= ((as_number(((((slice0shift_search_4_1 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value)) + as_number(((((slice0shift_search_4_1 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_2)) + as_number(((((slice0shift_search_4_1 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice0shift_search_4_1 mod 2) = 1) /=
        ((slice0shift_reference_4 mod 2) = 1))) + as_number(((((slice0shift_search_4_1 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_4)) + as_number(((((slice0shift_search_4_1 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_5)) + ((as_number(((((slice0shift_search_4_1 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_6)) + as_number(((((slice0shift_search_4_1 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_7)) + as_number(((((slice0shift_search_4_1 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice0shift_search_4_1 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_9)) + as_number((((slice0shift_search_4_1 / 2048) = 1) /=
        ((slice0shift_reference_4 / 2048) = 1))) + as_number(((((slice0shift_search_4_1 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_10))) * 64);
      slice0cost_pixels_first_4_2 <= ((as_number(((((slice0shift_search_4_2 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value)) + as_number(((((slice0shift_search_4_2 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_2)) + as_number(((((slice0shift_search_4_2 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice0shift_search_4_2 mod 2) = 1) /=
        ((slice0shift_reference_4 mod 2) = 1))) + as_number(((((slice0shift_search_4_2 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_4)) + as_number(((((slice0shift_search_4_2 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_5)) + ((as_number(((((slice0shift_search_4_2 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_6)) + as_number(((((slice0shift_search_4_2 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_7)) + as_number(((((slice0shift_search_4_2 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice0shift_search_4_2 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_9)) + as_number((((slice0shift_search_4_2 / 2048) = 1) /=
        ((slice0shift_reference_4 / 2048) = 1))) + as_number(((((slice0shift_search_4_2 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_10))) * 64);
      slice0cost_pixels_first_4_3 <= ((as_number(((((slice0shift_search_4_3 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value)) + as_number(((((slice0shift_search_4_3 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_2)) + as_number(((((slice0shift_search_4_3 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice0shift_search_4_3 mod 2) = 1) /=
        ((slice0shift_reference_4 mod 2) = 1))) + as_number(((((slice0shift_search_4_3 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_4)) + as_number(((((slice0shift_search_4_3 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_5)) + ((as_number(((((slice0shift_search_4_3 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_6)) + as_number(((((slice0shift_search_4_3 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_7)) + as_number(((((slice0shift_search_4_3 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice0shift_search_4_3 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_9)) + as_number((((slice0shift_search_4_3 / 2048) = 1) /=
        ((slice0shift_reference_4 / 2048) = 1))) + as_number(((((slice0shift_search_4_3 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_10))) * 64);
      slice0cost_pixels_first_4_4 <= ((as_number(((((slice0shift_search_4_4 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value)) + as_number(((((slice0shift_search_4_4 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_2)) + as_number(((((slice0shift_search_4_4 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice0shift_search_4_4 mod 2) = 1) /=
        ((slice0shift_reference_4 mod 2) = 1))) + as_number(((((slice0shift_search_4_4 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_4)) + as_number(((((slice0shift_search_4_4 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_5)) + ((as_number(((((slice0shift_search_4_4 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_6)) + as_number(((((slice0shift_search_4_4 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_7)) + as_number(((((slice0shift_search_4_4 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice0shift_search_4_4 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_9)) + as_number((((slice0shift_search_4_4 / 2048) = 1) /=
        ((slice0shift_reference_4 / 2048) = 1))) + as_number(((((slice0shift_search_4_4 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_10))) * 64);
      slice0cost_pixels_first_4_5 <= ((as_number(((((slice0shift_search_4_5 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value)) + as_number(((((slice0shift_search_4_5 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_2)) + as_number(((((slice0shift_search_4_5 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice0shift_search_4_5 mod 2) = 1) /=
        ((slice0shift_reference_4 mod 2) = 1))) + as_number(((((slice0shift_search_4_5 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_4)) + as_number(((((slice0shift_search_4_5 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_5)) + ((as_number(((((slice0shift_search_4_5 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_6)) + as_number(((((slice0shift_search_4_5 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_7)) + as_number(((((slice0shift_search_4_5 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice0shift_search_4_5 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_9)) + as_number((((slice0shift_search_4_5 / 2048) = 1) /=
        ((slice0shift_reference_4 / 2048) = 1))) + as_number(((((slice0shift_search_4_5 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_4_0_value_10))) * 64);
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      slice0cost_pixels_cost_0_0 <= (((slice0cost_pixels_first_0_0 mod 4) + (((slice0cost_pixels_first_0_0 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_0 / 16) mod 4) + (slice0cost_pixels_first_0_0 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_0 / 16) + (slice0cost_pixels_first_0_0 / 64)) mod 2);
      slice0cost_pixels_cost_0_1 <= (((slice0cost_pixels_first_0_1 mod 4) + (((slice0cost_pixels_first_0_1 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_1 / 16) mod 4) + (slice0cost_pixels_first_0_1 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_1 / 16) + (slice0cost_pixels_first_0_1 / 64)) mod 2);
      slice0cost_pixels_cost_0_2 <= (((slice0cost_pixels_first_0_2 mod 4) + (((slice0cost_pixels_first_0_2 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_2 / 16) mod 4) + (slice0cost_pixels_first_0_2 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_2 / 16) + (slice0cost_pixels_first_0_2 / 64)) mod 2);
      slice0cost_pixels_cost_0_3 <= (((slice0cost_pixels_first_0_3 mod 4) + (((slice0cost_pixels_first_0_3 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_3 / 16) mod 4) + (slice0cost_pixels_first_0_3 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_3 / 16) + (slice0cost_pixels_first_0_3 / 64)) mod 2);
      slice0cost_pixels_cost_0_4 <= (((slice0cost_pixels_first_0_4 mod 4) + (((slice0cost_pixels_first_0_4 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_4 / 16) mod 4) + (slice0cost_pixels_first_0_4 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_4 / 16) + (slice0cost_pixels_first_0_4 / 64)) mod 2);
      slice0cost_pixels_cost_0_5 <= (((slice0cost_pixels_first_0_5 mod 4) + (((slice0cost_pixels_first_0_5 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_5 / 16) mod 4) + (slice0cost_pixels_first_0_5 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_5 / 16) + (slice0cost_pixels_first_0_5 / 64)) mod 2);
      slice0cost_pixels_cost_1_0 <= (((slice0cost_pixels_first_1_0 mod 4) + (((slice0cost_pixels_first_1_0 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_0 / 16) mod 4) + (slice0cost_pixels_first_1_0 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_0 / 16) + (slice0cost_pixels_first_1_0 / 64)) mod 2);
      slice0cost_pixels_cost_1_1 <= (((slice0cost_pixels_first_1_1 mod 4) + (((slice0cost_pixels_first_1_1 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_1 / 16) mod 4) + (slice0cost_pixels_first_1_1 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_1 / 16) + (slice0cost_pixels_first_1_1 / 64)) mod 2);
      slice0cost_pixels_cost_1_2 <= (((slice0cost_pixels_first_1_2 mod 4) + (((slice0cost_pixels_first_1_2 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_2 / 16) mod 4) + (slice0cost_pixels_first_1_2 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_2 / 16) + (slice0cost_pixels_first_1_2 / 64)) mod 2);
      slice0cost_pixels_cost_1_3 <= (((slice0cost_pixels_first_1_3 mod 4) + (((slice0cost_pixels_first_1_3 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_3 / 16) mod 4) + (slice0cost_pixels_first_1_3 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_3 / 16) + (slice0cost_pixels_first_1_3 / 64)) mod 2);
      slice0cost_pixels_cost_1_4 <= (((slice0cost_pixels_first_1_4 mod 4) + (((slice0cost_pixels_first_1_4 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_4 / 16) mod 4) + (slice0cost_pixels_first_1_4 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_4 / 16) + (slice0cost_pixels_first_1_4 / 64)) mod 2);
      slice0cost_pixels_cost_1_5 <= (((slice0cost_pixels_first_1_5 mod 4) + (((slice0cost_pixels_first_1_5 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_5 / 16) mod 4) + (slice0cost_pixels_first_1_5 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_5 / 16) + (slice0cost_pixels_first_1_5 / 64)) mod 2);
      slice0cost_pixels_cost_2_0 <= (((slice0cost_pixels_first_2_0 mod 4) + (((slice0cost_pixels_first_2_0 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_0 / 16) mod 4) + (slice0cost_pixels_first_2_0 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_0 / 16) + (slice0cost_pixels_first_2_0 / 64)) mod 2);
      slice0cost_pixels_cost_2_1 <= (((slice0cost_pixels_first_2_1 mod 4) + (((slice0cost_pixels_first_2_1 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_1 / 16) mod 4) + (slice0cost_pixels_first_2_1 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_1 / 16) + (slice0cost_pixels_first_2_1 / 64)) mod 2);
      slice0cost_pixels_cost_2_2 <= (((slice0cost_pixels_first_2_2 mod 4) + (((slice0cost_pixels_first_2_2 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_2 / 16) mod 4) + (slice0cost_pixels_first_2_2 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_2 / 16) + (slice0cost_pixels_first_2_2 / 64)) mod 2);
      slice0cost_pixels_cost_2_3 <= (((slice0cost_pixels_first_2_3 mod 4) + (((slice0cost_pixels_first_2_3 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_3 / 16) mod 4) + (slice0cost_pixels_first_2_3 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_3 / 16) + (slice0cost_pixels_first_2_3 / 64)) mod 2);
      slice0cost_pixels_cost_2_4 <= (((slice0cost_pixels_first_2_4 mod 4) + (((slice0cost_pixels_first_2_4 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_4 / 16) mod 4) + (slice0cost_pixels_first_2_4 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_4 / 16) + (slice0cost_pixels_first_2_4 / 64)) mod 2);
      slice0cost_pixels_cost_2_5 <= (((slice0cost_pixels_first_2_5 mod 4) + (((slice0cost_pixels_first_2_5 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_2_5 / 16) mod 4) + (slice0cost_pixels_first_2_5 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_2_5 / 16) + (slice0cost_pixels_first_2_5 / 64)) mod 2);
      slice0cost_pixels_cost_3_0 <= (((slice0cost_pixels_first_3_0 mod 4) + (((slice0cost_pixels_first_3_0 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_0 / 16) mod 4) + (slice0cost_pixels_first_3_0 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_0 / 16) + (slice0cost_pixels_first_3_0 / 64)) mod 2);
      slice0cost_pixels_cost_3_1 <= (((slice0cost_pixels_first_3_1 mod 4) + (((slice0cost_pixels_first_3_1 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_1 / 16) mod 4) + (slice0cost_pixels_first_3_1 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_1 / 16) + (slice0cost_pixels_first_3_1 / 64)) mod 2);
      slice0cost_pixels_cost_3_2 <= (((slice0cost_pixels_first_3_2 mod 4) + (((slice0cost_pixels_first_3_2 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_2 / 16) mod 4) + (slice0cost_pixels_first_3_2 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_2 / 16) + (slice0cost_pixels_first_3_2 / 64)) mod 2);
      slice0cost_pixels_cost_3_3 <= (((slice0cost_pixels_first_3_3 mod 4) + (((slice0cost_pixels_first_3_3 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_3 / 16) mod 4) + (slice0cost_pixels_first_3_3 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_3 / 16) + (slice0cost_pixels_first_3_3 / 64)) mod 2);
      slice0cost_pixels_cost_3_4 <= (((slice0cost_pixels_first_3_4 mod 4) + (((slice0cost_pixels_first_3_4 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_4 / 16) mod 4) + (slice0cost_pixels_first_3_4 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_4 / 16) + (slice0cost_pixels_first_3_4 / 64)) mod 2);
      slice0cost_pixels_cost_3_5 <= (((slice0cost_pixels_first_3_5 mod 4) + (((slice0cost_pixels_first_3_5 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_3_5 / 16) mod 4) + (slice0cost_pixels_first_3_5 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_3_5 / 16) + (slice0cost_pixels_first_3_5 / 64)) mod 2);
      slice0cost_pixels_cost_4_0 <= (((slice0cost_pixels_first_4_0 mod 4) + (((slice0cost_pixels_first_4_0 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_0 / 16) mod 4) + (slice0cost_pixels_first_4_0 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_0 / 16) + (slice0cost_pixels_first_4_0 / 64)) mod 2);
      slice0cost_pixels_cost_4_1 <= (((slice0cost_pixels_first_4_1 mod 4) + (((slice0cost_pixels_first_4_1 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_1 / 16) mod 4) + (slice0cost_pixels_first_4_1 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_1 / 16) + (slice0cost_pixels_first_4_1 / 64)) mod 2);
      slice0cost_pixels_cost_4_2 <= (((slice0cost_pixels_first_4_2 mod 4) + (((slice0cost_pixels_first_4_2 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_2 / 16) mod 4) + (slice0cost_pixels_first_4_2 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_2 / 16) + (slice0cost_pixels_first_4_2 / 64)) mod 2);
      slice0cost_pixels_cost_4_3 <= (((slice0cost_pixels_first_4_3 mod 4) + (((slice0cost_pixels_first_4_3 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_3 / 16) mod 4) + (slice0cost_pixels_first_4_3 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_3 / 16) + (slice0cost_pixels_first_4_3 / 64)) mod 2);
      slice0cost_pixels_cost_4_4 <= (((slice0cost_pixels_first_4_4 mod 4) + (((slice0cost_pixels_first_4_4 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_4 / 16) mod 4) + (slice0cost_pixels_first_4_4 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_4 / 16) + (slice0cost_pixels_first_4_4 / 64)) mod 2);
      slice0cost_pixels_cost_4_5 <= (((slice0cost_pixels_first_4_5 mod 4) + (((slice0cost_pixels_first_4_5 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_4_5 / 16) mod 4) + (slice0cost_pixels_first_4_5 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_4_5 / 16) + (slice0cost_pixels_first_4_5 / 64)) mod 2);
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_pair_0_0 <= slice0cost_pixels_cost_1_0 + slice0cost_pixels_cost_2_0;
      slice0cost_pair_0_1 <= slice0cost_pixels_cost_1_1 + slice0cost_pixels_cost_2_1;
      slice0cost_pair_0_2 <= slice0cost_pixels_cost_1_2 + slice0cost_pixels_cost_2_2;
      slice0cost_pair_0_3 <= slice0cost_pixels_cost_1_3 + slice0cost_pixels_cost_2_3;
      slice0cost_pair_0_4 <= slice0cost_pixels_cost_1_4 + slice0cost_pixels_cost_2_4;
      slice0cost_pair_0_5 <= slice0cost_pixels_cost_1_5 + slice0cost_pixels_cost_2_5;
      slice0cost_pair_1_0 <= slice0cost_pixels_cost_3_0 + slice0cost_pixels_cost_4_0;
      slice0cost_pair_1_1 <= slice0cost_pixels_cost_3_1 + slice0cost_pixels_cost_4_1;
      slice0cost_pair_1_2 <= slice0cost_pixels_cost_3_2 + slice0cost_pixels_cost_4_2;
      slice0cost_pair_1_3 <= slice0cost_pixels_cost_3_3 + slice0cost_pixels_cost_4_3;
      slice0cost_pair_1_4 <= slice0cost_pixels_cost_3_4 + slice0cost_pixels_cost_4_4;
      slice0cost_pair_1_5 <= slice0cost_pixels_cost_3_5 + slice0cost_pixels_cost_4_5;
      slice0cost_single_0_0 <= slice0cost_pixels_cost_0_0;
      slice0cost_single_0_1 <= slice0cost_pixels_cost_0_1;
      slice0cost_single_0_2 <= slice0cost_pixels_cost_0_2;
      slice0cost_single_0_3 <= slice0cost_pixels_cost_0_3;
      slice0cost_single_0_4 <= slice0cost_pixels_cost_0_4;
      slice0cost_single_0_5 <= slice0cost_pixels_cost_0_5;
      slice0cost_pair_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_single_0_0 + slice0cost_pair_0_0 + slice0cost_pair_1_0;
      slice0cost_column_0_1 <= slice0cost_single_0_1 + slice0cost_pair_0_1 + slice0cost_pair_1_1;
      slice0cost_column_0_2 <= slice0cost_single_0_2 + slice0cost_pair_0_2 + slice0cost_pair_1_2;
      slice0cost_column_0_3 <= slice0cost_single_0_3 + slice0cost_pair_0_3 + slice0cost_pair_1_3;
      slice0cost_column_0_4 <= slice0cost_single_0_4 + slice0cost_pair_0_4 + slice0cost_pair_1_4;
      slice0cost_column_0_5 <= slice0cost_single_0_5 + slice0cost_pair_0_5 + slice0cost_pair_1_5;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_pair_tag_first_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_partial_0_0_0 <= slice0cost_column_0_0;
        slice0window_partial_0_0_1 <= slice0cost_column_0_1;
        slice0window_partial_0_0_2 <= slice0cost_column_0_2;
        slice0window_partial_0_0_3 <= slice0cost_column_0_3;
        slice0window_partial_0_0_4 <= slice0cost_column_0_4;
        slice0window_partial_0_0_5 <= slice0cost_column_0_5;
        slice0window_partial_0_1_0 <= slice0window_partial_0_0_0 + slice0cost_column_0_0;
        slice0window_partial_0_1_1 <= slice0window_partial_0_0_1 + slice0cost_column_0_1;
        slice0window_partial_0_1_2 <= slice0window_partial_0_0_2 + slice0cost_column_0_2;
        slice0window_partial_0_1_3 <= slice0window_partial_0_0_3 + slice0cost_column_0_3;
        slice0window_partial_0_1_4 <= slice0window_partial_0_0_4 + slice0cost_column_0_4;
        slice0window_partial_0_1_5 <= slice0window_partial_0_0_5 + slice0cost_column_0_5;
        slice0window_partial_0_2_0 <= slice0window_partial_0_1_0 + slice0cost_column_0_0;
        slice0window_partial_0_2_1 <= slice0window_partial_0_1_1 + slice0cost_column_0_1;
        slice0window_partial_0_2_2 <= slice0window_partial_0_1_2 + slice0cost_column_0_2;
        slice0window_partial_0_2_3 <= slice0window_partial_0_1_3 + slice0cost_column_0_3;
        slice0window_partial_0_2_4 <= slice0window_partial_0_1_4 + slice0cost_column_0_4;
        slice0window_partial_0_2_5 <= slice0window_partial_0_1_5 + slice0cost_column_0_5;
        slice0window_partial_0_3_0 <= slice0window_partial_0_2_0 + slice0cost_column_0_0;
        slice0window_partial_0_3_1 <= slice0window_partial_0_2_1 + slice0cost_column_0_1;
        slice0window_partial_0_3_2 <= slice0window_partial_0_2_2 + slice0cost_column_0_2;
        slice0window_partial_0_3_3 <= slice0window_partial_0_2_3 + slice0cost_column_0_3;
        slice0window_partial_0_3_4 <= slice0window_partial_0_2_4 + slice0cost_column_0_4;
        slice0window_partial_0_3_5 <= slice0window_partial_0_2_5 + slice0cost_column_0_5;
        slice0window_centre_first_column_1 <= slice1cost_tag_first_column;
      end if;
      slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
      slice0window_centre_first_column_0 <= slice0cost_tag_first_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0window_partial_0_3_0 + slice0cost_column_0_0;
      slice0window_sum_0_1 <= slice0window_partial_0_3_1 + slice0cost_column_0_1;
      slice0window_sum_0_2 <= slice0window_partial_0_3_2 + slice0cost_column_0_2;
      slice0window_sum_0_3 <= slice0window_partial_0_3_3 + slice0cost_column_0_3;
      slice0window_sum_0_4 <= slice0window_partial_0_3_4 + slice0cost_column_0_4;
      slice0window_sum_0_5 <= slice0window_partial_0_3_5 + slice0cost_column_0_5;
      slice0window_tag_valid <= slice0cost_tag_valid;
      if slice0window_tag_valid then
        slice0window_centre_start_of_frame_1 <= slice0window_centre_start_of_frame_0;
        slice0window_tag_output_column <= slice1window_centre_output_column_0;
        slice0window_tag_first_column <= slice1window_centre_first_column_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_1;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_0;
      end if;
      -- slice0mask
      if slice0cost_tag_valid then
        slice0mask_inside_0_choice := slice0mask_inside_1;
      else
        slice0mask_inside_0_choice := slice0mask_inside_0;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_1_choice := slice0mask_inside_2;
      else
        slice0mask_inside_1_choice := slice0mask_inside_1;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_2_choice := slice0mask_inside_3;
      else
        slice0mask_inside_2_choice := slice0mask_inside_2;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_3_choice := slice0mask_inside_4;
      else
        slice0mask_inside_3_choice := slice0mask_inside_3;
      end if;
      if slice0cost_tag_valid then
        slice0mask_inside_4_choice := slice0mask_inside_5;
      else
        slice0mask_inside_4_choice := slice0mask_inside_4;
      end if;
      if (slice0mask_column / 32) = 1 then
        slice0mask_inside_5_choice := not slice0window_centre_first_column_1;
      else
        slice0mask_inside_5_choice := (not slice0window_centre_first_column_1) and (((slice0mask_column / 8) mod 4) =
          3);
      end if;
      slice0mask_left_out <= slice0mask_inside_0;
      if slice0window_centre_first_column_1 then
        slice0mask_inside_0 <= slice0cost_tag_valid or slice0mask_inside_0;
        slice0mask_inside_1 <= slice0cost_tag_valid or slice0mask_inside_1;
        slice0mask_inside_2 <= slice0cost_tag_valid or slice0mask_inside_2;
        slice0mask_inside_3 <= slice0cost_tag_valid or slice0mask_inside_3;
        slice0mask_inside_4 <= slice0cost_tag_valid or slice0mask_inside_4;
      else
        slice0mask_inside_0 <= slice0mask_inside_0_choice;
        slice0mask_inside_1 <= slice0mask_inside_1_choice;
        slice0mask_inside_2 <= slice0mask_inside_2_choice;
        slice0mask_inside_3 <= slice0mask_inside_3_choice;
        slice0mask_inside_4 <= slice0mask_inside_4_choice;
      end if;
      if slice0mask_inside_5_choice then
        slice0mask_inside_5 <= (not slice0cost_tag_valid) and slice0mask_inside_5;
      else
        slice0mask_inside_5 <= slice0cost_tag_valid or slice0mask_inside_5;
      end if;
      if slice0cost_tag_valid then
        if slice0window_centre_first_column_1 then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 64;
        end if;
      end if;
      -- slice0winner1
      if slice0mask_inside_1 then
        slice0winner1_best_cost_0_0_choice := 0;
      else
        slice0winner1_best_cost_0_0_choice := 511;
      end if;
      slice0winner1_best_cost_0_0_any := to_integer(((to_unsigned(slice0window_sum_0_1, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_0_choice, 9))));
      if slice0mask_inside_0 then
        slice0winner1_best_cost_0_0_choice_2 := 0;
      else
        slice0winner1_best_cost_0_0_choice_2 := 511;
      end if;
      slice0winner1_best_cost_0_0_any_2 := to_integer(((to_unsigned(slice0window_sum_0_0, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_0_choice_2, 9))));
      slice0winner1_best_cost_0_0_is_less := (slice0winner1_best_cost_0_0_any - slice0winner1_best_cost_0_0_any_2) < 0;
      if slice0mask_inside_3 then
        slice0winner1_best_cost_0_1_choice := 0;
      else
        slice0winner1_best_cost_0_1_choice := 511;
      end if;
      slice0winner1_best_cost_0_1_any := to_integer(((to_unsigned(slice0window_sum_0_3, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_1_choice, 9))));
      if slice0mask_inside_2 then
        slice0winner1_best_cost_0_1_choice_2 := 0;
      else
        slice0winner1_best_cost_0_1_choice_2 := 511;
      end if;
      slice0winner1_best_cost_0_1_any_2 := to_integer(((to_unsigned(slice0window_sum_0_2, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_1_choice_2, 9))));
      slice0winner1_best_cost_0_1_is_less := (slice0winner1_best_cost_0_1_any - slice0winner1_best_cost_0_1_any_2) < 0;
      if slice0mask_inside_5 then
        slice0winner1_best_cost_0_2_choice := 0;
      else
        slice0winner1_best_cost_0_2_choice := 511;
      end if;
      slice0winner1_best_cost_0_2_any := to_integer(((to_unsigned(slice0window_sum_0_5, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_2_choice, 9))));
      if slice0mask_inside_4 then
        slice0winner1_best_cost_0_2_choice_2 := 0;
      else
        slice0winner1_best_cost_0_2_choice_2 := 511;
      end if;
      slice0winner1_best_cost_0_2_any_2 := to_integer(((to_unsigned(slice0window_sum_0_4, 9)) or
        (to_unsigned(slice0winner1_best_cost_0_2_choice_2, 9))));
      slice0winner1_best_cost_0_2_is_less := (slice0winner1_best_cost_0_2_any - slice0winner1_best_cost_0_2_any_2) < 0;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_first_0_0 <= slice0winner1_best_cost_0_0_any_2;
      slice0winner1_best_first_0_1 <= slice0winner1_best_cost_0_1_any_2;
      slice0winner1_best_first_0_2 <= slice0winner1_best_cost_0_2_any_2;
      slice0winner1_best_last_0_0 <= slice0winner1_best_cost_0_0_any;
      slice0winner1_best_last_0_1 <= slice0winner1_best_cost_0_1_any;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0winner1_best_cost_0_0_any;
        slice0winner1_best_below_0_0 <= slice0winner1_best_cost_0_0_any_2;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_cost_0_0 <= slice0winner1_best_cost_0_0_any_2;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0winner1_best_cost_0_0_any;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0winner1_best_cost_0_1_any;
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0winner1_best_cost_0_1_any_2;
        slice0winner1_best_above_0_1 <= 0;
      else
        slice0winner1_best_cost_0_1 <= slice0winner1_best_cost_0_1_any_2;
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0winner1_best_cost_0_1_any;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0winner1_best_cost_0_2_any;
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0winner1_best_cost_0_2_any_2;
        slice0winner1_best_above_0_2 <= 0;
      else
        slice0winner1_best_cost_0_2 <= slice0winner1_best_cost_0_2_any_2;
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0winner1_best_cost_0_2_any;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      if slice0winner1_best_index_0_1 = 2 then
        slice0winner2_best_below_0_0_choice := slice0winner1_best_last_0_0;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_best_first_0_1;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_2;
      slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
      slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;
      slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_2;
      slice0winner2_best_first_0_0 <= slice0winner1_best_first_0_0;
      slice0winner2_best_first_0_1 <= slice0winner1_best_first_0_2;
      slice0winner2_best_last_0_0 <= slice0winner1_best_last_0_1;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_1;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
        slice0winner2_best_below_0_0 <= slice0winner2_best_below_0_0_choice;
        slice0winner2_best_above_0_0 <= slice0winner1_best_above_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
        slice0winner2_best_below_0_0 <= slice0winner1_best_below_0_0;
        slice0winner2_best_above_0_0 <= slice0winner2_best_above_0_0_choice;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      if ((slice0winner2_best_index_0_1 / 4) = 1) and (not ((slice0winner2_best_index_0_1 mod 2) = 1)) then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      if slice0winner2_best_index_0_0 = 3 then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      slice0winner3_best_first_0_0 <= slice0winner2_best_first_0_0;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if slice0winner3_best_cost_0_0_is_less then
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_1;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0_0 <= slice0winner3_best_below_0_0_choice;
        slice0winner3_best_above_0_0 <= slice0winner2_best_above_0_1;
      else
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_0;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0_0 <= slice0winner2_best_below_0_0;
        slice0winner3_best_above_0_0 <= slice0winner3_best_above_0_0_choice;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner3_best_cost_0_0;
      slice0_best_index_0_0 <= (((slice0winner3_best_index_0_0 / 2) + 3) * 2) + (slice0winner3_best_index_0_0 mod 2);
      slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
      slice0_best_first_0_0 <= slice0winner3_best_first_0_0;
      slice0_best_tag_valid <= slice0winner3_tag_valid;
      slice0_best_tag_output_column <= slice0winner3_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner3_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice1shift_search_0_1;
        slice1shift_search_0_1 <= slice1shift_search_0_2;
        slice1shift_search_0_2 <= slice1shift_search_0_3;
        slice1shift_search_0_3 <= slice1shift_search_0_4;
        slice1shift_search_0_4 <= slice1shift_search_0_5;
        slice1shift_search_0_5 <= slice0shift_search_out_0;
        slice1shift_search_1_0 <= slice1shift_search_1_1;
        slice1shift_search_1_1 <= slice1shift_search_1_2;
        slice1shift_search_1_2 <= slice1shift_search_1_3;
        slice1shift_search_1_3 <= slice1shift_search_1_4;
        slice1shift_search_1_4 <= slice1shift_search_1_5;
        slice1shift_search_1_5 <= slice0shift_search_out_1;
        slice1shift_search_2_0 <= slice1shift_search_2_1;
        slice1shift_search_2_1 <= slice1shift_search_2_2;
        slice1shift_search_2_2 <= slice1shift_search_2_3;
        slice1shift_search_2_3 <= slice1shift_search_2_4;
        slice1shift_search_2_4 <= slice1shift_search_2_5;
        slice1shift_search_2_5 <= slice0shift_search_out_2;
        slice1shift_search_3_0 <= slice1shift_search_3_1;
        slice1shift_search_3_1 <= slice1shift_search_3_2;
        slice1shift_search_3_2 <= slice1shift_search_3_3;
        slice1shift_search_3_3 <= slice1shift_search_3_4;
        slice1shift_search_3_4 <= slice1shift_search_3_5;
        slice1shift_search_3_5 <= slice0shift_search_out_3;
        slice1shift_search_4_0 <= slice1shift_search_4_1;
        slice1shift_search_4_1 <= slice1shift_search_4_2;
        slice1shift_search_4_2 <= slice1shift_search_4_3;
        slice1shift_search_4_3 <= slice1shift_search_4_4;
        slice1shift_search_4_4 <= slice1shift_search_4_5;
        slice1shift_search_4_5 <= slice0shift_search_out_4;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
      slice1shift_reference_2 <= slice0shift_reference_2;
      slice1shift_reference_3 <= slice0shift_reference_3;
      slice1shift_reference_4 <= slice0shift_reference_4;
      -- slice1cost
      slice1cost_pixels_first_0_0_value := ((slice1shift_reference_0 / 8) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_2 := ((slice1shift_reference_0 / 32) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_3 := ((slice1shift_reference_0 / 16) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_4 := ((slice1shift_reference_0 / 4) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_5 := ((slice1shift_reference_0 / 2) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_6 := ((slice1shift_reference_0 / 64) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_7 := ((slice1shift_reference_0 / 256) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_8 := ((slice1shift_reference_0 / 128) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_9 := ((slice1shift_reference_0 / 512) mod 2) = 1;
      slice1cost_pixels_first_0_0_value_10 := ((slice1shift_reference_0 / 1024) mod 2) = 1;
      slice1cost_pixels_first_1_0_value := ((slice1shift_reference_1 / 8) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_2 := ((slice1shift_reference_1 / 32) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_3 := ((slice1shift_reference_1 / 16) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_4 := ((slice1shift_reference_1 / 4) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_5 := ((slice1shift_reference_1 / 2) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_6 := ((slice1shift_reference_1 / 64) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_7 := ((slice1shift_reference_1 / 256) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_8 := ((slice1shift_reference_1 / 128) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_9 := ((slice1shift_reference_1 / 512) mod 2) = 1;
      slice1cost_pixels_first_1_0_value_10 := ((slice1shift_reference_1 / 1024) mod 2) = 1;
      slice1cost_pixels_first_2_0_value := ((slice1shift_reference_2 / 8) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_2 := ((slice1shift_reference_2 / 32) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_3 := ((slice1shift_reference_2 / 16) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_4 := ((slice1shift_reference_2 / 4) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_5 := ((slice1shift_reference_2 / 2) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_6 := ((slice1shift_reference_2 / 64) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_7 := ((slice1shift_reference_2 / 256) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_8 := ((slice1shift_reference_2 / 128) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_9 := ((slice1shift_reference_2 / 512) mod 2) = 1;
      slice1cost_pixels_first_2_0_value_10 := ((slice1shift_reference_2 / 1024) mod 2) = 1;
      slice1cost_pixels_first_3_0_value := ((slice1shift_reference_3 / 8) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_2 := ((slice1shift_reference_3 / 32) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_3 := ((slice1shift_reference_3 / 16) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_4 := ((slice1shift_reference_3 / 4) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_5 := ((slice1shift_reference_3 / 2) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_6 := ((slice1shift_reference_3 / 64) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_7 := ((slice1shift_reference_3 / 256) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_8 := ((slice1shift_reference_3 / 128) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_9 := ((slice1shift_reference_3 / 512) mod 2) = 1;
      slice1cost_pixels_first_3_0_value_10 := ((slice1shift_reference_3 / 1024) mod 2) = 1;
      slice1cost_pixels_first_4_0_value := ((slice1shift_reference_4 / 8) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_2 := ((slice1shift_reference_4 / 32) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_3 := ((slice1shift_reference_4 / 16) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_4 := ((slice1shift_reference_4 / 4) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_5 := ((slice1shift_reference_4 / 2) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_6 := ((slice1shift_reference_4 / 64) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_7 := ((slice1shift_reference_4 / 256) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_8 := ((slice1shift_reference_4 / 128) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_9 := ((slice1shift_reference_4 / 512) mod 2) = 1;
      slice1cost_pixels_first_4_0_value_10 := ((slice1shift_reference_4 / 1024) mod 2) = 1;
      slice1cost_pixels_first_0_0 <= ((as_number((slice1cost_pixels_first_0_0_value /= (((slice1shift_search_0_0 / 8)
        mod 2) = 1))) + as_number((slice1cost_pixels_first_0_0_value_2 /= (((slice1shift_search_0_0 / 32) mod 2) = 1)))
        + as_number((slice1cost_pixels_first_0_0_value_3 /= (((slice1shift_search_0_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice1shift_reference_0 mod 2) = 1) /= ((slice1shift_search_0_0 mod 2) = 1))) +
        as_number((slice1cost_pixels_first_0_0_value_4 /= (((slice1shift_search_0_0 / 4) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_0_0_value_5 /= (((slice1shift_search_0_0 / 2) mod 2) = 1))) +
        ((as_number((slice1cost_pixels_first_0_0_value_6 /= (((slice1shift_search_0_0 / 64) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_0_0_value_7 /= (((slice1shift_search_0_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_0_0_value_8 /= (((slice1shift_search_0_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice1cost_pixels_first_0_0_value_9 /= (((slice1shift_search_0_0 / 512) mod 2) = 1))) +
        as_number((((slice1shift_reference_0 / 2048) = 1) /= ((slice1shift_search_0_0 / 2048) = 1))) +
        as_number((slice1cost_pixels_first_0_0_value_10 /= (((slice1shift_search_0_0 / 1024) mod 2) = 1)))) * 64);
      slice1cost_pixels_first_0_1 <= ((as_number(((((slice1shift_search_0_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_1 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_1 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_1 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_1 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_1 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_2 <= ((as_number(((((slice1shift_search_0_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_2 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_2 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_2 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_2 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_2 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_3 <= ((as_number(((((slice1shift_search_0_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_3 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_3 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_3 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_3 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_3 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_4 <= ((as_number(((((slice1shift_search_0_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_4 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_4 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_4 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_4 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_4 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_5 <= ((as_number(((((slice1shift_search_0_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_5 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_5 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_5 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_5 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_5 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_1_0 <= ((as_number((slice1cost_pixels_first_1_0_value /= (((slice1shift_search_1_0 / 8)
        mod 2) = 1))) + as_number((slice1cost_pixels_first_1_0_value_2 /= (((slice1shift_search_1_0 / 32) mod 2) = 1)))
        + as_number((slice1cost_pixels_first_1_0_value_3 /= (((slice1shift_search_1_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice1shift_reference_1 mod 2) = 1) /= ((slice1shift_search_1_0 mod 2) = 1))) +
        as_number((slice1cost_pixels_first_1_0_value_4 /= (((slice1shift_search_1_0 / 4) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_1_0_value_5 /= (((slice1shift_search_1_0 / 2) mod 2) = 1))) +
        ((as_number((slice1cost_pixels_first_1_0_value_6 /= (((slice1shift_search_1_0 / 64) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_1_0_value_7 /= (((slice1shift_search_1_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_1_0_value_8 /= (((slice1shift_search_1_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice1cost_pixels_first_1_0_value_9 /= (((slice1shift_search_1_0 / 512) mod 2) = 1))) +
        as_number((((slice1shift_reference_1 / 2048) = 1) /= ((slice1shift_search_1_0 / 2048) = 1))) +
        as_number((slice1cost_pixels_first_1_0_value_10 /= (((slice1shift_search_1_0 / 1024) mod 2) = 1)))) * 64);
      slice1cost_pixels_first_1_1 <= ((as_number(((((slice1shift_search_1_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_1 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_1 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_1 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_1 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_1 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_2 <= ((as_number(((((slice1shift_search_1_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_2 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_2 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_2 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_2 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_2 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_3 <= ((as_number(((((slice1shift_search_1_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_3 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_3 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_3 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_3 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_3 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_4 <= ((as_number(((((slice1shift_search_1_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_4 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_4 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_4 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_4 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_4 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_5 <= ((as_number(((((slice1shift_search_1_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_5 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_5 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_5 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_5 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_5 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_2_0 <= ((as_number((slice1cost_pixels_first_2_0_value /= (((slice1shift_search_2_0 / 8)
        mod 2) = 1))) + as_number((slice1cost_pixels_first_2_0_value_2 /= (((slice1shift_search_2_0 / 32) mod 2) = 1)))
        + as_number((slice1cost_pixels_first_2_0_value_3 /= (((slice1shift_search_2_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice1shift_reference_2 mod 2) = 1) /= ((slice1shift_search_2_0 mod 2) = 1))) +
        as_number((slice1cost_pixels_first_2_0_value_4 /= (((slice1shift_search_2_0 / 4) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_2_0_value_5 /= (((slice1shift_search_2_0 / 2) mod 2) = 1))) +
        ((as_number((slice1cost_pixels_first_2_0_value_6 /= (((slice1shift_search_2_0 / 64) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_2_0_value_7 /= (((slice1shift_search_2_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_2_0_value_8 /= (((slice1shift_search_2_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice1cost_pixels_first_2_0_value_9 /= (((slice1shift_search_2_0 / 512) mod 2) = 1))) +
        as_number((((slice1shift_reference_2 / 2048) = 1) /= ((slice1shift_search_2_0 / 2048) = 1))) +
        as_number((slice1cost_pixels_first_2_0_value_10 /= (((slice1shift_search_2_0 / 1024) mod 2) = 1)))) * 64);
      slice1cost_pixels_first_2_1 <= ((as_number(((((slice1shift_search_2_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value)) + as_number(((((slice1shift_search_2_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_2)) + as_number(((((slice1shift_search_2_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice1shift_search_2_1 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_4)) + as_number(((((slice1shift_search_2_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_5)) + ((as_number(((((slice1shift_search_2_1 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_6)) + as_number(((((slice1shift_search_2_1 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_7)) + as_number(((((slice1shift_search_2_1 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice1shift_search_2_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_9)) + as_number((((slice1shift_search_2_1 / 2048) = 1) /=
        ((slice1shift_reference_2 / 2048) = 1))) + as_number(((((slice1shift_search_2_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_10))) * 64);
      slice1cost_pixels_first_2_2 <= ((as_number(((((slice1shift_search_2_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value)) + as_number(((((slice1shift_search_2_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_2)) + as_number(((((slice1shift_search_2_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice1shift_search_2_2 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_4)) + as_number(((((slice1shift_search_2_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_5)) + ((as_number(((((slice1shift_search_2_2 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_6)) + as_number(((((slice1shift_search_2_2 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_7)) + as_number(((((slice1shift_search_2_2 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice1shift_search_2_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_9)) + as_number((((slice1shift_search_2_2 / 2048) = 1) /=
        ((slice1shift_reference_2 / 2048) = 1))) + as_number(((((slice1shift_search_2_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_10))) * 64);
      slice1cost_pixels_first_2_3 <= ((as_number(((((slice1shift_search_2_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value)) + as_number(((((slice1shift_search_2_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_2)) + as_number(((((slice1shift_search_2_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice1shift_search_2_3 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_4)) + as_number(((((slice1shift_search_2_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_5)) + ((as_number(((((slice1shift_search_2_3 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_6)) + as_number(((((slice1shift_search_2_3 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_7)) + as_number(((((slice1shift_search_2_3 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice1shift_search_2_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_9)) + as_number((((slice1shift_search_2_3 / 2048) = 1) /=
        ((slice1shift_reference_2 / 2048) = 1))) + as_number(((((slice1shift_search_2_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_10))) * 64);
      slice1cost_pixels_first_2_4 <= ((as_number(((((slice1shift_search_2_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value)) + as_number(((((slice1shift_search_2_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_2)) + as_number(((((slice1shift_search_2_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice1shift_search_2_4 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_4)) + as_number(((((slice1shift_search_2_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_5)) + ((as_number(((((slice1shift_search_2_4 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_6)) + as_number(((((slice1shift_search_2_4 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_7)) + as_number(((((slice1shift_search_2_4 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice1shift_search_2_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_9)) + as_number((((slice1shift_search_2_4 / 2048) = 1) /=
        ((slice1shift_reference_2 / 2048) = 1))) + as_number(((((slice1shift_search_2_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_10))) * 64);
      slice1cost_pixels_first_2_5 <= ((as_number(((((slice1shift_search_2_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value)) + as_number(((((slice1shift_search_2_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_2)) + as_number(((((slice1shift_search_2_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_3))) * 4) + as_number((((slice1shift_search_2_5 mod 2) = 1) /=
        ((slice1shift_reference_2 mod 2) = 1))) + as_number(((((slice1shift_search_2_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_4)) + as_number(((((slice1shift_search_2_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_5)) + ((as_number(((((slice1shift_search_2_5 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_6)) + as_number(((((slice1shift_search_2_5 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_7)) + as_number(((((slice1shift_search_2_5 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_8))) * 16) + ((as_number(((((slice1shift_search_2_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_9)) + as_number((((slice1shift_search_2_5 / 2048) = 1) /=
        ((slice1shift_reference_2 / 2048) = 1))) + as_number(((((slice1shift_search_2_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_2_0_value_10))) * 64);
      slice1cost_pixels_first_3_0 <= ((as_number((slice1cost_pixels_first_3_0_value /= (((slice1shift_search_3_0 / 8)
        mod 2) = 1))) + as_number((slice1cost_pixels_first_3_0_value_2 /= (((slice1shift_search_3_0 / 32) mod 2) = 1)))
        + as_number((slice1cost_pixels_first_3_0_value_3 /= (((slice1shift_search_3_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice1shift_reference_3 mod 2) = 1) /= ((slice1shift_search_3_0 mod 2) = 1))) +
        as_number((slice1cost_pixels_first_3_0_value_4 /= (((slice1shift_search_3_0 / 4) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_3_0_value_5 /= (((slice1shift_search_3_0 / 2) mod 2) = 1))) +
        ((as_number((slice1cost_pixels_first_3_0_value_6 /= (((slice1shift_search_3_0 / 64) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_3_0_value_7 /= (((slice1shift_search_3_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_3_0_value_8 /= (((slice1shift_search_3_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice1cost_pixels_first_3_0_value_9 /= (((slice1shift_search_3_0 / 512) mod 2) = 1))) +
        as_number((((slice1shift_reference_3 / 2048) = 1) /= ((slice1shift_search_3_0 / 2048) = 1))) +
        as_number((slice1cost_pixels_first_3_0_value_10 /= (((slice1shift_search_3_0 / 1024) mod 2) = 1)))) * 64);
      slice1cost_pixels_first_3_1 <= ((as_number(((((slice1shift_search_3_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value)) + as_number(((((slice1shift_search_3_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_2)) + as_number(((((slice1shift_search_3_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice1shift_search_3_1 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_4)) + as_number(((((slice1shift_search_3_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_5)) + ((as_number(((((slice1shift_search_3_1 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_6)) + as_number(((((slice1shift_search_3_1 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_7)) + as_number(((((slice1shift_search_3_1 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice1shift_search_3_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_9)) + as_number((((slice1shift_search_3_1 / 2048) = 1) /=
        ((slice1shift_reference_3 / 2048) = 1))) + as_number(((((slice1shift_search_3_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_10))) * 64);
      slice1cost_pixels_first_3_2 <= ((as_number(((((slice1shift_search_3_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value)) + as_number(((((slice1shift_search_3_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_2)) + as_number(((((slice1shift_search_3_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice1shift_search_3_2 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_4)) + as_number(((((slice1shift_search_3_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_5)) + ((as_number(((((slice1shift_search_3_2 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_6)) + as_number(((((slice1shift_search_3_2 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_7)) + as_number(((((slice1shift_search_3_2 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice1shift_search_3_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_9)) + as_number((((slice1shift_search_3_2 / 2048) = 1) /=
        ((slice1shift_reference_3 / 2048) = 1))) + as_number(((((slice1shift_search_3_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_10))) * 64);
      slice1cost_pixels_first_3_3 <= ((as_number(((((slice1shift_search_3_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value)) + as_number(((((slice1shift_search_3_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_2)) + as_number(((((slice1shift_search_3_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice1shift_search_3_3 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_4)) + as_number(((((slice1shift_search_3_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_5)) + ((as_number(((((slice1shift_search_3_3 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_6)) + as_number(((((slice1shift_search_3_3 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_7)) + as_number(((((slice1shift_search_3_3 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice1shift_search_3_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_9)) + as_number((((slice1shift_search_3_3 / 2048) = 1) /=
        ((slice1shift_reference_3 / 2048) = 1))) + as_number(((((slice1shift_search_3_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_10))) * 64);
      slice1cost_pixels_first_3_4 <= ((as_number(((((slice1shift_search_3_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value)) + as_number(((((slice1shift_search_3_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_2)) + as_number(((((slice1shift_search_3_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice1shift_search_3_4 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_4)) + as_number(((((slice1shift_search_3_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_5)) + ((as_number(((((slice1shift_search_3_4 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_6)) + as_number(((((slice1shift_search_3_4 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_7)) + as_number(((((slice1shift_search_3_4 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice1shift_search_3_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_9)) + as_number((((slice1shift_search_3_4 / 2048) = 1) /=
        ((slice1shift_reference_3 / 2048) = 1))) + as_number(((((slice1shift_search_3_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_10))) * 64);
      slice1cost_pixels_first_3_5 <= ((as_number(((((slice1shift_search_3_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value)) + as_number(((((slice1shift_search_3_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_2)) + as_number(((((slice1shift_search_3_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_3))) * 4) + as_number((((slice1shift_search_3_5 mod 2) = 1) /=
        ((slice1shift_reference_3 mod 2) = 1))) + as_number(((((slice1shift_search_3_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_4)) + as_number(((((slice1shift_search_3_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_5)) + ((as_number(((((slice1shift_search_3_5 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_6)) + as_number(((((slice1shift_search_3_5 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_7)) + as_number(((((slice1shift_search_3_5 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_8))) * 16) + ((as_number(((((slice1shift_search_3_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_9)) + as_number((((slice1shift_search_3_5 / 2048) = 1) /=
        ((slice1shift_reference_3 / 2048) = 1))) + as_number(((((slice1shift_search_3_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_3_0_value_10))) * 64);
      slice1cost_pixels_first_4_0 <= ((as_number((slice1cost_pixels_first_4_0_value /= (((slice1shift_search_4_0 / 8)
        mod 2) = 1))) + as_number((slice1cost_pixels_first_4_0_value_2 /= (((slice1shift_search_4_0 / 32) mod 2) = 1)))
        + as_number((slice1cost_pixels_first_4_0_value_3 /= (((slice1shift_search_4_0 / 16) mod 2) = 1)))) * 4) +
        as_number((((slice1shift_reference_4 mod 2) = 1) /= ((slice1shift_search_4_0 mod 2) = 1))) +
        as_number((slice1cost_pixels_first_4_0_value_4 /= (((slice1shift_search_4_0 / 4) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_4_0_value_5 /= (((slice1shift_search_4_0 / 2) mod 2) = 1))) +
        ((as_number((slice1cost_pixels_first_4_0_value_6 /= (((slice1shift_search_4_0 / 64) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_4_0_value_7 /= (((slice1shift_search_4_0 / 256) mod 2) = 1))) +
        as_number((slice1cost_pixels_first_4_0_value_8 /= (((slice1shift_search_4_0 / 128) mod 2) = 1)))) * 16) +
        ((as_number((slice1cost_pixels_first_4_0_value_9 /= (((slice1shift_search_4_0 / 512) mod 2) = 1))) +
        as_number((((slice1shift_reference_4 / 2048) = 1) /= ((slice1shift_search_4_0 / 2048) = 1))) +
        as_number((slice1cost_pixels_first_4_0_value_10 /= (((slice1shift_search_4_0 / 1024) mod 2) = 1)))) * 64);
      slice1cost_pixels_first_4_1 <= ((as_number(((((slice1shift_search_4_1 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value)) + as_number(((((slice1shift_search_4_1 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_2)) + as_number(((((slice1shift_search_4_1 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice1shift_search_4_1 mod 2) = 1) /=
        ((slice1shift_reference_4 mod 2) = 1))) + as_number(((((slice1shift_search_4_1 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_4)) + as_number(((((slice1shift_search_4_1 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_5)) + ((as_number(((((slice1shift_search_4_1 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_6)) + as_number(((((slice1shift_search_4_1 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_7)) + as_number(((((slice1shift_search_4_1 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice1shift_search_4_1 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_9)) + as_number((((slice1shift_search_4_1 / 2048) = 1) /=
        ((slice1shift_reference_4 / 2048) = 1))) + as_number(((((slice1shift_search_4_1 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_10))) * 64);
      slice1cost_pixels_first_4_2 <= ((as_number(((((slice1shift_search_4_2 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value)) + as_number(((((slice1shift_search_4_2 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_2)) + as_number(((((slice1shift_search_4_2 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice1shift_search_4_2 mod 2) = 1) /=
        ((slice1shift_reference_4 mod 2) = 1))) + as_number(((((slice1shift_search_4_2 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_4)) + as_number(((((slice1shift_search_4_2 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_5)) + ((as_number(((((slice1shift_search_4_2 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_6)) + as_number(((((slice1shift_search_4_2 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_7)) + as_number(((((slice1shift_search_4_2 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice1shift_search_4_2 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_9)) + as_number((((slice1shift_search_4_2 / 2048) = 1) /=
        ((slice1shift_reference_4 / 2048) = 1))) + as_number(((((slice1shift_search_4_2 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_10))) * 64);
      slice1cost_pixels_first_4_3 <= ((as_number(((((slice1shift_search_4_3 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value)) + as_number(((((slice1shift_search_4_3 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_2)) + as_number(((((slice1shift_search_4_3 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice1shift_search_4_3 mod 2) = 1) /=
        ((slice1shift_reference_4 mod 2) = 1))) + as_number(((((slice1shift_search_4_3 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_4)) + as_number(((((slice1shift_search_4_3 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_5)) + ((as_number(((((slice1shift_search_4_3 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_6)) + as_number(((((slice1shift_search_4_3 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_7)) + as_number(((((slice1shift_search_4_3 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice1shift_search_4_3 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_9)) + as_number((((slice1shift_search_4_3 / 2048) = 1) /=
        ((slice1shift_reference_4 / 2048) = 1))) + as_number(((((slice1shift_search_4_3 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_10))) * 64);
      slice1cost_pixels_first_4_4 <= ((as_number(((((slice1shift_search_4_4 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value)) + as_number(((((slice1shift_search_4_4 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_2)) + as_number(((((slice1shift_search_4_4 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice1shift_search_4_4 mod 2) = 1) /=
        ((slice1shift_reference_4 mod 2) = 1))) + as_number(((((slice1shift_search_4_4 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_4)) + as_number(((((slice1shift_search_4_4 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_5)) + ((as_number(((((slice1shift_search_4_4 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_6)) + as_number(((((slice1shift_search_4_4 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_7)) + as_number(((((slice1shift_search_4_4 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice1shift_search_4_4 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_9)) + as_number((((slice1shift_search_4_4 / 2048) = 1) /=
        ((slice1shift_reference_4 / 2048) = 1))) + as_number(((((slice1shift_search_4_4 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_10))) * 64);
      slice1cost_pixels_first_4_5 <= ((as_number(((((slice1shift_search_4_5 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value)) + as_number(((((slice1shift_search_4_5 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_2)) + as_number(((((slice1shift_search_4_5 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_3))) * 4) + as_number((((slice1shift_search_4_5 mod 2) = 1) /=
        ((slice1shift_reference_4 mod 2) = 1))) + as_number(((((slice1shift_search_4_5 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_4)) + as_number(((((slice1shift_search_4_5 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_5)) + ((as_number(((((slice1shift_search_4_5 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_6)) + as_number(((((slice1shift_search_4_5 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_7)) + as_number(((((slice1shift_search_4_5 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_8))) * 16) + ((as_number(((((slice1shift_search_4_5 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_9)) + as_number((((slice1shift_search_4_5 / 2048) = 1) /=
        ((slice1shift_reference_4 / 2048) = 1))) + as_number(((((slice1shift_search_4_5 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_4_0_value_10))) * 64);
      slice1cost_pixels_cost_0_0 <= (((slice1cost_pixels_first_0_0 mod 4) + (((slice1cost_pixels_first_0_0 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_0 / 16) mod 4) + (slice1cost_pixels_first_0_0 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_0 / 16) + (slice1cost_pixels_first_0_0 / 64)) mod 2);
      slice1cost_pixels_cost_0_1 <= (((slice1cost_pixels_first_0_1 mod 4) + (((slice1cost_pixels_first_0_1 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_1 / 16) mod 4) + (slice1cost_pixels_first_0_1 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_1 / 16) + (slice1cost_pixels_first_0_1 / 64)) mod 2);
      slice1cost_pixels_cost_0_2 <= (((slice1cost_pixels_first_0_2 mod 4) + (((slice1cost_pixels_first_0_2 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_2 / 16) mod 4) + (slice1cost_pixels_first_0_2 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_2 / 16) + (slice1cost_pixels_first_0_2 / 64)) mod 2);
      slice1cost_pixels_cost_0_3 <= (((slice1cost_pixels_first_0_3 mod 4) + (((slice1cost_pixels_first_0_3 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_3 / 16) mod 4) + (slice1cost_pixels_first_0_3 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_3 / 16) + (slice1cost_pixels_first_0_3 / 64)) mod 2);
      slice1cost_pixels_cost_0_4 <= (((slice1cost_pixels_first_0_4 mod 4) + (((slice1cost_pixels_first_0_4 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_4 / 16) mod 4) + (slice1cost_pixels_first_0_4 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_4 / 16) + (slice1cost_pixels_first_0_4 / 64)) mod 2);
      slice1cost_pixels_cost_0_5 <= (((slice1cost_pixels_first_0_5 mod 4) + (((slice1cost_pixels_first_0_5 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_5 / 16) mod 4) + (slice1cost_pixels_first_0_5 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_5 / 16) + (slice1cost_pixels_first_0_5 / 64)) mod 2);
      slice1cost_pixels_cost_1_0 <= (((slice1cost_pixels_first_1_0 mod 4) + (((slice1cost_pixels_first_1_0 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_0 / 16) mod 4) + (slice1cost_pixels_first_1_0 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_0 / 16) + (slice1cost_pixels_first_1_0 / 64)) mod 2);
      slice1cost_pixels_cost_1_1 <= (((slice1cost_pixels_first_1_1 mod 4) + (((slice1cost_pixels_first_1_1 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_1 / 16) mod 4) + (slice1cost_pixels_first_1_1 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_1 / 16) + (slice1cost_pixels_first_1_1 / 64)) mod 2);
      slice1cost_pixels_cost_1_2 <= (((slice1cost_pixels_first_1_2 mod 4) + (((slice1cost_pixels_first_1_2 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_2 / 16) mod 4) + (slice1cost_pixels_first_1_2 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_2 / 16) + (slice1cost_pixels_first_1_2 / 64)) mod 2);
      slice1cost_pixels_cost_1_3 <= (((slice1cost_pixels_first_1_3 mod 4) + (((slice1cost_pixels_first_1_3 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_3 / 16) mod 4) + (slice1cost_pixels_first_1_3 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_3 / 16) + (slice1cost_pixels_first_1_3 / 64)) mod 2);
      slice1cost_pixels_cost_1_4 <= (((slice1cost_pixels_first_1_4 mod 4) + (((slice1cost_pixels_first_1_4 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_4 / 16) mod 4) + (slice1cost_pixels_first_1_4 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_4 / 16) + (slice1cost_pixels_first_1_4 / 64)) mod 2);
      slice1cost_pixels_cost_1_5 <= (((slice1cost_pixels_first_1_5 mod 4) + (((slice1cost_pixels_first_1_5 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_5 / 16) mod 4) + (slice1cost_pixels_first_1_5 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_5 / 16) + (slice1cost_pixels_first_1_5 / 64)) mod 2);
      slice1cost_pixels_cost_2_0 <= (((slice1cost_pixels_first_2_0 mod 4) + (((slice1cost_pixels_first_2_0 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_0 / 16) mod 4) + (slice1cost_pixels_first_2_0 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_0 / 16) + (slice1cost_pixels_first_2_0 / 64)) mod 2);
      slice1cost_pixels_cost_2_1 <= (((slice1cost_pixels_first_2_1 mod 4) + (((slice1cost_pixels_first_2_1 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_1 / 16) mod 4) + (slice1cost_pixels_first_2_1 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_1 / 16) + (slice1cost_pixels_first_2_1 / 64)) mod 2);
      slice1cost_pixels_cost_2_2 <= (((slice1cost_pixels_first_2_2 mod 4) + (((slice1cost_pixels_first_2_2 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_2 / 16) mod 4) + (slice1cost_pixels_first_2_2 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_2 / 16) + (slice1cost_pixels_first_2_2 / 64)) mod 2);
      slice1cost_pixels_cost_2_3 <= (((slice1cost_pixels_first_2_3 mod 4) + (((slice1cost_pixels_first_2_3 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_3 / 16) mod 4) + (slice1cost_pixels_first_2_3 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_3 / 16) + (slice1cost_pixels_first_2_3 / 64)) mod 2);
      slice1cost_pixels_cost_2_4 <= (((slice1cost_pixels_first_2_4 mod 4) + (((slice1cost_pixels_first_2_4 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_4 / 16) mod 4) + (slice1cost_pixels_first_2_4 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_4 / 16) + (slice1cost_pixels_first_2_4 / 64)) mod 2);
      slice1cost_pixels_cost_2_5 <= (((slice1cost_pixels_first_2_5 mod 4) + (((slice1cost_pixels_first_2_5 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_2_5 / 16) mod 4) + (slice1cost_pixels_first_2_5 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_2_5 / 16) + (slice1cost_pixels_first_2_5 / 64)) mod 2);
      slice1cost_pixels_cost_3_0 <= (((slice1cost_pixels_first_3_0 mod 4) + (((slice1cost_pixels_first_3_0 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_0 / 16) mod 4) + (slice1cost_pixels_first_3_0 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_0 / 16) + (slice1cost_pixels_first_3_0 / 64)) mod 2);
      slice1cost_pixels_cost_3_1 <= (((slice1cost_pixels_first_3_1 mod 4) + (((slice1cost_pixels_first_3_1 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_1 / 16) mod 4) + (slice1cost_pixels_first_3_1 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_1 / 16) + (slice1cost_pixels_first_3_1 / 64)) mod 2);
      slice1cost_pixels_cost_3_2 <= (((slice1cost_pixels_first_3_2 mod 4) + (((slice1cost_pixels_first_3_2 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_2 / 16) mod 4) + (slice1cost_pixels_first_3_2 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_2 / 16) + (slice1cost_pixels_first_3_2 / 64)) mod 2);
      slice1cost_pixels_cost_3_3 <= (((slice1cost_pixels_first_3_3 mod 4) + (((slice1cost_pixels_first_3_3 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_3 / 16) mod 4) + (slice1cost_pixels_first_3_3 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_3 / 16) + (slice1cost_pixels_first_3_3 / 64)) mod 2);
      slice1cost_pixels_cost_3_4 <= (((slice1cost_pixels_first_3_4 mod 4) + (((slice1cost_pixels_first_3_4 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_4 / 16) mod 4) + (slice1cost_pixels_first_3_4 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_4 / 16) + (slice1cost_pixels_first_3_4 / 64)) mod 2);
      slice1cost_pixels_cost_3_5 <= (((slice1cost_pixels_first_3_5 mod 4) + (((slice1cost_pixels_first_3_5 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_3_5 / 16) mod 4) + (slice1cost_pixels_first_3_5 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_3_5 / 16) + (slice1cost_pixels_first_3_5 / 64)) mod 2);
      slice1cost_pixels_cost_4_0 <= (((slice1cost_pixels_first_4_0 mod 4) + (((slice1cost_pixels_first_4_0 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_0 / 16) mod 4) + (slice1cost_pixels_first_4_0 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_0 / 16) + (slice1cost_pixels_first_4_0 / 64)) mod 2);
      slice1cost_pixels_cost_4_1 <= (((slice1cost_pixels_first_4_1 mod 4) + (((slice1cost_pixels_first_4_1 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_1 / 16) mod 4) + (slice1cost_pixels_first_4_1 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_1 / 16) + (slice1cost_pixels_first_4_1 / 64)) mod 2);
      slice1cost_pixels_cost_4_2 <= (((slice1cost_pixels_first_4_2 mod 4) + (((slice1cost_pixels_first_4_2 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_2 / 16) mod 4) + (slice1cost_pixels_first_4_2 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_2 / 16) + (slice1cost_pixels_first_4_2 / 64)) mod 2);
      slice1cost_pixels_cost_4_3 <= (((slice1cost_pixels_first_4_3 mod 4) + (((slice1cost_pixels_first_4_3 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_3 / 16) mod 4) + (slice1cost_pixels_first_4_3 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_3 / 16) + (slice1cost_pixels_first_4_3 / 64)) mod 2);
      slice1cost_pixels_cost_4_4 <= (((slice1cost_pixels_first_4_4 mod 4) + (((slice1cost_pixels_first_4_4 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_4 / 16) mod 4) + (slice1cost_pixels_first_4_4 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_4 / 16) + (slice1cost_pixels_first_4_4 / 64)) mod 2);
      slice1cost_pixels_cost_4_5 <= (((slice1cost_pixels_first_4_5 mod 4) + (((slice1cost_pixels_first_4_5 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_4_5 / 16) mod 4) + (slice1cost_pixels_first_4_5 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_4_5 / 16) + (slice1cost_pixels_first_4_5 / 64)) mod 2);
      slice1cost_pair_0_0 <= slice1cost_pixels_cost_1_0 + slice1cost_pixels_cost_2_0;
      slice1cost_pair_0_1 <= slice1cost_pixels_cost_1_1 + slice1cost_pixels_cost_2_1;
      slice1cost_pair_0_2 <= slice1cost_pixels_cost_1_2 + slice1cost_pixels_cost_2_2;
      slice1cost_pair_0_3 <= slice1cost_pixels_cost_1_3 + slice1cost_pixels_cost_2_3;
      slice1cost_pair_0_4 <= slice1cost_pixels_cost_1_4 + slice1cost_pixels_cost_2_4;
      slice1cost_pair_0_5 <= slice1cost_pixels_cost_1_5 + slice1cost_pixels_cost_2_5;
      slice1cost_pair_1_0 <= slice1cost_pixels_cost_3_0 + slice1cost_pixels_cost_4_0;
      slice1cost_pair_1_1 <= slice1cost_pixels_cost_3_1 + slice1cost_pixels_cost_4_1;
      slice1cost_pair_1_2 <= slice1cost_pixels_cost_3_2 + slice1cost_pixels_cost_4_2;
      slice1cost_pair_1_3 <= slice1cost_pixels_cost_3_3 + slice1cost_pixels_cost_4_3;
      slice1cost_pair_1_4 <= slice1cost_pixels_cost_3_4 + slice1cost_pixels_cost_4_4;
      slice1cost_pair_1_5 <= slice1cost_pixels_cost_3_5 + slice1cost_pixels_cost_4_5;
      slice1cost_single_0_0 <= slice1cost_pixels_cost_0_0;
      slice1cost_single_0_1 <= slice1cost_pixels_cost_0_1;
      slice1cost_single_0_2 <= slice1cost_pixels_cost_0_2;
      slice1cost_single_0_3 <= slice1cost_pixels_cost_0_3;
      slice1cost_single_0_4 <= slice1cost_pixels_cost_0_4;
      slice1cost_single_0_5 <= slice1cost_pixels_cost_0_5;
      slice1cost_column_0_0 <= slice1cost_single_0_0 + slice1cost_pair_0_0 + slice1cost_pair_1_0;
      slice1cost_column_0_1 <= slice1cost_single_0_1 + slice1cost_pair_0_1 + slice1cost_pair_1_1;
      slice1cost_column_0_2 <= slice1cost_single_0_2 + slice1cost_pair_0_2 + slice1cost_pair_1_2;
      slice1cost_column_0_3 <= slice1cost_single_0_3 + slice1cost_pair_0_3 + slice1cost_pair_1_3;
      slice1cost_column_0_4 <= slice1cost_single_0_4 + slice1cost_pair_0_4 + slice1cost_pair_1_4;
      slice1cost_column_0_5 <= slice1cost_single_0_5 + slice1cost_pair_0_5 + slice1cost_pair_1_5;
      if slice0cost_tag_valid then
        slice1cost_tag_first_column <= slice0cost_tag_first_column;
      end if;
      -- slice1window
      if slice0window_tag_valid then
        slice1window_partial_0_0_0 <= slice1cost_column_0_0;
        slice1window_partial_0_0_1 <= slice1cost_column_0_1;
        slice1window_partial_0_0_2 <= slice1cost_column_0_2;
        slice1window_partial_0_0_3 <= slice1cost_column_0_3;
        slice1window_partial_0_0_4 <= slice1cost_column_0_4;
        slice1window_partial_0_0_5 <= slice1cost_column_0_5;
        slice1window_partial_0_1_0 <= slice1window_partial_0_0_0 + slice1cost_column_0_0;
        slice1window_partial_0_1_1 <= slice1window_partial_0_0_1 + slice1cost_column_0_1;
        slice1window_partial_0_1_2 <= slice1window_partial_0_0_2 + slice1cost_column_0_2;
        slice1window_partial_0_1_3 <= slice1window_partial_0_0_3 + slice1cost_column_0_3;
        slice1window_partial_0_1_4 <= slice1window_partial_0_0_4 + slice1cost_column_0_4;
        slice1window_partial_0_1_5 <= slice1window_partial_0_0_5 + slice1cost_column_0_5;
        slice1window_partial_0_2_0 <= slice1window_partial_0_1_0 + slice1cost_column_0_0;
        slice1window_partial_0_2_1 <= slice1window_partial_0_1_1 + slice1cost_column_0_1;
        slice1window_partial_0_2_2 <= slice1window_partial_0_1_2 + slice1cost_column_0_2;
        slice1window_partial_0_2_3 <= slice1window_partial_0_1_3 + slice1cost_column_0_3;
        slice1window_partial_0_2_4 <= slice1window_partial_0_1_4 + slice1cost_column_0_4;
        slice1window_partial_0_2_5 <= slice1window_partial_0_1_5 + slice1cost_column_0_5;
        slice1window_partial_0_3_0 <= slice1window_partial_0_2_0 + slice1cost_column_0_0;
        slice1window_partial_0_3_1 <= slice1window_partial_0_2_1 + slice1cost_column_0_1;
        slice1window_partial_0_3_2 <= slice1window_partial_0_2_2 + slice1cost_column_0_2;
        slice1window_partial_0_3_3 <= slice1window_partial_0_2_3 + slice1cost_column_0_3;
        slice1window_partial_0_3_4 <= slice1window_partial_0_2_4 + slice1cost_column_0_4;
        slice1window_partial_0_3_5 <= slice1window_partial_0_2_5 + slice1cost_column_0_5;
        slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
        slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
        slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      end if;
      slice1window_sum_0_0 <= slice1window_partial_0_3_0 + slice1cost_column_0_0;
      slice1window_sum_0_1 <= slice1window_partial_0_3_1 + slice1cost_column_0_1;
      slice1window_sum_0_2 <= slice1window_partial_0_3_2 + slice1cost_column_0_2;
      slice1window_sum_0_3 <= slice1window_partial_0_3_3 + slice1cost_column_0_3;
      slice1window_sum_0_4 <= slice1window_partial_0_3_4 + slice1cost_column_0_4;
      slice1window_sum_0_5 <= slice1window_partial_0_3_5 + slice1cost_column_0_5;
      -- slice1mask
      if slice0window_tag_valid then
        slice1mask_inside_0_choice := slice1mask_inside_1;
      else
        slice1mask_inside_0_choice := slice1mask_inside_0;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_1_choice := slice1mask_inside_2;
      else
        slice1mask_inside_1_choice := slice1mask_inside_1;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_2_choice := slice1mask_inside_3;
      else
        slice1mask_inside_2_choice := slice1mask_inside_2;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_3_choice := slice1mask_inside_4;
      else
        slice1mask_inside_3_choice := slice1mask_inside_3;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_4_choice := slice1mask_inside_5;
      else
        slice1mask_inside_4_choice := slice1mask_inside_4;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_5_choice := slice0window_tag_first_column;
      else
        slice1mask_inside_5_choice := slice1mask_inside_5;
      end if;
      if slice0window_tag_first_column then
        slice1mask_inside_0 <= slice0window_tag_valid or slice1mask_inside_0;
        slice1mask_inside_1 <= slice0window_tag_valid or slice1mask_inside_1;
        slice1mask_inside_2 <= slice0window_tag_valid or slice1mask_inside_2;
        slice1mask_inside_3 <= slice0window_tag_valid or slice1mask_inside_3;
        slice1mask_inside_4 <= slice0window_tag_valid or slice1mask_inside_4;
      else
        slice1mask_inside_0 <= slice1mask_inside_0_choice;
        slice1mask_inside_1 <= slice1mask_inside_1_choice;
        slice1mask_inside_2 <= slice1mask_inside_2_choice;
        slice1mask_inside_3 <= slice1mask_inside_3_choice;
        slice1mask_inside_4 <= slice1mask_inside_4_choice;
      end if;
      if slice0mask_left_out then
        slice1mask_inside_5 <= slice0window_tag_valid or slice1mask_inside_5;
      else
        slice1mask_inside_5 <= slice1mask_inside_5_choice;
      end if;
      -- slice1winner1
      if slice1mask_inside_1 then
        slice1winner1_best_cost_0_0_choice := 0;
      else
        slice1winner1_best_cost_0_0_choice := 511;
      end if;
      slice1winner1_best_cost_0_0_any := to_integer(((to_unsigned(slice1window_sum_0_1, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_0_choice, 9))));
      if slice1mask_inside_0 then
        slice1winner1_best_cost_0_0_choice_2 := 0;
      else
        slice1winner1_best_cost_0_0_choice_2 := 511;
      end if;
      slice1winner1_best_cost_0_0_any_2 := to_integer(((to_unsigned(slice1window_sum_0_0, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_0_choice_2, 9))));
      slice1winner1_best_cost_0_0_is_less := (slice1winner1_best_cost_0_0_any - slice1winner1_best_cost_0_0_any_2) < 0;
      if slice1mask_inside_3 then
        slice1winner1_best_cost_0_1_choice := 0;
      else
        slice1winner1_best_cost_0_1_choice := 511;
      end if;
      slice1winner1_best_cost_0_1_any := to_integer(((to_unsigned(slice1window_sum_0_3, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_1_choice, 9))));
      if slice1mask_inside_2 then
        slice1winner1_best_cost_0_1_choice_2 := 0;
      else
        slice1winner1_best_cost_0_1_choice_2 := 511;
      end if;
      slice1winner1_best_cost_0_1_any_2 := to_integer(((to_unsigned(slice1window_sum_0_2, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_1_choice_2, 9))));
      slice1winner1_best_cost_0_1_is_less := (slice1winner1_best_cost_0_1_any - slice1winner1_best_cost_0_1_any_2) < 0;
      if slice1mask_inside_5 then
        slice1winner1_best_cost_0_2_choice := 0;
      else
        slice1winner1_best_cost_0_2_choice := 511;
      end if;
      slice1winner1_best_cost_0_2_any := to_integer(((to_unsigned(slice1window_sum_0_5, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_2_choice, 9))));
      if slice1mask_inside_4 then
        slice1winner1_best_cost_0_2_choice_2 := 0;
      else
        slice1winner1_best_cost_0_2_choice_2 := 511;
      end if;
      slice1winner1_best_cost_0_2_any_2 := to_integer(((to_unsigned(slice1window_sum_0_4, 9)) or
        (to_unsigned(slice1winner1_best_cost_0_2_choice_2, 9))));
      slice1winner1_best_cost_0_2_is_less := (slice1winner1_best_cost_0_2_any - slice1winner1_best_cost_0_2_any_2) < 0;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_first_0_1 <= slice1winner1_best_cost_0_1_any_2;
      slice1winner1_best_first_0_2 <= slice1winner1_best_cost_0_2_any_2;
      slice1winner1_best_last_0_0 <= slice1winner1_best_cost_0_0_any;
      slice1winner1_best_last_0_1 <= slice1winner1_best_cost_0_1_any;
      slice1winner1_best_last_0_2 <= slice1winner1_best_cost_0_2_any;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1winner1_best_cost_0_0_any;
        slice1winner1_best_below_0_0 <= slice1winner1_best_cost_0_0_any_2;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_cost_0_0 <= slice1winner1_best_cost_0_0_any_2;
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1winner1_best_cost_0_0_any;
      end if;
      if slice1winner1_best_cost_0_1_is_less then
        slice1winner1_best_cost_0_1 <= slice1winner1_best_cost_0_1_any;
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0_1 <= slice1winner1_best_cost_0_1_any_2;
        slice1winner1_best_above_0_1 <= 0;
      else
        slice1winner1_best_cost_0_1 <= slice1winner1_best_cost_0_1_any_2;
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0_1 <= 0;
        slice1winner1_best_above_0_1 <= slice1winner1_best_cost_0_1_any;
      end if;
      if slice1winner1_best_cost_0_2_is_less then
        slice1winner1_best_cost_0_2 <= slice1winner1_best_cost_0_2_any;
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0_2 <= slice1winner1_best_cost_0_2_any_2;
        slice1winner1_best_above_0_2 <= 0;
      else
        slice1winner1_best_cost_0_2 <= slice1winner1_best_cost_0_2_any_2;
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0_2 <= 0;
        slice1winner1_best_above_0_2 <= slice1winner1_best_cost_0_2_any;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      if slice1winner1_best_index_0_1 = 2 then
        slice1winner2_best_below_0_0_choice := slice1winner1_best_last_0_0;
      else
        slice1winner2_best_below_0_0_choice := slice1winner1_best_below_0_1;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_best_first_0_1;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_2;
      slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
      slice1winner2_best_below_0_1 <= slice1winner1_best_below_0_2;
      slice1winner2_best_above_0_1 <= slice1winner1_best_above_0_2;
      slice1winner2_best_first_0_1 <= slice1winner1_best_first_0_2;
      slice1winner2_best_last_0_0 <= slice1winner1_best_last_0_1;
      slice1winner2_best_last_0_1 <= slice1winner1_best_last_0_2;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_1;
        slice1winner2_best_index_0_0 <= slice1winner1_best_index_0_1;
        slice1winner2_best_below_0_0 <= slice1winner2_best_below_0_0_choice;
        slice1winner2_best_above_0_0 <= slice1winner1_best_above_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
        slice1winner2_best_below_0_0 <= slice1winner1_best_below_0_0;
        slice1winner2_best_above_0_0 <= slice1winner2_best_above_0_0_choice;
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0_1 - slice1winner2_best_cost_0_0) < 0;
      if ((slice1winner2_best_index_0_1 / 4) = 1) and (not ((slice1winner2_best_index_0_1 mod 2) = 1)) then
        slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0;
      else
        slice1winner3_best_below_0_0_choice := slice1winner2_best_below_0_1;
      end if;
      if slice1winner2_best_index_0_0 = 3 then
        slice1winner3_best_above_0_0_choice := slice1winner2_best_first_0_1;
      else
        slice1winner3_best_above_0_0_choice := slice1winner2_best_above_0_0;
      end if;
      slice1winner3_best_last_0_0 <= slice1winner2_best_last_0_1;
      if slice1winner3_best_cost_0_0_is_less then
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_1;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0_0 <= slice1winner3_best_below_0_0_choice;
        slice1winner3_best_above_0_0 <= slice1winner2_best_above_0_1;
      else
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0_0 <= slice1winner2_best_below_0_0;
        slice1winner3_best_above_0_0 <= slice1winner3_best_above_0_0_choice;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner3_best_cost_0_0) < 0;
      if slice0_best_index_0_0 = 6 then
        slice1_best_below_0_0_choice := slice1winner3_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice0_best_below_0_0;
      end if;
      if slice1winner3_best_index_0_0 = 5 then
        slice1_best_above_0_0_choice := slice0_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice1winner3_best_above_0_0;
      end if;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0_best_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice0_best_above_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner3_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1_best_below_0_0 <= slice1winner3_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      end if;
      -- refinement
      refinement_below_0_differs := slice1_best_index_0_0 /= 0;
      refinement_below_0_differs_2 := slice1_best_below_0_0 /= 511;
      refinement_below_0_all := refinement_below_0_differs and refinement_below_0_differs_2;
      if slice1_best_index_0_0 = 11 then
        refinement_above_0_choice := refinement_below_0_all;
      else
        refinement_above_0_choice := refinement_below_0_differs and (slice1_best_above_0_0 = 511) and
          refinement_below_0_differs_2;
      end if;
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 1024) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 1024) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 1024) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 1024) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 1024) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 1024) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 1024) - refinement_divisor_6_0;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
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
      refinement_disparity_0_0 <= slice1_best_index_0_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_disparity_4_0 <= refinement_disparity_3_0;
      refinement_disparity_5_0 <= refinement_disparity_4_0;
      refinement_disparity_6_0 <= refinement_disparity_5_0;
      refinement_disparity_7_0 <= refinement_disparity_6_0;
      refinement_disparity_8_0 <= refinement_disparity_7_0;
      refinement_disparity_9_0 <= refinement_disparity_8_0;
      refinement_disparity_10_0 <= refinement_disparity_9_0;
      refinement_disparity_11_0 <= refinement_disparity_10_0;
      refinement_passed_0_0 <= true;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_passed_3_0 <= refinement_passed_2_0;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_tag_0_valid <= slice1_best_tag_valid;
      refinement_tag_0_output_column <= slice1_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice1_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice1_best_tag_end_of_line;
      refinement_tag_1_valid <= refinement_tag_0_valid;
      refinement_tag_1_output_column <= refinement_tag_0_output_column;
      refinement_tag_1_start_of_frame <= refinement_tag_0_start_of_frame;
      refinement_tag_1_end_of_line <= refinement_tag_0_end_of_line;
      refinement_tag_2_valid <= refinement_tag_1_valid;
      refinement_tag_2_output_column <= refinement_tag_1_output_column;
      refinement_tag_2_start_of_frame <= refinement_tag_1_start_of_frame;
      refinement_tag_2_end_of_line <= refinement_tag_1_end_of_line;
      refinement_tag_3_valid <= refinement_tag_2_valid;
      refinement_tag_3_output_column <= refinement_tag_2_output_column;
      refinement_tag_3_start_of_frame <= refinement_tag_2_start_of_frame;
      refinement_tag_3_end_of_line <= refinement_tag_2_end_of_line;
      refinement_tag_4_valid <= refinement_tag_3_valid;
      refinement_tag_4_output_column <= refinement_tag_3_output_column;
      refinement_tag_4_start_of_frame <= refinement_tag_3_start_of_frame;
      refinement_tag_4_end_of_line <= refinement_tag_3_end_of_line;
      refinement_tag_5_valid <= refinement_tag_4_valid;
      refinement_tag_5_output_column <= refinement_tag_4_output_column;
      refinement_tag_5_start_of_frame <= refinement_tag_4_start_of_frame;
      refinement_tag_5_end_of_line <= refinement_tag_4_end_of_line;
      refinement_tag_6_valid <= refinement_tag_5_valid;
      refinement_tag_6_output_column <= refinement_tag_5_output_column;
      refinement_tag_6_start_of_frame <= refinement_tag_5_start_of_frame;
      refinement_tag_6_end_of_line <= refinement_tag_5_end_of_line;
      refinement_tag_7_valid <= refinement_tag_6_valid;
      refinement_tag_7_output_column <= refinement_tag_6_output_column;
      refinement_tag_7_start_of_frame <= refinement_tag_6_start_of_frame;
      refinement_tag_7_end_of_line <= refinement_tag_6_end_of_line;
      refinement_tag_8_valid <= refinement_tag_7_valid;
      refinement_tag_8_output_column <= refinement_tag_7_output_column;
      refinement_tag_8_start_of_frame <= refinement_tag_7_start_of_frame;
      refinement_tag_8_end_of_line <= refinement_tag_7_end_of_line;
      refinement_tag_9_valid <= refinement_tag_8_valid;
      refinement_tag_9_output_column <= refinement_tag_8_output_column;
      refinement_tag_9_start_of_frame <= refinement_tag_8_start_of_frame;
      refinement_tag_9_end_of_line <= refinement_tag_8_end_of_line;
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_output_column <= refinement_tag_9_output_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_output_column <= refinement_tag_10_output_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_cost_0 <= slice1_best_cost_0_0;
      refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 512;
      refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 512;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 9)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 9))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((1024 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 512) + ((other_0
        / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 32) * 8) + refinement_fraction_0_choice_2;
      if refinement_below_0_all then
        refinement_below_0 <= slice1_best_below_0_0;
      else
        refinement_below_0 <= slice1_best_above_0_0;
      end if;
      if refinement_above_0_choice then
        refinement_above_0 <= slice1_best_below_0_0;
      else
        refinement_above_0 <= slice1_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 1024) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 512;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 1024) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 512;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 256) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 1024) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 512;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 256) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 1024) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 512;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 256) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 1024) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 512;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 256) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 1024) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 512;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 256) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 1024) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 512;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 256) * 2;
      end if;
      -- map
      map_out_disparity_0 <= (((((refinement_disparity_11_0 + (refinement_fraction_0 / 16)) * 2) +
        ((refinement_fraction_0 mod 16) / 8) + 8191) mod 8192) * 8) + (refinement_fraction_0 mod 8);
      map_out_passed_0 <= refinement_passed_11_0;
      map_out_valid <= refinement_tag_11_valid and refinement_tag_11_output_column;
      map_out_start_of_frame <= refinement_tag_11_start_of_frame and refinement_tag_11_valid and
        refinement_tag_11_output_column;
      map_out_end_of_line <= refinement_tag_11_end_of_line and refinement_tag_11_valid and
        refinement_tag_11_output_column;
      -- other
      other_0 <= ((refinement_remainder_7_0_difference / 1024) * 2) + ((other_1 / 4) * 4);
      other_1 <= ((refinement_remainder_6_0_difference / 1024) * 4) + ((other_2 / 8) * 8);
      other_2 <= ((refinement_remainder_5_0_difference / 1024) * 8) + ((other_3 / 16) * 16);
      other_3 <= ((refinement_remainder_4_0_difference / 1024) * 16) + ((other_4 / 32) * 32);
      other_4 <= ((refinement_remainder_3_0_difference / 1024) * 32) + ((other_5 / 64) * 64);
      other_5 <= ((refinement_remainder_2_0_difference / 1024) * 64) + ((other_6 / 128) * 128);
      other_6 <= (refinement_remainder_1_0_difference / 1024) * 128;
      other_7 <= raster_place_group_is_equal;
      other_8 <= (((transform_right_code_next_row_outer_0 / 2) - transform_right_code_next_row_centre_0) mod 32768) * 2;
      other_9 <= as_number(((transform_right_code_row_before_0 - transform_right_code_row_after_0) < 0)) * 8192;
      other_10 <= as_number((((other_11 / 2) - transform_right_code_row_centre_0) < 0)) * 8192;
      other_11 <= ((transform_right_code_row_box_0_0 + transform_right_code_row_column_0_3) / 2) * 2;
      other_12 <= (((transform_left_code_next_row_outer_0 / 2) - transform_left_code_next_row_centre_0) mod 32768) * 2;
      other_13 <= as_number(((transform_left_code_row_before_0 - transform_left_code_row_after_0) < 0)) * 8192;
      other_14 <= as_number((((other_15 / 2) - transform_left_code_row_centre_0) < 0)) * 8192;
      other_15 <= ((transform_left_code_row_box_0_0 + transform_left_code_row_column_0_3) / 2) * 2;
      other_16 <= other_17;
      other_17 <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 4) and
        (transform_counter_group = 4)));
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 22;
        transform_counter_next_frame <= false;
        transform_read_column <= 0;
        transform_ready_column <= 0;
        transform_write_column <= 0;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_filtering_0_start_of_frame <= false;
        transform_filtering_0_valid <= false;
        transform_filtering_1_start_of_frame <= false;
        transform_filtering_1_valid <= false;
        transform_filtering_2_start_of_frame <= false;
        transform_filtering_2_valid <= false;
        transform_filtering_3_start_of_frame <= false;
        transform_filtering_3_valid <= false;
        transform_filtering_4_start_of_frame <= false;
        transform_filtering_4_valid <= false;
        transform_filtering_5_start_of_frame <= false;
        transform_filtering_5_valid <= false;
        transform_filtering_6_start_of_frame <= false;
        transform_filtering_6_valid <= false;
        transform_filtering_7_start_of_frame <= false;
        transform_filtering_7_valid <= false;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 20;
        raster_place_next_frame <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        delay_split_inside_before_2 <= false;
        delay_split_whole_before <= false;
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
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
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
        slice0window_centre_start_of_frame_1 <= false;
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
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        refinement_tag_0_valid <= false;
        refinement_tag_0_output_column <= false;
        refinement_tag_0_start_of_frame <= false;
        refinement_tag_0_end_of_line <= false;
        refinement_tag_1_valid <= false;
        refinement_tag_1_output_column <= false;
        refinement_tag_1_start_of_frame <= false;
        refinement_tag_1_end_of_line <= false;
        refinement_tag_2_valid <= false;
        refinement_tag_2_output_column <= false;
        refinement_tag_2_start_of_frame <= false;
        refinement_tag_2_end_of_line <= false;
        refinement_tag_3_valid <= false;
        refinement_tag_3_output_column <= false;
        refinement_tag_3_start_of_frame <= false;
        refinement_tag_3_end_of_line <= false;
        refinement_tag_4_valid <= false;
        refinement_tag_4_output_column <= false;
        refinement_tag_4_start_of_frame <= false;
        refinement_tag_4_end_of_line <= false;
        refinement_tag_5_valid <= false;
        refinement_tag_5_output_column <= false;
        refinement_tag_5_start_of_frame <= false;
        refinement_tag_5_end_of_line <= false;
        refinement_tag_6_valid <= false;
        refinement_tag_6_output_column <= false;
        refinement_tag_6_start_of_frame <= false;
        refinement_tag_6_end_of_line <= false;
        refinement_tag_7_valid <= false;
        refinement_tag_7_output_column <= false;
        refinement_tag_7_start_of_frame <= false;
        refinement_tag_7_end_of_line <= false;
        refinement_tag_8_valid <= false;
        refinement_tag_8_output_column <= false;
        refinement_tag_8_start_of_frame <= false;
        refinement_tag_8_end_of_line <= false;
        refinement_tag_9_valid <= false;
        refinement_tag_9_output_column <= false;
        refinement_tag_9_start_of_frame <= false;
        refinement_tag_9_end_of_line <= false;
        refinement_tag_10_valid <= false;
        refinement_tag_10_output_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_output_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_7 <= false;
        other_16 <= 0;
        other_17 <= 0;
      end if;
    end if;
  end process;
end architecture;
