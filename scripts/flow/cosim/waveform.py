# SPDX-License-Identifier: Apache-2.0
"""The signals that matter at a mismatch: their groups, a save file for GTKWave, and a table for a page."""

import re
from dataclasses import dataclass

from .vcd import Values

CORE = "tb_stereo_core.dut."
CLOCK_NS = 10
FIRST_CLOCK_NS = 20  # after two clocks of reset
CLOCKS_BEFORE = 8  # in a page's table
CLOCKS_AFTER = 3
_ZOOM = "-6.0"  # of GTKWave: some 30 clocks in its window
_HEXADECIMAL, _DECIMAL, _BINARY = "22", "24", "28"
_OPEN, _CLOSED = ("@800200", "@1000200"), ("@c00200", "@1401200")

# (title, pattern of the names in the core, shown in the page's table, open in GTKWave)
GROUPS = [
    ("inputs", r"reset|start_of_frame|valid|left_pixel|right_pixel", True, True),
    ("outputs", r"disparity|pixel_valid|disparity_(valid|start_of_frame|end_of_line)", True, True),
    ("place in the frame", r"raster_(column|group|valid)", True, True),
    ("winner's path: the best of each slice", r"slice\d+best_(cost|index)_\d+_\d+|slice\d+best_tag_valid", True, True),
    ("after the winner", r"(refinement|leftright|texture|median)_\w+", False, False),
    ("winner trees", r"slice\d+winner\d+_\w+", False, False),
    ("window sums", r"slice\d+window_sum_\w+", False, False),
]


@dataclass(frozen=True)
class Table:
    simulator: str
    clock: int  # of the mismatch
    first: int  # clocks that the dump has
    last: int
    clocks: list
    groups: list  # {"title", "signals": [(name, values)]}
    command: str


def start_ns(clock):
    """When a clock begins, and the bench reads the outputs."""
    return FIRST_CLOCK_NS + CLOCK_NS * clock


def _groups(values):
    """[(group of GROUPS, names that the dump has)], without the empty ones."""
    core = [name for name in values.names if name.startswith(CORE)]
    found = [(group, [name for name in core if re.fullmatch(group[1], name[len(CORE) :])]) for group in GROUPS]
    return [
        (group, sorted(names, key=_natural) if group[0].startswith("w") else names) for group, names in found if names
    ]


def _natural(name):
    """slice10 after slice9."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def save_file(dump, clock):
    """The text of a .gtkw for a dump, with a marker where the clock begins."""
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
    for (title, _, _, is_open), names in _groups(values):
        begin, end = _OPEN if is_open else _CLOSED
        lines += [begin, f"-{title}"]
        for name in names:
            short = name[len(CORE) :]
            pixels = short in ("left_pixel", "right_pixel", "disparity")
            lines += [
                f"@{_HEXADECIMAL if pixels else _BINARY if values.bits(name) == 1 else _DECIMAL}",
                values.label(name),
            ]
        lines += [end, f"-{title}"]
    return "\n".join(lines) + "\n"


def table(dump, clock, simulator, command, first, last):
    values = Values(dump)
    clocks = list(range(max(first, clock - CLOCKS_BEFORE), min(last, clock + CLOCKS_AFTER) + 1))
    groups = []
    for (title, _, on_page, _), names in _groups(values):
        if on_page:
            groups.append(
                {
                    "title": title,
                    "signals": [
                        (name[len(CORE) :], [_shown(values.at(name, start_ns(c)), values.bits(name)) for c in clocks])
                        for name in names
                    ],
                }
            )
    return Table(simulator, clock, first, last, clocks, groups, command)


def _shown(value, bits):
    """Port words of several rows in hexadecimal, all else in decimal. Integers have 32 bits."""
    if value is None or value == "X":
        return value or ""
    return f"{value:0{bits // 4}x}" if 8 < bits != 32 else str(value)


def output(dump, clock):
    """(disparity_valid, disparity) that the dump's core shows in a clock."""
    values = Values(dump)
    return values.at(CORE + "disparity_valid", start_ns(clock)), values.at(CORE + "disparity", start_ns(clock))
