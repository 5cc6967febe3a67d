-- SPDX-License-Identifier: Apache-2.0
-- What stands between two AXI4-Streams and a stereo core, with back-pressure on both sides. All stream outputs come from
-- registers. The core hangs on the ports core_*: its ports of these names, and those that stereo_shell adds.
--
-- s_axis: both images, a group of P rows a beat (P = pixels_per_clock), columns 0 ... W-1 of each group of rows.
--   tdata   lanes of lane_bits, 8 or 16. Lane p: left pixel of row p of the group, 0 the upper one; lane P+p: right pixel
--   tuser   bit 0: start of frame, with the first beat of a frame
--   tlast   end of line, with the last column of each group of rows: H/P times a frame
-- m_axis: the disparity map, as wide as the configuration says, with the same framing.
--   tdata   `disparity_bits` bits for each row of the group, the upper row at the bottom; above them a byte with bit p = row
--           p's disparity has passed all checks, the other bits '0'
--   tuser   bit 0: start of frame; bit 1: frame error
--   tlast   end of line
-- Each frame that begins on m_axis ends there with all its beats. Frame error is '1' with each beat of a frame that is not
-- made of pixels of s_axis only, and with the last beat of each frame that did not come in whole. A frame whose last beat
-- has it '0' is exact.
--
--   enable           '0': s_axis waits between frames
--   soft_reset       hold until soft_reset_done: ends the frame in progress with frame error, then resets the core
--   busy             something is in the shell or on its way through the core
--   errors           pulses: bits 0 ... 3 of stereo_framing, 4: the core showed a disparity in a clock in which none of its
--                    groups can give one
--   frame_ends       a frame's last disparity left the core in the last clock; frame_ends_broken: it is not whole
--   frame_clocks     of the last frame: from the clock in which its first group enters the core to the one in which its
--                    last disparity leaves it, both counted; a clock after frame_ends
--   core_reset       two clocks after aresetn or the end of a soft reset, from a register that follows another one: it
--                    drives the whole core, and a tool that copies it has a clock for the way to the copies
--   width_wanted     with run_time_size, and height_wanted: of the images from the next start of frame on, within the limits of
--                    the core. Once the last disparity of the frame before has left it, the core is reset, and then has
--                    the new size: core_width, core_height. Until then no frame begins
-- Sizes: input buffer 4 * 2 * lane_bits * P bits; output queue (latency_clocks + 9) words of (disparity_bits + 1) * P + 3 bits.
-- Generics: those of the core.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_axis is
  generic (
    width_px : positive;
    height_px : positive;
    pixels_per_clock : positive;
    disparity_bits : positive;
    latency_clocks : positive;
    flush_groups : natural;
    gap_groups : natural;
    lane_bits : positive := 8;
    run_time_size : boolean := false;
    clocks_per_group : positive := 1  -- from one group to the next, at least
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;  -- synchronous, active low, one clock is enough
    s_axis_tvalid : in std_logic;
    s_axis_tready : out std_logic;
    s_axis_tdata : in std_logic_vector(2 * lane_bits * pixels_per_clock - 1 downto 0);
    s_axis_tuser : in std_logic_vector(0 downto 0);
    s_axis_tlast : in std_logic;
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(disparity_bits * pixels_per_clock + 7 downto 0);
    m_axis_tuser : out std_logic_vector(1 downto 0);
    m_axis_tlast : out std_logic;
    width_wanted : in std_logic_vector(15 downto 0) := (others => '0');
    height_wanted : in std_logic_vector(15 downto 0) := (others => '0');
    enable : in std_logic;
    soft_reset : in std_logic;
    soft_reset_done : out std_logic;
    busy : out std_logic;
    errors : out std_logic_vector(4 downto 0);
    frame_ends : out std_logic;
    frame_ends_broken : out std_logic;
    frame_clocks : out unsigned(31 downto 0);
    core_reset : out std_logic;
    core_width : out std_logic_vector(15 downto 0);
    core_height : out std_logic_vector(15 downto 0);
    core_left_pixel : out std_logic_vector(lane_bits * pixels_per_clock - 1 downto 0);
    core_right_pixel : out std_logic_vector(lane_bits * pixels_per_clock - 1 downto 0);
    core_start_of_frame : out std_logic;
    core_valid : out std_logic;
    core_disparity : in std_logic_vector(disparity_bits * pixels_per_clock - 1 downto 0);
    core_pixel_valid : in std_logic_vector(pixels_per_clock - 1 downto 0);
    core_disparity_valid : in std_logic;
    core_disparity_start_of_frame : in std_logic;
    core_disparity_end_of_line : in std_logic
  );
end entity;

architecture rtl of stereo_axis is
  constant pixel_bits : positive := lane_bits * pixels_per_clock;
  constant map_bits : positive := disparity_bits * pixels_per_clock;
  constant word_bits : positive := map_bits + pixels_per_clock + 3;
  constant credits : positive := latency_clocks + 9;

  signal reset, clear, restart : std_logic;
  signal halts : std_logic := '0';  -- soft_reset a clock later: its register is far from the framing
  signal halted : std_logic := '0';  -- no frame has begun in this clock
  -- the size of the images that the core takes, and whether another one is wanted, in the last clock, too
  signal width_now, height_now : std_logic_vector(15 downto 0);
  signal columns_now : natural range 0 to width_px;
  signal row_groups_now : natural range 0 to height_px / pixels_per_clock;
  signal gap_groups_now : natural range 0 to gap_groups + 1;  -- at least a bit
  signal resizes, resizing, resized, may_begin : std_logic;
  signal beat_flags : std_logic_vector(1 downto 0);  -- start of frame, end of line
  signal beat_pixels : std_logic_vector(2 * pixel_bits - 1 downto 0);
  signal beat_valid, beat_take : std_logic;
  signal has_credit, in_time, may_send, may_start, sends, starts, breaks, at_rest, in_flight, all_back, due : std_logic;
  signal stream_errors : std_logic_vector(3 downto 0);
  signal group_valid, group_start : std_logic;
  signal group_pixels : std_logic_vector(2 * pixel_bits - 1 downto 0);
  signal core_in_reset : std_logic_vector(1 to 2);  -- so many clocks after the shell
  signal result, stray : std_logic;
  signal queues : std_logic := '0';  -- `queued` is a result: a clock later, for whether its frame is whole comes late
  signal queued : std_logic_vector(word_bits - 1 downto 0);
  signal frame_error, ends, entering, leaving, start_slot : std_logic;
  signal word : std_logic_vector(word_bits - 1 downto 0);
  signal word_valid : std_logic;
  signal taken : std_logic := '0';  -- a clock later: the queue's end and the credits are far from each other
begin
  reset <= not aresetn;
  clear <= reset or restart;
  -- When nothing is left in the core that could come out of it.
  restart <= soft_reset and halted and at_rest and not in_flight;
  soft_reset_done <= restart;

  -- As for `restart`: no frame has begun in this clock.
  resized <= resizes and resizing and at_rest and not in_flight;
  may_begin <= enable and not resizes;
  core_width <= width_now;
  core_height <= height_now;

  one_size : if not run_time_size generate
    width_now <= std_logic_vector(to_unsigned(width_px, 16));
    height_now <= std_logic_vector(to_unsigned(height_px, 16));
    columns_now <= width_px;
    row_groups_now <= height_px / pixels_per_clock;
    gap_groups_now <= gap_groups;
    resizes <= '0';
    resizing <= '0';
  end generate;

  sizes : if run_time_size generate
    resizes <= '1' when width_wanted /= width_now or height_wanted /= height_now else '0';
    process (aclk)
    begin
      if rising_edge(aclk) then
        resizing <= resizes;
        if resized = '1' then
          width_now <= width_wanted;
          height_now <= height_wanted;
          columns_now <= to_integer(unsigned(width_wanted));
          row_groups_now <= to_integer(unsigned(height_wanted)) / pixels_per_clock;
        end if;
        gap_groups_now <= gap_groups / width_px * columns_now;
        if reset = '1' then
          width_now <= std_logic_vector(to_unsigned(width_px, 16));
          height_now <= std_logic_vector(to_unsigned(height_px, 16));
          columns_now <= width_px;
          row_groups_now <= height_px / pixels_per_clock;
          gap_groups_now <= gap_groups;
          resizing <= '0';
        end if;
      end if;
    end process;
  end generate;

  input_register : entity work.stream_register
    generic map (flag_bits => 2, data_bits => 2 * pixel_bits)
    port map (
      clock => aclk, reset => reset,
      in_valid => s_axis_tvalid, in_ready => s_axis_tready, in_flags(1) => s_axis_tuser(0), in_flags(0) => s_axis_tlast,
      in_data => s_axis_tdata,
      out_valid => beat_valid, out_ready => beat_take, out_flags => beat_flags, out_data => beat_pixels);

  may_send <= has_credit and in_time;

  each_clock : if clocks_per_group = 1 generate
    in_time <= '1';
  end generate;

  -- in_time: a group may be sent in the next clock, as far as the one before it is concerned.
  paced : if clocks_per_group > 1 generate
    signal clocks_left : natural range 0 to clocks_per_group - 2 := 0;
  begin
    in_time <= '1' when clocks_left = 0 and sends = '0' else '0';
    process (aclk)
    begin
      if rising_edge(aclk) then
        if sends = '1' then
          clocks_left <= clocks_per_group - 2;
        elsif clocks_left /= 0 then
          clocks_left <= clocks_left - 1;
        end if;
        if clear = '1' then
          clocks_left <= clocks_per_group - 2;
        end if;
      end if;
    end process;
  end generate;

  framing : entity work.stereo_framing
    generic map (
      columns => width_px, row_groups => height_px / pixels_per_clock,
      flush_groups => flush_groups, gap_groups => gap_groups, data_bits => 2 * pixel_bits)
    port map (
      clock => aclk, reset => reset, columns_now => columns_now, row_groups_now => row_groups_now,
      gap_groups_now => gap_groups_now, enable => may_begin, halt => halts, at_rest => at_rest,
      in_valid => beat_valid, in_start => beat_flags(1), in_last => beat_flags(0),
      in_data => beat_pixels, in_take => beat_take,
      may_send => may_send, may_start => may_start, sends => sends, starts => starts, breaks => breaks,
      error => stream_errors,
      out_valid => group_valid, out_start => group_start, out_data => group_pixels);

  core_reset <= core_in_reset(2);
  core_left_pixel <= group_pixels(pixel_bits - 1 downto 0);
  core_right_pixel <= group_pixels(2 * pixel_bits - 1 downto pixel_bits);
  core_start_of_frame <= group_start;
  core_valid <= group_valid;

  -- What has no credit has no place in the queue either. Nothing is due while the core is reset, so what it shows of the
  -- time before counts nowhere.
  result <= core_disparity_valid and due;
  stray <= core_disparity_valid and not due and not core_in_reset(1) and not core_in_reset(2);

  frames : entity work.stereo_frames
    generic map (row_groups => height_px / pixels_per_clock)
    port map (
      clock => aclk, reset => clear, row_groups_now => row_groups_now,
      starts => starts, breaks => breaks, may_start => may_start,
      result_valid => result, result_start => core_disparity_start_of_frame, result_last => core_disparity_end_of_line,
      frame_error => frame_error, ends => ends, entering => entering, leaving => leaving);

  start_slot <= not entering;
  timer : entity work.frame_timer
    port map (
      clock => aclk, reset => clear, starts => starts, start_slot => start_slot, ends => ends, end_slot => leaving,
      clocks => frame_clocks);

  queue : entity work.stream_fifo
    generic map (depth => credits, width => word_bits)
    port map (
      clock => aclk, reset => reset, in_valid => queues, in_data => queued,
      out_valid => word_valid, out_ready => m_axis_tready, out_data => word);

  credit : entity work.stream_credit
    generic map (words => credits, latency => latency_clocks)
    port map (
      clock => aclk, reset => reset, sends => sends, result => result, taken => taken,
      may_send => has_credit, in_flight => in_flight, all_back => all_back, due => due);

  m_axis_tvalid <= word_valid;
  m_axis_tdata(map_bits - 1 downto 0) <= word(map_bits - 1 downto 0);
  m_axis_tdata(map_bits + 7 downto map_bits) <=
    std_logic_vector(resize(unsigned(word(map_bits + pixels_per_clock - 1 downto map_bits)), 8));
  m_axis_tlast <= word(word_bits - 3);
  m_axis_tuser <= word(word_bits - 1 downto word_bits - 2);

  busy <= beat_valid or not at_rest or not all_back;
  errors <= stray & stream_errors;

  process (aclk)
  begin
    if rising_edge(aclk) then
      halts <= soft_reset;
      halted <= soft_reset and halts;
      queues <= result and not reset;
      queued <=
        frame_error & core_disparity_start_of_frame & core_disparity_end_of_line & core_pixel_valid & core_disparity;
      taken <= word_valid and m_axis_tready and not reset;
      core_in_reset <= (clear or resized) & core_in_reset(1);
      frame_ends <= ends and not clear;
      frame_ends_broken <= ends and frame_error and not clear;
    end if;
  end process;
end architecture;
