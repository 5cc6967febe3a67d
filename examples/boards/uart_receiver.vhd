-- SPDX-License-Identifier: Apache-2.0
-- Bytes from a serial line: a start bit, eight data bits, the lowest first, a stop bit, no parity. Each bit is sampled in its
-- middle, counted from the edge of the start bit: the clocks of the two sides may differ by a few percent.
--   out_valid   for one clock, with each byte
--   out_broken  for one clock: the stop bit was '0'. The next byte begins at an edge, so after the line was '1'
library ieee;
use ieee.std_logic_1164.all;

entity uart_receiver is
  generic (clocks_per_bit : positive);  -- 4 or more
  port (
    clock : in std_logic;
    reset : in std_logic;
    serial : in std_logic;  -- in no relation to the clock
    out_valid : out std_logic;
    out_broken : out std_logic;
    out_data : out std_logic_vector(7 downto 0)
  );
end entity;

architecture rtl of uart_receiver is
  signal history : std_logic_vector(2 downto 0) := "111";  -- the line, from two clocks ago on
  signal bits_left : natural range 0 to 10 := 0;
  signal clocks_left : natural range 0 to clocks_per_bit - 1 := 0;
  signal data : std_logic_vector(7 downto 0) := (others => '0');
  signal valid, broken : std_logic := '0';
begin
  assert clocks_per_bit >= 4 report "uart_receiver: clocks_per_bit must be 4 or more" severity failure;

  out_valid <= valid;
  out_broken <= broken;
  out_data <= data;

  process (clock)
  begin
    if rising_edge(clock) then
      history <= history(1 downto 0) & serial;
      valid <= '0';
      broken <= '0';
      if bits_left = 0 then
        clocks_left <= clocks_per_bit / 2 - 1;
        if history(2 downto 1) = "10" then
          bits_left <= 10;
        end if;
      elsif clocks_left /= 0 then
        clocks_left <= clocks_left - 1;
      else
        clocks_left <= clocks_per_bit - 1;
        bits_left <= bits_left - 1;
        if bits_left = 1 then
          valid <= history(1);
          broken <= not history(1);
        else
          data <= history(1) & data(7 downto 1);  -- the start bit, too, which falls out
        end if;
        if bits_left = 10 and history(1) = '1' then
          bits_left <= 0;  -- too short for a start bit
        end if;
      end if;
      if reset = '1' then
        bits_left <= 0;
        valid <= '0';
        broken <= '0';
      end if;
    end if;
  end process;
end architecture;
