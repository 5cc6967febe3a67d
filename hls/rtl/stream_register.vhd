-- SPDX-License-Identifier: Apache-2.0
-- A register in a valid/ready stream that breaks every combinational path from one side to the other. A word a clock in
-- each direction, no bubble; a word leaves one clock after it came at the earliest. Its flags are for who decides whether
-- to take it; its data may be wide: out_ready, which comes late in a clock, reaches none of their registers.
--   in_ready, out_valid, out_flags  come straight from registers; out_data over a multiplexer of two words
--   a word moves on a side in each rising edge with valid and ready
--   reset                           synchronous, active high; in_ready is '0' in it and in the clock after it
-- Size: 2 * (flag_bits + data_bits) + 5 register bits.
library ieee;
use ieee.std_logic_1164.all;

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
  signal main_flags, spare_flags : std_logic_vector(flag_bits - 1 downto 0);
  signal main_valid, spare_valid, accepts : std_logic := '0';
  signal even_data, odd_data : std_logic_vector(data_bits - 1 downto 0);
  signal writes_odd, reads_odd : std_logic := '0';  -- where the next word goes, where the oldest one stands
begin
  in_ready <= accepts;
  out_valid <= main_valid;
  out_flags <= main_flags;
  out_data <= odd_data when reads_odd = '1' else even_data;

  process (clock)
    variable arrives, spare_in_use : std_logic;
  begin
    if rising_edge(clock) then
      arrives := in_valid and accepts;
      spare_in_use := spare_valid;
      if out_ready = '1' or main_valid = '0' then
        -- The spare word is the older one; nothing arrives while there is one.
        main_flags <= spare_flags when spare_valid = '1' else in_flags;
        main_valid <= spare_valid or arrives;
        spare_in_use := '0';
      elsif arrives = '1' then
        spare_in_use := '1';
      end if;
      -- What no *_valid speaks of may change in any clock.
      if accepts = '1' then
        spare_flags <= in_flags;
        if writes_odd = '1' then
          odd_data <= in_data;
        else
          even_data <= in_data;
        end if;
      end if;
      spare_valid <= spare_in_use;
      accepts <= not spare_in_use;
      writes_odd <= writes_odd xor arrives;
      reads_odd <= reads_odd xor (main_valid and out_ready);
      if reset = '1' then
        main_valid <= '0';
        spare_valid <= '0';
        accepts <= '0';
        writes_odd <= '0';
        reads_odd <= '0';
      end if;
    end if;
  end process;
end architecture;
