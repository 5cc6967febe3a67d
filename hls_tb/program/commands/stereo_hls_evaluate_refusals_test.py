# SPDX-License-Identifier: Apache-2.0
"""Words and files that evaluate refuses."""

import struct

import pytest

from stereo_hls_program import WIDTH, fail, write_image
from truth_files import pfm


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["--config", "tiny"], ["--truth-left"]),
        (["--truth-left", "T"], ["--config", "--opencv"]),
        (["--truth-left", "T", "--config", "nope"], ["nope", "tiny"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "window=3"], ["--set window=3", "known are", "window_px"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "window_px"], ["--set window_px", "NAME=VALUE"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "median=yes"], ["--set median=yes", "false or true"]),
        (["--truth-left", "T", "--config", "tiny", "--set", "disparities=40"], ["--config tiny", "32x12", "40"]),
        (["--truth-left", "T", "--opencv", "bm", "--set", "window_px=3"], ["--set", "--config"]),
        (["--truth-left", "T", "--opencv", "gc"], ["--opencv", "gc"]),
        (["--truth-left", "T", "--opencv", "bm", "--opencv-disparities", "17"], ["17", "multiple of 16"]),
        (["--truth-left", "T", "--opencv", "bm", "--opencv-block", "13"], ["13", "32x12", "5 to 11"]),
        (["--truth-left", "T", "--opencv", "sgbm", "--opencv-block", "4"], ["--opencv-block 4", "odd"]),
        (["--truth-left", "T", "--disparity", "T"], ["--disparity", "--reference"]),
        (["--truth-left", "T", "--disparity", "T", "--reference", "both"], ["--reference", "both"]),
        (["--truth-left", "T", "--truth-scale", "0", "--config", "tiny"], ["--truth-scale"]),
        (["--truth-left", "T", "--truth-scale", "nan", "--config", "tiny"], ["--truth-scale", "not a number above 0"]),
        (["--truth-left", "GREY", "--truth-scale", "1e-300", "--config", "tiny"], ["--truth-left", "so small a scale"]),
        (["--truth-left", "T", "--border", "-1", "--config", "tiny"], ["--border"]),
        *(
            (["--truth-left", "T", option, value, "--config", "tiny"], [option])
            for option in ("--offset", "--gain")
            for value in ("nan", "inf", "-1e300", "1e300")
        ),
        (["--truth-left", "T", "--opencv", "bm", "--surest", "50"], ["--surest", "name one with --config"]),
        (["--truth-left", "no.pfm", "--config", "tiny"], ["no.pfm", "no such file"]),
        (["--truth-left", "WIDE", "--config", "tiny"], ["--truth-left", "33x12", "32x12"]),
        (["--truth-left", "T", "--disparity", "WIDE", "--reference", "left"], ["--disparity", "33x12"]),
        (["--truth-left", "COLOUR", "--config", "tiny"], ["--truth-left", "colour"]),
    ],
)
def test_wrong_usage(tmp_path, evaluate, arguments, says):
    files = {
        "T": pfm(tmp_path / "t.pfm", lambda x, y: 3),
        "WIDE": pfm(tmp_path / "w.pfm", lambda x, y: 3, width=WIDTH + 1),
        "GREY": write_image(tmp_path / "g.pgm"),
        "COLOUR": write_image(tmp_path / "c.ppm", channels=3),
    }
    fail(tmp_path, *evaluate, *[files.get(word, word) for word in arguments], says=says)


@pytest.mark.parametrize(
    "content, says",
    [
        (b"", "truncated"),
        (b"Pf\n32 12\n-1\n", "0 bytes of pixels"),
        (b"Pf\n60000 60000\n-1\nxxxx", "14400000000"),
        (b"Pf\n0 12\n-1\n", "width of 0"),
        (b"PF\n32 12\n-1\n", "colour"),
        (b"Pf\n32 12\n-1\n" + struct.pack("<f", float("nan")) * 384, "none of its pixels has a true disparity"),
        (b"Pf\n32 12\n-1\n" + struct.pack("<f", 1e30) * 384, "is not a disparity"),
    ],
)
def test_hostile_pfm(tmp_path, evaluate, content, says):
    (tmp_path / "h.pfm").write_bytes(content)
    fail(
        tmp_path,
        *evaluate,
        "--truth-left",
        tmp_path / "h.pfm",
        "--config",
        "tiny",
        says=["--truth-left", "h.pfm", says],
    )


@pytest.mark.parametrize("content", [b"P5\n60000 60000\n255\n", b"P5\n-3 4\n255\n", b"\x89PNG\r\n\x1a\n", b"GIF89a"])
def test_hostile_images(tmp_path, evaluate, content):
    (tmp_path / "h.png").write_bytes(content)
    fail(
        tmp_path,
        *evaluate,
        "--truth-left",
        tmp_path / "h.png",
        "--config",
        "tiny",
        says=["--truth-left", "h.png", "not an image"],
    )


def test_json_that_cannot_be_written(tmp_path, evaluate):
    truth = pfm(tmp_path / "t.pfm", lambda x, y: 3)
    (tmp_path / "file").write_text("")
    arguments = [*evaluate[:-2], "--truth-right", truth, "--config", "tiny", "--json"]
    fail(tmp_path, *arguments, tmp_path / "file" / "e.json", says=["--json", "file"])
    (tmp_path / "folder").mkdir()
    fail(tmp_path, *arguments, tmp_path / "folder", says=["folder", "--json"])
