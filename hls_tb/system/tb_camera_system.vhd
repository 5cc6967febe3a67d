-- SPDX-License-Identifier: Apache-2.0
-- Plays two cameras into a camera_system and writes down every beat of m_axis, as camera_bench.cpp does, with the same
-- files. It judges nothing: scripts/flow/system/ does. NAME stands for the system, and
-- the numbers of lane_bits and map_bits give way to its own.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use ieee.math_real.all;
use std.textio.all;

entity tb_camera_system is
  generic (
    stream_file : string := "";
    observed_file : string := ""
  );
end entity;

architecture sim of tb_camera_system is
  constant lane_bits : positive := 8;  -- of a pixel
  constant map_bits : positive := 24;  -- of m_axis_tdata
  constant quiet_clocks : positive := 4000;
  constant progress_clocks : positive := 20000;
  signal clock, reset_n, tables_done, done : std_logic := '0';
  signal table_awvalid, table_awready, table_bvalid : std_logic := '0';
  signal table_awaddr : std_logic_vector(4 downto 0) := (others => '0');
  signal table_wdata : std_logic_vector(31 downto 0) := (others => '0');
  signal table_bresp : std_logic_vector(1 downto 0);
  type pixels is array (0 to 1) of std_logic_vector(lane_bits - 1 downto 0);
  signal camera_valid, camera_start, camera_last : std_logic_vector(0 to 1) := "00";
  signal camera_pixel : pixels := (others => (others => '0'));
  signal camera_ended : std_logic_vector(0 to 1) := "00";
  signal map_valid, map_last : std_logic;
  signal map_ready : std_logic := '0';
  signal map_data : std_logic_vector(map_bits - 1 downto 0);
  signal map_user : std_logic_vector(1 downto 0);
begin
  clock <= not clock after 5 ns when done = '0';

  dut : entity work.camera_system_NAME
    port map (
      aclk => clock, aresetn => reset_n,
      s_left_axis_tvalid => camera_valid(0), s_left_axis_tready => open, s_left_axis_tdata => camera_pixel(0),
      s_left_axis_tuser => camera_start(0 to 0), s_left_axis_tlast => camera_last(0),
      s_right_axis_tvalid => camera_valid(1), s_right_axis_tready => open, s_right_axis_tdata => camera_pixel(1),
      s_right_axis_tuser => camera_start(1 to 1), s_right_axis_tlast => camera_last(1),
      m_axis_tvalid => map_valid, m_axis_tready => map_ready, m_axis_tdata => map_data, m_axis_tuser => map_user,
      m_axis_tlast => map_last,
      s_axil_awaddr => (others => '0'), s_axil_awprot => (others => '0'), s_axil_awvalid => '0',
      s_axil_awready => open, s_axil_wdata => (others => '0'), s_axil_wstrb => (others => '0'), s_axil_wvalid => '0',
      s_axil_wready => open, s_axil_bresp => open, s_axil_bvalid => open, s_axil_bready => '1',
      s_axil_araddr => (others => '0'), s_axil_arprot => (others => '0'), s_axil_arvalid => '0',
      s_axil_arready => open, s_axil_rdata => open, s_axil_rresp => open, s_axil_rvalid => open,
      s_axil_rready => '1',
      s_tables_axil_awaddr => table_awaddr, s_tables_axil_awvalid => table_awvalid,
      s_tables_axil_awready => table_awready, s_tables_axil_wdata => table_wdata,
      s_tables_axil_wvalid => table_awvalid, s_tables_axil_wready => open, s_tables_axil_bresp => table_bresp,
      s_tables_axil_bvalid => table_bvalid, s_tables_axil_bready => '1', s_tables_axil_araddr => (others => '0'),
      s_tables_axil_arvalid => '0', s_tables_axil_arready => open, s_tables_axil_rdata => open,
      s_tables_axil_rresp => open, s_tables_axil_rvalid => open, s_tables_axil_rready => '1');

  cameras : for camera in 0 to 1 generate
    process
      file stream : text;
      variable words : line;
      variable kind : character;
      variable gap, flags : natural;
      variable pixel : std_logic_vector(lane_bits - 1 downto 0);
    begin
      file_open(stream, stream_file, read_mode);
      wait until tables_done = '1';
      while not endfile(stream) loop
        readline(stream, words);
        read(words, kind);
        if (kind = 'l' and camera = 0) or (kind = 'r' and camera = 1) then
          read(words, gap);
          hread(words, pixel);
          read(words, flags);
          for i in 1 to gap loop
            camera_valid(camera) <= '0';
            wait until falling_edge(clock);
          end loop;
          camera_valid(camera) <= '1';
          camera_pixel(camera) <= pixel;
          camera_start(camera) <= '1' when flags mod 2 = 1 else '0';
          camera_last(camera) <= '1' when flags / 2 mod 2 = 1 else '0';
          wait until falling_edge(clock);
        end if;
      end loop;
      camera_valid(camera) <= '0';
      camera_ended(camera) <= '1';
      wait;
    end process;
  end generate;

  main : process
    file stream, observed : text;
    variable words, note : line;
    variable kind : character;
    variable address : std_logic_vector(7 downto 0);
    variable data : std_logic_vector(31 downto 0);
    variable percent : natural := 0;
    variable seed_1, seed_2 : positive := 1;
    variable chance : real;
    variable clocks, last : natural := 0;

    procedure write_table is
    begin
      table_awaddr <= address(4 downto 0);
      table_wdata <= data;
      table_awvalid <= '1';
      wait until rising_edge(clock) and table_awready = '1';
      table_awvalid <= '0';
      wait until rising_edge(clock) and table_bvalid = '1';
      write(note, "t " & to_string(to_integer(unsigned(table_bresp))));
      writeline(observed, note);
    end procedure;

    procedure observe_camera(camera : natural) is
    begin
      if camera_valid(camera) = '1' then
        last := clocks;
        if camera_last(camera) = '1' then
          write(note, "e " & to_string(camera) & " " & to_string(clocks));
          writeline(observed, note);
        end if;
      end if;
    end procedure;

    procedure observe_map is
      variable flags : std_logic_vector(2 downto 0);
    begin
      if map_valid = '1' and map_ready = '1' then
        last := clocks;
        flags := map_last & map_user;
        write(note, "o " & to_hstring(map_data) & " " & to_string(to_integer(unsigned(flags))) & " " & to_string(clocks));
        writeline(observed, note);
      end if;
    end procedure;
  begin
    file_open(stream, stream_file, read_mode);
    file_open(observed, observed_file, write_mode);
    for i in 1 to 3 loop
      wait until rising_edge(clock);
    end loop;
    reset_n <= '1';
    while not endfile(stream) loop
      readline(stream, words);
      read(words, kind);
      if kind = 't' then
        hread(words, address);
        hread(words, data);
        write_table;
      elsif kind = 's' then
        read(words, percent);
        read(words, seed_2);
      end if;
    end loop;
    wait until falling_edge(clock);
    tables_done <= '1';
    while camera_ended /= "11" or clocks - last < quiet_clocks loop
      uniform(seed_1, seed_2, chance);
      map_ready <= '1' when chance * 100.0 >= real(percent) else '0';
      wait until rising_edge(clock);
      observe_camera(0);
      observe_camera(1);
      observe_map;
      clocks := clocks + 1;
      if clocks mod progress_clocks = 0 then
        write(note, "progress " & to_string(clocks));
        writeline(output, note);
      end if;
      wait until falling_edge(clock);
    end loop;
    write(note, "end " & to_string(clocks));
    writeline(observed, note);
    file_close(observed);
    done <= '1';
    wait;
  end process;
end architecture;
