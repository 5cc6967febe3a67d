# SPDX-License-Identifier: Apache-2.0
"""Compares what a simulator observed with what the C++ core said, and measures clocks. The only judge of all simulators."""

from dataclasses import dataclass
from typing import Optional

from .vectors import Expected, Observed


@dataclass(frozen=True)
class Mismatch:
    """`expected` is None for a surplus output, `got` is None for a missing one."""

    expected: Optional[Expected]
    got: Optional[Observed]
    disparity_bits: int = 8  # of one row in the port word

    def __str__(self):
        if self.expected is None:
            return f"clock {self.got.clock}: surplus output, disparity {self.got.disparity} flags {self.got.flags}"
        e = self.expected
        row = self.wrong_row()
        where = f"clock {e.clock}, frame {e.frame}, x {e.x}, y {e.y + row}: expected disparity {self._row(e.disparity, row)} flags {e.flags}"
        if self.got is None:
            return f"{where}, got nothing"
        return f"{where}, got disparity {self._row(self.got.disparity, row)} flags {self.got.flags} at clock {self.got.clock}"

    @property
    def clock(self):
        return (self.expected or self.got).clock

    def wrong_row(self):
        """The uppermost row of the group that differs; the upper one when the difference is elsewhere."""
        if self.got is None or self.got.disparity == "X" or self.got.disparity == self.expected.disparity:
            return 0
        difference = self.got.disparity ^ self.expected.disparity
        return ((difference & -difference).bit_length() - 1) // self.disparity_bits

    def _row(self, word, row):
        """One row's disparity of a port word."""
        return word if word == "X" else word >> (self.disparity_bits * row) & ((1 << self.disparity_bits) - 1)


@dataclass(frozen=True)
class Verdict:
    expected: int  # outputs that should have come
    compared: int  # outputs that came and had a partner
    mismatches: int  # differing, missing and surplus outputs
    first_mismatch: Optional[Mismatch]

    @property
    def passed(self):
        """Nothing expected is no pass: a comparison of nothing proves nothing."""
        return self.expected > 0 and self.compared == self.expected and self.mismatches == 0


def compare(expected, observed, disparity_bits=8):
    """Every output in order: disparity, flags and the very clock must agree."""
    wrong = [
        Mismatch(e, o, disparity_bits)
        for e, o in zip(expected, observed)
        if (e.clock, e.disparity, e.flags) != (o.clock, o.disparity, o.flags)
    ]
    wrong += [Mismatch(e, None, disparity_bits) for e in expected[len(observed) :]]
    wrong += [Mismatch(None, o, disparity_bits) for o in observed[len(expected) :]]
    return Verdict(len(expected), min(len(expected), len(observed)), len(wrong), wrong[0] if wrong else None)


@dataclass(frozen=True)
class Timing:
    frames: int
    clocks_per_frame: Optional[int]  # None when no whole frame was simulated
    initiation_interval: Optional[dict]  # min, avg, max clocks between outputs of one line
    latency_clocks: Optional[int]


def measure(stimulus, observed, configuration):
    """Clocks as seen at the ports of the simulated VHDL.

    clocks_per_frame: from start of frame to start of frame of the outputs when frames came back to back, else from the
    first pixel pair in to the last disparity out. latency_clocks: from the pixel pair that completes the first window to
    its disparity. The interval is only that of the core when the stimulus has no bubbles.
    """
    numbers = [o for o in observed if o.flags != "X"]
    starts = [o.clock for o in numbers if o.flags & 1]
    outputs_per_frame = (
        configuration["output_width_px"] * configuration["output_height_px"] // configuration["pixels_per_clock"]
    )
    whole_frames = len(numbers) // outputs_per_frame
    first_input = next((clock for clock, (valid, start) in enumerate(stimulus) if valid and start), None)
    clocks = None
    if whole_frames > 1:
        clocks = starts[1] - starts[0]
    elif whole_frames == 1:
        clocks = numbers[outputs_per_frame - 1].clock - first_input + 1
    gaps = [b.clock - a.clock for a, b in zip(numbers, numbers[1:]) if not a.flags & 2]
    interval = {"min": min(gaps), "avg": sum(gaps) / len(gaps), "max": max(gaps)} if gaps else None
    latency = _latency(stimulus, starts, configuration) if starts else None
    return Timing(len(starts), clocks, interval, latency)


def _latency(stimulus, starts, configuration):
    """From the last group of pixels that the first output needs to that output."""
    first = next(clock for clock, (valid, start) in enumerate(stimulus) if valid and start)
    valid_clocks = [clock for clock in range(first, len(stimulus)) if stimulus[clock][0]]
    return starts[0] - valid_clocks[configuration["groups_to_first_output"] - 1]
