-- SPDX-License-Identifier: Apache-2.0
-- Endless frames of random pixels on an AXI4-Stream for stereo_ip with P = 1: the left image is the right one moved by `shift`
-- columns to the right, so that the disparity is `shift`, but for the left edge of each line.
library ieee;
use ieee.std_logic_1164.all;

entity pattern_source is
  generic (
    width_px : positive;
    height_px : positive;
    shift : positive  -- below the disparity range
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    tvalid : out std_logic;
    tready : in std_logic;
    tdata : out std_logic_vector(15 downto 0);
    tuser : out std_logic_vector(0 downto 0);
    tlast : out std_logic
  );
end entity;

architecture rtl of pattern_source is
  type pixels is array (0 to shift) of std_logic_vector(7 downto 0);
  signal random_bits : std_logic_vector(31 downto 0) := x"2007abcd";
  signal row : pixels := (others => (others => '0'));  -- row(k): the right image's pixel k columns to the left
  signal column : natural range 0 to width_px - 1 := 0;
  signal line_number : natural range 0 to height_px - 1 := 0;
  signal running : std_logic := '0';
begin
  tvalid <= running;
  tdata <= row(0) & row(shift);
  tlast <= '1' when column = width_px - 1 else '0';
  tuser(0) <= '1' when column = 0 and line_number = 0 else '0';

  process (clock)
    variable bits : std_logic_vector(31 downto 0);
  begin
    if rising_edge(clock) then
      running <= not reset;
      if running = '0' or tready = '1' then
        -- A linear feedback shift register, x^32 + x^22 + x^2 + x + 1, eight steps.
        bits := random_bits;
        for step in 1 to 8 loop
          bits := bits(30 downto 0) & (bits(31) xor bits(21) xor bits(1) xor bits(0));
        end loop;
        random_bits <= bits;
        row <= bits(7 downto 0) & row(0 to shift - 1);
      end if;
      if running = '1' and tready = '1' then
        if column /= width_px - 1 then
          column <= column + 1;
        else
          column <= 0;
          if line_number /= height_px - 1 then
            line_number <= line_number + 1;
          else
            line_number <= 0;
          end if;
        end if;
      end if;
      if reset = '1' then
        column <= 0;
        line_number <= 0;
      end if;
    end if;
  end process;
end architecture;
