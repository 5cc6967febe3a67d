-- SPDX-License-Identifier: Apache-2.0
-- Drives a stereo_core_NAME (NAME stands for that of the configuration) with a stimulus file, one line a clock, and
-- writes down every output with its clock. It judges nothing: the one checker of all simulators does
-- (scripts/flow/cosim/checker.py).
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tb_stereo_core is
  generic (
    stimulus_file  : string;
    observed_file  : string;
    pixels         : positive := 1;  -- pixel pairs a clock
    disparity_bits : positive := 8;  -- of one pixel
    settings_count : natural := 0  -- that have ports
  );
end entity;

architecture sim of tb_stereo_core is
  signal clock, reset, start_of_frame, valid : std_logic := '0';
  signal left_pixel, right_pixel : std_logic_vector(8 * pixels - 1 downto 0);
  signal settings : std_logic_vector(16 * settings_count - 1 downto 0);
  signal disparity : std_logic_vector(disparity_bits * pixels - 1 downto 0);
  signal pixel_valid : std_logic_vector(pixels - 1 downto 0);
  signal disparity_valid, disparity_start_of_frame, disparity_end_of_line : std_logic;
begin
  dut : entity work.stereo_core_NAME
    port map (
      clock => clock, reset => reset,
      left_pixel => left_pixel, right_pixel => right_pixel, start_of_frame => start_of_frame, valid => valid,
      -- settings of the stimulus
      disparity => disparity, pixel_valid => pixel_valid, disparity_valid => disparity_valid,
      disparity_start_of_frame => disparity_start_of_frame, disparity_end_of_line => disparity_end_of_line);

  main : process
    constant half_period : time := 5 ns;
    constant progress_clocks : positive := 1000;
    file stimulus, observed : text;
    variable stimulus_line, observed_line, progress_line : line;
    variable flags : std_logic_vector(3 downto 0);
    variable left_value, right_value : std_logic_vector(8 * pixels - 1 downto 0);
    variable setting : std_logic_vector(15 downto 0);
    variable clock_count : natural := 0;

    procedure clock_edge is
    begin
      wait for half_period;
      clock <= '1';
      wait for half_period;
      clock <= '0';
    end procedure;

    -- One line for every clock whose outputs say valid; a valid bit that is neither 0 nor 1 is written down as well.
    procedure observe is
    begin
      if disparity_valid = '0' then
        return;
      end if;
      write(observed_line, clock_count);
      if disparity_valid /= '1' or is_x(disparity) or is_x(pixel_valid) or is_x(disparity_start_of_frame) or is_x(disparity_end_of_line) then
        write(observed_line, string'(" X X"));
      else
        write(observed_line, " " & to_hstring(disparity));
        write(observed_line, " " & to_string(to_integer(unsigned(std_logic_vector'(
          pixel_valid & disparity_end_of_line & disparity_start_of_frame)))));
      end if;
      writeline(observed, observed_line);
    end procedure;
  begin
    file_open(stimulus, stimulus_file, read_mode);
    file_open(observed, observed_file, write_mode);
    readline(stimulus, stimulus_line);  -- format line, checked before the simulation starts
    left_pixel <= (others => '0');
    right_pixel <= (others => '0');
    reset <= '1';
    clock_edge;
    clock_edge;
    reset <= '0';
    while not endfile(stimulus) loop
      readline(stimulus, stimulus_line);
      hread(stimulus_line, flags);
      hread(stimulus_line, left_value);
      hread(stimulus_line, right_value);
      valid <= flags(0);
      start_of_frame <= flags(1);
      reset <= flags(2);
      left_pixel <= left_value;
      right_pixel <= right_value;
      for i in 0 to settings_count - 1 loop
        hread(stimulus_line, setting);
        settings(16 * i + 15 downto 16 * i) <= setting;
      end loop;
      wait for 0 ns;
      observe;
      clock_edge;
      clock_count := clock_count + 1;
      if clock_count mod progress_clocks = 0 then
        write(progress_line, "progress " & to_string(clock_count));
        writeline(output, progress_line);
      end if;
    end loop;
    write(observed_line, "end " & to_string(clock_count));
    writeline(observed, observed_line);
    file_close(observed);
    wait;
  end process;
end architecture;
