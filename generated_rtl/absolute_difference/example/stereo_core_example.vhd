-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, absolute difference, configuration example: 24x8, absolute difference, valid from 0 on, 1 pixel pair a clock.
-- Options: none.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config example
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_example is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 24;
    height_px : positive := 8;
    disparities : positive := 256;
    pixels_per_clock : positive := 1;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 2;
    flush_groups : natural := 0;
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
  assert width_px = 24 report "stereo_core_example: width_px is " & integer'image(width_px) & " but this core has 24" severity failure;
  assert height_px = 8 report "stereo_core_example: height_px is " & integer'image(height_px) & " but this core has 8" severity failure;
  assert disparities = 256 report "stereo_core_example: disparities is " & integer'image(disparities) & " but this core has 256" severity failure;
  assert pixels_per_clock = 1 report "stereo_core_example: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 1" severity failure;
  assert disparity_bits = 8 report "stereo_core_example: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_example: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 2 report "stereo_core_example: latency_clocks is " & integer'image(latency_clocks) & " but this core has 2" severity failure;
  assert flush_groups = 0 report "stereo_core_example: flush_groups is " & integer'image(flush_groups) & " but this core has 0" severity failure;
  assert gap_groups = 0 report "stereo_core_example: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_example is
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
  -- place
  signal place_column : natural range 0 to 31;
  signal place_group : natural range 0 to 15;
  -- input
  signal input_difference_0 : integer range -255 to 255;
  signal input_starts, input_valid : boolean;
  -- map
  signal map_magnitude_0 : natural range 0 to 255;
  signal map_inside, map_start_of_frame, map_end_of_line, map_valid : boolean;

begin
  in_start_of_frame <= start_of_frame = '1';
  in_valid <= valid = '1';
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  disparity <= std_logic_vector(to_unsigned(map_magnitude_0, 8));
  pixel_valid <= std_logic_vector(to_unsigned(1, 1));
  disparity_valid <= as_bit(map_valid and map_inside);
  disparity_start_of_frame <= as_bit(map_start_of_frame and map_valid and map_inside);
  disparity_end_of_line <= as_bit(map_end_of_line and map_valid and map_inside);


  process (clock)
    variable place_column_is_equal : boolean;
  begin
    if rising_edge(clock) then
      -- place
      place_column_is_equal := place_column = 23;
      if in_valid then
        if place_column_is_equal or in_start_of_frame then
          place_column <= 0;
        else
          place_column <= (place_column + 1) mod 32;
        end if;
      end if;
      if in_start_of_frame and in_valid then
        place_group <= 0;
      else
        place_group <= (place_group + as_number((place_column_is_equal and (place_group /= 8) and in_valid))) mod 16;
      end if;
      -- input
      input_difference_0 <= in_left_pixel - in_right_pixel;
      input_starts <= in_start_of_frame;
      input_valid <= in_valid;
      -- map
      map_magnitude_0 <= magnitude(input_difference_0);
      map_inside <= (not ((place_group / 8) = 1)) or (((place_group / 4) mod 2) = 1) or (((place_group / 2) mod 2) = 1)
        or ((place_group mod 2) = 1);
      map_start_of_frame <= input_starts;
      map_end_of_line <= place_column_is_equal;
      map_valid <= input_valid;
      if reset = '1' then
        place_column <= 0;
        place_group <= 8;
        input_starts <= false;
        input_valid <= false;
        map_inside <= false;
        map_start_of_frame <= false;
        map_end_of_line <= false;
        map_valid <= false;
      end if;
    end if;
  end process;
end architecture;
