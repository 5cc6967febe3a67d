# SPDX-License-Identifier: Apache-2.0
"""What a bench does, as a list of steps that every simulator plays.

("beat", data, flags)     to s_axis
("idle", clocks)          nothing comes to s_axis
("rates", source, sink)   from now on in percent: chance that a beat waits another clock, that the sink takes nothing
("reset", clocks)         aresetn low for so long, without regard to anything in progress
("drain",)                wait until nothing has come out for a while
("write", address, value) a register; Verilator only, as the next two
("query", address, value, mask)   what a register must read
("level", value)          what the output `irq` must be
"""

from collections.abc import Iterable, Sequence
from random import Random
from typing import Literal, Union

from ..base.rtl import Setting
from . import registers
from .broken import CASES, beats_of
from .contract import Beat
from .pool import Frame, Geometry

Step = Union[
    tuple[Literal["beat"], int, int],
    tuple[Literal["idle"], int],
    tuple[Literal["rates"], int, int],
    tuple[Literal["reset"], int],
    tuple[Literal["drain"]],
    tuple[Literal["write"], int, int],
    tuple[Literal["query"], int, int, int],
    tuple[Literal["level"], int],
]

RATES = ((0, 0), (0, 0), (50, 0), (0, 50), (30, 30), (80, 20), (20, 80), (5, 0), (0, 5), (90, 0), (0, 90))


def send(beats: Iterable[Beat]) -> list[Step]:
    return [("beat", data, flags) for data, flags in beats]


def frames(rng: Random, pool: Sequence[Frame], geometry: Geometry, count: int, back_to_back: float = 0.5) -> list[Step]:
    """Correct frames with gaps of many lengths between some of them."""
    steps: list[Step] = []
    for _ in range(count):
        steps += send(beats_of(rng.choice(pool), geometry))
        if rng.random() >= back_to_back:
            steps.append(("idle", rng.choice((1, 1, 2, 3, rng.randrange(geometry.columns * 3)))))
    return steps


def rates(rng: Random) -> list[Step]:
    return [("rates", *rng.choice(RATES))]


def broken(rng: Random, pool: Sequence[Frame], geometry: Geometry, name: str, times: int = 1) -> list[Step]:
    """A broken stretch, then one or two correct frames, so that the broken ones come at odd and even places; `times` in
    all."""
    steps: list[Step] = []
    for _ in range(times):
        steps += send(CASES[name](beats_of(rng.choice(pool), geometry), rng, geometry))
        if rng.random() < 0.3:
            steps.append(("idle", rng.randrange(1, 2 * geometry.columns)))
        for _ in range(rng.choice((1, 2))):
            steps += send(beats_of(rng.choice(pool), geometry))
    return steps


def reset_within(rng: Random, pool: Sequence[Frame], geometry: Geometry) -> list[Step]:
    """A frame that a reset cuts off at a random clock, then correct frames of a source that starts anew."""
    beats = beats_of(rng.choice(pool), geometry)
    sent = send(beats[: rng.randrange(1, len(beats))])
    return [*sent, ("idle", rng.randrange(1, 40)), ("reset", rng.choice((1, 1, 2, 5)))]


def mixture(rng: Random, pool: Sequence[Frame], geometry: Geometry, count: int) -> list[Step]:
    """`count` correct frames at random rates with broken stretches and resets between them."""
    steps: list[Step] = []
    good = 0
    while good < count:
        steps += rates(rng)
        kind = rng.random()
        if kind < 0.55:
            number = min(rng.randrange(1, 4), count - good)
            steps += frames(rng, pool, geometry, number)
            good += number
        elif kind < 0.95:
            steps += broken(rng, pool, geometry, rng.choice(sorted(CASES)))
            good += 1
        else:
            steps += reset_within(rng, pool, geometry)
    return steps


def with_size(geometry: Geometry, pixels_per_clock: int) -> list[Step]:
    """Writes the size of the images that follow."""
    map_ = registers.by_name()
    return [
        ("write", map_["image_width"]["offset"], geometry.columns),
        ("write", map_["image_height"]["offset"], geometry.row_groups * pixels_per_clock),
    ]


def _refused(rng: Random, setting: Setting) -> list[int]:
    """Values beyond the limits of a setting."""
    values = [setting.largest + 1, 0xFFFF, rng.randrange(setting.largest + 1, 0x10000)]
    if setting.least:
        values += [0, setting.least - 1]
    if setting.step > 1:
        values += [setting.largest - 1]
    return values


def changed_settings(rng: Random, pool: Sequence[Frame], geometry: Geometry, settings: Sequence[Setting]) -> list[Step]:
    """Each frame of the pool with its own settings, which are written while the frame before it comes in. Some writes
    are beyond the limits: the old value stays. Begins and ends with the interrupts."""
    map_ = registers.by_name()
    offset = {setting.name: map_[setting.name]["offset"] for setting in settings}
    interrupt, status = map_["interrupt"]["offset"], map_["status"]["offset"]
    refused = 1 << map_["status"]["fields"]["setting_refused"]["low"]
    done = 1 << map_["interrupt"]["fields"]["frame_done"]["low"]
    largest_low = map_[settings[0].name]["fields"]["largest"]["low"]

    def written(frame: Frame) -> list[list[Step]]:
        """A list for each register."""
        lists: list[list[Step]] = []
        for setting, value in zip(settings, frame.settings):
            whole = setting.largest << largest_low | value
            steps: list[Step] = [("write", offset[setting.name], value)]
            if rng.random() < 0.3:
                beyond = rng.choice(_refused(rng, setting))
                steps += [("write", offset[setting.name], beyond), ("query", status, refused, refused)]
                steps += [("write", status, refused), ("query", status, 0, refused)]
            lists.append([*steps, ("query", offset[setting.name], whole, 0xFFFFFFFF)])
        rng.shuffle(lists)
        return lists

    steps: list[Step] = []
    for setting in settings:
        start = setting.largest << largest_low | setting.start
        steps.append(("query", offset[setting.name], start, 0xFFFFFFFF))
    steps += [step for part in written(pool[0]) for step in part]
    steps += [("level", 0), ("write", interrupt, 1)]
    for frame, following in zip(pool, [*pool[1:], pool[0]]):
        sent = send(beats_of(frame, geometry))
        # The start is in the core when so many beats are taken: what stands in front of it holds less.
        places = sorted(rng.randrange(8, len(sent) + 1) for _ in settings)
        for place, part in zip(reversed(places), written(following)):
            sent[place:place] = part
        steps += rates(rng) if rng.random() < 0.3 else []
        steps += sent
        if frame is pool[0]:
            steps += [("drain",), ("level", 1), ("query", interrupt, done | 1, 0xFFFF), ("write", interrupt, done | 2)]
            steps += [("idle", 4), ("level", 0), ("query", interrupt, 2, 0xFFFF)]
            steps += [("write", offset[settings[0].name], 0xFFFF), ("idle", 4), ("level", 1)]
            steps += [("write", status, refused), ("idle", 4), ("level", 0)]
    return steps


def segments(steps: Iterable[Step]) -> list[list[Beat]]:
    """The beats between resets, one list for each."""
    parts: list[list[Beat]] = [[]]
    for step in steps:
        if step[0] == "beat":
            parts[-1].append((step[1], step[2]))
        elif step[0] == "reset":
            parts.append([])
    return parts


def as_text(steps: Iterable[Step], seed: int) -> str:
    """The file for verilator_axi_bench.cpp: one step a line."""
    lines = [f"stereo-hls stream 1 seed={seed}"]
    for step in steps:
        if step[0] == "beat":
            lines.append(f"b {step[1]:x} {step[2]}")
        else:
            kind, *values = step
            lines.append(" ".join(["p" if kind == "rates" else kind[0], *map(str, values)]))
    return "\n".join(lines) + "\n"
