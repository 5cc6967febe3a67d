-- SPDX-License-Identifier: Apache-2.0
-- The sink of the self test: counts how many disparities of a frame are `shift`. `good`: in the last frame at least three
-- quarters were, and it had no frame error. Takes a beat in 15 of 16 clocks, so that back-pressure is used.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity map_check is
  generic (
    map_px : positive;  -- pixels of a map
    shift : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    tvalid : in std_logic;
    tready : out std_logic;
    tdata : in std_logic_vector(15 downto 0);
    tuser : in std_logic_vector(1 downto 0);
    good : out std_logic;
    frames : out unsigned(7 downto 0)
  );
end entity;

architecture rtl of map_check is
  signal pause : unsigned(3 downto 0) := (others => '0');
  signal hits, beats : natural range 0 to map_px := 0;
  signal frame_count : unsigned(7 downto 0) := (others => '0');
begin
  tready <= '0' when pause = 0 else '1';
  frames <= frame_count;

  process (clock)
    variable frame_hits : natural range 0 to map_px + 1;
  begin
    if rising_edge(clock) then
      pause <= pause + 1;
      if tvalid = '1' and pause /= 0 then
        frame_hits := hits;
        if tuser(0) = '1' then
          frame_hits := 0;
        end if;
        if unsigned(tdata(7 downto 0)) = shift then
          frame_hits := frame_hits + 1;
        end if;
        hits <= frame_hits;
        if tuser(0) = '1' then
          beats <= 1;
        else
          beats <= beats + 1;
        end if;
        if beats = map_px - 1 then
          beats <= 0;
          good <= '0';
          if frame_hits >= map_px - map_px / 4 and tuser(1) = '0' then
            good <= '1';
          end if;
          frame_count <= frame_count + 1;
        end if;
      end if;
      if reset = '1' then
        pause <= (others => '0');
        hits <= 0;
        beats <= 0;
        good <= '0';
        frame_count <= (others => '0');
      end if;
    end if;
  end process;
end architecture;
