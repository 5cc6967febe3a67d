# SPDX-License-Identifier: Apache-2.0
"""Pairs as a board takes them, and its map against that of the program."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from pathlib import Path

from ..base import files
from ..base.errors import FlowError
from ..base.tools import Word, find_stereo_hls, run
from ..quality.error_picture import read_pfm
from ..rendering import pictures
from .protocol import Map


def pixels(path: Path, config: str, sizes: Mapping[str, int]) -> bytes:
    """Grey values of an image, row by row."""
    image = pictures.load(path, gray=True)
    wanted = sizes["width_px"], sizes["height_px"]
    found = image.shape[1], image.shape[0]
    if found != wanted:
        raise FlowError(f"{path} has {found[0]}x{found[1]} pixels; {config} takes {wanted[0]}x{wanted[1]}")
    return image.tobytes()


def picture(found: Map, sizes: Mapping[str, int]) -> bytes:
    """PNG: grey value = disparity in pixels, 0 where it is not valid."""
    numpy, _ = pictures.libraries()
    values = numpy.frombuffer(found.disparities, numpy.uint8) * numpy.array(found.valid, numpy.uint8)
    return pictures.png(values.reshape(sizes["height_px"], sizes["output_width_px"]))


def of_program(config: str, left: bytes, right: bytes, sizes: Mapping[str, int]) -> list[float]:
    """The map of the program `stereo_hls` row by row, infinite where it is not valid."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for side, grey in (("left", left), ("right", right)):
            (folder / f"{side}.pgm").write_bytes(files.pgm(sizes["width_px"], sizes["height_px"], grey))
        images: list[Word] = ["--left", folder / "left.pgm", "--right", folder / "right.pgm"]
        words: list[Word] = ["--config", config, *images, "--write", "pfm", "--out", folder / "map"]
        run([find_stereo_hls(), "match", *words], passes_errors=True)
        first = json.loads((folder / "map" / "match.json").read_text())["output_first_column"]
        rows = read_pfm(folder / "map" / "disparity.pfm")[:, first : first + sizes["output_width_px"]]
        return [float(value) for row in rows for value in row]


def differences(found: Map, expected: list[float], width: int) -> list[str]:
    """A sentence for each pixel that differs."""
    sentences = []
    for number, (disparity, valid, wanted) in enumerate(zip(found.disparities, found.valid, expected)):
        got = float(disparity) if valid else float("inf")
        if got != wanted:
            sentences.append(f"x {number % width}, y {number // width}: {wanted:g} expected, got {got:g}")
    return sentences
