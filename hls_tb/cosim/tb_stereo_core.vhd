-- SPDX-License-Identifier: Apache-2.0
-- Drives a design with a stimulus file, one line a clock, and writes down every output with its clock. It judges
-- nothing: the one checker of all simulators does (scripts/flow/cosim/checker.py). Words between two @ stand for what
-- follows from the ports of the design (scripts/flow/cosim/bench.py).
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tb_stereo_core is
  generic (
    stimulus_file : string := "";
    observed_file : string := ""
  );
end entity;

architecture sim of tb_stereo_core is
  signal clock, reset : std_logic := '0';
@PORT_SIGNALS@
begin
  dut : entity work.@ENTITY@
    port map (
      clock => clock, reset => reset,
      @PORT_MAP@);

  main : process
    constant half_period : time := 5 ns;
    constant progress_clocks : positive := 1000;
    file stimulus, observed : text;
    variable stimulus_line, observed_line, progress_line : line;
    variable flags : std_logic_vector(@FLAG_BITS@ - 1 downto 0);
@FIELD_VARIABLES@
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
      if @VALID@ = '0' then
        return;
      end if;
      write(observed_line, clock_count);
      if @VALID@ /= '1' or is_x(std_logic_vector'("" & @WORD@)) or is_x(std_logic_vector'("" & @SHOWN_FLAGS@)) then
        write(observed_line, string'(" X X"));
      else
        write(observed_line, " " & to_hstring(std_logic_vector'("" & @WORD@)));
        write(observed_line, " " & to_string(to_integer(unsigned(std_logic_vector'("" & @SHOWN_FLAGS@)))));
      end if;
      writeline(observed, observed_line);
    end procedure;
  begin
    file_open(stimulus, stimulus_file, read_mode);
    file_open(observed, observed_file, write_mode);
    readline(stimulus, stimulus_line);  -- format line, checked before the simulation starts
    reset <= '1';
    clock_edge;
    clock_edge;
    reset <= '0';
    while not endfile(stimulus) loop
      readline(stimulus, stimulus_line);
      hread(stimulus_line, flags);
@SET_FLAGS@
@READ_FIELDS@
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
