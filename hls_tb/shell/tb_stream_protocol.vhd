-- SPDX-License-Identifier: Apache-2.0
-- The maps of stereo_ip_tiny under VUnit's checker of the AXI4-Stream protocol, which stops at the first rule that is
-- broken.
library ieee;
use ieee.std_logic_1164.all;
library vunit_lib;
context vunit_lib.vunit_context;
context vunit_lib.vc_context;

entity tb_stream_protocol is
  generic (runner_cfg : string);
end entity;

architecture sim of tb_stream_protocol is
  constant rules : axi_stream_protocol_checker_t :=
    new_axi_stream_protocol_checker(data_length => 16, user_length => 2, logger => get_logger("m_axis"), max_waits => 1000);
  signal aclk : std_logic := '0';
  signal aresetn, s_axis_tvalid, s_axis_tready, s_axis_tlast : std_logic;
  signal s_axis_tdata : std_logic_vector(15 downto 0);
  signal s_axis_tuser : std_logic_vector(0 downto 0);
  signal m_axis_tvalid, m_axis_tready, m_axis_tlast : std_logic;
  signal m_axis_tdata : std_logic_vector(15 downto 0);
  signal m_axis_tuser : std_logic_vector(1 downto 0);
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
      m_axis_tvalid => m_axis_tvalid, m_axis_tready => m_axis_tready, m_axis_tdata => m_axis_tdata,
      m_axis_tuser => m_axis_tuser, m_axis_tlast => m_axis_tlast,
      s_axil_awaddr => (others => '0'), s_axil_awprot => "000", s_axil_awvalid => '0', s_axil_awready => open,
      s_axil_wdata => (others => '0'), s_axil_wstrb => "0000", s_axil_wvalid => '0', s_axil_wready => open,
      s_axil_bresp => open, s_axil_bvalid => open, s_axil_bready => '0',
      s_axil_araddr => (others => '0'), s_axil_arprot => "000", s_axil_arvalid => '0', s_axil_arready => open,
      s_axil_rdata => open, s_axil_rresp => open, s_axil_rvalid => open, s_axil_rready => '0', irq => open);

  checker : entity vunit_lib.axi_stream_protocol_checker
    generic map (protocol_checker => rules)
    port map (
      aclk => aclk, areset_n => aresetn, tvalid => m_axis_tvalid, tready => m_axis_tready, tdata => m_axis_tdata,
      tlast => m_axis_tlast, tuser => m_axis_tuser);

  main : process
  begin
    test_runner_setup(runner, runner_cfg);
    wait until done;
    test_runner_cleanup(runner);
  end process;
end architecture;
