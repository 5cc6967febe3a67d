# SPDX-License-Identifier: Apache-2.0
"""Words that a memory reads in the clock in which it writes them.

yosys leaves them open where a memory has the attribute no_rw_check. There are such words: in block matching and folded
semi-global matching those of bubbles, which nobody looks at, so they get the attribute; in semi-global matching of one
clock a pixel pair some that decide the result."""

import pytest

from cover import fast, with_slow
from flow.base import rtl
from flow.base.configurations import configuration, configurations
from flow.cosim import checker, vectors
from flow.cosim.simulators import Ghdl
from flow.implementation import yosys
from flow.implementation.targets import TARGETS
from flow.synthesis import manifest
from flow_commands import scene, stream

READ = "          word <= memory(to_integer(read_address));\n"
OTHER = f"{READ}          if {{}} then\n  {READ.replace('<= ', '<= not ')}          end if;\n"
SAME_CLOCK = "read_address = write_address"
LOOKING_AT_NONE = sorted(
    name
    for name, row in configurations().items()
    if yosys.looks_at_no_word_being_written(row) and row["use"] in ("tiny", "option")
)


def agrees(config, folder, wrong):
    """Whether the core answers to two frames with bubbles as the C++ core does although its memories read other words
    where `wrong` is true."""
    stream(folder, config, scene(folder / "pair", config), "--frames", 2, "--stall-percent", 25)
    cell = folder / "line_memory.vhd"
    text = rtl.MEMORY_CELL.read_text()
    assert READ in text
    cell.write_text(text.replace(READ, OTHER.format(wrong)))
    row = configuration(config)
    files = [cell if path == rtl.MEMORY_CELL else path for path in manifest.core_files(config)]
    simulator = Ghdl(
        config, files, folder / "simulation", row["pixels_per_clock"], row["disparity_bits"], kind=rtl.kind_of(row)
    )
    simulator.build()
    simulator.run(folder / "stimulus.txt", folder / "observed.txt", lambda clock: None, 100)
    expected, _ = vectors.read_expected(folder / "expected.txt")
    seen, _ = vectors.read_observed(folder / "observed.txt")
    return checker.compare(expected, seen, vectors.row_bits(row), "disparity").passed


@pytest.mark.parametrize("config", with_slow(LOOKING_AT_NONE, fast() & {*LOOKING_AT_NONE}))
def test_some_cores_look_at_none(ghdl, tmp_path, config):
    assert agrees(config, tmp_path, SAME_CLOCK)


def test_wrong_words_are_seen(ghdl, tmp_path):
    """Of the clock in which the address before was written."""
    assert not agrees("tiny", tmp_path, "read_address = write_address + 1")


def test_semi_global_matching_looks_at_some(ghdl, tmp_path):
    assert not agrees("tiny_sgm", tmp_path, SAME_CLOCK)


def attribute_of(config, core=""):
    return yosys.memories_without_bypass(configuration(config), core)


@pytest.mark.parametrize("family", {target.family for target in TARGETS.values()}, ids=lambda family: family.name)
def test_only_they_get_the_attribute(family):
    assert not any(attribute_of(name) for name in ("tiny_sgm", "tiny_trellis", "tiny_phase"))
    assert "no_rw_check" not in yosys.script(family) and "no-rw-check" not in family.synthesis
    assert "setattr -set no_rw_check 1" in yosys.script(family, attribute_of("tiny"))
    assert attribute_of("tiny_sgm_f4", "core.") == f"m:core.{yosys.LINE_MEMORIES}"
