# SPDX-License-Identifier: Apache-2.0
"""The command depth with the matrix Q of OpenCV's stereoRectify."""

import math

import pytest

from plane_scene import BASELINE, FOCAL, SHIFT, Q, calibration, of_q, plane, ply_points, png_pixels
from stereo_hls_program import fail, succeed


def test_q_comes_before_the_cameras(tmp_path, depth):
    q = [1.0, 0.0, 0.0, -80.0, 0.0, 1.0, 0.0, -60.0, 0.0, 0.0, 0.0, 2 * FOCAL, 0.0, 0.0, 1 / BASELINE, 0.0]
    succeed(*depth, calibration(tmp_path / "c.yml", Q=(q, 4)), *plane(tmp_path), "--rectified")
    assert png_pixels(tmp_path / "out" / "depth.png")[60][80] == round(2000 * FOCAL * BASELINE / SHIFT)


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
