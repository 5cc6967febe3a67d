-- SPDX-License-Identifier: Apache-2.0
-- To be proved: `bad` is '0' for ever. stream_fifo loses nothing, doubles nothing, keeps the order, holds what it offers, and
-- offers a word two clocks after it came, as long as its writer never puts in more than `depth`.
library ieee;
use ieee.std_logic_1164.all;

entity prove_stream_fifo is
  generic (
    depth : positive := 3;
    width : positive := 1
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    wants_in : in std_logic;
    in_data : in std_logic_vector(width - 1 downto 0);
    out_ready : in std_logic;
    bad : out std_logic
  );
end entity;

architecture proof of prove_stream_fifo is
  signal in_valid, out_valid, pop, was_held, waited : std_logic := '0';
  signal out_data, oldest, held_data : std_logic_vector(width - 1 downto 0);
  signal count : natural range 0 to depth;
begin
  in_valid <= wants_in when count < depth else '0';
  pop <= out_valid and out_ready;

  dut : entity work.stream_fifo
    generic map (depth => depth, width => width)
    port map (
      clock => clock, reset => reset, in_valid => in_valid, in_data => in_data,
      out_valid => out_valid, out_ready => out_ready, out_data => out_data);

  model : entity work.reference_queue
    generic map (capacity => depth, width => width)
    port map (clock => clock, reset => reset, push => in_valid, push_data => in_data, pop => pop, oldest => oldest, count => count);

  process (all)
  begin
    bad <= '0';
    if out_valid = '1' and (count = 0 or out_data /= oldest) then
      bad <= '1';
    end if;
    if waited = '1' and out_valid = '0' then
      bad <= '1';
    end if;
    if was_held = '1' and (out_valid = '0' or out_data /= held_data) then
      bad <= '1';
    end if;
  end process;

  process (clock)
  begin
    if rising_edge(clock) then
      waited <= '0';
      if count > 0 and out_valid = '0' and reset = '0' then
        waited <= '1';
      end if;
      was_held <= out_valid and not out_ready and not reset;
      held_data <= out_data;
    end if;
  end process;
end architecture;
