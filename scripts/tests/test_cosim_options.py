# SPDX-License-Identifier: Apache-2.0
"""Co-simulation of every option of the algorithm: model == core (hls_tb/cores/named_cores_test.cpp) == VHDL (here). The
fast set takes the tiny cores, and of block matching as few others as have every option. mark.slow takes a few that have
every option of every family, and all whose VHDL has not passed the stress stream on record."""

import pytest

from cover import cover, rows, simulated, with_slow
from flow.base import committed, rtl
from flow.base.configurations import clocks_per_pixel, configurations, outputs_per_frame
from flow.base.ghdl import to_verilog
from flow.cosim import record
from flow.cosim.report import judged
from flow.synthesis import manifest
from flow_commands import call, cosim, report, scene

TABLE = configurations()
OPTIONS = sorted(name for name, row in TABLE.items() if row["use"] in ("option", "example"))
TINY = [name for name, row in TABLE.items() if row["use"] == "tiny"]
SMALL = sorted([*OPTIONS, *TINY])
FAST = simulated() & {*SMALL}
LONG = sorted(name for name in FAST if TABLE[name]["family"] == "dynamic_range")  # a minute: the fast set takes rows


def is_whole(config, result):
    """A stream and two frames."""
    return judged(result) == 0 and result["frames"] == 2 and result["compared"] > 12 * outputs_per_frame(TABLE[config])


def on_record(config):
    """Whether the VHDL that is there now has passed as it would here."""
    if config not in MADE:
        return False
    folder = committed.folder(config)
    run = record.read(folder, manifest.read(folder), "stress").get("ghdl")
    return run is not None and is_whole(config, run)


MADE = set(committed.known_configurations())
ROWS = {name: row for name, row in rows().items() if name in SMALL}
# As few as have every option of every family, and each word of it.
FEW = {*FAST, *cover(ROWS, others=[ROWS[name] for name in FAST])}
IN_SYNTHESIS = {"example_p2_delayed", "tiny_12bit_all"}  # of the fast set
SIMULATED = sorted(name for name in SMALL if name in FEW or not on_record(name))


def test_there_are_enough_parameter_sets():
    """Among them wide ranges, even windows, several rows at once."""
    assert len(OPTIONS) >= 30
    assert any(p["disparities"] > 0.8 * p["width_px"] for p in TABLE.values())
    assert any(p.get("window_px", 1) % 2 == 0 for p in map(TABLE.get, OPTIONS))
    assert {p["pixels_per_clock"] for p in map(TABLE.get, OPTIONS)} == {1, 2, 4}


def test_the_fast_set_has_every_option():
    """As the program lists them: the choice was made from the text of the tables."""

    def options(names):
        return {option.partition(" ")[0] for name in names for option in TABLE[name]["options"]}

    assert len(FAST) < len(SMALL) / 6 and {*TINY} < FAST
    block_matching = [name for name in SMALL if TABLE[name]["family"] == "block_matching"]
    assert options(FAST) >= options(block_matching) and len(options(block_matching)) > 30
    assert {TABLE[name]["family"] for name in FAST} == {TABLE[name]["family"] for name in SMALL}


def test_what_counts_on_record(monkeypatch):
    count = 12 * outputs_per_frame(TABLE["tiny"]) + 1
    run = {"passed": True, "compared": count, "expected": count, "mismatches": 0, "frames": 2}
    for change, counts in (
        ({}, True),
        ({"passed": False}, False),
        ({"mismatches": 1}, False),
        ({"frames": 1}, False),
        ({"compared": count - 1, "expected": count - 1}, False),
    ):
        monkeypatch.setattr(record, "read", lambda *_, change=change: {"ghdl": run | change})
        assert on_record("tiny") == counts, change
    monkeypatch.setattr(record, "read", lambda *_: {"verilator": run})
    assert not on_record("tiny") and not on_record("no_vhdl_yet")


@pytest.mark.parametrize("config", LONG)
def test_rows_of_a_long_frame(ghdl, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--rows", 2)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert result["compared"] == result["expected"] > 40 and result["mismatches"] == 0


@pytest.mark.parametrize("config", with_slow(SIMULATED, FAST.difference(LONG)))
def test_stress_stream_and_two_frames(ghdl, tmp_path, config):
    """One of the streams that cosim.py sends by default, of another seed in each configuration, and behind it two
    frames as close as they may be. Clock by clock as the C++ core."""
    parameters, seed = TABLE[config], 1 + SMALL.index(config)
    words = ["--frames", 2, "--seed", seed, "--stress-clocks", 1, "--out", tmp_path]
    process = call("cosim.py", "--config", config, *words)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path)
    assert is_whole(config, result)
    groups = (
        parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"] + parameters["gap_groups"]
    )
    assert result["clocks_per_frame"] == groups * clocks_per_pixel(parameters)
    assert result["latency_clocks"] == parameters["latency_clocks"]


@pytest.mark.parametrize("config", with_slow(sorted(FEW | IN_SYNTHESIS), IN_SYNTHESIS))
def test_synthesis_takes_the_vhdl(ghdl, tmp_path, config):
    assert to_verilog(manifest.core_files(config), tmp_path, rtl.core_entity(config)).count("endmodule") >= 1
