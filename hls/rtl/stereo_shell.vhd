-- SPDX-License-Identifier: Apache-2.0
-- All of a stereo_ip but its core: AXI4-Stream in and out (stereo_axis) and registers on AXI4-Lite (stereo_registers). Each
-- configuration has a stereo_ip_NAME in generated_rtl/, which puts this around its stereo_core_NAME and fills in the
-- generics. docs/integration.md says how to use it.
-- Without a processor tie the AXI4-Lite inputs to '0' and leave enabled_at_reset.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.stereo_register_map.all;

entity stereo_shell is
  generic (
    width_px : positive;  -- W, 8 ... 4096
    height_px : positive;  -- H
    disparities : positive;  -- D
    pixels_per_clock : positive;  -- P, 1, 2 or 4
    disparity_bits : positive;  -- 8 or 16
    output_width_px : positive;
    latency_clocks : positive;
    flush_groups : natural;
    gap_groups : natural;
    core_id : std_logic_vector(31 downto 0);  -- the first digits of the digest of the core's VHDL in manifest.json
    enabled_at_reset : boolean := true;
    -- of a core with run-time settings, in the order of their registers: the largest value of each, 0 where there is none,
    -- and the value after a reset
    settings_largest : setting_values := (others => 0);
    settings_start : setting_values := (others => 0);
    settings_least : setting_values := (others => 0);  -- the smallest value
    -- of a grey value, and of its lane in s_axis_tdata: 8 and 8, or more and 16; further bits of a lane do not count
    pixel_bits : positive := 8;
    lane_bits : positive := 8;
    clocks_per_group : positive := 1  -- F: the core takes a group in so many clocks
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;  -- synchronous, active low, one clock is enough
    -- image pairs
    s_axis_tvalid : in std_logic;
    s_axis_tready : out std_logic;
    s_axis_tdata : in std_logic_vector(2 * lane_bits * pixels_per_clock - 1 downto 0);
    s_axis_tuser : in std_logic_vector(0 downto 0);
    s_axis_tlast : in std_logic;
    -- disparity maps
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(disparity_bits * pixels_per_clock + 7 downto 0);
    m_axis_tuser : out std_logic_vector(1 downto 0);
    m_axis_tlast : out std_logic;
    -- registers
    s_axil_awaddr : in std_logic_vector(address_bits - 1 downto 0);
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
    s_axil_araddr : in std_logic_vector(address_bits - 1 downto 0);
    s_axil_arprot : in std_logic_vector(2 downto 0);
    s_axil_arvalid : in std_logic;
    s_axil_arready : out std_logic;
    s_axil_rdata : out std_logic_vector(31 downto 0);
    s_axil_rresp : out std_logic_vector(1 downto 0);
    s_axil_rvalid : out std_logic;
    s_axil_rready : in std_logic;
    irq : out std_logic;  -- a level: register `interrupt`
    -- the core
    core_reset : out std_logic;
    core_left_pixel : out std_logic_vector(pixel_bits * pixels_per_clock - 1 downto 0);
    core_right_pixel : out std_logic_vector(pixel_bits * pixels_per_clock - 1 downto 0);
    core_start_of_frame : out std_logic;
    core_valid : out std_logic;
    core_settings : out setting_words;
    core_disparity : in std_logic_vector(disparity_bits * pixels_per_clock - 1 downto 0);
    core_pixel_valid : in std_logic_vector(pixels_per_clock - 1 downto 0);
    core_disparity_valid : in std_logic;
    core_disparity_start_of_frame : in std_logic;
    core_disparity_end_of_line : in std_logic
  );
end entity;

architecture rtl of stereo_shell is
  constant width_setting : natural := image_width_word - first_setting_word;
  constant height_setting : natural := image_height_word - first_setting_word;
  signal settings : setting_words;  -- as they are written; the core has the size of the frame that is in it
  signal core_width, core_height : std_logic_vector(15 downto 0);
  signal enable, soft_reset, soft_reset_done, busy, frame_ends, frame_ends_broken : std_logic;
  signal errors : std_logic_vector(4 downto 0);
  signal frame_clocks : unsigned(31 downto 0);
  signal left_lanes, right_lanes : std_logic_vector(lane_bits * pixels_per_clock - 1 downto 0);
begin
  axis : entity work.stereo_axis
    generic map (
      width_px => width_px, height_px => height_px, pixels_per_clock => pixels_per_clock, disparity_bits => disparity_bits,
      latency_clocks => latency_clocks, flush_groups => flush_groups, gap_groups => gap_groups,
      lane_bits => lane_bits, run_time_size => settings_largest(width_setting) > 0, clocks_per_group => clocks_per_group)
    port map (
      aclk => aclk, aresetn => aresetn,
      s_axis_tvalid => s_axis_tvalid, s_axis_tready => s_axis_tready, s_axis_tdata => s_axis_tdata,
      s_axis_tuser => s_axis_tuser, s_axis_tlast => s_axis_tlast,
      m_axis_tvalid => m_axis_tvalid, m_axis_tready => m_axis_tready, m_axis_tdata => m_axis_tdata,
      m_axis_tuser => m_axis_tuser, m_axis_tlast => m_axis_tlast,
      enable => enable, soft_reset => soft_reset, soft_reset_done => soft_reset_done, busy => busy, errors => errors,
      frame_ends => frame_ends, frame_ends_broken => frame_ends_broken, frame_clocks => frame_clocks,
      width_wanted => settings(width_setting), height_wanted => settings(height_setting),
      core_reset => core_reset, core_width => core_width, core_height => core_height,
      core_left_pixel => left_lanes, core_right_pixel => right_lanes,
      core_start_of_frame => core_start_of_frame, core_valid => core_valid,
      core_disparity => core_disparity, core_pixel_valid => core_pixel_valid, core_disparity_valid => core_disparity_valid,
      core_disparity_start_of_frame => core_disparity_start_of_frame,
      core_disparity_end_of_line => core_disparity_end_of_line);

  registers : entity work.stereo_registers
    generic map (
      width_px => width_px, height_px => height_px, disparities => disparities, pixels_per_clock => pixels_per_clock,
      output_width_px => output_width_px, disparity_bits => disparity_bits, core_id => core_id,
      enabled_at_reset => enabled_at_reset,
      settings_largest => settings_largest, settings_start => settings_start, settings_least => settings_least)
    port map (
      aclk => aclk, aresetn => aresetn,
      s_axil_awaddr => s_axil_awaddr, s_axil_awprot => s_axil_awprot, s_axil_awvalid => s_axil_awvalid,
      s_axil_awready => s_axil_awready, s_axil_wdata => s_axil_wdata, s_axil_wstrb => s_axil_wstrb,
      s_axil_wvalid => s_axil_wvalid, s_axil_wready => s_axil_wready, s_axil_bresp => s_axil_bresp,
      s_axil_bvalid => s_axil_bvalid, s_axil_bready => s_axil_bready, s_axil_araddr => s_axil_araddr,
      s_axil_arprot => s_axil_arprot, s_axil_arvalid => s_axil_arvalid, s_axil_arready => s_axil_arready,
      s_axil_rdata => s_axil_rdata, s_axil_rresp => s_axil_rresp, s_axil_rvalid => s_axil_rvalid,
      s_axil_rready => s_axil_rready,
      enable => enable, soft_reset => soft_reset, soft_reset_done => soft_reset_done, busy => busy, errors => errors,
      frame_ends => frame_ends, frame_ends_broken => frame_ends_broken, frame_clocks => frame_clocks,
      settings => settings, irq => irq);

  words : for i in core_settings'range generate
    core_settings(i) <= core_width when i = width_setting else core_height when i = height_setting else settings(i);
  end generate;

  pixels : for p in 0 to pixels_per_clock - 1 generate
    core_left_pixel(pixel_bits * (p + 1) - 1 downto pixel_bits * p) <=
      left_lanes(lane_bits * p + pixel_bits - 1 downto lane_bits * p);
    core_right_pixel(pixel_bits * (p + 1) - 1 downto pixel_bits * p) <=
      right_lanes(lane_bits * p + pixel_bits - 1 downto lane_bits * p);
  end generate;
end architecture;
