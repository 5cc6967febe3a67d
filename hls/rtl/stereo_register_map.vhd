-- SPDX-License-Identifier: Apache-2.0
-- Addresses, in words of 4 bytes, and fields of the registers of stereo_ip: of a field of one bit its place, of a wider
-- one its width. Made by scripts/registers.py from hls/rtl/registers.json; do not edit.
library ieee;
use ieee.std_logic_1164.all;

package stereo_register_map is
  constant address_bits : positive := 6;  -- of addresses in bytes
  constant id_value : std_logic_vector(31 downto 0) := x"53544552";
  constant version_value : std_logic_vector(31 downto 0) := x"00010200";
  constant id_word : natural := 0;
  constant version_word : natural := 1;
  constant control_word : natural := 2;
  constant control_enable : natural := 0;
  constant control_soft_reset : natural := 1;
  constant status_word : natural := 3;
  constant status_busy : natural := 0;
  constant status_early_line_end : natural := 8;
  constant status_late_line_end : natural := 9;
  constant status_early_start : natural := 10;
  constant status_outside_frame : natural := 11;
  constant status_core_fault : natural := 12;
  constant status_setting_refused : natural := 13;
  constant size_word : natural := 4;
  constant size_width_px_bits : positive := 16;
  constant size_height_px_bits : positive := 16;
  constant matching_word : natural := 5;
  constant matching_disparities_bits : positive := 16;
  constant matching_pixels_per_clock_bits : positive := 8;
  constant map_word : natural := 6;
  constant map_output_width_px_bits : positive := 16;
  constant map_disparity_bits_bits : positive := 8;
  constant frames_word : natural := 7;
  constant broken_frames_word : natural := 8;
  constant frame_clocks_word : natural := 9;
  constant core_word : natural := 10;
  constant interrupt_word : natural := 11;
  constant interrupt_frame_done_enable : natural := 0;
  constant interrupt_any_error_enable : natural := 1;
  constant interrupt_frame_done : natural := 8;
  constant interrupt_any_error : natural := 9;
  constant texture_threshold_word : natural := 12;
  constant texture_threshold_value_bits : positive := 16;
  constant texture_threshold_largest_bits : positive := 16;
  constant uniqueness_percent_word : natural := 13;
  constant uniqueness_percent_value_bits : positive := 16;
  constant uniqueness_percent_largest_bits : positive := 16;
  constant left_right_threshold_word : natural := 14;
  constant left_right_threshold_value_bits : positive := 16;
  constant left_right_threshold_largest_bits : positive := 16;
  constant p1_word : natural := 12;
  constant p1_value_bits : positive := 16;
  constant p1_largest_bits : positive := 16;
  constant uniqueness_distance_word : natural := 13;
  constant uniqueness_distance_value_bits : positive := 16;
  constant uniqueness_distance_largest_bits : positive := 16;
  constant p2_word : natural := 15;
  constant p2_value_bits : positive := 16;
  constant p2_largest_bits : positive := 16;
  constant setting_count : positive := 4;
  constant first_setting_word : natural := texture_threshold_word;
  type setting_words is array (0 to setting_count - 1) of std_logic_vector(15 downto 0);
  type setting_values is array (0 to setting_count - 1) of natural;
end package;
