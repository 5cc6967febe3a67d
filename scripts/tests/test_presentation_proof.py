# SPDX-License-Identifier: Apache-2.0
"""The presented VHDL and what the lowering wrote are proved to show the same for ever: what the words stand for is the
same hardware, too."""

import pytest

from conftest import need
from cover import with_slow
from flow.base import committed
from flow.mutation import equivalence
from flow.mutation.equivalence import Design
from flow.synthesis import manifest
from flow.synthesis.presentation.present import expand, present

FAST = ["tiny"]
# Arrays with places for more: from the third on; comparisons in steps: of numbers, from false and from true, of words.
# The last one has counts of differing bits.
CASES = [
    "tiny",
    "tiny_p2",
    "tiny_f2",
    "tiny_sgm_f5_forward",
    "tiny_median",
    "tiny_sgm_f6_relief_rows",
    "tiny_census_9x7",
]


@pytest.fixture(scope="module", autouse=True)
def _tools():
    for tool, variable in (("ghdl", "GHDL"), ("yosys", "YOSYS"), ("yosys-abc", "YOSYS_ABC")):
        need(tool, variable)


def scalar_of(name):
    return expand((committed.folder(name) / f"{committed.entity(name)}.vhd").read_text())


def graph_of(name, text, work):
    """Of the core with this text."""
    work.mkdir()
    core = work / f"{committed.entity(name)}.vhd"
    core.write_text(text)
    files = [core if path.name == core.name else path for path in manifest.core_files(name)]
    return equivalence.graph(Design(name, True), files, [], work / "graph")


@pytest.mark.parametrize("name", with_slow(CASES, FAST))
def test_it_is_the_same_hardware(name, tmp_path):
    scalar = scalar_of(name)
    graphs = [graph_of(name, text, tmp_path / part) for part, text in (("scalar", scalar), ("new", present(scalar)))]
    assert equivalence.compare(*graphs, tmp_path) == ""


FAULTS = {
    "the function of choices": ("    if test then\n      return yes;", "    if test then\n      return no;"),
    "a field of a tag": ("slice0cost_tag.valid", "slice0cost_tag.border_column"),
    "the copy of a tag": ("slice0cost_tag <= slice0cost_pair_tag;", "slice0cost_tag <= slice0shift_tag;"),
}


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["the function of choices"]))
def test_what_stands_for_something_else_is_found(fault, tmp_path):
    """Whether or not it goes back to what the lowering wrote."""
    scalar = scalar_of("tiny")
    text = present(scalar)
    assert FAULTS[fault][0] in text
    graphs = [
        graph_of("tiny", changed, tmp_path / part)
        for part, changed in (("scalar", scalar), ("wrong", text.replace(*FAULTS[fault])))
    ]
    assert "differs" in equivalence.compare(*graphs, tmp_path)
