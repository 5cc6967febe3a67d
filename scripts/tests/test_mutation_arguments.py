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


RESET = "      if reset = '1' then\n"


def shows_the_same(config, changes, work, at_reset=False):
    """`changes`: {pattern of a line: what stands there instead}; `at_reset`: only in what a reset sets."""
    *others, file = scalars.files(manifest.core_files(config))
    before, reset, text = file.read_text().partition(RESET) if at_reset else ("", "", file.read_text())
    for pattern, new in changes.items():
        text, count = re.subn(rf"(?m)^( +){pattern}$", rf"\1{new}", text)
        assert count, pattern
    work.mkdir()
    changed = work / file.name
    changed.write_text(before + reset + text)
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


@pytest.mark.parametrize(
    "config, register", [("tiny_sgm", "entry_next_tag|slice0window_tag"), ("tiny_trellis", r"slice0_tag_\d+")]
)
def test_a_column_in_the_clock_of_a_reset_changes_nothing(config, register, tmp_path):
    change = {rf"({register})_valid <= false;": r"\2_valid <= true;"}
    assert shows_the_same(config, change, tmp_path / "one", at_reset=True)


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis"])
def test_a_row_that_begins_with_a_reset_counts_as_none(config, tmp_path):
    begun = "slice0window_centre_map_column_0 <= true;"
    assert shows_the_same(config, {begun.replace("true", "false"): begun}, tmp_path / "one", at_reset=True)


def test_rows_that_count_show(tmp_path):
    counts = {rf"(entry_order_{flag}) <= false;": r"\2 <= true;" for flag in ("complete", "output")}
    assert not shows_the_same("tiny_sgm", counts, tmp_path / "one", at_reset=True)


def test_records_before_a_start_may_have_any_column(tmp_path):
    change = {r"raster_place_column <= 0;": "raster_place_column <= 20;"}
    assert shows_the_same("tiny_trellis", change, tmp_path / "one", at_reset=True)


INSIDE = r"(delay_row_inside_{}) <= .*;"


def test_rows_beside_the_map_may_have_any_cost(tmp_path):
    assert shows_the_same("tiny_sgm", {INSIDE.format(1): r"\2 <= true;"}, tmp_path / "one")


def test_other_rows_beside_the_image_may_not(tmp_path):
    assert not shows_the_same("tiny_sgm", {INSIDE.format(2): r"\2 <= true;"}, tmp_path / "one")


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis"])
def test_the_first_row_may_be_turned_downward(config, tmp_path):
    change = {r"(\w*order_falls) <= false;": r"\2 <= true;"}
    assert shows_the_same(config, change, tmp_path / "one", at_reset=True)


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis"])
def test_the_first_place_that_is_written_may_be_any(config, tmp_path):
    change = {r"(\w*turn_write_place) <= 0;": r"\2 <= 11;"}
    assert shows_the_same(config, change, tmp_path / "one", at_reset=True)


FALLS = r"(forward_path_{}_value) := .*;"


def test_the_last_state_never_falls(tmp_path):
    assert shows_the_same("tiny_trellis", {FALLS.format(11): r"\2 := false;"}, tmp_path / "one")


def test_the_state_below_falls(tmp_path):
    assert not shows_the_same("tiny_trellis", {FALLS.format(10): r"\2 := false;"}, tmp_path / "one")


FAR_OFF = r"forward_{}_\d+ <= 128;"


def test_what_a_row_leaves_loses_against_the_next_one(tmp_path):
    assert shows_the_same("tiny_trellis", {FAR_OFF.format("occluding"): "null;"}, tmp_path / "one")


def test_how_a_row_has_fallen_does_not(tmp_path):
    assert not shows_the_same("tiny_trellis", {FAR_OFF.format("dropped"): "null;"}, tmp_path / "one")


FAR = r"(forward_far_\d+_any) := .*;"


def test_the_column_before_a_row_may_fall_anyhow(tmp_path):
    value = "entry_tag_valid or (not forward_next_first)"
    assert shows_the_same("tiny_trellis", {FAR: rf"\2 := {value};"}, tmp_path / "one")


def test_other_columns_may_not_fall_anyhow(tmp_path):
    assert not shows_the_same("tiny_trellis", {FAR: r"\2 := false;"}, tmp_path / "one")
