-- SPDX-License-Identifier: Apache-2.0
-- What a processor loads into a camera_system, on AXI4-Lite: the nodes of the rectification's tables, and the depths.
--   0x00  node_place    write  bits 15 ... 0 column, 30 ... 16 row, 31: of the right camera's table
--   0x04  node_offsets  write  bits 15 ... 0 offset to the right, 31 ... 16 offset down, in two's complement: writes the
--                              node at node_place. SLVERR, and nothing is written, where the table has no such node
--   0x08  depth         write  bits 15 ... 0 millimetres, 31 ... 16 the disparity that they belong to. SLVERR, and nothing is
--                              written, where the table has no such entry
--   0x0c  size          read   bits 15 ... 0 columns of a table, 31 ... 16 rows
--   0x10  cameras       read   bits 15 ... 0 lines by which the right camera is behind, 18 ... 16 faults of the joiner since
--                              the last write to here
--   0x14  depths        read   bits 15 ... 0 entries of the table of depths, 16: from one to the next it is a sixteenth of a
--                              pixel, else a pixel
-- Other addresses answer SLVERR. Strobes are not looked at: words are written whole.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity camera_tables is
  generic (
    table_columns : positive;
    table_rows : positive;
    depth_entries : positive;
    subpixel : boolean
  );
  port (
    aclk : in std_logic;
    aresetn : in std_logic;
    s_axil_awaddr : in std_logic_vector(4 downto 0);
    s_axil_awvalid : in std_logic;
    s_axil_awready : out std_logic;
    s_axil_wdata : in std_logic_vector(31 downto 0);
    s_axil_wvalid : in std_logic;
    s_axil_wready : out std_logic;
    s_axil_bresp : out std_logic_vector(1 downto 0);
    s_axil_bvalid : out std_logic;
    s_axil_bready : in std_logic;
    s_axil_araddr : in std_logic_vector(4 downto 0);
    s_axil_arvalid : in std_logic;
    s_axil_arready : out std_logic;
    s_axil_rdata : out std_logic_vector(31 downto 0);
    s_axil_rresp : out std_logic_vector(1 downto 0);
    s_axil_rvalid : out std_logic;
    s_axil_rready : in std_logic;
    skew_lines : in std_logic_vector(15 downto 0);
    faults : in std_logic_vector(2 downto 0);
    -- to the rectification: valid for one clock
    node_valid : out std_logic;
    node_right : out std_logic;
    node_column : out std_logic_vector(15 downto 0);
    node_row : out std_logic_vector(15 downto 0);
    node_x : out std_logic_vector(15 downto 0);
    node_y : out std_logic_vector(15 downto 0);
    -- the last depth that was written stands there
    depth_disparity : out std_logic_vector(15 downto 0);
    depth_mm : out std_logic_vector(15 downto 0)
  );
end entity;

architecture rtl of camera_tables is
  constant okay : std_logic_vector(1 downto 0) := "00";
  constant error : std_logic_vector(1 downto 0) := "10";
  signal writes, reads : std_logic;
  signal answers, shows : std_logic := '0';  -- bvalid, rvalid
  signal place : std_logic_vector(31 downto 0) := (others => '0');
  signal seen : std_logic_vector(2 downto 0) := "000";
  signal has_node : boolean;
  signal write_word, read_word : std_logic_vector(2 downto 0);  -- of an address
begin
  -- An address and its word are taken together, one at a time.
  writes <= s_axil_awvalid and s_axil_wvalid and not answers;
  reads <= s_axil_arvalid and not shows;
  s_axil_awready <= writes;
  s_axil_wready <= writes;
  s_axil_arready <= reads;
  s_axil_bvalid <= answers;
  s_axil_rvalid <= shows;
  has_node <= unsigned(place(15 downto 0)) < table_columns and unsigned(place(30 downto 16)) < table_rows;
  write_word <= s_axil_awaddr(4 downto 2);
  read_word <= s_axil_araddr(4 downto 2);
  node_right <= place(31);
  node_column <= place(15 downto 0);
  node_row <= '0' & place(30 downto 16);

  process (aclk)
  begin
    if rising_edge(aclk) then
      node_valid <= '0';
      seen <= seen or faults;
      if s_axil_bready = '1' then
        answers <= '0';
      end if;
      if writes = '1' then
        answers <= '1';
        s_axil_bresp <= okay;
        -- No case: GHDL writes Verilog for it that synthesisers read as a latch.
        if write_word = "000" then
          place <= s_axil_wdata;
        elsif write_word = "001" then
          node_x <= s_axil_wdata(15 downto 0);
          node_y <= s_axil_wdata(31 downto 16);
          if has_node then
            node_valid <= '1';
          else
            s_axil_bresp <= error;
          end if;
        elsif write_word = "010" and unsigned(s_axil_wdata(31 downto 16)) < depth_entries then
          depth_mm <= s_axil_wdata(15 downto 0);
          depth_disparity <= s_axil_wdata(31 downto 16);
        elsif write_word = "100" then
          seen <= faults;
        else
          s_axil_bresp <= error;
        end if;
      end if;
      if s_axil_rready = '1' then
        shows <= '0';
      end if;
      if reads = '1' then
        shows <= '1';
        s_axil_rresp <= okay;
        s_axil_rdata <= (others => '0');
        if read_word = "011" then
          s_axil_rdata <=
            std_logic_vector(to_unsigned(table_rows, 16)) & std_logic_vector(to_unsigned(table_columns, 16));
        elsif read_word = "100" then
          s_axil_rdata(18 downto 0) <= seen & skew_lines;
        elsif read_word = "101" then
          s_axil_rdata(15 downto 0) <= std_logic_vector(to_unsigned(depth_entries, 16));
          if subpixel then
            s_axil_rdata(16) <= '1';
          end if;
        else
          s_axil_rresp <= error;
        end if;
      end if;
      if aresetn = '0' then
        answers <= '0';
        shows <= '0';
        node_valid <= '0';
        seen <= "000";
        depth_disparity <= (others => '0');
        depth_mm <= (others => '0');
      end if;
    end if;
  end process;
end architecture;
