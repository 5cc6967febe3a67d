#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which configurations the fast set of the tests takes: those that tests name, and a few that stand for all others, as
they have every option together. CMake asks for the list, as it builds the cores of these. Run as a program, it prints
their names, with ; between them."""

import math
import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
TABLES = ("hls/*/configurations.hpp", "hls_tb/*/*/configurations.hpp")
# Tests, and the table of camera systems, which tests take by the systems' names.
TESTS = ("scripts/tests/test_*.py", "hls_tb/**/*_test.py", "hls_tb/**/*_test.cpp", "scripts/flow/system/template.py")
# The uses of which a part stands for all; `study` repeats the options at one size, and the slow set takes the others,
# which are large or have no VHDL: of them tests read figures only.
COVERED, LEFT_OUT = ("option", "example"), ("study", "system", "planned")
# Tests that take pages, VHDL and fast models of what they name, but no C++ core: one that does says which is not built.
WITHOUT_CORES = {
    "stereo_hls_configurations_test",
    "test_boards",
    "test_example",
    "test_explore",
    "test_explore_truth",
    "test_features",
    "test_kit_vhdl",
    "test_mutation_families",
    "test_packaging",
    "test_reference",
    "test_report",
    "test_tied_settings",
    "vector_files_test",
}
BY_VALUE = {"pixels_per_clock"}  # numbers that are choices
_ROW = re.compile(r"^STEREO_ROW\((\w+), (\w+), ([\w():]+?)(?:,(.*?))?\);", re.MULTILINE | re.DOTALL)


class Row(NamedTuple):
    """Of a table of configurations, as its text says."""

    family: str
    use: str
    options: dict[str, str]  # those of its base with its own


def rows():
    """{name: Row}"""
    found = {}
    for table in (path for pattern in TABLES for path in sorted(ROOT.glob(pattern))):
        for name, use, base, text in _ROW.findall(table.read_text()):
            inherited = found[base].options if base in found else {}
            own = dict(re.findall(r"(\w+) = ([^,]+?)\s*(?:,|$)", text))
            found[name] = Row(table.parent.name, use, inherited | own)
    return found


def choices(row):
    """What of a configuration a test should meet: each option that it names, of a number whatever it is."""
    numbers = {name for name, value in row.options.items() if value.lstrip("-").isdigit() and name not in BY_VALUE}
    return {(row.family, name, "" if name in numbers else value) for name, value in row.options.items()}


def options(row):
    """The options that it names, whatever its family."""
    return {*row.options}


def clocks(row):
    """Of a frame, about."""
    return math.prod(
        int(row.options[name]) for name in ("width_px", "height_px", "clocks_per_pixel") if name in row.options
    )


def cover(table, met=choices, cost=lambda row: 1, others=()):
    """The names of so few rows as a greedy choice finds, each time the one with most of what is left for its cost.
    `met`: what a test should meet; `others`: rows that it takes anyway."""
    left, chosen = set().union(*map(met, table.values())).difference(*map(met, others)), []
    while left:
        chosen.append(max(sorted(table), key=lambda name: len(met(table[name]) & left) / cost(table[name])))
        left -= met(table[chosen[-1]])
    return chosen


def fast():
    """The configurations whose C++ cores the fast set tests, but for those that single tests name."""
    table = rows()
    covered = {name: row for name, row in table.items() if row.use in COVERED}
    return {name for name, row in table.items() if row.use not in (*COVERED, *LEFT_OUT)} | {*cover(covered)}


def simulated():
    """Those of them whose VHDL it simulates: the smallest ones, of each family one, and every option of block matching,
    whose VHDL simulators run fastest."""
    tested = fast()
    table = {name: row for name, row in rows().items() if name in tested and row.use in (*COVERED, "tiny")}
    smallest = {name: row for name, row in table.items() if row.use == "tiny"}
    for family in {row.family for row in table.values()} - {row.family for row in smallest.values()}:
        of_family = [name for name, row in table.items() if row.family == family]
        name = min(of_family, key=lambda name: (clocks(table[name]), len(table[name].options), name))
        smallest[name] = table[name]
    block_matching = {name: row for name, row in table.items() if row.family == "block_matching"}
    return {*smallest, *cover(block_matching, options, lambda row: math.sqrt(clocks(row)), smallest.values())}


def named():
    """The configurations whose cores tests take that name them."""
    paths = [path for pattern in TESTS for path in sorted(ROOT.glob(pattern))]
    texts = [path.read_text() for path in paths if path.stem not in WITHOUT_CORES]
    words = {word for text in texts for word in re.findall(r"[\"'](\w+)[\"']", text)}
    return {name for name, row in rows().items() if name in words and row.use not in LEFT_OUT}


def with_slow(values, fast_ones):
    """Parameters of a test, a tuple where it has several: those that are not in `fast_ones` run in the slow set."""
    import pytest  # CMake may have a Python without it

    assert all(value in values for value in fast_ones), "what is not there is no guard"

    def slow(value):
        return pytest.param(*(value if isinstance(value, tuple) else (value,)), marks=pytest.mark.slow)

    return [value if value in fast_ones else slow(value) for value in values]


if __name__ == "__main__":
    print(";".join(sorted(fast() | named())), end="")
