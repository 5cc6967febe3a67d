# SPDX-License-Identifier: Apache-2.0
"""Random frames of two cameras for a system: gaps, skew, a sink that waits, and cameras that lose pixels, rows or
frames; and the judge of what came out."""

import random
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..base import rtl
from ..base.configurations import Configuration, option
from ..base.errors import FlowError
from . import pipeline, play, record
from .pipeline import Image, Node, Table
from .template import System

FRAMES = 12  # of a run
BROKEN = 2  # of them
FIRST_TO_BREAK = (1, 4, 7)
FOCAL_BASELINE = 16 * 400  # in sixteenths of pixels times millimetres
LEAST_BLANKING_CLOCKS = 400  # between two frames
Pair = tuple[Image, Image]


class Material(NamedTuple):
    """Tables, pairs of images, and the frames that must come of them."""

    tables: list[Table]
    depths: list[int]
    pairs: list[Pair]
    frames: list[list[int]]


class Verdict(NamedTuple):
    """Of one run of a broken stream."""

    exact: int
    mismatches: int  # frames that do not say error and are none of those that were sent, in their order
    hangs: int  # the last frame, which is whole, did not come out


def random_table(stage: Configuration, generator: random.Random, reach: int) -> Table:
    columns, rows = option(stage, "table_columns"), option(stage, "table_rows")
    return [
        [Node(generator.randint(-reach, reach), generator.randint(-reach, reach)) for _ in range(columns)]
        for _ in range(rows)
    ]


def random_image(row: Configuration, generator: random.Random) -> Image:
    levels = 1 << rtl.pixel_bits_of(row)
    return [[generator.randrange(levels) for _ in range(row["width_px"])] for _ in range(row["height_px"])]


def shifted_pair(row: Configuration, generator: random.Random) -> Pair:
    """One image beside itself, some pixels away, with noise: random pairs pass next to no check."""
    image, away = random_image(row, generator), generator.randrange(row["disparities"])
    levels = 1 << rtl.pixel_bits_of(row)
    other = [
        [
            min(levels - 1, line[min(x + away, len(line) - 1)] + generator.randrange(levels // 64))
            for x in range(len(line))
        ]
        for line in image
    ]
    return image, other


def expected(system: System, pair: Pair, tables: Sequence[Table], depths: Sequence[int], folder: Path) -> list[int]:
    folder.mkdir(parents=True, exist_ok=True)
    stage = pipeline.rows_of(system)[0]
    bits = rtl.pixel_bits_of(stage)
    images = [pipeline.rectified(image, table, stage) for image, table in zip(pair, tables)]
    left, right = (
        pipeline.write_pgm(folder / f"{side}.pgm", image, bits) for side, image in zip(("left", "right"), images)
    )
    return pipeline.depth_frame(system, left, right, depths, folder, images[0])


def material(system: System, seed: int, pairs: int, folder: Path) -> Material:
    stage, core = pipeline.rows_of(system)
    generator = random.Random(seed)
    tables = [random_table(stage, generator, 160), random_table(stage, generator, 160)]
    depths = pipeline.depth_table(system, FOCAL_BASELINE)
    made = [
        shifted_pair(core, generator) if at % 2 else (random_image(core, generator), random_image(core, generator))
        for at in range(pairs)
    ]
    frames = [expected(system, pair, tables, depths, folder / str(at)) for at, pair in enumerate(made)]
    return Material(tables, depths, made, frames)


def streams(
    pairs: Sequence[Pair],
    generator: random.Random,
    gap_percent: int = 0,
    skew_clocks: int = 0,
    blanking_clocks: int = 0,
    line_clocks: int = 0,
) -> tuple[list[play.Beat], list[play.Beat]]:
    """Both cameras' beats; the same gaps, more before each line, so that it begins `line_clocks` or more after the one
    before, and before each frame, and the right one some clocks later."""
    left = [beat for pair in pairs for beat in play.beats(pair[0])]
    right = [beat for pair in pairs for beat in play.beats(pair[1])]
    width = len(pairs[0][0][0])
    gaps = [generator.randrange(4) if generator.randrange(100) < gap_percent else 0 for _ in left]
    for at in range(width, len(gaps), width):
        gaps[at] += max(0, line_clocks - width - sum(gaps[at - width + 1 : at + 1]))
    for at in range(0, len(gaps), width * len(pairs[0][0])):
        gaps[at] += blanking_clocks
    for stream in (left, right):
        stream[:] = [beat._replace(gap=gap) for beat, gap in zip(stream, gaps)]
    late = right if skew_clocks > 0 else left
    late[0] = late[0]._replace(gap=late[0].gap + abs(skew_clocks))
    return left, right


def lose(stream: list[play.Beat], at: int, count: int) -> None:
    """Beats that a camera does not send; those behind them come when they would have come."""
    clocks = sum(beat.gap + 1 for beat in stream[at : at + count])
    del stream[at : at + count]
    stream[at] = stream[at]._replace(gap=stream[at].gap + clocks)


def judge(seen: play.Observation, frames: Sequence[list[int]], order: Sequence[int]) -> Verdict:
    """`order`: the frames that were sent."""
    at, exact, mismatches = 0, 0, 0
    for frame in seen.frames:
        if frame.error and len(frame.words) == len(frames[0]):
            continue
        found = at
        while found < len(order) and frames[order[found]] != frame.words:
            found += 1
        if frame.error or found == len(order):  # a frame that begins has all its beats, error or not
            mismatches += 1
        else:
            at, exact = found + 1, exact + 1
    hangs = not seen.frames or seen.frames[-1].error or seen.frames[-1].words != frames[order[-1]]
    return Verdict(exact, mismatches, int(hangs))


def play_broken(simulation: play.Simulation, made: Material, seed: int, out: Path) -> Verdict:
    """FRAMES frames with gaps, skew and a sink that waits; of BROKEN frames one camera loses a pixel, a row or all."""
    generator = random.Random(seed)
    core = pipeline.rows_of(simulation.system)[1]
    width, pixels = core["width_px"], core["width_px"] * core["height_px"]
    order = [generator.randrange(len(made.pairs)) for _ in range(FRAMES)]
    clocks = pipeline.line_clocks(simulation.system)
    skew = generator.randrange(-3 * clocks, 3 * clocks)
    blanking = max(LEAST_BLANKING_CLOCKS, pipeline.pause_clocks(simulation.system))
    left, right = streams([made.pairs[number] for number in order], generator, 20, skew, blanking, clocks)
    for frame in sorted(generator.sample(FIRST_TO_BREAK, BROKEN), reverse=True):  # never on both sides of one frame
        count = generator.choice((1, width, pixels))
        at = frame * pixels + generator.randrange(pixels - count + 1)  # of this frame only
        lose(generator.choice((left, right)), at, count)
    seen = simulation.play(play.table_writes(made.tables, made.depths), left, right, out, (10, seed))
    return judge(seen, made.frames, order)


def run(system: System, frames: int, work: Path) -> record.Streams:
    """As many runs as give `frames` frames, each of another seed."""
    runs = -(-frames // FRAMES)
    simulation = play.Verilated(system)
    made = material(system, 5, 24, work / "material")
    total = Verdict(0, 0, 0)
    for seed in range(runs):
        try:
            verdict = play_broken(simulation, made, seed, work / "run")
        except FlowError as error:
            print(f"seed {seed}: {error}")
            verdict = Verdict(0, 0, 1)
        if verdict.mismatches or verdict.hangs or verdict.exact != FRAMES - BROKEN:
            print(f"seed {seed}: {verdict}")
        total = Verdict(*(sum(values) for values in zip(total, verdict)))
    return {
        "command": f"scripts/camera_system.py --system {system.name} --streams {frames}",
        "frames": runs * FRAMES,
        "broken": runs * BROKEN,
        "exact": total.exact,
        "mismatches": total.mismatches,
        "hangs": total.hangs,
    }


def passed(played: record.Streams) -> bool:
    """Each fault costs its frame only."""
    return not played["mismatches"] and not played["hangs"] and played["exact"] == played["frames"] - played["broken"]
