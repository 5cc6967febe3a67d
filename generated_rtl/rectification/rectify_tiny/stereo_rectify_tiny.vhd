-- SPDX-License-Identifier: Apache-2.0
-- Stage in front of a stereo core, rectification, configuration rectify_tiny: 32x12, a node every 4 pixels, 3 rows above and 3 below, 1 pixel pair a clock.
-- Options: grid_px 4, rows_above 3, rows_below 3.
-- Made from hls/top/rectification_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config rectify_tiny
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_rectify_tiny is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 32;
    height_px : positive := 12;
    pixels_per_clock : positive := 1;
    table_columns : positive := 9;
    table_rows : positive := 4;
    latency_clocks : positive := 24;
    flush_groups : positive := 128
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(7 downto 0);  -- as the cameras send them
    right_pixel : in std_logic_vector(7 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first row
    valid : in std_logic;  -- 0: bubble
    node_valid : in std_logic;  -- a node of a table: docs/rectification.md
    node_right : in std_logic;  -- of the right camera's table
    node_column : in std_logic_vector(15 downto 0);  -- of the node, below table_columns
    node_row : in std_logic_vector(15 downto 0);  -- below table_rows
    node_x : in std_logic_vector(15 downto 0);  -- offset to the right in two's complement
    node_y : in std_logic_vector(15 downto 0);  -- offset down
    rectified_left : out std_logic_vector(7 downto 0);
    rectified_right : out std_logic_vector(7 downto 0);
    rectified_start_of_frame : out std_logic;
    rectified_valid : out std_logic
  );
begin
  assert width_px = 32 report "stereo_rectify_tiny: width_px is " & integer'image(width_px) & " but this core has 32" severity failure;
  assert height_px = 12 report "stereo_rectify_tiny: height_px is " & integer'image(height_px) & " but this core has 12" severity failure;
  assert pixels_per_clock = 1 report "stereo_rectify_tiny: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert table_columns = 9 report "stereo_rectify_tiny: table_columns is " & integer'image(table_columns) & " but this core has 9" severity failure;
  assert table_rows = 4 report "stereo_rectify_tiny: table_rows is " & integer'image(table_rows) & " but this core has 4" severity failure;
  assert latency_clocks = 24 report "stereo_rectify_tiny: latency_clocks is " & integer'image(latency_clocks) & " but this core has 24" severity failure;
  assert flush_groups = 128 report "stereo_rectify_tiny: flush_groups is " & integer'image(flush_groups) & " but this core has 128" severity failure;
end entity;

architecture rtl of stereo_rectify_tiny is
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

  signal in_node_x : natural range 0 to 65535;
  signal in_node_y : natural range 0 to 65535;
  signal in_node_column : natural range 0 to 65535;
  signal in_node_row : natural range 0 to 65535;
  signal in_node_valid : boolean;
  signal in_node_right : boolean;
  signal in_valid : boolean;
  signal in_start_of_frame : boolean;
  signal in_right_pixel : natural range 0 to 255;
  signal in_left_pixel : natural range 0 to 255;
  -- counter
  signal counter_column, counter_group : natural range 0 to 31;
  signal counter_next_frame : boolean;
  -- delay
  signal delay_held_0_left, delay_held_0_right, delay_held_1_left, delay_held_1_right : natural range 0 to 255;
  signal delay_held_2_left, delay_held_2_right, delay_held_3_left, delay_held_3_right : natural range 0 to 255;
  signal delay_held_4_left, delay_held_4_right, delay_held_5_left, delay_held_5_right : natural range 0 to 255;
  signal delay_held_6_left, delay_held_6_right, delay_held_7_left, delay_held_7_right : natural range 0 to 255;
  signal delay_held_8_left, delay_held_8_right, delay_held_9_left, delay_held_9_right : natural range 0 to 255;
  signal delay_held_10_left, delay_held_10_right : natural range 0 to 255;
  signal delay_held_0_start_of_frame, delay_held_0_valid, delay_held_1_start_of_frame, delay_held_1_valid : boolean;
  signal delay_held_2_start_of_frame, delay_held_2_valid, delay_held_3_start_of_frame, delay_held_3_valid : boolean;
  signal delay_held_4_start_of_frame, delay_held_4_valid, delay_held_5_start_of_frame, delay_held_5_valid : boolean;
  signal delay_held_6_start_of_frame, delay_held_6_valid, delay_held_7_start_of_frame, delay_held_7_valid : boolean;
  signal delay_held_8_start_of_frame, delay_held_8_valid, delay_held_9_start_of_frame, delay_held_9_valid : boolean;
  signal delay_held_10_start_of_frame, delay_held_10_valid : boolean;
  -- grid
  signal grid_node_column : natural range 0 to 7;
  signal grid_node_row, grid_weight_x_held_0, grid_weight_x_held_1, grid_weight_x_held_2 : natural range 0 to 3;
  signal grid_weight_x_held_3, grid_weight_x_held_4, grid_weight_y_held_0, grid_weight_y_held_1 : natural range 0 to 3;
  signal grid_weight_y_held_2, grid_weight_y_held_3, grid_weight_y_held_4 : natural range 0 to 3;
  -- leftoffsets
  signal leftoffsets_nodes_even_line : natural range 0 to 6;
  signal leftoffsets_nodes_odd_line : natural range 0 to 5;
  signal leftoffsets_nodes_write_line : natural range 0 to 7;
  signal leftoffsets_nodes_even_column : natural range 0 to 4;
  signal leftoffsets_nodes_odd_column, leftoffsets_x_left_part, leftoffsets_x_weight_x_held_0 : natural range 0 to 3;
  signal leftoffsets_x_weight_x_held_1, leftoffsets_x_weight_x_held_2, leftoffsets_x_row_part : natural range 0 to 3;
  signal leftoffsets_nodes_write_column, leftoffsets_nodes_even_even_write_address : natural range 0 to 15;
  signal leftoffsets_nodes_even_odd_write_address, leftoffsets_nodes_odd_even_write_address : natural range 0 to 15;
  signal leftoffsets_nodes_odd_odd_write_address : natural range 0 to 15;
  signal leftoffsets_nodes_to_even_even, leftoffsets_nodes_to_even_odd, leftoffsets_nodes_to_odd_even : boolean;
  signal leftoffsets_nodes_to_odd_odd, leftoffsets_nodes_row_odd_0, leftoffsets_nodes_row_odd_1 : boolean;
  signal leftoffsets_nodes_row_odd_2, leftoffsets_nodes_row_odd_3, leftoffsets_nodes_column_odd_0 : boolean;
  signal leftoffsets_nodes_column_odd_1, leftoffsets_nodes_column_odd_2, leftoffsets_nodes_column_odd_3 : boolean;
  signal leftoffsets_nodes_written, leftoffsets_nodes_even_even_write_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_even_read_word, leftoffsets_nodes_even_even_ready_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_odd_write_word, leftoffsets_nodes_even_odd_read_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_odd_ready_word, leftoffsets_nodes_odd_even_write_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_odd_even_read_word, leftoffsets_nodes_odd_even_ready_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_odd_odd_write_word, leftoffsets_nodes_odd_odd_read_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_odd_odd_ready_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_even_read_address : natural range 0 to 10;
  signal leftoffsets_nodes_even_odd_read_address, leftoffsets_nodes_odd_even_read_address : natural range 0 to 9;
  signal leftoffsets_nodes_odd_odd_read_address : natural range 0 to 8;
  signal leftoffsets_x_left_from, leftoffsets_x_right_from, leftoffsets_x_row_value : natural range 0 to 65535;
  signal leftoffsets_y_left_from, leftoffsets_y_right_from, leftoffsets_y_row_value : natural range 0 to 65535;
  signal leftoffsets_x_left_difference, leftoffsets_x_right_difference : integer range -65535 to 65535;
  signal leftoffsets_y_left_difference, leftoffsets_y_right_difference : integer range -65535 to 65535;
  signal leftoffsets_x_left_base, leftoffsets_x_right_base, leftoffsets_y_left_base : natural range 0 to 262140;
  signal leftoffsets_y_right_base : natural range 0 to 262140;
  signal leftoffsets_x_left_value, leftoffsets_x_right_value, leftoffsets_x_row_from : natural range 0 to 262143;
  signal leftoffsets_y_left_value, leftoffsets_y_right_value, leftoffsets_y_row_from : natural range 0 to 262143;
  signal leftoffsets_x_row_difference, leftoffsets_y_row_difference : integer range -262143 to 262143;
  signal leftoffsets_x_row_base, leftoffsets_y_row_base : natural range 0 to 1048588;
  signal leftoffsets_x_row_share, leftoffsets_y_row_share : integer range -786429 to 786429;
  signal leftoffsets_y_left_share, leftoffsets_y_right_share : integer range -131072 to 131071;
  -- rightoffsets
  signal rightoffsets_nodes_to_even_even, rightoffsets_nodes_to_even_odd, rightoffsets_nodes_to_odd_even : boolean;
  signal rightoffsets_nodes_to_odd_odd : boolean;
  signal rightoffsets_nodes_even_even_write_address, rightoffsets_nodes_even_odd_write_address : natural range 0 to 15;
  signal rightoffsets_nodes_odd_even_write_address, rightoffsets_nodes_odd_odd_write_address : natural range 0 to 15;
  signal rightoffsets_nodes_even_even_write_word, rightoffsets_nodes_even_even_read_word : unsigned(31 downto 0);
  signal rightoffsets_nodes_even_even_ready_word, rightoffsets_nodes_even_odd_write_word : unsigned(31 downto 0);
  signal rightoffsets_nodes_even_odd_read_word, rightoffsets_nodes_even_odd_ready_word : unsigned(31 downto 0);
  signal rightoffsets_nodes_odd_even_write_word, rightoffsets_nodes_odd_even_read_word : unsigned(31 downto 0);
  signal rightoffsets_nodes_odd_even_ready_word, rightoffsets_nodes_odd_odd_write_word : unsigned(31 downto 0);
  signal rightoffsets_nodes_odd_odd_read_word, rightoffsets_nodes_odd_odd_ready_word : unsigned(31 downto 0);
  signal rightoffsets_x_left_from, rightoffsets_x_right_from, rightoffsets_x_row_value : natural range 0 to 65535;
  signal rightoffsets_y_left_from, rightoffsets_y_right_from, rightoffsets_y_row_value : natural range 0 to 65535;
  signal rightoffsets_x_left_difference, rightoffsets_x_right_difference : integer range -65535 to 65535;
  signal rightoffsets_y_left_difference, rightoffsets_y_right_difference : integer range -65535 to 65535;
  signal rightoffsets_x_left_base, rightoffsets_x_right_base, rightoffsets_y_left_base : natural range 0 to 262140;
  signal rightoffsets_y_right_base : natural range 0 to 262140;
  signal rightoffsets_x_left_value, rightoffsets_x_right_value, rightoffsets_x_row_from : natural range 0 to 262143;
  signal rightoffsets_y_left_value, rightoffsets_y_right_value, rightoffsets_y_row_from : natural range 0 to 262143;
  signal rightoffsets_x_row_difference, rightoffsets_y_row_difference : integer range -262143 to 262143;
  signal rightoffsets_x_row_base, rightoffsets_y_row_base : natural range 0 to 1048588;
  signal rightoffsets_x_row_share, rightoffsets_y_row_share : integer range -786429 to 786429;
  -- sample
  signal sample_place_column, sample_place_group : natural range 0 to 31;
  signal sample_place_next_frame, sample_pixels_valid, sample_leaves, sample_starts : boolean;
  signal sample_taken_pixels_valid, sample_kept_pixels_valid, sample_kept_starts : boolean;
  signal sample_slot, sample_taken_row, sample_kept_row : natural range 0 to 7;
  signal sample_pixels_left, sample_pixels_right, sample_taken_pixels_left : natural range 0 to 255;
  signal sample_taken_pixels_right, sample_kept_pixels_left, sample_kept_pixels_right : natural range 0 to 255;
  signal sample_row : natural range 0 to 15;
  signal sample_taken_column, sample_kept_column : natural range 0 to 32;
  -- lefttaps
  signal lefttaps_source_x : natural range 0 to 66527;
  signal lefttaps_offset_y : natural range 0 to 65535;
  signal lefttaps_taps_column : natural range 0 to 255;
  signal lefttaps_taps_row : natural range 0 to 7;
  signal lefttaps_weight_x, lefttaps_weight_y : natural range 0 to 31;
  signal lefttaps_column_shown_0, lefttaps_column_shown_1, lefttaps_row_shown_0, lefttaps_row_shown_1 : boolean;
  -- righttaps
  signal righttaps_source_x : natural range 0 to 66527;
  signal righttaps_offset_y : natural range 0 to 65535;
  signal righttaps_taps_column : natural range 0 to 255;
  signal righttaps_taps_row : natural range 0 to 7;
  signal righttaps_weight_x, righttaps_weight_y : natural range 0 to 31;
  signal righttaps_column_shown_0, righttaps_column_shown_1, righttaps_row_shown_0, righttaps_row_shown_1 : boolean;
  -- leftsampler
  signal leftsampler_rows_even_line : natural range 0 to 52;
  signal leftsampler_rows_odd_line, leftsampler_rows_write_line : natural range 0 to 51;
  signal leftsampler_rows_even_column, leftsampler_rows_odd_column : natural range 0 to 127;
  signal leftsampler_rows_even_even_read_address, leftsampler_rows_even_odd_read_address : natural range 0 to 127;
  signal leftsampler_rows_odd_even_read_address, leftsampler_rows_odd_odd_read_address : natural range 0 to 127;
  signal leftsampler_rows_write_column : natural range 0 to 16;
  signal leftsampler_rows_to_even_even, leftsampler_rows_to_even_odd, leftsampler_rows_to_odd_even : boolean;
  signal leftsampler_rows_to_odd_odd, leftsampler_rows_row_odd_0, leftsampler_rows_row_odd_1 : boolean;
  signal leftsampler_rows_row_odd_2, leftsampler_rows_row_odd_3, leftsampler_rows_column_odd_0 : boolean;
  signal leftsampler_rows_column_odd_1, leftsampler_rows_column_odd_2, leftsampler_rows_column_odd_3 : boolean;
  signal leftsampler_rows_written, leftsampler_rows_even_even_write_word : natural range 0 to 255;
  signal leftsampler_rows_even_even_ready_word, leftsampler_rows_even_odd_write_word : natural range 0 to 255;
  signal leftsampler_rows_even_odd_ready_word, leftsampler_rows_odd_even_write_word : natural range 0 to 255;
  signal leftsampler_rows_odd_even_ready_word, leftsampler_rows_odd_odd_write_word : natural range 0 to 255;
  signal leftsampler_rows_odd_odd_ready_word, leftsampler_pixel_left_from : natural range 0 to 255;
  signal leftsampler_pixel_right_from, leftsampler_pixel_row_value : natural range 0 to 255;
  signal leftsampler_rows_even_even_write_address, leftsampler_rows_even_odd_write_address : natural range 0 to 67;
  signal leftsampler_rows_odd_even_write_address, leftsampler_rows_odd_odd_write_address : natural range 0 to 67;
  signal leftsampler_rows_even_even_read_word, leftsampler_rows_even_odd_read_word : unsigned(7 downto 0);
  signal leftsampler_rows_odd_even_read_word, leftsampler_rows_odd_odd_read_word : unsigned(7 downto 0);
  signal leftsampler_weight_x_held_0, leftsampler_weight_x_held_1, leftsampler_weight_x_held_2 : natural range 0 to 31;
  signal leftsampler_weight_x_held_3, leftsampler_weight_y_held_0, leftsampler_weight_y_held_1 : natural range 0 to 31;
  signal leftsampler_weight_y_held_2, leftsampler_weight_y_held_3, leftsampler_pixel_left_part : natural range 0 to 31;
  signal leftsampler_pixel_weight_x_held_0, leftsampler_pixel_weight_x_held_1 : natural range 0 to 31;
  signal leftsampler_pixel_weight_x_held_2, leftsampler_pixel_row_part : natural range 0 to 31;
  signal leftsampler_shown_held_0, leftsampler_shown_held_1, leftsampler_shown_held_2 : natural range 0 to 15;
  signal leftsampler_shown_held_3 : natural range 0 to 15;
  signal leftsampler_pixel_left_difference, leftsampler_pixel_right_difference : integer range -255 to 255;
  signal leftsampler_pixel_left_base, leftsampler_pixel_right_base : natural range 0 to 8160;
  signal leftsampler_pixel_left_value, leftsampler_pixel_right_value : natural range 0 to 8191;
  signal leftsampler_pixel_row_from : natural range 0 to 8191;
  signal leftsampler_pixel_row_difference : integer range -8191 to 8191;
  signal leftsampler_pixel_row_base : natural range 0 to 262624;
  signal leftsampler_pixel_row_share : integer range -253921 to 253921;
  -- rightsampler
  signal rightsampler_rows_even_line : natural range 0 to 52;
  signal rightsampler_rows_odd_line : natural range 0 to 51;
  signal rightsampler_rows_even_column, rightsampler_rows_odd_column : natural range 0 to 127;
  signal rightsampler_rows_even_even_read_address, rightsampler_rows_even_odd_read_address : natural range 0 to 127;
  signal rightsampler_rows_odd_even_read_address, rightsampler_rows_odd_odd_read_address : natural range 0 to 127;
  signal rightsampler_rows_written, rightsampler_rows_even_even_write_word : natural range 0 to 255;
  signal rightsampler_rows_even_even_ready_word, rightsampler_rows_even_odd_write_word : natural range 0 to 255;
  signal rightsampler_rows_even_odd_ready_word, rightsampler_rows_odd_even_write_word : natural range 0 to 255;
  signal rightsampler_rows_odd_even_ready_word, rightsampler_rows_odd_odd_write_word : natural range 0 to 255;
  signal rightsampler_rows_odd_odd_ready_word, rightsampler_pixel_left_from : natural range 0 to 255;
  signal rightsampler_pixel_right_from, rightsampler_pixel_row_value : natural range 0 to 255;
  signal rightsampler_rows_even_even_read_word, rightsampler_rows_even_odd_read_word : unsigned(7 downto 0);
  signal rightsampler_rows_odd_even_read_word, rightsampler_rows_odd_odd_read_word : unsigned(7 downto 0);
  signal rightsampler_rows_row_odd_0, rightsampler_rows_row_odd_1, rightsampler_rows_row_odd_2 : boolean;
  signal rightsampler_rows_row_odd_3, rightsampler_rows_column_odd_0, rightsampler_rows_column_odd_1 : boolean;
  signal rightsampler_rows_column_odd_2, rightsampler_rows_column_odd_3 : boolean;
  signal rightsampler_weight_x_held_0, rightsampler_weight_x_held_1 : natural range 0 to 31;
  signal rightsampler_weight_x_held_2, rightsampler_weight_x_held_3 : natural range 0 to 31;
  signal rightsampler_weight_y_held_0, rightsampler_weight_y_held_1 : natural range 0 to 31;
  signal rightsampler_weight_y_held_2, rightsampler_weight_y_held_3 : natural range 0 to 31;
  signal rightsampler_pixel_left_part, rightsampler_pixel_weight_x_held_0 : natural range 0 to 31;
  signal rightsampler_pixel_weight_x_held_1, rightsampler_pixel_weight_x_held_2 : natural range 0 to 31;
  signal rightsampler_pixel_row_part : natural range 0 to 31;
  signal rightsampler_shown_held_0, rightsampler_shown_held_1, rightsampler_shown_held_2 : natural range 0 to 15;
  signal rightsampler_shown_held_3 : natural range 0 to 15;
  signal rightsampler_pixel_left_difference, rightsampler_pixel_right_difference : integer range -255 to 255;
  signal rightsampler_pixel_left_base, rightsampler_pixel_right_base : natural range 0 to 8160;
  signal rightsampler_pixel_left_value, rightsampler_pixel_right_value : natural range 0 to 8191;
  signal rightsampler_pixel_row_from : natural range 0 to 8191;
  signal rightsampler_pixel_row_difference : integer range -8191 to 8191;
  signal rightsampler_pixel_row_base : natural range 0 to 262624;
  signal rightsampler_pixel_row_share : integer range -253921 to 253921;
  -- valid
  signal valid_held_0, valid_held_1, valid_held_2, valid_held_3, valid_held_4, valid_held_5, valid_held_6 : boolean;
  signal valid_held_7, valid_held_8, valid_held_9 : boolean;
  -- starts
  signal starts_held_0, starts_held_1, starts_held_2, starts_held_3, starts_held_4, starts_held_5 : boolean;
  signal starts_held_6, starts_held_7, starts_held_8, starts_held_9 : boolean;
  -- other
  signal other_0, other_1, other_2, other_3, other_6, other_7 : natural range 0 to 262143;
  signal other_4, other_5, other_8, other_9 : natural range 0 to 8191;
  signal leftsampler_rows_even_even_read_word_memory_read_enable : boolean;
  signal leftsampler_rows_even_even_read_word_memory_read_address : unsigned(6 downto 0);
  signal leftsampler_rows_even_even_read_word_memory_write_address : unsigned(6 downto 0);
  signal leftsampler_rows_even_even_read_word_memory_write_data : unsigned(7 downto 0);
  signal leftsampler_rows_even_odd_read_word_memory_read_enable : boolean;
  signal leftsampler_rows_even_odd_read_word_memory_read_address : unsigned(6 downto 0);
  signal leftsampler_rows_even_odd_read_word_memory_write_address : unsigned(6 downto 0);
  signal leftsampler_rows_even_odd_read_word_memory_write_data : unsigned(7 downto 0);
  signal leftsampler_rows_odd_even_read_word_memory_read_enable : boolean;
  signal leftsampler_rows_odd_even_read_word_memory_read_address : unsigned(6 downto 0);
  signal leftsampler_rows_odd_even_read_word_memory_write_address : unsigned(6 downto 0);
  signal leftsampler_rows_odd_even_read_word_memory_write_data : unsigned(7 downto 0);
  signal leftsampler_rows_odd_odd_read_word_memory_read_enable : boolean;
  signal leftsampler_rows_odd_odd_read_word_memory_read_address : unsigned(6 downto 0);
  signal leftsampler_rows_odd_odd_read_word_memory_write_address : unsigned(6 downto 0);
  signal leftsampler_rows_odd_odd_read_word_memory_write_data : unsigned(7 downto 0);
  signal rightsampler_rows_even_even_read_word_memory_read_enable : boolean;
  signal rightsampler_rows_even_even_read_word_memory_read_address : unsigned(6 downto 0);
  signal rightsampler_rows_even_even_read_word_memory_write_address : unsigned(6 downto 0);
  signal rightsampler_rows_even_even_read_word_memory_write_data : unsigned(7 downto 0);
  signal rightsampler_rows_even_odd_read_word_memory_read_enable : boolean;
  signal rightsampler_rows_even_odd_read_word_memory_read_address : unsigned(6 downto 0);
  signal rightsampler_rows_even_odd_read_word_memory_write_address : unsigned(6 downto 0);
  signal rightsampler_rows_even_odd_read_word_memory_write_data : unsigned(7 downto 0);
  signal rightsampler_rows_odd_even_read_word_memory_read_enable : boolean;
  signal rightsampler_rows_odd_even_read_word_memory_read_address : unsigned(6 downto 0);
  signal rightsampler_rows_odd_even_read_word_memory_write_address : unsigned(6 downto 0);
  signal rightsampler_rows_odd_even_read_word_memory_write_data : unsigned(7 downto 0);
  signal rightsampler_rows_odd_odd_read_word_memory_read_enable : boolean;
  signal rightsampler_rows_odd_odd_read_word_memory_read_address : unsigned(6 downto 0);
  signal rightsampler_rows_odd_odd_read_word_memory_write_address : unsigned(6 downto 0);
  signal rightsampler_rows_odd_odd_read_word_memory_write_data : unsigned(7 downto 0);
  signal leftoffsets_nodes_even_even_read_word_memory_read_enable : boolean;
  signal leftoffsets_nodes_even_even_read_word_memory_read_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_even_even_read_word_memory_write_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_even_even_read_word_memory_write_data : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_odd_read_word_memory_read_enable : boolean;
  signal leftoffsets_nodes_even_odd_read_word_memory_read_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_even_odd_read_word_memory_write_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_even_odd_read_word_memory_write_data : unsigned(31 downto 0);
  signal leftoffsets_nodes_odd_even_read_word_memory_read_enable : boolean;
  signal leftoffsets_nodes_odd_even_read_word_memory_read_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_odd_even_read_word_memory_write_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_odd_even_read_word_memory_write_data : unsigned(31 downto 0);
  signal leftoffsets_nodes_odd_odd_read_word_memory_read_enable : boolean;
  signal leftoffsets_nodes_odd_odd_read_word_memory_read_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_odd_odd_read_word_memory_write_address : unsigned(3 downto 0);
  signal leftoffsets_nodes_odd_odd_read_word_memory_write_data : unsigned(31 downto 0);
  signal rightoffsets_nodes_even_even_read_word_memory_read_enable : boolean;
  signal rightoffsets_nodes_even_even_read_word_memory_read_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_even_even_read_word_memory_write_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_even_even_read_word_memory_write_data : unsigned(31 downto 0);
  signal rightoffsets_nodes_even_odd_read_word_memory_read_enable : boolean;
  signal rightoffsets_nodes_even_odd_read_word_memory_read_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_even_odd_read_word_memory_write_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_even_odd_read_word_memory_write_data : unsigned(31 downto 0);
  signal rightoffsets_nodes_odd_even_read_word_memory_read_enable : boolean;
  signal rightoffsets_nodes_odd_even_read_word_memory_read_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_odd_even_read_word_memory_write_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_odd_even_read_word_memory_write_data : unsigned(31 downto 0);
  signal rightoffsets_nodes_odd_odd_read_word_memory_read_enable : boolean;
  signal rightoffsets_nodes_odd_odd_read_word_memory_read_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_odd_odd_read_word_memory_write_address : unsigned(3 downto 0);
  signal rightoffsets_nodes_odd_odd_read_word_memory_write_data : unsigned(31 downto 0);

begin
  in_node_x <= to_integer(unsigned(to_stdlogicvector(to_bitvector(node_x))));
  in_node_y <= to_integer(unsigned(to_stdlogicvector(to_bitvector(node_y))));
  in_node_column <= to_integer(unsigned(to_stdlogicvector(to_bitvector(node_column))));
  in_node_row <= to_integer(unsigned(to_stdlogicvector(to_bitvector(node_row))));
  in_node_valid <= node_valid = '1';
  in_node_right <= node_right = '1';
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  rectified_left <= std_logic_vector(to_unsigned(leftsampler_pixel_row_value, 8));
  rectified_right <= std_logic_vector(to_unsigned(rightsampler_pixel_row_value, 8));
  rectified_start_of_frame <= as_bit(valid_held_9 and starts_held_9);
  rectified_valid <= as_bit(valid_held_9);

  leftsampler_rows_even_even_read_word_memory_read_enable <= true;
  leftsampler_rows_even_even_read_word_memory_read_address <= to_unsigned(leftsampler_rows_even_even_read_address, 7);
  leftsampler_rows_even_even_read_word_memory_write_address <= to_unsigned(leftsampler_rows_even_even_write_address, 7);
  leftsampler_rows_even_even_read_word_memory_write_data <= to_unsigned(leftsampler_rows_even_even_write_word, 8);
  leftsampler_rows_even_even_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => leftsampler_rows_even_even_read_word_memory_read_enable,
      read_address => leftsampler_rows_even_even_read_word_memory_read_address, read_data => leftsampler_rows_even_even_read_word,
      write_address => leftsampler_rows_even_even_read_word_memory_write_address, write_data => leftsampler_rows_even_even_read_word_memory_write_data);

  leftsampler_rows_even_odd_read_word_memory_read_enable <= true;
  leftsampler_rows_even_odd_read_word_memory_read_address <= to_unsigned(leftsampler_rows_even_odd_read_address, 7);
  leftsampler_rows_even_odd_read_word_memory_write_address <= to_unsigned(leftsampler_rows_even_odd_write_address, 7);
  leftsampler_rows_even_odd_read_word_memory_write_data <= to_unsigned(leftsampler_rows_even_odd_write_word, 8);
  leftsampler_rows_even_odd_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => leftsampler_rows_even_odd_read_word_memory_read_enable,
      read_address => leftsampler_rows_even_odd_read_word_memory_read_address, read_data => leftsampler_rows_even_odd_read_word,
      write_address => leftsampler_rows_even_odd_read_word_memory_write_address, write_data => leftsampler_rows_even_odd_read_word_memory_write_data);

  leftsampler_rows_odd_even_read_word_memory_read_enable <= true;
  leftsampler_rows_odd_even_read_word_memory_read_address <= to_unsigned(leftsampler_rows_odd_even_read_address, 7);
  leftsampler_rows_odd_even_read_word_memory_write_address <= to_unsigned(leftsampler_rows_odd_even_write_address, 7);
  leftsampler_rows_odd_even_read_word_memory_write_data <= to_unsigned(leftsampler_rows_odd_even_write_word, 8);
  leftsampler_rows_odd_even_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => leftsampler_rows_odd_even_read_word_memory_read_enable,
      read_address => leftsampler_rows_odd_even_read_word_memory_read_address, read_data => leftsampler_rows_odd_even_read_word,
      write_address => leftsampler_rows_odd_even_read_word_memory_write_address, write_data => leftsampler_rows_odd_even_read_word_memory_write_data);

  leftsampler_rows_odd_odd_read_word_memory_read_enable <= true;
  leftsampler_rows_odd_odd_read_word_memory_read_address <= to_unsigned(leftsampler_rows_odd_odd_read_address, 7);
  leftsampler_rows_odd_odd_read_word_memory_write_address <= to_unsigned(leftsampler_rows_odd_odd_write_address, 7);
  leftsampler_rows_odd_odd_read_word_memory_write_data <= to_unsigned(leftsampler_rows_odd_odd_write_word, 8);
  leftsampler_rows_odd_odd_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => leftsampler_rows_odd_odd_read_word_memory_read_enable,
      read_address => leftsampler_rows_odd_odd_read_word_memory_read_address, read_data => leftsampler_rows_odd_odd_read_word,
      write_address => leftsampler_rows_odd_odd_read_word_memory_write_address, write_data => leftsampler_rows_odd_odd_read_word_memory_write_data);

  rightsampler_rows_even_even_read_word_memory_read_enable <= true;
  rightsampler_rows_even_even_read_word_memory_read_address <= to_unsigned(rightsampler_rows_even_even_read_address, 7);
  rightsampler_rows_even_even_read_word_memory_write_address <= to_unsigned(leftsampler_rows_even_even_write_address, 7);
  rightsampler_rows_even_even_read_word_memory_write_data <= to_unsigned(rightsampler_rows_even_even_write_word, 8);
  rightsampler_rows_even_even_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => rightsampler_rows_even_even_read_word_memory_read_enable,
      read_address => rightsampler_rows_even_even_read_word_memory_read_address, read_data => rightsampler_rows_even_even_read_word,
      write_address => rightsampler_rows_even_even_read_word_memory_write_address, write_data => rightsampler_rows_even_even_read_word_memory_write_data);

  rightsampler_rows_even_odd_read_word_memory_read_enable <= true;
  rightsampler_rows_even_odd_read_word_memory_read_address <= to_unsigned(rightsampler_rows_even_odd_read_address, 7);
  rightsampler_rows_even_odd_read_word_memory_write_address <= to_unsigned(leftsampler_rows_even_odd_write_address, 7);
  rightsampler_rows_even_odd_read_word_memory_write_data <= to_unsigned(rightsampler_rows_even_odd_write_word, 8);
  rightsampler_rows_even_odd_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => rightsampler_rows_even_odd_read_word_memory_read_enable,
      read_address => rightsampler_rows_even_odd_read_word_memory_read_address, read_data => rightsampler_rows_even_odd_read_word,
      write_address => rightsampler_rows_even_odd_read_word_memory_write_address, write_data => rightsampler_rows_even_odd_read_word_memory_write_data);

  rightsampler_rows_odd_even_read_word_memory_read_enable <= true;
  rightsampler_rows_odd_even_read_word_memory_read_address <= to_unsigned(rightsampler_rows_odd_even_read_address, 7);
  rightsampler_rows_odd_even_read_word_memory_write_address <= to_unsigned(leftsampler_rows_odd_even_write_address, 7);
  rightsampler_rows_odd_even_read_word_memory_write_data <= to_unsigned(rightsampler_rows_odd_even_write_word, 8);
  rightsampler_rows_odd_even_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => rightsampler_rows_odd_even_read_word_memory_read_enable,
      read_address => rightsampler_rows_odd_even_read_word_memory_read_address, read_data => rightsampler_rows_odd_even_read_word,
      write_address => rightsampler_rows_odd_even_read_word_memory_write_address, write_data => rightsampler_rows_odd_even_read_word_memory_write_data);

  rightsampler_rows_odd_odd_read_word_memory_read_enable <= true;
  rightsampler_rows_odd_odd_read_word_memory_read_address <= to_unsigned(rightsampler_rows_odd_odd_read_address, 7);
  rightsampler_rows_odd_odd_read_word_memory_write_address <= to_unsigned(leftsampler_rows_odd_odd_write_address, 7);
  rightsampler_rows_odd_odd_read_word_memory_write_data <= to_unsigned(rightsampler_rows_odd_odd_write_word, 8);
  rightsampler_rows_odd_odd_read_word_memory : entity work.line_memory
    generic map (depth => 68, width => 8, address_bits => 7)
    port map (
      clock => clock, read_enable => rightsampler_rows_odd_odd_read_word_memory_read_enable,
      read_address => rightsampler_rows_odd_odd_read_word_memory_read_address, read_data => rightsampler_rows_odd_odd_read_word,
      write_address => rightsampler_rows_odd_odd_read_word_memory_write_address, write_data => rightsampler_rows_odd_odd_read_word_memory_write_data);

  leftoffsets_nodes_even_even_read_word_memory_read_enable <= true;
  leftoffsets_nodes_even_even_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_even_even_read_address, 4);
  leftoffsets_nodes_even_even_read_word_memory_write_address <= to_unsigned(leftoffsets_nodes_even_even_write_address, 4);
  leftoffsets_nodes_even_even_read_word_memory_write_data <= leftoffsets_nodes_even_even_write_word;
  leftoffsets_nodes_even_even_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => leftoffsets_nodes_even_even_read_word_memory_read_enable,
      read_address => leftoffsets_nodes_even_even_read_word_memory_read_address, read_data => leftoffsets_nodes_even_even_read_word,
      write_address => leftoffsets_nodes_even_even_read_word_memory_write_address, write_data => leftoffsets_nodes_even_even_read_word_memory_write_data);

  leftoffsets_nodes_even_odd_read_word_memory_read_enable <= true;
  leftoffsets_nodes_even_odd_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_even_odd_read_address, 4);
  leftoffsets_nodes_even_odd_read_word_memory_write_address <= to_unsigned(leftoffsets_nodes_even_odd_write_address, 4);
  leftoffsets_nodes_even_odd_read_word_memory_write_data <= leftoffsets_nodes_even_odd_write_word;
  leftoffsets_nodes_even_odd_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => leftoffsets_nodes_even_odd_read_word_memory_read_enable,
      read_address => leftoffsets_nodes_even_odd_read_word_memory_read_address, read_data => leftoffsets_nodes_even_odd_read_word,
      write_address => leftoffsets_nodes_even_odd_read_word_memory_write_address, write_data => leftoffsets_nodes_even_odd_read_word_memory_write_data);

  leftoffsets_nodes_odd_even_read_word_memory_read_enable <= true;
  leftoffsets_nodes_odd_even_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_odd_even_read_address, 4);
  leftoffsets_nodes_odd_even_read_word_memory_write_address <= to_unsigned(leftoffsets_nodes_odd_even_write_address, 4);
  leftoffsets_nodes_odd_even_read_word_memory_write_data <= leftoffsets_nodes_odd_even_write_word;
  leftoffsets_nodes_odd_even_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => leftoffsets_nodes_odd_even_read_word_memory_read_enable,
      read_address => leftoffsets_nodes_odd_even_read_word_memory_read_address, read_data => leftoffsets_nodes_odd_even_read_word,
      write_address => leftoffsets_nodes_odd_even_read_word_memory_write_address, write_data => leftoffsets_nodes_odd_even_read_word_memory_write_data);

  leftoffsets_nodes_odd_odd_read_word_memory_read_enable <= true;
  leftoffsets_nodes_odd_odd_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_odd_odd_read_address, 4);
  leftoffsets_nodes_odd_odd_read_word_memory_write_address <= to_unsigned(leftoffsets_nodes_odd_odd_write_address, 4);
  leftoffsets_nodes_odd_odd_read_word_memory_write_data <= leftoffsets_nodes_odd_odd_write_word;
  leftoffsets_nodes_odd_odd_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => leftoffsets_nodes_odd_odd_read_word_memory_read_enable,
      read_address => leftoffsets_nodes_odd_odd_read_word_memory_read_address, read_data => leftoffsets_nodes_odd_odd_read_word,
      write_address => leftoffsets_nodes_odd_odd_read_word_memory_write_address, write_data => leftoffsets_nodes_odd_odd_read_word_memory_write_data);

  rightoffsets_nodes_even_even_read_word_memory_read_enable <= true;
  rightoffsets_nodes_even_even_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_even_even_read_address, 4);
  rightoffsets_nodes_even_even_read_word_memory_write_address <= to_unsigned(rightoffsets_nodes_even_even_write_address, 4);
  rightoffsets_nodes_even_even_read_word_memory_write_data <= rightoffsets_nodes_even_even_write_word;
  rightoffsets_nodes_even_even_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => rightoffsets_nodes_even_even_read_word_memory_read_enable,
      read_address => rightoffsets_nodes_even_even_read_word_memory_read_address, read_data => rightoffsets_nodes_even_even_read_word,
      write_address => rightoffsets_nodes_even_even_read_word_memory_write_address, write_data => rightoffsets_nodes_even_even_read_word_memory_write_data);

  rightoffsets_nodes_even_odd_read_word_memory_read_enable <= true;
  rightoffsets_nodes_even_odd_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_even_odd_read_address, 4);
  rightoffsets_nodes_even_odd_read_word_memory_write_address <= to_unsigned(rightoffsets_nodes_even_odd_write_address, 4);
  rightoffsets_nodes_even_odd_read_word_memory_write_data <= rightoffsets_nodes_even_odd_write_word;
  rightoffsets_nodes_even_odd_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => rightoffsets_nodes_even_odd_read_word_memory_read_enable,
      read_address => rightoffsets_nodes_even_odd_read_word_memory_read_address, read_data => rightoffsets_nodes_even_odd_read_word,
      write_address => rightoffsets_nodes_even_odd_read_word_memory_write_address, write_data => rightoffsets_nodes_even_odd_read_word_memory_write_data);

  rightoffsets_nodes_odd_even_read_word_memory_read_enable <= true;
  rightoffsets_nodes_odd_even_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_odd_even_read_address, 4);
  rightoffsets_nodes_odd_even_read_word_memory_write_address <= to_unsigned(rightoffsets_nodes_odd_even_write_address, 4);
  rightoffsets_nodes_odd_even_read_word_memory_write_data <= rightoffsets_nodes_odd_even_write_word;
  rightoffsets_nodes_odd_even_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => rightoffsets_nodes_odd_even_read_word_memory_read_enable,
      read_address => rightoffsets_nodes_odd_even_read_word_memory_read_address, read_data => rightoffsets_nodes_odd_even_read_word,
      write_address => rightoffsets_nodes_odd_even_read_word_memory_write_address, write_data => rightoffsets_nodes_odd_even_read_word_memory_write_data);

  rightoffsets_nodes_odd_odd_read_word_memory_read_enable <= true;
  rightoffsets_nodes_odd_odd_read_word_memory_read_address <= to_unsigned(leftoffsets_nodes_odd_odd_read_address, 4);
  rightoffsets_nodes_odd_odd_read_word_memory_write_address <= to_unsigned(rightoffsets_nodes_odd_odd_write_address, 4);
  rightoffsets_nodes_odd_odd_read_word_memory_write_data <= rightoffsets_nodes_odd_odd_write_word;
  rightoffsets_nodes_odd_odd_read_word_memory : entity work.line_memory
    generic map (depth => 10, width => 32, address_bits => 4)
    port map (
      clock => clock, read_enable => rightoffsets_nodes_odd_odd_read_word_memory_read_enable,
      read_address => rightoffsets_nodes_odd_odd_read_word_memory_read_address, read_data => rightoffsets_nodes_odd_odd_read_word,
      write_address => rightoffsets_nodes_odd_odd_read_word_memory_write_address, write_data => rightoffsets_nodes_odd_odd_read_word_memory_write_data);

  process (clock)
    variable counter_column_is_equal, counter_next_frame_differs, counter_next_frame_is_equal : boolean;
    variable counter_next_frame_is_equal_2, counter_next_frame_all, counter_next_frame_choice : boolean;
    variable grid_node_row_all, sample_place_column_is_equal, sample_place_next_frame_differs : boolean;
    variable sample_place_next_frame_is_equal, sample_place_next_frame_is_equal_2 : boolean;
    variable sample_place_next_frame_all, sample_place_next_frame_choice, lefttaps_taps_column_is_equal : boolean;
    variable righttaps_taps_column_is_equal : boolean;
    variable counter_group_choice, sample_place_group_choice, lefttaps_taps_row_value : natural range 0 to 3;
    variable righttaps_taps_row_value, leftsampler_shown_held_0_choice : natural range 0 to 3;
    variable rightsampler_shown_held_0_choice : natural range 0 to 3;
    variable counter_group_choice_2, counter_group_choice_3, sample_place_group_choice_2 : natural range 0 to 31;
    variable sample_place_group_choice_3 : natural range 0 to 31;
    variable grid_node_row_choice, leftoffsets_nodes_even_even_write_address_value : natural range 0 to 15;
    variable leftoffsets_nodes_even_line_value : natural range 0 to 2;
    variable leftoffsets_x_left_from_choice, leftoffsets_x_left_from_choice_2 : natural range 0 to 65535;
    variable leftoffsets_x_left_from_choice_3, leftoffsets_x_left_difference_choice : natural range 0 to 65535;
    variable leftoffsets_x_right_from_choice, leftoffsets_x_right_from_choice_2 : natural range 0 to 65535;
    variable leftoffsets_x_right_from_choice_3, leftoffsets_x_right_difference_choice : natural range 0 to 65535;
    variable rightoffsets_x_left_from_choice, rightoffsets_x_left_from_choice_2 : natural range 0 to 65535;
    variable rightoffsets_x_left_from_choice_3, rightoffsets_x_left_difference_choice : natural range 0 to 65535;
    variable rightoffsets_x_right_from_choice, rightoffsets_x_right_from_choice_2 : natural range 0 to 65535;
    variable rightoffsets_x_right_from_choice_3, rightoffsets_x_right_difference_choice : natural range 0 to 65535;
    variable lefttaps_taps_row_sum, righttaps_taps_row_sum : natural range 0 to 65535;
    variable leftoffsets_y_left_from_choice, leftoffsets_y_left_from_choice_2 : unsigned(31 downto 0);
    variable leftoffsets_y_left_from_choice_3, leftoffsets_y_left_difference_choice : unsigned(31 downto 0);
    variable leftoffsets_y_right_from_choice, leftoffsets_y_right_from_choice_2 : unsigned(31 downto 0);
    variable leftoffsets_y_right_from_choice_3, leftoffsets_y_right_difference_choice : unsigned(31 downto 0);
    variable rightoffsets_y_left_from_choice, rightoffsets_y_left_from_choice_2 : unsigned(31 downto 0);
    variable rightoffsets_y_left_from_choice_3, rightoffsets_y_left_difference_choice : unsigned(31 downto 0);
    variable rightoffsets_y_right_from_choice, rightoffsets_y_right_from_choice_2 : unsigned(31 downto 0);
    variable rightoffsets_y_right_from_choice_3, rightoffsets_y_right_difference_choice : unsigned(31 downto 0);
    variable sample_place_column_sum : natural range 1 to 32;
    variable lefttaps_taps_row_choice, righttaps_taps_row_choice : natural range 0 to 7;
    variable leftsampler_rows_even_line_value, rightsampler_rows_even_line_value : natural range 0 to 4;
    variable leftsampler_pixel_left_from_choice, leftsampler_pixel_left_from_choice_2 : natural range 0 to 255;
    variable leftsampler_pixel_left_from_choice_3, leftsampler_pixel_left_from_choice_4 : natural range 0 to 255;
    variable leftsampler_pixel_left_difference_choice : natural range 0 to 255;
    variable leftsampler_pixel_left_difference_choice_2, leftsampler_pixel_right_from_choice : natural range 0 to 255;
    variable leftsampler_pixel_right_from_choice_2, leftsampler_pixel_right_from_choice_3 : natural range 0 to 255;
    variable leftsampler_pixel_right_from_choice_4, leftsampler_pixel_right_difference_choice : natural range 0 to 255;
    variable leftsampler_pixel_right_difference_choice_2, rightsampler_pixel_left_from_choice : natural range 0 to 255;
    variable rightsampler_pixel_left_from_choice_2, rightsampler_pixel_left_from_choice_3 : natural range 0 to 255;
    variable rightsampler_pixel_left_from_choice_4, rightsampler_pixel_left_difference_choice : natural range 0 to 255;
    variable rightsampler_pixel_left_difference_choice_2, rightsampler_pixel_right_from_choice : natural range 0 to 255;
    variable rightsampler_pixel_right_from_choice_2, rightsampler_pixel_right_from_choice_3 : natural range 0 to 255;
    variable rightsampler_pixel_right_from_choice_4 : natural range 0 to 255;
    variable rightsampler_pixel_right_difference_choice : natural range 0 to 255;
    variable rightsampler_pixel_right_difference_choice_2 : natural range 0 to 255;
    variable leftsampler_rows_even_even_write_address_sum : natural range 0 to 67;
  begin
    if rising_edge(clock) then
      -- counter
      counter_column_is_equal := counter_column = 31;
      counter_next_frame_differs := counter_group /= 16;
      counter_next_frame_is_equal := counter_group = 15;
      counter_next_frame_is_equal_2 := counter_group = 11;
      counter_next_frame_all := counter_column_is_equal and counter_next_frame_is_equal_2;
      if in_start_of_frame then
        counter_next_frame_choice := counter_next_frame_all;
      else
        counter_next_frame_choice := counter_next_frame;
      end if;
      if in_valid then
        if counter_column_is_equal or in_start_of_frame then
          counter_column <= 0;
        else
          counter_column <= (counter_column + 1) mod 32;
        end if;
        if counter_column_is_equal and counter_next_frame_differs and counter_next_frame_is_equal then
          counter_next_frame <= counter_column_is_equal and counter_next_frame_is_equal_2 and in_start_of_frame;
        else
          counter_next_frame <= counter_next_frame_choice;
        end if;
      end if;
      if counter_next_frame_all then
        counter_group_choice := 3;
      else
        counter_group_choice := 0;
      end if;
      if counter_next_frame and counter_next_frame_is_equal then
        counter_group_choice_2 := 4;
      else
        counter_group_choice_2 := (counter_group + 1) mod 32;
      end if;
      if counter_column_is_equal and counter_next_frame_differs and in_valid then
        counter_group_choice_3 := counter_group_choice_2;
      else
        counter_group_choice_3 := counter_group;
      end if;
      if in_start_of_frame and in_valid then
        counter_group <= counter_group_choice * 4;
      else
        counter_group <= counter_group_choice_3;
      end if;
      -- delay
      delay_held_0_left <= in_left_pixel;
      delay_held_0_right <= in_right_pixel;
      delay_held_0_start_of_frame <= in_start_of_frame;
      delay_held_0_valid <= in_valid;
      delay_held_1_left <= delay_held_0_left;
      delay_held_1_right <= delay_held_0_right;
      delay_held_1_start_of_frame <= delay_held_0_start_of_frame;
      delay_held_1_valid <= delay_held_0_valid;
      delay_held_2_left <= delay_held_1_left;
      delay_held_2_right <= delay_held_1_right;
      delay_held_2_start_of_frame <= delay_held_1_start_of_frame;
      delay_held_2_valid <= delay_held_1_valid;
      delay_held_3_left <= delay_held_2_left;
      delay_held_3_right <= delay_held_2_right;
      delay_held_3_start_of_frame <= delay_held_2_start_of_frame;
      delay_held_3_valid <= delay_held_2_valid;
      delay_held_4_left <= delay_held_3_left;
      delay_held_4_right <= delay_held_3_right;
      delay_held_4_start_of_frame <= delay_held_3_start_of_frame;
      delay_held_4_valid <= delay_held_3_valid;
      delay_held_5_left <= delay_held_4_left;
      delay_held_5_right <= delay_held_4_right;
      delay_held_5_start_of_frame <= delay_held_4_start_of_frame;
      delay_held_5_valid <= delay_held_4_valid;
      delay_held_6_left <= delay_held_5_left;
      delay_held_6_right <= delay_held_5_right;
      delay_held_6_start_of_frame <= delay_held_5_start_of_frame;
      delay_held_6_valid <= delay_held_5_valid;
      delay_held_7_left <= delay_held_6_left;
      delay_held_7_right <= delay_held_6_right;
      delay_held_7_start_of_frame <= delay_held_6_start_of_frame;
      delay_held_7_valid <= delay_held_6_valid;
      delay_held_8_left <= delay_held_7_left;
      delay_held_8_right <= delay_held_7_right;
      delay_held_8_start_of_frame <= delay_held_7_start_of_frame;
      delay_held_8_valid <= delay_held_7_valid;
      delay_held_9_left <= delay_held_8_left;
      delay_held_9_right <= delay_held_8_right;
      delay_held_9_start_of_frame <= delay_held_8_start_of_frame;
      delay_held_9_valid <= delay_held_8_valid;
      delay_held_10_left <= delay_held_9_left;
      delay_held_10_right <= delay_held_9_right;
      delay_held_10_start_of_frame <= delay_held_9_start_of_frame;
      delay_held_10_valid <= delay_held_9_valid;
      -- grid
      grid_node_row_all := counter_next_frame_differs and (((counter_group / 16) = 1) or (((counter_group / 8) mod 2) =
        1) or (((counter_group / 4) mod 2) = 1));
      if grid_node_row_all then
        grid_node_row_choice := ((((counter_group / 4) + 3) mod 4) * 4) + (counter_group mod 4);
      else
        grid_node_row_choice := 0;
      end if;
      grid_node_column <= counter_column / 4;
      grid_node_row <= grid_node_row_choice / 4;
      grid_weight_x_held_0 <= counter_column mod 4;
      grid_weight_x_held_1 <= grid_weight_x_held_0;
      grid_weight_x_held_2 <= grid_weight_x_held_1;
      grid_weight_x_held_3 <= grid_weight_x_held_2;
      grid_weight_x_held_4 <= grid_weight_x_held_3;
      grid_weight_y_held_1 <= grid_weight_y_held_0;
      grid_weight_y_held_2 <= grid_weight_y_held_1;
      grid_weight_y_held_3 <= grid_weight_y_held_2;
      grid_weight_y_held_4 <= grid_weight_y_held_3;
      if grid_node_row_all then
        grid_weight_y_held_0 <= counter_group mod 4;
      else
        grid_weight_y_held_0 <= 0;
      end if;
      -- leftoffsets
      leftoffsets_nodes_even_line_value := (grid_node_row + 1) / 2;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_x_left_from_choice := to_integer(leftoffsets_nodes_odd_odd_ready_word(15 downto 0));
      else
        leftoffsets_x_left_from_choice := to_integer(leftoffsets_nodes_odd_even_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_x_left_from_choice_2 := to_integer(leftoffsets_nodes_even_odd_ready_word(15 downto 0));
      else
        leftoffsets_x_left_from_choice_2 := to_integer(leftoffsets_nodes_even_even_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_x_left_from_choice_3 := leftoffsets_x_left_from_choice;
      else
        leftoffsets_x_left_from_choice_3 := leftoffsets_x_left_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_x_left_difference_choice := leftoffsets_x_left_from_choice_2;
      else
        leftoffsets_x_left_difference_choice := leftoffsets_x_left_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_x_right_from_choice := to_integer(leftoffsets_nodes_odd_even_ready_word(15 downto 0));
      else
        leftoffsets_x_right_from_choice := to_integer(leftoffsets_nodes_odd_odd_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_x_right_from_choice_2 := to_integer(leftoffsets_nodes_even_even_ready_word(15 downto 0));
      else
        leftoffsets_x_right_from_choice_2 := to_integer(leftoffsets_nodes_even_odd_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_x_right_from_choice_3 := leftoffsets_x_right_from_choice;
      else
        leftoffsets_x_right_from_choice_3 := leftoffsets_x_right_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_x_right_difference_choice := leftoffsets_x_right_from_choice_2;
      else
        leftoffsets_x_right_difference_choice := leftoffsets_x_right_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_y_left_from_choice := leftoffsets_nodes_odd_odd_ready_word;
      else
        leftoffsets_y_left_from_choice := leftoffsets_nodes_odd_even_ready_word;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_y_left_from_choice_2 := leftoffsets_nodes_even_odd_ready_word;
      else
        leftoffsets_y_left_from_choice_2 := leftoffsets_nodes_even_even_ready_word;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_y_left_from_choice_3 := leftoffsets_y_left_from_choice;
      else
        leftoffsets_y_left_from_choice_3 := leftoffsets_y_left_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_y_left_difference_choice := leftoffsets_y_left_from_choice_2;
      else
        leftoffsets_y_left_difference_choice := leftoffsets_y_left_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_y_right_from_choice := leftoffsets_nodes_odd_even_ready_word;
      else
        leftoffsets_y_right_from_choice := leftoffsets_nodes_odd_odd_ready_word;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        leftoffsets_y_right_from_choice_2 := leftoffsets_nodes_even_even_ready_word;
      else
        leftoffsets_y_right_from_choice_2 := leftoffsets_nodes_even_odd_ready_word;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_y_right_from_choice_3 := leftoffsets_y_right_from_choice;
      else
        leftoffsets_y_right_from_choice_3 := leftoffsets_y_right_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        leftoffsets_y_right_difference_choice := leftoffsets_y_right_from_choice_2;
      else
        leftoffsets_y_right_difference_choice := leftoffsets_y_right_from_choice;
      end if;
      leftoffsets_nodes_odd_line <= ((grid_node_row / 2) * 4) + (grid_node_row / 2);
      leftoffsets_nodes_write_line <= ((((in_node_row / 2) + (in_node_row / 8)) mod 2) * 4) + ((in_node_row / 2) mod 4);
      leftoffsets_nodes_even_column <= (grid_node_column + 1) / 2;
      leftoffsets_nodes_odd_column <= grid_node_column / 2;
      leftoffsets_nodes_write_column <= (in_node_column mod 32) / 2;
      leftoffsets_nodes_to_even_even <= (not ((in_node_column mod 2) = 1)) and (not ((in_node_row mod 2) = 1)) and
        in_node_valid and (not in_node_right);
      leftoffsets_nodes_to_even_odd <= ((in_node_column mod 2) = 1) and (not ((in_node_row mod 2) = 1)) and
        in_node_valid and (not in_node_right);
      leftoffsets_nodes_to_odd_even <= (not ((in_node_column mod 2) = 1)) and ((in_node_row mod 2) = 1) and
        in_node_valid and (not in_node_right);
      leftoffsets_nodes_to_odd_odd <= ((in_node_column mod 2) = 1) and ((in_node_row mod 2) = 1) and in_node_valid and
        (not in_node_right);
      leftoffsets_nodes_written <= to_unsigned(to_integer(((to_unsigned(in_node_y, 16)) xor (to_unsigned(32768, 16)))),
        16) & to_unsigned(to_integer(((to_unsigned(in_node_x, 16)) xor (to_unsigned(32768, 16)))), 16);
      leftoffsets_nodes_even_even_read_address <= leftoffsets_nodes_even_line + leftoffsets_nodes_even_column;
      leftoffsets_nodes_even_even_ready_word <= leftoffsets_nodes_even_even_read_word;
      leftoffsets_nodes_even_odd_read_address <= leftoffsets_nodes_even_line + leftoffsets_nodes_odd_column;
      leftoffsets_nodes_even_odd_ready_word <= leftoffsets_nodes_even_odd_read_word;
      leftoffsets_nodes_odd_even_read_address <= leftoffsets_nodes_odd_line + leftoffsets_nodes_even_column;
      leftoffsets_nodes_odd_even_ready_word <= leftoffsets_nodes_odd_even_read_word;
      leftoffsets_nodes_odd_odd_read_address <= leftoffsets_nodes_odd_line + leftoffsets_nodes_odd_column;
      leftoffsets_nodes_odd_odd_ready_word <= leftoffsets_nodes_odd_odd_read_word;
      leftoffsets_nodes_row_odd_0 <= (grid_node_row mod 2) = 1;
      leftoffsets_nodes_row_odd_1 <= leftoffsets_nodes_row_odd_0;
      leftoffsets_nodes_row_odd_2 <= leftoffsets_nodes_row_odd_1;
      leftoffsets_nodes_row_odd_3 <= leftoffsets_nodes_row_odd_2;
      leftoffsets_nodes_column_odd_0 <= (grid_node_column mod 2) = 1;
      leftoffsets_nodes_column_odd_1 <= leftoffsets_nodes_column_odd_0;
      leftoffsets_nodes_column_odd_2 <= leftoffsets_nodes_column_odd_1;
      leftoffsets_nodes_column_odd_3 <= leftoffsets_nodes_column_odd_2;
      leftoffsets_x_left_from <= leftoffsets_x_left_from_choice_3;
      leftoffsets_x_left_difference <= leftoffsets_x_left_difference_choice - leftoffsets_x_left_from_choice_3;
      leftoffsets_x_left_part <= grid_weight_y_held_4;
      leftoffsets_x_left_base <= leftoffsets_x_left_from * 4;
      leftoffsets_x_left_value <= ((((leftoffsets_x_left_base / 4) + (other_7 / 4)) mod 65536) * 4) + (other_7 mod 4);
      leftoffsets_x_right_from <= leftoffsets_x_right_from_choice_3;
      leftoffsets_x_right_difference <= leftoffsets_x_right_difference_choice - leftoffsets_x_right_from_choice_3;
      leftoffsets_x_right_base <= leftoffsets_x_right_from * 4;
      leftoffsets_x_right_value <= ((((leftoffsets_x_right_base / 4) + (other_6 / 4)) mod 65536) * 4) + (other_6 mod 4);
      leftoffsets_x_weight_x_held_0 <= grid_weight_x_held_4;
      leftoffsets_x_weight_x_held_1 <= leftoffsets_x_weight_x_held_0;
      leftoffsets_x_weight_x_held_2 <= leftoffsets_x_weight_x_held_1;
      leftoffsets_x_row_from <= leftoffsets_x_left_value;
      leftoffsets_x_row_difference <= leftoffsets_x_right_value - leftoffsets_x_left_value;
      leftoffsets_x_row_part <= leftoffsets_x_weight_x_held_2;
      leftoffsets_x_row_base <= ((((leftoffsets_x_row_from * 4) / 16) + 1) * 16) + ((leftoffsets_x_row_from mod 4) * 4);
      leftoffsets_x_row_share <= leftoffsets_x_row_difference * leftoffsets_x_row_part;
      leftoffsets_x_row_value <= ((((leftoffsets_x_row_base / 4) + ((leftoffsets_x_row_share mod 2097152) / 4)) mod
        524288) * 4) / 32;
      leftoffsets_y_left_from <= to_integer(leftoffsets_y_left_from_choice_3(31 downto 16));
      leftoffsets_y_left_difference <= to_integer(leftoffsets_y_left_difference_choice(31 downto 16)) -
        to_integer(leftoffsets_y_left_from_choice_3(31 downto 16));
      leftoffsets_y_left_base <= leftoffsets_y_left_from * 4;
      leftoffsets_y_left_share <= (((leftoffsets_y_left_difference * leftoffsets_x_left_part) + 131072) mod 262144) -
        131072;
      leftoffsets_y_left_value <= ((((leftoffsets_y_left_base / 4) + ((leftoffsets_y_left_share mod 262144) / 4)) mod
        65536) * 4) + (leftoffsets_y_left_share mod 4);
      leftoffsets_y_right_from <= to_integer(leftoffsets_y_right_from_choice_3(31 downto 16));
      leftoffsets_y_right_difference <= to_integer(leftoffsets_y_right_difference_choice(31 downto 16)) -
        to_integer(leftoffsets_y_right_from_choice_3(31 downto 16));
      leftoffsets_y_right_base <= leftoffsets_y_right_from * 4;
      leftoffsets_y_right_share <= (((leftoffsets_y_right_difference * leftoffsets_x_left_part) + 131072) mod 262144) -
        131072;
      leftoffsets_y_right_value <= ((((leftoffsets_y_right_base / 4) + ((leftoffsets_y_right_share mod 262144) / 4))
        mod 65536) * 4) + (leftoffsets_y_right_share mod 4);
      leftoffsets_y_row_from <= leftoffsets_y_left_value;
      leftoffsets_y_row_difference <= leftoffsets_y_right_value - leftoffsets_y_left_value;
      leftoffsets_y_row_base <= ((((leftoffsets_y_row_from * 4) / 16) + 1) * 16) + ((leftoffsets_y_row_from mod 4) * 4);
      leftoffsets_y_row_share <= leftoffsets_y_row_difference * leftoffsets_x_row_part;
      leftoffsets_y_row_value <= ((((leftoffsets_y_row_base / 4) + ((leftoffsets_y_row_share mod 2097152) / 4)) mod
        524288) * 4) / 32;
      if grid_node_row = 3 then
        leftoffsets_nodes_even_line <= 0;
      else
        leftoffsets_nodes_even_line <= ((leftoffsets_nodes_even_line_value mod 2) * 4) +
          leftoffsets_nodes_even_line_value;
      end if;
      leftoffsets_nodes_even_even_write_address_value := (leftoffsets_nodes_write_line +
        leftoffsets_nodes_write_column) mod 16;
      if leftoffsets_nodes_to_even_even then
        leftoffsets_nodes_even_even_write_address <= leftoffsets_nodes_even_even_write_address_value;
        leftoffsets_nodes_even_even_write_word <= leftoffsets_nodes_written;
      end if;
      if leftoffsets_nodes_to_even_odd then
        leftoffsets_nodes_even_odd_write_address <= leftoffsets_nodes_even_even_write_address_value;
        leftoffsets_nodes_even_odd_write_word <= leftoffsets_nodes_written;
      end if;
      if leftoffsets_nodes_to_odd_even then
        leftoffsets_nodes_odd_even_write_address <= leftoffsets_nodes_even_even_write_address_value;
        leftoffsets_nodes_odd_even_write_word <= leftoffsets_nodes_written;
      end if;
      if leftoffsets_nodes_to_odd_odd then
        leftoffsets_nodes_odd_odd_write_address <= leftoffsets_nodes_even_even_write_address_value;
        leftoffsets_nodes_odd_odd_write_word <= leftoffsets_nodes_written;
      end if;
      -- rightoffsets
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_x_left_from_choice := to_integer(rightoffsets_nodes_odd_odd_ready_word(15 downto 0));
      else
        rightoffsets_x_left_from_choice := to_integer(rightoffsets_nodes_odd_even_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_x_left_from_choice_2 := to_integer(rightoffsets_nodes_even_odd_ready_word(15 downto 0));
      else
        rightoffsets_x_left_from_choice_2 := to_integer(rightoffsets_nodes_even_even_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_x_left_from_choice_3 := rightoffsets_x_left_from_choice;
      else
        rightoffsets_x_left_from_choice_3 := rightoffsets_x_left_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_x_left_difference_choice := rightoffsets_x_left_from_choice_2;
      else
        rightoffsets_x_left_difference_choice := rightoffsets_x_left_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_x_right_from_choice := to_integer(rightoffsets_nodes_odd_even_ready_word(15 downto 0));
      else
        rightoffsets_x_right_from_choice := to_integer(rightoffsets_nodes_odd_odd_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_x_right_from_choice_2 := to_integer(rightoffsets_nodes_even_even_ready_word(15 downto 0));
      else
        rightoffsets_x_right_from_choice_2 := to_integer(rightoffsets_nodes_even_odd_ready_word(15 downto 0));
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_x_right_from_choice_3 := rightoffsets_x_right_from_choice;
      else
        rightoffsets_x_right_from_choice_3 := rightoffsets_x_right_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_x_right_difference_choice := rightoffsets_x_right_from_choice_2;
      else
        rightoffsets_x_right_difference_choice := rightoffsets_x_right_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_y_left_from_choice := rightoffsets_nodes_odd_odd_ready_word;
      else
        rightoffsets_y_left_from_choice := rightoffsets_nodes_odd_even_ready_word;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_y_left_from_choice_2 := rightoffsets_nodes_even_odd_ready_word;
      else
        rightoffsets_y_left_from_choice_2 := rightoffsets_nodes_even_even_ready_word;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_y_left_from_choice_3 := rightoffsets_y_left_from_choice;
      else
        rightoffsets_y_left_from_choice_3 := rightoffsets_y_left_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_y_left_difference_choice := rightoffsets_y_left_from_choice_2;
      else
        rightoffsets_y_left_difference_choice := rightoffsets_y_left_from_choice;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_y_right_from_choice := rightoffsets_nodes_odd_even_ready_word;
      else
        rightoffsets_y_right_from_choice := rightoffsets_nodes_odd_odd_ready_word;
      end if;
      if leftoffsets_nodes_column_odd_3 then
        rightoffsets_y_right_from_choice_2 := rightoffsets_nodes_even_even_ready_word;
      else
        rightoffsets_y_right_from_choice_2 := rightoffsets_nodes_even_odd_ready_word;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_y_right_from_choice_3 := rightoffsets_y_right_from_choice;
      else
        rightoffsets_y_right_from_choice_3 := rightoffsets_y_right_from_choice_2;
      end if;
      if leftoffsets_nodes_row_odd_3 then
        rightoffsets_y_right_difference_choice := rightoffsets_y_right_from_choice_2;
      else
        rightoffsets_y_right_difference_choice := rightoffsets_y_right_from_choice;
      end if;
      rightoffsets_nodes_to_even_even <= (not ((in_node_column mod 2) = 1)) and (not ((in_node_row mod 2) = 1)) and
        in_node_valid and in_node_right;
      rightoffsets_nodes_to_even_odd <= ((in_node_column mod 2) = 1) and (not ((in_node_row mod 2) = 1)) and
        in_node_valid and in_node_right;
      rightoffsets_nodes_to_odd_even <= (not ((in_node_column mod 2) = 1)) and ((in_node_row mod 2) = 1) and
        in_node_valid and in_node_right;
      rightoffsets_nodes_to_odd_odd <= ((in_node_column mod 2) = 1) and ((in_node_row mod 2) = 1) and in_node_valid and
        in_node_right;
      rightoffsets_nodes_even_even_ready_word <= rightoffsets_nodes_even_even_read_word;
      rightoffsets_nodes_even_odd_ready_word <= rightoffsets_nodes_even_odd_read_word;
      rightoffsets_nodes_odd_even_ready_word <= rightoffsets_nodes_odd_even_read_word;
      rightoffsets_nodes_odd_odd_ready_word <= rightoffsets_nodes_odd_odd_read_word;
      rightoffsets_x_left_from <= rightoffsets_x_left_from_choice_3;
      rightoffsets_x_left_difference <= rightoffsets_x_left_difference_choice - rightoffsets_x_left_from_choice_3;
      rightoffsets_x_left_base <= rightoffsets_x_left_from * 4;
      rightoffsets_x_left_value <= ((((rightoffsets_x_left_base / 4) + (other_3 / 4)) mod 65536) * 4) + (other_3 mod 4);
      rightoffsets_x_right_from <= rightoffsets_x_right_from_choice_3;
      rightoffsets_x_right_difference <= rightoffsets_x_right_difference_choice - rightoffsets_x_right_from_choice_3;
      rightoffsets_x_right_base <= rightoffsets_x_right_from * 4;
      rightoffsets_x_right_value <= ((((rightoffsets_x_right_base / 4) + (other_2 / 4)) mod 65536) * 4) + (other_2 mod
        4);
      rightoffsets_x_row_from <= rightoffsets_x_left_value;
      rightoffsets_x_row_difference <= rightoffsets_x_right_value - rightoffsets_x_left_value;
      rightoffsets_x_row_base <= ((((rightoffsets_x_row_from * 4) / 16) + 1) * 16) + ((rightoffsets_x_row_from mod 4) *
        4);
      rightoffsets_x_row_share <= rightoffsets_x_row_difference * leftoffsets_x_row_part;
      rightoffsets_x_row_value <= ((((rightoffsets_x_row_base / 4) + ((rightoffsets_x_row_share mod 2097152) / 4)) mod
        524288) * 4) / 32;
      rightoffsets_y_left_from <= to_integer(rightoffsets_y_left_from_choice_3(31 downto 16));
      rightoffsets_y_left_difference <= to_integer(rightoffsets_y_left_difference_choice(31 downto 16)) -
        to_integer(rightoffsets_y_left_from_choice_3(31 downto 16));
      rightoffsets_y_left_base <= rightoffsets_y_left_from * 4;
      rightoffsets_y_left_value <= ((((rightoffsets_y_left_base / 4) + (other_1 / 4)) mod 65536) * 4) + (other_1 mod 4);
      rightoffsets_y_right_from <= to_integer(rightoffsets_y_right_from_choice_3(31 downto 16));
      rightoffsets_y_right_difference <= to_integer(rightoffsets_y_right_difference_choice(31 downto 16)) -
        to_integer(rightoffsets_y_right_from_choice_3(31 downto 16));
      rightoffsets_y_right_base <= rightoffsets_y_right_from * 4;
      rightoffsets_y_right_value <= ((((rightoffsets_y_right_base / 4) + (other_0 / 4)) mod 65536) * 4) + (other_0 mod
        4);
      rightoffsets_y_row_from <= rightoffsets_y_left_value;
      rightoffsets_y_row_difference <= rightoffsets_y_right_value - rightoffsets_y_left_value;
      rightoffsets_y_row_base <= ((((rightoffsets_y_row_from * 4) / 16) + 1) * 16) + ((rightoffsets_y_row_from mod 4) *
        4);
      rightoffsets_y_row_share <= rightoffsets_y_row_difference * leftoffsets_x_row_part;
      rightoffsets_y_row_value <= ((((rightoffsets_y_row_base / 4) + ((rightoffsets_y_row_share mod 2097152) / 4)) mod
        524288) * 4) / 32;
      if rightoffsets_nodes_to_even_even then
        rightoffsets_nodes_even_even_write_address <= leftoffsets_nodes_even_even_write_address_value;
        rightoffsets_nodes_even_even_write_word <= leftoffsets_nodes_written;
      end if;
      if rightoffsets_nodes_to_even_odd then
        rightoffsets_nodes_even_odd_write_address <= leftoffsets_nodes_even_even_write_address_value;
        rightoffsets_nodes_even_odd_write_word <= leftoffsets_nodes_written;
      end if;
      if rightoffsets_nodes_to_odd_even then
        rightoffsets_nodes_odd_even_write_address <= leftoffsets_nodes_even_even_write_address_value;
        rightoffsets_nodes_odd_even_write_word <= leftoffsets_nodes_written;
      end if;
      if rightoffsets_nodes_to_odd_odd then
        rightoffsets_nodes_odd_odd_write_address <= leftoffsets_nodes_even_even_write_address_value;
        rightoffsets_nodes_odd_odd_write_word <= leftoffsets_nodes_written;
      end if;
      -- sample
      sample_place_column_is_equal := sample_place_column = 31;
      sample_place_column_sum := sample_place_column + 1;
      sample_place_next_frame_differs := sample_place_group /= 16;
      sample_place_next_frame_is_equal := sample_place_group = 15;
      sample_place_next_frame_is_equal_2 := sample_place_group = 11;
      sample_place_next_frame_all := sample_place_column_is_equal and sample_place_next_frame_is_equal_2;
      if delay_held_10_start_of_frame then
        sample_place_next_frame_choice := sample_place_next_frame_all;
      else
        sample_place_next_frame_choice := sample_place_next_frame;
      end if;
      if delay_held_10_valid then
        if sample_place_column_is_equal or delay_held_10_start_of_frame then
          sample_place_column <= 0;
        else
          sample_place_column <= sample_place_column_sum mod 32;
        end if;
        if sample_place_column_is_equal and sample_place_next_frame_differs and sample_place_next_frame_is_equal then
          sample_place_next_frame <= sample_place_column_is_equal and sample_place_next_frame_is_equal_2 and
            delay_held_10_start_of_frame;
        else
          sample_place_next_frame <= sample_place_next_frame_choice;
        end if;
      end if;
      if sample_place_next_frame_all then
        sample_place_group_choice := 3;
      else
        sample_place_group_choice := 0;
      end if;
      if sample_place_next_frame and sample_place_next_frame_is_equal then
        sample_place_group_choice_2 := 4;
      else
        sample_place_group_choice_2 := (sample_place_group + 1) mod 32;
      end if;
      if sample_place_column_is_equal and sample_place_next_frame_differs and delay_held_10_valid then
        sample_place_group_choice_3 := sample_place_group_choice_2;
      else
        sample_place_group_choice_3 := sample_place_group;
      end if;
      sample_pixels_left <= delay_held_10_left;
      sample_pixels_right <= delay_held_10_right;
      sample_pixels_valid <= delay_held_10_valid;
      sample_row <= ((((sample_place_group / 4) + 3) mod 4) * 4) + (sample_place_group mod 4);
      sample_leaves <= sample_place_next_frame_differs and (((sample_place_group / 16) = 1) or (((sample_place_group /
        8) mod 2) = 1) or (((sample_place_group / 4) mod 2) = 1));
      sample_starts <= (sample_place_column = 0) and (sample_place_group = 4);
      sample_taken_column <= sample_place_column_sum;
      sample_taken_row <= sample_slot;
      sample_taken_pixels_left <= sample_pixels_left;
      sample_taken_pixels_right <= sample_pixels_right;
      sample_taken_pixels_valid <= sample_pixels_valid;
      sample_kept_column <= sample_taken_column;
      sample_kept_row <= sample_taken_row;
      sample_kept_pixels_left <= sample_taken_pixels_left;
      sample_kept_pixels_right <= sample_taken_pixels_right;
      sample_kept_pixels_valid <= sample_taken_pixels_valid;
      sample_kept_starts <= sample_starts;
      if delay_held_10_start_of_frame and delay_held_10_valid then
        sample_place_group <= sample_place_group_choice * 4;
      else
        sample_place_group <= sample_place_group_choice_3;
      end if;
      if sample_place_column_is_equal and delay_held_10_valid then
        if sample_slot = 7 then
          sample_slot <= 0;
        else
          sample_slot <= (sample_slot + 1) mod 8;
        end if;
      end if;
      -- lefttaps
      lefttaps_taps_column_is_equal := (lefttaps_source_x / 1024) = 16;
      lefttaps_taps_row_value := (lefttaps_offset_y / 32) mod 4;
      lefttaps_taps_row_sum := ((((lefttaps_offset_y / 128) + 16257) mod 16384) * 4) + lefttaps_taps_row_value;
      if lefttaps_taps_row_sum < 8 then
        lefttaps_taps_row_choice := ((((lefttaps_offset_y / 128) + 1) mod 2) * 4) + lefttaps_taps_row_value;
      else
        lefttaps_taps_row_choice := 0;
      end if;
      lefttaps_source_x <= (((leftoffsets_x_row_value / 32) + sample_place_column) * 32) + (leftoffsets_x_row_value mod
        32);
      lefttaps_offset_y <= leftoffsets_y_row_value;
      lefttaps_taps_row <= (sample_taken_row + lefttaps_taps_row_choice) mod 8;
      lefttaps_weight_x <= lefttaps_source_x mod 32;
      lefttaps_weight_y <= lefttaps_offset_y mod 32;
      lefttaps_column_shown_0 <= lefttaps_taps_column_is_equal and sample_leaves;
      lefttaps_column_shown_1 <= sample_leaves and ((((lefttaps_source_x / 32) + 1) / 32) = 16);
      lefttaps_row_shown_0 <= ((lefttaps_offset_y / 32) >= 509) and ((lefttaps_offset_y / 32) < 516) and (((sample_row
        + (lefttaps_offset_y / 32) + 65024) mod 65536) < 12);
      lefttaps_row_shown_1 <= (lefttaps_taps_row_sum < 7) and (((sample_row + (lefttaps_offset_y / 32) + 65025) mod
        65536) < 12);
      if lefttaps_taps_column_is_equal then
        lefttaps_taps_column <= ((lefttaps_source_x / 32) + 65025) mod 256;
      else
        lefttaps_taps_column <= 0;
      end if;
      -- righttaps
      righttaps_taps_column_is_equal := (righttaps_source_x / 1024) = 16;
      righttaps_taps_row_value := (righttaps_offset_y / 32) mod 4;
      righttaps_taps_row_sum := ((((righttaps_offset_y / 128) + 16257) mod 16384) * 4) + righttaps_taps_row_value;
      if righttaps_taps_row_sum < 8 then
        righttaps_taps_row_choice := ((((righttaps_offset_y / 128) + 1) mod 2) * 4) + righttaps_taps_row_value;
      else
        righttaps_taps_row_choice := 0;
      end if;
      righttaps_source_x <= (((rightoffsets_x_row_value / 32) + sample_place_column) * 32) + (rightoffsets_x_row_value
        mod 32);
      righttaps_offset_y <= rightoffsets_y_row_value;
      righttaps_taps_row <= (sample_taken_row + righttaps_taps_row_choice) mod 8;
      righttaps_weight_x <= righttaps_source_x mod 32;
      righttaps_weight_y <= righttaps_offset_y mod 32;
      righttaps_column_shown_0 <= righttaps_taps_column_is_equal and sample_leaves;
      righttaps_column_shown_1 <= sample_leaves and ((((righttaps_source_x / 32) + 1) / 32) = 16);
      righttaps_row_shown_0 <= ((righttaps_offset_y / 32) >= 509) and ((righttaps_offset_y / 32) < 516) and
        (((sample_row + (righttaps_offset_y / 32) + 65024) mod 65536) < 12);
      righttaps_row_shown_1 <= (righttaps_taps_row_sum < 7) and (((sample_row + (righttaps_offset_y / 32) + 65025) mod
        65536) < 12);
      if righttaps_taps_column_is_equal then
        righttaps_taps_column <= ((righttaps_source_x / 32) + 65025) mod 256;
      else
        righttaps_taps_column <= 0;
      end if;
      -- leftsampler
      leftsampler_rows_even_line_value := (lefttaps_taps_row + 1) / 2;
      if lefttaps_row_shown_0 then
        leftsampler_shown_held_0_choice := (as_number(lefttaps_column_shown_1) * 2) +
          as_number(lefttaps_column_shown_0);
      else
        leftsampler_shown_held_0_choice := 0;
      end if;
      if leftsampler_rows_column_odd_3 then
        leftsampler_pixel_left_from_choice := leftsampler_rows_odd_odd_ready_word;
      else
        leftsampler_pixel_left_from_choice := leftsampler_rows_odd_even_ready_word;
      end if;
      if leftsampler_rows_column_odd_3 then
        leftsampler_pixel_left_from_choice_2 := leftsampler_rows_even_odd_ready_word;
      else
        leftsampler_pixel_left_from_choice_2 := leftsampler_rows_even_even_ready_word;
      end if;
      if leftsampler_rows_row_odd_3 then
        leftsampler_pixel_left_from_choice_3 := leftsampler_pixel_left_from_choice;
      else
        leftsampler_pixel_left_from_choice_3 := leftsampler_pixel_left_from_choice_2;
      end if;
      if (leftsampler_shown_held_3 mod 2) = 1 then
        leftsampler_pixel_left_from_choice_4 := leftsampler_pixel_left_from_choice_3;
      else
        leftsampler_pixel_left_from_choice_4 := 0;
      end if;
      if leftsampler_rows_row_odd_3 then
        leftsampler_pixel_left_difference_choice := leftsampler_pixel_left_from_choice_2;
      else
        leftsampler_pixel_left_difference_choice := leftsampler_pixel_left_from_choice;
      end if;
      if ((leftsampler_shown_held_3 / 4) mod 2) = 1 then
        leftsampler_pixel_left_difference_choice_2 := leftsampler_pixel_left_difference_choice;
      else
        leftsampler_pixel_left_difference_choice_2 := 0;
      end if;
      if leftsampler_rows_column_odd_3 then
        leftsampler_pixel_right_from_choice := leftsampler_rows_odd_even_ready_word;
      else
        leftsampler_pixel_right_from_choice := leftsampler_rows_odd_odd_ready_word;
      end if;
      if leftsampler_rows_column_odd_3 then
        leftsampler_pixel_right_from_choice_2 := leftsampler_rows_even_even_ready_word;
      else
        leftsampler_pixel_right_from_choice_2 := leftsampler_rows_even_odd_ready_word;
      end if;
      if leftsampler_rows_row_odd_3 then
        leftsampler_pixel_right_from_choice_3 := leftsampler_pixel_right_from_choice;
      else
        leftsampler_pixel_right_from_choice_3 := leftsampler_pixel_right_from_choice_2;
      end if;
      if ((leftsampler_shown_held_3 / 2) mod 2) = 1 then
        leftsampler_pixel_right_from_choice_4 := leftsampler_pixel_right_from_choice_3;
      else
        leftsampler_pixel_right_from_choice_4 := 0;
      end if;
      if leftsampler_rows_row_odd_3 then
        leftsampler_pixel_right_difference_choice := leftsampler_pixel_right_from_choice_2;
      else
        leftsampler_pixel_right_difference_choice := leftsampler_pixel_right_from_choice;
      end if;
      if (leftsampler_shown_held_3 / 8) = 1 then
        leftsampler_pixel_right_difference_choice_2 := leftsampler_pixel_right_difference_choice;
      else
        leftsampler_pixel_right_difference_choice_2 := 0;
      end if;
      leftsampler_rows_odd_line <= ((lefttaps_taps_row / 2) * 16) + (lefttaps_taps_row / 2);
      leftsampler_rows_write_line <= ((sample_kept_row / 2) * 16) + (sample_kept_row / 2);
      leftsampler_rows_even_column <= ((lefttaps_taps_column + 1) mod 256) / 2;
      leftsampler_rows_odd_column <= lefttaps_taps_column / 2;
      leftsampler_rows_write_column <= sample_kept_column / 2;
      leftsampler_rows_to_even_even <= sample_kept_pixels_valid and (not ((sample_kept_column mod 2) = 1)) and (not
        ((sample_kept_row mod 2) = 1));
      leftsampler_rows_to_even_odd <= sample_kept_pixels_valid and ((sample_kept_column mod 2) = 1) and (not
        ((sample_kept_row mod 2) = 1));
      leftsampler_rows_to_odd_even <= sample_kept_pixels_valid and (not ((sample_kept_column mod 2) = 1)) and
        ((sample_kept_row mod 2) = 1);
      leftsampler_rows_to_odd_odd <= sample_kept_pixels_valid and ((sample_kept_column mod 2) = 1) and
        ((sample_kept_row mod 2) = 1);
      leftsampler_rows_written <= sample_kept_pixels_left;
      leftsampler_rows_even_even_read_address <= (leftsampler_rows_even_line + leftsampler_rows_even_column) mod 128;
      leftsampler_rows_even_even_ready_word <= to_integer(leftsampler_rows_even_even_read_word);
      leftsampler_rows_even_odd_read_address <= (leftsampler_rows_even_line + leftsampler_rows_odd_column) mod 128;
      leftsampler_rows_even_odd_ready_word <= to_integer(leftsampler_rows_even_odd_read_word);
      leftsampler_rows_odd_even_read_address <= (leftsampler_rows_odd_line + leftsampler_rows_even_column) mod 128;
      leftsampler_rows_odd_even_ready_word <= to_integer(leftsampler_rows_odd_even_read_word);
      leftsampler_rows_odd_odd_read_address <= (leftsampler_rows_odd_line + leftsampler_rows_odd_column) mod 128;
      leftsampler_rows_odd_odd_ready_word <= to_integer(leftsampler_rows_odd_odd_read_word);
      leftsampler_rows_row_odd_0 <= (lefttaps_taps_row mod 2) = 1;
      leftsampler_rows_row_odd_1 <= leftsampler_rows_row_odd_0;
      leftsampler_rows_row_odd_2 <= leftsampler_rows_row_odd_1;
      leftsampler_rows_row_odd_3 <= leftsampler_rows_row_odd_2;
      leftsampler_rows_column_odd_0 <= (lefttaps_taps_column mod 2) = 1;
      leftsampler_rows_column_odd_1 <= leftsampler_rows_column_odd_0;
      leftsampler_rows_column_odd_2 <= leftsampler_rows_column_odd_1;
      leftsampler_rows_column_odd_3 <= leftsampler_rows_column_odd_2;
      leftsampler_weight_x_held_0 <= lefttaps_weight_x;
      leftsampler_weight_x_held_1 <= leftsampler_weight_x_held_0;
      leftsampler_weight_x_held_2 <= leftsampler_weight_x_held_1;
      leftsampler_weight_x_held_3 <= leftsampler_weight_x_held_2;
      leftsampler_weight_y_held_0 <= lefttaps_weight_y;
      leftsampler_weight_y_held_1 <= leftsampler_weight_y_held_0;
      leftsampler_weight_y_held_2 <= leftsampler_weight_y_held_1;
      leftsampler_weight_y_held_3 <= leftsampler_weight_y_held_2;
      leftsampler_shown_held_1 <= leftsampler_shown_held_0;
      leftsampler_shown_held_2 <= leftsampler_shown_held_1;
      leftsampler_shown_held_3 <= leftsampler_shown_held_2;
      leftsampler_pixel_left_from <= leftsampler_pixel_left_from_choice_4;
      leftsampler_pixel_left_difference <= leftsampler_pixel_left_difference_choice_2 -
        leftsampler_pixel_left_from_choice_4;
      leftsampler_pixel_left_part <= leftsampler_weight_y_held_3;
      leftsampler_pixel_left_base <= leftsampler_pixel_left_from * 32;
      leftsampler_pixel_left_value <= ((((leftsampler_pixel_left_base / 32) + (other_9 / 32)) mod 256) * 32) + (other_9
        mod 32);
      leftsampler_pixel_right_from <= leftsampler_pixel_right_from_choice_4;
      leftsampler_pixel_right_difference <= leftsampler_pixel_right_difference_choice_2 -
        leftsampler_pixel_right_from_choice_4;
      leftsampler_pixel_right_base <= leftsampler_pixel_right_from * 32;
      leftsampler_pixel_right_value <= ((((leftsampler_pixel_right_base / 32) + (other_8 / 32)) mod 256) * 32) +
        (other_8 mod 32);
      leftsampler_pixel_weight_x_held_0 <= leftsampler_weight_x_held_3;
      leftsampler_pixel_weight_x_held_1 <= leftsampler_pixel_weight_x_held_0;
      leftsampler_pixel_weight_x_held_2 <= leftsampler_pixel_weight_x_held_1;
      leftsampler_pixel_row_from <= leftsampler_pixel_left_value;
      leftsampler_pixel_row_difference <= leftsampler_pixel_right_value - leftsampler_pixel_left_value;
      leftsampler_pixel_row_part <= leftsampler_pixel_weight_x_held_2;
      leftsampler_pixel_row_base <= ((((leftsampler_pixel_row_from * 32) / 512) + 1) * 512) +
        ((leftsampler_pixel_row_from mod 16) * 32);
      leftsampler_pixel_row_share <= leftsampler_pixel_row_difference * leftsampler_pixel_row_part;
      leftsampler_pixel_row_value <= (((((leftsampler_pixel_row_base / 32) + ((leftsampler_pixel_row_share mod 524288)
        / 32)) mod 16384) * 32) / 1024) mod 256;
      if lefttaps_taps_row = 7 then
        leftsampler_rows_even_line <= 0;
      else
        leftsampler_rows_even_line <= ((leftsampler_rows_even_line_value mod 4) * 16) +
          leftsampler_rows_even_line_value;
      end if;
      if lefttaps_row_shown_1 then
        leftsampler_shown_held_0 <= leftsampler_shown_held_0_choice + (as_number(lefttaps_column_shown_0) * 4) +
          (as_number(lefttaps_column_shown_1) * 8);
      else
        leftsampler_shown_held_0 <= leftsampler_shown_held_0_choice;
      end if;
      leftsampler_rows_even_even_write_address_sum := leftsampler_rows_write_line + leftsampler_rows_write_column;
      if leftsampler_rows_to_even_even then
        leftsampler_rows_even_even_write_address <= leftsampler_rows_even_even_write_address_sum;
        leftsampler_rows_even_even_write_word <= leftsampler_rows_written;
      end if;
      if leftsampler_rows_to_even_odd then
        leftsampler_rows_even_odd_write_address <= leftsampler_rows_even_even_write_address_sum;
        leftsampler_rows_even_odd_write_word <= leftsampler_rows_written;
      end if;
      if leftsampler_rows_to_odd_even then
        leftsampler_rows_odd_even_write_address <= leftsampler_rows_even_even_write_address_sum;
        leftsampler_rows_odd_even_write_word <= leftsampler_rows_written;
      end if;
      if leftsampler_rows_to_odd_odd then
        leftsampler_rows_odd_odd_write_address <= leftsampler_rows_even_even_write_address_sum;
        leftsampler_rows_odd_odd_write_word <= leftsampler_rows_written;
      end if;
      -- rightsampler
      rightsampler_rows_even_line_value := (righttaps_taps_row + 1) / 2;
      if righttaps_row_shown_0 then
        rightsampler_shown_held_0_choice := (as_number(righttaps_column_shown_1) * 2) +
          as_number(righttaps_column_shown_0);
      else
        rightsampler_shown_held_0_choice := 0;
      end if;
      if rightsampler_rows_column_odd_3 then
        rightsampler_pixel_left_from_choice := rightsampler_rows_odd_odd_ready_word;
      else
        rightsampler_pixel_left_from_choice := rightsampler_rows_odd_even_ready_word;
      end if;
      if rightsampler_rows_column_odd_3 then
        rightsampler_pixel_left_from_choice_2 := rightsampler_rows_even_odd_ready_word;
      else
        rightsampler_pixel_left_from_choice_2 := rightsampler_rows_even_even_ready_word;
      end if;
      if rightsampler_rows_row_odd_3 then
        rightsampler_pixel_left_from_choice_3 := rightsampler_pixel_left_from_choice;
      else
        rightsampler_pixel_left_from_choice_3 := rightsampler_pixel_left_from_choice_2;
      end if;
      if (rightsampler_shown_held_3 mod 2) = 1 then
        rightsampler_pixel_left_from_choice_4 := rightsampler_pixel_left_from_choice_3;
      else
        rightsampler_pixel_left_from_choice_4 := 0;
      end if;
      if rightsampler_rows_row_odd_3 then
        rightsampler_pixel_left_difference_choice := rightsampler_pixel_left_from_choice_2;
      else
        rightsampler_pixel_left_difference_choice := rightsampler_pixel_left_from_choice;
      end if;
      if ((rightsampler_shown_held_3 / 4) mod 2) = 1 then
        rightsampler_pixel_left_difference_choice_2 := rightsampler_pixel_left_difference_choice;
      else
        rightsampler_pixel_left_difference_choice_2 := 0;
      end if;
      if rightsampler_rows_column_odd_3 then
        rightsampler_pixel_right_from_choice := rightsampler_rows_odd_even_ready_word;
      else
        rightsampler_pixel_right_from_choice := rightsampler_rows_odd_odd_ready_word;
      end if;
      if rightsampler_rows_column_odd_3 then
        rightsampler_pixel_right_from_choice_2 := rightsampler_rows_even_even_ready_word;
      else
        rightsampler_pixel_right_from_choice_2 := rightsampler_rows_even_odd_ready_word;
      end if;
      if rightsampler_rows_row_odd_3 then
        rightsampler_pixel_right_from_choice_3 := rightsampler_pixel_right_from_choice;
      else
        rightsampler_pixel_right_from_choice_3 := rightsampler_pixel_right_from_choice_2;
      end if;
      if ((rightsampler_shown_held_3 / 2) mod 2) = 1 then
        rightsampler_pixel_right_from_choice_4 := rightsampler_pixel_right_from_choice_3;
      else
        rightsampler_pixel_right_from_choice_4 := 0;
      end if;
      if rightsampler_rows_row_odd_3 then
        rightsampler_pixel_right_difference_choice := rightsampler_pixel_right_from_choice_2;
      else
        rightsampler_pixel_right_difference_choice := rightsampler_pixel_right_from_choice;
      end if;
      if (rightsampler_shown_held_3 / 8) = 1 then
        rightsampler_pixel_right_difference_choice_2 := rightsampler_pixel_right_difference_choice;
      else
        rightsampler_pixel_right_difference_choice_2 := 0;
      end if;
      rightsampler_rows_odd_line <= ((righttaps_taps_row / 2) * 16) + (righttaps_taps_row / 2);
      rightsampler_rows_even_column <= ((righttaps_taps_column + 1) mod 256) / 2;
      rightsampler_rows_odd_column <= righttaps_taps_column / 2;
      rightsampler_rows_written <= sample_kept_pixels_right;
      rightsampler_rows_even_even_read_address <= (rightsampler_rows_even_line + rightsampler_rows_even_column) mod 128;
      rightsampler_rows_even_even_ready_word <= to_integer(rightsampler_rows_even_even_read_word);
      rightsampler_rows_even_odd_read_address <= (rightsampler_rows_even_line + rightsampler_rows_odd_column) mod 128;
      rightsampler_rows_even_odd_ready_word <= to_integer(rightsampler_rows_even_odd_read_word);
      rightsampler_rows_odd_even_read_address <= (rightsampler_rows_odd_line + rightsampler_rows_even_column) mod 128;
      rightsampler_rows_odd_even_ready_word <= to_integer(rightsampler_rows_odd_even_read_word);
      rightsampler_rows_odd_odd_read_address <= (rightsampler_rows_odd_line + rightsampler_rows_odd_column) mod 128;
      rightsampler_rows_odd_odd_ready_word <= to_integer(rightsampler_rows_odd_odd_read_word);
      rightsampler_rows_row_odd_0 <= (righttaps_taps_row mod 2) = 1;
      rightsampler_rows_row_odd_1 <= rightsampler_rows_row_odd_0;
      rightsampler_rows_row_odd_2 <= rightsampler_rows_row_odd_1;
      rightsampler_rows_row_odd_3 <= rightsampler_rows_row_odd_2;
      rightsampler_rows_column_odd_0 <= (righttaps_taps_column mod 2) = 1;
      rightsampler_rows_column_odd_1 <= rightsampler_rows_column_odd_0;
      rightsampler_rows_column_odd_2 <= rightsampler_rows_column_odd_1;
      rightsampler_rows_column_odd_3 <= rightsampler_rows_column_odd_2;
      rightsampler_weight_x_held_0 <= righttaps_weight_x;
      rightsampler_weight_x_held_1 <= rightsampler_weight_x_held_0;
      rightsampler_weight_x_held_2 <= rightsampler_weight_x_held_1;
      rightsampler_weight_x_held_3 <= rightsampler_weight_x_held_2;
      rightsampler_weight_y_held_0 <= righttaps_weight_y;
      rightsampler_weight_y_held_1 <= rightsampler_weight_y_held_0;
      rightsampler_weight_y_held_2 <= rightsampler_weight_y_held_1;
      rightsampler_weight_y_held_3 <= rightsampler_weight_y_held_2;
      rightsampler_shown_held_1 <= rightsampler_shown_held_0;
      rightsampler_shown_held_2 <= rightsampler_shown_held_1;
      rightsampler_shown_held_3 <= rightsampler_shown_held_2;
      rightsampler_pixel_left_from <= rightsampler_pixel_left_from_choice_4;
      rightsampler_pixel_left_difference <= rightsampler_pixel_left_difference_choice_2 -
        rightsampler_pixel_left_from_choice_4;
      rightsampler_pixel_left_part <= rightsampler_weight_y_held_3;
      rightsampler_pixel_left_base <= rightsampler_pixel_left_from * 32;
      rightsampler_pixel_left_value <= ((((other_4 / 32) + (rightsampler_pixel_left_base / 32)) mod 256) * 32) +
        (other_4 mod 32);
      rightsampler_pixel_right_from <= rightsampler_pixel_right_from_choice_4;
      rightsampler_pixel_right_difference <= rightsampler_pixel_right_difference_choice_2 -
        rightsampler_pixel_right_from_choice_4;
      rightsampler_pixel_right_base <= rightsampler_pixel_right_from * 32;
      rightsampler_pixel_right_value <= ((((other_5 / 32) + (rightsampler_pixel_right_base / 32)) mod 256) * 32) +
        (other_5 mod 32);
      rightsampler_pixel_weight_x_held_0 <= rightsampler_weight_x_held_3;
      rightsampler_pixel_weight_x_held_1 <= rightsampler_pixel_weight_x_held_0;
      rightsampler_pixel_weight_x_held_2 <= rightsampler_pixel_weight_x_held_1;
      rightsampler_pixel_row_from <= rightsampler_pixel_left_value;
      rightsampler_pixel_row_difference <= rightsampler_pixel_right_value - rightsampler_pixel_left_value;
      rightsampler_pixel_row_part <= rightsampler_pixel_weight_x_held_2;
      rightsampler_pixel_row_base <= ((((rightsampler_pixel_row_from * 32) / 512) + 1) * 512) +
        ((rightsampler_pixel_row_from mod 16) * 32);
      rightsampler_pixel_row_share <= rightsampler_pixel_row_part * rightsampler_pixel_row_difference;
      rightsampler_pixel_row_value <= ((((((rightsampler_pixel_row_share mod 524288) / 32) +
        (rightsampler_pixel_row_base / 32)) mod 16384) * 32) / 1024) mod 256;
      if righttaps_taps_row = 7 then
        rightsampler_rows_even_line <= 0;
      else
        rightsampler_rows_even_line <= ((rightsampler_rows_even_line_value mod 4) * 16) +
          rightsampler_rows_even_line_value;
      end if;
      if righttaps_row_shown_1 then
        rightsampler_shown_held_0 <= rightsampler_shown_held_0_choice + (as_number(righttaps_column_shown_0) * 4) +
          (as_number(righttaps_column_shown_1) * 8);
      else
        rightsampler_shown_held_0 <= rightsampler_shown_held_0_choice;
      end if;
      if leftsampler_rows_to_even_even then
        rightsampler_rows_even_even_write_word <= rightsampler_rows_written;
      end if;
      if leftsampler_rows_to_even_odd then
        rightsampler_rows_even_odd_write_word <= rightsampler_rows_written;
      end if;
      if leftsampler_rows_to_odd_even then
        rightsampler_rows_odd_even_write_word <= rightsampler_rows_written;
      end if;
      if leftsampler_rows_to_odd_odd then
        rightsampler_rows_odd_odd_write_word <= rightsampler_rows_written;
      end if;
      -- valid
      valid_held_0 <= sample_kept_pixels_valid;
      valid_held_1 <= valid_held_0;
      valid_held_2 <= valid_held_1;
      valid_held_3 <= valid_held_2;
      valid_held_4 <= valid_held_3;
      valid_held_5 <= valid_held_4;
      valid_held_6 <= valid_held_5;
      valid_held_7 <= valid_held_6;
      valid_held_8 <= valid_held_7;
      valid_held_9 <= valid_held_8;
      -- starts
      starts_held_0 <= sample_kept_starts;
      starts_held_1 <= starts_held_0;
      starts_held_2 <= starts_held_1;
      starts_held_3 <= starts_held_2;
      starts_held_4 <= starts_held_3;
      starts_held_5 <= starts_held_4;
      starts_held_6 <= starts_held_5;
      starts_held_7 <= starts_held_6;
      starts_held_8 <= starts_held_7;
      starts_held_9 <= starts_held_8;
      -- other
      other_0 <= (rightoffsets_y_right_difference * leftoffsets_x_left_part) mod 262144;
      other_1 <= (rightoffsets_y_left_difference * leftoffsets_x_left_part) mod 262144;
      other_2 <= (rightoffsets_x_right_difference * leftoffsets_x_left_part) mod 262144;
      other_3 <= (rightoffsets_x_left_difference * leftoffsets_x_left_part) mod 262144;
      other_4 <= (rightsampler_pixel_left_difference * rightsampler_pixel_left_part) mod 8192;
      other_5 <= (rightsampler_pixel_right_difference * rightsampler_pixel_left_part) mod 8192;
      other_6 <= (leftoffsets_x_right_difference * leftoffsets_x_left_part) mod 262144;
      other_7 <= (leftoffsets_x_left_difference * leftoffsets_x_left_part) mod 262144;
      other_8 <= (leftsampler_pixel_right_difference * leftsampler_pixel_left_part) mod 8192;
      other_9 <= (leftsampler_pixel_left_difference * leftsampler_pixel_left_part) mod 8192;
      if reset = '1' then
        counter_column <= 0;
        counter_group <= 16;
        counter_next_frame <= false;
        delay_held_0_start_of_frame <= false;
        delay_held_0_valid <= false;
        delay_held_1_start_of_frame <= false;
        delay_held_1_valid <= false;
        delay_held_2_start_of_frame <= false;
        delay_held_2_valid <= false;
        delay_held_3_start_of_frame <= false;
        delay_held_3_valid <= false;
        delay_held_4_start_of_frame <= false;
        delay_held_4_valid <= false;
        delay_held_5_start_of_frame <= false;
        delay_held_5_valid <= false;
        delay_held_6_start_of_frame <= false;
        delay_held_6_valid <= false;
        delay_held_7_start_of_frame <= false;
        delay_held_7_valid <= false;
        delay_held_8_start_of_frame <= false;
        delay_held_8_valid <= false;
        delay_held_9_start_of_frame <= false;
        delay_held_9_valid <= false;
        delay_held_10_start_of_frame <= false;
        delay_held_10_valid <= false;
        grid_node_column <= 0;
        grid_node_row <= 0;
        leftoffsets_nodes_even_line <= 0;
        leftoffsets_nodes_odd_line <= 0;
        leftoffsets_nodes_even_column <= 0;
        leftoffsets_nodes_odd_column <= 0;
        leftoffsets_nodes_to_even_even <= false;
        leftoffsets_nodes_to_even_odd <= false;
        leftoffsets_nodes_to_odd_even <= false;
        leftoffsets_nodes_to_odd_odd <= false;
        leftoffsets_nodes_even_even_read_address <= 0;
        leftoffsets_nodes_even_odd_read_address <= 0;
        leftoffsets_nodes_odd_even_read_address <= 0;
        leftoffsets_nodes_odd_odd_read_address <= 0;
        rightoffsets_nodes_to_even_even <= false;
        rightoffsets_nodes_to_even_odd <= false;
        rightoffsets_nodes_to_odd_even <= false;
        rightoffsets_nodes_to_odd_odd <= false;
        sample_place_column <= 0;
        sample_place_group <= 16;
        sample_place_next_frame <= false;
        sample_slot <= 0;
        sample_pixels_valid <= false;
        sample_starts <= false;
        sample_taken_column <= 0;
        sample_taken_row <= 0;
        sample_taken_pixels_valid <= false;
        sample_kept_column <= 0;
        sample_kept_row <= 0;
        sample_kept_pixels_valid <= false;
        sample_kept_starts <= false;
        leftsampler_rows_write_line <= 0;
        leftsampler_rows_write_column <= 0;
        leftsampler_rows_to_even_even <= false;
        leftsampler_rows_to_even_odd <= false;
        leftsampler_rows_to_odd_even <= false;
        leftsampler_rows_to_odd_odd <= false;
        leftsampler_rows_even_even_write_address <= 0;
        leftsampler_rows_even_odd_write_address <= 0;
        leftsampler_rows_odd_even_write_address <= 0;
        leftsampler_rows_odd_odd_write_address <= 0;
        valid_held_0 <= false;
        valid_held_1 <= false;
        valid_held_2 <= false;
        valid_held_3 <= false;
        valid_held_4 <= false;
        valid_held_5 <= false;
        valid_held_6 <= false;
        valid_held_7 <= false;
        valid_held_8 <= false;
        valid_held_9 <= false;
        starts_held_0 <= false;
        starts_held_1 <= false;
        starts_held_2 <= false;
        starts_held_3 <= false;
        starts_held_4 <= false;
        starts_held_5 <= false;
        starts_held_6 <= false;
        starts_held_7 <= false;
        starts_held_8 <= false;
        starts_held_9 <= false;
      end if;
    end if;
  end process;
end architecture;
