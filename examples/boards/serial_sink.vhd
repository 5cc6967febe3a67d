-- SPDX-License-Identifier: Apache-2.0
-- The map of stereo_ip, with disparities of 8 bits, as bytes for a serial line: for each disparity its value, then a byte of
-- flags: bit 0 valid, 1 start of frame, 2 end of line, 3 frame error, 7 ... 4 "1010".
--   whole  the last byte of a map without frame error has been taken, since the reset
library ieee;
use ieee.std_logic_1164.all;

entity serial_sink is
  generic (height_px : positive);
  port (
    clock : in std_logic;
    reset : in std_logic;
    tvalid : in std_logic;
    tready : out std_logic;
    tdata : in std_logic_vector(15 downto 0);
    tuser : in std_logic_vector(1 downto 0);
    tlast : in std_logic;
    byte_valid : out std_logic;
    byte_ready : in std_logic;
    byte_data : out std_logic_vector(7 downto 0);
    whole : out std_logic
  );
end entity;

architecture rtl of serial_sink is
  constant mark : std_logic_vector(3 downto 0) := "1010";
  signal second : std_logic := '0';  -- the byte of flags comes next
  signal lines : natural range 0 to height_px := 0;
  signal has_error : std_logic := '0';
begin
  tready <= byte_ready and second;
  byte_valid <= tvalid and not reset;  -- what waits in a reset will not stay
  byte_data <= tdata(7 downto 0) when second = '0' else mark & tuser(1) & tlast & tuser(0) & tdata(8);
  whole <= '1' when lines = height_px and has_error = '0' else '0';

  process (clock)
  begin
    if rising_edge(clock) then
      if tvalid = '1' and byte_ready = '1' then
        second <= not second;
        if second = '1' then
          has_error <= has_error or tuser(1);
          if tlast = '1' and lines /= height_px then
            lines <= lines + 1;
          end if;
        end if;
      end if;
      if reset = '1' then
        second <= '0';
        lines <= 0;
        has_error <= '0';
      end if;
    end if;
  end process;
end architecture;
