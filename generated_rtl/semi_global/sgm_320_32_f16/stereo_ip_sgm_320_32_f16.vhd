-- SPDX-License-Identifier: Apache-2.0
-- The core stereo_core_sgm_320_32_f16 between AXI4-Streams: docs/integration.md. Do not edit; made by
--   scripts/instantiate.py --config sgm_320_32_f16
library ieee;
use ieee.std_logic_1164.all;

entity stereo_ip_sgm_320_32_f16 is
  generic (enabled_at_reset : boolean := true);  -- false: waits for a processor
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
    m_axis_tlast : out std_logic;
    s_axil_awaddr : in std_logic_vector(6 downto 0);
    s_axil_awprot : in std_logic_vector(2 downto 0);
    s_axil_awvalid : in std_logic;
    s_axil_awready : out std_logic;
    s_axil_wdata : in std_logic_vector(31 downto 0);
    s_axil_wstrb : in std_logic_vector(3 downto 0);
    s_axil_wvalid : in std_logic;
    s_axil_wready : out std_logic;
    s_axil_bresp : out std_logic_vector(1 downto 0);
    s_axil_bvalid : out std_logic;
    s_axil_bready : in std_logic;
    s_axil_araddr : in std_logic_vector(6 downto 0);
    s_axil_arprot : in std_logic_vector(2 downto 0);
    s_axil_arvalid : in std_logic;
    s_axil_arready : out std_logic;
    s_axil_rdata : out std_logic_vector(31 downto 0);
    s_axil_rresp : out std_logic_vector(1 downto 0);
    s_axil_rvalid : out std_logic;
    s_axil_rready : in std_logic;
    irq : out std_logic
  );
end entity;

architecture rtl of stereo_ip_sgm_320_32_f16 is
  signal reset : std_logic;
  signal left_pixel : std_logic_vector(7 downto 0);
  signal right_pixel : std_logic_vector(7 downto 0);
  signal start_of_frame : std_logic;
  signal valid : std_logic;
  signal disparity : std_logic_vector(7 downto 0);
  signal pixel_valid : std_logic_vector(0 downto 0);
  signal disparity_valid : std_logic;
  signal disparity_start_of_frame : std_logic;
  signal disparity_end_of_line : std_logic;
begin
  shell : entity work.stereo_shell
    generic map (
      width_px => 320,
      height_px => 240,
      disparities => 32,
      pixels_per_clock => 1,
      disparity_bits => 8,
      output_width_px => 289,
      latency_clocks => 73,
      flush_groups => 1926,
      gap_groups => 0,
      core_id => x"85bb4fe3",
      enabled_at_reset => enabled_at_reset,
      clocks_per_group => 16)
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
      s_axil_awaddr => s_axil_awaddr,
      s_axil_awprot => s_axil_awprot,
      s_axil_awvalid => s_axil_awvalid,
      s_axil_awready => s_axil_awready,
      s_axil_wdata => s_axil_wdata,
      s_axil_wstrb => s_axil_wstrb,
      s_axil_wvalid => s_axil_wvalid,
      s_axil_wready => s_axil_wready,
      s_axil_bresp => s_axil_bresp,
      s_axil_bvalid => s_axil_bvalid,
      s_axil_bready => s_axil_bready,
      s_axil_araddr => s_axil_araddr,
      s_axil_arprot => s_axil_arprot,
      s_axil_arvalid => s_axil_arvalid,
      s_axil_arready => s_axil_arready,
      s_axil_rdata => s_axil_rdata,
      s_axil_rresp => s_axil_rresp,
      s_axil_rvalid => s_axil_rvalid,
      s_axil_rready => s_axil_rready,
      irq => irq,
      core_reset => reset,
      core_left_pixel => left_pixel,
      core_right_pixel => right_pixel,
      core_start_of_frame => start_of_frame,
      core_valid => valid,
      core_disparity => disparity,
      core_pixel_valid => pixel_valid,
      core_disparity_valid => disparity_valid,
      core_disparity_start_of_frame => disparity_start_of_frame,
      core_disparity_end_of_line => disparity_end_of_line);

  core : entity work.stereo_core_sgm_320_32_f16
    generic map (
      width_px => 320,
      height_px => 240,
      disparities => 32,
      pixels_per_clock => 1,
      disparity_bits => 8,
      output_width_px => 289,
      latency_clocks => 73,
      flush_groups => 1926,
      gap_groups => 0)
    port map (
      clock => aclk,
      reset => reset,
      left_pixel => left_pixel,
      right_pixel => right_pixel,
      start_of_frame => start_of_frame,
      valid => valid,
      disparity => disparity,
      pixel_valid => pixel_valid,
      disparity_valid => disparity_valid,
      disparity_start_of_frame => disparity_start_of_frame,
      disparity_end_of_line => disparity_end_of_line);
end architecture;
