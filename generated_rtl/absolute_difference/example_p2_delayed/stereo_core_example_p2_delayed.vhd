-- SPDX-License-Identifier: Apache-2.0
-- Stereo core, absolute difference, configuration example_p2_delayed: 24x8, absolute difference, valid from 10 on, 2 pixel pairs a clock.
-- Options: least_difference 10, delay_groups 5.
-- Made from hls/top/stereo_top.cpp by PandA Bambu 2024.10 revision 683d87153 and scripts/synthesize.py. Do not edit:
--   scripts/synthesize.py --config example_p2_delayed
-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_core_example_p2_delayed is
  generic (
    -- What this core is. A user may state it: another value stops elaboration.
    width_px : positive := 24;
    height_px : positive := 8;
    disparities : positive := 256;
    pixels_per_clock : positive := 2;
    disparity_bits : positive := 8;
    output_width_px : positive := 24;
    latency_clocks : positive := 3;
    flush_groups : positive := 5;
    gap_groups : natural := 0
  );
  port (
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector(15 downto 0);  -- 8 bits a row, the upper row in the lowest
    right_pixel : in std_logic_vector(15 downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector(15 downto 0);
    pixel_valid : out std_logic_vector(1 downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
begin
  assert width_px = 24 report "stereo_core_example_p2_delayed: width_px is " & integer'image(width_px) & " but this core has 24" severity failure;
  assert height_px = 8 report "stereo_core_example_p2_delayed: height_px is " & integer'image(height_px) & " but this core has 8" severity failure;
  assert disparities = 256 report "stereo_core_example_p2_delayed: disparities is " & integer'image(disparities) & " but this core has 256" severity failure;
  assert pixels_per_clock = 2 report "stereo_core_example_p2_delayed: pixels_per_clock is " & integer'image(pixels_per_clock) & " but this core has 2" severity failure;
  assert disparity_bits = 8 report "stereo_core_example_p2_delayed: disparity_bits is " & integer'image(disparity_bits) & " but this core has 8" severity failure;
  assert output_width_px = 24 report "stereo_core_example_p2_delayed: output_width_px is " & integer'image(output_width_px) & " but this core has 24" severity failure;
  assert latency_clocks = 3 report "stereo_core_example_p2_delayed: latency_clocks is " & integer'image(latency_clocks) & " but this core has 3" severity failure;
  assert flush_groups = 5 report "stereo_core_example_p2_delayed: flush_groups is " & integer'image(flush_groups) & " but this core has 5" severity failure;
  assert gap_groups = 0 report "stereo_core_example_p2_delayed: gap_groups is " & integer'image(gap_groups) & " but this core has 0" severity failure;
end entity;

architecture rtl of stereo_core_example_p2_delayed is
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

  signal in_right_pixel : natural range 0 to 65535;
  signal in_left_pixel : natural range 0 to 65535;
  signal in_valid : boolean;
  signal in_start_of_frame : boolean;
  -- place
  signal place_column : natural range 0 to 31;
  signal place_group : natural range 0 to 7;
  -- input
  signal input_difference_0, input_difference_1 : integer range -255 to 255;
  signal input_starts, input_valid : boolean;
  -- map
  signal map_magnitude_0, map_magnitude_1 : natural range 0 to 255;
  signal map_inside, map_start_of_frame, map_end_of_line, map_valid : boolean;
  -- delay
  signal delay_ring_read_address, delay_ring_write_address, delay_filled : natural range 0 to 7;
  signal delay_held_0 : unsigned(18 downto 0);
  signal delay_valid : boolean;
  signal delay_held_0_memory_read_enable : boolean;
  signal delay_held_0_memory_read_address : unsigned(2 downto 0);
  signal delay_held_0_memory_write_address : unsigned(2 downto 0);
  signal delay_held_0_memory_write_data : unsigned(18 downto 0);

begin
  in_right_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(right_pixel))));
  in_left_pixel <= to_integer(unsigned(to_stdlogicvector(to_bitvector(left_pixel))));
  in_valid <= valid = '1';
  in_start_of_frame <= start_of_frame = '1';
  disparity <= std_logic_vector(delay_held_0(18 downto 11) & to_unsigned((to_integer(delay_held_0(10 downto 0)) / 8), 8));
  pixel_valid <= std_logic_vector(to_unsigned(as_number(((not ((not (to_integer(delay_held_0(15 downto 15)) = 1)) and ((not (to_integer(delay_held_0(14 downto 14)) = 1)) or (to_integer(delay_held_0(13 downto 12)) = 0)))) or (to_integer(delay_held_0(18 downto 18)) = 1) or (to_integer(delay_held_0(17 downto 17)) = 1) or (to_integer(delay_held_0(16 downto 16)) = 1))), 1) & to_unsigned(as_number(((not ((not (to_integer(delay_held_0(7 downto 7)) = 1)) and ((not (to_integer(delay_held_0(6 downto 6)) = 1)) or (to_integer(delay_held_0(5 downto 4)) = 0)))) or (to_integer(delay_held_0(10 downto 10)) = 1) or (to_integer(delay_held_0(9 downto 9)) = 1) or (to_integer(delay_held_0(8 downto 8)) = 1))), 1));
  disparity_valid <= as_bit(delay_valid and (to_integer(delay_held_0(0 downto 0)) = 1));
  disparity_start_of_frame <= as_bit(delay_valid and (to_integer(delay_held_0(1 downto 0)) = 3));
  disparity_end_of_line <= as_bit((to_integer(delay_held_0(2 downto 2)) = 1) and delay_valid and (to_integer(delay_held_0(0 downto 0)) = 1));

  delay_held_0_memory_read_enable <= true;
  delay_held_0_memory_read_address <= to_unsigned(delay_ring_read_address, 3);
  delay_held_0_memory_write_address <= to_unsigned(delay_ring_write_address, 3);
  delay_held_0_memory_write_data <= to_unsigned(map_magnitude_1, 8) & to_unsigned(map_magnitude_0, 8) & to_unsigned(as_number(map_end_of_line), 1) & to_unsigned(as_number(map_start_of_frame), 1) & to_unsigned(as_number(map_inside), 1);
  delay_held_0_memory : entity work.line_memory
    generic map (depth => 6, width => 19, address_bits => 3)
    port map (
      clock => clock, read_enable => delay_held_0_memory_read_enable,
      read_address => delay_held_0_memory_read_address, read_data => delay_held_0,
      write_address => delay_held_0_memory_write_address, write_data => delay_held_0_memory_write_data);

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
        place_group <= (place_group + as_number((place_column_is_equal and (place_group /= 4) and in_valid))) mod 8;
      end if;
      -- input
      input_difference_0 <= (in_left_pixel mod 256) - (in_right_pixel mod 256);
      input_difference_1 <= (in_left_pixel / 256) - (in_right_pixel / 256);
      input_starts <= in_start_of_frame;
      input_valid <= in_valid;
      -- map
      map_magnitude_0 <= magnitude(input_difference_0);
      map_magnitude_1 <= magnitude(input_difference_1);
      map_inside <= (not ((place_group / 4) = 1)) or (((place_group / 2) mod 2) = 1) or ((place_group mod 2) = 1);
      map_start_of_frame <= input_starts;
      map_end_of_line <= place_column_is_equal;
      map_valid <= input_valid;
      -- delay
      if map_valid then
        delay_ring_write_address <= delay_ring_read_address;
        if delay_ring_read_address = 5 then
          delay_ring_read_address <= 0;
        else
          delay_ring_read_address <= (delay_ring_read_address + 1) mod 8;
        end if;
      end if;
      delay_filled <= (delay_filled + as_number((map_valid and ((not ((delay_filled / 4) = 1)) or (((delay_filled / 2)
        mod 2) = 1) or (not ((delay_filled mod 2) = 1)))))) mod 8;
      delay_valid <= map_valid and (delay_filled = 5);
      if reset = '1' then
        place_column <= 0;
        place_group <= 4;
        input_starts <= false;
        input_valid <= false;
        map_inside <= false;
        map_start_of_frame <= false;
        map_end_of_line <= false;
        map_valid <= false;
        delay_ring_read_address <= 1;
        delay_ring_write_address <= 0;
        delay_filled <= 0;
        delay_valid <= false;
      end if;
    end if;
  end process;
end architecture;
