-- SPDX-License-Identifier: Apache-2.0
-- Keeps what one camera sends until the other camera's pixels are there. A camera does not wait: where there is no room,
-- all up to the next start of frame is dropped, be that start in the queue already or still to come.
--   in_valid   a pixel; what comes before the first start of frame is ignored
--   out_*      valid/ready stream from registers; a word shows five clocks after its in_valid at the earliest
--   lines      ends of lines that have come in since the last start of frame, at most 2**15 - 1
--   dropped    '1' for one clock: pixels were dropped, and the word at the output with them
--   reset      synchronous, active high: the queue is empty and waits for a start of frame
-- Size: depth * (pixel_bits + 2) bits of memory, and 8 words of LUT RAM.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity camera_queue is
  generic (
    depth : positive;  -- pixels, 16 or more
    pixel_bits : positive
  );
  port (
    clock : in std_logic;
    reset : in std_logic;
    in_valid : in std_logic;
    in_start_of_frame : in std_logic;
    in_end_of_line : in std_logic;
    in_pixel : in std_logic_vector(pixel_bits - 1 downto 0);
    out_valid : out std_logic;
    out_ready : in std_logic;
    out_start_of_frame : out std_logic;
    out_end_of_line : out std_logic;
    out_pixel : out std_logic_vector(pixel_bits - 1 downto 0);
    lines : out unsigned(14 downto 0);
    dropped : out std_logic
  );
end entity;

architecture rtl of camera_queue is
  constant word_bits : positive := pixel_bits + 2;
  constant ahead : positive := 8;  -- words that are read and not yet taken, at most

  function bits_of(largest : natural) return positive is
    variable bits : positive := 1;
  begin
    while largest / 2 ** bits > 0 loop
      bits := bits + 1;
    end loop;
    return bits;
  end function;

  constant address_bits : positive := bits_of(depth - 1);
  signal write_address, read_address, written_address : natural range 0 to depth - 1 := 0;
  signal memory_read_address, memory_write_address : unsigned(address_bits - 1 downto 0);
  signal written_word : unsigned(word_bits - 1 downto 0) := (others => '0');
  signal read_word : unsigned(word_bits - 1 downto 0);
  signal writes : std_logic := '0';  -- the written word is new: from the next clock on it is in the memory
  signal stored : natural range 0 to depth := 0;  -- words in the memory that are not yet read
  signal start_address : natural range 0 to depth - 1 := 0;  -- of the latest start of frame
  signal behind : natural range 0 to depth := depth;  -- words that came since, itself included; depth: or more
  signal in_flight : natural range 0 to ahead := 0;  -- words that are read and not yet taken
  signal accepts : std_logic := '0';  -- in a frame
  signal arrives, drops : std_logic := '0';
  signal count : unsigned(lines'range) := (others => '0');
  signal shown : std_logic_vector(word_bits - 1 downto 0);
  signal shows, empties : std_logic;

  function following(address : natural) return natural is
  begin
    if address = depth - 1 then
      return 0;
    end if;
    return address + 1;
  end function;
begin
  assert depth >= 2 * ahead
    report "camera_queue: depth is " & integer'image(depth) & " but must be 16 or more" severity failure;

  lines <= count;
  dropped <= drops;
  empties <= reset or drops;
  out_valid <= shows and not drops;
  out_pixel <= shown(pixel_bits - 1 downto 0);
  out_start_of_frame <= shown(pixel_bits);
  out_end_of_line <= shown(pixel_bits + 1);

  memory_read_address <= to_unsigned(read_address, address_bits);
  memory_write_address <= to_unsigned(written_address, address_bits);

  memory : entity work.line_memory
    generic map (depth => depth, width => word_bits, address_bits => address_bits)
    port map (
      clock => clock, read_enable => true, read_address => memory_read_address, read_data => read_word,
      write_address => memory_write_address, write_data => written_word);

  words_ahead : entity work.stream_fifo
    generic map (depth => ahead, width => word_bits)
    port map (
      clock => clock, reset => empties, in_valid => arrives, in_data => std_logic_vector(read_word),
      out_valid => shows, out_ready => out_ready, out_data => shown);

  process (clock)
    variable starts, takes, full, gives_up, reads, leaves : boolean;
  begin
    if rising_edge(clock) then
      starts := in_valid = '1' and in_start_of_frame = '1';
      takes := starts or (in_valid = '1' and accepts = '1');
      full := takes and stored >= depth - 1;  -- one word may be on its way into the memory
      gives_up := full and not starts and behind >= depth - 1;  -- this frame is longer than the queue
      reads := stored > 0 and in_flight < ahead;
      leaves := shows = '1' and drops = '0' and out_ready = '1';
      drops <= '0';
      writes <= '0';
      arrives <= '0';
      if reads then
        arrives <= '1';
      end if;
      if takes then
        writes <= '1';
        accepts <= '1';
        written_address <= write_address;
        written_word <= unsigned(in_end_of_line & in_start_of_frame & in_pixel);
      end if;
      -- Not an increment that a later statement takes back by an assignment of write_address to itself: GHDL 2.0's
      -- synthesis can lose the conditions of such a one.
      if takes and not gives_up then
        write_address <= following(write_address);
      end if;
      if starts then
        start_address <= write_address;
        behind <= 1;
      elsif takes and behind < depth then
        behind <= behind + 1;
      end if;
      if reads then
        read_address <= following(read_address);
      end if;
      if writes = '1' and not reads then
        stored <= stored + 1;
      elsif writes = '0' and reads then
        stored <= stored - 1;
      end if;
      if reads and not leaves then
        in_flight <= in_flight + 1;
      elsif leaves and not reads then
        in_flight <= in_flight - 1;
      end if;
      if starts then
        count <= (others => '0');
        count(0) <= in_end_of_line;
      elsif in_valid = '1' and in_end_of_line = '1' and count /= 2 ** count'length - 1 then
        count <= count + 1;
      end if;
      -- No room. What is read ahead is dropped, too.
      if full then
        drops <= '1';
        in_flight <= 0;
        arrives <= '0';
        if starts then
          read_address <= write_address;
          stored <= 0;
        elsif not gives_up then
          read_address <= start_address;
          stored <= behind;
        else
          accepts <= '0';
          writes <= '0';
          read_address <= write_address;
          stored <= 0;
        end if;
      end if;
      if reset = '1' then
        drops <= '0';
        accepts <= '0';
        writes <= '0';
        arrives <= '0';
        write_address <= 0;
        read_address <= 0;
        stored <= 0;
        in_flight <= 0;
        behind <= depth;
      end if;
      if reset = '1' then
        count <= (others => '0');
      end if;
    end if;
  end process;
end architecture;
