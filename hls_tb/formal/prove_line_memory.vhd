-- SPDX-License-Identifier: Apache-2.0
-- To be proved: `bad` is '0' for ever. line_memory gives what an array of whole words gives, also where its columns are not
-- equally wide: the word at the last address that was read, as it was before a write of the same clock. What stands there
-- before the first write is left open, as the synthesised memory has no initial value.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity prove_line_memory is
  generic (width : positive := 61);
  port (
    clock : in std_logic;
    read_enable : in std_logic;
    read_upper : in std_logic;
    write_upper : in std_logic;
    data : in std_logic_vector(width - 1 downto 0);
    bad : out std_logic
  );
end entity;

architecture proof of prove_line_memory is
  signal read_address, write_address : unsigned(0 downto 0);
  signal found : unsigned(width - 1 downto 0);
  signal lower, upper, expected : std_logic_vector(width - 1 downto 0) := (others => '0');
  signal lower_known, upper_known, known : std_logic := '0';
begin
  read_address(0) <= read_upper;
  write_address(0) <= write_upper;

  dut : entity work.line_memory
    generic map (depth => 2, width => width, address_bits => 1)
    port map (
      clock => clock, read_enable => read_enable = '1', read_address => read_address, read_data => found,
      write_address => write_address, write_data => unsigned(data));

  bad <= '1' when known = '1' and std_logic_vector(found) /= expected else '0';

  process (clock)
  begin
    if rising_edge(clock) then
      if read_enable = '1' then
        expected <= upper when read_upper = '1' else lower;
        known <= upper_known when read_upper = '1' else lower_known;
      end if;
      if write_upper = '1' then
        upper <= data;
        upper_known <= '1';
      else
        lower <= data;
        lower_known <= '1';
      end if;
    end if;
  end process;
end architecture;
