-- SPDX-License-Identifier: Apache-2.0
-- The design for all boards, around the core in board_core.vhd. After configuration, and after the button: a source of moved
-- noise and a check of the maps. From the first frame on that comes over the serial line: the map of each frame goes back
-- over it. README.md in this folder has the protocol.
--   led(0)   self test: the last map was right; serial line: the last frame came in and its map went out, both whole
--   led(1)   a frame has come over the serial line
--   led(2 ...)  the lowest bits of the number of maps of the self test
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.board_sizes.all;

entity board_top is
  generic (
    clock_hz : positive := 25000000;
    baud : positive := 1000000;
    quiet_ms : positive := 125;  -- a frame whose bytes pause for longer is given up
    leds : positive := 8;  -- 2 to 10
    leds_active_low : boolean := false;
    button_active_low : boolean := false
  );
  port (
    clock : in std_logic;
    button : in std_logic;
    rx : in std_logic;
    tx : out std_logic;
    led : out std_logic_vector(leds - 1 downto 0)
  );
end entity;

architecture rtl of board_top is
  constant clocks_per_bit : positive := (clock_hz + baud / 2) / baud;
  constant shift : positive := 5;

  signal pressed : std_logic;
  signal resetn_history : std_logic_vector(3 downto 0) := "0000";  -- holds the reset for four clocks after configuration
  signal reset : std_logic;
  signal over_line : std_logic := '0';  -- frames come over the serial line
  signal core_aresetn : std_logic := '0';
  signal core_reset, begins, good, whole : std_logic;
  signal frames : unsigned(7 downto 0);
  signal received_valid, received_broken, sent_valid, sent_ready : std_logic;
  signal received, sent : std_logic_vector(7 downto 0);
  signal pattern_tvalid, pattern_tlast, serial_tvalid, serial_tlast, in_tvalid, in_tready, in_tlast : std_logic;
  signal pattern_tdata, serial_tdata, in_tdata, map_tdata : std_logic_vector(15 downto 0);
  signal pattern_tuser, serial_tuser, in_tuser : std_logic_vector(0 downto 0);
  signal map_tvalid, map_tready, map_tlast, check_tvalid, check_tready, sink_tvalid, sink_tready : std_logic;
  signal map_tuser : std_logic_vector(1 downto 0);
  signal shown : std_logic_vector(9 downto 0);
begin
  pressed <= not button when button_active_low else button;
  reset <= not resetn_history(3);
  core_reset <= not core_aresetn;

  process (clock)
  begin
    if rising_edge(clock) then
      resetn_history <= resetn_history(2 downto 0) & not pressed;
      core_aresetn <= not (reset or begins);
      over_line <= (over_line or begins) and not reset;
    end if;
  end process;

  receiver : entity work.uart_receiver
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => clock, reset => reset, serial => rx,
      out_valid => received_valid, out_broken => received_broken, out_data => received);

  pairs : entity work.serial_source
    generic map (width_px => width_px, height_px => height_px, quiet_clocks => clock_hz / 1000 * quiet_ms)
    port map (
      clock => clock, reset => reset,
      byte_valid => received_valid, byte_broken => received_broken, byte_data => received, begins => begins,
      tvalid => serial_tvalid, tready => in_tready, tdata => serial_tdata, tuser => serial_tuser, tlast => serial_tlast);

  source : entity work.pattern_source
    generic map (width_px => width_px, height_px => height_px, shift => shift)
    port map (
      clock => clock, reset => core_reset,
      tvalid => pattern_tvalid, tready => in_tready, tdata => pattern_tdata, tuser => pattern_tuser, tlast => pattern_tlast);

  in_tvalid <= serial_tvalid when over_line = '1' else pattern_tvalid;
  in_tdata <= serial_tdata when over_line = '1' else pattern_tdata;
  in_tuser <= serial_tuser when over_line = '1' else pattern_tuser;
  in_tlast <= serial_tlast when over_line = '1' else pattern_tlast;

  stereo : entity work.board_core
    port map (
      aclk => clock, aresetn => core_aresetn,
      s_axis_tvalid => in_tvalid, s_axis_tready => in_tready, s_axis_tdata => in_tdata, s_axis_tuser => in_tuser,
      s_axis_tlast => in_tlast,
      m_axis_tvalid => map_tvalid, m_axis_tready => map_tready, m_axis_tdata => map_tdata, m_axis_tuser => map_tuser,
      m_axis_tlast => map_tlast);

  check_tvalid <= map_tvalid and not over_line;
  sink_tvalid <= map_tvalid and over_line;
  map_tready <= sink_tready when over_line = '1' else check_tready;

  judge : entity work.map_check
    generic map (map_px => output_width_px * height_px, shift => shift)
    port map (
      clock => clock, reset => core_reset, tvalid => check_tvalid, tready => check_tready, tdata => map_tdata,
      tuser => map_tuser, good => good, frames => frames);

  answers : entity work.serial_sink
    generic map (height_px => height_px)
    port map (
      clock => clock, reset => core_reset,
      tvalid => sink_tvalid, tready => sink_tready, tdata => map_tdata, tuser => map_tuser, tlast => map_tlast,
      byte_valid => sent_valid, byte_ready => sent_ready, byte_data => sent, whole => whole);

  transmitter : entity work.uart_transmitter
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => clock, reset => reset, in_valid => sent_valid, in_ready => sent_ready, in_data => sent, serial => tx);

  shown(0) <= whole when over_line = '1' else good;
  shown(1) <= over_line;
  shown(9 downto 2) <= std_logic_vector(frames);
  led <= not shown(leds - 1 downto 0) when leds_active_low else shown(leds - 1 downto 0);
end architecture;
