# SPDX-License-Identifier: Apache-2.0
"""Speckles and confidence behind any configuration's map, in the command match."""

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, changed, fail, match_facts, png_size, succeed


def test_speckles_and_confidence(tmp_path, match):
    def files():
        return {p.name for p in (tmp_path / "out").iterdir()}

    succeed(*match)
    without, map_before = files(), (tmp_path / "out" / "disparity.png").read_bytes()
    out = succeed(*match, "--speckle-window", 400)
    assert "valid pixels: 0.00 %" in out, "no set has 400 of the map's 288 pixels"
    assert files() == without | {"valid.png"}
    assert (tmp_path / "out" / "disparity.png").read_bytes() == map_before, "only the validity changes"
    assert "valid pixels: 100.00 %" in succeed(*match, "--speckle-window", 1, "--speckle-range", 256)
    succeed(*match, "--confidence")
    assert files() == without | {"confidence.png"}
    assert png_size(tmp_path / "out" / "confidence.png") == (WIDTH - DISPARITIES, HEIGHT)
    succeed(*match, "--least-confidence", 128, "--speckle-window", 3, "--speckle-range", 2)
    assert files() == without | {"valid.png"}
    facts = match_facts(tmp_path)
    assert facts["postprocessing"] == {"speckle_window_px": 3, "speckle_range_px": 2, "least_confidence": 128}
    assert facts["density"] < 1, "random images"


def test_both_engines_give_one_confidence(tmp_path, match):
    words = ["--confidence", "--least-confidence", 1]
    succeed(*match, *words)
    succeed(*changed(match, "--out", tmp_path / "clocked"), *words, "--engine", "clocked")
    for name in ("confidence.png", "valid.png", "disparity.png"):
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / "clocked" / name).read_bytes()


@pytest.mark.parametrize(
    "words",
    [
        ["--speckle-window", -1],
        ["--speckle-range", 1],
        ["--speckle-window", 9, "--speckle-range", 257],
        ["--least-confidence", 256],
        ["--least-confidence", "half"],
    ],
)
def test_postprocessing_out_of_range(tmp_path, match, words):
    fail(tmp_path, *match, *words, says=[words[-2] if len(words) > 2 else words[0]])
