# SPDX-License-Identifier: Apache-2.0
"""A plane before two cameras, its calibration, and readers of what depth makes of it."""

import math
import random
import struct
import zlib
from functools import cache

from stereo_hls_program import gray_image, png_depth, png_size

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


@cache
def plane_pixels(turn):
    """What both cameras see of a plane that faces them: rows of left and right."""
    value, c, s = ground(), math.cos(turn), math.sin(turn)

    def right(x, y):  # the camera turned by `turn` sees at x, y what the straight one sees at the place turned back
        dx, dy = x - WIDTH / 2, y - HEIGHT / 2
        return value(c * dx + s * dy + WIDTH / 2 + SHIFT, -s * dx + c * dy + HEIGHT / 2)

    return [[bytes(see(x, y) for x in range(WIDTH)) for y in range(HEIGHT)] for see in (value, right)]


def plane(tmp_path, turn=0.0):
    """A plane that faces both cameras."""
    words = []
    for name, rows in zip(("left", "right"), plane_pixels(turn)):
        path = gray_image(tmp_path / f"{name}.pgm", lambda x, y, rows=rows: rows[y][x], WIDTH, HEIGHT)
        words += [f"--{name}", path]
    return words


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


Q = [1.0, 0.0, 0.0, -80.0, 0.0, 1.0, 0.0, -60.0, 0.0, 0.0, 0.0, FOCAL, 0.0, 0.0, 1 / BASELINE, 0.0]
NOTHING = dict.fromkeys(("M1", "D1", "M2", "D2", "R", "T"))


def of_q(path, q, **others):
    return calibration(path, Q=(q, 4), **{**NOTHING, **others})


def with_size(path, width=WIDTH, height=HEIGHT, more=""):
    path.write_text(path.read_text() + f"image_width: {width}\nimage_height: {height}\n{more}")
    return path
