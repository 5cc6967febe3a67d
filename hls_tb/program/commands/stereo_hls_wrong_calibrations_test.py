# SPDX-License-Identifier: Apache-2.0
"""Calibrations that the command depth refuses."""

import math
import re

import pytest

from plane_scene import BASELINE, FOCAL, HEIGHT, WIDTH, calibration, plane
from stereo_hls_program import fail

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


@pytest.mark.parametrize("ending", [".yml", ".json", ".xml"])
@pytest.mark.parametrize("command", [["depth", "--config", "study"], ["rectify"]])
def test_keys_that_appear_twice(tmp_path, ending, command):
    """The first one would count, and nobody knows which one is meant."""
    images = plane(tmp_path)
    text = calibration(tmp_path / "c.yml").read_text()
    matrices = re.findall(r"(\w+): !!opencv-matrix\n   rows: (\d)\n   cols: (\d)\n   dt: d\n   data: (.*)\n", text)
    matrices.append(matrices[-1])
    if ending == ".yml":
        text += text[text.index("T: ") :]
    elif ending == ".json":
        form = '"%s": {"type_id": "opencv-matrix", "rows": %s, "cols": %s, "dt": "d", "data": %s}'
        text = "{" + ",\n".join(form % one for one in matrices) + "}"
    else:
        form = '<%s type_id="opencv-matrix"><rows>%s</rows><cols>%s</cols><dt>d</dt><data>%s</data></%s>'
        numbers = [(*one[:3], one[3].strip("[] ").replace(",", " "), one[0]) for one in matrices]
        text = (
            '<?xml version="1.0"?>\n<opencv_storage>\n'
            + "\n".join(form % one for one in numbers)
            + "\n</opencv_storage>\n"
        )
    file = tmp_path / f"twice{ending}"
    file.write_text(text)
    fail(tmp_path, *command, "--calibration", file, *images, "--out", "out", says=["T appears twice"])
