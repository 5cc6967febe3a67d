-- SPDX-License-Identifier: Apache-2.0
-- Drives a stereo_joiner with a stimulus file and writes down what it shows. It judges nothing:
-- scripts/tests/test_joiner.py does.
--   stimulus  a line a clock: FLAGS LEFT RIGHT, hexadecimal; LEFT and RIGHT are lanes. FLAGS: bits 2 ... 0 of the left
--             camera: end of line, start of frame, valid; bits 5 ... 3 of the right one; bit 6: the sink is ready; bit 7:
--             reset
--   observed  a line for each pair that leaves and each fault: CLOCK pair PAIR FLAGS SKEW, flags: end of line, start of
--             frame; CLOCK fault BITS
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tb_stereo_joiner is
  generic (
    stimulus_file : string := "";
    observed_file : string := "";
    width_px : positive := 8;
    height_px : positive := 4;
    depth : positive := 16;
    pixel_bits : positive := 8;
    lane_bits : positive := 8
  );
end entity;

architecture sim of tb_stereo_joiner is
  signal clock, reset_n : std_logic := '0';
  signal flags : std_logic_vector(7 downto 0) := (others => '0');
  signal left, right : std_logic_vector(lane_bits - 1 downto 0) := (others => '0');
  signal pair : std_logic_vector(2 * lane_bits - 1 downto 0);
  signal valid, last, left_ready, right_ready : std_logic;
  signal start : std_logic_vector(0 downto 0);
  signal skew : std_logic_vector(15 downto 0);
  signal faults : std_logic_vector(2 downto 0);
begin
  reset_n <= not flags(7);

  dut : entity work.stereo_joiner
    generic map (
      width_px => width_px, height_px => height_px, depth => depth, pixel_bits => pixel_bits, lane_bits => lane_bits)
    port map (
      aclk => clock, aresetn => reset_n,
      s_left_axis_tvalid => flags(0), s_left_axis_tready => left_ready, s_left_axis_tdata => left,
      s_left_axis_tuser => flags(1 downto 1), s_left_axis_tlast => flags(2),
      s_right_axis_tvalid => flags(3), s_right_axis_tready => right_ready, s_right_axis_tdata => right,
      s_right_axis_tuser => flags(4 downto 4), s_right_axis_tlast => flags(5),
      m_axis_tvalid => valid, m_axis_tready => flags(6), m_axis_tdata => pair, m_axis_tuser => start,
      m_axis_tlast => last, skew_lines => skew, faults => faults);

  main : process
    file stimulus, observed : text;
    variable stimulus_line, observed_line : line;
    variable flags_value : std_logic_vector(7 downto 0);
    variable left_value, right_value : std_logic_vector(lane_bits - 1 downto 0);
    variable clock_count : natural := 0;
  begin
    file_open(stimulus, stimulus_file, read_mode);
    file_open(observed, observed_file, write_mode);
    while not endfile(stimulus) loop
      readline(stimulus, stimulus_line);
      hread(stimulus_line, flags_value);
      hread(stimulus_line, left_value);
      hread(stimulus_line, right_value);
      flags <= flags_value;
      left <= left_value;
      right <= right_value;
      wait for 5 ns;
      if flags(7) = '0' then
        assert left_ready = '1' and right_ready = '1' report "a camera was made to wait" severity failure;
        if valid = '1' and flags(6) = '1' then
          write(observed_line, to_string(clock_count) & " pair " & to_hstring(pair) & " " & to_string(
            to_integer(unsigned(std_logic_vector'(last & start)))) & " " & to_string(to_integer(signed(skew))));
          writeline(observed, observed_line);
        end if;
        if faults /= "000" then
          write(observed_line, to_string(clock_count) & " fault " & to_string(faults));
          writeline(observed, observed_line);
        end if;
      end if;
      clock <= '1';
      wait for 5 ns;
      clock <= '0';
      clock_count := clock_count + 1;
    end loop;
    write(observed_line, to_string(clock_count) & " end");
    writeline(observed, observed_line);
    file_close(observed);
    wait;
  end process;
end architecture;
