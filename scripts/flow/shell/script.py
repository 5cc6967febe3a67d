# SPDX-License-Identifier: Apache-2.0
"""What a bench does, as a list of steps that every simulator plays.

("beat", data, flags)     to s_axis
("idle", clocks)          nothing comes to s_axis
("rates", source, sink)   from now on in percent: chance that a beat waits another clock, that the sink takes nothing
("reset", clocks)         aresetn low for so long, without regard to anything in progress
("drain",)                wait until nothing has come out for a while
"""

from .broken import CASES, beats_of
from .contract import START

RATES = ((0, 0), (0, 0), (50, 0), (0, 50), (30, 30), (80, 20), (20, 80), (5, 0), (0, 5), (90, 0), (0, 90))


def send(beats):
    return [("beat", data, flags) for data, flags in beats]


def frames(rng, pool, geometry, count, back_to_back=0.5):
    """Correct frames with gaps of many lengths between some of them."""
    steps = []
    for _ in range(count):
        steps += send(beats_of(rng.choice(pool), geometry))
        if rng.random() >= back_to_back:
            steps.append(("idle", rng.choice((1, 1, 2, 3, rng.randrange(geometry.columns * 3)))))
    return steps


def rates(rng):
    return [("rates", *rng.choice(RATES))]


def broken(rng, pool, geometry, name, times=1):
    """A broken stretch, then one or two correct frames, so that the broken ones come at odd and even places; `times` in all."""
    steps = []
    for _ in range(times):
        steps += send(CASES[name](beats_of(rng.choice(pool), geometry), rng, geometry))
        if rng.random() < 0.3:
            steps.append(("idle", rng.randrange(1, 2 * geometry.columns)))
        for _ in range(rng.choice((1, 2))):
            steps += send(beats_of(rng.choice(pool), geometry))
    return steps


def reset_within(rng, pool, geometry):
    """A frame that a reset cuts off at a random clock, then correct frames of a source that starts anew."""
    beats = beats_of(rng.choice(pool), geometry)
    return send(beats[: rng.randrange(1, len(beats))]) + [
        ("idle", rng.randrange(1, 40)),
        ("reset", rng.choice((1, 1, 2, 5))),
    ]


def mixture(rng, pool, geometry, count):
    """`count` correct frames at random rates with broken stretches and resets between them."""
    steps, good = [], 0
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


def segments(steps):
    """The beats between resets, one list for each."""
    parts = [[]]
    for step in steps:
        if step[0] == "beat":
            parts[-1].append(step[1:])
        elif step[0] == "reset":
            parts.append([])
    return parts


def starts(steps):
    return sum(step[0] == "beat" and bool(step[2] & START) for step in steps)


def as_text(steps, seed):
    """The file for verilator_axi_bench.cpp: one step a line."""
    lines = [f"stereo-hls stream 1 seed={seed}"]
    for kind, *values in steps:
        lines.append(
            f"b {values[0]:x} {values[1]}"
            if kind == "beat"
            else " ".join([kind[0] if kind != "rates" else "p", *map(str, values)])
        )
    return "\n".join(lines) + "\n"
