-- SPDX-License-Identifier: Apache-2.0
-- Two cameras to depths: rectify_vga, sgm_640_64_f8_dense. Do not edit; made by
--   scripts/camera_system.py --system vga_sgm_f8_dense --write
-- examples/camera_system/README.md says what the ports are.
library ieee;
use ieee.std_logic_1164.all;

entity camera_system_vga_sgm_f8_dense is
  generic (enabled_at_reset : boolean := true);  -- false: waits for a processor
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_left_axis_tvalid : in std_logic;
    s_left_axis_tready : out std_logic;
    s_left_axis_tdata : in std_logic_vector(7 downto 0);
    s_left_axis_tuser : in std_logic_vector(0 downto 0);
    s_left_axis_tlast : in std_logic;
    s_right_axis_tvalid : in std_logic;
    s_right_axis_tready : out std_logic;
    s_right_axis_tdata : in std_logic_vector(7 downto 0);
    s_right_axis_tuser : in std_logic_vector(0 downto 0);
    s_right_axis_tlast : in std_logic;
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(39 downto 0);
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
    s_tables_axil_awaddr : in std_logic_vector(4 downto 0);
    s_tables_axil_awvalid : in std_logic;
    s_tables_axil_awready : out std_logic;
    s_tables_axil_wdata : in std_logic_vector(31 downto 0);
    s_tables_axil_wvalid : in std_logic;
    s_tables_axil_wready : out std_logic;
    s_tables_axil_bresp : out std_logic_vector(1 downto 0);
    s_tables_axil_bvalid : out std_logic;
    s_tables_axil_bready : in std_logic;
    s_tables_axil_araddr : in std_logic_vector(4 downto 0);
    s_tables_axil_arvalid : in std_logic;
    s_tables_axil_arready : out std_logic;
    s_tables_axil_rdata : out std_logic_vector(31 downto 0);
    s_tables_axil_rresp : out std_logic_vector(1 downto 0);
    s_tables_axil_rvalid : out std_logic;
    s_tables_axil_rready : in std_logic
  );
end entity;

architecture rtl of camera_system_vga_sgm_f8_dense is
  signal reset, core_reset, pair_tvalid, pair_tready, pair_tlast : std_logic;
  signal pair_tdata, node_column, node_row, node_x, node_y : std_logic_vector(15 downto 0);
  signal skew_lines, write_disparity, write_mm, depth_mm : std_logic_vector(15 downto 0);
  signal pair_tuser, pixel_valid, depth_known : std_logic_vector(0 downto 0);
  signal faults : std_logic_vector(2 downto 0);
  signal left_pixel, right_pixel, rectified_left, rectified_right : std_logic_vector(7 downto 0);
  signal start_of_frame, valid, node_valid, node_right, rectified_start_of_frame, rectified_valid : std_logic;
  signal disparity_valid, disparity_start_of_frame, disparity_end_of_line : std_logic;
  signal depth_valid, depth_start_of_frame, depth_end_of_line : std_logic;
  signal disparity : std_logic_vector(23 downto 0);
  signal has_depth, measured : std_logic_vector(0 downto 0);
  signal marks, depth_marks : std_logic_vector(8 downto 0);
  signal image_pixel : std_logic_vector(7 downto 0);
  signal word : std_logic_vector(32 downto 0);
  signal word_tdata : std_logic_vector(40 downto 0);
begin
  -- A soft reset leaves the tables as they are.
  process (aclk)
  begin
    if rising_edge(aclk) then
      reset <= not aresetn;
    end if;
  end process;

  joiner : entity work.stereo_joiner
    generic map (
      width_px => 640,
      height_px => 480,
      depth => 3840)
    port map (
      aclk => aclk,
      aresetn => aresetn,
      s_left_axis_tvalid => s_left_axis_tvalid,
      s_left_axis_tready => s_left_axis_tready,
      s_left_axis_tdata => s_left_axis_tdata,
      s_left_axis_tuser => s_left_axis_tuser,
      s_left_axis_tlast => s_left_axis_tlast,
      s_right_axis_tvalid => s_right_axis_tvalid,
      s_right_axis_tready => s_right_axis_tready,
      s_right_axis_tdata => s_right_axis_tdata,
      s_right_axis_tuser => s_right_axis_tuser,
      s_right_axis_tlast => s_right_axis_tlast,
      m_axis_tvalid => pair_tvalid,
      m_axis_tready => pair_tready,
      m_axis_tdata => pair_tdata,
      m_axis_tuser => pair_tuser,
      m_axis_tlast => pair_tlast,
      skew_lines => skew_lines,
      faults => faults);

  shell : entity work.stereo_shell
    generic map (
      width_px => 640,
      height_px => 480,
      disparities => 64,
      pixels_per_clock => 1,
      disparity_bits => 33,
      output_width_px => 638,
      latency_clocks => 123,
      flush_groups => 16714,
      gap_groups => 0,
      core_id => x"18d7ad3c",
      enabled_at_reset => enabled_at_reset,
      clocks_per_group => 8)
    port map (
      aclk => aclk,
      aresetn => aresetn,
      s_axis_tvalid => pair_tvalid,
      s_axis_tready => pair_tready,
      s_axis_tdata => pair_tdata,
      s_axis_tuser => pair_tuser,
      s_axis_tlast => pair_tlast,
      m_axis_tvalid => m_axis_tvalid,
      m_axis_tready => m_axis_tready,
      m_axis_tdata => word_tdata,
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
      core_left_pixel => left_pixel,
      core_right_pixel => right_pixel,
      core_start_of_frame => start_of_frame,
      core_valid => valid,
      core_reset => core_reset,
      core_disparity => word,
      core_pixel_valid => measured,
      core_disparity_valid => depth_valid,
      core_disparity_start_of_frame => depth_start_of_frame,
      core_disparity_end_of_line => depth_end_of_line);

  tables : entity work.camera_tables
    generic map (
      table_columns => 41,
      table_rows => 31,
      depth_entries => 1024,
      subpixel => true)
    port map (
      aclk => aclk,
      aresetn => aresetn,
      s_axil_awaddr => s_tables_axil_awaddr,
      s_axil_awvalid => s_tables_axil_awvalid,
      s_axil_awready => s_tables_axil_awready,
      s_axil_wdata => s_tables_axil_wdata,
      s_axil_wvalid => s_tables_axil_wvalid,
      s_axil_wready => s_tables_axil_wready,
      s_axil_bresp => s_tables_axil_bresp,
      s_axil_bvalid => s_tables_axil_bvalid,
      s_axil_bready => s_tables_axil_bready,
      s_axil_araddr => s_tables_axil_araddr,
      s_axil_arvalid => s_tables_axil_arvalid,
      s_axil_arready => s_tables_axil_arready,
      s_axil_rdata => s_tables_axil_rdata,
      s_axil_rresp => s_tables_axil_rresp,
      s_axil_rvalid => s_tables_axil_rvalid,
      s_axil_rready => s_tables_axil_rready,
      skew_lines => skew_lines,
      faults => faults,
      node_valid => node_valid,
      node_right => node_right,
      node_column => node_column,
      node_row => node_row,
      node_x => node_x,
      node_y => node_y,
      depth_disparity => write_disparity,
      depth_mm => write_mm);

  rectification : entity work.stereo_rectify_vga
    generic map (
      width_px => 640,
      height_px => 480,
      pixels_per_clock => 1,
      table_columns => 41,
      table_rows => 31,
      latency_clocks => 24,
      flush_groups => 10880)
    port map (
      clock => aclk,
      reset => reset,
      left_pixel => left_pixel,
      right_pixel => right_pixel,
      start_of_frame => start_of_frame,
      valid => valid,
      node_valid => node_valid,
      node_right => node_right,
      node_column => node_column,
      node_row => node_row,
      node_x => node_x,
      node_y => node_y,
      rectified_left => rectified_left,
      rectified_right => rectified_right,
      rectified_start_of_frame => rectified_start_of_frame,
      rectified_valid => rectified_valid);

  core : entity work.stereo_core_sgm_640_64_f8_dense
    generic map (
      width_px => 640,
      height_px => 480,
      disparities => 64,
      pixels_per_clock => 1,
      disparity_bits => 24,
      output_width_px => 638,
      latency_clocks => 97,
      flush_groups => 5834,
      gap_groups => 0)
    port map (
      clock => aclk,
      reset => core_reset,
      left_pixel => rectified_left,
      right_pixel => rectified_right,
      start_of_frame => rectified_start_of_frame,
      valid => rectified_valid,
      disparity => disparity,
      pixel_valid => pixel_valid,
      disparity_valid => disparity_valid,
      disparity_start_of_frame => disparity_start_of_frame,
      disparity_end_of_line => disparity_end_of_line);

  depth : entity work.camera_depth
    generic map (
      place_bits => 10,
      disparity_bits => 24)
    port map (
      clock => aclk,
      reset => core_reset,
      write_disparity => write_disparity,
      write_mm => write_mm,
      disparity => disparity,
      pixel_valid => has_depth,
      disparity_valid => disparity_valid,
      disparity_start_of_frame => disparity_start_of_frame,
      disparity_end_of_line => disparity_end_of_line,
      depth_mm => depth_mm,
      depth_known => depth_known,
      depth_valid => depth_valid,
      depth_start_of_frame => depth_start_of_frame,
      depth_end_of_line => depth_end_of_line);

  image : entity work.camera_image
    generic map (
      width_px => 640,
      output_width_px => 638,
      first_column => 1,
      kept => 5848,
      address_bits => 13,
      pixel_bits => 8)
    port map (
      clock => aclk,
      rectified_pixel => rectified_left,
      rectified_start_of_frame => rectified_start_of_frame,
      rectified_valid => rectified_valid,
      disparity_valid => disparity_valid,
      disparity_start_of_frame => disparity_start_of_frame,
      disparity_end_of_line => disparity_end_of_line,
      image_pixel => image_pixel);

  -- As late as camera_depth is.
  process (aclk)
  begin
    if rising_edge(aclk) then
      marks <= disparity(23 downto 15);
      depth_marks <= marks;
    end if;
  end process;
  has_depth(0) <= pixel_valid(0) or disparity(15);
  measured(0) <= depth_known(0) and not depth_marks(0);
  word <= image_pixel & depth_marks & depth_mm;
  m_axis_tdata(15 downto 0) <= word_tdata(15 downto 0);
  m_axis_tdata(16 downto 16) <= word_tdata(33 downto 33);
  m_axis_tdata(17 downto 17) <= word_tdata(16 downto 16);
  m_axis_tdata(23 downto 18) <= (others => '0');
  m_axis_tdata(31 downto 24) <= word_tdata(24 downto 17);
  m_axis_tdata(39 downto 32) <= word_tdata(32 downto 25);
end architecture;
