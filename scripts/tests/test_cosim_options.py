# SPDX-License-Identifier: Apache-2.0
"""Co-simulation of every option of the algorithm: model == core (hls_tb/cores/named_cores_test.cpp) == VHDL
(here)."""

from dataclasses import replace

import pytest

from flow.base import rtl
from flow.base.configurations import configurations
from flow.base.ghdl import to_verilog
from flow.cosim import checker, vectors
from flow.synthesis import manifest
from flow_commands import cosim_of_streams, outputs_of, random_pair, report, scene, stream

TABLE = configurations()
OPTIONS = sorted(name for name, row in TABLE.items() if row["use"] in ("option", "example"))


def test_there_are_enough_parameter_sets():
    """Among them wide ranges, even windows, several rows at once."""
    assert len(OPTIONS) >= 30
    assert any(p["disparities"] > 0.8 * p["width_px"] for p in TABLE.values())
    assert any(p.get("window_px", 1) % 2 == 0 for p in map(TABLE.get, OPTIONS))
    assert {p["pixels_per_clock"] for p in map(TABLE.get, OPTIONS)} == {1, 2, 4}


def timed_in(stream, observed, after):
    """The outputs of a stream that came after another one, with their clocks in the stream."""
    first, start = outputs_of(after), len((after / "stimulus.txt").read_text().splitlines())
    seen = vectors.read_observed(observed)[0][first : first + outputs_of(stream)]
    return [replace(output, clock=output.clock - start) for output in seen]


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
    broken, ties, _ = streams
    outputs = parameters["output_width_px"] * parameters["output_height_px"] // parameters["pixels_per_clock"]
    assert [outputs_of(one) for one in streams[1:]] == [2 * outputs, 2 * outputs] and outputs_of(broken) > 0

    process = cosim_of_streams(config, streams, tmp_path / "out")
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert (result["compared"], result["mismatches"]) == (sum(map(outputs_of, streams)), 0)
    # The clocks are those of the VHDL: each output came in its own.
    timing = checker.measure(
        vectors.read_stimulus(ties / "stimulus.txt", rtl.kind_of(parameters)),
        timed_in(ties, tmp_path / "out" / "observed.txt", after=broken),
        parameters,
    )
    frame = parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"]
    assert timing.clocks_per_frame == frame + parameters["gap_groups"]
    assert timing.latency_clocks == parameters["latency_clocks"]


@pytest.mark.parametrize("config", OPTIONS)
def test_synthesis_takes_the_vhdl(ghdl, tmp_path, config):
    assert to_verilog(manifest.core_files(config), tmp_path, rtl.core_entity(config)).count("endmodule") >= 1
