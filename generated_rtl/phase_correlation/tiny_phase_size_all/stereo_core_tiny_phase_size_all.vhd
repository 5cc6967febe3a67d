-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, phase correlation, configuration tiny_phase_size_all: 40x26, 12 disparities, window 4x4, phase of 2 scales, 1 pixel pair a clock.
-- Options: disparities 12, window_px 4, min_disparity 2, reference left, left_right_threshold 1,
--   uniqueness_percent 10, subpixel true, median true, full_width true, aggregation recursive,
--   slice_disparities 6, run_time_settings true, run_time_size true.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_phase_size_all
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_phase_size_all is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 40;
    height_px : positive := 26;
    disparities : positive := 12;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 16;
    output_width_px : positive := 37;
    latency_clocks : positive := 57;
    flush_groups : positive := 257;
    gap_groups : positive := 160
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    uniqueness_percent : in std_logic_vector(7 downto 0);  -- 0 ... 100, taken over with start_of_frame
    left_right_threshold : in std_logic_vector(7 downto 0);  -- 0 ... 11, taken over with start_of_frame
    first_disparity : in std_logic_vector(7 downto 0);  -- 0 ... 11, taken over with start_of_frame
    last_disparity : in std_logic_vector(7 downto 0);  -- 0 ... 11, taken over with start_of_frame
    image_width : in std_logic_vector(15 downto 0);  -- 17 ... 40, changes in a reset only
    image_height : in std_logic_vector(15 downto 0);  -- 11 ... 26, changes in a reset only
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 40 report "stereo_core_tiny_phase_size_all: width_px is " & integer'image(width_px) & " but this core has 40" severity failure;
  assert height_px = 26 report "stereo_core_tiny_phase_size_all: height_px is " & integer'image(height_px) & " but this core has 26" severity failure;
  assert disparities = 12 report "stereo_core_tiny_phase_size_all: disparities is " & integer'image(disparities) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_phase_size_all: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 16 report "stereo_core_tiny_phase_size_all: disparity_bits is " & integer'image(disparity_bits) & " but this core has 16" severity failure;
  assert output_width_px = 37 report "stereo_core_tiny_phase_size_all: output_width_px is " & integer'image(output_width_px) & " but this core has 37" severity failure;
  assert latency_clocks = 57 report "stereo_core_tiny_phase_size_all: latency_clocks is " & integer'image(latency_clocks) & " but this core has 57" severity failure;
  assert flush_groups = 257 report "stereo_core_tiny_phase_size_all: flush_groups is " & integer'image(flush_groups) & " but this core has 257" severity failure;
  assert gap_groups = 160 report "stereo_core_tiny_phase_size_all: gap_groups is " & integer'image(gap_groups) & " but this core has 160" severity failure;
end entity;

architecture rtl of stereo_core_tiny_phase_size_all is
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
  signal in_image_height : natural range 0 to 65535;
  signal in_image_width : natural range 0 to 65535;
  signal in_last_disparity : natural range 0 to 255;
  signal in_first_disparity : natural range 0 to 255;
  signal in_left_right_threshold : natural range 0 to 255;
  signal in_uniqueness_percent : natural range 0 to 255;
  -- settings
  signal settings_uniqueness_percent, settings_left_right_threshold, settings_first_disparity : natural range 0 to 255;
  signal settings_last_disparity : natural range 0 to 255;
  -- size
  signal size_windows_last_column, size_map_last_column, size_map_columns_to : natural range 0 to 63;
  signal size_windows_last_group, size_windows_groups, size_windows_idle : natural range 0 to 31;
  signal size_transform_last_counted, size_transform_idle : natural range 0 to 31;
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
  signal transform_write_column, transform_columns_up_value, transform_centre_column : natural range 0 to 63;
  signal transform_left_code_row_signs, transform_left_code_earlier_0 : natural range 0 to 63;
  signal transform_left_code_earlier_1, transform_left_code_earlier_2, transform_left_code_bits : natural range 0 to 63;
  signal transform_left_code_next_row_signs, transform_left_code_next_bits : natural range 0 to 63;
  signal transform_right_code_row_signs, transform_right_code_earlier_0 : natural range 0 to 63;
  signal transform_right_code_earlier_1, transform_right_code_earlier_2 : natural range 0 to 63;
  signal transform_right_code_bits, transform_right_code_next_row_signs : natural range 0 to 63;
  signal transform_right_code_next_bits : natural range 0 to 63;
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
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 63;
  signal raster_place_group : natural range 0 to 31;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 3;
  signal delay_ahead_0 : natural range 0 to 4095;
  signal delay_delayed_0 : unsigned(11 downto 0);
  signal delay_column : natural range 0 to 63;
  signal delay_row_inside_0, delay_row_inside_1, delay_tag_valid, delay_tag_row_start, delay_tag_first_group : boolean;
  signal delay_tag_leaves_window, delay_tag_map_column, delay_tag_output_column, delay_tag_first_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line, delay_split_search_inside_0 : boolean;
  signal delay_split_search_inside_1, delay_split_inside_before_0, delay_split_inside_before_1 : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_reference_rows_read_words_0, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 4095;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 4095;
  signal rows_search_1, rows_reference_0, rows_reference_1 : natural range 0 to 4095;
  signal rows_search_rows_ready_words_0, rows_search_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_search_rows_write_words_0, rows_search_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_ready_words_1 : natural range 0 to 16777215;
  signal rows_reference_rows_write_words_0, rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 63;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_tag_valid, rows_read_tag_row_start : boolean;
  signal rows_read_tag_first_group, rows_read_tag_leaves_window, rows_read_tag_map_column : boolean;
  signal rows_read_tag_output_column, rows_read_tag_first_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_read_search_inside_0, rows_read_search_inside_1, rows_ready_inside_0 : boolean;
  signal rows_ready_inside_1, rows_ready_tag_valid, rows_ready_tag_row_start, rows_ready_tag_first_group : boolean;
  signal rows_ready_tag_leaves_window, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_ready_search_inside_0, rows_ready_search_inside_1, rows_tag_valid, rows_tag_row_start : boolean;
  signal rows_tag_first_group, rows_tag_leaves_window, rows_tag_map_column, rows_tag_output_column : boolean;
  signal rows_tag_first_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 4095;
  signal slice0shift_search_0_3, slice0shift_search_0_4, slice0shift_search_0_5 : natural range 0 to 4095;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 4095;
  signal slice0shift_search_1_3, slice0shift_search_1_4, slice0shift_search_1_5 : natural range 0 to 4095;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_search_out_0 : natural range 0 to 4095;
  signal slice0shift_search_out_1 : natural range 0 to 4095;
  signal slice0shift_tag_valid, slice0shift_tag_row_start, slice0shift_tag_first_group : boolean;
  signal slice0shift_tag_leaves_window, slice0shift_tag_map_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_first_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_0, slice0cost_pixels_first_0_1, slice0cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_0_3, slice0cost_pixels_first_0_4, slice0cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_0, slice0cost_pixels_first_1_1, slice0cost_pixels_first_1_2 : natural range 0 to 255;
  signal slice0cost_pixels_first_1_3, slice0cost_pixels_first_1_4, slice0cost_pixels_first_1_5 : natural range 0 to 255;
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_row_start : boolean;
  signal slice0cost_pixels_first_tag_first_group, slice0cost_pixels_first_tag_leaves_window : boolean;
  signal slice0cost_pixels_first_tag_map_column, slice0cost_pixels_first_tag_output_column : boolean;
  signal slice0cost_pixels_first_tag_first_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_row_start, slice0cost_pixels_tag_first_group : boolean;
  signal slice0cost_pixels_tag_leaves_window, slice0cost_pixels_tag_map_column : boolean;
  signal slice0cost_pixels_tag_output_column, slice0cost_pixels_tag_first_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_ready_tag_valid : boolean;
  signal slice0cost_ready_tag_row_start, slice0cost_ready_tag_first_group, slice0cost_ready_tag_leaves_window : boolean;
  signal slice0cost_ready_tag_map_column, slice0cost_ready_tag_output_column : boolean;
  signal slice0cost_ready_tag_first_column, slice0cost_ready_tag_start_of_frame : boolean;
  signal slice0cost_ready_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_row_start : boolean;
  signal slice0cost_tag_first_group, slice0cost_tag_leaves_window, slice0cost_tag_map_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_first_column, slice0cost_tag_start_of_frame : boolean;
  signal slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0_0, slice0cost_pixels_cost_0_1, slice0cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_0_3, slice0cost_pixels_cost_0_4, slice0cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_0, slice0cost_pixels_cost_1_1, slice0cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice0cost_pixels_cost_1_3, slice0cost_pixels_cost_1_4, slice0cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column : natural range 0 to 63;
  signal slice0cost_write_column : natural range 0 to 63;
  signal slice0cost_read_words_0 : unsigned(27 downto 0);
  signal slice0cost_read_words_1 : unsigned(13 downto 0);
  signal slice0cost_change_0_0, slice0cost_change_0_1, slice0cost_change_0_2 : integer range -19 to 19;
  signal slice0cost_change_0_3, slice0cost_change_0_4, slice0cost_change_0_5 : integer range -19 to 19;
  signal slice0cost_ready_words_0, slice0cost_write_words_0 : natural range 0 to 268435455;
  signal slice0cost_ready_words_1, slice0cost_write_words_1 : natural range 0 to 16383;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 127;
  signal slice0cost_column_0_3, slice0cost_column_0_4, slice0cost_column_0_5 : natural range 0 to 127;
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving_0 : unsigned(27 downto 0);
  signal slice0window_leaving_1 : unsigned(13 downto 0);
  signal slice0window_entering_0_0, slice0window_entering_0_1, slice0window_entering_0_2 : natural range 0 to 127;
  signal slice0window_entering_0_3, slice0window_entering_0_4, slice0window_entering_0_5 : natural range 0 to 127;
  signal slice0window_entering_tag_valid, slice0window_entering_tag_row_start : boolean;
  signal slice0window_entering_tag_leaves_window, slice0window_entering_tag_map_column : boolean;
  signal slice0window_entering_tag_output_column, slice0window_entering_tag_first_column : boolean;
  signal slice0window_entering_tag_start_of_frame, slice0window_entering_tag_end_of_line : boolean;
  signal slice0window_change_tag_valid, slice0window_change_tag_row_start : boolean;
  signal slice0window_change_tag_leaves_window, slice0window_change_tag_map_column : boolean;
  signal slice0window_change_tag_output_column, slice0window_change_tag_first_column : boolean;
  signal slice0window_change_tag_start_of_frame, slice0window_change_tag_end_of_line : boolean;
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_output_column_1, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_first_column_1, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_start_of_frame_1, slice0window_centre_end_of_line_0, slice0window_tag_valid : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_first_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_change_0_0, slice0window_change_0_1, slice0window_change_0_2 : integer range -127 to 127;
  signal slice0window_change_0_3, slice0window_change_0_4, slice0window_change_0_5 : integer range -127 to 127;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 511;
  signal slice0window_sum_0_3, slice0window_sum_0_4, slice0window_sum_0_5 : natural range 0 to 511;
  -- slice0mask
  signal slice0mask_inside_0, slice0mask_inside_1, slice0mask_inside_2, slice0mask_inside_3 : boolean;
  signal slice0mask_inside_4, slice0mask_inside_5, slice0mask_left_out : boolean;
  signal slice0mask_column, slice0mask_end_value : natural range 0 to 63;
  -- slice0other
  signal slice0other_cost_0_0, slice0other_cost_0_1, slice0other_cost_0_2 : natural range 0 to 511;
  signal slice0other_cost_0_3, slice0other_cost_0_4, slice0other_cost_0_5 : natural range 0 to 511;
  signal slice0other_cost_out_0 : natural range 0 to 511;
  signal slice0other_winner_0_1 : boolean;
  signal slice0other_winner_0_2 : natural range 0 to 2;
  signal slice0other_winner_0_3 : natural range 0 to 3;
  signal slice0other_winner_0_4 : natural range 0 to 4;
  signal slice0other_winner_0_5, slice0other_winner_out_0 : natural range 0 to 5;
  -- slice0winner1
  signal slice0winner1_held_0_0, slice0winner1_held_0_1, slice0winner1_held_0_2 : natural range 0 to 511;
  signal slice0winner1_held_0_3, slice0winner1_held_0_4, slice0winner1_held_0_5 : natural range 0 to 511;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_cost_0_1, slice0winner1_best_cost_0_2 : natural range 0 to 511;
  signal slice0winner1_best_below_0_0, slice0winner1_best_below_0_1 : natural range 0 to 511;
  signal slice0winner1_best_below_0_2, slice0winner1_best_above_0_0 : natural range 0 to 511;
  signal slice0winner1_best_above_0_1, slice0winner1_best_above_0_2 : natural range 0 to 511;
  signal slice0winner1_best_late_cost_0_0, slice0winner1_best_late_cost_0_1 : natural range 0 to 511;
  signal slice0winner1_best_late_cost_0_2, slice0winner1_best_but_first_0_1 : natural range 0 to 511;
  signal slice0winner1_best_but_first_0_2, slice0winner1_best_but_last_0_0 : natural range 0 to 511;
  signal slice0winner1_best_but_last_0_1, slice0winner1_best_but_last_0_2 : natural range 0 to 511;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_map_column : boolean;
  signal slice0winner1_tag_output_column, slice0winner1_tag_first_column, slice0winner1_tag_start_of_frame : boolean;
  signal slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 3;
  signal slice0winner1_best_index_0_2 : natural range 0 to 5;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_below_0_0 : natural range 0 to 511;
  signal slice0winner2_best_below_0_1, slice0winner2_best_above_0_0 : natural range 0 to 511;
  signal slice0winner2_best_above_0_1, slice0winner2_best_first_0_1 : natural range 0 to 511;
  signal slice0winner2_best_last_0_0, slice0winner2_best_last_0_1 : natural range 0 to 511;
  signal slice0winner2_best_late_cost_0_0, slice0winner2_best_late_cost_0_1 : natural range 0 to 511;
  signal slice0winner2_best_second_0_0, slice0winner2_best_but_first_0_1 : natural range 0 to 511;
  signal slice0winner2_best_but_last_0_0, slice0winner2_best_but_last_0_1 : natural range 0 to 511;
  signal slice0winner2_best_index_0_0 : natural range 0 to 3;
  signal slice0winner2_best_index_0_1 : natural range 0 to 5;
  signal slice0winner2_best_place_0_0, slice0winner2_best_at_start_0_0, slice0winner2_best_at_end_0_0 : boolean;
  signal slice0winner2_tag_valid, slice0winner2_tag_map_column, slice0winner2_tag_output_column : boolean;
  signal slice0winner2_tag_start_of_frame, slice0winner2_tag_end_of_line : boolean;
  -- slice0winner3
  signal slice0winner3_best_cost_0_0, slice0winner3_best_below_0_0 : natural range 0 to 511;
  signal slice0winner3_best_above_0_0, slice0winner3_best_last_0_0 : natural range 0 to 511;
  signal slice0winner3_best_late_cost_0_0, slice0winner3_best_second_0_0 : natural range 0 to 511;
  signal slice0winner3_best_but_last_0_0 : natural range 0 to 511;
  signal slice0winner3_best_index_0_0 : natural range 0 to 5;
  signal slice0winner3_best_place_0_0, slice0winner3_best_at_start_0_0, slice0winner3_best_at_end_0_0 : boolean;
  signal slice0winner3_tag_valid, slice0winner3_tag_map_column, slice0winner3_tag_output_column : boolean;
  signal slice0winner3_tag_start_of_frame, slice0winner3_tag_end_of_line : boolean;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 5;
  signal slice0_best_below_0_0, slice0_best_above_0_0, slice0_best_last_0_0 : natural range 0 to 511;
  signal slice0_best_late_cost_0_0, slice0_best_second_0_0, slice0_best_but_last_0_0 : natural range 0 to 511;
  signal slice0_best_tag_valid, slice0_best_tag_map_column, slice0_best_tag_output_column : boolean;
  signal slice0_best_tag_start_of_frame, slice0_best_tag_end_of_line : boolean;
  -- slice1shift
  signal slice1shift_search_0_0, slice1shift_search_0_1, slice1shift_search_0_2 : natural range 0 to 4095;
  signal slice1shift_search_0_3, slice1shift_search_0_4, slice1shift_search_0_5 : natural range 0 to 4095;
  signal slice1shift_search_1_0, slice1shift_search_1_1, slice1shift_search_1_2 : natural range 0 to 4095;
  signal slice1shift_search_1_3, slice1shift_search_1_4, slice1shift_search_1_5 : natural range 0 to 4095;
  signal slice1shift_reference_0, slice1shift_reference_1 : natural range 0 to 4095;
  -- slice1cost
  signal slice1cost_pixels_first_0_0, slice1cost_pixels_first_0_1, slice1cost_pixels_first_0_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_0_3, slice1cost_pixels_first_0_4, slice1cost_pixels_first_0_5 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_0, slice1cost_pixels_first_1_1, slice1cost_pixels_first_1_2 : natural range 0 to 255;
  signal slice1cost_pixels_first_1_3, slice1cost_pixels_first_1_4, slice1cost_pixels_first_1_5 : natural range 0 to 255;
  signal slice1cost_pixels_cost_0_0, slice1cost_pixels_cost_0_1, slice1cost_pixels_cost_0_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_0_3, slice1cost_pixels_cost_0_4, slice1cost_pixels_cost_0_5 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_0, slice1cost_pixels_cost_1_1, slice1cost_pixels_cost_1_2 : natural range 0 to 19;
  signal slice1cost_pixels_cost_1_3, slice1cost_pixels_cost_1_4, slice1cost_pixels_cost_1_5 : natural range 0 to 19;
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column : natural range 0 to 63;
  signal slice1cost_write_column : natural range 0 to 63;
  signal slice1cost_read_words_0 : unsigned(27 downto 0);
  signal slice1cost_read_words_1 : unsigned(13 downto 0);
  signal slice1cost_change_0_0, slice1cost_change_0_1, slice1cost_change_0_2 : integer range -19 to 19;
  signal slice1cost_change_0_3, slice1cost_change_0_4, slice1cost_change_0_5 : integer range -19 to 19;
  signal slice1cost_ready_words_0, slice1cost_write_words_0 : natural range 0 to 268435455;
  signal slice1cost_ready_words_1, slice1cost_write_words_1 : natural range 0 to 16383;
  signal slice1cost_column_0_0, slice1cost_column_0_1, slice1cost_column_0_2 : natural range 0 to 127;
  signal slice1cost_column_0_3, slice1cost_column_0_4, slice1cost_column_0_5 : natural range 0 to 127;
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving_0 : unsigned(27 downto 0);
  signal slice1window_leaving_1 : unsigned(13 downto 0);
  signal slice1window_entering_0_0, slice1window_entering_0_1, slice1window_entering_0_2 : natural range 0 to 127;
  signal slice1window_entering_0_3, slice1window_entering_0_4, slice1window_entering_0_5 : natural range 0 to 127;
  signal slice1window_entering_tag_border_column, slice1window_sum_0_0, slice1window_sum_0_1 : natural range 0 to 511;
  signal slice1window_sum_0_2, slice1window_sum_0_3, slice1window_sum_0_4 : natural range 0 to 511;
  signal slice1window_sum_0_5 : natural range 0 to 511;
  signal slice1window_change_0_0, slice1window_change_0_1, slice1window_change_0_2 : integer range -127 to 127;
  signal slice1window_change_0_3, slice1window_change_0_4, slice1window_change_0_5 : integer range -127 to 127;
  signal slice1window_change_tag_row_start, slice1window_change_tag_output_column : boolean;
  signal slice1window_change_tag_first_column, slice1window_change_tag_start_of_frame : boolean;
  signal slice1window_centre_map_column_0, slice1window_centre_output_column_0 : boolean;
  signal slice1window_centre_output_column_1, slice1window_centre_first_column_0 : boolean;
  signal slice1window_centre_first_column_1, slice1window_centre_start_of_frame_0 : boolean;
  signal slice1window_centre_end_of_line_0 : boolean;
  -- slice1mask
  signal slice1mask_inside_0, slice1mask_inside_1, slice1mask_inside_2, slice1mask_inside_3 : boolean;
  signal slice1mask_inside_4, slice1mask_inside_5, slice1mask_searched_5 : boolean;
  -- slice1other
  signal slice1other_cost_0_0, slice1other_cost_0_1, slice1other_cost_0_2 : natural range 0 to 511;
  signal slice1other_cost_0_3, slice1other_cost_0_4 : natural range 0 to 511;
  signal slice1other_winner_0_0 : natural range 0 to 6;
  signal slice1other_winner_0_1 : natural range 0 to 7;
  signal slice1other_winner_0_2 : natural range 0 to 8;
  signal slice1other_winner_0_3 : natural range 0 to 9;
  signal slice1other_winner_0_4 : natural range 0 to 10;
  signal slice1other_winner_0_5, slice1other_winner_out_0 : natural range 0 to 11;
  -- slice1winner1
  signal slice1winner1_held_0_0, slice1winner1_held_0_1, slice1winner1_held_0_2 : natural range 0 to 511;
  signal slice1winner1_held_0_3, slice1winner1_held_0_4, slice1winner1_held_0_5 : natural range 0 to 511;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_cost_0_1, slice1winner1_best_cost_0_2 : natural range 0 to 511;
  signal slice1winner1_best_below_0_0, slice1winner1_best_below_0_1 : natural range 0 to 511;
  signal slice1winner1_best_above_0_0, slice1winner1_best_above_0_1 : natural range 0 to 511;
  signal slice1winner1_best_above_0_2, slice1winner1_best_late_cost_0_0 : natural range 0 to 511;
  signal slice1winner1_best_late_cost_0_1, slice1winner1_best_late_cost_0_2 : natural range 0 to 511;
  signal slice1winner1_best_but_first_0_0, slice1winner1_best_but_first_0_1 : natural range 0 to 511;
  signal slice1winner1_best_but_first_0_2, slice1winner1_best_but_last_0_0 : natural range 0 to 511;
  signal slice1winner1_best_but_last_0_1 : natural range 0 to 511;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0_1 : natural range 0 to 3;
  signal slice1winner1_best_index_0_2 : natural range 0 to 5;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_cost_0_1 : natural range 0 to 511;
  signal slice1winner2_best_below_0_0, slice1winner2_best_above_0_0 : natural range 0 to 511;
  signal slice1winner2_best_above_0_1, slice1winner2_best_first_0_0 : natural range 0 to 511;
  signal slice1winner2_best_last_0_0, slice1winner2_best_late_cost_0_0 : natural range 0 to 511;
  signal slice1winner2_best_late_cost_0_1, slice1winner2_best_second_0_0 : natural range 0 to 511;
  signal slice1winner2_best_but_first_0_0, slice1winner2_best_but_first_0_1 : natural range 0 to 511;
  signal slice1winner2_best_but_last_0_0 : natural range 0 to 511;
  signal slice1winner2_best_index_0_0 : natural range 0 to 3;
  signal slice1winner2_best_index_0_1 : natural range 0 to 5;
  signal slice1winner2_best_place_0_0, slice1winner2_best_at_start_0_0, slice1winner2_best_at_end_0_0 : boolean;
  -- slice1winner3
  signal slice1winner3_best_cost_0_0, slice1winner3_best_below_0_0 : natural range 0 to 511;
  signal slice1winner3_best_above_0_0, slice1winner3_best_first_0_0 : natural range 0 to 511;
  signal slice1winner3_best_late_cost_0_0, slice1winner3_best_second_0_0 : natural range 0 to 511;
  signal slice1winner3_best_but_first_0_0, slice1winner3_tag_row_start : natural range 0 to 511;
  signal slice1winner3_best_index_0_0 : natural range 0 to 5;
  signal slice1winner3_best_place_0_0, slice1winner3_best_at_start_0_0, slice1winner3_best_at_end_0_0 : boolean;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_below_0_0, slice1_best_above_0_0 : natural range 0 to 511;
  signal slice1_best_late_cost_0_0, slice1_best_second_0_0 : natural range 0 to 511;
  signal slice1_best_index_0_0 : natural range 0 to 11;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0, slice1_best_tag_valid : boolean;
  signal slice1_best_tag_map_column, slice1_best_tag_output_column, slice1_best_tag_start_of_frame : boolean;
  signal slice1_best_tag_end_of_line : boolean;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 11;
  signal refinement_disparity_3_0, refinement_disparity_4_0, refinement_disparity_5_0 : natural range 0 to 11;
  signal refinement_disparity_6_0, refinement_disparity_7_0, refinement_disparity_8_0 : natural range 0 to 11;
  signal refinement_disparity_9_0, refinement_disparity_10_0, refinement_disparity_11_0 : natural range 0 to 11;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_passed_4_0, refinement_passed_5_0, refinement_passed_6_0, refinement_passed_7_0 : boolean;
  signal refinement_passed_8_0, refinement_passed_9_0, refinement_passed_10_0, refinement_passed_11_0 : boolean;
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
  signal refinement_tag_9_start_of_frame, refinement_tag_9_end_of_line, refinement_tag_10_valid : boolean;
  signal refinement_tag_10_map_column, refinement_tag_10_output_column, refinement_tag_10_start_of_frame : boolean;
  signal refinement_tag_10_end_of_line, refinement_tag_11_valid, refinement_tag_11_map_column : boolean;
  signal refinement_tag_11_output_column, refinement_tag_11_start_of_frame, refinement_tag_11_end_of_line : boolean;
  signal refinement_alone_0_0, refinement_alone_1_0, refinement_negative_0_0, refinement_negative_1_0 : boolean;
  signal refinement_negative_2_0, refinement_negative_3_0, refinement_negative_4_0, refinement_negative_5_0 : boolean;
  signal refinement_negative_6_0, refinement_negative_7_0, refinement_negative_8_0 : boolean;
  signal refinement_gap_0, refinement_lowest_0, refinement_below_0, refinement_above_0 : natural range 0 to 511;
  signal refinement_u_0, refinement_v_0, refinement_remainder_0_0, refinement_remainder_1_0 : natural range 0 to 511;
  signal refinement_remainder_2_0, refinement_remainder_3_0, refinement_remainder_4_0 : natural range 0 to 511;
  signal refinement_remainder_5_0, refinement_remainder_6_0, refinement_remainder_7_0 : natural range 0 to 511;
  signal refinement_divisor_0_0, refinement_divisor_1_0, refinement_divisor_2_0 : natural range 0 to 511;
  signal refinement_divisor_3_0, refinement_divisor_4_0, refinement_divisor_5_0 : natural range 0 to 511;
  signal refinement_divisor_6_0, refinement_divisor_7_0 : natural range 0 to 511;
  signal refinement_scaled_gap_0 : natural range 0 to 51100;
  signal refinement_scaled_cost_0 : natural range 0 to 130305;
  signal refinement_percent, refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_difference_0 : integer range -511 to 511;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_1_0, leftright_other_2_0, leftright_other_3_0, leftright_other_4_0 : natural range 0 to 11;
  signal leftright_other_5_0, leftright_other_6_0, leftright_other_7_0, leftright_other_8_0 : natural range 0 to 11;
  signal leftright_other_9_0, leftright_other_10_0, leftright_other_11_0, leftright_other_12_0 : natural range 0 to 11;
  signal leftright_other_13_0, leftright_other_14_0 : natural range 0 to 11;
  signal leftright_ring_read_address, leftright_ring_write_address, leftright_position : natural range 0 to 15;
  signal leftright_held_position, leftright_address_0, leftright_asking_disparity_0 : natural range 0 to 15;
  signal leftright_answered_disparity_0, leftright_checked_disparity_0 : natural range 0 to 15;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_output_column : boolean;
  signal leftright_asking_tag_start_of_frame, leftright_asking_tag_end_of_line, leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_map_column : boolean;
  signal leftright_answered_tag_start_of_frame, leftright_answered_tag_end_of_line : boolean;
  signal leftright_checked_passed_0, leftright_checked_tag_valid, leftright_checked_tag_row_start : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_start_of_frame : boolean;
  signal leftright_checked_tag_end_of_line : boolean;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  signal leftright_found_0 : unsigned(3 downto 0);
  signal leftright_threshold : natural range 0 to 255;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 63;
  signal map_sorted_column : natural range 0 to 63;
  signal map_counter_group : natural range 0 to 31;
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
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0, map_column_2 : natural range 0 to 65535;
  signal map_rows_read_words_0 : unsigned(25 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 67108863;
  signal map_rows_write_words_0 : natural range 0 to 536870911;
  signal map_column_1 : natural range 0 to 8191;
  signal map_of_column_0_a, map_of_column_0_b : natural range 0 to 4095;
  signal map_of_column_0_c, map_sorted_low_0, map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 32767;
  signal map_low_0_0, map_low_1_0, map_low_2_0, map_middle_0_0, map_middle_1_0 : natural range 0 to 32767;
  signal map_middle_2_0, map_high_0_0, map_high_1_0, map_high_2_0, map_of_low_0_a : natural range 0 to 32767;
  signal map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 32767;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 32767;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 32767;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 32767;
  -- other
  signal other_0, other_1, other_29, other_30 : natural range 0 to 8192;
  signal other_2, other_31 : natural range 0 to 2042;
  signal other_3, other_4 : natural range 0 to 257;
  signal other_5, other_6 : natural range 0 to 65535;
  signal other_7 : natural range 0 to 8190;
  signal other_8, other_9 : unsigned(48 downto 0);
  signal other_10 : natural range 0 to 254;
  signal other_11 : natural range 0 to 252;
  signal other_12 : natural range 0 to 248;
  signal other_13 : natural range 0 to 240;
  signal other_14 : natural range 0 to 224;
  signal other_15 : natural range 0 to 192;
  signal other_16 : natural range 0 to 128;
  signal other_17, other_18, other_19, other_20, other_21, other_22, other_23, other_24, other_25, other_26 : boolean;
  signal other_27 : boolean;
  signal other_28, other_32 : natural range 0 to 65534;
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal map_rows_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(3 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_address : unsigned(3 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);
  signal slice1window_leaving_1_memory_read_enable : boolean;
  signal slice1window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_1_memory_write_data : unsigned(13 downto 0);
  signal slice1window_leaving_0_memory_read_enable : boolean;
  signal slice1window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice1window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice1window_leaving_0_memory_write_data : unsigned(27 downto 0);
  signal slice1cost_read_words_1_memory_read_enable : boolean;
  signal slice1cost_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal slice1cost_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal slice1cost_read_words_1_memory_write_data : unsigned(13 downto 0);
  signal slice1cost_read_words_0_memory_read_enable : boolean;
  signal slice1cost_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal slice1cost_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal slice1cost_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal slice0window_leaving_1_memory_read_enable : boolean;
  signal slice0window_leaving_1_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_1_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_1_memory_write_data : unsigned(13 downto 0);
  signal slice0window_leaving_0_memory_read_enable : boolean;
  signal slice0window_leaving_0_memory_read_address : unsigned(2 downto 0);
  signal slice0window_leaving_0_memory_write_address : unsigned(2 downto 0);
  signal slice0window_leaving_0_memory_write_data : unsigned(27 downto 0);
  signal slice0cost_read_words_1_memory_read_enable : boolean;
  signal slice0cost_read_words_1_memory_read_address : unsigned(5 downto 0);
  signal slice0cost_read_words_1_memory_write_address : unsigned(5 downto 0);
  signal slice0cost_read_words_1_memory_write_data : unsigned(13 downto 0);
  signal slice0cost_read_words_0_memory_read_enable : boolean;
  signal slice0cost_read_words_0_memory_read_address : unsigned(5 downto 0);
  signal slice0cost_read_words_0_memory_write_address : unsigned(5 downto 0);
  signal slice0cost_read_words_0_memory_write_data : unsigned(27 downto 0);
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
  signal delay_delayed_0_memory_read_address : unsigned(1 downto 0);
  signal delay_delayed_0_memory_write_address : unsigned(1 downto 0);
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
  in_image_height <= to_integer(unsigned(to_stdlogicvector(to_bitvector(image_height))));
  in_image_width <= to_integer(unsigned(to_stdlogicvector(to_bitvector(image_width))));
  in_last_disparity <= to_integer(unsigned(to_stdlogicvector(to_bitvector(last_disparity))));
  in_first_disparity <= to_integer(unsigned(to_stdlogicvector(to_bitvector(first_disparity))));
  in_left_right_threshold <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_right_threshold))));
  in_uniqueness_percent <= to_integer(unsigned(to_stdlogicvector(to_bitvector(uniqueness_percent))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 16));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 6);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 6);
  map_rows_read_words_0_memory_write_data <= to_unsigned((map_rows_write_words_0 mod 67108864), 26);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 37, width => 26, address_bits => 6)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 4);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 4);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_14_0, 4);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 16, width => 4, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 4);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 4);
  leftright_held_0_memory_write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned(as_number(refinement_passed_11_0), 1) & to_unsigned(refinement_disparity_11_0, 8) & to_unsigned(as_number(refinement_tag_11_end_of_line), 1) & to_unsigned(as_number(refinement_tag_11_start_of_frame), 1) & to_unsigned(as_number(refinement_tag_11_output_column), 1) & to_unsigned(as_number(refinement_tag_11_map_column), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 12, width => 18, address_bits => 4)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

  slice1window_leaving_1_memory_read_enable <= true;
  slice1window_leaving_1_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_1_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_1_memory_write_data <= to_unsigned(slice1cost_column_0_5, 7) & to_unsigned(slice1cost_column_0_4, 7);
  slice1window_leaving_1_memory : entity work.line_memory
    generic map (depth => 5, width => 14, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_1_memory_read_enable,
      read_address => slice1window_leaving_1_memory_read_address, read_data => slice1window_leaving_1,
      write_address => slice1window_leaving_1_memory_write_address, write_data => slice1window_leaving_1_memory_write_data);

  slice1window_leaving_0_memory_read_enable <= true;
  slice1window_leaving_0_memory_read_address <= to_unsigned(slice1window_ring_read_address, 3);
  slice1window_leaving_0_memory_write_address <= to_unsigned(slice1window_ring_write_address, 3);
  slice1window_leaving_0_memory_write_data <= to_unsigned(slice1cost_column_0_3, 7) & to_unsigned(slice1cost_column_0_2, 7) & to_unsigned(slice1cost_column_0_1, 7) & to_unsigned(slice1cost_column_0_0, 7);
  slice1window_leaving_0_memory : entity work.line_memory
    generic map (depth => 5, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => slice1window_leaving_0_memory_read_enable,
      read_address => slice1window_leaving_0_memory_read_address, read_data => slice1window_leaving_0,
      write_address => slice1window_leaving_0_memory_write_address, write_data => slice1window_leaving_0_memory_write_data);

  slice1cost_read_words_1_memory_read_enable <= true;
  slice1cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_change_column, 6);
  slice1cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_write_column, 6);
  slice1cost_read_words_1_memory_write_data <= to_unsigned(slice1cost_write_words_1, 14);
  slice1cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 14, address_bits => 6)
    port map (
      clock => clock, read_enable => slice1cost_read_words_1_memory_read_enable,
      read_address => slice1cost_read_words_1_memory_read_address, read_data => slice1cost_read_words_1,
      write_address => slice1cost_read_words_1_memory_write_address, write_data => slice1cost_read_words_1_memory_write_data);

  slice1cost_read_words_0_memory_read_enable <= true;
  slice1cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_change_column, 6);
  slice1cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_write_column, 6);
  slice1cost_read_words_0_memory_write_data <= to_unsigned(slice1cost_write_words_0, 28);
  slice1cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => slice1cost_read_words_0_memory_read_enable,
      read_address => slice1cost_read_words_0_memory_read_address, read_data => slice1cost_read_words_0,
      write_address => slice1cost_read_words_0_memory_write_address, write_data => slice1cost_read_words_0_memory_write_data);

  slice0window_leaving_1_memory_read_enable <= true;
  slice0window_leaving_1_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_1_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_1_memory_write_data <= to_unsigned(slice0cost_column_0_5, 7) & to_unsigned(slice0cost_column_0_4, 7);
  slice0window_leaving_1_memory : entity work.line_memory
    generic map (depth => 5, width => 14, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_1_memory_read_enable,
      read_address => slice0window_leaving_1_memory_read_address, read_data => slice0window_leaving_1,
      write_address => slice0window_leaving_1_memory_write_address, write_data => slice0window_leaving_1_memory_write_data);

  slice0window_leaving_0_memory_read_enable <= true;
  slice0window_leaving_0_memory_read_address <= to_unsigned(slice0window_ring_read_address, 3);
  slice0window_leaving_0_memory_write_address <= to_unsigned(slice0window_ring_write_address, 3);
  slice0window_leaving_0_memory_write_data <= to_unsigned(slice0cost_column_0_3, 7) & to_unsigned(slice0cost_column_0_2, 7) & to_unsigned(slice0cost_column_0_1, 7) & to_unsigned(slice0cost_column_0_0, 7);
  slice0window_leaving_0_memory : entity work.line_memory
    generic map (depth => 5, width => 28, address_bits => 3)
    port map (
      clock => clock, read_enable => slice0window_leaving_0_memory_read_enable,
      read_address => slice0window_leaving_0_memory_read_address, read_data => slice0window_leaving_0,
      write_address => slice0window_leaving_0_memory_write_address, write_data => slice0window_leaving_0_memory_write_data);

  slice0cost_read_words_1_memory_read_enable <= true;
  slice0cost_read_words_1_memory_read_address <= to_unsigned(slice0cost_read_column, 6);
  slice0cost_read_words_1_memory_write_address <= to_unsigned(slice1cost_ready_column, 6);
  slice0cost_read_words_1_memory_write_data <= to_unsigned(slice0cost_write_words_1, 14);
  slice0cost_read_words_1_memory : entity work.line_memory
    generic map (depth => 40, width => 14, address_bits => 6)
    port map (
      clock => clock, read_enable => slice0cost_read_words_1_memory_read_enable,
      read_address => slice0cost_read_words_1_memory_read_address, read_data => slice0cost_read_words_1,
      write_address => slice0cost_read_words_1_memory_write_address, write_data => slice0cost_read_words_1_memory_write_data);

  slice0cost_read_words_0_memory_read_enable <= true;
  slice0cost_read_words_0_memory_read_address <= to_unsigned(slice0cost_read_column, 6);
  slice0cost_read_words_0_memory_write_address <= to_unsigned(slice1cost_ready_column, 6);
  slice0cost_read_words_0_memory_write_data <= to_unsigned(slice0cost_write_words_0, 28);
  slice0cost_read_words_0_memory : entity work.line_memory
    generic map (depth => 40, width => 28, address_bits => 6)
    port map (
      clock => clock, read_enable => slice0cost_read_words_0_memory_read_enable,
      read_address => slice0cost_read_words_0_memory_read_address, read_data => slice0cost_read_words_0,
      write_address => slice0cost_read_words_0_memory_write_address, write_data => slice0cost_read_words_0_memory_write_data);

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
  delay_delayed_0_memory_read_address <= to_unsigned(delay_ring_read_address, 2);
  delay_delayed_0_memory_write_address <= to_unsigned(delay_ring_write_address, 2);
  delay_delayed_0_memory_write_data <= to_unsigned(raster_features_search_0, 12);
  delay_delayed_0_memory : entity work.line_memory
    generic map (depth => 3, width => 12, address_bits => 2)
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
    variable settings_uniqueness_percent_any, transform_counter_group_value, transform_counter_group_choice : boolean;
    variable transform_counter_group_choice_2, transform_counter_group_choice_3 : boolean;
    variable transform_counter_group_value_2, transform_counter_group_choice_4 : boolean;
    variable transform_counter_group_choice_5, transform_counter_group_choice_6 : boolean;
    variable transform_counter_group_value_3, transform_counter_group_value_4 : boolean;
    variable transform_counter_group_differs, transform_counter_group_value_5 : boolean;
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_choice_7, transform_counter_group_is_equal_3 : boolean;
    variable transform_counter_group_is_equal_4, transform_counter_group_choice_8 : boolean;
    variable transform_counter_group_choice_9, transform_counter_group_value_6 : boolean;
    variable transform_counter_group_value_7, transform_counter_group_is_equal_5 : boolean;
    variable transform_counter_group_is_equal_6, transform_counter_group_choice_10 : boolean;
    variable transform_counter_group_is_equal_7, transform_counter_group_is_equal_8 : boolean;
    variable transform_counter_group_choice_11, transform_counter_group_choice_12 : boolean;
    variable transform_counter_group_differs_2, transform_counter_group_value_9 : boolean;
    variable transform_counter_group_value_10, transform_counter_group_differs_3, transform_counter_group_all : boolean;
    variable transform_counter_group_choice_14, transform_counter_group_is_equal_9 : boolean;
    variable transform_counter_group_choice_15, transform_counter_group_choice_16 : boolean;
    variable transform_counter_group_choice_17, transform_counter_group_choice_18 : boolean;
    variable transform_counter_group_value_11, transform_counter_group_choice_19 : boolean;
    variable transform_counter_group_choice_20, transform_counter_group_choice_21 : boolean;
    variable transform_counter_group_choice_22, transform_counter_group_choice_23 : boolean;
    variable transform_counter_group_choice_24, transform_counter_group_differs_4 : boolean;
    variable transform_centre_column_any, transform_from_first_1_differs, transform_up_to_last_0_is_equal : boolean;
    variable transform_up_to_last_0_value, transform_up_to_last_0_choice, transform_up_to_last_0_choice_2 : boolean;
    variable transform_up_to_last_0_value_2, transform_up_to_last_0_choice_3, transform_up_to_last_0_choice_4 : boolean;
    variable transform_up_to_last_0_value_3, transform_up_to_last_0_choice_5, transform_up_to_last_0_choice_6 : boolean;
    variable transform_up_to_last_1_choice, transform_up_to_last_1_choice_2, transform_up_to_last_1_choice_3 : boolean;
    variable transform_up_to_last_1_choice_4, transform_up_to_last_1_choice_5 : boolean;
    variable transform_up_to_last_1_choice_6, transform_counter_next_frame_choice, raster_place_group_value : boolean;
    variable raster_place_group_value_2, raster_place_group_choice, raster_place_group_choice_2 : boolean;
    variable raster_place_group_value_3, raster_place_group_value_4, raster_place_group_choice_3 : boolean;
    variable raster_place_group_value_5, raster_place_group_value_6, raster_place_group_choice_4 : boolean;
    variable raster_place_group_choice_5, raster_place_group_value_7, raster_place_group_choice_6 : boolean;
    variable raster_place_group_choice_7, raster_place_group_choice_8, raster_place_group_value_8 : boolean;
    variable raster_place_group_value_9, raster_place_group_choice_9, raster_place_group_choice_10 : boolean;
    variable raster_place_group_choice_11, raster_place_group_differs, raster_place_group_value_10 : boolean;
    variable raster_place_group_differs_2, delay_row_inside_0_is_less, delay_row_inside_0_any : boolean;
    variable delay_row_inside_0_all, delay_row_inside_1_is_less, delay_tag_row_start_is_equal : boolean;
    variable delay_tag_leaves_window_choice, delay_tag_leaves_window_choice_2 : boolean;
    variable delay_tag_leaves_window_choice_3, delay_tag_leaves_window_choice_4 : boolean;
    variable delay_tag_leaves_window_choice_5, delay_tag_leaves_window_is_not_less : boolean;
    variable delay_tag_map_column_value, delay_tag_map_column_choice, delay_tag_map_column_choice_2 : boolean;
    variable delay_tag_map_column_value_2, delay_tag_map_column_choice_3, delay_tag_map_column_value_3 : boolean;
    variable delay_tag_map_column_choice_4, delay_tag_map_column_value_4, delay_tag_map_column_choice_5 : boolean;
    variable delay_tag_map_column_is_not_less, delay_tag_output_column_choice : boolean;
    variable delay_tag_first_column_is_equal, delay_tag_end_of_line_choice, delay_tag_end_of_line_choice_2 : boolean;
    variable delay_tag_end_of_line_choice_3, delay_tag_end_of_line_choice_4, delay_tag_end_of_line_choice_5 : boolean;
    variable delay_tag_end_of_line_choice_6, delay_split_search_inside_0_is_equal : boolean;
    variable delay_split_search_inside_0_value, delay_split_search_inside_0_choice : boolean;
    variable delay_split_search_inside_0_choice_2, delay_split_search_inside_0_choice_3 : boolean;
    variable delay_split_search_inside_0_value_2, delay_split_search_inside_0_choice_4 : boolean;
    variable delay_split_search_inside_0_choice_5, delay_split_search_inside_0_choice_6 : boolean;
    variable delay_split_search_inside_0_choice_7, delay_split_search_inside_0_all : boolean;
    variable delay_split_inside_before_1_all, slice0cost_pixels_first_0_0_value : boolean;
    variable slice0cost_pixels_first_0_0_value_2, slice0cost_pixels_first_0_0_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_value_4, slice0cost_pixels_first_0_0_value_5 : boolean;
    variable slice0cost_pixels_first_0_0_value_6, slice0cost_pixels_first_0_0_value_7 : boolean;
    variable slice0cost_pixels_first_0_0_value_8, slice0cost_pixels_first_0_0_value_9 : boolean;
    variable slice0cost_pixels_first_0_0_value_10, slice0cost_pixels_first_1_0_value : boolean;
    variable slice0cost_pixels_first_1_0_value_2, slice0cost_pixels_first_1_0_value_3 : boolean;
    variable slice0cost_pixels_first_1_0_value_4, slice0cost_pixels_first_1_0_value_5 : boolean;
    variable slice0cost_pixels_first_1_0_value_6, slice0cost_pixels_first_1_0_value_7 : boolean;
    variable slice0cost_pixels_first_1_0_value_8, slice0cost_pixels_first_1_0_value_9 : boolean;
    variable slice0cost_pixels_first_1_0_value_10, slice0mask_inside_0_choice, slice0mask_inside_0_choice_2 : boolean;
    variable slice0mask_inside_0_value, slice0mask_inside_0_choice_3, slice0mask_inside_0_value_2 : boolean;
    variable slice0mask_inside_0_choice_4, slice0mask_inside_0_value_3, slice0mask_inside_0_choice_5 : boolean;
    variable slice0mask_inside_0_differs, slice0mask_inside_0_choice_6, slice0mask_inside_0_all : boolean;
    variable slice0mask_inside_0_choice_7, slice0mask_inside_1_choice, slice0mask_inside_2_choice : boolean;
    variable slice0mask_inside_3_choice, slice0mask_inside_4_choice, slice0mask_inside_5_choice : boolean;
    variable slice0other_cost_0_1_all, slice0other_cost_0_1_choice, slice0other_cost_0_1_all_2 : boolean;
    variable slice0other_cost_0_2_choice, slice0other_cost_0_2_all, slice0other_cost_0_3_choice : boolean;
    variable slice0other_cost_0_3_all, slice0other_cost_0_4_choice, slice0other_cost_0_4_all : boolean;
    variable slice0other_cost_0_5_all, slice0winner1_best_cost_0_0_is_less : boolean;
    variable slice0winner1_best_cost_0_1_is_less, slice0winner1_best_cost_0_2_is_less : boolean;
    variable slice0winner2_best_cost_0_0_is_less, slice0winner2_best_below_0_0_is_equal : boolean;
    variable slice0winner3_best_cost_0_0_is_less, slice0winner3_best_above_0_0_is_equal : boolean;
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
    variable slice1window_entering_tag_border_column_is_less, slice1mask_inside_0_all : boolean;
    variable slice1mask_inside_0_choice, slice1mask_inside_1_choice, slice1mask_inside_2_choice : boolean;
    variable slice1mask_inside_3_choice, slice1mask_inside_4_choice, slice1mask_inside_5_choice : boolean;
    variable slice1mask_searched_5_value, slice1mask_searched_5_value_2, slice1mask_searched_5_value_3 : boolean;
    variable slice1mask_searched_5_all, slice1mask_searched_5_choice, slice1mask_searched_5_value_4 : boolean;
    variable slice1mask_searched_5_value_5, slice1mask_searched_5_choice_2, slice1mask_searched_5_is_equal : boolean;
    variable slice1mask_searched_5_value_6, slice1mask_searched_5_choice_3, slice1mask_searched_5_all_2 : boolean;
    variable slice1other_cost_0_0_all, slice1other_cost_0_0_choice, slice1other_cost_0_0_all_2 : boolean;
    variable slice1other_cost_0_1_choice, slice1other_cost_0_1_all, slice1other_cost_0_2_choice : boolean;
    variable slice1other_cost_0_2_all, slice1other_cost_0_3_choice, slice1other_cost_0_3_all : boolean;
    variable slice1other_cost_0_4_choice, slice1other_cost_0_4_all, slice1winner1_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_1_is_less, slice1winner2_best_cost_0_0_is_less : boolean;
    variable slice1winner2_best_below_0_0_is_equal, slice1winner3_best_cost_0_0_is_less : boolean;
    variable slice1winner3_best_above_0_0_is_equal, slice1_best_cost_0_0_is_less : boolean;
    variable slice1_best_below_0_0_is_equal, slice1_best_above_0_0_is_equal, refinement_below_0_differs : boolean;
    variable refinement_below_0_differs_2, refinement_below_0_all, refinement_above_0_choice : boolean;
    variable refinement_divisor_0_0_is_less, leftright_holds_winners_all : boolean;
    variable leftright_checked_tag_row_start_choice, leftright_checked_tag_row_start_is_equal : boolean;
    variable leftright_checked_tag_row_start_choice_2, leftright_checked_tag_row_start_value : boolean;
    variable leftright_checked_tag_row_start_choice_3, leftright_checked_tag_row_start_value_2 : boolean;
    variable leftright_checked_tag_row_start_choice_4, leftright_checked_tag_row_start_value_3 : boolean;
    variable leftright_checked_tag_row_start_choice_5, leftright_checked_tag_row_start_choice_6 : boolean;
    variable leftright_checked_tag_row_start_choice_7, leftright_checked_tag_row_start_value_4 : boolean;
    variable leftright_checked_tag_row_start_choice_8, leftright_checked_tag_row_start_choice_9 : boolean;
    variable leftright_checked_tag_row_start_choice_10, leftright_checked_tag_row_start_differs : boolean;
    variable leftright_checked_tag_row_start_differs_2, leftright_checked_tag_row_start_choice_11 : boolean;
    variable leftright_checked_tag_row_start_value_6, leftright_checked_tag_row_start_is_equal_2 : boolean;
    variable leftright_checked_tag_row_start_is_equal_3, leftright_checked_tag_row_start_choice_12 : boolean;
    variable leftright_checked_tag_row_start_is_equal_4, leftright_checked_tag_row_start_is_equal_5 : boolean;
    variable leftright_checked_tag_row_start_choice_13, leftright_checked_tag_row_start_choice_14 : boolean;
    variable leftright_checked_tag_row_start_is_equal_6, leftright_checked_tag_row_start_is_equal_7 : boolean;
    variable leftright_checked_tag_row_start_choice_15, leftright_checked_tag_row_start_is_equal_8 : boolean;
    variable leftright_checked_tag_row_start_choice_16, leftright_checked_tag_row_start_choice_17 : boolean;
    variable leftright_checked_tag_row_start_differs_3, leftright_checked_tag_row_start_all : boolean;
    variable leftright_checked_tag_row_start_choice_18, leftright_checked_tag_row_start_value_7 : boolean;
    variable leftright_checked_tag_row_start_choice_19, leftright_checked_tag_row_start_choice_20 : boolean;
    variable leftright_checked_tag_row_start_choice_21, leftright_checked_tag_row_start_choice_22 : boolean;
    variable leftright_checked_tag_row_start_choice_23, leftright_checked_tag_row_start_choice_24 : boolean;
    variable leftright_checked_tag_row_start_differs_4, leftright_checked_tag_row_start_all_2 : boolean;
    variable leftright_checked_tag_row_start_choice_25, leftright_checked_tag_row_start_all_3 : boolean;
    variable map_line_ended_choice, map_at_arrives_value, map_window_complete_choice : boolean;
    variable map_window_complete_choice_2, map_low_1_0_all, map_low_0_0_all, other_17_is_equal : boolean;
    variable other_17_is_equal_2, other_17_is_equal_3, other_18_choice, other_18_choice_2, other_18_value : boolean;
    variable other_18_choice_3, other_22_any, other_22_all, other_22_choice, other_22_value, other_22_any_2 : boolean;
    variable other_22_is_equal, other_22_choice_2, other_22_all_2, other_24_choice, other_24_is_equal : boolean;
    variable other_24_choice_2, other_26_is_equal, other_26_choice, other_27_choice, other_20_choice : boolean;
    variable transform_counter_group_value_8, delay_tag_end_of_line_value : natural range 0 to 3;
    variable leftright_checked_tag_row_start_value_5 : natural range 0 to 3;
    variable transform_counter_group_choice_13, transform_counter_group_choice_25 : natural range 0 to 31;
    variable transform_counter_group_choice_26, map_counter_group_choice : natural range 0 to 31;
    variable map_counter_group_choice_2, map_counter_group_choice_3 : natural range 0 to 31;
    variable transform_centre_column_choice : natural range 0 to 63;
    variable transform_up_to_last_0_sum : natural range 1 to 32;
    variable transform_up_to_last_0_difference : integer range -31 to 32;
    variable transform_up_to_last_1_sum : natural range 5 to 68;
    variable delay_row_inside_0_difference : integer range -31 to 31;
    variable slice0cost_column_0_0_choice, slice0cost_column_0_0_value : natural range 0 to 127;
    variable slice0cost_column_0_1_choice, slice0cost_column_0_1_value : natural range 0 to 127;
    variable slice0cost_column_0_2_choice, slice0cost_column_0_2_value : natural range 0 to 127;
    variable slice0cost_column_0_3_choice, slice0cost_column_0_3_value : natural range 0 to 127;
    variable slice0cost_column_0_4_choice, slice0cost_column_0_4_value : natural range 0 to 127;
    variable slice0cost_column_0_5_choice, slice0cost_column_0_5_value : natural range 0 to 127;
    variable slice0window_change_0_0_choice, slice0window_change_0_1_choice : natural range 0 to 127;
    variable slice0window_change_0_2_choice, slice0window_change_0_3_choice : natural range 0 to 127;
    variable slice0window_change_0_4_choice, slice0window_change_0_5_choice : natural range 0 to 127;
    variable slice1cost_column_0_0_choice, slice1cost_column_0_0_value : natural range 0 to 127;
    variable slice1cost_column_0_1_choice, slice1cost_column_0_1_value : natural range 0 to 127;
    variable slice1cost_column_0_2_choice, slice1cost_column_0_2_value : natural range 0 to 127;
    variable slice1cost_column_0_3_choice, slice1cost_column_0_3_value : natural range 0 to 127;
    variable slice1cost_column_0_4_choice, slice1cost_column_0_4_value : natural range 0 to 127;
    variable slice1cost_column_0_5_choice, slice1cost_column_0_5_value : natural range 0 to 127;
    variable slice1window_change_0_0_choice, slice1window_change_0_1_choice : natural range 0 to 127;
    variable slice1window_change_0_2_choice, slice1window_change_0_3_choice : natural range 0 to 127;
    variable slice1window_change_0_4_choice, slice1window_change_0_5_choice : natural range 0 to 127;
    variable slice0window_sum_0_0_choice, slice0window_sum_0_1_choice : natural range 0 to 511;
    variable slice0window_sum_0_2_choice, slice0window_sum_0_3_choice : natural range 0 to 511;
    variable slice0window_sum_0_4_choice, slice0window_sum_0_5_choice : natural range 0 to 511;
    variable slice0other_cost_0_1_choice_2, slice0other_cost_0_2_choice_2 : natural range 0 to 511;
    variable slice0other_cost_0_3_choice_2, slice0other_cost_0_4_choice_2 : natural range 0 to 511;
    variable slice0other_cost_0_5_choice, slice0winner1_held_0_0_choice : natural range 0 to 511;
    variable slice0winner1_held_0_0_any, slice0winner1_held_0_1_choice : natural range 0 to 511;
    variable slice0winner1_held_0_1_any, slice0winner1_held_0_2_choice : natural range 0 to 511;
    variable slice0winner1_held_0_2_any, slice0winner1_held_0_3_choice : natural range 0 to 511;
    variable slice0winner1_held_0_3_any, slice0winner1_held_0_4_choice : natural range 0 to 511;
    variable slice0winner1_held_0_4_any, slice0winner1_held_0_5_choice : natural range 0 to 511;
    variable slice0winner1_held_0_5_any, slice0winner2_best_below_0_0_choice : natural range 0 to 511;
    variable slice0winner2_best_above_0_0_choice, slice0winner2_best_second_0_0_choice : natural range 0 to 511;
    variable slice0winner2_best_second_0_0_choice_2, slice0winner2_best_second_0_0_choice_3 : natural range 0 to 511;
    variable slice0winner2_best_second_0_0_choice_4, slice0winner3_best_below_0_0_choice : natural range 0 to 511;
    variable slice0winner3_best_above_0_0_choice, slice0winner3_best_second_0_0_choice : natural range 0 to 511;
    variable slice0winner3_best_second_0_0_choice_2, slice0winner3_best_second_0_0_choice_3 : natural range 0 to 511;
    variable slice0winner3_best_second_0_0_choice_4 : natural range 0 to 511;
    variable slice1window_entering_tag_border_column_choice : natural range 0 to 511;
    variable slice1window_entering_tag_border_column_any : natural range 0 to 511;
    variable slice1window_entering_tag_border_column_choice_2 : natural range 0 to 511;
    variable slice1window_entering_tag_border_column_any_2, slice1window_sum_0_0_choice : natural range 0 to 511;
    variable slice1window_sum_0_1_choice, slice1window_sum_0_2_choice : natural range 0 to 511;
    variable slice1window_sum_0_3_choice, slice1window_sum_0_4_choice : natural range 0 to 511;
    variable slice1window_sum_0_5_choice, slice1other_cost_0_0_choice_2 : natural range 0 to 511;
    variable slice1other_cost_0_1_choice_2, slice1other_cost_0_2_choice_2 : natural range 0 to 511;
    variable slice1other_cost_0_3_choice_2, slice1other_cost_0_4_choice_2 : natural range 0 to 511;
    variable slice1winner1_held_0_0_choice, slice1winner1_held_0_0_any : natural range 0 to 511;
    variable slice1winner1_held_0_1_choice, slice1winner1_held_0_1_any : natural range 0 to 511;
    variable slice1winner1_held_0_2_choice, slice1winner1_held_0_2_any : natural range 0 to 511;
    variable slice1winner1_held_0_3_choice, slice1winner1_held_0_3_any : natural range 0 to 511;
    variable slice1winner2_best_below_0_0_choice, slice1winner2_best_above_0_0_choice : natural range 0 to 511;
    variable slice1winner2_best_second_0_0_choice, slice1winner2_best_second_0_0_choice_2 : natural range 0 to 511;
    variable slice1winner2_best_second_0_0_choice_3, slice1winner2_best_second_0_0_choice_4 : natural range 0 to 511;
    variable slice1winner3_best_below_0_0_choice, slice1winner3_best_above_0_0_choice : natural range 0 to 511;
    variable slice1winner3_best_second_0_0_choice, slice1winner3_best_second_0_0_choice_2 : natural range 0 to 511;
    variable slice1winner3_best_second_0_0_choice_3, slice1winner3_best_second_0_0_choice_4 : natural range 0 to 511;
    variable slice1_best_below_0_0_choice, slice1_best_above_0_0_choice : natural range 0 to 511;
    variable slice1_best_second_0_0_choice, slice1_best_second_0_0_choice_2 : natural range 0 to 511;
    variable slice1_best_second_0_0_choice_3, slice1_best_second_0_0_choice_4 : natural range 0 to 511;
    variable refinement_divisor_0_0_choice : natural range 0 to 511;
    variable refinement_remainder_1_0_difference : natural range 513 to 1535;
    variable refinement_remainder_2_0_difference, refinement_remainder_3_0_difference : natural range 513 to 2046;
    variable refinement_remainder_4_0_difference, refinement_remainder_5_0_difference : natural range 513 to 2046;
    variable refinement_remainder_6_0_difference, refinement_remainder_7_0_difference : natural range 513 to 2046;
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice : natural range 0 to 255;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -15 to 15;
    variable map_of_column_0_a_choice : natural range 0 to 4095;
    variable map_of_column_0_c_choice, map_sorted_low_0_choice, map_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_middle_0_choice, map_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable map_sorted_high_0_choice, map_sorted_high_0_choice_2, map_largest_low_0_choice : natural range 0 to 32767;
    variable map_largest_low_0_choice_2, map_median_middle_0_choice : natural range 0 to 32767;
    variable map_median_middle_0_choice_2, map_median_middle_0_choice_3 : natural range 0 to 32767;
    variable map_median_middle_0_choice_4, map_smallest_high_0_choice : natural range 0 to 32767;
    variable map_smallest_high_0_choice_2, map_out_disparity_0_choice : natural range 0 to 32767;
    variable map_out_disparity_0_choice_2, map_out_disparity_0_choice_3 : natural range 0 to 32767;
    variable map_out_disparity_0_choice_4, map_low_0_0_choice, map_middle_0_0_choice : natural range 0 to 32767;
    variable map_high_0_0_choice : natural range 0 to 32767;
  begin
    if rising_edge(clock) then
      -- settings
      settings_uniqueness_percent_any := (not in_valid) or (not in_start_of_frame);
      if not settings_uniqueness_percent_any then
        settings_uniqueness_percent <= in_uniqueness_percent;
        settings_left_right_threshold <= in_left_right_threshold;
        settings_first_disparity <= in_first_disparity;
        settings_last_disparity <= in_last_disparity;
      end if;
      -- size
      size_windows_last_column <= (in_image_width + 63) mod 64;
      size_windows_last_group <= (in_image_height + 31) mod 32;
      size_windows_groups <= in_image_height mod 32;
      size_windows_idle <= (in_image_height + 1) mod 32;
      size_map_last_column <= ((((in_image_width / 4) + 15) mod 16) * 4) + (in_image_width mod 4);
      size_transform_last_counted <= (in_image_height + 3) mod 32;
      size_transform_idle <= (((((in_image_height mod 32) / 4) + 1) mod 8) * 4) + (in_image_height mod 4);
      size_map_columns_to <= (in_image_width + 61) mod 64;
      -- transform
      transform_counter_group_value := ((transform_counter_group / 8) mod 2) = 1;
      if transform_counter_group_value then
        transform_counter_group_choice := (size_windows_last_group / 8) = 3;
      else
        transform_counter_group_choice := (size_windows_last_group / 8) = 2;
      end if;
      if transform_counter_group_value then
        transform_counter_group_choice_2 := (size_windows_last_group / 8) = 1;
      else
        transform_counter_group_choice_2 := (size_windows_last_group / 8) = 0;
      end if;
      if (transform_counter_group / 16) = 1 then
        transform_counter_group_choice_3 := transform_counter_group_choice;
      else
        transform_counter_group_choice_3 := transform_counter_group_choice_2;
      end if;
      transform_counter_group_value_2 := ((transform_counter_group / 2) mod 2) = 1;
      if transform_counter_group_value_2 then
        transform_counter_group_choice_4 := (size_windows_last_group mod 4) = 3;
      else
        transform_counter_group_choice_4 := (size_windows_last_group mod 4) = 1;
      end if;
      if transform_counter_group_value_2 then
        transform_counter_group_choice_5 := (size_windows_last_group mod 4) = 2;
      else
        transform_counter_group_choice_5 := (size_windows_last_group mod 4) = 0;
      end if;
      if (transform_counter_group mod 2) = 1 then
        transform_counter_group_choice_6 := transform_counter_group_choice_4;
      else
        transform_counter_group_choice_6 := transform_counter_group_choice_5;
      end if;
      transform_counter_group_value_3 := ((transform_counter_group / 4) mod 2) = 1;
      transform_counter_group_value_4 := ((size_windows_last_group / 4) mod 2) = 1;
      transform_counter_group_differs := transform_counter_group_value_3 /= (not transform_counter_group_value_4);
      transform_counter_group_value_5 := ((transform_counter_column / 16) mod 2) = 1;
      transform_counter_group_is_equal := (size_windows_last_column / 16) = 3;
      transform_counter_group_is_equal_2 := (size_windows_last_column / 16) = 2;
      if transform_counter_group_value_5 then
        transform_counter_group_choice_7 := transform_counter_group_is_equal;
      else
        transform_counter_group_choice_7 := transform_counter_group_is_equal_2;
      end if;
      transform_counter_group_is_equal_3 := (size_windows_last_column / 16) = 1;
      transform_counter_group_is_equal_4 := (size_windows_last_column / 16) = 0;
      if transform_counter_group_value_5 then
        transform_counter_group_choice_8 := transform_counter_group_is_equal_3;
      else
        transform_counter_group_choice_8 := transform_counter_group_is_equal_4;
      end if;
      if (transform_counter_column / 32) = 1 then
        transform_counter_group_choice_9 := transform_counter_group_choice_7;
      else
        transform_counter_group_choice_9 := transform_counter_group_choice_8;
      end if;
      transform_counter_group_value_6 := ((transform_counter_column / 4) mod 2) = 1;
      transform_counter_group_value_7 := ((transform_counter_column / 2) mod 2) = 1;
      transform_counter_group_value_8 := (size_windows_last_column / 2) mod 4;
      transform_counter_group_is_equal_5 := transform_counter_group_value_8 = 3;
      transform_counter_group_is_equal_6 := transform_counter_group_value_8 = 2;
      if transform_counter_group_value_7 then
        transform_counter_group_choice_10 := transform_counter_group_is_equal_5;
      else
        transform_counter_group_choice_10 := transform_counter_group_is_equal_6;
      end if;
      transform_counter_group_is_equal_7 := transform_counter_group_value_8 = 1;
      transform_counter_group_is_equal_8 := transform_counter_group_value_8 = 0;
      if transform_counter_group_value_7 then
        transform_counter_group_choice_11 := transform_counter_group_is_equal_7;
      else
        transform_counter_group_choice_11 := transform_counter_group_is_equal_8;
      end if;
      if transform_counter_group_value_6 then
        transform_counter_group_choice_12 := transform_counter_group_choice_10;
      else
        transform_counter_group_choice_12 := transform_counter_group_choice_11;
      end if;
      transform_counter_group_differs_2 := ((transform_counter_column mod 2) = 1) /= (not ((size_windows_last_column
        mod 2) = 1));
      transform_counter_group_value_9 := ((transform_counter_column / 8) mod 2) = 1;
      transform_counter_group_value_10 := ((size_windows_last_column / 8) mod 2) = 1;
      transform_counter_group_differs_3 := transform_counter_group_value_9 /= (not transform_counter_group_value_10);
      transform_counter_group_all := transform_counter_group_choice_3 and transform_counter_group_choice_6 and
        transform_counter_group_differs and transform_counter_group_choice_9 and transform_counter_group_choice_12 and
        transform_counter_group_differs_2 and transform_counter_group_differs_3;
      if transform_counter_group_all then
        transform_counter_group_choice_13 := size_windows_groups;
      else
        transform_counter_group_choice_13 := 0;
      end if;
      if (size_transform_idle mod 2) = 1 then
        transform_counter_group_choice_14 := (not ((transform_counter_group mod 2) = 1)) or (not
          transform_counter_group_value_2);
      else
        transform_counter_group_choice_14 := not transform_counter_group_value_2;
      end if;
      transform_counter_group_is_equal_9 := (transform_counter_group mod 4) = 0;
      if ((size_transform_idle / 2) mod 2) = 1 then
        transform_counter_group_choice_15 := transform_counter_group_choice_14;
      else
        transform_counter_group_choice_15 := ((size_transform_idle mod 2) = 1) and transform_counter_group_is_equal_9;
      end if;
      if transform_counter_group_choice_15 then
        transform_counter_group_choice_16 := (not (((size_transform_idle / 4) mod 2) = 1)) and
          transform_counter_group_value_3;
      else
        transform_counter_group_choice_16 := (not (((size_transform_idle / 4) mod 2) = 1)) or
          transform_counter_group_value_3;
      end if;
      if transform_counter_group_choice_16 then
        transform_counter_group_choice_17 := (not (((size_transform_idle / 8) mod 2) = 1)) or
          transform_counter_group_value;
      else
        transform_counter_group_choice_17 := (not (((size_transform_idle / 8) mod 2) = 1)) and
          transform_counter_group_value;
      end if;
      if transform_counter_group_choice_17 then
        transform_counter_group_choice_18 := transform_counter_group_choice_9 and transform_counter_group_choice_12 and
          transform_counter_group_differs_2 and transform_counter_group_differs_3 and ((size_transform_idle / 16) = 1)
          and (not ((transform_counter_group / 16) = 1));
      else
        transform_counter_group_choice_18 := transform_counter_group_choice_9 and transform_counter_group_choice_12 and
          transform_counter_group_differs_2 and transform_counter_group_differs_3 and (((size_transform_idle / 16) = 1)
          or (not ((transform_counter_group / 16) = 1)));
      end if;
      transform_counter_group_value_11 := ((size_transform_last_counted / 8) mod 2) = 1;
      if transform_counter_group_value_11 then
        transform_counter_group_choice_19 := (transform_counter_group / 8) = 3;
      else
        transform_counter_group_choice_19 := (transform_counter_group / 8) = 2;
      end if;
      if transform_counter_group_value_11 then
        transform_counter_group_choice_20 := (transform_counter_group / 8) = 1;
      else
        transform_counter_group_choice_20 := (transform_counter_group / 8) = 0;
      end if;
      if (size_transform_last_counted / 16) = 1 then
        transform_counter_group_choice_21 := transform_counter_group_choice_19;
      else
        transform_counter_group_choice_21 := transform_counter_group_choice_20;
      end if;
      if (size_transform_last_counted mod 2) = 1 then
        transform_counter_group_choice_22 := (transform_counter_group mod 4) = 3;
      else
        transform_counter_group_choice_22 := (transform_counter_group mod 4) = 2;
      end if;
      if (size_transform_last_counted mod 2) = 1 then
        transform_counter_group_choice_23 := (transform_counter_group mod 4) = 1;
      else
        transform_counter_group_choice_23 := transform_counter_group_is_equal_9;
      end if;
      if ((size_transform_last_counted / 2) mod 2) = 1 then
        transform_counter_group_choice_24 := transform_counter_group_choice_22;
      else
        transform_counter_group_choice_24 := transform_counter_group_choice_23;
      end if;
      transform_counter_group_differs_4 := (((size_transform_last_counted / 4) mod 2) = 1) /= (not
        transform_counter_group_value_3);
      if transform_counter_group_choice_21 and transform_counter_group_choice_24 and transform_counter_group_differs_4
        and transform_counter_next_frame then
        transform_counter_group_choice_25 := 4;
      else
        transform_counter_group_choice_25 := (transform_counter_group + 1) mod 32;
      end if;
      if transform_counter_group_choice_18 and in_valid then
        transform_counter_group_choice_26 := transform_counter_group_choice_25;
      else
        transform_counter_group_choice_26 := transform_counter_group;
      end if;
      transform_centre_column_any := (not ((not transform_counter_group_value_9) and ((not
        transform_counter_group_value_6) or ((transform_counter_column mod 4) = 0)))) or ((transform_counter_column /
        32) = 1) or transform_counter_group_value_5;
      if transform_centre_column_any then
        transform_centre_column_choice := 59;
      else
        transform_centre_column_choice := transform_columns_up_value;
      end if;
      transform_from_first_1_differs := (transform_centre_column / 4) /= 0;
      transform_up_to_last_0_sum := (transform_centre_column / 2) + 1;
      transform_up_to_last_0_is_equal := (size_windows_last_column mod 4) = 3;
      transform_up_to_last_0_value := ((size_windows_last_column / 2) mod 2) = 1;
      if (transform_centre_column mod 2) = 1 then
        transform_up_to_last_0_choice := transform_up_to_last_0_is_equal;
      else
        transform_up_to_last_0_choice := transform_up_to_last_0_value;
      end if;
      if (transform_up_to_last_0_sum mod 2) = 1 then
        transform_up_to_last_0_choice_2 := transform_up_to_last_0_choice;
      else
        transform_up_to_last_0_choice_2 := (not ((transform_centre_column mod 2) = 1)) or ((size_windows_last_column
          mod 2) = 1) or transform_up_to_last_0_value;
      end if;
      transform_up_to_last_0_value_2 := ((size_windows_last_column / 4) mod 2) = 1;
      if transform_up_to_last_0_choice_2 then
        transform_up_to_last_0_choice_3 := (not (((transform_up_to_last_0_sum / 2) mod 2) = 1)) or
          transform_up_to_last_0_value_2;
      else
        transform_up_to_last_0_choice_3 := (not (((transform_up_to_last_0_sum / 2) mod 2) = 1)) and
          transform_up_to_last_0_value_2;
      end if;
      if transform_up_to_last_0_choice_3 then
        transform_up_to_last_0_choice_4 := (not (((transform_up_to_last_0_sum / 4) mod 2) = 1)) or
          transform_counter_group_value_10;
      else
        transform_up_to_last_0_choice_4 := (not (((transform_up_to_last_0_sum / 4) mod 2) = 1)) and
          transform_counter_group_value_10;
      end if;
      transform_up_to_last_0_value_3 := ((size_windows_last_column / 16) mod 2) = 1;
      if transform_up_to_last_0_choice_4 then
        transform_up_to_last_0_choice_5 := (not (((transform_up_to_last_0_sum / 8) mod 2) = 1)) or
          transform_up_to_last_0_value_3;
      else
        transform_up_to_last_0_choice_5 := (not (((transform_up_to_last_0_sum / 8) mod 2) = 1)) and
          transform_up_to_last_0_value_3;
      end if;
      if transform_up_to_last_0_choice_5 then
        transform_up_to_last_0_choice_6 := (not ((transform_up_to_last_0_sum / 32) = 1)) and ((not
          (((transform_up_to_last_0_sum / 16) mod 2) = 1)) or ((size_windows_last_column / 32) = 1));
      else
        transform_up_to_last_0_choice_6 := ((transform_up_to_last_0_sum / 16) = 0) and ((size_windows_last_column / 32)
          = 1);
      end if;
      transform_up_to_last_0_difference := transform_centre_group - size_windows_groups;
      transform_up_to_last_1_sum := transform_centre_column + 5;
      if (transform_up_to_last_1_sum mod 2) = 1 then
        transform_up_to_last_1_choice := transform_up_to_last_0_is_equal;
      else
        transform_up_to_last_1_choice := transform_up_to_last_0_value;
      end if;
      if ((transform_up_to_last_1_sum / 2) mod 2) = 1 then
        transform_up_to_last_1_choice_2 := transform_up_to_last_1_choice;
      else
        transform_up_to_last_1_choice_2 := (not ((transform_up_to_last_1_sum mod 2) = 1)) or ((size_windows_last_column
          mod 2) = 1) or transform_up_to_last_0_value;
      end if;
      if transform_up_to_last_1_choice_2 then
        transform_up_to_last_1_choice_3 := (not (((transform_up_to_last_1_sum / 4) mod 2) = 1)) or
          transform_up_to_last_0_value_2;
      else
        transform_up_to_last_1_choice_3 := (not (((transform_up_to_last_1_sum / 4) mod 2) = 1)) and
          transform_up_to_last_0_value_2;
      end if;
      if transform_up_to_last_1_choice_3 then
        transform_up_to_last_1_choice_4 := (not (((transform_up_to_last_1_sum / 8) mod 2) = 1)) or
          transform_counter_group_value_10;
      else
        transform_up_to_last_1_choice_4 := (not (((transform_up_to_last_1_sum / 8) mod 2) = 1)) and
          transform_counter_group_value_10;
      end if;
      if transform_up_to_last_1_choice_4 then
        transform_up_to_last_1_choice_5 := (not (((transform_up_to_last_1_sum / 16) mod 2) = 1)) or
          transform_up_to_last_0_value_3;
      else
        transform_up_to_last_1_choice_5 := (not (((transform_up_to_last_1_sum / 16) mod 2) = 1)) and
          transform_up_to_last_0_value_3;
      end if;
      if transform_up_to_last_1_choice_5 then
        transform_up_to_last_1_choice_6 := (not ((transform_up_to_last_1_sum / 64) = 1)) and ((not
          (((transform_up_to_last_1_sum / 32) mod 2) = 1)) or ((size_windows_last_column / 32) = 1));
      else
        transform_up_to_last_1_choice_6 := ((transform_up_to_last_1_sum / 32) = 0) and ((size_windows_last_column / 32)
          = 1);
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
      transform_columns_up_value <= ((((size_windows_last_column / 4) + 15) mod 16) * 4) + (size_windows_last_column
        mod 4);
      transform_centre_column <= (transform_centre_column_choice + transform_counter_column) mod 64;
      transform_centre_group <= transform_counter_group + as_number(transform_centre_column_any);
      transform_up_to_last_0 <= transform_up_to_last_0_choice_6 and (transform_up_to_last_0_difference < 3);
      transform_up_to_last_1 <= transform_up_to_last_1_choice_6 and (transform_up_to_last_0_difference < 1);
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
      transform_columns_start_of_frame <= (other_3 mod 2) = 1;
      transform_columns_valid <= (other_3 / 256) = 1;
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
      transform_left_code_row_odd_1 <= (transform_left_code_row_after_1 - transform_left_code_row_before_1) mod 16384;
      transform_left_code_row_odd_2 <= (transform_left_code_row_after_2 - transform_left_code_row_before_2) mod 16384;
      transform_left_code_row_signs <= ((other_0 / 8192) * 2) + (other_1 / 8192) + ((((transform_left_code_row_even_2 +
        transform_left_code_row_odd_1) mod 16384) / 8192) * 8) + ((((transform_left_code_row_odd_1 -
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
      transform_left_code_next_row_odd_0 <= (transform_left_code_next_row_after_0 -
        transform_left_code_next_row_before_0) mod 65536;
      transform_left_code_next_row_odd_1 <= (transform_left_code_next_row_after_1 -
        transform_left_code_next_row_before_1) mod 65536;
      transform_left_code_next_row_odd_2 <= (transform_left_code_next_row_after_2 -
        transform_left_code_next_row_before_2) mod 65536;
      transform_left_code_next_row_signs <= (other_32 / 32768) + ((transform_left_code_next_row_odd_0 / 32768) * 2) +
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
      transform_right_code_row_odd_1 <= (transform_right_code_row_after_1 - transform_right_code_row_before_1) mod
        16384;
      transform_right_code_row_odd_2 <= (transform_right_code_row_after_2 - transform_right_code_row_before_2) mod
        16384;
      transform_right_code_row_signs <= ((other_29 / 8192) * 2) + (other_30 / 8192) +
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
      transform_right_code_next_row_odd_0 <= (transform_right_code_next_row_after_0 -
        transform_right_code_next_row_before_0) mod 65536;
      transform_right_code_next_row_odd_1 <= (transform_right_code_next_row_after_1 -
        transform_right_code_next_row_before_1) mod 65536;
      transform_right_code_next_row_odd_2 <= (transform_right_code_next_row_after_2 -
        transform_right_code_next_row_before_2) mod 65536;
      transform_right_code_next_row_signs <= (other_28 / 32768) + ((transform_right_code_next_row_odd_0 / 32768) * 2) +
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
        transform_counter_group <= transform_counter_group_choice_13;
      else
        transform_counter_group <= transform_counter_group_choice_26;
      end if;
      if ((transform_centre_column / 2) mod 16) = 0 then
        transform_from_first_0 <= (not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0))) and ((transform_centre_column / 32) = 1);
      else
        transform_from_first_0 <= not (((not (((transform_centre_group / 4) mod 2) = 1)) or (not
          (((transform_centre_group / 2) mod 2) = 1)) or (not ((transform_centre_group mod 2) = 1))) and
          ((transform_centre_group / 8) = 0));
      end if;
      if (not (((transform_centre_group / 16) mod 2) = 1)) and ((not (((transform_centre_group / 8) mod 2) = 1)) or
        (((transform_centre_group / 2) mod 4) = 0)) then
        transform_from_first_1 <= transform_from_first_1_differs and ((transform_centre_group / 32) = 1);
      else
        transform_from_first_1 <= transform_from_first_1_differs;
      end if;
      if transform_filtering_6_inside_0 then
        transform_left_code_bits <= transform_left_code_earlier_2;
        transform_right_code_bits <= transform_right_code_earlier_2;
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
      if transform_counter_group_choice_18 then
        transform_counter_next_frame_choice := (not (transform_counter_group_choice_21 and
          transform_counter_group_choice_24 and transform_counter_group_differs_4)) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if in_valid then
        if (transform_counter_group_choice_9 and transform_counter_group_choice_12 and
          transform_counter_group_differs_2 and transform_counter_group_differs_3) or in_start_of_frame then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 64;
        end if;
        if transform_counter_next_frame_choice then
          transform_counter_next_frame <= transform_counter_group_all or (not in_start_of_frame);
        else
          transform_counter_next_frame <= transform_counter_group_choice_3 and transform_counter_group_choice_6 and
            transform_counter_group_differs and transform_counter_group_choice_9 and transform_counter_group_choice_12
            and transform_counter_group_differs_2 and transform_counter_group_differs_3 and in_start_of_frame;
        end if;
      end if;
      if (other_3 / 256) = 1 then
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
        transform_left_code_earlier_2 <= transform_left_code_earlier_1;
        transform_right_code_earlier_0 <= transform_right_code_row_signs;
        transform_right_code_earlier_1 <= transform_right_code_earlier_0;
        transform_right_code_earlier_2 <= transform_right_code_earlier_1;
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
      raster_place_group_value := ((raster_place_group / 2) mod 2) = 1;
      raster_place_group_value_2 := ((size_windows_idle / 2) mod 2) = 1;
      if raster_place_group_value then
        raster_place_group_choice := (not raster_place_group_value_2) or (not ((size_windows_idle mod 2) = 1));
      else
        raster_place_group_choice := (size_windows_idle mod 4) = 0;
      end if;
      if (raster_place_group mod 2) = 1 then
        raster_place_group_choice_2 := raster_place_group_value or (not raster_place_group_value_2);
      else
        raster_place_group_choice_2 := raster_place_group_choice;
      end if;
      raster_place_group_value_3 := ((raster_place_group / 4) mod 2) = 1;
      raster_place_group_value_4 := ((size_windows_idle / 4) mod 2) = 1;
      if raster_place_group_choice_2 then
        raster_place_group_choice_3 := (not raster_place_group_value_3) and raster_place_group_value_4;
      else
        raster_place_group_choice_3 := (not raster_place_group_value_3) or raster_place_group_value_4;
      end if;
      raster_place_group_value_5 := ((raster_place_group / 8) mod 2) = 1;
      raster_place_group_value_6 := ((size_windows_idle / 8) mod 2) = 1;
      if raster_place_group_choice_3 then
        raster_place_group_choice_4 := (not raster_place_group_value_5) or raster_place_group_value_6;
      else
        raster_place_group_choice_4 := (not raster_place_group_value_5) and raster_place_group_value_6;
      end if;
      if raster_place_group_choice_4 then
        raster_place_group_choice_5 := (not ((raster_place_group / 16) = 1)) or ((size_windows_idle / 16) = 1);
      else
        raster_place_group_choice_5 := (not ((raster_place_group / 16) = 1)) and ((size_windows_idle / 16) = 1);
      end if;
      raster_place_group_value_7 := ((raster_place_column / 16) mod 2) = 1;
      if raster_place_group_value_7 then
        raster_place_group_choice_6 := transform_counter_group_is_equal;
      else
        raster_place_group_choice_6 := transform_counter_group_is_equal_2;
      end if;
      if raster_place_group_value_7 then
        raster_place_group_choice_7 := transform_counter_group_is_equal_3;
      else
        raster_place_group_choice_7 := transform_counter_group_is_equal_4;
      end if;
      if (raster_place_column / 32) = 1 then
        raster_place_group_choice_8 := raster_place_group_choice_6;
      else
        raster_place_group_choice_8 := raster_place_group_choice_7;
      end if;
      raster_place_group_value_8 := ((raster_place_column / 4) mod 2) = 1;
      raster_place_group_value_9 := ((raster_place_column / 2) mod 2) = 1;
      if raster_place_group_value_9 then
        raster_place_group_choice_9 := transform_counter_group_is_equal_5;
      else
        raster_place_group_choice_9 := transform_counter_group_is_equal_6;
      end if;
      if raster_place_group_value_9 then
        raster_place_group_choice_10 := transform_counter_group_is_equal_7;
      else
        raster_place_group_choice_10 := transform_counter_group_is_equal_8;
      end if;
      if raster_place_group_value_8 then
        raster_place_group_choice_11 := raster_place_group_choice_9;
      else
        raster_place_group_choice_11 := raster_place_group_choice_10;
      end if;
      raster_place_group_differs := ((raster_place_column mod 2) = 1) /= (not ((size_windows_last_column mod 2) = 1));
      raster_place_group_value_10 := ((raster_place_column / 8) mod 2) = 1;
      raster_place_group_differs_2 := raster_place_group_value_10 /= (not transform_counter_group_value_10);
      raster_features_search_0 <= (transform_right_code_next_bits * 64) + transform_right_code_bits;
      raster_features_reference_0 <= (transform_left_code_next_bits * 64) + transform_left_code_bits;
      raster_features_valid <= transform_filtering_7_valid;
      if transform_filtering_7_valid and transform_filtering_7_start_of_frame then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number((raster_place_group_choice_5 and
          raster_place_group_choice_8 and raster_place_group_choice_11 and raster_place_group_differs and
          raster_place_group_differs_2 and transform_filtering_7_valid))) mod 32;
      end if;
      if transform_filtering_7_valid then
        if (raster_place_group_choice_8 and raster_place_group_choice_11 and raster_place_group_differs and
          raster_place_group_differs_2) or transform_filtering_7_start_of_frame then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 64;
        end if;
      end if;
      -- delay
      if raster_features_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 2 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 4;
        end if;
      end if;
      delay_row_inside_0_difference := raster_place_group - size_windows_groups;
      delay_row_inside_0_is_less := delay_row_inside_0_difference < 4;
      delay_row_inside_0_any := ((raster_place_group / 16) = 1) or raster_place_group_value_5 or
        raster_place_group_value_3;
      delay_row_inside_0_all := delay_row_inside_0_is_less and delay_row_inside_0_any;
      delay_row_inside_1_is_less := delay_row_inside_0_difference < 0;
      delay_tag_row_start_is_equal := raster_place_column = 0;
      if raster_place_group_value_9 then
        delay_tag_leaves_window_choice := (not ((size_windows_last_column mod 2) = 1)) or (not
          transform_up_to_last_0_value);
      else
        delay_tag_leaves_window_choice := (size_windows_last_column mod 4) = 0;
      end if;
      if (raster_place_column mod 2) = 1 then
        delay_tag_leaves_window_choice_2 := delay_tag_leaves_window_choice;
      else
        delay_tag_leaves_window_choice_2 := raster_place_group_value_9 and (not transform_up_to_last_0_value);
      end if;
      if delay_tag_leaves_window_choice_2 then
        delay_tag_leaves_window_choice_3 := raster_place_group_value_8 or (not transform_up_to_last_0_value_2);
      else
        delay_tag_leaves_window_choice_3 := raster_place_group_value_8 and (not transform_up_to_last_0_value_2);
      end if;
      if delay_tag_leaves_window_choice_3 then
        delay_tag_leaves_window_choice_4 := raster_place_group_value_10 or (not transform_counter_group_value_10);
      else
        delay_tag_leaves_window_choice_4 := raster_place_group_value_10 and (not transform_counter_group_value_10);
      end if;
      if delay_tag_leaves_window_choice_4 then
        delay_tag_leaves_window_choice_5 := raster_place_group_value_7 or (not transform_up_to_last_0_value_3);
      else
        delay_tag_leaves_window_choice_5 := raster_place_group_value_7 and (not transform_up_to_last_0_value_3);
      end if;
      delay_tag_leaves_window_is_not_less := (raster_place_column - other_6) >= 0;
      delay_tag_map_column_value := ((size_map_columns_to / 2) mod 2) = 1;
      if (size_map_columns_to mod 2) = 1 then
        delay_tag_map_column_choice := raster_place_group_value_9;
      else
        delay_tag_map_column_choice := ((raster_place_column mod 2) = 1) or raster_place_group_value_9;
      end if;
      if delay_tag_map_column_value then
        delay_tag_map_column_choice_2 := (not ((size_map_columns_to mod 2) = 1)) and ((raster_place_column mod 4) = 3);
      else
        delay_tag_map_column_choice_2 := delay_tag_map_column_choice;
      end if;
      delay_tag_map_column_value_2 := ((size_map_columns_to / 4) mod 2) = 1;
      if delay_tag_map_column_choice_2 then
        delay_tag_map_column_choice_3 := (not delay_tag_map_column_value_2) or raster_place_group_value_8;
      else
        delay_tag_map_column_choice_3 := (not delay_tag_map_column_value_2) and raster_place_group_value_8;
      end if;
      delay_tag_map_column_value_3 := ((size_map_columns_to / 8) mod 2) = 1;
      if delay_tag_map_column_choice_3 then
        delay_tag_map_column_choice_4 := (not delay_tag_map_column_value_3) or raster_place_group_value_10;
      else
        delay_tag_map_column_choice_4 := (not delay_tag_map_column_value_3) and raster_place_group_value_10;
      end if;
      delay_tag_map_column_value_4 := ((size_map_columns_to / 16) mod 2) = 1;
      if delay_tag_map_column_choice_4 then
        delay_tag_map_column_choice_5 := (not delay_tag_map_column_value_4) or raster_place_group_value_7;
      else
        delay_tag_map_column_choice_5 := (not delay_tag_map_column_value_4) and raster_place_group_value_7;
      end if;
      delay_tag_map_column_is_not_less := (raster_place_column - other_5) >= 0;
      if delay_tag_map_column_choice_5 then
        delay_tag_output_column_choice := (not ((size_map_columns_to / 32) = 1)) or ((raster_place_column / 32) = 1);
      else
        delay_tag_output_column_choice := (not ((size_map_columns_to / 32) = 1)) and ((raster_place_column / 32) = 1);
      end if;
      delay_tag_first_column_is_equal := raster_place_column = other_5;
      if delay_tag_map_column_value_4 then
        delay_tag_end_of_line_choice := (raster_place_column / 16) = 3;
      else
        delay_tag_end_of_line_choice := (raster_place_column / 16) = 2;
      end if;
      if delay_tag_map_column_value_4 then
        delay_tag_end_of_line_choice_2 := (raster_place_column / 16) = 1;
      else
        delay_tag_end_of_line_choice_2 := (raster_place_column / 16) = 0;
      end if;
      if (size_map_columns_to / 32) = 1 then
        delay_tag_end_of_line_choice_3 := delay_tag_end_of_line_choice;
      else
        delay_tag_end_of_line_choice_3 := delay_tag_end_of_line_choice_2;
      end if;
      delay_tag_end_of_line_value := (raster_place_column / 2) mod 4;
      if delay_tag_map_column_value then
        delay_tag_end_of_line_choice_4 := delay_tag_end_of_line_value = 3;
      else
        delay_tag_end_of_line_choice_4 := delay_tag_end_of_line_value = 2;
      end if;
      if delay_tag_map_column_value then
        delay_tag_end_of_line_choice_5 := delay_tag_end_of_line_value = 1;
      else
        delay_tag_end_of_line_choice_5 := delay_tag_end_of_line_value = 0;
      end if;
      if delay_tag_map_column_value_2 then
        delay_tag_end_of_line_choice_6 := delay_tag_end_of_line_choice_4;
      else
        delay_tag_end_of_line_choice_6 := delay_tag_end_of_line_choice_5;
      end if;
      delay_split_search_inside_0_is_equal := (raster_place_column / 2) = 0;
      delay_split_search_inside_0_value := ((delay_column / 16) mod 2) = 1;
      if delay_split_search_inside_0_value then
        delay_split_search_inside_0_choice := transform_counter_group_is_equal;
      else
        delay_split_search_inside_0_choice := transform_counter_group_is_equal_2;
      end if;
      if delay_split_search_inside_0_value then
        delay_split_search_inside_0_choice_2 := transform_counter_group_is_equal_3;
      else
        delay_split_search_inside_0_choice_2 := transform_counter_group_is_equal_4;
      end if;
      if (delay_column / 32) = 1 then
        delay_split_search_inside_0_choice_3 := delay_split_search_inside_0_choice;
      else
        delay_split_search_inside_0_choice_3 := delay_split_search_inside_0_choice_2;
      end if;
      delay_split_search_inside_0_value_2 := ((delay_column / 2) mod 2) = 1;
      if delay_split_search_inside_0_value_2 then
        delay_split_search_inside_0_choice_4 := transform_counter_group_is_equal_5;
      else
        delay_split_search_inside_0_choice_4 := transform_counter_group_is_equal_6;
      end if;
      if delay_split_search_inside_0_value_2 then
        delay_split_search_inside_0_choice_5 := transform_counter_group_is_equal_7;
      else
        delay_split_search_inside_0_choice_5 := transform_counter_group_is_equal_8;
      end if;
      if ((delay_column / 4) mod 2) = 1 then
        delay_split_search_inside_0_choice_6 := delay_split_search_inside_0_choice_4;
      else
        delay_split_search_inside_0_choice_6 := delay_split_search_inside_0_choice_5;
      end if;
      if delay_split_search_inside_0_choice_3 and ((((delay_column / 8) mod 2) = 1) /= (not
        transform_counter_group_value_10)) then
        delay_split_search_inside_0_choice_7 := (not (delay_split_search_inside_0_choice_6 and (((delay_column mod 2) =
          1) /= (not ((size_windows_last_column mod 2) = 1))))) and delay_tag_row_start_is_equal and
          raster_features_valid;
      else
        delay_split_search_inside_0_choice_7 := delay_tag_row_start_is_equal and raster_features_valid;
      end if;
      delay_split_search_inside_0_all := (not delay_split_search_inside_0_choice_7) and delay_split_inside_before_0;
      delay_split_inside_before_1_all := (not delay_split_search_inside_0_choice_7) and delay_split_inside_before_1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= delay_row_inside_0_all;
      delay_row_inside_1 <= delay_row_inside_1_is_less;
      delay_tag_valid <= raster_features_valid;
      delay_tag_row_start <= delay_tag_row_start_is_equal;
      delay_tag_first_group <= raster_place_group = 0;
      delay_tag_output_column <= raster_place_group_choice_5 and (not delay_tag_output_column_choice) and
        (raster_place_group /= 0) and delay_tag_map_column_is_not_less;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= delay_tag_end_of_line_choice_3 and delay_tag_end_of_line_choice_6 and
        (((size_map_columns_to mod 2) = 1) /= (not ((raster_place_column mod 2) = 1))) and
        (delay_tag_map_column_value_3 /= (not raster_place_group_value_10));
      delay_split_search_inside_1 <= rows_read_inside_1;
      if delay_tag_leaves_window_choice_5 then
        delay_tag_leaves_window <= delay_tag_leaves_window_is_not_less and (not ((raster_place_column / 32) = 1)) and
          ((size_windows_last_column / 32) = 1);
      else
        delay_tag_leaves_window <= delay_tag_leaves_window_is_not_less and ((not ((raster_place_column / 32) = 1)) or
          ((size_windows_last_column / 32) = 1));
      end if;
      if delay_tag_map_column_choice_5 then
        delay_tag_map_column <= delay_tag_map_column_is_not_less and ((size_map_columns_to / 32) = 1) and (not
          ((raster_place_column / 32) = 1));
      else
        delay_tag_map_column <= delay_tag_map_column_is_not_less and (((size_map_columns_to / 32) = 1) or (not
          ((raster_place_column / 32) = 1)));
      end if;
      if delay_split_search_inside_0_is_equal then
        delay_split_search_inside_0 <= delay_split_search_inside_0_all;
      else
        delay_split_search_inside_0 <= delay_row_inside_0_all;
      end if;
      if delay_split_search_inside_0_all then
        delay_split_inside_before_0 <= (not (raster_place_group_choice_8 and raster_place_group_choice_11 and
          raster_place_group_differs and raster_place_group_differs_2 and raster_features_valid)) or
          delay_row_inside_0_all;
      else
        delay_split_inside_before_0 <= raster_place_group_choice_8 and raster_place_group_choice_11 and
          raster_place_group_differs and raster_place_group_differs_2 and raster_features_valid and
          delay_row_inside_0_is_less and delay_row_inside_0_any;
      end if;
      if delay_split_inside_before_1_all then
        delay_split_inside_before_1 <= (not (raster_place_group_choice_8 and raster_place_group_choice_11 and
          raster_place_group_differs and raster_place_group_differs_2 and raster_features_valid)) or
          delay_row_inside_1_is_less;
      else
        delay_split_inside_before_1 <= raster_place_group_choice_8 and raster_place_group_choice_11 and
          raster_place_group_differs and raster_place_group_differs_2 and raster_features_valid and
          delay_row_inside_1_is_less;
      end if;
      -- rows
      rows_search_rows_read_newest_0 <= to_integer(delay_delayed_0);
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_words_1 <= to_integer(rows_search_rows_read_words_1);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_words_1 <= to_integer(rows_reference_rows_read_words_1);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside_0 <= delay_row_inside_0;
      rows_read_inside_1 <= delay_row_inside_1;
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_row_start <= delay_tag_row_start;
      rows_read_tag_first_group <= delay_tag_first_group;
      rows_read_tag_leaves_window <= delay_tag_leaves_window;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_read_search_inside_0 <= delay_split_search_inside_0;
      rows_read_search_inside_1 <= rows_ready_inside_1;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_row_start <= rows_read_tag_row_start;
      rows_ready_tag_first_group <= rows_read_tag_first_group;
      rows_ready_tag_leaves_window <= rows_read_tag_leaves_window;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_ready_search_inside_0 <= rows_read_search_inside_0;
      rows_ready_search_inside_1 <= rows_read_search_inside_1;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_row_start <= rows_ready_tag_row_start;
      rows_tag_first_group <= rows_ready_tag_first_group;
      rows_tag_leaves_window <= rows_ready_tag_leaves_window;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if delay_split_search_inside_0_is_equal then
        rows_ready_inside_1 <= delay_split_inside_before_1_all;
      else
        rows_ready_inside_1 <= delay_row_inside_1_is_less;
      end if;
      if rows_ready_search_inside_0 then
        rows_search_0 <= rows_search_rows_ready_words_0 mod 4096;
      else
        rows_search_0 <= 0;
      end if;
      if rows_ready_search_inside_1 then
        rows_search_1 <= rows_search_rows_ready_newest_0;
      else
        rows_search_1 <= 0;
      end if;
      if rows_ready_inside_0 then
        rows_reference_0 <= rows_reference_rows_ready_words_0 mod 4096;
      else
        rows_reference_0 <= 0;
      end if;
      if delay_split_search_inside_1 then
        rows_reference_1 <= rows_reference_rows_ready_newest_0;
      else
        rows_reference_1 <= 0;
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
        slice0shift_search_0_0 <= rows_search_0;
        slice0shift_search_0_1 <= slice0shift_search_0_0;
        slice0shift_search_0_2 <= slice0shift_search_0_1;
        slice0shift_search_0_3 <= slice0shift_search_0_2;
        slice0shift_search_0_4 <= slice0shift_search_0_3;
        slice0shift_search_0_5 <= slice0shift_search_0_4;
        slice0shift_search_1_0 <= rows_search_1;
        slice0shift_search_1_1 <= slice0shift_search_1_0;
        slice0shift_search_1_2 <= slice0shift_search_1_1;
        slice0shift_search_1_3 <= slice0shift_search_1_2;
        slice0shift_search_1_4 <= slice0shift_search_1_3;
        slice0shift_search_1_5 <= slice0shift_search_1_4;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_reference_1 <= rows_reference_1;
      slice0shift_search_out_0 <= slice0shift_search_0_5;
      slice0shift_search_out_1 <= slice0shift_search_1_5;
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_row_start <= rows_tag_row_start;
      slice0shift_tag_first_group <= rows_tag_first_group;
      slice0shift_tag_leaves_window <= rows_tag_leaves_window;
      slice0shift_tag_map_column <= rows_tag_map_column;
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
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_0_choice := 0;
      else
        slice0cost_column_0_0_choice := slice0cost_ready_words_0 mod 128;
      end if;
      slice0cost_column_0_0_value := (slice0cost_change_0_0 + slice0cost_column_0_0_choice) mod 128;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_1_choice := 0;
      else
        slice0cost_column_0_1_choice := (slice0cost_ready_words_0 / 128) mod 128;
      end if;
      slice0cost_column_0_1_value := (slice0cost_change_0_1 + slice0cost_column_0_1_choice) mod 128;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_2_choice := 0;
      else
        slice0cost_column_0_2_choice := (slice0cost_ready_words_0 / 16384) mod 128;
      end if;
      slice0cost_column_0_2_value := (slice0cost_change_0_2 + slice0cost_column_0_2_choice) mod 128;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_3_choice := 0;
      else
        slice0cost_column_0_3_choice := slice0cost_ready_words_0 / 2097152;
      end if;
      slice0cost_column_0_3_value := (slice0cost_column_0_3_choice + slice0cost_change_0_3) mod 128;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_4_choice := 0;
      else
        slice0cost_column_0_4_choice := slice0cost_ready_words_1 mod 128;
      end if;
      slice0cost_column_0_4_value := (slice0cost_change_0_4 + slice0cost_column_0_4_choice) mod 128;
      if slice0cost_ready_tag_first_group then
        slice0cost_column_0_5_choice := 0;
      else
        slice0cost_column_0_5_choice := slice0cost_ready_words_1 / 128;
      end if;
      slice0cost_column_0_5_value := (slice0cost_column_0_5_choice + slice0cost_change_0_5) mod 128;
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
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_row_start <= slice0shift_tag_row_start;
      slice0cost_pixels_first_tag_first_group <= slice0shift_tag_first_group;
      slice0cost_pixels_first_tag_leaves_window <= slice0shift_tag_leaves_window;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
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
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_row_start <= slice0cost_pixels_first_tag_row_start;
      slice0cost_pixels_tag_first_group <= slice0cost_pixels_first_tag_first_group;
      slice0cost_pixels_tag_leaves_window <= slice0cost_pixels_first_tag_leaves_window;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      slice0cost_change_0_0 <= slice0cost_pixels_cost_1_0 - slice0cost_pixels_cost_0_0;
      slice0cost_change_0_1 <= slice0cost_pixels_cost_1_1 - slice0cost_pixels_cost_0_1;
      slice0cost_change_0_2 <= slice0cost_pixels_cost_1_2 - slice0cost_pixels_cost_0_2;
      slice0cost_change_0_3 <= slice0cost_pixels_cost_1_3 - slice0cost_pixels_cost_0_3;
      slice0cost_change_0_4 <= slice0cost_pixels_cost_1_4 - slice0cost_pixels_cost_0_4;
      slice0cost_change_0_5 <= slice0cost_pixels_cost_1_5 - slice0cost_pixels_cost_0_5;
      slice0cost_ready_words_0 <= to_integer(slice0cost_read_words_0);
      slice0cost_ready_words_1 <= to_integer(slice0cost_read_words_1);
      slice0cost_ready_column <= slice0cost_change_column;
      slice0cost_ready_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_ready_tag_row_start <= slice0cost_pixels_tag_row_start;
      slice0cost_ready_tag_first_group <= slice0cost_pixels_tag_first_group;
      slice0cost_ready_tag_leaves_window <= slice0cost_pixels_tag_leaves_window;
      slice0cost_ready_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_ready_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_ready_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_ready_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_ready_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_column_0_0 <= slice0cost_column_0_0_value;
      slice0cost_column_0_1 <= slice0cost_column_0_1_value;
      slice0cost_column_0_2 <= slice0cost_column_0_2_value;
      slice0cost_column_0_3 <= slice0cost_column_0_3_value;
      slice0cost_column_0_4 <= slice0cost_column_0_4_value;
      slice0cost_column_0_5 <= slice0cost_column_0_5_value;
      slice0cost_write_column <= slice0cost_ready_column;
      slice0cost_tag_valid <= slice0cost_ready_tag_valid;
      slice0cost_tag_row_start <= slice0cost_ready_tag_row_start;
      slice0cost_tag_first_group <= slice0cost_ready_tag_first_group;
      slice0cost_tag_leaves_window <= slice0cost_ready_tag_leaves_window;
      slice0cost_tag_map_column <= slice0cost_ready_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_ready_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_ready_tag_first_column;
      slice0cost_tag_start_of_frame <= slice0cost_ready_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_ready_tag_end_of_line;
      if slice0shift_tag_valid then
        if slice0shift_tag_row_start then
          slice0cost_read_column <= 0;
        else
          slice0cost_read_column <= (slice0cost_read_column + 1) mod 64;
        end if;
      end if;
      if slice0cost_pixels_first_tag_valid then
        if slice0cost_pixels_first_tag_row_start then
          slice0cost_change_column <= 0;
        else
          slice0cost_change_column <= (slice0cost_change_column + 1) mod 64;
        end if;
      end if;
      if slice0cost_ready_tag_valid then
        slice0cost_write_words_0 <= (slice0cost_column_0_1_value * 128) + slice0cost_column_0_0_value +
          (slice0cost_column_0_2_value * 16384) + (slice0cost_column_0_3_value * 2097152);
        slice0cost_write_words_1 <= (slice0cost_column_0_5_value * 128) + slice0cost_column_0_4_value;
      end if;
      -- slice0window
      if slice0cost_tag_valid then
        slice0window_ring_write_address <= slice0window_ring_read_address;
        if slice0window_ring_read_address = 4 then
          slice0window_ring_read_address <= 0;
        else
          slice0window_ring_read_address <= (slice0window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_0_choice := to_integer(slice0window_leaving_0(6 downto 0));
      else
        slice0window_change_0_0_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_1_choice := to_integer(slice0window_leaving_0(13 downto 7));
      else
        slice0window_change_0_1_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_2_choice := to_integer(slice0window_leaving_0(20 downto 14));
      else
        slice0window_change_0_2_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_3_choice := to_integer(slice0window_leaving_0(27 downto 21));
      else
        slice0window_change_0_3_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_4_choice := to_integer(slice0window_leaving_1(6 downto 0));
      else
        slice0window_change_0_4_choice := 0;
      end if;
      if slice0window_entering_tag_leaves_window then
        slice0window_change_0_5_choice := to_integer(slice0window_leaving_1(13 downto 7));
      else
        slice0window_change_0_5_choice := 0;
      end if;
      slice0window_entering_0_0 <= slice0cost_column_0_0;
      slice0window_entering_0_1 <= slice0cost_column_0_1;
      slice0window_entering_0_2 <= slice0cost_column_0_2;
      slice0window_entering_0_3 <= slice0cost_column_0_3;
      slice0window_entering_0_4 <= slice0cost_column_0_4;
      slice0window_entering_0_5 <= slice0cost_column_0_5;
      slice0window_entering_tag_valid <= slice0cost_tag_valid;
      slice0window_entering_tag_row_start <= slice0cost_tag_row_start;
      slice0window_entering_tag_leaves_window <= slice0cost_tag_leaves_window;
      slice0window_entering_tag_map_column <= slice0cost_tag_map_column;
      slice0window_entering_tag_output_column <= slice0cost_tag_output_column;
      slice0window_entering_tag_first_column <= slice0cost_tag_first_column;
      slice0window_entering_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_entering_tag_end_of_line <= slice0cost_tag_end_of_line;
      slice0window_change_0_0 <= slice0window_entering_0_0 - slice0window_change_0_0_choice;
      slice0window_change_0_1 <= slice0window_entering_0_1 - slice0window_change_0_1_choice;
      slice0window_change_0_2 <= slice0window_entering_0_2 - slice0window_change_0_2_choice;
      slice0window_change_0_3 <= slice0window_entering_0_3 - slice0window_change_0_3_choice;
      slice0window_change_0_4 <= slice0window_entering_0_4 - slice0window_change_0_4_choice;
      slice0window_change_0_5 <= slice0window_entering_0_5 - slice0window_change_0_5_choice;
      slice0window_change_tag_valid <= slice0window_entering_tag_valid;
      slice0window_change_tag_row_start <= slice0window_entering_tag_row_start;
      slice0window_change_tag_leaves_window <= slice0window_entering_tag_leaves_window;
      slice0window_change_tag_map_column <= slice0window_entering_tag_map_column;
      slice0window_change_tag_output_column <= slice0window_entering_tag_output_column;
      slice0window_change_tag_first_column <= slice0window_entering_tag_first_column;
      slice0window_change_tag_start_of_frame <= slice0window_entering_tag_start_of_frame;
      slice0window_change_tag_end_of_line <= slice0window_entering_tag_end_of_line;
      slice0window_centre_map_column_0 <= slice0window_change_tag_map_column;
      slice0window_centre_end_of_line_0 <= slice0window_change_tag_end_of_line;
      slice0window_tag_valid <= slice0window_change_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column_1;
      slice0window_tag_first_column <= slice0window_centre_first_column_1;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_0_choice := 0;
      else
        slice0window_sum_0_0_choice := slice0window_sum_0_0;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_1_choice := 0;
      else
        slice0window_sum_0_1_choice := slice0window_sum_0_1;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_2_choice := 0;
      else
        slice0window_sum_0_2_choice := slice0window_sum_0_2;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_3_choice := 0;
      else
        slice0window_sum_0_3_choice := slice0window_sum_0_3;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_4_choice := 0;
      else
        slice0window_sum_0_4_choice := slice0window_sum_0_4;
      end if;
      if slice0window_change_tag_row_start then
        slice0window_sum_0_5_choice := 0;
      else
        slice0window_sum_0_5_choice := slice0window_sum_0_5;
      end if;
      if slice0window_change_tag_valid then
        slice0window_sum_0_0 <= (slice0window_sum_0_0_choice + slice0window_change_0_0) mod 512;
        slice0window_sum_0_1 <= (slice0window_sum_0_1_choice + slice0window_change_0_1) mod 512;
        slice0window_sum_0_2 <= (slice0window_sum_0_2_choice + slice0window_change_0_2) mod 512;
        slice0window_sum_0_3 <= (slice0window_sum_0_3_choice + slice0window_change_0_3) mod 512;
        slice0window_sum_0_4 <= (slice0window_sum_0_4_choice + slice0window_change_0_4) mod 512;
        slice0window_sum_0_5 <= (slice0window_sum_0_5_choice + slice0window_change_0_5) mod 512;
        slice0window_centre_output_column_0 <= slice0window_change_tag_output_column;
        slice0window_centre_output_column_1 <= slice0window_centre_output_column_0;
        slice0window_centre_first_column_0 <= slice0window_change_tag_first_column;
        slice0window_centre_first_column_1 <= slice0window_centre_first_column_0;
        slice0window_centre_start_of_frame_0 <= slice0window_change_tag_start_of_frame;
      end if;
      if slice0window_tag_valid then
        slice0window_centre_start_of_frame_1 <= slice1window_change_tag_start_of_frame;
        slice0window_tag_map_column <= slice1window_centre_map_column_0;
        slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_1;
        slice0window_tag_end_of_line <= slice1window_centre_end_of_line_0;
      end if;
      -- slice0mask
      if (slice0mask_end_value mod 2) = 1 then
        slice0mask_inside_0_choice := (not (((slice0mask_column / 2) mod 2) = 1)) or (not ((slice0mask_column mod 2) =
          1));
      else
        slice0mask_inside_0_choice := not (((slice0mask_column / 2) mod 2) = 1);
      end if;
      if ((slice0mask_end_value / 2) mod 2) = 1 then
        slice0mask_inside_0_choice_2 := slice0mask_inside_0_choice;
      else
        slice0mask_inside_0_choice_2 := ((slice0mask_end_value mod 2) = 1) and ((slice0mask_column mod 4) = 0);
      end if;
      slice0mask_inside_0_value := ((slice0mask_column / 4) mod 2) = 1;
      if slice0mask_inside_0_choice_2 then
        slice0mask_inside_0_choice_3 := (not (((slice0mask_end_value / 4) mod 2) = 1)) and slice0mask_inside_0_value;
      else
        slice0mask_inside_0_choice_3 := (not (((slice0mask_end_value / 4) mod 2) = 1)) or slice0mask_inside_0_value;
      end if;
      slice0mask_inside_0_value_2 := ((slice0mask_column / 8) mod 2) = 1;
      if slice0mask_inside_0_choice_3 then
        slice0mask_inside_0_choice_4 := (not (((slice0mask_end_value / 8) mod 2) = 1)) or slice0mask_inside_0_value_2;
      else
        slice0mask_inside_0_choice_4 := (not (((slice0mask_end_value / 8) mod 2) = 1)) and slice0mask_inside_0_value_2;
      end if;
      slice0mask_inside_0_value_3 := ((slice0mask_column / 16) mod 2) = 1;
      if slice0mask_inside_0_choice_4 then
        slice0mask_inside_0_choice_5 := (not (((slice0mask_end_value / 16) mod 2) = 1)) or slice0mask_inside_0_value_3;
      else
        slice0mask_inside_0_choice_5 := (not (((slice0mask_end_value / 16) mod 2) = 1)) and slice0mask_inside_0_value_3;
      end if;
      slice0mask_inside_0_differs := slice0mask_column /= 0;
      if slice0mask_inside_0_choice_5 then
        slice0mask_inside_0_choice_6 := slice0mask_inside_0_differs and ((slice0mask_end_value / 32) = 1) and (not
          ((slice0mask_column / 32) = 1));
      else
        slice0mask_inside_0_choice_6 := slice0mask_inside_0_differs and (((slice0mask_end_value / 32) = 1) or (not
          ((slice0mask_column / 32) = 1)));
      end if;
      slice0mask_inside_0_all := (not slice0window_change_tag_valid) and slice0mask_inside_0;
      if slice0window_centre_first_column_1 then
        slice0mask_inside_0_choice_7 := slice0mask_inside_0_all;
      else
        slice0mask_inside_0_choice_7 := slice0window_change_tag_valid or slice0mask_inside_0;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_1_choice := slice0mask_inside_0;
      else
        slice0mask_inside_1_choice := slice0mask_inside_1;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_2_choice := slice0mask_inside_1;
      else
        slice0mask_inside_2_choice := slice0mask_inside_2;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_3_choice := slice0mask_inside_2;
      else
        slice0mask_inside_3_choice := slice0mask_inside_3;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_4_choice := slice0mask_inside_3;
      else
        slice0mask_inside_4_choice := slice0mask_inside_4;
      end if;
      if slice0window_change_tag_valid then
        slice0mask_inside_5_choice := slice0mask_inside_4;
      else
        slice0mask_inside_5_choice := slice0mask_inside_5;
      end if;
      slice0mask_left_out <= slice0mask_inside_5;
      slice0mask_end_value <= (size_windows_last_column + 63) mod 64;
      if slice0mask_inside_0_choice_6 then
        slice0mask_inside_0 <= slice0mask_inside_0_choice_7;
      else
        slice0mask_inside_0 <= slice0mask_inside_0_all;
      end if;
      if slice0window_centre_first_column_1 then
        slice0mask_inside_1 <= (not slice0window_change_tag_valid) and slice0mask_inside_1;
        slice0mask_inside_2 <= (not slice0window_change_tag_valid) and slice0mask_inside_2;
        slice0mask_inside_3 <= (not slice0window_change_tag_valid) and slice0mask_inside_3;
        slice0mask_inside_4 <= (not slice0window_change_tag_valid) and slice0mask_inside_4;
        slice0mask_inside_5 <= (not slice0window_change_tag_valid) and slice0mask_inside_5;
      else
        slice0mask_inside_1 <= slice0mask_inside_1_choice;
        slice0mask_inside_2 <= slice0mask_inside_2_choice;
        slice0mask_inside_3 <= slice0mask_inside_3_choice;
        slice0mask_inside_4 <= slice0mask_inside_4_choice;
        slice0mask_inside_5 <= slice0mask_inside_5_choice;
      end if;
      if slice0window_change_tag_valid then
        if slice0window_centre_first_column_1 then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 64;
        end if;
      end if;
      -- slice0other
      slice0other_cost_0_1_all := slice0window_tag_output_column and slice0window_tag_first_column;
      if (slice0window_sum_0_1 - slice0other_cost_0_0) < 0 then
        slice0other_cost_0_1_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_1_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_1_all_2 := other_26 and slice0mask_inside_1 and slice0other_cost_0_1_choice;
      if slice0window_tag_first_column then
        slice0other_cost_0_1_choice_2 := 511;
      else
        slice0other_cost_0_1_choice_2 := slice0other_cost_0_0;
      end if;
      if (slice0window_sum_0_2 - slice0other_cost_0_1) < 0 then
        slice0other_cost_0_2_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_2_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_2_all := other_25 and slice0mask_inside_2 and slice0other_cost_0_2_choice;
      if slice0window_tag_first_column then
        slice0other_cost_0_2_choice_2 := 511;
      else
        slice0other_cost_0_2_choice_2 := slice0other_cost_0_1;
      end if;
      if (slice0window_sum_0_3 - slice0other_cost_0_2) < 0 then
        slice0other_cost_0_3_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_3_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_3_all := other_24 and slice0mask_inside_3 and slice0other_cost_0_3_choice;
      if slice0window_tag_first_column then
        slice0other_cost_0_3_choice_2 := 511;
      else
        slice0other_cost_0_3_choice_2 := slice0other_cost_0_2;
      end if;
      if (slice0window_sum_0_4 - slice0other_cost_0_3) < 0 then
        slice0other_cost_0_4_choice := slice0window_tag_output_column;
      else
        slice0other_cost_0_4_choice := slice0other_cost_0_1_all;
      end if;
      slice0other_cost_0_4_all := other_23 and slice0mask_inside_4 and slice0other_cost_0_4_choice;
      if slice0window_tag_first_column then
        slice0other_cost_0_4_choice_2 := 511;
      else
        slice0other_cost_0_4_choice_2 := slice0other_cost_0_3;
      end if;
      slice0other_cost_0_5_all := other_22 and slice0mask_inside_5 and slice0window_tag_output_column and
        (((slice0window_sum_0_5 - slice0other_cost_0_4) < 0) or slice0window_tag_first_column);
      if slice0window_tag_first_column then
        slice0other_cost_0_5_choice := 511;
      else
        slice0other_cost_0_5_choice := slice0other_cost_0_4;
      end if;
      if slice0window_tag_valid then
        slice0other_winner_0_1 <= slice0other_cost_0_1_all_2;
        if slice0window_tag_output_column and other_27 and slice0mask_inside_0 then
          slice0other_cost_0_0 <= slice0window_sum_0_0;
        else
          slice0other_cost_0_0 <= 511;
        end if;
        if slice0other_cost_0_1_all_2 then
          slice0other_cost_0_1 <= slice0window_sum_0_1;
        else
          slice0other_cost_0_1 <= slice0other_cost_0_1_choice_2;
        end if;
        if slice0other_cost_0_2_all then
          slice0other_cost_0_2 <= slice0window_sum_0_2;
          slice0other_winner_0_2 <= 2;
        else
          slice0other_cost_0_2 <= slice0other_cost_0_2_choice_2;
          slice0other_winner_0_2 <= as_number(slice0other_winner_0_1);
        end if;
        if slice0other_cost_0_3_all then
          slice0other_cost_0_3 <= slice0window_sum_0_3;
          slice0other_winner_0_3 <= 3;
        else
          slice0other_cost_0_3 <= slice0other_cost_0_3_choice_2;
          slice0other_winner_0_3 <= slice0other_winner_0_2;
        end if;
        if slice0other_cost_0_4_all then
          slice0other_cost_0_4 <= slice0window_sum_0_4;
          slice0other_winner_0_4 <= 4;
        else
          slice0other_cost_0_4 <= slice0other_cost_0_4_choice_2;
          slice0other_winner_0_4 <= slice0other_winner_0_3;
        end if;
        if slice0other_cost_0_5_all then
          slice0other_cost_0_5 <= slice0window_sum_0_5;
          slice0other_winner_0_5 <= 5;
        else
          slice0other_cost_0_5 <= slice0other_cost_0_5_choice;
          slice0other_winner_0_5 <= slice0other_winner_0_4;
        end if;
      end if;
      slice0other_cost_out_0 <= slice0other_cost_0_5;
      slice0other_winner_out_0 <= slice0other_winner_0_5;
      -- slice0winner1
      if (not other_27) or (not slice0mask_inside_0) then
        slice0winner1_held_0_0_choice := 511;
      else
        slice0winner1_held_0_0_choice := 0;
      end if;
      slice0winner1_held_0_0_any := to_integer(((to_unsigned(slice0window_sum_0_0, 9)) or
        (to_unsigned(slice0winner1_held_0_0_choice, 9))));
      if (not other_26) or (not slice0mask_inside_1) then
        slice0winner1_held_0_1_choice := 511;
      else
        slice0winner1_held_0_1_choice := 0;
      end if;
      slice0winner1_held_0_1_any := to_integer(((to_unsigned(slice0window_sum_0_1, 9)) or
        (to_unsigned(slice0winner1_held_0_1_choice, 9))));
      if (not other_25) or (not slice0mask_inside_2) then
        slice0winner1_held_0_2_choice := 511;
      else
        slice0winner1_held_0_2_choice := 0;
      end if;
      slice0winner1_held_0_2_any := to_integer(((to_unsigned(slice0window_sum_0_2, 9)) or
        (to_unsigned(slice0winner1_held_0_2_choice, 9))));
      if (not other_24) or (not slice0mask_inside_3) then
        slice0winner1_held_0_3_choice := 511;
      else
        slice0winner1_held_0_3_choice := 0;
      end if;
      slice0winner1_held_0_3_any := to_integer(((to_unsigned(slice0window_sum_0_3, 9)) or
        (to_unsigned(slice0winner1_held_0_3_choice, 9))));
      if (not other_23) or (not slice0mask_inside_4) then
        slice0winner1_held_0_4_choice := 511;
      else
        slice0winner1_held_0_4_choice := 0;
      end if;
      slice0winner1_held_0_4_any := to_integer(((to_unsigned(slice0window_sum_0_4, 9)) or
        (to_unsigned(slice0winner1_held_0_4_choice, 9))));
      if (not other_22) or (not slice0mask_inside_5) then
        slice0winner1_held_0_5_choice := 511;
      else
        slice0winner1_held_0_5_choice := 0;
      end if;
      slice0winner1_held_0_5_any := to_integer(((to_unsigned(slice0window_sum_0_5, 9)) or
        (to_unsigned(slice0winner1_held_0_5_choice, 9))));
      slice0winner1_best_cost_0_0_is_less := (slice0winner1_held_0_1_any - slice0winner1_held_0_0_any) < 0;
      slice0winner1_best_cost_0_1_is_less := (slice0winner1_held_0_3_any - slice0winner1_held_0_2_any) < 0;
      slice0winner1_best_cost_0_2_is_less := (slice0winner1_held_0_5_any - slice0winner1_held_0_4_any) < 0;
      slice0winner1_held_0_0 <= slice0winner1_held_0_0_any;
      slice0winner1_held_0_1 <= slice0winner1_held_0_1_any;
      slice0winner1_held_0_2 <= slice0winner1_held_0_2_any;
      slice0winner1_held_0_3 <= slice0winner1_held_0_3_any;
      slice0winner1_held_0_4 <= slice0winner1_held_0_4_any;
      slice0winner1_held_0_5 <= slice0winner1_held_0_5_any;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_late_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0winner1_best_late_cost_0_1 <= slice0winner1_best_cost_0_1;
      slice0winner1_best_late_cost_0_2 <= slice0winner1_best_cost_0_2;
      slice0winner1_best_but_first_0_1 <= slice0winner1_held_0_3;
      slice0winner1_best_but_first_0_2 <= slice0winner1_held_0_5;
      slice0winner1_best_but_last_0_0 <= slice0winner1_held_0_0;
      slice0winner1_best_but_last_0_1 <= slice0winner1_held_0_2;
      slice0winner1_best_but_last_0_2 <= slice0winner1_held_0_4;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      slice0winner1_tag_map_column <= slice0window_tag_map_column;
      slice0winner1_tag_output_column <= slice1window_centre_output_column_1;
      slice0winner1_tag_first_column <= slice1window_centre_first_column_1;
      slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
      slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0winner1_held_0_1_any;
        slice0winner1_best_below_0_0 <= slice0winner1_held_0_0_any;
        slice0winner1_best_above_0_0 <= 0;
      else
        slice0winner1_best_cost_0_0 <= slice0winner1_held_0_0_any;
        slice0winner1_best_below_0_0 <= 0;
        slice0winner1_best_above_0_0 <= slice0winner1_held_0_1_any;
      end if;
      if slice0winner1_best_cost_0_1_is_less then
        slice0winner1_best_cost_0_1 <= slice0winner1_held_0_3_any;
        slice0winner1_best_index_0_1 <= 3;
        slice0winner1_best_below_0_1 <= slice0winner1_held_0_2_any;
        slice0winner1_best_above_0_1 <= 0;
      else
        slice0winner1_best_cost_0_1 <= slice0winner1_held_0_2_any;
        slice0winner1_best_index_0_1 <= 2;
        slice0winner1_best_below_0_1 <= 0;
        slice0winner1_best_above_0_1 <= slice0winner1_held_0_3_any;
      end if;
      if slice0winner1_best_cost_0_2_is_less then
        slice0winner1_best_cost_0_2 <= slice0winner1_held_0_5_any;
        slice0winner1_best_index_0_2 <= 5;
        slice0winner1_best_below_0_2 <= slice0winner1_held_0_4_any;
        slice0winner1_best_above_0_2 <= 0;
      else
        slice0winner1_best_cost_0_2 <= slice0winner1_held_0_4_any;
        slice0winner1_best_index_0_2 <= 4;
        slice0winner1_best_below_0_2 <= 0;
        slice0winner1_best_above_0_2 <= slice0winner1_held_0_5_any;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_best_cost_0_1 - slice0winner1_best_cost_0_0) < 0;
      slice0winner2_best_below_0_0_is_equal := slice0winner1_best_index_0_1 = 2;
      if slice0winner2_best_below_0_0_is_equal then
        slice0winner2_best_below_0_0_choice := slice0winner1_held_0_1;
      else
        slice0winner2_best_below_0_0_choice := slice0winner1_best_below_0_1;
      end if;
      if slice0winner1_best_index_0_0 then
        slice0winner2_best_above_0_0_choice := slice0winner1_held_0_2;
      else
        slice0winner2_best_above_0_0_choice := slice0winner1_best_above_0_0;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice := 511;
      else
        slice0winner2_best_second_0_0_choice := slice0winner1_best_late_cost_0_1;
      end if;
      if slice0winner2_best_at_end_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_but_first_0_1;
      else
        slice0winner2_best_second_0_0_choice_2 := slice0winner2_best_second_0_0_choice;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice_3 := slice0winner1_best_late_cost_0_0;
      else
        slice0winner2_best_second_0_0_choice_3 := 511;
      end if;
      if slice0winner2_best_at_start_0_0 then
        slice0winner2_best_second_0_0_choice_4 := slice0winner1_best_but_last_0_0;
      else
        slice0winner2_best_second_0_0_choice_4 := slice0winner2_best_second_0_0_choice_3;
      end if;
      slice0winner2_best_index_0_1 <= slice0winner1_best_index_0_2;
      slice0winner2_best_below_0_1 <= slice0winner1_best_below_0_2;
      slice0winner2_best_above_0_1 <= slice0winner1_best_above_0_2;
      slice0winner2_best_first_0_1 <= slice0winner1_held_0_4;
      slice0winner2_best_last_0_0 <= slice0winner1_held_0_3;
      slice0winner2_best_last_0_1 <= slice0winner1_held_0_5;
      slice0winner2_best_place_0_0 <= slice0winner2_best_cost_0_0_is_less;
      slice0winner2_best_at_start_0_0 <= slice0winner2_best_cost_0_0_is_less and slice0winner2_best_below_0_0_is_equal;
      slice0winner2_best_at_end_0_0 <= slice0winner1_best_index_0_0 and ((slice0winner1_best_cost_0_1 -
        slice0winner1_best_cost_0_0) >= 0);
      slice0winner2_best_late_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0winner2_best_late_cost_0_1 <= slice0winner1_best_late_cost_0_2;
      slice0winner2_best_but_first_0_1 <= slice0winner1_best_but_first_0_2;
      slice0winner2_best_but_last_0_1 <= slice0winner1_best_but_last_0_2;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_map_column <= slice0winner1_tag_map_column;
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
      if (slice0winner2_best_second_0_0_choice_2 - slice0winner2_best_second_0_0_choice_4) < 0 then
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_2;
      else
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_4;
      end if;
      if (slice0winner1_best_but_last_0_1 - slice0winner1_best_late_cost_0_0) < 0 then
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_but_last_0_1;
      else
        slice0winner2_best_but_last_0_0 <= slice0winner1_best_late_cost_0_0;
      end if;
      -- slice0winner3
      slice0winner3_best_cost_0_0_is_less := (slice0winner1_best_late_cost_0_2 - slice0winner2_best_cost_0_0) < 0;
      if ((slice0winner2_best_index_0_1 / 4) = 1) and (not ((slice0winner2_best_index_0_1 mod 2) = 1)) then
        slice0winner3_best_below_0_0_choice := slice0winner2_best_last_0_0;
      else
        slice0winner3_best_below_0_0_choice := slice0winner2_best_below_0_1;
      end if;
      slice0winner3_best_above_0_0_is_equal := slice0winner2_best_index_0_0 = 3;
      if slice0winner3_best_above_0_0_is_equal then
        slice0winner3_best_above_0_0_choice := slice0winner2_best_first_0_1;
      else
        slice0winner3_best_above_0_0_choice := slice0winner2_best_above_0_0;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice := 511;
      else
        slice0winner3_best_second_0_0_choice := slice0winner2_best_late_cost_0_1;
      end if;
      if slice0winner3_best_at_end_0_0 then
        slice0winner3_best_second_0_0_choice_2 := slice0winner2_best_but_first_0_1;
      else
        slice0winner3_best_second_0_0_choice_2 := slice0winner3_best_second_0_0_choice;
      end if;
      if slice0winner3_best_place_0_0 then
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_late_cost_0_0;
      else
        slice0winner3_best_second_0_0_choice_3 := slice0winner2_best_second_0_0;
      end if;
      if slice0winner3_best_at_start_0_0 then
        slice0winner3_best_second_0_0_choice_4 := slice0winner2_best_but_last_0_0;
      else
        slice0winner3_best_second_0_0_choice_4 := slice0winner3_best_second_0_0_choice_3;
      end if;
      slice0winner3_best_last_0_0 <= slice0winner2_best_last_0_1;
      slice0winner3_best_place_0_0 <= slice0winner3_best_cost_0_0_is_less;
      slice0winner3_best_at_start_0_0 <= slice0winner3_best_cost_0_0_is_less and ((slice0winner2_best_index_0_1 / 4) =
        1) and (not ((slice0winner2_best_index_0_1 mod 2) = 1));
      slice0winner3_best_at_end_0_0 <= ((slice0winner1_best_late_cost_0_2 - slice0winner2_best_cost_0_0) >= 0) and
        slice0winner3_best_above_0_0_is_equal;
      slice0winner3_best_late_cost_0_0 <= slice0winner3_best_cost_0_0;
      slice0winner3_tag_valid <= slice0winner2_tag_valid;
      slice0winner3_tag_map_column <= slice0winner2_tag_map_column;
      slice0winner3_tag_output_column <= slice0winner2_tag_output_column;
      slice0winner3_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0winner3_tag_end_of_line <= slice0winner2_tag_end_of_line;
      if slice0winner3_best_cost_0_0_is_less then
        slice0winner3_best_cost_0_0 <= slice0winner1_best_late_cost_0_2;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_1;
        slice0winner3_best_below_0_0 <= slice0winner3_best_below_0_0_choice;
        slice0winner3_best_above_0_0 <= slice0winner2_best_above_0_1;
      else
        slice0winner3_best_cost_0_0 <= slice0winner2_best_cost_0_0;
        slice0winner3_best_index_0_0 <= slice0winner2_best_index_0_0;
        slice0winner3_best_below_0_0 <= slice0winner2_best_below_0_0;
        slice0winner3_best_above_0_0 <= slice0winner3_best_above_0_0_choice;
      end if;
      if (slice0winner3_best_second_0_0_choice_2 - slice0winner3_best_second_0_0_choice_4) < 0 then
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_2;
      else
        slice0winner3_best_second_0_0 <= slice0winner3_best_second_0_0_choice_4;
      end if;
      if (slice0winner2_best_but_last_0_1 - slice0winner2_best_late_cost_0_0) < 0 then
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_but_last_0_1;
      else
        slice0winner3_best_but_last_0_0 <= slice0winner2_best_late_cost_0_0;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner3_best_index_0_0;
      slice0_best_below_0_0 <= slice0winner3_best_below_0_0;
      slice0_best_above_0_0 <= slice0winner3_best_above_0_0;
      slice0_best_last_0_0 <= slice0winner3_best_last_0_0;
      slice0_best_late_cost_0_0 <= slice0winner3_best_late_cost_0_0;
      slice0_best_second_0_0 <= slice0winner3_best_second_0_0;
      slice0_best_but_last_0_0 <= slice0winner3_best_but_last_0_0;
      slice0_best_tag_valid <= slice0winner3_tag_valid;
      slice0_best_tag_map_column <= slice0winner3_tag_map_column;
      slice0_best_tag_output_column <= slice0winner3_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner3_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner3_tag_end_of_line;
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0_0 <= slice0shift_search_out_0;
        slice1shift_search_0_1 <= slice1shift_search_0_0;
        slice1shift_search_0_2 <= slice1shift_search_0_1;
        slice1shift_search_0_3 <= slice1shift_search_0_2;
        slice1shift_search_0_4 <= slice1shift_search_0_3;
        slice1shift_search_0_5 <= slice1shift_search_0_4;
        slice1shift_search_1_0 <= slice0shift_search_out_1;
        slice1shift_search_1_1 <= slice1shift_search_1_0;
        slice1shift_search_1_2 <= slice1shift_search_1_1;
        slice1shift_search_1_3 <= slice1shift_search_1_2;
        slice1shift_search_1_4 <= slice1shift_search_1_3;
        slice1shift_search_1_5 <= slice1shift_search_1_4;
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
        slice1cost_column_0_0_choice := slice1cost_ready_words_0 mod 128;
      end if;
      slice1cost_column_0_0_value := (slice1cost_change_0_0 + slice1cost_column_0_0_choice) mod 128;
      if slice0cost_tag_first_group then
        slice1cost_column_0_1_choice := 0;
      else
        slice1cost_column_0_1_choice := (slice1cost_ready_words_0 / 128) mod 128;
      end if;
      slice1cost_column_0_1_value := (slice1cost_change_0_1 + slice1cost_column_0_1_choice) mod 128;
      if slice0cost_tag_first_group then
        slice1cost_column_0_2_choice := 0;
      else
        slice1cost_column_0_2_choice := (slice1cost_ready_words_0 / 16384) mod 128;
      end if;
      slice1cost_column_0_2_value := (slice1cost_change_0_2 + slice1cost_column_0_2_choice) mod 128;
      if slice0cost_tag_first_group then
        slice1cost_column_0_3_choice := 0;
      else
        slice1cost_column_0_3_choice := slice1cost_ready_words_0 / 2097152;
      end if;
      slice1cost_column_0_3_value := (slice1cost_column_0_3_choice + slice1cost_change_0_3) mod 128;
      if slice0cost_tag_first_group then
        slice1cost_column_0_4_choice := 0;
      else
        slice1cost_column_0_4_choice := slice1cost_ready_words_1 mod 128;
      end if;
      slice1cost_column_0_4_value := (slice1cost_change_0_4 + slice1cost_column_0_4_choice) mod 128;
      if slice0cost_tag_first_group then
        slice1cost_column_0_5_choice := 0;
      else
        slice1cost_column_0_5_choice := slice1cost_ready_words_1 / 128;
      end if;
      slice1cost_column_0_5_value := (slice1cost_column_0_5_choice + slice1cost_change_0_5) mod 128;
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
      slice1cost_read_column <= slice0cost_read_column;
      slice1cost_change_column <= slice1cost_read_column;
      slice1cost_change_0_0 <= slice1cost_pixels_cost_1_0 - slice1cost_pixels_cost_0_0;
      slice1cost_change_0_1 <= slice1cost_pixels_cost_1_1 - slice1cost_pixels_cost_0_1;
      slice1cost_change_0_2 <= slice1cost_pixels_cost_1_2 - slice1cost_pixels_cost_0_2;
      slice1cost_change_0_3 <= slice1cost_pixels_cost_1_3 - slice1cost_pixels_cost_0_3;
      slice1cost_change_0_4 <= slice1cost_pixels_cost_1_4 - slice1cost_pixels_cost_0_4;
      slice1cost_change_0_5 <= slice1cost_pixels_cost_1_5 - slice1cost_pixels_cost_0_5;
      slice1cost_ready_words_0 <= to_integer(slice1cost_read_words_0);
      slice1cost_ready_words_1 <= to_integer(slice1cost_read_words_1);
      slice1cost_column_0_0 <= slice1cost_column_0_0_value;
      slice1cost_column_0_1 <= slice1cost_column_0_1_value;
      slice1cost_column_0_2 <= slice1cost_column_0_2_value;
      slice1cost_column_0_3 <= slice1cost_column_0_3_value;
      slice1cost_column_0_4 <= slice1cost_column_0_4_value;
      slice1cost_column_0_5 <= slice1cost_column_0_5_value;
      if slice0cost_ready_tag_valid then
        slice1cost_ready_column <= slice1cost_change_column;
      end if;
      if slice0cost_tag_valid then
        slice1cost_write_column <= slice0cost_write_column;
        slice1cost_write_words_0 <= (slice1cost_column_0_1_value * 128) + slice1cost_column_0_0_value +
          (slice1cost_column_0_2_value * 16384) + (slice1cost_column_0_3_value * 2097152);
        slice1cost_write_words_1 <= (slice1cost_column_0_5_value * 128) + slice1cost_column_0_4_value;
      end if;
      -- slice1window
      if slice0window_entering_tag_valid then
        slice1window_ring_write_address <= slice1window_ring_read_address;
        if slice1window_ring_read_address = 4 then
          slice1window_ring_read_address <= 0;
        else
          slice1window_ring_read_address <= (slice1window_ring_read_address + 1) mod 8;
        end if;
      end if;
      if (not slice1mask_searched_5) or (not slice1mask_inside_5) then
        slice1window_entering_tag_border_column_choice := 511;
      else
        slice1window_entering_tag_border_column_choice := 0;
      end if;
      slice1window_entering_tag_border_column_any := to_integer(((to_unsigned(slice1window_sum_0_5, 9)) or
        (to_unsigned(slice1window_entering_tag_border_column_choice, 9))));
      if (not other_17) or (not slice1mask_inside_4) then
        slice1window_entering_tag_border_column_choice_2 := 511;
      else
        slice1window_entering_tag_border_column_choice_2 := 0;
      end if;
      slice1window_entering_tag_border_column_any_2 := to_integer(((to_unsigned(slice1window_sum_0_4, 9)) or
        (to_unsigned(slice1window_entering_tag_border_column_choice_2, 9))));
      slice1window_entering_tag_border_column_is_less := (slice1window_entering_tag_border_column_any -
        slice1window_entering_tag_border_column_any_2) < 0;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_0_choice := to_integer(slice1window_leaving_0(6 downto 0));
      else
        slice1window_change_0_0_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_1_choice := to_integer(slice1window_leaving_0(13 downto 7));
      else
        slice1window_change_0_1_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_2_choice := to_integer(slice1window_leaving_0(20 downto 14));
      else
        slice1window_change_0_2_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_3_choice := to_integer(slice1window_leaving_0(27 downto 21));
      else
        slice1window_change_0_3_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_4_choice := to_integer(slice1window_leaving_1(6 downto 0));
      else
        slice1window_change_0_4_choice := 0;
      end if;
      if slice0window_change_tag_leaves_window then
        slice1window_change_0_5_choice := to_integer(slice1window_leaving_1(13 downto 7));
      else
        slice1window_change_0_5_choice := 0;
      end if;
      slice1window_entering_0_0 <= slice1cost_column_0_0;
      slice1window_entering_0_1 <= slice1cost_column_0_1;
      slice1window_entering_0_2 <= slice1cost_column_0_2;
      slice1window_entering_0_3 <= slice1cost_column_0_3;
      slice1window_entering_0_4 <= slice1cost_column_0_4;
      slice1window_entering_0_5 <= slice1cost_column_0_5;
      slice1window_change_0_0 <= slice1window_entering_0_0 - slice1window_change_0_0_choice;
      slice1window_change_0_1 <= slice1window_entering_0_1 - slice1window_change_0_1_choice;
      slice1window_change_0_2 <= slice1window_entering_0_2 - slice1window_change_0_2_choice;
      slice1window_change_0_3 <= slice1window_entering_0_3 - slice1window_change_0_3_choice;
      slice1window_change_0_4 <= slice1window_entering_0_4 - slice1window_change_0_4_choice;
      slice1window_change_0_5 <= slice1window_entering_0_5 - slice1window_change_0_5_choice;
      slice1window_change_tag_row_start <= slice0window_change_tag_row_start;
      slice1window_change_tag_output_column <= slice0window_change_tag_output_column;
      slice1window_change_tag_first_column <= slice0window_change_tag_first_column;
      slice1window_change_tag_start_of_frame <= slice0window_change_tag_start_of_frame;
      if slice1window_entering_tag_border_column_is_less then
        slice1window_entering_tag_border_column <= slice1window_entering_tag_border_column_any_2;
      else
        slice1window_entering_tag_border_column <= 0;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_0_choice := 0;
      else
        slice1window_sum_0_0_choice := slice1window_sum_0_0;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_1_choice := 0;
      else
        slice1window_sum_0_1_choice := slice1window_sum_0_1;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_2_choice := 0;
      else
        slice1window_sum_0_2_choice := slice1window_sum_0_2;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_3_choice := 0;
      else
        slice1window_sum_0_3_choice := slice1window_sum_0_3;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_4_choice := 0;
      else
        slice1window_sum_0_4_choice := slice1window_sum_0_4;
      end if;
      if slice1window_change_tag_row_start then
        slice1window_sum_0_5_choice := 0;
      else
        slice1window_sum_0_5_choice := slice1window_sum_0_5;
      end if;
      if slice0window_tag_valid then
        slice1window_sum_0_0 <= (slice1window_sum_0_0_choice + slice1window_change_0_0) mod 512;
        slice1window_sum_0_1 <= (slice1window_sum_0_1_choice + slice1window_change_0_1) mod 512;
        slice1window_sum_0_2 <= (slice1window_sum_0_2_choice + slice1window_change_0_2) mod 512;
        slice1window_sum_0_3 <= (slice1window_sum_0_3_choice + slice1window_change_0_3) mod 512;
        slice1window_sum_0_4 <= (slice1window_sum_0_4_choice + slice1window_change_0_4) mod 512;
        slice1window_sum_0_5 <= (slice1window_sum_0_5_choice + slice1window_change_0_5) mod 512;
        slice1window_centre_map_column_0 <= slice0window_centre_map_column_0;
        slice1window_centre_output_column_0 <= slice1window_change_tag_output_column;
        slice1window_centre_output_column_1 <= slice1window_centre_output_column_0;
        slice1window_centre_first_column_0 <= slice1window_change_tag_first_column;
        slice1window_centre_first_column_1 <= slice1window_centre_first_column_0;
        slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
      end if;
      if slice0window_change_tag_valid then
        slice1window_centre_start_of_frame_0 <= slice0window_centre_start_of_frame_0;
      end if;
      -- slice1mask
      slice1mask_inside_0_all := (not slice0window_tag_valid) and slice1mask_inside_0;
      if slice1window_centre_first_column_1 then
        slice1mask_inside_0_choice := slice1mask_inside_0_all;
      else
        slice1mask_inside_0_choice := slice0window_tag_valid or slice1mask_inside_0;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_1_choice := slice1mask_inside_0;
      else
        slice1mask_inside_1_choice := slice1mask_inside_1;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_2_choice := slice1mask_inside_1;
      else
        slice1mask_inside_2_choice := slice1mask_inside_2;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_3_choice := slice1mask_inside_2;
      else
        slice1mask_inside_3_choice := slice1mask_inside_3;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_4_choice := slice1mask_inside_3;
      else
        slice1mask_inside_4_choice := slice1mask_inside_4;
      end if;
      if slice0window_tag_valid then
        slice1mask_inside_5_choice := slice1mask_inside_4;
      else
        slice1mask_inside_5_choice := slice1mask_inside_5;
      end if;
      slice1mask_searched_5_value := ((settings_last_disparity / 8) mod 2) = 1;
      slice1mask_searched_5_value_2 := ((settings_last_disparity / 4) mod 2) = 1;
      slice1mask_searched_5_value_3 := ((settings_last_disparity / 2) mod 2) = 1;
      slice1mask_searched_5_all := slice1mask_searched_5_value and (slice1mask_searched_5_value_2 or
        slice1mask_searched_5_value_3);
      if (settings_last_disparity mod 2) = 1 then
        slice1mask_searched_5_choice := slice1mask_searched_5_all;
      else
        slice1mask_searched_5_choice := ((settings_last_disparity / 4) mod 4) = 3;
      end if;
      slice1mask_searched_5_value_4 := ((settings_first_disparity / 8) mod 2) = 1;
      slice1mask_searched_5_value_5 := ((settings_first_disparity / 4) mod 2) = 1;
      if slice1mask_searched_5_value_4 then
        slice1mask_searched_5_choice_2 := (not (((settings_first_disparity / 16) mod 2) = 1)) and (not
          slice1mask_searched_5_value_5);
      else
        slice1mask_searched_5_choice_2 := not (((settings_first_disparity / 16) mod 2) = 1);
      end if;
      slice1mask_searched_5_is_equal := (settings_first_disparity / 32) = 0;
      slice1mask_searched_5_value_6 := ((settings_last_disparity / 64) mod 2) = 1;
      if (not slice1mask_searched_5_choice) and (not ((settings_last_disparity / 128) = 1)) and
        (((settings_last_disparity / 16) mod 4) = 0) then
        slice1mask_searched_5_choice_3 := slice1mask_searched_5_choice_2 and slice1mask_searched_5_is_equal and
          slice0window_tag_start_of_frame and slice1window_centre_output_column_1 and slice0window_tag_valid and
          slice1mask_searched_5_value_6;
      else
        slice1mask_searched_5_choice_3 := slice1mask_searched_5_choice_2 and slice1mask_searched_5_is_equal and
          slice0window_tag_start_of_frame and slice1window_centre_output_column_1 and slice0window_tag_valid;
      end if;
      slice1mask_searched_5_all_2 := slice0window_tag_start_of_frame and slice1window_centre_output_column_1 and
        slice0window_tag_valid;
      slice1mask_searched_5 <= slice1mask_searched_5_choice_3 or ((not slice1mask_searched_5_all_2) and
        slice1mask_searched_5);
      if slice0mask_left_out then
        slice1mask_inside_0 <= slice1mask_inside_0_choice;
      else
        slice1mask_inside_0 <= slice1mask_inside_0_all;
      end if;
      if slice1window_centre_first_column_1 then
        slice1mask_inside_1 <= (not slice0window_tag_valid) and slice1mask_inside_1;
        slice1mask_inside_2 <= (not slice0window_tag_valid) and slice1mask_inside_2;
        slice1mask_inside_3 <= (not slice0window_tag_valid) and slice1mask_inside_3;
        slice1mask_inside_4 <= (not slice0window_tag_valid) and slice1mask_inside_4;
        slice1mask_inside_5 <= (not slice0window_tag_valid) and slice1mask_inside_5;
      else
        slice1mask_inside_1 <= slice1mask_inside_1_choice;
        slice1mask_inside_2 <= slice1mask_inside_2_choice;
        slice1mask_inside_3 <= slice1mask_inside_3_choice;
        slice1mask_inside_4 <= slice1mask_inside_4_choice;
        slice1mask_inside_5 <= slice1mask_inside_5_choice;
      end if;
      -- slice1other
      slice1other_cost_0_0_all := slice0winner1_tag_output_column and slice0winner1_tag_first_column;
      if (slice1window_sum_0_0 - slice0other_cost_out_0) < 0 then
        slice1other_cost_0_0_choice := slice0winner1_tag_output_column;
      else
        slice1other_cost_0_0_choice := slice1other_cost_0_0_all;
      end if;
      slice1other_cost_0_0_all_2 := other_21 and slice1mask_inside_0 and slice1other_cost_0_0_choice;
      if slice0winner1_tag_first_column then
        slice1other_cost_0_0_choice_2 := 511;
      else
        slice1other_cost_0_0_choice_2 := slice0other_cost_out_0;
      end if;
      if (slice1window_sum_0_1 - slice1other_cost_0_0) < 0 then
        slice1other_cost_0_1_choice := slice0winner1_tag_output_column;
      else
        slice1other_cost_0_1_choice := slice1other_cost_0_0_all;
      end if;
      slice1other_cost_0_1_all := other_20 and slice1mask_inside_1 and slice1other_cost_0_1_choice;
      if slice0winner1_tag_first_column then
        slice1other_cost_0_1_choice_2 := 511;
      else
        slice1other_cost_0_1_choice_2 := slice1other_cost_0_0;
      end if;
      if (slice1window_sum_0_2 - slice1other_cost_0_1) < 0 then
        slice1other_cost_0_2_choice := slice0winner1_tag_output_column;
      else
        slice1other_cost_0_2_choice := slice1other_cost_0_0_all;
      end if;
      slice1other_cost_0_2_all := other_19 and slice1mask_inside_2 and slice1other_cost_0_2_choice;
      if slice0winner1_tag_first_column then
        slice1other_cost_0_2_choice_2 := 511;
      else
        slice1other_cost_0_2_choice_2 := slice1other_cost_0_1;
      end if;
      if (slice1window_sum_0_3 - slice1other_cost_0_2) < 0 then
        slice1other_cost_0_3_choice := slice0winner1_tag_output_column;
      else
        slice1other_cost_0_3_choice := slice1other_cost_0_0_all;
      end if;
      slice1other_cost_0_3_all := other_18 and slice1mask_inside_3 and slice1other_cost_0_3_choice;
      if slice0winner1_tag_first_column then
        slice1other_cost_0_3_choice_2 := 511;
      else
        slice1other_cost_0_3_choice_2 := slice1other_cost_0_2;
      end if;
      if (slice1window_sum_0_4 - slice1other_cost_0_3) < 0 then
        slice1other_cost_0_4_choice := slice0winner1_tag_output_column;
      else
        slice1other_cost_0_4_choice := slice1other_cost_0_0_all;
      end if;
      slice1other_cost_0_4_all := other_17 and slice1mask_inside_4 and slice1other_cost_0_4_choice;
      if slice0winner1_tag_first_column then
        slice1other_cost_0_4_choice_2 := 511;
      else
        slice1other_cost_0_4_choice_2 := slice1other_cost_0_3;
      end if;
      if slice0winner1_tag_valid then
        if slice1other_cost_0_0_all_2 then
          slice1other_cost_0_0 <= slice1window_sum_0_0;
          slice1other_winner_0_0 <= 6;
        else
          slice1other_cost_0_0 <= slice1other_cost_0_0_choice_2;
          slice1other_winner_0_0 <= slice0other_winner_out_0;
        end if;
        if slice1other_cost_0_1_all then
          slice1other_cost_0_1 <= slice1window_sum_0_1;
          slice1other_winner_0_1 <= 7;
        else
          slice1other_cost_0_1 <= slice1other_cost_0_1_choice_2;
          slice1other_winner_0_1 <= slice1other_winner_0_0;
        end if;
        if slice1other_cost_0_2_all then
          slice1other_cost_0_2 <= slice1window_sum_0_2;
          slice1other_winner_0_2 <= 8;
        else
          slice1other_cost_0_2 <= slice1other_cost_0_2_choice_2;
          slice1other_winner_0_2 <= slice1other_winner_0_1;
        end if;
        if slice1other_cost_0_3_all then
          slice1other_cost_0_3 <= slice1window_sum_0_3;
          slice1other_winner_0_3 <= 9;
        else
          slice1other_cost_0_3 <= slice1other_cost_0_3_choice_2;
          slice1other_winner_0_3 <= slice1other_winner_0_2;
        end if;
        if slice1other_cost_0_4_all then
          slice1other_cost_0_4 <= slice1window_sum_0_4;
          slice1other_winner_0_4 <= 10;
        else
          slice1other_cost_0_4 <= slice1other_cost_0_4_choice_2;
          slice1other_winner_0_4 <= slice1other_winner_0_3;
        end if;
        if slice1mask_searched_5 and slice1mask_inside_5 and slice0winner1_tag_output_column and
          (((slice1window_sum_0_5 - slice1other_cost_0_4) < 0) or slice0winner1_tag_first_column) then
          slice1other_winner_0_5 <= 11;
        else
          slice1other_winner_0_5 <= slice1other_winner_0_4;
        end if;
      end if;
      slice1other_winner_out_0 <= slice1other_winner_0_5;
      -- slice1winner1
      if (not other_21) or (not slice1mask_inside_0) then
        slice1winner1_held_0_0_choice := 511;
      else
        slice1winner1_held_0_0_choice := 0;
      end if;
      slice1winner1_held_0_0_any := to_integer(((to_unsigned(slice1window_sum_0_0, 9)) or
        (to_unsigned(slice1winner1_held_0_0_choice, 9))));
      if (not other_20) or (not slice1mask_inside_1) then
        slice1winner1_held_0_1_choice := 511;
      else
        slice1winner1_held_0_1_choice := 0;
      end if;
      slice1winner1_held_0_1_any := to_integer(((to_unsigned(slice1window_sum_0_1, 9)) or
        (to_unsigned(slice1winner1_held_0_1_choice, 9))));
      if (not other_19) or (not slice1mask_inside_2) then
        slice1winner1_held_0_2_choice := 511;
      else
        slice1winner1_held_0_2_choice := 0;
      end if;
      slice1winner1_held_0_2_any := to_integer(((to_unsigned(slice1window_sum_0_2, 9)) or
        (to_unsigned(slice1winner1_held_0_2_choice, 9))));
      if (not other_18) or (not slice1mask_inside_3) then
        slice1winner1_held_0_3_choice := 511;
      else
        slice1winner1_held_0_3_choice := 0;
      end if;
      slice1winner1_held_0_3_any := to_integer(((to_unsigned(slice1window_sum_0_3, 9)) or
        (to_unsigned(slice1winner1_held_0_3_choice, 9))));
      slice1winner1_best_cost_0_0_is_less := (slice1winner1_held_0_1_any - slice1winner1_held_0_0_any) < 0;
      slice1winner1_best_cost_0_1_is_less := (slice1winner1_held_0_3_any - slice1winner1_held_0_2_any) < 0;
      slice1winner1_held_0_0 <= slice1winner1_held_0_0_any;
      slice1winner1_held_0_1 <= slice1winner1_held_0_1_any;
      slice1winner1_held_0_2 <= slice1winner1_held_0_2_any;
      slice1winner1_held_0_3 <= slice1winner1_held_0_3_any;
      slice1winner1_held_0_4 <= slice1window_entering_tag_border_column_any_2;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_above_0_2 <= slice1window_entering_tag_border_column_any;
      slice1winner1_best_late_cost_0_0 <= slice1winner1_best_cost_0_0;
      slice1winner1_best_late_cost_0_1 <= slice1winner1_best_cost_0_1;
      slice1winner1_best_late_cost_0_2 <= slice1winner1_best_cost_0_2;
      slice1winner1_best_but_first_0_0 <= slice1winner1_held_0_1;
      slice1winner1_best_but_first_0_1 <= slice1winner1_held_0_3;
      slice1winner1_best_but_first_0_2 <= slice1winner1_best_above_0_2;
      slice1winner1_best_but_last_0_0 <= slice1winner1_held_0_0;
      slice1winner1_best_but_last_0_1 <= slice1winner1_held_0_2;
      if slice1window_entering_tag_border_column_is_less then
        slice1winner1_held_0_5 <= 0;
        slice1winner1_best_cost_0_2 <= slice1window_entering_tag_border_column_any;
        slice1winner1_best_index_0_2 <= 5;
      else
        slice1winner1_held_0_5 <= slice1window_entering_tag_border_column_any;
        slice1winner1_best_cost_0_2 <= slice1window_entering_tag_border_column_any_2;
        slice1winner1_best_index_0_2 <= 4;
      end if;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1winner1_held_0_1_any;
        slice1winner1_best_below_0_0 <= slice1winner1_held_0_0_any;
        slice1winner1_best_above_0_0 <= 0;
      else
        slice1winner1_best_cost_0_0 <= slice1winner1_held_0_0_any;
        slice1winner1_best_below_0_0 <= 0;
        slice1winner1_best_above_0_0 <= slice1winner1_held_0_1_any;
      end if;
      if slice1winner1_best_cost_0_1_is_less then
        slice1winner1_best_cost_0_1 <= slice1winner1_held_0_3_any;
        slice1winner1_best_index_0_1 <= 3;
        slice1winner1_best_below_0_1 <= slice1winner1_held_0_2_any;
        slice1winner1_best_above_0_1 <= 0;
      else
        slice1winner1_best_cost_0_1 <= slice1winner1_held_0_2_any;
        slice1winner1_best_index_0_1 <= 2;
        slice1winner1_best_below_0_1 <= 0;
        slice1winner1_best_above_0_1 <= slice1winner1_held_0_3_any;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_best_cost_0_1 - slice1winner1_best_cost_0_0) < 0;
      slice1winner2_best_below_0_0_is_equal := slice1winner1_best_index_0_1 = 2;
      if slice1winner2_best_below_0_0_is_equal then
        slice1winner2_best_below_0_0_choice := slice1winner1_held_0_1;
      else
        slice1winner2_best_below_0_0_choice := slice1winner1_best_below_0_1;
      end if;
      if slice1winner1_best_index_0_0 then
        slice1winner2_best_above_0_0_choice := slice1winner1_held_0_2;
      else
        slice1winner2_best_above_0_0_choice := slice1winner1_best_above_0_0;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice := 511;
      else
        slice1winner2_best_second_0_0_choice := slice1winner1_best_late_cost_0_1;
      end if;
      if slice1winner2_best_at_end_0_0 then
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_but_first_0_1;
      else
        slice1winner2_best_second_0_0_choice_2 := slice1winner2_best_second_0_0_choice;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice_3 := slice1winner1_best_late_cost_0_0;
      else
        slice1winner2_best_second_0_0_choice_3 := 511;
      end if;
      if slice1winner2_best_at_start_0_0 then
        slice1winner2_best_second_0_0_choice_4 := slice1winner1_best_but_last_0_0;
      else
        slice1winner2_best_second_0_0_choice_4 := slice1winner2_best_second_0_0_choice_3;
      end if;
      slice1winner2_best_cost_0_1 <= slice1winner1_held_0_4;
      slice1winner2_best_index_0_1 <= slice1winner1_best_index_0_2;
      slice1winner2_best_above_0_1 <= slice1winner1_held_0_5;
      slice1winner2_best_first_0_0 <= slice1winner1_held_0_0;
      slice1winner2_best_last_0_0 <= slice1winner1_held_0_3;
      slice1winner2_best_place_0_0 <= slice1winner2_best_cost_0_0_is_less;
      slice1winner2_best_at_start_0_0 <= slice1winner2_best_cost_0_0_is_less and slice1winner2_best_below_0_0_is_equal;
      slice1winner2_best_at_end_0_0 <= slice1winner1_best_index_0_0 and ((slice1winner1_best_cost_0_1 -
        slice1winner1_best_cost_0_0) >= 0);
      slice1winner2_best_late_cost_0_0 <= slice1winner2_best_cost_0_0;
      slice1winner2_best_late_cost_0_1 <= slice1winner1_best_late_cost_0_2;
      slice1winner2_best_but_first_0_1 <= slice1winner1_best_but_first_0_2;
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
      if (slice1winner2_best_second_0_0_choice_2 - slice1winner2_best_second_0_0_choice_4) < 0 then
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_2;
      else
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_4;
      end if;
      if (slice1winner1_best_late_cost_0_1 - slice1winner1_best_but_first_0_0) < 0 then
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_but_first_0_0;
      end if;
      if (slice1winner1_best_but_last_0_1 - slice1winner1_best_late_cost_0_0) < 0 then
        slice1winner2_best_but_last_0_0 <= slice1winner1_best_but_last_0_1;
      else
        slice1winner2_best_but_last_0_0 <= slice1winner1_best_late_cost_0_0;
      end if;
      -- slice1winner3
      slice1winner3_best_cost_0_0_is_less := (slice1winner1_best_late_cost_0_2 - slice1winner2_best_cost_0_0) < 0;
      if ((slice1winner2_best_index_0_1 / 4) = 1) and (not ((slice1winner2_best_index_0_1 mod 2) = 1)) then
        slice1winner3_best_below_0_0_choice := slice1winner2_best_last_0_0;
      else
        slice1winner3_best_below_0_0_choice := slice1winner3_tag_row_start;
      end if;
      slice1winner3_best_above_0_0_is_equal := slice1winner2_best_index_0_0 = 3;
      if slice1winner3_best_above_0_0_is_equal then
        slice1winner3_best_above_0_0_choice := slice1winner2_best_cost_0_1;
      else
        slice1winner3_best_above_0_0_choice := slice1winner2_best_above_0_0;
      end if;
      if slice1winner3_best_at_start_0_0 then
        slice1winner3_best_second_0_0_choice := 511;
      else
        slice1winner3_best_second_0_0_choice := slice1winner2_best_late_cost_0_1;
      end if;
      if slice1winner3_best_at_end_0_0 then
        slice1winner3_best_second_0_0_choice_2 := slice1winner2_best_but_first_0_1;
      else
        slice1winner3_best_second_0_0_choice_2 := slice1winner3_best_second_0_0_choice;
      end if;
      if slice1winner3_best_at_start_0_0 then
        slice1winner3_best_second_0_0_choice_3 := slice1winner2_best_late_cost_0_0;
      else
        slice1winner3_best_second_0_0_choice_3 := slice1winner2_best_second_0_0;
      end if;
      if slice1winner3_best_place_0_0 then
        slice1winner3_best_second_0_0_choice_4 := slice1winner2_best_but_last_0_0;
      else
        slice1winner3_best_second_0_0_choice_4 := slice1winner3_best_second_0_0_choice_3;
      end if;
      slice1winner3_best_first_0_0 <= slice1winner2_best_first_0_0;
      slice1winner3_best_place_0_0 <= slice1winner3_best_cost_0_0_is_less and ((slice1winner2_best_index_0_1 / 4) = 1)
        and (not ((slice1winner2_best_index_0_1 mod 2) = 1));
      slice1winner3_best_at_start_0_0 <= slice1winner3_best_cost_0_0_is_less;
      slice1winner3_best_at_end_0_0 <= ((slice1winner1_best_late_cost_0_2 - slice1winner2_best_cost_0_0) >= 0) and
        slice1winner3_best_above_0_0_is_equal;
      slice1winner3_best_late_cost_0_0 <= slice1winner3_best_cost_0_0;
      slice1winner3_tag_row_start <= slice1window_entering_tag_border_column;
      if slice1winner3_best_cost_0_0_is_less then
        slice1winner3_best_cost_0_0 <= slice1winner1_best_late_cost_0_2;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_1;
        slice1winner3_best_below_0_0 <= slice1winner3_best_below_0_0_choice;
        slice1winner3_best_above_0_0 <= slice1winner2_best_above_0_1;
      else
        slice1winner3_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1winner3_best_index_0_0 <= slice1winner2_best_index_0_0;
        slice1winner3_best_below_0_0 <= slice1winner2_best_below_0_0;
        slice1winner3_best_above_0_0 <= slice1winner3_best_above_0_0_choice;
      end if;
      if (slice1winner3_best_second_0_0_choice_2 - slice1winner3_best_second_0_0_choice_4) < 0 then
        slice1winner3_best_second_0_0 <= slice1winner3_best_second_0_0_choice_2;
      else
        slice1winner3_best_second_0_0 <= slice1winner3_best_second_0_0_choice_4;
      end if;
      if (slice1winner2_best_late_cost_0_1 - slice1winner2_best_but_first_0_0) < 0 then
        slice1winner3_best_but_first_0_0 <= slice1winner2_best_late_cost_0_1;
      else
        slice1winner3_best_but_first_0_0 <= slice1winner2_best_but_first_0_0;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice1winner3_best_cost_0_0 - slice0winner3_best_late_cost_0_0) < 0;
      slice1_best_below_0_0_is_equal := slice1winner3_best_index_0_0 = 0;
      if slice1_best_below_0_0_is_equal then
        slice1_best_below_0_0_choice := slice0_best_last_0_0;
      else
        slice1_best_below_0_0_choice := slice1winner3_best_below_0_0;
      end if;
      slice1_best_above_0_0_is_equal := slice0_best_index_0_0 = 5;
      if slice1_best_above_0_0_is_equal then
        slice1_best_above_0_0_choice := slice1winner3_best_first_0_0;
      else
        slice1_best_above_0_0_choice := slice0_best_above_0_0;
      end if;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice := slice1winner3_best_second_0_0;
      else
        slice1_best_second_0_0_choice := slice1winner3_best_late_cost_0_0;
      end if;
      if slice1_best_at_end_0_0 then
        slice1_best_second_0_0_choice_2 := slice1winner3_best_but_first_0_0;
      else
        slice1_best_second_0_0_choice_2 := slice1_best_second_0_0_choice;
      end if;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice_3 := slice0_best_late_cost_0_0;
      else
        slice1_best_second_0_0_choice_3 := slice0_best_second_0_0;
      end if;
      if slice1_best_at_start_0_0 then
        slice1_best_second_0_0_choice_4 := slice0_best_but_last_0_0;
      else
        slice1_best_second_0_0_choice_4 := slice1_best_second_0_0_choice_3;
      end if;
      slice1_best_place_0_0 <= slice1_best_cost_0_0_is_less;
      slice1_best_at_start_0_0 <= slice1_best_cost_0_0_is_less and slice1_best_below_0_0_is_equal;
      slice1_best_at_end_0_0 <= ((slice1winner3_best_cost_0_0 - slice0winner3_best_late_cost_0_0) >= 0) and
        slice1_best_above_0_0_is_equal;
      slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_map_column <= slice0_best_tag_map_column;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice1winner3_best_cost_0_0;
        slice1_best_index_0_0 <= (((slice1winner3_best_index_0_0 / 2) + 3) * 2) + (slice1winner3_best_index_0_0 mod 2);
        slice1_best_below_0_0 <= slice1_best_below_0_0_choice;
        slice1_best_above_0_0 <= slice1winner3_best_above_0_0;
      else
        slice1_best_cost_0_0 <= slice0winner3_best_late_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
        slice1_best_below_0_0 <= slice0_best_below_0_0;
        slice1_best_above_0_0 <= slice1_best_above_0_0_choice;
      end if;
      if (slice1_best_second_0_0_choice_2 - slice1_best_second_0_0_choice_4) < 0 then
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_2;
      else
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_4;
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
      refinement_passed_0_0 <= slice1_best_cost_0_0 /= 511;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_passed_4_0 <= refinement_passed_3_0;
      refinement_passed_5_0 <= refinement_passed_4_0;
      refinement_passed_6_0 <= refinement_passed_5_0;
      refinement_passed_7_0 <= refinement_passed_6_0;
      refinement_passed_8_0 <= refinement_passed_7_0;
      refinement_passed_9_0 <= refinement_passed_8_0;
      refinement_passed_10_0 <= refinement_passed_9_0;
      refinement_passed_11_0 <= refinement_passed_10_0;
      refinement_tag_0_valid <= slice1_best_tag_valid;
      refinement_tag_0_map_column <= slice1_best_tag_map_column;
      refinement_tag_0_output_column <= slice1_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice1_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice1_best_tag_end_of_line;
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
      refinement_tag_10_valid <= refinement_tag_9_valid;
      refinement_tag_10_map_column <= refinement_tag_9_map_column;
      refinement_tag_10_output_column <= refinement_tag_9_output_column;
      refinement_tag_10_start_of_frame <= refinement_tag_9_start_of_frame;
      refinement_tag_10_end_of_line <= refinement_tag_9_end_of_line;
      refinement_tag_11_valid <= refinement_tag_10_valid;
      refinement_tag_11_map_column <= refinement_tag_10_map_column;
      refinement_tag_11_output_column <= refinement_tag_10_output_column;
      refinement_tag_11_start_of_frame <= refinement_tag_10_start_of_frame;
      refinement_tag_11_end_of_line <= refinement_tag_10_end_of_line;
      refinement_alone_0_0 <= slice1_best_second_0_0 = 511;
      refinement_gap_0 <= (slice1_best_second_0_0 - slice1_best_late_cost_0_0) mod 512;
      refinement_lowest_0 <= slice1_best_late_cost_0_0;
      refinement_scaled_gap_0 <= (refinement_gap_0 * 25) * 4;
      refinement_scaled_cost_0 <= refinement_lowest_0 * refinement_percent;
      refinement_u_0 <= (refinement_below_0 - slice1_best_late_cost_0_0) mod 512;
      refinement_v_0 <= (refinement_above_0 - slice1_best_late_cost_0_0) mod 512;
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
      refinement_quotient_8_0 <= (((((1024 - refinement_divisor_7_0) / 2) + refinement_remainder_7_0) * 2) / 1024) +
        ((other_10 / 2) * 2);
      refinement_negative_0_0 <= refinement_divisor_0_0_is_less;
      refinement_negative_1_0 <= refinement_negative_0_0;
      refinement_negative_2_0 <= refinement_negative_1_0;
      refinement_negative_3_0 <= refinement_negative_2_0;
      refinement_negative_4_0 <= refinement_negative_3_0;
      refinement_negative_5_0 <= refinement_negative_4_0;
      refinement_negative_6_0 <= refinement_negative_5_0;
      refinement_negative_7_0 <= refinement_negative_6_0;
      refinement_negative_8_0 <= refinement_negative_7_0;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
      if refinement_alone_1_0 then
        refinement_passed_3_0 <= refinement_passed_2_0;
      else
        refinement_passed_3_0 <= refinement_passed_2_0 and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0);
      end if;
      if (refinement_percent / 16) = 0 then
        refinement_alone_1_0 <= ((refinement_percent mod 16) = 0) or refinement_alone_0_0;
      else
        refinement_alone_1_0 <= refinement_alone_0_0;
      end if;
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
      if not ((not refinement_tag_0_valid) or (not refinement_tag_0_start_of_frame) or (not refinement_tag_0_output_column)) then
        refinement_percent <= settings_uniqueness_percent;
      end if;
      -- leftright
      leftright_holds_winners_all := (leftright_ring_read_address /= 0) and (not leftright_holds_winners);
      leftright_checked_passed_0_difference := leftright_answered_disparity_0 - to_integer(leftright_found_0);
      if (size_windows_idle mod 2) = 1 then
        leftright_checked_tag_row_start_choice := (not ((map_counter_group mod 2) = 1)) or (not (((map_counter_group /
          2) mod 2) = 1));
      else
        leftright_checked_tag_row_start_choice := not (((map_counter_group / 2) mod 2) = 1);
      end if;
      leftright_checked_tag_row_start_is_equal := (map_counter_group mod 4) = 0;
      if raster_place_group_value_2 then
        leftright_checked_tag_row_start_choice_2 := leftright_checked_tag_row_start_choice;
      else
        leftright_checked_tag_row_start_choice_2 := ((size_windows_idle mod 2) = 1) and
          leftright_checked_tag_row_start_is_equal;
      end if;
      leftright_checked_tag_row_start_value := ((map_counter_group / 4) mod 2) = 1;
      if leftright_checked_tag_row_start_choice_2 then
        leftright_checked_tag_row_start_choice_3 := (not raster_place_group_value_4) and
          leftright_checked_tag_row_start_value;
      else
        leftright_checked_tag_row_start_choice_3 := (not raster_place_group_value_4) or
          leftright_checked_tag_row_start_value;
      end if;
      leftright_checked_tag_row_start_value_2 := ((map_counter_group / 8) mod 2) = 1;
      if leftright_checked_tag_row_start_choice_3 then
        leftright_checked_tag_row_start_choice_4 := (not raster_place_group_value_6) or
          leftright_checked_tag_row_start_value_2;
      else
        leftright_checked_tag_row_start_choice_4 := (not raster_place_group_value_6) and
          leftright_checked_tag_row_start_value_2;
      end if;
      leftright_checked_tag_row_start_value_3 := ((size_map_last_column / 16) mod 2) = 1;
      if leftright_checked_tag_row_start_value_3 then
        leftright_checked_tag_row_start_choice_5 := (map_counter_column / 16) = 3;
      else
        leftright_checked_tag_row_start_choice_5 := (map_counter_column / 16) = 2;
      end if;
      if leftright_checked_tag_row_start_value_3 then
        leftright_checked_tag_row_start_choice_6 := (map_counter_column / 16) = 1;
      else
        leftright_checked_tag_row_start_choice_6 := (map_counter_column / 16) = 0;
      end if;
      if (size_map_last_column / 32) = 1 then
        leftright_checked_tag_row_start_choice_7 := leftright_checked_tag_row_start_choice_5;
      else
        leftright_checked_tag_row_start_choice_7 := leftright_checked_tag_row_start_choice_6;
      end if;
      leftright_checked_tag_row_start_value_4 := ((size_map_last_column / 2) mod 2) = 1;
      leftright_checked_tag_row_start_value_5 := (map_counter_column / 2) mod 4;
      if leftright_checked_tag_row_start_value_4 then
        leftright_checked_tag_row_start_choice_8 := leftright_checked_tag_row_start_value_5 = 3;
      else
        leftright_checked_tag_row_start_choice_8 := leftright_checked_tag_row_start_value_5 = 2;
      end if;
      if leftright_checked_tag_row_start_value_4 then
        leftright_checked_tag_row_start_choice_9 := leftright_checked_tag_row_start_value_5 = 1;
      else
        leftright_checked_tag_row_start_choice_9 := leftright_checked_tag_row_start_value_5 = 0;
      end if;
      if ((size_map_last_column / 4) mod 2) = 1 then
        leftright_checked_tag_row_start_choice_10 := leftright_checked_tag_row_start_choice_8;
      else
        leftright_checked_tag_row_start_choice_10 := leftright_checked_tag_row_start_choice_9;
      end if;
      leftright_checked_tag_row_start_differs := ((size_map_last_column mod 2) = 1) /= (not ((map_counter_column mod 2)
        = 1));
      leftright_checked_tag_row_start_differs_2 := (((size_map_last_column / 8) mod 2) = 1) /= (not
        (((map_counter_column / 8) mod 2) = 1));
      if leftright_checked_tag_row_start_choice_4 then
        leftright_checked_tag_row_start_choice_11 := leftright_checked_tag_row_start_choice_7 and
          leftright_checked_tag_row_start_choice_10 and leftright_checked_tag_row_start_differs and
          leftright_checked_tag_row_start_differs_2 and ((size_windows_idle / 16) = 1) and (not ((map_counter_group /
          16) = 1));
      else
        leftright_checked_tag_row_start_choice_11 := leftright_checked_tag_row_start_choice_7 and
          leftright_checked_tag_row_start_choice_10 and leftright_checked_tag_row_start_differs and
          leftright_checked_tag_row_start_differs_2 and (((size_windows_idle / 16) = 1) or (not ((map_counter_group /
          16) = 1)));
      end if;
      leftright_checked_tag_row_start_value_6 := ((size_windows_groups / 8) mod 2) = 1;
      leftright_checked_tag_row_start_is_equal_2 := (map_counter_group / 8) = 3;
      leftright_checked_tag_row_start_is_equal_3 := (map_counter_group / 8) = 2;
      if leftright_checked_tag_row_start_value_6 then
        leftright_checked_tag_row_start_choice_12 := leftright_checked_tag_row_start_is_equal_2;
      else
        leftright_checked_tag_row_start_choice_12 := leftright_checked_tag_row_start_is_equal_3;
      end if;
      leftright_checked_tag_row_start_is_equal_4 := (map_counter_group / 8) = 1;
      leftright_checked_tag_row_start_is_equal_5 := (map_counter_group / 8) = 0;
      if leftright_checked_tag_row_start_value_6 then
        leftright_checked_tag_row_start_choice_13 := leftright_checked_tag_row_start_is_equal_4;
      else
        leftright_checked_tag_row_start_choice_13 := leftright_checked_tag_row_start_is_equal_5;
      end if;
      if (size_windows_groups / 16) = 1 then
        leftright_checked_tag_row_start_choice_14 := leftright_checked_tag_row_start_choice_12;
      else
        leftright_checked_tag_row_start_choice_14 := leftright_checked_tag_row_start_choice_13;
      end if;
      leftright_checked_tag_row_start_is_equal_6 := (map_counter_group mod 4) = 3;
      leftright_checked_tag_row_start_is_equal_7 := (map_counter_group mod 4) = 2;
      if (size_windows_groups mod 2) = 1 then
        leftright_checked_tag_row_start_choice_15 := leftright_checked_tag_row_start_is_equal_6;
      else
        leftright_checked_tag_row_start_choice_15 := leftright_checked_tag_row_start_is_equal_7;
      end if;
      leftright_checked_tag_row_start_is_equal_8 := (map_counter_group mod 4) = 1;
      if (size_windows_groups mod 2) = 1 then
        leftright_checked_tag_row_start_choice_16 := leftright_checked_tag_row_start_is_equal_8;
      else
        leftright_checked_tag_row_start_choice_16 := leftright_checked_tag_row_start_is_equal;
      end if;
      if ((size_windows_groups / 2) mod 2) = 1 then
        leftright_checked_tag_row_start_choice_17 := leftright_checked_tag_row_start_choice_15;
      else
        leftright_checked_tag_row_start_choice_17 := leftright_checked_tag_row_start_choice_16;
      end if;
      leftright_checked_tag_row_start_differs_3 := (((size_windows_groups / 4) mod 2) = 1) /= (not
        leftright_checked_tag_row_start_value);
      leftright_checked_tag_row_start_all := leftright_checked_tag_row_start_choice_14 and
        leftright_checked_tag_row_start_choice_17 and leftright_checked_tag_row_start_differs_3;
      if leftright_checked_tag_row_start_choice_11 then
        leftright_checked_tag_row_start_choice_18 := (not leftright_checked_tag_row_start_all) and
          leftright_checked_tag_row_start;
      else
        leftright_checked_tag_row_start_choice_18 := leftright_checked_tag_row_start;
      end if;
      leftright_checked_tag_row_start_value_7 := ((size_windows_last_group / 8) mod 2) = 1;
      if leftright_checked_tag_row_start_value_7 then
        leftright_checked_tag_row_start_choice_19 := leftright_checked_tag_row_start_is_equal_2;
      else
        leftright_checked_tag_row_start_choice_19 := leftright_checked_tag_row_start_is_equal_3;
      end if;
      if leftright_checked_tag_row_start_value_7 then
        leftright_checked_tag_row_start_choice_20 := leftright_checked_tag_row_start_is_equal_4;
      else
        leftright_checked_tag_row_start_choice_20 := leftright_checked_tag_row_start_is_equal_5;
      end if;
      if (size_windows_last_group / 16) = 1 then
        leftright_checked_tag_row_start_choice_21 := leftright_checked_tag_row_start_choice_19;
      else
        leftright_checked_tag_row_start_choice_21 := leftright_checked_tag_row_start_choice_20;
      end if;
      if (size_windows_last_group mod 2) = 1 then
        leftright_checked_tag_row_start_choice_22 := leftright_checked_tag_row_start_is_equal_6;
      else
        leftright_checked_tag_row_start_choice_22 := leftright_checked_tag_row_start_is_equal_7;
      end if;
      if (size_windows_last_group mod 2) = 1 then
        leftright_checked_tag_row_start_choice_23 := leftright_checked_tag_row_start_is_equal_8;
      else
        leftright_checked_tag_row_start_choice_23 := leftright_checked_tag_row_start_is_equal;
      end if;
      if ((size_windows_last_group / 2) mod 2) = 1 then
        leftright_checked_tag_row_start_choice_24 := leftright_checked_tag_row_start_choice_22;
      else
        leftright_checked_tag_row_start_choice_24 := leftright_checked_tag_row_start_choice_23;
      end if;
      leftright_checked_tag_row_start_differs_4 := transform_counter_group_value_4 /= (not
        leftright_checked_tag_row_start_value);
      leftright_checked_tag_row_start_all_2 := leftright_checked_tag_row_start_choice_21 and
        leftright_checked_tag_row_start_choice_24 and leftright_checked_tag_row_start_differs_4 and
        leftright_checked_tag_row_start_choice_7 and leftright_checked_tag_row_start_choice_10 and
        leftright_checked_tag_row_start_differs and leftright_checked_tag_row_start_differs_2;
      if leftright_checked_tag_row_start_choice_18 then
        leftright_checked_tag_row_start_choice_25 := leftright_checked_tag_row_start_all_2 or (not
          leftright_checked_tag_start_of_frame);
      else
        leftright_checked_tag_row_start_choice_25 := leftright_checked_tag_row_start_choice_21 and
          leftright_checked_tag_row_start_choice_24 and leftright_checked_tag_row_start_differs_4 and
          leftright_checked_tag_row_start_choice_7 and leftright_checked_tag_row_start_choice_10 and
          leftright_checked_tag_row_start_differs and leftright_checked_tag_row_start_differs_2 and
          leftright_checked_tag_start_of_frame;
      end if;
      leftright_checked_tag_row_start_all_3 := leftright_checked_tag_valid and leftright_checked_tag_map_column;
      leftright_other_1_0 <= slice1other_winner_out_0;
      leftright_other_2_0 <= leftright_other_1_0;
      leftright_other_3_0 <= leftright_other_2_0;
      leftright_other_4_0 <= leftright_other_3_0;
      leftright_other_5_0 <= leftright_other_4_0;
      leftright_other_6_0 <= leftright_other_5_0;
      leftright_other_7_0 <= leftright_other_6_0;
      leftright_other_8_0 <= leftright_other_7_0;
      leftright_other_9_0 <= leftright_other_8_0;
      leftright_other_10_0 <= leftright_other_9_0;
      leftright_other_11_0 <= leftright_other_10_0;
      leftright_other_12_0 <= leftright_other_11_0;
      leftright_other_13_0 <= leftright_other_12_0;
      leftright_other_14_0 <= leftright_other_13_0;
      leftright_position <= (leftright_position + as_number(refinement_tag_11_valid)) mod 16;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_all) and refinement_tag_11_valid;
      leftright_address_0 <= (leftright_held_position - to_integer(leftright_held_0(17 downto 4))) mod 16;
      leftright_asking_disparity_0 <= to_integer(leftright_held_0(7 downto 4));
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= to_integer(leftright_held_0(12 downto 12)) = 1;
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= to_integer(leftright_held_0(0 downto 0)) = 1;
      leftright_asking_tag_output_column <= to_integer(leftright_held_0(1 downto 1)) = 1;
      leftright_asking_tag_start_of_frame <= to_integer(leftright_held_0(2 downto 2)) = 1;
      leftright_asking_tag_end_of_line <= to_integer(leftright_held_0(3 downto 3)) = 1;
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and ((leftright_checked_passed_0_difference - (0 -
        leftright_threshold)) >= 0) and ((leftright_threshold - leftright_checked_passed_0_difference) >= 0);
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_all then
        leftright_holds_winners <= (not refinement_tag_11_valid) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_11_valid or leftright_holds_winners;
      end if;
      if leftright_checked_tag_row_start_choice_25 then
        leftright_checked_tag_row_start <= leftright_checked_tag_row_start or leftright_checked_tag_row_start_all_3;
      else
        leftright_checked_tag_row_start <= leftright_checked_tag_row_start and ((not leftright_checked_tag_valid) or
          (not leftright_checked_tag_map_column));
      end if;
      if refinement_tag_11_valid then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 11 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 16;
        end if;
      end if;
      if not ((not leftright_asking_tag_valid) or (not leftright_asking_tag_start_of_frame) or (not leftright_asking_tag_output_column)) then
        leftright_threshold <= settings_left_right_threshold;
      end if;
      -- map
      if leftright_checked_tag_row_start_all_3 then
        if (leftright_checked_tag_row_start_choice_7 and leftright_checked_tag_row_start_choice_10 and
          leftright_checked_tag_row_start_differs and leftright_checked_tag_row_start_differs_2) or
          leftright_checked_tag_start_of_frame then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 64;
        end if;
      end if;
      if leftright_checked_tag_row_start_all_2 then
        map_counter_group_choice := size_windows_groups;
      else
        map_counter_group_choice := 0;
      end if;
      if leftright_checked_tag_row_start_choice_14 and leftright_checked_tag_row_start_choice_17 and
        leftright_checked_tag_row_start_differs_3 and leftright_checked_tag_row_start then
        map_counter_group_choice_2 := 1;
      else
        map_counter_group_choice_2 := (map_counter_group + 1) mod 32;
      end if;
      if leftright_checked_tag_row_start_choice_11 and leftright_checked_tag_valid and leftright_checked_tag_map_column
        then
        map_counter_group_choice_3 := map_counter_group_choice_2;
      else
        map_counter_group_choice_3 := map_counter_group;
      end if;
      if leftright_checked_tag_valid then
        map_line_ended_choice := leftright_checked_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := to_integer(other_8(16 downto 16)) = 1;
      if map_at_top then
        map_of_column_0_a_choice := map_column_1 / 2;
      else
        map_of_column_0_a_choice := other_7 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c_choice := map_column_1 / 2;
      else
        map_of_column_0_c_choice := map_column_2 / 2;
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
      if ((map_sorted_column / 2) mod 2) = 1 then
        map_window_complete_choice := map_sorted_arrives;
      else
        map_window_complete_choice := ((map_sorted_column mod 2) = 1) and map_sorted_arrives;
      end if;
      if (map_sorted_column / 4) = 0 then
        map_window_complete_choice_2 := map_window_complete_choice;
      else
        map_window_complete_choice_2 := map_sorted_arrives;
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
      map_counter_next_frame <= to_integer(other_8(40 downto 40)) = 1;
      map_newest_0 <= ((((((((leftright_checked_disparity_0 + 4095) mod 2048) * 2) + (leftright_checked_fraction_0 / 8)
        + 1) mod 4096) * 8) + (leftright_checked_fraction_0 mod 8)) * 2) + as_number(leftright_checked_passed_0);
      map_arrives <= leftright_checked_tag_row_start_all_3;
      map_behind <= map_line_ended and leftright_checked_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_8(5 downto 0));
      map_column_1 <= map_rows_ready_words_0 / 8192;
      map_column_2 <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= to_integer(other_8(24 downto 24)) = 1;
      map_at_top <= to_integer(other_8(32 downto 32)) = 1;
      map_at_output <= to_integer(other_8(48 downto 48)) = 1;
      map_of_column_0_a <= map_of_column_0_a_choice;
      map_of_column_0_b <= map_column_1 / 2;
      map_of_column_0_c <= map_of_column_0_c_choice;
      map_of_column_0_b_below_a <= ((map_column_1 / 2) - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_a <= (map_of_column_0_c_choice - map_of_column_0_a_choice) < 0;
      map_of_column_0_c_below_b <= (map_of_column_0_c_choice - (map_column_1 / 2)) < 0;
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
      map_of_low_0_b_below_a <= (map_low_1_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_a <= (map_low_2_0 - map_low_0_0) < 0;
      map_of_low_0_c_below_b <= (map_low_2_0 - map_low_1_0) < 0;
      map_of_middle_0_a <= map_middle_0_0;
      map_of_middle_0_b <= map_middle_1_0;
      map_of_middle_0_c <= map_middle_2_0;
      map_of_middle_0_b_below_a <= (map_middle_1_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_a <= (map_middle_2_0 - map_middle_0_0) < 0;
      map_of_middle_0_c_below_b <= (map_middle_2_0 - map_middle_1_0) < 0;
      map_of_high_0_a <= map_high_0_0;
      map_of_high_0_b <= map_high_1_0;
      map_of_high_0_c <= map_high_2_0;
      map_of_high_0_b_below_a <= (map_high_1_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_a <= (map_high_2_0 - map_high_0_0) < 0;
      map_of_high_0_c_below_b <= (map_high_2_0 - map_high_1_0) < 0;
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_of_all_0_b_below_a <= (map_median_middle_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_a <= (map_smallest_high_0 - map_largest_low_0) < 0;
      map_of_all_0_c_below_b <= (map_smallest_high_0 - map_median_middle_0) < 0;
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
      if leftright_checked_tag_start_of_frame and leftright_checked_tag_valid and leftright_checked_tag_map_column then
        map_counter_group <= map_counter_group_choice;
      else
        map_counter_group <= map_counter_group_choice_3;
      end if;
      if leftright_checked_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not leftright_checked_tag_valid);
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
      if map_window_complete_choice_2 then
        map_window_complete <= map_sorted_output;
      else
        map_window_complete <= map_sorted_output and map_sorted_behind;
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
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choice_2;
      else
        map_out_disparity_0 <= map_out_disparity_0_choice_4;
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 8192) + (map_rows_ready_newest_0 * 8192);
        map_at_column <= to_integer(other_8(5 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0_0;
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_1_0_all := map_sorted_arrives and (map_sorted_column = 0);
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
      other_17_is_equal := ((settings_last_disparity / 2) mod 4) = 0;
      other_17_is_equal_2 := (settings_last_disparity / 16) = 0;
      other_17_is_equal_3 := (settings_first_disparity / 16) = 0;
      if (settings_last_disparity mod 2) = 1 then
        other_18_choice := slice1mask_searched_5_value;
      else
        other_18_choice := slice1mask_searched_5_all;
      end if;
      if slice1mask_searched_5_value_4 then
        other_18_choice_2 := (not (((settings_first_disparity / 16) mod 2) = 1)) and (((settings_first_disparity / 2)
          mod 4) = 0);
      else
        other_18_choice_2 := not (((settings_first_disparity / 16) mod 2) = 1);
      end if;
      other_18_value := ((settings_last_disparity / 32) mod 2) = 1;
      if (not other_18_choice) and (not ((settings_last_disparity / 128) = 1)) and (not slice1mask_searched_5_value_6)
        and (not (((settings_last_disparity / 16) mod 2) = 1)) then
        other_18_choice_3 := other_18_choice_2 and slice1mask_searched_5_is_equal and slice0window_tag_start_of_frame
          and slice1window_centre_output_column_1 and slice0window_tag_valid and other_18_value;
      else
        other_18_choice_3 := other_18_choice_2 and slice1mask_searched_5_is_equal and slice0window_tag_start_of_frame
          and slice1window_centre_output_column_1 and slice0window_tag_valid;
      end if;
      other_22_any := (not slice1mask_searched_5_value_2) or (not slice1mask_searched_5_value_3);
      other_22_all := (not (((settings_last_disparity / 16) mod 2) = 1)) and other_22_any;
      if (settings_last_disparity mod 2) = 1 then
        other_22_choice := (not (((settings_last_disparity / 16) mod 2) = 1)) and (not slice1mask_searched_5_value_2);
      else
        other_22_choice := other_22_all;
      end if;
      other_22_value := ((settings_first_disparity / 2) mod 2) = 1;
      other_22_any_2 := (not slice1mask_searched_5_value_5) or (not other_22_value);
      other_22_is_equal := (settings_first_disparity / 8) = 0;
      if other_22_choice and (not ((settings_last_disparity / 128) = 1)) and (not slice1mask_searched_5_value_6) and
        (not slice1mask_searched_5_value) then
        other_22_choice_2 := other_22_any_2 and other_22_is_equal and slice0window_change_tag_valid and
          slice1window_centre_start_of_frame_0 and slice0window_centre_output_column_1 and other_18_value;
      else
        other_22_choice_2 := other_22_any_2 and other_22_is_equal and slice0window_change_tag_valid and
          slice1window_centre_start_of_frame_0 and slice0window_centre_output_column_1;
      end if;
      other_22_all_2 := slice0window_change_tag_valid and slice1window_centre_start_of_frame_0 and
        slice0window_centre_output_column_1;
      if (settings_last_disparity mod 2) = 1 then
        other_24_choice := (not other_18_value) and other_17_is_equal;
      else
        other_24_choice := (not other_18_value) and (not slice1mask_searched_5_value_2);
      end if;
      other_24_is_equal := (settings_first_disparity / 4) = 0;
      if other_24_choice and (not ((settings_last_disparity / 128) = 1)) and (((settings_last_disparity / 8) mod 4) =
        0) then
        other_24_choice_2 := other_24_is_equal and slice0window_change_tag_valid and
          slice1window_centre_start_of_frame_0 and slice0window_centre_output_column_1 and
          slice1mask_searched_5_value_6;
      else
        other_24_choice_2 := other_24_is_equal and slice0window_change_tag_valid and
          slice1window_centre_start_of_frame_0 and slice0window_centre_output_column_1;
      end if;
      other_26_is_equal := (settings_first_disparity / 2) = 0;
      if other_17_is_equal_2 then
        other_26_choice := ((settings_last_disparity mod 16) /= 0) and other_26_is_equal and
          slice0window_change_tag_valid and slice1window_centre_start_of_frame_0 and
          slice0window_centre_output_column_1;
      else
        other_26_choice := other_26_is_equal and slice0window_change_tag_valid and slice1window_centre_start_of_frame_0
          and slice0window_centre_output_column_1;
      end if;
      if other_22_all_2 then
        other_27_choice := (settings_first_disparity mod 16) = 0;
      else
        other_27_choice := other_27;
      end if;
      other_0 <= as_number(((transform_left_code_row_after_0 - transform_left_code_row_before_0) < 0)) * 8192;
      other_1 <= as_number((((other_2 / 2) - transform_left_code_row_centre_0) < 0)) * 8192;
      other_2 <= ((transform_left_code_row_box_0_0 + transform_left_code_row_column_0_3) / 2) * 2;
      other_3 <= other_4;
      other_4 <= (as_number(transform_valid) * 256) + as_number(((transform_counter_column = 5) and
        (transform_counter_group = 4)));
      other_7 <= ((map_rows_ready_words_0 mod 8192) / 2) * 2;
      other_8 <= other_9;
      other_9 <= to_unsigned(as_number(((((map_counter_group + 65535) mod 65536) - size_windows_groups) < 0)), 1) &
        to_unsigned(as_number(leftright_checked_tag_row_start_all), 8) & to_unsigned(as_number((map_counter_group =
        1)), 8) & to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other_10 <= ((refinement_remainder_7_0_difference / 1024) * 2) + ((other_11 / 4) * 4);
      other_11 <= ((refinement_remainder_6_0_difference / 1024) * 4) + ((other_12 / 8) * 8);
      other_12 <= ((refinement_remainder_5_0_difference / 1024) * 8) + ((other_13 / 16) * 16);
      other_13 <= ((refinement_remainder_4_0_difference / 1024) * 16) + ((other_14 / 32) * 32);
      other_14 <= ((refinement_remainder_3_0_difference / 1024) * 32) + ((other_15 / 64) * 64);
      other_15 <= ((refinement_remainder_2_0_difference / 1024) * 64) + ((other_16 / 128) * 128);
      other_16 <= (refinement_remainder_1_0_difference / 1024) * 128;
      other_17 <= ((not (slice1mask_searched_5_value_4 and (slice1mask_searched_5_value_5 or ((settings_first_disparity
        mod 4) = 3)))) and (not (((not slice1mask_searched_5_value) or other_17_is_equal) and other_17_is_equal_2)) and
        slice0window_tag_start_of_frame and slice1window_centre_output_column_1 and slice0window_tag_valid and
        other_17_is_equal_3) or ((not slice1mask_searched_5_all_2) and other_17);
      other_18 <= other_18_choice_3 or ((not slice1mask_searched_5_all_2) and other_18);
      other_22 <= other_22_choice_2 or ((not other_22_all_2) and other_22);
      other_23 <= (((settings_last_disparity / 4) /= 0) and ((not slice1mask_searched_5_value_5) or
        ((settings_first_disparity mod 4) = 0)) and slice0window_change_tag_valid and
        slice1window_centre_start_of_frame_0 and slice0window_centre_output_column_1 and other_22_is_equal) or ((not
        other_22_all_2) and other_23);
      other_24 <= other_24_choice_2 or ((not other_22_all_2) and other_24);
      other_25 <= (((not other_22_value) or (not ((settings_first_disparity mod 2) = 1))) and ((settings_last_disparity
        / 2) /= 0) and slice0window_change_tag_valid and slice1window_centre_start_of_frame_0 and
        slice0window_centre_output_column_1 and other_24_is_equal) or ((not other_22_all_2) and other_25);
      other_26 <= other_26_choice or ((not other_22_all_2) and other_26);
      other_28 <= (((transform_right_code_next_row_outer_0 / 2) - transform_right_code_next_row_centre_0) mod 32768) *
        2;
      other_29 <= as_number(((transform_right_code_row_after_0 - transform_right_code_row_before_0) < 0)) * 8192;
      other_30 <= as_number((((other_31 / 2) - transform_right_code_row_centre_0) < 0)) * 8192;
      other_31 <= ((transform_right_code_row_box_0_0 + transform_right_code_row_column_0_3) / 2) * 2;
      other_32 <= (((transform_left_code_next_row_outer_0 / 2) - transform_left_code_next_row_centre_0) mod 32768) * 2;
      if 1 < in_image_width then
        other_5 <= 1;
      else
        other_5 <= (1 - in_image_width) mod 65536;
      end if;
      if 4 < in_image_width then
        other_6 <= 4;
      else
        other_6 <= (4 - in_image_width) mod 65536;
      end if;
      if other_17_is_equal_3 then
        other_27 <= other_27_choice;
      else
        other_27 <= (not other_22_all_2) and other_27;
      end if;
      if (settings_last_disparity mod 2) = 1 then
        other_20_choice := other_22_all;
      else
        other_20_choice := not (((settings_last_disparity / 16) mod 2) = 1);
      end if;
      if slice1mask_searched_5_all_2 then
        other_21 <= ((not slice1mask_searched_5_value_5) or (not other_22_value) or (not ((settings_first_disparity mod
          2) = 1))) and (not (other_22_any and ((settings_last_disparity / 8) = 0))) and other_22_is_equal;
        if ((settings_last_disparity / 8) mod 16) = 0 then
          other_19 <= (not (slice1mask_searched_5_value_4 and (slice1mask_searched_5_value_5 or other_22_value or
            ((settings_first_disparity mod 2) = 1)))) and other_17_is_equal_3 and ((settings_last_disparity / 128) = 1);
        else
          other_19 <= (not (slice1mask_searched_5_value_4 and (slice1mask_searched_5_value_5 or other_22_value or
            ((settings_first_disparity mod 2) = 1)))) and other_17_is_equal_3;
        end if;
        if other_20_choice and (not ((settings_last_disparity / 128) = 1)) and (not slice1mask_searched_5_value_6) and
          (not slice1mask_searched_5_value) then
          other_20 <= other_22_is_equal and other_18_value;
        else
          other_20 <= other_22_is_equal;
        end if;
      end if;
      if reset = '1' then
        size_windows_last_column <= 39;
        size_windows_last_group <= 25;
        size_windows_groups <= 26;
        size_windows_idle <= 27;
        size_map_last_column <= 36;
        size_transform_last_counted <= 29;
        size_transform_idle <= 30;
        size_map_columns_to <= 37;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 30;
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
        raster_place_group <= 27;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_column <= 0;
        delay_tag_valid <= false;
        delay_tag_row_start <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_read_column <= 0;
        rows_read_tag_valid <= false;
        rows_read_tag_row_start <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_tag_valid <= false;
        rows_ready_tag_row_start <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_tag_valid <= false;
        rows_tag_row_start <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_row_start <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_row_start <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_read_column <= 0;
        slice0cost_change_column <= 0;
        slice0cost_ready_column <= 0;
        slice0cost_ready_tag_valid <= false;
        slice0cost_ready_tag_map_column <= false;
        slice0cost_ready_tag_output_column <= false;
        slice0cost_ready_tag_start_of_frame <= false;
        slice0cost_ready_tag_end_of_line <= false;
        slice0cost_write_column <= 0;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_ring_read_address <= 1;
        slice0window_ring_write_address <= 0;
        slice0window_entering_tag_valid <= false;
        slice0window_entering_tag_map_column <= false;
        slice0window_entering_tag_output_column <= false;
        slice0window_entering_tag_start_of_frame <= false;
        slice0window_entering_tag_end_of_line <= false;
        slice0window_change_tag_valid <= false;
        slice0window_change_tag_map_column <= false;
        slice0window_change_tag_output_column <= false;
        slice0window_change_tag_start_of_frame <= false;
        slice0window_change_tag_end_of_line <= false;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_start_of_frame_1 <= false;
        slice0window_centre_end_of_line_0 <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        slice0winner1_tag_valid <= false;
        slice0winner1_tag_map_column <= false;
        slice0winner1_tag_output_column <= false;
        slice0winner1_tag_start_of_frame <= false;
        slice0winner1_tag_end_of_line <= false;
        slice0winner2_tag_valid <= false;
        slice0winner2_tag_map_column <= false;
        slice0winner2_tag_output_column <= false;
        slice0winner2_tag_start_of_frame <= false;
        slice0winner2_tag_end_of_line <= false;
        slice0winner3_tag_valid <= false;
        slice0winner3_tag_map_column <= false;
        slice0winner3_tag_output_column <= false;
        slice0winner3_tag_start_of_frame <= false;
        slice0winner3_tag_end_of_line <= false;
        slice0_best_tag_valid <= false;
        slice0_best_tag_map_column <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1cost_read_column <= 0;
        slice1cost_change_column <= 0;
        slice1cost_ready_column <= 0;
        slice1cost_write_column <= 0;
        slice1window_ring_read_address <= 1;
        slice1window_ring_write_address <= 0;
        slice1window_change_tag_output_column <= false;
        slice1window_change_tag_start_of_frame <= false;
        slice1window_centre_map_column_0 <= false;
        slice1window_centre_output_column_0 <= false;
        slice1window_centre_output_column_1 <= false;
        slice1window_centre_end_of_line_0 <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_map_column <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
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
        refinement_tag_10_valid <= false;
        refinement_tag_10_map_column <= false;
        refinement_tag_10_output_column <= false;
        refinement_tag_10_start_of_frame <= false;
        refinement_tag_10_end_of_line <= false;
        refinement_tag_11_valid <= false;
        refinement_tag_11_map_column <= false;
        refinement_tag_11_output_column <= false;
        refinement_tag_11_start_of_frame <= false;
        refinement_tag_11_end_of_line <= false;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_valid <= false;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_output_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_row_start <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 27;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
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
        other_3 <= 0;
        other_4 <= 0;
        other_5 <= 1;
        other_8 <= to_unsigned(0, 49);
        other_9 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
