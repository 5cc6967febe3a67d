# SPDX-License-Identifier: Apache-2.0
"""Memory cells of a core as blocks, neighbours as one `for ... generate`, and back."""

import pytest

from flow.synthesis.presentation import memories
from flow.synthesis.presentation.words import split


def cell(place, address="column", depth=16):
    return memories.Memory(
        {
            "read_enable": ("true",),
            "read_address": tuple(split(f"to_unsigned({address}, 4)")),
            "write_address": tuple(split("to_unsigned(next_column, 4)")),
            "write_data": tuple(split(f"to_unsigned(words({place}), 8)")),
            "depth": (str(depth),),
            "width": ("8",),
            "address_bits": ("4",),
            "unit": ("line_memory_of_a_kit",),
            "read_data": tuple(split(f"held({place})")),
        }
    )


@pytest.mark.parametrize(
    ("cells", "count"),
    [
        ([cell(0), cell(1), cell(2)], 1),
        ([cell(2), cell(1), cell(0)], 1),
        ([cell(0), cell(1, "other")], 2),
        ([cell(0), cell(2), cell(3)], 2),  # every other one is no range of a `generate`
        ([cell(0), cell(1, depth=17)], 2),
    ],
)
def test_memories(cells, count):
    shown = memories.presented(cells, "i", {"held"}, {"taken"})
    assert sum(line.endswith((" generate", " : block")) and not line.startswith("  end") for line in shown) == count
    assert memories.back(["  ports <= 1;", "", *shown]) == (["  ports <= 1;", ""], cells)
    assert max(map(len, shown)) <= 120


def test_labels_of_memories_are_unique():
    cells = [cell(0), cell(1), cell(2, depth=17), cell(3, depth=17)]
    labels = [
        line.split()[0]
        for line in memories.presented(cells, "i", {"held"}, ())
        if " generate" in line and " : " in line
    ]
    assert labels == ["held_memory", "held_2_memory"]
    assert memories.presented(cells[:1], "i", {"held"}, {"held_0_memory"})[2] == "  held_0_memory_2 : block"


def test_names_of_generics_and_ports_are_read():
    """As cores had them before."""
    shown = "\n".join(memories.presented([cell(0)], "i", {"held"}, ()))
    names = ["depth", "width", "address_bits"]
    named = shown.replace("(16, 8, 4)", f"({', '.join(f'{a} => {b}' for a, b in zip(names, ('16', '8', '4')))})")
    ports = ", ".join(f"{name} => {name}" for name in ("clock", "read_address", "write_address", "write_data"))
    for named_ports in (ports, ", ".join(reversed(ports.split(", ")))):
        text = named.replace(
            "(clock, true, read_address, held(0), write_address, write_data)",
            f"(read_data => held(0), {named_ports}, read_enable => true)",
        )
        assert text.count("=>") == 9 and memories.back(text.splitlines())[1] == [cell(0)]
        for old, new in (("clock => clock", "clock => other"), ("read_enable => true", "enable => true")):
            with pytest.raises(ValueError, match="a memory is connected in another way"):
                memories.back(text.replace(old, new).splitlines())


def test_another_form_of_a_memory_stays():
    single = memories.in_words(cell(0), lambda words: ("held_0",) if words[0] == "held" else words)
    plain = memories.written(["  ports <= 1;", ""], [single])
    changed = [line.replace("clock => clock", "clock => other") for line in plain]
    assert memories.read(changed) == (changed, [])
    assert memories.read(plain, ["held", "column"])[1] == [single]
    assert memories.read(plain, ["write_data"]) == (plain, [])  # would be another signal in the block
