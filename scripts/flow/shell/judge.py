# SPDX-License-Identifier: Apache-2.0
"""From steps and what a simulator observed to a verdict."""

from collections.abc import Sequence

from .contract import Judge
from .pool import Frame, Geometry
from .script import Step, segments
from .verilated import Observation


def judge(steps: Sequence[Step], observation: Observation, geometry: Geometry, pool: Sequence[Frame]) -> Judge:
    """A Judge that has seen every segment between resets. Frames with sizes of their own are sent in their order."""
    sizes = [frame.geometry for frame in pool if frame.geometry is not None]
    verdict = Judge(geometry, pool)
    verdict.problems += observation.breaches
    parts = segments(steps)
    if observation.hangs:
        verdict.problems.append(f"a beat was not taken for ever, clock {observation.clocks}")
        return verdict
    if len(parts) != len(observation.segments):
        verdict.problems.append(f"{len(observation.segments) - 1} resets instead of {len(parts) - 1}")
        return verdict
    for number, (beats, results) in enumerate(zip(parts, observation.segments)):
        before = len(verdict.problems)
        seen = [(data, flags) for data, flags, _ in results]
        verdict.judge(beats, seen, complete=number == len(parts) - 1, sizes=sizes)
        verdict.problems[before:] = [f"after reset {number}: {sentence}" for sentence in verdict.problems[before:]]
    if verdict.compared == 0:
        verdict.problems.append("nothing was compared")
    return verdict
