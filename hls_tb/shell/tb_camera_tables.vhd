-- SPDX-License-Identifier: Apache-2.0
-- Drives camera_tables with a file, one line a clock, and writes down all outputs of each clock, before its edge.
-- scripts/tests/test_camera_tables.py makes the one and judges the other.
--   stimulus  FLAGS AWADDR WDATA ARADDR SKEW FAULTS, hexadecimal; FLAGS: bit 0 aresetn, 1 awvalid, 2 wvalid, 3 bready,
--             4 arvalid, 5 rready
--   observed  AWREADY WREADY BVALID ARREADY RVALID NODE_VALID NODE_RIGHT as bits, BRESP RRESP as bits, then hexadecimal
--             RDATA NODE_COLUMN NODE_ROW NODE_X NODE_Y DEPTH_DISPARITY DEPTH_MM
library ieee;
use ieee.std_logic_1164.all;
use std.textio.all;

entity tb_camera_tables is
  generic (
    stimulus_file : string := "";
    observed_file : string := "";
    table_columns : positive := 5;
    table_rows : positive := 3;
    depth_entries : positive := 9;
    sixteenths : natural := 0  -- 1: depths of subpixel disparities
  );
end entity;

architecture sim of tb_camera_tables is
  signal aclk, aresetn : std_logic := '0';
  signal awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready : std_logic := '0';
  signal awaddr, araddr : std_logic_vector(4 downto 0) := (others => '0');
  signal wdata, rdata : std_logic_vector(31 downto 0) := (others => '0');
  signal bresp, rresp : std_logic_vector(1 downto 0);
  signal skew_lines : std_logic_vector(15 downto 0) := (others => '0');
  signal faults : std_logic_vector(2 downto 0) := "000";
  signal node_valid, node_right : std_logic;
  signal node_column, node_row, node_x, node_y, depth_disparity, depth_mm : std_logic_vector(15 downto 0);
begin
  dut : entity work.camera_tables
    generic map (
      table_columns => table_columns, table_rows => table_rows, depth_entries => depth_entries,
      subpixel => sixteenths = 1)
    port map (
      aclk => aclk, aresetn => aresetn, s_axil_awaddr => awaddr, s_axil_awvalid => awvalid, s_axil_awready => awready,
      s_axil_wdata => wdata, s_axil_wvalid => wvalid, s_axil_wready => wready, s_axil_bresp => bresp,
      s_axil_bvalid => bvalid, s_axil_bready => bready, s_axil_araddr => araddr, s_axil_arvalid => arvalid,
      s_axil_arready => arready, s_axil_rdata => rdata, s_axil_rresp => rresp, s_axil_rvalid => rvalid,
      s_axil_rready => rready, skew_lines => skew_lines, faults => faults, node_valid => node_valid,
      node_right => node_right, node_column => node_column, node_row => node_row, node_x => node_x, node_y => node_y,
      depth_disparity => depth_disparity, depth_mm => depth_mm);

  main : process
    file stimulus, observed : text;
    variable stimulus_line, observed_line : line;
    variable flags, aw, ar : std_logic_vector(7 downto 0);
    variable data : std_logic_vector(31 downto 0);
    variable skew : std_logic_vector(15 downto 0);
    variable bits : std_logic_vector(3 downto 0);
  begin
    file_open(stimulus, stimulus_file, read_mode);
    file_open(observed, observed_file, write_mode);
    while not endfile(stimulus) loop
      readline(stimulus, stimulus_line);
      hread(stimulus_line, flags);
      hread(stimulus_line, aw);
      hread(stimulus_line, data);
      hread(stimulus_line, ar);
      hread(stimulus_line, skew);
      hread(stimulus_line, bits);
      aresetn <= flags(0);
      awvalid <= flags(1);
      wvalid <= flags(2);
      bready <= flags(3);
      arvalid <= flags(4);
      rready <= flags(5);
      awaddr <= aw(4 downto 0);
      wdata <= data;
      araddr <= ar(4 downto 0);
      skew_lines <= skew;
      faults <= bits(2 downto 0);
      wait for 5 ns;
      write(observed_line, to_string(std_logic_vector'(awready & wready & bvalid & arready & rvalid & node_valid & node_right)));
      write(observed_line, " " & to_string(bresp) & " " & to_string(rresp) & " " & to_hstring(rdata));
      write(observed_line, " " & to_hstring(node_column) & " " & to_hstring(node_row) & " " & to_hstring(node_x));
      write(observed_line, " " & to_hstring(node_y) & " " & to_hstring(depth_disparity) & " " & to_hstring(depth_mm));
      writeline(observed, observed_line);
      aclk <= '1';
      wait for 5 ns;
      aclk <= '0';
    end loop;
    file_close(observed);
    wait;
  end process;
end architecture;
