-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, semi global, configuration sgm_450_dense: 450x375, 64 disparities, window 3x3, P1 9, P2 40, 1 pixel pair a clock.
-- Options: reference left, census_width_px 9, census_pattern sparse, cost_shift 3, cost_cap 6, p1 9, p2 40,
--   p2_least 15, above_p1 5, above_p2 20, left_right_threshold 1, subpixel true, median true, full_width
--   true, border_cost 3, support_threshold 10, confidence true, margin_weight 4, support_weight 2, fill_holes
--   true, slice_disparities 16.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config sgm_450_dense
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_sgm_450_dense is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 450;
    height_px : positive := 375;
    disparities : positive := 64;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 24;
    output_width_px : positive := 448;
    latency_clocks : positive := 82;
    flush_groups : positive := 4139;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(23 downto 0);
    pixel_valid : out std_logic_vector(0 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 450 report "stereo_core_sgm_450_dense: width_px is " & integer'image(width_px) & " but this core has 450" severity failure;
  assert height_px = 375 report "stereo_core_sgm_450_dense: height_px is " & integer'image(height_px) & " but this core has 375" severity failure;
  assert disparities = 64 report "stereo_core_sgm_450_dense: disparities is " & integer'image(disparities) & " but this core has 64" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_sgm_450_dense: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 24 report "stereo_core_sgm_450_dense: disparity_bits is " & integer'image(disparity_bits) & " but this core has 24" severity failure;
  assert output_width_px = 448 report "stereo_core_sgm_450_dense: output_width_px is " & integer'image(output_width_px) & " but this core has 448" severity failure;
  assert latency_clocks = 82 report "stereo_core_sgm_450_dense: latency_clocks is " & integer'image(latency_clocks) & " but this core has 82" severity failure;
  assert flush_groups = 4139 report "stereo_core_sgm_450_dense: flush_groups is " & integer'image(flush_groups) & " but this core has 4139" severity failure;
  assert gap_groups = 0 report "stereo_core_sgm_450_dense: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_sgm_450_dense is
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
  type boolean_2d is array (natural range <>, natural range <>) of boolean;
  type natural_1023_1d is array (natural range <>) of natural range 0 to 1023;
  type natural_1073741823_1d is array (natural range <>) of natural range 0 to 1073741823;
  type natural_126_1d is array (natural range <>) of natural range 0 to 126;
  type natural_127_1d is array (natural range <>) of natural range 0 to 127;
  type natural_127_2d is array (natural range <>, natural range <>) of natural range 0 to 127;
  type natural_14_1d is array (natural range <>) of natural range 0 to 14;
  type natural_14_2d is array (natural range <>, natural range <>) of natural range 0 to 14;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_15_2d is array (natural range <>, natural range <>) of natural range 0 to 15;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_16383_2d is array (natural range <>, natural range <>) of natural range 0 to 16383;
  type natural_2147483647_1d is array (natural range <>) of natural range 0 to 2147483647;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_257_to_1022_1d is array (natural range <>) of natural range 257 to 1022;
  type natural_268435455_1d is array (natural range <>) of natural range 0 to 268435455;
  type natural_28_1d is array (natural range <>) of natural range 0 to 28;
  type natural_2_2d is array (natural range <>, natural range <>) of natural range 0 to 2;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_32767_1d is array (natural range <>) of natural range 0 to 32767;
  type natural_36_1d is array (natural range <>) of natural range 0 to 36;
  type natural_36_2d is array (natural range <>, natural range <>) of natural range 0 to 36;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_42_1d is array (natural range <>) of natural range 0 to 42;
  type natural_46_1d is array (natural range <>) of natural range 0 to 46;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_5_1d is array (natural range <>) of natural range 0 to 5;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_63_to_127_1d is array (natural range <>) of natural range 63 to 127;
  type natural_7_2d is array (natural range <>, natural range <>) of natural range 0 to 7;
  type natural_84_1d is array (natural range <>) of natural range 0 to 84;
  type unsigned_28_1d is array (natural range <>) of unsigned(27 downto 0);
  type unsigned_30_1d is array (natural range <>) of unsigned(29 downto 0);
  type unsigned_31_1d is array (natural range <>) of unsigned(30 downto 0);
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0 : natural range 0 to 255;
  signal transform_left_rows_ready_newest_0, transform_right_rows_read_newest_0 : natural range 0 to 255;
  signal transform_right_rows_ready_newest_0, transform_left_column_0, transform_left_column_2 : natural range 0 to 255;
  signal transform_left_column_4, transform_right_column_0, transform_right_column_2 : natural range 0 to 255;
  signal transform_right_column_4 : natural range 0 to 255;
  signal transform_left_filter_column_0 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_0
  signal transform_left_filter_column_2 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_2
  signal transform_left_filter_column_4 : natural_255_1d(0 to 8);  -- transform_left_filter_column_#_4
  signal transform_right_filter_column_0 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_0
  signal transform_right_filter_column_2 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_2
  signal transform_right_filter_column_4 : natural_255_1d(0 to 8);  -- transform_right_filter_column_#_4
  signal transform_valid, transform_counter_next_frame, transform_read_row_inside_0 : boolean;
  signal transform_read_row_inside_2, transform_read_row_inside_4, transform_read_column_inside_0 : boolean;
  signal transform_read_column_inside_2, transform_read_column_inside_4, transform_read_column_inside_6 : boolean;
  signal transform_read_column_inside_8, transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside_0, transform_ready_row_inside_2, transform_ready_row_inside_4 : boolean;
  signal transform_ready_column_inside_0, transform_ready_column_inside_2, transform_ready_column_inside_4 : boolean;
  signal transform_ready_column_inside_6, transform_ready_column_inside_8, transform_ready_start_of_frame : boolean;
  signal transform_ready_valid, transform_columns_row_inside_0, transform_columns_row_inside_2 : boolean;
  signal transform_columns_row_inside_4, transform_columns_column_inside_0, transform_columns_column_inside_2 : boolean;
  signal transform_columns_column_inside_4, transform_columns_column_inside_6 : boolean;
  signal transform_columns_column_inside_8, transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside_0, transform_filtering_0_column_inside_2 : boolean;
  signal transform_filtering_0_column_inside_4, transform_filtering_0_column_inside_6 : boolean;
  signal transform_filtering_0_column_inside_8 : boolean;
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- transform_filtering_#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- transform_filtering_#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column : natural range 0 to 511;
  signal transform_ready_column, transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_write_words_0, transform_right_rows_read_words_0 : unsigned(31 downto 0);
  signal transform_right_rows_ready_words_0, transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : natural range 0 to 16383;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 16383;
  signal raster_features_valid, raster_place_next_frame : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ahead_0, delay_delayed_0 : natural range 0 to 16383;
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 2);
  signal delay_tag_valid, delay_tag_map_column, delay_tag_output_column, delay_tag_first_column : boolean;
  signal delay_tag_start_of_frame, delay_tag_end_of_line : boolean;
  -- rows
  signal rows_search_rows_read_words_0, rows_reference_rows_read_words_0 : unsigned(27 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_reference_rows_read_newest_0, rows_reference_rows_ready_newest_0 : natural range 0 to 16383;
  signal rows_search : natural_16383_1d(0 to 2);
  signal rows_reference : natural_16383_1d(0 to 2);
  signal rows_search_rows_ready_words_0, rows_search_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_reference_rows_ready_words_0, rows_reference_rows_write_words_0 : natural range 0 to 268435455;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 2);
  signal rows_read_tag_valid, rows_read_tag_map_column, rows_read_tag_output_column : boolean;
  signal rows_read_tag_first_column, rows_read_tag_start_of_frame, rows_read_tag_end_of_line : boolean;
  signal rows_ready_inside : boolean_1d(0 to 2);
  signal rows_ready_tag_valid, rows_ready_tag_map_column, rows_ready_tag_output_column : boolean;
  signal rows_ready_tag_first_column, rows_ready_tag_start_of_frame, rows_ready_tag_end_of_line : boolean;
  signal rows_tag_valid, rows_tag_map_column, rows_tag_output_column, rows_tag_first_column : boolean;
  signal rows_tag_start_of_frame, rows_tag_end_of_line : boolean;
  -- slice0shift
  signal slice0shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice0shift_reference : natural_16383_1d(0 to 2);
  signal slice0shift_search_out : natural_16383_1d(0 to 2);
  signal slice0shift_tag_valid, slice0shift_tag_map_column, slice0shift_tag_output_column : boolean;
  signal slice0shift_tag_first_column, slice0shift_tag_start_of_frame, slice0shift_tag_end_of_line : boolean;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- slice0cost_pixels_first_#_#_count_#
  signal slice0cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- slice0cost_pixels_first_#_#_count_4
  signal slice0cost_pixels_first_tag_valid, slice0cost_pixels_first_tag_map_column : boolean;
  signal slice0cost_pixels_first_tag_output_column, slice0cost_pixels_first_tag_first_column : boolean;
  signal slice0cost_pixels_first_tag_start_of_frame, slice0cost_pixels_first_tag_end_of_line : boolean;
  signal slice0cost_pixels_tag_valid, slice0cost_pixels_tag_map_column, slice0cost_pixels_tag_output_column : boolean;
  signal slice0cost_pixels_tag_first_column, slice0cost_pixels_tag_start_of_frame : boolean;
  signal slice0cost_pixels_tag_end_of_line, slice0cost_pair_tag_valid, slice0cost_pair_tag_map_column : boolean;
  signal slice0cost_pair_tag_output_column, slice0cost_pair_tag_first_column : boolean;
  signal slice0cost_pair_tag_start_of_frame, slice0cost_pair_tag_end_of_line, slice0cost_tag_valid : boolean;
  signal slice0cost_tag_map_column, slice0cost_tag_output_column, slice0cost_tag_first_column : boolean;
  signal slice0cost_tag_start_of_frame, slice0cost_tag_end_of_line : boolean;
  signal slice0cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice0cost_single_0 : natural_14_1d(0 to 15);
  signal slice0cost_pair_0 : natural_28_1d(0 to 15);
  signal slice0cost_column_0 : natural_42_1d(0 to 15);
  -- slice0window
  signal slice0window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice0window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice0window_centre_map_column_0, slice0window_centre_output_column_0 : boolean;
  signal slice0window_centre_first_column_0, slice0window_centre_start_of_frame_0 : boolean;
  signal slice0window_centre_end_of_line_0, slice0window_tag_valid, slice0window_tag_map_column : boolean;
  signal slice0window_tag_output_column, slice0window_tag_first_column, slice0window_tag_start_of_frame : boolean;
  signal slice0window_tag_end_of_line : boolean;
  signal slice0window_sum_0 : natural_126_1d(0 to 15);
  -- slice0mask
  signal slice0mask_inside : boolean_1d(0 to 15);
  signal slice0mask_left_out : boolean;
  signal slice0mask_column : natural range 0 to 511;
  -- slice0
  signal slice0_held : natural_15_2d(0 to 3, 0 to 15);
  signal slice0_tag_valid : boolean_1d(0 to 3);  -- slice0_tag_#_valid
  signal slice0_tag_map_column : boolean_1d(0 to 3);  -- slice0_tag_#_map_column
  signal slice0_tag_output_column : boolean_1d(0 to 3);  -- slice0_tag_#_output_column
  signal slice0_tag_first_column : boolean_1d(0 to 3);  -- slice0_tag_#_first_column
  signal slice0_tag_start_of_frame : boolean_1d(0 to 3);  -- slice0_tag_#_start_of_frame
  signal slice0_tag_end_of_line : boolean_1d(0 to 3);  -- slice0_tag_#_end_of_line
  -- slice1shift
  signal slice1shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice1shift_reference : natural_16383_1d(0 to 2);
  signal slice1shift_search_out : natural_16383_1d(0 to 2);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- slice1cost_pixels_first_#_#_count_#
  signal slice1cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- slice1cost_pixels_first_#_#_count_4
  signal slice1cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice1cost_single_0 : natural_14_1d(0 to 15);
  signal slice1cost_pair_0 : natural_28_1d(0 to 15);
  signal slice1cost_column_0 : natural_42_1d(0 to 15);
  signal slice1cost_tag_first_column : boolean;
  -- slice1window
  signal slice1window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice1window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice1window_centre_first_column_0, slice1window_tag_first_column : boolean;
  signal slice1window_sum_0 : natural_126_1d(0 to 15);
  -- slice1mask
  signal slice1mask_inside : boolean_1d(0 to 15);
  signal slice1mask_left_out : boolean;
  -- slice1
  signal slice1_held : natural_15_2d(0 to 2, 0 to 15);
  signal slice1_tag_0_first_column : boolean;
  -- slice2shift
  signal slice2shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice2shift_reference : natural_16383_1d(0 to 2);
  signal slice2shift_search_out : natural_16383_1d(0 to 2);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- slice2cost_pixels_first_#_#_count_#
  signal slice2cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- slice2cost_pixels_first_#_#_count_4
  signal slice2cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice2cost_single_0 : natural_14_1d(0 to 15);
  signal slice2cost_pair_0 : natural_28_1d(0 to 15);
  signal slice2cost_column_0 : natural_42_1d(0 to 15);
  signal slice2cost_tag_first_column : boolean;
  -- slice2window
  signal slice2window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice2window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice2window_centre_first_column_0 : boolean;
  signal slice2window_sum_0 : natural_126_1d(0 to 15);
  -- slice2mask
  signal slice2mask_inside : boolean_1d(0 to 15);
  signal slice2mask_left_out : boolean;
  -- slice2
  signal slice2_held : natural_15_2d(0 to 1, 0 to 15);
  -- slice3shift
  signal slice3shift_search : natural_16383_2d(0 to 2, 0 to 15);
  signal slice3shift_reference : natural_16383_1d(0 to 2);
  -- slice3cost
  signal slice3cost_pixels_first_count : natural_3_3d(0 to 2, 0 to 15, 0 to 3);  -- slice3cost_pixels_first_#_#_count_#
  signal slice3cost_pixels_first_count_4 : natural_2_2d(0 to 2, 0 to 15);  -- slice3cost_pixels_first_#_#_count_4
  signal slice3cost_pixels_cost : natural_14_2d(0 to 2, 0 to 15);
  signal slice3cost_single_0 : natural_14_1d(0 to 15);
  signal slice3cost_pair_0 : natural_28_1d(0 to 15);
  signal slice3cost_column_0 : natural_42_1d(0 to 15);
  -- slice3window
  signal slice3window_partial_0_0 : natural_42_1d(0 to 15);
  signal slice3window_partial_0_1 : natural_84_1d(0 to 15);
  signal slice3window_sum_0 : natural_126_1d(0 to 15);
  -- slice3mask
  signal slice3mask_inside : boolean_1d(0 to 15);
  -- slice3
  signal slice3_held_0 : natural_15_1d(0 to 15);
  -- entry
  signal entry_next_cost : natural_15_1d(0 to 63);
  signal entry_cost : natural_15_1d(0 to 63);
  signal entry_next_tag_valid, entry_next_tag_map_column, entry_next_tag_first_column : boolean;
  signal entry_next_tag_end_of_line, entry_next_top, entry_order_falls, entry_order_inside : boolean;
  signal entry_order_complete, entry_order_output, entry_order_first, entry_order_held_output : boolean;
  signal entry_order_turned_output_column, entry_order_turned_first_column, entry_order_turned_start_of_frame : boolean;
  signal entry_tag_valid, entry_tag_map_column, entry_tag_first_column, entry_tag_end_of_line, entry_top : boolean;
  signal entry_turned_output_column, entry_turned_first_column, entry_turned_start_of_frame : boolean;
  signal entry_next_column, entry_order_address, entry_column, entry_place : natural range 0 to 511;
  -- forward
  signal forward_smallest_smallest : natural_15_1d(0 to 31);
  signal forward_smallest_next_smallest : natural_15_1d(0 to 15);
  signal forward_smallest_next_next_smallest : natural_15_1d(0 to 7);
  signal forward_smallest_next_next_next_smallest : natural_15_1d(0 to 3);
  signal forward_smallest_next_next_next_next_smallest : natural_15_1d(0 to 1);
  signal forward_smallest_next_next_next_next_next_smallest_0 : natural range 0 to 15;
  signal forward_above_ready_cost : natural_15_1d(0 to 63);
  signal forward_smallest_cost : natural_15_1d(0 to 4);
  signal forward_cost_delay_ring_read_address, forward_cost_delay_ring_write_address : natural range 0 to 7;
  signal forward_above_delay_ring_read_address, forward_above_delay_ring_write_address : natural range 0 to 7;
  signal forward_cost : natural_7_2d(0 to 3, 0 to 63);
  signal forward_cost_delay_held : unsigned_32_1d(0 to 5);
  signal forward_cost_delay_held_6 : unsigned(13 downto 0);
  signal forward_left_pair : natural_127_1d(0 to 31);
  signal forward_left_tree_smallest : natural_127_1d(0 to 15);
  signal forward_left_tree_next_smallest : natural_127_1d(0 to 7);
  signal forward_left_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal forward_left_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal forward_left_tree_next_next_next_next_smallest_0, forward_left_smallest : natural range 0 to 127;
  signal forward_left_smallest_less, forward_left_relief_leaves : natural range 0 to 127;
  signal forward_left_g_copy : natural_127_1d(0 to 3);
  signal forward_left_g_less_copy : natural_127_1d(0 to 3);
  signal forward_left_stay_change : natural_127_1d(0 to 63);
  signal forward_left_step_change : natural_127_1d(0 to 63);
  signal forward_left_cost : natural_127_1d(0 to 63);
  signal forward_left_arrived : natural_127_1d(0 to 63);
  signal forward_sum : natural_127_1d(0 to 63);
  signal forward_left_start_cost : natural_63_1d(0 to 8);
  signal forward_left_room : natural range 0 to 63;
  signal forward_left_first : boolean_1d(0 to 2);
  signal forward_above_ready_top : boolean;
  signal forward_above_comes : boolean_1d(0 to 11);
  signal forward_above_writes_copy_0 : boolean;
  signal forward_first : boolean_1d(0 to 10);
  signal forward_left_relief_next : natural_31_1d(0 to 3);
  signal forward_left_relief_past : natural_31_1d(0 to 7);
  signal forward_left_relief_pairs : natural_31_1d(0 to 1);
  signal forward_left_relief_fours : natural_31_1d(0 to 2);
  signal forward_left_relief_older, forward_left_relief_recent, forward_left_relief_largest : natural range 0 to 31;
  signal forward_left_relief_beyond : natural range 0 to 31;
  signal forward_above_cost : natural_31_1d(0 to 63);
  signal forward_above_beside : natural_31_1d(0 to 63);
  signal forward_above_own_0 : natural range 0 to 31;
  signal forward_above_own : natural_31_1d(2 to 61);
  signal forward_above_own_63 : natural range 0 to 31;
  signal forward_above_stay : natural_31_1d(0 to 63);
  signal forward_reliefs_moved : natural_31_1d(0 to 10);
  signal forward_left_relief_reach_of_best : natural range 0 to 255;
  signal forward_left_relief_room_of_best : natural range 0 to 158;
  signal forward_left_relief_reach_again : natural range 0 to 222;
  signal forward_above_read_words : unsigned_31_1d(0 to 9);
  signal forward_above_delay_held : unsigned_31_1d(0 to 9);
  signal forward_above_read_words_10, forward_above_delay_held_10 : unsigned(20 downto 0);
  signal forward_above_ready_words : natural_2147483647_1d(0 to 9);
  signal forward_above_write_words : natural_2147483647_1d(0 to 9);
  signal forward_above_ready_words_10, forward_above_write_words_10 : natural range 0 to 2097151;
  signal forward_above_total : natural_46_1d(0 to 63);
  signal forward_above_tree_smallest : natural_46_1d(0 to 31);
  signal forward_above_tree_next_smallest : natural_46_1d(0 to 15);
  signal forward_above_tree_next_next_smallest : natural_46_1d(0 to 7);
  signal forward_above_tree_next_next_next_smallest : natural_46_1d(0 to 3);
  signal forward_above_tree_next_next_next_next_smallest : natural_46_1d(0 to 1);
  signal forward_above_tree_next_next_next_next_next_smallest_0 : natural range 0 to 46;
  signal forward_above_smallest_copy : natural_46_1d(0 to 3);
  signal forward_above_step : natural_36_1d(0 to 63);
  signal forward_above_column : natural_511_1d(0 to 11);
  signal forward_above_write_column : natural range 0 to 511;
  -- sums
  signal sums_turn_read_sums : unsigned_28_1d(0 to 15);
  signal sums_sum_delay_held : unsigned_28_1d(0 to 15);
  signal sums_turn_read_costs : unsigned_30_1d(0 to 5);
  signal sums_turn_read_costs_6 : unsigned(11 downto 0);
  signal sums_turn_read_smallest_0 : unsigned(7 downto 0);
  signal sums_turn_ready_sums : natural_268435455_1d(0 to 15);
  signal sums_turn_write_sums : natural_268435455_1d(0 to 15);
  signal sums_turn_ready_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_write_costs : natural_1073741823_1d(0 to 5);
  signal sums_turn_ready_costs_6, sums_turn_write_costs_6 : natural range 0 to 4095;
  signal sums_turn_ready_smallest_0, sums_turn_write_smallest_0 : natural range 0 to 255;
  signal sums_right_relief_reach_of_best : natural range 0 to 255;
  signal sums_sum_0 : natural_255_1d(0 to 63);
  signal sums_turn_ready_first, sums_turn_writes_copy_0 : boolean;
  signal sums_turn_waiting_first : boolean_1d(0 to 5);
  signal sums_right_first : boolean_1d(0 to 2);
  signal sums_tag_valid, sums_tag_map_column, sums_tag_output_column, sums_tag_first_column : boolean;
  signal sums_tag_start_of_frame, sums_tag_end_of_line : boolean;
  signal sums_tags_held_output_column : boolean_1d(0 to 15);  -- sums_tags_held_#_output_column
  signal sums_tags_held_start_of_frame : boolean_1d(0 to 15);  -- sums_tags_held_#_start_of_frame
  signal sums_tags_held_end_of_line : boolean_1d(0 to 15);  -- sums_tags_held_#_end_of_line
  signal sums_tags_held_map_column : boolean_1d(12 to 15);  -- sums_tags_held_#_map_column
  signal sums_tags_held_first_column : boolean_1d(12 to 15);  -- sums_tags_held_#_first_column
  signal sums_tags_moved : boolean;
  signal sums_turn_place : natural_511_1d(0 to 10);
  signal sums_turn_write_place, sums_turn_waiting_read_place : natural range 0 to 511;
  signal sums_cost : natural_7_2d(0 to 1, 0 to 63);
  signal sums_right_pair : natural_127_1d(0 to 31);
  signal sums_right_tree_smallest : natural_127_1d(0 to 15);
  signal sums_right_tree_next_smallest : natural_127_1d(0 to 7);
  signal sums_right_tree_next_next_smallest : natural_127_1d(0 to 3);
  signal sums_right_tree_next_next_next_smallest : natural_127_1d(0 to 1);
  signal sums_right_tree_next_next_next_next_smallest_0, sums_right_smallest : natural range 0 to 127;
  signal sums_right_smallest_less, sums_right_relief_leaves : natural range 0 to 127;
  signal sums_right_g_copy : natural_127_1d(0 to 3);
  signal sums_right_g_less_copy : natural_127_1d(0 to 3);
  signal sums_right_stay_change : natural_127_1d(0 to 63);
  signal sums_right_step_change : natural_127_1d(0 to 63);
  signal sums_right_cost : natural_127_1d(0 to 63);
  signal sums_right_arrived : natural_127_1d(0 to 63);
  signal sums_right_start_cost : natural_63_1d(0 to 8);
  signal sums_right_room : natural range 0 to 63;
  signal sums_right_relief_next : natural_31_1d(0 to 3);
  signal sums_right_relief_past : natural_31_1d(0 to 7);
  signal sums_right_relief_pairs : natural_31_1d(0 to 1);
  signal sums_right_relief_fours : natural_31_1d(0 to 2);
  signal sums_right_relief_older, sums_right_relief_recent, sums_right_relief_largest : natural range 0 to 31;
  signal sums_right_relief_beyond : natural range 0 to 31;
  signal sums_right_relief_room_of_best : natural range 0 to 158;
  signal sums_right_relief_reach_again : natural range 0 to 222;
  signal sums_sum_delay_ring_read_address, sums_sum_delay_ring_write_address : natural range 0 to 3;
  -- winnersmask
  signal winnersmask_inside : boolean_1d(0 to 63);
  signal winnersmask_column : natural range 0 to 511;
  -- winnersother
  signal winnersother_cost_0 : natural_255_1d(1 to 63);
  signal winnersother_winner_0 : natural_63_1d(0 to 63);
  signal winnersother_winner_out_0 : natural range 0 to 63;
  -- winnerswinner1
  signal winnerswinner1_held_0 : natural_255_1d(0 to 63);
  signal winnerswinner1_best_cost_0 : natural_255_1d(0 to 31);
  signal winnerswinner1_best_below_0 : natural_255_1d(0 to 31);
  signal winnerswinner1_best_above_0 : natural_255_1d(0 to 31);
  signal winnerswinner1_best_late_cost_0 : natural_255_1d(0 to 31);
  signal winnerswinner1_best_but_first_0 : natural_255_1d(1 to 31);
  signal winnerswinner1_best_but_last_0 : natural_255_1d(0 to 30);
  signal winnerswinner1_best_index_0_0, winnerswinner1_best_place_0_2, winnerswinner1_best_place_0_4 : boolean;
  signal winnerswinner1_best_place_0_6, winnerswinner1_best_place_0_8, winnerswinner1_best_place_0_10 : boolean;
  signal winnerswinner1_best_place_0_12, winnerswinner1_best_place_0_14, winnerswinner1_best_place_0_16 : boolean;
  signal winnerswinner1_best_place_0_18, winnerswinner1_best_place_0_20, winnerswinner1_best_place_0_22 : boolean;
  signal winnerswinner1_best_place_0_24, winnerswinner1_best_place_0_26, winnerswinner1_best_place_0_28 : boolean;
  signal winnerswinner1_best_place_0_30, winnerswinner1_tag_valid, winnerswinner1_tag_map_column : boolean;
  signal winnerswinner1_tag_output_column, winnerswinner1_tag_first_column, winnerswinner1_tag_start_of_frame : boolean;
  signal winnerswinner1_tag_end_of_line : boolean;
  signal winnerswinner1_best_index_0_1 : natural range 0 to 3;
  signal winnerswinner1_best_index_0_2 : natural range 0 to 5;
  signal winnerswinner1_best_index_0_3 : natural range 0 to 7;
  signal winnerswinner1_best_index_0_4 : natural range 0 to 9;
  signal winnerswinner1_best_index_0_5 : natural range 0 to 11;
  signal winnerswinner1_best_index_0_6 : natural range 0 to 13;
  signal winnerswinner1_best_index_0_7 : natural range 0 to 15;
  signal winnerswinner1_best_index_0_8 : natural range 0 to 17;
  signal winnerswinner1_best_index_0_9 : natural range 0 to 19;
  signal winnerswinner1_best_index_0_10 : natural range 0 to 21;
  signal winnerswinner1_best_index_0_11 : natural range 0 to 23;
  signal winnerswinner1_best_index_0_12 : natural range 0 to 25;
  signal winnerswinner1_best_index_0_13 : natural range 0 to 27;
  signal winnerswinner1_best_index_0_14 : natural range 0 to 29;
  signal winnerswinner1_best_index_0_15 : natural range 0 to 31;
  signal winnerswinner1_best_index_0_16 : natural range 0 to 33;
  signal winnerswinner1_best_index_0_17 : natural range 0 to 35;
  signal winnerswinner1_best_index_0_18 : natural range 0 to 37;
  signal winnerswinner1_best_index_0_19 : natural range 0 to 39;
  signal winnerswinner1_best_index_0_20 : natural range 0 to 41;
  signal winnerswinner1_best_index_0_21 : natural range 0 to 43;
  signal winnerswinner1_best_index_0_22 : natural range 0 to 45;
  signal winnerswinner1_best_index_0_23 : natural range 0 to 47;
  signal winnerswinner1_best_index_0_24 : natural range 0 to 49;
  signal winnerswinner1_best_index_0_25 : natural range 0 to 51;
  signal winnerswinner1_best_index_0_26 : natural range 0 to 53;
  signal winnerswinner1_best_index_0_27 : natural range 0 to 55;
  signal winnerswinner1_best_index_0_28 : natural range 0 to 57;
  signal winnerswinner1_best_index_0_29 : natural range 0 to 59;
  signal winnerswinner1_best_index_0_30 : natural range 0 to 61;
  signal winnerswinner1_best_index_0_31 : natural range 0 to 63;
  -- winnerswinner2
  signal winnerswinner2_best_cost_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_below_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_above_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_first_0 : natural_255_1d(1 to 15);
  signal winnerswinner2_best_last_0 : natural_255_1d(0 to 14);
  signal winnerswinner2_best_late_cost_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_second_0 : natural_255_1d(0 to 15);
  signal winnerswinner2_best_but_first_0 : natural_255_1d(1 to 15);
  signal winnerswinner2_best_but_last_0 : natural_255_1d(0 to 14);
  signal winnerswinner2_best_index_0_0 : natural range 0 to 3;
  signal winnerswinner2_best_index_0_1 : natural range 0 to 7;
  signal winnerswinner2_best_index_0_2 : natural range 0 to 11;
  signal winnerswinner2_best_index_0_3 : natural range 0 to 15;
  signal winnerswinner2_best_index_0_4 : natural range 0 to 19;
  signal winnerswinner2_best_index_0_5 : natural range 0 to 23;
  signal winnerswinner2_best_index_0_6 : natural range 0 to 27;
  signal winnerswinner2_best_index_0_7 : natural range 0 to 31;
  signal winnerswinner2_best_index_0_8 : natural range 0 to 35;
  signal winnerswinner2_best_index_0_9 : natural range 0 to 39;
  signal winnerswinner2_best_index_0_10 : natural range 0 to 43;
  signal winnerswinner2_best_index_0_11 : natural range 0 to 47;
  signal winnerswinner2_best_index_0_12 : natural range 0 to 51;
  signal winnerswinner2_best_index_0_13 : natural range 0 to 55;
  signal winnerswinner2_best_index_0_14 : natural range 0 to 59;
  signal winnerswinner2_best_index_0_15 : natural range 0 to 63;
  signal winnerswinner2_best_place_0 : boolean_1d(0 to 15);
  signal winnerswinner2_best_at_start_0 : boolean_1d(0 to 15);
  signal winnerswinner2_best_at_end_0 : boolean_1d(0 to 15);
  signal winnerswinner2_tag_valid, winnerswinner2_tag_map_column, winnerswinner2_tag_output_column : boolean;
  signal winnerswinner2_tag_first_column, winnerswinner2_tag_start_of_frame, winnerswinner2_tag_end_of_line : boolean;
  -- winnerswinner3
  signal winnerswinner3_best_cost_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_below_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_above_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_first_0 : natural_255_1d(1 to 7);
  signal winnerswinner3_best_last_0 : natural_255_1d(0 to 6);
  signal winnerswinner3_best_late_cost_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_second_0 : natural_255_1d(0 to 7);
  signal winnerswinner3_best_but_first_0 : natural_255_1d(1 to 7);
  signal winnerswinner3_best_but_last_0 : natural_255_1d(0 to 6);
  signal winnerswinner3_best_index_0_0 : natural range 0 to 7;
  signal winnerswinner3_best_index_0_1 : natural range 0 to 15;
  signal winnerswinner3_best_index_0_2 : natural range 0 to 23;
  signal winnerswinner3_best_index_0_3 : natural range 0 to 31;
  signal winnerswinner3_best_index_0_4 : natural range 0 to 39;
  signal winnerswinner3_best_index_0_5 : natural range 0 to 47;
  signal winnerswinner3_best_index_0_6 : natural range 0 to 55;
  signal winnerswinner3_best_index_0_7 : natural range 0 to 63;
  signal winnerswinner3_best_place_0 : boolean_1d(0 to 7);
  signal winnerswinner3_best_at_start_0 : boolean_1d(0 to 7);
  signal winnerswinner3_best_at_end_0 : boolean_1d(0 to 7);
  signal winnerswinner3_tag_valid, winnerswinner3_tag_map_column, winnerswinner3_tag_output_column : boolean;
  signal winnerswinner3_tag_first_column, winnerswinner3_tag_start_of_frame, winnerswinner3_tag_end_of_line : boolean;
  -- winnerswinner4
  signal winnerswinner4_best_cost_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_below_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_above_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_first_0 : natural_255_1d(1 to 3);
  signal winnerswinner4_best_last_0 : natural_255_1d(0 to 2);
  signal winnerswinner4_best_late_cost_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_second_0 : natural_255_1d(0 to 3);
  signal winnerswinner4_best_but_first_0 : natural_255_1d(1 to 3);
  signal winnerswinner4_best_but_last_0 : natural_255_1d(0 to 2);
  signal winnerswinner4_best_index_0_0 : natural range 0 to 15;
  signal winnerswinner4_best_index_0_1 : natural range 0 to 31;
  signal winnerswinner4_best_index_0_2 : natural range 0 to 47;
  signal winnerswinner4_best_index_0_3 : natural range 0 to 63;
  signal winnerswinner4_best_place_0 : boolean_1d(0 to 3);
  signal winnerswinner4_best_at_start_0 : boolean_1d(0 to 3);
  signal winnerswinner4_best_at_end_0 : boolean_1d(0 to 3);
  signal winnerswinner4_tag_valid, winnerswinner4_tag_map_column, winnerswinner4_tag_output_column : boolean;
  signal winnerswinner4_tag_first_column, winnerswinner4_tag_start_of_frame, winnerswinner4_tag_end_of_line : boolean;
  -- winnerswinner5
  signal winnerswinner5_best_cost_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_below_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_above_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_first_0_1, winnerswinner5_best_last_0_0 : natural range 0 to 255;
  signal winnerswinner5_best_late_cost_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_second_0 : natural_255_1d(0 to 1);
  signal winnerswinner5_best_but_first_0_1, winnerswinner5_best_but_last_0_0 : natural range 0 to 255;
  signal winnerswinner5_best_index_0_0 : natural range 0 to 31;
  signal winnerswinner5_best_index_0_1 : natural range 0 to 63;
  signal winnerswinner5_best_place_0 : boolean_1d(0 to 1);
  signal winnerswinner5_best_at_start_0 : boolean_1d(0 to 1);
  signal winnerswinner5_best_at_end_0 : boolean_1d(0 to 1);
  signal winnerswinner5_tag_valid, winnerswinner5_tag_map_column, winnerswinner5_tag_output_column : boolean;
  signal winnerswinner5_tag_first_column, winnerswinner5_tag_start_of_frame, winnerswinner5_tag_end_of_line : boolean;
  -- winnerswinner6
  signal winnerswinner6_best_cost_0_0, winnerswinner6_best_below_0_0 : natural range 0 to 255;
  signal winnerswinner6_best_above_0_0, winnerswinner6_best_late_cost_0_0 : natural range 0 to 255;
  signal winnerswinner6_best_second_0_0 : natural range 0 to 255;
  signal winnerswinner6_best_index_0_0 : natural range 0 to 63;
  signal winnerswinner6_best_place_0_0, winnerswinner6_best_at_start_0_0, winnerswinner6_best_at_end_0_0 : boolean;
  signal winnerswinner6_tag_valid, winnerswinner6_tag_map_column, winnerswinner6_tag_output_column : boolean;
  signal winnerswinner6_tag_first_column, winnerswinner6_tag_start_of_frame, winnerswinner6_tag_end_of_line : boolean;
  -- winners
  signal winners_best_index_0_0 : natural range 0 to 63;
  signal winners_best_below_0_0, winners_best_above_0_0, winners_best_late_cost_0_0 : natural range 0 to 255;
  signal winners_best_second_0_0 : natural range 0 to 255;
  signal winners_best_place_0, winners_best_tag_valid, winners_best_tag_map_column : boolean;
  signal winners_best_tag_output_column, winners_best_tag_start_of_frame, winners_best_tag_end_of_line : boolean;
  signal winners_partner_column : natural range 0 to 511;
  signal winners_partner_at : natural range 0 to 575;
  -- refinement
  signal refinement_disparity_0 : natural_63_1d(0 to 11);  -- refinement_disparity_#_0
  signal refinement_margin_0 : natural_63_1d(0 to 9);  -- refinement_margin_#_0
  signal refinement_passed_0 : boolean_1d(0 to 11);  -- refinement_passed_#_0
  signal refinement_tag_valid : boolean_1d(0 to 11);  -- refinement_tag_#_valid
  signal refinement_tag_map_column : boolean_1d(0 to 11);  -- refinement_tag_#_map_column
  signal refinement_tag_output_column : boolean_1d(0 to 11);  -- refinement_tag_#_output_column
  signal refinement_tag_start_of_frame : boolean_1d(0 to 11);  -- refinement_tag_#_start_of_frame
  signal refinement_tag_end_of_line : boolean_1d(0 to 11);  -- refinement_tag_#_end_of_line
  signal refinement_alone_0_0 : boolean;
  signal refinement_negative_0 : boolean_1d(0 to 8);  -- refinement_negative_#_0
  signal refinement_gap_0, refinement_below_0, refinement_above_0, refinement_u_0 : natural range 0 to 255;
  signal refinement_v_0 : natural range 0 to 255;
  signal refinement_remainder_0 : natural_255_1d(0 to 7);  -- refinement_remainder_#_0
  signal refinement_divisor_0 : natural_255_1d(0 to 7);  -- refinement_divisor_#_0
  signal refinement_quotient_8_0 : natural range 0 to 255;
  signal refinement_difference_0 : integer range -255 to 255;
  signal refinement_fraction_0 : natural range 0 to 31;
  -- leftright
  signal leftright_other_0 : natural_63_1d(1 to 17);  -- leftright_other_#_0
  signal leftright_ring_read_address, leftright_ring_write_address : natural range 0 to 63;
  signal leftright_asking_disparity_0, leftright_asking_margin_0 : natural range 0 to 63;
  signal leftright_answered_disparity_0, leftright_answered_margin_0 : natural range 0 to 63;
  signal leftright_checked_disparity_0, leftright_checked_margin_0 : natural range 0 to 63;
  signal leftright_holds_winners, leftright_held_valid, leftright_asking_passed_0, leftright_asking_tag_valid : boolean;
  signal leftright_asking_tag_map_column, leftright_asking_tag_output_column : boolean;
  signal leftright_asking_tag_start_of_frame, leftright_asking_tag_end_of_line, leftright_answered_passed_0 : boolean;
  signal leftright_answered_tag_valid, leftright_answered_tag_map_column : boolean;
  signal leftright_answered_tag_output_column, leftright_answered_tag_start_of_frame : boolean;
  signal leftright_answered_tag_end_of_line, leftright_checked_passed_0, leftright_checked_tag_valid : boolean;
  signal leftright_checked_tag_map_column, leftright_checked_tag_output_column : boolean;
  signal leftright_checked_tag_start_of_frame, leftright_checked_tag_end_of_line : boolean;
  signal leftright_position, leftright_held_position, leftright_address_0 : natural range 0 to 127;
  signal leftright_held_0 : unsigned(17 downto 0);
  signal leftright_held_1, leftright_found_0 : unsigned(5 downto 0);
  signal leftright_asking_fraction_0, leftright_answered_fraction_0 : natural range 0 to 31;
  signal leftright_checked_fraction_0 : natural range 0 to 31;
  -- turn
  signal turn_order_address, turn_write_place : natural range 0 to 511;
  signal turn_order_falls, turn_order_inside, turn_order_complete, turn_order_output, turn_order_first : boolean;
  signal turn_order_turned_valid, turn_order_turned_map_column, turn_order_turned_start_of_frame : boolean;
  signal turn_order_turned_end_of_line, turn_comes, turn_read_tag_valid, turn_read_tag_map_column : boolean;
  signal turn_read_tag_start_of_frame, turn_read_tag_end_of_line, turn_ready_tag_valid : boolean;
  signal turn_ready_tag_row_start, turn_ready_tag_map_column, turn_ready_tag_start_of_frame : boolean;
  signal turn_ready_tag_end_of_line : boolean;
  signal turn_newest, turn_write_words_0 : natural range 0 to 1048383;
  signal turn_read_words_0 : unsigned(19 downto 0);
  signal turn_ready : natural range 0 to 1048575;
  -- support
  signal support_counter_column, support_counter_group, support_read_column : natural range 0 to 511;
  signal support_ready_column, support_write_column : natural range 0 to 511;
  signal support_newest_0, support_rows_read_newest_0, support_rows_ready_newest_0 : natural range 0 to 127;
  signal support_column : natural_127_1d(0 to 4);
  signal support_cells : natural_127_2d(0 to 12, 0 to 4);
  signal support_centre_0 : natural_127_1d(0 to 2);  -- support_centre_#_0
  signal support_newest_rest_0, support_rest_rows_read_newest_0 : natural range 0 to 1023;
  signal support_rest_rows_ready_newest_0, support_column_rest_0 : natural range 0 to 1023;
  signal support_rest_0 : natural_1023_1d(0 to 6);  -- support_rest_#_0
  signal support_centre_rest_0 : natural_1023_1d(0 to 2);  -- support_centre_rest_#_0
  signal support_out_disparity_0 : natural range 0 to 1023;
  signal support_moves, support_arrives, support_last, support_read_moves, support_read_arrives : boolean;
  signal support_read_above2, support_read_above1, support_read_below1, support_read_below2 : boolean;
  signal support_read_first, support_read_last, support_ready_moves, support_ready_arrives : boolean;
  signal support_ready_above2, support_ready_above1, support_ready_below1, support_ready_below2 : boolean;
  signal support_ready_first, support_ready_last, support_at_moves, support_at_arrives, support_at_first : boolean;
  signal support_at_last : boolean;
  signal support_row_tag : boolean_1d(0 to 12);
  signal support_moment_map_column : boolean_1d(0 to 6);  -- support_moment_#_map_column
  signal support_moment_start_of_frame : boolean_1d(0 to 6);  -- support_moment_#_start_of_frame
  signal support_moment_last : boolean_1d(0 to 6);  -- support_moment_#_last
  signal support_next_tag, support_moved : boolean;
  signal support_like_0 : boolean_2d(0 to 6, 0 to 4);
  signal support_enough_0 : boolean;
  signal support_centre_moment_map_column : boolean_1d(0 to 3);  -- support_centre_moment_#_map_column
  signal support_centre_moment_start_of_frame : boolean_1d(0 to 3);  -- support_centre_moment_#_start_of_frame
  signal support_centre_moment_last : boolean_1d(0 to 3);  -- support_centre_moment_#_last
  signal support_centre_moved : boolean_1d(0 to 3);
  signal support_out_passed_0, support_out_tag_valid, support_out_tag_row_start, support_out_tag_map_column : boolean;
  signal support_out_tag_start_of_frame, support_out_tag_end_of_line : boolean;
  signal support_rows_read_words_0 : unsigned(27 downto 0);
  signal support_rows_ready_words_0, support_rows_write_words_0 : natural range 0 to 268435455;
  signal support_rest_rows_read_words_0 : unsigned(19 downto 0);
  signal support_rest_rows_ready_words_0, support_rest_rows_write_words_0 : natural range 0 to 1048575;
  signal support_partial_0 : natural_5_1d(0 to 6);
  signal support_count_0 : natural range 0 to 35;
  signal support_sum_0 : natural range 0 to 322;
  signal support_out_sure_0 : natural range 0 to 255;
  -- fill
  signal fill_counter_column, fill_counter_group, fill_read_column, fill_ready_column : natural range 0 to 511;
  signal fill_write_column, fill_at_column : natural range 0 to 511;
  signal fill_asking_at_column : natural_511_1d(0 to 1);  -- fill_asking_at_#_column
  signal fill_known_at_column, fill_beside_0_left_column, fill_beside_0_right_column : natural range 0 to 511;
  signal fill_measured_at_column, fill_measured_beside_0_right_column, fill_width_0 : natural range 0 to 511;
  signal fill_chosen_at_column, fill_write_above_column : natural range 0 to 511;
  signal fill_newest_disparity_0, fill_pixel_0_disparity : natural range 0 to 1023;
  signal fill_asking_0_disparity : natural_1023_1d(0 to 1);  -- fill_asking_#_0_disparity
  signal fill_known_0_disparity, fill_beside_0_left, fill_beside_0_right : natural range 0 to 1023;
  signal fill_measured_0_disparity, fill_measured_beside_0_left, fill_measured_beside_0_right : natural range 0 to 1023;
  signal fill_chosen_0_disparity, fill_chosen_beside_0_left, fill_chosen_beside_0_right : natural range 0 to 1023;
  signal fill_newest_passed_0, fill_moves, fill_arrives, fill_last, fill_read_moves, fill_read_arrives : boolean;
  signal fill_read_top, fill_read_last, fill_ready_moves, fill_ready_arrives, fill_ready_top, fill_ready_last : boolean;
  signal fill_ends_open_0, fill_pixel_0_passed, fill_at_moves, fill_at_arrives, fill_at_top, fill_at_last : boolean;
  signal fill_in_hole_0 : boolean;
  signal fill_asking_0_passed : boolean_1d(0 to 1);  -- fill_asking_#_0_passed
  signal fill_asking_at_moves : boolean_1d(0 to 1);  -- fill_asking_at_#_moves
  signal fill_asking_at_arrives : boolean_1d(0 to 1);  -- fill_asking_at_#_arrives
  signal fill_asking_at_top : boolean_1d(0 to 1);  -- fill_asking_at_#_top
  signal fill_asking_at_last : boolean_1d(0 to 1);  -- fill_asking_at_#_last
  signal fill_hole_starts_0 : boolean_1d(0 to 1);  -- fill_hole_starts_#_0
  signal fill_known_0_passed, fill_known_at_moves, fill_known_at_arrives, fill_known_at_top : boolean;
  signal fill_known_at_last, fill_beside_0_has_left, fill_beside_0_has_right, fill_measured_0_passed : boolean;
  signal fill_measured_at_moves, fill_measured_at_arrives, fill_measured_at_top, fill_measured_at_last : boolean;
  signal fill_measured_beside_0_has_left, fill_measured_beside_0_has_right, fill_rises_0 : boolean;
  signal fill_chosen_0_passed, fill_chosen_at_moves, fill_chosen_at_arrives, fill_chosen_at_top : boolean;
  signal fill_chosen_at_last, fill_chosen_beside_0_has_left, fill_chosen_beside_0_has_right : boolean;
  signal fill_takes_left_0, fill_out_passed_0, fill_out_filled_0, fill_out_tag_valid, fill_out_tag_row_start : boolean;
  signal fill_out_tag_map_column, fill_out_tag_start_of_frame, fill_out_tag_end_of_line, fill_has_values : boolean;
  signal fill_had_values : boolean;
  signal fill_newest_sure_0, fill_ends_next_place_0, fill_ends_row_place_0 : natural range 0 to 255;
  signal fill_ends_row_above_place_0, fill_ends_write_place_0, fill_ends_read_place_0 : natural range 0 to 255;
  signal fill_pixel_0_sure : natural range 0 to 255;
  signal fill_asking_0_sure : natural_255_1d(0 to 1);  -- fill_asking_#_0_sure
  signal fill_known_0_sure, fill_measured_0_sure, fill_chosen_0_sure, fill_out_sure_0 : natural range 0 to 255;
  signal fill_rows_read_words_0 : unsigned(18 downto 0);
  signal fill_rows_read_newest_0, fill_rows_ready_words_0, fill_rows_ready_newest_0 : natural range 0 to 524287;
  signal fill_rows_write_words_0 : natural range 0 to 524287;
  signal fill_ends_write_words_0, fill_ends_ready_words_0 : natural range 0 to 1048575;
  signal fill_ends_read_words_0 : unsigned(19 downto 0);
  signal fill_step_0 : natural range 0 to 127;
  signal fill_above_read_0 : unsigned(15 downto 0);
  signal fill_above_0, fill_write_above_0 : natural range 0 to 65535;
  signal fill_out_disparity_0 : natural range 0 to 32767;
  -- median
  signal median_counter_column, median_counter_group, median_read_column, median_ready_column : natural range 0 to 511;
  signal median_write_column, median_at_column, median_comparing_column, median_sorted_column : natural range 0 to 511;
  signal median_beside_newest_0, median_beside_rows_read_newest_0 : natural range 0 to 511;
  signal median_beside_rows_ready_words_0, median_beside_rows_ready_newest_0 : natural range 0 to 511;
  signal median_beside_rows_write_words_0, median_beside_column_0 : natural range 0 to 511;
  signal median_beside_of_column_0 : natural_511_1d(0 to 1);  -- median_beside_of_column_#_0
  signal median_beside_in_window_0 : natural_511_1d(0 to 1);  -- median_beside_in_window_#_0
  signal median_beside_waiting_0 : natural_511_1d(0 to 2);  -- median_beside_waiting_#_0
  signal median_counter_next_frame, median_arrives, median_behind, median_line_ended, median_read_arrives : boolean;
  signal median_read_behind, median_read_top, median_read_bottom, median_read_output, median_ready_arrives : boolean;
  signal median_ready_behind, median_ready_top, median_ready_output, median_at_arrives, median_at_behind : boolean;
  signal median_at_top, median_at_output, median_of_column_0_b_below_a, median_of_column_0_c_below_a : boolean;
  signal median_of_column_0_c_below_b : boolean;
  signal median_column_passed_0 : boolean_1d(0 to 1);  -- median_column_passed_#_0
  signal median_comparing_arrives, median_comparing_behind, median_comparing_top, median_comparing_output : boolean;
  signal median_sorted_arrives, median_sorted_behind, median_sorted_top, median_sorted_output : boolean;
  signal median_passed_0 : boolean_1d(0 to 1);  -- median_passed_#_0
  signal median_window_complete, median_window_first, median_window_last, median_of_low_0_b_below_a : boolean;
  signal median_of_low_0_c_below_a, median_of_low_0_c_below_b, median_of_middle_0_b_below_a : boolean;
  signal median_of_middle_0_c_below_a, median_of_middle_0_c_below_b, median_of_high_0_b_below_a : boolean;
  signal median_of_high_0_c_below_a, median_of_high_0_c_below_b, median_of_all_0_b_below_a : boolean;
  signal median_of_all_0_c_below_a, median_of_all_0_c_below_b : boolean;
  signal median_waiting_complete : boolean_1d(0 to 2);  -- median_waiting_#_complete
  signal median_waiting_first : boolean_1d(0 to 2);  -- median_waiting_#_first
  signal median_waiting_last : boolean_1d(0 to 2);  -- median_waiting_#_last
  signal median_waiting_passed_0 : boolean_1d(0 to 2);  -- median_waiting_passed_#_0
  signal median_out_passed_0, median_out_filled_0, median_out_valid, median_out_start_of_frame : boolean;
  signal median_out_end_of_line : boolean;
  signal median_newest_0, median_rows_read_newest_0, median_rows_ready_newest_0 : natural range 0 to 65535;
  signal median_column_2 : natural range 0 to 65535;
  signal median_rows_read_words_0 : unsigned(25 downto 0);
  signal median_rows_ready_words_0 : natural range 0 to 67108863;
  signal median_rows_write_words_0 : natural range 0 to 536870911;
  signal median_column_1 : natural range 0 to 8191;
  signal median_of_column_0_a, median_of_column_0_b : natural range 0 to 4095;
  signal median_of_column_0_c, median_sorted_low_0, median_sorted_middle_0 : natural range 0 to 32767;
  signal median_sorted_high_0 : natural range 0 to 32767;
  signal median_low_0 : natural_32767_1d(0 to 2);  -- median_low_#_0
  signal median_middle_0 : natural_32767_1d(0 to 2);  -- median_middle_#_0
  signal median_high_0 : natural_32767_1d(0 to 2);  -- median_high_#_0
  signal median_of_low_0_a, median_of_low_0_b, median_of_low_0_c, median_of_middle_0_a : natural range 0 to 32767;
  signal median_of_middle_0_b, median_of_middle_0_c, median_of_high_0_a, median_of_high_0_b : natural range 0 to 32767;
  signal median_of_high_0_c, median_largest_low_0, median_median_middle_0 : natural range 0 to 32767;
  signal median_smallest_high_0, median_of_all_0_a, median_of_all_0_b, median_of_all_0_c : natural range 0 to 32767;
  signal median_out_disparity_0 : natural range 0 to 32767;
  signal median_beside_rows_read_words_0 : unsigned(8 downto 0);
  signal median_out_confidence_0 : natural range 0 to 255;
  -- relief
  signal relief_centre_column : natural_255_1d(0 to 4);
  signal relief_centre_grey_0, relief_before : natural range 0 to 255;
  signal relief_newest, relief_delayed_0, relief_rows_read_newest_0, relief_rows_ready_words_0 : natural range 0 to 31;
  signal relief_rows_ready_newest_0, relief_rows_write_words_0, relief_shown_0, relief_column_0 : natural range 0 to 31;
  signal relief_waiting : natural_31_1d(0 to 9);
  signal relief_entering, relief_entered : natural range 0 to 31;
  signal relief_rows_read_words_0 : unsigned(4 downto 0);
  -- other
  signal other_0 : boolean;
  signal other_1 : natural range 0 to 8190;
  signal other_2 : natural range 0 to 15;
  signal other_3 : natural range 0 to 63;
  signal other_4 : natural range 0 to 254;
  signal other_5 : natural range 0 to 252;
  signal other_6 : natural range 0 to 248;
  signal other_7 : natural range 0 to 240;
  signal other_8 : natural range 0 to 224;
  signal other_9 : natural range 0 to 192;
  signal other_10 : natural range 0 to 128;
  signal transform_left_rows_read_words_0_memory_read_enable : boolean;
  signal transform_left_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_left_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal transform_right_rows_read_words_0_memory_read_enable : boolean;
  signal transform_right_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal transform_right_rows_read_words_0_memory_write_data : unsigned(31 downto 0);
  signal median_beside_rows_read_words_0_memory_read_enable : boolean;
  signal median_beside_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal median_beside_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal median_beside_rows_read_words_0_memory_write_data : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_read_enable : boolean;
  signal median_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal median_rows_read_words_0_memory_write_data : unsigned(25 downto 0);
  signal fill_above_read_0_memory_read_enable : boolean;
  signal fill_above_read_0_memory_read_address, fill_above_read_0_memory_write_address : unsigned(8 downto 0);
  signal fill_above_read_0_memory_write_data : unsigned(15 downto 0);
  signal fill_ends_read_words_0_memory_read_enable : boolean;
  signal fill_ends_read_words_0_memory_read_address, fill_ends_read_words_0_memory_write_address : unsigned(7 downto 0);
  signal fill_ends_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal fill_rows_read_words_0_memory_read_enable : boolean;
  signal fill_rows_read_words_0_memory_read_address, fill_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal fill_rows_read_words_0_memory_write_data : unsigned(18 downto 0);
  signal support_rows_read_words_0_memory_read_enable : boolean;
  signal support_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal support_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal support_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal support_rest_rows_read_words_0_memory_read_enable : boolean;
  signal support_rest_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal support_rest_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal support_rest_rows_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal turn_read_words_0_memory_read_enable : boolean;
  signal turn_read_words_0_memory_read_address, turn_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal turn_read_words_0_memory_write_data : unsigned(19 downto 0);
  signal leftright_found_0_memory_read_enable : boolean;
  signal leftright_found_0_memory_read_address, leftright_found_0_memory_write_address : unsigned(6 downto 0);
  signal leftright_found_0_memory_write_data : unsigned(5 downto 0);
  signal leftright_held_1_memory_read_enable : boolean;
  signal leftright_held_1_memory_read_address, leftright_held_1_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_1_memory_write_data : unsigned(5 downto 0);
  signal leftright_held_0_memory_read_enable : boolean;
  signal leftright_held_0_memory_read_address, leftright_held_0_memory_write_address : unsigned(5 downto 0);
  signal leftright_held_0_memory_write_data : unsigned(17 downto 0);
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
  signal sums_turn_read_sums_15_memory_read_enable : boolean;
  signal sums_turn_read_sums_15_memory_read_address, sums_turn_read_sums_15_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_15_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_14_memory_read_enable : boolean;
  signal sums_turn_read_sums_14_memory_read_address, sums_turn_read_sums_14_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_14_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_13_memory_read_enable : boolean;
  signal sums_turn_read_sums_13_memory_read_address, sums_turn_read_sums_13_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_13_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_12_memory_read_enable : boolean;
  signal sums_turn_read_sums_12_memory_read_address, sums_turn_read_sums_12_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_12_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_11_memory_read_enable : boolean;
  signal sums_turn_read_sums_11_memory_read_address, sums_turn_read_sums_11_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_11_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_10_memory_read_enable : boolean;
  signal sums_turn_read_sums_10_memory_read_address, sums_turn_read_sums_10_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_10_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_9_memory_read_enable : boolean;
  signal sums_turn_read_sums_9_memory_read_address, sums_turn_read_sums_9_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_9_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_8_memory_read_enable : boolean;
  signal sums_turn_read_sums_8_memory_read_address, sums_turn_read_sums_8_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_8_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_7_memory_read_enable : boolean;
  signal sums_turn_read_sums_7_memory_read_address, sums_turn_read_sums_7_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_7_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_6_memory_read_enable : boolean;
  signal sums_turn_read_sums_6_memory_read_address, sums_turn_read_sums_6_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_6_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_5_memory_read_enable : boolean;
  signal sums_turn_read_sums_5_memory_read_address, sums_turn_read_sums_5_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_5_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_4_memory_read_enable : boolean;
  signal sums_turn_read_sums_4_memory_read_address, sums_turn_read_sums_4_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_4_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_3_memory_read_enable : boolean;
  signal sums_turn_read_sums_3_memory_read_address, sums_turn_read_sums_3_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_3_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_2_memory_read_enable : boolean;
  signal sums_turn_read_sums_2_memory_read_address, sums_turn_read_sums_2_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_2_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_1_memory_read_enable : boolean;
  signal sums_turn_read_sums_1_memory_read_address, sums_turn_read_sums_1_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_1_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_sums_0_memory_read_enable : boolean;
  signal sums_turn_read_sums_0_memory_read_address, sums_turn_read_sums_0_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_sums_0_memory_write_data : unsigned(27 downto 0);
  signal sums_turn_read_costs_6_memory_read_enable : boolean;
  signal sums_turn_read_costs_6_memory_read_address, sums_turn_read_costs_6_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_6_memory_write_data : unsigned(11 downto 0);
  signal sums_turn_read_costs_5_memory_read_enable : boolean;
  signal sums_turn_read_costs_5_memory_read_address, sums_turn_read_costs_5_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_5_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_4_memory_read_enable : boolean;
  signal sums_turn_read_costs_4_memory_read_address, sums_turn_read_costs_4_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_4_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_3_memory_read_enable : boolean;
  signal sums_turn_read_costs_3_memory_read_address, sums_turn_read_costs_3_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_3_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_2_memory_read_enable : boolean;
  signal sums_turn_read_costs_2_memory_read_address, sums_turn_read_costs_2_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_2_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_1_memory_read_enable : boolean;
  signal sums_turn_read_costs_1_memory_read_address, sums_turn_read_costs_1_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_1_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_costs_0_memory_read_enable : boolean;
  signal sums_turn_read_costs_0_memory_read_address, sums_turn_read_costs_0_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_costs_0_memory_write_data : unsigned(29 downto 0);
  signal sums_turn_read_smallest_0_memory_read_enable : boolean;
  signal sums_turn_read_smallest_0_memory_read_address : unsigned(8 downto 0);
  signal sums_turn_read_smallest_0_memory_write_address : unsigned(8 downto 0);
  signal sums_turn_read_smallest_0_memory_write_data : unsigned(7 downto 0);
  signal forward_above_read_words_10_memory_read_enable : boolean;
  signal forward_above_read_words_10_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_10_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_10_memory_write_data : unsigned(20 downto 0);
  signal forward_above_read_words_9_memory_read_enable : boolean;
  signal forward_above_read_words_9_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_9_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_9_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_8_memory_read_enable : boolean;
  signal forward_above_read_words_8_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_8_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_8_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_7_memory_read_enable : boolean;
  signal forward_above_read_words_7_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_7_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_7_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_6_memory_read_enable : boolean;
  signal forward_above_read_words_6_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_6_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_6_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_5_memory_read_enable : boolean;
  signal forward_above_read_words_5_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_5_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_5_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_4_memory_read_enable : boolean;
  signal forward_above_read_words_4_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_4_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_4_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_3_memory_read_enable : boolean;
  signal forward_above_read_words_3_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_3_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_3_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_2_memory_read_enable : boolean;
  signal forward_above_read_words_2_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_2_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_2_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_1_memory_read_enable : boolean;
  signal forward_above_read_words_1_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_1_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_1_memory_write_data : unsigned(30 downto 0);
  signal forward_above_read_words_0_memory_read_enable : boolean;
  signal forward_above_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal forward_above_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal forward_above_read_words_0_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_10_memory_read_enable : boolean;
  signal forward_above_delay_held_10_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_10_memory_write_data : unsigned(20 downto 0);
  signal forward_above_delay_held_9_memory_read_enable : boolean;
  signal forward_above_delay_held_9_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_9_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_8_memory_read_enable : boolean;
  signal forward_above_delay_held_8_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_8_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_7_memory_read_enable : boolean;
  signal forward_above_delay_held_7_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_7_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_6_memory_read_enable : boolean;
  signal forward_above_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_6_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_5_memory_read_enable : boolean;
  signal forward_above_delay_held_5_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_5_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_4_memory_read_enable : boolean;
  signal forward_above_delay_held_4_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_4_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_3_memory_read_enable : boolean;
  signal forward_above_delay_held_3_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_3_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_2_memory_read_enable : boolean;
  signal forward_above_delay_held_2_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_2_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_1_memory_read_enable : boolean;
  signal forward_above_delay_held_1_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_1_memory_write_data : unsigned(30 downto 0);
  signal forward_above_delay_held_0_memory_read_enable : boolean;
  signal forward_above_delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal forward_above_delay_held_0_memory_write_data : unsigned(30 downto 0);
  signal forward_cost_delay_held_6_memory_read_enable : boolean;
  signal forward_cost_delay_held_6_memory_read_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_address : unsigned(2 downto 0);
  signal forward_cost_delay_held_6_memory_write_data : unsigned(13 downto 0);
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
  signal relief_rows_read_words_0_memory_read_enable : boolean;
  signal relief_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal relief_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal relief_rows_read_words_0_memory_write_data : unsigned(4 downto 0);
  signal rows_search_rows_read_words_0_memory_read_enable : boolean;
  signal rows_search_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_search_rows_read_words_0_memory_write_data : unsigned(27 downto 0);
  signal rows_reference_rows_read_words_0_memory_read_enable : boolean;
  signal rows_reference_rows_read_words_0_memory_read_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_address : unsigned(8 downto 0);
  signal rows_reference_rows_read_words_0_memory_write_data : unsigned(27 downto 0);

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(unsigned'(to_unsigned(median_out_confidence_0, 8) & to_unsigned(as_number(median_out_filled_0), 1) & to_unsigned(median_out_disparity_0, 15)));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(median_out_passed_0), 1));
  disparity_valid <= as_bit(median_out_valid);
  disparity_start_of_frame <= as_bit(median_out_start_of_frame);
  disparity_end_of_line <= as_bit(median_out_end_of_line);

  transform_left_rows_read_words_0_memory_read_enable <= true;
  transform_left_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_left_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_left_rows_read_words_0_memory_write_data <= transform_left_rows_write_words_0;
  transform_left_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_left_rows_read_words_0_memory_read_enable,
      read_address => transform_left_rows_read_words_0_memory_read_address, read_data => transform_left_rows_read_words_0,
      write_address => transform_left_rows_read_words_0_memory_write_address, write_data => transform_left_rows_read_words_0_memory_write_data);

  transform_right_rows_read_words_0_memory_read_enable <= true;
  transform_right_rows_read_words_0_memory_read_address <= to_unsigned(transform_counter_column, 9);
  transform_right_rows_read_words_0_memory_write_address <= to_unsigned(transform_write_column, 9);
  transform_right_rows_read_words_0_memory_write_data <= transform_right_rows_write_words_0;
  transform_right_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 32, address_bits => 9)
    port map (
      clock => clock, read_enable => transform_right_rows_read_words_0_memory_read_enable,
      read_address => transform_right_rows_read_words_0_memory_read_address, read_data => transform_right_rows_read_words_0,
      write_address => transform_right_rows_read_words_0_memory_write_address, write_data => transform_right_rows_read_words_0_memory_write_data);

  median_beside_rows_read_words_0_memory_read_enable <= true;
  median_beside_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 9);
  median_beside_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 9);
  median_beside_rows_read_words_0_memory_write_data <= to_unsigned(median_beside_rows_write_words_0, 9);
  median_beside_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 9, address_bits => 9)
    port map (
      clock => clock, read_enable => median_beside_rows_read_words_0_memory_read_enable,
      read_address => median_beside_rows_read_words_0_memory_read_address, read_data => median_beside_rows_read_words_0,
      write_address => median_beside_rows_read_words_0_memory_write_address, write_data => median_beside_rows_read_words_0_memory_write_data);

  median_rows_read_words_0_memory_read_enable <= true;
  median_rows_read_words_0_memory_read_address <= to_unsigned(median_counter_column, 9);
  median_rows_read_words_0_memory_write_address <= to_unsigned(median_at_column, 9);
  median_rows_read_words_0_memory_write_data <= to_unsigned((median_rows_write_words_0 mod 67108864), 26);
  median_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 26, address_bits => 9)
    port map (
      clock => clock, read_enable => median_rows_read_words_0_memory_read_enable,
      read_address => median_rows_read_words_0_memory_read_address, read_data => median_rows_read_words_0,
      write_address => median_rows_read_words_0_memory_write_address, write_data => median_rows_read_words_0_memory_write_data);

  fill_above_read_0_memory_read_enable <= true;
  fill_above_read_0_memory_read_address <= to_unsigned(fill_known_at_column, 9);
  fill_above_read_0_memory_write_address <= to_unsigned(fill_write_above_column, 9);
  fill_above_read_0_memory_write_data <= to_unsigned(fill_write_above_0, 16);
  fill_above_read_0_memory : entity work.line_memory
    generic map (depth => 448, width => 16, address_bits => 9)
    port map (
      clock => clock, read_enable => fill_above_read_0_memory_read_enable,
      read_address => fill_above_read_0_memory_read_address, read_data => fill_above_read_0,
      write_address => fill_above_read_0_memory_write_address, write_data => fill_above_read_0_memory_write_data);

  fill_ends_read_words_0_memory_read_enable <= true;
  fill_ends_read_words_0_memory_read_address <= to_unsigned(fill_ends_read_place_0, 8);
  fill_ends_read_words_0_memory_write_address <= to_unsigned(fill_ends_write_place_0, 8);
  fill_ends_read_words_0_memory_write_data <= to_unsigned(fill_ends_write_words_0, 20);
  fill_ends_read_words_0_memory : entity work.line_memory
    generic map (depth => 228, width => 20, address_bits => 8)
    port map (
      clock => clock, read_enable => fill_ends_read_words_0_memory_read_enable,
      read_address => fill_ends_read_words_0_memory_read_address, read_data => fill_ends_read_words_0,
      write_address => fill_ends_read_words_0_memory_write_address, write_data => fill_ends_read_words_0_memory_write_data);

  fill_rows_read_words_0_memory_read_enable <= true;
  fill_rows_read_words_0_memory_read_address <= to_unsigned(fill_counter_column, 9);
  fill_rows_read_words_0_memory_write_address <= to_unsigned(fill_at_column, 9);
  fill_rows_read_words_0_memory_write_data <= to_unsigned(fill_rows_write_words_0, 19);
  fill_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 19, address_bits => 9)
    port map (
      clock => clock, read_enable => fill_rows_read_words_0_memory_read_enable,
      read_address => fill_rows_read_words_0_memory_read_address, read_data => fill_rows_read_words_0,
      write_address => fill_rows_read_words_0_memory_write_address, write_data => fill_rows_read_words_0_memory_write_data);

  support_rows_read_words_0_memory_read_enable <= true;
  support_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 9);
  support_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 9);
  support_rows_read_words_0_memory_write_data <= to_unsigned(support_rows_write_words_0, 28);
  support_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => support_rows_read_words_0_memory_read_enable,
      read_address => support_rows_read_words_0_memory_read_address, read_data => support_rows_read_words_0,
      write_address => support_rows_read_words_0_memory_write_address, write_data => support_rows_read_words_0_memory_write_data);

  support_rest_rows_read_words_0_memory_read_enable <= true;
  support_rest_rows_read_words_0_memory_read_address <= to_unsigned(support_counter_column, 9);
  support_rest_rows_read_words_0_memory_write_address <= to_unsigned(support_write_column, 9);
  support_rest_rows_read_words_0_memory_write_data <= to_unsigned(support_rest_rows_write_words_0, 20);
  support_rest_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 20, address_bits => 9)
    port map (
      clock => clock, read_enable => support_rest_rows_read_words_0_memory_read_enable,
      read_address => support_rest_rows_read_words_0_memory_read_address, read_data => support_rest_rows_read_words_0,
      write_address => support_rest_rows_read_words_0_memory_write_address, write_data => support_rest_rows_read_words_0_memory_write_data);

  turn_read_words_0_memory_read_enable <= true;
  turn_read_words_0_memory_read_address <= to_unsigned(turn_order_address, 9);
  turn_read_words_0_memory_write_address <= to_unsigned(turn_write_place, 9);
  turn_read_words_0_memory_write_data <= to_unsigned(turn_write_words_0, 20);
  turn_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 20, address_bits => 9)
    port map (
      clock => clock, read_enable => turn_read_words_0_memory_read_enable,
      read_address => turn_read_words_0_memory_read_address, read_data => turn_read_words_0,
      write_address => turn_read_words_0_memory_write_address, write_data => turn_read_words_0_memory_write_data);

  leftright_found_0_memory_read_enable <= true;
  leftright_found_0_memory_read_address <= to_unsigned(leftright_address_0, 7);
  leftright_found_0_memory_write_address <= to_unsigned(leftright_position, 7);
  leftright_found_0_memory_write_data <= to_unsigned(leftright_other_0(17), 6);
  leftright_found_0_memory : entity work.line_memory
    generic map (depth => 128, width => 6, address_bits => 7)
    port map (
      clock => clock, read_enable => leftright_found_0_memory_read_enable,
      read_address => leftright_found_0_memory_read_address, read_data => leftright_found_0,
      write_address => leftright_found_0_memory_write_address, write_data => leftright_found_0_memory_write_data);

  leftright_held_1_memory_read_enable <= true;
  leftright_held_1_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_1_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_1_memory_write_data <= to_unsigned(refinement_margin_0(9), 6);
  leftright_held_1_memory : entity work.line_memory
    generic map (depth => 64, width => 6, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_1_memory_read_enable,
      read_address => leftright_held_1_memory_read_address, read_data => leftright_held_1,
      write_address => leftright_held_1_memory_write_address, write_data => leftright_held_1_memory_write_data);

  leftright_held_0_memory_read_enable <= true;
  leftright_held_0_memory_read_address <= to_unsigned(leftright_ring_read_address, 6);
  leftright_held_0_memory_write_address <= to_unsigned(leftright_ring_write_address, 6);
  leftright_held_0_memory_write_data <= to_unsigned(refinement_fraction_0, 5) & to_unsigned(as_number(refinement_passed_0(11)), 1) & to_unsigned(refinement_disparity_0(11), 8) & to_unsigned(as_number(refinement_tag_end_of_line(11)), 1) & to_unsigned(as_number(refinement_tag_start_of_frame(11)), 1) & to_unsigned(as_number(refinement_tag_output_column(11)), 1) & to_unsigned(as_number(refinement_tag_map_column(11)), 1);
  leftright_held_0_memory : entity work.line_memory
    generic map (depth => 64, width => 18, address_bits => 6)
    port map (
      clock => clock, read_enable => leftright_held_0_memory_read_enable,
      read_address => leftright_held_0_memory_read_address, read_data => leftright_held_0,
      write_address => leftright_held_0_memory_write_address, write_data => leftright_held_0_memory_write_data);

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

  sums_turn_read_sums_15_memory_read_enable <= true;
  sums_turn_read_sums_15_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_15_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_15_memory_write_data <= to_unsigned(sums_turn_write_sums(15), 28);
  sums_turn_read_sums_15_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_15_memory_read_enable,
      read_address => sums_turn_read_sums_15_memory_read_address, read_data => sums_turn_read_sums(15),
      write_address => sums_turn_read_sums_15_memory_write_address, write_data => sums_turn_read_sums_15_memory_write_data);

  sums_turn_read_sums_14_memory_read_enable <= true;
  sums_turn_read_sums_14_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_14_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_14_memory_write_data <= to_unsigned(sums_turn_write_sums(14), 28);
  sums_turn_read_sums_14_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_14_memory_read_enable,
      read_address => sums_turn_read_sums_14_memory_read_address, read_data => sums_turn_read_sums(14),
      write_address => sums_turn_read_sums_14_memory_write_address, write_data => sums_turn_read_sums_14_memory_write_data);

  sums_turn_read_sums_13_memory_read_enable <= true;
  sums_turn_read_sums_13_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_13_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_13_memory_write_data <= to_unsigned(sums_turn_write_sums(13), 28);
  sums_turn_read_sums_13_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_13_memory_read_enable,
      read_address => sums_turn_read_sums_13_memory_read_address, read_data => sums_turn_read_sums(13),
      write_address => sums_turn_read_sums_13_memory_write_address, write_data => sums_turn_read_sums_13_memory_write_data);

  sums_turn_read_sums_12_memory_read_enable <= true;
  sums_turn_read_sums_12_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_12_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_12_memory_write_data <= to_unsigned(sums_turn_write_sums(12), 28);
  sums_turn_read_sums_12_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_12_memory_read_enable,
      read_address => sums_turn_read_sums_12_memory_read_address, read_data => sums_turn_read_sums(12),
      write_address => sums_turn_read_sums_12_memory_write_address, write_data => sums_turn_read_sums_12_memory_write_data);

  sums_turn_read_sums_11_memory_read_enable <= true;
  sums_turn_read_sums_11_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_11_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_11_memory_write_data <= to_unsigned(sums_turn_write_sums(11), 28);
  sums_turn_read_sums_11_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_11_memory_read_enable,
      read_address => sums_turn_read_sums_11_memory_read_address, read_data => sums_turn_read_sums(11),
      write_address => sums_turn_read_sums_11_memory_write_address, write_data => sums_turn_read_sums_11_memory_write_data);

  sums_turn_read_sums_10_memory_read_enable <= true;
  sums_turn_read_sums_10_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_10_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_10_memory_write_data <= to_unsigned(sums_turn_write_sums(10), 28);
  sums_turn_read_sums_10_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_10_memory_read_enable,
      read_address => sums_turn_read_sums_10_memory_read_address, read_data => sums_turn_read_sums(10),
      write_address => sums_turn_read_sums_10_memory_write_address, write_data => sums_turn_read_sums_10_memory_write_data);

  sums_turn_read_sums_9_memory_read_enable <= true;
  sums_turn_read_sums_9_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_9_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_9_memory_write_data <= to_unsigned(sums_turn_write_sums(9), 28);
  sums_turn_read_sums_9_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_9_memory_read_enable,
      read_address => sums_turn_read_sums_9_memory_read_address, read_data => sums_turn_read_sums(9),
      write_address => sums_turn_read_sums_9_memory_write_address, write_data => sums_turn_read_sums_9_memory_write_data);

  sums_turn_read_sums_8_memory_read_enable <= true;
  sums_turn_read_sums_8_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_8_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_8_memory_write_data <= to_unsigned(sums_turn_write_sums(8), 28);
  sums_turn_read_sums_8_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_8_memory_read_enable,
      read_address => sums_turn_read_sums_8_memory_read_address, read_data => sums_turn_read_sums(8),
      write_address => sums_turn_read_sums_8_memory_write_address, write_data => sums_turn_read_sums_8_memory_write_data);

  sums_turn_read_sums_7_memory_read_enable <= true;
  sums_turn_read_sums_7_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_7_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_7_memory_write_data <= to_unsigned(sums_turn_write_sums(7), 28);
  sums_turn_read_sums_7_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_7_memory_read_enable,
      read_address => sums_turn_read_sums_7_memory_read_address, read_data => sums_turn_read_sums(7),
      write_address => sums_turn_read_sums_7_memory_write_address, write_data => sums_turn_read_sums_7_memory_write_data);

  sums_turn_read_sums_6_memory_read_enable <= true;
  sums_turn_read_sums_6_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_6_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_6_memory_write_data <= to_unsigned(sums_turn_write_sums(6), 28);
  sums_turn_read_sums_6_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_6_memory_read_enable,
      read_address => sums_turn_read_sums_6_memory_read_address, read_data => sums_turn_read_sums(6),
      write_address => sums_turn_read_sums_6_memory_write_address, write_data => sums_turn_read_sums_6_memory_write_data);

  sums_turn_read_sums_5_memory_read_enable <= true;
  sums_turn_read_sums_5_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_5_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_5_memory_write_data <= to_unsigned(sums_turn_write_sums(5), 28);
  sums_turn_read_sums_5_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_5_memory_read_enable,
      read_address => sums_turn_read_sums_5_memory_read_address, read_data => sums_turn_read_sums(5),
      write_address => sums_turn_read_sums_5_memory_write_address, write_data => sums_turn_read_sums_5_memory_write_data);

  sums_turn_read_sums_4_memory_read_enable <= true;
  sums_turn_read_sums_4_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_4_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_4_memory_write_data <= to_unsigned(sums_turn_write_sums(4), 28);
  sums_turn_read_sums_4_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_4_memory_read_enable,
      read_address => sums_turn_read_sums_4_memory_read_address, read_data => sums_turn_read_sums(4),
      write_address => sums_turn_read_sums_4_memory_write_address, write_data => sums_turn_read_sums_4_memory_write_data);

  sums_turn_read_sums_3_memory_read_enable <= true;
  sums_turn_read_sums_3_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_3_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_3_memory_write_data <= to_unsigned(sums_turn_write_sums(3), 28);
  sums_turn_read_sums_3_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_3_memory_read_enable,
      read_address => sums_turn_read_sums_3_memory_read_address, read_data => sums_turn_read_sums(3),
      write_address => sums_turn_read_sums_3_memory_write_address, write_data => sums_turn_read_sums_3_memory_write_data);

  sums_turn_read_sums_2_memory_read_enable <= true;
  sums_turn_read_sums_2_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_2_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_2_memory_write_data <= to_unsigned(sums_turn_write_sums(2), 28);
  sums_turn_read_sums_2_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_2_memory_read_enable,
      read_address => sums_turn_read_sums_2_memory_read_address, read_data => sums_turn_read_sums(2),
      write_address => sums_turn_read_sums_2_memory_write_address, write_data => sums_turn_read_sums_2_memory_write_data);

  sums_turn_read_sums_1_memory_read_enable <= true;
  sums_turn_read_sums_1_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_1_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_1_memory_write_data <= to_unsigned(sums_turn_write_sums(1), 28);
  sums_turn_read_sums_1_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_1_memory_read_enable,
      read_address => sums_turn_read_sums_1_memory_read_address, read_data => sums_turn_read_sums(1),
      write_address => sums_turn_read_sums_1_memory_write_address, write_data => sums_turn_read_sums_1_memory_write_data);

  sums_turn_read_sums_0_memory_read_enable <= true;
  sums_turn_read_sums_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_sums_0_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_sums_0_memory_write_data <= to_unsigned(sums_turn_write_sums(0), 28);
  sums_turn_read_sums_0_memory : entity work.line_memory
    generic map (depth => 448, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_sums_0_memory_read_enable,
      read_address => sums_turn_read_sums_0_memory_read_address, read_data => sums_turn_read_sums(0),
      write_address => sums_turn_read_sums_0_memory_write_address, write_data => sums_turn_read_sums_0_memory_write_data);

  sums_turn_read_costs_6_memory_read_enable <= true;
  sums_turn_read_costs_6_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_6_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_6_memory_write_data <= to_unsigned(sums_turn_write_costs_6, 12);
  sums_turn_read_costs_6_memory : entity work.line_memory
    generic map (depth => 448, width => 12, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_6_memory_read_enable,
      read_address => sums_turn_read_costs_6_memory_read_address, read_data => sums_turn_read_costs_6,
      write_address => sums_turn_read_costs_6_memory_write_address, write_data => sums_turn_read_costs_6_memory_write_data);

  sums_turn_read_costs_5_memory_read_enable <= true;
  sums_turn_read_costs_5_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_5_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_5_memory_write_data <= to_unsigned(sums_turn_write_costs(5), 30);
  sums_turn_read_costs_5_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_5_memory_read_enable,
      read_address => sums_turn_read_costs_5_memory_read_address, read_data => sums_turn_read_costs(5),
      write_address => sums_turn_read_costs_5_memory_write_address, write_data => sums_turn_read_costs_5_memory_write_data);

  sums_turn_read_costs_4_memory_read_enable <= true;
  sums_turn_read_costs_4_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_4_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_4_memory_write_data <= to_unsigned(sums_turn_write_costs(4), 30);
  sums_turn_read_costs_4_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_4_memory_read_enable,
      read_address => sums_turn_read_costs_4_memory_read_address, read_data => sums_turn_read_costs(4),
      write_address => sums_turn_read_costs_4_memory_write_address, write_data => sums_turn_read_costs_4_memory_write_data);

  sums_turn_read_costs_3_memory_read_enable <= true;
  sums_turn_read_costs_3_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_3_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_3_memory_write_data <= to_unsigned(sums_turn_write_costs(3), 30);
  sums_turn_read_costs_3_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_3_memory_read_enable,
      read_address => sums_turn_read_costs_3_memory_read_address, read_data => sums_turn_read_costs(3),
      write_address => sums_turn_read_costs_3_memory_write_address, write_data => sums_turn_read_costs_3_memory_write_data);

  sums_turn_read_costs_2_memory_read_enable <= true;
  sums_turn_read_costs_2_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_2_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_2_memory_write_data <= to_unsigned(sums_turn_write_costs(2), 30);
  sums_turn_read_costs_2_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_2_memory_read_enable,
      read_address => sums_turn_read_costs_2_memory_read_address, read_data => sums_turn_read_costs(2),
      write_address => sums_turn_read_costs_2_memory_write_address, write_data => sums_turn_read_costs_2_memory_write_data);

  sums_turn_read_costs_1_memory_read_enable <= true;
  sums_turn_read_costs_1_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_1_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_1_memory_write_data <= to_unsigned(sums_turn_write_costs(1), 30);
  sums_turn_read_costs_1_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_1_memory_read_enable,
      read_address => sums_turn_read_costs_1_memory_read_address, read_data => sums_turn_read_costs(1),
      write_address => sums_turn_read_costs_1_memory_write_address, write_data => sums_turn_read_costs_1_memory_write_data);

  sums_turn_read_costs_0_memory_read_enable <= true;
  sums_turn_read_costs_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_costs_0_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_costs_0_memory_write_data <= to_unsigned(sums_turn_write_costs(0), 30);
  sums_turn_read_costs_0_memory : entity work.line_memory
    generic map (depth => 448, width => 30, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_costs_0_memory_read_enable,
      read_address => sums_turn_read_costs_0_memory_read_address, read_data => sums_turn_read_costs(0),
      write_address => sums_turn_read_costs_0_memory_write_address, write_data => sums_turn_read_costs_0_memory_write_data);

  sums_turn_read_smallest_0_memory_read_enable <= true;
  sums_turn_read_smallest_0_memory_read_address <= to_unsigned(sums_turn_waiting_read_place, 9);
  sums_turn_read_smallest_0_memory_write_address <= to_unsigned(sums_turn_write_place, 9);
  sums_turn_read_smallest_0_memory_write_data <= to_unsigned(sums_turn_write_smallest_0, 8);
  sums_turn_read_smallest_0_memory : entity work.line_memory
    generic map (depth => 448, width => 8, address_bits => 9)
    port map (
      clock => clock, read_enable => sums_turn_read_smallest_0_memory_read_enable,
      read_address => sums_turn_read_smallest_0_memory_read_address, read_data => sums_turn_read_smallest_0,
      write_address => sums_turn_read_smallest_0_memory_write_address, write_data => sums_turn_read_smallest_0_memory_write_data);

  forward_above_read_words_10_memory_read_enable <= true;
  forward_above_read_words_10_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_10_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_10_memory_write_data <= to_unsigned(forward_above_write_words_10, 21);
  forward_above_read_words_10_memory : entity work.line_memory
    generic map (depth => 448, width => 21, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_10_memory_read_enable,
      read_address => forward_above_read_words_10_memory_read_address, read_data => forward_above_read_words_10,
      write_address => forward_above_read_words_10_memory_write_address, write_data => forward_above_read_words_10_memory_write_data);

  forward_above_read_words_9_memory_read_enable <= true;
  forward_above_read_words_9_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_9_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_9_memory_write_data <= to_unsigned(forward_above_write_words(9), 31);
  forward_above_read_words_9_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_9_memory_read_enable,
      read_address => forward_above_read_words_9_memory_read_address, read_data => forward_above_read_words(9),
      write_address => forward_above_read_words_9_memory_write_address, write_data => forward_above_read_words_9_memory_write_data);

  forward_above_read_words_8_memory_read_enable <= true;
  forward_above_read_words_8_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_8_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_8_memory_write_data <= to_unsigned(forward_above_write_words(8), 31);
  forward_above_read_words_8_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_8_memory_read_enable,
      read_address => forward_above_read_words_8_memory_read_address, read_data => forward_above_read_words(8),
      write_address => forward_above_read_words_8_memory_write_address, write_data => forward_above_read_words_8_memory_write_data);

  forward_above_read_words_7_memory_read_enable <= true;
  forward_above_read_words_7_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_7_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_7_memory_write_data <= to_unsigned(forward_above_write_words(7), 31);
  forward_above_read_words_7_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_7_memory_read_enable,
      read_address => forward_above_read_words_7_memory_read_address, read_data => forward_above_read_words(7),
      write_address => forward_above_read_words_7_memory_write_address, write_data => forward_above_read_words_7_memory_write_data);

  forward_above_read_words_6_memory_read_enable <= true;
  forward_above_read_words_6_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_6_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_6_memory_write_data <= to_unsigned(forward_above_write_words(6), 31);
  forward_above_read_words_6_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_6_memory_read_enable,
      read_address => forward_above_read_words_6_memory_read_address, read_data => forward_above_read_words(6),
      write_address => forward_above_read_words_6_memory_write_address, write_data => forward_above_read_words_6_memory_write_data);

  forward_above_read_words_5_memory_read_enable <= true;
  forward_above_read_words_5_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_5_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_5_memory_write_data <= to_unsigned(forward_above_write_words(5), 31);
  forward_above_read_words_5_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_5_memory_read_enable,
      read_address => forward_above_read_words_5_memory_read_address, read_data => forward_above_read_words(5),
      write_address => forward_above_read_words_5_memory_write_address, write_data => forward_above_read_words_5_memory_write_data);

  forward_above_read_words_4_memory_read_enable <= true;
  forward_above_read_words_4_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_4_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_4_memory_write_data <= to_unsigned(forward_above_write_words(4), 31);
  forward_above_read_words_4_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_4_memory_read_enable,
      read_address => forward_above_read_words_4_memory_read_address, read_data => forward_above_read_words(4),
      write_address => forward_above_read_words_4_memory_write_address, write_data => forward_above_read_words_4_memory_write_data);

  forward_above_read_words_3_memory_read_enable <= true;
  forward_above_read_words_3_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_3_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_3_memory_write_data <= to_unsigned(forward_above_write_words(3), 31);
  forward_above_read_words_3_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_3_memory_read_enable,
      read_address => forward_above_read_words_3_memory_read_address, read_data => forward_above_read_words(3),
      write_address => forward_above_read_words_3_memory_write_address, write_data => forward_above_read_words_3_memory_write_data);

  forward_above_read_words_2_memory_read_enable <= true;
  forward_above_read_words_2_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_2_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_2_memory_write_data <= to_unsigned(forward_above_write_words(2), 31);
  forward_above_read_words_2_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_2_memory_read_enable,
      read_address => forward_above_read_words_2_memory_read_address, read_data => forward_above_read_words(2),
      write_address => forward_above_read_words_2_memory_write_address, write_data => forward_above_read_words_2_memory_write_data);

  forward_above_read_words_1_memory_read_enable <= true;
  forward_above_read_words_1_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_1_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_1_memory_write_data <= to_unsigned(forward_above_write_words(1), 31);
  forward_above_read_words_1_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_1_memory_read_enable,
      read_address => forward_above_read_words_1_memory_read_address, read_data => forward_above_read_words(1),
      write_address => forward_above_read_words_1_memory_write_address, write_data => forward_above_read_words_1_memory_write_data);

  forward_above_read_words_0_memory_read_enable <= true;
  forward_above_read_words_0_memory_read_address <= to_unsigned(entry_next_column, 9);
  forward_above_read_words_0_memory_write_address <= to_unsigned(forward_above_write_column, 9);
  forward_above_read_words_0_memory_write_data <= to_unsigned(forward_above_write_words(0), 31);
  forward_above_read_words_0_memory : entity work.line_memory
    generic map (depth => 448, width => 31, address_bits => 9)
    port map (
      clock => clock, read_enable => forward_above_read_words_0_memory_read_enable,
      read_address => forward_above_read_words_0_memory_read_address, read_data => forward_above_read_words(0),
      write_address => forward_above_read_words_0_memory_write_address, write_data => forward_above_read_words_0_memory_write_data);

  forward_above_delay_held_10_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_10_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_10_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_10_memory_write_data <= ((((((to_unsigned(forward_above_total(62), 11) & to_unsigned(0, 10)) or (to_unsigned(forward_above_total(63), 6) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(60), 21)))) or (to_unsigned(forward_above_total(61), 16) & to_unsigned(0, 5)));
  forward_above_delay_held_10_memory : entity work.line_memory
    generic map (depth => 7, width => 21, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_10_memory_read_enable,
      read_address => forward_above_delay_held_10_memory_read_address, read_data => forward_above_delay_held_10,
      write_address => forward_above_delay_held_10_memory_write_address, write_data => forward_above_delay_held_10_memory_write_data);

  forward_above_delay_held_9_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_9_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_9_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_9_memory_write_data <= ((((((((((to_unsigned(forward_above_total(58), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(59), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(57), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(56), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(54), 31)))) or (to_unsigned(forward_above_total(55), 26) & to_unsigned(0, 5)));
  forward_above_delay_held_9_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_9_memory_read_enable,
      read_address => forward_above_delay_held_9_memory_read_address, read_data => forward_above_delay_held(9),
      write_address => forward_above_delay_held_9_memory_write_address, write_data => forward_above_delay_held_9_memory_write_data);

  forward_above_delay_held_8_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_8_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_8_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_8_memory_write_data <= ((((((((((to_unsigned(forward_above_total(52), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(53), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(51), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(50), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(48), 31)))) or (to_unsigned(forward_above_total(49), 26) & to_unsigned(0, 5)));
  forward_above_delay_held_8_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_8_memory_read_enable,
      read_address => forward_above_delay_held_8_memory_read_address, read_data => forward_above_delay_held(8),
      write_address => forward_above_delay_held_8_memory_write_address, write_data => forward_above_delay_held_8_memory_write_data);

  forward_above_delay_held_7_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_7_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_7_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_7_memory_write_data <= ((((((((((to_unsigned(forward_above_total(46), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(47), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(45), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(44), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(42), 31)))) or (to_unsigned(forward_above_total(43), 26) & to_unsigned(0, 5)));
  forward_above_delay_held_7_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_7_memory_read_enable,
      read_address => forward_above_delay_held_7_memory_read_address, read_data => forward_above_delay_held(7),
      write_address => forward_above_delay_held_7_memory_write_address, write_data => forward_above_delay_held_7_memory_write_data);

  forward_above_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_6_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_6_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_6_memory_write_data <= ((((((((((to_unsigned(forward_above_total(40), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(41), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(39), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(38), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(36), 31)))) or (to_unsigned(forward_above_total(37), 26) & to_unsigned(0, 5)));
  forward_above_delay_held_6_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_6_memory_read_enable,
      read_address => forward_above_delay_held_6_memory_read_address, read_data => forward_above_delay_held(6),
      write_address => forward_above_delay_held_6_memory_write_address, write_data => forward_above_delay_held_6_memory_write_data);

  forward_above_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_5_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_5_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_5_memory_write_data <= ((((((((((to_unsigned(forward_above_total(34), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(35), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(33), 16) & to_unsigned(0, 15)))) or (to_unsigned(forward_above_total(32), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(30), 31)))) or (to_unsigned(forward_above_total(31), 26) & to_unsigned(0, 5)));
  forward_above_delay_held_5_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_5_memory_read_enable,
      read_address => forward_above_delay_held_5_memory_read_address, read_data => forward_above_delay_held(5),
      write_address => forward_above_delay_held_5_memory_write_address, write_data => forward_above_delay_held_5_memory_write_data);

  forward_above_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_4_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_4_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_4_memory_write_data <= ((((((to_unsigned(forward_above_total(28), 11) & to_unsigned(0, 20)) or (to_unsigned(forward_above_total(29), 6) & to_unsigned(0, 25)))) or (to_unsigned(forward_above_total(26), 21) & to_unsigned(0, 10)))) or (to_unsigned(forward_above_total(27), 16) & to_unsigned(to_integer(((to_unsigned(forward_above_total(25), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(24), 11)))), 15)));
  forward_above_delay_held_4_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_4_memory_read_enable,
      read_address => forward_above_delay_held_4_memory_read_address, read_data => forward_above_delay_held(4),
      write_address => forward_above_delay_held_4_memory_write_address, write_data => forward_above_delay_held_4_memory_write_data);

  forward_above_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_3_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_3_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_3_memory_write_data <= ((to_unsigned(forward_above_total(23), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(20), 11) & to_unsigned(0, 10)) or (to_unsigned(forward_above_total(21), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(19), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(18), 11)))), 15)))), 25)) or (to_unsigned(forward_above_total(22), 11) & to_unsigned(0, 20)));
  forward_above_delay_held_3_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_3_memory_read_enable,
      read_address => forward_above_delay_held_3_memory_read_address, read_data => forward_above_delay_held(3),
      write_address => forward_above_delay_held_3_memory_write_address, write_data => forward_above_delay_held_3_memory_write_data);

  forward_above_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_2_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_2_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_2_memory_write_data <= ((to_unsigned(forward_above_total(17), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(14), 11) & to_unsigned(0, 10)) or (to_unsigned(forward_above_total(15), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(13), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(12), 11)))), 15)))), 25)) or (to_unsigned(forward_above_total(16), 11) & to_unsigned(0, 20)));
  forward_above_delay_held_2_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_2_memory_read_enable,
      read_address => forward_above_delay_held_2_memory_read_address, read_data => forward_above_delay_held(2),
      write_address => forward_above_delay_held_2_memory_write_address, write_data => forward_above_delay_held_2_memory_write_data);

  forward_above_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_1_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_1_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_1_memory_write_data <= ((to_unsigned(forward_above_total(11), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(8), 11) & to_unsigned(0, 10)) or (to_unsigned(forward_above_total(9), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(7), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(6), 11)))), 15)))), 25)) or (to_unsigned(forward_above_total(10), 11) & to_unsigned(0, 20)));
  forward_above_delay_held_1_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_1_memory_read_enable,
      read_address => forward_above_delay_held_1_memory_read_address, read_data => forward_above_delay_held(1),
      write_address => forward_above_delay_held_1_memory_write_address, write_data => forward_above_delay_held_1_memory_write_data);

  forward_above_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_above_delay_held_0_memory_read_address <= to_unsigned(forward_cost_delay_ring_read_address, 3);
  forward_above_delay_held_0_memory_write_address <= to_unsigned(forward_cost_delay_ring_write_address, 3);
  forward_above_delay_held_0_memory_write_data <= ((to_unsigned(forward_above_total(5), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(2), 11) & to_unsigned(0, 10)) or (to_unsigned(forward_above_total(3), 6) & to_unsigned(to_integer(((to_unsigned(forward_above_total(1), 6) & to_unsigned(0, 5)) or (to_unsigned(forward_above_total(0), 11)))), 15)))), 25)) or (to_unsigned(forward_above_total(4), 11) & to_unsigned(0, 20)));
  forward_above_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 31, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_above_delay_held_0_memory_read_enable,
      read_address => forward_above_delay_held_0_memory_read_address, read_data => forward_above_delay_held(0),
      write_address => forward_above_delay_held_0_memory_write_address, write_data => forward_above_delay_held_0_memory_write_data);

  forward_cost_delay_held_6_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_6_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_6_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_6_memory_write_data <= ((((((to_unsigned(entry_cost(62), 8) & to_unsigned(0, 6)) or (to_unsigned(entry_cost(63), 5) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(60), 14)))) or (to_unsigned(entry_cost(61), 11) & to_unsigned(0, 3)));
  forward_cost_delay_held_6_memory : entity work.line_memory
    generic map (depth => 7, width => 14, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_6_memory_read_enable,
      read_address => forward_cost_delay_held_6_memory_read_address, read_data => forward_cost_delay_held_6,
      write_address => forward_cost_delay_held_6_memory_write_address, write_data => forward_cost_delay_held_6_memory_write_data);

  forward_cost_delay_held_5_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_5_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_5_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_5_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(58), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(59), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(57), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(56), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(55), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(54), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(53), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(52), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(50), 32)))) or (to_unsigned(entry_cost(51), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_5_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_5_memory_read_enable,
      read_address => forward_cost_delay_held_5_memory_read_address, read_data => forward_cost_delay_held(5),
      write_address => forward_cost_delay_held_5_memory_write_address, write_data => forward_cost_delay_held_5_memory_write_data);

  forward_cost_delay_held_4_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_4_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_4_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_4_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(48), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(49), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(47), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(46), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(45), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(44), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(43), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(42), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(40), 32)))) or (to_unsigned(entry_cost(41), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_4_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_4_memory_read_enable,
      read_address => forward_cost_delay_held_4_memory_read_address, read_data => forward_cost_delay_held(4),
      write_address => forward_cost_delay_held_4_memory_write_address, write_data => forward_cost_delay_held_4_memory_write_data);

  forward_cost_delay_held_3_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_3_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_3_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_3_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(38), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(39), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(37), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(36), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(35), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(34), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(33), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(32), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(30), 32)))) or (to_unsigned(entry_cost(31), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_3_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_3_memory_read_enable,
      read_address => forward_cost_delay_held_3_memory_read_address, read_data => forward_cost_delay_held(3),
      write_address => forward_cost_delay_held_3_memory_write_address, write_data => forward_cost_delay_held_3_memory_write_data);

  forward_cost_delay_held_2_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_2_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_2_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_2_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(28), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(29), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(27), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(26), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(25), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(24), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(23), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(22), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(20), 32)))) or (to_unsigned(entry_cost(21), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_2_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_2_memory_read_enable,
      read_address => forward_cost_delay_held_2_memory_read_address, read_data => forward_cost_delay_held(2),
      write_address => forward_cost_delay_held_2_memory_write_address, write_data => forward_cost_delay_held_2_memory_write_data);

  forward_cost_delay_held_1_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_1_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_1_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_1_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(18), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(19), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(17), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(16), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(15), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(14), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(13), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(12), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(10), 32)))) or (to_unsigned(entry_cost(11), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_1_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_1_memory_read_enable,
      read_address => forward_cost_delay_held_1_memory_read_address, read_data => forward_cost_delay_held(1),
      write_address => forward_cost_delay_held_1_memory_write_address, write_data => forward_cost_delay_held_1_memory_write_data);

  forward_cost_delay_held_0_memory_read_enable <= entry_tag_valid;
  forward_cost_delay_held_0_memory_read_address <= to_unsigned(forward_above_delay_ring_read_address, 3);
  forward_cost_delay_held_0_memory_write_address <= to_unsigned(forward_above_delay_ring_write_address, 3);
  forward_cost_delay_held_0_memory_write_data <= ((((((((((((((((((to_unsigned(entry_cost(8), 8) & to_unsigned(0, 24)) or (to_unsigned(entry_cost(9), 5) & to_unsigned(0, 27)))) or (to_unsigned(entry_cost(7), 11) & to_unsigned(0, 21)))) or (to_unsigned(entry_cost(6), 14) & to_unsigned(0, 18)))) or (to_unsigned(entry_cost(5), 17) & to_unsigned(0, 15)))) or (to_unsigned(entry_cost(4), 20) & to_unsigned(0, 12)))) or (to_unsigned(entry_cost(3), 23) & to_unsigned(0, 9)))) or (to_unsigned(entry_cost(2), 26) & to_unsigned(0, 6)))) or (to_unsigned(entry_cost(0), 32)))) or (to_unsigned(entry_cost(1), 29) & to_unsigned(0, 3)));
  forward_cost_delay_held_0_memory : entity work.line_memory
    generic map (depth => 7, width => 32, address_bits => 3)
    port map (
      clock => clock, read_enable => forward_cost_delay_held_0_memory_read_enable,
      read_address => forward_cost_delay_held_0_memory_read_address, read_data => forward_cost_delay_held(0),
      write_address => forward_cost_delay_held_0_memory_write_address, write_data => forward_cost_delay_held_0_memory_write_data);

  relief_rows_read_words_0_memory_read_enable <= true;
  relief_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  relief_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  relief_rows_read_words_0_memory_write_data <= to_unsigned(relief_rows_write_words_0, 5);
  relief_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 5, address_bits => 9)
    port map (
      clock => clock, read_enable => relief_rows_read_words_0_memory_read_enable,
      read_address => relief_rows_read_words_0_memory_read_address, read_data => relief_rows_read_words_0,
      write_address => relief_rows_read_words_0_memory_write_address, write_data => relief_rows_read_words_0_memory_write_data);

  rows_search_rows_read_words_0_memory_read_enable <= true;
  rows_search_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_search_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_search_rows_read_words_0_memory_write_data <= to_unsigned(rows_search_rows_write_words_0, 28);
  rows_search_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_search_rows_read_words_0_memory_read_enable,
      read_address => rows_search_rows_read_words_0_memory_read_address, read_data => rows_search_rows_read_words_0,
      write_address => rows_search_rows_read_words_0_memory_write_address, write_data => rows_search_rows_read_words_0_memory_write_data);

  rows_reference_rows_read_words_0_memory_read_enable <= true;
  rows_reference_rows_read_words_0_memory_read_address <= to_unsigned(delay_column, 9);
  rows_reference_rows_read_words_0_memory_write_address <= to_unsigned(rows_write_column, 9);
  rows_reference_rows_read_words_0_memory_write_data <= to_unsigned(rows_reference_rows_write_words_0, 28);
  rows_reference_rows_read_words_0_memory : entity work.line_memory
    generic map (depth => 450, width => 28, address_bits => 9)
    port map (
      clock => clock, read_enable => rows_reference_rows_read_words_0_memory_read_enable,
      read_address => rows_reference_rows_read_words_0_memory_read_address, read_data => rows_reference_rows_read_words_0,
      write_address => rows_reference_rows_read_words_0_memory_write_address, write_data => rows_reference_rows_read_words_0_memory_write_data);

  process (clock)
    variable transform_counter_group_is_equal, transform_counter_group_is_equal_2 : boolean;
    variable transform_counter_group_all, transform_counter_group_differs : boolean;
    variable transform_read_column_inside_0_is_less, transform_left_filter_feature_0_value : boolean;
    variable transform_left_filter_feature_0_any, transform_left_filter_feature_0_choice : boolean;
    variable transform_left_filter_feature_0_is_equal : boolean;
    variable transform_left_filter_feature_0_choices : boolean_1d(2 to 16);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_left_filter_feature_0_value_#
    variable transform_left_filter_feature_0_choices_from_18 : boolean_1d(18 to 121);  -- transform_left_filter_feature_0_choice_#
    variable transform_left_filter_feature_0_all : boolean;
    variable transform_left_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_left_filter_feature_0_all_#
    variable transform_right_filter_feature_0_value, transform_right_filter_feature_0_any : boolean;
    variable transform_right_filter_feature_0_choice, transform_right_filter_feature_0_is_equal : boolean;
    variable transform_right_filter_feature_0_choices : boolean_1d(2 to 16);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_values : boolean_1d(2 to 11);  -- transform_right_filter_feature_0_value_#
    variable transform_right_filter_feature_0_choices_from_18 : boolean_1d(18 to 125);  -- transform_right_filter_feature_0_choice_#
    variable transform_right_filter_feature_0_all : boolean;
    variable transform_right_filter_feature_0_alls : boolean_1d(2 to 4);  -- transform_right_filter_feature_0_all_#
    variable transform_counter_next_frame_choice, transform_counter_next_frame_choice_2 : boolean;
    variable raster_place_group_is_equal, raster_place_group_is_equal_2, raster_place_group_all : boolean;
    variable raster_place_group_differs, raster_place_next_frame_choice, raster_place_next_frame_choice_2 : boolean;
    variable delay_row_inside_1_is_not_less, delay_row_inside_1_is_less, delay_tag_map_column_is_not_less : boolean;
    variable delay_tag_map_column_is_less, delay_tag_first_column_is_equal : boolean;
    variable slice0cost_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- slice0cost_pixels_first_#_0_count_#_value
    variable slice0cost_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- slice0cost_pixels_first_#_0_count_#_value_2
    variable slice0cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- slice0cost_pixels_first_#_0_count_1_value_3
    variable slice0cost_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- slice0cost_pixels_first_#_0_count_3_value_3
    variable slice0mask_inside_choice : boolean_1d(0 to 15);  -- slice0mask_inside_#_choice
    variable slice1cost_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- slice1cost_pixels_first_#_0_count_#_value
    variable slice1cost_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- slice1cost_pixels_first_#_0_count_#_value_2
    variable slice1cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- slice1cost_pixels_first_#_0_count_1_value_3
    variable slice1cost_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- slice1cost_pixels_first_#_0_count_3_value_3
    variable slice1mask_inside_0_all : boolean;
    variable slice1mask_inside_choice : boolean_1d(0 to 15);  -- slice1mask_inside_#_choice
    variable slice2cost_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- slice2cost_pixels_first_#_0_count_#_value
    variable slice2cost_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- slice2cost_pixels_first_#_0_count_#_value_2
    variable slice2cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- slice2cost_pixels_first_#_0_count_1_value_3
    variable slice2cost_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- slice2cost_pixels_first_#_0_count_3_value_3
    variable slice2mask_inside_0_all : boolean;
    variable slice2mask_inside_choice : boolean_1d(0 to 15);  -- slice2mask_inside_#_choice
    variable slice3cost_pixels_first_0_count_value : boolean_2d(0 to 2, 0 to 4);  -- slice3cost_pixels_first_#_0_count_#_value
    variable slice3cost_pixels_first_0_count_value_2 : boolean_2d(0 to 2, 0 to 3);  -- slice3cost_pixels_first_#_0_count_#_value_2
    variable slice3cost_pixels_first_0_count_1_value_3 : boolean_1d(0 to 2);  -- slice3cost_pixels_first_#_0_count_1_value_3
    variable slice3cost_pixels_first_0_count_3_value_3 : boolean_1d(0 to 2);  -- slice3cost_pixels_first_#_0_count_3_value_3
    variable slice3mask_inside_0_all : boolean;
    variable slice3mask_inside_choice : boolean_1d(0 to 15);  -- slice3mask_inside_#_choice
    variable entry_order_falls_any, entry_order_falls_all, entry_order_complete_all, entry_order_complete_any : boolean;
    variable entry_order_turned_output_column_choice, forward_left_start_cost_0_any : boolean;
    variable forward_left_start_cost_0_choice : boolean;
    variable forward_left_start_cost_0_choices : boolean_1d(2 to 6);  -- forward_left_start_cost_0_choice_#
    variable forward_left_start_cost_0_value, forward_left_start_cost_0_value_2 : boolean;
    variable forward_left_start_cost_0_is_equal, forward_left_start_cost_0_is_less : boolean;
    variable forward_above_writes_copy_0_choice, sums_right_start_cost_0_any, sums_right_start_cost_0_choice : boolean;
    variable sums_right_start_cost_0_choices : boolean_1d(2 to 6);  -- sums_right_start_cost_0_choice_#
    variable sums_right_start_cost_0_value, sums_right_start_cost_0_value_2, sums_right_start_cost_0_is_equal : boolean;
    variable sums_right_start_cost_0_is_less, sums_turn_writes_copy_0_choice, winnersmask_inside_63_choice : boolean;
    variable winnersother_cost_0_1_is_equal : boolean;
    variable winnersother_cost_0_choice : boolean_1d(1 to 62);  -- winnersother_cost_0_#_choice
    variable winnersother_cost_0_choices : boolean_2d(1 to 62, 2 to 9);  -- winnersother_cost_0_#_choice_#
    variable winnersother_cost_0_value : boolean_1d(1 to 62);  -- winnersother_cost_0_#_value
    variable winnersother_cost_0_values : boolean_2d(1 to 62, 2 to 5);  -- winnersother_cost_0_#_value_#
    variable winnersother_cost_0_all : boolean_1d(1 to 63);  -- winnersother_cost_0_#_all
    variable winnersother_cost_0_2_value_6, winnersother_cost_0_3_is_equal, winnersother_cost_0_4_value_6 : boolean;
    variable winnersother_cost_0_5_is_equal, winnersother_cost_0_6_value_6, winnersother_cost_0_7_is_equal : boolean;
    variable winnersother_cost_0_8_value_6, winnersother_cost_0_9_is_equal, winnersother_cost_0_10_value_6 : boolean;
    variable winnersother_cost_0_11_is_equal, winnersother_cost_0_12_value_6, winnersother_cost_0_13_is_equal : boolean;
    variable winnersother_cost_0_14_value_6, winnersother_cost_0_15_is_equal, winnersother_cost_0_16_value_6 : boolean;
    variable winnersother_cost_0_17_is_equal, winnersother_cost_0_18_value_6, winnersother_cost_0_19_is_equal : boolean;
    variable winnersother_cost_0_20_value_6, winnersother_cost_0_21_is_equal, winnersother_cost_0_22_value_6 : boolean;
    variable winnersother_cost_0_23_is_equal, winnersother_cost_0_24_value_6, winnersother_cost_0_25_is_equal : boolean;
    variable winnersother_cost_0_26_value_6, winnersother_cost_0_27_is_equal, winnersother_cost_0_28_value_6 : boolean;
    variable winnersother_cost_0_29_is_equal, winnersother_cost_0_30_value_6, winnersother_cost_0_31_is_equal : boolean;
    variable winnersother_cost_0_32_value_6, winnersother_cost_0_33_is_equal, winnersother_cost_0_34_value_6 : boolean;
    variable winnersother_cost_0_35_is_equal, winnersother_cost_0_36_value_6, winnersother_cost_0_37_is_equal : boolean;
    variable winnersother_cost_0_38_value_6, winnersother_cost_0_39_is_equal, winnersother_cost_0_40_value_6 : boolean;
    variable winnersother_cost_0_41_is_equal, winnersother_cost_0_42_value_6, winnersother_cost_0_43_is_equal : boolean;
    variable winnersother_cost_0_44_value_6, winnersother_cost_0_45_is_equal, winnersother_cost_0_46_value_6 : boolean;
    variable winnersother_cost_0_47_is_equal, winnersother_cost_0_48_value_6, winnersother_cost_0_49_is_equal : boolean;
    variable winnersother_cost_0_50_value_6, winnersother_cost_0_51_is_equal, winnersother_cost_0_52_value_6 : boolean;
    variable winnersother_cost_0_53_is_equal, winnersother_cost_0_54_value_6, winnersother_cost_0_55_is_equal : boolean;
    variable winnersother_cost_0_56_value_6, winnersother_cost_0_57_is_equal, winnersother_cost_0_58_value_6 : boolean;
    variable winnersother_cost_0_59_is_equal, winnersother_cost_0_60_value_6, winnersother_cost_0_61_is_equal : boolean;
    variable winnersother_cost_0_62_value_6, winnersother_winner_0_0_value, winnersother_winner_0_0_choice : boolean;
    variable winnersother_winner_0_0_choices : boolean_1d(2 to 8);  -- winnersother_winner_0_0_choice_#
    variable winnersother_winner_0_0_values : boolean_1d(2 to 6);  -- winnersother_winner_0_0_value_#
    variable winnerswinner1_best_index_0_choice : boolean_1d(0 to 31);  -- winnerswinner1_best_index_0_#_choice
    variable winnerswinner1_best_index_0_choices : boolean_2d(0 to 31, 2 to 8);  -- winnerswinner1_best_index_0_#_choice_#
    variable winnerswinner1_best_index_0_31_value : boolean;
    variable winnerswinner1_best_index_0_31_values : boolean_1d(2 to 5);  -- winnerswinner1_best_index_0_31_value_#
    variable winnerswinner2_best_index_0_choice : boolean_1d(0 to 15);  -- winnerswinner2_best_index_0_#_choice
    variable winnerswinner2_best_index_0_choices : boolean_2d(0 to 15, 2 to 8);  -- winnerswinner2_best_index_0_#_choice_#
    variable winnerswinner2_best_index_0_value : boolean_1d(0 to 15);  -- winnerswinner2_best_index_0_#_value
    variable winnerswinner2_best_index_0_values : boolean_2d(0 to 15, 2 to 5);  -- winnerswinner2_best_index_0_#_value_#
    variable winnerswinner2_best_below_0_is_equal : boolean_1d(0 to 3);  -- winnerswinner2_best_below_0_#_is_equal
    variable winnerswinner2_best_below_0_value : boolean_1d(4 to 6);  -- winnerswinner2_best_below_0_#_value
    variable winnerswinner2_best_below_0_5_value_2 : boolean;
    variable winnerswinner2_best_below_0_is_equals : boolean_1d(6 to 15);  -- winnerswinner2_best_below_0_#_is_equal
    variable winnerswinner2_best_below_0_values : boolean_1d(10 to 14);  -- winnerswinner2_best_below_0_#_value
    variable winnerswinner2_best_below_0_14_value_2 : boolean;
    variable winnerswinner2_best_at_start_0_choice : boolean_1d(0 to 15);  -- winnerswinner2_best_at_start_0_#_choice
    variable winnerswinner3_best_index_0_choice : boolean_1d(0 to 7);  -- winnerswinner3_best_index_0_#_choice
    variable winnerswinner3_best_index_0_choices : boolean_2d(0 to 7, 2 to 8);  -- winnerswinner3_best_index_0_#_choice_#
    variable winnerswinner3_best_index_0_value : boolean_1d(0 to 7);  -- winnerswinner3_best_index_0_#_value
    variable winnerswinner3_best_index_0_values : boolean_2d(0 to 7, 2 to 5);  -- winnerswinner3_best_index_0_#_value_#
    variable winnerswinner3_best_below_0_is_equal : boolean_1d(0 to 1);  -- winnerswinner3_best_below_0_#_is_equal
    variable winnerswinner3_best_below_0_2_value : boolean;
    variable winnerswinner3_best_below_0_is_equals : boolean_1d(3 to 7);  -- winnerswinner3_best_below_0_#_is_equal
    variable winnerswinner3_best_below_0_value : boolean_1d(5 to 6);  -- winnerswinner3_best_below_0_#_value
    variable winnerswinner3_best_above_0_is_equal : boolean_1d(0 to 1);  -- winnerswinner3_best_above_0_#_is_equal
    variable winnerswinner3_best_above_0_value : boolean_1d(2 to 3);  -- winnerswinner3_best_above_0_#_value
    variable winnerswinner3_best_above_0_is_equals : boolean_1d(3 to 7);  -- winnerswinner3_best_above_0_#_is_equal
    variable winnerswinner3_best_above_0_values : boolean_1d(5 to 7);  -- winnerswinner3_best_above_0_#_value
    variable winnerswinner3_best_above_0_7_value_2 : boolean;
    variable winnerswinner3_best_at_start_0_choice : boolean_1d(0 to 7);  -- winnerswinner3_best_at_start_0_#_choice
    variable winnerswinner4_best_index_0_choice : boolean_1d(0 to 3);  -- winnerswinner4_best_index_0_#_choice
    variable winnerswinner4_best_index_0_choices : boolean_2d(0 to 3, 2 to 8);  -- winnerswinner4_best_index_0_#_choice_#
    variable winnerswinner4_best_index_0_value : boolean_1d(0 to 3);  -- winnerswinner4_best_index_0_#_value
    variable winnerswinner4_best_index_0_values : boolean_2d(0 to 3, 2 to 5);  -- winnerswinner4_best_index_0_#_value_#
    variable winnerswinner4_best_below_0_is_equal : boolean_1d(0 to 3);  -- winnerswinner4_best_below_0_#_is_equal
    variable winnerswinner4_best_below_0_2_value, winnerswinner4_best_above_0_0_is_equal : boolean;
    variable winnerswinner4_best_above_0_1_value, winnerswinner4_best_above_0_1_value_2 : boolean;
    variable winnerswinner4_best_above_0_is_equal : boolean_1d(2 to 3);  -- winnerswinner4_best_above_0_#_is_equal
    variable winnerswinner4_best_above_0_3_value : boolean;
    variable winnerswinner4_best_at_start_0_choice : boolean_1d(0 to 3);  -- winnerswinner4_best_at_start_0_#_choice
    variable winnerswinner5_best_index_0_choice : boolean_1d(0 to 1);  -- winnerswinner5_best_index_0_#_choice
    variable winnerswinner5_best_index_0_choices : boolean_2d(0 to 1, 2 to 8);  -- winnerswinner5_best_index_0_#_choice_#
    variable winnerswinner5_best_index_0_value : boolean_1d(0 to 1);  -- winnerswinner5_best_index_0_#_value
    variable winnerswinner5_best_index_0_values : boolean_2d(0 to 1, 2 to 5);  -- winnerswinner5_best_index_0_#_value_#
    variable winnerswinner5_best_below_0_is_equal : boolean_1d(0 to 1);  -- winnerswinner5_best_below_0_#_is_equal
    variable winnerswinner5_best_above_0_is_equal : boolean_1d(0 to 1);  -- winnerswinner5_best_above_0_#_is_equal
    variable winnerswinner5_best_above_0_1_value : boolean;
    variable winnerswinner5_best_at_start_0_choice : boolean_1d(0 to 1);  -- winnerswinner5_best_at_start_0_#_choice
    variable winnerswinner6_best_index_0_0_choice : boolean;
    variable winnerswinner6_best_index_0_0_choices : boolean_1d(2 to 8);  -- winnerswinner6_best_index_0_0_choice_#
    variable winnerswinner6_best_index_0_0_value : boolean;
    variable winnerswinner6_best_index_0_0_values : boolean_1d(2 to 5);  -- winnerswinner6_best_index_0_0_value_#
    variable winnerswinner6_best_below_0_0_is_equal, winnerswinner6_best_above_0_0_is_equal : boolean;
    variable winnerswinner6_best_at_start_0_0_choice, refinement_below_0_differs : boolean;
    variable refinement_below_0_differs_2, refinement_below_0_all, refinement_above_0_choice : boolean;
    variable refinement_divisor_0_0_is_less, leftright_holds_winners_choice, turn_order_address_any : boolean;
    variable turn_order_address_any_2, turn_order_falls_all, turn_order_complete_all : boolean;
    variable turn_ready_tag_row_start_differs, turn_ready_tag_row_start_is_equal : boolean;
    variable turn_ready_tag_row_start_choice : boolean;
    variable turn_ready_tag_row_start_choices : boolean_1d(2 to 3);  -- turn_ready_tag_row_start_choice_#
    variable turn_ready_tag_row_start_is_equal_2, turn_ready_tag_row_start_all : boolean;
    variable turn_ready_tag_row_start_all_2, support_newest_0_value, support_moment_0_start_of_frame_choice : boolean;
    variable support_next_tag_choice, support_next_tag_choice_2 : boolean;
    variable support_like_0_0_choice : boolean_1d(0 to 2);  -- support_like_0_#_0_choice
    variable support_like_0_1_differs : boolean_1d(0 to 2);  -- support_like_0_#_1_differs
    variable support_like_0_0_choices : boolean_1d(4 to 6);  -- support_like_0_#_0_choice
    variable support_like_0_1_differss : boolean_1d(4 to 6);  -- support_like_0_#_1_differs
    variable support_out_tag_row_start_differs, support_out_tag_row_start_is_equal : boolean;
    variable support_out_tag_row_start_choice : boolean;
    variable support_out_tag_row_start_choices : boolean_1d(2 to 3);  -- support_out_tag_row_start_choice_#
    variable support_out_tag_row_start_is_equal_2, support_out_tag_row_start_all : boolean;
    variable support_out_tag_row_start_all_2, fill_ends_read_place_0_is_equal, fill_ends_read_place_0_choice : boolean;
    variable fill_out_disparity_0_all, fill_out_disparity_0_all_2, fill_out_filled_0_is_equal : boolean;
    variable fill_out_filled_0_choice, fill_out_tag_row_start_differs, fill_out_tag_row_start_is_equal : boolean;
    variable fill_out_tag_row_start_choice : boolean;
    variable fill_out_tag_row_start_choices : boolean_1d(2 to 3);  -- fill_out_tag_row_start_choice_#
    variable fill_out_tag_row_start_is_equal_2, fill_out_tag_row_start_all, fill_out_tag_row_start_all_2 : boolean;
    variable fill_ends_next_place_0_choice, fill_ends_next_place_0_choice_2, fill_ends_row_place_0_all : boolean;
    variable fill_beside_0_left_any, median_counter_group_is_equal, median_line_ended_choice : boolean;
    variable median_window_complete_is_equal, median_window_complete_choice : boolean;
    variable median_low_0_all : boolean_1d(0 to 1);  -- median_low_#_0_all
    variable relief_newest_choice : boolean;
    variable relief_newest_choices : boolean_1d(2 to 15);  -- relief_newest_choice_#
    variable relief_newest_value : boolean;
    variable relief_newest_values : boolean_1d(2 to 5);  -- relief_newest_value_#
    variable transform_counter_group_choice, raster_place_group_choice : natural range 0 to 375;
    variable support_counter_group_choice, fill_counter_group_choice : natural range 0 to 375;
    variable median_counter_group_choice : natural range 0 to 375;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- transform_counter_group_choice_#
    variable raster_place_group_choices : natural_511_1d(2 to 3);  -- raster_place_group_choice_#
    variable sums_turn_waiting_read_place_choice, sums_turn_waiting_read_place_choice_2 : natural range 0 to 511;
    variable support_counter_group_choices : natural_511_1d(2 to 3);  -- support_counter_group_choice_#
    variable fill_counter_group_choices : natural_511_1d(2 to 3);  -- fill_counter_group_choice_#
    variable fill_takes_left_0_choice_2 : natural range 0 to 511;
    variable median_counter_group_choices : natural_511_1d(2 to 3);  -- median_counter_group_choice_#
    variable transform_left_filter_feature_0_choice_17 : natural range 0 to 3;
    variable transform_right_filter_feature_0_choice_17 : natural range 0 to 3;
    variable slice0_held_0_choice : natural_15_1d(0 to 15);  -- slice0_held_0_#_choice
    variable slice1_held_0_choice : natural_15_1d(0 to 15);  -- slice1_held_0_#_choice
    variable slice2_held_0_choice : natural_15_1d(0 to 15);  -- slice2_held_0_#_choice
    variable slice3_held_0_choice : natural_15_1d(0 to 15);  -- slice3_held_0_#_choice
    variable entry_order_address_choice, turn_order_address_choice : natural range 1 to 511;
    variable entry_order_address_choice_2, turn_order_address_choice_2 : natural range 0 to 447;
    variable forward_left_pair_choice : natural_127_1d(0 to 31);  -- forward_left_pair_#_choice
    variable forward_left_g_copy_0_value, forward_left_g_less_copy_0_value : natural range 0 to 127;
    variable forward_left_cost_choice : natural_127_1d(0 to 63);  -- forward_left_cost_#_choice
    variable forward_left_cost_choice_2 : natural_127_1d(0 to 63);  -- forward_left_cost_#_choice_2
    variable forward_left_arrived_choice : natural_127_1d(0 to 63);  -- forward_left_arrived_#_choice
    variable forward_left_arrived_choice_2 : natural_127_1d(3 to 4);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s : natural_127_1d(7 to 8);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_11 : natural_127_1d(11 to 12);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_15 : natural_127_1d(15 to 16);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_19 : natural_127_1d(19 to 20);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_23 : natural_127_1d(23 to 24);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_27 : natural_127_1d(27 to 28);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_31 : natural_127_1d(31 to 32);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_35 : natural_127_1d(35 to 36);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_39 : natural_127_1d(39 to 40);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_43 : natural_127_1d(43 to 44);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_47 : natural_127_1d(47 to 48);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_51 : natural_127_1d(51 to 52);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_55 : natural_127_1d(55 to 56);  -- forward_left_arrived_#_choice_2
    variable forward_left_arrived_choice_2s_from_59 : natural_127_1d(59 to 60);  -- forward_left_arrived_#_choice_2
    variable sums_right_pair_choice : natural_127_1d(0 to 31);  -- sums_right_pair_#_choice
    variable sums_right_g_copy_0_value, sums_right_g_less_copy_0_value : natural range 0 to 127;
    variable sums_right_cost_choice : natural_127_1d(0 to 63);  -- sums_right_cost_#_choice
    variable sums_right_cost_choice_2 : natural_127_1d(0 to 63);  -- sums_right_cost_#_choice_2
    variable sums_right_arrived_choice : natural_127_1d(0 to 63);  -- sums_right_arrived_#_choice
    variable sums_right_arrived_choice_2 : natural_127_1d(3 to 4);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s : natural_127_1d(7 to 8);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_11 : natural_127_1d(11 to 12);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_15 : natural_127_1d(15 to 16);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_19 : natural_127_1d(19 to 20);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_23 : natural_127_1d(23 to 24);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_27 : natural_127_1d(27 to 28);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_31 : natural_127_1d(31 to 32);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_35 : natural_127_1d(35 to 36);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_39 : natural_127_1d(39 to 40);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_43 : natural_127_1d(43 to 44);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_47 : natural_127_1d(47 to 48);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_51 : natural_127_1d(51 to 52);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_55 : natural_127_1d(55 to 56);  -- sums_right_arrived_#_choice_2
    variable sums_right_arrived_choice_2s_from_59 : natural_127_1d(59 to 60);  -- sums_right_arrived_#_choice_2
    variable support_like_0_value : natural_127_2d(0 to 6, 0 to 4);  -- support_like_0_#_#_value
    variable forward_left_start_cost_0_choices_from_7 : natural_63_1d(7 to 9);  -- forward_left_start_cost_0_choice_#
    variable forward_left_room_value, forward_left_room_choice : natural range 0 to 63;
    variable forward_left_room_choices : natural_63_1d(2 to 3);  -- forward_left_room_choice_#
    variable sums_right_start_cost_0_choices_from_7 : natural_63_1d(7 to 9);  -- sums_right_start_cost_0_choice_#
    variable sums_right_room_value, sums_right_room_choice : natural range 0 to 63;
    variable sums_right_room_choices : natural_63_1d(2 to 3);  -- sums_right_room_choice_#
    variable leftright_address_0_value : natural range 0 to 63;
    variable forward_left_smallest_choice, forward_left_relief_pairs_0_choice : natural range 0 to 31;
    variable forward_left_relief_older_choice, forward_left_relief_recent_choice : natural range 0 to 31;
    variable forward_left_relief_largest_choice : natural range 0 to 31;
    variable forward_above_total_choice : natural_31_1d(0 to 63);  -- forward_above_total_#_choice
    variable sums_right_smallest_choice, sums_right_relief_pairs_0_choice : natural range 0 to 31;
    variable sums_right_relief_older_choice, sums_right_relief_recent_choice : natural range 0 to 31;
    variable sums_right_relief_largest_choice, relief_newest_choice_16 : natural range 0 to 31;
    variable forward_left_smallest_difference : integer range -31 to 46;
    variable forward_left_relief_reach_of_best_sum, forward_left_relief_reach_of_best_choice : natural range 0 to 190;
    variable sums_right_relief_reach_of_best_sum, sums_right_relief_reach_of_best_choice : natural range 0 to 190;
    variable forward_left_relief_reach_of_best_choices : natural_255_1d(2 to 3);  -- forward_left_relief_reach_of_best_choice_#
    variable sums_right_relief_reach_of_best_choices : natural_255_1d(2 to 3);  -- sums_right_relief_reach_of_best_choice_#
    variable winnerswinner2_best_below_0_choice : natural_255_1d(0 to 15);  -- winnerswinner2_best_below_0_#_choice
    variable winnerswinner2_best_above_0_choice : natural_255_1d(0 to 15);  -- winnerswinner2_best_above_0_#_choice
    variable winnerswinner2_best_second_0_choice : natural_255_1d(0 to 15);  -- winnerswinner2_best_second_0_#_choice
    variable winnerswinner2_best_second_0_choices : natural_255_2d(0 to 15, 2 to 4);  -- winnerswinner2_best_second_0_#_choice_#
    variable winnerswinner3_best_below_0_choice : natural_255_1d(0 to 7);  -- winnerswinner3_best_below_0_#_choice
    variable winnerswinner3_best_above_0_choice : natural_255_1d(0 to 7);  -- winnerswinner3_best_above_0_#_choice
    variable winnerswinner3_best_second_0_choice : natural_255_1d(0 to 7);  -- winnerswinner3_best_second_0_#_choice
    variable winnerswinner3_best_second_0_choices : natural_255_2d(0 to 7, 2 to 4);  -- winnerswinner3_best_second_0_#_choice_#
    variable winnerswinner4_best_below_0_choice : natural_255_1d(0 to 3);  -- winnerswinner4_best_below_0_#_choice
    variable winnerswinner4_best_above_0_choice : natural_255_1d(0 to 3);  -- winnerswinner4_best_above_0_#_choice
    variable winnerswinner4_best_second_0_choice : natural_255_1d(0 to 3);  -- winnerswinner4_best_second_0_#_choice
    variable winnerswinner4_best_second_0_choices : natural_255_2d(0 to 3, 2 to 4);  -- winnerswinner4_best_second_0_#_choice_#
    variable winnerswinner5_best_below_0_choice : natural_255_1d(0 to 1);  -- winnerswinner5_best_below_0_#_choice
    variable winnerswinner5_best_above_0_choice : natural_255_1d(0 to 1);  -- winnerswinner5_best_above_0_#_choice
    variable winnerswinner5_best_second_0_choice : natural_255_1d(0 to 1);  -- winnerswinner5_best_second_0_#_choice
    variable winnerswinner5_best_second_0_choices : natural_255_2d(0 to 1, 2 to 4);  -- winnerswinner5_best_second_0_#_choice_#
    variable winnerswinner6_best_below_0_0_choice, winnerswinner6_best_above_0_0_choice : natural range 0 to 255;
    variable winnerswinner6_best_second_0_0_choice : natural range 0 to 255;
    variable winnerswinner6_best_second_0_0_choices : natural_255_1d(2 to 4);  -- winnerswinner6_best_second_0_0_choice_#
    variable refinement_divisor_0_0_choice, refinement_fraction_0_choice : natural range 0 to 255;
    variable support_out_sure_0_choice : natural range 0 to 255;
    variable fill_ends_read_place_0_choices : natural_255_1d(2 to 3);  -- fill_ends_read_place_0_choice_#
    variable fill_takes_left_0_choice : natural range 0 to 255;
    variable relief_newest_values_from_6 : natural_255_1d(6 to 7);  -- relief_newest_value_#
    variable forward_left_relief_leaves_choice, sums_right_relief_leaves_choice : natural range 64 to 127;
    variable forward_above_write_words_choice : natural_36_1d(0 to 10);  -- forward_above_write_words_#_choice
    variable forward_above_write_words_choices : natural_36_2d(0 to 9, 2 to 6);  -- forward_above_write_words_#_choice_#
    variable forward_above_write_words_10_choices : natural_36_1d(2 to 4);  -- forward_above_write_words_10_choice_#
    variable sums_right_smallest_difference : integer range -31 to 31;
    variable winners_partner_at_sum : natural range 1 to 512;
    variable winners_partner_at_choice : natural range 0 to 512;
    variable refinement_remainder_1_0_difference : natural range 257 to 767;
    variable refinement_remainder_0_difference : natural_257_to_1022_1d(2 to 7);  -- refinement_remainder_#_0_difference
    variable refinement_fraction_0_difference : integer range -15 to 0;
    variable refinement_fraction_0_value : natural range 0 to 16;
    variable refinement_fraction_0_choice_2 : natural range 0 to 7;
    variable leftright_checked_passed_0_difference : integer range -62 to 64;
    variable support_column_choice : natural_63_to_127_1d(0 to 4);  -- support_column_#_choice
    variable support_like_0_0_0_difference : integer range -62 to 1;
    variable fill_out_disparity_0_choice : natural range 0 to 1023;
    variable fill_out_disparity_0_choice_2, median_of_column_0_c_choice : natural range 0 to 32767;
    variable median_sorted_low_0_choice, median_sorted_low_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_middle_0_choice, median_sorted_middle_0_choice_2 : natural range 0 to 32767;
    variable median_sorted_high_0_choice, median_sorted_high_0_choice_2 : natural range 0 to 32767;
    variable median_largest_low_0_choice, median_largest_low_0_choice_2 : natural range 0 to 32767;
    variable median_median_middle_0_choice : natural range 0 to 32767;
    variable median_median_middle_0_choices : natural_32767_1d(2 to 4);  -- median_median_middle_0_choice_#
    variable median_smallest_high_0_choice, median_smallest_high_0_choice_2 : natural range 0 to 32767;
    variable median_out_disparity_0_choice : natural range 0 to 32767;
    variable median_out_disparity_0_choices : natural_32767_1d(2 to 4);  -- median_out_disparity_0_choice_#
    variable median_low_0_0_choice, median_middle_0_0_choice, median_high_0_0_choice : natural range 0 to 32767;
    variable fill_write_above_0_choice : natural range 0 to 65535;
    variable median_of_column_0_a_choice : natural range 0 to 4095;
  begin
    if rising_edge(clock) then
      -- transform
      transform_counter_group_is_equal := transform_counter_group = 374;
      transform_counter_group_is_equal_2 := transform_counter_column = 449;
      transform_counter_group_all := transform_counter_group_is_equal and transform_counter_group_is_equal_2;
      if transform_counter_group_all then
        transform_counter_group_choice := 375;
      else
        transform_counter_group_choice := 0;
      end if;
      transform_counter_group_differs := transform_counter_group /= 377;
      if (transform_counter_group = 376) and transform_counter_next_frame then
        transform_counter_group_choices(2) := 2;
      else
        transform_counter_group_choices(2) := (transform_counter_group + 1) mod 512;
      end if;
      if transform_counter_group_differs and in_valid and transform_counter_group_is_equal_2 then
        transform_counter_group_choices(3) := transform_counter_group_choices(2);
      else
        transform_counter_group_choices(3) := transform_counter_group;
      end if;
      transform_read_column_inside_0_is_less := 3 < transform_counter_column;
      transform_left_filter_feature_0_value := is_set(transform_left_filter_column_2(4), 1);
      transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_value) or (not
        is_set(transform_left_filter_column_2(4), 0));
      if is_set(transform_left_filter_column_0(4), 0) then
        transform_left_filter_feature_0_choice := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choice := not transform_left_filter_feature_0_value;
      end if;
      transform_left_filter_feature_0_is_equal := (transform_left_filter_column_2(4) mod 4) = 0;
      if is_set(transform_left_filter_column_0(4), 1) then
        transform_left_filter_feature_0_choices(2) := transform_left_filter_feature_0_choice;
      else
        transform_left_filter_feature_0_choices(2) := is_set(transform_left_filter_column_0(4), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      transform_left_filter_feature_0_values(2) := is_set(transform_left_filter_column_2(4), 2);
      if transform_left_filter_feature_0_choices(2) then
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(3) := (not is_set(transform_left_filter_column_0(4), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column_2(4), i);
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(4), i)) or
            transform_left_filter_feature_0_values(i);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_0(4), i)) and
            transform_left_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(7) then
        transform_left_filter_feature_0_choices(8) := is_set(transform_left_filter_column_0(4), 7) and (not
          is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(8) := is_set(transform_left_filter_column_0(4), 7) or (not
          is_set(transform_left_filter_column_2(4), 7));
      end if;
      if is_set(transform_left_filter_column_4(4), 0) then
        transform_left_filter_feature_0_choices(9) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices(9) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_4(4), 1) then
        transform_left_filter_feature_0_choices(10) := transform_left_filter_feature_0_choices(9);
      else
        transform_left_filter_feature_0_choices(10) := is_set(transform_left_filter_column_4(4), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices(10) then
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column_4(4), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices(11) := (not is_set(transform_left_filter_column_4(4), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 11 to 14 loop
        if transform_left_filter_feature_0_choices(i) then
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 8)) or
            transform_left_filter_feature_0_values(i - 8);
        else
          transform_left_filter_feature_0_choices(i + 1) := (not is_set(transform_left_filter_column_4(4), i - 8)) and
            transform_left_filter_feature_0_values(i - 8);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices(15) then
        transform_left_filter_feature_0_choices(16) := is_set(transform_left_filter_column_4(4), 7) and (not
          is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices(16) := is_set(transform_left_filter_column_4(4), 7) or (not
          is_set(transform_left_filter_column_2(4), 7));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_left_filter_feature_0_choice_17 := as_number(transform_left_filter_feature_0_choices(8)) +
          (as_number(transform_left_filter_feature_0_choices(16)) * 2);
      else
        transform_left_filter_feature_0_choice_17 := 0;
      end if;
      if is_set(transform_left_filter_column_2(0), 0) then
        transform_left_filter_feature_0_choices_from_18(18) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(18) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_2(0), 1) then
        transform_left_filter_feature_0_choices_from_18(19) := transform_left_filter_feature_0_choices_from_18(18);
      else
        transform_left_filter_feature_0_choices_from_18(19) := is_set(transform_left_filter_column_2(0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(19) then
        transform_left_filter_feature_0_choices_from_18(20) := (not is_set(transform_left_filter_column_2(0), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(20) := (not is_set(transform_left_filter_column_2(0), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 20 to 23 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(0), i -
            17)) or transform_left_filter_feature_0_values(i - 17);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(0), i -
            17)) and transform_left_filter_feature_0_values(i - 17);
        end if;
      end loop;
      transform_left_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(0), 7) then
        transform_left_filter_feature_0_choices_from_18(25) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices_from_18(25) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices_from_18(24) then
        transform_left_filter_feature_0_choices_from_18(26) := is_set(transform_left_filter_column_2(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(26) := transform_left_filter_feature_0_choices_from_18(25);
      end if;
      if is_set(transform_left_filter_column_0(0), 0) then
        transform_left_filter_feature_0_choices_from_18(27) := (transform_left_filter_column_2(4) mod 4) = 3;
      else
        transform_left_filter_feature_0_choices_from_18(27) := transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_0(0), 1) then
        transform_left_filter_feature_0_choices_from_18(28) := transform_left_filter_feature_0_choices_from_18(27);
      else
        transform_left_filter_feature_0_choices_from_18(28) := (not is_set(transform_left_filter_column_0(0), 0)) or
          transform_left_filter_feature_0_value or is_set(transform_left_filter_column_2(4), 0);
      end if;
      transform_left_filter_feature_0_values(7) := is_set(transform_left_filter_column_0(0), 2);
      if transform_left_filter_feature_0_choices_from_18(28) then
        transform_left_filter_feature_0_choices_from_18(29) := transform_left_filter_feature_0_values(7) and (not
          transform_left_filter_feature_0_values(2));
      else
        transform_left_filter_feature_0_choices_from_18(29) := transform_left_filter_feature_0_values(7) or (not
          transform_left_filter_feature_0_values(2));
      end if;
      for i in 8 to 11 loop
        transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column_0(0), i - 5);
        if transform_left_filter_feature_0_choices_from_18(i + 21) then
          transform_left_filter_feature_0_choices_from_18(i + 22) := transform_left_filter_feature_0_values(i) or (not
            transform_left_filter_feature_0_values(i - 5));
        else
          transform_left_filter_feature_0_choices_from_18(i + 22) := transform_left_filter_feature_0_values(i) and (not
            transform_left_filter_feature_0_values(i - 5));
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(0), 7) then
        transform_left_filter_feature_0_choices_from_18(34) := transform_filtering_0_column_inside_0;
      else
        transform_left_filter_feature_0_choices_from_18(34) := transform_left_filter_feature_0_all;
      end if;
      if transform_left_filter_feature_0_choices_from_18(33) then
        transform_left_filter_feature_0_choices_from_18(35) := transform_left_filter_feature_0_choices_from_18(34);
      else
        transform_left_filter_feature_0_choices_from_18(35) := is_set(transform_left_filter_column_0(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_left_filter_column_2(4), 7));
      end if;
      if is_set(transform_left_filter_column_4(0), 0) then
        transform_left_filter_feature_0_choices_from_18(36) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(36) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_4(0), 1) then
        transform_left_filter_feature_0_choices_from_18(37) := transform_left_filter_feature_0_choices_from_18(36);
      else
        transform_left_filter_feature_0_choices_from_18(37) := is_set(transform_left_filter_column_4(0), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(37) then
        transform_left_filter_feature_0_choices_from_18(38) := (not is_set(transform_left_filter_column_4(0), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(38) := (not is_set(transform_left_filter_column_4(0), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 38 to 41 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(0), i -
            35)) or transform_left_filter_feature_0_values(i - 35);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(0), i -
            35)) and transform_left_filter_feature_0_values(i - 35);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(42) then
        transform_left_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0 and
          is_set(transform_left_filter_column_4(0), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0 and
          (is_set(transform_left_filter_column_4(0), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(2), 0) then
        transform_left_filter_feature_0_choices_from_18(44) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(44) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_2(2), 1) then
        transform_left_filter_feature_0_choices_from_18(45) := transform_left_filter_feature_0_choices_from_18(44);
      else
        transform_left_filter_feature_0_choices_from_18(45) := is_set(transform_left_filter_column_2(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(45) then
        transform_left_filter_feature_0_choices_from_18(46) := (not is_set(transform_left_filter_column_2(2), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(46) := (not is_set(transform_left_filter_column_2(2), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 46 to 49 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(2), i -
            43)) or transform_left_filter_feature_0_values(i - 43);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(2), i -
            43)) and transform_left_filter_feature_0_values(i - 43);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(2) := transform_filtering_0_column_inside_2 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(2), 7) then
        transform_left_filter_feature_0_choices_from_18(51) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices_from_18(51) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices_from_18(50) then
        transform_left_filter_feature_0_choices_from_18(52) := is_set(transform_left_filter_column_2(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(52) := transform_left_filter_feature_0_choices_from_18(51);
      end if;
      if is_set(transform_left_filter_column_0(2), 0) then
        transform_left_filter_feature_0_choices_from_18(53) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(53) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_0(2), 1) then
        transform_left_filter_feature_0_choices_from_18(54) := transform_left_filter_feature_0_choices_from_18(53);
      else
        transform_left_filter_feature_0_choices_from_18(54) := is_set(transform_left_filter_column_0(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(54) then
        transform_left_filter_feature_0_choices_from_18(55) := (not is_set(transform_left_filter_column_0(2), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(55) := (not is_set(transform_left_filter_column_0(2), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 55 to 58 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(2), i -
            52)) or transform_left_filter_feature_0_values(i - 52);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(2), i -
            52)) and transform_left_filter_feature_0_values(i - 52);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(2), 7) then
        transform_left_filter_feature_0_choices_from_18(60) := transform_filtering_0_column_inside_2;
      else
        transform_left_filter_feature_0_choices_from_18(60) := transform_left_filter_feature_0_alls(2);
      end if;
      if transform_left_filter_feature_0_choices_from_18(59) then
        transform_left_filter_feature_0_choices_from_18(61) := is_set(transform_left_filter_column_0(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(61) := transform_left_filter_feature_0_choices_from_18(60);
      end if;
      if is_set(transform_left_filter_column_4(2), 0) then
        transform_left_filter_feature_0_choices_from_18(62) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(62) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_4(2), 1) then
        transform_left_filter_feature_0_choices_from_18(63) := transform_left_filter_feature_0_choices_from_18(62);
      else
        transform_left_filter_feature_0_choices_from_18(63) := is_set(transform_left_filter_column_4(2), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(63) then
        transform_left_filter_feature_0_choices_from_18(64) := (not is_set(transform_left_filter_column_4(2), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(64) := (not is_set(transform_left_filter_column_4(2), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 64 to 67 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(2), i -
            61)) or transform_left_filter_feature_0_values(i - 61);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(2), i -
            61)) and transform_left_filter_feature_0_values(i - 61);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(68) then
        transform_left_filter_feature_0_choices_from_18(69) := transform_filtering_0_column_inside_2 and
          is_set(transform_left_filter_column_4(2), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(69) := transform_filtering_0_column_inside_2 and
          (is_set(transform_left_filter_column_4(2), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(6), 0) then
        transform_left_filter_feature_0_choices_from_18(70) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(70) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_2(6), 1) then
        transform_left_filter_feature_0_choices_from_18(71) := transform_left_filter_feature_0_choices_from_18(70);
      else
        transform_left_filter_feature_0_choices_from_18(71) := is_set(transform_left_filter_column_2(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(71) then
        transform_left_filter_feature_0_choices_from_18(72) := (not is_set(transform_left_filter_column_2(6), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(72) := (not is_set(transform_left_filter_column_2(6), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 72 to 75 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(6), i -
            69)) or transform_left_filter_feature_0_values(i - 69);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(6), i -
            69)) and transform_left_filter_feature_0_values(i - 69);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(3) := transform_filtering_0_column_inside_6 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(6), 7) then
        transform_left_filter_feature_0_choices_from_18(77) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices_from_18(77) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices_from_18(76) then
        transform_left_filter_feature_0_choices_from_18(78) := is_set(transform_left_filter_column_2(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(78) := transform_left_filter_feature_0_choices_from_18(77);
      end if;
      if is_set(transform_left_filter_column_0(6), 0) then
        transform_left_filter_feature_0_choices_from_18(79) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(79) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_0(6), 1) then
        transform_left_filter_feature_0_choices_from_18(80) := transform_left_filter_feature_0_choices_from_18(79);
      else
        transform_left_filter_feature_0_choices_from_18(80) := is_set(transform_left_filter_column_0(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(80) then
        transform_left_filter_feature_0_choices_from_18(81) := (not is_set(transform_left_filter_column_0(6), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(81) := (not is_set(transform_left_filter_column_0(6), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 81 to 84 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(6), i -
            78)) or transform_left_filter_feature_0_values(i - 78);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(6), i -
            78)) and transform_left_filter_feature_0_values(i - 78);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(6), 7) then
        transform_left_filter_feature_0_choices_from_18(86) := transform_filtering_0_column_inside_6;
      else
        transform_left_filter_feature_0_choices_from_18(86) := transform_left_filter_feature_0_alls(3);
      end if;
      if transform_left_filter_feature_0_choices_from_18(85) then
        transform_left_filter_feature_0_choices_from_18(87) := is_set(transform_left_filter_column_0(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(87) := transform_left_filter_feature_0_choices_from_18(86);
      end if;
      if is_set(transform_left_filter_column_4(6), 0) then
        transform_left_filter_feature_0_choices_from_18(88) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(88) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_4(6), 1) then
        transform_left_filter_feature_0_choices_from_18(89) := transform_left_filter_feature_0_choices_from_18(88);
      else
        transform_left_filter_feature_0_choices_from_18(89) := is_set(transform_left_filter_column_4(6), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(89) then
        transform_left_filter_feature_0_choices_from_18(90) := (not is_set(transform_left_filter_column_4(6), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(90) := (not is_set(transform_left_filter_column_4(6), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 90 to 93 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(6), i -
            87)) or transform_left_filter_feature_0_values(i - 87);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(6), i -
            87)) and transform_left_filter_feature_0_values(i - 87);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(94) then
        transform_left_filter_feature_0_choices_from_18(95) := transform_filtering_0_column_inside_6 and
          is_set(transform_left_filter_column_4(6), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(95) := transform_filtering_0_column_inside_6 and
          (is_set(transform_left_filter_column_4(6), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      if is_set(transform_left_filter_column_2(8), 0) then
        transform_left_filter_feature_0_choices_from_18(96) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(96) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_2(8), 1) then
        transform_left_filter_feature_0_choices_from_18(97) := transform_left_filter_feature_0_choices_from_18(96);
      else
        transform_left_filter_feature_0_choices_from_18(97) := is_set(transform_left_filter_column_2(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(97) then
        transform_left_filter_feature_0_choices_from_18(98) := (not is_set(transform_left_filter_column_2(8), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(98) := (not is_set(transform_left_filter_column_2(8), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 98 to 101 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(8), i -
            95)) or transform_left_filter_feature_0_values(i - 95);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_2(8), i -
            95)) and transform_left_filter_feature_0_values(i - 95);
        end if;
      end loop;
      transform_left_filter_feature_0_alls(4) := transform_filtering_0_column_inside_8 and (not
        is_set(transform_left_filter_column_2(4), 7));
      if is_set(transform_left_filter_column_2(8), 7) then
        transform_left_filter_feature_0_choices_from_18(103) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices_from_18(103) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices_from_18(102) then
        transform_left_filter_feature_0_choices_from_18(104) := is_set(transform_left_filter_column_2(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(104) := transform_left_filter_feature_0_choices_from_18(103);
      end if;
      if is_set(transform_left_filter_column_0(8), 0) then
        transform_left_filter_feature_0_choices_from_18(105) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(105) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_0(8), 1) then
        transform_left_filter_feature_0_choices_from_18(106) := transform_left_filter_feature_0_choices_from_18(105);
      else
        transform_left_filter_feature_0_choices_from_18(106) := is_set(transform_left_filter_column_0(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(106) then
        transform_left_filter_feature_0_choices_from_18(107) := (not is_set(transform_left_filter_column_0(8), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(107) := (not is_set(transform_left_filter_column_0(8), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 107 to 110 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(8), i -
            104)) or transform_left_filter_feature_0_values(i - 104);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_0(8), i -
            104)) and transform_left_filter_feature_0_values(i - 104);
        end if;
      end loop;
      if is_set(transform_left_filter_column_0(8), 7) then
        transform_left_filter_feature_0_choices_from_18(112) := transform_filtering_0_column_inside_8;
      else
        transform_left_filter_feature_0_choices_from_18(112) := transform_left_filter_feature_0_alls(4);
      end if;
      if transform_left_filter_feature_0_choices_from_18(111) then
        transform_left_filter_feature_0_choices_from_18(113) := is_set(transform_left_filter_column_0(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(113) := transform_left_filter_feature_0_choices_from_18(112);
      end if;
      if is_set(transform_left_filter_column_4(8), 0) then
        transform_left_filter_feature_0_choices_from_18(114) := transform_left_filter_feature_0_any;
      else
        transform_left_filter_feature_0_choices_from_18(114) := not transform_left_filter_feature_0_value;
      end if;
      if is_set(transform_left_filter_column_4(8), 1) then
        transform_left_filter_feature_0_choices_from_18(115) := transform_left_filter_feature_0_choices_from_18(114);
      else
        transform_left_filter_feature_0_choices_from_18(115) := is_set(transform_left_filter_column_4(8), 0) and
          transform_left_filter_feature_0_is_equal;
      end if;
      if transform_left_filter_feature_0_choices_from_18(115) then
        transform_left_filter_feature_0_choices_from_18(116) := (not is_set(transform_left_filter_column_4(8), 2)) and
          transform_left_filter_feature_0_values(2);
      else
        transform_left_filter_feature_0_choices_from_18(116) := (not is_set(transform_left_filter_column_4(8), 2)) or
          transform_left_filter_feature_0_values(2);
      end if;
      for i in 116 to 119 loop
        if transform_left_filter_feature_0_choices_from_18(i) then
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(8), i -
            113)) or transform_left_filter_feature_0_values(i - 113);
        else
          transform_left_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_left_filter_column_4(8), i -
            113)) and transform_left_filter_feature_0_values(i - 113);
        end if;
      end loop;
      if transform_left_filter_feature_0_choices_from_18(120) then
        transform_left_filter_feature_0_choices_from_18(121) := transform_filtering_0_column_inside_8 and
          is_set(transform_left_filter_column_4(8), 7) and (not is_set(transform_left_filter_column_2(4), 7));
      else
        transform_left_filter_feature_0_choices_from_18(121) := transform_filtering_0_column_inside_8 and
          (is_set(transform_left_filter_column_4(8), 7) or (not is_set(transform_left_filter_column_2(4), 7)));
      end if;
      transform_right_filter_feature_0_value := is_set(transform_right_filter_column_2(4), 1);
      transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_value) or (not
        is_set(transform_right_filter_column_2(4), 0));
      if is_set(transform_right_filter_column_0(4), 0) then
        transform_right_filter_feature_0_choice := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choice := not transform_right_filter_feature_0_value;
      end if;
      transform_right_filter_feature_0_is_equal := (transform_right_filter_column_2(4) mod 4) = 0;
      if is_set(transform_right_filter_column_0(4), 1) then
        transform_right_filter_feature_0_choices(2) := transform_right_filter_feature_0_choice;
      else
        transform_right_filter_feature_0_choices(2) := is_set(transform_right_filter_column_0(4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      transform_right_filter_feature_0_values(2) := is_set(transform_right_filter_column_2(4), 2);
      if transform_right_filter_feature_0_choices(2) then
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(3) := (not is_set(transform_right_filter_column_0(4), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 3 to 6 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column_2(4), i);
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(4), i)) or
            transform_right_filter_feature_0_values(i);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_0(4), i)) and
            transform_right_filter_feature_0_values(i);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(7) then
        transform_right_filter_feature_0_choices(8) := is_set(transform_right_filter_column_0(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices(8) := is_set(transform_right_filter_column_0(4), 7) or (not
          is_set(transform_right_filter_column_2(4), 7));
      end if;
      if is_set(transform_right_filter_column_4(4), 0) then
        transform_right_filter_feature_0_choices(9) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices(9) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_4(4), 1) then
        transform_right_filter_feature_0_choices(10) := transform_right_filter_feature_0_choices(9);
      else
        transform_right_filter_feature_0_choices(10) := is_set(transform_right_filter_column_4(4), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices(10) then
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column_4(4), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices(11) := (not is_set(transform_right_filter_column_4(4), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 11 to 14 loop
        if transform_right_filter_feature_0_choices(i) then
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 8)) or
            transform_right_filter_feature_0_values(i - 8);
        else
          transform_right_filter_feature_0_choices(i + 1) := (not is_set(transform_right_filter_column_4(4), i - 8))
            and transform_right_filter_feature_0_values(i - 8);
        end if;
      end loop;
      if transform_right_filter_feature_0_choices(15) then
        transform_right_filter_feature_0_choices(16) := is_set(transform_right_filter_column_4(4), 7) and (not
          is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices(16) := is_set(transform_right_filter_column_4(4), 7) or (not
          is_set(transform_right_filter_column_2(4), 7));
      end if;
      if transform_filtering_0_column_inside_4 then
        transform_right_filter_feature_0_choice_17 := as_number(transform_right_filter_feature_0_choices(8)) +
          (as_number(transform_right_filter_feature_0_choices(16)) * 2);
      else
        transform_right_filter_feature_0_choice_17 := 0;
      end if;
      if is_set(transform_right_filter_column_2(0), 0) then
        transform_right_filter_feature_0_choices_from_18(18) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(18) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_2(0), 1) then
        transform_right_filter_feature_0_choices_from_18(19) := transform_right_filter_feature_0_choices_from_18(18);
      else
        transform_right_filter_feature_0_choices_from_18(19) := is_set(transform_right_filter_column_2(0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(19) then
        transform_right_filter_feature_0_choices_from_18(20) := (not is_set(transform_right_filter_column_2(0), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(20) := (not is_set(transform_right_filter_column_2(0), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 20 to 23 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(0), i
            - 17)) or transform_right_filter_feature_0_values(i - 17);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(0), i
            - 17)) and transform_right_filter_feature_0_values(i - 17);
        end if;
      end loop;
      transform_right_filter_feature_0_all := transform_filtering_0_column_inside_0 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(0), 7) then
        transform_right_filter_feature_0_choices_from_18(25) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(25) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(24) then
        transform_right_filter_feature_0_choices_from_18(26) := is_set(transform_right_filter_column_2(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(26) := transform_right_filter_feature_0_choices_from_18(25);
      end if;
      if is_set(transform_right_filter_column_0(0), 0) then
        transform_right_filter_feature_0_choices_from_18(27) := (transform_right_filter_column_2(4) mod 4) = 3;
      else
        transform_right_filter_feature_0_choices_from_18(27) := transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_0(0), 1) then
        transform_right_filter_feature_0_choices_from_18(28) := transform_right_filter_feature_0_choices_from_18(27);
      else
        transform_right_filter_feature_0_choices_from_18(28) := (not is_set(transform_right_filter_column_0(0), 0)) or
          transform_right_filter_feature_0_value or is_set(transform_right_filter_column_2(4), 0);
      end if;
      transform_right_filter_feature_0_values(7) := is_set(transform_right_filter_column_0(0), 2);
      if transform_right_filter_feature_0_choices_from_18(28) then
        transform_right_filter_feature_0_choices_from_18(29) := transform_right_filter_feature_0_values(7) and (not
          transform_right_filter_feature_0_values(2));
      else
        transform_right_filter_feature_0_choices_from_18(29) := transform_right_filter_feature_0_values(7) or (not
          transform_right_filter_feature_0_values(2));
      end if;
      for i in 8 to 11 loop
        transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column_0(0), i - 5);
        if transform_right_filter_feature_0_choices_from_18(i + 21) then
          transform_right_filter_feature_0_choices_from_18(i + 22) := transform_right_filter_feature_0_values(i) or
            (not transform_right_filter_feature_0_values(i - 5));
        else
          transform_right_filter_feature_0_choices_from_18(i + 22) := transform_right_filter_feature_0_values(i) and
            (not transform_right_filter_feature_0_values(i - 5));
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(0), 7) then
        transform_right_filter_feature_0_choices_from_18(34) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(34) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(33) then
        transform_right_filter_feature_0_choices_from_18(35) := transform_right_filter_feature_0_choices_from_18(34);
      else
        transform_right_filter_feature_0_choices_from_18(35) := is_set(transform_right_filter_column_0(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      end if;
      if is_set(transform_right_filter_column_4(0), 0) then
        transform_right_filter_feature_0_choices_from_18(36) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(36) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_4(0), 1) then
        transform_right_filter_feature_0_choices_from_18(37) := transform_right_filter_feature_0_choices_from_18(36);
      else
        transform_right_filter_feature_0_choices_from_18(37) := is_set(transform_right_filter_column_4(0), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(37) then
        transform_right_filter_feature_0_choices_from_18(38) := (not is_set(transform_right_filter_column_4(0), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(38) := (not is_set(transform_right_filter_column_4(0), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 38 to 41 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(0), i
            - 35)) or transform_right_filter_feature_0_values(i - 35);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(0), i
            - 35)) and transform_right_filter_feature_0_values(i - 35);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(0), 7) then
        transform_right_filter_feature_0_choices_from_18(43) := transform_filtering_0_column_inside_0;
      else
        transform_right_filter_feature_0_choices_from_18(43) := transform_right_filter_feature_0_all;
      end if;
      if transform_right_filter_feature_0_choices_from_18(42) then
        transform_right_filter_feature_0_choices_from_18(44) := is_set(transform_right_filter_column_4(0), 7) and
          transform_filtering_0_column_inside_0 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(44) := transform_right_filter_feature_0_choices_from_18(43);
      end if;
      if is_set(transform_right_filter_column_2(2), 0) then
        transform_right_filter_feature_0_choices_from_18(45) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(45) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_2(2), 1) then
        transform_right_filter_feature_0_choices_from_18(46) := transform_right_filter_feature_0_choices_from_18(45);
      else
        transform_right_filter_feature_0_choices_from_18(46) := is_set(transform_right_filter_column_2(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(46) then
        transform_right_filter_feature_0_choices_from_18(47) := (not is_set(transform_right_filter_column_2(2), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(47) := (not is_set(transform_right_filter_column_2(2), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 47 to 50 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(2), i
            - 44)) or transform_right_filter_feature_0_values(i - 44);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(2), i
            - 44)) and transform_right_filter_feature_0_values(i - 44);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(2) := transform_filtering_0_column_inside_2 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(2), 7) then
        transform_right_filter_feature_0_choices_from_18(52) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(52) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(51) then
        transform_right_filter_feature_0_choices_from_18(53) := is_set(transform_right_filter_column_2(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(53) := transform_right_filter_feature_0_choices_from_18(52);
      end if;
      if is_set(transform_right_filter_column_0(2), 0) then
        transform_right_filter_feature_0_choices_from_18(54) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(54) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_0(2), 1) then
        transform_right_filter_feature_0_choices_from_18(55) := transform_right_filter_feature_0_choices_from_18(54);
      else
        transform_right_filter_feature_0_choices_from_18(55) := is_set(transform_right_filter_column_0(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(55) then
        transform_right_filter_feature_0_choices_from_18(56) := (not is_set(transform_right_filter_column_0(2), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(56) := (not is_set(transform_right_filter_column_0(2), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 56 to 59 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(2), i
            - 53)) or transform_right_filter_feature_0_values(i - 53);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(2), i
            - 53)) and transform_right_filter_feature_0_values(i - 53);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(2), 7) then
        transform_right_filter_feature_0_choices_from_18(61) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(61) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(60) then
        transform_right_filter_feature_0_choices_from_18(62) := is_set(transform_right_filter_column_0(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(62) := transform_right_filter_feature_0_choices_from_18(61);
      end if;
      if is_set(transform_right_filter_column_4(2), 0) then
        transform_right_filter_feature_0_choices_from_18(63) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(63) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_4(2), 1) then
        transform_right_filter_feature_0_choices_from_18(64) := transform_right_filter_feature_0_choices_from_18(63);
      else
        transform_right_filter_feature_0_choices_from_18(64) := is_set(transform_right_filter_column_4(2), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(64) then
        transform_right_filter_feature_0_choices_from_18(65) := (not is_set(transform_right_filter_column_4(2), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(65) := (not is_set(transform_right_filter_column_4(2), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 65 to 68 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(2), i
            - 62)) or transform_right_filter_feature_0_values(i - 62);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(2), i
            - 62)) and transform_right_filter_feature_0_values(i - 62);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(2), 7) then
        transform_right_filter_feature_0_choices_from_18(70) := transform_filtering_0_column_inside_2;
      else
        transform_right_filter_feature_0_choices_from_18(70) := transform_right_filter_feature_0_alls(2);
      end if;
      if transform_right_filter_feature_0_choices_from_18(69) then
        transform_right_filter_feature_0_choices_from_18(71) := is_set(transform_right_filter_column_4(2), 7) and
          transform_filtering_0_column_inside_2 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(71) := transform_right_filter_feature_0_choices_from_18(70);
      end if;
      if is_set(transform_right_filter_column_2(6), 0) then
        transform_right_filter_feature_0_choices_from_18(72) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(72) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_2(6), 1) then
        transform_right_filter_feature_0_choices_from_18(73) := transform_right_filter_feature_0_choices_from_18(72);
      else
        transform_right_filter_feature_0_choices_from_18(73) := is_set(transform_right_filter_column_2(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(73) then
        transform_right_filter_feature_0_choices_from_18(74) := (not is_set(transform_right_filter_column_2(6), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(74) := (not is_set(transform_right_filter_column_2(6), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 74 to 77 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(6), i
            - 71)) or transform_right_filter_feature_0_values(i - 71);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(6), i
            - 71)) and transform_right_filter_feature_0_values(i - 71);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(3) := transform_filtering_0_column_inside_6 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(6), 7) then
        transform_right_filter_feature_0_choices_from_18(79) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(79) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(78) then
        transform_right_filter_feature_0_choices_from_18(80) := is_set(transform_right_filter_column_2(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(80) := transform_right_filter_feature_0_choices_from_18(79);
      end if;
      if is_set(transform_right_filter_column_0(6), 0) then
        transform_right_filter_feature_0_choices_from_18(81) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(81) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_0(6), 1) then
        transform_right_filter_feature_0_choices_from_18(82) := transform_right_filter_feature_0_choices_from_18(81);
      else
        transform_right_filter_feature_0_choices_from_18(82) := is_set(transform_right_filter_column_0(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(82) then
        transform_right_filter_feature_0_choices_from_18(83) := (not is_set(transform_right_filter_column_0(6), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(83) := (not is_set(transform_right_filter_column_0(6), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 83 to 86 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(6), i
            - 80)) or transform_right_filter_feature_0_values(i - 80);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(6), i
            - 80)) and transform_right_filter_feature_0_values(i - 80);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(6), 7) then
        transform_right_filter_feature_0_choices_from_18(88) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(88) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(87) then
        transform_right_filter_feature_0_choices_from_18(89) := is_set(transform_right_filter_column_0(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(89) := transform_right_filter_feature_0_choices_from_18(88);
      end if;
      if is_set(transform_right_filter_column_4(6), 0) then
        transform_right_filter_feature_0_choices_from_18(90) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(90) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_4(6), 1) then
        transform_right_filter_feature_0_choices_from_18(91) := transform_right_filter_feature_0_choices_from_18(90);
      else
        transform_right_filter_feature_0_choices_from_18(91) := is_set(transform_right_filter_column_4(6), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(91) then
        transform_right_filter_feature_0_choices_from_18(92) := (not is_set(transform_right_filter_column_4(6), 2)) and
          transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(92) := (not is_set(transform_right_filter_column_4(6), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 92 to 95 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(6), i
            - 89)) or transform_right_filter_feature_0_values(i - 89);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(6), i
            - 89)) and transform_right_filter_feature_0_values(i - 89);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(6), 7) then
        transform_right_filter_feature_0_choices_from_18(97) := transform_filtering_0_column_inside_6;
      else
        transform_right_filter_feature_0_choices_from_18(97) := transform_right_filter_feature_0_alls(3);
      end if;
      if transform_right_filter_feature_0_choices_from_18(96) then
        transform_right_filter_feature_0_choices_from_18(98) := is_set(transform_right_filter_column_4(6), 7) and
          transform_filtering_0_column_inside_6 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(98) := transform_right_filter_feature_0_choices_from_18(97);
      end if;
      if is_set(transform_right_filter_column_2(8), 0) then
        transform_right_filter_feature_0_choices_from_18(99) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(99) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_2(8), 1) then
        transform_right_filter_feature_0_choices_from_18(100) := transform_right_filter_feature_0_choices_from_18(99);
      else
        transform_right_filter_feature_0_choices_from_18(100) := is_set(transform_right_filter_column_2(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(100) then
        transform_right_filter_feature_0_choices_from_18(101) := (not is_set(transform_right_filter_column_2(8), 2))
          and transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(101) := (not is_set(transform_right_filter_column_2(8), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 101 to 104 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(8), i
            - 98)) or transform_right_filter_feature_0_values(i - 98);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_2(8), i
            - 98)) and transform_right_filter_feature_0_values(i - 98);
        end if;
      end loop;
      transform_right_filter_feature_0_alls(4) := transform_filtering_0_column_inside_8 and (not
        is_set(transform_right_filter_column_2(4), 7));
      if is_set(transform_right_filter_column_2(8), 7) then
        transform_right_filter_feature_0_choices_from_18(106) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(106) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(105) then
        transform_right_filter_feature_0_choices_from_18(107) := is_set(transform_right_filter_column_2(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(107) := transform_right_filter_feature_0_choices_from_18(106);
      end if;
      if is_set(transform_right_filter_column_0(8), 0) then
        transform_right_filter_feature_0_choices_from_18(108) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(108) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_0(8), 1) then
        transform_right_filter_feature_0_choices_from_18(109) := transform_right_filter_feature_0_choices_from_18(108);
      else
        transform_right_filter_feature_0_choices_from_18(109) := is_set(transform_right_filter_column_0(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(109) then
        transform_right_filter_feature_0_choices_from_18(110) := (not is_set(transform_right_filter_column_0(8), 2))
          and transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(110) := (not is_set(transform_right_filter_column_0(8), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 110 to 113 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(8), i
            - 107)) or transform_right_filter_feature_0_values(i - 107);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_0(8), i
            - 107)) and transform_right_filter_feature_0_values(i - 107);
        end if;
      end loop;
      if is_set(transform_right_filter_column_0(8), 7) then
        transform_right_filter_feature_0_choices_from_18(115) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(115) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(114) then
        transform_right_filter_feature_0_choices_from_18(116) := is_set(transform_right_filter_column_0(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(116) := transform_right_filter_feature_0_choices_from_18(115);
      end if;
      if is_set(transform_right_filter_column_4(8), 0) then
        transform_right_filter_feature_0_choices_from_18(117) := transform_right_filter_feature_0_any;
      else
        transform_right_filter_feature_0_choices_from_18(117) := not transform_right_filter_feature_0_value;
      end if;
      if is_set(transform_right_filter_column_4(8), 1) then
        transform_right_filter_feature_0_choices_from_18(118) := transform_right_filter_feature_0_choices_from_18(117);
      else
        transform_right_filter_feature_0_choices_from_18(118) := is_set(transform_right_filter_column_4(8), 0) and
          transform_right_filter_feature_0_is_equal;
      end if;
      if transform_right_filter_feature_0_choices_from_18(118) then
        transform_right_filter_feature_0_choices_from_18(119) := (not is_set(transform_right_filter_column_4(8), 2))
          and transform_right_filter_feature_0_values(2);
      else
        transform_right_filter_feature_0_choices_from_18(119) := (not is_set(transform_right_filter_column_4(8), 2)) or
          transform_right_filter_feature_0_values(2);
      end if;
      for i in 119 to 122 loop
        if transform_right_filter_feature_0_choices_from_18(i) then
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(8), i
            - 116)) or transform_right_filter_feature_0_values(i - 116);
        else
          transform_right_filter_feature_0_choices_from_18(i + 1) := (not is_set(transform_right_filter_column_4(8), i
            - 116)) and transform_right_filter_feature_0_values(i - 116);
        end if;
      end loop;
      if is_set(transform_right_filter_column_4(8), 7) then
        transform_right_filter_feature_0_choices_from_18(124) := transform_filtering_0_column_inside_8;
      else
        transform_right_filter_feature_0_choices_from_18(124) := transform_right_filter_feature_0_alls(4);
      end if;
      if transform_right_filter_feature_0_choices_from_18(123) then
        transform_right_filter_feature_0_choices_from_18(125) := is_set(transform_right_filter_column_4(8), 7) and
          transform_filtering_0_column_inside_8 and (not is_set(transform_right_filter_column_2(4), 7));
      else
        transform_right_filter_feature_0_choices_from_18(125) := transform_right_filter_feature_0_choices_from_18(124);
      end if;
      transform_left_0 <= in_left_pixel;
      transform_right_0 <= in_right_pixel;
      transform_valid <= in_valid;
      transform_left_rows_read_newest_0 <= transform_left_0;
      transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
      transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
      transform_right_rows_read_newest_0 <= transform_right_0;
      transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
      transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
      transform_read_column <= transform_counter_column;
      transform_read_row_inside_0 <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
        (transform_counter_group mod 4)) < 375;
      transform_read_row_inside_2 <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
        (transform_counter_group mod 2)) < 375;
      transform_read_row_inside_4 <= transform_counter_group < 375;
      transform_read_column_inside_0 <= transform_read_column_inside_0_is_less;
      transform_read_column_inside_2 <= (transform_counter_column < 2) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_4 <= (transform_counter_column < 4) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_6 <= (transform_counter_column < 6) /= transform_read_column_inside_0_is_less;
      transform_read_column_inside_8 <= (transform_counter_column < 8) /= transform_read_column_inside_0_is_less;
      transform_read_start_of_frame <= (transform_counter_group = 2) and (transform_counter_column = 4);
      transform_read_valid <= transform_valid;
      transform_ready_column <= transform_read_column;
      transform_ready_row_inside_0 <= transform_read_row_inside_0;
      transform_ready_row_inside_2 <= transform_read_row_inside_2;
      transform_ready_row_inside_4 <= transform_read_row_inside_4;
      transform_ready_column_inside_0 <= transform_read_column_inside_0;
      transform_ready_column_inside_2 <= transform_read_column_inside_2;
      transform_ready_column_inside_4 <= transform_read_column_inside_4;
      transform_ready_column_inside_6 <= transform_read_column_inside_6;
      transform_ready_column_inside_8 <= transform_read_column_inside_8;
      transform_ready_start_of_frame <= transform_read_start_of_frame;
      transform_ready_valid <= transform_read_valid;
      transform_left_column_0 <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
      transform_left_column_2 <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
      transform_left_column_4 <= transform_left_rows_ready_newest_0;
      transform_right_column_0 <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
      transform_right_column_2 <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
      transform_right_column_4 <= transform_right_rows_ready_newest_0;
      transform_columns_row_inside_0 <= transform_ready_row_inside_0;
      transform_columns_row_inside_2 <= transform_ready_row_inside_2;
      transform_columns_row_inside_4 <= transform_ready_row_inside_4;
      transform_columns_column_inside_0 <= transform_ready_column_inside_0;
      transform_columns_column_inside_2 <= transform_ready_column_inside_2;
      transform_columns_column_inside_4 <= transform_ready_column_inside_4;
      transform_columns_column_inside_6 <= transform_ready_column_inside_6;
      transform_columns_column_inside_8 <= transform_ready_column_inside_8;
      transform_columns_start_of_frame <= transform_ready_start_of_frame;
      transform_columns_valid <= transform_ready_valid;
      transform_left_filter_feature_0 <= (transform_left_filter_feature_0_choice_17 * 64) +
        (as_number(transform_left_filter_feature_0_choices_from_18(26)) * 2) +
        as_number(transform_left_filter_feature_0_choices_from_18(35)) +
        (as_number(transform_left_filter_feature_0_choices_from_18(43)) * 4) +
        (as_number(transform_left_filter_feature_0_choices_from_18(52)) * 16) +
        (as_number(transform_left_filter_feature_0_choices_from_18(61)) * 8) +
        (as_number(transform_left_filter_feature_0_choices_from_18(69)) * 32) +
        (as_number(transform_left_filter_feature_0_choices_from_18(78)) * 512) +
        (as_number(transform_left_filter_feature_0_choices_from_18(87)) * 256) +
        (as_number(transform_left_filter_feature_0_choices_from_18(95)) * 1024) +
        (as_number(transform_left_filter_feature_0_choices_from_18(104)) * 4096) +
        (as_number(transform_left_filter_feature_0_choices_from_18(113)) * 2048) +
        (as_number(transform_left_filter_feature_0_choices_from_18(121)) * 8192);
      transform_right_filter_feature_0 <= (transform_right_filter_feature_0_choice_17 * 64) +
        (as_number(transform_right_filter_feature_0_choices_from_18(26)) * 2) +
        as_number(transform_right_filter_feature_0_choices_from_18(35)) +
        (as_number(transform_right_filter_feature_0_choices_from_18(44)) * 4) +
        (as_number(transform_right_filter_feature_0_choices_from_18(53)) * 16) +
        (as_number(transform_right_filter_feature_0_choices_from_18(62)) * 8) +
        (as_number(transform_right_filter_feature_0_choices_from_18(71)) * 32) +
        (as_number(transform_right_filter_feature_0_choices_from_18(80)) * 512) +
        (as_number(transform_right_filter_feature_0_choices_from_18(89)) * 256) +
        (as_number(transform_right_filter_feature_0_choices_from_18(98)) * 1024) +
        (as_number(transform_right_filter_feature_0_choices_from_18(107)) * 4096) +
        (as_number(transform_right_filter_feature_0_choices_from_18(116)) * 2048) +
        (as_number(transform_right_filter_feature_0_choices_from_18(125)) * 8192);
      transform_filtering_0_column_inside_0 <= transform_columns_column_inside_0;
      transform_filtering_0_column_inside_2 <= transform_columns_column_inside_2;
      transform_filtering_0_column_inside_4 <= transform_columns_column_inside_4;
      transform_filtering_0_column_inside_6 <= transform_columns_column_inside_6;
      transform_filtering_0_column_inside_8 <= transform_columns_column_inside_8;
      transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
      transform_filtering_valid(0) <= transform_columns_valid;
      transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
      transform_filtering_valid(1) <= transform_filtering_valid(0);
      if in_valid and in_start_of_frame then
        transform_counter_group <= transform_counter_group_choice;
      else
        transform_counter_group <= transform_counter_group_choices(3);
      end if;
      if transform_counter_group_is_equal_2 then
        transform_counter_next_frame_choice := (transform_counter_group /= 376) and transform_counter_next_frame;
      else
        transform_counter_next_frame_choice := transform_counter_next_frame;
      end if;
      if transform_counter_group_differs then
        transform_counter_next_frame_choice_2 := transform_counter_next_frame_choice;
      else
        transform_counter_next_frame_choice_2 := transform_counter_next_frame;
      end if;
      if in_valid then
        if in_start_of_frame or transform_counter_group_is_equal_2 then
          transform_counter_column <= 0;
        else
          transform_counter_column <= (transform_counter_column + 1) mod 512;
        end if;
        if transform_counter_next_frame_choice_2 then
          transform_counter_next_frame <= (not in_start_of_frame) or transform_counter_group_all;
        else
          transform_counter_next_frame <= in_start_of_frame and transform_counter_group_is_equal and
            transform_counter_group_is_equal_2;
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
        for i in 1 to 8 loop
          transform_left_filter_column_0(i) <= transform_left_filter_column_0(i - 1);
          transform_left_filter_column_2(i) <= transform_left_filter_column_2(i - 1);
          transform_left_filter_column_4(i) <= transform_left_filter_column_4(i - 1);
        end loop;
        for i in 1 to 8 loop
          transform_right_filter_column_0(i) <= transform_right_filter_column_0(i - 1);
          transform_right_filter_column_2(i) <= transform_right_filter_column_2(i - 1);
          transform_right_filter_column_4(i) <= transform_right_filter_column_4(i - 1);
        end loop;
        if transform_columns_row_inside_0 then
          transform_left_filter_column_0(0) <= transform_left_column_0;
          transform_right_filter_column_0(0) <= transform_right_column_0;
        else
          transform_left_filter_column_0(0) <= 0;
          transform_right_filter_column_0(0) <= 0;
        end if;
        if transform_columns_row_inside_2 then
          transform_left_filter_column_2(0) <= transform_left_column_2;
          transform_right_filter_column_2(0) <= transform_right_column_2;
        else
          transform_left_filter_column_2(0) <= 0;
          transform_right_filter_column_2(0) <= 0;
        end if;
        if transform_columns_row_inside_4 then
          transform_left_filter_column_4(0) <= transform_left_column_4;
          transform_right_filter_column_4(0) <= transform_right_column_4;
        else
          transform_left_filter_column_4(0) <= 0;
          transform_right_filter_column_4(0) <= 0;
        end if;
      end if;
      -- raster
      raster_place_group_is_equal := raster_place_group = 374;
      raster_place_group_is_equal_2 := raster_place_column = 449;
      raster_place_group_all := raster_place_group_is_equal and raster_place_group_is_equal_2;
      if raster_place_group_all then
        raster_place_group_choice := 375;
      else
        raster_place_group_choice := 0;
      end if;
      raster_place_group_differs := raster_place_group /= 376;
      if (raster_place_group = 375) and raster_place_next_frame then
        raster_place_group_choices(2) := 1;
      else
        raster_place_group_choices(2) := (raster_place_group + 1) mod 512;
      end if;
      if raster_place_group_differs and raster_place_group_is_equal_2 and transform_filtering_valid(1) then
        raster_place_group_choices(3) := raster_place_group_choices(2);
      else
        raster_place_group_choices(3) := raster_place_group;
      end if;
      raster_features_search_0 <= transform_right_filter_feature_0;
      raster_features_reference_0 <= transform_left_filter_feature_0;
      raster_features_valid <= transform_filtering_valid(1);
      if transform_filtering_start_of_frame(1) and transform_filtering_valid(1) then
        raster_place_group <= raster_place_group_choice;
      else
        raster_place_group <= raster_place_group_choices(3);
      end if;
      if raster_place_group_is_equal_2 then
        raster_place_next_frame_choice := (raster_place_group /= 375) and raster_place_next_frame;
      else
        raster_place_next_frame_choice := raster_place_next_frame;
      end if;
      if raster_place_group_differs then
        raster_place_next_frame_choice_2 := raster_place_next_frame_choice;
      else
        raster_place_next_frame_choice_2 := raster_place_next_frame;
      end if;
      if transform_filtering_valid(1) then
        if transform_filtering_start_of_frame(1) or raster_place_group_is_equal_2 then
          raster_place_column <= 0;
        else
          raster_place_column <= (raster_place_column + 1) mod 512;
        end if;
        if raster_place_next_frame_choice_2 then
          raster_place_next_frame <= (not transform_filtering_start_of_frame(1)) or raster_place_group_all;
        else
          raster_place_next_frame <= transform_filtering_start_of_frame(1) and raster_place_group_is_equal and
            raster_place_group_is_equal_2;
        end if;
      end if;
      -- delay
      delay_row_inside_1_is_not_less := raster_place_group >= 1;
      delay_row_inside_1_is_less := raster_place_group < 376;
      delay_tag_map_column_is_not_less := raster_place_column >= 1;
      delay_tag_map_column_is_less := raster_place_column < 449;
      delay_tag_first_column_is_equal := raster_place_column = 1;
      delay_ahead_0 <= raster_features_reference_0;
      delay_delayed_0 <= raster_features_search_0;
      delay_column <= raster_place_column;
      delay_row_inside(0) <= (((((raster_place_group / 2) + 32767) mod 32768) * 2) + (raster_place_group mod 2)) < 375;
      delay_row_inside(1) <= delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_row_inside(2) <= raster_place_group < 375;
      delay_tag_valid <= raster_features_valid;
      delay_tag_map_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less;
      delay_tag_output_column <= delay_tag_map_column_is_not_less and delay_tag_map_column_is_less and
        delay_row_inside_1_is_not_less and delay_row_inside_1_is_less;
      delay_tag_first_column <= delay_tag_first_column_is_equal;
      delay_tag_start_of_frame <= delay_tag_first_column_is_equal and (raster_place_group = 1);
      delay_tag_end_of_line <= raster_place_column = 448;
      -- rows
      rows_search_rows_read_newest_0 <= delay_delayed_0;
      rows_search_rows_ready_words_0 <= to_integer(rows_search_rows_read_words_0);
      rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
      rows_reference_rows_read_newest_0 <= delay_ahead_0;
      rows_reference_rows_ready_words_0 <= to_integer(rows_reference_rows_read_words_0);
      rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
      rows_read_column <= delay_column;
      rows_read_inside(0) <= delay_row_inside(0);
      rows_read_inside(1) <= delay_row_inside(1);
      rows_read_inside(2) <= delay_row_inside(2);
      rows_read_tag_valid <= delay_tag_valid;
      rows_read_tag_map_column <= delay_tag_map_column;
      rows_read_tag_output_column <= delay_tag_output_column;
      rows_read_tag_first_column <= delay_tag_first_column;
      rows_read_tag_start_of_frame <= delay_tag_start_of_frame;
      rows_read_tag_end_of_line <= delay_tag_end_of_line;
      rows_ready_column <= rows_read_column;
      rows_ready_inside(0) <= rows_read_inside(0);
      rows_ready_inside(1) <= rows_read_inside(1);
      rows_ready_inside(2) <= rows_read_inside(2);
      rows_ready_tag_valid <= rows_read_tag_valid;
      rows_ready_tag_map_column <= rows_read_tag_map_column;
      rows_ready_tag_output_column <= rows_read_tag_output_column;
      rows_ready_tag_first_column <= rows_read_tag_first_column;
      rows_ready_tag_start_of_frame <= rows_read_tag_start_of_frame;
      rows_ready_tag_end_of_line <= rows_read_tag_end_of_line;
      rows_tag_valid <= rows_ready_tag_valid;
      rows_tag_map_column <= rows_ready_tag_map_column;
      rows_tag_output_column <= rows_ready_tag_output_column;
      rows_tag_first_column <= rows_ready_tag_first_column;
      rows_tag_start_of_frame <= rows_ready_tag_start_of_frame;
      rows_tag_end_of_line <= rows_ready_tag_end_of_line;
      if rows_ready_inside(0) then
        rows_search(0) <= rows_search_rows_ready_words_0 mod 16384;
        rows_reference(0) <= rows_reference_rows_ready_words_0 mod 16384;
      else
        rows_search(0) <= 0;
        rows_reference(0) <= 0;
      end if;
      if rows_ready_inside(1) then
        rows_search(1) <= rows_search_rows_ready_words_0 / 16384;
        rows_reference(1) <= rows_reference_rows_ready_words_0 / 16384;
      else
        rows_search(1) <= 0;
        rows_reference(1) <= 0;
      end if;
      if rows_ready_inside(2) then
        rows_search(2) <= rows_search_rows_ready_newest_0;
        rows_reference(2) <= rows_reference_rows_ready_newest_0;
      else
        rows_search(2) <= 0;
        rows_reference(2) <= 0;
      end if;
      if rows_ready_tag_valid then
        rows_search_rows_write_words_0 <= (rows_search_rows_ready_words_0 / 16384) + (rows_search_rows_ready_newest_0 *
          16384);
        rows_reference_rows_write_words_0 <= (rows_reference_rows_ready_words_0 / 16384) +
          (rows_reference_rows_ready_newest_0 * 16384);
        rows_write_column <= rows_ready_column;
      end if;
      -- slice0shift
      if rows_tag_valid then
        for i in 0 to 2 loop
          slice0shift_search(i, 0) <= rows_search(i);
          for j in 1 to 15 loop
            slice0shift_search(i, j) <= slice0shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice0shift_reference(0) <= rows_reference(0);
      slice0shift_reference(1) <= rows_reference(1);
      slice0shift_reference(2) <= rows_reference(2);
      slice0shift_search_out(0) <= slice0shift_search(0, 15);
      slice0shift_search_out(1) <= slice0shift_search(1, 15);
      slice0shift_search_out(2) <= slice0shift_search(2, 15);
      slice0shift_tag_valid <= rows_tag_valid;
      slice0shift_tag_map_column <= rows_tag_map_column;
      slice0shift_tag_output_column <= rows_tag_output_column;
      slice0shift_tag_first_column <= rows_tag_first_column;
      slice0shift_tag_start_of_frame <= rows_tag_start_of_frame;
      slice0shift_tag_end_of_line <= rows_tag_end_of_line;
      -- slice0cost
      for i in 0 to 2 loop
        slice0cost_pixels_first_0_count_value(i, 0) := is_set(slice0shift_reference(i), 2);
        slice0cost_pixels_first_0_count_value_2(i, 0) := is_set(slice0shift_reference(i), 1);
        slice0cost_pixels_first_0_count_value(i, 1) := is_set(slice0shift_reference(i), 3);
        slice0cost_pixels_first_0_count_value_2(i, 1) := is_set(slice0shift_reference(i), 5);
        slice0cost_pixels_first_0_count_1_value_3(i) := is_set(slice0shift_reference(i), 4);
        slice0cost_pixels_first_0_count_value(i, 2) := is_set(slice0shift_reference(i), 8);
        slice0cost_pixels_first_0_count_value_2(i, 2) := is_set(slice0shift_reference(i), 6);
        slice0cost_pixels_first_0_count_value(i, 3) := is_set(slice0shift_reference(i), 9);
        slice0cost_pixels_first_0_count_value_2(i, 3) := is_set(slice0shift_reference(i), 11);
        slice0cost_pixels_first_0_count_3_value_3(i) := is_set(slice0shift_reference(i), 10);
        slice0cost_pixels_first_0_count_value(i, 4) := is_set(slice0shift_reference(i), 12);
      end loop;
      for i in 0 to 2 loop
        slice0cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice0shift_search(i, 0), 0) /=
          is_set(slice0shift_reference(i), 0))) + as_number((slice0cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice0shift_search(i, 0), 2))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice0shift_search(i, 0), 1)));
        slice0cost_pixels_first_count(i, 0, 1) <= as_number((slice0cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice0shift_search(i, 0), 3))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice0shift_search(i, 0), 5))) + as_number((slice0cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice0shift_search(i, 0), 4)));
        slice0cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice0cost_pixels_first_0_count_value(i, 2) /= is_set(slice0shift_search(i, 0), 8))) +
          as_number((slice0cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice0shift_search(i, 0), 6)));
        slice0cost_pixels_first_count(i, 0, 3) <= as_number((slice0cost_pixels_first_0_count_value(i, 3) /=
          is_set(slice0shift_search(i, 0), 9))) + as_number((slice0cost_pixels_first_0_count_value_2(i, 3) /=
          is_set(slice0shift_search(i, 0), 11))) + as_number((slice0cost_pixels_first_0_count_3_value_3(i) /=
          is_set(slice0shift_search(i, 0), 10)));
        slice0cost_pixels_first_count_4(i, 0) <= as_number((is_set(slice0shift_reference(i), 13) /=
          is_set(slice0shift_search(i, 0), 13))) + as_number((slice0cost_pixels_first_0_count_value(i, 4) /=
          is_set(slice0shift_search(i, 0), 12)));
        for j in 1 to 15 loop
          slice0cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice0shift_search(i, j), 0) /=
            is_set(slice0shift_reference(i), 0))) + as_number((is_set(slice0shift_search(i, j), 2) /=
            slice0cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice0shift_search(i, j), 1) /=
            slice0cost_pixels_first_0_count_value_2(i, 0)));
          slice0cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice0shift_search(i, j), 3) /=
            slice0cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice0shift_search(i, j), 5) /=
            slice0cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice0shift_search(i, j), 4) /=
            slice0cost_pixels_first_0_count_1_value_3(i)));
          slice0cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice0shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice0shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice0shift_search(i,
            j), 8) /= slice0cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice0shift_search(i, j), 6) /=
            slice0cost_pixels_first_0_count_value_2(i, 2)));
          slice0cost_pixels_first_count(i, j, 3) <= as_number((is_set(slice0shift_search(i, j), 9) /=
            slice0cost_pixels_first_0_count_value(i, 3))) + as_number((is_set(slice0shift_search(i, j), 11) /=
            slice0cost_pixels_first_0_count_value_2(i, 3))) + as_number((is_set(slice0shift_search(i, j), 10) /=
            slice0cost_pixels_first_0_count_3_value_3(i)));
          slice0cost_pixels_first_count_4(i, j) <= as_number((is_set(slice0shift_search(i, j), 13) /=
            is_set(slice0shift_reference(i), 13))) + as_number((is_set(slice0shift_search(i, j), 12) /=
            slice0cost_pixels_first_0_count_value(i, 4)));
        end loop;
      end loop;
      slice0cost_pixels_first_tag_valid <= slice0shift_tag_valid;
      slice0cost_pixels_first_tag_map_column <= slice0shift_tag_map_column;
      slice0cost_pixels_first_tag_output_column <= slice0shift_tag_output_column;
      slice0cost_pixels_first_tag_first_column <= slice0shift_tag_first_column;
      slice0cost_pixels_first_tag_start_of_frame <= slice0shift_tag_start_of_frame;
      slice0cost_pixels_first_tag_end_of_line <= slice0shift_tag_end_of_line;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 3) + slice0cost_pixels_first_count(i, j,
            0) + slice0cost_pixels_first_count(i, j, 1) + slice0cost_pixels_first_count_4(i, j) +
            slice0cost_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      slice0cost_pixels_tag_valid <= slice0cost_pixels_first_tag_valid;
      slice0cost_pixels_tag_map_column <= slice0cost_pixels_first_tag_map_column;
      slice0cost_pixels_tag_output_column <= slice0cost_pixels_first_tag_output_column;
      slice0cost_pixels_tag_first_column <= slice0cost_pixels_first_tag_first_column;
      slice0cost_pixels_tag_start_of_frame <= slice0cost_pixels_first_tag_start_of_frame;
      slice0cost_pixels_tag_end_of_line <= slice0cost_pixels_first_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_pair_0(i) <= slice0cost_pixels_cost(1, i) + slice0cost_pixels_cost(2, i);
      end loop;
      for i in 0 to 15 loop
        slice0cost_single_0(i) <= slice0cost_pixels_cost(0, i);
      end loop;
      slice0cost_pair_tag_valid <= slice0cost_pixels_tag_valid;
      slice0cost_pair_tag_map_column <= slice0cost_pixels_tag_map_column;
      slice0cost_pair_tag_output_column <= slice0cost_pixels_tag_output_column;
      slice0cost_pair_tag_first_column <= slice0cost_pixels_tag_first_column;
      slice0cost_pair_tag_start_of_frame <= slice0cost_pixels_tag_start_of_frame;
      slice0cost_pair_tag_end_of_line <= slice0cost_pixels_tag_end_of_line;
      for i in 0 to 15 loop
        slice0cost_column_0(i) <= slice0cost_pair_0(i) + slice0cost_single_0(i);
      end loop;
      slice0cost_tag_valid <= slice0cost_pair_tag_valid;
      slice0cost_tag_map_column <= slice0cost_pair_tag_map_column;
      slice0cost_tag_output_column <= slice0cost_pair_tag_output_column;
      slice0cost_tag_first_column <= slice0cost_pair_tag_first_column;
      slice0cost_tag_start_of_frame <= slice0cost_pair_tag_start_of_frame;
      slice0cost_tag_end_of_line <= slice0cost_pair_tag_end_of_line;
      -- slice0window
      if slice0cost_tag_valid then
        for i in 0 to 15 loop
          slice0window_partial_0_0(i) <= slice0cost_column_0(i);
        end loop;
        for i in 0 to 15 loop
          slice0window_partial_0_1(i) <= slice0cost_column_0(i) + slice0window_partial_0_0(i);
        end loop;
        slice0window_centre_map_column_0 <= slice0cost_tag_map_column;
        slice0window_centre_output_column_0 <= slice0cost_tag_output_column;
        slice0window_centre_first_column_0 <= slice0cost_tag_first_column;
        slice0window_centre_start_of_frame_0 <= slice0cost_tag_start_of_frame;
        slice0window_centre_end_of_line_0 <= slice0cost_tag_end_of_line;
      end if;
      for i in 0 to 15 loop
        slice0window_sum_0(i) <= slice0cost_column_0(i) + slice0window_partial_0_1(i);
      end loop;
      slice0window_tag_valid <= slice0cost_tag_valid;
      slice0window_tag_map_column <= slice0window_centre_map_column_0;
      slice0window_tag_output_column <= slice0window_centre_output_column_0;
      slice0window_tag_first_column <= slice0window_centre_first_column_0;
      slice0window_tag_start_of_frame <= slice0window_centre_start_of_frame_0;
      slice0window_tag_end_of_line <= slice0window_centre_end_of_line_0;
      -- slice0mask
      if slice0cost_tag_valid then
        slice0mask_inside_choice(0) := slice0window_centre_first_column_0;
      else
        slice0mask_inside_choice(0) := slice0mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0cost_tag_valid then
          slice0mask_inside_choice(i) := slice0mask_inside(i - 1);
        else
          slice0mask_inside_choice(i) := slice0mask_inside(i);
        end if;
      end loop;
      slice0mask_left_out <= slice0mask_inside(15);
      if slice0mask_column < 447 then
        slice0mask_inside(0) <= slice0cost_tag_valid or slice0mask_inside(0);
      else
        slice0mask_inside(0) <= slice0mask_inside_choice(0);
      end if;
      if slice0window_centre_first_column_0 then
        for i in 1 to 15 loop
          slice0mask_inside(i) <= (not slice0cost_tag_valid) and slice0mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice0mask_inside(i) <= slice0mask_inside_choice(i);
        end loop;
      end if;
      if slice0cost_tag_valid then
        if slice0window_centre_first_column_0 then
          slice0mask_column <= 0;
        else
          slice0mask_column <= (slice0mask_column + 1) mod 512;
        end if;
      end if;
      -- slice0
      for i in 0 to 15 loop
        if (not is_set(slice0window_sum_0(i), 6)) and ((not is_set(slice0window_sum_0(i), 5)) or (not
          is_set(slice0window_sum_0(i), 4)) or (not is_set(slice0window_sum_0(i), 3))) then
          slice0_held_0_choice(i) := slice0window_sum_0(i) / 8;
        else
          slice0_held_0_choice(i) := 6;
        end if;
      end loop;
      for i in 1 to 3 loop
        for j in 0 to 15 loop
          slice0_held(i, j) <= slice0_held(i - 1, j);
        end loop;
      end loop;
      slice0_tag_valid(0) <= slice0window_tag_valid;
      slice0_tag_map_column(0) <= slice0window_tag_map_column;
      slice0_tag_output_column(0) <= slice0window_tag_output_column;
      slice0_tag_first_column(0) <= slice0window_tag_first_column;
      slice0_tag_start_of_frame(0) <= slice0window_tag_start_of_frame;
      slice0_tag_end_of_line(0) <= slice0window_tag_end_of_line;
      for i in 1 to 3 loop
        slice0_tag_valid(i) <= slice0_tag_valid(i - 1);
        slice0_tag_map_column(i) <= slice0_tag_map_column(i - 1);
        slice0_tag_output_column(i) <= slice0_tag_output_column(i - 1);
        slice0_tag_first_column(i) <= slice0_tag_first_column(i - 1);
        slice0_tag_start_of_frame(i) <= slice0_tag_start_of_frame(i - 1);
        slice0_tag_end_of_line(i) <= slice0_tag_end_of_line(i - 1);
      end loop;
      for i in 0 to 15 loop
        if slice0mask_inside(i) then
          slice0_held(0, i) <= slice0_held_0_choice(i);
        else
          slice0_held(0, i) <= 3;
        end if;
      end loop;
      -- slice1shift
      if slice0shift_tag_valid then
        for i in 0 to 2 loop
          slice1shift_search(i, 0) <= slice0shift_search_out(i);
          for j in 1 to 15 loop
            slice1shift_search(i, j) <= slice1shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice1shift_reference(0) <= slice0shift_reference(0);
      slice1shift_reference(1) <= slice0shift_reference(1);
      slice1shift_reference(2) <= slice0shift_reference(2);
      slice1shift_search_out(0) <= slice1shift_search(0, 15);
      slice1shift_search_out(1) <= slice1shift_search(1, 15);
      slice1shift_search_out(2) <= slice1shift_search(2, 15);
      -- slice1cost
      for i in 0 to 2 loop
        slice1cost_pixels_first_0_count_value(i, 0) := is_set(slice1shift_reference(i), 2);
        slice1cost_pixels_first_0_count_value_2(i, 0) := is_set(slice1shift_reference(i), 1);
        slice1cost_pixels_first_0_count_value(i, 1) := is_set(slice1shift_reference(i), 3);
        slice1cost_pixels_first_0_count_value_2(i, 1) := is_set(slice1shift_reference(i), 5);
        slice1cost_pixels_first_0_count_1_value_3(i) := is_set(slice1shift_reference(i), 4);
        slice1cost_pixels_first_0_count_value(i, 2) := is_set(slice1shift_reference(i), 8);
        slice1cost_pixels_first_0_count_value_2(i, 2) := is_set(slice1shift_reference(i), 6);
        slice1cost_pixels_first_0_count_value(i, 3) := is_set(slice1shift_reference(i), 9);
        slice1cost_pixels_first_0_count_value_2(i, 3) := is_set(slice1shift_reference(i), 11);
        slice1cost_pixels_first_0_count_3_value_3(i) := is_set(slice1shift_reference(i), 10);
        slice1cost_pixels_first_0_count_value(i, 4) := is_set(slice1shift_reference(i), 12);
      end loop;
      for i in 0 to 2 loop
        slice1cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice1shift_search(i, 0), 0) /=
          is_set(slice1shift_reference(i), 0))) + as_number((slice1cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice1shift_search(i, 0), 2))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice1shift_search(i, 0), 1)));
        slice1cost_pixels_first_count(i, 0, 1) <= as_number((slice1cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice1shift_search(i, 0), 3))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice1shift_search(i, 0), 5))) + as_number((slice1cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice1shift_search(i, 0), 4)));
        slice1cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice1cost_pixels_first_0_count_value(i, 2) /= is_set(slice1shift_search(i, 0), 8))) +
          as_number((slice1cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice1shift_search(i, 0), 6)));
        slice1cost_pixels_first_count(i, 0, 3) <= as_number((slice1cost_pixels_first_0_count_value(i, 3) /=
          is_set(slice1shift_search(i, 0), 9))) + as_number((slice1cost_pixels_first_0_count_value_2(i, 3) /=
          is_set(slice1shift_search(i, 0), 11))) + as_number((slice1cost_pixels_first_0_count_3_value_3(i) /=
          is_set(slice1shift_search(i, 0), 10)));
        slice1cost_pixels_first_count_4(i, 0) <= as_number((is_set(slice1shift_reference(i), 13) /=
          is_set(slice1shift_search(i, 0), 13))) + as_number((slice1cost_pixels_first_0_count_value(i, 4) /=
          is_set(slice1shift_search(i, 0), 12)));
        for j in 1 to 15 loop
          slice1cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice1shift_search(i, j), 0) /=
            is_set(slice1shift_reference(i), 0))) + as_number((is_set(slice1shift_search(i, j), 2) /=
            slice1cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice1shift_search(i, j), 1) /=
            slice1cost_pixels_first_0_count_value_2(i, 0)));
          slice1cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice1shift_search(i, j), 3) /=
            slice1cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice1shift_search(i, j), 5) /=
            slice1cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice1shift_search(i, j), 4) /=
            slice1cost_pixels_first_0_count_1_value_3(i)));
          slice1cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice1shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice1shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice1shift_search(i,
            j), 8) /= slice1cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice1shift_search(i, j), 6) /=
            slice1cost_pixels_first_0_count_value_2(i, 2)));
          slice1cost_pixels_first_count(i, j, 3) <= as_number((is_set(slice1shift_search(i, j), 9) /=
            slice1cost_pixels_first_0_count_value(i, 3))) + as_number((is_set(slice1shift_search(i, j), 11) /=
            slice1cost_pixels_first_0_count_value_2(i, 3))) + as_number((is_set(slice1shift_search(i, j), 10) /=
            slice1cost_pixels_first_0_count_3_value_3(i)));
          slice1cost_pixels_first_count_4(i, j) <= as_number((is_set(slice1shift_search(i, j), 13) /=
            is_set(slice1shift_reference(i), 13))) + as_number((is_set(slice1shift_search(i, j), 12) /=
            slice1cost_pixels_first_0_count_value(i, 4)));
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 3) + slice1cost_pixels_first_count(i, j,
            0) + slice1cost_pixels_first_count(i, j, 1) + slice1cost_pixels_first_count_4(i, j) +
            slice1cost_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice1cost_pair_0(i) <= slice1cost_pixels_cost(1, i) + slice1cost_pixels_cost(2, i);
      end loop;
      for i in 0 to 15 loop
        slice1cost_single_0(i) <= slice1cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 15 loop
        slice1cost_column_0(i) <= slice1cost_pair_0(i) + slice1cost_single_0(i);
      end loop;
      slice1cost_tag_first_column <= slice0cost_tag_first_column;
      -- slice1window
      if slice0window_tag_valid then
        for i in 0 to 15 loop
          slice1window_partial_0_0(i) <= slice1cost_column_0(i);
        end loop;
        for i in 0 to 15 loop
          slice1window_partial_0_1(i) <= slice1cost_column_0(i) + slice1window_partial_0_0(i);
        end loop;
        slice1window_centre_first_column_0 <= slice1cost_tag_first_column;
      end if;
      for i in 0 to 15 loop
        slice1window_sum_0(i) <= slice1cost_column_0(i) + slice1window_partial_0_1(i);
      end loop;
      if slice0_tag_valid(0) then
        slice1window_tag_first_column <= slice2cost_tag_first_column;
      end if;
      -- slice1mask
      slice1mask_inside_0_all := (not slice0window_tag_valid) and slice1mask_inside(0);
      if slice1window_centre_first_column_0 then
        slice1mask_inside_choice(0) := slice1mask_inside_0_all;
      else
        slice1mask_inside_choice(0) := slice0window_tag_valid or slice1mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0window_tag_valid then
          slice1mask_inside_choice(i) := slice1mask_inside(i - 1);
        else
          slice1mask_inside_choice(i) := slice1mask_inside(i);
        end if;
      end loop;
      slice1mask_left_out <= slice1mask_inside(15);
      if slice0mask_left_out then
        slice1mask_inside(0) <= slice1mask_inside_choice(0);
      else
        slice1mask_inside(0) <= slice1mask_inside_0_all;
      end if;
      if slice1window_centre_first_column_0 then
        for i in 1 to 15 loop
          slice1mask_inside(i) <= (not slice0window_tag_valid) and slice1mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice1mask_inside(i) <= slice1mask_inside_choice(i);
        end loop;
      end if;
      -- slice1
      for i in 0 to 15 loop
        if (not is_set(slice1window_sum_0(i), 6)) and ((not is_set(slice1window_sum_0(i), 5)) or (not
          is_set(slice1window_sum_0(i), 4)) or (not is_set(slice1window_sum_0(i), 3))) then
          slice1_held_0_choice(i) := slice1window_sum_0(i) / 8;
        else
          slice1_held_0_choice(i) := 6;
        end if;
      end loop;
      for i in 0 to 15 loop
        slice1_held(1, i) <= slice1_held(0, i);
      end loop;
      for i in 0 to 15 loop
        slice1_held(2, i) <= slice1_held(1, i);
      end loop;
      for i in 0 to 15 loop
        if slice1mask_inside(i) then
          slice1_held(0, i) <= slice1_held_0_choice(i);
        else
          slice1_held(0, i) <= 3;
        end if;
      end loop;
      if slice0_tag_valid(1) then
        slice1_tag_0_first_column <= slice2window_centre_first_column_0;
      end if;
      -- slice2shift
      if slice0cost_pixels_first_tag_valid then
        for i in 0 to 2 loop
          slice2shift_search(i, 0) <= slice1shift_search_out(i);
          for j in 1 to 15 loop
            slice2shift_search(i, j) <= slice2shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice2shift_reference(0) <= slice1shift_reference(0);
      slice2shift_reference(1) <= slice1shift_reference(1);
      slice2shift_reference(2) <= slice1shift_reference(2);
      slice2shift_search_out(0) <= slice2shift_search(0, 15);
      slice2shift_search_out(1) <= slice2shift_search(1, 15);
      slice2shift_search_out(2) <= slice2shift_search(2, 15);
      -- slice2cost
      for i in 0 to 2 loop
        slice2cost_pixels_first_0_count_value(i, 0) := is_set(slice2shift_reference(i), 2);
        slice2cost_pixels_first_0_count_value_2(i, 0) := is_set(slice2shift_reference(i), 1);
        slice2cost_pixels_first_0_count_value(i, 1) := is_set(slice2shift_reference(i), 3);
        slice2cost_pixels_first_0_count_value_2(i, 1) := is_set(slice2shift_reference(i), 5);
        slice2cost_pixels_first_0_count_1_value_3(i) := is_set(slice2shift_reference(i), 4);
        slice2cost_pixels_first_0_count_value(i, 2) := is_set(slice2shift_reference(i), 8);
        slice2cost_pixels_first_0_count_value_2(i, 2) := is_set(slice2shift_reference(i), 6);
        slice2cost_pixels_first_0_count_value(i, 3) := is_set(slice2shift_reference(i), 9);
        slice2cost_pixels_first_0_count_value_2(i, 3) := is_set(slice2shift_reference(i), 11);
        slice2cost_pixels_first_0_count_3_value_3(i) := is_set(slice2shift_reference(i), 10);
        slice2cost_pixels_first_0_count_value(i, 4) := is_set(slice2shift_reference(i), 12);
      end loop;
      for i in 0 to 2 loop
        slice2cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice2shift_search(i, 0), 0) /=
          is_set(slice2shift_reference(i), 0))) + as_number((slice2cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice2shift_search(i, 0), 2))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice2shift_search(i, 0), 1)));
        slice2cost_pixels_first_count(i, 0, 1) <= as_number((slice2cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice2shift_search(i, 0), 3))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice2shift_search(i, 0), 5))) + as_number((slice2cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice2shift_search(i, 0), 4)));
        slice2cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice2cost_pixels_first_0_count_value(i, 2) /= is_set(slice2shift_search(i, 0), 8))) +
          as_number((slice2cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice2shift_search(i, 0), 6)));
        slice2cost_pixels_first_count(i, 0, 3) <= as_number((slice2cost_pixels_first_0_count_value(i, 3) /=
          is_set(slice2shift_search(i, 0), 9))) + as_number((slice2cost_pixels_first_0_count_value_2(i, 3) /=
          is_set(slice2shift_search(i, 0), 11))) + as_number((slice2cost_pixels_first_0_count_3_value_3(i) /=
          is_set(slice2shift_search(i, 0), 10)));
        slice2cost_pixels_first_count_4(i, 0) <= as_number((is_set(slice2shift_reference(i), 13) /=
          is_set(slice2shift_search(i, 0), 13))) + as_number((slice2cost_pixels_first_0_count_value(i, 4) /=
          is_set(slice2shift_search(i, 0), 12)));
        for j in 1 to 15 loop
          slice2cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice2shift_search(i, j), 0) /=
            is_set(slice2shift_reference(i), 0))) + as_number((is_set(slice2shift_search(i, j), 2) /=
            slice2cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice2shift_search(i, j), 1) /=
            slice2cost_pixels_first_0_count_value_2(i, 0)));
          slice2cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice2shift_search(i, j), 3) /=
            slice2cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice2shift_search(i, j), 5) /=
            slice2cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice2shift_search(i, j), 4) /=
            slice2cost_pixels_first_0_count_1_value_3(i)));
          slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice2shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice2shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice2shift_search(i,
            j), 8) /= slice2cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice2shift_search(i, j), 6) /=
            slice2cost_pixels_first_0_count_value_2(i, 2)));
          slice2cost_pixels_first_count(i, j, 3) <= as_number((is_set(slice2shift_search(i, j), 9) /=
            slice2cost_pixels_first_0_count_value(i, 3))) + as_number((is_set(slice2shift_search(i, j), 11) /=
            slice2cost_pixels_first_0_count_value_2(i, 3))) + as_number((is_set(slice2shift_search(i, j), 10) /=
            slice2cost_pixels_first_0_count_3_value_3(i)));
          slice2cost_pixels_first_count_4(i, j) <= as_number((is_set(slice2shift_search(i, j), 13) /=
            is_set(slice2shift_reference(i), 13))) + as_number((is_set(slice2shift_search(i, j), 12) /=
            slice2cost_pixels_first_0_count_value(i, 4)));
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 3) + slice2cost_pixels_first_count(i, j,
            0) + slice2cost_pixels_first_count(i, j, 1) + slice2cost_pixels_first_count_4(i, j) +
            slice2cost_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice2cost_pair_0(i) <= slice2cost_pixels_cost(1, i) + slice2cost_pixels_cost(2, i);
      end loop;
      for i in 0 to 15 loop
        slice2cost_single_0(i) <= slice2cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 15 loop
        slice2cost_column_0(i) <= slice2cost_pair_0(i) + slice2cost_single_0(i);
      end loop;
      slice2cost_tag_first_column <= slice1cost_tag_first_column;
      -- slice2window
      if slice0_tag_valid(0) then
        for i in 0 to 15 loop
          slice2window_partial_0_0(i) <= slice2cost_column_0(i);
        end loop;
        for i in 0 to 15 loop
          slice2window_partial_0_1(i) <= slice2cost_column_0(i) + slice2window_partial_0_0(i);
        end loop;
      end if;
      slice2window_centre_first_column_0 <= slice2cost_tag_first_column;
      for i in 0 to 15 loop
        slice2window_sum_0(i) <= slice2cost_column_0(i) + slice2window_partial_0_1(i);
      end loop;
      -- slice2mask
      slice2mask_inside_0_all := (not slice0_tag_valid(0)) and slice2mask_inside(0);
      if slice1window_tag_first_column then
        slice2mask_inside_choice(0) := slice2mask_inside_0_all;
      else
        slice2mask_inside_choice(0) := slice0_tag_valid(0) or slice2mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0_tag_valid(0) then
          slice2mask_inside_choice(i) := slice2mask_inside(i - 1);
        else
          slice2mask_inside_choice(i) := slice2mask_inside(i);
        end if;
      end loop;
      slice2mask_left_out <= slice2mask_inside(15);
      if slice1mask_left_out then
        slice2mask_inside(0) <= slice2mask_inside_choice(0);
      else
        slice2mask_inside(0) <= slice2mask_inside_0_all;
      end if;
      if slice1window_tag_first_column then
        for i in 1 to 15 loop
          slice2mask_inside(i) <= (not slice0_tag_valid(0)) and slice2mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice2mask_inside(i) <= slice2mask_inside_choice(i);
        end loop;
      end if;
      -- slice2
      for i in 0 to 15 loop
        if (not is_set(slice2window_sum_0(i), 6)) and ((not is_set(slice2window_sum_0(i), 5)) or (not
          is_set(slice2window_sum_0(i), 4)) or (not is_set(slice2window_sum_0(i), 3))) then
          slice2_held_0_choice(i) := slice2window_sum_0(i) / 8;
        else
          slice2_held_0_choice(i) := 6;
        end if;
      end loop;
      for i in 0 to 15 loop
        slice2_held(1, i) <= slice2_held(0, i);
      end loop;
      for i in 0 to 15 loop
        if slice2mask_inside(i) then
          slice2_held(0, i) <= slice2_held_0_choice(i);
        else
          slice2_held(0, i) <= 3;
        end if;
      end loop;
      -- slice3shift
      if slice0cost_pixels_tag_valid then
        for i in 0 to 2 loop
          slice3shift_search(i, 0) <= slice2shift_search_out(i);
          for j in 1 to 15 loop
            slice3shift_search(i, j) <= slice3shift_search(i, j - 1);
          end loop;
        end loop;
      end if;
      slice3shift_reference(0) <= slice2shift_reference(0);
      slice3shift_reference(1) <= slice2shift_reference(1);
      slice3shift_reference(2) <= slice2shift_reference(2);
      -- slice3cost
      for i in 0 to 2 loop
        slice3cost_pixels_first_0_count_value(i, 0) := is_set(slice3shift_reference(i), 2);
        slice3cost_pixels_first_0_count_value_2(i, 0) := is_set(slice3shift_reference(i), 1);
        slice3cost_pixels_first_0_count_value(i, 1) := is_set(slice3shift_reference(i), 3);
        slice3cost_pixels_first_0_count_value_2(i, 1) := is_set(slice3shift_reference(i), 5);
        slice3cost_pixels_first_0_count_1_value_3(i) := is_set(slice3shift_reference(i), 4);
        slice3cost_pixels_first_0_count_value(i, 2) := is_set(slice3shift_reference(i), 8);
        slice3cost_pixels_first_0_count_value_2(i, 2) := is_set(slice3shift_reference(i), 6);
        slice3cost_pixels_first_0_count_value(i, 3) := is_set(slice3shift_reference(i), 9);
        slice3cost_pixels_first_0_count_value_2(i, 3) := is_set(slice3shift_reference(i), 11);
        slice3cost_pixels_first_0_count_3_value_3(i) := is_set(slice3shift_reference(i), 10);
        slice3cost_pixels_first_0_count_value(i, 4) := is_set(slice3shift_reference(i), 12);
      end loop;
      for i in 0 to 2 loop
        slice3cost_pixels_first_count(i, 0, 0) <= as_number((is_set(slice3shift_search(i, 0), 0) /=
          is_set(slice3shift_reference(i), 0))) + as_number((slice3cost_pixels_first_0_count_value(i, 0) /=
          is_set(slice3shift_search(i, 0), 2))) + as_number((slice3cost_pixels_first_0_count_value_2(i, 0) /=
          is_set(slice3shift_search(i, 0), 1)));
        slice3cost_pixels_first_count(i, 0, 1) <= as_number((slice3cost_pixels_first_0_count_value(i, 1) /=
          is_set(slice3shift_search(i, 0), 3))) + as_number((slice3cost_pixels_first_0_count_value_2(i, 1) /=
          is_set(slice3shift_search(i, 0), 5))) + as_number((slice3cost_pixels_first_0_count_1_value_3(i) /=
          is_set(slice3shift_search(i, 0), 4)));
        slice3cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, 0) mod 256), 8)) xor
          (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) +
          as_number((slice3cost_pixels_first_0_count_value(i, 2) /= is_set(slice3shift_search(i, 0), 8))) +
          as_number((slice3cost_pixels_first_0_count_value_2(i, 2) /= is_set(slice3shift_search(i, 0), 6)));
        slice3cost_pixels_first_count(i, 0, 3) <= as_number((slice3cost_pixels_first_0_count_value(i, 3) /=
          is_set(slice3shift_search(i, 0), 9))) + as_number((slice3cost_pixels_first_0_count_value_2(i, 3) /=
          is_set(slice3shift_search(i, 0), 11))) + as_number((slice3cost_pixels_first_0_count_3_value_3(i) /=
          is_set(slice3shift_search(i, 0), 10)));
        slice3cost_pixels_first_count_4(i, 0) <= as_number((is_set(slice3shift_reference(i), 13) /=
          is_set(slice3shift_search(i, 0), 13))) + as_number((slice3cost_pixels_first_0_count_value(i, 4) /=
          is_set(slice3shift_search(i, 0), 12)));
        for j in 1 to 15 loop
          slice3cost_pixels_first_count(i, j, 0) <= as_number((is_set(slice3shift_search(i, j), 0) /=
            is_set(slice3shift_reference(i), 0))) + as_number((is_set(slice3shift_search(i, j), 2) /=
            slice3cost_pixels_first_0_count_value(i, 0))) + as_number((is_set(slice3shift_search(i, j), 1) /=
            slice3cost_pixels_first_0_count_value_2(i, 0)));
          slice3cost_pixels_first_count(i, j, 1) <= as_number((is_set(slice3shift_search(i, j), 3) /=
            slice3cost_pixels_first_0_count_value(i, 1))) + as_number((is_set(slice3shift_search(i, j), 5) /=
            slice3cost_pixels_first_0_count_value_2(i, 1))) + as_number((is_set(slice3shift_search(i, j), 4) /=
            slice3cost_pixels_first_0_count_1_value_3(i)));
          slice3cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned((slice3shift_search(i, j) mod 256), 8))
            xor (to_unsigned((slice3shift_reference(i) mod 256), 8)))) / 128) + as_number((is_set(slice3shift_search(i,
            j), 8) /= slice3cost_pixels_first_0_count_value(i, 2))) + as_number((is_set(slice3shift_search(i, j), 6) /=
            slice3cost_pixels_first_0_count_value_2(i, 2)));
          slice3cost_pixels_first_count(i, j, 3) <= as_number((is_set(slice3shift_search(i, j), 9) /=
            slice3cost_pixels_first_0_count_value(i, 3))) + as_number((is_set(slice3shift_search(i, j), 11) /=
            slice3cost_pixels_first_0_count_value_2(i, 3))) + as_number((is_set(slice3shift_search(i, j), 10) /=
            slice3cost_pixels_first_0_count_3_value_3(i)));
          slice3cost_pixels_first_count_4(i, j) <= as_number((is_set(slice3shift_search(i, j), 13) /=
            is_set(slice3shift_reference(i), 13))) + as_number((is_set(slice3shift_search(i, j), 12) /=
            slice3cost_pixels_first_0_count_value(i, 4)));
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 15 loop
          slice3cost_pixels_cost(i, j) <= slice3cost_pixels_first_count(i, j, 3) + slice3cost_pixels_first_count(i, j,
            0) + slice3cost_pixels_first_count(i, j, 1) + slice3cost_pixels_first_count_4(i, j) +
            slice3cost_pixels_first_count(i, j, 2);
        end loop;
      end loop;
      for i in 0 to 15 loop
        slice3cost_pair_0(i) <= slice3cost_pixels_cost(1, i) + slice3cost_pixels_cost(2, i);
      end loop;
      for i in 0 to 15 loop
        slice3cost_single_0(i) <= slice3cost_pixels_cost(0, i);
      end loop;
      for i in 0 to 15 loop
        slice3cost_column_0(i) <= slice3cost_pair_0(i) + slice3cost_single_0(i);
      end loop;
      -- slice3window
      if slice0_tag_valid(1) then
        for i in 0 to 15 loop
          slice3window_partial_0_0(i) <= slice3cost_column_0(i);
        end loop;
        for i in 0 to 15 loop
          slice3window_partial_0_1(i) <= slice3cost_column_0(i) + slice3window_partial_0_0(i);
        end loop;
      end if;
      for i in 0 to 15 loop
        slice3window_sum_0(i) <= slice3cost_column_0(i) + slice3window_partial_0_1(i);
      end loop;
      -- slice3mask
      slice3mask_inside_0_all := (not slice0_tag_valid(1)) and slice3mask_inside(0);
      if slice1_tag_0_first_column then
        slice3mask_inside_choice(0) := slice3mask_inside_0_all;
      else
        slice3mask_inside_choice(0) := slice0_tag_valid(1) or slice3mask_inside(0);
      end if;
      for i in 1 to 15 loop
        if slice0_tag_valid(1) then
          slice3mask_inside_choice(i) := slice3mask_inside(i - 1);
        else
          slice3mask_inside_choice(i) := slice3mask_inside(i);
        end if;
      end loop;
      if slice2mask_left_out then
        slice3mask_inside(0) <= slice3mask_inside_choice(0);
      else
        slice3mask_inside(0) <= slice3mask_inside_0_all;
      end if;
      if slice1_tag_0_first_column then
        for i in 1 to 15 loop
          slice3mask_inside(i) <= (not slice0_tag_valid(1)) and slice3mask_inside(i);
        end loop;
      else
        for i in 1 to 15 loop
          slice3mask_inside(i) <= slice3mask_inside_choice(i);
        end loop;
      end if;
      -- slice3
      for i in 0 to 15 loop
        if (not is_set(slice3window_sum_0(i), 6)) and ((not is_set(slice3window_sum_0(i), 5)) or (not
          is_set(slice3window_sum_0(i), 4)) or (not is_set(slice3window_sum_0(i), 3))) then
          slice3_held_0_choice(i) := slice3window_sum_0(i) / 8;
        else
          slice3_held_0_choice(i) := 6;
        end if;
      end loop;
      for i in 0 to 15 loop
        if slice3mask_inside(i) then
          slice3_held_0(i) <= slice3_held_0_choice(i);
        else
          slice3_held_0(i) <= 3;
        end if;
      end loop;
      -- entry
      entry_order_falls_any := entry_order_inside or (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
      entry_order_falls_all := (not entry_order_inside) and slice0_tag_map_column(3) and slice0_tag_valid(3);
      entry_order_complete_all := slice0_tag_map_column(3) and slice0_tag_valid(3);
      entry_order_complete_any := (not slice0_tag_map_column(3)) or (not slice0_tag_valid(3));
      if entry_order_falls_all then
        entry_order_turned_output_column_choice := entry_order_output and entry_order_complete;
      else
        entry_order_turned_output_column_choice := entry_order_held_output;
      end if;
      for i in 0 to 15 loop
        entry_next_cost(i) <= slice0_held(3, i);
      end loop;
      for i in 16 to 31 loop
        entry_next_cost(i) <= slice1_held(2, i - 16);
      end loop;
      for i in 32 to 47 loop
        entry_next_cost(i) <= slice2_held(1, i - 32);
      end loop;
      for i in 48 to 63 loop
        entry_next_cost(i) <= slice3_held_0(i - 48);
      end loop;
      entry_next_tag_valid <= slice0_tag_valid(3);
      entry_next_tag_map_column <= slice0_tag_map_column(3);
      entry_next_tag_first_column <= slice0_tag_first_column(3);
      entry_next_tag_end_of_line <= slice0_tag_end_of_line(3);
      entry_order_turned_output_column <= entry_order_turned_output_column_choice and slice0_tag_map_column(3);
      entry_order_turned_first_column <= entry_order_falls_all;
      entry_order_turned_start_of_frame <= (not entry_order_inside) and slice0_tag_map_column(3) and
        slice0_tag_valid(3) and entry_order_first and entry_order_output and entry_order_complete;
      for i in 0 to 63 loop
        entry_cost(i) <= entry_next_cost(i);
      end loop;
      entry_tag_valid <= entry_next_tag_valid;
      entry_tag_map_column <= entry_next_tag_map_column;
      entry_tag_first_column <= entry_next_tag_first_column;
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
      if slice0_tag_end_of_line(3) then
        entry_order_complete <= entry_order_complete or entry_order_complete_all;
      else
        entry_order_complete <= entry_order_complete and entry_order_complete_any;
      end if;
      if entry_order_complete_all then
        if slice0_tag_first_column(3) then
          entry_next_column <= 0;
          entry_next_top <= slice0_tag_start_of_frame(3);
        else
          entry_next_column <= (entry_next_column + 1) mod 512;
          entry_next_top <= entry_next_top;
        end if;
      end if;
      if entry_order_falls then
        entry_order_address_choice := 511;
      else
        entry_order_address_choice := 1;
      end if;
      if entry_order_falls then
        entry_order_address_choice_2 := 0;
      else
        entry_order_address_choice_2 := 447;
      end if;
      if not entry_order_complete_any then
        if entry_order_falls_any then
          entry_order_address <= (entry_order_address_choice + entry_order_address) mod 512;
        else
          entry_order_address <= entry_order_address_choice_2;
        end if;
      end if;
      if slice0_tag_valid(3) then
        entry_order_inside <= slice0_tag_map_column(3);
      end if;
      if entry_order_falls_all then
        entry_order_output <= slice0_tag_output_column(3);
        entry_order_first <= slice0_tag_start_of_frame(3);
        entry_order_held_output <= entry_order_output and entry_order_complete;
      end if;
      -- forward
      for i in 0 to 7 loop
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
      forward_left_start_cost_0_any := ((((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
        forward_left_relief_beyond) / 64) = 1) or is_set(forward_left_tree_next_next_next_next_smallest_0, 6);
      if is_set(forward_left_relief_largest, 0) then
        forward_left_start_cost_0_choice := (not is_set(forward_left_room, 1)) or (not is_set(forward_left_room, 0));
      else
        forward_left_start_cost_0_choice := not is_set(forward_left_room, 1);
      end if;
      if is_set(forward_left_relief_largest, 1) then
        forward_left_start_cost_0_choices(2) := forward_left_start_cost_0_choice;
      else
        forward_left_start_cost_0_choices(2) := is_set(forward_left_relief_largest, 0) and ((forward_left_room mod 4) =
          0);
      end if;
      forward_left_start_cost_0_value := is_set(forward_left_room, 2);
      if forward_left_start_cost_0_choices(2) then
        forward_left_start_cost_0_choices(3) := (not is_set(forward_left_relief_largest, 2)) and
          forward_left_start_cost_0_value;
      else
        forward_left_start_cost_0_choices(3) := (not is_set(forward_left_relief_largest, 2)) or
          forward_left_start_cost_0_value;
      end if;
      forward_left_start_cost_0_value_2 := is_set(forward_left_room, 3);
      if forward_left_start_cost_0_choices(3) then
        forward_left_start_cost_0_choices(4) := (not is_set(forward_left_relief_largest, 3)) or
          forward_left_start_cost_0_value_2;
      else
        forward_left_start_cost_0_choices(4) := (not is_set(forward_left_relief_largest, 3)) and
          forward_left_start_cost_0_value_2;
      end if;
      forward_left_start_cost_0_is_equal := (forward_left_room / 16) = 0;
      if is_set(forward_left_relief_largest, 4) then
        forward_left_start_cost_0_choices(5) := not is_set(forward_left_room, 5);
      else
        forward_left_start_cost_0_choices(5) := forward_left_start_cost_0_is_equal;
      end if;
      if forward_left_start_cost_0_choices(4) then
        forward_left_start_cost_0_choices(6) := is_set(forward_left_relief_largest, 4) and
          forward_left_start_cost_0_is_equal;
      else
        forward_left_start_cost_0_choices(6) := forward_left_start_cost_0_choices(5);
      end if;
      if forward_left_start_cost_0_choices(6) then
        forward_left_start_cost_0_choices_from_7(7) := 0;
      else
        forward_left_start_cost_0_choices_from_7(7) := (forward_left_room - forward_left_relief_largest) mod 64;
      end if;
      forward_left_start_cost_0_is_less := 127 < ((forward_left_tree_next_next_next_next_smallest_0 mod 64) +
        forward_left_relief_reach_of_best);
      if forward_left_start_cost_0_is_less then
        forward_left_start_cost_0_choices_from_7(8) := (forward_left_tree_next_next_next_next_smallest_0 +
          forward_left_relief_reach_of_best) mod 64;
      else
        forward_left_start_cost_0_choices_from_7(8) := 0;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_start_cost_0_choices_from_7(9) := forward_left_start_cost_0_choices_from_7(7);
      else
        forward_left_start_cost_0_choices_from_7(9) := forward_left_start_cost_0_choices_from_7(8);
      end if;
      forward_left_room_value := (forward_left_start_cost(8) + forward_left_room) mod 64;
      if forward_left_start_cost_0_choices(6) then
        forward_left_room_choice := forward_left_room_value;
      else
        forward_left_room_choice := (forward_left_start_cost(8) + forward_left_relief_largest) mod 64;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_room_choices(2) := (forward_left_relief_room_of_best -
          forward_left_tree_next_next_next_next_smallest_0) mod 64;
      else
        forward_left_room_choices(2) := forward_left_room_value;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_room_choices(3) := forward_left_room_choice;
      else
        forward_left_room_choices(3) := forward_left_room_choices(2);
      end if;
      if sums_turn_waiting_first(5) then
        forward_left_smallest_choice := 0;
      else
        forward_left_smallest_choice := forward_reliefs_moved(5);
      end if;
      forward_left_smallest_difference := (forward_smallest_next_next_next_next_next_smallest_0 +
        forward_left_smallest_choice) - forward_reliefs_moved(4);
      if (forward_left_smallest_choice - forward_left_relief_past(0)) < 0 then
        forward_left_relief_pairs_0_choice := forward_left_relief_past(0);
      else
        forward_left_relief_pairs_0_choice := forward_left_smallest_choice;
      end if;
      if (forward_left_relief_fours(0) - forward_left_relief_fours(2)) < 0 then
        forward_left_relief_older_choice := forward_left_relief_fours(2);
      else
        forward_left_relief_older_choice := forward_left_relief_fours(0);
      end if;
      if (forward_reliefs_moved(4) - forward_left_smallest_choice) < 0 then
        forward_left_relief_recent_choice := forward_left_smallest_choice;
      else
        forward_left_relief_recent_choice := forward_reliefs_moved(4);
      end if;
      if (forward_reliefs_moved(4) - forward_left_relief_recent) < 0 then
        forward_left_relief_largest_choice := forward_left_relief_recent;
      else
        forward_left_relief_largest_choice := forward_reliefs_moved(4);
      end if;
      forward_left_relief_reach_of_best_sum := forward_left_room + forward_left_relief_leaves;
      if forward_left_start_cost_0_choices(6) then
        forward_left_relief_reach_of_best_choice := forward_left_relief_reach_of_best_sum;
      else
        forward_left_relief_reach_of_best_choice := forward_left_relief_largest + forward_left_relief_leaves;
      end if;
      if forward_left_start_cost_0_is_less then
        forward_left_relief_reach_of_best_choices(2) := (forward_left_relief_reach_again -
          (forward_left_tree_next_next_next_next_smallest_0 mod 64)) mod 256;
      else
        forward_left_relief_reach_of_best_choices(2) := forward_left_relief_reach_of_best_sum;
      end if;
      if forward_left_start_cost_0_any then
        forward_left_relief_reach_of_best_choices(3) := forward_left_relief_reach_of_best_choice;
      else
        forward_left_relief_reach_of_best_choices(3) := forward_left_relief_reach_of_best_choices(2);
      end if;
      if sums_turn_waiting_first(5) then
        forward_left_relief_leaves_choice := 64;
      else
        forward_left_relief_leaves_choice := forward_left_start_cost(7) + 64;
      end if;
      forward_left_g_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest) mod 128;
      forward_left_g_less_copy_0_value := (forward_left_start_cost(0) + forward_left_smallest_less) mod 128;
      for i in 0 to 63 loop
        if (forward_left_arrived(i) - forward_left_cost(i)) < 0 then
          forward_left_cost_choice(i) := forward_left_arrived(i);
        else
          forward_left_cost_choice(i) := forward_left_cost(i);
        end if;
        if is_set(forward_left_cost_choice(i), 6) or forward_first(8) then
          forward_left_cost_choice_2(i) := 64;
        else
          forward_left_cost_choice_2(i) := forward_left_cost_choice(i);
        end if;
      end loop;
      if forward_first(8) then
        forward_left_arrived_choice(0) := 64;
      else
        forward_left_arrived_choice(0) := forward_left_cost(1);
      end if;
      for i in 1 to 2 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2(i - 1) := 64;
        else
          forward_left_arrived_choice_2(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s(i - 1) := 64;
        else
          forward_left_arrived_choice_2s(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_11(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_11(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_15(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_15(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_19(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_19(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_23(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_23(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_27(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_27(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_31(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_31(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_35(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_35(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_39(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_39(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_43(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_43(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_47(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_47(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_51(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_51(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_55(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_55(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
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
        if forward_first(8) then
          forward_left_arrived_choice_2s_from_59(i - 1) := 64;
        else
          forward_left_arrived_choice_2s_from_59(i - 1) := forward_left_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if forward_first(8) then
          forward_left_arrived_choice(i) := 64;
        else
          forward_left_arrived_choice(i) := forward_left_pair_choice(i - 31);
        end if;
      end loop;
      if forward_first(8) then
        forward_left_arrived_choice(63) := 64;
      else
        forward_left_arrived_choice(63) := forward_left_cost(62);
      end if;
      for i in 0 to 9 loop
        if forward_above_ready_top then
          forward_above_total_choice(6 * i) := 20;
        else
          forward_above_total_choice(6 * i) := forward_above_ready_words(i) mod 32;
        end if;
        if forward_above_ready_top then
          forward_above_total_choice(6 * i + 1) := 20;
        else
          forward_above_total_choice(6 * i + 1) := (forward_above_ready_words(i) / 32) mod 32;
        end if;
        if forward_above_ready_top then
          forward_above_total_choice(6 * i + 2) := 20;
        else
          forward_above_total_choice(6 * i + 2) := (forward_above_ready_words(i) / 1024) mod 32;
        end if;
        if forward_above_ready_top then
          forward_above_total_choice(6 * i + 3) := 20;
        else
          forward_above_total_choice(6 * i + 3) := (forward_above_ready_words(i) / 32768) mod 32;
        end if;
        if forward_above_ready_top then
          forward_above_total_choice(6 * i + 4) := 20;
        else
          forward_above_total_choice(6 * i + 4) := (forward_above_ready_words(i) / 1048576) mod 32;
        end if;
        if forward_above_ready_top then
          forward_above_total_choice(6 * i + 5) := 20;
        else
          forward_above_total_choice(6 * i + 5) := (forward_above_ready_words(i) / 33554432) mod 32;
        end if;
      end loop;
      if forward_above_ready_top then
        forward_above_total_choice(60) := 20;
      else
        forward_above_total_choice(60) := forward_above_ready_words_10 mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(61) := 20;
      else
        forward_above_total_choice(61) := (forward_above_ready_words_10 / 32) mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(62) := 20;
      else
        forward_above_total_choice(62) := (forward_above_ready_words_10 / 1024) mod 32;
      end if;
      if forward_above_ready_top then
        forward_above_total_choice(63) := 20;
      else
        forward_above_total_choice(63) := (forward_above_ready_words_10 / 32768) mod 32;
      end if;
      if entry_tag_valid then
        forward_cost_delay_ring_write_address <= forward_cost_delay_ring_read_address;
        for i in 0 to 31 loop
          forward_left_pair(i) <= forward_left_pair_choice(i);
        end loop;
        forward_left_smallest <= forward_left_smallest_difference mod 128;
        forward_left_smallest_less <= (forward_left_smallest_difference + 119) mod 128;
        forward_left_first(0) <= forward_first(5);
        forward_left_first(1) <= forward_left_first(0);
        forward_left_first(2) <= forward_left_first(1);
        forward_left_relief_next(0) <= forward_reliefs_moved(4);
        forward_left_relief_next(1) <= forward_left_relief_next(0);
        forward_left_relief_next(2) <= forward_left_relief_next(1);
        forward_left_relief_next(3) <= forward_left_relief_next(2);
        forward_left_relief_past(0) <= forward_left_smallest_choice;
        for i in 1 to 7 loop
          forward_left_relief_past(i) <= forward_left_relief_past(i - 1);
        end loop;
        forward_left_relief_pairs(0) <= forward_left_relief_pairs_0_choice;
        forward_left_relief_pairs(1) <= forward_left_relief_pairs(0);
        forward_left_relief_fours(1) <= forward_left_relief_fours(0);
        forward_left_relief_fours(2) <= forward_left_relief_fours(1);
        forward_left_relief_largest <= forward_left_relief_largest_choice;
        forward_left_relief_beyond <= (forward_left_relief_largest_choice - forward_left_relief_past(7)) mod 32;
        forward_left_relief_leaves <= forward_left_relief_leaves_choice - forward_left_relief_past(6);
        forward_left_relief_room_of_best <= forward_left_relief_past(7) + forward_left_relief_leaves_choice;
        forward_left_relief_reach_again <= (64 - forward_left_relief_past(6)) + forward_left_relief_past(7) +
          forward_left_relief_leaves_choice;
        forward_left_g_copy(0) <= forward_left_g_copy_0_value;
        forward_left_g_copy(1) <= forward_left_g_copy_0_value;
        forward_left_g_copy(2) <= forward_left_g_copy_0_value;
        forward_left_g_copy(3) <= forward_left_g_copy_0_value;
        forward_left_g_less_copy(0) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(1) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(2) <= forward_left_g_less_copy_0_value;
        forward_left_g_less_copy(3) <= forward_left_g_less_copy_0_value;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            forward_left_stay_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_copy(2 * i + 1)) mod
              128;
          end loop;
        end loop;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i)) mod
              128;
          end loop;
          for j in 16 to 31 loop
            forward_left_step_change(32 * i + j) <= (forward_cost(0, 32 * i + j) - forward_left_g_less_copy(2 * i + 1))
              mod 128;
          end loop;
        end loop;
        for i in 0 to 63 loop
          forward_left_cost(i) <= (forward_left_cost_choice_2(i) + forward_left_stay_change(i)) mod 128;
        end loop;
        for i in 0 to 2 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 128;
        end loop;
        forward_left_arrived(3) <= (forward_left_arrived_choice_2(3) + forward_left_step_change(3)) mod 128;
        forward_left_arrived(4) <= (forward_left_arrived_choice_2(4) + forward_left_step_change(4)) mod 128;
        forward_left_arrived(5) <= (forward_left_arrived_choice(5) + forward_left_step_change(5)) mod 128;
        forward_left_arrived(6) <= (forward_left_arrived_choice(6) + forward_left_step_change(6)) mod 128;
        forward_left_arrived(7) <= (forward_left_arrived_choice_2s(7) + forward_left_step_change(7)) mod 128;
        forward_left_arrived(8) <= (forward_left_arrived_choice_2s(8) + forward_left_step_change(8)) mod 128;
        forward_left_arrived(9) <= (forward_left_arrived_choice(9) + forward_left_step_change(9)) mod 128;
        forward_left_arrived(10) <= (forward_left_arrived_choice(10) + forward_left_step_change(10)) mod 128;
        forward_left_arrived(11) <= (forward_left_arrived_choice_2s_from_11(11) + forward_left_step_change(11)) mod 128;
        forward_left_arrived(12) <= (forward_left_arrived_choice_2s_from_11(12) + forward_left_step_change(12)) mod 128;
        forward_left_arrived(13) <= (forward_left_arrived_choice(13) + forward_left_step_change(13)) mod 128;
        forward_left_arrived(14) <= (forward_left_arrived_choice(14) + forward_left_step_change(14)) mod 128;
        forward_left_arrived(15) <= (forward_left_arrived_choice_2s_from_15(15) + forward_left_step_change(15)) mod 128;
        forward_left_arrived(16) <= (forward_left_arrived_choice_2s_from_15(16) + forward_left_step_change(16)) mod 128;
        forward_left_arrived(17) <= (forward_left_arrived_choice(17) + forward_left_step_change(17)) mod 128;
        forward_left_arrived(18) <= (forward_left_arrived_choice(18) + forward_left_step_change(18)) mod 128;
        forward_left_arrived(19) <= (forward_left_arrived_choice_2s_from_19(19) + forward_left_step_change(19)) mod 128;
        forward_left_arrived(20) <= (forward_left_arrived_choice_2s_from_19(20) + forward_left_step_change(20)) mod 128;
        forward_left_arrived(21) <= (forward_left_arrived_choice(21) + forward_left_step_change(21)) mod 128;
        forward_left_arrived(22) <= (forward_left_arrived_choice(22) + forward_left_step_change(22)) mod 128;
        forward_left_arrived(23) <= (forward_left_arrived_choice_2s_from_23(23) + forward_left_step_change(23)) mod 128;
        forward_left_arrived(24) <= (forward_left_arrived_choice_2s_from_23(24) + forward_left_step_change(24)) mod 128;
        forward_left_arrived(25) <= (forward_left_arrived_choice(25) + forward_left_step_change(25)) mod 128;
        forward_left_arrived(26) <= (forward_left_arrived_choice(26) + forward_left_step_change(26)) mod 128;
        forward_left_arrived(27) <= (forward_left_arrived_choice_2s_from_27(27) + forward_left_step_change(27)) mod 128;
        forward_left_arrived(28) <= (forward_left_arrived_choice_2s_from_27(28) + forward_left_step_change(28)) mod 128;
        forward_left_arrived(29) <= (forward_left_arrived_choice(29) + forward_left_step_change(29)) mod 128;
        forward_left_arrived(30) <= (forward_left_arrived_choice(30) + forward_left_step_change(30)) mod 128;
        forward_left_arrived(31) <= (forward_left_arrived_choice_2s_from_31(31) + forward_left_step_change(31)) mod 128;
        forward_left_arrived(32) <= (forward_left_arrived_choice_2s_from_31(32) + forward_left_step_change(32)) mod 128;
        forward_left_arrived(33) <= (forward_left_arrived_choice(33) + forward_left_step_change(33)) mod 128;
        forward_left_arrived(34) <= (forward_left_arrived_choice(34) + forward_left_step_change(34)) mod 128;
        forward_left_arrived(35) <= (forward_left_arrived_choice_2s_from_35(35) + forward_left_step_change(35)) mod 128;
        forward_left_arrived(36) <= (forward_left_arrived_choice_2s_from_35(36) + forward_left_step_change(36)) mod 128;
        forward_left_arrived(37) <= (forward_left_arrived_choice(37) + forward_left_step_change(37)) mod 128;
        forward_left_arrived(38) <= (forward_left_arrived_choice(38) + forward_left_step_change(38)) mod 128;
        forward_left_arrived(39) <= (forward_left_arrived_choice_2s_from_39(39) + forward_left_step_change(39)) mod 128;
        forward_left_arrived(40) <= (forward_left_arrived_choice_2s_from_39(40) + forward_left_step_change(40)) mod 128;
        forward_left_arrived(41) <= (forward_left_arrived_choice(41) + forward_left_step_change(41)) mod 128;
        forward_left_arrived(42) <= (forward_left_arrived_choice(42) + forward_left_step_change(42)) mod 128;
        forward_left_arrived(43) <= (forward_left_arrived_choice_2s_from_43(43) + forward_left_step_change(43)) mod 128;
        forward_left_arrived(44) <= (forward_left_arrived_choice_2s_from_43(44) + forward_left_step_change(44)) mod 128;
        forward_left_arrived(45) <= (forward_left_arrived_choice(45) + forward_left_step_change(45)) mod 128;
        forward_left_arrived(46) <= (forward_left_arrived_choice(46) + forward_left_step_change(46)) mod 128;
        forward_left_arrived(47) <= (forward_left_arrived_choice_2s_from_47(47) + forward_left_step_change(47)) mod 128;
        forward_left_arrived(48) <= (forward_left_arrived_choice_2s_from_47(48) + forward_left_step_change(48)) mod 128;
        forward_left_arrived(49) <= (forward_left_arrived_choice(49) + forward_left_step_change(49)) mod 128;
        forward_left_arrived(50) <= (forward_left_arrived_choice(50) + forward_left_step_change(50)) mod 128;
        forward_left_arrived(51) <= (forward_left_arrived_choice_2s_from_51(51) + forward_left_step_change(51)) mod 128;
        forward_left_arrived(52) <= (forward_left_arrived_choice_2s_from_51(52) + forward_left_step_change(52)) mod 128;
        forward_left_arrived(53) <= (forward_left_arrived_choice(53) + forward_left_step_change(53)) mod 128;
        forward_left_arrived(54) <= (forward_left_arrived_choice(54) + forward_left_step_change(54)) mod 128;
        forward_left_arrived(55) <= (forward_left_arrived_choice_2s_from_55(55) + forward_left_step_change(55)) mod 128;
        forward_left_arrived(56) <= (forward_left_arrived_choice_2s_from_55(56) + forward_left_step_change(56)) mod 128;
        forward_left_arrived(57) <= (forward_left_arrived_choice(57) + forward_left_step_change(57)) mod 128;
        forward_left_arrived(58) <= (forward_left_arrived_choice(58) + forward_left_step_change(58)) mod 128;
        forward_left_arrived(59) <= (forward_left_arrived_choice_2s_from_59(59) + forward_left_step_change(59)) mod 128;
        forward_left_arrived(60) <= (forward_left_arrived_choice_2s_from_59(60) + forward_left_step_change(60)) mod 128;
        for i in 61 to 63 loop
          forward_left_arrived(i) <= (forward_left_arrived_choice(i) + forward_left_step_change(i)) mod 128;
        end loop;
        for i in 0 to 9 loop
          forward_above_ready_words(i) <= to_integer(forward_above_read_words(i));
        end loop;
        forward_above_ready_words_10 <= to_integer(forward_above_read_words_10);
        for i in 0 to 63 loop
          forward_above_ready_cost(i) <= entry_cost(i);
        end loop;
        forward_above_ready_top <= entry_top;
        for i in 0 to 63 loop
          forward_above_total(i) <= forward_above_total_choice(i) + forward_above_ready_cost(i);
        end loop;
        forward_above_delay_ring_write_address <= forward_above_delay_ring_read_address;
        forward_above_smallest_copy(0) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(1) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(2) <= forward_above_tree_next_next_next_next_next_smallest_0;
        forward_above_smallest_copy(3) <= forward_above_tree_next_next_next_next_next_smallest_0;
        for i in 0 to 1 loop
          forward_above_cost(6 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(0)) mod
            32;
          forward_above_cost(6 * i + 1) <= (to_integer(forward_above_delay_held(i)(30 downto 5)) -
            forward_above_smallest_copy(0)) mod 32;
          forward_above_cost(6 * i + 2) <= (to_integer(forward_above_delay_held(i)(30 downto 10)) -
            forward_above_smallest_copy(0)) mod 32;
          forward_above_cost(6 * i + 3) <= (to_integer(forward_above_delay_held(i)(30 downto 15)) -
            forward_above_smallest_copy(0)) mod 32;
          forward_above_cost(6 * i + 4) <= (to_integer(forward_above_delay_held(i)(30 downto 20)) -
            forward_above_smallest_copy(0)) mod 32;
          forward_above_cost(6 * i + 5) <= (to_integer(forward_above_delay_held(i)(30 downto 25)) -
            forward_above_smallest_copy(0)) mod 32;
        end loop;
        for i in 2 to 3 loop
          forward_above_cost(6 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(i - 2))
            mod 32;
          forward_above_cost(6 * i + 1) <= (to_integer(forward_above_delay_held(i)(30 downto 5)) -
            forward_above_smallest_copy(i - 2)) mod 32;
          forward_above_cost(6 * i + 2) <= (to_integer(forward_above_delay_held(i)(30 downto 10)) -
            forward_above_smallest_copy(i - 2)) mod 32;
          forward_above_cost(6 * i + 3) <= (to_integer(forward_above_delay_held(i)(30 downto 15)) -
            forward_above_smallest_copy(i - 2)) mod 32;
          forward_above_cost(6 * i + 4) <= (to_integer(forward_above_delay_held(i)(30 downto 20)) -
            forward_above_smallest_copy(1)) mod 32;
          forward_above_cost(6 * i + 5) <= (to_integer(forward_above_delay_held(i)(30 downto 25)) -
            forward_above_smallest_copy(1)) mod 32;
        end loop;
        for i in 4 to 5 loop
          forward_above_cost(6 * i) <= (to_integer(forward_above_delay_held(i)) - forward_above_smallest_copy(1)) mod
            32;
          forward_above_cost(6 * i + 1) <= (to_integer(forward_above_delay_held(i)(30 downto 5)) -
            forward_above_smallest_copy(1)) mod 32;
          forward_above_cost(6 * i + 2) <= (to_integer(forward_above_delay_held(i)(30 downto 10)) -
            forward_above_smallest_copy(i - 3)) mod 32;
          forward_above_cost(6 * i + 3) <= (to_integer(forward_above_delay_held(i)(30 downto 15)) -
            forward_above_smallest_copy(i - 3)) mod 32;
          forward_above_cost(6 * i + 4) <= (to_integer(forward_above_delay_held(i)(30 downto 20)) -
            forward_above_smallest_copy(i - 3)) mod 32;
          forward_above_cost(6 * i + 5) <= (to_integer(forward_above_delay_held(i)(30 downto 25)) -
            forward_above_smallest_copy(i - 3)) mod 32;
        end loop;
        for i in 2 to 3 loop
          for j in 2 to 3 loop
            forward_above_cost(12 * i + 6 * j) <= (to_integer(forward_above_delay_held(2 * i + j)) -
              forward_above_smallest_copy(i)) mod 32;
            forward_above_cost(12 * i + 6 * j + 1) <= (to_integer(forward_above_delay_held(2 * i + j)(30 downto 5)) -
              forward_above_smallest_copy(i)) mod 32;
            forward_above_cost(12 * i + 6 * j + 2) <= (to_integer(forward_above_delay_held(2 * i + j)(30 downto 10)) -
              forward_above_smallest_copy(i)) mod 32;
            forward_above_cost(12 * i + 6 * j + 3) <= (to_integer(forward_above_delay_held(2 * i + j)(30 downto 15)) -
              forward_above_smallest_copy(i)) mod 32;
            forward_above_cost(12 * i + 6 * j + 4) <= (to_integer(forward_above_delay_held(2 * i + j)(30 downto 20)) -
              forward_above_smallest_copy(i)) mod 32;
            forward_above_cost(12 * i + 6 * j + 5) <= (to_integer(forward_above_delay_held(2 * i + j)(30 downto 25)) -
              forward_above_smallest_copy(i)) mod 32;
          end loop;
        end loop;
        forward_above_cost(60) <= (to_integer(forward_above_delay_held_10) - forward_above_smallest_copy(3)) mod 32;
        forward_above_cost(61) <= (to_integer(forward_above_delay_held_10(20 downto 5)) -
          forward_above_smallest_copy(3)) mod 32;
        forward_above_cost(62) <= (to_integer(forward_above_delay_held_10(20 downto 10)) -
          forward_above_smallest_copy(3)) mod 32;
        forward_above_cost(63) <= (to_integer(forward_above_delay_held_10(20 downto 15)) -
          forward_above_smallest_copy(3)) mod 32;
        forward_above_beside(0) <= forward_above_cost(1);
        forward_above_beside(63) <= forward_above_cost(62);
        forward_above_own_0 <= forward_above_cost(0);
        for i in 2 to 61 loop
          forward_above_own(i) <= forward_above_cost(i);
        end loop;
        forward_above_own_63 <= forward_above_cost(63);
        for i in 0 to 63 loop
          forward_above_step(i) <= forward_above_beside(i) + 5;
        end loop;
        forward_above_comes(0) <= entry_tag_map_column;
        for i in 1 to 11 loop
          forward_above_comes(i) <= forward_above_comes(i - 1);
        end loop;
        forward_above_column(0) <= entry_column;
        for i in 1 to 11 loop
          forward_above_column(i) <= forward_above_column(i - 1);
        end loop;
        for i in 0 to 63 loop
          forward_sum(i) <= ((forward_left_cost(i) + forward_above_cost(i)) - forward_reliefs_moved(8)) mod 128;
        end loop;
        forward_first(0) <= entry_turned_first_column;
        for i in 1 to 5 loop
          forward_first(i) <= forward_first(i - 1);
        end loop;
        forward_first(6) <= sums_turn_waiting_first(5);
        forward_first(7) <= forward_first(6);
        forward_first(8) <= forward_first(7);
        forward_first(9) <= forward_left_first(2);
        forward_first(10) <= forward_first(9);
        forward_reliefs_moved(0) <= relief_entered;
        for i in 1 to 8 loop
          forward_reliefs_moved(i) <= forward_reliefs_moved(i - 1);
        end loop;
        forward_reliefs_moved(9) <= forward_left_relief_next(3);
        forward_reliefs_moved(10) <= forward_reliefs_moved(9);
        for i in 0 to 5 loop
          forward_cost(0, 10 * i) <= to_integer(forward_cost_delay_held(i)(2 downto 0));
          forward_cost(0, 10 * i + 1) <= to_integer(forward_cost_delay_held(i)(5 downto 0)) / 8;
          for j in 2 to 9 loop
            forward_cost(0, 10 * i + j) <= to_integer(forward_cost_delay_held(i)(3 * j + 2 downto 3 * j));
          end loop;
        end loop;
        forward_cost(0, 60) <= to_integer(forward_cost_delay_held_6(2 downto 0));
        forward_cost(0, 61) <= to_integer(forward_cost_delay_held_6(5 downto 0)) / 8;
        forward_cost(0, 62) <= to_integer(forward_cost_delay_held_6(8 downto 6));
        forward_cost(0, 63) <= to_integer(forward_cost_delay_held_6(11 downto 9));
        for i in 1 to 3 loop
          for j in 0 to 63 loop
            forward_cost(i, j) <= forward_cost(i - 1, j);
          end loop;
        end loop;
        forward_smallest_cost(0) <= forward_smallest_next_next_next_next_next_smallest_0;
        forward_smallest_cost(1) <= forward_smallest_cost(0);
        forward_smallest_cost(2) <= forward_smallest_cost(1);
        forward_smallest_cost(3) <= forward_smallest_cost(2);
        forward_smallest_cost(4) <= forward_smallest_cost(3);
        for i in 0 to 31 loop
          if (entry_cost(2 * i + 1) - entry_cost(2 * i)) < 0 then
            forward_smallest_smallest(i) <= entry_cost(2 * i + 1);
          else
            forward_smallest_smallest(i) <= entry_cost(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_smallest_smallest(2 * i + 1) - forward_smallest_smallest(2 * i)) < 0 then
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i + 1);
          else
            forward_smallest_next_smallest(i) <= forward_smallest_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_smallest_next_smallest(2 * i + 1) - forward_smallest_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_smallest(i) <= forward_smallest_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_smallest_next_next_smallest(2 * i + 1) - forward_smallest_next_next_smallest(2 * i)) < 0 then
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_smallest(i) <= forward_smallest_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_smallest_next_next_next_smallest(2 * i + 1) - forward_smallest_next_next_next_smallest(2 * i)) <
            0 then
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i + 1);
          else
            forward_smallest_next_next_next_next_smallest(i) <= forward_smallest_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_smallest_next_next_next_next_smallest(1) - forward_smallest_next_next_next_next_smallest(0)) < 0
          then
          forward_smallest_next_next_next_next_next_smallest_0 <= forward_smallest_next_next_next_next_smallest(1);
        else
          forward_smallest_next_next_next_next_next_smallest_0 <= forward_smallest_next_next_next_next_smallest(0);
        end if;
        if forward_cost_delay_ring_read_address = 6 then
          forward_cost_delay_ring_read_address <= 0;
        else
          forward_cost_delay_ring_read_address <= (forward_cost_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 0 to 15 loop
          if (forward_left_pair(2 * i + 1) - forward_left_pair(2 * i)) < 0 then
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i + 1);
          else
            forward_left_tree_smallest(i) <= forward_left_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_left_tree_smallest(2 * i + 1) - forward_left_tree_smallest(2 * i)) < 0 then
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i + 1);
          else
            forward_left_tree_next_smallest(i) <= forward_left_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_left_tree_next_smallest(2 * i + 1) - forward_left_tree_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_smallest(i) <= forward_left_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_left_tree_next_next_smallest(2 * i + 1) - forward_left_tree_next_next_smallest(2 * i)) < 0 then
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i + 1);
          else
            forward_left_tree_next_next_next_smallest(i) <= forward_left_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_left_tree_next_next_next_smallest(1) - forward_left_tree_next_next_next_smallest(0)) < 0 then
          forward_left_tree_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_smallest(1);
        else
          forward_left_tree_next_next_next_next_smallest_0 <= forward_left_tree_next_next_next_smallest(0);
        end if;
        if sums_turn_waiting_first(5) then
          forward_left_start_cost(0) <= 40;
          for i in 1 to 8 loop
            forward_left_start_cost(i) <= 0;
          end loop;
          forward_left_room <= 0;
          forward_left_relief_reach_of_best <= 0;
        else
          forward_left_start_cost(0) <= forward_left_start_cost_0_choices_from_7(9);
          for i in 1 to 8 loop
            forward_left_start_cost(i) <= forward_left_start_cost(i - 1);
          end loop;
          forward_left_room <= forward_left_room_choices(3);
          forward_left_relief_reach_of_best <= forward_left_relief_reach_of_best_choices(3);
        end if;
        if (forward_left_relief_pairs_0_choice - forward_left_relief_pairs(1)) < 0 then
          forward_left_relief_fours(0) <= forward_left_relief_pairs(1);
        else
          forward_left_relief_fours(0) <= forward_left_relief_pairs_0_choice;
        end if;
        if (forward_left_smallest_choice - forward_left_relief_older_choice) < 0 then
          forward_left_relief_older <= forward_left_relief_older_choice;
        else
          forward_left_relief_older <= forward_left_smallest_choice;
        end if;
        if (forward_left_relief_recent_choice - forward_left_relief_older) < 0 then
          forward_left_relief_recent <= forward_left_relief_older;
        else
          forward_left_relief_recent <= forward_left_relief_recent_choice;
        end if;
        for i in 0 to 31 loop
          if (forward_above_total(2 * i + 1) - forward_above_total(2 * i)) < 0 then
            forward_above_tree_smallest(i) <= forward_above_total(2 * i + 1);
          else
            forward_above_tree_smallest(i) <= forward_above_total(2 * i);
          end if;
        end loop;
        for i in 0 to 15 loop
          if (forward_above_tree_smallest(2 * i + 1) - forward_above_tree_smallest(2 * i)) < 0 then
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i + 1);
          else
            forward_above_tree_next_smallest(i) <= forward_above_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (forward_above_tree_next_smallest(2 * i + 1) - forward_above_tree_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_smallest(i) <= forward_above_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (forward_above_tree_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_smallest(2 * i)) < 0 then
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_smallest(i) <= forward_above_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (forward_above_tree_next_next_next_smallest(2 * i + 1) - forward_above_tree_next_next_next_smallest(2 *
            i)) < 0 then
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i + 1);
          else
            forward_above_tree_next_next_next_next_smallest(i) <= forward_above_tree_next_next_next_smallest(2 * i);
          end if;
        end loop;
        if (forward_above_tree_next_next_next_next_smallest(1) - forward_above_tree_next_next_next_next_smallest(0)) <
          0 then
          forward_above_tree_next_next_next_next_next_smallest_0 <= forward_above_tree_next_next_next_next_smallest(1);
        else
          forward_above_tree_next_next_next_next_next_smallest_0 <= forward_above_tree_next_next_next_next_smallest(0);
        end if;
        if forward_above_delay_ring_read_address = 6 then
          forward_above_delay_ring_read_address <= 0;
        else
          forward_above_delay_ring_read_address <= (forward_above_delay_ring_read_address + 1) mod 8;
        end if;
        for i in 2 to 63 loop
          if (forward_above_cost(i) - forward_above_cost(i - 2)) < 0 then
            forward_above_beside(i - 1) <= forward_above_cost(i);
          else
            forward_above_beside(i - 1) <= forward_above_cost(i - 2);
          end if;
        end loop;
        if forward_above_own_0 < 20 then
          forward_above_stay(0) <= forward_above_own_0;
        else
          forward_above_stay(0) <= 20;
        end if;
        if forward_above_beside(0) < 20 then
          forward_above_stay(1) <= forward_above_beside(0);
        else
          forward_above_stay(1) <= 20;
        end if;
        for i in 2 to 61 loop
          if forward_above_own(i) < 20 then
            forward_above_stay(i) <= forward_above_own(i);
          else
            forward_above_stay(i) <= 20;
          end if;
        end loop;
        if forward_above_beside(63) < 20 then
          forward_above_stay(62) <= forward_above_beside(63);
        else
          forward_above_stay(62) <= 20;
        end if;
        if forward_above_own_63 < 20 then
          forward_above_stay(63) <= forward_above_own_63;
        else
          forward_above_stay(63) <= 20;
        end if;
      end if;
      if entry_tag_valid then
        forward_above_writes_copy_0_choice := forward_above_comes(10);
      else
        forward_above_writes_copy_0_choice := forward_above_comes(11);
      end if;
      forward_above_writes_copy_0 <= entry_next_tag_valid and forward_above_writes_copy_0_choice;
      for i in 0 to 9 loop
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
      if (forward_above_step(62) - forward_above_stay(62)) < 0 then
        forward_above_write_words_choice(10) := forward_above_step(62);
      else
        forward_above_write_words_choice(10) := forward_above_stay(62);
      end if;
      for i in 2 to 3 loop
        if (forward_above_step(69 - 3 * i) - forward_above_stay(69 - 3 * i)) < 0 then
          forward_above_write_words_10_choices(i) := forward_above_step(69 - 3 * i);
        else
          forward_above_write_words_10_choices(i) := forward_above_stay(69 - 3 * i);
        end if;
      end loop;
      if (forward_above_step(61) - forward_above_stay(61)) < 0 then
        forward_above_write_words_10_choices(4) := forward_above_step(61);
      else
        forward_above_write_words_10_choices(4) := forward_above_stay(61);
      end if;
      if forward_above_writes_copy_0 then
        for i in 0 to 9 loop
          forward_above_write_words(i) <= to_integer(((((((((((to_unsigned(forward_above_write_words_choice(i), 11) &
            to_unsigned(0, 20)) or (to_unsigned(forward_above_write_words_choices(i, 2), 6) & to_unsigned(0, 25)))) or
            (to_unsigned(forward_above_write_words_choices(i, 3), 16) & to_unsigned(0, 15)))) or
            (to_unsigned(forward_above_write_words_choices(i, 4), 21) & to_unsigned(0, 10)))) or
            (to_unsigned(forward_above_write_words_choices(i, 5), 31)))) or
            (to_unsigned(forward_above_write_words_choices(i, 6), 26) & to_unsigned(0, 5))));
        end loop;
        forward_above_write_words_10 <= to_integer(((((((to_unsigned(forward_above_write_words_choice(10), 11) &
          to_unsigned(0, 10)) or (to_unsigned(forward_above_write_words_10_choices(2), 6) & to_unsigned(0, 15)))) or
          (to_unsigned(forward_above_write_words_10_choices(3), 21)))) or
          (to_unsigned(forward_above_write_words_10_choices(4), 16) & to_unsigned(0, 5))));
        forward_above_write_column <= forward_above_column(11);
      end if;
      -- sums
      for i in 0 to 7 loop
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
      sums_right_start_cost_0_any := ((((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
        sums_right_relief_beyond) / 64) = 1) or is_set(sums_right_tree_next_next_next_next_smallest_0, 6);
      if is_set(sums_right_relief_largest, 0) then
        sums_right_start_cost_0_choice := (not is_set(sums_right_room, 1)) or (not is_set(sums_right_room, 0));
      else
        sums_right_start_cost_0_choice := not is_set(sums_right_room, 1);
      end if;
      if is_set(sums_right_relief_largest, 1) then
        sums_right_start_cost_0_choices(2) := sums_right_start_cost_0_choice;
      else
        sums_right_start_cost_0_choices(2) := is_set(sums_right_relief_largest, 0) and ((sums_right_room mod 4) = 0);
      end if;
      sums_right_start_cost_0_value := is_set(sums_right_room, 2);
      if sums_right_start_cost_0_choices(2) then
        sums_right_start_cost_0_choices(3) := (not is_set(sums_right_relief_largest, 2)) and
          sums_right_start_cost_0_value;
      else
        sums_right_start_cost_0_choices(3) := (not is_set(sums_right_relief_largest, 2)) or
          sums_right_start_cost_0_value;
      end if;
      sums_right_start_cost_0_value_2 := is_set(sums_right_room, 3);
      if sums_right_start_cost_0_choices(3) then
        sums_right_start_cost_0_choices(4) := (not is_set(sums_right_relief_largest, 3)) or
          sums_right_start_cost_0_value_2;
      else
        sums_right_start_cost_0_choices(4) := (not is_set(sums_right_relief_largest, 3)) and
          sums_right_start_cost_0_value_2;
      end if;
      sums_right_start_cost_0_is_equal := (sums_right_room / 16) = 0;
      if is_set(sums_right_relief_largest, 4) then
        sums_right_start_cost_0_choices(5) := not is_set(sums_right_room, 5);
      else
        sums_right_start_cost_0_choices(5) := sums_right_start_cost_0_is_equal;
      end if;
      if sums_right_start_cost_0_choices(4) then
        sums_right_start_cost_0_choices(6) := is_set(sums_right_relief_largest, 4) and sums_right_start_cost_0_is_equal;
      else
        sums_right_start_cost_0_choices(6) := sums_right_start_cost_0_choices(5);
      end if;
      if sums_right_start_cost_0_choices(6) then
        sums_right_start_cost_0_choices_from_7(7) := 0;
      else
        sums_right_start_cost_0_choices_from_7(7) := (sums_right_room - sums_right_relief_largest) mod 64;
      end if;
      sums_right_start_cost_0_is_less := 127 < ((sums_right_tree_next_next_next_next_smallest_0 mod 64) +
        sums_right_relief_reach_of_best);
      if sums_right_start_cost_0_is_less then
        sums_right_start_cost_0_choices_from_7(8) := (sums_right_tree_next_next_next_next_smallest_0 +
          sums_right_relief_reach_of_best) mod 64;
      else
        sums_right_start_cost_0_choices_from_7(8) := 0;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_start_cost_0_choices_from_7(9) := sums_right_start_cost_0_choices_from_7(7);
      else
        sums_right_start_cost_0_choices_from_7(9) := sums_right_start_cost_0_choices_from_7(8);
      end if;
      sums_right_room_value := (sums_right_start_cost(8) + sums_right_room) mod 64;
      if sums_right_start_cost_0_choices(6) then
        sums_right_room_choice := sums_right_room_value;
      else
        sums_right_room_choice := (sums_right_start_cost(8) + sums_right_relief_largest) mod 64;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_room_choices(2) := (sums_right_relief_room_of_best - sums_right_tree_next_next_next_next_smallest_0)
          mod 64;
      else
        sums_right_room_choices(2) := sums_right_room_value;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_room_choices(3) := sums_right_room_choice;
      else
        sums_right_room_choices(3) := sums_right_room_choices(2);
      end if;
      if sums_turn_ready_first then
        sums_right_smallest_choice := 0;
      else
        sums_right_smallest_choice := sums_right_relief_next(0);
      end if;
      sums_right_smallest_difference := sums_right_smallest_choice - (sums_turn_ready_smallest_0 / 8);
      if (sums_right_smallest_choice - sums_right_relief_past(0)) < 0 then
        sums_right_relief_pairs_0_choice := sums_right_relief_past(0);
      else
        sums_right_relief_pairs_0_choice := sums_right_smallest_choice;
      end if;
      if (sums_right_relief_fours(0) - sums_right_relief_fours(2)) < 0 then
        sums_right_relief_older_choice := sums_right_relief_fours(2);
      else
        sums_right_relief_older_choice := sums_right_relief_fours(0);
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_smallest_choice) < 0 then
        sums_right_relief_recent_choice := sums_right_smallest_choice;
      else
        sums_right_relief_recent_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      if ((sums_turn_ready_smallest_0 / 8) - sums_right_relief_recent) < 0 then
        sums_right_relief_largest_choice := sums_right_relief_recent;
      else
        sums_right_relief_largest_choice := sums_turn_ready_smallest_0 / 8;
      end if;
      sums_right_relief_reach_of_best_sum := sums_right_room + sums_right_relief_leaves;
      if sums_right_start_cost_0_choices(6) then
        sums_right_relief_reach_of_best_choice := sums_right_relief_reach_of_best_sum;
      else
        sums_right_relief_reach_of_best_choice := sums_right_relief_largest + sums_right_relief_leaves;
      end if;
      if sums_right_start_cost_0_is_less then
        sums_right_relief_reach_of_best_choices(2) := (sums_right_relief_reach_again -
          (sums_right_tree_next_next_next_next_smallest_0 mod 64)) mod 256;
      else
        sums_right_relief_reach_of_best_choices(2) := sums_right_relief_reach_of_best_sum;
      end if;
      if sums_right_start_cost_0_any then
        sums_right_relief_reach_of_best_choices(3) := sums_right_relief_reach_of_best_choice;
      else
        sums_right_relief_reach_of_best_choices(3) := sums_right_relief_reach_of_best_choices(2);
      end if;
      if sums_turn_ready_first then
        sums_right_relief_leaves_choice := 64;
      else
        sums_right_relief_leaves_choice := sums_right_start_cost(7) + 64;
      end if;
      sums_right_g_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest) mod 128;
      sums_right_g_less_copy_0_value := (sums_right_start_cost(0) + sums_right_smallest_less) mod 128;
      for i in 0 to 63 loop
        if (sums_right_arrived(i) - sums_right_cost(i)) < 0 then
          sums_right_cost_choice(i) := sums_right_arrived(i);
        else
          sums_right_cost_choice(i) := sums_right_cost(i);
        end if;
        if is_set(sums_right_cost_choice(i), 6) or sums_tags_held_first_column(14) then
          sums_right_cost_choice_2(i) := 64;
        else
          sums_right_cost_choice_2(i) := sums_right_cost_choice(i);
        end if;
      end loop;
      if sums_tags_held_first_column(14) then
        sums_right_arrived_choice(0) := 64;
      else
        sums_right_arrived_choice(0) := sums_right_cost(1);
      end if;
      for i in 1 to 2 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2(i - 1) := 64;
        else
          sums_right_arrived_choice_2(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 5 to 6 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s(i - 1) := 64;
        else
          sums_right_arrived_choice_2s(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 9 to 10 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_11(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_11(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 13 to 14 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_15(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_15(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 17 to 18 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_19(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_19(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 21 to 22 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_23(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_23(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 25 to 26 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_27(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_27(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 29 to 30 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_31(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_31(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 33 to 34 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_35(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_35(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 37 to 38 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_39(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_39(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 41 to 42 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_43(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_43(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 45 to 46 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_47(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_47(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 49 to 50 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_51(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_51(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 53 to 54 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_55(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_55(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 57 to 58 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
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
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice_2s_from_59(i - 1) := 64;
        else
          sums_right_arrived_choice_2s_from_59(i - 1) := sums_right_arrived_choice(i - 1);
        end if;
      end loop;
      for i in 61 to 62 loop
        if sums_tags_held_first_column(14) then
          sums_right_arrived_choice(i) := 64;
        else
          sums_right_arrived_choice(i) := sums_right_pair_choice(i - 31);
        end if;
      end loop;
      if sums_tags_held_first_column(14) then
        sums_right_arrived_choice(63) := 64;
      else
        sums_right_arrived_choice(63) := sums_right_cost(62);
      end if;
      if entry_tag_valid then
        for i in 0 to 15 loop
          sums_turn_ready_sums(i) <= to_integer(sums_turn_read_sums(i));
        end loop;
        for i in 0 to 5 loop
          sums_turn_ready_costs(i) <= to_integer(sums_turn_read_costs(i));
        end loop;
        sums_turn_ready_costs_6 <= to_integer(sums_turn_read_costs_6);
        sums_turn_ready_smallest_0 <= to_integer(sums_turn_read_smallest_0);
        sums_turn_ready_first <= forward_first(10);
        sums_turn_place(0) <= entry_place;
        for i in 1 to 10 loop
          sums_turn_place(i) <= sums_turn_place(i - 1);
        end loop;
        sums_turn_waiting_first(0) <= entry_tag_first_column;
        for i in 1 to 5 loop
          sums_turn_waiting_first(i) <= sums_turn_waiting_first(i - 1);
        end loop;
        for i in 0 to 5 loop
          sums_cost(0, 10 * i) <= sums_turn_ready_costs(i) mod 8;
          sums_cost(0, 10 * i + 1) <= (sums_turn_ready_costs(i) mod 64) / 8;
          sums_cost(0, 10 * i + 2) <= (sums_turn_ready_costs(i) / 64) mod 8;
          sums_cost(0, 10 * i + 3) <= (sums_turn_ready_costs(i) / 512) mod 8;
          sums_cost(0, 10 * i + 4) <= (sums_turn_ready_costs(i) / 4096) mod 8;
          sums_cost(0, 10 * i + 5) <= (sums_turn_ready_costs(i) / 32768) mod 8;
          sums_cost(0, 10 * i + 6) <= (sums_turn_ready_costs(i) / 262144) mod 8;
          sums_cost(0, 10 * i + 7) <= (sums_turn_ready_costs(i) / 2097152) mod 8;
          sums_cost(0, 10 * i + 8) <= (sums_turn_ready_costs(i) / 16777216) mod 8;
          sums_cost(0, 10 * i + 9) <= sums_turn_ready_costs(i) / 134217728;
        end loop;
        sums_cost(0, 60) <= sums_turn_ready_costs_6 mod 8;
        sums_cost(0, 61) <= (sums_turn_ready_costs_6 mod 64) / 8;
        sums_cost(0, 62) <= (sums_turn_ready_costs_6 / 64) mod 8;
        sums_cost(0, 63) <= sums_turn_ready_costs_6 / 512;
        for i in 0 to 63 loop
          sums_cost(1, i) <= sums_cost(0, i);
        end loop;
        for i in 0 to 31 loop
          sums_right_pair(i) <= sums_right_pair_choice(i);
        end loop;
        sums_right_smallest <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8)) mod 128;
        sums_right_smallest_less <= (sums_right_smallest_difference + (sums_turn_ready_smallest_0 mod 8) + 119) mod 128;
        sums_right_first(0) <= sums_turn_ready_first;
        sums_right_first(1) <= sums_right_first(0);
        sums_right_first(2) <= sums_right_first(1);
        sums_right_relief_next(0) <= sums_turn_ready_smallest_0 / 8;
        sums_right_relief_next(1) <= sums_right_relief_next(0);
        sums_right_relief_next(2) <= sums_right_relief_next(1);
        sums_right_relief_next(3) <= sums_right_relief_next(2);
        sums_right_relief_past(0) <= sums_right_smallest_choice;
        for i in 1 to 7 loop
          sums_right_relief_past(i) <= sums_right_relief_past(i - 1);
        end loop;
        sums_right_relief_pairs(0) <= sums_right_relief_pairs_0_choice;
        sums_right_relief_pairs(1) <= sums_right_relief_pairs(0);
        sums_right_relief_fours(1) <= sums_right_relief_fours(0);
        sums_right_relief_fours(2) <= sums_right_relief_fours(1);
        sums_right_relief_largest <= sums_right_relief_largest_choice;
        sums_right_relief_beyond <= (sums_right_relief_largest_choice - sums_right_relief_past(7)) mod 32;
        sums_right_relief_leaves <= sums_right_relief_leaves_choice - sums_right_relief_past(6);
        sums_right_relief_room_of_best <= sums_right_relief_past(7) + sums_right_relief_leaves_choice;
        sums_right_relief_reach_again <= (64 - sums_right_relief_past(6)) + sums_right_relief_past(7) +
          sums_right_relief_leaves_choice;
        sums_right_g_copy(0) <= sums_right_g_copy_0_value;
        sums_right_g_copy(1) <= sums_right_g_copy_0_value;
        sums_right_g_copy(2) <= sums_right_g_copy_0_value;
        sums_right_g_copy(3) <= sums_right_g_copy_0_value;
        sums_right_g_less_copy(0) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(1) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(2) <= sums_right_g_less_copy_0_value;
        sums_right_g_less_copy(3) <= sums_right_g_less_copy_0_value;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            sums_right_stay_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_copy(2 * i + 1)) mod 128;
          end loop;
        end loop;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i)) mod 128;
          end loop;
          for j in 16 to 31 loop
            sums_right_step_change(32 * i + j) <= (sums_cost(1, 32 * i + j) - sums_right_g_less_copy(2 * i + 1)) mod
              128;
          end loop;
        end loop;
        for i in 0 to 63 loop
          sums_right_cost(i) <= (sums_right_cost_choice_2(i) + sums_right_stay_change(i)) mod 128;
        end loop;
        sums_right_arrived(0) <= (sums_right_arrived_choice(0) + sums_right_step_change(0)) mod 128;
        sums_right_arrived(1) <= (sums_right_arrived_choice(1) + sums_right_step_change(1)) mod 128;
        sums_right_arrived(2) <= (sums_right_arrived_choice(2) + sums_right_step_change(2)) mod 128;
        sums_right_arrived(3) <= (sums_right_arrived_choice_2(3) + sums_right_step_change(3)) mod 128;
        sums_right_arrived(4) <= (sums_right_arrived_choice_2(4) + sums_right_step_change(4)) mod 128;
        sums_right_arrived(5) <= (sums_right_arrived_choice(5) + sums_right_step_change(5)) mod 128;
        sums_right_arrived(6) <= (sums_right_arrived_choice(6) + sums_right_step_change(6)) mod 128;
        sums_right_arrived(7) <= (sums_right_arrived_choice_2s(7) + sums_right_step_change(7)) mod 128;
        sums_right_arrived(8) <= (sums_right_arrived_choice_2s(8) + sums_right_step_change(8)) mod 128;
        sums_right_arrived(9) <= (sums_right_arrived_choice(9) + sums_right_step_change(9)) mod 128;
        sums_right_arrived(10) <= (sums_right_arrived_choice(10) + sums_right_step_change(10)) mod 128;
        sums_right_arrived(11) <= (sums_right_arrived_choice_2s_from_11(11) + sums_right_step_change(11)) mod 128;
        sums_right_arrived(12) <= (sums_right_arrived_choice_2s_from_11(12) + sums_right_step_change(12)) mod 128;
        sums_right_arrived(13) <= (sums_right_arrived_choice(13) + sums_right_step_change(13)) mod 128;
        sums_right_arrived(14) <= (sums_right_arrived_choice(14) + sums_right_step_change(14)) mod 128;
        sums_right_arrived(15) <= (sums_right_arrived_choice_2s_from_15(15) + sums_right_step_change(15)) mod 128;
        sums_right_arrived(16) <= (sums_right_arrived_choice_2s_from_15(16) + sums_right_step_change(16)) mod 128;
        sums_right_arrived(17) <= (sums_right_arrived_choice(17) + sums_right_step_change(17)) mod 128;
        sums_right_arrived(18) <= (sums_right_arrived_choice(18) + sums_right_step_change(18)) mod 128;
        sums_right_arrived(19) <= (sums_right_arrived_choice_2s_from_19(19) + sums_right_step_change(19)) mod 128;
        sums_right_arrived(20) <= (sums_right_arrived_choice_2s_from_19(20) + sums_right_step_change(20)) mod 128;
        sums_right_arrived(21) <= (sums_right_arrived_choice(21) + sums_right_step_change(21)) mod 128;
        sums_right_arrived(22) <= (sums_right_arrived_choice(22) + sums_right_step_change(22)) mod 128;
        sums_right_arrived(23) <= (sums_right_arrived_choice_2s_from_23(23) + sums_right_step_change(23)) mod 128;
        sums_right_arrived(24) <= (sums_right_arrived_choice_2s_from_23(24) + sums_right_step_change(24)) mod 128;
        sums_right_arrived(25) <= (sums_right_arrived_choice(25) + sums_right_step_change(25)) mod 128;
        sums_right_arrived(26) <= (sums_right_arrived_choice(26) + sums_right_step_change(26)) mod 128;
        sums_right_arrived(27) <= (sums_right_arrived_choice_2s_from_27(27) + sums_right_step_change(27)) mod 128;
        sums_right_arrived(28) <= (sums_right_arrived_choice_2s_from_27(28) + sums_right_step_change(28)) mod 128;
        sums_right_arrived(29) <= (sums_right_arrived_choice(29) + sums_right_step_change(29)) mod 128;
        sums_right_arrived(30) <= (sums_right_arrived_choice(30) + sums_right_step_change(30)) mod 128;
        sums_right_arrived(31) <= (sums_right_arrived_choice_2s_from_31(31) + sums_right_step_change(31)) mod 128;
        sums_right_arrived(32) <= (sums_right_arrived_choice_2s_from_31(32) + sums_right_step_change(32)) mod 128;
        sums_right_arrived(33) <= (sums_right_arrived_choice(33) + sums_right_step_change(33)) mod 128;
        sums_right_arrived(34) <= (sums_right_arrived_choice(34) + sums_right_step_change(34)) mod 128;
        sums_right_arrived(35) <= (sums_right_arrived_choice_2s_from_35(35) + sums_right_step_change(35)) mod 128;
        sums_right_arrived(36) <= (sums_right_arrived_choice_2s_from_35(36) + sums_right_step_change(36)) mod 128;
        sums_right_arrived(37) <= (sums_right_arrived_choice(37) + sums_right_step_change(37)) mod 128;
        sums_right_arrived(38) <= (sums_right_arrived_choice(38) + sums_right_step_change(38)) mod 128;
        sums_right_arrived(39) <= (sums_right_arrived_choice_2s_from_39(39) + sums_right_step_change(39)) mod 128;
        sums_right_arrived(40) <= (sums_right_arrived_choice_2s_from_39(40) + sums_right_step_change(40)) mod 128;
        sums_right_arrived(41) <= (sums_right_arrived_choice(41) + sums_right_step_change(41)) mod 128;
        sums_right_arrived(42) <= (sums_right_arrived_choice(42) + sums_right_step_change(42)) mod 128;
        sums_right_arrived(43) <= (sums_right_arrived_choice_2s_from_43(43) + sums_right_step_change(43)) mod 128;
        sums_right_arrived(44) <= (sums_right_arrived_choice_2s_from_43(44) + sums_right_step_change(44)) mod 128;
        sums_right_arrived(45) <= (sums_right_arrived_choice(45) + sums_right_step_change(45)) mod 128;
        sums_right_arrived(46) <= (sums_right_arrived_choice(46) + sums_right_step_change(46)) mod 128;
        sums_right_arrived(47) <= (sums_right_arrived_choice_2s_from_47(47) + sums_right_step_change(47)) mod 128;
        sums_right_arrived(48) <= (sums_right_arrived_choice_2s_from_47(48) + sums_right_step_change(48)) mod 128;
        sums_right_arrived(49) <= (sums_right_arrived_choice(49) + sums_right_step_change(49)) mod 128;
        sums_right_arrived(50) <= (sums_right_arrived_choice(50) + sums_right_step_change(50)) mod 128;
        sums_right_arrived(51) <= (sums_right_arrived_choice_2s_from_51(51) + sums_right_step_change(51)) mod 128;
        sums_right_arrived(52) <= (sums_right_arrived_choice_2s_from_51(52) + sums_right_step_change(52)) mod 128;
        sums_right_arrived(53) <= (sums_right_arrived_choice(53) + sums_right_step_change(53)) mod 128;
        sums_right_arrived(54) <= (sums_right_arrived_choice(54) + sums_right_step_change(54)) mod 128;
        sums_right_arrived(55) <= (sums_right_arrived_choice_2s_from_55(55) + sums_right_step_change(55)) mod 128;
        sums_right_arrived(56) <= (sums_right_arrived_choice_2s_from_55(56) + sums_right_step_change(56)) mod 128;
        sums_right_arrived(57) <= (sums_right_arrived_choice(57) + sums_right_step_change(57)) mod 128;
        sums_right_arrived(58) <= (sums_right_arrived_choice(58) + sums_right_step_change(58)) mod 128;
        sums_right_arrived(59) <= (sums_right_arrived_choice_2s_from_59(59) + sums_right_step_change(59)) mod 128;
        sums_right_arrived(60) <= (sums_right_arrived_choice_2s_from_59(60) + sums_right_step_change(60)) mod 128;
        sums_right_arrived(61) <= (sums_right_arrived_choice(61) + sums_right_step_change(61)) mod 128;
        sums_right_arrived(62) <= (sums_right_arrived_choice(62) + sums_right_step_change(62)) mod 128;
        sums_right_arrived(63) <= (sums_right_arrived_choice(63) + sums_right_step_change(63)) mod 128;
        sums_sum_delay_ring_write_address <= sums_sum_delay_ring_read_address;
        sums_tags_held_output_column(0) <= entry_turned_output_column;
        sums_tags_held_start_of_frame(0) <= entry_turned_start_of_frame;
        sums_tags_held_end_of_line(0) <= entry_tag_end_of_line;
        for i in 1 to 11 loop
          sums_tags_held_output_column(i) <= sums_tags_held_output_column(i - 1);
          sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
          sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
        end loop;
        sums_tags_held_map_column(12) <= forward_above_comes(11);
        sums_tags_held_output_column(12) <= sums_tags_held_output_column(11);
        sums_tags_held_first_column(12) <= sums_turn_ready_first;
        for i in 12 to 13 loop
          sums_tags_held_start_of_frame(i) <= sums_tags_held_start_of_frame(i - 1);
          sums_tags_held_end_of_line(i) <= sums_tags_held_end_of_line(i - 1);
          sums_tags_held_map_column(i + 1) <= sums_tags_held_map_column(i);
          sums_tags_held_output_column(i + 1) <= sums_tags_held_output_column(i);
          sums_tags_held_first_column(i + 1) <= sums_tags_held_first_column(i);
        end loop;
        sums_tags_held_start_of_frame(14) <= sums_tags_held_start_of_frame(13);
        sums_tags_held_end_of_line(14) <= sums_tags_held_end_of_line(13);
        sums_tags_held_map_column(15) <= sums_tags_held_map_column(14);
        sums_tags_held_output_column(15) <= sums_tags_held_output_column(14);
        sums_tags_held_first_column(15) <= sums_right_first(2);
        sums_tags_held_start_of_frame(15) <= sums_tags_held_start_of_frame(14);
        sums_tags_held_end_of_line(15) <= sums_tags_held_end_of_line(14);
        for i in 0 to 15 loop
          if (sums_right_pair(2 * i + 1) - sums_right_pair(2 * i)) < 0 then
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i + 1);
          else
            sums_right_tree_smallest(i) <= sums_right_pair(2 * i);
          end if;
        end loop;
        for i in 0 to 7 loop
          if (sums_right_tree_smallest(2 * i + 1) - sums_right_tree_smallest(2 * i)) < 0 then
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i + 1);
          else
            sums_right_tree_next_smallest(i) <= sums_right_tree_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 3 loop
          if (sums_right_tree_next_smallest(2 * i + 1) - sums_right_tree_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_smallest(i) <= sums_right_tree_next_smallest(2 * i);
          end if;
        end loop;
        for i in 0 to 1 loop
          if (sums_right_tree_next_next_smallest(2 * i + 1) - sums_right_tree_next_next_smallest(2 * i)) < 0 then
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i + 1);
          else
            sums_right_tree_next_next_next_smallest(i) <= sums_right_tree_next_next_smallest(2 * i);
          end if;
        end loop;
        if (sums_right_tree_next_next_next_smallest(1) - sums_right_tree_next_next_next_smallest(0)) < 0 then
          sums_right_tree_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_smallest(1);
        else
          sums_right_tree_next_next_next_next_smallest_0 <= sums_right_tree_next_next_next_smallest(0);
        end if;
        if sums_turn_ready_first then
          sums_right_start_cost(0) <= 40;
          for i in 1 to 8 loop
            sums_right_start_cost(i) <= 0;
          end loop;
          sums_right_room <= 0;
          sums_right_relief_reach_of_best <= 0;
        else
          sums_right_start_cost(0) <= sums_right_start_cost_0_choices_from_7(9);
          for i in 1 to 8 loop
            sums_right_start_cost(i) <= sums_right_start_cost(i - 1);
          end loop;
          sums_right_room <= sums_right_room_choices(3);
          sums_right_relief_reach_of_best <= sums_right_relief_reach_of_best_choices(3);
        end if;
        if (sums_right_relief_pairs_0_choice - sums_right_relief_pairs(1)) < 0 then
          sums_right_relief_fours(0) <= sums_right_relief_pairs(1);
        else
          sums_right_relief_fours(0) <= sums_right_relief_pairs_0_choice;
        end if;
        if (sums_right_smallest_choice - sums_right_relief_older_choice) < 0 then
          sums_right_relief_older <= sums_right_relief_older_choice;
        else
          sums_right_relief_older <= sums_right_smallest_choice;
        end if;
        if (sums_right_relief_recent_choice - sums_right_relief_older) < 0 then
          sums_right_relief_recent <= sums_right_relief_older;
        else
          sums_right_relief_recent <= sums_right_relief_recent_choice;
        end if;
        if sums_sum_delay_ring_read_address = 3 then
          sums_sum_delay_ring_read_address <= 0;
        else
          sums_sum_delay_ring_read_address <= (sums_sum_delay_ring_read_address + 1) mod 4;
        end if;
      end if;
      if entry_tag_valid then
        sums_turn_writes_copy_0_choice := forward_above_comes(9);
      else
        sums_turn_writes_copy_0_choice := forward_above_comes(10);
      end if;
      if entry_tag_valid then
        sums_turn_waiting_read_place_choice := sums_turn_place(8);
      else
        sums_turn_waiting_read_place_choice := sums_turn_place(9);
      end if;
      if entry_tag_valid then
        sums_turn_waiting_read_place_choice_2 := sums_turn_place(9);
      else
        sums_turn_waiting_read_place_choice_2 := sums_turn_place(10);
      end if;
      sums_turn_writes_copy_0 <= entry_next_tag_valid and sums_turn_writes_copy_0_choice;
      for i in 0 to 7 loop
        for j in 0 to 3 loop
          sums_sum_0(8 * i + j) <= ((sums_right_cost(8 * i + j) + to_integer(sums_sum_delay_held(2 * i)(7 * j + 6
            downto 7 * j))) - sums_right_relief_next(3)) mod 256;
        end loop;
        for j in 4 to 7 loop
          sums_sum_0(8 * i + j) <= ((sums_right_cost(8 * i + j) + to_integer(sums_sum_delay_held(2 * i + 1)(7 * j - 22
            downto 7 * j - 28))) - sums_right_relief_next(3)) mod 256;
        end loop;
      end loop;
      sums_tag_valid <= sums_tags_moved;
      sums_tag_map_column <= sums_tags_held_map_column(15);
      sums_tag_output_column <= sums_tags_held_output_column(15);
      sums_tag_first_column <= sums_tags_held_first_column(15);
      sums_tag_start_of_frame <= sums_tags_held_start_of_frame(15);
      sums_tag_end_of_line <= sums_tags_held_end_of_line(15);
      sums_tags_moved <= entry_tag_valid;
      if entry_next_tag_valid then
        sums_turn_waiting_read_place <= sums_turn_waiting_read_place_choice;
      else
        sums_turn_waiting_read_place <= sums_turn_waiting_read_place_choice_2;
      end if;
      if sums_turn_writes_copy_0 then
        for i in 0 to 15 loop
          sums_turn_write_sums(i) <= (forward_sum(4 * i + 2) * 16384) + (forward_sum(4 * i + 3) * 2097152) +
            forward_sum(4 * i) + (forward_sum(4 * i + 1) * 128);
        end loop;
        for i in 0 to 5 loop
          sums_turn_write_costs(i) <= (forward_cost(3, 10 * i + 8) * 16777216) + (forward_cost(3, 10 * i + 9) *
            134217728) + (forward_cost(3, 10 * i + 7) * 2097152) + (forward_cost(3, 10 * i + 6) * 262144) +
            (forward_cost(3, 10 * i + 5) * 32768) + (forward_cost(3, 10 * i + 4) * 4096) + (forward_cost(3, 10 * i + 3)
            * 512) + (forward_cost(3, 10 * i + 2) * 64) + forward_cost(3, 10 * i) + (forward_cost(3, 10 * i + 1) * 8);
        end loop;
        sums_turn_write_costs_6 <= (forward_cost(3, 62) * 64) + (forward_cost(3, 63) * 512) + forward_cost(3, 60) +
          (forward_cost(3, 61) * 8);
        sums_turn_write_smallest_0 <= to_integer(((to_unsigned(forward_reliefs_moved(10), 5) & to_unsigned(0, 3)) or
          (to_unsigned(forward_smallest_cost(4), 8))));
        sums_turn_write_place <= sums_turn_place(10);
      end if;
      -- winnersmask
      if sums_tags_moved then
        for i in 0 to 62 loop
          winnersmask_inside(i) <= sums_tags_held_first_column(15) or winnersmask_inside(i + 1);
        end loop;
        if sums_tags_held_first_column(15) then
          winnersmask_column <= 0;
        else
          winnersmask_column <= (winnersmask_column + 1) mod 512;
        end if;
      end if;
      if sums_tags_moved then
        winnersmask_inside_63_choice := sums_tags_held_first_column(15);
      else
        winnersmask_inside_63_choice := winnersmask_inside(63);
      end if;
      if winnersmask_column < 384 then
        winnersmask_inside(63) <= sums_tags_moved or winnersmask_inside(63);
      else
        winnersmask_inside(63) <= winnersmask_inside_63_choice;
      end if;
      -- winnersother
      winnersother_cost_0_1_is_equal := (sums_sum_0(1) mod 4) = 0;
      if is_set(winnersother_cost_0(2), 0) then
        winnersother_cost_0_choice(1) := not is_set(sums_sum_0(1), 1);
      else
        winnersother_cost_0_choice(1) := winnersother_cost_0_1_is_equal;
      end if;
      if is_set(winnersother_cost_0(2), 1) then
        winnersother_cost_0_choices(1, 2) := is_set(winnersother_cost_0(2), 0) or (not is_set(sums_sum_0(1), 1)) or
          (not is_set(sums_sum_0(1), 0));
      else
        winnersother_cost_0_choices(1, 2) := winnersother_cost_0_choice(1);
      end if;
      winnersother_cost_0_value(1) := is_set(sums_sum_0(1), 2);
      if winnersother_cost_0_choices(1, 2) then
        winnersother_cost_0_choices(1, 3) := (not is_set(winnersother_cost_0(2), 2)) and winnersother_cost_0_value(1);
      else
        winnersother_cost_0_choices(1, 3) := (not is_set(winnersother_cost_0(2), 2)) or winnersother_cost_0_value(1);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(1, i) := is_set(sums_sum_0(1), i + 1);
        if winnersother_cost_0_choices(1, i + 1) then
          winnersother_cost_0_choices(1, i + 2) := (not is_set(winnersother_cost_0(2), i + 1)) or
            winnersother_cost_0_values(1, i);
        else
          winnersother_cost_0_choices(1, i + 2) := (not is_set(winnersother_cost_0(2), i + 1)) and
            winnersother_cost_0_values(1, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(2), 7) then
        winnersother_cost_0_choices(1, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(1), 7);
      else
        winnersother_cost_0_choices(1, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(1, 7) then
        winnersother_cost_0_choices(1, 9) := winnersother_cost_0_choices(1, 8);
      else
        winnersother_cost_0_choices(1, 9) := (not is_set(winnersother_cost_0(2), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(1), 7);
      end if;
      winnersother_cost_0_all(1) := (not winnersother_cost_0_choices(1, 9)) and winnersmask_inside(1) and
        sums_tag_output_column;
      winnersother_cost_0_value(2) := is_set(sums_sum_0(2), 1);
      if is_set(winnersother_cost_0(3), 0) then
        winnersother_cost_0_choice(2) := not winnersother_cost_0_value(2);
      else
        winnersother_cost_0_choice(2) := (sums_sum_0(2) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(3), 1) then
        winnersother_cost_0_choices(2, 2) := is_set(winnersother_cost_0(3), 0) or (not winnersother_cost_0_value(2)) or
          (not is_set(sums_sum_0(2), 0));
      else
        winnersother_cost_0_choices(2, 2) := winnersother_cost_0_choice(2);
      end if;
      winnersother_cost_0_values(2, 2) := is_set(sums_sum_0(2), 2);
      if winnersother_cost_0_choices(2, 2) then
        winnersother_cost_0_choices(2, 3) := (not is_set(winnersother_cost_0(3), 2)) and winnersother_cost_0_values(2,
          2);
      else
        winnersother_cost_0_choices(2, 3) := (not is_set(winnersother_cost_0(3), 2)) or winnersother_cost_0_values(2,
          2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(2, i) := is_set(sums_sum_0(2), i);
        if winnersother_cost_0_choices(2, i) then
          winnersother_cost_0_choices(2, i + 1) := (not is_set(winnersother_cost_0(3), i)) or
            winnersother_cost_0_values(2, i);
        else
          winnersother_cost_0_choices(2, i + 1) := (not is_set(winnersother_cost_0(3), i)) and
            winnersother_cost_0_values(2, i);
        end if;
      end loop;
      winnersother_cost_0_2_value_6 := is_set(sums_sum_0(2), 6);
      if winnersother_cost_0_choices(2, 6) then
        winnersother_cost_0_choices(2, 7) := (not is_set(winnersother_cost_0(3), 6)) or winnersother_cost_0_2_value_6;
      else
        winnersother_cost_0_choices(2, 7) := (not is_set(winnersother_cost_0(3), 6)) and winnersother_cost_0_2_value_6;
      end if;
      if is_set(winnersother_cost_0(3), 7) then
        winnersother_cost_0_choices(2, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(2), 7);
      else
        winnersother_cost_0_choices(2, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(2, 7) then
        winnersother_cost_0_choices(2, 9) := winnersother_cost_0_choices(2, 8);
      else
        winnersother_cost_0_choices(2, 9) := (not is_set(winnersother_cost_0(3), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(2), 7);
      end if;
      winnersother_cost_0_all(2) := (not winnersother_cost_0_choices(2, 9)) and winnersmask_inside(2) and
        sums_tag_output_column;
      winnersother_cost_0_3_is_equal := (sums_sum_0(3) mod 4) = 0;
      if is_set(winnersother_cost_0(4), 0) then
        winnersother_cost_0_choice(3) := not is_set(sums_sum_0(3), 1);
      else
        winnersother_cost_0_choice(3) := winnersother_cost_0_3_is_equal;
      end if;
      if is_set(winnersother_cost_0(4), 1) then
        winnersother_cost_0_choices(3, 2) := is_set(winnersother_cost_0(4), 0) or (not is_set(sums_sum_0(3), 1)) or
          (not is_set(sums_sum_0(3), 0));
      else
        winnersother_cost_0_choices(3, 2) := winnersother_cost_0_choice(3);
      end if;
      winnersother_cost_0_value(3) := is_set(sums_sum_0(3), 2);
      if winnersother_cost_0_choices(3, 2) then
        winnersother_cost_0_choices(3, 3) := (not is_set(winnersother_cost_0(4), 2)) and winnersother_cost_0_value(3);
      else
        winnersother_cost_0_choices(3, 3) := (not is_set(winnersother_cost_0(4), 2)) or winnersother_cost_0_value(3);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(3, i) := is_set(sums_sum_0(3), i + 1);
        if winnersother_cost_0_choices(3, i + 1) then
          winnersother_cost_0_choices(3, i + 2) := (not is_set(winnersother_cost_0(4), i + 1)) or
            winnersother_cost_0_values(3, i);
        else
          winnersother_cost_0_choices(3, i + 2) := (not is_set(winnersother_cost_0(4), i + 1)) and
            winnersother_cost_0_values(3, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(4), 7) then
        winnersother_cost_0_choices(3, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(3), 7);
      else
        winnersother_cost_0_choices(3, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(3, 7) then
        winnersother_cost_0_choices(3, 9) := winnersother_cost_0_choices(3, 8);
      else
        winnersother_cost_0_choices(3, 9) := (not is_set(winnersother_cost_0(4), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(3), 7);
      end if;
      winnersother_cost_0_all(3) := (not winnersother_cost_0_choices(3, 9)) and winnersmask_inside(3) and
        sums_tag_output_column;
      winnersother_cost_0_value(4) := is_set(sums_sum_0(4), 1);
      if is_set(winnersother_cost_0(5), 0) then
        winnersother_cost_0_choice(4) := not winnersother_cost_0_value(4);
      else
        winnersother_cost_0_choice(4) := (sums_sum_0(4) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(5), 1) then
        winnersother_cost_0_choices(4, 2) := is_set(winnersother_cost_0(5), 0) or (not winnersother_cost_0_value(4)) or
          (not is_set(sums_sum_0(4), 0));
      else
        winnersother_cost_0_choices(4, 2) := winnersother_cost_0_choice(4);
      end if;
      winnersother_cost_0_values(4, 2) := is_set(sums_sum_0(4), 2);
      if winnersother_cost_0_choices(4, 2) then
        winnersother_cost_0_choices(4, 3) := (not is_set(winnersother_cost_0(5), 2)) and winnersother_cost_0_values(4,
          2);
      else
        winnersother_cost_0_choices(4, 3) := (not is_set(winnersother_cost_0(5), 2)) or winnersother_cost_0_values(4,
          2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(4, i) := is_set(sums_sum_0(4), i);
        if winnersother_cost_0_choices(4, i) then
          winnersother_cost_0_choices(4, i + 1) := (not is_set(winnersother_cost_0(5), i)) or
            winnersother_cost_0_values(4, i);
        else
          winnersother_cost_0_choices(4, i + 1) := (not is_set(winnersother_cost_0(5), i)) and
            winnersother_cost_0_values(4, i);
        end if;
      end loop;
      winnersother_cost_0_4_value_6 := is_set(sums_sum_0(4), 6);
      if winnersother_cost_0_choices(4, 6) then
        winnersother_cost_0_choices(4, 7) := (not is_set(winnersother_cost_0(5), 6)) or winnersother_cost_0_4_value_6;
      else
        winnersother_cost_0_choices(4, 7) := (not is_set(winnersother_cost_0(5), 6)) and winnersother_cost_0_4_value_6;
      end if;
      if is_set(winnersother_cost_0(5), 7) then
        winnersother_cost_0_choices(4, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(4), 7);
      else
        winnersother_cost_0_choices(4, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(4, 7) then
        winnersother_cost_0_choices(4, 9) := winnersother_cost_0_choices(4, 8);
      else
        winnersother_cost_0_choices(4, 9) := (not is_set(winnersother_cost_0(5), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(4), 7);
      end if;
      winnersother_cost_0_all(4) := (not winnersother_cost_0_choices(4, 9)) and winnersmask_inside(4) and
        sums_tag_output_column;
      winnersother_cost_0_5_is_equal := (sums_sum_0(5) mod 4) = 0;
      if is_set(winnersother_cost_0(6), 0) then
        winnersother_cost_0_choice(5) := not is_set(sums_sum_0(5), 1);
      else
        winnersother_cost_0_choice(5) := winnersother_cost_0_5_is_equal;
      end if;
      if is_set(winnersother_cost_0(6), 1) then
        winnersother_cost_0_choices(5, 2) := is_set(winnersother_cost_0(6), 0) or (not is_set(sums_sum_0(5), 1)) or
          (not is_set(sums_sum_0(5), 0));
      else
        winnersother_cost_0_choices(5, 2) := winnersother_cost_0_choice(5);
      end if;
      winnersother_cost_0_value(5) := is_set(sums_sum_0(5), 2);
      if winnersother_cost_0_choices(5, 2) then
        winnersother_cost_0_choices(5, 3) := (not is_set(winnersother_cost_0(6), 2)) and winnersother_cost_0_value(5);
      else
        winnersother_cost_0_choices(5, 3) := (not is_set(winnersother_cost_0(6), 2)) or winnersother_cost_0_value(5);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(5, i) := is_set(sums_sum_0(5), i + 1);
        if winnersother_cost_0_choices(5, i + 1) then
          winnersother_cost_0_choices(5, i + 2) := (not is_set(winnersother_cost_0(6), i + 1)) or
            winnersother_cost_0_values(5, i);
        else
          winnersother_cost_0_choices(5, i + 2) := (not is_set(winnersother_cost_0(6), i + 1)) and
            winnersother_cost_0_values(5, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(6), 7) then
        winnersother_cost_0_choices(5, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(5), 7);
      else
        winnersother_cost_0_choices(5, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(5, 7) then
        winnersother_cost_0_choices(5, 9) := winnersother_cost_0_choices(5, 8);
      else
        winnersother_cost_0_choices(5, 9) := (not is_set(winnersother_cost_0(6), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(5), 7);
      end if;
      winnersother_cost_0_all(5) := (not winnersother_cost_0_choices(5, 9)) and winnersmask_inside(5) and
        sums_tag_output_column;
      winnersother_cost_0_value(6) := is_set(sums_sum_0(6), 1);
      if is_set(winnersother_cost_0(7), 0) then
        winnersother_cost_0_choice(6) := not winnersother_cost_0_value(6);
      else
        winnersother_cost_0_choice(6) := (sums_sum_0(6) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(7), 1) then
        winnersother_cost_0_choices(6, 2) := is_set(winnersother_cost_0(7), 0) or (not winnersother_cost_0_value(6)) or
          (not is_set(sums_sum_0(6), 0));
      else
        winnersother_cost_0_choices(6, 2) := winnersother_cost_0_choice(6);
      end if;
      winnersother_cost_0_values(6, 2) := is_set(sums_sum_0(6), 2);
      if winnersother_cost_0_choices(6, 2) then
        winnersother_cost_0_choices(6, 3) := (not is_set(winnersother_cost_0(7), 2)) and winnersother_cost_0_values(6,
          2);
      else
        winnersother_cost_0_choices(6, 3) := (not is_set(winnersother_cost_0(7), 2)) or winnersother_cost_0_values(6,
          2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(6, i) := is_set(sums_sum_0(6), i);
        if winnersother_cost_0_choices(6, i) then
          winnersother_cost_0_choices(6, i + 1) := (not is_set(winnersother_cost_0(7), i)) or
            winnersother_cost_0_values(6, i);
        else
          winnersother_cost_0_choices(6, i + 1) := (not is_set(winnersother_cost_0(7), i)) and
            winnersother_cost_0_values(6, i);
        end if;
      end loop;
      winnersother_cost_0_6_value_6 := is_set(sums_sum_0(6), 6);
      if winnersother_cost_0_choices(6, 6) then
        winnersother_cost_0_choices(6, 7) := (not is_set(winnersother_cost_0(7), 6)) or winnersother_cost_0_6_value_6;
      else
        winnersother_cost_0_choices(6, 7) := (not is_set(winnersother_cost_0(7), 6)) and winnersother_cost_0_6_value_6;
      end if;
      if is_set(winnersother_cost_0(7), 7) then
        winnersother_cost_0_choices(6, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(6), 7);
      else
        winnersother_cost_0_choices(6, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(6, 7) then
        winnersother_cost_0_choices(6, 9) := winnersother_cost_0_choices(6, 8);
      else
        winnersother_cost_0_choices(6, 9) := (not is_set(winnersother_cost_0(7), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(6), 7);
      end if;
      winnersother_cost_0_all(6) := (not winnersother_cost_0_choices(6, 9)) and winnersmask_inside(6) and
        sums_tag_output_column;
      winnersother_cost_0_7_is_equal := (sums_sum_0(7) mod 4) = 0;
      if is_set(winnersother_cost_0(8), 0) then
        winnersother_cost_0_choice(7) := not is_set(sums_sum_0(7), 1);
      else
        winnersother_cost_0_choice(7) := winnersother_cost_0_7_is_equal;
      end if;
      if is_set(winnersother_cost_0(8), 1) then
        winnersother_cost_0_choices(7, 2) := is_set(winnersother_cost_0(8), 0) or (not is_set(sums_sum_0(7), 1)) or
          (not is_set(sums_sum_0(7), 0));
      else
        winnersother_cost_0_choices(7, 2) := winnersother_cost_0_choice(7);
      end if;
      winnersother_cost_0_value(7) := is_set(sums_sum_0(7), 2);
      if winnersother_cost_0_choices(7, 2) then
        winnersother_cost_0_choices(7, 3) := (not is_set(winnersother_cost_0(8), 2)) and winnersother_cost_0_value(7);
      else
        winnersother_cost_0_choices(7, 3) := (not is_set(winnersother_cost_0(8), 2)) or winnersother_cost_0_value(7);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(7, i) := is_set(sums_sum_0(7), i + 1);
        if winnersother_cost_0_choices(7, i + 1) then
          winnersother_cost_0_choices(7, i + 2) := (not is_set(winnersother_cost_0(8), i + 1)) or
            winnersother_cost_0_values(7, i);
        else
          winnersother_cost_0_choices(7, i + 2) := (not is_set(winnersother_cost_0(8), i + 1)) and
            winnersother_cost_0_values(7, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(8), 7) then
        winnersother_cost_0_choices(7, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(7), 7);
      else
        winnersother_cost_0_choices(7, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(7, 7) then
        winnersother_cost_0_choices(7, 9) := winnersother_cost_0_choices(7, 8);
      else
        winnersother_cost_0_choices(7, 9) := (not is_set(winnersother_cost_0(8), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(7), 7);
      end if;
      winnersother_cost_0_all(7) := (not winnersother_cost_0_choices(7, 9)) and winnersmask_inside(7) and
        sums_tag_output_column;
      winnersother_cost_0_value(8) := is_set(sums_sum_0(8), 1);
      if is_set(winnersother_cost_0(9), 0) then
        winnersother_cost_0_choice(8) := not winnersother_cost_0_value(8);
      else
        winnersother_cost_0_choice(8) := (sums_sum_0(8) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(9), 1) then
        winnersother_cost_0_choices(8, 2) := is_set(winnersother_cost_0(9), 0) or (not winnersother_cost_0_value(8)) or
          (not is_set(sums_sum_0(8), 0));
      else
        winnersother_cost_0_choices(8, 2) := winnersother_cost_0_choice(8);
      end if;
      winnersother_cost_0_values(8, 2) := is_set(sums_sum_0(8), 2);
      if winnersother_cost_0_choices(8, 2) then
        winnersother_cost_0_choices(8, 3) := (not is_set(winnersother_cost_0(9), 2)) and winnersother_cost_0_values(8,
          2);
      else
        winnersother_cost_0_choices(8, 3) := (not is_set(winnersother_cost_0(9), 2)) or winnersother_cost_0_values(8,
          2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(8, i) := is_set(sums_sum_0(8), i);
        if winnersother_cost_0_choices(8, i) then
          winnersother_cost_0_choices(8, i + 1) := (not is_set(winnersother_cost_0(9), i)) or
            winnersother_cost_0_values(8, i);
        else
          winnersother_cost_0_choices(8, i + 1) := (not is_set(winnersother_cost_0(9), i)) and
            winnersother_cost_0_values(8, i);
        end if;
      end loop;
      winnersother_cost_0_8_value_6 := is_set(sums_sum_0(8), 6);
      if winnersother_cost_0_choices(8, 6) then
        winnersother_cost_0_choices(8, 7) := (not is_set(winnersother_cost_0(9), 6)) or winnersother_cost_0_8_value_6;
      else
        winnersother_cost_0_choices(8, 7) := (not is_set(winnersother_cost_0(9), 6)) and winnersother_cost_0_8_value_6;
      end if;
      if is_set(winnersother_cost_0(9), 7) then
        winnersother_cost_0_choices(8, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(8), 7);
      else
        winnersother_cost_0_choices(8, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(8, 7) then
        winnersother_cost_0_choices(8, 9) := winnersother_cost_0_choices(8, 8);
      else
        winnersother_cost_0_choices(8, 9) := (not is_set(winnersother_cost_0(9), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(8), 7);
      end if;
      winnersother_cost_0_all(8) := (not winnersother_cost_0_choices(8, 9)) and winnersmask_inside(8) and
        sums_tag_output_column;
      winnersother_cost_0_9_is_equal := (sums_sum_0(9) mod 4) = 0;
      if is_set(winnersother_cost_0(10), 0) then
        winnersother_cost_0_choice(9) := not is_set(sums_sum_0(9), 1);
      else
        winnersother_cost_0_choice(9) := winnersother_cost_0_9_is_equal;
      end if;
      if is_set(winnersother_cost_0(10), 1) then
        winnersother_cost_0_choices(9, 2) := is_set(winnersother_cost_0(10), 0) or (not is_set(sums_sum_0(9), 1)) or
          (not is_set(sums_sum_0(9), 0));
      else
        winnersother_cost_0_choices(9, 2) := winnersother_cost_0_choice(9);
      end if;
      winnersother_cost_0_value(9) := is_set(sums_sum_0(9), 2);
      if winnersother_cost_0_choices(9, 2) then
        winnersother_cost_0_choices(9, 3) := (not is_set(winnersother_cost_0(10), 2)) and winnersother_cost_0_value(9);
      else
        winnersother_cost_0_choices(9, 3) := (not is_set(winnersother_cost_0(10), 2)) or winnersother_cost_0_value(9);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(9, i) := is_set(sums_sum_0(9), i + 1);
        if winnersother_cost_0_choices(9, i + 1) then
          winnersother_cost_0_choices(9, i + 2) := (not is_set(winnersother_cost_0(10), i + 1)) or
            winnersother_cost_0_values(9, i);
        else
          winnersother_cost_0_choices(9, i + 2) := (not is_set(winnersother_cost_0(10), i + 1)) and
            winnersother_cost_0_values(9, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(10), 7) then
        winnersother_cost_0_choices(9, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(9), 7);
      else
        winnersother_cost_0_choices(9, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(9, 7) then
        winnersother_cost_0_choices(9, 9) := winnersother_cost_0_choices(9, 8);
      else
        winnersother_cost_0_choices(9, 9) := (not is_set(winnersother_cost_0(10), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(9), 7);
      end if;
      winnersother_cost_0_all(9) := (not winnersother_cost_0_choices(9, 9)) and winnersmask_inside(9) and
        sums_tag_output_column;
      winnersother_cost_0_value(10) := is_set(sums_sum_0(10), 1);
      if is_set(winnersother_cost_0(11), 0) then
        winnersother_cost_0_choice(10) := not winnersother_cost_0_value(10);
      else
        winnersother_cost_0_choice(10) := (sums_sum_0(10) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(11), 1) then
        winnersother_cost_0_choices(10, 2) := is_set(winnersother_cost_0(11), 0) or (not winnersother_cost_0_value(10))
          or (not is_set(sums_sum_0(10), 0));
      else
        winnersother_cost_0_choices(10, 2) := winnersother_cost_0_choice(10);
      end if;
      winnersother_cost_0_values(10, 2) := is_set(sums_sum_0(10), 2);
      if winnersother_cost_0_choices(10, 2) then
        winnersother_cost_0_choices(10, 3) := (not is_set(winnersother_cost_0(11), 2)) and
          winnersother_cost_0_values(10, 2);
      else
        winnersother_cost_0_choices(10, 3) := (not is_set(winnersother_cost_0(11), 2)) or
          winnersother_cost_0_values(10, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(10, i) := is_set(sums_sum_0(10), i);
        if winnersother_cost_0_choices(10, i) then
          winnersother_cost_0_choices(10, i + 1) := (not is_set(winnersother_cost_0(11), i)) or
            winnersother_cost_0_values(10, i);
        else
          winnersother_cost_0_choices(10, i + 1) := (not is_set(winnersother_cost_0(11), i)) and
            winnersother_cost_0_values(10, i);
        end if;
      end loop;
      winnersother_cost_0_10_value_6 := is_set(sums_sum_0(10), 6);
      if winnersother_cost_0_choices(10, 6) then
        winnersother_cost_0_choices(10, 7) := (not is_set(winnersother_cost_0(11), 6)) or
          winnersother_cost_0_10_value_6;
      else
        winnersother_cost_0_choices(10, 7) := (not is_set(winnersother_cost_0(11), 6)) and
          winnersother_cost_0_10_value_6;
      end if;
      if is_set(winnersother_cost_0(11), 7) then
        winnersother_cost_0_choices(10, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(10), 7);
      else
        winnersother_cost_0_choices(10, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(10, 7) then
        winnersother_cost_0_choices(10, 9) := winnersother_cost_0_choices(10, 8);
      else
        winnersother_cost_0_choices(10, 9) := (not is_set(winnersother_cost_0(11), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(10), 7);
      end if;
      winnersother_cost_0_all(10) := (not winnersother_cost_0_choices(10, 9)) and winnersmask_inside(10) and
        sums_tag_output_column;
      winnersother_cost_0_11_is_equal := (sums_sum_0(11) mod 4) = 0;
      if is_set(winnersother_cost_0(12), 0) then
        winnersother_cost_0_choice(11) := not is_set(sums_sum_0(11), 1);
      else
        winnersother_cost_0_choice(11) := winnersother_cost_0_11_is_equal;
      end if;
      if is_set(winnersother_cost_0(12), 1) then
        winnersother_cost_0_choices(11, 2) := is_set(winnersother_cost_0(12), 0) or (not is_set(sums_sum_0(11), 1)) or
          (not is_set(sums_sum_0(11), 0));
      else
        winnersother_cost_0_choices(11, 2) := winnersother_cost_0_choice(11);
      end if;
      winnersother_cost_0_value(11) := is_set(sums_sum_0(11), 2);
      if winnersother_cost_0_choices(11, 2) then
        winnersother_cost_0_choices(11, 3) := (not is_set(winnersother_cost_0(12), 2)) and
          winnersother_cost_0_value(11);
      else
        winnersother_cost_0_choices(11, 3) := (not is_set(winnersother_cost_0(12), 2)) or winnersother_cost_0_value(11);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(11, i) := is_set(sums_sum_0(11), i + 1);
        if winnersother_cost_0_choices(11, i + 1) then
          winnersother_cost_0_choices(11, i + 2) := (not is_set(winnersother_cost_0(12), i + 1)) or
            winnersother_cost_0_values(11, i);
        else
          winnersother_cost_0_choices(11, i + 2) := (not is_set(winnersother_cost_0(12), i + 1)) and
            winnersother_cost_0_values(11, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(12), 7) then
        winnersother_cost_0_choices(11, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(11), 7);
      else
        winnersother_cost_0_choices(11, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(11, 7) then
        winnersother_cost_0_choices(11, 9) := winnersother_cost_0_choices(11, 8);
      else
        winnersother_cost_0_choices(11, 9) := (not is_set(winnersother_cost_0(12), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(11), 7);
      end if;
      winnersother_cost_0_all(11) := (not winnersother_cost_0_choices(11, 9)) and winnersmask_inside(11) and
        sums_tag_output_column;
      winnersother_cost_0_value(12) := is_set(sums_sum_0(12), 1);
      if is_set(winnersother_cost_0(13), 0) then
        winnersother_cost_0_choice(12) := not winnersother_cost_0_value(12);
      else
        winnersother_cost_0_choice(12) := (sums_sum_0(12) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(13), 1) then
        winnersother_cost_0_choices(12, 2) := is_set(winnersother_cost_0(13), 0) or (not winnersother_cost_0_value(12))
          or (not is_set(sums_sum_0(12), 0));
      else
        winnersother_cost_0_choices(12, 2) := winnersother_cost_0_choice(12);
      end if;
      winnersother_cost_0_values(12, 2) := is_set(sums_sum_0(12), 2);
      if winnersother_cost_0_choices(12, 2) then
        winnersother_cost_0_choices(12, 3) := (not is_set(winnersother_cost_0(13), 2)) and
          winnersother_cost_0_values(12, 2);
      else
        winnersother_cost_0_choices(12, 3) := (not is_set(winnersother_cost_0(13), 2)) or
          winnersother_cost_0_values(12, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(12, i) := is_set(sums_sum_0(12), i);
        if winnersother_cost_0_choices(12, i) then
          winnersother_cost_0_choices(12, i + 1) := (not is_set(winnersother_cost_0(13), i)) or
            winnersother_cost_0_values(12, i);
        else
          winnersother_cost_0_choices(12, i + 1) := (not is_set(winnersother_cost_0(13), i)) and
            winnersother_cost_0_values(12, i);
        end if;
      end loop;
      winnersother_cost_0_12_value_6 := is_set(sums_sum_0(12), 6);
      if winnersother_cost_0_choices(12, 6) then
        winnersother_cost_0_choices(12, 7) := (not is_set(winnersother_cost_0(13), 6)) or
          winnersother_cost_0_12_value_6;
      else
        winnersother_cost_0_choices(12, 7) := (not is_set(winnersother_cost_0(13), 6)) and
          winnersother_cost_0_12_value_6;
      end if;
      if is_set(winnersother_cost_0(13), 7) then
        winnersother_cost_0_choices(12, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(12), 7);
      else
        winnersother_cost_0_choices(12, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(12, 7) then
        winnersother_cost_0_choices(12, 9) := winnersother_cost_0_choices(12, 8);
      else
        winnersother_cost_0_choices(12, 9) := (not is_set(winnersother_cost_0(13), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(12), 7);
      end if;
      winnersother_cost_0_all(12) := (not winnersother_cost_0_choices(12, 9)) and winnersmask_inside(12) and
        sums_tag_output_column;
      winnersother_cost_0_13_is_equal := (sums_sum_0(13) mod 4) = 0;
      if is_set(winnersother_cost_0(14), 0) then
        winnersother_cost_0_choice(13) := not is_set(sums_sum_0(13), 1);
      else
        winnersother_cost_0_choice(13) := winnersother_cost_0_13_is_equal;
      end if;
      if is_set(winnersother_cost_0(14), 1) then
        winnersother_cost_0_choices(13, 2) := is_set(winnersother_cost_0(14), 0) or (not is_set(sums_sum_0(13), 1)) or
          (not is_set(sums_sum_0(13), 0));
      else
        winnersother_cost_0_choices(13, 2) := winnersother_cost_0_choice(13);
      end if;
      winnersother_cost_0_value(13) := is_set(sums_sum_0(13), 2);
      if winnersother_cost_0_choices(13, 2) then
        winnersother_cost_0_choices(13, 3) := (not is_set(winnersother_cost_0(14), 2)) and
          winnersother_cost_0_value(13);
      else
        winnersother_cost_0_choices(13, 3) := (not is_set(winnersother_cost_0(14), 2)) or winnersother_cost_0_value(13);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(13, i) := is_set(sums_sum_0(13), i + 1);
        if winnersother_cost_0_choices(13, i + 1) then
          winnersother_cost_0_choices(13, i + 2) := (not is_set(winnersother_cost_0(14), i + 1)) or
            winnersother_cost_0_values(13, i);
        else
          winnersother_cost_0_choices(13, i + 2) := (not is_set(winnersother_cost_0(14), i + 1)) and
            winnersother_cost_0_values(13, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(14), 7) then
        winnersother_cost_0_choices(13, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(13), 7);
      else
        winnersother_cost_0_choices(13, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(13, 7) then
        winnersother_cost_0_choices(13, 9) := winnersother_cost_0_choices(13, 8);
      else
        winnersother_cost_0_choices(13, 9) := (not is_set(winnersother_cost_0(14), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(13), 7);
      end if;
      winnersother_cost_0_all(13) := (not winnersother_cost_0_choices(13, 9)) and winnersmask_inside(13) and
        sums_tag_output_column;
      winnersother_cost_0_value(14) := is_set(sums_sum_0(14), 1);
      if is_set(winnersother_cost_0(15), 0) then
        winnersother_cost_0_choice(14) := not winnersother_cost_0_value(14);
      else
        winnersother_cost_0_choice(14) := (sums_sum_0(14) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(15), 1) then
        winnersother_cost_0_choices(14, 2) := is_set(winnersother_cost_0(15), 0) or (not winnersother_cost_0_value(14))
          or (not is_set(sums_sum_0(14), 0));
      else
        winnersother_cost_0_choices(14, 2) := winnersother_cost_0_choice(14);
      end if;
      winnersother_cost_0_values(14, 2) := is_set(sums_sum_0(14), 2);
      if winnersother_cost_0_choices(14, 2) then
        winnersother_cost_0_choices(14, 3) := (not is_set(winnersother_cost_0(15), 2)) and
          winnersother_cost_0_values(14, 2);
      else
        winnersother_cost_0_choices(14, 3) := (not is_set(winnersother_cost_0(15), 2)) or
          winnersother_cost_0_values(14, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(14, i) := is_set(sums_sum_0(14), i);
        if winnersother_cost_0_choices(14, i) then
          winnersother_cost_0_choices(14, i + 1) := (not is_set(winnersother_cost_0(15), i)) or
            winnersother_cost_0_values(14, i);
        else
          winnersother_cost_0_choices(14, i + 1) := (not is_set(winnersother_cost_0(15), i)) and
            winnersother_cost_0_values(14, i);
        end if;
      end loop;
      winnersother_cost_0_14_value_6 := is_set(sums_sum_0(14), 6);
      if winnersother_cost_0_choices(14, 6) then
        winnersother_cost_0_choices(14, 7) := (not is_set(winnersother_cost_0(15), 6)) or
          winnersother_cost_0_14_value_6;
      else
        winnersother_cost_0_choices(14, 7) := (not is_set(winnersother_cost_0(15), 6)) and
          winnersother_cost_0_14_value_6;
      end if;
      if is_set(winnersother_cost_0(15), 7) then
        winnersother_cost_0_choices(14, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(14), 7);
      else
        winnersother_cost_0_choices(14, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(14, 7) then
        winnersother_cost_0_choices(14, 9) := winnersother_cost_0_choices(14, 8);
      else
        winnersother_cost_0_choices(14, 9) := (not is_set(winnersother_cost_0(15), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(14), 7);
      end if;
      winnersother_cost_0_all(14) := (not winnersother_cost_0_choices(14, 9)) and winnersmask_inside(14) and
        sums_tag_output_column;
      winnersother_cost_0_15_is_equal := (sums_sum_0(15) mod 4) = 0;
      if is_set(winnersother_cost_0(16), 0) then
        winnersother_cost_0_choice(15) := not is_set(sums_sum_0(15), 1);
      else
        winnersother_cost_0_choice(15) := winnersother_cost_0_15_is_equal;
      end if;
      if is_set(winnersother_cost_0(16), 1) then
        winnersother_cost_0_choices(15, 2) := is_set(winnersother_cost_0(16), 0) or (not is_set(sums_sum_0(15), 1)) or
          (not is_set(sums_sum_0(15), 0));
      else
        winnersother_cost_0_choices(15, 2) := winnersother_cost_0_choice(15);
      end if;
      winnersother_cost_0_value(15) := is_set(sums_sum_0(15), 2);
      if winnersother_cost_0_choices(15, 2) then
        winnersother_cost_0_choices(15, 3) := (not is_set(winnersother_cost_0(16), 2)) and
          winnersother_cost_0_value(15);
      else
        winnersother_cost_0_choices(15, 3) := (not is_set(winnersother_cost_0(16), 2)) or winnersother_cost_0_value(15);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(15, i) := is_set(sums_sum_0(15), i + 1);
        if winnersother_cost_0_choices(15, i + 1) then
          winnersother_cost_0_choices(15, i + 2) := (not is_set(winnersother_cost_0(16), i + 1)) or
            winnersother_cost_0_values(15, i);
        else
          winnersother_cost_0_choices(15, i + 2) := (not is_set(winnersother_cost_0(16), i + 1)) and
            winnersother_cost_0_values(15, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(16), 7) then
        winnersother_cost_0_choices(15, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(15), 7);
      else
        winnersother_cost_0_choices(15, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(15, 7) then
        winnersother_cost_0_choices(15, 9) := winnersother_cost_0_choices(15, 8);
      else
        winnersother_cost_0_choices(15, 9) := (not is_set(winnersother_cost_0(16), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(15), 7);
      end if;
      winnersother_cost_0_all(15) := (not winnersother_cost_0_choices(15, 9)) and winnersmask_inside(15) and
        sums_tag_output_column;
      winnersother_cost_0_value(16) := is_set(sums_sum_0(16), 1);
      if is_set(winnersother_cost_0(17), 0) then
        winnersother_cost_0_choice(16) := not winnersother_cost_0_value(16);
      else
        winnersother_cost_0_choice(16) := (sums_sum_0(16) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(17), 1) then
        winnersother_cost_0_choices(16, 2) := is_set(winnersother_cost_0(17), 0) or (not winnersother_cost_0_value(16))
          or (not is_set(sums_sum_0(16), 0));
      else
        winnersother_cost_0_choices(16, 2) := winnersother_cost_0_choice(16);
      end if;
      winnersother_cost_0_values(16, 2) := is_set(sums_sum_0(16), 2);
      if winnersother_cost_0_choices(16, 2) then
        winnersother_cost_0_choices(16, 3) := (not is_set(winnersother_cost_0(17), 2)) and
          winnersother_cost_0_values(16, 2);
      else
        winnersother_cost_0_choices(16, 3) := (not is_set(winnersother_cost_0(17), 2)) or
          winnersother_cost_0_values(16, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(16, i) := is_set(sums_sum_0(16), i);
        if winnersother_cost_0_choices(16, i) then
          winnersother_cost_0_choices(16, i + 1) := (not is_set(winnersother_cost_0(17), i)) or
            winnersother_cost_0_values(16, i);
        else
          winnersother_cost_0_choices(16, i + 1) := (not is_set(winnersother_cost_0(17), i)) and
            winnersother_cost_0_values(16, i);
        end if;
      end loop;
      winnersother_cost_0_16_value_6 := is_set(sums_sum_0(16), 6);
      if winnersother_cost_0_choices(16, 6) then
        winnersother_cost_0_choices(16, 7) := (not is_set(winnersother_cost_0(17), 6)) or
          winnersother_cost_0_16_value_6;
      else
        winnersother_cost_0_choices(16, 7) := (not is_set(winnersother_cost_0(17), 6)) and
          winnersother_cost_0_16_value_6;
      end if;
      if is_set(winnersother_cost_0(17), 7) then
        winnersother_cost_0_choices(16, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(16), 7);
      else
        winnersother_cost_0_choices(16, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(16, 7) then
        winnersother_cost_0_choices(16, 9) := winnersother_cost_0_choices(16, 8);
      else
        winnersother_cost_0_choices(16, 9) := (not is_set(winnersother_cost_0(17), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(16), 7);
      end if;
      winnersother_cost_0_all(16) := (not winnersother_cost_0_choices(16, 9)) and winnersmask_inside(16) and
        sums_tag_output_column;
      winnersother_cost_0_17_is_equal := (sums_sum_0(17) mod 4) = 0;
      if is_set(winnersother_cost_0(18), 0) then
        winnersother_cost_0_choice(17) := not is_set(sums_sum_0(17), 1);
      else
        winnersother_cost_0_choice(17) := winnersother_cost_0_17_is_equal;
      end if;
      if is_set(winnersother_cost_0(18), 1) then
        winnersother_cost_0_choices(17, 2) := is_set(winnersother_cost_0(18), 0) or (not is_set(sums_sum_0(17), 1)) or
          (not is_set(sums_sum_0(17), 0));
      else
        winnersother_cost_0_choices(17, 2) := winnersother_cost_0_choice(17);
      end if;
      winnersother_cost_0_value(17) := is_set(sums_sum_0(17), 2);
      if winnersother_cost_0_choices(17, 2) then
        winnersother_cost_0_choices(17, 3) := (not is_set(winnersother_cost_0(18), 2)) and
          winnersother_cost_0_value(17);
      else
        winnersother_cost_0_choices(17, 3) := (not is_set(winnersother_cost_0(18), 2)) or winnersother_cost_0_value(17);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(17, i) := is_set(sums_sum_0(17), i + 1);
        if winnersother_cost_0_choices(17, i + 1) then
          winnersother_cost_0_choices(17, i + 2) := (not is_set(winnersother_cost_0(18), i + 1)) or
            winnersother_cost_0_values(17, i);
        else
          winnersother_cost_0_choices(17, i + 2) := (not is_set(winnersother_cost_0(18), i + 1)) and
            winnersother_cost_0_values(17, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(18), 7) then
        winnersother_cost_0_choices(17, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(17), 7);
      else
        winnersother_cost_0_choices(17, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(17, 7) then
        winnersother_cost_0_choices(17, 9) := winnersother_cost_0_choices(17, 8);
      else
        winnersother_cost_0_choices(17, 9) := (not is_set(winnersother_cost_0(18), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(17), 7);
      end if;
      winnersother_cost_0_all(17) := (not winnersother_cost_0_choices(17, 9)) and winnersmask_inside(17) and
        sums_tag_output_column;
      winnersother_cost_0_value(18) := is_set(sums_sum_0(18), 1);
      if is_set(winnersother_cost_0(19), 0) then
        winnersother_cost_0_choice(18) := not winnersother_cost_0_value(18);
      else
        winnersother_cost_0_choice(18) := (sums_sum_0(18) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(19), 1) then
        winnersother_cost_0_choices(18, 2) := is_set(winnersother_cost_0(19), 0) or (not winnersother_cost_0_value(18))
          or (not is_set(sums_sum_0(18), 0));
      else
        winnersother_cost_0_choices(18, 2) := winnersother_cost_0_choice(18);
      end if;
      winnersother_cost_0_values(18, 2) := is_set(sums_sum_0(18), 2);
      if winnersother_cost_0_choices(18, 2) then
        winnersother_cost_0_choices(18, 3) := (not is_set(winnersother_cost_0(19), 2)) and
          winnersother_cost_0_values(18, 2);
      else
        winnersother_cost_0_choices(18, 3) := (not is_set(winnersother_cost_0(19), 2)) or
          winnersother_cost_0_values(18, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(18, i) := is_set(sums_sum_0(18), i);
        if winnersother_cost_0_choices(18, i) then
          winnersother_cost_0_choices(18, i + 1) := (not is_set(winnersother_cost_0(19), i)) or
            winnersother_cost_0_values(18, i);
        else
          winnersother_cost_0_choices(18, i + 1) := (not is_set(winnersother_cost_0(19), i)) and
            winnersother_cost_0_values(18, i);
        end if;
      end loop;
      winnersother_cost_0_18_value_6 := is_set(sums_sum_0(18), 6);
      if winnersother_cost_0_choices(18, 6) then
        winnersother_cost_0_choices(18, 7) := (not is_set(winnersother_cost_0(19), 6)) or
          winnersother_cost_0_18_value_6;
      else
        winnersother_cost_0_choices(18, 7) := (not is_set(winnersother_cost_0(19), 6)) and
          winnersother_cost_0_18_value_6;
      end if;
      if is_set(winnersother_cost_0(19), 7) then
        winnersother_cost_0_choices(18, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(18), 7);
      else
        winnersother_cost_0_choices(18, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(18, 7) then
        winnersother_cost_0_choices(18, 9) := winnersother_cost_0_choices(18, 8);
      else
        winnersother_cost_0_choices(18, 9) := (not is_set(winnersother_cost_0(19), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(18), 7);
      end if;
      winnersother_cost_0_all(18) := (not winnersother_cost_0_choices(18, 9)) and winnersmask_inside(18) and
        sums_tag_output_column;
      winnersother_cost_0_19_is_equal := (sums_sum_0(19) mod 4) = 0;
      if is_set(winnersother_cost_0(20), 0) then
        winnersother_cost_0_choice(19) := not is_set(sums_sum_0(19), 1);
      else
        winnersother_cost_0_choice(19) := winnersother_cost_0_19_is_equal;
      end if;
      if is_set(winnersother_cost_0(20), 1) then
        winnersother_cost_0_choices(19, 2) := is_set(winnersother_cost_0(20), 0) or (not is_set(sums_sum_0(19), 1)) or
          (not is_set(sums_sum_0(19), 0));
      else
        winnersother_cost_0_choices(19, 2) := winnersother_cost_0_choice(19);
      end if;
      winnersother_cost_0_value(19) := is_set(sums_sum_0(19), 2);
      if winnersother_cost_0_choices(19, 2) then
        winnersother_cost_0_choices(19, 3) := (not is_set(winnersother_cost_0(20), 2)) and
          winnersother_cost_0_value(19);
      else
        winnersother_cost_0_choices(19, 3) := (not is_set(winnersother_cost_0(20), 2)) or winnersother_cost_0_value(19);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(19, i) := is_set(sums_sum_0(19), i + 1);
        if winnersother_cost_0_choices(19, i + 1) then
          winnersother_cost_0_choices(19, i + 2) := (not is_set(winnersother_cost_0(20), i + 1)) or
            winnersother_cost_0_values(19, i);
        else
          winnersother_cost_0_choices(19, i + 2) := (not is_set(winnersother_cost_0(20), i + 1)) and
            winnersother_cost_0_values(19, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(20), 7) then
        winnersother_cost_0_choices(19, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(19), 7);
      else
        winnersother_cost_0_choices(19, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(19, 7) then
        winnersother_cost_0_choices(19, 9) := winnersother_cost_0_choices(19, 8);
      else
        winnersother_cost_0_choices(19, 9) := (not is_set(winnersother_cost_0(20), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(19), 7);
      end if;
      winnersother_cost_0_all(19) := (not winnersother_cost_0_choices(19, 9)) and winnersmask_inside(19) and
        sums_tag_output_column;
      winnersother_cost_0_value(20) := is_set(sums_sum_0(20), 1);
      if is_set(winnersother_cost_0(21), 0) then
        winnersother_cost_0_choice(20) := not winnersother_cost_0_value(20);
      else
        winnersother_cost_0_choice(20) := (sums_sum_0(20) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(21), 1) then
        winnersother_cost_0_choices(20, 2) := is_set(winnersother_cost_0(21), 0) or (not winnersother_cost_0_value(20))
          or (not is_set(sums_sum_0(20), 0));
      else
        winnersother_cost_0_choices(20, 2) := winnersother_cost_0_choice(20);
      end if;
      winnersother_cost_0_values(20, 2) := is_set(sums_sum_0(20), 2);
      if winnersother_cost_0_choices(20, 2) then
        winnersother_cost_0_choices(20, 3) := (not is_set(winnersother_cost_0(21), 2)) and
          winnersother_cost_0_values(20, 2);
      else
        winnersother_cost_0_choices(20, 3) := (not is_set(winnersother_cost_0(21), 2)) or
          winnersother_cost_0_values(20, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(20, i) := is_set(sums_sum_0(20), i);
        if winnersother_cost_0_choices(20, i) then
          winnersother_cost_0_choices(20, i + 1) := (not is_set(winnersother_cost_0(21), i)) or
            winnersother_cost_0_values(20, i);
        else
          winnersother_cost_0_choices(20, i + 1) := (not is_set(winnersother_cost_0(21), i)) and
            winnersother_cost_0_values(20, i);
        end if;
      end loop;
      winnersother_cost_0_20_value_6 := is_set(sums_sum_0(20), 6);
      if winnersother_cost_0_choices(20, 6) then
        winnersother_cost_0_choices(20, 7) := (not is_set(winnersother_cost_0(21), 6)) or
          winnersother_cost_0_20_value_6;
      else
        winnersother_cost_0_choices(20, 7) := (not is_set(winnersother_cost_0(21), 6)) and
          winnersother_cost_0_20_value_6;
      end if;
      if is_set(winnersother_cost_0(21), 7) then
        winnersother_cost_0_choices(20, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(20), 7);
      else
        winnersother_cost_0_choices(20, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(20, 7) then
        winnersother_cost_0_choices(20, 9) := winnersother_cost_0_choices(20, 8);
      else
        winnersother_cost_0_choices(20, 9) := (not is_set(winnersother_cost_0(21), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(20), 7);
      end if;
      winnersother_cost_0_all(20) := (not winnersother_cost_0_choices(20, 9)) and winnersmask_inside(20) and
        sums_tag_output_column;
      winnersother_cost_0_21_is_equal := (sums_sum_0(21) mod 4) = 0;
      if is_set(winnersother_cost_0(22), 0) then
        winnersother_cost_0_choice(21) := not is_set(sums_sum_0(21), 1);
      else
        winnersother_cost_0_choice(21) := winnersother_cost_0_21_is_equal;
      end if;
      if is_set(winnersother_cost_0(22), 1) then
        winnersother_cost_0_choices(21, 2) := is_set(winnersother_cost_0(22), 0) or (not is_set(sums_sum_0(21), 1)) or
          (not is_set(sums_sum_0(21), 0));
      else
        winnersother_cost_0_choices(21, 2) := winnersother_cost_0_choice(21);
      end if;
      winnersother_cost_0_value(21) := is_set(sums_sum_0(21), 2);
      if winnersother_cost_0_choices(21, 2) then
        winnersother_cost_0_choices(21, 3) := (not is_set(winnersother_cost_0(22), 2)) and
          winnersother_cost_0_value(21);
      else
        winnersother_cost_0_choices(21, 3) := (not is_set(winnersother_cost_0(22), 2)) or winnersother_cost_0_value(21);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(21, i) := is_set(sums_sum_0(21), i + 1);
        if winnersother_cost_0_choices(21, i + 1) then
          winnersother_cost_0_choices(21, i + 2) := (not is_set(winnersother_cost_0(22), i + 1)) or
            winnersother_cost_0_values(21, i);
        else
          winnersother_cost_0_choices(21, i + 2) := (not is_set(winnersother_cost_0(22), i + 1)) and
            winnersother_cost_0_values(21, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(22), 7) then
        winnersother_cost_0_choices(21, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(21), 7);
      else
        winnersother_cost_0_choices(21, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(21, 7) then
        winnersother_cost_0_choices(21, 9) := winnersother_cost_0_choices(21, 8);
      else
        winnersother_cost_0_choices(21, 9) := (not is_set(winnersother_cost_0(22), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(21), 7);
      end if;
      winnersother_cost_0_all(21) := (not winnersother_cost_0_choices(21, 9)) and winnersmask_inside(21) and
        sums_tag_output_column;
      winnersother_cost_0_value(22) := is_set(sums_sum_0(22), 1);
      if is_set(winnersother_cost_0(23), 0) then
        winnersother_cost_0_choice(22) := not winnersother_cost_0_value(22);
      else
        winnersother_cost_0_choice(22) := (sums_sum_0(22) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(23), 1) then
        winnersother_cost_0_choices(22, 2) := is_set(winnersother_cost_0(23), 0) or (not winnersother_cost_0_value(22))
          or (not is_set(sums_sum_0(22), 0));
      else
        winnersother_cost_0_choices(22, 2) := winnersother_cost_0_choice(22);
      end if;
      winnersother_cost_0_values(22, 2) := is_set(sums_sum_0(22), 2);
      if winnersother_cost_0_choices(22, 2) then
        winnersother_cost_0_choices(22, 3) := (not is_set(winnersother_cost_0(23), 2)) and
          winnersother_cost_0_values(22, 2);
      else
        winnersother_cost_0_choices(22, 3) := (not is_set(winnersother_cost_0(23), 2)) or
          winnersother_cost_0_values(22, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(22, i) := is_set(sums_sum_0(22), i);
        if winnersother_cost_0_choices(22, i) then
          winnersother_cost_0_choices(22, i + 1) := (not is_set(winnersother_cost_0(23), i)) or
            winnersother_cost_0_values(22, i);
        else
          winnersother_cost_0_choices(22, i + 1) := (not is_set(winnersother_cost_0(23), i)) and
            winnersother_cost_0_values(22, i);
        end if;
      end loop;
      winnersother_cost_0_22_value_6 := is_set(sums_sum_0(22), 6);
      if winnersother_cost_0_choices(22, 6) then
        winnersother_cost_0_choices(22, 7) := (not is_set(winnersother_cost_0(23), 6)) or
          winnersother_cost_0_22_value_6;
      else
        winnersother_cost_0_choices(22, 7) := (not is_set(winnersother_cost_0(23), 6)) and
          winnersother_cost_0_22_value_6;
      end if;
      if is_set(winnersother_cost_0(23), 7) then
        winnersother_cost_0_choices(22, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(22), 7);
      else
        winnersother_cost_0_choices(22, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(22, 7) then
        winnersother_cost_0_choices(22, 9) := winnersother_cost_0_choices(22, 8);
      else
        winnersother_cost_0_choices(22, 9) := (not is_set(winnersother_cost_0(23), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(22), 7);
      end if;
      winnersother_cost_0_all(22) := (not winnersother_cost_0_choices(22, 9)) and winnersmask_inside(22) and
        sums_tag_output_column;
      winnersother_cost_0_23_is_equal := (sums_sum_0(23) mod 4) = 0;
      if is_set(winnersother_cost_0(24), 0) then
        winnersother_cost_0_choice(23) := not is_set(sums_sum_0(23), 1);
      else
        winnersother_cost_0_choice(23) := winnersother_cost_0_23_is_equal;
      end if;
      if is_set(winnersother_cost_0(24), 1) then
        winnersother_cost_0_choices(23, 2) := is_set(winnersother_cost_0(24), 0) or (not is_set(sums_sum_0(23), 1)) or
          (not is_set(sums_sum_0(23), 0));
      else
        winnersother_cost_0_choices(23, 2) := winnersother_cost_0_choice(23);
      end if;
      winnersother_cost_0_value(23) := is_set(sums_sum_0(23), 2);
      if winnersother_cost_0_choices(23, 2) then
        winnersother_cost_0_choices(23, 3) := (not is_set(winnersother_cost_0(24), 2)) and
          winnersother_cost_0_value(23);
      else
        winnersother_cost_0_choices(23, 3) := (not is_set(winnersother_cost_0(24), 2)) or winnersother_cost_0_value(23);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(23, i) := is_set(sums_sum_0(23), i + 1);
        if winnersother_cost_0_choices(23, i + 1) then
          winnersother_cost_0_choices(23, i + 2) := (not is_set(winnersother_cost_0(24), i + 1)) or
            winnersother_cost_0_values(23, i);
        else
          winnersother_cost_0_choices(23, i + 2) := (not is_set(winnersother_cost_0(24), i + 1)) and
            winnersother_cost_0_values(23, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(24), 7) then
        winnersother_cost_0_choices(23, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(23), 7);
      else
        winnersother_cost_0_choices(23, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(23, 7) then
        winnersother_cost_0_choices(23, 9) := winnersother_cost_0_choices(23, 8);
      else
        winnersother_cost_0_choices(23, 9) := (not is_set(winnersother_cost_0(24), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(23), 7);
      end if;
      winnersother_cost_0_all(23) := (not winnersother_cost_0_choices(23, 9)) and winnersmask_inside(23) and
        sums_tag_output_column;
      winnersother_cost_0_value(24) := is_set(sums_sum_0(24), 1);
      if is_set(winnersother_cost_0(25), 0) then
        winnersother_cost_0_choice(24) := not winnersother_cost_0_value(24);
      else
        winnersother_cost_0_choice(24) := (sums_sum_0(24) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(25), 1) then
        winnersother_cost_0_choices(24, 2) := is_set(winnersother_cost_0(25), 0) or (not winnersother_cost_0_value(24))
          or (not is_set(sums_sum_0(24), 0));
      else
        winnersother_cost_0_choices(24, 2) := winnersother_cost_0_choice(24);
      end if;
      winnersother_cost_0_values(24, 2) := is_set(sums_sum_0(24), 2);
      if winnersother_cost_0_choices(24, 2) then
        winnersother_cost_0_choices(24, 3) := (not is_set(winnersother_cost_0(25), 2)) and
          winnersother_cost_0_values(24, 2);
      else
        winnersother_cost_0_choices(24, 3) := (not is_set(winnersother_cost_0(25), 2)) or
          winnersother_cost_0_values(24, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(24, i) := is_set(sums_sum_0(24), i);
        if winnersother_cost_0_choices(24, i) then
          winnersother_cost_0_choices(24, i + 1) := (not is_set(winnersother_cost_0(25), i)) or
            winnersother_cost_0_values(24, i);
        else
          winnersother_cost_0_choices(24, i + 1) := (not is_set(winnersother_cost_0(25), i)) and
            winnersother_cost_0_values(24, i);
        end if;
      end loop;
      winnersother_cost_0_24_value_6 := is_set(sums_sum_0(24), 6);
      if winnersother_cost_0_choices(24, 6) then
        winnersother_cost_0_choices(24, 7) := (not is_set(winnersother_cost_0(25), 6)) or
          winnersother_cost_0_24_value_6;
      else
        winnersother_cost_0_choices(24, 7) := (not is_set(winnersother_cost_0(25), 6)) and
          winnersother_cost_0_24_value_6;
      end if;
      if is_set(winnersother_cost_0(25), 7) then
        winnersother_cost_0_choices(24, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(24), 7);
      else
        winnersother_cost_0_choices(24, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(24, 7) then
        winnersother_cost_0_choices(24, 9) := winnersother_cost_0_choices(24, 8);
      else
        winnersother_cost_0_choices(24, 9) := (not is_set(winnersother_cost_0(25), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(24), 7);
      end if;
      winnersother_cost_0_all(24) := (not winnersother_cost_0_choices(24, 9)) and winnersmask_inside(24) and
        sums_tag_output_column;
      winnersother_cost_0_25_is_equal := (sums_sum_0(25) mod 4) = 0;
      if is_set(winnersother_cost_0(26), 0) then
        winnersother_cost_0_choice(25) := not is_set(sums_sum_0(25), 1);
      else
        winnersother_cost_0_choice(25) := winnersother_cost_0_25_is_equal;
      end if;
      if is_set(winnersother_cost_0(26), 1) then
        winnersother_cost_0_choices(25, 2) := is_set(winnersother_cost_0(26), 0) or (not is_set(sums_sum_0(25), 1)) or
          (not is_set(sums_sum_0(25), 0));
      else
        winnersother_cost_0_choices(25, 2) := winnersother_cost_0_choice(25);
      end if;
      winnersother_cost_0_value(25) := is_set(sums_sum_0(25), 2);
      if winnersother_cost_0_choices(25, 2) then
        winnersother_cost_0_choices(25, 3) := (not is_set(winnersother_cost_0(26), 2)) and
          winnersother_cost_0_value(25);
      else
        winnersother_cost_0_choices(25, 3) := (not is_set(winnersother_cost_0(26), 2)) or winnersother_cost_0_value(25);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(25, i) := is_set(sums_sum_0(25), i + 1);
        if winnersother_cost_0_choices(25, i + 1) then
          winnersother_cost_0_choices(25, i + 2) := (not is_set(winnersother_cost_0(26), i + 1)) or
            winnersother_cost_0_values(25, i);
        else
          winnersother_cost_0_choices(25, i + 2) := (not is_set(winnersother_cost_0(26), i + 1)) and
            winnersother_cost_0_values(25, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(26), 7) then
        winnersother_cost_0_choices(25, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(25), 7);
      else
        winnersother_cost_0_choices(25, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(25, 7) then
        winnersother_cost_0_choices(25, 9) := winnersother_cost_0_choices(25, 8);
      else
        winnersother_cost_0_choices(25, 9) := (not is_set(winnersother_cost_0(26), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(25), 7);
      end if;
      winnersother_cost_0_all(25) := (not winnersother_cost_0_choices(25, 9)) and winnersmask_inside(25) and
        sums_tag_output_column;
      winnersother_cost_0_value(26) := is_set(sums_sum_0(26), 1);
      if is_set(winnersother_cost_0(27), 0) then
        winnersother_cost_0_choice(26) := not winnersother_cost_0_value(26);
      else
        winnersother_cost_0_choice(26) := (sums_sum_0(26) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(27), 1) then
        winnersother_cost_0_choices(26, 2) := is_set(winnersother_cost_0(27), 0) or (not winnersother_cost_0_value(26))
          or (not is_set(sums_sum_0(26), 0));
      else
        winnersother_cost_0_choices(26, 2) := winnersother_cost_0_choice(26);
      end if;
      winnersother_cost_0_values(26, 2) := is_set(sums_sum_0(26), 2);
      if winnersother_cost_0_choices(26, 2) then
        winnersother_cost_0_choices(26, 3) := (not is_set(winnersother_cost_0(27), 2)) and
          winnersother_cost_0_values(26, 2);
      else
        winnersother_cost_0_choices(26, 3) := (not is_set(winnersother_cost_0(27), 2)) or
          winnersother_cost_0_values(26, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(26, i) := is_set(sums_sum_0(26), i);
        if winnersother_cost_0_choices(26, i) then
          winnersother_cost_0_choices(26, i + 1) := (not is_set(winnersother_cost_0(27), i)) or
            winnersother_cost_0_values(26, i);
        else
          winnersother_cost_0_choices(26, i + 1) := (not is_set(winnersother_cost_0(27), i)) and
            winnersother_cost_0_values(26, i);
        end if;
      end loop;
      winnersother_cost_0_26_value_6 := is_set(sums_sum_0(26), 6);
      if winnersother_cost_0_choices(26, 6) then
        winnersother_cost_0_choices(26, 7) := (not is_set(winnersother_cost_0(27), 6)) or
          winnersother_cost_0_26_value_6;
      else
        winnersother_cost_0_choices(26, 7) := (not is_set(winnersother_cost_0(27), 6)) and
          winnersother_cost_0_26_value_6;
      end if;
      if is_set(winnersother_cost_0(27), 7) then
        winnersother_cost_0_choices(26, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(26), 7);
      else
        winnersother_cost_0_choices(26, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(26, 7) then
        winnersother_cost_0_choices(26, 9) := winnersother_cost_0_choices(26, 8);
      else
        winnersother_cost_0_choices(26, 9) := (not is_set(winnersother_cost_0(27), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(26), 7);
      end if;
      winnersother_cost_0_all(26) := (not winnersother_cost_0_choices(26, 9)) and winnersmask_inside(26) and
        sums_tag_output_column;
      winnersother_cost_0_27_is_equal := (sums_sum_0(27) mod 4) = 0;
      if is_set(winnersother_cost_0(28), 0) then
        winnersother_cost_0_choice(27) := not is_set(sums_sum_0(27), 1);
      else
        winnersother_cost_0_choice(27) := winnersother_cost_0_27_is_equal;
      end if;
      if is_set(winnersother_cost_0(28), 1) then
        winnersother_cost_0_choices(27, 2) := is_set(winnersother_cost_0(28), 0) or (not is_set(sums_sum_0(27), 1)) or
          (not is_set(sums_sum_0(27), 0));
      else
        winnersother_cost_0_choices(27, 2) := winnersother_cost_0_choice(27);
      end if;
      winnersother_cost_0_value(27) := is_set(sums_sum_0(27), 2);
      if winnersother_cost_0_choices(27, 2) then
        winnersother_cost_0_choices(27, 3) := (not is_set(winnersother_cost_0(28), 2)) and
          winnersother_cost_0_value(27);
      else
        winnersother_cost_0_choices(27, 3) := (not is_set(winnersother_cost_0(28), 2)) or winnersother_cost_0_value(27);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(27, i) := is_set(sums_sum_0(27), i + 1);
        if winnersother_cost_0_choices(27, i + 1) then
          winnersother_cost_0_choices(27, i + 2) := (not is_set(winnersother_cost_0(28), i + 1)) or
            winnersother_cost_0_values(27, i);
        else
          winnersother_cost_0_choices(27, i + 2) := (not is_set(winnersother_cost_0(28), i + 1)) and
            winnersother_cost_0_values(27, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(28), 7) then
        winnersother_cost_0_choices(27, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(27), 7);
      else
        winnersother_cost_0_choices(27, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(27, 7) then
        winnersother_cost_0_choices(27, 9) := winnersother_cost_0_choices(27, 8);
      else
        winnersother_cost_0_choices(27, 9) := (not is_set(winnersother_cost_0(28), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(27), 7);
      end if;
      winnersother_cost_0_all(27) := (not winnersother_cost_0_choices(27, 9)) and winnersmask_inside(27) and
        sums_tag_output_column;
      winnersother_cost_0_value(28) := is_set(sums_sum_0(28), 1);
      if is_set(winnersother_cost_0(29), 0) then
        winnersother_cost_0_choice(28) := not winnersother_cost_0_value(28);
      else
        winnersother_cost_0_choice(28) := (sums_sum_0(28) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(29), 1) then
        winnersother_cost_0_choices(28, 2) := is_set(winnersother_cost_0(29), 0) or (not winnersother_cost_0_value(28))
          or (not is_set(sums_sum_0(28), 0));
      else
        winnersother_cost_0_choices(28, 2) := winnersother_cost_0_choice(28);
      end if;
      winnersother_cost_0_values(28, 2) := is_set(sums_sum_0(28), 2);
      if winnersother_cost_0_choices(28, 2) then
        winnersother_cost_0_choices(28, 3) := (not is_set(winnersother_cost_0(29), 2)) and
          winnersother_cost_0_values(28, 2);
      else
        winnersother_cost_0_choices(28, 3) := (not is_set(winnersother_cost_0(29), 2)) or
          winnersother_cost_0_values(28, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(28, i) := is_set(sums_sum_0(28), i);
        if winnersother_cost_0_choices(28, i) then
          winnersother_cost_0_choices(28, i + 1) := (not is_set(winnersother_cost_0(29), i)) or
            winnersother_cost_0_values(28, i);
        else
          winnersother_cost_0_choices(28, i + 1) := (not is_set(winnersother_cost_0(29), i)) and
            winnersother_cost_0_values(28, i);
        end if;
      end loop;
      winnersother_cost_0_28_value_6 := is_set(sums_sum_0(28), 6);
      if winnersother_cost_0_choices(28, 6) then
        winnersother_cost_0_choices(28, 7) := (not is_set(winnersother_cost_0(29), 6)) or
          winnersother_cost_0_28_value_6;
      else
        winnersother_cost_0_choices(28, 7) := (not is_set(winnersother_cost_0(29), 6)) and
          winnersother_cost_0_28_value_6;
      end if;
      if is_set(winnersother_cost_0(29), 7) then
        winnersother_cost_0_choices(28, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(28), 7);
      else
        winnersother_cost_0_choices(28, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(28, 7) then
        winnersother_cost_0_choices(28, 9) := winnersother_cost_0_choices(28, 8);
      else
        winnersother_cost_0_choices(28, 9) := (not is_set(winnersother_cost_0(29), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(28), 7);
      end if;
      winnersother_cost_0_all(28) := (not winnersother_cost_0_choices(28, 9)) and winnersmask_inside(28) and
        sums_tag_output_column;
      winnersother_cost_0_29_is_equal := (sums_sum_0(29) mod 4) = 0;
      if is_set(winnersother_cost_0(30), 0) then
        winnersother_cost_0_choice(29) := not is_set(sums_sum_0(29), 1);
      else
        winnersother_cost_0_choice(29) := winnersother_cost_0_29_is_equal;
      end if;
      if is_set(winnersother_cost_0(30), 1) then
        winnersother_cost_0_choices(29, 2) := is_set(winnersother_cost_0(30), 0) or (not is_set(sums_sum_0(29), 1)) or
          (not is_set(sums_sum_0(29), 0));
      else
        winnersother_cost_0_choices(29, 2) := winnersother_cost_0_choice(29);
      end if;
      winnersother_cost_0_value(29) := is_set(sums_sum_0(29), 2);
      if winnersother_cost_0_choices(29, 2) then
        winnersother_cost_0_choices(29, 3) := (not is_set(winnersother_cost_0(30), 2)) and
          winnersother_cost_0_value(29);
      else
        winnersother_cost_0_choices(29, 3) := (not is_set(winnersother_cost_0(30), 2)) or winnersother_cost_0_value(29);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(29, i) := is_set(sums_sum_0(29), i + 1);
        if winnersother_cost_0_choices(29, i + 1) then
          winnersother_cost_0_choices(29, i + 2) := (not is_set(winnersother_cost_0(30), i + 1)) or
            winnersother_cost_0_values(29, i);
        else
          winnersother_cost_0_choices(29, i + 2) := (not is_set(winnersother_cost_0(30), i + 1)) and
            winnersother_cost_0_values(29, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(30), 7) then
        winnersother_cost_0_choices(29, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(29), 7);
      else
        winnersother_cost_0_choices(29, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(29, 7) then
        winnersother_cost_0_choices(29, 9) := winnersother_cost_0_choices(29, 8);
      else
        winnersother_cost_0_choices(29, 9) := (not is_set(winnersother_cost_0(30), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(29), 7);
      end if;
      winnersother_cost_0_all(29) := (not winnersother_cost_0_choices(29, 9)) and winnersmask_inside(29) and
        sums_tag_output_column;
      winnersother_cost_0_value(30) := is_set(sums_sum_0(30), 1);
      if is_set(winnersother_cost_0(31), 0) then
        winnersother_cost_0_choice(30) := not winnersother_cost_0_value(30);
      else
        winnersother_cost_0_choice(30) := (sums_sum_0(30) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(31), 1) then
        winnersother_cost_0_choices(30, 2) := is_set(winnersother_cost_0(31), 0) or (not winnersother_cost_0_value(30))
          or (not is_set(sums_sum_0(30), 0));
      else
        winnersother_cost_0_choices(30, 2) := winnersother_cost_0_choice(30);
      end if;
      winnersother_cost_0_values(30, 2) := is_set(sums_sum_0(30), 2);
      if winnersother_cost_0_choices(30, 2) then
        winnersother_cost_0_choices(30, 3) := (not is_set(winnersother_cost_0(31), 2)) and
          winnersother_cost_0_values(30, 2);
      else
        winnersother_cost_0_choices(30, 3) := (not is_set(winnersother_cost_0(31), 2)) or
          winnersother_cost_0_values(30, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(30, i) := is_set(sums_sum_0(30), i);
        if winnersother_cost_0_choices(30, i) then
          winnersother_cost_0_choices(30, i + 1) := (not is_set(winnersother_cost_0(31), i)) or
            winnersother_cost_0_values(30, i);
        else
          winnersother_cost_0_choices(30, i + 1) := (not is_set(winnersother_cost_0(31), i)) and
            winnersother_cost_0_values(30, i);
        end if;
      end loop;
      winnersother_cost_0_30_value_6 := is_set(sums_sum_0(30), 6);
      if winnersother_cost_0_choices(30, 6) then
        winnersother_cost_0_choices(30, 7) := (not is_set(winnersother_cost_0(31), 6)) or
          winnersother_cost_0_30_value_6;
      else
        winnersother_cost_0_choices(30, 7) := (not is_set(winnersother_cost_0(31), 6)) and
          winnersother_cost_0_30_value_6;
      end if;
      if is_set(winnersother_cost_0(31), 7) then
        winnersother_cost_0_choices(30, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(30), 7);
      else
        winnersother_cost_0_choices(30, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(30, 7) then
        winnersother_cost_0_choices(30, 9) := winnersother_cost_0_choices(30, 8);
      else
        winnersother_cost_0_choices(30, 9) := (not is_set(winnersother_cost_0(31), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(30), 7);
      end if;
      winnersother_cost_0_all(30) := (not winnersother_cost_0_choices(30, 9)) and winnersmask_inside(30) and
        sums_tag_output_column;
      winnersother_cost_0_31_is_equal := (sums_sum_0(31) mod 4) = 0;
      if is_set(winnersother_cost_0(32), 0) then
        winnersother_cost_0_choice(31) := not is_set(sums_sum_0(31), 1);
      else
        winnersother_cost_0_choice(31) := winnersother_cost_0_31_is_equal;
      end if;
      if is_set(winnersother_cost_0(32), 1) then
        winnersother_cost_0_choices(31, 2) := is_set(winnersother_cost_0(32), 0) or (not is_set(sums_sum_0(31), 1)) or
          (not is_set(sums_sum_0(31), 0));
      else
        winnersother_cost_0_choices(31, 2) := winnersother_cost_0_choice(31);
      end if;
      winnersother_cost_0_value(31) := is_set(sums_sum_0(31), 2);
      if winnersother_cost_0_choices(31, 2) then
        winnersother_cost_0_choices(31, 3) := (not is_set(winnersother_cost_0(32), 2)) and
          winnersother_cost_0_value(31);
      else
        winnersother_cost_0_choices(31, 3) := (not is_set(winnersother_cost_0(32), 2)) or winnersother_cost_0_value(31);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(31, i) := is_set(sums_sum_0(31), i + 1);
        if winnersother_cost_0_choices(31, i + 1) then
          winnersother_cost_0_choices(31, i + 2) := (not is_set(winnersother_cost_0(32), i + 1)) or
            winnersother_cost_0_values(31, i);
        else
          winnersother_cost_0_choices(31, i + 2) := (not is_set(winnersother_cost_0(32), i + 1)) and
            winnersother_cost_0_values(31, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(32), 7) then
        winnersother_cost_0_choices(31, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(31), 7);
      else
        winnersother_cost_0_choices(31, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(31, 7) then
        winnersother_cost_0_choices(31, 9) := winnersother_cost_0_choices(31, 8);
      else
        winnersother_cost_0_choices(31, 9) := (not is_set(winnersother_cost_0(32), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(31), 7);
      end if;
      winnersother_cost_0_all(31) := (not winnersother_cost_0_choices(31, 9)) and winnersmask_inside(31) and
        sums_tag_output_column;
      winnersother_cost_0_value(32) := is_set(sums_sum_0(32), 1);
      if is_set(winnersother_cost_0(33), 0) then
        winnersother_cost_0_choice(32) := not winnersother_cost_0_value(32);
      else
        winnersother_cost_0_choice(32) := (sums_sum_0(32) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(33), 1) then
        winnersother_cost_0_choices(32, 2) := is_set(winnersother_cost_0(33), 0) or (not winnersother_cost_0_value(32))
          or (not is_set(sums_sum_0(32), 0));
      else
        winnersother_cost_0_choices(32, 2) := winnersother_cost_0_choice(32);
      end if;
      winnersother_cost_0_values(32, 2) := is_set(sums_sum_0(32), 2);
      if winnersother_cost_0_choices(32, 2) then
        winnersother_cost_0_choices(32, 3) := (not is_set(winnersother_cost_0(33), 2)) and
          winnersother_cost_0_values(32, 2);
      else
        winnersother_cost_0_choices(32, 3) := (not is_set(winnersother_cost_0(33), 2)) or
          winnersother_cost_0_values(32, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(32, i) := is_set(sums_sum_0(32), i);
        if winnersother_cost_0_choices(32, i) then
          winnersother_cost_0_choices(32, i + 1) := (not is_set(winnersother_cost_0(33), i)) or
            winnersother_cost_0_values(32, i);
        else
          winnersother_cost_0_choices(32, i + 1) := (not is_set(winnersother_cost_0(33), i)) and
            winnersother_cost_0_values(32, i);
        end if;
      end loop;
      winnersother_cost_0_32_value_6 := is_set(sums_sum_0(32), 6);
      if winnersother_cost_0_choices(32, 6) then
        winnersother_cost_0_choices(32, 7) := (not is_set(winnersother_cost_0(33), 6)) or
          winnersother_cost_0_32_value_6;
      else
        winnersother_cost_0_choices(32, 7) := (not is_set(winnersother_cost_0(33), 6)) and
          winnersother_cost_0_32_value_6;
      end if;
      if is_set(winnersother_cost_0(33), 7) then
        winnersother_cost_0_choices(32, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(32), 7);
      else
        winnersother_cost_0_choices(32, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(32, 7) then
        winnersother_cost_0_choices(32, 9) := winnersother_cost_0_choices(32, 8);
      else
        winnersother_cost_0_choices(32, 9) := (not is_set(winnersother_cost_0(33), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(32), 7);
      end if;
      winnersother_cost_0_all(32) := (not winnersother_cost_0_choices(32, 9)) and winnersmask_inside(32) and
        sums_tag_output_column;
      winnersother_cost_0_33_is_equal := (sums_sum_0(33) mod 4) = 0;
      if is_set(winnersother_cost_0(34), 0) then
        winnersother_cost_0_choice(33) := not is_set(sums_sum_0(33), 1);
      else
        winnersother_cost_0_choice(33) := winnersother_cost_0_33_is_equal;
      end if;
      if is_set(winnersother_cost_0(34), 1) then
        winnersother_cost_0_choices(33, 2) := is_set(winnersother_cost_0(34), 0) or (not is_set(sums_sum_0(33), 1)) or
          (not is_set(sums_sum_0(33), 0));
      else
        winnersother_cost_0_choices(33, 2) := winnersother_cost_0_choice(33);
      end if;
      winnersother_cost_0_value(33) := is_set(sums_sum_0(33), 2);
      if winnersother_cost_0_choices(33, 2) then
        winnersother_cost_0_choices(33, 3) := (not is_set(winnersother_cost_0(34), 2)) and
          winnersother_cost_0_value(33);
      else
        winnersother_cost_0_choices(33, 3) := (not is_set(winnersother_cost_0(34), 2)) or winnersother_cost_0_value(33);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(33, i) := is_set(sums_sum_0(33), i + 1);
        if winnersother_cost_0_choices(33, i + 1) then
          winnersother_cost_0_choices(33, i + 2) := (not is_set(winnersother_cost_0(34), i + 1)) or
            winnersother_cost_0_values(33, i);
        else
          winnersother_cost_0_choices(33, i + 2) := (not is_set(winnersother_cost_0(34), i + 1)) and
            winnersother_cost_0_values(33, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(34), 7) then
        winnersother_cost_0_choices(33, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(33), 7);
      else
        winnersother_cost_0_choices(33, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(33, 7) then
        winnersother_cost_0_choices(33, 9) := winnersother_cost_0_choices(33, 8);
      else
        winnersother_cost_0_choices(33, 9) := (not is_set(winnersother_cost_0(34), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(33), 7);
      end if;
      winnersother_cost_0_all(33) := (not winnersother_cost_0_choices(33, 9)) and winnersmask_inside(33) and
        sums_tag_output_column;
      winnersother_cost_0_value(34) := is_set(sums_sum_0(34), 1);
      if is_set(winnersother_cost_0(35), 0) then
        winnersother_cost_0_choice(34) := not winnersother_cost_0_value(34);
      else
        winnersother_cost_0_choice(34) := (sums_sum_0(34) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(35), 1) then
        winnersother_cost_0_choices(34, 2) := is_set(winnersother_cost_0(35), 0) or (not winnersother_cost_0_value(34))
          or (not is_set(sums_sum_0(34), 0));
      else
        winnersother_cost_0_choices(34, 2) := winnersother_cost_0_choice(34);
      end if;
      winnersother_cost_0_values(34, 2) := is_set(sums_sum_0(34), 2);
      if winnersother_cost_0_choices(34, 2) then
        winnersother_cost_0_choices(34, 3) := (not is_set(winnersother_cost_0(35), 2)) and
          winnersother_cost_0_values(34, 2);
      else
        winnersother_cost_0_choices(34, 3) := (not is_set(winnersother_cost_0(35), 2)) or
          winnersother_cost_0_values(34, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(34, i) := is_set(sums_sum_0(34), i);
        if winnersother_cost_0_choices(34, i) then
          winnersother_cost_0_choices(34, i + 1) := (not is_set(winnersother_cost_0(35), i)) or
            winnersother_cost_0_values(34, i);
        else
          winnersother_cost_0_choices(34, i + 1) := (not is_set(winnersother_cost_0(35), i)) and
            winnersother_cost_0_values(34, i);
        end if;
      end loop;
      winnersother_cost_0_34_value_6 := is_set(sums_sum_0(34), 6);
      if winnersother_cost_0_choices(34, 6) then
        winnersother_cost_0_choices(34, 7) := (not is_set(winnersother_cost_0(35), 6)) or
          winnersother_cost_0_34_value_6;
      else
        winnersother_cost_0_choices(34, 7) := (not is_set(winnersother_cost_0(35), 6)) and
          winnersother_cost_0_34_value_6;
      end if;
      if is_set(winnersother_cost_0(35), 7) then
        winnersother_cost_0_choices(34, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(34), 7);
      else
        winnersother_cost_0_choices(34, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(34, 7) then
        winnersother_cost_0_choices(34, 9) := winnersother_cost_0_choices(34, 8);
      else
        winnersother_cost_0_choices(34, 9) := (not is_set(winnersother_cost_0(35), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(34), 7);
      end if;
      winnersother_cost_0_all(34) := (not winnersother_cost_0_choices(34, 9)) and winnersmask_inside(34) and
        sums_tag_output_column;
      winnersother_cost_0_35_is_equal := (sums_sum_0(35) mod 4) = 0;
      if is_set(winnersother_cost_0(36), 0) then
        winnersother_cost_0_choice(35) := not is_set(sums_sum_0(35), 1);
      else
        winnersother_cost_0_choice(35) := winnersother_cost_0_35_is_equal;
      end if;
      if is_set(winnersother_cost_0(36), 1) then
        winnersother_cost_0_choices(35, 2) := is_set(winnersother_cost_0(36), 0) or (not is_set(sums_sum_0(35), 1)) or
          (not is_set(sums_sum_0(35), 0));
      else
        winnersother_cost_0_choices(35, 2) := winnersother_cost_0_choice(35);
      end if;
      winnersother_cost_0_value(35) := is_set(sums_sum_0(35), 2);
      if winnersother_cost_0_choices(35, 2) then
        winnersother_cost_0_choices(35, 3) := (not is_set(winnersother_cost_0(36), 2)) and
          winnersother_cost_0_value(35);
      else
        winnersother_cost_0_choices(35, 3) := (not is_set(winnersother_cost_0(36), 2)) or winnersother_cost_0_value(35);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(35, i) := is_set(sums_sum_0(35), i + 1);
        if winnersother_cost_0_choices(35, i + 1) then
          winnersother_cost_0_choices(35, i + 2) := (not is_set(winnersother_cost_0(36), i + 1)) or
            winnersother_cost_0_values(35, i);
        else
          winnersother_cost_0_choices(35, i + 2) := (not is_set(winnersother_cost_0(36), i + 1)) and
            winnersother_cost_0_values(35, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(36), 7) then
        winnersother_cost_0_choices(35, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(35), 7);
      else
        winnersother_cost_0_choices(35, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(35, 7) then
        winnersother_cost_0_choices(35, 9) := winnersother_cost_0_choices(35, 8);
      else
        winnersother_cost_0_choices(35, 9) := (not is_set(winnersother_cost_0(36), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(35), 7);
      end if;
      winnersother_cost_0_all(35) := (not winnersother_cost_0_choices(35, 9)) and winnersmask_inside(35) and
        sums_tag_output_column;
      winnersother_cost_0_value(36) := is_set(sums_sum_0(36), 1);
      if is_set(winnersother_cost_0(37), 0) then
        winnersother_cost_0_choice(36) := not winnersother_cost_0_value(36);
      else
        winnersother_cost_0_choice(36) := (sums_sum_0(36) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(37), 1) then
        winnersother_cost_0_choices(36, 2) := is_set(winnersother_cost_0(37), 0) or (not winnersother_cost_0_value(36))
          or (not is_set(sums_sum_0(36), 0));
      else
        winnersother_cost_0_choices(36, 2) := winnersother_cost_0_choice(36);
      end if;
      winnersother_cost_0_values(36, 2) := is_set(sums_sum_0(36), 2);
      if winnersother_cost_0_choices(36, 2) then
        winnersother_cost_0_choices(36, 3) := (not is_set(winnersother_cost_0(37), 2)) and
          winnersother_cost_0_values(36, 2);
      else
        winnersother_cost_0_choices(36, 3) := (not is_set(winnersother_cost_0(37), 2)) or
          winnersother_cost_0_values(36, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(36, i) := is_set(sums_sum_0(36), i);
        if winnersother_cost_0_choices(36, i) then
          winnersother_cost_0_choices(36, i + 1) := (not is_set(winnersother_cost_0(37), i)) or
            winnersother_cost_0_values(36, i);
        else
          winnersother_cost_0_choices(36, i + 1) := (not is_set(winnersother_cost_0(37), i)) and
            winnersother_cost_0_values(36, i);
        end if;
      end loop;
      winnersother_cost_0_36_value_6 := is_set(sums_sum_0(36), 6);
      if winnersother_cost_0_choices(36, 6) then
        winnersother_cost_0_choices(36, 7) := (not is_set(winnersother_cost_0(37), 6)) or
          winnersother_cost_0_36_value_6;
      else
        winnersother_cost_0_choices(36, 7) := (not is_set(winnersother_cost_0(37), 6)) and
          winnersother_cost_0_36_value_6;
      end if;
      if is_set(winnersother_cost_0(37), 7) then
        winnersother_cost_0_choices(36, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(36), 7);
      else
        winnersother_cost_0_choices(36, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(36, 7) then
        winnersother_cost_0_choices(36, 9) := winnersother_cost_0_choices(36, 8);
      else
        winnersother_cost_0_choices(36, 9) := (not is_set(winnersother_cost_0(37), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(36), 7);
      end if;
      winnersother_cost_0_all(36) := (not winnersother_cost_0_choices(36, 9)) and winnersmask_inside(36) and
        sums_tag_output_column;
      winnersother_cost_0_37_is_equal := (sums_sum_0(37) mod 4) = 0;
      if is_set(winnersother_cost_0(38), 0) then
        winnersother_cost_0_choice(37) := not is_set(sums_sum_0(37), 1);
      else
        winnersother_cost_0_choice(37) := winnersother_cost_0_37_is_equal;
      end if;
      if is_set(winnersother_cost_0(38), 1) then
        winnersother_cost_0_choices(37, 2) := is_set(winnersother_cost_0(38), 0) or (not is_set(sums_sum_0(37), 1)) or
          (not is_set(sums_sum_0(37), 0));
      else
        winnersother_cost_0_choices(37, 2) := winnersother_cost_0_choice(37);
      end if;
      winnersother_cost_0_value(37) := is_set(sums_sum_0(37), 2);
      if winnersother_cost_0_choices(37, 2) then
        winnersother_cost_0_choices(37, 3) := (not is_set(winnersother_cost_0(38), 2)) and
          winnersother_cost_0_value(37);
      else
        winnersother_cost_0_choices(37, 3) := (not is_set(winnersother_cost_0(38), 2)) or winnersother_cost_0_value(37);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(37, i) := is_set(sums_sum_0(37), i + 1);
        if winnersother_cost_0_choices(37, i + 1) then
          winnersother_cost_0_choices(37, i + 2) := (not is_set(winnersother_cost_0(38), i + 1)) or
            winnersother_cost_0_values(37, i);
        else
          winnersother_cost_0_choices(37, i + 2) := (not is_set(winnersother_cost_0(38), i + 1)) and
            winnersother_cost_0_values(37, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(38), 7) then
        winnersother_cost_0_choices(37, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(37), 7);
      else
        winnersother_cost_0_choices(37, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(37, 7) then
        winnersother_cost_0_choices(37, 9) := winnersother_cost_0_choices(37, 8);
      else
        winnersother_cost_0_choices(37, 9) := (not is_set(winnersother_cost_0(38), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(37), 7);
      end if;
      winnersother_cost_0_all(37) := (not winnersother_cost_0_choices(37, 9)) and winnersmask_inside(37) and
        sums_tag_output_column;
      winnersother_cost_0_value(38) := is_set(sums_sum_0(38), 1);
      if is_set(winnersother_cost_0(39), 0) then
        winnersother_cost_0_choice(38) := not winnersother_cost_0_value(38);
      else
        winnersother_cost_0_choice(38) := (sums_sum_0(38) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(39), 1) then
        winnersother_cost_0_choices(38, 2) := is_set(winnersother_cost_0(39), 0) or (not winnersother_cost_0_value(38))
          or (not is_set(sums_sum_0(38), 0));
      else
        winnersother_cost_0_choices(38, 2) := winnersother_cost_0_choice(38);
      end if;
      winnersother_cost_0_values(38, 2) := is_set(sums_sum_0(38), 2);
      if winnersother_cost_0_choices(38, 2) then
        winnersother_cost_0_choices(38, 3) := (not is_set(winnersother_cost_0(39), 2)) and
          winnersother_cost_0_values(38, 2);
      else
        winnersother_cost_0_choices(38, 3) := (not is_set(winnersother_cost_0(39), 2)) or
          winnersother_cost_0_values(38, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(38, i) := is_set(sums_sum_0(38), i);
        if winnersother_cost_0_choices(38, i) then
          winnersother_cost_0_choices(38, i + 1) := (not is_set(winnersother_cost_0(39), i)) or
            winnersother_cost_0_values(38, i);
        else
          winnersother_cost_0_choices(38, i + 1) := (not is_set(winnersother_cost_0(39), i)) and
            winnersother_cost_0_values(38, i);
        end if;
      end loop;
      winnersother_cost_0_38_value_6 := is_set(sums_sum_0(38), 6);
      if winnersother_cost_0_choices(38, 6) then
        winnersother_cost_0_choices(38, 7) := (not is_set(winnersother_cost_0(39), 6)) or
          winnersother_cost_0_38_value_6;
      else
        winnersother_cost_0_choices(38, 7) := (not is_set(winnersother_cost_0(39), 6)) and
          winnersother_cost_0_38_value_6;
      end if;
      if is_set(winnersother_cost_0(39), 7) then
        winnersother_cost_0_choices(38, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(38), 7);
      else
        winnersother_cost_0_choices(38, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(38, 7) then
        winnersother_cost_0_choices(38, 9) := winnersother_cost_0_choices(38, 8);
      else
        winnersother_cost_0_choices(38, 9) := (not is_set(winnersother_cost_0(39), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(38), 7);
      end if;
      winnersother_cost_0_all(38) := (not winnersother_cost_0_choices(38, 9)) and winnersmask_inside(38) and
        sums_tag_output_column;
      winnersother_cost_0_39_is_equal := (sums_sum_0(39) mod 4) = 0;
      if is_set(winnersother_cost_0(40), 0) then
        winnersother_cost_0_choice(39) := not is_set(sums_sum_0(39), 1);
      else
        winnersother_cost_0_choice(39) := winnersother_cost_0_39_is_equal;
      end if;
      if is_set(winnersother_cost_0(40), 1) then
        winnersother_cost_0_choices(39, 2) := is_set(winnersother_cost_0(40), 0) or (not is_set(sums_sum_0(39), 1)) or
          (not is_set(sums_sum_0(39), 0));
      else
        winnersother_cost_0_choices(39, 2) := winnersother_cost_0_choice(39);
      end if;
      winnersother_cost_0_value(39) := is_set(sums_sum_0(39), 2);
      if winnersother_cost_0_choices(39, 2) then
        winnersother_cost_0_choices(39, 3) := (not is_set(winnersother_cost_0(40), 2)) and
          winnersother_cost_0_value(39);
      else
        winnersother_cost_0_choices(39, 3) := (not is_set(winnersother_cost_0(40), 2)) or winnersother_cost_0_value(39);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(39, i) := is_set(sums_sum_0(39), i + 1);
        if winnersother_cost_0_choices(39, i + 1) then
          winnersother_cost_0_choices(39, i + 2) := (not is_set(winnersother_cost_0(40), i + 1)) or
            winnersother_cost_0_values(39, i);
        else
          winnersother_cost_0_choices(39, i + 2) := (not is_set(winnersother_cost_0(40), i + 1)) and
            winnersother_cost_0_values(39, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(40), 7) then
        winnersother_cost_0_choices(39, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(39), 7);
      else
        winnersother_cost_0_choices(39, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(39, 7) then
        winnersother_cost_0_choices(39, 9) := winnersother_cost_0_choices(39, 8);
      else
        winnersother_cost_0_choices(39, 9) := (not is_set(winnersother_cost_0(40), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(39), 7);
      end if;
      winnersother_cost_0_all(39) := (not winnersother_cost_0_choices(39, 9)) and winnersmask_inside(39) and
        sums_tag_output_column;
      winnersother_cost_0_value(40) := is_set(sums_sum_0(40), 1);
      if is_set(winnersother_cost_0(41), 0) then
        winnersother_cost_0_choice(40) := not winnersother_cost_0_value(40);
      else
        winnersother_cost_0_choice(40) := (sums_sum_0(40) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(41), 1) then
        winnersother_cost_0_choices(40, 2) := is_set(winnersother_cost_0(41), 0) or (not winnersother_cost_0_value(40))
          or (not is_set(sums_sum_0(40), 0));
      else
        winnersother_cost_0_choices(40, 2) := winnersother_cost_0_choice(40);
      end if;
      winnersother_cost_0_values(40, 2) := is_set(sums_sum_0(40), 2);
      if winnersother_cost_0_choices(40, 2) then
        winnersother_cost_0_choices(40, 3) := (not is_set(winnersother_cost_0(41), 2)) and
          winnersother_cost_0_values(40, 2);
      else
        winnersother_cost_0_choices(40, 3) := (not is_set(winnersother_cost_0(41), 2)) or
          winnersother_cost_0_values(40, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(40, i) := is_set(sums_sum_0(40), i);
        if winnersother_cost_0_choices(40, i) then
          winnersother_cost_0_choices(40, i + 1) := (not is_set(winnersother_cost_0(41), i)) or
            winnersother_cost_0_values(40, i);
        else
          winnersother_cost_0_choices(40, i + 1) := (not is_set(winnersother_cost_0(41), i)) and
            winnersother_cost_0_values(40, i);
        end if;
      end loop;
      winnersother_cost_0_40_value_6 := is_set(sums_sum_0(40), 6);
      if winnersother_cost_0_choices(40, 6) then
        winnersother_cost_0_choices(40, 7) := (not is_set(winnersother_cost_0(41), 6)) or
          winnersother_cost_0_40_value_6;
      else
        winnersother_cost_0_choices(40, 7) := (not is_set(winnersother_cost_0(41), 6)) and
          winnersother_cost_0_40_value_6;
      end if;
      if is_set(winnersother_cost_0(41), 7) then
        winnersother_cost_0_choices(40, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(40), 7);
      else
        winnersother_cost_0_choices(40, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(40, 7) then
        winnersother_cost_0_choices(40, 9) := winnersother_cost_0_choices(40, 8);
      else
        winnersother_cost_0_choices(40, 9) := (not is_set(winnersother_cost_0(41), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(40), 7);
      end if;
      winnersother_cost_0_all(40) := (not winnersother_cost_0_choices(40, 9)) and winnersmask_inside(40) and
        sums_tag_output_column;
      winnersother_cost_0_41_is_equal := (sums_sum_0(41) mod 4) = 0;
      if is_set(winnersother_cost_0(42), 0) then
        winnersother_cost_0_choice(41) := not is_set(sums_sum_0(41), 1);
      else
        winnersother_cost_0_choice(41) := winnersother_cost_0_41_is_equal;
      end if;
      if is_set(winnersother_cost_0(42), 1) then
        winnersother_cost_0_choices(41, 2) := is_set(winnersother_cost_0(42), 0) or (not is_set(sums_sum_0(41), 1)) or
          (not is_set(sums_sum_0(41), 0));
      else
        winnersother_cost_0_choices(41, 2) := winnersother_cost_0_choice(41);
      end if;
      winnersother_cost_0_value(41) := is_set(sums_sum_0(41), 2);
      if winnersother_cost_0_choices(41, 2) then
        winnersother_cost_0_choices(41, 3) := (not is_set(winnersother_cost_0(42), 2)) and
          winnersother_cost_0_value(41);
      else
        winnersother_cost_0_choices(41, 3) := (not is_set(winnersother_cost_0(42), 2)) or winnersother_cost_0_value(41);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(41, i) := is_set(sums_sum_0(41), i + 1);
        if winnersother_cost_0_choices(41, i + 1) then
          winnersother_cost_0_choices(41, i + 2) := (not is_set(winnersother_cost_0(42), i + 1)) or
            winnersother_cost_0_values(41, i);
        else
          winnersother_cost_0_choices(41, i + 2) := (not is_set(winnersother_cost_0(42), i + 1)) and
            winnersother_cost_0_values(41, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(42), 7) then
        winnersother_cost_0_choices(41, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(41), 7);
      else
        winnersother_cost_0_choices(41, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(41, 7) then
        winnersother_cost_0_choices(41, 9) := winnersother_cost_0_choices(41, 8);
      else
        winnersother_cost_0_choices(41, 9) := (not is_set(winnersother_cost_0(42), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(41), 7);
      end if;
      winnersother_cost_0_all(41) := (not winnersother_cost_0_choices(41, 9)) and winnersmask_inside(41) and
        sums_tag_output_column;
      winnersother_cost_0_value(42) := is_set(sums_sum_0(42), 1);
      if is_set(winnersother_cost_0(43), 0) then
        winnersother_cost_0_choice(42) := not winnersother_cost_0_value(42);
      else
        winnersother_cost_0_choice(42) := (sums_sum_0(42) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(43), 1) then
        winnersother_cost_0_choices(42, 2) := is_set(winnersother_cost_0(43), 0) or (not winnersother_cost_0_value(42))
          or (not is_set(sums_sum_0(42), 0));
      else
        winnersother_cost_0_choices(42, 2) := winnersother_cost_0_choice(42);
      end if;
      winnersother_cost_0_values(42, 2) := is_set(sums_sum_0(42), 2);
      if winnersother_cost_0_choices(42, 2) then
        winnersother_cost_0_choices(42, 3) := (not is_set(winnersother_cost_0(43), 2)) and
          winnersother_cost_0_values(42, 2);
      else
        winnersother_cost_0_choices(42, 3) := (not is_set(winnersother_cost_0(43), 2)) or
          winnersother_cost_0_values(42, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(42, i) := is_set(sums_sum_0(42), i);
        if winnersother_cost_0_choices(42, i) then
          winnersother_cost_0_choices(42, i + 1) := (not is_set(winnersother_cost_0(43), i)) or
            winnersother_cost_0_values(42, i);
        else
          winnersother_cost_0_choices(42, i + 1) := (not is_set(winnersother_cost_0(43), i)) and
            winnersother_cost_0_values(42, i);
        end if;
      end loop;
      winnersother_cost_0_42_value_6 := is_set(sums_sum_0(42), 6);
      if winnersother_cost_0_choices(42, 6) then
        winnersother_cost_0_choices(42, 7) := (not is_set(winnersother_cost_0(43), 6)) or
          winnersother_cost_0_42_value_6;
      else
        winnersother_cost_0_choices(42, 7) := (not is_set(winnersother_cost_0(43), 6)) and
          winnersother_cost_0_42_value_6;
      end if;
      if is_set(winnersother_cost_0(43), 7) then
        winnersother_cost_0_choices(42, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(42), 7);
      else
        winnersother_cost_0_choices(42, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(42, 7) then
        winnersother_cost_0_choices(42, 9) := winnersother_cost_0_choices(42, 8);
      else
        winnersother_cost_0_choices(42, 9) := (not is_set(winnersother_cost_0(43), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(42), 7);
      end if;
      winnersother_cost_0_all(42) := (not winnersother_cost_0_choices(42, 9)) and winnersmask_inside(42) and
        sums_tag_output_column;
      winnersother_cost_0_43_is_equal := (sums_sum_0(43) mod 4) = 0;
      if is_set(winnersother_cost_0(44), 0) then
        winnersother_cost_0_choice(43) := not is_set(sums_sum_0(43), 1);
      else
        winnersother_cost_0_choice(43) := winnersother_cost_0_43_is_equal;
      end if;
      if is_set(winnersother_cost_0(44), 1) then
        winnersother_cost_0_choices(43, 2) := is_set(winnersother_cost_0(44), 0) or (not is_set(sums_sum_0(43), 1)) or
          (not is_set(sums_sum_0(43), 0));
      else
        winnersother_cost_0_choices(43, 2) := winnersother_cost_0_choice(43);
      end if;
      winnersother_cost_0_value(43) := is_set(sums_sum_0(43), 2);
      if winnersother_cost_0_choices(43, 2) then
        winnersother_cost_0_choices(43, 3) := (not is_set(winnersother_cost_0(44), 2)) and
          winnersother_cost_0_value(43);
      else
        winnersother_cost_0_choices(43, 3) := (not is_set(winnersother_cost_0(44), 2)) or winnersother_cost_0_value(43);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(43, i) := is_set(sums_sum_0(43), i + 1);
        if winnersother_cost_0_choices(43, i + 1) then
          winnersother_cost_0_choices(43, i + 2) := (not is_set(winnersother_cost_0(44), i + 1)) or
            winnersother_cost_0_values(43, i);
        else
          winnersother_cost_0_choices(43, i + 2) := (not is_set(winnersother_cost_0(44), i + 1)) and
            winnersother_cost_0_values(43, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(44), 7) then
        winnersother_cost_0_choices(43, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(43), 7);
      else
        winnersother_cost_0_choices(43, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(43, 7) then
        winnersother_cost_0_choices(43, 9) := winnersother_cost_0_choices(43, 8);
      else
        winnersother_cost_0_choices(43, 9) := (not is_set(winnersother_cost_0(44), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(43), 7);
      end if;
      winnersother_cost_0_all(43) := (not winnersother_cost_0_choices(43, 9)) and winnersmask_inside(43) and
        sums_tag_output_column;
      winnersother_cost_0_value(44) := is_set(sums_sum_0(44), 1);
      if is_set(winnersother_cost_0(45), 0) then
        winnersother_cost_0_choice(44) := not winnersother_cost_0_value(44);
      else
        winnersother_cost_0_choice(44) := (sums_sum_0(44) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(45), 1) then
        winnersother_cost_0_choices(44, 2) := is_set(winnersother_cost_0(45), 0) or (not winnersother_cost_0_value(44))
          or (not is_set(sums_sum_0(44), 0));
      else
        winnersother_cost_0_choices(44, 2) := winnersother_cost_0_choice(44);
      end if;
      winnersother_cost_0_values(44, 2) := is_set(sums_sum_0(44), 2);
      if winnersother_cost_0_choices(44, 2) then
        winnersother_cost_0_choices(44, 3) := (not is_set(winnersother_cost_0(45), 2)) and
          winnersother_cost_0_values(44, 2);
      else
        winnersother_cost_0_choices(44, 3) := (not is_set(winnersother_cost_0(45), 2)) or
          winnersother_cost_0_values(44, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(44, i) := is_set(sums_sum_0(44), i);
        if winnersother_cost_0_choices(44, i) then
          winnersother_cost_0_choices(44, i + 1) := (not is_set(winnersother_cost_0(45), i)) or
            winnersother_cost_0_values(44, i);
        else
          winnersother_cost_0_choices(44, i + 1) := (not is_set(winnersother_cost_0(45), i)) and
            winnersother_cost_0_values(44, i);
        end if;
      end loop;
      winnersother_cost_0_44_value_6 := is_set(sums_sum_0(44), 6);
      if winnersother_cost_0_choices(44, 6) then
        winnersother_cost_0_choices(44, 7) := (not is_set(winnersother_cost_0(45), 6)) or
          winnersother_cost_0_44_value_6;
      else
        winnersother_cost_0_choices(44, 7) := (not is_set(winnersother_cost_0(45), 6)) and
          winnersother_cost_0_44_value_6;
      end if;
      if is_set(winnersother_cost_0(45), 7) then
        winnersother_cost_0_choices(44, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(44), 7);
      else
        winnersother_cost_0_choices(44, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(44, 7) then
        winnersother_cost_0_choices(44, 9) := winnersother_cost_0_choices(44, 8);
      else
        winnersother_cost_0_choices(44, 9) := (not is_set(winnersother_cost_0(45), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(44), 7);
      end if;
      winnersother_cost_0_all(44) := (not winnersother_cost_0_choices(44, 9)) and winnersmask_inside(44) and
        sums_tag_output_column;
      winnersother_cost_0_45_is_equal := (sums_sum_0(45) mod 4) = 0;
      if is_set(winnersother_cost_0(46), 0) then
        winnersother_cost_0_choice(45) := not is_set(sums_sum_0(45), 1);
      else
        winnersother_cost_0_choice(45) := winnersother_cost_0_45_is_equal;
      end if;
      if is_set(winnersother_cost_0(46), 1) then
        winnersother_cost_0_choices(45, 2) := is_set(winnersother_cost_0(46), 0) or (not is_set(sums_sum_0(45), 1)) or
          (not is_set(sums_sum_0(45), 0));
      else
        winnersother_cost_0_choices(45, 2) := winnersother_cost_0_choice(45);
      end if;
      winnersother_cost_0_value(45) := is_set(sums_sum_0(45), 2);
      if winnersother_cost_0_choices(45, 2) then
        winnersother_cost_0_choices(45, 3) := (not is_set(winnersother_cost_0(46), 2)) and
          winnersother_cost_0_value(45);
      else
        winnersother_cost_0_choices(45, 3) := (not is_set(winnersother_cost_0(46), 2)) or winnersother_cost_0_value(45);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(45, i) := is_set(sums_sum_0(45), i + 1);
        if winnersother_cost_0_choices(45, i + 1) then
          winnersother_cost_0_choices(45, i + 2) := (not is_set(winnersother_cost_0(46), i + 1)) or
            winnersother_cost_0_values(45, i);
        else
          winnersother_cost_0_choices(45, i + 2) := (not is_set(winnersother_cost_0(46), i + 1)) and
            winnersother_cost_0_values(45, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(46), 7) then
        winnersother_cost_0_choices(45, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(45), 7);
      else
        winnersother_cost_0_choices(45, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(45, 7) then
        winnersother_cost_0_choices(45, 9) := winnersother_cost_0_choices(45, 8);
      else
        winnersother_cost_0_choices(45, 9) := (not is_set(winnersother_cost_0(46), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(45), 7);
      end if;
      winnersother_cost_0_all(45) := (not winnersother_cost_0_choices(45, 9)) and winnersmask_inside(45) and
        sums_tag_output_column;
      winnersother_cost_0_value(46) := is_set(sums_sum_0(46), 1);
      if is_set(winnersother_cost_0(47), 0) then
        winnersother_cost_0_choice(46) := not winnersother_cost_0_value(46);
      else
        winnersother_cost_0_choice(46) := (sums_sum_0(46) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(47), 1) then
        winnersother_cost_0_choices(46, 2) := is_set(winnersother_cost_0(47), 0) or (not winnersother_cost_0_value(46))
          or (not is_set(sums_sum_0(46), 0));
      else
        winnersother_cost_0_choices(46, 2) := winnersother_cost_0_choice(46);
      end if;
      winnersother_cost_0_values(46, 2) := is_set(sums_sum_0(46), 2);
      if winnersother_cost_0_choices(46, 2) then
        winnersother_cost_0_choices(46, 3) := (not is_set(winnersother_cost_0(47), 2)) and
          winnersother_cost_0_values(46, 2);
      else
        winnersother_cost_0_choices(46, 3) := (not is_set(winnersother_cost_0(47), 2)) or
          winnersother_cost_0_values(46, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(46, i) := is_set(sums_sum_0(46), i);
        if winnersother_cost_0_choices(46, i) then
          winnersother_cost_0_choices(46, i + 1) := (not is_set(winnersother_cost_0(47), i)) or
            winnersother_cost_0_values(46, i);
        else
          winnersother_cost_0_choices(46, i + 1) := (not is_set(winnersother_cost_0(47), i)) and
            winnersother_cost_0_values(46, i);
        end if;
      end loop;
      winnersother_cost_0_46_value_6 := is_set(sums_sum_0(46), 6);
      if winnersother_cost_0_choices(46, 6) then
        winnersother_cost_0_choices(46, 7) := (not is_set(winnersother_cost_0(47), 6)) or
          winnersother_cost_0_46_value_6;
      else
        winnersother_cost_0_choices(46, 7) := (not is_set(winnersother_cost_0(47), 6)) and
          winnersother_cost_0_46_value_6;
      end if;
      if is_set(winnersother_cost_0(47), 7) then
        winnersother_cost_0_choices(46, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(46), 7);
      else
        winnersother_cost_0_choices(46, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(46, 7) then
        winnersother_cost_0_choices(46, 9) := winnersother_cost_0_choices(46, 8);
      else
        winnersother_cost_0_choices(46, 9) := (not is_set(winnersother_cost_0(47), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(46), 7);
      end if;
      winnersother_cost_0_all(46) := (not winnersother_cost_0_choices(46, 9)) and winnersmask_inside(46) and
        sums_tag_output_column;
      winnersother_cost_0_47_is_equal := (sums_sum_0(47) mod 4) = 0;
      if is_set(winnersother_cost_0(48), 0) then
        winnersother_cost_0_choice(47) := not is_set(sums_sum_0(47), 1);
      else
        winnersother_cost_0_choice(47) := winnersother_cost_0_47_is_equal;
      end if;
      if is_set(winnersother_cost_0(48), 1) then
        winnersother_cost_0_choices(47, 2) := is_set(winnersother_cost_0(48), 0) or (not is_set(sums_sum_0(47), 1)) or
          (not is_set(sums_sum_0(47), 0));
      else
        winnersother_cost_0_choices(47, 2) := winnersother_cost_0_choice(47);
      end if;
      winnersother_cost_0_value(47) := is_set(sums_sum_0(47), 2);
      if winnersother_cost_0_choices(47, 2) then
        winnersother_cost_0_choices(47, 3) := (not is_set(winnersother_cost_0(48), 2)) and
          winnersother_cost_0_value(47);
      else
        winnersother_cost_0_choices(47, 3) := (not is_set(winnersother_cost_0(48), 2)) or winnersother_cost_0_value(47);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(47, i) := is_set(sums_sum_0(47), i + 1);
        if winnersother_cost_0_choices(47, i + 1) then
          winnersother_cost_0_choices(47, i + 2) := (not is_set(winnersother_cost_0(48), i + 1)) or
            winnersother_cost_0_values(47, i);
        else
          winnersother_cost_0_choices(47, i + 2) := (not is_set(winnersother_cost_0(48), i + 1)) and
            winnersother_cost_0_values(47, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(48), 7) then
        winnersother_cost_0_choices(47, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(47), 7);
      else
        winnersother_cost_0_choices(47, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(47, 7) then
        winnersother_cost_0_choices(47, 9) := winnersother_cost_0_choices(47, 8);
      else
        winnersother_cost_0_choices(47, 9) := (not is_set(winnersother_cost_0(48), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(47), 7);
      end if;
      winnersother_cost_0_all(47) := (not winnersother_cost_0_choices(47, 9)) and winnersmask_inside(47) and
        sums_tag_output_column;
      winnersother_cost_0_value(48) := is_set(sums_sum_0(48), 1);
      if is_set(winnersother_cost_0(49), 0) then
        winnersother_cost_0_choice(48) := not winnersother_cost_0_value(48);
      else
        winnersother_cost_0_choice(48) := (sums_sum_0(48) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(49), 1) then
        winnersother_cost_0_choices(48, 2) := is_set(winnersother_cost_0(49), 0) or (not winnersother_cost_0_value(48))
          or (not is_set(sums_sum_0(48), 0));
      else
        winnersother_cost_0_choices(48, 2) := winnersother_cost_0_choice(48);
      end if;
      winnersother_cost_0_values(48, 2) := is_set(sums_sum_0(48), 2);
      if winnersother_cost_0_choices(48, 2) then
        winnersother_cost_0_choices(48, 3) := (not is_set(winnersother_cost_0(49), 2)) and
          winnersother_cost_0_values(48, 2);
      else
        winnersother_cost_0_choices(48, 3) := (not is_set(winnersother_cost_0(49), 2)) or
          winnersother_cost_0_values(48, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(48, i) := is_set(sums_sum_0(48), i);
        if winnersother_cost_0_choices(48, i) then
          winnersother_cost_0_choices(48, i + 1) := (not is_set(winnersother_cost_0(49), i)) or
            winnersother_cost_0_values(48, i);
        else
          winnersother_cost_0_choices(48, i + 1) := (not is_set(winnersother_cost_0(49), i)) and
            winnersother_cost_0_values(48, i);
        end if;
      end loop;
      winnersother_cost_0_48_value_6 := is_set(sums_sum_0(48), 6);
      if winnersother_cost_0_choices(48, 6) then
        winnersother_cost_0_choices(48, 7) := (not is_set(winnersother_cost_0(49), 6)) or
          winnersother_cost_0_48_value_6;
      else
        winnersother_cost_0_choices(48, 7) := (not is_set(winnersother_cost_0(49), 6)) and
          winnersother_cost_0_48_value_6;
      end if;
      if is_set(winnersother_cost_0(49), 7) then
        winnersother_cost_0_choices(48, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(48), 7);
      else
        winnersother_cost_0_choices(48, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(48, 7) then
        winnersother_cost_0_choices(48, 9) := winnersother_cost_0_choices(48, 8);
      else
        winnersother_cost_0_choices(48, 9) := (not is_set(winnersother_cost_0(49), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(48), 7);
      end if;
      winnersother_cost_0_all(48) := (not winnersother_cost_0_choices(48, 9)) and winnersmask_inside(48) and
        sums_tag_output_column;
      winnersother_cost_0_49_is_equal := (sums_sum_0(49) mod 4) = 0;
      if is_set(winnersother_cost_0(50), 0) then
        winnersother_cost_0_choice(49) := not is_set(sums_sum_0(49), 1);
      else
        winnersother_cost_0_choice(49) := winnersother_cost_0_49_is_equal;
      end if;
      if is_set(winnersother_cost_0(50), 1) then
        winnersother_cost_0_choices(49, 2) := is_set(winnersother_cost_0(50), 0) or (not is_set(sums_sum_0(49), 1)) or
          (not is_set(sums_sum_0(49), 0));
      else
        winnersother_cost_0_choices(49, 2) := winnersother_cost_0_choice(49);
      end if;
      winnersother_cost_0_value(49) := is_set(sums_sum_0(49), 2);
      if winnersother_cost_0_choices(49, 2) then
        winnersother_cost_0_choices(49, 3) := (not is_set(winnersother_cost_0(50), 2)) and
          winnersother_cost_0_value(49);
      else
        winnersother_cost_0_choices(49, 3) := (not is_set(winnersother_cost_0(50), 2)) or winnersother_cost_0_value(49);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(49, i) := is_set(sums_sum_0(49), i + 1);
        if winnersother_cost_0_choices(49, i + 1) then
          winnersother_cost_0_choices(49, i + 2) := (not is_set(winnersother_cost_0(50), i + 1)) or
            winnersother_cost_0_values(49, i);
        else
          winnersother_cost_0_choices(49, i + 2) := (not is_set(winnersother_cost_0(50), i + 1)) and
            winnersother_cost_0_values(49, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(50), 7) then
        winnersother_cost_0_choices(49, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(49), 7);
      else
        winnersother_cost_0_choices(49, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(49, 7) then
        winnersother_cost_0_choices(49, 9) := winnersother_cost_0_choices(49, 8);
      else
        winnersother_cost_0_choices(49, 9) := (not is_set(winnersother_cost_0(50), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(49), 7);
      end if;
      winnersother_cost_0_all(49) := (not winnersother_cost_0_choices(49, 9)) and winnersmask_inside(49) and
        sums_tag_output_column;
      winnersother_cost_0_value(50) := is_set(sums_sum_0(50), 1);
      if is_set(winnersother_cost_0(51), 0) then
        winnersother_cost_0_choice(50) := not winnersother_cost_0_value(50);
      else
        winnersother_cost_0_choice(50) := (sums_sum_0(50) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(51), 1) then
        winnersother_cost_0_choices(50, 2) := is_set(winnersother_cost_0(51), 0) or (not winnersother_cost_0_value(50))
          or (not is_set(sums_sum_0(50), 0));
      else
        winnersother_cost_0_choices(50, 2) := winnersother_cost_0_choice(50);
      end if;
      winnersother_cost_0_values(50, 2) := is_set(sums_sum_0(50), 2);
      if winnersother_cost_0_choices(50, 2) then
        winnersother_cost_0_choices(50, 3) := (not is_set(winnersother_cost_0(51), 2)) and
          winnersother_cost_0_values(50, 2);
      else
        winnersother_cost_0_choices(50, 3) := (not is_set(winnersother_cost_0(51), 2)) or
          winnersother_cost_0_values(50, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(50, i) := is_set(sums_sum_0(50), i);
        if winnersother_cost_0_choices(50, i) then
          winnersother_cost_0_choices(50, i + 1) := (not is_set(winnersother_cost_0(51), i)) or
            winnersother_cost_0_values(50, i);
        else
          winnersother_cost_0_choices(50, i + 1) := (not is_set(winnersother_cost_0(51), i)) and
            winnersother_cost_0_values(50, i);
        end if;
      end loop;
      winnersother_cost_0_50_value_6 := is_set(sums_sum_0(50), 6);
      if winnersother_cost_0_choices(50, 6) then
        winnersother_cost_0_choices(50, 7) := (not is_set(winnersother_cost_0(51), 6)) or
          winnersother_cost_0_50_value_6;
      else
        winnersother_cost_0_choices(50, 7) := (not is_set(winnersother_cost_0(51), 6)) and
          winnersother_cost_0_50_value_6;
      end if;
      if is_set(winnersother_cost_0(51), 7) then
        winnersother_cost_0_choices(50, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(50), 7);
      else
        winnersother_cost_0_choices(50, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(50, 7) then
        winnersother_cost_0_choices(50, 9) := winnersother_cost_0_choices(50, 8);
      else
        winnersother_cost_0_choices(50, 9) := (not is_set(winnersother_cost_0(51), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(50), 7);
      end if;
      winnersother_cost_0_all(50) := (not winnersother_cost_0_choices(50, 9)) and winnersmask_inside(50) and
        sums_tag_output_column;
      winnersother_cost_0_51_is_equal := (sums_sum_0(51) mod 4) = 0;
      if is_set(winnersother_cost_0(52), 0) then
        winnersother_cost_0_choice(51) := not is_set(sums_sum_0(51), 1);
      else
        winnersother_cost_0_choice(51) := winnersother_cost_0_51_is_equal;
      end if;
      if is_set(winnersother_cost_0(52), 1) then
        winnersother_cost_0_choices(51, 2) := is_set(winnersother_cost_0(52), 0) or (not is_set(sums_sum_0(51), 1)) or
          (not is_set(sums_sum_0(51), 0));
      else
        winnersother_cost_0_choices(51, 2) := winnersother_cost_0_choice(51);
      end if;
      winnersother_cost_0_value(51) := is_set(sums_sum_0(51), 2);
      if winnersother_cost_0_choices(51, 2) then
        winnersother_cost_0_choices(51, 3) := (not is_set(winnersother_cost_0(52), 2)) and
          winnersother_cost_0_value(51);
      else
        winnersother_cost_0_choices(51, 3) := (not is_set(winnersother_cost_0(52), 2)) or winnersother_cost_0_value(51);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(51, i) := is_set(sums_sum_0(51), i + 1);
        if winnersother_cost_0_choices(51, i + 1) then
          winnersother_cost_0_choices(51, i + 2) := (not is_set(winnersother_cost_0(52), i + 1)) or
            winnersother_cost_0_values(51, i);
        else
          winnersother_cost_0_choices(51, i + 2) := (not is_set(winnersother_cost_0(52), i + 1)) and
            winnersother_cost_0_values(51, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(52), 7) then
        winnersother_cost_0_choices(51, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(51), 7);
      else
        winnersother_cost_0_choices(51, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(51, 7) then
        winnersother_cost_0_choices(51, 9) := winnersother_cost_0_choices(51, 8);
      else
        winnersother_cost_0_choices(51, 9) := (not is_set(winnersother_cost_0(52), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(51), 7);
      end if;
      winnersother_cost_0_all(51) := (not winnersother_cost_0_choices(51, 9)) and winnersmask_inside(51) and
        sums_tag_output_column;
      winnersother_cost_0_value(52) := is_set(sums_sum_0(52), 1);
      if is_set(winnersother_cost_0(53), 0) then
        winnersother_cost_0_choice(52) := not winnersother_cost_0_value(52);
      else
        winnersother_cost_0_choice(52) := (sums_sum_0(52) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(53), 1) then
        winnersother_cost_0_choices(52, 2) := is_set(winnersother_cost_0(53), 0) or (not winnersother_cost_0_value(52))
          or (not is_set(sums_sum_0(52), 0));
      else
        winnersother_cost_0_choices(52, 2) := winnersother_cost_0_choice(52);
      end if;
      winnersother_cost_0_values(52, 2) := is_set(sums_sum_0(52), 2);
      if winnersother_cost_0_choices(52, 2) then
        winnersother_cost_0_choices(52, 3) := (not is_set(winnersother_cost_0(53), 2)) and
          winnersother_cost_0_values(52, 2);
      else
        winnersother_cost_0_choices(52, 3) := (not is_set(winnersother_cost_0(53), 2)) or
          winnersother_cost_0_values(52, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(52, i) := is_set(sums_sum_0(52), i);
        if winnersother_cost_0_choices(52, i) then
          winnersother_cost_0_choices(52, i + 1) := (not is_set(winnersother_cost_0(53), i)) or
            winnersother_cost_0_values(52, i);
        else
          winnersother_cost_0_choices(52, i + 1) := (not is_set(winnersother_cost_0(53), i)) and
            winnersother_cost_0_values(52, i);
        end if;
      end loop;
      winnersother_cost_0_52_value_6 := is_set(sums_sum_0(52), 6);
      if winnersother_cost_0_choices(52, 6) then
        winnersother_cost_0_choices(52, 7) := (not is_set(winnersother_cost_0(53), 6)) or
          winnersother_cost_0_52_value_6;
      else
        winnersother_cost_0_choices(52, 7) := (not is_set(winnersother_cost_0(53), 6)) and
          winnersother_cost_0_52_value_6;
      end if;
      if is_set(winnersother_cost_0(53), 7) then
        winnersother_cost_0_choices(52, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(52), 7);
      else
        winnersother_cost_0_choices(52, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(52, 7) then
        winnersother_cost_0_choices(52, 9) := winnersother_cost_0_choices(52, 8);
      else
        winnersother_cost_0_choices(52, 9) := (not is_set(winnersother_cost_0(53), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(52), 7);
      end if;
      winnersother_cost_0_all(52) := (not winnersother_cost_0_choices(52, 9)) and winnersmask_inside(52) and
        sums_tag_output_column;
      winnersother_cost_0_53_is_equal := (sums_sum_0(53) mod 4) = 0;
      if is_set(winnersother_cost_0(54), 0) then
        winnersother_cost_0_choice(53) := not is_set(sums_sum_0(53), 1);
      else
        winnersother_cost_0_choice(53) := winnersother_cost_0_53_is_equal;
      end if;
      if is_set(winnersother_cost_0(54), 1) then
        winnersother_cost_0_choices(53, 2) := is_set(winnersother_cost_0(54), 0) or (not is_set(sums_sum_0(53), 1)) or
          (not is_set(sums_sum_0(53), 0));
      else
        winnersother_cost_0_choices(53, 2) := winnersother_cost_0_choice(53);
      end if;
      winnersother_cost_0_value(53) := is_set(sums_sum_0(53), 2);
      if winnersother_cost_0_choices(53, 2) then
        winnersother_cost_0_choices(53, 3) := (not is_set(winnersother_cost_0(54), 2)) and
          winnersother_cost_0_value(53);
      else
        winnersother_cost_0_choices(53, 3) := (not is_set(winnersother_cost_0(54), 2)) or winnersother_cost_0_value(53);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(53, i) := is_set(sums_sum_0(53), i + 1);
        if winnersother_cost_0_choices(53, i + 1) then
          winnersother_cost_0_choices(53, i + 2) := (not is_set(winnersother_cost_0(54), i + 1)) or
            winnersother_cost_0_values(53, i);
        else
          winnersother_cost_0_choices(53, i + 2) := (not is_set(winnersother_cost_0(54), i + 1)) and
            winnersother_cost_0_values(53, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(54), 7) then
        winnersother_cost_0_choices(53, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(53), 7);
      else
        winnersother_cost_0_choices(53, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(53, 7) then
        winnersother_cost_0_choices(53, 9) := winnersother_cost_0_choices(53, 8);
      else
        winnersother_cost_0_choices(53, 9) := (not is_set(winnersother_cost_0(54), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(53), 7);
      end if;
      winnersother_cost_0_all(53) := (not winnersother_cost_0_choices(53, 9)) and winnersmask_inside(53) and
        sums_tag_output_column;
      winnersother_cost_0_value(54) := is_set(sums_sum_0(54), 1);
      if is_set(winnersother_cost_0(55), 0) then
        winnersother_cost_0_choice(54) := not winnersother_cost_0_value(54);
      else
        winnersother_cost_0_choice(54) := (sums_sum_0(54) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(55), 1) then
        winnersother_cost_0_choices(54, 2) := is_set(winnersother_cost_0(55), 0) or (not winnersother_cost_0_value(54))
          or (not is_set(sums_sum_0(54), 0));
      else
        winnersother_cost_0_choices(54, 2) := winnersother_cost_0_choice(54);
      end if;
      winnersother_cost_0_values(54, 2) := is_set(sums_sum_0(54), 2);
      if winnersother_cost_0_choices(54, 2) then
        winnersother_cost_0_choices(54, 3) := (not is_set(winnersother_cost_0(55), 2)) and
          winnersother_cost_0_values(54, 2);
      else
        winnersother_cost_0_choices(54, 3) := (not is_set(winnersother_cost_0(55), 2)) or
          winnersother_cost_0_values(54, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(54, i) := is_set(sums_sum_0(54), i);
        if winnersother_cost_0_choices(54, i) then
          winnersother_cost_0_choices(54, i + 1) := (not is_set(winnersother_cost_0(55), i)) or
            winnersother_cost_0_values(54, i);
        else
          winnersother_cost_0_choices(54, i + 1) := (not is_set(winnersother_cost_0(55), i)) and
            winnersother_cost_0_values(54, i);
        end if;
      end loop;
      winnersother_cost_0_54_value_6 := is_set(sums_sum_0(54), 6);
      if winnersother_cost_0_choices(54, 6) then
        winnersother_cost_0_choices(54, 7) := (not is_set(winnersother_cost_0(55), 6)) or
          winnersother_cost_0_54_value_6;
      else
        winnersother_cost_0_choices(54, 7) := (not is_set(winnersother_cost_0(55), 6)) and
          winnersother_cost_0_54_value_6;
      end if;
      if is_set(winnersother_cost_0(55), 7) then
        winnersother_cost_0_choices(54, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(54), 7);
      else
        winnersother_cost_0_choices(54, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(54, 7) then
        winnersother_cost_0_choices(54, 9) := winnersother_cost_0_choices(54, 8);
      else
        winnersother_cost_0_choices(54, 9) := (not is_set(winnersother_cost_0(55), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(54), 7);
      end if;
      winnersother_cost_0_all(54) := (not winnersother_cost_0_choices(54, 9)) and winnersmask_inside(54) and
        sums_tag_output_column;
      winnersother_cost_0_55_is_equal := (sums_sum_0(55) mod 4) = 0;
      if is_set(winnersother_cost_0(56), 0) then
        winnersother_cost_0_choice(55) := not is_set(sums_sum_0(55), 1);
      else
        winnersother_cost_0_choice(55) := winnersother_cost_0_55_is_equal;
      end if;
      if is_set(winnersother_cost_0(56), 1) then
        winnersother_cost_0_choices(55, 2) := is_set(winnersother_cost_0(56), 0) or (not is_set(sums_sum_0(55), 1)) or
          (not is_set(sums_sum_0(55), 0));
      else
        winnersother_cost_0_choices(55, 2) := winnersother_cost_0_choice(55);
      end if;
      winnersother_cost_0_value(55) := is_set(sums_sum_0(55), 2);
      if winnersother_cost_0_choices(55, 2) then
        winnersother_cost_0_choices(55, 3) := (not is_set(winnersother_cost_0(56), 2)) and
          winnersother_cost_0_value(55);
      else
        winnersother_cost_0_choices(55, 3) := (not is_set(winnersother_cost_0(56), 2)) or winnersother_cost_0_value(55);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(55, i) := is_set(sums_sum_0(55), i + 1);
        if winnersother_cost_0_choices(55, i + 1) then
          winnersother_cost_0_choices(55, i + 2) := (not is_set(winnersother_cost_0(56), i + 1)) or
            winnersother_cost_0_values(55, i);
        else
          winnersother_cost_0_choices(55, i + 2) := (not is_set(winnersother_cost_0(56), i + 1)) and
            winnersother_cost_0_values(55, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(56), 7) then
        winnersother_cost_0_choices(55, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(55), 7);
      else
        winnersother_cost_0_choices(55, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(55, 7) then
        winnersother_cost_0_choices(55, 9) := winnersother_cost_0_choices(55, 8);
      else
        winnersother_cost_0_choices(55, 9) := (not is_set(winnersother_cost_0(56), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(55), 7);
      end if;
      winnersother_cost_0_all(55) := (not winnersother_cost_0_choices(55, 9)) and winnersmask_inside(55) and
        sums_tag_output_column;
      winnersother_cost_0_value(56) := is_set(sums_sum_0(56), 1);
      if is_set(winnersother_cost_0(57), 0) then
        winnersother_cost_0_choice(56) := not winnersother_cost_0_value(56);
      else
        winnersother_cost_0_choice(56) := (sums_sum_0(56) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(57), 1) then
        winnersother_cost_0_choices(56, 2) := is_set(winnersother_cost_0(57), 0) or (not winnersother_cost_0_value(56))
          or (not is_set(sums_sum_0(56), 0));
      else
        winnersother_cost_0_choices(56, 2) := winnersother_cost_0_choice(56);
      end if;
      winnersother_cost_0_values(56, 2) := is_set(sums_sum_0(56), 2);
      if winnersother_cost_0_choices(56, 2) then
        winnersother_cost_0_choices(56, 3) := (not is_set(winnersother_cost_0(57), 2)) and
          winnersother_cost_0_values(56, 2);
      else
        winnersother_cost_0_choices(56, 3) := (not is_set(winnersother_cost_0(57), 2)) or
          winnersother_cost_0_values(56, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(56, i) := is_set(sums_sum_0(56), i);
        if winnersother_cost_0_choices(56, i) then
          winnersother_cost_0_choices(56, i + 1) := (not is_set(winnersother_cost_0(57), i)) or
            winnersother_cost_0_values(56, i);
        else
          winnersother_cost_0_choices(56, i + 1) := (not is_set(winnersother_cost_0(57), i)) and
            winnersother_cost_0_values(56, i);
        end if;
      end loop;
      winnersother_cost_0_56_value_6 := is_set(sums_sum_0(56), 6);
      if winnersother_cost_0_choices(56, 6) then
        winnersother_cost_0_choices(56, 7) := (not is_set(winnersother_cost_0(57), 6)) or
          winnersother_cost_0_56_value_6;
      else
        winnersother_cost_0_choices(56, 7) := (not is_set(winnersother_cost_0(57), 6)) and
          winnersother_cost_0_56_value_6;
      end if;
      if is_set(winnersother_cost_0(57), 7) then
        winnersother_cost_0_choices(56, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(56), 7);
      else
        winnersother_cost_0_choices(56, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(56, 7) then
        winnersother_cost_0_choices(56, 9) := winnersother_cost_0_choices(56, 8);
      else
        winnersother_cost_0_choices(56, 9) := (not is_set(winnersother_cost_0(57), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(56), 7);
      end if;
      winnersother_cost_0_all(56) := (not winnersother_cost_0_choices(56, 9)) and winnersmask_inside(56) and
        sums_tag_output_column;
      winnersother_cost_0_57_is_equal := (sums_sum_0(57) mod 4) = 0;
      if is_set(winnersother_cost_0(58), 0) then
        winnersother_cost_0_choice(57) := not is_set(sums_sum_0(57), 1);
      else
        winnersother_cost_0_choice(57) := winnersother_cost_0_57_is_equal;
      end if;
      if is_set(winnersother_cost_0(58), 1) then
        winnersother_cost_0_choices(57, 2) := is_set(winnersother_cost_0(58), 0) or (not is_set(sums_sum_0(57), 1)) or
          (not is_set(sums_sum_0(57), 0));
      else
        winnersother_cost_0_choices(57, 2) := winnersother_cost_0_choice(57);
      end if;
      winnersother_cost_0_value(57) := is_set(sums_sum_0(57), 2);
      if winnersother_cost_0_choices(57, 2) then
        winnersother_cost_0_choices(57, 3) := (not is_set(winnersother_cost_0(58), 2)) and
          winnersother_cost_0_value(57);
      else
        winnersother_cost_0_choices(57, 3) := (not is_set(winnersother_cost_0(58), 2)) or winnersother_cost_0_value(57);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(57, i) := is_set(sums_sum_0(57), i + 1);
        if winnersother_cost_0_choices(57, i + 1) then
          winnersother_cost_0_choices(57, i + 2) := (not is_set(winnersother_cost_0(58), i + 1)) or
            winnersother_cost_0_values(57, i);
        else
          winnersother_cost_0_choices(57, i + 2) := (not is_set(winnersother_cost_0(58), i + 1)) and
            winnersother_cost_0_values(57, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(58), 7) then
        winnersother_cost_0_choices(57, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(57), 7);
      else
        winnersother_cost_0_choices(57, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(57, 7) then
        winnersother_cost_0_choices(57, 9) := winnersother_cost_0_choices(57, 8);
      else
        winnersother_cost_0_choices(57, 9) := (not is_set(winnersother_cost_0(58), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(57), 7);
      end if;
      winnersother_cost_0_all(57) := (not winnersother_cost_0_choices(57, 9)) and winnersmask_inside(57) and
        sums_tag_output_column;
      winnersother_cost_0_value(58) := is_set(sums_sum_0(58), 1);
      if is_set(winnersother_cost_0(59), 0) then
        winnersother_cost_0_choice(58) := not winnersother_cost_0_value(58);
      else
        winnersother_cost_0_choice(58) := (sums_sum_0(58) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(59), 1) then
        winnersother_cost_0_choices(58, 2) := is_set(winnersother_cost_0(59), 0) or (not winnersother_cost_0_value(58))
          or (not is_set(sums_sum_0(58), 0));
      else
        winnersother_cost_0_choices(58, 2) := winnersother_cost_0_choice(58);
      end if;
      winnersother_cost_0_values(58, 2) := is_set(sums_sum_0(58), 2);
      if winnersother_cost_0_choices(58, 2) then
        winnersother_cost_0_choices(58, 3) := (not is_set(winnersother_cost_0(59), 2)) and
          winnersother_cost_0_values(58, 2);
      else
        winnersother_cost_0_choices(58, 3) := (not is_set(winnersother_cost_0(59), 2)) or
          winnersother_cost_0_values(58, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(58, i) := is_set(sums_sum_0(58), i);
        if winnersother_cost_0_choices(58, i) then
          winnersother_cost_0_choices(58, i + 1) := (not is_set(winnersother_cost_0(59), i)) or
            winnersother_cost_0_values(58, i);
        else
          winnersother_cost_0_choices(58, i + 1) := (not is_set(winnersother_cost_0(59), i)) and
            winnersother_cost_0_values(58, i);
        end if;
      end loop;
      winnersother_cost_0_58_value_6 := is_set(sums_sum_0(58), 6);
      if winnersother_cost_0_choices(58, 6) then
        winnersother_cost_0_choices(58, 7) := (not is_set(winnersother_cost_0(59), 6)) or
          winnersother_cost_0_58_value_6;
      else
        winnersother_cost_0_choices(58, 7) := (not is_set(winnersother_cost_0(59), 6)) and
          winnersother_cost_0_58_value_6;
      end if;
      if is_set(winnersother_cost_0(59), 7) then
        winnersother_cost_0_choices(58, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(58), 7);
      else
        winnersother_cost_0_choices(58, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(58, 7) then
        winnersother_cost_0_choices(58, 9) := winnersother_cost_0_choices(58, 8);
      else
        winnersother_cost_0_choices(58, 9) := (not is_set(winnersother_cost_0(59), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(58), 7);
      end if;
      winnersother_cost_0_all(58) := (not winnersother_cost_0_choices(58, 9)) and winnersmask_inside(58) and
        sums_tag_output_column;
      winnersother_cost_0_59_is_equal := (sums_sum_0(59) mod 4) = 0;
      if is_set(winnersother_cost_0(60), 0) then
        winnersother_cost_0_choice(59) := not is_set(sums_sum_0(59), 1);
      else
        winnersother_cost_0_choice(59) := winnersother_cost_0_59_is_equal;
      end if;
      if is_set(winnersother_cost_0(60), 1) then
        winnersother_cost_0_choices(59, 2) := is_set(winnersother_cost_0(60), 0) or (not is_set(sums_sum_0(59), 1)) or
          (not is_set(sums_sum_0(59), 0));
      else
        winnersother_cost_0_choices(59, 2) := winnersother_cost_0_choice(59);
      end if;
      winnersother_cost_0_value(59) := is_set(sums_sum_0(59), 2);
      if winnersother_cost_0_choices(59, 2) then
        winnersother_cost_0_choices(59, 3) := (not is_set(winnersother_cost_0(60), 2)) and
          winnersother_cost_0_value(59);
      else
        winnersother_cost_0_choices(59, 3) := (not is_set(winnersother_cost_0(60), 2)) or winnersother_cost_0_value(59);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(59, i) := is_set(sums_sum_0(59), i + 1);
        if winnersother_cost_0_choices(59, i + 1) then
          winnersother_cost_0_choices(59, i + 2) := (not is_set(winnersother_cost_0(60), i + 1)) or
            winnersother_cost_0_values(59, i);
        else
          winnersother_cost_0_choices(59, i + 2) := (not is_set(winnersother_cost_0(60), i + 1)) and
            winnersother_cost_0_values(59, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(60), 7) then
        winnersother_cost_0_choices(59, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(59), 7);
      else
        winnersother_cost_0_choices(59, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(59, 7) then
        winnersother_cost_0_choices(59, 9) := winnersother_cost_0_choices(59, 8);
      else
        winnersother_cost_0_choices(59, 9) := (not is_set(winnersother_cost_0(60), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(59), 7);
      end if;
      winnersother_cost_0_all(59) := (not winnersother_cost_0_choices(59, 9)) and winnersmask_inside(59) and
        sums_tag_output_column;
      winnersother_cost_0_value(60) := is_set(sums_sum_0(60), 1);
      if is_set(winnersother_cost_0(61), 0) then
        winnersother_cost_0_choice(60) := not winnersother_cost_0_value(60);
      else
        winnersother_cost_0_choice(60) := (sums_sum_0(60) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(61), 1) then
        winnersother_cost_0_choices(60, 2) := is_set(winnersother_cost_0(61), 0) or (not winnersother_cost_0_value(60))
          or (not is_set(sums_sum_0(60), 0));
      else
        winnersother_cost_0_choices(60, 2) := winnersother_cost_0_choice(60);
      end if;
      winnersother_cost_0_values(60, 2) := is_set(sums_sum_0(60), 2);
      if winnersother_cost_0_choices(60, 2) then
        winnersother_cost_0_choices(60, 3) := (not is_set(winnersother_cost_0(61), 2)) and
          winnersother_cost_0_values(60, 2);
      else
        winnersother_cost_0_choices(60, 3) := (not is_set(winnersother_cost_0(61), 2)) or
          winnersother_cost_0_values(60, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(60, i) := is_set(sums_sum_0(60), i);
        if winnersother_cost_0_choices(60, i) then
          winnersother_cost_0_choices(60, i + 1) := (not is_set(winnersother_cost_0(61), i)) or
            winnersother_cost_0_values(60, i);
        else
          winnersother_cost_0_choices(60, i + 1) := (not is_set(winnersother_cost_0(61), i)) and
            winnersother_cost_0_values(60, i);
        end if;
      end loop;
      winnersother_cost_0_60_value_6 := is_set(sums_sum_0(60), 6);
      if winnersother_cost_0_choices(60, 6) then
        winnersother_cost_0_choices(60, 7) := (not is_set(winnersother_cost_0(61), 6)) or
          winnersother_cost_0_60_value_6;
      else
        winnersother_cost_0_choices(60, 7) := (not is_set(winnersother_cost_0(61), 6)) and
          winnersother_cost_0_60_value_6;
      end if;
      if is_set(winnersother_cost_0(61), 7) then
        winnersother_cost_0_choices(60, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(60), 7);
      else
        winnersother_cost_0_choices(60, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(60, 7) then
        winnersother_cost_0_choices(60, 9) := winnersother_cost_0_choices(60, 8);
      else
        winnersother_cost_0_choices(60, 9) := (not is_set(winnersother_cost_0(61), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(60), 7);
      end if;
      winnersother_cost_0_all(60) := (not winnersother_cost_0_choices(60, 9)) and winnersmask_inside(60) and
        sums_tag_output_column;
      winnersother_cost_0_61_is_equal := (sums_sum_0(61) mod 4) = 0;
      if is_set(winnersother_cost_0(62), 0) then
        winnersother_cost_0_choice(61) := not is_set(sums_sum_0(61), 1);
      else
        winnersother_cost_0_choice(61) := winnersother_cost_0_61_is_equal;
      end if;
      if is_set(winnersother_cost_0(62), 1) then
        winnersother_cost_0_choices(61, 2) := is_set(winnersother_cost_0(62), 0) or (not is_set(sums_sum_0(61), 1)) or
          (not is_set(sums_sum_0(61), 0));
      else
        winnersother_cost_0_choices(61, 2) := winnersother_cost_0_choice(61);
      end if;
      winnersother_cost_0_value(61) := is_set(sums_sum_0(61), 2);
      if winnersother_cost_0_choices(61, 2) then
        winnersother_cost_0_choices(61, 3) := (not is_set(winnersother_cost_0(62), 2)) and
          winnersother_cost_0_value(61);
      else
        winnersother_cost_0_choices(61, 3) := (not is_set(winnersother_cost_0(62), 2)) or winnersother_cost_0_value(61);
      end if;
      for i in 2 to 5 loop
        winnersother_cost_0_values(61, i) := is_set(sums_sum_0(61), i + 1);
        if winnersother_cost_0_choices(61, i + 1) then
          winnersother_cost_0_choices(61, i + 2) := (not is_set(winnersother_cost_0(62), i + 1)) or
            winnersother_cost_0_values(61, i);
        else
          winnersother_cost_0_choices(61, i + 2) := (not is_set(winnersother_cost_0(62), i + 1)) and
            winnersother_cost_0_values(61, i);
        end if;
      end loop;
      if is_set(winnersother_cost_0(62), 7) then
        winnersother_cost_0_choices(61, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(61), 7);
      else
        winnersother_cost_0_choices(61, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(61, 7) then
        winnersother_cost_0_choices(61, 9) := winnersother_cost_0_choices(61, 8);
      else
        winnersother_cost_0_choices(61, 9) := (not is_set(winnersother_cost_0(62), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(61), 7);
      end if;
      winnersother_cost_0_all(61) := (not winnersother_cost_0_choices(61, 9)) and winnersmask_inside(61) and
        sums_tag_output_column;
      winnersother_cost_0_value(62) := is_set(sums_sum_0(62), 1);
      if is_set(winnersother_cost_0(63), 0) then
        winnersother_cost_0_choice(62) := not winnersother_cost_0_value(62);
      else
        winnersother_cost_0_choice(62) := (sums_sum_0(62) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(63), 1) then
        winnersother_cost_0_choices(62, 2) := is_set(winnersother_cost_0(63), 0) or (not winnersother_cost_0_value(62))
          or (not is_set(sums_sum_0(62), 0));
      else
        winnersother_cost_0_choices(62, 2) := winnersother_cost_0_choice(62);
      end if;
      winnersother_cost_0_values(62, 2) := is_set(sums_sum_0(62), 2);
      if winnersother_cost_0_choices(62, 2) then
        winnersother_cost_0_choices(62, 3) := (not is_set(winnersother_cost_0(63), 2)) and
          winnersother_cost_0_values(62, 2);
      else
        winnersother_cost_0_choices(62, 3) := (not is_set(winnersother_cost_0(63), 2)) or
          winnersother_cost_0_values(62, 2);
      end if;
      for i in 3 to 5 loop
        winnersother_cost_0_values(62, i) := is_set(sums_sum_0(62), i);
        if winnersother_cost_0_choices(62, i) then
          winnersother_cost_0_choices(62, i + 1) := (not is_set(winnersother_cost_0(63), i)) or
            winnersother_cost_0_values(62, i);
        else
          winnersother_cost_0_choices(62, i + 1) := (not is_set(winnersother_cost_0(63), i)) and
            winnersother_cost_0_values(62, i);
        end if;
      end loop;
      winnersother_cost_0_62_value_6 := is_set(sums_sum_0(62), 6);
      if winnersother_cost_0_choices(62, 6) then
        winnersother_cost_0_choices(62, 7) := (not is_set(winnersother_cost_0(63), 6)) or
          winnersother_cost_0_62_value_6;
      else
        winnersother_cost_0_choices(62, 7) := (not is_set(winnersother_cost_0(63), 6)) and
          winnersother_cost_0_62_value_6;
      end if;
      if is_set(winnersother_cost_0(63), 7) then
        winnersother_cost_0_choices(62, 8) := (not sums_tag_first_column) and is_set(sums_sum_0(62), 7);
      else
        winnersother_cost_0_choices(62, 8) := not sums_tag_first_column;
      end if;
      if winnersother_cost_0_choices(62, 7) then
        winnersother_cost_0_choices(62, 9) := winnersother_cost_0_choices(62, 8);
      else
        winnersother_cost_0_choices(62, 9) := (not is_set(winnersother_cost_0(63), 7)) and (not sums_tag_first_column)
          and is_set(sums_sum_0(62), 7);
      end if;
      winnersother_cost_0_all(62) := (not winnersother_cost_0_choices(62, 9)) and winnersmask_inside(62) and
        sums_tag_output_column;
      winnersother_cost_0_all(63) := winnersmask_inside(63) and sums_tag_output_column;
      winnersother_winner_0_0_value := is_set(sums_sum_0(0), 1);
      if is_set(winnersother_cost_0(1), 0) then
        winnersother_winner_0_0_choice := not winnersother_winner_0_0_value;
      else
        winnersother_winner_0_0_choice := (sums_sum_0(0) mod 4) = 0;
      end if;
      if is_set(winnersother_cost_0(1), 1) then
        winnersother_winner_0_0_choices(2) := is_set(winnersother_cost_0(1), 0) or (not winnersother_winner_0_0_value)
          or (not is_set(sums_sum_0(0), 0));
      else
        winnersother_winner_0_0_choices(2) := winnersother_winner_0_0_choice;
      end if;
      winnersother_winner_0_0_values(2) := is_set(sums_sum_0(0), 2);
      if winnersother_winner_0_0_choices(2) then
        winnersother_winner_0_0_choices(3) := (not is_set(winnersother_cost_0(1), 2)) and
          winnersother_winner_0_0_values(2);
      else
        winnersother_winner_0_0_choices(3) := (not is_set(winnersother_cost_0(1), 2)) or
          winnersother_winner_0_0_values(2);
      end if;
      for i in 3 to 6 loop
        winnersother_winner_0_0_values(i) := is_set(sums_sum_0(0), i);
        if winnersother_winner_0_0_choices(i) then
          winnersother_winner_0_0_choices(i + 1) := (not is_set(winnersother_cost_0(1), i)) or
            winnersother_winner_0_0_values(i);
        else
          winnersother_winner_0_0_choices(i + 1) := (not is_set(winnersother_cost_0(1), i)) and
            winnersother_winner_0_0_values(i);
        end if;
      end loop;
      if winnersother_winner_0_0_choices(7) then
        winnersother_winner_0_0_choices(8) := (not sums_tag_first_column) and ((not is_set(winnersother_cost_0(1), 7))
          or is_set(sums_sum_0(0), 7));
      else
        winnersother_winner_0_0_choices(8) := (not sums_tag_first_column) and (not is_set(winnersother_cost_0(1), 7))
          and is_set(sums_sum_0(0), 7);
      end if;
      if sums_tag_valid then
        for i in 1 to 62 loop
          if winnersother_cost_0_all(i) then
            winnersother_cost_0(i) <= sums_sum_0(i);
            winnersother_winner_0(i) <= i;
          else
            winnersother_cost_0(i) <= winnersother_cost_0(i + 1);
            winnersother_winner_0(i) <= winnersother_winner_0(i + 1);
          end if;
        end loop;
        if winnersother_cost_0_all(63) then
          winnersother_cost_0(63) <= sums_sum_0(63);
          winnersother_winner_0(63) <= 63;
        else
          winnersother_cost_0(63) <= 0;
          winnersother_winner_0(63) <= 0;
        end if;
        if (not winnersother_winner_0_0_choices(8)) and sums_tag_output_column and winnersmask_inside(0) then
          winnersother_winner_0(0) <= 0;
        else
          winnersother_winner_0(0) <= winnersother_winner_0(1);
        end if;
      end if;
      winnersother_winner_out_0 <= winnersother_winner_0(0);
      -- winnerswinner1
      if is_set(sums_sum_0(0), 0) then
        winnerswinner1_best_index_0_choice(0) := (not is_set(sums_sum_0(1), 1)) or (not is_set(sums_sum_0(1), 0));
      else
        winnerswinner1_best_index_0_choice(0) := not is_set(sums_sum_0(1), 1);
      end if;
      if winnersother_winner_0_0_value then
        winnerswinner1_best_index_0_choices(0, 2) := winnerswinner1_best_index_0_choice(0);
      else
        winnerswinner1_best_index_0_choices(0, 2) := is_set(sums_sum_0(0), 0) and winnersother_cost_0_1_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(0, 2) then
        winnerswinner1_best_index_0_choices(0, 3) := (not winnersother_winner_0_0_values(2)) and
          winnersother_cost_0_value(1);
      else
        winnerswinner1_best_index_0_choices(0, 3) := (not winnersother_winner_0_0_values(2)) or
          winnersother_cost_0_value(1);
      end if;
      for i in 3 to 6 loop
        if winnerswinner1_best_index_0_choices(0, i) then
          winnerswinner1_best_index_0_choices(0, i + 1) := (not winnersother_winner_0_0_values(i)) or
            winnersother_cost_0_values(1, i - 1);
        else
          winnerswinner1_best_index_0_choices(0, i + 1) := (not winnersother_winner_0_0_values(i)) and
            winnersother_cost_0_values(1, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(0, 7) then
        winnerswinner1_best_index_0_choices(0, 8) := is_set(sums_sum_0(0), 7) and (not is_set(sums_sum_0(1), 7));
      else
        winnerswinner1_best_index_0_choices(0, 8) := is_set(sums_sum_0(0), 7) or (not is_set(sums_sum_0(1), 7));
      end if;
      if is_set(sums_sum_0(2), 0) then
        winnerswinner1_best_index_0_choice(1) := (not is_set(sums_sum_0(3), 1)) or (not is_set(sums_sum_0(3), 0));
      else
        winnerswinner1_best_index_0_choice(1) := not is_set(sums_sum_0(3), 1);
      end if;
      if winnersother_cost_0_value(2) then
        winnerswinner1_best_index_0_choices(1, 2) := winnerswinner1_best_index_0_choice(1);
      else
        winnerswinner1_best_index_0_choices(1, 2) := is_set(sums_sum_0(2), 0) and winnersother_cost_0_3_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(1, 2) then
        winnerswinner1_best_index_0_choices(1, 3) := (not winnersother_cost_0_values(2, 2)) and
          winnersother_cost_0_value(3);
      else
        winnerswinner1_best_index_0_choices(1, 3) := (not winnersother_cost_0_values(2, 2)) or
          winnersother_cost_0_value(3);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(1, i) then
          winnerswinner1_best_index_0_choices(1, i + 1) := (not winnersother_cost_0_values(2, i)) or
            winnersother_cost_0_values(3, i - 1);
        else
          winnerswinner1_best_index_0_choices(1, i + 1) := (not winnersother_cost_0_values(2, i)) and
            winnersother_cost_0_values(3, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(1, 6) then
        winnerswinner1_best_index_0_choices(1, 7) := (not winnersother_cost_0_2_value_6) or
          winnersother_cost_0_values(3, 5);
      else
        winnerswinner1_best_index_0_choices(1, 7) := (not winnersother_cost_0_2_value_6) and
          winnersother_cost_0_values(3, 5);
      end if;
      if winnerswinner1_best_index_0_choices(1, 7) then
        winnerswinner1_best_index_0_choices(1, 8) := is_set(sums_sum_0(2), 7) and (not is_set(sums_sum_0(3), 7));
      else
        winnerswinner1_best_index_0_choices(1, 8) := is_set(sums_sum_0(2), 7) or (not is_set(sums_sum_0(3), 7));
      end if;
      if is_set(sums_sum_0(4), 0) then
        winnerswinner1_best_index_0_choice(2) := (not is_set(sums_sum_0(5), 1)) or (not is_set(sums_sum_0(5), 0));
      else
        winnerswinner1_best_index_0_choice(2) := not is_set(sums_sum_0(5), 1);
      end if;
      if winnersother_cost_0_value(4) then
        winnerswinner1_best_index_0_choices(2, 2) := winnerswinner1_best_index_0_choice(2);
      else
        winnerswinner1_best_index_0_choices(2, 2) := is_set(sums_sum_0(4), 0) and winnersother_cost_0_5_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(2, 2) then
        winnerswinner1_best_index_0_choices(2, 3) := (not winnersother_cost_0_values(4, 2)) and
          winnersother_cost_0_value(5);
      else
        winnerswinner1_best_index_0_choices(2, 3) := (not winnersother_cost_0_values(4, 2)) or
          winnersother_cost_0_value(5);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(2, i) then
          winnerswinner1_best_index_0_choices(2, i + 1) := (not winnersother_cost_0_values(4, i)) or
            winnersother_cost_0_values(5, i - 1);
        else
          winnerswinner1_best_index_0_choices(2, i + 1) := (not winnersother_cost_0_values(4, i)) and
            winnersother_cost_0_values(5, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(2, 6) then
        winnerswinner1_best_index_0_choices(2, 7) := (not winnersother_cost_0_4_value_6) or
          winnersother_cost_0_values(5, 5);
      else
        winnerswinner1_best_index_0_choices(2, 7) := (not winnersother_cost_0_4_value_6) and
          winnersother_cost_0_values(5, 5);
      end if;
      if winnerswinner1_best_index_0_choices(2, 7) then
        winnerswinner1_best_index_0_choices(2, 8) := is_set(sums_sum_0(4), 7) and (not is_set(sums_sum_0(5), 7));
      else
        winnerswinner1_best_index_0_choices(2, 8) := is_set(sums_sum_0(4), 7) or (not is_set(sums_sum_0(5), 7));
      end if;
      if is_set(sums_sum_0(6), 0) then
        winnerswinner1_best_index_0_choice(3) := (not is_set(sums_sum_0(7), 1)) or (not is_set(sums_sum_0(7), 0));
      else
        winnerswinner1_best_index_0_choice(3) := not is_set(sums_sum_0(7), 1);
      end if;
      if winnersother_cost_0_value(6) then
        winnerswinner1_best_index_0_choices(3, 2) := winnerswinner1_best_index_0_choice(3);
      else
        winnerswinner1_best_index_0_choices(3, 2) := is_set(sums_sum_0(6), 0) and winnersother_cost_0_7_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(3, 2) then
        winnerswinner1_best_index_0_choices(3, 3) := (not winnersother_cost_0_values(6, 2)) and
          winnersother_cost_0_value(7);
      else
        winnerswinner1_best_index_0_choices(3, 3) := (not winnersother_cost_0_values(6, 2)) or
          winnersother_cost_0_value(7);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(3, i) then
          winnerswinner1_best_index_0_choices(3, i + 1) := (not winnersother_cost_0_values(6, i)) or
            winnersother_cost_0_values(7, i - 1);
        else
          winnerswinner1_best_index_0_choices(3, i + 1) := (not winnersother_cost_0_values(6, i)) and
            winnersother_cost_0_values(7, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(3, 6) then
        winnerswinner1_best_index_0_choices(3, 7) := (not winnersother_cost_0_6_value_6) or
          winnersother_cost_0_values(7, 5);
      else
        winnerswinner1_best_index_0_choices(3, 7) := (not winnersother_cost_0_6_value_6) and
          winnersother_cost_0_values(7, 5);
      end if;
      if winnerswinner1_best_index_0_choices(3, 7) then
        winnerswinner1_best_index_0_choices(3, 8) := is_set(sums_sum_0(6), 7) and (not is_set(sums_sum_0(7), 7));
      else
        winnerswinner1_best_index_0_choices(3, 8) := is_set(sums_sum_0(6), 7) or (not is_set(sums_sum_0(7), 7));
      end if;
      if is_set(sums_sum_0(8), 0) then
        winnerswinner1_best_index_0_choice(4) := (not is_set(sums_sum_0(9), 1)) or (not is_set(sums_sum_0(9), 0));
      else
        winnerswinner1_best_index_0_choice(4) := not is_set(sums_sum_0(9), 1);
      end if;
      if winnersother_cost_0_value(8) then
        winnerswinner1_best_index_0_choices(4, 2) := winnerswinner1_best_index_0_choice(4);
      else
        winnerswinner1_best_index_0_choices(4, 2) := is_set(sums_sum_0(8), 0) and winnersother_cost_0_9_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(4, 2) then
        winnerswinner1_best_index_0_choices(4, 3) := (not winnersother_cost_0_values(8, 2)) and
          winnersother_cost_0_value(9);
      else
        winnerswinner1_best_index_0_choices(4, 3) := (not winnersother_cost_0_values(8, 2)) or
          winnersother_cost_0_value(9);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(4, i) then
          winnerswinner1_best_index_0_choices(4, i + 1) := (not winnersother_cost_0_values(8, i)) or
            winnersother_cost_0_values(9, i - 1);
        else
          winnerswinner1_best_index_0_choices(4, i + 1) := (not winnersother_cost_0_values(8, i)) and
            winnersother_cost_0_values(9, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(4, 6) then
        winnerswinner1_best_index_0_choices(4, 7) := (not winnersother_cost_0_8_value_6) or
          winnersother_cost_0_values(9, 5);
      else
        winnerswinner1_best_index_0_choices(4, 7) := (not winnersother_cost_0_8_value_6) and
          winnersother_cost_0_values(9, 5);
      end if;
      if winnerswinner1_best_index_0_choices(4, 7) then
        winnerswinner1_best_index_0_choices(4, 8) := is_set(sums_sum_0(8), 7) and (not is_set(sums_sum_0(9), 7));
      else
        winnerswinner1_best_index_0_choices(4, 8) := is_set(sums_sum_0(8), 7) or (not is_set(sums_sum_0(9), 7));
      end if;
      if is_set(sums_sum_0(10), 0) then
        winnerswinner1_best_index_0_choice(5) := (not is_set(sums_sum_0(11), 1)) or (not is_set(sums_sum_0(11), 0));
      else
        winnerswinner1_best_index_0_choice(5) := not is_set(sums_sum_0(11), 1);
      end if;
      if winnersother_cost_0_value(10) then
        winnerswinner1_best_index_0_choices(5, 2) := winnerswinner1_best_index_0_choice(5);
      else
        winnerswinner1_best_index_0_choices(5, 2) := is_set(sums_sum_0(10), 0) and winnersother_cost_0_11_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(5, 2) then
        winnerswinner1_best_index_0_choices(5, 3) := (not winnersother_cost_0_values(10, 2)) and
          winnersother_cost_0_value(11);
      else
        winnerswinner1_best_index_0_choices(5, 3) := (not winnersother_cost_0_values(10, 2)) or
          winnersother_cost_0_value(11);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(5, i) then
          winnerswinner1_best_index_0_choices(5, i + 1) := (not winnersother_cost_0_values(10, i)) or
            winnersother_cost_0_values(11, i - 1);
        else
          winnerswinner1_best_index_0_choices(5, i + 1) := (not winnersother_cost_0_values(10, i)) and
            winnersother_cost_0_values(11, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(5, 6) then
        winnerswinner1_best_index_0_choices(5, 7) := (not winnersother_cost_0_10_value_6) or
          winnersother_cost_0_values(11, 5);
      else
        winnerswinner1_best_index_0_choices(5, 7) := (not winnersother_cost_0_10_value_6) and
          winnersother_cost_0_values(11, 5);
      end if;
      if winnerswinner1_best_index_0_choices(5, 7) then
        winnerswinner1_best_index_0_choices(5, 8) := is_set(sums_sum_0(10), 7) and (not is_set(sums_sum_0(11), 7));
      else
        winnerswinner1_best_index_0_choices(5, 8) := is_set(sums_sum_0(10), 7) or (not is_set(sums_sum_0(11), 7));
      end if;
      if is_set(sums_sum_0(12), 0) then
        winnerswinner1_best_index_0_choice(6) := (not is_set(sums_sum_0(13), 1)) or (not is_set(sums_sum_0(13), 0));
      else
        winnerswinner1_best_index_0_choice(6) := not is_set(sums_sum_0(13), 1);
      end if;
      if winnersother_cost_0_value(12) then
        winnerswinner1_best_index_0_choices(6, 2) := winnerswinner1_best_index_0_choice(6);
      else
        winnerswinner1_best_index_0_choices(6, 2) := is_set(sums_sum_0(12), 0) and winnersother_cost_0_13_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(6, 2) then
        winnerswinner1_best_index_0_choices(6, 3) := (not winnersother_cost_0_values(12, 2)) and
          winnersother_cost_0_value(13);
      else
        winnerswinner1_best_index_0_choices(6, 3) := (not winnersother_cost_0_values(12, 2)) or
          winnersother_cost_0_value(13);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(6, i) then
          winnerswinner1_best_index_0_choices(6, i + 1) := (not winnersother_cost_0_values(12, i)) or
            winnersother_cost_0_values(13, i - 1);
        else
          winnerswinner1_best_index_0_choices(6, i + 1) := (not winnersother_cost_0_values(12, i)) and
            winnersother_cost_0_values(13, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(6, 6) then
        winnerswinner1_best_index_0_choices(6, 7) := (not winnersother_cost_0_12_value_6) or
          winnersother_cost_0_values(13, 5);
      else
        winnerswinner1_best_index_0_choices(6, 7) := (not winnersother_cost_0_12_value_6) and
          winnersother_cost_0_values(13, 5);
      end if;
      if winnerswinner1_best_index_0_choices(6, 7) then
        winnerswinner1_best_index_0_choices(6, 8) := is_set(sums_sum_0(12), 7) and (not is_set(sums_sum_0(13), 7));
      else
        winnerswinner1_best_index_0_choices(6, 8) := is_set(sums_sum_0(12), 7) or (not is_set(sums_sum_0(13), 7));
      end if;
      if is_set(sums_sum_0(14), 0) then
        winnerswinner1_best_index_0_choice(7) := (not is_set(sums_sum_0(15), 1)) or (not is_set(sums_sum_0(15), 0));
      else
        winnerswinner1_best_index_0_choice(7) := not is_set(sums_sum_0(15), 1);
      end if;
      if winnersother_cost_0_value(14) then
        winnerswinner1_best_index_0_choices(7, 2) := winnerswinner1_best_index_0_choice(7);
      else
        winnerswinner1_best_index_0_choices(7, 2) := is_set(sums_sum_0(14), 0) and winnersother_cost_0_15_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(7, 2) then
        winnerswinner1_best_index_0_choices(7, 3) := (not winnersother_cost_0_values(14, 2)) and
          winnersother_cost_0_value(15);
      else
        winnerswinner1_best_index_0_choices(7, 3) := (not winnersother_cost_0_values(14, 2)) or
          winnersother_cost_0_value(15);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(7, i) then
          winnerswinner1_best_index_0_choices(7, i + 1) := (not winnersother_cost_0_values(14, i)) or
            winnersother_cost_0_values(15, i - 1);
        else
          winnerswinner1_best_index_0_choices(7, i + 1) := (not winnersother_cost_0_values(14, i)) and
            winnersother_cost_0_values(15, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(7, 6) then
        winnerswinner1_best_index_0_choices(7, 7) := (not winnersother_cost_0_14_value_6) or
          winnersother_cost_0_values(15, 5);
      else
        winnerswinner1_best_index_0_choices(7, 7) := (not winnersother_cost_0_14_value_6) and
          winnersother_cost_0_values(15, 5);
      end if;
      if winnerswinner1_best_index_0_choices(7, 7) then
        winnerswinner1_best_index_0_choices(7, 8) := is_set(sums_sum_0(14), 7) and (not is_set(sums_sum_0(15), 7));
      else
        winnerswinner1_best_index_0_choices(7, 8) := is_set(sums_sum_0(14), 7) or (not is_set(sums_sum_0(15), 7));
      end if;
      if is_set(sums_sum_0(16), 0) then
        winnerswinner1_best_index_0_choice(8) := (not is_set(sums_sum_0(17), 1)) or (not is_set(sums_sum_0(17), 0));
      else
        winnerswinner1_best_index_0_choice(8) := not is_set(sums_sum_0(17), 1);
      end if;
      if winnersother_cost_0_value(16) then
        winnerswinner1_best_index_0_choices(8, 2) := winnerswinner1_best_index_0_choice(8);
      else
        winnerswinner1_best_index_0_choices(8, 2) := is_set(sums_sum_0(16), 0) and winnersother_cost_0_17_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(8, 2) then
        winnerswinner1_best_index_0_choices(8, 3) := (not winnersother_cost_0_values(16, 2)) and
          winnersother_cost_0_value(17);
      else
        winnerswinner1_best_index_0_choices(8, 3) := (not winnersother_cost_0_values(16, 2)) or
          winnersother_cost_0_value(17);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(8, i) then
          winnerswinner1_best_index_0_choices(8, i + 1) := (not winnersother_cost_0_values(16, i)) or
            winnersother_cost_0_values(17, i - 1);
        else
          winnerswinner1_best_index_0_choices(8, i + 1) := (not winnersother_cost_0_values(16, i)) and
            winnersother_cost_0_values(17, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(8, 6) then
        winnerswinner1_best_index_0_choices(8, 7) := (not winnersother_cost_0_16_value_6) or
          winnersother_cost_0_values(17, 5);
      else
        winnerswinner1_best_index_0_choices(8, 7) := (not winnersother_cost_0_16_value_6) and
          winnersother_cost_0_values(17, 5);
      end if;
      if winnerswinner1_best_index_0_choices(8, 7) then
        winnerswinner1_best_index_0_choices(8, 8) := is_set(sums_sum_0(16), 7) and (not is_set(sums_sum_0(17), 7));
      else
        winnerswinner1_best_index_0_choices(8, 8) := is_set(sums_sum_0(16), 7) or (not is_set(sums_sum_0(17), 7));
      end if;
      if is_set(sums_sum_0(18), 0) then
        winnerswinner1_best_index_0_choice(9) := (not is_set(sums_sum_0(19), 1)) or (not is_set(sums_sum_0(19), 0));
      else
        winnerswinner1_best_index_0_choice(9) := not is_set(sums_sum_0(19), 1);
      end if;
      if winnersother_cost_0_value(18) then
        winnerswinner1_best_index_0_choices(9, 2) := winnerswinner1_best_index_0_choice(9);
      else
        winnerswinner1_best_index_0_choices(9, 2) := is_set(sums_sum_0(18), 0) and winnersother_cost_0_19_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(9, 2) then
        winnerswinner1_best_index_0_choices(9, 3) := (not winnersother_cost_0_values(18, 2)) and
          winnersother_cost_0_value(19);
      else
        winnerswinner1_best_index_0_choices(9, 3) := (not winnersother_cost_0_values(18, 2)) or
          winnersother_cost_0_value(19);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(9, i) then
          winnerswinner1_best_index_0_choices(9, i + 1) := (not winnersother_cost_0_values(18, i)) or
            winnersother_cost_0_values(19, i - 1);
        else
          winnerswinner1_best_index_0_choices(9, i + 1) := (not winnersother_cost_0_values(18, i)) and
            winnersother_cost_0_values(19, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(9, 6) then
        winnerswinner1_best_index_0_choices(9, 7) := (not winnersother_cost_0_18_value_6) or
          winnersother_cost_0_values(19, 5);
      else
        winnerswinner1_best_index_0_choices(9, 7) := (not winnersother_cost_0_18_value_6) and
          winnersother_cost_0_values(19, 5);
      end if;
      if winnerswinner1_best_index_0_choices(9, 7) then
        winnerswinner1_best_index_0_choices(9, 8) := is_set(sums_sum_0(18), 7) and (not is_set(sums_sum_0(19), 7));
      else
        winnerswinner1_best_index_0_choices(9, 8) := is_set(sums_sum_0(18), 7) or (not is_set(sums_sum_0(19), 7));
      end if;
      if is_set(sums_sum_0(20), 0) then
        winnerswinner1_best_index_0_choice(10) := (not is_set(sums_sum_0(21), 1)) or (not is_set(sums_sum_0(21), 0));
      else
        winnerswinner1_best_index_0_choice(10) := not is_set(sums_sum_0(21), 1);
      end if;
      if winnersother_cost_0_value(20) then
        winnerswinner1_best_index_0_choices(10, 2) := winnerswinner1_best_index_0_choice(10);
      else
        winnerswinner1_best_index_0_choices(10, 2) := is_set(sums_sum_0(20), 0) and winnersother_cost_0_21_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(10, 2) then
        winnerswinner1_best_index_0_choices(10, 3) := (not winnersother_cost_0_values(20, 2)) and
          winnersother_cost_0_value(21);
      else
        winnerswinner1_best_index_0_choices(10, 3) := (not winnersother_cost_0_values(20, 2)) or
          winnersother_cost_0_value(21);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(10, i) then
          winnerswinner1_best_index_0_choices(10, i + 1) := (not winnersother_cost_0_values(20, i)) or
            winnersother_cost_0_values(21, i - 1);
        else
          winnerswinner1_best_index_0_choices(10, i + 1) := (not winnersother_cost_0_values(20, i)) and
            winnersother_cost_0_values(21, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(10, 6) then
        winnerswinner1_best_index_0_choices(10, 7) := (not winnersother_cost_0_20_value_6) or
          winnersother_cost_0_values(21, 5);
      else
        winnerswinner1_best_index_0_choices(10, 7) := (not winnersother_cost_0_20_value_6) and
          winnersother_cost_0_values(21, 5);
      end if;
      if winnerswinner1_best_index_0_choices(10, 7) then
        winnerswinner1_best_index_0_choices(10, 8) := is_set(sums_sum_0(20), 7) and (not is_set(sums_sum_0(21), 7));
      else
        winnerswinner1_best_index_0_choices(10, 8) := is_set(sums_sum_0(20), 7) or (not is_set(sums_sum_0(21), 7));
      end if;
      if is_set(sums_sum_0(22), 0) then
        winnerswinner1_best_index_0_choice(11) := (not is_set(sums_sum_0(23), 1)) or (not is_set(sums_sum_0(23), 0));
      else
        winnerswinner1_best_index_0_choice(11) := not is_set(sums_sum_0(23), 1);
      end if;
      if winnersother_cost_0_value(22) then
        winnerswinner1_best_index_0_choices(11, 2) := winnerswinner1_best_index_0_choice(11);
      else
        winnerswinner1_best_index_0_choices(11, 2) := is_set(sums_sum_0(22), 0) and winnersother_cost_0_23_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(11, 2) then
        winnerswinner1_best_index_0_choices(11, 3) := (not winnersother_cost_0_values(22, 2)) and
          winnersother_cost_0_value(23);
      else
        winnerswinner1_best_index_0_choices(11, 3) := (not winnersother_cost_0_values(22, 2)) or
          winnersother_cost_0_value(23);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(11, i) then
          winnerswinner1_best_index_0_choices(11, i + 1) := (not winnersother_cost_0_values(22, i)) or
            winnersother_cost_0_values(23, i - 1);
        else
          winnerswinner1_best_index_0_choices(11, i + 1) := (not winnersother_cost_0_values(22, i)) and
            winnersother_cost_0_values(23, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(11, 6) then
        winnerswinner1_best_index_0_choices(11, 7) := (not winnersother_cost_0_22_value_6) or
          winnersother_cost_0_values(23, 5);
      else
        winnerswinner1_best_index_0_choices(11, 7) := (not winnersother_cost_0_22_value_6) and
          winnersother_cost_0_values(23, 5);
      end if;
      if winnerswinner1_best_index_0_choices(11, 7) then
        winnerswinner1_best_index_0_choices(11, 8) := is_set(sums_sum_0(22), 7) and (not is_set(sums_sum_0(23), 7));
      else
        winnerswinner1_best_index_0_choices(11, 8) := is_set(sums_sum_0(22), 7) or (not is_set(sums_sum_0(23), 7));
      end if;
      if is_set(sums_sum_0(24), 0) then
        winnerswinner1_best_index_0_choice(12) := (not is_set(sums_sum_0(25), 1)) or (not is_set(sums_sum_0(25), 0));
      else
        winnerswinner1_best_index_0_choice(12) := not is_set(sums_sum_0(25), 1);
      end if;
      if winnersother_cost_0_value(24) then
        winnerswinner1_best_index_0_choices(12, 2) := winnerswinner1_best_index_0_choice(12);
      else
        winnerswinner1_best_index_0_choices(12, 2) := is_set(sums_sum_0(24), 0) and winnersother_cost_0_25_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(12, 2) then
        winnerswinner1_best_index_0_choices(12, 3) := (not winnersother_cost_0_values(24, 2)) and
          winnersother_cost_0_value(25);
      else
        winnerswinner1_best_index_0_choices(12, 3) := (not winnersother_cost_0_values(24, 2)) or
          winnersother_cost_0_value(25);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(12, i) then
          winnerswinner1_best_index_0_choices(12, i + 1) := (not winnersother_cost_0_values(24, i)) or
            winnersother_cost_0_values(25, i - 1);
        else
          winnerswinner1_best_index_0_choices(12, i + 1) := (not winnersother_cost_0_values(24, i)) and
            winnersother_cost_0_values(25, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(12, 6) then
        winnerswinner1_best_index_0_choices(12, 7) := (not winnersother_cost_0_24_value_6) or
          winnersother_cost_0_values(25, 5);
      else
        winnerswinner1_best_index_0_choices(12, 7) := (not winnersother_cost_0_24_value_6) and
          winnersother_cost_0_values(25, 5);
      end if;
      if winnerswinner1_best_index_0_choices(12, 7) then
        winnerswinner1_best_index_0_choices(12, 8) := is_set(sums_sum_0(24), 7) and (not is_set(sums_sum_0(25), 7));
      else
        winnerswinner1_best_index_0_choices(12, 8) := is_set(sums_sum_0(24), 7) or (not is_set(sums_sum_0(25), 7));
      end if;
      if is_set(sums_sum_0(26), 0) then
        winnerswinner1_best_index_0_choice(13) := (not is_set(sums_sum_0(27), 1)) or (not is_set(sums_sum_0(27), 0));
      else
        winnerswinner1_best_index_0_choice(13) := not is_set(sums_sum_0(27), 1);
      end if;
      if winnersother_cost_0_value(26) then
        winnerswinner1_best_index_0_choices(13, 2) := winnerswinner1_best_index_0_choice(13);
      else
        winnerswinner1_best_index_0_choices(13, 2) := is_set(sums_sum_0(26), 0) and winnersother_cost_0_27_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(13, 2) then
        winnerswinner1_best_index_0_choices(13, 3) := (not winnersother_cost_0_values(26, 2)) and
          winnersother_cost_0_value(27);
      else
        winnerswinner1_best_index_0_choices(13, 3) := (not winnersother_cost_0_values(26, 2)) or
          winnersother_cost_0_value(27);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(13, i) then
          winnerswinner1_best_index_0_choices(13, i + 1) := (not winnersother_cost_0_values(26, i)) or
            winnersother_cost_0_values(27, i - 1);
        else
          winnerswinner1_best_index_0_choices(13, i + 1) := (not winnersother_cost_0_values(26, i)) and
            winnersother_cost_0_values(27, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(13, 6) then
        winnerswinner1_best_index_0_choices(13, 7) := (not winnersother_cost_0_26_value_6) or
          winnersother_cost_0_values(27, 5);
      else
        winnerswinner1_best_index_0_choices(13, 7) := (not winnersother_cost_0_26_value_6) and
          winnersother_cost_0_values(27, 5);
      end if;
      if winnerswinner1_best_index_0_choices(13, 7) then
        winnerswinner1_best_index_0_choices(13, 8) := is_set(sums_sum_0(26), 7) and (not is_set(sums_sum_0(27), 7));
      else
        winnerswinner1_best_index_0_choices(13, 8) := is_set(sums_sum_0(26), 7) or (not is_set(sums_sum_0(27), 7));
      end if;
      if is_set(sums_sum_0(28), 0) then
        winnerswinner1_best_index_0_choice(14) := (not is_set(sums_sum_0(29), 1)) or (not is_set(sums_sum_0(29), 0));
      else
        winnerswinner1_best_index_0_choice(14) := not is_set(sums_sum_0(29), 1);
      end if;
      if winnersother_cost_0_value(28) then
        winnerswinner1_best_index_0_choices(14, 2) := winnerswinner1_best_index_0_choice(14);
      else
        winnerswinner1_best_index_0_choices(14, 2) := is_set(sums_sum_0(28), 0) and winnersother_cost_0_29_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(14, 2) then
        winnerswinner1_best_index_0_choices(14, 3) := (not winnersother_cost_0_values(28, 2)) and
          winnersother_cost_0_value(29);
      else
        winnerswinner1_best_index_0_choices(14, 3) := (not winnersother_cost_0_values(28, 2)) or
          winnersother_cost_0_value(29);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(14, i) then
          winnerswinner1_best_index_0_choices(14, i + 1) := (not winnersother_cost_0_values(28, i)) or
            winnersother_cost_0_values(29, i - 1);
        else
          winnerswinner1_best_index_0_choices(14, i + 1) := (not winnersother_cost_0_values(28, i)) and
            winnersother_cost_0_values(29, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(14, 6) then
        winnerswinner1_best_index_0_choices(14, 7) := (not winnersother_cost_0_28_value_6) or
          winnersother_cost_0_values(29, 5);
      else
        winnerswinner1_best_index_0_choices(14, 7) := (not winnersother_cost_0_28_value_6) and
          winnersother_cost_0_values(29, 5);
      end if;
      if winnerswinner1_best_index_0_choices(14, 7) then
        winnerswinner1_best_index_0_choices(14, 8) := is_set(sums_sum_0(28), 7) and (not is_set(sums_sum_0(29), 7));
      else
        winnerswinner1_best_index_0_choices(14, 8) := is_set(sums_sum_0(28), 7) or (not is_set(sums_sum_0(29), 7));
      end if;
      if is_set(sums_sum_0(30), 0) then
        winnerswinner1_best_index_0_choice(15) := (not is_set(sums_sum_0(31), 1)) or (not is_set(sums_sum_0(31), 0));
      else
        winnerswinner1_best_index_0_choice(15) := not is_set(sums_sum_0(31), 1);
      end if;
      if winnersother_cost_0_value(30) then
        winnerswinner1_best_index_0_choices(15, 2) := winnerswinner1_best_index_0_choice(15);
      else
        winnerswinner1_best_index_0_choices(15, 2) := is_set(sums_sum_0(30), 0) and winnersother_cost_0_31_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(15, 2) then
        winnerswinner1_best_index_0_choices(15, 3) := (not winnersother_cost_0_values(30, 2)) and
          winnersother_cost_0_value(31);
      else
        winnerswinner1_best_index_0_choices(15, 3) := (not winnersother_cost_0_values(30, 2)) or
          winnersother_cost_0_value(31);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(15, i) then
          winnerswinner1_best_index_0_choices(15, i + 1) := (not winnersother_cost_0_values(30, i)) or
            winnersother_cost_0_values(31, i - 1);
        else
          winnerswinner1_best_index_0_choices(15, i + 1) := (not winnersother_cost_0_values(30, i)) and
            winnersother_cost_0_values(31, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(15, 6) then
        winnerswinner1_best_index_0_choices(15, 7) := (not winnersother_cost_0_30_value_6) or
          winnersother_cost_0_values(31, 5);
      else
        winnerswinner1_best_index_0_choices(15, 7) := (not winnersother_cost_0_30_value_6) and
          winnersother_cost_0_values(31, 5);
      end if;
      if winnerswinner1_best_index_0_choices(15, 7) then
        winnerswinner1_best_index_0_choices(15, 8) := is_set(sums_sum_0(30), 7) and (not is_set(sums_sum_0(31), 7));
      else
        winnerswinner1_best_index_0_choices(15, 8) := is_set(sums_sum_0(30), 7) or (not is_set(sums_sum_0(31), 7));
      end if;
      if is_set(sums_sum_0(32), 0) then
        winnerswinner1_best_index_0_choice(16) := (not is_set(sums_sum_0(33), 1)) or (not is_set(sums_sum_0(33), 0));
      else
        winnerswinner1_best_index_0_choice(16) := not is_set(sums_sum_0(33), 1);
      end if;
      if winnersother_cost_0_value(32) then
        winnerswinner1_best_index_0_choices(16, 2) := winnerswinner1_best_index_0_choice(16);
      else
        winnerswinner1_best_index_0_choices(16, 2) := is_set(sums_sum_0(32), 0) and winnersother_cost_0_33_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(16, 2) then
        winnerswinner1_best_index_0_choices(16, 3) := (not winnersother_cost_0_values(32, 2)) and
          winnersother_cost_0_value(33);
      else
        winnerswinner1_best_index_0_choices(16, 3) := (not winnersother_cost_0_values(32, 2)) or
          winnersother_cost_0_value(33);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(16, i) then
          winnerswinner1_best_index_0_choices(16, i + 1) := (not winnersother_cost_0_values(32, i)) or
            winnersother_cost_0_values(33, i - 1);
        else
          winnerswinner1_best_index_0_choices(16, i + 1) := (not winnersother_cost_0_values(32, i)) and
            winnersother_cost_0_values(33, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(16, 6) then
        winnerswinner1_best_index_0_choices(16, 7) := (not winnersother_cost_0_32_value_6) or
          winnersother_cost_0_values(33, 5);
      else
        winnerswinner1_best_index_0_choices(16, 7) := (not winnersother_cost_0_32_value_6) and
          winnersother_cost_0_values(33, 5);
      end if;
      if winnerswinner1_best_index_0_choices(16, 7) then
        winnerswinner1_best_index_0_choices(16, 8) := is_set(sums_sum_0(32), 7) and (not is_set(sums_sum_0(33), 7));
      else
        winnerswinner1_best_index_0_choices(16, 8) := is_set(sums_sum_0(32), 7) or (not is_set(sums_sum_0(33), 7));
      end if;
      if is_set(sums_sum_0(34), 0) then
        winnerswinner1_best_index_0_choice(17) := (not is_set(sums_sum_0(35), 1)) or (not is_set(sums_sum_0(35), 0));
      else
        winnerswinner1_best_index_0_choice(17) := not is_set(sums_sum_0(35), 1);
      end if;
      if winnersother_cost_0_value(34) then
        winnerswinner1_best_index_0_choices(17, 2) := winnerswinner1_best_index_0_choice(17);
      else
        winnerswinner1_best_index_0_choices(17, 2) := is_set(sums_sum_0(34), 0) and winnersother_cost_0_35_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(17, 2) then
        winnerswinner1_best_index_0_choices(17, 3) := (not winnersother_cost_0_values(34, 2)) and
          winnersother_cost_0_value(35);
      else
        winnerswinner1_best_index_0_choices(17, 3) := (not winnersother_cost_0_values(34, 2)) or
          winnersother_cost_0_value(35);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(17, i) then
          winnerswinner1_best_index_0_choices(17, i + 1) := (not winnersother_cost_0_values(34, i)) or
            winnersother_cost_0_values(35, i - 1);
        else
          winnerswinner1_best_index_0_choices(17, i + 1) := (not winnersother_cost_0_values(34, i)) and
            winnersother_cost_0_values(35, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(17, 6) then
        winnerswinner1_best_index_0_choices(17, 7) := (not winnersother_cost_0_34_value_6) or
          winnersother_cost_0_values(35, 5);
      else
        winnerswinner1_best_index_0_choices(17, 7) := (not winnersother_cost_0_34_value_6) and
          winnersother_cost_0_values(35, 5);
      end if;
      if winnerswinner1_best_index_0_choices(17, 7) then
        winnerswinner1_best_index_0_choices(17, 8) := is_set(sums_sum_0(34), 7) and (not is_set(sums_sum_0(35), 7));
      else
        winnerswinner1_best_index_0_choices(17, 8) := is_set(sums_sum_0(34), 7) or (not is_set(sums_sum_0(35), 7));
      end if;
      if is_set(sums_sum_0(36), 0) then
        winnerswinner1_best_index_0_choice(18) := (not is_set(sums_sum_0(37), 1)) or (not is_set(sums_sum_0(37), 0));
      else
        winnerswinner1_best_index_0_choice(18) := not is_set(sums_sum_0(37), 1);
      end if;
      if winnersother_cost_0_value(36) then
        winnerswinner1_best_index_0_choices(18, 2) := winnerswinner1_best_index_0_choice(18);
      else
        winnerswinner1_best_index_0_choices(18, 2) := is_set(sums_sum_0(36), 0) and winnersother_cost_0_37_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(18, 2) then
        winnerswinner1_best_index_0_choices(18, 3) := (not winnersother_cost_0_values(36, 2)) and
          winnersother_cost_0_value(37);
      else
        winnerswinner1_best_index_0_choices(18, 3) := (not winnersother_cost_0_values(36, 2)) or
          winnersother_cost_0_value(37);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(18, i) then
          winnerswinner1_best_index_0_choices(18, i + 1) := (not winnersother_cost_0_values(36, i)) or
            winnersother_cost_0_values(37, i - 1);
        else
          winnerswinner1_best_index_0_choices(18, i + 1) := (not winnersother_cost_0_values(36, i)) and
            winnersother_cost_0_values(37, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(18, 6) then
        winnerswinner1_best_index_0_choices(18, 7) := (not winnersother_cost_0_36_value_6) or
          winnersother_cost_0_values(37, 5);
      else
        winnerswinner1_best_index_0_choices(18, 7) := (not winnersother_cost_0_36_value_6) and
          winnersother_cost_0_values(37, 5);
      end if;
      if winnerswinner1_best_index_0_choices(18, 7) then
        winnerswinner1_best_index_0_choices(18, 8) := is_set(sums_sum_0(36), 7) and (not is_set(sums_sum_0(37), 7));
      else
        winnerswinner1_best_index_0_choices(18, 8) := is_set(sums_sum_0(36), 7) or (not is_set(sums_sum_0(37), 7));
      end if;
      if is_set(sums_sum_0(38), 0) then
        winnerswinner1_best_index_0_choice(19) := (not is_set(sums_sum_0(39), 1)) or (not is_set(sums_sum_0(39), 0));
      else
        winnerswinner1_best_index_0_choice(19) := not is_set(sums_sum_0(39), 1);
      end if;
      if winnersother_cost_0_value(38) then
        winnerswinner1_best_index_0_choices(19, 2) := winnerswinner1_best_index_0_choice(19);
      else
        winnerswinner1_best_index_0_choices(19, 2) := is_set(sums_sum_0(38), 0) and winnersother_cost_0_39_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(19, 2) then
        winnerswinner1_best_index_0_choices(19, 3) := (not winnersother_cost_0_values(38, 2)) and
          winnersother_cost_0_value(39);
      else
        winnerswinner1_best_index_0_choices(19, 3) := (not winnersother_cost_0_values(38, 2)) or
          winnersother_cost_0_value(39);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(19, i) then
          winnerswinner1_best_index_0_choices(19, i + 1) := (not winnersother_cost_0_values(38, i)) or
            winnersother_cost_0_values(39, i - 1);
        else
          winnerswinner1_best_index_0_choices(19, i + 1) := (not winnersother_cost_0_values(38, i)) and
            winnersother_cost_0_values(39, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(19, 6) then
        winnerswinner1_best_index_0_choices(19, 7) := (not winnersother_cost_0_38_value_6) or
          winnersother_cost_0_values(39, 5);
      else
        winnerswinner1_best_index_0_choices(19, 7) := (not winnersother_cost_0_38_value_6) and
          winnersother_cost_0_values(39, 5);
      end if;
      if winnerswinner1_best_index_0_choices(19, 7) then
        winnerswinner1_best_index_0_choices(19, 8) := is_set(sums_sum_0(38), 7) and (not is_set(sums_sum_0(39), 7));
      else
        winnerswinner1_best_index_0_choices(19, 8) := is_set(sums_sum_0(38), 7) or (not is_set(sums_sum_0(39), 7));
      end if;
      if is_set(sums_sum_0(40), 0) then
        winnerswinner1_best_index_0_choice(20) := (not is_set(sums_sum_0(41), 1)) or (not is_set(sums_sum_0(41), 0));
      else
        winnerswinner1_best_index_0_choice(20) := not is_set(sums_sum_0(41), 1);
      end if;
      if winnersother_cost_0_value(40) then
        winnerswinner1_best_index_0_choices(20, 2) := winnerswinner1_best_index_0_choice(20);
      else
        winnerswinner1_best_index_0_choices(20, 2) := is_set(sums_sum_0(40), 0) and winnersother_cost_0_41_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(20, 2) then
        winnerswinner1_best_index_0_choices(20, 3) := (not winnersother_cost_0_values(40, 2)) and
          winnersother_cost_0_value(41);
      else
        winnerswinner1_best_index_0_choices(20, 3) := (not winnersother_cost_0_values(40, 2)) or
          winnersother_cost_0_value(41);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(20, i) then
          winnerswinner1_best_index_0_choices(20, i + 1) := (not winnersother_cost_0_values(40, i)) or
            winnersother_cost_0_values(41, i - 1);
        else
          winnerswinner1_best_index_0_choices(20, i + 1) := (not winnersother_cost_0_values(40, i)) and
            winnersother_cost_0_values(41, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(20, 6) then
        winnerswinner1_best_index_0_choices(20, 7) := (not winnersother_cost_0_40_value_6) or
          winnersother_cost_0_values(41, 5);
      else
        winnerswinner1_best_index_0_choices(20, 7) := (not winnersother_cost_0_40_value_6) and
          winnersother_cost_0_values(41, 5);
      end if;
      if winnerswinner1_best_index_0_choices(20, 7) then
        winnerswinner1_best_index_0_choices(20, 8) := is_set(sums_sum_0(40), 7) and (not is_set(sums_sum_0(41), 7));
      else
        winnerswinner1_best_index_0_choices(20, 8) := is_set(sums_sum_0(40), 7) or (not is_set(sums_sum_0(41), 7));
      end if;
      if is_set(sums_sum_0(42), 0) then
        winnerswinner1_best_index_0_choice(21) := (not is_set(sums_sum_0(43), 1)) or (not is_set(sums_sum_0(43), 0));
      else
        winnerswinner1_best_index_0_choice(21) := not is_set(sums_sum_0(43), 1);
      end if;
      if winnersother_cost_0_value(42) then
        winnerswinner1_best_index_0_choices(21, 2) := winnerswinner1_best_index_0_choice(21);
      else
        winnerswinner1_best_index_0_choices(21, 2) := is_set(sums_sum_0(42), 0) and winnersother_cost_0_43_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(21, 2) then
        winnerswinner1_best_index_0_choices(21, 3) := (not winnersother_cost_0_values(42, 2)) and
          winnersother_cost_0_value(43);
      else
        winnerswinner1_best_index_0_choices(21, 3) := (not winnersother_cost_0_values(42, 2)) or
          winnersother_cost_0_value(43);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(21, i) then
          winnerswinner1_best_index_0_choices(21, i + 1) := (not winnersother_cost_0_values(42, i)) or
            winnersother_cost_0_values(43, i - 1);
        else
          winnerswinner1_best_index_0_choices(21, i + 1) := (not winnersother_cost_0_values(42, i)) and
            winnersother_cost_0_values(43, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(21, 6) then
        winnerswinner1_best_index_0_choices(21, 7) := (not winnersother_cost_0_42_value_6) or
          winnersother_cost_0_values(43, 5);
      else
        winnerswinner1_best_index_0_choices(21, 7) := (not winnersother_cost_0_42_value_6) and
          winnersother_cost_0_values(43, 5);
      end if;
      if winnerswinner1_best_index_0_choices(21, 7) then
        winnerswinner1_best_index_0_choices(21, 8) := is_set(sums_sum_0(42), 7) and (not is_set(sums_sum_0(43), 7));
      else
        winnerswinner1_best_index_0_choices(21, 8) := is_set(sums_sum_0(42), 7) or (not is_set(sums_sum_0(43), 7));
      end if;
      if is_set(sums_sum_0(44), 0) then
        winnerswinner1_best_index_0_choice(22) := (not is_set(sums_sum_0(45), 1)) or (not is_set(sums_sum_0(45), 0));
      else
        winnerswinner1_best_index_0_choice(22) := not is_set(sums_sum_0(45), 1);
      end if;
      if winnersother_cost_0_value(44) then
        winnerswinner1_best_index_0_choices(22, 2) := winnerswinner1_best_index_0_choice(22);
      else
        winnerswinner1_best_index_0_choices(22, 2) := is_set(sums_sum_0(44), 0) and winnersother_cost_0_45_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(22, 2) then
        winnerswinner1_best_index_0_choices(22, 3) := (not winnersother_cost_0_values(44, 2)) and
          winnersother_cost_0_value(45);
      else
        winnerswinner1_best_index_0_choices(22, 3) := (not winnersother_cost_0_values(44, 2)) or
          winnersother_cost_0_value(45);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(22, i) then
          winnerswinner1_best_index_0_choices(22, i + 1) := (not winnersother_cost_0_values(44, i)) or
            winnersother_cost_0_values(45, i - 1);
        else
          winnerswinner1_best_index_0_choices(22, i + 1) := (not winnersother_cost_0_values(44, i)) and
            winnersother_cost_0_values(45, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(22, 6) then
        winnerswinner1_best_index_0_choices(22, 7) := (not winnersother_cost_0_44_value_6) or
          winnersother_cost_0_values(45, 5);
      else
        winnerswinner1_best_index_0_choices(22, 7) := (not winnersother_cost_0_44_value_6) and
          winnersother_cost_0_values(45, 5);
      end if;
      if winnerswinner1_best_index_0_choices(22, 7) then
        winnerswinner1_best_index_0_choices(22, 8) := is_set(sums_sum_0(44), 7) and (not is_set(sums_sum_0(45), 7));
      else
        winnerswinner1_best_index_0_choices(22, 8) := is_set(sums_sum_0(44), 7) or (not is_set(sums_sum_0(45), 7));
      end if;
      if is_set(sums_sum_0(46), 0) then
        winnerswinner1_best_index_0_choice(23) := (not is_set(sums_sum_0(47), 1)) or (not is_set(sums_sum_0(47), 0));
      else
        winnerswinner1_best_index_0_choice(23) := not is_set(sums_sum_0(47), 1);
      end if;
      if winnersother_cost_0_value(46) then
        winnerswinner1_best_index_0_choices(23, 2) := winnerswinner1_best_index_0_choice(23);
      else
        winnerswinner1_best_index_0_choices(23, 2) := is_set(sums_sum_0(46), 0) and winnersother_cost_0_47_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(23, 2) then
        winnerswinner1_best_index_0_choices(23, 3) := (not winnersother_cost_0_values(46, 2)) and
          winnersother_cost_0_value(47);
      else
        winnerswinner1_best_index_0_choices(23, 3) := (not winnersother_cost_0_values(46, 2)) or
          winnersother_cost_0_value(47);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(23, i) then
          winnerswinner1_best_index_0_choices(23, i + 1) := (not winnersother_cost_0_values(46, i)) or
            winnersother_cost_0_values(47, i - 1);
        else
          winnerswinner1_best_index_0_choices(23, i + 1) := (not winnersother_cost_0_values(46, i)) and
            winnersother_cost_0_values(47, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(23, 6) then
        winnerswinner1_best_index_0_choices(23, 7) := (not winnersother_cost_0_46_value_6) or
          winnersother_cost_0_values(47, 5);
      else
        winnerswinner1_best_index_0_choices(23, 7) := (not winnersother_cost_0_46_value_6) and
          winnersother_cost_0_values(47, 5);
      end if;
      if winnerswinner1_best_index_0_choices(23, 7) then
        winnerswinner1_best_index_0_choices(23, 8) := is_set(sums_sum_0(46), 7) and (not is_set(sums_sum_0(47), 7));
      else
        winnerswinner1_best_index_0_choices(23, 8) := is_set(sums_sum_0(46), 7) or (not is_set(sums_sum_0(47), 7));
      end if;
      if is_set(sums_sum_0(48), 0) then
        winnerswinner1_best_index_0_choice(24) := (not is_set(sums_sum_0(49), 1)) or (not is_set(sums_sum_0(49), 0));
      else
        winnerswinner1_best_index_0_choice(24) := not is_set(sums_sum_0(49), 1);
      end if;
      if winnersother_cost_0_value(48) then
        winnerswinner1_best_index_0_choices(24, 2) := winnerswinner1_best_index_0_choice(24);
      else
        winnerswinner1_best_index_0_choices(24, 2) := is_set(sums_sum_0(48), 0) and winnersother_cost_0_49_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(24, 2) then
        winnerswinner1_best_index_0_choices(24, 3) := (not winnersother_cost_0_values(48, 2)) and
          winnersother_cost_0_value(49);
      else
        winnerswinner1_best_index_0_choices(24, 3) := (not winnersother_cost_0_values(48, 2)) or
          winnersother_cost_0_value(49);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(24, i) then
          winnerswinner1_best_index_0_choices(24, i + 1) := (not winnersother_cost_0_values(48, i)) or
            winnersother_cost_0_values(49, i - 1);
        else
          winnerswinner1_best_index_0_choices(24, i + 1) := (not winnersother_cost_0_values(48, i)) and
            winnersother_cost_0_values(49, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(24, 6) then
        winnerswinner1_best_index_0_choices(24, 7) := (not winnersother_cost_0_48_value_6) or
          winnersother_cost_0_values(49, 5);
      else
        winnerswinner1_best_index_0_choices(24, 7) := (not winnersother_cost_0_48_value_6) and
          winnersother_cost_0_values(49, 5);
      end if;
      if winnerswinner1_best_index_0_choices(24, 7) then
        winnerswinner1_best_index_0_choices(24, 8) := is_set(sums_sum_0(48), 7) and (not is_set(sums_sum_0(49), 7));
      else
        winnerswinner1_best_index_0_choices(24, 8) := is_set(sums_sum_0(48), 7) or (not is_set(sums_sum_0(49), 7));
      end if;
      if is_set(sums_sum_0(50), 0) then
        winnerswinner1_best_index_0_choice(25) := (not is_set(sums_sum_0(51), 1)) or (not is_set(sums_sum_0(51), 0));
      else
        winnerswinner1_best_index_0_choice(25) := not is_set(sums_sum_0(51), 1);
      end if;
      if winnersother_cost_0_value(50) then
        winnerswinner1_best_index_0_choices(25, 2) := winnerswinner1_best_index_0_choice(25);
      else
        winnerswinner1_best_index_0_choices(25, 2) := is_set(sums_sum_0(50), 0) and winnersother_cost_0_51_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(25, 2) then
        winnerswinner1_best_index_0_choices(25, 3) := (not winnersother_cost_0_values(50, 2)) and
          winnersother_cost_0_value(51);
      else
        winnerswinner1_best_index_0_choices(25, 3) := (not winnersother_cost_0_values(50, 2)) or
          winnersother_cost_0_value(51);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(25, i) then
          winnerswinner1_best_index_0_choices(25, i + 1) := (not winnersother_cost_0_values(50, i)) or
            winnersother_cost_0_values(51, i - 1);
        else
          winnerswinner1_best_index_0_choices(25, i + 1) := (not winnersother_cost_0_values(50, i)) and
            winnersother_cost_0_values(51, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(25, 6) then
        winnerswinner1_best_index_0_choices(25, 7) := (not winnersother_cost_0_50_value_6) or
          winnersother_cost_0_values(51, 5);
      else
        winnerswinner1_best_index_0_choices(25, 7) := (not winnersother_cost_0_50_value_6) and
          winnersother_cost_0_values(51, 5);
      end if;
      if winnerswinner1_best_index_0_choices(25, 7) then
        winnerswinner1_best_index_0_choices(25, 8) := is_set(sums_sum_0(50), 7) and (not is_set(sums_sum_0(51), 7));
      else
        winnerswinner1_best_index_0_choices(25, 8) := is_set(sums_sum_0(50), 7) or (not is_set(sums_sum_0(51), 7));
      end if;
      if is_set(sums_sum_0(52), 0) then
        winnerswinner1_best_index_0_choice(26) := (not is_set(sums_sum_0(53), 1)) or (not is_set(sums_sum_0(53), 0));
      else
        winnerswinner1_best_index_0_choice(26) := not is_set(sums_sum_0(53), 1);
      end if;
      if winnersother_cost_0_value(52) then
        winnerswinner1_best_index_0_choices(26, 2) := winnerswinner1_best_index_0_choice(26);
      else
        winnerswinner1_best_index_0_choices(26, 2) := is_set(sums_sum_0(52), 0) and winnersother_cost_0_53_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(26, 2) then
        winnerswinner1_best_index_0_choices(26, 3) := (not winnersother_cost_0_values(52, 2)) and
          winnersother_cost_0_value(53);
      else
        winnerswinner1_best_index_0_choices(26, 3) := (not winnersother_cost_0_values(52, 2)) or
          winnersother_cost_0_value(53);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(26, i) then
          winnerswinner1_best_index_0_choices(26, i + 1) := (not winnersother_cost_0_values(52, i)) or
            winnersother_cost_0_values(53, i - 1);
        else
          winnerswinner1_best_index_0_choices(26, i + 1) := (not winnersother_cost_0_values(52, i)) and
            winnersother_cost_0_values(53, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(26, 6) then
        winnerswinner1_best_index_0_choices(26, 7) := (not winnersother_cost_0_52_value_6) or
          winnersother_cost_0_values(53, 5);
      else
        winnerswinner1_best_index_0_choices(26, 7) := (not winnersother_cost_0_52_value_6) and
          winnersother_cost_0_values(53, 5);
      end if;
      if winnerswinner1_best_index_0_choices(26, 7) then
        winnerswinner1_best_index_0_choices(26, 8) := is_set(sums_sum_0(52), 7) and (not is_set(sums_sum_0(53), 7));
      else
        winnerswinner1_best_index_0_choices(26, 8) := is_set(sums_sum_0(52), 7) or (not is_set(sums_sum_0(53), 7));
      end if;
      if is_set(sums_sum_0(54), 0) then
        winnerswinner1_best_index_0_choice(27) := (not is_set(sums_sum_0(55), 1)) or (not is_set(sums_sum_0(55), 0));
      else
        winnerswinner1_best_index_0_choice(27) := not is_set(sums_sum_0(55), 1);
      end if;
      if winnersother_cost_0_value(54) then
        winnerswinner1_best_index_0_choices(27, 2) := winnerswinner1_best_index_0_choice(27);
      else
        winnerswinner1_best_index_0_choices(27, 2) := is_set(sums_sum_0(54), 0) and winnersother_cost_0_55_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(27, 2) then
        winnerswinner1_best_index_0_choices(27, 3) := (not winnersother_cost_0_values(54, 2)) and
          winnersother_cost_0_value(55);
      else
        winnerswinner1_best_index_0_choices(27, 3) := (not winnersother_cost_0_values(54, 2)) or
          winnersother_cost_0_value(55);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(27, i) then
          winnerswinner1_best_index_0_choices(27, i + 1) := (not winnersother_cost_0_values(54, i)) or
            winnersother_cost_0_values(55, i - 1);
        else
          winnerswinner1_best_index_0_choices(27, i + 1) := (not winnersother_cost_0_values(54, i)) and
            winnersother_cost_0_values(55, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(27, 6) then
        winnerswinner1_best_index_0_choices(27, 7) := (not winnersother_cost_0_54_value_6) or
          winnersother_cost_0_values(55, 5);
      else
        winnerswinner1_best_index_0_choices(27, 7) := (not winnersother_cost_0_54_value_6) and
          winnersother_cost_0_values(55, 5);
      end if;
      if winnerswinner1_best_index_0_choices(27, 7) then
        winnerswinner1_best_index_0_choices(27, 8) := is_set(sums_sum_0(54), 7) and (not is_set(sums_sum_0(55), 7));
      else
        winnerswinner1_best_index_0_choices(27, 8) := is_set(sums_sum_0(54), 7) or (not is_set(sums_sum_0(55), 7));
      end if;
      if is_set(sums_sum_0(56), 0) then
        winnerswinner1_best_index_0_choice(28) := (not is_set(sums_sum_0(57), 1)) or (not is_set(sums_sum_0(57), 0));
      else
        winnerswinner1_best_index_0_choice(28) := not is_set(sums_sum_0(57), 1);
      end if;
      if winnersother_cost_0_value(56) then
        winnerswinner1_best_index_0_choices(28, 2) := winnerswinner1_best_index_0_choice(28);
      else
        winnerswinner1_best_index_0_choices(28, 2) := is_set(sums_sum_0(56), 0) and winnersother_cost_0_57_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(28, 2) then
        winnerswinner1_best_index_0_choices(28, 3) := (not winnersother_cost_0_values(56, 2)) and
          winnersother_cost_0_value(57);
      else
        winnerswinner1_best_index_0_choices(28, 3) := (not winnersother_cost_0_values(56, 2)) or
          winnersother_cost_0_value(57);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(28, i) then
          winnerswinner1_best_index_0_choices(28, i + 1) := (not winnersother_cost_0_values(56, i)) or
            winnersother_cost_0_values(57, i - 1);
        else
          winnerswinner1_best_index_0_choices(28, i + 1) := (not winnersother_cost_0_values(56, i)) and
            winnersother_cost_0_values(57, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(28, 6) then
        winnerswinner1_best_index_0_choices(28, 7) := (not winnersother_cost_0_56_value_6) or
          winnersother_cost_0_values(57, 5);
      else
        winnerswinner1_best_index_0_choices(28, 7) := (not winnersother_cost_0_56_value_6) and
          winnersother_cost_0_values(57, 5);
      end if;
      if winnerswinner1_best_index_0_choices(28, 7) then
        winnerswinner1_best_index_0_choices(28, 8) := is_set(sums_sum_0(56), 7) and (not is_set(sums_sum_0(57), 7));
      else
        winnerswinner1_best_index_0_choices(28, 8) := is_set(sums_sum_0(56), 7) or (not is_set(sums_sum_0(57), 7));
      end if;
      if is_set(sums_sum_0(58), 0) then
        winnerswinner1_best_index_0_choice(29) := (not is_set(sums_sum_0(59), 1)) or (not is_set(sums_sum_0(59), 0));
      else
        winnerswinner1_best_index_0_choice(29) := not is_set(sums_sum_0(59), 1);
      end if;
      if winnersother_cost_0_value(58) then
        winnerswinner1_best_index_0_choices(29, 2) := winnerswinner1_best_index_0_choice(29);
      else
        winnerswinner1_best_index_0_choices(29, 2) := is_set(sums_sum_0(58), 0) and winnersother_cost_0_59_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(29, 2) then
        winnerswinner1_best_index_0_choices(29, 3) := (not winnersother_cost_0_values(58, 2)) and
          winnersother_cost_0_value(59);
      else
        winnerswinner1_best_index_0_choices(29, 3) := (not winnersother_cost_0_values(58, 2)) or
          winnersother_cost_0_value(59);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(29, i) then
          winnerswinner1_best_index_0_choices(29, i + 1) := (not winnersother_cost_0_values(58, i)) or
            winnersother_cost_0_values(59, i - 1);
        else
          winnerswinner1_best_index_0_choices(29, i + 1) := (not winnersother_cost_0_values(58, i)) and
            winnersother_cost_0_values(59, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(29, 6) then
        winnerswinner1_best_index_0_choices(29, 7) := (not winnersother_cost_0_58_value_6) or
          winnersother_cost_0_values(59, 5);
      else
        winnerswinner1_best_index_0_choices(29, 7) := (not winnersother_cost_0_58_value_6) and
          winnersother_cost_0_values(59, 5);
      end if;
      if winnerswinner1_best_index_0_choices(29, 7) then
        winnerswinner1_best_index_0_choices(29, 8) := is_set(sums_sum_0(58), 7) and (not is_set(sums_sum_0(59), 7));
      else
        winnerswinner1_best_index_0_choices(29, 8) := is_set(sums_sum_0(58), 7) or (not is_set(sums_sum_0(59), 7));
      end if;
      if is_set(sums_sum_0(60), 0) then
        winnerswinner1_best_index_0_choice(30) := (not is_set(sums_sum_0(61), 1)) or (not is_set(sums_sum_0(61), 0));
      else
        winnerswinner1_best_index_0_choice(30) := not is_set(sums_sum_0(61), 1);
      end if;
      if winnersother_cost_0_value(60) then
        winnerswinner1_best_index_0_choices(30, 2) := winnerswinner1_best_index_0_choice(30);
      else
        winnerswinner1_best_index_0_choices(30, 2) := is_set(sums_sum_0(60), 0) and winnersother_cost_0_61_is_equal;
      end if;
      if winnerswinner1_best_index_0_choices(30, 2) then
        winnerswinner1_best_index_0_choices(30, 3) := (not winnersother_cost_0_values(60, 2)) and
          winnersother_cost_0_value(61);
      else
        winnerswinner1_best_index_0_choices(30, 3) := (not winnersother_cost_0_values(60, 2)) or
          winnersother_cost_0_value(61);
      end if;
      for i in 3 to 5 loop
        if winnerswinner1_best_index_0_choices(30, i) then
          winnerswinner1_best_index_0_choices(30, i + 1) := (not winnersother_cost_0_values(60, i)) or
            winnersother_cost_0_values(61, i - 1);
        else
          winnerswinner1_best_index_0_choices(30, i + 1) := (not winnersother_cost_0_values(60, i)) and
            winnersother_cost_0_values(61, i - 1);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(30, 6) then
        winnerswinner1_best_index_0_choices(30, 7) := (not winnersother_cost_0_60_value_6) or
          winnersother_cost_0_values(61, 5);
      else
        winnerswinner1_best_index_0_choices(30, 7) := (not winnersother_cost_0_60_value_6) and
          winnersother_cost_0_values(61, 5);
      end if;
      if winnerswinner1_best_index_0_choices(30, 7) then
        winnerswinner1_best_index_0_choices(30, 8) := is_set(sums_sum_0(60), 7) and (not is_set(sums_sum_0(61), 7));
      else
        winnerswinner1_best_index_0_choices(30, 8) := is_set(sums_sum_0(60), 7) or (not is_set(sums_sum_0(61), 7));
      end if;
      if is_set(sums_sum_0(62), 0) then
        winnerswinner1_best_index_0_choice(31) := (not is_set(sums_sum_0(63), 1)) or (not is_set(sums_sum_0(63), 0));
      else
        winnerswinner1_best_index_0_choice(31) := not is_set(sums_sum_0(63), 1);
      end if;
      if winnersother_cost_0_value(62) then
        winnerswinner1_best_index_0_choices(31, 2) := winnerswinner1_best_index_0_choice(31);
      else
        winnerswinner1_best_index_0_choices(31, 2) := is_set(sums_sum_0(62), 0) and ((sums_sum_0(63) mod 4) = 0);
      end if;
      winnerswinner1_best_index_0_31_value := is_set(sums_sum_0(63), 2);
      if winnerswinner1_best_index_0_choices(31, 2) then
        winnerswinner1_best_index_0_choices(31, 3) := (not winnersother_cost_0_values(62, 2)) and
          winnerswinner1_best_index_0_31_value;
      else
        winnerswinner1_best_index_0_choices(31, 3) := (not winnersother_cost_0_values(62, 2)) or
          winnerswinner1_best_index_0_31_value;
      end if;
      for i in 2 to 4 loop
        winnerswinner1_best_index_0_31_values(i) := is_set(sums_sum_0(63), i + 1);
        if winnerswinner1_best_index_0_choices(31, i + 1) then
          winnerswinner1_best_index_0_choices(31, i + 2) := (not winnersother_cost_0_values(62, i + 1)) or
            winnerswinner1_best_index_0_31_values(i);
        else
          winnerswinner1_best_index_0_choices(31, i + 2) := (not winnersother_cost_0_values(62, i + 1)) and
            winnerswinner1_best_index_0_31_values(i);
        end if;
      end loop;
      winnerswinner1_best_index_0_31_values(5) := is_set(sums_sum_0(63), 6);
      if winnerswinner1_best_index_0_choices(31, 6) then
        winnerswinner1_best_index_0_choices(31, 7) := (not winnersother_cost_0_62_value_6) or
          winnerswinner1_best_index_0_31_values(5);
      else
        winnerswinner1_best_index_0_choices(31, 7) := (not winnersother_cost_0_62_value_6) and
          winnerswinner1_best_index_0_31_values(5);
      end if;
      if winnerswinner1_best_index_0_choices(31, 7) then
        winnerswinner1_best_index_0_choices(31, 8) := is_set(sums_sum_0(62), 7) and (not is_set(sums_sum_0(63), 7));
      else
        winnerswinner1_best_index_0_choices(31, 8) := is_set(sums_sum_0(62), 7) or (not is_set(sums_sum_0(63), 7));
      end if;
      for i in 0 to 63 loop
        winnerswinner1_held_0(i) <= sums_sum_0(i);
      end loop;
      winnerswinner1_best_index_0_0 <= winnerswinner1_best_index_0_choices(0, 8);
      winnerswinner1_best_place_0_2 <= winnerswinner1_best_index_0_choices(2, 8);
      winnerswinner1_best_place_0_4 <= winnerswinner1_best_index_0_choices(4, 8);
      winnerswinner1_best_place_0_6 <= winnerswinner1_best_index_0_choices(6, 8);
      winnerswinner1_best_place_0_8 <= winnerswinner1_best_index_0_choices(8, 8);
      winnerswinner1_best_place_0_10 <= winnerswinner1_best_index_0_choices(10, 8);
      winnerswinner1_best_place_0_12 <= winnerswinner1_best_index_0_choices(12, 8);
      winnerswinner1_best_place_0_14 <= winnerswinner1_best_index_0_choices(14, 8);
      winnerswinner1_best_place_0_16 <= winnerswinner1_best_index_0_choices(16, 8);
      winnerswinner1_best_place_0_18 <= winnerswinner1_best_index_0_choices(18, 8);
      winnerswinner1_best_place_0_20 <= winnerswinner1_best_index_0_choices(20, 8);
      winnerswinner1_best_place_0_22 <= winnerswinner1_best_index_0_choices(22, 8);
      winnerswinner1_best_place_0_24 <= winnerswinner1_best_index_0_choices(24, 8);
      winnerswinner1_best_place_0_26 <= winnerswinner1_best_index_0_choices(26, 8);
      winnerswinner1_best_place_0_28 <= winnerswinner1_best_index_0_choices(28, 8);
      winnerswinner1_best_place_0_30 <= winnerswinner1_best_index_0_choices(30, 8);
      for i in 0 to 31 loop
        winnerswinner1_best_late_cost_0(i) <= winnerswinner1_best_cost_0(i);
      end loop;
      for i in 1 to 31 loop
        winnerswinner1_best_but_first_0(i) <= winnerswinner1_held_0(2 * i + 1);
      end loop;
      for i in 0 to 30 loop
        winnerswinner1_best_but_last_0(i) <= winnerswinner1_held_0(2 * i);
      end loop;
      winnerswinner1_tag_valid <= sums_tag_valid;
      winnerswinner1_tag_map_column <= sums_tag_map_column;
      winnerswinner1_tag_output_column <= sums_tag_output_column;
      winnerswinner1_tag_first_column <= sums_tag_first_column;
      winnerswinner1_tag_start_of_frame <= sums_tag_start_of_frame;
      winnerswinner1_tag_end_of_line <= sums_tag_end_of_line;
      for i in 0 to 31 loop
        if (sums_sum_0(2 * i + 1) - sums_sum_0(2 * i)) < 0 then
          winnerswinner1_best_cost_0(i) <= sums_sum_0(2 * i + 1);
        else
          winnerswinner1_best_cost_0(i) <= sums_sum_0(2 * i);
        end if;
      end loop;
      if winnerswinner1_best_index_0_choices(1, 8) then
        winnerswinner1_best_index_0_1 <= 3;
        winnerswinner1_best_below_0(1) <= sums_sum_0(2);
        winnerswinner1_best_above_0(1) <= 0;
      else
        winnerswinner1_best_index_0_1 <= 2;
        winnerswinner1_best_below_0(1) <= 0;
        winnerswinner1_best_above_0(1) <= sums_sum_0(3);
      end if;
      if winnerswinner1_best_index_0_choices(2, 8) then
        winnerswinner1_best_index_0_2 <= 5;
        winnerswinner1_best_below_0(2) <= sums_sum_0(4);
        winnerswinner1_best_above_0(2) <= 0;
      else
        winnerswinner1_best_index_0_2 <= 4;
        winnerswinner1_best_below_0(2) <= 0;
        winnerswinner1_best_above_0(2) <= sums_sum_0(5);
      end if;
      if winnerswinner1_best_index_0_choices(3, 8) then
        winnerswinner1_best_index_0_3 <= 7;
        winnerswinner1_best_below_0(3) <= sums_sum_0(6);
        winnerswinner1_best_above_0(3) <= 0;
      else
        winnerswinner1_best_index_0_3 <= 6;
        winnerswinner1_best_below_0(3) <= 0;
        winnerswinner1_best_above_0(3) <= sums_sum_0(7);
      end if;
      if winnerswinner1_best_index_0_choices(4, 8) then
        winnerswinner1_best_index_0_4 <= 9;
        winnerswinner1_best_below_0(4) <= sums_sum_0(8);
        winnerswinner1_best_above_0(4) <= 0;
      else
        winnerswinner1_best_index_0_4 <= 8;
        winnerswinner1_best_below_0(4) <= 0;
        winnerswinner1_best_above_0(4) <= sums_sum_0(9);
      end if;
      if winnerswinner1_best_index_0_choices(5, 8) then
        winnerswinner1_best_index_0_5 <= 11;
        winnerswinner1_best_below_0(5) <= sums_sum_0(10);
        winnerswinner1_best_above_0(5) <= 0;
      else
        winnerswinner1_best_index_0_5 <= 10;
        winnerswinner1_best_below_0(5) <= 0;
        winnerswinner1_best_above_0(5) <= sums_sum_0(11);
      end if;
      if winnerswinner1_best_index_0_choices(6, 8) then
        winnerswinner1_best_index_0_6 <= 13;
        winnerswinner1_best_below_0(6) <= sums_sum_0(12);
        winnerswinner1_best_above_0(6) <= 0;
      else
        winnerswinner1_best_index_0_6 <= 12;
        winnerswinner1_best_below_0(6) <= 0;
        winnerswinner1_best_above_0(6) <= sums_sum_0(13);
      end if;
      if winnerswinner1_best_index_0_choices(7, 8) then
        winnerswinner1_best_index_0_7 <= 15;
        winnerswinner1_best_below_0(7) <= sums_sum_0(14);
        winnerswinner1_best_above_0(7) <= 0;
      else
        winnerswinner1_best_index_0_7 <= 14;
        winnerswinner1_best_below_0(7) <= 0;
        winnerswinner1_best_above_0(7) <= sums_sum_0(15);
      end if;
      if winnerswinner1_best_index_0_choices(8, 8) then
        winnerswinner1_best_index_0_8 <= 17;
        winnerswinner1_best_below_0(8) <= sums_sum_0(16);
        winnerswinner1_best_above_0(8) <= 0;
      else
        winnerswinner1_best_index_0_8 <= 16;
        winnerswinner1_best_below_0(8) <= 0;
        winnerswinner1_best_above_0(8) <= sums_sum_0(17);
      end if;
      if winnerswinner1_best_index_0_choices(9, 8) then
        winnerswinner1_best_index_0_9 <= 19;
        winnerswinner1_best_below_0(9) <= sums_sum_0(18);
        winnerswinner1_best_above_0(9) <= 0;
      else
        winnerswinner1_best_index_0_9 <= 18;
        winnerswinner1_best_below_0(9) <= 0;
        winnerswinner1_best_above_0(9) <= sums_sum_0(19);
      end if;
      if winnerswinner1_best_index_0_choices(10, 8) then
        winnerswinner1_best_index_0_10 <= 21;
        winnerswinner1_best_below_0(10) <= sums_sum_0(20);
        winnerswinner1_best_above_0(10) <= 0;
      else
        winnerswinner1_best_index_0_10 <= 20;
        winnerswinner1_best_below_0(10) <= 0;
        winnerswinner1_best_above_0(10) <= sums_sum_0(21);
      end if;
      if winnerswinner1_best_index_0_choices(11, 8) then
        winnerswinner1_best_index_0_11 <= 23;
        winnerswinner1_best_below_0(11) <= sums_sum_0(22);
        winnerswinner1_best_above_0(11) <= 0;
      else
        winnerswinner1_best_index_0_11 <= 22;
        winnerswinner1_best_below_0(11) <= 0;
        winnerswinner1_best_above_0(11) <= sums_sum_0(23);
      end if;
      if winnerswinner1_best_index_0_choices(12, 8) then
        winnerswinner1_best_index_0_12 <= 25;
        winnerswinner1_best_below_0(12) <= sums_sum_0(24);
        winnerswinner1_best_above_0(12) <= 0;
      else
        winnerswinner1_best_index_0_12 <= 24;
        winnerswinner1_best_below_0(12) <= 0;
        winnerswinner1_best_above_0(12) <= sums_sum_0(25);
      end if;
      if winnerswinner1_best_index_0_choices(13, 8) then
        winnerswinner1_best_index_0_13 <= 27;
        winnerswinner1_best_below_0(13) <= sums_sum_0(26);
        winnerswinner1_best_above_0(13) <= 0;
      else
        winnerswinner1_best_index_0_13 <= 26;
        winnerswinner1_best_below_0(13) <= 0;
        winnerswinner1_best_above_0(13) <= sums_sum_0(27);
      end if;
      if winnerswinner1_best_index_0_choices(14, 8) then
        winnerswinner1_best_index_0_14 <= 29;
        winnerswinner1_best_below_0(14) <= sums_sum_0(28);
        winnerswinner1_best_above_0(14) <= 0;
      else
        winnerswinner1_best_index_0_14 <= 28;
        winnerswinner1_best_below_0(14) <= 0;
        winnerswinner1_best_above_0(14) <= sums_sum_0(29);
      end if;
      if winnerswinner1_best_index_0_choices(15, 8) then
        winnerswinner1_best_index_0_15 <= 31;
        winnerswinner1_best_below_0(15) <= sums_sum_0(30);
        winnerswinner1_best_above_0(15) <= 0;
      else
        winnerswinner1_best_index_0_15 <= 30;
        winnerswinner1_best_below_0(15) <= 0;
        winnerswinner1_best_above_0(15) <= sums_sum_0(31);
      end if;
      if winnerswinner1_best_index_0_choices(16, 8) then
        winnerswinner1_best_index_0_16 <= 33;
        winnerswinner1_best_below_0(16) <= sums_sum_0(32);
        winnerswinner1_best_above_0(16) <= 0;
      else
        winnerswinner1_best_index_0_16 <= 32;
        winnerswinner1_best_below_0(16) <= 0;
        winnerswinner1_best_above_0(16) <= sums_sum_0(33);
      end if;
      if winnerswinner1_best_index_0_choices(17, 8) then
        winnerswinner1_best_index_0_17 <= 35;
        winnerswinner1_best_below_0(17) <= sums_sum_0(34);
        winnerswinner1_best_above_0(17) <= 0;
      else
        winnerswinner1_best_index_0_17 <= 34;
        winnerswinner1_best_below_0(17) <= 0;
        winnerswinner1_best_above_0(17) <= sums_sum_0(35);
      end if;
      if winnerswinner1_best_index_0_choices(18, 8) then
        winnerswinner1_best_index_0_18 <= 37;
        winnerswinner1_best_below_0(18) <= sums_sum_0(36);
        winnerswinner1_best_above_0(18) <= 0;
      else
        winnerswinner1_best_index_0_18 <= 36;
        winnerswinner1_best_below_0(18) <= 0;
        winnerswinner1_best_above_0(18) <= sums_sum_0(37);
      end if;
      if winnerswinner1_best_index_0_choices(19, 8) then
        winnerswinner1_best_index_0_19 <= 39;
        winnerswinner1_best_below_0(19) <= sums_sum_0(38);
        winnerswinner1_best_above_0(19) <= 0;
      else
        winnerswinner1_best_index_0_19 <= 38;
        winnerswinner1_best_below_0(19) <= 0;
        winnerswinner1_best_above_0(19) <= sums_sum_0(39);
      end if;
      if winnerswinner1_best_index_0_choices(20, 8) then
        winnerswinner1_best_index_0_20 <= 41;
        winnerswinner1_best_below_0(20) <= sums_sum_0(40);
        winnerswinner1_best_above_0(20) <= 0;
      else
        winnerswinner1_best_index_0_20 <= 40;
        winnerswinner1_best_below_0(20) <= 0;
        winnerswinner1_best_above_0(20) <= sums_sum_0(41);
      end if;
      if winnerswinner1_best_index_0_choices(21, 8) then
        winnerswinner1_best_index_0_21 <= 43;
        winnerswinner1_best_below_0(21) <= sums_sum_0(42);
        winnerswinner1_best_above_0(21) <= 0;
      else
        winnerswinner1_best_index_0_21 <= 42;
        winnerswinner1_best_below_0(21) <= 0;
        winnerswinner1_best_above_0(21) <= sums_sum_0(43);
      end if;
      if winnerswinner1_best_index_0_choices(22, 8) then
        winnerswinner1_best_index_0_22 <= 45;
        winnerswinner1_best_below_0(22) <= sums_sum_0(44);
        winnerswinner1_best_above_0(22) <= 0;
      else
        winnerswinner1_best_index_0_22 <= 44;
        winnerswinner1_best_below_0(22) <= 0;
        winnerswinner1_best_above_0(22) <= sums_sum_0(45);
      end if;
      if winnerswinner1_best_index_0_choices(23, 8) then
        winnerswinner1_best_index_0_23 <= 47;
        winnerswinner1_best_below_0(23) <= sums_sum_0(46);
        winnerswinner1_best_above_0(23) <= 0;
      else
        winnerswinner1_best_index_0_23 <= 46;
        winnerswinner1_best_below_0(23) <= 0;
        winnerswinner1_best_above_0(23) <= sums_sum_0(47);
      end if;
      if winnerswinner1_best_index_0_choices(24, 8) then
        winnerswinner1_best_index_0_24 <= 49;
        winnerswinner1_best_below_0(24) <= sums_sum_0(48);
        winnerswinner1_best_above_0(24) <= 0;
      else
        winnerswinner1_best_index_0_24 <= 48;
        winnerswinner1_best_below_0(24) <= 0;
        winnerswinner1_best_above_0(24) <= sums_sum_0(49);
      end if;
      if winnerswinner1_best_index_0_choices(25, 8) then
        winnerswinner1_best_index_0_25 <= 51;
        winnerswinner1_best_below_0(25) <= sums_sum_0(50);
        winnerswinner1_best_above_0(25) <= 0;
      else
        winnerswinner1_best_index_0_25 <= 50;
        winnerswinner1_best_below_0(25) <= 0;
        winnerswinner1_best_above_0(25) <= sums_sum_0(51);
      end if;
      if winnerswinner1_best_index_0_choices(26, 8) then
        winnerswinner1_best_index_0_26 <= 53;
        winnerswinner1_best_below_0(26) <= sums_sum_0(52);
        winnerswinner1_best_above_0(26) <= 0;
      else
        winnerswinner1_best_index_0_26 <= 52;
        winnerswinner1_best_below_0(26) <= 0;
        winnerswinner1_best_above_0(26) <= sums_sum_0(53);
      end if;
      if winnerswinner1_best_index_0_choices(27, 8) then
        winnerswinner1_best_index_0_27 <= 55;
        winnerswinner1_best_below_0(27) <= sums_sum_0(54);
        winnerswinner1_best_above_0(27) <= 0;
      else
        winnerswinner1_best_index_0_27 <= 54;
        winnerswinner1_best_below_0(27) <= 0;
        winnerswinner1_best_above_0(27) <= sums_sum_0(55);
      end if;
      if winnerswinner1_best_index_0_choices(28, 8) then
        winnerswinner1_best_index_0_28 <= 57;
        winnerswinner1_best_below_0(28) <= sums_sum_0(56);
        winnerswinner1_best_above_0(28) <= 0;
      else
        winnerswinner1_best_index_0_28 <= 56;
        winnerswinner1_best_below_0(28) <= 0;
        winnerswinner1_best_above_0(28) <= sums_sum_0(57);
      end if;
      if winnerswinner1_best_index_0_choices(29, 8) then
        winnerswinner1_best_index_0_29 <= 59;
        winnerswinner1_best_below_0(29) <= sums_sum_0(58);
        winnerswinner1_best_above_0(29) <= 0;
      else
        winnerswinner1_best_index_0_29 <= 58;
        winnerswinner1_best_below_0(29) <= 0;
        winnerswinner1_best_above_0(29) <= sums_sum_0(59);
      end if;
      if winnerswinner1_best_index_0_choices(30, 8) then
        winnerswinner1_best_index_0_30 <= 61;
        winnerswinner1_best_below_0(30) <= sums_sum_0(60);
        winnerswinner1_best_above_0(30) <= 0;
      else
        winnerswinner1_best_index_0_30 <= 60;
        winnerswinner1_best_below_0(30) <= 0;
        winnerswinner1_best_above_0(30) <= sums_sum_0(61);
      end if;
      if winnerswinner1_best_index_0_choices(31, 8) then
        winnerswinner1_best_index_0_31 <= 63;
        winnerswinner1_best_below_0(31) <= sums_sum_0(62);
        winnerswinner1_best_above_0(31) <= 0;
      else
        winnerswinner1_best_index_0_31 <= 62;
        winnerswinner1_best_below_0(31) <= 0;
        winnerswinner1_best_above_0(31) <= sums_sum_0(63);
      end if;
      if winnerswinner1_best_index_0_choices(0, 8) then
        winnerswinner1_best_below_0(0) <= sums_sum_0(0);
        winnerswinner1_best_above_0(0) <= 0;
      else
        winnerswinner1_best_below_0(0) <= 0;
        winnerswinner1_best_above_0(0) <= sums_sum_0(1);
      end if;
      -- winnerswinner2
      for i in 0 to 15 loop
        if is_set(winnerswinner1_best_cost_0(2 * i), 0) then
          winnerswinner2_best_index_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner2_best_index_0_choice(i) := not is_set(winnerswinner1_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner1_best_cost_0(2 * i), 1) then
          winnerswinner2_best_index_0_choices(i, 2) := winnerswinner2_best_index_0_choice(i);
        else
          winnerswinner2_best_index_0_choices(i, 2) := is_set(winnerswinner1_best_cost_0(2 * i), 0) and
            ((winnerswinner1_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner2_best_index_0_value(i) := is_set(winnerswinner1_best_cost_0(2 * i + 1), 2);
        if winnerswinner2_best_index_0_choices(i, 2) then
          winnerswinner2_best_index_0_choices(i, 3) := (not is_set(winnerswinner1_best_cost_0(2 * i), 2)) and
            winnerswinner2_best_index_0_value(i);
        else
          winnerswinner2_best_index_0_choices(i, 3) := (not is_set(winnerswinner1_best_cost_0(2 * i), 2)) or
            winnerswinner2_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner2_best_index_0_values(i, j) := is_set(winnerswinner1_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner2_best_index_0_choices(i, j + 1) then
            winnerswinner2_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner1_best_cost_0(2 * i), j + 1)) or
              winnerswinner2_best_index_0_values(i, j);
          else
            winnerswinner2_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner1_best_cost_0(2 * i), j + 1)) and
              winnerswinner2_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner2_best_index_0_choices(i, 7) then
          winnerswinner2_best_index_0_choices(i, 8) := is_set(winnerswinner1_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner2_best_index_0_choices(i, 8) := is_set(winnerswinner1_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      winnerswinner2_best_below_0_is_equal(0) := winnerswinner1_best_index_0_1 = 2;
      if winnerswinner2_best_below_0_is_equal(0) then
        winnerswinner2_best_below_0_choice(0) := winnerswinner1_held_0(1);
      else
        winnerswinner2_best_below_0_choice(0) := winnerswinner1_best_below_0(1);
      end if;
      winnerswinner2_best_below_0_is_equal(1) := winnerswinner1_best_index_0_3 = 6;
      if winnerswinner2_best_below_0_is_equal(1) then
        winnerswinner2_best_below_0_choice(1) := winnerswinner1_held_0(5);
      else
        winnerswinner2_best_below_0_choice(1) := winnerswinner1_best_below_0(3);
      end if;
      winnerswinner2_best_below_0_is_equal(2) := (winnerswinner1_best_index_0_5 mod 4) = 2;
      if is_set(winnerswinner1_best_index_0_5, 3) and winnerswinner2_best_below_0_is_equal(2) then
        winnerswinner2_best_below_0_choice(2) := winnerswinner1_held_0(9);
      else
        winnerswinner2_best_below_0_choice(2) := winnerswinner1_best_below_0(5);
      end if;
      winnerswinner2_best_below_0_is_equal(3) := winnerswinner1_best_index_0_7 = 14;
      if winnerswinner2_best_below_0_is_equal(3) then
        winnerswinner2_best_below_0_choice(3) := winnerswinner1_held_0(13);
      else
        winnerswinner2_best_below_0_choice(3) := winnerswinner1_best_below_0(7);
      end if;
      winnerswinner2_best_below_0_value(4) := is_set(winnerswinner1_best_index_0_9, 1);
      if winnerswinner2_best_below_0_value(4) and (not is_set(winnerswinner1_best_index_0_9, 0)) and
        is_set(winnerswinner1_best_index_0_9, 4) then
        winnerswinner2_best_below_0_choice(4) := winnerswinner1_held_0(17);
      else
        winnerswinner2_best_below_0_choice(4) := winnerswinner1_best_below_0(9);
      end if;
      winnerswinner2_best_below_0_value(5) := is_set(winnerswinner1_best_index_0_11, 1);
      winnerswinner2_best_below_0_5_value_2 := is_set(winnerswinner1_best_index_0_11, 2);
      if winnerswinner2_best_below_0_value(5) and (not is_set(winnerswinner1_best_index_0_11, 0)) and
        is_set(winnerswinner1_best_index_0_11, 4) and winnerswinner2_best_below_0_5_value_2 then
        winnerswinner2_best_below_0_choice(5) := winnerswinner1_held_0(21);
      else
        winnerswinner2_best_below_0_choice(5) := winnerswinner1_best_below_0(11);
      end if;
      winnerswinner2_best_below_0_value(6) := is_set(winnerswinner1_best_index_0_13, 1);
      winnerswinner2_best_below_0_is_equals(6) := (winnerswinner1_best_index_0_13 / 8) = 3;
      if winnerswinner2_best_below_0_value(6) and (not is_set(winnerswinner1_best_index_0_13, 0)) and
        winnerswinner2_best_below_0_is_equals(6) then
        winnerswinner2_best_below_0_choice(6) := winnerswinner1_held_0(25);
      else
        winnerswinner2_best_below_0_choice(6) := winnerswinner1_best_below_0(13);
      end if;
      winnerswinner2_best_below_0_is_equals(7) := winnerswinner1_best_index_0_15 = 30;
      if winnerswinner2_best_below_0_is_equals(7) then
        winnerswinner2_best_below_0_choice(7) := winnerswinner1_held_0(29);
      else
        winnerswinner2_best_below_0_choice(7) := winnerswinner1_best_below_0(15);
      end if;
      winnerswinner2_best_below_0_is_equals(8) := (winnerswinner1_best_index_0_17 mod 4) = 2;
      if is_set(winnerswinner1_best_index_0_17, 5) and winnerswinner2_best_below_0_is_equals(8) then
        winnerswinner2_best_below_0_choice(8) := winnerswinner1_held_0(33);
      else
        winnerswinner2_best_below_0_choice(8) := winnerswinner1_best_below_0(17);
      end if;
      winnerswinner2_best_below_0_is_equals(9) := (winnerswinner1_best_index_0_19 mod 8) = 6;
      if is_set(winnerswinner1_best_index_0_19, 5) and winnerswinner2_best_below_0_is_equals(9) then
        winnerswinner2_best_below_0_choice(9) := winnerswinner1_held_0(37);
      else
        winnerswinner2_best_below_0_choice(9) := winnerswinner1_best_below_0(19);
      end if;
      winnerswinner2_best_below_0_values(10) := is_set(winnerswinner1_best_index_0_21, 3);
      winnerswinner2_best_below_0_is_equals(10) := (winnerswinner1_best_index_0_21 mod 4) = 2;
      if is_set(winnerswinner1_best_index_0_21, 5) and winnerswinner2_best_below_0_values(10) and
        winnerswinner2_best_below_0_is_equals(10) then
        winnerswinner2_best_below_0_choice(10) := winnerswinner1_held_0(41);
      else
        winnerswinner2_best_below_0_choice(10) := winnerswinner1_best_below_0(21);
      end if;
      winnerswinner2_best_below_0_is_equals(11) := (winnerswinner1_best_index_0_23 mod 8) = 6;
      winnerswinner2_best_below_0_values(11) := is_set(winnerswinner1_best_index_0_23, 3);
      if is_set(winnerswinner1_best_index_0_23, 5) and winnerswinner2_best_below_0_is_equals(11) and
        winnerswinner2_best_below_0_values(11) then
        winnerswinner2_best_below_0_choice(11) := winnerswinner1_held_0(45);
      else
        winnerswinner2_best_below_0_choice(11) := winnerswinner1_best_below_0(23);
      end if;
      winnerswinner2_best_below_0_values(12) := is_set(winnerswinner1_best_index_0_25, 4);
      winnerswinner2_best_below_0_is_equals(12) := (winnerswinner1_best_index_0_25 mod 4) = 2;
      if is_set(winnerswinner1_best_index_0_25, 5) and winnerswinner2_best_below_0_values(12) and
        winnerswinner2_best_below_0_is_equals(12) then
        winnerswinner2_best_below_0_choice(12) := winnerswinner1_held_0(49);
      else
        winnerswinner2_best_below_0_choice(12) := winnerswinner1_best_below_0(25);
      end if;
      winnerswinner2_best_below_0_is_equals(13) := (winnerswinner1_best_index_0_27 mod 8) = 6;
      winnerswinner2_best_below_0_values(13) := is_set(winnerswinner1_best_index_0_27, 4);
      if is_set(winnerswinner1_best_index_0_27, 5) and winnerswinner2_best_below_0_is_equals(13) and
        winnerswinner2_best_below_0_values(13) then
        winnerswinner2_best_below_0_choice(13) := winnerswinner1_held_0(53);
      else
        winnerswinner2_best_below_0_choice(13) := winnerswinner1_best_below_0(27);
      end if;
      winnerswinner2_best_below_0_values(14) := is_set(winnerswinner1_best_index_0_29, 4);
      winnerswinner2_best_below_0_is_equals(14) := (winnerswinner1_best_index_0_29 mod 4) = 2;
      winnerswinner2_best_below_0_14_value_2 := is_set(winnerswinner1_best_index_0_29, 3);
      if is_set(winnerswinner1_best_index_0_29, 5) and winnerswinner2_best_below_0_values(14) and
        winnerswinner2_best_below_0_is_equals(14) and winnerswinner2_best_below_0_14_value_2 then
        winnerswinner2_best_below_0_choice(14) := winnerswinner1_held_0(57);
      else
        winnerswinner2_best_below_0_choice(14) := winnerswinner1_best_below_0(29);
      end if;
      winnerswinner2_best_below_0_is_equals(15) := winnerswinner1_best_index_0_31 = 62;
      if winnerswinner2_best_below_0_is_equals(15) then
        winnerswinner2_best_below_0_choice(15) := winnerswinner1_held_0(61);
      else
        winnerswinner2_best_below_0_choice(15) := winnerswinner1_best_below_0(31);
      end if;
      if winnerswinner1_best_index_0_0 then
        winnerswinner2_best_above_0_choice(0) := winnerswinner1_held_0(2);
      else
        winnerswinner2_best_above_0_choice(0) := winnerswinner1_best_above_0(0);
      end if;
      if winnerswinner1_best_place_0_2 then
        winnerswinner2_best_above_0_choice(1) := winnerswinner1_held_0(6);
      else
        winnerswinner2_best_above_0_choice(1) := winnerswinner1_best_above_0(2);
      end if;
      if winnerswinner1_best_place_0_4 then
        winnerswinner2_best_above_0_choice(2) := winnerswinner1_held_0(10);
      else
        winnerswinner2_best_above_0_choice(2) := winnerswinner1_best_above_0(4);
      end if;
      if winnerswinner1_best_place_0_6 then
        winnerswinner2_best_above_0_choice(3) := winnerswinner1_held_0(14);
      else
        winnerswinner2_best_above_0_choice(3) := winnerswinner1_best_above_0(6);
      end if;
      if winnerswinner1_best_place_0_8 then
        winnerswinner2_best_above_0_choice(4) := winnerswinner1_held_0(18);
      else
        winnerswinner2_best_above_0_choice(4) := winnerswinner1_best_above_0(8);
      end if;
      if winnerswinner1_best_place_0_10 then
        winnerswinner2_best_above_0_choice(5) := winnerswinner1_held_0(22);
      else
        winnerswinner2_best_above_0_choice(5) := winnerswinner1_best_above_0(10);
      end if;
      if winnerswinner1_best_place_0_12 then
        winnerswinner2_best_above_0_choice(6) := winnerswinner1_held_0(26);
      else
        winnerswinner2_best_above_0_choice(6) := winnerswinner1_best_above_0(12);
      end if;
      if winnerswinner1_best_place_0_14 then
        winnerswinner2_best_above_0_choice(7) := winnerswinner1_held_0(30);
      else
        winnerswinner2_best_above_0_choice(7) := winnerswinner1_best_above_0(14);
      end if;
      if winnerswinner1_best_place_0_16 then
        winnerswinner2_best_above_0_choice(8) := winnerswinner1_held_0(34);
      else
        winnerswinner2_best_above_0_choice(8) := winnerswinner1_best_above_0(16);
      end if;
      if winnerswinner1_best_place_0_18 then
        winnerswinner2_best_above_0_choice(9) := winnerswinner1_held_0(38);
      else
        winnerswinner2_best_above_0_choice(9) := winnerswinner1_best_above_0(18);
      end if;
      if winnerswinner1_best_place_0_20 then
        winnerswinner2_best_above_0_choice(10) := winnerswinner1_held_0(42);
      else
        winnerswinner2_best_above_0_choice(10) := winnerswinner1_best_above_0(20);
      end if;
      if winnerswinner1_best_place_0_22 then
        winnerswinner2_best_above_0_choice(11) := winnerswinner1_held_0(46);
      else
        winnerswinner2_best_above_0_choice(11) := winnerswinner1_best_above_0(22);
      end if;
      if winnerswinner1_best_place_0_24 then
        winnerswinner2_best_above_0_choice(12) := winnerswinner1_held_0(50);
      else
        winnerswinner2_best_above_0_choice(12) := winnerswinner1_best_above_0(24);
      end if;
      if winnerswinner1_best_place_0_26 then
        winnerswinner2_best_above_0_choice(13) := winnerswinner1_held_0(54);
      else
        winnerswinner2_best_above_0_choice(13) := winnerswinner1_best_above_0(26);
      end if;
      if winnerswinner1_best_place_0_28 then
        winnerswinner2_best_above_0_choice(14) := winnerswinner1_held_0(58);
      else
        winnerswinner2_best_above_0_choice(14) := winnerswinner1_best_above_0(28);
      end if;
      if winnerswinner1_best_place_0_30 then
        winnerswinner2_best_above_0_choice(15) := winnerswinner1_held_0(62);
      else
        winnerswinner2_best_above_0_choice(15) := winnerswinner1_best_above_0(30);
      end if;
      for i in 0 to 15 loop
        if winnerswinner2_best_index_0_choices(i, 7) then
          winnerswinner2_best_at_start_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i), 7)) or
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7);
        else
          winnerswinner2_best_at_start_0_choice(i) := (not is_set(winnerswinner1_best_cost_0(2 * i), 7)) and
            is_set(winnerswinner1_best_cost_0(2 * i + 1), 7);
        end if;
      end loop;
      for i in 0 to 15 loop
        if winnerswinner2_best_place_0(i) then
          winnerswinner2_best_second_0_choice(i) := 255;
        else
          winnerswinner2_best_second_0_choice(i) := winnerswinner1_best_late_cost_0(2 * i + 1);
        end if;
        if winnerswinner2_best_at_end_0(i) then
          winnerswinner2_best_second_0_choices(i, 2) := winnerswinner1_best_but_first_0(2 * i + 1);
        else
          winnerswinner2_best_second_0_choices(i, 2) := winnerswinner2_best_second_0_choice(i);
        end if;
        if winnerswinner2_best_place_0(i) then
          winnerswinner2_best_second_0_choices(i, 3) := winnerswinner1_best_late_cost_0(2 * i);
        else
          winnerswinner2_best_second_0_choices(i, 3) := 255;
        end if;
        if winnerswinner2_best_at_start_0(i) then
          winnerswinner2_best_second_0_choices(i, 4) := winnerswinner1_best_but_last_0(2 * i);
        else
          winnerswinner2_best_second_0_choices(i, 4) := winnerswinner2_best_second_0_choices(i, 3);
        end if;
      end loop;
      for i in 1 to 15 loop
        winnerswinner2_best_first_0(i) <= winnerswinner1_held_0(4 * i);
      end loop;
      for i in 0 to 14 loop
        winnerswinner2_best_last_0(i) <= winnerswinner1_held_0(4 * i + 3);
      end loop;
      for i in 0 to 15 loop
        winnerswinner2_best_place_0(i) <= winnerswinner2_best_index_0_choices(i, 8);
      end loop;
      winnerswinner2_best_at_start_0(0) <= (not winnerswinner2_best_at_start_0_choice(0)) and
        winnerswinner2_best_below_0_is_equal(0);
      winnerswinner2_best_at_start_0(1) <= (not winnerswinner2_best_at_start_0_choice(1)) and
        winnerswinner2_best_below_0_is_equal(1);
      winnerswinner2_best_at_start_0(2) <= (not winnerswinner2_best_at_start_0_choice(2)) and
        is_set(winnerswinner1_best_index_0_5, 3) and winnerswinner2_best_below_0_is_equal(2);
      winnerswinner2_best_at_start_0(3) <= winnerswinner2_best_below_0_is_equal(3) and (not
        winnerswinner2_best_at_start_0_choice(3));
      winnerswinner2_best_at_start_0(4) <= (not winnerswinner2_best_at_start_0_choice(4)) and
        winnerswinner2_best_below_0_value(4) and (not is_set(winnerswinner1_best_index_0_9, 0)) and
        is_set(winnerswinner1_best_index_0_9, 4);
      winnerswinner2_best_at_start_0(5) <= winnerswinner2_best_below_0_value(5) and (not
        is_set(winnerswinner1_best_index_0_11, 0)) and is_set(winnerswinner1_best_index_0_11, 4) and
        winnerswinner2_best_below_0_5_value_2 and (not winnerswinner2_best_at_start_0_choice(5));
      winnerswinner2_best_at_start_0(6) <= winnerswinner2_best_below_0_value(6) and (not
        is_set(winnerswinner1_best_index_0_13, 0)) and winnerswinner2_best_below_0_is_equals(6) and (not
        winnerswinner2_best_at_start_0_choice(6));
      winnerswinner2_best_at_start_0(7) <= winnerswinner2_best_below_0_is_equals(7) and (not
        winnerswinner2_best_at_start_0_choice(7));
      winnerswinner2_best_at_start_0(8) <= (not winnerswinner2_best_at_start_0_choice(8)) and
        is_set(winnerswinner1_best_index_0_17, 5) and winnerswinner2_best_below_0_is_equals(8);
      winnerswinner2_best_at_start_0(9) <= is_set(winnerswinner1_best_index_0_19, 5) and
        winnerswinner2_best_below_0_is_equals(9) and (not winnerswinner2_best_at_start_0_choice(9));
      winnerswinner2_best_at_start_0(10) <= is_set(winnerswinner1_best_index_0_21, 5) and
        winnerswinner2_best_below_0_values(10) and winnerswinner2_best_below_0_is_equals(10) and (not
        winnerswinner2_best_at_start_0_choice(10));
      winnerswinner2_best_at_start_0(11) <= is_set(winnerswinner1_best_index_0_23, 5) and
        winnerswinner2_best_below_0_is_equals(11) and winnerswinner2_best_below_0_values(11) and (not
        winnerswinner2_best_at_start_0_choice(11));
      winnerswinner2_best_at_start_0(12) <= is_set(winnerswinner1_best_index_0_25, 5) and
        winnerswinner2_best_below_0_values(12) and winnerswinner2_best_below_0_is_equals(12) and (not
        winnerswinner2_best_at_start_0_choice(12));
      winnerswinner2_best_at_start_0(13) <= is_set(winnerswinner1_best_index_0_27, 5) and
        winnerswinner2_best_below_0_is_equals(13) and winnerswinner2_best_below_0_values(13) and (not
        winnerswinner2_best_at_start_0_choice(13));
      winnerswinner2_best_at_start_0(14) <= is_set(winnerswinner1_best_index_0_29, 5) and
        winnerswinner2_best_below_0_values(14) and winnerswinner2_best_below_0_is_equals(14) and
        winnerswinner2_best_below_0_14_value_2 and (not winnerswinner2_best_at_start_0_choice(14));
      winnerswinner2_best_at_start_0(15) <= winnerswinner2_best_below_0_is_equals(15) and (not
        winnerswinner2_best_at_start_0_choice(15));
      winnerswinner2_best_at_end_0(0) <= winnerswinner2_best_at_start_0_choice(0) and winnerswinner1_best_index_0_0;
      winnerswinner2_best_at_end_0(1) <= winnerswinner2_best_at_start_0_choice(1) and winnerswinner1_best_place_0_2;
      winnerswinner2_best_at_end_0(2) <= winnerswinner2_best_at_start_0_choice(2) and winnerswinner1_best_place_0_4;
      winnerswinner2_best_at_end_0(3) <= winnerswinner2_best_at_start_0_choice(3) and winnerswinner1_best_place_0_6;
      winnerswinner2_best_at_end_0(4) <= winnerswinner2_best_at_start_0_choice(4) and winnerswinner1_best_place_0_8;
      winnerswinner2_best_at_end_0(5) <= winnerswinner2_best_at_start_0_choice(5) and winnerswinner1_best_place_0_10;
      winnerswinner2_best_at_end_0(6) <= winnerswinner2_best_at_start_0_choice(6) and winnerswinner1_best_place_0_12;
      winnerswinner2_best_at_end_0(7) <= winnerswinner2_best_at_start_0_choice(7) and winnerswinner1_best_place_0_14;
      winnerswinner2_best_at_end_0(8) <= winnerswinner2_best_at_start_0_choice(8) and winnerswinner1_best_place_0_16;
      winnerswinner2_best_at_end_0(9) <= winnerswinner2_best_at_start_0_choice(9) and winnerswinner1_best_place_0_18;
      winnerswinner2_best_at_end_0(10) <= winnerswinner2_best_at_start_0_choice(10) and winnerswinner1_best_place_0_20;
      winnerswinner2_best_at_end_0(11) <= winnerswinner2_best_at_start_0_choice(11) and winnerswinner1_best_place_0_22;
      winnerswinner2_best_at_end_0(12) <= winnerswinner2_best_at_start_0_choice(12) and winnerswinner1_best_place_0_24;
      winnerswinner2_best_at_end_0(13) <= winnerswinner2_best_at_start_0_choice(13) and winnerswinner1_best_place_0_26;
      winnerswinner2_best_at_end_0(14) <= winnerswinner2_best_at_start_0_choice(14) and winnerswinner1_best_place_0_28;
      winnerswinner2_best_at_end_0(15) <= winnerswinner2_best_at_start_0_choice(15) and winnerswinner1_best_place_0_30;
      for i in 0 to 15 loop
        winnerswinner2_best_late_cost_0(i) <= winnerswinner2_best_cost_0(i);
      end loop;
      winnerswinner2_tag_valid <= winnerswinner1_tag_valid;
      winnerswinner2_tag_map_column <= winnerswinner1_tag_map_column;
      winnerswinner2_tag_output_column <= winnerswinner1_tag_output_column;
      winnerswinner2_tag_first_column <= winnerswinner1_tag_first_column;
      winnerswinner2_tag_start_of_frame <= winnerswinner1_tag_start_of_frame;
      winnerswinner2_tag_end_of_line <= winnerswinner1_tag_end_of_line;
      for i in 0 to 15 loop
        if (winnerswinner1_best_cost_0(2 * i + 1) - winnerswinner1_best_cost_0(2 * i)) < 0 then
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i + 1);
        else
          winnerswinner2_best_cost_0(i) <= winnerswinner1_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner2_best_index_0_choices(0, 8) then
        winnerswinner2_best_index_0_0 <= winnerswinner1_best_index_0_1;
        winnerswinner2_best_below_0(0) <= winnerswinner2_best_below_0_choice(0);
        winnerswinner2_best_above_0(0) <= winnerswinner1_best_above_0(1);
      else
        winnerswinner2_best_index_0_0 <= as_number(winnerswinner1_best_index_0_0);
        winnerswinner2_best_below_0(0) <= winnerswinner1_best_below_0(0);
        winnerswinner2_best_above_0(0) <= winnerswinner2_best_above_0_choice(0);
      end if;
      if winnerswinner2_best_index_0_choices(1, 8) then
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_3;
        winnerswinner2_best_below_0(1) <= winnerswinner2_best_below_0_choice(1);
        winnerswinner2_best_above_0(1) <= winnerswinner1_best_above_0(3);
      else
        winnerswinner2_best_index_0_1 <= winnerswinner1_best_index_0_2;
        winnerswinner2_best_below_0(1) <= winnerswinner1_best_below_0(2);
        winnerswinner2_best_above_0(1) <= winnerswinner2_best_above_0_choice(1);
      end if;
      if winnerswinner2_best_index_0_choices(2, 8) then
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_5;
        winnerswinner2_best_below_0(2) <= winnerswinner2_best_below_0_choice(2);
        winnerswinner2_best_above_0(2) <= winnerswinner1_best_above_0(5);
      else
        winnerswinner2_best_index_0_2 <= winnerswinner1_best_index_0_4;
        winnerswinner2_best_below_0(2) <= winnerswinner1_best_below_0(4);
        winnerswinner2_best_above_0(2) <= winnerswinner2_best_above_0_choice(2);
      end if;
      if winnerswinner2_best_index_0_choices(3, 8) then
        winnerswinner2_best_index_0_3 <= winnerswinner1_best_index_0_7;
        winnerswinner2_best_below_0(3) <= winnerswinner2_best_below_0_choice(3);
        winnerswinner2_best_above_0(3) <= winnerswinner1_best_above_0(7);
      else
        winnerswinner2_best_index_0_3 <= winnerswinner1_best_index_0_6;
        winnerswinner2_best_below_0(3) <= winnerswinner1_best_below_0(6);
        winnerswinner2_best_above_0(3) <= winnerswinner2_best_above_0_choice(3);
      end if;
      if winnerswinner2_best_index_0_choices(4, 8) then
        winnerswinner2_best_index_0_4 <= winnerswinner1_best_index_0_9;
        winnerswinner2_best_below_0(4) <= winnerswinner2_best_below_0_choice(4);
        winnerswinner2_best_above_0(4) <= winnerswinner1_best_above_0(9);
      else
        winnerswinner2_best_index_0_4 <= winnerswinner1_best_index_0_8;
        winnerswinner2_best_below_0(4) <= winnerswinner1_best_below_0(8);
        winnerswinner2_best_above_0(4) <= winnerswinner2_best_above_0_choice(4);
      end if;
      if winnerswinner2_best_index_0_choices(5, 8) then
        winnerswinner2_best_index_0_5 <= winnerswinner1_best_index_0_11;
        winnerswinner2_best_below_0(5) <= winnerswinner2_best_below_0_choice(5);
        winnerswinner2_best_above_0(5) <= winnerswinner1_best_above_0(11);
      else
        winnerswinner2_best_index_0_5 <= winnerswinner1_best_index_0_10;
        winnerswinner2_best_below_0(5) <= winnerswinner1_best_below_0(10);
        winnerswinner2_best_above_0(5) <= winnerswinner2_best_above_0_choice(5);
      end if;
      if winnerswinner2_best_index_0_choices(6, 8) then
        winnerswinner2_best_index_0_6 <= winnerswinner1_best_index_0_13;
        winnerswinner2_best_below_0(6) <= winnerswinner2_best_below_0_choice(6);
        winnerswinner2_best_above_0(6) <= winnerswinner1_best_above_0(13);
      else
        winnerswinner2_best_index_0_6 <= winnerswinner1_best_index_0_12;
        winnerswinner2_best_below_0(6) <= winnerswinner1_best_below_0(12);
        winnerswinner2_best_above_0(6) <= winnerswinner2_best_above_0_choice(6);
      end if;
      if winnerswinner2_best_index_0_choices(7, 8) then
        winnerswinner2_best_index_0_7 <= winnerswinner1_best_index_0_15;
        winnerswinner2_best_below_0(7) <= winnerswinner2_best_below_0_choice(7);
        winnerswinner2_best_above_0(7) <= winnerswinner1_best_above_0(15);
      else
        winnerswinner2_best_index_0_7 <= winnerswinner1_best_index_0_14;
        winnerswinner2_best_below_0(7) <= winnerswinner1_best_below_0(14);
        winnerswinner2_best_above_0(7) <= winnerswinner2_best_above_0_choice(7);
      end if;
      if winnerswinner2_best_index_0_choices(8, 8) then
        winnerswinner2_best_index_0_8 <= winnerswinner1_best_index_0_17;
        winnerswinner2_best_below_0(8) <= winnerswinner2_best_below_0_choice(8);
        winnerswinner2_best_above_0(8) <= winnerswinner1_best_above_0(17);
      else
        winnerswinner2_best_index_0_8 <= winnerswinner1_best_index_0_16;
        winnerswinner2_best_below_0(8) <= winnerswinner1_best_below_0(16);
        winnerswinner2_best_above_0(8) <= winnerswinner2_best_above_0_choice(8);
      end if;
      if winnerswinner2_best_index_0_choices(9, 8) then
        winnerswinner2_best_index_0_9 <= winnerswinner1_best_index_0_19;
        winnerswinner2_best_below_0(9) <= winnerswinner2_best_below_0_choice(9);
        winnerswinner2_best_above_0(9) <= winnerswinner1_best_above_0(19);
      else
        winnerswinner2_best_index_0_9 <= winnerswinner1_best_index_0_18;
        winnerswinner2_best_below_0(9) <= winnerswinner1_best_below_0(18);
        winnerswinner2_best_above_0(9) <= winnerswinner2_best_above_0_choice(9);
      end if;
      if winnerswinner2_best_index_0_choices(10, 8) then
        winnerswinner2_best_index_0_10 <= winnerswinner1_best_index_0_21;
        winnerswinner2_best_below_0(10) <= winnerswinner2_best_below_0_choice(10);
        winnerswinner2_best_above_0(10) <= winnerswinner1_best_above_0(21);
      else
        winnerswinner2_best_index_0_10 <= winnerswinner1_best_index_0_20;
        winnerswinner2_best_below_0(10) <= winnerswinner1_best_below_0(20);
        winnerswinner2_best_above_0(10) <= winnerswinner2_best_above_0_choice(10);
      end if;
      if winnerswinner2_best_index_0_choices(11, 8) then
        winnerswinner2_best_index_0_11 <= winnerswinner1_best_index_0_23;
        winnerswinner2_best_below_0(11) <= winnerswinner2_best_below_0_choice(11);
        winnerswinner2_best_above_0(11) <= winnerswinner1_best_above_0(23);
      else
        winnerswinner2_best_index_0_11 <= winnerswinner1_best_index_0_22;
        winnerswinner2_best_below_0(11) <= winnerswinner1_best_below_0(22);
        winnerswinner2_best_above_0(11) <= winnerswinner2_best_above_0_choice(11);
      end if;
      if winnerswinner2_best_index_0_choices(12, 8) then
        winnerswinner2_best_index_0_12 <= winnerswinner1_best_index_0_25;
        winnerswinner2_best_below_0(12) <= winnerswinner2_best_below_0_choice(12);
        winnerswinner2_best_above_0(12) <= winnerswinner1_best_above_0(25);
      else
        winnerswinner2_best_index_0_12 <= winnerswinner1_best_index_0_24;
        winnerswinner2_best_below_0(12) <= winnerswinner1_best_below_0(24);
        winnerswinner2_best_above_0(12) <= winnerswinner2_best_above_0_choice(12);
      end if;
      if winnerswinner2_best_index_0_choices(13, 8) then
        winnerswinner2_best_index_0_13 <= winnerswinner1_best_index_0_27;
        winnerswinner2_best_below_0(13) <= winnerswinner2_best_below_0_choice(13);
        winnerswinner2_best_above_0(13) <= winnerswinner1_best_above_0(27);
      else
        winnerswinner2_best_index_0_13 <= winnerswinner1_best_index_0_26;
        winnerswinner2_best_below_0(13) <= winnerswinner1_best_below_0(26);
        winnerswinner2_best_above_0(13) <= winnerswinner2_best_above_0_choice(13);
      end if;
      if winnerswinner2_best_index_0_choices(14, 8) then
        winnerswinner2_best_index_0_14 <= winnerswinner1_best_index_0_29;
        winnerswinner2_best_below_0(14) <= winnerswinner2_best_below_0_choice(14);
        winnerswinner2_best_above_0(14) <= winnerswinner1_best_above_0(29);
      else
        winnerswinner2_best_index_0_14 <= winnerswinner1_best_index_0_28;
        winnerswinner2_best_below_0(14) <= winnerswinner1_best_below_0(28);
        winnerswinner2_best_above_0(14) <= winnerswinner2_best_above_0_choice(14);
      end if;
      if winnerswinner2_best_index_0_choices(15, 8) then
        winnerswinner2_best_index_0_15 <= winnerswinner1_best_index_0_31;
        winnerswinner2_best_below_0(15) <= winnerswinner2_best_below_0_choice(15);
        winnerswinner2_best_above_0(15) <= winnerswinner1_best_above_0(31);
      else
        winnerswinner2_best_index_0_15 <= winnerswinner1_best_index_0_30;
        winnerswinner2_best_below_0(15) <= winnerswinner1_best_below_0(30);
        winnerswinner2_best_above_0(15) <= winnerswinner2_best_above_0_choice(15);
      end if;
      for i in 0 to 15 loop
        if (winnerswinner2_best_second_0_choices(i, 2) - winnerswinner2_best_second_0_choices(i, 4)) < 0 then
          winnerswinner2_best_second_0(i) <= winnerswinner2_best_second_0_choices(i, 2);
        else
          winnerswinner2_best_second_0(i) <= winnerswinner2_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 1 to 15 loop
        if (winnerswinner1_best_late_cost_0(2 * i + 1) - winnerswinner1_best_but_first_0(2 * i)) < 0 then
          winnerswinner2_best_but_first_0(i) <= winnerswinner1_best_late_cost_0(2 * i + 1);
        else
          winnerswinner2_best_but_first_0(i) <= winnerswinner1_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 14 loop
        if (winnerswinner1_best_but_last_0(2 * i + 1) - winnerswinner1_best_late_cost_0(2 * i)) < 0 then
          winnerswinner2_best_but_last_0(i) <= winnerswinner1_best_but_last_0(2 * i + 1);
        else
          winnerswinner2_best_but_last_0(i) <= winnerswinner1_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- winnerswinner3
      for i in 0 to 7 loop
        if is_set(winnerswinner2_best_cost_0(2 * i), 0) then
          winnerswinner3_best_index_0_choice(i) := (not is_set(winnerswinner2_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner3_best_index_0_choice(i) := not is_set(winnerswinner2_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner2_best_cost_0(2 * i), 1) then
          winnerswinner3_best_index_0_choices(i, 2) := winnerswinner3_best_index_0_choice(i);
        else
          winnerswinner3_best_index_0_choices(i, 2) := is_set(winnerswinner2_best_cost_0(2 * i), 0) and
            ((winnerswinner2_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner3_best_index_0_value(i) := is_set(winnerswinner2_best_cost_0(2 * i + 1), 2);
        if winnerswinner3_best_index_0_choices(i, 2) then
          winnerswinner3_best_index_0_choices(i, 3) := (not is_set(winnerswinner2_best_cost_0(2 * i), 2)) and
            winnerswinner3_best_index_0_value(i);
        else
          winnerswinner3_best_index_0_choices(i, 3) := (not is_set(winnerswinner2_best_cost_0(2 * i), 2)) or
            winnerswinner3_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner3_best_index_0_values(i, j) := is_set(winnerswinner2_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner3_best_index_0_choices(i, j + 1) then
            winnerswinner3_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner2_best_cost_0(2 * i), j + 1)) or
              winnerswinner3_best_index_0_values(i, j);
          else
            winnerswinner3_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner2_best_cost_0(2 * i), j + 1)) and
              winnerswinner3_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner3_best_index_0_choices(i, 7) then
          winnerswinner3_best_index_0_choices(i, 8) := is_set(winnerswinner2_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner3_best_index_0_choices(i, 8) := is_set(winnerswinner2_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      winnerswinner3_best_below_0_is_equal(0) := winnerswinner2_best_index_0_1 = 4;
      if winnerswinner3_best_below_0_is_equal(0) then
        winnerswinner3_best_below_0_choice(0) := winnerswinner2_best_last_0(0);
      else
        winnerswinner3_best_below_0_choice(0) := winnerswinner2_best_below_0(1);
      end if;
      winnerswinner3_best_below_0_is_equal(1) := winnerswinner2_best_index_0_3 = 12;
      if winnerswinner3_best_below_0_is_equal(1) then
        winnerswinner3_best_below_0_choice(1) := winnerswinner2_best_last_0(2);
      else
        winnerswinner3_best_below_0_choice(1) := winnerswinner2_best_below_0(3);
      end if;
      winnerswinner3_best_below_0_2_value := is_set(winnerswinner2_best_index_0_5, 2);
      if (not is_set(winnerswinner2_best_index_0_5, 1)) and (not is_set(winnerswinner2_best_index_0_5, 0)) and
        is_set(winnerswinner2_best_index_0_5, 4) and winnerswinner3_best_below_0_2_value then
        winnerswinner3_best_below_0_choice(2) := winnerswinner2_best_last_0(4);
      else
        winnerswinner3_best_below_0_choice(2) := winnerswinner2_best_below_0(5);
      end if;
      winnerswinner3_best_below_0_is_equals(3) := winnerswinner2_best_index_0_7 = 28;
      if winnerswinner3_best_below_0_is_equals(3) then
        winnerswinner3_best_below_0_choice(3) := winnerswinner2_best_last_0(6);
      else
        winnerswinner3_best_below_0_choice(3) := winnerswinner2_best_below_0(7);
      end if;
      winnerswinner3_best_below_0_is_equals(4) := (winnerswinner2_best_index_0_9 mod 8) = 4;
      if is_set(winnerswinner2_best_index_0_9, 5) and winnerswinner3_best_below_0_is_equals(4) then
        winnerswinner3_best_below_0_choice(4) := winnerswinner2_best_last_0(8);
      else
        winnerswinner3_best_below_0_choice(4) := winnerswinner2_best_below_0(9);
      end if;
      winnerswinner3_best_below_0_is_equals(5) := (winnerswinner2_best_index_0_11 mod 8) = 4;
      winnerswinner3_best_below_0_value(5) := is_set(winnerswinner2_best_index_0_11, 3);
      if is_set(winnerswinner2_best_index_0_11, 5) and winnerswinner3_best_below_0_is_equals(5) and
        winnerswinner3_best_below_0_value(5) then
        winnerswinner3_best_below_0_choice(5) := winnerswinner2_best_last_0(10);
      else
        winnerswinner3_best_below_0_choice(5) := winnerswinner2_best_below_0(11);
      end if;
      winnerswinner3_best_below_0_is_equals(6) := (winnerswinner2_best_index_0_13 mod 8) = 4;
      winnerswinner3_best_below_0_value(6) := is_set(winnerswinner2_best_index_0_13, 4);
      if is_set(winnerswinner2_best_index_0_13, 5) and winnerswinner3_best_below_0_is_equals(6) and
        winnerswinner3_best_below_0_value(6) then
        winnerswinner3_best_below_0_choice(6) := winnerswinner2_best_last_0(12);
      else
        winnerswinner3_best_below_0_choice(6) := winnerswinner2_best_below_0(13);
      end if;
      winnerswinner3_best_below_0_is_equals(7) := winnerswinner2_best_index_0_15 = 60;
      if winnerswinner3_best_below_0_is_equals(7) then
        winnerswinner3_best_below_0_choice(7) := winnerswinner2_best_last_0(14);
      else
        winnerswinner3_best_below_0_choice(7) := winnerswinner2_best_below_0(15);
      end if;
      winnerswinner3_best_above_0_is_equal(0) := winnerswinner2_best_index_0_0 = 3;
      if winnerswinner3_best_above_0_is_equal(0) then
        winnerswinner3_best_above_0_choice(0) := winnerswinner2_best_first_0(1);
      else
        winnerswinner3_best_above_0_choice(0) := winnerswinner2_best_above_0(0);
      end if;
      winnerswinner3_best_above_0_is_equal(1) := (winnerswinner2_best_index_0_2 mod 4) = 3;
      if is_set(winnerswinner2_best_index_0_2, 3) and winnerswinner3_best_above_0_is_equal(1) then
        winnerswinner3_best_above_0_choice(1) := winnerswinner2_best_first_0(3);
      else
        winnerswinner3_best_above_0_choice(1) := winnerswinner2_best_above_0(2);
      end if;
      winnerswinner3_best_above_0_value(2) := is_set(winnerswinner2_best_index_0_4, 1);
      if winnerswinner3_best_above_0_value(2) and is_set(winnerswinner2_best_index_0_4, 0) and
        is_set(winnerswinner2_best_index_0_4, 4) then
        winnerswinner3_best_above_0_choice(2) := winnerswinner2_best_first_0(5);
      else
        winnerswinner3_best_above_0_choice(2) := winnerswinner2_best_above_0(4);
      end if;
      winnerswinner3_best_above_0_value(3) := is_set(winnerswinner2_best_index_0_6, 1);
      winnerswinner3_best_above_0_is_equals(3) := (winnerswinner2_best_index_0_6 / 8) = 3;
      if winnerswinner3_best_above_0_value(3) and is_set(winnerswinner2_best_index_0_6, 0) and
        winnerswinner3_best_above_0_is_equals(3) then
        winnerswinner3_best_above_0_choice(3) := winnerswinner2_best_first_0(7);
      else
        winnerswinner3_best_above_0_choice(3) := winnerswinner2_best_above_0(6);
      end if;
      winnerswinner3_best_above_0_is_equals(4) := (winnerswinner2_best_index_0_8 mod 4) = 3;
      if is_set(winnerswinner2_best_index_0_8, 5) and winnerswinner3_best_above_0_is_equals(4) then
        winnerswinner3_best_above_0_choice(4) := winnerswinner2_best_first_0(9);
      else
        winnerswinner3_best_above_0_choice(4) := winnerswinner2_best_above_0(8);
      end if;
      winnerswinner3_best_above_0_values(5) := is_set(winnerswinner2_best_index_0_10, 3);
      winnerswinner3_best_above_0_is_equals(5) := (winnerswinner2_best_index_0_10 mod 4) = 3;
      if is_set(winnerswinner2_best_index_0_10, 5) and winnerswinner3_best_above_0_values(5) and
        winnerswinner3_best_above_0_is_equals(5) then
        winnerswinner3_best_above_0_choice(5) := winnerswinner2_best_first_0(11);
      else
        winnerswinner3_best_above_0_choice(5) := winnerswinner2_best_above_0(10);
      end if;
      winnerswinner3_best_above_0_values(6) := is_set(winnerswinner2_best_index_0_12, 4);
      winnerswinner3_best_above_0_is_equals(6) := (winnerswinner2_best_index_0_12 mod 4) = 3;
      if is_set(winnerswinner2_best_index_0_12, 5) and winnerswinner3_best_above_0_values(6) and
        winnerswinner3_best_above_0_is_equals(6) then
        winnerswinner3_best_above_0_choice(6) := winnerswinner2_best_first_0(13);
      else
        winnerswinner3_best_above_0_choice(6) := winnerswinner2_best_above_0(12);
      end if;
      winnerswinner3_best_above_0_values(7) := is_set(winnerswinner2_best_index_0_14, 4);
      winnerswinner3_best_above_0_is_equals(7) := (winnerswinner2_best_index_0_14 mod 4) = 3;
      winnerswinner3_best_above_0_7_value_2 := is_set(winnerswinner2_best_index_0_14, 3);
      if is_set(winnerswinner2_best_index_0_14, 5) and winnerswinner3_best_above_0_values(7) and
        winnerswinner3_best_above_0_is_equals(7) and winnerswinner3_best_above_0_7_value_2 then
        winnerswinner3_best_above_0_choice(7) := winnerswinner2_best_first_0(15);
      else
        winnerswinner3_best_above_0_choice(7) := winnerswinner2_best_above_0(14);
      end if;
      for i in 0 to 7 loop
        if winnerswinner3_best_index_0_choices(i, 7) then
          winnerswinner3_best_at_start_0_choice(i) := (not is_set(winnerswinner2_best_cost_0(2 * i), 7)) or
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7);
        else
          winnerswinner3_best_at_start_0_choice(i) := (not is_set(winnerswinner2_best_cost_0(2 * i), 7)) and
            is_set(winnerswinner2_best_cost_0(2 * i + 1), 7);
        end if;
      end loop;
      for i in 0 to 7 loop
        if winnerswinner3_best_place_0(i) then
          winnerswinner3_best_second_0_choice(i) := winnerswinner2_best_second_0(2 * i + 1);
        else
          winnerswinner3_best_second_0_choice(i) := winnerswinner2_best_late_cost_0(2 * i + 1);
        end if;
        if winnerswinner3_best_at_end_0(i) then
          winnerswinner3_best_second_0_choices(i, 2) := winnerswinner2_best_but_first_0(2 * i + 1);
        else
          winnerswinner3_best_second_0_choices(i, 2) := winnerswinner3_best_second_0_choice(i);
        end if;
        if winnerswinner3_best_place_0(i) then
          winnerswinner3_best_second_0_choices(i, 3) := winnerswinner2_best_late_cost_0(2 * i);
        else
          winnerswinner3_best_second_0_choices(i, 3) := winnerswinner2_best_second_0(2 * i);
        end if;
        if winnerswinner3_best_at_start_0(i) then
          winnerswinner3_best_second_0_choices(i, 4) := winnerswinner2_best_but_last_0(2 * i);
        else
          winnerswinner3_best_second_0_choices(i, 4) := winnerswinner3_best_second_0_choices(i, 3);
        end if;
      end loop;
      for i in 1 to 7 loop
        winnerswinner3_best_first_0(i) <= winnerswinner2_best_first_0(2 * i);
      end loop;
      for i in 0 to 6 loop
        winnerswinner3_best_last_0(i) <= winnerswinner2_best_last_0(2 * i + 1);
      end loop;
      for i in 0 to 7 loop
        winnerswinner3_best_place_0(i) <= winnerswinner3_best_index_0_choices(i, 8);
      end loop;
      winnerswinner3_best_at_start_0(0) <= (not winnerswinner3_best_at_start_0_choice(0)) and
        winnerswinner3_best_below_0_is_equal(0);
      winnerswinner3_best_at_start_0(1) <= winnerswinner3_best_below_0_is_equal(1) and (not
        winnerswinner3_best_at_start_0_choice(1));
      winnerswinner3_best_at_start_0(2) <= (not is_set(winnerswinner2_best_index_0_5, 1)) and (not
        is_set(winnerswinner2_best_index_0_5, 0)) and is_set(winnerswinner2_best_index_0_5, 4) and
        winnerswinner3_best_below_0_2_value and (not winnerswinner3_best_at_start_0_choice(2));
      winnerswinner3_best_at_start_0(3) <= winnerswinner3_best_below_0_is_equals(3) and (not
        winnerswinner3_best_at_start_0_choice(3));
      winnerswinner3_best_at_start_0(4) <= is_set(winnerswinner2_best_index_0_9, 5) and
        winnerswinner3_best_below_0_is_equals(4) and (not winnerswinner3_best_at_start_0_choice(4));
      winnerswinner3_best_at_start_0(5) <= is_set(winnerswinner2_best_index_0_11, 5) and
        winnerswinner3_best_below_0_is_equals(5) and winnerswinner3_best_below_0_value(5) and (not
        winnerswinner3_best_at_start_0_choice(5));
      winnerswinner3_best_at_start_0(6) <= is_set(winnerswinner2_best_index_0_13, 5) and
        winnerswinner3_best_below_0_is_equals(6) and winnerswinner3_best_below_0_value(6) and (not
        winnerswinner3_best_at_start_0_choice(6));
      winnerswinner3_best_at_start_0(7) <= winnerswinner3_best_below_0_is_equals(7) and (not
        winnerswinner3_best_at_start_0_choice(7));
      winnerswinner3_best_at_end_0(0) <= winnerswinner3_best_at_start_0_choice(0) and
        winnerswinner3_best_above_0_is_equal(0);
      winnerswinner3_best_at_end_0(1) <= winnerswinner3_best_at_start_0_choice(1) and
        is_set(winnerswinner2_best_index_0_2, 3) and winnerswinner3_best_above_0_is_equal(1);
      winnerswinner3_best_at_end_0(2) <= winnerswinner3_best_at_start_0_choice(2) and
        winnerswinner3_best_above_0_value(2) and is_set(winnerswinner2_best_index_0_4, 0) and
        is_set(winnerswinner2_best_index_0_4, 4);
      winnerswinner3_best_at_end_0(3) <= winnerswinner3_best_above_0_value(3) and is_set(winnerswinner2_best_index_0_6,
        0) and winnerswinner3_best_above_0_is_equals(3) and winnerswinner3_best_at_start_0_choice(3);
      winnerswinner3_best_at_end_0(4) <= winnerswinner3_best_at_start_0_choice(4) and
        is_set(winnerswinner2_best_index_0_8, 5) and winnerswinner3_best_above_0_is_equals(4);
      winnerswinner3_best_at_end_0(5) <= is_set(winnerswinner2_best_index_0_10, 5) and
        winnerswinner3_best_above_0_values(5) and winnerswinner3_best_above_0_is_equals(5) and
        winnerswinner3_best_at_start_0_choice(5);
      winnerswinner3_best_at_end_0(6) <= is_set(winnerswinner2_best_index_0_12, 5) and
        winnerswinner3_best_above_0_values(6) and winnerswinner3_best_above_0_is_equals(6) and
        winnerswinner3_best_at_start_0_choice(6);
      winnerswinner3_best_at_end_0(7) <= is_set(winnerswinner2_best_index_0_14, 5) and
        winnerswinner3_best_above_0_values(7) and winnerswinner3_best_above_0_is_equals(7) and
        winnerswinner3_best_above_0_7_value_2 and winnerswinner3_best_at_start_0_choice(7);
      for i in 0 to 7 loop
        winnerswinner3_best_late_cost_0(i) <= winnerswinner3_best_cost_0(i);
      end loop;
      winnerswinner3_tag_valid <= winnerswinner2_tag_valid;
      winnerswinner3_tag_map_column <= winnerswinner2_tag_map_column;
      winnerswinner3_tag_output_column <= winnerswinner2_tag_output_column;
      winnerswinner3_tag_first_column <= winnerswinner2_tag_first_column;
      winnerswinner3_tag_start_of_frame <= winnerswinner2_tag_start_of_frame;
      winnerswinner3_tag_end_of_line <= winnerswinner2_tag_end_of_line;
      for i in 0 to 7 loop
        if (winnerswinner2_best_cost_0(2 * i + 1) - winnerswinner2_best_cost_0(2 * i)) < 0 then
          winnerswinner3_best_cost_0(i) <= winnerswinner2_best_cost_0(2 * i + 1);
        else
          winnerswinner3_best_cost_0(i) <= winnerswinner2_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner3_best_index_0_choices(0, 8) then
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_1;
        winnerswinner3_best_below_0(0) <= winnerswinner3_best_below_0_choice(0);
        winnerswinner3_best_above_0(0) <= winnerswinner2_best_above_0(1);
      else
        winnerswinner3_best_index_0_0 <= winnerswinner2_best_index_0_0;
        winnerswinner3_best_below_0(0) <= winnerswinner2_best_below_0(0);
        winnerswinner3_best_above_0(0) <= winnerswinner3_best_above_0_choice(0);
      end if;
      if winnerswinner3_best_index_0_choices(1, 8) then
        winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_3;
        winnerswinner3_best_below_0(1) <= winnerswinner3_best_below_0_choice(1);
        winnerswinner3_best_above_0(1) <= winnerswinner2_best_above_0(3);
      else
        winnerswinner3_best_index_0_1 <= winnerswinner2_best_index_0_2;
        winnerswinner3_best_below_0(1) <= winnerswinner2_best_below_0(2);
        winnerswinner3_best_above_0(1) <= winnerswinner3_best_above_0_choice(1);
      end if;
      if winnerswinner3_best_index_0_choices(2, 8) then
        winnerswinner3_best_index_0_2 <= winnerswinner2_best_index_0_5;
        winnerswinner3_best_below_0(2) <= winnerswinner3_best_below_0_choice(2);
        winnerswinner3_best_above_0(2) <= winnerswinner2_best_above_0(5);
      else
        winnerswinner3_best_index_0_2 <= winnerswinner2_best_index_0_4;
        winnerswinner3_best_below_0(2) <= winnerswinner2_best_below_0(4);
        winnerswinner3_best_above_0(2) <= winnerswinner3_best_above_0_choice(2);
      end if;
      if winnerswinner3_best_index_0_choices(3, 8) then
        winnerswinner3_best_index_0_3 <= winnerswinner2_best_index_0_7;
        winnerswinner3_best_below_0(3) <= winnerswinner3_best_below_0_choice(3);
        winnerswinner3_best_above_0(3) <= winnerswinner2_best_above_0(7);
      else
        winnerswinner3_best_index_0_3 <= winnerswinner2_best_index_0_6;
        winnerswinner3_best_below_0(3) <= winnerswinner2_best_below_0(6);
        winnerswinner3_best_above_0(3) <= winnerswinner3_best_above_0_choice(3);
      end if;
      if winnerswinner3_best_index_0_choices(4, 8) then
        winnerswinner3_best_index_0_4 <= winnerswinner2_best_index_0_9;
        winnerswinner3_best_below_0(4) <= winnerswinner3_best_below_0_choice(4);
        winnerswinner3_best_above_0(4) <= winnerswinner2_best_above_0(9);
      else
        winnerswinner3_best_index_0_4 <= winnerswinner2_best_index_0_8;
        winnerswinner3_best_below_0(4) <= winnerswinner2_best_below_0(8);
        winnerswinner3_best_above_0(4) <= winnerswinner3_best_above_0_choice(4);
      end if;
      if winnerswinner3_best_index_0_choices(5, 8) then
        winnerswinner3_best_index_0_5 <= winnerswinner2_best_index_0_11;
        winnerswinner3_best_below_0(5) <= winnerswinner3_best_below_0_choice(5);
        winnerswinner3_best_above_0(5) <= winnerswinner2_best_above_0(11);
      else
        winnerswinner3_best_index_0_5 <= winnerswinner2_best_index_0_10;
        winnerswinner3_best_below_0(5) <= winnerswinner2_best_below_0(10);
        winnerswinner3_best_above_0(5) <= winnerswinner3_best_above_0_choice(5);
      end if;
      if winnerswinner3_best_index_0_choices(6, 8) then
        winnerswinner3_best_index_0_6 <= winnerswinner2_best_index_0_13;
        winnerswinner3_best_below_0(6) <= winnerswinner3_best_below_0_choice(6);
        winnerswinner3_best_above_0(6) <= winnerswinner2_best_above_0(13);
      else
        winnerswinner3_best_index_0_6 <= winnerswinner2_best_index_0_12;
        winnerswinner3_best_below_0(6) <= winnerswinner2_best_below_0(12);
        winnerswinner3_best_above_0(6) <= winnerswinner3_best_above_0_choice(6);
      end if;
      if winnerswinner3_best_index_0_choices(7, 8) then
        winnerswinner3_best_index_0_7 <= winnerswinner2_best_index_0_15;
        winnerswinner3_best_below_0(7) <= winnerswinner3_best_below_0_choice(7);
        winnerswinner3_best_above_0(7) <= winnerswinner2_best_above_0(15);
      else
        winnerswinner3_best_index_0_7 <= winnerswinner2_best_index_0_14;
        winnerswinner3_best_below_0(7) <= winnerswinner2_best_below_0(14);
        winnerswinner3_best_above_0(7) <= winnerswinner3_best_above_0_choice(7);
      end if;
      for i in 0 to 7 loop
        if (winnerswinner3_best_second_0_choices(i, 2) - winnerswinner3_best_second_0_choices(i, 4)) < 0 then
          winnerswinner3_best_second_0(i) <= winnerswinner3_best_second_0_choices(i, 2);
        else
          winnerswinner3_best_second_0(i) <= winnerswinner3_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 1 to 7 loop
        if (winnerswinner2_best_late_cost_0(2 * i + 1) - winnerswinner2_best_but_first_0(2 * i)) < 0 then
          winnerswinner3_best_but_first_0(i) <= winnerswinner2_best_late_cost_0(2 * i + 1);
        else
          winnerswinner3_best_but_first_0(i) <= winnerswinner2_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 6 loop
        if (winnerswinner2_best_but_last_0(2 * i + 1) - winnerswinner2_best_late_cost_0(2 * i)) < 0 then
          winnerswinner3_best_but_last_0(i) <= winnerswinner2_best_but_last_0(2 * i + 1);
        else
          winnerswinner3_best_but_last_0(i) <= winnerswinner2_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- winnerswinner4
      for i in 0 to 3 loop
        if is_set(winnerswinner3_best_cost_0(2 * i), 0) then
          winnerswinner4_best_index_0_choice(i) := (not is_set(winnerswinner3_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner3_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner4_best_index_0_choice(i) := not is_set(winnerswinner3_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner3_best_cost_0(2 * i), 1) then
          winnerswinner4_best_index_0_choices(i, 2) := winnerswinner4_best_index_0_choice(i);
        else
          winnerswinner4_best_index_0_choices(i, 2) := is_set(winnerswinner3_best_cost_0(2 * i), 0) and
            ((winnerswinner3_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner4_best_index_0_value(i) := is_set(winnerswinner3_best_cost_0(2 * i + 1), 2);
        if winnerswinner4_best_index_0_choices(i, 2) then
          winnerswinner4_best_index_0_choices(i, 3) := (not is_set(winnerswinner3_best_cost_0(2 * i), 2)) and
            winnerswinner4_best_index_0_value(i);
        else
          winnerswinner4_best_index_0_choices(i, 3) := (not is_set(winnerswinner3_best_cost_0(2 * i), 2)) or
            winnerswinner4_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner4_best_index_0_values(i, j) := is_set(winnerswinner3_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner4_best_index_0_choices(i, j + 1) then
            winnerswinner4_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner3_best_cost_0(2 * i), j + 1)) or
              winnerswinner4_best_index_0_values(i, j);
          else
            winnerswinner4_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner3_best_cost_0(2 * i), j + 1)) and
              winnerswinner4_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner4_best_index_0_choices(i, 7) then
          winnerswinner4_best_index_0_choices(i, 8) := is_set(winnerswinner3_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner3_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner4_best_index_0_choices(i, 8) := is_set(winnerswinner3_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner3_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      winnerswinner4_best_below_0_is_equal(0) := winnerswinner3_best_index_0_1 = 8;
      if winnerswinner4_best_below_0_is_equal(0) then
        winnerswinner4_best_below_0_choice(0) := winnerswinner3_best_last_0(0);
      else
        winnerswinner4_best_below_0_choice(0) := winnerswinner3_best_below_0(1);
      end if;
      winnerswinner4_best_below_0_is_equal(1) := winnerswinner3_best_index_0_3 = 24;
      if winnerswinner4_best_below_0_is_equal(1) then
        winnerswinner4_best_below_0_choice(1) := winnerswinner3_best_last_0(2);
      else
        winnerswinner4_best_below_0_choice(1) := winnerswinner3_best_below_0(3);
      end if;
      winnerswinner4_best_below_0_is_equal(2) := (winnerswinner3_best_index_0_5 mod 8) = 0;
      winnerswinner4_best_below_0_2_value := is_set(winnerswinner3_best_index_0_5, 3);
      if is_set(winnerswinner3_best_index_0_5, 5) and winnerswinner4_best_below_0_is_equal(2) and
        winnerswinner4_best_below_0_2_value then
        winnerswinner4_best_below_0_choice(2) := winnerswinner3_best_last_0(4);
      else
        winnerswinner4_best_below_0_choice(2) := winnerswinner3_best_below_0(5);
      end if;
      winnerswinner4_best_below_0_is_equal(3) := winnerswinner3_best_index_0_7 = 56;
      if winnerswinner4_best_below_0_is_equal(3) then
        winnerswinner4_best_below_0_choice(3) := winnerswinner3_best_last_0(6);
      else
        winnerswinner4_best_below_0_choice(3) := winnerswinner3_best_below_0(7);
      end if;
      winnerswinner4_best_above_0_0_is_equal := winnerswinner3_best_index_0_0 = 7;
      if winnerswinner4_best_above_0_0_is_equal then
        winnerswinner4_best_above_0_choice(0) := winnerswinner3_best_first_0(1);
      else
        winnerswinner4_best_above_0_choice(0) := winnerswinner3_best_above_0(0);
      end if;
      winnerswinner4_best_above_0_1_value := is_set(winnerswinner3_best_index_0_2, 1);
      winnerswinner4_best_above_0_1_value_2 := is_set(winnerswinner3_best_index_0_2, 2);
      if winnerswinner4_best_above_0_1_value and is_set(winnerswinner3_best_index_0_2, 0) and
        is_set(winnerswinner3_best_index_0_2, 4) and winnerswinner4_best_above_0_1_value_2 then
        winnerswinner4_best_above_0_choice(1) := winnerswinner3_best_first_0(3);
      else
        winnerswinner4_best_above_0_choice(1) := winnerswinner3_best_above_0(2);
      end if;
      winnerswinner4_best_above_0_is_equal(2) := (winnerswinner3_best_index_0_4 mod 8) = 7;
      if is_set(winnerswinner3_best_index_0_4, 5) and winnerswinner4_best_above_0_is_equal(2) then
        winnerswinner4_best_above_0_choice(2) := winnerswinner3_best_first_0(5);
      else
        winnerswinner4_best_above_0_choice(2) := winnerswinner3_best_above_0(4);
      end if;
      winnerswinner4_best_above_0_is_equal(3) := (winnerswinner3_best_index_0_6 mod 8) = 7;
      winnerswinner4_best_above_0_3_value := is_set(winnerswinner3_best_index_0_6, 4);
      if is_set(winnerswinner3_best_index_0_6, 5) and winnerswinner4_best_above_0_is_equal(3) and
        winnerswinner4_best_above_0_3_value then
        winnerswinner4_best_above_0_choice(3) := winnerswinner3_best_first_0(7);
      else
        winnerswinner4_best_above_0_choice(3) := winnerswinner3_best_above_0(6);
      end if;
      for i in 0 to 3 loop
        if winnerswinner4_best_index_0_choices(i, 7) then
          winnerswinner4_best_at_start_0_choice(i) := (not is_set(winnerswinner3_best_cost_0(2 * i), 7)) or
            is_set(winnerswinner3_best_cost_0(2 * i + 1), 7);
        else
          winnerswinner4_best_at_start_0_choice(i) := (not is_set(winnerswinner3_best_cost_0(2 * i), 7)) and
            is_set(winnerswinner3_best_cost_0(2 * i + 1), 7);
        end if;
      end loop;
      for i in 0 to 3 loop
        if winnerswinner4_best_place_0(i) then
          winnerswinner4_best_second_0_choice(i) := winnerswinner3_best_second_0(2 * i + 1);
        else
          winnerswinner4_best_second_0_choice(i) := winnerswinner3_best_late_cost_0(2 * i + 1);
        end if;
        if winnerswinner4_best_at_end_0(i) then
          winnerswinner4_best_second_0_choices(i, 2) := winnerswinner3_best_but_first_0(2 * i + 1);
        else
          winnerswinner4_best_second_0_choices(i, 2) := winnerswinner4_best_second_0_choice(i);
        end if;
        if winnerswinner4_best_place_0(i) then
          winnerswinner4_best_second_0_choices(i, 3) := winnerswinner3_best_late_cost_0(2 * i);
        else
          winnerswinner4_best_second_0_choices(i, 3) := winnerswinner3_best_second_0(2 * i);
        end if;
        if winnerswinner4_best_at_start_0(i) then
          winnerswinner4_best_second_0_choices(i, 4) := winnerswinner3_best_but_last_0(2 * i);
        else
          winnerswinner4_best_second_0_choices(i, 4) := winnerswinner4_best_second_0_choices(i, 3);
        end if;
      end loop;
      winnerswinner4_best_first_0(1) <= winnerswinner3_best_first_0(2);
      winnerswinner4_best_first_0(2) <= winnerswinner3_best_first_0(4);
      winnerswinner4_best_first_0(3) <= winnerswinner3_best_first_0(6);
      winnerswinner4_best_last_0(0) <= winnerswinner3_best_last_0(1);
      winnerswinner4_best_last_0(1) <= winnerswinner3_best_last_0(3);
      winnerswinner4_best_last_0(2) <= winnerswinner3_best_last_0(5);
      winnerswinner4_best_place_0(0) <= winnerswinner4_best_index_0_choices(0, 8);
      winnerswinner4_best_place_0(1) <= winnerswinner4_best_index_0_choices(1, 8);
      winnerswinner4_best_place_0(2) <= winnerswinner4_best_index_0_choices(2, 8);
      winnerswinner4_best_place_0(3) <= winnerswinner4_best_index_0_choices(3, 8);
      winnerswinner4_best_at_start_0(0) <= winnerswinner4_best_below_0_is_equal(0) and (not
        winnerswinner4_best_at_start_0_choice(0));
      winnerswinner4_best_at_start_0(1) <= winnerswinner4_best_below_0_is_equal(1) and (not
        winnerswinner4_best_at_start_0_choice(1));
      winnerswinner4_best_at_start_0(2) <= is_set(winnerswinner3_best_index_0_5, 5) and
        winnerswinner4_best_below_0_is_equal(2) and winnerswinner4_best_below_0_2_value and (not
        winnerswinner4_best_at_start_0_choice(2));
      winnerswinner4_best_at_start_0(3) <= winnerswinner4_best_below_0_is_equal(3) and (not
        winnerswinner4_best_at_start_0_choice(3));
      winnerswinner4_best_at_end_0(0) <= winnerswinner4_best_at_start_0_choice(0) and
        winnerswinner4_best_above_0_0_is_equal;
      winnerswinner4_best_at_end_0(1) <= winnerswinner4_best_above_0_1_value and is_set(winnerswinner3_best_index_0_2,
        0) and is_set(winnerswinner3_best_index_0_2, 4) and winnerswinner4_best_above_0_1_value_2 and
        winnerswinner4_best_at_start_0_choice(1);
      winnerswinner4_best_at_end_0(2) <= is_set(winnerswinner3_best_index_0_4, 5) and
        winnerswinner4_best_above_0_is_equal(2) and winnerswinner4_best_at_start_0_choice(2);
      winnerswinner4_best_at_end_0(3) <= is_set(winnerswinner3_best_index_0_6, 5) and
        winnerswinner4_best_above_0_is_equal(3) and winnerswinner4_best_above_0_3_value and
        winnerswinner4_best_at_start_0_choice(3);
      winnerswinner4_best_late_cost_0(0) <= winnerswinner4_best_cost_0(0);
      winnerswinner4_best_late_cost_0(1) <= winnerswinner4_best_cost_0(1);
      winnerswinner4_best_late_cost_0(2) <= winnerswinner4_best_cost_0(2);
      winnerswinner4_best_late_cost_0(3) <= winnerswinner4_best_cost_0(3);
      winnerswinner4_tag_valid <= winnerswinner3_tag_valid;
      winnerswinner4_tag_map_column <= winnerswinner3_tag_map_column;
      winnerswinner4_tag_output_column <= winnerswinner3_tag_output_column;
      winnerswinner4_tag_first_column <= winnerswinner3_tag_first_column;
      winnerswinner4_tag_start_of_frame <= winnerswinner3_tag_start_of_frame;
      winnerswinner4_tag_end_of_line <= winnerswinner3_tag_end_of_line;
      for i in 0 to 3 loop
        if (winnerswinner3_best_cost_0(2 * i + 1) - winnerswinner3_best_cost_0(2 * i)) < 0 then
          winnerswinner4_best_cost_0(i) <= winnerswinner3_best_cost_0(2 * i + 1);
        else
          winnerswinner4_best_cost_0(i) <= winnerswinner3_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner4_best_index_0_choices(0, 8) then
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_1;
        winnerswinner4_best_below_0(0) <= winnerswinner4_best_below_0_choice(0);
        winnerswinner4_best_above_0(0) <= winnerswinner3_best_above_0(1);
      else
        winnerswinner4_best_index_0_0 <= winnerswinner3_best_index_0_0;
        winnerswinner4_best_below_0(0) <= winnerswinner3_best_below_0(0);
        winnerswinner4_best_above_0(0) <= winnerswinner4_best_above_0_choice(0);
      end if;
      if winnerswinner4_best_index_0_choices(1, 8) then
        winnerswinner4_best_index_0_1 <= winnerswinner3_best_index_0_3;
        winnerswinner4_best_below_0(1) <= winnerswinner4_best_below_0_choice(1);
        winnerswinner4_best_above_0(1) <= winnerswinner3_best_above_0(3);
      else
        winnerswinner4_best_index_0_1 <= winnerswinner3_best_index_0_2;
        winnerswinner4_best_below_0(1) <= winnerswinner3_best_below_0(2);
        winnerswinner4_best_above_0(1) <= winnerswinner4_best_above_0_choice(1);
      end if;
      if winnerswinner4_best_index_0_choices(2, 8) then
        winnerswinner4_best_index_0_2 <= winnerswinner3_best_index_0_5;
        winnerswinner4_best_below_0(2) <= winnerswinner4_best_below_0_choice(2);
        winnerswinner4_best_above_0(2) <= winnerswinner3_best_above_0(5);
      else
        winnerswinner4_best_index_0_2 <= winnerswinner3_best_index_0_4;
        winnerswinner4_best_below_0(2) <= winnerswinner3_best_below_0(4);
        winnerswinner4_best_above_0(2) <= winnerswinner4_best_above_0_choice(2);
      end if;
      if winnerswinner4_best_index_0_choices(3, 8) then
        winnerswinner4_best_index_0_3 <= winnerswinner3_best_index_0_7;
        winnerswinner4_best_below_0(3) <= winnerswinner4_best_below_0_choice(3);
        winnerswinner4_best_above_0(3) <= winnerswinner3_best_above_0(7);
      else
        winnerswinner4_best_index_0_3 <= winnerswinner3_best_index_0_6;
        winnerswinner4_best_below_0(3) <= winnerswinner3_best_below_0(6);
        winnerswinner4_best_above_0(3) <= winnerswinner4_best_above_0_choice(3);
      end if;
      for i in 0 to 3 loop
        if (winnerswinner4_best_second_0_choices(i, 2) - winnerswinner4_best_second_0_choices(i, 4)) < 0 then
          winnerswinner4_best_second_0(i) <= winnerswinner4_best_second_0_choices(i, 2);
        else
          winnerswinner4_best_second_0(i) <= winnerswinner4_best_second_0_choices(i, 4);
        end if;
      end loop;
      for i in 1 to 3 loop
        if (winnerswinner3_best_late_cost_0(2 * i + 1) - winnerswinner3_best_but_first_0(2 * i)) < 0 then
          winnerswinner4_best_but_first_0(i) <= winnerswinner3_best_late_cost_0(2 * i + 1);
        else
          winnerswinner4_best_but_first_0(i) <= winnerswinner3_best_but_first_0(2 * i);
        end if;
      end loop;
      for i in 0 to 2 loop
        if (winnerswinner3_best_but_last_0(2 * i + 1) - winnerswinner3_best_late_cost_0(2 * i)) < 0 then
          winnerswinner4_best_but_last_0(i) <= winnerswinner3_best_but_last_0(2 * i + 1);
        else
          winnerswinner4_best_but_last_0(i) <= winnerswinner3_best_late_cost_0(2 * i);
        end if;
      end loop;
      -- winnerswinner5
      for i in 0 to 1 loop
        if is_set(winnerswinner4_best_cost_0(2 * i), 0) then
          winnerswinner5_best_index_0_choice(i) := (not is_set(winnerswinner4_best_cost_0(2 * i + 1), 1)) or (not
            is_set(winnerswinner4_best_cost_0(2 * i + 1), 0));
        else
          winnerswinner5_best_index_0_choice(i) := not is_set(winnerswinner4_best_cost_0(2 * i + 1), 1);
        end if;
        if is_set(winnerswinner4_best_cost_0(2 * i), 1) then
          winnerswinner5_best_index_0_choices(i, 2) := winnerswinner5_best_index_0_choice(i);
        else
          winnerswinner5_best_index_0_choices(i, 2) := is_set(winnerswinner4_best_cost_0(2 * i), 0) and
            ((winnerswinner4_best_cost_0(2 * i + 1) mod 4) = 0);
        end if;
        winnerswinner5_best_index_0_value(i) := is_set(winnerswinner4_best_cost_0(2 * i + 1), 2);
        if winnerswinner5_best_index_0_choices(i, 2) then
          winnerswinner5_best_index_0_choices(i, 3) := (not is_set(winnerswinner4_best_cost_0(2 * i), 2)) and
            winnerswinner5_best_index_0_value(i);
        else
          winnerswinner5_best_index_0_choices(i, 3) := (not is_set(winnerswinner4_best_cost_0(2 * i), 2)) or
            winnerswinner5_best_index_0_value(i);
        end if;
        for j in 2 to 5 loop
          winnerswinner5_best_index_0_values(i, j) := is_set(winnerswinner4_best_cost_0(2 * i + 1), j + 1);
          if winnerswinner5_best_index_0_choices(i, j + 1) then
            winnerswinner5_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner4_best_cost_0(2 * i), j + 1)) or
              winnerswinner5_best_index_0_values(i, j);
          else
            winnerswinner5_best_index_0_choices(i, j + 2) := (not is_set(winnerswinner4_best_cost_0(2 * i), j + 1)) and
              winnerswinner5_best_index_0_values(i, j);
          end if;
        end loop;
        if winnerswinner5_best_index_0_choices(i, 7) then
          winnerswinner5_best_index_0_choices(i, 8) := is_set(winnerswinner4_best_cost_0(2 * i), 7) and (not
            is_set(winnerswinner4_best_cost_0(2 * i + 1), 7));
        else
          winnerswinner5_best_index_0_choices(i, 8) := is_set(winnerswinner4_best_cost_0(2 * i), 7) or (not
            is_set(winnerswinner4_best_cost_0(2 * i + 1), 7));
        end if;
      end loop;
      winnerswinner5_best_below_0_is_equal(0) := winnerswinner4_best_index_0_1 = 16;
      if winnerswinner5_best_below_0_is_equal(0) then
        winnerswinner5_best_below_0_choice(0) := winnerswinner4_best_last_0(0);
      else
        winnerswinner5_best_below_0_choice(0) := winnerswinner4_best_below_0(1);
      end if;
      winnerswinner5_best_below_0_is_equal(1) := winnerswinner4_best_index_0_3 = 48;
      if winnerswinner5_best_below_0_is_equal(1) then
        winnerswinner5_best_below_0_choice(1) := winnerswinner4_best_last_0(2);
      else
        winnerswinner5_best_below_0_choice(1) := winnerswinner4_best_below_0(3);
      end if;
      winnerswinner5_best_above_0_is_equal(0) := winnerswinner4_best_index_0_0 = 15;
      if winnerswinner5_best_above_0_is_equal(0) then
        winnerswinner5_best_above_0_choice(0) := winnerswinner4_best_first_0(1);
      else
        winnerswinner5_best_above_0_choice(0) := winnerswinner4_best_above_0(0);
      end if;
      winnerswinner5_best_above_0_is_equal(1) := (winnerswinner4_best_index_0_2 mod 8) = 7;
      winnerswinner5_best_above_0_1_value := is_set(winnerswinner4_best_index_0_2, 3);
      if is_set(winnerswinner4_best_index_0_2, 5) and winnerswinner5_best_above_0_is_equal(1) and
        winnerswinner5_best_above_0_1_value then
        winnerswinner5_best_above_0_choice(1) := winnerswinner4_best_first_0(3);
      else
        winnerswinner5_best_above_0_choice(1) := winnerswinner4_best_above_0(2);
      end if;
      for i in 0 to 1 loop
        if winnerswinner5_best_index_0_choices(i, 7) then
          winnerswinner5_best_at_start_0_choice(i) := (not is_set(winnerswinner4_best_cost_0(2 * i), 7)) or
            is_set(winnerswinner4_best_cost_0(2 * i + 1), 7);
        else
          winnerswinner5_best_at_start_0_choice(i) := (not is_set(winnerswinner4_best_cost_0(2 * i), 7)) and
            is_set(winnerswinner4_best_cost_0(2 * i + 1), 7);
        end if;
      end loop;
      for i in 0 to 1 loop
        if winnerswinner5_best_place_0(i) then
          winnerswinner5_best_second_0_choice(i) := winnerswinner4_best_second_0(2 * i + 1);
        else
          winnerswinner5_best_second_0_choice(i) := winnerswinner4_best_late_cost_0(2 * i + 1);
        end if;
        if winnerswinner5_best_at_end_0(i) then
          winnerswinner5_best_second_0_choices(i, 2) := winnerswinner4_best_but_first_0(2 * i + 1);
        else
          winnerswinner5_best_second_0_choices(i, 2) := winnerswinner5_best_second_0_choice(i);
        end if;
        if winnerswinner5_best_place_0(i) then
          winnerswinner5_best_second_0_choices(i, 3) := winnerswinner4_best_late_cost_0(2 * i);
        else
          winnerswinner5_best_second_0_choices(i, 3) := winnerswinner4_best_second_0(2 * i);
        end if;
        if winnerswinner5_best_at_start_0(i) then
          winnerswinner5_best_second_0_choices(i, 4) := winnerswinner4_best_but_last_0(2 * i);
        else
          winnerswinner5_best_second_0_choices(i, 4) := winnerswinner5_best_second_0_choices(i, 3);
        end if;
      end loop;
      winnerswinner5_best_first_0_1 <= winnerswinner4_best_first_0(2);
      winnerswinner5_best_last_0_0 <= winnerswinner4_best_last_0(1);
      winnerswinner5_best_place_0(0) <= winnerswinner5_best_index_0_choices(0, 8);
      winnerswinner5_best_place_0(1) <= winnerswinner5_best_index_0_choices(1, 8);
      winnerswinner5_best_at_start_0(0) <= winnerswinner5_best_below_0_is_equal(0) and (not
        winnerswinner5_best_at_start_0_choice(0));
      winnerswinner5_best_at_start_0(1) <= winnerswinner5_best_below_0_is_equal(1) and (not
        winnerswinner5_best_at_start_0_choice(1));
      winnerswinner5_best_at_end_0(0) <= winnerswinner5_best_above_0_is_equal(0) and
        winnerswinner5_best_at_start_0_choice(0);
      winnerswinner5_best_at_end_0(1) <= is_set(winnerswinner4_best_index_0_2, 5) and
        winnerswinner5_best_above_0_is_equal(1) and winnerswinner5_best_above_0_1_value and
        winnerswinner5_best_at_start_0_choice(1);
      winnerswinner5_best_late_cost_0(0) <= winnerswinner5_best_cost_0(0);
      winnerswinner5_best_late_cost_0(1) <= winnerswinner5_best_cost_0(1);
      winnerswinner5_tag_valid <= winnerswinner4_tag_valid;
      winnerswinner5_tag_map_column <= winnerswinner4_tag_map_column;
      winnerswinner5_tag_output_column <= winnerswinner4_tag_output_column;
      winnerswinner5_tag_first_column <= winnerswinner4_tag_first_column;
      winnerswinner5_tag_start_of_frame <= winnerswinner4_tag_start_of_frame;
      winnerswinner5_tag_end_of_line <= winnerswinner4_tag_end_of_line;
      for i in 0 to 1 loop
        if (winnerswinner4_best_cost_0(2 * i + 1) - winnerswinner4_best_cost_0(2 * i)) < 0 then
          winnerswinner5_best_cost_0(i) <= winnerswinner4_best_cost_0(2 * i + 1);
        else
          winnerswinner5_best_cost_0(i) <= winnerswinner4_best_cost_0(2 * i);
        end if;
      end loop;
      if winnerswinner5_best_index_0_choices(0, 8) then
        winnerswinner5_best_index_0_0 <= winnerswinner4_best_index_0_1;
        winnerswinner5_best_below_0(0) <= winnerswinner5_best_below_0_choice(0);
        winnerswinner5_best_above_0(0) <= winnerswinner4_best_above_0(1);
      else
        winnerswinner5_best_index_0_0 <= winnerswinner4_best_index_0_0;
        winnerswinner5_best_below_0(0) <= winnerswinner4_best_below_0(0);
        winnerswinner5_best_above_0(0) <= winnerswinner5_best_above_0_choice(0);
      end if;
      if winnerswinner5_best_index_0_choices(1, 8) then
        winnerswinner5_best_index_0_1 <= winnerswinner4_best_index_0_3;
        winnerswinner5_best_below_0(1) <= winnerswinner5_best_below_0_choice(1);
        winnerswinner5_best_above_0(1) <= winnerswinner4_best_above_0(3);
      else
        winnerswinner5_best_index_0_1 <= winnerswinner4_best_index_0_2;
        winnerswinner5_best_below_0(1) <= winnerswinner4_best_below_0(2);
        winnerswinner5_best_above_0(1) <= winnerswinner5_best_above_0_choice(1);
      end if;
      for i in 0 to 1 loop
        if (winnerswinner5_best_second_0_choices(i, 2) - winnerswinner5_best_second_0_choices(i, 4)) < 0 then
          winnerswinner5_best_second_0(i) <= winnerswinner5_best_second_0_choices(i, 2);
        else
          winnerswinner5_best_second_0(i) <= winnerswinner5_best_second_0_choices(i, 4);
        end if;
      end loop;
      if (winnerswinner4_best_late_cost_0(3) - winnerswinner4_best_but_first_0(2)) < 0 then
        winnerswinner5_best_but_first_0_1 <= winnerswinner4_best_late_cost_0(3);
      else
        winnerswinner5_best_but_first_0_1 <= winnerswinner4_best_but_first_0(2);
      end if;
      if (winnerswinner4_best_but_last_0(1) - winnerswinner4_best_late_cost_0(0)) < 0 then
        winnerswinner5_best_but_last_0_0 <= winnerswinner4_best_but_last_0(1);
      else
        winnerswinner5_best_but_last_0_0 <= winnerswinner4_best_late_cost_0(0);
      end if;
      -- winnerswinner6
      if is_set(winnerswinner5_best_cost_0(0), 0) then
        winnerswinner6_best_index_0_0_choice := (not is_set(winnerswinner5_best_cost_0(1), 1)) or (not
          is_set(winnerswinner5_best_cost_0(1), 0));
      else
        winnerswinner6_best_index_0_0_choice := not is_set(winnerswinner5_best_cost_0(1), 1);
      end if;
      if is_set(winnerswinner5_best_cost_0(0), 1) then
        winnerswinner6_best_index_0_0_choices(2) := winnerswinner6_best_index_0_0_choice;
      else
        winnerswinner6_best_index_0_0_choices(2) := is_set(winnerswinner5_best_cost_0(0), 0) and
          ((winnerswinner5_best_cost_0(1) mod 4) = 0);
      end if;
      winnerswinner6_best_index_0_0_value := is_set(winnerswinner5_best_cost_0(1), 2);
      if winnerswinner6_best_index_0_0_choices(2) then
        winnerswinner6_best_index_0_0_choices(3) := (not is_set(winnerswinner5_best_cost_0(0), 2)) and
          winnerswinner6_best_index_0_0_value;
      else
        winnerswinner6_best_index_0_0_choices(3) := (not is_set(winnerswinner5_best_cost_0(0), 2)) or
          winnerswinner6_best_index_0_0_value;
      end if;
      for i in 2 to 5 loop
        winnerswinner6_best_index_0_0_values(i) := is_set(winnerswinner5_best_cost_0(1), i + 1);
        if winnerswinner6_best_index_0_0_choices(i + 1) then
          winnerswinner6_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner5_best_cost_0(0), i + 1)) or
            winnerswinner6_best_index_0_0_values(i);
        else
          winnerswinner6_best_index_0_0_choices(i + 2) := (not is_set(winnerswinner5_best_cost_0(0), i + 1)) and
            winnerswinner6_best_index_0_0_values(i);
        end if;
      end loop;
      if winnerswinner6_best_index_0_0_choices(7) then
        winnerswinner6_best_index_0_0_choices(8) := is_set(winnerswinner5_best_cost_0(0), 7) and (not
          is_set(winnerswinner5_best_cost_0(1), 7));
      else
        winnerswinner6_best_index_0_0_choices(8) := is_set(winnerswinner5_best_cost_0(0), 7) or (not
          is_set(winnerswinner5_best_cost_0(1), 7));
      end if;
      winnerswinner6_best_below_0_0_is_equal := winnerswinner5_best_index_0_1 = 32;
      if winnerswinner6_best_below_0_0_is_equal then
        winnerswinner6_best_below_0_0_choice := winnerswinner5_best_last_0_0;
      else
        winnerswinner6_best_below_0_0_choice := winnerswinner5_best_below_0(1);
      end if;
      winnerswinner6_best_above_0_0_is_equal := winnerswinner5_best_index_0_0 = 31;
      if winnerswinner6_best_above_0_0_is_equal then
        winnerswinner6_best_above_0_0_choice := winnerswinner5_best_first_0_1;
      else
        winnerswinner6_best_above_0_0_choice := winnerswinner5_best_above_0(0);
      end if;
      if winnerswinner6_best_index_0_0_choices(7) then
        winnerswinner6_best_at_start_0_0_choice := (not is_set(winnerswinner5_best_cost_0(0), 7)) or
          is_set(winnerswinner5_best_cost_0(1), 7);
      else
        winnerswinner6_best_at_start_0_0_choice := (not is_set(winnerswinner5_best_cost_0(0), 7)) and
          is_set(winnerswinner5_best_cost_0(1), 7);
      end if;
      if winnerswinner6_best_place_0_0 then
        winnerswinner6_best_second_0_0_choice := winnerswinner5_best_second_0(1);
      else
        winnerswinner6_best_second_0_0_choice := winnerswinner5_best_late_cost_0(1);
      end if;
      if winnerswinner6_best_at_end_0_0 then
        winnerswinner6_best_second_0_0_choices(2) := winnerswinner5_best_but_first_0_1;
      else
        winnerswinner6_best_second_0_0_choices(2) := winnerswinner6_best_second_0_0_choice;
      end if;
      if winnerswinner6_best_place_0_0 then
        winnerswinner6_best_second_0_0_choices(3) := winnerswinner5_best_late_cost_0(0);
      else
        winnerswinner6_best_second_0_0_choices(3) := winnerswinner5_best_second_0(0);
      end if;
      if winnerswinner6_best_at_start_0_0 then
        winnerswinner6_best_second_0_0_choices(4) := winnerswinner5_best_but_last_0_0;
      else
        winnerswinner6_best_second_0_0_choices(4) := winnerswinner6_best_second_0_0_choices(3);
      end if;
      winnerswinner6_best_place_0_0 <= winnerswinner6_best_index_0_0_choices(8);
      winnerswinner6_best_at_start_0_0 <= winnerswinner6_best_below_0_0_is_equal and (not
        winnerswinner6_best_at_start_0_0_choice);
      winnerswinner6_best_at_end_0_0 <= winnerswinner6_best_at_start_0_0_choice and
        winnerswinner6_best_above_0_0_is_equal;
      winnerswinner6_best_late_cost_0_0 <= winnerswinner6_best_cost_0_0;
      winnerswinner6_tag_valid <= winnerswinner5_tag_valid;
      winnerswinner6_tag_map_column <= winnerswinner5_tag_map_column;
      winnerswinner6_tag_output_column <= winnerswinner5_tag_output_column;
      winnerswinner6_tag_first_column <= winnerswinner5_tag_first_column;
      winnerswinner6_tag_start_of_frame <= winnerswinner5_tag_start_of_frame;
      winnerswinner6_tag_end_of_line <= winnerswinner5_tag_end_of_line;
      if (winnerswinner5_best_cost_0(1) - winnerswinner5_best_cost_0(0)) < 0 then
        winnerswinner6_best_cost_0_0 <= winnerswinner5_best_cost_0(1);
      else
        winnerswinner6_best_cost_0_0 <= winnerswinner5_best_cost_0(0);
      end if;
      if winnerswinner6_best_index_0_0_choices(8) then
        winnerswinner6_best_index_0_0 <= winnerswinner5_best_index_0_1;
        winnerswinner6_best_below_0_0 <= winnerswinner6_best_below_0_0_choice;
        winnerswinner6_best_above_0_0 <= winnerswinner5_best_above_0(1);
      else
        winnerswinner6_best_index_0_0 <= winnerswinner5_best_index_0_0;
        winnerswinner6_best_below_0_0 <= winnerswinner5_best_below_0(0);
        winnerswinner6_best_above_0_0 <= winnerswinner6_best_above_0_0_choice;
      end if;
      if (winnerswinner6_best_second_0_0_choices(2) - winnerswinner6_best_second_0_0_choices(4)) < 0 then
        winnerswinner6_best_second_0_0 <= winnerswinner6_best_second_0_0_choices(2);
      else
        winnerswinner6_best_second_0_0 <= winnerswinner6_best_second_0_0_choices(4);
      end if;
      -- winners
      winners_partner_at_sum := winners_partner_column + 1;
      if winnerswinner6_tag_first_column then
        winners_partner_at_choice := 0;
      else
        winners_partner_at_choice := winners_partner_at_sum;
      end if;
      winners_best_index_0_0 <= winnerswinner6_best_index_0_0;
      winners_best_below_0_0 <= winnerswinner6_best_below_0_0;
      winners_best_above_0_0 <= winnerswinner6_best_above_0_0;
      winners_best_place_0 <= median_read_bottom;
      winners_best_late_cost_0_0 <= winnerswinner6_best_late_cost_0_0;
      winners_best_second_0_0 <= winnerswinner6_best_second_0_0;
      winners_best_tag_valid <= winnerswinner6_tag_valid;
      winners_best_tag_map_column <= winnerswinner6_tag_map_column;
      winners_best_tag_output_column <= winnerswinner6_tag_output_column;
      winners_best_tag_start_of_frame <= winnerswinner6_tag_start_of_frame;
      winners_best_tag_end_of_line <= winnerswinner6_tag_end_of_line;
      winners_partner_at <= winners_partner_at_choice + winnerswinner6_best_index_0_0;
      if winnerswinner6_tag_valid then
        if winnerswinner6_tag_first_column then
          winners_partner_column <= 0;
        else
          winners_partner_column <= winners_partner_at_sum mod 512;
        end if;
      end if;
      -- refinement
      refinement_below_0_differs := winners_best_index_0_0 /= 0;
      refinement_below_0_differs_2 := winners_best_below_0_0 /= 255;
      refinement_below_0_all := refinement_below_0_differs and refinement_below_0_differs_2;
      if winners_best_index_0_0 = 63 then
        refinement_above_0_choice := refinement_below_0_all;
      else
        refinement_above_0_choice := (winners_best_above_0_0 = 255) and refinement_below_0_differs and
          refinement_below_0_differs_2;
      end if;
      refinement_remainder_1_0_difference := (refinement_remainder_0(0) + 512) - refinement_divisor_0(0);
      for i in 2 to 7 loop
        refinement_remainder_0_difference(i) := ((refinement_remainder_0(i - 1) * 2) + 512) - refinement_divisor_0(i -
          1);
      end loop;
      refinement_divisor_0_0_is_less := (-1) < refinement_difference_0;
      if refinement_divisor_0_0_is_less then
        refinement_divisor_0_0_choice := refinement_v_0;
      else
        refinement_divisor_0_0_choice := refinement_u_0;
      end if;
      refinement_fraction_0_difference := 0 - (refinement_quotient_8_0 / 16);
      refinement_fraction_0_value := (refinement_quotient_8_0 + 15) / 16;
      if refinement_negative_0(8) then
        refinement_fraction_0_choice := refinement_fraction_0_difference mod 256;
      else
        refinement_fraction_0_choice := refinement_fraction_0_value;
      end if;
      if refinement_negative_0(8) then
        refinement_fraction_0_choice_2 := refinement_fraction_0_difference mod 8;
      else
        refinement_fraction_0_choice_2 := refinement_fraction_0_value mod 8;
      end if;
      refinement_disparity_0(0) <= winners_best_index_0_0;
      for i in 1 to 11 loop
        refinement_disparity_0(i) <= refinement_disparity_0(i - 1);
      end loop;
      refinement_passed_0(0) <= winners_partner_at < 448;
      for i in 1 to 11 loop
        refinement_passed_0(i) <= refinement_passed_0(i - 1);
      end loop;
      refinement_tag_valid(0) <= winners_best_tag_valid;
      refinement_tag_map_column(0) <= winners_best_tag_map_column;
      refinement_tag_output_column(0) <= winners_best_tag_output_column;
      refinement_tag_start_of_frame(0) <= winners_best_tag_start_of_frame;
      refinement_tag_end_of_line(0) <= winners_best_tag_end_of_line;
      for i in 1 to 11 loop
        refinement_tag_valid(i) <= refinement_tag_valid(i - 1);
        refinement_tag_map_column(i) <= refinement_tag_map_column(i - 1);
        refinement_tag_output_column(i) <= refinement_tag_output_column(i - 1);
        refinement_tag_start_of_frame(i) <= refinement_tag_start_of_frame(i - 1);
        refinement_tag_end_of_line(i) <= refinement_tag_end_of_line(i - 1);
      end loop;
      refinement_alone_0_0 <= winners_best_second_0_0 = 255;
      refinement_gap_0 <= (winners_best_second_0_0 - winners_best_late_cost_0_0) mod 256;
      for i in 1 to 9 loop
        refinement_margin_0(i) <= refinement_margin_0(i - 1);
      end loop;
      refinement_u_0 <= (refinement_below_0 - winners_best_late_cost_0_0) mod 256;
      refinement_v_0 <= (refinement_above_0 - winners_best_late_cost_0_0) mod 256;
      refinement_difference_0 <= refinement_above_0 - refinement_below_0;
      refinement_remainder_0(0) <= magnitude(refinement_difference_0);
      refinement_divisor_0(0) <= to_integer(((to_unsigned(refinement_divisor_0_0_choice, 8)) or
        (to_unsigned(as_number(((refinement_v_0 = 0) and (refinement_u_0 = 0))), 8))));
      for i in 1 to 7 loop
        refinement_divisor_0(i) <= refinement_divisor_0(i - 1);
      end loop;
      refinement_quotient_8_0 <= ((((refinement_remainder_0(7) * 2) + 512) - refinement_divisor_0(7)) / 512) +
        ((other_4 / 2) * 2);
      refinement_negative_0(0) <= refinement_divisor_0_0_is_less;
      for i in 1 to 8 loop
        refinement_negative_0(i) <= refinement_negative_0(i - 1);
      end loop;
      refinement_fraction_0 <= ((((refinement_fraction_0_choice / 8) + 1) mod 4) * 8) + refinement_fraction_0_choice_2;
      if (not refinement_alone_0_0) and ((refinement_gap_0 / 64) = 0) then
        refinement_margin_0(0) <= refinement_gap_0 mod 64;
      else
        refinement_margin_0(0) <= 63;
      end if;
      if refinement_below_0_all then
        refinement_below_0 <= winners_best_below_0_0;
      else
        refinement_below_0 <= winners_best_above_0_0;
      end if;
      if refinement_above_0_choice then
        refinement_above_0 <= winners_best_below_0_0;
      else
        refinement_above_0 <= winners_best_above_0_0;
      end if;
      if is_set(refinement_remainder_1_0_difference, 9) then
        refinement_remainder_0(1) <= refinement_remainder_1_0_difference mod 256;
      else
        refinement_remainder_0(1) <= refinement_remainder_0(0);
      end if;
      for i in 2 to 7 loop
        if is_set(refinement_remainder_0_difference(i), 9) then
          refinement_remainder_0(i) <= refinement_remainder_0_difference(i) mod 256;
        else
          refinement_remainder_0(i) <= (refinement_remainder_0(i - 1) mod 128) * 2;
        end if;
      end loop;
      -- leftright
      if (not is_set(leftright_ring_read_address, 5)) and ((leftright_ring_read_address mod 8) = 0) then
        leftright_holds_winners_choice := (not leftright_holds_winners) and (is_set(leftright_ring_read_address, 4) or
          is_set(leftright_ring_read_address, 3));
      else
        leftright_holds_winners_choice := not leftright_holds_winners;
      end if;
      leftright_address_0_value := to_integer(leftright_held_0(9 downto 4));
      leftright_checked_passed_0_difference := (leftright_answered_disparity_0 + 1) - to_integer(leftright_found_0);
      leftright_other_0(1) <= winnersother_winner_out_0;
      for i in 2 to 17 loop
        leftright_other_0(i) <= leftright_other_0(i - 1);
      end loop;
      leftright_position <= (leftright_position + as_number(refinement_tag_valid(11))) mod 128;
      leftright_held_position <= leftright_position;
      leftright_held_valid <= (not leftright_holds_winners_choice) and refinement_tag_valid(11);
      leftright_address_0 <= (leftright_address_0_value + leftright_held_position + 65) mod 128;
      leftright_asking_disparity_0 <= leftright_address_0_value;
      leftright_asking_fraction_0 <= to_integer(leftright_held_0(17 downto 13));
      leftright_asking_passed_0 <= leftright_held_0(12) = '1';
      leftright_asking_margin_0 <= to_integer(leftright_held_1);
      leftright_asking_tag_valid <= leftright_held_valid;
      leftright_asking_tag_map_column <= leftright_held_0(0) = '1';
      leftright_asking_tag_output_column <= leftright_held_0(1) = '1';
      leftright_asking_tag_start_of_frame <= leftright_held_0(2) = '1';
      leftright_asking_tag_end_of_line <= leftright_held_0(3) = '1';
      leftright_answered_disparity_0 <= leftright_asking_disparity_0;
      leftright_answered_fraction_0 <= leftright_asking_fraction_0;
      leftright_answered_passed_0 <= leftright_asking_passed_0;
      leftright_answered_margin_0 <= leftright_asking_margin_0;
      leftright_answered_tag_valid <= leftright_asking_tag_valid;
      leftright_answered_tag_map_column <= leftright_asking_tag_map_column;
      leftright_answered_tag_output_column <= leftright_asking_tag_output_column;
      leftright_answered_tag_start_of_frame <= leftright_asking_tag_start_of_frame;
      leftright_answered_tag_end_of_line <= leftright_asking_tag_end_of_line;
      leftright_checked_disparity_0 <= leftright_answered_disparity_0;
      leftright_checked_fraction_0 <= leftright_answered_fraction_0;
      leftright_checked_passed_0 <= leftright_answered_passed_0 and (leftright_checked_passed_0_difference >= 0) and
        (leftright_checked_passed_0_difference < 3);
      leftright_checked_margin_0 <= leftright_answered_margin_0;
      leftright_checked_tag_valid <= leftright_answered_tag_valid;
      leftright_checked_tag_map_column <= leftright_answered_tag_map_column;
      leftright_checked_tag_output_column <= leftright_answered_tag_output_column;
      leftright_checked_tag_start_of_frame <= leftright_answered_tag_start_of_frame;
      leftright_checked_tag_end_of_line <= leftright_answered_tag_end_of_line;
      if leftright_holds_winners_choice then
        leftright_holds_winners <= (not refinement_tag_valid(11)) and leftright_holds_winners;
      else
        leftright_holds_winners <= refinement_tag_valid(11) or leftright_holds_winners;
      end if;
      if refinement_tag_valid(11) then
        leftright_ring_write_address <= leftright_ring_read_address;
        if leftright_ring_read_address = 63 then
          leftright_ring_read_address <= 0;
        else
          leftright_ring_read_address <= (leftright_ring_read_address + 1) mod 64;
        end if;
      end if;
      -- turn
      turn_order_address_any := turn_order_inside or (not leftright_checked_tag_map_column) or (not
        leftright_checked_tag_valid);
      if turn_order_falls then
        turn_order_address_choice := 511;
      else
        turn_order_address_choice := 1;
      end if;
      if turn_order_falls then
        turn_order_address_choice_2 := 0;
      else
        turn_order_address_choice_2 := 447;
      end if;
      turn_order_address_any_2 := (not leftright_checked_tag_map_column) or (not leftright_checked_tag_valid);
      if not turn_order_address_any_2 then
        if turn_order_address_any then
          turn_order_address <= (turn_order_address_choice + turn_order_address) mod 512;
        else
          turn_order_address <= turn_order_address_choice_2;
        end if;
      end if;
      turn_order_falls_all := (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid;
      turn_order_complete_all := leftright_checked_tag_map_column and leftright_checked_tag_valid;
      turn_ready_tag_row_start_differs := support_counter_group /= 377;
      turn_ready_tag_row_start_is_equal := support_counter_column = 447;
      if turn_ready_tag_row_start_is_equal then
        turn_ready_tag_row_start_choice := (support_counter_group /= 376) and turn_ready_tag_row_start;
      else
        turn_ready_tag_row_start_choice := turn_ready_tag_row_start;
      end if;
      if turn_ready_tag_row_start_differs then
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start_choice;
      else
        turn_ready_tag_row_start_choices(2) := turn_ready_tag_row_start;
      end if;
      turn_ready_tag_row_start_is_equal_2 := support_counter_group = 374;
      turn_ready_tag_row_start_all := turn_ready_tag_row_start_is_equal_2 and turn_ready_tag_row_start_is_equal;
      if turn_ready_tag_row_start_choices(2) then
        turn_ready_tag_row_start_choices(3) := (not turn_ready_tag_start_of_frame) or turn_ready_tag_row_start_all;
      else
        turn_ready_tag_row_start_choices(3) := turn_ready_tag_start_of_frame and turn_ready_tag_row_start_is_equal_2
          and turn_ready_tag_row_start_is_equal;
      end if;
      turn_ready_tag_row_start_all_2 := turn_ready_tag_map_column and turn_ready_tag_valid;
      turn_order_turned_valid <= leftright_checked_tag_valid;
      turn_order_turned_map_column <= leftright_checked_tag_map_column;
      turn_order_turned_start_of_frame <= (not turn_order_inside) and leftright_checked_tag_map_column and
        leftright_checked_tag_valid and turn_order_first and turn_order_output and turn_order_complete;
      turn_order_turned_end_of_line <= leftright_checked_tag_end_of_line;
      turn_newest <= (leftright_checked_fraction_0 * 512) + leftright_checked_disparity_0 +
        (as_number(leftright_checked_passed_0) * 256) + (leftright_checked_margin_0 * 16384);
      turn_comes <= turn_order_complete_all;
      turn_read_tag_valid <= turn_order_turned_valid;
      turn_read_tag_map_column <= turn_order_turned_map_column;
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
      if leftright_checked_tag_end_of_line then
        turn_order_complete <= turn_order_complete or turn_order_complete_all;
      else
        turn_order_complete <= turn_order_complete and turn_order_address_any_2;
      end if;
      if turn_ready_tag_row_start_choices(3) then
        turn_ready_tag_row_start <= turn_ready_tag_row_start or turn_ready_tag_row_start_all_2;
      else
        turn_ready_tag_row_start <= turn_ready_tag_row_start and ((not turn_ready_tag_map_column) or (not
          turn_ready_tag_valid));
      end if;
      if leftright_checked_tag_valid then
        turn_order_inside <= leftright_checked_tag_map_column;
      end if;
      if turn_order_falls_all then
        turn_order_output <= leftright_checked_tag_output_column;
        turn_order_first <= leftright_checked_tag_start_of_frame;
      end if;
      if turn_comes then
        turn_write_words_0 <= turn_newest;
        turn_write_place <= turn_order_address;
      end if;
      -- support
      if turn_ready_tag_row_start_all_2 then
        if turn_ready_tag_start_of_frame or turn_ready_tag_row_start_is_equal then
          support_counter_column <= 0;
        else
          support_counter_column <= (support_counter_column + 1) mod 512;
        end if;
      end if;
      if turn_ready_tag_row_start_all then
        support_counter_group_choice := 375;
      else
        support_counter_group_choice := 0;
      end if;
      if (support_counter_group = 376) and turn_ready_tag_row_start then
        support_counter_group_choices(2) := 2;
      else
        support_counter_group_choices(2) := (support_counter_group + 1) mod 512;
      end if;
      if turn_ready_tag_row_start_differs and turn_ready_tag_row_start_is_equal and turn_ready_tag_map_column and
        turn_ready_tag_valid then
        support_counter_group_choices(3) := support_counter_group_choices(2);
      else
        support_counter_group_choices(3) := support_counter_group;
      end if;
      support_newest_0_value := (((turn_ready / 512) mod 16) / 8) = 1;
      if support_ready_arrives and support_ready_above2 then
        support_column_choice(0) := 127;
      else
        support_column_choice(0) := 63;
      end if;
      if support_ready_above1 and support_ready_arrives then
        support_column_choice(1) := 127;
      else
        support_column_choice(1) := 63;
      end if;
      if support_ready_arrives then
        support_column_choice(2) := 127;
      else
        support_column_choice(2) := 63;
      end if;
      if support_ready_below2 and support_ready_arrives then
        support_column_choice(3) := 127;
      else
        support_column_choice(3) := 63;
      end if;
      if support_ready_below1 and support_ready_arrives then
        support_column_choice(4) := 127;
      else
        support_column_choice(4) := 63;
      end if;
      if support_at_moves then
        support_moment_0_start_of_frame_choice := support_at_arrives;
      else
        support_moment_0_start_of_frame_choice := support_moment_start_of_frame(0);
      end if;
      if support_row_tag(0) then
        support_next_tag_choice := (not support_at_moves) and support_next_tag;
      else
        support_next_tag_choice := support_at_moves or support_next_tag;
      end if;
      if support_at_moves then
        support_next_tag_choice_2 := support_row_tag(0);
      else
        support_next_tag_choice_2 := support_next_tag;
      end if;
      support_like_0_0_0_difference := 1 - (support_cells(6, 2) mod 64);
      support_like_0_value(0, 0) := ((support_cells(0, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      if support_row_tag(6) then
        support_like_0_0_choice(0) := support_next_tag and is_set(support_cells(0, 0), 6);
      else
        support_like_0_0_choice(0) := (not support_next_tag) and is_set(support_cells(0, 0), 6);
      end if;
      support_like_0_value(0, 1) := ((support_cells(0, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_1_differs(0) := support_row_tag(6) /= (not support_next_tag);
      for i in 0 to 1 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := ((support_cells(2 * i, j) mod 64) + support_like_0_0_0_difference) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := ((support_cells(2 * i + 2, 0) mod 64) + support_like_0_0_0_difference) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choice(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := ((support_cells(2 * i + 2, 1) mod 64) + support_like_0_0_0_difference) mod
          128;
        support_like_0_1_differs(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(2, i) := ((support_cells(4, i) mod 64) + support_like_0_0_0_difference) mod 128;
      end loop;
      support_like_0_value(3, 0) := ((support_cells(6, 0) mod 64) + support_like_0_0_0_difference) mod 128;
      support_like_0_value(3, 1) := ((support_cells(6, 1) mod 64) + support_like_0_0_0_difference) mod 128;
      for i in 3 to 5 loop
        for j in 2 to 4 loop
          support_like_0_value(i, j) := (support_like_0_0_0_difference + (support_cells(2 * i, j) mod 64)) mod 128;
        end loop;
        support_like_0_value(i + 1, 0) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 0) mod 64)) mod
          128;
        if support_row_tag(2 * i + 2) then
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and support_row_tag(6);
        else
          support_like_0_0_choices(i + 1) := is_set(support_cells(2 * i + 2, 0), 6) and (not support_row_tag(6));
        end if;
        support_like_0_value(i + 1, 1) := (support_like_0_0_0_difference + (support_cells(2 * i + 2, 1) mod 64)) mod
          128;
        support_like_0_1_differss(i + 1) := support_row_tag(2 * i + 2) /= (not support_row_tag(6));
      end loop;
      for i in 2 to 4 loop
        support_like_0_value(6, i) := (support_like_0_0_0_difference + (support_cells(12, i) mod 64)) mod 128;
      end loop;
      if support_sum_0 < 255 then
        support_out_sure_0_choice := support_sum_0 mod 256;
      else
        support_out_sure_0_choice := 255;
      end if;
      support_out_tag_row_start_differs := fill_counter_group /= 376;
      support_out_tag_row_start_is_equal := fill_counter_column = 447;
      if support_out_tag_row_start_is_equal then
        support_out_tag_row_start_choice := (fill_counter_group /= 375) and support_out_tag_row_start;
      else
        support_out_tag_row_start_choice := support_out_tag_row_start;
      end if;
      if support_out_tag_row_start_differs then
        support_out_tag_row_start_choices(2) := support_out_tag_row_start_choice;
      else
        support_out_tag_row_start_choices(2) := support_out_tag_row_start;
      end if;
      support_out_tag_row_start_is_equal_2 := fill_counter_group = 374;
      support_out_tag_row_start_all := support_out_tag_row_start_is_equal_2 and support_out_tag_row_start_is_equal;
      if support_out_tag_row_start_choices(2) then
        support_out_tag_row_start_choices(3) := (not support_out_tag_start_of_frame) or support_out_tag_row_start_all;
      else
        support_out_tag_row_start_choices(3) := support_out_tag_start_of_frame and support_out_tag_row_start_is_equal_2
          and support_out_tag_row_start_is_equal;
      end if;
      support_out_tag_row_start_all_2 := support_out_tag_map_column and support_out_tag_valid;
      support_newest_0 <= ((((((turn_ready + (((turn_ready / 512) mod 32) / 16)) mod 64) * 2) +
        as_number(support_newest_0_value)) * 8) / 16) + (((turn_ready / 256) mod 2) * 64);
      support_newest_rest_0 <= (as_number(support_newest_0_value) * 8) + ((turn_ready / 512) mod 8) + ((turn_ready /
        16384) * 16);
      support_moves <= turn_ready_tag_valid;
      support_arrives <= turn_ready_tag_row_start_all_2;
      support_last <= turn_ready_tag_end_of_line and turn_ready_tag_map_column and turn_ready_tag_valid;
      support_rows_read_newest_0 <= support_newest_0;
      support_rows_ready_words_0 <= to_integer(support_rows_read_words_0);
      support_rows_ready_newest_0 <= support_rows_read_newest_0;
      support_rest_rows_read_newest_0 <= support_newest_rest_0;
      support_rest_rows_ready_words_0 <= to_integer(support_rest_rows_read_words_0);
      support_rest_rows_ready_newest_0 <= support_rest_rows_read_newest_0;
      support_read_column <= support_counter_column;
      support_read_moves <= support_moves;
      support_read_arrives <= support_arrives;
      support_read_above2 <= 3 < support_counter_group;
      support_read_above1 <= 2 < support_counter_group;
      support_read_below1 <= support_counter_group < 375;
      support_read_below2 <= support_counter_group < 376;
      support_read_first <= (support_counter_column = 0) and (support_counter_group = 2);
      support_read_last <= support_last;
      support_ready_column <= support_read_column;
      support_ready_moves <= support_read_moves;
      support_ready_arrives <= support_read_arrives;
      support_ready_above2 <= support_read_above2;
      support_ready_above1 <= support_read_above1;
      support_ready_below1 <= support_read_below1;
      support_ready_below2 <= support_read_below2;
      support_ready_first <= support_read_first;
      support_ready_last <= support_read_last;
      support_column(0) <= to_integer(((to_unsigned(support_column_choice(0), 7)) and
        (to_unsigned((support_rows_ready_words_0 mod 128), 7))));
      support_column(1) <= to_integer(((to_unsigned(support_column_choice(1), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 128) mod 128), 7))));
      support_column(2) <= to_integer(((to_unsigned(support_column_choice(2), 7)) and
        (to_unsigned(((support_rows_ready_words_0 / 16384) mod 128), 7))));
      support_column(3) <= to_integer(((to_unsigned(support_column_choice(3), 7)) and
        (to_unsigned((support_rows_ready_words_0 / 2097152), 7))));
      support_column(4) <= to_integer(((to_unsigned(support_rows_ready_newest_0, 7)) and
        (to_unsigned(support_column_choice(4), 7))));
      support_column_rest_0 <= support_rest_rows_ready_words_0 mod 1024;
      support_at_moves <= support_ready_moves;
      support_at_arrives <= support_ready_arrives;
      support_at_first <= support_ready_first;
      support_at_last <= support_ready_last;
      support_moved <= support_at_moves;
      for i in 0 to 2 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_cells(2 * i, 0) +
          support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choice(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_cells(2 * i, j) +
            support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differs(i);
        end loop;
      end loop;
      support_like_0(3, 0) <= ((not is_set(support_like_0_value(3, 0), 1)) or (not (((support_cells(6, 0) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 0) / 4) = 0) and
        is_set(support_cells(6, 0), 6);
      support_like_0(3, 1) <= ((not is_set(support_like_0_value(3, 1), 1)) or (not (((support_cells(6, 1) +
        support_like_0_0_0_difference) mod 2) = 1))) and ((support_like_0_value(3, 1) / 4) = 0) and
        is_set(support_cells(6, 1), 6);
      for i in 2 to 4 loop
        support_like_0(3, i) <= ((not is_set(support_like_0_value(3, i), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(6, i)) mod 2) = 1))) and ((support_like_0_value(3, i) / 4) = 0) and is_set(support_cells(6, i),
          6);
      end loop;
      for i in 4 to 6 loop
        support_like_0(i, 0) <= ((not is_set(support_like_0_value(i, 0), 1)) or (not (((support_like_0_0_0_difference +
          support_cells(2 * i, 0)) mod 2) = 1))) and ((support_like_0_value(i, 0) / 4) = 0) and
          support_like_0_0_choices(i);
        for j in 1 to 4 loop
          support_like_0(i, j) <= ((not is_set(support_like_0_value(i, j), 1)) or (not (((support_like_0_0_0_difference
            + support_cells(2 * i, j)) mod 2) = 1))) and ((support_like_0_value(i, j) / 4) = 0) and
            is_set(support_cells(2 * i, j), 6) and support_like_0_1_differss(i);
        end loop;
      end loop;
      for i in 0 to 6 loop
        support_partial_0(i) <= as_number(support_like_0(i, 3)) + as_number(support_like_0(i, 0)) +
          as_number(support_like_0(i, 1)) + as_number(support_like_0(i, 4)) + as_number(support_like_0(i, 2));
      end loop;
      support_count_0 <= support_partial_0(6) + support_partial_0(4) + support_partial_0(3) + support_partial_0(1) +
        support_partial_0(5) + support_partial_0(0) + support_partial_0(2);
      support_sum_0 <= ((((support_centre_rest_0(2) / 16) + ((support_count_0 * 2) / 4)) * 2) + (support_count_0 mod
        2)) * 2;
      support_centre_0(0) <= support_cells(6, 2);
      support_centre_0(1) <= support_centre_0(0);
      support_centre_0(2) <= support_centre_0(1);
      support_centre_rest_0(0) <= support_rest_0(6);
      support_centre_rest_0(1) <= support_centre_rest_0(0);
      support_centre_rest_0(2) <= support_centre_rest_0(1);
      support_centre_moment_map_column(0) <= support_moment_map_column(6);
      support_centre_moment_start_of_frame(0) <= support_moment_start_of_frame(6);
      support_centre_moment_last(0) <= support_moment_last(6);
      for i in 1 to 3 loop
        support_centre_moment_map_column(i) <= support_centre_moment_map_column(i - 1);
        support_centre_moment_start_of_frame(i) <= support_centre_moment_start_of_frame(i - 1);
        support_centre_moment_last(i) <= support_centre_moment_last(i - 1);
      end loop;
      support_centre_moved(0) <= support_moved;
      support_centre_moved(1) <= support_centre_moved(0);
      support_centre_moved(2) <= support_centre_moved(1);
      support_centre_moved(3) <= support_centre_moved(2);
      support_out_disparity_0 <= ((((other_3 * 2) + (other_2 / 8) + 127) mod 128) * 8) + (other_2 mod 8);
      support_out_passed_0 <= support_enough_0;
      support_out_tag_valid <= support_centre_moved(3);
      support_out_tag_map_column <= support_centre_moment_map_column(3);
      support_out_tag_start_of_frame <= support_centre_moment_start_of_frame(3);
      support_out_tag_end_of_line <= support_centre_moment_last(3);
      if turn_ready_tag_start_of_frame and turn_ready_tag_map_column and turn_ready_tag_valid then
        support_counter_group <= support_counter_group_choice;
      else
        support_counter_group <= support_counter_group_choices(3);
      end if;
      if support_row_tag(0) then
        support_row_tag(0) <= (not support_at_arrives) or support_moment_map_column(0) or (not support_at_moves);
      else
        support_row_tag(0) <= support_at_arrives and (not support_moment_map_column(0)) and support_at_moves;
      end if;
      if support_at_first then
        support_moment_start_of_frame(0) <= support_moment_0_start_of_frame_choice;
      else
        support_moment_start_of_frame(0) <= support_moment_start_of_frame(0) and (not support_at_moves);
      end if;
      if support_at_arrives and (not support_moment_map_column(0)) then
        support_next_tag <= support_next_tag_choice;
      else
        support_next_tag <= support_next_tag_choice_2;
      end if;
      if (not is_set(support_count_0, 4)) and ((not is_set(support_count_0, 3)) or (((support_count_0 / 2) mod 4) = 0))
        then
        support_enough_0 <= is_set(support_centre_0(2), 6) and is_set(support_count_0, 5);
      else
        support_enough_0 <= is_set(support_centre_0(2), 6);
      end if;
      if support_enough_0 then
        support_out_sure_0 <= support_out_sure_0_choice;
      else
        support_out_sure_0 <= 0;
      end if;
      if support_out_tag_row_start_choices(3) then
        support_out_tag_row_start <= support_out_tag_row_start or support_out_tag_row_start_all_2;
      else
        support_out_tag_row_start <= support_out_tag_row_start and ((not support_out_tag_map_column) or (not
          support_out_tag_valid));
      end if;
      if support_ready_arrives then
        support_rows_write_words_0 <= (support_rows_ready_words_0 / 128) + (support_rows_ready_newest_0 * 2097152);
        support_rest_rows_write_words_0 <= (support_rest_rows_ready_words_0 / 1024) + (support_rest_rows_ready_newest_0
          * 1024);
        support_write_column <= support_ready_column;
      end if;
      if support_at_moves then
        for i in 0 to 4 loop
          support_cells(0, i) <= support_column(i);
        end loop;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= support_cells(2 * i, j);
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 2, j) <= support_cells(2 * i + 1, j);
          end loop;
        end loop;
        support_row_tag(1) <= support_next_tag;
        for i in 2 to 12 loop
          support_row_tag(i) <= support_row_tag(i - 1);
        end loop;
        support_rest_0(0) <= support_column_rest_0;
        for i in 1 to 6 loop
          support_rest_0(i) <= support_rest_0(i - 1);
        end loop;
        support_moment_map_column(0) <= support_at_arrives;
        support_moment_last(0) <= support_at_last;
        for i in 1 to 6 loop
          support_moment_map_column(i) <= support_moment_map_column(i - 1);
          support_moment_start_of_frame(i) <= support_moment_start_of_frame(i - 1);
          support_moment_last(i) <= support_moment_last(i - 1);
        end loop;
      end if;
      -- fill
      if support_out_tag_row_start_all_2 then
        if support_out_tag_start_of_frame or support_out_tag_row_start_is_equal then
          fill_counter_column <= 0;
        else
          fill_counter_column <= (fill_counter_column + 1) mod 512;
        end if;
      end if;
      if support_out_tag_row_start_all then
        fill_counter_group_choice := 375;
      else
        fill_counter_group_choice := 0;
      end if;
      if (fill_counter_group = 375) and support_out_tag_row_start then
        fill_counter_group_choices(2) := 1;
      else
        fill_counter_group_choices(2) := (fill_counter_group + 1) mod 512;
      end if;
      if support_out_tag_row_start_differs and support_out_tag_row_start_is_equal and support_out_tag_map_column and
        support_out_tag_valid then
        fill_counter_group_choices(3) := fill_counter_group_choices(2);
      else
        fill_counter_group_choices(3) := fill_counter_group;
      end if;
      fill_ends_read_place_0_is_equal := fill_ready_column = 0;
      if other_0 then
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed);
      else
        fill_ends_read_place_0_choice := fill_at_arrives and (not fill_pixel_0_passed) and (not fill_in_hole_0);
      end if;
      if fill_ends_read_place_0 = 227 then
        fill_ends_read_place_0_choices(2) := 0;
      else
        fill_ends_read_place_0_choices(2) := (fill_ends_read_place_0 + 1) mod 256;
      end if;
      if fill_ends_read_place_0_choice then
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0_choices(2);
      else
        fill_ends_read_place_0_choices(3) := fill_ends_read_place_0;
      end if;
      if (fill_step_0 - fill_width_0) < 0 then
        fill_takes_left_0_choice := ((fill_width_0 - fill_step_0) mod 512) / 2;
      else
        fill_takes_left_0_choice := 0;
      end if;
      if fill_rises_0 then
        fill_takes_left_0_choice_2 := fill_takes_left_0_choice * 2;
      else
        fill_takes_left_0_choice_2 := fill_width_0;
      end if;
      fill_out_disparity_0_all := (not fill_chosen_0_passed) and ((not fill_chosen_at_top) or
        fill_chosen_beside_0_has_right or fill_chosen_beside_0_has_left);
      fill_out_disparity_0_all_2 := (not fill_chosen_beside_0_has_right) and (not fill_chosen_beside_0_has_left);
      if fill_takes_left_0 then
        fill_out_disparity_0_choice := fill_chosen_beside_0_left;
      else
        fill_out_disparity_0_choice := fill_chosen_beside_0_right;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_out_disparity_0_choice_2 := fill_above_0 mod 32768;
      else
        fill_out_disparity_0_choice_2 := fill_out_disparity_0_choice;
      end if;
      fill_out_filled_0_is_equal := fill_chosen_at_column = 0;
      if fill_out_filled_0_is_equal and fill_chosen_at_arrives then
        fill_out_filled_0_choice := fill_has_values and (not fill_chosen_at_top);
      else
        fill_out_filled_0_choice := fill_had_values;
      end if;
      fill_out_tag_row_start_differs := median_counter_group /= 376;
      fill_out_tag_row_start_is_equal := median_counter_column = 447;
      if fill_out_tag_row_start_is_equal then
        fill_out_tag_row_start_choice := (median_counter_group /= 375) and fill_out_tag_row_start;
      else
        fill_out_tag_row_start_choice := fill_out_tag_row_start;
      end if;
      if fill_out_tag_row_start_differs then
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start_choice;
      else
        fill_out_tag_row_start_choices(2) := fill_out_tag_row_start;
      end if;
      fill_out_tag_row_start_is_equal_2 := median_counter_group = 374;
      fill_out_tag_row_start_all := fill_out_tag_row_start_is_equal_2 and fill_out_tag_row_start_is_equal;
      if fill_out_tag_row_start_choices(2) then
        fill_out_tag_row_start_choices(3) := (not fill_out_tag_start_of_frame) or fill_out_tag_row_start_all;
      else
        fill_out_tag_row_start_choices(3) := fill_out_tag_start_of_frame and fill_out_tag_row_start_is_equal_2 and
          fill_out_tag_row_start_is_equal;
      end if;
      fill_out_tag_row_start_all_2 := fill_out_tag_map_column and fill_out_tag_valid;
      fill_newest_disparity_0 <= support_out_disparity_0;
      fill_newest_passed_0 <= support_out_passed_0;
      fill_newest_sure_0 <= support_out_sure_0;
      fill_moves <= support_out_tag_valid;
      fill_arrives <= support_out_tag_row_start_all_2;
      fill_last <= support_out_tag_end_of_line and support_out_tag_map_column and support_out_tag_valid;
      fill_rows_read_newest_0 <= (fill_newest_sure_0 * 2048) + (fill_newest_disparity_0 * 2) +
        as_number(fill_newest_passed_0);
      fill_rows_ready_words_0 <= to_integer(fill_rows_read_words_0);
      fill_rows_ready_newest_0 <= fill_rows_read_newest_0;
      fill_read_column <= fill_counter_column;
      fill_read_moves <= fill_moves;
      fill_read_arrives <= fill_arrives;
      fill_read_top <= fill_counter_group = 1;
      fill_read_last <= fill_last;
      fill_ready_column <= fill_read_column;
      fill_ready_moves <= fill_read_moves;
      fill_ready_arrives <= fill_read_arrives;
      fill_ready_top <= fill_read_top;
      fill_ready_last <= fill_read_last;
      fill_write_column <= fill_ready_column;
      fill_ends_write_words_0 <= (fill_counter_column * 1024) + fill_newest_disparity_0 +
        (as_number(fill_newest_passed_0) * 524288);
      fill_ends_write_place_0 <= fill_ends_next_place_0;
      fill_ends_ready_words_0 <= to_integer(fill_ends_read_words_0);
      fill_pixel_0_disparity <= (fill_rows_ready_words_0 mod 2048) / 2;
      fill_pixel_0_passed <= is_set(fill_rows_ready_words_0, 0);
      fill_pixel_0_sure <= fill_rows_ready_words_0 / 2048;
      fill_at_moves <= fill_ready_moves;
      fill_at_arrives <= fill_ready_arrives;
      fill_at_top <= fill_ready_top;
      fill_at_last <= fill_ready_last;
      fill_asking_0_disparity(0) <= fill_pixel_0_disparity;
      fill_asking_0_passed(0) <= fill_pixel_0_passed;
      fill_asking_0_sure(0) <= fill_pixel_0_sure;
      fill_asking_0_disparity(1) <= fill_asking_0_disparity(0);
      fill_asking_0_passed(1) <= fill_asking_0_passed(0);
      fill_asking_0_sure(1) <= fill_asking_0_sure(0);
      fill_asking_at_column(0) <= fill_write_column;
      fill_asking_at_moves(0) <= fill_at_moves;
      fill_asking_at_arrives(0) <= fill_at_arrives;
      fill_asking_at_top(0) <= fill_at_top;
      fill_asking_at_last(0) <= fill_at_last;
      fill_asking_at_column(1) <= fill_asking_at_column(0);
      fill_asking_at_moves(1) <= fill_asking_at_moves(0);
      fill_asking_at_arrives(1) <= fill_asking_at_arrives(0);
      fill_asking_at_top(1) <= fill_asking_at_top(0);
      fill_asking_at_last(1) <= fill_asking_at_last(0);
      fill_hole_starts_0(0) <= fill_ends_read_place_0_choice;
      fill_hole_starts_0(1) <= fill_hole_starts_0(0);
      fill_known_0_disparity <= fill_asking_0_disparity(1);
      fill_known_0_passed <= fill_asking_0_passed(1);
      fill_known_0_sure <= fill_asking_0_sure(1);
      fill_known_at_column <= fill_asking_at_column(1);
      fill_known_at_moves <= fill_asking_at_moves(1);
      fill_known_at_arrives <= fill_asking_at_arrives(1);
      fill_known_at_top <= fill_asking_at_top(1);
      fill_known_at_last <= fill_asking_at_last(1);
      fill_measured_0_disparity <= fill_known_0_disparity;
      fill_measured_0_passed <= fill_known_0_passed;
      fill_measured_0_sure <= fill_known_0_sure;
      fill_measured_at_column <= fill_known_at_column;
      fill_measured_at_moves <= fill_known_at_moves;
      fill_measured_at_arrives <= fill_known_at_arrives;
      fill_measured_at_top <= fill_known_at_top;
      fill_measured_at_last <= fill_known_at_last;
      fill_measured_beside_0_left <= fill_beside_0_left;
      fill_measured_beside_0_right <= fill_beside_0_right;
      fill_measured_beside_0_has_left <= fill_beside_0_has_left;
      fill_measured_beside_0_has_right <= fill_beside_0_has_right;
      fill_measured_beside_0_right_column <= fill_beside_0_right_column;
      fill_width_0 <= (fill_beside_0_right_column + (65535 - fill_beside_0_left_column)) mod 512;
      fill_step_0 <= ((fill_beside_0_right - fill_beside_0_left) mod 2048) / 16;
      fill_rises_0 <= (fill_beside_0_right - fill_beside_0_left) >= 0;
      fill_chosen_0_disparity <= fill_measured_0_disparity;
      fill_chosen_0_passed <= fill_measured_0_passed;
      fill_chosen_0_sure <= fill_measured_0_sure;
      fill_chosen_at_column <= fill_measured_at_column;
      fill_chosen_at_moves <= fill_measured_at_moves;
      fill_chosen_at_arrives <= fill_measured_at_arrives;
      fill_chosen_at_top <= fill_measured_at_top;
      fill_chosen_at_last <= fill_measured_at_last;
      fill_chosen_beside_0_left <= fill_measured_beside_0_left;
      fill_chosen_beside_0_right <= fill_measured_beside_0_right;
      fill_chosen_beside_0_has_left <= fill_measured_beside_0_has_left;
      fill_chosen_beside_0_has_right <= fill_measured_beside_0_has_right;
      fill_takes_left_0 <= fill_measured_beside_0_has_left and ((((fill_measured_at_column +
        (fill_takes_left_0_choice_2 / 2)) - fill_measured_beside_0_right_column) < 0) or (not
        fill_measured_beside_0_has_right));
      fill_above_0 <= to_integer(fill_above_read_0);
      fill_out_passed_0 <= fill_chosen_0_passed;
      fill_out_sure_0 <= fill_chosen_0_sure;
      fill_out_tag_valid <= fill_chosen_at_moves;
      fill_out_tag_map_column <= fill_chosen_at_arrives;
      fill_out_tag_start_of_frame <= fill_out_filled_0_is_equal and fill_chosen_at_arrives and fill_chosen_at_top;
      fill_out_tag_end_of_line <= fill_chosen_at_last;
      if support_out_tag_start_of_frame and support_out_tag_map_column and support_out_tag_valid then
        fill_counter_group <= fill_counter_group_choice;
      else
        fill_counter_group <= fill_counter_group_choices(3);
      end if;
      if fill_newest_passed_0 then
        fill_ends_open_0 <= fill_ends_open_0 and (not fill_arrives);
      else
        fill_ends_open_0 <= fill_ends_open_0 or fill_arrives;
      end if;
      if fill_ends_read_place_0_is_equal and fill_ready_arrives then
        fill_ends_read_place_0 <= fill_ends_row_above_place_0;
      else
        fill_ends_read_place_0 <= fill_ends_read_place_0_choices(3);
      end if;
      if fill_beside_0_has_left then
        fill_beside_0_has_left <= (fill_asking_at_column(1) /= 0) or fill_asking_0_passed(1) or (not
          fill_asking_at_arrives(1));
      else
        fill_beside_0_has_left <= fill_asking_0_passed(1) and fill_asking_at_arrives(1);
      end if;
      if fill_out_disparity_0_all then
        fill_out_disparity_0 <= fill_out_disparity_0_choice_2;
      else
        fill_out_disparity_0 <= fill_chosen_0_disparity;
      end if;
      if fill_out_filled_0_choice then
        fill_out_filled_0 <= not fill_chosen_0_passed;
      else
        fill_out_filled_0 <= (not fill_chosen_0_passed) and (fill_chosen_beside_0_has_right or
          fill_chosen_beside_0_has_left);
      end if;
      if fill_out_tag_row_start_choices(3) then
        fill_out_tag_row_start <= fill_out_tag_row_start or fill_out_tag_row_start_all_2;
      else
        fill_out_tag_row_start <= fill_out_tag_row_start and ((not fill_out_tag_map_column) or (not
          fill_out_tag_valid));
      end if;
      if (not fill_out_filled_0_choice) and (not fill_chosen_0_passed) and (not fill_chosen_beside_0_has_right) and
        (not fill_chosen_beside_0_has_left) then
        fill_has_values <= fill_has_values and (not fill_chosen_at_arrives);
      else
        fill_has_values <= fill_has_values or fill_chosen_at_arrives;
      end if;
      if fill_ready_arrives then
        fill_rows_write_words_0 <= fill_rows_ready_newest_0;
        fill_at_column <= fill_ready_column;
      end if;
      if fill_last then
        fill_ends_next_place_0_choice := fill_arrives;
      else
        fill_ends_next_place_0_choice := fill_newest_passed_0 and fill_arrives;
      end if;
      if fill_ends_open_0 and ((not fill_arrives) or (fill_counter_column /= 0)) then
        fill_ends_next_place_0_choice_2 := fill_ends_next_place_0_choice;
      else
        fill_ends_next_place_0_choice_2 := fill_last and (not fill_newest_passed_0) and fill_arrives;
      end if;
      if fill_ends_next_place_0_choice_2 then
        if fill_ends_next_place_0 = 227 then
          fill_ends_next_place_0 <= 0;
        else
          fill_ends_next_place_0 <= (fill_ends_next_place_0 + 1) mod 256;
        end if;
      end if;
      fill_ends_row_place_0_all := fill_arrives and (fill_counter_column = 0);
      if fill_ends_row_place_0_all then
        fill_ends_row_place_0 <= fill_ends_next_place_0;
        fill_ends_row_above_place_0 <= fill_ends_row_place_0;
      end if;
      if fill_at_arrives then
        fill_in_hole_0 <= not fill_pixel_0_passed;
      end if;
      fill_beside_0_left_any := (not fill_asking_0_passed(1)) or (not fill_asking_at_arrives(1));
      if not fill_beside_0_left_any then
        fill_beside_0_left <= fill_asking_0_disparity(1);
        fill_beside_0_left_column <= fill_asking_at_column(1);
      end if;
      if fill_hole_starts_0(1) then
        fill_beside_0_right <= fill_ends_ready_words_0 mod 1024;
        fill_beside_0_has_right <= is_set(fill_ends_ready_words_0, 19);
        fill_beside_0_right_column <= (fill_ends_ready_words_0 / 1024) mod 512;
      end if;
      if fill_out_disparity_0_all_2 then
        fill_write_above_0_choice := fill_above_0;
      else
        fill_write_above_0_choice := fill_out_disparity_0_choice;
      end if;
      if fill_chosen_at_arrives then
        fill_had_values <= fill_out_filled_0_choice;
        fill_write_above_column <= fill_chosen_at_column;
        if fill_out_disparity_0_all then
          fill_write_above_0 <= fill_write_above_0_choice;
        else
          fill_write_above_0 <= fill_chosen_0_disparity;
        end if;
      end if;
      -- median
      if fill_out_tag_row_start_all_2 then
        if fill_out_tag_start_of_frame or fill_out_tag_row_start_is_equal then
          median_counter_column <= 0;
        else
          median_counter_column <= (median_counter_column + 1) mod 512;
        end if;
      end if;
      if fill_out_tag_row_start_all then
        median_counter_group_choice := 375;
      else
        median_counter_group_choice := 0;
      end if;
      median_counter_group_is_equal := median_counter_group = 375;
      if median_counter_group_is_equal and fill_out_tag_row_start then
        median_counter_group_choices(2) := 1;
      else
        median_counter_group_choices(2) := (median_counter_group + 1) mod 512;
      end if;
      if fill_out_tag_row_start_differs and fill_out_tag_row_start_is_equal and fill_out_tag_map_column and
        fill_out_tag_valid then
        median_counter_group_choices(3) := median_counter_group_choices(2);
      else
        median_counter_group_choices(3) := median_counter_group;
      end if;
      if fill_out_tag_valid then
        median_line_ended_choice := fill_out_tag_map_column;
      else
        median_line_ended_choice := median_line_ended;
      end if;
      if median_at_top then
        median_of_column_0_a_choice := median_column_1 / 2;
      else
        median_of_column_0_a_choice := other_1 / 2;
      end if;
      if median_counter_next_frame then
        median_of_column_0_c_choice := median_column_1 / 2;
      else
        median_of_column_0_c_choice := median_column_2 / 2;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_low_0_choice := median_of_column_0_c;
      else
        median_sorted_low_0_choice := median_of_column_0_b;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_low_0_choice_2 := median_of_column_0_c;
      else
        median_sorted_low_0_choice_2 := median_of_column_0_a;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_middle_0_choice := median_of_column_0_b;
      else
        median_sorted_middle_0_choice := median_sorted_low_0_choice_2;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_middle_0_choice_2 := median_of_column_0_a;
      else
        median_sorted_middle_0_choice_2 := median_sorted_low_0_choice;
      end if;
      if median_of_column_0_c_below_a then
        median_sorted_high_0_choice := median_of_column_0_a;
      else
        median_sorted_high_0_choice := median_of_column_0_c;
      end if;
      if median_of_column_0_c_below_b then
        median_sorted_high_0_choice_2 := median_of_column_0_b;
      else
        median_sorted_high_0_choice_2 := median_of_column_0_c;
      end if;
      median_window_complete_is_equal := median_sorted_column = 0;
      if median_window_complete_is_equal then
        median_window_complete_choice := median_sorted_behind;
      else
        median_window_complete_choice := median_sorted_arrives or median_sorted_behind;
      end if;
      if median_of_low_0_c_below_a then
        median_largest_low_0_choice := median_of_low_0_a;
      else
        median_largest_low_0_choice := median_of_low_0_c;
      end if;
      if median_of_low_0_c_below_b then
        median_largest_low_0_choice_2 := median_of_low_0_b;
      else
        median_largest_low_0_choice_2 := median_of_low_0_c;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choice := median_of_middle_0_c;
      else
        median_median_middle_0_choice := median_of_middle_0_a;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(2) := median_of_middle_0_b;
      else
        median_median_middle_0_choices(2) := median_median_middle_0_choice;
      end if;
      if median_of_middle_0_c_below_b then
        median_median_middle_0_choices(3) := median_of_middle_0_c;
      else
        median_median_middle_0_choices(3) := median_of_middle_0_b;
      end if;
      if median_of_middle_0_c_below_a then
        median_median_middle_0_choices(4) := median_of_middle_0_a;
      else
        median_median_middle_0_choices(4) := median_median_middle_0_choices(3);
      end if;
      if median_of_high_0_c_below_b then
        median_smallest_high_0_choice := median_of_high_0_c;
      else
        median_smallest_high_0_choice := median_of_high_0_b;
      end if;
      if median_of_high_0_c_below_a then
        median_smallest_high_0_choice_2 := median_of_high_0_c;
      else
        median_smallest_high_0_choice_2 := median_of_high_0_a;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choice := median_of_all_0_c;
      else
        median_out_disparity_0_choice := median_of_all_0_a;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(2) := median_of_all_0_b;
      else
        median_out_disparity_0_choices(2) := median_out_disparity_0_choice;
      end if;
      if median_of_all_0_c_below_b then
        median_out_disparity_0_choices(3) := median_of_all_0_c;
      else
        median_out_disparity_0_choices(3) := median_of_all_0_b;
      end if;
      if median_of_all_0_c_below_a then
        median_out_disparity_0_choices(4) := median_of_all_0_a;
      else
        median_out_disparity_0_choices(4) := median_out_disparity_0_choices(3);
      end if;
      median_counter_next_frame <= winners_best_place_0;
      median_newest_0 <= (fill_out_disparity_0 * 2) + as_number(fill_out_passed_0);
      median_arrives <= fill_out_tag_row_start_all_2;
      median_behind <= median_line_ended and fill_out_tag_valid;
      median_rows_read_newest_0 <= median_newest_0;
      median_rows_ready_words_0 <= to_integer(median_rows_read_words_0);
      median_rows_ready_newest_0 <= median_rows_read_newest_0;
      median_read_column <= median_counter_column;
      median_read_arrives <= median_arrives;
      median_read_behind <= median_behind;
      median_read_top <= median_counter_group = 1;
      median_read_bottom <= median_counter_group_is_equal;
      median_read_output <= (median_counter_group >= 1) and (median_counter_group < 376);
      median_ready_column <= median_read_column;
      median_ready_arrives <= median_read_arrives;
      median_ready_behind <= median_read_behind;
      median_ready_top <= median_read_top;
      median_ready_output <= median_read_output;
      median_write_column <= median_ready_column;
      median_column_1 <= median_rows_ready_words_0 / 8192;
      median_column_2 <= median_rows_ready_newest_0;
      median_at_arrives <= median_ready_arrives;
      median_at_behind <= median_ready_behind;
      median_at_top <= median_ready_top;
      median_at_output <= median_ready_output;
      median_of_column_0_a <= median_of_column_0_a_choice;
      median_of_column_0_b <= median_column_1 / 2;
      median_of_column_0_c <= median_of_column_0_c_choice;
      median_of_column_0_b_below_a <= ((median_column_1 / 2) - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_a <= (median_of_column_0_c_choice - median_of_column_0_a_choice) < 0;
      median_of_column_0_c_below_b <= (median_of_column_0_c_choice - (median_column_1 / 2)) < 0;
      median_column_passed_0(0) <= is_set(median_column_1, 0);
      median_column_passed_0(1) <= median_column_passed_0(0);
      median_comparing_column <= median_write_column;
      median_comparing_arrives <= median_at_arrives;
      median_comparing_behind <= median_at_behind;
      median_comparing_top <= median_at_top;
      median_comparing_output <= median_at_output;
      median_sorted_column <= median_comparing_column;
      median_sorted_arrives <= median_comparing_arrives;
      median_sorted_behind <= median_comparing_behind;
      median_sorted_top <= median_comparing_top;
      median_sorted_output <= median_comparing_output;
      median_window_complete <= median_sorted_output and median_window_complete_choice;
      median_window_first <= median_sorted_top and (median_sorted_column = 1) and median_sorted_arrives;
      median_window_last <= median_sorted_behind;
      median_of_low_0_a <= median_low_0(0);
      median_of_low_0_b <= median_low_0(1);
      median_of_low_0_c <= median_low_0(2);
      median_of_low_0_b_below_a <= (median_low_0(1) - median_low_0(0)) < 0;
      median_of_low_0_c_below_a <= (median_low_0(2) - median_low_0(0)) < 0;
      median_of_low_0_c_below_b <= (median_low_0(2) - median_low_0(1)) < 0;
      median_of_middle_0_a <= median_middle_0(0);
      median_of_middle_0_b <= median_middle_0(1);
      median_of_middle_0_c <= median_middle_0(2);
      median_of_middle_0_b_below_a <= (median_middle_0(1) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_a <= (median_middle_0(2) - median_middle_0(0)) < 0;
      median_of_middle_0_c_below_b <= (median_middle_0(2) - median_middle_0(1)) < 0;
      median_of_high_0_a <= median_high_0(0);
      median_of_high_0_b <= median_high_0(1);
      median_of_high_0_c <= median_high_0(2);
      median_of_high_0_b_below_a <= (median_high_0(1) - median_high_0(0)) < 0;
      median_of_high_0_c_below_a <= (median_high_0(2) - median_high_0(0)) < 0;
      median_of_high_0_c_below_b <= (median_high_0(2) - median_high_0(1)) < 0;
      median_of_all_0_a <= median_largest_low_0;
      median_of_all_0_b <= median_median_middle_0;
      median_of_all_0_c <= median_smallest_high_0;
      median_of_all_0_b_below_a <= (median_median_middle_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_a <= (median_smallest_high_0 - median_largest_low_0) < 0;
      median_of_all_0_c_below_b <= (median_smallest_high_0 - median_median_middle_0) < 0;
      median_waiting_complete(0) <= median_window_complete;
      median_waiting_first(0) <= median_window_first;
      median_waiting_last(0) <= median_window_last;
      median_waiting_complete(1) <= median_waiting_complete(0);
      median_waiting_first(1) <= median_waiting_first(0);
      median_waiting_last(1) <= median_waiting_last(0);
      median_waiting_complete(2) <= median_waiting_complete(1);
      median_waiting_first(2) <= median_waiting_first(1);
      median_waiting_last(2) <= median_waiting_last(1);
      median_waiting_passed_0(0) <= median_passed_0(1);
      median_waiting_passed_0(1) <= median_waiting_passed_0(0);
      median_waiting_passed_0(2) <= median_waiting_passed_0(1);
      median_beside_newest_0 <= (fill_out_sure_0 * 2) + as_number(fill_out_filled_0);
      median_beside_rows_read_newest_0 <= median_beside_newest_0;
      median_beside_rows_ready_words_0 <= to_integer(median_beside_rows_read_words_0);
      median_beside_rows_ready_newest_0 <= median_beside_rows_read_newest_0;
      median_beside_column_0 <= median_beside_rows_ready_words_0;
      median_beside_of_column_0(0) <= median_beside_column_0;
      median_beside_of_column_0(1) <= median_beside_of_column_0(0);
      median_beside_waiting_0(0) <= median_beside_in_window_0(1);
      median_beside_waiting_0(1) <= median_beside_waiting_0(0);
      median_beside_waiting_0(2) <= median_beside_waiting_0(1);
      median_out_passed_0 <= median_waiting_passed_0(2);
      median_out_confidence_0 <= median_beside_waiting_0(2) / 2;
      median_out_filled_0 <= is_set(median_beside_waiting_0(2), 0);
      median_out_valid <= median_waiting_complete(2);
      median_out_start_of_frame <= median_waiting_first(2) and median_waiting_complete(2);
      median_out_end_of_line <= median_waiting_last(2) and median_waiting_complete(2);
      if fill_out_tag_start_of_frame and fill_out_tag_map_column and fill_out_tag_valid then
        median_counter_group <= median_counter_group_choice;
      else
        median_counter_group <= median_counter_group_choices(3);
      end if;
      if fill_out_tag_end_of_line then
        median_line_ended <= median_line_ended_choice;
      else
        median_line_ended <= median_line_ended and (not fill_out_tag_valid);
      end if;
      if median_of_column_0_b_below_a then
        median_sorted_low_0 <= median_sorted_low_0_choice;
        median_sorted_middle_0 <= median_sorted_middle_0_choice;
        median_sorted_high_0 <= median_sorted_high_0_choice;
      else
        median_sorted_low_0 <= median_sorted_low_0_choice_2;
        median_sorted_middle_0 <= median_sorted_middle_0_choice_2;
        median_sorted_high_0 <= median_sorted_high_0_choice_2;
      end if;
      if median_passed_0(0) then
        median_passed_0(1) <= median_passed_0(1) or median_sorted_arrives or median_sorted_behind;
      else
        median_passed_0(1) <= median_passed_0(1) and (not median_sorted_arrives) and (not median_sorted_behind);
      end if;
      if median_of_low_0_b_below_a then
        median_largest_low_0 <= median_largest_low_0_choice;
      else
        median_largest_low_0 <= median_largest_low_0_choice_2;
      end if;
      if median_of_middle_0_b_below_a then
        median_median_middle_0 <= median_median_middle_0_choices(2);
      else
        median_median_middle_0 <= median_median_middle_0_choices(4);
      end if;
      if median_of_high_0_b_below_a then
        median_smallest_high_0 <= median_smallest_high_0_choice;
      else
        median_smallest_high_0 <= median_smallest_high_0_choice_2;
      end if;
      if median_of_all_0_b_below_a then
        median_out_disparity_0 <= median_out_disparity_0_choices(2);
      else
        median_out_disparity_0 <= median_out_disparity_0_choices(4);
      end if;
      if median_ready_arrives then
        median_rows_write_words_0 <= (median_rows_ready_words_0 / 8192) + (median_rows_ready_newest_0 * 8192);
        median_at_column <= median_ready_column;
        median_beside_rows_write_words_0 <= median_beside_rows_ready_newest_0;
      end if;
      if median_sorted_behind then
        median_low_0_0_choice := median_low_0(0);
      else
        median_low_0_0_choice := median_sorted_low_0;
      end if;
      median_low_0_all(1) := median_window_complete_is_equal and median_sorted_arrives;
      if median_sorted_behind then
        median_middle_0_0_choice := median_middle_0(0);
      else
        median_middle_0_0_choice := median_sorted_middle_0;
      end if;
      if median_sorted_behind then
        median_high_0_0_choice := median_high_0(0);
      else
        median_high_0_0_choice := median_sorted_high_0;
      end if;
      median_low_0_all(0) := (not median_sorted_arrives) and (not median_sorted_behind);
      if not median_low_0_all(0) then
        median_low_0(0) <= median_low_0_0_choice;
        median_low_0(2) <= median_low_0(1);
        median_middle_0(0) <= median_middle_0_0_choice;
        median_middle_0(2) <= median_middle_0(1);
        median_high_0(0) <= median_high_0_0_choice;
        median_high_0(2) <= median_high_0(1);
        median_beside_in_window_0(1) <= median_beside_in_window_0(0);
        if median_low_0_all(1) then
          median_low_0(1) <= median_low_0_0_choice;
          median_middle_0(1) <= median_middle_0_0_choice;
          median_high_0(1) <= median_high_0_0_choice;
        else
          median_low_0(1) <= median_low_0(0);
          median_middle_0(1) <= median_middle_0(0);
          median_high_0(1) <= median_high_0(0);
        end if;
      end if;
      if median_sorted_arrives then
        median_passed_0(0) <= median_column_passed_0(1);
        median_beside_in_window_0(0) <= median_beside_of_column_0(1);
      end if;
      -- relief
      if transform_columns_valid then
        relief_centre_column(0) <= transform_left_column_2;
        relief_centre_column(1) <= relief_centre_column(0);
        relief_centre_column(2) <= relief_centre_column(1);
        relief_centre_column(3) <= relief_centre_column(2);
        relief_centre_column(4) <= relief_centre_column(3);
      end if;
      if is_set(relief_centre_grey_0, 0) then
        relief_newest_choice := (not is_set(relief_before, 1)) or (not is_set(relief_before, 0));
      else
        relief_newest_choice := not is_set(relief_before, 1);
      end if;
      if is_set(relief_centre_grey_0, 1) then
        relief_newest_choices(2) := relief_newest_choice;
      else
        relief_newest_choices(2) := is_set(relief_centre_grey_0, 0) and ((relief_before mod 4) = 0);
      end if;
      relief_newest_value := is_set(relief_before, 2);
      if relief_newest_choices(2) then
        relief_newest_choices(3) := (not is_set(relief_centre_grey_0, 2)) and relief_newest_value;
      else
        relief_newest_choices(3) := (not is_set(relief_centre_grey_0, 2)) or relief_newest_value;
      end if;
      for i in 2 to 5 loop
        relief_newest_values(i) := is_set(relief_before, i + 1);
        if relief_newest_choices(i + 1) then
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey_0, i + 1)) or relief_newest_values(i);
        else
          relief_newest_choices(i + 2) := (not is_set(relief_centre_grey_0, i + 1)) and relief_newest_values(i);
        end if;
      end loop;
      if relief_newest_choices(7) then
        relief_newest_choices(8) := (not is_set(relief_centre_grey_0, 7)) or is_set(relief_before, 7);
      else
        relief_newest_choices(8) := (not is_set(relief_centre_grey_0, 7)) and is_set(relief_before, 7);
      end if;
      relief_newest_values_from_6(6) := (relief_before - relief_centre_grey_0) mod 256;
      relief_newest_values_from_6(7) := (relief_centre_grey_0 - relief_before) mod 256;
      if relief_newest_choices(8) then
        relief_newest_choices(9) := is_set(relief_newest_values_from_6(6), 2);
      else
        relief_newest_choices(9) := is_set(relief_newest_values_from_6(7), 2);
      end if;
      if relief_newest_choices(8) then
        relief_newest_choices(10) := not is_set(relief_newest_values_from_6(6), 3);
      else
        relief_newest_choices(10) := not is_set(relief_newest_values_from_6(7), 3);
      end if;
      for i in 11 to 12 loop
        if relief_newest_choices(8) then
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(6), 16 - i);
        else
          relief_newest_choices(i) := is_set(relief_newest_values_from_6(7), 16 - i);
        end if;
      end loop;
      if relief_newest_choices(8) then
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(6), 7);
      else
        relief_newest_choices(13) := not is_set(relief_newest_values_from_6(7), 7);
      end if;
      if relief_newest_choices(8) then
        relief_newest_choices(14) := is_set(relief_newest_values_from_6(6), 6);
      else
        relief_newest_choices(14) := is_set(relief_newest_values_from_6(7), 6);
      end if;
      if relief_newest_choices(7) then
        relief_newest_choices(15) := is_set(relief_centre_grey_0, 7) and (not is_set(relief_before, 7));
      else
        relief_newest_choices(15) := is_set(relief_centre_grey_0, 7) or (not is_set(relief_before, 7));
      end if;
      if relief_newest_choices(15) then
        relief_newest_choice_16 := (relief_newest_values_from_6(7) / 2) mod 32;
      else
        relief_newest_choice_16 := (relief_newest_values_from_6(6) / 2) mod 32;
      end if;
      relief_centre_grey_0 <= relief_centre_column(4);
      relief_delayed_0 <= relief_newest;
      relief_rows_read_newest_0 <= relief_delayed_0;
      relief_rows_ready_words_0 <= to_integer(relief_rows_read_words_0);
      relief_rows_ready_newest_0 <= relief_rows_read_newest_0;
      relief_shown_0 <= relief_rows_ready_words_0;
      relief_waiting(0) <= relief_column_0;
      for i in 1 to 9 loop
        relief_waiting(i) <= relief_waiting(i - 1);
      end loop;
      relief_entered <= relief_entering;
      if (not ((not ((not ((not relief_newest_choices(9)) and relief_newest_choices(10))) and relief_newest_choices(11)
        and relief_newest_choices(12))) and relief_newest_choices(13))) or relief_newest_choices(14) then
        relief_newest <= 25;
      else
        relief_newest <= relief_newest_choice_16;
      end if;
      if relief_waiting(9) < 25 then
        relief_entering <= relief_waiting(9);
      else
        relief_entering <= 25;
      end if;
      if transform_filtering_valid(1) then
        relief_before <= relief_centre_grey_0;
      end if;
      if rows_ready_tag_valid then
        relief_rows_write_words_0 <= relief_rows_ready_newest_0;
      end if;
      if rows_tag_valid then
        relief_column_0 <= relief_shown_0;
      end if;
      -- other
      other_0 <= fill_ends_read_place_0_is_equal;
      other_1 <= ((median_rows_ready_words_0 mod 8192) / 2) * 2;
      other_2 <= support_centre_rest_0(2) mod 16;
      other_3 <= support_centre_0(2) mod 64;
      other_4 <= ((refinement_remainder_0_difference(7) / 512) * 2) + ((other_5 / 4) * 4);
      other_5 <= ((refinement_remainder_0_difference(6) / 512) * 4) + ((other_6 / 8) * 8);
      other_6 <= ((refinement_remainder_0_difference(5) / 512) * 8) + ((other_7 / 16) * 16);
      other_7 <= ((refinement_remainder_0_difference(4) / 512) * 16) + ((other_8 / 32) * 32);
      other_8 <= ((refinement_remainder_0_difference(3) / 512) * 32) + ((other_9 / 64) * 64);
      other_9 <= ((refinement_remainder_0_difference(2) / 512) * 64) + ((other_10 / 128) * 128);
      other_10 <= (refinement_remainder_1_0_difference / 512) * 128;
      if reset = '1' then
        transform_left_0 <= 0;
        transform_right_0 <= 0;
        transform_valid <= false;
        transform_counter_column <= 0;
        transform_counter_group <= 377;
        transform_counter_next_frame <= false;
        transform_left_rows_read_newest_0 <= 0;
        transform_left_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_left_rows_ready_newest_0 <= 0;
        transform_left_rows_write_words_0 <= to_unsigned(0, 32);
        transform_right_rows_read_newest_0 <= 0;
        transform_right_rows_ready_words_0 <= to_unsigned(0, 32);
        transform_right_rows_ready_newest_0 <= 0;
        transform_right_rows_write_words_0 <= to_unsigned(0, 32);
        transform_read_column <= 0;
        transform_read_row_inside_0 <= false;
        transform_read_row_inside_2 <= false;
        transform_read_row_inside_4 <= false;
        transform_read_column_inside_0 <= false;
        transform_read_column_inside_2 <= false;
        transform_read_column_inside_4 <= false;
        transform_read_column_inside_6 <= false;
        transform_read_column_inside_8 <= false;
        transform_read_start_of_frame <= false;
        transform_read_valid <= false;
        transform_ready_column <= 0;
        transform_ready_row_inside_0 <= false;
        transform_ready_row_inside_2 <= false;
        transform_ready_row_inside_4 <= false;
        transform_ready_column_inside_0 <= false;
        transform_ready_column_inside_2 <= false;
        transform_ready_column_inside_4 <= false;
        transform_ready_column_inside_6 <= false;
        transform_ready_column_inside_8 <= false;
        transform_ready_start_of_frame <= false;
        transform_ready_valid <= false;
        transform_write_column <= 0;
        transform_left_column_0 <= 0;
        transform_left_column_2 <= 0;
        transform_left_column_4 <= 0;
        transform_right_column_0 <= 0;
        transform_right_column_2 <= 0;
        transform_right_column_4 <= 0;
        transform_columns_row_inside_0 <= false;
        transform_columns_row_inside_2 <= false;
        transform_columns_row_inside_4 <= false;
        transform_columns_column_inside_0 <= false;
        transform_columns_column_inside_2 <= false;
        transform_columns_column_inside_4 <= false;
        transform_columns_column_inside_6 <= false;
        transform_columns_column_inside_8 <= false;
        transform_columns_start_of_frame <= false;
        transform_columns_valid <= false;
        for i in 0 to 8 loop
          transform_left_filter_column_0(i) <= 0;
          transform_left_filter_column_2(i) <= 0;
          transform_left_filter_column_4(i) <= 0;
        end loop;
        transform_left_filter_feature_0 <= 0;
        for i in 0 to 8 loop
          transform_right_filter_column_0(i) <= 0;
          transform_right_filter_column_2(i) <= 0;
          transform_right_filter_column_4(i) <= 0;
        end loop;
        transform_right_filter_feature_0 <= 0;
        transform_filtering_0_column_inside_0 <= false;
        transform_filtering_0_column_inside_2 <= false;
        transform_filtering_0_column_inside_4 <= false;
        transform_filtering_0_column_inside_6 <= false;
        transform_filtering_0_column_inside_8 <= false;
        transform_filtering_start_of_frame(0) <= false;
        transform_filtering_valid(0) <= false;
        transform_filtering_start_of_frame(1) <= false;
        transform_filtering_valid(1) <= false;
        raster_features_search_0 <= 0;
        raster_features_reference_0 <= 0;
        raster_features_valid <= false;
        raster_place_column <= 0;
        raster_place_group <= 376;
        raster_place_next_frame <= false;
        delay_ahead_0 <= 0;
        delay_delayed_0 <= 0;
        delay_column <= 0;
        delay_row_inside(0) <= false;
        delay_row_inside(1) <= false;
        delay_row_inside(2) <= false;
        delay_tag_valid <= false;
        delay_tag_map_column <= false;
        delay_tag_output_column <= false;
        delay_tag_first_column <= false;
        delay_tag_start_of_frame <= false;
        delay_tag_end_of_line <= false;
        rows_search_rows_read_newest_0 <= 0;
        rows_search_rows_ready_words_0 <= 0;
        rows_search_rows_ready_newest_0 <= 0;
        rows_search_rows_write_words_0 <= 0;
        rows_reference_rows_read_newest_0 <= 0;
        rows_reference_rows_ready_words_0 <= 0;
        rows_reference_rows_ready_newest_0 <= 0;
        rows_reference_rows_write_words_0 <= 0;
        rows_read_column <= 0;
        rows_read_inside(0) <= false;
        rows_read_inside(1) <= false;
        rows_read_inside(2) <= false;
        rows_read_tag_valid <= false;
        rows_read_tag_map_column <= false;
        rows_read_tag_output_column <= false;
        rows_read_tag_first_column <= false;
        rows_read_tag_start_of_frame <= false;
        rows_read_tag_end_of_line <= false;
        rows_ready_column <= 0;
        rows_ready_inside(0) <= false;
        rows_ready_inside(1) <= false;
        rows_ready_inside(2) <= false;
        rows_ready_tag_valid <= false;
        rows_ready_tag_map_column <= false;
        rows_ready_tag_output_column <= false;
        rows_ready_tag_first_column <= false;
        rows_ready_tag_start_of_frame <= false;
        rows_ready_tag_end_of_line <= false;
        rows_write_column <= 0;
        rows_search(0) <= 0;
        rows_search(1) <= 0;
        rows_search(2) <= 0;
        rows_reference(0) <= 0;
        rows_reference(1) <= 0;
        rows_reference(2) <= 0;
        rows_tag_valid <= false;
        rows_tag_map_column <= false;
        rows_tag_output_column <= false;
        rows_tag_first_column <= false;
        rows_tag_start_of_frame <= false;
        rows_tag_end_of_line <= false;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice0shift_search(i, j) <= 0;
          end loop;
        end loop;
        slice0shift_reference(0) <= 0;
        slice0shift_reference(1) <= 0;
        slice0shift_reference(2) <= 0;
        slice0shift_search_out(0) <= 0;
        slice0shift_search_out(1) <= 0;
        slice0shift_search_out(2) <= 0;
        slice0shift_tag_valid <= false;
        slice0shift_tag_map_column <= false;
        slice0shift_tag_output_column <= false;
        slice0shift_tag_first_column <= false;
        slice0shift_tag_start_of_frame <= false;
        slice0shift_tag_end_of_line <= false;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice0cost_pixels_first_count(i, j, 0) <= 0;
            slice0cost_pixels_first_count(i, j, 1) <= 0;
            slice0cost_pixels_first_count(i, j, 2) <= 0;
            slice0cost_pixels_first_count(i, j, 3) <= 0;
            slice0cost_pixels_first_count_4(i, j) <= 0;
          end loop;
        end loop;
        slice0cost_pixels_first_tag_valid <= false;
        slice0cost_pixels_first_tag_map_column <= false;
        slice0cost_pixels_first_tag_output_column <= false;
        slice0cost_pixels_first_tag_first_column <= false;
        slice0cost_pixels_first_tag_start_of_frame <= false;
        slice0cost_pixels_first_tag_end_of_line <= false;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice0cost_pixels_cost(i, j) <= 0;
          end loop;
        end loop;
        slice0cost_pixels_tag_valid <= false;
        slice0cost_pixels_tag_map_column <= false;
        slice0cost_pixels_tag_output_column <= false;
        slice0cost_pixels_tag_first_column <= false;
        slice0cost_pixels_tag_start_of_frame <= false;
        slice0cost_pixels_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0cost_pair_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice0cost_single_0(i) <= 0;
        end loop;
        slice0cost_pair_tag_valid <= false;
        slice0cost_pair_tag_map_column <= false;
        slice0cost_pair_tag_output_column <= false;
        slice0cost_pair_tag_first_column <= false;
        slice0cost_pair_tag_start_of_frame <= false;
        slice0cost_pair_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0cost_column_0(i) <= 0;
        end loop;
        slice0cost_tag_valid <= false;
        slice0cost_tag_map_column <= false;
        slice0cost_tag_output_column <= false;
        slice0cost_tag_first_column <= false;
        slice0cost_tag_start_of_frame <= false;
        slice0cost_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0window_partial_0_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice0window_partial_0_1(i) <= 0;
        end loop;
        slice0window_centre_map_column_0 <= false;
        slice0window_centre_output_column_0 <= false;
        slice0window_centre_first_column_0 <= false;
        slice0window_centre_start_of_frame_0 <= false;
        slice0window_centre_end_of_line_0 <= false;
        for i in 0 to 15 loop
          slice0window_sum_0(i) <= 0;
        end loop;
        slice0window_tag_valid <= false;
        slice0window_tag_map_column <= false;
        slice0window_tag_output_column <= false;
        slice0window_tag_first_column <= false;
        slice0window_tag_start_of_frame <= false;
        slice0window_tag_end_of_line <= false;
        for i in 0 to 15 loop
          slice0mask_inside(i) <= false;
        end loop;
        slice0mask_left_out <= false;
        slice0mask_column <= 0;
        for i in 0 to 1 loop
          for j in 0 to 15 loop
            slice0_held(2 * i, j) <= 0;
          end loop;
          for j in 0 to 15 loop
            slice0_held(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 3 loop
          slice0_tag_valid(i) <= false;
          slice0_tag_map_column(i) <= false;
          slice0_tag_output_column(i) <= false;
          slice0_tag_first_column(i) <= false;
          slice0_tag_start_of_frame(i) <= false;
          slice0_tag_end_of_line(i) <= false;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice1shift_search(i, j) <= 0;
          end loop;
        end loop;
        slice1shift_reference(0) <= 0;
        slice1shift_reference(1) <= 0;
        slice1shift_reference(2) <= 0;
        slice1shift_search_out(0) <= 0;
        slice1shift_search_out(1) <= 0;
        slice1shift_search_out(2) <= 0;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice1cost_pixels_first_count(i, j, 0) <= 0;
            slice1cost_pixels_first_count(i, j, 1) <= 0;
            slice1cost_pixels_first_count(i, j, 2) <= 0;
            slice1cost_pixels_first_count(i, j, 3) <= 0;
            slice1cost_pixels_first_count_4(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice1cost_pixels_cost(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 15 loop
          slice1cost_pair_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1cost_single_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1cost_column_0(i) <= 0;
        end loop;
        slice1cost_tag_first_column <= false;
        for i in 0 to 15 loop
          slice1window_partial_0_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice1window_partial_0_1(i) <= 0;
        end loop;
        slice1window_centre_first_column_0 <= false;
        for i in 0 to 15 loop
          slice1window_sum_0(i) <= 0;
        end loop;
        slice1window_tag_first_column <= false;
        for i in 0 to 15 loop
          slice1mask_inside(i) <= false;
        end loop;
        slice1mask_left_out <= false;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice1_held(i, j) <= 0;
          end loop;
        end loop;
        slice1_tag_0_first_column <= false;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice2shift_search(i, j) <= 0;
          end loop;
        end loop;
        slice2shift_reference(0) <= 0;
        slice2shift_reference(1) <= 0;
        slice2shift_reference(2) <= 0;
        slice2shift_search_out(0) <= 0;
        slice2shift_search_out(1) <= 0;
        slice2shift_search_out(2) <= 0;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice2cost_pixels_first_count(i, j, 0) <= 0;
            slice2cost_pixels_first_count(i, j, 1) <= 0;
            slice2cost_pixels_first_count(i, j, 2) <= 0;
            slice2cost_pixels_first_count(i, j, 3) <= 0;
            slice2cost_pixels_first_count_4(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice2cost_pixels_cost(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 15 loop
          slice2cost_pair_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2cost_single_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2cost_column_0(i) <= 0;
        end loop;
        slice2cost_tag_first_column <= false;
        for i in 0 to 15 loop
          slice2window_partial_0_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2window_partial_0_1(i) <= 0;
        end loop;
        slice2window_centre_first_column_0 <= false;
        for i in 0 to 15 loop
          slice2window_sum_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2mask_inside(i) <= false;
        end loop;
        slice2mask_left_out <= false;
        for i in 0 to 15 loop
          slice2_held(0, i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice2_held(1, i) <= 0;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice3shift_search(i, j) <= 0;
          end loop;
        end loop;
        slice3shift_reference(0) <= 0;
        slice3shift_reference(1) <= 0;
        slice3shift_reference(2) <= 0;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice3cost_pixels_first_count(i, j, 0) <= 0;
            slice3cost_pixels_first_count(i, j, 1) <= 0;
            slice3cost_pixels_first_count(i, j, 2) <= 0;
            slice3cost_pixels_first_count(i, j, 3) <= 0;
            slice3cost_pixels_first_count_4(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 2 loop
          for j in 0 to 15 loop
            slice3cost_pixels_cost(i, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 15 loop
          slice3cost_pair_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3cost_single_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3cost_column_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3window_partial_0_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3window_partial_0_1(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3window_sum_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          slice3mask_inside(i) <= false;
        end loop;
        for i in 0 to 15 loop
          slice3_held_0(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          entry_next_cost(i) <= 0;
        end loop;
        entry_next_tag_valid <= false;
        entry_next_tag_map_column <= false;
        entry_next_tag_first_column <= false;
        entry_next_tag_end_of_line <= false;
        entry_next_column <= 0;
        entry_next_top <= false;
        entry_order_address <= 0;
        entry_order_falls <= false;
        entry_order_inside <= false;
        entry_order_complete <= false;
        entry_order_output <= false;
        entry_order_first <= false;
        entry_order_held_output <= false;
        entry_order_turned_output_column <= false;
        entry_order_turned_first_column <= false;
        entry_order_turned_start_of_frame <= false;
        for i in 0 to 63 loop
          entry_cost(i) <= 0;
        end loop;
        entry_tag_valid <= false;
        entry_tag_map_column <= false;
        entry_tag_first_column <= false;
        entry_tag_end_of_line <= false;
        entry_column <= 0;
        entry_top <= false;
        entry_place <= 0;
        entry_turned_output_column <= false;
        entry_turned_first_column <= false;
        entry_turned_start_of_frame <= false;
        for i in 0 to 31 loop
          forward_smallest_smallest(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          forward_smallest_next_smallest(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          forward_smallest_next_next_smallest(i) <= 0;
        end loop;
        forward_smallest_next_next_next_smallest(0) <= 0;
        forward_smallest_next_next_next_smallest(1) <= 0;
        forward_smallest_next_next_next_smallest(2) <= 0;
        forward_smallest_next_next_next_smallest(3) <= 0;
        forward_smallest_next_next_next_next_smallest(0) <= 0;
        forward_smallest_next_next_next_next_smallest(1) <= 0;
        forward_smallest_next_next_next_next_next_smallest_0 <= 0;
        forward_cost_delay_ring_read_address <= 1;
        forward_cost_delay_ring_write_address <= 0;
        for i in 0 to 31 loop
          forward_left_pair(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          forward_left_tree_smallest(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          forward_left_tree_next_smallest(i) <= 0;
        end loop;
        forward_left_tree_next_next_smallest(0) <= 0;
        forward_left_tree_next_next_smallest(1) <= 0;
        forward_left_tree_next_next_smallest(2) <= 0;
        forward_left_tree_next_next_smallest(3) <= 0;
        forward_left_tree_next_next_next_smallest(0) <= 0;
        forward_left_tree_next_next_next_smallest(1) <= 0;
        forward_left_tree_next_next_next_next_smallest_0 <= 0;
        for i in 0 to 8 loop
          forward_left_start_cost(i) <= 0;
        end loop;
        forward_left_room <= 0;
        forward_left_smallest <= 0;
        forward_left_smallest_less <= 0;
        forward_left_first(0) <= false;
        forward_left_first(1) <= false;
        forward_left_first(2) <= false;
        forward_left_relief_next(0) <= 0;
        forward_left_relief_next(1) <= 0;
        forward_left_relief_next(2) <= 0;
        forward_left_relief_next(3) <= 0;
        for i in 0 to 7 loop
          forward_left_relief_past(i) <= 0;
        end loop;
        forward_left_relief_pairs(0) <= 0;
        forward_left_relief_pairs(1) <= 0;
        forward_left_relief_fours(0) <= 0;
        forward_left_relief_fours(1) <= 0;
        forward_left_relief_fours(2) <= 0;
        forward_left_relief_older <= 0;
        forward_left_relief_recent <= 0;
        forward_left_relief_largest <= 0;
        forward_left_relief_beyond <= 0;
        forward_left_relief_reach_of_best <= 0;
        forward_left_relief_leaves <= 0;
        forward_left_relief_room_of_best <= 0;
        forward_left_relief_reach_again <= 0;
        forward_left_g_copy(0) <= 0;
        forward_left_g_copy(1) <= 1;
        forward_left_g_copy(2) <= 2;
        forward_left_g_copy(3) <= 3;
        forward_left_g_less_copy(0) <= 0;
        forward_left_g_less_copy(1) <= 1;
        forward_left_g_less_copy(2) <= 2;
        forward_left_g_less_copy(3) <= 3;
        for i in 0 to 63 loop
          forward_left_stay_change(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          forward_left_step_change(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          forward_left_cost(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          forward_left_arrived(i) <= 0;
        end loop;
        for i in 0 to 9 loop
          forward_above_ready_words(i) <= 0;
        end loop;
        forward_above_ready_words_10 <= 0;
        for i in 0 to 63 loop
          forward_above_ready_cost(i) <= 0;
        end loop;
        forward_above_ready_top <= false;
        for i in 0 to 63 loop
          forward_above_total(i) <= 0;
        end loop;
        for i in 0 to 31 loop
          forward_above_tree_smallest(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          forward_above_tree_next_smallest(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          forward_above_tree_next_next_smallest(i) <= 0;
        end loop;
        forward_above_tree_next_next_next_smallest(0) <= 0;
        forward_above_tree_next_next_next_smallest(1) <= 0;
        forward_above_tree_next_next_next_smallest(2) <= 0;
        forward_above_tree_next_next_next_smallest(3) <= 0;
        forward_above_tree_next_next_next_next_smallest(0) <= 0;
        forward_above_tree_next_next_next_next_smallest(1) <= 0;
        forward_above_tree_next_next_next_next_next_smallest_0 <= 0;
        forward_above_delay_ring_read_address <= 1;
        forward_above_delay_ring_write_address <= 0;
        forward_above_smallest_copy(0) <= 0;
        forward_above_smallest_copy(1) <= 1;
        forward_above_smallest_copy(2) <= 2;
        forward_above_smallest_copy(3) <= 3;
        for i in 0 to 63 loop
          forward_above_cost(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          forward_above_beside(i) <= 0;
        end loop;
        forward_above_own_0 <= 0;
        for i in 2 to 61 loop
          forward_above_own(i) <= 0;
        end loop;
        forward_above_own_63 <= 0;
        for i in 0 to 63 loop
          forward_above_step(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          forward_above_stay(i) <= 0;
        end loop;
        for i in 0 to 11 loop
          forward_above_comes(i) <= false;
        end loop;
        for i in 0 to 11 loop
          forward_above_column(i) <= 0;
        end loop;
        forward_above_writes_copy_0 <= false;
        for i in 0 to 9 loop
          forward_above_write_words(i) <= 0;
        end loop;
        forward_above_write_words_10 <= 0;
        forward_above_write_column <= 0;
        for i in 0 to 63 loop
          forward_sum(i) <= 0;
        end loop;
        for i in 0 to 10 loop
          forward_first(i) <= false;
        end loop;
        for i in 0 to 10 loop
          forward_reliefs_moved(i) <= 0;
        end loop;
        for i in 0 to 1 loop
          for j in 0 to 63 loop
            forward_cost(2 * i, j) <= 0;
          end loop;
          for j in 0 to 63 loop
            forward_cost(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          forward_smallest_cost(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          sums_turn_ready_sums(i) <= 0;
        end loop;
        for i in 0 to 5 loop
          sums_turn_ready_costs(i) <= 0;
        end loop;
        sums_turn_ready_costs_6 <= 0;
        sums_turn_ready_smallest_0 <= 0;
        sums_turn_ready_first <= false;
        for i in 0 to 10 loop
          sums_turn_place(i) <= 0;
        end loop;
        sums_turn_writes_copy_0 <= false;
        for i in 0 to 15 loop
          sums_turn_write_sums(i) <= 0;
        end loop;
        for i in 0 to 5 loop
          sums_turn_write_costs(i) <= 0;
        end loop;
        sums_turn_write_costs_6 <= 0;
        sums_turn_write_smallest_0 <= 0;
        sums_turn_write_place <= 0;
        sums_turn_waiting_read_place <= 0;
        for i in 0 to 5 loop
          sums_turn_waiting_first(i) <= false;
        end loop;
        for i in 0 to 63 loop
          sums_cost(0, i) <= 0;
        end loop;
        for i in 0 to 63 loop
          sums_cost(1, i) <= 0;
        end loop;
        for i in 0 to 31 loop
          sums_right_pair(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          sums_right_tree_smallest(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          sums_right_tree_next_smallest(i) <= 0;
        end loop;
        sums_right_tree_next_next_smallest(0) <= 0;
        sums_right_tree_next_next_smallest(1) <= 0;
        sums_right_tree_next_next_smallest(2) <= 0;
        sums_right_tree_next_next_smallest(3) <= 0;
        sums_right_tree_next_next_next_smallest(0) <= 0;
        sums_right_tree_next_next_next_smallest(1) <= 0;
        sums_right_tree_next_next_next_next_smallest_0 <= 0;
        for i in 0 to 8 loop
          sums_right_start_cost(i) <= 0;
        end loop;
        sums_right_room <= 0;
        sums_right_smallest <= 0;
        sums_right_smallest_less <= 0;
        sums_right_first(0) <= false;
        sums_right_first(1) <= false;
        sums_right_first(2) <= false;
        sums_right_relief_next(0) <= 0;
        sums_right_relief_next(1) <= 0;
        sums_right_relief_next(2) <= 0;
        sums_right_relief_next(3) <= 0;
        for i in 0 to 7 loop
          sums_right_relief_past(i) <= 0;
        end loop;
        sums_right_relief_pairs(0) <= 0;
        sums_right_relief_pairs(1) <= 0;
        sums_right_relief_fours(0) <= 0;
        sums_right_relief_fours(1) <= 0;
        sums_right_relief_fours(2) <= 0;
        sums_right_relief_older <= 0;
        sums_right_relief_recent <= 0;
        sums_right_relief_largest <= 0;
        sums_right_relief_beyond <= 0;
        sums_right_relief_reach_of_best <= 0;
        sums_right_relief_leaves <= 0;
        sums_right_relief_room_of_best <= 0;
        sums_right_relief_reach_again <= 0;
        sums_right_g_copy(0) <= 0;
        sums_right_g_copy(1) <= 1;
        sums_right_g_copy(2) <= 2;
        sums_right_g_copy(3) <= 3;
        sums_right_g_less_copy(0) <= 0;
        sums_right_g_less_copy(1) <= 1;
        sums_right_g_less_copy(2) <= 2;
        sums_right_g_less_copy(3) <= 3;
        for i in 0 to 63 loop
          sums_right_stay_change(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          sums_right_step_change(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          sums_right_cost(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          sums_right_arrived(i) <= 0;
        end loop;
        sums_sum_delay_ring_read_address <= 1;
        sums_sum_delay_ring_write_address <= 0;
        for i in 0 to 63 loop
          sums_sum_0(i) <= 0;
        end loop;
        sums_tag_valid <= false;
        sums_tag_map_column <= false;
        sums_tag_output_column <= false;
        sums_tag_first_column <= false;
        sums_tag_start_of_frame <= false;
        sums_tag_end_of_line <= false;
        for i in 0 to 11 loop
          sums_tags_held_output_column(i) <= false;
          sums_tags_held_start_of_frame(i) <= false;
          sums_tags_held_end_of_line(i) <= false;
        end loop;
        for i in 12 to 15 loop
          sums_tags_held_map_column(i) <= false;
          sums_tags_held_output_column(i) <= false;
          sums_tags_held_first_column(i) <= false;
          sums_tags_held_start_of_frame(i) <= false;
          sums_tags_held_end_of_line(i) <= false;
        end loop;
        sums_tags_moved <= false;
        for i in 0 to 63 loop
          winnersmask_inside(i) <= false;
        end loop;
        winnersmask_column <= 0;
        for i in 1 to 63 loop
          winnersother_cost_0(i) <= 0;
        end loop;
        for i in 0 to 63 loop
          winnersother_winner_0(i) <= 0;
        end loop;
        winnersother_winner_out_0 <= 0;
        for i in 0 to 63 loop
          winnerswinner1_held_0(i) <= 0;
        end loop;
        for i in 0 to 31 loop
          winnerswinner1_best_cost_0(i) <= 0;
        end loop;
        winnerswinner1_best_index_0_0 <= false;
        winnerswinner1_best_index_0_1 <= 0;
        winnerswinner1_best_index_0_2 <= 0;
        winnerswinner1_best_index_0_3 <= 0;
        winnerswinner1_best_index_0_4 <= 0;
        winnerswinner1_best_index_0_5 <= 0;
        winnerswinner1_best_index_0_6 <= 0;
        winnerswinner1_best_index_0_7 <= 0;
        winnerswinner1_best_index_0_8 <= 0;
        winnerswinner1_best_index_0_9 <= 0;
        winnerswinner1_best_index_0_10 <= 0;
        winnerswinner1_best_index_0_11 <= 0;
        winnerswinner1_best_index_0_12 <= 0;
        winnerswinner1_best_index_0_13 <= 0;
        winnerswinner1_best_index_0_14 <= 0;
        winnerswinner1_best_index_0_15 <= 0;
        winnerswinner1_best_index_0_16 <= 0;
        winnerswinner1_best_index_0_17 <= 0;
        winnerswinner1_best_index_0_18 <= 0;
        winnerswinner1_best_index_0_19 <= 0;
        winnerswinner1_best_index_0_20 <= 0;
        winnerswinner1_best_index_0_21 <= 0;
        winnerswinner1_best_index_0_22 <= 0;
        winnerswinner1_best_index_0_23 <= 0;
        winnerswinner1_best_index_0_24 <= 0;
        winnerswinner1_best_index_0_25 <= 0;
        winnerswinner1_best_index_0_26 <= 0;
        winnerswinner1_best_index_0_27 <= 0;
        winnerswinner1_best_index_0_28 <= 0;
        winnerswinner1_best_index_0_29 <= 0;
        winnerswinner1_best_index_0_30 <= 0;
        winnerswinner1_best_index_0_31 <= 0;
        for i in 0 to 31 loop
          winnerswinner1_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 31 loop
          winnerswinner1_best_above_0(i) <= 0;
        end loop;
        winnerswinner1_best_place_0_2 <= false;
        winnerswinner1_best_place_0_4 <= false;
        winnerswinner1_best_place_0_6 <= false;
        winnerswinner1_best_place_0_8 <= false;
        winnerswinner1_best_place_0_10 <= false;
        winnerswinner1_best_place_0_12 <= false;
        winnerswinner1_best_place_0_14 <= false;
        winnerswinner1_best_place_0_16 <= false;
        winnerswinner1_best_place_0_18 <= false;
        winnerswinner1_best_place_0_20 <= false;
        winnerswinner1_best_place_0_22 <= false;
        winnerswinner1_best_place_0_24 <= false;
        winnerswinner1_best_place_0_26 <= false;
        winnerswinner1_best_place_0_28 <= false;
        winnerswinner1_best_place_0_30 <= false;
        for i in 0 to 31 loop
          winnerswinner1_best_late_cost_0(i) <= 0;
        end loop;
        for i in 1 to 31 loop
          winnerswinner1_best_but_first_0(i) <= 255;
        end loop;
        for i in 0 to 30 loop
          winnerswinner1_best_but_last_0(i) <= 255;
        end loop;
        winnerswinner1_tag_valid <= false;
        winnerswinner1_tag_map_column <= false;
        winnerswinner1_tag_output_column <= false;
        winnerswinner1_tag_first_column <= false;
        winnerswinner1_tag_start_of_frame <= false;
        winnerswinner1_tag_end_of_line <= false;
        for i in 0 to 15 loop
          winnerswinner2_best_cost_0(i) <= 0;
        end loop;
        winnerswinner2_best_index_0_0 <= 0;
        winnerswinner2_best_index_0_1 <= 0;
        winnerswinner2_best_index_0_2 <= 0;
        winnerswinner2_best_index_0_3 <= 0;
        winnerswinner2_best_index_0_4 <= 0;
        winnerswinner2_best_index_0_5 <= 0;
        winnerswinner2_best_index_0_6 <= 0;
        winnerswinner2_best_index_0_7 <= 0;
        winnerswinner2_best_index_0_8 <= 0;
        winnerswinner2_best_index_0_9 <= 0;
        winnerswinner2_best_index_0_10 <= 0;
        winnerswinner2_best_index_0_11 <= 0;
        winnerswinner2_best_index_0_12 <= 0;
        winnerswinner2_best_index_0_13 <= 0;
        winnerswinner2_best_index_0_14 <= 0;
        winnerswinner2_best_index_0_15 <= 0;
        for i in 0 to 15 loop
          winnerswinner2_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_above_0(i) <= 0;
        end loop;
        for i in 1 to 15 loop
          winnerswinner2_best_first_0(i) <= 0;
        end loop;
        for i in 0 to 14 loop
          winnerswinner2_best_last_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_place_0(i) <= false;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_at_start_0(i) <= false;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_at_end_0(i) <= false;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_late_cost_0(i) <= 0;
        end loop;
        for i in 0 to 15 loop
          winnerswinner2_best_second_0(i) <= 255;
        end loop;
        for i in 1 to 15 loop
          winnerswinner2_best_but_first_0(i) <= 255;
        end loop;
        for i in 0 to 14 loop
          winnerswinner2_best_but_last_0(i) <= 255;
        end loop;
        winnerswinner2_tag_valid <= false;
        winnerswinner2_tag_map_column <= false;
        winnerswinner2_tag_output_column <= false;
        winnerswinner2_tag_first_column <= false;
        winnerswinner2_tag_start_of_frame <= false;
        winnerswinner2_tag_end_of_line <= false;
        for i in 0 to 7 loop
          winnerswinner3_best_cost_0(i) <= 0;
        end loop;
        winnerswinner3_best_index_0_0 <= 0;
        winnerswinner3_best_index_0_1 <= 0;
        winnerswinner3_best_index_0_2 <= 0;
        winnerswinner3_best_index_0_3 <= 0;
        winnerswinner3_best_index_0_4 <= 0;
        winnerswinner3_best_index_0_5 <= 0;
        winnerswinner3_best_index_0_6 <= 0;
        winnerswinner3_best_index_0_7 <= 0;
        for i in 0 to 7 loop
          winnerswinner3_best_below_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_above_0(i) <= 0;
        end loop;
        for i in 1 to 7 loop
          winnerswinner3_best_first_0(i) <= 0;
        end loop;
        for i in 0 to 6 loop
          winnerswinner3_best_last_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_place_0(i) <= false;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_at_start_0(i) <= false;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_at_end_0(i) <= false;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_late_cost_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          winnerswinner3_best_second_0(i) <= 255;
        end loop;
        for i in 1 to 7 loop
          winnerswinner3_best_but_first_0(i) <= 255;
        end loop;
        for i in 0 to 6 loop
          winnerswinner3_best_but_last_0(i) <= 255;
        end loop;
        winnerswinner3_tag_valid <= false;
        winnerswinner3_tag_map_column <= false;
        winnerswinner3_tag_output_column <= false;
        winnerswinner3_tag_first_column <= false;
        winnerswinner3_tag_start_of_frame <= false;
        winnerswinner3_tag_end_of_line <= false;
        winnerswinner4_best_cost_0(0) <= 0;
        winnerswinner4_best_cost_0(1) <= 0;
        winnerswinner4_best_cost_0(2) <= 0;
        winnerswinner4_best_cost_0(3) <= 0;
        winnerswinner4_best_index_0_0 <= 0;
        winnerswinner4_best_index_0_1 <= 0;
        winnerswinner4_best_index_0_2 <= 0;
        winnerswinner4_best_index_0_3 <= 0;
        winnerswinner4_best_below_0(0) <= 0;
        winnerswinner4_best_below_0(1) <= 0;
        winnerswinner4_best_below_0(2) <= 0;
        winnerswinner4_best_below_0(3) <= 0;
        winnerswinner4_best_above_0(0) <= 0;
        winnerswinner4_best_above_0(1) <= 0;
        winnerswinner4_best_above_0(2) <= 0;
        winnerswinner4_best_above_0(3) <= 0;
        winnerswinner4_best_first_0(1) <= 0;
        winnerswinner4_best_first_0(2) <= 0;
        winnerswinner4_best_first_0(3) <= 0;
        winnerswinner4_best_last_0(0) <= 0;
        winnerswinner4_best_last_0(1) <= 0;
        winnerswinner4_best_last_0(2) <= 0;
        winnerswinner4_best_place_0(0) <= false;
        winnerswinner4_best_place_0(1) <= false;
        winnerswinner4_best_place_0(2) <= false;
        winnerswinner4_best_place_0(3) <= false;
        winnerswinner4_best_at_start_0(0) <= false;
        winnerswinner4_best_at_start_0(1) <= false;
        winnerswinner4_best_at_start_0(2) <= false;
        winnerswinner4_best_at_start_0(3) <= false;
        winnerswinner4_best_at_end_0(0) <= false;
        winnerswinner4_best_at_end_0(1) <= false;
        winnerswinner4_best_at_end_0(2) <= false;
        winnerswinner4_best_at_end_0(3) <= false;
        winnerswinner4_best_late_cost_0(0) <= 0;
        winnerswinner4_best_late_cost_0(1) <= 0;
        winnerswinner4_best_late_cost_0(2) <= 0;
        winnerswinner4_best_late_cost_0(3) <= 0;
        winnerswinner4_best_second_0(0) <= 255;
        winnerswinner4_best_second_0(1) <= 255;
        winnerswinner4_best_second_0(2) <= 255;
        winnerswinner4_best_second_0(3) <= 255;
        winnerswinner4_best_but_first_0(1) <= 255;
        winnerswinner4_best_but_first_0(2) <= 255;
        winnerswinner4_best_but_first_0(3) <= 255;
        winnerswinner4_best_but_last_0(0) <= 255;
        winnerswinner4_best_but_last_0(1) <= 255;
        winnerswinner4_best_but_last_0(2) <= 255;
        winnerswinner4_tag_valid <= false;
        winnerswinner4_tag_map_column <= false;
        winnerswinner4_tag_output_column <= false;
        winnerswinner4_tag_first_column <= false;
        winnerswinner4_tag_start_of_frame <= false;
        winnerswinner4_tag_end_of_line <= false;
        winnerswinner5_best_cost_0(0) <= 0;
        winnerswinner5_best_cost_0(1) <= 0;
        winnerswinner5_best_index_0_0 <= 0;
        winnerswinner5_best_index_0_1 <= 0;
        winnerswinner5_best_below_0(0) <= 0;
        winnerswinner5_best_below_0(1) <= 0;
        winnerswinner5_best_above_0(0) <= 0;
        winnerswinner5_best_above_0(1) <= 0;
        winnerswinner5_best_first_0_1 <= 0;
        winnerswinner5_best_last_0_0 <= 0;
        winnerswinner5_best_place_0(0) <= false;
        winnerswinner5_best_place_0(1) <= false;
        winnerswinner5_best_at_start_0(0) <= false;
        winnerswinner5_best_at_start_0(1) <= false;
        winnerswinner5_best_at_end_0(0) <= false;
        winnerswinner5_best_at_end_0(1) <= false;
        winnerswinner5_best_late_cost_0(0) <= 0;
        winnerswinner5_best_late_cost_0(1) <= 0;
        winnerswinner5_best_second_0(0) <= 255;
        winnerswinner5_best_second_0(1) <= 255;
        winnerswinner5_best_but_first_0_1 <= 255;
        winnerswinner5_best_but_last_0_0 <= 255;
        winnerswinner5_tag_valid <= false;
        winnerswinner5_tag_map_column <= false;
        winnerswinner5_tag_output_column <= false;
        winnerswinner5_tag_first_column <= false;
        winnerswinner5_tag_start_of_frame <= false;
        winnerswinner5_tag_end_of_line <= false;
        winnerswinner6_best_cost_0_0 <= 0;
        winnerswinner6_best_index_0_0 <= 0;
        winnerswinner6_best_below_0_0 <= 0;
        winnerswinner6_best_above_0_0 <= 0;
        winnerswinner6_best_place_0_0 <= false;
        winnerswinner6_best_at_start_0_0 <= false;
        winnerswinner6_best_at_end_0_0 <= false;
        winnerswinner6_best_late_cost_0_0 <= 0;
        winnerswinner6_best_second_0_0 <= 255;
        winnerswinner6_tag_valid <= false;
        winnerswinner6_tag_map_column <= false;
        winnerswinner6_tag_output_column <= false;
        winnerswinner6_tag_first_column <= false;
        winnerswinner6_tag_start_of_frame <= false;
        winnerswinner6_tag_end_of_line <= false;
        winners_best_index_0_0 <= 0;
        winners_best_below_0_0 <= 0;
        winners_best_above_0_0 <= 0;
        winners_best_late_cost_0_0 <= 0;
        winners_best_second_0_0 <= 255;
        winners_best_tag_valid <= false;
        winners_best_tag_map_column <= false;
        winners_best_tag_output_column <= false;
        winners_best_tag_start_of_frame <= false;
        winners_best_tag_end_of_line <= false;
        winners_partner_column <= 0;
        winners_partner_at <= 0;
        for i in 0 to 11 loop
          refinement_disparity_0(i) <= 0;
        end loop;
        for i in 0 to 11 loop
          refinement_passed_0(i) <= false;
        end loop;
        for i in 0 to 11 loop
          refinement_tag_valid(i) <= false;
          refinement_tag_map_column(i) <= false;
          refinement_tag_output_column(i) <= false;
          refinement_tag_start_of_frame(i) <= false;
          refinement_tag_end_of_line(i) <= false;
        end loop;
        refinement_alone_0_0 <= false;
        refinement_gap_0 <= 0;
        for i in 0 to 9 loop
          refinement_margin_0(i) <= 0;
        end loop;
        refinement_below_0 <= 0;
        refinement_above_0 <= 0;
        refinement_u_0 <= 0;
        refinement_v_0 <= 0;
        refinement_difference_0 <= 0;
        for i in 0 to 7 loop
          refinement_remainder_0(i) <= 0;
        end loop;
        for i in 0 to 7 loop
          refinement_divisor_0(i) <= 1;
        end loop;
        refinement_quotient_8_0 <= 0;
        for i in 0 to 8 loop
          refinement_negative_0(i) <= false;
        end loop;
        refinement_fraction_0 <= 8;
        for i in 1 to 17 loop
          leftright_other_0(i) <= 0;
        end loop;
        leftright_ring_read_address <= 1;
        leftright_ring_write_address <= 0;
        leftright_holds_winners <= false;
        leftright_position <= 0;
        leftright_held_position <= 0;
        leftright_held_valid <= false;
        leftright_address_0 <= 0;
        leftright_asking_disparity_0 <= 0;
        leftright_asking_fraction_0 <= 8;
        leftright_asking_passed_0 <= true;
        leftright_asking_margin_0 <= 0;
        leftright_asking_tag_valid <= false;
        leftright_asking_tag_map_column <= false;
        leftright_asking_tag_output_column <= false;
        leftright_asking_tag_start_of_frame <= false;
        leftright_asking_tag_end_of_line <= false;
        leftright_answered_disparity_0 <= 0;
        leftright_answered_fraction_0 <= 8;
        leftright_answered_passed_0 <= true;
        leftright_answered_margin_0 <= 0;
        leftright_answered_tag_valid <= false;
        leftright_answered_tag_map_column <= false;
        leftright_answered_tag_output_column <= false;
        leftright_answered_tag_start_of_frame <= false;
        leftright_answered_tag_end_of_line <= false;
        leftright_checked_disparity_0 <= 0;
        leftright_checked_fraction_0 <= 8;
        leftright_checked_passed_0 <= true;
        leftright_checked_margin_0 <= 0;
        leftright_checked_tag_valid <= false;
        leftright_checked_tag_map_column <= false;
        leftright_checked_tag_output_column <= false;
        leftright_checked_tag_start_of_frame <= false;
        leftright_checked_tag_end_of_line <= false;
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
        turn_newest <= 0;
        turn_comes <= false;
        turn_read_tag_valid <= false;
        turn_read_tag_map_column <= false;
        turn_read_tag_start_of_frame <= false;
        turn_read_tag_end_of_line <= false;
        turn_write_words_0 <= 0;
        turn_write_place <= 0;
        turn_ready <= 0;
        turn_ready_tag_valid <= false;
        turn_ready_tag_row_start <= false;
        turn_ready_tag_map_column <= false;
        turn_ready_tag_start_of_frame <= false;
        turn_ready_tag_end_of_line <= false;
        support_counter_column <= 0;
        support_counter_group <= 377;
        support_newest_0 <= 0;
        support_newest_rest_0 <= 0;
        support_moves <= false;
        support_arrives <= false;
        support_last <= false;
        support_rows_read_newest_0 <= 0;
        support_rows_ready_words_0 <= 0;
        support_rows_ready_newest_0 <= 0;
        support_rows_write_words_0 <= 0;
        support_rest_rows_read_newest_0 <= 0;
        support_rest_rows_ready_words_0 <= 0;
        support_rest_rows_ready_newest_0 <= 0;
        support_rest_rows_write_words_0 <= 0;
        support_read_column <= 0;
        support_read_moves <= false;
        support_read_arrives <= false;
        support_read_above2 <= false;
        support_read_above1 <= false;
        support_read_below1 <= false;
        support_read_below2 <= false;
        support_read_first <= false;
        support_read_last <= false;
        support_ready_column <= 0;
        support_ready_moves <= false;
        support_ready_arrives <= false;
        support_ready_above2 <= false;
        support_ready_above1 <= false;
        support_ready_below1 <= false;
        support_ready_below2 <= false;
        support_ready_first <= false;
        support_ready_last <= false;
        support_write_column <= 0;
        for i in 0 to 4 loop
          support_column(i) <= 0;
        end loop;
        support_column_rest_0 <= 0;
        support_at_moves <= false;
        support_at_arrives <= false;
        support_at_first <= false;
        support_at_last <= false;
        for i in 0 to 5 loop
          for j in 0 to 4 loop
            support_cells(2 * i, j) <= 0;
          end loop;
          for j in 0 to 4 loop
            support_cells(2 * i + 1, j) <= 0;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_cells(12, i) <= 0;
        end loop;
        for i in 0 to 12 loop
          support_row_tag(i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_rest_0(i) <= 0;
        end loop;
        for i in 0 to 6 loop
          support_moment_map_column(i) <= false;
          support_moment_start_of_frame(i) <= false;
          support_moment_last(i) <= false;
        end loop;
        support_next_tag <= false;
        support_moved <= false;
        for i in 0 to 2 loop
          for j in 0 to 4 loop
            support_like_0(2 * i, j) <= false;
          end loop;
          for j in 0 to 4 loop
            support_like_0(2 * i + 1, j) <= false;
          end loop;
        end loop;
        for i in 0 to 4 loop
          support_like_0(6, i) <= false;
        end loop;
        for i in 0 to 6 loop
          support_partial_0(i) <= 0;
        end loop;
        support_count_0 <= 0;
        support_enough_0 <= false;
        support_sum_0 <= 0;
        support_centre_0(0) <= 0;
        support_centre_0(1) <= 0;
        support_centre_0(2) <= 0;
        support_centre_rest_0(0) <= 0;
        support_centre_rest_0(1) <= 0;
        support_centre_rest_0(2) <= 0;
        for i in 0 to 3 loop
          support_centre_moment_map_column(i) <= false;
          support_centre_moment_start_of_frame(i) <= false;
          support_centre_moment_last(i) <= false;
        end loop;
        support_centre_moved(0) <= false;
        support_centre_moved(1) <= false;
        support_centre_moved(2) <= false;
        support_centre_moved(3) <= false;
        support_out_disparity_0 <= 0;
        support_out_passed_0 <= false;
        support_out_sure_0 <= 0;
        support_out_tag_valid <= false;
        support_out_tag_row_start <= false;
        support_out_tag_map_column <= false;
        support_out_tag_start_of_frame <= false;
        support_out_tag_end_of_line <= false;
        fill_counter_column <= 0;
        fill_counter_group <= 376;
        fill_newest_disparity_0 <= 0;
        fill_newest_passed_0 <= false;
        fill_newest_sure_0 <= 0;
        fill_moves <= false;
        fill_arrives <= false;
        fill_last <= false;
        fill_rows_read_newest_0 <= 0;
        fill_rows_ready_words_0 <= 0;
        fill_rows_ready_newest_0 <= 0;
        fill_rows_write_words_0 <= 0;
        fill_read_column <= 0;
        fill_read_moves <= false;
        fill_read_arrives <= false;
        fill_read_top <= false;
        fill_read_last <= false;
        fill_ready_column <= 0;
        fill_ready_moves <= false;
        fill_ready_arrives <= false;
        fill_ready_top <= false;
        fill_ready_last <= false;
        fill_write_column <= 0;
        fill_ends_open_0 <= false;
        fill_pixel_0_passed <= false;
        fill_at_column <= 0;
        fill_at_moves <= false;
        fill_at_arrives <= false;
        fill_at_top <= false;
        fill_at_last <= false;
        fill_in_hole_0 <= false;
        fill_asking_0_passed(0) <= false;
        fill_asking_0_passed(1) <= false;
        for i in 0 to 1 loop
          fill_asking_at_column(i) <= 0;
          fill_asking_at_moves(i) <= false;
          fill_asking_at_arrives(i) <= false;
          fill_asking_at_top(i) <= false;
          fill_asking_at_last(i) <= false;
        end loop;
        fill_hole_starts_0(0) <= false;
        fill_hole_starts_0(1) <= false;
        fill_known_at_column <= 0;
        fill_known_at_moves <= false;
        fill_known_at_arrives <= false;
        fill_known_at_top <= false;
        fill_known_at_last <= false;
        fill_measured_at_column <= 0;
        fill_measured_at_moves <= false;
        fill_measured_at_arrives <= false;
        fill_measured_at_top <= false;
        fill_measured_at_last <= false;
        fill_chosen_at_column <= 0;
        fill_chosen_at_moves <= false;
        fill_chosen_at_arrives <= false;
        fill_chosen_at_top <= false;
        fill_chosen_at_last <= false;
        fill_out_tag_valid <= false;
        fill_out_tag_row_start <= false;
        fill_out_tag_map_column <= false;
        fill_out_tag_start_of_frame <= false;
        fill_out_tag_end_of_line <= false;
        median_counter_column <= 0;
        median_counter_group <= 376;
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
        median_at_arrives <= false;
        median_at_behind <= false;
        median_at_top <= false;
        median_at_output <= false;
        median_comparing_column <= 0;
        median_comparing_arrives <= false;
        median_comparing_behind <= false;
        median_comparing_top <= false;
        median_comparing_output <= false;
        median_sorted_column <= 0;
        median_sorted_arrives <= false;
        median_sorted_behind <= false;
        median_sorted_top <= false;
        median_sorted_output <= false;
        median_window_complete <= false;
        median_window_first <= false;
        median_window_last <= false;
        for i in 0 to 2 loop
          median_waiting_complete(i) <= false;
          median_waiting_first(i) <= false;
          median_waiting_last(i) <= false;
        end loop;
        median_out_valid <= false;
        median_out_start_of_frame <= false;
        median_out_end_of_line <= false;
        for i in 0 to 4 loop
          relief_centre_column(i) <= 0;
        end loop;
        relief_centre_grey_0 <= 0;
        relief_before <= 0;
        relief_newest <= 0;
        relief_delayed_0 <= 0;
        relief_rows_read_newest_0 <= 0;
        relief_rows_ready_words_0 <= 0;
        relief_rows_ready_newest_0 <= 0;
        relief_rows_write_words_0 <= 0;
        relief_shown_0 <= 0;
        relief_column_0 <= 0;
        for i in 0 to 9 loop
          relief_waiting(i) <= 0;
        end loop;
        relief_entering <= 0;
        relief_entered <= 0;
        other_0 <= true;
        other_2 <= 0;
        other_3 <= 0;
        other_4 <= 0;
        other_5 <= 0;
        other_6 <= 0;
        other_7 <= 0;
        other_8 <= 0;
        other_9 <= 0;
        other_10 <= 0;
      end if;
    end if;
  end process;
end architecture;
