-- SPDX-License-Identifier: Apache-2.0
-- Joins the streams of two cameras that send the same frame some lines apart into the stream of pixel pairs that a
-- stereo_ip takes (P = 1). Framing on all sides: tuser(0) with the first pixel of a frame, tlast with the last pixel of
-- each line.
--   s_*_axis   a camera does not wait: tready is always '1'. tdata: a pixel in the lowest bits of its lane; those above it
--              do not count
--   m_axis     tdata: the left pixel's lane in the lower half, the right one's in the upper half; bits above the pixels
--              are '0'. From registers
--   skew_lines lines by which the right camera is behind the left one, negative when it is ahead: as they were when the
--              last joined frame began to leave
--   faults     each '1' for one clock: (0) a frame of the left camera was dropped for want of room, (1) one of the right
--              camera, (2) the frames that were being joined do not have the same lines
-- Whatever a camera loses, pixel, line or frame: that frame does not come out whole. A pair of zeros ends it at once, whose
-- tlast is wrong for its column: from it the stereo_ip behind knows that it must fill the frame up, and has done so when
-- the next one comes. If it learned that from the next start of frame only, the queues would overflow meanwhile, and the
-- next frame would be lost, too. But where one camera has begun the next frame and the other has not, the end waits for
-- the other's start, too: behind a frame that has ended the stereo_ip flushes, which nothing stops, and would be late for
-- the next one. The next frame that both cameras send whole is joined again.
-- Pixels of different frames are never joined, as long as `depth` and the distance of the cameras are less than a frame
-- together, and no frame is damaged on both sides: a start of frame that waits for longer than `depth` pixels is dropped
-- with its frame.
-- Size: two camera_queue, and the place of the next pair.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity stereo_joiner is
  generic (
    width_px : positive;  -- 2 or more
    height_px : positive;
    depth : positive;  -- pixels that either camera may be ahead: lines * width, 16 or more, less than a frame
    -- of a grey value, and of its lane in tdata: 8 and 8, or more and 16
    pixel_bits : positive := 8;
    lane_bits : positive := 8
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_left_axis_tvalid : in std_logic;
    s_left_axis_tready : out std_logic;
    s_left_axis_tdata : in std_logic_vector(lane_bits - 1 downto 0);
    s_left_axis_tuser : in std_logic_vector(0 downto 0);
    s_left_axis_tlast : in std_logic;
    s_right_axis_tvalid : in std_logic;
    s_right_axis_tready : out std_logic;
    s_right_axis_tdata : in std_logic_vector(lane_bits - 1 downto 0);
    s_right_axis_tuser : in std_logic_vector(0 downto 0);
    s_right_axis_tlast : in std_logic;
    m_axis_tvalid : out std_logic;
    m_axis_tready : in std_logic;
    m_axis_tdata : out std_logic_vector(2 * lane_bits - 1 downto 0);
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
  signal both, starts, alike, differs, ahead, left_drops, right_drops : std_logic;
  -- As it was in the last clock, and whether a joined frame began to leave in it: who reads it may be far away.
  signal distance : signed(15 downto 0);
  signal began : std_logic := '0';
  signal skew : signed(15 downto 0) := (others => '0');
  -- the frame that is being joined
  signal column : natural range 0 to width_px - 1 := 0;  -- of the next pair, and its row
  signal row : natural range 0 to height_px - 1 := 0;
  signal incomplete : std_logic := '0';
  signal breaks : std_logic := '0';  -- the pair that ends it as a broken one is to leave
  signal same, cuts, lost, pair_valid, pair_start, pair_end : std_logic;
  signal pair, shown : std_logic_vector(2 * pixel_bits - 1 downto 0);
begin
  assert width_px >= 2
    report "stereo_joiner: width_px is " & integer'image(width_px) & " but must be 2 or more" severity failure;

  reset <= not aresetn;
  s_left_axis_tready <= '1';
  s_right_axis_tready <= '1';

  left_queue : entity work.camera_queue
    generic map (depth => depth, pixel_bits => pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => s_left_axis_tvalid, in_start_of_frame => s_left_axis_tuser(0),
      in_end_of_line => s_left_axis_tlast, in_pixel => s_left_axis_tdata(pixel_bits - 1 downto 0), out_valid => left_valid,
      out_ready => left_ready, out_start_of_frame => left_start, out_end_of_line => left_end,
      out_pixel => left_pixel, lines => left_lines, dropped => left_drops);

  right_queue : entity work.camera_queue
    generic map (depth => depth, pixel_bits => pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => s_right_axis_tvalid, in_start_of_frame => s_right_axis_tuser(0),
      in_end_of_line => s_right_axis_tlast, in_pixel => s_right_axis_tdata(pixel_bits - 1 downto 0), out_valid => right_valid,
      out_ready => right_ready, out_start_of_frame => right_start, out_end_of_line => right_end,
      out_pixel => right_pixel, lines => right_lines, dropped => right_drops);

  -- A pair leaves when both queues show the same place: the start of a frame, or, in a frame that has begun, pixels that
  -- are both inside it and both or neither the last one of a line. Else both queues are emptied up to a start of frame.
  both <= left_valid and right_valid;
  starts <= left_start and right_start;
  alike <= starts when left_start = '1' or right_start = '1' else joined;
  same <= both and alike and not (left_end xor right_end);
  ahead <= both and joined and incomplete and (left_start xor right_start);  -- the next frame begins on one side
  differs <= both and not same and not ahead;
  cuts <= same and starts and joined and incomplete;  -- the next frame begins on both sides
  lost <= differs or cuts or left_drops or right_drops;
  joins <= same and not cuts and not breaks;
  left_ready <= (joins and room) or ((ahead or (not joined and left_valid)) and not left_start) or (differs and starts);
  right_ready <= (joins and room) or ((ahead or (not joined and right_valid)) and not right_start) or (differs and starts);

  pair_valid <= joins or breaks;
  pair_start <= left_start and not breaks;
  pair_end <= left_end when breaks = '0' else '0' when column = width_px - 1 else '1';
  pair <= right_pixel & left_pixel when breaks = '0' else (others => '0');

  pairs_out : entity work.stream_register
    generic map (flag_bits => 2, data_bits => 2 * pixel_bits)
    port map (
      clock => aclk, reset => reset, in_valid => pair_valid, in_ready => room, in_flags(0) => pair_start,
      in_flags(1) => pair_end, in_data => pair, out_valid => m_axis_tvalid,
      out_ready => m_axis_tready, out_flags(0) => m_axis_tuser(0), out_flags(1) => m_axis_tlast,
      out_data => shown);

  m_axis_tdata <= std_logic_vector(
    resize(unsigned(shown(2 * pixel_bits - 1 downto pixel_bits)), lane_bits) &
    resize(unsigned(shown(pixel_bits - 1 downto 0)), lane_bits));

  skew_lines <= std_logic_vector(skew);

  process (aclk)
    variable at_column : natural range 0 to width_px - 1;
    variable at_row : natural range 0 to height_px - 1;
  begin
    if rising_edge(aclk) then
      distance <= signed(resize(left_lines, 16)) - signed(resize(right_lines, 16));
      began <= joins and room and starts;
      if began = '1' then
        skew <= distance;
      end if;
      faults <= ((differs or cuts) and joined) & right_drops & left_drops;
      if joins = '1' and room = '1' then
        joined <= '1';
        at_column := column;
        at_row := row;
        if starts = '1' then
          at_column := 0;
          at_row := 0;
          incomplete <= '1';
        end if;
        row <= at_row;
        if left_end = '1' then
          column <= 0;
          if at_row = height_px - 1 then
            incomplete <= '0';
          else
            row <= at_row + 1;
          end if;
        elsif at_column /= width_px - 1 then
          column <= at_column + 1;
        end if;
      elsif lost = '1' then
        joined <= '0';
        breaks <= breaks or (joined and incomplete);
      end if;
      if breaks = '1' and room = '1' then
        breaks <= '0';
      end if;
      if reset = '1' then
        joined <= '0';
        breaks <= '0';
        began <= '0';
        skew <= (others => '0');
        faults <= "000";
      end if;
    end if;
  end process;
end architecture;
