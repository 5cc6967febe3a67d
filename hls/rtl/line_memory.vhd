-- SPDX-License-Identifier: Apache-2.0
-- A memory of whole words with one synchronous read and one write a clock, the template that synthesisers fold into block
-- RAM or LUT RAM. Both addresses must come from registers.
--   read_data  the word at read_address of the last clock with read_enable; a read sees the word before a write of the
--              same clock to the same address
--   write      in every clock; a user that has nothing to write repeats its last write
--   addresses  below depth
-- Size: depth * width bits, all 0 at start, not cleared by any reset. No core needs the 0s in hardware; simulators of four
-- values would carry what is unknown in circles.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity line_memory is
  generic (
    depth : positive;
    width : positive;
    address_bits : positive  -- 2 ** address_bits >= depth
  );
  port (
    clock : in std_logic;
    read_enable : in boolean;
    read_address : in unsigned(address_bits - 1 downto 0);
    read_data : out unsigned(width - 1 downto 0);
    write_address : in unsigned(address_bits - 1 downto 0);
    write_data : in unsigned(width - 1 downto 0)
  );
end entity;

architecture rtl of line_memory is
  -- As few columns of bits as can be, all equally wide: a block RAM holds 36 bits side by side.
  constant columns : positive := (width + 35) / 36;
  constant column_bits : positive := (width + columns - 1) / columns;

  function least(a, b : natural) return natural is
  begin
    if a < b then
      return a;
    end if;
    return b;
  end function;
begin
  column : for c in 0 to columns - 1 generate
    constant low : natural := c * column_bits;
    constant high : natural := least(low + column_bits, width) - 1;
    constant bits : natural := high - low + 1;
    type words is array (0 to depth - 1) of bit_vector(bits - 1 downto 0);
    signal memory : words := (others => (others => '0'));
    signal word : bit_vector(bits - 1 downto 0) := (others => '0');
  begin
    process (clock)
    begin
      if rising_edge(clock) then
        if read_enable then
          word <= memory(to_integer(read_address));
        end if;
        memory(to_integer(write_address)) <= to_bitvector(std_logic_vector(write_data(high downto low)));
      end if;
    end process;
    read_data(high downto low) <= unsigned(to_stdlogicvector(word));
  end generate;
end architecture;
