-- SPDX-License-Identifier: Apache-2.0
-- Bambu writes the input ports of mode `none` in Verilog only; this is their VHDL. The co-simulation of the original design
-- analyses one copy for each port, PORT replaced by the port's name.
library ieee;
use ieee.std_logic_1164.all;

entity PORT_bambu_artificial_ParmMgr_Read_none_modgen is
  generic (
    BITSIZE_in1 : integer;
    BITSIZE_out1 : integer
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    start_port : in std_logic_vector(0 downto 0);
    in1 : in std_logic_vector(BITSIZE_in1 - 1 downto 0);
    \_PORT\ : in std_logic_vector(BITSIZE_out1 - 1 downto 0);
    out1 : out std_logic_vector(BITSIZE_out1 - 1 downto 0)
  );
end entity;

architecture through of PORT_bambu_artificial_ParmMgr_Read_none_modgen is
begin
  out1 <= \_PORT\;
end architecture;
