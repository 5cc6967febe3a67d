# SPDX-License-Identifier: Apache-2.0
"""Truth that evaluate reads: kinds of files, scales, values for unknown, masks."""

import pytest

from stereo_hls_program import HEIGHT, WIDTH, fail, gray_as_colour, gray_image, write_image
from truth_files import float_tiff, npy, pfm, png16, results


@pytest.mark.parametrize("kind", ["pfm", "pgm", "ppm", "png16", "npy", "tiff"])
def test_every_kind_of_truth_says_the_same(tmp_path, evaluate, kind):
    value = lambda x, y: 0 if (x + y) % 5 == 0 else 2 + (x + 3 * y) % 9 / 4  # noqa: E731, 0: unknown
    truth, found = tmp_path / f"truth.{kind}", pfm(tmp_path / "found.pfm", lambda x, y: 3)
    if kind == "pfm":
        pfm(truth, lambda x, y: value(x, y) or float("inf"))
    elif kind in ("npy", "tiff"):
        {"npy": npy, "tiff": float_tiff}[kind](truth, lambda x, y: value(x, y) or float("nan"))
    elif kind in ("pgm", "ppm"):
        write = {"pgm": gray_image, "ppm": gray_as_colour}[kind]
        write(truth, lambda x, y: round(4 * value(x, y)))
    else:
        truth = png16(tmp_path / "truth.png", lambda x, y: round(256 * value(x, y)))
    scale = ["--truth-scale", 4] if kind in ("pgm", "ppm") else []
    _, [method] = results(
        tmp_path, *evaluate, "--truth-left", truth, *scale, "--disparity", found, "--reference", "left"
    )
    errors = [abs(3 - value(x, y)) for x in range(WIDTH) for y in range(HEIGHT) if value(x, y) != 0]
    mask = method["masks"]["all"]
    assert mask["pixels"] == len(errors) and mask["avg_px"] == pytest.approx(sum(errors) / len(errors), abs=1e-6)


KINDS = {"pfm": pfm, "npy": npy, "tiff": float_tiff, "png": png16, "pgm": gray_image}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("scale", [2, 16, 0.5, 100])
def test_a_given_scale_is_used_whatever_the_file(tmp_path, evaluate, kind, scale):
    """Of the truth and of a result; the JSON has the scale that was used."""
    stored = KINDS[kind](tmp_path / f"s.{kind}", lambda x, y: 40)
    plain = pfm(tmp_path / "p.pfm", lambda x, y: 40 / scale + 0.25)
    words = ["--disparity", stored, "--reference", "left", "--disparity-scale", scale]
    _, [method] = results(tmp_path, *evaluate, "--truth-left", plain, *words)
    assert method["parameters"] == {"scale": scale}
    assert method["masks"]["all"]["avg_px"] == pytest.approx(0.25, abs=1e-4)
    words = ["--truth-scale", scale, "--disparity", plain, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, "--truth-left", stored, *words)
    assert method["parameters"] == {"scale": 1}
    assert method["masks"]["all"]["avg_px"] == pytest.approx(0.25, abs=1e-4)


@pytest.mark.parametrize("kind, scale", [("png", 256), ("pgm", 1), ("pfm", 1), ("npy", 1), ("tiff", 1)])
def test_the_scale_that_was_used_is_recorded(tmp_path, evaluate, kind, scale):
    stored = KINDS[kind](tmp_path / f"s.{kind}", lambda x, y: 5 * scale)
    truth = pfm(tmp_path / "p.pfm", lambda x, y: 5)
    words = ["--truth-left", truth, "--disparity", stored, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, *words)
    assert method["parameters"] == {"scale": scale} and method["masks"]["all"]["avg_px"] == 0


@pytest.mark.parametrize("kind", ["pfm", "npy", "tiff"])
@pytest.mark.parametrize("mark", [float("nan"), float("inf"), float("-inf"), -1, -9999, 1e9])
def test_values_that_stand_for_unknown(tmp_path, evaluate, kind, mark):
    truth = KINDS[kind](tmp_path / f"t.{kind}", lambda x, y: mark if x < 3 else 5)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 5)
    words = ["--truth-left", truth, "--disparity", found, "--reference", "left"]
    said = ["--unknown", mark] if abs(mark) < float("inf") else []
    out, [method] = results(tmp_path, *evaluate, *words, *said)
    assert method["masks"]["all"]["pixels"] == (WIDTH - 3) * HEIGHT and method["masks"]["all"]["avg_px"] == 0
    assert "unknown" not in out
    if mark == 1e9:
        fail(tmp_path, *evaluate, *words, says=["0,", "is not a disparity", "--unknown"])
    elif said:
        out, [method] = results(tmp_path, *evaluate, *words)
        assert method["masks"]["all"]["pixels"] == WIDTH * HEIGHT
        assert (f"{3 * HEIGHT} pixels are -1: are they unknown? Then give --unknown -1" in out) == (mark == -1)
    # A result's, too.
    words = ["--truth-left", found, "--disparity", truth, "--reference", "left"]
    _, [method] = results(tmp_path, *evaluate, *words, *said)
    assert method["masks"]["all"]["density"] == pytest.approx((WIDTH - 3) / WIDTH)


def test_a_mask_says_which_truth_counts(tmp_path, evaluate):
    mask = gray_image(tmp_path / "m.pgm", lambda x, y: 0 if x < 4 else 128 + x)
    truth = gray_image(tmp_path / "t.pgm", lambda x, y: 0 if x % 2 == 0 else 9)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 0 if x % 2 == 0 else 9)
    for side in ("left", "right"):
        words = [f"--truth-{side}", truth, "--disparity", found, "--reference", side]
        _, [method] = results(tmp_path, *evaluate, *words)
        assert method["masks"]["all"]["pixels"] == WIDTH // 2 * HEIGHT, "0: unknown"
        _, [method] = results(tmp_path, *evaluate, *words, f"--visible-{side}", mask)
        assert method["masks"]["all"]["pixels"] == (WIDTH - 4) * HEIGHT, "0 is a disparity, too"
        assert method["masks"]["all"]["avg_px"] == 0
        other = {"left": "right", "right": "left"}[side]
        fail(tmp_path, *evaluate, *words, f"--visible-{other}", mask, says=[f"needs --truth-{other}"])
        wide = write_image(tmp_path / "w.pgm", WIDTH + 1)
        fail(tmp_path, *evaluate, *words, f"--visible-{side}", wide, says=[f"--visible-{side}", "33x12", "32x12"])


def test_truth_that_cannot_fit_is_remarked(tmp_path, evaluate):
    far = pfm(tmp_path / "far.pfm", lambda x, y: 90.5)
    out, [method] = results(tmp_path, *evaluate, "--truth-right", far, "--config", "tiny")
    assert method["remarks"] == [
        "tiny searches disparities of 0 ... 7 px, but 100 % of the ground truth, 90.5 ... 90.5 px, lies outside; "
        "check the scale of the truth"
    ]
    assert method["remarks"][0] in out
    near = pfm(tmp_path / "near.pfm", lambda x, y: 7)
    found = pfm(tmp_path / "found.pfm", lambda x, y: 3)
    words = ["--truth-left", near, "--reference", "left", "--disparity"]
    _, [method] = results(tmp_path, *evaluate, *words, found)
    assert method["remarks"] == [
        f"100 % of the disparities that {found} found are off by more than 1 px; "
        "check that the truth and its scale belong to these images"
    ]
    _, [method] = results(tmp_path, *evaluate, *words, near)
    assert method["remarks"] == []
