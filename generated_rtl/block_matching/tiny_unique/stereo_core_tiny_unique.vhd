-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration tiny_unique: 32x12, 8 disparities, window 3x3, 1 pixel pair a clock.
-- Options: disparities 8, uniqueness_percent 15, slice_disparities 3.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config tiny_unique
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_tiny_unique is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    disparities : positive := 8;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 19;
    flush_groups : positive := 32;
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
  assert width_px = 32 report "stereo_core_tiny_unique: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_core_tiny_unique: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert disparities = 8 report "stereo_core_tiny_unique: disparities is " & integer'image(disparities) & " but this core has 8" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_tiny_unique: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_tiny_unique: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_tiny_unique: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 19 report "stereo_core_tiny_unique: latency_clocks is " & integer'image(latency_clocks) & " but this core has 19" severity failure;
  assert flush_groups = 32 report "stereo_core_tiny_unique: flush_groups is " & integer'image(flush_groups) & " but this core has 32" severity failure;
  assert gap_groups = 0 report "stereo_core_tiny_unique: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_tiny_unique is
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
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(15 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0, rows_search_0 : natural range 0 to 255;
  signal rows_search_1, rows_search_2, rows_reference_0, rows_reference_1, rows_reference_2 : natural range 0 to 255;
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 65535;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 65535;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 31;
  signal rows_read_inside_0, rows_read_inside_1, rows_read_inside_2, rows_read_tag_valid : boolean;
  signal rows_read_tag_border_column, rows_read_tag_output_column, rows_read_tag_start_of_frame : boolean;
  signal rows_read_tag_end_of_line, rows_ready_inside_0, rows_ready_inside_1, rows_ready_inside_2 : boolean;
  signal rows_ready_tag_valid, rows_ready_tag_border_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line, rows_tag_valid, rows_tag_border_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0_0, slice0shift_search_0_1, slice0shift_search_0_2 : natural range 0 to 255;
  signal slice0shift_search_1_0, slice0shift_search_1_1, slice0shift_search_1_2 : natural range 0 to 255;
  signal slice0shift_search_2_0, slice0shift_search_2_1, slice0shift_search_2_2 : natural range 0 to 255;
  signal slice0shift_reference_0, slice0shift_reference_1, slice0shift_reference_2 : natural range 0 to 255;
  signal slice0shift_search_out_0, slice0shift_search_out_1, slice0shift_search_out_2 : natural range 0 to 255;
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_difference_0_0, slice0cost_difference_0_1, slice0cost_difference_0_2 : integer range -255 to 255;
  signal slice0cost_difference_1_0, slice0cost_difference_1_1, slice0cost_difference_1_2 : integer range -255 to 255;
  signal slice0cost_difference_2_0, slice0cost_difference_2_1, slice0cost_difference_2_2 : integer range -255 to 255;
  signal slice0cost_difference_tag_valid, slice0cost_difference_tag_border_column : boolean;
  signal slice0cost_difference_tag_output_column, slice0cost_difference_tag_start_of_frame : boolean;
  signal slice0cost_difference_tag_end_of_line, slice0cost_negative_0_0, slice0cost_negative_0_1 : boolean;
  signal slice0cost_negative_0_2, slice0cost_pair_tag_valid, slice0cost_pair_tag_border_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_start_of_frame : boolean;
  signal slice0cost_pair_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_border_column : boolean;
  signal slice0cost_tag_output_column, slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pair_0_0, slice0cost_pair_0_1, slice0cost_pair_0_2 : natural range 0 to 511;
  signal slice0cost_single_0_0, slice0cost_single_0_1, slice0cost_single_0_2 : natural range 0 to 255;
  signal slice0cost_column_0_0, slice0cost_column_0_1, slice0cost_column_0_2 : natural range 0 to 767;
  -- slice0window
  signal slice0window_partial_0_0_0, slice0window_partial_0_0_1, slice0window_partial_0_0_2 : natural range 0 to 767;
  signal slice0window_partial_0_1_0, slice0window_partial_0_1_1, slice0window_partial_0_1_2 : natural range 0 to 1534;
  signal slice0window_centre_output_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_output_column : boolean;
  signal slice0window_tag_start_of_frame, slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0_0, slice0window_sum_0_1, slice0window_sum_0_2 : natural range 0 to 2301;
  -- slice0winner1
  signal slice0winner1_held_0_0, slice0winner1_held_0_1, slice0winner1_held_0_2 : natural range 0 to 2301;
  signal slice0winner1_best_cost_0_0, slice0winner1_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice0winner1_best_late_cost_0_1 : natural range 0 to 2301;
  signal slice0winner1_best_index_0_0, slice0winner1_tag_valid, slice0winner1_tag_output_column : boolean;
  signal slice0winner1_tag_start_of_frame, slice0winner1_tag_end_of_line : boolean;
  signal slice0winner1_best_index_0_1 : natural range 0 to 2;
  signal slice0winner1_best_but_first_0_0, slice0winner1_best_but_last_0_0 : natural range 0 to 4095;
  -- slice0winner2
  signal slice0winner2_best_cost_0_0, slice0winner2_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice0winner2_best_index_0_0 : natural range 0 to 2;
  signal slice0winner2_best_place_0_0, slice0winner2_best_at_start_0_0, slice0winner2_best_at_end_0_0 : boolean;
  signal slice0winner2_tag_valid, slice0winner2_tag_output_column, slice0winner2_tag_start_of_frame : boolean;
  signal slice0winner2_tag_end_of_line : boolean;
  signal slice0winner2_best_second_0_0, slice0winner2_best_but_first_0_0 : natural range 0 to 4095;
  -- slice0
  signal slice0_best_index_0_0 : natural range 0 to 7;
  signal slice0_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice0_best_second_0_0, slice0_best_but_first_0_0 : natural range 0 to 4095;
  signal slice0_best_tag_valid, slice0_best_tag_output_column, slice0_best_tag_start_of_frame : boolean;
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
  signal slice1winner1_held_0_0, slice1winner1_held_0_1, slice1winner1_held_0_2 : natural range 0 to 2301;
  signal slice1winner1_best_cost_0_0, slice1winner1_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice1winner1_best_late_cost_0_1 : natural range 0 to 2301;
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_but_first_0_0, slice1winner1_best_but_last_0_0 : natural range 0 to 4095;
  -- slice1winner2
  signal slice1winner2_best_cost_0_0, slice1winner2_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice1winner2_best_index_0_0 : natural range 0 to 2;
  signal slice1winner2_best_place_0_0, slice1winner2_best_at_start_0_0, slice1winner2_best_at_end_0_0 : boolean;
  signal slice1winner2_best_second_0_0, slice1winner2_best_but_first_0_0 : natural range 0 to 4095;
  signal slice1winner2_best_but_last_0_0 : natural range 0 to 4095;
  -- slice1
  signal slice1_best_cost_0_0, slice1_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice1_best_index_0_0 : natural range 0 to 7;
  signal slice1_best_place_0_0, slice1_best_at_start_0_0, slice1_best_at_end_0_0, slice1_best_tag_valid : boolean;
  signal slice1_best_tag_output_column, slice1_best_tag_start_of_frame, slice1_best_tag_end_of_line : boolean;
  signal slice1_best_second_0_0, slice1_best_but_first_0_0 : natural range 0 to 4095;
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
  signal slice2winner1_held_0_0, slice2winner1_best_cost_0_0 : natural range 0 to 2301;
  signal slice2winner1_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_but_last_0_0 : natural range 0 to 4095;
  -- slice2winner2
  signal slice2winner2_best_index_0_0 : boolean;
  signal slice2winner2_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice2winner2_best_but_last_0_0 : natural range 0 to 4095;
  -- slice2
  signal slice2_best_cost_0_0, slice2_best_late_cost_0_0 : natural range 0 to 2301;
  signal slice2_best_index_0_0 : natural range 0 to 7;
  signal slice2_best_place_0_0, slice2_best_at_start_0_0, slice2_best_at_end_0_0, slice2_best_tag_valid : boolean;
  signal slice2_best_tag_output_column, slice2_best_tag_start_of_frame, slice2_best_tag_end_of_line : boolean;
  signal slice2_best_second_0_0 : natural range 0 to 4095;
  -- refinement
  signal refinement_disparity_0_0, refinement_disparity_1_0, refinement_disparity_2_0 : natural range 0 to 7;
  signal refinement_disparity_3_0 : natural range 0 to 7;
  signal refinement_passed_0_0, refinement_passed_1_0, refinement_passed_2_0, refinement_passed_3_0 : boolean;
  signal refinement_tag_0_valid, refinement_tag_0_output_column, refinement_tag_0_start_of_frame : boolean;
  signal refinement_tag_0_end_of_line, refinement_tag_1_valid, refinement_tag_1_output_column : boolean;
  signal refinement_tag_1_start_of_frame, refinement_tag_1_end_of_line, refinement_tag_2_valid : boolean;
  signal refinement_tag_2_output_column, refinement_tag_2_start_of_frame, refinement_tag_2_end_of_line : boolean;
  signal refinement_tag_3_valid, refinement_tag_3_output_column, refinement_tag_3_start_of_frame : boolean;
  signal refinement_tag_3_end_of_line, refinement_alone_0_0, refinement_alone_1_0 : boolean;
  signal refinement_gap_0 : natural range 0 to 4095;
  signal refinement_lowest_0 : natural range 0 to 2301;
  signal refinement_scaled_gap_0 : natural range 0 to 81900;
  signal refinement_scaled_cost_0 : natural range 0 to 6903;
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
  disparity <= std_logic_vector(to_unsigned(refinement_disparity_3_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(refinement_passed_3_0), 1));
  disparity_valid <= as_bit(refinement_tag_3_valid and refinement_tag_3_output_column);
  disparity_start_of_frame <= as_bit(refinement_tag_3_start_of_frame and refinement_tag_3_valid and refinement_tag_3_output_column);
  disparity_end_of_line <= as_bit(refinement_tag_3_end_of_line and refinement_tag_3_valid and refinement_tag_3_output_column);

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
    variable raster_place_next_frame_choice_2, delay_row_inside_1_is_not_less, delay_row_inside_1_is_less : boolean;
    variable slice0winner1_best_cost_0_0_is_less, slice0winner2_best_cost_0_0_is_less : boolean;
    variable slice1winner1_best_cost_0_0_is_less, slice1winner2_best_cost_0_0_is_less : boolean;
    variable slice1_best_cost_0_0_is_less, slice2winner1_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less : boolean;
    variable raster_place_group_choice : natural range 0 to 3;
    variable raster_place_group_choice_3, raster_place_group_choice_4 : natural range 0 to 15;
    variable slice0winner2_best_second_0_0_choice, slice0winner2_best_second_0_0_choice_2 : natural range 0 to 4095;
    variable slice0winner2_best_second_0_0_choice_3, slice1winner2_best_second_0_0_choice : natural range 0 to 4095;
    variable slice1winner2_best_second_0_0_choice_2, slice1winner2_best_second_0_0_choice_3 : natural range 0 to 4095;
    variable slice1_best_second_0_0_choice, slice1_best_second_0_0_choice_2 : natural range 0 to 4095;
    variable slice1_best_second_0_0_choice_3, slice1_best_second_0_0_choice_4 : natural range 0 to 4095;
    variable slice2_best_second_0_0_choice, slice2_best_second_0_0_choice_2 : natural range 0 to 4095;
    variable slice2_best_second_0_0_choice_3, slice2_best_second_0_0_choice_4 : natural range 0 to 4095;
    variable slice1_best_index_0_0_sum : natural range 1 to 2;
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
      raster_features_search_0 <= in_left_pixel;
      raster_features_reference_0 <= in_right_pixel;
      raster_features_valid <= in_valid;
      if in_start_of_frame and in_valid then
        raster_place_group <= raster_place_group_choice * 4;
      else
        raster_place_group <= raster_place_group_choice_4;
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
        if delay_ring_read_address = 7 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 8;
        end if;
      end if;
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 13;
      delay_ahead_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside_0 <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 12;
      delay_row_inside_1 <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside_2 <= (not ((raster_place_group / 8) = 1)) or (not (((raster_place_group / 4) mod 2) = 1));
      delay_tag_valid <= raster_features_valid;
      delay_tag_output_column <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less and (raster_place_column
        >= 7) and (raster_place_column < 31);
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
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside_0 <= rows_read_inside_0;
      rows_ready_inside_1 <= rows_read_inside_1;
      rows_ready_inside_2 <= rows_read_inside_2;
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
      slice0shift_tag_output_column <= rows_tag_output_column;
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
      slice0cost_difference_tag_output_column <= slice0shift_tag_output_column;
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
      slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
      slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
      slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      slice0window_sum_0_0 <= slice0cost_column_0_0 + slice0window_partial_0_1_0;
      slice0window_sum_0_1 <= slice0cost_column_0_1 + slice0window_partial_0_1_1;
      slice0window_sum_0_2 <= slice0cost_column_0_2 + slice0window_partial_0_1_2;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0winner1
      slice0winner1_best_cost_0_0_is_less := (slice0window_sum_0_1 - slice0window_sum_0_0) < 0;
      slice0winner1_held_0_0 <= slice0window_sum_0_0;
      slice0winner1_held_0_1 <= slice0window_sum_0_1;
      slice0winner1_held_0_2 <= slice0window_sum_0_2;
      slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_0_is_less;
      slice0winner1_best_index_0_1 <= 2;
      slice0winner1_best_late_cost_0_0 <= slice0winner1_best_cost_0_0;
      slice0winner1_best_late_cost_0_1 <= slice0winner1_held_0_2;
      slice0winner1_best_but_first_0_0 <= slice0winner1_held_0_1;
      slice0winner1_best_but_last_0_0 <= slice0winner1_held_0_0;
      slice0winner1_tag_valid <= slice0window_tag_valid;
      if slice0winner1_best_cost_0_0_is_less then
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_1;
      else
        slice0winner1_best_cost_0_0 <= slice0window_sum_0_0;
      end if;
      if slice0winner1_tag_valid then
        slice0winner1_tag_output_column <= slice0window_tag_output_column;
        slice0winner1_tag_start_of_frame <= slice0window_tag_start_of_frame;
        slice0winner1_tag_end_of_line <= slice0window_tag_end_of_line;
      end if;
      -- slice0winner2
      slice0winner2_best_cost_0_0_is_less := (slice0winner1_held_0_2 - slice0winner1_best_cost_0_0) < 0;
      if (not slice0winner2_best_at_end_0_0) and (not slice0winner2_best_at_start_0_0) then
        slice0winner2_best_second_0_0_choice := slice0winner1_best_late_cost_0_1;
      else
        slice0winner2_best_second_0_0_choice := 4095;
      end if;
      if slice0winner2_best_at_start_0_0 then
        slice0winner2_best_second_0_0_choice_2 := slice0winner1_best_late_cost_0_0;
      else
        slice0winner2_best_second_0_0_choice_2 := 4095;
      end if;
      if slice0winner2_best_place_0_0 then
        slice0winner2_best_second_0_0_choice_3 := slice0winner1_best_but_last_0_0;
      else
        slice0winner2_best_second_0_0_choice_3 := slice0winner2_best_second_0_0_choice_2;
      end if;
      slice0winner2_best_place_0_0 <= slice0winner2_best_cost_0_0_is_less and refinement_passed_0_0;
      slice0winner2_best_at_start_0_0 <= slice0winner2_best_cost_0_0_is_less;
      slice0winner2_best_at_end_0_0 <= slice0winner1_best_index_0_0 and ((slice0winner1_held_0_2 -
        slice0winner1_best_cost_0_0) >= 0);
      slice0winner2_best_late_cost_0_0 <= slice0winner2_best_cost_0_0;
      slice0winner2_tag_valid <= slice0winner1_tag_valid;
      slice0winner2_tag_output_column <= slice0winner1_tag_output_column;
      slice0winner2_tag_start_of_frame <= slice0winner1_tag_start_of_frame;
      slice0winner2_tag_end_of_line <= slice0winner1_tag_end_of_line;
      if slice0winner2_best_cost_0_0_is_less then
        slice0winner2_best_cost_0_0 <= slice0winner1_held_0_2;
        slice0winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice0winner2_best_cost_0_0 <= slice0winner1_best_cost_0_0;
        slice0winner2_best_index_0_0 <= as_number(slice0winner1_best_index_0_0);
      end if;
      if (slice0winner2_best_second_0_0_choice - slice0winner2_best_second_0_0_choice_3) < 0 then
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice;
      else
        slice0winner2_best_second_0_0 <= slice0winner2_best_second_0_0_choice_3;
      end if;
      if (slice0winner1_best_late_cost_0_1 - slice0winner1_best_but_first_0_0) < 0 then
        slice0winner2_best_but_first_0_0 <= slice0winner1_best_late_cost_0_1;
      else
        slice0winner2_best_but_first_0_0 <= slice0winner1_best_but_first_0_0;
      end if;
      -- slice0
      slice0_best_index_0_0 <= slice0winner2_best_index_0_0 + 5;
      slice0_best_late_cost_0_0 <= slice0winner2_best_late_cost_0_0;
      slice0_best_second_0_0 <= slice0winner2_best_second_0_0;
      slice0_best_but_first_0_0 <= slice0winner2_best_but_first_0_0;
      slice0_best_tag_valid <= slice0winner2_tag_valid;
      slice0_best_tag_output_column <= slice0winner2_tag_output_column;
      slice0_best_tag_start_of_frame <= slice0winner2_tag_start_of_frame;
      slice0_best_tag_end_of_line <= slice0winner2_tag_end_of_line;
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
      slice1winner1_best_cost_0_0_is_less := (slice1window_sum_0_1 - slice1window_sum_0_0) < 0;
      slice1winner1_held_0_0 <= slice1window_sum_0_0;
      slice1winner1_held_0_1 <= slice1window_sum_0_1;
      slice1winner1_held_0_2 <= slice1window_sum_0_2;
      slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_0_is_less;
      slice1winner1_best_late_cost_0_0 <= slice1winner1_best_cost_0_0;
      slice1winner1_best_late_cost_0_1 <= slice1winner1_held_0_2;
      slice1winner1_best_but_first_0_0 <= slice1winner1_held_0_1;
      slice1winner1_best_but_last_0_0 <= slice1winner1_held_0_0;
      if slice1winner1_best_cost_0_0_is_less then
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_1;
      else
        slice1winner1_best_cost_0_0 <= slice1window_sum_0_0;
      end if;
      -- slice1winner2
      slice1winner2_best_cost_0_0_is_less := (slice1winner1_held_0_2 - slice1winner1_best_cost_0_0) < 0;
      if (not slice1winner2_best_at_end_0_0) and (not slice1winner2_best_at_start_0_0) then
        slice1winner2_best_second_0_0_choice := slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_second_0_0_choice := 4095;
      end if;
      if slice1winner2_best_at_start_0_0 then
        slice1winner2_best_second_0_0_choice_2 := slice1winner1_best_late_cost_0_0;
      else
        slice1winner2_best_second_0_0_choice_2 := 4095;
      end if;
      if slice1winner2_best_place_0_0 then
        slice1winner2_best_second_0_0_choice_3 := slice1winner1_best_but_last_0_0;
      else
        slice1winner2_best_second_0_0_choice_3 := slice1winner2_best_second_0_0_choice_2;
      end if;
      slice1winner2_best_place_0_0 <= refinement_passed_0_0 and slice1winner2_best_cost_0_0_is_less;
      slice1winner2_best_at_start_0_0 <= slice1winner2_best_cost_0_0_is_less;
      slice1winner2_best_at_end_0_0 <= slice1winner1_best_index_0_0 and ((slice1winner1_held_0_2 -
        slice1winner1_best_cost_0_0) >= 0);
      slice1winner2_best_late_cost_0_0 <= slice1winner2_best_cost_0_0;
      slice1winner2_best_but_last_0_0 <= slice1winner1_best_late_cost_0_0;
      if slice1winner2_best_cost_0_0_is_less then
        slice1winner2_best_cost_0_0 <= slice1winner1_held_0_2;
        slice1winner2_best_index_0_0 <= slice0winner1_best_index_0_1;
      else
        slice1winner2_best_cost_0_0 <= slice1winner1_best_cost_0_0;
        slice1winner2_best_index_0_0 <= as_number(slice1winner1_best_index_0_0);
      end if;
      if (slice1winner2_best_second_0_0_choice - slice1winner2_best_second_0_0_choice_3) < 0 then
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice;
      else
        slice1winner2_best_second_0_0 <= slice1winner2_best_second_0_0_choice_3;
      end if;
      if (slice1winner1_best_late_cost_0_1 - slice1winner1_best_but_first_0_0) < 0 then
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_late_cost_0_1;
      else
        slice1winner2_best_but_first_0_0 <= slice1winner1_best_but_first_0_0;
      end if;
      -- slice1
      slice1_best_cost_0_0_is_less := (slice0winner2_best_late_cost_0_0 - slice1winner2_best_cost_0_0) < 0;
      slice1_best_index_0_0_sum := (slice1winner2_best_index_0_0 / 2) + 1;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice := slice0_best_second_0_0;
      else
        slice1_best_second_0_0_choice := slice0_best_late_cost_0_0;
      end if;
      if slice1_best_at_end_0_0 then
        slice1_best_second_0_0_choice_2 := slice0_best_but_first_0_0;
      else
        slice1_best_second_0_0_choice_2 := slice1_best_second_0_0_choice;
      end if;
      if slice1_best_place_0_0 then
        slice1_best_second_0_0_choice_3 := slice1winner2_best_late_cost_0_0;
      else
        slice1_best_second_0_0_choice_3 := slice1winner2_best_second_0_0;
      end if;
      if slice1_best_at_start_0_0 then
        slice1_best_second_0_0_choice_4 := slice1winner2_best_but_last_0_0;
      else
        slice1_best_second_0_0_choice_4 := slice1_best_second_0_0_choice_3;
      end if;
      slice1_best_place_0_0 <= slice1_best_cost_0_0_is_less;
      slice1_best_at_start_0_0 <= (slice0_best_index_0_0 = 5) and slice1_best_cost_0_0_is_less;
      slice1_best_at_end_0_0 <= ((slice0winner2_best_late_cost_0_0 - slice1winner2_best_cost_0_0) >= 0) and
        (slice1_best_index_0_0_sum = 2) and (not ((slice1winner2_best_index_0_0 mod 2) = 1));
      slice1_best_late_cost_0_0 <= slice1_best_cost_0_0;
      slice1_best_tag_valid <= slice0_best_tag_valid;
      slice1_best_tag_output_column <= slice0_best_tag_output_column;
      slice1_best_tag_start_of_frame <= slice0_best_tag_start_of_frame;
      slice1_best_tag_end_of_line <= slice0_best_tag_end_of_line;
      if slice1_best_cost_0_0_is_less then
        slice1_best_cost_0_0 <= slice0winner2_best_late_cost_0_0;
        slice1_best_index_0_0 <= slice0_best_index_0_0;
      else
        slice1_best_cost_0_0 <= slice1winner2_best_cost_0_0;
        slice1_best_index_0_0 <= (slice1_best_index_0_0_sum * 2) + (slice1winner2_best_index_0_0 mod 2);
      end if;
      if (slice1_best_second_0_0_choice_2 - slice1_best_second_0_0_choice_4) < 0 then
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_2;
      else
        slice1_best_second_0_0 <= slice1_best_second_0_0_choice_4;
      end if;
      if (slice0_best_late_cost_0_0 - slice1winner2_best_but_first_0_0) < 0 then
        slice1_best_but_first_0_0 <= slice0_best_late_cost_0_0;
      else
        slice1_best_but_first_0_0 <= slice1winner2_best_but_first_0_0;
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
      if slice0winner1_tag_valid then
        slice2window_partial_0_0_0 <= slice2cost_column_0_0;
        slice2window_partial_0_0_1 <= slice2cost_column_0_1;
        slice2window_partial_0_1_0 <= slice2cost_column_0_0 + slice2window_partial_0_0_0;
        slice2window_partial_0_1_1 <= slice2cost_column_0_1 + slice2window_partial_0_0_1;
      end if;
      slice2window_sum_0_0 <= slice2cost_column_0_0 + slice2window_partial_0_1_0;
      slice2window_sum_0_1 <= slice2cost_column_0_1 + slice2window_partial_0_1_1;
      -- slice2winner1
      slice2winner1_best_cost_0_0_is_less := (slice2window_sum_0_1 - slice2window_sum_0_0) < 0;
      slice2winner1_held_0_0 <= slice2window_sum_0_0;
      slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_0_is_less;
      slice2winner1_best_late_cost_0_0 <= slice2winner1_best_cost_0_0;
      slice2winner1_best_but_last_0_0 <= slice2winner1_held_0_0;
      if slice2winner1_best_cost_0_0_is_less then
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_1;
      else
        slice2winner1_best_cost_0_0 <= slice2window_sum_0_0;
      end if;
      -- slice2winner2
      slice2winner2_best_index_0_0 <= slice2winner1_best_index_0_0;
      slice2winner2_best_late_cost_0_0 <= slice2winner1_best_late_cost_0_0;
      slice2winner2_best_but_last_0_0 <= slice2winner1_best_but_last_0_0;
      -- slice2
      slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner1_best_late_cost_0_0) < 0;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choice := slice1_best_second_0_0;
      else
        slice2_best_second_0_0_choice := slice1_best_late_cost_0_0;
      end if;
      if slice2_best_at_end_0_0 then
        slice2_best_second_0_0_choice_2 := slice1_best_but_first_0_0;
      else
        slice2_best_second_0_0_choice_2 := slice2_best_second_0_0_choice;
      end if;
      if slice2_best_place_0_0 then
        slice2_best_second_0_0_choice_3 := slice2winner2_best_late_cost_0_0;
      else
        slice2_best_second_0_0_choice_3 := 4095;
      end if;
      if slice2_best_at_start_0_0 then
        slice2_best_second_0_0_choice_4 := slice2winner2_best_but_last_0_0;
      else
        slice2_best_second_0_0_choice_4 := slice2_best_second_0_0_choice_3;
      end if;
      slice2_best_place_0_0 <= slice2_best_cost_0_0_is_less;
      slice2_best_at_start_0_0 <= (slice1_best_index_0_0 = 2) and slice2_best_cost_0_0_is_less;
      slice2_best_at_end_0_0 <= slice2winner2_best_index_0_0 and ((slice1_best_cost_0_0 -
        slice2winner1_best_late_cost_0_0) >= 0);
      slice2_best_late_cost_0_0 <= slice2_best_cost_0_0;
      slice2_best_tag_valid <= slice1_best_tag_valid;
      slice2_best_tag_output_column <= slice1_best_tag_output_column;
      slice2_best_tag_start_of_frame <= slice1_best_tag_start_of_frame;
      slice2_best_tag_end_of_line <= slice1_best_tag_end_of_line;
      if slice2_best_cost_0_0_is_less then
        slice2_best_cost_0_0 <= slice1_best_cost_0_0;
        slice2_best_index_0_0 <= slice1_best_index_0_0;
      else
        slice2_best_cost_0_0 <= slice2winner1_best_late_cost_0_0;
        slice2_best_index_0_0 <= as_number(slice2winner2_best_index_0_0);
      end if;
      if (slice2_best_second_0_0_choice_2 - slice2_best_second_0_0_choice_4) < 0 then
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_2;
      else
        slice2_best_second_0_0 <= slice2_best_second_0_0_choice_4;
      end if;
      -- refinement
      refinement_disparity_0_0 <= slice2_best_index_0_0;
      refinement_disparity_1_0 <= refinement_disparity_0_0;
      refinement_disparity_2_0 <= refinement_disparity_1_0;
      refinement_disparity_3_0 <= refinement_disparity_2_0;
      refinement_passed_0_0 <= true;
      refinement_passed_1_0 <= refinement_passed_0_0;
      refinement_passed_2_0 <= refinement_passed_1_0;
      refinement_tag_0_valid <= slice2_best_tag_valid;
      refinement_tag_0_output_column <= slice2_best_tag_output_column;
      refinement_tag_0_start_of_frame <= slice2_best_tag_start_of_frame;
      refinement_tag_0_end_of_line <= slice2_best_tag_end_of_line;
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
      refinement_alone_0_0 <= slice2_best_second_0_0 = 4095;
      refinement_alone_1_0 <= refinement_alone_0_0;
      refinement_gap_0 <= (slice2_best_second_0_0 - slice2_best_late_cost_0_0) mod 4096;
      refinement_lowest_0 <= slice2_best_late_cost_0_0;
      refinement_scaled_gap_0 <= (((refinement_gap_0 + (refinement_gap_0 / 4)) * 4) + (refinement_gap_0 mod 4)) * 4;
      refinement_scaled_cost_0 <= ((refinement_lowest_0 + (refinement_lowest_0 / 2)) * 2) + (refinement_lowest_0 mod 2);
      if refinement_alone_1_0 then
        refinement_passed_3_0 <= refinement_passed_2_0;
      else
        refinement_passed_3_0 <= refinement_passed_2_0 and ((refinement_scaled_cost_0 - refinement_scaled_gap_0) < 0);
      end if;
      if reset = '1' then
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 13;
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
        slice0_best_tag_valid <= false;
        slice0_best_tag_output_column <= false;
        slice0_best_tag_start_of_frame <= false;
        slice0_best_tag_end_of_line <= false;
        slice1_best_tag_valid <= false;
        slice1_best_tag_output_column <= false;
        slice1_best_tag_start_of_frame <= false;
        slice1_best_tag_end_of_line <= false;
        slice2_best_tag_valid <= false;
        slice2_best_tag_output_column <= false;
        slice2_best_tag_start_of_frame <= false;
        slice2_best_tag_end_of_line <= false;
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
      end if;
    end if;
  end process;
end architecture;
