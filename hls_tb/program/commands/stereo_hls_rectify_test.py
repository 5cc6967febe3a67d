# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls rectify."""

import json

import pytest

from plane_scene import FOCAL, HEIGHT, WIDTH, calibration, png_pixels
from stereo_hls_program import changed, deep_image, fail, gray_image, png_depth, png_size, succeed, write_image

BENT = [-0.2, 0.05, 0.0, 0.0, 0.0]  # a lens that bends outlines outwards


@pytest.fixture
def images(tmp_path):
    return [
        "--left",
        gray_image(tmp_path / "l.pgm", lambda x, y: (2 * x + y) % 256, WIDTH, HEIGHT),
        "--right",
        gray_image(tmp_path / "r.pgm", lambda x, y: (x + 3 * y) // 3, WIDTH, HEIGHT),
    ]


@pytest.fixture
def rectify(tmp_path):
    return ["rectify", "--out", tmp_path / "out", "--calibration"]


SIZE = ["--width", WIDTH, "--height", HEIGHT]


def files(folder):
    return {path.name for path in folder.iterdir()}


def nodes(path):
    """The offsets of a table, each from a word of 16 bits across and 16 bits down."""
    words = [int(line, 16) for line in path.read_text().split()]
    return [((word & 0xFFFF ^ 0x8000) - 0x8000, (word >> 16 ^ 0x8000) - 0x8000) for word in words]


def test_straight_cameras_need_nothing(tmp_path, rectify, images):
    out = succeed(*rectify, calibration(tmp_path / "c.yml"), *images)
    assert files(tmp_path / "out") == {"left.png", "right.png", "left_table.hex", "right_table.hex", "rectify.json"}
    facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
    assert facts["format"] == "stereo-hls rectify 1"
    assert (facts["table_columns"], facts["table_rows"]) == (WIDTH // 16 + 1, (HEIGHT - 1) // 16 + 2)
    assert facts["table_bits"] == facts["table_columns"] * facts["table_rows"] * 32
    assert nodes(tmp_path / "out" / "left_table.hex") == [(0, 0)] * (facts["table_columns"] * facts["table_rows"])
    assert f"{facts['table_bits']} bits a camera" in out
    # The neighbour below counts as needed, though with weight 0.
    assert facts["parameters"]["rows_above"] == 0 and facts["parameters"]["rows_below"] == 1
    assert facts["lag_rows"] == 2 and facts["buffered_rows"] == 4
    assert facts["left"]["largest_grey_difference"] == 0
    assert png_pixels(tmp_path / "out" / "left.png") == [
        [(2 * x + y) % 256 for x in range(WIDTH)] for y in range(HEIGHT)
    ]


def test_a_bent_and_turned_pair(tmp_path, rectify, images):
    bent = calibration(tmp_path / "c.yml", turn=0.04, D1=(BENT, 5), D2=(BENT, 5))
    out = succeed(*rectify, bent, *images)
    facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
    needs = [facts[side] for side in ("left", "right")]
    assert facts["parameters"]["rows_above"] == max(side["rows_above"] for side in needs) > 1
    assert facts["parameters"]["rows_below"] == max(side["rows_below"] for side in needs) > 1
    assert facts["lag_rows"] == facts["parameters"]["rows_below"] + 1
    assert f"{facts['buffered_rows']} buffered, {facts['buffer_bits']} bits a camera" in out
    for side in needs:
        assert 0 < side["mean_place_difference_px"] < side["largest_place_difference_px"] < 0.2
        assert 0 < side["mean_grey_difference"] < 1 <= side["largest_grey_difference"]
    assert f"at most {needs[0]['largest_grey_difference']:g} grey levels" in out
    assert png_size(tmp_path / "out" / "left.png") == (WIDTH, HEIGHT)
    # The same maps as `depth` takes, but for the rounding of places and nodes.
    succeed("depth", "--config", "study", "--calibration", bent, *images, "--out", tmp_path / "depth")
    theirs, ours = png_pixels(tmp_path / "depth" / "right.png"), png_pixels(tmp_path / "out" / "right.png")
    largest = max(abs(a - b) for row, other in zip(ours, theirs) for a, b in zip(row, other))
    assert largest == needs[1]["largest_grey_difference"]


def deep_images(tmp_path, bits):
    """The whole range, down to the lowest bit."""
    return [
        "--left",
        deep_image(tmp_path / "deep_l.pgm", lambda x, y: (37 * x + 5 * y) % (1 << bits), WIDTH, HEIGHT),
        "--right",
        deep_image(tmp_path / "deep_r.pgm", lambda x, y: (21 * x + 11 * y + 1) % (1 << bits), WIDTH, HEIGHT),
    ]


@pytest.mark.parametrize("bits", [10, 12])
def test_pixels_of_more_bits(tmp_path, rectify, bits):
    pair, deep = deep_images(tmp_path, bits), ["--set", f"pixel_bits={bits}"]
    succeed(*rectify, calibration(tmp_path / "c.yml"), *pair, *deep)
    facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
    assert facts["parameters"]["pixel_bits"] == bits and facts["left"]["largest_grey_difference"] == 0
    assert facts["buffer_bits"] == facts["buffered_rows"] * (WIDTH + 2) * bits
    as_they_came = [[(37 * x + 5 * y) % (1 << bits) for x in range(WIDTH)] for y in range(HEIGHT)]
    assert png_pixels(tmp_path / "out" / "left.png") == as_they_came

    bent = calibration(tmp_path / "b.yml", turn=0.04, D1=(BENT, 5), D2=(BENT, 5))
    succeed(*rectify, bent, *pair, *deep)
    facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
    succeed("depth", "--config", "study", "--calibration", bent, *pair, *deep, "--out", tmp_path / "depth")
    theirs, ours = png_pixels(tmp_path / "depth" / "right.png"), png_pixels(tmp_path / "out" / "right.png")
    largest = max(abs(a - b) for row, other in zip(ours, theirs) for a, b in zip(row, other))
    assert largest == facts["right"]["largest_grey_difference"] > 0


def test_images_of_8_bits_are_taken_as_they_are(tmp_path, rectify, images):
    bent = calibration(tmp_path / "c.yml", D1=(BENT, 5))
    made = []
    for bits in (8, 12):
        succeed(*rectify, bent, *images, "--set", f"pixel_bits={bits}")
        made.append((tmp_path / "out" / "left.png").read_bytes())
    assert made[0] == made[1] and png_depth(tmp_path / "out" / "left.png") == 8
    deep = deep_images(tmp_path, 8)
    mixed = [*images[:2], *deep[2:], "--set", "pixel_bits=12"]
    fail(tmp_path, *rectify, bent, *mixed, says=["the left image has 8 bits a channel and the right one 16"])


def test_pixels_beyond_the_range_are_refused(tmp_path, rectify):
    yml, pair = calibration(tmp_path / "c.yml"), deep_images(tmp_path, 12)
    fail(tmp_path, *rectify, yml, *pair, says=["deep_l.pgm", "16 bits a channel but must have 8"])
    says = ["deep_l.pgm", "grey value", "pixels of 10 bits are at most 1023"]
    fail(tmp_path, *rectify, yml, *pair, "--set", "pixel_bits=10", says=says)


def test_a_finer_grid_is_closer(tmp_path, rectify):
    bent = calibration(tmp_path / "c.yml", D1=(BENT, 5))
    largest = []
    for grid in (32, 16, 8):
        succeed(*rectify, bent, *SIZE, "--set", f"grid_px={grid}", "--set", "offset_bits=16")
        facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
        assert facts["parameters"]["grid_px"] == grid and facts["table_columns"] == WIDTH // grid + 1
        largest.append(facts["left"]["largest_place_difference_px"])
    assert largest == sorted(largest, reverse=True) and largest[0] > 2 * largest[2]


def test_without_images_there_are_tables_only(tmp_path, rectify, images):
    yml = calibration(tmp_path / "c.yml", D1=(BENT, 5))
    succeed(*rectify, yml, *images)
    table = (tmp_path / "out" / "left_table.hex").read_text()
    out = succeed(*rectify, yml, *SIZE)
    assert files(tmp_path / "out") == {"left_table.hex", "right_table.hex", "rectify.json"}, "no earlier image stays"
    assert (tmp_path / "out" / "left_table.hex").read_text() == table
    assert "grey" not in out and "grey" not in (tmp_path / "out" / "rectify.json").read_text()


def test_nodes_say_how_pixels_move(tmp_path, rectify):
    """What the left camera sees stands 4 px lower in the right camera's image."""
    camera = [FOCAL, 0.0, WIDTH / 2, 0.0, FOCAL, HEIGHT / 2 + 4, 0.0, 0.0, 1.0]
    succeed(*rectify, calibration(tmp_path / "c.yml", M2=(camera, 3)), *SIZE)
    left, right = (nodes(tmp_path / "out" / f"{side}_table.hex") for side in ("left", "right"))
    assert {(x2 - x1, y2 - y1) for (x1, y1), (x2, y2) in zip(left, right)} == {(0, 4 * 64)}


def test_more_rows_than_needed_may_be_set_and_fewer_may_not(tmp_path, rectify):
    bent = calibration(tmp_path / "c.yml", D1=(BENT, 5))
    succeed(*rectify, bent, *SIZE)
    needed = json.loads((tmp_path / "out" / "rectify.json").read_text())["parameters"]["rows_above"]
    succeed(*rectify, bent, *SIZE, "--set", f"rows_above={needed + 3}")
    facts = json.loads((tmp_path / "out" / "rectify.json").read_text())
    assert facts["parameters"]["rows_above"] == needed + 3
    says = [f"--set rows_above={needed - 1}", f"this calibration needs {needed}"]
    fail(tmp_path, *rectify, bent, *SIZE, "--set", f"rows_above={needed - 1}", says=says)


@pytest.mark.parametrize(
    "options, says",
    [
        (["--set", "grid_px=12"], ["nodes is 12", "power of two"]),
        (["--set", "pixel_bits=9"], ["bits of a pixel is 9 but must be 8, 10 or 12"]),
        (["--set", "pixel_bits=16"], ["bits of a pixel is 16 but must be 8 ... 12"]),
        (["--set", "grid_px=2"], ["nodes is 2 but must be 4 ... 64"]),
        (["--set", "grid=8"], ["--set grid=8", "known are: pixel_bits, grid_px"]),
        (["--set", "grid_px=x"], ["--set grid_px=x", "a whole number"]),
        (["--set", "grid_px"], ["--set grid_px", "NAME=VALUE"]),
        (["--set", "width_px=8"], ["--set width_px=8", "no such option"]),
        (["--set", "offset_bits=8", "--set", "offset_fraction_bits=8"], ["more bits than fraction bits"]),
        (["--set", "rows_above=-1"], ["rows above is -1"]),
        (["--set", "rows_below=-9"], ["rows below is -9"]),
        (["--set", "rows_below=200"], ["image height is 120", "201"]),
        (["--set", "offset_bits=8", "--set", "offset_fraction_bits=7"], ["left camera", "8 bits", "offset_bits"]),
        (["--width", "4"], ["image width is 4"]),
        (["--width", "5000"], ["image width is 5000"]),
        (["--width", "0"], ["image width is 0"]),
        (["--height", "-1"], ["image height is -1"]),
        (["--width", "64"], ["M1", "64x120"]),
    ],
)
def test_wrong_options(tmp_path, rectify, options, says):
    arguments = [*rectify, calibration(tmp_path / "c.yml", D1=(BENT, 5)), *SIZE]
    if options[0] in SIZE:
        arguments, options = changed(arguments, *options), []
    fail(tmp_path, *arguments, *options, says=says)


def test_images_and_sizes(tmp_path, rectify, images):
    yml = calibration(tmp_path / "c.yml")
    fail(tmp_path, *rectify, yml, says=["--left and --right, or --width and --height"])
    fail(tmp_path, *rectify, yml, *images, *SIZE, says=["--left and --right, or --width and --height"])
    fail(tmp_path, *rectify, yml, *images[:2], says=["--left", "--right"])
    fail(tmp_path, *rectify, yml, *SIZE[:2], says=["--width", "--height"])
    other = write_image(tmp_path / "o.pgm", WIDTH, HEIGHT + 2)
    fail(tmp_path, *rectify, yml, *images[:3], other, says=["differ in size"])
    fail(tmp_path, *rectify, yml, *images[:3], tmp_path / "no.png", says=["no.png", "no such file"])
    fail(tmp_path, *rectify, tmp_path / "no.yml", *images, says=["no.yml", "no such file"])
    fail(tmp_path, *rectify, calibration(tmp_path / "r.yml", R=None), *SIZE, says=["lacks R"])
