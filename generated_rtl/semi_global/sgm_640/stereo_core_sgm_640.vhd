-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_640: 640x480, 128 disparities, window 1x1, P1 4, P2 24, 1 pixel pair a clock.
-- Options: disparities 128, window_px 1, reference left, census_width_px 9, cost_shift 2, p1 4, p2 24, median
--   true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_640
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_640 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 128;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 513;
    latency_clocks : positive := 52;
    flush_groups : positive := 3209;
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
  assert width_px = 640 report "stereo_core_sgm_640: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_sgm_640: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 128 report "stereo_core_sgm_640: disparities is " & integer'image(disparities) & " but this core has 128" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_640: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_sgm_640: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 513 report "stereo_core_sgm_640: output_width_px is " & integer'image(output_width_px) & " but this core has 513" severity failure;
  assert latency_clocks = 52 report "stereo_core_sgm_640: latency_clocks is " & integer'image(latency_clocks) & " but this core has 52" severity failure;
  assert flush_groups = 3209 report "stereo_core_sgm_640: flush_groups is " & integer'image(flush_groups) & " but this core has 3209" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_640: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_640 is
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

  -- whether the bit of this place is 1
  function is_set(value : natural; place : natural) return boolean is
  begin
    return (value / 2 ** place) mod 2 = 1;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_11_2d is array (natural range <>, natural range <>) of natural range 0 to 11;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_266321790_1d is array (natural range <>) of natural range 0 to 266321790;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_2_1d is array (natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_3_2d is array (natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_44_1d is array (natural range <>) of natural range 0 to 44;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_67_1d is array (natural range <>) of natural range 0 to 67;
  type natural_67_2d is array (natural range <>, natural range <>) of natural range 0 to 67;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  type unsigned_44_1d is array (natural range <>) of unsigned(43 downto 0);
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column : natural_255_1d(0 to 4);
  signal transform_right_column : natural_255_1d(0 to 4);
  signal transform_left_filter_column : natural_255_2d(0 to 8, 0 to 4);
  signal transform_right_filter_column : natural_255_2d(0 to 8, 0 to 4);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside : boolean_1d(0 to 4);
  signal transform_read_column_inside : boolean_1d(0 to 8);
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside : boolean_1d(0 to 4);
  signal transform_ready_column_inside : boolean_1d(0 to 8);
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside : boolean_1d(0 to 4);
  signal transform_columns_column_inside : boolean_1d(0 to 8);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 8);
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_read_column, transform_ready_column : natural range 0 to 1023;
  signal transform_write_column : natural range 0 to 1023;
  signal transform_counter_group : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(43 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(43 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : unsigned(43 downto 0);
  signal delay_tag_valid, delay_tag_border_column, delay_tag_first_cost, delay_tag_map_column : boolean;
  signal delay_tag_output_column, delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_0, rows_reference_0 : unsigned(43 downto 0);
  signal rows_tag_valid, rows_tag_border_column, rows_tag_first_cost, rows_tag_map_column : boolean;
  signal rows_tag_output_column, rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice0shift_reference_0, slice0shift_search_out_0 : unsigned(43 downto 0);
  signal slice0shift_tag_valid, slice0shift_tag_border_column, slice0shift_tag_first_cost : boolean;
  signal slice0shift_tag_map_column, slice0shift_tag_output_column, slice0shift_tag_start_of_frame : boolean;
  signal slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice0cost_pixels_first_0_#_count_#
  signal slice0cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice0cost_pixels_first_0_#_count_14
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_border_column : boolean;
  signal slice0cost_pixels_first_tag_first_cost, slice0cost_pixels_first_tag_map_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_start_of_frame : boolean;
  signal slice0cost_pixels_first_tag_end_of_line, slice0cost_pixels_tag_valid : boolean;
  signal slice0cost_pixels_tag_border_column, slice0cost_pixels_tag_first_cost : boolean;
  signal slice0cost_pixels_tag_map_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_start_of_frame, slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid : boolean;
  signal slice0cost_pair_tag_border_column, slice0cost_pair_tag_first_cost, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_start_of_frame : boolean;
  signal slice0cost_pair_tag_end_of_line, slice0cost_tag_valid, slice0cost_tag_border_column : boolean;
  signal slice0cost_tag_first_cost, slice0cost_tag_map_column, slice0cost_tag_output_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice0cost_single_0 : natural_44_1d(0 to 15);
  -- slice0window
  signal slice0window_tag_valid, slice0window_tag_border_column, slice0window_tag_first_cost : boolean;
  signal slice0window_tag_map_column, slice0window_tag_output_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  -- slice0
  signal slice0_held : natural_11_2d(0 to 7, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 7);  -- slice0_tag_#_valid
  signal slice0_tag_border_column : boolean_1d(0 to 4);  -- slice0_tag_#_border_column
  signal slice0_tag_first_cost : boolean_1d(0 to 7);  -- slice0_tag_#_first_cost
  signal slice0_tag_map_column : boolean_1d(0 to 7);  -- slice0_tag_#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 7);  -- slice0_tag_#_output_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 7);  -- slice0_tag_#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 7);  -- slice0_tag_#_end_of_line
  -- slice1shift
  signal slice1shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice1shift_reference_0, slice1shift_search_out_0 : unsigned(43 downto 0);
  -- slice1cost
  signal slice1cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice1cost_pixels_first_0_#_count_#
  signal slice1cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice1cost_pixels_first_0_#_count_14
  signal slice1cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice1cost_single_0 : natural_44_1d(0 to 15);
  -- slice1
  signal slice1_held : natural_11_2d(0 to 6, 0 to 15);
  -- slice2shift
  signal slice2shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice2shift_reference_0, slice2shift_search_out_0 : unsigned(43 downto 0);
  -- slice2cost
  signal slice2cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice2cost_pixels_first_0_#_count_#
  signal slice2cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice2cost_pixels_first_0_#_count_14
  signal slice2cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice2cost_single_0 : natural_44_1d(0 to 15);
  -- slice2
  signal slice2_held : natural_11_2d(0 to 5, 0 to 15);
  -- slice3shift
  signal slice3shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice3shift_reference_0, slice3shift_search_out_0 : unsigned(43 downto 0);
  -- slice3cost
  signal slice3cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice3cost_pixels_first_0_#_count_#
  signal slice3cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice3cost_pixels_first_0_#_count_14
  signal slice3cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice3cost_single_0 : natural_44_1d(0 to 15);
  -- slice3
  signal slice3_held : natural_11_2d(0 to 4, 0 to 15);
  -- slice4shift
  signal slice4shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice4shift_reference_0, slice4shift_search_out_0 : unsigned(43 downto 0);
  -- slice4cost
  signal slice4cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice4cost_pixels_first_0_#_count_#
  signal slice4cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice4cost_pixels_first_0_#_count_14
  signal slice4cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice4cost_single_0 : natural_44_1d(0 to 15);
  -- slice4
  signal slice4_held : natural_11_2d(0 to 3, 0 to 15);
  -- slice5shift
  signal slice5shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice5shift_reference_0, slice5shift_search_out_0 : unsigned(43 downto 0);
  -- slice5cost
  signal slice5cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice5cost_pixels_first_0_#_count_#
  signal slice5cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice5cost_pixels_first_0_#_count_14
  signal slice5cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice5cost_single_0 : natural_44_1d(0 to 15);
  -- slice5
  signal slice5_held : natural_11_2d(0 to 2, 0 to 15);
  -- slice6shift
  signal slice6shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice6shift_reference_0, slice6shift_search_out_0 : unsigned(43 downto 0);
  -- slice6cost
  signal slice6cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice6cost_pixels_first_0_#_count_#
  signal slice6cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice6cost_pixels_first_0_#_count_14
  signal slice6cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice6cost_single_0 : natural_44_1d(0 to 15);
  -- slice6
  signal slice6_held : natural_11_2d(0 to 1, 0 to 15);
  -- slice7shift
  signal slice7shift_search_0 : unsigned_44_1d(0 to 15);
  signal slice7shift_reference_0 : unsigned(43 downto 0);
  -- slice7cost
  signal slice7cost_pixels_first_0_count : natural_3_2d(0 to 15, 0 to 13);  -- slice7cost_pixels_first_0_#_count_#
  signal slice7cost_pixels_first_0_count_14 : natural_2_1d(0 to 15);  -- slice7cost_pixels_first_0_#_count_14
  signal slice7cost_pixels_cost_0 : natural_44_1d(0 to 15);
  signal slice7cost_single_0 : natural_44_1d(0 to 15);
  -- slice7
  signal slice7_held_0 : natural_11_1d(0 to 15);
  -- entry
  signal entry_next_cost : natural_11_1d(0 to 127);
  signal entry_cost : natural_11_1d(0 to 127);
  signal entry_next_tag_valid, entry_next_tag_first_cost, entry_next_tag_map_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_first_cost, entry_tag_map_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 1023;
  -- forward
  signal forward_smallest_smallest : natural_11_1d(0 to 63);
  signal forward_smallest_next_smallest : natural_11_1d(0 to 31);
  signal forward_smallest_next_next_smallest : natural_11_1d(0 to 15);
  signal forward_smallest_next_next_next_smallest : natural_11_1d(0 to 7);
  signal forward_smallest_next_next_next_next_smallest : natural_11_1d(0 to 3);
  signal forward_smallest_next_next_next_next_next_smallest : natural_11_1d(0 to 1);
  signal forward_smallest_next_next_next_next_next_next_smallest_0, forward_left_smallest : natural range 0 to 11;
  signal forward_above_ready_cost : natural_11_1d(0 to 127);
  signal forward_smallest_cost : natural_11_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost_delay_held : unsigned_32_1d(0 to 15);
  signal forward_above_read_words : unsigned_32_1d(0 to 20);
  signal forward_above_ready_words : unsigned_32_1d(0 to 20);
  signal forward_above_write_words : unsigned_32_1d(0 to 20);
  signal forward_left_pair : natural_63_1d(0 to 63);
  signal forward_left_tree_smallest : natural_63_1d(0 to 31);
  signal forward_left_tree_next_smallest : natural_63_1d(0 to 15);
  signal forward_left_tree_next_next_smallest : natural_63_1d(0 to 7);
  signal forward_left_tree_next_next_next_smallest : natural_63_1d(0 to 3);
  signal forward_left_tree_next_next_next_next_smallest : natural_63_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_next_smallest_0, forward_left_smallest_less : natural range 0 to 63;
  signal forward_left_g_copy : natural_63_1d(0 to 7);
  signal forward_left_g_less_copy : natural_63_1d(0 to 7);
  signal forward_left_stay_change : natural_63_1d(0 to 127);
  signal forward_left_step_change : natural_63_1d(0 to 127);
  signal forward_left_cost : natural_63_1d(0 to 127);
  signal forward_left_arrived : natural_63_1d(0 to 127);
  signal forward_above_cost : natural_63_1d(0 to 127);
  signal forward_above_beside : natural_63_1d(0 to 127);
  signal forward_above_own_0 : natural range 0 to 63;
  signal forward_above_own : natural_63_1d(2 to 125);
  signal forward_above_own_127 : natural range 0 to 63;
  signal forward_left_start_cost : natural_255_1d(0 to 9);
  signal forward_left_room : natural range 0 to 31;
  signal forward_above_stay : natural_31_1d(0 to 127);
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 12);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 6);
  signal forward_above_read_words_21 : unsigned(11 downto 0);
  signal forward_above_ready_words_21, forward_above_write_words_21 : natural range 0 to 4095;
  signal forward_above_total : natural_42_1d(0 to 127);
  signal forward_above_tree_smallest : natural_42_1d(0 to 63);
  signal forward_above_tree_next_smallest : natural_42_1d(0 to 31);
  signal forward_above_tree_next_next_smallest : natural_42_1d(0 to 15);
  signal forward_above_tree_next_next_next_smallest : natural_42_1d(0 to 7);
  signal forward_above_tree_next_next_next_next_smallest : natural_42_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_next_smallest : natural_42_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_next_smallest_0 : natural range 0 to 42;
  signal forward_above_smallest_copy : natural_42_1d(0 to 7);
  signal forward_above_delay_held : unsigned_30_1d(0 to 24);
  signal forward_above_delay_held_25 : unsigned(17 downto 0);
  signal forward_above_step : natural_67_1d(0 to 127);
  signal forward_above_column : natural_1023_1d(0 to 12);
  signal forward_above_write_column : natural range 0 to 1023;
  signal forward_sum : natural_126_1d(0 to 127);
  signal forward_cost : natural_15_2d(0 to 3, 0 to 127);
  -- sums
  signal sums_turn_read_sums : unsigned_28_1d(0 to 31);
  signal sums_sum_delay_held : unsigned_28_1d(0 to 31);
  signal sums_turn_read_costs : unsigned_32_1d(0 to 15);
  signal sums_turn_ready_costs : unsigned_32_1d(0 to 15);
  signal sums_turn_write_costs : unsigned_32_1d(0 to 15);
  signal sums_turn_read_smallest_0 : unsigned(3 downto 0);
  signal sums_turn_ready_sums : natural_268435455_1d(0 to 31);
  signal sums_turn_ready_smallest_0 : natural range 0 to 15;
  signal sums_cost : natural_15_2d(0 to 1, 0 to 127);
  signal sums_right_smallest : natural range 0 to 15;
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag_valid, sums_tag_map_column, sums_tag_output_column, sums_tag_start_of_frame : boolean;
  signal sums_tag_end_of_line : boolean;
  signal sums_tags_held_output_column : boolean_1d(0 to 4);  -- sums_tags_held_#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 4);  -- sums_tags_held_#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 4);  -- sums_tags_held_#_end_of_line
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_1023_1d(0 to 11);
  signal sums_turn_write_place : natural range 0 to 1023;
  signal sums_turn_write_sums : natural_266321790_1d(0 to 31);
  signal sums_turn_write_smallest_0 : natural range 0 to 11;
  signal sums_right_pair : natural_63_1d(0 to 63);
  signal sums_right_tree_smallest : natural_63_1d(0 to 31);
  signal sums_right_tree_next_smallest : natural_63_1d(0 to 15);
  signal sums_right_tree_next_next_smallest : natural_63_1d(0 to 7);
  signal sums_right_tree_next_next_next_smallest : natural_63_1d(0 to 3);
  signal sums_right_tree_next_next_next_next_smallest : natural_63_1d(0 to 1);
  signal sums_right_tree_next_next_next_next_next_smallest_0, sums_right_smallest_less : natural range 0 to 63;
  signal sums_right_g_copy : natural_63_1d(0 to 7);
  signal sums_right_g_less_copy : natural_63_1d(0 to 7);
  signal sums_right_stay_change : natural_63_1d(0 to 127);
  signal sums_right_step_change : natural_63_1d(0 to 127);
  signal sums_right_cost : natural_63_1d(0 to 127);
  signal sums_right_arrived : natural_63_1d(0 to 127);
  signal sums_right_start_cost : natural_255_1d(0 to 9);
  signal sums_right_room : natural range 0 to 31;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  signal sums_sum_0 : natural_127_1d(0 to 127);
  -- winnerswinner1
  signal winnerswinner1_of_pair_0 : natural_127_1d(0 to 127);
  signal winnerswinner1_pair_index_0_63 : natural range 0 to 127;
  signal winnerswinner1_of_four_0 : natural_127_1d(0 to 127);
  signal winnerswinner1_four_index_0_31 : natural range 0 to 127;
  signal winnerswinner1_best_cost_0 : natural_127_1d(0 to 31);
  signal winnerswinner1_best_index_0_31 : natural range 0 to 127;
  signal winnerswinner1_pair_index_0_0, winnerswinner1_pair_tag_valid, winnerswinner1_pair_tag_map_column : boolean;
  signal winnerswinner1_pair_tag_output_column, winnerswinner1_pair_tag_start_of_frame : boolean;
  signal winnerswinner1_pair_tag_end_of_line, winnerswinner1_four_tag_valid : boolean;
  signal winnerswinner1_four_tag_map_column, winnerswinner1_four_tag_output_column : boolean;
  signal winnerswinner1_four_tag_start_of_frame, winnerswinner1_four_tag_end_of_line : boolean;
  signal winnerswinner1_tag_valid, winnerswinner1_tag_map_column, winnerswinner1_tag_output_column : boolean;
  signal winnerswinner1_tag_start_of_frame, winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_pair_index_0_1, winnerswinner1_four_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner1_pair_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_pair_index_0_3, winnerswinner1_four_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner1_pair_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_pair_index_0_5, winnerswinner1_four_index_0_2 : natural range 0 to 11;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner1_pair_index_0_6 : natural range 0 to 13;
  signal winnerswinner1_pair_index_0_7, winnerswinner1_four_index_0_3 : natural range 0 to 15;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 15;
  signal winnerswinner1_pair_index_0_8 : natural range 0 to 17;
  signal winnerswinner1_pair_index_0_9, winnerswinner1_four_index_0_4 : natural range 0 to 19;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 19;
  signal winnerswinner1_pair_index_0_10 : natural range 0 to 21;
  signal winnerswinner1_pair_index_0_11, winnerswinner1_four_index_0_5 : natural range 0 to 23;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 23;
  signal winnerswinner1_pair_index_0_12 : natural range 0 to 25;
  signal winnerswinner1_pair_index_0_13, winnerswinner1_four_index_0_6 : natural range 0 to 27;
  signal winnerswinner1_best_index_0_6 : natural range 0 to 27;
  signal winnerswinner1_pair_index_0_14 : natural range 0 to 29;
  signal winnerswinner1_pair_index_0_15, winnerswinner1_four_index_0_7 : natural range 0 to 31;
  signal winnerswinner1_best_index_0_7 : natural range 0 to 31;
  signal winnerswinner1_pair_index_0_16 : natural range 0 to 33;
  signal winnerswinner1_pair_index_0_17, winnerswinner1_four_index_0_8 : natural range 0 to 35;
  signal winnerswinner1_best_index_0_8 : natural range 0 to 35;
  signal winnerswinner1_pair_index_0_18 : natural range 0 to 37;
  signal winnerswinner1_pair_index_0_19, winnerswinner1_four_index_0_9 : natural range 0 to 39;
  signal winnerswinner1_best_index_0_9 : natural range 0 to 39;
  signal winnerswinner1_pair_index_0_20 : natural range 0 to 41;
  signal winnerswinner1_pair_index_0_21, winnerswinner1_four_index_0_10 : natural range 0 to 43;
  signal winnerswinner1_best_index_0_10 : natural range 0 to 43;
  signal winnerswinner1_pair_index_0_22 : natural range 0 to 45;
  signal winnerswinner1_pair_index_0_23, winnerswinner1_four_index_0_11 : natural range 0 to 47;
  signal winnerswinner1_best_index_0_11 : natural range 0 to 47;
  signal winnerswinner1_pair_index_0_24 : natural range 0 to 49;
  signal winnerswinner1_pair_index_0_25, winnerswinner1_four_index_0_12 : natural range 0 to 51;
  signal winnerswinner1_best_index_0_12 : natural range 0 to 51;
  signal winnerswinner1_pair_index_0_26 : natural range 0 to 53;
  signal winnerswinner1_pair_index_0_27, winnerswinner1_four_index_0_13 : natural range 0 to 55;
  signal winnerswinner1_best_index_0_13 : natural range 0 to 55;
  signal winnerswinner1_pair_index_0_28 : natural range 0 to 57;
  signal winnerswinner1_pair_index_0_29, winnerswinner1_four_index_0_14 : natural range 0 to 59;
  signal winnerswinner1_best_index_0_14 : natural range 0 to 59;
  signal winnerswinner1_pair_index_0_30 : natural range 0 to 61;
  signal winnerswinner1_pair_index_0_31, winnerswinner1_four_index_0_15 : natural range 0 to 63;
  signal winnerswinner1_best_index_0_15 : natural range 0 to 63;
  signal winnerswinner1_pair_index_0_32 : natural range 0 to 65;
  signal winnerswinner1_pair_index_0_33, winnerswinner1_four_index_0_16 : natural range 0 to 67;
  signal winnerswinner1_best_index_0_16 : natural range 0 to 67;
  signal winnerswinner1_pair_index_0_34 : natural range 0 to 69;
  signal winnerswinner1_pair_index_0_35, winnerswinner1_four_index_0_17 : natural range 0 to 71;
  signal winnerswinner1_best_index_0_17 : natural range 0 to 71;
  signal winnerswinner1_pair_index_0_36 : natural range 0 to 73;
  signal winnerswinner1_pair_index_0_37, winnerswinner1_four_index_0_18 : natural range 0 to 75;
  signal winnerswinner1_best_index_0_18 : natural range 0 to 75;
  signal winnerswinner1_pair_index_0_38 : natural range 0 to 77;
  signal winnerswinner1_pair_index_0_39, winnerswinner1_four_index_0_19 : natural range 0 to 79;
  signal winnerswinner1_best_index_0_19 : natural range 0 to 79;
  signal winnerswinner1_pair_index_0_40 : natural range 0 to 81;
  signal winnerswinner1_pair_index_0_41, winnerswinner1_four_index_0_20 : natural range 0 to 83;
  signal winnerswinner1_best_index_0_20 : natural range 0 to 83;
  signal winnerswinner1_pair_index_0_42 : natural range 0 to 85;
  signal winnerswinner1_pair_index_0_43, winnerswinner1_four_index_0_21 : natural range 0 to 87;
  signal winnerswinner1_best_index_0_21 : natural range 0 to 87;
  signal winnerswinner1_pair_index_0_44 : natural range 0 to 89;
  signal winnerswinner1_pair_index_0_45, winnerswinner1_four_index_0_22 : natural range 0 to 91;
  signal winnerswinner1_best_index_0_22 : natural range 0 to 91;
  signal winnerswinner1_pair_index_0_46 : natural range 0 to 93;
  signal winnerswinner1_pair_index_0_47, winnerswinner1_four_index_0_23 : natural range 0 to 95;
  signal winnerswinner1_best_index_0_23 : natural range 0 to 95;
  signal winnerswinner1_pair_index_0_48 : natural range 0 to 97;
  signal winnerswinner1_pair_index_0_49, winnerswinner1_four_index_0_24 : natural range 0 to 99;
  signal winnerswinner1_best_index_0_24 : natural range 0 to 99;
  signal winnerswinner1_pair_index_0_50 : natural range 0 to 101;
  signal winnerswinner1_pair_index_0_51, winnerswinner1_four_index_0_25 : natural range 0 to 103;
  signal winnerswinner1_best_index_0_25 : natural range 0 to 103;
  signal winnerswinner1_pair_index_0_52 : natural range 0 to 105;
  signal winnerswinner1_pair_index_0_53, winnerswinner1_four_index_0_26 : natural range 0 to 107;
  signal winnerswinner1_best_index_0_26 : natural range 0 to 107;
  signal winnerswinner1_pair_index_0_54 : natural range 0 to 109;
  signal winnerswinner1_pair_index_0_55, winnerswinner1_four_index_0_27 : natural range 0 to 111;
  signal winnerswinner1_best_index_0_27 : natural range 0 to 111;
  signal winnerswinner1_pair_index_0_56 : natural range 0 to 113;
  signal winnerswinner1_pair_index_0_57, winnerswinner1_four_index_0_28 : natural range 0 to 115;
  signal winnerswinner1_best_index_0_28 : natural range 0 to 115;
  signal winnerswinner1_pair_index_0_58 : natural range 0 to 117;
  signal winnerswinner1_pair_index_0_59, winnerswinner1_four_index_0_29 : natural range 0 to 119;
  signal winnerswinner1_best_index_0_29 : natural range 0 to 119;
  signal winnerswinner1_pair_index_0_60 : natural range 0 to 121;
  signal winnerswinner1_pair_index_0_61, winnerswinner1_four_index_0_30 : natural range 0 to 123;
  signal winnerswinner1_best_index_0_30 : natural range 0 to 123;
  signal winnerswinner1_pair_index_0_62 : natural range 0 to 125;
  -- winnerswinner2
  signal winnerswinner2_of_pair_0 : natural_127_1d(0 to 31);
  signal winnerswinner2_pair_index_0_15 : natural range 0 to 127;
  signal winnerswinner2_of_four_0 : natural_127_1d(0 to 31);
  signal winnerswinner2_four_index_0_7 : natural range 0 to 127;
  signal winnerswinner2_best_cost_0 : natural_127_1d(0 to 7);
  signal winnerswinner2_best_index_0_7 : natural range 0 to 127;
  signal winnerswinner2_pair_index_0_0 : natural range 0 to 7;
  signal winnerswinner2_pair_index_0_1, winnerswinner2_four_index_0_0 : natural range 0 to 15;
  signal winnerswinner2_best_index_0_0 : natural range 0 to 15;
  signal winnerswinner2_pair_index_0_2 : natural range 0 to 23;
  signal winnerswinner2_pair_index_0_3, winnerswinner2_four_index_0_1 : natural range 0 to 31;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 31;
  signal winnerswinner2_pair_index_0_4 : natural range 0 to 39;
  signal winnerswinner2_pair_index_0_5, winnerswinner2_four_index_0_2 : natural range 0 to 47;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 47;
  signal winnerswinner2_pair_index_0_6 : natural range 0 to 55;
  signal winnerswinner2_pair_index_0_7, winnerswinner2_four_index_0_3 : natural range 0 to 63;
  signal winnerswinner2_best_index_0_3 : natural range 0 to 63;
  signal winnerswinner2_pair_index_0_8 : natural range 0 to 71;
  signal winnerswinner2_pair_index_0_9, winnerswinner2_four_index_0_4 : natural range 0 to 79;
  signal winnerswinner2_best_index_0_4 : natural range 0 to 79;
  signal winnerswinner2_pair_index_0_10 : natural range 0 to 87;
  signal winnerswinner2_pair_index_0_11, winnerswinner2_four_index_0_5 : natural range 0 to 95;
  signal winnerswinner2_best_index_0_5 : natural range 0 to 95;
  signal winnerswinner2_pair_index_0_12 : natural range 0 to 103;
  signal winnerswinner2_pair_index_0_13, winnerswinner2_four_index_0_6 : natural range 0 to 111;
  signal winnerswinner2_best_index_0_6 : natural range 0 to 111;
  signal winnerswinner2_pair_index_0_14 : natural range 0 to 119;
  signal winnerswinner2_pair_tag_valid, winnerswinner2_pair_tag_map_column : boolean;
  signal winnerswinner2_pair_tag_output_column, winnerswinner2_pair_tag_start_of_frame : boolean;
  signal winnerswinner2_pair_tag_end_of_line, winnerswinner2_four_tag_valid : boolean;
  signal winnerswinner2_four_tag_map_column, winnerswinner2_four_tag_output_column : boolean;
  signal winnerswinner2_four_tag_start_of_frame, winnerswinner2_four_tag_end_of_line : boolean;
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winnerswinner3
  signal winnerswinner3_of_pair_0 : natural_127_1d(0 to 7);
  signal winnerswinner3_pair_index_0_3 : natural range 0 to 127;
  signal winnerswinner3_of_four_0 : natural_127_1d(0 to 7);
  signal winnerswinner3_four_index_0_1 : natural range 0 to 127;
  signal winnerswinner3_best_cost_0 : natural_127_1d(0 to 1);
  signal winnerswinner3_best_index_0_1 : natural range 0 to 127;
  signal winnerswinner3_pair_index_0_0 : natural range 0 to 31;
  signal winnerswinner3_pair_index_0_1, winnerswinner3_four_index_0_0 : natural range 0 to 63;
  signal winnerswinner3_best_index_0_0 : natural range 0 to 63;
  signal winnerswinner3_pair_index_0_2 : natural range 0 to 95;
  signal winnerswinner3_pair_tag_valid, winnerswinner3_pair_tag_map_column : boolean;
  signal winnerswinner3_pair_tag_output_column, winnerswinner3_pair_tag_start_of_frame : boolean;
  signal winnerswinner3_pair_tag_end_of_line, winnerswinner3_four_tag_valid : boolean;
  signal winnerswinner3_four_tag_map_column, winnerswinner3_four_tag_output_column : boolean;
  signal winnerswinner3_four_tag_start_of_frame, winnerswinner3_four_tag_end_of_line : boolean;
  signal winnerswinner3_tag_valid, winnerswinner3_tag_map_column, winnerswinner3_tag_output_column : boolean;
  signal winnerswinner3_tag_start_of_frame, winnerswinner3_tag_end_of_line : boolean;
  -- winnerswinner4
  signal winnerswinner4_best_index_0_0 : natural range 0 to 127;
  signal winnerswinner4_tag_valid, winnerswinner4_tag_map_column, winnerswinner4_tag_output_column : boolean;
  signal winnerswinner4_tag_start_of_frame, winnerswinner4_tag_end_of_line : boolean;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 127;
  signal winners_best_tag_valid, winners_best_tag_map_column, winners_best_tag_output_column : boolean;
  signal winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 1023;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0 : natural range 0 to 383;
  signal turn_read_words_0 : unsigned(8 downto 0);
  signal turn_ready : natural range 0 to 511;
  -- map
  signal map_counter_column, map_write_column, map_at_column, map_comparing_column : natural range 0 to 1023;
  signal map_sorted_column : natural range 0 to 1023;
  signal map_counter_group : natural range 0 to 511;
  signal map_counter_next_frame, map_arrives, map_behind, map_line_ended, map_at_arrives, map_at_behind : boolean;
  signal map_at_top, map_at_output, map_of_column_0_b_below_a, map_of_column_0_c_below_a : boolean;
  signal map_of_column_0_c_below_b : boolean;
  signal map_column_passed_0 : boolean_1d(0 to 1);  -- map_column_passed_#_0
  signal map_comparing_arrives, map_comparing_behind, map_comparing_top, map_comparing_output : boolean;
  signal map_sorted_arrives, map_sorted_behind, map_sorted_top, map_sorted_output : boolean;
  signal map_passed_0 : boolean_1d(0 to 1);  -- map_passed_#_0
  signal map_window_complete, map_window_first, map_window_last, map_of_low_0_b_below_a : boolean;
  signal map_of_low_0_c_below_a, map_of_low_0_c_below_b, map_of_middle_0_b_below_a, map_of_middle_0_c_below_a : boolean;
  signal map_of_middle_0_c_below_b, map_of_high_0_b_below_a, map_of_high_0_c_below_a, map_of_high_0_c_below_b : boolean;
  signal map_of_all_0_b_below_a, map_of_all_0_c_below_a, map_of_all_0_c_below_b : boolean;
  signal map_waiting_complete : boolean_1d(0 to 2);  -- map_waiting_#_complete
  signal map_waiting_first : boolean_1d(0 to 2);  -- map_waiting_#_first
  signal map_waiting_last : boolean_1d(0 to 2);  -- map_waiting_#_last
  signal map_waiting_passed_0 : boolean_1d(0 to 2);  -- map_waiting_passed_#_0
  signal map_out_passed_0, map_out_valid, map_out_start_of_frame, map_out_end_of_line : boolean;
  signal map_newest_0, map_rows_read_newest_0, map_rows_ready_newest_0 : natural range 0 to 255;
  signal map_column : natural_255_1d(1 to 2);
  signal map_rows_read_words_0 : unsigned(16 downto 0);
  signal map_rows_ready_words_0 : natural range 0 to 131071;
  signal map_rows_write_words_0 : natural range 0 to 130815;
  signal map_of_column_0_a, map_of_column_0_b, map_of_column_0_c, map_sorted_low_0 : natural range 0 to 127;
  signal map_sorted_middle_0, map_sorted_high_0 : natural range 0 to 127;
  signal map_low_0 : natural_127_1d(0 to 2);  -- map_low_#_0
  signal map_middle_0 : natural_127_1d(0 to 2);  -- map_middle_#_0
  signal map_high_0 : natural_127_1d(0 to 2);  -- map_high_#_0
  signal map_of_low_0_a, map_of_low_0_b, map_of_low_0_c, map_of_middle_0_a, map_of_middle_0_b : natural range 0 to 127;
  signal map_of_middle_0_c, map_of_high_0_a, map_of_high_0_b, map_of_high_0_c : natural range 0 to 127;
  signal map_largest_low_0, map_median_middle_0, map_smallest_high_0, map_of_all_0_a : natural range 0 to 127;
  signal map_of_all_0_b, map_of_all_0_c, map_out_disparity_0 : natural range 0 to 127;
  -- other
  signal other_0, other_2 : unsigned(48 downto 0);
  signal other_1 : natural range 0 to 254;
  signal other : natural_44_1d(3 to 258);
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal map_rows_read_words_0_memory_read_enable : boolean;
  signal map_rows_read_words_0_memory_read_address, map_rows_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal map_rows_read_words_0_memory_write_data : unsigned(16 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal sums_sum_delay_held_31_memory_read_enable : boolean;
  signal sums_sum_delay_held_31_memory_read_address, sums_sum_delay_held_31_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_31_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_30_memory_read_enable : boolean;
  signal sums_sum_delay_held_30_memory_read_address, sums_sum_delay_held_30_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_30_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_29_memory_read_enable : boolean;
  signal sums_sum_delay_held_29_memory_read_address, sums_sum_delay_held_29_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_29_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_28_memory_read_enable : boolean;
  signal sums_sum_delay_held_28_memory_read_address, sums_sum_delay_held_28_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_28_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_27_memory_read_enable : boolean;
  signal sums_sum_delay_held_27_memory_read_address, sums_sum_delay_held_27_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_27_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_26_memory_read_enable : boolean;
  signal sums_sum_delay_held_26_memory_read_address, sums_sum_delay_held_26_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_26_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_25_memory_read_enable : boolean;
  signal sums_sum_delay_held_25_memory_read_address, sums_sum_delay_held_25_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_25_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_24_memory_read_enable : boolean;
  signal sums_sum_delay_held_24_memory_read_address, sums_sum_delay_held_24_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_24_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_23_memory_read_enable : boolean;
  signal sums_sum_delay_held_23_memory_read_address, sums_sum_delay_held_23_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_23_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_22_memory_read_enable : boolean;
  signal sums_sum_delay_held_22_memory_read_address, sums_sum_delay_held_22_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_22_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_21_memory_read_enable : boolean;
  signal sums_sum_delay_held_21_memory_read_address, sums_sum_delay_held_21_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_21_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_20_memory_read_enable : boolean;
  signal sums_sum_delay_held_20_memory_read_address, sums_sum_delay_held_20_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_20_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_19_memory_read_enable : boolean;
  signal sums_sum_delay_held_19_memory_read_address, sums_sum_delay_held_19_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_19_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_18_memory_read_enable : boolean;
  signal sums_sum_delay_held_18_memory_read_address, sums_sum_delay_held_18_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_18_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_17_memory_read_enable : boolean;
  signal sums_sum_delay_held_17_memory_read_address, sums_sum_delay_held_17_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_17_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_16_memory_read_enable : boolean;
  signal sums_sum_delay_held_16_memory_read_address, sums_sum_delay_held_16_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_16_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_15_memory_read_enable : boolean;
  signal sums_sum_delay_held_15_memory_read_address, sums_sum_delay_held_15_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_15_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_14_memory_read_enable : boolean;
  signal sums_sum_delay_held_14_memory_read_address, sums_sum_delay_held_14_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_14_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_13_memory_read_enable : boolean;
  signal sums_sum_delay_held_13_memory_read_address, sums_sum_delay_held_13_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_13_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_12_memory_read_enable : boolean;
  signal sums_sum_delay_held_12_memory_read_address, sums_sum_delay_held_12_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_12_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_11_memory_read_enable : boolean;
  signal sums_sum_delay_held_11_memory_read_address, sums_sum_delay_held_11_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_11_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_10_memory_read_enable : boolean;
  signal sums_sum_delay_held_10_memory_read_address, sums_sum_delay_held_10_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_10_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_9_memory_read_enable : boolean;
  signal sums_sum_delay_held_9_memory_read_address, sums_sum_delay_held_9_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_9_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_8_memory_read_enable : boolean;
  signal sums_sum_delay_held_8_memory_read_address, sums_sum_delay_held_8_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_8_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_7_memory_read_enable : boolean;
  signal sums_sum_delay_held_7_memory_read_address, sums_sum_delay_held_7_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_7_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_6_memory_read_enable : boolean;
  signal sums_sum_delay_held_6_memory_read_address, sums_sum_delay_held_6_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_6_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_5_memory_read_enable : boolean;
  signal sums_sum_delay_held_5_memory_read_address, sums_sum_delay_held_5_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_5_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_4_memory_read_enable : boolean;
  signal sums_sum_delay_held_4_memory_read_address, sums_sum_delay_held_4_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_4_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_3_memory_read_enable : boolean;
  signal sums_sum_delay_held_3_memory_read_address, sums_sum_delay_held_3_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_3_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_2_memory_read_enable : boolean;
  signal sums_sum_delay_held_2_memory_read_address, sums_sum_delay_held_2_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_2_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_1_memory_read_enable : boolean;
  signal sums_sum_delay_held_1_memory_read_address, sums_sum_delay_held_1_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_1_memory_write_data : unsigned(27 downto 0);
  signal sums_sum_delay_held_0_memory_read_enable : boolean;
  signal sums_sum_delay_held_0_memory_read_address, sums_sum_delay_held_0_memory_write_address : unsigned(1 downto 0);
  signal sums_sum_delay_held_0_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_31_memory_read_enable : boolean;
  signal sums_turn_read_sums_31_memory_read_address, sums_turn_read_sums_31_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_31_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_30_memory_read_enable : boolean;
  signal sums_turn_read_sums_30_memory_read_address, sums_turn_read_sums_30_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_30_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_29_memory_read_enable : boolean;
  signal sums_turn_read_sums_29_memory_read_address, sums_turn_read_sums_29_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_29_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_28_memory_read_enable : boolean;
  signal sums_turn_read_sums_28_memory_read_address, sums_turn_read_sums_28_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_28_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_27_memory_read_enable : boolean;
  signal sums_turn_read_sums_27_memory_read_address, sums_turn_read_sums_27_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_27_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_26_memory_read_enable : boolean;
  signal sums_turn_read_sums_26_memory_read_address, sums_turn_read_sums_26_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_26_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_25_memory_read_enable : boolean;
  signal sums_turn_read_sums_25_memory_read_address, sums_turn_read_sums_25_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_25_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_24_memory_read_enable : boolean;
  signal sums_turn_read_sums_24_memory_read_address, sums_turn_read_sums_24_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_24_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_23_memory_read_enable : boolean;
  signal sums_turn_read_sums_23_memory_read_address, sums_turn_read_sums_23_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_23_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_22_memory_read_enable : boolean;
  signal sums_turn_read_sums_22_memory_read_address, sums_turn_read_sums_22_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_22_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_21_memory_read_enable : boolean;
  signal sums_turn_read_sums_21_memory_read_address, sums_turn_read_sums_21_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_21_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_20_memory_read_enable : boolean;
  signal sums_turn_read_sums_20_memory_read_address, sums_turn_read_sums_20_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_20_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_19_memory_read_enable : boolean;
  signal sums_turn_read_sums_19_memory_read_address, sums_turn_read_sums_19_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_19_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_18_memory_read_enable : boolean;
  signal sums_turn_read_sums_18_memory_read_address, sums_turn_read_sums_18_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_18_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_17_memory_read_enable : boolean;
  signal sums_turn_read_sums_17_memory_read_address, sums_turn_read_sums_17_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_17_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_16_memory_read_enable : boolean;
  signal sums_turn_read_sums_16_memory_read_address, sums_turn_read_sums_16_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_16_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_15_memory_read_enable : boolean;
  signal sums_turn_read_sums_15_memory_read_address, sums_turn_read_sums_15_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_15_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_14_memory_read_enable : boolean;
  signal sums_turn_read_sums_14_memory_read_address, sums_turn_read_sums_14_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_14_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_13_memory_read_enable : boolean;
  signal sums_turn_read_sums_13_memory_read_address, sums_turn_read_sums_13_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_13_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_12_memory_read_enable : boolean;
  signal sums_turn_read_sums_12_memory_read_address, sums_turn_read_sums_12_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_12_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_11_memory_read_enable : boolean;
  signal sums_turn_read_sums_11_memory_read_address, sums_turn_read_sums_11_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_11_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_10_memory_read_enable : boolean;
  signal sums_turn_read_sums_10_memory_read_address, sums_turn_read_sums_10_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_10_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_9_memory_read_enable : boolean;
  signal sums_turn_read_sums_9_memory_read_address, sums_turn_read_sums_9_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_9_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_8_memory_read_enable : boolean;
  signal sums_turn_read_sums_8_memory_read_address, sums_turn_read_sums_8_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_8_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_7_memory_read_enable : boolean;
  signal sums_turn_read_sums_7_memory_read_address, sums_turn_read_sums_7_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_7_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_6_memory_read_enable : boolean;
  signal sums_turn_read_sums_6_memory_read_address, sums_turn_read_sums_6_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_6_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_5_memory_read_enable : boolean;
  signal sums_turn_read_sums_5_memory_read_address, sums_turn_read_sums_5_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_5_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_4_memory_read_enable : boolean;
  signal sums_turn_read_sums_4_memory_read_address, sums_turn_read_sums_4_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_4_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_3_memory_read_enable : boolean;
  signal sums_turn_read_sums_3_memory_read_address, sums_turn_read_sums_3_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_3_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address, sums_turn_read_sums_2_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address, sums_turn_read_sums_1_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address, sums_turn_read_sums_0_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_costs_15_memory_read_enable : boolean;
  signal sums_turn_read_costs_15_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_15_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_15_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_14_memory_read_enable : boolean;
  signal sums_turn_read_costs_14_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_14_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_14_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_13_memory_read_enable : boolean;
  signal sums_turn_read_costs_13_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_13_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_13_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_12_memory_read_enable : boolean;
  signal sums_turn_read_costs_12_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_12_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_12_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_11_memory_read_enable : boolean;
  signal sums_turn_read_costs_11_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_11_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_11_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_10_memory_read_enable : boolean;
  signal sums_turn_read_costs_10_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_10_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_10_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_9_memory_read_enable : boolean;
  signal sums_turn_read_costs_9_memory_read_address, sums_turn_read_costs_9_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_9_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_8_memory_read_enable : boolean;
  signal sums_turn_read_costs_8_memory_read_address, sums_turn_read_costs_8_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_8_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_7_memory_read_enable : boolean;
  signal sums_turn_read_costs_7_memory_read_address, sums_turn_read_costs_7_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_7_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_6_memory_read_enable : boolean;
  signal sums_turn_read_costs_6_memory_read_address, sums_turn_read_costs_6_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_6_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_5_memory_read_enable : boolean;
  signal sums_turn_read_costs_5_memory_read_address, sums_turn_read_costs_5_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_5_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_4_memory_read_enable : boolean;
  signal sums_turn_read_costs_4_memory_read_address, sums_turn_read_costs_4_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_4_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_3_memory_read_enable : boolean;
  signal sums_turn_read_costs_3_memory_read_address, sums_turn_read_costs_3_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_3_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_2_memory_read_enable : boolean;
  signal sums_turn_read_costs_2_memory_read_address, sums_turn_read_costs_2_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_2_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address, sums_turn_read_costs_1_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address, sums_turn_read_costs_0_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(31 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(9 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(9 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(3 downto 0);
  signal forward_above_read_words_21_memory_read_enable : boolean;
  signal forward_above_read_words_21_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_21_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_21_memory_write_data : unsigned(11 downto 0);
  signal forward_above_read_words_20_memory_read_enable : boolean;
  signal forward_above_read_words_20_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_20_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_20_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_19_memory_read_enable : boolean;
  signal forward_above_read_words_19_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_19_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_19_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_18_memory_read_enable : boolean;
  signal forward_above_read_words_18_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_18_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_18_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_17_memory_read_enable : boolean;
  signal forward_above_read_words_17_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_17_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_17_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_16_memory_read_enable : boolean;
  signal forward_above_read_words_16_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_16_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_16_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_15_memory_read_enable : boolean;
  signal forward_above_read_words_15_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_15_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_15_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_14_memory_read_enable : boolean;
  signal forward_above_read_words_14_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_14_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_14_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_13_memory_read_enable : boolean;
  signal forward_above_read_words_13_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_13_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_13_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_12_memory_read_enable : boolean;
  signal forward_above_read_words_12_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_12_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_12_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_11_memory_read_enable : boolean;
  signal forward_above_read_words_11_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_11_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_11_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_10_memory_read_enable : boolean;
  signal forward_above_read_words_10_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_10_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_10_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_9_memory_read_enable : boolean;
  signal forward_above_read_words_9_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_9_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_9_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_8_memory_read_enable : boolean;
  signal forward_above_read_words_8_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_8_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_8_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_7_memory_read_enable : boolean;
  signal forward_above_read_words_7_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_7_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_7_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_6_memory_read_enable : boolean;
  signal forward_above_read_words_6_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_6_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_6_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_5_memory_read_enable : boolean;
  signal forward_above_read_words_5_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_5_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_5_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_4_memory_read_enable : boolean;
  signal forward_above_read_words_4_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_4_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_4_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_3_memory_read_enable : boolean;
  signal forward_above_read_words_3_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_3_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_3_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_2_memory_read_enable : boolean;
  signal forward_above_read_words_2_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_2_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_2_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_1_memory_read_enable : boolean;
  signal forward_above_read_words_1_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_1_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_1_memory_write_data : unsigned(31 downto 0);
  signal forward_above_read_words_0_memory_read_enable : boolean;
  signal forward_above_read_words_0_memory_read_address : unsigned(9 downto 0);
  signal forward_above_read_words_0_memory_write_address : unsigned(9 downto 0);
  signal forward_above_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal forward_above_delay_held_25_memory_read_enable : boolean;
  signal forward_above_delay_held_25_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_25_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_25_memory_write_data : unsigned(17 downto 0);
  signal forward_above_delay_held_24_memory_read_enable : boolean;
  signal forward_above_delay_held_24_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_24_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_24_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_23_memory_read_enable : boolean;
  signal forward_above_delay_held_23_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_23_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_23_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_22_memory_read_enable : boolean;
  signal forward_above_delay_held_22_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_22_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_22_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_21_memory_read_enable : boolean;
  signal forward_above_delay_held_21_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_21_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_21_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_20_memory_read_enable : boolean;
  signal forward_above_delay_held_20_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_20_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_20_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_19_memory_read_enable : boolean;
  signal forward_above_delay_held_19_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_19_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_19_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_18_memory_read_enable : boolean;
  signal forward_above_delay_held_18_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_18_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_18_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_17_memory_read_enable : boolean;
  signal forward_above_delay_held_17_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_17_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_17_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_16_memory_read_enable : boolean;
  signal forward_above_delay_held_16_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_16_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_16_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_15_memory_read_enable : boolean;
  signal forward_above_delay_held_15_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_15_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_15_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_14_memory_read_enable : boolean;
  signal forward_above_delay_held_14_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_14_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_14_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_13_memory_read_enable : boolean;
  signal forward_above_delay_held_13_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_13_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_13_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_12_memory_read_enable : boolean;
  signal forward_above_delay_held_12_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_12_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_12_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_11_memory_read_enable : boolean;
  signal forward_above_delay_held_11_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_11_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_11_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_10_memory_read_enable : boolean;
  signal forward_above_delay_held_10_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_9_memory_read_enable : boolean;
  signal forward_above_delay_held_9_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_8_memory_read_enable : boolean;
  signal forward_above_delay_held_8_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_7_memory_read_enable : boolean;
  signal forward_above_delay_held_7_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_6_memory_read_enable : boolean;
  signal forward_above_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_5_memory_read_enable : boolean;
  signal forward_above_delay_held_5_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_4_memory_read_enable : boolean;
  signal forward_above_delay_held_4_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_3_memory_read_enable : boolean;
  signal forward_above_delay_held_3_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_2_memory_read_enable : boolean;
  signal forward_above_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_1_memory_read_enable : boolean;
  signal forward_above_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_data : unsigned(29 downto 0);
  signal forward_above_delay_held_0_memory_read_enable : boolean;
  signal forward_above_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_data : unsigned(29 downto 0);
  signal forward_cost_delay_held_15_memory_read_enable : boolean;
  signal forward_cost_delay_held_15_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_15_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_15_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_14_memory_read_enable : boolean;
  signal forward_cost_delay_held_14_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_14_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_14_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_13_memory_read_enable : boolean;
  signal forward_cost_delay_held_13_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_13_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_13_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_12_memory_read_enable : boolean;
  signal forward_cost_delay_held_12_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_12_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_12_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_11_memory_read_enable : boolean;
  signal forward_cost_delay_held_11_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_11_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_11_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_10_memory_read_enable : boolean;
  signal forward_cost_delay_held_10_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_10_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_10_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_9_memory_read_enable : boolean;
  signal forward_cost_delay_held_9_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_9_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_9_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_8_memory_read_enable : boolean;
  signal forward_cost_delay_held_8_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_8_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_8_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_7_memory_read_enable : boolean;
  signal forward_cost_delay_held_7_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_7_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_7_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_6_memory_read_enable : boolean;
  signal forward_cost_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_5_memory_read_enable : boolean;
  signal forward_cost_delay_held_5_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_5_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_5_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_4_memory_read_enable : boolean;
  signal forward_cost_delay_held_4_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_4_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_4_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_3_memory_read_enable : boolean;
  signal forward_cost_delay_held_3_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_3_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_3_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_2_memory_read_enable : boolean;
  signal forward_cost_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_2_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_1_memory_read_enable : boolean;
  signal forward_cost_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_1_memory_write_data : unsigned(31 downto 0);
  signal forward_cost_delay_held_0_memory_read_enable : boolean;
  signal forward_cost_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_0_memory_write_data : unsigned(31 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_out_disparity_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(map_out_passed_0), 1));
  disparity_valid <= as_bit(map_out_valid);
  disparity_start_of_frame <= as_bit(map_out_start_of_frame);
  disparity_end_of_line <= as_bit(map_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 10);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 10);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 640, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  map_rows_read_words_0_memory_read_enable <= true;
  map_rows_read_words_0_memory_read_address <= to_unsigned(map_counter_column, 10);
  map_rows_read_words_0_memory_write_address <= to_unsigned(map_at_column, 10);
  map_rows_read_words_0_memory_write_data <= to_unsigned(map_rows_write_words_0, 17);
  map_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 513, width => 17, address_bits => 10)
    port map (
      clock => clock, read_enable => map_rows_read_words_0_memory_read_enable,
      read_address => map_rows_read_words_0_memory_read_address, read_data => map_rows_read_words_0,
      write_address => map_rows_read_words_0_memory_write_address, write_data => map_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 10);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 10);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 9);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 513, width => 9, address_bits => 10)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  sums_sum_delay_held_31_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_31_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_31_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_31_memory_write_data <= to_unsigned(sums_turn_ready_sums(31), 28);
  sums_sum_delay_held_31_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_31_memory_read_enable,
      read_address => sums_sum_delay_held_31_memory_read_address, read_data => sums_sum_delay_held(31),
      write_address => sums_sum_delay_held_31_memory_write_address, write_data => sums_sum_delay_held_31_memory_write_data);

  sums_sum_delay_held_30_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_30_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_30_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_30_memory_write_data <= to_unsigned(sums_turn_ready_sums(30), 28);
  sums_sum_delay_held_30_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_30_memory_read_enable,
      read_address => sums_sum_delay_held_30_memory_read_address, read_data => sums_sum_delay_held(30),
      write_address => sums_sum_delay_held_30_memory_write_address, write_data => sums_sum_delay_held_30_memory_write_data);

  sums_sum_delay_held_29_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_29_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_29_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_29_memory_write_data <= to_unsigned(sums_turn_ready_sums(29), 28);
  sums_sum_delay_held_29_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_29_memory_read_enable,
      read_address => sums_sum_delay_held_29_memory_read_address, read_data => sums_sum_delay_held(29),
      write_address => sums_sum_delay_held_29_memory_write_address, write_data => sums_sum_delay_held_29_memory_write_data);

  sums_sum_delay_held_28_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_28_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_28_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_28_memory_write_data <= to_unsigned(sums_turn_ready_sums(28), 28);
  sums_sum_delay_held_28_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_28_memory_read_enable,
      read_address => sums_sum_delay_held_28_memory_read_address, read_data => sums_sum_delay_held(28),
      write_address => sums_sum_delay_held_28_memory_write_address, write_data => sums_sum_delay_held_28_memory_write_data);

  sums_sum_delay_held_27_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_27_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_27_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_27_memory_write_data <= to_unsigned(sums_turn_ready_sums(27), 28);
  sums_sum_delay_held_27_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_27_memory_read_enable,
      read_address => sums_sum_delay_held_27_memory_read_address, read_data => sums_sum_delay_held(27),
      write_address => sums_sum_delay_held_27_memory_write_address, write_data => sums_sum_delay_held_27_memory_write_data);

  sums_sum_delay_held_26_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_26_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_26_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_26_memory_write_data <= to_unsigned(sums_turn_ready_sums(26), 28);
  sums_sum_delay_held_26_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_26_memory_read_enable,
      read_address => sums_sum_delay_held_26_memory_read_address, read_data => sums_sum_delay_held(26),
      write_address => sums_sum_delay_held_26_memory_write_address, write_data => sums_sum_delay_held_26_memory_write_data);

  sums_sum_delay_held_25_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_25_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_25_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_25_memory_write_data <= to_unsigned(sums_turn_ready_sums(25), 28);
  sums_sum_delay_held_25_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_25_memory_read_enable,
      read_address => sums_sum_delay_held_25_memory_read_address, read_data => sums_sum_delay_held(25),
      write_address => sums_sum_delay_held_25_memory_write_address, write_data => sums_sum_delay_held_25_memory_write_data);

  sums_sum_delay_held_24_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_24_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_24_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_24_memory_write_data <= to_unsigned(sums_turn_ready_sums(24), 28);
  sums_sum_delay_held_24_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_24_memory_read_enable,
      read_address => sums_sum_delay_held_24_memory_read_address, read_data => sums_sum_delay_held(24),
      write_address => sums_sum_delay_held_24_memory_write_address, write_data => sums_sum_delay_held_24_memory_write_data);

  sums_sum_delay_held_23_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_23_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_23_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_23_memory_write_data <= to_unsigned(sums_turn_ready_sums(23), 28);
  sums_sum_delay_held_23_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_23_memory_read_enable,
      read_address => sums_sum_delay_held_23_memory_read_address, read_data => sums_sum_delay_held(23),
      write_address => sums_sum_delay_held_23_memory_write_address, write_data => sums_sum_delay_held_23_memory_write_data);

  sums_sum_delay_held_22_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_22_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_22_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_22_memory_write_data <= to_unsigned(sums_turn_ready_sums(22), 28);
  sums_sum_delay_held_22_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_22_memory_read_enable,
      read_address => sums_sum_delay_held_22_memory_read_address, read_data => sums_sum_delay_held(22),
      write_address => sums_sum_delay_held_22_memory_write_address, write_data => sums_sum_delay_held_22_memory_write_data);

  sums_sum_delay_held_21_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_21_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_21_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_21_memory_write_data <= to_unsigned(sums_turn_ready_sums(21), 28);
  sums_sum_delay_held_21_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_21_memory_read_enable,
      read_address => sums_sum_delay_held_21_memory_read_address, read_data => sums_sum_delay_held(21),
      write_address => sums_sum_delay_held_21_memory_write_address, write_data => sums_sum_delay_held_21_memory_write_data);

  sums_sum_delay_held_20_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_20_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_20_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_20_memory_write_data <= to_unsigned(sums_turn_ready_sums(20), 28);
  sums_sum_delay_held_20_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_20_memory_read_enable,
      read_address => sums_sum_delay_held_20_memory_read_address, read_data => sums_sum_delay_held(20),
      write_address => sums_sum_delay_held_20_memory_write_address, write_data => sums_sum_delay_held_20_memory_write_data);

  sums_sum_delay_held_19_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_19_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_19_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_19_memory_write_data <= to_unsigned(sums_turn_ready_sums(19), 28);
  sums_sum_delay_held_19_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_19_memory_read_enable,
      read_address => sums_sum_delay_held_19_memory_read_address, read_data => sums_sum_delay_held(19),
      write_address => sums_sum_delay_held_19_memory_write_address, write_data => sums_sum_delay_held_19_memory_write_data);

  sums_sum_delay_held_18_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_18_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_18_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_18_memory_write_data <= to_unsigned(sums_turn_ready_sums(18), 28);
  sums_sum_delay_held_18_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_18_memory_read_enable,
      read_address => sums_sum_delay_held_18_memory_read_address, read_data => sums_sum_delay_held(18),
      write_address => sums_sum_delay_held_18_memory_write_address, write_data => sums_sum_delay_held_18_memory_write_data);

  sums_sum_delay_held_17_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_17_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_17_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_17_memory_write_data <= to_unsigned(sums_turn_ready_sums(17), 28);
  sums_sum_delay_held_17_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_17_memory_read_enable,
      read_address => sums_sum_delay_held_17_memory_read_address, read_data => sums_sum_delay_held(17),
      write_address => sums_sum_delay_held_17_memory_write_address, write_data => sums_sum_delay_held_17_memory_write_data);

  sums_sum_delay_held_16_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_16_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_16_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_16_memory_write_data <= to_unsigned(sums_turn_ready_sums(16), 28);
  sums_sum_delay_held_16_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_16_memory_read_enable,
      read_address => sums_sum_delay_held_16_memory_read_address, read_data => sums_sum_delay_held(16),
      write_address => sums_sum_delay_held_16_memory_write_address, write_data => sums_sum_delay_held_16_memory_write_data);

  sums_sum_delay_held_15_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_15_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_15_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_15_memory_write_data <= to_unsigned(sums_turn_ready_sums(15), 28);
  sums_sum_delay_held_15_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_15_memory_read_enable,
      read_address => sums_sum_delay_held_15_memory_read_address, read_data => sums_sum_delay_held(15),
      write_address => sums_sum_delay_held_15_memory_write_address, write_data => sums_sum_delay_held_15_memory_write_data);

  sums_sum_delay_held_14_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_14_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_14_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_14_memory_write_data <= to_unsigned(sums_turn_ready_sums(14), 28);
  sums_sum_delay_held_14_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_14_memory_read_enable,
      read_address => sums_sum_delay_held_14_memory_read_address, read_data => sums_sum_delay_held(14),
      write_address => sums_sum_delay_held_14_memory_write_address, write_data => sums_sum_delay_held_14_memory_write_data);

  sums_sum_delay_held_13_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_13_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_13_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_13_memory_write_data <= to_unsigned(sums_turn_ready_sums(13), 28);
  sums_sum_delay_held_13_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_13_memory_read_enable,
      read_address => sums_sum_delay_held_13_memory_read_address, read_data => sums_sum_delay_held(13),
      write_address => sums_sum_delay_held_13_memory_write_address, write_data => sums_sum_delay_held_13_memory_write_data);

  sums_sum_delay_held_12_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_12_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_12_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_12_memory_write_data <= to_unsigned(sums_turn_ready_sums(12), 28);
  sums_sum_delay_held_12_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_12_memory_read_enable,
      read_address => sums_sum_delay_held_12_memory_read_address, read_data => sums_sum_delay_held(12),
      write_address => sums_sum_delay_held_12_memory_write_address, write_data => sums_sum_delay_held_12_memory_write_data);

  sums_sum_delay_held_11_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_11_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_11_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_11_memory_write_data <= to_unsigned(sums_turn_ready_sums(11), 28);
  sums_sum_delay_held_11_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_11_memory_read_enable,
      read_address => sums_sum_delay_held_11_memory_read_address, read_data => sums_sum_delay_held(11),
      write_address => sums_sum_delay_held_11_memory_write_address, write_data => sums_sum_delay_held_11_memory_write_data);

  sums_sum_delay_held_10_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_10_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_10_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_10_memory_write_data <= to_unsigned(sums_turn_ready_sums(10), 28);
  sums_sum_delay_held_10_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_10_memory_read_enable,
      read_address => sums_sum_delay_held_10_memory_read_address, read_data => sums_sum_delay_held(10),
      write_address => sums_sum_delay_held_10_memory_write_address, write_data => sums_sum_delay_held_10_memory_write_data);

  sums_sum_delay_held_9_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_9_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_9_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_9_memory_write_data <= to_unsigned(sums_turn_ready_sums(9), 28);
  sums_sum_delay_held_9_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_9_memory_read_enable,
      read_address => sums_sum_delay_held_9_memory_read_address, read_data => sums_sum_delay_held(9),
      write_address => sums_sum_delay_held_9_memory_write_address, write_data => sums_sum_delay_held_9_memory_write_data);

  sums_sum_delay_held_8_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_8_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_8_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_8_memory_write_data <= to_unsigned(sums_turn_ready_sums(8), 28);
  sums_sum_delay_held_8_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_8_memory_read_enable,
      read_address => sums_sum_delay_held_8_memory_read_address, read_data => sums_sum_delay_held(8),
      write_address => sums_sum_delay_held_8_memory_write_address, write_data => sums_sum_delay_held_8_memory_write_data);

  sums_sum_delay_held_7_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_7_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_7_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_7_memory_write_data <= to_unsigned(sums_turn_ready_sums(7), 28);
  sums_sum_delay_held_7_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_7_memory_read_enable,
      read_address => sums_sum_delay_held_7_memory_read_address, read_data => sums_sum_delay_held(7),
      write_address => sums_sum_delay_held_7_memory_write_address, write_data => sums_sum_delay_held_7_memory_write_data);

  sums_sum_delay_held_6_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_6_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_6_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_6_memory_write_data <= to_unsigned(sums_turn_ready_sums(6), 28);
  sums_sum_delay_held_6_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_6_memory_read_enable,
      read_address => sums_sum_delay_held_6_memory_read_address, read_data => sums_sum_delay_held(6),
      write_address => sums_sum_delay_held_6_memory_write_address, write_data => sums_sum_delay_held_6_memory_write_data);

  sums_sum_delay_held_5_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_5_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_5_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_5_memory_write_data <= to_unsigned(sums_turn_ready_sums(5), 28);
  sums_sum_delay_held_5_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_5_memory_read_enable,
      read_address => sums_sum_delay_held_5_memory_read_address, read_data => sums_sum_delay_held(5),
      write_address => sums_sum_delay_held_5_memory_write_address, write_data => sums_sum_delay_held_5_memory_write_data);

  sums_sum_delay_held_4_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_4_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_4_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_4_memory_write_data <= to_unsigned(sums_turn_ready_sums(4), 28);
  sums_sum_delay_held_4_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_4_memory_read_enable,
      read_address => sums_sum_delay_held_4_memory_read_address, read_data => sums_sum_delay_held(4),
      write_address => sums_sum_delay_held_4_memory_write_address, write_data => sums_sum_delay_held_4_memory_write_data);

  sums_sum_delay_held_3_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_3_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_3_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_3_memory_write_data <= to_unsigned(sums_turn_ready_sums(3), 28);
  sums_sum_delay_held_3_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_3_memory_read_enable,
      read_address => sums_sum_delay_held_3_memory_read_address, read_data => sums_sum_delay_held(3),
      write_address => sums_sum_delay_held_3_memory_write_address, write_data => sums_sum_delay_held_3_memory_write_data);

  sums_sum_delay_held_2_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_2_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_2_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_2_memory_write_data <= to_unsigned(sums_turn_ready_sums(2), 28);
  sums_sum_delay_held_2_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_2_memory_read_enable,
      read_address => sums_sum_delay_held_2_memory_read_address, read_data => sums_sum_delay_held(2),
      write_address => sums_sum_delay_held_2_memory_write_address, write_data => sums_sum_delay_held_2_memory_write_data);

  sums_sum_delay_held_1_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_1_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_1_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_1_memory_write_data <= to_unsigned(sums_turn_ready_sums(1), 28);
  sums_sum_delay_held_1_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_1_memory_read_enable,
      read_address => sums_sum_delay_held_1_memory_read_address, read_data => sums_sum_delay_held(1),
      write_address => sums_sum_delay_held_1_memory_write_address, write_data => sums_sum_delay_held_1_memory_write_data);

  sums_sum_delay_held_0_memory_read_enable <= entry_tag_valid;
  sums_sum_delay_held_0_memory_read_address <= to_unsigned(sums_sum_delay_ring_read_address, 2);
  sums_sum_delay_held_0_memory_write_address <= to_unsigned(sums_sum_delay_ring_write_address, 2);
  sums_sum_delay_held_0_memory_write_data <= to_unsigned(sums_turn_ready_sums(0), 28);
  sums_sum_delay_held_0_memory : entity work.line_memory
    generic map (depth => 4, width => 28, address_bits => 2)
    port map (
      clock => clock, read_enable => sums_sum_delay_held_0_memory_read_enable,
      read_address => sums_sum_delay_held_0_memory_read_address, read_data => sums_sum_delay_held(0),
      write_address => sums_sum_delay_held_0_memory_write_address, write_data => sums_sum_delay_held_0_memory_write_data);

  sums_turn_read_sums_31_memory_read_enable <= true;
  sums_turn_read_sums_31_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_31_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_31_memory_write_data <= to_unsigned(sums_turn_write_sums(31), 28);
  sums_turn_read_sums_31_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_31_memory_read_enable,
      read_address => sums_turn_read_sums_31_memory_read_address, read_data => sums_turn_read_sums(31),
      write_address => sums_turn_read_sums_31_memory_write_address, write_data => sums_turn_read_sums_31_memory_write_data);

  sums_turn_read_sums_30_memory_read_enable <= true;
  sums_turn_read_sums_30_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_30_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_30_memory_write_data <= to_unsigned(sums_turn_write_sums(30), 28);
  sums_turn_read_sums_30_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_30_memory_read_enable,
      read_address => sums_turn_read_sums_30_memory_read_address, read_data => sums_turn_read_sums(30),
      write_address => sums_turn_read_sums_30_memory_write_address, write_data => sums_turn_read_sums_30_memory_write_data);

  sums_turn_read_sums_29_memory_read_enable <= true;
  sums_turn_read_sums_29_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_29_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_29_memory_write_data <= to_unsigned(sums_turn_write_sums(29), 28);
  sums_turn_read_sums_29_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_29_memory_read_enable,
      read_address => sums_turn_read_sums_29_memory_read_address, read_data => sums_turn_read_sums(29),
      write_address => sums_turn_read_sums_29_memory_write_address, write_data => sums_turn_read_sums_29_memory_write_data);

  sums_turn_read_sums_28_memory_read_enable <= true;
  sums_turn_read_sums_28_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_28_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_28_memory_write_data <= to_unsigned(sums_turn_write_sums(28), 28);
  sums_turn_read_sums_28_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_28_memory_read_enable,
      read_address => sums_turn_read_sums_28_memory_read_address, read_data => sums_turn_read_sums(28),
      write_address => sums_turn_read_sums_28_memory_write_address, write_data => sums_turn_read_sums_28_memory_write_data);

  sums_turn_read_sums_27_memory_read_enable <= true;
  sums_turn_read_sums_27_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_27_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_27_memory_write_data <= to_unsigned(sums_turn_write_sums(27), 28);
  sums_turn_read_sums_27_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_27_memory_read_enable,
      read_address => sums_turn_read_sums_27_memory_read_address, read_data => sums_turn_read_sums(27),
      write_address => sums_turn_read_sums_27_memory_write_address, write_data => sums_turn_read_sums_27_memory_write_data);

  sums_turn_read_sums_26_memory_read_enable <= true;
  sums_turn_read_sums_26_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_26_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_26_memory_write_data <= to_unsigned(sums_turn_write_sums(26), 28);
  sums_turn_read_sums_26_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_26_memory_read_enable,
      read_address => sums_turn_read_sums_26_memory_read_address, read_data => sums_turn_read_sums(26),
      write_address => sums_turn_read_sums_26_memory_write_address, write_data => sums_turn_read_sums_26_memory_write_data);

  sums_turn_read_sums_25_memory_read_enable <= true;
  sums_turn_read_sums_25_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_25_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_25_memory_write_data <= to_unsigned(sums_turn_write_sums(25), 28);
  sums_turn_read_sums_25_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_25_memory_read_enable,
      read_address => sums_turn_read_sums_25_memory_read_address, read_data => sums_turn_read_sums(25),
      write_address => sums_turn_read_sums_25_memory_write_address, write_data => sums_turn_read_sums_25_memory_write_data);

  sums_turn_read_sums_24_memory_read_enable <= true;
  sums_turn_read_sums_24_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_24_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_24_memory_write_data <= to_unsigned(sums_turn_write_sums(24), 28);
  sums_turn_read_sums_24_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_24_memory_read_enable,
      read_address => sums_turn_read_sums_24_memory_read_address, read_data => sums_turn_read_sums(24),
      write_address => sums_turn_read_sums_24_memory_write_address, write_data => sums_turn_read_sums_24_memory_write_data);

  sums_turn_read_sums_23_memory_read_enable <= true;
  sums_turn_read_sums_23_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_23_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_23_memory_write_data <= to_unsigned(sums_turn_write_sums(23), 28);
  sums_turn_read_sums_23_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_23_memory_read_enable,
      read_address => sums_turn_read_sums_23_memory_read_address, read_data => sums_turn_read_sums(23),
      write_address => sums_turn_read_sums_23_memory_write_address, write_data => sums_turn_read_sums_23_memory_write_data);

  sums_turn_read_sums_22_memory_read_enable <= true;
  sums_turn_read_sums_22_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_22_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_22_memory_write_data <= to_unsigned(sums_turn_write_sums(22), 28);
  sums_turn_read_sums_22_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_22_memory_read_enable,
      read_address => sums_turn_read_sums_22_memory_read_address, read_data => sums_turn_read_sums(22),
      write_address => sums_turn_read_sums_22_memory_write_address, write_data => sums_turn_read_sums_22_memory_write_data);

  sums_turn_read_sums_21_memory_read_enable <= true;
  sums_turn_read_sums_21_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_21_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_21_memory_write_data <= to_unsigned(sums_turn_write_sums(21), 28);
  sums_turn_read_sums_21_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_21_memory_read_enable,
      read_address => sums_turn_read_sums_21_memory_read_address, read_data => sums_turn_read_sums(21),
      write_address => sums_turn_read_sums_21_memory_write_address, write_data => sums_turn_read_sums_21_memory_write_data);

  sums_turn_read_sums_20_memory_read_enable <= true;
  sums_turn_read_sums_20_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_20_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_20_memory_write_data <= to_unsigned(sums_turn_write_sums(20), 28);
  sums_turn_read_sums_20_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_20_memory_read_enable,
      read_address => sums_turn_read_sums_20_memory_read_address, read_data => sums_turn_read_sums(20),
      write_address => sums_turn_read_sums_20_memory_write_address, write_data => sums_turn_read_sums_20_memory_write_data);

  sums_turn_read_sums_19_memory_read_enable <= true;
  sums_turn_read_sums_19_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_19_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_19_memory_write_data <= to_unsigned(sums_turn_write_sums(19), 28);
  sums_turn_read_sums_19_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_19_memory_read_enable,
      read_address => sums_turn_read_sums_19_memory_read_address, read_data => sums_turn_read_sums(19),
      write_address => sums_turn_read_sums_19_memory_write_address, write_data => sums_turn_read_sums_19_memory_write_data);

  sums_turn_read_sums_18_memory_read_enable <= true;
  sums_turn_read_sums_18_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_18_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_18_memory_write_data <= to_unsigned(sums_turn_write_sums(18), 28);
  sums_turn_read_sums_18_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_18_memory_read_enable,
      read_address => sums_turn_read_sums_18_memory_read_address, read_data => sums_turn_read_sums(18),
      write_address => sums_turn_read_sums_18_memory_write_address, write_data => sums_turn_read_sums_18_memory_write_data);

  sums_turn_read_sums_17_memory_read_enable <= true;
  sums_turn_read_sums_17_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_17_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_17_memory_write_data <= to_unsigned(sums_turn_write_sums(17), 28);
  sums_turn_read_sums_17_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_17_memory_read_enable,
      read_address => sums_turn_read_sums_17_memory_read_address, read_data => sums_turn_read_sums(17),
      write_address => sums_turn_read_sums_17_memory_write_address, write_data => sums_turn_read_sums_17_memory_write_data);

  sums_turn_read_sums_16_memory_read_enable <= true;
  sums_turn_read_sums_16_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_16_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_16_memory_write_data <= to_unsigned(sums_turn_write_sums(16), 28);
  sums_turn_read_sums_16_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_16_memory_read_enable,
      read_address => sums_turn_read_sums_16_memory_read_address, read_data => sums_turn_read_sums(16),
      write_address => sums_turn_read_sums_16_memory_write_address, write_data => sums_turn_read_sums_16_memory_write_data);

  sums_turn_read_sums_15_memory_read_enable <= true;
  sums_turn_read_sums_15_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_15_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_15_memory_write_data <= to_unsigned(sums_turn_write_sums(15), 28);
  sums_turn_read_sums_15_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_15_memory_read_enable,
      read_address => sums_turn_read_sums_15_memory_read_address, read_data => sums_turn_read_sums(15),
      write_address => sums_turn_read_sums_15_memory_write_address, write_data => sums_turn_read_sums_15_memory_write_data);

  sums_turn_read_sums_14_memory_read_enable <= true;
  sums_turn_read_sums_14_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_14_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_14_memory_write_data <= to_unsigned(sums_turn_write_sums(14), 28);
  sums_turn_read_sums_14_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_14_memory_read_enable,
      read_address => sums_turn_read_sums_14_memory_read_address, read_data => sums_turn_read_sums(14),
      write_address => sums_turn_read_sums_14_memory_write_address, write_data => sums_turn_read_sums_14_memory_write_data);

  sums_turn_read_sums_13_memory_read_enable <= true;
  sums_turn_read_sums_13_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_13_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_13_memory_write_data <= to_unsigned(sums_turn_write_sums(13), 28);
  sums_turn_read_sums_13_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_13_memory_read_enable,
      read_address => sums_turn_read_sums_13_memory_read_address, read_data => sums_turn_read_sums(13),
      write_address => sums_turn_read_sums_13_memory_write_address, write_data => sums_turn_read_sums_13_memory_write_data);

  sums_turn_read_sums_12_memory_read_enable <= true;
  sums_turn_read_sums_12_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_12_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_12_memory_write_data <= to_unsigned(sums_turn_write_sums(12), 28);
  sums_turn_read_sums_12_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_12_memory_read_enable,
      read_address => sums_turn_read_sums_12_memory_read_address, read_data => sums_turn_read_sums(12),
      write_address => sums_turn_read_sums_12_memory_write_address, write_data => sums_turn_read_sums_12_memory_write_data);

  sums_turn_read_sums_11_memory_read_enable <= true;
  sums_turn_read_sums_11_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_11_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_11_memory_write_data <= to_unsigned(sums_turn_write_sums(11), 28);
  sums_turn_read_sums_11_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_11_memory_read_enable,
      read_address => sums_turn_read_sums_11_memory_read_address, read_data => sums_turn_read_sums(11),
      write_address => sums_turn_read_sums_11_memory_write_address, write_data => sums_turn_read_sums_11_memory_write_data);

  sums_turn_read_sums_10_memory_read_enable <= true;
  sums_turn_read_sums_10_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_10_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_10_memory_write_data <= to_unsigned(sums_turn_write_sums(10), 28);
  sums_turn_read_sums_10_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_10_memory_read_enable,
      read_address => sums_turn_read_sums_10_memory_read_address, read_data => sums_turn_read_sums(10),
      write_address => sums_turn_read_sums_10_memory_write_address, write_data => sums_turn_read_sums_10_memory_write_data);

  sums_turn_read_sums_9_memory_read_enable <= true;
  sums_turn_read_sums_9_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_9_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_9_memory_write_data <= to_unsigned(sums_turn_write_sums(9), 28);
  sums_turn_read_sums_9_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_9_memory_read_enable,
      read_address => sums_turn_read_sums_9_memory_read_address, read_data => sums_turn_read_sums(9),
      write_address => sums_turn_read_sums_9_memory_write_address, write_data => sums_turn_read_sums_9_memory_write_data);

  sums_turn_read_sums_8_memory_read_enable <= true;
  sums_turn_read_sums_8_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_8_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_8_memory_write_data <= to_unsigned(sums_turn_write_sums(8), 28);
  sums_turn_read_sums_8_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_8_memory_read_enable,
      read_address => sums_turn_read_sums_8_memory_read_address, read_data => sums_turn_read_sums(8),
      write_address => sums_turn_read_sums_8_memory_write_address, write_data => sums_turn_read_sums_8_memory_write_data);

  sums_turn_read_sums_7_memory_read_enable <= true;
  sums_turn_read_sums_7_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_7_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_7_memory_write_data <= to_unsigned(sums_turn_write_sums(7), 28);
  sums_turn_read_sums_7_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_7_memory_read_enable,
      read_address => sums_turn_read_sums_7_memory_read_address, read_data => sums_turn_read_sums(7),
      write_address => sums_turn_read_sums_7_memory_write_address, write_data => sums_turn_read_sums_7_memory_write_data);

  sums_turn_read_sums_6_memory_read_enable <= true;
  sums_turn_read_sums_6_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_6_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_6_memory_write_data <= to_unsigned(sums_turn_write_sums(6), 28);
  sums_turn_read_sums_6_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_6_memory_read_enable,
      read_address => sums_turn_read_sums_6_memory_read_address, read_data => sums_turn_read_sums(6),
      write_address => sums_turn_read_sums_6_memory_write_address, write_data => sums_turn_read_sums_6_memory_write_data);

  sums_turn_read_sums_5_memory_read_enable <= true;
  sums_turn_read_sums_5_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_5_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_5_memory_write_data <= to_unsigned(sums_turn_write_sums(5), 28);
  sums_turn_read_sums_5_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_5_memory_read_enable,
      read_address => sums_turn_read_sums_5_memory_read_address, read_data => sums_turn_read_sums(5),
      write_address => sums_turn_read_sums_5_memory_write_address, write_data => sums_turn_read_sums_5_memory_write_data);

  sums_turn_read_sums_4_memory_read_enable <= true;
  sums_turn_read_sums_4_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_4_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_4_memory_write_data <= to_unsigned(sums_turn_write_sums(4), 28);
  sums_turn_read_sums_4_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_4_memory_read_enable,
      read_address => sums_turn_read_sums_4_memory_read_address, read_data => sums_turn_read_sums(4),
      write_address => sums_turn_read_sums_4_memory_write_address, write_data => sums_turn_read_sums_4_memory_write_data);

  sums_turn_read_sums_3_memory_read_enable <= true;
  sums_turn_read_sums_3_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_3_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_3_memory_write_data <= to_unsigned(sums_turn_write_sums(3), 28);
  sums_turn_read_sums_3_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_3_memory_read_enable,
      read_address => sums_turn_read_sums_3_memory_read_address, read_data => sums_turn_read_sums(3),
      write_address => sums_turn_read_sums_3_memory_write_address, write_data => sums_turn_read_sums_3_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_2_memory_write_data <= to_unsigned(sums_turn_write_sums(2), 28);
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums(2),
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_1_memory_write_data <= to_unsigned(sums_turn_write_sums(1), 28);
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums(1),
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_sums_0_memory_write_data <= to_unsigned(sums_turn_write_sums(0), 28);
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 513, width => 28, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums(0),
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_15_memory_read_enable <= true;
  sums_turn_read_costs_15_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_15_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_15_memory_write_data <= sums_turn_write_costs(15);
  sums_turn_read_costs_15_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_15_memory_read_enable,
      read_address => sums_turn_read_costs_15_memory_read_address, read_data => sums_turn_read_costs(15),
      write_address => sums_turn_read_costs_15_memory_write_address, write_data => sums_turn_read_costs_15_memory_write_data);

  sums_turn_read_costs_14_memory_read_enable <= true;
  sums_turn_read_costs_14_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_14_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_14_memory_write_data <= sums_turn_write_costs(14);
  sums_turn_read_costs_14_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_14_memory_read_enable,
      read_address => sums_turn_read_costs_14_memory_read_address, read_data => sums_turn_read_costs(14),
      write_address => sums_turn_read_costs_14_memory_write_address, write_data => sums_turn_read_costs_14_memory_write_data);

  sums_turn_read_costs_13_memory_read_enable <= true;
  sums_turn_read_costs_13_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_13_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_13_memory_write_data <= sums_turn_write_costs(13);
  sums_turn_read_costs_13_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_13_memory_read_enable,
      read_address => sums_turn_read_costs_13_memory_read_address, read_data => sums_turn_read_costs(13),
      write_address => sums_turn_read_costs_13_memory_write_address, write_data => sums_turn_read_costs_13_memory_write_data);

  sums_turn_read_costs_12_memory_read_enable <= true;
  sums_turn_read_costs_12_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_12_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_12_memory_write_data <= sums_turn_write_costs(12);
  sums_turn_read_costs_12_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_12_memory_read_enable,
      read_address => sums_turn_read_costs_12_memory_read_address, read_data => sums_turn_read_costs(12),
      write_address => sums_turn_read_costs_12_memory_write_address, write_data => sums_turn_read_costs_12_memory_write_data);

  sums_turn_read_costs_11_memory_read_enable <= true;
  sums_turn_read_costs_11_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_11_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_11_memory_write_data <= sums_turn_write_costs(11);
  sums_turn_read_costs_11_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_11_memory_read_enable,
      read_address => sums_turn_read_costs_11_memory_read_address, read_data => sums_turn_read_costs(11),
      write_address => sums_turn_read_costs_11_memory_write_address, write_data => sums_turn_read_costs_11_memory_write_data);

  sums_turn_read_costs_10_memory_read_enable <= true;
  sums_turn_read_costs_10_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_10_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_10_memory_write_data <= sums_turn_write_costs(10);
  sums_turn_read_costs_10_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_10_memory_read_enable,
      read_address => sums_turn_read_costs_10_memory_read_address, read_data => sums_turn_read_costs(10),
      write_address => sums_turn_read_costs_10_memory_write_address, write_data => sums_turn_read_costs_10_memory_write_data);

  sums_turn_read_costs_9_memory_read_enable <= true;
  sums_turn_read_costs_9_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_9_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_9_memory_write_data <= sums_turn_write_costs(9);
  sums_turn_read_costs_9_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_9_memory_read_enable,
      read_address => sums_turn_read_costs_9_memory_read_address, read_data => sums_turn_read_costs(9),
      write_address => sums_turn_read_costs_9_memory_write_address, write_data => sums_turn_read_costs_9_memory_write_data);

  sums_turn_read_costs_8_memory_read_enable <= true;
  sums_turn_read_costs_8_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_8_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_8_memory_write_data <= sums_turn_write_costs(8);
  sums_turn_read_costs_8_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_8_memory_read_enable,
      read_address => sums_turn_read_costs_8_memory_read_address, read_data => sums_turn_read_costs(8),
      write_address => sums_turn_read_costs_8_memory_write_address, write_data => sums_turn_read_costs_8_memory_write_data);

  sums_turn_read_costs_7_memory_read_enable <= true;
  sums_turn_read_costs_7_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_7_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_7_memory_write_data <= sums_turn_write_costs(7);
  sums_turn_read_costs_7_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_7_memory_read_enable,
      read_address => sums_turn_read_costs_7_memory_read_address, read_data => sums_turn_read_costs(7),
      write_address => sums_turn_read_costs_7_memory_write_address, write_data => sums_turn_read_costs_7_memory_write_data);

  sums_turn_read_costs_6_memory_read_enable <= true;
  sums_turn_read_costs_6_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_6_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_6_memory_write_data <= sums_turn_write_costs(6);
  sums_turn_read_costs_6_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_6_memory_read_enable,
      read_address => sums_turn_read_costs_6_memory_read_address, read_data => sums_turn_read_costs(6),
      write_address => sums_turn_read_costs_6_memory_write_address, write_data => sums_turn_read_costs_6_memory_write_data);

  sums_turn_read_costs_5_memory_read_enable <= true;
  sums_turn_read_costs_5_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_5_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_5_memory_write_data <= sums_turn_write_costs(5);
  sums_turn_read_costs_5_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_5_memory_read_enable,
      read_address => sums_turn_read_costs_5_memory_read_address, read_data => sums_turn_read_costs(5),
      write_address => sums_turn_read_costs_5_memory_write_address, write_data => sums_turn_read_costs_5_memory_write_data);

  sums_turn_read_costs_4_memory_read_enable <= true;
  sums_turn_read_costs_4_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_4_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_4_memory_write_data <= sums_turn_write_costs(4);
  sums_turn_read_costs_4_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_4_memory_read_enable,
      read_address => sums_turn_read_costs_4_memory_read_address, read_data => sums_turn_read_costs(4),
      write_address => sums_turn_read_costs_4_memory_write_address, write_data => sums_turn_read_costs_4_memory_write_data);

  sums_turn_read_costs_3_memory_read_enable <= true;
  sums_turn_read_costs_3_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_3_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_3_memory_write_data <= sums_turn_write_costs(3);
  sums_turn_read_costs_3_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_3_memory_read_enable,
      read_address => sums_turn_read_costs_3_memory_read_address, read_data => sums_turn_read_costs(3),
      write_address => sums_turn_read_costs_3_memory_write_address, write_data => sums_turn_read_costs_3_memory_write_data);

  sums_turn_read_costs_2_memory_read_enable <= true;
  sums_turn_read_costs_2_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_2_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_2_memory_write_data <= sums_turn_write_costs(2);
  sums_turn_read_costs_2_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_2_memory_read_enable,
      read_address => sums_turn_read_costs_2_memory_read_address, read_data => sums_turn_read_costs(2),
      write_address => sums_turn_read_costs_2_memory_write_address, write_data => sums_turn_read_costs_2_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_1_memory_write_data <= sums_turn_write_costs(1);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs(1),
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_costs_0_memory_write_data <= sums_turn_write_costs(0);
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs(0),
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(entry_order_address, 10);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 10);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 4);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 513, width => 4, address_bits => 10)
    port map (
      clock => clock, read_enable => sums_turn_read_smallest_0_memory_read_enable,
      read_address => sums_turn_read_smallest_0_memory_read_address, read_data => sums_turn_read_smallest_0,
      write_address => sums_turn_read_smallest_0_memory_write_address, write_data => sums_turn_read_smallest_0_memory_write_data);

  forward_above_read_words_21_memory_read_enable <= true;
  forward_above_read_words_21_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_21_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_21_memory_write_data <= to_unsigned(forward_above_write_words_21, 12);
  forward_above_read_words_21_memory : entity work.line_memory
    generic map (depth => 513, width => 12, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_21_memory_read_enable,
      read_address => forward_above_read_words_21_memory_read_address, read_data => forward_above_read_words_21,
      write_address => forward_above_read_words_21_memory_write_address, write_data => forward_above_read_words_21_memory_write_data);

  forward_above_read_words_20_memory_read_enable <= true;
  forward_above_read_words_20_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_20_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_20_memory_write_data <= forward_above_write_words(20);
  forward_above_read_words_20_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_20_memory_read_enable,
      read_address => forward_above_read_words_20_memory_read_address, read_data => forward_above_read_words(20),
      write_address => forward_above_read_words_20_memory_write_address, write_data => forward_above_read_words_20_memory_write_data);

  forward_above_read_words_19_memory_read_enable <= true;
  forward_above_read_words_19_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_19_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_19_memory_write_data <= forward_above_write_words(19);
  forward_above_read_words_19_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_19_memory_read_enable,
      read_address => forward_above_read_words_19_memory_read_address, read_data => forward_above_read_words(19),
      write_address => forward_above_read_words_19_memory_write_address, write_data => forward_above_read_words_19_memory_write_data);

  forward_above_read_words_18_memory_read_enable <= true;
  forward_above_read_words_18_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_18_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_18_memory_write_data <= forward_above_write_words(18);
  forward_above_read_words_18_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_18_memory_read_enable,
      read_address => forward_above_read_words_18_memory_read_address, read_data => forward_above_read_words(18),
      write_address => forward_above_read_words_18_memory_write_address, write_data => forward_above_read_words_18_memory_write_data);

  forward_above_read_words_17_memory_read_enable <= true;
  forward_above_read_words_17_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_17_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_17_memory_write_data <= forward_above_write_words(17);
  forward_above_read_words_17_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_17_memory_read_enable,
      read_address => forward_above_read_words_17_memory_read_address, read_data => forward_above_read_words(17),
      write_address => forward_above_read_words_17_memory_write_address, write_data => forward_above_read_words_17_memory_write_data);

  forward_above_read_words_16_memory_read_enable <= true;
  forward_above_read_words_16_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_16_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_16_memory_write_data <= forward_above_write_words(16);
  forward_above_read_words_16_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_16_memory_read_enable,
      read_address => forward_above_read_words_16_memory_read_address, read_data => forward_above_read_words(16),
      write_address => forward_above_read_words_16_memory_write_address, write_data => forward_above_read_words_16_memory_write_data);

  forward_above_read_words_15_memory_read_enable <= true;
  forward_above_read_words_15_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_15_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_15_memory_write_data <= forward_above_write_words(15);
  forward_above_read_words_15_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_15_memory_read_enable,
      read_address => forward_above_read_words_15_memory_read_address, read_data => forward_above_read_words(15),
      write_address => forward_above_read_words_15_memory_write_address, write_data => forward_above_read_words_15_memory_write_data);

  forward_above_read_words_14_memory_read_enable <= true;
  forward_above_read_words_14_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_14_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_14_memory_write_data <= forward_above_write_words(14);
  forward_above_read_words_14_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_14_memory_read_enable,
      read_address => forward_above_read_words_14_memory_read_address, read_data => forward_above_read_words(14),
      write_address => forward_above_read_words_14_memory_write_address, write_data => forward_above_read_words_14_memory_write_data);

  forward_above_read_words_13_memory_read_enable <= true;
  forward_above_read_words_13_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_13_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_13_memory_write_data <= forward_above_write_words(13);
  forward_above_read_words_13_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_13_memory_read_enable,
      read_address => forward_above_read_words_13_memory_read_address, read_data => forward_above_read_words(13),
      write_address => forward_above_read_words_13_memory_write_address, write_data => forward_above_read_words_13_memory_write_data);

  forward_above_read_words_12_memory_read_enable <= true;
  forward_above_read_words_12_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_12_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_12_memory_write_data <= forward_above_write_words(12);
  forward_above_read_words_12_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_12_memory_read_enable,
      read_address => forward_above_read_words_12_memory_read_address, read_data => forward_above_read_words(12),
      write_address => forward_above_read_words_12_memory_write_address, write_data => forward_above_read_words_12_memory_write_data);

  forward_above_read_words_11_memory_read_enable <= true;
  forward_above_read_words_11_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_11_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_11_memory_write_data <= forward_above_write_words(11);
  forward_above_read_words_11_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_11_memory_read_enable,
      read_address => forward_above_read_words_11_memory_read_address, read_data => forward_above_read_words(11),
      write_address => forward_above_read_words_11_memory_write_address, write_data => forward_above_read_words_11_memory_write_data);

  forward_above_read_words_10_memory_read_enable <= true;
  forward_above_read_words_10_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_10_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_10_memory_write_data <= forward_above_write_words(10);
  forward_above_read_words_10_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_10_memory_read_enable,
      read_address => forward_above_read_words_10_memory_read_address, read_data => forward_above_read_words(10),
      write_address => forward_above_read_words_10_memory_write_address, write_data => forward_above_read_words_10_memory_write_data);

  forward_above_read_words_9_memory_read_enable <= true;
  forward_above_read_words_9_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_9_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_9_memory_write_data <= forward_above_write_words(9);
  forward_above_read_words_9_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_9_memory_read_enable,
      read_address => forward_above_read_words_9_memory_read_address, read_data => forward_above_read_words(9),
      write_address => forward_above_read_words_9_memory_write_address, write_data => forward_above_read_words_9_memory_write_data);

  forward_above_read_words_8_memory_read_enable <= true;
  forward_above_read_words_8_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_8_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_8_memory_write_data <= forward_above_write_words(8);
  forward_above_read_words_8_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_8_memory_read_enable,
      read_address => forward_above_read_words_8_memory_read_address, read_data => forward_above_read_words(8),
      write_address => forward_above_read_words_8_memory_write_address, write_data => forward_above_read_words_8_memory_write_data);

  forward_above_read_words_7_memory_read_enable <= true;
  forward_above_read_words_7_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_7_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_7_memory_write_data <= forward_above_write_words(7);
  forward_above_read_words_7_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_7_memory_read_enable,
      read_address => forward_above_read_words_7_memory_read_address, read_data => forward_above_read_words(7),
      write_address => forward_above_read_words_7_memory_write_address, write_data => forward_above_read_words_7_memory_write_data);

  forward_above_read_words_6_memory_read_enable <= true;
  forward_above_read_words_6_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_6_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_6_memory_write_data <= forward_above_write_words(6);
  forward_above_read_words_6_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_6_memory_read_enable,
      read_address => forward_above_read_words_6_memory_read_address, read_data => forward_above_read_words(6),
      write_address => forward_above_read_words_6_memory_write_address, write_data => forward_above_read_words_6_memory_write_data);

  forward_above_read_words_5_memory_read_enable <= true;
  forward_above_read_words_5_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_5_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_5_memory_write_data <= forward_above_write_words(5);
  forward_above_read_words_5_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_5_memory_read_enable,
      read_address => forward_above_read_words_5_memory_read_address, read_data => forward_above_read_words(5),
      write_address => forward_above_read_words_5_memory_write_address, write_data => forward_above_read_words_5_memory_write_data);

  forward_above_read_words_4_memory_read_enable <= true;
  forward_above_read_words_4_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_4_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_4_memory_write_data <= forward_above_write_words(4);
  forward_above_read_words_4_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_4_memory_read_enable,
      read_address => forward_above_read_words_4_memory_read_address, read_data => forward_above_read_words(4),
      write_address => forward_above_read_words_4_memory_write_address, write_data => forward_above_read_words_4_memory_write_data);

  forward_above_read_words_3_memory_read_enable <= true;
  forward_above_read_words_3_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_3_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_3_memory_write_data <= forward_above_write_words(3);
  forward_above_read_words_3_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_3_memory_read_enable,
      read_address => forward_above_read_words_3_memory_read_address, read_data => forward_above_read_words(3),
      write_address => forward_above_read_words_3_memory_write_address, write_data => forward_above_read_words_3_memory_write_data);

  forward_above_read_words_2_memory_read_enable <= true;
  forward_above_read_words_2_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_2_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_2_memory_write_data <= forward_above_write_words(2);
  forward_above_read_words_2_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_2_memory_read_enable,
      read_address => forward_above_read_words_2_memory_read_address, read_data => forward_above_read_words(2),
      write_address => forward_above_read_words_2_memory_write_address, write_data => forward_above_read_words_2_memory_write_data);

  forward_above_read_words_1_memory_read_enable <= true;
  forward_above_read_words_1_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_1_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_1_memory_write_data <= forward_above_write_words(1);
  forward_above_read_words_1_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_1_memory_read_enable,
      read_address => forward_above_read_words_1_memory_read_address, read_data => forward_above_read_words(1),
      write_address => forward_above_read_words_1_memory_write_address, write_data => forward_above_read_words_1_memory_write_data);

  forward_above_read_words_0_memory_read_enable <= true;
  forward_above_read_words_0_memory_read_address <= to_unsigned(entry_next_column, 10);
  forward_above_read_words_0_memory_write_address <= to_unsigned(forward_above_write_column, 10);
  forward_above_read_words_0_memory_write_data <= forward_above_write_words(0);
  forward_above_read_words_0_memory : entity work.line_memory
    generic map (depth => 513, width => 32, address_bits => 10)
    port map (
      clock => clock, read_enable => forward_above_read_words_0_memory_read_enable,
      read_address => forward_above_read_words_0_memory_read_address, read_data => forward_above_read_words(0),
      write_address => forward_above_read_words_0_memory_write_address, write_data => forward_above_read_words_0_memory_write_data);

  forward_above_delay_held_25_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_25_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_25_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_25_memory_write_data <= to_unsigned(forward_above_total(127), 6) & to_unsigned(forward_above_total(126), 6) & to_unsigned(forward_above_total(125), 6);
  forward_above_delay_held_25_memory : entity work.line_memory
    generic map (depth => 8, width => 18, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_25_memory_read_enable,
      read_address => forward_above_delay_held_25_memory_read_address, read_data => forward_above_delay_held_25,
      write_address => forward_above_delay_held_25_memory_write_address, write_data => forward_above_delay_held_25_memory_write_data);

  forward_above_delay_held_24_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_24_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_24_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_24_memory_write_data <= to_unsigned(forward_above_total(124), 6) & to_unsigned(forward_above_total(123), 6) & to_unsigned(forward_above_total(122), 6) & to_unsigned(forward_above_total(121), 6) & to_unsigned(forward_above_total(120), 6);
  forward_above_delay_held_24_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_24_memory_read_enable,
      read_address => forward_above_delay_held_24_memory_read_address, read_data => forward_above_delay_held(24),
      write_address => forward_above_delay_held_24_memory_write_address, write_data => forward_above_delay_held_24_memory_write_data);

  forward_above_delay_held_23_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_23_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_23_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_23_memory_write_data <= to_unsigned(forward_above_total(119), 6) & to_unsigned(forward_above_total(118), 6) & to_unsigned(forward_above_total(117), 6) & to_unsigned(forward_above_total(116), 6) & to_unsigned(forward_above_total(115), 6);
  forward_above_delay_held_23_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_23_memory_read_enable,
      read_address => forward_above_delay_held_23_memory_read_address, read_data => forward_above_delay_held(23),
      write_address => forward_above_delay_held_23_memory_write_address, write_data => forward_above_delay_held_23_memory_write_data);

  forward_above_delay_held_22_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_22_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_22_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_22_memory_write_data <= to_unsigned(forward_above_total(114), 6) & to_unsigned(forward_above_total(113), 6) & to_unsigned(forward_above_total(112), 6) & to_unsigned(forward_above_total(111), 6) & to_unsigned(forward_above_total(110), 6);
  forward_above_delay_held_22_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_22_memory_read_enable,
      read_address => forward_above_delay_held_22_memory_read_address, read_data => forward_above_delay_held(22),
      write_address => forward_above_delay_held_22_memory_write_address, write_data => forward_above_delay_held_22_memory_write_data);

  forward_above_delay_held_21_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_21_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_21_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_21_memory_write_data <= to_unsigned(forward_above_total(109), 6) & to_unsigned(forward_above_total(108), 6) & to_unsigned(forward_above_total(107), 6) & to_unsigned(forward_above_total(106), 6) & to_unsigned(forward_above_total(105), 6);
  forward_above_delay_held_21_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_21_memory_read_enable,
      read_address => forward_above_delay_held_21_memory_read_address, read_data => forward_above_delay_held(21),
      write_address => forward_above_delay_held_21_memory_write_address, write_data => forward_above_delay_held_21_memory_write_data);

  forward_above_delay_held_20_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_20_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_20_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_20_memory_write_data <= to_unsigned(forward_above_total(104), 6) & to_unsigned(forward_above_total(103), 6) & to_unsigned(forward_above_total(102), 6) & to_unsigned(forward_above_total(101), 6) & to_unsigned(forward_above_total(100), 6);
  forward_above_delay_held_20_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_20_memory_read_enable,
      read_address => forward_above_delay_held_20_memory_read_address, read_data => forward_above_delay_held(20),
      write_address => forward_above_delay_held_20_memory_write_address, write_data => forward_above_delay_held_20_memory_write_data);

  forward_above_delay_held_19_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_19_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_19_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_19_memory_write_data <= to_unsigned(forward_above_total(99), 6) & to_unsigned(forward_above_total(98), 6) & to_unsigned(forward_above_total(97), 6) & to_unsigned(forward_above_total(96), 6) & to_unsigned(forward_above_total(95), 6);
  forward_above_delay_held_19_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_19_memory_read_enable,
      read_address => forward_above_delay_held_19_memory_read_address, read_data => forward_above_delay_held(19),
      write_address => forward_above_delay_held_19_memory_write_address, write_data => forward_above_delay_held_19_memory_write_data);

  forward_above_delay_held_18_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_18_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_18_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_18_memory_write_data <= to_unsigned(forward_above_total(94), 6) & to_unsigned(forward_above_total(93), 6) & to_unsigned(forward_above_total(92), 6) & to_unsigned(forward_above_total(91), 6) & to_unsigned(forward_above_total(90), 6);
  forward_above_delay_held_18_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_18_memory_read_enable,
      read_address => forward_above_delay_held_18_memory_read_address, read_data => forward_above_delay_held(18),
      write_address => forward_above_delay_held_18_memory_write_address, write_data => forward_above_delay_held_18_memory_write_data);

  forward_above_delay_held_17_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_17_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_17_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_17_memory_write_data <= to_unsigned(forward_above_total(89), 6) & to_unsigned(forward_above_total(88), 6) & to_unsigned(forward_above_total(87), 6) & to_unsigned(forward_above_total(86), 6) & to_unsigned(forward_above_total(85), 6);
  forward_above_delay_held_17_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_17_memory_read_enable,
      read_address => forward_above_delay_held_17_memory_read_address, read_data => forward_above_delay_held(17),
      write_address => forward_above_delay_held_17_memory_write_address, write_data => forward_above_delay_held_17_memory_write_data);

  forward_above_delay_held_16_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_16_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_16_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_16_memory_write_data <= to_unsigned(forward_above_total(84), 6) & to_unsigned(forward_above_total(83), 6) & to_unsigned(forward_above_total(82), 6) & to_unsigned(forward_above_total(81), 6) & to_unsigned(forward_above_total(80), 6);
  forward_above_delay_held_16_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_16_memory_read_enable,
      read_address => forward_above_delay_held_16_memory_read_address, read_data => forward_above_delay_held(16),
      write_address => forward_above_delay_held_16_memory_write_address, write_data => forward_above_delay_held_16_memory_write_data);

  forward_above_delay_held_15_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_15_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_15_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_15_memory_write_data <= to_unsigned(forward_above_total(79), 6) & to_unsigned(forward_above_total(78), 6) & to_unsigned(forward_above_total(77), 6) & to_unsigned(forward_above_total(76), 6) & to_unsigned(forward_above_total(75), 6);
  forward_above_delay_held_15_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_15_memory_read_enable,
      read_address => forward_above_delay_held_15_memory_read_address, read_data => forward_above_delay_held(15),
      write_address => forward_above_delay_held_15_memory_write_address, write_data => forward_above_delay_held_15_memory_write_data);

  forward_above_delay_held_14_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_14_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_14_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_14_memory_write_data <= to_unsigned(forward_above_total(74), 6) & to_unsigned(forward_above_total(73), 6) & to_unsigned(forward_above_total(72), 6) & to_unsigned(forward_above_total(71), 6) & to_unsigned(forward_above_total(70), 6);
  forward_above_delay_held_14_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_14_memory_read_enable,
      read_address => forward_above_delay_held_14_memory_read_address, read_data => forward_above_delay_held(14),
      write_address => forward_above_delay_held_14_memory_write_address, write_data => forward_above_delay_held_14_memory_write_data);

  forward_above_delay_held_13_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_13_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_13_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_13_memory_write_data <= to_unsigned(forward_above_total(69), 6) & to_unsigned(forward_above_total(68), 6) & to_unsigned(forward_above_total(67), 6) & to_unsigned(forward_above_total(66), 6) & to_unsigned(forward_above_total(65), 6);
  forward_above_delay_held_13_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_13_memory_read_enable,
      read_address => forward_above_delay_held_13_memory_read_address, read_data => forward_above_delay_held(13),
      write_address => forward_above_delay_held_13_memory_write_address, write_data => forward_above_delay_held_13_memory_write_data);

  forward_above_delay_held_12_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_12_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_12_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_12_memory_write_data <= to_unsigned(forward_above_total(64), 6) & to_unsigned(forward_above_total(63), 6) & to_unsigned(forward_above_total(62), 6) & to_unsigned(forward_above_total(61), 6) & to_unsigned(forward_above_total(60), 6);
  forward_above_delay_held_12_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_12_memory_read_enable,
      read_address => forward_above_delay_held_12_memory_read_address, read_data => forward_above_delay_held(12),
      write_address => forward_above_delay_held_12_memory_write_address, write_data => forward_above_delay_held_12_memory_write_data);

  forward_above_delay_held_11_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_11_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_11_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_11_memory_write_data <= to_unsigned(forward_above_total(59), 6) & to_unsigned(forward_above_total(58), 6) & to_unsigned(forward_above_total(57), 6) & to_unsigned(forward_above_total(56), 6) & to_unsigned(forward_above_total(55), 6);
  forward_above_delay_held_11_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_11_memory_read_enable,
      read_address => forward_above_delay_held_11_memory_read_address, read_data => forward_above_delay_held(11),
      write_address => forward_above_delay_held_11_memory_write_address, write_data => forward_above_delay_held_11_memory_write_data);

  forward_above_delay_held_10_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_10_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_10_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_10_memory_write_data <= to_unsigned(forward_above_total(54), 6) & to_unsigned(forward_above_total(53), 6) & to_unsigned(forward_above_total(52), 6) & to_unsigned(forward_above_total(51), 6) & to_unsigned(forward_above_total(50), 6);
  forward_above_delay_held_10_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_10_memory_read_enable,
      read_address => forward_above_delay_held_10_memory_read_address, read_data => forward_above_delay_held(10),
      write_address => forward_above_delay_held_10_memory_write_address, write_data => forward_above_delay_held_10_memory_write_data);

  forward_above_delay_held_9_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_9_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_9_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_9_memory_write_data <= to_unsigned(forward_above_total(49), 6) & to_unsigned(forward_above_total(48), 6) & to_unsigned(forward_above_total(47), 6) & to_unsigned(forward_above_total(46), 6) & to_unsigned(forward_above_total(45), 6);
  forward_above_delay_held_9_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_9_memory_read_enable,
      read_address => forward_above_delay_held_9_memory_read_address, read_data => forward_above_delay_held(9),
      write_address => forward_above_delay_held_9_memory_write_address, write_data => forward_above_delay_held_9_memory_write_data);

  forward_above_delay_held_8_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_8_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_8_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_8_memory_write_data <= to_unsigned(forward_above_total(44), 6) & to_unsigned(forward_above_total(43), 6) & to_unsigned(forward_above_total(42), 6) & to_unsigned(forward_above_total(41), 6) & to_unsigned(forward_above_total(40), 6);
  forward_above_delay_held_8_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_8_memory_read_enable,
      read_address => forward_above_delay_held_8_memory_read_address, read_data => forward_above_delay_held(8),
      write_address => forward_above_delay_held_8_memory_write_address, write_data => forward_above_delay_held_8_memory_write_data);

  forward_above_delay_held_7_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_7_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_7_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_7_memory_write_data <= to_unsigned(forward_above_total(39), 6) & to_unsigned(forward_above_total(38), 6) & to_unsigned(forward_above_total(37), 6) & to_unsigned(forward_above_total(36), 6) & to_unsigned(forward_above_total(35), 6);
  forward_above_delay_held_7_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_7_memory_read_enable,
      read_address => forward_above_delay_held_7_memory_read_address, read_data => forward_above_delay_held(7),
      write_address => forward_above_delay_held_7_memory_write_address, write_data => forward_above_delay_held_7_memory_write_data);

  forward_above_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_6_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_6_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_6_memory_write_data <= to_unsigned(forward_above_total(34), 6) & to_unsigned(forward_above_total(33), 6) & to_unsigned(forward_above_total(32), 6) & to_unsigned(forward_above_total(31), 6) & to_unsigned(forward_above_total(30), 6);
  forward_above_delay_held_6_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_6_memory_read_enable,
      read_address => forward_above_delay_held_6_memory_read_address, read_data => forward_above_delay_held(6),
      write_address => forward_above_delay_held_6_memory_write_address, write_data => forward_above_delay_held_6_memory_write_data);

  forward_above_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_5_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_5_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_5_memory_write_data <= to_unsigned(forward_above_total(29), 6) & to_unsigned(forward_above_total(28), 6) & to_unsigned(forward_above_total(27), 6) & to_unsigned(forward_above_total(26), 6) & to_unsigned(forward_above_total(25), 6);
  forward_above_delay_held_5_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_5_memory_read_enable,
      read_address => forward_above_delay_held_5_memory_read_address, read_data => forward_above_delay_held(5),
      write_address => forward_above_delay_held_5_memory_write_address, write_data => forward_above_delay_held_5_memory_write_data);

  forward_above_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_4_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_4_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_4_memory_write_data <= to_unsigned(forward_above_total(24), 6) & to_unsigned(forward_above_total(23), 6) & to_unsigned(forward_above_total(22), 6) & to_unsigned(forward_above_total(21), 6) & to_unsigned(forward_above_total(20), 6);
  forward_above_delay_held_4_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_4_memory_read_enable,
      read_address => forward_above_delay_held_4_memory_read_address, read_data => forward_above_delay_held(4),
      write_address => forward_above_delay_held_4_memory_write_address, write_data => forward_above_delay_held_4_memory_write_data);

  forward_above_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_3_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_3_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_3_memory_write_data <= to_unsigned(forward_above_total(19), 6) & to_unsigned(forward_above_total(18), 6) & to_unsigned(forward_above_total(17), 6) & to_unsigned(forward_above_total(16), 6) & to_unsigned(forward_above_total(15), 6);
  forward_above_delay_held_3_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_3_memory_read_enable,
      read_address => forward_above_delay_held_3_memory_read_address, read_data => forward_above_delay_held(3),
      write_address => forward_above_delay_held_3_memory_write_address, write_data => forward_above_delay_held_3_memory_write_data);

  forward_above_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_2_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_2_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_2_memory_write_data <= to_unsigned(forward_above_total(14), 6) & to_unsigned(forward_above_total(13), 6) & to_unsigned(forward_above_total(12), 6) & to_unsigned(forward_above_total(11), 6) & to_unsigned(forward_above_total(10), 6);
  forward_above_delay_held_2_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_2_memory_read_enable,
      read_address => forward_above_delay_held_2_memory_read_address, read_data => forward_above_delay_held(2),
      write_address => forward_above_delay_held_2_memory_write_address, write_data => forward_above_delay_held_2_memory_write_data);

  forward_above_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_1_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_1_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_1_memory_write_data <= to_unsigned(forward_above_total(9), 6) & to_unsigned(forward_above_total(8), 6) & to_unsigned(forward_above_total(7), 6) & to_unsigned(forward_above_total(6), 6) & to_unsigned(forward_above_total(5), 6);
  forward_above_delay_held_1_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_1_memory_read_enable,
      read_address => forward_above_delay_held_1_memory_read_address, read_data => forward_above_delay_held(1),
      write_address => forward_above_delay_held_1_memory_write_address, write_data => forward_above_delay_held_1_memory_write_data);

  forward_above_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_0_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_0_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_0_memory_write_data <= to_unsigned(forward_above_total(4), 6) & to_unsigned(forward_above_total(3), 6) & to_unsigned(forward_above_total(2), 6) & to_unsigned(forward_above_total(1), 6) & to_unsigned(forward_above_total(0), 6);
  forward_above_delay_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 30, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_0_memory_read_enable,
      read_address => forward_above_delay_held_0_memory_read_address, read_data => forward_above_delay_held(0),
      write_address => forward_above_delay_held_0_memory_write_address, write_data => forward_above_delay_held_0_memory_write_data);

  forward_cost_delay_held_15_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_15_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_15_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_15_memory_write_data <= to_unsigned(entry_cost(127), 4) & to_unsigned(entry_cost(126), 4) & to_unsigned(entry_cost(125), 4) & to_unsigned(entry_cost(124), 4) & to_unsigned(entry_cost(123), 4) & to_unsigned(entry_cost(122), 4) & to_unsigned(entry_cost(121), 4) & to_unsigned(entry_cost(120), 4);
  forward_cost_delay_held_15_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_15_memory_read_enable,
      read_address => forward_cost_delay_held_15_memory_read_address, read_data => forward_cost_delay_held(15),
      write_address => forward_cost_delay_held_15_memory_write_address, write_data => forward_cost_delay_held_15_memory_write_data);

  forward_cost_delay_held_14_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_14_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_14_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_14_memory_write_data <= to_unsigned(entry_cost(119), 4) & to_unsigned(entry_cost(118), 4) & to_unsigned(entry_cost(117), 4) & to_unsigned(entry_cost(116), 4) & to_unsigned(entry_cost(115), 4) & to_unsigned(entry_cost(114), 4) & to_unsigned(entry_cost(113), 4) & to_unsigned(entry_cost(112), 4);
  forward_cost_delay_held_14_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_14_memory_read_enable,
      read_address => forward_cost_delay_held_14_memory_read_address, read_data => forward_cost_delay_held(14),
      write_address => forward_cost_delay_held_14_memory_write_address, write_data => forward_cost_delay_held_14_memory_write_data);

  forward_cost_delay_held_13_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_13_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_13_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_13_memory_write_data <= to_unsigned(entry_cost(111), 4) & to_unsigned(entry_cost(110), 4) & to_unsigned(entry_cost(109), 4) & to_unsigned(entry_cost(108), 4) & to_unsigned(entry_cost(107), 4) & to_unsigned(entry_cost(106), 4) & to_unsigned(entry_cost(105), 4) & to_unsigned(entry_cost(104), 4);
  forward_cost_delay_held_13_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_13_memory_read_enable,
      read_address => forward_cost_delay_held_13_memory_read_address, read_data => forward_cost_delay_held(13),
      write_address => forward_cost_delay_held_13_memory_write_address, write_data => forward_cost_delay_held_13_memory_write_data);

  forward_cost_delay_held_12_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_12_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_12_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_12_memory_write_data <= to_unsigned(entry_cost(103), 4) & to_unsigned(entry_cost(102), 4) & to_unsigned(entry_cost(101), 4) & to_unsigned(entry_cost(100), 4) & to_unsigned(entry_cost(99), 4) & to_unsigned(entry_cost(98), 4) & to_unsigned(entry_cost(97), 4) & to_unsigned(entry_cost(96), 4);
  forward_cost_delay_held_12_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_12_memory_read_enable,
      read_address => forward_cost_delay_held_12_memory_read_address, read_data => forward_cost_delay_held(12),
      write_address => forward_cost_delay_held_12_memory_write_address, write_data => forward_cost_delay_held_12_memory_write_data);

  forward_cost_delay_held_11_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_11_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_11_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_11_memory_write_data <= to_unsigned(entry_cost(95), 4) & to_unsigned(entry_cost(94), 4) & to_unsigned(entry_cost(93), 4) & to_unsigned(entry_cost(92), 4) & to_unsigned(entry_cost(91), 4) & to_unsigned(entry_cost(90), 4) & to_unsigned(entry_cost(89), 4) & to_unsigned(entry_cost(88), 4);
  forward_cost_delay_held_11_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_11_memory_read_enable,
      read_address => forward_cost_delay_held_11_memory_read_address, read_data => forward_cost_delay_held(11),
      write_address => forward_cost_delay_held_11_memory_write_address, write_data => forward_cost_delay_held_11_memory_write_data);

  forward_cost_delay_held_10_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_10_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_10_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_10_memory_write_data <= to_unsigned(entry_cost(87), 4) & to_unsigned(entry_cost(86), 4) & to_unsigned(entry_cost(85), 4) & to_unsigned(entry_cost(84), 4) & to_unsigned(entry_cost(83), 4) & to_unsigned(entry_cost(82), 4) & to_unsigned(entry_cost(81), 4) & to_unsigned(entry_cost(80), 4);
  forward_cost_delay_held_10_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_10_memory_read_enable,
      read_address => forward_cost_delay_held_10_memory_read_address, read_data => forward_cost_delay_held(10),
      write_address => forward_cost_delay_held_10_memory_write_address, write_data => forward_cost_delay_held_10_memory_write_data);

  forward_cost_delay_held_9_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_9_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_9_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_9_memory_write_data <= to_unsigned(entry_cost(79), 4) & to_unsigned(entry_cost(78), 4) & to_unsigned(entry_cost(77), 4) & to_unsigned(entry_cost(76), 4) & to_unsigned(entry_cost(75), 4) & to_unsigned(entry_cost(74), 4) & to_unsigned(entry_cost(73), 4) & to_unsigned(entry_cost(72), 4);
  forward_cost_delay_held_9_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_9_memory_read_enable,
      read_address => forward_cost_delay_held_9_memory_read_address, read_data => forward_cost_delay_held(9),
      write_address => forward_cost_delay_held_9_memory_write_address, write_data => forward_cost_delay_held_9_memory_write_data);

  forward_cost_delay_held_8_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_8_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_8_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_8_memory_write_data <= to_unsigned(entry_cost(71), 4) & to_unsigned(entry_cost(70), 4) & to_unsigned(entry_cost(69), 4) & to_unsigned(entry_cost(68), 4) & to_unsigned(entry_cost(67), 4) & to_unsigned(entry_cost(66), 4) & to_unsigned(entry_cost(65), 4) & to_unsigned(entry_cost(64), 4);
  forward_cost_delay_held_8_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_8_memory_read_enable,
      read_address => forward_cost_delay_held_8_memory_read_address, read_data => forward_cost_delay_held(8),
      write_address => forward_cost_delay_held_8_memory_write_address, write_data => forward_cost_delay_held_8_memory_write_data);

  forward_cost_delay_held_7_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_7_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_7_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_7_memory_write_data <= to_unsigned(entry_cost(63), 4) & to_unsigned(entry_cost(62), 4) & to_unsigned(entry_cost(61), 4) & to_unsigned(entry_cost(60), 4) & to_unsigned(entry_cost(59), 4) & to_unsigned(entry_cost(58), 4) & to_unsigned(entry_cost(57), 4) & to_unsigned(entry_cost(56), 4);
  forward_cost_delay_held_7_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_7_memory_read_enable,
      read_address => forward_cost_delay_held_7_memory_read_address, read_data => forward_cost_delay_held(7),
      write_address => forward_cost_delay_held_7_memory_write_address, write_data => forward_cost_delay_held_7_memory_write_data);

  forward_cost_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_6_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_6_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_6_memory_write_data <= to_unsigned(entry_cost(55), 4) & to_unsigned(entry_cost(54), 4) & to_unsigned(entry_cost(53), 4) & to_unsigned(entry_cost(52), 4) & to_unsigned(entry_cost(51), 4) & to_unsigned(entry_cost(50), 4) & to_unsigned(entry_cost(49), 4) & to_unsigned(entry_cost(48), 4);
  forward_cost_delay_held_6_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_6_memory_read_enable,
      read_address => forward_cost_delay_held_6_memory_read_address, read_data => forward_cost_delay_held(6),
      write_address => forward_cost_delay_held_6_memory_write_address, write_data => forward_cost_delay_held_6_memory_write_data);

  forward_cost_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_5_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_5_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_5_memory_write_data <= to_unsigned(entry_cost(47), 4) & to_unsigned(entry_cost(46), 4) & to_unsigned(entry_cost(45), 4) & to_unsigned(entry_cost(44), 4) & to_unsigned(entry_cost(43), 4) & to_unsigned(entry_cost(42), 4) & to_unsigned(entry_cost(41), 4) & to_unsigned(entry_cost(40), 4);
  forward_cost_delay_held_5_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_5_memory_read_enable,
      read_address => forward_cost_delay_held_5_memory_read_address, read_data => forward_cost_delay_held(5),
      write_address => forward_cost_delay_held_5_memory_write_address, write_data => forward_cost_delay_held_5_memory_write_data);

  forward_cost_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_4_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_4_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_4_memory_write_data <= to_unsigned(entry_cost(39), 4) & to_unsigned(entry_cost(38), 4) & to_unsigned(entry_cost(37), 4) & to_unsigned(entry_cost(36), 4) & to_unsigned(entry_cost(35), 4) & to_unsigned(entry_cost(34), 4) & to_unsigned(entry_cost(33), 4) & to_unsigned(entry_cost(32), 4);
  forward_cost_delay_held_4_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_4_memory_read_enable,
      read_address => forward_cost_delay_held_4_memory_read_address, read_data => forward_cost_delay_held(4),
      write_address => forward_cost_delay_held_4_memory_write_address, write_data => forward_cost_delay_held_4_memory_write_data);

  forward_cost_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_3_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_3_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_3_memory_write_data <= to_unsigned(entry_cost(31), 4) & to_unsigned(entry_cost(30), 4) & to_unsigned(entry_cost(29), 4) & to_unsigned(entry_cost(28), 4) & to_unsigned(entry_cost(27), 4) & to_unsigned(entry_cost(26), 4) & to_unsigned(entry_cost(25), 4) & to_unsigned(entry_cost(24), 4);
  forward_cost_delay_held_3_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_3_memory_read_enable,
      read_address => forward_cost_delay_held_3_memory_read_address, read_data => forward_cost_delay_held(3),
      write_address => forward_cost_delay_held_3_memory_write_address, write_data => forward_cost_delay_held_3_memory_write_data);

  forward_cost_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_2_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_2_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_2_memory_write_data <= to_unsigned(entry_cost(23), 4) & to_unsigned(entry_cost(22), 4) & to_unsigned(entry_cost(21), 4) & to_unsigned(entry_cost(20), 4) & to_unsigned(entry_cost(19), 4) & to_unsigned(entry_cost(18), 4) & to_unsigned(entry_cost(17), 4) & to_unsigned(entry_cost(16), 4);
  forward_cost_delay_held_2_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_2_memory_read_enable,
      read_address => forward_cost_delay_held_2_memory_read_address, read_data => forward_cost_delay_held(2),
      write_address => forward_cost_delay_held_2_memory_write_address, write_data => forward_cost_delay_held_2_memory_write_data);

  forward_cost_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_1_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_1_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_1_memory_write_data <= to_unsigned(entry_cost(15), 4) & to_unsigned(entry_cost(14), 4) & to_unsigned(entry_cost(13), 4) & to_unsigned(entry_cost(12), 4) & to_unsigned(entry_cost(11), 4) & to_unsigned(entry_cost(10), 4) & to_unsigned(entry_cost(9), 4) & to_unsigned(entry_cost(8), 4);
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held(1),
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= to_unsigned(entry_cost(7), 4) & to_unsigned(entry_cost(6), 4) & to_unsigned(entry_cost(5), 4) & to_unsigned(entry_cost(4), 4) & to_unsigned(entry_cost(3), 4) & to_unsigned(entry_cost(2), 4) & to_unsigned(entry_cost(1), 4) & to_unsigned(entry_cost(0), 4);
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 8, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held(0),
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_counter_next_frame_choice : boolean;
    variable transform_counter_next_frame_choices : boolean_1d(2 to 4);  -- transform_counter_next_frame_choice_#
    variable transform_read_column_inside_0_is_less, transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_any, transform_left_filter_feature_0_choice : boolean;
    variable transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 353);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_left_filter_feature_0_value_#
    variable transform_right_filter_feature_0_value, transform_right_filter_feature_0_any : boolean;
    variable transform_right_filter_feature_0_choice, transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 353);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_right_filter_feature_0_value_#
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less : boolean;
    variable slice0cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice0cost_pixels_first_0_0_count_#_value
    variable slice0cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice0cost_pixels_first_0_0_count_#_value_2
    variable slice0cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice0cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice0cost_pixels_first_0_0_count_#_value_3
    variable slice1cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice1cost_pixels_first_0_0_count_#_value
    variable slice1cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice1cost_pixels_first_0_0_count_#_value_2
    variable slice1cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice1cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice1cost_pixels_first_0_0_count_#_value_3
    variable slice2cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice2cost_pixels_first_0_0_count_#_value
    variable slice2cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice2cost_pixels_first_0_0_count_#_value_2
    variable slice2cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice2cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice2cost_pixels_first_0_0_count_#_value_3
    variable slice3cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice3cost_pixels_first_0_0_count_#_value
    variable slice3cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice3cost_pixels_first_0_0_count_#_value_2
    variable slice3cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice3cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice3cost_pixels_first_0_0_count_#_value_3
    variable slice4cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice4cost_pixels_first_0_0_count_#_value
    variable slice4cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice4cost_pixels_first_0_0_count_#_value_2
    variable slice4cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice4cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice4cost_pixels_first_0_0_count_#_value_3
    variable slice5cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice5cost_pixels_first_0_0_count_#_value
    variable slice5cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice5cost_pixels_first_0_0_count_#_value_2
    variable slice5cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice5cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice5cost_pixels_first_0_0_count_#_value_3
    variable slice6cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice6cost_pixels_first_0_0_count_#_value
    variable slice6cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice6cost_pixels_first_0_0_count_#_value_2
    variable slice6cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice6cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice6cost_pixels_first_0_0_count_#_value_3
    variable slice7cost_pixels_first_0_0_count_value : boolean_1d(0 to 14);  -- slice7cost_pixels_first_0_0_count_#_value
    variable slice7cost_pixels_first_0_0_count_value_2 : boolean_1d(0 to 13);  -- slice7cost_pixels_first_0_0_count_#_value_2
    variable slice7cost_pixels_first_0_0_count_1_value_3 : boolean;
    variable slice7cost_pixels_first_0_0_count_value_3 : boolean_1d(3 to 13);  -- slice7cost_pixels_first_0_0_count_#_value_3
    variable entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any : boolean;
    variable entry_order_turned_output_column_choice, forward_left_start_cost_0_value : boolean;
    variable sums_right_start_cost_0_value, sums_turn_writes_copy_0_choice, winnerswinner1_of_pair_0_0_choice : boolean;
    variable winnerswinner1_of_pair_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_0_choice_#
    variable winnerswinner1_of_pair_0_0_value : boolean;
    variable winnerswinner1_of_pair_0_0_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_0_value_#
    variable winnerswinner1_of_pair_0_2_choice : boolean;
    variable winnerswinner1_of_pair_0_2_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_2_choice_#
    variable winnerswinner1_of_pair_0_2_value : boolean;
    variable winnerswinner1_of_pair_0_2_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_2_value_#
    variable winnerswinner1_of_pair_0_4_choice : boolean;
    variable winnerswinner1_of_pair_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_4_choice_#
    variable winnerswinner1_of_pair_0_4_value : boolean;
    variable winnerswinner1_of_pair_0_4_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_4_value_#
    variable winnerswinner1_of_pair_0_6_choice : boolean;
    variable winnerswinner1_of_pair_0_6_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_6_choice_#
    variable winnerswinner1_of_pair_0_6_value : boolean;
    variable winnerswinner1_of_pair_0_6_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_6_value_#
    variable winnerswinner1_of_pair_0_8_choice : boolean;
    variable winnerswinner1_of_pair_0_8_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_8_choice_#
    variable winnerswinner1_of_pair_0_8_value : boolean;
    variable winnerswinner1_of_pair_0_8_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_8_value_#
    variable winnerswinner1_of_pair_0_10_choice : boolean;
    variable winnerswinner1_of_pair_0_10_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_10_choice_#
    variable winnerswinner1_of_pair_0_10_value : boolean;
    variable winnerswinner1_of_pair_0_10_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_10_value_#
    variable winnerswinner1_of_pair_0_12_choice : boolean;
    variable winnerswinner1_of_pair_0_12_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_12_choice_#
    variable winnerswinner1_of_pair_0_12_value : boolean;
    variable winnerswinner1_of_pair_0_12_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_12_value_#
    variable winnerswinner1_of_pair_0_14_choice : boolean;
    variable winnerswinner1_of_pair_0_14_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_14_choice_#
    variable winnerswinner1_of_pair_0_14_value : boolean;
    variable winnerswinner1_of_pair_0_14_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_14_value_#
    variable winnerswinner1_of_pair_0_16_choice : boolean;
    variable winnerswinner1_of_pair_0_16_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_16_choice_#
    variable winnerswinner1_of_pair_0_16_value : boolean;
    variable winnerswinner1_of_pair_0_16_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_16_value_#
    variable winnerswinner1_of_pair_0_18_choice : boolean;
    variable winnerswinner1_of_pair_0_18_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_18_choice_#
    variable winnerswinner1_of_pair_0_18_value : boolean;
    variable winnerswinner1_of_pair_0_18_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_18_value_#
    variable winnerswinner1_of_pair_0_20_choice : boolean;
    variable winnerswinner1_of_pair_0_20_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_20_choice_#
    variable winnerswinner1_of_pair_0_20_value : boolean;
    variable winnerswinner1_of_pair_0_20_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_20_value_#
    variable winnerswinner1_of_pair_0_22_choice : boolean;
    variable winnerswinner1_of_pair_0_22_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_22_choice_#
    variable winnerswinner1_of_pair_0_22_value : boolean;
    variable winnerswinner1_of_pair_0_22_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_22_value_#
    variable winnerswinner1_of_pair_0_24_choice : boolean;
    variable winnerswinner1_of_pair_0_24_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_24_choice_#
    variable winnerswinner1_of_pair_0_24_value : boolean;
    variable winnerswinner1_of_pair_0_24_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_24_value_#
    variable winnerswinner1_of_pair_0_26_choice : boolean;
    variable winnerswinner1_of_pair_0_26_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_26_choice_#
    variable winnerswinner1_of_pair_0_26_value : boolean;
    variable winnerswinner1_of_pair_0_26_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_26_value_#
    variable winnerswinner1_of_pair_0_28_choice : boolean;
    variable winnerswinner1_of_pair_0_28_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_28_choice_#
    variable winnerswinner1_of_pair_0_28_value : boolean;
    variable winnerswinner1_of_pair_0_28_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_28_value_#
    variable winnerswinner1_of_pair_0_30_choice : boolean;
    variable winnerswinner1_of_pair_0_30_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_30_choice_#
    variable winnerswinner1_of_pair_0_30_value : boolean;
    variable winnerswinner1_of_pair_0_30_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_30_value_#
    variable winnerswinner1_of_pair_0_32_choice : boolean;
    variable winnerswinner1_of_pair_0_32_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_32_choice_#
    variable winnerswinner1_of_pair_0_32_value : boolean;
    variable winnerswinner1_of_pair_0_32_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_32_value_#
    variable winnerswinner1_of_pair_0_34_choice : boolean;
    variable winnerswinner1_of_pair_0_34_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_34_choice_#
    variable winnerswinner1_of_pair_0_34_value : boolean;
    variable winnerswinner1_of_pair_0_34_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_34_value_#
    variable winnerswinner1_of_pair_0_36_choice : boolean;
    variable winnerswinner1_of_pair_0_36_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_36_choice_#
    variable winnerswinner1_of_pair_0_36_value : boolean;
    variable winnerswinner1_of_pair_0_36_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_36_value_#
    variable winnerswinner1_of_pair_0_38_choice : boolean;
    variable winnerswinner1_of_pair_0_38_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_38_choice_#
    variable winnerswinner1_of_pair_0_38_value : boolean;
    variable winnerswinner1_of_pair_0_38_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_38_value_#
    variable winnerswinner1_of_pair_0_40_choice : boolean;
    variable winnerswinner1_of_pair_0_40_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_40_choice_#
    variable winnerswinner1_of_pair_0_40_value : boolean;
    variable winnerswinner1_of_pair_0_40_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_40_value_#
    variable winnerswinner1_of_pair_0_42_choice : boolean;
    variable winnerswinner1_of_pair_0_42_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_42_choice_#
    variable winnerswinner1_of_pair_0_42_value : boolean;
    variable winnerswinner1_of_pair_0_42_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_42_value_#
    variable winnerswinner1_of_pair_0_44_choice : boolean;
    variable winnerswinner1_of_pair_0_44_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_44_choice_#
    variable winnerswinner1_of_pair_0_44_value : boolean;
    variable winnerswinner1_of_pair_0_44_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_44_value_#
    variable winnerswinner1_of_pair_0_46_choice : boolean;
    variable winnerswinner1_of_pair_0_46_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_46_choice_#
    variable winnerswinner1_of_pair_0_46_value : boolean;
    variable winnerswinner1_of_pair_0_46_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_46_value_#
    variable winnerswinner1_of_pair_0_48_choice : boolean;
    variable winnerswinner1_of_pair_0_48_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_48_choice_#
    variable winnerswinner1_of_pair_0_48_value : boolean;
    variable winnerswinner1_of_pair_0_48_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_48_value_#
    variable winnerswinner1_of_pair_0_50_choice : boolean;
    variable winnerswinner1_of_pair_0_50_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_50_choice_#
    variable winnerswinner1_of_pair_0_50_value : boolean;
    variable winnerswinner1_of_pair_0_50_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_50_value_#
    variable winnerswinner1_of_pair_0_52_choice : boolean;
    variable winnerswinner1_of_pair_0_52_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_52_choice_#
    variable winnerswinner1_of_pair_0_52_value : boolean;
    variable winnerswinner1_of_pair_0_52_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_52_value_#
    variable winnerswinner1_of_pair_0_54_choice : boolean;
    variable winnerswinner1_of_pair_0_54_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_54_choice_#
    variable winnerswinner1_of_pair_0_54_value : boolean;
    variable winnerswinner1_of_pair_0_54_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_54_value_#
    variable winnerswinner1_of_pair_0_56_choice : boolean;
    variable winnerswinner1_of_pair_0_56_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_56_choice_#
    variable winnerswinner1_of_pair_0_56_value : boolean;
    variable winnerswinner1_of_pair_0_56_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_56_value_#
    variable winnerswinner1_of_pair_0_58_choice : boolean;
    variable winnerswinner1_of_pair_0_58_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_58_choice_#
    variable winnerswinner1_of_pair_0_58_value : boolean;
    variable winnerswinner1_of_pair_0_58_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_58_value_#
    variable winnerswinner1_of_pair_0_60_choice : boolean;
    variable winnerswinner1_of_pair_0_60_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_60_choice_#
    variable winnerswinner1_of_pair_0_60_value : boolean;
    variable winnerswinner1_of_pair_0_60_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_60_value_#
    variable winnerswinner1_of_pair_0_62_choice : boolean;
    variable winnerswinner1_of_pair_0_62_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_62_choice_#
    variable winnerswinner1_of_pair_0_62_value : boolean;
    variable winnerswinner1_of_pair_0_62_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_62_value_#
    variable winnerswinner1_of_pair_0_64_choice : boolean;
    variable winnerswinner1_of_pair_0_64_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_64_choice_#
    variable winnerswinner1_of_pair_0_64_value : boolean;
    variable winnerswinner1_of_pair_0_64_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_64_value_#
    variable winnerswinner1_of_pair_0_66_choice : boolean;
    variable winnerswinner1_of_pair_0_66_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_66_choice_#
    variable winnerswinner1_of_pair_0_66_value : boolean;
    variable winnerswinner1_of_pair_0_66_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_66_value_#
    variable winnerswinner1_of_pair_0_68_choice : boolean;
    variable winnerswinner1_of_pair_0_68_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_68_choice_#
    variable winnerswinner1_of_pair_0_68_value : boolean;
    variable winnerswinner1_of_pair_0_68_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_68_value_#
    variable winnerswinner1_of_pair_0_70_choice : boolean;
    variable winnerswinner1_of_pair_0_70_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_70_choice_#
    variable winnerswinner1_of_pair_0_70_value : boolean;
    variable winnerswinner1_of_pair_0_70_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_70_value_#
    variable winnerswinner1_of_pair_0_72_choice : boolean;
    variable winnerswinner1_of_pair_0_72_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_72_choice_#
    variable winnerswinner1_of_pair_0_72_value : boolean;
    variable winnerswinner1_of_pair_0_72_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_72_value_#
    variable winnerswinner1_of_pair_0_74_choice : boolean;
    variable winnerswinner1_of_pair_0_74_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_74_choice_#
    variable winnerswinner1_of_pair_0_74_value : boolean;
    variable winnerswinner1_of_pair_0_74_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_74_value_#
    variable winnerswinner1_of_pair_0_76_choice : boolean;
    variable winnerswinner1_of_pair_0_76_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_76_choice_#
    variable winnerswinner1_of_pair_0_76_value : boolean;
    variable winnerswinner1_of_pair_0_76_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_76_value_#
    variable winnerswinner1_of_pair_0_78_choice : boolean;
    variable winnerswinner1_of_pair_0_78_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_78_choice_#
    variable winnerswinner1_of_pair_0_78_value : boolean;
    variable winnerswinner1_of_pair_0_78_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_78_value_#
    variable winnerswinner1_of_pair_0_80_choice : boolean;
    variable winnerswinner1_of_pair_0_80_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_80_choice_#
    variable winnerswinner1_of_pair_0_80_value : boolean;
    variable winnerswinner1_of_pair_0_80_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_80_value_#
    variable winnerswinner1_of_pair_0_82_choice : boolean;
    variable winnerswinner1_of_pair_0_82_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_82_choice_#
    variable winnerswinner1_of_pair_0_82_value : boolean;
    variable winnerswinner1_of_pair_0_82_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_82_value_#
    variable winnerswinner1_of_pair_0_84_choice : boolean;
    variable winnerswinner1_of_pair_0_84_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_84_choice_#
    variable winnerswinner1_of_pair_0_84_value : boolean;
    variable winnerswinner1_of_pair_0_84_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_84_value_#
    variable winnerswinner1_of_pair_0_86_choice : boolean;
    variable winnerswinner1_of_pair_0_86_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_86_choice_#
    variable winnerswinner1_of_pair_0_86_value : boolean;
    variable winnerswinner1_of_pair_0_86_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_86_value_#
    variable winnerswinner1_of_pair_0_88_choice : boolean;
    variable winnerswinner1_of_pair_0_88_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_88_choice_#
    variable winnerswinner1_of_pair_0_88_value : boolean;
    variable winnerswinner1_of_pair_0_88_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_88_value_#
    variable winnerswinner1_of_pair_0_90_choice : boolean;
    variable winnerswinner1_of_pair_0_90_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_90_choice_#
    variable winnerswinner1_of_pair_0_90_value : boolean;
    variable winnerswinner1_of_pair_0_90_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_90_value_#
    variable winnerswinner1_of_pair_0_92_choice : boolean;
    variable winnerswinner1_of_pair_0_92_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_92_choice_#
    variable winnerswinner1_of_pair_0_92_value : boolean;
    variable winnerswinner1_of_pair_0_92_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_92_value_#
    variable winnerswinner1_of_pair_0_94_choice : boolean;
    variable winnerswinner1_of_pair_0_94_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_94_choice_#
    variable winnerswinner1_of_pair_0_94_value : boolean;
    variable winnerswinner1_of_pair_0_94_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_94_value_#
    variable winnerswinner1_of_pair_0_96_choice : boolean;
    variable winnerswinner1_of_pair_0_96_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_96_choice_#
    variable winnerswinner1_of_pair_0_96_value : boolean;
    variable winnerswinner1_of_pair_0_96_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_96_value_#
    variable winnerswinner1_of_pair_0_98_choice : boolean;
    variable winnerswinner1_of_pair_0_98_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_98_choice_#
    variable winnerswinner1_of_pair_0_98_value : boolean;
    variable winnerswinner1_of_pair_0_98_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_98_value_#
    variable winnerswinner1_of_pair_0_100_choice : boolean;
    variable winnerswinner1_of_pair_0_100_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_100_choice_#
    variable winnerswinner1_of_pair_0_100_value : boolean;
    variable winnerswinner1_of_pair_0_100_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_100_value_#
    variable winnerswinner1_of_pair_0_102_choice : boolean;
    variable winnerswinner1_of_pair_0_102_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_102_choice_#
    variable winnerswinner1_of_pair_0_102_value : boolean;
    variable winnerswinner1_of_pair_0_102_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_102_value_#
    variable winnerswinner1_of_pair_0_104_choice : boolean;
    variable winnerswinner1_of_pair_0_104_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_104_choice_#
    variable winnerswinner1_of_pair_0_104_value : boolean;
    variable winnerswinner1_of_pair_0_104_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_104_value_#
    variable winnerswinner1_of_pair_0_106_choice : boolean;
    variable winnerswinner1_of_pair_0_106_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_106_choice_#
    variable winnerswinner1_of_pair_0_106_value : boolean;
    variable winnerswinner1_of_pair_0_106_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_106_value_#
    variable winnerswinner1_of_pair_0_108_choice : boolean;
    variable winnerswinner1_of_pair_0_108_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_108_choice_#
    variable winnerswinner1_of_pair_0_108_value : boolean;
    variable winnerswinner1_of_pair_0_108_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_108_value_#
    variable winnerswinner1_of_pair_0_110_choice : boolean;
    variable winnerswinner1_of_pair_0_110_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_110_choice_#
    variable winnerswinner1_of_pair_0_110_value : boolean;
    variable winnerswinner1_of_pair_0_110_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_110_value_#
    variable winnerswinner1_of_pair_0_112_choice : boolean;
    variable winnerswinner1_of_pair_0_112_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_112_choice_#
    variable winnerswinner1_of_pair_0_112_value : boolean;
    variable winnerswinner1_of_pair_0_112_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_112_value_#
    variable winnerswinner1_of_pair_0_114_choice : boolean;
    variable winnerswinner1_of_pair_0_114_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_114_choice_#
    variable winnerswinner1_of_pair_0_114_value : boolean;
    variable winnerswinner1_of_pair_0_114_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_114_value_#
    variable winnerswinner1_of_pair_0_116_choice : boolean;
    variable winnerswinner1_of_pair_0_116_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_116_choice_#
    variable winnerswinner1_of_pair_0_116_value : boolean;
    variable winnerswinner1_of_pair_0_116_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_116_value_#
    variable winnerswinner1_of_pair_0_118_choice : boolean;
    variable winnerswinner1_of_pair_0_118_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_118_choice_#
    variable winnerswinner1_of_pair_0_118_value : boolean;
    variable winnerswinner1_of_pair_0_118_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_118_value_#
    variable winnerswinner1_of_pair_0_120_choice : boolean;
    variable winnerswinner1_of_pair_0_120_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_120_choice_#
    variable winnerswinner1_of_pair_0_120_value : boolean;
    variable winnerswinner1_of_pair_0_120_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_120_value_#
    variable winnerswinner1_of_pair_0_122_choice : boolean;
    variable winnerswinner1_of_pair_0_122_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_122_choice_#
    variable winnerswinner1_of_pair_0_122_value : boolean;
    variable winnerswinner1_of_pair_0_122_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_122_value_#
    variable winnerswinner1_of_pair_0_124_choice : boolean;
    variable winnerswinner1_of_pair_0_124_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_124_choice_#
    variable winnerswinner1_of_pair_0_124_value : boolean;
    variable winnerswinner1_of_pair_0_124_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_124_value_#
    variable winnerswinner1_of_pair_0_126_choice : boolean;
    variable winnerswinner1_of_pair_0_126_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_pair_0_126_choice_#
    variable winnerswinner1_of_pair_0_126_value : boolean;
    variable winnerswinner1_of_pair_0_126_values : boolean_1d(2 to 4);  -- winnerswinner1_of_pair_0_126_value_#
    variable winnerswinner1_of_four_0_0_choice, winnerswinner1_of_four_0_0_value : boolean;
    variable winnerswinner1_of_four_0_0_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_0_value_#
    variable winnerswinner1_of_four_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_0_choice_#
    variable winnerswinner1_of_four_0_4_choice, winnerswinner1_of_four_0_4_value : boolean;
    variable winnerswinner1_of_four_0_4_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_4_value_#
    variable winnerswinner1_of_four_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_4_choice_#
    variable winnerswinner1_of_four_0_8_choice, winnerswinner1_of_four_0_8_value : boolean;
    variable winnerswinner1_of_four_0_8_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_8_value_#
    variable winnerswinner1_of_four_0_8_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_8_choice_#
    variable winnerswinner1_of_four_0_12_choice, winnerswinner1_of_four_0_12_value : boolean;
    variable winnerswinner1_of_four_0_12_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_12_value_#
    variable winnerswinner1_of_four_0_12_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_12_choice_#
    variable winnerswinner1_of_four_0_16_choice, winnerswinner1_of_four_0_16_value : boolean;
    variable winnerswinner1_of_four_0_16_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_16_value_#
    variable winnerswinner1_of_four_0_16_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_16_choice_#
    variable winnerswinner1_of_four_0_20_choice, winnerswinner1_of_four_0_20_value : boolean;
    variable winnerswinner1_of_four_0_20_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_20_value_#
    variable winnerswinner1_of_four_0_20_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_20_choice_#
    variable winnerswinner1_of_four_0_24_choice, winnerswinner1_of_four_0_24_value : boolean;
    variable winnerswinner1_of_four_0_24_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_24_value_#
    variable winnerswinner1_of_four_0_24_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_24_choice_#
    variable winnerswinner1_of_four_0_28_choice, winnerswinner1_of_four_0_28_value : boolean;
    variable winnerswinner1_of_four_0_28_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_28_value_#
    variable winnerswinner1_of_four_0_28_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_28_choice_#
    variable winnerswinner1_of_four_0_32_choice, winnerswinner1_of_four_0_32_value : boolean;
    variable winnerswinner1_of_four_0_32_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_32_value_#
    variable winnerswinner1_of_four_0_32_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_32_choice_#
    variable winnerswinner1_of_four_0_36_choice, winnerswinner1_of_four_0_36_value : boolean;
    variable winnerswinner1_of_four_0_36_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_36_value_#
    variable winnerswinner1_of_four_0_36_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_36_choice_#
    variable winnerswinner1_of_four_0_40_choice, winnerswinner1_of_four_0_40_value : boolean;
    variable winnerswinner1_of_four_0_40_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_40_value_#
    variable winnerswinner1_of_four_0_40_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_40_choice_#
    variable winnerswinner1_of_four_0_44_choice, winnerswinner1_of_four_0_44_value : boolean;
    variable winnerswinner1_of_four_0_44_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_44_value_#
    variable winnerswinner1_of_four_0_44_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_44_choice_#
    variable winnerswinner1_of_four_0_48_choice, winnerswinner1_of_four_0_48_value : boolean;
    variable winnerswinner1_of_four_0_48_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_48_value_#
    variable winnerswinner1_of_four_0_48_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_48_choice_#
    variable winnerswinner1_of_four_0_52_choice, winnerswinner1_of_four_0_52_value : boolean;
    variable winnerswinner1_of_four_0_52_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_52_value_#
    variable winnerswinner1_of_four_0_52_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_52_choice_#
    variable winnerswinner1_of_four_0_56_choice, winnerswinner1_of_four_0_56_value : boolean;
    variable winnerswinner1_of_four_0_56_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_56_value_#
    variable winnerswinner1_of_four_0_56_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_56_choice_#
    variable winnerswinner1_of_four_0_60_choice, winnerswinner1_of_four_0_60_value : boolean;
    variable winnerswinner1_of_four_0_60_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_60_value_#
    variable winnerswinner1_of_four_0_60_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_60_choice_#
    variable winnerswinner1_of_four_0_64_choice, winnerswinner1_of_four_0_64_value : boolean;
    variable winnerswinner1_of_four_0_64_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_64_value_#
    variable winnerswinner1_of_four_0_64_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_64_choice_#
    variable winnerswinner1_of_four_0_68_choice, winnerswinner1_of_four_0_68_value : boolean;
    variable winnerswinner1_of_four_0_68_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_68_value_#
    variable winnerswinner1_of_four_0_68_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_68_choice_#
    variable winnerswinner1_of_four_0_72_choice, winnerswinner1_of_four_0_72_value : boolean;
    variable winnerswinner1_of_four_0_72_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_72_value_#
    variable winnerswinner1_of_four_0_72_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_72_choice_#
    variable winnerswinner1_of_four_0_76_choice, winnerswinner1_of_four_0_76_value : boolean;
    variable winnerswinner1_of_four_0_76_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_76_value_#
    variable winnerswinner1_of_four_0_76_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_76_choice_#
    variable winnerswinner1_of_four_0_80_choice, winnerswinner1_of_four_0_80_value : boolean;
    variable winnerswinner1_of_four_0_80_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_80_value_#
    variable winnerswinner1_of_four_0_80_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_80_choice_#
    variable winnerswinner1_of_four_0_84_choice, winnerswinner1_of_four_0_84_value : boolean;
    variable winnerswinner1_of_four_0_84_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_84_value_#
    variable winnerswinner1_of_four_0_84_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_84_choice_#
    variable winnerswinner1_of_four_0_88_choice, winnerswinner1_of_four_0_88_value : boolean;
    variable winnerswinner1_of_four_0_88_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_88_value_#
    variable winnerswinner1_of_four_0_88_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_88_choice_#
    variable winnerswinner1_of_four_0_92_choice, winnerswinner1_of_four_0_92_value : boolean;
    variable winnerswinner1_of_four_0_92_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_92_value_#
    variable winnerswinner1_of_four_0_92_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_92_choice_#
    variable winnerswinner1_of_four_0_96_choice, winnerswinner1_of_four_0_96_value : boolean;
    variable winnerswinner1_of_four_0_96_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_96_value_#
    variable winnerswinner1_of_four_0_96_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_96_choice_#
    variable winnerswinner1_of_four_0_100_choice, winnerswinner1_of_four_0_100_value : boolean;
    variable winnerswinner1_of_four_0_100_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_100_value_#
    variable winnerswinner1_of_four_0_100_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_100_choice_#
    variable winnerswinner1_of_four_0_104_choice, winnerswinner1_of_four_0_104_value : boolean;
    variable winnerswinner1_of_four_0_104_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_104_value_#
    variable winnerswinner1_of_four_0_104_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_104_choice_#
    variable winnerswinner1_of_four_0_108_choice, winnerswinner1_of_four_0_108_value : boolean;
    variable winnerswinner1_of_four_0_108_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_108_value_#
    variable winnerswinner1_of_four_0_108_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_108_choice_#
    variable winnerswinner1_of_four_0_112_choice, winnerswinner1_of_four_0_112_value : boolean;
    variable winnerswinner1_of_four_0_112_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_112_value_#
    variable winnerswinner1_of_four_0_112_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_112_choice_#
    variable winnerswinner1_of_four_0_116_choice, winnerswinner1_of_four_0_116_value : boolean;
    variable winnerswinner1_of_four_0_116_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_116_value_#
    variable winnerswinner1_of_four_0_116_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_116_choice_#
    variable winnerswinner1_of_four_0_120_choice, winnerswinner1_of_four_0_120_value : boolean;
    variable winnerswinner1_of_four_0_120_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_120_value_#
    variable winnerswinner1_of_four_0_120_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_120_choice_#
    variable winnerswinner1_of_four_0_124_choice, winnerswinner1_of_four_0_124_value : boolean;
    variable winnerswinner1_of_four_0_124_values : boolean_1d(2 to 10);  -- winnerswinner1_of_four_0_124_value_#
    variable winnerswinner1_of_four_0_124_choices : boolean_1d(2 to 7);  -- winnerswinner1_of_four_0_124_choice_#
    variable winnerswinner2_of_pair_0_0_choice : boolean;
    variable winnerswinner2_of_pair_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_0_choice_#
    variable winnerswinner2_of_pair_0_0_value : boolean;
    variable winnerswinner2_of_pair_0_0_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_0_value_#
    variable winnerswinner2_of_pair_0_2_choice : boolean;
    variable winnerswinner2_of_pair_0_2_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_2_choice_#
    variable winnerswinner2_of_pair_0_2_value : boolean;
    variable winnerswinner2_of_pair_0_2_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_2_value_#
    variable winnerswinner2_of_pair_0_4_choice : boolean;
    variable winnerswinner2_of_pair_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_4_choice_#
    variable winnerswinner2_of_pair_0_4_value : boolean;
    variable winnerswinner2_of_pair_0_4_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_4_value_#
    variable winnerswinner2_of_pair_0_6_choice : boolean;
    variable winnerswinner2_of_pair_0_6_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_6_choice_#
    variable winnerswinner2_of_pair_0_6_value : boolean;
    variable winnerswinner2_of_pair_0_6_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_6_value_#
    variable winnerswinner2_of_pair_0_8_choice : boolean;
    variable winnerswinner2_of_pair_0_8_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_8_choice_#
    variable winnerswinner2_of_pair_0_8_value : boolean;
    variable winnerswinner2_of_pair_0_8_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_8_value_#
    variable winnerswinner2_of_pair_0_10_choice : boolean;
    variable winnerswinner2_of_pair_0_10_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_10_choice_#
    variable winnerswinner2_of_pair_0_10_value : boolean;
    variable winnerswinner2_of_pair_0_10_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_10_value_#
    variable winnerswinner2_of_pair_0_12_choice : boolean;
    variable winnerswinner2_of_pair_0_12_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_12_choice_#
    variable winnerswinner2_of_pair_0_12_value : boolean;
    variable winnerswinner2_of_pair_0_12_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_12_value_#
    variable winnerswinner2_of_pair_0_14_choice : boolean;
    variable winnerswinner2_of_pair_0_14_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_14_choice_#
    variable winnerswinner2_of_pair_0_14_value : boolean;
    variable winnerswinner2_of_pair_0_14_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_14_value_#
    variable winnerswinner2_of_pair_0_16_choice : boolean;
    variable winnerswinner2_of_pair_0_16_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_16_choice_#
    variable winnerswinner2_of_pair_0_16_value : boolean;
    variable winnerswinner2_of_pair_0_16_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_16_value_#
    variable winnerswinner2_of_pair_0_18_choice : boolean;
    variable winnerswinner2_of_pair_0_18_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_18_choice_#
    variable winnerswinner2_of_pair_0_18_value : boolean;
    variable winnerswinner2_of_pair_0_18_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_18_value_#
    variable winnerswinner2_of_pair_0_20_choice : boolean;
    variable winnerswinner2_of_pair_0_20_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_20_choice_#
    variable winnerswinner2_of_pair_0_20_value : boolean;
    variable winnerswinner2_of_pair_0_20_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_20_value_#
    variable winnerswinner2_of_pair_0_22_choice : boolean;
    variable winnerswinner2_of_pair_0_22_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_22_choice_#
    variable winnerswinner2_of_pair_0_22_value : boolean;
    variable winnerswinner2_of_pair_0_22_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_22_value_#
    variable winnerswinner2_of_pair_0_24_choice : boolean;
    variable winnerswinner2_of_pair_0_24_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_24_choice_#
    variable winnerswinner2_of_pair_0_24_value : boolean;
    variable winnerswinner2_of_pair_0_24_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_24_value_#
    variable winnerswinner2_of_pair_0_26_choice : boolean;
    variable winnerswinner2_of_pair_0_26_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_26_choice_#
    variable winnerswinner2_of_pair_0_26_value : boolean;
    variable winnerswinner2_of_pair_0_26_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_26_value_#
    variable winnerswinner2_of_pair_0_28_choice : boolean;
    variable winnerswinner2_of_pair_0_28_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_28_choice_#
    variable winnerswinner2_of_pair_0_28_value : boolean;
    variable winnerswinner2_of_pair_0_28_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_28_value_#
    variable winnerswinner2_of_pair_0_30_choice : boolean;
    variable winnerswinner2_of_pair_0_30_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_pair_0_30_choice_#
    variable winnerswinner2_of_pair_0_30_value : boolean;
    variable winnerswinner2_of_pair_0_30_values : boolean_1d(2 to 4);  -- winnerswinner2_of_pair_0_30_value_#
    variable winnerswinner2_of_four_0_0_choice, winnerswinner2_of_four_0_0_value : boolean;
    variable winnerswinner2_of_four_0_0_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_0_value_#
    variable winnerswinner2_of_four_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_0_choice_#
    variable winnerswinner2_of_four_0_4_choice, winnerswinner2_of_four_0_4_value : boolean;
    variable winnerswinner2_of_four_0_4_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_4_value_#
    variable winnerswinner2_of_four_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_4_choice_#
    variable winnerswinner2_of_four_0_8_choice, winnerswinner2_of_four_0_8_value : boolean;
    variable winnerswinner2_of_four_0_8_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_8_value_#
    variable winnerswinner2_of_four_0_8_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_8_choice_#
    variable winnerswinner2_of_four_0_12_choice, winnerswinner2_of_four_0_12_value : boolean;
    variable winnerswinner2_of_four_0_12_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_12_value_#
    variable winnerswinner2_of_four_0_12_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_12_choice_#
    variable winnerswinner2_of_four_0_16_choice, winnerswinner2_of_four_0_16_value : boolean;
    variable winnerswinner2_of_four_0_16_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_16_value_#
    variable winnerswinner2_of_four_0_16_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_16_choice_#
    variable winnerswinner2_of_four_0_20_choice, winnerswinner2_of_four_0_20_value : boolean;
    variable winnerswinner2_of_four_0_20_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_20_value_#
    variable winnerswinner2_of_four_0_20_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_20_choice_#
    variable winnerswinner2_of_four_0_24_choice, winnerswinner2_of_four_0_24_value : boolean;
    variable winnerswinner2_of_four_0_24_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_24_value_#
    variable winnerswinner2_of_four_0_24_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_24_choice_#
    variable winnerswinner2_of_four_0_28_choice, winnerswinner2_of_four_0_28_value : boolean;
    variable winnerswinner2_of_four_0_28_values : boolean_1d(2 to 10);  -- winnerswinner2_of_four_0_28_value_#
    variable winnerswinner2_of_four_0_28_choices : boolean_1d(2 to 7);  -- winnerswinner2_of_four_0_28_choice_#
    variable winnerswinner3_of_pair_0_0_choice : boolean;
    variable winnerswinner3_of_pair_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_pair_0_0_choice_#
    variable winnerswinner3_of_pair_0_0_value : boolean;
    variable winnerswinner3_of_pair_0_0_values : boolean_1d(2 to 4);  -- winnerswinner3_of_pair_0_0_value_#
    variable winnerswinner3_of_pair_0_2_choice : boolean;
    variable winnerswinner3_of_pair_0_2_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_pair_0_2_choice_#
    variable winnerswinner3_of_pair_0_2_value : boolean;
    variable winnerswinner3_of_pair_0_2_values : boolean_1d(2 to 4);  -- winnerswinner3_of_pair_0_2_value_#
    variable winnerswinner3_of_pair_0_4_choice : boolean;
    variable winnerswinner3_of_pair_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_pair_0_4_choice_#
    variable winnerswinner3_of_pair_0_4_value : boolean;
    variable winnerswinner3_of_pair_0_4_values : boolean_1d(2 to 4);  -- winnerswinner3_of_pair_0_4_value_#
    variable winnerswinner3_of_pair_0_6_choice : boolean;
    variable winnerswinner3_of_pair_0_6_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_pair_0_6_choice_#
    variable winnerswinner3_of_pair_0_6_value : boolean;
    variable winnerswinner3_of_pair_0_6_values : boolean_1d(2 to 4);  -- winnerswinner3_of_pair_0_6_value_#
    variable winnerswinner3_of_four_0_0_choice, winnerswinner3_of_four_0_0_value : boolean;
    variable winnerswinner3_of_four_0_0_values : boolean_1d(2 to 10);  -- winnerswinner3_of_four_0_0_value_#
    variable winnerswinner3_of_four_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_four_0_0_choice_#
    variable winnerswinner3_of_four_0_4_choice, winnerswinner3_of_four_0_4_value : boolean;
    variable winnerswinner3_of_four_0_4_values : boolean_1d(2 to 10);  -- winnerswinner3_of_four_0_4_value_#
    variable winnerswinner3_of_four_0_4_choices : boolean_1d(2 to 7);  -- winnerswinner3_of_four_0_4_choice_#
    variable winnerswinner4_best_index_0_0_choice : boolean;
    variable winnerswinner4_best_index_0_0_choices : boolean_1d(2 to 7);  -- winnerswinner4_best_index_0_0_choice_#
    variable winnerswinner4_best_index_0_0_value : boolean;
    variable winnerswinner4_best_index_0_0_values : boolean_1d(2 to 4);  -- winnerswinner4_best_index_0_0_value_#
    variable turn_order_address_any, turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_differs, turn_ready_tag_row_start_is_equal : boolean;
    variable turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equal_2, turn_ready_tag_row_start_all : boolean;
    variable turn_ready_tag_row_start_all_2, map_counter_group_is_equal, map_line_ended_choice : boolean;
    variable map_at_arrives_value, map_of_column_0_b_below_a_value, map_of_column_0_b_below_a_choice : boolean;
    variable map_of_column_0_b_below_a_values : boolean_1d(2 to 10);  -- map_of_column_0_b_below_a_value_#
    variable map_of_column_0_b_below_a_choices : boolean_1d(2 to 8);  -- map_of_column_0_b_below_a_choice_#
    variable map_of_column_0_c_below_a_value, map_of_column_0_c_below_a_choice : boolean;
    variable map_of_column_0_c_below_a_values : boolean_1d(2 to 6);  -- map_of_column_0_c_below_a_value_#
    variable map_of_column_0_c_below_a_choices : boolean_1d(2 to 17);  -- map_of_column_0_c_below_a_choice_#
    variable map_of_column_0_c_below_b_choice : boolean;
    variable map_of_column_0_c_below_b_choices : boolean_1d(2 to 5);  -- map_of_column_0_c_below_b_choice_#
    variable map_window_complete_is_equal, map_window_complete_choice, map_of_low_0_b_below_a_value : boolean;
    variable map_of_low_0_b_below_a_choice, map_of_low_0_b_below_a_is_equal : boolean;
    variable map_of_low_0_b_below_a_choices : boolean_1d(2 to 6);  -- map_of_low_0_b_below_a_choice_#
    variable map_of_low_0_b_below_a_values : boolean_1d(2 to 9);  -- map_of_low_0_b_below_a_value_#
    variable map_of_low_0_c_below_a_value, map_of_low_0_c_below_a_choice : boolean;
    variable map_of_low_0_c_below_a_choices : boolean_1d(2 to 6);  -- map_of_low_0_c_below_a_choice_#
    variable map_of_low_0_c_below_b_choice : boolean;
    variable map_of_low_0_c_below_b_choices : boolean_1d(2 to 6);  -- map_of_low_0_c_below_b_choice_#
    variable map_of_middle_0_b_below_a_value, map_of_middle_0_b_below_a_choice : boolean;
    variable map_of_middle_0_b_below_a_is_equal : boolean;
    variable map_of_middle_0_b_below_a_choices : boolean_1d(2 to 6);  -- map_of_middle_0_b_below_a_choice_#
    variable map_of_middle_0_b_below_a_values : boolean_1d(2 to 9);  -- map_of_middle_0_b_below_a_value_#
    variable map_of_middle_0_c_below_a_value, map_of_middle_0_c_below_a_choice : boolean;
    variable map_of_middle_0_c_below_a_choices : boolean_1d(2 to 6);  -- map_of_middle_0_c_below_a_choice_#
    variable map_of_middle_0_c_below_b_choice : boolean;
    variable map_of_middle_0_c_below_b_choices : boolean_1d(2 to 6);  -- map_of_middle_0_c_below_b_choice_#
    variable map_of_high_0_b_below_a_value, map_of_high_0_b_below_a_choice, map_of_high_0_b_below_a_is_equal : boolean;
    variable map_of_high_0_b_below_a_choices : boolean_1d(2 to 6);  -- map_of_high_0_b_below_a_choice_#
    variable map_of_high_0_b_below_a_values : boolean_1d(2 to 9);  -- map_of_high_0_b_below_a_value_#
    variable map_of_high_0_c_below_a_value, map_of_high_0_c_below_a_choice : boolean;
    variable map_of_high_0_c_below_a_choices : boolean_1d(2 to 6);  -- map_of_high_0_c_below_a_choice_#
    variable map_of_high_0_c_below_b_choice : boolean;
    variable map_of_high_0_c_below_b_choices : boolean_1d(2 to 6);  -- map_of_high_0_c_below_b_choice_#
    variable map_of_all_0_b_below_a_value, map_of_all_0_b_below_a_choice, map_of_all_0_b_below_a_is_equal : boolean;
    variable map_of_all_0_b_below_a_choices : boolean_1d(2 to 6);  -- map_of_all_0_b_below_a_choice_#
    variable map_of_all_0_b_below_a_values : boolean_1d(2 to 9);  -- map_of_all_0_b_below_a_value_#
    variable map_of_all_0_c_below_a_value, map_of_all_0_c_below_a_choice : boolean;
    variable map_of_all_0_c_below_a_choices : boolean_1d(2 to 6);  -- map_of_all_0_c_below_a_choice_#
    variable map_of_all_0_c_below_b_choice : boolean;
    variable map_of_all_0_c_below_b_choices : boolean_1d(2 to 6);  -- map_of_all_0_c_below_b_choice_#
    variable map_low_0_all : boolean_1d(0 to 1);  -- map_low_#_0_all
    variable transform_counter_group_choice, map_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- transform_counter_group_choice_#
    variable map_counter_group_choices : natural_511_1d(2 to 3);  -- map_counter_group_choice_#
    variable transform_left_filter_feature_0_choice_354 : natural range 0 to 31;
    variable transform_right_filter_feature_0_choice_354, forward_left_room_choice : natural range 0 to 31;
    variable forward_left_room_choice_2 : natural range 0 to 31;
    variable forward_above_total_choice : natural_31_1d(0 to 127);  -- forward_above_total_#_choice
    variable sums_right_room_choice, sums_right_room_choice_2 : natural range 0 to 31;
    variable transform_left_filter_feature_0_choice_355 : natural range 0 to 1023;
    variable transform_right_filter_feature_0_choice_355 : natural range 0 to 1023;
    variable transform_left_filter_feature_0_choice_356 : natural range 0 to 32767;
    variable transform_right_filter_feature_0_choice_356 : natural range 0 to 32767;
    variable transform_left_filter_feature_0_choice_357 : natural range 0 to 1048575;
    variable transform_right_filter_feature_0_choice_357 : natural range 0 to 1048575;
    variable transform_left_filter_feature_0_choice_358 : natural range 0 to 8388607;
    variable transform_right_filter_feature_0_choice_358 : natural range 0 to 8388607;
    variable transform_left_filter_feature_0_choice_359 : natural range 0 to 536870911;
    variable transform_right_filter_feature_0_choice_359 : natural range 0 to 536870911;
    variable transform_left_filter_feature_0_choice_360 : unsigned(33 downto 0);
    variable transform_right_filter_feature_0_choice_360 : unsigned(33 downto 0);
    variable transform_left_filter_feature_0_choice_361 : unsigned(38 downto 0);
    variable transform_right_filter_feature_0_choice_361 : unsigned(38 downto 0);
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 1023;
    variable forward_left_pair_choice : natural_63_1d(0 to 63);  -- forward_left_pair_#_choice
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value : natural range 0 to 63;
    variable forward_left_cost_choice : natural_63_1d(0 to 127);  -- forward_left_cost_#_choice
    variable forward_left_cost_choice_2 : natural_63_1d(0 to 127);  -- forward_left_cost_#_choice_2
    variable forward_left_arrived_choice : natural_63_1d(0 to 127);  -- forward_left_arrived_#_choice
    variable forward_left_arrived_choice_2 : natural_63_1d(3 to 4);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s : natural_63_1d(7 to 8);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_11 : natural_63_1d(11 to 12);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_15 : natural_63_1d(15 to 16);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_19 : natural_63_1d(19 to 20);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_23 : natural_63_1d(23 to 24);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_27 : natural_63_1d(27 to 28);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_31 : natural_63_1d(31 to 32);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_35 : natural_63_1d(35 to 36);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_39 : natural_63_1d(39 to 40);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_43 : natural_63_1d(43 to 44);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_47 : natural_63_1d(47 to 48);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_51 : natural_63_1d(51 to 52);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_55 : natural_63_1d(55 to 56);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_59 : natural_63_1d(59 to 60);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_63 : natural_63_1d(63 to 64);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_67 : natural_63_1d(67 to 68);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_71 : natural_63_1d(71 to 72);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_75 : natural_63_1d(75 to 76);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_79 : natural_63_1d(79 to 80);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_83 : natural_63_1d(83 to 84);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_87 : natural_63_1d(87 to 88);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_91 : natural_63_1d(91 to 92);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_95 : natural_63_1d(95 to 96);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_99 : natural_63_1d(99 to 100);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_103 : natural_63_1d(103 to 104);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_107 : natural_63_1d(107 to 108);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_111 : natural_63_1d(111 to 112);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_115 : natural_63_1d(115 to 116);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_119 : natural_63_1d(119 to 120);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_123 : natural_63_1d(123 to 124);  -- forward_left_arrived_#_choice_2
    variable sums_right_pair_choice : natural_63_1d(0 to 63);  -- sums_right_pair_#_choice
    variable sums_right_g_copy_0_value, sums_right_g_less_copy_0_value : natural range 0 to 63;
    variable sums_right_cost_choice : natural_63_1d(0 to 127);  -- sums_right_cost_#_choice
    variable sums_right_cost_choice_2 : natural_63_1d(0 to 127);  -- sums_right_cost_#_choice_2
    variable sums_right_arrived_choice : natural_63_1d(0 to 127);  -- sums_right_arrived_#_choice
    variable sums_right_arrived_choice_2 : natural_63_1d(3 to 4);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s : natural_63_1d(7 to 8);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_11 : natural_63_1d(11 to 12);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_15 : natural_63_1d(15 to 16);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_19 : natural_63_1d(19 to 20);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_23 : natural_63_1d(23 to 24);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_27 : natural_63_1d(27 to 28);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_31 : natural_63_1d(31 to 32);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_35 : natural_63_1d(35 to 36);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_39 : natural_63_1d(39 to 40);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_43 : natural_63_1d(43 to 44);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_47 : natural_63_1d(47 to 48);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_51 : natural_63_1d(51 to 52);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_55 : natural_63_1d(55 to 56);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_59 : natural_63_1d(59 to 60);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_63 : natural_63_1d(63 to 64);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_67 : natural_63_1d(67 to 68);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_71 : natural_63_1d(71 to 72);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_75 : natural_63_1d(75 to 76);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_79 : natural_63_1d(79 to 80);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_83 : natural_63_1d(83 to 84);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_87 : natural_63_1d(87 to 88);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_91 : natural_63_1d(91 to 92);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_95 : natural_63_1d(95 to 96);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_99 : natural_63_1d(99 to 100);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_103 : natural_63_1d(103 to 104);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_107 : natural_63_1d(107 to 108);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_111 : natural_63_1d(111 to 112);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_115 : natural_63_1d(115 to 116);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_119 : natural_63_1d(119 to 120);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_123 : natural_63_1d(123 to 124);  -- sums_right_arrived_#_choice_2
    variable forward_left_start_cost_0_choice, forward_left_start_cost_0_choice_2 : natural range 0 to 255;
    variable sums_right_start_cost_0_choice, sums_right_start_cost_0_choice_2 : natural range 0 to 255;
    variable forward_above_write_words_choice : natural_67_1d(0 to 21);  -- forward_above_write_words_#_choice
    variable forward_above_write_words_choices : natural_67_2d(0 to 20, 2 to 6);  -- forward_above_write_words_#_choice_#
    variable forward_above_write_words_21_choice_2 : natural range 0 to 67;
    variable map_sorted_low_0_choice, map_sorted_low_0_choice_2, map_sorted_middle_0_choice : natural range 0 to 127;
    variable map_sorted_middle_0_choice_2, map_sorted_high_0_choice : natural range 0 to 127;
    variable map_sorted_high_0_choice_2, map_largest_low_0_choice, map_largest_low_0_choice_2 : natural range 0 to 127;
    variable map_median_middle_0_choice : natural range 0 to 127;
    variable map_median_middle_0_choices : natural_127_1d(2 to 4);  -- map_median_middle_0_choice_#
    variable map_smallest_high_0_choice, map_smallest_high_0_choice_2 : natural range 0 to 127;
    variable map_out_disparity_0_choice : natural range 0 to 127;
    variable map_out_disparity_0_choices : natural_127_1d(2 to 4);  -- map_out_disparity_0_choice_#
    variable map_low_0_0_choice, map_middle_0_0_choice, map_high_0_0_choice : natural range 0 to 127;
    variable other_4_choice, other_6_choice, other_8_choice, other_10_choice, other_12_choice : natural range 0 to 11;
    variable other_14_choice, other_16_choice, other_18_choice, other_20_choice : natural range 0 to 11;
    variable other_22_choice, other_24_choice, other_26_choice, other_28_choice : natural range 0 to 11;
    variable other_30_choice, other_32_choice, other_34_choice, other_36_choice : natural range 0 to 11;
    variable other_38_choice, other_40_choice, other_42_choice, other_44_choice : natural range 0 to 11;
    variable other_46_choice, other_48_choice, other_50_choice, other_52_choice : natural range 0 to 11;
    variable other_54_choice, other_56_choice, other_58_choice, other_60_choice : natural range 0 to 11;
    variable other_62_choice, other_64_choice, other_66_choice, other_68_choice : natural range 0 to 11;
    variable other_70_choice, other_72_choice, other_74_choice, other_76_choice : natural range 0 to 11;
    variable other_78_choice, other_80_choice, other_82_choice, other_84_choice : natural range 0 to 11;
    variable other_86_choice, other_88_choice, other_90_choice, other_92_choice : natural range 0 to 11;
    variable other_94_choice, other_96_choice, other_98_choice, other_100_choice : natural range 0 to 11;
    variable other_102_choice, other_104_choice, other_106_choice, other_108_choice : natural range 0 to 11;
    variable other_110_choice, other_112_choice, other_114_choice, other_116_choice : natural range 0 to 11;
    variable other_118_choice, other_120_choice, other_122_choice, other_124_choice : natural range 0 to 11;
    variable other_126_choice, other_128_choice, other_130_choice, other_132_choice : natural range 0 to 11;
    variable other_134_choice, other_136_choice, other_138_choice, other_140_choice : natural range 0 to 11;
    variable other_142_choice, other_144_choice, other_146_choice, other_148_choice : natural range 0 to 11;
    variable other_150_choice, other_152_choice, other_154_choice, other_156_choice : natural range 0 to 11;
    variable other_158_choice, other_160_choice, other_162_choice, other_164_choice : natural range 0 to 11;
    variable other_166_choice, other_168_choice, other_170_choice, other_172_choice : natural range 0 to 11;
    variable other_174_choice, other_176_choice, other_178_choice, other_180_choice : natural range 0 to 11;
    variable other_182_choice, other_184_choice, other_186_choice, other_188_choice : natural range 0 to 11;
    variable other_190_choice, other_192_choice, other_194_choice, other_196_choice : natural range 0 to 11;
    variable other_198_choice, other_200_choice, other_202_choice, other_204_choice : natural range 0 to 11;
    variable other_206_choice, other_208_choice, other_210_choice, other_212_choice : natural range 0 to 11;
    variable other_214_choice, other_216_choice, other_218_choice, other_220_choice : natural range 0 to 11;
    variable other_222_choice, other_224_choice, other_226_choice, other_228_choice : natural range 0 to 11;
    variable other_230_choice, other_232_choice, other_234_choice, other_236_choice : natural range 0 to 11;
    variable other_238_choice, other_240_choice, other_242_choice, other_244_choice : natural range 0 to 11;
    variable other_246_choice, other_248_choice, other_250_choice, other_252_choice : natural range 0 to 11;
    variable other_254_choice, other_256_choice, other_258_choice : natural range 0 to 11;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_group = 479;
      transform_counter_group_is_equal_2 := transform_counter_column = 639;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 15;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 482;
      if (transform_counter_group = 481) and transform_counter_next_frame then
        transform_counter_group_choices(2) := 2;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 481) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choices(2) := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choices(2) := transform_counter_next_frame;
      end if;
      if transform_counter_group_all then
        transform_counter_next_frame_choices(3) := in_valid;
      else
        transform_counter_next_frame_choices(3) := in_valid and (not in_start_of_frame);
      end if;
      if transform_counter_next_frame_choices(2) then
        transform_counter_next_frame_choices(4) := transform_counter_next_frame_choices(3);
      else
        transform_counter_next_frame_choices(4) := transform_counter_group_is_equal and
          transform_counter_group_is_equal_2 and in_valid and in_start_of_frame;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column(4, 2), 1);
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        is_set(transform_left_filter_column(4, 2), 0));
      if is_set(transform_left_filter_column(8, 0), 0) then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_left_filter_column(8, 0), 1) then
        transform_left_filter_feature_0_choices(2) := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choices(2) := is_set(transform_left_filter_column(8, 0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_values(2) := is_set(transform_left_filter_column(4, 2), 2);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(8, 0), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column(8, 0), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(4, 2), i);
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(8, 0), i)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(8, 0), i)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if transform_left_filter_feature_0_choices(8 * i + 7) then
          transform_left_filter_feature_0_choices(8 * i + 8) := is_set(transform_left_filter_column(8, i), 7) and (not
            is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 8) := is_set(transform_left_filter_column(8, i), 7) or (not
            is_set(transform_left_filter_column(4, 2), 7));
        end if;
        if is_set(transform_left_filter_column(8, i + 1), 0) then
          transform_left_filter_feature_0_choices(8 * i + 9) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 9) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(8, i + 1), 1) then
          transform_left_filter_feature_0_choices(8 * i + 10) := transform_left_filter_feature_0_choices(8 * i + 9);
        else
          transform_left_filter_feature_0_choices(8 * i + 10) := is_set(transform_left_filter_column(8, i + 1), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 10) then
          transform_left_filter_feature_0_choices(8 * i + 11) := (not is_set(transform_left_filter_column(8, i + 1),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 11) := (not is_set(transform_left_filter_column(8, i + 1),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 8) then
            transform_left_filter_feature_0_choices(8 * i + j + 9) := (not is_set(transform_left_filter_column(8, i +
              1), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 9) := (not is_set(transform_left_filter_column(8, i +
              1), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 1 loop
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 39) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 40) := is_set(transform_left_filter_column(8 - i -
              j, 4 - 4 * j), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 40) := is_set(transform_left_filter_column(8 - i -
              j, 4 - 4 * j), 7) or (not is_set(transform_left_filter_column(4, 2), 7));
          end if;
          if is_set(transform_left_filter_column(7 - i, j), 0) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 41) := transform_left_filter_feature_0_any;
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 41) := not transform_left_filter_feature_0_value;
          end if;
          if is_set(transform_left_filter_column(7 - i, j), 1) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 42) := transform_left_filter_feature_0_choices(40
              * i + 8 * j + 41);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 42) := is_set(transform_left_filter_column(7 - i,
              j), 0) and transform_left_filter_feature_0_is_equal;
          end if;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 42) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 43) := (not is_set(transform_left_filter_column(7
              - i, j), 2)) and transform_left_filter_feature_0_values(2);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 43) := (not is_set(transform_left_filter_column(7
              - i, j), 2)) or transform_left_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 40) then
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 41) := (not
                is_set(transform_left_filter_column(7 - i, j), k)) or transform_left_filter_feature_0_values(k);
            else
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 41) := (not
                is_set(transform_left_filter_column(7 - i, j), k)) and transform_left_filter_feature_0_values(k);
            end if;
          end loop;
        end loop;
        for j in 1 to 3 loop
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 47) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 48) := is_set(transform_left_filter_column(7 - i,
              j), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 48) := is_set(transform_left_filter_column(7 - i,
              j), 7) or (not is_set(transform_left_filter_column(4, 2), 7));
          end if;
          if is_set(transform_left_filter_column(7 - i, j + 1), 0) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 49) := transform_left_filter_feature_0_any;
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 49) := not transform_left_filter_feature_0_value;
          end if;
          if is_set(transform_left_filter_column(7 - i, j + 1), 1) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 50) := transform_left_filter_feature_0_choices(40
              * i + 8 * j + 49);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 50) := is_set(transform_left_filter_column(7 - i,
              j + 1), 0) and transform_left_filter_feature_0_is_equal;
          end if;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 50) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 51) := (not is_set(transform_left_filter_column(7
              - i, j + 1), 2)) and transform_left_filter_feature_0_values(2);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 51) := (not is_set(transform_left_filter_column(7
              - i, j + 1), 2)) or transform_left_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 48) then
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 49) := (not
                is_set(transform_left_filter_column(7 - i, j + 1), k)) or transform_left_filter_feature_0_values(k);
            else
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 49) := (not
                is_set(transform_left_filter_column(7 - i, j + 1), k)) and transform_left_filter_feature_0_values(k);
            end if;
          end loop;
        end loop;
      end loop;
      if transform_left_filter_feature_0_choices(159) then
        transform_left_filter_feature_0_choices(160) := is_set(transform_left_filter_column(5, 4), 7) and (not
          is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(160) := is_set(transform_left_filter_column(5, 4), 7) or (not
          is_set(transform_left_filter_column(4, 2), 7));
      end if;
      if is_set(transform_left_filter_column(4, 4), 0) then
        transform_left_filter_feature_0_choices(161) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(161) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column(4, 4), 1) then
        transform_left_filter_feature_0_choices(162) := transform_left_filter_feature_0_choices(161);
      else
        transform_left_filter_feature_0_choices(162) := is_set(transform_left_filter_column(4, 4), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(162) then
        transform_left_filter_feature_0_choices(163) := (not is_set(transform_left_filter_column(4, 4), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(163) := (not is_set(transform_left_filter_column(4, 4), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 163 to 166 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(4, 4), i - 160))
            or transform_left_filter_feature_0_values(i - 160);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column(4, 4), i - 160))
            and transform_left_filter_feature_0_values(i - 160);
        end if;
      end loop;
      if is_set(transform_left_filter_column(4, 4), 7) then
        transform_left_filter_feature_0_choices(168) := transform_filtering_0_column_inside(4);
      else
        transform_left_filter_feature_0_choices(168) := transform_filtering_0_column_inside(4) and (not
          is_set(transform_left_filter_column(4, 2), 7));
      end if;
      if transform_left_filter_feature_0_choices(167) then
        transform_left_filter_feature_0_choices(169) := is_set(transform_left_filter_column(4, 4), 7) and
          transform_filtering_0_column_inside(4) and (not is_set(transform_left_filter_column(4, 2), 7));
      else
        transform_left_filter_feature_0_choices(169) := transform_left_filter_feature_0_choices(168);
      end if;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(4, 2 * i + 1), 0) then
          transform_left_filter_feature_0_choices(8 * i + 170) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 170) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(4, 2 * i + 1), 1) then
          transform_left_filter_feature_0_choices(8 * i + 171) := transform_left_filter_feature_0_choices(8 * i + 170);
        else
          transform_left_filter_feature_0_choices(8 * i + 171) := is_set(transform_left_filter_column(4, 2 * i + 1), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 171) then
          transform_left_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_left_filter_column(4, 2 * i +
            1), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_left_filter_column(4, 2 * i +
            1), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 169) then
            transform_left_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_left_filter_column(4, 2 *
              i + 1), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_left_filter_column(4, 2 *
              i + 1), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 176) then
          transform_left_filter_feature_0_choices(8 * i + 177) := is_set(transform_left_filter_column(4, 2 * i + 1), 7)
            and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 177) := is_set(transform_left_filter_column(4, 2 * i + 1), 7)
            or (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(4 - i, 3 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 186) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 186) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(4 - i, 3 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 187) := transform_left_filter_feature_0_choices(8 * i + 186);
        else
          transform_left_filter_feature_0_choices(8 * i + 187) := is_set(transform_left_filter_column(4 - i, 3 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 187) then
          transform_left_filter_feature_0_choices(8 * i + 188) := (not is_set(transform_left_filter_column(4 - i, 3 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 188) := (not is_set(transform_left_filter_column(4 - i, 3 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 185) then
            transform_left_filter_feature_0_choices(8 * i + j + 186) := (not is_set(transform_left_filter_column(4 - i,
              3 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 186) := (not is_set(transform_left_filter_column(4 - i,
              3 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 192) then
          transform_left_filter_feature_0_choices(8 * i + 193) := is_set(transform_left_filter_column(4 - i, 3 * i), 7)
            and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 193) := is_set(transform_left_filter_column(4 - i, 3 * i), 7)
            or (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(3, 4 - 2 * i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 202) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 202) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(3, 4 - 2 * i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 203) := transform_left_filter_feature_0_choices(8 * i + 202);
        else
          transform_left_filter_feature_0_choices(8 * i + 203) := is_set(transform_left_filter_column(3, 4 - 2 * i), 0)
            and transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 203) then
          transform_left_filter_feature_0_choices(8 * i + 204) := (not is_set(transform_left_filter_column(3, 4 - 2 *
            i), 2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 204) := (not is_set(transform_left_filter_column(3, 4 - 2 *
            i), 2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 201) then
            transform_left_filter_feature_0_choices(8 * i + j + 202) := (not is_set(transform_left_filter_column(3, 4 -
              2 * i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 202) := (not is_set(transform_left_filter_column(3, 4 -
              2 * i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 208) then
          transform_left_filter_feature_0_choices(8 * i + 209) := is_set(transform_left_filter_column(3, 4 - 2 * i), 7)
            and (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 209) := is_set(transform_left_filter_column(3, 4 - 2 * i), 7)
            or (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(3, 1 - i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 218) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 218) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(3, 1 - i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 219) := transform_left_filter_feature_0_choices(8 * i + 218);
        else
          transform_left_filter_feature_0_choices(8 * i + 219) := is_set(transform_left_filter_column(3, 1 - i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 219) then
          transform_left_filter_feature_0_choices(8 * i + 220) := (not is_set(transform_left_filter_column(3, 1 - i),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 220) := (not is_set(transform_left_filter_column(3, 1 - i),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 217) then
            transform_left_filter_feature_0_choices(8 * i + j + 218) := (not is_set(transform_left_filter_column(3, 1 -
              i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 218) := (not is_set(transform_left_filter_column(3, 1 -
              i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 224) then
          transform_left_filter_feature_0_choices(8 * i + 225) := is_set(transform_left_filter_column(3, 1 - i), 7) and
            (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 225) := is_set(transform_left_filter_column(3, 1 - i), 7) or
            (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        for j in 3 to 4 loop
          if is_set(transform_left_filter_column(2 - i, j), 0) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 210) := transform_left_filter_feature_0_any;
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 210) := not transform_left_filter_feature_0_value;
          end if;
          if is_set(transform_left_filter_column(2 - i, j), 1) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 211) := transform_left_filter_feature_0_choices(40
              * i + 8 * j + 210);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 211) := is_set(transform_left_filter_column(2 - i,
              j), 0) and transform_left_filter_feature_0_is_equal;
          end if;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 211) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 212) := (not is_set(transform_left_filter_column(2
              - i, j), 2)) and transform_left_filter_feature_0_values(2);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 212) := (not is_set(transform_left_filter_column(2
              - i, j), 2)) or transform_left_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 209) then
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 210) := (not
                is_set(transform_left_filter_column(2 - i, j), k)) or transform_left_filter_feature_0_values(k);
            else
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 210) := (not
                is_set(transform_left_filter_column(2 - i, j), k)) and transform_left_filter_feature_0_values(k);
            end if;
          end loop;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 216) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 217) := is_set(transform_left_filter_column(2 - i,
              j), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 217) := is_set(transform_left_filter_column(2 - i,
              j), 7) or (not is_set(transform_left_filter_column(4, 2), 7));
          end if;
        end loop;
        for j in 0 to 2 loop
          if is_set(transform_left_filter_column(2 - i, 2 - j), 0) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 250) := transform_left_filter_feature_0_any;
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 250) := not transform_left_filter_feature_0_value;
          end if;
          if is_set(transform_left_filter_column(2 - i, 2 - j), 1) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 251) := transform_left_filter_feature_0_choices(40
              * i + 8 * j + 250);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 251) := is_set(transform_left_filter_column(2 - i,
              2 - j), 0) and transform_left_filter_feature_0_is_equal;
          end if;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 251) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 252) := (not is_set(transform_left_filter_column(2
              - i, 2 - j), 2)) and transform_left_filter_feature_0_values(2);
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 252) := (not is_set(transform_left_filter_column(2
              - i, 2 - j), 2)) or transform_left_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 249) then
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 250) := (not
                is_set(transform_left_filter_column(2 - i, 2 - j), k)) or transform_left_filter_feature_0_values(k);
            else
              transform_left_filter_feature_0_choices(40 * i + 8 * j + k + 250) := (not
                is_set(transform_left_filter_column(2 - i, 2 - j), k)) and transform_left_filter_feature_0_values(k);
            end if;
          end loop;
          if transform_left_filter_feature_0_choices(40 * i + 8 * j + 256) then
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 257) := is_set(transform_left_filter_column(2 - i,
              2 - j), 7) and (not is_set(transform_left_filter_column(4, 2), 7));
          else
            transform_left_filter_feature_0_choices(40 * i + 8 * j + 257) := is_set(transform_left_filter_column(2 - i,
              2 - j), 7) or (not is_set(transform_left_filter_column(4, 2), 7));
          end if;
        end loop;
      end loop;
      for i in 3 to 4 loop
        if is_set(transform_left_filter_column(0, i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 290) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 290) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(0, i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 291) := transform_left_filter_feature_0_choices(8 * i + 290);
        else
          transform_left_filter_feature_0_choices(8 * i + 291) := is_set(transform_left_filter_column(0, i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 291) then
          transform_left_filter_feature_0_choices(8 * i + 292) := (not is_set(transform_left_filter_column(0, i), 2))
            and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 292) := (not is_set(transform_left_filter_column(0, i), 2))
            or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 289) then
            transform_left_filter_feature_0_choices(8 * i + j + 290) := (not is_set(transform_left_filter_column(0, i),
              j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 290) := (not is_set(transform_left_filter_column(0, i),
              j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 296) then
          transform_left_filter_feature_0_choices(8 * i + 297) := is_set(transform_left_filter_column(0, i), 7) and
            (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 297) := is_set(transform_left_filter_column(0, i), 7) or (not
            is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_left_filter_column(0, 2 - i), 0) then
          transform_left_filter_feature_0_choices(8 * i + 330) := transform_left_filter_feature_0_any;
        else
          transform_left_filter_feature_0_choices(8 * i + 330) := not transform_left_filter_feature_0_value;
        end if;
        if is_set(transform_left_filter_column(0, 2 - i), 1) then
          transform_left_filter_feature_0_choices(8 * i + 331) := transform_left_filter_feature_0_choices(8 * i + 330);
        else
          transform_left_filter_feature_0_choices(8 * i + 331) := is_set(transform_left_filter_column(0, 2 - i), 0) and
            transform_left_filter_feature_0_is_equal;
        end if;
        if transform_left_filter_feature_0_choices(8 * i + 331) then
          transform_left_filter_feature_0_choices(8 * i + 332) := (not is_set(transform_left_filter_column(0, 2 - i),
            2)) and transform_left_filter_feature_0_values(2);
        else
          transform_left_filter_feature_0_choices(8 * i + 332) := (not is_set(transform_left_filter_column(0, 2 - i),
            2)) or transform_left_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_left_filter_feature_0_choices(8 * i + j + 329) then
            transform_left_filter_feature_0_choices(8 * i + j + 330) := (not is_set(transform_left_filter_column(0, 2 -
              i), j)) or transform_left_filter_feature_0_values(j);
          else
            transform_left_filter_feature_0_choices(8 * i + j + 330) := (not is_set(transform_left_filter_column(0, 2 -
              i), j)) and transform_left_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_left_filter_feature_0_choices(8 * i + 336) then
          transform_left_filter_feature_0_choices(8 * i + 337) := is_set(transform_left_filter_column(0, 2 - i), 7) and
            (not is_set(transform_left_filter_column(4, 2), 7));
        else
          transform_left_filter_feature_0_choices(8 * i + 337) := is_set(transform_left_filter_column(0, 2 - i), 7) or
            (not is_set(transform_left_filter_column(4, 2), 7));
        end if;
      end loop;
      if is_set(transform_left_filter_column(4, 2), 0) then
        transform_left_filter_feature_0_choices(346) := not is_set(transform_left_filter_column(0, 0), 1);
      else
        transform_left_filter_feature_0_choices(346) := (transform_left_filter_column(0, 0) mod 4) = 0;
      end if;
      if transform_left_filter_feature_0_value then
        transform_left_filter_feature_0_choices(347) := is_set(transform_left_filter_column(4, 2), 0) or (not
          is_set(transform_left_filter_column(0, 0), 1)) or (not is_set(transform_left_filter_column(0, 0), 0));
      else
        transform_left_filter_feature_0_choices(347) := transform_left_filter_feature_0_choices(346);
      end if;
      transform_left_filter_feature_0_values(7) := is_set(transform_left_filter_column(0, 0), 2);
      if transform_left_filter_feature_0_choices(347) then
        transform_left_filter_feature_0_choices(348) := (not transform_left_filter_feature_0_values(2)) and
          transform_left_filter_feature_0_values(7);
      else
        transform_left_filter_feature_0_choices(348) := (not transform_left_filter_feature_0_values(2)) or
          transform_left_filter_feature_0_values(7);
      end if;
      for i in 8 to 11 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
        if transform_left_filter_feature_0_choices(i + 340) then
          transform_left_filter_feature_0_choices(i + 341) := (not transform_left_filter_feature_0_values(i - 5)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 341) := (not transform_left_filter_feature_0_values(i - 5)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(352) then
        transform_left_filter_feature_0_choices(353) := (not is_set(transform_left_filter_column(4, 2), 7)) or
          is_set(transform_left_filter_column(0, 0), 7);
      else
        transform_left_filter_feature_0_choices(353) := (not is_set(transform_left_filter_column(4, 2), 7)) and
          is_set(transform_left_filter_column(0, 0), 7);
      end if;
      if transform_filtering_0_column_inside(0) then
        transform_left_filter_feature_0_choice_354 := (as_number(transform_left_filter_feature_0_choices(321)) * 8) +
          (as_number(transform_left_filter_feature_0_choices(329)) * 16) +
          (as_number(transform_left_filter_feature_0_choices(337)) * 4) +
          (as_number(transform_left_filter_feature_0_choices(345)) * 2) +
          as_number(transform_left_filter_feature_0_choices(353));
      else
        transform_left_filter_feature_0_choice_354 := 0;
      end if;
      if transform_filtering_0_column_inside(1) then
        transform_left_filter_feature_0_choice_355 := (as_number(transform_left_filter_feature_0_choices(281)) * 256) +
          (as_number(transform_left_filter_feature_0_choices(289)) * 512) +
          (as_number(transform_left_filter_feature_0_choices(297)) * 128) +
          (as_number(transform_left_filter_feature_0_choices(305)) * 64) +
          (as_number(transform_left_filter_feature_0_choices(313)) * 32) + transform_left_filter_feature_0_choice_354;
      else
        transform_left_filter_feature_0_choice_355 := transform_left_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside(2) then
        transform_left_filter_feature_0_choice_356 := (as_number(transform_left_filter_feature_0_choices(241)) * 8192)
          + (as_number(transform_left_filter_feature_0_choices(249)) * 16384) +
          (as_number(transform_left_filter_feature_0_choices(257)) * 4096) +
          (as_number(transform_left_filter_feature_0_choices(265)) * 2048) +
          (as_number(transform_left_filter_feature_0_choices(273)) * 1024) + transform_left_filter_feature_0_choice_355;
      else
        transform_left_filter_feature_0_choice_356 := transform_left_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside(3) then
        transform_left_filter_feature_0_choice_357 := (as_number(transform_left_filter_feature_0_choices(201)) *
          262144) + (as_number(transform_left_filter_feature_0_choices(209)) * 524288) +
          (as_number(transform_left_filter_feature_0_choices(217)) * 131072) +
          (as_number(transform_left_filter_feature_0_choices(225)) * 65536) +
          (as_number(transform_left_filter_feature_0_choices(233)) * 32768) +
          transform_left_filter_feature_0_choice_356;
      else
        transform_left_filter_feature_0_choice_357 := transform_left_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside(4) then
        transform_left_filter_feature_0_choice_358 := (as_number(transform_left_filter_feature_0_choices(177)) *
          2097152) + (as_number(transform_left_filter_feature_0_choices(185)) * 4194304) +
          (as_number(transform_left_filter_feature_0_choices(193)) * 1048576) +
          transform_left_filter_feature_0_choice_357;
      else
        transform_left_filter_feature_0_choice_358 := transform_left_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside(5) then
        transform_left_filter_feature_0_choice_359 := (as_number(transform_left_filter_feature_0_choices(128)) *
          16777216) + (as_number(transform_left_filter_feature_0_choices(136)) * 33554432) +
          (as_number(transform_left_filter_feature_0_choices(144)) * 67108864) +
          (as_number(transform_left_filter_feature_0_choices(152)) * 134217728) +
          (as_number(transform_left_filter_feature_0_choices(160)) * 268435456) +
          (as_number(transform_left_filter_feature_0_choices(169)) * 8388608) +
          transform_left_filter_feature_0_choice_358;
      else
        transform_left_filter_feature_0_choice_359 := (as_number(transform_left_filter_feature_0_choices(169)) *
          8388608) + transform_left_filter_feature_0_choice_358;
      end if;
      if transform_filtering_0_column_inside(6) then
        transform_left_filter_feature_0_choice_360 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choices(120)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(112)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(104)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(96)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(88)), 1) &
          to_unsigned(transform_left_filter_feature_0_choice_359, 29);
      else
        transform_left_filter_feature_0_choice_360 := to_unsigned(transform_left_filter_feature_0_choice_359, 34);
      end if;
      if transform_filtering_0_column_inside(7) then
        transform_left_filter_feature_0_choice_361 :=
          to_unsigned(as_number(transform_left_filter_feature_0_choices(80)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(72)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(64)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(56)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(48)), 1) &
          transform_left_filter_feature_0_choice_360(33 downto 0);
      else
        transform_left_filter_feature_0_choice_361 := resize(transform_left_filter_feature_0_choice_360, 39);
      end if;
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column(4, 2), 1);
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        is_set(transform_right_filter_column(4, 2), 0));
      if is_set(transform_right_filter_column(8, 0), 0) then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column(4, 2) mod 4) = 0;
      if is_set(transform_right_filter_column(8, 0), 1) then
        transform_right_filter_feature_0_choices(2) := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choices(2) := is_set(transform_right_filter_column(8, 0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_values(2) := is_set(transform_right_filter_column(4, 2), 2);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(8, 0), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column(8, 0), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(4, 2), i);
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(8, 0), i)) or
            transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(8, 0), i)) and
            transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      for i in 0 to 3 loop
        if transform_right_filter_feature_0_choices(8 * i + 7) then
          transform_right_filter_feature_0_choices(8 * i + 8) := is_set(transform_right_filter_column(8, i), 7) and
            (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 8) := is_set(transform_right_filter_column(8, i), 7) or (not
            is_set(transform_right_filter_column(4, 2), 7));
        end if;
        if is_set(transform_right_filter_column(8, i + 1), 0) then
          transform_right_filter_feature_0_choices(8 * i + 9) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 9) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(8, i + 1), 1) then
          transform_right_filter_feature_0_choices(8 * i + 10) := transform_right_filter_feature_0_choices(8 * i + 9);
        else
          transform_right_filter_feature_0_choices(8 * i + 10) := is_set(transform_right_filter_column(8, i + 1), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 10) then
          transform_right_filter_feature_0_choices(8 * i + 11) := (not is_set(transform_right_filter_column(8, i + 1),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 11) := (not is_set(transform_right_filter_column(8, i + 1),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 8) then
            transform_right_filter_feature_0_choices(8 * i + j + 9) := (not is_set(transform_right_filter_column(8, i +
              1), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 9) := (not is_set(transform_right_filter_column(8, i +
              1), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 1 loop
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 39) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 40) := is_set(transform_right_filter_column(8 - i
              - j, 4 - 4 * j), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 40) := is_set(transform_right_filter_column(8 - i
              - j, 4 - 4 * j), 7) or (not is_set(transform_right_filter_column(4, 2), 7));
          end if;
          if is_set(transform_right_filter_column(7 - i, j), 0) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 41) := transform_right_filter_feature_0_any;
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 41) := not transform_right_filter_feature_0_value;
          end if;
          if is_set(transform_right_filter_column(7 - i, j), 1) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 42) :=
              transform_right_filter_feature_0_choices(40 * i + 8 * j + 41);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 42) := is_set(transform_right_filter_column(7 -
              i, j), 0) and transform_right_filter_feature_0_is_equal;
          end if;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 42) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 43) := (not
              is_set(transform_right_filter_column(7 - i, j), 2)) and transform_right_filter_feature_0_values(2);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 43) := (not
              is_set(transform_right_filter_column(7 - i, j), 2)) or transform_right_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 40) then
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 41) := (not
                is_set(transform_right_filter_column(7 - i, j), k)) or transform_right_filter_feature_0_values(k);
            else
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 41) := (not
                is_set(transform_right_filter_column(7 - i, j), k)) and transform_right_filter_feature_0_values(k);
            end if;
          end loop;
        end loop;
        for j in 1 to 3 loop
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 47) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 48) := is_set(transform_right_filter_column(7 -
              i, j), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 48) := is_set(transform_right_filter_column(7 -
              i, j), 7) or (not is_set(transform_right_filter_column(4, 2), 7));
          end if;
          if is_set(transform_right_filter_column(7 - i, j + 1), 0) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 49) := transform_right_filter_feature_0_any;
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 49) := not transform_right_filter_feature_0_value;
          end if;
          if is_set(transform_right_filter_column(7 - i, j + 1), 1) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 50) :=
              transform_right_filter_feature_0_choices(40 * i + 8 * j + 49);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 50) := is_set(transform_right_filter_column(7 -
              i, j + 1), 0) and transform_right_filter_feature_0_is_equal;
          end if;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 50) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 51) := (not
              is_set(transform_right_filter_column(7 - i, j + 1), 2)) and transform_right_filter_feature_0_values(2);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 51) := (not
              is_set(transform_right_filter_column(7 - i, j + 1), 2)) or transform_right_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 48) then
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 49) := (not
                is_set(transform_right_filter_column(7 - i, j + 1), k)) or transform_right_filter_feature_0_values(k);
            else
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 49) := (not
                is_set(transform_right_filter_column(7 - i, j + 1), k)) and transform_right_filter_feature_0_values(k);
            end if;
          end loop;
        end loop;
      end loop;
      if transform_right_filter_feature_0_choices(159) then
        transform_right_filter_feature_0_choices(160) := is_set(transform_right_filter_column(5, 4), 7) and (not
          is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(160) := is_set(transform_right_filter_column(5, 4), 7) or (not
          is_set(transform_right_filter_column(4, 2), 7));
      end if;
      if is_set(transform_right_filter_column(4, 4), 0) then
        transform_right_filter_feature_0_choices(161) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(161) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column(4, 4), 1) then
        transform_right_filter_feature_0_choices(162) := transform_right_filter_feature_0_choices(161);
      else
        transform_right_filter_feature_0_choices(162) := is_set(transform_right_filter_column(4, 4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(162) then
        transform_right_filter_feature_0_choices(163) := (not is_set(transform_right_filter_column(4, 4), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(163) := (not is_set(transform_right_filter_column(4, 4), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 163 to 166 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(4, 4), i - 160))
            or transform_right_filter_feature_0_values(i - 160);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column(4, 4), i - 160))
            and transform_right_filter_feature_0_values(i - 160);
        end if;
      end loop;
      if is_set(transform_right_filter_column(4, 4), 7) then
        transform_right_filter_feature_0_choices(168) := transform_filtering_0_column_inside(4);
      else
        transform_right_filter_feature_0_choices(168) := transform_filtering_0_column_inside(4) and (not
          is_set(transform_right_filter_column(4, 2), 7));
      end if;
      if transform_right_filter_feature_0_choices(167) then
        transform_right_filter_feature_0_choices(169) := is_set(transform_right_filter_column(4, 4), 7) and
          transform_filtering_0_column_inside(4) and (not is_set(transform_right_filter_column(4, 2), 7));
      else
        transform_right_filter_feature_0_choices(169) := transform_right_filter_feature_0_choices(168);
      end if;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(4, 2 * i + 1), 0) then
          transform_right_filter_feature_0_choices(8 * i + 170) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 170) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(4, 2 * i + 1), 1) then
          transform_right_filter_feature_0_choices(8 * i + 171) := transform_right_filter_feature_0_choices(8 * i +
            170);
        else
          transform_right_filter_feature_0_choices(8 * i + 171) := is_set(transform_right_filter_column(4, 2 * i + 1),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 171) then
          transform_right_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_right_filter_column(4, 2 * i +
            1), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 172) := (not is_set(transform_right_filter_column(4, 2 * i +
            1), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 169) then
            transform_right_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_right_filter_column(4, 2
              * i + 1), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 170) := (not is_set(transform_right_filter_column(4, 2
              * i + 1), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 176) then
          transform_right_filter_feature_0_choices(8 * i + 177) := is_set(transform_right_filter_column(4, 2 * i + 1),
            7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 177) := is_set(transform_right_filter_column(4, 2 * i + 1),
            7) or (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(4 - i, 3 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 186) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 186) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(4 - i, 3 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 187) := transform_right_filter_feature_0_choices(8 * i +
            186);
        else
          transform_right_filter_feature_0_choices(8 * i + 187) := is_set(transform_right_filter_column(4 - i, 3 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 187) then
          transform_right_filter_feature_0_choices(8 * i + 188) := (not is_set(transform_right_filter_column(4 - i, 3 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 188) := (not is_set(transform_right_filter_column(4 - i, 3 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 185) then
            transform_right_filter_feature_0_choices(8 * i + j + 186) := (not is_set(transform_right_filter_column(4 -
              i, 3 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 186) := (not is_set(transform_right_filter_column(4 -
              i, 3 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 192) then
          transform_right_filter_feature_0_choices(8 * i + 193) := is_set(transform_right_filter_column(4 - i, 3 * i),
            7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 193) := is_set(transform_right_filter_column(4 - i, 3 * i),
            7) or (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(3, 4 - 2 * i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 202) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 202) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(3, 4 - 2 * i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 203) := transform_right_filter_feature_0_choices(8 * i +
            202);
        else
          transform_right_filter_feature_0_choices(8 * i + 203) := is_set(transform_right_filter_column(3, 4 - 2 * i),
            0) and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 203) then
          transform_right_filter_feature_0_choices(8 * i + 204) := (not is_set(transform_right_filter_column(3, 4 - 2 *
            i), 2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 204) := (not is_set(transform_right_filter_column(3, 4 - 2 *
            i), 2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 201) then
            transform_right_filter_feature_0_choices(8 * i + j + 202) := (not is_set(transform_right_filter_column(3, 4
              - 2 * i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 202) := (not is_set(transform_right_filter_column(3, 4
              - 2 * i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 208) then
          transform_right_filter_feature_0_choices(8 * i + 209) := is_set(transform_right_filter_column(3, 4 - 2 * i),
            7) and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 209) := is_set(transform_right_filter_column(3, 4 - 2 * i),
            7) or (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(3, 1 - i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 218) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 218) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(3, 1 - i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 219) := transform_right_filter_feature_0_choices(8 * i +
            218);
        else
          transform_right_filter_feature_0_choices(8 * i + 219) := is_set(transform_right_filter_column(3, 1 - i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 219) then
          transform_right_filter_feature_0_choices(8 * i + 220) := (not is_set(transform_right_filter_column(3, 1 - i),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 220) := (not is_set(transform_right_filter_column(3, 1 - i),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 217) then
            transform_right_filter_feature_0_choices(8 * i + j + 218) := (not is_set(transform_right_filter_column(3, 1
              - i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 218) := (not is_set(transform_right_filter_column(3, 1
              - i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 224) then
          transform_right_filter_feature_0_choices(8 * i + 225) := is_set(transform_right_filter_column(3, 1 - i), 7)
            and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 225) := is_set(transform_right_filter_column(3, 1 - i), 7)
            or (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        for j in 3 to 4 loop
          if is_set(transform_right_filter_column(2 - i, j), 0) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 210) := transform_right_filter_feature_0_any;
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 210) := not
              transform_right_filter_feature_0_value;
          end if;
          if is_set(transform_right_filter_column(2 - i, j), 1) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 211) :=
              transform_right_filter_feature_0_choices(40 * i + 8 * j + 210);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 211) := is_set(transform_right_filter_column(2 -
              i, j), 0) and transform_right_filter_feature_0_is_equal;
          end if;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 211) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 212) := (not
              is_set(transform_right_filter_column(2 - i, j), 2)) and transform_right_filter_feature_0_values(2);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 212) := (not
              is_set(transform_right_filter_column(2 - i, j), 2)) or transform_right_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 209) then
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 210) := (not
                is_set(transform_right_filter_column(2 - i, j), k)) or transform_right_filter_feature_0_values(k);
            else
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 210) := (not
                is_set(transform_right_filter_column(2 - i, j), k)) and transform_right_filter_feature_0_values(k);
            end if;
          end loop;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 216) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 217) := is_set(transform_right_filter_column(2 -
              i, j), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 217) := is_set(transform_right_filter_column(2 -
              i, j), 7) or (not is_set(transform_right_filter_column(4, 2), 7));
          end if;
        end loop;
        for j in 0 to 2 loop
          if is_set(transform_right_filter_column(2 - i, 2 - j), 0) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 250) := transform_right_filter_feature_0_any;
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 250) := not
              transform_right_filter_feature_0_value;
          end if;
          if is_set(transform_right_filter_column(2 - i, 2 - j), 1) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 251) :=
              transform_right_filter_feature_0_choices(40 * i + 8 * j + 250);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 251) := is_set(transform_right_filter_column(2 -
              i, 2 - j), 0) and transform_right_filter_feature_0_is_equal;
          end if;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 251) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 252) := (not
              is_set(transform_right_filter_column(2 - i, 2 - j), 2)) and transform_right_filter_feature_0_values(2);
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 252) := (not
              is_set(transform_right_filter_column(2 - i, 2 - j), 2)) or transform_right_filter_feature_0_values(2);
          end if;
          for k in 3 to 6 loop
            if transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 249) then
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 250) := (not
                is_set(transform_right_filter_column(2 - i, 2 - j), k)) or transform_right_filter_feature_0_values(k);
            else
              transform_right_filter_feature_0_choices(40 * i + 8 * j + k + 250) := (not
                is_set(transform_right_filter_column(2 - i, 2 - j), k)) and transform_right_filter_feature_0_values(k);
            end if;
          end loop;
          if transform_right_filter_feature_0_choices(40 * i + 8 * j + 256) then
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 257) := is_set(transform_right_filter_column(2 -
              i, 2 - j), 7) and (not is_set(transform_right_filter_column(4, 2), 7));
          else
            transform_right_filter_feature_0_choices(40 * i + 8 * j + 257) := is_set(transform_right_filter_column(2 -
              i, 2 - j), 7) or (not is_set(transform_right_filter_column(4, 2), 7));
          end if;
        end loop;
      end loop;
      for i in 3 to 4 loop
        if is_set(transform_right_filter_column(0, i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 290) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 290) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(0, i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 291) := transform_right_filter_feature_0_choices(8 * i +
            290);
        else
          transform_right_filter_feature_0_choices(8 * i + 291) := is_set(transform_right_filter_column(0, i), 0) and
            transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 291) then
          transform_right_filter_feature_0_choices(8 * i + 292) := (not is_set(transform_right_filter_column(0, i), 2))
            and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 292) := (not is_set(transform_right_filter_column(0, i), 2))
            or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 289) then
            transform_right_filter_feature_0_choices(8 * i + j + 290) := (not is_set(transform_right_filter_column(0,
              i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 290) := (not is_set(transform_right_filter_column(0,
              i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 296) then
          transform_right_filter_feature_0_choices(8 * i + 297) := is_set(transform_right_filter_column(0, i), 7) and
            (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 297) := is_set(transform_right_filter_column(0, i), 7) or
            (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      for i in 0 to 1 loop
        if is_set(transform_right_filter_column(0, 2 - i), 0) then
          transform_right_filter_feature_0_choices(8 * i + 330) := transform_right_filter_feature_0_any;
        else
          transform_right_filter_feature_0_choices(8 * i + 330) := not transform_right_filter_feature_0_value;
        end if;
        if is_set(transform_right_filter_column(0, 2 - i), 1) then
          transform_right_filter_feature_0_choices(8 * i + 331) := transform_right_filter_feature_0_choices(8 * i +
            330);
        else
          transform_right_filter_feature_0_choices(8 * i + 331) := is_set(transform_right_filter_column(0, 2 - i), 0)
            and transform_right_filter_feature_0_is_equal;
        end if;
        if transform_right_filter_feature_0_choices(8 * i + 331) then
          transform_right_filter_feature_0_choices(8 * i + 332) := (not is_set(transform_right_filter_column(0, 2 - i),
            2)) and transform_right_filter_feature_0_values(2);
        else
          transform_right_filter_feature_0_choices(8 * i + 332) := (not is_set(transform_right_filter_column(0, 2 - i),
            2)) or transform_right_filter_feature_0_values(2);
        end if;
        for j in 3 to 6 loop
          if transform_right_filter_feature_0_choices(8 * i + j + 329) then
            transform_right_filter_feature_0_choices(8 * i + j + 330) := (not is_set(transform_right_filter_column(0, 2
              - i), j)) or transform_right_filter_feature_0_values(j);
          else
            transform_right_filter_feature_0_choices(8 * i + j + 330) := (not is_set(transform_right_filter_column(0, 2
              - i), j)) and transform_right_filter_feature_0_values(j);
          end if;
        end loop;
        if transform_right_filter_feature_0_choices(8 * i + 336) then
          transform_right_filter_feature_0_choices(8 * i + 337) := is_set(transform_right_filter_column(0, 2 - i), 7)
            and (not is_set(transform_right_filter_column(4, 2), 7));
        else
          transform_right_filter_feature_0_choices(8 * i + 337) := is_set(transform_right_filter_column(0, 2 - i), 7)
            or (not is_set(transform_right_filter_column(4, 2), 7));
        end if;
      end loop;
      if is_set(transform_right_filter_column(4, 2), 0) then
        transform_right_filter_feature_0_choices(346) := not is_set(transform_right_filter_column(0, 0), 1);
      else
        transform_right_filter_feature_0_choices(346) := (transform_right_filter_column(0, 0) mod 4) = 0;
      end if;
      if transform_right_filter_feature_0_value then
        transform_right_filter_feature_0_choices(347) := is_set(transform_right_filter_column(4, 2), 0) or (not
          is_set(transform_right_filter_column(0, 0), 1)) or (not is_set(transform_right_filter_column(0, 0), 0));
      else
        transform_right_filter_feature_0_choices(347) := transform_right_filter_feature_0_choices(346);
      end if;
      transform_right_filter_feature_0_values(7) := is_set(transform_right_filter_column(0, 0), 2);
      if transform_right_filter_feature_0_choices(347) then
        transform_right_filter_feature_0_choices(348) := (not transform_right_filter_feature_0_values(2)) and
          transform_right_filter_feature_0_values(7);
      else
        transform_right_filter_feature_0_choices(348) := (not transform_right_filter_feature_0_values(2)) or
          transform_right_filter_feature_0_values(7);
      end if;
      for i in 8 to 11 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
        if transform_right_filter_feature_0_choices(i + 340) then
          transform_right_filter_feature_0_choices(i + 341) := (not transform_right_filter_feature_0_values(i - 5)) or
            transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 341) := (not transform_right_filter_feature_0_values(i - 5)) and
            transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(352) then
        transform_right_filter_feature_0_choices(353) := (not is_set(transform_right_filter_column(4, 2), 7)) or
          is_set(transform_right_filter_column(0, 0), 7);
      else
        transform_right_filter_feature_0_choices(353) := (not is_set(transform_right_filter_column(4, 2), 7)) and
          is_set(transform_right_filter_column(0, 0), 7);
      end if;
      if transform_filtering_0_column_inside(0) then
        transform_right_filter_feature_0_choice_354 := (as_number(transform_right_filter_feature_0_choices(321)) * 8) +
          (as_number(transform_right_filter_feature_0_choices(329)) * 16) +
          (as_number(transform_right_filter_feature_0_choices(337)) * 4) +
          (as_number(transform_right_filter_feature_0_choices(345)) * 2) +
          as_number(transform_right_filter_feature_0_choices(353));
      else
        transform_right_filter_feature_0_choice_354 := 0;
      end if;
      if transform_filtering_0_column_inside(1) then
        transform_right_filter_feature_0_choice_355 := (as_number(transform_right_filter_feature_0_choices(281)) * 256)
          + (as_number(transform_right_filter_feature_0_choices(289)) * 512) +
          (as_number(transform_right_filter_feature_0_choices(297)) * 128) +
          (as_number(transform_right_filter_feature_0_choices(305)) * 64) +
          (as_number(transform_right_filter_feature_0_choices(313)) * 32) + transform_right_filter_feature_0_choice_354;
      else
        transform_right_filter_feature_0_choice_355 := transform_right_filter_feature_0_choice_354;
      end if;
      if transform_filtering_0_column_inside(2) then
        transform_right_filter_feature_0_choice_356 := (as_number(transform_right_filter_feature_0_choices(241)) *
          8192) + (as_number(transform_right_filter_feature_0_choices(249)) * 16384) +
          (as_number(transform_right_filter_feature_0_choices(257)) * 4096) +
          (as_number(transform_right_filter_feature_0_choices(265)) * 2048) +
          (as_number(transform_right_filter_feature_0_choices(273)) * 1024) +
          transform_right_filter_feature_0_choice_355;
      else
        transform_right_filter_feature_0_choice_356 := transform_right_filter_feature_0_choice_355;
      end if;
      if transform_filtering_0_column_inside(3) then
        transform_right_filter_feature_0_choice_357 := (as_number(transform_right_filter_feature_0_choices(201)) *
          262144) + (as_number(transform_right_filter_feature_0_choices(209)) * 524288) +
          (as_number(transform_right_filter_feature_0_choices(217)) * 131072) +
          (as_number(transform_right_filter_feature_0_choices(225)) * 65536) +
          (as_number(transform_right_filter_feature_0_choices(233)) * 32768) +
          transform_right_filter_feature_0_choice_356;
      else
        transform_right_filter_feature_0_choice_357 := transform_right_filter_feature_0_choice_356;
      end if;
      if transform_filtering_0_column_inside(4) then
        transform_right_filter_feature_0_choice_358 := (as_number(transform_right_filter_feature_0_choices(177)) *
          2097152) + (as_number(transform_right_filter_feature_0_choices(185)) * 4194304) +
          (as_number(transform_right_filter_feature_0_choices(193)) * 1048576) +
          transform_right_filter_feature_0_choice_357;
      else
        transform_right_filter_feature_0_choice_358 := transform_right_filter_feature_0_choice_357;
      end if;
      if transform_filtering_0_column_inside(5) then
        transform_right_filter_feature_0_choice_359 := (as_number(transform_right_filter_feature_0_choices(128)) *
          16777216) + (as_number(transform_right_filter_feature_0_choices(136)) * 33554432) +
          (as_number(transform_right_filter_feature_0_choices(144)) * 67108864) +
          (as_number(transform_right_filter_feature_0_choices(152)) * 134217728) +
          (as_number(transform_right_filter_feature_0_choices(160)) * 268435456) +
          (as_number(transform_right_filter_feature_0_choices(169)) * 8388608) +
          transform_right_filter_feature_0_choice_358;
      else
        transform_right_filter_feature_0_choice_359 := (as_number(transform_right_filter_feature_0_choices(169)) *
          8388608) + transform_right_filter_feature_0_choice_358;
      end if;
      if transform_filtering_0_column_inside(6) then
        transform_right_filter_feature_0_choice_360 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choices(120)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(112)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(104)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(96)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(88)), 1) &
          to_unsigned(transform_right_filter_feature_0_choice_359, 29);
      else
        transform_right_filter_feature_0_choice_360 := to_unsigned(transform_right_filter_feature_0_choice_359, 34);
      end if;
      if transform_filtering_0_column_inside(7) then
        transform_right_filter_feature_0_choice_361 :=
          to_unsigned(as_number(transform_right_filter_feature_0_choices(80)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(72)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(64)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(56)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(48)), 1) &
          transform_right_filter_feature_0_choice_360(33 downto 0);
      else
        transform_right_filter_feature_0_choice_361 := resize(transform_right_filter_feature_0_choice_360, 39);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_counter_next_frame <= transform_counter_next_frame_choices(4) or ((not in_valid) and
        transform_counter_next_frame);
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside(0) <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 480;
      transform_read_row_inside(1) <= (transform_counter_group >= 3) and (transform_counter_group < 483);
      transform_read_row_inside(2) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 480;
      transform_read_row_inside(3) <= (transform_counter_group >= 1) and (transform_counter_group < 481);
      transform_read_row_inside(4) <= transform_counter_group < 480;
      transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
      transform_read_column_inside(1) <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside(2) <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside(3) <= transform_counter_column /= 3;
      for i in 4 to 8 loop
        transform_read_column_inside(i) <= (transform_counter_column < i) /= transform_read_column_inside_0_is_less;
      end loop;
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      for i in 0 to 4 loop
        transform_ready_row_inside(i) <= transform_read_row_inside(i);
      end loop;
      for i in 0 to 8 loop
        transform_ready_column_inside(i) <= transform_read_column_inside(i);
      end loop;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column(0) <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column(1) <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
      transform_left_column(2) <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column(3) <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
      transform_left_column(4) <= transform_left_rows_ready_newest_0;
      transform_right_column(0) <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column(1) <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
      transform_right_column(2) <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column(3) <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
      transform_right_column(4) <= transform_right_rows_ready_newest_0;
      for i in 0 to 4 loop
        transform_columns_row_inside(i) <= transform_ready_row_inside(i);
      end loop;
      for i in 0 to 8 loop
        transform_columns_column_inside(i) <= transform_ready_column_inside(i);
      end loop;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      for i in 0 to 8 loop
        transform_filtering_0_column_inside(i) <= transform_columns_column_inside(i);
      end loop;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice * 32;
      else
        transform_counter_group <= transform_counter_group_choices(3);
      end if;
      if transform_filtering_0_column_inside(8) then
        transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choices(40)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(32)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(24)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(16)), 1) &
          to_unsigned(as_number(transform_left_filter_feature_0_choices(8)), 1) &
          transform_left_filter_feature_0_choice_361(38 downto 0);
        transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choices(40)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(32)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(24)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(16)), 1) &
          to_unsigned(as_number(transform_right_filter_feature_0_choices(8)), 1) &
          transform_right_filter_feature_0_choice_361(38 downto 0);
      else
        transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_361, 44);
        transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_361, 44);
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal_2 then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 1024;
        end if;
      end if;
      if transform_ready_valid then
        transform_left_rows_write_words_0 <= to_unsigned(transform_left_rows_ready_newest_0, 8) &
          transform_left_rows_ready_words_0(31 downto 8);
        transform_right_rows_write_words_0 <= to_unsigned(transform_right_rows_ready_newest_0, 8) &
          transform_right_rows_ready_words_0(31 downto 8);
        transform_write_column <= transform_ready_column;
      end if;
      if transform_columns_valid then
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
          end loop;
        end loop;
        for i in 0 to 4 loop
          if transform_columns_row_inside(i) then
            transform_left_filter_column(0, i) <= transform_left_column(i);
            transform_right_filter_column(0, i) <= transform_right_column(i);
          else
            transform_left_filter_column(0, i) <= 0;
            transform_right_filter_column(0, i) <= 0;
          end if;
        end loop;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_column = 639;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(1);
      if transform_filtering_valid(1) and transform_filtering_start_of_frame(1) then
        raster_place_group <= 0;
      else
        raster_place_group <= (raster_place_group + as_number(((raster_place_group /= 480) and
          transform_filtering_valid(1) and raster_place_group_is_equal))) mod 512;
      end if;
      if transform_filtering_valid(1) then
        if raster_place_group_is_equal or transform_filtering_start_of_frame(1) then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 1024;
        end if;
      end if;
      -- delay
      delay_tag_first_cost_is_equal := raster_place_column = 127;
      delay_tag_map_column_is_not_less := raster_place_column >= 127;
      delay_tag_map_column_is_less := raster_place_column < 640;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_tag_valid <= raster_features_valid;
      delay_tag_border_column <= raster_place_column < 127;
      delay_tag_first_cost <= delay_tag_first_cost_is_equal;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= (raster_place_group < 480) and delay_tag_map_column_is_not_less and
        delay_tag_map_column_is_less;
      delay_tag_start_of_frame <= (raster_place_group = 0) and delay_tag_first_cost_is_equal;
      delay_tag_end_of_line <= raster_place_group_is_equal;
      -- rows
      rows_search_0 <= delay_delayed_0;
      rows_reference_0 <= delay_ahead_0;
      rows_tag_valid <= delay_tag_valid;
      rows_tag_border_column <= delay_tag_border_column;
      rows_tag_first_cost <= delay_tag_first_cost;
      rows_tag_map_column <= delay_tag_map_column;
      rows_tag_output_column <= delay_tag_output_column;
      rows_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_tag_end_of_line <= delay_tag_end_of_line;
      -- slice0shift
      if rows_tag_valid then
        slice0shift_search_0(0) <= rows_search_0;
        for i in 1 to 15 loop
          slice0shift_search_0(i) <= slice0shift_search_0(i - 1);
        end loop;
      end if;
      slice0shift_reference_0 <= rows_reference_0;
      slice0shift_search_out_0 <= slice0shift_search_0(15);
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_border_column <= rows_tag_border_column;
      slice0shift_tag_first_cost <= rows_tag_first_cost;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      slice0cost_pixels_first_0_0_count_value(0) := slice0shift_reference_0(2) = '1';
      slice0cost_pixels_first_0_0_count_value_2(0) := slice0shift_reference_0(1) = '1';
      slice0cost_pixels_first_0_0_count_value(1) := slice0shift_reference_0(3) = '1';
      slice0cost_pixels_first_0_0_count_value_2(1) := slice0shift_reference_0(5) = '1';
      slice0cost_pixels_first_0_0_count_1_value_3 := slice0shift_reference_0(4) = '1';
      slice0cost_pixels_first_0_0_count_value(2) := slice0shift_reference_0(8) = '1';
      slice0cost_pixels_first_0_0_count_value_2(2) := slice0shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice0cost_pixels_first_0_0_count_value(i) := slice0shift_reference_0(3 * i) = '1';
        slice0cost_pixels_first_0_0_count_value_2(i) := slice0shift_reference_0(3 * i + 2) = '1';
        slice0cost_pixels_first_0_0_count_value_3(i) := slice0shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice0cost_pixels_first_0_0_count_value(14) := slice0shift_reference_0(42) = '1';
      slice0cost_pixels_first_0_count(0, 0) <= as_number(((slice0shift_search_0(0)(0) = '1') /=
        (slice0shift_reference_0(0) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value(0) /=
        (slice0shift_search_0(0)(2) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value_2(0) /=
        (slice0shift_search_0(0)(1) = '1')));
      slice0cost_pixels_first_0_count(0, 1) <= as_number((slice0cost_pixels_first_0_0_count_value(1) /=
        (slice0shift_search_0(0)(3) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value_2(1) /=
        (slice0shift_search_0(0)(5) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_1_value_3 /=
        (slice0shift_search_0(0)(4) = '1')));
      slice0cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice0cost_pixels_first_0_0_count_value(2) /= (slice0shift_search_0(0)(8) = '1'))) +
        as_number((slice0cost_pixels_first_0_0_count_value_2(2) /= (slice0shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice0cost_pixels_first_0_count(0, i) <= as_number((slice0cost_pixels_first_0_0_count_value(i) /=
          (slice0shift_search_0(0)(3 * i) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value_2(i) /=
          (slice0shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value_3(i) /=
          (slice0shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice0cost_pixels_first_0_count_14(0) <= as_number(((slice0shift_reference_0(43) = '1') /=
        (slice0shift_search_0(0)(43) = '1'))) + as_number((slice0cost_pixels_first_0_0_count_value(14) /=
        (slice0shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice0cost_pixels_first_0_count(i, 0) <= as_number(((slice0shift_search_0(i)(0) = '1') /=
          (slice0shift_reference_0(0) = '1'))) + as_number(((slice0shift_search_0(i)(2) = '1') /=
          slice0cost_pixels_first_0_0_count_value(0))) + as_number(((slice0shift_search_0(i)(1) = '1') /=
          slice0cost_pixels_first_0_0_count_value_2(0)));
        slice0cost_pixels_first_0_count(i, 1) <= as_number(((slice0shift_search_0(i)(3) = '1') /=
          slice0cost_pixels_first_0_0_count_value(1))) + as_number(((slice0shift_search_0(i)(5) = '1') /=
          slice0cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice0shift_search_0(i)(4) = '1') /=
          slice0cost_pixels_first_0_0_count_1_value_3));
        slice0cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice0shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice0shift_search_0(i)(8) = '1') /= slice0cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice0shift_search_0(i)(6) = '1') /= slice0cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice0cost_pixels_first_0_count(i, j) <= as_number(((slice0shift_search_0(i)(3 * j) = '1') /=
            slice0cost_pixels_first_0_0_count_value(j))) + as_number(((slice0shift_search_0(i)(3 * j + 2) = '1') /=
            slice0cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice0shift_search_0(i)(3 * j + 1) = '1') /=
            slice0cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice0cost_pixels_first_0_count_14(i) <= as_number(((slice0shift_search_0(i)(43) = '1') /=
          (slice0shift_reference_0(43) = '1'))) + as_number(((slice0shift_search_0(i)(42) = '1') /=
          slice0cost_pixels_first_0_0_count_value(14)));
      end loop;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_border_column <= slice0shift_tag_border_column;
      slice0cost_pixels_first_tag_first_cost <= slice0shift_tag_first_cost;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_pixels_cost_0(i) <= slice0cost_pixels_first_0_count(i, 3) + slice0cost_pixels_first_0_count(i, 7) +
          slice0cost_pixels_first_0_count(i, 12) + slice0cost_pixels_first_0_count(i, 6) +
          slice0cost_pixels_first_0_count(i, 9) + slice0cost_pixels_first_0_count_14(i) +
          slice0cost_pixels_first_0_count(i, 11) + slice0cost_pixels_first_0_count(i, 2) +
          slice0cost_pixels_first_0_count(i, 10) + slice0cost_pixels_first_0_count(i, 4) +
          slice0cost_pixels_first_0_count(i, 8) + slice0cost_pixels_first_0_count(i, 1) +
          slice0cost_pixels_first_0_count(i, 5) + slice0cost_pixels_first_0_count(i, 0) +
          slice0cost_pixels_first_0_count(i, 13);
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_border_column <= slice0cost_pixels_first_tag_border_column;
      slice0cost_pixels_tag_first_cost <= slice0cost_pixels_first_tag_first_cost;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_single_0(i) <= slice0cost_pixels_cost_0(i);
      end loop;
      slice0cost_pair_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_pair_tag_border_column <= slice0cost_pixels_tag_border_column;
      slice0cost_pair_tag_first_cost <= slice0cost_pixels_tag_first_cost;
      slice0cost_pair_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_border_column <= slice0cost_pair_tag_border_column;
      slice0cost_tag_first_cost <= slice0cost_pair_tag_first_cost;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      -- slice0window
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_border_column <= slice0cost_tag_border_column;
      slice0window_tag_first_cost <= slice0cost_tag_first_cost;
      slice0window_tag_map_column <= slice0cost_tag_map_column;
      slice0window_tag_output_column <= slice0cost_tag_output_column;
      slice0window_tag_start_of_frame <= slice0cost_tag_start_of_frame;
      slice0window_tag_end_of_line <= slice0cost_tag_end_of_line;
      -- slice0
      for i in 0 to 15 loop
        slice0_held(0, i) <= other(257 - 2 * i) / 4;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice0_held(2 * i + 1, j) <= slice0_held(2 * i, j);
        end loop;
        for j in 0 to 15 loop
          slice0_held(2 * i + 2, j) <= slice0_held(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice0_held(7, i) <= slice0_held(6, i);
      end loop;
      slice0_tag_valid(0) <= slice0window_tag_valid;
      slice0_tag_border_column(0) <= slice0window_tag_border_column;
      slice0_tag_first_cost(0) <= slice0window_tag_first_cost;
      slice0_tag_map_column(0) <= slice0window_tag_map_column;
      slice0_tag_output_column(0) <= slice0window_tag_output_column;
      slice0_tag_start_of_frame(0) <= slice0window_tag_start_of_frame;
      slice0_tag_end_of_line(0) <= slice0window_tag_end_of_line;
      for i in 1 to 3 loop
        slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
        slice0_tag_border_column(i) <= slice0_tag_border_column(i - 1);
        slice0_tag_first_cost(i) <= slice0_tag_first_cost(i - 1);
        slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
        slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
        slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
        slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
      end loop;
      slice0_tag_valid(4) <= slice0_tag_valid(3);
      slice0_tag_border_column(4) <= slice0_tag_border_column(3);
      for i in 4 to 6 loop
        slice0_tag_first_cost(i) <= slice0_tag_first_cost(i - 1);
        slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
        slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
        slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
        slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
        slice0_tag_valid(i + 1) <= slice0_tag_valid(i);
      end loop;
      slice0_tag_first_cost(7) <= slice0_tag_first_cost(6);
      slice0_tag_map_column(7) <= slice0_tag_map_column(6);
      slice0_tag_output_column(7) <= slice0_tag_output_column(6);
      slice0_tag_start_of_frame(7) <= slice0_tag_start_of_frame(6);
      slice0_tag_end_of_line(7) <= slice0_tag_end_of_line(6);
      -- slice1shift
      if slice0shift_tag_valid then
        slice1shift_search_0(0) <= slice0shift_search_out_0;
        for i in 1 to 15 loop
          slice1shift_search_0(i) <= slice1shift_search_0(i - 1);
        end loop;
      end if;
      slice1shift_reference_0 <= slice0shift_reference_0;
      slice1shift_search_out_0 <= slice1shift_search_0(15);
      -- slice1cost
      slice1cost_pixels_first_0_0_count_value(0) := slice1shift_reference_0(2) = '1';
      slice1cost_pixels_first_0_0_count_value_2(0) := slice1shift_reference_0(1) = '1';
      slice1cost_pixels_first_0_0_count_value(1) := slice1shift_reference_0(3) = '1';
      slice1cost_pixels_first_0_0_count_value_2(1) := slice1shift_reference_0(5) = '1';
      slice1cost_pixels_first_0_0_count_1_value_3 := slice1shift_reference_0(4) = '1';
      slice1cost_pixels_first_0_0_count_value(2) := slice1shift_reference_0(8) = '1';
      slice1cost_pixels_first_0_0_count_value_2(2) := slice1shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice1cost_pixels_first_0_0_count_value(i) := slice1shift_reference_0(3 * i) = '1';
        slice1cost_pixels_first_0_0_count_value_2(i) := slice1shift_reference_0(3 * i + 2) = '1';
        slice1cost_pixels_first_0_0_count_value_3(i) := slice1shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice1cost_pixels_first_0_0_count_value(14) := slice1shift_reference_0(42) = '1';
      slice1cost_pixels_first_0_count(0, 0) <= as_number(((slice1shift_search_0(0)(0) = '1') /=
        (slice1shift_reference_0(0) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value(0) /=
        (slice1shift_search_0(0)(2) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value_2(0) /=
        (slice1shift_search_0(0)(1) = '1')));
      slice1cost_pixels_first_0_count(0, 1) <= as_number((slice1cost_pixels_first_0_0_count_value(1) /=
        (slice1shift_search_0(0)(3) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value_2(1) /=
        (slice1shift_search_0(0)(5) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_1_value_3 /=
        (slice1shift_search_0(0)(4) = '1')));
      slice1cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice1cost_pixels_first_0_0_count_value(2) /= (slice1shift_search_0(0)(8) = '1'))) +
        as_number((slice1cost_pixels_first_0_0_count_value_2(2) /= (slice1shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice1cost_pixels_first_0_count(0, i) <= as_number((slice1cost_pixels_first_0_0_count_value(i) /=
          (slice1shift_search_0(0)(3 * i) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value_2(i) /=
          (slice1shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value_3(i) /=
          (slice1shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice1cost_pixels_first_0_count_14(0) <= as_number(((slice1shift_reference_0(43) = '1') /=
        (slice1shift_search_0(0)(43) = '1'))) + as_number((slice1cost_pixels_first_0_0_count_value(14) /=
        (slice1shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice1cost_pixels_first_0_count(i, 0) <= as_number(((slice1shift_search_0(i)(0) = '1') /=
          (slice1shift_reference_0(0) = '1'))) + as_number(((slice1shift_search_0(i)(2) = '1') /=
          slice1cost_pixels_first_0_0_count_value(0))) + as_number(((slice1shift_search_0(i)(1) = '1') /=
          slice1cost_pixels_first_0_0_count_value_2(0)));
        slice1cost_pixels_first_0_count(i, 1) <= as_number(((slice1shift_search_0(i)(3) = '1') /=
          slice1cost_pixels_first_0_0_count_value(1))) + as_number(((slice1shift_search_0(i)(5) = '1') /=
          slice1cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice1shift_search_0(i)(4) = '1') /=
          slice1cost_pixels_first_0_0_count_1_value_3));
        slice1cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice1shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice1shift_search_0(i)(8) = '1') /= slice1cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice1shift_search_0(i)(6) = '1') /= slice1cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice1cost_pixels_first_0_count(i, j) <= as_number(((slice1shift_search_0(i)(3 * j) = '1') /=
            slice1cost_pixels_first_0_0_count_value(j))) + as_number(((slice1shift_search_0(i)(3 * j + 2) = '1') /=
            slice1cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice1shift_search_0(i)(3 * j + 1) = '1') /=
            slice1cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice1cost_pixels_first_0_count_14(i) <= as_number(((slice1shift_search_0(i)(43) = '1') /=
          (slice1shift_reference_0(43) = '1'))) + as_number(((slice1shift_search_0(i)(42) = '1') /=
          slice1cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice1cost_pixels_cost_0(i) <= slice1cost_pixels_first_0_count(i, 3) + slice1cost_pixels_first_0_count(i, 7) +
          slice1cost_pixels_first_0_count(i, 12) + slice1cost_pixels_first_0_count(i, 6) +
          slice1cost_pixels_first_0_count(i, 9) + slice1cost_pixels_first_0_count_14(i) +
          slice1cost_pixels_first_0_count(i, 11) + slice1cost_pixels_first_0_count(i, 2) +
          slice1cost_pixels_first_0_count(i, 10) + slice1cost_pixels_first_0_count(i, 4) +
          slice1cost_pixels_first_0_count(i, 8) + slice1cost_pixels_first_0_count(i, 1) +
          slice1cost_pixels_first_0_count(i, 5) + slice1cost_pixels_first_0_count(i, 0) +
          slice1cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice1cost_single_0(i) <= slice1cost_pixels_cost_0(i);
      end loop;
      -- slice1
      for i in 0 to 15 loop
        slice1_held(0, i) <= other(225 - 2 * i) / 4;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice1_held(2 * i + 1, j) <= slice1_held(2 * i, j);
        end loop;
        for j in 0 to 15 loop
          slice1_held(2 * i + 2, j) <= slice1_held(2 * i + 1, j);
        end loop;
      end loop;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        slice2shift_search_0(0) <= slice1shift_search_out_0;
        for i in 1 to 15 loop
          slice2shift_search_0(i) <= slice2shift_search_0(i - 1);
        end loop;
      end if;
      slice2shift_reference_0 <= slice1shift_reference_0;
      slice2shift_search_out_0 <= slice2shift_search_0(15);
      -- slice2cost
      slice2cost_pixels_first_0_0_count_value(0) := slice2shift_reference_0(2) = '1';
      slice2cost_pixels_first_0_0_count_value_2(0) := slice2shift_reference_0(1) = '1';
      slice2cost_pixels_first_0_0_count_value(1) := slice2shift_reference_0(3) = '1';
      slice2cost_pixels_first_0_0_count_value_2(1) := slice2shift_reference_0(5) = '1';
      slice2cost_pixels_first_0_0_count_1_value_3 := slice2shift_reference_0(4) = '1';
      slice2cost_pixels_first_0_0_count_value(2) := slice2shift_reference_0(8) = '1';
      slice2cost_pixels_first_0_0_count_value_2(2) := slice2shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice2cost_pixels_first_0_0_count_value(i) := slice2shift_reference_0(3 * i) = '1';
        slice2cost_pixels_first_0_0_count_value_2(i) := slice2shift_reference_0(3 * i + 2) = '1';
        slice2cost_pixels_first_0_0_count_value_3(i) := slice2shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice2cost_pixels_first_0_0_count_value(14) := slice2shift_reference_0(42) = '1';
      slice2cost_pixels_first_0_count(0, 0) <= as_number(((slice2shift_search_0(0)(0) = '1') /=
        (slice2shift_reference_0(0) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value(0) /=
        (slice2shift_search_0(0)(2) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value_2(0) /=
        (slice2shift_search_0(0)(1) = '1')));
      slice2cost_pixels_first_0_count(0, 1) <= as_number((slice2cost_pixels_first_0_0_count_value(1) /=
        (slice2shift_search_0(0)(3) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value_2(1) /=
        (slice2shift_search_0(0)(5) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_1_value_3 /=
        (slice2shift_search_0(0)(4) = '1')));
      slice2cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice2cost_pixels_first_0_0_count_value(2) /= (slice2shift_search_0(0)(8) = '1'))) +
        as_number((slice2cost_pixels_first_0_0_count_value_2(2) /= (slice2shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice2cost_pixels_first_0_count(0, i) <= as_number((slice2cost_pixels_first_0_0_count_value(i) /=
          (slice2shift_search_0(0)(3 * i) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value_2(i) /=
          (slice2shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value_3(i) /=
          (slice2shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice2cost_pixels_first_0_count_14(0) <= as_number(((slice2shift_reference_0(43) = '1') /=
        (slice2shift_search_0(0)(43) = '1'))) + as_number((slice2cost_pixels_first_0_0_count_value(14) /=
        (slice2shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice2cost_pixels_first_0_count(i, 0) <= as_number(((slice2shift_search_0(i)(0) = '1') /=
          (slice2shift_reference_0(0) = '1'))) + as_number(((slice2shift_search_0(i)(2) = '1') /=
          slice2cost_pixels_first_0_0_count_value(0))) + as_number(((slice2shift_search_0(i)(1) = '1') /=
          slice2cost_pixels_first_0_0_count_value_2(0)));
        slice2cost_pixels_first_0_count(i, 1) <= as_number(((slice2shift_search_0(i)(3) = '1') /=
          slice2cost_pixels_first_0_0_count_value(1))) + as_number(((slice2shift_search_0(i)(5) = '1') /=
          slice2cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice2shift_search_0(i)(4) = '1') /=
          slice2cost_pixels_first_0_0_count_1_value_3));
        slice2cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice2shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice2shift_search_0(i)(8) = '1') /= slice2cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice2shift_search_0(i)(6) = '1') /= slice2cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice2cost_pixels_first_0_count(i, j) <= as_number(((slice2shift_search_0(i)(3 * j) = '1') /=
            slice2cost_pixels_first_0_0_count_value(j))) + as_number(((slice2shift_search_0(i)(3 * j + 2) = '1') /=
            slice2cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice2shift_search_0(i)(3 * j + 1) = '1') /=
            slice2cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice2cost_pixels_first_0_count_14(i) <= as_number(((slice2shift_search_0(i)(43) = '1') /=
          (slice2shift_reference_0(43) = '1'))) + as_number(((slice2shift_search_0(i)(42) = '1') /=
          slice2cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice2cost_pixels_cost_0(i) <= slice2cost_pixels_first_0_count(i, 3) + slice2cost_pixels_first_0_count(i, 7) +
          slice2cost_pixels_first_0_count(i, 12) + slice2cost_pixels_first_0_count(i, 6) +
          slice2cost_pixels_first_0_count(i, 9) + slice2cost_pixels_first_0_count_14(i) +
          slice2cost_pixels_first_0_count(i, 11) + slice2cost_pixels_first_0_count(i, 2) +
          slice2cost_pixels_first_0_count(i, 10) + slice2cost_pixels_first_0_count(i, 4) +
          slice2cost_pixels_first_0_count(i, 8) + slice2cost_pixels_first_0_count(i, 1) +
          slice2cost_pixels_first_0_count(i, 5) + slice2cost_pixels_first_0_count(i, 0) +
          slice2cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice2cost_single_0(i) <= slice2cost_pixels_cost_0(i);
      end loop;
      -- slice2
      for i in 0 to 15 loop
        slice2_held(0, i) <= other(193 - 2 * i) / 4;
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice2_held(2 * i + 1, j) <= slice2_held(2 * i, j);
        end loop;
        for j in 0 to 15 loop
          slice2_held(2 * i + 2, j) <= slice2_held(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice2_held(5, i) <= slice2_held(4, i);
      end loop;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        slice3shift_search_0(0) <= slice2shift_search_out_0;
        for i in 1 to 15 loop
          slice3shift_search_0(i) <= slice3shift_search_0(i - 1);
        end loop;
      end if;
      slice3shift_reference_0 <= slice2shift_reference_0;
      slice3shift_search_out_0 <= slice3shift_search_0(15);
      -- slice3cost
      slice3cost_pixels_first_0_0_count_value(0) := slice3shift_reference_0(2) = '1';
      slice3cost_pixels_first_0_0_count_value_2(0) := slice3shift_reference_0(1) = '1';
      slice3cost_pixels_first_0_0_count_value(1) := slice3shift_reference_0(3) = '1';
      slice3cost_pixels_first_0_0_count_value_2(1) := slice3shift_reference_0(5) = '1';
      slice3cost_pixels_first_0_0_count_1_value_3 := slice3shift_reference_0(4) = '1';
      slice3cost_pixels_first_0_0_count_value(2) := slice3shift_reference_0(8) = '1';
      slice3cost_pixels_first_0_0_count_value_2(2) := slice3shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice3cost_pixels_first_0_0_count_value(i) := slice3shift_reference_0(3 * i) = '1';
        slice3cost_pixels_first_0_0_count_value_2(i) := slice3shift_reference_0(3 * i + 2) = '1';
        slice3cost_pixels_first_0_0_count_value_3(i) := slice3shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice3cost_pixels_first_0_0_count_value(14) := slice3shift_reference_0(42) = '1';
      slice3cost_pixels_first_0_count(0, 0) <= as_number(((slice3shift_search_0(0)(0) = '1') /=
        (slice3shift_reference_0(0) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value(0) /=
        (slice3shift_search_0(0)(2) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value_2(0) /=
        (slice3shift_search_0(0)(1) = '1')));
      slice3cost_pixels_first_0_count(0, 1) <= as_number((slice3cost_pixels_first_0_0_count_value(1) /=
        (slice3shift_search_0(0)(3) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value_2(1) /=
        (slice3shift_search_0(0)(5) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_1_value_3 /=
        (slice3shift_search_0(0)(4) = '1')));
      slice3cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice3shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice3cost_pixels_first_0_0_count_value(2) /= (slice3shift_search_0(0)(8) = '1'))) +
        as_number((slice3cost_pixels_first_0_0_count_value_2(2) /= (slice3shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice3cost_pixels_first_0_count(0, i) <= as_number((slice3cost_pixels_first_0_0_count_value(i) /=
          (slice3shift_search_0(0)(3 * i) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value_2(i) /=
          (slice3shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value_3(i) /=
          (slice3shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice3cost_pixels_first_0_count_14(0) <= as_number(((slice3shift_reference_0(43) = '1') /=
        (slice3shift_search_0(0)(43) = '1'))) + as_number((slice3cost_pixels_first_0_0_count_value(14) /=
        (slice3shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice3cost_pixels_first_0_count(i, 0) <= as_number(((slice3shift_search_0(i)(0) = '1') /=
          (slice3shift_reference_0(0) = '1'))) + as_number(((slice3shift_search_0(i)(2) = '1') /=
          slice3cost_pixels_first_0_0_count_value(0))) + as_number(((slice3shift_search_0(i)(1) = '1') /=
          slice3cost_pixels_first_0_0_count_value_2(0)));
        slice3cost_pixels_first_0_count(i, 1) <= as_number(((slice3shift_search_0(i)(3) = '1') /=
          slice3cost_pixels_first_0_0_count_value(1))) + as_number(((slice3shift_search_0(i)(5) = '1') /=
          slice3cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice3shift_search_0(i)(4) = '1') /=
          slice3cost_pixels_first_0_0_count_1_value_3));
        slice3cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice3shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice3shift_search_0(i)(8) = '1') /= slice3cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice3shift_search_0(i)(6) = '1') /= slice3cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice3cost_pixels_first_0_count(i, j) <= as_number(((slice3shift_search_0(i)(3 * j) = '1') /=
            slice3cost_pixels_first_0_0_count_value(j))) + as_number(((slice3shift_search_0(i)(3 * j + 2) = '1') /=
            slice3cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice3shift_search_0(i)(3 * j + 1) = '1') /=
            slice3cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice3cost_pixels_first_0_count_14(i) <= as_number(((slice3shift_search_0(i)(43) = '1') /=
          (slice3shift_reference_0(43) = '1'))) + as_number(((slice3shift_search_0(i)(42) = '1') /=
          slice3cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice3cost_pixels_cost_0(i) <= slice3cost_pixels_first_0_count(i, 3) + slice3cost_pixels_first_0_count(i, 7) +
          slice3cost_pixels_first_0_count(i, 12) + slice3cost_pixels_first_0_count(i, 6) +
          slice3cost_pixels_first_0_count(i, 9) + slice3cost_pixels_first_0_count_14(i) +
          slice3cost_pixels_first_0_count(i, 11) + slice3cost_pixels_first_0_count(i, 2) +
          slice3cost_pixels_first_0_count(i, 10) + slice3cost_pixels_first_0_count(i, 4) +
          slice3cost_pixels_first_0_count(i, 8) + slice3cost_pixels_first_0_count(i, 1) +
          slice3cost_pixels_first_0_count(i, 5) + slice3cost_pixels_first_0_count(i, 0) +
          slice3cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice3cost_single_0(i) <= slice3cost_pixels_cost_0(i);
      end loop;
      -- slice3
      for i in 0 to 15 loop
        slice3_held(0, i) <= other(161 - 2 * i) / 4;
      end loop;
      for i in 0 to 1 loop
        for j in 0 to 15 loop
          slice3_held(2 * i + 1, j) <= slice3_held(2 * i, j);
        end loop;
        for j in 0 to 15 loop
          slice3_held(2 * i + 2, j) <= slice3_held(2 * i + 1, j);
        end loop;
      end loop;
      -- slice4shift
      if slice0cost_pair_tag_valid then
        slice4shift_search_0(0) <= slice3shift_search_out_0;
        for i in 1 to 15 loop
          slice4shift_search_0(i) <= slice4shift_search_0(i - 1);
        end loop;
      end if;
      slice4shift_reference_0 <= slice3shift_reference_0;
      slice4shift_search_out_0 <= slice4shift_search_0(15);
      -- slice4cost
      slice4cost_pixels_first_0_0_count_value(0) := slice4shift_reference_0(2) = '1';
      slice4cost_pixels_first_0_0_count_value_2(0) := slice4shift_reference_0(1) = '1';
      slice4cost_pixels_first_0_0_count_value(1) := slice4shift_reference_0(3) = '1';
      slice4cost_pixels_first_0_0_count_value_2(1) := slice4shift_reference_0(5) = '1';
      slice4cost_pixels_first_0_0_count_1_value_3 := slice4shift_reference_0(4) = '1';
      slice4cost_pixels_first_0_0_count_value(2) := slice4shift_reference_0(8) = '1';
      slice4cost_pixels_first_0_0_count_value_2(2) := slice4shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice4cost_pixels_first_0_0_count_value(i) := slice4shift_reference_0(3 * i) = '1';
        slice4cost_pixels_first_0_0_count_value_2(i) := slice4shift_reference_0(3 * i + 2) = '1';
        slice4cost_pixels_first_0_0_count_value_3(i) := slice4shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice4cost_pixels_first_0_0_count_value(14) := slice4shift_reference_0(42) = '1';
      slice4cost_pixels_first_0_count(0, 0) <= as_number(((slice4shift_search_0(0)(0) = '1') /=
        (slice4shift_reference_0(0) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value(0) /=
        (slice4shift_search_0(0)(2) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value_2(0) /=
        (slice4shift_search_0(0)(1) = '1')));
      slice4cost_pixels_first_0_count(0, 1) <= as_number((slice4cost_pixels_first_0_0_count_value(1) /=
        (slice4shift_search_0(0)(3) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value_2(1) /=
        (slice4shift_search_0(0)(5) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_1_value_3 /=
        (slice4shift_search_0(0)(4) = '1')));
      slice4cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice4shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice4shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice4cost_pixels_first_0_0_count_value(2) /= (slice4shift_search_0(0)(8) = '1'))) +
        as_number((slice4cost_pixels_first_0_0_count_value_2(2) /= (slice4shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice4cost_pixels_first_0_count(0, i) <= as_number((slice4cost_pixels_first_0_0_count_value(i) /=
          (slice4shift_search_0(0)(3 * i) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value_2(i) /=
          (slice4shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value_3(i) /=
          (slice4shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice4cost_pixels_first_0_count_14(0) <= as_number(((slice4shift_reference_0(43) = '1') /=
        (slice4shift_search_0(0)(43) = '1'))) + as_number((slice4cost_pixels_first_0_0_count_value(14) /=
        (slice4shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice4cost_pixels_first_0_count(i, 0) <= as_number(((slice4shift_search_0(i)(0) = '1') /=
          (slice4shift_reference_0(0) = '1'))) + as_number(((slice4shift_search_0(i)(2) = '1') /=
          slice4cost_pixels_first_0_0_count_value(0))) + as_number(((slice4shift_search_0(i)(1) = '1') /=
          slice4cost_pixels_first_0_0_count_value_2(0)));
        slice4cost_pixels_first_0_count(i, 1) <= as_number(((slice4shift_search_0(i)(3) = '1') /=
          slice4cost_pixels_first_0_0_count_value(1))) + as_number(((slice4shift_search_0(i)(5) = '1') /=
          slice4cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice4shift_search_0(i)(4) = '1') /=
          slice4cost_pixels_first_0_0_count_1_value_3));
        slice4cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice4shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice4shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice4shift_search_0(i)(8) = '1') /= slice4cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice4shift_search_0(i)(6) = '1') /= slice4cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice4cost_pixels_first_0_count(i, j) <= as_number(((slice4shift_search_0(i)(3 * j) = '1') /=
            slice4cost_pixels_first_0_0_count_value(j))) + as_number(((slice4shift_search_0(i)(3 * j + 2) = '1') /=
            slice4cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice4shift_search_0(i)(3 * j + 1) = '1') /=
            slice4cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice4cost_pixels_first_0_count_14(i) <= as_number(((slice4shift_search_0(i)(43) = '1') /=
          (slice4shift_reference_0(43) = '1'))) + as_number(((slice4shift_search_0(i)(42) = '1') /=
          slice4cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice4cost_pixels_cost_0(i) <= slice4cost_pixels_first_0_count(i, 3) + slice4cost_pixels_first_0_count(i, 7) +
          slice4cost_pixels_first_0_count(i, 12) + slice4cost_pixels_first_0_count(i, 6) +
          slice4cost_pixels_first_0_count(i, 9) + slice4cost_pixels_first_0_count_14(i) +
          slice4cost_pixels_first_0_count(i, 11) + slice4cost_pixels_first_0_count(i, 2) +
          slice4cost_pixels_first_0_count(i, 10) + slice4cost_pixels_first_0_count(i, 4) +
          slice4cost_pixels_first_0_count(i, 8) + slice4cost_pixels_first_0_count(i, 1) +
          slice4cost_pixels_first_0_count(i, 5) + slice4cost_pixels_first_0_count(i, 0) +
          slice4cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice4cost_single_0(i) <= slice4cost_pixels_cost_0(i);
      end loop;
      -- slice4
      for i in 0 to 15 loop
        slice4_held(0, i) <= other(129 - 2 * i) / 4;
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 15 loop
          slice4_held(i, j) <= slice4_held(i - 1, j);
        end loop;
      end loop;
      -- slice5shift
      if slice0cost_tag_valid then
        slice5shift_search_0(0) <= slice4shift_search_out_0;
        for i in 1 to 15 loop
          slice5shift_search_0(i) <= slice5shift_search_0(i - 1);
        end loop;
      end if;
      slice5shift_reference_0 <= slice4shift_reference_0;
      slice5shift_search_out_0 <= slice5shift_search_0(15);
      -- slice5cost
      slice5cost_pixels_first_0_0_count_value(0) := slice5shift_reference_0(2) = '1';
      slice5cost_pixels_first_0_0_count_value_2(0) := slice5shift_reference_0(1) = '1';
      slice5cost_pixels_first_0_0_count_value(1) := slice5shift_reference_0(3) = '1';
      slice5cost_pixels_first_0_0_count_value_2(1) := slice5shift_reference_0(5) = '1';
      slice5cost_pixels_first_0_0_count_1_value_3 := slice5shift_reference_0(4) = '1';
      slice5cost_pixels_first_0_0_count_value(2) := slice5shift_reference_0(8) = '1';
      slice5cost_pixels_first_0_0_count_value_2(2) := slice5shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice5cost_pixels_first_0_0_count_value(i) := slice5shift_reference_0(3 * i) = '1';
        slice5cost_pixels_first_0_0_count_value_2(i) := slice5shift_reference_0(3 * i + 2) = '1';
        slice5cost_pixels_first_0_0_count_value_3(i) := slice5shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice5cost_pixels_first_0_0_count_value(14) := slice5shift_reference_0(42) = '1';
      slice5cost_pixels_first_0_count(0, 0) <= as_number(((slice5shift_search_0(0)(0) = '1') /=
        (slice5shift_reference_0(0) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value(0) /=
        (slice5shift_search_0(0)(2) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value_2(0) /=
        (slice5shift_search_0(0)(1) = '1')));
      slice5cost_pixels_first_0_count(0, 1) <= as_number((slice5cost_pixels_first_0_0_count_value(1) /=
        (slice5shift_search_0(0)(3) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value_2(1) /=
        (slice5shift_search_0(0)(5) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_1_value_3 /=
        (slice5shift_search_0(0)(4) = '1')));
      slice5cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice5shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice5shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice5cost_pixels_first_0_0_count_value(2) /= (slice5shift_search_0(0)(8) = '1'))) +
        as_number((slice5cost_pixels_first_0_0_count_value_2(2) /= (slice5shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice5cost_pixels_first_0_count(0, i) <= as_number((slice5cost_pixels_first_0_0_count_value(i) /=
          (slice5shift_search_0(0)(3 * i) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value_2(i) /=
          (slice5shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value_3(i) /=
          (slice5shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice5cost_pixels_first_0_count_14(0) <= as_number(((slice5shift_reference_0(43) = '1') /=
        (slice5shift_search_0(0)(43) = '1'))) + as_number((slice5cost_pixels_first_0_0_count_value(14) /=
        (slice5shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice5cost_pixels_first_0_count(i, 0) <= as_number(((slice5shift_search_0(i)(0) = '1') /=
          (slice5shift_reference_0(0) = '1'))) + as_number(((slice5shift_search_0(i)(2) = '1') /=
          slice5cost_pixels_first_0_0_count_value(0))) + as_number(((slice5shift_search_0(i)(1) = '1') /=
          slice5cost_pixels_first_0_0_count_value_2(0)));
        slice5cost_pixels_first_0_count(i, 1) <= as_number(((slice5shift_search_0(i)(3) = '1') /=
          slice5cost_pixels_first_0_0_count_value(1))) + as_number(((slice5shift_search_0(i)(5) = '1') /=
          slice5cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice5shift_search_0(i)(4) = '1') /=
          slice5cost_pixels_first_0_0_count_1_value_3));
        slice5cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice5shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice5shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice5shift_search_0(i)(8) = '1') /= slice5cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice5shift_search_0(i)(6) = '1') /= slice5cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice5cost_pixels_first_0_count(i, j) <= as_number(((slice5shift_search_0(i)(3 * j) = '1') /=
            slice5cost_pixels_first_0_0_count_value(j))) + as_number(((slice5shift_search_0(i)(3 * j + 2) = '1') /=
            slice5cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice5shift_search_0(i)(3 * j + 1) = '1') /=
            slice5cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice5cost_pixels_first_0_count_14(i) <= as_number(((slice5shift_search_0(i)(43) = '1') /=
          (slice5shift_reference_0(43) = '1'))) + as_number(((slice5shift_search_0(i)(42) = '1') /=
          slice5cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice5cost_pixels_cost_0(i) <= slice5cost_pixels_first_0_count(i, 3) + slice5cost_pixels_first_0_count(i, 7) +
          slice5cost_pixels_first_0_count(i, 12) + slice5cost_pixels_first_0_count(i, 6) +
          slice5cost_pixels_first_0_count(i, 9) + slice5cost_pixels_first_0_count_14(i) +
          slice5cost_pixels_first_0_count(i, 11) + slice5cost_pixels_first_0_count(i, 2) +
          slice5cost_pixels_first_0_count(i, 10) + slice5cost_pixels_first_0_count(i, 4) +
          slice5cost_pixels_first_0_count(i, 8) + slice5cost_pixels_first_0_count(i, 1) +
          slice5cost_pixels_first_0_count(i, 5) + slice5cost_pixels_first_0_count(i, 0) +
          slice5cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice5cost_single_0(i) <= slice5cost_pixels_cost_0(i);
      end loop;
      -- slice5
      for i in 0 to 15 loop
        slice5_held(0, i) <= other(97 - 2 * i) / 4;
      end loop;
      for i in 0 to 15 loop
        slice5_held(1, i) <= slice5_held(0, i);
      end loop;
      for i in 0 to 15 loop
        slice5_held(2, i) <= slice5_held(1, i);
      end loop;
      -- slice6shift
      if slice0window_tag_valid then
        slice6shift_search_0(0) <= slice5shift_search_out_0;
        for i in 1 to 15 loop
          slice6shift_search_0(i) <= slice6shift_search_0(i - 1);
        end loop;
      end if;
      slice6shift_reference_0 <= slice5shift_reference_0;
      slice6shift_search_out_0 <= slice6shift_search_0(15);
      -- slice6cost
      slice6cost_pixels_first_0_0_count_value(0) := slice6shift_reference_0(2) = '1';
      slice6cost_pixels_first_0_0_count_value_2(0) := slice6shift_reference_0(1) = '1';
      slice6cost_pixels_first_0_0_count_value(1) := slice6shift_reference_0(3) = '1';
      slice6cost_pixels_first_0_0_count_value_2(1) := slice6shift_reference_0(5) = '1';
      slice6cost_pixels_first_0_0_count_1_value_3 := slice6shift_reference_0(4) = '1';
      slice6cost_pixels_first_0_0_count_value(2) := slice6shift_reference_0(8) = '1';
      slice6cost_pixels_first_0_0_count_value_2(2) := slice6shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice6cost_pixels_first_0_0_count_value(i) := slice6shift_reference_0(3 * i) = '1';
        slice6cost_pixels_first_0_0_count_value_2(i) := slice6shift_reference_0(3 * i + 2) = '1';
        slice6cost_pixels_first_0_0_count_value_3(i) := slice6shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice6cost_pixels_first_0_0_count_value(14) := slice6shift_reference_0(42) = '1';
      slice6cost_pixels_first_0_count(0, 0) <= as_number(((slice6shift_search_0(0)(0) = '1') /=
        (slice6shift_reference_0(0) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value(0) /=
        (slice6shift_search_0(0)(2) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value_2(0) /=
        (slice6shift_search_0(0)(1) = '1')));
      slice6cost_pixels_first_0_count(0, 1) <= as_number((slice6cost_pixels_first_0_0_count_value(1) /=
        (slice6shift_search_0(0)(3) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value_2(1) /=
        (slice6shift_search_0(0)(5) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_1_value_3 /=
        (slice6shift_search_0(0)(4) = '1')));
      slice6cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice6shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice6shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice6cost_pixels_first_0_0_count_value(2) /= (slice6shift_search_0(0)(8) = '1'))) +
        as_number((slice6cost_pixels_first_0_0_count_value_2(2) /= (slice6shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice6cost_pixels_first_0_count(0, i) <= as_number((slice6cost_pixels_first_0_0_count_value(i) /=
          (slice6shift_search_0(0)(3 * i) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value_2(i) /=
          (slice6shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value_3(i) /=
          (slice6shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice6cost_pixels_first_0_count_14(0) <= as_number(((slice6shift_reference_0(43) = '1') /=
        (slice6shift_search_0(0)(43) = '1'))) + as_number((slice6cost_pixels_first_0_0_count_value(14) /=
        (slice6shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice6cost_pixels_first_0_count(i, 0) <= as_number(((slice6shift_search_0(i)(0) = '1') /=
          (slice6shift_reference_0(0) = '1'))) + as_number(((slice6shift_search_0(i)(2) = '1') /=
          slice6cost_pixels_first_0_0_count_value(0))) + as_number(((slice6shift_search_0(i)(1) = '1') /=
          slice6cost_pixels_first_0_0_count_value_2(0)));
        slice6cost_pixels_first_0_count(i, 1) <= as_number(((slice6shift_search_0(i)(3) = '1') /=
          slice6cost_pixels_first_0_0_count_value(1))) + as_number(((slice6shift_search_0(i)(5) = '1') /=
          slice6cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice6shift_search_0(i)(4) = '1') /=
          slice6cost_pixels_first_0_0_count_1_value_3));
        slice6cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice6shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice6shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice6shift_search_0(i)(8) = '1') /= slice6cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice6shift_search_0(i)(6) = '1') /= slice6cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice6cost_pixels_first_0_count(i, j) <= as_number(((slice6shift_search_0(i)(3 * j) = '1') /=
            slice6cost_pixels_first_0_0_count_value(j))) + as_number(((slice6shift_search_0(i)(3 * j + 2) = '1') /=
            slice6cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice6shift_search_0(i)(3 * j + 1) = '1') /=
            slice6cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice6cost_pixels_first_0_count_14(i) <= as_number(((slice6shift_search_0(i)(43) = '1') /=
          (slice6shift_reference_0(43) = '1'))) + as_number(((slice6shift_search_0(i)(42) = '1') /=
          slice6cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice6cost_pixels_cost_0(i) <= slice6cost_pixels_first_0_count(i, 3) + slice6cost_pixels_first_0_count(i, 7) +
          slice6cost_pixels_first_0_count(i, 12) + slice6cost_pixels_first_0_count(i, 6) +
          slice6cost_pixels_first_0_count(i, 9) + slice6cost_pixels_first_0_count_14(i) +
          slice6cost_pixels_first_0_count(i, 11) + slice6cost_pixels_first_0_count(i, 2) +
          slice6cost_pixels_first_0_count(i, 10) + slice6cost_pixels_first_0_count(i, 4) +
          slice6cost_pixels_first_0_count(i, 8) + slice6cost_pixels_first_0_count(i, 1) +
          slice6cost_pixels_first_0_count(i, 5) + slice6cost_pixels_first_0_count(i, 0) +
          slice6cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice6cost_single_0(i) <= slice6cost_pixels_cost_0(i);
      end loop;
      -- slice6
      for i in 0 to 15 loop
        slice6_held(0, i) <= other(65 - 2 * i) / 4;
      end loop;
      for i in 0 to 15 loop
        slice6_held(1, i) <= slice6_held(0, i);
      end loop;
      -- slice7shift
      if slice0_tag_valid(0) then
        slice7shift_search_0(0) <= slice6shift_search_out_0;
        for i in 1 to 15 loop
          slice7shift_search_0(i) <= slice7shift_search_0(i - 1);
        end loop;
      end if;
      slice7shift_reference_0 <= slice6shift_reference_0;
      -- slice7cost
      slice7cost_pixels_first_0_0_count_value(0) := slice7shift_reference_0(2) = '1';
      slice7cost_pixels_first_0_0_count_value_2(0) := slice7shift_reference_0(1) = '1';
      slice7cost_pixels_first_0_0_count_value(1) := slice7shift_reference_0(3) = '1';
      slice7cost_pixels_first_0_0_count_value_2(1) := slice7shift_reference_0(5) = '1';
      slice7cost_pixels_first_0_0_count_1_value_3 := slice7shift_reference_0(4) = '1';
      slice7cost_pixels_first_0_0_count_value(2) := slice7shift_reference_0(8) = '1';
      slice7cost_pixels_first_0_0_count_value_2(2) := slice7shift_reference_0(6) = '1';
      for i in 3 to 13 loop
        slice7cost_pixels_first_0_0_count_value(i) := slice7shift_reference_0(3 * i) = '1';
        slice7cost_pixels_first_0_0_count_value_2(i) := slice7shift_reference_0(3 * i + 2) = '1';
        slice7cost_pixels_first_0_0_count_value_3(i) := slice7shift_reference_0(3 * i + 1) = '1';
      end loop;
      slice7cost_pixels_first_0_0_count_value(14) := slice7shift_reference_0(42) = '1';
      slice7cost_pixels_first_0_count(0, 0) <= as_number(((slice7shift_search_0(0)(0) = '1') /=
        (slice7shift_reference_0(0) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value(0) /=
        (slice7shift_search_0(0)(2) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value_2(0) /=
        (slice7shift_search_0(0)(1) = '1')));
      slice7cost_pixels_first_0_count(0, 1) <= as_number((slice7cost_pixels_first_0_0_count_value(1) /=
        (slice7shift_search_0(0)(3) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value_2(1) /=
        (slice7shift_search_0(0)(5) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_1_value_3 /=
        (slice7shift_search_0(0)(4) = '1')));
      slice7cost_pixels_first_0_count(0, 2) <= (to_integer(((to_unsigned(to_integer(slice7shift_search_0(0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice7shift_reference_0(7 downto 0)), 8)))) / 128) +
        as_number((slice7cost_pixels_first_0_0_count_value(2) /= (slice7shift_search_0(0)(8) = '1'))) +
        as_number((slice7cost_pixels_first_0_0_count_value_2(2) /= (slice7shift_search_0(0)(6) = '1')));
      for i in 3 to 13 loop
        slice7cost_pixels_first_0_count(0, i) <= as_number((slice7cost_pixels_first_0_0_count_value(i) /=
          (slice7shift_search_0(0)(3 * i) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value_2(i) /=
          (slice7shift_search_0(0)(3 * i + 2) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value_3(i) /=
          (slice7shift_search_0(0)(3 * i + 1) = '1')));
      end loop;
      slice7cost_pixels_first_0_count_14(0) <= as_number(((slice7shift_reference_0(43) = '1') /=
        (slice7shift_search_0(0)(43) = '1'))) + as_number((slice7cost_pixels_first_0_0_count_value(14) /=
        (slice7shift_search_0(0)(42) = '1')));
      for i in 1 to 15 loop
        slice7cost_pixels_first_0_count(i, 0) <= as_number(((slice7shift_search_0(i)(0) = '1') /=
          (slice7shift_reference_0(0) = '1'))) + as_number(((slice7shift_search_0(i)(2) = '1') /=
          slice7cost_pixels_first_0_0_count_value(0))) + as_number(((slice7shift_search_0(i)(1) = '1') /=
          slice7cost_pixels_first_0_0_count_value_2(0)));
        slice7cost_pixels_first_0_count(i, 1) <= as_number(((slice7shift_search_0(i)(3) = '1') /=
          slice7cost_pixels_first_0_0_count_value(1))) + as_number(((slice7shift_search_0(i)(5) = '1') /=
          slice7cost_pixels_first_0_0_count_value_2(1))) + as_number(((slice7shift_search_0(i)(4) = '1') /=
          slice7cost_pixels_first_0_0_count_1_value_3));
        slice7cost_pixels_first_0_count(i, 2) <= (to_integer(((to_unsigned(to_integer(slice7shift_search_0(i)(7 downto
          0)), 8)) xor (to_unsigned(to_integer(slice7shift_reference_0(7 downto 0)), 8)))) / 128) +
          as_number(((slice7shift_search_0(i)(8) = '1') /= slice7cost_pixels_first_0_0_count_value(2))) +
          as_number(((slice7shift_search_0(i)(6) = '1') /= slice7cost_pixels_first_0_0_count_value_2(2)));
        for j in 3 to 13 loop
          slice7cost_pixels_first_0_count(i, j) <= as_number(((slice7shift_search_0(i)(3 * j) = '1') /=
            slice7cost_pixels_first_0_0_count_value(j))) + as_number(((slice7shift_search_0(i)(3 * j + 2) = '1') /=
            slice7cost_pixels_first_0_0_count_value_2(j))) + as_number(((slice7shift_search_0(i)(3 * j + 1) = '1') /=
            slice7cost_pixels_first_0_0_count_value_3(j)));
        end loop;
        slice7cost_pixels_first_0_count_14(i) <= as_number(((slice7shift_search_0(i)(43) = '1') /=
          (slice7shift_reference_0(43) = '1'))) + as_number(((slice7shift_search_0(i)(42) = '1') /=
          slice7cost_pixels_first_0_0_count_value(14)));
      end loop;
      for i in 0 to 15 loop
        slice7cost_pixels_cost_0(i) <= slice7cost_pixels_first_0_count(i, 3) + slice7cost_pixels_first_0_count(i, 7) +
          slice7cost_pixels_first_0_count(i, 12) + slice7cost_pixels_first_0_count(i, 6) +
          slice7cost_pixels_first_0_count(i, 9) + slice7cost_pixels_first_0_count_14(i) +
          slice7cost_pixels_first_0_count(i, 11) + slice7cost_pixels_first_0_count(i, 2) +
          slice7cost_pixels_first_0_count(i, 10) + slice7cost_pixels_first_0_count(i, 4) +
          slice7cost_pixels_first_0_count(i, 8) + slice7cost_pixels_first_0_count(i, 1) +
          slice7cost_pixels_first_0_count(i, 5) + slice7cost_pixels_first_0_count(i, 0) +
          slice7cost_pixels_first_0_count(i, 13);
      end loop;
      for i in 0 to 15 loop
        slice7cost_single_0(i) <= slice7cost_pixels_cost_0(i);
      end loop;
      -- slice7
      for i in 0 to 15 loop
        slice7_held_0(i) <= other(33 - 2 * i) / 4;
      end loop;
      -- entry
      entry_order_falls_any := entry_next_tag_map_column or (not slice0_tag_map_column(7)) or (not slice0_tag_valid(7));
      entry_order_falls_all := (not entry_next_tag_map_column) and slice0_tag_map_column(7) and slice0_tag_valid(7);
      entry_order_complete_all := slice0_tag_map_column(7) and slice0_tag_valid(7);
      entry_order_complete_any := (not slice0_tag_map_column(7)) or (not slice0_tag_valid(7));
      if entry_order_falls_all then
        entry_order_turned_output_column_choice := entry_order_output and entry_order_complete;
      else
        entry_order_turned_output_column_choice := entry_order_held_output;
      end if;
      for i in 0 to 15 loop
        entry_next_cost(i) <= slice0_held(7, i);
      end loop;
      for i in 16 to 31 loop
        entry_next_cost(i) <= slice1_held(6, i - 16);
      end loop;
      for i in 32 to 47 loop
        entry_next_cost(i) <= slice2_held(5, i - 32);
      end loop;
      for i in 48 to 63 loop
        entry_next_cost(i) <= slice3_held(4, i - 48);
      end loop;
      for i in 64 to 79 loop
        entry_next_cost(i) <= slice4_held(3, i - 64);
      end loop;
      for i in 80 to 95 loop
        entry_next_cost(i) <= slice5_held(2, i - 80);
      end loop;
      for i in 96 to 111 loop
        entry_next_cost(i) <= slice6_held(1, i - 96);
      end loop;
      for i in 112 to 127 loop
        entry_next_cost(i) <= slice7_held_0(i - 112);
      end loop;
      entry_next_tag_valid <= slice0_tag_valid(7);
      entry_next_tag_first_cost <= slice0_tag_first_cost(7);
      entry_next_tag_end_of_line <= slice0_tag_end_of_line(7);
      entry_order_inside <= slice0_tag_map_column(7);
      entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(7);
      entry_order_turned_first_column <= entry_order_falls_all;
      entry_order_turned_start_of_frame <= (not entry_next_tag_map_column) and slice0_tag_map_column(7) and
        slice0_tag_valid(7) and entry_order_first and entry_order_output and entry_order_complete;
      for i in 0 to 127 loop
        entry_cost(i) <= entry_next_cost(i);
      end loop;
      entry_tag_valid <= entry_next_tag_valid;
      entry_tag_first_cost <= entry_next_tag_first_cost;
      entry_tag_map_column <= entry_order_inside;
      entry_tag_end_of_line <= entry_next_tag_end_of_line;
      entry_column <= entry_next_column;
      entry_top <= entry_next_top;
      entry_place <= entry_order_address;
      entry_turned_output_column <= entry_order_turned_output_column;
      entry_turned_first_column <= entry_order_turned_first_column;
      entry_turned_start_of_frame <= entry_order_turned_start_of_frame;
      if entry_order_falls then
        entry_order_falls <= entry_order_falls_any;
      else
        entry_order_falls <= entry_order_falls_all;
      end if;
      if slice0_tag_end_of_line(7) then
        entry_order_complete <= entry_order_complete or entry_order_complete_all;
      else
        entry_order_complete <= entry_order_complete and entry_order_complete_any;
      end if;
      if slice0_tag_valid(7) then
        entry_next_tag_map_column <= slice0_tag_map_column(7);
      end if;
      if entry_order_complete_all then
        if slice0_tag_first_cost(7) then
          entry_next_column <= 0;
          entry_next_top <= slice0_tag_start_of_frame(7);
        else
          entry_next_column <= (entry_next_column + 1) mod 1024;
          entry_next_top <= entry_next_top;
        end if;
      end if;
      if entry_order_falls then
        entry_order_address_choice := 1023;
      else
        entry_order_address_choice := 1;
      end if;
      if not entry_order_complete_any then
        if entry_order_falls_any then
          entry_order_address <= (entry_order_address_choice + entry_order_address) mod 1024;
        else
          entry_order_address <= as_number((not entry_order_falls)) * 512;
        end if;
      end if;
      if entry_order_falls_all then
        entry_order_output <= slice0_tag_output_column(7);
        entry_order_first <= slice0_tag_start_of_frame(7);
        entry_order_held_output <= entry_order_output and entry_order_complete;
      end if;
      -- forward
      for i in 0 to 15 loop
        for j in 2 to 3 loop
          if (forward_left_cost(8 * i + j) - forward_left_cost(8 * i + j - 2)) < 0 then
            forward_left_pair_choice(4 * i + j - 2) := forward_left_cost(8 * i + j);
          else
            forward_left_pair_choice(4 * i + j - 2) := forward_left_cost(8 * i + j - 2);
          end if;
        end loop;
        for j in 6 to 7 loop
          if (forward_left_cost(8 * i + j) - forward_left_cost(8 * i + j - 2)) < 0 then
            forward_left_pair_choice(4 * i + j - 4) := forward_left_cost(8 * i + j);
          else
            forward_left_pair_choice(4 * i + j - 4) := forward_left_cost(8 * i + j - 2);
          end if;
        end loop;
      end loop;
      forward_left_start_cost_0_value := (((forward_left_tree_next_next_next_next_next_smallest_0 mod 32) +
        forward_left_room) / 32) = 1;
      if forward_left_start_cost_0_value then
        forward_left_start_cost_0_choice := (((as_number(forward_left_start_cost_0_value) + 7) mod 8) * 32) +
          ((forward_left_tree_next_next_next_next_next_smallest_0 + forward_left_room) mod 32);
      else
        forward_left_start_cost_0_choice := 0;
      end if;
      if is_set(forward_left_tree_next_next_next_next_next_smallest_0, 5) then
        forward_left_start_cost_0_choice_2 := forward_left_room;
      else
        forward_left_start_cost_0_choice_2 := forward_left_start_cost_0_choice;
      end if;
      if forward_left_start_cost_0_value then
        forward_left_room_choice := (0 - forward_left_tree_next_next_next_next_next_smallest_0) mod 32;
      else
        forward_left_room_choice := forward_left_room;
      end if;
      if is_set(forward_left_tree_next_next_next_next_next_smallest_0, 5) then
        forward_left_room_choice_2 := 0;
      else
        forward_left_room_choice_2 := forward_left_room_choice;
      end if;
      forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_smallest_cost(0)) mod 64;
      forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 64;
      for i in 0 to 127 loop
        if (forward_left_arrived(i) - forward_left_cost(i)) < 0 then
          forward_left_cost_choice(i) := forward_left_arrived(i);
        else
          forward_left_cost_choice(i) := forward_left_cost(i);
        end if;
        if is_set(forward_left_cost_choice(i), 5) or forward_left_first(2) then
          forward_left_cost_choice_2(i) := 32;
        else
          forward_left_cost_choice_2(i) := forward_left_cost_choice(i);
        end if;
      end loop;
      if forward_left_first(2) then
        forward_left_arrived_choice(0) := 32;
      else
        forward_left_arrived_choice(0) := forward_left_cost(1);
      end if;
      for i in 1 to 2 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 1);
        end if;
      end loop;
      for i in 4 to 5 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2(i - 1) := 32;
        else
          forward_left_arrived_choice_2(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 3);
        end if;
      end loop;
      for i in 8 to 9 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s(i - 1) := 32;
        else
          forward_left_arrived_choice_2s(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 5);
        end if;
      end loop;
      for i in 12 to 13 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_11(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_11(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 7);
        end if;
      end loop;
      for i in 16 to 17 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_15(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_15(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 9);
        end if;
      end loop;
      for i in 20 to 21 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_19(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_19(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 11);
        end if;
      end loop;
      for i in 24 to 25 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_23(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_23(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 13);
        end if;
      end loop;
      for i in 28 to 29 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_27(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_27(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 15);
        end if;
      end loop;
      for i in 32 to 33 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_31(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_31(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 17);
        end if;
      end loop;
      for i in 36 to 37 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_35(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_35(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 19);
        end if;
      end loop;
      for i in 40 to 41 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_39(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_39(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 21);
        end if;
      end loop;
      for i in 44 to 45 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_43(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_43(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 23);
        end if;
      end loop;
      for i in 48 to 49 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_47(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_47(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 25);
        end if;
      end loop;
      for i in 52 to 53 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_51(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_51(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 27);
        end if;
      end loop;
      for i in 56 to 57 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_55(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_55(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 29);
        end if;
      end loop;
      for i in 60 to 61 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_59(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_59(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 31);
        end if;
      end loop;
      for i in 64 to 65 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_63(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_63(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 65 to 66 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 33);
        end if;
      end loop;
      for i in 68 to 69 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_67(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_67(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 69 to 70 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 35);
        end if;
      end loop;
      for i in 72 to 73 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_71(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_71(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 73 to 74 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 37);
        end if;
      end loop;
      for i in 76 to 77 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_75(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_75(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 77 to 78 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 39);
        end if;
      end loop;
      for i in 80 to 81 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_79(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_79(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 81 to 82 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 41);
        end if;
      end loop;
      for i in 84 to 85 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_83(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_83(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 85 to 86 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 43);
        end if;
      end loop;
      for i in 88 to 89 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_87(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_87(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 89 to 90 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 45);
        end if;
      end loop;
      for i in 92 to 93 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_91(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_91(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 93 to 94 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 47);
        end if;
      end loop;
      for i in 96 to 97 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_95(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_95(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 97 to 98 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 49);
        end if;
      end loop;
      for i in 100 to 101 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_99(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_99(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 101 to 102 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 51);
        end if;
      end loop;
      for i in 104 to 105 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_103(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_103(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 105 to 106 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 53);
        end if;
      end loop;
      for i in 108 to 109 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_107(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_107(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 109 to 110 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 55);
        end if;
      end loop;
      for i in 112 to 113 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_111(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_111(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 113 to 114 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 57);
        end if;
      end loop;
      for i in 116 to 117 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_115(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_115(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 117 to 118 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 59);
        end if;
      end loop;
      for i in 120 to 121 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_119(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_119(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 121 to 122 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 61);
        end if;
      end loop;
      for i in 124 to 125 loop
        if (forward_left_cost(i) - forward_left_cost(i - 2)) < 0 then
          forward_left_arrived_choice(i - 1) := forward_left_cost(i);
        else
          forward_left_arrived_choice(i - 1) := forward_left_cost(i - 2);
        end if;
        if forward_left_first(2) then
          forward_left_arrived_choice_2s_from_123(i - 1) := 32;
        else
          forward_left_arrived_choice_2s_from_123(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 125 to 126 loop
        if forward_left_first(2) then
          forward_left_arrived_choice(i) := 32;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 63);
        end if;
      end loop;
      if forward_left_first(2) then
        forward_left_arrived_choice(127) := 32;
      else
        forward_left_arrived_choice(127) := forward_left_cost(126);
      end if;
      for i in 0 to 9 loop
        for j in 0 to 5 loop
          if forward_above_ready_top then
            forward_above_total_choice(12 * i + j) := 24;
          else
            forward_above_total_choice(12 * i + j) := to_integer(forward_above_ready_words(2 * i)(5 * j + 4 downto 5 *
              j));
          end if;
        end loop;
        for j in 6 to 11 loop
          if forward_above_ready_top then
            forward_above_total_choice(12 * i + j) := 24;
          else
            forward_above_total_choice(12 * i + j) := to_integer(forward_above_ready_words(2 * i + 1)(5 * j - 26 downto
              5 * j - 30));
          end if;
        end loop;
      end loop;
      for i in 120 to 125 loop
        if forward_above_ready_top then
          forward_above_total_choice(i) := 24;
        else
          forward_above_total_choice(i) := to_integer(forward_above_ready_words(20)(5 * i - 596 downto 5 * i - 600));
        end if;
      end loop;
      if forward_above_ready_top then
        forward_above_total_choice(126) := 24;
      else
        forward_above_total_choice(126) := forward_above_ready_words_21 mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(127) := 24;
      else
        forward_above_total_choice(127) := (forward_above_ready_words_21 / 32) mod 32;
      end if;
      if entry_tag_valid then
        forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
        for i in 0 to 63 loop
          forward_left_pair(i) <= forward_left_pair_choice(i);
        end loop;
        forward_left_smallest <= forward_smallest_next_next_next_next_next_next_smallest_0;
        forward_left_smallest_less <= ((((forward_smallest_next_next_next_next_next_next_smallest_0 / 4) + 15) mod 16)
          * 4) + (forward_smallest_next_next_next_next_next_next_smallest_0 mod 4);
        forward_left_first(0) <= forward_first(6);
        forward_left_first(1) <= forward_left_first(0);
        forward_left_first(2) <= forward_left_first(1);
        for i in 0 to 7 loop
          forward_left_g_copy(i) <= forward_left_g_copy_0_value;
        end loop;
        for i in 0 to 7 loop
          forward_left_g_less_copy(i) <= forward_left_g_less_copy_0_value;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 15 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i)) mod 64;
          end loop;
          for j in 16 to 31 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i + 1)) mod
              64;
          end loop;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 15 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i)) mod
              64;
          end loop;
          for j in 16 to 31 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i + 1))
              mod 64;
          end loop;
        end loop;
        for i in 0 to 127 loop
          forward_left_cost(i) <= (forward_left_cost_choice_2(i) + forward_left_stay_change(i)) mod 64;
        end loop;
        for i in 0 to 2 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 64;
        end loop;
        forward_left_arrived(3) <= (forward_left_arrived_choice_2(3) + forward_left_step_change(3)) mod 64;
        forward_left_arrived(4) <= (forward_left_arrived_choice_2(4) + forward_left_step_change(4)) mod 64;
        forward_left_arrived(5) <= (forward_left_arrived_choice(5) + forward_left_step_change(5)) mod 64;
        forward_left_arrived(6) <= (forward_left_arrived_choice(6) + forward_left_step_change(6)) mod 64;
        forward_left_arrived(7) <= (forward_left_arrived_choice_2s(7) + forward_left_step_change(7)) mod 64;
        forward_left_arrived(8) <= (forward_left_arrived_choice_2s(8) + forward_left_step_change(8)) mod 64;
        forward_left_arrived(9) <= (forward_left_arrived_choice(9) + forward_left_step_change(9)) mod 64;
        forward_left_arrived(10) <= (forward_left_arrived_choice(10) + forward_left_step_change(10)) mod 64;
        forward_left_arrived(11) <= (forward_left_arrived_choice_2s_from_11(11) + forward_left_step_change(11)) mod 64;
        forward_left_arrived(12) <= (forward_left_arrived_choice_2s_from_11(12) + forward_left_step_change(12)) mod 64;
        forward_left_arrived(13) <= (forward_left_arrived_choice(13) + forward_left_step_change(13)) mod 64;
        forward_left_arrived(14) <= (forward_left_arrived_choice(14) + forward_left_step_change(14)) mod 64;
        forward_left_arrived(15) <= (forward_left_arrived_choice_2s_from_15(15) + forward_left_step_change(15)) mod 64;
        forward_left_arrived(16) <= (forward_left_arrived_choice_2s_from_15(16) + forward_left_step_change(16)) mod 64;
        forward_left_arrived(17) <= (forward_left_arrived_choice(17) + forward_left_step_change(17)) mod 64;
        forward_left_arrived(18) <= (forward_left_arrived_choice(18) + forward_left_step_change(18)) mod 64;
        forward_left_arrived(19) <= (forward_left_arrived_choice_2s_from_19(19) + forward_left_step_change(19)) mod 64;
        forward_left_arrived(20) <= (forward_left_arrived_choice_2s_from_19(20) + forward_left_step_change(20)) mod 64;
        forward_left_arrived(21) <= (forward_left_arrived_choice(21) + forward_left_step_change(21)) mod 64;
        forward_left_arrived(22) <= (forward_left_arrived_choice(22) + forward_left_step_change(22)) mod 64;
        forward_left_arrived(23) <= (forward_left_arrived_choice_2s_from_23(23) + forward_left_step_change(23)) mod 64;
        forward_left_arrived(24) <= (forward_left_arrived_choice_2s_from_23(24) + forward_left_step_change(24)) mod 64;
        forward_left_arrived(25) <= (forward_left_arrived_choice(25) + forward_left_step_change(25)) mod 64;
        forward_left_arrived(26) <= (forward_left_arrived_choice(26) + forward_left_step_change(26)) mod 64;
        forward_left_arrived(27) <= (forward_left_arrived_choice_2s_from_27(27) + forward_left_step_change(27)) mod 64;
        forward_left_arrived(28) <= (forward_left_arrived_choice_2s_from_27(28) + forward_left_step_change(28)) mod 64;
        forward_left_arrived(29) <= (forward_left_arrived_choice(29) + forward_left_step_change(29)) mod 64;
        forward_left_arrived(30) <= (forward_left_arrived_choice(30) + forward_left_step_change(30)) mod 64;
        forward_left_arrived(31) <= (forward_left_arrived_choice_2s_from_31(31) + forward_left_step_change(31)) mod 64;
        forward_left_arrived(32) <= (forward_left_arrived_choice_2s_from_31(32) + forward_left_step_change(32)) mod 64;
        forward_left_arrived(33) <= (forward_left_arrived_choice(33) + forward_left_step_change(33)) mod 64;
        forward_left_arrived(34) <= (forward_left_arrived_choice(34) + forward_left_step_change(34)) mod 64;
        forward_left_arrived(35) <= (forward_left_arrived_choice_2s_from_35(35) + forward_left_step_change(35)) mod 64;
        forward_left_arrived(36) <= (forward_left_arrived_choice_2s_from_35(36) + forward_left_step_change(36)) mod 64;
        forward_left_arrived(37) <= (forward_left_arrived_choice(37) + forward_left_step_change(37)) mod 64;
        forward_left_arrived(38) <= (forward_left_arrived_choice(38) + forward_left_step_change(38)) mod 64;
        forward_left_arrived(39) <= (forward_left_arrived_choice_2s_from_39(39) + forward_left_step_change(39)) mod 64;
        forward_left_arrived(40) <= (forward_left_arrived_choice_2s_from_39(40) + forward_left_step_change(40)) mod 64;
        forward_left_arrived(41) <= (forward_left_arrived_choice(41) + forward_left_step_change(41)) mod 64;
        forward_left_arrived(42) <= (forward_left_arrived_choice(42) + forward_left_step_change(42)) mod 64;
        forward_left_arrived(43) <= (forward_left_arrived_choice_2s_from_43(43) + forward_left_step_change(43)) mod 64;
        forward_left_arrived(44) <= (forward_left_arrived_choice_2s_from_43(44) + forward_left_step_change(44)) mod 64;
        forward_left_arrived(45) <= (forward_left_arrived_choice(45) + forward_left_step_change(45)) mod 64;
        forward_left_arrived(46) <= (forward_left_arrived_choice(46) + forward_left_step_change(46)) mod 64;
        forward_left_arrived(47) <= (forward_left_arrived_choice_2s_from_47(47) + forward_left_step_change(47)) mod 64;
        forward_left_arrived(48) <= (forward_left_arrived_choice_2s_from_47(48) + forward_left_step_change(48)) mod 64;
        forward_left_arrived(49) <= (forward_left_arrived_choice(49) + forward_left_step_change(49)) mod 64;
        forward_left_arrived(50) <= (forward_left_arrived_choice(50) + forward_left_step_change(50)) mod 64;
        forward_left_arrived(51) <= (forward_left_arrived_choice_2s_from_51(51) + forward_left_step_change(51)) mod 64;
        forward_left_arrived(52) <= (forward_left_arrived_choice_2s_from_51(52) + forward_left_step_change(52)) mod 64;
        forward_left_arrived(53) <= (forward_left_arrived_choice(53) + forward_left_step_change(53)) mod 64;
        forward_left_arrived(54) <= (forward_left_arrived_choice(54) + forward_left_step_change(54)) mod 64;
        forward_left_arrived(55) <= (forward_left_arrived_choice_2s_from_55(55) + forward_left_step_change(55)) mod 64;
        forward_left_arrived(56) <= (forward_left_arrived_choice_2s_from_55(56) + forward_left_step_change(56)) mod 64;
        forward_left_arrived(57) <= (forward_left_arrived_choice(57) + forward_left_step_change(57)) mod 64;
        forward_left_arrived(58) <= (forward_left_arrived_choice(58) + forward_left_step_change(58)) mod 64;
        forward_left_arrived(59) <= (forward_left_arrived_choice_2s_from_59(59) + forward_left_step_change(59)) mod 64;
        forward_left_arrived(60) <= (forward_left_arrived_choice_2s_from_59(60) + forward_left_step_change(60)) mod 64;
        forward_left_arrived(61) <= (forward_left_arrived_choice(61) + forward_left_step_change(61)) mod 64;
        forward_left_arrived(62) <= (forward_left_arrived_choice(62) + forward_left_step_change(62)) mod 64;
        forward_left_arrived(63) <= (forward_left_arrived_choice_2s_from_63(63) + forward_left_step_change(63)) mod 64;
        forward_left_arrived(64) <= (forward_left_arrived_choice_2s_from_63(64) + forward_left_step_change(64)) mod 64;
        forward_left_arrived(65) <= (forward_left_arrived_choice(65) + forward_left_step_change(65)) mod 64;
        forward_left_arrived(66) <= (forward_left_arrived_choice(66) + forward_left_step_change(66)) mod 64;
        forward_left_arrived(67) <= (forward_left_arrived_choice_2s_from_67(67) + forward_left_step_change(67)) mod 64;
        forward_left_arrived(68) <= (forward_left_arrived_choice_2s_from_67(68) + forward_left_step_change(68)) mod 64;
        forward_left_arrived(69) <= (forward_left_arrived_choice(69) + forward_left_step_change(69)) mod 64;
        forward_left_arrived(70) <= (forward_left_arrived_choice(70) + forward_left_step_change(70)) mod 64;
        forward_left_arrived(71) <= (forward_left_arrived_choice_2s_from_71(71) + forward_left_step_change(71)) mod 64;
        forward_left_arrived(72) <= (forward_left_arrived_choice_2s_from_71(72) + forward_left_step_change(72)) mod 64;
        forward_left_arrived(73) <= (forward_left_arrived_choice(73) + forward_left_step_change(73)) mod 64;
        forward_left_arrived(74) <= (forward_left_arrived_choice(74) + forward_left_step_change(74)) mod 64;
        forward_left_arrived(75) <= (forward_left_arrived_choice_2s_from_75(75) + forward_left_step_change(75)) mod 64;
        forward_left_arrived(76) <= (forward_left_arrived_choice_2s_from_75(76) + forward_left_step_change(76)) mod 64;
        forward_left_arrived(77) <= (forward_left_arrived_choice(77) + forward_left_step_change(77)) mod 64;
        forward_left_arrived(78) <= (forward_left_arrived_choice(78) + forward_left_step_change(78)) mod 64;
        forward_left_arrived(79) <= (forward_left_arrived_choice_2s_from_79(79) + forward_left_step_change(79)) mod 64;
        forward_left_arrived(80) <= (forward_left_arrived_choice_2s_from_79(80) + forward_left_step_change(80)) mod 64;
        forward_left_arrived(81) <= (forward_left_arrived_choice(81) + forward_left_step_change(81)) mod 64;
        forward_left_arrived(82) <= (forward_left_arrived_choice(82) + forward_left_step_change(82)) mod 64;
        forward_left_arrived(83) <= (forward_left_arrived_choice_2s_from_83(83) + forward_left_step_change(83)) mod 64;
        forward_left_arrived(84) <= (forward_left_arrived_choice_2s_from_83(84) + forward_left_step_change(84)) mod 64;
        forward_left_arrived(85) <= (forward_left_arrived_choice(85) + forward_left_step_change(85)) mod 64;
        forward_left_arrived(86) <= (forward_left_arrived_choice(86) + forward_left_step_change(86)) mod 64;
        forward_left_arrived(87) <= (forward_left_arrived_choice_2s_from_87(87) + forward_left_step_change(87)) mod 64;
        forward_left_arrived(88) <= (forward_left_arrived_choice_2s_from_87(88) + forward_left_step_change(88)) mod 64;
        forward_left_arrived(89) <= (forward_left_arrived_choice(89) + forward_left_step_change(89)) mod 64;
        forward_left_arrived(90) <= (forward_left_arrived_choice(90) + forward_left_step_change(90)) mod 64;
        forward_left_arrived(91) <= (forward_left_arrived_choice_2s_from_91(91) + forward_left_step_change(91)) mod 64;
        forward_left_arrived(92) <= (forward_left_arrived_choice_2s_from_91(92) + forward_left_step_change(92)) mod 64;
        forward_left_arrived(93) <= (forward_left_arrived_choice(93) + forward_left_step_change(93)) mod 64;
        forward_left_arrived(94) <= (forward_left_arrived_choice(94) + forward_left_step_change(94)) mod 64;
        forward_left_arrived(95) <= (forward_left_arrived_choice_2s_from_95(95) + forward_left_step_change(95)) mod 64;
        forward_left_arrived(96) <= (forward_left_arrived_choice_2s_from_95(96) + forward_left_step_change(96)) mod 64;
        forward_left_arrived(97) <= (forward_left_arrived_choice(97) + forward_left_step_change(97)) mod 64;
        forward_left_arrived(98) <= (forward_left_arrived_choice(98) + forward_left_step_change(98)) mod 64;
        forward_left_arrived(99) <= (forward_left_arrived_choice_2s_from_99(99) + forward_left_step_change(99)) mod 64;
        forward_left_arrived(100) <= (forward_left_arrived_choice_2s_from_99(100) + forward_left_step_change(100)) mod
          64;
        forward_left_arrived(101) <= (forward_left_arrived_choice(101) + forward_left_step_change(101)) mod 64;
        forward_left_arrived(102) <= (forward_left_arrived_choice(102) + forward_left_step_change(102)) mod 64;
        forward_left_arrived(103) <= (forward_left_arrived_choice_2s_from_103(103) + forward_left_step_change(103)) mod
          64;
        forward_left_arrived(104) <= (forward_left_arrived_choice_2s_from_103(104) + forward_left_step_change(104)) mod
          64;
        forward_left_arrived(105) <= (forward_left_arrived_choice(105) + forward_left_step_change(105)) mod 64;
        forward_left_arrived(106) <= (forward_left_arrived_choice(106) + forward_left_step_change(106)) mod 64;
        forward_left_arrived(107) <= (forward_left_arrived_choice_2s_from_107(107) + forward_left_step_change(107)) mod
          64;
        forward_left_arrived(108) <= (forward_left_arrived_choice_2s_from_107(108) + forward_left_step_change(108)) mod
          64;
        forward_left_arrived(109) <= (forward_left_arrived_choice(109) + forward_left_step_change(109)) mod 64;
        forward_left_arrived(110) <= (forward_left_arrived_choice(110) + forward_left_step_change(110)) mod 64;
        forward_left_arrived(111) <= (forward_left_arrived_choice_2s_from_111(111) + forward_left_step_change(111)) mod
          64;
        forward_left_arrived(112) <= (forward_left_arrived_choice_2s_from_111(112) + forward_left_step_change(112)) mod
          64;
        forward_left_arrived(113) <= (forward_left_arrived_choice(113) + forward_left_step_change(113)) mod 64;
        forward_left_arrived(114) <= (forward_left_arrived_choice(114) + forward_left_step_change(114)) mod 64;
        forward_left_arrived(115) <= (forward_left_arrived_choice_2s_from_115(115) + forward_left_step_change(115)) mod
          64;
        forward_left_arrived(116) <= (forward_left_arrived_choice_2s_from_115(116) + forward_left_step_change(116)) mod
          64;
        forward_left_arrived(117) <= (forward_left_arrived_choice(117) + forward_left_step_change(117)) mod 64;
        forward_left_arrived(118) <= (forward_left_arrived_choice(118) + forward_left_step_change(118)) mod 64;
        forward_left_arrived(119) <= (forward_left_arrived_choice_2s_from_119(119) + forward_left_step_change(119)) mod
          64;
        forward_left_arrived(120) <= (forward_left_arrived_choice_2s_from_119(120) + forward_left_step_change(120)) mod
          64;
        forward_left_arrived(121) <= (forward_left_arrived_choice(121) + forward_left_step_change(121)) mod 64;
        forward_left_arrived(122) <= (forward_left_arrived_choice(122) + forward_left_step_change(122)) mod 64;
        forward_left_arrived(123) <= (forward_left_arrived_choice_2s_from_123(123) + forward_left_step_change(123)) mod
          64;
        forward_left_arrived(124) <= (forward_left_arrived_choice_2s_from_123(124) + forward_left_step_change(124)) mod
          64;
        for i in 125 to 127 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 64;
        end loop;
        for i in 0 to 20 loop
          forward_above_ready_words(i) <= forward_above_read_words(i);
        end loop;
        forward_above_ready_words_21 <= to_integer(forward_above_read_words_21);
        for i in 0 to 127 loop
          forward_above_ready_cost(i) <= entry_cost(i);
        end loop;
        forward_above_ready_top <= entry_top;
        for i in 0 to 127 loop
          forward_above_total(i) <= forward_above_total_choice(i) + forward_above_ready_cost(i);
        end loop;
        forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
        for i in 0 to 7 loop
          forward_above_smallest_copy(i) <= forward_above_tree_next_next_next_next_next_next_smallest_0;
        end loop;
        for i in 0 to 2 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(0)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(0)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(0)) mod 64;
        end loop;
        for i in 3 to 4 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 3))
            mod 64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(1)) mod 64;
        end loop;
        for i in 5 to 6 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(1)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(1)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(i - 4)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(i - 4)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(i - 4)) mod 64;
        end loop;
        for i in 7 to 8 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(2)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(2)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(2)) mod 64;
        end loop;
        for i in 9 to 10 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 7))
            mod 64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(i - 7)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(i - 7)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(3)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(3)) mod 64;
        end loop;
        for i in 11 to 12 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(3)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(3)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(3)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(3)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(i - 8)) mod 64;
        end loop;
        for i in 4 to 5 loop
          for j in 1 to 3 loop
            forward_above_cost(15 * i + 5 * j) <= (to_integer(forward_above_delay_held(3 * i + j)) -
              forward_above_smallest_copy(i)) mod 64;
            forward_above_cost(15 * i + 5 * j + 1) <= (to_integer(forward_above_delay_held(3 * i + j)(29 downto 6)) -
              forward_above_smallest_copy(i)) mod 64;
            forward_above_cost(15 * i + 5 * j + 2) <= (to_integer(forward_above_delay_held(3 * i + j)(29 downto 12)) -
              forward_above_smallest_copy(i)) mod 64;
            forward_above_cost(15 * i + 5 * j + 3) <= (to_integer(forward_above_delay_held(3 * i + j)(29 downto 18)) -
              forward_above_smallest_copy(i)) mod 64;
            forward_above_cost(15 * i + 5 * j + 4) <= (to_integer(forward_above_delay_held(3 * i + j)(29 downto 24)) -
              forward_above_smallest_copy(i)) mod 64;
          end loop;
        end loop;
        for i in 19 to 20 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 14))
            mod 64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(6)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(6)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(6)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(6)) mod 64;
        end loop;
        for i in 21 to 22 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(6)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(6)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(i - 15)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(i - 15)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(i - 15)) mod 64;
        end loop;
        for i in 23 to 24 loop
          forward_above_cost(5 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(7)) mod
            64;
          forward_above_cost(5 * i + 1) <= (to_integer(forward_above_delay_held(i)(29 downto 6)) -
            forward_above_smallest_copy(7)) mod 64;
          forward_above_cost(5 * i + 2) <= (to_integer(forward_above_delay_held(i)(29 downto 12)) -
            forward_above_smallest_copy(7)) mod 64;
          forward_above_cost(5 * i + 3) <= (to_integer(forward_above_delay_held(i)(29 downto 18)) -
            forward_above_smallest_copy(7)) mod 64;
          forward_above_cost(5 * i + 4) <= (to_integer(forward_above_delay_held(i)(29 downto 24)) -
            forward_above_smallest_copy(7)) mod 64;
        end loop;
        forward_above_cost(125) <= (to_integer(forward_above_delay_held_25) - forward_above_smallest_copy(7)) mod 64;
        forward_above_cost(126) <= (to_integer(forward_above_delay_held_25(17 downto 6)) -
          forward_above_smallest_copy(7)) mod 64;
        forward_above_cost(127) <= (to_integer(forward_above_delay_held_25(17 downto 12)) -
          forward_above_smallest_copy(7)) mod 64;
        forward_above_beside(0) <= forward_above_cost(1);
        forward_above_beside(127) <= forward_above_cost(126);
        forward_above_own_0 <= forward_above_cost(0);
        for i in 2 to 125 loop
          forward_above_own(i) <= forward_above_cost(i);
        end loop;
        forward_above_own_127 <= forward_above_cost(127);
        for i in 0 to 127 loop
          forward_above_step(i) <= (((forward_above_beside(i) / 4) + 1) * 4) + (forward_above_beside(i) mod 4);
        end loop;
        forward_above_comes(0) <= entry_tag_map_column;
        for i in 1 to 12 loop
          forward_above_comes(i) <= forward_above_comes(i - 1);
        end loop;
        forward_above_column(0) <= entry_column;
        for i in 1 to 12 loop
          forward_above_column(i) <= forward_above_column(i - 1);
        end loop;
        for i in 0 to 127 loop
          forward_sum(i) <= forward_left_cost(i) + forward_above_cost(i);
        end loop;
        forward_first(0) <= entry_turned_first_column;
        forward_first(1) <= forward_first(0);
        forward_first(2) <= forward_first(1);
        forward_first(3) <= forward_first(2);
        forward_first(4) <= sums_right_first(2);
        forward_first(5) <= forward_first(4);
        forward_first(6) <= forward_first(5);
        for i in 0 to 15 loop
          forward_cost(0, 8 * i) <= to_integer(forward_cost_delay_held(i)(3 downto 0));
          forward_cost(0, 8 * i + 1) <= to_integer(forward_cost_delay_held(i)(7 downto 0)) / 16;
          for j in 2 to 7 loop
            forward_cost(0, 8 * i + j) <= to_integer(forward_cost_delay_held(i)(4 * j + 3 downto 4 * j));
          end loop;
        end loop;
        for i in 1 to 3 loop
          for j in 0 to 127 loop
            forward_cost(i, j) <= forward_cost(i - 1, j);
          end loop;
        end loop;
        forward_smallest_cost(0) <= forward_smallest_next_next_next_next_next_next_smallest_0;
        forward_smallest_cost(1) <= forward_left_smallest;
        forward_smallest_cost(2) <= forward_smallest_cost(1);
        forward_smallest_cost(3) <= forward_smallest_cost(2);
        forward_smallest_cost(4) <= forward_smallest_cost(3);
        for i in 0 to 63 loop
          if (entry_cost(2 * i + 1) - entry_cost(2 * i)) < 0 then
            forward_smallest_smallest(i) <= entry_cost(2 * i + 1);
          else
            forward_smallest_smallest(i) <= entry_cost(2 * i);
          end if;
        end loop;
        for i in 0 to 31 loop
          if (forward_smallest_smallest(2 * i + 1) - forward_smallest_smallest(2 * i)) < 0 then
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i + 1);
          else
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_smallest_next_smallest(2 * i + 1) - forward_smallest_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_smallest_next_next_smallest(2 * i + 1) - forward_smallest_next_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_smallest_next_next_next_smallest(2 * i + 1) - forward_smallest_next_next_next_smallest(2 * i)) <
            0 then
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_smallest_next_next_next_next_smallest(2 * i + 1) -
            forward_smallest_next_next_next_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_next_smallest(2 *
              i + 1);
          else
            forward_smallest_next_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_next_smallest(2 *
              i);
          end if;
        end loop;
        if (forward_smallest_next_next_next_next_next_smallest(1) -
          forward_smallest_next_next_next_next_next_smallest(0)) < 0 then
          forward_smallest_next_next_next_next_next_next_smallest_0 <=
            forward_smallest_next_next_next_next_next_smallest(1);
        else
          forward_smallest_next_next_next_next_next_next_smallest_0 <=
            forward_smallest_next_next_next_next_next_smallest(0);
        end if;
        if forward_cost_delay_ring_read_address = 7 then
          forward_cost_delay_ring_read_address <= 0;
        else
          forward_cost_delay_ring_read_address <= (forward_cost_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 0 to 31 loop
          if (forward_left_pair(2 * i + 1) - forward_left_pair(2 * i)) < 0 then
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i + 1);
          else
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_left_tree_smallest(2 * i + 1) - forward_left_tree_smallest(2 * i)) < 0 then
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i + 1);
          else
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_left_tree_next_smallest(2 * i + 1) - forward_left_tree_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_left_tree_next_next_smallest(2 * i + 1) - forward_left_tree_next_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_left_tree_next_next_next_smallest(2 * i + 1) - forward_left_tree_next_next_next_smallest(2 * i))
            < 0 then
            forward_left_tree_next_next_next_next_smallest(i) <= forward_left_tree_next_next_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_next_next_smallest(i) <= forward_left_tree_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_left_tree_next_next_next_next_smallest(1) - forward_left_tree_next_next_next_next_smallest(0)) < 0
          then
          forward_left_tree_next_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_next_smallest(1);
        else
          forward_left_tree_next_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_next_smallest(0);
        end if;
        if forward_first(6) then
          forward_left_start_cost(0) <= 24;
          for i in 1 to 9 loop
            forward_left_start_cost(i) <= 0;
          end loop;
          forward_left_room <= 0;
        else
          forward_left_start_cost(0) <= forward_left_start_cost_0_choice_2;
          for i in 1 to 9 loop
            forward_left_start_cost(i) <= forward_left_start_cost(i - 1);
          end loop;
          forward_left_room <= (forward_left_room_choice_2 + forward_left_start_cost(9)) mod 32;
        end if;
        for i in 0 to 63 loop
          if (forward_above_total(2 * i + 1) - forward_above_total(2 * i)) < 0 then
            forward_above_tree_smallest(i) <= forward_above_total(2 * i + 1);
          else
            forward_above_tree_smallest(i) <= forward_above_total(2 * i);
          end if;
        end loop;
        for i in 0 to 31 loop
          if (forward_above_tree_smallest(2 * i + 1) - forward_above_tree_smallest(2 * i)) < 0 then
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i + 1);
          else
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_above_tree_next_smallest(2 * i + 1) - forward_above_tree_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_above_tree_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_above_tree_next_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_next_smallest(2 *
            i)) < 0 then
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_above_tree_next_next_next_next_smallest(2 * i + 1) -
            forward_above_tree_next_next_next_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_next_next_next_smallest(i) <=
              forward_above_tree_next_next_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_next_next_smallest(i) <=
              forward_above_tree_next_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_above_tree_next_next_next_next_next_smallest(1) -
          forward_above_tree_next_next_next_next_next_smallest(0)) < 0 then
          forward_above_tree_next_next_next_next_next_next_smallest_0 <=
            forward_above_tree_next_next_next_next_next_smallest(1);
        else
          forward_above_tree_next_next_next_next_next_next_smallest_0 <=
            forward_above_tree_next_next_next_next_next_smallest(0);
        end if;
        if forward_above_delay_ring_read_address = 7 then
          forward_above_delay_ring_read_address <= 0;
        else
          forward_above_delay_ring_read_address <= (forward_above_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 2 to 127 loop
          if (forward_above_cost(i) - forward_above_cost(i - 2)) < 0 then
            forward_above_beside(i - 1) <= forward_above_cost(i);
          else
            forward_above_beside(i - 1) <= forward_above_cost(i - 2);
          end if;
        end loop;
        if forward_above_own_0 < 24 then
          forward_above_stay(0) <= forward_above_own_0 mod 32;
        else
          forward_above_stay(0) <= 24;
        end if;
        if forward_above_beside(0) < 24 then
          forward_above_stay(1) <= forward_above_beside(0) mod 32;
        else
          forward_above_stay(1) <= 24;
        end if;
        for i in 2 to 125 loop
          if forward_above_own(i) < 24 then
            forward_above_stay(i) <= forward_above_own(i) mod 32;
          else
            forward_above_stay(i) <= 24;
          end if;
        end loop;
        if forward_above_beside(127) < 24 then
          forward_above_stay(126) <= forward_above_beside(127) mod 32;
        else
          forward_above_stay(126) <= 24;
        end if;
        if forward_above_own_127 < 24 then
          forward_above_stay(127) <= forward_above_own_127 mod 32;
        else
          forward_above_stay(127) <= 24;
        end if;
      end if;
      if forward_above_comes(12) then
        forward_above_writes_copy_0 <= entry_next_tag_valid and (forward_above_comes(11) or (not entry_tag_valid));
      else
        forward_above_writes_copy_0 <= entry_next_tag_valid and forward_above_comes(11) and entry_tag_valid;
      end if;
      for i in 0 to 20 loop
        if (forward_above_step(6 * i + 4) - forward_above_stay(6 * i + 4)) < 0 then
          forward_above_write_words_choice(i) := forward_above_step(6 * i + 4);
        else
          forward_above_write_words_choice(i) := forward_above_stay(6 * i + 4);
        end if;
        for j in 2 to 3 loop
          if (forward_above_step(6 * i + 9 - 2 * j) - forward_above_stay(6 * i + 9 - 2 * j)) < 0 then
            forward_above_write_words_choices(i, j) := forward_above_step(6 * i + 9 - 2 * j);
          else
            forward_above_write_words_choices(i, j) := forward_above_stay(6 * i + 9 - 2 * j);
          end if;
        end loop;
        for j in 4 to 5 loop
          if (forward_above_step(6 * i + 10 - 2 * j) - forward_above_stay(6 * i + 10 - 2 * j)) < 0 then
            forward_above_write_words_choices(i, j) := forward_above_step(6 * i + 10 - 2 * j);
          else
            forward_above_write_words_choices(i, j) := forward_above_stay(6 * i + 10 - 2 * j);
          end if;
        end loop;
        if (forward_above_step(6 * i + 1) - forward_above_stay(6 * i + 1)) < 0 then
          forward_above_write_words_choices(i, 6) := forward_above_step(6 * i + 1);
        else
          forward_above_write_words_choices(i, 6) := forward_above_stay(6 * i + 1);
        end if;
      end loop;
      if (forward_above_step(127) - forward_above_stay(127)) < 0 then
        forward_above_write_words_choice(21) := forward_above_step(127);
      else
        forward_above_write_words_choice(21) := forward_above_stay(127);
      end if;
      if (forward_above_step(126) - forward_above_stay(126)) < 0 then
        forward_above_write_words_21_choice_2 := forward_above_step(126);
      else
        forward_above_write_words_21_choice_2 := forward_above_stay(126);
      end if;
      if forward_above_writes_copy_0 then
        for i in 0 to 20 loop
          forward_above_write_words(i) <= ((((((((((to_unsigned(forward_above_write_words_choice(i), 12) &
            to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choices(i, 2), 7) & to_unsigned(0, 25)))) or
            (to_unsigned(forward_above_write_words_choices(i, 3), 17) & to_unsigned(0, 15)))) or
            (to_unsigned(forward_above_write_words_choices(i, 4), 22) & to_unsigned(0, 10)))) or
            (to_unsigned(forward_above_write_words_choices(i, 5), 32)))) or
            (to_unsigned(forward_above_write_words_choices(i, 6), 27) & to_unsigned(0, 5)));
        end loop;
        forward_above_write_words_21 <= to_integer(((to_unsigned(forward_above_write_words_choice(21), 7) &
          to_unsigned(0, 5)) or (to_unsigned(forward_above_write_words_21_choice_2, 12))));
        forward_above_write_column <= forward_above_column(12);
      end if;
      -- sums
      for i in 0 to 15 loop
        for j in 2 to 3 loop
          if (sums_right_cost(8 * i + j) - sums_right_cost(8 * i + j - 2)) < 0 then
            sums_right_pair_choice(4 * i + j - 2) := sums_right_cost(8 * i + j);
          else
            sums_right_pair_choice(4 * i + j - 2) := sums_right_cost(8 * i + j - 2);
          end if;
        end loop;
        for j in 6 to 7 loop
          if (sums_right_cost(8 * i + j) - sums_right_cost(8 * i + j - 2)) < 0 then
            sums_right_pair_choice(4 * i + j - 4) := sums_right_cost(8 * i + j);
          else
            sums_right_pair_choice(4 * i + j - 4) := sums_right_cost(8 * i + j - 2);
          end if;
        end loop;
      end loop;
      sums_right_start_cost_0_value := (((sums_right_tree_next_next_next_next_next_smallest_0 mod 32) +
        sums_right_room) / 32) = 1;
      if sums_right_start_cost_0_value then
        sums_right_start_cost_0_choice := (((as_number(sums_right_start_cost_0_value) + 7) mod 8) * 32) +
          ((sums_right_tree_next_next_next_next_next_smallest_0 + sums_right_room) mod 32);
      else
        sums_right_start_cost_0_choice := 0;
      end if;
      if is_set(sums_right_tree_next_next_next_next_next_smallest_0, 5) then
        sums_right_start_cost_0_choice_2 := sums_right_room;
      else
        sums_right_start_cost_0_choice_2 := sums_right_start_cost_0_choice;
      end if;
      if sums_right_start_cost_0_value then
        sums_right_room_choice := (0 - sums_right_tree_next_next_next_next_next_smallest_0) mod 32;
      else
        sums_right_room_choice := sums_right_room;
      end if;
      if is_set(sums_right_tree_next_next_next_next_next_smallest_0, 5) then
        sums_right_room_choice_2 := 0;
      else
        sums_right_room_choice_2 := sums_right_room_choice;
      end if;
      sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 64;
      sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 64;
      for i in 0 to 127 loop
        if (sums_right_arrived(i) - sums_right_cost(i)) < 0 then
          sums_right_cost_choice(i) := sums_right_arrived(i);
        else
          sums_right_cost_choice(i) := sums_right_cost(i);
        end if;
        if is_set(sums_right_cost_choice(i), 5) or forward_first(3) then
          sums_right_cost_choice_2(i) := 32;
        else
          sums_right_cost_choice_2(i) := sums_right_cost_choice(i);
        end if;
      end loop;
      if forward_first(3) then
        sums_right_arrived_choice(0) := 32;
      else
        sums_right_arrived_choice(0) := sums_right_cost(1);
      end if;
      for i in 1 to 2 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 1);
        end if;
      end loop;
      for i in 4 to 5 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2(i - 1) := 32;
        else
          sums_right_arrived_choice_2(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 3);
        end if;
      end loop;
      for i in 8 to 9 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s(i - 1) := 32;
        else
          sums_right_arrived_choice_2s(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 5);
        end if;
      end loop;
      for i in 12 to 13 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_11(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_11(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 7);
        end if;
      end loop;
      for i in 16 to 17 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_15(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_15(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 9);
        end if;
      end loop;
      for i in 20 to 21 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_19(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_19(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 11);
        end if;
      end loop;
      for i in 24 to 25 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_23(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_23(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 13);
        end if;
      end loop;
      for i in 28 to 29 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_27(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_27(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 15);
        end if;
      end loop;
      for i in 32 to 33 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_31(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_31(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 17);
        end if;
      end loop;
      for i in 36 to 37 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_35(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_35(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 19);
        end if;
      end loop;
      for i in 40 to 41 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_39(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_39(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 21);
        end if;
      end loop;
      for i in 44 to 45 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_43(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_43(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 23);
        end if;
      end loop;
      for i in 48 to 49 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_47(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_47(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 25);
        end if;
      end loop;
      for i in 52 to 53 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_51(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_51(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 27);
        end if;
      end loop;
      for i in 56 to 57 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_55(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_55(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 29);
        end if;
      end loop;
      for i in 60 to 61 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_59(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_59(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 31);
        end if;
      end loop;
      for i in 64 to 65 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_63(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_63(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 65 to 66 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 33);
        end if;
      end loop;
      for i in 68 to 69 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_67(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_67(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 69 to 70 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 35);
        end if;
      end loop;
      for i in 72 to 73 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_71(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_71(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 73 to 74 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 37);
        end if;
      end loop;
      for i in 76 to 77 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_75(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_75(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 77 to 78 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 39);
        end if;
      end loop;
      for i in 80 to 81 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_79(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_79(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 81 to 82 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 41);
        end if;
      end loop;
      for i in 84 to 85 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_83(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_83(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 85 to 86 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 43);
        end if;
      end loop;
      for i in 88 to 89 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_87(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_87(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 89 to 90 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 45);
        end if;
      end loop;
      for i in 92 to 93 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_91(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_91(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 93 to 94 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 47);
        end if;
      end loop;
      for i in 96 to 97 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_95(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_95(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 97 to 98 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 49);
        end if;
      end loop;
      for i in 100 to 101 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_99(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_99(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 101 to 102 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 51);
        end if;
      end loop;
      for i in 104 to 105 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_103(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_103(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 105 to 106 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 53);
        end if;
      end loop;
      for i in 108 to 109 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_107(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_107(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 109 to 110 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 55);
        end if;
      end loop;
      for i in 112 to 113 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_111(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_111(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 113 to 114 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 57);
        end if;
      end loop;
      for i in 116 to 117 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_115(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_115(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 117 to 118 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 59);
        end if;
      end loop;
      for i in 120 to 121 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_119(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_119(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 121 to 122 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 61);
        end if;
      end loop;
      for i in 124 to 125 loop
        if (sums_right_cost(i) - sums_right_cost(i - 2)) < 0 then
          sums_right_arrived_choice(i - 1) := sums_right_cost(i);
        else
          sums_right_arrived_choice(i - 1) := sums_right_cost(i - 2);
        end if;
        if forward_first(3) then
          sums_right_arrived_choice_2s_from_123(i - 1) := 32;
        else
          sums_right_arrived_choice_2s_from_123(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 125 to 126 loop
        if forward_first(3) then
          sums_right_arrived_choice(i) := 32;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 63);
        end if;
      end loop;
      if forward_first(3) then
        sums_right_arrived_choice(127) := 32;
      else
        sums_right_arrived_choice(127) := sums_right_cost(126);
      end if;
      if entry_tag_valid then
        for i in 0 to 31 loop
          sums_turn_ready_sums(i) <= to_integer(sums_turn_read_sums(i));
        end loop;
        for i in 0 to 15 loop
          sums_turn_ready_costs(i) <= sums_turn_read_costs(i);
        end loop;
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= entry_tag_first_cost;
        sums_turn_place(0) <= entry_place;
        for i in 1 to 11 loop
          sums_turn_place(i) <= sums_turn_place(i - 1);
        end loop;
        for i in 0 to 15 loop
          sums_cost(0, 8 * i) <= to_integer(sums_turn_ready_costs(i)(3 downto 0));
          sums_cost(0, 8 * i + 1) <= to_integer(sums_turn_ready_costs(i)(7 downto 0)) / 16;
          for j in 2 to 7 loop
            sums_cost(0, 8 * i + j) <= to_integer(sums_turn_ready_costs(i)(4 * j + 3 downto 4 * j));
          end loop;
        end loop;
        for i in 0 to 127 loop
          sums_cost(1, i) <= sums_cost(0, i);
        end loop;
        for i in 0 to 63 loop
          sums_right_pair(i) <= sums_right_pair_choice(i);
        end loop;
        sums_right_smallest <= sums_turn_ready_smallest_0;
        sums_right_smallest_less <= ((((sums_turn_ready_smallest_0 / 4) + 15) mod 16) * 4) +
          (sums_turn_ready_smallest_0 mod 4);
        sums_right_first(0) <= sums_turn_ready_first;
        sums_right_first(1) <= sums_right_first(0);
        sums_right_first(2) <= sums_right_first(1);
        for i in 0 to 7 loop
          sums_right_g_copy(i) <= sums_right_g_copy_0_value;
        end loop;
        for i in 0 to 7 loop
          sums_right_g_less_copy(i) <= sums_right_g_less_copy_0_value;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 15 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i)) mod 64;
          end loop;
          for j in 16 to 31 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i + 1)) mod 64;
          end loop;
        end loop;
        for i in 0 to 3 loop
          for j in 0 to 15 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i)) mod 64;
          end loop;
          for j in 16 to 31 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i + 1)) mod 64;
          end loop;
        end loop;
        for i in 0 to 127 loop
          sums_right_cost(i) <= (sums_right_cost_choice_2(i) + sums_right_stay_change(i)) mod 64;
        end loop;
        sums_right_arrived(0) <= (sums_right_arrived_choice(0) + sums_right_step_change(0)) mod 64;
        sums_right_arrived(1) <= (sums_right_arrived_choice(1) + sums_right_step_change(1)) mod 64;
        sums_right_arrived(2) <= (sums_right_arrived_choice(2) + sums_right_step_change(2)) mod 64;
        sums_right_arrived(3) <= (sums_right_arrived_choice_2(3) + sums_right_step_change(3)) mod 64;
        sums_right_arrived(4) <= (sums_right_arrived_choice_2(4) + sums_right_step_change(4)) mod 64;
        sums_right_arrived(5) <= (sums_right_arrived_choice(5) + sums_right_step_change(5)) mod 64;
        sums_right_arrived(6) <= (sums_right_arrived_choice(6) + sums_right_step_change(6)) mod 64;
        sums_right_arrived(7) <= (sums_right_arrived_choice_2s(7) + sums_right_step_change(7)) mod 64;
        sums_right_arrived(8) <= (sums_right_arrived_choice_2s(8) + sums_right_step_change(8)) mod 64;
        sums_right_arrived(9) <= (sums_right_arrived_choice(9) + sums_right_step_change(9)) mod 64;
        sums_right_arrived(10) <= (sums_right_arrived_choice(10) + sums_right_step_change(10)) mod 64;
        sums_right_arrived(11) <= (sums_right_arrived_choice_2s_from_11(11) + sums_right_step_change(11)) mod 64;
        sums_right_arrived(12) <= (sums_right_arrived_choice_2s_from_11(12) + sums_right_step_change(12)) mod 64;
        sums_right_arrived(13) <= (sums_right_arrived_choice(13) + sums_right_step_change(13)) mod 64;
        sums_right_arrived(14) <= (sums_right_arrived_choice(14) + sums_right_step_change(14)) mod 64;
        sums_right_arrived(15) <= (sums_right_arrived_choice_2s_from_15(15) + sums_right_step_change(15)) mod 64;
        sums_right_arrived(16) <= (sums_right_arrived_choice_2s_from_15(16) + sums_right_step_change(16)) mod 64;
        sums_right_arrived(17) <= (sums_right_arrived_choice(17) + sums_right_step_change(17)) mod 64;
        sums_right_arrived(18) <= (sums_right_arrived_choice(18) + sums_right_step_change(18)) mod 64;
        sums_right_arrived(19) <= (sums_right_arrived_choice_2s_from_19(19) + sums_right_step_change(19)) mod 64;
        sums_right_arrived(20) <= (sums_right_arrived_choice_2s_from_19(20) + sums_right_step_change(20)) mod 64;
        sums_right_arrived(21) <= (sums_right_arrived_choice(21) + sums_right_step_change(21)) mod 64;
        sums_right_arrived(22) <= (sums_right_arrived_choice(22) + sums_right_step_change(22)) mod 64;
        sums_right_arrived(23) <= (sums_right_arrived_choice_2s_from_23(23) + sums_right_step_change(23)) mod 64;
        sums_right_arrived(24) <= (sums_right_arrived_choice_2s_from_23(24) + sums_right_step_change(24)) mod 64;
        sums_right_arrived(25) <= (sums_right_arrived_choice(25) + sums_right_step_change(25)) mod 64;
        sums_right_arrived(26) <= (sums_right_arrived_choice(26) + sums_right_step_change(26)) mod 64;
        sums_right_arrived(27) <= (sums_right_arrived_choice_2s_from_27(27) + sums_right_step_change(27)) mod 64;
        sums_right_arrived(28) <= (sums_right_arrived_choice_2s_from_27(28) + sums_right_step_change(28)) mod 64;
        sums_right_arrived(29) <= (sums_right_arrived_choice(29) + sums_right_step_change(29)) mod 64;
        sums_right_arrived(30) <= (sums_right_arrived_choice(30) + sums_right_step_change(30)) mod 64;
        sums_right_arrived(31) <= (sums_right_arrived_choice_2s_from_31(31) + sums_right_step_change(31)) mod 64;
        sums_right_arrived(32) <= (sums_right_arrived_choice_2s_from_31(32) + sums_right_step_change(32)) mod 64;
        sums_right_arrived(33) <= (sums_right_arrived_choice(33) + sums_right_step_change(33)) mod 64;
        sums_right_arrived(34) <= (sums_right_arrived_choice(34) + sums_right_step_change(34)) mod 64;
        sums_right_arrived(35) <= (sums_right_arrived_choice_2s_from_35(35) + sums_right_step_change(35)) mod 64;
        sums_right_arrived(36) <= (sums_right_arrived_choice_2s_from_35(36) + sums_right_step_change(36)) mod 64;
        sums_right_arrived(37) <= (sums_right_arrived_choice(37) + sums_right_step_change(37)) mod 64;
        sums_right_arrived(38) <= (sums_right_arrived_choice(38) + sums_right_step_change(38)) mod 64;
        sums_right_arrived(39) <= (sums_right_arrived_choice_2s_from_39(39) + sums_right_step_change(39)) mod 64;
        sums_right_arrived(40) <= (sums_right_arrived_choice_2s_from_39(40) + sums_right_step_change(40)) mod 64;
        sums_right_arrived(41) <= (sums_right_arrived_choice(41) + sums_right_step_change(41)) mod 64;
        sums_right_arrived(42) <= (sums_right_arrived_choice(42) + sums_right_step_change(42)) mod 64;
        sums_right_arrived(43) <= (sums_right_arrived_choice_2s_from_43(43) + sums_right_step_change(43)) mod 64;
        sums_right_arrived(44) <= (sums_right_arrived_choice_2s_from_43(44) + sums_right_step_change(44)) mod 64;
        sums_right_arrived(45) <= (sums_right_arrived_choice(45) + sums_right_step_change(45)) mod 64;
        sums_right_arrived(46) <= (sums_right_arrived_choice(46) + sums_right_step_change(46)) mod 64;
        sums_right_arrived(47) <= (sums_right_arrived_choice_2s_from_47(47) + sums_right_step_change(47)) mod 64;
        sums_right_arrived(48) <= (sums_right_arrived_choice_2s_from_47(48) + sums_right_step_change(48)) mod 64;
        sums_right_arrived(49) <= (sums_right_arrived_choice(49) + sums_right_step_change(49)) mod 64;
        sums_right_arrived(50) <= (sums_right_arrived_choice(50) + sums_right_step_change(50)) mod 64;
        sums_right_arrived(51) <= (sums_right_arrived_choice_2s_from_51(51) + sums_right_step_change(51)) mod 64;
        sums_right_arrived(52) <= (sums_right_arrived_choice_2s_from_51(52) + sums_right_step_change(52)) mod 64;
        sums_right_arrived(53) <= (sums_right_arrived_choice(53) + sums_right_step_change(53)) mod 64;
        sums_right_arrived(54) <= (sums_right_arrived_choice(54) + sums_right_step_change(54)) mod 64;
        sums_right_arrived(55) <= (sums_right_arrived_choice_2s_from_55(55) + sums_right_step_change(55)) mod 64;
        sums_right_arrived(56) <= (sums_right_arrived_choice_2s_from_55(56) + sums_right_step_change(56)) mod 64;
        sums_right_arrived(57) <= (sums_right_arrived_choice(57) + sums_right_step_change(57)) mod 64;
        sums_right_arrived(58) <= (sums_right_arrived_choice(58) + sums_right_step_change(58)) mod 64;
        sums_right_arrived(59) <= (sums_right_arrived_choice_2s_from_59(59) + sums_right_step_change(59)) mod 64;
        sums_right_arrived(60) <= (sums_right_arrived_choice_2s_from_59(60) + sums_right_step_change(60)) mod 64;
        sums_right_arrived(61) <= (sums_right_arrived_choice(61) + sums_right_step_change(61)) mod 64;
        sums_right_arrived(62) <= (sums_right_arrived_choice(62) + sums_right_step_change(62)) mod 64;
        sums_right_arrived(63) <= (sums_right_arrived_choice_2s_from_63(63) + sums_right_step_change(63)) mod 64;
        sums_right_arrived(64) <= (sums_right_arrived_choice_2s_from_63(64) + sums_right_step_change(64)) mod 64;
        sums_right_arrived(65) <= (sums_right_arrived_choice(65) + sums_right_step_change(65)) mod 64;
        sums_right_arrived(66) <= (sums_right_arrived_choice(66) + sums_right_step_change(66)) mod 64;
        sums_right_arrived(67) <= (sums_right_arrived_choice_2s_from_67(67) + sums_right_step_change(67)) mod 64;
        sums_right_arrived(68) <= (sums_right_arrived_choice_2s_from_67(68) + sums_right_step_change(68)) mod 64;
        sums_right_arrived(69) <= (sums_right_arrived_choice(69) + sums_right_step_change(69)) mod 64;
        sums_right_arrived(70) <= (sums_right_arrived_choice(70) + sums_right_step_change(70)) mod 64;
        sums_right_arrived(71) <= (sums_right_arrived_choice_2s_from_71(71) + sums_right_step_change(71)) mod 64;
        sums_right_arrived(72) <= (sums_right_arrived_choice_2s_from_71(72) + sums_right_step_change(72)) mod 64;
        sums_right_arrived(73) <= (sums_right_arrived_choice(73) + sums_right_step_change(73)) mod 64;
        sums_right_arrived(74) <= (sums_right_arrived_choice(74) + sums_right_step_change(74)) mod 64;
        sums_right_arrived(75) <= (sums_right_arrived_choice_2s_from_75(75) + sums_right_step_change(75)) mod 64;
        sums_right_arrived(76) <= (sums_right_arrived_choice_2s_from_75(76) + sums_right_step_change(76)) mod 64;
        sums_right_arrived(77) <= (sums_right_arrived_choice(77) + sums_right_step_change(77)) mod 64;
        sums_right_arrived(78) <= (sums_right_arrived_choice(78) + sums_right_step_change(78)) mod 64;
        sums_right_arrived(79) <= (sums_right_arrived_choice_2s_from_79(79) + sums_right_step_change(79)) mod 64;
        sums_right_arrived(80) <= (sums_right_arrived_choice_2s_from_79(80) + sums_right_step_change(80)) mod 64;
        sums_right_arrived(81) <= (sums_right_arrived_choice(81) + sums_right_step_change(81)) mod 64;
        sums_right_arrived(82) <= (sums_right_arrived_choice(82) + sums_right_step_change(82)) mod 64;
        sums_right_arrived(83) <= (sums_right_arrived_choice_2s_from_83(83) + sums_right_step_change(83)) mod 64;
        sums_right_arrived(84) <= (sums_right_arrived_choice_2s_from_83(84) + sums_right_step_change(84)) mod 64;
        sums_right_arrived(85) <= (sums_right_arrived_choice(85) + sums_right_step_change(85)) mod 64;
        sums_right_arrived(86) <= (sums_right_arrived_choice(86) + sums_right_step_change(86)) mod 64;
        sums_right_arrived(87) <= (sums_right_arrived_choice_2s_from_87(87) + sums_right_step_change(87)) mod 64;
        sums_right_arrived(88) <= (sums_right_arrived_choice_2s_from_87(88) + sums_right_step_change(88)) mod 64;
        sums_right_arrived(89) <= (sums_right_arrived_choice(89) + sums_right_step_change(89)) mod 64;
        sums_right_arrived(90) <= (sums_right_arrived_choice(90) + sums_right_step_change(90)) mod 64;
        sums_right_arrived(91) <= (sums_right_arrived_choice_2s_from_91(91) + sums_right_step_change(91)) mod 64;
        sums_right_arrived(92) <= (sums_right_arrived_choice_2s_from_91(92) + sums_right_step_change(92)) mod 64;
        sums_right_arrived(93) <= (sums_right_arrived_choice(93) + sums_right_step_change(93)) mod 64;
        sums_right_arrived(94) <= (sums_right_arrived_choice(94) + sums_right_step_change(94)) mod 64;
        sums_right_arrived(95) <= (sums_right_arrived_choice_2s_from_95(95) + sums_right_step_change(95)) mod 64;
        sums_right_arrived(96) <= (sums_right_arrived_choice_2s_from_95(96) + sums_right_step_change(96)) mod 64;
        sums_right_arrived(97) <= (sums_right_arrived_choice(97) + sums_right_step_change(97)) mod 64;
        sums_right_arrived(98) <= (sums_right_arrived_choice(98) + sums_right_step_change(98)) mod 64;
        sums_right_arrived(99) <= (sums_right_arrived_choice_2s_from_99(99) + sums_right_step_change(99)) mod 64;
        sums_right_arrived(100) <= (sums_right_arrived_choice_2s_from_99(100) + sums_right_step_change(100)) mod 64;
        sums_right_arrived(101) <= (sums_right_arrived_choice(101) + sums_right_step_change(101)) mod 64;
        sums_right_arrived(102) <= (sums_right_arrived_choice(102) + sums_right_step_change(102)) mod 64;
        sums_right_arrived(103) <= (sums_right_arrived_choice_2s_from_103(103) + sums_right_step_change(103)) mod 64;
        sums_right_arrived(104) <= (sums_right_arrived_choice_2s_from_103(104) + sums_right_step_change(104)) mod 64;
        sums_right_arrived(105) <= (sums_right_arrived_choice(105) + sums_right_step_change(105)) mod 64;
        sums_right_arrived(106) <= (sums_right_arrived_choice(106) + sums_right_step_change(106)) mod 64;
        sums_right_arrived(107) <= (sums_right_arrived_choice_2s_from_107(107) + sums_right_step_change(107)) mod 64;
        sums_right_arrived(108) <= (sums_right_arrived_choice_2s_from_107(108) + sums_right_step_change(108)) mod 64;
        sums_right_arrived(109) <= (sums_right_arrived_choice(109) + sums_right_step_change(109)) mod 64;
        sums_right_arrived(110) <= (sums_right_arrived_choice(110) + sums_right_step_change(110)) mod 64;
        sums_right_arrived(111) <= (sums_right_arrived_choice_2s_from_111(111) + sums_right_step_change(111)) mod 64;
        sums_right_arrived(112) <= (sums_right_arrived_choice_2s_from_111(112) + sums_right_step_change(112)) mod 64;
        sums_right_arrived(113) <= (sums_right_arrived_choice(113) + sums_right_step_change(113)) mod 64;
        sums_right_arrived(114) <= (sums_right_arrived_choice(114) + sums_right_step_change(114)) mod 64;
        sums_right_arrived(115) <= (sums_right_arrived_choice_2s_from_115(115) + sums_right_step_change(115)) mod 64;
        sums_right_arrived(116) <= (sums_right_arrived_choice_2s_from_115(116) + sums_right_step_change(116)) mod 64;
        sums_right_arrived(117) <= (sums_right_arrived_choice(117) + sums_right_step_change(117)) mod 64;
        sums_right_arrived(118) <= (sums_right_arrived_choice(118) + sums_right_step_change(118)) mod 64;
        sums_right_arrived(119) <= (sums_right_arrived_choice_2s_from_119(119) + sums_right_step_change(119)) mod 64;
        sums_right_arrived(120) <= (sums_right_arrived_choice_2s_from_119(120) + sums_right_step_change(120)) mod 64;
        sums_right_arrived(121) <= (sums_right_arrived_choice(121) + sums_right_step_change(121)) mod 64;
        sums_right_arrived(122) <= (sums_right_arrived_choice(122) + sums_right_step_change(122)) mod 64;
        sums_right_arrived(123) <= (sums_right_arrived_choice_2s_from_123(123) + sums_right_step_change(123)) mod 64;
        sums_right_arrived(124) <= (sums_right_arrived_choice_2s_from_123(124) + sums_right_step_change(124)) mod 64;
        for i in 125 to 127 loop
          sums_right_arrived(i) <= (sums_right_arrived_choice(i) + sums_right_step_change(i)) mod 64;
        end loop;
        sums_sum_delay_ring_write_address <= sums_sum_delay_ring_read_address;
        sums_tags_held_output_column(0) <= entry_turned_output_column;
        sums_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
        sums_tags_held_end_of_line(0) <= entry_tag_end_of_line;
        for i in 1 to 4 loop
          sums_tags_held_output_column(i) <= sums_tags_held_output_column(i - 1);
          sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
          sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
        end loop;
        for i in 0 to 31 loop
          if (sums_right_pair(2 * i + 1) - sums_right_pair(2 * i)) < 0 then
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i + 1);
          else
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (sums_right_tree_smallest(2 * i + 1) - sums_right_tree_smallest(2 * i)) < 0 then
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i + 1);
          else
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (sums_right_tree_next_smallest(2 * i + 1) - sums_right_tree_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (sums_right_tree_next_next_smallest(2 * i + 1) - sums_right_tree_next_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (sums_right_tree_next_next_next_smallest(2 * i + 1) - sums_right_tree_next_next_next_smallest(2 * i)) < 0
            then
            sums_right_tree_next_next_next_next_smallest(i) <= sums_right_tree_next_next_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_next_next_smallest(i) <= sums_right_tree_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (sums_right_tree_next_next_next_next_smallest(1) - sums_right_tree_next_next_next_next_smallest(0)) < 0 then
          sums_right_tree_next_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_next_smallest(1);
        else
          sums_right_tree_next_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_next_smallest(0);
        end if;
        if forward_first(0) then
          sums_right_start_cost(0) <= 24;
          for i in 1 to 9 loop
            sums_right_start_cost(i) <= 0;
          end loop;
          sums_right_room <= 0;
        else
          sums_right_start_cost(0) <= sums_right_start_cost_0_choice_2;
          for i in 1 to 9 loop
            sums_right_start_cost(i) <= sums_right_start_cost(i - 1);
          end loop;
          sums_right_room <= (sums_right_room_choice_2 + sums_right_start_cost(9)) mod 32;
        end if;
        if sums_sum_delay_ring_read_address = 3 then
          sums_sum_delay_ring_read_address <= 0;
        else
          sums_sum_delay_ring_read_address <= (sums_sum_delay_ring_read_address + 1) mod 4;
        end if;
      end if;
      if entry_tag_valid then
        sums_turn_writes_copy_0_choice := forward_above_comes(10);
      else
        sums_turn_writes_copy_0_choice := forward_above_comes(11);
      end if;
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      for i in 0 to 31 loop
        sums_sum_0(4 * i) <= (sums_right_cost(4 * i) + to_integer(sums_sum_delay_held(i))) mod 128;
        sums_sum_0(4 * i + 1) <= (sums_right_cost(4 * i + 1) + to_integer(sums_sum_delay_held(i)(27 downto 7))) mod 128;
        sums_sum_0(4 * i + 2) <= (sums_right_cost(4 * i + 2) + to_integer(sums_sum_delay_held(i)(27 downto 14))) mod
          128;
        sums_sum_0(4 * i + 3) <= (sums_right_cost(4 * i + 3) + to_integer(sums_sum_delay_held(i)(27 downto 21))) mod
          128;
      end loop;
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= forward_above_comes(4);
      sums_tag_output_column <= sums_tags_held_output_column(4);
      sums_tag_start_of_frame <= sums_tags_held_start_of_frame(4);
      sums_tag_end_of_line <= sums_tags_held_end_of_line(4);
      sums_tags_moved <= entry_tag_valid;
      if sums_turn_writes_copy_0 then
        for i in 0 to 31 loop
          sums_turn_write_sums(i) <= (forward_sum(4 * i + 2) * 16384) + (forward_sum(4 * i + 3) * 2097152) +
            forward_sum(4 * i) + (forward_sum(4 * i + 1) * 128);
        end loop;
        for i in 0 to 15 loop
          sums_turn_write_costs(i) <= to_unsigned(forward_cost(3, 8 * i + 7), 4) & to_unsigned(forward_cost(3, 8 * i +
            6), 4) & to_unsigned(forward_cost(3, 8 * i + 5), 4) & to_unsigned(forward_cost(3, 8 * i + 4), 4) &
            to_unsigned(forward_cost(3, 8 * i + 3), 4) & to_unsigned(forward_cost(3, 8 * i + 2), 4) &
            to_unsigned(forward_cost(3, 8 * i + 1), 4) & to_unsigned(forward_cost(3, 8 * i), 4);
        end loop;
        sums_turn_write_smallest_0 <= forward_smallest_cost(4);
        sums_turn_write_place <= sums_turn_place(11);
      end if;
      -- winnerswinner1
      if is_set(sums_sum_0(0), 0) then
        winnerswinner1_of_pair_0_0_choice := (not is_set(sums_sum_0(1), 1)) or (not is_set(sums_sum_0(1), 0));
      else
        winnerswinner1_of_pair_0_0_choice := not is_set(sums_sum_0(1), 1);
      end if;
      if is_set(sums_sum_0(0), 1) then
        winnerswinner1_of_pair_0_0_choices(2) := winnerswinner1_of_pair_0_0_choice;
      else
        winnerswinner1_of_pair_0_0_choices(2) := is_set(sums_sum_0(0), 0) and ((sums_sum_0(1) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_0_value := is_set(sums_sum_0(1), 2);
      if winnerswinner1_of_pair_0_0_choices(2) then
        winnerswinner1_of_pair_0_0_choices(3) := (not is_set(sums_sum_0(0), 2)) and winnerswinner1_of_pair_0_0_value;
      else
        winnerswinner1_of_pair_0_0_choices(3) := (not is_set(sums_sum_0(0), 2)) or winnerswinner1_of_pair_0_0_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_0_values(i) := is_set(sums_sum_0(1), i + 1);
        if winnerswinner1_of_pair_0_0_choices(i + 1) then
          winnerswinner1_of_pair_0_0_choices(i + 2) := (not is_set(sums_sum_0(0), i + 1)) or
            winnerswinner1_of_pair_0_0_values(i);
        else
          winnerswinner1_of_pair_0_0_choices(i + 2) := (not is_set(sums_sum_0(0), i + 1)) and
            winnerswinner1_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_0_choices(6) then
        winnerswinner1_of_pair_0_0_choices(7) := is_set(sums_sum_0(0), 6) and (not is_set(sums_sum_0(1), 6));
      else
        winnerswinner1_of_pair_0_0_choices(7) := is_set(sums_sum_0(0), 6) or (not is_set(sums_sum_0(1), 6));
      end if;
      if is_set(sums_sum_0(2), 0) then
        winnerswinner1_of_pair_0_2_choice := (not is_set(sums_sum_0(3), 1)) or (not is_set(sums_sum_0(3), 0));
      else
        winnerswinner1_of_pair_0_2_choice := not is_set(sums_sum_0(3), 1);
      end if;
      if is_set(sums_sum_0(2), 1) then
        winnerswinner1_of_pair_0_2_choices(2) := winnerswinner1_of_pair_0_2_choice;
      else
        winnerswinner1_of_pair_0_2_choices(2) := is_set(sums_sum_0(2), 0) and ((sums_sum_0(3) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_2_value := is_set(sums_sum_0(3), 2);
      if winnerswinner1_of_pair_0_2_choices(2) then
        winnerswinner1_of_pair_0_2_choices(3) := (not is_set(sums_sum_0(2), 2)) and winnerswinner1_of_pair_0_2_value;
      else
        winnerswinner1_of_pair_0_2_choices(3) := (not is_set(sums_sum_0(2), 2)) or winnerswinner1_of_pair_0_2_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_2_values(i) := is_set(sums_sum_0(3), i + 1);
        if winnerswinner1_of_pair_0_2_choices(i + 1) then
          winnerswinner1_of_pair_0_2_choices(i + 2) := (not is_set(sums_sum_0(2), i + 1)) or
            winnerswinner1_of_pair_0_2_values(i);
        else
          winnerswinner1_of_pair_0_2_choices(i + 2) := (not is_set(sums_sum_0(2), i + 1)) and
            winnerswinner1_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_2_choices(6) then
        winnerswinner1_of_pair_0_2_choices(7) := is_set(sums_sum_0(2), 6) and (not is_set(sums_sum_0(3), 6));
      else
        winnerswinner1_of_pair_0_2_choices(7) := is_set(sums_sum_0(2), 6) or (not is_set(sums_sum_0(3), 6));
      end if;
      if is_set(sums_sum_0(4), 0) then
        winnerswinner1_of_pair_0_4_choice := (not is_set(sums_sum_0(5), 1)) or (not is_set(sums_sum_0(5), 0));
      else
        winnerswinner1_of_pair_0_4_choice := not is_set(sums_sum_0(5), 1);
      end if;
      if is_set(sums_sum_0(4), 1) then
        winnerswinner1_of_pair_0_4_choices(2) := winnerswinner1_of_pair_0_4_choice;
      else
        winnerswinner1_of_pair_0_4_choices(2) := is_set(sums_sum_0(4), 0) and ((sums_sum_0(5) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_4_value := is_set(sums_sum_0(5), 2);
      if winnerswinner1_of_pair_0_4_choices(2) then
        winnerswinner1_of_pair_0_4_choices(3) := (not is_set(sums_sum_0(4), 2)) and winnerswinner1_of_pair_0_4_value;
      else
        winnerswinner1_of_pair_0_4_choices(3) := (not is_set(sums_sum_0(4), 2)) or winnerswinner1_of_pair_0_4_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_4_values(i) := is_set(sums_sum_0(5), i + 1);
        if winnerswinner1_of_pair_0_4_choices(i + 1) then
          winnerswinner1_of_pair_0_4_choices(i + 2) := (not is_set(sums_sum_0(4), i + 1)) or
            winnerswinner1_of_pair_0_4_values(i);
        else
          winnerswinner1_of_pair_0_4_choices(i + 2) := (not is_set(sums_sum_0(4), i + 1)) and
            winnerswinner1_of_pair_0_4_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_4_choices(6) then
        winnerswinner1_of_pair_0_4_choices(7) := is_set(sums_sum_0(4), 6) and (not is_set(sums_sum_0(5), 6));
      else
        winnerswinner1_of_pair_0_4_choices(7) := is_set(sums_sum_0(4), 6) or (not is_set(sums_sum_0(5), 6));
      end if;
      if is_set(sums_sum_0(6), 0) then
        winnerswinner1_of_pair_0_6_choice := (not is_set(sums_sum_0(7), 1)) or (not is_set(sums_sum_0(7), 0));
      else
        winnerswinner1_of_pair_0_6_choice := not is_set(sums_sum_0(7), 1);
      end if;
      if is_set(sums_sum_0(6), 1) then
        winnerswinner1_of_pair_0_6_choices(2) := winnerswinner1_of_pair_0_6_choice;
      else
        winnerswinner1_of_pair_0_6_choices(2) := is_set(sums_sum_0(6), 0) and ((sums_sum_0(7) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_6_value := is_set(sums_sum_0(7), 2);
      if winnerswinner1_of_pair_0_6_choices(2) then
        winnerswinner1_of_pair_0_6_choices(3) := (not is_set(sums_sum_0(6), 2)) and winnerswinner1_of_pair_0_6_value;
      else
        winnerswinner1_of_pair_0_6_choices(3) := (not is_set(sums_sum_0(6), 2)) or winnerswinner1_of_pair_0_6_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_6_values(i) := is_set(sums_sum_0(7), i + 1);
        if winnerswinner1_of_pair_0_6_choices(i + 1) then
          winnerswinner1_of_pair_0_6_choices(i + 2) := (not is_set(sums_sum_0(6), i + 1)) or
            winnerswinner1_of_pair_0_6_values(i);
        else
          winnerswinner1_of_pair_0_6_choices(i + 2) := (not is_set(sums_sum_0(6), i + 1)) and
            winnerswinner1_of_pair_0_6_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_6_choices(6) then
        winnerswinner1_of_pair_0_6_choices(7) := is_set(sums_sum_0(6), 6) and (not is_set(sums_sum_0(7), 6));
      else
        winnerswinner1_of_pair_0_6_choices(7) := is_set(sums_sum_0(6), 6) or (not is_set(sums_sum_0(7), 6));
      end if;
      if is_set(sums_sum_0(8), 0) then
        winnerswinner1_of_pair_0_8_choice := (not is_set(sums_sum_0(9), 1)) or (not is_set(sums_sum_0(9), 0));
      else
        winnerswinner1_of_pair_0_8_choice := not is_set(sums_sum_0(9), 1);
      end if;
      if is_set(sums_sum_0(8), 1) then
        winnerswinner1_of_pair_0_8_choices(2) := winnerswinner1_of_pair_0_8_choice;
      else
        winnerswinner1_of_pair_0_8_choices(2) := is_set(sums_sum_0(8), 0) and ((sums_sum_0(9) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_8_value := is_set(sums_sum_0(9), 2);
      if winnerswinner1_of_pair_0_8_choices(2) then
        winnerswinner1_of_pair_0_8_choices(3) := (not is_set(sums_sum_0(8), 2)) and winnerswinner1_of_pair_0_8_value;
      else
        winnerswinner1_of_pair_0_8_choices(3) := (not is_set(sums_sum_0(8), 2)) or winnerswinner1_of_pair_0_8_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_8_values(i) := is_set(sums_sum_0(9), i + 1);
        if winnerswinner1_of_pair_0_8_choices(i + 1) then
          winnerswinner1_of_pair_0_8_choices(i + 2) := (not is_set(sums_sum_0(8), i + 1)) or
            winnerswinner1_of_pair_0_8_values(i);
        else
          winnerswinner1_of_pair_0_8_choices(i + 2) := (not is_set(sums_sum_0(8), i + 1)) and
            winnerswinner1_of_pair_0_8_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_8_choices(6) then
        winnerswinner1_of_pair_0_8_choices(7) := is_set(sums_sum_0(8), 6) and (not is_set(sums_sum_0(9), 6));
      else
        winnerswinner1_of_pair_0_8_choices(7) := is_set(sums_sum_0(8), 6) or (not is_set(sums_sum_0(9), 6));
      end if;
      if is_set(sums_sum_0(10), 0) then
        winnerswinner1_of_pair_0_10_choice := (not is_set(sums_sum_0(11), 1)) or (not is_set(sums_sum_0(11), 0));
      else
        winnerswinner1_of_pair_0_10_choice := not is_set(sums_sum_0(11), 1);
      end if;
      if is_set(sums_sum_0(10), 1) then
        winnerswinner1_of_pair_0_10_choices(2) := winnerswinner1_of_pair_0_10_choice;
      else
        winnerswinner1_of_pair_0_10_choices(2) := is_set(sums_sum_0(10), 0) and ((sums_sum_0(11) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_10_value := is_set(sums_sum_0(11), 2);
      if winnerswinner1_of_pair_0_10_choices(2) then
        winnerswinner1_of_pair_0_10_choices(3) := (not is_set(sums_sum_0(10), 2)) and winnerswinner1_of_pair_0_10_value;
      else
        winnerswinner1_of_pair_0_10_choices(3) := (not is_set(sums_sum_0(10), 2)) or winnerswinner1_of_pair_0_10_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_10_values(i) := is_set(sums_sum_0(11), i + 1);
        if winnerswinner1_of_pair_0_10_choices(i + 1) then
          winnerswinner1_of_pair_0_10_choices(i + 2) := (not is_set(sums_sum_0(10), i + 1)) or
            winnerswinner1_of_pair_0_10_values(i);
        else
          winnerswinner1_of_pair_0_10_choices(i + 2) := (not is_set(sums_sum_0(10), i + 1)) and
            winnerswinner1_of_pair_0_10_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_10_choices(6) then
        winnerswinner1_of_pair_0_10_choices(7) := is_set(sums_sum_0(10), 6) and (not is_set(sums_sum_0(11), 6));
      else
        winnerswinner1_of_pair_0_10_choices(7) := is_set(sums_sum_0(10), 6) or (not is_set(sums_sum_0(11), 6));
      end if;
      if is_set(sums_sum_0(12), 0) then
        winnerswinner1_of_pair_0_12_choice := (not is_set(sums_sum_0(13), 1)) or (not is_set(sums_sum_0(13), 0));
      else
        winnerswinner1_of_pair_0_12_choice := not is_set(sums_sum_0(13), 1);
      end if;
      if is_set(sums_sum_0(12), 1) then
        winnerswinner1_of_pair_0_12_choices(2) := winnerswinner1_of_pair_0_12_choice;
      else
        winnerswinner1_of_pair_0_12_choices(2) := is_set(sums_sum_0(12), 0) and ((sums_sum_0(13) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_12_value := is_set(sums_sum_0(13), 2);
      if winnerswinner1_of_pair_0_12_choices(2) then
        winnerswinner1_of_pair_0_12_choices(3) := (not is_set(sums_sum_0(12), 2)) and winnerswinner1_of_pair_0_12_value;
      else
        winnerswinner1_of_pair_0_12_choices(3) := (not is_set(sums_sum_0(12), 2)) or winnerswinner1_of_pair_0_12_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_12_values(i) := is_set(sums_sum_0(13), i + 1);
        if winnerswinner1_of_pair_0_12_choices(i + 1) then
          winnerswinner1_of_pair_0_12_choices(i + 2) := (not is_set(sums_sum_0(12), i + 1)) or
            winnerswinner1_of_pair_0_12_values(i);
        else
          winnerswinner1_of_pair_0_12_choices(i + 2) := (not is_set(sums_sum_0(12), i + 1)) and
            winnerswinner1_of_pair_0_12_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_12_choices(6) then
        winnerswinner1_of_pair_0_12_choices(7) := is_set(sums_sum_0(12), 6) and (not is_set(sums_sum_0(13), 6));
      else
        winnerswinner1_of_pair_0_12_choices(7) := is_set(sums_sum_0(12), 6) or (not is_set(sums_sum_0(13), 6));
      end if;
      if is_set(sums_sum_0(14), 0) then
        winnerswinner1_of_pair_0_14_choice := (not is_set(sums_sum_0(15), 1)) or (not is_set(sums_sum_0(15), 0));
      else
        winnerswinner1_of_pair_0_14_choice := not is_set(sums_sum_0(15), 1);
      end if;
      if is_set(sums_sum_0(14), 1) then
        winnerswinner1_of_pair_0_14_choices(2) := winnerswinner1_of_pair_0_14_choice;
      else
        winnerswinner1_of_pair_0_14_choices(2) := is_set(sums_sum_0(14), 0) and ((sums_sum_0(15) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_14_value := is_set(sums_sum_0(15), 2);
      if winnerswinner1_of_pair_0_14_choices(2) then
        winnerswinner1_of_pair_0_14_choices(3) := (not is_set(sums_sum_0(14), 2)) and winnerswinner1_of_pair_0_14_value;
      else
        winnerswinner1_of_pair_0_14_choices(3) := (not is_set(sums_sum_0(14), 2)) or winnerswinner1_of_pair_0_14_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_14_values(i) := is_set(sums_sum_0(15), i + 1);
        if winnerswinner1_of_pair_0_14_choices(i + 1) then
          winnerswinner1_of_pair_0_14_choices(i + 2) := (not is_set(sums_sum_0(14), i + 1)) or
            winnerswinner1_of_pair_0_14_values(i);
        else
          winnerswinner1_of_pair_0_14_choices(i + 2) := (not is_set(sums_sum_0(14), i + 1)) and
            winnerswinner1_of_pair_0_14_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_14_choices(6) then
        winnerswinner1_of_pair_0_14_choices(7) := is_set(sums_sum_0(14), 6) and (not is_set(sums_sum_0(15), 6));
      else
        winnerswinner1_of_pair_0_14_choices(7) := is_set(sums_sum_0(14), 6) or (not is_set(sums_sum_0(15), 6));
      end if;
      if is_set(sums_sum_0(16), 0) then
        winnerswinner1_of_pair_0_16_choice := (not is_set(sums_sum_0(17), 1)) or (not is_set(sums_sum_0(17), 0));
      else
        winnerswinner1_of_pair_0_16_choice := not is_set(sums_sum_0(17), 1);
      end if;
      if is_set(sums_sum_0(16), 1) then
        winnerswinner1_of_pair_0_16_choices(2) := winnerswinner1_of_pair_0_16_choice;
      else
        winnerswinner1_of_pair_0_16_choices(2) := is_set(sums_sum_0(16), 0) and ((sums_sum_0(17) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_16_value := is_set(sums_sum_0(17), 2);
      if winnerswinner1_of_pair_0_16_choices(2) then
        winnerswinner1_of_pair_0_16_choices(3) := (not is_set(sums_sum_0(16), 2)) and winnerswinner1_of_pair_0_16_value;
      else
        winnerswinner1_of_pair_0_16_choices(3) := (not is_set(sums_sum_0(16), 2)) or winnerswinner1_of_pair_0_16_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_16_values(i) := is_set(sums_sum_0(17), i + 1);
        if winnerswinner1_of_pair_0_16_choices(i + 1) then
          winnerswinner1_of_pair_0_16_choices(i + 2) := (not is_set(sums_sum_0(16), i + 1)) or
            winnerswinner1_of_pair_0_16_values(i);
        else
          winnerswinner1_of_pair_0_16_choices(i + 2) := (not is_set(sums_sum_0(16), i + 1)) and
            winnerswinner1_of_pair_0_16_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_16_choices(6) then
        winnerswinner1_of_pair_0_16_choices(7) := is_set(sums_sum_0(16), 6) and (not is_set(sums_sum_0(17), 6));
      else
        winnerswinner1_of_pair_0_16_choices(7) := is_set(sums_sum_0(16), 6) or (not is_set(sums_sum_0(17), 6));
      end if;
      if is_set(sums_sum_0(18), 0) then
        winnerswinner1_of_pair_0_18_choice := (not is_set(sums_sum_0(19), 1)) or (not is_set(sums_sum_0(19), 0));
      else
        winnerswinner1_of_pair_0_18_choice := not is_set(sums_sum_0(19), 1);
      end if;
      if is_set(sums_sum_0(18), 1) then
        winnerswinner1_of_pair_0_18_choices(2) := winnerswinner1_of_pair_0_18_choice;
      else
        winnerswinner1_of_pair_0_18_choices(2) := is_set(sums_sum_0(18), 0) and ((sums_sum_0(19) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_18_value := is_set(sums_sum_0(19), 2);
      if winnerswinner1_of_pair_0_18_choices(2) then
        winnerswinner1_of_pair_0_18_choices(3) := (not is_set(sums_sum_0(18), 2)) and winnerswinner1_of_pair_0_18_value;
      else
        winnerswinner1_of_pair_0_18_choices(3) := (not is_set(sums_sum_0(18), 2)) or winnerswinner1_of_pair_0_18_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_18_values(i) := is_set(sums_sum_0(19), i + 1);
        if winnerswinner1_of_pair_0_18_choices(i + 1) then
          winnerswinner1_of_pair_0_18_choices(i + 2) := (not is_set(sums_sum_0(18), i + 1)) or
            winnerswinner1_of_pair_0_18_values(i);
        else
          winnerswinner1_of_pair_0_18_choices(i + 2) := (not is_set(sums_sum_0(18), i + 1)) and
            winnerswinner1_of_pair_0_18_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_18_choices(6) then
        winnerswinner1_of_pair_0_18_choices(7) := is_set(sums_sum_0(18), 6) and (not is_set(sums_sum_0(19), 6));
      else
        winnerswinner1_of_pair_0_18_choices(7) := is_set(sums_sum_0(18), 6) or (not is_set(sums_sum_0(19), 6));
      end if;
      if is_set(sums_sum_0(20), 0) then
        winnerswinner1_of_pair_0_20_choice := (not is_set(sums_sum_0(21), 1)) or (not is_set(sums_sum_0(21), 0));
      else
        winnerswinner1_of_pair_0_20_choice := not is_set(sums_sum_0(21), 1);
      end if;
      if is_set(sums_sum_0(20), 1) then
        winnerswinner1_of_pair_0_20_choices(2) := winnerswinner1_of_pair_0_20_choice;
      else
        winnerswinner1_of_pair_0_20_choices(2) := is_set(sums_sum_0(20), 0) and ((sums_sum_0(21) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_20_value := is_set(sums_sum_0(21), 2);
      if winnerswinner1_of_pair_0_20_choices(2) then
        winnerswinner1_of_pair_0_20_choices(3) := (not is_set(sums_sum_0(20), 2)) and winnerswinner1_of_pair_0_20_value;
      else
        winnerswinner1_of_pair_0_20_choices(3) := (not is_set(sums_sum_0(20), 2)) or winnerswinner1_of_pair_0_20_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_20_values(i) := is_set(sums_sum_0(21), i + 1);
        if winnerswinner1_of_pair_0_20_choices(i + 1) then
          winnerswinner1_of_pair_0_20_choices(i + 2) := (not is_set(sums_sum_0(20), i + 1)) or
            winnerswinner1_of_pair_0_20_values(i);
        else
          winnerswinner1_of_pair_0_20_choices(i + 2) := (not is_set(sums_sum_0(20), i + 1)) and
            winnerswinner1_of_pair_0_20_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_20_choices(6) then
        winnerswinner1_of_pair_0_20_choices(7) := is_set(sums_sum_0(20), 6) and (not is_set(sums_sum_0(21), 6));
      else
        winnerswinner1_of_pair_0_20_choices(7) := is_set(sums_sum_0(20), 6) or (not is_set(sums_sum_0(21), 6));
      end if;
      if is_set(sums_sum_0(22), 0) then
        winnerswinner1_of_pair_0_22_choice := (not is_set(sums_sum_0(23), 1)) or (not is_set(sums_sum_0(23), 0));
      else
        winnerswinner1_of_pair_0_22_choice := not is_set(sums_sum_0(23), 1);
      end if;
      if is_set(sums_sum_0(22), 1) then
        winnerswinner1_of_pair_0_22_choices(2) := winnerswinner1_of_pair_0_22_choice;
      else
        winnerswinner1_of_pair_0_22_choices(2) := is_set(sums_sum_0(22), 0) and ((sums_sum_0(23) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_22_value := is_set(sums_sum_0(23), 2);
      if winnerswinner1_of_pair_0_22_choices(2) then
        winnerswinner1_of_pair_0_22_choices(3) := (not is_set(sums_sum_0(22), 2)) and winnerswinner1_of_pair_0_22_value;
      else
        winnerswinner1_of_pair_0_22_choices(3) := (not is_set(sums_sum_0(22), 2)) or winnerswinner1_of_pair_0_22_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_22_values(i) := is_set(sums_sum_0(23), i + 1);
        if winnerswinner1_of_pair_0_22_choices(i + 1) then
          winnerswinner1_of_pair_0_22_choices(i + 2) := (not is_set(sums_sum_0(22), i + 1)) or
            winnerswinner1_of_pair_0_22_values(i);
        else
          winnerswinner1_of_pair_0_22_choices(i + 2) := (not is_set(sums_sum_0(22), i + 1)) and
            winnerswinner1_of_pair_0_22_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_22_choices(6) then
        winnerswinner1_of_pair_0_22_choices(7) := is_set(sums_sum_0(22), 6) and (not is_set(sums_sum_0(23), 6));
      else
        winnerswinner1_of_pair_0_22_choices(7) := is_set(sums_sum_0(22), 6) or (not is_set(sums_sum_0(23), 6));
      end if;
      if is_set(sums_sum_0(24), 0) then
        winnerswinner1_of_pair_0_24_choice := (not is_set(sums_sum_0(25), 1)) or (not is_set(sums_sum_0(25), 0));
      else
        winnerswinner1_of_pair_0_24_choice := not is_set(sums_sum_0(25), 1);
      end if;
      if is_set(sums_sum_0(24), 1) then
        winnerswinner1_of_pair_0_24_choices(2) := winnerswinner1_of_pair_0_24_choice;
      else
        winnerswinner1_of_pair_0_24_choices(2) := is_set(sums_sum_0(24), 0) and ((sums_sum_0(25) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_24_value := is_set(sums_sum_0(25), 2);
      if winnerswinner1_of_pair_0_24_choices(2) then
        winnerswinner1_of_pair_0_24_choices(3) := (not is_set(sums_sum_0(24), 2)) and winnerswinner1_of_pair_0_24_value;
      else
        winnerswinner1_of_pair_0_24_choices(3) := (not is_set(sums_sum_0(24), 2)) or winnerswinner1_of_pair_0_24_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_24_values(i) := is_set(sums_sum_0(25), i + 1);
        if winnerswinner1_of_pair_0_24_choices(i + 1) then
          winnerswinner1_of_pair_0_24_choices(i + 2) := (not is_set(sums_sum_0(24), i + 1)) or
            winnerswinner1_of_pair_0_24_values(i);
        else
          winnerswinner1_of_pair_0_24_choices(i + 2) := (not is_set(sums_sum_0(24), i + 1)) and
            winnerswinner1_of_pair_0_24_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_24_choices(6) then
        winnerswinner1_of_pair_0_24_choices(7) := is_set(sums_sum_0(24), 6) and (not is_set(sums_sum_0(25), 6));
      else
        winnerswinner1_of_pair_0_24_choices(7) := is_set(sums_sum_0(24), 6) or (not is_set(sums_sum_0(25), 6));
      end if;
      if is_set(sums_sum_0(26), 0) then
        winnerswinner1_of_pair_0_26_choice := (not is_set(sums_sum_0(27), 1)) or (not is_set(sums_sum_0(27), 0));
      else
        winnerswinner1_of_pair_0_26_choice := not is_set(sums_sum_0(27), 1);
      end if;
      if is_set(sums_sum_0(26), 1) then
        winnerswinner1_of_pair_0_26_choices(2) := winnerswinner1_of_pair_0_26_choice;
      else
        winnerswinner1_of_pair_0_26_choices(2) := is_set(sums_sum_0(26), 0) and ((sums_sum_0(27) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_26_value := is_set(sums_sum_0(27), 2);
      if winnerswinner1_of_pair_0_26_choices(2) then
        winnerswinner1_of_pair_0_26_choices(3) := (not is_set(sums_sum_0(26), 2)) and winnerswinner1_of_pair_0_26_value;
      else
        winnerswinner1_of_pair_0_26_choices(3) := (not is_set(sums_sum_0(26), 2)) or winnerswinner1_of_pair_0_26_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_26_values(i) := is_set(sums_sum_0(27), i + 1);
        if winnerswinner1_of_pair_0_26_choices(i + 1) then
          winnerswinner1_of_pair_0_26_choices(i + 2) := (not is_set(sums_sum_0(26), i + 1)) or
            winnerswinner1_of_pair_0_26_values(i);
        else
          winnerswinner1_of_pair_0_26_choices(i + 2) := (not is_set(sums_sum_0(26), i + 1)) and
            winnerswinner1_of_pair_0_26_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_26_choices(6) then
        winnerswinner1_of_pair_0_26_choices(7) := is_set(sums_sum_0(26), 6) and (not is_set(sums_sum_0(27), 6));
      else
        winnerswinner1_of_pair_0_26_choices(7) := is_set(sums_sum_0(26), 6) or (not is_set(sums_sum_0(27), 6));
      end if;
      if is_set(sums_sum_0(28), 0) then
        winnerswinner1_of_pair_0_28_choice := (not is_set(sums_sum_0(29), 1)) or (not is_set(sums_sum_0(29), 0));
      else
        winnerswinner1_of_pair_0_28_choice := not is_set(sums_sum_0(29), 1);
      end if;
      if is_set(sums_sum_0(28), 1) then
        winnerswinner1_of_pair_0_28_choices(2) := winnerswinner1_of_pair_0_28_choice;
      else
        winnerswinner1_of_pair_0_28_choices(2) := is_set(sums_sum_0(28), 0) and ((sums_sum_0(29) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_28_value := is_set(sums_sum_0(29), 2);
      if winnerswinner1_of_pair_0_28_choices(2) then
        winnerswinner1_of_pair_0_28_choices(3) := (not is_set(sums_sum_0(28), 2)) and winnerswinner1_of_pair_0_28_value;
      else
        winnerswinner1_of_pair_0_28_choices(3) := (not is_set(sums_sum_0(28), 2)) or winnerswinner1_of_pair_0_28_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_28_values(i) := is_set(sums_sum_0(29), i + 1);
        if winnerswinner1_of_pair_0_28_choices(i + 1) then
          winnerswinner1_of_pair_0_28_choices(i + 2) := (not is_set(sums_sum_0(28), i + 1)) or
            winnerswinner1_of_pair_0_28_values(i);
        else
          winnerswinner1_of_pair_0_28_choices(i + 2) := (not is_set(sums_sum_0(28), i + 1)) and
            winnerswinner1_of_pair_0_28_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_28_choices(6) then
        winnerswinner1_of_pair_0_28_choices(7) := is_set(sums_sum_0(28), 6) and (not is_set(sums_sum_0(29), 6));
      else
        winnerswinner1_of_pair_0_28_choices(7) := is_set(sums_sum_0(28), 6) or (not is_set(sums_sum_0(29), 6));
      end if;
      if is_set(sums_sum_0(30), 0) then
        winnerswinner1_of_pair_0_30_choice := (not is_set(sums_sum_0(31), 1)) or (not is_set(sums_sum_0(31), 0));
      else
        winnerswinner1_of_pair_0_30_choice := not is_set(sums_sum_0(31), 1);
      end if;
      if is_set(sums_sum_0(30), 1) then
        winnerswinner1_of_pair_0_30_choices(2) := winnerswinner1_of_pair_0_30_choice;
      else
        winnerswinner1_of_pair_0_30_choices(2) := is_set(sums_sum_0(30), 0) and ((sums_sum_0(31) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_30_value := is_set(sums_sum_0(31), 2);
      if winnerswinner1_of_pair_0_30_choices(2) then
        winnerswinner1_of_pair_0_30_choices(3) := (not is_set(sums_sum_0(30), 2)) and winnerswinner1_of_pair_0_30_value;
      else
        winnerswinner1_of_pair_0_30_choices(3) := (not is_set(sums_sum_0(30), 2)) or winnerswinner1_of_pair_0_30_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_30_values(i) := is_set(sums_sum_0(31), i + 1);
        if winnerswinner1_of_pair_0_30_choices(i + 1) then
          winnerswinner1_of_pair_0_30_choices(i + 2) := (not is_set(sums_sum_0(30), i + 1)) or
            winnerswinner1_of_pair_0_30_values(i);
        else
          winnerswinner1_of_pair_0_30_choices(i + 2) := (not is_set(sums_sum_0(30), i + 1)) and
            winnerswinner1_of_pair_0_30_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_30_choices(6) then
        winnerswinner1_of_pair_0_30_choices(7) := is_set(sums_sum_0(30), 6) and (not is_set(sums_sum_0(31), 6));
      else
        winnerswinner1_of_pair_0_30_choices(7) := is_set(sums_sum_0(30), 6) or (not is_set(sums_sum_0(31), 6));
      end if;
      if is_set(sums_sum_0(32), 0) then
        winnerswinner1_of_pair_0_32_choice := (not is_set(sums_sum_0(33), 1)) or (not is_set(sums_sum_0(33), 0));
      else
        winnerswinner1_of_pair_0_32_choice := not is_set(sums_sum_0(33), 1);
      end if;
      if is_set(sums_sum_0(32), 1) then
        winnerswinner1_of_pair_0_32_choices(2) := winnerswinner1_of_pair_0_32_choice;
      else
        winnerswinner1_of_pair_0_32_choices(2) := is_set(sums_sum_0(32), 0) and ((sums_sum_0(33) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_32_value := is_set(sums_sum_0(33), 2);
      if winnerswinner1_of_pair_0_32_choices(2) then
        winnerswinner1_of_pair_0_32_choices(3) := (not is_set(sums_sum_0(32), 2)) and winnerswinner1_of_pair_0_32_value;
      else
        winnerswinner1_of_pair_0_32_choices(3) := (not is_set(sums_sum_0(32), 2)) or winnerswinner1_of_pair_0_32_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_32_values(i) := is_set(sums_sum_0(33), i + 1);
        if winnerswinner1_of_pair_0_32_choices(i + 1) then
          winnerswinner1_of_pair_0_32_choices(i + 2) := (not is_set(sums_sum_0(32), i + 1)) or
            winnerswinner1_of_pair_0_32_values(i);
        else
          winnerswinner1_of_pair_0_32_choices(i + 2) := (not is_set(sums_sum_0(32), i + 1)) and
            winnerswinner1_of_pair_0_32_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_32_choices(6) then
        winnerswinner1_of_pair_0_32_choices(7) := is_set(sums_sum_0(32), 6) and (not is_set(sums_sum_0(33), 6));
      else
        winnerswinner1_of_pair_0_32_choices(7) := is_set(sums_sum_0(32), 6) or (not is_set(sums_sum_0(33), 6));
      end if;
      if is_set(sums_sum_0(34), 0) then
        winnerswinner1_of_pair_0_34_choice := (not is_set(sums_sum_0(35), 1)) or (not is_set(sums_sum_0(35), 0));
      else
        winnerswinner1_of_pair_0_34_choice := not is_set(sums_sum_0(35), 1);
      end if;
      if is_set(sums_sum_0(34), 1) then
        winnerswinner1_of_pair_0_34_choices(2) := winnerswinner1_of_pair_0_34_choice;
      else
        winnerswinner1_of_pair_0_34_choices(2) := is_set(sums_sum_0(34), 0) and ((sums_sum_0(35) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_34_value := is_set(sums_sum_0(35), 2);
      if winnerswinner1_of_pair_0_34_choices(2) then
        winnerswinner1_of_pair_0_34_choices(3) := (not is_set(sums_sum_0(34), 2)) and winnerswinner1_of_pair_0_34_value;
      else
        winnerswinner1_of_pair_0_34_choices(3) := (not is_set(sums_sum_0(34), 2)) or winnerswinner1_of_pair_0_34_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_34_values(i) := is_set(sums_sum_0(35), i + 1);
        if winnerswinner1_of_pair_0_34_choices(i + 1) then
          winnerswinner1_of_pair_0_34_choices(i + 2) := (not is_set(sums_sum_0(34), i + 1)) or
            winnerswinner1_of_pair_0_34_values(i);
        else
          winnerswinner1_of_pair_0_34_choices(i + 2) := (not is_set(sums_sum_0(34), i + 1)) and
            winnerswinner1_of_pair_0_34_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_34_choices(6) then
        winnerswinner1_of_pair_0_34_choices(7) := is_set(sums_sum_0(34), 6) and (not is_set(sums_sum_0(35), 6));
      else
        winnerswinner1_of_pair_0_34_choices(7) := is_set(sums_sum_0(34), 6) or (not is_set(sums_sum_0(35), 6));
      end if;
      if is_set(sums_sum_0(36), 0) then
        winnerswinner1_of_pair_0_36_choice := (not is_set(sums_sum_0(37), 1)) or (not is_set(sums_sum_0(37), 0));
      else
        winnerswinner1_of_pair_0_36_choice := not is_set(sums_sum_0(37), 1);
      end if;
      if is_set(sums_sum_0(36), 1) then
        winnerswinner1_of_pair_0_36_choices(2) := winnerswinner1_of_pair_0_36_choice;
      else
        winnerswinner1_of_pair_0_36_choices(2) := is_set(sums_sum_0(36), 0) and ((sums_sum_0(37) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_36_value := is_set(sums_sum_0(37), 2);
      if winnerswinner1_of_pair_0_36_choices(2) then
        winnerswinner1_of_pair_0_36_choices(3) := (not is_set(sums_sum_0(36), 2)) and winnerswinner1_of_pair_0_36_value;
      else
        winnerswinner1_of_pair_0_36_choices(3) := (not is_set(sums_sum_0(36), 2)) or winnerswinner1_of_pair_0_36_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_36_values(i) := is_set(sums_sum_0(37), i + 1);
        if winnerswinner1_of_pair_0_36_choices(i + 1) then
          winnerswinner1_of_pair_0_36_choices(i + 2) := (not is_set(sums_sum_0(36), i + 1)) or
            winnerswinner1_of_pair_0_36_values(i);
        else
          winnerswinner1_of_pair_0_36_choices(i + 2) := (not is_set(sums_sum_0(36), i + 1)) and
            winnerswinner1_of_pair_0_36_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_36_choices(6) then
        winnerswinner1_of_pair_0_36_choices(7) := is_set(sums_sum_0(36), 6) and (not is_set(sums_sum_0(37), 6));
      else
        winnerswinner1_of_pair_0_36_choices(7) := is_set(sums_sum_0(36), 6) or (not is_set(sums_sum_0(37), 6));
      end if;
      if is_set(sums_sum_0(38), 0) then
        winnerswinner1_of_pair_0_38_choice := (not is_set(sums_sum_0(39), 1)) or (not is_set(sums_sum_0(39), 0));
      else
        winnerswinner1_of_pair_0_38_choice := not is_set(sums_sum_0(39), 1);
      end if;
      if is_set(sums_sum_0(38), 1) then
        winnerswinner1_of_pair_0_38_choices(2) := winnerswinner1_of_pair_0_38_choice;
      else
        winnerswinner1_of_pair_0_38_choices(2) := is_set(sums_sum_0(38), 0) and ((sums_sum_0(39) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_38_value := is_set(sums_sum_0(39), 2);
      if winnerswinner1_of_pair_0_38_choices(2) then
        winnerswinner1_of_pair_0_38_choices(3) := (not is_set(sums_sum_0(38), 2)) and winnerswinner1_of_pair_0_38_value;
      else
        winnerswinner1_of_pair_0_38_choices(3) := (not is_set(sums_sum_0(38), 2)) or winnerswinner1_of_pair_0_38_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_38_values(i) := is_set(sums_sum_0(39), i + 1);
        if winnerswinner1_of_pair_0_38_choices(i + 1) then
          winnerswinner1_of_pair_0_38_choices(i + 2) := (not is_set(sums_sum_0(38), i + 1)) or
            winnerswinner1_of_pair_0_38_values(i);
        else
          winnerswinner1_of_pair_0_38_choices(i + 2) := (not is_set(sums_sum_0(38), i + 1)) and
            winnerswinner1_of_pair_0_38_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_38_choices(6) then
        winnerswinner1_of_pair_0_38_choices(7) := is_set(sums_sum_0(38), 6) and (not is_set(sums_sum_0(39), 6));
      else
        winnerswinner1_of_pair_0_38_choices(7) := is_set(sums_sum_0(38), 6) or (not is_set(sums_sum_0(39), 6));
      end if;
      if is_set(sums_sum_0(40), 0) then
        winnerswinner1_of_pair_0_40_choice := (not is_set(sums_sum_0(41), 1)) or (not is_set(sums_sum_0(41), 0));
      else
        winnerswinner1_of_pair_0_40_choice := not is_set(sums_sum_0(41), 1);
      end if;
      if is_set(sums_sum_0(40), 1) then
        winnerswinner1_of_pair_0_40_choices(2) := winnerswinner1_of_pair_0_40_choice;
      else
        winnerswinner1_of_pair_0_40_choices(2) := is_set(sums_sum_0(40), 0) and ((sums_sum_0(41) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_40_value := is_set(sums_sum_0(41), 2);
      if winnerswinner1_of_pair_0_40_choices(2) then
        winnerswinner1_of_pair_0_40_choices(3) := (not is_set(sums_sum_0(40), 2)) and winnerswinner1_of_pair_0_40_value;
      else
        winnerswinner1_of_pair_0_40_choices(3) := (not is_set(sums_sum_0(40), 2)) or winnerswinner1_of_pair_0_40_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_40_values(i) := is_set(sums_sum_0(41), i + 1);
        if winnerswinner1_of_pair_0_40_choices(i + 1) then
          winnerswinner1_of_pair_0_40_choices(i + 2) := (not is_set(sums_sum_0(40), i + 1)) or
            winnerswinner1_of_pair_0_40_values(i);
        else
          winnerswinner1_of_pair_0_40_choices(i + 2) := (not is_set(sums_sum_0(40), i + 1)) and
            winnerswinner1_of_pair_0_40_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_40_choices(6) then
        winnerswinner1_of_pair_0_40_choices(7) := is_set(sums_sum_0(40), 6) and (not is_set(sums_sum_0(41), 6));
      else
        winnerswinner1_of_pair_0_40_choices(7) := is_set(sums_sum_0(40), 6) or (not is_set(sums_sum_0(41), 6));
      end if;
      if is_set(sums_sum_0(42), 0) then
        winnerswinner1_of_pair_0_42_choice := (not is_set(sums_sum_0(43), 1)) or (not is_set(sums_sum_0(43), 0));
      else
        winnerswinner1_of_pair_0_42_choice := not is_set(sums_sum_0(43), 1);
      end if;
      if is_set(sums_sum_0(42), 1) then
        winnerswinner1_of_pair_0_42_choices(2) := winnerswinner1_of_pair_0_42_choice;
      else
        winnerswinner1_of_pair_0_42_choices(2) := is_set(sums_sum_0(42), 0) and ((sums_sum_0(43) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_42_value := is_set(sums_sum_0(43), 2);
      if winnerswinner1_of_pair_0_42_choices(2) then
        winnerswinner1_of_pair_0_42_choices(3) := (not is_set(sums_sum_0(42), 2)) and winnerswinner1_of_pair_0_42_value;
      else
        winnerswinner1_of_pair_0_42_choices(3) := (not is_set(sums_sum_0(42), 2)) or winnerswinner1_of_pair_0_42_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_42_values(i) := is_set(sums_sum_0(43), i + 1);
        if winnerswinner1_of_pair_0_42_choices(i + 1) then
          winnerswinner1_of_pair_0_42_choices(i + 2) := (not is_set(sums_sum_0(42), i + 1)) or
            winnerswinner1_of_pair_0_42_values(i);
        else
          winnerswinner1_of_pair_0_42_choices(i + 2) := (not is_set(sums_sum_0(42), i + 1)) and
            winnerswinner1_of_pair_0_42_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_42_choices(6) then
        winnerswinner1_of_pair_0_42_choices(7) := is_set(sums_sum_0(42), 6) and (not is_set(sums_sum_0(43), 6));
      else
        winnerswinner1_of_pair_0_42_choices(7) := is_set(sums_sum_0(42), 6) or (not is_set(sums_sum_0(43), 6));
      end if;
      if is_set(sums_sum_0(44), 0) then
        winnerswinner1_of_pair_0_44_choice := (not is_set(sums_sum_0(45), 1)) or (not is_set(sums_sum_0(45), 0));
      else
        winnerswinner1_of_pair_0_44_choice := not is_set(sums_sum_0(45), 1);
      end if;
      if is_set(sums_sum_0(44), 1) then
        winnerswinner1_of_pair_0_44_choices(2) := winnerswinner1_of_pair_0_44_choice;
      else
        winnerswinner1_of_pair_0_44_choices(2) := is_set(sums_sum_0(44), 0) and ((sums_sum_0(45) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_44_value := is_set(sums_sum_0(45), 2);
      if winnerswinner1_of_pair_0_44_choices(2) then
        winnerswinner1_of_pair_0_44_choices(3) := (not is_set(sums_sum_0(44), 2)) and winnerswinner1_of_pair_0_44_value;
      else
        winnerswinner1_of_pair_0_44_choices(3) := (not is_set(sums_sum_0(44), 2)) or winnerswinner1_of_pair_0_44_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_44_values(i) := is_set(sums_sum_0(45), i + 1);
        if winnerswinner1_of_pair_0_44_choices(i + 1) then
          winnerswinner1_of_pair_0_44_choices(i + 2) := (not is_set(sums_sum_0(44), i + 1)) or
            winnerswinner1_of_pair_0_44_values(i);
        else
          winnerswinner1_of_pair_0_44_choices(i + 2) := (not is_set(sums_sum_0(44), i + 1)) and
            winnerswinner1_of_pair_0_44_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_44_choices(6) then
        winnerswinner1_of_pair_0_44_choices(7) := is_set(sums_sum_0(44), 6) and (not is_set(sums_sum_0(45), 6));
      else
        winnerswinner1_of_pair_0_44_choices(7) := is_set(sums_sum_0(44), 6) or (not is_set(sums_sum_0(45), 6));
      end if;
      if is_set(sums_sum_0(46), 0) then
        winnerswinner1_of_pair_0_46_choice := (not is_set(sums_sum_0(47), 1)) or (not is_set(sums_sum_0(47), 0));
      else
        winnerswinner1_of_pair_0_46_choice := not is_set(sums_sum_0(47), 1);
      end if;
      if is_set(sums_sum_0(46), 1) then
        winnerswinner1_of_pair_0_46_choices(2) := winnerswinner1_of_pair_0_46_choice;
      else
        winnerswinner1_of_pair_0_46_choices(2) := is_set(sums_sum_0(46), 0) and ((sums_sum_0(47) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_46_value := is_set(sums_sum_0(47), 2);
      if winnerswinner1_of_pair_0_46_choices(2) then
        winnerswinner1_of_pair_0_46_choices(3) := (not is_set(sums_sum_0(46), 2)) and winnerswinner1_of_pair_0_46_value;
      else
        winnerswinner1_of_pair_0_46_choices(3) := (not is_set(sums_sum_0(46), 2)) or winnerswinner1_of_pair_0_46_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_46_values(i) := is_set(sums_sum_0(47), i + 1);
        if winnerswinner1_of_pair_0_46_choices(i + 1) then
          winnerswinner1_of_pair_0_46_choices(i + 2) := (not is_set(sums_sum_0(46), i + 1)) or
            winnerswinner1_of_pair_0_46_values(i);
        else
          winnerswinner1_of_pair_0_46_choices(i + 2) := (not is_set(sums_sum_0(46), i + 1)) and
            winnerswinner1_of_pair_0_46_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_46_choices(6) then
        winnerswinner1_of_pair_0_46_choices(7) := is_set(sums_sum_0(46), 6) and (not is_set(sums_sum_0(47), 6));
      else
        winnerswinner1_of_pair_0_46_choices(7) := is_set(sums_sum_0(46), 6) or (not is_set(sums_sum_0(47), 6));
      end if;
      if is_set(sums_sum_0(48), 0) then
        winnerswinner1_of_pair_0_48_choice := (not is_set(sums_sum_0(49), 1)) or (not is_set(sums_sum_0(49), 0));
      else
        winnerswinner1_of_pair_0_48_choice := not is_set(sums_sum_0(49), 1);
      end if;
      if is_set(sums_sum_0(48), 1) then
        winnerswinner1_of_pair_0_48_choices(2) := winnerswinner1_of_pair_0_48_choice;
      else
        winnerswinner1_of_pair_0_48_choices(2) := is_set(sums_sum_0(48), 0) and ((sums_sum_0(49) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_48_value := is_set(sums_sum_0(49), 2);
      if winnerswinner1_of_pair_0_48_choices(2) then
        winnerswinner1_of_pair_0_48_choices(3) := (not is_set(sums_sum_0(48), 2)) and winnerswinner1_of_pair_0_48_value;
      else
        winnerswinner1_of_pair_0_48_choices(3) := (not is_set(sums_sum_0(48), 2)) or winnerswinner1_of_pair_0_48_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_48_values(i) := is_set(sums_sum_0(49), i + 1);
        if winnerswinner1_of_pair_0_48_choices(i + 1) then
          winnerswinner1_of_pair_0_48_choices(i + 2) := (not is_set(sums_sum_0(48), i + 1)) or
            winnerswinner1_of_pair_0_48_values(i);
        else
          winnerswinner1_of_pair_0_48_choices(i + 2) := (not is_set(sums_sum_0(48), i + 1)) and
            winnerswinner1_of_pair_0_48_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_48_choices(6) then
        winnerswinner1_of_pair_0_48_choices(7) := is_set(sums_sum_0(48), 6) and (not is_set(sums_sum_0(49), 6));
      else
        winnerswinner1_of_pair_0_48_choices(7) := is_set(sums_sum_0(48), 6) or (not is_set(sums_sum_0(49), 6));
      end if;
      if is_set(sums_sum_0(50), 0) then
        winnerswinner1_of_pair_0_50_choice := (not is_set(sums_sum_0(51), 1)) or (not is_set(sums_sum_0(51), 0));
      else
        winnerswinner1_of_pair_0_50_choice := not is_set(sums_sum_0(51), 1);
      end if;
      if is_set(sums_sum_0(50), 1) then
        winnerswinner1_of_pair_0_50_choices(2) := winnerswinner1_of_pair_0_50_choice;
      else
        winnerswinner1_of_pair_0_50_choices(2) := is_set(sums_sum_0(50), 0) and ((sums_sum_0(51) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_50_value := is_set(sums_sum_0(51), 2);
      if winnerswinner1_of_pair_0_50_choices(2) then
        winnerswinner1_of_pair_0_50_choices(3) := (not is_set(sums_sum_0(50), 2)) and winnerswinner1_of_pair_0_50_value;
      else
        winnerswinner1_of_pair_0_50_choices(3) := (not is_set(sums_sum_0(50), 2)) or winnerswinner1_of_pair_0_50_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_50_values(i) := is_set(sums_sum_0(51), i + 1);
        if winnerswinner1_of_pair_0_50_choices(i + 1) then
          winnerswinner1_of_pair_0_50_choices(i + 2) := (not is_set(sums_sum_0(50), i + 1)) or
            winnerswinner1_of_pair_0_50_values(i);
        else
          winnerswinner1_of_pair_0_50_choices(i + 2) := (not is_set(sums_sum_0(50), i + 1)) and
            winnerswinner1_of_pair_0_50_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_50_choices(6) then
        winnerswinner1_of_pair_0_50_choices(7) := is_set(sums_sum_0(50), 6) and (not is_set(sums_sum_0(51), 6));
      else
        winnerswinner1_of_pair_0_50_choices(7) := is_set(sums_sum_0(50), 6) or (not is_set(sums_sum_0(51), 6));
      end if;
      if is_set(sums_sum_0(52), 0) then
        winnerswinner1_of_pair_0_52_choice := (not is_set(sums_sum_0(53), 1)) or (not is_set(sums_sum_0(53), 0));
      else
        winnerswinner1_of_pair_0_52_choice := not is_set(sums_sum_0(53), 1);
      end if;
      if is_set(sums_sum_0(52), 1) then
        winnerswinner1_of_pair_0_52_choices(2) := winnerswinner1_of_pair_0_52_choice;
      else
        winnerswinner1_of_pair_0_52_choices(2) := is_set(sums_sum_0(52), 0) and ((sums_sum_0(53) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_52_value := is_set(sums_sum_0(53), 2);
      if winnerswinner1_of_pair_0_52_choices(2) then
        winnerswinner1_of_pair_0_52_choices(3) := (not is_set(sums_sum_0(52), 2)) and winnerswinner1_of_pair_0_52_value;
      else
        winnerswinner1_of_pair_0_52_choices(3) := (not is_set(sums_sum_0(52), 2)) or winnerswinner1_of_pair_0_52_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_52_values(i) := is_set(sums_sum_0(53), i + 1);
        if winnerswinner1_of_pair_0_52_choices(i + 1) then
          winnerswinner1_of_pair_0_52_choices(i + 2) := (not is_set(sums_sum_0(52), i + 1)) or
            winnerswinner1_of_pair_0_52_values(i);
        else
          winnerswinner1_of_pair_0_52_choices(i + 2) := (not is_set(sums_sum_0(52), i + 1)) and
            winnerswinner1_of_pair_0_52_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_52_choices(6) then
        winnerswinner1_of_pair_0_52_choices(7) := is_set(sums_sum_0(52), 6) and (not is_set(sums_sum_0(53), 6));
      else
        winnerswinner1_of_pair_0_52_choices(7) := is_set(sums_sum_0(52), 6) or (not is_set(sums_sum_0(53), 6));
      end if;
      if is_set(sums_sum_0(54), 0) then
        winnerswinner1_of_pair_0_54_choice := (not is_set(sums_sum_0(55), 1)) or (not is_set(sums_sum_0(55), 0));
      else
        winnerswinner1_of_pair_0_54_choice := not is_set(sums_sum_0(55), 1);
      end if;
      if is_set(sums_sum_0(54), 1) then
        winnerswinner1_of_pair_0_54_choices(2) := winnerswinner1_of_pair_0_54_choice;
      else
        winnerswinner1_of_pair_0_54_choices(2) := is_set(sums_sum_0(54), 0) and ((sums_sum_0(55) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_54_value := is_set(sums_sum_0(55), 2);
      if winnerswinner1_of_pair_0_54_choices(2) then
        winnerswinner1_of_pair_0_54_choices(3) := (not is_set(sums_sum_0(54), 2)) and winnerswinner1_of_pair_0_54_value;
      else
        winnerswinner1_of_pair_0_54_choices(3) := (not is_set(sums_sum_0(54), 2)) or winnerswinner1_of_pair_0_54_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_54_values(i) := is_set(sums_sum_0(55), i + 1);
        if winnerswinner1_of_pair_0_54_choices(i + 1) then
          winnerswinner1_of_pair_0_54_choices(i + 2) := (not is_set(sums_sum_0(54), i + 1)) or
            winnerswinner1_of_pair_0_54_values(i);
        else
          winnerswinner1_of_pair_0_54_choices(i + 2) := (not is_set(sums_sum_0(54), i + 1)) and
            winnerswinner1_of_pair_0_54_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_54_choices(6) then
        winnerswinner1_of_pair_0_54_choices(7) := is_set(sums_sum_0(54), 6) and (not is_set(sums_sum_0(55), 6));
      else
        winnerswinner1_of_pair_0_54_choices(7) := is_set(sums_sum_0(54), 6) or (not is_set(sums_sum_0(55), 6));
      end if;
      if is_set(sums_sum_0(56), 0) then
        winnerswinner1_of_pair_0_56_choice := (not is_set(sums_sum_0(57), 1)) or (not is_set(sums_sum_0(57), 0));
      else
        winnerswinner1_of_pair_0_56_choice := not is_set(sums_sum_0(57), 1);
      end if;
      if is_set(sums_sum_0(56), 1) then
        winnerswinner1_of_pair_0_56_choices(2) := winnerswinner1_of_pair_0_56_choice;
      else
        winnerswinner1_of_pair_0_56_choices(2) := is_set(sums_sum_0(56), 0) and ((sums_sum_0(57) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_56_value := is_set(sums_sum_0(57), 2);
      if winnerswinner1_of_pair_0_56_choices(2) then
        winnerswinner1_of_pair_0_56_choices(3) := (not is_set(sums_sum_0(56), 2)) and winnerswinner1_of_pair_0_56_value;
      else
        winnerswinner1_of_pair_0_56_choices(3) := (not is_set(sums_sum_0(56), 2)) or winnerswinner1_of_pair_0_56_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_56_values(i) := is_set(sums_sum_0(57), i + 1);
        if winnerswinner1_of_pair_0_56_choices(i + 1) then
          winnerswinner1_of_pair_0_56_choices(i + 2) := (not is_set(sums_sum_0(56), i + 1)) or
            winnerswinner1_of_pair_0_56_values(i);
        else
          winnerswinner1_of_pair_0_56_choices(i + 2) := (not is_set(sums_sum_0(56), i + 1)) and
            winnerswinner1_of_pair_0_56_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_56_choices(6) then
        winnerswinner1_of_pair_0_56_choices(7) := is_set(sums_sum_0(56), 6) and (not is_set(sums_sum_0(57), 6));
      else
        winnerswinner1_of_pair_0_56_choices(7) := is_set(sums_sum_0(56), 6) or (not is_set(sums_sum_0(57), 6));
      end if;
      if is_set(sums_sum_0(58), 0) then
        winnerswinner1_of_pair_0_58_choice := (not is_set(sums_sum_0(59), 1)) or (not is_set(sums_sum_0(59), 0));
      else
        winnerswinner1_of_pair_0_58_choice := not is_set(sums_sum_0(59), 1);
      end if;
      if is_set(sums_sum_0(58), 1) then
        winnerswinner1_of_pair_0_58_choices(2) := winnerswinner1_of_pair_0_58_choice;
      else
        winnerswinner1_of_pair_0_58_choices(2) := is_set(sums_sum_0(58), 0) and ((sums_sum_0(59) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_58_value := is_set(sums_sum_0(59), 2);
      if winnerswinner1_of_pair_0_58_choices(2) then
        winnerswinner1_of_pair_0_58_choices(3) := (not is_set(sums_sum_0(58), 2)) and winnerswinner1_of_pair_0_58_value;
      else
        winnerswinner1_of_pair_0_58_choices(3) := (not is_set(sums_sum_0(58), 2)) or winnerswinner1_of_pair_0_58_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_58_values(i) := is_set(sums_sum_0(59), i + 1);
        if winnerswinner1_of_pair_0_58_choices(i + 1) then
          winnerswinner1_of_pair_0_58_choices(i + 2) := (not is_set(sums_sum_0(58), i + 1)) or
            winnerswinner1_of_pair_0_58_values(i);
        else
          winnerswinner1_of_pair_0_58_choices(i + 2) := (not is_set(sums_sum_0(58), i + 1)) and
            winnerswinner1_of_pair_0_58_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_58_choices(6) then
        winnerswinner1_of_pair_0_58_choices(7) := is_set(sums_sum_0(58), 6) and (not is_set(sums_sum_0(59), 6));
      else
        winnerswinner1_of_pair_0_58_choices(7) := is_set(sums_sum_0(58), 6) or (not is_set(sums_sum_0(59), 6));
      end if;
      if is_set(sums_sum_0(60), 0) then
        winnerswinner1_of_pair_0_60_choice := (not is_set(sums_sum_0(61), 1)) or (not is_set(sums_sum_0(61), 0));
      else
        winnerswinner1_of_pair_0_60_choice := not is_set(sums_sum_0(61), 1);
      end if;
      if is_set(sums_sum_0(60), 1) then
        winnerswinner1_of_pair_0_60_choices(2) := winnerswinner1_of_pair_0_60_choice;
      else
        winnerswinner1_of_pair_0_60_choices(2) := is_set(sums_sum_0(60), 0) and ((sums_sum_0(61) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_60_value := is_set(sums_sum_0(61), 2);
      if winnerswinner1_of_pair_0_60_choices(2) then
        winnerswinner1_of_pair_0_60_choices(3) := (not is_set(sums_sum_0(60), 2)) and winnerswinner1_of_pair_0_60_value;
      else
        winnerswinner1_of_pair_0_60_choices(3) := (not is_set(sums_sum_0(60), 2)) or winnerswinner1_of_pair_0_60_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_60_values(i) := is_set(sums_sum_0(61), i + 1);
        if winnerswinner1_of_pair_0_60_choices(i + 1) then
          winnerswinner1_of_pair_0_60_choices(i + 2) := (not is_set(sums_sum_0(60), i + 1)) or
            winnerswinner1_of_pair_0_60_values(i);
        else
          winnerswinner1_of_pair_0_60_choices(i + 2) := (not is_set(sums_sum_0(60), i + 1)) and
            winnerswinner1_of_pair_0_60_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_60_choices(6) then
        winnerswinner1_of_pair_0_60_choices(7) := is_set(sums_sum_0(60), 6) and (not is_set(sums_sum_0(61), 6));
      else
        winnerswinner1_of_pair_0_60_choices(7) := is_set(sums_sum_0(60), 6) or (not is_set(sums_sum_0(61), 6));
      end if;
      if is_set(sums_sum_0(62), 0) then
        winnerswinner1_of_pair_0_62_choice := (not is_set(sums_sum_0(63), 1)) or (not is_set(sums_sum_0(63), 0));
      else
        winnerswinner1_of_pair_0_62_choice := not is_set(sums_sum_0(63), 1);
      end if;
      if is_set(sums_sum_0(62), 1) then
        winnerswinner1_of_pair_0_62_choices(2) := winnerswinner1_of_pair_0_62_choice;
      else
        winnerswinner1_of_pair_0_62_choices(2) := is_set(sums_sum_0(62), 0) and ((sums_sum_0(63) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_62_value := is_set(sums_sum_0(63), 2);
      if winnerswinner1_of_pair_0_62_choices(2) then
        winnerswinner1_of_pair_0_62_choices(3) := (not is_set(sums_sum_0(62), 2)) and winnerswinner1_of_pair_0_62_value;
      else
        winnerswinner1_of_pair_0_62_choices(3) := (not is_set(sums_sum_0(62), 2)) or winnerswinner1_of_pair_0_62_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_62_values(i) := is_set(sums_sum_0(63), i + 1);
        if winnerswinner1_of_pair_0_62_choices(i + 1) then
          winnerswinner1_of_pair_0_62_choices(i + 2) := (not is_set(sums_sum_0(62), i + 1)) or
            winnerswinner1_of_pair_0_62_values(i);
        else
          winnerswinner1_of_pair_0_62_choices(i + 2) := (not is_set(sums_sum_0(62), i + 1)) and
            winnerswinner1_of_pair_0_62_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_62_choices(6) then
        winnerswinner1_of_pair_0_62_choices(7) := is_set(sums_sum_0(62), 6) and (not is_set(sums_sum_0(63), 6));
      else
        winnerswinner1_of_pair_0_62_choices(7) := is_set(sums_sum_0(62), 6) or (not is_set(sums_sum_0(63), 6));
      end if;
      if is_set(sums_sum_0(64), 0) then
        winnerswinner1_of_pair_0_64_choice := (not is_set(sums_sum_0(65), 1)) or (not is_set(sums_sum_0(65), 0));
      else
        winnerswinner1_of_pair_0_64_choice := not is_set(sums_sum_0(65), 1);
      end if;
      if is_set(sums_sum_0(64), 1) then
        winnerswinner1_of_pair_0_64_choices(2) := winnerswinner1_of_pair_0_64_choice;
      else
        winnerswinner1_of_pair_0_64_choices(2) := is_set(sums_sum_0(64), 0) and ((sums_sum_0(65) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_64_value := is_set(sums_sum_0(65), 2);
      if winnerswinner1_of_pair_0_64_choices(2) then
        winnerswinner1_of_pair_0_64_choices(3) := (not is_set(sums_sum_0(64), 2)) and winnerswinner1_of_pair_0_64_value;
      else
        winnerswinner1_of_pair_0_64_choices(3) := (not is_set(sums_sum_0(64), 2)) or winnerswinner1_of_pair_0_64_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_64_values(i) := is_set(sums_sum_0(65), i + 1);
        if winnerswinner1_of_pair_0_64_choices(i + 1) then
          winnerswinner1_of_pair_0_64_choices(i + 2) := (not is_set(sums_sum_0(64), i + 1)) or
            winnerswinner1_of_pair_0_64_values(i);
        else
          winnerswinner1_of_pair_0_64_choices(i + 2) := (not is_set(sums_sum_0(64), i + 1)) and
            winnerswinner1_of_pair_0_64_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_64_choices(6) then
        winnerswinner1_of_pair_0_64_choices(7) := is_set(sums_sum_0(64), 6) and (not is_set(sums_sum_0(65), 6));
      else
        winnerswinner1_of_pair_0_64_choices(7) := is_set(sums_sum_0(64), 6) or (not is_set(sums_sum_0(65), 6));
      end if;
      if is_set(sums_sum_0(66), 0) then
        winnerswinner1_of_pair_0_66_choice := (not is_set(sums_sum_0(67), 1)) or (not is_set(sums_sum_0(67), 0));
      else
        winnerswinner1_of_pair_0_66_choice := not is_set(sums_sum_0(67), 1);
      end if;
      if is_set(sums_sum_0(66), 1) then
        winnerswinner1_of_pair_0_66_choices(2) := winnerswinner1_of_pair_0_66_choice;
      else
        winnerswinner1_of_pair_0_66_choices(2) := is_set(sums_sum_0(66), 0) and ((sums_sum_0(67) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_66_value := is_set(sums_sum_0(67), 2);
      if winnerswinner1_of_pair_0_66_choices(2) then
        winnerswinner1_of_pair_0_66_choices(3) := (not is_set(sums_sum_0(66), 2)) and winnerswinner1_of_pair_0_66_value;
      else
        winnerswinner1_of_pair_0_66_choices(3) := (not is_set(sums_sum_0(66), 2)) or winnerswinner1_of_pair_0_66_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_66_values(i) := is_set(sums_sum_0(67), i + 1);
        if winnerswinner1_of_pair_0_66_choices(i + 1) then
          winnerswinner1_of_pair_0_66_choices(i + 2) := (not is_set(sums_sum_0(66), i + 1)) or
            winnerswinner1_of_pair_0_66_values(i);
        else
          winnerswinner1_of_pair_0_66_choices(i + 2) := (not is_set(sums_sum_0(66), i + 1)) and
            winnerswinner1_of_pair_0_66_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_66_choices(6) then
        winnerswinner1_of_pair_0_66_choices(7) := is_set(sums_sum_0(66), 6) and (not is_set(sums_sum_0(67), 6));
      else
        winnerswinner1_of_pair_0_66_choices(7) := is_set(sums_sum_0(66), 6) or (not is_set(sums_sum_0(67), 6));
      end if;
      if is_set(sums_sum_0(68), 0) then
        winnerswinner1_of_pair_0_68_choice := (not is_set(sums_sum_0(69), 1)) or (not is_set(sums_sum_0(69), 0));
      else
        winnerswinner1_of_pair_0_68_choice := not is_set(sums_sum_0(69), 1);
      end if;
      if is_set(sums_sum_0(68), 1) then
        winnerswinner1_of_pair_0_68_choices(2) := winnerswinner1_of_pair_0_68_choice;
      else
        winnerswinner1_of_pair_0_68_choices(2) := is_set(sums_sum_0(68), 0) and ((sums_sum_0(69) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_68_value := is_set(sums_sum_0(69), 2);
      if winnerswinner1_of_pair_0_68_choices(2) then
        winnerswinner1_of_pair_0_68_choices(3) := (not is_set(sums_sum_0(68), 2)) and winnerswinner1_of_pair_0_68_value;
      else
        winnerswinner1_of_pair_0_68_choices(3) := (not is_set(sums_sum_0(68), 2)) or winnerswinner1_of_pair_0_68_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_68_values(i) := is_set(sums_sum_0(69), i + 1);
        if winnerswinner1_of_pair_0_68_choices(i + 1) then
          winnerswinner1_of_pair_0_68_choices(i + 2) := (not is_set(sums_sum_0(68), i + 1)) or
            winnerswinner1_of_pair_0_68_values(i);
        else
          winnerswinner1_of_pair_0_68_choices(i + 2) := (not is_set(sums_sum_0(68), i + 1)) and
            winnerswinner1_of_pair_0_68_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_68_choices(6) then
        winnerswinner1_of_pair_0_68_choices(7) := is_set(sums_sum_0(68), 6) and (not is_set(sums_sum_0(69), 6));
      else
        winnerswinner1_of_pair_0_68_choices(7) := is_set(sums_sum_0(68), 6) or (not is_set(sums_sum_0(69), 6));
      end if;
      if is_set(sums_sum_0(70), 0) then
        winnerswinner1_of_pair_0_70_choice := (not is_set(sums_sum_0(71), 1)) or (not is_set(sums_sum_0(71), 0));
      else
        winnerswinner1_of_pair_0_70_choice := not is_set(sums_sum_0(71), 1);
      end if;
      if is_set(sums_sum_0(70), 1) then
        winnerswinner1_of_pair_0_70_choices(2) := winnerswinner1_of_pair_0_70_choice;
      else
        winnerswinner1_of_pair_0_70_choices(2) := is_set(sums_sum_0(70), 0) and ((sums_sum_0(71) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_70_value := is_set(sums_sum_0(71), 2);
      if winnerswinner1_of_pair_0_70_choices(2) then
        winnerswinner1_of_pair_0_70_choices(3) := (not is_set(sums_sum_0(70), 2)) and winnerswinner1_of_pair_0_70_value;
      else
        winnerswinner1_of_pair_0_70_choices(3) := (not is_set(sums_sum_0(70), 2)) or winnerswinner1_of_pair_0_70_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_70_values(i) := is_set(sums_sum_0(71), i + 1);
        if winnerswinner1_of_pair_0_70_choices(i + 1) then
          winnerswinner1_of_pair_0_70_choices(i + 2) := (not is_set(sums_sum_0(70), i + 1)) or
            winnerswinner1_of_pair_0_70_values(i);
        else
          winnerswinner1_of_pair_0_70_choices(i + 2) := (not is_set(sums_sum_0(70), i + 1)) and
            winnerswinner1_of_pair_0_70_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_70_choices(6) then
        winnerswinner1_of_pair_0_70_choices(7) := is_set(sums_sum_0(70), 6) and (not is_set(sums_sum_0(71), 6));
      else
        winnerswinner1_of_pair_0_70_choices(7) := is_set(sums_sum_0(70), 6) or (not is_set(sums_sum_0(71), 6));
      end if;
      if is_set(sums_sum_0(72), 0) then
        winnerswinner1_of_pair_0_72_choice := (not is_set(sums_sum_0(73), 1)) or (not is_set(sums_sum_0(73), 0));
      else
        winnerswinner1_of_pair_0_72_choice := not is_set(sums_sum_0(73), 1);
      end if;
      if is_set(sums_sum_0(72), 1) then
        winnerswinner1_of_pair_0_72_choices(2) := winnerswinner1_of_pair_0_72_choice;
      else
        winnerswinner1_of_pair_0_72_choices(2) := is_set(sums_sum_0(72), 0) and ((sums_sum_0(73) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_72_value := is_set(sums_sum_0(73), 2);
      if winnerswinner1_of_pair_0_72_choices(2) then
        winnerswinner1_of_pair_0_72_choices(3) := (not is_set(sums_sum_0(72), 2)) and winnerswinner1_of_pair_0_72_value;
      else
        winnerswinner1_of_pair_0_72_choices(3) := (not is_set(sums_sum_0(72), 2)) or winnerswinner1_of_pair_0_72_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_72_values(i) := is_set(sums_sum_0(73), i + 1);
        if winnerswinner1_of_pair_0_72_choices(i + 1) then
          winnerswinner1_of_pair_0_72_choices(i + 2) := (not is_set(sums_sum_0(72), i + 1)) or
            winnerswinner1_of_pair_0_72_values(i);
        else
          winnerswinner1_of_pair_0_72_choices(i + 2) := (not is_set(sums_sum_0(72), i + 1)) and
            winnerswinner1_of_pair_0_72_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_72_choices(6) then
        winnerswinner1_of_pair_0_72_choices(7) := is_set(sums_sum_0(72), 6) and (not is_set(sums_sum_0(73), 6));
      else
        winnerswinner1_of_pair_0_72_choices(7) := is_set(sums_sum_0(72), 6) or (not is_set(sums_sum_0(73), 6));
      end if;
      if is_set(sums_sum_0(74), 0) then
        winnerswinner1_of_pair_0_74_choice := (not is_set(sums_sum_0(75), 1)) or (not is_set(sums_sum_0(75), 0));
      else
        winnerswinner1_of_pair_0_74_choice := not is_set(sums_sum_0(75), 1);
      end if;
      if is_set(sums_sum_0(74), 1) then
        winnerswinner1_of_pair_0_74_choices(2) := winnerswinner1_of_pair_0_74_choice;
      else
        winnerswinner1_of_pair_0_74_choices(2) := is_set(sums_sum_0(74), 0) and ((sums_sum_0(75) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_74_value := is_set(sums_sum_0(75), 2);
      if winnerswinner1_of_pair_0_74_choices(2) then
        winnerswinner1_of_pair_0_74_choices(3) := (not is_set(sums_sum_0(74), 2)) and winnerswinner1_of_pair_0_74_value;
      else
        winnerswinner1_of_pair_0_74_choices(3) := (not is_set(sums_sum_0(74), 2)) or winnerswinner1_of_pair_0_74_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_74_values(i) := is_set(sums_sum_0(75), i + 1);
        if winnerswinner1_of_pair_0_74_choices(i + 1) then
          winnerswinner1_of_pair_0_74_choices(i + 2) := (not is_set(sums_sum_0(74), i + 1)) or
            winnerswinner1_of_pair_0_74_values(i);
        else
          winnerswinner1_of_pair_0_74_choices(i + 2) := (not is_set(sums_sum_0(74), i + 1)) and
            winnerswinner1_of_pair_0_74_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_74_choices(6) then
        winnerswinner1_of_pair_0_74_choices(7) := is_set(sums_sum_0(74), 6) and (not is_set(sums_sum_0(75), 6));
      else
        winnerswinner1_of_pair_0_74_choices(7) := is_set(sums_sum_0(74), 6) or (not is_set(sums_sum_0(75), 6));
      end if;
      if is_set(sums_sum_0(76), 0) then
        winnerswinner1_of_pair_0_76_choice := (not is_set(sums_sum_0(77), 1)) or (not is_set(sums_sum_0(77), 0));
      else
        winnerswinner1_of_pair_0_76_choice := not is_set(sums_sum_0(77), 1);
      end if;
      if is_set(sums_sum_0(76), 1) then
        winnerswinner1_of_pair_0_76_choices(2) := winnerswinner1_of_pair_0_76_choice;
      else
        winnerswinner1_of_pair_0_76_choices(2) := is_set(sums_sum_0(76), 0) and ((sums_sum_0(77) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_76_value := is_set(sums_sum_0(77), 2);
      if winnerswinner1_of_pair_0_76_choices(2) then
        winnerswinner1_of_pair_0_76_choices(3) := (not is_set(sums_sum_0(76), 2)) and winnerswinner1_of_pair_0_76_value;
      else
        winnerswinner1_of_pair_0_76_choices(3) := (not is_set(sums_sum_0(76), 2)) or winnerswinner1_of_pair_0_76_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_76_values(i) := is_set(sums_sum_0(77), i + 1);
        if winnerswinner1_of_pair_0_76_choices(i + 1) then
          winnerswinner1_of_pair_0_76_choices(i + 2) := (not is_set(sums_sum_0(76), i + 1)) or
            winnerswinner1_of_pair_0_76_values(i);
        else
          winnerswinner1_of_pair_0_76_choices(i + 2) := (not is_set(sums_sum_0(76), i + 1)) and
            winnerswinner1_of_pair_0_76_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_76_choices(6) then
        winnerswinner1_of_pair_0_76_choices(7) := is_set(sums_sum_0(76), 6) and (not is_set(sums_sum_0(77), 6));
      else
        winnerswinner1_of_pair_0_76_choices(7) := is_set(sums_sum_0(76), 6) or (not is_set(sums_sum_0(77), 6));
      end if;
      if is_set(sums_sum_0(78), 0) then
        winnerswinner1_of_pair_0_78_choice := (not is_set(sums_sum_0(79), 1)) or (not is_set(sums_sum_0(79), 0));
      else
        winnerswinner1_of_pair_0_78_choice := not is_set(sums_sum_0(79), 1);
      end if;
      if is_set(sums_sum_0(78), 1) then
        winnerswinner1_of_pair_0_78_choices(2) := winnerswinner1_of_pair_0_78_choice;
      else
        winnerswinner1_of_pair_0_78_choices(2) := is_set(sums_sum_0(78), 0) and ((sums_sum_0(79) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_78_value := is_set(sums_sum_0(79), 2);
      if winnerswinner1_of_pair_0_78_choices(2) then
        winnerswinner1_of_pair_0_78_choices(3) := (not is_set(sums_sum_0(78), 2)) and winnerswinner1_of_pair_0_78_value;
      else
        winnerswinner1_of_pair_0_78_choices(3) := (not is_set(sums_sum_0(78), 2)) or winnerswinner1_of_pair_0_78_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_78_values(i) := is_set(sums_sum_0(79), i + 1);
        if winnerswinner1_of_pair_0_78_choices(i + 1) then
          winnerswinner1_of_pair_0_78_choices(i + 2) := (not is_set(sums_sum_0(78), i + 1)) or
            winnerswinner1_of_pair_0_78_values(i);
        else
          winnerswinner1_of_pair_0_78_choices(i + 2) := (not is_set(sums_sum_0(78), i + 1)) and
            winnerswinner1_of_pair_0_78_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_78_choices(6) then
        winnerswinner1_of_pair_0_78_choices(7) := is_set(sums_sum_0(78), 6) and (not is_set(sums_sum_0(79), 6));
      else
        winnerswinner1_of_pair_0_78_choices(7) := is_set(sums_sum_0(78), 6) or (not is_set(sums_sum_0(79), 6));
      end if;
      if is_set(sums_sum_0(80), 0) then
        winnerswinner1_of_pair_0_80_choice := (not is_set(sums_sum_0(81), 1)) or (not is_set(sums_sum_0(81), 0));
      else
        winnerswinner1_of_pair_0_80_choice := not is_set(sums_sum_0(81), 1);
      end if;
      if is_set(sums_sum_0(80), 1) then
        winnerswinner1_of_pair_0_80_choices(2) := winnerswinner1_of_pair_0_80_choice;
      else
        winnerswinner1_of_pair_0_80_choices(2) := is_set(sums_sum_0(80), 0) and ((sums_sum_0(81) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_80_value := is_set(sums_sum_0(81), 2);
      if winnerswinner1_of_pair_0_80_choices(2) then
        winnerswinner1_of_pair_0_80_choices(3) := (not is_set(sums_sum_0(80), 2)) and winnerswinner1_of_pair_0_80_value;
      else
        winnerswinner1_of_pair_0_80_choices(3) := (not is_set(sums_sum_0(80), 2)) or winnerswinner1_of_pair_0_80_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_80_values(i) := is_set(sums_sum_0(81), i + 1);
        if winnerswinner1_of_pair_0_80_choices(i + 1) then
          winnerswinner1_of_pair_0_80_choices(i + 2) := (not is_set(sums_sum_0(80), i + 1)) or
            winnerswinner1_of_pair_0_80_values(i);
        else
          winnerswinner1_of_pair_0_80_choices(i + 2) := (not is_set(sums_sum_0(80), i + 1)) and
            winnerswinner1_of_pair_0_80_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_80_choices(6) then
        winnerswinner1_of_pair_0_80_choices(7) := is_set(sums_sum_0(80), 6) and (not is_set(sums_sum_0(81), 6));
      else
        winnerswinner1_of_pair_0_80_choices(7) := is_set(sums_sum_0(80), 6) or (not is_set(sums_sum_0(81), 6));
      end if;
      if is_set(sums_sum_0(82), 0) then
        winnerswinner1_of_pair_0_82_choice := (not is_set(sums_sum_0(83), 1)) or (not is_set(sums_sum_0(83), 0));
      else
        winnerswinner1_of_pair_0_82_choice := not is_set(sums_sum_0(83), 1);
      end if;
      if is_set(sums_sum_0(82), 1) then
        winnerswinner1_of_pair_0_82_choices(2) := winnerswinner1_of_pair_0_82_choice;
      else
        winnerswinner1_of_pair_0_82_choices(2) := is_set(sums_sum_0(82), 0) and ((sums_sum_0(83) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_82_value := is_set(sums_sum_0(83), 2);
      if winnerswinner1_of_pair_0_82_choices(2) then
        winnerswinner1_of_pair_0_82_choices(3) := (not is_set(sums_sum_0(82), 2)) and winnerswinner1_of_pair_0_82_value;
      else
        winnerswinner1_of_pair_0_82_choices(3) := (not is_set(sums_sum_0(82), 2)) or winnerswinner1_of_pair_0_82_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_82_values(i) := is_set(sums_sum_0(83), i + 1);
        if winnerswinner1_of_pair_0_82_choices(i + 1) then
          winnerswinner1_of_pair_0_82_choices(i + 2) := (not is_set(sums_sum_0(82), i + 1)) or
            winnerswinner1_of_pair_0_82_values(i);
        else
          winnerswinner1_of_pair_0_82_choices(i + 2) := (not is_set(sums_sum_0(82), i + 1)) and
            winnerswinner1_of_pair_0_82_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_82_choices(6) then
        winnerswinner1_of_pair_0_82_choices(7) := is_set(sums_sum_0(82), 6) and (not is_set(sums_sum_0(83), 6));
      else
        winnerswinner1_of_pair_0_82_choices(7) := is_set(sums_sum_0(82), 6) or (not is_set(sums_sum_0(83), 6));
      end if;
      if is_set(sums_sum_0(84), 0) then
        winnerswinner1_of_pair_0_84_choice := (not is_set(sums_sum_0(85), 1)) or (not is_set(sums_sum_0(85), 0));
      else
        winnerswinner1_of_pair_0_84_choice := not is_set(sums_sum_0(85), 1);
      end if;
      if is_set(sums_sum_0(84), 1) then
        winnerswinner1_of_pair_0_84_choices(2) := winnerswinner1_of_pair_0_84_choice;
      else
        winnerswinner1_of_pair_0_84_choices(2) := is_set(sums_sum_0(84), 0) and ((sums_sum_0(85) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_84_value := is_set(sums_sum_0(85), 2);
      if winnerswinner1_of_pair_0_84_choices(2) then
        winnerswinner1_of_pair_0_84_choices(3) := (not is_set(sums_sum_0(84), 2)) and winnerswinner1_of_pair_0_84_value;
      else
        winnerswinner1_of_pair_0_84_choices(3) := (not is_set(sums_sum_0(84), 2)) or winnerswinner1_of_pair_0_84_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_84_values(i) := is_set(sums_sum_0(85), i + 1);
        if winnerswinner1_of_pair_0_84_choices(i + 1) then
          winnerswinner1_of_pair_0_84_choices(i + 2) := (not is_set(sums_sum_0(84), i + 1)) or
            winnerswinner1_of_pair_0_84_values(i);
        else
          winnerswinner1_of_pair_0_84_choices(i + 2) := (not is_set(sums_sum_0(84), i + 1)) and
            winnerswinner1_of_pair_0_84_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_84_choices(6) then
        winnerswinner1_of_pair_0_84_choices(7) := is_set(sums_sum_0(84), 6) and (not is_set(sums_sum_0(85), 6));
      else
        winnerswinner1_of_pair_0_84_choices(7) := is_set(sums_sum_0(84), 6) or (not is_set(sums_sum_0(85), 6));
      end if;
      if is_set(sums_sum_0(86), 0) then
        winnerswinner1_of_pair_0_86_choice := (not is_set(sums_sum_0(87), 1)) or (not is_set(sums_sum_0(87), 0));
      else
        winnerswinner1_of_pair_0_86_choice := not is_set(sums_sum_0(87), 1);
      end if;
      if is_set(sums_sum_0(86), 1) then
        winnerswinner1_of_pair_0_86_choices(2) := winnerswinner1_of_pair_0_86_choice;
      else
        winnerswinner1_of_pair_0_86_choices(2) := is_set(sums_sum_0(86), 0) and ((sums_sum_0(87) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_86_value := is_set(sums_sum_0(87), 2);
      if winnerswinner1_of_pair_0_86_choices(2) then
        winnerswinner1_of_pair_0_86_choices(3) := (not is_set(sums_sum_0(86), 2)) and winnerswinner1_of_pair_0_86_value;
      else
        winnerswinner1_of_pair_0_86_choices(3) := (not is_set(sums_sum_0(86), 2)) or winnerswinner1_of_pair_0_86_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_86_values(i) := is_set(sums_sum_0(87), i + 1);
        if winnerswinner1_of_pair_0_86_choices(i + 1) then
          winnerswinner1_of_pair_0_86_choices(i + 2) := (not is_set(sums_sum_0(86), i + 1)) or
            winnerswinner1_of_pair_0_86_values(i);
        else
          winnerswinner1_of_pair_0_86_choices(i + 2) := (not is_set(sums_sum_0(86), i + 1)) and
            winnerswinner1_of_pair_0_86_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_86_choices(6) then
        winnerswinner1_of_pair_0_86_choices(7) := is_set(sums_sum_0(86), 6) and (not is_set(sums_sum_0(87), 6));
      else
        winnerswinner1_of_pair_0_86_choices(7) := is_set(sums_sum_0(86), 6) or (not is_set(sums_sum_0(87), 6));
      end if;
      if is_set(sums_sum_0(88), 0) then
        winnerswinner1_of_pair_0_88_choice := (not is_set(sums_sum_0(89), 1)) or (not is_set(sums_sum_0(89), 0));
      else
        winnerswinner1_of_pair_0_88_choice := not is_set(sums_sum_0(89), 1);
      end if;
      if is_set(sums_sum_0(88), 1) then
        winnerswinner1_of_pair_0_88_choices(2) := winnerswinner1_of_pair_0_88_choice;
      else
        winnerswinner1_of_pair_0_88_choices(2) := is_set(sums_sum_0(88), 0) and ((sums_sum_0(89) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_88_value := is_set(sums_sum_0(89), 2);
      if winnerswinner1_of_pair_0_88_choices(2) then
        winnerswinner1_of_pair_0_88_choices(3) := (not is_set(sums_sum_0(88), 2)) and winnerswinner1_of_pair_0_88_value;
      else
        winnerswinner1_of_pair_0_88_choices(3) := (not is_set(sums_sum_0(88), 2)) or winnerswinner1_of_pair_0_88_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_88_values(i) := is_set(sums_sum_0(89), i + 1);
        if winnerswinner1_of_pair_0_88_choices(i + 1) then
          winnerswinner1_of_pair_0_88_choices(i + 2) := (not is_set(sums_sum_0(88), i + 1)) or
            winnerswinner1_of_pair_0_88_values(i);
        else
          winnerswinner1_of_pair_0_88_choices(i + 2) := (not is_set(sums_sum_0(88), i + 1)) and
            winnerswinner1_of_pair_0_88_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_88_choices(6) then
        winnerswinner1_of_pair_0_88_choices(7) := is_set(sums_sum_0(88), 6) and (not is_set(sums_sum_0(89), 6));
      else
        winnerswinner1_of_pair_0_88_choices(7) := is_set(sums_sum_0(88), 6) or (not is_set(sums_sum_0(89), 6));
      end if;
      if is_set(sums_sum_0(90), 0) then
        winnerswinner1_of_pair_0_90_choice := (not is_set(sums_sum_0(91), 1)) or (not is_set(sums_sum_0(91), 0));
      else
        winnerswinner1_of_pair_0_90_choice := not is_set(sums_sum_0(91), 1);
      end if;
      if is_set(sums_sum_0(90), 1) then
        winnerswinner1_of_pair_0_90_choices(2) := winnerswinner1_of_pair_0_90_choice;
      else
        winnerswinner1_of_pair_0_90_choices(2) := is_set(sums_sum_0(90), 0) and ((sums_sum_0(91) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_90_value := is_set(sums_sum_0(91), 2);
      if winnerswinner1_of_pair_0_90_choices(2) then
        winnerswinner1_of_pair_0_90_choices(3) := (not is_set(sums_sum_0(90), 2)) and winnerswinner1_of_pair_0_90_value;
      else
        winnerswinner1_of_pair_0_90_choices(3) := (not is_set(sums_sum_0(90), 2)) or winnerswinner1_of_pair_0_90_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_90_values(i) := is_set(sums_sum_0(91), i + 1);
        if winnerswinner1_of_pair_0_90_choices(i + 1) then
          winnerswinner1_of_pair_0_90_choices(i + 2) := (not is_set(sums_sum_0(90), i + 1)) or
            winnerswinner1_of_pair_0_90_values(i);
        else
          winnerswinner1_of_pair_0_90_choices(i + 2) := (not is_set(sums_sum_0(90), i + 1)) and
            winnerswinner1_of_pair_0_90_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_90_choices(6) then
        winnerswinner1_of_pair_0_90_choices(7) := is_set(sums_sum_0(90), 6) and (not is_set(sums_sum_0(91), 6));
      else
        winnerswinner1_of_pair_0_90_choices(7) := is_set(sums_sum_0(90), 6) or (not is_set(sums_sum_0(91), 6));
      end if;
      if is_set(sums_sum_0(92), 0) then
        winnerswinner1_of_pair_0_92_choice := (not is_set(sums_sum_0(93), 1)) or (not is_set(sums_sum_0(93), 0));
      else
        winnerswinner1_of_pair_0_92_choice := not is_set(sums_sum_0(93), 1);
      end if;
      if is_set(sums_sum_0(92), 1) then
        winnerswinner1_of_pair_0_92_choices(2) := winnerswinner1_of_pair_0_92_choice;
      else
        winnerswinner1_of_pair_0_92_choices(2) := is_set(sums_sum_0(92), 0) and ((sums_sum_0(93) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_92_value := is_set(sums_sum_0(93), 2);
      if winnerswinner1_of_pair_0_92_choices(2) then
        winnerswinner1_of_pair_0_92_choices(3) := (not is_set(sums_sum_0(92), 2)) and winnerswinner1_of_pair_0_92_value;
      else
        winnerswinner1_of_pair_0_92_choices(3) := (not is_set(sums_sum_0(92), 2)) or winnerswinner1_of_pair_0_92_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_92_values(i) := is_set(sums_sum_0(93), i + 1);
        if winnerswinner1_of_pair_0_92_choices(i + 1) then
          winnerswinner1_of_pair_0_92_choices(i + 2) := (not is_set(sums_sum_0(92), i + 1)) or
            winnerswinner1_of_pair_0_92_values(i);
        else
          winnerswinner1_of_pair_0_92_choices(i + 2) := (not is_set(sums_sum_0(92), i + 1)) and
            winnerswinner1_of_pair_0_92_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_92_choices(6) then
        winnerswinner1_of_pair_0_92_choices(7) := is_set(sums_sum_0(92), 6) and (not is_set(sums_sum_0(93), 6));
      else
        winnerswinner1_of_pair_0_92_choices(7) := is_set(sums_sum_0(92), 6) or (not is_set(sums_sum_0(93), 6));
      end if;
      if is_set(sums_sum_0(94), 0) then
        winnerswinner1_of_pair_0_94_choice := (not is_set(sums_sum_0(95), 1)) or (not is_set(sums_sum_0(95), 0));
      else
        winnerswinner1_of_pair_0_94_choice := not is_set(sums_sum_0(95), 1);
      end if;
      if is_set(sums_sum_0(94), 1) then
        winnerswinner1_of_pair_0_94_choices(2) := winnerswinner1_of_pair_0_94_choice;
      else
        winnerswinner1_of_pair_0_94_choices(2) := is_set(sums_sum_0(94), 0) and ((sums_sum_0(95) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_94_value := is_set(sums_sum_0(95), 2);
      if winnerswinner1_of_pair_0_94_choices(2) then
        winnerswinner1_of_pair_0_94_choices(3) := (not is_set(sums_sum_0(94), 2)) and winnerswinner1_of_pair_0_94_value;
      else
        winnerswinner1_of_pair_0_94_choices(3) := (not is_set(sums_sum_0(94), 2)) or winnerswinner1_of_pair_0_94_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_94_values(i) := is_set(sums_sum_0(95), i + 1);
        if winnerswinner1_of_pair_0_94_choices(i + 1) then
          winnerswinner1_of_pair_0_94_choices(i + 2) := (not is_set(sums_sum_0(94), i + 1)) or
            winnerswinner1_of_pair_0_94_values(i);
        else
          winnerswinner1_of_pair_0_94_choices(i + 2) := (not is_set(sums_sum_0(94), i + 1)) and
            winnerswinner1_of_pair_0_94_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_94_choices(6) then
        winnerswinner1_of_pair_0_94_choices(7) := is_set(sums_sum_0(94), 6) and (not is_set(sums_sum_0(95), 6));
      else
        winnerswinner1_of_pair_0_94_choices(7) := is_set(sums_sum_0(94), 6) or (not is_set(sums_sum_0(95), 6));
      end if;
      if is_set(sums_sum_0(96), 0) then
        winnerswinner1_of_pair_0_96_choice := (not is_set(sums_sum_0(97), 1)) or (not is_set(sums_sum_0(97), 0));
      else
        winnerswinner1_of_pair_0_96_choice := not is_set(sums_sum_0(97), 1);
      end if;
      if is_set(sums_sum_0(96), 1) then
        winnerswinner1_of_pair_0_96_choices(2) := winnerswinner1_of_pair_0_96_choice;
      else
        winnerswinner1_of_pair_0_96_choices(2) := is_set(sums_sum_0(96), 0) and ((sums_sum_0(97) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_96_value := is_set(sums_sum_0(97), 2);
      if winnerswinner1_of_pair_0_96_choices(2) then
        winnerswinner1_of_pair_0_96_choices(3) := (not is_set(sums_sum_0(96), 2)) and winnerswinner1_of_pair_0_96_value;
      else
        winnerswinner1_of_pair_0_96_choices(3) := (not is_set(sums_sum_0(96), 2)) or winnerswinner1_of_pair_0_96_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_96_values(i) := is_set(sums_sum_0(97), i + 1);
        if winnerswinner1_of_pair_0_96_choices(i + 1) then
          winnerswinner1_of_pair_0_96_choices(i + 2) := (not is_set(sums_sum_0(96), i + 1)) or
            winnerswinner1_of_pair_0_96_values(i);
        else
          winnerswinner1_of_pair_0_96_choices(i + 2) := (not is_set(sums_sum_0(96), i + 1)) and
            winnerswinner1_of_pair_0_96_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_96_choices(6) then
        winnerswinner1_of_pair_0_96_choices(7) := is_set(sums_sum_0(96), 6) and (not is_set(sums_sum_0(97), 6));
      else
        winnerswinner1_of_pair_0_96_choices(7) := is_set(sums_sum_0(96), 6) or (not is_set(sums_sum_0(97), 6));
      end if;
      if is_set(sums_sum_0(98), 0) then
        winnerswinner1_of_pair_0_98_choice := (not is_set(sums_sum_0(99), 1)) or (not is_set(sums_sum_0(99), 0));
      else
        winnerswinner1_of_pair_0_98_choice := not is_set(sums_sum_0(99), 1);
      end if;
      if is_set(sums_sum_0(98), 1) then
        winnerswinner1_of_pair_0_98_choices(2) := winnerswinner1_of_pair_0_98_choice;
      else
        winnerswinner1_of_pair_0_98_choices(2) := is_set(sums_sum_0(98), 0) and ((sums_sum_0(99) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_98_value := is_set(sums_sum_0(99), 2);
      if winnerswinner1_of_pair_0_98_choices(2) then
        winnerswinner1_of_pair_0_98_choices(3) := (not is_set(sums_sum_0(98), 2)) and winnerswinner1_of_pair_0_98_value;
      else
        winnerswinner1_of_pair_0_98_choices(3) := (not is_set(sums_sum_0(98), 2)) or winnerswinner1_of_pair_0_98_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_98_values(i) := is_set(sums_sum_0(99), i + 1);
        if winnerswinner1_of_pair_0_98_choices(i + 1) then
          winnerswinner1_of_pair_0_98_choices(i + 2) := (not is_set(sums_sum_0(98), i + 1)) or
            winnerswinner1_of_pair_0_98_values(i);
        else
          winnerswinner1_of_pair_0_98_choices(i + 2) := (not is_set(sums_sum_0(98), i + 1)) and
            winnerswinner1_of_pair_0_98_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_98_choices(6) then
        winnerswinner1_of_pair_0_98_choices(7) := is_set(sums_sum_0(98), 6) and (not is_set(sums_sum_0(99), 6));
      else
        winnerswinner1_of_pair_0_98_choices(7) := is_set(sums_sum_0(98), 6) or (not is_set(sums_sum_0(99), 6));
      end if;
      if is_set(sums_sum_0(100), 0) then
        winnerswinner1_of_pair_0_100_choice := (not is_set(sums_sum_0(101), 1)) or (not is_set(sums_sum_0(101), 0));
      else
        winnerswinner1_of_pair_0_100_choice := not is_set(sums_sum_0(101), 1);
      end if;
      if is_set(sums_sum_0(100), 1) then
        winnerswinner1_of_pair_0_100_choices(2) := winnerswinner1_of_pair_0_100_choice;
      else
        winnerswinner1_of_pair_0_100_choices(2) := is_set(sums_sum_0(100), 0) and ((sums_sum_0(101) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_100_value := is_set(sums_sum_0(101), 2);
      if winnerswinner1_of_pair_0_100_choices(2) then
        winnerswinner1_of_pair_0_100_choices(3) := (not is_set(sums_sum_0(100), 2)) and
          winnerswinner1_of_pair_0_100_value;
      else
        winnerswinner1_of_pair_0_100_choices(3) := (not is_set(sums_sum_0(100), 2)) or
          winnerswinner1_of_pair_0_100_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_100_values(i) := is_set(sums_sum_0(101), i + 1);
        if winnerswinner1_of_pair_0_100_choices(i + 1) then
          winnerswinner1_of_pair_0_100_choices(i + 2) := (not is_set(sums_sum_0(100), i + 1)) or
            winnerswinner1_of_pair_0_100_values(i);
        else
          winnerswinner1_of_pair_0_100_choices(i + 2) := (not is_set(sums_sum_0(100), i + 1)) and
            winnerswinner1_of_pair_0_100_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_100_choices(6) then
        winnerswinner1_of_pair_0_100_choices(7) := is_set(sums_sum_0(100), 6) and (not is_set(sums_sum_0(101), 6));
      else
        winnerswinner1_of_pair_0_100_choices(7) := is_set(sums_sum_0(100), 6) or (not is_set(sums_sum_0(101), 6));
      end if;
      if is_set(sums_sum_0(102), 0) then
        winnerswinner1_of_pair_0_102_choice := (not is_set(sums_sum_0(103), 1)) or (not is_set(sums_sum_0(103), 0));
      else
        winnerswinner1_of_pair_0_102_choice := not is_set(sums_sum_0(103), 1);
      end if;
      if is_set(sums_sum_0(102), 1) then
        winnerswinner1_of_pair_0_102_choices(2) := winnerswinner1_of_pair_0_102_choice;
      else
        winnerswinner1_of_pair_0_102_choices(2) := is_set(sums_sum_0(102), 0) and ((sums_sum_0(103) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_102_value := is_set(sums_sum_0(103), 2);
      if winnerswinner1_of_pair_0_102_choices(2) then
        winnerswinner1_of_pair_0_102_choices(3) := (not is_set(sums_sum_0(102), 2)) and
          winnerswinner1_of_pair_0_102_value;
      else
        winnerswinner1_of_pair_0_102_choices(3) := (not is_set(sums_sum_0(102), 2)) or
          winnerswinner1_of_pair_0_102_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_102_values(i) := is_set(sums_sum_0(103), i + 1);
        if winnerswinner1_of_pair_0_102_choices(i + 1) then
          winnerswinner1_of_pair_0_102_choices(i + 2) := (not is_set(sums_sum_0(102), i + 1)) or
            winnerswinner1_of_pair_0_102_values(i);
        else
          winnerswinner1_of_pair_0_102_choices(i + 2) := (not is_set(sums_sum_0(102), i + 1)) and
            winnerswinner1_of_pair_0_102_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_102_choices(6) then
        winnerswinner1_of_pair_0_102_choices(7) := is_set(sums_sum_0(102), 6) and (not is_set(sums_sum_0(103), 6));
      else
        winnerswinner1_of_pair_0_102_choices(7) := is_set(sums_sum_0(102), 6) or (not is_set(sums_sum_0(103), 6));
      end if;
      if is_set(sums_sum_0(104), 0) then
        winnerswinner1_of_pair_0_104_choice := (not is_set(sums_sum_0(105), 1)) or (not is_set(sums_sum_0(105), 0));
      else
        winnerswinner1_of_pair_0_104_choice := not is_set(sums_sum_0(105), 1);
      end if;
      if is_set(sums_sum_0(104), 1) then
        winnerswinner1_of_pair_0_104_choices(2) := winnerswinner1_of_pair_0_104_choice;
      else
        winnerswinner1_of_pair_0_104_choices(2) := is_set(sums_sum_0(104), 0) and ((sums_sum_0(105) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_104_value := is_set(sums_sum_0(105), 2);
      if winnerswinner1_of_pair_0_104_choices(2) then
        winnerswinner1_of_pair_0_104_choices(3) := (not is_set(sums_sum_0(104), 2)) and
          winnerswinner1_of_pair_0_104_value;
      else
        winnerswinner1_of_pair_0_104_choices(3) := (not is_set(sums_sum_0(104), 2)) or
          winnerswinner1_of_pair_0_104_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_104_values(i) := is_set(sums_sum_0(105), i + 1);
        if winnerswinner1_of_pair_0_104_choices(i + 1) then
          winnerswinner1_of_pair_0_104_choices(i + 2) := (not is_set(sums_sum_0(104), i + 1)) or
            winnerswinner1_of_pair_0_104_values(i);
        else
          winnerswinner1_of_pair_0_104_choices(i + 2) := (not is_set(sums_sum_0(104), i + 1)) and
            winnerswinner1_of_pair_0_104_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_104_choices(6) then
        winnerswinner1_of_pair_0_104_choices(7) := is_set(sums_sum_0(104), 6) and (not is_set(sums_sum_0(105), 6));
      else
        winnerswinner1_of_pair_0_104_choices(7) := is_set(sums_sum_0(104), 6) or (not is_set(sums_sum_0(105), 6));
      end if;
      if is_set(sums_sum_0(106), 0) then
        winnerswinner1_of_pair_0_106_choice := (not is_set(sums_sum_0(107), 1)) or (not is_set(sums_sum_0(107), 0));
      else
        winnerswinner1_of_pair_0_106_choice := not is_set(sums_sum_0(107), 1);
      end if;
      if is_set(sums_sum_0(106), 1) then
        winnerswinner1_of_pair_0_106_choices(2) := winnerswinner1_of_pair_0_106_choice;
      else
        winnerswinner1_of_pair_0_106_choices(2) := is_set(sums_sum_0(106), 0) and ((sums_sum_0(107) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_106_value := is_set(sums_sum_0(107), 2);
      if winnerswinner1_of_pair_0_106_choices(2) then
        winnerswinner1_of_pair_0_106_choices(3) := (not is_set(sums_sum_0(106), 2)) and
          winnerswinner1_of_pair_0_106_value;
      else
        winnerswinner1_of_pair_0_106_choices(3) := (not is_set(sums_sum_0(106), 2)) or
          winnerswinner1_of_pair_0_106_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_106_values(i) := is_set(sums_sum_0(107), i + 1);
        if winnerswinner1_of_pair_0_106_choices(i + 1) then
          winnerswinner1_of_pair_0_106_choices(i + 2) := (not is_set(sums_sum_0(106), i + 1)) or
            winnerswinner1_of_pair_0_106_values(i);
        else
          winnerswinner1_of_pair_0_106_choices(i + 2) := (not is_set(sums_sum_0(106), i + 1)) and
            winnerswinner1_of_pair_0_106_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_106_choices(6) then
        winnerswinner1_of_pair_0_106_choices(7) := is_set(sums_sum_0(106), 6) and (not is_set(sums_sum_0(107), 6));
      else
        winnerswinner1_of_pair_0_106_choices(7) := is_set(sums_sum_0(106), 6) or (not is_set(sums_sum_0(107), 6));
      end if;
      if is_set(sums_sum_0(108), 0) then
        winnerswinner1_of_pair_0_108_choice := (not is_set(sums_sum_0(109), 1)) or (not is_set(sums_sum_0(109), 0));
      else
        winnerswinner1_of_pair_0_108_choice := not is_set(sums_sum_0(109), 1);
      end if;
      if is_set(sums_sum_0(108), 1) then
        winnerswinner1_of_pair_0_108_choices(2) := winnerswinner1_of_pair_0_108_choice;
      else
        winnerswinner1_of_pair_0_108_choices(2) := is_set(sums_sum_0(108), 0) and ((sums_sum_0(109) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_108_value := is_set(sums_sum_0(109), 2);
      if winnerswinner1_of_pair_0_108_choices(2) then
        winnerswinner1_of_pair_0_108_choices(3) := (not is_set(sums_sum_0(108), 2)) and
          winnerswinner1_of_pair_0_108_value;
      else
        winnerswinner1_of_pair_0_108_choices(3) := (not is_set(sums_sum_0(108), 2)) or
          winnerswinner1_of_pair_0_108_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_108_values(i) := is_set(sums_sum_0(109), i + 1);
        if winnerswinner1_of_pair_0_108_choices(i + 1) then
          winnerswinner1_of_pair_0_108_choices(i + 2) := (not is_set(sums_sum_0(108), i + 1)) or
            winnerswinner1_of_pair_0_108_values(i);
        else
          winnerswinner1_of_pair_0_108_choices(i + 2) := (not is_set(sums_sum_0(108), i + 1)) and
            winnerswinner1_of_pair_0_108_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_108_choices(6) then
        winnerswinner1_of_pair_0_108_choices(7) := is_set(sums_sum_0(108), 6) and (not is_set(sums_sum_0(109), 6));
      else
        winnerswinner1_of_pair_0_108_choices(7) := is_set(sums_sum_0(108), 6) or (not is_set(sums_sum_0(109), 6));
      end if;
      if is_set(sums_sum_0(110), 0) then
        winnerswinner1_of_pair_0_110_choice := (not is_set(sums_sum_0(111), 1)) or (not is_set(sums_sum_0(111), 0));
      else
        winnerswinner1_of_pair_0_110_choice := not is_set(sums_sum_0(111), 1);
      end if;
      if is_set(sums_sum_0(110), 1) then
        winnerswinner1_of_pair_0_110_choices(2) := winnerswinner1_of_pair_0_110_choice;
      else
        winnerswinner1_of_pair_0_110_choices(2) := is_set(sums_sum_0(110), 0) and ((sums_sum_0(111) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_110_value := is_set(sums_sum_0(111), 2);
      if winnerswinner1_of_pair_0_110_choices(2) then
        winnerswinner1_of_pair_0_110_choices(3) := (not is_set(sums_sum_0(110), 2)) and
          winnerswinner1_of_pair_0_110_value;
      else
        winnerswinner1_of_pair_0_110_choices(3) := (not is_set(sums_sum_0(110), 2)) or
          winnerswinner1_of_pair_0_110_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_110_values(i) := is_set(sums_sum_0(111), i + 1);
        if winnerswinner1_of_pair_0_110_choices(i + 1) then
          winnerswinner1_of_pair_0_110_choices(i + 2) := (not is_set(sums_sum_0(110), i + 1)) or
            winnerswinner1_of_pair_0_110_values(i);
        else
          winnerswinner1_of_pair_0_110_choices(i + 2) := (not is_set(sums_sum_0(110), i + 1)) and
            winnerswinner1_of_pair_0_110_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_110_choices(6) then
        winnerswinner1_of_pair_0_110_choices(7) := is_set(sums_sum_0(110), 6) and (not is_set(sums_sum_0(111), 6));
      else
        winnerswinner1_of_pair_0_110_choices(7) := is_set(sums_sum_0(110), 6) or (not is_set(sums_sum_0(111), 6));
      end if;
      if is_set(sums_sum_0(112), 0) then
        winnerswinner1_of_pair_0_112_choice := (not is_set(sums_sum_0(113), 1)) or (not is_set(sums_sum_0(113), 0));
      else
        winnerswinner1_of_pair_0_112_choice := not is_set(sums_sum_0(113), 1);
      end if;
      if is_set(sums_sum_0(112), 1) then
        winnerswinner1_of_pair_0_112_choices(2) := winnerswinner1_of_pair_0_112_choice;
      else
        winnerswinner1_of_pair_0_112_choices(2) := is_set(sums_sum_0(112), 0) and ((sums_sum_0(113) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_112_value := is_set(sums_sum_0(113), 2);
      if winnerswinner1_of_pair_0_112_choices(2) then
        winnerswinner1_of_pair_0_112_choices(3) := (not is_set(sums_sum_0(112), 2)) and
          winnerswinner1_of_pair_0_112_value;
      else
        winnerswinner1_of_pair_0_112_choices(3) := (not is_set(sums_sum_0(112), 2)) or
          winnerswinner1_of_pair_0_112_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_112_values(i) := is_set(sums_sum_0(113), i + 1);
        if winnerswinner1_of_pair_0_112_choices(i + 1) then
          winnerswinner1_of_pair_0_112_choices(i + 2) := (not is_set(sums_sum_0(112), i + 1)) or
            winnerswinner1_of_pair_0_112_values(i);
        else
          winnerswinner1_of_pair_0_112_choices(i + 2) := (not is_set(sums_sum_0(112), i + 1)) and
            winnerswinner1_of_pair_0_112_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_112_choices(6) then
        winnerswinner1_of_pair_0_112_choices(7) := is_set(sums_sum_0(112), 6) and (not is_set(sums_sum_0(113), 6));
      else
        winnerswinner1_of_pair_0_112_choices(7) := is_set(sums_sum_0(112), 6) or (not is_set(sums_sum_0(113), 6));
      end if;
      if is_set(sums_sum_0(114), 0) then
        winnerswinner1_of_pair_0_114_choice := (not is_set(sums_sum_0(115), 1)) or (not is_set(sums_sum_0(115), 0));
      else
        winnerswinner1_of_pair_0_114_choice := not is_set(sums_sum_0(115), 1);
      end if;
      if is_set(sums_sum_0(114), 1) then
        winnerswinner1_of_pair_0_114_choices(2) := winnerswinner1_of_pair_0_114_choice;
      else
        winnerswinner1_of_pair_0_114_choices(2) := is_set(sums_sum_0(114), 0) and ((sums_sum_0(115) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_114_value := is_set(sums_sum_0(115), 2);
      if winnerswinner1_of_pair_0_114_choices(2) then
        winnerswinner1_of_pair_0_114_choices(3) := (not is_set(sums_sum_0(114), 2)) and
          winnerswinner1_of_pair_0_114_value;
      else
        winnerswinner1_of_pair_0_114_choices(3) := (not is_set(sums_sum_0(114), 2)) or
          winnerswinner1_of_pair_0_114_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_114_values(i) := is_set(sums_sum_0(115), i + 1);
        if winnerswinner1_of_pair_0_114_choices(i + 1) then
          winnerswinner1_of_pair_0_114_choices(i + 2) := (not is_set(sums_sum_0(114), i + 1)) or
            winnerswinner1_of_pair_0_114_values(i);
        else
          winnerswinner1_of_pair_0_114_choices(i + 2) := (not is_set(sums_sum_0(114), i + 1)) and
            winnerswinner1_of_pair_0_114_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_114_choices(6) then
        winnerswinner1_of_pair_0_114_choices(7) := is_set(sums_sum_0(114), 6) and (not is_set(sums_sum_0(115), 6));
      else
        winnerswinner1_of_pair_0_114_choices(7) := is_set(sums_sum_0(114), 6) or (not is_set(sums_sum_0(115), 6));
      end if;
      if is_set(sums_sum_0(116), 0) then
        winnerswinner1_of_pair_0_116_choice := (not is_set(sums_sum_0(117), 1)) or (not is_set(sums_sum_0(117), 0));
      else
        winnerswinner1_of_pair_0_116_choice := not is_set(sums_sum_0(117), 1);
      end if;
      if is_set(sums_sum_0(116), 1) then
        winnerswinner1_of_pair_0_116_choices(2) := winnerswinner1_of_pair_0_116_choice;
      else
        winnerswinner1_of_pair_0_116_choices(2) := is_set(sums_sum_0(116), 0) and ((sums_sum_0(117) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_116_value := is_set(sums_sum_0(117), 2);
      if winnerswinner1_of_pair_0_116_choices(2) then
        winnerswinner1_of_pair_0_116_choices(3) := (not is_set(sums_sum_0(116), 2)) and
          winnerswinner1_of_pair_0_116_value;
      else
        winnerswinner1_of_pair_0_116_choices(3) := (not is_set(sums_sum_0(116), 2)) or
          winnerswinner1_of_pair_0_116_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_116_values(i) := is_set(sums_sum_0(117), i + 1);
        if winnerswinner1_of_pair_0_116_choices(i + 1) then
          winnerswinner1_of_pair_0_116_choices(i + 2) := (not is_set(sums_sum_0(116), i + 1)) or
            winnerswinner1_of_pair_0_116_values(i);
        else
          winnerswinner1_of_pair_0_116_choices(i + 2) := (not is_set(sums_sum_0(116), i + 1)) and
            winnerswinner1_of_pair_0_116_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_116_choices(6) then
        winnerswinner1_of_pair_0_116_choices(7) := is_set(sums_sum_0(116), 6) and (not is_set(sums_sum_0(117), 6));
      else
        winnerswinner1_of_pair_0_116_choices(7) := is_set(sums_sum_0(116), 6) or (not is_set(sums_sum_0(117), 6));
      end if;
      if is_set(sums_sum_0(118), 0) then
        winnerswinner1_of_pair_0_118_choice := (not is_set(sums_sum_0(119), 1)) or (not is_set(sums_sum_0(119), 0));
      else
        winnerswinner1_of_pair_0_118_choice := not is_set(sums_sum_0(119), 1);
      end if;
      if is_set(sums_sum_0(118), 1) then
        winnerswinner1_of_pair_0_118_choices(2) := winnerswinner1_of_pair_0_118_choice;
      else
        winnerswinner1_of_pair_0_118_choices(2) := is_set(sums_sum_0(118), 0) and ((sums_sum_0(119) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_118_value := is_set(sums_sum_0(119), 2);
      if winnerswinner1_of_pair_0_118_choices(2) then
        winnerswinner1_of_pair_0_118_choices(3) := (not is_set(sums_sum_0(118), 2)) and
          winnerswinner1_of_pair_0_118_value;
      else
        winnerswinner1_of_pair_0_118_choices(3) := (not is_set(sums_sum_0(118), 2)) or
          winnerswinner1_of_pair_0_118_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_118_values(i) := is_set(sums_sum_0(119), i + 1);
        if winnerswinner1_of_pair_0_118_choices(i + 1) then
          winnerswinner1_of_pair_0_118_choices(i + 2) := (not is_set(sums_sum_0(118), i + 1)) or
            winnerswinner1_of_pair_0_118_values(i);
        else
          winnerswinner1_of_pair_0_118_choices(i + 2) := (not is_set(sums_sum_0(118), i + 1)) and
            winnerswinner1_of_pair_0_118_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_118_choices(6) then
        winnerswinner1_of_pair_0_118_choices(7) := is_set(sums_sum_0(118), 6) and (not is_set(sums_sum_0(119), 6));
      else
        winnerswinner1_of_pair_0_118_choices(7) := is_set(sums_sum_0(118), 6) or (not is_set(sums_sum_0(119), 6));
      end if;
      if is_set(sums_sum_0(120), 0) then
        winnerswinner1_of_pair_0_120_choice := (not is_set(sums_sum_0(121), 1)) or (not is_set(sums_sum_0(121), 0));
      else
        winnerswinner1_of_pair_0_120_choice := not is_set(sums_sum_0(121), 1);
      end if;
      if is_set(sums_sum_0(120), 1) then
        winnerswinner1_of_pair_0_120_choices(2) := winnerswinner1_of_pair_0_120_choice;
      else
        winnerswinner1_of_pair_0_120_choices(2) := is_set(sums_sum_0(120), 0) and ((sums_sum_0(121) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_120_value := is_set(sums_sum_0(121), 2);
      if winnerswinner1_of_pair_0_120_choices(2) then
        winnerswinner1_of_pair_0_120_choices(3) := (not is_set(sums_sum_0(120), 2)) and
          winnerswinner1_of_pair_0_120_value;
      else
        winnerswinner1_of_pair_0_120_choices(3) := (not is_set(sums_sum_0(120), 2)) or
          winnerswinner1_of_pair_0_120_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_120_values(i) := is_set(sums_sum_0(121), i + 1);
        if winnerswinner1_of_pair_0_120_choices(i + 1) then
          winnerswinner1_of_pair_0_120_choices(i + 2) := (not is_set(sums_sum_0(120), i + 1)) or
            winnerswinner1_of_pair_0_120_values(i);
        else
          winnerswinner1_of_pair_0_120_choices(i + 2) := (not is_set(sums_sum_0(120), i + 1)) and
            winnerswinner1_of_pair_0_120_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_120_choices(6) then
        winnerswinner1_of_pair_0_120_choices(7) := is_set(sums_sum_0(120), 6) and (not is_set(sums_sum_0(121), 6));
      else
        winnerswinner1_of_pair_0_120_choices(7) := is_set(sums_sum_0(120), 6) or (not is_set(sums_sum_0(121), 6));
      end if;
      if is_set(sums_sum_0(122), 0) then
        winnerswinner1_of_pair_0_122_choice := (not is_set(sums_sum_0(123), 1)) or (not is_set(sums_sum_0(123), 0));
      else
        winnerswinner1_of_pair_0_122_choice := not is_set(sums_sum_0(123), 1);
      end if;
      if is_set(sums_sum_0(122), 1) then
        winnerswinner1_of_pair_0_122_choices(2) := winnerswinner1_of_pair_0_122_choice;
      else
        winnerswinner1_of_pair_0_122_choices(2) := is_set(sums_sum_0(122), 0) and ((sums_sum_0(123) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_122_value := is_set(sums_sum_0(123), 2);
      if winnerswinner1_of_pair_0_122_choices(2) then
        winnerswinner1_of_pair_0_122_choices(3) := (not is_set(sums_sum_0(122), 2)) and
          winnerswinner1_of_pair_0_122_value;
      else
        winnerswinner1_of_pair_0_122_choices(3) := (not is_set(sums_sum_0(122), 2)) or
          winnerswinner1_of_pair_0_122_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_122_values(i) := is_set(sums_sum_0(123), i + 1);
        if winnerswinner1_of_pair_0_122_choices(i + 1) then
          winnerswinner1_of_pair_0_122_choices(i + 2) := (not is_set(sums_sum_0(122), i + 1)) or
            winnerswinner1_of_pair_0_122_values(i);
        else
          winnerswinner1_of_pair_0_122_choices(i + 2) := (not is_set(sums_sum_0(122), i + 1)) and
            winnerswinner1_of_pair_0_122_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_122_choices(6) then
        winnerswinner1_of_pair_0_122_choices(7) := is_set(sums_sum_0(122), 6) and (not is_set(sums_sum_0(123), 6));
      else
        winnerswinner1_of_pair_0_122_choices(7) := is_set(sums_sum_0(122), 6) or (not is_set(sums_sum_0(123), 6));
      end if;
      if is_set(sums_sum_0(124), 0) then
        winnerswinner1_of_pair_0_124_choice := (not is_set(sums_sum_0(125), 1)) or (not is_set(sums_sum_0(125), 0));
      else
        winnerswinner1_of_pair_0_124_choice := not is_set(sums_sum_0(125), 1);
      end if;
      if is_set(sums_sum_0(124), 1) then
        winnerswinner1_of_pair_0_124_choices(2) := winnerswinner1_of_pair_0_124_choice;
      else
        winnerswinner1_of_pair_0_124_choices(2) := is_set(sums_sum_0(124), 0) and ((sums_sum_0(125) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_124_value := is_set(sums_sum_0(125), 2);
      if winnerswinner1_of_pair_0_124_choices(2) then
        winnerswinner1_of_pair_0_124_choices(3) := (not is_set(sums_sum_0(124), 2)) and
          winnerswinner1_of_pair_0_124_value;
      else
        winnerswinner1_of_pair_0_124_choices(3) := (not is_set(sums_sum_0(124), 2)) or
          winnerswinner1_of_pair_0_124_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_124_values(i) := is_set(sums_sum_0(125), i + 1);
        if winnerswinner1_of_pair_0_124_choices(i + 1) then
          winnerswinner1_of_pair_0_124_choices(i + 2) := (not is_set(sums_sum_0(124), i + 1)) or
            winnerswinner1_of_pair_0_124_values(i);
        else
          winnerswinner1_of_pair_0_124_choices(i + 2) := (not is_set(sums_sum_0(124), i + 1)) and
            winnerswinner1_of_pair_0_124_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_124_choices(6) then
        winnerswinner1_of_pair_0_124_choices(7) := is_set(sums_sum_0(124), 6) and (not is_set(sums_sum_0(125), 6));
      else
        winnerswinner1_of_pair_0_124_choices(7) := is_set(sums_sum_0(124), 6) or (not is_set(sums_sum_0(125), 6));
      end if;
      if is_set(sums_sum_0(126), 0) then
        winnerswinner1_of_pair_0_126_choice := (not is_set(sums_sum_0(127), 1)) or (not is_set(sums_sum_0(127), 0));
      else
        winnerswinner1_of_pair_0_126_choice := not is_set(sums_sum_0(127), 1);
      end if;
      if is_set(sums_sum_0(126), 1) then
        winnerswinner1_of_pair_0_126_choices(2) := winnerswinner1_of_pair_0_126_choice;
      else
        winnerswinner1_of_pair_0_126_choices(2) := is_set(sums_sum_0(126), 0) and ((sums_sum_0(127) mod 4) = 0);
      end if;
      winnerswinner1_of_pair_0_126_value := is_set(sums_sum_0(127), 2);
      if winnerswinner1_of_pair_0_126_choices(2) then
        winnerswinner1_of_pair_0_126_choices(3) := (not is_set(sums_sum_0(126), 2)) and
          winnerswinner1_of_pair_0_126_value;
      else
        winnerswinner1_of_pair_0_126_choices(3) := (not is_set(sums_sum_0(126), 2)) or
          winnerswinner1_of_pair_0_126_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_of_pair_0_126_values(i) := is_set(sums_sum_0(127), i + 1);
        if winnerswinner1_of_pair_0_126_choices(i + 1) then
          winnerswinner1_of_pair_0_126_choices(i + 2) := (not is_set(sums_sum_0(126), i + 1)) or
            winnerswinner1_of_pair_0_126_values(i);
        else
          winnerswinner1_of_pair_0_126_choices(i + 2) := (not is_set(sums_sum_0(126), i + 1)) and
            winnerswinner1_of_pair_0_126_values(i);
        end if;
      end loop;
      if winnerswinner1_of_pair_0_126_choices(6) then
        winnerswinner1_of_pair_0_126_choices(7) := is_set(sums_sum_0(126), 6) and (not is_set(sums_sum_0(127), 6));
      else
        winnerswinner1_of_pair_0_126_choices(7) := is_set(sums_sum_0(126), 6) or (not is_set(sums_sum_0(127), 6));
      end if;
      if is_set(winnerswinner1_of_pair_0(1), 0) then
        winnerswinner1_of_four_0_0_choice := (not is_set(winnerswinner1_of_pair_0(3), 0)) and (not
          is_set(winnerswinner1_of_pair_0(2), 0));
      else
        winnerswinner1_of_four_0_0_choice := is_set(winnerswinner1_of_pair_0(0), 0) and (not
          is_set(winnerswinner1_of_pair_0(3), 0)) and (not is_set(winnerswinner1_of_pair_0(2), 0));
      end if;
      winnerswinner1_of_four_0_0_value := is_set(winnerswinner1_of_pair_0(1), 1);
      winnerswinner1_of_four_0_0_values(2) := is_set(winnerswinner1_of_pair_0(0), 1);
      if (not is_set(winnerswinner1_of_pair_0(3), 1)) and (not is_set(winnerswinner1_of_pair_0(2), 1)) then
        winnerswinner1_of_four_0_0_choices(2) := winnerswinner1_of_four_0_0_choice or winnerswinner1_of_four_0_0_value
          or winnerswinner1_of_four_0_0_values(2);
      else
        winnerswinner1_of_four_0_0_choices(2) := winnerswinner1_of_four_0_0_choice and
          (winnerswinner1_of_four_0_0_value or winnerswinner1_of_four_0_0_values(2));
      end if;
      winnerswinner1_of_four_0_0_values(3) := is_set(winnerswinner1_of_pair_0(3), 2);
      winnerswinner1_of_four_0_0_values(4) := is_set(winnerswinner1_of_pair_0(2), 2);
      if winnerswinner1_of_four_0_0_choices(2) then
        winnerswinner1_of_four_0_0_choices(3) := (not is_set(winnerswinner1_of_pair_0(1), 2)) and (not
          is_set(winnerswinner1_of_pair_0(0), 2)) and (winnerswinner1_of_four_0_0_values(3) or
          winnerswinner1_of_four_0_0_values(4));
      else
        winnerswinner1_of_four_0_0_choices(3) := ((not is_set(winnerswinner1_of_pair_0(1), 2)) and (not
          is_set(winnerswinner1_of_pair_0(0), 2))) or winnerswinner1_of_four_0_0_values(3) or
          winnerswinner1_of_four_0_0_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_0_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(3), i);
        winnerswinner1_of_four_0_0_values(2 * i) := is_set(winnerswinner1_of_pair_0(2), i);
        if winnerswinner1_of_four_0_0_choices(i) then
          winnerswinner1_of_four_0_0_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(1), i)) and (not
            is_set(winnerswinner1_of_pair_0(0), i))) or winnerswinner1_of_four_0_0_values(2 * i - 1) or
            winnerswinner1_of_four_0_0_values(2 * i);
        else
          winnerswinner1_of_four_0_0_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(1), i)) and (not
            is_set(winnerswinner1_of_pair_0(0), i)) and (winnerswinner1_of_four_0_0_values(2 * i - 1) or
            winnerswinner1_of_four_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_0_choices(6) then
        winnerswinner1_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(1), 6)) and (not
          is_set(winnerswinner1_of_pair_0(0), 6)))) and (not is_set(winnerswinner1_of_pair_0(3), 6)) and (not
          is_set(winnerswinner1_of_pair_0(2), 6));
      else
        winnerswinner1_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(1), 6)) and (not
          is_set(winnerswinner1_of_pair_0(0), 6)))) or ((not is_set(winnerswinner1_of_pair_0(3), 6)) and (not
          is_set(winnerswinner1_of_pair_0(2), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(5), 0) then
        winnerswinner1_of_four_0_4_choice := (not is_set(winnerswinner1_of_pair_0(7), 0)) and (not
          is_set(winnerswinner1_of_pair_0(6), 0));
      else
        winnerswinner1_of_four_0_4_choice := is_set(winnerswinner1_of_pair_0(4), 0) and (not
          is_set(winnerswinner1_of_pair_0(7), 0)) and (not is_set(winnerswinner1_of_pair_0(6), 0));
      end if;
      winnerswinner1_of_four_0_4_value := is_set(winnerswinner1_of_pair_0(5), 1);
      winnerswinner1_of_four_0_4_values(2) := is_set(winnerswinner1_of_pair_0(4), 1);
      if (not is_set(winnerswinner1_of_pair_0(7), 1)) and (not is_set(winnerswinner1_of_pair_0(6), 1)) then
        winnerswinner1_of_four_0_4_choices(2) := winnerswinner1_of_four_0_4_choice or winnerswinner1_of_four_0_4_value
          or winnerswinner1_of_four_0_4_values(2);
      else
        winnerswinner1_of_four_0_4_choices(2) := winnerswinner1_of_four_0_4_choice and
          (winnerswinner1_of_four_0_4_value or winnerswinner1_of_four_0_4_values(2));
      end if;
      winnerswinner1_of_four_0_4_values(3) := is_set(winnerswinner1_of_pair_0(7), 2);
      winnerswinner1_of_four_0_4_values(4) := is_set(winnerswinner1_of_pair_0(6), 2);
      if winnerswinner1_of_four_0_4_choices(2) then
        winnerswinner1_of_four_0_4_choices(3) := (not is_set(winnerswinner1_of_pair_0(5), 2)) and (not
          is_set(winnerswinner1_of_pair_0(4), 2)) and (winnerswinner1_of_four_0_4_values(3) or
          winnerswinner1_of_four_0_4_values(4));
      else
        winnerswinner1_of_four_0_4_choices(3) := ((not is_set(winnerswinner1_of_pair_0(5), 2)) and (not
          is_set(winnerswinner1_of_pair_0(4), 2))) or winnerswinner1_of_four_0_4_values(3) or
          winnerswinner1_of_four_0_4_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_4_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(7), i);
        winnerswinner1_of_four_0_4_values(2 * i) := is_set(winnerswinner1_of_pair_0(6), i);
        if winnerswinner1_of_four_0_4_choices(i) then
          winnerswinner1_of_four_0_4_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(5), i)) and (not
            is_set(winnerswinner1_of_pair_0(4), i))) or winnerswinner1_of_four_0_4_values(2 * i - 1) or
            winnerswinner1_of_four_0_4_values(2 * i);
        else
          winnerswinner1_of_four_0_4_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(5), i)) and (not
            is_set(winnerswinner1_of_pair_0(4), i)) and (winnerswinner1_of_four_0_4_values(2 * i - 1) or
            winnerswinner1_of_four_0_4_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_4_choices(6) then
        winnerswinner1_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(5), 6)) and (not
          is_set(winnerswinner1_of_pair_0(4), 6)))) and (not is_set(winnerswinner1_of_pair_0(7), 6)) and (not
          is_set(winnerswinner1_of_pair_0(6), 6));
      else
        winnerswinner1_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(5), 6)) and (not
          is_set(winnerswinner1_of_pair_0(4), 6)))) or ((not is_set(winnerswinner1_of_pair_0(7), 6)) and (not
          is_set(winnerswinner1_of_pair_0(6), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(9), 0) then
        winnerswinner1_of_four_0_8_choice := (not is_set(winnerswinner1_of_pair_0(11), 0)) and (not
          is_set(winnerswinner1_of_pair_0(10), 0));
      else
        winnerswinner1_of_four_0_8_choice := is_set(winnerswinner1_of_pair_0(8), 0) and (not
          is_set(winnerswinner1_of_pair_0(11), 0)) and (not is_set(winnerswinner1_of_pair_0(10), 0));
      end if;
      winnerswinner1_of_four_0_8_value := is_set(winnerswinner1_of_pair_0(9), 1);
      winnerswinner1_of_four_0_8_values(2) := is_set(winnerswinner1_of_pair_0(8), 1);
      if (not is_set(winnerswinner1_of_pair_0(11), 1)) and (not is_set(winnerswinner1_of_pair_0(10), 1)) then
        winnerswinner1_of_four_0_8_choices(2) := winnerswinner1_of_four_0_8_choice or winnerswinner1_of_four_0_8_value
          or winnerswinner1_of_four_0_8_values(2);
      else
        winnerswinner1_of_four_0_8_choices(2) := winnerswinner1_of_four_0_8_choice and
          (winnerswinner1_of_four_0_8_value or winnerswinner1_of_four_0_8_values(2));
      end if;
      winnerswinner1_of_four_0_8_values(3) := is_set(winnerswinner1_of_pair_0(11), 2);
      winnerswinner1_of_four_0_8_values(4) := is_set(winnerswinner1_of_pair_0(10), 2);
      if winnerswinner1_of_four_0_8_choices(2) then
        winnerswinner1_of_four_0_8_choices(3) := (not is_set(winnerswinner1_of_pair_0(9), 2)) and (not
          is_set(winnerswinner1_of_pair_0(8), 2)) and (winnerswinner1_of_four_0_8_values(3) or
          winnerswinner1_of_four_0_8_values(4));
      else
        winnerswinner1_of_four_0_8_choices(3) := ((not is_set(winnerswinner1_of_pair_0(9), 2)) and (not
          is_set(winnerswinner1_of_pair_0(8), 2))) or winnerswinner1_of_four_0_8_values(3) or
          winnerswinner1_of_four_0_8_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_8_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(11), i);
        winnerswinner1_of_four_0_8_values(2 * i) := is_set(winnerswinner1_of_pair_0(10), i);
        if winnerswinner1_of_four_0_8_choices(i) then
          winnerswinner1_of_four_0_8_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(9), i)) and (not
            is_set(winnerswinner1_of_pair_0(8), i))) or winnerswinner1_of_four_0_8_values(2 * i - 1) or
            winnerswinner1_of_four_0_8_values(2 * i);
        else
          winnerswinner1_of_four_0_8_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(9), i)) and (not
            is_set(winnerswinner1_of_pair_0(8), i)) and (winnerswinner1_of_four_0_8_values(2 * i - 1) or
            winnerswinner1_of_four_0_8_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_8_choices(6) then
        winnerswinner1_of_four_0_8_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(9), 6)) and (not
          is_set(winnerswinner1_of_pair_0(8), 6)))) and (not is_set(winnerswinner1_of_pair_0(11), 6)) and (not
          is_set(winnerswinner1_of_pair_0(10), 6));
      else
        winnerswinner1_of_four_0_8_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(9), 6)) and (not
          is_set(winnerswinner1_of_pair_0(8), 6)))) or ((not is_set(winnerswinner1_of_pair_0(11), 6)) and (not
          is_set(winnerswinner1_of_pair_0(10), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(13), 0) then
        winnerswinner1_of_four_0_12_choice := (not is_set(winnerswinner1_of_pair_0(15), 0)) and (not
          is_set(winnerswinner1_of_pair_0(14), 0));
      else
        winnerswinner1_of_four_0_12_choice := is_set(winnerswinner1_of_pair_0(12), 0) and (not
          is_set(winnerswinner1_of_pair_0(15), 0)) and (not is_set(winnerswinner1_of_pair_0(14), 0));
      end if;
      winnerswinner1_of_four_0_12_value := is_set(winnerswinner1_of_pair_0(13), 1);
      winnerswinner1_of_four_0_12_values(2) := is_set(winnerswinner1_of_pair_0(12), 1);
      if (not is_set(winnerswinner1_of_pair_0(15), 1)) and (not is_set(winnerswinner1_of_pair_0(14), 1)) then
        winnerswinner1_of_four_0_12_choices(2) := winnerswinner1_of_four_0_12_choice or
          winnerswinner1_of_four_0_12_value or winnerswinner1_of_four_0_12_values(2);
      else
        winnerswinner1_of_four_0_12_choices(2) := winnerswinner1_of_four_0_12_choice and
          (winnerswinner1_of_four_0_12_value or winnerswinner1_of_four_0_12_values(2));
      end if;
      winnerswinner1_of_four_0_12_values(3) := is_set(winnerswinner1_of_pair_0(15), 2);
      winnerswinner1_of_four_0_12_values(4) := is_set(winnerswinner1_of_pair_0(14), 2);
      if winnerswinner1_of_four_0_12_choices(2) then
        winnerswinner1_of_four_0_12_choices(3) := (not is_set(winnerswinner1_of_pair_0(13), 2)) and (not
          is_set(winnerswinner1_of_pair_0(12), 2)) and (winnerswinner1_of_four_0_12_values(3) or
          winnerswinner1_of_four_0_12_values(4));
      else
        winnerswinner1_of_four_0_12_choices(3) := ((not is_set(winnerswinner1_of_pair_0(13), 2)) and (not
          is_set(winnerswinner1_of_pair_0(12), 2))) or winnerswinner1_of_four_0_12_values(3) or
          winnerswinner1_of_four_0_12_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_12_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(15), i);
        winnerswinner1_of_four_0_12_values(2 * i) := is_set(winnerswinner1_of_pair_0(14), i);
        if winnerswinner1_of_four_0_12_choices(i) then
          winnerswinner1_of_four_0_12_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(13), i)) and (not
            is_set(winnerswinner1_of_pair_0(12), i))) or winnerswinner1_of_four_0_12_values(2 * i - 1) or
            winnerswinner1_of_four_0_12_values(2 * i);
        else
          winnerswinner1_of_four_0_12_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(13), i)) and (not
            is_set(winnerswinner1_of_pair_0(12), i)) and (winnerswinner1_of_four_0_12_values(2 * i - 1) or
            winnerswinner1_of_four_0_12_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_12_choices(6) then
        winnerswinner1_of_four_0_12_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(13), 6)) and (not
          is_set(winnerswinner1_of_pair_0(12), 6)))) and (not is_set(winnerswinner1_of_pair_0(15), 6)) and (not
          is_set(winnerswinner1_of_pair_0(14), 6));
      else
        winnerswinner1_of_four_0_12_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(13), 6)) and (not
          is_set(winnerswinner1_of_pair_0(12), 6)))) or ((not is_set(winnerswinner1_of_pair_0(15), 6)) and (not
          is_set(winnerswinner1_of_pair_0(14), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(17), 0) then
        winnerswinner1_of_four_0_16_choice := (not is_set(winnerswinner1_of_pair_0(19), 0)) and (not
          is_set(winnerswinner1_of_pair_0(18), 0));
      else
        winnerswinner1_of_four_0_16_choice := is_set(winnerswinner1_of_pair_0(16), 0) and (not
          is_set(winnerswinner1_of_pair_0(19), 0)) and (not is_set(winnerswinner1_of_pair_0(18), 0));
      end if;
      winnerswinner1_of_four_0_16_value := is_set(winnerswinner1_of_pair_0(17), 1);
      winnerswinner1_of_four_0_16_values(2) := is_set(winnerswinner1_of_pair_0(16), 1);
      if (not is_set(winnerswinner1_of_pair_0(19), 1)) and (not is_set(winnerswinner1_of_pair_0(18), 1)) then
        winnerswinner1_of_four_0_16_choices(2) := winnerswinner1_of_four_0_16_choice or
          winnerswinner1_of_four_0_16_value or winnerswinner1_of_four_0_16_values(2);
      else
        winnerswinner1_of_four_0_16_choices(2) := winnerswinner1_of_four_0_16_choice and
          (winnerswinner1_of_four_0_16_value or winnerswinner1_of_four_0_16_values(2));
      end if;
      winnerswinner1_of_four_0_16_values(3) := is_set(winnerswinner1_of_pair_0(19), 2);
      winnerswinner1_of_four_0_16_values(4) := is_set(winnerswinner1_of_pair_0(18), 2);
      if winnerswinner1_of_four_0_16_choices(2) then
        winnerswinner1_of_four_0_16_choices(3) := (not is_set(winnerswinner1_of_pair_0(17), 2)) and (not
          is_set(winnerswinner1_of_pair_0(16), 2)) and (winnerswinner1_of_four_0_16_values(3) or
          winnerswinner1_of_four_0_16_values(4));
      else
        winnerswinner1_of_four_0_16_choices(3) := ((not is_set(winnerswinner1_of_pair_0(17), 2)) and (not
          is_set(winnerswinner1_of_pair_0(16), 2))) or winnerswinner1_of_four_0_16_values(3) or
          winnerswinner1_of_four_0_16_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_16_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(19), i);
        winnerswinner1_of_four_0_16_values(2 * i) := is_set(winnerswinner1_of_pair_0(18), i);
        if winnerswinner1_of_four_0_16_choices(i) then
          winnerswinner1_of_four_0_16_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(17), i)) and (not
            is_set(winnerswinner1_of_pair_0(16), i))) or winnerswinner1_of_four_0_16_values(2 * i - 1) or
            winnerswinner1_of_four_0_16_values(2 * i);
        else
          winnerswinner1_of_four_0_16_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(17), i)) and (not
            is_set(winnerswinner1_of_pair_0(16), i)) and (winnerswinner1_of_four_0_16_values(2 * i - 1) or
            winnerswinner1_of_four_0_16_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_16_choices(6) then
        winnerswinner1_of_four_0_16_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(17), 6)) and (not
          is_set(winnerswinner1_of_pair_0(16), 6)))) and (not is_set(winnerswinner1_of_pair_0(19), 6)) and (not
          is_set(winnerswinner1_of_pair_0(18), 6));
      else
        winnerswinner1_of_four_0_16_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(17), 6)) and (not
          is_set(winnerswinner1_of_pair_0(16), 6)))) or ((not is_set(winnerswinner1_of_pair_0(19), 6)) and (not
          is_set(winnerswinner1_of_pair_0(18), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(21), 0) then
        winnerswinner1_of_four_0_20_choice := (not is_set(winnerswinner1_of_pair_0(23), 0)) and (not
          is_set(winnerswinner1_of_pair_0(22), 0));
      else
        winnerswinner1_of_four_0_20_choice := is_set(winnerswinner1_of_pair_0(20), 0) and (not
          is_set(winnerswinner1_of_pair_0(23), 0)) and (not is_set(winnerswinner1_of_pair_0(22), 0));
      end if;
      winnerswinner1_of_four_0_20_value := is_set(winnerswinner1_of_pair_0(21), 1);
      winnerswinner1_of_four_0_20_values(2) := is_set(winnerswinner1_of_pair_0(20), 1);
      if (not is_set(winnerswinner1_of_pair_0(23), 1)) and (not is_set(winnerswinner1_of_pair_0(22), 1)) then
        winnerswinner1_of_four_0_20_choices(2) := winnerswinner1_of_four_0_20_choice or
          winnerswinner1_of_four_0_20_value or winnerswinner1_of_four_0_20_values(2);
      else
        winnerswinner1_of_four_0_20_choices(2) := winnerswinner1_of_four_0_20_choice and
          (winnerswinner1_of_four_0_20_value or winnerswinner1_of_four_0_20_values(2));
      end if;
      winnerswinner1_of_four_0_20_values(3) := is_set(winnerswinner1_of_pair_0(23), 2);
      winnerswinner1_of_four_0_20_values(4) := is_set(winnerswinner1_of_pair_0(22), 2);
      if winnerswinner1_of_four_0_20_choices(2) then
        winnerswinner1_of_four_0_20_choices(3) := (not is_set(winnerswinner1_of_pair_0(21), 2)) and (not
          is_set(winnerswinner1_of_pair_0(20), 2)) and (winnerswinner1_of_four_0_20_values(3) or
          winnerswinner1_of_four_0_20_values(4));
      else
        winnerswinner1_of_four_0_20_choices(3) := ((not is_set(winnerswinner1_of_pair_0(21), 2)) and (not
          is_set(winnerswinner1_of_pair_0(20), 2))) or winnerswinner1_of_four_0_20_values(3) or
          winnerswinner1_of_four_0_20_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_20_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(23), i);
        winnerswinner1_of_four_0_20_values(2 * i) := is_set(winnerswinner1_of_pair_0(22), i);
        if winnerswinner1_of_four_0_20_choices(i) then
          winnerswinner1_of_four_0_20_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(21), i)) and (not
            is_set(winnerswinner1_of_pair_0(20), i))) or winnerswinner1_of_four_0_20_values(2 * i - 1) or
            winnerswinner1_of_four_0_20_values(2 * i);
        else
          winnerswinner1_of_four_0_20_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(21), i)) and (not
            is_set(winnerswinner1_of_pair_0(20), i)) and (winnerswinner1_of_four_0_20_values(2 * i - 1) or
            winnerswinner1_of_four_0_20_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_20_choices(6) then
        winnerswinner1_of_four_0_20_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(21), 6)) and (not
          is_set(winnerswinner1_of_pair_0(20), 6)))) and (not is_set(winnerswinner1_of_pair_0(23), 6)) and (not
          is_set(winnerswinner1_of_pair_0(22), 6));
      else
        winnerswinner1_of_four_0_20_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(21), 6)) and (not
          is_set(winnerswinner1_of_pair_0(20), 6)))) or ((not is_set(winnerswinner1_of_pair_0(23), 6)) and (not
          is_set(winnerswinner1_of_pair_0(22), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(25), 0) then
        winnerswinner1_of_four_0_24_choice := (not is_set(winnerswinner1_of_pair_0(27), 0)) and (not
          is_set(winnerswinner1_of_pair_0(26), 0));
      else
        winnerswinner1_of_four_0_24_choice := is_set(winnerswinner1_of_pair_0(24), 0) and (not
          is_set(winnerswinner1_of_pair_0(27), 0)) and (not is_set(winnerswinner1_of_pair_0(26), 0));
      end if;
      winnerswinner1_of_four_0_24_value := is_set(winnerswinner1_of_pair_0(25), 1);
      winnerswinner1_of_four_0_24_values(2) := is_set(winnerswinner1_of_pair_0(24), 1);
      if (not is_set(winnerswinner1_of_pair_0(27), 1)) and (not is_set(winnerswinner1_of_pair_0(26), 1)) then
        winnerswinner1_of_four_0_24_choices(2) := winnerswinner1_of_four_0_24_choice or
          winnerswinner1_of_four_0_24_value or winnerswinner1_of_four_0_24_values(2);
      else
        winnerswinner1_of_four_0_24_choices(2) := winnerswinner1_of_four_0_24_choice and
          (winnerswinner1_of_four_0_24_value or winnerswinner1_of_four_0_24_values(2));
      end if;
      winnerswinner1_of_four_0_24_values(3) := is_set(winnerswinner1_of_pair_0(27), 2);
      winnerswinner1_of_four_0_24_values(4) := is_set(winnerswinner1_of_pair_0(26), 2);
      if winnerswinner1_of_four_0_24_choices(2) then
        winnerswinner1_of_four_0_24_choices(3) := (not is_set(winnerswinner1_of_pair_0(25), 2)) and (not
          is_set(winnerswinner1_of_pair_0(24), 2)) and (winnerswinner1_of_four_0_24_values(3) or
          winnerswinner1_of_four_0_24_values(4));
      else
        winnerswinner1_of_four_0_24_choices(3) := ((not is_set(winnerswinner1_of_pair_0(25), 2)) and (not
          is_set(winnerswinner1_of_pair_0(24), 2))) or winnerswinner1_of_four_0_24_values(3) or
          winnerswinner1_of_four_0_24_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_24_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(27), i);
        winnerswinner1_of_four_0_24_values(2 * i) := is_set(winnerswinner1_of_pair_0(26), i);
        if winnerswinner1_of_four_0_24_choices(i) then
          winnerswinner1_of_four_0_24_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(25), i)) and (not
            is_set(winnerswinner1_of_pair_0(24), i))) or winnerswinner1_of_four_0_24_values(2 * i - 1) or
            winnerswinner1_of_four_0_24_values(2 * i);
        else
          winnerswinner1_of_four_0_24_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(25), i)) and (not
            is_set(winnerswinner1_of_pair_0(24), i)) and (winnerswinner1_of_four_0_24_values(2 * i - 1) or
            winnerswinner1_of_four_0_24_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_24_choices(6) then
        winnerswinner1_of_four_0_24_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(25), 6)) and (not
          is_set(winnerswinner1_of_pair_0(24), 6)))) and (not is_set(winnerswinner1_of_pair_0(27), 6)) and (not
          is_set(winnerswinner1_of_pair_0(26), 6));
      else
        winnerswinner1_of_four_0_24_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(25), 6)) and (not
          is_set(winnerswinner1_of_pair_0(24), 6)))) or ((not is_set(winnerswinner1_of_pair_0(27), 6)) and (not
          is_set(winnerswinner1_of_pair_0(26), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(29), 0) then
        winnerswinner1_of_four_0_28_choice := (not is_set(winnerswinner1_of_pair_0(31), 0)) and (not
          is_set(winnerswinner1_of_pair_0(30), 0));
      else
        winnerswinner1_of_four_0_28_choice := is_set(winnerswinner1_of_pair_0(28), 0) and (not
          is_set(winnerswinner1_of_pair_0(31), 0)) and (not is_set(winnerswinner1_of_pair_0(30), 0));
      end if;
      winnerswinner1_of_four_0_28_value := is_set(winnerswinner1_of_pair_0(29), 1);
      winnerswinner1_of_four_0_28_values(2) := is_set(winnerswinner1_of_pair_0(28), 1);
      if (not is_set(winnerswinner1_of_pair_0(31), 1)) and (not is_set(winnerswinner1_of_pair_0(30), 1)) then
        winnerswinner1_of_four_0_28_choices(2) := winnerswinner1_of_four_0_28_choice or
          winnerswinner1_of_four_0_28_value or winnerswinner1_of_four_0_28_values(2);
      else
        winnerswinner1_of_four_0_28_choices(2) := winnerswinner1_of_four_0_28_choice and
          (winnerswinner1_of_four_0_28_value or winnerswinner1_of_four_0_28_values(2));
      end if;
      winnerswinner1_of_four_0_28_values(3) := is_set(winnerswinner1_of_pair_0(31), 2);
      winnerswinner1_of_four_0_28_values(4) := is_set(winnerswinner1_of_pair_0(30), 2);
      if winnerswinner1_of_four_0_28_choices(2) then
        winnerswinner1_of_four_0_28_choices(3) := (not is_set(winnerswinner1_of_pair_0(29), 2)) and (not
          is_set(winnerswinner1_of_pair_0(28), 2)) and (winnerswinner1_of_four_0_28_values(3) or
          winnerswinner1_of_four_0_28_values(4));
      else
        winnerswinner1_of_four_0_28_choices(3) := ((not is_set(winnerswinner1_of_pair_0(29), 2)) and (not
          is_set(winnerswinner1_of_pair_0(28), 2))) or winnerswinner1_of_four_0_28_values(3) or
          winnerswinner1_of_four_0_28_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_28_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(31), i);
        winnerswinner1_of_four_0_28_values(2 * i) := is_set(winnerswinner1_of_pair_0(30), i);
        if winnerswinner1_of_four_0_28_choices(i) then
          winnerswinner1_of_four_0_28_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(29), i)) and (not
            is_set(winnerswinner1_of_pair_0(28), i))) or winnerswinner1_of_four_0_28_values(2 * i - 1) or
            winnerswinner1_of_four_0_28_values(2 * i);
        else
          winnerswinner1_of_four_0_28_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(29), i)) and (not
            is_set(winnerswinner1_of_pair_0(28), i)) and (winnerswinner1_of_four_0_28_values(2 * i - 1) or
            winnerswinner1_of_four_0_28_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_28_choices(6) then
        winnerswinner1_of_four_0_28_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(29), 6)) and (not
          is_set(winnerswinner1_of_pair_0(28), 6)))) and (not is_set(winnerswinner1_of_pair_0(31), 6)) and (not
          is_set(winnerswinner1_of_pair_0(30), 6));
      else
        winnerswinner1_of_four_0_28_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(29), 6)) and (not
          is_set(winnerswinner1_of_pair_0(28), 6)))) or ((not is_set(winnerswinner1_of_pair_0(31), 6)) and (not
          is_set(winnerswinner1_of_pair_0(30), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(33), 0) then
        winnerswinner1_of_four_0_32_choice := (not is_set(winnerswinner1_of_pair_0(35), 0)) and (not
          is_set(winnerswinner1_of_pair_0(34), 0));
      else
        winnerswinner1_of_four_0_32_choice := is_set(winnerswinner1_of_pair_0(32), 0) and (not
          is_set(winnerswinner1_of_pair_0(35), 0)) and (not is_set(winnerswinner1_of_pair_0(34), 0));
      end if;
      winnerswinner1_of_four_0_32_value := is_set(winnerswinner1_of_pair_0(33), 1);
      winnerswinner1_of_four_0_32_values(2) := is_set(winnerswinner1_of_pair_0(32), 1);
      if (not is_set(winnerswinner1_of_pair_0(35), 1)) and (not is_set(winnerswinner1_of_pair_0(34), 1)) then
        winnerswinner1_of_four_0_32_choices(2) := winnerswinner1_of_four_0_32_choice or
          winnerswinner1_of_four_0_32_value or winnerswinner1_of_four_0_32_values(2);
      else
        winnerswinner1_of_four_0_32_choices(2) := winnerswinner1_of_four_0_32_choice and
          (winnerswinner1_of_four_0_32_value or winnerswinner1_of_four_0_32_values(2));
      end if;
      winnerswinner1_of_four_0_32_values(3) := is_set(winnerswinner1_of_pair_0(35), 2);
      winnerswinner1_of_four_0_32_values(4) := is_set(winnerswinner1_of_pair_0(34), 2);
      if winnerswinner1_of_four_0_32_choices(2) then
        winnerswinner1_of_four_0_32_choices(3) := (not is_set(winnerswinner1_of_pair_0(33), 2)) and (not
          is_set(winnerswinner1_of_pair_0(32), 2)) and (winnerswinner1_of_four_0_32_values(3) or
          winnerswinner1_of_four_0_32_values(4));
      else
        winnerswinner1_of_four_0_32_choices(3) := ((not is_set(winnerswinner1_of_pair_0(33), 2)) and (not
          is_set(winnerswinner1_of_pair_0(32), 2))) or winnerswinner1_of_four_0_32_values(3) or
          winnerswinner1_of_four_0_32_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_32_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(35), i);
        winnerswinner1_of_four_0_32_values(2 * i) := is_set(winnerswinner1_of_pair_0(34), i);
        if winnerswinner1_of_four_0_32_choices(i) then
          winnerswinner1_of_four_0_32_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(33), i)) and (not
            is_set(winnerswinner1_of_pair_0(32), i))) or winnerswinner1_of_four_0_32_values(2 * i - 1) or
            winnerswinner1_of_four_0_32_values(2 * i);
        else
          winnerswinner1_of_four_0_32_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(33), i)) and (not
            is_set(winnerswinner1_of_pair_0(32), i)) and (winnerswinner1_of_four_0_32_values(2 * i - 1) or
            winnerswinner1_of_four_0_32_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_32_choices(6) then
        winnerswinner1_of_four_0_32_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(33), 6)) and (not
          is_set(winnerswinner1_of_pair_0(32), 6)))) and (not is_set(winnerswinner1_of_pair_0(35), 6)) and (not
          is_set(winnerswinner1_of_pair_0(34), 6));
      else
        winnerswinner1_of_four_0_32_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(33), 6)) and (not
          is_set(winnerswinner1_of_pair_0(32), 6)))) or ((not is_set(winnerswinner1_of_pair_0(35), 6)) and (not
          is_set(winnerswinner1_of_pair_0(34), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(37), 0) then
        winnerswinner1_of_four_0_36_choice := (not is_set(winnerswinner1_of_pair_0(39), 0)) and (not
          is_set(winnerswinner1_of_pair_0(38), 0));
      else
        winnerswinner1_of_four_0_36_choice := is_set(winnerswinner1_of_pair_0(36), 0) and (not
          is_set(winnerswinner1_of_pair_0(39), 0)) and (not is_set(winnerswinner1_of_pair_0(38), 0));
      end if;
      winnerswinner1_of_four_0_36_value := is_set(winnerswinner1_of_pair_0(37), 1);
      winnerswinner1_of_four_0_36_values(2) := is_set(winnerswinner1_of_pair_0(36), 1);
      if (not is_set(winnerswinner1_of_pair_0(39), 1)) and (not is_set(winnerswinner1_of_pair_0(38), 1)) then
        winnerswinner1_of_four_0_36_choices(2) := winnerswinner1_of_four_0_36_choice or
          winnerswinner1_of_four_0_36_value or winnerswinner1_of_four_0_36_values(2);
      else
        winnerswinner1_of_four_0_36_choices(2) := winnerswinner1_of_four_0_36_choice and
          (winnerswinner1_of_four_0_36_value or winnerswinner1_of_four_0_36_values(2));
      end if;
      winnerswinner1_of_four_0_36_values(3) := is_set(winnerswinner1_of_pair_0(39), 2);
      winnerswinner1_of_four_0_36_values(4) := is_set(winnerswinner1_of_pair_0(38), 2);
      if winnerswinner1_of_four_0_36_choices(2) then
        winnerswinner1_of_four_0_36_choices(3) := (not is_set(winnerswinner1_of_pair_0(37), 2)) and (not
          is_set(winnerswinner1_of_pair_0(36), 2)) and (winnerswinner1_of_four_0_36_values(3) or
          winnerswinner1_of_four_0_36_values(4));
      else
        winnerswinner1_of_four_0_36_choices(3) := ((not is_set(winnerswinner1_of_pair_0(37), 2)) and (not
          is_set(winnerswinner1_of_pair_0(36), 2))) or winnerswinner1_of_four_0_36_values(3) or
          winnerswinner1_of_four_0_36_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_36_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(39), i);
        winnerswinner1_of_four_0_36_values(2 * i) := is_set(winnerswinner1_of_pair_0(38), i);
        if winnerswinner1_of_four_0_36_choices(i) then
          winnerswinner1_of_four_0_36_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(37), i)) and (not
            is_set(winnerswinner1_of_pair_0(36), i))) or winnerswinner1_of_four_0_36_values(2 * i - 1) or
            winnerswinner1_of_four_0_36_values(2 * i);
        else
          winnerswinner1_of_four_0_36_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(37), i)) and (not
            is_set(winnerswinner1_of_pair_0(36), i)) and (winnerswinner1_of_four_0_36_values(2 * i - 1) or
            winnerswinner1_of_four_0_36_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_36_choices(6) then
        winnerswinner1_of_four_0_36_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(37), 6)) and (not
          is_set(winnerswinner1_of_pair_0(36), 6)))) and (not is_set(winnerswinner1_of_pair_0(39), 6)) and (not
          is_set(winnerswinner1_of_pair_0(38), 6));
      else
        winnerswinner1_of_four_0_36_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(37), 6)) and (not
          is_set(winnerswinner1_of_pair_0(36), 6)))) or ((not is_set(winnerswinner1_of_pair_0(39), 6)) and (not
          is_set(winnerswinner1_of_pair_0(38), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(41), 0) then
        winnerswinner1_of_four_0_40_choice := (not is_set(winnerswinner1_of_pair_0(43), 0)) and (not
          is_set(winnerswinner1_of_pair_0(42), 0));
      else
        winnerswinner1_of_four_0_40_choice := is_set(winnerswinner1_of_pair_0(40), 0) and (not
          is_set(winnerswinner1_of_pair_0(43), 0)) and (not is_set(winnerswinner1_of_pair_0(42), 0));
      end if;
      winnerswinner1_of_four_0_40_value := is_set(winnerswinner1_of_pair_0(41), 1);
      winnerswinner1_of_four_0_40_values(2) := is_set(winnerswinner1_of_pair_0(40), 1);
      if (not is_set(winnerswinner1_of_pair_0(43), 1)) and (not is_set(winnerswinner1_of_pair_0(42), 1)) then
        winnerswinner1_of_four_0_40_choices(2) := winnerswinner1_of_four_0_40_choice or
          winnerswinner1_of_four_0_40_value or winnerswinner1_of_four_0_40_values(2);
      else
        winnerswinner1_of_four_0_40_choices(2) := winnerswinner1_of_four_0_40_choice and
          (winnerswinner1_of_four_0_40_value or winnerswinner1_of_four_0_40_values(2));
      end if;
      winnerswinner1_of_four_0_40_values(3) := is_set(winnerswinner1_of_pair_0(43), 2);
      winnerswinner1_of_four_0_40_values(4) := is_set(winnerswinner1_of_pair_0(42), 2);
      if winnerswinner1_of_four_0_40_choices(2) then
        winnerswinner1_of_four_0_40_choices(3) := (not is_set(winnerswinner1_of_pair_0(41), 2)) and (not
          is_set(winnerswinner1_of_pair_0(40), 2)) and (winnerswinner1_of_four_0_40_values(3) or
          winnerswinner1_of_four_0_40_values(4));
      else
        winnerswinner1_of_four_0_40_choices(3) := ((not is_set(winnerswinner1_of_pair_0(41), 2)) and (not
          is_set(winnerswinner1_of_pair_0(40), 2))) or winnerswinner1_of_four_0_40_values(3) or
          winnerswinner1_of_four_0_40_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_40_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(43), i);
        winnerswinner1_of_four_0_40_values(2 * i) := is_set(winnerswinner1_of_pair_0(42), i);
        if winnerswinner1_of_four_0_40_choices(i) then
          winnerswinner1_of_four_0_40_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(41), i)) and (not
            is_set(winnerswinner1_of_pair_0(40), i))) or winnerswinner1_of_four_0_40_values(2 * i - 1) or
            winnerswinner1_of_four_0_40_values(2 * i);
        else
          winnerswinner1_of_four_0_40_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(41), i)) and (not
            is_set(winnerswinner1_of_pair_0(40), i)) and (winnerswinner1_of_four_0_40_values(2 * i - 1) or
            winnerswinner1_of_four_0_40_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_40_choices(6) then
        winnerswinner1_of_four_0_40_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(41), 6)) and (not
          is_set(winnerswinner1_of_pair_0(40), 6)))) and (not is_set(winnerswinner1_of_pair_0(43), 6)) and (not
          is_set(winnerswinner1_of_pair_0(42), 6));
      else
        winnerswinner1_of_four_0_40_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(41), 6)) and (not
          is_set(winnerswinner1_of_pair_0(40), 6)))) or ((not is_set(winnerswinner1_of_pair_0(43), 6)) and (not
          is_set(winnerswinner1_of_pair_0(42), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(45), 0) then
        winnerswinner1_of_four_0_44_choice := (not is_set(winnerswinner1_of_pair_0(47), 0)) and (not
          is_set(winnerswinner1_of_pair_0(46), 0));
      else
        winnerswinner1_of_four_0_44_choice := is_set(winnerswinner1_of_pair_0(44), 0) and (not
          is_set(winnerswinner1_of_pair_0(47), 0)) and (not is_set(winnerswinner1_of_pair_0(46), 0));
      end if;
      winnerswinner1_of_four_0_44_value := is_set(winnerswinner1_of_pair_0(45), 1);
      winnerswinner1_of_four_0_44_values(2) := is_set(winnerswinner1_of_pair_0(44), 1);
      if (not is_set(winnerswinner1_of_pair_0(47), 1)) and (not is_set(winnerswinner1_of_pair_0(46), 1)) then
        winnerswinner1_of_four_0_44_choices(2) := winnerswinner1_of_four_0_44_choice or
          winnerswinner1_of_four_0_44_value or winnerswinner1_of_four_0_44_values(2);
      else
        winnerswinner1_of_four_0_44_choices(2) := winnerswinner1_of_four_0_44_choice and
          (winnerswinner1_of_four_0_44_value or winnerswinner1_of_four_0_44_values(2));
      end if;
      winnerswinner1_of_four_0_44_values(3) := is_set(winnerswinner1_of_pair_0(47), 2);
      winnerswinner1_of_four_0_44_values(4) := is_set(winnerswinner1_of_pair_0(46), 2);
      if winnerswinner1_of_four_0_44_choices(2) then
        winnerswinner1_of_four_0_44_choices(3) := (not is_set(winnerswinner1_of_pair_0(45), 2)) and (not
          is_set(winnerswinner1_of_pair_0(44), 2)) and (winnerswinner1_of_four_0_44_values(3) or
          winnerswinner1_of_four_0_44_values(4));
      else
        winnerswinner1_of_four_0_44_choices(3) := ((not is_set(winnerswinner1_of_pair_0(45), 2)) and (not
          is_set(winnerswinner1_of_pair_0(44), 2))) or winnerswinner1_of_four_0_44_values(3) or
          winnerswinner1_of_four_0_44_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_44_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(47), i);
        winnerswinner1_of_four_0_44_values(2 * i) := is_set(winnerswinner1_of_pair_0(46), i);
        if winnerswinner1_of_four_0_44_choices(i) then
          winnerswinner1_of_four_0_44_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(45), i)) and (not
            is_set(winnerswinner1_of_pair_0(44), i))) or winnerswinner1_of_four_0_44_values(2 * i - 1) or
            winnerswinner1_of_four_0_44_values(2 * i);
        else
          winnerswinner1_of_four_0_44_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(45), i)) and (not
            is_set(winnerswinner1_of_pair_0(44), i)) and (winnerswinner1_of_four_0_44_values(2 * i - 1) or
            winnerswinner1_of_four_0_44_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_44_choices(6) then
        winnerswinner1_of_four_0_44_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(45), 6)) and (not
          is_set(winnerswinner1_of_pair_0(44), 6)))) and (not is_set(winnerswinner1_of_pair_0(47), 6)) and (not
          is_set(winnerswinner1_of_pair_0(46), 6));
      else
        winnerswinner1_of_four_0_44_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(45), 6)) and (not
          is_set(winnerswinner1_of_pair_0(44), 6)))) or ((not is_set(winnerswinner1_of_pair_0(47), 6)) and (not
          is_set(winnerswinner1_of_pair_0(46), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(49), 0) then
        winnerswinner1_of_four_0_48_choice := (not is_set(winnerswinner1_of_pair_0(51), 0)) and (not
          is_set(winnerswinner1_of_pair_0(50), 0));
      else
        winnerswinner1_of_four_0_48_choice := is_set(winnerswinner1_of_pair_0(48), 0) and (not
          is_set(winnerswinner1_of_pair_0(51), 0)) and (not is_set(winnerswinner1_of_pair_0(50), 0));
      end if;
      winnerswinner1_of_four_0_48_value := is_set(winnerswinner1_of_pair_0(49), 1);
      winnerswinner1_of_four_0_48_values(2) := is_set(winnerswinner1_of_pair_0(48), 1);
      if (not is_set(winnerswinner1_of_pair_0(51), 1)) and (not is_set(winnerswinner1_of_pair_0(50), 1)) then
        winnerswinner1_of_four_0_48_choices(2) := winnerswinner1_of_four_0_48_choice or
          winnerswinner1_of_four_0_48_value or winnerswinner1_of_four_0_48_values(2);
      else
        winnerswinner1_of_four_0_48_choices(2) := winnerswinner1_of_four_0_48_choice and
          (winnerswinner1_of_four_0_48_value or winnerswinner1_of_four_0_48_values(2));
      end if;
      winnerswinner1_of_four_0_48_values(3) := is_set(winnerswinner1_of_pair_0(51), 2);
      winnerswinner1_of_four_0_48_values(4) := is_set(winnerswinner1_of_pair_0(50), 2);
      if winnerswinner1_of_four_0_48_choices(2) then
        winnerswinner1_of_four_0_48_choices(3) := (not is_set(winnerswinner1_of_pair_0(49), 2)) and (not
          is_set(winnerswinner1_of_pair_0(48), 2)) and (winnerswinner1_of_four_0_48_values(3) or
          winnerswinner1_of_four_0_48_values(4));
      else
        winnerswinner1_of_four_0_48_choices(3) := ((not is_set(winnerswinner1_of_pair_0(49), 2)) and (not
          is_set(winnerswinner1_of_pair_0(48), 2))) or winnerswinner1_of_four_0_48_values(3) or
          winnerswinner1_of_four_0_48_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_48_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(51), i);
        winnerswinner1_of_four_0_48_values(2 * i) := is_set(winnerswinner1_of_pair_0(50), i);
        if winnerswinner1_of_four_0_48_choices(i) then
          winnerswinner1_of_four_0_48_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(49), i)) and (not
            is_set(winnerswinner1_of_pair_0(48), i))) or winnerswinner1_of_four_0_48_values(2 * i - 1) or
            winnerswinner1_of_four_0_48_values(2 * i);
        else
          winnerswinner1_of_four_0_48_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(49), i)) and (not
            is_set(winnerswinner1_of_pair_0(48), i)) and (winnerswinner1_of_four_0_48_values(2 * i - 1) or
            winnerswinner1_of_four_0_48_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_48_choices(6) then
        winnerswinner1_of_four_0_48_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(49), 6)) and (not
          is_set(winnerswinner1_of_pair_0(48), 6)))) and (not is_set(winnerswinner1_of_pair_0(51), 6)) and (not
          is_set(winnerswinner1_of_pair_0(50), 6));
      else
        winnerswinner1_of_four_0_48_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(49), 6)) and (not
          is_set(winnerswinner1_of_pair_0(48), 6)))) or ((not is_set(winnerswinner1_of_pair_0(51), 6)) and (not
          is_set(winnerswinner1_of_pair_0(50), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(53), 0) then
        winnerswinner1_of_four_0_52_choice := (not is_set(winnerswinner1_of_pair_0(55), 0)) and (not
          is_set(winnerswinner1_of_pair_0(54), 0));
      else
        winnerswinner1_of_four_0_52_choice := is_set(winnerswinner1_of_pair_0(52), 0) and (not
          is_set(winnerswinner1_of_pair_0(55), 0)) and (not is_set(winnerswinner1_of_pair_0(54), 0));
      end if;
      winnerswinner1_of_four_0_52_value := is_set(winnerswinner1_of_pair_0(53), 1);
      winnerswinner1_of_four_0_52_values(2) := is_set(winnerswinner1_of_pair_0(52), 1);
      if (not is_set(winnerswinner1_of_pair_0(55), 1)) and (not is_set(winnerswinner1_of_pair_0(54), 1)) then
        winnerswinner1_of_four_0_52_choices(2) := winnerswinner1_of_four_0_52_choice or
          winnerswinner1_of_four_0_52_value or winnerswinner1_of_four_0_52_values(2);
      else
        winnerswinner1_of_four_0_52_choices(2) := winnerswinner1_of_four_0_52_choice and
          (winnerswinner1_of_four_0_52_value or winnerswinner1_of_four_0_52_values(2));
      end if;
      winnerswinner1_of_four_0_52_values(3) := is_set(winnerswinner1_of_pair_0(55), 2);
      winnerswinner1_of_four_0_52_values(4) := is_set(winnerswinner1_of_pair_0(54), 2);
      if winnerswinner1_of_four_0_52_choices(2) then
        winnerswinner1_of_four_0_52_choices(3) := (not is_set(winnerswinner1_of_pair_0(53), 2)) and (not
          is_set(winnerswinner1_of_pair_0(52), 2)) and (winnerswinner1_of_four_0_52_values(3) or
          winnerswinner1_of_four_0_52_values(4));
      else
        winnerswinner1_of_four_0_52_choices(3) := ((not is_set(winnerswinner1_of_pair_0(53), 2)) and (not
          is_set(winnerswinner1_of_pair_0(52), 2))) or winnerswinner1_of_four_0_52_values(3) or
          winnerswinner1_of_four_0_52_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_52_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(55), i);
        winnerswinner1_of_four_0_52_values(2 * i) := is_set(winnerswinner1_of_pair_0(54), i);
        if winnerswinner1_of_four_0_52_choices(i) then
          winnerswinner1_of_four_0_52_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(53), i)) and (not
            is_set(winnerswinner1_of_pair_0(52), i))) or winnerswinner1_of_four_0_52_values(2 * i - 1) or
            winnerswinner1_of_four_0_52_values(2 * i);
        else
          winnerswinner1_of_four_0_52_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(53), i)) and (not
            is_set(winnerswinner1_of_pair_0(52), i)) and (winnerswinner1_of_four_0_52_values(2 * i - 1) or
            winnerswinner1_of_four_0_52_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_52_choices(6) then
        winnerswinner1_of_four_0_52_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(53), 6)) and (not
          is_set(winnerswinner1_of_pair_0(52), 6)))) and (not is_set(winnerswinner1_of_pair_0(55), 6)) and (not
          is_set(winnerswinner1_of_pair_0(54), 6));
      else
        winnerswinner1_of_four_0_52_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(53), 6)) and (not
          is_set(winnerswinner1_of_pair_0(52), 6)))) or ((not is_set(winnerswinner1_of_pair_0(55), 6)) and (not
          is_set(winnerswinner1_of_pair_0(54), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(57), 0) then
        winnerswinner1_of_four_0_56_choice := (not is_set(winnerswinner1_of_pair_0(59), 0)) and (not
          is_set(winnerswinner1_of_pair_0(58), 0));
      else
        winnerswinner1_of_four_0_56_choice := is_set(winnerswinner1_of_pair_0(56), 0) and (not
          is_set(winnerswinner1_of_pair_0(59), 0)) and (not is_set(winnerswinner1_of_pair_0(58), 0));
      end if;
      winnerswinner1_of_four_0_56_value := is_set(winnerswinner1_of_pair_0(57), 1);
      winnerswinner1_of_four_0_56_values(2) := is_set(winnerswinner1_of_pair_0(56), 1);
      if (not is_set(winnerswinner1_of_pair_0(59), 1)) and (not is_set(winnerswinner1_of_pair_0(58), 1)) then
        winnerswinner1_of_four_0_56_choices(2) := winnerswinner1_of_four_0_56_choice or
          winnerswinner1_of_four_0_56_value or winnerswinner1_of_four_0_56_values(2);
      else
        winnerswinner1_of_four_0_56_choices(2) := winnerswinner1_of_four_0_56_choice and
          (winnerswinner1_of_four_0_56_value or winnerswinner1_of_four_0_56_values(2));
      end if;
      winnerswinner1_of_four_0_56_values(3) := is_set(winnerswinner1_of_pair_0(59), 2);
      winnerswinner1_of_four_0_56_values(4) := is_set(winnerswinner1_of_pair_0(58), 2);
      if winnerswinner1_of_four_0_56_choices(2) then
        winnerswinner1_of_four_0_56_choices(3) := (not is_set(winnerswinner1_of_pair_0(57), 2)) and (not
          is_set(winnerswinner1_of_pair_0(56), 2)) and (winnerswinner1_of_four_0_56_values(3) or
          winnerswinner1_of_four_0_56_values(4));
      else
        winnerswinner1_of_four_0_56_choices(3) := ((not is_set(winnerswinner1_of_pair_0(57), 2)) and (not
          is_set(winnerswinner1_of_pair_0(56), 2))) or winnerswinner1_of_four_0_56_values(3) or
          winnerswinner1_of_four_0_56_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_56_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(59), i);
        winnerswinner1_of_four_0_56_values(2 * i) := is_set(winnerswinner1_of_pair_0(58), i);
        if winnerswinner1_of_four_0_56_choices(i) then
          winnerswinner1_of_four_0_56_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(57), i)) and (not
            is_set(winnerswinner1_of_pair_0(56), i))) or winnerswinner1_of_four_0_56_values(2 * i - 1) or
            winnerswinner1_of_four_0_56_values(2 * i);
        else
          winnerswinner1_of_four_0_56_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(57), i)) and (not
            is_set(winnerswinner1_of_pair_0(56), i)) and (winnerswinner1_of_four_0_56_values(2 * i - 1) or
            winnerswinner1_of_four_0_56_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_56_choices(6) then
        winnerswinner1_of_four_0_56_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(57), 6)) and (not
          is_set(winnerswinner1_of_pair_0(56), 6)))) and (not is_set(winnerswinner1_of_pair_0(59), 6)) and (not
          is_set(winnerswinner1_of_pair_0(58), 6));
      else
        winnerswinner1_of_four_0_56_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(57), 6)) and (not
          is_set(winnerswinner1_of_pair_0(56), 6)))) or ((not is_set(winnerswinner1_of_pair_0(59), 6)) and (not
          is_set(winnerswinner1_of_pair_0(58), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(61), 0) then
        winnerswinner1_of_four_0_60_choice := (not is_set(winnerswinner1_of_pair_0(63), 0)) and (not
          is_set(winnerswinner1_of_pair_0(62), 0));
      else
        winnerswinner1_of_four_0_60_choice := is_set(winnerswinner1_of_pair_0(60), 0) and (not
          is_set(winnerswinner1_of_pair_0(63), 0)) and (not is_set(winnerswinner1_of_pair_0(62), 0));
      end if;
      winnerswinner1_of_four_0_60_value := is_set(winnerswinner1_of_pair_0(61), 1);
      winnerswinner1_of_four_0_60_values(2) := is_set(winnerswinner1_of_pair_0(60), 1);
      if (not is_set(winnerswinner1_of_pair_0(63), 1)) and (not is_set(winnerswinner1_of_pair_0(62), 1)) then
        winnerswinner1_of_four_0_60_choices(2) := winnerswinner1_of_four_0_60_choice or
          winnerswinner1_of_four_0_60_value or winnerswinner1_of_four_0_60_values(2);
      else
        winnerswinner1_of_four_0_60_choices(2) := winnerswinner1_of_four_0_60_choice and
          (winnerswinner1_of_four_0_60_value or winnerswinner1_of_four_0_60_values(2));
      end if;
      winnerswinner1_of_four_0_60_values(3) := is_set(winnerswinner1_of_pair_0(63), 2);
      winnerswinner1_of_four_0_60_values(4) := is_set(winnerswinner1_of_pair_0(62), 2);
      if winnerswinner1_of_four_0_60_choices(2) then
        winnerswinner1_of_four_0_60_choices(3) := (not is_set(winnerswinner1_of_pair_0(61), 2)) and (not
          is_set(winnerswinner1_of_pair_0(60), 2)) and (winnerswinner1_of_four_0_60_values(3) or
          winnerswinner1_of_four_0_60_values(4));
      else
        winnerswinner1_of_four_0_60_choices(3) := ((not is_set(winnerswinner1_of_pair_0(61), 2)) and (not
          is_set(winnerswinner1_of_pair_0(60), 2))) or winnerswinner1_of_four_0_60_values(3) or
          winnerswinner1_of_four_0_60_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_60_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(63), i);
        winnerswinner1_of_four_0_60_values(2 * i) := is_set(winnerswinner1_of_pair_0(62), i);
        if winnerswinner1_of_four_0_60_choices(i) then
          winnerswinner1_of_four_0_60_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(61), i)) and (not
            is_set(winnerswinner1_of_pair_0(60), i))) or winnerswinner1_of_four_0_60_values(2 * i - 1) or
            winnerswinner1_of_four_0_60_values(2 * i);
        else
          winnerswinner1_of_four_0_60_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(61), i)) and (not
            is_set(winnerswinner1_of_pair_0(60), i)) and (winnerswinner1_of_four_0_60_values(2 * i - 1) or
            winnerswinner1_of_four_0_60_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_60_choices(6) then
        winnerswinner1_of_four_0_60_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(61), 6)) and (not
          is_set(winnerswinner1_of_pair_0(60), 6)))) and (not is_set(winnerswinner1_of_pair_0(63), 6)) and (not
          is_set(winnerswinner1_of_pair_0(62), 6));
      else
        winnerswinner1_of_four_0_60_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(61), 6)) and (not
          is_set(winnerswinner1_of_pair_0(60), 6)))) or ((not is_set(winnerswinner1_of_pair_0(63), 6)) and (not
          is_set(winnerswinner1_of_pair_0(62), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(65), 0) then
        winnerswinner1_of_four_0_64_choice := (not is_set(winnerswinner1_of_pair_0(67), 0)) and (not
          is_set(winnerswinner1_of_pair_0(66), 0));
      else
        winnerswinner1_of_four_0_64_choice := is_set(winnerswinner1_of_pair_0(64), 0) and (not
          is_set(winnerswinner1_of_pair_0(67), 0)) and (not is_set(winnerswinner1_of_pair_0(66), 0));
      end if;
      winnerswinner1_of_four_0_64_value := is_set(winnerswinner1_of_pair_0(65), 1);
      winnerswinner1_of_four_0_64_values(2) := is_set(winnerswinner1_of_pair_0(64), 1);
      if (not is_set(winnerswinner1_of_pair_0(67), 1)) and (not is_set(winnerswinner1_of_pair_0(66), 1)) then
        winnerswinner1_of_four_0_64_choices(2) := winnerswinner1_of_four_0_64_choice or
          winnerswinner1_of_four_0_64_value or winnerswinner1_of_four_0_64_values(2);
      else
        winnerswinner1_of_four_0_64_choices(2) := winnerswinner1_of_four_0_64_choice and
          (winnerswinner1_of_four_0_64_value or winnerswinner1_of_four_0_64_values(2));
      end if;
      winnerswinner1_of_four_0_64_values(3) := is_set(winnerswinner1_of_pair_0(67), 2);
      winnerswinner1_of_four_0_64_values(4) := is_set(winnerswinner1_of_pair_0(66), 2);
      if winnerswinner1_of_four_0_64_choices(2) then
        winnerswinner1_of_four_0_64_choices(3) := (not is_set(winnerswinner1_of_pair_0(65), 2)) and (not
          is_set(winnerswinner1_of_pair_0(64), 2)) and (winnerswinner1_of_four_0_64_values(3) or
          winnerswinner1_of_four_0_64_values(4));
      else
        winnerswinner1_of_four_0_64_choices(3) := ((not is_set(winnerswinner1_of_pair_0(65), 2)) and (not
          is_set(winnerswinner1_of_pair_0(64), 2))) or winnerswinner1_of_four_0_64_values(3) or
          winnerswinner1_of_four_0_64_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_64_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(67), i);
        winnerswinner1_of_four_0_64_values(2 * i) := is_set(winnerswinner1_of_pair_0(66), i);
        if winnerswinner1_of_four_0_64_choices(i) then
          winnerswinner1_of_four_0_64_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(65), i)) and (not
            is_set(winnerswinner1_of_pair_0(64), i))) or winnerswinner1_of_four_0_64_values(2 * i - 1) or
            winnerswinner1_of_four_0_64_values(2 * i);
        else
          winnerswinner1_of_four_0_64_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(65), i)) and (not
            is_set(winnerswinner1_of_pair_0(64), i)) and (winnerswinner1_of_four_0_64_values(2 * i - 1) or
            winnerswinner1_of_four_0_64_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_64_choices(6) then
        winnerswinner1_of_four_0_64_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(65), 6)) and (not
          is_set(winnerswinner1_of_pair_0(64), 6)))) and (not is_set(winnerswinner1_of_pair_0(67), 6)) and (not
          is_set(winnerswinner1_of_pair_0(66), 6));
      else
        winnerswinner1_of_four_0_64_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(65), 6)) and (not
          is_set(winnerswinner1_of_pair_0(64), 6)))) or ((not is_set(winnerswinner1_of_pair_0(67), 6)) and (not
          is_set(winnerswinner1_of_pair_0(66), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(69), 0) then
        winnerswinner1_of_four_0_68_choice := (not is_set(winnerswinner1_of_pair_0(71), 0)) and (not
          is_set(winnerswinner1_of_pair_0(70), 0));
      else
        winnerswinner1_of_four_0_68_choice := is_set(winnerswinner1_of_pair_0(68), 0) and (not
          is_set(winnerswinner1_of_pair_0(71), 0)) and (not is_set(winnerswinner1_of_pair_0(70), 0));
      end if;
      winnerswinner1_of_four_0_68_value := is_set(winnerswinner1_of_pair_0(69), 1);
      winnerswinner1_of_four_0_68_values(2) := is_set(winnerswinner1_of_pair_0(68), 1);
      if (not is_set(winnerswinner1_of_pair_0(71), 1)) and (not is_set(winnerswinner1_of_pair_0(70), 1)) then
        winnerswinner1_of_four_0_68_choices(2) := winnerswinner1_of_four_0_68_choice or
          winnerswinner1_of_four_0_68_value or winnerswinner1_of_four_0_68_values(2);
      else
        winnerswinner1_of_four_0_68_choices(2) := winnerswinner1_of_four_0_68_choice and
          (winnerswinner1_of_four_0_68_value or winnerswinner1_of_four_0_68_values(2));
      end if;
      winnerswinner1_of_four_0_68_values(3) := is_set(winnerswinner1_of_pair_0(71), 2);
      winnerswinner1_of_four_0_68_values(4) := is_set(winnerswinner1_of_pair_0(70), 2);
      if winnerswinner1_of_four_0_68_choices(2) then
        winnerswinner1_of_four_0_68_choices(3) := (not is_set(winnerswinner1_of_pair_0(69), 2)) and (not
          is_set(winnerswinner1_of_pair_0(68), 2)) and (winnerswinner1_of_four_0_68_values(3) or
          winnerswinner1_of_four_0_68_values(4));
      else
        winnerswinner1_of_four_0_68_choices(3) := ((not is_set(winnerswinner1_of_pair_0(69), 2)) and (not
          is_set(winnerswinner1_of_pair_0(68), 2))) or winnerswinner1_of_four_0_68_values(3) or
          winnerswinner1_of_four_0_68_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_68_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(71), i);
        winnerswinner1_of_four_0_68_values(2 * i) := is_set(winnerswinner1_of_pair_0(70), i);
        if winnerswinner1_of_four_0_68_choices(i) then
          winnerswinner1_of_four_0_68_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(69), i)) and (not
            is_set(winnerswinner1_of_pair_0(68), i))) or winnerswinner1_of_four_0_68_values(2 * i - 1) or
            winnerswinner1_of_four_0_68_values(2 * i);
        else
          winnerswinner1_of_four_0_68_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(69), i)) and (not
            is_set(winnerswinner1_of_pair_0(68), i)) and (winnerswinner1_of_four_0_68_values(2 * i - 1) or
            winnerswinner1_of_four_0_68_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_68_choices(6) then
        winnerswinner1_of_four_0_68_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(69), 6)) and (not
          is_set(winnerswinner1_of_pair_0(68), 6)))) and (not is_set(winnerswinner1_of_pair_0(71), 6)) and (not
          is_set(winnerswinner1_of_pair_0(70), 6));
      else
        winnerswinner1_of_four_0_68_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(69), 6)) and (not
          is_set(winnerswinner1_of_pair_0(68), 6)))) or ((not is_set(winnerswinner1_of_pair_0(71), 6)) and (not
          is_set(winnerswinner1_of_pair_0(70), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(73), 0) then
        winnerswinner1_of_four_0_72_choice := (not is_set(winnerswinner1_of_pair_0(75), 0)) and (not
          is_set(winnerswinner1_of_pair_0(74), 0));
      else
        winnerswinner1_of_four_0_72_choice := is_set(winnerswinner1_of_pair_0(72), 0) and (not
          is_set(winnerswinner1_of_pair_0(75), 0)) and (not is_set(winnerswinner1_of_pair_0(74), 0));
      end if;
      winnerswinner1_of_four_0_72_value := is_set(winnerswinner1_of_pair_0(73), 1);
      winnerswinner1_of_four_0_72_values(2) := is_set(winnerswinner1_of_pair_0(72), 1);
      if (not is_set(winnerswinner1_of_pair_0(75), 1)) and (not is_set(winnerswinner1_of_pair_0(74), 1)) then
        winnerswinner1_of_four_0_72_choices(2) := winnerswinner1_of_four_0_72_choice or
          winnerswinner1_of_four_0_72_value or winnerswinner1_of_four_0_72_values(2);
      else
        winnerswinner1_of_four_0_72_choices(2) := winnerswinner1_of_four_0_72_choice and
          (winnerswinner1_of_four_0_72_value or winnerswinner1_of_four_0_72_values(2));
      end if;
      winnerswinner1_of_four_0_72_values(3) := is_set(winnerswinner1_of_pair_0(75), 2);
      winnerswinner1_of_four_0_72_values(4) := is_set(winnerswinner1_of_pair_0(74), 2);
      if winnerswinner1_of_four_0_72_choices(2) then
        winnerswinner1_of_four_0_72_choices(3) := (not is_set(winnerswinner1_of_pair_0(73), 2)) and (not
          is_set(winnerswinner1_of_pair_0(72), 2)) and (winnerswinner1_of_four_0_72_values(3) or
          winnerswinner1_of_four_0_72_values(4));
      else
        winnerswinner1_of_four_0_72_choices(3) := ((not is_set(winnerswinner1_of_pair_0(73), 2)) and (not
          is_set(winnerswinner1_of_pair_0(72), 2))) or winnerswinner1_of_four_0_72_values(3) or
          winnerswinner1_of_four_0_72_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_72_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(75), i);
        winnerswinner1_of_four_0_72_values(2 * i) := is_set(winnerswinner1_of_pair_0(74), i);
        if winnerswinner1_of_four_0_72_choices(i) then
          winnerswinner1_of_four_0_72_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(73), i)) and (not
            is_set(winnerswinner1_of_pair_0(72), i))) or winnerswinner1_of_four_0_72_values(2 * i - 1) or
            winnerswinner1_of_four_0_72_values(2 * i);
        else
          winnerswinner1_of_four_0_72_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(73), i)) and (not
            is_set(winnerswinner1_of_pair_0(72), i)) and (winnerswinner1_of_four_0_72_values(2 * i - 1) or
            winnerswinner1_of_four_0_72_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_72_choices(6) then
        winnerswinner1_of_four_0_72_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(73), 6)) and (not
          is_set(winnerswinner1_of_pair_0(72), 6)))) and (not is_set(winnerswinner1_of_pair_0(75), 6)) and (not
          is_set(winnerswinner1_of_pair_0(74), 6));
      else
        winnerswinner1_of_four_0_72_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(73), 6)) and (not
          is_set(winnerswinner1_of_pair_0(72), 6)))) or ((not is_set(winnerswinner1_of_pair_0(75), 6)) and (not
          is_set(winnerswinner1_of_pair_0(74), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(77), 0) then
        winnerswinner1_of_four_0_76_choice := (not is_set(winnerswinner1_of_pair_0(79), 0)) and (not
          is_set(winnerswinner1_of_pair_0(78), 0));
      else
        winnerswinner1_of_four_0_76_choice := is_set(winnerswinner1_of_pair_0(76), 0) and (not
          is_set(winnerswinner1_of_pair_0(79), 0)) and (not is_set(winnerswinner1_of_pair_0(78), 0));
      end if;
      winnerswinner1_of_four_0_76_value := is_set(winnerswinner1_of_pair_0(77), 1);
      winnerswinner1_of_four_0_76_values(2) := is_set(winnerswinner1_of_pair_0(76), 1);
      if (not is_set(winnerswinner1_of_pair_0(79), 1)) and (not is_set(winnerswinner1_of_pair_0(78), 1)) then
        winnerswinner1_of_four_0_76_choices(2) := winnerswinner1_of_four_0_76_choice or
          winnerswinner1_of_four_0_76_value or winnerswinner1_of_four_0_76_values(2);
      else
        winnerswinner1_of_four_0_76_choices(2) := winnerswinner1_of_four_0_76_choice and
          (winnerswinner1_of_four_0_76_value or winnerswinner1_of_four_0_76_values(2));
      end if;
      winnerswinner1_of_four_0_76_values(3) := is_set(winnerswinner1_of_pair_0(79), 2);
      winnerswinner1_of_four_0_76_values(4) := is_set(winnerswinner1_of_pair_0(78), 2);
      if winnerswinner1_of_four_0_76_choices(2) then
        winnerswinner1_of_four_0_76_choices(3) := (not is_set(winnerswinner1_of_pair_0(77), 2)) and (not
          is_set(winnerswinner1_of_pair_0(76), 2)) and (winnerswinner1_of_four_0_76_values(3) or
          winnerswinner1_of_four_0_76_values(4));
      else
        winnerswinner1_of_four_0_76_choices(3) := ((not is_set(winnerswinner1_of_pair_0(77), 2)) and (not
          is_set(winnerswinner1_of_pair_0(76), 2))) or winnerswinner1_of_four_0_76_values(3) or
          winnerswinner1_of_four_0_76_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_76_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(79), i);
        winnerswinner1_of_four_0_76_values(2 * i) := is_set(winnerswinner1_of_pair_0(78), i);
        if winnerswinner1_of_four_0_76_choices(i) then
          winnerswinner1_of_four_0_76_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(77), i)) and (not
            is_set(winnerswinner1_of_pair_0(76), i))) or winnerswinner1_of_four_0_76_values(2 * i - 1) or
            winnerswinner1_of_four_0_76_values(2 * i);
        else
          winnerswinner1_of_four_0_76_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(77), i)) and (not
            is_set(winnerswinner1_of_pair_0(76), i)) and (winnerswinner1_of_four_0_76_values(2 * i - 1) or
            winnerswinner1_of_four_0_76_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_76_choices(6) then
        winnerswinner1_of_four_0_76_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(77), 6)) and (not
          is_set(winnerswinner1_of_pair_0(76), 6)))) and (not is_set(winnerswinner1_of_pair_0(79), 6)) and (not
          is_set(winnerswinner1_of_pair_0(78), 6));
      else
        winnerswinner1_of_four_0_76_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(77), 6)) and (not
          is_set(winnerswinner1_of_pair_0(76), 6)))) or ((not is_set(winnerswinner1_of_pair_0(79), 6)) and (not
          is_set(winnerswinner1_of_pair_0(78), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(81), 0) then
        winnerswinner1_of_four_0_80_choice := (not is_set(winnerswinner1_of_pair_0(83), 0)) and (not
          is_set(winnerswinner1_of_pair_0(82), 0));
      else
        winnerswinner1_of_four_0_80_choice := is_set(winnerswinner1_of_pair_0(80), 0) and (not
          is_set(winnerswinner1_of_pair_0(83), 0)) and (not is_set(winnerswinner1_of_pair_0(82), 0));
      end if;
      winnerswinner1_of_four_0_80_value := is_set(winnerswinner1_of_pair_0(81), 1);
      winnerswinner1_of_four_0_80_values(2) := is_set(winnerswinner1_of_pair_0(80), 1);
      if (not is_set(winnerswinner1_of_pair_0(83), 1)) and (not is_set(winnerswinner1_of_pair_0(82), 1)) then
        winnerswinner1_of_four_0_80_choices(2) := winnerswinner1_of_four_0_80_choice or
          winnerswinner1_of_four_0_80_value or winnerswinner1_of_four_0_80_values(2);
      else
        winnerswinner1_of_four_0_80_choices(2) := winnerswinner1_of_four_0_80_choice and
          (winnerswinner1_of_four_0_80_value or winnerswinner1_of_four_0_80_values(2));
      end if;
      winnerswinner1_of_four_0_80_values(3) := is_set(winnerswinner1_of_pair_0(83), 2);
      winnerswinner1_of_four_0_80_values(4) := is_set(winnerswinner1_of_pair_0(82), 2);
      if winnerswinner1_of_four_0_80_choices(2) then
        winnerswinner1_of_four_0_80_choices(3) := (not is_set(winnerswinner1_of_pair_0(81), 2)) and (not
          is_set(winnerswinner1_of_pair_0(80), 2)) and (winnerswinner1_of_four_0_80_values(3) or
          winnerswinner1_of_four_0_80_values(4));
      else
        winnerswinner1_of_four_0_80_choices(3) := ((not is_set(winnerswinner1_of_pair_0(81), 2)) and (not
          is_set(winnerswinner1_of_pair_0(80), 2))) or winnerswinner1_of_four_0_80_values(3) or
          winnerswinner1_of_four_0_80_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_80_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(83), i);
        winnerswinner1_of_four_0_80_values(2 * i) := is_set(winnerswinner1_of_pair_0(82), i);
        if winnerswinner1_of_four_0_80_choices(i) then
          winnerswinner1_of_four_0_80_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(81), i)) and (not
            is_set(winnerswinner1_of_pair_0(80), i))) or winnerswinner1_of_four_0_80_values(2 * i - 1) or
            winnerswinner1_of_four_0_80_values(2 * i);
        else
          winnerswinner1_of_four_0_80_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(81), i)) and (not
            is_set(winnerswinner1_of_pair_0(80), i)) and (winnerswinner1_of_four_0_80_values(2 * i - 1) or
            winnerswinner1_of_four_0_80_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_80_choices(6) then
        winnerswinner1_of_four_0_80_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(81), 6)) and (not
          is_set(winnerswinner1_of_pair_0(80), 6)))) and (not is_set(winnerswinner1_of_pair_0(83), 6)) and (not
          is_set(winnerswinner1_of_pair_0(82), 6));
      else
        winnerswinner1_of_four_0_80_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(81), 6)) and (not
          is_set(winnerswinner1_of_pair_0(80), 6)))) or ((not is_set(winnerswinner1_of_pair_0(83), 6)) and (not
          is_set(winnerswinner1_of_pair_0(82), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(85), 0) then
        winnerswinner1_of_four_0_84_choice := (not is_set(winnerswinner1_of_pair_0(87), 0)) and (not
          is_set(winnerswinner1_of_pair_0(86), 0));
      else
        winnerswinner1_of_four_0_84_choice := is_set(winnerswinner1_of_pair_0(84), 0) and (not
          is_set(winnerswinner1_of_pair_0(87), 0)) and (not is_set(winnerswinner1_of_pair_0(86), 0));
      end if;
      winnerswinner1_of_four_0_84_value := is_set(winnerswinner1_of_pair_0(85), 1);
      winnerswinner1_of_four_0_84_values(2) := is_set(winnerswinner1_of_pair_0(84), 1);
      if (not is_set(winnerswinner1_of_pair_0(87), 1)) and (not is_set(winnerswinner1_of_pair_0(86), 1)) then
        winnerswinner1_of_four_0_84_choices(2) := winnerswinner1_of_four_0_84_choice or
          winnerswinner1_of_four_0_84_value or winnerswinner1_of_four_0_84_values(2);
      else
        winnerswinner1_of_four_0_84_choices(2) := winnerswinner1_of_four_0_84_choice and
          (winnerswinner1_of_four_0_84_value or winnerswinner1_of_four_0_84_values(2));
      end if;
      winnerswinner1_of_four_0_84_values(3) := is_set(winnerswinner1_of_pair_0(87), 2);
      winnerswinner1_of_four_0_84_values(4) := is_set(winnerswinner1_of_pair_0(86), 2);
      if winnerswinner1_of_four_0_84_choices(2) then
        winnerswinner1_of_four_0_84_choices(3) := (not is_set(winnerswinner1_of_pair_0(85), 2)) and (not
          is_set(winnerswinner1_of_pair_0(84), 2)) and (winnerswinner1_of_four_0_84_values(3) or
          winnerswinner1_of_four_0_84_values(4));
      else
        winnerswinner1_of_four_0_84_choices(3) := ((not is_set(winnerswinner1_of_pair_0(85), 2)) and (not
          is_set(winnerswinner1_of_pair_0(84), 2))) or winnerswinner1_of_four_0_84_values(3) or
          winnerswinner1_of_four_0_84_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_84_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(87), i);
        winnerswinner1_of_four_0_84_values(2 * i) := is_set(winnerswinner1_of_pair_0(86), i);
        if winnerswinner1_of_four_0_84_choices(i) then
          winnerswinner1_of_four_0_84_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(85), i)) and (not
            is_set(winnerswinner1_of_pair_0(84), i))) or winnerswinner1_of_four_0_84_values(2 * i - 1) or
            winnerswinner1_of_four_0_84_values(2 * i);
        else
          winnerswinner1_of_four_0_84_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(85), i)) and (not
            is_set(winnerswinner1_of_pair_0(84), i)) and (winnerswinner1_of_four_0_84_values(2 * i - 1) or
            winnerswinner1_of_four_0_84_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_84_choices(6) then
        winnerswinner1_of_four_0_84_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(85), 6)) and (not
          is_set(winnerswinner1_of_pair_0(84), 6)))) and (not is_set(winnerswinner1_of_pair_0(87), 6)) and (not
          is_set(winnerswinner1_of_pair_0(86), 6));
      else
        winnerswinner1_of_four_0_84_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(85), 6)) and (not
          is_set(winnerswinner1_of_pair_0(84), 6)))) or ((not is_set(winnerswinner1_of_pair_0(87), 6)) and (not
          is_set(winnerswinner1_of_pair_0(86), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(89), 0) then
        winnerswinner1_of_four_0_88_choice := (not is_set(winnerswinner1_of_pair_0(91), 0)) and (not
          is_set(winnerswinner1_of_pair_0(90), 0));
      else
        winnerswinner1_of_four_0_88_choice := is_set(winnerswinner1_of_pair_0(88), 0) and (not
          is_set(winnerswinner1_of_pair_0(91), 0)) and (not is_set(winnerswinner1_of_pair_0(90), 0));
      end if;
      winnerswinner1_of_four_0_88_value := is_set(winnerswinner1_of_pair_0(89), 1);
      winnerswinner1_of_four_0_88_values(2) := is_set(winnerswinner1_of_pair_0(88), 1);
      if (not is_set(winnerswinner1_of_pair_0(91), 1)) and (not is_set(winnerswinner1_of_pair_0(90), 1)) then
        winnerswinner1_of_four_0_88_choices(2) := winnerswinner1_of_four_0_88_choice or
          winnerswinner1_of_four_0_88_value or winnerswinner1_of_four_0_88_values(2);
      else
        winnerswinner1_of_four_0_88_choices(2) := winnerswinner1_of_four_0_88_choice and
          (winnerswinner1_of_four_0_88_value or winnerswinner1_of_four_0_88_values(2));
      end if;
      winnerswinner1_of_four_0_88_values(3) := is_set(winnerswinner1_of_pair_0(91), 2);
      winnerswinner1_of_four_0_88_values(4) := is_set(winnerswinner1_of_pair_0(90), 2);
      if winnerswinner1_of_four_0_88_choices(2) then
        winnerswinner1_of_four_0_88_choices(3) := (not is_set(winnerswinner1_of_pair_0(89), 2)) and (not
          is_set(winnerswinner1_of_pair_0(88), 2)) and (winnerswinner1_of_four_0_88_values(3) or
          winnerswinner1_of_four_0_88_values(4));
      else
        winnerswinner1_of_four_0_88_choices(3) := ((not is_set(winnerswinner1_of_pair_0(89), 2)) and (not
          is_set(winnerswinner1_of_pair_0(88), 2))) or winnerswinner1_of_four_0_88_values(3) or
          winnerswinner1_of_four_0_88_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_88_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(91), i);
        winnerswinner1_of_four_0_88_values(2 * i) := is_set(winnerswinner1_of_pair_0(90), i);
        if winnerswinner1_of_four_0_88_choices(i) then
          winnerswinner1_of_four_0_88_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(89), i)) and (not
            is_set(winnerswinner1_of_pair_0(88), i))) or winnerswinner1_of_four_0_88_values(2 * i - 1) or
            winnerswinner1_of_four_0_88_values(2 * i);
        else
          winnerswinner1_of_four_0_88_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(89), i)) and (not
            is_set(winnerswinner1_of_pair_0(88), i)) and (winnerswinner1_of_four_0_88_values(2 * i - 1) or
            winnerswinner1_of_four_0_88_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_88_choices(6) then
        winnerswinner1_of_four_0_88_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(89), 6)) and (not
          is_set(winnerswinner1_of_pair_0(88), 6)))) and (not is_set(winnerswinner1_of_pair_0(91), 6)) and (not
          is_set(winnerswinner1_of_pair_0(90), 6));
      else
        winnerswinner1_of_four_0_88_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(89), 6)) and (not
          is_set(winnerswinner1_of_pair_0(88), 6)))) or ((not is_set(winnerswinner1_of_pair_0(91), 6)) and (not
          is_set(winnerswinner1_of_pair_0(90), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(93), 0) then
        winnerswinner1_of_four_0_92_choice := (not is_set(winnerswinner1_of_pair_0(95), 0)) and (not
          is_set(winnerswinner1_of_pair_0(94), 0));
      else
        winnerswinner1_of_four_0_92_choice := is_set(winnerswinner1_of_pair_0(92), 0) and (not
          is_set(winnerswinner1_of_pair_0(95), 0)) and (not is_set(winnerswinner1_of_pair_0(94), 0));
      end if;
      winnerswinner1_of_four_0_92_value := is_set(winnerswinner1_of_pair_0(93), 1);
      winnerswinner1_of_four_0_92_values(2) := is_set(winnerswinner1_of_pair_0(92), 1);
      if (not is_set(winnerswinner1_of_pair_0(95), 1)) and (not is_set(winnerswinner1_of_pair_0(94), 1)) then
        winnerswinner1_of_four_0_92_choices(2) := winnerswinner1_of_four_0_92_choice or
          winnerswinner1_of_four_0_92_value or winnerswinner1_of_four_0_92_values(2);
      else
        winnerswinner1_of_four_0_92_choices(2) := winnerswinner1_of_four_0_92_choice and
          (winnerswinner1_of_four_0_92_value or winnerswinner1_of_four_0_92_values(2));
      end if;
      winnerswinner1_of_four_0_92_values(3) := is_set(winnerswinner1_of_pair_0(95), 2);
      winnerswinner1_of_four_0_92_values(4) := is_set(winnerswinner1_of_pair_0(94), 2);
      if winnerswinner1_of_four_0_92_choices(2) then
        winnerswinner1_of_four_0_92_choices(3) := (not is_set(winnerswinner1_of_pair_0(93), 2)) and (not
          is_set(winnerswinner1_of_pair_0(92), 2)) and (winnerswinner1_of_four_0_92_values(3) or
          winnerswinner1_of_four_0_92_values(4));
      else
        winnerswinner1_of_four_0_92_choices(3) := ((not is_set(winnerswinner1_of_pair_0(93), 2)) and (not
          is_set(winnerswinner1_of_pair_0(92), 2))) or winnerswinner1_of_four_0_92_values(3) or
          winnerswinner1_of_four_0_92_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_92_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(95), i);
        winnerswinner1_of_four_0_92_values(2 * i) := is_set(winnerswinner1_of_pair_0(94), i);
        if winnerswinner1_of_four_0_92_choices(i) then
          winnerswinner1_of_four_0_92_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(93), i)) and (not
            is_set(winnerswinner1_of_pair_0(92), i))) or winnerswinner1_of_four_0_92_values(2 * i - 1) or
            winnerswinner1_of_four_0_92_values(2 * i);
        else
          winnerswinner1_of_four_0_92_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(93), i)) and (not
            is_set(winnerswinner1_of_pair_0(92), i)) and (winnerswinner1_of_four_0_92_values(2 * i - 1) or
            winnerswinner1_of_four_0_92_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_92_choices(6) then
        winnerswinner1_of_four_0_92_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(93), 6)) and (not
          is_set(winnerswinner1_of_pair_0(92), 6)))) and (not is_set(winnerswinner1_of_pair_0(95), 6)) and (not
          is_set(winnerswinner1_of_pair_0(94), 6));
      else
        winnerswinner1_of_four_0_92_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(93), 6)) and (not
          is_set(winnerswinner1_of_pair_0(92), 6)))) or ((not is_set(winnerswinner1_of_pair_0(95), 6)) and (not
          is_set(winnerswinner1_of_pair_0(94), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(97), 0) then
        winnerswinner1_of_four_0_96_choice := (not is_set(winnerswinner1_of_pair_0(99), 0)) and (not
          is_set(winnerswinner1_of_pair_0(98), 0));
      else
        winnerswinner1_of_four_0_96_choice := is_set(winnerswinner1_of_pair_0(96), 0) and (not
          is_set(winnerswinner1_of_pair_0(99), 0)) and (not is_set(winnerswinner1_of_pair_0(98), 0));
      end if;
      winnerswinner1_of_four_0_96_value := is_set(winnerswinner1_of_pair_0(97), 1);
      winnerswinner1_of_four_0_96_values(2) := is_set(winnerswinner1_of_pair_0(96), 1);
      if (not is_set(winnerswinner1_of_pair_0(99), 1)) and (not is_set(winnerswinner1_of_pair_0(98), 1)) then
        winnerswinner1_of_four_0_96_choices(2) := winnerswinner1_of_four_0_96_choice or
          winnerswinner1_of_four_0_96_value or winnerswinner1_of_four_0_96_values(2);
      else
        winnerswinner1_of_four_0_96_choices(2) := winnerswinner1_of_four_0_96_choice and
          (winnerswinner1_of_four_0_96_value or winnerswinner1_of_four_0_96_values(2));
      end if;
      winnerswinner1_of_four_0_96_values(3) := is_set(winnerswinner1_of_pair_0(99), 2);
      winnerswinner1_of_four_0_96_values(4) := is_set(winnerswinner1_of_pair_0(98), 2);
      if winnerswinner1_of_four_0_96_choices(2) then
        winnerswinner1_of_four_0_96_choices(3) := (not is_set(winnerswinner1_of_pair_0(97), 2)) and (not
          is_set(winnerswinner1_of_pair_0(96), 2)) and (winnerswinner1_of_four_0_96_values(3) or
          winnerswinner1_of_four_0_96_values(4));
      else
        winnerswinner1_of_four_0_96_choices(3) := ((not is_set(winnerswinner1_of_pair_0(97), 2)) and (not
          is_set(winnerswinner1_of_pair_0(96), 2))) or winnerswinner1_of_four_0_96_values(3) or
          winnerswinner1_of_four_0_96_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_96_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(99), i);
        winnerswinner1_of_four_0_96_values(2 * i) := is_set(winnerswinner1_of_pair_0(98), i);
        if winnerswinner1_of_four_0_96_choices(i) then
          winnerswinner1_of_four_0_96_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(97), i)) and (not
            is_set(winnerswinner1_of_pair_0(96), i))) or winnerswinner1_of_four_0_96_values(2 * i - 1) or
            winnerswinner1_of_four_0_96_values(2 * i);
        else
          winnerswinner1_of_four_0_96_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(97), i)) and (not
            is_set(winnerswinner1_of_pair_0(96), i)) and (winnerswinner1_of_four_0_96_values(2 * i - 1) or
            winnerswinner1_of_four_0_96_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_96_choices(6) then
        winnerswinner1_of_four_0_96_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(97), 6)) and (not
          is_set(winnerswinner1_of_pair_0(96), 6)))) and (not is_set(winnerswinner1_of_pair_0(99), 6)) and (not
          is_set(winnerswinner1_of_pair_0(98), 6));
      else
        winnerswinner1_of_four_0_96_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(97), 6)) and (not
          is_set(winnerswinner1_of_pair_0(96), 6)))) or ((not is_set(winnerswinner1_of_pair_0(99), 6)) and (not
          is_set(winnerswinner1_of_pair_0(98), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(101), 0) then
        winnerswinner1_of_four_0_100_choice := (not is_set(winnerswinner1_of_pair_0(103), 0)) and (not
          is_set(winnerswinner1_of_pair_0(102), 0));
      else
        winnerswinner1_of_four_0_100_choice := is_set(winnerswinner1_of_pair_0(100), 0) and (not
          is_set(winnerswinner1_of_pair_0(103), 0)) and (not is_set(winnerswinner1_of_pair_0(102), 0));
      end if;
      winnerswinner1_of_four_0_100_value := is_set(winnerswinner1_of_pair_0(101), 1);
      winnerswinner1_of_four_0_100_values(2) := is_set(winnerswinner1_of_pair_0(100), 1);
      if (not is_set(winnerswinner1_of_pair_0(103), 1)) and (not is_set(winnerswinner1_of_pair_0(102), 1)) then
        winnerswinner1_of_four_0_100_choices(2) := winnerswinner1_of_four_0_100_choice or
          winnerswinner1_of_four_0_100_value or winnerswinner1_of_four_0_100_values(2);
      else
        winnerswinner1_of_four_0_100_choices(2) := winnerswinner1_of_four_0_100_choice and
          (winnerswinner1_of_four_0_100_value or winnerswinner1_of_four_0_100_values(2));
      end if;
      winnerswinner1_of_four_0_100_values(3) := is_set(winnerswinner1_of_pair_0(103), 2);
      winnerswinner1_of_four_0_100_values(4) := is_set(winnerswinner1_of_pair_0(102), 2);
      if winnerswinner1_of_four_0_100_choices(2) then
        winnerswinner1_of_four_0_100_choices(3) := (not is_set(winnerswinner1_of_pair_0(101), 2)) and (not
          is_set(winnerswinner1_of_pair_0(100), 2)) and (winnerswinner1_of_four_0_100_values(3) or
          winnerswinner1_of_four_0_100_values(4));
      else
        winnerswinner1_of_four_0_100_choices(3) := ((not is_set(winnerswinner1_of_pair_0(101), 2)) and (not
          is_set(winnerswinner1_of_pair_0(100), 2))) or winnerswinner1_of_four_0_100_values(3) or
          winnerswinner1_of_four_0_100_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_100_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(103), i);
        winnerswinner1_of_four_0_100_values(2 * i) := is_set(winnerswinner1_of_pair_0(102), i);
        if winnerswinner1_of_four_0_100_choices(i) then
          winnerswinner1_of_four_0_100_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(101), i)) and (not
            is_set(winnerswinner1_of_pair_0(100), i))) or winnerswinner1_of_four_0_100_values(2 * i - 1) or
            winnerswinner1_of_four_0_100_values(2 * i);
        else
          winnerswinner1_of_four_0_100_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(101), i)) and (not
            is_set(winnerswinner1_of_pair_0(100), i)) and (winnerswinner1_of_four_0_100_values(2 * i - 1) or
            winnerswinner1_of_four_0_100_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_100_choices(6) then
        winnerswinner1_of_four_0_100_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(101), 6)) and (not
          is_set(winnerswinner1_of_pair_0(100), 6)))) and (not is_set(winnerswinner1_of_pair_0(103), 6)) and (not
          is_set(winnerswinner1_of_pair_0(102), 6));
      else
        winnerswinner1_of_four_0_100_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(101), 6)) and (not
          is_set(winnerswinner1_of_pair_0(100), 6)))) or ((not is_set(winnerswinner1_of_pair_0(103), 6)) and (not
          is_set(winnerswinner1_of_pair_0(102), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(105), 0) then
        winnerswinner1_of_four_0_104_choice := (not is_set(winnerswinner1_of_pair_0(107), 0)) and (not
          is_set(winnerswinner1_of_pair_0(106), 0));
      else
        winnerswinner1_of_four_0_104_choice := is_set(winnerswinner1_of_pair_0(104), 0) and (not
          is_set(winnerswinner1_of_pair_0(107), 0)) and (not is_set(winnerswinner1_of_pair_0(106), 0));
      end if;
      winnerswinner1_of_four_0_104_value := is_set(winnerswinner1_of_pair_0(105), 1);
      winnerswinner1_of_four_0_104_values(2) := is_set(winnerswinner1_of_pair_0(104), 1);
      if (not is_set(winnerswinner1_of_pair_0(107), 1)) and (not is_set(winnerswinner1_of_pair_0(106), 1)) then
        winnerswinner1_of_four_0_104_choices(2) := winnerswinner1_of_four_0_104_choice or
          winnerswinner1_of_four_0_104_value or winnerswinner1_of_four_0_104_values(2);
      else
        winnerswinner1_of_four_0_104_choices(2) := winnerswinner1_of_four_0_104_choice and
          (winnerswinner1_of_four_0_104_value or winnerswinner1_of_four_0_104_values(2));
      end if;
      winnerswinner1_of_four_0_104_values(3) := is_set(winnerswinner1_of_pair_0(107), 2);
      winnerswinner1_of_four_0_104_values(4) := is_set(winnerswinner1_of_pair_0(106), 2);
      if winnerswinner1_of_four_0_104_choices(2) then
        winnerswinner1_of_four_0_104_choices(3) := (not is_set(winnerswinner1_of_pair_0(105), 2)) and (not
          is_set(winnerswinner1_of_pair_0(104), 2)) and (winnerswinner1_of_four_0_104_values(3) or
          winnerswinner1_of_four_0_104_values(4));
      else
        winnerswinner1_of_four_0_104_choices(3) := ((not is_set(winnerswinner1_of_pair_0(105), 2)) and (not
          is_set(winnerswinner1_of_pair_0(104), 2))) or winnerswinner1_of_four_0_104_values(3) or
          winnerswinner1_of_four_0_104_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_104_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(107), i);
        winnerswinner1_of_four_0_104_values(2 * i) := is_set(winnerswinner1_of_pair_0(106), i);
        if winnerswinner1_of_four_0_104_choices(i) then
          winnerswinner1_of_four_0_104_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(105), i)) and (not
            is_set(winnerswinner1_of_pair_0(104), i))) or winnerswinner1_of_four_0_104_values(2 * i - 1) or
            winnerswinner1_of_four_0_104_values(2 * i);
        else
          winnerswinner1_of_four_0_104_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(105), i)) and (not
            is_set(winnerswinner1_of_pair_0(104), i)) and (winnerswinner1_of_four_0_104_values(2 * i - 1) or
            winnerswinner1_of_four_0_104_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_104_choices(6) then
        winnerswinner1_of_four_0_104_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(105), 6)) and (not
          is_set(winnerswinner1_of_pair_0(104), 6)))) and (not is_set(winnerswinner1_of_pair_0(107), 6)) and (not
          is_set(winnerswinner1_of_pair_0(106), 6));
      else
        winnerswinner1_of_four_0_104_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(105), 6)) and (not
          is_set(winnerswinner1_of_pair_0(104), 6)))) or ((not is_set(winnerswinner1_of_pair_0(107), 6)) and (not
          is_set(winnerswinner1_of_pair_0(106), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(109), 0) then
        winnerswinner1_of_four_0_108_choice := (not is_set(winnerswinner1_of_pair_0(111), 0)) and (not
          is_set(winnerswinner1_of_pair_0(110), 0));
      else
        winnerswinner1_of_four_0_108_choice := is_set(winnerswinner1_of_pair_0(108), 0) and (not
          is_set(winnerswinner1_of_pair_0(111), 0)) and (not is_set(winnerswinner1_of_pair_0(110), 0));
      end if;
      winnerswinner1_of_four_0_108_value := is_set(winnerswinner1_of_pair_0(109), 1);
      winnerswinner1_of_four_0_108_values(2) := is_set(winnerswinner1_of_pair_0(108), 1);
      if (not is_set(winnerswinner1_of_pair_0(111), 1)) and (not is_set(winnerswinner1_of_pair_0(110), 1)) then
        winnerswinner1_of_four_0_108_choices(2) := winnerswinner1_of_four_0_108_choice or
          winnerswinner1_of_four_0_108_value or winnerswinner1_of_four_0_108_values(2);
      else
        winnerswinner1_of_four_0_108_choices(2) := winnerswinner1_of_four_0_108_choice and
          (winnerswinner1_of_four_0_108_value or winnerswinner1_of_four_0_108_values(2));
      end if;
      winnerswinner1_of_four_0_108_values(3) := is_set(winnerswinner1_of_pair_0(111), 2);
      winnerswinner1_of_four_0_108_values(4) := is_set(winnerswinner1_of_pair_0(110), 2);
      if winnerswinner1_of_four_0_108_choices(2) then
        winnerswinner1_of_four_0_108_choices(3) := (not is_set(winnerswinner1_of_pair_0(109), 2)) and (not
          is_set(winnerswinner1_of_pair_0(108), 2)) and (winnerswinner1_of_four_0_108_values(3) or
          winnerswinner1_of_four_0_108_values(4));
      else
        winnerswinner1_of_four_0_108_choices(3) := ((not is_set(winnerswinner1_of_pair_0(109), 2)) and (not
          is_set(winnerswinner1_of_pair_0(108), 2))) or winnerswinner1_of_four_0_108_values(3) or
          winnerswinner1_of_four_0_108_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_108_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(111), i);
        winnerswinner1_of_four_0_108_values(2 * i) := is_set(winnerswinner1_of_pair_0(110), i);
        if winnerswinner1_of_four_0_108_choices(i) then
          winnerswinner1_of_four_0_108_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(109), i)) and (not
            is_set(winnerswinner1_of_pair_0(108), i))) or winnerswinner1_of_four_0_108_values(2 * i - 1) or
            winnerswinner1_of_four_0_108_values(2 * i);
        else
          winnerswinner1_of_four_0_108_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(109), i)) and (not
            is_set(winnerswinner1_of_pair_0(108), i)) and (winnerswinner1_of_four_0_108_values(2 * i - 1) or
            winnerswinner1_of_four_0_108_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_108_choices(6) then
        winnerswinner1_of_four_0_108_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(109), 6)) and (not
          is_set(winnerswinner1_of_pair_0(108), 6)))) and (not is_set(winnerswinner1_of_pair_0(111), 6)) and (not
          is_set(winnerswinner1_of_pair_0(110), 6));
      else
        winnerswinner1_of_four_0_108_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(109), 6)) and (not
          is_set(winnerswinner1_of_pair_0(108), 6)))) or ((not is_set(winnerswinner1_of_pair_0(111), 6)) and (not
          is_set(winnerswinner1_of_pair_0(110), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(113), 0) then
        winnerswinner1_of_four_0_112_choice := (not is_set(winnerswinner1_of_pair_0(115), 0)) and (not
          is_set(winnerswinner1_of_pair_0(114), 0));
      else
        winnerswinner1_of_four_0_112_choice := is_set(winnerswinner1_of_pair_0(112), 0) and (not
          is_set(winnerswinner1_of_pair_0(115), 0)) and (not is_set(winnerswinner1_of_pair_0(114), 0));
      end if;
      winnerswinner1_of_four_0_112_value := is_set(winnerswinner1_of_pair_0(113), 1);
      winnerswinner1_of_four_0_112_values(2) := is_set(winnerswinner1_of_pair_0(112), 1);
      if (not is_set(winnerswinner1_of_pair_0(115), 1)) and (not is_set(winnerswinner1_of_pair_0(114), 1)) then
        winnerswinner1_of_four_0_112_choices(2) := winnerswinner1_of_four_0_112_choice or
          winnerswinner1_of_four_0_112_value or winnerswinner1_of_four_0_112_values(2);
      else
        winnerswinner1_of_four_0_112_choices(2) := winnerswinner1_of_four_0_112_choice and
          (winnerswinner1_of_four_0_112_value or winnerswinner1_of_four_0_112_values(2));
      end if;
      winnerswinner1_of_four_0_112_values(3) := is_set(winnerswinner1_of_pair_0(115), 2);
      winnerswinner1_of_four_0_112_values(4) := is_set(winnerswinner1_of_pair_0(114), 2);
      if winnerswinner1_of_four_0_112_choices(2) then
        winnerswinner1_of_four_0_112_choices(3) := (not is_set(winnerswinner1_of_pair_0(113), 2)) and (not
          is_set(winnerswinner1_of_pair_0(112), 2)) and (winnerswinner1_of_four_0_112_values(3) or
          winnerswinner1_of_four_0_112_values(4));
      else
        winnerswinner1_of_four_0_112_choices(3) := ((not is_set(winnerswinner1_of_pair_0(113), 2)) and (not
          is_set(winnerswinner1_of_pair_0(112), 2))) or winnerswinner1_of_four_0_112_values(3) or
          winnerswinner1_of_four_0_112_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_112_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(115), i);
        winnerswinner1_of_four_0_112_values(2 * i) := is_set(winnerswinner1_of_pair_0(114), i);
        if winnerswinner1_of_four_0_112_choices(i) then
          winnerswinner1_of_four_0_112_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(113), i)) and (not
            is_set(winnerswinner1_of_pair_0(112), i))) or winnerswinner1_of_four_0_112_values(2 * i - 1) or
            winnerswinner1_of_four_0_112_values(2 * i);
        else
          winnerswinner1_of_four_0_112_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(113), i)) and (not
            is_set(winnerswinner1_of_pair_0(112), i)) and (winnerswinner1_of_four_0_112_values(2 * i - 1) or
            winnerswinner1_of_four_0_112_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_112_choices(6) then
        winnerswinner1_of_four_0_112_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(113), 6)) and (not
          is_set(winnerswinner1_of_pair_0(112), 6)))) and (not is_set(winnerswinner1_of_pair_0(115), 6)) and (not
          is_set(winnerswinner1_of_pair_0(114), 6));
      else
        winnerswinner1_of_four_0_112_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(113), 6)) and (not
          is_set(winnerswinner1_of_pair_0(112), 6)))) or ((not is_set(winnerswinner1_of_pair_0(115), 6)) and (not
          is_set(winnerswinner1_of_pair_0(114), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(117), 0) then
        winnerswinner1_of_four_0_116_choice := (not is_set(winnerswinner1_of_pair_0(119), 0)) and (not
          is_set(winnerswinner1_of_pair_0(118), 0));
      else
        winnerswinner1_of_four_0_116_choice := is_set(winnerswinner1_of_pair_0(116), 0) and (not
          is_set(winnerswinner1_of_pair_0(119), 0)) and (not is_set(winnerswinner1_of_pair_0(118), 0));
      end if;
      winnerswinner1_of_four_0_116_value := is_set(winnerswinner1_of_pair_0(117), 1);
      winnerswinner1_of_four_0_116_values(2) := is_set(winnerswinner1_of_pair_0(116), 1);
      if (not is_set(winnerswinner1_of_pair_0(119), 1)) and (not is_set(winnerswinner1_of_pair_0(118), 1)) then
        winnerswinner1_of_four_0_116_choices(2) := winnerswinner1_of_four_0_116_choice or
          winnerswinner1_of_four_0_116_value or winnerswinner1_of_four_0_116_values(2);
      else
        winnerswinner1_of_four_0_116_choices(2) := winnerswinner1_of_four_0_116_choice and
          (winnerswinner1_of_four_0_116_value or winnerswinner1_of_four_0_116_values(2));
      end if;
      winnerswinner1_of_four_0_116_values(3) := is_set(winnerswinner1_of_pair_0(119), 2);
      winnerswinner1_of_four_0_116_values(4) := is_set(winnerswinner1_of_pair_0(118), 2);
      if winnerswinner1_of_four_0_116_choices(2) then
        winnerswinner1_of_four_0_116_choices(3) := (not is_set(winnerswinner1_of_pair_0(117), 2)) and (not
          is_set(winnerswinner1_of_pair_0(116), 2)) and (winnerswinner1_of_four_0_116_values(3) or
          winnerswinner1_of_four_0_116_values(4));
      else
        winnerswinner1_of_four_0_116_choices(3) := ((not is_set(winnerswinner1_of_pair_0(117), 2)) and (not
          is_set(winnerswinner1_of_pair_0(116), 2))) or winnerswinner1_of_four_0_116_values(3) or
          winnerswinner1_of_four_0_116_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_116_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(119), i);
        winnerswinner1_of_four_0_116_values(2 * i) := is_set(winnerswinner1_of_pair_0(118), i);
        if winnerswinner1_of_four_0_116_choices(i) then
          winnerswinner1_of_four_0_116_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(117), i)) and (not
            is_set(winnerswinner1_of_pair_0(116), i))) or winnerswinner1_of_four_0_116_values(2 * i - 1) or
            winnerswinner1_of_four_0_116_values(2 * i);
        else
          winnerswinner1_of_four_0_116_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(117), i)) and (not
            is_set(winnerswinner1_of_pair_0(116), i)) and (winnerswinner1_of_four_0_116_values(2 * i - 1) or
            winnerswinner1_of_four_0_116_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_116_choices(6) then
        winnerswinner1_of_four_0_116_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(117), 6)) and (not
          is_set(winnerswinner1_of_pair_0(116), 6)))) and (not is_set(winnerswinner1_of_pair_0(119), 6)) and (not
          is_set(winnerswinner1_of_pair_0(118), 6));
      else
        winnerswinner1_of_four_0_116_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(117), 6)) and (not
          is_set(winnerswinner1_of_pair_0(116), 6)))) or ((not is_set(winnerswinner1_of_pair_0(119), 6)) and (not
          is_set(winnerswinner1_of_pair_0(118), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(121), 0) then
        winnerswinner1_of_four_0_120_choice := (not is_set(winnerswinner1_of_pair_0(123), 0)) and (not
          is_set(winnerswinner1_of_pair_0(122), 0));
      else
        winnerswinner1_of_four_0_120_choice := is_set(winnerswinner1_of_pair_0(120), 0) and (not
          is_set(winnerswinner1_of_pair_0(123), 0)) and (not is_set(winnerswinner1_of_pair_0(122), 0));
      end if;
      winnerswinner1_of_four_0_120_value := is_set(winnerswinner1_of_pair_0(121), 1);
      winnerswinner1_of_four_0_120_values(2) := is_set(winnerswinner1_of_pair_0(120), 1);
      if (not is_set(winnerswinner1_of_pair_0(123), 1)) and (not is_set(winnerswinner1_of_pair_0(122), 1)) then
        winnerswinner1_of_four_0_120_choices(2) := winnerswinner1_of_four_0_120_choice or
          winnerswinner1_of_four_0_120_value or winnerswinner1_of_four_0_120_values(2);
      else
        winnerswinner1_of_four_0_120_choices(2) := winnerswinner1_of_four_0_120_choice and
          (winnerswinner1_of_four_0_120_value or winnerswinner1_of_four_0_120_values(2));
      end if;
      winnerswinner1_of_four_0_120_values(3) := is_set(winnerswinner1_of_pair_0(123), 2);
      winnerswinner1_of_four_0_120_values(4) := is_set(winnerswinner1_of_pair_0(122), 2);
      if winnerswinner1_of_four_0_120_choices(2) then
        winnerswinner1_of_four_0_120_choices(3) := (not is_set(winnerswinner1_of_pair_0(121), 2)) and (not
          is_set(winnerswinner1_of_pair_0(120), 2)) and (winnerswinner1_of_four_0_120_values(3) or
          winnerswinner1_of_four_0_120_values(4));
      else
        winnerswinner1_of_four_0_120_choices(3) := ((not is_set(winnerswinner1_of_pair_0(121), 2)) and (not
          is_set(winnerswinner1_of_pair_0(120), 2))) or winnerswinner1_of_four_0_120_values(3) or
          winnerswinner1_of_four_0_120_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_120_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(123), i);
        winnerswinner1_of_four_0_120_values(2 * i) := is_set(winnerswinner1_of_pair_0(122), i);
        if winnerswinner1_of_four_0_120_choices(i) then
          winnerswinner1_of_four_0_120_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(121), i)) and (not
            is_set(winnerswinner1_of_pair_0(120), i))) or winnerswinner1_of_four_0_120_values(2 * i - 1) or
            winnerswinner1_of_four_0_120_values(2 * i);
        else
          winnerswinner1_of_four_0_120_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(121), i)) and (not
            is_set(winnerswinner1_of_pair_0(120), i)) and (winnerswinner1_of_four_0_120_values(2 * i - 1) or
            winnerswinner1_of_four_0_120_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_120_choices(6) then
        winnerswinner1_of_four_0_120_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(121), 6)) and (not
          is_set(winnerswinner1_of_pair_0(120), 6)))) and (not is_set(winnerswinner1_of_pair_0(123), 6)) and (not
          is_set(winnerswinner1_of_pair_0(122), 6));
      else
        winnerswinner1_of_four_0_120_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(121), 6)) and (not
          is_set(winnerswinner1_of_pair_0(120), 6)))) or ((not is_set(winnerswinner1_of_pair_0(123), 6)) and (not
          is_set(winnerswinner1_of_pair_0(122), 6)));
      end if;
      if is_set(winnerswinner1_of_pair_0(125), 0) then
        winnerswinner1_of_four_0_124_choice := (not is_set(winnerswinner1_of_pair_0(127), 0)) and (not
          is_set(winnerswinner1_of_pair_0(126), 0));
      else
        winnerswinner1_of_four_0_124_choice := is_set(winnerswinner1_of_pair_0(124), 0) and (not
          is_set(winnerswinner1_of_pair_0(127), 0)) and (not is_set(winnerswinner1_of_pair_0(126), 0));
      end if;
      winnerswinner1_of_four_0_124_value := is_set(winnerswinner1_of_pair_0(125), 1);
      winnerswinner1_of_four_0_124_values(2) := is_set(winnerswinner1_of_pair_0(124), 1);
      if (not is_set(winnerswinner1_of_pair_0(127), 1)) and (not is_set(winnerswinner1_of_pair_0(126), 1)) then
        winnerswinner1_of_four_0_124_choices(2) := winnerswinner1_of_four_0_124_choice or
          winnerswinner1_of_four_0_124_value or winnerswinner1_of_four_0_124_values(2);
      else
        winnerswinner1_of_four_0_124_choices(2) := winnerswinner1_of_four_0_124_choice and
          (winnerswinner1_of_four_0_124_value or winnerswinner1_of_four_0_124_values(2));
      end if;
      winnerswinner1_of_four_0_124_values(3) := is_set(winnerswinner1_of_pair_0(127), 2);
      winnerswinner1_of_four_0_124_values(4) := is_set(winnerswinner1_of_pair_0(126), 2);
      if winnerswinner1_of_four_0_124_choices(2) then
        winnerswinner1_of_four_0_124_choices(3) := (not is_set(winnerswinner1_of_pair_0(125), 2)) and (not
          is_set(winnerswinner1_of_pair_0(124), 2)) and (winnerswinner1_of_four_0_124_values(3) or
          winnerswinner1_of_four_0_124_values(4));
      else
        winnerswinner1_of_four_0_124_choices(3) := ((not is_set(winnerswinner1_of_pair_0(125), 2)) and (not
          is_set(winnerswinner1_of_pair_0(124), 2))) or winnerswinner1_of_four_0_124_values(3) or
          winnerswinner1_of_four_0_124_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner1_of_four_0_124_values(2 * i - 1) := is_set(winnerswinner1_of_pair_0(127), i);
        winnerswinner1_of_four_0_124_values(2 * i) := is_set(winnerswinner1_of_pair_0(126), i);
        if winnerswinner1_of_four_0_124_choices(i) then
          winnerswinner1_of_four_0_124_choices(i + 1) := ((not is_set(winnerswinner1_of_pair_0(125), i)) and (not
            is_set(winnerswinner1_of_pair_0(124), i))) or winnerswinner1_of_four_0_124_values(2 * i - 1) or
            winnerswinner1_of_four_0_124_values(2 * i);
        else
          winnerswinner1_of_four_0_124_choices(i + 1) := (not is_set(winnerswinner1_of_pair_0(125), i)) and (not
            is_set(winnerswinner1_of_pair_0(124), i)) and (winnerswinner1_of_four_0_124_values(2 * i - 1) or
            winnerswinner1_of_four_0_124_values(2 * i));
        end if;
      end loop;
      if winnerswinner1_of_four_0_124_choices(6) then
        winnerswinner1_of_four_0_124_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(125), 6)) and (not
          is_set(winnerswinner1_of_pair_0(124), 6)))) and (not is_set(winnerswinner1_of_pair_0(127), 6)) and (not
          is_set(winnerswinner1_of_pair_0(126), 6));
      else
        winnerswinner1_of_four_0_124_choices(7) := (not ((not is_set(winnerswinner1_of_pair_0(125), 6)) and (not
          is_set(winnerswinner1_of_pair_0(124), 6)))) or ((not is_set(winnerswinner1_of_pair_0(127), 6)) and (not
          is_set(winnerswinner1_of_pair_0(126), 6)));
      end if;
      winnerswinner1_pair_index_0_0 <= winnerswinner1_of_pair_0_0_choices(7);
      winnerswinner1_pair_tag_valid <= sums_tag_valid;
      winnerswinner1_pair_tag_map_column <= sums_tag_map_column;
      winnerswinner1_pair_tag_output_column <= sums_tag_output_column;
      winnerswinner1_pair_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_pair_tag_end_of_line <= sums_tag_end_of_line;
      winnerswinner1_four_tag_valid <= winnerswinner1_pair_tag_valid;
      winnerswinner1_four_tag_map_column <= winnerswinner1_pair_tag_map_column;
      winnerswinner1_four_tag_output_column <= winnerswinner1_pair_tag_output_column;
      winnerswinner1_four_tag_start_of_frame <= winnerswinner1_pair_tag_start_of_frame;
      winnerswinner1_four_tag_end_of_line <= winnerswinner1_pair_tag_end_of_line;
      for i in 0 to 31 loop
        winnerswinner1_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner1_of_four_0(4 * i + 2), 7)) or
          (to_unsigned(winnerswinner1_of_four_0(4 * i + 3), 7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i + 1),
          7)))) or (to_unsigned(winnerswinner1_of_four_0(4 * i), 7))));
      end loop;
      winnerswinner1_best_index_0_0 <= winnerswinner1_four_index_0_0;
      winnerswinner1_best_index_0_1 <= winnerswinner1_four_index_0_1;
      winnerswinner1_best_index_0_2 <= winnerswinner1_four_index_0_2;
      winnerswinner1_best_index_0_3 <= winnerswinner1_four_index_0_3;
      winnerswinner1_best_index_0_4 <= winnerswinner1_four_index_0_4;
      winnerswinner1_best_index_0_5 <= winnerswinner1_four_index_0_5;
      winnerswinner1_best_index_0_6 <= winnerswinner1_four_index_0_6;
      winnerswinner1_best_index_0_7 <= winnerswinner1_four_index_0_7;
      winnerswinner1_best_index_0_8 <= winnerswinner1_four_index_0_8;
      winnerswinner1_best_index_0_9 <= winnerswinner1_four_index_0_9;
      winnerswinner1_best_index_0_10 <= winnerswinner1_four_index_0_10;
      winnerswinner1_best_index_0_11 <= winnerswinner1_four_index_0_11;
      winnerswinner1_best_index_0_12 <= winnerswinner1_four_index_0_12;
      winnerswinner1_best_index_0_13 <= winnerswinner1_four_index_0_13;
      winnerswinner1_best_index_0_14 <= winnerswinner1_four_index_0_14;
      winnerswinner1_best_index_0_15 <= winnerswinner1_four_index_0_15;
      winnerswinner1_best_index_0_16 <= winnerswinner1_four_index_0_16;
      winnerswinner1_best_index_0_17 <= winnerswinner1_four_index_0_17;
      winnerswinner1_best_index_0_18 <= winnerswinner1_four_index_0_18;
      winnerswinner1_best_index_0_19 <= winnerswinner1_four_index_0_19;
      winnerswinner1_best_index_0_20 <= winnerswinner1_four_index_0_20;
      winnerswinner1_best_index_0_21 <= winnerswinner1_four_index_0_21;
      winnerswinner1_best_index_0_22 <= winnerswinner1_four_index_0_22;
      winnerswinner1_best_index_0_23 <= winnerswinner1_four_index_0_23;
      winnerswinner1_best_index_0_24 <= winnerswinner1_four_index_0_24;
      winnerswinner1_best_index_0_25 <= winnerswinner1_four_index_0_25;
      winnerswinner1_best_index_0_26 <= winnerswinner1_four_index_0_26;
      winnerswinner1_best_index_0_27 <= winnerswinner1_four_index_0_27;
      winnerswinner1_best_index_0_28 <= winnerswinner1_four_index_0_28;
      winnerswinner1_best_index_0_29 <= winnerswinner1_four_index_0_29;
      winnerswinner1_best_index_0_30 <= winnerswinner1_four_index_0_30;
      winnerswinner1_best_index_0_31 <= winnerswinner1_four_index_0_31;
      winnerswinner1_tag_valid <= winnerswinner1_four_tag_valid;
      winnerswinner1_tag_map_column <= winnerswinner1_four_tag_map_column;
      winnerswinner1_tag_output_column <= winnerswinner1_four_tag_output_column;
      winnerswinner1_tag_start_of_frame <= winnerswinner1_four_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= winnerswinner1_four_tag_end_of_line;
      if winnerswinner1_of_pair_0_0_choices(7) then
        winnerswinner1_of_pair_0(0) <= 0;
        winnerswinner1_of_pair_0(1) <= sums_sum_0(1);
      else
        winnerswinner1_of_pair_0(0) <= sums_sum_0(0);
        winnerswinner1_of_pair_0(1) <= 0;
      end if;
      if winnerswinner1_of_pair_0_2_choices(7) then
        winnerswinner1_of_pair_0(2) <= 0;
        winnerswinner1_of_pair_0(3) <= sums_sum_0(3);
        winnerswinner1_pair_index_0_1 <= 3;
      else
        winnerswinner1_of_pair_0(2) <= sums_sum_0(2);
        winnerswinner1_of_pair_0(3) <= 0;
        winnerswinner1_pair_index_0_1 <= 2;
      end if;
      if winnerswinner1_of_pair_0_4_choices(7) then
        winnerswinner1_of_pair_0(4) <= 0;
        winnerswinner1_of_pair_0(5) <= sums_sum_0(5);
        winnerswinner1_pair_index_0_2 <= 5;
      else
        winnerswinner1_of_pair_0(4) <= sums_sum_0(4);
        winnerswinner1_of_pair_0(5) <= 0;
        winnerswinner1_pair_index_0_2 <= 4;
      end if;
      if winnerswinner1_of_pair_0_6_choices(7) then
        winnerswinner1_of_pair_0(6) <= 0;
        winnerswinner1_of_pair_0(7) <= sums_sum_0(7);
        winnerswinner1_pair_index_0_3 <= 7;
      else
        winnerswinner1_of_pair_0(6) <= sums_sum_0(6);
        winnerswinner1_of_pair_0(7) <= 0;
        winnerswinner1_pair_index_0_3 <= 6;
      end if;
      if winnerswinner1_of_pair_0_8_choices(7) then
        winnerswinner1_of_pair_0(8) <= 0;
        winnerswinner1_of_pair_0(9) <= sums_sum_0(9);
        winnerswinner1_pair_index_0_4 <= 9;
      else
        winnerswinner1_of_pair_0(8) <= sums_sum_0(8);
        winnerswinner1_of_pair_0(9) <= 0;
        winnerswinner1_pair_index_0_4 <= 8;
      end if;
      if winnerswinner1_of_pair_0_10_choices(7) then
        winnerswinner1_of_pair_0(10) <= 0;
        winnerswinner1_of_pair_0(11) <= sums_sum_0(11);
        winnerswinner1_pair_index_0_5 <= 11;
      else
        winnerswinner1_of_pair_0(10) <= sums_sum_0(10);
        winnerswinner1_of_pair_0(11) <= 0;
        winnerswinner1_pair_index_0_5 <= 10;
      end if;
      if winnerswinner1_of_pair_0_12_choices(7) then
        winnerswinner1_of_pair_0(12) <= 0;
        winnerswinner1_of_pair_0(13) <= sums_sum_0(13);
        winnerswinner1_pair_index_0_6 <= 13;
      else
        winnerswinner1_of_pair_0(12) <= sums_sum_0(12);
        winnerswinner1_of_pair_0(13) <= 0;
        winnerswinner1_pair_index_0_6 <= 12;
      end if;
      if winnerswinner1_of_pair_0_14_choices(7) then
        winnerswinner1_of_pair_0(14) <= 0;
        winnerswinner1_of_pair_0(15) <= sums_sum_0(15);
        winnerswinner1_pair_index_0_7 <= 15;
      else
        winnerswinner1_of_pair_0(14) <= sums_sum_0(14);
        winnerswinner1_of_pair_0(15) <= 0;
        winnerswinner1_pair_index_0_7 <= 14;
      end if;
      if winnerswinner1_of_pair_0_16_choices(7) then
        winnerswinner1_of_pair_0(16) <= 0;
        winnerswinner1_of_pair_0(17) <= sums_sum_0(17);
        winnerswinner1_pair_index_0_8 <= 17;
      else
        winnerswinner1_of_pair_0(16) <= sums_sum_0(16);
        winnerswinner1_of_pair_0(17) <= 0;
        winnerswinner1_pair_index_0_8 <= 16;
      end if;
      if winnerswinner1_of_pair_0_18_choices(7) then
        winnerswinner1_of_pair_0(18) <= 0;
        winnerswinner1_of_pair_0(19) <= sums_sum_0(19);
        winnerswinner1_pair_index_0_9 <= 19;
      else
        winnerswinner1_of_pair_0(18) <= sums_sum_0(18);
        winnerswinner1_of_pair_0(19) <= 0;
        winnerswinner1_pair_index_0_9 <= 18;
      end if;
      if winnerswinner1_of_pair_0_20_choices(7) then
        winnerswinner1_of_pair_0(20) <= 0;
        winnerswinner1_of_pair_0(21) <= sums_sum_0(21);
        winnerswinner1_pair_index_0_10 <= 21;
      else
        winnerswinner1_of_pair_0(20) <= sums_sum_0(20);
        winnerswinner1_of_pair_0(21) <= 0;
        winnerswinner1_pair_index_0_10 <= 20;
      end if;
      if winnerswinner1_of_pair_0_22_choices(7) then
        winnerswinner1_of_pair_0(22) <= 0;
        winnerswinner1_of_pair_0(23) <= sums_sum_0(23);
        winnerswinner1_pair_index_0_11 <= 23;
      else
        winnerswinner1_of_pair_0(22) <= sums_sum_0(22);
        winnerswinner1_of_pair_0(23) <= 0;
        winnerswinner1_pair_index_0_11 <= 22;
      end if;
      if winnerswinner1_of_pair_0_24_choices(7) then
        winnerswinner1_of_pair_0(24) <= 0;
        winnerswinner1_of_pair_0(25) <= sums_sum_0(25);
        winnerswinner1_pair_index_0_12 <= 25;
      else
        winnerswinner1_of_pair_0(24) <= sums_sum_0(24);
        winnerswinner1_of_pair_0(25) <= 0;
        winnerswinner1_pair_index_0_12 <= 24;
      end if;
      if winnerswinner1_of_pair_0_26_choices(7) then
        winnerswinner1_of_pair_0(26) <= 0;
        winnerswinner1_of_pair_0(27) <= sums_sum_0(27);
        winnerswinner1_pair_index_0_13 <= 27;
      else
        winnerswinner1_of_pair_0(26) <= sums_sum_0(26);
        winnerswinner1_of_pair_0(27) <= 0;
        winnerswinner1_pair_index_0_13 <= 26;
      end if;
      if winnerswinner1_of_pair_0_28_choices(7) then
        winnerswinner1_of_pair_0(28) <= 0;
        winnerswinner1_of_pair_0(29) <= sums_sum_0(29);
        winnerswinner1_pair_index_0_14 <= 29;
      else
        winnerswinner1_of_pair_0(28) <= sums_sum_0(28);
        winnerswinner1_of_pair_0(29) <= 0;
        winnerswinner1_pair_index_0_14 <= 28;
      end if;
      if winnerswinner1_of_pair_0_30_choices(7) then
        winnerswinner1_of_pair_0(30) <= 0;
        winnerswinner1_of_pair_0(31) <= sums_sum_0(31);
        winnerswinner1_pair_index_0_15 <= 31;
      else
        winnerswinner1_of_pair_0(30) <= sums_sum_0(30);
        winnerswinner1_of_pair_0(31) <= 0;
        winnerswinner1_pair_index_0_15 <= 30;
      end if;
      if winnerswinner1_of_pair_0_32_choices(7) then
        winnerswinner1_of_pair_0(32) <= 0;
        winnerswinner1_of_pair_0(33) <= sums_sum_0(33);
        winnerswinner1_pair_index_0_16 <= 33;
      else
        winnerswinner1_of_pair_0(32) <= sums_sum_0(32);
        winnerswinner1_of_pair_0(33) <= 0;
        winnerswinner1_pair_index_0_16 <= 32;
      end if;
      if winnerswinner1_of_pair_0_34_choices(7) then
        winnerswinner1_of_pair_0(34) <= 0;
        winnerswinner1_of_pair_0(35) <= sums_sum_0(35);
        winnerswinner1_pair_index_0_17 <= 35;
      else
        winnerswinner1_of_pair_0(34) <= sums_sum_0(34);
        winnerswinner1_of_pair_0(35) <= 0;
        winnerswinner1_pair_index_0_17 <= 34;
      end if;
      if winnerswinner1_of_pair_0_36_choices(7) then
        winnerswinner1_of_pair_0(36) <= 0;
        winnerswinner1_of_pair_0(37) <= sums_sum_0(37);
        winnerswinner1_pair_index_0_18 <= 37;
      else
        winnerswinner1_of_pair_0(36) <= sums_sum_0(36);
        winnerswinner1_of_pair_0(37) <= 0;
        winnerswinner1_pair_index_0_18 <= 36;
      end if;
      if winnerswinner1_of_pair_0_38_choices(7) then
        winnerswinner1_of_pair_0(38) <= 0;
        winnerswinner1_of_pair_0(39) <= sums_sum_0(39);
        winnerswinner1_pair_index_0_19 <= 39;
      else
        winnerswinner1_of_pair_0(38) <= sums_sum_0(38);
        winnerswinner1_of_pair_0(39) <= 0;
        winnerswinner1_pair_index_0_19 <= 38;
      end if;
      if winnerswinner1_of_pair_0_40_choices(7) then
        winnerswinner1_of_pair_0(40) <= 0;
        winnerswinner1_of_pair_0(41) <= sums_sum_0(41);
        winnerswinner1_pair_index_0_20 <= 41;
      else
        winnerswinner1_of_pair_0(40) <= sums_sum_0(40);
        winnerswinner1_of_pair_0(41) <= 0;
        winnerswinner1_pair_index_0_20 <= 40;
      end if;
      if winnerswinner1_of_pair_0_42_choices(7) then
        winnerswinner1_of_pair_0(42) <= 0;
        winnerswinner1_of_pair_0(43) <= sums_sum_0(43);
        winnerswinner1_pair_index_0_21 <= 43;
      else
        winnerswinner1_of_pair_0(42) <= sums_sum_0(42);
        winnerswinner1_of_pair_0(43) <= 0;
        winnerswinner1_pair_index_0_21 <= 42;
      end if;
      if winnerswinner1_of_pair_0_44_choices(7) then
        winnerswinner1_of_pair_0(44) <= 0;
        winnerswinner1_of_pair_0(45) <= sums_sum_0(45);
        winnerswinner1_pair_index_0_22 <= 45;
      else
        winnerswinner1_of_pair_0(44) <= sums_sum_0(44);
        winnerswinner1_of_pair_0(45) <= 0;
        winnerswinner1_pair_index_0_22 <= 44;
      end if;
      if winnerswinner1_of_pair_0_46_choices(7) then
        winnerswinner1_of_pair_0(46) <= 0;
        winnerswinner1_of_pair_0(47) <= sums_sum_0(47);
        winnerswinner1_pair_index_0_23 <= 47;
      else
        winnerswinner1_of_pair_0(46) <= sums_sum_0(46);
        winnerswinner1_of_pair_0(47) <= 0;
        winnerswinner1_pair_index_0_23 <= 46;
      end if;
      if winnerswinner1_of_pair_0_48_choices(7) then
        winnerswinner1_of_pair_0(48) <= 0;
        winnerswinner1_of_pair_0(49) <= sums_sum_0(49);
        winnerswinner1_pair_index_0_24 <= 49;
      else
        winnerswinner1_of_pair_0(48) <= sums_sum_0(48);
        winnerswinner1_of_pair_0(49) <= 0;
        winnerswinner1_pair_index_0_24 <= 48;
      end if;
      if winnerswinner1_of_pair_0_50_choices(7) then
        winnerswinner1_of_pair_0(50) <= 0;
        winnerswinner1_of_pair_0(51) <= sums_sum_0(51);
        winnerswinner1_pair_index_0_25 <= 51;
      else
        winnerswinner1_of_pair_0(50) <= sums_sum_0(50);
        winnerswinner1_of_pair_0(51) <= 0;
        winnerswinner1_pair_index_0_25 <= 50;
      end if;
      if winnerswinner1_of_pair_0_52_choices(7) then
        winnerswinner1_of_pair_0(52) <= 0;
        winnerswinner1_of_pair_0(53) <= sums_sum_0(53);
        winnerswinner1_pair_index_0_26 <= 53;
      else
        winnerswinner1_of_pair_0(52) <= sums_sum_0(52);
        winnerswinner1_of_pair_0(53) <= 0;
        winnerswinner1_pair_index_0_26 <= 52;
      end if;
      if winnerswinner1_of_pair_0_54_choices(7) then
        winnerswinner1_of_pair_0(54) <= 0;
        winnerswinner1_of_pair_0(55) <= sums_sum_0(55);
        winnerswinner1_pair_index_0_27 <= 55;
      else
        winnerswinner1_of_pair_0(54) <= sums_sum_0(54);
        winnerswinner1_of_pair_0(55) <= 0;
        winnerswinner1_pair_index_0_27 <= 54;
      end if;
      if winnerswinner1_of_pair_0_56_choices(7) then
        winnerswinner1_of_pair_0(56) <= 0;
        winnerswinner1_of_pair_0(57) <= sums_sum_0(57);
        winnerswinner1_pair_index_0_28 <= 57;
      else
        winnerswinner1_of_pair_0(56) <= sums_sum_0(56);
        winnerswinner1_of_pair_0(57) <= 0;
        winnerswinner1_pair_index_0_28 <= 56;
      end if;
      if winnerswinner1_of_pair_0_58_choices(7) then
        winnerswinner1_of_pair_0(58) <= 0;
        winnerswinner1_of_pair_0(59) <= sums_sum_0(59);
        winnerswinner1_pair_index_0_29 <= 59;
      else
        winnerswinner1_of_pair_0(58) <= sums_sum_0(58);
        winnerswinner1_of_pair_0(59) <= 0;
        winnerswinner1_pair_index_0_29 <= 58;
      end if;
      if winnerswinner1_of_pair_0_60_choices(7) then
        winnerswinner1_of_pair_0(60) <= 0;
        winnerswinner1_of_pair_0(61) <= sums_sum_0(61);
        winnerswinner1_pair_index_0_30 <= 61;
      else
        winnerswinner1_of_pair_0(60) <= sums_sum_0(60);
        winnerswinner1_of_pair_0(61) <= 0;
        winnerswinner1_pair_index_0_30 <= 60;
      end if;
      if winnerswinner1_of_pair_0_62_choices(7) then
        winnerswinner1_of_pair_0(62) <= 0;
        winnerswinner1_of_pair_0(63) <= sums_sum_0(63);
        winnerswinner1_pair_index_0_31 <= 63;
      else
        winnerswinner1_of_pair_0(62) <= sums_sum_0(62);
        winnerswinner1_of_pair_0(63) <= 0;
        winnerswinner1_pair_index_0_31 <= 62;
      end if;
      if winnerswinner1_of_pair_0_64_choices(7) then
        winnerswinner1_of_pair_0(64) <= 0;
        winnerswinner1_of_pair_0(65) <= sums_sum_0(65);
        winnerswinner1_pair_index_0_32 <= 65;
      else
        winnerswinner1_of_pair_0(64) <= sums_sum_0(64);
        winnerswinner1_of_pair_0(65) <= 0;
        winnerswinner1_pair_index_0_32 <= 64;
      end if;
      if winnerswinner1_of_pair_0_66_choices(7) then
        winnerswinner1_of_pair_0(66) <= 0;
        winnerswinner1_of_pair_0(67) <= sums_sum_0(67);
        winnerswinner1_pair_index_0_33 <= 67;
      else
        winnerswinner1_of_pair_0(66) <= sums_sum_0(66);
        winnerswinner1_of_pair_0(67) <= 0;
        winnerswinner1_pair_index_0_33 <= 66;
      end if;
      if winnerswinner1_of_pair_0_68_choices(7) then
        winnerswinner1_of_pair_0(68) <= 0;
        winnerswinner1_of_pair_0(69) <= sums_sum_0(69);
        winnerswinner1_pair_index_0_34 <= 69;
      else
        winnerswinner1_of_pair_0(68) <= sums_sum_0(68);
        winnerswinner1_of_pair_0(69) <= 0;
        winnerswinner1_pair_index_0_34 <= 68;
      end if;
      if winnerswinner1_of_pair_0_70_choices(7) then
        winnerswinner1_of_pair_0(70) <= 0;
        winnerswinner1_of_pair_0(71) <= sums_sum_0(71);
        winnerswinner1_pair_index_0_35 <= 71;
      else
        winnerswinner1_of_pair_0(70) <= sums_sum_0(70);
        winnerswinner1_of_pair_0(71) <= 0;
        winnerswinner1_pair_index_0_35 <= 70;
      end if;
      if winnerswinner1_of_pair_0_72_choices(7) then
        winnerswinner1_of_pair_0(72) <= 0;
        winnerswinner1_of_pair_0(73) <= sums_sum_0(73);
        winnerswinner1_pair_index_0_36 <= 73;
      else
        winnerswinner1_of_pair_0(72) <= sums_sum_0(72);
        winnerswinner1_of_pair_0(73) <= 0;
        winnerswinner1_pair_index_0_36 <= 72;
      end if;
      if winnerswinner1_of_pair_0_74_choices(7) then
        winnerswinner1_of_pair_0(74) <= 0;
        winnerswinner1_of_pair_0(75) <= sums_sum_0(75);
        winnerswinner1_pair_index_0_37 <= 75;
      else
        winnerswinner1_of_pair_0(74) <= sums_sum_0(74);
        winnerswinner1_of_pair_0(75) <= 0;
        winnerswinner1_pair_index_0_37 <= 74;
      end if;
      if winnerswinner1_of_pair_0_76_choices(7) then
        winnerswinner1_of_pair_0(76) <= 0;
        winnerswinner1_of_pair_0(77) <= sums_sum_0(77);
        winnerswinner1_pair_index_0_38 <= 77;
      else
        winnerswinner1_of_pair_0(76) <= sums_sum_0(76);
        winnerswinner1_of_pair_0(77) <= 0;
        winnerswinner1_pair_index_0_38 <= 76;
      end if;
      if winnerswinner1_of_pair_0_78_choices(7) then
        winnerswinner1_of_pair_0(78) <= 0;
        winnerswinner1_of_pair_0(79) <= sums_sum_0(79);
        winnerswinner1_pair_index_0_39 <= 79;
      else
        winnerswinner1_of_pair_0(78) <= sums_sum_0(78);
        winnerswinner1_of_pair_0(79) <= 0;
        winnerswinner1_pair_index_0_39 <= 78;
      end if;
      if winnerswinner1_of_pair_0_80_choices(7) then
        winnerswinner1_of_pair_0(80) <= 0;
        winnerswinner1_of_pair_0(81) <= sums_sum_0(81);
        winnerswinner1_pair_index_0_40 <= 81;
      else
        winnerswinner1_of_pair_0(80) <= sums_sum_0(80);
        winnerswinner1_of_pair_0(81) <= 0;
        winnerswinner1_pair_index_0_40 <= 80;
      end if;
      if winnerswinner1_of_pair_0_82_choices(7) then
        winnerswinner1_of_pair_0(82) <= 0;
        winnerswinner1_of_pair_0(83) <= sums_sum_0(83);
        winnerswinner1_pair_index_0_41 <= 83;
      else
        winnerswinner1_of_pair_0(82) <= sums_sum_0(82);
        winnerswinner1_of_pair_0(83) <= 0;
        winnerswinner1_pair_index_0_41 <= 82;
      end if;
      if winnerswinner1_of_pair_0_84_choices(7) then
        winnerswinner1_of_pair_0(84) <= 0;
        winnerswinner1_of_pair_0(85) <= sums_sum_0(85);
        winnerswinner1_pair_index_0_42 <= 85;
      else
        winnerswinner1_of_pair_0(84) <= sums_sum_0(84);
        winnerswinner1_of_pair_0(85) <= 0;
        winnerswinner1_pair_index_0_42 <= 84;
      end if;
      if winnerswinner1_of_pair_0_86_choices(7) then
        winnerswinner1_of_pair_0(86) <= 0;
        winnerswinner1_of_pair_0(87) <= sums_sum_0(87);
        winnerswinner1_pair_index_0_43 <= 87;
      else
        winnerswinner1_of_pair_0(86) <= sums_sum_0(86);
        winnerswinner1_of_pair_0(87) <= 0;
        winnerswinner1_pair_index_0_43 <= 86;
      end if;
      if winnerswinner1_of_pair_0_88_choices(7) then
        winnerswinner1_of_pair_0(88) <= 0;
        winnerswinner1_of_pair_0(89) <= sums_sum_0(89);
        winnerswinner1_pair_index_0_44 <= 89;
      else
        winnerswinner1_of_pair_0(88) <= sums_sum_0(88);
        winnerswinner1_of_pair_0(89) <= 0;
        winnerswinner1_pair_index_0_44 <= 88;
      end if;
      if winnerswinner1_of_pair_0_90_choices(7) then
        winnerswinner1_of_pair_0(90) <= 0;
        winnerswinner1_of_pair_0(91) <= sums_sum_0(91);
        winnerswinner1_pair_index_0_45 <= 91;
      else
        winnerswinner1_of_pair_0(90) <= sums_sum_0(90);
        winnerswinner1_of_pair_0(91) <= 0;
        winnerswinner1_pair_index_0_45 <= 90;
      end if;
      if winnerswinner1_of_pair_0_92_choices(7) then
        winnerswinner1_of_pair_0(92) <= 0;
        winnerswinner1_of_pair_0(93) <= sums_sum_0(93);
        winnerswinner1_pair_index_0_46 <= 93;
      else
        winnerswinner1_of_pair_0(92) <= sums_sum_0(92);
        winnerswinner1_of_pair_0(93) <= 0;
        winnerswinner1_pair_index_0_46 <= 92;
      end if;
      if winnerswinner1_of_pair_0_94_choices(7) then
        winnerswinner1_of_pair_0(94) <= 0;
        winnerswinner1_of_pair_0(95) <= sums_sum_0(95);
        winnerswinner1_pair_index_0_47 <= 95;
      else
        winnerswinner1_of_pair_0(94) <= sums_sum_0(94);
        winnerswinner1_of_pair_0(95) <= 0;
        winnerswinner1_pair_index_0_47 <= 94;
      end if;
      if winnerswinner1_of_pair_0_96_choices(7) then
        winnerswinner1_of_pair_0(96) <= 0;
        winnerswinner1_of_pair_0(97) <= sums_sum_0(97);
        winnerswinner1_pair_index_0_48 <= 97;
      else
        winnerswinner1_of_pair_0(96) <= sums_sum_0(96);
        winnerswinner1_of_pair_0(97) <= 0;
        winnerswinner1_pair_index_0_48 <= 96;
      end if;
      if winnerswinner1_of_pair_0_98_choices(7) then
        winnerswinner1_of_pair_0(98) <= 0;
        winnerswinner1_of_pair_0(99) <= sums_sum_0(99);
        winnerswinner1_pair_index_0_49 <= 99;
      else
        winnerswinner1_of_pair_0(98) <= sums_sum_0(98);
        winnerswinner1_of_pair_0(99) <= 0;
        winnerswinner1_pair_index_0_49 <= 98;
      end if;
      if winnerswinner1_of_pair_0_100_choices(7) then
        winnerswinner1_of_pair_0(100) <= 0;
        winnerswinner1_of_pair_0(101) <= sums_sum_0(101);
        winnerswinner1_pair_index_0_50 <= 101;
      else
        winnerswinner1_of_pair_0(100) <= sums_sum_0(100);
        winnerswinner1_of_pair_0(101) <= 0;
        winnerswinner1_pair_index_0_50 <= 100;
      end if;
      if winnerswinner1_of_pair_0_102_choices(7) then
        winnerswinner1_of_pair_0(102) <= 0;
        winnerswinner1_of_pair_0(103) <= sums_sum_0(103);
        winnerswinner1_pair_index_0_51 <= 103;
      else
        winnerswinner1_of_pair_0(102) <= sums_sum_0(102);
        winnerswinner1_of_pair_0(103) <= 0;
        winnerswinner1_pair_index_0_51 <= 102;
      end if;
      if winnerswinner1_of_pair_0_104_choices(7) then
        winnerswinner1_of_pair_0(104) <= 0;
        winnerswinner1_of_pair_0(105) <= sums_sum_0(105);
        winnerswinner1_pair_index_0_52 <= 105;
      else
        winnerswinner1_of_pair_0(104) <= sums_sum_0(104);
        winnerswinner1_of_pair_0(105) <= 0;
        winnerswinner1_pair_index_0_52 <= 104;
      end if;
      if winnerswinner1_of_pair_0_106_choices(7) then
        winnerswinner1_of_pair_0(106) <= 0;
        winnerswinner1_of_pair_0(107) <= sums_sum_0(107);
        winnerswinner1_pair_index_0_53 <= 107;
      else
        winnerswinner1_of_pair_0(106) <= sums_sum_0(106);
        winnerswinner1_of_pair_0(107) <= 0;
        winnerswinner1_pair_index_0_53 <= 106;
      end if;
      if winnerswinner1_of_pair_0_108_choices(7) then
        winnerswinner1_of_pair_0(108) <= 0;
        winnerswinner1_of_pair_0(109) <= sums_sum_0(109);
        winnerswinner1_pair_index_0_54 <= 109;
      else
        winnerswinner1_of_pair_0(108) <= sums_sum_0(108);
        winnerswinner1_of_pair_0(109) <= 0;
        winnerswinner1_pair_index_0_54 <= 108;
      end if;
      if winnerswinner1_of_pair_0_110_choices(7) then
        winnerswinner1_of_pair_0(110) <= 0;
        winnerswinner1_of_pair_0(111) <= sums_sum_0(111);
        winnerswinner1_pair_index_0_55 <= 111;
      else
        winnerswinner1_of_pair_0(110) <= sums_sum_0(110);
        winnerswinner1_of_pair_0(111) <= 0;
        winnerswinner1_pair_index_0_55 <= 110;
      end if;
      if winnerswinner1_of_pair_0_112_choices(7) then
        winnerswinner1_of_pair_0(112) <= 0;
        winnerswinner1_of_pair_0(113) <= sums_sum_0(113);
        winnerswinner1_pair_index_0_56 <= 113;
      else
        winnerswinner1_of_pair_0(112) <= sums_sum_0(112);
        winnerswinner1_of_pair_0(113) <= 0;
        winnerswinner1_pair_index_0_56 <= 112;
      end if;
      if winnerswinner1_of_pair_0_114_choices(7) then
        winnerswinner1_of_pair_0(114) <= 0;
        winnerswinner1_of_pair_0(115) <= sums_sum_0(115);
        winnerswinner1_pair_index_0_57 <= 115;
      else
        winnerswinner1_of_pair_0(114) <= sums_sum_0(114);
        winnerswinner1_of_pair_0(115) <= 0;
        winnerswinner1_pair_index_0_57 <= 114;
      end if;
      if winnerswinner1_of_pair_0_116_choices(7) then
        winnerswinner1_of_pair_0(116) <= 0;
        winnerswinner1_of_pair_0(117) <= sums_sum_0(117);
        winnerswinner1_pair_index_0_58 <= 117;
      else
        winnerswinner1_of_pair_0(116) <= sums_sum_0(116);
        winnerswinner1_of_pair_0(117) <= 0;
        winnerswinner1_pair_index_0_58 <= 116;
      end if;
      if winnerswinner1_of_pair_0_118_choices(7) then
        winnerswinner1_of_pair_0(118) <= 0;
        winnerswinner1_of_pair_0(119) <= sums_sum_0(119);
        winnerswinner1_pair_index_0_59 <= 119;
      else
        winnerswinner1_of_pair_0(118) <= sums_sum_0(118);
        winnerswinner1_of_pair_0(119) <= 0;
        winnerswinner1_pair_index_0_59 <= 118;
      end if;
      if winnerswinner1_of_pair_0_120_choices(7) then
        winnerswinner1_of_pair_0(120) <= 0;
        winnerswinner1_of_pair_0(121) <= sums_sum_0(121);
        winnerswinner1_pair_index_0_60 <= 121;
      else
        winnerswinner1_of_pair_0(120) <= sums_sum_0(120);
        winnerswinner1_of_pair_0(121) <= 0;
        winnerswinner1_pair_index_0_60 <= 120;
      end if;
      if winnerswinner1_of_pair_0_122_choices(7) then
        winnerswinner1_of_pair_0(122) <= 0;
        winnerswinner1_of_pair_0(123) <= sums_sum_0(123);
        winnerswinner1_pair_index_0_61 <= 123;
      else
        winnerswinner1_of_pair_0(122) <= sums_sum_0(122);
        winnerswinner1_of_pair_0(123) <= 0;
        winnerswinner1_pair_index_0_61 <= 122;
      end if;
      if winnerswinner1_of_pair_0_124_choices(7) then
        winnerswinner1_of_pair_0(124) <= 0;
        winnerswinner1_of_pair_0(125) <= sums_sum_0(125);
        winnerswinner1_pair_index_0_62 <= 125;
      else
        winnerswinner1_of_pair_0(124) <= sums_sum_0(124);
        winnerswinner1_of_pair_0(125) <= 0;
        winnerswinner1_pair_index_0_62 <= 124;
      end if;
      if winnerswinner1_of_pair_0_126_choices(7) then
        winnerswinner1_of_pair_0(126) <= 0;
        winnerswinner1_of_pair_0(127) <= sums_sum_0(127);
        winnerswinner1_pair_index_0_63 <= 127;
      else
        winnerswinner1_of_pair_0(126) <= sums_sum_0(126);
        winnerswinner1_of_pair_0(127) <= 0;
        winnerswinner1_pair_index_0_63 <= 126;
      end if;
      if winnerswinner1_of_four_0_0_choices(7) then
        winnerswinner1_of_four_0(0) <= 0;
        winnerswinner1_of_four_0(1) <= 0;
        winnerswinner1_of_four_0(2) <= winnerswinner1_of_pair_0(2);
        winnerswinner1_of_four_0(3) <= winnerswinner1_of_pair_0(3);
        winnerswinner1_four_index_0_0 <= winnerswinner1_pair_index_0_1;
      else
        winnerswinner1_of_four_0(0) <= winnerswinner1_of_pair_0(0);
        winnerswinner1_of_four_0(1) <= winnerswinner1_of_pair_0(1);
        winnerswinner1_of_four_0(2) <= 0;
        winnerswinner1_of_four_0(3) <= 0;
        winnerswinner1_four_index_0_0 <= as_number(winnerswinner1_pair_index_0_0);
      end if;
      if winnerswinner1_of_four_0_4_choices(7) then
        winnerswinner1_of_four_0(4) <= 0;
        winnerswinner1_of_four_0(5) <= 0;
        winnerswinner1_of_four_0(6) <= winnerswinner1_of_pair_0(6);
        winnerswinner1_of_four_0(7) <= winnerswinner1_of_pair_0(7);
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_3;
      else
        winnerswinner1_of_four_0(4) <= winnerswinner1_of_pair_0(4);
        winnerswinner1_of_four_0(5) <= winnerswinner1_of_pair_0(5);
        winnerswinner1_of_four_0(6) <= 0;
        winnerswinner1_of_four_0(7) <= 0;
        winnerswinner1_four_index_0_1 <= winnerswinner1_pair_index_0_2;
      end if;
      if winnerswinner1_of_four_0_8_choices(7) then
        winnerswinner1_of_four_0(8) <= 0;
        winnerswinner1_of_four_0(9) <= 0;
        winnerswinner1_of_four_0(10) <= winnerswinner1_of_pair_0(10);
        winnerswinner1_of_four_0(11) <= winnerswinner1_of_pair_0(11);
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_5;
      else
        winnerswinner1_of_four_0(8) <= winnerswinner1_of_pair_0(8);
        winnerswinner1_of_four_0(9) <= winnerswinner1_of_pair_0(9);
        winnerswinner1_of_four_0(10) <= 0;
        winnerswinner1_of_four_0(11) <= 0;
        winnerswinner1_four_index_0_2 <= winnerswinner1_pair_index_0_4;
      end if;
      if winnerswinner1_of_four_0_12_choices(7) then
        winnerswinner1_of_four_0(12) <= 0;
        winnerswinner1_of_four_0(13) <= 0;
        winnerswinner1_of_four_0(14) <= winnerswinner1_of_pair_0(14);
        winnerswinner1_of_four_0(15) <= winnerswinner1_of_pair_0(15);
        winnerswinner1_four_index_0_3 <= winnerswinner1_pair_index_0_7;
      else
        winnerswinner1_of_four_0(12) <= winnerswinner1_of_pair_0(12);
        winnerswinner1_of_four_0(13) <= winnerswinner1_of_pair_0(13);
        winnerswinner1_of_four_0(14) <= 0;
        winnerswinner1_of_four_0(15) <= 0;
        winnerswinner1_four_index_0_3 <= winnerswinner1_pair_index_0_6;
      end if;
      if winnerswinner1_of_four_0_16_choices(7) then
        winnerswinner1_of_four_0(16) <= 0;
        winnerswinner1_of_four_0(17) <= 0;
        winnerswinner1_of_four_0(18) <= winnerswinner1_of_pair_0(18);
        winnerswinner1_of_four_0(19) <= winnerswinner1_of_pair_0(19);
        winnerswinner1_four_index_0_4 <= winnerswinner1_pair_index_0_9;
      else
        winnerswinner1_of_four_0(16) <= winnerswinner1_of_pair_0(16);
        winnerswinner1_of_four_0(17) <= winnerswinner1_of_pair_0(17);
        winnerswinner1_of_four_0(18) <= 0;
        winnerswinner1_of_four_0(19) <= 0;
        winnerswinner1_four_index_0_4 <= winnerswinner1_pair_index_0_8;
      end if;
      if winnerswinner1_of_four_0_20_choices(7) then
        winnerswinner1_of_four_0(20) <= 0;
        winnerswinner1_of_four_0(21) <= 0;
        winnerswinner1_of_four_0(22) <= winnerswinner1_of_pair_0(22);
        winnerswinner1_of_four_0(23) <= winnerswinner1_of_pair_0(23);
        winnerswinner1_four_index_0_5 <= winnerswinner1_pair_index_0_11;
      else
        winnerswinner1_of_four_0(20) <= winnerswinner1_of_pair_0(20);
        winnerswinner1_of_four_0(21) <= winnerswinner1_of_pair_0(21);
        winnerswinner1_of_four_0(22) <= 0;
        winnerswinner1_of_four_0(23) <= 0;
        winnerswinner1_four_index_0_5 <= winnerswinner1_pair_index_0_10;
      end if;
      if winnerswinner1_of_four_0_24_choices(7) then
        winnerswinner1_of_four_0(24) <= 0;
        winnerswinner1_of_four_0(25) <= 0;
        winnerswinner1_of_four_0(26) <= winnerswinner1_of_pair_0(26);
        winnerswinner1_of_four_0(27) <= winnerswinner1_of_pair_0(27);
        winnerswinner1_four_index_0_6 <= winnerswinner1_pair_index_0_13;
      else
        winnerswinner1_of_four_0(24) <= winnerswinner1_of_pair_0(24);
        winnerswinner1_of_four_0(25) <= winnerswinner1_of_pair_0(25);
        winnerswinner1_of_four_0(26) <= 0;
        winnerswinner1_of_four_0(27) <= 0;
        winnerswinner1_four_index_0_6 <= winnerswinner1_pair_index_0_12;
      end if;
      if winnerswinner1_of_four_0_28_choices(7) then
        winnerswinner1_of_four_0(28) <= 0;
        winnerswinner1_of_four_0(29) <= 0;
        winnerswinner1_of_four_0(30) <= winnerswinner1_of_pair_0(30);
        winnerswinner1_of_four_0(31) <= winnerswinner1_of_pair_0(31);
        winnerswinner1_four_index_0_7 <= winnerswinner1_pair_index_0_15;
      else
        winnerswinner1_of_four_0(28) <= winnerswinner1_of_pair_0(28);
        winnerswinner1_of_four_0(29) <= winnerswinner1_of_pair_0(29);
        winnerswinner1_of_four_0(30) <= 0;
        winnerswinner1_of_four_0(31) <= 0;
        winnerswinner1_four_index_0_7 <= winnerswinner1_pair_index_0_14;
      end if;
      if winnerswinner1_of_four_0_32_choices(7) then
        winnerswinner1_of_four_0(32) <= 0;
        winnerswinner1_of_four_0(33) <= 0;
        winnerswinner1_of_four_0(34) <= winnerswinner1_of_pair_0(34);
        winnerswinner1_of_four_0(35) <= winnerswinner1_of_pair_0(35);
        winnerswinner1_four_index_0_8 <= winnerswinner1_pair_index_0_17;
      else
        winnerswinner1_of_four_0(32) <= winnerswinner1_of_pair_0(32);
        winnerswinner1_of_four_0(33) <= winnerswinner1_of_pair_0(33);
        winnerswinner1_of_four_0(34) <= 0;
        winnerswinner1_of_four_0(35) <= 0;
        winnerswinner1_four_index_0_8 <= winnerswinner1_pair_index_0_16;
      end if;
      if winnerswinner1_of_four_0_36_choices(7) then
        winnerswinner1_of_four_0(36) <= 0;
        winnerswinner1_of_four_0(37) <= 0;
        winnerswinner1_of_four_0(38) <= winnerswinner1_of_pair_0(38);
        winnerswinner1_of_four_0(39) <= winnerswinner1_of_pair_0(39);
        winnerswinner1_four_index_0_9 <= winnerswinner1_pair_index_0_19;
      else
        winnerswinner1_of_four_0(36) <= winnerswinner1_of_pair_0(36);
        winnerswinner1_of_four_0(37) <= winnerswinner1_of_pair_0(37);
        winnerswinner1_of_four_0(38) <= 0;
        winnerswinner1_of_four_0(39) <= 0;
        winnerswinner1_four_index_0_9 <= winnerswinner1_pair_index_0_18;
      end if;
      if winnerswinner1_of_four_0_40_choices(7) then
        winnerswinner1_of_four_0(40) <= 0;
        winnerswinner1_of_four_0(41) <= 0;
        winnerswinner1_of_four_0(42) <= winnerswinner1_of_pair_0(42);
        winnerswinner1_of_four_0(43) <= winnerswinner1_of_pair_0(43);
        winnerswinner1_four_index_0_10 <= winnerswinner1_pair_index_0_21;
      else
        winnerswinner1_of_four_0(40) <= winnerswinner1_of_pair_0(40);
        winnerswinner1_of_four_0(41) <= winnerswinner1_of_pair_0(41);
        winnerswinner1_of_four_0(42) <= 0;
        winnerswinner1_of_four_0(43) <= 0;
        winnerswinner1_four_index_0_10 <= winnerswinner1_pair_index_0_20;
      end if;
      if winnerswinner1_of_four_0_44_choices(7) then
        winnerswinner1_of_four_0(44) <= 0;
        winnerswinner1_of_four_0(45) <= 0;
        winnerswinner1_of_four_0(46) <= winnerswinner1_of_pair_0(46);
        winnerswinner1_of_four_0(47) <= winnerswinner1_of_pair_0(47);
        winnerswinner1_four_index_0_11 <= winnerswinner1_pair_index_0_23;
      else
        winnerswinner1_of_four_0(44) <= winnerswinner1_of_pair_0(44);
        winnerswinner1_of_four_0(45) <= winnerswinner1_of_pair_0(45);
        winnerswinner1_of_four_0(46) <= 0;
        winnerswinner1_of_four_0(47) <= 0;
        winnerswinner1_four_index_0_11 <= winnerswinner1_pair_index_0_22;
      end if;
      if winnerswinner1_of_four_0_48_choices(7) then
        winnerswinner1_of_four_0(48) <= 0;
        winnerswinner1_of_four_0(49) <= 0;
        winnerswinner1_of_four_0(50) <= winnerswinner1_of_pair_0(50);
        winnerswinner1_of_four_0(51) <= winnerswinner1_of_pair_0(51);
        winnerswinner1_four_index_0_12 <= winnerswinner1_pair_index_0_25;
      else
        winnerswinner1_of_four_0(48) <= winnerswinner1_of_pair_0(48);
        winnerswinner1_of_four_0(49) <= winnerswinner1_of_pair_0(49);
        winnerswinner1_of_four_0(50) <= 0;
        winnerswinner1_of_four_0(51) <= 0;
        winnerswinner1_four_index_0_12 <= winnerswinner1_pair_index_0_24;
      end if;
      if winnerswinner1_of_four_0_52_choices(7) then
        winnerswinner1_of_four_0(52) <= 0;
        winnerswinner1_of_four_0(53) <= 0;
        winnerswinner1_of_four_0(54) <= winnerswinner1_of_pair_0(54);
        winnerswinner1_of_four_0(55) <= winnerswinner1_of_pair_0(55);
        winnerswinner1_four_index_0_13 <= winnerswinner1_pair_index_0_27;
      else
        winnerswinner1_of_four_0(52) <= winnerswinner1_of_pair_0(52);
        winnerswinner1_of_four_0(53) <= winnerswinner1_of_pair_0(53);
        winnerswinner1_of_four_0(54) <= 0;
        winnerswinner1_of_four_0(55) <= 0;
        winnerswinner1_four_index_0_13 <= winnerswinner1_pair_index_0_26;
      end if;
      if winnerswinner1_of_four_0_56_choices(7) then
        winnerswinner1_of_four_0(56) <= 0;
        winnerswinner1_of_four_0(57) <= 0;
        winnerswinner1_of_four_0(58) <= winnerswinner1_of_pair_0(58);
        winnerswinner1_of_four_0(59) <= winnerswinner1_of_pair_0(59);
        winnerswinner1_four_index_0_14 <= winnerswinner1_pair_index_0_29;
      else
        winnerswinner1_of_four_0(56) <= winnerswinner1_of_pair_0(56);
        winnerswinner1_of_four_0(57) <= winnerswinner1_of_pair_0(57);
        winnerswinner1_of_four_0(58) <= 0;
        winnerswinner1_of_four_0(59) <= 0;
        winnerswinner1_four_index_0_14 <= winnerswinner1_pair_index_0_28;
      end if;
      if winnerswinner1_of_four_0_60_choices(7) then
        winnerswinner1_of_four_0(60) <= 0;
        winnerswinner1_of_four_0(61) <= 0;
        winnerswinner1_of_four_0(62) <= winnerswinner1_of_pair_0(62);
        winnerswinner1_of_four_0(63) <= winnerswinner1_of_pair_0(63);
        winnerswinner1_four_index_0_15 <= winnerswinner1_pair_index_0_31;
      else
        winnerswinner1_of_four_0(60) <= winnerswinner1_of_pair_0(60);
        winnerswinner1_of_four_0(61) <= winnerswinner1_of_pair_0(61);
        winnerswinner1_of_four_0(62) <= 0;
        winnerswinner1_of_four_0(63) <= 0;
        winnerswinner1_four_index_0_15 <= winnerswinner1_pair_index_0_30;
      end if;
      if winnerswinner1_of_four_0_64_choices(7) then
        winnerswinner1_of_four_0(64) <= 0;
        winnerswinner1_of_four_0(65) <= 0;
        winnerswinner1_of_four_0(66) <= winnerswinner1_of_pair_0(66);
        winnerswinner1_of_four_0(67) <= winnerswinner1_of_pair_0(67);
        winnerswinner1_four_index_0_16 <= winnerswinner1_pair_index_0_33;
      else
        winnerswinner1_of_four_0(64) <= winnerswinner1_of_pair_0(64);
        winnerswinner1_of_four_0(65) <= winnerswinner1_of_pair_0(65);
        winnerswinner1_of_four_0(66) <= 0;
        winnerswinner1_of_four_0(67) <= 0;
        winnerswinner1_four_index_0_16 <= winnerswinner1_pair_index_0_32;
      end if;
      if winnerswinner1_of_four_0_68_choices(7) then
        winnerswinner1_of_four_0(68) <= 0;
        winnerswinner1_of_four_0(69) <= 0;
        winnerswinner1_of_four_0(70) <= winnerswinner1_of_pair_0(70);
        winnerswinner1_of_four_0(71) <= winnerswinner1_of_pair_0(71);
        winnerswinner1_four_index_0_17 <= winnerswinner1_pair_index_0_35;
      else
        winnerswinner1_of_four_0(68) <= winnerswinner1_of_pair_0(68);
        winnerswinner1_of_four_0(69) <= winnerswinner1_of_pair_0(69);
        winnerswinner1_of_four_0(70) <= 0;
        winnerswinner1_of_four_0(71) <= 0;
        winnerswinner1_four_index_0_17 <= winnerswinner1_pair_index_0_34;
      end if;
      if winnerswinner1_of_four_0_72_choices(7) then
        winnerswinner1_of_four_0(72) <= 0;
        winnerswinner1_of_four_0(73) <= 0;
        winnerswinner1_of_four_0(74) <= winnerswinner1_of_pair_0(74);
        winnerswinner1_of_four_0(75) <= winnerswinner1_of_pair_0(75);
        winnerswinner1_four_index_0_18 <= winnerswinner1_pair_index_0_37;
      else
        winnerswinner1_of_four_0(72) <= winnerswinner1_of_pair_0(72);
        winnerswinner1_of_four_0(73) <= winnerswinner1_of_pair_0(73);
        winnerswinner1_of_four_0(74) <= 0;
        winnerswinner1_of_four_0(75) <= 0;
        winnerswinner1_four_index_0_18 <= winnerswinner1_pair_index_0_36;
      end if;
      if winnerswinner1_of_four_0_76_choices(7) then
        winnerswinner1_of_four_0(76) <= 0;
        winnerswinner1_of_four_0(77) <= 0;
        winnerswinner1_of_four_0(78) <= winnerswinner1_of_pair_0(78);
        winnerswinner1_of_four_0(79) <= winnerswinner1_of_pair_0(79);
        winnerswinner1_four_index_0_19 <= winnerswinner1_pair_index_0_39;
      else
        winnerswinner1_of_four_0(76) <= winnerswinner1_of_pair_0(76);
        winnerswinner1_of_four_0(77) <= winnerswinner1_of_pair_0(77);
        winnerswinner1_of_four_0(78) <= 0;
        winnerswinner1_of_four_0(79) <= 0;
        winnerswinner1_four_index_0_19 <= winnerswinner1_pair_index_0_38;
      end if;
      if winnerswinner1_of_four_0_80_choices(7) then
        winnerswinner1_of_four_0(80) <= 0;
        winnerswinner1_of_four_0(81) <= 0;
        winnerswinner1_of_four_0(82) <= winnerswinner1_of_pair_0(82);
        winnerswinner1_of_four_0(83) <= winnerswinner1_of_pair_0(83);
        winnerswinner1_four_index_0_20 <= winnerswinner1_pair_index_0_41;
      else
        winnerswinner1_of_four_0(80) <= winnerswinner1_of_pair_0(80);
        winnerswinner1_of_four_0(81) <= winnerswinner1_of_pair_0(81);
        winnerswinner1_of_four_0(82) <= 0;
        winnerswinner1_of_four_0(83) <= 0;
        winnerswinner1_four_index_0_20 <= winnerswinner1_pair_index_0_40;
      end if;
      if winnerswinner1_of_four_0_84_choices(7) then
        winnerswinner1_of_four_0(84) <= 0;
        winnerswinner1_of_four_0(85) <= 0;
        winnerswinner1_of_four_0(86) <= winnerswinner1_of_pair_0(86);
        winnerswinner1_of_four_0(87) <= winnerswinner1_of_pair_0(87);
        winnerswinner1_four_index_0_21 <= winnerswinner1_pair_index_0_43;
      else
        winnerswinner1_of_four_0(84) <= winnerswinner1_of_pair_0(84);
        winnerswinner1_of_four_0(85) <= winnerswinner1_of_pair_0(85);
        winnerswinner1_of_four_0(86) <= 0;
        winnerswinner1_of_four_0(87) <= 0;
        winnerswinner1_four_index_0_21 <= winnerswinner1_pair_index_0_42;
      end if;
      if winnerswinner1_of_four_0_88_choices(7) then
        winnerswinner1_of_four_0(88) <= 0;
        winnerswinner1_of_four_0(89) <= 0;
        winnerswinner1_of_four_0(90) <= winnerswinner1_of_pair_0(90);
        winnerswinner1_of_four_0(91) <= winnerswinner1_of_pair_0(91);
        winnerswinner1_four_index_0_22 <= winnerswinner1_pair_index_0_45;
      else
        winnerswinner1_of_four_0(88) <= winnerswinner1_of_pair_0(88);
        winnerswinner1_of_four_0(89) <= winnerswinner1_of_pair_0(89);
        winnerswinner1_of_four_0(90) <= 0;
        winnerswinner1_of_four_0(91) <= 0;
        winnerswinner1_four_index_0_22 <= winnerswinner1_pair_index_0_44;
      end if;
      if winnerswinner1_of_four_0_92_choices(7) then
        winnerswinner1_of_four_0(92) <= 0;
        winnerswinner1_of_four_0(93) <= 0;
        winnerswinner1_of_four_0(94) <= winnerswinner1_of_pair_0(94);
        winnerswinner1_of_four_0(95) <= winnerswinner1_of_pair_0(95);
        winnerswinner1_four_index_0_23 <= winnerswinner1_pair_index_0_47;
      else
        winnerswinner1_of_four_0(92) <= winnerswinner1_of_pair_0(92);
        winnerswinner1_of_four_0(93) <= winnerswinner1_of_pair_0(93);
        winnerswinner1_of_four_0(94) <= 0;
        winnerswinner1_of_four_0(95) <= 0;
        winnerswinner1_four_index_0_23 <= winnerswinner1_pair_index_0_46;
      end if;
      if winnerswinner1_of_four_0_96_choices(7) then
        winnerswinner1_of_four_0(96) <= 0;
        winnerswinner1_of_four_0(97) <= 0;
        winnerswinner1_of_four_0(98) <= winnerswinner1_of_pair_0(98);
        winnerswinner1_of_four_0(99) <= winnerswinner1_of_pair_0(99);
        winnerswinner1_four_index_0_24 <= winnerswinner1_pair_index_0_49;
      else
        winnerswinner1_of_four_0(96) <= winnerswinner1_of_pair_0(96);
        winnerswinner1_of_four_0(97) <= winnerswinner1_of_pair_0(97);
        winnerswinner1_of_four_0(98) <= 0;
        winnerswinner1_of_four_0(99) <= 0;
        winnerswinner1_four_index_0_24 <= winnerswinner1_pair_index_0_48;
      end if;
      if winnerswinner1_of_four_0_100_choices(7) then
        winnerswinner1_of_four_0(100) <= 0;
        winnerswinner1_of_four_0(101) <= 0;
        winnerswinner1_of_four_0(102) <= winnerswinner1_of_pair_0(102);
        winnerswinner1_of_four_0(103) <= winnerswinner1_of_pair_0(103);
        winnerswinner1_four_index_0_25 <= winnerswinner1_pair_index_0_51;
      else
        winnerswinner1_of_four_0(100) <= winnerswinner1_of_pair_0(100);
        winnerswinner1_of_four_0(101) <= winnerswinner1_of_pair_0(101);
        winnerswinner1_of_four_0(102) <= 0;
        winnerswinner1_of_four_0(103) <= 0;
        winnerswinner1_four_index_0_25 <= winnerswinner1_pair_index_0_50;
      end if;
      if winnerswinner1_of_four_0_104_choices(7) then
        winnerswinner1_of_four_0(104) <= 0;
        winnerswinner1_of_four_0(105) <= 0;
        winnerswinner1_of_four_0(106) <= winnerswinner1_of_pair_0(106);
        winnerswinner1_of_four_0(107) <= winnerswinner1_of_pair_0(107);
        winnerswinner1_four_index_0_26 <= winnerswinner1_pair_index_0_53;
      else
        winnerswinner1_of_four_0(104) <= winnerswinner1_of_pair_0(104);
        winnerswinner1_of_four_0(105) <= winnerswinner1_of_pair_0(105);
        winnerswinner1_of_four_0(106) <= 0;
        winnerswinner1_of_four_0(107) <= 0;
        winnerswinner1_four_index_0_26 <= winnerswinner1_pair_index_0_52;
      end if;
      if winnerswinner1_of_four_0_108_choices(7) then
        winnerswinner1_of_four_0(108) <= 0;
        winnerswinner1_of_four_0(109) <= 0;
        winnerswinner1_of_four_0(110) <= winnerswinner1_of_pair_0(110);
        winnerswinner1_of_four_0(111) <= winnerswinner1_of_pair_0(111);
        winnerswinner1_four_index_0_27 <= winnerswinner1_pair_index_0_55;
      else
        winnerswinner1_of_four_0(108) <= winnerswinner1_of_pair_0(108);
        winnerswinner1_of_four_0(109) <= winnerswinner1_of_pair_0(109);
        winnerswinner1_of_four_0(110) <= 0;
        winnerswinner1_of_four_0(111) <= 0;
        winnerswinner1_four_index_0_27 <= winnerswinner1_pair_index_0_54;
      end if;
      if winnerswinner1_of_four_0_112_choices(7) then
        winnerswinner1_of_four_0(112) <= 0;
        winnerswinner1_of_four_0(113) <= 0;
        winnerswinner1_of_four_0(114) <= winnerswinner1_of_pair_0(114);
        winnerswinner1_of_four_0(115) <= winnerswinner1_of_pair_0(115);
        winnerswinner1_four_index_0_28 <= winnerswinner1_pair_index_0_57;
      else
        winnerswinner1_of_four_0(112) <= winnerswinner1_of_pair_0(112);
        winnerswinner1_of_four_0(113) <= winnerswinner1_of_pair_0(113);
        winnerswinner1_of_four_0(114) <= 0;
        winnerswinner1_of_four_0(115) <= 0;
        winnerswinner1_four_index_0_28 <= winnerswinner1_pair_index_0_56;
      end if;
      if winnerswinner1_of_four_0_116_choices(7) then
        winnerswinner1_of_four_0(116) <= 0;
        winnerswinner1_of_four_0(117) <= 0;
        winnerswinner1_of_four_0(118) <= winnerswinner1_of_pair_0(118);
        winnerswinner1_of_four_0(119) <= winnerswinner1_of_pair_0(119);
        winnerswinner1_four_index_0_29 <= winnerswinner1_pair_index_0_59;
      else
        winnerswinner1_of_four_0(116) <= winnerswinner1_of_pair_0(116);
        winnerswinner1_of_four_0(117) <= winnerswinner1_of_pair_0(117);
        winnerswinner1_of_four_0(118) <= 0;
        winnerswinner1_of_four_0(119) <= 0;
        winnerswinner1_four_index_0_29 <= winnerswinner1_pair_index_0_58;
      end if;
      if winnerswinner1_of_four_0_120_choices(7) then
        winnerswinner1_of_four_0(120) <= 0;
        winnerswinner1_of_four_0(121) <= 0;
        winnerswinner1_of_four_0(122) <= winnerswinner1_of_pair_0(122);
        winnerswinner1_of_four_0(123) <= winnerswinner1_of_pair_0(123);
        winnerswinner1_four_index_0_30 <= winnerswinner1_pair_index_0_61;
      else
        winnerswinner1_of_four_0(120) <= winnerswinner1_of_pair_0(120);
        winnerswinner1_of_four_0(121) <= winnerswinner1_of_pair_0(121);
        winnerswinner1_of_four_0(122) <= 0;
        winnerswinner1_of_four_0(123) <= 0;
        winnerswinner1_four_index_0_30 <= winnerswinner1_pair_index_0_60;
      end if;
      if winnerswinner1_of_four_0_124_choices(7) then
        winnerswinner1_of_four_0(124) <= 0;
        winnerswinner1_of_four_0(125) <= 0;
        winnerswinner1_of_four_0(126) <= winnerswinner1_of_pair_0(126);
        winnerswinner1_of_four_0(127) <= winnerswinner1_of_pair_0(127);
        winnerswinner1_four_index_0_31 <= winnerswinner1_pair_index_0_63;
      else
        winnerswinner1_of_four_0(124) <= winnerswinner1_of_pair_0(124);
        winnerswinner1_of_four_0(125) <= winnerswinner1_of_pair_0(125);
        winnerswinner1_of_four_0(126) <= 0;
        winnerswinner1_of_four_0(127) <= 0;
        winnerswinner1_four_index_0_31 <= winnerswinner1_pair_index_0_62;
      end if;
      -- winnerswinner2
      if is_set(winnerswinner1_best_cost_0(0), 0) then
        winnerswinner2_of_pair_0_0_choice := (not is_set(winnerswinner1_best_cost_0(1), 1)) or (not
          is_set(winnerswinner1_best_cost_0(1), 0));
      else
        winnerswinner2_of_pair_0_0_choice := not is_set(winnerswinner1_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(0), 1) then
        winnerswinner2_of_pair_0_0_choices(2) := winnerswinner2_of_pair_0_0_choice;
      else
        winnerswinner2_of_pair_0_0_choices(2) := is_set(winnerswinner1_best_cost_0(0), 0) and
          ((winnerswinner1_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_0_value := is_set(winnerswinner1_best_cost_0(1), 2);
      if winnerswinner2_of_pair_0_0_choices(2) then
        winnerswinner2_of_pair_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) and
          winnerswinner2_of_pair_0_0_value;
      else
        winnerswinner2_of_pair_0_0_choices(3) := (not is_set(winnerswinner1_best_cost_0(0), 2)) or
          winnerswinner2_of_pair_0_0_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_0_values(i) := is_set(winnerswinner1_best_cost_0(1), i + 1);
        if winnerswinner2_of_pair_0_0_choices(i + 1) then
          winnerswinner2_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) or
            winnerswinner2_of_pair_0_0_values(i);
        else
          winnerswinner2_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(0), i + 1)) and
            winnerswinner2_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_0_choices(6) then
        winnerswinner2_of_pair_0_0_choices(7) := is_set(winnerswinner1_best_cost_0(0), 6) and (not
          is_set(winnerswinner1_best_cost_0(1), 6));
      else
        winnerswinner2_of_pair_0_0_choices(7) := is_set(winnerswinner1_best_cost_0(0), 6) or (not
          is_set(winnerswinner1_best_cost_0(1), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(2), 0) then
        winnerswinner2_of_pair_0_2_choice := (not is_set(winnerswinner1_best_cost_0(3), 1)) or (not
          is_set(winnerswinner1_best_cost_0(3), 0));
      else
        winnerswinner2_of_pair_0_2_choice := not is_set(winnerswinner1_best_cost_0(3), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(2), 1) then
        winnerswinner2_of_pair_0_2_choices(2) := winnerswinner2_of_pair_0_2_choice;
      else
        winnerswinner2_of_pair_0_2_choices(2) := is_set(winnerswinner1_best_cost_0(2), 0) and
          ((winnerswinner1_best_cost_0(3) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_2_value := is_set(winnerswinner1_best_cost_0(3), 2);
      if winnerswinner2_of_pair_0_2_choices(2) then
        winnerswinner2_of_pair_0_2_choices(3) := (not is_set(winnerswinner1_best_cost_0(2), 2)) and
          winnerswinner2_of_pair_0_2_value;
      else
        winnerswinner2_of_pair_0_2_choices(3) := (not is_set(winnerswinner1_best_cost_0(2), 2)) or
          winnerswinner2_of_pair_0_2_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_2_values(i) := is_set(winnerswinner1_best_cost_0(3), i + 1);
        if winnerswinner2_of_pair_0_2_choices(i + 1) then
          winnerswinner2_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(2), i + 1)) or
            winnerswinner2_of_pair_0_2_values(i);
        else
          winnerswinner2_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(2), i + 1)) and
            winnerswinner2_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_2_choices(6) then
        winnerswinner2_of_pair_0_2_choices(7) := is_set(winnerswinner1_best_cost_0(2), 6) and (not
          is_set(winnerswinner1_best_cost_0(3), 6));
      else
        winnerswinner2_of_pair_0_2_choices(7) := is_set(winnerswinner1_best_cost_0(2), 6) or (not
          is_set(winnerswinner1_best_cost_0(3), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(4), 0) then
        winnerswinner2_of_pair_0_4_choice := (not is_set(winnerswinner1_best_cost_0(5), 1)) or (not
          is_set(winnerswinner1_best_cost_0(5), 0));
      else
        winnerswinner2_of_pair_0_4_choice := not is_set(winnerswinner1_best_cost_0(5), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(4), 1) then
        winnerswinner2_of_pair_0_4_choices(2) := winnerswinner2_of_pair_0_4_choice;
      else
        winnerswinner2_of_pair_0_4_choices(2) := is_set(winnerswinner1_best_cost_0(4), 0) and
          ((winnerswinner1_best_cost_0(5) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_4_value := is_set(winnerswinner1_best_cost_0(5), 2);
      if winnerswinner2_of_pair_0_4_choices(2) then
        winnerswinner2_of_pair_0_4_choices(3) := (not is_set(winnerswinner1_best_cost_0(4), 2)) and
          winnerswinner2_of_pair_0_4_value;
      else
        winnerswinner2_of_pair_0_4_choices(3) := (not is_set(winnerswinner1_best_cost_0(4), 2)) or
          winnerswinner2_of_pair_0_4_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_4_values(i) := is_set(winnerswinner1_best_cost_0(5), i + 1);
        if winnerswinner2_of_pair_0_4_choices(i + 1) then
          winnerswinner2_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(4), i + 1)) or
            winnerswinner2_of_pair_0_4_values(i);
        else
          winnerswinner2_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(4), i + 1)) and
            winnerswinner2_of_pair_0_4_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_4_choices(6) then
        winnerswinner2_of_pair_0_4_choices(7) := is_set(winnerswinner1_best_cost_0(4), 6) and (not
          is_set(winnerswinner1_best_cost_0(5), 6));
      else
        winnerswinner2_of_pair_0_4_choices(7) := is_set(winnerswinner1_best_cost_0(4), 6) or (not
          is_set(winnerswinner1_best_cost_0(5), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(6), 0) then
        winnerswinner2_of_pair_0_6_choice := (not is_set(winnerswinner1_best_cost_0(7), 1)) or (not
          is_set(winnerswinner1_best_cost_0(7), 0));
      else
        winnerswinner2_of_pair_0_6_choice := not is_set(winnerswinner1_best_cost_0(7), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(6), 1) then
        winnerswinner2_of_pair_0_6_choices(2) := winnerswinner2_of_pair_0_6_choice;
      else
        winnerswinner2_of_pair_0_6_choices(2) := is_set(winnerswinner1_best_cost_0(6), 0) and
          ((winnerswinner1_best_cost_0(7) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_6_value := is_set(winnerswinner1_best_cost_0(7), 2);
      if winnerswinner2_of_pair_0_6_choices(2) then
        winnerswinner2_of_pair_0_6_choices(3) := (not is_set(winnerswinner1_best_cost_0(6), 2)) and
          winnerswinner2_of_pair_0_6_value;
      else
        winnerswinner2_of_pair_0_6_choices(3) := (not is_set(winnerswinner1_best_cost_0(6), 2)) or
          winnerswinner2_of_pair_0_6_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_6_values(i) := is_set(winnerswinner1_best_cost_0(7), i + 1);
        if winnerswinner2_of_pair_0_6_choices(i + 1) then
          winnerswinner2_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(6), i + 1)) or
            winnerswinner2_of_pair_0_6_values(i);
        else
          winnerswinner2_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(6), i + 1)) and
            winnerswinner2_of_pair_0_6_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_6_choices(6) then
        winnerswinner2_of_pair_0_6_choices(7) := is_set(winnerswinner1_best_cost_0(6), 6) and (not
          is_set(winnerswinner1_best_cost_0(7), 6));
      else
        winnerswinner2_of_pair_0_6_choices(7) := is_set(winnerswinner1_best_cost_0(6), 6) or (not
          is_set(winnerswinner1_best_cost_0(7), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(8), 0) then
        winnerswinner2_of_pair_0_8_choice := (not is_set(winnerswinner1_best_cost_0(9), 1)) or (not
          is_set(winnerswinner1_best_cost_0(9), 0));
      else
        winnerswinner2_of_pair_0_8_choice := not is_set(winnerswinner1_best_cost_0(9), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(8), 1) then
        winnerswinner2_of_pair_0_8_choices(2) := winnerswinner2_of_pair_0_8_choice;
      else
        winnerswinner2_of_pair_0_8_choices(2) := is_set(winnerswinner1_best_cost_0(8), 0) and
          ((winnerswinner1_best_cost_0(9) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_8_value := is_set(winnerswinner1_best_cost_0(9), 2);
      if winnerswinner2_of_pair_0_8_choices(2) then
        winnerswinner2_of_pair_0_8_choices(3) := (not is_set(winnerswinner1_best_cost_0(8), 2)) and
          winnerswinner2_of_pair_0_8_value;
      else
        winnerswinner2_of_pair_0_8_choices(3) := (not is_set(winnerswinner1_best_cost_0(8), 2)) or
          winnerswinner2_of_pair_0_8_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_8_values(i) := is_set(winnerswinner1_best_cost_0(9), i + 1);
        if winnerswinner2_of_pair_0_8_choices(i + 1) then
          winnerswinner2_of_pair_0_8_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(8), i + 1)) or
            winnerswinner2_of_pair_0_8_values(i);
        else
          winnerswinner2_of_pair_0_8_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(8), i + 1)) and
            winnerswinner2_of_pair_0_8_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_8_choices(6) then
        winnerswinner2_of_pair_0_8_choices(7) := is_set(winnerswinner1_best_cost_0(8), 6) and (not
          is_set(winnerswinner1_best_cost_0(9), 6));
      else
        winnerswinner2_of_pair_0_8_choices(7) := is_set(winnerswinner1_best_cost_0(8), 6) or (not
          is_set(winnerswinner1_best_cost_0(9), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(10), 0) then
        winnerswinner2_of_pair_0_10_choice := (not is_set(winnerswinner1_best_cost_0(11), 1)) or (not
          is_set(winnerswinner1_best_cost_0(11), 0));
      else
        winnerswinner2_of_pair_0_10_choice := not is_set(winnerswinner1_best_cost_0(11), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(10), 1) then
        winnerswinner2_of_pair_0_10_choices(2) := winnerswinner2_of_pair_0_10_choice;
      else
        winnerswinner2_of_pair_0_10_choices(2) := is_set(winnerswinner1_best_cost_0(10), 0) and
          ((winnerswinner1_best_cost_0(11) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_10_value := is_set(winnerswinner1_best_cost_0(11), 2);
      if winnerswinner2_of_pair_0_10_choices(2) then
        winnerswinner2_of_pair_0_10_choices(3) := (not is_set(winnerswinner1_best_cost_0(10), 2)) and
          winnerswinner2_of_pair_0_10_value;
      else
        winnerswinner2_of_pair_0_10_choices(3) := (not is_set(winnerswinner1_best_cost_0(10), 2)) or
          winnerswinner2_of_pair_0_10_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_10_values(i) := is_set(winnerswinner1_best_cost_0(11), i + 1);
        if winnerswinner2_of_pair_0_10_choices(i + 1) then
          winnerswinner2_of_pair_0_10_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(10), i + 1)) or
            winnerswinner2_of_pair_0_10_values(i);
        else
          winnerswinner2_of_pair_0_10_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(10), i + 1)) and
            winnerswinner2_of_pair_0_10_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_10_choices(6) then
        winnerswinner2_of_pair_0_10_choices(7) := is_set(winnerswinner1_best_cost_0(10), 6) and (not
          is_set(winnerswinner1_best_cost_0(11), 6));
      else
        winnerswinner2_of_pair_0_10_choices(7) := is_set(winnerswinner1_best_cost_0(10), 6) or (not
          is_set(winnerswinner1_best_cost_0(11), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(12), 0) then
        winnerswinner2_of_pair_0_12_choice := (not is_set(winnerswinner1_best_cost_0(13), 1)) or (not
          is_set(winnerswinner1_best_cost_0(13), 0));
      else
        winnerswinner2_of_pair_0_12_choice := not is_set(winnerswinner1_best_cost_0(13), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(12), 1) then
        winnerswinner2_of_pair_0_12_choices(2) := winnerswinner2_of_pair_0_12_choice;
      else
        winnerswinner2_of_pair_0_12_choices(2) := is_set(winnerswinner1_best_cost_0(12), 0) and
          ((winnerswinner1_best_cost_0(13) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_12_value := is_set(winnerswinner1_best_cost_0(13), 2);
      if winnerswinner2_of_pair_0_12_choices(2) then
        winnerswinner2_of_pair_0_12_choices(3) := (not is_set(winnerswinner1_best_cost_0(12), 2)) and
          winnerswinner2_of_pair_0_12_value;
      else
        winnerswinner2_of_pair_0_12_choices(3) := (not is_set(winnerswinner1_best_cost_0(12), 2)) or
          winnerswinner2_of_pair_0_12_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_12_values(i) := is_set(winnerswinner1_best_cost_0(13), i + 1);
        if winnerswinner2_of_pair_0_12_choices(i + 1) then
          winnerswinner2_of_pair_0_12_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(12), i + 1)) or
            winnerswinner2_of_pair_0_12_values(i);
        else
          winnerswinner2_of_pair_0_12_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(12), i + 1)) and
            winnerswinner2_of_pair_0_12_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_12_choices(6) then
        winnerswinner2_of_pair_0_12_choices(7) := is_set(winnerswinner1_best_cost_0(12), 6) and (not
          is_set(winnerswinner1_best_cost_0(13), 6));
      else
        winnerswinner2_of_pair_0_12_choices(7) := is_set(winnerswinner1_best_cost_0(12), 6) or (not
          is_set(winnerswinner1_best_cost_0(13), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(14), 0) then
        winnerswinner2_of_pair_0_14_choice := (not is_set(winnerswinner1_best_cost_0(15), 1)) or (not
          is_set(winnerswinner1_best_cost_0(15), 0));
      else
        winnerswinner2_of_pair_0_14_choice := not is_set(winnerswinner1_best_cost_0(15), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(14), 1) then
        winnerswinner2_of_pair_0_14_choices(2) := winnerswinner2_of_pair_0_14_choice;
      else
        winnerswinner2_of_pair_0_14_choices(2) := is_set(winnerswinner1_best_cost_0(14), 0) and
          ((winnerswinner1_best_cost_0(15) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_14_value := is_set(winnerswinner1_best_cost_0(15), 2);
      if winnerswinner2_of_pair_0_14_choices(2) then
        winnerswinner2_of_pair_0_14_choices(3) := (not is_set(winnerswinner1_best_cost_0(14), 2)) and
          winnerswinner2_of_pair_0_14_value;
      else
        winnerswinner2_of_pair_0_14_choices(3) := (not is_set(winnerswinner1_best_cost_0(14), 2)) or
          winnerswinner2_of_pair_0_14_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_14_values(i) := is_set(winnerswinner1_best_cost_0(15), i + 1);
        if winnerswinner2_of_pair_0_14_choices(i + 1) then
          winnerswinner2_of_pair_0_14_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(14), i + 1)) or
            winnerswinner2_of_pair_0_14_values(i);
        else
          winnerswinner2_of_pair_0_14_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(14), i + 1)) and
            winnerswinner2_of_pair_0_14_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_14_choices(6) then
        winnerswinner2_of_pair_0_14_choices(7) := is_set(winnerswinner1_best_cost_0(14), 6) and (not
          is_set(winnerswinner1_best_cost_0(15), 6));
      else
        winnerswinner2_of_pair_0_14_choices(7) := is_set(winnerswinner1_best_cost_0(14), 6) or (not
          is_set(winnerswinner1_best_cost_0(15), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(16), 0) then
        winnerswinner2_of_pair_0_16_choice := (not is_set(winnerswinner1_best_cost_0(17), 1)) or (not
          is_set(winnerswinner1_best_cost_0(17), 0));
      else
        winnerswinner2_of_pair_0_16_choice := not is_set(winnerswinner1_best_cost_0(17), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(16), 1) then
        winnerswinner2_of_pair_0_16_choices(2) := winnerswinner2_of_pair_0_16_choice;
      else
        winnerswinner2_of_pair_0_16_choices(2) := is_set(winnerswinner1_best_cost_0(16), 0) and
          ((winnerswinner1_best_cost_0(17) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_16_value := is_set(winnerswinner1_best_cost_0(17), 2);
      if winnerswinner2_of_pair_0_16_choices(2) then
        winnerswinner2_of_pair_0_16_choices(3) := (not is_set(winnerswinner1_best_cost_0(16), 2)) and
          winnerswinner2_of_pair_0_16_value;
      else
        winnerswinner2_of_pair_0_16_choices(3) := (not is_set(winnerswinner1_best_cost_0(16), 2)) or
          winnerswinner2_of_pair_0_16_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_16_values(i) := is_set(winnerswinner1_best_cost_0(17), i + 1);
        if winnerswinner2_of_pair_0_16_choices(i + 1) then
          winnerswinner2_of_pair_0_16_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(16), i + 1)) or
            winnerswinner2_of_pair_0_16_values(i);
        else
          winnerswinner2_of_pair_0_16_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(16), i + 1)) and
            winnerswinner2_of_pair_0_16_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_16_choices(6) then
        winnerswinner2_of_pair_0_16_choices(7) := is_set(winnerswinner1_best_cost_0(16), 6) and (not
          is_set(winnerswinner1_best_cost_0(17), 6));
      else
        winnerswinner2_of_pair_0_16_choices(7) := is_set(winnerswinner1_best_cost_0(16), 6) or (not
          is_set(winnerswinner1_best_cost_0(17), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(18), 0) then
        winnerswinner2_of_pair_0_18_choice := (not is_set(winnerswinner1_best_cost_0(19), 1)) or (not
          is_set(winnerswinner1_best_cost_0(19), 0));
      else
        winnerswinner2_of_pair_0_18_choice := not is_set(winnerswinner1_best_cost_0(19), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(18), 1) then
        winnerswinner2_of_pair_0_18_choices(2) := winnerswinner2_of_pair_0_18_choice;
      else
        winnerswinner2_of_pair_0_18_choices(2) := is_set(winnerswinner1_best_cost_0(18), 0) and
          ((winnerswinner1_best_cost_0(19) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_18_value := is_set(winnerswinner1_best_cost_0(19), 2);
      if winnerswinner2_of_pair_0_18_choices(2) then
        winnerswinner2_of_pair_0_18_choices(3) := (not is_set(winnerswinner1_best_cost_0(18), 2)) and
          winnerswinner2_of_pair_0_18_value;
      else
        winnerswinner2_of_pair_0_18_choices(3) := (not is_set(winnerswinner1_best_cost_0(18), 2)) or
          winnerswinner2_of_pair_0_18_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_18_values(i) := is_set(winnerswinner1_best_cost_0(19), i + 1);
        if winnerswinner2_of_pair_0_18_choices(i + 1) then
          winnerswinner2_of_pair_0_18_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(18), i + 1)) or
            winnerswinner2_of_pair_0_18_values(i);
        else
          winnerswinner2_of_pair_0_18_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(18), i + 1)) and
            winnerswinner2_of_pair_0_18_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_18_choices(6) then
        winnerswinner2_of_pair_0_18_choices(7) := is_set(winnerswinner1_best_cost_0(18), 6) and (not
          is_set(winnerswinner1_best_cost_0(19), 6));
      else
        winnerswinner2_of_pair_0_18_choices(7) := is_set(winnerswinner1_best_cost_0(18), 6) or (not
          is_set(winnerswinner1_best_cost_0(19), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(20), 0) then
        winnerswinner2_of_pair_0_20_choice := (not is_set(winnerswinner1_best_cost_0(21), 1)) or (not
          is_set(winnerswinner1_best_cost_0(21), 0));
      else
        winnerswinner2_of_pair_0_20_choice := not is_set(winnerswinner1_best_cost_0(21), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(20), 1) then
        winnerswinner2_of_pair_0_20_choices(2) := winnerswinner2_of_pair_0_20_choice;
      else
        winnerswinner2_of_pair_0_20_choices(2) := is_set(winnerswinner1_best_cost_0(20), 0) and
          ((winnerswinner1_best_cost_0(21) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_20_value := is_set(winnerswinner1_best_cost_0(21), 2);
      if winnerswinner2_of_pair_0_20_choices(2) then
        winnerswinner2_of_pair_0_20_choices(3) := (not is_set(winnerswinner1_best_cost_0(20), 2)) and
          winnerswinner2_of_pair_0_20_value;
      else
        winnerswinner2_of_pair_0_20_choices(3) := (not is_set(winnerswinner1_best_cost_0(20), 2)) or
          winnerswinner2_of_pair_0_20_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_20_values(i) := is_set(winnerswinner1_best_cost_0(21), i + 1);
        if winnerswinner2_of_pair_0_20_choices(i + 1) then
          winnerswinner2_of_pair_0_20_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(20), i + 1)) or
            winnerswinner2_of_pair_0_20_values(i);
        else
          winnerswinner2_of_pair_0_20_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(20), i + 1)) and
            winnerswinner2_of_pair_0_20_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_20_choices(6) then
        winnerswinner2_of_pair_0_20_choices(7) := is_set(winnerswinner1_best_cost_0(20), 6) and (not
          is_set(winnerswinner1_best_cost_0(21), 6));
      else
        winnerswinner2_of_pair_0_20_choices(7) := is_set(winnerswinner1_best_cost_0(20), 6) or (not
          is_set(winnerswinner1_best_cost_0(21), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(22), 0) then
        winnerswinner2_of_pair_0_22_choice := (not is_set(winnerswinner1_best_cost_0(23), 1)) or (not
          is_set(winnerswinner1_best_cost_0(23), 0));
      else
        winnerswinner2_of_pair_0_22_choice := not is_set(winnerswinner1_best_cost_0(23), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(22), 1) then
        winnerswinner2_of_pair_0_22_choices(2) := winnerswinner2_of_pair_0_22_choice;
      else
        winnerswinner2_of_pair_0_22_choices(2) := is_set(winnerswinner1_best_cost_0(22), 0) and
          ((winnerswinner1_best_cost_0(23) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_22_value := is_set(winnerswinner1_best_cost_0(23), 2);
      if winnerswinner2_of_pair_0_22_choices(2) then
        winnerswinner2_of_pair_0_22_choices(3) := (not is_set(winnerswinner1_best_cost_0(22), 2)) and
          winnerswinner2_of_pair_0_22_value;
      else
        winnerswinner2_of_pair_0_22_choices(3) := (not is_set(winnerswinner1_best_cost_0(22), 2)) or
          winnerswinner2_of_pair_0_22_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_22_values(i) := is_set(winnerswinner1_best_cost_0(23), i + 1);
        if winnerswinner2_of_pair_0_22_choices(i + 1) then
          winnerswinner2_of_pair_0_22_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(22), i + 1)) or
            winnerswinner2_of_pair_0_22_values(i);
        else
          winnerswinner2_of_pair_0_22_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(22), i + 1)) and
            winnerswinner2_of_pair_0_22_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_22_choices(6) then
        winnerswinner2_of_pair_0_22_choices(7) := is_set(winnerswinner1_best_cost_0(22), 6) and (not
          is_set(winnerswinner1_best_cost_0(23), 6));
      else
        winnerswinner2_of_pair_0_22_choices(7) := is_set(winnerswinner1_best_cost_0(22), 6) or (not
          is_set(winnerswinner1_best_cost_0(23), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(24), 0) then
        winnerswinner2_of_pair_0_24_choice := (not is_set(winnerswinner1_best_cost_0(25), 1)) or (not
          is_set(winnerswinner1_best_cost_0(25), 0));
      else
        winnerswinner2_of_pair_0_24_choice := not is_set(winnerswinner1_best_cost_0(25), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(24), 1) then
        winnerswinner2_of_pair_0_24_choices(2) := winnerswinner2_of_pair_0_24_choice;
      else
        winnerswinner2_of_pair_0_24_choices(2) := is_set(winnerswinner1_best_cost_0(24), 0) and
          ((winnerswinner1_best_cost_0(25) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_24_value := is_set(winnerswinner1_best_cost_0(25), 2);
      if winnerswinner2_of_pair_0_24_choices(2) then
        winnerswinner2_of_pair_0_24_choices(3) := (not is_set(winnerswinner1_best_cost_0(24), 2)) and
          winnerswinner2_of_pair_0_24_value;
      else
        winnerswinner2_of_pair_0_24_choices(3) := (not is_set(winnerswinner1_best_cost_0(24), 2)) or
          winnerswinner2_of_pair_0_24_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_24_values(i) := is_set(winnerswinner1_best_cost_0(25), i + 1);
        if winnerswinner2_of_pair_0_24_choices(i + 1) then
          winnerswinner2_of_pair_0_24_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(24), i + 1)) or
            winnerswinner2_of_pair_0_24_values(i);
        else
          winnerswinner2_of_pair_0_24_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(24), i + 1)) and
            winnerswinner2_of_pair_0_24_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_24_choices(6) then
        winnerswinner2_of_pair_0_24_choices(7) := is_set(winnerswinner1_best_cost_0(24), 6) and (not
          is_set(winnerswinner1_best_cost_0(25), 6));
      else
        winnerswinner2_of_pair_0_24_choices(7) := is_set(winnerswinner1_best_cost_0(24), 6) or (not
          is_set(winnerswinner1_best_cost_0(25), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(26), 0) then
        winnerswinner2_of_pair_0_26_choice := (not is_set(winnerswinner1_best_cost_0(27), 1)) or (not
          is_set(winnerswinner1_best_cost_0(27), 0));
      else
        winnerswinner2_of_pair_0_26_choice := not is_set(winnerswinner1_best_cost_0(27), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(26), 1) then
        winnerswinner2_of_pair_0_26_choices(2) := winnerswinner2_of_pair_0_26_choice;
      else
        winnerswinner2_of_pair_0_26_choices(2) := is_set(winnerswinner1_best_cost_0(26), 0) and
          ((winnerswinner1_best_cost_0(27) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_26_value := is_set(winnerswinner1_best_cost_0(27), 2);
      if winnerswinner2_of_pair_0_26_choices(2) then
        winnerswinner2_of_pair_0_26_choices(3) := (not is_set(winnerswinner1_best_cost_0(26), 2)) and
          winnerswinner2_of_pair_0_26_value;
      else
        winnerswinner2_of_pair_0_26_choices(3) := (not is_set(winnerswinner1_best_cost_0(26), 2)) or
          winnerswinner2_of_pair_0_26_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_26_values(i) := is_set(winnerswinner1_best_cost_0(27), i + 1);
        if winnerswinner2_of_pair_0_26_choices(i + 1) then
          winnerswinner2_of_pair_0_26_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(26), i + 1)) or
            winnerswinner2_of_pair_0_26_values(i);
        else
          winnerswinner2_of_pair_0_26_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(26), i + 1)) and
            winnerswinner2_of_pair_0_26_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_26_choices(6) then
        winnerswinner2_of_pair_0_26_choices(7) := is_set(winnerswinner1_best_cost_0(26), 6) and (not
          is_set(winnerswinner1_best_cost_0(27), 6));
      else
        winnerswinner2_of_pair_0_26_choices(7) := is_set(winnerswinner1_best_cost_0(26), 6) or (not
          is_set(winnerswinner1_best_cost_0(27), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(28), 0) then
        winnerswinner2_of_pair_0_28_choice := (not is_set(winnerswinner1_best_cost_0(29), 1)) or (not
          is_set(winnerswinner1_best_cost_0(29), 0));
      else
        winnerswinner2_of_pair_0_28_choice := not is_set(winnerswinner1_best_cost_0(29), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(28), 1) then
        winnerswinner2_of_pair_0_28_choices(2) := winnerswinner2_of_pair_0_28_choice;
      else
        winnerswinner2_of_pair_0_28_choices(2) := is_set(winnerswinner1_best_cost_0(28), 0) and
          ((winnerswinner1_best_cost_0(29) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_28_value := is_set(winnerswinner1_best_cost_0(29), 2);
      if winnerswinner2_of_pair_0_28_choices(2) then
        winnerswinner2_of_pair_0_28_choices(3) := (not is_set(winnerswinner1_best_cost_0(28), 2)) and
          winnerswinner2_of_pair_0_28_value;
      else
        winnerswinner2_of_pair_0_28_choices(3) := (not is_set(winnerswinner1_best_cost_0(28), 2)) or
          winnerswinner2_of_pair_0_28_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_28_values(i) := is_set(winnerswinner1_best_cost_0(29), i + 1);
        if winnerswinner2_of_pair_0_28_choices(i + 1) then
          winnerswinner2_of_pair_0_28_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(28), i + 1)) or
            winnerswinner2_of_pair_0_28_values(i);
        else
          winnerswinner2_of_pair_0_28_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(28), i + 1)) and
            winnerswinner2_of_pair_0_28_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_28_choices(6) then
        winnerswinner2_of_pair_0_28_choices(7) := is_set(winnerswinner1_best_cost_0(28), 6) and (not
          is_set(winnerswinner1_best_cost_0(29), 6));
      else
        winnerswinner2_of_pair_0_28_choices(7) := is_set(winnerswinner1_best_cost_0(28), 6) or (not
          is_set(winnerswinner1_best_cost_0(29), 6));
      end if;
      if is_set(winnerswinner1_best_cost_0(30), 0) then
        winnerswinner2_of_pair_0_30_choice := (not is_set(winnerswinner1_best_cost_0(31), 1)) or (not
          is_set(winnerswinner1_best_cost_0(31), 0));
      else
        winnerswinner2_of_pair_0_30_choice := not is_set(winnerswinner1_best_cost_0(31), 1);
      end if;
      if is_set(winnerswinner1_best_cost_0(30), 1) then
        winnerswinner2_of_pair_0_30_choices(2) := winnerswinner2_of_pair_0_30_choice;
      else
        winnerswinner2_of_pair_0_30_choices(2) := is_set(winnerswinner1_best_cost_0(30), 0) and
          ((winnerswinner1_best_cost_0(31) mod 4) = 0);
      end if;
      winnerswinner2_of_pair_0_30_value := is_set(winnerswinner1_best_cost_0(31), 2);
      if winnerswinner2_of_pair_0_30_choices(2) then
        winnerswinner2_of_pair_0_30_choices(3) := (not is_set(winnerswinner1_best_cost_0(30), 2)) and
          winnerswinner2_of_pair_0_30_value;
      else
        winnerswinner2_of_pair_0_30_choices(3) := (not is_set(winnerswinner1_best_cost_0(30), 2)) or
          winnerswinner2_of_pair_0_30_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner2_of_pair_0_30_values(i) := is_set(winnerswinner1_best_cost_0(31), i + 1);
        if winnerswinner2_of_pair_0_30_choices(i + 1) then
          winnerswinner2_of_pair_0_30_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(30), i + 1)) or
            winnerswinner2_of_pair_0_30_values(i);
        else
          winnerswinner2_of_pair_0_30_choices(i + 2) := (not is_set(winnerswinner1_best_cost_0(30), i + 1)) and
            winnerswinner2_of_pair_0_30_values(i);
        end if;
      end loop;
      if winnerswinner2_of_pair_0_30_choices(6) then
        winnerswinner2_of_pair_0_30_choices(7) := is_set(winnerswinner1_best_cost_0(30), 6) and (not
          is_set(winnerswinner1_best_cost_0(31), 6));
      else
        winnerswinner2_of_pair_0_30_choices(7) := is_set(winnerswinner1_best_cost_0(30), 6) or (not
          is_set(winnerswinner1_best_cost_0(31), 6));
      end if;
      if is_set(winnerswinner2_of_pair_0(1), 0) then
        winnerswinner2_of_four_0_0_choice := (not is_set(winnerswinner2_of_pair_0(3), 0)) and (not
          is_set(winnerswinner2_of_pair_0(2), 0));
      else
        winnerswinner2_of_four_0_0_choice := is_set(winnerswinner2_of_pair_0(0), 0) and (not
          is_set(winnerswinner2_of_pair_0(3), 0)) and (not is_set(winnerswinner2_of_pair_0(2), 0));
      end if;
      winnerswinner2_of_four_0_0_value := is_set(winnerswinner2_of_pair_0(1), 1);
      winnerswinner2_of_four_0_0_values(2) := is_set(winnerswinner2_of_pair_0(0), 1);
      if (not is_set(winnerswinner2_of_pair_0(3), 1)) and (not is_set(winnerswinner2_of_pair_0(2), 1)) then
        winnerswinner2_of_four_0_0_choices(2) := winnerswinner2_of_four_0_0_choice or winnerswinner2_of_four_0_0_value
          or winnerswinner2_of_four_0_0_values(2);
      else
        winnerswinner2_of_four_0_0_choices(2) := winnerswinner2_of_four_0_0_choice and
          (winnerswinner2_of_four_0_0_value or winnerswinner2_of_four_0_0_values(2));
      end if;
      winnerswinner2_of_four_0_0_values(3) := is_set(winnerswinner2_of_pair_0(3), 2);
      winnerswinner2_of_four_0_0_values(4) := is_set(winnerswinner2_of_pair_0(2), 2);
      if winnerswinner2_of_four_0_0_choices(2) then
        winnerswinner2_of_four_0_0_choices(3) := (not is_set(winnerswinner2_of_pair_0(1), 2)) and (not
          is_set(winnerswinner2_of_pair_0(0), 2)) and (winnerswinner2_of_four_0_0_values(3) or
          winnerswinner2_of_four_0_0_values(4));
      else
        winnerswinner2_of_four_0_0_choices(3) := ((not is_set(winnerswinner2_of_pair_0(1), 2)) and (not
          is_set(winnerswinner2_of_pair_0(0), 2))) or winnerswinner2_of_four_0_0_values(3) or
          winnerswinner2_of_four_0_0_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_0_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(3), i);
        winnerswinner2_of_four_0_0_values(2 * i) := is_set(winnerswinner2_of_pair_0(2), i);
        if winnerswinner2_of_four_0_0_choices(i) then
          winnerswinner2_of_four_0_0_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(1), i)) and (not
            is_set(winnerswinner2_of_pair_0(0), i))) or winnerswinner2_of_four_0_0_values(2 * i - 1) or
            winnerswinner2_of_four_0_0_values(2 * i);
        else
          winnerswinner2_of_four_0_0_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(1), i)) and (not
            is_set(winnerswinner2_of_pair_0(0), i)) and (winnerswinner2_of_four_0_0_values(2 * i - 1) or
            winnerswinner2_of_four_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_0_choices(6) then
        winnerswinner2_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(1), 6)) and (not
          is_set(winnerswinner2_of_pair_0(0), 6)))) and (not is_set(winnerswinner2_of_pair_0(3), 6)) and (not
          is_set(winnerswinner2_of_pair_0(2), 6));
      else
        winnerswinner2_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(1), 6)) and (not
          is_set(winnerswinner2_of_pair_0(0), 6)))) or ((not is_set(winnerswinner2_of_pair_0(3), 6)) and (not
          is_set(winnerswinner2_of_pair_0(2), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(5), 0) then
        winnerswinner2_of_four_0_4_choice := (not is_set(winnerswinner2_of_pair_0(7), 0)) and (not
          is_set(winnerswinner2_of_pair_0(6), 0));
      else
        winnerswinner2_of_four_0_4_choice := is_set(winnerswinner2_of_pair_0(4), 0) and (not
          is_set(winnerswinner2_of_pair_0(7), 0)) and (not is_set(winnerswinner2_of_pair_0(6), 0));
      end if;
      winnerswinner2_of_four_0_4_value := is_set(winnerswinner2_of_pair_0(5), 1);
      winnerswinner2_of_four_0_4_values(2) := is_set(winnerswinner2_of_pair_0(4), 1);
      if (not is_set(winnerswinner2_of_pair_0(7), 1)) and (not is_set(winnerswinner2_of_pair_0(6), 1)) then
        winnerswinner2_of_four_0_4_choices(2) := winnerswinner2_of_four_0_4_choice or winnerswinner2_of_four_0_4_value
          or winnerswinner2_of_four_0_4_values(2);
      else
        winnerswinner2_of_four_0_4_choices(2) := winnerswinner2_of_four_0_4_choice and
          (winnerswinner2_of_four_0_4_value or winnerswinner2_of_four_0_4_values(2));
      end if;
      winnerswinner2_of_four_0_4_values(3) := is_set(winnerswinner2_of_pair_0(7), 2);
      winnerswinner2_of_four_0_4_values(4) := is_set(winnerswinner2_of_pair_0(6), 2);
      if winnerswinner2_of_four_0_4_choices(2) then
        winnerswinner2_of_four_0_4_choices(3) := (not is_set(winnerswinner2_of_pair_0(5), 2)) and (not
          is_set(winnerswinner2_of_pair_0(4), 2)) and (winnerswinner2_of_four_0_4_values(3) or
          winnerswinner2_of_four_0_4_values(4));
      else
        winnerswinner2_of_four_0_4_choices(3) := ((not is_set(winnerswinner2_of_pair_0(5), 2)) and (not
          is_set(winnerswinner2_of_pair_0(4), 2))) or winnerswinner2_of_four_0_4_values(3) or
          winnerswinner2_of_four_0_4_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_4_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(7), i);
        winnerswinner2_of_four_0_4_values(2 * i) := is_set(winnerswinner2_of_pair_0(6), i);
        if winnerswinner2_of_four_0_4_choices(i) then
          winnerswinner2_of_four_0_4_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(5), i)) and (not
            is_set(winnerswinner2_of_pair_0(4), i))) or winnerswinner2_of_four_0_4_values(2 * i - 1) or
            winnerswinner2_of_four_0_4_values(2 * i);
        else
          winnerswinner2_of_four_0_4_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(5), i)) and (not
            is_set(winnerswinner2_of_pair_0(4), i)) and (winnerswinner2_of_four_0_4_values(2 * i - 1) or
            winnerswinner2_of_four_0_4_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_4_choices(6) then
        winnerswinner2_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(5), 6)) and (not
          is_set(winnerswinner2_of_pair_0(4), 6)))) and (not is_set(winnerswinner2_of_pair_0(7), 6)) and (not
          is_set(winnerswinner2_of_pair_0(6), 6));
      else
        winnerswinner2_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(5), 6)) and (not
          is_set(winnerswinner2_of_pair_0(4), 6)))) or ((not is_set(winnerswinner2_of_pair_0(7), 6)) and (not
          is_set(winnerswinner2_of_pair_0(6), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(9), 0) then
        winnerswinner2_of_four_0_8_choice := (not is_set(winnerswinner2_of_pair_0(11), 0)) and (not
          is_set(winnerswinner2_of_pair_0(10), 0));
      else
        winnerswinner2_of_four_0_8_choice := is_set(winnerswinner2_of_pair_0(8), 0) and (not
          is_set(winnerswinner2_of_pair_0(11), 0)) and (not is_set(winnerswinner2_of_pair_0(10), 0));
      end if;
      winnerswinner2_of_four_0_8_value := is_set(winnerswinner2_of_pair_0(9), 1);
      winnerswinner2_of_four_0_8_values(2) := is_set(winnerswinner2_of_pair_0(8), 1);
      if (not is_set(winnerswinner2_of_pair_0(11), 1)) and (not is_set(winnerswinner2_of_pair_0(10), 1)) then
        winnerswinner2_of_four_0_8_choices(2) := winnerswinner2_of_four_0_8_choice or winnerswinner2_of_four_0_8_value
          or winnerswinner2_of_four_0_8_values(2);
      else
        winnerswinner2_of_four_0_8_choices(2) := winnerswinner2_of_four_0_8_choice and
          (winnerswinner2_of_four_0_8_value or winnerswinner2_of_four_0_8_values(2));
      end if;
      winnerswinner2_of_four_0_8_values(3) := is_set(winnerswinner2_of_pair_0(11), 2);
      winnerswinner2_of_four_0_8_values(4) := is_set(winnerswinner2_of_pair_0(10), 2);
      if winnerswinner2_of_four_0_8_choices(2) then
        winnerswinner2_of_four_0_8_choices(3) := (not is_set(winnerswinner2_of_pair_0(9), 2)) and (not
          is_set(winnerswinner2_of_pair_0(8), 2)) and (winnerswinner2_of_four_0_8_values(3) or
          winnerswinner2_of_four_0_8_values(4));
      else
        winnerswinner2_of_four_0_8_choices(3) := ((not is_set(winnerswinner2_of_pair_0(9), 2)) and (not
          is_set(winnerswinner2_of_pair_0(8), 2))) or winnerswinner2_of_four_0_8_values(3) or
          winnerswinner2_of_four_0_8_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_8_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(11), i);
        winnerswinner2_of_four_0_8_values(2 * i) := is_set(winnerswinner2_of_pair_0(10), i);
        if winnerswinner2_of_four_0_8_choices(i) then
          winnerswinner2_of_four_0_8_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(9), i)) and (not
            is_set(winnerswinner2_of_pair_0(8), i))) or winnerswinner2_of_four_0_8_values(2 * i - 1) or
            winnerswinner2_of_four_0_8_values(2 * i);
        else
          winnerswinner2_of_four_0_8_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(9), i)) and (not
            is_set(winnerswinner2_of_pair_0(8), i)) and (winnerswinner2_of_four_0_8_values(2 * i - 1) or
            winnerswinner2_of_four_0_8_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_8_choices(6) then
        winnerswinner2_of_four_0_8_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(9), 6)) and (not
          is_set(winnerswinner2_of_pair_0(8), 6)))) and (not is_set(winnerswinner2_of_pair_0(11), 6)) and (not
          is_set(winnerswinner2_of_pair_0(10), 6));
      else
        winnerswinner2_of_four_0_8_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(9), 6)) and (not
          is_set(winnerswinner2_of_pair_0(8), 6)))) or ((not is_set(winnerswinner2_of_pair_0(11), 6)) and (not
          is_set(winnerswinner2_of_pair_0(10), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(13), 0) then
        winnerswinner2_of_four_0_12_choice := (not is_set(winnerswinner2_of_pair_0(15), 0)) and (not
          is_set(winnerswinner2_of_pair_0(14), 0));
      else
        winnerswinner2_of_four_0_12_choice := is_set(winnerswinner2_of_pair_0(12), 0) and (not
          is_set(winnerswinner2_of_pair_0(15), 0)) and (not is_set(winnerswinner2_of_pair_0(14), 0));
      end if;
      winnerswinner2_of_four_0_12_value := is_set(winnerswinner2_of_pair_0(13), 1);
      winnerswinner2_of_four_0_12_values(2) := is_set(winnerswinner2_of_pair_0(12), 1);
      if (not is_set(winnerswinner2_of_pair_0(15), 1)) and (not is_set(winnerswinner2_of_pair_0(14), 1)) then
        winnerswinner2_of_four_0_12_choices(2) := winnerswinner2_of_four_0_12_choice or
          winnerswinner2_of_four_0_12_value or winnerswinner2_of_four_0_12_values(2);
      else
        winnerswinner2_of_four_0_12_choices(2) := winnerswinner2_of_four_0_12_choice and
          (winnerswinner2_of_four_0_12_value or winnerswinner2_of_four_0_12_values(2));
      end if;
      winnerswinner2_of_four_0_12_values(3) := is_set(winnerswinner2_of_pair_0(15), 2);
      winnerswinner2_of_four_0_12_values(4) := is_set(winnerswinner2_of_pair_0(14), 2);
      if winnerswinner2_of_four_0_12_choices(2) then
        winnerswinner2_of_four_0_12_choices(3) := (not is_set(winnerswinner2_of_pair_0(13), 2)) and (not
          is_set(winnerswinner2_of_pair_0(12), 2)) and (winnerswinner2_of_four_0_12_values(3) or
          winnerswinner2_of_four_0_12_values(4));
      else
        winnerswinner2_of_four_0_12_choices(3) := ((not is_set(winnerswinner2_of_pair_0(13), 2)) and (not
          is_set(winnerswinner2_of_pair_0(12), 2))) or winnerswinner2_of_four_0_12_values(3) or
          winnerswinner2_of_four_0_12_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_12_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(15), i);
        winnerswinner2_of_four_0_12_values(2 * i) := is_set(winnerswinner2_of_pair_0(14), i);
        if winnerswinner2_of_four_0_12_choices(i) then
          winnerswinner2_of_four_0_12_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(13), i)) and (not
            is_set(winnerswinner2_of_pair_0(12), i))) or winnerswinner2_of_four_0_12_values(2 * i - 1) or
            winnerswinner2_of_four_0_12_values(2 * i);
        else
          winnerswinner2_of_four_0_12_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(13), i)) and (not
            is_set(winnerswinner2_of_pair_0(12), i)) and (winnerswinner2_of_four_0_12_values(2 * i - 1) or
            winnerswinner2_of_four_0_12_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_12_choices(6) then
        winnerswinner2_of_four_0_12_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(13), 6)) and (not
          is_set(winnerswinner2_of_pair_0(12), 6)))) and (not is_set(winnerswinner2_of_pair_0(15), 6)) and (not
          is_set(winnerswinner2_of_pair_0(14), 6));
      else
        winnerswinner2_of_four_0_12_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(13), 6)) and (not
          is_set(winnerswinner2_of_pair_0(12), 6)))) or ((not is_set(winnerswinner2_of_pair_0(15), 6)) and (not
          is_set(winnerswinner2_of_pair_0(14), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(17), 0) then
        winnerswinner2_of_four_0_16_choice := (not is_set(winnerswinner2_of_pair_0(19), 0)) and (not
          is_set(winnerswinner2_of_pair_0(18), 0));
      else
        winnerswinner2_of_four_0_16_choice := is_set(winnerswinner2_of_pair_0(16), 0) and (not
          is_set(winnerswinner2_of_pair_0(19), 0)) and (not is_set(winnerswinner2_of_pair_0(18), 0));
      end if;
      winnerswinner2_of_four_0_16_value := is_set(winnerswinner2_of_pair_0(17), 1);
      winnerswinner2_of_four_0_16_values(2) := is_set(winnerswinner2_of_pair_0(16), 1);
      if (not is_set(winnerswinner2_of_pair_0(19), 1)) and (not is_set(winnerswinner2_of_pair_0(18), 1)) then
        winnerswinner2_of_four_0_16_choices(2) := winnerswinner2_of_four_0_16_choice or
          winnerswinner2_of_four_0_16_value or winnerswinner2_of_four_0_16_values(2);
      else
        winnerswinner2_of_four_0_16_choices(2) := winnerswinner2_of_four_0_16_choice and
          (winnerswinner2_of_four_0_16_value or winnerswinner2_of_four_0_16_values(2));
      end if;
      winnerswinner2_of_four_0_16_values(3) := is_set(winnerswinner2_of_pair_0(19), 2);
      winnerswinner2_of_four_0_16_values(4) := is_set(winnerswinner2_of_pair_0(18), 2);
      if winnerswinner2_of_four_0_16_choices(2) then
        winnerswinner2_of_four_0_16_choices(3) := (not is_set(winnerswinner2_of_pair_0(17), 2)) and (not
          is_set(winnerswinner2_of_pair_0(16), 2)) and (winnerswinner2_of_four_0_16_values(3) or
          winnerswinner2_of_four_0_16_values(4));
      else
        winnerswinner2_of_four_0_16_choices(3) := ((not is_set(winnerswinner2_of_pair_0(17), 2)) and (not
          is_set(winnerswinner2_of_pair_0(16), 2))) or winnerswinner2_of_four_0_16_values(3) or
          winnerswinner2_of_four_0_16_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_16_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(19), i);
        winnerswinner2_of_four_0_16_values(2 * i) := is_set(winnerswinner2_of_pair_0(18), i);
        if winnerswinner2_of_four_0_16_choices(i) then
          winnerswinner2_of_four_0_16_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(17), i)) and (not
            is_set(winnerswinner2_of_pair_0(16), i))) or winnerswinner2_of_four_0_16_values(2 * i - 1) or
            winnerswinner2_of_four_0_16_values(2 * i);
        else
          winnerswinner2_of_four_0_16_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(17), i)) and (not
            is_set(winnerswinner2_of_pair_0(16), i)) and (winnerswinner2_of_four_0_16_values(2 * i - 1) or
            winnerswinner2_of_four_0_16_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_16_choices(6) then
        winnerswinner2_of_four_0_16_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(17), 6)) and (not
          is_set(winnerswinner2_of_pair_0(16), 6)))) and (not is_set(winnerswinner2_of_pair_0(19), 6)) and (not
          is_set(winnerswinner2_of_pair_0(18), 6));
      else
        winnerswinner2_of_four_0_16_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(17), 6)) and (not
          is_set(winnerswinner2_of_pair_0(16), 6)))) or ((not is_set(winnerswinner2_of_pair_0(19), 6)) and (not
          is_set(winnerswinner2_of_pair_0(18), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(21), 0) then
        winnerswinner2_of_four_0_20_choice := (not is_set(winnerswinner2_of_pair_0(23), 0)) and (not
          is_set(winnerswinner2_of_pair_0(22), 0));
      else
        winnerswinner2_of_four_0_20_choice := is_set(winnerswinner2_of_pair_0(20), 0) and (not
          is_set(winnerswinner2_of_pair_0(23), 0)) and (not is_set(winnerswinner2_of_pair_0(22), 0));
      end if;
      winnerswinner2_of_four_0_20_value := is_set(winnerswinner2_of_pair_0(21), 1);
      winnerswinner2_of_four_0_20_values(2) := is_set(winnerswinner2_of_pair_0(20), 1);
      if (not is_set(winnerswinner2_of_pair_0(23), 1)) and (not is_set(winnerswinner2_of_pair_0(22), 1)) then
        winnerswinner2_of_four_0_20_choices(2) := winnerswinner2_of_four_0_20_choice or
          winnerswinner2_of_four_0_20_value or winnerswinner2_of_four_0_20_values(2);
      else
        winnerswinner2_of_four_0_20_choices(2) := winnerswinner2_of_four_0_20_choice and
          (winnerswinner2_of_four_0_20_value or winnerswinner2_of_four_0_20_values(2));
      end if;
      winnerswinner2_of_four_0_20_values(3) := is_set(winnerswinner2_of_pair_0(23), 2);
      winnerswinner2_of_four_0_20_values(4) := is_set(winnerswinner2_of_pair_0(22), 2);
      if winnerswinner2_of_four_0_20_choices(2) then
        winnerswinner2_of_four_0_20_choices(3) := (not is_set(winnerswinner2_of_pair_0(21), 2)) and (not
          is_set(winnerswinner2_of_pair_0(20), 2)) and (winnerswinner2_of_four_0_20_values(3) or
          winnerswinner2_of_four_0_20_values(4));
      else
        winnerswinner2_of_four_0_20_choices(3) := ((not is_set(winnerswinner2_of_pair_0(21), 2)) and (not
          is_set(winnerswinner2_of_pair_0(20), 2))) or winnerswinner2_of_four_0_20_values(3) or
          winnerswinner2_of_four_0_20_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_20_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(23), i);
        winnerswinner2_of_four_0_20_values(2 * i) := is_set(winnerswinner2_of_pair_0(22), i);
        if winnerswinner2_of_four_0_20_choices(i) then
          winnerswinner2_of_four_0_20_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(21), i)) and (not
            is_set(winnerswinner2_of_pair_0(20), i))) or winnerswinner2_of_four_0_20_values(2 * i - 1) or
            winnerswinner2_of_four_0_20_values(2 * i);
        else
          winnerswinner2_of_four_0_20_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(21), i)) and (not
            is_set(winnerswinner2_of_pair_0(20), i)) and (winnerswinner2_of_four_0_20_values(2 * i - 1) or
            winnerswinner2_of_four_0_20_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_20_choices(6) then
        winnerswinner2_of_four_0_20_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(21), 6)) and (not
          is_set(winnerswinner2_of_pair_0(20), 6)))) and (not is_set(winnerswinner2_of_pair_0(23), 6)) and (not
          is_set(winnerswinner2_of_pair_0(22), 6));
      else
        winnerswinner2_of_four_0_20_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(21), 6)) and (not
          is_set(winnerswinner2_of_pair_0(20), 6)))) or ((not is_set(winnerswinner2_of_pair_0(23), 6)) and (not
          is_set(winnerswinner2_of_pair_0(22), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(25), 0) then
        winnerswinner2_of_four_0_24_choice := (not is_set(winnerswinner2_of_pair_0(27), 0)) and (not
          is_set(winnerswinner2_of_pair_0(26), 0));
      else
        winnerswinner2_of_four_0_24_choice := is_set(winnerswinner2_of_pair_0(24), 0) and (not
          is_set(winnerswinner2_of_pair_0(27), 0)) and (not is_set(winnerswinner2_of_pair_0(26), 0));
      end if;
      winnerswinner2_of_four_0_24_value := is_set(winnerswinner2_of_pair_0(25), 1);
      winnerswinner2_of_four_0_24_values(2) := is_set(winnerswinner2_of_pair_0(24), 1);
      if (not is_set(winnerswinner2_of_pair_0(27), 1)) and (not is_set(winnerswinner2_of_pair_0(26), 1)) then
        winnerswinner2_of_four_0_24_choices(2) := winnerswinner2_of_four_0_24_choice or
          winnerswinner2_of_four_0_24_value or winnerswinner2_of_four_0_24_values(2);
      else
        winnerswinner2_of_four_0_24_choices(2) := winnerswinner2_of_four_0_24_choice and
          (winnerswinner2_of_four_0_24_value or winnerswinner2_of_four_0_24_values(2));
      end if;
      winnerswinner2_of_four_0_24_values(3) := is_set(winnerswinner2_of_pair_0(27), 2);
      winnerswinner2_of_four_0_24_values(4) := is_set(winnerswinner2_of_pair_0(26), 2);
      if winnerswinner2_of_four_0_24_choices(2) then
        winnerswinner2_of_four_0_24_choices(3) := (not is_set(winnerswinner2_of_pair_0(25), 2)) and (not
          is_set(winnerswinner2_of_pair_0(24), 2)) and (winnerswinner2_of_four_0_24_values(3) or
          winnerswinner2_of_four_0_24_values(4));
      else
        winnerswinner2_of_four_0_24_choices(3) := ((not is_set(winnerswinner2_of_pair_0(25), 2)) and (not
          is_set(winnerswinner2_of_pair_0(24), 2))) or winnerswinner2_of_four_0_24_values(3) or
          winnerswinner2_of_four_0_24_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_24_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(27), i);
        winnerswinner2_of_four_0_24_values(2 * i) := is_set(winnerswinner2_of_pair_0(26), i);
        if winnerswinner2_of_four_0_24_choices(i) then
          winnerswinner2_of_four_0_24_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(25), i)) and (not
            is_set(winnerswinner2_of_pair_0(24), i))) or winnerswinner2_of_four_0_24_values(2 * i - 1) or
            winnerswinner2_of_four_0_24_values(2 * i);
        else
          winnerswinner2_of_four_0_24_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(25), i)) and (not
            is_set(winnerswinner2_of_pair_0(24), i)) and (winnerswinner2_of_four_0_24_values(2 * i - 1) or
            winnerswinner2_of_four_0_24_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_24_choices(6) then
        winnerswinner2_of_four_0_24_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(25), 6)) and (not
          is_set(winnerswinner2_of_pair_0(24), 6)))) and (not is_set(winnerswinner2_of_pair_0(27), 6)) and (not
          is_set(winnerswinner2_of_pair_0(26), 6));
      else
        winnerswinner2_of_four_0_24_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(25), 6)) and (not
          is_set(winnerswinner2_of_pair_0(24), 6)))) or ((not is_set(winnerswinner2_of_pair_0(27), 6)) and (not
          is_set(winnerswinner2_of_pair_0(26), 6)));
      end if;
      if is_set(winnerswinner2_of_pair_0(29), 0) then
        winnerswinner2_of_four_0_28_choice := (not is_set(winnerswinner2_of_pair_0(31), 0)) and (not
          is_set(winnerswinner2_of_pair_0(30), 0));
      else
        winnerswinner2_of_four_0_28_choice := is_set(winnerswinner2_of_pair_0(28), 0) and (not
          is_set(winnerswinner2_of_pair_0(31), 0)) and (not is_set(winnerswinner2_of_pair_0(30), 0));
      end if;
      winnerswinner2_of_four_0_28_value := is_set(winnerswinner2_of_pair_0(29), 1);
      winnerswinner2_of_four_0_28_values(2) := is_set(winnerswinner2_of_pair_0(28), 1);
      if (not is_set(winnerswinner2_of_pair_0(31), 1)) and (not is_set(winnerswinner2_of_pair_0(30), 1)) then
        winnerswinner2_of_four_0_28_choices(2) := winnerswinner2_of_four_0_28_choice or
          winnerswinner2_of_four_0_28_value or winnerswinner2_of_four_0_28_values(2);
      else
        winnerswinner2_of_four_0_28_choices(2) := winnerswinner2_of_four_0_28_choice and
          (winnerswinner2_of_four_0_28_value or winnerswinner2_of_four_0_28_values(2));
      end if;
      winnerswinner2_of_four_0_28_values(3) := is_set(winnerswinner2_of_pair_0(31), 2);
      winnerswinner2_of_four_0_28_values(4) := is_set(winnerswinner2_of_pair_0(30), 2);
      if winnerswinner2_of_four_0_28_choices(2) then
        winnerswinner2_of_four_0_28_choices(3) := (not is_set(winnerswinner2_of_pair_0(29), 2)) and (not
          is_set(winnerswinner2_of_pair_0(28), 2)) and (winnerswinner2_of_four_0_28_values(3) or
          winnerswinner2_of_four_0_28_values(4));
      else
        winnerswinner2_of_four_0_28_choices(3) := ((not is_set(winnerswinner2_of_pair_0(29), 2)) and (not
          is_set(winnerswinner2_of_pair_0(28), 2))) or winnerswinner2_of_four_0_28_values(3) or
          winnerswinner2_of_four_0_28_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner2_of_four_0_28_values(2 * i - 1) := is_set(winnerswinner2_of_pair_0(31), i);
        winnerswinner2_of_four_0_28_values(2 * i) := is_set(winnerswinner2_of_pair_0(30), i);
        if winnerswinner2_of_four_0_28_choices(i) then
          winnerswinner2_of_four_0_28_choices(i + 1) := ((not is_set(winnerswinner2_of_pair_0(29), i)) and (not
            is_set(winnerswinner2_of_pair_0(28), i))) or winnerswinner2_of_four_0_28_values(2 * i - 1) or
            winnerswinner2_of_four_0_28_values(2 * i);
        else
          winnerswinner2_of_four_0_28_choices(i + 1) := (not is_set(winnerswinner2_of_pair_0(29), i)) and (not
            is_set(winnerswinner2_of_pair_0(28), i)) and (winnerswinner2_of_four_0_28_values(2 * i - 1) or
            winnerswinner2_of_four_0_28_values(2 * i));
        end if;
      end loop;
      if winnerswinner2_of_four_0_28_choices(6) then
        winnerswinner2_of_four_0_28_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(29), 6)) and (not
          is_set(winnerswinner2_of_pair_0(28), 6)))) and (not is_set(winnerswinner2_of_pair_0(31), 6)) and (not
          is_set(winnerswinner2_of_pair_0(30), 6));
      else
        winnerswinner2_of_four_0_28_choices(7) := (not ((not is_set(winnerswinner2_of_pair_0(29), 6)) and (not
          is_set(winnerswinner2_of_pair_0(28), 6)))) or ((not is_set(winnerswinner2_of_pair_0(31), 6)) and (not
          is_set(winnerswinner2_of_pair_0(30), 6)));
      end if;
      winnerswinner2_pair_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_pair_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_pair_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_pair_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_pair_tag_end_of_line <= winnerswinner1_tag_end_of_line;
      winnerswinner2_four_tag_valid <= winnerswinner2_pair_tag_valid;
      winnerswinner2_four_tag_map_column <= winnerswinner2_pair_tag_map_column;
      winnerswinner2_four_tag_output_column <= winnerswinner2_pair_tag_output_column;
      winnerswinner2_four_tag_start_of_frame <= winnerswinner2_pair_tag_start_of_frame;
      winnerswinner2_four_tag_end_of_line <= winnerswinner2_pair_tag_end_of_line;
      for i in 0 to 7 loop
        winnerswinner2_best_cost_0(i) <= to_integer(((((((to_unsigned(winnerswinner2_of_four_0(4 * i + 2), 7)) or
          (to_unsigned(winnerswinner2_of_four_0(4 * i + 3), 7)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i + 1),
          7)))) or (to_unsigned(winnerswinner2_of_four_0(4 * i), 7))));
      end loop;
      winnerswinner2_best_index_0_0 <= winnerswinner2_four_index_0_0;
      winnerswinner2_best_index_0_1 <= winnerswinner2_four_index_0_1;
      winnerswinner2_best_index_0_2 <= winnerswinner2_four_index_0_2;
      winnerswinner2_best_index_0_3 <= winnerswinner2_four_index_0_3;
      winnerswinner2_best_index_0_4 <= winnerswinner2_four_index_0_4;
      winnerswinner2_best_index_0_5 <= winnerswinner2_four_index_0_5;
      winnerswinner2_best_index_0_6 <= winnerswinner2_four_index_0_6;
      winnerswinner2_best_index_0_7 <= winnerswinner2_four_index_0_7;
      winnerswinner2_tag_valid <= winnerswinner2_four_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner2_four_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner2_four_tag_output_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner2_four_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner2_four_tag_end_of_line;
      if winnerswinner2_of_pair_0_0_choices(7) then
        winnerswinner2_of_pair_0(0) <= 0;
        winnerswinner2_of_pair_0(1) <= winnerswinner1_best_cost_0(1);
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_1;
      else
        winnerswinner2_of_pair_0(0) <= winnerswinner1_best_cost_0(0);
        winnerswinner2_of_pair_0(1) <= 0;
        winnerswinner2_pair_index_0_0 <= winnerswinner1_best_index_0_0;
      end if;
      if winnerswinner2_of_pair_0_2_choices(7) then
        winnerswinner2_of_pair_0(2) <= 0;
        winnerswinner2_of_pair_0(3) <= winnerswinner1_best_cost_0(3);
        winnerswinner2_pair_index_0_1 <= winnerswinner1_best_index_0_3;
      else
        winnerswinner2_of_pair_0(2) <= winnerswinner1_best_cost_0(2);
        winnerswinner2_of_pair_0(3) <= 0;
        winnerswinner2_pair_index_0_1 <= winnerswinner1_best_index_0_2;
      end if;
      if winnerswinner2_of_pair_0_4_choices(7) then
        winnerswinner2_of_pair_0(4) <= 0;
        winnerswinner2_of_pair_0(5) <= winnerswinner1_best_cost_0(5);
        winnerswinner2_pair_index_0_2 <= winnerswinner1_best_index_0_5;
      else
        winnerswinner2_of_pair_0(4) <= winnerswinner1_best_cost_0(4);
        winnerswinner2_of_pair_0(5) <= 0;
        winnerswinner2_pair_index_0_2 <= winnerswinner1_best_index_0_4;
      end if;
      if winnerswinner2_of_pair_0_6_choices(7) then
        winnerswinner2_of_pair_0(6) <= 0;
        winnerswinner2_of_pair_0(7) <= winnerswinner1_best_cost_0(7);
        winnerswinner2_pair_index_0_3 <= winnerswinner1_best_index_0_7;
      else
        winnerswinner2_of_pair_0(6) <= winnerswinner1_best_cost_0(6);
        winnerswinner2_of_pair_0(7) <= 0;
        winnerswinner2_pair_index_0_3 <= winnerswinner1_best_index_0_6;
      end if;
      if winnerswinner2_of_pair_0_8_choices(7) then
        winnerswinner2_of_pair_0(8) <= 0;
        winnerswinner2_of_pair_0(9) <= winnerswinner1_best_cost_0(9);
        winnerswinner2_pair_index_0_4 <= winnerswinner1_best_index_0_9;
      else
        winnerswinner2_of_pair_0(8) <= winnerswinner1_best_cost_0(8);
        winnerswinner2_of_pair_0(9) <= 0;
        winnerswinner2_pair_index_0_4 <= winnerswinner1_best_index_0_8;
      end if;
      if winnerswinner2_of_pair_0_10_choices(7) then
        winnerswinner2_of_pair_0(10) <= 0;
        winnerswinner2_of_pair_0(11) <= winnerswinner1_best_cost_0(11);
        winnerswinner2_pair_index_0_5 <= winnerswinner1_best_index_0_11;
      else
        winnerswinner2_of_pair_0(10) <= winnerswinner1_best_cost_0(10);
        winnerswinner2_of_pair_0(11) <= 0;
        winnerswinner2_pair_index_0_5 <= winnerswinner1_best_index_0_10;
      end if;
      if winnerswinner2_of_pair_0_12_choices(7) then
        winnerswinner2_of_pair_0(12) <= 0;
        winnerswinner2_of_pair_0(13) <= winnerswinner1_best_cost_0(13);
        winnerswinner2_pair_index_0_6 <= winnerswinner1_best_index_0_13;
      else
        winnerswinner2_of_pair_0(12) <= winnerswinner1_best_cost_0(12);
        winnerswinner2_of_pair_0(13) <= 0;
        winnerswinner2_pair_index_0_6 <= winnerswinner1_best_index_0_12;
      end if;
      if winnerswinner2_of_pair_0_14_choices(7) then
        winnerswinner2_of_pair_0(14) <= 0;
        winnerswinner2_of_pair_0(15) <= winnerswinner1_best_cost_0(15);
        winnerswinner2_pair_index_0_7 <= winnerswinner1_best_index_0_15;
      else
        winnerswinner2_of_pair_0(14) <= winnerswinner1_best_cost_0(14);
        winnerswinner2_of_pair_0(15) <= 0;
        winnerswinner2_pair_index_0_7 <= winnerswinner1_best_index_0_14;
      end if;
      if winnerswinner2_of_pair_0_16_choices(7) then
        winnerswinner2_of_pair_0(16) <= 0;
        winnerswinner2_of_pair_0(17) <= winnerswinner1_best_cost_0(17);
        winnerswinner2_pair_index_0_8 <= winnerswinner1_best_index_0_17;
      else
        winnerswinner2_of_pair_0(16) <= winnerswinner1_best_cost_0(16);
        winnerswinner2_of_pair_0(17) <= 0;
        winnerswinner2_pair_index_0_8 <= winnerswinner1_best_index_0_16;
      end if;
      if winnerswinner2_of_pair_0_18_choices(7) then
        winnerswinner2_of_pair_0(18) <= 0;
        winnerswinner2_of_pair_0(19) <= winnerswinner1_best_cost_0(19);
        winnerswinner2_pair_index_0_9 <= winnerswinner1_best_index_0_19;
      else
        winnerswinner2_of_pair_0(18) <= winnerswinner1_best_cost_0(18);
        winnerswinner2_of_pair_0(19) <= 0;
        winnerswinner2_pair_index_0_9 <= winnerswinner1_best_index_0_18;
      end if;
      if winnerswinner2_of_pair_0_20_choices(7) then
        winnerswinner2_of_pair_0(20) <= 0;
        winnerswinner2_of_pair_0(21) <= winnerswinner1_best_cost_0(21);
        winnerswinner2_pair_index_0_10 <= winnerswinner1_best_index_0_21;
      else
        winnerswinner2_of_pair_0(20) <= winnerswinner1_best_cost_0(20);
        winnerswinner2_of_pair_0(21) <= 0;
        winnerswinner2_pair_index_0_10 <= winnerswinner1_best_index_0_20;
      end if;
      if winnerswinner2_of_pair_0_22_choices(7) then
        winnerswinner2_of_pair_0(22) <= 0;
        winnerswinner2_of_pair_0(23) <= winnerswinner1_best_cost_0(23);
        winnerswinner2_pair_index_0_11 <= winnerswinner1_best_index_0_23;
      else
        winnerswinner2_of_pair_0(22) <= winnerswinner1_best_cost_0(22);
        winnerswinner2_of_pair_0(23) <= 0;
        winnerswinner2_pair_index_0_11 <= winnerswinner1_best_index_0_22;
      end if;
      if winnerswinner2_of_pair_0_24_choices(7) then
        winnerswinner2_of_pair_0(24) <= 0;
        winnerswinner2_of_pair_0(25) <= winnerswinner1_best_cost_0(25);
        winnerswinner2_pair_index_0_12 <= winnerswinner1_best_index_0_25;
      else
        winnerswinner2_of_pair_0(24) <= winnerswinner1_best_cost_0(24);
        winnerswinner2_of_pair_0(25) <= 0;
        winnerswinner2_pair_index_0_12 <= winnerswinner1_best_index_0_24;
      end if;
      if winnerswinner2_of_pair_0_26_choices(7) then
        winnerswinner2_of_pair_0(26) <= 0;
        winnerswinner2_of_pair_0(27) <= winnerswinner1_best_cost_0(27);
        winnerswinner2_pair_index_0_13 <= winnerswinner1_best_index_0_27;
      else
        winnerswinner2_of_pair_0(26) <= winnerswinner1_best_cost_0(26);
        winnerswinner2_of_pair_0(27) <= 0;
        winnerswinner2_pair_index_0_13 <= winnerswinner1_best_index_0_26;
      end if;
      if winnerswinner2_of_pair_0_28_choices(7) then
        winnerswinner2_of_pair_0(28) <= 0;
        winnerswinner2_of_pair_0(29) <= winnerswinner1_best_cost_0(29);
        winnerswinner2_pair_index_0_14 <= winnerswinner1_best_index_0_29;
      else
        winnerswinner2_of_pair_0(28) <= winnerswinner1_best_cost_0(28);
        winnerswinner2_of_pair_0(29) <= 0;
        winnerswinner2_pair_index_0_14 <= winnerswinner1_best_index_0_28;
      end if;
      if winnerswinner2_of_pair_0_30_choices(7) then
        winnerswinner2_of_pair_0(30) <= 0;
        winnerswinner2_of_pair_0(31) <= winnerswinner1_best_cost_0(31);
        winnerswinner2_pair_index_0_15 <= winnerswinner1_best_index_0_31;
      else
        winnerswinner2_of_pair_0(30) <= winnerswinner1_best_cost_0(30);
        winnerswinner2_of_pair_0(31) <= 0;
        winnerswinner2_pair_index_0_15 <= winnerswinner1_best_index_0_30;
      end if;
      if winnerswinner2_of_four_0_0_choices(7) then
        winnerswinner2_of_four_0(0) <= 0;
        winnerswinner2_of_four_0(1) <= 0;
        winnerswinner2_of_four_0(2) <= winnerswinner2_of_pair_0(2);
        winnerswinner2_of_four_0(3) <= winnerswinner2_of_pair_0(3);
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_1;
      else
        winnerswinner2_of_four_0(0) <= winnerswinner2_of_pair_0(0);
        winnerswinner2_of_four_0(1) <= winnerswinner2_of_pair_0(1);
        winnerswinner2_of_four_0(2) <= 0;
        winnerswinner2_of_four_0(3) <= 0;
        winnerswinner2_four_index_0_0 <= winnerswinner2_pair_index_0_0;
      end if;
      if winnerswinner2_of_four_0_4_choices(7) then
        winnerswinner2_of_four_0(4) <= 0;
        winnerswinner2_of_four_0(5) <= 0;
        winnerswinner2_of_four_0(6) <= winnerswinner2_of_pair_0(6);
        winnerswinner2_of_four_0(7) <= winnerswinner2_of_pair_0(7);
        winnerswinner2_four_index_0_1 <= winnerswinner2_pair_index_0_3;
      else
        winnerswinner2_of_four_0(4) <= winnerswinner2_of_pair_0(4);
        winnerswinner2_of_four_0(5) <= winnerswinner2_of_pair_0(5);
        winnerswinner2_of_four_0(6) <= 0;
        winnerswinner2_of_four_0(7) <= 0;
        winnerswinner2_four_index_0_1 <= winnerswinner2_pair_index_0_2;
      end if;
      if winnerswinner2_of_four_0_8_choices(7) then
        winnerswinner2_of_four_0(8) <= 0;
        winnerswinner2_of_four_0(9) <= 0;
        winnerswinner2_of_four_0(10) <= winnerswinner2_of_pair_0(10);
        winnerswinner2_of_four_0(11) <= winnerswinner2_of_pair_0(11);
        winnerswinner2_four_index_0_2 <= winnerswinner2_pair_index_0_5;
      else
        winnerswinner2_of_four_0(8) <= winnerswinner2_of_pair_0(8);
        winnerswinner2_of_four_0(9) <= winnerswinner2_of_pair_0(9);
        winnerswinner2_of_four_0(10) <= 0;
        winnerswinner2_of_four_0(11) <= 0;
        winnerswinner2_four_index_0_2 <= winnerswinner2_pair_index_0_4;
      end if;
      if winnerswinner2_of_four_0_12_choices(7) then
        winnerswinner2_of_four_0(12) <= 0;
        winnerswinner2_of_four_0(13) <= 0;
        winnerswinner2_of_four_0(14) <= winnerswinner2_of_pair_0(14);
        winnerswinner2_of_four_0(15) <= winnerswinner2_of_pair_0(15);
        winnerswinner2_four_index_0_3 <= winnerswinner2_pair_index_0_7;
      else
        winnerswinner2_of_four_0(12) <= winnerswinner2_of_pair_0(12);
        winnerswinner2_of_four_0(13) <= winnerswinner2_of_pair_0(13);
        winnerswinner2_of_four_0(14) <= 0;
        winnerswinner2_of_four_0(15) <= 0;
        winnerswinner2_four_index_0_3 <= winnerswinner2_pair_index_0_6;
      end if;
      if winnerswinner2_of_four_0_16_choices(7) then
        winnerswinner2_of_four_0(16) <= 0;
        winnerswinner2_of_four_0(17) <= 0;
        winnerswinner2_of_four_0(18) <= winnerswinner2_of_pair_0(18);
        winnerswinner2_of_four_0(19) <= winnerswinner2_of_pair_0(19);
        winnerswinner2_four_index_0_4 <= winnerswinner2_pair_index_0_9;
      else
        winnerswinner2_of_four_0(16) <= winnerswinner2_of_pair_0(16);
        winnerswinner2_of_four_0(17) <= winnerswinner2_of_pair_0(17);
        winnerswinner2_of_four_0(18) <= 0;
        winnerswinner2_of_four_0(19) <= 0;
        winnerswinner2_four_index_0_4 <= winnerswinner2_pair_index_0_8;
      end if;
      if winnerswinner2_of_four_0_20_choices(7) then
        winnerswinner2_of_four_0(20) <= 0;
        winnerswinner2_of_four_0(21) <= 0;
        winnerswinner2_of_four_0(22) <= winnerswinner2_of_pair_0(22);
        winnerswinner2_of_four_0(23) <= winnerswinner2_of_pair_0(23);
        winnerswinner2_four_index_0_5 <= winnerswinner2_pair_index_0_11;
      else
        winnerswinner2_of_four_0(20) <= winnerswinner2_of_pair_0(20);
        winnerswinner2_of_four_0(21) <= winnerswinner2_of_pair_0(21);
        winnerswinner2_of_four_0(22) <= 0;
        winnerswinner2_of_four_0(23) <= 0;
        winnerswinner2_four_index_0_5 <= winnerswinner2_pair_index_0_10;
      end if;
      if winnerswinner2_of_four_0_24_choices(7) then
        winnerswinner2_of_four_0(24) <= 0;
        winnerswinner2_of_four_0(25) <= 0;
        winnerswinner2_of_four_0(26) <= winnerswinner2_of_pair_0(26);
        winnerswinner2_of_four_0(27) <= winnerswinner2_of_pair_0(27);
        winnerswinner2_four_index_0_6 <= winnerswinner2_pair_index_0_13;
      else
        winnerswinner2_of_four_0(24) <= winnerswinner2_of_pair_0(24);
        winnerswinner2_of_four_0(25) <= winnerswinner2_of_pair_0(25);
        winnerswinner2_of_four_0(26) <= 0;
        winnerswinner2_of_four_0(27) <= 0;
        winnerswinner2_four_index_0_6 <= winnerswinner2_pair_index_0_12;
      end if;
      if winnerswinner2_of_four_0_28_choices(7) then
        winnerswinner2_of_four_0(28) <= 0;
        winnerswinner2_of_four_0(29) <= 0;
        winnerswinner2_of_four_0(30) <= winnerswinner2_of_pair_0(30);
        winnerswinner2_of_four_0(31) <= winnerswinner2_of_pair_0(31);
        winnerswinner2_four_index_0_7 <= winnerswinner2_pair_index_0_15;
      else
        winnerswinner2_of_four_0(28) <= winnerswinner2_of_pair_0(28);
        winnerswinner2_of_four_0(29) <= winnerswinner2_of_pair_0(29);
        winnerswinner2_of_four_0(30) <= 0;
        winnerswinner2_of_four_0(31) <= 0;
        winnerswinner2_four_index_0_7 <= winnerswinner2_pair_index_0_14;
      end if;
      -- winnerswinner3
      if is_set(winnerswinner2_best_cost_0(0), 0) then
        winnerswinner3_of_pair_0_0_choice := (not is_set(winnerswinner2_best_cost_0(1), 1)) or (not
          is_set(winnerswinner2_best_cost_0(1), 0));
      else
        winnerswinner3_of_pair_0_0_choice := not is_set(winnerswinner2_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(0), 1) then
        winnerswinner3_of_pair_0_0_choices(2) := winnerswinner3_of_pair_0_0_choice;
      else
        winnerswinner3_of_pair_0_0_choices(2) := is_set(winnerswinner2_best_cost_0(0), 0) and
          ((winnerswinner2_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_0_value := is_set(winnerswinner2_best_cost_0(1), 2);
      if winnerswinner3_of_pair_0_0_choices(2) then
        winnerswinner3_of_pair_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) and
          winnerswinner3_of_pair_0_0_value;
      else
        winnerswinner3_of_pair_0_0_choices(3) := (not is_set(winnerswinner2_best_cost_0(0), 2)) or
          winnerswinner3_of_pair_0_0_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner3_of_pair_0_0_values(i) := is_set(winnerswinner2_best_cost_0(1), i + 1);
        if winnerswinner3_of_pair_0_0_choices(i + 1) then
          winnerswinner3_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) or
            winnerswinner3_of_pair_0_0_values(i);
        else
          winnerswinner3_of_pair_0_0_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(0), i + 1)) and
            winnerswinner3_of_pair_0_0_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_0_choices(6) then
        winnerswinner3_of_pair_0_0_choices(7) := is_set(winnerswinner2_best_cost_0(0), 6) and (not
          is_set(winnerswinner2_best_cost_0(1), 6));
      else
        winnerswinner3_of_pair_0_0_choices(7) := is_set(winnerswinner2_best_cost_0(0), 6) or (not
          is_set(winnerswinner2_best_cost_0(1), 6));
      end if;
      if is_set(winnerswinner2_best_cost_0(2), 0) then
        winnerswinner3_of_pair_0_2_choice := (not is_set(winnerswinner2_best_cost_0(3), 1)) or (not
          is_set(winnerswinner2_best_cost_0(3), 0));
      else
        winnerswinner3_of_pair_0_2_choice := not is_set(winnerswinner2_best_cost_0(3), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(2), 1) then
        winnerswinner3_of_pair_0_2_choices(2) := winnerswinner3_of_pair_0_2_choice;
      else
        winnerswinner3_of_pair_0_2_choices(2) := is_set(winnerswinner2_best_cost_0(2), 0) and
          ((winnerswinner2_best_cost_0(3) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_2_value := is_set(winnerswinner2_best_cost_0(3), 2);
      if winnerswinner3_of_pair_0_2_choices(2) then
        winnerswinner3_of_pair_0_2_choices(3) := (not is_set(winnerswinner2_best_cost_0(2), 2)) and
          winnerswinner3_of_pair_0_2_value;
      else
        winnerswinner3_of_pair_0_2_choices(3) := (not is_set(winnerswinner2_best_cost_0(2), 2)) or
          winnerswinner3_of_pair_0_2_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner3_of_pair_0_2_values(i) := is_set(winnerswinner2_best_cost_0(3), i + 1);
        if winnerswinner3_of_pair_0_2_choices(i + 1) then
          winnerswinner3_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(2), i + 1)) or
            winnerswinner3_of_pair_0_2_values(i);
        else
          winnerswinner3_of_pair_0_2_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(2), i + 1)) and
            winnerswinner3_of_pair_0_2_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_2_choices(6) then
        winnerswinner3_of_pair_0_2_choices(7) := is_set(winnerswinner2_best_cost_0(2), 6) and (not
          is_set(winnerswinner2_best_cost_0(3), 6));
      else
        winnerswinner3_of_pair_0_2_choices(7) := is_set(winnerswinner2_best_cost_0(2), 6) or (not
          is_set(winnerswinner2_best_cost_0(3), 6));
      end if;
      if is_set(winnerswinner2_best_cost_0(4), 0) then
        winnerswinner3_of_pair_0_4_choice := (not is_set(winnerswinner2_best_cost_0(5), 1)) or (not
          is_set(winnerswinner2_best_cost_0(5), 0));
      else
        winnerswinner3_of_pair_0_4_choice := not is_set(winnerswinner2_best_cost_0(5), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(4), 1) then
        winnerswinner3_of_pair_0_4_choices(2) := winnerswinner3_of_pair_0_4_choice;
      else
        winnerswinner3_of_pair_0_4_choices(2) := is_set(winnerswinner2_best_cost_0(4), 0) and
          ((winnerswinner2_best_cost_0(5) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_4_value := is_set(winnerswinner2_best_cost_0(5), 2);
      if winnerswinner3_of_pair_0_4_choices(2) then
        winnerswinner3_of_pair_0_4_choices(3) := (not is_set(winnerswinner2_best_cost_0(4), 2)) and
          winnerswinner3_of_pair_0_4_value;
      else
        winnerswinner3_of_pair_0_4_choices(3) := (not is_set(winnerswinner2_best_cost_0(4), 2)) or
          winnerswinner3_of_pair_0_4_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner3_of_pair_0_4_values(i) := is_set(winnerswinner2_best_cost_0(5), i + 1);
        if winnerswinner3_of_pair_0_4_choices(i + 1) then
          winnerswinner3_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(4), i + 1)) or
            winnerswinner3_of_pair_0_4_values(i);
        else
          winnerswinner3_of_pair_0_4_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(4), i + 1)) and
            winnerswinner3_of_pair_0_4_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_4_choices(6) then
        winnerswinner3_of_pair_0_4_choices(7) := is_set(winnerswinner2_best_cost_0(4), 6) and (not
          is_set(winnerswinner2_best_cost_0(5), 6));
      else
        winnerswinner3_of_pair_0_4_choices(7) := is_set(winnerswinner2_best_cost_0(4), 6) or (not
          is_set(winnerswinner2_best_cost_0(5), 6));
      end if;
      if is_set(winnerswinner2_best_cost_0(6), 0) then
        winnerswinner3_of_pair_0_6_choice := (not is_set(winnerswinner2_best_cost_0(7), 1)) or (not
          is_set(winnerswinner2_best_cost_0(7), 0));
      else
        winnerswinner3_of_pair_0_6_choice := not is_set(winnerswinner2_best_cost_0(7), 1);
      end if;
      if is_set(winnerswinner2_best_cost_0(6), 1) then
        winnerswinner3_of_pair_0_6_choices(2) := winnerswinner3_of_pair_0_6_choice;
      else
        winnerswinner3_of_pair_0_6_choices(2) := is_set(winnerswinner2_best_cost_0(6), 0) and
          ((winnerswinner2_best_cost_0(7) mod 4) = 0);
      end if;
      winnerswinner3_of_pair_0_6_value := is_set(winnerswinner2_best_cost_0(7), 2);
      if winnerswinner3_of_pair_0_6_choices(2) then
        winnerswinner3_of_pair_0_6_choices(3) := (not is_set(winnerswinner2_best_cost_0(6), 2)) and
          winnerswinner3_of_pair_0_6_value;
      else
        winnerswinner3_of_pair_0_6_choices(3) := (not is_set(winnerswinner2_best_cost_0(6), 2)) or
          winnerswinner3_of_pair_0_6_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner3_of_pair_0_6_values(i) := is_set(winnerswinner2_best_cost_0(7), i + 1);
        if winnerswinner3_of_pair_0_6_choices(i + 1) then
          winnerswinner3_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(6), i + 1)) or
            winnerswinner3_of_pair_0_6_values(i);
        else
          winnerswinner3_of_pair_0_6_choices(i + 2) := (not is_set(winnerswinner2_best_cost_0(6), i + 1)) and
            winnerswinner3_of_pair_0_6_values(i);
        end if;
      end loop;
      if winnerswinner3_of_pair_0_6_choices(6) then
        winnerswinner3_of_pair_0_6_choices(7) := is_set(winnerswinner2_best_cost_0(6), 6) and (not
          is_set(winnerswinner2_best_cost_0(7), 6));
      else
        winnerswinner3_of_pair_0_6_choices(7) := is_set(winnerswinner2_best_cost_0(6), 6) or (not
          is_set(winnerswinner2_best_cost_0(7), 6));
      end if;
      if is_set(winnerswinner3_of_pair_0(1), 0) then
        winnerswinner3_of_four_0_0_choice := (not is_set(winnerswinner3_of_pair_0(3), 0)) and (not
          is_set(winnerswinner3_of_pair_0(2), 0));
      else
        winnerswinner3_of_four_0_0_choice := is_set(winnerswinner3_of_pair_0(0), 0) and (not
          is_set(winnerswinner3_of_pair_0(3), 0)) and (not is_set(winnerswinner3_of_pair_0(2), 0));
      end if;
      winnerswinner3_of_four_0_0_value := is_set(winnerswinner3_of_pair_0(1), 1);
      winnerswinner3_of_four_0_0_values(2) := is_set(winnerswinner3_of_pair_0(0), 1);
      if (not is_set(winnerswinner3_of_pair_0(3), 1)) and (not is_set(winnerswinner3_of_pair_0(2), 1)) then
        winnerswinner3_of_four_0_0_choices(2) := winnerswinner3_of_four_0_0_choice or winnerswinner3_of_four_0_0_value
          or winnerswinner3_of_four_0_0_values(2);
      else
        winnerswinner3_of_four_0_0_choices(2) := winnerswinner3_of_four_0_0_choice and
          (winnerswinner3_of_four_0_0_value or winnerswinner3_of_four_0_0_values(2));
      end if;
      winnerswinner3_of_four_0_0_values(3) := is_set(winnerswinner3_of_pair_0(3), 2);
      winnerswinner3_of_four_0_0_values(4) := is_set(winnerswinner3_of_pair_0(2), 2);
      if winnerswinner3_of_four_0_0_choices(2) then
        winnerswinner3_of_four_0_0_choices(3) := (not is_set(winnerswinner3_of_pair_0(1), 2)) and (not
          is_set(winnerswinner3_of_pair_0(0), 2)) and (winnerswinner3_of_four_0_0_values(3) or
          winnerswinner3_of_four_0_0_values(4));
      else
        winnerswinner3_of_four_0_0_choices(3) := ((not is_set(winnerswinner3_of_pair_0(1), 2)) and (not
          is_set(winnerswinner3_of_pair_0(0), 2))) or winnerswinner3_of_four_0_0_values(3) or
          winnerswinner3_of_four_0_0_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner3_of_four_0_0_values(2 * i - 1) := is_set(winnerswinner3_of_pair_0(3), i);
        winnerswinner3_of_four_0_0_values(2 * i) := is_set(winnerswinner3_of_pair_0(2), i);
        if winnerswinner3_of_four_0_0_choices(i) then
          winnerswinner3_of_four_0_0_choices(i + 1) := ((not is_set(winnerswinner3_of_pair_0(1), i)) and (not
            is_set(winnerswinner3_of_pair_0(0), i))) or winnerswinner3_of_four_0_0_values(2 * i - 1) or
            winnerswinner3_of_four_0_0_values(2 * i);
        else
          winnerswinner3_of_four_0_0_choices(i + 1) := (not is_set(winnerswinner3_of_pair_0(1), i)) and (not
            is_set(winnerswinner3_of_pair_0(0), i)) and (winnerswinner3_of_four_0_0_values(2 * i - 1) or
            winnerswinner3_of_four_0_0_values(2 * i));
        end if;
      end loop;
      if winnerswinner3_of_four_0_0_choices(6) then
        winnerswinner3_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner3_of_pair_0(1), 6)) and (not
          is_set(winnerswinner3_of_pair_0(0), 6)))) and (not is_set(winnerswinner3_of_pair_0(3), 6)) and (not
          is_set(winnerswinner3_of_pair_0(2), 6));
      else
        winnerswinner3_of_four_0_0_choices(7) := (not ((not is_set(winnerswinner3_of_pair_0(1), 6)) and (not
          is_set(winnerswinner3_of_pair_0(0), 6)))) or ((not is_set(winnerswinner3_of_pair_0(3), 6)) and (not
          is_set(winnerswinner3_of_pair_0(2), 6)));
      end if;
      if is_set(winnerswinner3_of_pair_0(5), 0) then
        winnerswinner3_of_four_0_4_choice := (not is_set(winnerswinner3_of_pair_0(7), 0)) and (not
          is_set(winnerswinner3_of_pair_0(6), 0));
      else
        winnerswinner3_of_four_0_4_choice := is_set(winnerswinner3_of_pair_0(4), 0) and (not
          is_set(winnerswinner3_of_pair_0(7), 0)) and (not is_set(winnerswinner3_of_pair_0(6), 0));
      end if;
      winnerswinner3_of_four_0_4_value := is_set(winnerswinner3_of_pair_0(5), 1);
      winnerswinner3_of_four_0_4_values(2) := is_set(winnerswinner3_of_pair_0(4), 1);
      if (not is_set(winnerswinner3_of_pair_0(7), 1)) and (not is_set(winnerswinner3_of_pair_0(6), 1)) then
        winnerswinner3_of_four_0_4_choices(2) := winnerswinner3_of_four_0_4_choice or winnerswinner3_of_four_0_4_value
          or winnerswinner3_of_four_0_4_values(2);
      else
        winnerswinner3_of_four_0_4_choices(2) := winnerswinner3_of_four_0_4_choice and
          (winnerswinner3_of_four_0_4_value or winnerswinner3_of_four_0_4_values(2));
      end if;
      winnerswinner3_of_four_0_4_values(3) := is_set(winnerswinner3_of_pair_0(7), 2);
      winnerswinner3_of_four_0_4_values(4) := is_set(winnerswinner3_of_pair_0(6), 2);
      if winnerswinner3_of_four_0_4_choices(2) then
        winnerswinner3_of_four_0_4_choices(3) := (not is_set(winnerswinner3_of_pair_0(5), 2)) and (not
          is_set(winnerswinner3_of_pair_0(4), 2)) and (winnerswinner3_of_four_0_4_values(3) or
          winnerswinner3_of_four_0_4_values(4));
      else
        winnerswinner3_of_four_0_4_choices(3) := ((not is_set(winnerswinner3_of_pair_0(5), 2)) and (not
          is_set(winnerswinner3_of_pair_0(4), 2))) or winnerswinner3_of_four_0_4_values(3) or
          winnerswinner3_of_four_0_4_values(4);
      end if;
      for i in 3 to 5 loop
        winnerswinner3_of_four_0_4_values(2 * i - 1) := is_set(winnerswinner3_of_pair_0(7), i);
        winnerswinner3_of_four_0_4_values(2 * i) := is_set(winnerswinner3_of_pair_0(6), i);
        if winnerswinner3_of_four_0_4_choices(i) then
          winnerswinner3_of_four_0_4_choices(i + 1) := ((not is_set(winnerswinner3_of_pair_0(5), i)) and (not
            is_set(winnerswinner3_of_pair_0(4), i))) or winnerswinner3_of_four_0_4_values(2 * i - 1) or
            winnerswinner3_of_four_0_4_values(2 * i);
        else
          winnerswinner3_of_four_0_4_choices(i + 1) := (not is_set(winnerswinner3_of_pair_0(5), i)) and (not
            is_set(winnerswinner3_of_pair_0(4), i)) and (winnerswinner3_of_four_0_4_values(2 * i - 1) or
            winnerswinner3_of_four_0_4_values(2 * i));
        end if;
      end loop;
      if winnerswinner3_of_four_0_4_choices(6) then
        winnerswinner3_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner3_of_pair_0(5), 6)) and (not
          is_set(winnerswinner3_of_pair_0(4), 6)))) and (not is_set(winnerswinner3_of_pair_0(7), 6)) and (not
          is_set(winnerswinner3_of_pair_0(6), 6));
      else
        winnerswinner3_of_four_0_4_choices(7) := (not ((not is_set(winnerswinner3_of_pair_0(5), 6)) and (not
          is_set(winnerswinner3_of_pair_0(4), 6)))) or ((not is_set(winnerswinner3_of_pair_0(7), 6)) and (not
          is_set(winnerswinner3_of_pair_0(6), 6)));
      end if;
      winnerswinner3_pair_tag_valid <= winnerswinner2_tag_valid;
      winnerswinner3_pair_tag_map_column <= winnerswinner2_tag_map_column;
      winnerswinner3_pair_tag_output_column <= winnerswinner2_tag_output_column;
      winnerswinner3_pair_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winnerswinner3_pair_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      winnerswinner3_four_tag_valid <= winnerswinner3_pair_tag_valid;
      winnerswinner3_four_tag_map_column <= winnerswinner3_pair_tag_map_column;
      winnerswinner3_four_tag_output_column <= winnerswinner3_pair_tag_output_column;
      winnerswinner3_four_tag_start_of_frame <= winnerswinner3_pair_tag_start_of_frame;
      winnerswinner3_four_tag_end_of_line <= winnerswinner3_pair_tag_end_of_line;
      winnerswinner3_best_cost_0(0) <= to_integer(((((((to_unsigned(winnerswinner3_of_four_0(2), 7)) or
        (to_unsigned(winnerswinner3_of_four_0(3), 7)))) or (to_unsigned(winnerswinner3_of_four_0(1), 7)))) or
        (to_unsigned(winnerswinner3_of_four_0(0), 7))));
      winnerswinner3_best_cost_0(1) <= to_integer(((((((to_unsigned(winnerswinner3_of_four_0(6), 7)) or
        (to_unsigned(winnerswinner3_of_four_0(7), 7)))) or (to_unsigned(winnerswinner3_of_four_0(5), 7)))) or
        (to_unsigned(winnerswinner3_of_four_0(4), 7))));
      winnerswinner3_best_index_0_0 <= winnerswinner3_four_index_0_0;
      winnerswinner3_best_index_0_1 <= winnerswinner3_four_index_0_1;
      winnerswinner3_tag_valid <= winnerswinner3_four_tag_valid;
      winnerswinner3_tag_map_column <= winnerswinner3_four_tag_map_column;
      winnerswinner3_tag_output_column <= winnerswinner3_four_tag_output_column;
      winnerswinner3_tag_start_of_frame <= winnerswinner3_four_tag_start_of_frame;
      winnerswinner3_tag_end_of_line <= winnerswinner3_four_tag_end_of_line;
      if winnerswinner3_of_pair_0_0_choices(7) then
        winnerswinner3_of_pair_0(0) <= 0;
        winnerswinner3_of_pair_0(1) <= winnerswinner2_best_cost_0(1);
        winnerswinner3_pair_index_0_0 <= winnerswinner2_best_index_0_1;
      else
        winnerswinner3_of_pair_0(0) <= winnerswinner2_best_cost_0(0);
        winnerswinner3_of_pair_0(1) <= 0;
        winnerswinner3_pair_index_0_0 <= winnerswinner2_best_index_0_0;
      end if;
      if winnerswinner3_of_pair_0_2_choices(7) then
        winnerswinner3_of_pair_0(2) <= 0;
        winnerswinner3_of_pair_0(3) <= winnerswinner2_best_cost_0(3);
        winnerswinner3_pair_index_0_1 <= winnerswinner2_best_index_0_3;
      else
        winnerswinner3_of_pair_0(2) <= winnerswinner2_best_cost_0(2);
        winnerswinner3_of_pair_0(3) <= 0;
        winnerswinner3_pair_index_0_1 <= winnerswinner2_best_index_0_2;
      end if;
      if winnerswinner3_of_pair_0_4_choices(7) then
        winnerswinner3_of_pair_0(4) <= 0;
        winnerswinner3_of_pair_0(5) <= winnerswinner2_best_cost_0(5);
        winnerswinner3_pair_index_0_2 <= winnerswinner2_best_index_0_5;
      else
        winnerswinner3_of_pair_0(4) <= winnerswinner2_best_cost_0(4);
        winnerswinner3_of_pair_0(5) <= 0;
        winnerswinner3_pair_index_0_2 <= winnerswinner2_best_index_0_4;
      end if;
      if winnerswinner3_of_pair_0_6_choices(7) then
        winnerswinner3_of_pair_0(6) <= 0;
        winnerswinner3_of_pair_0(7) <= winnerswinner2_best_cost_0(7);
        winnerswinner3_pair_index_0_3 <= winnerswinner2_best_index_0_7;
      else
        winnerswinner3_of_pair_0(6) <= winnerswinner2_best_cost_0(6);
        winnerswinner3_of_pair_0(7) <= 0;
        winnerswinner3_pair_index_0_3 <= winnerswinner2_best_index_0_6;
      end if;
      if winnerswinner3_of_four_0_0_choices(7) then
        winnerswinner3_of_four_0(0) <= 0;
        winnerswinner3_of_four_0(1) <= 0;
        winnerswinner3_of_four_0(2) <= winnerswinner3_of_pair_0(2);
        winnerswinner3_of_four_0(3) <= winnerswinner3_of_pair_0(3);
        winnerswinner3_four_index_0_0 <= winnerswinner3_pair_index_0_1;
      else
        winnerswinner3_of_four_0(0) <= winnerswinner3_of_pair_0(0);
        winnerswinner3_of_four_0(1) <= winnerswinner3_of_pair_0(1);
        winnerswinner3_of_four_0(2) <= 0;
        winnerswinner3_of_four_0(3) <= 0;
        winnerswinner3_four_index_0_0 <= winnerswinner3_pair_index_0_0;
      end if;
      if winnerswinner3_of_four_0_4_choices(7) then
        winnerswinner3_of_four_0(4) <= 0;
        winnerswinner3_of_four_0(5) <= 0;
        winnerswinner3_of_four_0(6) <= winnerswinner3_of_pair_0(6);
        winnerswinner3_of_four_0(7) <= winnerswinner3_of_pair_0(7);
        winnerswinner3_four_index_0_1 <= winnerswinner3_pair_index_0_3;
      else
        winnerswinner3_of_four_0(4) <= winnerswinner3_of_pair_0(4);
        winnerswinner3_of_four_0(5) <= winnerswinner3_of_pair_0(5);
        winnerswinner3_of_four_0(6) <= 0;
        winnerswinner3_of_four_0(7) <= 0;
        winnerswinner3_four_index_0_1 <= winnerswinner3_pair_index_0_2;
      end if;
      -- winnerswinner4
      if is_set(winnerswinner3_best_cost_0(0), 0) then
        winnerswinner4_best_index_0_0_choice := (not is_set(winnerswinner3_best_cost_0(1), 1)) or (not
          is_set(winnerswinner3_best_cost_0(1), 0));
      else
        winnerswinner4_best_index_0_0_choice := not is_set(winnerswinner3_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner3_best_cost_0(0), 1) then
        winnerswinner4_best_index_0_0_choices(2) := winnerswinner4_best_index_0_0_choice;
      else
        winnerswinner4_best_index_0_0_choices(2) := is_set(winnerswinner3_best_cost_0(0), 0) and
          ((winnerswinner3_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner4_best_index_0_0_value := is_set(winnerswinner3_best_cost_0(1), 2);
      if winnerswinner4_best_index_0_0_choices(2) then
        winnerswinner4_best_index_0_0_choices(3) := (not is_set(winnerswinner3_best_cost_0(0), 2)) and
          winnerswinner4_best_index_0_0_value;
      else
        winnerswinner4_best_index_0_0_choices(3) := (not is_set(winnerswinner3_best_cost_0(0), 2)) or
          winnerswinner4_best_index_0_0_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner4_best_index_0_0_values(i) := is_set(winnerswinner3_best_cost_0(1), i + 1);
        if winnerswinner4_best_index_0_0_choices(i + 1) then
          winnerswinner4_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner3_best_cost_0(0), i + 1)) or
            winnerswinner4_best_index_0_0_values(i);
        else
          winnerswinner4_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner3_best_cost_0(0), i + 1)) and
            winnerswinner4_best_index_0_0_values(i);
        end if;
      end loop;
      if winnerswinner4_best_index_0_0_choices(6) then
        winnerswinner4_best_index_0_0_choices(7) := is_set(winnerswinner3_best_cost_0(0), 6) and (not
          is_set(winnerswinner3_best_cost_0(1), 6));
      else
        winnerswinner4_best_index_0_0_choices(7) := is_set(winnerswinner3_best_cost_0(0), 6) or (not
          is_set(winnerswinner3_best_cost_0(1), 6));
      end if;
      winnerswinner4_tag_valid <= winnerswinner3_tag_valid;
      winnerswinner4_tag_map_column <= winnerswinner3_tag_map_column;
      winnerswinner4_tag_output_column <= winnerswinner3_tag_output_column;
      winnerswinner4_tag_start_of_frame <= winnerswinner3_tag_start_of_frame;
      winnerswinner4_tag_end_of_line <= winnerswinner3_tag_end_of_line;
      if winnerswinner4_best_index_0_0_choices(7) then
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_1;
      else
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_0;
      end if;
      -- winners
      winners_best_index_0_0 <= winnerswinner4_best_index_0_0;
      winners_best_tag_valid <= winnerswinner4_tag_valid;
      winners_best_tag_map_column <= winnerswinner4_tag_map_column;
      winners_best_tag_output_column <= winnerswinner4_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner4_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner4_tag_end_of_line;
      -- turn
      turn_order_address_any := turn_order_turned_map_column or (not winners_best_tag_map_column) or (not
        winners_best_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 1023;
      else
        turn_order_address_choice := 1;
      end if;
      turn_order_address_any_2 := (not winners_best_tag_map_column) or (not winners_best_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 1024;
        else
          turn_order_address <= as_number((not turn_order_falls)) * 512;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_turned_map_column) and winners_best_tag_map_column and
        winners_best_tag_valid;
      turn_order_complete_all := winners_best_tag_map_column and winners_best_tag_valid;
      turn_ready_tag_row_start_differs := map_counter_group /= 481;
      turn_ready_tag_row_start_is_equal := map_counter_column = 512;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start and (map_counter_group /= 480);
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := map_counter_group = 479;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_valid and turn_ready_tag_map_column;
      turn_order_inside <= winners_best_tag_map_column;
      turn_order_turned_valid <= winners_best_tag_valid;
      turn_order_turned_start_of_frame <= (not turn_order_turned_map_column) and winners_best_tag_map_column and
        winners_best_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= winners_best_tag_end_of_line;
      turn_newest <= winners_best_index_0_0 + 256;
      turn_comes <= turn_order_complete_all;
      turn_read_tag_valid <= turn_order_turned_valid;
      turn_read_tag_map_column <= turn_order_inside;
      turn_read_tag_start_of_frame <= turn_order_turned_start_of_frame;
      turn_read_tag_end_of_line <= turn_order_turned_end_of_line;
      turn_ready <= to_integer(turn_read_words_0);
      turn_ready_tag_valid <= turn_read_tag_valid;
      turn_ready_tag_map_column <= turn_read_tag_map_column;
      turn_ready_tag_start_of_frame <= turn_read_tag_start_of_frame;
      turn_ready_tag_end_of_line <= turn_read_tag_end_of_line;
      if turn_order_falls then
        turn_order_falls <= turn_order_address_any;
      else
        turn_order_falls <= turn_order_falls_all;
      end if;
      if winners_best_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_ready_tag_row_start_choices(3) then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_valid) or (not
          turn_ready_tag_map_column));
      end if;
      if turn_order_falls_all then
        turn_order_output <= winners_best_tag_output_column;
        turn_order_first <= winners_best_tag_start_of_frame;
      end if;
      if winners_best_tag_valid then
        turn_order_turned_map_column <= winners_best_tag_map_column;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- map
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equal then
          map_counter_column <= 0;
        else
          map_counter_column <= (map_counter_column + 1) mod 1024;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        map_counter_group_choice := 15;
      else
        map_counter_group_choice := 0;
      end if;
      map_counter_group_is_equal := map_counter_group = 480;
      if turn_ready_tag_row_start and map_counter_group_is_equal then
        map_counter_group_choices(2) := 1;
      else
        map_counter_group_choices(2) := (map_counter_group + 1) mod 512;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_valid and
        turn_ready_tag_map_column then
        map_counter_group_choices(3) := map_counter_group_choices(2);
      else
        map_counter_group_choices(3) := map_counter_group;
      end if;
      if turn_ready_tag_valid then
        map_line_ended_choice := turn_ready_tag_map_column;
      else
        map_line_ended_choice := map_line_ended;
      end if;
      map_at_arrives_value := other_0(16) = '1';
      map_of_column_0_b_below_a_value := is_set(map_column(1), 2);
      if map_at_top then
        map_of_column_0_b_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_b_below_a_choice := is_set(other_1, 2);
      end if;
      map_of_column_0_b_below_a_values(2) := is_set(map_column(1), 1);
      if map_at_top then
        map_of_column_0_b_below_a_choices(2) := map_of_column_0_b_below_a_values(2);
      else
        map_of_column_0_b_below_a_choices(2) := is_set(other_1, 1);
      end if;
      if map_of_column_0_b_below_a_choices(2) then
        map_of_column_0_b_below_a_choices(3) := (not map_of_column_0_b_below_a_value) or (not
          map_of_column_0_b_below_a_values(2));
      else
        map_of_column_0_b_below_a_choices(3) := not map_of_column_0_b_below_a_value;
      end if;
      if map_of_column_0_b_below_a_choice then
        map_of_column_0_b_below_a_choices(4) := map_of_column_0_b_below_a_choices(3);
      else
        map_of_column_0_b_below_a_choices(4) := map_of_column_0_b_below_a_choices(2) and (((map_column(1) / 2) mod 4) =
          0);
      end if;
      map_of_column_0_b_below_a_values(3) := is_set(map_column(1), 3);
      map_of_column_0_b_below_a_values(4) := is_set(other_1, 3);
      if map_of_column_0_b_below_a_choices(4) then
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) and (not
          map_of_column_0_b_below_a_values(4)) and (not map_at_top);
      else
        map_of_column_0_b_below_a_choices(5) := map_of_column_0_b_below_a_values(3) or (not
          map_of_column_0_b_below_a_values(4)) or map_at_top;
      end if;
      for i in 4 to 6 loop
        map_of_column_0_b_below_a_values(2 * i - 3) := is_set(map_column(1), i);
        map_of_column_0_b_below_a_values(2 * i - 2) := is_set(other_1, i);
        if map_of_column_0_b_below_a_choices(i + 1) then
          map_of_column_0_b_below_a_choices(i + 2) := map_of_column_0_b_below_a_values(2 * i - 3) or (not
            map_of_column_0_b_below_a_values(2 * i - 2)) or map_at_top;
        else
          map_of_column_0_b_below_a_choices(i + 2) := map_of_column_0_b_below_a_values(2 * i - 3) and (not
            map_of_column_0_b_below_a_values(2 * i - 2)) and (not map_at_top);
        end if;
      end loop;
      map_of_column_0_c_below_a_value := is_set(map_column(2), 2);
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choice := map_of_column_0_b_below_a_value;
      else
        map_of_column_0_c_below_a_choice := map_of_column_0_c_below_a_value;
      end if;
      map_of_column_0_c_below_a_values(2) := is_set(map_column(2), 1);
      if map_of_column_0_c_below_a_values(2) then
        map_of_column_0_c_below_a_choices(2) := (not map_of_column_0_b_below_a_values(2)) and map_counter_next_frame;
      else
        map_of_column_0_c_below_a_choices(2) := (not map_of_column_0_b_below_a_values(2)) or (not
          map_counter_next_frame);
      end if;
      if map_of_column_0_c_below_a_choice then
        map_of_column_0_c_below_a_choices(3) := map_of_column_0_b_below_a_choices(2) and
          map_of_column_0_c_below_a_choices(2) and map_of_column_0_b_below_a_choice;
      else
        map_of_column_0_c_below_a_choices(3) := (map_of_column_0_b_below_a_choices(2) and
          map_of_column_0_c_below_a_choices(2)) or map_of_column_0_b_below_a_choice;
      end if;
      for i in 3 to 6 loop
        map_of_column_0_c_below_a_values(i) := is_set(map_column(2), i);
        if map_counter_next_frame then
          map_of_column_0_c_below_a_choices(3 * i - 5) := map_of_column_0_b_below_a_values(2 * i - 3);
        else
          map_of_column_0_c_below_a_choices(3 * i - 5) := map_of_column_0_c_below_a_values(i);
        end if;
        if map_at_top then
          map_of_column_0_c_below_a_choices(3 * i - 4) := map_of_column_0_b_below_a_values(2 * i - 3);
        else
          map_of_column_0_c_below_a_choices(3 * i - 4) := map_of_column_0_b_below_a_values(2 * i - 2);
        end if;
        if map_of_column_0_c_below_a_choices(3 * i - 6) then
          map_of_column_0_c_below_a_choices(3 * i - 3) := (not map_of_column_0_c_below_a_choices(3 * i - 5)) or
            map_of_column_0_c_below_a_choices(3 * i - 4);
        else
          map_of_column_0_c_below_a_choices(3 * i - 3) := (not map_of_column_0_c_below_a_choices(3 * i - 5)) and
            map_of_column_0_c_below_a_choices(3 * i - 4);
        end if;
      end loop;
      if map_counter_next_frame then
        map_of_column_0_c_below_a_choices(16) := is_set(map_column(1), 7);
      else
        map_of_column_0_c_below_a_choices(16) := is_set(map_column(2), 7);
      end if;
      if map_at_top then
        map_of_column_0_c_below_a_choices(17) := is_set(map_column(1), 7);
      else
        map_of_column_0_c_below_a_choices(17) := is_set(other_1, 7);
      end if;
      if (not map_of_column_0_c_below_a_values(2)) and map_of_column_0_b_below_a_values(2) and (not
        map_counter_next_frame) then
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value and (not map_of_column_0_b_below_a_value)
          and (not map_counter_next_frame);
      else
        map_of_column_0_c_below_b_choice := map_of_column_0_c_below_a_value or (not map_of_column_0_b_below_a_value) or
          map_counter_next_frame;
      end if;
      if map_of_column_0_c_below_b_choice then
        map_of_column_0_c_below_b_choices(2) := map_of_column_0_c_below_a_values(3) or (not
          map_of_column_0_b_below_a_values(3)) or map_counter_next_frame;
      else
        map_of_column_0_c_below_b_choices(2) := map_of_column_0_c_below_a_values(3) and (not
          map_of_column_0_b_below_a_values(3)) and (not map_counter_next_frame);
      end if;
      for i in 2 to 4 loop
        if map_of_column_0_c_below_b_choices(i) then
          map_of_column_0_c_below_b_choices(i + 1) := map_of_column_0_c_below_a_values(i + 2) or (not
            map_of_column_0_b_below_a_values(2 * i + 1)) or map_counter_next_frame;
        else
          map_of_column_0_c_below_b_choices(i + 1) := map_of_column_0_c_below_a_values(i + 2) and (not
            map_of_column_0_b_below_a_values(2 * i + 1)) and (not map_counter_next_frame);
        end if;
      end loop;
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
      map_window_complete_is_equal := map_sorted_column = 0;
      if map_window_complete_is_equal then
        map_window_complete_choice := map_sorted_behind;
      else
        map_window_complete_choice := map_sorted_arrives or map_sorted_behind;
      end if;
      map_of_low_0_b_below_a_value := is_set(map_low_0(0), 1);
      if is_set(map_low_0(0), 0) then
        map_of_low_0_b_below_a_choice := (not is_set(map_low_0(1), 1)) or (not is_set(map_low_0(1), 0));
      else
        map_of_low_0_b_below_a_choice := not is_set(map_low_0(1), 1);
      end if;
      map_of_low_0_b_below_a_is_equal := (map_low_0(1) mod 4) = 0;
      if map_of_low_0_b_below_a_value then
        map_of_low_0_b_below_a_choices(2) := map_of_low_0_b_below_a_choice;
      else
        map_of_low_0_b_below_a_choices(2) := is_set(map_low_0(0), 0) and map_of_low_0_b_below_a_is_equal;
      end if;
      map_of_low_0_b_below_a_values(2) := is_set(map_low_0(0), 2);
      map_of_low_0_b_below_a_values(3) := is_set(map_low_0(1), 2);
      if map_of_low_0_b_below_a_choices(2) then
        map_of_low_0_b_below_a_choices(3) := (not map_of_low_0_b_below_a_values(2)) and
          map_of_low_0_b_below_a_values(3);
      else
        map_of_low_0_b_below_a_choices(3) := (not map_of_low_0_b_below_a_values(2)) or map_of_low_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        map_of_low_0_b_below_a_values(2 * i - 2) := is_set(map_low_0(0), i);
        map_of_low_0_b_below_a_values(2 * i - 1) := is_set(map_low_0(1), i);
        if map_of_low_0_b_below_a_choices(i) then
          map_of_low_0_b_below_a_choices(i + 1) := (not map_of_low_0_b_below_a_values(2 * i - 2)) or
            map_of_low_0_b_below_a_values(2 * i - 1);
        else
          map_of_low_0_b_below_a_choices(i + 1) := (not map_of_low_0_b_below_a_values(2 * i - 2)) and
            map_of_low_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_low_0_c_below_a_value := is_set(map_low_0(2), 1);
      if is_set(map_low_0(2), 0) then
        map_of_low_0_c_below_a_choice := not map_of_low_0_b_below_a_value;
      else
        map_of_low_0_c_below_a_choice := (map_low_0(0) mod 4) = 0;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_a_choices(2) := is_set(map_low_0(2), 0) or (not map_of_low_0_b_below_a_value) or (not
          is_set(map_low_0(0), 0));
      else
        map_of_low_0_c_below_a_choices(2) := map_of_low_0_c_below_a_choice;
      end if;
      if map_of_low_0_c_below_a_choices(2) then
        map_of_low_0_c_below_a_choices(3) := (not is_set(map_low_0(2), 2)) and map_of_low_0_b_below_a_values(2);
      else
        map_of_low_0_c_below_a_choices(3) := (not is_set(map_low_0(2), 2)) or map_of_low_0_b_below_a_values(2);
      end if;
      for i in 3 to 5 loop
        if map_of_low_0_c_below_a_choices(i) then
          map_of_low_0_c_below_a_choices(i + 1) := (not is_set(map_low_0(2), i)) or map_of_low_0_b_below_a_values(2 * i
            - 2);
        else
          map_of_low_0_c_below_a_choices(i + 1) := (not is_set(map_low_0(2), i)) and map_of_low_0_b_below_a_values(2 *
            i - 2);
        end if;
      end loop;
      if is_set(map_low_0(2), 0) then
        map_of_low_0_c_below_b_choice := not is_set(map_low_0(1), 1);
      else
        map_of_low_0_c_below_b_choice := map_of_low_0_b_below_a_is_equal;
      end if;
      if map_of_low_0_c_below_a_value then
        map_of_low_0_c_below_b_choices(2) := is_set(map_low_0(2), 0) or (not is_set(map_low_0(1), 1)) or (not
          is_set(map_low_0(1), 0));
      else
        map_of_low_0_c_below_b_choices(2) := map_of_low_0_c_below_b_choice;
      end if;
      if map_of_low_0_c_below_b_choices(2) then
        map_of_low_0_c_below_b_choices(3) := (not is_set(map_low_0(2), 2)) and map_of_low_0_b_below_a_values(3);
      else
        map_of_low_0_c_below_b_choices(3) := (not is_set(map_low_0(2), 2)) or map_of_low_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        if map_of_low_0_c_below_b_choices(i) then
          map_of_low_0_c_below_b_choices(i + 1) := (not is_set(map_low_0(2), i)) or map_of_low_0_b_below_a_values(2 * i
            - 1);
        else
          map_of_low_0_c_below_b_choices(i + 1) := (not is_set(map_low_0(2), i)) and map_of_low_0_b_below_a_values(2 *
            i - 1);
        end if;
      end loop;
      map_of_middle_0_b_below_a_value := is_set(map_middle_0(0), 1);
      if is_set(map_middle_0(0), 0) then
        map_of_middle_0_b_below_a_choice := (not is_set(map_middle_0(1), 1)) or (not is_set(map_middle_0(1), 0));
      else
        map_of_middle_0_b_below_a_choice := not is_set(map_middle_0(1), 1);
      end if;
      map_of_middle_0_b_below_a_is_equal := (map_middle_0(1) mod 4) = 0;
      if map_of_middle_0_b_below_a_value then
        map_of_middle_0_b_below_a_choices(2) := map_of_middle_0_b_below_a_choice;
      else
        map_of_middle_0_b_below_a_choices(2) := is_set(map_middle_0(0), 0) and map_of_middle_0_b_below_a_is_equal;
      end if;
      map_of_middle_0_b_below_a_values(2) := is_set(map_middle_0(0), 2);
      map_of_middle_0_b_below_a_values(3) := is_set(map_middle_0(1), 2);
      if map_of_middle_0_b_below_a_choices(2) then
        map_of_middle_0_b_below_a_choices(3) := (not map_of_middle_0_b_below_a_values(2)) and
          map_of_middle_0_b_below_a_values(3);
      else
        map_of_middle_0_b_below_a_choices(3) := (not map_of_middle_0_b_below_a_values(2)) or
          map_of_middle_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        map_of_middle_0_b_below_a_values(2 * i - 2) := is_set(map_middle_0(0), i);
        map_of_middle_0_b_below_a_values(2 * i - 1) := is_set(map_middle_0(1), i);
        if map_of_middle_0_b_below_a_choices(i) then
          map_of_middle_0_b_below_a_choices(i + 1) := (not map_of_middle_0_b_below_a_values(2 * i - 2)) or
            map_of_middle_0_b_below_a_values(2 * i - 1);
        else
          map_of_middle_0_b_below_a_choices(i + 1) := (not map_of_middle_0_b_below_a_values(2 * i - 2)) and
            map_of_middle_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_middle_0_c_below_a_value := is_set(map_middle_0(2), 1);
      if is_set(map_middle_0(2), 0) then
        map_of_middle_0_c_below_a_choice := not map_of_middle_0_b_below_a_value;
      else
        map_of_middle_0_c_below_a_choice := (map_middle_0(0) mod 4) = 0;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_a_choices(2) := is_set(map_middle_0(2), 0) or (not map_of_middle_0_b_below_a_value) or
          (not is_set(map_middle_0(0), 0));
      else
        map_of_middle_0_c_below_a_choices(2) := map_of_middle_0_c_below_a_choice;
      end if;
      if map_of_middle_0_c_below_a_choices(2) then
        map_of_middle_0_c_below_a_choices(3) := (not is_set(map_middle_0(2), 2)) and
          map_of_middle_0_b_below_a_values(2);
      else
        map_of_middle_0_c_below_a_choices(3) := (not is_set(map_middle_0(2), 2)) or map_of_middle_0_b_below_a_values(2);
      end if;
      for i in 3 to 5 loop
        if map_of_middle_0_c_below_a_choices(i) then
          map_of_middle_0_c_below_a_choices(i + 1) := (not is_set(map_middle_0(2), i)) or
            map_of_middle_0_b_below_a_values(2 * i - 2);
        else
          map_of_middle_0_c_below_a_choices(i + 1) := (not is_set(map_middle_0(2), i)) and
            map_of_middle_0_b_below_a_values(2 * i - 2);
        end if;
      end loop;
      if is_set(map_middle_0(2), 0) then
        map_of_middle_0_c_below_b_choice := not is_set(map_middle_0(1), 1);
      else
        map_of_middle_0_c_below_b_choice := map_of_middle_0_b_below_a_is_equal;
      end if;
      if map_of_middle_0_c_below_a_value then
        map_of_middle_0_c_below_b_choices(2) := is_set(map_middle_0(2), 0) or (not is_set(map_middle_0(1), 1)) or (not
          is_set(map_middle_0(1), 0));
      else
        map_of_middle_0_c_below_b_choices(2) := map_of_middle_0_c_below_b_choice;
      end if;
      if map_of_middle_0_c_below_b_choices(2) then
        map_of_middle_0_c_below_b_choices(3) := (not is_set(map_middle_0(2), 2)) and
          map_of_middle_0_b_below_a_values(3);
      else
        map_of_middle_0_c_below_b_choices(3) := (not is_set(map_middle_0(2), 2)) or map_of_middle_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        if map_of_middle_0_c_below_b_choices(i) then
          map_of_middle_0_c_below_b_choices(i + 1) := (not is_set(map_middle_0(2), i)) or
            map_of_middle_0_b_below_a_values(2 * i - 1);
        else
          map_of_middle_0_c_below_b_choices(i + 1) := (not is_set(map_middle_0(2), i)) and
            map_of_middle_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_high_0_b_below_a_value := is_set(map_high_0(0), 1);
      if is_set(map_high_0(0), 0) then
        map_of_high_0_b_below_a_choice := (not is_set(map_high_0(1), 1)) or (not is_set(map_high_0(1), 0));
      else
        map_of_high_0_b_below_a_choice := not is_set(map_high_0(1), 1);
      end if;
      map_of_high_0_b_below_a_is_equal := (map_high_0(1) mod 4) = 0;
      if map_of_high_0_b_below_a_value then
        map_of_high_0_b_below_a_choices(2) := map_of_high_0_b_below_a_choice;
      else
        map_of_high_0_b_below_a_choices(2) := is_set(map_high_0(0), 0) and map_of_high_0_b_below_a_is_equal;
      end if;
      map_of_high_0_b_below_a_values(2) := is_set(map_high_0(0), 2);
      map_of_high_0_b_below_a_values(3) := is_set(map_high_0(1), 2);
      if map_of_high_0_b_below_a_choices(2) then
        map_of_high_0_b_below_a_choices(3) := (not map_of_high_0_b_below_a_values(2)) and
          map_of_high_0_b_below_a_values(3);
      else
        map_of_high_0_b_below_a_choices(3) := (not map_of_high_0_b_below_a_values(2)) or
          map_of_high_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        map_of_high_0_b_below_a_values(2 * i - 2) := is_set(map_high_0(0), i);
        map_of_high_0_b_below_a_values(2 * i - 1) := is_set(map_high_0(1), i);
        if map_of_high_0_b_below_a_choices(i) then
          map_of_high_0_b_below_a_choices(i + 1) := (not map_of_high_0_b_below_a_values(2 * i - 2)) or
            map_of_high_0_b_below_a_values(2 * i - 1);
        else
          map_of_high_0_b_below_a_choices(i + 1) := (not map_of_high_0_b_below_a_values(2 * i - 2)) and
            map_of_high_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_high_0_c_below_a_value := is_set(map_high_0(2), 1);
      if is_set(map_high_0(2), 0) then
        map_of_high_0_c_below_a_choice := not map_of_high_0_b_below_a_value;
      else
        map_of_high_0_c_below_a_choice := (map_high_0(0) mod 4) = 0;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_a_choices(2) := is_set(map_high_0(2), 0) or (not map_of_high_0_b_below_a_value) or (not
          is_set(map_high_0(0), 0));
      else
        map_of_high_0_c_below_a_choices(2) := map_of_high_0_c_below_a_choice;
      end if;
      if map_of_high_0_c_below_a_choices(2) then
        map_of_high_0_c_below_a_choices(3) := (not is_set(map_high_0(2), 2)) and map_of_high_0_b_below_a_values(2);
      else
        map_of_high_0_c_below_a_choices(3) := (not is_set(map_high_0(2), 2)) or map_of_high_0_b_below_a_values(2);
      end if;
      for i in 3 to 5 loop
        if map_of_high_0_c_below_a_choices(i) then
          map_of_high_0_c_below_a_choices(i + 1) := (not is_set(map_high_0(2), i)) or map_of_high_0_b_below_a_values(2
            * i - 2);
        else
          map_of_high_0_c_below_a_choices(i + 1) := (not is_set(map_high_0(2), i)) and map_of_high_0_b_below_a_values(2
            * i - 2);
        end if;
      end loop;
      if is_set(map_high_0(2), 0) then
        map_of_high_0_c_below_b_choice := not is_set(map_high_0(1), 1);
      else
        map_of_high_0_c_below_b_choice := map_of_high_0_b_below_a_is_equal;
      end if;
      if map_of_high_0_c_below_a_value then
        map_of_high_0_c_below_b_choices(2) := is_set(map_high_0(2), 0) or (not is_set(map_high_0(1), 1)) or (not
          is_set(map_high_0(1), 0));
      else
        map_of_high_0_c_below_b_choices(2) := map_of_high_0_c_below_b_choice;
      end if;
      if map_of_high_0_c_below_b_choices(2) then
        map_of_high_0_c_below_b_choices(3) := (not is_set(map_high_0(2), 2)) and map_of_high_0_b_below_a_values(3);
      else
        map_of_high_0_c_below_b_choices(3) := (not is_set(map_high_0(2), 2)) or map_of_high_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        if map_of_high_0_c_below_b_choices(i) then
          map_of_high_0_c_below_b_choices(i + 1) := (not is_set(map_high_0(2), i)) or map_of_high_0_b_below_a_values(2
            * i - 1);
        else
          map_of_high_0_c_below_b_choices(i + 1) := (not is_set(map_high_0(2), i)) and map_of_high_0_b_below_a_values(2
            * i - 1);
        end if;
      end loop;
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
        map_median_middle_0_choices(2) := map_of_middle_0_b;
      else
        map_median_middle_0_choices(2) := map_median_middle_0_choice;
      end if;
      if map_of_middle_0_c_below_b then
        map_median_middle_0_choices(3) := map_of_middle_0_c;
      else
        map_median_middle_0_choices(3) := map_of_middle_0_b;
      end if;
      if map_of_middle_0_c_below_a then
        map_median_middle_0_choices(4) := map_of_middle_0_a;
      else
        map_median_middle_0_choices(4) := map_median_middle_0_choices(3);
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
      map_of_all_0_b_below_a_value := is_set(map_largest_low_0, 1);
      if is_set(map_largest_low_0, 0) then
        map_of_all_0_b_below_a_choice := (not is_set(map_median_middle_0, 1)) or (not is_set(map_median_middle_0, 0));
      else
        map_of_all_0_b_below_a_choice := not is_set(map_median_middle_0, 1);
      end if;
      map_of_all_0_b_below_a_is_equal := (map_median_middle_0 mod 4) = 0;
      if map_of_all_0_b_below_a_value then
        map_of_all_0_b_below_a_choices(2) := map_of_all_0_b_below_a_choice;
      else
        map_of_all_0_b_below_a_choices(2) := is_set(map_largest_low_0, 0) and map_of_all_0_b_below_a_is_equal;
      end if;
      map_of_all_0_b_below_a_values(2) := is_set(map_largest_low_0, 2);
      map_of_all_0_b_below_a_values(3) := is_set(map_median_middle_0, 2);
      if map_of_all_0_b_below_a_choices(2) then
        map_of_all_0_b_below_a_choices(3) := (not map_of_all_0_b_below_a_values(2)) and
          map_of_all_0_b_below_a_values(3);
      else
        map_of_all_0_b_below_a_choices(3) := (not map_of_all_0_b_below_a_values(2)) or map_of_all_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        map_of_all_0_b_below_a_values(2 * i - 2) := is_set(map_largest_low_0, i);
        map_of_all_0_b_below_a_values(2 * i - 1) := is_set(map_median_middle_0, i);
        if map_of_all_0_b_below_a_choices(i) then
          map_of_all_0_b_below_a_choices(i + 1) := (not map_of_all_0_b_below_a_values(2 * i - 2)) or
            map_of_all_0_b_below_a_values(2 * i - 1);
        else
          map_of_all_0_b_below_a_choices(i + 1) := (not map_of_all_0_b_below_a_values(2 * i - 2)) and
            map_of_all_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      map_of_all_0_c_below_a_value := is_set(map_smallest_high_0, 1);
      if is_set(map_smallest_high_0, 0) then
        map_of_all_0_c_below_a_choice := not map_of_all_0_b_below_a_value;
      else
        map_of_all_0_c_below_a_choice := (map_largest_low_0 mod 4) = 0;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_a_choices(2) := is_set(map_smallest_high_0, 0) or (not map_of_all_0_b_below_a_value) or
          (not is_set(map_largest_low_0, 0));
      else
        map_of_all_0_c_below_a_choices(2) := map_of_all_0_c_below_a_choice;
      end if;
      if map_of_all_0_c_below_a_choices(2) then
        map_of_all_0_c_below_a_choices(3) := (not is_set(map_smallest_high_0, 2)) and map_of_all_0_b_below_a_values(2);
      else
        map_of_all_0_c_below_a_choices(3) := (not is_set(map_smallest_high_0, 2)) or map_of_all_0_b_below_a_values(2);
      end if;
      for i in 3 to 5 loop
        if map_of_all_0_c_below_a_choices(i) then
          map_of_all_0_c_below_a_choices(i + 1) := (not is_set(map_smallest_high_0, i)) or
            map_of_all_0_b_below_a_values(2 * i - 2);
        else
          map_of_all_0_c_below_a_choices(i + 1) := (not is_set(map_smallest_high_0, i)) and
            map_of_all_0_b_below_a_values(2 * i - 2);
        end if;
      end loop;
      if is_set(map_smallest_high_0, 0) then
        map_of_all_0_c_below_b_choice := not is_set(map_median_middle_0, 1);
      else
        map_of_all_0_c_below_b_choice := map_of_all_0_b_below_a_is_equal;
      end if;
      if map_of_all_0_c_below_a_value then
        map_of_all_0_c_below_b_choices(2) := is_set(map_smallest_high_0, 0) or (not is_set(map_median_middle_0, 1)) or
          (not is_set(map_median_middle_0, 0));
      else
        map_of_all_0_c_below_b_choices(2) := map_of_all_0_c_below_b_choice;
      end if;
      if map_of_all_0_c_below_b_choices(2) then
        map_of_all_0_c_below_b_choices(3) := (not is_set(map_smallest_high_0, 2)) and map_of_all_0_b_below_a_values(3);
      else
        map_of_all_0_c_below_b_choices(3) := (not is_set(map_smallest_high_0, 2)) or map_of_all_0_b_below_a_values(3);
      end if;
      for i in 3 to 5 loop
        if map_of_all_0_c_below_b_choices(i) then
          map_of_all_0_c_below_b_choices(i + 1) := (not is_set(map_smallest_high_0, i)) or
            map_of_all_0_b_below_a_values(2 * i - 1);
        else
          map_of_all_0_c_below_b_choices(i + 1) := (not is_set(map_smallest_high_0, i)) and
            map_of_all_0_b_below_a_values(2 * i - 1);
        end if;
      end loop;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choice := map_of_all_0_c;
      else
        map_out_disparity_0_choice := map_of_all_0_a;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(2) := map_of_all_0_b;
      else
        map_out_disparity_0_choices(2) := map_out_disparity_0_choice;
      end if;
      if map_of_all_0_c_below_b then
        map_out_disparity_0_choices(3) := map_of_all_0_c;
      else
        map_out_disparity_0_choices(3) := map_of_all_0_b;
      end if;
      if map_of_all_0_c_below_a then
        map_out_disparity_0_choices(4) := map_of_all_0_a;
      else
        map_out_disparity_0_choices(4) := map_out_disparity_0_choices(3);
      end if;
      map_counter_next_frame <= other_0(40) = '1';
      map_newest_0 <= ((turn_ready mod 128) * 2) + (turn_ready / 256);
      map_arrives <= turn_ready_tag_row_start_all_2;
      map_behind <= map_line_ended and turn_ready_tag_valid;
      map_rows_read_newest_0 <= map_newest_0;
      map_rows_ready_words_0 <= to_integer(map_rows_read_words_0);
      map_rows_ready_newest_0 <= map_rows_read_newest_0;
      map_write_column <= to_integer(other_0(9 downto 0));
      map_column(1) <= map_rows_ready_words_0 / 512;
      map_column(2) <= map_rows_ready_newest_0;
      map_at_arrives <= map_at_arrives_value;
      map_at_behind <= other_0(24) = '1';
      map_at_top <= other_0(32) = '1';
      map_at_output <= other_0(48) = '1';
      map_of_column_0_b <= map_column(1) / 2;
      map_column_passed_0(0) <= is_set(map_column(1), 0);
      map_column_passed_0(1) <= map_column_passed_0(0);
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
      map_window_complete <= map_sorted_output and map_window_complete_choice;
      map_window_first <= map_sorted_top and (map_sorted_column = 1) and map_sorted_arrives;
      map_window_last <= map_sorted_behind;
      map_of_low_0_a <= map_low_0(0);
      map_of_low_0_b <= map_low_0(1);
      map_of_low_0_c <= map_low_0(2);
      map_of_middle_0_a <= map_middle_0(0);
      map_of_middle_0_b <= map_middle_0(1);
      map_of_middle_0_c <= map_middle_0(2);
      map_of_high_0_a <= map_high_0(0);
      map_of_high_0_b <= map_high_0(1);
      map_of_high_0_c <= map_high_0(2);
      map_of_all_0_a <= map_largest_low_0;
      map_of_all_0_b <= map_median_middle_0;
      map_of_all_0_c <= map_smallest_high_0;
      map_waiting_complete(0) <= map_window_complete;
      map_waiting_first(0) <= map_window_first;
      map_waiting_last(0) <= map_window_last;
      map_waiting_complete(1) <= map_waiting_complete(0);
      map_waiting_first(1) <= map_waiting_first(0);
      map_waiting_last(1) <= map_waiting_last(0);
      map_waiting_complete(2) <= map_waiting_complete(1);
      map_waiting_first(2) <= map_waiting_first(1);
      map_waiting_last(2) <= map_waiting_last(1);
      map_waiting_passed_0(0) <= map_passed_0(1);
      map_waiting_passed_0(1) <= map_waiting_passed_0(0);
      map_waiting_passed_0(2) <= map_waiting_passed_0(1);
      map_out_passed_0 <= map_waiting_passed_0(2);
      map_out_valid <= map_waiting_complete(2);
      map_out_start_of_frame <= map_waiting_first(2) and map_waiting_complete(2);
      map_out_end_of_line <= map_waiting_last(2) and map_waiting_complete(2);
      if turn_ready_tag_start_of_frame and turn_ready_tag_valid and turn_ready_tag_map_column then
        map_counter_group <= map_counter_group_choice * 32;
      else
        map_counter_group <= map_counter_group_choices(3);
      end if;
      if turn_ready_tag_end_of_line then
        map_line_ended <= map_line_ended_choice;
      else
        map_line_ended <= map_line_ended and (not turn_ready_tag_valid);
      end if;
      if map_at_top then
        map_of_column_0_a <= map_column(1) / 2;
      else
        map_of_column_0_a <= other_1 / 2;
      end if;
      if map_counter_next_frame then
        map_of_column_0_c <= map_column(1) / 2;
      else
        map_of_column_0_c <= map_column(2) / 2;
      end if;
      if map_of_column_0_b_below_a_choices(8) then
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 7)) and is_set(other_1, 7) and (not map_at_top);
      else
        map_of_column_0_b_below_a <= (not is_set(map_column(1), 7)) or is_set(other_1, 7) or map_at_top;
      end if;
      if map_of_column_0_c_below_a_choices(15) then
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(16)) or
          map_of_column_0_c_below_a_choices(17);
      else
        map_of_column_0_c_below_a <= (not map_of_column_0_c_below_a_choices(16)) and
          map_of_column_0_c_below_a_choices(17);
      end if;
      if map_of_column_0_c_below_b_choices(5) then
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 7)) and is_set(map_column(1), 7) and (not
          map_counter_next_frame);
      else
        map_of_column_0_c_below_b <= (not is_set(map_column(2), 7)) or is_set(map_column(1), 7) or
          map_counter_next_frame;
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
      if map_passed_0(0) then
        map_passed_0(1) <= map_passed_0(1) or map_sorted_arrives or map_sorted_behind;
      else
        map_passed_0(1) <= map_passed_0(1) and (not map_sorted_arrives) and (not map_sorted_behind);
      end if;
      if map_of_low_0_b_below_a_choices(6) then
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 6) and (not is_set(map_low_0(1), 6));
      else
        map_of_low_0_b_below_a <= is_set(map_low_0(0), 6) or (not is_set(map_low_0(1), 6));
      end if;
      if map_of_low_0_c_below_a_choices(6) then
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 6)) or is_set(map_low_0(0), 6);
      else
        map_of_low_0_c_below_a <= (not is_set(map_low_0(2), 6)) and is_set(map_low_0(0), 6);
      end if;
      if map_of_low_0_c_below_b_choices(6) then
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 6)) or is_set(map_low_0(1), 6);
      else
        map_of_low_0_c_below_b <= (not is_set(map_low_0(2), 6)) and is_set(map_low_0(1), 6);
      end if;
      if map_of_middle_0_b_below_a_choices(6) then
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 6) and (not is_set(map_middle_0(1), 6));
      else
        map_of_middle_0_b_below_a <= is_set(map_middle_0(0), 6) or (not is_set(map_middle_0(1), 6));
      end if;
      if map_of_middle_0_c_below_a_choices(6) then
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 6)) or is_set(map_middle_0(0), 6);
      else
        map_of_middle_0_c_below_a <= (not is_set(map_middle_0(2), 6)) and is_set(map_middle_0(0), 6);
      end if;
      if map_of_middle_0_c_below_b_choices(6) then
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 6)) or is_set(map_middle_0(1), 6);
      else
        map_of_middle_0_c_below_b <= (not is_set(map_middle_0(2), 6)) and is_set(map_middle_0(1), 6);
      end if;
      if map_of_high_0_b_below_a_choices(6) then
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 6) and (not is_set(map_high_0(1), 6));
      else
        map_of_high_0_b_below_a <= is_set(map_high_0(0), 6) or (not is_set(map_high_0(1), 6));
      end if;
      if map_of_high_0_c_below_a_choices(6) then
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 6)) or is_set(map_high_0(0), 6);
      else
        map_of_high_0_c_below_a <= (not is_set(map_high_0(2), 6)) and is_set(map_high_0(0), 6);
      end if;
      if map_of_high_0_c_below_b_choices(6) then
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 6)) or is_set(map_high_0(1), 6);
      else
        map_of_high_0_c_below_b <= (not is_set(map_high_0(2), 6)) and is_set(map_high_0(1), 6);
      end if;
      if map_of_low_0_b_below_a then
        map_largest_low_0 <= map_largest_low_0_choice;
      else
        map_largest_low_0 <= map_largest_low_0_choice_2;
      end if;
      if map_of_middle_0_b_below_a then
        map_median_middle_0 <= map_median_middle_0_choices(2);
      else
        map_median_middle_0 <= map_median_middle_0_choices(4);
      end if;
      if map_of_high_0_b_below_a then
        map_smallest_high_0 <= map_smallest_high_0_choice;
      else
        map_smallest_high_0 <= map_smallest_high_0_choice_2;
      end if;
      if map_of_all_0_b_below_a_choices(6) then
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 6) and (not is_set(map_median_middle_0, 6));
      else
        map_of_all_0_b_below_a <= is_set(map_largest_low_0, 6) or (not is_set(map_median_middle_0, 6));
      end if;
      if map_of_all_0_c_below_a_choices(6) then
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 6)) or is_set(map_largest_low_0, 6);
      else
        map_of_all_0_c_below_a <= (not is_set(map_smallest_high_0, 6)) and is_set(map_largest_low_0, 6);
      end if;
      if map_of_all_0_c_below_b_choices(6) then
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 6)) or is_set(map_median_middle_0, 6);
      else
        map_of_all_0_c_below_b <= (not is_set(map_smallest_high_0, 6)) and is_set(map_median_middle_0, 6);
      end if;
      if map_of_all_0_b_below_a then
        map_out_disparity_0 <= map_out_disparity_0_choices(2);
      else
        map_out_disparity_0 <= map_out_disparity_0_choices(4);
      end if;
      if map_at_arrives_value then
        map_rows_write_words_0 <= (map_rows_ready_words_0 / 512) + (map_rows_ready_newest_0 * 512);
        map_at_column <= to_integer(other_0(9 downto 0));
      end if;
      if map_sorted_behind then
        map_low_0_0_choice := map_low_0(0);
      else
        map_low_0_0_choice := map_sorted_low_0;
      end if;
      map_low_0_all(1) := map_window_complete_is_equal and map_sorted_arrives;
      if map_sorted_behind then
        map_middle_0_0_choice := map_middle_0(0);
      else
        map_middle_0_0_choice := map_sorted_middle_0;
      end if;
      if map_sorted_behind then
        map_high_0_0_choice := map_high_0(0);
      else
        map_high_0_0_choice := map_sorted_high_0;
      end if;
      map_low_0_all(0) := (not map_sorted_arrives) and (not map_sorted_behind);
      if not map_low_0_all(0) then
        map_low_0(0) <= map_low_0_0_choice;
        map_low_0(2) <= map_low_0(1);
        map_middle_0(0) <= map_middle_0_0_choice;
        map_middle_0(2) <= map_middle_0(1);
        map_high_0(0) <= map_high_0_0_choice;
        map_high_0(2) <= map_high_0(1);
        if map_low_0_all(1) then
          map_low_0(1) <= map_low_0_0_choice;
          map_middle_0(1) <= map_middle_0_0_choice;
          map_high_0(1) <= map_high_0_0_choice;
        else
          map_low_0(1) <= map_low_0(0);
          map_middle_0(1) <= map_middle_0(0);
          map_high_0(1) <= map_high_0(0);
        end if;
      end if;
      if map_sorted_arrives then
        map_passed_0(0) <= map_column_passed_0(1);
      end if;
      -- other
      if slice0_tag_border_column(4) then
        other_4_choice := 0;
      else
        other_4_choice := slice7cost_single_0(15) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_6_choice := 0;
      else
        other_6_choice := slice7cost_single_0(14) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_8_choice := 0;
      else
        other_8_choice := slice7cost_single_0(13) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_10_choice := 0;
      else
        other_10_choice := slice7cost_single_0(12) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_12_choice := 0;
      else
        other_12_choice := slice7cost_single_0(11) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_14_choice := 0;
      else
        other_14_choice := slice7cost_single_0(10) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_16_choice := 0;
      else
        other_16_choice := slice7cost_single_0(9) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_18_choice := 0;
      else
        other_18_choice := slice7cost_single_0(8) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_20_choice := 0;
      else
        other_20_choice := slice7cost_single_0(7) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_22_choice := 0;
      else
        other_22_choice := slice7cost_single_0(6) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_24_choice := 0;
      else
        other_24_choice := slice7cost_single_0(5) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_26_choice := 0;
      else
        other_26_choice := slice7cost_single_0(4) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_28_choice := 0;
      else
        other_28_choice := slice7cost_single_0(3) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_30_choice := 0;
      else
        other_30_choice := slice7cost_single_0(2) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_32_choice := 0;
      else
        other_32_choice := slice7cost_single_0(1) / 4;
      end if;
      if slice0_tag_border_column(4) then
        other_34_choice := 0;
      else
        other_34_choice := slice7cost_single_0(0) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_36_choice := 0;
      else
        other_36_choice := slice6cost_single_0(15) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_38_choice := 0;
      else
        other_38_choice := slice6cost_single_0(14) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_40_choice := 0;
      else
        other_40_choice := slice6cost_single_0(13) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_42_choice := 0;
      else
        other_42_choice := slice6cost_single_0(12) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_44_choice := 0;
      else
        other_44_choice := slice6cost_single_0(11) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_46_choice := 0;
      else
        other_46_choice := slice6cost_single_0(10) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_48_choice := 0;
      else
        other_48_choice := slice6cost_single_0(9) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_50_choice := 0;
      else
        other_50_choice := slice6cost_single_0(8) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_52_choice := 0;
      else
        other_52_choice := slice6cost_single_0(7) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_54_choice := 0;
      else
        other_54_choice := slice6cost_single_0(6) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_56_choice := 0;
      else
        other_56_choice := slice6cost_single_0(5) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_58_choice := 0;
      else
        other_58_choice := slice6cost_single_0(4) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_60_choice := 0;
      else
        other_60_choice := slice6cost_single_0(3) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_62_choice := 0;
      else
        other_62_choice := slice6cost_single_0(2) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_64_choice := 0;
      else
        other_64_choice := slice6cost_single_0(1) / 4;
      end if;
      if slice0_tag_border_column(3) then
        other_66_choice := 0;
      else
        other_66_choice := slice6cost_single_0(0) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_68_choice := 0;
      else
        other_68_choice := slice5cost_single_0(15) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_70_choice := 0;
      else
        other_70_choice := slice5cost_single_0(14) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_72_choice := 0;
      else
        other_72_choice := slice5cost_single_0(13) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_74_choice := 0;
      else
        other_74_choice := slice5cost_single_0(12) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_76_choice := 0;
      else
        other_76_choice := slice5cost_single_0(11) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_78_choice := 0;
      else
        other_78_choice := slice5cost_single_0(10) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_80_choice := 0;
      else
        other_80_choice := slice5cost_single_0(9) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_82_choice := 0;
      else
        other_82_choice := slice5cost_single_0(8) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_84_choice := 0;
      else
        other_84_choice := slice5cost_single_0(7) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_86_choice := 0;
      else
        other_86_choice := slice5cost_single_0(6) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_88_choice := 0;
      else
        other_88_choice := slice5cost_single_0(5) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_90_choice := 0;
      else
        other_90_choice := slice5cost_single_0(4) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_92_choice := 0;
      else
        other_92_choice := slice5cost_single_0(3) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_94_choice := 0;
      else
        other_94_choice := slice5cost_single_0(2) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_96_choice := 0;
      else
        other_96_choice := slice5cost_single_0(1) / 4;
      end if;
      if slice0_tag_border_column(2) then
        other_98_choice := 0;
      else
        other_98_choice := slice5cost_single_0(0) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_100_choice := 0;
      else
        other_100_choice := slice4cost_single_0(15) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_102_choice := 0;
      else
        other_102_choice := slice4cost_single_0(14) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_104_choice := 0;
      else
        other_104_choice := slice4cost_single_0(13) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_106_choice := 0;
      else
        other_106_choice := slice4cost_single_0(12) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_108_choice := 0;
      else
        other_108_choice := slice4cost_single_0(11) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_110_choice := 0;
      else
        other_110_choice := slice4cost_single_0(10) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_112_choice := 0;
      else
        other_112_choice := slice4cost_single_0(9) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_114_choice := 0;
      else
        other_114_choice := slice4cost_single_0(8) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_116_choice := 0;
      else
        other_116_choice := slice4cost_single_0(7) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_118_choice := 0;
      else
        other_118_choice := slice4cost_single_0(6) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_120_choice := 0;
      else
        other_120_choice := slice4cost_single_0(5) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_122_choice := 0;
      else
        other_122_choice := slice4cost_single_0(4) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_124_choice := 0;
      else
        other_124_choice := slice4cost_single_0(3) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_126_choice := 0;
      else
        other_126_choice := slice4cost_single_0(2) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_128_choice := 0;
      else
        other_128_choice := slice4cost_single_0(1) / 4;
      end if;
      if slice0_tag_border_column(1) then
        other_130_choice := 0;
      else
        other_130_choice := slice4cost_single_0(0) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_132_choice := 0;
      else
        other_132_choice := slice3cost_single_0(15) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_134_choice := 0;
      else
        other_134_choice := slice3cost_single_0(14) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_136_choice := 0;
      else
        other_136_choice := slice3cost_single_0(13) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_138_choice := 0;
      else
        other_138_choice := slice3cost_single_0(12) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_140_choice := 0;
      else
        other_140_choice := slice3cost_single_0(11) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_142_choice := 0;
      else
        other_142_choice := slice3cost_single_0(10) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_144_choice := 0;
      else
        other_144_choice := slice3cost_single_0(9) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_146_choice := 0;
      else
        other_146_choice := slice3cost_single_0(8) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_148_choice := 0;
      else
        other_148_choice := slice3cost_single_0(7) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_150_choice := 0;
      else
        other_150_choice := slice3cost_single_0(6) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_152_choice := 0;
      else
        other_152_choice := slice3cost_single_0(5) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_154_choice := 0;
      else
        other_154_choice := slice3cost_single_0(4) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_156_choice := 0;
      else
        other_156_choice := slice3cost_single_0(3) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_158_choice := 0;
      else
        other_158_choice := slice3cost_single_0(2) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_160_choice := 0;
      else
        other_160_choice := slice3cost_single_0(1) / 4;
      end if;
      if slice0_tag_border_column(0) then
        other_162_choice := 0;
      else
        other_162_choice := slice3cost_single_0(0) / 4;
      end if;
      if slice0window_tag_border_column then
        other_164_choice := 0;
      else
        other_164_choice := slice2cost_single_0(15) / 4;
      end if;
      if slice0window_tag_border_column then
        other_166_choice := 0;
      else
        other_166_choice := slice2cost_single_0(14) / 4;
      end if;
      if slice0window_tag_border_column then
        other_168_choice := 0;
      else
        other_168_choice := slice2cost_single_0(13) / 4;
      end if;
      if slice0window_tag_border_column then
        other_170_choice := 0;
      else
        other_170_choice := slice2cost_single_0(12) / 4;
      end if;
      if slice0window_tag_border_column then
        other_172_choice := 0;
      else
        other_172_choice := slice2cost_single_0(11) / 4;
      end if;
      if slice0window_tag_border_column then
        other_174_choice := 0;
      else
        other_174_choice := slice2cost_single_0(10) / 4;
      end if;
      if slice0window_tag_border_column then
        other_176_choice := 0;
      else
        other_176_choice := slice2cost_single_0(9) / 4;
      end if;
      if slice0window_tag_border_column then
        other_178_choice := 0;
      else
        other_178_choice := slice2cost_single_0(8) / 4;
      end if;
      if slice0window_tag_border_column then
        other_180_choice := 0;
      else
        other_180_choice := slice2cost_single_0(7) / 4;
      end if;
      if slice0window_tag_border_column then
        other_182_choice := 0;
      else
        other_182_choice := slice2cost_single_0(6) / 4;
      end if;
      if slice0window_tag_border_column then
        other_184_choice := 0;
      else
        other_184_choice := slice2cost_single_0(5) / 4;
      end if;
      if slice0window_tag_border_column then
        other_186_choice := 0;
      else
        other_186_choice := slice2cost_single_0(4) / 4;
      end if;
      if slice0window_tag_border_column then
        other_188_choice := 0;
      else
        other_188_choice := slice2cost_single_0(3) / 4;
      end if;
      if slice0window_tag_border_column then
        other_190_choice := 0;
      else
        other_190_choice := slice2cost_single_0(2) / 4;
      end if;
      if slice0window_tag_border_column then
        other_192_choice := 0;
      else
        other_192_choice := slice2cost_single_0(1) / 4;
      end if;
      if slice0window_tag_border_column then
        other_194_choice := 0;
      else
        other_194_choice := slice2cost_single_0(0) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_196_choice := 0;
      else
        other_196_choice := slice1cost_single_0(15) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_198_choice := 0;
      else
        other_198_choice := slice1cost_single_0(14) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_200_choice := 0;
      else
        other_200_choice := slice1cost_single_0(13) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_202_choice := 0;
      else
        other_202_choice := slice1cost_single_0(12) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_204_choice := 0;
      else
        other_204_choice := slice1cost_single_0(11) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_206_choice := 0;
      else
        other_206_choice := slice1cost_single_0(10) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_208_choice := 0;
      else
        other_208_choice := slice1cost_single_0(9) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_210_choice := 0;
      else
        other_210_choice := slice1cost_single_0(8) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_212_choice := 0;
      else
        other_212_choice := slice1cost_single_0(7) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_214_choice := 0;
      else
        other_214_choice := slice1cost_single_0(6) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_216_choice := 0;
      else
        other_216_choice := slice1cost_single_0(5) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_218_choice := 0;
      else
        other_218_choice := slice1cost_single_0(4) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_220_choice := 0;
      else
        other_220_choice := slice1cost_single_0(3) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_222_choice := 0;
      else
        other_222_choice := slice1cost_single_0(2) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_224_choice := 0;
      else
        other_224_choice := slice1cost_single_0(1) / 4;
      end if;
      if slice0cost_tag_border_column then
        other_226_choice := 0;
      else
        other_226_choice := slice1cost_single_0(0) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_228_choice := 0;
      else
        other_228_choice := slice0cost_single_0(15) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_230_choice := 0;
      else
        other_230_choice := slice0cost_single_0(14) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_232_choice := 0;
      else
        other_232_choice := slice0cost_single_0(13) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_234_choice := 0;
      else
        other_234_choice := slice0cost_single_0(12) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_236_choice := 0;
      else
        other_236_choice := slice0cost_single_0(11) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_238_choice := 0;
      else
        other_238_choice := slice0cost_single_0(10) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_240_choice := 0;
      else
        other_240_choice := slice0cost_single_0(9) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_242_choice := 0;
      else
        other_242_choice := slice0cost_single_0(8) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_244_choice := 0;
      else
        other_244_choice := slice0cost_single_0(7) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_246_choice := 0;
      else
        other_246_choice := slice0cost_single_0(6) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_248_choice := 0;
      else
        other_248_choice := slice0cost_single_0(5) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_250_choice := 0;
      else
        other_250_choice := slice0cost_single_0(4) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_252_choice := 0;
      else
        other_252_choice := slice0cost_single_0(3) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_254_choice := 0;
      else
        other_254_choice := slice0cost_single_0(2) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_256_choice := 0;
      else
        other_256_choice := slice0cost_single_0(1) / 4;
      end if;
      if slice0cost_pair_tag_border_column then
        other_258_choice := 0;
      else
        other_258_choice := slice0cost_single_0(0) / 4;
      end if;
      other_0 <= other_2;
      other_1 <= (((map_rows_ready_words_0 mod 512) / 2) mod 128) * 2;
      other_2 <= to_unsigned(as_number(((map_counter_group >= 1) and (map_counter_group < 481))), 1) &
        to_unsigned(as_number(map_counter_group_is_equal), 8) & to_unsigned(as_number((map_counter_group = 1)), 8) &
        to_unsigned(as_number(map_behind), 8) & to_unsigned(as_number(map_arrives), 8) &
        to_unsigned(map_counter_column, 16);
      other(3) <= other(4);
      other(4) <= other_4_choice * 4;
      other(5) <= other(6);
      other(6) <= other_6_choice * 4;
      other(7) <= other(8);
      other(8) <= other_8_choice * 4;
      other(9) <= other(10);
      other(10) <= other_10_choice * 4;
      other(11) <= other(12);
      other(12) <= other_12_choice * 4;
      other(13) <= other(14);
      other(14) <= other_14_choice * 4;
      other(15) <= other(16);
      other(16) <= other_16_choice * 4;
      other(17) <= other(18);
      other(18) <= other_18_choice * 4;
      other(19) <= other(20);
      other(20) <= other_20_choice * 4;
      other(21) <= other(22);
      other(22) <= other_22_choice * 4;
      other(23) <= other(24);
      other(24) <= other_24_choice * 4;
      other(25) <= other(26);
      other(26) <= other_26_choice * 4;
      other(27) <= other(28);
      other(28) <= other_28_choice * 4;
      other(29) <= other(30);
      other(30) <= other_30_choice * 4;
      other(31) <= other(32);
      other(32) <= other_32_choice * 4;
      other(33) <= other(34);
      other(34) <= other_34_choice * 4;
      other(35) <= other(36);
      other(36) <= other_36_choice * 4;
      other(37) <= other(38);
      other(38) <= other_38_choice * 4;
      other(39) <= other(40);
      other(40) <= other_40_choice * 4;
      other(41) <= other(42);
      other(42) <= other_42_choice * 4;
      other(43) <= other(44);
      other(44) <= other_44_choice * 4;
      other(45) <= other(46);
      other(46) <= other_46_choice * 4;
      other(47) <= other(48);
      other(48) <= other_48_choice * 4;
      other(49) <= other(50);
      other(50) <= other_50_choice * 4;
      other(51) <= other(52);
      other(52) <= other_52_choice * 4;
      other(53) <= other(54);
      other(54) <= other_54_choice * 4;
      other(55) <= other(56);
      other(56) <= other_56_choice * 4;
      other(57) <= other(58);
      other(58) <= other_58_choice * 4;
      other(59) <= other(60);
      other(60) <= other_60_choice * 4;
      other(61) <= other(62);
      other(62) <= other_62_choice * 4;
      other(63) <= other(64);
      other(64) <= other_64_choice * 4;
      other(65) <= other(66);
      other(66) <= other_66_choice * 4;
      other(67) <= other(68);
      other(68) <= other_68_choice * 4;
      other(69) <= other(70);
      other(70) <= other_70_choice * 4;
      other(71) <= other(72);
      other(72) <= other_72_choice * 4;
      other(73) <= other(74);
      other(74) <= other_74_choice * 4;
      other(75) <= other(76);
      other(76) <= other_76_choice * 4;
      other(77) <= other(78);
      other(78) <= other_78_choice * 4;
      other(79) <= other(80);
      other(80) <= other_80_choice * 4;
      other(81) <= other(82);
      other(82) <= other_82_choice * 4;
      other(83) <= other(84);
      other(84) <= other_84_choice * 4;
      other(85) <= other(86);
      other(86) <= other_86_choice * 4;
      other(87) <= other(88);
      other(88) <= other_88_choice * 4;
      other(89) <= other(90);
      other(90) <= other_90_choice * 4;
      other(91) <= other(92);
      other(92) <= other_92_choice * 4;
      other(93) <= other(94);
      other(94) <= other_94_choice * 4;
      other(95) <= other(96);
      other(96) <= other_96_choice * 4;
      other(97) <= other(98);
      other(98) <= other_98_choice * 4;
      other(99) <= other(100);
      other(100) <= other_100_choice * 4;
      other(101) <= other(102);
      other(102) <= other_102_choice * 4;
      other(103) <= other(104);
      other(104) <= other_104_choice * 4;
      other(105) <= other(106);
      other(106) <= other_106_choice * 4;
      other(107) <= other(108);
      other(108) <= other_108_choice * 4;
      other(109) <= other(110);
      other(110) <= other_110_choice * 4;
      other(111) <= other(112);
      other(112) <= other_112_choice * 4;
      other(113) <= other(114);
      other(114) <= other_114_choice * 4;
      other(115) <= other(116);
      other(116) <= other_116_choice * 4;
      other(117) <= other(118);
      other(118) <= other_118_choice * 4;
      other(119) <= other(120);
      other(120) <= other_120_choice * 4;
      other(121) <= other(122);
      other(122) <= other_122_choice * 4;
      other(123) <= other(124);
      other(124) <= other_124_choice * 4;
      other(125) <= other(126);
      other(126) <= other_126_choice * 4;
      other(127) <= other(128);
      other(128) <= other_128_choice * 4;
      other(129) <= other(130);
      other(130) <= other_130_choice * 4;
      other(131) <= other(132);
      other(132) <= other_132_choice * 4;
      other(133) <= other(134);
      other(134) <= other_134_choice * 4;
      other(135) <= other(136);
      other(136) <= other_136_choice * 4;
      other(137) <= other(138);
      other(138) <= other_138_choice * 4;
      other(139) <= other(140);
      other(140) <= other_140_choice * 4;
      other(141) <= other(142);
      other(142) <= other_142_choice * 4;
      other(143) <= other(144);
      other(144) <= other_144_choice * 4;
      other(145) <= other(146);
      other(146) <= other_146_choice * 4;
      other(147) <= other(148);
      other(148) <= other_148_choice * 4;
      other(149) <= other(150);
      other(150) <= other_150_choice * 4;
      other(151) <= other(152);
      other(152) <= other_152_choice * 4;
      other(153) <= other(154);
      other(154) <= other_154_choice * 4;
      other(155) <= other(156);
      other(156) <= other_156_choice * 4;
      other(157) <= other(158);
      other(158) <= other_158_choice * 4;
      other(159) <= other(160);
      other(160) <= other_160_choice * 4;
      other(161) <= other(162);
      other(162) <= other_162_choice * 4;
      other(163) <= other(164);
      other(164) <= other_164_choice * 4;
      other(165) <= other(166);
      other(166) <= other_166_choice * 4;
      other(167) <= other(168);
      other(168) <= other_168_choice * 4;
      other(169) <= other(170);
      other(170) <= other_170_choice * 4;
      other(171) <= other(172);
      other(172) <= other_172_choice * 4;
      other(173) <= other(174);
      other(174) <= other_174_choice * 4;
      other(175) <= other(176);
      other(176) <= other_176_choice * 4;
      other(177) <= other(178);
      other(178) <= other_178_choice * 4;
      other(179) <= other(180);
      other(180) <= other_180_choice * 4;
      other(181) <= other(182);
      other(182) <= other_182_choice * 4;
      other(183) <= other(184);
      other(184) <= other_184_choice * 4;
      other(185) <= other(186);
      other(186) <= other_186_choice * 4;
      other(187) <= other(188);
      other(188) <= other_188_choice * 4;
      other(189) <= other(190);
      other(190) <= other_190_choice * 4;
      other(191) <= other(192);
      other(192) <= other_192_choice * 4;
      other(193) <= other(194);
      other(194) <= other_194_choice * 4;
      other(195) <= other(196);
      other(196) <= other_196_choice * 4;
      other(197) <= other(198);
      other(198) <= other_198_choice * 4;
      other(199) <= other(200);
      other(200) <= other_200_choice * 4;
      other(201) <= other(202);
      other(202) <= other_202_choice * 4;
      other(203) <= other(204);
      other(204) <= other_204_choice * 4;
      other(205) <= other(206);
      other(206) <= other_206_choice * 4;
      other(207) <= other(208);
      other(208) <= other_208_choice * 4;
      other(209) <= other(210);
      other(210) <= other_210_choice * 4;
      other(211) <= other(212);
      other(212) <= other_212_choice * 4;
      other(213) <= other(214);
      other(214) <= other_214_choice * 4;
      other(215) <= other(216);
      other(216) <= other_216_choice * 4;
      other(217) <= other(218);
      other(218) <= other_218_choice * 4;
      other(219) <= other(220);
      other(220) <= other_220_choice * 4;
      other(221) <= other(222);
      other(222) <= other_222_choice * 4;
      other(223) <= other(224);
      other(224) <= other_224_choice * 4;
      other(225) <= other(226);
      other(226) <= other_226_choice * 4;
      other(227) <= other(228);
      other(228) <= other_228_choice * 4;
      other(229) <= other(230);
      other(230) <= other_230_choice * 4;
      other(231) <= other(232);
      other(232) <= other_232_choice * 4;
      other(233) <= other(234);
      other(234) <= other_234_choice * 4;
      other(235) <= other(236);
      other(236) <= other_236_choice * 4;
      other(237) <= other(238);
      other(238) <= other_238_choice * 4;
      other(239) <= other(240);
      other(240) <= other_240_choice * 4;
      other(241) <= other(242);
      other(242) <= other_242_choice * 4;
      other(243) <= other(244);
      other(244) <= other_244_choice * 4;
      other(245) <= other(246);
      other(246) <= other_246_choice * 4;
      other(247) <= other(248);
      other(248) <= other_248_choice * 4;
      other(249) <= other(250);
      other(250) <= other_250_choice * 4;
      other(251) <= other(252);
      other(252) <= other_252_choice * 4;
      other(253) <= other(254);
      other(254) <= other_254_choice * 4;
      other(255) <= other(256);
      other(256) <= other_256_choice * 4;
      other(257) <= other(258);
      other(258) <= other_258_choice * 4;
      if reset = '1' then
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 482;
        transform_counter_next_frame <= false;
        transform_read_column <= 0;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        transform_filtering_start_of_frame(0) <= false;
        transform_filtering_valid(0) <= false;
        transform_filtering_start_of_frame(1) <= false;
        transform_filtering_valid(1) <= false;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 480;
        delay_tag_valid <= false;
        delay_tag_first_cost <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_tag_valid <= false;
        rows_tag_first_cost <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        slice0shift_tag_valid <= false;
        slice0shift_tag_first_cost <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_first_cost <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_first_cost <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_first_cost <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        slice0cost_tag_valid <= false;
        slice0cost_tag_first_cost <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        slice0window_tag_valid <= false;
        slice0window_tag_first_cost <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        for i in 0 to 7 loop
          slice0_tag_valid(i) <= false;
          slice0_tag_first_cost(i) <= false;
          slice0_tag_map_column(i) <= false;
          slice0_tag_output_column(i) <= false;
          slice0_tag_start_of_frame(i) <= false;
          slice0_tag_end_of_line(i) <= false;
        end loop;
        entry_next_tag_valid <= false;
        entry_next_tag_map_column <= false;
        entry_next_tag_end_of_line <= false;
        entry_next_column <= 0;
        entry_order_address <= 0;
        entry_order_falls <= false;
        entry_order_inside <= false;
        entry_order_complete <= false;
        entry_order_output <= false;
        entry_order_first <= false;
        entry_order_held_output <= false;
        entry_order_turned_output_column <= false;
        entry_order_turned_start_of_frame <= false;
        entry_tag_valid <= false;
        entry_tag_map_column <= false;
        entry_tag_end_of_line <= false;
        entry_column <= 0;
        entry_place <= 0;
        entry_turned_output_column <= false;
        entry_turned_start_of_frame <= false;
        forward_cost_delay_ring_read_address <= 1;
        forward_cost_delay_ring_write_address <= 0;
        forward_above_delay_ring_read_address <= 1;
        forward_above_delay_ring_write_address <= 0;
        for i in 0 to 12 loop
          forward_above_comes(i) <= false;
        end loop;
        for i in 0 to 12 loop
          forward_above_column(i) <= 0;
        end loop;
        forward_above_writes_copy_0 <= false;
        forward_above_write_column <= 0;
        for i in 0 to 11 loop
          sums_turn_place(i) <= 0;
        end loop;
        sums_turn_writes_copy_0 <= false;
        sums_turn_write_place <= 0;
        sums_sum_delay_ring_read_address <= 1;
        sums_sum_delay_ring_write_address <= 0;
        sums_tag_valid <= false;
        sums_tag_map_column <= false;
        sums_tag_output_column <= false;
        sums_tag_start_of_frame <= false;
        sums_tag_end_of_line <= false;
        for i in 0 to 4 loop
          sums_tags_held_output_column(i) <= false;
          sums_tags_held_start_of_frame(i) <= false;
          sums_tags_held_end_of_line(i) <= false;
        end loop;
        sums_tags_moved <= false;
        winnerswinner1_pair_tag_valid <= false;
        winnerswinner1_pair_tag_map_column <= false;
        winnerswinner1_pair_tag_output_column <= false;
        winnerswinner1_pair_tag_start_of_frame <= false;
        winnerswinner1_pair_tag_end_of_line <= false;
        winnerswinner1_four_tag_valid <= false;
        winnerswinner1_four_tag_map_column <= false;
        winnerswinner1_four_tag_output_column <= false;
        winnerswinner1_four_tag_start_of_frame <= false;
        winnerswinner1_four_tag_end_of_line <= false;
        winnerswinner1_tag_valid <= false;
        winnerswinner1_tag_map_column <= false;
        winnerswinner1_tag_output_column <= false;
        winnerswinner1_tag_start_of_frame <= false;
        winnerswinner1_tag_end_of_line <= false;
        winnerswinner2_pair_tag_valid <= false;
        winnerswinner2_pair_tag_map_column <= false;
        winnerswinner2_pair_tag_output_column <= false;
        winnerswinner2_pair_tag_start_of_frame <= false;
        winnerswinner2_pair_tag_end_of_line <= false;
        winnerswinner2_four_tag_valid <= false;
        winnerswinner2_four_tag_map_column <= false;
        winnerswinner2_four_tag_output_column <= false;
        winnerswinner2_four_tag_start_of_frame <= false;
        winnerswinner2_four_tag_end_of_line <= false;
        winnerswinner2_tag_valid <= false;
        winnerswinner2_tag_map_column <= false;
        winnerswinner2_tag_output_column <= false;
        winnerswinner2_tag_start_of_frame <= false;
        winnerswinner2_tag_end_of_line <= false;
        winnerswinner3_pair_tag_valid <= false;
        winnerswinner3_pair_tag_map_column <= false;
        winnerswinner3_pair_tag_output_column <= false;
        winnerswinner3_pair_tag_start_of_frame <= false;
        winnerswinner3_pair_tag_end_of_line <= false;
        winnerswinner3_four_tag_valid <= false;
        winnerswinner3_four_tag_map_column <= false;
        winnerswinner3_four_tag_output_column <= false;
        winnerswinner3_four_tag_start_of_frame <= false;
        winnerswinner3_four_tag_end_of_line <= false;
        winnerswinner3_tag_valid <= false;
        winnerswinner3_tag_map_column <= false;
        winnerswinner3_tag_output_column <= false;
        winnerswinner3_tag_start_of_frame <= false;
        winnerswinner3_tag_end_of_line <= false;
        winnerswinner4_tag_valid <= false;
        winnerswinner4_tag_map_column <= false;
        winnerswinner4_tag_output_column <= false;
        winnerswinner4_tag_start_of_frame <= false;
        winnerswinner4_tag_end_of_line <= false;
        winners_best_tag_valid <= false;
        winners_best_tag_map_column <= false;
        winners_best_tag_output_column <= false;
        winners_best_tag_start_of_frame <= false;
        winners_best_tag_end_of_line <= false;
        turn_order_address <= 0;
        turn_order_falls <= false;
        turn_order_inside <= false;
        turn_order_complete <= false;
        turn_order_output <= false;
        turn_order_first <= false;
        turn_order_turned_valid <= false;
        turn_order_turned_map_column <= false;
        turn_order_turned_start_of_frame <= false;
        turn_order_turned_end_of_line <= false;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_write_place <= 0;
        turn_ready_tag_valid <= false;
        turn_ready_tag_row_start <= false;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
        map_counter_column <= 0;
        map_counter_group <= 481;
        map_arrives <= false;
        map_behind <= false;
        map_line_ended <= false;
        map_write_column <= 0;
        map_at_column <= 0;
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
        for i in 0 to 2 loop
          map_waiting_complete(i) <= false;
          map_waiting_first(i) <= false;
          map_waiting_last(i) <= false;
        end loop;
        map_out_valid <= false;
        map_out_start_of_frame <= false;
        map_out_end_of_line <= false;
        other_0 <= to_unsigned(0, 49);
        other_2 <= to_unsigned(0, 49);
      end if;
    end if;
  end process;
end architecture;
