-- SPDX-License-Identifier: Apache-2.0
-- Sends two frames of noise through @{top}. The left image is the right one, moved: most disparities must say so.
-- Fails with the first thing that is wrong. Ends with "passed", the clocks to the first disparity, and those in which the
-- source had to wait: a camera cannot, and has blanking instead.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;

entity @{name} is
  generic (
    blanking : natural := 0;  -- clocks between the frames
    sink_waits : natural range 0 to 1 := 1  -- now and then
  );
end entity;

architecture sim of @{name} is
@{constants}
  constant frames : positive := 2;
  constant rows : positive := height_px / pixels_per_clock;  -- lines of a frame, on both sides
  constant most_clocks : positive := 6 * frames * rows * width_px + 20_000 + blanking;
  signal aclk : std_logic := '0';
@{signals}
  signal done, finished : boolean := false;
  signal clock_number, first_in, first_out, waited : natural := 0;
begin
  aclk <= not aclk after 5 ns when not finished else '0';

@{dut}

  watchdog : process (aclk)
  begin
    if rising_edge(aclk) then
      clock_number <= clock_number + 1;
      if first_in > 0 and s_axis_tvalid = '1' and s_axis_tready = '0' then
        waited <= waited + 1;
      end if;
      assert clock_number < most_clocks report "the maps do not come" severity failure;
    end if;
  end process;

  source : process
    constant before : natural := maximum(shift, 0);
    type row is array (0 to width_px + abs shift - 1) of natural range 0 to 2 ** pixel_bits - 1;
    type group_of_rows is array (0 to pixels_per_clock - 1) of row;
    variable noise : group_of_rows;
    variable seed_a, seed_b : positive := 2007;
    variable number : real;
  begin
    for i in 1 to 4 loop
      wait until rising_edge(aclk);
    end loop;
    aresetn <= '1';
    s_axis_tvalid <= '1';
    for line in 0 to frames * rows - 1 loop
      for lane in noise'range loop
        for x in row'range loop
          uniform(seed_a, seed_b, number);
          noise(lane)(x) := natural(floor(number * 2.0 ** pixel_bits));
        end loop;
      end loop;
      for x in 0 to width_px - 1 loop
        for lane in noise'range loop
          s_axis_tdata(lane_bits * (lane + 1) - 1 downto lane_bits * lane) <=
            std_logic_vector(to_unsigned(noise(lane)(x - shift + before), lane_bits));
          s_axis_tdata(
            lane_bits * (pixels_per_clock + lane + 1) - 1 downto lane_bits * (pixels_per_clock + lane)) <=
            std_logic_vector(to_unsigned(noise(lane)(x + before), lane_bits));
        end loop;
        s_axis_tuser(0) <= '1' when line mod rows = 0 and x = 0 else '0';
        s_axis_tlast <= '1' when x = width_px - 1 else '0';
        wait until rising_edge(aclk) and s_axis_tready = '1';
        if line = 0 and x = 0 then
          first_in <= clock_number;
        end if;
      end loop;
      if line mod rows = rows - 1 then
        s_axis_tvalid <= '0';
        for i in 1 to blanking loop
          wait until rising_edge(aclk);
        end loop;
        s_axis_tvalid <= '1' when line < frames * rows - 1 else '0';
      end if;
    end loop;
    wait;
  end process;

  -- Waits in every fourth clock, but not before the first disparity.
  m_axis_tready <= '0' when sink_waits = 1 and first_out > 0 and clock_number mod 4 = 0 else '1';

  sink : process
    variable shown, as_expected : natural := 0;
  begin
    for beat in 0 to frames * rows * output_width_px - 1 loop
      wait until rising_edge(aclk) and m_axis_tvalid = '1' and m_axis_tready = '1';
      if beat = 0 then
        first_out <= clock_number;
      end if;
      assert (m_axis_tuser(0) = '1') = (beat mod (rows * output_width_px) = 0)
        report "start of frame is wrong at beat " & to_string(beat) severity failure;
      assert m_axis_tuser(1) = '0' report "frame error at beat " & to_string(beat) severity failure;
      assert (m_axis_tlast = '1') = (beat mod output_width_px = output_width_px - 1)
        report "end of line is wrong at beat " & to_string(beat) severity failure;
      for lane in 0 to pixels_per_clock - 1 loop
        shown := to_integer(unsigned(
          m_axis_tdata(disparity_bits * lane + value_bits - 1 downto disparity_bits * lane)));
        if abs (shown - expected) <= tolerance then
          as_expected := as_expected + 1;
        end if;
      end loop;
    end loop;
    assert expected < 0 or 2 * as_expected > frames * height_px * output_width_px
      report "only " & to_string(as_expected) & " disparities are " & to_string(expected) severity failure;
    done <= true;
    wait;
  end process;

  registers : process
    procedure expect(name : string; address : natural; value : std_logic_vector(31 downto 0)) is
    begin
      s_axil_araddr <= std_logic_vector(to_unsigned(address, s_axil_araddr'length));
      s_axil_arvalid <= '1';
      s_axil_rready <= '1';
      wait until rising_edge(aclk) and s_axil_arready = '1';
      s_axil_arvalid <= '0';
      wait until rising_edge(aclk) and s_axil_rvalid = '1';
      assert s_axil_rdata = value
        report "register " & name & " is " & to_hstring(s_axil_rdata) & ", not " & to_hstring(value) severity failure;
    end procedure;
  begin
    wait until done;
@{checks}
    expect("frames", 16#@{frames}#, std_logic_vector(to_unsigned(frames, 32)));
    report "@{top} passed: " & to_string(first_out - first_in) & " clocks from the first pair to the first disparity, " &
      to_string(waited) & " in which the source waited";
    finished <= true;
    wait;
  end process;
end architecture;
