-- SPDX-License-Identifier: Apache-2.0
-- Runs the example until it has counted four frames, pushes its button and waits for four more. Fails when LED 7 is not lit
-- then or the frames do not come.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tb_example_top is
end entity;

architecture sim of tb_example_top is
  constant period : time := 40 ns;
  constant most_clocks : positive := 4000;
  signal clock, button : std_logic := '0';
  signal led : std_logic_vector(7 downto 0);
begin
  dut : entity work.example_top
    port map (clk_25mhz => clock, button => button, led => led);

  main : process
    procedure tick(clocks : positive) is
    begin
      for i in 1 to clocks loop
        clock <= '1';
        wait for period / 2;
        clock <= '0';
        wait for period / 2;
      end loop;
    end procedure;

    procedure expect_frames is
    begin
      for i in 1 to most_clocks loop
        tick(1);
        exit when led(6 downto 0) = "0000100";
      end loop;
      assert led = "10000100" report "LEDs show " & to_string(led) severity failure;
    end procedure;
  begin
    tick(10);
    expect_frames;
    button <= '1';
    tick(10);
    assert led = "00000000" report "not reset" severity failure;
    button <= '0';
    tick(10);
    expect_frames;
    report "example passed: LEDs " & to_string(led);
    wait;
  end process;
end architecture;
