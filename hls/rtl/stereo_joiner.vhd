-- SPDX-License-Identifier: Apache-2.0
-- Joins the streams of two cameras that send the same frame some lines apart into the stream of pixel pairs that a
-- stereo_ip takes (P = 1). Framing on all sides: tuser(0) with the first pixel of a frame, tlast with the last pixel of
-- each line.
--   s_*_axis   a camera does not wait: tready is always '1'
--   m_axis     tdata: the left pixel in the lower half, the right one in the upper half. From registers
--   skew_lines lines by which the right camera is behind the left one, negative when it is ahead: as they were when the
--              last joined frame began to leave
--   faults     each '1' for one clock: (0) a frame of the left camera was dropped for want of room, (1) one of the right
--              camera, (2) the frames that were being joined do not have the same lines
-- Whatever a camera loses, pixel, line or frame: that frame does not come out whole, which the stereo_ip behind notices,
-- and the next frame that both cameras send whole is joined again. Pixels of different frames are never joined, as long
-- as `depth` and the distance of the cameras are less than a frame together, and no frame is damaged on both sides: a
-- start of frame that waits for longer than `depth` pixels is dropped with its frame.
-- Size: two camera_queue.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_joiner is
  generic (
    depth : positive;  -- pixels that either camera may be ahead: lines * width, 16 or more, less than a frame
    pixel_bits : positive := 8
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_left_axis_tvalid : in std_logic;
    s_left_axis_tready : out std_logic;
    s_left_axis_tdata : in std_logic_vector(pixel_bits - 1 downto 0);
    s_left_axis_tuser : in std_logic_vector(0 downto 0);
    s_left_axis_tlast : in std_logic;
    s_right_axis_tvalid : in std_logic;
    s_right_axis_tready : out std_logic;
    s_right_axis_tdata : in std_logic_vector(pixel_bits - 1 downto 0);
    s_right_axis_tuser : in std_logic_vector(0 downto 0);
    s_right_axis_tlast : in std_logic;
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(2 * pixel_bits - 1 downto 0);
    m_axis_tuser : out std_logic_vector(0 downto 0);
    m_axis_tlast : out std_logic;
    skew_lines : out std_logic_vector(15 downto 0);
    faults : out std_logic_vector(2 downto 0)
  );
end entity;

architecture rtl of stereo_joiner is
  signal reset, joined, room, joins : std_logic := '0';
  signal left_valid, left_ready, left_start, left_end : std_logic;
  signal right_valid, right_ready, right_start, right_end : std_logic;
  signal left_pixel, right_pixel : std_logic_vector(pixel_bits - 1 downto 0);
  signal left_lines, right_lines : unsigned(14 downto 0);
  signal both, starts, alike, differs, left_drops, right_drops : std_logic;
  signal skew : signed(15 downto 0) := (others => '0');
begin
  reset <= not aresetn;
  s_left_axis_tready <= '1';
  s_right_axis_tready <= '1';

  left_queue : entity work.camera_queue
    generic map (depth => depth, pixel_bits => pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => s_left_axis_tvalid, in_start_of_frame => s_left_axis_tuser(0),
      in_end_of_line => s_left_axis_tlast, in_pixel => s_left_axis_tdata, out_valid => left_valid,
      out_ready => left_ready, out_start_of_frame => left_start, out_end_of_line => left_end,
      out_pixel => left_pixel, lines => left_lines, dropped => left_drops);

  right_queue : entity work.camera_queue
    generic map (depth => depth, pixel_bits => pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => s_right_axis_tvalid, in_start_of_frame => s_right_axis_tuser(0),
      in_end_of_line => s_right_axis_tlast, in_pixel => s_right_axis_tdata, out_valid => right_valid,
      out_ready => right_ready, out_start_of_frame => right_start, out_end_of_line => right_end,
      out_pixel => right_pixel, lines => right_lines, dropped => right_drops);

  -- A pair leaves when both queues show the same place: the start of a frame, or, in a frame that has begun, pixels that
  -- are both inside it and both or neither the last one of a line. Else both queues are emptied up to a start of frame.
  both <= left_valid and right_valid;
  starts <= left_start and right_start;
  alike <= starts when left_start = '1' or right_start = '1' else joined;
  joins <= both and alike and (left_end xnor right_end);
  differs <= both and not joins;
  left_ready <= (joins and room) or (not joined and left_valid and not left_start) or (differs and starts);
  right_ready <= (joins and room) or (not joined and right_valid and not right_start) or (differs and starts);

  pairs_out : entity work.stream_register
    generic map (flag_bits => 2, data_bits => 2 * pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => joins, in_ready => room, in_flags(0) => left_start,
      in_flags(1) => left_end, in_data => right_pixel & left_pixel, out_valid => m_axis_tvalid,
      out_ready => m_axis_tready, out_flags(0) => m_axis_tuser(0), out_flags(1) => m_axis_tlast,
      out_data => m_axis_tdata);

  skew_lines <= std_logic_vector(skew);

  process (aclk)
  begin
    if rising_edge(aclk) then
      faults <= (differs and joined) & right_drops & left_drops;
      if joins = '1' and room = '1' then
        joined <= '1';
        if starts = '1' then
          skew <= signed(resize(left_lines, 16)) - signed(resize(right_lines, 16));
        end if;
      elsif differs = '1' or left_drops = '1' or right_drops = '1' then
        joined <= '0';
      end if;
      if reset = '1' then
        joined <= '0';
        skew <= (others => '0');
        faults <= "000";
      end if;
    end if;
  end process;
end architecture;
