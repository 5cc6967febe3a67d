# SPDX-License-Identifier: Apache-2.0
"""Compares what a simulator observed with what the C++ core said, and measures clocks. The only judge of all
simulators."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypedDict

from ..base.configurations import Parameters, outputs_per_frame
from .vectors import Expected, Observed, Seen, Stimulus


@dataclass(frozen=True)
class Mismatch:
    """`expected` is None for a surplus output, `got` is None for a missing one."""

    expected: Expected | None
    got: Observed | None
    disparity_bits: int = 8  # of one row in the port word
    word: str = "disparity"  # what the word is

    def __str__(self) -> str:
        got, e = self.got, self.expected
        if e is None:
            assert got is not None
            return f"clock {got.clock}: surplus output, {self.word} {got.disparity} flags {got.flags}"
        row = self.wrong_row()
        where = f"clock {e.clock}, frame {e.frame}, x {e.x}, y {e.y + row}"
        wanted = f"expected {self.word} {self._row(e.disparity, row)} flags {e.flags}"
        if got is None:
            return f"{where}: {wanted}, got nothing"
        seen = f"got {self.word} {self._row(got.disparity, row)} flags {got.flags} at clock {got.clock}"
        return f"{where}: {wanted}, {seen}"

    @property
    def clock(self) -> int:
        """Where the ports begin to show something else: an output too many comes before the one that it displaces."""
        return min(output.clock for output in (self.expected, self.got) if output is not None)

    def wrong_row(self) -> int:
        """The uppermost row of the group that differs; the upper one when the difference is elsewhere."""
        if self.got is None or self.expected is None or not isinstance(self.got.disparity, int):
            return 0
        difference = self.got.disparity ^ self.expected.disparity
        return ((difference & -difference).bit_length() - 1) // self.disparity_bits if difference else 0

    def _row(self, word: Seen, row: int) -> Seen:
        """One row's disparity of a port word."""
        if not isinstance(word, int):
            return word
        return word >> (self.disparity_bits * row) & ((1 << self.disparity_bits) - 1)


@dataclass(frozen=True)
class Verdict:
    expected: int  # outputs that should have come
    compared: int  # outputs that came and had a partner
    mismatches: int  # differing, missing and surplus outputs
    first_mismatch: Mismatch | None

    @property
    def passed(self) -> bool:
        """Nothing expected is no pass: a comparison of nothing proves nothing."""
        return self.expected > 0 and self.compared == self.expected and self.mismatches == 0


def compare(
    expected: list[Expected], observed: list[Observed], disparity_bits: int = 8, word: str = "disparity"
) -> Verdict:
    """Every output in order: disparity, flags and the very clock must agree."""
    wrong = [
        Mismatch(e, o, disparity_bits, word)
        for e, o in zip(expected, observed)
        if (e.clock, e.disparity, e.flags) != (o.clock, o.disparity, o.flags)
    ]
    wrong += [Mismatch(e, None, disparity_bits, word) for e in expected[len(observed) :]]
    wrong += [Mismatch(None, o, disparity_bits, word) for o in observed[len(expected) :]]
    return Verdict(len(expected), min(len(expected), len(observed)), len(wrong), wrong[0] if wrong else None)


class Interval(TypedDict):
    """In clocks."""

    min: int
    avg: float
    max: int


@dataclass(frozen=True)
class Timing:
    frames: int
    clocks_per_frame: int | None  # None when no whole frame was simulated
    initiation_interval: Interval | None  # between outputs of one line
    latency_clocks: int | None


def measure(stimulus: Stimulus, observed: list[Observed], configuration: Parameters) -> Timing:
    """Clocks as seen at the ports of the simulated VHDL.

    clocks_per_frame: from start of frame to start of frame of the outputs when frames came back to back, else from the
    first pixel pair in to the last disparity out. latency_clocks: from the pixel pair that completes the first window
    to its disparity. The interval is only that of the core when the stimulus has no bubbles.
    """
    numbers = [(o.clock, o.flags) for o in observed if isinstance(o.flags, int)]
    starts = [clock for clock, flags in numbers if flags & 1]
    of_frame = outputs_per_frame(configuration)
    whole_frames = len(numbers) // of_frame
    first_input = next((clock for clock, (valid, start) in enumerate(stimulus) if valid and start), None)
    clocks = latency = None
    if whole_frames > 1:
        clocks = starts[1] - starts[0]
    elif whole_frames == 1 and first_input is not None:
        # A stage shows a pair for each one that comes in, those before the frame too.
        first = next((number for number, (_, flags) in enumerate(numbers) if flags & 1), 0)
        if first + of_frame <= len(numbers):
            clocks = numbers[first + of_frame - 1][0] - first_input + 1
    gaps = [later - clock for (clock, flags), (later, _) in zip(numbers, numbers[1:]) if not flags & 2]
    interval: Interval | None = None
    if gaps:
        interval = {"min": min(gaps), "avg": sum(gaps) / len(gaps), "max": max(gaps)}
    if starts and first_input is not None:
        latency = starts[0] - _completing_clock(stimulus, first_input, configuration)
    return Timing(len(starts), clocks, interval, latency)


def part_from(clock: int, stimulus: Stimulus, observed: list[Observed]) -> tuple[Stimulus, list[Observed]]:
    """What is sent and seen from a clock on, as if it were the first."""
    later = [replace(output, clock=output.clock - clock) for output in observed if output.clock >= clock]
    return stimulus[clock:], later


def count_frames(observed: list[Observed]) -> Timing:
    """Of a broken stream: its frames have no common length."""
    return Timing(sum(o.flags & 1 for o in observed if isinstance(o.flags, int)), None, None, None)


def _completing_clock(stimulus: Stimulus, first_input: int, configuration: Parameters) -> int:
    """The clock of the last group of pixels that the first output needs."""
    valid_clocks = [clock for clock in range(first_input, len(stimulus)) if stimulus[clock][0]]
    return valid_clocks[configuration["groups_to_first_output"] - 1]
