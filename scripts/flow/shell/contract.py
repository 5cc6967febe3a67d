# SPDX-License-Identifier: Apache-2.0
"""What stereo_ip promises, as a model of the beats that went in, and the one judge of what came out in every simulator.

Beats of s_axis: (data, flags), flags: bit 0 start of frame, bit 1 end of line.
Beats of m_axis: (data, flags), flags: bit 0 start of frame, bit 1 frame error, bit 2 end of line.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from .pool import Frame, Geometry

Beat = tuple[int, int]  # (data, flags)

START, LAST = 1, 2
RESULT_START, RESULT_ERROR, RESULT_LAST = 1, 2, 4


@dataclass
class Incoming:
    """A frame as the stream brought it."""

    geometry: Geometry
    groups: list[int] = field(default_factory=list)
    whole: bool = False
    broken: bool = False


@dataclass
class Expectation:
    frames: list[Incoming]  # the last one may be neither whole nor broken: the stream ends in it
    errors: set[str]


def expect(beats: Iterable[Beat], geometry: Geometry, sizes: Sequence[Geometry] = ()) -> Expectation:
    """What must become of a stream, from the definition of its framing. `sizes`: of the first frames, where they differ
    from that of all others."""
    frames: list[Incoming] = []
    errors: set[str] = set()
    current: Incoming | None = None
    lost = False
    for data, flags in beats:
        if flags & START:
            if current is not None:
                current.broken = True
                errors.add("early_start")
            current, lost = Incoming(sizes[len(frames)] if len(frames) < len(sizes) else geometry), False
            frames.append(current)
        elif current is None:
            if not lost:
                errors.add("outside_frame")
            continue
        at_end = len(current.groups) % current.geometry.columns == current.geometry.columns - 1
        current.groups.append(data)
        if bool(flags & LAST) != at_end:
            errors.add("late_line_end" if at_end else "early_line_end")
            current.broken, lost = True, True
        current.whole = not current.broken and len(current.groups) == current.geometry.groups
        if current.broken or current.whole:
            current = None
    return Expectation(frames, errors)


class Judge:
    """Compares the beats of m_axis with the expectation; collects sentences about what is wrong."""

    def __init__(self, geometry: Geometry, pool: Sequence[Frame]) -> None:
        self.geometry = geometry
        self.by_groups = {frame.groups: frame for frame in pool}
        self.pool = pool
        self.exact_frames = 0
        self.broken_frames = 0
        self.compared = 0
        self.problems: list[str] = []

    def judge(
        self,
        beats: Iterable[Beat],
        results: Sequence[Beat],
        complete: bool = True,
        sizes: Sequence[Geometry] = (),
    ) -> Expectation:
        """`beats` were taken from s_axis since a reset, `results` given on m_axis. `complete`: the simulation waited
        until nothing more came; otherwise (a reset) the results may end anywhere. `sizes`: see expect."""
        expectation = expect(beats, self.geometry, sizes)
        frames = [frame for frame in expectation.frames if frame.whole or frame.broken or not complete]
        due = sum(frame.geometry.results for frame in frames)
        if complete and len(results) < due and not self._ends_in_open_frame(expectation):
            self._problem(f"{len(results)} beats came out, {due} were due")
        most = sum(frame.geometry.results for frame in expectation.frames)
        if len(results) > most:
            self._problem(f"{len(results) - most} beats more came out than all frames have")
        first = 0
        for number, frame in enumerate(expectation.frames):
            self._judge_frame(number, frame, results[first : first + frame.geometry.results])
            first += frame.geometry.results
        return expectation

    @staticmethod
    def _ends_in_open_frame(expectation: Expectation) -> bool:
        # Flush groups only follow a frame's end: what stands before an open frame leaves with that frame's pixels.
        return bool(expectation.frames) and not (expectation.frames[-1].whole or expectation.frames[-1].broken)

    def _problem(self, sentence: str) -> None:
        self.problems.append(sentence)

    def _judge_frame(self, number: int, frame: Incoming, part: Sequence[Beat]) -> None:
        source = self._source(frame)
        if source is None:
            self._problem(f"frame {number}: no frame of the pool begins so; the test is wrong")
            return
        same = self._same_groups(frame, source)
        for place, beat in enumerate(part):
            self._judge_beat(f"frame {number}, beat {place}", frame, source, same, place, beat)
        if len(part) == frame.geometry.results:
            self.exact_frames += frame.whole
            self.broken_frames += frame.broken
            if frame.broken and not part[-1][1] & RESULT_ERROR:
                self._problem(f"frame {number} is broken, but its last beat does not say so")

    def _judge_beat(self, where: str, frame: Incoming, source: Frame, same: int, place: int, beat: Beat) -> None:
        """`same`: how many groups are those of the source."""
        data, flags = beat
        columns = frame.geometry.result_columns
        framing = (RESULT_START if place == 0 else 0) | (RESULT_LAST if place % columns == columns - 1 else 0)
        if flags & ~RESULT_ERROR != framing:
            self._problem(f"{where}: start and end of line are {flags & ~RESULT_ERROR}, expected {framing}")
        if flags & RESULT_ERROR and not frame.broken:
            self._problem(f"{where}: frame error in a whole frame")
        if not flags & RESULT_ERROR and source.needs[place] > len(frame.groups):
            self._problem(f"{where}: depends on filling but has no frame error")
        if source.needs[place] <= same:
            self.compared += 1
            if data != source.results[place]:
                self._problem(f"{where}: expected {source.results[place]:x}, got {data:x}")

    def _source(self, frame: Incoming) -> Frame | None:
        """The frame of the pool that was sent."""
        found = self.by_groups.get(tuple(frame.groups))
        if found is not None:
            return found
        if frame.whole:
            return None
        candidates = [(self._same_groups(frame, entry), index) for index, entry in enumerate(self.pool)]
        return self.pool[max(candidates)[1]]

    @staticmethod
    def _same_groups(frame: Incoming, source: Frame) -> int:
        for count, (a, b) in enumerate(zip(frame.groups, source.groups)):
            if a != b:
                return count
        return min(len(frame.groups), len(source.groups))
