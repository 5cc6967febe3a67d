-- SPDX-License-Identifier: Apache-2.0
-- To be proved: `bad` is '0' for ever. In front of a core that answers each group after `latency` clocks or not at all,
-- whichever it likes, and a queue whose reader takes words when it likes, stream_credit never lets the queue get more words
-- than it has room for, never calls a result not due, lets a group in whenever three words were free three clocks ago, and
-- knows a clock later that all credits are back.
library ieee;
use ieee.std_logic_1164.all;

entity prove_stream_credit is
  generic (
    words : positive := 4;
    latency : positive := 2
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    wants_in : in std_logic;
    answers : in std_logic;
    out_ready : in std_logic;
    bad : out std_logic
  );
end entity;

architecture proof of prove_stream_credit is
  signal may_send, may_now, sends, result, taken, in_flight, all_back, due : std_logic := '0';
  signal flight : std_logic_vector(0 to latency) := (others => '0');
  signal queued : natural range 0 to words := 0;
  signal had_room : std_logic_vector(1 to 3) := "000";  -- so many clocks ago there were three free words or more
  signal was_empty : std_logic := '0';
  signal out_valid : std_logic;

  function ones(bits : std_logic_vector) return natural is
    variable count : natural range 0 to bits'length := 0;
  begin
    for place in bits'range loop
      if bits(place) = '1' then
        count := count + 1;
      end if;
    end loop;
    return count;
  end function;
begin
  sends <= wants_in and may_now;
  result <= flight(latency) and answers;
  out_valid <= '1' when queued > 0 else '0';
  taken <= out_valid and out_ready;

  dut : entity work.stream_credit
    generic map (words => words, latency => latency)
    port map (
      clock => clock, reset => reset, sends => sends, result => result, taken => taken, may_send => may_send,
      in_flight => in_flight, all_back => all_back, due => due);

  process (all)
  begin
    bad <= result and not due;
    if result = '1' and queued = words then
      bad <= '1';
    end if;
    if may_now = '0' and had_room(3) = '1' then
      bad <= '1';
    end if;
    if all_back = '1' and queued + ones(flight) > 0 then
      bad <= '1';
    end if;
    if all_back = '0' and queued + ones(flight) = 0 and was_empty = '1' then
      bad <= '1';
    end if;
    if (in_flight = '1') /= (ones(flight) > 0) then
      bad <= '1';
    end if;
  end process;

  process (clock)
  begin
    if rising_edge(clock) then
      had_room(1) <= '0';
      if queued + ones(flight) < words - 3 or (queued + ones(flight) = words - 3 and sends = '0') then
        had_room(1) <= '1';
      end if;
      had_room(2 to 3) <= had_room(1 to 2);
      may_now <= may_send;
      was_empty <= '1' when queued + ones(flight) = 0 else '0';
      flight <= sends & flight(0 to latency - 1);
      if result = '1' and taken = '0' and queued < words then
        queued <= queued + 1;
      elsif result = '0' and taken = '1' then
        queued <= queued - 1;
      end if;
      if reset = '1' then
        flight <= (others => '0');
        queued <= 0;
        had_room <= "000";
        was_empty <= '1';
      end if;
    end if;
  end process;
end architecture;
