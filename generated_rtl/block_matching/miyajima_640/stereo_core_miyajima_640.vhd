-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration miyajima_640: 640x480, 200 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 200, window_px 7, aggregation recursive.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config miyajima_640
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_miyajima_640 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 640;
    height_px : positive := 480;
    disparities : positive := 200;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 440;
    latency_clocks : positive := 26;
    flush_groups : positive := 1922;
    gap_groups : positive := 1920
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
  assert width_px = 640 report "stereo_core_miyajima_640: width_px is " & integer'image(width_px) & " but this core has 640" severity failure;
  assert height_px = 480 report "stereo_core_miyajima_640: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 200 report "stereo_core_miyajima_640: disparities is " & integer'image(disparities) & " but this core has 200" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_miyajima_640: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_miyajima_640: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 440 report "stereo_core_miyajima_640: output_width_px is " & integer'image(output_width_px) & " but this core has 440" severity failure;
  assert latency_clocks = 26 report "stereo_core_miyajima_640: latency_clocks is " & integer'image(latency_clocks) & " but this core has 26" severity failure;
  assert flush_groups = 1922 report "stereo_core_miyajima_640: flush_groups is " & integer'image(flush_groups) & " but this core has 1922" severity failure;
  assert gap_groups = 1920 report "stereo_core_miyajima_640: gap_groups is " & integer'image(gap_groups) & " but this core has 1920" severity failure;
end entity;

architecture rtl of stereo_core_miyajima_640 is
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

  function choice(test : boolean; yes : integer; no : integer) return integer is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

  type boolean_1d is array (natural range <>) of boolean;
  type integer_minus_2047_to_2047_1d is array (natural range <>) of integer range -2047 to 2047;
  type integer_minus_255_to_255_1d is array (natural range <>) of integer range -255 to 255;
  type integer_minus_255_to_255_2d is array (natural range <>, natural range <>) of integer range -255 to 255;
  type natural_16383_1d is array (natural range <>) of natural range 0 to 16383;
  type natural_2047_1d is array (natural range <>) of natural range 0 to 2047;
  type natural_2047_2d is array (natural range <>, natural range <>) of natural range 0 to 2047;
  type natural_23_1d is array (natural range <>) of natural range 0 to 23;
  type natural_24_1d is array (natural range <>) of natural range 0 to 24;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_4194303_1d is array (natural range <>) of natural range 0 to 4194303;
  type unsigned_22_1d is array (natural range <>) of unsigned(21 downto 0);
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_2 is record
    valid, start_of_frame : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_4_b is record
    row_start, first_group, border_column, leaves_window : boolean;
  end record;
  type tag_3 is record
    first_group, border_column, leaves_window : boolean;
  end record;
  signal in_start_of_frame, in_valid : boolean;
  signal in_left_pixel, in_right_pixel : natural range 0 to 255;
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : natural range 0 to 255;
  signal raster_features_valid : boolean;
  signal raster_place_column : natural range 0 to 1023;
  signal raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address, delay_ahead_0 : natural range 0 to 255;
  signal delay_delayed_0 : unsigned(7 downto 0);
  signal delay_column : natural range 0 to 1023;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words_0, rows_search_rows_ready_words_0, rows_search_rows_write_words_0,
    rows_reference_rows_read_words_0, rows_reference_rows_ready_words_0,
    rows_reference_rows_write_words_0 : unsigned(31 downto 0);
  signal rows_search_rows_read_words_1, rows_reference_rows_read_words_1 : unsigned(23 downto 0);
  signal rows_search_rows_read_newest_0, rows_search_rows_ready_newest_0, rows_reference_rows_read_newest_0,
    rows_reference_rows_ready_newest_0 : natural range 0 to 255;
  signal rows_search, rows_reference : natural_255_1d(0 to 1);
  signal rows_search_rows_ready_words_1, rows_search_rows_write_words_1, rows_reference_rows_ready_words_1,
    rows_reference_rows_write_words_1 : natural range 0 to 16777215;
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 1023;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice0shift_reference, slice0shift_search_out : natural_255_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice0cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag, slice0cost_tag : tag_9;
  signal slice0cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_column,
    slice0cost_write_column : natural range 0 to 1023;
  signal slice0cost_read_words : unsigned_22_1d(0 to 11);
  signal slice0cost_read_words_12 : unsigned(10 downto 0);
  signal slice0cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice0cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice0cost_ready_words_12 : natural range 0 to 2047;
  signal slice0cost_column_0 : natural_2047_1d(0 to 24);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving : unsigned_22_1d(0 to 11);
  signal slice0window_leaving_12 : unsigned(10 downto 0);
  signal slice0window_entering_0 : natural_2047_1d(0 to 24);
  signal slice0window_entering_tag, slice0window_change_tag : tag_9;
  signal slice0window_centre_output_column : boolean_1d(0 to 1);
  signal slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 2);
  signal slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_2;
  signal slice0window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice0window_sum_0 : natural_16383_1d(0 to 24);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_2;
  signal slice0winner1_best_index_0 : natural_24_1d(1 to 12);  -- _# up to 3, 5 .. 23, 24
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice0winner2_best_index_0 : natural_24_1d(0 to 6);  -- _# up to 3, 7 .. 23, 24
  signal slice0winner2_tag : tag_2;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice0winner3_best_index_0 : natural_24_1d(0 to 3);  -- _# up to 7, 15, 23, 24
  signal slice0winner3_tag : tag_2;
  -- slice0winner4
  signal slice0winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice0winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  signal slice0winner4_tag : tag_2;
  -- slice0winner5
  signal slice0winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice0winner5_best_index_0_0 : natural range 0 to 24;
  signal slice0winner5_tag : tag_2;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 16383;
  signal slice0_best_index_0_0 : natural range 0 to 199;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice1shift_reference, slice1shift_search_out : natural_255_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice1cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice1cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_column,
    slice1cost_write_column : natural range 0 to 1023;
  signal slice1cost_read_words : unsigned_22_1d(0 to 11);
  signal slice1cost_read_words_12 : unsigned(10 downto 0);
  signal slice1cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice1cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice1cost_ready_words_12 : natural range 0 to 2047;
  signal slice1cost_column_0 : natural_2047_1d(0 to 24);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving : unsigned_22_1d(0 to 11);
  signal slice1window_leaving_12 : unsigned(10 downto 0);
  signal slice1window_entering_0 : natural_2047_1d(0 to 24);
  signal slice1window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice1window_change_tag : tag_4_b;
  signal slice1window_centre_output_column_1, slice1window_centre_first_column_0,
    slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_16383_1d(0 to 24);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice1winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice1winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice1winner4
  signal slice1winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice1winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice1winner5
  signal slice1winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice1winner5_best_index_0_0 : natural range 0 to 24;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 16383;
  signal slice1_best_index_0_0 : natural range 0 to 199;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice2shift_reference, slice2shift_search_out : natural_255_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice2cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice2cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_column,
    slice2cost_write_column : natural range 0 to 1023;
  signal slice2cost_read_words : unsigned_22_1d(0 to 11);
  signal slice2cost_read_words_12 : unsigned(10 downto 0);
  signal slice2cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice2cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice2cost_ready_words_12 : natural range 0 to 2047;
  signal slice2cost_column_0 : natural_2047_1d(0 to 24);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 7;
  signal slice2window_leaving : unsigned_22_1d(0 to 11);
  signal slice2window_leaving_12 : unsigned(10 downto 0);
  signal slice2window_entering_0 : natural_2047_1d(0 to 24);
  signal slice2window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice2window_change_tag : tag_3;
  signal slice2window_centre_output_column_1, slice2window_centre_first_column_0,
    slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_16383_1d(0 to 24);
  -- slice2winner1
  signal slice2winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice2winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice2winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice2winner4
  signal slice2winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice2winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice2winner5
  signal slice2winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice2winner5_best_index_0_0 : natural range 0 to 24;
  -- slice2
  signal slice2_best_cost_0_0 : natural range 0 to 16383;
  signal slice2_best_index_0_0 : natural range 0 to 199;
  signal slice2_best_tag : tag_4;
  -- slice3shift
  signal slice3shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice3shift_reference, slice3shift_search_out : natural_255_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice3cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice3cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_column,
    slice3cost_write_column : natural range 0 to 1023;
  signal slice3cost_read_words : unsigned_22_1d(0 to 11);
  signal slice3cost_read_words_12 : unsigned(10 downto 0);
  signal slice3cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice3cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice3cost_ready_words_12 : natural range 0 to 2047;
  signal slice3cost_column_0 : natural_2047_1d(0 to 24);
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 7;
  signal slice3window_leaving : unsigned_22_1d(0 to 11);
  signal slice3window_leaving_12 : unsigned(10 downto 0);
  signal slice3window_entering_0 : natural_2047_1d(0 to 24);
  signal slice3window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice3window_change_tag : tag_3;
  signal slice3window_centre_output_column_1, slice3window_centre_first_column_0,
    slice3window_centre_end_of_line_0 : boolean;
  signal slice3window_sum_0 : natural_16383_1d(0 to 24);
  -- slice3winner1
  signal slice3winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice3winner2
  signal slice3winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice3winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice3winner3
  signal slice3winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice3winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice3winner4
  signal slice3winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice3winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice3winner5
  signal slice3winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice3winner5_best_index_0_0 : natural range 0 to 24;
  -- slice3
  signal slice3_best_cost_0_0 : natural range 0 to 16383;
  signal slice3_best_index_0_0 : natural range 0 to 199;
  signal slice3_best_tag : tag_4;
  -- slice4shift
  signal slice4shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice4shift_reference, slice4shift_search_out : natural_255_1d(0 to 1);
  -- slice4cost
  signal slice4cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice4cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice4cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice4cost_read_column, slice4cost_change_column, slice4cost_ready_column,
    slice4cost_write_column : natural range 0 to 1023;
  signal slice4cost_read_words : unsigned_22_1d(0 to 11);
  signal slice4cost_read_words_12 : unsigned(10 downto 0);
  signal slice4cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice4cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice4cost_ready_words_12 : natural range 0 to 2047;
  signal slice4cost_column_0 : natural_2047_1d(0 to 24);
  -- slice4window
  signal slice4window_ring_read_address, slice4window_ring_write_address : natural range 0 to 7;
  signal slice4window_leaving : unsigned_22_1d(0 to 11);
  signal slice4window_leaving_12 : unsigned(10 downto 0);
  signal slice4window_entering_0 : natural_2047_1d(0 to 24);
  signal slice4window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice4window_change_tag : tag_3;
  signal slice4window_centre_output_column_1, slice4window_centre_first_column_0,
    slice4window_centre_end_of_line_0 : boolean;
  signal slice4window_sum_0 : natural_16383_1d(0 to 24);
  -- slice4winner1
  signal slice4winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice4winner1_best_index_0_0 : boolean;
  signal slice4winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice4winner2
  signal slice4winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice4winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice4winner3
  signal slice4winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice4winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice4winner4
  signal slice4winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice4winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice4winner5
  signal slice4winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice4winner5_best_index_0_0 : natural range 0 to 24;
  -- slice4
  signal slice4_best_cost_0_0 : natural range 0 to 16383;
  signal slice4_best_index_0_0 : natural range 0 to 199;
  signal slice4_best_tag : tag_4;
  -- slice5shift
  signal slice5shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice5shift_reference, slice5shift_search_out : natural_255_1d(0 to 1);
  -- slice5cost
  signal slice5cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice5cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice5cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice5cost_read_column, slice5cost_change_column, slice5cost_ready_column,
    slice5cost_write_column : natural range 0 to 1023;
  signal slice5cost_read_words : unsigned_22_1d(0 to 11);
  signal slice5cost_read_words_12 : unsigned(10 downto 0);
  signal slice5cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice5cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice5cost_ready_words_12 : natural range 0 to 2047;
  signal slice5cost_column_0 : natural_2047_1d(0 to 24);
  -- slice5window
  signal slice5window_ring_read_address, slice5window_ring_write_address : natural range 0 to 7;
  signal slice5window_leaving : unsigned_22_1d(0 to 11);
  signal slice5window_leaving_12 : unsigned(10 downto 0);
  signal slice5window_entering_0 : natural_2047_1d(0 to 24);
  signal slice5window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice5window_change_tag_leaves_window, slice5window_centre_output_column_1,
    slice5window_centre_first_column_0, slice5window_centre_end_of_line_0 : boolean;
  signal slice5window_sum_0 : natural_16383_1d(0 to 24);
  -- slice5winner1
  signal slice5winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice5winner1_best_index_0_0 : boolean;
  signal slice5winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice5winner2
  signal slice5winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice5winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice5winner3
  signal slice5winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice5winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice5winner4
  signal slice5winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice5winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice5winner5
  signal slice5winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice5winner5_best_index_0_0 : natural range 0 to 24;
  -- slice5
  signal slice5_best_cost_0_0 : natural range 0 to 16383;
  signal slice5_best_index_0_0 : natural range 0 to 199;
  signal slice5_best_tag : tag_4;
  -- slice6shift
  signal slice6shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice6shift_reference, slice6shift_search_out : natural_255_1d(0 to 1);
  -- slice6cost
  signal slice6cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice6cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice6cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice6cost_read_column, slice6cost_change_column, slice6cost_ready_column,
    slice6cost_write_column : natural range 0 to 1023;
  signal slice6cost_read_words : unsigned_22_1d(0 to 11);
  signal slice6cost_read_words_12 : unsigned(10 downto 0);
  signal slice6cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice6cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice6cost_ready_words_12 : natural range 0 to 2047;
  signal slice6cost_column_0 : natural_2047_1d(0 to 24);
  -- slice6window
  signal slice6window_ring_read_address, slice6window_ring_write_address : natural range 0 to 7;
  signal slice6window_leaving : unsigned_22_1d(0 to 11);
  signal slice6window_leaving_12 : unsigned(10 downto 0);
  signal slice6window_entering_0 : natural_2047_1d(0 to 24);
  signal slice6window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice6window_change_tag_leaves_window, slice6window_centre_output_column_1,
    slice6window_centre_first_column_0, slice6window_centre_end_of_line_0 : boolean;
  signal slice6window_sum_0 : natural_16383_1d(0 to 24);
  -- slice6winner1
  signal slice6winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice6winner1_best_index_0_0 : boolean;
  signal slice6winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice6winner2
  signal slice6winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice6winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice6winner3
  signal slice6winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice6winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice6winner4
  signal slice6winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice6winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice6winner5
  signal slice6winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice6winner5_best_index_0_0 : natural range 0 to 24;
  -- slice6
  signal slice6_best_cost_0_0 : natural range 0 to 16383;
  signal slice6_best_index_0_0 : natural range 0 to 199;
  signal slice6_best_tag : tag_4;
  -- slice7shift
  signal slice7shift_search : natural_255_2d(0 to 1, 0 to 24);
  signal slice7shift_reference : natural_255_1d(0 to 1);
  -- slice7cost
  signal slice7cost_pixels_first : integer_minus_255_to_255_2d(0 to 1, 0 to 24);
  signal slice7cost_change_0 : integer_minus_255_to_255_1d(0 to 24);
  signal slice7cost_pixels_cost : natural_255_2d(0 to 1, 0 to 24);
  signal slice7cost_read_column, slice7cost_change_column, slice7cost_ready_column,
    slice7cost_write_column : natural range 0 to 1023;
  signal slice7cost_read_words : unsigned_22_1d(0 to 11);
  signal slice7cost_read_words_12 : unsigned(10 downto 0);
  signal slice7cost_ready_words : natural_4194303_1d(0 to 11);
  signal slice7cost_write_words : natural_4194303_1d(0 to 12);  -- _# up to 4194303 x 12, 2047
  signal slice7cost_ready_words_12 : natural range 0 to 2047;
  signal slice7cost_column_0 : natural_2047_1d(0 to 24);
  -- slice7window
  signal slice7window_ring_read_address, slice7window_ring_write_address : natural range 0 to 7;
  signal slice7window_leaving : unsigned_22_1d(0 to 11);
  signal slice7window_leaving_12 : unsigned(10 downto 0);
  signal slice7window_entering_0 : natural_2047_1d(0 to 24);
  signal slice7window_change_0 : integer_minus_2047_to_2047_1d(0 to 24);
  signal slice7window_sum_0 : natural_16383_1d(0 to 24);
  signal slice7window_centre_output_column_1 : boolean;
  signal slice7window_centre_end_of_line : boolean_1d(0 to 1);
  -- slice7winner1
  signal slice7winner1_best_cost_0 : natural_16383_1d(0 to 12);
  signal slice7winner1_best_index_0_0 : boolean;
  signal slice7winner1_best_index_0 : natural_23_1d(1 to 11);  -- _# up to 3, 5 .. 23
  -- slice7winner2
  signal slice7winner2_best_cost_0 : natural_16383_1d(0 to 6);
  signal slice7winner2_best_index_0 : natural_23_1d(0 to 5);  -- _# up to 3, 7 .. 23
  -- slice7winner3
  signal slice7winner3_best_cost_0 : natural_16383_1d(0 to 3);
  signal slice7winner3_best_index_0 : natural_23_1d(0 to 2);  -- _# up to 7, 15, 23
  -- slice7winner4
  signal slice7winner4_best_cost_0 : natural_16383_1d(0 to 1);
  signal slice7winner4_best_index_0 : natural_24_1d(0 to 1);  -- _# up to 15, 24
  -- slice7winner5
  signal slice7winner5_best_cost_0_0 : natural range 0 to 16383;
  signal slice7winner5_best_index_0_0 : natural range 0 to 24;
  -- slice7
  signal slice7_best_index_0_0 : natural range 0 to 199;
  signal slice7_best_tag : tag_4;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice7_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice7_best_tag.valid and slice7_best_tag.output_column);
  disparity_start_of_frame <= as_bit(slice7_best_tag.start_of_frame and slice7_best_tag.valid and slice7_best_tag.output_column);
  disparity_end_of_line <= as_bit(slice7_best_tag.end_of_line and slice7_best_tag.valid and slice7_best_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  slice7window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice7window_ring_read_address, 3);
    write_address <= to_unsigned(slice7window_ring_write_address, 3);
    write_data <= to_unsigned(slice7cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice7window_leaving_12, write_address, write_data);
  end block;

  slice7window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice7window_ring_read_address, 3);
    write_address <= to_unsigned(slice7window_ring_write_address, 3);
    write_data <= to_unsigned(slice7cost_column_0(2 * i + 1), 11) & to_unsigned(slice7cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice7window_leaving(i), write_address, write_data);
  end generate;

  slice7cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice6cost_change_column, 10);
    write_address <= to_unsigned(slice7cost_write_column, 10);
    write_data <= to_unsigned(slice7cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice7cost_read_words_12, write_address, write_data);
  end block;

  slice7cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice6cost_change_column, 10);
    write_address <= to_unsigned(slice7cost_write_column, 10);
    write_data <= to_unsigned(slice7cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice7cost_read_words(i), write_address, write_data);
  end generate;

  slice6window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice6window_ring_read_address, 3);
    write_address <= to_unsigned(slice6window_ring_write_address, 3);
    write_data <= to_unsigned(slice6cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice6window_leaving_12, write_address, write_data);
  end block;

  slice6window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice6window_ring_read_address, 3);
    write_address <= to_unsigned(slice6window_ring_write_address, 3);
    write_data <= to_unsigned(slice6cost_column_0(2 * i + 1), 11) & to_unsigned(slice6cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice6window_leaving(i), write_address, write_data);
  end generate;

  slice6cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice6cost_read_column, 10);
    write_address <= to_unsigned(slice7cost_ready_column, 10);
    write_data <= to_unsigned(slice6cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice6cost_read_words_12, write_address, write_data);
  end block;

  slice6cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice6cost_read_column, 10);
    write_address <= to_unsigned(slice7cost_ready_column, 10);
    write_data <= to_unsigned(slice6cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice6cost_read_words(i), write_address, write_data);
  end generate;

  slice5window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice5window_ring_read_address, 3);
    write_address <= to_unsigned(slice5window_ring_write_address, 3);
    write_data <= to_unsigned(slice5cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice5window_leaving_12, write_address, write_data);
  end block;

  slice5window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice5window_ring_read_address, 3);
    write_address <= to_unsigned(slice5window_ring_write_address, 3);
    write_data <= to_unsigned(slice5cost_column_0(2 * i + 1), 11) & to_unsigned(slice5cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice5window_leaving(i), write_address, write_data);
  end generate;

  slice5cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_write_column, 10);
    write_data <= to_unsigned(slice5cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice5cost_read_words_12, write_address, write_data);
  end block;

  slice5cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_write_column, 10);
    write_data <= to_unsigned(slice5cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice5cost_read_words(i), write_address, write_data);
  end generate;

  slice4window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice4window_ring_read_address, 3);
    write_address <= to_unsigned(slice4window_ring_write_address, 3);
    write_data <= to_unsigned(slice4cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice4window_leaving_12, write_address, write_data);
  end block;

  slice4window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice4window_ring_read_address, 3);
    write_address <= to_unsigned(slice4window_ring_write_address, 3);
    write_data <= to_unsigned(slice4cost_column_0(2 * i + 1), 11) & to_unsigned(slice4cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice4window_leaving(i), write_address, write_data);
  end generate;

  slice4cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice1cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_ready_column, 10);
    write_data <= to_unsigned(slice4cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice4cost_read_words_12, write_address, write_data);
  end block;

  slice4cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice1cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_ready_column, 10);
    write_data <= to_unsigned(slice4cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice4cost_read_words(i), write_address, write_data);
  end generate;

  slice3window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 3);
    write_address <= to_unsigned(slice3window_ring_write_address, 3);
    write_data <= to_unsigned(slice3cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice3window_leaving_12, write_address, write_data);
  end block;

  slice3window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 3);
    write_address <= to_unsigned(slice3window_ring_write_address, 3);
    write_data <= to_unsigned(slice3cost_column_0(2 * i + 1), 11) & to_unsigned(slice3cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice3window_leaving(i), write_address, write_data);
  end generate;

  slice3cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_change_column, 10);
    write_data <= to_unsigned(slice3cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice3cost_read_words_12, write_address, write_data);
  end block;

  slice3cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_write_column, 10);
    write_address <= to_unsigned(slice5cost_change_column, 10);
    write_data <= to_unsigned(slice3cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice3cost_read_words(i), write_address, write_data);
  end generate;

  slice2window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 3);
    write_address <= to_unsigned(slice2window_ring_write_address, 3);
    write_data <= to_unsigned(slice2cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice2window_leaving_12, write_address, write_data);
  end block;

  slice2window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 3);
    write_address <= to_unsigned(slice2window_ring_write_address, 3);
    write_data <= to_unsigned(slice2cost_column_0(2 * i + 1), 11) & to_unsigned(slice2cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice2window_leaving(i), write_address, write_data);
  end generate;

  slice2cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_ready_column, 10);
    write_address <= to_unsigned(slice5cost_read_column, 10);
    write_data <= to_unsigned(slice2cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice2cost_read_words_12, write_address, write_data);
  end block;

  slice2cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_ready_column, 10);
    write_address <= to_unsigned(slice5cost_read_column, 10);
    write_data <= to_unsigned(slice2cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice2cost_read_words(i), write_address, write_data);
  end generate;

  slice1window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice1window_leaving_12, write_address, write_data);
  end block;

  slice1window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(2 * i + 1), 11) & to_unsigned(slice1cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 10);
    write_address <= to_unsigned(slice4cost_read_column, 10);
    write_data <= to_unsigned(slice1cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice1cost_read_words_12, write_address, write_data);
  end block;

  slice1cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 10);
    write_address <= to_unsigned(slice4cost_read_column, 10);
    write_data <= to_unsigned(slice1cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, write_data);
  end generate;

  slice0window_leaving_12_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(24), 11);
    cell : entity work.line_memory generic map (8, 11, 3)
      port map (clock, true, read_address, slice0window_leaving_12, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(2 * i + 1), 11) & to_unsigned(slice0cost_column_0(2 * i), 11);
    cell : entity work.line_memory generic map (8, 22, 3)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_12_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(10 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 10);
    write_address <= to_unsigned(slice3cost_read_column, 10);
    write_data <= to_unsigned(slice0cost_write_words(12), 11);
    cell : entity work.line_memory generic map (640, 11, 10)
      port map (clock, true, read_address, slice0cost_read_words_12, write_address, write_data);
  end block;

  slice0cost_read_words_memory : for i in 11 downto 0 generate
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(21 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 10);
    write_address <= to_unsigned(slice3cost_read_column, 10);
    write_data <= to_unsigned(slice0cost_write_words(i), 22);
    cell : entity work.line_memory generic map (640, 22, 10)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_search_rows_write_words_1, 24);
    cell : entity work.line_memory generic map (640, 24, 10)
      port map (clock, true, read_address, rows_search_rows_read_words_1, write_address, write_data);
  end block;

  rows_search_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, rows_search_rows_read_words_0, write_address,
        rows_search_rows_write_words_0);
  end block;

  rows_reference_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
    signal write_data : unsigned(23 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    write_data <= to_unsigned(rows_reference_rows_write_words_1, 24);
    cell : entity work.line_memory generic map (640, 24, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words_1, write_address, write_data);
  end block;

  rows_reference_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(9 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 10);
    write_address <= to_unsigned(rows_write_column, 10);
    cell : entity work.line_memory generic map (640, 32, 10)
      port map (clock, true, read_address, rows_reference_rows_read_words_0, write_address,
        rows_reference_rows_write_words_0);
  end block;

  delay_delayed_0_memory : block
    signal read_address, write_address, write_data : unsigned(7 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 8);
    write_address <= to_unsigned(delay_ring_write_address, 8);
    write_data <= to_unsigned(raster_features_reference_0, 8);
    cell : entity work.line_memory generic map (200, 8, 8)
      port map (clock, true, read_address, delay_delayed_0, write_address, write_data);
  end block;

  process
    variable raster_place_group_is_equal, delay_tag_first_cost_is_equal, slice0winner5_best_cost_0_0_is_less,
      slice1winner5_best_cost_0_0_is_less, slice1_best_cost_0_0_is_less, slice2winner5_best_cost_0_0_is_less,
      slice2_best_cost_0_0_is_less, slice3winner5_best_cost_0_0_is_less, slice3_best_cost_0_0_is_less,
      slice4winner5_best_cost_0_0_is_less, slice4_best_cost_0_0_is_less, slice5winner5_best_cost_0_0_is_less,
      slice5_best_cost_0_0_is_less, slice6winner5_best_cost_0_0_is_less, slice6_best_cost_0_0_is_less,
      slice7winner5_best_cost_0_0_is_less : boolean;
    variable slice0cost_column_0_choice, slice1cost_column_0_choice, slice2cost_column_0_choice,
      slice3cost_column_0_choice, slice4cost_column_0_choice, slice5cost_column_0_choice, slice6cost_column_0_choice,
      slice7cost_column_0_choice : natural_2047_2d(0 to 24, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice, slice2window_change_0_choice,
      slice3window_change_0_choice, slice4window_change_0_choice, slice5window_change_0_choice,
      slice6window_change_0_choice, slice7window_change_0_choice : natural_2047_1d(0 to 24);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice, slice2window_sum_0_choice,
      slice3window_sum_0_choice, slice4window_sum_0_choice, slice5window_sum_0_choice, slice6window_sum_0_choice,
      slice7window_sum_0_choice : natural_16383_1d(0 to 24);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less, slice2winner1_best_cost_0_is_less,
      slice3winner1_best_cost_0_is_less, slice4winner1_best_cost_0_is_less, slice5winner1_best_cost_0_is_less,
      slice6winner1_best_cost_0_is_less, slice7winner1_best_cost_0_is_less : boolean_1d(0 to 11);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less, slice2winner2_best_cost_0_is_less,
      slice3winner2_best_cost_0_is_less, slice4winner2_best_cost_0_is_less, slice5winner2_best_cost_0_is_less,
      slice6winner2_best_cost_0_is_less, slice7winner2_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less, slice2winner3_best_cost_0_is_less,
      slice3winner3_best_cost_0_is_less, slice4winner3_best_cost_0_is_less, slice5winner3_best_cost_0_is_less,
      slice6winner3_best_cost_0_is_less, slice7winner3_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner4_best_cost_0_is_less, slice1winner4_best_cost_0_is_less, slice2winner4_best_cost_0_is_less,
      slice3winner4_best_cost_0_is_less, slice4winner4_best_cost_0_is_less, slice5winner4_best_cost_0_is_less,
      slice6winner4_best_cost_0_is_less, slice7winner4_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
  begin
    wait until rising_edge(clock);
    -- raster
    raster_place_group_is_equal := raster_place_column = 639;
    raster_features_search_0 <= in_left_pixel;
    raster_features_reference_0 <= in_right_pixel;
    raster_features_valid <= in_valid;
    raster_place_group <= choice(in_start_of_frame and in_valid, 0, (raster_place_group +
      as_number(((raster_place_group /= 483) and raster_place_group_is_equal and in_valid))) mod 512);
    if in_valid then
      raster_place_column <= choice(raster_place_group_is_equal or in_start_of_frame, 0, (raster_place_column + 1) mod
        1024);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 199, 0, (delay_ring_read_address + 1) mod 256);
    end if;
    delay_tag_first_cost_is_equal := raster_place_column = 199;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 7) and (raster_place_group < 487);
    delay_row_inside(1) <= raster_place_group < 480;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 199;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.leaves_window <= (((((raster_place_column / 2) + 32665) mod 32768) * 2) + (raster_place_column mod 2)) <
      65333;
    delay_tag.output_column <= (raster_place_group >= 3) and (raster_place_group < 483) and (raster_place_column >=
      199) and (raster_place_column < 639);
    delay_tag.start_of_frame <= (raster_place_group = 3) and delay_tag_first_cost_is_equal;
    delay_tag.end_of_line <= raster_place_column = 638;
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
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    rows_search(0) <= choice(rows_ready_inside(0), to_integer(rows_search_rows_ready_words_0(7 downto 0)), 0);
    rows_reference(0) <= choice(rows_ready_inside(0), to_integer(rows_reference_rows_ready_words_0(7 downto 0)), 0);
    rows_search(1) <= choice(rows_ready_inside(1), rows_search_rows_ready_newest_0, 0);
    rows_reference(1) <= choice(rows_ready_inside(1), rows_reference_rows_ready_newest_0, 0);
    if rows_ready_tag.valid then
      rows_search_rows_write_words_0 <= to_unsigned((rows_search_rows_ready_words_1 mod 256), 8) &
        rows_search_rows_ready_words_0(31 downto 8);
      rows_search_rows_write_words_1 <= (rows_search_rows_ready_newest_0 * 65536) + ((rows_search_rows_ready_words_1 /
        65536) * 256) + ((rows_search_rows_ready_words_1 mod 65536) / 256);
      rows_reference_rows_write_words_0 <= to_unsigned((rows_reference_rows_ready_words_1 mod 256), 8) &
        rows_reference_rows_ready_words_0(31 downto 8);
      rows_reference_rows_write_words_1 <= (rows_reference_rows_ready_newest_0 * 65536) +
        ((rows_reference_rows_ready_words_1 / 65536) * 256) + ((rows_reference_rows_ready_words_1 mod 65536) / 256);
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 24) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 11 loop
      slice0cost_column_0_choice(2 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        2048);
      slice0cost_column_0_choice(2 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2 * i)
        + slice0cost_column_0_choice(2 * i, 1)) mod 2048);
      slice0cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 2048);
      slice0cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(2
        * i + 1) + slice0cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice0cost_column_0_choice(24, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words_12);
    slice0cost_column_0_choice(24, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(24) +
      slice0cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice0cost_pixels_first(0, i) <= slice0shift_search(0, i) - slice0shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice0cost_pixels_first(1, i) <= slice0shift_search(1, i) - slice0shift_reference(1);
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice0cost_pixels_cost(i, j) <= (folded(slice0cost_pixels_first(i, j)) + as_number((slice0cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 24 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice0cost_ready_words(i) <= to_integer(slice0cost_read_words(i)); end loop;
    slice0cost_ready_words_12 <= to_integer(slice0cost_read_words_12);
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 24 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_tag <= slice0cost_ready_tag;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 1024);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        1024);
    end if;
    if slice0cost_pixels_tag.valid then
      slice0cost_ready_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice0cost_ready_column + 1) mod 1024);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 11 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(2 * i + 1, 2) * 2048) + slice0cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice0cost_write_words(12) <= slice0cost_column_0_choice(24, 2);
      slice0cost_write_column <= choice(slice0cost_ready_tag.row_start, 0, (slice0cost_write_column + 1) mod 1024);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 7, 0, (slice0window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice0window_change_0_choice(2 * i) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(10 downto 0)), 0);
      slice0window_change_0_choice(2 * i + 1) := choice(slice0window_entering_tag.leaves_window,
        to_integer(slice0window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice0window_change_0_choice(24) := choice(slice0window_entering_tag.leaves_window,
      to_integer(slice0window_leaving_12), 0);
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag <= slice0cost_tag;
    for i in 0 to 24 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_output_column(0) <= slice0window_change_tag.output_column;
    slice0window_centre_output_column(1) <= slice0window_centre_output_column(0);
    slice0window_centre_first_column_0 <= slice0window_change_tag.first_cost;
    slice0window_centre_start_of_frame(0) <= slice0window_change_tag.start_of_frame;
    slice0window_centre_start_of_frame(1 to 2) <= slice0window_centre_start_of_frame(0 to 1);
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame(2);
    for i in 0 to 24 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 24 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice0winner1
    for i in 0 to 11 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_cost_0(12) <= slice0window_sum_0(24);
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_index_0(12) <= 24;
    slice0winner1_tag <= slice0window_tag;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 1 to 11 loop
      slice0winner1_best_cost_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i + 1),
        slice0window_sum_0(2 * i));
      slice0winner1_best_index_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice0winner2
    for i in 0 to 5 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_cost_0(6) <= slice0winner1_best_cost_0(12);
    slice0winner2_best_index_0(6) <= slice0winner1_best_index_0(12);
    slice0winner2_tag <= slice0winner1_tag;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice0winner2_best_cost_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_cost_0(2 * i +
        1), slice0winner1_best_cost_0(2 * i));
      slice0winner2_best_index_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_index_0(2 * i +
        1), slice0winner1_best_index_0(2 * i));
    end loop;
    -- slice0winner3
    for i in 0 to 2 loop
      slice0winner3_best_cost_0_is_less(i) := (slice0winner2_best_cost_0(2 * i + 1) - slice0winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner3_best_cost_0(3) <= slice0winner2_best_cost_0(6);
    slice0winner3_best_index_0(3) <= slice0winner2_best_index_0(6);
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 2 loop
      slice0winner3_best_cost_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_cost_0(2 * i +
        1), slice0winner2_best_cost_0(2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
    end loop;
    -- slice0winner4
    slice0winner4_best_cost_0_is_less(0) := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_best_cost_0_is_less(1) := (slice0winner3_best_cost_0(3) - slice0winner3_best_cost_0(2)) < 0;
    slice0winner4_tag.valid <= slice0winner3_tag.valid;
    for i in 0 to 1 loop
      slice0winner4_best_cost_0(i) <= choice(slice0winner4_best_cost_0_is_less(i), slice0winner3_best_cost_0(2 * i +
        1), slice0winner3_best_cost_0(2 * i));
      slice0winner4_best_index_0(i) <= choice(slice0winner4_best_cost_0_is_less(i), slice0winner3_best_index_0(2 * i +
        1), slice0winner3_best_index_0(2 * i));
    end loop;
    if slice0_best_tag.valid then slice0winner4_tag.start_of_frame <= slice0winner3_tag.start_of_frame; end if;
    -- slice0winner5
    slice0winner5_best_cost_0_0_is_less := (slice0winner4_best_cost_0(1) - slice0winner4_best_cost_0(0)) < 0;
    slice0winner5_tag.valid <= slice0winner4_tag.valid;
    slice0winner5_best_cost_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_cost_0(1),
      slice0winner4_best_cost_0(0));
    slice0winner5_best_index_0_0 <= choice(slice0winner5_best_cost_0_0_is_less, slice0winner4_best_index_0(1),
      slice0winner4_best_index_0(0));
    if slice0_best_tag.valid then slice0winner5_tag.start_of_frame <= slice0winner4_tag.start_of_frame; end if;
    -- slice0
    slice0_best_cost_0_0 <= slice0winner5_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner5_best_index_0_0 + 175;
    slice0_best_tag.valid <= slice0winner5_tag.valid;
    if slice0_best_tag.valid then
      slice0_best_tag.output_column <= slice7window_centre_output_column_1;
      slice0_best_tag.start_of_frame <= slice0winner5_tag.start_of_frame;
      slice0_best_tag.end_of_line <= slice7window_centre_end_of_line(1);
    end if;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 24) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 0);
    slice1shift_search_out(1) <= slice1shift_search(1, 0);
    -- slice1cost
    for i in 0 to 11 loop
      slice1cost_column_0_choice(2 * i, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) mod 2048);
      slice1cost_column_0_choice(2 * i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i) +
        slice1cost_column_0_choice(2 * i, 1)) mod 2048);
      slice1cost_column_0_choice(2 * i + 1, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) /
        2048);
      slice1cost_column_0_choice(2 * i + 1, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(2 * i +
        1) + slice1cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice1cost_column_0_choice(24, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words_12);
    slice1cost_column_0_choice(24, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(24) +
      slice1cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice1cost_pixels_first(0, i) <= slice1shift_search(0, i) - slice1shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice1cost_pixels_first(1, i) <= slice1shift_search(1, i) - slice1shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice1cost_pixels_cost(i, j) <= (folded(slice1cost_pixels_first(i, j)) + as_number((slice1cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice0cost_change_column;
    for i in 0 to 24 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice1cost_ready_words(i) <= to_integer(slice1cost_read_words(i)); end loop;
    slice1cost_ready_words_12 <= to_integer(slice1cost_read_words_12);
    slice1cost_ready_column <= slice0cost_ready_column;
    for i in 0 to 24 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_tag.valid then
      for i in 0 to 11 loop
        slice1cost_write_words(i) <= (slice1cost_column_0_choice(2 * i + 1, 2) * 2048) + slice1cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice1cost_write_words(12) <= slice1cost_column_0_choice(24, 2);
      slice1cost_write_column <= choice(slice0cost_tag.row_start, 0, (slice1cost_write_column + 1) mod 1024);
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 7, 0, (slice1window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice1window_change_0_choice(2 * i) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(10 downto 0)), 0);
      slice1window_change_0_choice(2 * i + 1) := choice(slice0window_change_tag.leaves_window,
        to_integer(slice1window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice1window_change_0_choice(24) := choice(slice0window_change_tag.leaves_window,
      to_integer(slice1window_leaving_12), 0);
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 24 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    slice1window_change_tag.row_start <= slice0window_change_tag.row_start;
    slice1window_change_tag.first_group <= slice0window_change_tag.first_group;
    slice1window_change_tag.border_column <= slice0window_change_tag.border_column;
    slice1window_change_tag.leaves_window <= slice0window_change_tag.leaves_window;
    slice1window_centre_output_column_1 <= slice0window_centre_output_column(1);
    slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice1window_sum_0_choice(i) := choice(slice0window_centre_first_column_0, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 24 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice1winner1
    for i in 0 to 11 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_cost_0(12) <= slice1window_sum_0(24);
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 1 to 11 loop
      slice1winner1_best_cost_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i + 1),
        slice1window_sum_0(2 * i));
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice1winner2
    for i in 0 to 5 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_cost_0(6) <= slice1winner1_best_cost_0(12);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice1winner2_best_cost_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_cost_0(2 * i +
        1), slice1winner1_best_cost_0(2 * i));
      slice1winner2_best_index_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_index_0(2 * i +
        1), slice1winner1_best_index_0(2 * i));
    end loop;
    -- slice1winner3
    for i in 0 to 2 loop
      slice1winner3_best_cost_0_is_less(i) := (slice1winner2_best_cost_0(2 * i + 1) - slice1winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner3_best_cost_0(3) <= slice1winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice1winner3_best_cost_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_cost_0(2 * i +
        1), slice1winner2_best_cost_0(2 * i));
      slice1winner3_best_index_0(i) <= choice(slice1winner3_best_cost_0_is_less(i), slice1winner2_best_index_0(2 * i +
        1), slice1winner2_best_index_0(2 * i));
    end loop;
    -- slice1winner4
    slice1winner4_best_cost_0_is_less(0) := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_cost_0_is_less(1) := (slice1winner3_best_cost_0(3) - slice1winner3_best_cost_0(2)) < 0;
    slice1winner4_best_cost_0(0) <= choice(slice1winner4_best_cost_0_is_less(0), slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0(0) <= choice(slice1winner4_best_cost_0_is_less(0), slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    slice1winner4_best_cost_0(1) <= choice(slice1winner4_best_cost_0_is_less(1), slice1winner3_best_cost_0(3),
      slice1winner3_best_cost_0(2));
    slice1winner4_best_index_0(1) <= choice(slice1winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice1winner3_best_index_0(2));
    -- slice1winner5
    slice1winner5_best_cost_0_0_is_less := (slice1winner4_best_cost_0(1) - slice1winner4_best_cost_0(0)) < 0;
    slice1winner5_best_cost_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice1winner4_best_cost_0(1),
      slice1winner4_best_cost_0(0));
    slice1winner5_best_index_0_0 <= choice(slice1winner5_best_cost_0_0_is_less, slice1winner4_best_index_0(1),
      slice1winner4_best_index_0(0));
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner5_best_cost_0_0) < 0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner5_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0,
      (((slice1winner5_best_index_0_0 / 2) + 75) * 2) + (slice1winner5_best_index_0_0 mod 2));
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice2shift_search(i, j) <= slice2shift_search(i, j + 1); end loop;
        slice2shift_search(i, 24) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    slice2shift_search_out(0) <= slice2shift_search(0, 0);
    slice2shift_search_out(1) <= slice2shift_search(1, 0);
    -- slice2cost
    for i in 0 to 11 loop
      slice2cost_column_0_choice(2 * i, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) mod 2048);
      slice2cost_column_0_choice(2 * i, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(2
        * i) + slice2cost_column_0_choice(2 * i, 1)) mod 2048);
      slice2cost_column_0_choice(2 * i + 1, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) / 2048);
      slice2cost_column_0_choice(2 * i + 1, 2) := choice(slice0window_entering_tag.border_column, 0,
        (slice2cost_change_0(2 * i + 1) + slice2cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice2cost_column_0_choice(24, 1) := choice(slice0window_entering_tag.first_group, 0, slice2cost_ready_words_12);
    slice2cost_column_0_choice(24, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(24) +
      slice2cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice2cost_pixels_first(0, i) <= slice2shift_search(0, i) - slice2shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice2cost_pixels_first(1, i) <= slice2shift_search(1, i) - slice2shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice2cost_pixels_cost(i, j) <= (folded(slice2cost_pixels_first(i, j)) + as_number((slice2cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice2cost_read_column <= slice1cost_read_column;
    slice2cost_change_column <= slice1cost_change_column;
    for i in 0 to 24 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice2cost_ready_words(i) <= to_integer(slice2cost_read_words(i)); end loop;
    slice2cost_ready_words_12 <= to_integer(slice2cost_read_words_12);
    slice2cost_ready_column <= slice0cost_write_column;
    for i in 0 to 24 loop slice2cost_column_0(i) <= slice2cost_column_0_choice(i, 2); end loop;
    if slice0window_entering_tag.valid then
      for i in 0 to 11 loop
        slice2cost_write_words(i) <= (slice2cost_column_0_choice(2 * i + 1, 2) * 2048) + slice2cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice2cost_write_words(12) <= slice2cost_column_0_choice(24, 2);
      slice2cost_write_column <= choice(slice0window_entering_tag.row_start, 0, (slice2cost_write_column + 1) mod 1024);
    end if;
    -- slice2window
    if slice0window_change_tag.valid then
      slice2window_ring_write_address <= slice2window_ring_read_address;
      slice2window_ring_read_address <= choice(slice2window_ring_read_address = 7, 0, (slice2window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice2window_change_0_choice(2 * i) := choice(slice1window_change_tag.leaves_window,
        to_integer(slice2window_leaving(i)(10 downto 0)), 0);
      slice2window_change_0_choice(2 * i + 1) := choice(slice1window_change_tag.leaves_window,
        to_integer(slice2window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice2window_change_0_choice(24) := choice(slice1window_change_tag.leaves_window,
      to_integer(slice2window_leaving_12), 0);
    slice2window_entering_0 <= slice2cost_column_0;
    for i in 0 to 24 loop
      slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
    end loop;
    slice2window_change_tag.first_group <= slice1window_change_tag.first_group;
    slice2window_change_tag.border_column <= slice1window_change_tag.border_column;
    slice2window_change_tag.leaves_window <= slice1window_change_tag.leaves_window;
    slice2window_centre_output_column_1 <= slice1window_centre_output_column_1;
    slice2window_centre_first_column_0 <= slice1window_centre_first_column_0;
    slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice2window_sum_0_choice(i) := choice(slice1window_centre_first_column_0, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag.valid then
      for i in 0 to 24 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice2winner1
    for i in 0 to 11 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
    end loop;
    slice2winner1_best_cost_0(12) <= slice2window_sum_0(24);
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    slice2winner1_best_cost_0(0) <= choice(slice2winner1_best_cost_0_is_less(0), slice2window_sum_0(1),
      slice2window_sum_0(0));
    for i in 1 to 11 loop
      slice2winner1_best_cost_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), slice2window_sum_0(2 * i + 1),
        slice2window_sum_0(2 * i));
      slice2winner1_best_index_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice2winner2
    for i in 0 to 5 loop
      slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner2_best_cost_0(6) <= slice2winner1_best_cost_0(12);
    slice2winner2_best_cost_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_cost_0(1),
      slice2winner1_best_cost_0(0));
    slice2winner2_best_index_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_index_0(1),
      as_number(slice2winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice2winner2_best_cost_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_cost_0(2 * i +
        1), slice2winner1_best_cost_0(2 * i));
      slice2winner2_best_index_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_index_0(2 * i +
        1), slice2winner1_best_index_0(2 * i));
    end loop;
    -- slice2winner3
    for i in 0 to 2 loop
      slice2winner3_best_cost_0_is_less(i) := (slice2winner2_best_cost_0(2 * i + 1) - slice2winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner3_best_cost_0(3) <= slice2winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice2winner3_best_cost_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_cost_0(2 * i +
        1), slice2winner2_best_cost_0(2 * i));
      slice2winner3_best_index_0(i) <= choice(slice2winner3_best_cost_0_is_less(i), slice2winner2_best_index_0(2 * i +
        1), slice2winner2_best_index_0(2 * i));
    end loop;
    -- slice2winner4
    slice2winner4_best_cost_0_is_less(0) := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_cost_0_is_less(1) := (slice2winner3_best_cost_0(3) - slice2winner3_best_cost_0(2)) < 0;
    slice2winner4_best_cost_0(0) <= choice(slice2winner4_best_cost_0_is_less(0), slice2winner3_best_cost_0(1),
      slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0(0) <= choice(slice2winner4_best_cost_0_is_less(0), slice2winner3_best_index_0(1),
      slice2winner3_best_index_0(0));
    slice2winner4_best_cost_0(1) <= choice(slice2winner4_best_cost_0_is_less(1), slice2winner3_best_cost_0(3),
      slice2winner3_best_cost_0(2));
    slice2winner4_best_index_0(1) <= choice(slice2winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice2winner3_best_index_0(2));
    -- slice2winner5
    slice2winner5_best_cost_0_0_is_less := (slice2winner4_best_cost_0(1) - slice2winner4_best_cost_0(0)) < 0;
    slice2winner5_best_cost_0_0 <= choice(slice2winner5_best_cost_0_0_is_less, slice2winner4_best_cost_0(1),
      slice2winner4_best_cost_0(0));
    slice2winner5_best_index_0_0 <= choice(slice2winner5_best_cost_0_0_is_less, slice2winner4_best_index_0(1),
      slice2winner4_best_index_0(0));
    -- slice2
    slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner5_best_cost_0_0) < 0;
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_cost_0_0, slice2winner5_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_index_0_0, slice2winner5_best_index_0_0 +
      125);
    -- slice3shift
    if slice0cost_pixels_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice3shift_search(i, j) <= slice3shift_search(i, j + 1); end loop;
        slice3shift_search(i, 24) <= slice2shift_search_out(i);
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    slice3shift_search_out(0) <= slice3shift_search(0, 0);
    slice3shift_search_out(1) <= slice3shift_search(1, 0);
    -- slice3cost
    for i in 0 to 11 loop
      slice3cost_column_0_choice(2 * i, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words(i)
        mod 2048);
      slice3cost_column_0_choice(2 * i, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(2 *
        i) + slice3cost_column_0_choice(2 * i, 1)) mod 2048);
      slice3cost_column_0_choice(2 * i + 1, 1) := choice(slice0window_change_tag.first_group, 0,
        slice3cost_ready_words(i) / 2048);
      slice3cost_column_0_choice(2 * i + 1, 2) := choice(slice0window_change_tag.border_column, 0,
        (slice3cost_change_0(2 * i + 1) + slice3cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice3cost_column_0_choice(24, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words_12);
    slice3cost_column_0_choice(24, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(24) +
      slice3cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice3cost_pixels_first(0, i) <= slice3shift_search(0, i) - slice3shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice3cost_pixels_first(1, i) <= slice3shift_search(1, i) - slice3shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice3cost_pixels_cost(i, j) <= (folded(slice3cost_pixels_first(i, j)) + as_number((slice3cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice3cost_change_column <= slice1cost_ready_column;
    for i in 0 to 24 loop
      slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice3cost_ready_words(i) <= to_integer(slice3cost_read_words(i)); end loop;
    slice3cost_ready_words_12 <= to_integer(slice3cost_read_words_12);
    slice3cost_ready_column <= slice1cost_write_column;
    for i in 0 to 24 loop slice3cost_column_0(i) <= slice3cost_column_0_choice(i, 2); end loop;
    slice3cost_write_column <= slice2cost_write_column;
    if slice0cost_ready_tag.valid then slice3cost_read_column <= slice2cost_read_column; end if;
    if slice0window_change_tag.valid then
      for i in 0 to 11 loop
        slice3cost_write_words(i) <= (slice3cost_column_0_choice(2 * i + 1, 2) * 2048) + slice3cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice3cost_write_words(12) <= slice3cost_column_0_choice(24, 2);
    end if;
    -- slice3window
    if slice0window_tag.valid then
      slice3window_ring_write_address <= slice3window_ring_read_address;
      slice3window_ring_read_address <= choice(slice3window_ring_read_address = 7, 0, (slice3window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice3window_change_0_choice(2 * i) := choice(slice2window_change_tag.leaves_window,
        to_integer(slice3window_leaving(i)(10 downto 0)), 0);
      slice3window_change_0_choice(2 * i + 1) := choice(slice2window_change_tag.leaves_window,
        to_integer(slice3window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice3window_change_0_choice(24) := choice(slice2window_change_tag.leaves_window,
      to_integer(slice3window_leaving_12), 0);
    slice3window_entering_0 <= slice3cost_column_0;
    for i in 0 to 24 loop
      slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
    end loop;
    slice3window_change_tag <= slice2window_change_tag;
    slice3window_centre_output_column_1 <= slice2window_centre_output_column_1;
    slice3window_centre_first_column_0 <= slice2window_centre_first_column_0;
    slice3window_centre_end_of_line_0 <= slice2window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice3window_sum_0_choice(i) := choice(slice2window_centre_first_column_0, 0, slice3window_sum_0(i));
    end loop;
    if slice0winner2_tag.valid then
      for i in 0 to 24 loop
        slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice3winner1
    for i in 0 to 11 loop
      slice3winner1_best_cost_0_is_less(i) := (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0;
    end loop;
    slice3winner1_best_cost_0(12) <= slice3window_sum_0(24);
    slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_is_less(0);
    slice3winner1_best_cost_0(0) <= choice(slice3winner1_best_cost_0_is_less(0), slice3window_sum_0(1),
      slice3window_sum_0(0));
    for i in 1 to 11 loop
      slice3winner1_best_cost_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), slice3window_sum_0(2 * i + 1),
        slice3window_sum_0(2 * i));
      slice3winner1_best_index_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice3winner2
    for i in 0 to 5 loop
      slice3winner2_best_cost_0_is_less(i) := (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner2_best_cost_0(6) <= slice3winner1_best_cost_0(12);
    slice3winner2_best_cost_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_cost_0(1),
      slice3winner1_best_cost_0(0));
    slice3winner2_best_index_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_index_0(1),
      as_number(slice3winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice3winner2_best_cost_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_cost_0(2 * i +
        1), slice3winner1_best_cost_0(2 * i));
      slice3winner2_best_index_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_index_0(2 * i +
        1), slice3winner1_best_index_0(2 * i));
    end loop;
    -- slice3winner3
    for i in 0 to 2 loop
      slice3winner3_best_cost_0_is_less(i) := (slice3winner2_best_cost_0(2 * i + 1) - slice3winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner3_best_cost_0(3) <= slice3winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice3winner3_best_cost_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_cost_0(2 * i +
        1), slice3winner2_best_cost_0(2 * i));
      slice3winner3_best_index_0(i) <= choice(slice3winner3_best_cost_0_is_less(i), slice3winner2_best_index_0(2 * i +
        1), slice3winner2_best_index_0(2 * i));
    end loop;
    -- slice3winner4
    slice3winner4_best_cost_0_is_less(0) := (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0;
    slice3winner4_best_cost_0_is_less(1) := (slice3winner3_best_cost_0(3) - slice3winner3_best_cost_0(2)) < 0;
    slice3winner4_best_cost_0(0) <= choice(slice3winner4_best_cost_0_is_less(0), slice3winner3_best_cost_0(1),
      slice3winner3_best_cost_0(0));
    slice3winner4_best_index_0(0) <= choice(slice3winner4_best_cost_0_is_less(0), slice3winner3_best_index_0(1),
      slice3winner3_best_index_0(0));
    slice3winner4_best_cost_0(1) <= choice(slice3winner4_best_cost_0_is_less(1), slice3winner3_best_cost_0(3),
      slice3winner3_best_cost_0(2));
    slice3winner4_best_index_0(1) <= choice(slice3winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice3winner3_best_index_0(2));
    -- slice3winner5
    slice3winner5_best_cost_0_0_is_less := (slice3winner4_best_cost_0(1) - slice3winner4_best_cost_0(0)) < 0;
    slice3winner5_best_cost_0_0 <= choice(slice3winner5_best_cost_0_0_is_less, slice3winner4_best_cost_0(1),
      slice3winner4_best_cost_0(0));
    slice3winner5_best_index_0_0 <= choice(slice3winner5_best_cost_0_0_is_less, slice3winner4_best_index_0(1),
      slice3winner4_best_index_0(0));
    -- slice3
    slice3_best_cost_0_0_is_less := (slice2_best_cost_0_0 - slice3winner5_best_cost_0_0) < 0;
    slice3_best_tag <= slice2_best_tag;
    slice3_best_cost_0_0 <= choice(slice3_best_cost_0_0_is_less, slice2_best_cost_0_0, slice3winner5_best_cost_0_0);
    slice3_best_index_0_0 <= choice(slice3_best_cost_0_0_is_less, slice2_best_index_0_0,
      (((slice3winner5_best_index_0_0 / 4) + 25) * 4) + (slice3winner5_best_index_0_0 mod 4));
    -- slice4shift
    if slice0cost_ready_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice4shift_search(i, j) <= slice4shift_search(i, j + 1); end loop;
        slice4shift_search(i, 24) <= slice3shift_search_out(i);
      end loop;
    end if;
    slice4shift_reference <= slice3shift_reference;
    slice4shift_search_out(0) <= slice4shift_search(0, 0);
    slice4shift_search_out(1) <= slice4shift_search(1, 0);
    -- slice4cost
    for i in 0 to 11 loop
      slice4cost_column_0_choice(2 * i, 1) := choice(slice1window_change_tag.first_group, 0, slice4cost_ready_words(i)
        mod 2048);
      slice4cost_column_0_choice(2 * i, 2) := choice(slice1window_change_tag.border_column, 0, (slice4cost_change_0(2 *
        i) + slice4cost_column_0_choice(2 * i, 1)) mod 2048);
      slice4cost_column_0_choice(2 * i + 1, 1) := choice(slice1window_change_tag.first_group, 0,
        slice4cost_ready_words(i) / 2048);
      slice4cost_column_0_choice(2 * i + 1, 2) := choice(slice1window_change_tag.border_column, 0,
        (slice4cost_change_0(2 * i + 1) + slice4cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice4cost_column_0_choice(24, 1) := choice(slice1window_change_tag.first_group, 0, slice4cost_ready_words_12);
    slice4cost_column_0_choice(24, 2) := choice(slice1window_change_tag.border_column, 0, (slice4cost_change_0(24) +
      slice4cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice4cost_pixels_first(0, i) <= slice4shift_search(0, i) - slice4shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice4cost_pixels_first(1, i) <= slice4shift_search(1, i) - slice4shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice4cost_pixels_cost(i, j) <= (folded(slice4cost_pixels_first(i, j)) + as_number((slice4cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice4cost_change_column <= slice2cost_ready_column;
    for i in 0 to 24 loop
      slice4cost_change_0(i) <= slice4cost_pixels_cost(1, i) - slice4cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice4cost_ready_words(i) <= to_integer(slice4cost_read_words(i)); end loop;
    slice4cost_ready_words_12 <= to_integer(slice4cost_read_words_12);
    slice4cost_ready_column <= slice3cost_ready_column;
    for i in 0 to 24 loop slice4cost_column_0(i) <= slice4cost_column_0_choice(i, 2); end loop;
    slice4cost_write_column <= slice3cost_write_column;
    if slice0cost_tag.valid then slice4cost_read_column <= slice2cost_change_column; end if;
    if slice0window_tag.valid then
      for i in 0 to 11 loop
        slice4cost_write_words(i) <= (slice4cost_column_0_choice(2 * i + 1, 2) * 2048) + slice4cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice4cost_write_words(12) <= slice4cost_column_0_choice(24, 2);
    end if;
    -- slice4window
    if slice0winner1_tag.valid then
      slice4window_ring_write_address <= slice4window_ring_read_address;
      slice4window_ring_read_address <= choice(slice4window_ring_read_address = 7, 0, (slice4window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice4window_change_0_choice(2 * i) := choice(slice3window_change_tag.leaves_window,
        to_integer(slice4window_leaving(i)(10 downto 0)), 0);
      slice4window_change_0_choice(2 * i + 1) := choice(slice3window_change_tag.leaves_window,
        to_integer(slice4window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice4window_change_0_choice(24) := choice(slice3window_change_tag.leaves_window,
      to_integer(slice4window_leaving_12), 0);
    slice4window_entering_0 <= slice4cost_column_0;
    for i in 0 to 24 loop
      slice4window_change_0(i) <= slice4window_entering_0(i) - slice4window_change_0_choice(i);
    end loop;
    slice4window_change_tag <= slice3window_change_tag;
    slice4window_centre_output_column_1 <= slice3window_centre_output_column_1;
    slice4window_centre_first_column_0 <= slice3window_centre_first_column_0;
    slice4window_centre_end_of_line_0 <= slice3window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice4window_sum_0_choice(i) := choice(slice3window_centre_first_column_0, 0, slice4window_sum_0(i));
    end loop;
    if slice0winner3_tag.valid then
      for i in 0 to 24 loop
        slice4window_sum_0(i) <= (slice4window_sum_0_choice(i) + slice4window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice4winner1
    for i in 0 to 11 loop
      slice4winner1_best_cost_0_is_less(i) := (slice4window_sum_0(2 * i + 1) - slice4window_sum_0(2 * i)) < 0;
    end loop;
    slice4winner1_best_cost_0(12) <= slice4window_sum_0(24);
    slice4winner1_best_index_0_0 <= slice4winner1_best_cost_0_is_less(0);
    slice4winner1_best_cost_0(0) <= choice(slice4winner1_best_cost_0_is_less(0), slice4window_sum_0(1),
      slice4window_sum_0(0));
    for i in 1 to 11 loop
      slice4winner1_best_cost_0(i) <= choice(slice4winner1_best_cost_0_is_less(i), slice4window_sum_0(2 * i + 1),
        slice4window_sum_0(2 * i));
      slice4winner1_best_index_0(i) <= choice(slice4winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice4winner2
    for i in 0 to 5 loop
      slice4winner2_best_cost_0_is_less(i) := (slice4winner1_best_cost_0(2 * i + 1) - slice4winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice4winner2_best_cost_0(6) <= slice4winner1_best_cost_0(12);
    slice4winner2_best_cost_0(0) <= choice(slice4winner2_best_cost_0_is_less(0), slice4winner1_best_cost_0(1),
      slice4winner1_best_cost_0(0));
    slice4winner2_best_index_0(0) <= choice(slice4winner2_best_cost_0_is_less(0), slice4winner1_best_index_0(1),
      as_number(slice4winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice4winner2_best_cost_0(i) <= choice(slice4winner2_best_cost_0_is_less(i), slice4winner1_best_cost_0(2 * i +
        1), slice4winner1_best_cost_0(2 * i));
      slice4winner2_best_index_0(i) <= choice(slice4winner2_best_cost_0_is_less(i), slice4winner1_best_index_0(2 * i +
        1), slice4winner1_best_index_0(2 * i));
    end loop;
    -- slice4winner3
    for i in 0 to 2 loop
      slice4winner3_best_cost_0_is_less(i) := (slice4winner2_best_cost_0(2 * i + 1) - slice4winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice4winner3_best_cost_0(3) <= slice4winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice4winner3_best_cost_0(i) <= choice(slice4winner3_best_cost_0_is_less(i), slice4winner2_best_cost_0(2 * i +
        1), slice4winner2_best_cost_0(2 * i));
      slice4winner3_best_index_0(i) <= choice(slice4winner3_best_cost_0_is_less(i), slice4winner2_best_index_0(2 * i +
        1), slice4winner2_best_index_0(2 * i));
    end loop;
    -- slice4winner4
    slice4winner4_best_cost_0_is_less(0) := (slice4winner3_best_cost_0(1) - slice4winner3_best_cost_0(0)) < 0;
    slice4winner4_best_cost_0_is_less(1) := (slice4winner3_best_cost_0(3) - slice4winner3_best_cost_0(2)) < 0;
    slice4winner4_best_cost_0(0) <= choice(slice4winner4_best_cost_0_is_less(0), slice4winner3_best_cost_0(1),
      slice4winner3_best_cost_0(0));
    slice4winner4_best_index_0(0) <= choice(slice4winner4_best_cost_0_is_less(0), slice4winner3_best_index_0(1),
      slice4winner3_best_index_0(0));
    slice4winner4_best_cost_0(1) <= choice(slice4winner4_best_cost_0_is_less(1), slice4winner3_best_cost_0(3),
      slice4winner3_best_cost_0(2));
    slice4winner4_best_index_0(1) <= choice(slice4winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice4winner3_best_index_0(2));
    -- slice4winner5
    slice4winner5_best_cost_0_0_is_less := (slice4winner4_best_cost_0(1) - slice4winner4_best_cost_0(0)) < 0;
    slice4winner5_best_cost_0_0 <= choice(slice4winner5_best_cost_0_0_is_less, slice4winner4_best_cost_0(1),
      slice4winner4_best_cost_0(0));
    slice4winner5_best_index_0_0 <= choice(slice4winner5_best_cost_0_0_is_less, slice4winner4_best_index_0(1),
      slice4winner4_best_index_0(0));
    -- slice4
    slice4_best_cost_0_0_is_less := (slice3_best_cost_0_0 - slice4winner5_best_cost_0_0) < 0;
    slice4_best_tag <= slice3_best_tag;
    slice4_best_cost_0_0 <= choice(slice4_best_cost_0_0_is_less, slice3_best_cost_0_0, slice4winner5_best_cost_0_0);
    slice4_best_index_0_0 <= choice(slice4_best_cost_0_0_is_less, slice3_best_index_0_0, slice4winner5_best_index_0_0 +
      75);
    -- slice5shift
    if slice0cost_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice5shift_search(i, j) <= slice5shift_search(i, j + 1); end loop;
        slice5shift_search(i, 24) <= slice4shift_search_out(i);
      end loop;
    end if;
    slice5shift_reference <= slice4shift_reference;
    slice5shift_search_out(0) <= slice5shift_search(0, 0);
    slice5shift_search_out(1) <= slice5shift_search(1, 0);
    -- slice5cost
    for i in 0 to 11 loop
      slice5cost_column_0_choice(2 * i, 1) := choice(slice2window_change_tag.first_group, 0, slice5cost_ready_words(i)
        mod 2048);
      slice5cost_column_0_choice(2 * i, 2) := choice(slice2window_change_tag.border_column, 0, (slice5cost_change_0(2 *
        i) + slice5cost_column_0_choice(2 * i, 1)) mod 2048);
      slice5cost_column_0_choice(2 * i + 1, 1) := choice(slice2window_change_tag.first_group, 0,
        slice5cost_ready_words(i) / 2048);
      slice5cost_column_0_choice(2 * i + 1, 2) := choice(slice2window_change_tag.border_column, 0,
        (slice5cost_change_0(2 * i + 1) + slice5cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice5cost_column_0_choice(24, 1) := choice(slice2window_change_tag.first_group, 0, slice5cost_ready_words_12);
    slice5cost_column_0_choice(24, 2) := choice(slice2window_change_tag.border_column, 0, (slice5cost_change_0(24) +
      slice5cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice5cost_pixels_first(0, i) <= slice5shift_search(0, i) - slice5shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice5cost_pixels_first(1, i) <= slice5shift_search(1, i) - slice5shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice5cost_pixels_cost(i, j) <= (folded(slice5cost_pixels_first(i, j)) + as_number((slice5cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop
      slice5cost_change_0(i) <= slice5cost_pixels_cost(1, i) - slice5cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice5cost_ready_words(i) <= to_integer(slice5cost_read_words(i)); end loop;
    slice5cost_ready_words_12 <= to_integer(slice5cost_read_words_12);
    for i in 0 to 24 loop slice5cost_column_0(i) <= slice5cost_column_0_choice(i, 2); end loop;
    if slice0window_entering_tag.valid then slice5cost_read_column <= slice3cost_change_column; end if;
    if slice0window_change_tag.valid then slice5cost_change_column <= slice4cost_change_column; end if;
    if slice0window_tag.valid then slice5cost_ready_column <= slice4cost_ready_column; end if;
    if slice0winner1_tag.valid then
      slice5cost_write_column <= slice4cost_write_column;
      for i in 0 to 11 loop
        slice5cost_write_words(i) <= (slice5cost_column_0_choice(2 * i + 1, 2) * 2048) + slice5cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice5cost_write_words(12) <= slice5cost_column_0_choice(24, 2);
    end if;
    -- slice5window
    if slice0winner2_tag.valid then
      slice5window_ring_write_address <= slice5window_ring_read_address;
      slice5window_ring_read_address <= choice(slice5window_ring_read_address = 7, 0, (slice5window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice5window_change_0_choice(2 * i) := choice(slice4window_change_tag.leaves_window,
        to_integer(slice5window_leaving(i)(10 downto 0)), 0);
      slice5window_change_0_choice(2 * i + 1) := choice(slice4window_change_tag.leaves_window,
        to_integer(slice5window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice5window_change_0_choice(24) := choice(slice4window_change_tag.leaves_window,
      to_integer(slice5window_leaving_12), 0);
    slice5window_entering_0 <= slice5cost_column_0;
    for i in 0 to 24 loop
      slice5window_change_0(i) <= slice5window_entering_0(i) - slice5window_change_0_choice(i);
    end loop;
    slice5window_change_tag_leaves_window <= slice4window_change_tag.leaves_window;
    slice5window_centre_output_column_1 <= slice4window_centre_output_column_1;
    slice5window_centre_first_column_0 <= slice4window_centre_first_column_0;
    slice5window_centre_end_of_line_0 <= slice4window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice5window_sum_0_choice(i) := choice(slice4window_centre_first_column_0, 0, slice5window_sum_0(i));
    end loop;
    if slice0winner4_tag.valid then
      for i in 0 to 24 loop
        slice5window_sum_0(i) <= (slice5window_sum_0_choice(i) + slice5window_change_0(i)) mod 16384;
      end loop;
    end if;
    -- slice5winner1
    for i in 0 to 11 loop
      slice5winner1_best_cost_0_is_less(i) := (slice5window_sum_0(2 * i + 1) - slice5window_sum_0(2 * i)) < 0;
    end loop;
    slice5winner1_best_cost_0(12) <= slice5window_sum_0(24);
    slice5winner1_best_index_0_0 <= slice5winner1_best_cost_0_is_less(0);
    slice5winner1_best_cost_0(0) <= choice(slice5winner1_best_cost_0_is_less(0), slice5window_sum_0(1),
      slice5window_sum_0(0));
    for i in 1 to 11 loop
      slice5winner1_best_cost_0(i) <= choice(slice5winner1_best_cost_0_is_less(i), slice5window_sum_0(2 * i + 1),
        slice5window_sum_0(2 * i));
      slice5winner1_best_index_0(i) <= choice(slice5winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice5winner2
    for i in 0 to 5 loop
      slice5winner2_best_cost_0_is_less(i) := (slice5winner1_best_cost_0(2 * i + 1) - slice5winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice5winner2_best_cost_0(6) <= slice5winner1_best_cost_0(12);
    slice5winner2_best_cost_0(0) <= choice(slice5winner2_best_cost_0_is_less(0), slice5winner1_best_cost_0(1),
      slice5winner1_best_cost_0(0));
    slice5winner2_best_index_0(0) <= choice(slice5winner2_best_cost_0_is_less(0), slice5winner1_best_index_0(1),
      as_number(slice5winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice5winner2_best_cost_0(i) <= choice(slice5winner2_best_cost_0_is_less(i), slice5winner1_best_cost_0(2 * i +
        1), slice5winner1_best_cost_0(2 * i));
      slice5winner2_best_index_0(i) <= choice(slice5winner2_best_cost_0_is_less(i), slice5winner1_best_index_0(2 * i +
        1), slice5winner1_best_index_0(2 * i));
    end loop;
    -- slice5winner3
    for i in 0 to 2 loop
      slice5winner3_best_cost_0_is_less(i) := (slice5winner2_best_cost_0(2 * i + 1) - slice5winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice5winner3_best_cost_0(3) <= slice5winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice5winner3_best_cost_0(i) <= choice(slice5winner3_best_cost_0_is_less(i), slice5winner2_best_cost_0(2 * i +
        1), slice5winner2_best_cost_0(2 * i));
      slice5winner3_best_index_0(i) <= choice(slice5winner3_best_cost_0_is_less(i), slice5winner2_best_index_0(2 * i +
        1), slice5winner2_best_index_0(2 * i));
    end loop;
    -- slice5winner4
    slice5winner4_best_cost_0_is_less(0) := (slice5winner3_best_cost_0(1) - slice5winner3_best_cost_0(0)) < 0;
    slice5winner4_best_cost_0_is_less(1) := (slice5winner3_best_cost_0(3) - slice5winner3_best_cost_0(2)) < 0;
    slice5winner4_best_cost_0(0) <= choice(slice5winner4_best_cost_0_is_less(0), slice5winner3_best_cost_0(1),
      slice5winner3_best_cost_0(0));
    slice5winner4_best_index_0(0) <= choice(slice5winner4_best_cost_0_is_less(0), slice5winner3_best_index_0(1),
      slice5winner3_best_index_0(0));
    slice5winner4_best_cost_0(1) <= choice(slice5winner4_best_cost_0_is_less(1), slice5winner3_best_cost_0(3),
      slice5winner3_best_cost_0(2));
    slice5winner4_best_index_0(1) <= choice(slice5winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice5winner3_best_index_0(2));
    -- slice5winner5
    slice5winner5_best_cost_0_0_is_less := (slice5winner4_best_cost_0(1) - slice5winner4_best_cost_0(0)) < 0;
    slice5winner5_best_cost_0_0 <= choice(slice5winner5_best_cost_0_0_is_less, slice5winner4_best_cost_0(1),
      slice5winner4_best_cost_0(0));
    slice5winner5_best_index_0_0 <= choice(slice5winner5_best_cost_0_0_is_less, slice5winner4_best_index_0(1),
      slice5winner4_best_index_0(0));
    -- slice5
    slice5_best_cost_0_0_is_less := (slice4_best_cost_0_0 - slice5winner5_best_cost_0_0) < 0;
    slice5_best_tag <= slice4_best_tag;
    slice5_best_cost_0_0 <= choice(slice5_best_cost_0_0_is_less, slice4_best_cost_0_0, slice5winner5_best_cost_0_0);
    slice5_best_index_0_0 <= choice(slice5_best_cost_0_0_is_less, slice4_best_index_0_0,
      (((slice5winner5_best_index_0_0 / 2) + 25) * 2) + (slice5winner5_best_index_0_0 mod 2));
    -- slice6shift
    if slice0window_entering_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice6shift_search(i, j) <= slice6shift_search(i, j + 1); end loop;
        slice6shift_search(i, 24) <= slice5shift_search_out(i);
      end loop;
    end if;
    slice6shift_reference <= slice5shift_reference;
    slice6shift_search_out(0) <= slice6shift_search(0, 0);
    slice6shift_search_out(1) <= slice6shift_search(1, 0);
    -- slice6cost
    for i in 0 to 11 loop
      slice6cost_column_0_choice(2 * i, 1) := choice(slice3window_change_tag.first_group, 0, slice6cost_ready_words(i)
        mod 2048);
      slice6cost_column_0_choice(2 * i, 2) := choice(slice3window_change_tag.border_column, 0, (slice6cost_change_0(2 *
        i) + slice6cost_column_0_choice(2 * i, 1)) mod 2048);
      slice6cost_column_0_choice(2 * i + 1, 1) := choice(slice3window_change_tag.first_group, 0,
        slice6cost_ready_words(i) / 2048);
      slice6cost_column_0_choice(2 * i + 1, 2) := choice(slice3window_change_tag.border_column, 0,
        (slice6cost_change_0(2 * i + 1) + slice6cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice6cost_column_0_choice(24, 1) := choice(slice3window_change_tag.first_group, 0, slice6cost_ready_words_12);
    slice6cost_column_0_choice(24, 2) := choice(slice3window_change_tag.border_column, 0, (slice6cost_change_0(24) +
      slice6cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice6cost_pixels_first(0, i) <= slice6shift_search(0, i) - slice6shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice6cost_pixels_first(1, i) <= slice6shift_search(1, i) - slice6shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice6cost_pixels_cost(i, j) <= (folded(slice6cost_pixels_first(i, j)) + as_number((slice6cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    for i in 0 to 24 loop
      slice6cost_change_0(i) <= slice6cost_pixels_cost(1, i) - slice6cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice6cost_ready_words(i) <= to_integer(slice6cost_read_words(i)); end loop;
    slice6cost_ready_words_12 <= to_integer(slice6cost_read_words_12);
    slice6cost_ready_column <= slice6cost_change_column;
    for i in 0 to 24 loop slice6cost_column_0(i) <= slice6cost_column_0_choice(i, 2); end loop;
    slice6cost_write_column <= slice6cost_ready_column;
    if slice0window_change_tag.valid then
      slice6cost_read_column <= choice(slice0window_change_tag.row_start, 0, (slice6cost_read_column + 1) mod 1024);
    end if;
    if slice0window_tag.valid then
      slice6cost_change_column <= choice(slice1window_change_tag.row_start, 0, (slice6cost_change_column + 1) mod 1024);
    end if;
    if slice0winner2_tag.valid then
      for i in 0 to 11 loop
        slice6cost_write_words(i) <= (slice6cost_column_0_choice(2 * i + 1, 2) * 2048) + slice6cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice6cost_write_words(12) <= slice6cost_column_0_choice(24, 2);
    end if;
    -- slice6window
    if slice0winner3_tag.valid then
      slice6window_ring_write_address <= slice6window_ring_read_address;
      slice6window_ring_read_address <= choice(slice6window_ring_read_address = 7, 0, (slice6window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice6window_change_0_choice(2 * i) := choice(slice5window_change_tag_leaves_window,
        to_integer(slice6window_leaving(i)(10 downto 0)), 0);
      slice6window_change_0_choice(2 * i + 1) := choice(slice5window_change_tag_leaves_window,
        to_integer(slice6window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice6window_change_0_choice(24) := choice(slice5window_change_tag_leaves_window,
      to_integer(slice6window_leaving_12), 0);
    slice6window_entering_0 <= slice6cost_column_0;
    for i in 0 to 24 loop
      slice6window_change_0(i) <= slice6window_entering_0(i) - slice6window_change_0_choice(i);
    end loop;
    slice6window_change_tag_leaves_window <= slice5window_change_tag_leaves_window;
    slice6window_centre_first_column_0 <= slice5window_centre_first_column_0;
    slice6window_centre_end_of_line_0 <= slice5window_centre_end_of_line_0;
    for i in 0 to 24 loop
      slice6window_sum_0_choice(i) := choice(slice5window_centre_first_column_0, 0, slice6window_sum_0(i));
    end loop;
    if slice0winner5_tag.valid then
      for i in 0 to 24 loop
        slice6window_sum_0(i) <= (slice6window_sum_0_choice(i) + slice6window_change_0(i)) mod 16384;
      end loop;
    end if;
    if slice0_best_tag.valid then slice6window_centre_output_column_1 <= slice5window_centre_output_column_1; end if;
    -- slice6winner1
    for i in 0 to 11 loop
      slice6winner1_best_cost_0_is_less(i) := (slice6window_sum_0(2 * i + 1) - slice6window_sum_0(2 * i)) < 0;
    end loop;
    slice6winner1_best_cost_0(12) <= slice6window_sum_0(24);
    slice6winner1_best_index_0_0 <= slice6winner1_best_cost_0_is_less(0);
    slice6winner1_best_cost_0(0) <= choice(slice6winner1_best_cost_0_is_less(0), slice6window_sum_0(1),
      slice6window_sum_0(0));
    for i in 1 to 11 loop
      slice6winner1_best_cost_0(i) <= choice(slice6winner1_best_cost_0_is_less(i), slice6window_sum_0(2 * i + 1),
        slice6window_sum_0(2 * i));
      slice6winner1_best_index_0(i) <= choice(slice6winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice6winner2
    for i in 0 to 5 loop
      slice6winner2_best_cost_0_is_less(i) := (slice6winner1_best_cost_0(2 * i + 1) - slice6winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice6winner2_best_cost_0(6) <= slice6winner1_best_cost_0(12);
    slice6winner2_best_cost_0(0) <= choice(slice6winner2_best_cost_0_is_less(0), slice6winner1_best_cost_0(1),
      slice6winner1_best_cost_0(0));
    slice6winner2_best_index_0(0) <= choice(slice6winner2_best_cost_0_is_less(0), slice6winner1_best_index_0(1),
      as_number(slice6winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice6winner2_best_cost_0(i) <= choice(slice6winner2_best_cost_0_is_less(i), slice6winner1_best_cost_0(2 * i +
        1), slice6winner1_best_cost_0(2 * i));
      slice6winner2_best_index_0(i) <= choice(slice6winner2_best_cost_0_is_less(i), slice6winner1_best_index_0(2 * i +
        1), slice6winner1_best_index_0(2 * i));
    end loop;
    -- slice6winner3
    for i in 0 to 2 loop
      slice6winner3_best_cost_0_is_less(i) := (slice6winner2_best_cost_0(2 * i + 1) - slice6winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice6winner3_best_cost_0(3) <= slice6winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice6winner3_best_cost_0(i) <= choice(slice6winner3_best_cost_0_is_less(i), slice6winner2_best_cost_0(2 * i +
        1), slice6winner2_best_cost_0(2 * i));
      slice6winner3_best_index_0(i) <= choice(slice6winner3_best_cost_0_is_less(i), slice6winner2_best_index_0(2 * i +
        1), slice6winner2_best_index_0(2 * i));
    end loop;
    -- slice6winner4
    slice6winner4_best_cost_0_is_less(0) := (slice6winner3_best_cost_0(1) - slice6winner3_best_cost_0(0)) < 0;
    slice6winner4_best_cost_0_is_less(1) := (slice6winner3_best_cost_0(3) - slice6winner3_best_cost_0(2)) < 0;
    slice6winner4_best_cost_0(0) <= choice(slice6winner4_best_cost_0_is_less(0), slice6winner3_best_cost_0(1),
      slice6winner3_best_cost_0(0));
    slice6winner4_best_index_0(0) <= choice(slice6winner4_best_cost_0_is_less(0), slice6winner3_best_index_0(1),
      slice6winner3_best_index_0(0));
    slice6winner4_best_cost_0(1) <= choice(slice6winner4_best_cost_0_is_less(1), slice6winner3_best_cost_0(3),
      slice6winner3_best_cost_0(2));
    slice6winner4_best_index_0(1) <= choice(slice6winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice6winner3_best_index_0(2));
    -- slice6winner5
    slice6winner5_best_cost_0_0_is_less := (slice6winner4_best_cost_0(1) - slice6winner4_best_cost_0(0)) < 0;
    slice6winner5_best_cost_0_0 <= choice(slice6winner5_best_cost_0_0_is_less, slice6winner4_best_cost_0(1),
      slice6winner4_best_cost_0(0));
    slice6winner5_best_index_0_0 <= choice(slice6winner5_best_cost_0_0_is_less, slice6winner4_best_index_0(1),
      slice6winner4_best_index_0(0));
    -- slice6
    slice6_best_cost_0_0_is_less := (slice5_best_cost_0_0 - slice6winner5_best_cost_0_0) < 0;
    slice6_best_tag <= slice5_best_tag;
    slice6_best_cost_0_0 <= choice(slice6_best_cost_0_0_is_less, slice5_best_cost_0_0, slice6winner5_best_cost_0_0);
    slice6_best_index_0_0 <= choice(slice6_best_cost_0_0_is_less, slice5_best_index_0_0, slice6winner5_best_index_0_0 +
      25);
    -- slice7shift
    if slice0window_change_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 23 loop slice7shift_search(i, j) <= slice7shift_search(i, j + 1); end loop;
        slice7shift_search(i, 24) <= slice6shift_search_out(i);
      end loop;
    end if;
    slice7shift_reference <= slice6shift_reference;
    -- slice7cost
    for i in 0 to 11 loop
      slice7cost_column_0_choice(2 * i, 1) := choice(slice4window_change_tag.first_group, 0, slice7cost_ready_words(i)
        mod 2048);
      slice7cost_column_0_choice(2 * i, 2) := choice(slice4window_change_tag.border_column, 0, (slice7cost_change_0(2 *
        i) + slice7cost_column_0_choice(2 * i, 1)) mod 2048);
      slice7cost_column_0_choice(2 * i + 1, 1) := choice(slice4window_change_tag.first_group, 0,
        slice7cost_ready_words(i) / 2048);
      slice7cost_column_0_choice(2 * i + 1, 2) := choice(slice4window_change_tag.border_column, 0,
        (slice7cost_change_0(2 * i + 1) + slice7cost_column_0_choice(2 * i + 1, 1)) mod 2048);
    end loop;
    slice7cost_column_0_choice(24, 1) := choice(slice4window_change_tag.first_group, 0, slice7cost_ready_words_12);
    slice7cost_column_0_choice(24, 2) := choice(slice4window_change_tag.border_column, 0, (slice7cost_change_0(24) +
      slice7cost_column_0_choice(24, 1)) mod 2048);
    for i in 0 to 24 loop
      slice7cost_pixels_first(0, i) <= slice7shift_search(0, i) - slice7shift_reference(0);
    end loop;
    for i in 0 to 24 loop
      slice7cost_pixels_first(1, i) <= slice7shift_search(1, i) - slice7shift_reference(1);
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 24 loop
        slice7cost_pixels_cost(i, j) <= (folded(slice7cost_pixels_first(i, j)) + as_number((slice7cost_pixels_first(i,
          j) < 0))) mod 256;
      end loop;
    end loop;
    slice7cost_read_column <= slice6cost_read_column;
    slice7cost_change_column <= slice7cost_read_column;
    for i in 0 to 24 loop
      slice7cost_change_0(i) <= slice7cost_pixels_cost(1, i) - slice7cost_pixels_cost(0, i);
    end loop;
    for i in 0 to 11 loop slice7cost_ready_words(i) <= to_integer(slice7cost_read_words(i)); end loop;
    slice7cost_ready_words_12 <= to_integer(slice7cost_read_words_12);
    for i in 0 to 24 loop slice7cost_column_0(i) <= slice7cost_column_0_choice(i, 2); end loop;
    if slice0winner2_tag.valid then slice7cost_ready_column <= slice7cost_change_column; end if;
    if slice0winner3_tag.valid then
      slice7cost_write_column <= slice6cost_write_column;
      for i in 0 to 11 loop
        slice7cost_write_words(i) <= (slice7cost_column_0_choice(2 * i + 1, 2) * 2048) + slice7cost_column_0_choice(2 *
          i, 2);
      end loop;
      slice7cost_write_words(12) <= slice7cost_column_0_choice(24, 2);
    end if;
    -- slice7window
    if slice0winner4_tag.valid then
      slice7window_ring_write_address <= slice7window_ring_read_address;
      slice7window_ring_read_address <= choice(slice7window_ring_read_address = 7, 0, (slice7window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 11 loop
      slice7window_change_0_choice(2 * i) := choice(slice6window_change_tag_leaves_window,
        to_integer(slice7window_leaving(i)(10 downto 0)), 0);
      slice7window_change_0_choice(2 * i + 1) := choice(slice6window_change_tag_leaves_window,
        to_integer(slice7window_leaving(i)(21 downto 11)), 0);
    end loop;
    slice7window_change_0_choice(24) := choice(slice6window_change_tag_leaves_window,
      to_integer(slice7window_leaving_12), 0);
    slice7window_entering_0 <= slice7cost_column_0;
    for i in 0 to 24 loop
      slice7window_change_0(i) <= slice7window_entering_0(i) - slice7window_change_0_choice(i);
    end loop;
    for i in 0 to 24 loop
      slice7window_sum_0_choice(i) := choice(slice6window_centre_first_column_0, 0, slice7window_sum_0(i));
    end loop;
    if slice0_best_tag.valid then
      for i in 0 to 24 loop
        slice7window_sum_0(i) <= (slice7window_sum_0_choice(i) + slice7window_change_0(i)) mod 16384;
      end loop;
      slice7window_centre_output_column_1 <= slice6window_centre_output_column_1;
      slice7window_centre_end_of_line(0) <= slice6window_centre_end_of_line_0;
      slice7window_centre_end_of_line(1) <= slice7window_centre_end_of_line(0);
    end if;
    -- slice7winner1
    for i in 0 to 11 loop
      slice7winner1_best_cost_0_is_less(i) := (slice7window_sum_0(2 * i + 1) - slice7window_sum_0(2 * i)) < 0;
    end loop;
    slice7winner1_best_cost_0(12) <= slice7window_sum_0(24);
    slice7winner1_best_index_0_0 <= slice7winner1_best_cost_0_is_less(0);
    slice7winner1_best_cost_0(0) <= choice(slice7winner1_best_cost_0_is_less(0), slice7window_sum_0(1),
      slice7window_sum_0(0));
    for i in 1 to 11 loop
      slice7winner1_best_cost_0(i) <= choice(slice7winner1_best_cost_0_is_less(i), slice7window_sum_0(2 * i + 1),
        slice7window_sum_0(2 * i));
      slice7winner1_best_index_0(i) <= choice(slice7winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice7winner2
    for i in 0 to 5 loop
      slice7winner2_best_cost_0_is_less(i) := (slice7winner1_best_cost_0(2 * i + 1) - slice7winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice7winner2_best_cost_0(6) <= slice7winner1_best_cost_0(12);
    slice7winner2_best_cost_0(0) <= choice(slice7winner2_best_cost_0_is_less(0), slice7winner1_best_cost_0(1),
      slice7winner1_best_cost_0(0));
    slice7winner2_best_index_0(0) <= choice(slice7winner2_best_cost_0_is_less(0), slice7winner1_best_index_0(1),
      as_number(slice7winner1_best_index_0_0));
    for i in 1 to 5 loop
      slice7winner2_best_cost_0(i) <= choice(slice7winner2_best_cost_0_is_less(i), slice7winner1_best_cost_0(2 * i +
        1), slice7winner1_best_cost_0(2 * i));
      slice7winner2_best_index_0(i) <= choice(slice7winner2_best_cost_0_is_less(i), slice7winner1_best_index_0(2 * i +
        1), slice7winner1_best_index_0(2 * i));
    end loop;
    -- slice7winner3
    for i in 0 to 2 loop
      slice7winner3_best_cost_0_is_less(i) := (slice7winner2_best_cost_0(2 * i + 1) - slice7winner2_best_cost_0(2 * i))
        < 0;
    end loop;
    slice7winner3_best_cost_0(3) <= slice7winner2_best_cost_0(6);
    for i in 0 to 2 loop
      slice7winner3_best_cost_0(i) <= choice(slice7winner3_best_cost_0_is_less(i), slice7winner2_best_cost_0(2 * i +
        1), slice7winner2_best_cost_0(2 * i));
      slice7winner3_best_index_0(i) <= choice(slice7winner3_best_cost_0_is_less(i), slice7winner2_best_index_0(2 * i +
        1), slice7winner2_best_index_0(2 * i));
    end loop;
    -- slice7winner4
    slice7winner4_best_cost_0_is_less(0) := (slice7winner3_best_cost_0(1) - slice7winner3_best_cost_0(0)) < 0;
    slice7winner4_best_cost_0_is_less(1) := (slice7winner3_best_cost_0(3) - slice7winner3_best_cost_0(2)) < 0;
    slice7winner4_best_cost_0(0) <= choice(slice7winner4_best_cost_0_is_less(0), slice7winner3_best_cost_0(1),
      slice7winner3_best_cost_0(0));
    slice7winner4_best_index_0(0) <= choice(slice7winner4_best_cost_0_is_less(0), slice7winner3_best_index_0(1),
      slice7winner3_best_index_0(0));
    slice7winner4_best_cost_0(1) <= choice(slice7winner4_best_cost_0_is_less(1), slice7winner3_best_cost_0(3),
      slice7winner3_best_cost_0(2));
    slice7winner4_best_index_0(1) <= choice(slice7winner4_best_cost_0_is_less(1), slice0winner3_best_index_0(3),
      slice7winner3_best_index_0(2));
    -- slice7winner5
    slice7winner5_best_cost_0_0_is_less := (slice7winner4_best_cost_0(1) - slice7winner4_best_cost_0(0)) < 0;
    slice7winner5_best_cost_0_0 <= choice(slice7winner5_best_cost_0_0_is_less, slice7winner4_best_cost_0(1),
      slice7winner4_best_cost_0(0));
    slice7winner5_best_index_0_0 <= choice(slice7winner5_best_cost_0_0_is_less, slice7winner4_best_index_0(1),
      slice7winner4_best_index_0(0));
    -- slice7
    slice7_best_tag <= slice6_best_tag;
    slice7_best_index_0_0 <= choice((slice6_best_cost_0_0 - slice7winner5_best_cost_0_0) < 0, slice6_best_index_0_0,
      slice7winner5_best_index_0_0);
    if reset = '1' then
      raster_features_valid <= false; raster_place_column <= 0; raster_place_group <= 483; delay_ring_read_address <= 1;
      delay_ring_write_address <= 0; delay_column <= 0; delay_tag.valid <= false; delay_tag.row_start <= false;
      delay_tag.output_column <= false; delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false;
      rows_read_column <= 0; rows_read_tag.valid <= false; rows_read_tag.row_start <= false;
      rows_read_tag.output_column <= false; rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false;
      rows_ready_column <= 0; rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false;
      rows_ready_tag.output_column <= false; rows_ready_tag.start_of_frame <= false;
      rows_ready_tag.end_of_line <= false; rows_write_column <= 0; rows_tag.valid <= false; rows_tag.row_start <= false;
      rows_tag.output_column <= false; rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false;
      slice0shift_tag.valid <= false; slice0shift_tag.row_start <= false; slice0shift_tag.output_column <= false;
      slice0shift_tag.start_of_frame <= false; slice0shift_tag.end_of_line <= false;
      slice0cost_pixels_first_tag.valid <= false; slice0cost_pixels_first_tag.row_start <= false;
      slice0cost_pixels_first_tag.output_column <= false; slice0cost_pixels_first_tag.start_of_frame <= false;
      slice0cost_pixels_first_tag.end_of_line <= false; slice0cost_pixels_tag.valid <= false;
      slice0cost_pixels_tag.row_start <= false; slice0cost_pixels_tag.output_column <= false;
      slice0cost_pixels_tag.start_of_frame <= false; slice0cost_pixels_tag.end_of_line <= false;
      slice0cost_read_column <= 0; slice0cost_change_column <= 0; slice0cost_ready_column <= 0;
      slice0cost_ready_tag.valid <= false; slice0cost_ready_tag.row_start <= false;
      slice0cost_ready_tag.output_column <= false; slice0cost_ready_tag.start_of_frame <= false;
      slice0cost_ready_tag.end_of_line <= false; slice0cost_write_column <= 0; slice0cost_tag.valid <= false;
      slice0cost_tag.row_start <= false; slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_tag.valid <= false; slice0window_entering_tag.row_start <= false;
      slice0window_entering_tag.output_column <= false; slice0window_entering_tag.start_of_frame <= false;
      slice0window_entering_tag.end_of_line <= false; slice0window_change_tag.valid <= false;
      slice0window_change_tag.row_start <= false; slice0window_change_tag.output_column <= false;
      slice0window_change_tag.start_of_frame <= false; slice0window_change_tag.end_of_line <= false;
      slice0window_centre_output_column <= (others => false); slice0window_centre_start_of_frame <= (others => false);
      slice0window_centre_end_of_line_0 <= false; slice0window_tag <= (others => false);
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0winner4_tag <= (others => false);
      slice0winner5_tag <= (others => false); slice0_best_tag <= (others => false); slice1cost_read_column <= 0;
      slice1cost_change_column <= 0; slice1cost_ready_column <= 0; slice1cost_write_column <= 0;
      slice1window_ring_read_address <= 1; slice1window_ring_write_address <= 0;
      slice1window_change_tag.row_start <= false; slice1window_centre_output_column_1 <= false;
      slice1window_centre_end_of_line_0 <= false; slice1_best_tag <= (others => false); slice2cost_read_column <= 0;
      slice2cost_change_column <= 0; slice2cost_ready_column <= 0; slice2cost_write_column <= 0;
      slice2window_ring_read_address <= 1; slice2window_ring_write_address <= 0;
      slice2window_centre_output_column_1 <= false; slice2window_centre_end_of_line_0 <= false;
      slice2_best_tag <= (others => false); slice3cost_read_column <= 0; slice3cost_change_column <= 0;
      slice3cost_ready_column <= 0; slice3cost_write_column <= 0; slice3window_ring_read_address <= 1;
      slice3window_ring_write_address <= 0; slice3window_centre_output_column_1 <= false;
      slice3window_centre_end_of_line_0 <= false; slice3_best_tag <= (others => false); slice4cost_read_column <= 0;
      slice4cost_change_column <= 0; slice4cost_ready_column <= 0; slice4cost_write_column <= 0;
      slice4window_ring_read_address <= 1; slice4window_ring_write_address <= 0;
      slice4window_centre_output_column_1 <= false; slice4window_centre_end_of_line_0 <= false;
      slice4_best_tag <= (others => false); slice5cost_read_column <= 0; slice5cost_change_column <= 0;
      slice5cost_ready_column <= 0; slice5cost_write_column <= 0; slice5window_ring_read_address <= 1;
      slice5window_ring_write_address <= 0; slice5window_centre_output_column_1 <= false;
      slice5window_centre_end_of_line_0 <= false; slice5_best_tag <= (others => false); slice6cost_read_column <= 0;
      slice6cost_change_column <= 0; slice6cost_ready_column <= 0; slice6cost_write_column <= 0;
      slice6window_ring_read_address <= 1; slice6window_ring_write_address <= 0;
      slice6window_centre_output_column_1 <= false; slice6window_centre_end_of_line_0 <= false;
      slice6_best_tag <= (others => false); slice7cost_read_column <= 0; slice7cost_change_column <= 0;
      slice7cost_ready_column <= 0; slice7cost_write_column <= 0; slice7window_ring_read_address <= 1;
      slice7window_ring_write_address <= 0; slice7window_centre_output_column_1 <= false;
      slice7window_centre_end_of_line <= (others => false); slice7_best_tag <= (others => false);
    end if;
  end process;
end architecture;
