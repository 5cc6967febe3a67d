# SPDX-License-Identifier: Apache-2.0
"""Comparisons in steps of one bit, and the calls that stand for them: what both mean, that each goes to the other, and
where the steps stay."""

import re
import subprocess
from itertools import product

import pytest

from conftest import need
from flow.base import ghdl
from flow.base.tools import find_ghdl
from flow.synthesis.presentation import bits, carries, comparisons, tree
from flow.synthesis.presentation.words import joined, split

VARIABLES = {"v", "r_choice", *(f"r_choice_{number}" for number in range(2, 40))}
CALLS = {  # what is called: {value of a, b, before: the answer}
    "from bit 0": ("is_larger(a, b, 0, 3, false)", lambda a, b, v: a > b),
    "equal ones count": ("is_larger(a, b, 0, 3, true)", lambda a, b, v: a >= b),
    "its complement": ("not is_larger(a, b, 0, 3, false)", lambda a, b, v: a <= b),
    "the complement with equal ones": ("not is_larger(a, b, 0, 3, true)", lambda a, b, v: a < b),
    "three bits": ("is_larger(a, b, 0, 2, false)", lambda a, b, v: a % 8 > b % 8),
    "two bits": ("is_larger(a, b, 0, 1, true)", lambda a, b, v: a % 4 >= b % 4),
    "behind a variable": ("is_larger(a, b, 1, 3, v)", lambda a, b, v: (a // 2, v) > (b // 2, False)),
    "behind a complement": ("is_larger(a, b, 1, 3, not v)", lambda a, b, v: (a // 2, not v) > (b // 2, False)),
    "behind a register": ("is_larger(a, b, 2, 3, s)", lambda a, b, v: (a // 4, v) > (b // 4, False)),
    "bits of words": (
        "is_larger(to_integer(w(5 downto 2)), to_integer(x(8 downto 5)), 0, 3, false)",
        lambda a, b, v: a > b,
    ),
    "a word and a number": ("not is_larger(to_integer(w(5 downto 2)), b, 0, 3, true)", lambda a, b, v: a < b),
    "a number and a word": (
        "is_larger(a, to_integer(x(8 downto 5)), 1, 3, v)",
        lambda a, b, v: (a // 2, v) > (b // 2, 0),
    ),
}
# Python for the words of VHDL.
MEANING = {
    "is_set": lambda value, place: bool(value >> place & 1),
    "choice": lambda test, yes, no: yes if test else no,
    "carry": lambda before, a, b: a or b if before else a and b,
    "inverted_carry": lambda before, a, b: a and b if before else a or b,
    "part": lambda word, high, low: int("".join(word(place) for place in range(high, low - 1, -1)), 2),
}


def read(text):
    return tree.read(split(text))


def written(statements):
    return [joined(one.words) for one in statements]


def run(statements, **values):
    """What the last assignment gives."""
    values = {**MEANING, **values}
    for one in statements:
        text = re.sub(r"to_integer \( (\w) \( (\d+) downto (\d+) \) \)", r"part(\1, \2, \3)", " ".join(one.words[2:]))
        text = text.replace(" mod ", " % ").replace(" = ", " == ").replace("false", "False").replace("true", "True")
        values[one.words[0]] = eval(text, {}, values)
    return values[statements[-1].words[0]]


def word(value, first):
    """With this value from bit `first` on, and the opposite below and above."""
    return lambda place: str(value >> place - first & 1) if first <= place < first + 4 else str(1 - (value & 1))


@pytest.mark.parametrize("name", CALLS)
def test_steps_mean_what_the_call_says(name):
    call, meaning = CALLS[name]
    steps, names = comparisons.unmade(read(f"r_choice_9 := {call};"), VARIABLES)
    assert len(steps) == len(names) + 1 and not any(comparisons.NAME in one.words for one in steps)
    for a, b, v in product(range(16), range(16), (False, True)):
        assert run(steps, a=a, b=b, v=v, s=v, w=word(a, 2), x=word(b, 5)) == meaning(a, b, v), (a, b, v)


@pytest.mark.parametrize("name", CALLS)
def test_steps_become_the_call(name):
    call = read(f"r_choice_9 := {CALLS[name][0]};")
    steps, _ = comparisons.unmade(call, VARIABLES)
    assert written(comparisons.made(steps, VARIABLES)) == written(call)


def test_values_of_several_steps_come_first(rng):
    """Random comparisons with variables for some of their bits, each where the lowering writes it."""
    for _ in range(200):
        low = rng.choice([0, 0, 1, 3])
        before = rng.choice(["false", "true"]) if low == 0 else rng.choice(["v", "not v", "s"])
        call = f"{rng.choice(['', 'not '])}is_larger(a, b, {low}, {low + rng.randint(1, 6)}, {before})"
        places = sorted(rng.sample(range(low, low + 6), 3))
        values = [f"x{place} := is_set({rng.choice('ab')}, {place});" for place in places]
        if before == "false" and rng.random() < 0.5:
            values.append("none := (b mod 4) = 0;")
        rng.shuffle(values)
        own = [f"known_{number} := is_set(c, {number});" for number in range(rng.randint(0, 2))]
        around = [f"r_choice_20 := {call};", f"y <= {rng.choice('uv')} or r_choice_20;"]
        presented = read("\n".join([*own, *values, *around]))
        steps, _ = comparisons.unmade(presented, VARIABLES)
        assert comparisons.unmade(comparisons.made(steps, VARIABLES), VARIABLES)[0] == steps
        text = written(steps)
        for place in places:
            value = next(number for number, line in enumerate(text) if line.startswith(f"x{place} :="))
            readers = [number for number, line in enumerate(text) if re.search(rf"\bx{place}\b", line)]
            assert readers[0] == value


STEPS = [
    "r_choice := inverted_carry(v, not is_set(a, 1), is_set(b, 1));",
    "r_choice_2 := carry(r_choice, not is_set(a, 2), is_set(b, 2));",
    "r_choice_3 := carry(r_choice_2, not is_set(a, 3), is_set(b, 3));",
]
KEPT = {
    "one step": STEPS[:1],
    "a step that is read twice": [*STEPS[:2], "y <= r_choice;"],
    "another operand": [STEPS[0], STEPS[1].replace("is_set(b, 2)", "is_set(c, 2)")],
    "a bit too far": [STEPS[0], STEPS[1].replace("is_set(b, 2)", "is_set(b, 3)")],
    "operands exchanged": [STEPS[0], "r_choice_2 := carry(r_choice, not is_set(b, 2), is_set(a, 2));"],
    "another function": [STEPS[0], STEPS[1].replace("carry", "choice")],
    "names without a count": [STEPS[0], STEPS[1].replace("r_choice_2", "other")],
    "a count left out": [STEPS[0], STEPS[1].replace("r_choice_2", "r_choice_5")],
    "a register in between": [STEPS[0], "y <= v;", STEPS[1]],
    "a value before the step that reads it": ["x2 := is_set(b, 2);", STEPS[0], STEPS[1].replace("is_set(b, 2)", "x2")],
}


@pytest.mark.parametrize("name", KEPT)
def test_what_is_left_alone(name):
    statements = read("\n".join(KEPT[name]))
    assert comparisons.made(statements, VARIABLES) == statements


def test_as_many_steps_as_belong_together():
    """Up to where the operands change."""
    other = "r_choice_4 := carry(r_choice_3, not is_set(c, 4), is_set(b, 4));"
    found = comparisons.made(read("\n".join([*STEPS, other])), VARIABLES)
    assert written(found) == ["r_choice_3 := not is_larger(a, b, 1, 3, v)", other.rstrip(";")]


BENCH = """entity bench is end entity;
architecture sim of bench is
{functions}
begin
  process
    variable is_right : boolean;
  begin
    for a in 0 to 15 loop
      for b in 0 to 15 loop
        for low in 0 to 3 loop
          for high in low to 3 loop
            for before in boolean loop
              if (a / 2 ** low) mod 2 ** (high - low + 1) = (b / 2 ** low) mod 2 ** (high - low + 1) then
                is_right := is_larger(a, b, low, high, before) = before;
              else
                is_right := is_larger(a, b, low, high, before) =
                  ((a / 2 ** low) mod 2 ** (high - low + 1) > (b / 2 ** low) mod 2 ** (high - low + 1));
              end if;
              assert is_right report "wrong" severity failure;
            end loop;
          end loop;
        end loop;
      end loop;
    end loop;
    report "all right";
    wait;
  end process;
end architecture;
"""


FAULTS = {
    "none": ("", ""),
    "equal ones": ("boolean := not before", "boolean := before"),
    "the first bit": ("in low to high", "in low + 1 to high"),
    "an operand": ("(b, place)", "(a, place)"),
    "their order": ("in low to high loop", "in 3 - high to 3 - low loop"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_function_of_the_vhdl(fault, tmp_path):
    """For all values."""
    need("ghdl", "GHDL")
    functions = bits.FUNCTION + carries.FUNCTION + comparisons.FUNCTION.replace(*FAULTS[fault])
    (tmp_path / "bench.vhd").write_text(BENCH.format(functions=functions))
    ghdl.analyse([tmp_path / "bench.vhd"], tmp_path)
    ghdl.elaborate(tmp_path, "bench")
    command = [find_ghdl(), "-r", ghdl.STANDARD, "bench"]
    answer = subprocess.run(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert ("all right" in answer.stdout and answer.returncode == 0) == (fault == "none"), answer.stdout
