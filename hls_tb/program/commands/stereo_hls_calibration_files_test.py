# SPDX-License-Identifier: Apache-2.0
"""Calibrations that the command depth reads: each program's files, sizes of images, units."""

import json
import math

import pytest

from plane_scene import (
    BASELINE,
    FOCAL,
    HEIGHT,
    SHIFT,
    WIDTH,
    Z_MM,
    Q,
    calibration,
    ground,
    of_q,
    plane,
    ply_points,
    png_pixels,
    with_size,
)
from stereo_hls_program import fail, gray_image, succeed


def test_calibrations_of_another_size(tmp_path, depth):
    """That of images twice as large. Scaled, the plane stands where it stood."""
    pair, names = plane(tmp_path), {"focal": 2 * FOCAL}
    large = [2 * FOCAL, 0.0, WIDTH - 0.5, 0.0, 2 * FOCAL, HEIGHT - 0.5, 0.0, 0.0, 1.0]
    for rectified in ([], ["--rectified"]):
        yml = calibration(tmp_path / "l.yml", **names, M1=(large, 3), M2=(large, 3))
        said = ["--calibrated-size", f"{2 * WIDTH}x{2 * HEIGHT}"]
        succeed(*depth, yml, *pair, *rectified, *said)
        assert abs(png_pixels(tmp_path / "out" / "depth.png")[60][80] - Z_MM) < 0.02 * Z_MM
        wrong = ["--calibrated-size", f"{2 * WIDTH}x{HEIGHT}"]
        fail(tmp_path, *depth, yml, *pair, *rectified, *wrong, says=["--calibrated-size", "no scaling"])
        with_size(yml, 2 * WIDTH, 2 * HEIGHT)
        says = ["images of 320x240 but these are 160x120", "--calibrated-size 320x240"]
        fail(tmp_path, *depth, yml, *pair, *rectified, says=says)
        succeed(*depth, yml, *pair, *rectified, *said)
        assert abs(png_pixels(tmp_path / "out" / "depth.png")[60][80] - Z_MM) < 0.02 * Z_MM
        other = ["--calibrated-size", f"{WIDTH}x{HEIGHT}"]
        fail(tmp_path, *depth, yml, *pair, *rectified, *other, says=["--calibrated-size 160x120", "320x240"])
    rectify = ["rectify", "--calibration", yml, *pair, "--out", tmp_path / "r"]
    fail(tmp_path, *rectify, says=["320x240"])
    succeed(*rectify, *said)
    succeed(*depth, with_size(calibration(tmp_path / "c.yml")), *pair)
    for word in ("640", "x480", "640x", "640x480x1", "0x480", "-640x480", "70000x480"):
        fail(tmp_path, *depth, yml, *pair, f"--calibrated-size={word}", says=["--calibrated-size", "WIDTHxHEIGHT"])


MIDDLEBURY = (
    f"cam0=[{FOCAL} 0 79.5; 0 {FOCAL} 59.5; 0 0 1]\ncam1=[{FOCAL} 0 82.5; 0 {FOCAL} 59.5; 0 0 1]\ndoffs=3\n"
    f"baseline={1000 * BASELINE}\nwidth={WIDTH}\nheight={HEIGHT}\nndisp=64\n"
)


def test_calibrations_of_benchmarks(tmp_path, depth):
    """In their own units: millimetres and metres."""
    pair = [*plane(tmp_path), "--rectified"]
    text = tmp_path / "calib.txt"
    text.write_text(MIDDLEBURY)
    out = succeed(*depth, text, *pair)
    assert "baseline 50 mm" in out and "warning" not in out
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == round(1000 * FOCAL * BASELINE / (SHIFT + 3))
    fail(tmp_path, *depth, text, *pair[:-1], says=["lacks R", "--rectified"])
    text.write_text(MIDDLEBURY.replace(f"width={WIDTH}", "width=320").replace(f"height={HEIGHT}", "height=240"))
    fail(tmp_path, *depth, text, *pair, says=["320x240", "160x120"])
    text.write_text(MIDDLEBURY.replace("doffs=3", "doffs=4"))
    fail(tmp_path, *depth, text, *pair, says=["calib.txt: its doffs is 4"])
    camera = f"{FOCAL} 0 79.5 {{}} 0 {FOCAL} 59.5 0 0 0 1 0"
    rows = [f"P{i}: {camera.format(FOCAL * x)}\n" for i, x in enumerate((0, -1, 0.02, 0.02 - BASELINE))]
    text.write_text("".join(rows))
    assert "baseline 50 mm" in succeed(*depth, text, *pair)
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == Z_MM
    assert "baseline 500 mm" in succeed(*depth, text, *pair, "--unit-mm", 10000), "what is given counts"


def test_a_principal_point_far_from_the_middle(tmp_path, depth):
    """As that of images of half and twice the size."""
    pair = [*plane(tmp_path), "--rectified"]
    for x, y in ((2 * 80.0, 2 * 60.0), (79.5, 1000.0), (4 * 80.0, 60.0)):
        q = [*Q[:3], -x, *Q[4:7], -y, *Q[8:]]
        yml = of_q(tmp_path / "q.yml", q)
        fail(tmp_path, *depth, yml, *pair, says=["principal point", "far from the middle of images of 160x120"])
        out = succeed(*depth, with_size(yml), *pair)
        assert "warning: the principal point" in out, "the file says that the images have its size"
    quarter = [*Q[:3], -40.0, *Q[4:7], -30.0, *Q[8:]]
    assert "warning: the principal point" in succeed(*depth, of_q(tmp_path / "q.yml", quarter), *pair)
    assert "warning" not in succeed(*depth, of_q(tmp_path / "q.yml", Q), *pair)
    corner = [FOCAL, 0.0, 40.0, 0.0, FOCAL, 30.0, 0.0, 0.0, 1.0]
    yml = calibration(tmp_path / "c.yml", M1=(corner, 3), M2=(corner, 3))
    assert "warning: the principal point of the right camera" in succeed(*depth, yml, *pair[:-1])
    out = succeed("rectify", "--calibration", yml, *pair[:-1], "--out", tmp_path / "r", "--set", "rows_above=120")
    assert "warning: the principal point of the left camera" in out


@pytest.mark.parametrize("width, height", [("wide", HEIGHT), (0, HEIGHT), (WIDTH, -1), (WIDTH, 1.5)])
def test_sizes_that_are_none(tmp_path, depth, width, height):
    yml = with_size(calibration(tmp_path / "c.yml"), width, height)
    fail(tmp_path, *depth, yml, *plane(tmp_path), says=["c.yml: its image_", "not a number of pixels"])


def test_a_size_of_one_side(tmp_path, depth):
    yml = calibration(tmp_path / "c.yml")
    yml.write_text(yml.read_text() + f"image_width: {WIDTH}\n")
    fail(tmp_path, *depth, yml, *plane(tmp_path), says=["c.yml: it has one of image_width and image_height"])


def test_lens_models_of_others(tmp_path, depth):
    pair = plane(tmp_path)
    yml = with_size(calibration(tmp_path / "c.yml"), more="distortion_model: scaramuzza\n")
    fail(tmp_path, *depth, yml, *pair, says=["c.yml", "distortion_model is scaramuzza"])
    yml = with_size(calibration(tmp_path / "c.yml"), more="distortion_model: equidistant\n")
    fail(tmp_path, *depth, yml, *pair, says=["c.yml", "D1 has 5 coefficients", "fisheye"])
    yml = with_size(calibration(tmp_path / "c.yml"), more="distortion_model: plumb_bob\n")
    fail(tmp_path, *depth, yml, *pair, "--fisheye", says=["--fisheye", "c.yml", "another model"])
    succeed(*depth, yml, *pair)


def camera_info(path, left, turn=0.0, model="plumb_bob", baseline=BASELINE):
    """As ROS writes it."""
    c, s = math.cos(turn), math.sin(turn)
    camera = [FOCAL, 0.0, WIDTH / 2, 0.0, FOCAL, HEIGHT / 2, 0.0, 0.0, 1.0]
    tx = 0.0 if left else -FOCAL * baseline
    matrices = {
        "camera_matrix": (camera, 3),
        "distortion_coefficients": ([0.0] * (5 if model == "plumb_bob" else 4), 5 if model == "plumb_bob" else 4),
        "rectification_matrix": (
            [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0] if left else [c, s, 0, -s, c, 0, 0, 0, 1],
            3,
        ),
        "projection_matrix": ([*camera[:3], tx, *camera[3:6], 0.0, *camera[6:], 0.0], 4),
    }
    text = f"image_width: {WIDTH}\nimage_height: {HEIGHT}\ncamera_name: stereo\ndistortion_model: {model}\n"
    for name, (values, columns) in matrices.items():
        text += f"{name}:\n  rows: {len(values) // columns}\n  cols: {columns}\n  data: {values}\n"
    path.write_text(text)
    return path


def test_camera_info_of_ros(tmp_path, depth):
    """Turned cameras, with their own matrices and without."""
    turn, exact = 0.1, ["--set", "window_px=15", "--set", "subpixel=true"]
    left, right = camera_info(tmp_path / "l.yaml", True), camera_info(tmp_path / "r.yaml", False, turn)
    pair = plane(tmp_path, turn)
    out = succeed(*depth, left, "--right-calibration", right, *pair, *exact)
    assert "baseline 50 mm" in out and "warning" not in out
    rows = png_pixels(tmp_path / "out" / "depth.png")
    assert all(abs(rows[y][x] - Z_MM) < 0.03 * Z_MM for x in range(60, 110) for y in range(20, HEIGHT - 20))
    succeed("rectify", "--calibration", left, "--right-calibration", right, *pair, "--out", tmp_path / "r")
    out = succeed(*depth, left, "--right-calibration", right, *plane(tmp_path), "--rectified")
    assert "focal length 200 px, baseline 50 mm" in out
    fail(tmp_path, *depth, left, *pair, says=["l.yaml: is of one camera", "--right-calibration"])
    fail(tmp_path, *depth, left, "--extrinsics", right, *pair, says=["l.yaml: is of one camera"])
    fail(tmp_path, *depth, right, "--right-calibration", left, *pair, says=["r.yaml: with", "exchange the files"])
    fail(tmp_path, *depth, left, "--right-calibration", tmp_path / "no.yaml", *pair, says=["no.yaml", "no such file"])
    other = calibration(tmp_path / "c.yml")
    fail(tmp_path, *depth, left, "--right-calibration", other, *pair, says=["c.yml: is no camera_info of ROS"])
    half = camera_info(tmp_path / "l.yaml", True)
    half.write_text(half.read_text().replace(f"image_width: {WIDTH}", "image_width: 320"))
    fail(tmp_path, *depth, half, "--right-calibration", right, *pair, says=["images of 320x120 and 160x120"])


KALIBR = f"""cam0:
  camera_model: pinhole
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  distortion_model: MODEL
  intrinsics: [{FOCAL}, {FOCAL}, {WIDTH / 2}, {HEIGHT / 2}]
  resolution: [{WIDTH}, {HEIGHT}]
cam1:
  T_cn_cnm1:
  - [1.0, 0.0, 0.0, {-BASELINE}]
  - [0.0, 1.0, 0.0, 0.0]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
  camera_model: pinhole
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
  distortion_model: MODEL
  intrinsics: [{FOCAL}, {FOCAL}, {WIDTH / 2}, {HEIGHT / 2}]
  resolution: [{WIDTH}, {HEIGHT}]
"""


def seen_by_fisheye(tmp_path):
    """The plane through lenses whose pixels stand as far from the middle as the angle of their ray is large."""
    value = ground()

    def camera(shift):
        def pixel(x, y):
            dx, dy = x - WIDTH / 2, y - HEIGHT / 2
            angle = math.hypot(dx, dy) / FOCAL
            longer = math.tan(angle) / angle if angle > 0 else 1.0
            return value(longer * dx + WIDTH / 2 + shift, longer * dy + HEIGHT / 2)

        return pixel

    size = {"width": WIDTH, "height": HEIGHT}
    left = gray_image(tmp_path / "fl.pgm", camera(0), **size)
    return ["--left", left, "--right", gray_image(tmp_path / "fr.pgm", camera(SHIFT), **size)]


def test_chains_of_kalibr_and_fisheye_lenses(tmp_path, depth):
    chain, exact = tmp_path / "camchain.yaml", ["--set", "window_px=15", "--set", "subpixel=true"]
    chain.write_text(KALIBR.replace("MODEL", "radtan"))
    assert "baseline 50 mm" in succeed(*depth, chain, *plane(tmp_path))
    chain.write_text(KALIBR.replace("MODEL", "equidistant"))
    four = calibration(tmp_path / "four.yml", D1=([0.0] * 4, 4), D2=([0.0] * 4, 4))
    pair = seen_by_fisheye(tmp_path)
    for given in ([chain], [four, "--fisheye"], [with_size(four, more="distortion_model: fisheye\n")]):
        out = succeed(*depth, *given, *pair, *exact)
        assert "baseline 50 mm" in out and "warning" not in out
        rows = png_pixels(tmp_path / "out" / "depth.png")
        assert all(abs(rows[y][x] - Z_MM) < 0.03 * Z_MM for x in range(60, 140) for y in range(20, HEIGHT - 20))
    assert "needs" in succeed("rectify", "--calibration", chain, *pair, "--out", tmp_path / "r")
    chain.write_text(KALIBR.replace("MODEL", "fov"))
    fail(tmp_path, *depth, chain, *pair, says=["camchain.yaml: of cam0", "distortion_model is fov"])
    chain.write_text(KALIBR.replace("MODEL", "radtan").replace(f"{-BASELINE}]", f"{BASELINE}]"))
    fail(tmp_path, *depth, chain, *pair, says=["exchange --left and --right"])


def test_stereo_parameters_of_matlab(tmp_path, depth):
    """Millimetres, matrices for row vectors, and a first pixel of 1."""
    camera = {
        "ImageSize": [HEIGHT, WIDTH],
        "IntrinsicMatrix": [[FOCAL, 0, 0], [0, FOCAL, 0], [WIDTH / 2 + 1, HEIGHT / 2 + 1, 1]],
        "RadialDistortion": [0, 0],
        "TangentialDistortion": [0, 0],
    }
    parameters = {
        "CameraParameters1": camera,
        "CameraParameters2": camera,
        "RotationOfCamera2": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        "TranslationOfCamera2": [-1000 * BASELINE, 0, 0],
        "WorldUnits": "millimeters",
    }
    path, pair = tmp_path / "stereoParams.json", plane(tmp_path)
    path.write_text(json.dumps(parameters))
    assert "baseline 50 mm" in succeed(*depth, path, *pair, "--rectified")
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == Z_MM
    x, _, z, *_ = ply_points(tmp_path / "out" / "cloud.ply")[1000]
    column = x * FOCAL / z + WIDTH / 2
    assert column == pytest.approx(round(column), abs=1e-3), "the principal point counts from 0 here"
    assert "baseline 50 mm" in succeed(*depth, path, *pair)
    path.write_text(json.dumps({**parameters, "WorldUnits": "squares"}))
    fail(tmp_path, *depth, path, *pair, says=["WorldUnits, squares", "--unit-mm"])
    assert "baseline 1250 mm" in succeed(*depth, path, *pair, "--unit-mm", 25)
    assert "needs" in succeed("rectify", "--calibration", path, *pair, "--out", tmp_path / "r"), "which has no lengths"


def test_units_that_cannot_be(tmp_path, depth):
    """T in millimetres with the unit of metres, and the other way round."""
    pair = [*plane(tmp_path), "--rectified"]
    millimetres = calibration(tmp_path / "c.yml", baseline=1000 * BASELINE)
    out = succeed(*depth, millimetres, *pair)
    assert "warning: a baseline of 50000 mm: is T in millimetres? Then give --unit-mm 1\n" in out
    assert "depth of 0 of" in out
    assert "warning" not in succeed(*depth, millimetres, *pair, "--unit-mm", 1)
    metres = calibration(tmp_path / "c.yml")
    assert "is T in metres? Then give --unit-mm 1000" in succeed(*depth, metres, *pair, "--unit-mm", 1)
    far = calibration(tmp_path / "f.yml", baseline=4.0)
    assert "points are farther than 65535 mm" in succeed(*depth, far, *pair)
