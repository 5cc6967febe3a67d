# SPDX-License-Identifier: Apache-2.0
"""Many whole frames with bubbles; minutes."""

import pytest

from flow_commands import cosim, random_pair, report, scene

FRAMES = {"ghdl": 2, "verilator": 20}  # GHDL takes minutes for what Verilator does in seconds


@pytest.mark.parametrize("images, simulator", [("scene", "ghdl"), ("scene", "verilator"), ("noise", "verilator")])
def test_ambrosch2007_frames_with_bubbles(request, tmp_path, simulator, images):
    request.getfixturevalue(simulator)
    folder = tmp_path / "pair"
    pair = (
        scene(folder, "ambrosch2007", seed=11) if images == "scene" else random_pair(folder, "ambrosch2007", levels=8)
    )
    options = ["--frames", FRAMES[simulator], "--stall-percent", 30, "--seed", 3, "--simulator", simulator]
    process = cosim("ambrosch2007", pair, tmp_path / "out", *options)
    assert process.returncode == 0, process.stdout + process.stderr
    assert report(tmp_path / "out")["compared"] == FRAMES[simulator] * 220 * 240
