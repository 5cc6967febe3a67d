-- SPDX-License-Identifier: Apache-2.0
-- Lets a group into a core without back-pressure only when the queue behind the core has room for what may come of it.
-- A group borrows one of `words` credits. The credit comes back `latency` clocks later when no disparity came of the
-- group, else when that disparity has left the queue.
--   sends      a group is decided on; allowed in the clock after one with may_send. It enters the core one clock later.
--   result     the core shows a disparity: `latency` clocks after its group entered
--   taken      a disparity leaves the queue
--   may_send   of the next clock, and known without `sends` of this one and the one before, which comes late: so the last
--              two credits are lent only when they are there for a while
--   in_flight  from a register: groups are in the core that may still give a disparity
--   all_back   no credit is out: nothing in the core that may give a disparity, nothing in the queue
--   due        a group may give its disparity in this clock; from a register. A disparity in another clock is nobody's:
--              `latency` is not that of the core, and neither a credit nor a place in the queue waits for it
-- In stereo_axis a credit is away latency + 7 clocks when nothing waits (one to enter the core, `latency` in it, one in a
-- register, two in the queue, two to count), and with two that are not lent, latency + 9 credits give a group a clock.
-- Size: latency + 5 register bits and a counter of 0 ... words.
library ieee;
use ieee.std_logic_1164.all;

entity stream_credit is
  generic (
    words : positive;  -- 3 or more
    latency : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    sends : in std_logic;
    result : in std_logic;
    taken : in std_logic;
    may_send : out std_logic;
    in_flight : out std_logic := '0';
    all_back : out std_logic;
    due : out std_logic
  );
end entity;

architecture rtl of stream_credit is
  signal flight : std_logic_vector(0 to latency) := (others => '0');  -- flight(k): entered the core k clocks ago
  signal lent : natural range 0 to words := 0;
  signal returned : natural range 0 to 2 := 0;  -- credits that came back in the last clock
  signal unused : std_logic;
begin
  all_back <= '1' when lent = 0 else '0';
  due <= flight(latency);
  unused <= flight(latency) and not result;

  -- `sends` comes late in a clock, and only an addition follows from it.
  process (clock)
    variable change : integer range -2 to 1;
  begin
    if rising_edge(clock) then
      returned <= 0;
      if unused = '1' and taken = '1' then
        returned <= 2;
      elsif unused = '1' or taken = '1' then
        returned <= 1;
      end if;
      if returned = 2 then
        change := -2;
        if sends = '1' then
          change := -1;
        end if;
      elsif returned = 1 then
        change := -1;
        if sends = '1' then
          change := 0;
        end if;
      else
        change := 0;
        if sends = '1' then
          change := 1;
        end if;
      end if;
      lent <= lent + change;
      may_send <= '0';
      if lent < words - 2 then
        may_send <= '1';
      end if;
      flight <= sends & flight(0 to latency - 1);
      in_flight <= '0';
      if sends = '1' or flight(0 to latency - 1) /= (0 to latency - 1 => '0') then
        in_flight <= '1';
      end if;
      if reset = '1' then
        flight <= (others => '0');
        in_flight <= '0';
        lent <= 0;
        returned <= 0;
      end if;
    end if;
  end process;
end architecture;
