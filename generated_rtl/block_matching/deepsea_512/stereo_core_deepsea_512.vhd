-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, block matching, configuration deepsea_512: 512x480, 52 disparities, window 7x7, 1 pixel pair a clock.
-- Options: disparities 52, window_px 7, cost census, census_width_px 7, census_height_px 7, aggregation
--   recursive, slice_disparities 13.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config deepsea_512
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
-- Where a comment behind a declaration has #, the C++ has the indices.
-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_deepsea_512 is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 512;
    height_px : positive := 480;
    disparities : positive := 52;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 460;
    latency_clocks : positive := 27;
    flush_groups : positive := 3077;
    gap_groups : positive := 1536
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
  assert width_px = 512 report "stereo_core_deepsea_512: width_px is " & integer'image(width_px) & " but this core has 512" severity failure;
  assert height_px = 480 report "stereo_core_deepsea_512: height_px is " & integer'image(height_px) & " but this core has 480" severity failure;
  assert disparities = 52 report "stereo_core_deepsea_512: disparities is " & integer'image(disparities) & " but this core has 52" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_deepsea_512: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_deepsea_512: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 460 report "stereo_core_deepsea_512: output_width_px is " & integer'image(output_width_px) & " but this core has 460" severity failure;
  assert latency_clocks = 27 report "stereo_core_deepsea_512: latency_clocks is " & integer'image(latency_clocks) & " but this core has 27" severity failure;
  assert flush_groups = 3077 report "stereo_core_deepsea_512: flush_groups is " & integer'image(flush_groups) & " but this core has 3077" severity failure;
  assert gap_groups = 1536 report "stereo_core_deepsea_512: gap_groups is " & integer'image(gap_groups) & " but this core has 1536" severity failure;
end entity;

architecture rtl of stereo_core_deepsea_512 is
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

  -- the majority: a comparison or a sum as a chain of its bits
  function carry(before : boolean; a : boolean; b : boolean) return boolean is
  begin
    if before then
      return a or b;
    end if;
    return a and b;
  end function;

  -- whether a > b, of bits `low` to `high`; of equal ones, `before`: bit by bit, as the tool has split it
  function is_larger(a : natural; b : natural; low : natural; high : natural; before : boolean) return boolean is
    variable is_not : boolean := not before;
  begin
    for place in low to high loop
      is_not := carry(is_not, not is_set(a, place), is_set(b, place));
    end loop;
    return not is_not;
  end function;

  -- 1 where this bit differs
  function differing_bits(a : unsigned; b : unsigned; place : natural) return natural is
  begin
    return as_number((a(place) = '1') /= (b(place) = '1'));
  end function;

  function differing_bits(a : unsigned; b : unsigned; p : natural; q : natural; r : natural) return natural is
  begin
    return differing_bits(a, b, p) + differing_bits(a, b, q) + differing_bits(a, b, r);
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

  type boolean_1d is array (natural range <>) of boolean;
  type integer_minus_48_to_48_1d is array (natural range <>) of integer range -48 to 48;
  type integer_minus_511_to_511_1d is array (natural range <>) of integer range -511 to 511;
  type natural_11_1d is array (natural range <>) of natural range 0 to 11;
  type natural_12_1d is array (natural range <>) of natural range 0 to 12;
  type natural_134217727_1d is array (natural range <>) of natural range 0 to 134217727;
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  type natural_255_2d is array (natural range <>, natural range <>) of natural range 0 to 255;
  type natural_3_3d is array (natural range <>, natural range <>, natural range <>) of natural range 0 to 3;
  type natural_4095_1d is array (natural range <>) of natural range 0 to 4095;
  type natural_48_2d is array (natural range <>, natural range <>) of natural range 0 to 48;
  type natural_511_1d is array (natural range <>) of natural range 0 to 511;
  type natural_511_2d is array (natural range <>, natural range <>) of natural range 0 to 511;
  type unsigned_27_1d is array (natural range <>) of unsigned(26 downto 0);
  type unsigned_48_1d is array (natural range <>) of unsigned(47 downto 0);
  type unsigned_48_2d is array (natural range <>, natural range <>) of unsigned(47 downto 0);
  type tag_9 is record
    valid, row_start, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame : boolean;
    end_of_line : boolean;
  end record;
  type tag_8 is record
    valid, first_group, border_column, first_cost, leaves_window, output_column, start_of_frame, end_of_line : boolean;
  end record;
  type tag_2 is record
    valid, start_of_frame : boolean;
  end record;
  type tag_4 is record
    valid, output_column, start_of_frame, end_of_line : boolean;
  end record;
  signal in_valid, in_start_of_frame : boolean;
  signal in_right_pixel, in_left_pixel : natural range 0 to 255;
  -- transform
  signal transform_left_0, transform_right_0, transform_left_rows_read_newest_0, transform_left_rows_ready_newest_0,
    transform_right_rows_read_newest_0, transform_right_rows_ready_newest_0 : natural range 0 to 255;
  signal transform_left_column, transform_right_column : natural_255_1d(0 to 6);
  signal transform_left_filter_column, transform_right_filter_column : natural_255_2d(0 to 6, 0 to 6);
  signal transform_valid, transform_counter_next_frame : boolean;
  signal transform_read_row_inside, transform_read_column_inside : boolean_1d(0 to 6);
  signal transform_read_start_of_frame, transform_read_valid : boolean;
  signal transform_ready_row_inside, transform_ready_column_inside : boolean_1d(0 to 6);
  signal transform_ready_start_of_frame, transform_ready_valid : boolean;
  signal transform_columns_row_inside, transform_columns_column_inside : boolean_1d(0 to 6);
  signal transform_columns_start_of_frame, transform_columns_valid : boolean;
  signal transform_filtering_0_column_inside : boolean_1d(0 to 6);
  signal transform_filtering_start_of_frame : boolean_1d(0 to 1);  -- _#_start_of_frame
  signal transform_filtering_valid : boolean_1d(0 to 1);  -- _#_valid
  signal transform_counter_column, transform_counter_group, transform_read_column, transform_ready_column,
    transform_write_column : natural range 0 to 511;
  signal transform_left_rows_read_words_0, transform_left_rows_ready_words_0, transform_left_rows_write_words_0,
    transform_right_rows_read_words_0, transform_right_rows_ready_words_0,
    transform_right_rows_write_words_0 : unsigned(31 downto 0);
  signal transform_left_rows_read_words_1, transform_right_rows_read_words_1 : unsigned(15 downto 0);
  signal transform_left_rows_ready_words_1, transform_left_rows_write_words_1, transform_right_rows_ready_words_1,
    transform_right_rows_write_words_1 : natural range 0 to 65535;
  signal transform_left_filter_feature_0, transform_right_filter_feature_0 : unsigned(47 downto 0);
  -- raster
  signal raster_features_search_0, raster_features_reference_0 : unsigned(47 downto 0);
  signal raster_features_valid : boolean;
  signal raster_place_column, raster_place_group : natural range 0 to 511;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address : natural range 0 to 63;
  signal delay_ahead_0, delay_delayed_0 : unsigned(47 downto 0);
  signal delay_column : natural range 0 to 511;
  signal delay_row_inside : boolean_1d(0 to 1);
  signal delay_tag : tag_9;
  -- rows
  signal rows_search_rows_read_words : unsigned_48_1d(0 to 6);
  signal rows_search_rows_read_newest_0 : unsigned(47 downto 0);
  signal rows_search_rows_ready_words : unsigned_48_1d(0 to 6);
  signal rows_search_rows_ready_newest_0 : unsigned(47 downto 0);
  signal rows_search_rows_write_words, rows_reference_rows_read_words : unsigned_48_1d(0 to 6);
  signal rows_reference_rows_read_newest_0 : unsigned(47 downto 0);
  signal rows_reference_rows_ready_words : unsigned_48_1d(0 to 6);
  signal rows_reference_rows_ready_newest_0 : unsigned(47 downto 0);
  signal rows_reference_rows_write_words : unsigned_48_1d(0 to 6);
  signal rows_search, rows_reference : unsigned_48_1d(0 to 1);
  signal rows_read_column, rows_ready_column, rows_write_column : natural range 0 to 511;
  signal rows_read_inside : boolean_1d(0 to 1);
  signal rows_read_tag : tag_9;
  signal rows_ready_inside : boolean_1d(0 to 1);
  signal rows_ready_tag, rows_tag : tag_9;
  -- slice0shift
  signal slice0shift_search : unsigned_48_2d(0 to 1, 0 to 12);
  signal slice0shift_reference, slice0shift_search_out : unsigned_48_1d(0 to 1);
  signal slice0shift_tag : tag_9;
  -- slice0cost
  signal slice0cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 12, 0 to 15);  -- _#_#_count_#
  signal slice0cost_pixels_first_tag, slice0cost_pixels_tag, slice0cost_ready_tag : tag_9;
  signal slice0cost_tag : tag_8;
  signal slice0cost_pixels_cost : natural_48_2d(0 to 1, 0 to 12);
  signal slice0cost_read_column, slice0cost_change_column, slice0cost_ready_words_4,
    slice0cost_ready_column : natural range 0 to 511;
  signal slice0cost_column_0 : natural_511_1d(0 to 12);
  signal slice0cost_write_column : natural range 0 to 511;
  signal slice0cost_write_words : natural_134217727_1d(0 to 4);  -- _# up to 134217727 x 4, 511
  signal slice0cost_read_words : unsigned_27_1d(0 to 3);
  signal slice0cost_read_words_4 : unsigned(8 downto 0);
  signal slice0cost_change_0 : integer_minus_48_to_48_1d(0 to 12);
  signal slice0cost_ready_words : natural_134217727_1d(0 to 3);
  -- slice0window
  signal slice0window_ring_read_address, slice0window_ring_write_address : natural range 0 to 7;
  signal slice0window_leaving : unsigned_27_1d(0 to 3);
  signal slice0window_leaving_4 : unsigned(8 downto 0);
  signal slice0window_entering_0 : natural_511_1d(0 to 12);
  signal slice0window_entering_tag, slice0window_change_tag : tag_8;
  signal slice0window_centre_output_column_0, slice0window_centre_first_column_0 : boolean;
  signal slice0window_centre_start_of_frame : boolean_1d(0 to 2);
  signal slice0window_centre_end_of_line_0 : boolean;
  signal slice0window_tag : tag_2;
  signal slice0window_change_0 : integer_minus_511_to_511_1d(0 to 12);
  signal slice0window_sum_0 : natural_4095_1d(0 to 12);
  -- slice0winner1
  signal slice0winner1_best_cost_0 : natural_4095_1d(0 to 6);
  signal slice0winner1_best_index_0_0 : boolean;
  signal slice0winner1_tag : tag_2;
  signal slice0winner1_best_index_0 : natural_12_1d(1 to 6);  -- _# up to 3, 5 .. 11, 12
  -- slice0winner2
  signal slice0winner2_best_cost_0 : natural_4095_1d(0 to 3);
  signal slice0winner2_best_index_0 : natural_12_1d(0 to 3);  -- _# up to 3, 7, 11, 12
  signal slice0winner2_tag : tag_4;
  -- slice0winner3
  signal slice0winner3_best_cost_0 : natural_4095_1d(0 to 1);
  signal slice0winner3_best_index_0 : natural_12_1d(0 to 1);  -- _# up to 7, 12
  signal slice0winner3_tag : tag_4;
  -- slice0winner4
  signal slice0winner4_best_cost_0_0 : natural range 0 to 4095;
  signal slice0winner4_best_index_0_0 : natural range 0 to 12;
  signal slice0winner4_tag : tag_4;
  -- slice0
  signal slice0_best_cost_0_0 : natural range 0 to 4095;
  signal slice0_best_index_0_0 : natural range 0 to 51;
  signal slice0_best_tag : tag_4;
  -- slice1shift
  signal slice1shift_search : unsigned_48_2d(0 to 1, 0 to 12);
  signal slice1shift_reference, slice1shift_search_out : unsigned_48_1d(0 to 1);
  -- slice1cost
  signal slice1cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 12, 0 to 15);  -- _#_#_count_#
  signal slice1cost_pixels_cost : natural_48_2d(0 to 1, 0 to 12);
  signal slice1cost_read_column, slice1cost_change_column, slice1cost_ready_words_4,
    slice1cost_ready_column : natural range 0 to 511;
  signal slice1cost_column_0 : natural_511_1d(0 to 12);
  signal slice1cost_write_column : natural range 0 to 511;
  signal slice1cost_write_words : natural_134217727_1d(0 to 4);  -- _# up to 134217727 x 4, 511
  signal slice1cost_read_words : unsigned_27_1d(0 to 3);
  signal slice1cost_read_words_4 : unsigned(8 downto 0);
  signal slice1cost_change_0 : integer_minus_48_to_48_1d(0 to 12);
  signal slice1cost_ready_words : natural_134217727_1d(0 to 3);
  -- slice1window
  signal slice1window_ring_read_address, slice1window_ring_write_address : natural range 0 to 7;
  signal slice1window_leaving : unsigned_27_1d(0 to 3);
  signal slice1window_leaving_4 : unsigned(8 downto 0);
  signal slice1window_entering_0 : natural_511_1d(0 to 12);
  signal slice1window_change_0 : integer_minus_511_to_511_1d(0 to 12);
  signal slice1window_change_tag_leaves_window, slice1window_centre_output_column_0,
    slice1window_centre_first_column_0, slice1window_centre_end_of_line_0 : boolean;
  signal slice1window_sum_0 : natural_4095_1d(0 to 12);
  -- slice1winner1
  signal slice1winner1_best_cost_0 : natural_4095_1d(0 to 6);
  signal slice1winner1_best_index_0_0 : boolean;
  signal slice1winner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- slice1winner2
  signal slice1winner2_best_cost_0 : natural_4095_1d(0 to 3);
  signal slice1winner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  -- slice1winner3
  signal slice1winner3_best_cost_0 : natural_4095_1d(0 to 1);
  signal slice1winner3_best_index_0 : natural_12_1d(0 to 1);  -- _# up to 7, 12
  -- slice1winner4
  signal slice1winner4_best_cost_0_0 : natural range 0 to 4095;
  signal slice1winner4_best_index_0_0 : natural range 0 to 12;
  -- slice1
  signal slice1_best_cost_0_0 : natural range 0 to 4095;
  signal slice1_best_index_0_0 : natural range 0 to 51;
  signal slice1_best_tag : tag_4;
  -- slice2shift
  signal slice2shift_search : unsigned_48_2d(0 to 1, 0 to 12);
  signal slice2shift_reference, slice2shift_search_out : unsigned_48_1d(0 to 1);
  -- slice2cost
  signal slice2cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 12, 0 to 15);  -- _#_#_count_#
  signal slice2cost_pixels_cost : natural_48_2d(0 to 1, 0 to 12);
  signal slice2cost_read_column, slice2cost_change_column, slice2cost_ready_words_4,
    slice2cost_ready_column : natural range 0 to 511;
  signal slice2cost_column_0 : natural_511_1d(0 to 12);
  signal slice2cost_write_column : natural range 0 to 511;
  signal slice2cost_write_words : natural_134217727_1d(0 to 4);  -- _# up to 134217727 x 4, 511
  signal slice2cost_read_words : unsigned_27_1d(0 to 3);
  signal slice2cost_read_words_4 : unsigned(8 downto 0);
  signal slice2cost_change_0 : integer_minus_48_to_48_1d(0 to 12);
  signal slice2cost_ready_words : natural_134217727_1d(0 to 3);
  -- slice2window
  signal slice2window_ring_read_address, slice2window_ring_write_address : natural range 0 to 7;
  signal slice2window_leaving : unsigned_27_1d(0 to 3);
  signal slice2window_leaving_4 : unsigned(8 downto 0);
  signal slice2window_entering_0 : natural_511_1d(0 to 12);
  signal slice2window_change_0 : integer_minus_511_to_511_1d(0 to 12);
  signal slice2window_change_tag_leaves_window, slice2window_centre_output_column_0,
    slice2window_centre_first_column_0, slice2window_centre_end_of_line_0 : boolean;
  signal slice2window_sum_0 : natural_4095_1d(0 to 12);
  -- slice2winner1
  signal slice2winner1_best_cost_0 : natural_4095_1d(0 to 6);
  signal slice2winner1_best_index_0_0 : boolean;
  signal slice2winner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- slice2winner2
  signal slice2winner2_best_cost_0 : natural_4095_1d(0 to 3);
  signal slice2winner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  -- slice2winner3
  signal slice2winner3_best_cost_0 : natural_4095_1d(0 to 1);
  signal slice2winner3_best_index_0 : natural_12_1d(0 to 1);  -- _# up to 7, 12
  -- slice2winner4
  signal slice2winner4_best_cost_0_0 : natural range 0 to 4095;
  signal slice2winner4_best_index_0_0 : natural range 0 to 12;
  -- slice2
  signal slice2_best_cost_0_0 : natural range 0 to 4095;
  signal slice2_best_index_0_0 : natural range 0 to 51;
  signal slice2_best_tag : tag_4;
  -- slice3shift
  signal slice3shift_search : unsigned_48_2d(0 to 1, 0 to 12);
  signal slice3shift_reference : unsigned_48_1d(0 to 1);
  -- slice3cost
  signal slice3cost_pixels_first_count : natural_3_3d(0 to 1, 0 to 12, 0 to 15);  -- _#_#_count_#
  signal slice3cost_pixels_cost : natural_48_2d(0 to 1, 0 to 12);
  signal slice3cost_read_column, slice3cost_change_column, slice3cost_ready_words_4,
    slice3cost_ready_column : natural range 0 to 511;
  signal slice3cost_column_0 : natural_511_1d(0 to 12);
  signal slice3cost_write_column : natural range 0 to 511;
  signal slice3cost_write_words : natural_134217727_1d(0 to 4);  -- _# up to 134217727 x 4, 511
  signal slice3cost_read_words : unsigned_27_1d(0 to 3);
  signal slice3cost_read_words_4 : unsigned(8 downto 0);
  signal slice3cost_change_0 : integer_minus_48_to_48_1d(0 to 12);
  signal slice3cost_ready_words : natural_134217727_1d(0 to 3);
  -- slice3window
  signal slice3window_ring_read_address, slice3window_ring_write_address : natural range 0 to 7;
  signal slice3window_leaving : unsigned_27_1d(0 to 3);
  signal slice3window_leaving_4 : unsigned(8 downto 0);
  signal slice3window_entering_0 : natural_511_1d(0 to 12);
  signal slice3window_change_0 : integer_minus_511_to_511_1d(0 to 12);
  signal slice3window_sum_0 : natural_4095_1d(0 to 12);
  signal slice3window_centre_output_column, slice3window_centre_end_of_line : boolean_1d(0 to 1);
  -- slice3winner1
  signal slice3winner1_best_cost_0 : natural_4095_1d(0 to 6);
  signal slice3winner1_best_index_0_0 : boolean;
  signal slice3winner1_best_index_0 : natural_11_1d(1 to 5);  -- _# up to 3, 5 .. 11
  -- slice3winner2
  signal slice3winner2_best_cost_0 : natural_4095_1d(0 to 3);
  signal slice3winner2_best_index_0 : natural_11_1d(0 to 2);  -- _# up to 3, 7, 11
  -- slice3winner3
  signal slice3winner3_best_cost_0 : natural_4095_1d(0 to 1);
  signal slice3winner3_best_index_0 : natural_12_1d(0 to 1);  -- _# up to 7, 12
  -- slice3winner4
  signal slice3winner4_best_cost_0_0 : natural range 0 to 4095;
  signal slice3winner4_best_index_0_0 : natural range 0 to 12;
  -- slice3
  signal slice3_best_index_0_0 : natural range 0 to 51;
  signal slice3_best_tag : tag_4;

begin
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(slice3_best_index_0_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(slice3_best_tag.valid and slice3_best_tag.output_column);
  disparity_start_of_frame <= as_bit(slice3_best_tag.start_of_frame and slice3_best_tag.valid and slice3_best_tag.output_column);
  disparity_end_of_line <= as_bit(slice3_best_tag.end_of_line and slice3_best_tag.valid and slice3_best_tag.output_column);

  -- Memories: (depth, width, address_bits), (clock, read_enable, read_address, read_data, write_address, write_data)

  transform_left_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_left_rows_write_words_1, 16);
    cell : entity work.line_memory generic map (512, 16, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_1, write_address, write_data);
  end block;

  transform_left_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (512, 32, 9)
      port map (clock, true, read_address, transform_left_rows_read_words_0, write_address,
        transform_left_rows_write_words_0);
  end block;

  transform_right_rows_read_words_1_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(15 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    write_data <= to_unsigned(transform_right_rows_write_words_1, 16);
    cell : entity work.line_memory generic map (512, 16, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_1, write_address, write_data);
  end block;

  transform_right_rows_read_words_0_memory : block
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(transform_counter_column, 9);
    write_address <= to_unsigned(transform_write_column, 9);
    cell : entity work.line_memory generic map (512, 32, 9)
      port map (clock, true, read_address, transform_right_rows_read_words_0, write_address,
        transform_right_rows_write_words_0);
  end block;

  slice3window_leaving_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 3);
    write_address <= to_unsigned(slice3window_ring_write_address, 3);
    write_data <= to_unsigned(slice3cost_column_0(12), 9);
    cell : entity work.line_memory generic map (8, 9, 3)
      port map (clock, true, read_address, slice3window_leaving_4, write_address, write_data);
  end block;

  slice3window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice3window_ring_read_address, 3);
    write_address <= to_unsigned(slice3window_ring_write_address, 3);
    write_data <= to_unsigned(slice3cost_column_0(3 * i + 2), 9) & to_unsigned(slice3cost_column_0(3 * i + 1), 9) &
      to_unsigned(slice3cost_column_0(3 * i), 9);
    cell : entity work.line_memory generic map (8, 27, 3)
      port map (clock, true, read_address, slice3window_leaving(i), write_address, write_data);
  end generate;

  slice3cost_read_words_4_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_change_column, 9);
    write_address <= to_unsigned(slice3cost_write_column, 9);
    write_data <= to_unsigned(slice3cost_write_words(4), 9);
    cell : entity work.line_memory generic map (512, 9, 9)
      port map (clock, true, read_address, slice3cost_read_words_4, write_address, write_data);
  end block;

  slice3cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_change_column, 9);
    write_address <= to_unsigned(slice3cost_write_column, 9);
    write_data <= to_unsigned(slice3cost_write_words(i), 27);
    cell : entity work.line_memory generic map (512, 27, 9)
      port map (clock, true, read_address, slice3cost_read_words(i), write_address, write_data);
  end generate;

  slice2window_leaving_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 3);
    write_address <= to_unsigned(slice2window_ring_write_address, 3);
    write_data <= to_unsigned(slice2cost_column_0(12), 9);
    cell : entity work.line_memory generic map (8, 9, 3)
      port map (clock, true, read_address, slice2window_leaving_4, write_address, write_data);
  end block;

  slice2window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice2window_ring_read_address, 3);
    write_address <= to_unsigned(slice2window_ring_write_address, 3);
    write_data <= to_unsigned(slice2cost_column_0(3 * i + 2), 9) & to_unsigned(slice2cost_column_0(3 * i + 1), 9) &
      to_unsigned(slice2cost_column_0(3 * i), 9);
    cell : entity work.line_memory generic map (8, 27, 3)
      port map (clock, true, read_address, slice2window_leaving(i), write_address, write_data);
  end generate;

  slice2cost_read_words_4_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_read_column, 9);
    write_address <= to_unsigned(slice3cost_ready_column, 9);
    write_data <= to_unsigned(slice2cost_write_words(4), 9);
    cell : entity work.line_memory generic map (512, 9, 9)
      port map (clock, true, read_address, slice2cost_read_words_4, write_address, write_data);
  end block;

  slice2cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice2cost_read_column, 9);
    write_address <= to_unsigned(slice3cost_ready_column, 9);
    write_data <= to_unsigned(slice2cost_write_words(i), 27);
    cell : entity work.line_memory generic map (512, 27, 9)
      port map (clock, true, read_address, slice2cost_read_words(i), write_address, write_data);
  end generate;

  slice1window_leaving_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(12), 9);
    cell : entity work.line_memory generic map (8, 9, 3)
      port map (clock, true, read_address, slice1window_leaving_4, write_address, write_data);
  end block;

  slice1window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice1window_ring_read_address, 3);
    write_address <= to_unsigned(slice1window_ring_write_address, 3);
    write_data <= to_unsigned(slice1cost_column_0(3 * i + 2), 9) & to_unsigned(slice1cost_column_0(3 * i + 1), 9) &
      to_unsigned(slice1cost_column_0(3 * i), 9);
    cell : entity work.line_memory generic map (8, 27, 3)
      port map (clock, true, read_address, slice1window_leaving(i), write_address, write_data);
  end generate;

  slice1cost_read_words_4_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(4), 9);
    cell : entity work.line_memory generic map (512, 9, 9)
      port map (clock, true, read_address, slice1cost_read_words_4, write_address, write_data);
  end block;

  slice1cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_change_column, 9);
    write_address <= to_unsigned(slice1cost_write_column, 9);
    write_data <= to_unsigned(slice1cost_write_words(i), 27);
    cell : entity work.line_memory generic map (512, 27, 9)
      port map (clock, true, read_address, slice1cost_read_words(i), write_address, write_data);
  end generate;

  slice0window_leaving_4_memory : block
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(12), 9);
    cell : entity work.line_memory generic map (8, 9, 3)
      port map (clock, true, read_address, slice0window_leaving_4, write_address, write_data);
  end block;

  slice0window_leaving_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(2 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice0window_ring_read_address, 3);
    write_address <= to_unsigned(slice0window_ring_write_address, 3);
    write_data <= to_unsigned(slice0cost_column_0(3 * i + 2), 9) & to_unsigned(slice0cost_column_0(3 * i + 1), 9) &
      to_unsigned(slice0cost_column_0(3 * i), 9);
    cell : entity work.line_memory generic map (8, 27, 3)
      port map (clock, true, read_address, slice0window_leaving(i), write_address, write_data);
  end generate;

  slice0cost_read_words_4_memory : block
    signal read_address, write_address, write_data : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(4), 9);
    cell : entity work.line_memory generic map (512, 9, 9)
      port map (clock, true, read_address, slice0cost_read_words_4, write_address, write_data);
  end block;

  slice0cost_read_words_memory : for i in 3 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
    signal write_data : unsigned(26 downto 0);
  begin
    read_address <= to_unsigned(slice0cost_read_column, 9);
    write_address <= to_unsigned(slice1cost_ready_column, 9);
    write_data <= to_unsigned(slice0cost_write_words(i), 27);
    cell : entity work.line_memory generic map (512, 27, 9)
      port map (clock, true, read_address, slice0cost_read_words(i), write_address, write_data);
  end generate;

  rows_search_rows_read_words_memory : for i in 6 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    cell : entity work.line_memory generic map (512, 48, 9)
      port map (clock, true, read_address, rows_search_rows_read_words(i), write_address,
        rows_search_rows_write_words(i));
  end generate;

  rows_reference_rows_read_words_memory : for i in 6 downto 0 generate
    signal read_address, write_address : unsigned(8 downto 0);
  begin
    read_address <= to_unsigned(delay_column, 9);
    write_address <= to_unsigned(rows_write_column, 9);
    cell : entity work.line_memory generic map (512, 48, 9)
      port map (clock, true, read_address, rows_reference_rows_read_words(i), write_address,
        rows_reference_rows_write_words(i));
  end generate;

  delay_delayed_0_memory : block
    signal read_address, write_address : unsigned(5 downto 0);
  begin
    read_address <= to_unsigned(delay_ring_read_address, 6);
    write_address <= to_unsigned(delay_ring_write_address, 6);
    cell : entity work.line_memory generic map (52, 48, 6)
      port map (clock, true, read_address, delay_delayed_0, write_address, raster_features_reference_0);
  end block;

  process
    variable transform_counter_group_is_equals : boolean_1d(1 to 2);  -- _equal_#
    variable transform_counter_group_all, transform_counter_group_differs, transform_read_column_inside_0_is_less,
      transform_left_filter_feature_0_any, transform_left_filter_feature_0_is_equal,
      transform_right_filter_feature_0_any, transform_right_filter_feature_0_is_equal, raster_place_group_is_equal,
      delay_tag_first_cost_is_equal, slice0winner4_best_cost_0_0_is_less, slice1winner4_best_cost_0_0_is_less,
      slice1_best_cost_0_0_is_less, slice2winner4_best_cost_0_0_is_less, slice2_best_cost_0_0_is_less,
      slice3winner4_best_cost_0_0_is_less : boolean;
    variable transform_counter_group_choice : natural range 0 to 15;
    variable transform_counter_group_choices : natural_511_1d(2 to 3);  -- _choice_#
    variable transform_left_filter_feature_0_values, transform_right_filter_feature_0_values : boolean_1d(1 to 11);  -- _value_#
    variable transform_left_filter_feature_0_choice, transform_right_filter_feature_0_choice : boolean_1d(8 to 384);
    variable transform_left_filter_feature_0_choice_385,
      transform_right_filter_feature_0_choice_385 : natural range 0 to 127;
    variable transform_left_filter_feature_0_choice_386,
      transform_right_filter_feature_0_choice_386 : natural range 0 to 16383;
    variable transform_left_filter_feature_0_choice_387,
      transform_right_filter_feature_0_choice_387 : natural range 0 to 2097151;
    variable transform_left_filter_feature_0_choice_388,
      transform_right_filter_feature_0_choice_388 : natural range 0 to 67108863;
    variable transform_left_filter_feature_0_choice_389,
      transform_right_filter_feature_0_choice_389 : unsigned(33 downto 0);
    variable transform_left_filter_feature_0_choice_390,
      transform_right_filter_feature_0_choice_390 : unsigned(40 downto 0);
    variable transform_counter_next_frame_choices : boolean_1d(1 to 2);  -- _choice_#
    variable slice0cost_column_0_choice, slice1cost_column_0_choice, slice2cost_column_0_choice,
      slice3cost_column_0_choice : natural_511_2d(0 to 12, 1 to 2);  -- _#_choice_#
    variable slice0window_change_0_choice, slice1window_change_0_choice, slice2window_change_0_choice,
      slice3window_change_0_choice : natural_511_1d(0 to 12);  -- _#_choice
    variable slice0window_sum_0_choice, slice1window_sum_0_choice, slice2window_sum_0_choice,
      slice3window_sum_0_choice : natural_4095_1d(0 to 12);  -- _#_choice
    variable slice0winner1_best_cost_0_is_less, slice1winner1_best_cost_0_is_less, slice2winner1_best_cost_0_is_less,
      slice3winner1_best_cost_0_is_less : boolean_1d(0 to 5);  -- _#_is_less
    variable slice0winner2_best_cost_0_is_less, slice1winner2_best_cost_0_is_less, slice2winner2_best_cost_0_is_less,
      slice3winner2_best_cost_0_is_less : boolean_1d(0 to 2);  -- _#_is_less
    variable slice0winner3_best_cost_0_is_less, slice1winner3_best_cost_0_is_less, slice2winner3_best_cost_0_is_less,
      slice3winner3_best_cost_0_is_less : boolean_1d(0 to 1);  -- _#_is_less
  begin
    wait until rising_edge(clock);
    -- no bit without a value, where an array has places for more
    transform_left_filter_feature_0_choice := (others => false);
    transform_right_filter_feature_0_choice := (others => false);
    -- transform
    transform_counter_group_is_equals(1) := transform_counter_group = 479;
    transform_counter_group_is_equals(2) := transform_counter_column = 511;
    transform_counter_group_all := transform_counter_group_is_equals(1) and transform_counter_group_is_equals(2);
    transform_counter_group_choice := choice(transform_counter_group_all, 15, 0);
    transform_counter_group_differs := transform_counter_group /= 483;
    transform_counter_group_choices(2) := choice((transform_counter_group = 482) and transform_counter_next_frame, 3,
      (transform_counter_group + 1) mod 512);
    transform_counter_group_choices(3) := choice(transform_counter_group_differs and in_valid and
      transform_counter_group_is_equals(2), transform_counter_group_choices(2), transform_counter_group);
    transform_read_column_inside_0_is_less := 2 < transform_counter_column;
    transform_left_filter_feature_0_values(1) := is_set(transform_left_filter_column(3, 3), 1);
    transform_left_filter_feature_0_any := (not transform_left_filter_feature_0_values(1)) or (not
      is_set(transform_left_filter_column(3, 3), 0));
    transform_left_filter_feature_0_is_equal := (transform_left_filter_column(3, 3) mod 4) = 0;
    for i in 2 to 6 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(3, 3), i);
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 6 loop
        transform_left_filter_feature_0_choice(56 * i + 8 * j + 8) := is_larger(transform_left_filter_column(6 - i, j),
          transform_left_filter_column(3, 3), 0, 7, false);
      end loop;
    end loop;
    transform_left_filter_feature_0_choice(175) := not is_larger(transform_left_filter_column(3, 6),
      transform_left_filter_column(3, 3), 0, 6, false);
    transform_left_filter_feature_0_choice(176) := choice(transform_left_filter_feature_0_choice(175),
      transform_filtering_0_column_inside(3) and is_set(transform_left_filter_column(3, 6), 7) and (not
      is_set(transform_left_filter_column(3, 3), 7)), transform_filtering_0_column_inside(3) and
      (is_set(transform_left_filter_column(3, 6), 7) or (not is_set(transform_left_filter_column(3, 3), 7))));
    transform_left_filter_feature_0_choice(184) := is_larger(transform_left_filter_column(3, 5),
      transform_left_filter_column(3, 3), 0, 7, false);
    transform_left_filter_feature_0_choice(192) := is_larger(transform_left_filter_column(3, 4),
      transform_left_filter_column(3, 3), 0, 7, false);
    for i in 0 to 2 loop
      transform_left_filter_feature_0_choice(8 * i + 200) := is_larger(transform_left_filter_column(3, 2 - i),
        transform_left_filter_column(3, 3), 0, 7, false);
    end loop;
    for i in 0 to 1 loop
      transform_left_filter_feature_0_choice(56 * i + 224) := is_larger(transform_left_filter_column(2 - i, 5),
        transform_left_filter_column(3, 3), 0, 7, false);
      transform_left_filter_feature_0_choice(56 * i + 232) := is_larger(transform_left_filter_column(2 - i, 6),
        transform_left_filter_column(3, 3), 0, 7, false);
      for j in 0 to 4 loop
        transform_left_filter_feature_0_choice(56 * i + 8 * j + 240) := is_larger(transform_left_filter_column(2 - i, 4
          - j), transform_left_filter_column(3, 3), 0, 7, false);
      end loop;
    end loop;
    transform_left_filter_feature_0_choice(336) := is_larger(transform_left_filter_column(0, 5),
      transform_left_filter_column(3, 3), 0, 7, false);
    transform_left_filter_feature_0_choice(344) := is_larger(transform_left_filter_column(0, 6),
      transform_left_filter_column(3, 3), 0, 7, false);
    for i in 0 to 3 loop
      transform_left_filter_feature_0_choice(8 * i + 352) := is_larger(transform_left_filter_column(0, 4 - i),
        transform_left_filter_column(3, 3), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_left_filter_feature_0_values(i) := is_set(transform_left_filter_column(0, 0), i - 5);
    end loop;
    transform_left_filter_feature_0_choice(384) := not is_larger(transform_left_filter_column(3, 3),
      transform_left_filter_column(0, 0), 0, 7, true);
    transform_left_filter_feature_0_choice_385 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_left_filter_feature_0_choice(336)) * 32) +
      (as_number(transform_left_filter_feature_0_choice(344)) * 64) +
      (as_number(transform_left_filter_feature_0_choice(352)) * 16) +
      (as_number(transform_left_filter_feature_0_choice(360)) * 8) +
      (as_number(transform_left_filter_feature_0_choice(368)) * 4) +
      (as_number(transform_left_filter_feature_0_choice(376)) * 2) +
      as_number(transform_left_filter_feature_0_choice(384)), 0);
    transform_left_filter_feature_0_choice_386 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_left_filter_feature_0_choice(280)) * 4096) +
      (as_number(transform_left_filter_feature_0_choice(288)) * 8192) +
      (as_number(transform_left_filter_feature_0_choice(296)) * 2048) +
      (as_number(transform_left_filter_feature_0_choice(304)) * 1024) +
      (as_number(transform_left_filter_feature_0_choice(312)) * 512) +
      (as_number(transform_left_filter_feature_0_choice(320)) * 256) +
      (as_number(transform_left_filter_feature_0_choice(328)) * 128) + transform_left_filter_feature_0_choice_385,
      transform_left_filter_feature_0_choice_385);
    transform_left_filter_feature_0_choice_387 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_left_filter_feature_0_choice(224)) * 524288) +
      (as_number(transform_left_filter_feature_0_choice(232)) * 1048576) +
      (as_number(transform_left_filter_feature_0_choice(240)) * 262144) +
      (as_number(transform_left_filter_feature_0_choice(248)) * 131072) +
      (as_number(transform_left_filter_feature_0_choice(256)) * 65536) +
      (as_number(transform_left_filter_feature_0_choice(264)) * 32768) +
      (as_number(transform_left_filter_feature_0_choice(272)) * 16384) + transform_left_filter_feature_0_choice_386,
      transform_left_filter_feature_0_choice_386);
    transform_left_filter_feature_0_choice_388 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_left_filter_feature_0_choice(184)) * 33554432) +
      (as_number(transform_left_filter_feature_0_choice(192)) * 16777216) +
      (as_number(transform_left_filter_feature_0_choice(200)) * 8388608) +
      (as_number(transform_left_filter_feature_0_choice(208)) * 4194304) +
      (as_number(transform_left_filter_feature_0_choice(216)) * 2097152) + transform_left_filter_feature_0_choice_387,
      transform_left_filter_feature_0_choice_387);
    if transform_filtering_0_column_inside(4) then
      transform_left_filter_feature_0_choice_389 := to_unsigned(as_number(transform_left_filter_feature_0_choice(168)),
        1) & to_unsigned(as_number(transform_left_filter_feature_0_choice(160)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(152)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(144)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(136)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(128)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(120)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(176)), 1) &
        to_unsigned(transform_left_filter_feature_0_choice_388, 26);
    else
      transform_left_filter_feature_0_choice_389 := to_unsigned(as_number(transform_left_filter_feature_0_choice(176)),
        8) & to_unsigned(transform_left_filter_feature_0_choice_388, 26);
    end if;
    if transform_filtering_0_column_inside(5) then
      transform_left_filter_feature_0_choice_390 := to_unsigned(as_number(transform_left_filter_feature_0_choice(112)),
        1) & to_unsigned(as_number(transform_left_filter_feature_0_choice(104)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(96)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(88)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(80)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(72)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(64)), 1) &
        transform_left_filter_feature_0_choice_389(33 downto 0);
    else
      transform_left_filter_feature_0_choice_390 := resize(transform_left_filter_feature_0_choice_389, 41);
    end if;
    transform_right_filter_feature_0_values(1) := is_set(transform_right_filter_column(3, 3), 1);
    transform_right_filter_feature_0_any := (not transform_right_filter_feature_0_values(1)) or (not
      is_set(transform_right_filter_column(3, 3), 0));
    transform_right_filter_feature_0_is_equal := (transform_right_filter_column(3, 3) mod 4) = 0;
    for i in 2 to 6 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(3, 3), i);
    end loop;
    for i in 0 to 2 loop
      for j in 0 to 6 loop
        transform_right_filter_feature_0_choice(56 * i + 8 * j + 8) := is_larger(transform_right_filter_column(6 - i,
          j), transform_right_filter_column(3, 3), 0, 7, false);
      end loop;
    end loop;
    transform_right_filter_feature_0_choice(175) := not is_larger(transform_right_filter_column(3, 6),
      transform_right_filter_column(3, 3), 0, 6, false);
    transform_right_filter_feature_0_choice(176) := choice(transform_right_filter_feature_0_choice(175),
      transform_filtering_0_column_inside(3) and is_set(transform_right_filter_column(3, 6), 7) and (not
      is_set(transform_right_filter_column(3, 3), 7)), transform_filtering_0_column_inside(3) and
      (is_set(transform_right_filter_column(3, 6), 7) or (not is_set(transform_right_filter_column(3, 3), 7))));
    transform_right_filter_feature_0_choice(184) := is_larger(transform_right_filter_column(3, 5),
      transform_right_filter_column(3, 3), 0, 7, false);
    transform_right_filter_feature_0_choice(192) := is_larger(transform_right_filter_column(3, 4),
      transform_right_filter_column(3, 3), 0, 7, false);
    for i in 0 to 2 loop
      transform_right_filter_feature_0_choice(8 * i + 200) := is_larger(transform_right_filter_column(3, 2 - i),
        transform_right_filter_column(3, 3), 0, 7, false);
    end loop;
    for i in 0 to 1 loop
      transform_right_filter_feature_0_choice(56 * i + 224) := is_larger(transform_right_filter_column(2 - i, 5),
        transform_right_filter_column(3, 3), 0, 7, false);
      transform_right_filter_feature_0_choice(56 * i + 232) := is_larger(transform_right_filter_column(2 - i, 6),
        transform_right_filter_column(3, 3), 0, 7, false);
      for j in 0 to 4 loop
        transform_right_filter_feature_0_choice(56 * i + 8 * j + 240) := is_larger(transform_right_filter_column(2 - i,
          4 - j), transform_right_filter_column(3, 3), 0, 7, false);
      end loop;
    end loop;
    transform_right_filter_feature_0_choice(336) := is_larger(transform_right_filter_column(0, 5),
      transform_right_filter_column(3, 3), 0, 7, false);
    transform_right_filter_feature_0_choice(344) := is_larger(transform_right_filter_column(0, 6),
      transform_right_filter_column(3, 3), 0, 7, false);
    for i in 0 to 3 loop
      transform_right_filter_feature_0_choice(8 * i + 352) := is_larger(transform_right_filter_column(0, 4 - i),
        transform_right_filter_column(3, 3), 0, 7, false);
    end loop;
    for i in 7 to 11 loop
      transform_right_filter_feature_0_values(i) := is_set(transform_right_filter_column(0, 0), i - 5);
    end loop;
    transform_right_filter_feature_0_choice(384) := not is_larger(transform_right_filter_column(3, 3),
      transform_right_filter_column(0, 0), 0, 7, true);
    transform_right_filter_feature_0_choice_385 := choice(transform_filtering_0_column_inside(0),
      (as_number(transform_right_filter_feature_0_choice(336)) * 32) +
      (as_number(transform_right_filter_feature_0_choice(344)) * 64) +
      (as_number(transform_right_filter_feature_0_choice(352)) * 16) +
      (as_number(transform_right_filter_feature_0_choice(360)) * 8) +
      (as_number(transform_right_filter_feature_0_choice(368)) * 4) +
      (as_number(transform_right_filter_feature_0_choice(376)) * 2) +
      as_number(transform_right_filter_feature_0_choice(384)), 0);
    transform_right_filter_feature_0_choice_386 := choice(transform_filtering_0_column_inside(1),
      (as_number(transform_right_filter_feature_0_choice(280)) * 4096) +
      (as_number(transform_right_filter_feature_0_choice(288)) * 8192) +
      (as_number(transform_right_filter_feature_0_choice(296)) * 2048) +
      (as_number(transform_right_filter_feature_0_choice(304)) * 1024) +
      (as_number(transform_right_filter_feature_0_choice(312)) * 512) +
      (as_number(transform_right_filter_feature_0_choice(320)) * 256) +
      (as_number(transform_right_filter_feature_0_choice(328)) * 128) + transform_right_filter_feature_0_choice_385,
      transform_right_filter_feature_0_choice_385);
    transform_right_filter_feature_0_choice_387 := choice(transform_filtering_0_column_inside(2),
      (as_number(transform_right_filter_feature_0_choice(224)) * 524288) +
      (as_number(transform_right_filter_feature_0_choice(232)) * 1048576) +
      (as_number(transform_right_filter_feature_0_choice(240)) * 262144) +
      (as_number(transform_right_filter_feature_0_choice(248)) * 131072) +
      (as_number(transform_right_filter_feature_0_choice(256)) * 65536) +
      (as_number(transform_right_filter_feature_0_choice(264)) * 32768) +
      (as_number(transform_right_filter_feature_0_choice(272)) * 16384) + transform_right_filter_feature_0_choice_386,
      transform_right_filter_feature_0_choice_386);
    transform_right_filter_feature_0_choice_388 := choice(transform_filtering_0_column_inside(3),
      (as_number(transform_right_filter_feature_0_choice(184)) * 33554432) +
      (as_number(transform_right_filter_feature_0_choice(192)) * 16777216) +
      (as_number(transform_right_filter_feature_0_choice(200)) * 8388608) +
      (as_number(transform_right_filter_feature_0_choice(208)) * 4194304) +
      (as_number(transform_right_filter_feature_0_choice(216)) * 2097152) +
      transform_right_filter_feature_0_choice_387, transform_right_filter_feature_0_choice_387);
    if transform_filtering_0_column_inside(4) then
      transform_right_filter_feature_0_choice_389 :=
        to_unsigned(as_number(transform_right_filter_feature_0_choice(168)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(160)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(152)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(144)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(136)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(128)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(120)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(176)), 1) &
        to_unsigned(transform_right_filter_feature_0_choice_388, 26);
    else
      transform_right_filter_feature_0_choice_389 :=
        to_unsigned(as_number(transform_right_filter_feature_0_choice(176)), 8) &
        to_unsigned(transform_right_filter_feature_0_choice_388, 26);
    end if;
    if transform_filtering_0_column_inside(5) then
      transform_right_filter_feature_0_choice_390 :=
        to_unsigned(as_number(transform_right_filter_feature_0_choice(112)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(104)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(96)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(88)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(80)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(72)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(64)), 1) &
        transform_right_filter_feature_0_choice_389(33 downto 0);
    else
      transform_right_filter_feature_0_choice_390 := resize(transform_right_filter_feature_0_choice_389, 41);
    end if;
    transform_left_0 <= in_left_pixel;
    transform_right_0 <= in_right_pixel;
    transform_valid <= in_valid;
    transform_left_rows_read_newest_0 <= transform_left_0;
    transform_left_rows_ready_words_0 <= transform_left_rows_read_words_0;
    transform_left_rows_ready_words_1 <= to_integer(transform_left_rows_read_words_1);
    transform_left_rows_ready_newest_0 <= transform_left_rows_read_newest_0;
    transform_right_rows_read_newest_0 <= transform_right_0;
    transform_right_rows_ready_words_0 <= transform_right_rows_read_words_0;
    transform_right_rows_ready_words_1 <= to_integer(transform_right_rows_read_words_1);
    transform_right_rows_ready_newest_0 <= transform_right_rows_read_newest_0;
    transform_read_column <= transform_counter_column;
    transform_read_row_inside(0) <= (((((transform_counter_group / 2) + 32765) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 480;
    transform_read_row_inside(1) <= (transform_counter_group >= 5) and (transform_counter_group < 485);
    transform_read_row_inside(2) <= (((((transform_counter_group / 4) + 16383) mod 16384) * 4) +
      (transform_counter_group mod 4)) < 480;
    transform_read_row_inside(3) <= (transform_counter_group >= 3) and (transform_counter_group < 483);
    transform_read_row_inside(4) <= (((((transform_counter_group / 2) + 32767) mod 32768) * 2) +
      (transform_counter_group mod 2)) < 480;
    transform_read_row_inside(5) <= (transform_counter_group >= 1) and (transform_counter_group < 481);
    transform_read_row_inside(6) <= transform_counter_group < 480;
    transform_read_column_inside(0) <= transform_read_column_inside_0_is_less;
    transform_read_column_inside(1) <= (transform_counter_column = 0) /= transform_read_column_inside_0_is_less;
    transform_read_column_inside(2) <= transform_counter_column /= 2;
    for i in 3 to 6 loop
      transform_read_column_inside(i) <= (transform_counter_column < i) /= transform_read_column_inside_0_is_less;
    end loop;
    transform_read_start_of_frame <= (transform_counter_group = 3) and (transform_counter_column = 3);
    transform_read_valid <= transform_valid;
    transform_ready_column <= transform_read_column;
    transform_ready_row_inside <= transform_read_row_inside;
    transform_ready_column_inside <= transform_read_column_inside;
    transform_ready_start_of_frame <= transform_read_start_of_frame;
    transform_ready_valid <= transform_read_valid;
    transform_left_column(0) <= to_integer(transform_left_rows_ready_words_0(7 downto 0));
    transform_left_column(1) <= to_integer(transform_left_rows_ready_words_0(15 downto 8));
    transform_left_column(2) <= to_integer(transform_left_rows_ready_words_0(23 downto 16));
    transform_left_column(3) <= to_integer(transform_left_rows_ready_words_0(31 downto 24));
    transform_left_column(4) <= transform_left_rows_ready_words_1 mod 256;
    transform_left_column(5) <= transform_left_rows_ready_words_1 / 256;
    transform_left_column(6) <= transform_left_rows_ready_newest_0;
    transform_right_column(0) <= to_integer(transform_right_rows_ready_words_0(7 downto 0));
    transform_right_column(1) <= to_integer(transform_right_rows_ready_words_0(15 downto 8));
    transform_right_column(2) <= to_integer(transform_right_rows_ready_words_0(23 downto 16));
    transform_right_column(3) <= to_integer(transform_right_rows_ready_words_0(31 downto 24));
    transform_right_column(4) <= transform_right_rows_ready_words_1 mod 256;
    transform_right_column(5) <= transform_right_rows_ready_words_1 / 256;
    transform_right_column(6) <= transform_right_rows_ready_newest_0;
    transform_columns_row_inside <= transform_ready_row_inside;
    transform_columns_column_inside <= transform_ready_column_inside;
    transform_columns_start_of_frame <= transform_ready_start_of_frame;
    transform_columns_valid <= transform_ready_valid;
    transform_filtering_0_column_inside <= transform_columns_column_inside;
    transform_filtering_start_of_frame(0) <= transform_columns_start_of_frame;
    transform_filtering_valid(0) <= transform_columns_valid;
    transform_filtering_start_of_frame(1) <= transform_filtering_start_of_frame(0);
    transform_filtering_valid(1) <= transform_filtering_valid(0);
    transform_counter_group <= choice(in_valid and in_start_of_frame, transform_counter_group_choice * 32,
      transform_counter_group_choices(3));
    if transform_filtering_0_column_inside(6) then
      transform_left_filter_feature_0 <= to_unsigned(as_number(transform_left_filter_feature_0_choice(56)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(48)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(40)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(32)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(24)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(16)), 1) &
        to_unsigned(as_number(transform_left_filter_feature_0_choice(8)), 1) &
        transform_left_filter_feature_0_choice_390(40 downto 0);
      transform_right_filter_feature_0 <= to_unsigned(as_number(transform_right_filter_feature_0_choice(56)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(48)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(40)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(32)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(24)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(16)), 1) &
        to_unsigned(as_number(transform_right_filter_feature_0_choice(8)), 1) &
        transform_right_filter_feature_0_choice_390(40 downto 0);
    else
      transform_left_filter_feature_0 <= resize(transform_left_filter_feature_0_choice_390, 48);
      transform_right_filter_feature_0 <= resize(transform_right_filter_feature_0_choice_390, 48);
    end if;
    transform_counter_next_frame_choices(1) := choice(transform_counter_group_is_equals(2), (transform_counter_group /=
      482) and transform_counter_next_frame, transform_counter_next_frame);
    transform_counter_next_frame_choices(2) := choice(transform_counter_group_differs,
      transform_counter_next_frame_choices(1), transform_counter_next_frame);
    if in_valid then
      transform_counter_column <= choice(in_start_of_frame or transform_counter_group_is_equals(2), 0,
        (transform_counter_column + 1) mod 512);
      transform_counter_next_frame <= choice(transform_counter_next_frame_choices(2), (not in_start_of_frame) or
        transform_counter_group_all, in_start_of_frame and transform_counter_group_is_equals(1) and
        transform_counter_group_is_equals(2));
    end if;
    if transform_ready_valid then
      transform_left_rows_write_words_0 <= to_unsigned((transform_left_rows_ready_words_1 mod 256), 8) &
        transform_left_rows_ready_words_0(31 downto 8);
      transform_left_rows_write_words_1 <= (transform_left_rows_ready_newest_0 * 256) +
        (transform_left_rows_ready_words_1 / 256);
      transform_right_rows_write_words_0 <= to_unsigned((transform_right_rows_ready_words_1 mod 256), 8) &
        transform_right_rows_ready_words_0(31 downto 8);
      transform_right_rows_write_words_1 <= (transform_right_rows_ready_newest_0 * 256) +
        (transform_right_rows_ready_words_1 / 256);
      transform_write_column <= transform_ready_column;
    end if;
    if transform_columns_valid then
      for i in 0 to 2 loop
        for j in 0 to 6 loop
          transform_left_filter_column(2 * i + 1, j) <= transform_left_filter_column(2 * i, j);
        end loop;
        for j in 0 to 6 loop
          transform_left_filter_column(2 * i + 2, j) <= transform_left_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 2 loop
        for j in 0 to 6 loop
          transform_right_filter_column(2 * i + 1, j) <= transform_right_filter_column(2 * i, j);
        end loop;
        for j in 0 to 6 loop
          transform_right_filter_column(2 * i + 2, j) <= transform_right_filter_column(2 * i + 1, j);
        end loop;
      end loop;
      for i in 0 to 6 loop
        transform_left_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_left_column(i), 0);
        transform_right_filter_column(0, i) <= choice(transform_columns_row_inside(i), transform_right_column(i), 0);
      end loop;
    end if;
    -- raster
    raster_place_group_is_equal := raster_place_column = 511;
    raster_features_search_0 <= transform_left_filter_feature_0;
    raster_features_reference_0 <= transform_right_filter_feature_0;
    raster_features_valid <= transform_filtering_valid(1);
    raster_place_group <= choice(transform_filtering_valid(1) and transform_filtering_start_of_frame(1), 0,
      (raster_place_group + as_number(((raster_place_group /= 483) and transform_filtering_valid(1) and
      raster_place_group_is_equal))) mod 512);
    if transform_filtering_valid(1) then
      raster_place_column <= choice(raster_place_group_is_equal or transform_filtering_start_of_frame(1), 0,
        (raster_place_column + 1) mod 512);
    end if;
    -- delay
    if raster_features_valid then
      delay_ring_write_address <= delay_ring_read_address;
      delay_ring_read_address <= choice(delay_ring_read_address = 51, 0, (delay_ring_read_address + 1) mod 64);
    end if;
    delay_tag_first_cost_is_equal := raster_place_column = 51;
    delay_ahead_0 <= raster_features_search_0;
    delay_column <= raster_place_column;
    delay_row_inside(0) <= (raster_place_group >= 7) and (raster_place_group < 487);
    delay_row_inside(1) <= raster_place_group < 480;
    delay_tag.valid <= raster_features_valid;
    delay_tag.row_start <= raster_place_column = 0;
    delay_tag.first_group <= raster_place_group = 0;
    delay_tag.border_column <= raster_place_column < 51;
    delay_tag.first_cost <= delay_tag_first_cost_is_equal;
    delay_tag.leaves_window <= (((((raster_place_column / 2) + 32739) mod 32768) * 2) + (raster_place_column mod 2)) <
      65481;
    delay_tag.output_column <= (raster_place_group >= 3) and (raster_place_group < 483) and (raster_place_column >= 51)
      and (raster_place_column < 511);
    delay_tag.start_of_frame <= (raster_place_group = 3) and delay_tag_first_cost_is_equal;
    delay_tag.end_of_line <= raster_place_column = 510;
    -- rows
    rows_search_rows_read_newest_0 <= delay_ahead_0;
    rows_search_rows_ready_words <= rows_search_rows_read_words;
    rows_search_rows_ready_newest_0 <= rows_search_rows_read_newest_0;
    rows_reference_rows_read_newest_0 <= delay_delayed_0;
    rows_reference_rows_ready_words <= rows_reference_rows_read_words;
    rows_reference_rows_ready_newest_0 <= rows_reference_rows_read_newest_0;
    rows_read_column <= delay_column;
    rows_read_inside <= delay_row_inside;
    rows_read_tag <= delay_tag;
    rows_ready_column <= rows_read_column;
    rows_ready_inside <= rows_read_inside;
    rows_ready_tag <= rows_read_tag;
    rows_tag <= rows_ready_tag;
    if rows_ready_inside(0) then
      rows_search(0) <= rows_search_rows_ready_words(0);
      rows_reference(0) <= rows_reference_rows_ready_words(0);
    else
      rows_search(0) <= to_unsigned(0, 48); rows_reference(0) <= to_unsigned(0, 48);
    end if;
    if rows_ready_inside(1) then
      rows_search(1) <= rows_search_rows_ready_newest_0;
      rows_reference(1) <= rows_reference_rows_ready_newest_0;
    else
      rows_search(1) <= to_unsigned(0, 48); rows_reference(1) <= to_unsigned(0, 48);
    end if;
    if rows_ready_tag.valid then
      rows_search_rows_write_words(0 to 5) <= rows_search_rows_ready_words(1 to 6);
      rows_search_rows_write_words(6) <= rows_search_rows_ready_newest_0;
      rows_reference_rows_write_words(0 to 5) <= rows_reference_rows_ready_words(1 to 6);
      rows_reference_rows_write_words(6) <= rows_reference_rows_ready_newest_0;
      rows_write_column <= rows_ready_column;
    end if;
    -- slice0shift
    if rows_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 11 loop slice0shift_search(i, j) <= slice0shift_search(i, j + 1); end loop;
        slice0shift_search(i, 12) <= rows_search(i);
      end loop;
    end if;
    slice0shift_reference <= rows_reference;
    slice0shift_search_out(0) <= slice0shift_search(0, 0);
    slice0shift_search_out(1) <= slice0shift_search(1, 0);
    slice0shift_tag <= rows_tag;
    -- slice0cost
    for i in 0 to 3 loop
      slice0cost_column_0_choice(3 * i, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i) mod
        512);
      slice0cost_column_0_choice(3 * i, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3 * i)
        + slice0cost_column_0_choice(3 * i, 1)) mod 512);
      slice0cost_column_0_choice(3 * i + 1, 1) := choice(slice0cost_ready_tag.first_group, 0,
        (slice0cost_ready_words(i) / 512) mod 512);
      slice0cost_column_0_choice(3 * i + 1, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3
        * i + 1) + slice0cost_column_0_choice(3 * i + 1, 1)) mod 512);
      slice0cost_column_0_choice(3 * i + 2, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words(i)
        / 262144);
      slice0cost_column_0_choice(3 * i + 2, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(3
        * i + 2) + slice0cost_column_0_choice(3 * i + 2, 1)) mod 512);
    end loop;
    slice0cost_column_0_choice(12, 1) := choice(slice0cost_ready_tag.first_group, 0, slice0cost_ready_words_4);
    slice0cost_column_0_choice(12, 2) := choice(slice0cost_ready_tag.border_column, 0, (slice0cost_change_0(12) +
      slice0cost_column_0_choice(12, 1)) mod 512);
    for i in 0 to 1 loop
      slice0cost_pixels_first_count(i, 0, 0) <= differing_bits(slice0shift_search(i, 0), slice0shift_reference(i), 0) +
        differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 2) +
        differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 1);
      slice0cost_pixels_first_count(i, 0, 1) <= differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 3,
        5, 4);
      slice0cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search(i, 0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice0shift_reference(i)(7 downto 0)), 8)))) / 128) +
        differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 8) +
        differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 6);
      for j in 3 to 15 loop
        slice0cost_pixels_first_count(i, 0, j) <= differing_bits(slice0shift_reference(i), slice0shift_search(i, 0), 3
          * j, 3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 12 loop
        slice0cost_pixels_first_count(i, j, 0) <= differing_bits(slice0shift_search(i, j), slice0shift_reference(i), 0,
          2, 1);
        slice0cost_pixels_first_count(i, j, 1) <= differing_bits(slice0shift_search(i, j), slice0shift_reference(i), 3,
          5, 4);
        slice0cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned(to_integer(slice0shift_search(i, j)(7
          downto 0)), 8)) xor (to_unsigned(to_integer(slice0shift_reference(i)(7 downto 0)), 8)))) / 128) +
          differing_bits(slice0shift_search(i, j), slice0shift_reference(i), 8) + differing_bits(slice0shift_search(i,
          j), slice0shift_reference(i), 6);
        for k in 3 to 15 loop
          slice0cost_pixels_first_count(i, j, k) <= differing_bits(slice0shift_search(i, j), slice0shift_reference(i),
            3 * k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    slice0cost_pixels_first_tag <= slice0shift_tag;
    for i in 0 to 1 loop
      for j in 0 to 12 loop
        slice0cost_pixels_cost(i, j) <= slice0cost_pixels_first_count(i, j, 4) + slice0cost_pixels_first_count(i, j, 8)
          + slice0cost_pixels_first_count(i, j, 13) + slice0cost_pixels_first_count(i, j, 7) +
          slice0cost_pixels_first_count(i, j, 10) + slice0cost_pixels_first_count(i, j, 15) +
          slice0cost_pixels_first_count(i, j, 12) + slice0cost_pixels_first_count(i, j, 3) +
          slice0cost_pixels_first_count(i, j, 11) + slice0cost_pixels_first_count(i, j, 5) +
          slice0cost_pixels_first_count(i, j, 9) + slice0cost_pixels_first_count(i, j, 2) +
          slice0cost_pixels_first_count(i, j, 1) + slice0cost_pixels_first_count(i, j, 14) +
          slice0cost_pixels_first_count(i, j, 0) + slice0cost_pixels_first_count(i, j, 6);
      end loop;
    end loop;
    slice0cost_pixels_tag <= slice0cost_pixels_first_tag;
    for i in 0 to 12 loop
      slice0cost_change_0(i) <= slice0cost_pixels_cost(1, i) - slice0cost_pixels_cost(0, i);
    end loop;
    slice0cost_ready_words(0) <= to_integer(slice0cost_read_words(0));
    slice0cost_ready_words(1) <= to_integer(slice0cost_read_words(1));
    slice0cost_ready_words(2) <= to_integer(slice0cost_read_words(2));
    slice0cost_ready_words(3) <= to_integer(slice0cost_read_words(3));
    slice0cost_ready_words_4 <= to_integer(slice0cost_read_words_4);
    slice0cost_ready_column <= slice0cost_change_column;
    slice0cost_ready_tag <= slice0cost_pixels_tag;
    for i in 0 to 12 loop slice0cost_column_0(i) <= slice0cost_column_0_choice(i, 2); end loop;
    slice0cost_write_column <= slice0cost_ready_column;
    slice0cost_tag.valid <= slice0cost_ready_tag.valid;
    slice0cost_tag.first_group <= slice0cost_ready_tag.first_group;
    slice0cost_tag.border_column <= slice0cost_ready_tag.border_column;
    slice0cost_tag.first_cost <= slice0cost_ready_tag.first_cost;
    slice0cost_tag.leaves_window <= slice0cost_ready_tag.leaves_window;
    slice0cost_tag.output_column <= slice0cost_ready_tag.output_column;
    slice0cost_tag.start_of_frame <= slice0cost_ready_tag.start_of_frame;
    slice0cost_tag.end_of_line <= slice0cost_ready_tag.end_of_line;
    if slice0shift_tag.valid then
      slice0cost_read_column <= choice(slice0shift_tag.row_start, 0, (slice0cost_read_column + 1) mod 512);
    end if;
    if slice0cost_pixels_first_tag.valid then
      slice0cost_change_column <= choice(slice0cost_pixels_first_tag.row_start, 0, (slice0cost_change_column + 1) mod
        512);
    end if;
    if slice0cost_ready_tag.valid then
      for i in 0 to 3 loop
        slice0cost_write_words(i) <= (slice0cost_column_0_choice(3 * i + 1, 2) * 512) + slice0cost_column_0_choice(3 *
          i, 2) + (slice0cost_column_0_choice(3 * i + 2, 2) * 262144);
      end loop;
      slice0cost_write_words(4) <= slice0cost_column_0_choice(12, 2);
    end if;
    -- slice0window
    if slice0cost_tag.valid then
      slice0window_ring_write_address <= slice0window_ring_read_address;
      slice0window_ring_read_address <= choice(slice0window_ring_read_address = 7, 0, (slice0window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice0window_change_0_choice(3 * i + j) := choice(slice0window_entering_tag.leaves_window,
          to_integer(slice0window_leaving(i)(9 * j + 8 downto 9 * j)), 0);
      end loop;
    end loop;
    slice0window_change_0_choice(12) := choice(slice0window_entering_tag.leaves_window,
      to_integer(slice0window_leaving_4), 0);
    slice0window_entering_0 <= slice0cost_column_0;
    slice0window_entering_tag <= slice0cost_tag;
    for i in 0 to 12 loop
      slice0window_change_0(i) <= slice0window_entering_0(i) - slice0window_change_0_choice(i);
    end loop;
    slice0window_change_tag <= slice0window_entering_tag;
    slice0window_centre_output_column_0 <= slice0window_change_tag.output_column;
    slice0window_centre_first_column_0 <= slice0window_change_tag.first_cost;
    slice0window_centre_start_of_frame(0) <= slice0window_change_tag.start_of_frame;
    slice0window_centre_start_of_frame(1 to 2) <= slice0window_centre_start_of_frame(0 to 1);
    slice0window_centre_end_of_line_0 <= slice0window_change_tag.end_of_line;
    slice0window_tag.valid <= slice0window_change_tag.valid;
    for i in 0 to 12 loop
      slice0window_sum_0_choice(i) := choice(slice0window_change_tag.first_cost, 0, slice0window_sum_0(i));
    end loop;
    if slice0window_change_tag.valid then
      for i in 0 to 12 loop
        slice0window_sum_0(i) <= (slice0window_sum_0_choice(i) + slice0window_change_0(i)) mod 4096;
      end loop;
    end if;
    if slice0winner2_tag.valid then slice0window_tag.start_of_frame <= slice0window_centre_start_of_frame(2); end if;
    -- slice0winner1
    for i in 0 to 5 loop
      slice0winner1_best_cost_0_is_less(i) := (slice0window_sum_0(2 * i + 1) - slice0window_sum_0(2 * i)) < 0;
    end loop;
    slice0winner1_best_cost_0(6) <= slice0window_sum_0(12);
    slice0winner1_best_index_0_0 <= slice0winner1_best_cost_0_is_less(0);
    slice0winner1_best_index_0(6) <= 12;
    slice0winner1_tag.valid <= slice0window_tag.valid;
    slice0winner1_best_cost_0(0) <= choice(slice0winner1_best_cost_0_is_less(0), slice0window_sum_0(1),
      slice0window_sum_0(0));
    for i in 1 to 5 loop
      slice0winner1_best_cost_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), slice0window_sum_0(2 * i + 1),
        slice0window_sum_0(2 * i));
      slice0winner1_best_index_0(i) <= choice(slice0winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    if slice0winner2_tag.valid then slice0winner1_tag.start_of_frame <= slice0window_tag.start_of_frame; end if;
    -- slice0winner2
    for i in 0 to 2 loop
      slice0winner2_best_cost_0_is_less(i) := (slice0winner1_best_cost_0(2 * i + 1) - slice0winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice0winner2_best_cost_0(3) <= slice0winner1_best_cost_0(6);
    slice0winner2_best_index_0(3) <= slice0winner1_best_index_0(6);
    slice0winner2_tag.valid <= slice0winner1_tag.valid;
    slice0winner2_best_cost_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_cost_0(1),
      slice0winner1_best_cost_0(0));
    slice0winner2_best_index_0(0) <= choice(slice0winner2_best_cost_0_is_less(0), slice0winner1_best_index_0(1),
      as_number(slice0winner1_best_index_0_0));
    for i in 1 to 2 loop
      slice0winner2_best_cost_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_cost_0(2 * i +
        1), slice0winner1_best_cost_0(2 * i));
      slice0winner2_best_index_0(i) <= choice(slice0winner2_best_cost_0_is_less(i), slice0winner1_best_index_0(2 * i +
        1), slice0winner1_best_index_0(2 * i));
    end loop;
    if slice0winner2_tag.valid then
      slice0winner2_tag.output_column <= slice3window_centre_output_column(1);
      slice0winner2_tag.start_of_frame <= slice0winner1_tag.start_of_frame;
      slice0winner2_tag.end_of_line <= slice3window_centre_end_of_line(1);
    end if;
    -- slice0winner3
    slice0winner3_best_cost_0_is_less(0) := (slice0winner2_best_cost_0(1) - slice0winner2_best_cost_0(0)) < 0;
    slice0winner3_best_cost_0_is_less(1) := (slice0winner2_best_cost_0(3) - slice0winner2_best_cost_0(2)) < 0;
    slice0winner3_tag <= slice0winner2_tag;
    for i in 0 to 1 loop
      slice0winner3_best_cost_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_cost_0(2 * i +
        1), slice0winner2_best_cost_0(2 * i));
      slice0winner3_best_index_0(i) <= choice(slice0winner3_best_cost_0_is_less(i), slice0winner2_best_index_0(2 * i +
        1), slice0winner2_best_index_0(2 * i));
    end loop;
    -- slice0winner4
    slice0winner4_best_cost_0_0_is_less := (slice0winner3_best_cost_0(1) - slice0winner3_best_cost_0(0)) < 0;
    slice0winner4_tag <= slice0winner3_tag;
    slice0winner4_best_cost_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_cost_0(1),
      slice0winner3_best_cost_0(0));
    slice0winner4_best_index_0_0 <= choice(slice0winner4_best_cost_0_0_is_less, slice0winner3_best_index_0(1),
      slice0winner3_best_index_0(0));
    -- slice0
    slice0_best_cost_0_0 <= slice0winner4_best_cost_0_0;
    slice0_best_index_0_0 <= slice0winner4_best_index_0_0 + 39;
    slice0_best_tag <= slice0winner4_tag;
    -- slice1shift
    if slice0shift_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 11 loop slice1shift_search(i, j) <= slice1shift_search(i, j + 1); end loop;
        slice1shift_search(i, 12) <= slice0shift_search_out(i);
      end loop;
    end if;
    slice1shift_reference <= slice0shift_reference;
    slice1shift_search_out(0) <= slice1shift_search(0, 0);
    slice1shift_search_out(1) <= slice1shift_search(1, 0);
    -- slice1cost
    for i in 0 to 3 loop
      slice1cost_column_0_choice(3 * i, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) mod 512);
      slice1cost_column_0_choice(3 * i, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i) +
        slice1cost_column_0_choice(3 * i, 1)) mod 512);
      slice1cost_column_0_choice(3 * i + 1, 1) := choice(slice0cost_tag.first_group, 0, (slice1cost_ready_words(i) /
        512) mod 512);
      slice1cost_column_0_choice(3 * i + 1, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i +
        1) + slice1cost_column_0_choice(3 * i + 1, 1)) mod 512);
      slice1cost_column_0_choice(3 * i + 2, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words(i) /
        262144);
      slice1cost_column_0_choice(3 * i + 2, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(3 * i +
        2) + slice1cost_column_0_choice(3 * i + 2, 1)) mod 512);
    end loop;
    slice1cost_column_0_choice(12, 1) := choice(slice0cost_tag.first_group, 0, slice1cost_ready_words_4);
    slice1cost_column_0_choice(12, 2) := choice(slice0cost_tag.border_column, 0, (slice1cost_change_0(12) +
      slice1cost_column_0_choice(12, 1)) mod 512);
    for i in 0 to 1 loop
      slice1cost_pixels_first_count(i, 0, 0) <= differing_bits(slice1shift_search(i, 0), slice1shift_reference(i), 0) +
        differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 2) +
        differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 1);
      slice1cost_pixels_first_count(i, 0, 1) <= differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 3,
        5, 4);
      slice1cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search(i, 0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice1shift_reference(i)(7 downto 0)), 8)))) / 128) +
        differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 8) +
        differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 6);
      for j in 3 to 15 loop
        slice1cost_pixels_first_count(i, 0, j) <= differing_bits(slice1shift_reference(i), slice1shift_search(i, 0), 3
          * j, 3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 12 loop
        slice1cost_pixels_first_count(i, j, 0) <= differing_bits(slice1shift_search(i, j), slice1shift_reference(i), 0,
          2, 1);
        slice1cost_pixels_first_count(i, j, 1) <= differing_bits(slice1shift_search(i, j), slice1shift_reference(i), 3,
          5, 4);
        slice1cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned(to_integer(slice1shift_search(i, j)(7
          downto 0)), 8)) xor (to_unsigned(to_integer(slice1shift_reference(i)(7 downto 0)), 8)))) / 128) +
          differing_bits(slice1shift_search(i, j), slice1shift_reference(i), 8) + differing_bits(slice1shift_search(i,
          j), slice1shift_reference(i), 6);
        for k in 3 to 15 loop
          slice1cost_pixels_first_count(i, j, k) <= differing_bits(slice1shift_search(i, j), slice1shift_reference(i),
            3 * k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 12 loop
        slice1cost_pixels_cost(i, j) <= slice1cost_pixels_first_count(i, j, 4) + slice1cost_pixels_first_count(i, j, 8)
          + slice1cost_pixels_first_count(i, j, 13) + slice1cost_pixels_first_count(i, j, 7) +
          slice1cost_pixels_first_count(i, j, 10) + slice1cost_pixels_first_count(i, j, 15) +
          slice1cost_pixels_first_count(i, j, 12) + slice1cost_pixels_first_count(i, j, 3) +
          slice1cost_pixels_first_count(i, j, 11) + slice1cost_pixels_first_count(i, j, 5) +
          slice1cost_pixels_first_count(i, j, 9) + slice1cost_pixels_first_count(i, j, 2) +
          slice1cost_pixels_first_count(i, j, 1) + slice1cost_pixels_first_count(i, j, 14) +
          slice1cost_pixels_first_count(i, j, 0) + slice1cost_pixels_first_count(i, j, 6);
      end loop;
    end loop;
    slice1cost_read_column <= slice0cost_read_column;
    slice1cost_change_column <= slice1cost_read_column;
    for i in 0 to 12 loop
      slice1cost_change_0(i) <= slice1cost_pixels_cost(1, i) - slice1cost_pixels_cost(0, i);
    end loop;
    slice1cost_ready_words(0) <= to_integer(slice1cost_read_words(0));
    slice1cost_ready_words(1) <= to_integer(slice1cost_read_words(1));
    slice1cost_ready_words(2) <= to_integer(slice1cost_read_words(2));
    slice1cost_ready_words(3) <= to_integer(slice1cost_read_words(3));
    slice1cost_ready_words_4 <= to_integer(slice1cost_read_words_4);
    for i in 0 to 12 loop slice1cost_column_0(i) <= slice1cost_column_0_choice(i, 2); end loop;
    if slice0cost_ready_tag.valid then slice1cost_ready_column <= slice1cost_change_column; end if;
    if slice0cost_tag.valid then
      slice1cost_write_column <= slice0cost_write_column;
      for i in 0 to 3 loop
        slice1cost_write_words(i) <= (slice1cost_column_0_choice(3 * i + 1, 2) * 512) + slice1cost_column_0_choice(3 *
          i, 2) + (slice1cost_column_0_choice(3 * i + 2, 2) * 262144);
      end loop;
      slice1cost_write_words(4) <= slice1cost_column_0_choice(12, 2);
    end if;
    -- slice1window
    if slice0window_entering_tag.valid then
      slice1window_ring_write_address <= slice1window_ring_read_address;
      slice1window_ring_read_address <= choice(slice1window_ring_read_address = 7, 0, (slice1window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice1window_change_0_choice(3 * i + j) := choice(slice0window_change_tag.leaves_window,
          to_integer(slice1window_leaving(i)(9 * j + 8 downto 9 * j)), 0);
      end loop;
    end loop;
    slice1window_change_0_choice(12) := choice(slice0window_change_tag.leaves_window,
      to_integer(slice1window_leaving_4), 0);
    slice1window_entering_0 <= slice1cost_column_0;
    for i in 0 to 12 loop
      slice1window_change_0(i) <= slice1window_entering_0(i) - slice1window_change_0_choice(i);
    end loop;
    slice1window_change_tag_leaves_window <= slice0window_change_tag.leaves_window;
    slice1window_centre_output_column_0 <= slice0window_centre_output_column_0;
    slice1window_centre_first_column_0 <= slice0window_centre_first_column_0;
    slice1window_centre_end_of_line_0 <= slice0window_centre_end_of_line_0;
    for i in 0 to 12 loop
      slice1window_sum_0_choice(i) := choice(slice0window_centre_first_column_0, 0, slice1window_sum_0(i));
    end loop;
    if slice0window_tag.valid then
      for i in 0 to 12 loop
        slice1window_sum_0(i) <= (slice1window_sum_0_choice(i) + slice1window_change_0(i)) mod 4096;
      end loop;
    end if;
    -- slice1winner1
    for i in 0 to 5 loop
      slice1winner1_best_cost_0_is_less(i) := (slice1window_sum_0(2 * i + 1) - slice1window_sum_0(2 * i)) < 0;
    end loop;
    slice1winner1_best_cost_0(6) <= slice1window_sum_0(12);
    slice1winner1_best_index_0_0 <= slice1winner1_best_cost_0_is_less(0);
    slice1winner1_best_cost_0(0) <= choice(slice1winner1_best_cost_0_is_less(0), slice1window_sum_0(1),
      slice1window_sum_0(0));
    for i in 1 to 5 loop
      slice1winner1_best_cost_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), slice1window_sum_0(2 * i + 1),
        slice1window_sum_0(2 * i));
      slice1winner1_best_index_0(i) <= choice(slice1winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice1winner2
    for i in 0 to 2 loop
      slice1winner2_best_cost_0_is_less(i) := (slice1winner1_best_cost_0(2 * i + 1) - slice1winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice1winner2_best_cost_0(3) <= slice1winner1_best_cost_0(6);
    slice1winner2_best_cost_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_cost_0(1),
      slice1winner1_best_cost_0(0));
    slice1winner2_best_index_0(0) <= choice(slice1winner2_best_cost_0_is_less(0), slice1winner1_best_index_0(1),
      as_number(slice1winner1_best_index_0_0));
    for i in 1 to 2 loop
      slice1winner2_best_cost_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_cost_0(2 * i +
        1), slice1winner1_best_cost_0(2 * i));
      slice1winner2_best_index_0(i) <= choice(slice1winner2_best_cost_0_is_less(i), slice1winner1_best_index_0(2 * i +
        1), slice1winner1_best_index_0(2 * i));
    end loop;
    -- slice1winner3
    slice1winner3_best_cost_0_is_less(0) := (slice1winner2_best_cost_0(1) - slice1winner2_best_cost_0(0)) < 0;
    slice1winner3_best_cost_0_is_less(1) := (slice1winner2_best_cost_0(3) - slice1winner2_best_cost_0(2)) < 0;
    slice1winner3_best_cost_0(0) <= choice(slice1winner3_best_cost_0_is_less(0), slice1winner2_best_cost_0(1),
      slice1winner2_best_cost_0(0));
    slice1winner3_best_index_0(0) <= choice(slice1winner3_best_cost_0_is_less(0), slice1winner2_best_index_0(1),
      slice1winner2_best_index_0(0));
    slice1winner3_best_cost_0(1) <= choice(slice1winner3_best_cost_0_is_less(1), slice1winner2_best_cost_0(3),
      slice1winner2_best_cost_0(2));
    slice1winner3_best_index_0(1) <= choice(slice1winner3_best_cost_0_is_less(1), slice0winner2_best_index_0(3),
      slice1winner2_best_index_0(2));
    -- slice1winner4
    slice1winner4_best_cost_0_0_is_less := (slice1winner3_best_cost_0(1) - slice1winner3_best_cost_0(0)) < 0;
    slice1winner4_best_cost_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_cost_0(1),
      slice1winner3_best_cost_0(0));
    slice1winner4_best_index_0_0 <= choice(slice1winner4_best_cost_0_0_is_less, slice1winner3_best_index_0(1),
      slice1winner3_best_index_0(0));
    -- slice1
    slice1_best_cost_0_0_is_less := (slice0_best_cost_0_0 - slice1winner4_best_cost_0_0) < 0;
    slice1_best_tag <= slice0_best_tag;
    slice1_best_cost_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_cost_0_0, slice1winner4_best_cost_0_0);
    slice1_best_index_0_0 <= choice(slice1_best_cost_0_0_is_less, slice0_best_index_0_0,
      (((slice1winner4_best_index_0_0 / 2) + 13) * 2) + (slice1winner4_best_index_0_0 mod 2));
    -- slice2shift
    if slice0cost_pixels_first_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 11 loop slice2shift_search(i, j) <= slice2shift_search(i, j + 1); end loop;
        slice2shift_search(i, 12) <= slice1shift_search_out(i);
      end loop;
    end if;
    slice2shift_reference <= slice1shift_reference;
    slice2shift_search_out(0) <= slice2shift_search(0, 0);
    slice2shift_search_out(1) <= slice2shift_search(1, 0);
    -- slice2cost
    for i in 0 to 3 loop
      slice2cost_column_0_choice(3 * i, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) mod 512);
      slice2cost_column_0_choice(3 * i, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(3
        * i) + slice2cost_column_0_choice(3 * i, 1)) mod 512);
      slice2cost_column_0_choice(3 * i + 1, 1) := choice(slice0window_entering_tag.first_group, 0,
        (slice2cost_ready_words(i) / 512) mod 512);
      slice2cost_column_0_choice(3 * i + 1, 2) := choice(slice0window_entering_tag.border_column, 0,
        (slice2cost_change_0(3 * i + 1) + slice2cost_column_0_choice(3 * i + 1, 1)) mod 512);
      slice2cost_column_0_choice(3 * i + 2, 1) := choice(slice0window_entering_tag.first_group, 0,
        slice2cost_ready_words(i) / 262144);
      slice2cost_column_0_choice(3 * i + 2, 2) := choice(slice0window_entering_tag.border_column, 0,
        (slice2cost_change_0(3 * i + 2) + slice2cost_column_0_choice(3 * i + 2, 1)) mod 512);
    end loop;
    slice2cost_column_0_choice(12, 1) := choice(slice0window_entering_tag.first_group, 0, slice2cost_ready_words_4);
    slice2cost_column_0_choice(12, 2) := choice(slice0window_entering_tag.border_column, 0, (slice2cost_change_0(12) +
      slice2cost_column_0_choice(12, 1)) mod 512);
    for i in 0 to 1 loop
      slice2cost_pixels_first_count(i, 0, 0) <= differing_bits(slice2shift_search(i, 0), slice2shift_reference(i), 0) +
        differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 2) +
        differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 1);
      slice2cost_pixels_first_count(i, 0, 1) <= differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 3,
        5, 4);
      slice2cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search(i, 0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice2shift_reference(i)(7 downto 0)), 8)))) / 128) +
        differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 8) +
        differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 6);
      for j in 3 to 15 loop
        slice2cost_pixels_first_count(i, 0, j) <= differing_bits(slice2shift_reference(i), slice2shift_search(i, 0), 3
          * j, 3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 12 loop
        slice2cost_pixels_first_count(i, j, 0) <= differing_bits(slice2shift_search(i, j), slice2shift_reference(i), 0,
          2, 1);
        slice2cost_pixels_first_count(i, j, 1) <= differing_bits(slice2shift_search(i, j), slice2shift_reference(i), 3,
          5, 4);
        slice2cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned(to_integer(slice2shift_search(i, j)(7
          downto 0)), 8)) xor (to_unsigned(to_integer(slice2shift_reference(i)(7 downto 0)), 8)))) / 128) +
          differing_bits(slice2shift_search(i, j), slice2shift_reference(i), 8) + differing_bits(slice2shift_search(i,
          j), slice2shift_reference(i), 6);
        for k in 3 to 15 loop
          slice2cost_pixels_first_count(i, j, k) <= differing_bits(slice2shift_search(i, j), slice2shift_reference(i),
            3 * k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 12 loop
        slice2cost_pixels_cost(i, j) <= slice2cost_pixels_first_count(i, j, 4) + slice2cost_pixels_first_count(i, j, 8)
          + slice2cost_pixels_first_count(i, j, 13) + slice2cost_pixels_first_count(i, j, 7) +
          slice2cost_pixels_first_count(i, j, 10) + slice2cost_pixels_first_count(i, j, 15) +
          slice2cost_pixels_first_count(i, j, 12) + slice2cost_pixels_first_count(i, j, 3) +
          slice2cost_pixels_first_count(i, j, 11) + slice2cost_pixels_first_count(i, j, 5) +
          slice2cost_pixels_first_count(i, j, 9) + slice2cost_pixels_first_count(i, j, 2) +
          slice2cost_pixels_first_count(i, j, 1) + slice2cost_pixels_first_count(i, j, 14) +
          slice2cost_pixels_first_count(i, j, 0) + slice2cost_pixels_first_count(i, j, 6);
      end loop;
    end loop;
    for i in 0 to 12 loop
      slice2cost_change_0(i) <= slice2cost_pixels_cost(1, i) - slice2cost_pixels_cost(0, i);
    end loop;
    slice2cost_ready_words(0) <= to_integer(slice2cost_read_words(0));
    slice2cost_ready_words(1) <= to_integer(slice2cost_read_words(1));
    slice2cost_ready_words(2) <= to_integer(slice2cost_read_words(2));
    slice2cost_ready_words(3) <= to_integer(slice2cost_read_words(3));
    slice2cost_ready_words_4 <= to_integer(slice2cost_read_words_4);
    slice2cost_ready_column <= slice2cost_change_column;
    for i in 0 to 12 loop slice2cost_column_0(i) <= slice2cost_column_0_choice(i, 2); end loop;
    slice2cost_write_column <= slice2cost_ready_column;
    if slice0cost_pixels_tag.valid then
      slice2cost_read_column <= choice(slice0cost_pixels_tag.row_start, 0, (slice2cost_read_column + 1) mod 512);
    end if;
    if slice0cost_ready_tag.valid then
      slice2cost_change_column <= choice(slice0cost_ready_tag.row_start, 0, (slice2cost_change_column + 1) mod 512);
    end if;
    if slice0window_entering_tag.valid then
      for i in 0 to 3 loop
        slice2cost_write_words(i) <= (slice2cost_column_0_choice(3 * i + 1, 2) * 512) + slice2cost_column_0_choice(3 *
          i, 2) + (slice2cost_column_0_choice(3 * i + 2, 2) * 262144);
      end loop;
      slice2cost_write_words(4) <= slice2cost_column_0_choice(12, 2);
    end if;
    -- slice2window
    if slice0window_change_tag.valid then
      slice2window_ring_write_address <= slice2window_ring_read_address;
      slice2window_ring_read_address <= choice(slice2window_ring_read_address = 7, 0, (slice2window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice2window_change_0_choice(3 * i + j) := choice(slice1window_change_tag_leaves_window,
          to_integer(slice2window_leaving(i)(9 * j + 8 downto 9 * j)), 0);
      end loop;
    end loop;
    slice2window_change_0_choice(12) := choice(slice1window_change_tag_leaves_window,
      to_integer(slice2window_leaving_4), 0);
    slice2window_entering_0 <= slice2cost_column_0;
    for i in 0 to 12 loop
      slice2window_change_0(i) <= slice2window_entering_0(i) - slice2window_change_0_choice(i);
    end loop;
    slice2window_change_tag_leaves_window <= slice1window_change_tag_leaves_window;
    slice2window_centre_output_column_0 <= slice1window_centre_output_column_0;
    slice2window_centre_first_column_0 <= slice1window_centre_first_column_0;
    slice2window_centre_end_of_line_0 <= slice1window_centre_end_of_line_0;
    for i in 0 to 12 loop
      slice2window_sum_0_choice(i) := choice(slice1window_centre_first_column_0, 0, slice2window_sum_0(i));
    end loop;
    if slice0winner1_tag.valid then
      for i in 0 to 12 loop
        slice2window_sum_0(i) <= (slice2window_sum_0_choice(i) + slice2window_change_0(i)) mod 4096;
      end loop;
    end if;
    -- slice2winner1
    for i in 0 to 5 loop
      slice2winner1_best_cost_0_is_less(i) := (slice2window_sum_0(2 * i + 1) - slice2window_sum_0(2 * i)) < 0;
    end loop;
    slice2winner1_best_cost_0(6) <= slice2window_sum_0(12);
    slice2winner1_best_index_0_0 <= slice2winner1_best_cost_0_is_less(0);
    slice2winner1_best_cost_0(0) <= choice(slice2winner1_best_cost_0_is_less(0), slice2window_sum_0(1),
      slice2window_sum_0(0));
    for i in 1 to 5 loop
      slice2winner1_best_cost_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), slice2window_sum_0(2 * i + 1),
        slice2window_sum_0(2 * i));
      slice2winner1_best_index_0(i) <= choice(slice2winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice2winner2
    for i in 0 to 2 loop
      slice2winner2_best_cost_0_is_less(i) := (slice2winner1_best_cost_0(2 * i + 1) - slice2winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice2winner2_best_cost_0(3) <= slice2winner1_best_cost_0(6);
    slice2winner2_best_cost_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_cost_0(1),
      slice2winner1_best_cost_0(0));
    slice2winner2_best_index_0(0) <= choice(slice2winner2_best_cost_0_is_less(0), slice2winner1_best_index_0(1),
      as_number(slice2winner1_best_index_0_0));
    for i in 1 to 2 loop
      slice2winner2_best_cost_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_cost_0(2 * i +
        1), slice2winner1_best_cost_0(2 * i));
      slice2winner2_best_index_0(i) <= choice(slice2winner2_best_cost_0_is_less(i), slice2winner1_best_index_0(2 * i +
        1), slice2winner1_best_index_0(2 * i));
    end loop;
    -- slice2winner3
    slice2winner3_best_cost_0_is_less(0) := (slice2winner2_best_cost_0(1) - slice2winner2_best_cost_0(0)) < 0;
    slice2winner3_best_cost_0_is_less(1) := (slice2winner2_best_cost_0(3) - slice2winner2_best_cost_0(2)) < 0;
    slice2winner3_best_cost_0(0) <= choice(slice2winner3_best_cost_0_is_less(0), slice2winner2_best_cost_0(1),
      slice2winner2_best_cost_0(0));
    slice2winner3_best_index_0(0) <= choice(slice2winner3_best_cost_0_is_less(0), slice2winner2_best_index_0(1),
      slice2winner2_best_index_0(0));
    slice2winner3_best_cost_0(1) <= choice(slice2winner3_best_cost_0_is_less(1), slice2winner2_best_cost_0(3),
      slice2winner2_best_cost_0(2));
    slice2winner3_best_index_0(1) <= choice(slice2winner3_best_cost_0_is_less(1), slice0winner2_best_index_0(3),
      slice2winner2_best_index_0(2));
    -- slice2winner4
    slice2winner4_best_cost_0_0_is_less := (slice2winner3_best_cost_0(1) - slice2winner3_best_cost_0(0)) < 0;
    slice2winner4_best_cost_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_cost_0(1),
      slice2winner3_best_cost_0(0));
    slice2winner4_best_index_0_0 <= choice(slice2winner4_best_cost_0_0_is_less, slice2winner3_best_index_0(1),
      slice2winner3_best_index_0(0));
    -- slice2
    slice2_best_cost_0_0_is_less := (slice1_best_cost_0_0 - slice2winner4_best_cost_0_0) < 0;
    slice2_best_tag <= slice1_best_tag;
    slice2_best_cost_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_cost_0_0, slice2winner4_best_cost_0_0);
    slice2_best_index_0_0 <= choice(slice2_best_cost_0_0_is_less, slice1_best_index_0_0, slice2winner4_best_index_0_0 +
      13);
    -- slice3shift
    if slice0cost_pixels_tag.valid then
      for i in 0 to 1 loop
        for j in 0 to 11 loop slice3shift_search(i, j) <= slice3shift_search(i, j + 1); end loop;
        slice3shift_search(i, 12) <= slice2shift_search_out(i);
      end loop;
    end if;
    slice3shift_reference <= slice2shift_reference;
    -- slice3cost
    for i in 0 to 3 loop
      slice3cost_column_0_choice(3 * i, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words(i)
        mod 512);
      slice3cost_column_0_choice(3 * i, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(3 *
        i) + slice3cost_column_0_choice(3 * i, 1)) mod 512);
      slice3cost_column_0_choice(3 * i + 1, 1) := choice(slice0window_change_tag.first_group, 0,
        (slice3cost_ready_words(i) / 512) mod 512);
      slice3cost_column_0_choice(3 * i + 1, 2) := choice(slice0window_change_tag.border_column, 0,
        (slice3cost_change_0(3 * i + 1) + slice3cost_column_0_choice(3 * i + 1, 1)) mod 512);
      slice3cost_column_0_choice(3 * i + 2, 1) := choice(slice0window_change_tag.first_group, 0,
        slice3cost_ready_words(i) / 262144);
      slice3cost_column_0_choice(3 * i + 2, 2) := choice(slice0window_change_tag.border_column, 0,
        (slice3cost_change_0(3 * i + 2) + slice3cost_column_0_choice(3 * i + 2, 1)) mod 512);
    end loop;
    slice3cost_column_0_choice(12, 1) := choice(slice0window_change_tag.first_group, 0, slice3cost_ready_words_4);
    slice3cost_column_0_choice(12, 2) := choice(slice0window_change_tag.border_column, 0, (slice3cost_change_0(12) +
      slice3cost_column_0_choice(12, 1)) mod 512);
    for i in 0 to 1 loop
      slice3cost_pixels_first_count(i, 0, 0) <= differing_bits(slice3shift_search(i, 0), slice3shift_reference(i), 0) +
        differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 2) +
        differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 1);
      slice3cost_pixels_first_count(i, 0, 1) <= differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 3,
        5, 4);
      slice3cost_pixels_first_count(i, 0, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search(i, 0)(7 downto
        0)), 8)) xor (to_unsigned(to_integer(slice3shift_reference(i)(7 downto 0)), 8)))) / 128) +
        differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 8) +
        differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 6);
      for j in 3 to 15 loop
        slice3cost_pixels_first_count(i, 0, j) <= differing_bits(slice3shift_reference(i), slice3shift_search(i, 0), 3
          * j, 3 * j + 2, 3 * j + 1);
      end loop;
      for j in 1 to 12 loop
        slice3cost_pixels_first_count(i, j, 0) <= differing_bits(slice3shift_search(i, j), slice3shift_reference(i), 0,
          2, 1);
        slice3cost_pixels_first_count(i, j, 1) <= differing_bits(slice3shift_search(i, j), slice3shift_reference(i), 3,
          5, 4);
        slice3cost_pixels_first_count(i, j, 2) <= (to_integer(((to_unsigned(to_integer(slice3shift_search(i, j)(7
          downto 0)), 8)) xor (to_unsigned(to_integer(slice3shift_reference(i)(7 downto 0)), 8)))) / 128) +
          differing_bits(slice3shift_search(i, j), slice3shift_reference(i), 8) + differing_bits(slice3shift_search(i,
          j), slice3shift_reference(i), 6);
        for k in 3 to 15 loop
          slice3cost_pixels_first_count(i, j, k) <= differing_bits(slice3shift_search(i, j), slice3shift_reference(i),
            3 * k, 3 * k + 2, 3 * k + 1);
        end loop;
      end loop;
    end loop;
    for i in 0 to 1 loop
      for j in 0 to 12 loop
        slice3cost_pixels_cost(i, j) <= slice3cost_pixels_first_count(i, j, 4) + slice3cost_pixels_first_count(i, j, 8)
          + slice3cost_pixels_first_count(i, j, 13) + slice3cost_pixels_first_count(i, j, 7) +
          slice3cost_pixels_first_count(i, j, 10) + slice3cost_pixels_first_count(i, j, 15) +
          slice3cost_pixels_first_count(i, j, 12) + slice3cost_pixels_first_count(i, j, 3) +
          slice3cost_pixels_first_count(i, j, 11) + slice3cost_pixels_first_count(i, j, 5) +
          slice3cost_pixels_first_count(i, j, 9) + slice3cost_pixels_first_count(i, j, 2) +
          slice3cost_pixels_first_count(i, j, 1) + slice3cost_pixels_first_count(i, j, 14) +
          slice3cost_pixels_first_count(i, j, 0) + slice3cost_pixels_first_count(i, j, 6);
      end loop;
    end loop;
    slice3cost_read_column <= slice2cost_read_column;
    slice3cost_change_column <= slice3cost_read_column;
    for i in 0 to 12 loop
      slice3cost_change_0(i) <= slice3cost_pixels_cost(1, i) - slice3cost_pixels_cost(0, i);
    end loop;
    slice3cost_ready_words(0) <= to_integer(slice3cost_read_words(0));
    slice3cost_ready_words(1) <= to_integer(slice3cost_read_words(1));
    slice3cost_ready_words(2) <= to_integer(slice3cost_read_words(2));
    slice3cost_ready_words(3) <= to_integer(slice3cost_read_words(3));
    slice3cost_ready_words_4 <= to_integer(slice3cost_read_words_4);
    for i in 0 to 12 loop slice3cost_column_0(i) <= slice3cost_column_0_choice(i, 2); end loop;
    if slice0window_entering_tag.valid then slice3cost_ready_column <= slice3cost_change_column; end if;
    if slice0window_change_tag.valid then
      slice3cost_write_column <= slice2cost_write_column;
      for i in 0 to 3 loop
        slice3cost_write_words(i) <= (slice3cost_column_0_choice(3 * i + 1, 2) * 512) + slice3cost_column_0_choice(3 *
          i, 2) + (slice3cost_column_0_choice(3 * i + 2, 2) * 262144);
      end loop;
      slice3cost_write_words(4) <= slice3cost_column_0_choice(12, 2);
    end if;
    -- slice3window
    if slice0window_tag.valid then
      slice3window_ring_write_address <= slice3window_ring_read_address;
      slice3window_ring_read_address <= choice(slice3window_ring_read_address = 7, 0, (slice3window_ring_read_address +
        1) mod 8);
    end if;
    for i in 0 to 3 loop
      for j in 0 to 2 loop
        slice3window_change_0_choice(3 * i + j) := choice(slice2window_change_tag_leaves_window,
          to_integer(slice3window_leaving(i)(9 * j + 8 downto 9 * j)), 0);
      end loop;
    end loop;
    slice3window_change_0_choice(12) := choice(slice2window_change_tag_leaves_window,
      to_integer(slice3window_leaving_4), 0);
    slice3window_entering_0 <= slice3cost_column_0;
    for i in 0 to 12 loop
      slice3window_change_0(i) <= slice3window_entering_0(i) - slice3window_change_0_choice(i);
    end loop;
    for i in 0 to 12 loop
      slice3window_sum_0_choice(i) := choice(slice2window_centre_first_column_0, 0, slice3window_sum_0(i));
    end loop;
    if slice0winner2_tag.valid then
      for i in 0 to 12 loop
        slice3window_sum_0(i) <= (slice3window_sum_0_choice(i) + slice3window_change_0(i)) mod 4096;
      end loop;
      slice3window_centre_output_column(0) <= slice2window_centre_output_column_0;
      slice3window_centre_output_column(1) <= slice3window_centre_output_column(0);
      slice3window_centre_end_of_line(0) <= slice2window_centre_end_of_line_0;
      slice3window_centre_end_of_line(1) <= slice3window_centre_end_of_line(0);
    end if;
    -- slice3winner1
    for i in 0 to 5 loop
      slice3winner1_best_cost_0_is_less(i) := (slice3window_sum_0(2 * i + 1) - slice3window_sum_0(2 * i)) < 0;
    end loop;
    slice3winner1_best_cost_0(6) <= slice3window_sum_0(12);
    slice3winner1_best_index_0_0 <= slice3winner1_best_cost_0_is_less(0);
    slice3winner1_best_cost_0(0) <= choice(slice3winner1_best_cost_0_is_less(0), slice3window_sum_0(1),
      slice3window_sum_0(0));
    for i in 1 to 5 loop
      slice3winner1_best_cost_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), slice3window_sum_0(2 * i + 1),
        slice3window_sum_0(2 * i));
      slice3winner1_best_index_0(i) <= choice(slice3winner1_best_cost_0_is_less(i), 2 * i + 1, 2 * i);
    end loop;
    -- slice3winner2
    for i in 0 to 2 loop
      slice3winner2_best_cost_0_is_less(i) := (slice3winner1_best_cost_0(2 * i + 1) - slice3winner1_best_cost_0(2 * i))
        < 0;
    end loop;
    slice3winner2_best_cost_0(3) <= slice3winner1_best_cost_0(6);
    slice3winner2_best_cost_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_cost_0(1),
      slice3winner1_best_cost_0(0));
    slice3winner2_best_index_0(0) <= choice(slice3winner2_best_cost_0_is_less(0), slice3winner1_best_index_0(1),
      as_number(slice3winner1_best_index_0_0));
    for i in 1 to 2 loop
      slice3winner2_best_cost_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_cost_0(2 * i +
        1), slice3winner1_best_cost_0(2 * i));
      slice3winner2_best_index_0(i) <= choice(slice3winner2_best_cost_0_is_less(i), slice3winner1_best_index_0(2 * i +
        1), slice3winner1_best_index_0(2 * i));
    end loop;
    -- slice3winner3
    slice3winner3_best_cost_0_is_less(0) := (slice3winner2_best_cost_0(1) - slice3winner2_best_cost_0(0)) < 0;
    slice3winner3_best_cost_0_is_less(1) := (slice3winner2_best_cost_0(3) - slice3winner2_best_cost_0(2)) < 0;
    slice3winner3_best_cost_0(0) <= choice(slice3winner3_best_cost_0_is_less(0), slice3winner2_best_cost_0(1),
      slice3winner2_best_cost_0(0));
    slice3winner3_best_index_0(0) <= choice(slice3winner3_best_cost_0_is_less(0), slice3winner2_best_index_0(1),
      slice3winner2_best_index_0(0));
    slice3winner3_best_cost_0(1) <= choice(slice3winner3_best_cost_0_is_less(1), slice3winner2_best_cost_0(3),
      slice3winner2_best_cost_0(2));
    slice3winner3_best_index_0(1) <= choice(slice3winner3_best_cost_0_is_less(1), slice0winner2_best_index_0(3),
      slice3winner2_best_index_0(2));
    -- slice3winner4
    slice3winner4_best_cost_0_0_is_less := (slice3winner3_best_cost_0(1) - slice3winner3_best_cost_0(0)) < 0;
    slice3winner4_best_cost_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner3_best_cost_0(1),
      slice3winner3_best_cost_0(0));
    slice3winner4_best_index_0_0 <= choice(slice3winner4_best_cost_0_0_is_less, slice3winner3_best_index_0(1),
      slice3winner3_best_index_0(0));
    -- slice3
    slice3_best_tag <= slice2_best_tag;
    slice3_best_index_0_0 <= choice((slice2_best_cost_0_0 - slice3winner4_best_cost_0_0) < 0, slice2_best_index_0_0,
      slice3winner4_best_index_0_0);
    if reset = '1' then
      transform_valid <= false; transform_counter_column <= 0; transform_counter_group <= 483;
      transform_counter_next_frame <= false; transform_read_column <= 0; transform_read_start_of_frame <= false;
      transform_read_valid <= false; transform_ready_column <= 0; transform_ready_start_of_frame <= false;
      transform_ready_valid <= false; transform_write_column <= 0; transform_columns_start_of_frame <= false;
      transform_columns_valid <= false; transform_filtering_start_of_frame(0) <= false;
      transform_filtering_valid(0) <= false; transform_filtering_start_of_frame(1) <= false;
      transform_filtering_valid(1) <= false; raster_features_valid <= false; raster_place_column <= 0;
      raster_place_group <= 483; delay_ring_read_address <= 1; delay_ring_write_address <= 0; delay_column <= 0;
      delay_tag.valid <= false; delay_tag.row_start <= false; delay_tag.output_column <= false;
      delay_tag.start_of_frame <= false; delay_tag.end_of_line <= false; rows_read_column <= 0;
      rows_read_tag.valid <= false; rows_read_tag.row_start <= false; rows_read_tag.output_column <= false;
      rows_read_tag.start_of_frame <= false; rows_read_tag.end_of_line <= false; rows_ready_column <= 0;
      rows_ready_tag.valid <= false; rows_ready_tag.row_start <= false; rows_ready_tag.output_column <= false;
      rows_ready_tag.start_of_frame <= false; rows_ready_tag.end_of_line <= false; rows_write_column <= 0;
      rows_tag.valid <= false; rows_tag.row_start <= false; rows_tag.output_column <= false;
      rows_tag.start_of_frame <= false; rows_tag.end_of_line <= false; slice0shift_tag.valid <= false;
      slice0shift_tag.row_start <= false; slice0shift_tag.output_column <= false;
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
      slice0cost_tag.output_column <= false; slice0cost_tag.start_of_frame <= false;
      slice0cost_tag.end_of_line <= false; slice0window_ring_read_address <= 1; slice0window_ring_write_address <= 0;
      slice0window_entering_tag.valid <= false; slice0window_entering_tag.output_column <= false;
      slice0window_entering_tag.start_of_frame <= false; slice0window_entering_tag.end_of_line <= false;
      slice0window_change_tag.valid <= false; slice0window_change_tag.output_column <= false;
      slice0window_change_tag.start_of_frame <= false; slice0window_change_tag.end_of_line <= false;
      slice0window_centre_output_column_0 <= false; slice0window_centre_start_of_frame <= (others => false);
      slice0window_centre_end_of_line_0 <= false; slice0window_tag <= (others => false);
      slice0winner1_tag <= (others => false); slice0winner2_tag <= (others => false);
      slice0winner3_tag <= (others => false); slice0winner4_tag <= (others => false);
      slice0_best_tag <= (others => false); slice1cost_read_column <= 0; slice1cost_change_column <= 0;
      slice1cost_ready_column <= 0; slice1cost_write_column <= 0; slice1window_ring_read_address <= 1;
      slice1window_ring_write_address <= 0; slice1window_centre_output_column_0 <= false;
      slice1window_centre_end_of_line_0 <= false; slice1_best_tag <= (others => false); slice2cost_read_column <= 0;
      slice2cost_change_column <= 0; slice2cost_ready_column <= 0; slice2cost_write_column <= 0;
      slice2window_ring_read_address <= 1; slice2window_ring_write_address <= 0;
      slice2window_centre_output_column_0 <= false; slice2window_centre_end_of_line_0 <= false;
      slice2_best_tag <= (others => false); slice3cost_read_column <= 0; slice3cost_change_column <= 0;
      slice3cost_ready_column <= 0; slice3cost_write_column <= 0; slice3window_ring_read_address <= 1;
      slice3window_ring_write_address <= 0; slice3window_centre_output_column <= (others => false);
      slice3window_centre_end_of_line <= (others => false); slice3_best_tag <= (others => false);
    end if;
  end process;
end architecture;
