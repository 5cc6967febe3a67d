-- SPDX-License-Identifier: Apache-2.0
-- Frames from the bytes of a serial line, on an AXI4-Stream for stereo_ip with P = 1. A frame is the letters "SP", then the
-- pixels: left and right one of each column, row by row. Bytes outside a frame are dropped until its letters come.
-- A frame is given up, and no more of it is sent, when a byte has no stop bit, when no byte comes for quiet_clocks, or when
-- a pair comes before the one before it was taken: a line cannot wait.
--   begins  for one clock, after the letters: what is left of an earlier frame is to be dropped
library ieee;
use ieee.std_logic_1164.all;

entity serial_source is
  generic (
    width_px : positive;
    height_px : positive;
    quiet_clocks : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    byte_valid : in std_logic;
    byte_broken : in std_logic;
    byte_data : in std_logic_vector(7 downto 0);
    begins : out std_logic;
    tvalid : out std_logic;
    tready : in std_logic;
    tdata : out std_logic_vector(15 downto 0);
    tuser : out std_logic_vector(0 downto 0);
    tlast : out std_logic
  );
end entity;

architecture rtl of serial_source is
  constant letter_s : std_logic_vector(7 downto 0) := x"53";
  constant letter_p : std_logic_vector(7 downto 0) := x"50";
  type bytes is (first_letter, second_letter, left_pixel, right_pixel);
  signal next_byte : bytes := first_letter;
  signal column : natural range 0 to width_px - 1 := 0;
  signal line_number : natural range 0 to height_px - 1 := 0;
  signal quiet : natural range 0 to quiet_clocks - 1 := 0;
  signal left : std_logic_vector(7 downto 0) := (others => '0');
  signal waits : std_logic := '0';  -- a pair, for tready
begin
  tvalid <= waits;

  process (clock)
  begin
    if rising_edge(clock) then
      begins <= '0';
      if tready = '1' then
        waits <= '0';
      end if;
      -- No case statement: GHDL 2.0 writes Verilog of it that is a latch.
      if byte_valid = '1' then
        if next_byte = first_letter then
          if byte_data = letter_s then
            next_byte <= second_letter;
          end if;
        elsif next_byte = second_letter then
          if byte_data = letter_p then
            next_byte <= left_pixel;
            begins <= '1';
            waits <= '0';
            column <= 0;
            line_number <= 0;
          elsif byte_data /= letter_s then
            next_byte <= first_letter;
          end if;
        elsif next_byte = left_pixel then
          left <= byte_data;
          next_byte <= right_pixel;
        else
          tdata <= byte_data & left;
          tuser(0) <= '0';
          if column = 0 and line_number = 0 then
            tuser(0) <= '1';
          end if;
          tlast <= '0';
          waits <= '1';
          next_byte <= left_pixel;
          if column /= width_px - 1 then
            column <= column + 1;
          else
            tlast <= '1';
            column <= 0;
            if line_number /= height_px - 1 then
              line_number <= line_number + 1;
            else
              next_byte <= first_letter;
            end if;
          end if;
          if waits = '1' and tready = '0' then
            next_byte <= first_letter;
            waits <= '0';
          end if;
        end if;
      end if;
      if byte_valid = '1' or next_byte = first_letter then
        quiet <= 0;
      elsif quiet /= quiet_clocks - 1 then
        quiet <= quiet + 1;
      else
        next_byte <= first_letter;
      end if;
      if byte_broken = '1' then
        next_byte <= first_letter;
      end if;
      if reset = '1' then
        next_byte <= first_letter;
        begins <= '0';
        waits <= '0';
      end if;
    end if;
  end process;
end architecture;
