# SPDX-License-Identifier: Apache-2.0
"""Counts of differing bits and the calls that stand for them: what both mean, that each goes to the other, and what
stays."""

import re
import subprocess
from itertools import product

import pytest

from conftest import need
from flow.base import ghdl
from flow.base.tools import find_ghdl
from flow.synthesis.presentation import bits, differences, tree
from flow.synthesis.presentation.words import joined, split

NUMBER, WORD = "natural range 0 to 31", "unsigned(4 downto 0)"
KINDS = {"a": NUMBER, "b": NUMBER, "c": NUMBER, "w": WORD, "x": WORD, "y": WORD, "n_value": "boolean", "m": "boolean"}
KINDS |= {f"n_value_{number}": "boolean" for number in range(2, 5)}
CASES = {  # statements, what stands for them
    "bits of numbers": (["n <= as_number((is_set(a, 3) /= is_set(b, 3)));"], ["n <= differing(a, b, 3);"]),
    "bits of words": (
        ["n <= as_number(((w(3) = '1') /= (x(3) = '1'))) + 1;"],
        ["n <= differing_bits(w, x, 3) + 1;"],
    ),
    "three at once": (
        ["n <= as_number((is_set(a, 0) /= is_set(b, 0)))", "+ as_number((is_set(a, 2) /= is_set(b, 2)))"]
        + ["+ as_number((is_set(a, 1) /= is_set(b, 1)));"],
        ["n <= differing(a, b, 0, 2, 1);"],
    ),
    "operands exchanged": (
        ["n <= as_number((is_set(a, 0) /= is_set(b, 0)))", "+ as_number((is_set(b, 2) /= is_set(a, 2)))"]
        + ["+ as_number((is_set(a, 1) /= is_set(b, 1)));"],
        ["n <= differing(a, b, 0) + differing(b, a, 2) + differing(a, b, 1);"],
    ),
    "behind another number": (
        ["n <= c + as_number((is_set(a, 0) /= is_set(b, 0)))", "+ as_number((is_set(a, 2) /= is_set(b, 2)))"]
        + ["+ as_number((is_set(a, 1) /= is_set(b, 1)));"],
        ["n <= c + differing(a, b, 0) + differing(a, b, 2) + differing(a, b, 1);"],
    ),
    "a bit that two take": (
        ["n_value := is_set(b, 2);", "n <= as_number((n_value /= is_set(a, 2)));"]
        + ["k <= as_number((is_set(c, 2) /= n_value)) * 4;"],
        ["n <= differing(b, a, 2);", "k <= differing(c, b, 2) * 4;"],
    ),
    "bits of a word that two take": (
        ["n_value := x(3) = '1';", "n_value_2 := x(1) = '1';"]
        + ["n <= as_number(((w(3) = '1') /= n_value)) + as_number((n_value_2 /= (w(1) = '1')));"]
        + ["k <= as_number((n_value /= (y(3) = '1'))) + as_number((n_value_2 /= (y(1) = '1')));"],
        ["n <= differing_bits(w, x, 3) + differing_bits(x, w, 1);"]
        + ["k <= differing_bits(x, y, 3) + differing_bits(x, y, 1);"],
    ),
    "the first and the last bit have no variables": (
        ["n <= as_number((is_set(a, 0) /= is_set(b, 0))) + as_number((is_set(a, 4) /= is_set(b, 4)));"]
        + ["k <= as_number((is_set(c, 0) /= is_set(b, 0))) + as_number((is_set(c, 4) /= is_set(b, 4)));"],
        ["n <= differing(a, b, 0) + differing(a, b, 4);", "k <= differing(c, b, 0) + differing(c, b, 4);"],
    ),
}


def read(*lines):
    return tree.read(split("\n".join(lines)))


def written(statements):
    return [f"-- {one.text}" if isinstance(one, tree.Comment) else f"{joined(one.words)};" for one in statements]


@pytest.mark.parametrize("case", CASES)
def test_there_and_back(case):
    lines, calls = CASES[case]
    statements = read("-- cost", *lines, "-- window", "k <= a + b;")
    shown = differences.made(statements, KINDS)
    assert written(shown) == ["-- cost", *calls, "-- window", "k <= a + b;"]
    back, variables = differences.unmade(shown, KINDS)
    assert back == statements
    assert variables == [one.words[0] for one in statements if isinstance(one, tree.Assign) and one.words[1] == ":="]


# Python for the words of VHDL.
MEANING = {
    "is_set": lambda value, place: bool(value >> place & 1),
    "as_number": int,
    "differing": lambda a, b, *places: sum((a ^ b) >> place & 1 for place in places),
}


def run(statements, **values):
    """{target: its value}"""
    for one in statements:
        text = re.sub(r"\b([wxy]) \( (\d) \) = '1'", r"is_set(\1, \2)", " ".join(one.words[2:]))
        text = text.replace("/=", "!=").replace("differing_bits", "differing")
        values[one.words[0]] = eval(text, {}, {**MEANING, **values})
    return values["n"], values.get("k")


@pytest.mark.parametrize("case", CASES)
def test_both_mean_the_same(case):
    lines, calls = CASES[case]
    for a, b, c in product(range(32), range(0, 32, 3), (0, 9, 31)):
        values = {"a": a, "b": b, "c": c, "w": a, "x": b, "y": c}
        assert run(read(*lines), **values) == run(read(*calls), **values)


STAY = {
    "bits of two places": "n <= as_number((is_set(a, 3) /= is_set(b, 2)));",
    "a number and a word": "n <= as_number((is_set(a, 3) /= (w(3) = '1')));",
    "no bits": "n <= as_number((a /= b));",
    "a condition": "m <= is_set(a, 3) /= is_set(b, 3);",
    "a value that something else reads": "n_value := is_set(b, 2);\nn <= as_number((n_value /= is_set(a, 2)));\n"
    "m <= n_value;",
    "a value that one takes": "n_value := is_set(b, 2);\nn <= as_number((n_value /= is_set(a, 2)));",
    "a value of another name": "m := is_set(b, 2);\nn <= as_number((m /= is_set(a, 2)));\n"
    "k <= as_number((m /= is_set(c, 2)));",
    "a bit that two take, without a variable": "n <= as_number((is_set(a, 2) /= is_set(b, 2)));\n"
    "k <= as_number((is_set(c, 2) /= is_set(b, 2)));",
    "a value behind its place": "m <= true;\nn_value := is_set(b, 2);\nn <= as_number((n_value /= is_set(a, 2)));\n"
    "k <= as_number((n_value /= is_set(c, 2)));",
}


@pytest.mark.parametrize("case", STAY)
def test_what_stays(case):
    statements = read("-- cost", STAY[case])
    assert differences.made(statements, KINDS) == statements


def test_a_fault_leaves_the_statements(monkeypatch):
    """What does not go back is not taken."""
    statements = read("-- cost", *CASES["a bit that two take"][0])
    shown = differences._shown
    monkeypatch.setattr(differences, "_shown", lambda parts: shown([*parts[::-1]]))
    assert differences.made(statements, KINDS) == statements


def test_a_section_that_stays_keeps_no_other():
    statements = read("-- cost", STAY["a value of another name"], "-- other", *CASES["a bit that two take"][0])
    shown = written(differences.made(statements, KINDS))
    assert shown == [*written(statements)[:5], *CASES["a bit that two take"][1]]


BENCH = """library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity bench is end entity;
architecture sim of bench is
  function as_number(value : boolean) return natural is
  begin
    return boolean'pos(value);
  end function;
{functions}
begin
  process
    variable count : natural;
  begin
    for a in 0 to 15 loop
      for b in 0 to 15 loop
        for p in 0 to 3 loop
          count := boolean'pos((a / 2 ** p) mod 2 /= (b / 2 ** p) mod 2);
          assert differing(a, b, p) = count and differing_bits(to_unsigned(a, 4), to_unsigned(b, 4), p) = count
            report "wrong" severity failure;
        end loop;
        count := differing(a, b, 3) + differing(a, b, 0) + differing(a, b, 2);
        assert differing(a, b, 3, 0, 2) = count report "wrong" severity failure;
        assert differing_bits(to_unsigned(a, 4), to_unsigned(b, 4), 3, 0, 2) = count report "wrong" severity failure;
      end loop;
    end loop;
    report "all right";
    wait;
  end process;
end architecture;
"""
FAULTS = {
    "none": ("", ""),
    "equal bits": ("is_set(a, place) /=", "is_set(a, place) ="),
    "an operand": ("/= (b(place)", "/= (a(place)"),
    "a place": ("differing(a, b, r)", "differing(a, b, q)"),
    "a place of words": ("differing_bits(a, b, q)", "differing_bits(a, b, p)"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_functions_of_the_vhdl(fault, tmp_path):
    """For all values."""
    need("ghdl", "GHDL")
    functions = bits.FUNCTION + "".join(differences.FUNCTIONS.values()).replace(*FAULTS[fault])
    (tmp_path / "bench.vhd").write_text(BENCH.replace("{functions}", functions))
    ghdl.analyse([tmp_path / "bench.vhd"], tmp_path)
    ghdl.elaborate(tmp_path, "bench")
    command = [find_ghdl(), "-r", ghdl.STANDARD, "bench"]
    answer = subprocess.run(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert ("all right" in answer.stdout and answer.returncode == 0) == (fault == "none"), answer.stdout
