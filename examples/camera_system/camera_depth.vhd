-- SPDX-License-Identifier: Apache-2.0
-- Disparities to millimetres by a table, 2 clocks. A pixel whose disparity has not passed the core's checks is 0, unknown.
--   write_*  the last entry that was written; it is written again in every clock
-- Size: 2**place_bits words of 16 bits.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity camera_depth is
  generic (
    place_bits : positive;  -- of each disparity that passes the checks
    disparity_bits : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    write_disparity : in std_logic_vector(15 downto 0);  -- below 2**place_bits
    write_mm : in std_logic_vector(15 downto 0);
    disparity : in std_logic_vector(disparity_bits - 1 downto 0);
    pixel_valid : in std_logic_vector(0 downto 0);
    disparity_valid : in std_logic;
    disparity_start_of_frame : in std_logic;
    disparity_end_of_line : in std_logic;
    depth_mm : out std_logic_vector(15 downto 0);
    depth_known : out std_logic_vector(0 downto 0);
    depth_valid : out std_logic;
    depth_start_of_frame : out std_logic;
    depth_end_of_line : out std_logic
  );
end entity;

architecture rtl of camera_depth is
  signal read_address, write_address : unsigned(place_bits - 1 downto 0);
  signal found : unsigned(15 downto 0);
  signal known, valid, start, last : std_logic := '0';
begin
  read_address <= unsigned(disparity(place_bits - 1 downto 0));
  write_address <= unsigned(write_disparity(place_bits - 1 downto 0));

  depths : entity work.line_memory
    generic map (depth => 2 ** place_bits, width => 16, address_bits => place_bits)
    port map (
      clock => clock, read_enable => true, read_address => read_address, read_data => found,
      write_address => write_address, write_data => unsigned(write_mm));

  process (clock)
  begin
    if rising_edge(clock) then
      known <= pixel_valid(0);
      valid <= disparity_valid;
      start <= disparity_start_of_frame;
      last <= disparity_end_of_line;
      depth_mm <= (others => '0');
      if known = '1' then
        depth_mm <= std_logic_vector(found);
      end if;
      depth_known(0) <= known;
      depth_valid <= valid;
      depth_start_of_frame <= start;
      depth_end_of_line <= last;
      if reset = '1' then
        valid <= '0';
        depth_valid <= '0';
      end if;
    end if;
  end process;
end architecture;
