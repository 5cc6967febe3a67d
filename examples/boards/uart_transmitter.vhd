-- SPDX-License-Identifier: Apache-2.0
-- Bytes to a serial line: a start bit, eight data bits, the lowest first, a stop bit, no parity. A byte that waits follows
-- the one before at once: ten bits a byte.
library ieee;
use ieee.std_logic_1164.all;

entity uart_transmitter is
  generic (clocks_per_bit : positive);
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_ready : out std_logic;
    in_data : in std_logic_vector(7 downto 0);
    serial : out std_logic
  );
end entity;

architecture rtl of uart_transmitter is
  signal bits : std_logic_vector(9 downto 0) := (others => '1');
  signal bits_left : natural range 0 to 10 := 0;
  signal clocks_left : natural range 0 to clocks_per_bit - 1 := 0;
  signal ready : std_logic;
begin
  serial <= bits(0);
  ready <= '1' when bits_left = 0 or (bits_left = 1 and clocks_left = 0) else '0';
  in_ready <= ready;

  process (clock)
  begin
    if rising_edge(clock) then
      if ready = '1' then
        bits_left <= 0;
        if in_valid = '1' then
          bits <= '1' & in_data & '0';
          bits_left <= 10;
          clocks_left <= clocks_per_bit - 1;
        end if;
      elsif clocks_left /= 0 then
        clocks_left <= clocks_left - 1;
      else
        clocks_left <= clocks_per_bit - 1;
        bits <= '1' & bits(9 downto 1);
        bits_left <= bits_left - 1;
      end if;
      if reset = '1' then
        bits <= (others => '1');
        bits_left <= 0;
      end if;
    end if;
  end process;
end architecture;
