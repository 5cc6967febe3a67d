# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls depth: what it measures and writes, and what match says of pairs that are not rectified."""

import json
import random
import struct

import pytest

from plane_scene import BASELINE, FOCAL, HEIGHT, SHIFT, WIDTH, Z_MM, calibration, ground, plane, ply_points, png_pixels
from stereo_hls_program import fail, png_depth, png_size, succeed, write_image


@pytest.mark.parametrize("reference", ["left", "right"])
@pytest.mark.parametrize("subpixel", ["false", "true"])
def test_a_plane_stands_where_it_stands(tmp_path, depth, reference, subpixel):
    settings = ["--set", "window_px=15", "--set", f"reference={reference}", "--set", f"subpixel={subpixel}"]
    out = succeed(*depth, calibration(tmp_path / "c.yml"), *plane(tmp_path), "--rectified", *settings)
    assert png_depth(tmp_path / "out" / "depth.png") == 16
    assert png_size(tmp_path / "out" / "depth.png") == (WIDTH, HEIGHT)
    rows = png_pixels(tmp_path / "out" / "depth.png")
    columns = range(40, 120)
    # Subpixel disparities are whole here, give or take a sixteenth or two.
    tolerance = 0 if subpixel == "false" else Z_MM * 2 / 16 / SHIFT
    assert all(abs(rows[y][x] - Z_MM) <= tolerance for x in columns for y in range(8, HEIGHT - 8))
    outside = range(16) if reference == "left" else range(WIDTH - 16, WIDTH)
    assert not any(rows[y][x] for x in outside for y in range(HEIGHT)), "no disparity there: unknown"
    points = ply_points(tmp_path / "out" / "cloud.ply")
    assert len(points) == sum(value != 0 for row in rows for value in row)
    facts = json.loads((tmp_path / "out" / "depth.json").read_text())
    assert facts["format"] == "stereo-hls depth 1" and facts["depth_unit"] == "mm" and facts["rectified_before"] is True
    assert facts["focal_px"] == FOCAL and facts["baseline_mm"] == pytest.approx(1000 * BASELINE)
    assert facts["known_px"] == len(points) and facts["parameters"]["reference"] == reference
    assert f"baseline 50 mm: depth of {len(points)} of {WIDTH * HEIGHT} pixels" in out and "warning" not in out
    assert sorted(p.name for p in (tmp_path / "out").iterdir()) == [
        "cloud.ply",
        "depth.json",
        "depth.png",
        "preview.png",
    ]
    if subpixel == "true":
        return
    x, y, z, red, green, blue = points[len(points) // 2]
    assert z == pytest.approx(FOCAL * BASELINE / SHIFT) and red == green == blue
    u, v = x * FOCAL / z + WIDTH / 2, y * FOCAL / z + HEIGHT / 2
    assert (u, v) == pytest.approx((round(u), round(v)), abs=1e-3), "it projects to the middle of a pixel"
    assert red == ground()(round(u), round(v)), "the grey value of the left pixel that sees it"


def test_depth_and_cloud_in_other_formats(tmp_path, depth):
    """The same numbers; evaluate reads the TIFF, which knows floats."""
    words = [calibration(tmp_path / "c.yml"), *plane(tmp_path), "--rectified", "--set", "subpixel=true"]
    succeed(*depth, *words)
    binary, rows = ply_points(tmp_path / "out" / "cloud.ply"), png_pixels(tmp_path / "out" / "depth.png")
    succeed(*depth, *words, "--ply", "ascii", "--tiff")
    header, body = (tmp_path / "out" / "cloud.ply").read_text().split("end_header\n")
    assert header.startswith("ply\nformat ascii 1.0\n") and f"element vertex {len(binary)}\n" in header
    texts = [line.split() for line in body.splitlines()]
    floats = [struct.unpack("<fff", struct.pack("<fff", *map(float, line[:3]))) for line in texts]
    assert [(*place, *map(int, line[3:])) for place, line in zip(floats, texts)] == binary
    # As a map of its own: each value of the TIFF is that of the PNG, rounded.
    pgm = tmp_path / "png.pgm"
    pgm.write_bytes(
        f"P5\n{WIDTH} {HEIGHT}\n65535\n".encode() + b"".join(v.to_bytes(2, "big") for row in rows for v in row)
    )
    evaluate = ["evaluate", *words[1:5], "--truth-left", pgm, "--truth-scale", 1, "--border", 0, "--reference", "left"]
    tiff = ["--disparity", tmp_path / "out" / "depth.tiff", "--unknown", 0]
    succeed(*evaluate, *tiff, "--json", tmp_path / "e.json")
    measures = json.loads((tmp_path / "e.json").read_text())["methods"][0]["masks"]["all"]
    assert measures["pixels"] == len(binary) and measures["density"] == 1
    assert 0 < measures["avg_px"] <= 0.5 and measures["bad_0_5"]["invalid_bad"] < 0.01
    succeed(*depth, *words)
    assert not (tmp_path / "out" / "depth.tiff").exists(), "that of an earlier run"
    assert json.loads((tmp_path / "out" / "depth.json").read_text())["depth_png_mm_per_value"] == 1


def test_lengths_are_in_the_unit_of_the_calibration(tmp_path, depth):
    millimetres = calibration(tmp_path / "c.yml", baseline=1000 * BASELINE)
    succeed(*depth, millimetres, *plane(tmp_path), "--rectified", "--unit-mm", 1)
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == Z_MM
    assert ply_points(tmp_path / "out" / "cloud.ply")[1000][2] == pytest.approx(Z_MM / 1000, rel=1e-3)


def test_depths_that_are_left_out(tmp_path, depth):
    """By their size, by speckles, by confidence: as match has them, and in every file."""
    yml, pair = calibration(tmp_path / "c.yml"), [*plane(tmp_path), "--rectified"]
    pixels = bytearray(pair[3].read_bytes())
    for y in range(30, 90):  # the right camera sees something else here, which gives wrong matches
        start = len(pixels) - WIDTH * (HEIGHT - y) + 60
        pixels[start : start + 40] = random.Random(y).randbytes(40)
    pair[3].write_bytes(pixels)
    succeed(*depth, yml, *pair, "--least-depth-mm", Z_MM - 1, "--largest-depth-mm", Z_MM + 1, "--tiff")
    facts = json.loads((tmp_path / "out" / "depth.json").read_text())
    assert facts["least_depth_mm"] == Z_MM - 1 and facts["left_out_px"] > 0
    assert facts["nearest_mm"] == facts["farthest_mm"] == Z_MM
    assert {round(1000 * z) for _, _, z, *_ in ply_points(tmp_path / "out" / "cloud.ply")} == {Z_MM}
    kept = sum(value == Z_MM for row in png_pixels(tmp_path / "out" / "depth.png") for value in row)
    succeed(*depth, yml, *pair)
    facts = json.loads((tmp_path / "out" / "depth.json").read_text())
    assert facts["left_out_px"] == 0 and facts["least_depth_mm"] is None
    rows = png_pixels(tmp_path / "out" / "depth.png")
    assert kept == sum(value == Z_MM for row in rows for value in row) < sum(value > 0 for row in rows for value in row)
    filters = ["--speckle-window", 400, "--speckle-range", 1, "--least-confidence", 100]
    succeed(*depth, yml, *pair, *filters)
    found = png_pixels(tmp_path / "out" / "depth.png")
    succeed("match", "--config", "study", *pair[:-1], *filters, "--out", tmp_path / "m")
    valid = png_pixels(tmp_path / "m" / "valid.png")
    first = json.loads((tmp_path / "m" / "match.json").read_text())["output_first_column"]
    places = [(x, y) for y in range(HEIGHT) for x in range(len(valid[0])) if rows[y][first + x]]
    assert all((found[y][first + x] > 0) == (valid[y][x] > 0) for x, y in places)
    assert 0 < sum(value > 0 for row in found for value in row) < sum(value > 0 for row in rows for value in row)
    json_of_depth = json.loads((tmp_path / "out" / "depth.json").read_text())
    assert json_of_depth["postprocessing"] == json.loads((tmp_path / "m" / "match.json").read_text())["postprocessing"]
    limits = ["--least-depth-mm", 2000, "--largest-depth-mm", 1000]
    fail(tmp_path, *depth, yml, *pair, *limits, says=["--least-depth-mm", "--largest-depth-mm"])
    fail(tmp_path, *depth, yml, *pair, "--largest-depth-mm", 0, says=["--largest-depth-mm"])
    fail(tmp_path, *depth, yml, *pair, "--speckle-range", 2, says=["--speckle-window"])


def test_pairs_that_are_exchanged_or_reach_farther(tmp_path, depth):
    yml, pair = calibration(tmp_path / "c.yml"), [*plane(tmp_path), "--rectified"]
    exchanged = ["--left", pair[3], "--right", pair[1], "--rectified"]
    for command in ([*depth, yml], ["match", "--config", "study", "--out", tmp_path / "m"]):
        rectified = slice(None) if command[0] == "depth" else slice(4)
        assert "warning: left and right look exchanged" in succeed(*command, *exchanged[rectified])
        out = succeed(*command, *pair[rectified], "--set", "disparities=4")
        assert "warning: the range of disparities, 0 ... 3 px, looks too short" in out
        assert "warning" not in succeed(*command, *pair[rectified])


def test_turned_cameras_are_rectified(tmp_path, depth):
    turn, pair = 0.1, plane(tmp_path, 0.1)
    assert "warning: the images do not look rectified" in succeed(
        "match", "--config", "study", *pair, "--out", tmp_path / "m"
    )
    intrinsics = calibration(tmp_path / "intrinsics.yml", R=None, T=None)
    extrinsics = calibration(tmp_path / "extrinsics.yml", turn=turn, M1=None, D1=None, M2=None, D2=None)
    exact = ["--set", "window_px=15", "--set", "subpixel=true"]
    out = succeed(*depth, intrinsics, "--extrinsics", extrinsics, *pair, *exact)
    assert "before rectification" in out and "warning" not in out
    facts = json.loads((tmp_path / "out" / "depth.json").read_text())
    assert facts["baseline_mm"] == pytest.approx(1000 * BASELINE) and facts["rectified_before"] is False
    # Rectified, focal length and disparity are others; the plane's distance stays.
    assert facts["focal_px"] > 1.05 * FOCAL
    rows = png_pixels(tmp_path / "out" / "depth.png")
    assert all(abs(rows[y][x] - Z_MM) < 0.03 * Z_MM for x in range(60, 110) for y in range(20, HEIGHT - 20))
    assert {"left.png", "right.png"} <= {p.name for p in (tmp_path / "out").iterdir()}
    rectified = ["--left", tmp_path / "out" / "left.png", "--right", tmp_path / "out" / "right.png"]
    assert "warning" not in succeed("match", "--config", "study", *rectified, "--out", tmp_path / "m")
    # What is not rectified is said, not hidden: by the calibration, else by the images.
    says = ["R turns the right camera by 5.7", "leave --rectified out"]
    fail(tmp_path, *depth, intrinsics, "--extrinsics", extrinsics, *pair, "--rectified", says=says)
    straight = calibration(tmp_path / "straight.yml")
    assert "warning: the images do not look rectified" in succeed(*depth, straight, *pair, "--rectified")


def test_match_says_nothing_of_a_rectified_pair(tmp_path):
    assert "warning" not in succeed("match", "--config", "study", *plane(tmp_path), "--out", tmp_path / "m")


def test_colours_reach_the_cloud(tmp_path, depth):
    pair = plane(tmp_path)
    for option, name in (("--left", "left"), ("--right", "right")):
        gray = (tmp_path / f"{name}.pgm").read_bytes()[-WIDTH * HEIGHT :]
        color = tmp_path / f"{name}.ppm"
        color.write_bytes(f"P6\n{WIDTH} {HEIGHT}\n255\n".encode() + b"".join(bytes((v, v // 2, 9)) for v in gray))
        pair[pair.index(option) + 1] = color
    succeed(*depth, calibration(tmp_path / "c.yml"), *pair, "--rectified")
    points = ply_points(tmp_path / "out" / "cloud.ply")
    assert points and all(blue == 9 and green == red // 2 for *_, red, green, blue in points)


def test_rectified_images_of_an_earlier_run_do_not_stay(tmp_path, depth):
    arguments = [*depth, calibration(tmp_path / "c.yml"), *plane(tmp_path)]
    others = {"cloud.ply", "depth.json", "depth.png", "preview.png"}
    succeed(*arguments)
    assert {p.name for p in (tmp_path / "out").iterdir()} == others | {"left.png", "right.png"}
    made = ["--left", tmp_path / "out" / "left.png", "--right", tmp_path / "out" / "right.png"]
    succeed(*arguments[:-4], *made, "--rectified")
    assert {p.name for p in (tmp_path / "out").iterdir()} == others | {"left.png", "right.png"}, "they were read"
    succeed(*arguments, "--rectified")
    assert {p.name for p in (tmp_path / "out").iterdir()} == others


def test_images_that_do_not_fit(tmp_path, depth):
    pair, other = plane(tmp_path), write_image(tmp_path / "o.pgm", WIDTH, HEIGHT + 2)
    yml = calibration(tmp_path / "c.yml")
    fail(tmp_path, *depth, yml, *pair[:3], other, says=["differ in size", "160x120", "160x122"])
    fail(tmp_path, *depth, yml, *pair[:3], tmp_path / "no.png", says=["no.png", "no such file"])
    fail(
        tmp_path,
        *depth,
        yml,
        *pair[:3],
        write_image(tmp_path / "d.pgm", WIDTH, HEIGHT, maximum=65535),
        says=["16 bits"],
    )
    fail(tmp_path, *depth, tmp_path / "no.yml", *pair, says=["no.yml", "no such file"])
    fail(tmp_path, *depth, tmp_path, *pair, says=[tmp_path, "is a folder"])
