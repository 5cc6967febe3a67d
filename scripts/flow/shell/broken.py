# SPDX-License-Identifier: Apache-2.0
"""Ways in which a stream can break. Each takes the correct beats of a frame and gives those that are sent instead; a
correct frame comes after them."""

from collections.abc import Callable
from random import Random

from .contract import LAST, START, Beat
from .pool import Frame, Geometry

Change = Callable[[int], int]  # of flags


def beats_of(frame: Frame, geometry: Geometry) -> list[Beat]:
    """A frame as correct beats. `geometry`: of one that has no size of its own."""
    columns = (frame.geometry or geometry).columns
    return [
        (data, (START if i == 0 else 0) | (LAST if i % columns == columns - 1 else 0))
        for i, data in enumerate(frame.groups)
    ]


def _with(beats: list[Beat], changes: dict[int, Change]) -> list[Beat]:
    """Beats with the flags of some places changed."""
    return [(data, changes[i](flags) if i in changes else flags) for i, (data, flags) in enumerate(beats)]


def _set(flag: int) -> Change:
    return lambda flags: flags | flag


def _clear(flag: int) -> Change:
    return lambda flags: flags & ~flag


def _somewhere(rng: Random, g: Geometry) -> int:
    """A place that is neither at an end of its line nor in the first line."""
    return rng.randrange(1, g.row_groups) * g.columns + rng.randrange(1, g.columns - 1)


def _plain(beats: list[Beat]) -> list[Beat]:
    return [(data, flags & ~START) for data, flags in beats]


def _all_flags_random(beats: list[Beat], rng: Random, g: Geometry) -> list[Beat]:
    return [(data, rng.choice((0, 0, 0, 0, START, LAST, LAST, START | LAST))) for data, _ in beats[: g.columns]]


CASES: dict[str, Callable[[list[Beat], Random, Geometry], list[Beat]]] = {
    "early end of line with the first beat": lambda b, rng, g: _with(b, {0: _set(LAST)}),
    "early end of line within the first line": lambda b, rng, g: _with(
        b, {rng.randrange(1, g.columns - 1): _set(LAST)}
    ),
    "early end of line one beat too soon": lambda b, rng, g: _with(b, {g.columns - 2: _set(LAST)}),
    "early end of line somewhere": lambda b, rng, g: _with(b, {_somewhere(rng, g): _set(LAST)}),
    "early end of the last line": lambda b, rng, g: _with(b, {g.groups - 2: _set(LAST)}),
    "no end of the first line": lambda b, rng, g: _with(b, {g.columns - 1: _clear(LAST)}),
    "no end of a line": lambda b, rng, g: _with(b, {g.columns * rng.randrange(1, g.row_groups) - 1: _clear(LAST)}),
    "no end of the last line": lambda b, rng, g: _with(b, {g.groups - 1: _clear(LAST)}),
    "no end of line at all": lambda b, rng, g: [(data, flags & ~LAST) for data, flags in b],
    "end of line with each beat": lambda b, rng, g: [(data, flags | LAST) for data, flags in b],
    "ends of lines one beat late": lambda b, rng, g: [
        (data, (b[i - 1][1] & LAST) | (flags & START)) for i, (data, flags) in enumerate(b)
    ],
    "a beat lost": lambda b, rng, g: (lambda at: b[:at] + b[at + 1 :])(_somewhere(rng, g)),
    "a beat twice": lambda b, rng, g: (lambda at: b[:at] + b[at - 1 :])(_somewhere(rng, g)),
    "the last beat lost": lambda b, rng, g: b[:-1],
    "a line lost": lambda b, rng, g: b[: -g.columns],
    "a line too many": lambda b, rng, g: b + _plain(b[: g.columns]),
    "a beat too many": lambda b, rng, g: b + _plain(b[:1]),
    "half a frame": lambda b, rng, g: b[: g.groups // 2],
    "half a line": lambda b, rng, g: b[: g.columns // 2],
    "a single beat": lambda b, rng, g: b[:1],
    "a single beat with both flags": lambda b, rng, g: [(b[0][0], START | LAST)],
    "no start of frame": lambda b, rng, g: _plain(b),
    "start of frame with the second beat": lambda b, rng, g: (
        [(b[0][0], b[0][1] & ~START), (b[1][0], b[1][1] | START)] + b[2:]
    ),
    "start of frame twice": lambda b, rng, g: b[:1] + b,
    "start of frame within a line": lambda b, rng, g: _with(b, {_somewhere(rng, g): _set(START)}),
    "start of frame with a later line": lambda b, rng, g: _with(
        b, {g.columns * rng.randrange(1, g.row_groups): _set(START)}
    ),
    "start of frame with the last beat": lambda b, rng, g: _with(b, {g.groups - 1: _set(START)}),
    "start of frame with each beat": lambda b, rng, g: [
        (data, flags | START) for data, flags in b[: rng.randrange(3, 9)]
    ],
    "noise before the frame": lambda b, rng, g: (
        [(rng.choice(b)[0], rng.choice((0, LAST))) for _ in range(rng.randrange(1, 40))] + b
    ),
    "noise after the frame": lambda b, rng, g: (
        b + [(rng.choice(b)[0], rng.choice((0, LAST))) for _ in range(rng.randrange(1, 40))]
    ),
    "random flags": _all_flags_random,
    "random flags in a frame": lambda b, rng, g: _with(
        b, {rng.randrange(g.groups): lambda flags: flags ^ rng.choice((START, LAST)) for _ in range(3)}
    ),
}
