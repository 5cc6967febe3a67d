-- SPDX-License-Identifier: Apache-2.0
-- The rectified image beside the depths: keeps its pixels as long as the matching core takes, and shows each with the depth
-- at its place.
--   rectified_*   as they go into the core
--   disparity_*   as they come out of it: a map of output_width_px columns, the first at column first_column of the image
--   image_pixel   2 clocks behind a disparity: the pixel at its place
-- Pixels that come between frames are kept like others, and each map begins at the pixels of its own frame: their number
-- does not matter. A frame comes in only when the map of the one before has begun to come out.
-- Size: `kept` words of pixel_bits.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity camera_image is
  generic (
    width_px : positive;
    output_width_px : positive;  -- up to width_px
    first_column : natural;
    kept : positive;  -- pixels, width_px or more
    address_bits : positive;  -- 2 ** address_bits >= kept
    pixel_bits : positive
  );
  port (
    clock : in std_logic;
    rectified_pixel : in std_logic_vector(pixel_bits - 1 downto 0);
    rectified_start_of_frame : in std_logic;
    rectified_valid : in std_logic;
    disparity_valid : in std_logic;
    disparity_start_of_frame : in std_logic;
    disparity_end_of_line : in std_logic;
    image_pixel : out std_logic_vector(pixel_bits - 1 downto 0)
  );
end entity;

architecture rtl of camera_image is
  -- Addresses: of the newest pixel, of the first one of the next map, of the one to be shown.
  signal written, first, shown : natural range 0 to kept - 1 := 0;
  signal written_pixel : std_logic_vector(pixel_bits - 1 downto 0) := (others => '0');
  signal line_ended : std_logic := '0';  -- with the last disparity
  signal write_address, read_address : unsigned(address_bits - 1 downto 0);
  signal found : unsigned(pixel_bits - 1 downto 0);

  -- Of the pixel that comes in so many pixels later.
  function later(address, pixels : natural) return natural is
  begin
    if address + pixels >= kept then
      return address + pixels - kept;
    end if;
    return address + pixels;
  end function;
begin
  write_address <= to_unsigned(written, address_bits);
  read_address <= to_unsigned(shown, address_bits);
  image_pixel <= std_logic_vector(found);

  memory : entity work.line_memory
    generic map (depth => kept, width => pixel_bits, address_bits => address_bits)
    port map (
      clock => clock, read_enable => true, read_address => read_address, read_data => found,
      write_address => write_address, write_data => unsigned(written_pixel));

  process (clock)
  begin
    if rising_edge(clock) then
      if rectified_valid = '1' then
        written <= later(written, 1);
        written_pixel <= rectified_pixel;
        if rectified_start_of_frame = '1' then
          first <= later(written, 1 + first_column);
        end if;
      end if;
      if disparity_valid = '1' then
        line_ended <= disparity_end_of_line;
        if disparity_start_of_frame = '1' then
          shown <= first;
        elsif line_ended = '1' then
          shown <= later(shown, 1 + width_px - output_width_px);
        else
          shown <= later(shown, 1);
        end if;
      end if;
    end if;
  end process;
end architecture;
