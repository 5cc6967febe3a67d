# SPDX-License-Identifier: Apache-2.0
"""From steps and what a simulator observed to a verdict."""

from . import script
from .contract import Judge


def judge(steps, observation, geometry, pool):
    """A Judge that has seen every segment between resets."""
    verdict = Judge(geometry, pool)
    verdict.problems += observation.breaches
    parts = script.segments(steps)
    if observation.hangs:
        verdict.problems.append(f"a beat was not taken for ever, clock {observation.clocks}")
        return verdict
    if len(parts) != len(observation.segments):
        verdict.problems.append(f"{len(observation.segments) - 1} resets instead of {len(parts) - 1}")
        return verdict
    for number, (beats, results) in enumerate(zip(parts, observation.segments)):
        before = len(verdict.problems)
        verdict.judge(beats, [result[:2] for result in results], complete=number == len(parts) - 1)
        verdict.problems[before:] = [f"after reset {number}: {sentence}" for sentence in verdict.problems[before:]]
    if verdict.compared == 0:
        verdict.problems.append("nothing was compared")
    return verdict
