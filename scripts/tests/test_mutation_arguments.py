# SPDX-License-Identifier: Apache-2.0
"""What the arguments of flow/mutation/arguments.py rest on: VHDL with other values in the same places shows the same in
streams of many seeds. Values for which that is not so must be noticed."""

import re

import pytest

from conftest import need
from flow.cosim import checker, vectors
from flow.cosim.simulators import CoreSimulation
from flow.mutation import judges
from flow.simulation.simulators import SIMULATORS
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars

SEEDS = range(1, 6)


@pytest.fixture(autouse=True)
def tools(ghdl):
    need("verilator", "VERILATOR")


def shows_the_same(config, changes, work):
    """`changes`: {pattern of a line: what stands there instead}."""
    *others, file = scalars.files(manifest.core_files(config))
    text = file.read_text()
    for pattern, new in changes.items():
        text, count = re.subn(rf"(?m)^( +){pattern}$", rf"\1{new}", text)
        assert count, pattern
    work.mkdir()
    changed = work / file.name
    changed.write_text(text)
    core = judges.Core(config)
    simulator = CoreSimulation(
        SIMULATORS["verilator"], config, [*others, changed], work / "core", core.lanes, core.bits, kind=core.kind
    )
    simulator.build()
    for seed in SEEDS:
        stimulus, expected = core.stream(seed)
        simulator.run(stimulus, work / "observed.txt", lambda clock: None, judges.WATCHDOG_SECONDS)
        observed, _ = vectors.read_observed(work / "observed.txt")
        if not checker.compare(expected, observed, core.bits).passed:
            return False
    return True


def outside(search, reference):
    return {r"(rows_search_\d+) <= 0;": rf"\2 <= {search};", r"(rows_reference_\d+) <= 0;": rf"\2 <= {reference};"}


@pytest.mark.parametrize("search, reference", [(255, 0), (7, 200)])
def test_rows_outside_may_have_any_grey_value(tmp_path, search, reference):
    assert shows_the_same("tiny", outside(search, reference), tmp_path / "tiny")


def test_rows_outside_may_not_where_a_check_compares_costs(tmp_path):
    assert not shows_the_same("tiny_unique", outside(255, 0), tmp_path / "checked")


def test_a_record_in_the_clock_of_a_reset_changes_nothing(tmp_path):
    assert shows_the_same(
        "tiny", {r"raster_features_valid <= false;": "raster_features_valid <= true;"}, tmp_path / "one"
    )


def test_a_pixel_that_is_not_held_back_as_long_as_the_others_shows(tmp_path):
    """Reading and writing do not move alike."""
    assert not shows_the_same(
        "tiny", {r"delay_ring_read_address <= 1;": "delay_ring_read_address <= 2;"}, tmp_path / "one"
    )
