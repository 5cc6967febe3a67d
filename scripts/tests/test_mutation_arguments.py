# SPDX-License-Identifier: Apache-2.0
"""What the arguments of flow/mutation/arguments.py rest on: VHDL with other values in the same places shows the same in
streams of many seeds. Values for which that is not so must be noticed."""

import re
from typing import NamedTuple

import pytest

from conftest import need
from flow.cosim import checker, vectors
from flow.cosim.simulators import CoreSimulation
from flow.mutation import arguments, judges, mutants
from flow.simulation.simulators import SIMULATORS
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars

SEEDS = range(1, 6)


@pytest.fixture(autouse=True)
def tools(ghdl):
    need("verilator", "VERILATOR")


RESET = "      if reset = '1' then\n"


class Change(NamedTuple):
    lines: dict[str, str]  # {pattern of a line: what stands there instead}
    at_reset: bool = False  # only in what a reset sets


def changed(text, changes):
    for change in changes:
        before, reset, rest = text.partition(RESET) if change.at_reset else ("", "", text)
        for pattern, new in change.lines.items():
            rest, count = re.subn(rf"(?m)^( +){pattern}$", rf"\1{new}", rest)
            assert count, pattern
        text = before + reset + rest
    return text


def shows(config, changes, work):
    """Whether streams of many seeds show a VHDL with all `changes`."""
    *others, file = scalars.files(manifest.core_files(config))
    work.mkdir()
    own = work / file.name
    own.write_text(changed(file.read_text(), changes))
    core = judges.Core(config)
    simulator = CoreSimulation(
        SIMULATORS["verilator"], config, [*others, own], work / "core", core.lanes, core.bits, kind=core.kind
    )
    simulator.build()
    for seed in SEEDS:
        stimulus, expected = core.stream(seed)
        simulator.run(stimulus, work / "observed.txt", lambda clock: None, judges.WATCHDOG_SECONDS)
        observed, _ = vectors.read_observed(work / "observed.txt")
        if not checker.compare(expected, observed, core.bits).passed:
            return True
    return False


def outside(search, reference):
    return Change(
        {r"(rows_search_\d+) <= 0;": rf"\2 <= {search};", r"(rows_reference_\d+) <= 0;": rf"\2 <= {reference};"}
    )


INSIDE = r"(delay_row_inside_{}) <= .*;"
FALLS = r"(forward_path_{}_value) := .*;"
FAR_OFF = r"forward_{}_\d+ <= 128;"
FAR = r"(forward_far_\d+_any) := .*;"
FIRST_DOWNWARD = Change({r"(\w*order_falls) <= false;": r"\2 <= true;"}, True)
ANY_PLACE = Change({r"(\w*turn_write_place) <= 0;": r"\2 <= 11;"}, True)
LAST_BELOW = r"(slice0winner1_best_below_0_2) <= slice0window_sum_0_{};"
NEXT_FRAME = r"(raster_place_next_frame_choice_2) := .*;"
BEGUN = Change(
    {"slice0window_centre_map_column_0 <= false;": "slice0window_centre_map_column_0 <= true;"},
    True,
)


def valid_at_reset(register):
    return Change({rf"({register})_valid <= false;": r"\2_valid <= true;"}, True)


# {configuration: {what the argument says: the change}}
SAME = {
    "tiny": {
        "rows outside, dark and bright": outside(7, 200),
        "a record in the clock of a reset": Change(
            {r"raster_features_valid <= false;": "raster_features_valid <= true;"},
        ),
    },
    "tiny_phase": {
        "a record in the clock of a reset": valid_at_reset(r"transform_filtering_\d|raster_features"),
        "a column in the clock of a reset": valid_at_reset(r"delay_tag|rows_\w*tag|slice0(?:shift|cost\w*|window)_tag"),
        "the first place": Change({r"(transform_write_column) <= 0;": r"\2 <= 11;"}, True),
        "a constant of all rows": Change(
            {
                r"(transform_\w+_column_outer) <= \((\d+) - (.*)": r"\2 <= (\3 + 1 - \4",
                r"(transform_\w+_column_upper) <= (\(?)(\d+) - (.*)": r"\2 <= \3\4 + 9 - \5",
            }
        ),
        "rows beside the image": Change({INSIDE.format("[0134]"): r"\2 <= true;"}),
        "a start while a next frame waits": Change({NEXT_FRAME: r"\2 := transform_filtering_7_valid;"}),
        "the neighbour of the last disparity": Change({LAST_BELOW.format(4): r"\2 <= 0;"}),
        "the neighbour of the first disparity": Change({r"(slice1winner1_best_below_0_0) <= 0;": r"\2 <= 475;"}),
    },
    "tiny_sgm": {
        "a column in the clock of a reset": valid_at_reset("entry_next_tag|slice0window_tag"),
        "a row that begins with a reset": BEGUN,
        "rows beside the map": Change({INSIDE.format(1): r"\2 <= true;"}),
        "the first row downward": FIRST_DOWNWARD,
        "the first place": ANY_PLACE,
    },
    "tiny_trellis": {
        "a column in the clock of a reset": valid_at_reset(r"slice0_tag_\d+"),
        "a row that begins with a reset": BEGUN,
        "records before a start": Change({r"raster_place_column <= 0;": "raster_place_column <= 20;"}, True),
        "the first row downward": FIRST_DOWNWARD,
        "the first place": ANY_PLACE,
        "the last state": Change({FALLS.format(11): r"\2 := false;"}),
        "what a row leaves": Change({FAR_OFF.format("occluding"): "null;"}),
        "the column before a row": Change({FAR: r"\2 := entry_tag_valid or (not forward_next_first);"}),
    },
}


def test_each_argument_speaks_of_a_fault():
    """One whose pattern fits no fault argues nothing."""
    argued = set()
    for config in SAME:
        for file in scalars.files(manifest.core_files(config)):
            argued |= {arguments.of(mutant) for mutant in mutants.mutants_of(file)}
    assert not [argument.test for argument in arguments.ARGUMENTS if argument not in argued]


@pytest.fixture(scope="module")
def noticed(tmp_path_factory):
    """The changes of a configuration that streams show. All are played at once; only where that shows, each alone."""
    found = {}

    def of(config):
        if config not in found:
            same, work = SAME[config], tmp_path_factory.mktemp(config)
            found[config] = set()
            if shows(config, same.values(), work / "together"):
                alone = {name for i, name in enumerate(same) if shows(config, [same[name]], work / str(i))}
                found[config] = alone or {*same}
        return found[config]

    return of


def test_rows_outside_may_have_any_grey_value(noticed, tmp_path):
    assert "rows outside, dark and bright" not in noticed("tiny")
    assert not shows("tiny", [outside(255, 0)], tmp_path / "extreme")


def test_rows_outside_may_not_where_a_check_compares_costs(tmp_path):
    assert shows("tiny_unique", [outside(255, 0)], tmp_path / "checked")


@pytest.mark.parametrize("config", ["tiny", "tiny_phase"])
def test_a_record_in_the_clock_of_a_reset_changes_nothing(noticed, config):
    assert "a record in the clock of a reset" not in noticed(config)


def test_a_start_in_the_clock_of_a_reset_does_not_count(tmp_path):
    start = {r"(transform_filtering_\d+_start_of_frame) <= false;": r"\2 <= true;"}
    assert not shows("tiny_phase", [Change(start, True)], tmp_path / "start")
    assert shows("tiny_phase", [Change(start, True), valid_at_reset(r"transform_filtering_\d")], tmp_path / "valid")


def test_a_pixel_that_is_not_held_back_as_long_as_the_others_shows(tmp_path):
    """Reading and writing do not move alike."""
    change = Change({r"delay_ring_read_address <= 1;": "delay_ring_read_address <= 2;"})
    assert shows("tiny", [change], tmp_path / "one")


@pytest.mark.parametrize("config", ["tiny_phase", "tiny_sgm", "tiny_trellis"])
def test_a_column_in_the_clock_of_a_reset_changes_nothing(noticed, config):
    assert "a column in the clock of a reset" not in noticed(config)


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis"])
def test_a_row_that_begins_with_a_reset_counts_as_none(noticed, config):
    assert "a row that begins with a reset" not in noticed(config)


def test_rows_that_count_show(tmp_path):
    counts = {rf"(entry_order_{flag}) <= false;": r"\2 <= true;" for flag in ("complete", "output")}
    assert shows("tiny_sgm", [Change(counts, True)], tmp_path / "one")


def test_records_before_a_start_may_have_any_column(noticed):
    assert "records before a start" not in noticed("tiny_trellis")


def test_rows_beside_the_map_may_have_any_cost(noticed):
    assert "rows beside the map" not in noticed("tiny_sgm")


def test_other_rows_beside_the_image_may_not(tmp_path):
    assert shows("tiny_sgm", [Change({INSIDE.format(2): r"\2 <= true;"})], tmp_path / "one")


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis"])
def test_the_first_row_may_be_turned_downward(noticed, config):
    assert "the first row downward" not in noticed(config)


@pytest.mark.parametrize("config", ["tiny_phase", "tiny_sgm", "tiny_trellis"])
def test_the_first_place_that_is_written_may_be_any(noticed, config):
    assert "the first place" not in noticed(config)


def test_the_last_state_never_falls(noticed):
    assert "the last state" not in noticed("tiny_trellis")


def test_the_state_below_falls(tmp_path):
    assert shows("tiny_trellis", [Change({FALLS.format(10): r"\2 := false;"})], tmp_path / "one")


def test_what_a_row_leaves_loses_against_the_next_one(noticed):
    assert "what a row leaves" not in noticed("tiny_trellis")


def test_how_a_row_has_fallen_does_not(tmp_path):
    assert shows("tiny_trellis", [Change({FAR_OFF.format("dropped"): "null;"})], tmp_path / "one")


def test_the_column_before_a_row_may_fall_anyhow(noticed):
    assert "the column before a row" not in noticed("tiny_trellis")


def test_other_columns_may_not_fall_anyhow(tmp_path):
    assert shows("tiny_trellis", [Change({FAR: r"\2 := false;"})], tmp_path / "one")


def test_a_constant_of_all_rows_falls_out(noticed):
    assert "a constant of all rows" not in noticed("tiny_phase")


def test_rows_beside_the_image_have_no_code(noticed):
    assert "rows beside the image" not in noticed("tiny_phase")


def test_no_start_of_frame_comes_while_a_next_frame_waits(noticed):
    assert "a start while a next frame waits" not in noticed("tiny_phase")


def test_the_first_and_the_last_disparity_may_have_any_neighbour(noticed):
    assert not {name for name in noticed("tiny_phase") if "neighbour" in name}


def test_other_values_of_the_transform_show(tmp_path):
    """A constant in one of the columns of such a sum, a row of the image as one outside, another neighbour."""
    column = {r"(transform_left_code_row_outer_2) <= (.*);": r"\2 <= (\3) + 9;"}
    row = {INSIDE.format(1): r"\2 <= false;"}
    neighbour = {r"(slice0winner1_best_below_0_1) <= slice0window_sum_0_2;": r"\2 <= 0;"}
    for number, lines in enumerate((column, row, neighbour)):
        assert shows("tiny_phase", [Change(lines)], tmp_path / str(number)), lines
