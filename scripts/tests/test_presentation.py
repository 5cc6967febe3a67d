# SPDX-License-Identifier: Apache-2.0
"""Arrays, loops and tests of bits in the VHDL: they stand for what the lowering wrote, word for word."""

import contextlib
import re
from dataclasses import replace

import pytest

from cover import COVERED, clocks, cover, rows, with_slow
from flow.base import committed
from flow.base.errors import FlowError
from flow.synthesis import manifest
from flow.synthesis.lowering.vhdl_text import type_of
from flow.synthesis.presentation import arrays, bits, comparisons, core, loops, scalars, tree
from flow.synthesis.presentation.present import expand, present
from flow.synthesis.presentation.words import joined, split
from flow.synthesis.structure import structure_digest

FAST = ["tiny", "tiny_sgm"]
# Every option of every family, and a core that people take of each. Whether the others stand for what was made,
# test_manifest.py asks of each.
MADE = {name: row for name, row in rows().items() if name in committed.known_designs()}
SMALL = {name: row for name, row in MADE.items() if row.use in (*COVERED, "tiny")}
LARGE = {name: row for name, row in MADE.items() if row.use in ("paper", "system")}
CASES = sorted(
    {
        *FAST,
        *cover(SMALL),
        *cover(LARGE, lambda row: {row.family}, clocks),
    }
)


def text_of(name):
    return (committed.folder(name) / f"{committed.entity(name)}.vhd").read_text()


@pytest.mark.parametrize("name", with_slow(CASES, FAST))
def test_committed(name):
    """It is presented as it is now done, and stands for the design that was made."""
    text = text_of(name)
    scalar = expand(text)
    assert not re.search(rf"\bloop\b| is array |\b({bits.NAME}|{comparisons.NAME})\b", scalar)
    assert present(scalar) == text == present(text)
    assert structure_digest(scalar) == manifest.read(committed.folder(name))["structure"]


@pytest.mark.parametrize("name", FAST)
def test_the_order_of_variables_does_not_count(rng, name):
    """Bambu's is not that of presented VHDL that is presented again."""
    scalar = core.read(expand(text_of(name)))
    assert len(scalar.variables) > 1
    names = [core.Names(one.kind, [variable]) for one in scalar.variables for variable in one.names]
    rng.shuffle(names)
    assert present(core.text(replace(scalar, variables=names))) == text_of(name)


def changed_number(rng, text, pattern):
    """With one of the numbers that `pattern` finds one higher."""
    match = rng.choice(list(re.finditer(pattern, text)))
    return f"{text[: match.start(1)]}{int(match[1]) + 1}{text[match.end(1) :]}"


CHANGES = {
    "the first turn of a loop": r"for \w in (\d+) to",
    "the last turn": r"for \w in \d+ to (\d+)",
    "an index": r"\(\w [+-] (\d+)",
    "an index outside a loop": r"\w\((\d+)\) <=",
    "a bit": r"is_set\([^()]*(?:\([^()]*\))?, (\d+)\)",
    "the first bit of a comparison": r"is_larger\([^;]*, (\d+), \d+, ",
    "the last bit": r"is_larger\([^;]*, \d+, (\d+), ",
    "the bounds of an array": r"_\dd\(\d+ to (\d+)",
    "the type of elements": r"array \(natural range <>\) of natural range 0 to (\d+)",
    "the function for bits": r"/ (2) \*\* place",
}


@pytest.mark.parametrize("times", with_slow([1, 5], [1]))
@pytest.mark.parametrize("change", CHANGES)
def test_every_change_counts(rng, change, times):
    text = text_of("tiny_sgm")
    made = structure_digest(text)
    for _ in range(1 if change == "the function for bits" else times):
        with contextlib.suppress(FlowError):  # the change leaves an array
            assert structure_digest(changed_number(rng, text, CHANGES[change])) != made


def test_what_is_presented_wrongly_is_refused(monkeypatch):
    """A fault in the folding."""
    scalar = expand(text_of("tiny_sgm"))
    fold = loops._loop
    monkeypatch.setattr(loops, "_loop", lambda body, turns, steps: fold(body, turns - 1, steps))
    with pytest.raises(FlowError, match="does not expand to what was written|unknown form of VHDL"):
        present(scalar)


def random_statements(rng):
    """Runs with steps, around and inside each other."""

    def run(depth):
        steps, start = [rng.randint(-3, 3) for _ in range(3)], [rng.randint(20, 30) for _ in range(3)]
        shape = rng.choice(
            ["a ( {} ) <= b ( {} , {} )", "a ( {} ) <= w ( {} downto {} ) + 1", "x := ( y + {} ) * c - {} + f ( {} )"]
        )
        for turn in range(rng.randint(1, 7)):
            numbers = [first + turn * step for first, step in zip(start, steps)]
            if depth and rng.random() < 0.4:
                words = f"is_set ( x , {numbers[0]} )".split()
                yield tree.If(tuple(words), tuple(run(depth - 1)), rng.choice([None, tuple(run(depth - 1))]))
            yield tree.Assign(tuple(shape.format(*numbers).split()))

    return [one for _ in range(rng.randint(1, 6)) for one in run(2)]


def test_loops_unroll_to_what_they_were_made_of(rng):
    made = 0
    for _ in range(300):
        statements = random_statements(rng)
        folded = loops.fold(statements, set())
        text = "\n".join(tree.lines(folded, ""))
        assert loops.unroll(tree.read(split(text))) == tuple(statements), text
        made += text.count("loop") > 0
    assert made > 100


def test_a_slice_keeps_its_width():
    """Both ends with the same step: else its width would change from turn to turn."""
    grows = [tree.Assign(("a", "(", str(n), ")", "<=", "w", "(", str(2 * n), "downto", str(n), ")")) for n in range(9)]
    assert loops.fold(grows, set()) == tuple(grows)


def test_bits_of_every_type():
    for width in (2, 5, 31):
        kinds = {"x": type_of(0, (1 << width) - 1), "signed": type_of(-1, (1 << width) - 2)}
        for place in range(width):
            top = place == width - 1
            inner = "x mod 2" if place == 0 else f"x / {1 << place}" if top else f"(x / {1 << place}) mod 2"
            for outer in ("{}", "not ({})", "a and ({})", "as_number(({}))"):
                words = tuple(split(outer.format(f"({inner}) = 1")))
                said = bits.named(words, kinds)
                assert bits.arithmetic(said, kinds) == words
                if width == 31 and place < 30 or outer == "{}":
                    assert f"is_set(x, {place})" in joined(said)
    for other in ("(x / 3) = 1", "((x / 4) mod 4) = 1", "(signed / 4) = 1"):
        assert bits.named(tuple(split(other)), kinds) == tuple(split(other))
    assert joined(bits.named(tuple(split("to_integer(w(3 downto 3)) = 1")), {})) == "w(3) = '1'"


def test_arrays_have_no_holes_and_one_type():
    byte, flag = (type_of(0, 255), "process"), (type_of(0, 1), "process")
    names = {f"a_{x}_{y}": byte for x in range(3) for y in range(4)} | {"a_3_0": flag, "b_1": byte, "b_3": byte}
    names |= {f"c_{x}_sum": byte if x < 2 else flag for x in range(4)} | {"c_sum": byte, "d_01": byte, "d_02": byte}
    names |= {"other": byte} | {f"other_{x}": byte for x in range(3)}
    names |= {f"e_{x}_{y}": byte for x in (0, 2, 4) for y in (3, 6)} | {"f_1": byte, "f_3": byte, "f_5": byte}
    found = {(one.name, one.pattern, one.kind[0], one.ranges) for one in arrays.found_in(names, set(names))}
    assert found == {
        ("a", "a_#_#", byte[0], ((0, 2), (0, 3))),
        ("c_sums", "c_#_sum", byte[0], ((0, 1),)),
        ("c_sums_from_2", "c_#_sum", flag[0], ((2, 3),)),
        ("e_3", "e_2#_3", byte[0], ((0, 2),)),
        ("e_6", "e_2#_6", byte[0], ((0, 2),)),
        ("others_from_0", "other_#", byte[0], ((0, 2),)),  # `others` is a word of VHDL
    }


def test_copies_for_tools_that_name_registers(tmp_path):
    files = manifest.core_files("tiny")
    copies = scalars.files(files)
    assert [path.name for path in copies] == [path.name for path in files] and copies[0] == files[0]
    assert copies[1] != files[1] and copies[1].read_text() == expand(files[1].read_text())
    edited = tmp_path / files[1].name
    edited.write_text(files[1].read_text().replace("end loop;", "end case;", 1))
    assert scalars.files([edited]) == [edited]
