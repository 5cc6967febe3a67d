-- SPDX-License-Identifier: Apache-2.0
-- Sends frames of noise to a stereo_ip with P = 1 and takes its maps, both with pauses. In a pause nothing but tvalid is
-- known: all else at s_axis is 'X', as some masters of other simulations drive it. `done` a while after the last disparity
-- has been taken; fails when the maps do not come.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity idle_traffic is
  generic (
    width_px : positive;
    height_px : positive;
    map_px : positive;  -- pixels of a map
    frames : positive := 3
  );
  port (
    aclk : in std_logic;
    aresetn : out std_logic;
    s_axis_tvalid : out std_logic;
    s_axis_tready : in std_logic;
    s_axis_tdata : out std_logic_vector(15 downto 0);
    s_axis_tuser : out std_logic_vector(0 downto 0);
    s_axis_tlast : out std_logic;
    m_axis_tvalid : in std_logic;
    m_axis_tready : out std_logic;
    done : out boolean := false
  );
end entity;

architecture sim of idle_traffic is
  constant most_clocks : positive := 10 * frames * width_px * height_px;
begin
  aresetn <= '0', '1' after 42 ns;

  source : process
    variable seed_a, seed_b : positive := 2007;
    variable chance : real;

    procedure pause is
    begin
      s_axis_tvalid <= '0';
      s_axis_tdata <= (others => 'X');
      s_axis_tuser <= "X";
      s_axis_tlast <= 'X';
    end procedure;
  begin
    pause;
    wait for 100 ns;
    for beat in 0 to frames * height_px * width_px - 1 loop
      uniform(seed_a, seed_b, chance);
      if chance < 0.3 then
        pause;
        wait until rising_edge(aclk);
      end if;
      uniform(seed_a, seed_b, chance);
      s_axis_tvalid <= '1';
      s_axis_tdata <= std_logic_vector(to_unsigned(natural(floor(chance * 65536.0)), 16));
      s_axis_tuser <= "1" when beat mod (width_px * height_px) = 0 else "0";
      s_axis_tlast <= '1' when beat mod width_px = width_px - 1 else '0';
      wait until rising_edge(aclk) and s_axis_tready = '1';
    end loop;
    pause;
    wait;
  end process;

  sink : process
    variable seed_a, seed_b : positive := 425;
    variable chance : real;
  begin
    m_axis_tready <= '0';
    for beat in 1 to frames * map_px loop
      loop
        uniform(seed_a, seed_b, chance);
        m_axis_tready <= '1' when chance < 0.8 else '0';
        wait until rising_edge(aclk);
        exit when m_axis_tvalid = '1' and m_axis_tready = '1';
      end loop;
    end loop;
    m_axis_tready <= '1';
    for i in 1 to 200 loop
      wait until rising_edge(aclk);
      assert m_axis_tvalid = '0' report "a disparity too many" severity failure;
    end loop;
    report "idle_traffic passed: " & to_string(frames) & " frames";
    done <= true;
    wait;
  end process;

  watchdog : process
  begin
    for i in 1 to most_clocks loop
      wait until rising_edge(aclk);
    end loop;
    report "the maps do not come" severity failure;
  end process;
end architecture;
