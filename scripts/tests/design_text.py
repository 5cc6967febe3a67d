# SPDX-License-Identifier: Apache-2.0
"""A small design in the shape in which the tool writes VHDL, for tests that need no tool.

One loop state S_0 after the start-up state S_1, which loads 5 into the counter `reg_0`. In the loop the counter grows
by the input `valid`, and its sum with the constant 3 is the output `disparity`.
"""

DATAPATH = """
entity datapath_stereo_core is
port (
  -- IN
  clock : in std_logic;
  reset : in std_logic;
  \\_valid\\ : in std_logic_vector(0 downto 0);
  selector_MUX_0 : in std_logic;
  wrenable_reg_0 : in std_logic;
  -- OUT
  \\_disparity\\ : out std_logic_vector(7 downto 0)
);
end datapath_stereo_core;

architecture datapath_stereo_core_arch of datapath_stereo_core is
  component MUX_GATE
  port ( in1 : in std_logic_vector(BITSIZE_in1-1 downto 0) );
  end component;
  signal out_const_0 : std_logic_vector(2 downto 0);
  signal out_const_1 : std_logic_vector(1 downto 0);
  signal out_MUX_0 : std_logic_vector(7 downto 0);
  signal out_valid : std_logic_vector(0 downto 0);
  signal out_next : unsigned (7 downto 0);
  signal out_sum : unsigned (7 downto 0);
  signal out_reg_0 : std_logic_vector(7 downto 0);
begin
  MUX_0 : MUX_GATE generic map(BITSIZE_in1=>8,
    BITSIZE_in2=>8,
    BITSIZE_out1=>8) port map (out1 => out_MUX_0,
    sel => selector_MUX_0,
    in1 => std_logic_vector(out_next),
    in2 => out_const_0);
  const_0 : constant_value generic map(BITSIZE_out1=>3,
    value=>"101") port map (out1 => out_const_0);
  const_1 : constant_value generic map(BITSIZE_out1=>2,
    value=>"11") port map (out1 => out_const_1);
  read_0 : valid_bambu_artificial_ParmMgr_Read_none_modgen generic map(BITSIZE_in1=>32,
    BITSIZE_out1=>1) port map (out1 => out_valid,
    clock => clock,
    reset => reset,
      start_port(0) => selector_MUX_0,
    in1 => "00000000000000000000000000000000",
    \\_valid\\ => \\_valid\\);
  fu_0 : ui_plus_expr_FU generic map(BITSIZE_in1=>8,
    BITSIZE_in2=>1,
    BITSIZE_out1=>8) port map (out1 => out_next,
    in1 => unsigned(out_reg_0),
    in2 => unsigned(out_valid));
  fu_1 : ui_plus_expr_FU generic map(BITSIZE_in1=>8,
    BITSIZE_in2=>2,
    BITSIZE_out1=>8) port map (out1 => out_sum,
    in1 => unsigned(out_reg_0),
    in2 => unsigned(out_const_1));
  reg_0 : register_SE generic map(BITSIZE_in1=>8,
    BITSIZE_out1=>8) port map (out1 => out_reg_0,
    clock => clock,
    reset => reset,
    in1 => out_MUX_0,
    wenable => wrenable_reg_0);
  write_0 : disparity_bambu_artificial_ParmMgr_Write_none_modgen generic map(BITSIZE_in2=>8) port map (\\_disparity\\ => \\_disparity\\,
    clock => clock,
    in2 => std_logic_vector(out_sum));

end datapath_stereo_core_arch;
"""  # noqa: E501 - as the tool breaks its lines

CONTROLLER = """
entity controller_stereo_core is
end controller_stereo_core;
architecture controller_stereo_core_arch of controller_stereo_core is
begin
  state_reg: process(clock)
  begin
    if (clock'event and clock='1') then
      if (reset='0') then
        present_state <= S_1;
      else
        present_state <= next_state;
      end if;
    end if;
  end process;
  comb_logic0: process(present_state, start_port)
  begin
    done_port <= '0';
    selector_MUX_0 <= '0';
    wrenable_reg_0 <= '0';
    case present_state is
      when S_1 =>
        if(start_port /= '1') then
          wrenable_reg_0 <= 'X';
          next_state <= S_1;
        else
          wrenable_reg_0 <= '1';
          next_state <= S_0;
        end if;
      when S_0 =>
        selector_MUX_0 <= '1';
        wrenable_reg_0 <= '1';
        next_state <= S_0;
      when others =>
        next_state <= S_1;
    end case;
  end process;
end controller_stereo_core_arch;
"""

DESIGN = DATAPATH + CONTROLLER
