-- SPDX-License-Identifier: Apache-2.0
-- Measures how long frames take: from the clock after `starts` to the one with `ends`, both counted.
-- Frames overlap: start_slot and end_slot, 0 or 1, say which of two is meant.
--   clocks  of the last frame that ended, two clocks after `ends`; 0 before the first; modulo 2**32
-- Size: 132 register bits.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity frame_timer is
  port (
    clock : in std_logic;
    reset : in std_logic;
    starts : in std_logic;
    start_slot : in std_logic;
    ends : in std_logic;
    end_slot : in std_logic;
    clocks : out unsigned(31 downto 0)
  );
end entity;

architecture rtl of frame_timer is
  type times is array (0 to 1) of unsigned(31 downto 0);
  signal now_clock : unsigned(31 downto 0) := (others => '0');
  signal started : times := (others => (others => '0'));
  -- As they were in the last clock.
  signal begun, ended, begun_slot, ended_slot : std_logic := '0';
begin
  process (clock)
    variable start_clock : unsigned(31 downto 0);
  begin
    if rising_edge(clock) then
      now_clock <= now_clock + 1;
      begun <= starts;
      begun_slot <= start_slot;
      ended <= ends;
      ended_slot <= end_slot;
      if begun = '1' and begun_slot = '0' then
        started(0) <= now_clock;
      elsif begun = '1' then
        started(1) <= now_clock;
      end if;
      start_clock := started(0);
      if ended_slot = '1' then
        start_clock := started(1);
      end if;
      if ended = '1' then
        clocks <= now_clock - start_clock;
      end if;
      if reset = '1' then
        begun <= '0';
        ended <= '0';
        now_clock <= (others => '0');
        clocks <= (others => '0');
      end if;
    end if;
  end process;
end architecture;
