-- SPDX-License-Identifier: Apache-2.0
-- Example for the ULX3S board (ECP5 LFE5U-85F): the core of configuration tiny between a source of moved noise and a check.
-- LED 7: the disparities are right; LEDs 6 ... 0: count of frames. Button 1 resets.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity example_top is
  port (
    clk_25mhz : in std_logic;
    button : in std_logic;
    led : out std_logic_vector(7 downto 0)
  );
end entity;

architecture rtl of example_top is
  constant width_px : positive := 32;
  constant height_px : positive := 12;
  constant output_width_px : positive := 24;
  constant shift : positive := 5;

  signal resetn_history : std_logic_vector(3 downto 0) := "0000";  -- holds the reset for four clocks after configuration
  signal aresetn, reset, good : std_logic;
  signal frames : unsigned(7 downto 0);
  signal in_tvalid, in_tready, in_tlast, map_tvalid, map_tready : std_logic;
  signal in_tdata, map_tdata : std_logic_vector(15 downto 0);
  signal in_tuser : std_logic_vector(0 downto 0);
  signal map_tuser : std_logic_vector(1 downto 0);
begin
  process (clk_25mhz)
  begin
    if rising_edge(clk_25mhz) then
      resetn_history <= resetn_history(2 downto 0) & not button;
    end if;
  end process;
  aresetn <= resetn_history(3);
  reset <= not aresetn;

  source : entity work.pattern_source
    generic map (width_px => width_px, height_px => height_px, shift => shift)
    port map (
      clock => clk_25mhz, reset => reset,
      tvalid => in_tvalid, tready => in_tready, tdata => in_tdata, tuser => in_tuser, tlast => in_tlast);

  stereo : entity work.stereo_ip_tiny
    port map (
      aclk => clk_25mhz, aresetn => aresetn,
      s_axis_tvalid => in_tvalid, s_axis_tready => in_tready, s_axis_tdata => in_tdata, s_axis_tuser => in_tuser,
      s_axis_tlast => in_tlast,
      m_axis_tvalid => map_tvalid, m_axis_tready => map_tready, m_axis_tdata => map_tdata, m_axis_tuser => map_tuser,
      m_axis_tlast => open,
      s_axil_awaddr => (others => '0'), s_axil_awprot => "000", s_axil_awvalid => '0', s_axil_awready => open,
      s_axil_wdata => (others => '0'), s_axil_wstrb => "0000", s_axil_wvalid => '0', s_axil_wready => open,
      s_axil_bresp => open, s_axil_bvalid => open, s_axil_bready => '0',
      s_axil_araddr => (others => '0'), s_axil_arprot => "000", s_axil_arvalid => '0', s_axil_arready => open,
      s_axil_rdata => open, s_axil_rresp => open, s_axil_rvalid => open, s_axil_rready => '0');

  check : entity work.map_check
    generic map (map_px => output_width_px * height_px, shift => shift)
    port map (
      clock => clk_25mhz, reset => reset, tvalid => map_tvalid, tready => map_tready, tdata => map_tdata, tuser => map_tuser,
      good => good, frames => frames);

  led <= good & std_logic_vector(frames(6 downto 0));
end architecture;
