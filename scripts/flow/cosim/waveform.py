# SPDX-License-Identifier: Apache-2.0
"""The signals that matter at a mismatch: their groups, a save file for GTKWave, and a table for a page."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, TypedDict

from .vcd import Values
from .vectors import Seen

CORE = "tb_stereo_core.dut."
CPP = "cpp"  # the scope of the C++ core's registers in a dump
CLOCK_NS = 10
INTEGER_BITS = 32
FIRST_CLOCK_NS = 20  # after two clocks of reset
CLOCKS_BEFORE = 8  # in a page's table
CLOCKS_AFTER = 3
DIFFER = "registers that differ first"
_ZOOM = "-6.0"  # of GTKWave: some 30 clocks in its window
_HEXADECIMAL, _DECIMAL, _BINARY = "22", "24", "28"
_OPEN, _CLOSED = ("@800200", "@1000200"), ("@c00200", "@1401200")


class Group(NamedTuple):
    title: str
    pattern: str  # of the names in the core
    on_page: bool  # shown in the page's table
    is_open: bool  # in GTKWave


GROUPS = [
    Group("inputs", r"reset|start_of_frame|valid|left_pixel|right_pixel|node_\w+", True, True),
    Group(
        "outputs",
        r"disparity|pixel_valid|disparity_(valid|start_of_frame|end_of_line)|rectified_\w+",
        on_page=True,
        is_open=True,
    ),
    Group("place in the frame", r"(raster|sample)_place_(column|group)|raster_features_valid", True, True),
    Group(
        "winner's path: the best of each slice",
        r"slice\d+_best_(cost|index)_\d+_\d+|slice\d+_best_tag_valid",
        on_page=True,
        is_open=True,
    ),
    Group("after the winner", r"(refinement|leftright|texture|map)_\w+", False, False),
    Group("winner trees", r"slice\d+winner\d+_\w+", False, False),
    Group("window sums", r"slice\d+window_sum_\w+", False, False),
]


class ShownGroup(TypedDict):
    title: str
    signals: list[tuple[str, list[str]]]  # (name, value in each clock)


@dataclass(frozen=True)
class Table:
    simulator: str
    clock: int  # of the mismatch
    first: int  # clocks that the dump has
    last: int
    clocks: list[int]
    groups: list[ShownGroup]
    cpp: dict[str, list[str | None]]  # by name, in each clock: the value in C++ where that differs
    command: str


def start_ns(clock: int) -> int:
    """When a clock begins, and the bench reads the outputs."""
    return FIRST_CLOCK_NS + CLOCK_NS * clock


def _groups(values: Values) -> list[tuple[Group, list[str]]]:
    """Each group with the names that the dump has, without the empty ones."""
    core = [name for name in values.names if name.startswith(CORE)]
    found = [(group, [name for name in core if re.fullmatch(group.pattern, _short(name))]) for group in GROUPS]
    return [
        (group, sorted(names, key=_natural) if group.title.startswith("w") else names)
        for group, names in found
        if names
    ]


def _short(name: str) -> str:
    return name[len(CORE) :]


def _natural(name: str) -> list[int | str]:
    """slice10 after slice9."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def save_file(dump: Path, clock: int, differ: Sequence[str] = ()) -> str:
    """The text of a .gtkw for a dump, with a marker where the clock begins; first of all the registers that `differ`,
    each above its value in C++."""
    values = Values(dump)
    lines = [
        "[*] Made by scripts/cosim.py",
        f'[dumpfile] "{dump.name}"',
        f"[timestart] {max(start_ns(clock) - 18 * CLOCK_NS, 0)}",
        "[size] 1600 900",
        "[sst_width] 220",
        "[signals_width] 370",
        f"*{_ZOOM} {start_ns(clock)}" + " -1" * 26,
        "@28",
        f"{CORE}clock",
    ]
    if differ:
        lines += [_OPEN[0], f"-{DIFFER}, VHDL above C++"]
        for name in differ:
            base = _BINARY if values.bits(CORE + name) == 1 else _DECIMAL
            lines += [f"@{base}", values.label(CORE + name), values.label(f"{CPP}.{name}")]
        lines += [_OPEN[1], f"-{DIFFER}, VHDL above C++"]
    for group, names in _groups(values):
        begin, end = _OPEN if group.is_open else _CLOSED
        lines += [begin, f"-{group.title}"]
        for name in names:
            pixels = _short(name) in ("left_pixel", "right_pixel", "disparity")
            base = _HEXADECIMAL if pixels else _BINARY if values.bits(name) == 1 else _DECIMAL
            lines += [f"@{base}", values.label(name)]
        lines += [end, f"-{group.title}"]
    return "\n".join(lines) + "\n"


def table(
    dump: Path, clock: int, simulator: str, command: str, first: int, last: int, differ: Sequence[str] = ()
) -> Table:
    values = Values(dump)
    clocks = list(range(max(first, clock - CLOCKS_BEFORE), min(last, clock + CLOCKS_AFTER) + 1))

    def shown(name: str) -> list[str]:
        return [_shown(values.at(name, start_ns(c)), values.bits(name)) for c in clocks]

    groups: list[ShownGroup] = [
        {"title": group.title, "signals": [(_short(name), shown(name)) for name in names]}
        for group, names in _groups(values)
        if group.on_page
    ]
    if differ:
        groups.insert(0, {"title": DIFFER, "signals": [(name, shown(CORE + name)) for name in differ]})

    def other(name: str) -> list[str | None]:
        vhdl, cpp = shown(CORE + name), shown(f"{CPP}.{name}")
        return [there if there not in ("", here) else None for here, there in zip(vhdl, cpp)]

    both = [name for group in groups for name, _ in group["signals"] if f"{CPP}.{name}" in values.names]
    return Table(simulator, clock, first, last, clocks, groups, {name: other(name) for name in both}, command)


def _shown(value: Seen | None, bits: int) -> str:
    """Port words of several rows in hexadecimal, all else in decimal. Integers have 32 bits."""
    if not isinstance(value, int):
        return value or ""
    return f"{value:0{bits // 4}x}" if 8 < bits != 32 else str(value)


def output(dump: Path, clock: int) -> tuple[Seen | None, Seen | None]:
    """(disparity_valid, disparity) that the dump's core shows in a clock."""
    values = Values(dump)
    return values.at(CORE + "disparity_valid", start_ns(clock)), values.at(CORE + "disparity", start_ns(clock))
