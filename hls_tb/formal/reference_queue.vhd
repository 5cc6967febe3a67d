-- SPDX-License-Identifier: Apache-2.0
-- The simplest queue there is: a word comes in at the next free place, all move down when one leaves. `capacity` words of
-- `width` bits. The proofs compare buffers with it.
library ieee;
use ieee.std_logic_1164.all;

entity reference_queue is
  generic (
    capacity : positive;
    width : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    push : in std_logic;
    push_data : in std_logic_vector(width - 1 downto 0);
    pop : in std_logic;
    oldest : out std_logic_vector(width - 1 downto 0);
    count : out natural range 0 to capacity
  );
end entity;

architecture model of reference_queue is
  type words is array (0 to capacity) of std_logic_vector(width - 1 downto 0);
  signal queue : words := (others => (others => '0'));
  signal used : natural range 0 to capacity := 0;
begin
  oldest <= queue(0);
  count <= used;

  process (clock)
    variable next_queue : words;
    variable next_used : integer range -1 to capacity + 1;
  begin
    if rising_edge(clock) then
      next_queue := queue;
      next_used := used;
      if pop = '1' and used > 0 then
        next_queue(0 to capacity - 1) := queue(1 to capacity);
        next_used := next_used - 1;
      end if;
      if push = '1' and next_used < capacity then
        for place in 0 to capacity - 1 loop
          if place = next_used then
            next_queue(place) := push_data;
          end if;
        end loop;
        next_used := next_used + 1;
      end if;
      queue <= next_queue;
      used <= next_used;
      if reset = '1' then
        used <= 0;
      end if;
    end if;
  end process;
end architecture;
