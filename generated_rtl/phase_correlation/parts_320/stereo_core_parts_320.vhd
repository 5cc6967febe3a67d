-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, phase correlation, configuration parts_320: 320x240, 24 disparities, window 9x9, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 24, subpixel true, aggregation recursive, slice_disparities 12.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config parts_320
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_parts_320 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 320;
    height_px : positive := 240;
    disparities : positive := 24;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 296;
    latency_clocks : positive := 44;
    flush_groups : positive := 2567;
    gap_groups : positive := 1280
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
  assert width_px = 320 report "stereo_core_parts_320: width_px is " & integer'image(width_px) & " but this core has 320" severity failure;
  assert height_px = 240 report "stereo_core_parts_320: height_px is " & integer'image(height_px) & " but this core has 240" severity failure;
  assert disparities = 24 report "stereo_core_parts_320: disparities is " & integer'image(disparities) & " but this core has 24" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_parts_320: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_parts_320: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 296 report "stereo_core_parts_320: output_width_px is " & integer'image(output_width_px) & " but this core has 296" severity failure;
  assert latency_clocks = 44 report "stereo_core_parts_320: latency_clocks is " & integer'image(latency_clocks) & " but this core has 44" severity failure;
  assert flush_groups = 2567 report "stereo_core_parts_320: flush_groups is " & integer'image(flush_groups) & " but this core has 2567" severity failure;
  assert gap_groups = 1280 report "stereo_core_parts_320: gap_groups is " & integer'image(gap_groups) & " but this core has 1280" severity failure;
end entity;

architecture rtl of stereo_core_parts_320 is
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
  signal transform_left_0, transform_right_0, transform_counter_group : natural range 0 to 255;
  signal transform_left_rows_read_newest_0, transform_left_rows_ready_words_2 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_left_rows_write_words_2 : natural range 0 to 255;
  signal transform_right_rows_read_newest_0, transform_right_rows_ready_words_2 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_right_rows_write_words_2 : natural range 0 to 255;
  signal transform_left_column_0, transform_left_column_1, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_3, transform_left_column_4, transform_left_column_5 : natural range 0 to 255;
  signal transform_left_column_6, transform_left_column_7, transform_left_column_8 : natural range 0 to 255;
  signal transform_left_column_9, transform_right_column_0, transform_right_column_1 : natural range 0 to 255;
  signal transform_right_column_2, transform_right_column_3, transform_right_column_4 : natural range 0 to 255;
  signal transform_right_column_5, transform_right_column_6, transform_right_column_7 : natural range 0 to 255;
  signal transform_right_column_8, transform_right_column_9 : natural range 0 to 255;
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
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 511;
  signal transform_write_column, transform_centre_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_read_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_ready_words_0, transform_left_rows_ready_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_left_rows_write_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0, transform_right_rows_read_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_ready_words_1 : unsigned(31 downto 0);
  signal transform_right_rows_write_words_0, transform_right_rows_write_words_1 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_2, transform_right_rows_read_words_2 : unsigned(7 downto 0);
  signal transform_centre_group : natural range 0 to 256;
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
  signal transform_left_code_row_signs, transform_left_code_earlier_0 : natural range 0 to 63;
  signal transform_left_code_earlier_1, transform_left_code_bits : natural range 0 to 63;
  signal transform_left_code_next_row_signs, transform_left_code_next_bits : natural range 0 to 63;
  signal transform_right_code_row_signs, transform_right_code_earlier_0 : natural range 0 to 63;
  signal transform_right_code_earlier_1, transform_right_code_bits : natural range 0 to 63;
  signal transform_right_code_next_row_signs, transform_right_code_next_bits : natural range 0 to 63;
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
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 511;
  signal raster_place_group : natural range 0 to 255;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 31;
  signal delay_ahead_0 : natural range 0 to 4095;
  signal delay_delayed_0 : unsigned(11 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_border_column, delay_tag_first_cost, delay_tag_leaves_window, delay_tag_output_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2, rows_search_rows_read_words_3 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_2, rows_reference_rows_read_words_3 : unsigned(23 downto 0);
  signal rows_search_rows_read_words_4, rows_reference_rows_read_words_4 : unsigned(11 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_words_4 : natural range 0 to 4095;
  signal rows_search_rows_ready_newest_0, rows_search_rows_write_words_4 : natural range 0 to 4095;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_words_4 : natural range 0 to 4095;
  signal rows_reference_rows_ready_newest_0, rows_reference_rows_write_words_4, rows_search_0 : natural range 0 to 4095;
  signal rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 4095;
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_search_rows_ready_words_2, rows_search_rows_ready_words_3 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_2, rows_search_rows_write_words_3 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_2, rows_reference_rows_ready_words_3 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_2, rows_reference_rows_write_words_3 : natural range 0 to 16777215;
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
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 4095;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 4095;
  signal slice0shift_search_0_6, slice0shift_search_0_7, slice0shift_search_0_8 : natural range 0 to 4095;
  signal slice0shift_search_0_9, slice0shift_search_0_10, slice0shift_search_0_11 : natural range 0 to 4095;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 4095;
  signal slice0shift_search_1_3, slice0shift_search_1_4, slice0shift_search_1_5 : natural range 0 to 4095;
  signal slice0shift_search_1_6, slice0shift_search_1_7, slice0shift_search_1_8 : natural range 0 to 4095;
  signal slice0shift_search_1_9, slice0shift_search_1_10, slice0shift_search_1_11 : natural range 0 to 4095;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_search_out_0 : natural range 0 to 4095;
  signal slice0shift_search_out_1 : natural range 0 to 4095;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_border_column, slice0shift_tag_first_cost, slice0shift_tag_leaves_window : boolean;
  signal slice0shift_tag_output_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1, slice0cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_3, slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_6, slice0cost_pixels_first_0_7, slice0cost_pixels_first_0_8 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_9, slice0cost_pixels_first_0_10 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_11, slice0cost_pixels_first_1_0 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_1, slice0cost_pixels_first_1_2, slice0cost_pixels_first_1_3 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_4, slice0cost_pixels_first_1_5, slice0cost_pixels_first_1_6 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_7, slice0cost_pixels_first_1_8, slice0cost_pixels_first_1_9 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_10, slice0cost_pixels_first_1_11, slice0cost_column_0_0 : natural range 0 to 255;
  signal slice0cost_column_0_1, slice0cost_column_0_2, slice0cost_column_0_3 : natural range 0 to 255;
  signal slice0cost_column_0_4, slice0cost_column_0_5, slice0cost_column_0_6 : natural range 0 to 255;
  signal slice0cost_column_0_7, slice0cost_column_0_8, slice0cost_column_0_9 : natural range 0 to 255;
  signal slice0cost_column_0_10, slice0cost_column_0_11 : natural range 0 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_first_group, slice0cost_pixels_tag_border_column : boolean;
  signal slice0cost_pixels_tag_first_cost, slice0cost_pixels_tag_leaves_window : boolean;
  signal slice0cost_pixels_tag_output_column, slice0cost_pixels_tag_start_of_frame : boolean;
  signal slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid, slice0cost_ready_tag_first_group : boolean;
  signal slice0cost_ready_tag_border_column, slice0cost_ready_tag_first_cost : boolean;
  signal slice0cost_ready_tag_leaves_window, slice0cost_ready_tag_output_column : boolean;
  signal slice0cost_ready_tag_start_of_frame, slice0cost_ready_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_border_column, slice0cost_tag_first_cost : boolean;
  signal slice0cost_tag_leaves_window, slice0cost_tag_output_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_0_6, slice0cost_pixels_cost_0_7, slice0cost_pixels_cost_0_8 : natural range 0 to 19;
  signal slice0cost_pixels_cost_0_9, slice0cost_pixels_cost_0_10, slice0cost_pixels_cost_0_11 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_6, slice0cost_pixels_cost_1_7, slice0cost_pixels_cost_1_8 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_9, slice0cost_pixels_cost_1_10, slice0cost_pixels_cost_1_11 : natural range 0 to 19;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_read_words_0, slice0cost_read_words_1, slice0cost_read_words_2 : unsigned(31 downto 0);
  signal slice0cost_ready_words_0, slice0cost_ready_words_1, slice0cost_ready_words_2 : unsigned(31 downto 0);
  signal slice0cost_write_words_0, slice0cost_write_words_1, slice0cost_write_words_2 : unsigned(31 downto 0);
  signal slice0cost_change_0_0, slice0cost_change_0_1, slice0cost_change_0_2 : integer range -19 to 19;
  signal slice0cost_change_0_3, slice0cost_change_0_4, slice0cost_change_0_5 : integer range -19 to 19;
  signal slice0cost_change_0_6, slice0cost_change_0_7, slice0cost_change_0_8 : integer range -19 to 19;
  signal slice0cost_change_0_9, slice0cost_change_0_10, slice0cost_change_0_11 : integer range -19 to 19;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 15;
  signal slice0window_leaving_0, slice0window_leaving_1, slice0window_leaving_2 : unsigned(31 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 255;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 255;
  signal slice0window_entering_0_6, slice0window_entering_0_7, slice0window_entering_0_8 : natural range 0 to 255;
  signal slice0window_entering_0_9, slice0window_entering_0_10, slice0window_entering_0_11 : natural range 0 to 255;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_first_cost : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_output_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_first_cost : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_output_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame_0, slice0window_centre_start_of_frame_3 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -255 to 255;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -255 to 255;
  signal slice0window_change_0_6, slice0window_change_0_7, slice0window_change_0_8 : integer range -255 to 255;
  signal slice0window_change_0_9, slice0window_change_0_10, slice0window_change_0_11 : integer range -255 to 255;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2047;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 2047;
  signal slice0window_sum_0_6, slice0window_sum_0_7, slice0window_sum_0_8 : natural range 0 to 2047;
  signal slice0window_sum_0_9, slice0window_sum_0_10, slice0window_sum_0_11 : natural range 0 to 2047;
  -- slice0winner1
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_cost_0_2, slice0winner1_best_cost_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_cost_0_4, slice0winner1_best_cost_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_2, slice0winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_below_0_4, slice0winner1_best_below_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_0, slice0winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_2, slice0winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_above_0_4, slice0winner1_best_above_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_0, slice0winner1_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_2, slice0winner1_best_first_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_first_0_4, slice0winner1_best_first_0_5 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_0, slice0winner1_best_last_0_1 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_2, slice0winner1_best_last_0_3 : natural range 0 to 2047;
  signal slice0winner1_best_last_0_4 : natural range 0 to 2047;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  signal slice0winner1_best_index_0_3 : natural range 0 to 7;
  signal slice0winner1_best_index_0_4 : natural range 0 to 9;
  signal slice0winner1_best_index_0_5 : natural range 0 to 11;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_cost_0_2, slice0winner2_best_below_0_0 : natural range 0 to 2047;
  signal slice0winner2_best_below_0_1, slice0winner2_best_below_0_2 : natural range 0 to 2047;
  signal slice0winner2_best_above_0_0, slice0winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_above_0_2, slice0winner2_best_first_0_0 : natural range 0 to 2047;
  signal slice0winner2_best_first_0_1, slice0winner2_best_first_0_2 : natural range 0 to 2047;
  signal slice0winner2_best_last_0_0, slice0winner2_best_last_0_1 : natural range 0 to 2047;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 7;
  signal slice0winner2_best_index_0_2 : natural range 0 to 11;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_cost_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_below_0_0, slice0winner3_best_below_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_above_0_0, slice0winner3_best_above_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_first_0_0, slice0winner3_best_first_0_1 : natural range 0 to 2047;
  signal slice0winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice0winner3_best_index_0_0 : natural range 0 to 7;
  signal slice0winner3_best_index_0_1 : natural range 0 to 11;
  signal slice0winner3_tag_valid, slice0winner3_tag_output_column, slice0winner3_tag_start_of_frame : boolean;
  signal slice0winner3_tag_end_of_line : boolean;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0, slice0winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_above_0_0, slice0winner4_best_first_0_0 : natural range 0 to 2047;
  signal slice0winner4_best_index_0_0 : natural range 0 to 11;
  signal slice0winner4_tag_valid, slice0winner4_tag_output_column, slice0winner4_tag_start_of_frame : boolean;
  signal slice0winner4_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_cost_0_0, slice0_best_below_0_0, slice0_best_above_0_0 : natural range 0 to 2047;
  signal slice0_best_first_0_0 : natural range 0 to 2047;
  signal slice0_best_index_0_0 : natural range 0 to 23;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
  signal slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 4095;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 4095;
  signal slice1shift_search_0_6, slice1shift_search_0_7, slice1shift_search_0_8 : natural range 0 to 4095;
  signal slice1shift_search_0_9, slice1shift_search_0_10, slice1shift_search_0_11 : natural range 0 to 4095;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 4095;
  signal slice1shift_search_1_3, slice1shift_search_1_4, slice1shift_search_1_5 : natural range 0 to 4095;
  signal slice1shift_search_1_6, slice1shift_search_1_7, slice1shift_search_1_8 : natural range 0 to 4095;
  signal slice1shift_search_1_9, slice1shift_search_1_10, slice1shift_search_1_11 : natural range 0 to 4095;
  signal slice1shift_reference_0, slice1shift_reference_1 : natural range 0 to 4095;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1, slice1cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_3, slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_6, slice1cost_pixels_first_0_7, slice1cost_pixels_first_0_8 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_9, slice1cost_pixels_first_0_10 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_11, slice1cost_pixels_first_1_0 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_1, slice1cost_pixels_first_1_2, slice1cost_pixels_first_1_3 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_4, slice1cost_pixels_first_1_5, slice1cost_pixels_first_1_6 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_7, slice1cost_pixels_first_1_8, slice1cost_pixels_first_1_9 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_10, slice1cost_pixels_first_1_11, slice1cost_column_0_0 : natural range 0 to 255;
  signal slice1cost_column_0_1, slice1cost_column_0_2, slice1cost_column_0_3 : natural range 0 to 255;
  signal slice1cost_column_0_4, slice1cost_column_0_5, slice1cost_column_0_6 : natural range 0 to 255;
  signal slice1cost_column_0_7, slice1cost_column_0_8, slice1cost_column_0_9 : natural range 0 to 255;
  signal slice1cost_column_0_10, slice1cost_column_0_11 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_0_6, slice1cost_pixels_cost_0_7, slice1cost_pixels_cost_0_8 : natural range 0 to 19;
  signal slice1cost_pixels_cost_0_9, slice1cost_pixels_cost_0_10, slice1cost_pixels_cost_0_11 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_6, slice1cost_pixels_cost_1_7, slice1cost_pixels_cost_1_8 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_9, slice1cost_pixels_cost_1_10, slice1cost_pixels_cost_1_11 : natural range 0 to 19;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_read_words_0, slice1cost_read_words_1, slice1cost_read_words_2 : unsigned(31 downto 0);
  signal slice1cost_ready_words_0, slice1cost_ready_words_1, slice1cost_ready_words_2 : unsigned(31 downto 0);
  signal slice1cost_write_words_0, slice1cost_write_words_1, slice1cost_write_words_2 : unsigned(31 downto 0);
  signal slice1cost_change_0_0, slice1cost_change_0_1, slice1cost_change_0_2 : integer range -19 to 19;
  signal slice1cost_change_0_3, slice1cost_change_0_4, slice1cost_change_0_5 : integer range -19 to 19;
  signal slice1cost_change_0_6, slice1cost_change_0_7, slice1cost_change_0_8 : integer range -19 to 19;
  signal slice1cost_change_0_9, slice1cost_change_0_10, slice1cost_change_0_11 : integer range -19 to 19;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 15;
  signal slice1window_leaving_0, slice1window_leaving_1, slice1window_leaving_2 : unsigned(31 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 255;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 255;
  signal slice1window_entering_0_6, slice1window_entering_0_7, slice1window_entering_0_8 : natural range 0 to 255;
  signal slice1window_entering_0_9, slice1window_entering_0_10, slice1window_entering_0_11 : natural range 0 to 255;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -255 to 255;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -255 to 255;
  signal slice1window_change_0_6, slice1window_change_0_7, slice1window_change_0_8 : integer range -255 to 255;
  signal slice1window_change_0_9, slice1window_change_0_10, slice1window_change_0_11 : integer range -255 to 255;
  signal slice1window_sum_0_0, slice1window_sum_0_1, slice1window_sum_0_2 : natural range 0 to 2047;
  signal slice1window_sum_0_3, slice1window_sum_0_4, slice1window_sum_0_5 : natural range 0 to 2047;
  signal slice1window_sum_0_6, slice1window_sum_0_7, slice1window_sum_0_8 : natural range 0 to 2047;
  signal slice1window_sum_0_9, slice1window_sum_0_10, slice1window_sum_0_11 : natural range 0 to 2047;
  signal slice1window_centre_output_column_0, slice1window_centre_output_column_1 : boolean;
  signal slice1window_centre_output_column_2, slice1window_centre_start_of_frame_0 : boolean;
  signal slice1window_centre_start_of_frame_1, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_centre_end_of_line_1, slice1window_centre_end_of_line_2 : boolean;
  -- slice1winner1
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_cost_0_2, slice1winner1_best_cost_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_cost_0_4, slice1winner1_best_cost_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_2, slice1winner1_best_below_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_below_0_4, slice1winner1_best_below_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_2, slice1winner1_best_above_0_3 : natural range 0 to 2047;
  signal slice1winner1_best_above_0_4, slice1winner1_best_above_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_1, slice1winner1_best_first_0_2 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_3, slice1winner1_best_first_0_4 : natural range 0 to 2047;
  signal slice1winner1_best_first_0_5, slice1winner1_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_1, slice1winner1_best_last_0_2 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_3, slice1winner1_best_last_0_4 : natural range 0 to 2047;
  signal slice1winner1_best_last_0_5 : natural range 0 to 2047;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  signal slice1winner1_best_index_0_3 : natural range 0 to 7;
  signal slice1winner1_best_index_0_4 : natural range 0 to 9;
  signal slice1winner1_best_index_0_5 : natural range 0 to 11;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_cost_0_2, slice1winner2_best_below_0_0 : natural range 0 to 2047;
  signal slice1winner2_best_below_0_1, slice1winner2_best_below_0_2 : natural range 0 to 2047;
  signal slice1winner2_best_above_0_0, slice1winner2_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_above_0_2, slice1winner2_best_first_0_1 : natural range 0 to 2047;
  signal slice1winner2_best_first_0_2, slice1winner2_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner2_best_last_0_1, slice1winner2_best_last_0_2 : natural range 0 to 2047;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 7;
  signal slice1winner2_best_index_0_2 : natural range 0 to 11;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_cost_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_below_0_0, slice1winner3_best_below_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_above_0_0, slice1winner3_best_above_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_first_0_1, slice1winner3_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner3_best_last_0_1 : natural range 0 to 2047;
  signal slice1winner3_best_index_0_0 : natural range 0 to 7;
  signal slice1winner3_best_index_0_1 : natural range 0 to 11;
  -- slice1winner4
  signal slice1winner4_best_cost_0_0, slice1winner4_best_below_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_above_0_0, slice1winner4_best_last_0_0 : natural range 0 to 2047;
  signal slice1winner4_best_index_0_0 : natural range 0 to 11;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 2047;
  signal slice1_best_index_0_0 : natural range 0 to 23;
  signal slice1_best_tag_valid, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 23;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 23;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 23;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 23;
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
  signal refinement_cost_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 2047;
  signal refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 2047;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 2047;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 2047;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 2047;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 2047;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 2047;
  signal refinement_difference_0 : integer range -2047 to 2047;
  signal refinement_quotient_8_0, refinement_fraction_0 : natural range 0 to 255;
  -- map
  signal map_out_disparity_0 : natural range 0 to 65535;
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  -- other
  signal other_0, other_3, other_11, other_12 : boolean;
  signal other_1, other_2 : natural range 0 to 257;
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;
  signal other_13, other_17 : natural range 0 to 65534;
  signal other_14, other_15, other_18, other_19 : natural range 0 to 8192;
  signal other_16, other_20 : natural range 0 to 2042;
  signal slice1window_leaving_2_memory_read_enable : boolean;
  signal slice1window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_2_memory_read_enable : boolean;
  signal slice1cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_2_memory_read_enable : boolean;
  signal slice0window_leaving_2_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_2_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(31 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(3 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_2_memory_read_enable : boolean;
  signal slice0cost_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal rows_search_rows_read_words_4_memory_read_enable : boolean;
  signal rows_search_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_4_memory_write_data : unsigned(11 downto 0);
  signal rows_search_rows_read_words_3_memory_read_enable : boolean;
  signal rows_search_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_2_memory_read_enable : boolean;
  signal rows_search_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_1_memory_read_enable : boolean;
  signal rows_search_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_4_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_4_memory_write_data : unsigned(11 downto 0);
  signal rows_reference_rows_read_words_3_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_3_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_2_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_2_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_1_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_1_memory_write_data : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(23 downto 0);
  signal delay_delayed_0_memory_read_enable : boolean;
  signal delay_delayed_0_memory_read_address : unsigned(4 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(4 downto 0);
  signal delay_delayed_0_memory_write_data : unsigned(11 downto 0);
  signal transform_left_rows_read_words_2_memory_read_enable : boolean;
  signal transform_left_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal transform_left_rows_read_words_1_memory_read_enable : boolean;
  signal transform_left_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_2_memory_read_enable : boolean;
  signal transform_right_rows_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_2_memory_write_data : unsigned(7 downto 0);
  signal transform_right_rows_read_words_1_memory_read_enable : boolean;
  signal transform_right_rows_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
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

  slice1window_leaving_2_memory_read_enable <= true;
  slice1window_leaving_2_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_2_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_2_memory_write_data <= to_unsigned(slice1cost_column_0_11, 8) & to_unsigned(slice1cost_column_0_10, 8) & to_unsigned(slice1cost_column_0_9, 8) & to_unsigned(slice1cost_column_0_8, 8);
  slice1window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_2_memory_read_enable,
      read_address => slice1window_leaving_2_memory_read_address, read_data => slice1window_leaving_2,
      write_address => slice1window_leaving_2_memory_write_address, write_data => slice1window_leaving_2_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_7, 8) & to_unsigned(slice1cost_column_0_6, 8) & to_unsigned(slice1cost_column_0_5, 8) & to_unsigned(slice1cost_column_0_4, 8);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 4);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 4);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_3, 8) & to_unsigned(slice1cost_column_0_2, 8) & to_unsigned(slice1cost_column_0_1, 8) & to_unsigned(slice1cost_column_0_0, 8);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_2_memory_read_enable <= true;
  slice1cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_2_memory_write_data <= slice1cost_write_words_2;
  slice1cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_2_memory_read_enable,
      read_address => slice1cost_read_words_2_memory_read_address, read_data => slice1cost_read_words_2,
      write_address => slice1cost_read_words_2_memory_write_address, write_data => slice1cost_read_words_2_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_1_memory_write_data <= slice1cost_write_words_1;
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 9);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 9);
  slice1cost_read_words_0_memory_write_data <= slice1cost_write_words_0;
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_2_memory_read_enable <= true;
  slice0window_leaving_2_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_2_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_2_memory_write_data <= to_unsigned(slice0cost_column_0_11, 8) & to_unsigned(slice0cost_column_0_10, 8) & to_unsigned(slice0cost_column_0_9, 8) & to_unsigned(slice0cost_column_0_8, 8);
  slice0window_leaving_2_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_2_memory_read_enable,
      read_address => slice0window_leaving_2_memory_read_address, read_data => slice0window_leaving_2,
      write_address => slice0window_leaving_2_memory_write_address, write_data => slice0window_leaving_2_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_7, 8) & to_unsigned(slice0cost_column_0_6, 8) & to_unsigned(slice0cost_column_0_5, 8) & to_unsigned(slice0cost_column_0_4, 8);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 4);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 4);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_3, 8) & to_unsigned(slice0cost_column_0_2, 8) & to_unsigned(slice0cost_column_0_1, 8) & to_unsigned(slice0cost_column_0_0, 8);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_2_memory_read_enable <= true;
  slice0cost_read_words_2_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_2_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_2_memory_write_data <= slice0cost_write_words_2;
  slice0cost_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_2_memory_read_enable,
      read_address => slice0cost_read_words_2_memory_read_address, read_data => slice0cost_read_words_2,
      write_address => slice0cost_read_words_2_memory_write_address, write_data => slice0cost_read_words_2_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_1_memory_write_data <= slice0cost_write_words_1;
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 9);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 9);
  slice0cost_read_words_0_memory_write_data <= slice0cost_write_words_0;
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

  rows_search_rows_read_words_4_memory_read_enable <= true;
  rows_search_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_4_memory_write_data <= to_unsigned(rows_search_rows_write_words_4, 12);
  rows_search_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 12, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_4_memory_read_enable,
      read_address => rows_search_rows_read_words_4_memory_read_address, read_data => rows_search_rows_read_words_4,
      write_address => rows_search_rows_read_words_4_memory_write_address, write_data => rows_search_rows_read_words_4_memory_write_data);

  rows_search_rows_read_words_3_memory_read_enable <= true;
  rows_search_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_3_memory_write_data <= to_unsigned(rows_search_rows_write_words_3, 24);
  rows_search_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_3_memory_read_enable,
      read_address => rows_search_rows_read_words_3_memory_read_address, read_data => rows_search_rows_read_words_3,
      write_address => rows_search_rows_read_words_3_memory_write_address, write_data => rows_search_rows_read_words_3_memory_write_data);

  rows_search_rows_read_words_2_memory_read_enable <= true;
  rows_search_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_2_memory_write_data <= to_unsigned(rows_search_rows_write_words_2, 24);
  rows_search_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_2_memory_read_enable,
      read_address => rows_search_rows_read_words_2_memory_read_address, read_data => rows_search_rows_read_words_2,
      write_address => rows_search_rows_read_words_2_memory_write_address, write_data => rows_search_rows_read_words_2_memory_write_data);

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
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 24);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_4_memory_read_enable <= true;
  rows_reference_rows_read_words_4_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_4_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_4_memory_write_data <= to_unsigned(rows_reference_rows_write_words_4, 12);
  rows_reference_rows_read_words_4_memory : entity work.line_memory
    generic map (depth => 320, width => 12, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_4_memory_read_enable,
      read_address => rows_reference_rows_read_words_4_memory_read_address, read_data => rows_reference_rows_read_words_4,
      write_address => rows_reference_rows_read_words_4_memory_write_address, write_data => rows_reference_rows_read_words_4_memory_write_data);

  rows_reference_rows_read_words_3_memory_read_enable <= true;
  rows_reference_rows_read_words_3_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_3_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_3_memory_write_data <= to_unsigned(rows_reference_rows_write_words_3, 24);
  rows_reference_rows_read_words_3_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_3_memory_read_enable,
      read_address => rows_reference_rows_read_words_3_memory_read_address, read_data => rows_reference_rows_read_words_3,
      write_address => rows_reference_rows_read_words_3_memory_write_address, write_data => rows_reference_rows_read_words_3_memory_write_data);

  rows_reference_rows_read_words_2_memory_read_enable <= true;
  rows_reference_rows_read_words_2_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_2_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_2_memory_write_data <= to_unsigned(rows_reference_rows_write_words_2, 24);
  rows_reference_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_2_memory_read_enable,
      read_address => rows_reference_rows_read_words_2_memory_read_address, read_data => rows_reference_rows_read_words_2,
      write_address => rows_reference_rows_read_words_2_memory_write_address, write_data => rows_reference_rows_read_words_2_memory_write_data);

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
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 24);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 24, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  delay_delayed_0_memory_read_enable <= true;
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 5);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 5);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_reference_0, 12);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 24, width => 12, address_bits => 5)
    port map (
      clock => clock, read_enable => delay_delayed_0_memory_read_enable,
      read_address => delay_delayed_0_memory_read_address, read_data => delay_delayed_0,
      write_address => delay_delayed_0_memory_write_address, write_data => delay_delayed_0_memory_write_data);

  transform_left_rows_read_words_2_memory_read_enable <= true;
  transform_left_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_2_memory_write_data <= to_unsigned(transform_left_rows_write_words_2, 8);
  transform_left_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 8, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_2_memory_read_enable,
      read_address => transform_left_rows_read_words_2_memory_read_address, read_data => transform_left_rows_read_words_2,
      write_address => transform_left_rows_read_words_2_memory_write_address, write_data => transform_left_rows_read_words_2_memory_write_data);

  transform_left_rows_read_words_1_memory_read_enable <= true;
  transform_left_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_1_memory_write_data <= transform_left_rows_write_words_1;
  transform_left_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_1_memory_read_enable,
      read_address => transform_left_rows_read_words_1_memory_read_address, read_data => transform_left_rows_read_words_1,
      write_address => transform_left_rows_read_words_1_memory_write_address, write_data => transform_left_rows_read_words_1_memory_write_data);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_2_memory_read_enable <= true;
  transform_right_rows_read_words_2_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_2_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_2_memory_write_data <= to_unsigned(transform_right_rows_write_words_2, 8);
  transform_right_rows_read_words_2_memory : entity work.line_memory
    generic map (depth => 320, width => 8, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_2_memory_read_enable,
      read_address => transform_right_rows_read_words_2_memory_read_address, read_data => transform_right_rows_read_words_2,
      write_address => transform_right_rows_read_words_2_memory_write_address, write_data => transform_right_rows_read_words_2_memory_write_data);

  transform_right_rows_read_words_1_memory_read_enable <= true;
  transform_right_rows_read_words_1_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_1_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_1_memory_write_data <= transform_right_rows_write_words_1;
  transform_right_rows_read_words_1_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_1_memory_read_enable,
      read_address => transform_right_rows_read_words_1_memory_read_address, read_data => transform_right_rows_read_words_1,
      write_address => transform_right_rows_read_words_1_memory_write_address, write_data => transform_right_rows_read_words_1_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 320, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_is_equal_3, transform_counter_group_differs : boolean;
    variable transform_counter_group_choice_2, transform_counter_group_is_equal_4 : boolean;
    variable transform_centre_column_is_less, transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choice_2, raster_place_group_is_equal, raster_place_group_choice : boolean;
    variable delay_tag_first_cost_is_equal, slice0cost_pixels_first_0_0_value : boolean;
    variable slice0cost_pixels_first_0_0_value_2, slice0cost_pixels_first_0_0_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_value_4, slice0cost_pixels_first_0_0_value_5 : boolean;
    variable slice0cost_pixels_first_0_0_value_6, slice0cost_pixels_first_0_0_value_7 : boolean;
    variable slice0cost_pixels_first_0_0_value_8, slice0cost_pixels_first_0_0_value_9 : boolean;
    variable slice0cost_pixels_first_0_0_value_10, slice0cost_pixels_first_1_0_value : boolean;
    variable slice0cost_pixels_first_1_0_value_2, slice0cost_pixels_first_1_0_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_value_4, slice0cost_pixels_first_1_0_value_5 : boolean;
    variable slice0cost_pixels_first_1_0_value_6, slice0cost_pixels_first_1_0_value_7 : boolean;
    variable slice0cost_pixels_first_1_0_value_8, slice0cost_pixels_first_1_0_value_9 : boolean;
    variable slice0cost_pixels_first_1_0_value_10, slice0winner1_best_cost_0_0_is_less : boolean;
    variable slice0winner1_best_cost_0_1_is_less, slice0winner1_best_cost_0_2_is_less : boolean;
    variable slice0winner1_best_cost_0_3_is_less, slice0winner1_best_cost_0_4_is_less : boolean;
    variable slice0winner1_best_cost_0_5_is_less, slice0winner2_best_cost_0_0_is_less : boolean;
    variable slice0winner2_best_cost_0_1_is_less, slice0winner2_best_cost_0_2_is_less : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner4_best_cost_0_0_is_less : boolean;
    variable slice1cost_pixels_first_0_0_value, slice1cost_pixels_first_0_0_value_2 : boolean;
    variable slice1cost_pixels_first_0_0_value_3, slice1cost_pixels_first_0_0_value_4 : boolean;
    variable slice1cost_pixels_first_0_0_value_5, slice1cost_pixels_first_0_0_value_6 : boolean;
    variable slice1cost_pixels_first_0_0_value_7, slice1cost_pixels_first_0_0_value_8 : boolean;
    variable slice1cost_pixels_first_0_0_value_9, slice1cost_pixels_first_0_0_value_10 : boolean;
    variable slice1cost_pixels_first_1_0_value, slice1cost_pixels_first_1_0_value_2 : boolean;
    variable slice1cost_pixels_first_1_0_value_3, slice1cost_pixels_first_1_0_value_4 : boolean;
    variable slice1cost_pixels_first_1_0_value_5, slice1cost_pixels_first_1_0_value_6 : boolean;
    variable slice1cost_pixels_first_1_0_value_7, slice1cost_pixels_first_1_0_value_8 : boolean;
    variable slice1cost_pixels_first_1_0_value_9, slice1cost_pixels_first_1_0_value_10 : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner1_best_cost_0_1_is_less : boolean;
    variable slice1winner1_best_cost_0_2_is_less, slice1winner1_best_cost_0_3_is_less : boolean;
    variable slice1winner1_best_cost_0_4_is_less, slice1winner1_best_cost_0_5_is_less : boolean;
    variable slice1winner2_best_cost_0_0_is_less, slice1winner2_best_cost_0_1_is_less : boolean;
    variable slice1winner2_best_cost_0_2_is_less, slice1winner3_best_cost_0_0_is_less : boolean;
    variable slice1winner4_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less : boolean;
    variable refinement_divisor_0_0_is_less : boolean;
    variable transform_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choice_3, transform_counter_group_choice_4 : natural range 0 to 255;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_6_choice, slice0cost_column_0_6_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_7_choice, slice0cost_column_0_7_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_8_choice, slice0cost_column_0_8_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_9_choice, slice0cost_column_0_9_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_10_choice, slice0cost_column_0_10_choice_2 : natural range 0 to 255;
    variable slice0cost_column_0_11_choice, slice0cost_column_0_11_choice_2 : natural range 0 to 255;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 255;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 255;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 255;
    variable slice0window_change_0_6_choice, slice0window_change_0_7_choice : natural range 0 to 255;
    variable slice0window_change_0_8_choice, slice0window_change_0_9_choice : natural range 0 to 255;
    variable slice0window_change_0_10_choice, slice0window_change_0_11_choice : natural range 0 to 255;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_0_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_1_choice, slice1cost_column_0_1_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_2_choice, slice1cost_column_0_2_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_3_choice, slice1cost_column_0_3_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_4_choice, slice1cost_column_0_4_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_5_choice, slice1cost_column_0_5_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_6_choice, slice1cost_column_0_6_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_7_choice, slice1cost_column_0_7_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_8_choice, slice1cost_column_0_8_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_9_choice, slice1cost_column_0_9_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_10_choice, slice1cost_column_0_10_choice_2 : natural range 0 to 255;
    variable slice1cost_column_0_11_choice, slice1cost_column_0_11_choice_2 : natural range 0 to 255;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 255;
    variable slice1window_change_0_2_choice, slice1window_change_0_3_choice : natural range 0 to 255;
    variable slice1window_change_0_4_choice, slice1window_change_0_5_choice : natural range 0 to 255;
    variable slice1window_change_0_6_choice, slice1window_change_0_7_choice : natural range 0 to 255;
    variable slice1window_change_0_8_choice, slice1window_change_0_9_choice : natural range 0 to 255;
    variable slice1window_change_0_10_choice, slice1window_change_0_11_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable transform_centre_column_choice : natural range 79 to 127;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 2047;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 2047;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 2047;
    variable slice0window_sum_0_6_choice, slice0window_sum_0_7_choice : natural range 0 to 2047;
    variable slice0window_sum_0_8_choice, slice0window_sum_0_9_choice : natural range 0 to 2047;
    variable slice0window_sum_0_10_choice, slice0window_sum_0_11_choice : natural range 0 to 2047;
    variable slice0winner2_best_below_0_0_choice, slice0winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice0winner2_best_below_0_2_choice, slice0winner2_best_above_0_0_choice : natural range 0 to 2047;
    variable slice0winner2_best_above_0_1_choice, slice0winner2_best_above_0_2_choice : natural range 0 to 2047;
    variable slice0winner3_best_below_0_0_choice, slice0winner3_best_above_0_0_choice : natural range 0 to 2047;
    variable slice0winner4_best_below_0_0_choice, slice0winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1window_sum_0_0_choice, slice1window_sum_0_1_choice : natural range 0 to 2047;
    variable slice1window_sum_0_2_choice, slice1window_sum_0_3_choice : natural range 0 to 2047;
    variable slice1window_sum_0_4_choice, slice1window_sum_0_5_choice : natural range 0 to 2047;
    variable slice1window_sum_0_6_choice, slice1window_sum_0_7_choice : natural range 0 to 2047;
    variable slice1window_sum_0_8_choice, slice1window_sum_0_9_choice : natural range 0 to 2047;
    variable slice1window_sum_0_10_choice, slice1window_sum_0_11_choice : natural range 0 to 2047;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_below_0_1_choice : natural range 0 to 2047;
    variable slice1winner2_best_below_0_2_choice, slice1winner2_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1winner2_best_above_0_1_choice, slice1winner2_best_above_0_2_choice : natural range 0 to 2047;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1winner4_best_below_0_0_choice, slice1winner4_best_above_0_0_choice : natural range 0 to 2047;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 2047;
    variable refinement_divisor_0_0_choice : natural range 0 to 2047;
    variable refinement_remainder_1_0_difference : natural range 2049 to 6143;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 2049 to 8190;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 2049 to 8190;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 2049 to 8190;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_column = 319;
      transform_counter_group_is_equal_2 := transform_counter_group = 239;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 15;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_is_equal_3 := (transform_counter_group / 16) = 15;
      transform_counter_group_differs := (transform_counter_group mod 16) /= 4;
      if transform_counter_group_is_equal_3 then
        transform_counter_group_choice_2 := transform_counter_group_differs and in_valid and
          transform_counter_group_is_equal;
      else
        transform_counter_group_choice_2 := in_valid and transform_counter_group_is_equal;
      end if;
      transform_counter_group_is_equal_4 := transform_counter_group = 243;
      if transform_counter_group_is_equal_4 and transform_counter_next_frame then
        transform_counter_group_choice_3 := 4;
      else
        transform_counter_group_choice_3 := (transform_counter_group + 1) mod 256;
      end if;
      if transform_counter_group_choice_2 then
        transform_counter_group_choice_4 := transform_counter_group_choice_3;
      else
        transform_counter_group_choice_4 := transform_counter_group;
      end if;
      transform_centre_column_is_less := 3 < transform_counter_column;
      if transform_centre_column_is_less then
        transform_centre_column_choice := 127;
      else
        transform_centre_column_choice := 79;
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
      transform_centre_column <= (((transform_centre_column_choice + (transform_counter_column / 4)) mod 128) * 4) +
        (transform_counter_column mod 4);
      transform_centre_group <= transform_counter_group + as_number(transform_centre_column_is_less);
      transform_from_first_0 <= (1 < transform_centre_column) and (6 < transform_centre_group);
      transform_from_first_1 <= (4 < transform_centre_column) and (9 < transform_centre_group);
      transform_up_to_last_0 <= (transform_centre_column < 318) and (transform_centre_group < 243);
      transform_up_to_last_1 <= (transform_centre_column < 316) and (transform_centre_group < 241);
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
      transform_columns_start_of_frame <= (other_1 mod 2) = 1;
      transform_columns_valid <= (other_1 / 256) = 1;
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
      transform_left_code_row_signs <= ((other_18 / 8192) * 2) + (other_19 / 8192) + ((((transform_left_code_row_even_2
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
      transform_left_code_next_row_signs <= (other_17 / 32768) + ((transform_left_code_next_row_odd_0 / 32768) * 2) +
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
      transform_right_code_row_signs <= ((other_14 / 8192) * 2) + (other_15 / 8192) +
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
      transform_right_code_next_row_signs <= (other_13 / 32768) + ((transform_right_code_next_row_odd_0 / 32768) * 2) +
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
        transform_counter_group <= transform_counter_group_choice * 16;
      else
        transform_counter_group <= transform_counter_group_choice_4;
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
      if transform_counter_group_is_equal_3 then
        transform_counter_next_frame_choice := transform_counter_group_differs and transform_counter_group_is_equal;
      else
        transform_counter_next_frame_choice := transform_counter_group_is_equal;
      end if;
      if in_start_of_frame then
        transform_counter_next_frame_choice_2 := transform_counter_group_all;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_group_is_equal_4 and transform_counter_next_frame_choice then
          transform_counter_next_frame <= transform_counter_group_is_equal and transform_counter_group_is_equal_2 and
            in_start_of_frame;
        else
          transform_counter_next_frame <= transform_counter_next_frame_choice_2;
        end if;
      end if;
      if (other_1 / 256) = 1 then
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
      raster_place_group_is_equal := raster_place_column = 319;
      if ((raster_place_group mod 16) = 4) and ((raster_place_group / 128) = 1) and (((raster_place_group / 16) mod 4)
        = 3) then
        raster_place_group_choice := transform_filtering_7_valid and raster_place_group_is_equal and (not
          (((raster_place_group / 64) mod 2) = 1));
      else
        raster_place_group_choice := transform_filtering_7_valid and raster_place_group_is_equal;
      end if;
      raster_features_search_0 <= (transform_left_code_next_bits * 64) + transform_left_code_bits;
      raster_features_reference_0 <= (transform_right_code_next_bits * 64) + transform_right_code_bits;
      raster_features_valid <= transform_filtering_7_valid;
      if transform_filtering_7_valid and transform_filtering_7_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(raster_place_group_choice)) mod 256;
      end if;
      if transform_filtering_7_valid then
        if raster_place_group_is_equal or transform_filtering_7_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 23 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 32;
        end if;
      end if;
      delay_tag_first_cost_is_equal := raster_place_column = 23;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (raster_place_group >= 9) and (raster_place_group < 249);
      delay_row_inside_1 <= (not ((raster_place_group / 128) = 1)) or (not (((raster_place_group / 64) mod 2) = 1)) or
        (not (((raster_place_group / 32) mod 2) = 1)) or (not (((raster_place_group / 16) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= raster_place_column = 0;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_border_column <= raster_place_column < 23;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_leaves_window <= (((((raster_place_column / 32) + 2047) mod 2048) * 32) + (raster_place_column mod 32))
        < 65508;
      delay_tag_output_column <= ((((((raster_place_group / 4) + 16383) mod 16384) * 4) + (raster_place_group mod 4)) <
        240) and (raster_place_column >= 23) and (raster_place_column < 319);
      delay_tag_start_of_frame <= delay_tag_first_cost_is_equal and (raster_place_group = 4);
      delay_tag_end_of_line <= raster_place_column = 318;
      -- rows
      rows_search_rows_read_newest_0 <= delay_ahead_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_words_2 <= to_integer(rows_search_rows_read_words_2);
      rows_search_rows_ready_words_3 <= to_integer(rows_search_rows_read_words_3);
      rows_search_rows_ready_words_4 <= to_integer(rows_search_rows_read_words_4);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_words_2 <= to_integer(rows_reference_rows_read_words_2);
      rows_reference_rows_ready_words_3 <= to_integer(rows_reference_rows_read_words_3);
      rows_reference_rows_ready_words_4 <= to_integer(rows_reference_rows_read_words_4);
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
        rows_search_0 <= rows_search_rows_ready_words_0 mod 4096;
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 4096;
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
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 4096) + ((rows_search_rows_ready_words_1
          mod 4096) * 4096);
        rows_search_rows_write_words_1 <= (rows_search_rows_ready_words_1 / 4096) + ((rows_search_rows_ready_words_2
          mod 4096) * 4096);
        rows_search_rows_write_words_2 <= (rows_search_rows_ready_words_2 / 4096) + ((rows_search_rows_ready_words_3
          mod 4096) * 4096);
        rows_search_rows_write_words_3 <= (rows_search_rows_ready_words_3 / 4096) + (rows_search_rows_ready_words_4 *
          4096);
        rows_search_rows_write_words_4 <= rows_search_rows_ready_newest_0;
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 4096) +
          ((rows_reference_rows_ready_words_1 mod 4096) * 4096);
        rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_words_1 / 4096) +
          ((rows_reference_rows_ready_words_2 mod 4096) * 4096);
        rows_reference_rows_write_words_2 <= (rows_reference_rows_ready_words_2 / 4096) +
          ((rows_reference_rows_ready_words_3 mod 4096) * 4096);
        rows_reference_rows_write_words_3 <= (rows_reference_rows_ready_words_3 / 4096) +
          (rows_reference_rows_ready_words_4 * 4096);
        rows_reference_rows_write_words_4 <= rows_reference_rows_ready_newest_0;
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
        slice0shift_search_0_11 <= rows_search_0;
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
        slice0shift_search_1_11 <= rows_search_1;
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
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := to_integer(slice0cost_ready_words_0(7 downto 0));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_0_choice_2 := 0;
      else
        slice0cost_column_0_0_choice_2 := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := to_integer(slice0cost_ready_words_0(15 downto 8));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_1_choice_2 := 0;
      else
        slice0cost_column_0_1_choice_2 := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := to_integer(slice0cost_ready_words_0(23 downto 16));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_2_choice_2 := 0;
      else
        slice0cost_column_0_2_choice_2 := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := to_integer(slice0cost_ready_words_0(31 downto 24));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_3_choice_2 := 0;
      else
        slice0cost_column_0_3_choice_2 := (slice0cost_change_0_3 + slice0cost_column_0_3_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := to_integer(slice0cost_ready_words_1(7 downto 0));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_4_choice_2 := 0;
      else
        slice0cost_column_0_4_choice_2 := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := to_integer(slice0cost_ready_words_1(15 downto 8));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_5_choice_2 := 0;
      else
        slice0cost_column_0_5_choice_2 := (slice0cost_change_0_5 + slice0cost_column_0_5_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_6_choice := 0;
      else
        slice0cost_column_0_6_choice := to_integer(slice0cost_ready_words_1(23 downto 16));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_6_choice_2 := 0;
      else
        slice0cost_column_0_6_choice_2 := (slice0cost_change_0_6 + slice0cost_column_0_6_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_7_choice := 0;
      else
        slice0cost_column_0_7_choice := to_integer(slice0cost_ready_words_1(31 downto 24));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_7_choice_2 := 0;
      else
        slice0cost_column_0_7_choice_2 := (slice0cost_change_0_7 + slice0cost_column_0_7_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_8_choice := 0;
      else
        slice0cost_column_0_8_choice := to_integer(slice0cost_ready_words_2(7 downto 0));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_8_choice_2 := 0;
      else
        slice0cost_column_0_8_choice_2 := (slice0cost_change_0_8 + slice0cost_column_0_8_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_9_choice := 0;
      else
        slice0cost_column_0_9_choice := to_integer(slice0cost_ready_words_2(15 downto 8));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_9_choice_2 := 0;
      else
        slice0cost_column_0_9_choice_2 := (slice0cost_change_0_9 + slice0cost_column_0_9_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_10_choice := 0;
      else
        slice0cost_column_0_10_choice := to_integer(slice0cost_ready_words_2(23 downto 16));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_10_choice_2 := 0;
      else
        slice0cost_column_0_10_choice_2 := (slice0cost_change_0_10 + slice0cost_column_0_10_choice) mod 256;
      end if;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_11_choice := 0;
      else
        slice0cost_column_0_11_choice := to_integer(slice0cost_ready_words_2(31 downto 24));
      end if;
      if slice0cost_ready_tag_border_column then
        slice0cost_column_0_11_choice_2 := 0;
      else
        slice0cost_column_0_11_choice_2 := (slice0cost_column_0_11_choice + slice0cost_change_0_11) mod 256;
      end if;
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
      slice0cost_pixels_first_0_6 <= ((as_number(((((slice0shift_search_0_6 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_6 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_6 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_6 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_6 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_6 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_6 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_6 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_6 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_6 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_6 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_6 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_7 <= ((as_number(((((slice0shift_search_0_7 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_7 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_7 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_7 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_7 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_7 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_7 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_7 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_7 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_7 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_7 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_7 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_8 <= ((as_number(((((slice0shift_search_0_8 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_8 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_8 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_8 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_8 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_8 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_8 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_8 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_8 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_8 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_8 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_8 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_9 <= ((as_number(((((slice0shift_search_0_9 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_9 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_9 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_9 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_9 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_9 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_9 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_9 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_9 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_9 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_9 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_9 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_10 <= ((as_number(((((slice0shift_search_0_10 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_10 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_10 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_10 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_10 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_10 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_10 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_10 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_10 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_10 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_10 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_10 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_10))) * 64);
      slice0cost_pixels_first_0_11 <= ((as_number(((((slice0shift_search_0_11 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value)) + as_number(((((slice0shift_search_0_11 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_2)) + as_number(((((slice0shift_search_0_11 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice0shift_search_0_11 mod 2) = 1) /=
        ((slice0shift_reference_0 mod 2) = 1))) + as_number(((((slice0shift_search_0_11 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_4)) + as_number(((((slice0shift_search_0_11 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_5)) + ((as_number(((((slice0shift_search_0_11 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_6)) + as_number(((((slice0shift_search_0_11 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_7)) + as_number(((((slice0shift_search_0_11 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice0shift_search_0_11 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_0_0_value_9)) + as_number((((slice0shift_search_0_11 / 2048) = 1) /=
        ((slice0shift_reference_0 / 2048) = 1))) + as_number(((((slice0shift_search_0_11 / 1024) mod 2) = 1) /=
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
      slice0cost_pixels_first_1_6 <= ((as_number(((((slice0shift_search_1_6 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_6 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_6 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_6 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_6 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_6 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_6 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_6 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_6 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_6 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_6 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_6 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_7 <= ((as_number(((((slice0shift_search_1_7 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_7 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_7 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_7 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_7 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_7 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_7 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_7 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_7 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_7 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_7 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_7 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_8 <= ((as_number(((((slice0shift_search_1_8 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_8 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_8 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_8 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_8 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_8 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_8 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_8 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_8 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_8 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_8 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_8 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_9 <= ((as_number(((((slice0shift_search_1_9 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_9 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_9 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_9 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_9 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_9 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_9 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_9 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_9 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_9 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_9 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_9 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_10 <= ((as_number(((((slice0shift_search_1_10 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_10 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_10 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_10 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_10 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_10 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_10 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_10 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_10 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_10 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_10 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_10 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_1_11 <= ((as_number(((((slice0shift_search_1_11 / 8) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value)) + as_number(((((slice0shift_search_1_11 / 32) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_2)) + as_number(((((slice0shift_search_1_11 / 16) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice0shift_search_1_11 mod 2) = 1) /=
        ((slice0shift_reference_1 mod 2) = 1))) + as_number(((((slice0shift_search_1_11 / 4) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_4)) + as_number(((((slice0shift_search_1_11 / 2) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_5)) + ((as_number(((((slice0shift_search_1_11 / 64) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_6)) + as_number(((((slice0shift_search_1_11 / 256) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_7)) + as_number(((((slice0shift_search_1_11 / 128) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice0shift_search_1_11 / 512) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_9)) + as_number((((slice0shift_search_1_11 / 2048) = 1) /=
        ((slice0shift_reference_1 / 2048) = 1))) + as_number(((((slice0shift_search_1_11 / 1024) mod 2) = 1) /=
        slice0cost_pixels_first_1_0_value_10))) * 64);
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
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
      slice0cost_pixels_cost_0_6 <= (((slice0cost_pixels_first_0_6 mod 4) + (((slice0cost_pixels_first_0_6 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_6 / 16) mod 4) + (slice0cost_pixels_first_0_6 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_6 / 16) + (slice0cost_pixels_first_0_6 / 64)) mod 2);
      slice0cost_pixels_cost_0_7 <= (((slice0cost_pixels_first_0_7 mod 4) + (((slice0cost_pixels_first_0_7 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_7 / 16) mod 4) + (slice0cost_pixels_first_0_7 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_7 / 16) + (slice0cost_pixels_first_0_7 / 64)) mod 2);
      slice0cost_pixels_cost_0_8 <= (((slice0cost_pixels_first_0_8 mod 4) + (((slice0cost_pixels_first_0_8 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_8 / 16) mod 4) + (slice0cost_pixels_first_0_8 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_8 / 16) + (slice0cost_pixels_first_0_8 / 64)) mod 2);
      slice0cost_pixels_cost_0_9 <= (((slice0cost_pixels_first_0_9 mod 4) + (((slice0cost_pixels_first_0_9 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_0_9 / 16) mod 4) + (slice0cost_pixels_first_0_9 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_9 / 16) + (slice0cost_pixels_first_0_9 / 64)) mod 2);
      slice0cost_pixels_cost_0_10 <= (((slice0cost_pixels_first_0_10 mod 4) + (((slice0cost_pixels_first_0_10 / 2) mod
        8) / 2) + ((((slice0cost_pixels_first_0_10 / 16) mod 4) + (slice0cost_pixels_first_0_10 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_10 / 16) + (slice0cost_pixels_first_0_10 / 64)) mod 2);
      slice0cost_pixels_cost_0_11 <= (((slice0cost_pixels_first_0_11 mod 4) + (((slice0cost_pixels_first_0_11 / 2) mod
        8) / 2) + ((((slice0cost_pixels_first_0_11 / 16) mod 4) + (slice0cost_pixels_first_0_11 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_0_11 / 16) + (slice0cost_pixels_first_0_11 / 64)) mod 2);
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
      slice0cost_pixels_cost_1_6 <= (((slice0cost_pixels_first_1_6 mod 4) + (((slice0cost_pixels_first_1_6 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_6 / 16) mod 4) + (slice0cost_pixels_first_1_6 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_6 / 16) + (slice0cost_pixels_first_1_6 / 64)) mod 2);
      slice0cost_pixels_cost_1_7 <= (((slice0cost_pixels_first_1_7 mod 4) + (((slice0cost_pixels_first_1_7 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_7 / 16) mod 4) + (slice0cost_pixels_first_1_7 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_7 / 16) + (slice0cost_pixels_first_1_7 / 64)) mod 2);
      slice0cost_pixels_cost_1_8 <= (((slice0cost_pixels_first_1_8 mod 4) + (((slice0cost_pixels_first_1_8 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_8 / 16) mod 4) + (slice0cost_pixels_first_1_8 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_8 / 16) + (slice0cost_pixels_first_1_8 / 64)) mod 2);
      slice0cost_pixels_cost_1_9 <= (((slice0cost_pixels_first_1_9 mod 4) + (((slice0cost_pixels_first_1_9 / 2) mod 8)
        / 2) + ((((slice0cost_pixels_first_1_9 / 16) mod 4) + (slice0cost_pixels_first_1_9 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_9 / 16) + (slice0cost_pixels_first_1_9 / 64)) mod 2);
      slice0cost_pixels_cost_1_10 <= (((slice0cost_pixels_first_1_10 mod 4) + (((slice0cost_pixels_first_1_10 / 2) mod
        8) / 2) + ((((slice0cost_pixels_first_1_10 / 16) mod 4) + (slice0cost_pixels_first_1_10 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_10 / 16) + (slice0cost_pixels_first_1_10 / 64)) mod 2);
      slice0cost_pixels_cost_1_11 <= (((slice0cost_pixels_first_1_11 mod 4) + (((slice0cost_pixels_first_1_11 / 2) mod
        8) / 2) + ((((slice0cost_pixels_first_1_11 / 16) mod 4) + (slice0cost_pixels_first_1_11 / 64)) / 2)) * 2) +
        (((slice0cost_pixels_first_1_11 / 16) + (slice0cost_pixels_first_1_11 / 64)) mod 2);
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
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
      slice0cost_ready_words_0 <= slice0cost_read_words_0;
      slice0cost_ready_words_1 <= slice0cost_read_words_1;
      slice0cost_ready_words_2 <= slice0cost_read_words_2;
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
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
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
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
      if slice0cost_ready_tag_valid then
        slice0cost_write_words_0 <= to_unsigned(slice0cost_column_0_3_choice_2, 8) &
          to_unsigned(slice0cost_column_0_2_choice_2, 8) & to_unsigned(slice0cost_column_0_1_choice_2, 8) &
          to_unsigned(slice0cost_column_0_0_choice_2, 8);
        slice0cost_write_words_1 <= to_unsigned(slice0cost_column_0_7_choice_2, 8) &
          to_unsigned(slice0cost_column_0_6_choice_2, 8) & to_unsigned(slice0cost_column_0_5_choice_2, 8) &
          to_unsigned(slice0cost_column_0_4_choice_2, 8);
        slice0cost_write_words_2 <= to_unsigned(slice0cost_column_0_11_choice_2, 8) &
          to_unsigned(slice0cost_column_0_10_choice_2, 8) & to_unsigned(slice0cost_column_0_9_choice_2, 8) &
          to_unsigned(slice0cost_column_0_8_choice_2, 8);
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 9 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(7 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(15 downto 8));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_0(23 downto 16));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_0(31 downto 24));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_1(7 downto 0));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_1(15 downto 8));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_6_choice := to_integer(slice0window_leaving_1(23 downto 16));
      else
        slice0window_change_0_6_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_7_choice := to_integer(slice0window_leaving_1(31 downto 24));
      else
        slice0window_change_0_7_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_8_choice := to_integer(slice0window_leaving_2(7 downto 0));
      else
        slice0window_change_0_8_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_9_choice := to_integer(slice0window_leaving_2(15 downto 8));
      else
        slice0window_change_0_9_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_10_choice := to_integer(slice0window_leaving_2(23 downto 16));
      else
        slice0window_change_0_10_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_11_choice := to_integer(slice0window_leaving_2(31 downto 24));
      else
        slice0window_change_0_11_choice := 0;
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
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
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
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_first_cost <= slice0window_entering_tag_first_cost;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
      slice0window_centre_first_column_0 <= slice0window_change_tag_first_cost;
      slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
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
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 2048;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 2048;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 2048;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 2048;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 2048;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 2048;
        slice0window_sum_0_6 <= (slice0window_sum_0_6_choice + slice0window_change_0_6) mod 2048;
        slice0window_sum_0_7 <= (slice0window_sum_0_7_choice + slice0window_change_0_7) mod 2048;
        slice0window_sum_0_8 <= (slice0window_sum_0_8_choice + slice0window_change_0_8) mod 2048;
        slice0window_sum_0_9 <= (slice0window_sum_0_9_choice + slice0window_change_0_9) mod 2048;
        slice0window_sum_0_10 <= (slice0window_sum_0_10_choice + slice0window_change_0_10) mod 2048;
        slice0window_sum_0_11 <= (slice0window_sum_0_11_choice + slice0window_change_0_11) mod 2048;
      end if;
      if slice0window_tag_valid then
        slice0window_centre_start_of_frame_3 <= slice1window_centre_start_of_frame_1;
        slice0window_tag_output_column <= slice1window_centre_output_column_2;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_3;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_2;
      end if;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_best_cost_0_1_is_less := (slice0window_sum_0_3 - slice0window_sum_0_2) < 0;
      slice0winner1_best_cost_0_2_is_less := (slice0window_sum_0_5 - slice0window_sum_0_4) < 0;
      slice0winner1_best_cost_0_3_is_less := (slice0window_sum_0_7 - slice0window_sum_0_6) < 0;
      slice0winner1_best_cost_0_4_is_less := (slice0window_sum_0_9 - slice0window_sum_0_8) < 0;
      slice0winner1_best_cost_0_5_is_less := (slice0window_sum_0_11 - slice0window_sum_0_10) < 0;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_first_0_0 <= slice0window_sum_0_0;
      slice0winner1_best_first_0_1 <= slice0window_sum_0_2;
      slice0winner1_best_first_0_2 <= slice0window_sum_0_4;
      slice0winner1_best_first_0_3 <= slice0window_sum_0_6;
      slice0winner1_best_first_0_4 <= slice0window_sum_0_8;
      slice0winner1_best_first_0_5 <= slice0window_sum_0_10;
      slice0winner1_best_last_0_0 <= slice0window_sum_0_1;
      slice0winner1_best_last_0_1 <= slice0window_sum_0_3;
      slice0winner1_best_last_0_2 <= slice0window_sum_0_5;
      slice0winner1_best_last_0_3 <= slice0window_sum_0_7;
      slice0winner1_best_last_0_4 <= slice0window_sum_0_9;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_output_column <= slice0window_tag_output_column;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
        slice0winner1_best_below_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0window_sum_0_1;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_3;
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_above_0_1 <= 0;
      else
        slice0winner1_best_cost_0_1 <= slice0window_sum_0_2;
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0window_sum_0_3;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_5;
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_above_0_2 <= 0;
      else
        slice0winner1_best_cost_0_2 <= slice0window_sum_0_4;
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0window_sum_0_5;
      end if;
      if slice0winner1_best_cost_0_3_is_less then
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_7;
        slice0winner1_best_index_0_3 <= 7;
        slice0winner1_best_below_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_above_0_3 <= 0;
      else
        slice0winner1_best_cost_0_3 <= slice0window_sum_0_6;
        slice0winner1_best_index_0_3 <= 6;
        slice0winner1_best_below_0_3 <= 0;
        slice0winner1_best_above_0_3 <= slice0window_sum_0_7;
      end if;
      if slice0winner1_best_cost_0_4_is_less then
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_9;
        slice0winner1_best_index_0_4 <= 9;
        slice0winner1_best_below_0_4 <= slice0window_sum_0_8;
        slice0winner1_best_above_0_4 <= 0;
      else
        slice0winner1_best_cost_0_4 <= slice0window_sum_0_8;
        slice0winner1_best_index_0_4 <= 8;
        slice0winner1_best_below_0_4 <= 0;
        slice0winner1_best_above_0_4 <= slice0window_sum_0_9;
      end if;
      if slice0winner1_best_cost_0_5_is_less then
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_11;
        slice0winner1_best_index_0_5 <= 11;
        slice0winner1_best_below_0_5 <= slice0window_sum_0_10;
        slice0winner1_best_above_0_5 <= 0;
      else
        slice0winner1_best_cost_0_5 <= slice0window_sum_0_10;
        slice0winner1_best_index_0_5 <= 10;
        slice0winner1_best_below_0_5 <= 0;
        slice0winner1_best_above_0_5 <= slice0window_sum_0_11;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_cost_0_1_is_less := (slice0winner1_best_cost_0_3 - slice0winner1_best_cost_0_2) < 0;
      slice0winner2_best_cost_0_2_is_less := (slice0winner1_best_cost_0_5 - slice0winner1_best_cost_0_4) < 0;
      if slice0winner1_best_index_0_1 = 2 then
        slice0winner2_best_below_0_0_choice := slice0winner1_best_last_0_0;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      if slice0winner1_best_index_0_3 = 6 then
        slice0winner2_best_below_0_1_choice := slice0winner1_best_last_0_2;
      else
        slice0winner2_best_below_0_1_choice := slice0winner1_best_below_0_3;
      end if;
      if ((slice0winner1_best_index_0_5 / 8) = 1) and ((slice0winner1_best_index_0_5 mod 4) = 2) then
        slice0winner2_best_below_0_2_choice := slice0winner1_best_last_0_4;
      else
        slice0winner2_best_below_0_2_choice := slice0winner1_best_below_0_5;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_best_first_0_1;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if other_0 then
        slice0winner2_best_above_0_1_choice := slice0winner1_best_first_0_3;
      else
        slice0winner2_best_above_0_1_choice := slice0winner1_best_above_0_2;
      end if;
      if other_3 then
        slice0winner2_best_above_0_2_choice := slice0winner1_best_first_0_5;
      else
        slice0winner2_best_above_0_2_choice := slice0winner1_best_above_0_4;
      end if;
      slice0winner2_best_first_0_0 <= slice0winner1_best_first_0_0;
      slice0winner2_best_first_0_1 <= slice0winner1_best_first_0_2;
      slice0winner2_best_first_0_2 <= slice0winner1_best_first_0_4;
      slice0winner2_best_last_0_0 <= slice0winner1_best_last_0_1;
      slice0winner2_best_last_0_1 <= slice0winner1_best_last_0_3;
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
      if slice0winner2_best_cost_0_1_is_less then
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_3;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_3;
        slice0winner2_best_below_0_1 <= slice0winner2_best_below_0_1_choice;
        slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_3;
      else
        slice0winner2_best_cost_0_1 <= slice0winner1_best_cost_0_2;
        slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
        slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;
        slice0winner2_best_above_0_1 <= slice0winner2_best_above_0_1_choice;
      end if;
      if slice0winner2_best_cost_0_2_is_less then
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_5;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_5;
        slice0winner2_best_below_0_2 <= slice0winner2_best_below_0_2_choice;
        slice0winner2_best_above_0_2 <= slice0winner1_best_above_0_5;
      else
        slice0winner2_best_cost_0_2 <= slice0winner1_best_cost_0_4;
        slice0winner2_best_index_0_2 <= slice0winner1_best_index_0_4;
        slice0winner2_best_below_0_2 <= slice0winner1_best_below_0_4;
        slice0winner2_best_above_0_2 <= slice0winner2_best_above_0_2_choice;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner2_best_cost_0_1 - slice0winner2_best_cost_0_0) < 0;
      if slice0winner2_best_index_0_1 = 4 then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      if slice0winner2_best_index_0_0 = 3 then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      slice0winner3_best_cost_0_1 <= slice0winner2_best_cost_0_2;
      slice0winner3_best_index_0_1 <= slice0winner2_best_index_0_2;
      slice0winner3_best_below_0_1 <= slice0winner2_best_below_0_2;
      slice0winner3_best_above_0_1 <= slice0winner2_best_above_0_2;
      slice0winner3_best_first_0_0 <= slice0winner2_best_first_0_0;
      slice0winner3_best_first_0_1 <= slice0winner2_best_first_0_2;
      slice0winner3_best_last_0_0 <= slice0winner2_best_last_0_1;
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
      -- slice0winner4
      slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0_1 - slice0winner3_best_cost_0_0) < 0;
      if ((slice0winner3_best_index_0_1 / 8) = 1) and ((slice0winner3_best_index_0_1 mod 4) = 0) then
        slice0winner4_best_below_0_0_choice := slice0winner3_best_last_0_0;
      else
        slice0winner4_best_below_0_0_choice := slice0winner3_best_below_0_1;
      end if;
      if slice0winner3_best_index_0_0 = 7 then
        slice0winner4_best_above_0_0_choice := slice0winner3_best_first_0_1;
      else
        slice0winner4_best_above_0_0_choice := slice0winner3_best_above_0_0;
      end if;
      slice0winner4_best_first_0_0 <= slice0winner3_best_first_0_0;
      slice0winner4_tag_valid <= slice0winner3_tag_valid;
      slice0winner4_tag_output_column <= slice0winner3_tag_output_column;
      slice0winner4_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0winner4_tag_end_of_line <= slice0winner3_tag_end_of_line;
      if slice0winner4_best_cost_0_0_is_less then
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_1;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_1;
        slice0winner4_best_below_0_0 <= slice0winner4_best_below_0_0_choice;
        slice0winner4_best_above_0_0 <= slice0winner3_best_above_0_1;
      else
        slice0winner4_best_cost_0_0 <= slice0winner3_best_cost_0_0;
        slice0winner4_best_index_0_0 <= slice0winner3_best_index_0_0;
        slice0winner4_best_below_0_0 <= slice0winner3_best_below_0_0;
        slice0winner4_best_above_0_0 <= slice0winner4_best_above_0_0_choice;
      end if;
      -- slice0
      slice0_best_cost_0_0 <= slice0winner4_best_cost_0_0;
      slice0_best_index_0_0 <= (((slice0winner4_best_index_0_0 / 4) + 3) * 4) + (slice0winner4_best_index_0_0 mod 4);
      slice0_best_below_0_0 <= slice0winner4_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner4_best_above_0_0;
      slice0_best_first_0_0 <= slice0winner4_best_first_0_0;
      slice0_best_tag_valid <= slice0winner4_tag_valid;
      slice0_best_tag_output_column <= slice0winner4_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner4_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner4_tag_end_of_line;
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
        slice1shift_search_0_11 <= slice0shift_search_out_0;
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
        slice1shift_search_1_11 <= slice0shift_search_out_1;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_reference_1 <= slice0shift_reference_1;
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
      if slice0cost_tag_first_group then
        slice1cost_column_0_0_choice := 0;
      else
        slice1cost_column_0_0_choice := to_integer(slice1cost_ready_words_0(7 downto 0));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_0_choice_2 := 0;
      else
        slice1cost_column_0_0_choice_2 := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := to_integer(slice1cost_ready_words_0(15 downto 8));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_1_choice_2 := 0;
      else
        slice1cost_column_0_1_choice_2 := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := to_integer(slice1cost_ready_words_0(23 downto 16));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_2_choice_2 := 0;
      else
        slice1cost_column_0_2_choice_2 := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := to_integer(slice1cost_ready_words_0(31 downto 24));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_3_choice_2 := 0;
      else
        slice1cost_column_0_3_choice_2 := (slice1cost_change_0_3 + slice1cost_column_0_3_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := to_integer(slice1cost_ready_words_1(7 downto 0));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_4_choice_2 := 0;
      else
        slice1cost_column_0_4_choice_2 := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := to_integer(slice1cost_ready_words_1(15 downto 8));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_5_choice_2 := 0;
      else
        slice1cost_column_0_5_choice_2 := (slice1cost_change_0_5 + slice1cost_column_0_5_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_6_choice := 0;
      else
        slice1cost_column_0_6_choice := to_integer(slice1cost_ready_words_1(23 downto 16));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_6_choice_2 := 0;
      else
        slice1cost_column_0_6_choice_2 := (slice1cost_change_0_6 + slice1cost_column_0_6_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_7_choice := 0;
      else
        slice1cost_column_0_7_choice := to_integer(slice1cost_ready_words_1(31 downto 24));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_7_choice_2 := 0;
      else
        slice1cost_column_0_7_choice_2 := (slice1cost_change_0_7 + slice1cost_column_0_7_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_8_choice := 0;
      else
        slice1cost_column_0_8_choice := to_integer(slice1cost_ready_words_2(7 downto 0));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_8_choice_2 := 0;
      else
        slice1cost_column_0_8_choice_2 := (slice1cost_change_0_8 + slice1cost_column_0_8_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_9_choice := 0;
      else
        slice1cost_column_0_9_choice := to_integer(slice1cost_ready_words_2(15 downto 8));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_9_choice_2 := 0;
      else
        slice1cost_column_0_9_choice_2 := (slice1cost_change_0_9 + slice1cost_column_0_9_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_10_choice := 0;
      else
        slice1cost_column_0_10_choice := to_integer(slice1cost_ready_words_2(23 downto 16));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_10_choice_2 := 0;
      else
        slice1cost_column_0_10_choice_2 := (slice1cost_change_0_10 + slice1cost_column_0_10_choice) mod 256;
      end if;
      if slice0cost_tag_first_group then
        slice1cost_column_0_11_choice := 0;
      else
        slice1cost_column_0_11_choice := to_integer(slice1cost_ready_words_2(31 downto 24));
      end if;
      if slice0cost_tag_border_column then
        slice1cost_column_0_11_choice_2 := 0;
      else
        slice1cost_column_0_11_choice_2 := (slice1cost_column_0_11_choice + slice1cost_change_0_11) mod 256;
      end if;
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
      slice1cost_pixels_first_0_6 <= ((as_number(((((slice1shift_search_0_6 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_6 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_6 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_6 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_6 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_6 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_6 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_6 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_6 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_6 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_6 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_6 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_7 <= ((as_number(((((slice1shift_search_0_7 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_7 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_7 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_7 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_7 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_7 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_7 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_7 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_7 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_7 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_7 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_7 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_8 <= ((as_number(((((slice1shift_search_0_8 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_8 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_8 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_8 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_8 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_8 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_8 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_8 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_8 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_8 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_8 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_8 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_9 <= ((as_number(((((slice1shift_search_0_9 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_9 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_9 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_9 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_9 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_9 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_9 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_9 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_9 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_9 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_9 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_9 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_10 <= ((as_number(((((slice1shift_search_0_10 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_10 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_10 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_10 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_10 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_10 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_10 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_10 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_10 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_10 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_10 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_10 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_10))) * 64);
      slice1cost_pixels_first_0_11 <= ((as_number(((((slice1shift_search_0_11 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value)) + as_number(((((slice1shift_search_0_11 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_2)) + as_number(((((slice1shift_search_0_11 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_3))) * 4) + as_number((((slice1shift_search_0_11 mod 2) = 1) /=
        ((slice1shift_reference_0 mod 2) = 1))) + as_number(((((slice1shift_search_0_11 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_4)) + as_number(((((slice1shift_search_0_11 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_5)) + ((as_number(((((slice1shift_search_0_11 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_6)) + as_number(((((slice1shift_search_0_11 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_7)) + as_number(((((slice1shift_search_0_11 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_8))) * 16) + ((as_number(((((slice1shift_search_0_11 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_0_0_value_9)) + as_number((((slice1shift_search_0_11 / 2048) = 1) /=
        ((slice1shift_reference_0 / 2048) = 1))) + as_number(((((slice1shift_search_0_11 / 1024) mod 2) = 1) /=
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
      slice1cost_pixels_first_1_6 <= ((as_number(((((slice1shift_search_1_6 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_6 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_6 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_6 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_6 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_6 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_6 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_6 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_6 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_6 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_6 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_6 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_7 <= ((as_number(((((slice1shift_search_1_7 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_7 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_7 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_7 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_7 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_7 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_7 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_7 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_7 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_7 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_7 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_7 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_8 <= ((as_number(((((slice1shift_search_1_8 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_8 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_8 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_8 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_8 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_8 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_8 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_8 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_8 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_8 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_8 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_8 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_9 <= ((as_number(((((slice1shift_search_1_9 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_9 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_9 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_9 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_9 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_9 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_9 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_9 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_9 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_9 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_9 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_9 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_10 <= ((as_number(((((slice1shift_search_1_10 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_10 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_10 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_10 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_10 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_10 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_10 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_10 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_10 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_10 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_10 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_10 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
      slice1cost_pixels_first_1_11 <= ((as_number(((((slice1shift_search_1_11 / 8) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value)) + as_number(((((slice1shift_search_1_11 / 32) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_2)) + as_number(((((slice1shift_search_1_11 / 16) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_3))) * 4) + as_number((((slice1shift_search_1_11 mod 2) = 1) /=
        ((slice1shift_reference_1 mod 2) = 1))) + as_number(((((slice1shift_search_1_11 / 4) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_4)) + as_number(((((slice1shift_search_1_11 / 2) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_5)) + ((as_number(((((slice1shift_search_1_11 / 64) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_6)) + as_number(((((slice1shift_search_1_11 / 256) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_7)) + as_number(((((slice1shift_search_1_11 / 128) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_8))) * 16) + ((as_number(((((slice1shift_search_1_11 / 512) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_9)) + as_number((((slice1shift_search_1_11 / 2048) = 1) /=
        ((slice1shift_reference_1 / 2048) = 1))) + as_number(((((slice1shift_search_1_11 / 1024) mod 2) = 1) /=
        slice1cost_pixels_first_1_0_value_10))) * 64);
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
      slice1cost_pixels_cost_0_6 <= (((slice1cost_pixels_first_0_6 mod 4) + (((slice1cost_pixels_first_0_6 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_6 / 16) mod 4) + (slice1cost_pixels_first_0_6 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_6 / 16) + (slice1cost_pixels_first_0_6 / 64)) mod 2);
      slice1cost_pixels_cost_0_7 <= (((slice1cost_pixels_first_0_7 mod 4) + (((slice1cost_pixels_first_0_7 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_7 / 16) mod 4) + (slice1cost_pixels_first_0_7 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_7 / 16) + (slice1cost_pixels_first_0_7 / 64)) mod 2);
      slice1cost_pixels_cost_0_8 <= (((slice1cost_pixels_first_0_8 mod 4) + (((slice1cost_pixels_first_0_8 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_8 / 16) mod 4) + (slice1cost_pixels_first_0_8 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_8 / 16) + (slice1cost_pixels_first_0_8 / 64)) mod 2);
      slice1cost_pixels_cost_0_9 <= (((slice1cost_pixels_first_0_9 mod 4) + (((slice1cost_pixels_first_0_9 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_0_9 / 16) mod 4) + (slice1cost_pixels_first_0_9 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_9 / 16) + (slice1cost_pixels_first_0_9 / 64)) mod 2);
      slice1cost_pixels_cost_0_10 <= (((slice1cost_pixels_first_0_10 mod 4) + (((slice1cost_pixels_first_0_10 / 2) mod
        8) / 2) + ((((slice1cost_pixels_first_0_10 / 16) mod 4) + (slice1cost_pixels_first_0_10 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_10 / 16) + (slice1cost_pixels_first_0_10 / 64)) mod 2);
      slice1cost_pixels_cost_0_11 <= (((slice1cost_pixels_first_0_11 mod 4) + (((slice1cost_pixels_first_0_11 / 2) mod
        8) / 2) + ((((slice1cost_pixels_first_0_11 / 16) mod 4) + (slice1cost_pixels_first_0_11 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_0_11 / 16) + (slice1cost_pixels_first_0_11 / 64)) mod 2);
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
      slice1cost_pixels_cost_1_6 <= (((slice1cost_pixels_first_1_6 mod 4) + (((slice1cost_pixels_first_1_6 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_6 / 16) mod 4) + (slice1cost_pixels_first_1_6 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_6 / 16) + (slice1cost_pixels_first_1_6 / 64)) mod 2);
      slice1cost_pixels_cost_1_7 <= (((slice1cost_pixels_first_1_7 mod 4) + (((slice1cost_pixels_first_1_7 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_7 / 16) mod 4) + (slice1cost_pixels_first_1_7 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_7 / 16) + (slice1cost_pixels_first_1_7 / 64)) mod 2);
      slice1cost_pixels_cost_1_8 <= (((slice1cost_pixels_first_1_8 mod 4) + (((slice1cost_pixels_first_1_8 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_8 / 16) mod 4) + (slice1cost_pixels_first_1_8 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_8 / 16) + (slice1cost_pixels_first_1_8 / 64)) mod 2);
      slice1cost_pixels_cost_1_9 <= (((slice1cost_pixels_first_1_9 mod 4) + (((slice1cost_pixels_first_1_9 / 2) mod 8)
        / 2) + ((((slice1cost_pixels_first_1_9 / 16) mod 4) + (slice1cost_pixels_first_1_9 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_9 / 16) + (slice1cost_pixels_first_1_9 / 64)) mod 2);
      slice1cost_pixels_cost_1_10 <= (((slice1cost_pixels_first_1_10 mod 4) + (((slice1cost_pixels_first_1_10 / 2) mod
        8) / 2) + ((((slice1cost_pixels_first_1_10 / 16) mod 4) + (slice1cost_pixels_first_1_10 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_10 / 16) + (slice1cost_pixels_first_1_10 / 64)) mod 2);
      slice1cost_pixels_cost_1_11 <= (((slice1cost_pixels_first_1_11 mod 4) + (((slice1cost_pixels_first_1_11 / 2) mod
        8) / 2) + ((((slice1cost_pixels_first_1_11 / 16) mod 4) + (slice1cost_pixels_first_1_11 / 64)) / 2)) * 2) +
        (((slice1cost_pixels_first_1_11 / 16) + (slice1cost_pixels_first_1_11 / 64)) mod 2);
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice1cost_read_column;
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
      slice1cost_ready_words_0 <= slice1cost_read_words_0;
      slice1cost_ready_words_1 <= slice1cost_read_words_1;
      slice1cost_ready_words_2 <= slice1cost_read_words_2;
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
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        slice1cost_write_words_0 <= to_unsigned(slice1cost_column_0_3_choice_2, 8) &
          to_unsigned(slice1cost_column_0_2_choice_2, 8) & to_unsigned(slice1cost_column_0_1_choice_2, 8) &
          to_unsigned(slice1cost_column_0_0_choice_2, 8);
        slice1cost_write_words_1 <= to_unsigned(slice1cost_column_0_7_choice_2, 8) &
          to_unsigned(slice1cost_column_0_6_choice_2, 8) & to_unsigned(slice1cost_column_0_5_choice_2, 8) &
          to_unsigned(slice1cost_column_0_4_choice_2, 8);
        slice1cost_write_words_2 <= to_unsigned(slice1cost_column_0_11_choice_2, 8) &
          to_unsigned(slice1cost_column_0_10_choice_2, 8) & to_unsigned(slice1cost_column_0_9_choice_2, 8) &
          to_unsigned(slice1cost_column_0_8_choice_2, 8);
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 9 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 16;
        end if;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(7 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(15 downto 8));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_0(23 downto 16));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_0(31 downto 24));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_1(7 downto 0));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_1(15 downto 8));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_6_choice := to_integer(slice1window_leaving_1(23 downto 16));
      else
        slice1window_change_0_6_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_7_choice := to_integer(slice1window_leaving_1(31 downto 24));
      else
        slice1window_change_0_7_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_8_choice := to_integer(slice1window_leaving_2(7 downto 0));
      else
        slice1window_change_0_8_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_9_choice := to_integer(slice1window_leaving_2(15 downto 8));
      else
        slice1window_change_0_9_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_10_choice := to_integer(slice1window_leaving_2(23 downto 16));
      else
        slice1window_change_0_10_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_11_choice := to_integer(slice1window_leaving_2(31 downto 24));
      else
        slice1window_change_0_11_choice := 0;
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
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 2048;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 2048;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 2048;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 2048;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 2048;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 2048;
        slice1window_sum_0_6 <= (slice1window_sum_0_6_choice + slice1window_change_0_6) mod 2048;
        slice1window_sum_0_7 <= (slice1window_sum_0_7_choice + slice1window_change_0_7) mod 2048;
        slice1window_sum_0_8 <= (slice1window_sum_0_8_choice + slice1window_change_0_8) mod 2048;
        slice1window_sum_0_9 <= (slice1window_sum_0_9_choice + slice1window_change_0_9) mod 2048;
        slice1window_sum_0_10 <= (slice1window_sum_0_10_choice + slice1window_change_0_10) mod 2048;
        slice1window_sum_0_11 <= (slice1window_sum_0_11_choice + slice1window_change_0_11) mod 2048;
        slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
        slice1window_centre_output_column_1 <= slice1window_centre_output_column_0;
        slice1window_centre_output_column_2 <= slice1window_centre_output_column_1;
        slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
        slice1window_centre_start_of_frame_1 <= slice1window_centre_start_of_frame_0;
        slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
        slice1window_centre_end_of_line_1 <= slice1window_centre_end_of_line_0;
        slice1window_centre_end_of_line_2 <= slice1window_centre_end_of_line_1;
      end if;
      -- slice1winner1
      slice1winner1_best_cost_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_best_cost_0_1_is_less := (slice1window_sum_0_3 - slice1window_sum_0_2) < 0;
      slice1winner1_best_cost_0_2_is_less := (slice1window_sum_0_5 - slice1window_sum_0_4) < 0;
      slice1winner1_best_cost_0_3_is_less := (slice1window_sum_0_7 - slice1window_sum_0_6) < 0;
      slice1winner1_best_cost_0_4_is_less := (slice1window_sum_0_9 - slice1window_sum_0_8) < 0;
      slice1winner1_best_cost_0_5_is_less := (slice1window_sum_0_11 - slice1window_sum_0_10) < 0;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_first_0_1 <= slice1window_sum_0_2;
      slice1winner1_best_first_0_2 <= slice1window_sum_0_4;
      slice1winner1_best_first_0_3 <= slice1window_sum_0_6;
      slice1winner1_best_first_0_4 <= slice1window_sum_0_8;
      slice1winner1_best_first_0_5 <= slice1window_sum_0_10;
      slice1winner1_best_last_0_0 <= slice1window_sum_0_1;
      slice1winner1_best_last_0_1 <= slice1window_sum_0_3;
      slice1winner1_best_last_0_2 <= slice1window_sum_0_5;
      slice1winner1_best_last_0_3 <= slice1window_sum_0_7;
      slice1winner1_best_last_0_4 <= slice1window_sum_0_9;
      slice1winner1_best_last_0_5 <= slice1window_sum_0_11;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
        slice1winner1_best_below_0_0 <= slice1window_sum_0_0;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1window_sum_0_1;
      end if;
      if slice1winner1_best_cost_0_1_is_less then
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_3;
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0_1 <= slice1window_sum_0_2;
        slice1winner1_best_above_0_1 <= 0;
      else
        slice1winner1_best_cost_0_1 <= slice1window_sum_0_2;
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0_1 <= 0;
        slice1winner1_best_above_0_1 <= slice1window_sum_0_3;
      end if;
      if slice1winner1_best_cost_0_2_is_less then
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_5;
        slice1winner1_best_index_0_2 <= 5;
        slice1winner1_best_below_0_2 <= slice1window_sum_0_4;
        slice1winner1_best_above_0_2 <= 0;
      else
        slice1winner1_best_cost_0_2 <= slice1window_sum_0_4;
        slice1winner1_best_index_0_2 <= 4;
        slice1winner1_best_below_0_2 <= 0;
        slice1winner1_best_above_0_2 <= slice1window_sum_0_5;
      end if;
      if slice1winner1_best_cost_0_3_is_less then
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_7;
        slice1winner1_best_index_0_3 <= 7;
        slice1winner1_best_below_0_3 <= slice1window_sum_0_6;
        slice1winner1_best_above_0_3 <= 0;
      else
        slice1winner1_best_cost_0_3 <= slice1window_sum_0_6;
        slice1winner1_best_index_0_3 <= 6;
        slice1winner1_best_below_0_3 <= 0;
        slice1winner1_best_above_0_3 <= slice1window_sum_0_7;
      end if;
      if slice1winner1_best_cost_0_4_is_less then
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_9;
        slice1winner1_best_index_0_4 <= 9;
        slice1winner1_best_below_0_4 <= slice1window_sum_0_8;
        slice1winner1_best_above_0_4 <= 0;
      else
        slice1winner1_best_cost_0_4 <= slice1window_sum_0_8;
        slice1winner1_best_index_0_4 <= 8;
        slice1winner1_best_below_0_4 <= 0;
        slice1winner1_best_above_0_4 <= slice1window_sum_0_9;
      end if;
      if slice1winner1_best_cost_0_5_is_less then
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_11;
        slice1winner1_best_index_0_5 <= 11;
        slice1winner1_best_below_0_5 <= slice1window_sum_0_10;
        slice1winner1_best_above_0_5 <= 0;
      else
        slice1winner1_best_cost_0_5 <= slice1window_sum_0_10;
        slice1winner1_best_index_0_5 <= 10;
        slice1winner1_best_below_0_5 <= 0;
        slice1winner1_best_above_0_5 <= slice1window_sum_0_11;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_cost_0_1_is_less := (slice1winner1_best_cost_0_3 - slice1winner1_best_cost_0_2) < 0;
      slice1winner2_best_cost_0_2_is_less := (slice1winner1_best_cost_0_5 - slice1winner1_best_cost_0_4) < 0;
      if slice1winner1_best_index_0_1 = 2 then
        slice1winner2_best_below_0_0_choice := slice1winner1_best_last_0_0;
      else
        slice1winner2_best_below_0_0_choice := slice1winner1_best_below_0_1;
      end if;
      if slice1winner1_best_index_0_3 = 6 then
        slice1winner2_best_below_0_1_choice := slice1winner1_best_last_0_2;
      else
        slice1winner2_best_below_0_1_choice := slice1winner1_best_below_0_3;
      end if;
      if ((slice1winner1_best_index_0_5 / 8) = 1) and ((slice1winner1_best_index_0_5 mod 4) = 2) then
        slice1winner2_best_below_0_2_choice := slice1winner1_best_last_0_4;
      else
        slice1winner2_best_below_0_2_choice := slice1winner1_best_below_0_5;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_best_first_0_1;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      if other_11 then
        slice1winner2_best_above_0_1_choice := slice1winner1_best_first_0_3;
      else
        slice1winner2_best_above_0_1_choice := slice1winner1_best_above_0_2;
      end if;
      if other_12 then
        slice1winner2_best_above_0_2_choice := slice1winner1_best_first_0_5;
      else
        slice1winner2_best_above_0_2_choice := slice1winner1_best_above_0_4;
      end if;
      slice1winner2_best_first_0_1 <= slice1winner1_best_first_0_2;
      slice1winner2_best_first_0_2 <= slice1winner1_best_first_0_4;
      slice1winner2_best_last_0_0 <= slice1winner1_best_last_0_1;
      slice1winner2_best_last_0_1 <= slice1winner1_best_last_0_3;
      slice1winner2_best_last_0_2 <= slice1winner1_best_last_0_5;
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
      if slice1winner2_best_cost_0_1_is_less then
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_3;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_3;
        slice1winner2_best_below_0_1 <= slice1winner2_best_below_0_1_choice;
        slice1winner2_best_above_0_1 <= slice1winner1_best_above_0_3;
      else
        slice1winner2_best_cost_0_1 <= slice1winner1_best_cost_0_2;
        slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
        slice1winner2_best_below_0_1 <= slice1winner1_best_below_0_2;
        slice1winner2_best_above_0_1 <= slice1winner2_best_above_0_1_choice;
      end if;
      if slice1winner2_best_cost_0_2_is_less then
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_5;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_5;
        slice1winner2_best_below_0_2 <= slice1winner2_best_below_0_2_choice;
        slice1winner2_best_above_0_2 <= slice1winner1_best_above_0_5;
      else
        slice1winner2_best_cost_0_2 <= slice1winner1_best_cost_0_4;
        slice1winner2_best_index_0_2 <= slice1winner1_best_index_0_4;
        slice1winner2_best_below_0_2 <= slice1winner1_best_below_0_4;
        slice1winner2_best_above_0_2 <= slice1winner2_best_above_0_2_choice;
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := (slice1winner2_best_cost_0_1 - slice1winner2_best_cost_0_0) < 0;
      if slice1winner2_best_index_0_1 = 4 then
        slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0;
      else
        slice1winner3_best_below_0_0_choice := slice1winner2_best_below_0_1;
      end if;
      if slice1winner2_best_index_0_0 = 3 then
        slice1winner3_best_above_0_0_choice := slice1winner2_best_first_0_1;
      else
        slice1winner3_best_above_0_0_choice := slice1winner2_best_above_0_0;
      end if;
      slice1winner3_best_cost_0_1 <= slice1winner2_best_cost_0_2;
      slice1winner3_best_index_0_1 <= slice1winner2_best_index_0_2;
      slice1winner3_best_below_0_1 <= slice1winner2_best_below_0_2;
      slice1winner3_best_above_0_1 <= slice1winner2_best_above_0_2;
      slice1winner3_best_first_0_1 <= slice1winner2_best_first_0_2;
      slice1winner3_best_last_0_0 <= slice1winner2_best_last_0_1;
      slice1winner3_best_last_0_1 <= slice1winner2_best_last_0_2;
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
      -- slice1winner4
      slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0_1 - slice1winner3_best_cost_0_0) < 0;
      if ((slice1winner3_best_index_0_1 / 8) = 1) and ((slice1winner3_best_index_0_1 mod 4) = 0) then
        slice1winner4_best_below_0_0_choice := slice1winner3_best_last_0_0;
      else
        slice1winner4_best_below_0_0_choice := slice1winner3_best_below_0_1;
      end if;
      if slice1winner3_best_index_0_0 = 7 then
        slice1winner4_best_above_0_0_choice := slice1winner3_best_first_0_1;
      else
        slice1winner4_best_above_0_0_choice := slice1winner3_best_above_0_0;
      end if;
      slice1winner4_best_last_0_0 <= slice1winner3_best_last_0_1;
      if slice1winner4_best_cost_0_0_is_less then
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_1;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_1;
        slice1winner4_best_below_0_0 <= slice1winner4_best_below_0_0_choice;
        slice1winner4_best_above_0_0 <= slice1winner3_best_above_0_1;
      else
        slice1winner4_best_cost_0_0 <= slice1winner3_best_cost_0_0;
        slice1winner4_best_index_0_0 <= slice1winner3_best_index_0_0;
        slice1winner4_best_below_0_0 <= slice1winner3_best_below_0_0;
        slice1winner4_best_above_0_0 <= slice1winner4_best_above_0_0_choice;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner4_best_cost_0_0) < 0;
      if slice0_best_index_0_0 = 12 then
        slice1_best_below_0_0_choice := slice1winner4_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice0_best_below_0_0;
      end if;
      if slice1winner4_best_index_0_0 = 11 then
        slice1_best_above_0_0_choice := slice0_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice1winner4_best_above_0_0;
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
        slice1_best_cost_0_0 <= slice1winner4_best_cost_0_0;
        slice1_best_index_0_0 <= slice1winner4_best_index_0_0;
        slice1_best_below_0_0 <= slice1winner4_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      end if;
      -- refinement
      refinement_remainder_1_0_difference := (refinement_remainder_0_0 + 4096) - refinement_divisor_0_0;
      refinement_remainder_2_0_difference := ((refinement_remainder_1_0 * 2) + 4096) - refinement_divisor_1_0;
      refinement_remainder_3_0_difference := ((refinement_remainder_2_0 * 2) + 4096) - refinement_divisor_2_0;
      refinement_remainder_4_0_difference := ((refinement_remainder_3_0 * 2) + 4096) - refinement_divisor_3_0;
      refinement_remainder_5_0_difference := ((refinement_remainder_4_0 * 2) + 4096) - refinement_divisor_4_0;
      refinement_remainder_6_0_difference := ((refinement_remainder_5_0 * 2) + 4096) - refinement_divisor_5_0;
      refinement_remainder_7_0_difference := ((refinement_remainder_6_0 * 2) + 4096) - refinement_divisor_6_0;
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
      refinement_u_0 <= (refinement_below_0 - refinement_cost_0) mod 2048;
      refinement_v_0 <= (refinement_above_0 - refinement_cost_0) mod 2048;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0_0 <= magnitude(refinement_difference_0);
      refinement_divisor_0_0 <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 11)) or
        (to_unsigned(as_number(((refinement_u_0 = 0) and (refinement_v_0 = 0))), 11))));
      refinement_divisor_1_0 <= refinement_divisor_0_0;
      refinement_divisor_2_0 <= refinement_divisor_1_0;
      refinement_divisor_3_0 <= refinement_divisor_2_0;
      refinement_divisor_4_0 <= refinement_divisor_3_0;
      refinement_divisor_5_0 <= refinement_divisor_4_0;
      refinement_divisor_6_0 <= refinement_divisor_5_0;
      refinement_divisor_7_0 <= refinement_divisor_6_0;
      refinement_quotient_8_0 <= ((((4096 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) / 2048) +
        ((other_4 / 2) * 2);
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
      if slice1_best_index_0_0 = 0 then
        refinement_below_0 <= slice1_best_above_0_0;
      else
        refinement_below_0 <= slice1_best_below_0_0;
      end if;
      if slice1_best_index_0_0 = 23 then
        refinement_above_0 <= slice1_best_below_0_0;
      else
        refinement_above_0 <= slice1_best_above_0_0;
      end if;
      if (refinement_remainder_1_0_difference / 4096) = 1 then
        refinement_remainder_1_0 <= refinement_remainder_1_0_difference mod 2048;
      else
        refinement_remainder_1_0 <= refinement_remainder_0_0;
      end if;
      if (refinement_remainder_2_0_difference / 4096) = 1 then
        refinement_remainder_2_0 <= refinement_remainder_2_0_difference mod 2048;
      else
        refinement_remainder_2_0 <= (refinement_remainder_1_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_3_0_difference / 4096) = 1 then
        refinement_remainder_3_0 <= refinement_remainder_3_0_difference mod 2048;
      else
        refinement_remainder_3_0 <= (refinement_remainder_2_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_4_0_difference / 4096) = 1 then
        refinement_remainder_4_0 <= refinement_remainder_4_0_difference mod 2048;
      else
        refinement_remainder_4_0 <= (refinement_remainder_3_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_5_0_difference / 4096) = 1 then
        refinement_remainder_5_0 <= refinement_remainder_5_0_difference mod 2048;
      else
        refinement_remainder_5_0 <= (refinement_remainder_4_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_6_0_difference / 4096) = 1 then
        refinement_remainder_6_0 <= refinement_remainder_6_0_difference mod 2048;
      else
        refinement_remainder_6_0 <= (refinement_remainder_5_0 mod 1024) * 2;
      end if;
      if (refinement_remainder_7_0_difference / 4096) = 1 then
        refinement_remainder_7_0 <= refinement_remainder_7_0_difference mod 2048;
      else
        refinement_remainder_7_0 <= (refinement_remainder_6_0 mod 1024) * 2;
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
      other_0 <= slice0winner1_best_cost_0_2_is_less;
      other_1 <= other_2;
      other_2 <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 4) and
        (transform_counter_group = 4)));
      other_3 <= slice0winner1_best_cost_0_4_is_less;
      other_4 <= ((refinement_remainder_7_0_difference / 4096) * 2) + ((other_5 / 4) * 4);
      other_5 <= ((refinement_remainder_6_0_difference / 4096) * 4) + ((other_6 / 8) * 8);
      other_6 <= ((refinement_remainder_5_0_difference / 4096) * 8) + ((other_7 / 16) * 16);
      other_7 <= ((refinement_remainder_4_0_difference / 4096) * 16) + ((other_8 / 32) * 32);
      other_8 <= ((refinement_remainder_3_0_difference / 4096) * 32) + ((other_9 / 64) * 64);
      other_9 <= ((refinement_remainder_2_0_difference / 4096) * 64) + ((other_10 / 128) * 128);
      other_10 <= (refinement_remainder_1_0_difference / 4096) * 128;
      other_11 <= slice1winner1_best_cost_0_2_is_less;
      other_12 <= slice1winner1_best_cost_0_4_is_less;
      other_13 <= (((transform_right_code_next_row_outer_0 / 2) - transform_right_code_next_row_centre_0) mod 32768) *
        2;
      other_14 <= as_number(((transform_right_code_row_before_0 - transform_right_code_row_after_0) < 0)) * 8192;
      other_15 <= as_number((((other_16 / 2) - transform_right_code_row_centre_0) < 0)) * 8192;
      other_16 <= ((transform_right_code_row_box_0_0 + transform_right_code_row_column_0_3) / 2) * 2;
      other_17 <= (((transform_left_code_next_row_outer_0 / 2) - transform_left_code_next_row_centre_0) mod 32768) * 2;
      other_18 <= as_number(((transform_left_code_row_before_0 - transform_left_code_row_after_0) < 0)) * 8192;
      other_19 <= as_number((((other_20 / 2) - transform_left_code_row_centre_0) < 0)) * 8192;
      other_20 <= ((transform_left_code_row_box_0_0 + transform_left_code_row_column_0_3) / 2) * 2;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 244;
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
        raster_place_group <= 244;
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
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_output_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
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
        slice0window_centre_start_of_frame_3 <= false;
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
        slice1window_centre_output_column_1 <= false;
        slice1window_centre_output_column_2 <= false;
        slice1window_centre_start_of_frame_0 <= false;
        slice1window_centre_start_of_frame_1 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1window_centre_end_of_line_1 <= false;
        slice1window_centre_end_of_line_2 <= false;
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
        other_1 <= 0;
        other_2 <= 0;
      end if;
    end if;
  end process;
end architecture;
