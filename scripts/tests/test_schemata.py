# SPDX-License-Identifier: Apache-2.0
"""Many mutants in one text: each is there when it is chosen, as if it stood there alone."""

import re

from flow.base import ghdl as simulator
from flow.base.errors import FlowError
from flow.base.tools import find_ghdl, run
from flow.mutation import mutants, schemata

TEXT = """-- SPDX-License-Identifier: Apache-2.0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity small is
  port (
    clock : in std_logic;
    a : in std_logic_vector(3 downto 0);
    b : in std_logic;
    shown : out std_logic_vector(3 downto 0)
  );
end entity;
architecture rtl of small is
  signal count : natural range 0 to 15 := 0;
  signal first, second : boolean := false;
begin
  shown <= std_logic_vector(to_unsigned(count, 4)) when b = '0' else "0001" when first or second else (others => '1');
  process (clock)
    variable number : natural range 0 to 15;
  begin
    if rising_edge(clock) then
      number := to_integer(unsigned(a));
      if (number > 3) and
        (b = '1') then
        count <= (count + number +
          1) mod 16;
      elsif number < 2 then
        first <= not first;
      else
        second <= first and (number = 7);
      end if;
    end if;
  end process;
end architecture;
"""
BENCH = """library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity bench is
  generic (chosen : natural := 0);
end entity;
architecture sim of bench is
  signal clock, b : std_logic := '0';
  signal a, shown : std_logic_vector(3 downto 0) := "0000";
begin
  dut : entity work.small port map (PORT clock => clock, a => a, b => b, shown => shown);
  process
    variable seed : natural := 1;
  begin
    for number in 1 to 60 loop
      seed := (seed * 75 + 74) mod 65537;
      a <= std_logic_vector(to_unsigned(seed / 16 mod 16, 4));
      b <= '1' when seed mod 16 > 7 else '0';
      wait for 5 ns;
      report to_string(shown);
      clock <= '1';
      wait for 5 ns;
      clock <= '0';
    end loop;
    wait;
  end process;
end architecture;
"""
CHOSEN = f"{schemata.INPUT} => std_logic_vector(to_unsigned(chosen, {schemata.BITS})),"


def simulation(work, text, port=""):
    work.mkdir()
    (work / "small.vhd").write_text(text)
    (work / "bench.vhd").write_text(BENCH.replace("PORT", port))
    simulator.analyse([work / "small.vhd", work / "bench.vhd"], work)
    simulator.elaborate(work, "bench")
    return work


def shown(work, chosen=0):
    run([find_ghdl(), "-r", simulator.STANDARD, "bench", f"-gchosen={chosen}"], cwd=work, log=work / "run.log")
    said = (work / "run.log").read_text()
    return re.findall(r"note\): (\w{4})$", said, re.MULTILINE)


def test_each_mutant_does_what_it_does_alone(ghdl, tmp_path):
    path = tmp_path / "small.vhd"
    path.write_text(TEXT)
    alone, known = {}, {}
    for number, mutant in enumerate(mutants.mutants_of(path), 1):
        try:
            work = simulation(tmp_path / str(number), mutants.write(mutant, tmp_path / f"text_{number}").read_text())
            alone[number] = shown(work)
        except FlowError:  # it does not compile, or leaves a range
            continue
        known[number] = mutant
    text = schemata.with_mutants(path, known)
    assert not text.line_of.keys() - range(1, 1 + text.text.count("\n"))
    together = simulation(tmp_path / "together", text.text, CHOSEN)
    original = shown(simulation(tmp_path / "original", TEXT))
    assert len(original) == 60 and shown(together) == original
    inside = known.keys() - {*text.outside}
    assert len(inside) >= 20 and len(text.outside) < 6
    assert {number: shown(together, number) for number in inside} == {number: alone[number] for number in inside}
    assert sum(alone[number] != original for number in inside) > 14


def test_a_line_names_its_mutant(tmp_path):
    path = tmp_path / "small.vhd"
    path.write_text(TEXT)
    known = dict(enumerate(mutants.mutants_of(path), 1))
    text = schemata.with_mutants(path, known)
    lines = text.text.splitlines()
    for line, number in text.line_of.items():
        assert number in known and number not in text.outside and lines[line - 1].strip()
    assert {*text.line_of.values()} == known.keys() - {*text.outside}


def test_declarations_functions_and_clocks_stay_outside(tmp_path):
    path = tmp_path / "small.vhd"
    path.write_text(TEXT)
    known = dict(enumerate(mutants.mutants_of(path), 1))
    outside = {known[number].text.strip() for number in schemata.with_mutants(path, known).outside}
    assert any("rising_edge" in text for text in outside) and any(text.startswith("variable") for text in outside)
    assert not any(re.match(r"count|first|elsif", text) for text in outside)
