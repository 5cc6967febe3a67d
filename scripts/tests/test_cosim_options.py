# SPDX-License-Identifier: Apache-2.0
"""Co-simulation of every option of the algorithm: model == core (hls_tb/cores/named_cores_test.cpp) == VHDL
(here)."""

import pytest

from flow.base import rtl
from flow.base.configurations import configurations
from flow.base.ghdl import to_verilog
from flow.synthesis import manifest
from flow_commands import cosim, random_pair, report, scene

TABLE = configurations()
OPTIONS = sorted(name for name, row in TABLE.items() if row["use"] in ("option", "example"))


def passed(process, out, config, frames):
    assert process.returncode == 0, process.stdout + process.stderr
    result, parameters = report(out), TABLE[config]
    outputs = frames * parameters["output_width_px"] * parameters["output_height_px"] // parameters["pixels_per_clock"]
    assert (result["expected"], result["compared"], result["mismatches"]) == (outputs, outputs, 0)
    return result


def test_there_are_enough_parameter_sets():
    """Among them wide ranges, even windows, several rows at once."""
    assert len(OPTIONS) >= 30
    assert any(p["disparities"] > 0.8 * p["width_px"] for p in TABLE.values())
    assert any(p.get("window_px", 1) % 2 == 0 for p in map(TABLE.get, OPTIONS))
    assert {p["pixels_per_clock"] for p in map(TABLE.get, OPTIONS)} == {1, 2, 4}


@pytest.mark.parametrize("config", OPTIONS)
def test_full_speed_with_ties(ghdl, tmp_path, config):
    """Few grey levels: ties, flat and saturated windows everywhere. Two frames as close as they may be."""
    pair = random_pair(tmp_path / "pair", config, levels=2)
    result = passed(cosim(config, pair, tmp_path / "out", "--frames", 2), tmp_path / "out", config, 2)
    parameters = TABLE[config]
    frame = parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"]
    assert result["clocks_per_frame"] == frame + parameters["gap_groups"]
    assert result["latency_clocks"] == parameters["latency_clocks"]


@pytest.mark.parametrize("config", OPTIONS)
def test_bubbles_on_a_scene(ghdl, tmp_path, config):
    process = cosim(config, scene(tmp_path / "pair", config), tmp_path / "out", "--frames", 2, "--stall-percent", 30)
    passed(process, tmp_path / "out", config, 2)


@pytest.mark.parametrize("config", [*OPTIONS, "tiny", "tiny_p2", "tiny_p4", "tiny_sgm"])
def test_broken_streams(ghdl, tmp_path, config):
    """Frames broken off, starts at any place, records without a start, resets: clock by clock as the C++ core."""
    pair = random_pair(tmp_path / "pair", config, levels=3)
    seed = sorted(TABLE).index(config)
    process = cosim(config, pair, tmp_path / "out", "--broken", 8, "--stall-percent", 5, "--seed", seed)
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(tmp_path / "out")
    assert result["compared"] == result["expected"] > 0 and result["mismatches"] == 0


@pytest.mark.parametrize("config", OPTIONS)
def test_synthesis_takes_the_vhdl(ghdl, tmp_path, config):
    assert to_verilog(manifest.core_files(config), tmp_path, rtl.core_entity(config)).count("endmodule") >= 1
