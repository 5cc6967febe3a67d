# SPDX-License-Identifier: Apache-2.0
"""Pixels of 10 and 12 bits in the commands match, evaluate, depth, video, vectors and scene."""

import json
import random

import pytest

import plane_scene
from stereo_hls_program import HEIGHT, WIDTH, changed, deep_image, fail, gray_image, png_depth, succeed


def deep_pair(tmp_path, bits, width=WIDTH, height=HEIGHT):
    """Noise over the whole range. The left image is moved by 3 pixels, and a third of its pixels are others."""
    noise = random.Random(bits)
    values = [[noise.randrange(1 << bits) for _ in range(width + 3)] for _ in range(height)]
    values[0][3], values[0][4] = 0, (1 << bits) - 1
    others = [[value if noise.random() < 2 / 3 else noise.randrange(1 << bits) for value in row] for row in values]
    left = deep_image(tmp_path / "deep_l.pgm", lambda x, y: others[y][x], width, height)
    right = deep_image(tmp_path / "deep_r.pgm", lambda x, y: values[y][x + 3], width, height)
    return ["--left", left, "--right", right]


@pytest.mark.parametrize(
    "config,bits,width,height",
    [
        ("tiny_10bit", 10, WIDTH, HEIGHT),
        ("tiny_12bit_all", 12, WIDTH, HEIGHT),
        ("tiny_sgm_10bit", 10, 40, HEIGHT),
        ("tiny_sgm_12bit_all", 12, 40, HEIGHT),
        ("tiny_trellis_12bit", 12, 40, HEIGHT),
        ("tiny_phase_10bit", 10, 40, 18),
        ("tiny_phase_12bit", 12, 40, 26),
        ("tiny_dynamic_10bit", 10, 64, 32),
        ("tiny_dynamic_12bit", 12, 64, 32),
    ],
)
def test_match_of_pixels_of_more_bits(tmp_path, config, bits, width, height):
    pair = deep_pair(tmp_path, bits, width, height)
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
    fail(tmp_path, "match", "--config", "example", "--set", "pixel_bits=10", *pair, *out, says=["no such option"])


def test_scene_fills_the_range_of_its_configuration(tmp_path):
    succeed("scene", "--config", "tiny_12bit_all", "--seed", 1, "--out", tmp_path / "scene")
    assert png_depth(tmp_path / "scene" / "left.png") == 16
    assert png_depth(tmp_path / "scene" / "visible_left.png") == 8


def moved_pair(folder, bits, values=256, factor=None, width=80, height=40, shift=3):
    """A pair whose right image is moved by `shift`: grey values 0 ... `values` - 1, times as much as fills the bits."""
    folder.mkdir()
    factor = factor or (1 << bits) // values
    noise = random.Random(1)
    ground = [[factor * noise.randrange(values) for _ in range(width + shift)] for _ in range(height)]
    write, size = (gray_image if bits == 8 else deep_image), {"width": width, "height": height}
    left = write(folder / "l.pgm", lambda x, y: ground[y][x], **size)
    right = write(folder / "r.pgm", lambda x, y: ground[y][x + shift], **size)
    return ["--left", left, "--right", right]


def evaluated(tmp_path, images, *words):
    truth = gray_image(tmp_path / "truth.pgm", lambda x, y: 3, 80, 40)
    both = ["--truth-left", truth, "--truth-right", truth]
    out = succeed("evaluate", *images, *both, *words, "--json", tmp_path / "e.json")
    return out, json.loads((tmp_path / "e.json").read_text())["methods"]


def test_evaluate_measures_as_with_8_bits(tmp_path):
    """Grey values that are 16 times as large: the same maps and masks, for OpenCV the same images."""
    words = ["--config", "tiny", "--set", "window_px=5", "--opencv", "bm", "--opencv-disparities", 16, "--gain", 2]
    _, [tiny, bm] = evaluated(tmp_path, moved_pair(tmp_path / "8", 8, values=64, factor=2), *words)
    deep = moved_pair(tmp_path / "12", 12, values=64, factor=32)
    out, [deeper, deeper_bm] = evaluated(tmp_path, deep, *words, "--set", "pixel_bits=12")
    assert tiny["masks"] == deeper["masks"] and len(tiny["masks"]) >= 3
    assert bm["masks"] == deeper_bm["masks"] and bm["parameters"] == deeper_bm["parameters"]
    remark = "StereoBM gets the upper 8 of the images' 12 bits"
    assert deeper_bm["remarks"][0] == remark and remark in out and bm["remarks"] == []
    assert (tiny["parameters"]["pixel_bits"], deeper["parameters"]["pixel_bits"]) == (8, 12)


def test_evaluate_sees_the_lowest_bits(tmp_path):
    dark = moved_pair(tmp_path / "dark", 12, values=16, factor=1)
    words = ["--config", "tiny", "--set", "pixel_bits=12", "--opencv", "bm", "--opencv-disparities", 16]
    _, [core, bm] = evaluated(tmp_path, dark, *words)
    assert core["masks"]["all"]["bad_1"]["valid_only"] == 0 and core["masks"]["all"]["density"] > 0.7
    assert bm["masks"]["all"]["density"] == 0, "its 8 bits are all 0"
    assert core["masks"]["textureless"]["pixels"] == core["masks"]["non_occluded"]["pixels"]


def test_evaluate_takes_the_bits_that_all_configurations_take(tmp_path):
    both = ["--config", "tiny", "--config", "tiny_10bit"]
    _, methods = evaluated(tmp_path, moved_pair(tmp_path / "8", 8), *both)
    assert methods[0]["masks"] == methods[1]["masks"]
    deep = moved_pair(tmp_path / "12", 12)
    arguments = ["evaluate", *deep, "--truth-left", tmp_path / "truth.pgm", "--config"]
    fail(tmp_path, *arguments, "tiny", "--config", "tiny_10bit", says=["l.pgm", "16 bits a channel but must have 8"])
    fail(tmp_path, *arguments, "tiny_10bit", says=["l.pgm", "pixels of 10 bits are at most 1023"])
    fail(tmp_path, *arguments[:-1], "--opencv", "bm", says=["16 bits a channel but must have 8"])


def test_the_clocked_core_is_measured_on_pixels_of_more_bits(tmp_path):
    truth = gray_image(tmp_path / "truth.pgm", lambda x, y: 3)
    words = ["evaluate", *deep_pair(tmp_path, 10), "--truth-right", truth, "--config", "tiny_10bit", "--border", 0]
    methods = []
    for engine in ("fast", "clocked"):
        succeed(*words, "--engine", engine, "--json", tmp_path / "e.json")
        methods += json.loads((tmp_path / "e.json").read_text())["methods"]
    assert methods[0]["masks"] == methods[1]["masks"] and methods[0]["masks"]


def test_depth_of_pixels_of_more_bits(tmp_path):
    calibration = tmp_path / "c.yml"
    camera = "!!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ {} ]\n"
    matrices = {name: camera.format("100., 0., 40., 0., 100., 20., 0., 0., 1.") for name in ("M1", "M2")}
    matrices["R"] = camera.format("1., 0., 0., 0., 1., 0., 0., 0., 1.")
    matrices["T"] = camera.replace("cols: 3", "cols: 1").format("-0.05, 0., 0.")
    calibration.write_text("%YAML:1.0\n---\n" + "".join(f"{name}: {text}" for name, text in matrices.items()))
    words = ["depth", "--calibration", calibration, "--config", "tiny"]
    for bits in (8, 12):
        images = moved_pair(tmp_path / str(bits), bits)
        for way in ([], ["--rectified"]):
            out = tmp_path / f"out{bits}{len(way)}"
            succeed(*words, *images, *way, "--set", f"pixel_bits={bits}", "--out", out)
    for way in (0, 1):
        for name in ("depth.png", "cloud.ply", "preview.png"):
            narrow, deep = (tmp_path / f"out{bits}{way}" / name for bits in (8, 12))
            assert narrow.read_bytes() == deep.read_bytes(), (name, way)
    assert {bits: png_depth(tmp_path / f"out{bits}0" / "left.png") for bits in (8, 12)} == {8: 8, 12: 16}
    assert json.loads((tmp_path / "out120" / "depth.json").read_text())["parameters"]["pixel_bits"] == 12
    deep = moved_pair(tmp_path / "again", 12)
    out = ["--out", tmp_path / "none"]
    fail(tmp_path, *words, *deep, *out, says=["16 bits a channel but must have 8"])
    fail(tmp_path, *words, *deep, "--set", "pixel_bits=10", *out, says=["l.pgm", "at most 1023"])


def test_video_of_folders_of_pixels_of_more_bits(tmp_path):
    for bits in (8, 12):
        folder = tmp_path / str(bits)
        moved_pair(folder, bits)
        for camera in ("l", "r"):
            (folder / camera).mkdir()
            (folder / f"{camera}.pgm").rename(folder / camera / "0.pgm")
        cameras = ["--left", folder / "l", "--right", folder / "r"]
        succeed("video", *cameras, "--config", "tiny", "--set", f"pixel_bits={bits}", "--out", folder / "out")
    frames = [tmp_path / str(bits) / "out" / "frame_000000.png" for bits in (8, 12)]
    assert frames[0].read_bytes() == frames[1].read_bytes()
    out = ["--out", tmp_path / "none"]
    fail(tmp_path, "video", *cameras, "--config", "tiny", *out, says=["0.pgm", "16 bits a channel but must have 8"])
    fail(tmp_path, "video", *cameras, "--config", "tiny_10bit", *out, says=["0.pgm", "at most 1023"])


@pytest.mark.parametrize("deep_side", ["left", "right"])
@pytest.mark.parametrize("command", ["match", "evaluate", "depth", "rectify", "video"])
def test_one_image_of_8_bits_beside_one_of_16_is_refused(tmp_path, command, deep_side):
    for side in ("left", "right"):
        (tmp_path / side).mkdir()
        made = deep_image if side == deep_side else gray_image
        made(tmp_path / side / "0.pgm", lambda x, y: (x * y) % 256, plane_scene.WIDTH, plane_scene.HEIGHT)
    words = [word for side in ("left", "right") for word in (f"--{side}", tmp_path / side / "0.pgm")]
    if command == "video":
        words = ["--left", tmp_path / "left", "--right", tmp_path / "right"]
    if command in ("depth", "rectify"):
        words += ["--calibration", plane_scene.calibration(tmp_path / "c.yml")]
    words += ["--set", "pixel_bits=10"] if command == "rectify" else ["--config", "tiny_10bit"]
    words += (
        ["--truth-left", tmp_path / "left" / "0.pgm"]
        if command == "evaluate"
        else ["--out", "out", *(["--fit", "crop"] if command == "match" else [])]
    )
    bits = {"left": "16 bits a channel and the right one 8", "right": "8 bits a channel and the right one 16"}
    fail(tmp_path, command, *words, says=[bits[deep_side]])
