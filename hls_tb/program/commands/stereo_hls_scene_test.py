# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls scene."""

import subprocess

import pytest

from stereo_hls_program import PROGRAM, png_size, succeed


def test_scene_is_determined_by_its_seed(tmp_path):
    def scene(name, seed):
        succeed("scene", "--out", tmp_path / name, "--seed", seed, "--width", 60, "--height", 40, "--disparities", 16)
        return {p.name: p.read_bytes() for p in (tmp_path / name).iterdir()}

    first = scene("a", 1)
    assert sorted(first) == [
        "disparity_left.png",
        "disparity_right.png",
        "left.png",
        "right.png",
        "visible_left.png",
        "visible_right.png",
    ]
    assert png_size(tmp_path / "a" / "left.png") == (60, 40)
    assert scene("b", 1) == first
    assert scene("c", 2)["left.png"] != first["left.png"]


def test_moving_scene_begins_with_the_pair_and_can_be_watched(tmp_path):
    size = ["--seed", 4, "--width", 120, "--height", 60, "--disparities", 16]
    succeed("scene", "--out", tmp_path / "pair", *size)
    moving = tmp_path / "moving"
    assert "7 frames" in succeed("scene", "--out", moving, *size, "--frames", 7)
    kinds = sorted(path.stem for path in (tmp_path / "pair").iterdir())
    assert sorted(path.name for path in moving.iterdir()) == kinds
    for kind in kinds:
        frames = sorted((moving / kind).iterdir())
        assert [path.name for path in frames] == [f"{number:05}.png" for number in range(7)]
        assert frames[0].read_bytes() == (tmp_path / "pair" / f"{kind}.png").read_bytes()
    assert len({path.read_bytes() for path in (moving / "disparity_right").iterdir()}) == 7
    words = ["--left", moving / "left", "--right", moving / "right", "--config", "tiny", "--set", "disparities=16"]
    assert "7 frames" in succeed("video", *words, "--out", tmp_path / "maps")


def test_scene_fits_a_configuration(tmp_path):
    succeed("scene", "--out", tmp_path / "s", "--seed", 3, "--config", "tiny")
    pair = ["--left", tmp_path / "s" / "left.png", "--right", tmp_path / "s" / "right.png"]
    assert "32x12" in succeed("match", "--config", "tiny", "--engine", "clocked", *pair, "--out", tmp_path / "m")


@pytest.mark.parametrize("seed", ["-1", str(2**64), "9" * 300, "1.5", "0x1"])
def test_seeds_that_would_be_another_number(tmp_path, seed):
    """A message fits a line."""
    words = [PROGRAM, "scene", "--config", "tiny", f"--seed={seed}", "--out", tmp_path / "out"]
    result = subprocess.run(words, capture_output=True, text=True)
    assert result.returncode == 2 and "not a whole number of 0 ... 18446744073709551615" in result.stderr
    assert not (tmp_path / "out").exists()
