-- SPDX-License-Identifier: Apache-2.0
-- uart_transmitter and uart_receiver at the two ends of a line, with clocks of their own: the receiver's period is `permille`
-- thousandths of the transmitter's. All bytes, in two orders, at once and after pauses; then what is no byte: a spike that is
-- too short, and a byte without its stop bit. Says "uart passed" and how many bytes came.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tb_uart is
  generic (
    clocks_per_bit : positive := 12;
    permille : positive := 1000
  );
end entity;

architecture sim of tb_uart is
  constant period : time := 40 ns;
  constant receiver_period : time := period / 1000 * permille;
  constant bit_time : time := period * clocks_per_bit;
  constant rounds : positive := 4;
  constant most_bits : positive := 40;  -- between two bytes that come
  signal clock, receiver_clock, over : std_logic := '0';
  signal in_valid : std_logic := '0';
  signal in_ready, serial, out_valid, out_broken : std_logic;
  signal line_by_hand : std_logic := '1';
  signal in_data, out_data : std_logic_vector(7 downto 0);
  signal came, broken : natural := 0;

  -- The byte of a round: of the first and the third one with neighbours far apart.
  function value(number : natural) return natural is
  begin
    if number / 256 mod 2 = 0 then
      return number * 83 mod 256;
    end if;
    return number mod 256;
  end function;
begin
  clock <= not clock after period / 2 when over = '0' else '0';
  receiver_clock <= not receiver_clock after receiver_period / 2 when over = '0' else '0';

  transmitter : entity work.uart_transmitter
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => clock, reset => '0', in_valid => in_valid, in_ready => in_ready, in_data => in_data, serial => serial);

  receiver : entity work.uart_receiver
    generic map (clocks_per_bit => clocks_per_bit)
    port map (
      clock => receiver_clock, reset => '0', serial => line_by_hand and serial,
      out_valid => out_valid, out_broken => out_broken, out_data => out_data);

  sender : process
    variable pause : natural;
  begin
    for number in 0 to 256 * rounds - 1 loop
      in_data <= std_logic_vector(to_unsigned(value(number), 8));
      in_valid <= '1';
      wait until rising_edge(clock) and in_ready = '1';
      -- Half of the bytes follow at once; the others after up to two bits of quiet.
      if number / 512 = 1 then
        in_valid <= '0';
        pause := 10 * clocks_per_bit + number * 7 mod (2 * clocks_per_bit);
        for i in 1 to pause loop
          wait until rising_edge(clock);
        end loop;
      end if;
    end loop;
    in_valid <= '0';
    wait for most_bits * bit_time;
    assert came = 256 * rounds and broken = 0
      report to_string(came) & " bytes came, " & to_string(broken) & " broken ones" severity failure;
    -- Shorter than half a bit.
    line_by_hand <= '0';
    wait for bit_time / 4;
    line_by_hand <= '1';
    wait for most_bits * bit_time;
    assert came = 256 * rounds and broken = 0 report "a spike became a byte" severity failure;
    line_by_hand <= '0';
    wait for most_bits * bit_time;
    assert came = 256 * rounds and broken = 1
      report "a line at 0 is " & to_string(broken) & " broken bytes" severity failure;
    line_by_hand <= '1';
    wait for most_bits * bit_time;
    assert came = 256 * rounds and broken = 1 report "the end of a line at 0 became a byte" severity failure;
    report "uart passed: " & to_string(came) & " bytes";
    over <= '1';
    wait;
  end process;

  recorder : process (receiver_clock)
  begin
    if rising_edge(receiver_clock) then
      if out_valid = '1' then
        assert unsigned(out_data) = value(came)
          report "byte " & to_string(came) & " is " & to_string(out_data) & " instead of "
            & to_string(to_unsigned(value(came), 8)) severity failure;
        came <= came + 1;
      end if;
      if out_broken = '1' then
        broken <= broken + 1;
      end if;
    end if;
  end process;
end architecture;
