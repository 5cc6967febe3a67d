# SPDX-License-Identifier: Apache-2.0
"""Co-simulation of every option of the algorithm: model == core (hls_tb/cores/named_cores_test.cpp) == VHDL
(here)."""

import re
from dataclasses import replace

import pytest

from flow.base import rtl
from flow.base.configurations import configurations
from flow.base.ghdl import to_verilog
from flow.cosim import checker, vectors
from flow.synthesis import manifest
from flow_commands import call, random_pair, report, scene, stream

TABLE = configurations()
OPTIONS = sorted(name for name, row in TABLE.items() if row["use"] in ("option", "example"))


def test_there_are_enough_parameter_sets():
    """Among them wide ranges, even windows, several rows at once."""
    assert len(OPTIONS) >= 30
    assert any(p["disparities"] > 0.8 * p["width_px"] for p in TABLE.values())
    assert any(p.get("window_px", 1) % 2 == 0 for p in map(TABLE.get, OPTIONS))
    assert {p["pixels_per_clock"] for p in map(TABLE.get, OPTIONS)} == {1, 2, 4}


def joined(streams, folder):
    """(stimulus, expected, first clock of each) of streams that follow one another, a clock of reset after each."""
    stimulus, expected, starts = [], [], []
    for one in streams:
        starts.append(len(stimulus))
        for line in lines_of(one, "expected"):
            clock, _, rest = line.partition(" ")
            expected.append(f"{int(clock) + starts[-1]} {rest}")
        stimulus += lines_of(one, "stimulus")
        stimulus.append("4" + stimulus[-1][1:])
    files = []
    for name, lines, count in (("stimulus", stimulus, "clocks"), ("expected", expected, "outputs")):
        header = (streams[0] / f"{name}.txt").read_text().splitlines()[0]
        header = re.sub(rf" {count}=\d+", f" {count}={len(lines)}", header)
        files.append(folder / f"{name}.txt")
        files[-1].write_text("\n".join([header, *lines]) + "\n")
    return *files, starts


def lines_of(stream, name):
    return (stream / f"{name}.txt").read_text().splitlines()[1:]


@pytest.mark.parametrize("config", [*OPTIONS, "tiny", "tiny_p2", "tiny_p4", "tiny_sgm"])
def test_three_streams(ghdl, tmp_path, config):
    """In one simulation, as most of its time is its start: a broken stream with frames broken off, starts at any place,
    records without a start and resets; two frames as close as they may be with few grey levels, so ties, flat and
    saturated windows everywhere; two frames of a scene with bubbles. Clock by clock as the C++ core. The broken stream
    comes first: what is left of a broken frame may hang on what the memories held, a whole frame may not."""
    parameters = TABLE[config]
    noise, seed = random_pair(tmp_path / "noise", config, levels=2), sorted(TABLE).index(config)
    streams = [
        stream(tmp_path / "broken", config, noise, "--broken", 8, "--stall-percent", 5, "--seed", seed),
        stream(tmp_path / "ties", config, noise, "--frames", 2),
        stream(tmp_path / "bubbles", config, scene(tmp_path / "scene", config), "--frames", 2, "--stall-percent", 30),
    ]
    outputs = parameters["output_width_px"] * parameters["output_height_px"] // parameters["pixels_per_clock"]
    counts = [len(lines_of(one, "expected")) for one in streams]
    assert counts[0] > 0 and counts[1:] == [2 * outputs, 2 * outputs]

    stimulus, expected, starts = joined(streams, tmp_path)
    words = ["--config", config, "--stimulus", stimulus, "--expected", expected, "--out", tmp_path / "out"]
    process = call("cosim.py", *words)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert (result["compared"], result["mismatches"]) == (sum(counts), 0)

    seen = vectors.read_observed(tmp_path / "out" / "observed.txt")[0][counts[0] : counts[0] + counts[1]]
    timing = checker.measure(
        vectors.read_stimulus(streams[1] / "stimulus.txt", rtl.kind_of(parameters)),
        [replace(output, clock=output.clock - starts[1]) for output in seen],
        parameters,
    )
    frame = parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"]
    assert timing.clocks_per_frame == frame + parameters["gap_groups"]
    assert timing.latency_clocks == parameters["latency_clocks"]


@pytest.mark.parametrize("config", OPTIONS)
def test_synthesis_takes_the_vhdl(ghdl, tmp_path, config):
    assert to_verilog(manifest.core_files(config), tmp_path, rtl.core_entity(config)).count("endmodule") >= 1
