-- SPDX-License-Identifier: Apache-2.0
-- Stage in front of a stereo core, rectification, configuration rectify_vga: 640x480, a node every 16 pixels, 16 rows above and 16 below, 1 pixel pair a clock.
-- Options: none.
-- Made from hls/top/rectification_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config rectify_vga
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_rectify_vga is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    pixels_per_clock : positive := 1;
    table_columns : positive := 41;
    table_rows : positive := 31;
    latency_clocks : positive := 24;
    flush_groups : positive := 10880
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
  assert width_px = 640 report "stereo_rectify_vga: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_rectify_vga: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert pixels_per_clock = 1 report "stereo_rectify_vga: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert table_columns = 41 report "stereo_rectify_vga: table_columns is " & integer'image(table_columns) & " but this core has 41" severity failure;
  assert table_rows = 31 report "stereo_rectify_vga: table_rows is " & integer'image(table_rows) & " but this core has 31" severity failure;
  assert latency_clocks = 24 report "stereo_rectify_vga: latency_clocks is " & integer'image(latency_clocks) & " but this core has 24" severity failure;
  assert flush_groups = 10880 report "stereo_rectify_vga: flush_groups is " & integer'image(flush_groups) & " but this core has 10880" severity failure;
end entity;

architecture rtl of stereo_rectify_vga is
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

  function choice(test : boolean; yes : boolean; no : boolean) return boolean is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  function choice(test : boolean; yes : integer; no : integer) return integer is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  function choice(test : boolean; yes : unsigned; no : unsigned) return unsigned is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type natural_1048575_1d is array (natural range <>) of natural range 0 to 1048575;
  type natural_15_1d is array (natural range <>) of natural range 0 to 15;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_31_1d is array (natural range <>) of natural range 0 to 31;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_63_1d is array (natural range <>) of natural range 0 to 63;
  type natural_65535_1d is array (natural range <>) of natural range 0 to 65535;
  type natural_8191_1d is array (natural range <>) of natural range 0 to 8191;
  type unsigned_32_1d is array (natural range <>) of unsigned(31 downto 0);
  signal in_node_x, in_node_y, in_node_column, in_node_row : natural range 0 to 65535;
  signal in_node_valid, in_node_right, in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- counter
  signal counter_column : natural range 0 to 1023;
  signal counter_group : natural range 0 to 511;
  signal counter_next_frame : boolean;
  -- delay
  signal delay_held_left : natural_255_1d(0 to 10);  -- _#_left
  signal delay_held_right : natural_255_1d(0 to 10);  -- _#_right
  signal delay_held_start_of_frame : boolean_1d(0 to 10);  -- _#_start_of_frame
  signal delay_held_valid : boolean_1d(0 to 10);  -- _#_valid
  -- grid
  signal grid_node_column : natural range 0 to 63;
  signal grid_node_row : natural range 0 to 31;
  signal grid_weight_x_held, grid_weight_y_held : natural_15_1d(0 to 4);
  -- leftoffsets
  signal leftoffsets_nodes_even_line : natural range 0 to 336;
  signal leftoffsets_nodes_odd_line : natural range 0 to 315;
  signal leftoffsets_nodes_write_line, leftoffsets_nodes_write_column, leftoffsets_nodes_even_even_write_address,
    leftoffsets_nodes_even_odd_write_address, leftoffsets_nodes_odd_even_write_address,
    leftoffsets_nodes_odd_odd_write_address : natural range 0 to 511;
  signal leftoffsets_nodes_even_column : natural range 0 to 32;
  signal leftoffsets_nodes_odd_column : natural range 0 to 31;
  signal leftoffsets_nodes_to_even_even, leftoffsets_nodes_to_even_odd, leftoffsets_nodes_to_odd_even,
    leftoffsets_nodes_to_odd_odd : boolean;
  signal leftoffsets_nodes_row_odd, leftoffsets_nodes_column_odd : boolean_1d(0 to 3);
  signal leftoffsets_nodes_written, leftoffsets_nodes_even_even_write_word, leftoffsets_nodes_even_even_read_word,
    leftoffsets_nodes_even_even_ready_word, leftoffsets_nodes_even_odd_write_word,
    leftoffsets_nodes_even_odd_read_word, leftoffsets_nodes_even_odd_ready_word, leftoffsets_nodes_odd_even_write_word,
    leftoffsets_nodes_odd_even_read_word, leftoffsets_nodes_odd_even_ready_word, leftoffsets_nodes_odd_odd_write_word,
    leftoffsets_nodes_odd_odd_read_word, leftoffsets_nodes_odd_odd_ready_word : unsigned(31 downto 0);
  signal leftoffsets_nodes_even_even_read_address : natural range 0 to 368;
  signal leftoffsets_nodes_even_odd_read_address : natural range 0 to 367;
  signal leftoffsets_nodes_odd_even_read_address : natural range 0 to 347;
  signal leftoffsets_nodes_odd_odd_read_address : natural range 0 to 346;
  signal leftoffsets_x_left_from, leftoffsets_x_right_from, leftoffsets_x_row_value, leftoffsets_y_left_from,
    leftoffsets_y_right_from, leftoffsets_y_row_value : natural range 0 to 65535;
  signal leftoffsets_x_left_difference, leftoffsets_x_right_difference, leftoffsets_y_left_difference,
    leftoffsets_y_right_difference : integer range -65535 to 65535;
  signal leftoffsets_x_left_part : natural range 0 to 15;
  signal leftoffsets_x_weight_x_held : natural_15_1d(0 to 2);
  signal leftoffsets_x_row_part : natural range 0 to 15;
  signal leftoffsets_x_left_base, leftoffsets_x_right_base, leftoffsets_y_left_base,
    leftoffsets_y_right_base : natural range 0 to 1048560;
  signal leftoffsets_x_left_value, leftoffsets_x_right_value, leftoffsets_x_row_from, leftoffsets_y_left_value,
    leftoffsets_y_right_value, leftoffsets_y_row_from : natural range 0 to 1048575;
  signal leftoffsets_x_row_difference, leftoffsets_y_row_difference : integer range -1048575 to 1048575;
  signal leftoffsets_x_row_base, leftoffsets_y_row_base : natural range 0 to 16777456;
  signal leftoffsets_x_row_share, leftoffsets_y_row_share : integer range -15728625 to 15728625;
  -- rightoffsets
  signal rightoffsets_nodes_to_even_even, rightoffsets_nodes_to_even_odd, rightoffsets_nodes_to_odd_even,
    rightoffsets_nodes_to_odd_odd : boolean;
  signal rightoffsets_nodes_even_even_write_address, rightoffsets_nodes_even_odd_write_address,
    rightoffsets_nodes_odd_even_write_address, rightoffsets_nodes_odd_odd_write_address : natural range 0 to 511;
  signal rightoffsets_nodes_even_even_write_word, rightoffsets_nodes_even_even_read_word,
    rightoffsets_nodes_even_even_ready_word, rightoffsets_nodes_even_odd_write_word,
    rightoffsets_nodes_even_odd_read_word, rightoffsets_nodes_even_odd_ready_word,
    rightoffsets_nodes_odd_even_write_word, rightoffsets_nodes_odd_even_read_word,
    rightoffsets_nodes_odd_even_ready_word, rightoffsets_nodes_odd_odd_write_word,
    rightoffsets_nodes_odd_odd_read_word, rightoffsets_nodes_odd_odd_ready_word : unsigned(31 downto 0);
  signal rightoffsets_x_left_from, rightoffsets_x_right_from, rightoffsets_x_row_value, rightoffsets_y_left_from,
    rightoffsets_y_right_from, rightoffsets_y_row_value : natural range 0 to 65535;
  signal rightoffsets_x_left_difference, rightoffsets_x_right_difference, rightoffsets_y_left_difference,
    rightoffsets_y_right_difference : integer range -65535 to 65535;
  signal rightoffsets_x_left_base, rightoffsets_x_right_base, rightoffsets_y_left_base,
    rightoffsets_y_right_base : natural range 0 to 1048560;
  signal rightoffsets_x_left_value, rightoffsets_x_right_value, rightoffsets_x_row_from, rightoffsets_y_left_value,
    rightoffsets_y_right_value, rightoffsets_y_row_from : natural range 0 to 1048575;
  signal rightoffsets_x_row_difference, rightoffsets_y_row_difference : integer range -1048575 to 1048575;
  signal rightoffsets_x_row_base, rightoffsets_y_row_base : natural range 0 to 16777456;
  signal rightoffsets_x_row_share, rightoffsets_y_row_share : integer range -15728625 to 15728625;
  -- sample
  signal sample_place_column : natural range 0 to 1023;
  signal sample_place_group, sample_row : natural range 0 to 511;
  signal sample_place_next_frame, sample_pixels_valid, sample_leaves, sample_starts, sample_taken_pixels_valid,
    sample_kept_pixels_valid, sample_kept_starts : boolean;
  signal sample_slot, sample_taken_row, sample_kept_row : natural range 0 to 63;
  signal sample_pixels_left, sample_pixels_right, sample_taken_pixels_left, sample_taken_pixels_right,
    sample_kept_pixels_left, sample_kept_pixels_right : natural range 0 to 255;
  signal sample_taken_column, sample_kept_column : natural range 0 to 1024;
  -- lefttaps
  signal lefttaps_source_x : natural range 0 to 98271;
  signal lefttaps_offset_y : natural range 0 to 65535;
  signal lefttaps_taps_column : natural range 0 to 16383;
  signal lefttaps_taps_row : natural range 0 to 63;
  signal lefttaps_weight_x, lefttaps_weight_y : natural range 0 to 31;
  signal lefttaps_column_shown, lefttaps_row_shown : boolean_1d(0 to 1);
  -- righttaps
  signal righttaps_source_x : natural range 0 to 98271;
  signal righttaps_offset_y : natural range 0 to 65535;
  signal righttaps_taps_column : natural range 0 to 16383;
  signal righttaps_taps_row : natural range 0 to 63;
  signal righttaps_weight_x, righttaps_weight_y : natural range 0 to 31;
  signal righttaps_column_shown, righttaps_row_shown : boolean_1d(0 to 1);
  -- leftsampler
  signal leftsampler_rows_even_line, leftsampler_rows_odd_line, leftsampler_rows_write_line,
    leftsampler_rows_even_column, leftsampler_rows_odd_column, leftsampler_rows_even_even_read_address,
    leftsampler_rows_even_even_write_address, leftsampler_rows_even_odd_read_address,
    leftsampler_rows_even_odd_write_address, leftsampler_rows_odd_even_read_address,
    leftsampler_rows_odd_even_write_address, leftsampler_rows_odd_odd_read_address,
    leftsampler_rows_odd_odd_write_address, leftsampler_pixel_left_value, leftsampler_pixel_right_value,
    leftsampler_pixel_row_from : natural range 0 to 8191;
  signal leftsampler_rows_write_column : natural range 0 to 512;
  signal leftsampler_rows_to_even_even, leftsampler_rows_to_even_odd, leftsampler_rows_to_odd_even,
    leftsampler_rows_to_odd_odd : boolean;
  signal leftsampler_rows_row_odd, leftsampler_rows_column_odd : boolean_1d(0 to 3);
  signal leftsampler_rows_written, leftsampler_rows_even_even_write_word, leftsampler_rows_even_even_ready_word,
    leftsampler_rows_even_odd_write_word, leftsampler_rows_even_odd_ready_word, leftsampler_rows_odd_even_write_word,
    leftsampler_rows_odd_even_ready_word, leftsampler_rows_odd_odd_write_word, leftsampler_rows_odd_odd_ready_word,
    leftsampler_pixel_left_from, leftsampler_pixel_right_from, leftsampler_pixel_row_value : natural range 0 to 255;
  signal leftsampler_rows_even_even_read_word, leftsampler_rows_even_odd_read_word,
    leftsampler_rows_odd_even_read_word, leftsampler_rows_odd_odd_read_word : unsigned(7 downto 0);
  signal leftsampler_weight_x_held, leftsampler_weight_y_held : natural_31_1d(0 to 3);
  signal leftsampler_pixel_left_part : natural range 0 to 31;
  signal leftsampler_pixel_weight_x_held : natural_31_1d(0 to 2);
  signal leftsampler_pixel_row_part : natural range 0 to 31;
  signal leftsampler_shown_held : natural_15_1d(0 to 3);
  signal leftsampler_pixel_left_difference, leftsampler_pixel_right_difference : integer range -255 to 255;
  signal leftsampler_pixel_left_base, leftsampler_pixel_right_base : natural range 0 to 8160;
  signal leftsampler_pixel_row_difference : integer range -8191 to 8191;
  signal leftsampler_pixel_row_base : natural range 0 to 262624;
  signal leftsampler_pixel_row_share : integer range -253921 to 253921;
  -- rightsampler
  signal rightsampler_rows_even_line, rightsampler_rows_odd_line, rightsampler_rows_even_column,
    rightsampler_rows_odd_column, rightsampler_rows_even_even_read_address, rightsampler_rows_even_odd_read_address,
    rightsampler_rows_odd_even_read_address, rightsampler_rows_odd_odd_read_address, rightsampler_pixel_left_value,
    rightsampler_pixel_right_value, rightsampler_pixel_row_from : natural range 0 to 8191;
  signal rightsampler_rows_written, rightsampler_rows_even_even_write_word, rightsampler_rows_even_even_ready_word,
    rightsampler_rows_even_odd_write_word, rightsampler_rows_even_odd_ready_word,
    rightsampler_rows_odd_even_write_word, rightsampler_rows_odd_even_ready_word, rightsampler_rows_odd_odd_write_word,
    rightsampler_rows_odd_odd_ready_word, rightsampler_pixel_left_from, rightsampler_pixel_right_from,
    rightsampler_pixel_row_value : natural range 0 to 255;
  signal rightsampler_rows_even_even_read_word, rightsampler_rows_even_odd_read_word,
    rightsampler_rows_odd_even_read_word, rightsampler_rows_odd_odd_read_word : unsigned(7 downto 0);
  signal rightsampler_rows_row_odd, rightsampler_rows_column_odd : boolean_1d(0 to 3);
  signal rightsampler_weight_x_held, rightsampler_weight_y_held : natural_31_1d(0 to 3);
  signal rightsampler_pixel_left_part : natural range 0 to 31;
  signal rightsampler_pixel_weight_x_held : natural_31_1d(0 to 2);
  signal rightsampler_pixel_row_part : natural range 0 to 31;
  signal rightsampler_shown_held : natural_15_1d(0 to 3);
  signal rightsampler_pixel_left_difference, rightsampler_pixel_right_difference : integer range -255 to 255;
  signal rightsampler_pixel_left_base, rightsampler_pixel_right_base : natural range 0 to 8160;
  signal rightsampler_pixel_row_difference : integer range -8191 to 8191;
  signal rightsampler_pixel_row_base : natural range 0 to 262624;
  signal rightsampler_pixel_row_share : integer range -253921 to 253921;
  -- valid
  signal valid_held : boolean_1d(0 to 9);
  -- starts
  signal starts_held : boolean_1d(0 to 9);
  -- other
  signal other : natural_1048575_1d(0 to 3);
  signal other_5 : natural range 0 to 1048575;
  signal others_from_7 : natural_1048575_1d(7 to 9);  -- other_#
  signal other_4, other_6 : natural range 0 to 8191;
  signal others_from_10 : natural_8191_1d(10 to 11);  -- other_#

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
  rectified_start_of_frame <= as_bit(valid_held(9) and starts_held(9));
  rectified_valid <= as_bit(valid_held(9));

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  leftsampler_rows_even_even_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(leftsampler_rows_even_even_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_even_even_write_address, 13);
    write_data <= to_unsigned(leftsampler_rows_even_even_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, leftsampler_rows_even_even_read_word, write_address, write_data);
  end block;

  leftsampler_rows_even_odd_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(leftsampler_rows_even_odd_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_even_odd_write_address, 13);
    write_data <= to_unsigned(leftsampler_rows_even_odd_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, leftsampler_rows_even_odd_read_word, write_address, write_data);
  end block;

  leftsampler_rows_odd_even_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(leftsampler_rows_odd_even_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_odd_even_write_address, 13);
    write_data <= to_unsigned(leftsampler_rows_odd_even_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, leftsampler_rows_odd_even_read_word, write_address, write_data);
  end block;

  leftsampler_rows_odd_odd_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(leftsampler_rows_odd_odd_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_odd_odd_write_address, 13);
    write_data <= to_unsigned(leftsampler_rows_odd_odd_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, leftsampler_rows_odd_odd_read_word, write_address, write_data);
  end block;

  rightsampler_rows_even_even_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(rightsampler_rows_even_even_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_even_even_write_address, 13);
    write_data <= to_unsigned(rightsampler_rows_even_even_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, rightsampler_rows_even_even_read_word, write_address, write_data);
  end block;

  rightsampler_rows_even_odd_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(rightsampler_rows_even_odd_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_even_odd_write_address, 13);
    write_data <= to_unsigned(rightsampler_rows_even_odd_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, rightsampler_rows_even_odd_read_word, write_address, write_data);
  end block;

  rightsampler_rows_odd_even_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(rightsampler_rows_odd_even_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_odd_even_write_address, 13);
    write_data <= to_unsigned(rightsampler_rows_odd_even_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, rightsampler_rows_odd_even_read_word, write_address, write_data);
  end block;

  rightsampler_rows_odd_odd_read_word_memory : block
    signal read_address, write_address : unsigned(12 downto 0);
    signal write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(rightsampler_rows_odd_odd_read_address, 13);
    write_address <= to_unsigned(leftsampler_rows_odd_odd_write_address, 13);
    write_data <= to_unsigned(rightsampler_rows_odd_odd_write_word, 8);
    cell : entity work.line_memory generic map (5457, 8, 13)
      port map (clock, true, read_address, rightsampler_rows_odd_odd_read_word, write_address, write_data);
  end block;

  leftoffsets_nodes_even_even_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_even_even_read_address, 9);
    write_address <= to_unsigned(leftoffsets_nodes_even_even_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, leftoffsets_nodes_even_even_read_word, write_address,
        leftoffsets_nodes_even_even_write_word);
  end block;

  leftoffsets_nodes_even_odd_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_even_odd_read_address, 9);
    write_address <= to_unsigned(leftoffsets_nodes_even_odd_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, leftoffsets_nodes_even_odd_read_word, write_address,
        leftoffsets_nodes_even_odd_write_word);
  end block;

  leftoffsets_nodes_odd_even_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_odd_even_read_address, 9);
    write_address <= to_unsigned(leftoffsets_nodes_odd_even_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, leftoffsets_nodes_odd_even_read_word, write_address,
        leftoffsets_nodes_odd_even_write_word);
  end block;

  leftoffsets_nodes_odd_odd_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_odd_odd_read_address, 9);
    write_address <= to_unsigned(leftoffsets_nodes_odd_odd_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, leftoffsets_nodes_odd_odd_read_word, write_address,
        leftoffsets_nodes_odd_odd_write_word);
  end block;

  rightoffsets_nodes_even_even_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_even_even_read_address, 9);
    write_address <= to_unsigned(rightoffsets_nodes_even_even_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, rightoffsets_nodes_even_even_read_word, write_address,
        rightoffsets_nodes_even_even_write_word);
  end block;

  rightoffsets_nodes_even_odd_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_even_odd_read_address, 9);
    write_address <= to_unsigned(rightoffsets_nodes_even_odd_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, rightoffsets_nodes_even_odd_read_word, write_address,
        rightoffsets_nodes_even_odd_write_word);
  end block;

  rightoffsets_nodes_odd_even_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_odd_even_read_address, 9);
    write_address <= to_unsigned(rightoffsets_nodes_odd_even_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, rightoffsets_nodes_odd_even_read_word, write_address,
        rightoffsets_nodes_odd_even_write_word);
  end block;

  rightoffsets_nodes_odd_odd_read_word_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(leftoffsets_nodes_odd_odd_read_address, 9);
    write_address <= to_unsigned(rightoffsets_nodes_odd_odd_write_address, 9);
    cell : entity work.line_memory generic map (336, 32, 9)
      port map (clock, true, read_address, rightoffsets_nodes_odd_odd_read_word, write_address,
        rightoffsets_nodes_odd_odd_write_word);
  end block;

  process
    variable counter_column_is_equal, counter_group_differs, grid_node_row_all, sample_place_column_is_equal,
      sample_place_group_differs, lefttaps_taps_column_is_less, lefttaps_taps_row_is_not_less,
      lefttaps_taps_row_is_less, lefttaps_taps_row_all, righttaps_taps_column_is_less, righttaps_taps_row_is_not_less,
      righttaps_taps_row_is_less, righttaps_taps_row_all : boolean;
    variable counter_next_frame_is_equals, sample_place_next_frame_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable counter_next_frame_choices : boolean_1d(1 to 3);  -- _choice_#
    variable counter_group_choice, sample_place_group_choice : natural range 0 to 15;
    variable counter_group_choices, sample_place_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable grid_node_row_sum : natural range 495 to 1006;
    variable grid_node_row_choice, leftoffsets_nodes_even_even_write_address_value : natural range 0 to 511;
    variable leftoffsets_x_left_from_choices, leftoffsets_x_right_from_choices, rightoffsets_x_left_from_choices,
      rightoffsets_x_right_from_choices : natural_65535_1d(1 to 3);  -- _choice_#
    variable leftoffsets_x_left_difference_choice, leftoffsets_x_right_difference_choice,
      rightoffsets_x_left_difference_choice, rightoffsets_x_right_difference_choice : natural range 0 to 65535;
    variable leftoffsets_y_left_from_choices, leftoffsets_y_right_from_choices, rightoffsets_y_left_from_choices,
      rightoffsets_y_right_from_choices : unsigned_32_1d(1 to 3);  -- _choice_#
    variable leftoffsets_y_left_difference_choice, leftoffsets_y_right_difference_choice,
      rightoffsets_y_left_difference_choice, rightoffsets_y_right_difference_choice : unsigned(31 downto 0);
    variable sample_place_column_sum : natural range 1 to 1024;
    variable sample_place_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable lefttaps_taps_row_difference, righttaps_taps_row_difference : integer range -1518 to 529;
    variable lefttaps_taps_row_values, righttaps_taps_row_values : boolean_1d(1 to 5);  -- _value_#
    variable lefttaps_taps_row_choices : boolean_1d(1 to 5);  -- _choice_#
    variable lefttaps_taps_row_sum : natural range 0 to 63;
    variable lefttaps_taps_row_choices_from_6 : natural_63_1d(6 to 7);  -- _choice_#
    variable righttaps_taps_row_choices : boolean_1d(1 to 10);  -- _choice_#
    variable righttaps_taps_row_choices_from_11 : natural_63_1d(11 to 12);  -- _choice_#
    variable leftsampler_shown_held_0_choice, rightsampler_shown_held_0_choice : natural range 0 to 3;
    variable leftsampler_pixel_left_from_choices, leftsampler_pixel_right_from_choices,
      rightsampler_pixel_left_from_choices, rightsampler_pixel_right_from_choices : natural_255_1d(1 to 4);  -- _choice_#
    variable leftsampler_pixel_left_difference_choices, leftsampler_pixel_right_difference_choices,
      rightsampler_pixel_left_difference_choices, rightsampler_pixel_right_difference_choices : natural_255_1d(1 to 2);  -- _choice_#
    variable leftsampler_rows_even_even_write_address_value : natural range 0 to 8191;
  begin
    wait until rising_edge(clock);
    -- counter
    counter_column_is_equal := counter_column = 639;
    counter_next_frame_is_equals(1) := counter_group = 496;
    counter_next_frame_choices(1) := choice(counter_next_frame_is_equals(1), counter_next_frame and (counter_group =
      497), counter_next_frame);
    counter_next_frame_choices(2) := choice(counter_column_is_equal, counter_next_frame_choices(1), counter_next_frame);
    counter_next_frame_is_equals(2) := counter_group = 479;
    counter_next_frame_choices(3) := choice(counter_next_frame_is_equals(2), counter_column_is_equal or (not
      in_start_of_frame), not in_start_of_frame);
    if in_valid then
      counter_column <= choice(counter_column_is_equal or in_start_of_frame, 0, (counter_column + 1) mod 1024);
      counter_next_frame <= choice(counter_next_frame_choices(2), counter_next_frame_choices(3),
        counter_next_frame_is_equals(2) and counter_column_is_equal and in_start_of_frame);
    end if;
    counter_group_choice := choice(counter_next_frame_is_equals(2) and counter_column_is_equal, 15, 0);
    counter_group_differs := counter_group /= 497;
    counter_group_choices(2) := choice(counter_next_frame_is_equals(1) and counter_next_frame, 17, (counter_group + 1)
      mod 512);
    counter_group_choices(3) := choice(counter_column_is_equal and in_valid and counter_group_differs,
      counter_group_choices(2), counter_group);
    counter_group <= choice(in_start_of_frame and in_valid, counter_group_choice * 32, counter_group_choices(3));
    -- delay
    delay_held_left(0) <= in_left_pixel;
    delay_held_right(0) <= in_right_pixel;
    delay_held_start_of_frame(0) <= in_start_of_frame;
    delay_held_valid(0) <= in_valid;
    for i in 1 to 10 loop
      delay_held_left(i) <= delay_held_left(i - 1);
      delay_held_right(i) <= delay_held_right(i - 1);
      delay_held_start_of_frame(i) <= delay_held_start_of_frame(i - 1);
      delay_held_valid(i) <= delay_held_valid(i - 1);
    end loop;
    -- grid
    grid_node_row_all := counter_group_differs and (16 < counter_group);
    grid_node_row_sum := counter_group + 495;
    grid_node_row_choice := choice(grid_node_row_all, grid_node_row_sum mod 512, 0);
    grid_node_column <= counter_column / 16;
    grid_node_row <= grid_node_row_choice / 16;
    grid_weight_x_held(0) <= counter_column mod 16;
    grid_weight_x_held(1 to 4) <= grid_weight_x_held(0 to 3);
    grid_weight_y_held(1 to 4) <= grid_weight_y_held(0 to 3);
    grid_weight_y_held(0) <= choice(grid_node_row_all, grid_node_row_sum mod 16, 0);
    -- leftoffsets
    leftoffsets_x_left_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(leftoffsets_nodes_odd_odd_ready_word(15 downto 0)),
      to_integer(leftoffsets_nodes_odd_even_ready_word(15 downto 0)));
    leftoffsets_x_left_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(leftoffsets_nodes_even_odd_ready_word(15 downto 0)),
      to_integer(leftoffsets_nodes_even_even_ready_word(15 downto 0)));
    leftoffsets_x_left_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), leftoffsets_x_left_from_choices(1),
      leftoffsets_x_left_from_choices(2));
    leftoffsets_x_left_difference_choice := choice(leftoffsets_nodes_row_odd(3), leftoffsets_x_left_from_choices(2),
      leftoffsets_x_left_from_choices(1));
    leftoffsets_x_right_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(leftoffsets_nodes_odd_even_ready_word(15 downto 0)),
      to_integer(leftoffsets_nodes_odd_odd_ready_word(15 downto 0)));
    leftoffsets_x_right_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(leftoffsets_nodes_even_even_ready_word(15 downto 0)),
      to_integer(leftoffsets_nodes_even_odd_ready_word(15 downto 0)));
    leftoffsets_x_right_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), leftoffsets_x_right_from_choices(1),
      leftoffsets_x_right_from_choices(2));
    leftoffsets_x_right_difference_choice := choice(leftoffsets_nodes_row_odd(3), leftoffsets_x_right_from_choices(2),
      leftoffsets_x_right_from_choices(1));
    leftoffsets_y_left_from_choices(1) := choice(leftoffsets_nodes_column_odd(3), leftoffsets_nodes_odd_odd_ready_word,
      leftoffsets_nodes_odd_even_ready_word);
    leftoffsets_y_left_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      leftoffsets_nodes_even_odd_ready_word, leftoffsets_nodes_even_even_ready_word);
    leftoffsets_y_left_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), leftoffsets_y_left_from_choices(1),
      leftoffsets_y_left_from_choices(2));
    leftoffsets_y_left_difference_choice := choice(leftoffsets_nodes_row_odd(3), leftoffsets_y_left_from_choices(2),
      leftoffsets_y_left_from_choices(1));
    leftoffsets_y_right_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      leftoffsets_nodes_odd_even_ready_word, leftoffsets_nodes_odd_odd_ready_word);
    leftoffsets_y_right_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      leftoffsets_nodes_even_even_ready_word, leftoffsets_nodes_even_odd_ready_word);
    leftoffsets_y_right_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), leftoffsets_y_right_from_choices(1),
      leftoffsets_y_right_from_choices(2));
    leftoffsets_y_right_difference_choice := choice(leftoffsets_nodes_row_odd(3), leftoffsets_y_right_from_choices(2),
      leftoffsets_y_right_from_choices(1));
    leftoffsets_nodes_odd_line <= (grid_node_row / 2) * 21;
    leftoffsets_nodes_write_line <= (((in_node_row mod 1024) / 2) * 21) mod 512;
    leftoffsets_nodes_even_column <= (grid_node_column + 1) / 2;
    leftoffsets_nodes_odd_column <= grid_node_column / 2;
    leftoffsets_nodes_write_column <= (in_node_column mod 1024) / 2;
    leftoffsets_nodes_to_even_even <= (not is_set(in_node_column, 0)) and (not is_set(in_node_row, 0)) and
      in_node_valid and (not in_node_right);
    leftoffsets_nodes_to_even_odd <= is_set(in_node_column, 0) and (not is_set(in_node_row, 0)) and in_node_valid and
      (not in_node_right);
    leftoffsets_nodes_to_odd_even <= (not is_set(in_node_column, 0)) and is_set(in_node_row, 0) and in_node_valid and
      (not in_node_right);
    leftoffsets_nodes_to_odd_odd <= is_set(in_node_column, 0) and is_set(in_node_row, 0) and in_node_valid and (not
      in_node_right);
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
    leftoffsets_nodes_row_odd(0) <= is_set(grid_node_row, 0);
    leftoffsets_nodes_row_odd(1 to 3) <= leftoffsets_nodes_row_odd(0 to 2);
    leftoffsets_nodes_column_odd(0) <= is_set(grid_node_column, 0);
    leftoffsets_nodes_column_odd(1 to 3) <= leftoffsets_nodes_column_odd(0 to 2);
    leftoffsets_x_left_from <= leftoffsets_x_left_from_choices(3);
    leftoffsets_x_left_difference <= leftoffsets_x_left_difference_choice - leftoffsets_x_left_from_choices(3);
    leftoffsets_x_left_part <= grid_weight_y_held(4);
    leftoffsets_x_left_base <= leftoffsets_x_left_from * 16;
    leftoffsets_x_left_value <= ((((leftoffsets_x_left_base / 16) + (others_from_7(9) / 16)) mod 65536) * 16) +
      (others_from_7(9) mod 16);
    leftoffsets_x_right_from <= leftoffsets_x_right_from_choices(3);
    leftoffsets_x_right_difference <= leftoffsets_x_right_difference_choice - leftoffsets_x_right_from_choices(3);
    leftoffsets_x_right_base <= leftoffsets_x_right_from * 16;
    leftoffsets_x_right_value <= ((((leftoffsets_x_right_base / 16) + (others_from_7(8) / 16)) mod 65536) * 16) +
      (others_from_7(8) mod 16);
    leftoffsets_x_weight_x_held(0) <= grid_weight_x_held(4);
    leftoffsets_x_weight_x_held(1 to 2) <= leftoffsets_x_weight_x_held(0 to 1);
    leftoffsets_x_row_from <= leftoffsets_x_left_value;
    leftoffsets_x_row_difference <= leftoffsets_x_right_value - leftoffsets_x_left_value;
    leftoffsets_x_row_part <= leftoffsets_x_weight_x_held(2);
    leftoffsets_x_row_base <= ((((leftoffsets_x_row_from * 16) / 256) + 1) * 256) + ((leftoffsets_x_row_from mod 16) *
      16);
    leftoffsets_x_row_share <= leftoffsets_x_row_difference * leftoffsets_x_row_part;
    leftoffsets_x_row_value <= ((((leftoffsets_x_row_base / 16) + ((leftoffsets_x_row_share mod 33554432) / 16)) mod
      2097152) * 16) / 512;
    leftoffsets_y_left_from <= to_integer(leftoffsets_y_left_from_choices(3)(31 downto 16));
    leftoffsets_y_left_difference <= to_integer(leftoffsets_y_left_difference_choice(31 downto 16)) -
      to_integer(leftoffsets_y_left_from_choices(3)(31 downto 16));
    leftoffsets_y_left_base <= leftoffsets_y_left_from * 16;
    leftoffsets_y_left_value <= ((((leftoffsets_y_left_base / 16) + (others_from_7(7) / 16)) mod 65536) * 16) +
      (others_from_7(7) mod 16);
    leftoffsets_y_right_from <= to_integer(leftoffsets_y_right_from_choices(3)(31 downto 16));
    leftoffsets_y_right_difference <= to_integer(leftoffsets_y_right_difference_choice(31 downto 16)) -
      to_integer(leftoffsets_y_right_from_choices(3)(31 downto 16));
    leftoffsets_y_right_base <= leftoffsets_y_right_from * 16;
    leftoffsets_y_right_value <= ((((leftoffsets_y_right_base / 16) + (other_5 / 16)) mod 65536) * 16) + (other_5 mod
      16);
    leftoffsets_y_row_from <= leftoffsets_y_left_value;
    leftoffsets_y_row_difference <= leftoffsets_y_right_value - leftoffsets_y_left_value;
    leftoffsets_y_row_base <= ((((leftoffsets_y_row_from * 16) / 256) + 1) * 256) + ((leftoffsets_y_row_from mod 16) *
      16);
    leftoffsets_y_row_share <= leftoffsets_y_row_difference * leftoffsets_x_row_part;
    leftoffsets_y_row_value <= ((((leftoffsets_y_row_base / 16) + ((leftoffsets_y_row_share mod 33554432) / 16)) mod
      2097152) * 16) / 512;
    leftoffsets_nodes_even_line <= choice(grid_node_row = 31, 0, ((grid_node_row + 1) / 2) * 21);
    leftoffsets_nodes_even_even_write_address_value := (leftoffsets_nodes_write_line + leftoffsets_nodes_write_column)
      mod 512;
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
    rightoffsets_x_left_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(rightoffsets_nodes_odd_odd_ready_word(15 downto 0)),
      to_integer(rightoffsets_nodes_odd_even_ready_word(15 downto 0)));
    rightoffsets_x_left_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(rightoffsets_nodes_even_odd_ready_word(15 downto 0)),
      to_integer(rightoffsets_nodes_even_even_ready_word(15 downto 0)));
    rightoffsets_x_left_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), rightoffsets_x_left_from_choices(1),
      rightoffsets_x_left_from_choices(2));
    rightoffsets_x_left_difference_choice := choice(leftoffsets_nodes_row_odd(3), rightoffsets_x_left_from_choices(2),
      rightoffsets_x_left_from_choices(1));
    rightoffsets_x_right_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(rightoffsets_nodes_odd_even_ready_word(15 downto 0)),
      to_integer(rightoffsets_nodes_odd_odd_ready_word(15 downto 0)));
    rightoffsets_x_right_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      to_integer(rightoffsets_nodes_even_even_ready_word(15 downto 0)),
      to_integer(rightoffsets_nodes_even_odd_ready_word(15 downto 0)));
    rightoffsets_x_right_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), rightoffsets_x_right_from_choices(1),
      rightoffsets_x_right_from_choices(2));
    rightoffsets_x_right_difference_choice := choice(leftoffsets_nodes_row_odd(3),
      rightoffsets_x_right_from_choices(2), rightoffsets_x_right_from_choices(1));
    rightoffsets_y_left_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      rightoffsets_nodes_odd_odd_ready_word, rightoffsets_nodes_odd_even_ready_word);
    rightoffsets_y_left_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      rightoffsets_nodes_even_odd_ready_word, rightoffsets_nodes_even_even_ready_word);
    rightoffsets_y_left_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), rightoffsets_y_left_from_choices(1),
      rightoffsets_y_left_from_choices(2));
    rightoffsets_y_left_difference_choice := choice(leftoffsets_nodes_row_odd(3), rightoffsets_y_left_from_choices(2),
      rightoffsets_y_left_from_choices(1));
    rightoffsets_y_right_from_choices(1) := choice(leftoffsets_nodes_column_odd(3),
      rightoffsets_nodes_odd_even_ready_word, rightoffsets_nodes_odd_odd_ready_word);
    rightoffsets_y_right_from_choices(2) := choice(leftoffsets_nodes_column_odd(3),
      rightoffsets_nodes_even_even_ready_word, rightoffsets_nodes_even_odd_ready_word);
    rightoffsets_y_right_from_choices(3) := choice(leftoffsets_nodes_row_odd(3), rightoffsets_y_right_from_choices(1),
      rightoffsets_y_right_from_choices(2));
    rightoffsets_y_right_difference_choice := choice(leftoffsets_nodes_row_odd(3),
      rightoffsets_y_right_from_choices(2), rightoffsets_y_right_from_choices(1));
    rightoffsets_nodes_to_even_even <= (not is_set(in_node_column, 0)) and (not is_set(in_node_row, 0)) and
      in_node_valid and in_node_right;
    rightoffsets_nodes_to_even_odd <= is_set(in_node_column, 0) and (not is_set(in_node_row, 0)) and in_node_valid and
      in_node_right;
    rightoffsets_nodes_to_odd_even <= (not is_set(in_node_column, 0)) and is_set(in_node_row, 0) and in_node_valid and
      in_node_right;
    rightoffsets_nodes_to_odd_odd <= is_set(in_node_column, 0) and is_set(in_node_row, 0) and in_node_valid and
      in_node_right;
    rightoffsets_nodes_even_even_ready_word <= rightoffsets_nodes_even_even_read_word;
    rightoffsets_nodes_even_odd_ready_word <= rightoffsets_nodes_even_odd_read_word;
    rightoffsets_nodes_odd_even_ready_word <= rightoffsets_nodes_odd_even_read_word;
    rightoffsets_nodes_odd_odd_ready_word <= rightoffsets_nodes_odd_odd_read_word;
    rightoffsets_x_left_from <= rightoffsets_x_left_from_choices(3);
    rightoffsets_x_left_difference <= rightoffsets_x_left_difference_choice - rightoffsets_x_left_from_choices(3);
    rightoffsets_x_left_base <= rightoffsets_x_left_from * 16;
    rightoffsets_x_left_value <= ((((rightoffsets_x_left_base / 16) + (other(3) / 16)) mod 65536) * 16) + (other(3) mod
      16);
    rightoffsets_x_right_from <= rightoffsets_x_right_from_choices(3);
    rightoffsets_x_right_difference <= rightoffsets_x_right_difference_choice - rightoffsets_x_right_from_choices(3);
    rightoffsets_x_right_base <= rightoffsets_x_right_from * 16;
    rightoffsets_x_right_value <= ((((rightoffsets_x_right_base / 16) + (other(2) / 16)) mod 65536) * 16) + (other(2)
      mod 16);
    rightoffsets_x_row_from <= rightoffsets_x_left_value;
    rightoffsets_x_row_difference <= rightoffsets_x_right_value - rightoffsets_x_left_value;
    rightoffsets_x_row_base <= ((((rightoffsets_x_row_from * 16) / 256) + 1) * 256) + ((rightoffsets_x_row_from mod 16)
      * 16);
    rightoffsets_x_row_share <= rightoffsets_x_row_difference * leftoffsets_x_row_part;
    rightoffsets_x_row_value <= ((((rightoffsets_x_row_base / 16) + ((rightoffsets_x_row_share mod 33554432) / 16)) mod
      2097152) * 16) / 512;
    rightoffsets_y_left_from <= to_integer(rightoffsets_y_left_from_choices(3)(31 downto 16));
    rightoffsets_y_left_difference <= to_integer(rightoffsets_y_left_difference_choice(31 downto 16)) -
      to_integer(rightoffsets_y_left_from_choices(3)(31 downto 16));
    rightoffsets_y_left_base <= rightoffsets_y_left_from * 16;
    rightoffsets_y_left_value <= ((((rightoffsets_y_left_base / 16) + (other(1) / 16)) mod 65536) * 16) + (other(1) mod
      16);
    rightoffsets_y_right_from <= to_integer(rightoffsets_y_right_from_choices(3)(31 downto 16));
    rightoffsets_y_right_difference <= to_integer(rightoffsets_y_right_difference_choice(31 downto 16)) -
      to_integer(rightoffsets_y_right_from_choices(3)(31 downto 16));
    rightoffsets_y_right_base <= rightoffsets_y_right_from * 16;
    rightoffsets_y_right_value <= ((((rightoffsets_y_right_base / 16) + (other(0) / 16)) mod 65536) * 16) + (other(0)
      mod 16);
    rightoffsets_y_row_from <= rightoffsets_y_left_value;
    rightoffsets_y_row_difference <= rightoffsets_y_right_value - rightoffsets_y_left_value;
    rightoffsets_y_row_base <= ((((rightoffsets_y_row_from * 16) / 256) + 1) * 256) + ((rightoffsets_y_row_from mod 16)
      * 16);
    rightoffsets_y_row_share <= rightoffsets_y_row_difference * leftoffsets_x_row_part;
    rightoffsets_y_row_value <= ((((rightoffsets_y_row_base / 16) + ((rightoffsets_y_row_share mod 33554432) / 16)) mod
      2097152) * 16) / 512;
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
    sample_place_column_is_equal := sample_place_column = 639;
    sample_place_column_sum := sample_place_column + 1;
    sample_place_next_frame_is_equals(1) := sample_place_group = 496;
    sample_place_next_frame_choices(1) := choice(sample_place_next_frame_is_equals(1), sample_place_next_frame and
      ((sample_place_column /= 639) or (sample_place_group = 497)), sample_place_next_frame);
    sample_place_next_frame_is_equals(2) := sample_place_group = 479;
    sample_place_next_frame_choices(2) := choice(sample_place_next_frame_is_equals(2), (not
      delay_held_start_of_frame(10)) or sample_place_column_is_equal, not delay_held_start_of_frame(10));
    if delay_held_valid(10) then
      sample_place_column <= choice(delay_held_start_of_frame(10) or sample_place_column_is_equal, 0,
        sample_place_column_sum mod 1024);
      sample_place_next_frame <= choice(sample_place_next_frame_choices(1), sample_place_next_frame_choices(2),
        sample_place_next_frame_is_equals(2) and delay_held_start_of_frame(10) and sample_place_column_is_equal);
    end if;
    sample_place_group_choice := choice(sample_place_next_frame_is_equals(2) and sample_place_column_is_equal, 15, 0);
    sample_place_group_differs := sample_place_group /= 497;
    sample_place_group_choices(2) := choice(sample_place_next_frame_is_equals(1) and sample_place_next_frame, 17,
      (sample_place_group + 1) mod 512);
    sample_place_group_choices(3) := choice(sample_place_column_is_equal and delay_held_valid(10) and
      sample_place_group_differs, sample_place_group_choices(2), sample_place_group);
    sample_pixels_left <= delay_held_left(10);
    sample_pixels_right <= delay_held_right(10);
    sample_pixels_valid <= delay_held_valid(10);
    sample_row <= (sample_place_group + 495) mod 512;
    sample_leaves <= sample_place_group_differs and (16 < sample_place_group);
    sample_starts <= (sample_place_group = 17) and (sample_place_column = 0);
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
    sample_place_group <= choice(delay_held_start_of_frame(10) and delay_held_valid(10), sample_place_group_choice *
      32, sample_place_group_choices(3));
    if sample_place_column_is_equal and delay_held_valid(10) then
      sample_slot <= choice(sample_slot = 33, 0, (sample_slot + 1) mod 64);
    end if;
    -- lefttaps
    lefttaps_taps_column_is_less := (((((lefttaps_source_x / 16384) + 127) mod 128) * 512) + ((lefttaps_source_x / 32)
      mod 512)) < 640;
    lefttaps_taps_row_difference := 529 - (lefttaps_offset_y / 32);
    lefttaps_taps_row_is_not_less := (lefttaps_offset_y / 32) >= 495;
    lefttaps_taps_row_is_less := (lefttaps_offset_y / 32) < 529;
    lefttaps_taps_row_values(1) := (((lefttaps_taps_row_difference mod 64) / 2) mod 2) = 1;
    lefttaps_taps_row_choices(1) := choice((not is_set(sample_taken_row, 0)) and is_set(lefttaps_taps_row_difference,
      0) and lefttaps_taps_row_is_not_less and lefttaps_taps_row_is_less, (not is_set(sample_taken_row, 1)) or
      (lefttaps_taps_row_values(1) and lefttaps_taps_row_is_not_less and lefttaps_taps_row_is_less), (not
      is_set(sample_taken_row, 1)) and lefttaps_taps_row_values(1) and lefttaps_taps_row_is_not_less and
      lefttaps_taps_row_is_less);
    lefttaps_taps_row_values(2) := is_set(sample_taken_row, 2);
    lefttaps_taps_row_all := lefttaps_taps_row_is_not_less and lefttaps_taps_row_is_less;
    lefttaps_taps_row_choices(2) := choice(lefttaps_taps_row_choices(1), lefttaps_taps_row_values(2) and ((not
      ((((lefttaps_taps_row_difference mod 64) / 4) mod 2) = 1)) or (not lefttaps_taps_row_all)),
      lefttaps_taps_row_values(2) or (not ((((lefttaps_taps_row_difference mod 64) / 4) mod 2) = 1)) or (not
      lefttaps_taps_row_all));
    lefttaps_taps_row_values(3) := is_set(sample_taken_row, 3);
    lefttaps_taps_row_choices(3) := choice(lefttaps_taps_row_choices(2), lefttaps_taps_row_values(3) or (not
      ((((lefttaps_taps_row_difference mod 64) / 8) mod 2) = 1)) or (not lefttaps_taps_row_all),
      lefttaps_taps_row_values(3) and ((not ((((lefttaps_taps_row_difference mod 64) / 8) mod 2) = 1)) or (not
      lefttaps_taps_row_all)));
    lefttaps_taps_row_values(4) := is_set(sample_taken_row, 4);
    lefttaps_taps_row_choices(4) := choice(lefttaps_taps_row_choices(3), lefttaps_taps_row_values(4) or (not
      ((((lefttaps_taps_row_difference mod 64) / 16) mod 2) = 1)) or (not lefttaps_taps_row_all),
      lefttaps_taps_row_values(4) and ((not ((((lefttaps_taps_row_difference mod 64) / 16) mod 2) = 1)) or (not
      lefttaps_taps_row_all)));
    lefttaps_taps_row_values(5) := ((lefttaps_taps_row_difference mod 64) / 32) = 1;
    lefttaps_taps_row_choices(5) := choice(lefttaps_taps_row_choices(4), (not is_set(sample_taken_row, 5)) and
      lefttaps_taps_row_values(5) and lefttaps_taps_row_is_not_less and lefttaps_taps_row_is_less, (not
      is_set(sample_taken_row, 5)) or (lefttaps_taps_row_values(5) and lefttaps_taps_row_is_not_less and
      lefttaps_taps_row_is_less));
    lefttaps_taps_row_sum := ((((sample_taken_row / 2) + 17) mod 32) * 2) + (sample_taken_row mod 2);
    lefttaps_taps_row_choices_from_6(6) := choice(lefttaps_taps_row_choices(5), lefttaps_taps_row_sum,
      sample_taken_row);
    lefttaps_taps_row_choices_from_6(7) := choice(lefttaps_taps_row_all, lefttaps_taps_row_difference mod 64, 0);
    lefttaps_source_x <= (((leftoffsets_x_row_value / 32) + sample_place_column) * 32) + (leftoffsets_x_row_value mod
      32);
    lefttaps_offset_y <= leftoffsets_y_row_value;
    lefttaps_taps_row <= (lefttaps_taps_row_choices_from_6(6) - lefttaps_taps_row_choices_from_6(7)) mod 64;
    lefttaps_weight_x <= lefttaps_source_x mod 32;
    lefttaps_weight_y <= lefttaps_offset_y mod 32;
    lefttaps_column_shown(0) <= sample_leaves and lefttaps_taps_column_is_less;
    lefttaps_column_shown(1) <= ((lefttaps_source_x / 32) >= 511) and ((lefttaps_source_x / 32) < 1151) and
      sample_leaves;
    lefttaps_row_shown(0) <= ((((((lefttaps_offset_y / 512) + 4065) mod 4096) * 16) + ((lefttaps_offset_y / 32) mod
      16)) < 33) and (((sample_row + (lefttaps_offset_y / 32) + 65024) mod 65536) < 480);
    lefttaps_row_shown(1) <= lefttaps_taps_row_is_not_less and ((lefttaps_offset_y / 32) < 528) and (((sample_row +
      (lefttaps_offset_y / 32) + 65025) mod 65536) < 480);
    lefttaps_taps_column <= choice(lefttaps_taps_column_is_less, ((lefttaps_source_x / 32) + 65025) mod 16384, 0);
    -- righttaps
    righttaps_taps_column_is_less := (((((righttaps_source_x / 16384) + 127) mod 128) * 512) + ((righttaps_source_x /
      32) mod 512)) < 640;
    righttaps_taps_row_difference := 529 - (righttaps_offset_y / 32);
    righttaps_taps_row_is_not_less := (righttaps_offset_y / 32) >= 495;
    righttaps_taps_row_is_less := (righttaps_offset_y / 32) < 529;
    righttaps_taps_row_values(1) := (((righttaps_taps_row_difference mod 64) / 2) mod 2) = 1;
    righttaps_taps_row_all := righttaps_taps_row_is_not_less and righttaps_taps_row_is_less;
    righttaps_taps_row_choices(1) := choice(righttaps_taps_row_values(1), righttaps_taps_row_all or (not
      is_set(sample_taken_row, 1)), not is_set(sample_taken_row, 1));
    righttaps_taps_row_choices(2) := choice(is_set(righttaps_taps_row_difference, 0) and righttaps_taps_row_is_not_less
      and righttaps_taps_row_is_less and (not is_set(sample_taken_row, 0)), righttaps_taps_row_choices(1),
      righttaps_taps_row_values(1) and righttaps_taps_row_is_not_less and righttaps_taps_row_is_less and (not
      is_set(sample_taken_row, 1)));
    righttaps_taps_row_values(2) := (((righttaps_taps_row_difference mod 64) / 4) mod 2) = 1;
    righttaps_taps_row_choices(3) := choice(righttaps_taps_row_values(2), (not righttaps_taps_row_all) and
      lefttaps_taps_row_values(2), lefttaps_taps_row_values(2));
    righttaps_taps_row_choices(4) := choice(righttaps_taps_row_choices(2), righttaps_taps_row_choices(3), (not
      righttaps_taps_row_values(2)) or (not righttaps_taps_row_all) or lefttaps_taps_row_values(2));
    righttaps_taps_row_values(3) := (((righttaps_taps_row_difference mod 64) / 8) mod 2) = 1;
    righttaps_taps_row_choices(5) := choice(righttaps_taps_row_values(3), (not righttaps_taps_row_all) and
      lefttaps_taps_row_values(3), lefttaps_taps_row_values(3));
    righttaps_taps_row_choices(6) := choice(righttaps_taps_row_choices(4), (not righttaps_taps_row_values(3)) or (not
      righttaps_taps_row_all) or lefttaps_taps_row_values(3), righttaps_taps_row_choices(5));
    righttaps_taps_row_values(4) := (((righttaps_taps_row_difference mod 64) / 16) mod 2) = 1;
    righttaps_taps_row_choices(7) := choice(righttaps_taps_row_values(4), (not righttaps_taps_row_all) and
      lefttaps_taps_row_values(4), lefttaps_taps_row_values(4));
    righttaps_taps_row_choices(8) := choice(righttaps_taps_row_choices(6), (not righttaps_taps_row_values(4)) or (not
      righttaps_taps_row_all) or lefttaps_taps_row_values(4), righttaps_taps_row_choices(7));
    righttaps_taps_row_values(5) := ((righttaps_taps_row_difference mod 64) / 32) = 1;
    righttaps_taps_row_choices(9) := choice(righttaps_taps_row_values(5), righttaps_taps_row_all or (not
      is_set(sample_taken_row, 5)), not is_set(sample_taken_row, 5));
    righttaps_taps_row_choices(10) := choice(righttaps_taps_row_choices(8), righttaps_taps_row_values(5) and
      righttaps_taps_row_is_not_less and righttaps_taps_row_is_less and (not is_set(sample_taken_row, 5)),
      righttaps_taps_row_choices(9));
    righttaps_taps_row_choices_from_11(11) := choice(righttaps_taps_row_choices(10), lefttaps_taps_row_sum,
      sample_taken_row);
    righttaps_taps_row_choices_from_11(12) := choice(righttaps_taps_row_all, righttaps_taps_row_difference mod 64, 0);
    righttaps_source_x <= (((rightoffsets_x_row_value / 32) + sample_place_column) * 32) + (rightoffsets_x_row_value
      mod 32);
    righttaps_offset_y <= rightoffsets_y_row_value;
    righttaps_taps_row <= (righttaps_taps_row_choices_from_11(11) - righttaps_taps_row_choices_from_11(12)) mod 64;
    righttaps_weight_x <= righttaps_source_x mod 32;
    righttaps_weight_y <= righttaps_offset_y mod 32;
    righttaps_column_shown(0) <= righttaps_taps_column_is_less and sample_leaves;
    righttaps_column_shown(1) <= ((righttaps_source_x / 32) >= 511) and ((righttaps_source_x / 32) < 1151) and
      sample_leaves;
    righttaps_row_shown(0) <= ((((((righttaps_offset_y / 512) + 4065) mod 4096) * 16) + ((righttaps_offset_y / 32) mod
      16)) < 33) and (((sample_row + (righttaps_offset_y / 32) + 65024) mod 65536) < 480);
    righttaps_row_shown(1) <= righttaps_taps_row_is_not_less and ((righttaps_offset_y / 32) < 528) and (((sample_row +
      (righttaps_offset_y / 32) + 65025) mod 65536) < 480);
    righttaps_taps_column <= choice(righttaps_taps_column_is_less, ((righttaps_source_x / 32) + 65025) mod 16384, 0);
    -- leftsampler
    leftsampler_shown_held_0_choice := choice(lefttaps_row_shown(0), (as_number(lefttaps_column_shown(1)) * 2) +
      as_number(lefttaps_column_shown(0)), 0);
    leftsampler_pixel_left_from_choices(1) := choice(leftsampler_rows_column_odd(3),
      leftsampler_rows_odd_odd_ready_word, leftsampler_rows_odd_even_ready_word);
    leftsampler_pixel_left_from_choices(2) := choice(leftsampler_rows_column_odd(3),
      leftsampler_rows_even_odd_ready_word, leftsampler_rows_even_even_ready_word);
    leftsampler_pixel_left_from_choices(3) := choice(leftsampler_rows_row_odd(3),
      leftsampler_pixel_left_from_choices(1), leftsampler_pixel_left_from_choices(2));
    leftsampler_pixel_left_from_choices(4) := choice(is_set(leftsampler_shown_held(3), 0),
      leftsampler_pixel_left_from_choices(3), 0);
    leftsampler_pixel_left_difference_choices(1) := choice(leftsampler_rows_row_odd(3),
      leftsampler_pixel_left_from_choices(2), leftsampler_pixel_left_from_choices(1));
    leftsampler_pixel_left_difference_choices(2) := choice(is_set(leftsampler_shown_held(3), 2),
      leftsampler_pixel_left_difference_choices(1), 0);
    leftsampler_pixel_right_from_choices(1) := choice(leftsampler_rows_column_odd(3),
      leftsampler_rows_odd_even_ready_word, leftsampler_rows_odd_odd_ready_word);
    leftsampler_pixel_right_from_choices(2) := choice(leftsampler_rows_column_odd(3),
      leftsampler_rows_even_even_ready_word, leftsampler_rows_even_odd_ready_word);
    leftsampler_pixel_right_from_choices(3) := choice(leftsampler_rows_row_odd(3),
      leftsampler_pixel_right_from_choices(1), leftsampler_pixel_right_from_choices(2));
    leftsampler_pixel_right_from_choices(4) := choice(is_set(leftsampler_shown_held(3), 1),
      leftsampler_pixel_right_from_choices(3), 0);
    leftsampler_pixel_right_difference_choices(1) := choice(leftsampler_rows_row_odd(3),
      leftsampler_pixel_right_from_choices(2), leftsampler_pixel_right_from_choices(1));
    leftsampler_pixel_right_difference_choices(2) := choice(is_set(leftsampler_shown_held(3), 3),
      leftsampler_pixel_right_difference_choices(1), 0);
    leftsampler_rows_odd_line <= ((lefttaps_taps_row / 2) * 321) mod 8192;
    leftsampler_rows_write_line <= ((sample_kept_row / 2) * 321) mod 8192;
    leftsampler_rows_even_column <= ((lefttaps_taps_column + 1) mod 16384) / 2;
    leftsampler_rows_odd_column <= lefttaps_taps_column / 2;
    leftsampler_rows_write_column <= sample_kept_column / 2;
    leftsampler_rows_to_even_even <= sample_kept_pixels_valid and (not is_set(sample_kept_column, 0)) and (not
      is_set(sample_kept_row, 0));
    leftsampler_rows_to_even_odd <= sample_kept_pixels_valid and is_set(sample_kept_column, 0) and (not
      is_set(sample_kept_row, 0));
    leftsampler_rows_to_odd_even <= sample_kept_pixels_valid and (not is_set(sample_kept_column, 0)) and
      is_set(sample_kept_row, 0);
    leftsampler_rows_to_odd_odd <= sample_kept_pixels_valid and is_set(sample_kept_column, 0) and
      is_set(sample_kept_row, 0);
    leftsampler_rows_written <= sample_kept_pixels_left;
    leftsampler_rows_even_even_read_address <= (leftsampler_rows_even_line + leftsampler_rows_even_column) mod 8192;
    leftsampler_rows_even_even_ready_word <= to_integer(leftsampler_rows_even_even_read_word);
    leftsampler_rows_even_odd_read_address <= (leftsampler_rows_even_line + leftsampler_rows_odd_column) mod 8192;
    leftsampler_rows_even_odd_ready_word <= to_integer(leftsampler_rows_even_odd_read_word);
    leftsampler_rows_odd_even_read_address <= (leftsampler_rows_odd_line + leftsampler_rows_even_column) mod 8192;
    leftsampler_rows_odd_even_ready_word <= to_integer(leftsampler_rows_odd_even_read_word);
    leftsampler_rows_odd_odd_read_address <= (leftsampler_rows_odd_line + leftsampler_rows_odd_column) mod 8192;
    leftsampler_rows_odd_odd_ready_word <= to_integer(leftsampler_rows_odd_odd_read_word);
    leftsampler_rows_row_odd(0) <= is_set(lefttaps_taps_row, 0);
    leftsampler_rows_row_odd(1 to 3) <= leftsampler_rows_row_odd(0 to 2);
    leftsampler_rows_column_odd(0) <= is_set(lefttaps_taps_column, 0);
    leftsampler_rows_column_odd(1 to 3) <= leftsampler_rows_column_odd(0 to 2);
    leftsampler_weight_x_held(0) <= lefttaps_weight_x;
    leftsampler_weight_x_held(1 to 3) <= leftsampler_weight_x_held(0 to 2);
    leftsampler_weight_y_held(0) <= lefttaps_weight_y;
    leftsampler_weight_y_held(1 to 3) <= leftsampler_weight_y_held(0 to 2);
    leftsampler_shown_held(1 to 3) <= leftsampler_shown_held(0 to 2);
    leftsampler_pixel_left_from <= leftsampler_pixel_left_from_choices(4);
    leftsampler_pixel_left_difference <= leftsampler_pixel_left_difference_choices(2) -
      leftsampler_pixel_left_from_choices(4);
    leftsampler_pixel_left_part <= leftsampler_weight_y_held(3);
    leftsampler_pixel_left_base <= leftsampler_pixel_left_from * 32;
    leftsampler_pixel_left_value <= ((((leftsampler_pixel_left_base / 32) + (others_from_10(11) / 32)) mod 256) * 32) +
      (others_from_10(11) mod 32);
    leftsampler_pixel_right_from <= leftsampler_pixel_right_from_choices(4);
    leftsampler_pixel_right_difference <= leftsampler_pixel_right_difference_choices(2) -
      leftsampler_pixel_right_from_choices(4);
    leftsampler_pixel_right_base <= leftsampler_pixel_right_from * 32;
    leftsampler_pixel_right_value <= ((((leftsampler_pixel_right_base / 32) + (others_from_10(10) / 32)) mod 256) * 32)
      + (others_from_10(10) mod 32);
    leftsampler_pixel_weight_x_held(0) <= leftsampler_weight_x_held(3);
    leftsampler_pixel_weight_x_held(1 to 2) <= leftsampler_pixel_weight_x_held(0 to 1);
    leftsampler_pixel_row_from <= leftsampler_pixel_left_value;
    leftsampler_pixel_row_difference <= leftsampler_pixel_right_value - leftsampler_pixel_left_value;
    leftsampler_pixel_row_part <= leftsampler_pixel_weight_x_held(2);
    leftsampler_pixel_row_base <= ((((leftsampler_pixel_row_from * 32) / 512) + 1) * 512) +
      ((leftsampler_pixel_row_from mod 16) * 32);
    leftsampler_pixel_row_share <= leftsampler_pixel_row_difference * leftsampler_pixel_row_part;
    leftsampler_pixel_row_value <= (((((leftsampler_pixel_row_base / 32) + ((leftsampler_pixel_row_share mod 524288) /
      32)) mod 16384) * 32) / 1024) mod 256;
    leftsampler_rows_even_line <= choice(lefttaps_taps_row = 33, 0, (((lefttaps_taps_row + 1) / 2) * 321) mod 8192);
    leftsampler_shown_held(0) <= choice(lefttaps_row_shown(1), leftsampler_shown_held_0_choice +
      (as_number(lefttaps_column_shown(0)) * 4) + (as_number(lefttaps_column_shown(1)) * 8),
      leftsampler_shown_held_0_choice);
    leftsampler_rows_even_even_write_address_value := (leftsampler_rows_write_line + leftsampler_rows_write_column) mod
      8192;
    if leftsampler_rows_to_even_even then
      leftsampler_rows_even_even_write_address <= leftsampler_rows_even_even_write_address_value;
      leftsampler_rows_even_even_write_word <= leftsampler_rows_written;
    end if;
    if leftsampler_rows_to_even_odd then
      leftsampler_rows_even_odd_write_address <= leftsampler_rows_even_even_write_address_value;
      leftsampler_rows_even_odd_write_word <= leftsampler_rows_written;
    end if;
    if leftsampler_rows_to_odd_even then
      leftsampler_rows_odd_even_write_address <= leftsampler_rows_even_even_write_address_value;
      leftsampler_rows_odd_even_write_word <= leftsampler_rows_written;
    end if;
    if leftsampler_rows_to_odd_odd then
      leftsampler_rows_odd_odd_write_address <= leftsampler_rows_even_even_write_address_value;
      leftsampler_rows_odd_odd_write_word <= leftsampler_rows_written;
    end if;
    -- rightsampler
    rightsampler_shown_held_0_choice := choice(righttaps_row_shown(0), (as_number(righttaps_column_shown(1)) * 2) +
      as_number(righttaps_column_shown(0)), 0);
    rightsampler_pixel_left_from_choices(1) := choice(rightsampler_rows_column_odd(3),
      rightsampler_rows_odd_odd_ready_word, rightsampler_rows_odd_even_ready_word);
    rightsampler_pixel_left_from_choices(2) := choice(rightsampler_rows_column_odd(3),
      rightsampler_rows_even_odd_ready_word, rightsampler_rows_even_even_ready_word);
    rightsampler_pixel_left_from_choices(3) := choice(rightsampler_rows_row_odd(3),
      rightsampler_pixel_left_from_choices(1), rightsampler_pixel_left_from_choices(2));
    rightsampler_pixel_left_from_choices(4) := choice(is_set(rightsampler_shown_held(3), 0),
      rightsampler_pixel_left_from_choices(3), 0);
    rightsampler_pixel_left_difference_choices(1) := choice(rightsampler_rows_row_odd(3),
      rightsampler_pixel_left_from_choices(2), rightsampler_pixel_left_from_choices(1));
    rightsampler_pixel_left_difference_choices(2) := choice(is_set(rightsampler_shown_held(3), 2),
      rightsampler_pixel_left_difference_choices(1), 0);
    rightsampler_pixel_right_from_choices(1) := choice(rightsampler_rows_column_odd(3),
      rightsampler_rows_odd_even_ready_word, rightsampler_rows_odd_odd_ready_word);
    rightsampler_pixel_right_from_choices(2) := choice(rightsampler_rows_column_odd(3),
      rightsampler_rows_even_even_ready_word, rightsampler_rows_even_odd_ready_word);
    rightsampler_pixel_right_from_choices(3) := choice(rightsampler_rows_row_odd(3),
      rightsampler_pixel_right_from_choices(1), rightsampler_pixel_right_from_choices(2));
    rightsampler_pixel_right_from_choices(4) := choice(is_set(rightsampler_shown_held(3), 1),
      rightsampler_pixel_right_from_choices(3), 0);
    rightsampler_pixel_right_difference_choices(1) := choice(rightsampler_rows_row_odd(3),
      rightsampler_pixel_right_from_choices(2), rightsampler_pixel_right_from_choices(1));
    rightsampler_pixel_right_difference_choices(2) := choice(is_set(rightsampler_shown_held(3), 3),
      rightsampler_pixel_right_difference_choices(1), 0);
    rightsampler_rows_odd_line <= ((righttaps_taps_row / 2) * 321) mod 8192;
    rightsampler_rows_even_column <= ((righttaps_taps_column + 1) mod 16384) / 2;
    rightsampler_rows_odd_column <= righttaps_taps_column / 2;
    rightsampler_rows_written <= sample_kept_pixels_right;
    rightsampler_rows_even_even_read_address <= (rightsampler_rows_even_line + rightsampler_rows_even_column) mod 8192;
    rightsampler_rows_even_even_ready_word <= to_integer(rightsampler_rows_even_even_read_word);
    rightsampler_rows_even_odd_read_address <= (rightsampler_rows_even_line + rightsampler_rows_odd_column) mod 8192;
    rightsampler_rows_even_odd_ready_word <= to_integer(rightsampler_rows_even_odd_read_word);
    rightsampler_rows_odd_even_read_address <= (rightsampler_rows_odd_line + rightsampler_rows_even_column) mod 8192;
    rightsampler_rows_odd_even_ready_word <= to_integer(rightsampler_rows_odd_even_read_word);
    rightsampler_rows_odd_odd_read_address <= (rightsampler_rows_odd_line + rightsampler_rows_odd_column) mod 8192;
    rightsampler_rows_odd_odd_ready_word <= to_integer(rightsampler_rows_odd_odd_read_word);
    rightsampler_rows_row_odd(0) <= is_set(righttaps_taps_row, 0);
    rightsampler_rows_row_odd(1 to 3) <= rightsampler_rows_row_odd(0 to 2);
    rightsampler_rows_column_odd(0) <= is_set(righttaps_taps_column, 0);
    rightsampler_rows_column_odd(1 to 3) <= rightsampler_rows_column_odd(0 to 2);
    rightsampler_weight_x_held(0) <= righttaps_weight_x;
    rightsampler_weight_x_held(1 to 3) <= rightsampler_weight_x_held(0 to 2);
    rightsampler_weight_y_held(0) <= righttaps_weight_y;
    rightsampler_weight_y_held(1 to 3) <= rightsampler_weight_y_held(0 to 2);
    rightsampler_shown_held(1 to 3) <= rightsampler_shown_held(0 to 2);
    rightsampler_pixel_left_from <= rightsampler_pixel_left_from_choices(4);
    rightsampler_pixel_left_difference <= rightsampler_pixel_left_difference_choices(2) -
      rightsampler_pixel_left_from_choices(4);
    rightsampler_pixel_left_part <= rightsampler_weight_y_held(3);
    rightsampler_pixel_left_base <= rightsampler_pixel_left_from * 32;
    rightsampler_pixel_left_value <= ((((other_4 / 32) + (rightsampler_pixel_left_base / 32)) mod 256) * 32) + (other_4
      mod 32);
    rightsampler_pixel_right_from <= rightsampler_pixel_right_from_choices(4);
    rightsampler_pixel_right_difference <= rightsampler_pixel_right_difference_choices(2) -
      rightsampler_pixel_right_from_choices(4);
    rightsampler_pixel_right_base <= rightsampler_pixel_right_from * 32;
    rightsampler_pixel_right_value <= ((((other_6 / 32) + (rightsampler_pixel_right_base / 32)) mod 256) * 32) +
      (other_6 mod 32);
    rightsampler_pixel_weight_x_held(0) <= rightsampler_weight_x_held(3);
    rightsampler_pixel_weight_x_held(1 to 2) <= rightsampler_pixel_weight_x_held(0 to 1);
    rightsampler_pixel_row_from <= rightsampler_pixel_left_value;
    rightsampler_pixel_row_difference <= rightsampler_pixel_right_value - rightsampler_pixel_left_value;
    rightsampler_pixel_row_part <= rightsampler_pixel_weight_x_held(2);
    rightsampler_pixel_row_base <= ((((rightsampler_pixel_row_from * 32) / 512) + 1) * 512) +
      ((rightsampler_pixel_row_from mod 16) * 32);
    rightsampler_pixel_row_share <= rightsampler_pixel_row_part * rightsampler_pixel_row_difference;
    rightsampler_pixel_row_value <= ((((((rightsampler_pixel_row_share mod 524288) / 32) + (rightsampler_pixel_row_base
      / 32)) mod 16384) * 32) / 1024) mod 256;
    rightsampler_rows_even_line <= choice(righttaps_taps_row = 33, 0, (((righttaps_taps_row + 1) / 2) * 321) mod 8192);
    rightsampler_shown_held(0) <= choice(righttaps_row_shown(1), rightsampler_shown_held_0_choice +
      (as_number(righttaps_column_shown(0)) * 4) + (as_number(righttaps_column_shown(1)) * 8),
      rightsampler_shown_held_0_choice);
    if leftsampler_rows_to_even_even then rightsampler_rows_even_even_write_word <= rightsampler_rows_written; end if;
    if leftsampler_rows_to_even_odd then rightsampler_rows_even_odd_write_word <= rightsampler_rows_written; end if;
    if leftsampler_rows_to_odd_even then rightsampler_rows_odd_even_write_word <= rightsampler_rows_written; end if;
    if leftsampler_rows_to_odd_odd then rightsampler_rows_odd_odd_write_word <= rightsampler_rows_written; end if;
    -- valid
    valid_held(0) <= sample_kept_pixels_valid;
    valid_held(1 to 9) <= valid_held(0 to 8);
    -- starts
    starts_held(0) <= sample_kept_starts;
    starts_held(1 to 9) <= starts_held(0 to 8);
    -- other
    other(0) <= (rightoffsets_y_right_difference * leftoffsets_x_left_part) mod 1048576;
    other(1) <= (rightoffsets_y_left_difference * leftoffsets_x_left_part) mod 1048576;
    other(2) <= (rightoffsets_x_right_difference * leftoffsets_x_left_part) mod 1048576;
    other(3) <= (rightoffsets_x_left_difference * leftoffsets_x_left_part) mod 1048576;
    other_4 <= (rightsampler_pixel_left_difference * rightsampler_pixel_left_part) mod 8192;
    other_5 <= (leftoffsets_y_right_difference * leftoffsets_x_left_part) mod 1048576;
    other_6 <= (rightsampler_pixel_right_difference * rightsampler_pixel_left_part) mod 8192;
    others_from_7(7) <= (leftoffsets_y_left_difference * leftoffsets_x_left_part) mod 1048576;
    others_from_7(8) <= (leftoffsets_x_right_difference * leftoffsets_x_left_part) mod 1048576;
    others_from_7(9) <= (leftoffsets_x_left_difference * leftoffsets_x_left_part) mod 1048576;
    others_from_10(10) <= (leftsampler_pixel_right_difference * leftsampler_pixel_left_part) mod 8192;
    others_from_10(11) <= (leftsampler_pixel_left_difference * leftsampler_pixel_left_part) mod 8192;
    if reset = '1' then
      counter_column <= 0; counter_group <= 497; counter_next_frame <= false;
      for i in 0 to 10 loop
        delay_held_start_of_frame(i) <= false; delay_held_valid(i) <= false;
      end loop;
      grid_node_column <= 0; grid_node_row <= 0; leftoffsets_nodes_even_line <= 0; leftoffsets_nodes_odd_line <= 0;
      leftoffsets_nodes_even_column <= 0; leftoffsets_nodes_odd_column <= 0; leftoffsets_nodes_to_even_even <= false;
      leftoffsets_nodes_to_even_odd <= false; leftoffsets_nodes_to_odd_even <= false;
      leftoffsets_nodes_to_odd_odd <= false; leftoffsets_nodes_even_even_read_address <= 0;
      leftoffsets_nodes_even_odd_read_address <= 0; leftoffsets_nodes_odd_even_read_address <= 0;
      leftoffsets_nodes_odd_odd_read_address <= 0; rightoffsets_nodes_to_even_even <= false;
      rightoffsets_nodes_to_even_odd <= false; rightoffsets_nodes_to_odd_even <= false;
      rightoffsets_nodes_to_odd_odd <= false; sample_place_column <= 0; sample_place_group <= 497;
      sample_place_next_frame <= false; sample_slot <= 0; sample_pixels_valid <= false; sample_starts <= false;
      sample_taken_column <= 0; sample_taken_row <= 0; sample_taken_pixels_valid <= false; sample_kept_column <= 0;
      sample_kept_row <= 0; sample_kept_pixels_valid <= false; sample_kept_starts <= false;
      leftsampler_rows_write_line <= 0; leftsampler_rows_write_column <= 0; leftsampler_rows_to_even_even <= false;
      leftsampler_rows_to_even_odd <= false; leftsampler_rows_to_odd_even <= false;
      leftsampler_rows_to_odd_odd <= false; leftsampler_rows_even_even_write_address <= 0;
      leftsampler_rows_even_odd_write_address <= 0; leftsampler_rows_odd_even_write_address <= 0;
      leftsampler_rows_odd_odd_write_address <= 0; valid_held <= (others => false); starts_held <= (others => false);
    end if;
  end process;
end architecture;
