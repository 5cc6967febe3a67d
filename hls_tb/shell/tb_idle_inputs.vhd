-- SPDX-License-Identifier: Apache-2.0
-- stereo_ip_tiny with inputs of which only those that count are known. It judges nothing but that the maps come: what a
-- simulator says of numbers that are made of 'X' is counted by scripts/tests/test_unknown_values.py.
library ieee;
use ieee.std_logic_1164.all;

entity tb_idle_inputs is
end entity;

architecture sim of tb_idle_inputs is
  signal aclk : std_logic := '0';
  signal aresetn, s_axis_tvalid, s_axis_tready, s_axis_tlast, m_axis_tvalid, m_axis_tready : std_logic;
  signal s_axis_tdata : std_logic_vector(15 downto 0);
  signal s_axis_tuser : std_logic_vector(0 downto 0);
  signal done : boolean;
begin
  aclk <= not aclk after 5 ns when not done else '0';

  traffic : entity work.idle_traffic
    generic map (width_px => 32, height_px => 12, map_px => 24 * 12)
    port map (
      aclk => aclk, aresetn => aresetn,
      s_axis_tvalid => s_axis_tvalid, s_axis_tready => s_axis_tready, s_axis_tdata => s_axis_tdata,
      s_axis_tuser => s_axis_tuser, s_axis_tlast => s_axis_tlast,
      m_axis_tvalid => m_axis_tvalid, m_axis_tready => m_axis_tready, done => done);

  dut : entity work.stereo_ip_tiny
    port map (
      aclk => aclk, aresetn => aresetn,
      s_axis_tvalid => s_axis_tvalid, s_axis_tready => s_axis_tready, s_axis_tdata => s_axis_tdata,
      s_axis_tuser => s_axis_tuser, s_axis_tlast => s_axis_tlast,
      m_axis_tvalid => m_axis_tvalid, m_axis_tready => m_axis_tready, m_axis_tdata => open, m_axis_tuser => open,
      m_axis_tlast => open,
      s_axil_awaddr => (others => 'X'), s_axil_awprot => (others => 'X'), s_axil_awvalid => '0', s_axil_awready => open,
      s_axil_wdata => (others => 'X'), s_axil_wstrb => "XXXX", s_axil_wvalid => '0', s_axil_wready => open,
      s_axil_bresp => open, s_axil_bvalid => open, s_axil_bready => '0',
      s_axil_araddr => (others => 'X'), s_axil_arprot => (others => 'X'), s_axil_arvalid => '0', s_axil_arready => open,
      s_axil_rdata => open, s_axil_rresp => open, s_axil_rvalid => open, s_axil_rready => '0', irq => open);
end architecture;
