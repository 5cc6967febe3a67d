-- SPDX-License-Identifier: Apache-2.0
-- Bambu writes its multiplier in Verilog only; this is the VHDL of one without pipeline registers, for the co-simulation of the
-- original design.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ui_mult_expr_FU is
  generic (
    BITSIZE_in1 : integer;
    BITSIZE_in2 : integer;
    BITSIZE_out1 : integer;
    PIPE_PARAMETER : integer
  );
  port (
    clock : in std_logic;
    in1 : in unsigned(BITSIZE_in1 - 1 downto 0);
    in2 : in unsigned(BITSIZE_in2 - 1 downto 0);
    out1 : out unsigned(BITSIZE_out1 - 1 downto 0)
  );
end entity;

architecture product of ui_mult_expr_FU is
begin
  assert PIPE_PARAMETER = 0 report "a multiplier with pipeline registers" severity failure;
  out1 <= resize(in1 * in2, BITSIZE_out1);
end architecture;
