-- SPDX-License-Identifier: Apache-2.0
-- Registers in a valid/ready stream that break every combinational path from one side to the other. A word a clock in
-- each direction, no bubble; a word leaves one clock after it came at the earliest. Its flags are for who decides whether
-- to take it; its data may be wide: out_ready, which comes late in a clock, reaches none of them, and in_ready does not
-- depend on out_ready of the clock before. So the two sides may be far from each other. Three words find room: what comes
-- in is counted before it is known what leaves.
--   in_ready, out_valid, out_flags  come straight from registers; out_data is read from a memory
--   a word moves on a side in each rising edge with valid and ready
--   reset                           synchronous, active high; in_ready is '0' in it and in the clock after it
-- Size: 4 * data_bits bits of memory (LUT RAM: read without a clock), 3 * flag_bits + 8 register bits.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stream_register is
  generic (
    flag_bits : positive;
    data_bits : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_ready : out std_logic;
    in_flags : in std_logic_vector(flag_bits - 1 downto 0);
    in_data : in std_logic_vector(data_bits - 1 downto 0);
    out_valid : out std_logic;
    out_ready : in std_logic;
    out_flags : out std_logic_vector(flag_bits - 1 downto 0);
    out_data : out std_logic_vector(data_bits - 1 downto 0)
  );
end entity;

architecture rtl of stream_register is
  type words is array (0 to 3) of std_logic_vector(data_bits - 1 downto 0);
  -- The word at the output, the one behind it, and the last one.
  signal main_flags, next_flags, last_flags : std_logic_vector(flag_bits - 1 downto 0) := (others => '0');
  signal main_valid, next_valid, last_valid, accepts : std_logic := '0';
  signal data : words;
  signal write_address, read_address : unsigned(1 downto 0) := "00";
begin
  in_ready <= accepts;
  out_valid <= main_valid;
  out_flags <= main_flags;
  out_data <= data(to_integer(read_address));

  process (clock)
    variable arrives, moves : std_logic;
  begin
    if rising_edge(clock) then
      arrives := in_valid and accepts;
      moves := out_ready or not main_valid;
      if moves = '1' then
        main_flags <= in_flags;
        if next_valid = '1' then
          main_flags <= next_flags;
        end if;
        main_valid <= next_valid or arrives;
      end if;
      if moves = '1' or next_valid = '0' then
        next_flags <= in_flags;
        if last_valid = '1' then
          next_flags <= last_flags;
        end if;
        next_valid <= last_valid or (arrives and (next_valid or not moves));
      end if;
      -- Nothing arrives while there is a last word.
      last_valid <= not moves and (last_valid or (arrives and next_valid));
      -- What no *_valid speaks of may change in any clock.
      if accepts = '1' then
        last_flags <= in_flags;
        data(to_integer(write_address)) <= in_data;
      end if;
      accepts <= not (last_valid or (arrives and next_valid));
      if arrives = '1' then
        write_address <= write_address + 1;
      end if;
      if main_valid = '1' and out_ready = '1' then
        read_address <= read_address + 1;
      end if;
      if reset = '1' then
        main_valid <= '0';
        next_valid <= '0';
        last_valid <= '0';
        accepts <= '0';
        write_address <= "00";
        read_address <= "00";
      end if;
    end if;
  end process;
end architecture;
