-- SPDX-License-Identifier: Apache-2.0
-- Plays board_top. First its self test, unless self_test is false: the LEDs must count four right maps, the button must stop
-- them, and they must come again. Then, if there is one, the file `given` for its serial line, a number a line: a byte; 256: a
-- byte of zeros without a stop bit; -n: a pause of n bits. The bytes that come back go to the file `answer`, a number a
-- line, -1 for one without a stop bit, then "leds" and what the LEDs show once the line has been quiet for quiet_bits.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tb_board_top is
  generic (
    given : string := "";
    answer : string := "";
    self_test : boolean := true;
    clocks_per_bit : positive := 4;
    permille : positive := 1000;  -- a bit on the line, in thousandths of what the board takes for one
    stop_bits : positive := 2;  -- of the bytes to the board
    quiet_bits : positive := 2000
  );
end entity;

architecture sim of tb_board_top is
  constant period : time := 40 ns;
  constant bit_time : time := period * clocks_per_bit / 1000 * permille;
  constant baud : positive := 1000000;
  constant most_clocks : positive := 4000;
  signal clock, button, over : std_logic := '0';
  signal rx, tx : std_logic := '1';
  signal led : std_logic_vector(7 downto 0);
  signal answered : natural := 0;  -- bytes
begin
  dut : entity work.board_top
    generic map (clock_hz => baud * clocks_per_bit, baud => baud, quiet_ms => 1)
    port map (clock => clock, button => button, rx => rx, tx => tx, led => led);

  clock <= not clock after period / 2 when over = '0' else '0';

  main : process
    procedure expect_maps is
    begin
      for i in 1 to most_clocks loop
        wait until rising_edge(clock);
        exit when led(7 downto 2) = "000100";
      end loop;
      assert led = "00010001" report "LEDs show " & to_string(led) severity failure;
    end procedure;

    procedure send(byte : natural) is
      variable bits : std_logic_vector(8 downto 0);
    begin
      bits := not std_logic_vector(to_unsigned(byte, 9));  -- bit 8: the stop bit
      bits(7 downto 0) := not bits(7 downto 0);
      rx <= '0';
      wait for bit_time;
      for i in 0 to 8 loop
        rx <= bits(i);
        wait for bit_time;
      end loop;
      rx <= '1';
      wait for bit_time * (stop_bits - 1);
    end procedure;

    file lines : text;
    variable row : line;
    variable number : integer;
    variable before : natural;
  begin
    if self_test then
      expect_maps;
      button <= '1';
      wait for 10 * period;
      assert led = "00000000" report "not reset" severity failure;
      button <= '0';
      expect_maps;
      report "self test passed: LEDs " & to_string(led);
    end if;
    if given /= "" then
      wait for 10 * period;
      file_open(lines, given);
      while not endfile(lines) loop
        readline(lines, row);
        read(row, number);
        if number < 0 then
          wait for bit_time * (-number);
        else
          send(number);
        end if;
      end loop;
      loop
        before := answered;
        wait for bit_time * quiet_bits;
        exit when answered = before;
      end loop;
    end if;
    over <= '1';
    wait;
  end process;

  recorder : process
    file bytes : text;
    variable row : line;
    variable byte : std_logic_vector(7 downto 0);
  begin
    if answer = "" then
      wait;
    end if;
    file_open(bytes, answer, write_mode);
    loop
      wait until tx = '0' or over = '1';
      exit when over = '1';
      wait for bit_time / 2;
      for i in 0 to 7 loop
        wait for bit_time;
        byte(i) := tx;
      end loop;
      wait for bit_time;
      if tx = '1' then
        write(row, to_integer(unsigned(byte)));
      else
        write(row, -1);
      end if;
      writeline(bytes, row);
      answered <= answered + 1;
      if tx /= '1' then
        wait until tx = '1';
      end if;
    end loop;
    write(row, string'("leds ") & to_string(led));
    writeline(bytes, row);
    file_close(bytes);
    wait;
  end process;
end architecture;
