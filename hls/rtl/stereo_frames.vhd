-- SPDX-License-Identifier: Apache-2.0
-- Follows the frames through the core: at most two are in it, the older one leaving while the younger one enters.
--   starts, breaks       a frame enters; the one that entered last is not whole (see stereo_framing)
--   may_start            there is room for another frame; from a register
--   result_*             what the core shows in this clock
--   frame_error          belongs to the disparity that the core shows: its frame is known not to be whole
--   ends                 that disparity is the last of its frame
--   entering, leaving    number 0 or 1 of the frame that entered last (with `starts` still that of the one before), and of
--                        the one that the disparity belongs to
-- A break is known at least one clock before a disparity can depend on what the frame was filled up with, and before the
-- frame's last disparity.
-- Size: 6 register bits and a counter of lines.
library ieee;
use ieee.std_logic_1164.all;

entity stereo_frames is
  generic (
    row_groups : positive  -- H/P, at most
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    row_groups_now : in natural range 0 to row_groups := row_groups;  -- may change while no frame is inside
    starts : in std_logic;
    breaks : in std_logic;
    may_start : out std_logic := '1';
    result_valid : in std_logic;
    result_start : in std_logic;
    result_last : in std_logic;
    frame_error : out std_logic;
    ends : out std_logic;
    entering : out std_logic;
    leaving : out std_logic
  );
end entity;

architecture rtl of stereo_frames is
  signal broken : std_logic_vector(0 to 1) := "00";
  signal youngest, oldest : std_logic := '0';  -- numbers of the frames that entered last and that left last
  signal frames_inside : natural range 0 to 2 := 0;
  signal line_group : natural range 0 to row_groups - 1 := 0;  -- of the next disparity but for a frame's first
  signal current, frame_leaves : std_logic;
begin
  current <= oldest xor (result_valid and result_start);
  frame_leaves <= result_valid and result_last when line_group = row_groups_now - 1 else '0';
  frame_error <= broken(0) when current = '0' else broken(1);
  ends <= frame_leaves;
  entering <= youngest;
  leaving <= current;

  process (clock)
    variable number : std_logic;
  begin
    if rising_edge(clock) then
      number := youngest xor starts;
      youngest <= number;
      if starts = '1' or breaks = '1' then
        if number = '0' then
          broken(0) <= breaks;
        else
          broken(1) <= breaks;
        end if;
      end if;

      oldest <= current;
      if result_valid = '1' and result_last = '1' then
        if frame_leaves = '1' then
          line_group <= 0;
        else
          line_group <= line_group + 1;
        end if;
      end if;

      if starts = '1' and frame_leaves = '0' then
        frames_inside <= frames_inside + 1;
        may_start <= '0';
        if frames_inside = 0 then
          may_start <= '1';
        end if;
      elsif starts = '0' and frame_leaves = '1' then
        frames_inside <= frames_inside - 1;
        may_start <= '1';
      end if;

      if reset = '1' then
        broken <= "00";
        youngest <= '0';
        oldest <= '0';
        frames_inside <= 0;
        may_start <= '1';
        line_group <= 0;
      end if;
    end if;
  end process;
end architecture;
