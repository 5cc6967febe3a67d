# SPDX-License-Identifier: Apache-2.0
"""The digest of a netlist: names, comments and order do not count, everything else does."""

import re

import pytest

from flow.base import committed, rtl
from flow.base.errors import FlowError
from flow.synthesis.presentation import present
from flow.synthesis.presentation.present import expand
from flow.synthesis.structure import structure_digest
from flow_commands import call, refused

TINY = expand((committed.folder("tiny") / f"{rtl.core_entity('tiny')}.vhd").read_text())


def names():
    """Signals and variables of the text."""
    lists = re.findall(r"^ *(?:signal|variable) ([\w, ]+) :", TINY, re.MULTILINE)
    return sorted({name for words in lists for name in words.split(", ")})


def renamed(rng):
    """All signals under other names, which sort in another order."""
    old = names()
    numbers = rng.sample(range(10_000), len(old))
    new = {name: f"s{number}" for name, number in zip(old, numbers)}
    return re.sub(r"\w+", lambda match: new.get(match[0], match[0]), TINY)


def test_names_and_comments_do_not_count(rng):
    assert len(names()) > 100
    assert structure_digest(renamed(rng)) == structure_digest(TINY)
    assert structure_digest(TINY.replace("\n", "  -- a word\n")) == structure_digest(TINY)


CHANGES = {
    "an operator": (r"\+ ", "- "),
    "a constant": (r"([=+] )(\d+)\b", lambda m: f"{m[1]}{int(m[2]) + 1}"),
    "a width": (r"unsigned\((\d+) downto", lambda m: f"unsigned({int(m[1]) + 1} downto"),
    "an output": (r"disparity_end_of_line <= ", "disparity_end_of_line <= not "),
    "a swapped comparison": (r" < ", " >= "),
}


@pytest.mark.parametrize("change", CHANGES)
def test_every_change_counts(rng, change):
    pattern, replacement = CHANGES[change]
    body = TINY.index("architecture")
    places = [match for match in re.finditer(pattern, TINY) if match.start() > body]
    if not places:
        pytest.fail(f"the VHDL of tiny has no {pattern}")
    match = rng.choice(places)
    changed = TINY[: match.start()] + re.sub(pattern, replacement, match[0]) + TINY[match.end() :]
    assert changed != TINY and structure_digest(changed) != structure_digest(TINY), match[0]


def test_two_exchanged_registers_count(rng):
    """The same words, another wiring: the names that two statements assign to change places."""
    lines = TINY.split("\n")
    found = [(n, m) for n, line in enumerate(lines) if (m := re.fullmatch(r" *(slice0\w+_\d+_\d+) <= (.*);", line))]
    a, first = rng.choice(found)
    b, second = rng.choice([(n, m) for n, m in found if m[2] != first[2]])
    lines[a], lines[b] = lines[a].replace(first[2], second[2]), lines[b].replace(second[2], first[2])
    assert structure_digest("\n".join(lines)) != structure_digest(TINY)


@pytest.mark.parametrize(
    "before, after",
    [
        (", write_address, write_data);", ", read_address, write_data);"),
        (", write_address, write_data);", ", write_address, write_address);"),
        ("(clock, true", "(reset, true"),
        ("(clock, true, ", "(true, "),
        ("(32, 16, 5)", "(16, 5)"),
        (" map (clock, ", " map (clock => clock, "),
    ],
)
def test_a_memory_that_is_connected_in_another_way_is_no_known_form(before, after):
    """Of presented text: what every memory has is not read there, but written anew."""
    presented = present.present(TINY)
    assert structure_digest(presented) == structure_digest(TINY) and before in presented
    with pytest.raises(FlowError, match="unknown form of VHDL"):
        structure_digest(presented.replace(before, after, 1))


@pytest.mark.parametrize("text", ["", "entity", "library ieee;"])
def test_what_is_no_core_is_no_known_form(text):
    with pytest.raises(FlowError, match="unknown form of VHDL"):
        structure_digest(text)


def test_command_refuses():
    refused(call("compare_rtl.py", "--against", "nonsense"), 2, "nonsense is no commit")
