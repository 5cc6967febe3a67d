# SPDX-License-Identifier: Apache-2.0
"""One whole frame of a system in Verilator: a pair as two calibrated cameras would see it, not rectified, and the
depths of the software pipeline for it. The latency of its rows comes out of the same run."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..base import rtl
from ..base.configurations import option
from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.tools import ROOT, Word, find_stereo_hls, run
from ..rendering import pictures
from ..rendering.pictures import Array
from . import pipeline, play, record
from .beside import FILLED_AT, MEASURED_AT
from .pipeline import Table
from .template import System, beside_of

SEED = 1  # of the scene
CALIBRATION = ROOT / "examples" / "camera_system" / "calibration_640x480.yml"
FOCAL_BASELINE = 16 * 540 * 60  # of that calibration, but for what its rectification scales
SCALE = 1.2  # of a pair that is smaller than a frame
STEPS = 12  # of the fixed point that turns a table round: each divides the error by 10 or more


class Scene(NamedTuple):
    name: str
    tables: list[Table]
    depths: list[int]
    cameras: list[list[list[int]]]  # what the cameras send: rows of grey values
    words: list[int]  # of m_axis


def _hls(*arguments: Word) -> None:
    run([find_stereo_hls(), *arguments], passes_errors=True)


def fitted(picture: Array, width: int, height: int) -> Array:
    """In the middle of a frame, larger where it is smaller than that."""
    numpy, image = pictures.libraries()
    rows, columns = picture.shape
    if (columns, rows) == (width, height):
        return picture
    scale = min(SCALE, width / columns, height / rows)
    size = int(columns * scale), int(rows * scale)
    frame: Array = numpy.zeros((height, width), numpy.uint8)
    left, top = (width - size[0]) // 2, (height - size[1]) // 2
    frame[top : top + size[1], left : left + size[0]] = numpy.asarray(image.fromarray(picture).resize(size))
    return frame


def unrectified(picture: Array, table: Table, grid_px: int, fraction_bits: int) -> Array:
    """What the camera of a table sees where the rectified image is `picture`. The table leads from rectified pixels to
    those of the camera; here a fixed point leads back."""
    numpy, _ = pictures.libraries()
    height, width = picture.shape
    nodes = numpy.array(table, float) / (1 << fraction_bits)  # rows, columns, (x, y)
    at_y, at_x = (values.astype(float) for values in numpy.mgrid[0:height, 0:width])
    x, y = at_x.copy(), at_y.copy()
    for _ in range(STEPS):
        offset = _bilinear(nodes, numpy.clip(x, 0, width - 1) / grid_px, numpy.clip(y, 0, height - 1) / grid_px)
        x, y = at_x - offset[..., 0], at_y - offset[..., 1]
    inside = (x >= 0) & (x <= width - 1) & (y >= 0) & (y <= height - 1)
    seen = _bilinear(picture[..., None].astype(float), x.clip(0, width - 1), y.clip(0, height - 1))[..., 0]
    image: Array = numpy.where(inside, seen.round(), 0).astype(numpy.uint8)
    return image


def _bilinear(values: Array, x: Array, y: Array) -> Array:
    """values: rows, columns, and what stands there; x, y: places within."""
    left, top = x.astype(int).clip(0, values.shape[1] - 2), y.astype(int).clip(0, values.shape[0] - 2)
    u, v = (x - left)[..., None], (y - top)[..., None]
    upper = values[top, left] * (1 - u) + values[top, left + 1] * u
    lower = values[top + 1, left] * (1 - u) + values[top + 1, left + 1] * u
    between: Array = upper * (1 - v) + lower * v
    return between


def scene(system: System, pair: Path | None, work: Path) -> Scene:
    """`pair`: a folder with left.png and right.png, rectified; else a generated scene."""
    stage, core = pipeline.rows_of(system)
    width, height = core["width_px"], core["height_px"]
    if rtl.pixel_bits_of(core) != rtl.PIXEL_BITS:
        raise FlowError(f"--frame is for pixels of {rtl.PIXEL_BITS} bits; {system.name} has {rtl.pixel_bits_of(core)}")
    if (width, height) != (640, 480):
        raise FlowError(f"--frame is for systems of 640x480; {system.name} has {width}x{height}")
    if pair is None:
        _hls("scene", "--config", system.matching, "--seed", SEED, "--out", work / "scene")
    source = pair or work / "scene"
    settings = [f"{name}={option(stage, name)}" for name in ("grid_px", "rows_above", "rows_below")]
    rectify: list[Word] = ["rectify", "--calibration", CALIBRATION]
    for setting in settings:
        rectify += ["--set", setting]
    _hls(*rectify, "--width", width, "--height", height, "--out", work / "tables")
    tables = [pipeline.read_table(work / "tables" / f"{side}_table.hex", stage) for side in ("left", "right")]
    bits = option(stage, "offset_fraction_bits")
    cameras: list[list[list[int]]] = []
    for side, table in zip(("left", "right"), tables):
        picture = fitted(pictures.load(source / f"{side}.png", gray=True), width, height)
        cameras.append(unrectified(picture, table, option(stage, "grid_px"), bits).tolist())
        pipeline.write_pgm(work / f"{side}.pgm", cameras[-1])
    _hls(*rectify, "--left", work / "left.pgm", "--right", work / "right.pgm", "--out", work / "rectified")
    depths = pipeline.depth_table(system, FOCAL_BASELINE)
    rectified = [work / "rectified" / f"{side}.png" for side in ("left", "right")]
    image = pictures.load(rectified[0]).tolist()
    words = pipeline.depth_frame(system, rectified[0], rectified[1], depths, work / "vectors", image)
    name = f"pair of the folder {pair.name}" if pair else f"stereo_hls scene, seed {SEED}"
    return Scene(name, list(tables), depths, cameras, words)


def latency(seen: play.Observation, of_frame: int = 0) -> record.Latency:
    """Of the rows whose depths do not wait for the flush at the end: those of the first half."""
    frame, sent = seen.frames[of_frame], seen.line_ends[1]
    rows = range(len(frame.line_ends) // 2)
    return {
        "first_clocks": max(frame.line_starts[row] - sent[row] for row in rows),
        "last_clocks": max(frame.line_ends[row] - sent[row] for row in rows),
    }


def mismatches(frames: Sequence[play.Frame], words: Sequence[int]) -> int:
    """Depths that are not as they must be, and all of a frame that is missing or too much."""
    if len(frames) != 1 or len(frames[0].words) != len(words) or frames[0].error:
        return len(words)
    return sum(got != word for got, word in zip(frames[0].words, words))


def run_frame(system: System, pair: Path | None, work: Path) -> record.Frame:
    """Plays it and compares. FlowError where a depth differs."""
    work.mkdir(parents=True, exist_ok=True)
    made = scene(system, pair, work)
    left, right = (play.beats(camera, pipeline.line_clocks(system)) for camera in made.cameras)
    seen = play.Verilated(system).play(play.table_writes(made.tables, made.depths), left, right, work)
    wrong = mismatches(seen.frames, made.words)
    if wrong or set(seen.responses) != {play.OKAY}:
        raise FlowError(
            f"{system.entity}: {wrong} of {len(made.words)} depths are not those of the software pipeline",
            EXIT_MISMATCH,
        )
    result: record.Frame = {
        "command": f"scripts/camera_system.py --system {system.name} --frame",
        "scene": made.name,
        "depths": len(made.words),
        "known": sum(word >> MEASURED_AT & 1 for word in made.words),
        "mismatches": wrong,
        "clocks": seen.clocks,
        "latency": latency(seen),
    }
    if beside_of(system).filled:
        result["filled"] = sum(word >> FILLED_AT & 1 for word in made.words)
    return result
