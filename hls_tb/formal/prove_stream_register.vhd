-- SPDX-License-Identifier: Apache-2.0
-- To be proved: `bad` is '0' for ever, whatever the inputs do, resets included. stream_register loses nothing, doubles
-- nothing, keeps the order, holds what it offers, and is ready whenever it would have room if nothing had left in the clock
-- before.
library ieee;
use ieee.std_logic_1164.all;

entity prove_stream_register is
  generic (
    flag_bits : positive := 1;
    data_bits : positive := 1
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_word : in std_logic_vector(flag_bits + data_bits - 1 downto 0);
    out_ready : in std_logic;
    bad : out std_logic
  );
end entity;

architecture proof of prove_stream_register is
  constant capacity : positive := 3;
  constant width : positive := flag_bits + data_bits;
  signal in_ready, out_valid, push, pop, was_reset, was_held, was_full : std_logic := '0';
  signal out_word, oldest, held_word : std_logic_vector(width - 1 downto 0);
  signal count : natural range 0 to capacity;
  signal begun : std_logic := '0';  -- a clock has passed since the start: before it in_ready is still '0'
begin
  dut : entity work.stream_register
    generic map (flag_bits => flag_bits, data_bits => data_bits)
    port map (
      clock => clock, reset => reset, in_valid => in_valid, in_ready => in_ready,
      in_flags => in_word(width - 1 downto data_bits), in_data => in_word(data_bits - 1 downto 0),
      out_valid => out_valid, out_ready => out_ready,
      out_flags => out_word(width - 1 downto data_bits), out_data => out_word(data_bits - 1 downto 0));

  push <= in_valid and in_ready;
  pop <= out_valid and out_ready;

  model : entity work.reference_queue
    generic map (capacity => capacity, width => width)
    port map (clock => clock, reset => reset, push => push, push_data => in_word, pop => pop, oldest => oldest, count => count);

  process (all)
  begin
    bad <= '0';
    if (out_valid = '1') /= (count > 0) then
      bad <= '1';
    end if;
    if out_valid = '1' and out_word /= oldest then
      bad <= '1';
    end if;
    if push = '1' and count = capacity then
      bad <= '1';
    end if;
    if in_ready = '0' and was_full = '0' and was_reset = '0' and begun = '1' then
      bad <= '1';
    end if;
    if was_held = '1' and (out_valid = '0' or out_word /= held_word) then
      bad <= '1';
    end if;
  end process;

  process (clock)
  begin
    if rising_edge(clock) then
      begun <= '1';
      was_reset <= reset;
      was_full <= '1' when count = capacity or (count = capacity - 1 and push = '1') else '0';
      was_held <= out_valid and not out_ready and not reset;
      held_word <= out_word;
    end if;
  end process;
end architecture;
