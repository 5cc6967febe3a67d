-- SPDX-License-Identifier: Apache-2.0
-- A memory of whole words with one synchronous read and one write a clock, the template that synthesisers fold into block
-- RAM or LUT RAM. Both addresses must come from registers.
--   read_data  the word at read_address of the last clock with read_enable; a read sees the word before a write of the
--              same clock to the same address
--   write      in every clock; a user that has nothing to write repeats its last write
-- Size: depth * width bits, all 0 at start, not cleared by any reset.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity line_memory is
  generic (
    depth : positive;
    width : positive
  );
  port (
    clock : in std_logic;
    read_enable : in boolean;
    read_address : in natural;
    read_data : out unsigned(width - 1 downto 0) := (others => '0');
    write_address : in natural;
    write_data : in unsigned(width - 1 downto 0)
  );
end entity;

architecture rtl of line_memory is
  type words is array (0 to depth - 1) of unsigned(width - 1 downto 0);
  signal memory : words := (others => (others => '0'));
begin
  process (clock)
  begin
    if rising_edge(clock) then
      if read_enable then
        read_data <= memory(read_address);
      end if;
      memory(write_address) <= write_data;
    end if;
  end process;
end architecture;
