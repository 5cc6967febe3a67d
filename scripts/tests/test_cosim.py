# SPDX-License-Identifier: Apache-2.0
"""Co-simulation of the committed VHDL against the C++ core, as users run it."""

import shutil
import xml.etree.ElementTree as xml

import pytest

from cover import with_slow
from flow.base import committed
from flow.base.configurations import configuration
from flow.cosim import record as cosim_record
from flow.pages import quality
from flow.synthesis import manifest
from flow_commands import cosim, random_pair, report, scene

# Outputs a frame: each is a column of as many rows as enter in a clock.
OUTPUTS = {
    "tiny": 24 * 12,
    "tiny_p2": 24 * 6,
    "tiny_p4": 24 * 3,
    "ambrosch2007": 220 * 240,
    "ambrosch2007_p2": 220 * 120,
    "ambrosch2007_p4": 220 * 60,
}


@pytest.fixture(scope="module")
def pairs(tmp_path_factory):
    return {config: scene(tmp_path_factory.mktemp(config), config) for config in OUTPUTS}


def passed(process, out, outputs):
    assert process.returncode == 0, process.stdout + process.stderr
    result = report(out)
    assert result["passed"] is True
    assert (result["expected"], result["compared"], result["mismatches"]) == (outputs, outputs, 0)
    assert result["clocks_per_second"] > 0
    return result


def test_tiny_whole_frame_in_ghdl(ghdl, pairs, tmp_path):
    result = passed(cosim("tiny", pairs["tiny"], tmp_path), tmp_path, OUTPUTS["tiny"])
    assert result["config"] == "tiny" and result["simulator"] == "ghdl"
    assert result["initiation_interval"] == {"min": 1, "avg": 1.0, "max": 1}
    assert result["latency_clocks"] == configuration("tiny")["latency_clocks"]


def test_tiny_frames_back_to_back_cost_their_pixels_and_no_clock_more(ghdl, pairs, tmp_path):
    result = passed(cosim("tiny", pairs["tiny"], tmp_path, "--frames", 3), tmp_path, 3 * OUTPUTS["tiny"])
    assert result["frames"] == 3
    assert result["clocks_per_frame"] == 32 * 12


BUBBLES = [("tiny", 5), ("tiny", 60), ("tiny_p2", 30), ("tiny_p4", 30)]


@pytest.mark.parametrize("simulator", ["ghdl", "verilator", "nvc"])
@pytest.mark.parametrize("config,stall_percent", with_slow(BUBBLES, BUBBLES[1:3]))
def test_tiny_with_bubbles(request, pairs, tmp_path, simulator, config, stall_percent):
    request.getfixturevalue(simulator)
    options = ["--frames", 4, "--stall-percent", stall_percent, "--seed", 5, "--simulator", simulator]
    process = cosim(config, pairs[config], tmp_path, *options)
    result = passed(process, tmp_path, 4 * OUTPUTS[config])
    assert result["initiation_interval"]["max"] > 1, "bubbles show in the outputs"


LEVELS = [(1, 255), (2, 255), (3, 255), (256, 255), (4, 3)]


@pytest.mark.parametrize("config", with_slow(["tiny", "tiny_p2", "tiny_p4"], ["tiny_p2"]))
@pytest.mark.parametrize("levels, brightest", with_slow(LEVELS, [(1, 255), (2, 255), (256, 255)]))
def test_tiny_with_ties_extremes_and_noise(ghdl, tmp_path, config, levels, brightest):
    pair = random_pair(tmp_path / "pair", config, levels, brightest=brightest)
    passed(cosim(config, pair, tmp_path / "out", "--frames", 2), tmp_path / "out", 2 * OUTPUTS[config])


@pytest.mark.slow
@pytest.mark.parametrize("levels", [2, 256])
def test_ambrosch2007_with_ties_extremes_and_noise(verilator, tmp_path, levels):
    pair = random_pair(tmp_path / "pair", "ambrosch2007", levels)
    process = cosim(
        "ambrosch2007", pair, tmp_path / "out", "--frames", 2, "--stall-percent", 10, "--simulator", "verilator"
    )
    passed(process, tmp_path / "out", 2 * OUTPUTS["ambrosch2007"])


@pytest.mark.parametrize(
    "config", with_slow(["ambrosch2007", "ambrosch2007_p2", "ambrosch2007_p4"], ["ambrosch2007_p2"])
)
def test_crop_in_ghdl(ghdl, pairs, tmp_path, config):
    process = cosim(config, pairs[config], tmp_path, "--rows", "100:108")
    result = passed(process, tmp_path, 220 * (7 // configuration(config)["pixels_per_clock"]))
    assert result["clocks_per_frame"] is None, "a crop is no frame"


@pytest.mark.parametrize("simulator", with_slow(["ghdl", "verilator"], ["verilator"]))
def test_two_whole_frames(ghdl, verilator, pairs, tmp_path, simulator):
    """Those of the other configurations are recorded: the next test."""
    process = cosim("ambrosch2007", pairs["ambrosch2007"], tmp_path, "--frames", 2, "--simulator", simulator)
    result = passed(process, tmp_path, 2 * OUTPUTS["ambrosch2007"])
    assert result["clocks_per_frame"] <= 77_600
    assert result["initiation_interval"] == {"min": 1, "avg": 1.0, "max": 1}


@pytest.mark.parametrize("config", ["ambrosch2007_p2", "ambrosch2007_p4"])
def test_two_whole_frames_are_recorded(config):
    """Of the VHDL that is here, else there is no record; two frames and the latency, no clock more."""
    runs = cosim_record.read(committed.folder(config), manifest.read(committed.folder(config)))
    for simulator in ("ghdl", "verilator"):
        run = runs.get(simulator)
        assert run, f"run scripts/cosim.py --config {config} --frames 2 --simulator {simulator} --record"
        assert (run["frames"], run["compared"], run["mismatches"]) == (2, 2 * OUTPUTS[config], 0) and run["passed"]
        frame = 320 * 240 // configuration(config)["pixels_per_clock"]
        assert 2 * frame < run["clocks"] < 2 * frame + 500


def test_ambrosch2007_real_pair(ghdl, tmp_path):
    folder = quality.default_pair()
    if not folder.is_dir():
        pytest.skip(f"SKIP: the stereo pair {folder} is missing")
    process = cosim("ambrosch2007", (folder / "left.png", folder / "right.png"), tmp_path, "--fit", "crop")
    passed(process, tmp_path, OUTPUTS["ambrosch2007"])
    assert "crop" in process.stdout, "what was done to the images is said"


def test_vhdl_that_has_moved_is_analysed_again(ghdl, pairs, tmp_path):
    """GHDL opens the files that it has analysed when it runs them."""
    for place in ("here", "there"):
        moved = tmp_path / place / "tiny_p2"
        shutil.copytree(committed.folder("tiny_p2"), moved)
        passed(
            cosim("tiny_p2", pairs["tiny_p2"], tmp_path / "out", "--rtl", moved), tmp_path / "out", OUTPUTS["tiny_p2"]
        )
        shutil.rmtree(moved)


def test_junit_of_a_pass(ghdl, pairs, tmp_path):
    passed(cosim("tiny", pairs["tiny"], tmp_path), tmp_path, OUTPUTS["tiny"])
    suite = xml.parse(tmp_path / "junit.xml").getroot()
    assert (suite.get("tests"), suite.get("failures")) == ("1", "0")


@pytest.mark.parametrize("suffix", [".ghw", ".fst", ".vcd"])
def test_ghdl_waveform(ghdl, pairs, tmp_path, suffix):
    wave = tmp_path / f"wave{suffix}"
    passed(cosim("tiny", pairs["tiny"], tmp_path, "--wave", wave), tmp_path, OUTPUTS["tiny"])
    assert wave.stat().st_size > 1000


@pytest.mark.parametrize("simulator", ["verilator", "nvc"])
def test_waveform_of_another_simulator(request, pairs, tmp_path, simulator):
    request.getfixturevalue(simulator)
    wave = tmp_path / "wave.fst"
    process = cosim("tiny", pairs["tiny"], tmp_path, "--wave", wave, "--simulator", simulator)
    passed(process, tmp_path, OUTPUTS["tiny"])
    assert wave.stat().st_size > 1000
