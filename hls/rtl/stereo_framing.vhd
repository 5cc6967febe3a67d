-- SPDX-License-Identifier: Apache-2.0
-- Makes whole frames of whatever comes in: the core sees W*H/P groups from each start of frame on, nothing else but flush
-- groups after them, and never two starts too close together.
--   in_*         valid/take stream of groups: start of frame, end of line, pixels. in_take depends on in_valid.
--   out_*        to the core, from registers
--   may_send     a group may be sent in the next clock; sends: one is in this clock (it stands at out_* in the next one)
--   may_start    a frame may begin from the next clock on, as far as the frames before it are concerned. It falls only
--                in the clock after `starts`
--   enable       '0': no frame begins from the next clock on; one that has begun goes on
--   halt         from the next clock on: ends the frame in progress as a broken one, and none begins
--   at_rest      no frame is in progress, and the last one has all its flush groups
--   starts       a frame begins in this clock
--   breaks       the frame in progress (or the one that begins) turns out not to be whole
--   error        pulses: bit 0 early end of line, 1 late end of line, 2 start of frame within a frame,
--                3 group outside a frame
-- A frame that breaks is filled up with the last group that came. What the stream still brings of it is dropped, up to
-- the next start of frame, which waits until the filling is done.
-- columns_now, row_groups_now, gap_groups_now: of a frame, up to the generics; columns and groups of rows from 2 on. They may
-- change while there is no frame in progress, a clock or more before one begins.
-- After a frame come flush_groups groups of anything, unless the next frame stands ready when gap_groups of them are sent.
library ieee;
use ieee.std_logic_1164.all;

entity stereo_framing is
  generic (
    columns : positive;  -- W, at most
    row_groups : positive;  -- H/P, at most
    flush_groups : natural;
    gap_groups : natural;
    data_bits : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    columns_now : in natural range 0 to columns := columns;
    row_groups_now : in natural range 0 to row_groups := row_groups;
    gap_groups_now : in natural range 0 to gap_groups + 1 := gap_groups;  -- at least a bit
    enable : in std_logic;
    halt : in std_logic;
    at_rest : out std_logic;
    in_valid : in std_logic;
    in_start : in std_logic;
    in_last : in std_logic;
    in_data : in std_logic_vector(data_bits - 1 downto 0);
    in_take : out std_logic;
    may_send : in std_logic;
    may_start : in std_logic;
    sends : out std_logic;
    starts : out std_logic;
    breaks : out std_logic;
    error : out std_logic_vector(3 downto 0);
    out_valid : out std_logic := '0';
    out_start : out std_logic := '0';
    out_data : out std_logic_vector(data_bits - 1 downto 0)
  );
end entity;

architecture rtl of stereo_framing is
  function larger(a, b : natural) return natural is
  begin
    if a > b then
      return a;
    end if;
    return b;
  end function;

  constant all_flush_groups : natural := larger(flush_groups, gap_groups);

  type phases is (idle, inside, filling, flushing);
  signal phase : phases := idle;
  signal column : natural range 0 to columns - 1 := 0;  -- of the next group of the frame
  signal row_group : natural range 0 to row_groups - 1 := 0;
  -- Decoded a clock ahead, for what decides in a clock whether a group is sent.
  signal line_ends : std_logic := '0';  -- column = columns_now - 1
  signal last_line : std_logic := '0';  -- row_group = row_groups_now - 1
  signal between : std_logic := '1';  -- idle, or flushing with just gap_groups flush groups sent
  signal takes_start : std_logic := '0';  -- that, enabled, and the frames before leave room: a frame may begin
  signal takes_group : std_logic := '0';  -- inside, and not halting: a group without a start may be sent
  signal takes_other : std_logic := '1';  -- that, or outside, where such a group is dropped
  signal may_fill : std_logic := '0';  -- filling or flushing, and a group may be sent
  signal guards : std_logic := '0';  -- inside, and not halting
  signal halting : std_logic := '0';
  signal flushed : natural range 0 to all_flush_groups := 0;  -- flush groups sent since the frame
  signal lost : std_logic := '0';  -- since the last break no start of frame has come

  signal begins, fills, brings, drops : std_logic;
  signal frame_ends, early_end, late_end, early_start, broken : std_logic;
begin
  begins <= in_valid and in_start and takes_start;
  brings <= in_valid and takes_start when in_start = '1' else in_valid and takes_group;
  fills <= may_fill and not begins;
  drops <= in_valid and not in_start when phase /= inside else '0';

  frame_ends <= line_ends and last_line;
  early_end <= brings and in_last and not line_ends;
  late_end <= brings and line_ends and not in_last;
  early_start <= in_valid and in_start and guards;
  broken <= early_end or late_end or early_start or halting when phase = inside else early_end or late_end;

  in_take <= in_valid and takes_start when in_start = '1' else in_valid and takes_other;
  sends <= brings or fills;
  starts <= begins;
  breaks <= broken;
  error <= (drops and not lost) & early_start & late_end & early_end;
  at_rest <= '1' when phase = idle else '0';

  process (clock)
    variable in_frame : std_logic;  -- the group that is sent belongs to a frame
    variable next_phase : phases;
    variable next_between, next_guards : std_logic;
  begin
    if rising_edge(clock) then
      out_valid <= brings or fills;
      out_start <= begins;
      -- What fills up and flushes is the last group that came, not what an idle input shows, which may be neither 0 nor 1.
      if in_valid = '1' then
        out_data <= in_data;
      end if;

      in_frame := brings;
      if phase = filling then
        in_frame := fills;
      end if;
      if in_frame = '1' then
        line_ends <= '0';
        if column = columns_now - 2 then
          line_ends <= '1';
        end if;
        if line_ends = '0' then
          column <= column + 1;
        else
          column <= 0;
          last_line <= '0';
          if row_groups = 1 or row_group = row_groups_now - 2 then
            last_line <= '1';
          end if;
          if last_line = '0' then
            row_group <= row_group + 1;
          else
            row_group <= 0;
          end if;
        end if;
      end if;

      next_phase := phase;
      next_between := between;
      if in_frame = '1' and frame_ends = '1' then
        next_phase := idle;
        if all_flush_groups > 0 then
          next_phase := flushing;
        end if;
        next_between := '0';
        if gap_groups = 0 then
          next_between := '1';
        end if;
      elsif broken = '1' then
        next_phase := filling;
        next_between := '0';
      elsif begins = '1' then
        next_phase := inside;
        next_between := '0';
      elsif phase = flushing and fills = '1' then
        next_between := '0';
        if flushed = gap_groups_now - 1 then
          next_between := '1';
        end if;
        if flushed = all_flush_groups - 1 then
          next_phase := idle;
          next_between := '1';
        end if;
      end if;
      phase <= next_phase;
      between <= next_between;
      next_guards := '0';
      if next_phase = inside then
        next_guards := not halt;
      end if;
      takes_start <= next_between and enable and may_start and may_send and not begins and not halt;
      takes_group <= next_guards and may_send;
      takes_other <= '1';
      if next_phase = inside then
        takes_other <= next_guards and may_send;
      end if;
      may_fill <= '0';
      if next_phase = filling or next_phase = flushing then
        may_fill <= may_send;
      end if;
      guards <= next_guards;
      halting <= halt;

      if phase /= flushing then
        flushed <= 0;
      elsif may_fill = '1' and flushed /= all_flush_groups then
        flushed <= flushed + 1;
      end if;

      lost <= broken or (lost and not begins);

      if reset = '1' then
        phase <= idle;
        column <= 0;
        row_group <= 0;
        line_ends <= '0';
        last_line <= '0';
        if row_groups = 1 then
          last_line <= '1';
        end if;
        between <= '1';
        takes_start <= '0';
        takes_group <= '0';
        takes_other <= '1';
        may_fill <= '0';
        guards <= '0';
        halting <= '0';
        flushed <= 0;
        lost <= '0';
        out_valid <= '0';
        out_start <= '0';
      end if;
    end if;
  end process;
end architecture;
