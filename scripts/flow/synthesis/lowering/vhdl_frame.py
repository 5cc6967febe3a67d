# SPDX-License-Identifier: Apache-2.0
"""What every VHDL file of a core has: its ports, and the functions that expressions call."""

PORTS = """\
    clock : in std_logic;
    reset : in std_logic;  -- synchronous, active high
    left_pixel : in std_logic_vector({high} downto 0);  -- 8 bits a row, the upper row in bits 7 ... 0
    right_pixel : in std_logic_vector({high} downto 0);
    start_of_frame : in std_logic;  -- with column 0 of the first rows
    valid : in std_logic;  -- 0: bubble
    disparity : out std_logic_vector({disparity_high} downto 0);
    pixel_valid : out std_logic_vector({rows} downto 0);  -- a bit a row: the disparity has passed every check
    disparity_valid : out std_logic;
    disparity_start_of_frame : out std_logic;
    disparity_end_of_line : out std_logic"""
HELPERS = """\
  function magnitude(value : integer) return natural is
  begin
    if value < 0 then
      return -value;
    end if;
    return value;
  end function;

  -- the complement of a negative number: its magnitude less 1
  function folded(value : integer) return natural is
  begin
    if value < 0 then
      return -1 - value;
    end if;
    return value;
  end function;

  function positive_part(value : integer) return natural is
  begin
    if value < 0 then
      return 0;
    end if;
    return value;
  end function;

  function as_number(value : boolean) return natural is
  begin
    if value then
      return 1;
    end if;
    return 0;
  end function;

  function as_bit(value : boolean) return std_logic is
  begin
    if value then
      return '1';
    end if;
    return '0';
  end function;
"""
