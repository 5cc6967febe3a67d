# SPDX-License-Identifier: Apache-2.0
"""Results of co-simulations that stand beside the VHDL: kept for each simulator, and only as long as the VHDL is the
same."""

import json
import shutil

import pytest

from flow.base import committed
from flow.base.errors import FlowError
from flow.cosim import record
from flow.pages import performance
from flow.pages.published import System
from flow.synthesis import manifest
from flow_commands import call, refused

REPORT = {
    "config": "tiny",
    "simulator": "ghdl",
    "command": "scripts/cosim.py ...",
    "passed": True,
    "expected": 168,
    "compared": 168,
    "mismatches": 0,
    "frames": 1,
    "clocks": 270,
    "clocks_per_second": 4321.4,
}


def keep(report, *stimulus):
    record.keep([(report, record.design("tiny"))], *stimulus)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    shutil.copytree(committed.folder("tiny"), tmp_path / "block_matching" / "tiny")
    copy = tmp_path / "block_matching" / "tiny"
    (copy / "implementation.json").unlink(missing_ok=True)
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path)
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    return copy


def test_the_last_run_of_each_simulator_is_kept(folder):
    entry = manifest.read(folder)
    assert record.read(folder, entry) == {}
    keep(REPORT)
    keep(REPORT | {"simulator": "verilator", "expected": 288, "compared": 288})
    keep(REPORT | {"mismatches": 3, "passed": False})
    runs = record.read(folder, entry)
    assert {name: (run["compared"], run["mismatches"]) for name, run in runs.items()} == {
        "ghdl": (168, 3),
        "verilator": (288, 0),
    }
    assert "clocks_per_second" not in runs["ghdl"], "times differ from machine to machine"


def test_results_of_other_vhdl_do_not_count(folder):
    keep(REPORT)
    keep(REPORT, "stress")
    entry = manifest.read(folder)
    for stimulus in ("runs", "stress"):
        assert record.read(folder, entry, stimulus) and not record.read(folder, entry | {"structure": "0"}, stimulus)


def test_what_was_simulated_must_be_there_still(folder):
    with pytest.raises(FlowError, match="the VHDL of tiny changed in the meantime; nothing recorded of it"):
        record.keep([(REPORT, {**record.design("tiny"), "structure": "0"})])
    assert not (folder / record.FILE).exists()


def test_images_and_the_stress_stream_are_two_results(folder):
    entry = manifest.read(folder)
    keep(REPORT | {"compared": 900, "expected": 900}, "stress")
    assert record.read(folder, entry) == {}
    keep(REPORT)
    assert record.read(folder, entry)["ghdl"]["compared"] == 168
    assert record.read(folder, entry, "stress")["ghdl"]["compared"] == 900


@pytest.mark.parametrize(
    "content",
    [
        "",
        "[]",
        "{}",
        '{"format": "stereo-hls cosimulation 9", "runs": {}}',
        json.dumps({"format": record.FORMAT, "runs": {"ghdl": {"compared": "all"}}}),
        json.dumps({"format": record.FORMAT, "stress": []}),
    ],
)
def test_damaged_results_are_refused(folder, content):
    (folder / record.FILE).write_text(content)
    with pytest.raises(FlowError, match="damaged .*cosimulation.json"):
        for stimulus in ("runs", "stress"):
            record.read(folder, manifest.read(folder), stimulus)


def test_the_page_shows_them(folder, monkeypatch):
    monkeypatch.setattr(performance, "SYSTEMS", [System("ours", "32x12", None, "", "tiny")])
    keep(REPORT)
    head, rows = performance.systems()
    shown = dict(zip(head, rows[0]))
    assert (shown["compared in GHDL"], shown["compared in Verilator"]) == ("168 of 168, 0 differ", performance.UNKNOWN)


@pytest.mark.parametrize(
    "options",
    [
        ["--rtl", committed.folder("tiny")],
        ["--simulator", "original"],
        ["--broken", 3],
        ["--wave", "w.ghw"],
        ["--coverage"],
        ["--config", "tiny_p2", "--changed"],
    ],
)
def test_only_results_of_the_committed_vhdl_are_recorded(options):
    refused(
        call("cosim.py", "--config", "tiny", "--left", "l.png", "--right", "r.png", "--record", *options), 2, "--record"
    )
