-- SPDX-License-Identifier: Apache-2.0
-- The design as Bambu wrote it, with the ports of the lowered one, so that both run in the same bench. The tool's files
-- are in the library `bambu`; NAME stands for that of the configuration. The core starts with the first clock of the
-- bench's reset, since it spends one clock on loading its registers before it takes input.
library ieee;
use ieee.std_logic_1164.all;
library bambu;

entity stereo_core_NAME is
  port (
    clock : in std_logic;
    reset : in std_logic;
    left_pixel : in std_logic_vector;
    right_pixel : in std_logic_vector;
    start_of_frame : in std_logic;
    valid : in std_logic;
    -- ports of settings
    disparity : out std_logic_vector;
    pixel_valid : out std_logic_vector;
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic
  );
end entity;

architecture original of stereo_core_NAME is
  signal running : std_logic := '0';
  signal valid_flag, start_flag, line_flag : std_logic_vector(0 downto 0);
  signal pixels_valid : std_logic_vector(7 downto 0);
  signal left, right : std_logic_vector(PIXELS - 1 downto 0) := (others => '0');  -- as wide as a C++ type
begin
  left(left_pixel'length - 1 downto 0) <= left_pixel;
  right(right_pixel'length - 1 downto 0) <= right_pixel;
  running <= '1' when rising_edge(clock);
  disparity_valid <= valid_flag(0);
  pixel_valid <= pixels_valid(pixel_valid'range);
  disparity_start_of_frame <= start_flag(0);
  disparity_end_of_line <= line_flag(0);

  core : entity bambu.stereo_core
    port map (
      clock => clock, reset => running, start_port => '1', done_port => open,
      left_pixel => left, right_pixel => right,
      start_of_frame(0) => start_of_frame, valid(0) => valid,
      -- settings
      disparity => disparity, pixel_valid => pixels_valid, disparity_valid => valid_flag,
      disparity_start_of_frame => start_flag, disparity_end_of_line => line_flag);
end architecture;
