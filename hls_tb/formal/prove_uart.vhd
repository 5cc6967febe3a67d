-- SPDX-License-Identifier: Apache-2.0
-- To be proved: `bad` is '0' for ever, whatever the inputs do. What uart_transmitter takes comes out of uart_receiver at the
-- other end of a line, each byte once and in order, with its stop bit. Both have the same clock: tb_uart has other ones.
library ieee;
use ieee.std_logic_1164.all;

entity prove_uart is
  generic (clocks_per_bit : positive := 4);
  port (
    clock : in std_logic;
    in_valid : in std_logic;
    in_data : in std_logic_vector(7 downto 0);
    bad : out std_logic
  );
end entity;

architecture proof of prove_uart is
  constant capacity : positive := 2;  -- a byte on the line, and its receiver is some clocks late
  signal in_ready, serial, push, out_valid, out_broken : std_logic;
  signal oldest, out_data : std_logic_vector(7 downto 0);
  signal count : natural range 0 to capacity;
begin
  transmitter : entity work.uart_transmitter
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => clock, reset => '0', in_valid => in_valid, in_ready => in_ready, in_data => in_data, serial => serial);

  receiver : entity work.uart_receiver
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => clock, reset => '0', serial => serial, out_valid => out_valid, out_broken => out_broken, out_data => out_data);

  push <= in_valid and in_ready;

  model : entity work.reference_queue
    generic map (capacity => capacity, width => 8)
    port map (
      clock => clock, reset => '0', push => push, push_data => in_data, pop => out_valid, oldest => oldest, count => count);

  process (all)
  begin
    bad <= out_broken;
    if out_valid = '1' and (count = 0 or out_data /= oldest) then
      bad <= '1';
    end if;
    if push = '1' and count = capacity then
      bad <= '1';
    end if;
  end process;
end architecture;
