-- SPDX-License-Identifier: Apache-2.0
-- A register in a valid/ready stream that breaks every combinational path from one side to the other. A word a clock in
-- each direction, no bubble; a word leaves one clock after it came at the earliest.
--   in_ready, out_valid, out_data  come straight from registers
--   a word moves on a side in each rising edge with valid and ready
--   reset                          synchronous, active high; in_ready is '0' in it and in the clock after it
-- Size: 2 * width + 3 register bits.
library ieee;
use ieee.std_logic_1164.all;

entity stream_register is
  generic (
    width : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_ready : out std_logic;
    in_data : in std_logic_vector(width - 1 downto 0);
    out_valid : out std_logic;
    out_ready : in std_logic;
    out_data : out std_logic_vector(width - 1 downto 0)
  );
end entity;

architecture rtl of stream_register is
  signal main_data, spare_data : std_logic_vector(width - 1 downto 0);
  signal main_valid, spare_valid, accepts : std_logic := '0';
begin
  in_ready <= accepts;
  out_valid <= main_valid;
  out_data <= main_data;

  process (clock)
    variable arrives, spare_in_use : std_logic;
  begin
    if rising_edge(clock) then
      arrives := in_valid and accepts;
      spare_in_use := spare_valid;
      if out_ready = '1' or main_valid = '0' then
        -- The spare word is the older one; nothing arrives while there is one.
        main_data <= spare_data when spare_valid = '1' else in_data;
        main_valid <= spare_valid or arrives;
        spare_in_use := '0';
      elsif arrives = '1' then
        spare_in_use := '1';
      end if;
      -- What no *_valid speaks of may change in any clock.
      if accepts = '1' then
        spare_data <= in_data;
      end if;
      spare_valid <= spare_in_use;
      accepts <= not spare_in_use;
      if reset = '1' then
        main_valid <= '0';
        spare_valid <= '0';
        accepts <= '0';
      end if;
    end if;
  end process;
end architecture;
