# SPDX-License-Identifier: Apache-2.0
"""Pixels of 10 and 12 bits in the commands match, vectors and scene."""

import json
import random

import pytest

from stereo_hls_program import HEIGHT, WIDTH, changed, deep_image, fail, png_depth, succeed


def deep_pair(tmp_path, bits, width=WIDTH):
    """Noise over the whole range. The left image is moved by 3 pixels, and a third of its pixels are others."""
    noise = random.Random(bits)
    values = [[noise.randrange(1 << bits) for _ in range(width + 3)] for _ in range(HEIGHT)]
    values[0][3], values[0][4] = 0, (1 << bits) - 1
    others = [[value if noise.random() < 2 / 3 else noise.randrange(1 << bits) for value in row] for row in values]
    left = deep_image(tmp_path / "deep_l.pgm", lambda x, y: others[y][x], width)
    right = deep_image(tmp_path / "deep_r.pgm", lambda x, y: values[y][x + 3], width)
    return ["--left", left, "--right", right]


@pytest.mark.parametrize(
    "config,bits,width",
    [
        ("tiny_10bit", 10, WIDTH),
        ("tiny_12bit_all", 12, WIDTH),
        ("tiny_sgm_10bit", 10, 40),
        ("tiny_sgm_12bit_all", 12, 40),
        ("tiny_trellis_12bit", 12, 40),
    ],
)
def test_match_of_pixels_of_more_bits(tmp_path, config, bits, width):
    pair = deep_pair(tmp_path, bits, width)
    for engine in ("fast", "clocked"):
        succeed("match", "--config", config, "--engine", engine, *pair, "--out", tmp_path / engine)
    maps = [(tmp_path / engine / "disparity.png").read_bytes() for engine in ("fast", "clocked")]
    assert maps[0] == maps[1]
    assert json.loads((tmp_path / "fast" / "match.json").read_text())["pixel_bits"] == bits


def test_match_with_pixel_bits_set(tmp_path):
    succeed("match", "--config", "tiny", "--set", "pixel_bits=12", *deep_pair(tmp_path, 12), "--out", tmp_path / "out")


def test_8_bits_are_taken_as_they_are(tmp_path, match):
    """With the plain costs of `tiny` the map is that of 8 bits."""
    succeed(*match)
    wider = changed(changed(match, "--config", "tiny_10bit"), "--out", tmp_path / "wider")
    succeed(*wider)
    maps = [(tmp_path / folder / "disparity.png").read_bytes() for folder in ("out", "wider")]
    assert maps[0] == maps[1]


def test_refuses_pixels_beyond_the_range(tmp_path):
    pair, out = deep_pair(tmp_path, 10), ["--out", tmp_path / "out"]
    deep_image(pair[1], lambda x, y: 1024 if (x, y) == (5, 7) else 1023)
    says = ["deep_l.pgm", "grey value 1024 at x=5 y=7", "pixels of 10 bits are at most 1023"]
    fail(tmp_path, "match", "--config", "tiny_10bit", *pair, *out, says=says)
    fail(tmp_path, "vectors", "--config", "tiny_10bit", *pair, *out, says=says)
    fail(tmp_path, "match", "--config", "tiny", *pair, *out, says=["16 bits a channel but must have 8"])
    fail(
        tmp_path,
        "match",
        "--config",
        "tiny",
        "--set",
        "pixel_bits=11",
        *pair,
        *out,
        says=["11 but must be 8, 10 or 12"],
    )
    fail(tmp_path, "match", "--config", "tiny_phase", "--set", "pixel_bits=10", *pair, *out, says=["no such option"])


def test_scene_fills_the_range_of_its_configuration(tmp_path):
    succeed("scene", "--config", "tiny_12bit_all", "--seed", 1, "--out", tmp_path / "scene")
    assert png_depth(tmp_path / "scene" / "left.png") == 16
    assert png_depth(tmp_path / "scene" / "visible_left.png") == 8
