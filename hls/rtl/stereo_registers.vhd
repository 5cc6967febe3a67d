-- SPDX-License-Identifier: Apache-2.0
-- The registers of the core on an AXI4-Lite slave of 32 bits. Their map: stereo_register_map.vhd, as a table in
-- docs/integration.md. One transfer of each kind at a time; address and data of a write in any order. Responses are always
-- OKAY.
--   enable, soft_reset    bits of `control`; soft_reset holds until soft_reset_done, which also clears errors and counters
--   errors                pulses, set the sticky bits of `status`
--   settings              the words of the settings, one behind the other, the first in the lowest bits. A write of more
--                         than the largest value, of less than the least one or of a height that is no multiple of the
--                         pixels per clock is refused and sets an error bit. The core takes them over with each start of
--                         frame. Largest value 0: no such setting
--   irq                   a level, from a register
--   frame_ends, ..broken  a frame has left the core, and was broken; frame_clocks: how long it took
-- Size: about 160 register bits, and those of the settings.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.stereo_register_map.all;

entity stereo_registers is
  generic (
    width_px : positive;
    height_px : positive;
    disparities : positive;
    pixels_per_clock : positive;
    output_width_px : positive;
    disparity_bits : positive;
    core_id : std_logic_vector(31 downto 0);
    enabled_at_reset : boolean;
    settings_largest : setting_values;
    settings_start : setting_values;
    settings_least : setting_values
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_axil_awaddr : in std_logic_vector(address_bits - 1 downto 0);
    s_axil_awprot : in std_logic_vector(2 downto 0);
    s_axil_awvalid : in std_logic;
    s_axil_awready : out std_logic;
    s_axil_wdata : in std_logic_vector(31 downto 0);
    s_axil_wstrb : in std_logic_vector(3 downto 0);
    s_axil_wvalid : in std_logic;
    s_axil_wready : out std_logic;
    s_axil_bresp : out std_logic_vector(1 downto 0);
    s_axil_bvalid : out std_logic;
    s_axil_bready : in std_logic;
    s_axil_araddr : in std_logic_vector(address_bits - 1 downto 0);
    s_axil_arprot : in std_logic_vector(2 downto 0);
    s_axil_arvalid : in std_logic;
    s_axil_arready : out std_logic;
    s_axil_rdata : out std_logic_vector(31 downto 0);
    s_axil_rresp : out std_logic_vector(1 downto 0);
    s_axil_rvalid : out std_logic;
    s_axil_rready : in std_logic;
    enable : out std_logic;
    soft_reset : out std_logic;
    soft_reset_done : in std_logic;
    busy : in std_logic;
    errors : in std_logic_vector(4 downto 0);
    frame_ends : in std_logic;
    frame_ends_broken : in std_logic;
    frame_clocks : in unsigned(31 downto 0);
    settings : out setting_words;
    irq : out std_logic
  );
end entity;

architecture rtl of stereo_registers is
  subtype word is std_logic_vector(31 downto 0);

  signal have_address, have_data, bvalid, rvalid : std_logic := '0';
  signal reads : std_logic := '0';  -- an address has come, and its value goes to rdata: pins may be far from each other
  signal read_address : natural range 0 to 2 ** (address_bits - 2) - 1;  -- in words
  -- '0' in reset and in the clock after it, else the opposite of have_address, have_data, and of reads or rvalid.
  signal takes_address, takes_data, takes_read : std_logic := '0';
  signal write_address : natural range 0 to 2 ** (address_bits - 2) - 1;  -- in words
  signal write_data : word := (others => '0');
  signal write_bytes : std_logic_vector(3 downto 0);
  signal writes : std_logic;  -- a write is complete: it happens in the next clock, that of the answer
  signal applies : std_logic := '0';  -- it happens in this clock
  -- Where it goes, and that a setting is not more than its largest value. From registers: a comparison takes most of a
  -- clock.
  signal to_control, to_status, to_interrupt : std_logic := '0';
  signal setting_addressed, setting_fits : std_logic_vector(0 to setting_count - 1) := (others => '0');
  signal enabled, resetting : std_logic := '0';
  signal sticky : std_logic_vector(5 downto 0) := (others => '0');
  signal frame_done, frame_done_enabled, errors_enabled, any_error : std_logic := '0';
  signal setting : setting_words;
  signal whole_frames, broken_frames : unsigned(31 downto 0) := (others => '0');

  function field(value, bits : natural) return std_logic_vector is
  begin
    return std_logic_vector(to_unsigned(value, bits));
  end function;

  -- the value, and the largest one above it
  function setting_word(value : std_logic_vector(15 downto 0); largest : natural) return word is
  begin
    return field(largest, 16) & value;
  end function;

  function bit_at(value : std_logic; place : natural) return word is
    variable bits : word := (others => '0');
  begin
    bits(place) := value;
    return bits;
  end function;

  type words is array (natural range 0 to 2 ** (address_bits - 2) - 1) of word;
  signal values : words;
begin
  s_axil_awready <= takes_address;
  s_axil_wready <= takes_data;
  s_axil_bvalid <= bvalid;
  s_axil_bresp <= "00";
  s_axil_arready <= takes_read;
  s_axil_rvalid <= rvalid;
  s_axil_rresp <= "00";
  enable <= enabled;
  soft_reset <= resetting;
  -- An array, no case: GHDL writes Verilog for a case that synthesisers read as a latch.
  values <= (
    id_word => id_value,
    version_word => version_value,
    control_word => bit_at(enabled, control_enable) or bit_at(resetting, control_soft_reset),
    status_word => bit_at(busy, status_busy) or
      std_logic_vector(shift_left(resize(unsigned(sticky), 32), status_early_line_end)),
    size_word => field(height_px, size_height_px_bits) & field(width_px, size_width_px_bits),
    matching_word => field(pixels_per_clock, matching_pixels_per_clock_bits) & x"00" &
      field(disparities, matching_disparities_bits),
    map_word => x"00" & field(disparity_bits, map_disparity_bits_bits) & field(output_width_px, map_output_width_px_bits),
    frames_word => std_logic_vector(whole_frames),
    broken_frames_word => std_logic_vector(broken_frames),
    frame_clocks_word => std_logic_vector(frame_clocks),
    core_word => core_id,
    interrupt_word => bit_at(frame_done_enabled, interrupt_frame_done_enable) or
      bit_at(errors_enabled, interrupt_any_error_enable) or bit_at(frame_done, interrupt_frame_done) or
      bit_at(any_error, interrupt_any_error),
    first_setting_word => setting_word(setting(0), settings_largest(0)),
    first_setting_word + 1 => setting_word(setting(1), settings_largest(1)),
    first_setting_word + 2 => setting_word(setting(2), settings_largest(2)),
    first_setting_word + 3 => setting_word(setting(3), settings_largest(3)),
    first_setting_word + 4 => setting_word(setting(4), settings_largest(4)),
    first_setting_word + 5 => setting_word(setting(5), settings_largest(5)),
    first_setting_word + 6 => setting_word(setting(6), settings_largest(6)),
    first_setting_word + 7 => setting_word(setting(7), settings_largest(7)),
    first_setting_word + 8 => setting_word(setting(8), settings_largest(8)),
    first_setting_word + 9 => setting_word(setting(9), settings_largest(9)),
    first_setting_word + 10 => setting_word(setting(10), settings_largest(10)),
    first_setting_word + 11 => setting_word(setting(11), settings_largest(11)),
    others => (others => '0'));

  writes <= have_address and have_data and not bvalid;

  reading : process (aclk)
  begin
    if rising_edge(aclk) then
      reads <= s_axil_arvalid and takes_read;
      rvalid <= reads or (rvalid and not s_axil_rready);
      if reads = '1' or rvalid = '1' then
        takes_read <= rvalid and s_axil_rready;
      else
        takes_read <= not (s_axil_arvalid and takes_read);
      end if;
      if s_axil_arvalid = '1' then
        read_address <= to_integer(unsigned(s_axil_araddr(address_bits - 1 downto 2)));
      end if;
      if reads = '1' then
        s_axil_rdata <= values(read_address);
      end if;
      if aresetn = '0' then
        reads <= '0';
        rvalid <= '0';
        takes_read <= '0';
      end if;
    end if;
  end process;

  writing : process (aclk)
  begin
    if rising_edge(aclk) then
      -- Not by takes_*, which go to pins: of a word that waits to be taken, the last clock counts.
      if have_address = '0' and s_axil_awvalid = '1' then
        write_address <= to_integer(unsigned(s_axil_awaddr(address_bits - 1 downto 2)));
      end if;
      if have_data = '0' and s_axil_wvalid = '1' then
        write_data <= s_axil_wdata;
        write_bytes <= s_axil_wstrb;
      end if;
      applies <= writes;
      to_control <= '0';
      to_status <= '0';
      to_interrupt <= '0';
      if write_address = control_word then
        to_control <= '1';
      elsif write_address = status_word then
        to_status <= '1';
      elsif write_address = interrupt_word then
        to_interrupt <= '1';
      end if;
      for i in setting_addressed'range loop
        setting_addressed(i) <= '0';
        if write_address = first_setting_word + i and write_bytes(1 downto 0) = "11" then
          setting_addressed(i) <= '1';
        end if;
        setting_fits(i) <= '0';
        if to_integer(unsigned(write_data(15 downto 0))) <= settings_largest(i) and
          to_integer(unsigned(write_data(15 downto 0))) >= settings_least(i) then
          setting_fits(i) <= '1';
        end if;
        if first_setting_word + i = image_height_word and
          to_integer(unsigned(write_data(15 downto 0))) mod pixels_per_clock /= 0 then
          setting_fits(i) <= '0';
        end if;
      end loop;
      if writes = '1' then
        bvalid <= '1';
        have_address <= '0';
        have_data <= '0';
        takes_address <= '1';
        takes_data <= '1';
      else
        bvalid <= bvalid and not s_axil_bready;
        have_address <= have_address or (takes_address and s_axil_awvalid);
        have_data <= have_data or (takes_data and s_axil_wvalid);
        takes_address <= not (have_address or (takes_address and s_axil_awvalid));
        takes_data <= not (have_data or (takes_data and s_axil_wvalid));
      end if;
      if aresetn = '0' then
        takes_address <= '0';
        takes_data <= '0';
        have_address <= '0';
        have_data <= '0';
        bvalid <= '0';
        applies <= '0';
      end if;
    end if;
  end process;

  settings <= setting;
  any_error <= '1' when sticky /= "000000" else '0';

  control : process (aclk)
    variable cleared, set : std_logic_vector(5 downto 0);
    variable frame_done_cleared : std_logic;
  begin
    if rising_edge(aclk) then
      cleared := (others => '0');
      set := '0' & errors;
      frame_done_cleared := '0';
      if applies = '1' and to_control = '1' and write_bytes(0) = '1' then
        enabled <= write_data(control_enable);
        resetting <= resetting or write_data(control_soft_reset);
      elsif applies = '1' and to_status = '1' and write_bytes(1) = '1' then
        cleared := write_data(status_setting_refused downto status_early_line_end);
      elsif applies = '1' and to_interrupt = '1' then
        if write_bytes(0) = '1' then
          frame_done_enabled <= write_data(interrupt_frame_done_enable);
          errors_enabled <= write_data(interrupt_any_error_enable);
        end if;
        frame_done_cleared := write_bytes(1) and write_data(interrupt_frame_done);
      end if;
      for i in setting_addressed'range loop
        if applies = '1' and setting_addressed(i) = '1' and setting_fits(i) = '0' then
          set(5) := '1';
        elsif applies = '1' and setting_addressed(i) = '1' and settings_largest(i) > 0 then
          setting(i) <= write_data(15 downto 0);
        end if;
      end loop;
      -- What happens in the very clock in which its bit is cleared stays.
      sticky <= (sticky and not cleared) or set;
      frame_done <= (frame_done and not frame_done_cleared) or frame_ends;
      irq <= (frame_done and frame_done_enabled) or (any_error and errors_enabled);
      if frame_ends = '1' and frame_ends_broken = '1' then
        broken_frames <= broken_frames + 1;
      elsif frame_ends = '1' then
        whole_frames <= whole_frames + 1;
      end if;
      if aresetn = '0' or soft_reset_done = '1' then
        resetting <= '0';
        sticky <= (others => '0');
        frame_done <= '0';
        broken_frames <= (others => '0');
        whole_frames <= (others => '0');
      end if;
      if aresetn = '0' then
        enabled <= '0';
        if enabled_at_reset then
          enabled <= '1';
        end if;
        frame_done_enabled <= '0';
        errors_enabled <= '0';
        irq <= '0';
        for i in 0 to setting_count - 1 loop
          setting(i) <= field(settings_start(i), 16);
        end loop;
      end if;
    end if;
  end process;
end architecture;
