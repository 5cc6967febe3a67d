# SPDX-License-Identifier: Apache-2.0
"""Faults put into copies of the VHDL must be caught: a co-simulation that cannot fail proves nothing."""

import signal
import subprocess
import time
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

from cover import with_slow
from flow.base import places
from flow.base.tools import ROOT
from flow_commands import altered_rtl, call, cosim, random_pair, report

FAULTS = {
    "constant: one row too many": (r"raster_place_group = 11", "raster_place_group = 10"),
    "constant: ring one shorter": (r"if delay_ring_read_address = 7 then", "if delay_ring_read_address = 6 then"),
    "operator: sum becomes difference": (r"(slice1window_sum_0_1 <= \S+) \+ ", r"\1 - "),
    "operator: smaller becomes smaller or equal": (
        r"(slice0winner1_of_pair_0_0_is_less := \(slice0window_sum_\d_\d - slice0window_sum_\d_\d\)) < ",
        r"\1 <= ",
    ),
    "register dropped": (r"^ *slice1window_partial_0_0_2 <= .*;$", ""),
    "register bypassed": (
        r"(slice0window_tag_end_of_line <= )slice0window_centre_end_of_line_0;",
        r"\1slice0cost_tag_end_of_line;",
    ),
    "index: the neighbour's pixel": (
        r"slice0shift_search_1_0 <= slice0shift_search_1_1;",
        "slice0shift_search_1_0 <= slice0shift_search_1_2;",
    ),
    "condition inverted": (r"if rows_ready_tag_valid then", "if not rows_ready_tag_valid then"),
    "a carry lost": (r"as_number\(slice0cost_negative_0_1\) \+", "0 +"),
    "one winner's place wrong": (
        r"(slice2_best_index_0_0 <= )slice1_best_index_0_0;",
        r"\g<1>slice1_best_index_0_0 / 2;",
    ),
}


# Faults of the control, which only a broken stream shows.
BROKEN_STREAM_FAULTS = {
    "a start in mid-frame leaves the column": (
        r"if raster_place_group_is_equal or in_start_of_frame then(\s+raster_place_column <= 0;)",
        r"if raster_place_group_is_equal then\1",
    ),
    "a start in mid-frame leaves the row": (
        r"if in_start_of_frame and in_valid then(\s+raster_place_group <= raster_place_group_choice \* 4;)",
        r"if in_start_of_frame and in_valid and (raster_place_group >= 11) then\1",
    ),
    "a start anywhere in the last row joins": (
        r"raster_place_group_all := raster_place_group_is_equal and ",
        "raster_place_group_all := ",
    ),
    "outputs without a start behind a reset": (r"raster_place_group <= 13;", "raster_place_group <= 0;"),
    "rows that come round behind a reset": (r"raster_place_group <= 13;", "raster_place_group <= 14;"),
    "the next frame is never forgotten": (r"mod 2\) = 1\);$", "mod 2) /= 1);"),
}


# The register of the VHDL that each fault makes wrong first. The others leave a range, which stops the simulator.
FIRST_REGISTERS = {
    "constant: one row too many": "raster_place_group",
    "constant: ring one shorter": "delay_ring_read_address",
    "operator: smaller becomes smaller or equal": "slice0winner1_of_pair_0_0",
    "register dropped": "slice1window_partial_0_0_2",
    "register bypassed": "slice0window_tag_end_of_line",
    "index: the neighbour's pixel": "slice0shift_search_1_0",
    # Of the three that it holds, the one that the stream shows first.
    "condition inverted": (
        "rows_search_rows_write_words_0",
        "rows_reference_rows_write_words_0",
        "rows_write_column",
    ),
    "a carry lost": "slice0cost_column_0_1",
    "one winner's place wrong": "slice2_best_index_0_0",
    "a start in mid-frame leaves the column": "raster_place_column",
    "a start in mid-frame leaves the row": "raster_place_group",
    "a start anywhere in the last row joins": "raster_place_group",
    "outputs without a start behind a reset": "raster_place_group",
    "rows that come round behind a reset": "raster_place_group",
    "the next frame is never forgotten": "raster_place_group",  # that of the flag is a guess
}


# Faults of settings that come from ports. Each frame of a stimulus has its own.
SETTING_FAULTS = {
    "the uniqueness of the frame behind": (
        "tiny_settings",
        "refinement_percent <= settings_uniqueness_percent",
        "refinement_percent <= in_uniqueness_percent",
    ),
    "P2 of the frame behind, on the path from the right": (
        "tiny_sgm_settings",
        "sums_right_p2 <= settings_p2",
        "sums_right_p2 <= in_p2 mod 32",
    ),
    "the rows of the largest images": (
        "tiny_size",
        "size_windows_groups <= in_image_height mod 16",
        "size_windows_groups <= size_windows_groups",
    ),
    "the columns of the largest images": (
        "tiny_size",
        r"size_last_map_column <= .*;",
        "size_last_map_column <= size_last_map_column;",
    ),
    "a row turned round at the largest width": (
        "tiny_sgm_size",
        r"entry_order_last_value <= \(.*;",
        "entry_order_last_value <= entry_order_last_value;",
    ),
    "candidates beyond the map of a narrower image": (
        "tiny_size_full",
        r"slice0mask_end_value <= .*;",
        "slice0mask_end_value <= 30;",
    ),
    "the cost of a drop of the frame behind": (
        "tiny_trellis_settings",
        "forward_drop_cost <= settings_drop_cost",
        "forward_drop_cost <= in_drop_cost mod 4",
    ),
    "filters beyond a narrower image": (
        "tiny_phase_size",
        r"transform_columns_up_value <= .*;",
        "transform_columns_up_value <= transform_columns_up_value;",
    ),
    "P1 stays": ("tiny_sgm_settings", "forward_above_p1 <= settings_p1", "forward_above_p1 <= forward_above_p1"),
}


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    """Four grey levels: every disparity wins somewhere, and ties are everywhere. A textured scene would miss some
    faults."""
    return random_pair(tmp_path_factory.mktemp("pair"), "tiny", levels=4)


# What the fast set takes: of each kind one that an output shows and, where there is one, one that stops the simulator.
FAST = ["constant: ring one shorter", "register dropped", "a carry lost"]
FAST_SETTINGS = ["the uniqueness of the frame behind", "the rows of the largest images"]
FAST_STREAMS = ["a start in mid-frame leaves the row", "outputs without a start behind a reset"]


@pytest.mark.parametrize("fault", with_slow(FAULTS, FAST))
def test_fault_is_caught(ghdl, pair, tmp_path, fault):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", *FAULTS[fault])
    process = cosim("tiny", pair, tmp_path / "out", "--frames", 2, "--stall-percent", 10, "--rtl", rtl)
    # A range that is left stops the simulator: that is a catch, too, with another exit code.
    assert process.returncode in (1, 4), f"{fault} was not caught: {process.stdout}"
    if process.returncode == 1:
        result = report(tmp_path / "out")
        assert result["passed"] is False and result["mismatches"] > 0
        assert "expected" in result["first_mismatch"] or "surplus" in result["first_mismatch"]
        assert_named(process, result, fault)


def assert_named(process, result, fault):
    """The register that the fault makes wrong is the first one that is told."""
    first, wrong = result["first_registers"][0], FIRST_REGISTERS[fault]
    assert first in (wrong if isinstance(wrong, tuple) else (wrong,)), result["first_register"]
    assert f"first register that differs: {first}, clock" in process.stdout


@pytest.mark.parametrize("fault", with_slow(SETTING_FAULTS, FAST_SETTINGS))
def test_fault_of_a_setting_is_caught(ghdl, tmp_path, fault):
    config, *change = SETTING_FAULTS[fault]
    rtl = altered_rtl(tmp_path / "rtl", config, *change)
    pair = random_pair(tmp_path / "pair", config, levels=256)
    process = cosim(config, pair, tmp_path / "out", "--frames", 6, "--rtl", rtl)
    assert process.returncode == 1, f"{fault} was not caught: {process.stdout}{process.stderr}"
    assert report(tmp_path / "out")["mismatches"] > 0


@pytest.mark.parametrize("fault", with_slow(BROKEN_STREAM_FAULTS, FAST_STREAMS))
def test_fault_of_the_control_is_caught(ghdl, pair, tmp_path, fault):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", *BROKEN_STREAM_FAULTS[fault])
    process = cosim("tiny", pair, tmp_path / "out", "--broken", 40, "--rtl", rtl)
    assert process.returncode in (1, 4), f"{fault} was not caught: {process.stdout}"
    if process.returncode == 1:
        assert_named(process, report(tmp_path / "out"), fault)


@pytest.mark.slow
@pytest.mark.parametrize("before, after", [(r"_2 <\s+3\)", "_2 <= 3)"), (r"_4 >= 0\)", "_4 >= -1)")])
def test_a_coarse_neighbour_that_may_differ_by_two_is_caught(verilator, tmp_path, before, after):
    """Of the dynamic range, by the default command: random pairs show that too seldom. stress_pairs_test.cpp asks for
    all neighbours."""
    name = "ranges_counts_difference"
    rtl = altered_rtl(tmp_path / "rtl", "tiny_dynamic", rf"\({name}{before}", f"({name}{after}")
    words = ["--config", "tiny_dynamic", "--rtl", rtl, "--allow-edited", "--simulator", "verilator"]
    process = call("cosim.py", *words, "--out", tmp_path / "out")
    assert process.returncode == 1, process.stdout + process.stderr
    assert report(tmp_path / "out")["mismatches"] > 0


def test_failure_is_reported_in_full(ghdl, pair, tmp_path):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", *FAULTS["one winner's place wrong"])
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", rtl, "--wave", tmp_path / "wave.ghw")
    assert process.returncode == 1
    assert "FAIL: tiny in ghdl" in process.stdout
    for word in ("clock", "x ", "y ", "expected disparity", "got disparity"):
        assert word in process.stdout
    assert (tmp_path / "wave.ghw").stat().st_size > 1000
    failure = xml.parse(tmp_path / "out" / "junit.xml").getroot().find("testcase/failure")
    assert "expected disparity" in failure.get("message")


@pytest.mark.parametrize("simulator", ["verilator", "nvc"])
def test_fault_is_caught_in_another_simulator(request, pair, tmp_path, simulator):
    request.getfixturevalue(simulator)
    rtl = altered_rtl(tmp_path / "rtl", "tiny", *FAULTS["register dropped"])
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", rtl, "--simulator", simulator)
    assert process.returncode == 1
    assert report(tmp_path / "out")["mismatches"] > 0


def test_undefined_output_is_caught(ghdl, pair, tmp_path):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", r"disparity_valid <= .*;", "disparity_valid <= 'X';")
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", rtl)
    assert process.returncode == 1
    assert "got disparity X" in process.stdout


def test_silent_core_is_caught(ghdl, pair, tmp_path):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", r"disparity_valid <= .*;", "disparity_valid <= '0';")
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", rtl)
    assert process.returncode == 1
    assert report(tmp_path / "out")["compared"] == 0
    assert "first_register" not in report(tmp_path / "out"), "all registers are right: the fault is in an output"


ENDLESS = r"disparity_valid <= .*;", "disparity_valid <= '0';\n  process begin loop end loop; end process;"


def test_hanging_simulation_is_stopped(ghdl, pair, tmp_path):
    rtl = altered_rtl(tmp_path / "rtl", "tiny", *ENDLESS)
    process = cosim("tiny", pair, tmp_path / "out", "--rtl", rtl, "--watchdog", "3")
    assert process.returncode == 4
    assert "made no progress for 3 s and was stopped" in process.stderr
    assert "made no progress" in report(tmp_path / "out")["error"]["message"]


def simulations_of(folder):
    """The running processes that know a folder."""
    lines = subprocess.run(["ps", "-ww", "-eo", "args"], capture_output=True, text=True, check=True).stdout.splitlines()
    return [line for line in lines if f"={folder}/observed.txt" in line]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interruption_ends_the_simulation(ghdl, pair, tmp_path, number):
    """Of the command alone, as `timeout` and CI services end it; a terminal's Ctrl-C reaches the simulation itself."""
    rtl, out = altered_rtl(tmp_path / "rtl", "tiny", *ENDLESS), tmp_path / "out"
    words = [ROOT / "scripts" / "cosim.py", "--config", "tiny", "--left", pair[0], "--right", pair[1]]
    words += ["--rtl", rtl, "--allow-edited", "--out", out]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    while not simulations_of(out):
        assert process.poll() is None
        time.sleep(0.05)
    process.send_signal(number)
    assert process.communicate(timeout=30)[1] == "cosim.py: interrupted\n" and process.returncode == 128 + number
    assert simulations_of(out) == [] and not (out / "report.json").exists()
    assert [path.name for path in Path(out).glob(".*")] == [places.MARK]
