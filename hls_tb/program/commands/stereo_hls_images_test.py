# SPDX-License-Identifier: Apache-2.0
"""Images that the commands read: sizes, kinds, damage."""

import random
from pathlib import Path

import pytest

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, changed, fail, png, png_size, succeed, write_image


def test_match_fast_takes_any_size_and_says_so(tmp_path, match):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    assert "50x20, not the 32x12 of tiny" in succeed(*match)
    assert png_size(tmp_path / "out" / "disparity.png") == (50 - DISPARITIES, 20)


@pytest.mark.parametrize("fit, verb", [("crop", "cropped"), ("resize", "resized")])
def test_match_fits_images_and_says_so(tmp_path, match, fit, verb):
    for option, name in (("--left", "big_l.pgm"), ("--right", "big_r.pgm")):
        match = changed(match, option, write_image(tmp_path / name, 50, 20))
    out = succeed(*match, "--engine", "clocked", "--fit", fit)
    assert f"images {verb} from 50x20 to" in out
    assert png_size(tmp_path / "out" / "disparity.png") == (WIDTH - DISPARITIES, HEIGHT)
    fail(tmp_path, *match, "--engine", "clocked", says=["50x20", "32x12", "--fit crop"])


def test_colour_is_converted_and_said(tmp_path, match):
    color = write_image(tmp_path / "color.ppm", channels=3)
    assert f"{color}: colour image converted to grey" in succeed(*changed(match, "--left", color))


@pytest.mark.parametrize("channels, is_said", [(1, False), (2, True), (3, False), (4, True)])
def test_transparency_is_left_out_and_said(tmp_path, match, channels, is_said):
    """Of grey images too, whose second channel the reader drops."""
    values = random.Random(channels).randbytes(WIDTH * HEIGHT * channels)
    path = png(tmp_path / "t.png", channels, values)
    said = succeed(*changed(match, "--left", path))
    assert (f"{path}: its transparency is left out\n" in said) == is_said
    if channels == 2:
        succeed(*changed(changed(match, "--left", png(tmp_path / "g.png", 1, values[::2])), "--out", tmp_path / "grey"))
        assert (tmp_path / "out" / "disparity.png").read_bytes() == (tmp_path / "grey" / "disparity.png").read_bytes()


def test_missing_and_unreadable_files(tmp_path, match):
    fail(tmp_path, *changed(match, "--left", tmp_path / "none.png"), says=[tmp_path / "none.png", "no such file"])
    text = tmp_path / "text.png"
    text.write_text("not an image")
    fail(tmp_path, *changed(match, "--right", text), says=[text, "not an image"])
    fail(tmp_path, *changed(match, "--right", tmp_path), says=[tmp_path, "is a folder"])


def test_damaged_png(tmp_path, match):
    succeed("scene", "--out", tmp_path / "s", "--seed", 1, "--config", "tiny")
    damaged = tmp_path / "damaged.png"
    damaged.write_bytes((tmp_path / "s" / "left.png").read_bytes()[:120])
    fail(tmp_path, *changed(match, "--left", damaged), says=[damaged, "not an image"])


def test_sizes_that_differ(tmp_path, match):
    other = write_image(tmp_path / "other.pgm", WIDTH, HEIGHT + 1)
    fail(tmp_path, *changed(match, "--right", other), says=["differ in size", other, "32x13", "32x12"])


def test_sixteen_bit_images(tmp_path, match):
    deep = write_image(tmp_path / "deep.pgm", maximum=65535)
    fail(tmp_path, *changed(match, "--left", deep), says=[deep, "16 bits", "8-bit"])
    pam = tmp_path / "two_channels.pam"
    pam.write_bytes(b"P7\nWIDTH 2\nHEIGHT 1\nDEPTH 2\nMAXVAL 255\nTUPLTYPE GRAYSCALE_ALPHA\nENDHDR\n\1\2\3\4")
    fail(tmp_path, *changed(match, "--left", pam), says=[pam, "2 channels", "grey"])


def test_width_not_above_the_disparity_range(tmp_path, match):
    for option, name in (("--left", "l8.pgm"), ("--right", "r8.pgm")):
        match = changed(match, option, write_image(tmp_path / name, DISPARITIES, HEIGHT))
    fail(tmp_path, *match, says=["--config tiny: the images are 8x12", "wider than the disparity range 8"])


JPEG = Path(__file__).parents[2] / "fuzz" / "corpus" / "image" / "gray.jpg"


@pytest.mark.parametrize("command", ["match", "evaluate", "depth", "rectify", "video"])
def test_a_jpeg_that_is_broken_off(tmp_path, command):
    """OpenCV reads it, and grey stands for what is missing."""
    whole, cut = tmp_path / "a" / "0.jpg", tmp_path / "b" / "0.jpg"
    for path, count in ((whole, None), (cut, -40)):
        path.parent.mkdir()
        path.write_bytes(JPEG.read_bytes()[:count])
    (tmp_path / "c.yml").write_text(
        "%YAML:1.0\n---\n"
        + "".join(
            f"{name}: !!opencv-matrix\n   rows: {len(data) // columns}\n   cols: {columns}\n   dt: d\n   data: {data}\n"
            for name, data, columns in (
                *((name, [50.0, 0.0, 18.0, 0.0, 50.0, 6.0, 0.0, 0.0, 1.0], 3) for name in ("M1", "M2")),
                ("R", [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], 3),
                ("T", [-0.1, 0.0, 0.0], 1),
            )
        )
    )
    more = {
        "match": ["--config", "tiny", "--out", tmp_path / "out"],
        "evaluate": ["--config", "tiny", "--truth-left", whole],
        "depth": ["--config", "tiny", "--calibration", tmp_path / "c.yml", "--out", tmp_path / "out"],
        "rectify": ["--calibration", tmp_path / "c.yml", "--out", tmp_path / "out"],
        "video": ["--config", "tiny", "--out", tmp_path / "out"],
    }[command]
    of = (lambda path: path.parent) if command == "video" else lambda path: path
    succeed(command, "--left", of(whole), "--right", of(whole), *more)
    for left, right in ((whole, cut), (cut, whole)):
        says = ["0.jpg: is truncated or damaged", "Premature end of JPEG file"]
        fail(tmp_path, command, "--left", of(left), "--right", of(right), *more, says=says)


def test_crop_of_images_too_small(tmp_path, match):
    for option, name in (("--left", "ls.pgm"), ("--right", "rs.pgm")):
        match = changed(match, option, write_image(tmp_path / name, WIDTH + 9, HEIGHT - 1))
    fail(tmp_path, *match, "--fit", "crop", says=["--fit crop", "41x11", "32x12"])
