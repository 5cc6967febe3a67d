-- SPDX-License-Identifier: Apache-2.0
-- stereo_ip_tiny for board_top. Do not edit; made by
--   scripts/build_example.py --config tiny --core FILE
package board_sizes is
  constant width_px : positive := 32;
  constant height_px : positive := 12;
  constant output_width_px : positive := 24;
end package;

library ieee;
use ieee.std_logic_1164.all;

entity board_core is
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_axis_tvalid : in std_logic;
    s_axis_tready : out std_logic;
    s_axis_tdata : in std_logic_vector(15 downto 0);
    s_axis_tuser : in std_logic_vector(0 downto 0);
    s_axis_tlast : in std_logic;
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(15 downto 0);
    m_axis_tuser : out std_logic_vector(1 downto 0);
    m_axis_tlast : out std_logic
  );
end entity;

architecture rtl of board_core is
begin
  stereo : entity work.stereo_ip_tiny
    port map (
      aclk => aclk,
      aresetn => aresetn,
      s_axis_tvalid => s_axis_tvalid,
      s_axis_tready => s_axis_tready,
      s_axis_tdata => s_axis_tdata,
      s_axis_tuser => s_axis_tuser,
      s_axis_tlast => s_axis_tlast,
      m_axis_tvalid => m_axis_tvalid,
      m_axis_tready => m_axis_tready,
      m_axis_tdata => m_axis_tdata,
      m_axis_tuser => m_axis_tuser,
      m_axis_tlast => m_axis_tlast,
      s_axil_awaddr => (others => '0'),
      s_axil_awprot => (others => '0'),
      s_axil_awvalid => '0',
      s_axil_awready => open,
      s_axil_wdata => (others => '0'),
      s_axil_wstrb => (others => '0'),
      s_axil_wvalid => '0',
      s_axil_wready => open,
      s_axil_bresp => open,
      s_axil_bvalid => open,
      s_axil_bready => '0',
      s_axil_araddr => (others => '0'),
      s_axil_arprot => (others => '0'),
      s_axil_arvalid => '0',
      s_axil_arready => open,
      s_axil_rdata => open,
      s_axil_rresp => open,
      s_axil_rvalid => open,
      s_axil_rready => '0',
      irq => open);
end architecture;
