# SPDX-License-Identifier: Apache-2.0
"""The command stereo_hls depth, and what match says of pairs that are not rectified."""

import json
import math
import random
import struct
import zlib

import pytest

from stereo_hls_program import fail, gray_image, png_depth, png_size, succeed, write_image

WIDTH, HEIGHT, SHIFT = 160, 120, 7  # pixels; the whole pair is a plane
FOCAL, BASELINE = 200.0, 0.05  # pixels, metres
Z_MM = round(1000 * FOCAL * BASELINE / SHIFT)


def matrix(name, values, columns):
    rows = len(values) // columns
    data = ", ".join(map(repr, values))
    return f"{name}: !!opencv-matrix\n   rows: {rows}\n   cols: {columns}\n   dt: d\n   data: [ {data} ]\n"


def calibration(path, baseline=BASELINE, focal=FOCAL, turn=0.0, **others):
    """As OpenCV's stereo_calib writes it; the right camera is turned by `turn` radians about its axis."""
    camera = [focal, 0.0, WIDTH / 2, 0.0, focal, HEIGHT / 2, 0.0, 0.0, 1.0]
    c, s = math.cos(turn), math.sin(turn)
    matrices = {
        "M1": (camera, 3),
        "D1": ([0.0] * 5, 5),
        "M2": (camera, 3),
        "D2": ([0.0] * 5, 5),
        "R": ([c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0], 3),
        "T": ([-baseline * c, -baseline * s, 0.0], 1),
        **others,
    }
    path.write_text("%YAML:1.0\n---\n" + "".join(matrix(name, *value) for name, value in matrices.items() if value))
    return path


def ground(seed=1):
    """Blurred noise that the images are cut from, with room on all sides: value(x, y) at real places."""
    noise = [random.Random(f"{seed} {y}").randbytes(2 * WIDTH) for y in range(2 * HEIGHT)]

    def value(x, y):
        x, y = x / 2 + WIDTH / 2, y / 2 + HEIGHT / 2
        i, j = int(x), int(y)
        u, v = x - i, y - j
        top = (1 - u) * noise[j][i] + u * noise[j][i + 1]
        return round((1 - v) * top + v * ((1 - u) * noise[j + 1][i] + u * noise[j + 1][i + 1]))

    return value


def plane(tmp_path, turn=0.0):
    """A plane that faces both cameras."""
    value, c, s = ground(), math.cos(turn), math.sin(turn)

    def right(x, y):  # the camera turned by `turn` sees at x, y what the straight one sees at the place turned back
        dx, dy = x - WIDTH / 2, y - HEIGHT / 2
        return value(c * dx + s * dy + WIDTH / 2 + SHIFT, -s * dx + c * dy + HEIGHT / 2)

    size = {"width": WIDTH, "height": HEIGHT}
    return [
        "--left",
        gray_image(tmp_path / "left.pgm", value, **size),
        "--right",
        gray_image(tmp_path / "right.pgm", right, **size),
    ]


def png_pixels(path):
    """The rows of a grey PNG file of 8 or 16 bits."""
    data, position, packed = path.read_bytes(), 8, b""
    while position < len(data):
        (length,), kind = struct.unpack(">I", data[position : position + 4]), data[position + 4 : position + 8]
        packed += data[position + 8 : position + 8 + length] if kind == b"IDAT" else b""
        position += 12 + length
    (width, height), step = png_size(path), png_depth(path) // 8
    raw, stride, last, rows = zlib.decompress(packed), 1 + width * step, bytes(width * step), []
    for y in range(height):
        line = bytearray(raw[y * stride + 1 : (y + 1) * stride])
        for i in range(len(line)):
            a, b, c = (line[i - step] if i >= step else 0), last[i], (last[i - step] if i >= step else 0)
            nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            line[i] = (line[i] + (0, a, b, (a + b) // 2, nearest)[raw[y * stride]]) & 255
        rows.append([int.from_bytes(line[x : x + step], "big") for x in range(0, len(line), step)])
        last = bytes(line)
    return rows


def ply_points(path):
    header, body = path.read_bytes().split(b"end_header\n", 1)
    count = int(header.split(b"element vertex ")[1].split()[0])
    assert b"format binary_little_endian 1.0" in header and len(body) == 15 * count
    return list(struct.iter_unpack("<fffBBB", body))


@pytest.fixture
def depth(tmp_path):
    return ["depth", "--config", "study", "--out", tmp_path / "out", "--calibration"]


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


def test_q_comes_before_the_cameras(tmp_path, depth):
    q = [1.0, 0.0, 0.0, -80.0, 0.0, 1.0, 0.0, -60.0, 0.0, 0.0, 0.0, 2 * FOCAL, 0.0, 0.0, 1 / BASELINE, 0.0]
    succeed(*depth, calibration(tmp_path / "c.yml", Q=(q, 4)), *plane(tmp_path), "--rectified")
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == round(2000 * FOCAL * BASELINE / SHIFT)


Q = [1.0, 0.0, 0.0, -80.0, 0.0, 1.0, 0.0, -60.0, 0.0, 0.0, 0.0, FOCAL, 0.0, 0.0, 1 / BASELINE, 0.0]
NOTHING = dict.fromkeys(("M1", "D1", "M2", "D2", "R", "T"))


def of_q(path, q, **others):
    return calibration(path, Q=(q, 4), **{**NOTHING, **others})


def cloud(tmp_path, depth, *words):
    succeed(*depth, *words)
    return ply_points(tmp_path / "out" / "cloud.ply")


def test_the_scale_and_sign_of_q_say_nothing(tmp_path, depth):
    pair = [*plane(tmp_path), "--rectified"]
    points = cloud(tmp_path, depth, of_q(tmp_path / "q.yml", Q), *pair)
    assert len(points) > 10000
    for scale in (10, 0.1, -1, -0.001):
        again = cloud(tmp_path, depth, of_q(tmp_path / "s.yml", [scale * value for value in Q]), *pair)
        assert len(again) == len(points)
        for there, wanted in zip(again, points):
            assert there[3:] == wanted[3:] and there[:3] == pytest.approx(wanted[:3], rel=1e-5, abs=1e-6)


def test_the_axes_of_q_are_those_of_the_cloud(tmp_path, depth):
    """y up and z backward, as the sample stereo_match.py of OpenCV has it."""
    pair = [*plane(tmp_path), "--rectified"]
    points = cloud(tmp_path, depth, of_q(tmp_path / "q.yml", Q), *pair)
    image = (tmp_path / "out" / "depth.png").read_bytes()
    other = [value * (-1 if 4 <= place < 12 else 1) for place, value in enumerate(Q)]
    for there, (x, y, z, *color) in zip(cloud(tmp_path, depth, of_q(tmp_path / "o.yml", other), *pair), points):
        assert there == pytest.approx((x, -y, -z, *color), rel=1e-6, abs=1e-6)
    assert (tmp_path / "out" / "depth.png").read_bytes() == image, "depth has no sign"
    assert b"axes are those of the calibration's Q" in (tmp_path / "out" / "cloud.ply").read_bytes()[:200]


@pytest.mark.parametrize(
    "q, says",
    [
        ([Q[4 * (i % 4) + i // 4] for i in range(16)], ["Q is not that of a rectified pair", "is it transposed?"]),
        ([*Q[:11], 0.0, *Q[12:]], ["Q lacks the focal length"]),
        ([*Q[:14], 0.0, 1.0], ["Q lacks the focal length"]),
        ([*Q[:14], -Q[14], 0.0], ["exchange --left and --right"]),
        ([*Q[:11], math.nan, *Q[12:]], ["q.yml"]),
    ],
)
def test_damaged_q(tmp_path, depth, q, says):
    fail(tmp_path, *depth, of_q(tmp_path / "q.yml", q), *plane(tmp_path), "--rectified", says=says)


def test_cameras_one_above_the_other_beside_q(tmp_path, depth):
    p1 = [FOCAL, 0.0, 80.0, 0.0, 0.0, FOCAL, 60.0, 0.0, 0.0, 0.0, 1.0, 0.0]
    above = [*p1[:7], -FOCAL * BASELINE, *p1[8:]]
    yml = of_q(tmp_path / "q.yml", Q, P1=(p1, 4), P2=(above, 4))
    fail(tmp_path, *depth, yml, *plane(tmp_path), "--rectified", says=["P1 and P2", "one above the other"])


def with_size(path, width=WIDTH, height=HEIGHT, more=""):
    path.write_text(path.read_text() + f"image_width: {width}\nimage_height: {height}\n{more}")
    return path


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


IDENTITY = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
CAMERA_TURNED = [FOCAL, 0.0, 0.0, 0.0, FOCAL, 0.0, WIDTH / 2, HEIGHT / 2, 1.0]
CAMERA_SKEWED = [FOCAL, 0.5, WIDTH / 2, 0.0, FOCAL, HEIGHT / 2, 0.0, 0.0, 1.0]
OTHER_Q = [
    1.0,
    0.0,
    0.0,
    -WIDTH / 2,
    0.0,
    1.0,
    0.0,
    -HEIGHT / 2,
    0.0,
    0.0,
    0.0,
    FOCAL,
    0.0,
    0.0,
    1 / (2 * BASELINE),
    0.0,
]
P_LEFT = [FOCAL, 0.0, WIDTH / 2, 0.0, 0.0, FOCAL, HEIGHT / 2, 0.0, 0.0, 0.0, 1.0, 0.0]
P_RIGHT = [FOCAL, 0.0, WIDTH / 2, -2 * FOCAL * BASELINE, *P_LEFT[4:]]


def turned(degrees):
    """About the upright axis."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c]


@pytest.mark.parametrize(
    "changes, options, says",
    [
        ({"R": None}, [], ["lacks R", "--extrinsics"]),
        ({"M1": None, "T": None}, [], ["lacks M1, T"]),
        ({"M1": None, "T": None}, ["--rectified"], ["neither Q"]),
        ({"M1": (IDENTITY[:6], 3)}, [], ["matrix M1 is 2x3", "3x3"]),
        ({"M1": (IDENTITY[:4] + [math.nan] + IDENTITY[5:], 3)}, [], ["c.yml"]),
        ({"M2": ([200.0, 0.0, 900.0, 0.0, 200.0, 60.0, 0.0, 0.0, 1.0], 3)}, [], ["M2", "160x120"]),
        ({"M1": ([0.0] * 9, 3)}, [], ["M1", "160x120"]),
        *(
            ({name: ([0.0] * count, columns)}, way, [f"matrix {name} is", f"{count}", "4, 5, 8, 12 or 14 coefficients"])
            for name, way, columns in (("D1", [], 1), ("D2", ["--rectified"], 0))
            for count in (1, 2, 3, 6, 7, 9, 10, 11, 13, 15)
            for columns in (columns or count,)
        ),
        ({"M1": (CAMERA_TURNED, 3)}, ["--rectified"], ["M1 is not a camera matrix", "row 3, column 1 must be 0"]),
        ({"M1": (CAMERA_SKEWED, 3)}, [], ["M1 is not a camera matrix", "row 1, column 2 must be 0"]),
        (
            {"T": ([-0.01, -0.1, 0.0], 1)},
            ["--rectified"],
            ["T puts the right camera at 0.01, 0.1, 0", "above the other"],
        ),
        ({"R": (turned(17), 3)}, ["--rectified"], ["R turns the right camera by 17 degrees"]),
        ({"R": ([2.0, *IDENTITY[1:]], 3)}, ["--rectified"], ["R is not a rotation"]),
        ({"R": ([2.0, *IDENTITY[1:]], 3)}, [], ["R is not a rotation"]),
        ({"T": ([0.0, -0.05, 0.0], 1)}, [], ["one above the other"]),
        ({"T": ([0.05, 0.0, 0.0], 1)}, [], ["exchange --left and --right"]),
        ({"T": ([0.0, 0.0, 0.0], 1)}, [], ["--calibration"]),
        ({"T": ([0.05, 0.0, 0.0], 1)}, ["--rectified"], ["exchange --left and --right"]),
        ({"T": ([-0.01, 0.0, -0.1], 1)}, [], ["one behind the other"]),
        ({"R": (turned(70), 3)}, [], ["R turns the right camera by 70 degrees"]),
        ({"R": (turned(180), 3)}, [], ["R turns the right camera by 180 degrees"]),
        ({"Q": (OTHER_Q, 4)}, ["--rectified"], ["Q has a baseline of 0.1 but its T is 0.05 long"]),
        (
            {"P1": (P_LEFT, 4), "P2": (P_RIGHT, 4)},
            ["--rectified"],
            ["P2 has a baseline of 0.1 but its T is 0.05 long"],
        ),
        ({}, ["--unit-mm", "0"], ["--unit-mm"]),
        ({}, ["--unit-mm", "nan"], ["--unit-mm", "not a number above 0"]),
        ({}, ["--unit-mm", "inf"], ["--unit-mm", "not a number above 0"]),
        ({}, ["--set", "window=3"], ["--set window=3"]),
        ({}, ["--set", "disparities=200"], ["--config study", "200"]),
        ({}, ["--config", "nope"], ["nope"]),
        ({}, ["--extrinsics", "nowhere.yml"], ["nowhere.yml", "no such file"]),
    ],
)
def test_wrong_calibrations(tmp_path, depth, changes, options, says):
    if "--config" in options:
        depth = [word for word in depth if word not in ("--config", "study")]
    fail(tmp_path, *depth, calibration(tmp_path / "c.yml", **changes), *plane(tmp_path), *options, says=says)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"hello",
        b"%YAML:1.0\n---\n- 1\n- 2\n",
        b"\0\1\2\3" * 100,
        b"%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1., 2. ]\n",
        b'<?xml version="1.0"?>\n<opencv_storage><M1',
        b'{"M1": [',
    ],
)
def test_hostile_calibrations(tmp_path, depth, content):
    (tmp_path / "h.yml").write_bytes(content)
    fail(tmp_path, *depth, tmp_path / "h.yml", *plane(tmp_path), says=["h.yml", "not a calibration"])


@pytest.mark.parametrize("rows, columns", [(-3, 3), (3, 0), (2000000000, 2000000000), (1000000000, 3)])
def test_the_size_of_a_matrix_is_looked_at_before_there_is_memory_for_it(tmp_path, depth, rows, columns):
    (tmp_path / "h.yml").write_text(
        f"%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: {rows}\n   cols: {columns}\n   dt: d\n   data: [ 1. ]\n"
    )
    fail(
        tmp_path,
        *depth,
        tmp_path / "h.yml",
        *plane(tmp_path),
        says=["h.yml: its matrix M1", f"{rows}x{columns} but must be 3x3"],
    )


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
