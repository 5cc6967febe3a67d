-- SPDX-License-Identifier: Apache-2.0
-- A queue whose writer never waits: it must have counted that there is room (stream_credit). First in, first out.
--   in_valid   a word comes in; at most `depth` words may be in the queue, the one at its output counted
--   out_*      valid/ready stream from registers: out_valid and out_data hold until out_ready. A word shows two clocks
--              after its in_valid at the earliest.
--   reset      synchronous, active high: the queue is empty
-- Size: depth * width bits of memory (LUT RAM: read without a clock), width + 1 register bits at the output, and the
-- counters.
library ieee;
use ieee.std_logic_1164.all;

entity stream_fifo is
  generic (
    depth : positive;
    width : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_data : in std_logic_vector(width - 1 downto 0);
    out_valid : out std_logic;
    out_ready : in std_logic;
    out_data : out std_logic_vector(width - 1 downto 0) := (others => '0')
  );
end entity;

architecture rtl of stream_fifo is
  type words is array (0 to depth - 1) of std_logic_vector(width - 1 downto 0);
  signal memory : words;
  signal write_address, read_address : natural range 0 to depth - 1 := 0;
  signal stored : natural range 0 to depth := 0;  -- words in the memory
  signal waits : std_logic := '0';  -- stored /= 0
  signal shows : std_logic := '0';  -- a word at the output

  function following(address : natural) return natural is
  begin
    if address = depth - 1 then
      return 0;
    end if;
    return address + 1;
  end function;
begin
  out_valid <= shows;

  process (clock)
    variable leaves : boolean;  -- from the memory to the output
  begin
    if rising_edge(clock) then
      leaves := waits = '1' and (shows = '0' or out_ready = '1');
      if leaves then
        out_data <= memory(read_address);
        read_address <= following(read_address);
        shows <= '1';
      elsif out_ready = '1' then
        shows <= '0';
      end if;
      if in_valid = '1' then
        memory(write_address) <= in_data;
        write_address <= following(write_address);
      end if;
      if in_valid = '1' and not leaves then
        stored <= stored + 1;
      elsif in_valid = '0' and leaves then
        stored <= stored - 1;
      end if;
      waits <= '0';
      if in_valid = '1' or stored > 1 or (stored = 1 and not leaves) then
        waits <= '1';
      end if;
      if reset = '1' then
        write_address <= 0;
        read_address <= 0;
        stored <= 0;
        waits <= '0';
        shows <= '0';
      end if;
    end if;
  end process;
end architecture;
