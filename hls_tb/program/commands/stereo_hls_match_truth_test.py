# SPDX-License-Identifier: Apache-2.0
"""The command match beside a true map."""

import random
import struct

import pytest

from stereo_hls_program import (
    DISPARITIES,
    HEIGHT,
    WIDTH,
    changed,
    fail,
    gray_as_colour,
    gray_image,
    match_facts,
    succeed,
    write_image,
)


def test_match_counts_bad_pixels(tmp_path, match):
    """A pair shifted by 3 has disparity 3 everywhere but where the shift leaves the image."""
    ground = [[random.Random(x * 100 + y).randrange(256) for x in range(WIDTH + 3)] for y in range(HEIGHT)]
    match = changed(match, "--left", gray_image(tmp_path / "l.pgm", lambda x, y: ground[y][x]))
    match = changed(match, "--right", gray_image(tmp_path / "r.pgm", lambda x, y: ground[y][x + 3]))
    # Row 2: off by one, which is allowed; row 3: off by two; row 4: off, but not visible.
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 3 + {2: 1, 3: 2, 4: 2}.get(y, 0))
    visible = gray_image(tmp_path / "v.pgm", lambda x, y: 0 if y == 4 else 255)
    out = succeed(*match, "--truth", truth, "--visible", visible)
    columns = WIDTH - DISPARITIES
    assert f"bad pixels (> 1 px): {columns} of {columns * (HEIGHT - 1)} visible ones (9.09 %)" in out
    assert match_facts(tmp_path)["truth"] == {
        "disparity": str(truth),
        "scale": 1,
        "visible": str(visible),
        "tolerance_px": 1,
        "compared_px": columns * (HEIGHT - 1),
        "bad_px": columns,
        "invalid_px": 0,
    }


@pytest.mark.parametrize("kind", ["scaled", "colour", "pfm"])
def test_truth_needs_no_visible_pixels(tmp_path, match, kind):
    """As for evaluate: any kind of file, and what is not known does not count."""
    ground = [[random.Random(x * 100 + y).randrange(256) for x in range(WIDTH + 3)] for y in range(HEIGHT)]
    match = changed(match, "--left", gray_image(tmp_path / "l.pgm", lambda x, y: ground[y][x]))
    match = changed(match, "--right", gray_image(tmp_path / "r.pgm", lambda x, y: ground[y][x + 3]))
    value = lambda x, y: 0 if y == 4 else 5 if y == 3 else 3  # noqa: E731, 0: unknown
    truth = tmp_path / f"truth.{kind}"
    if kind == "scaled":
        gray_image(truth, lambda x, y: 16 * value(x, y))
    elif kind == "colour":
        gray_as_colour(truth, lambda x, y: 16 * value(x, y))
    else:
        rows = [struct.pack(f"<{WIDTH}f", *(value(x, y) or float("inf") for x in range(WIDTH))) for y in range(HEIGHT)]
        truth.write_bytes(f"Pf\n{WIDTH} {HEIGHT}\n-1\n".encode() + b"".join(reversed(rows)))
    scale = [] if kind == "pfm" else ["--truth-scale", 16]
    out = succeed(*match, "--truth", truth, *scale)
    columns = WIDTH - DISPARITIES
    assert f"{columns} of {columns * (HEIGHT - 1)} with a true disparity (9.09 %)" in out
    facts = match_facts(tmp_path)["truth"]
    assert facts["visible"] is None and facts["scale"] == (1 if kind == "pfm" else 16)
    assert (facts["compared_px"], facts["bad_px"]) == (columns * (HEIGHT - 1), columns)


def test_truth_of_a_wrong_scale_is_remarked(tmp_path, match):
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 40)
    assert "searches disparities of 0 ... 7 px, but 100 %" in succeed(*match, "--truth", truth)
    assert "lies outside" not in succeed(*match, "--truth", truth, "--truth-scale", 10)


def test_match_on_the_generated_scene_is_mostly_right(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    for option, name in (("--left", "left.png"), ("--right", "right.png")):
        match = changed(match, option, tmp_path / "s" / name)
    succeed(
        *match, "--truth", tmp_path / "s" / "disparity_right.png", "--visible", tmp_path / "s" / "visible_right.png"
    )
    truth = match_facts(tmp_path)["truth"]
    assert 0 < truth["compared_px"] <= (WIDTH - DISPARITIES) * HEIGHT and truth["bad_px"] < 0.1 * truth["compared_px"]


def test_truth_that_does_not_fit(tmp_path, match):
    image = write_image(tmp_path / "t.pgm")
    other = write_image(tmp_path / "other.pgm", WIDTH - 1, HEIGHT)
    fail(tmp_path, *match, "--truth", other, says=["--truth", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth-scale", 2, says=["--truth"])
    fail(tmp_path, *match, "--truth", image, "--truth-scale", 0, says=["--truth-scale"])
    fail(tmp_path, *match, "--visible", image, says=["--truth"])
    fail(tmp_path, *match, "--truth", other, "--visible", image, says=["--truth", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", image, "--visible", other, says=["--visible", other, "31x12", "32x12"])
    fail(tmp_path, *match, "--truth", tmp_path / "no.png", "--visible", image, says=["no.png", "no such file"])
