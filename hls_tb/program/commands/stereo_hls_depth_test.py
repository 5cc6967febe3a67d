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


def test_lengths_are_in_the_unit_of_the_calibration(tmp_path, depth):
    millimetres = calibration(tmp_path / "c.yml", baseline=1000 * BASELINE)
    succeed(*depth, millimetres, *plane(tmp_path), "--rectified", "--unit-mm", 1)
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == Z_MM
    assert ply_points(tmp_path / "out" / "cloud.ply")[1000][2] == pytest.approx(Z_MM / 1000, rel=1e-3)


def test_q_comes_before_the_cameras(tmp_path, depth):
    q = [1.0, 0.0, 0.0, -80.0, 0.0, 1.0, 0.0, -60.0, 0.0, 0.0, 0.0, 2 * FOCAL, 0.0, 0.0, 1 / BASELINE, 0.0]
    succeed(*depth, calibration(tmp_path / "c.yml", Q=(q, 4)), *plane(tmp_path), "--rectified")
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == round(2000 * FOCAL * BASELINE / SHIFT)


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
    # What is not rectified is said, not hidden.
    assert "warning: the images do not look rectified" in succeed(
        *depth, intrinsics, "--extrinsics", extrinsics, *pair, "--rectified"
    )


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
        ({"D1": ([0.0] * 15, 15)}, [], ["matrix D1 is 1x15", "14"]),
        ({"D1": ([0.0] * 3, 3)}, [], ["cannot be rectified"]),
        ({"R": ([2.0, *IDENTITY[1:]], 3)}, [], ["R is no rotation"]),
        ({"T": ([0.0, -0.05, 0.0], 1)}, [], ["one above the other"]),
        ({"T": ([0.05, 0.0, 0.0], 1)}, [], ["exchange --left and --right"]),
        ({"T": ([0.0, 0.0, 0.0], 1)}, [], ["--calibration"]),
        ({"T": ([0.05, 0.0, 0.0], 1)}, ["--rectified"], ["exchange --left and --right"]),
        ({}, ["--unit-mm", "0"], ["--unit-mm"]),
        ({}, ["--unit-mm", "nan"], ["--unit-mm", "no number above 0"]),
        ({}, ["--unit-mm", "inf"], ["--unit-mm", "no number above 0"]),
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
