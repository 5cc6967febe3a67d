# SPDX-License-Identifier: Apache-2.0
"""The judge of stereo_ip's streams: it must accept what is right and name what is wrong."""

import random

import pytest

from flow.base.errors import FlowError
from flow.shell import registers, script
from flow.shell.broken import CASES, beats_of
from flow.shell.contract import LAST, RESULT_ERROR, RESULT_LAST, RESULT_START, START, Judge, expect
from flow.shell.judge import judge
from flow.shell.pool import Frame, Geometry
from flow.shell.verilated import Observation, read_observation
from flow_commands import call

GEOMETRY = Geometry(columns=8, row_groups=4, result_columns=5)
# A result needs the groups up to that of the same place one line below.
NEEDS = tuple(min((i // 5 + 1) * 8 + i % 5 + 4, 32) for i in range(20))
POOL = [Frame(tuple(range(100 * f, 100 * f + 32)), tuple(range(1000 * f, 1000 * f + 20)), NEEDS) for f in (1, 2)]


def results_of(frame, mark_from=None):
    """The beats of m_axis for a frame, marked from one place on."""
    return [
        (
            data,
            (RESULT_START if i == 0 else 0)
            | (RESULT_LAST if i % 5 == 4 else 0)
            | (RESULT_ERROR if mark_from is not None and i >= mark_from else 0),
        )
        for i, data in enumerate(frame.results)
    ]


def problems(beats, results, complete=True):
    verdict = Judge(GEOMETRY, POOL)
    verdict.judge(beats, results, complete)
    return verdict.problems


def test_whole_frames_pass():
    verdict = Judge(GEOMETRY, POOL)
    verdict.judge(beats_of(POOL[0], GEOMETRY) + beats_of(POOL[1], GEOMETRY), results_of(POOL[0]) + results_of(POOL[1]))
    assert not verdict.problems
    assert (verdict.exact_frames, verdict.broken_frames, verdict.compared) == (2, 0, 40)


def test_broken_frame_passes_with_its_mark():
    beats = beats_of(POOL[0], GEOMETRY)[:20] + beats_of(POOL[1], GEOMETRY)
    marked = results_of(POOL[0], mark_from=6)
    verdict = Judge(GEOMETRY, POOL)
    verdict.judge(beats, marked + results_of(POOL[1]))
    assert not verdict.problems
    assert (verdict.exact_frames, verdict.broken_frames) == (1, 1)


@pytest.mark.parametrize(
    "change, word",
    [
        (lambda r: r[:-1], "39 beats came out, 40 were due"),
        (lambda r: r + [(0, 0)], "1 beats more"),
        (lambda r: [r[1], r[0], *r[2:]], "expected 3e8, got 3e9"),
        (lambda r: [r[0], r[0], *r[2:]], "start and end of line are 1, expected 0"),
        (lambda r: r[:20] + [(r[20][0], 0)] + r[21:], "frame 1, beat 0: start and end"),
        (lambda r: r[:30] + [(r[30][0] ^ 1, r[30][1])] + r[31:], "frame 1, beat 10: expected 7da, got 7db"),
        (lambda r: r[:39] + [(r[39][0], r[39][1] | RESULT_ERROR)], "frame error in a whole frame"),
        (lambda r: r[20:] + r[:20], "frame 0, beat 0"),
        (lambda r: [], "0 beats came out"),
    ],
)
def test_faults_are_named(change, word):
    beats = beats_of(POOL[0], GEOMETRY) + beats_of(POOL[1], GEOMETRY)
    assert any(word in sentence for sentence in problems(beats, change(results_of(POOL[0]) + results_of(POOL[1]))))


def test_partial_frame_without_mark_is_named():
    beats = beats_of(POOL[0], GEOMETRY)[:20] + beats_of(POOL[1], GEOMETRY)
    found = problems(beats, results_of(POOL[0]) + results_of(POOL[1]))
    assert any("is broken, but its last beat does not say so" in sentence for sentence in found)
    assert any("depends on filling but has no frame error" in sentence for sentence in found)


def test_wrong_disparity_before_the_break_is_named():
    beats = beats_of(POOL[0], GEOMETRY)[:20] + beats_of(POOL[1], GEOMETRY)
    wrong = results_of(POOL[0], mark_from=6)
    wrong[2] = (wrong[2][0] + 1, wrong[2][1])
    assert problems(beats, wrong + results_of(POOL[1])) == ["frame 0, beat 2: expected 3ea, got 3eb"]


def test_reset_may_cut_results_anywhere():
    beats = beats_of(POOL[0], GEOMETRY)
    assert not problems(beats, results_of(POOL[0])[:7], complete=False)
    assert problems(beats, results_of(POOL[0]) + [(0, 0)], complete=False)


@pytest.mark.parametrize(
    "name, errors",
    [
        ("early end of line somewhere", {"early_line_end"}),
        ("no end of a line", {"late_line_end"}),
        ("half a frame", {"early_start"}),
        ("no start of frame", {"outside_frame"}),
        ("a line too many", {"outside_frame"}),
        ("a beat lost", {"early_line_end"}),
        ("a beat twice", {"late_line_end"}),
    ],
)
def test_expectation(rng, name, errors):
    good = beats_of(POOL[1], GEOMETRY)
    expected = expect(
        beats_of(POOL[0], GEOMETRY) + CASES[name](beats_of(POOL[0], GEOMETRY), rng, GEOMETRY) + good, GEOMETRY
    )
    assert expected.errors == errors
    assert expected.frames[-1].whole and tuple(expected.frames[-1].groups) == POOL[1].groups


def test_every_case_breaks_something(rng):
    correct = beats_of(POOL[0], GEOMETRY)
    assert len(CASES) >= 20
    for name, change in CASES.items():
        beats = change(list(correct), rng, GEOMETRY)
        assert beats != correct, name
        assert name.startswith("random") or expect(beats + correct, GEOMETRY).errors, name


def test_observation_with_breaches_and_hangs(tmp_path):
    path = tmp_path / "observed.txt"
    path.write_text("r\no 3e8 1 17\np m_axis changed before it was taken, clock 5\nhang 90\n")
    seen = read_observation(path)
    assert (seen.segments, seen.hangs, seen.clocks) == ([[(1000, 1, 17)]], True, 90)
    verdict = judge(script.send(beats_of(POOL[0], GEOMETRY)), seen, GEOMETRY, POOL)
    assert len(verdict.problems) == 2 and "for ever" in verdict.problems[1]
    path.write_text("r\no 3e8 1 17\n")
    with pytest.raises(FlowError, match="did not finish"):
        read_observation(path)


def test_comparing_nothing_is_no_pass():
    assert judge([], Observation([[]]), GEOMETRY, POOL).problems == ["nothing was compared"]


def test_same_seed_same_steps():
    steps = [script.mixture(random.Random(seed), POOL, GEOMETRY, 20) for seed in (1, 1, 2)]
    assert steps[0] == steps[1] != steps[2]
    assert {step[0] for step in steps[0]} >= {"beat", "idle", "rates"}
    assert all(
        flags in (0, START, LAST, START | LAST) for kind, *values in steps[0] if kind == "beat" for flags in values[1:]
    )


def test_registers_follow_from_their_description():
    process = call("registers.py", "--check")
    assert process.returncode == 0, process.stdout
    used = set()
    for family in ("block_matching", "semi_global", "trellis"):
        offsets = [register["offset"] for register in registers.description_of(family)]
        assert offsets == sorted(set(offsets)), "a family has one name for an address"
        used.update(offsets)
    assert used == set(range(0, 4 * len(used), 4))
    names = [register["name"] for register in registers.description()]
    assert len(names) == len(set(names)), "a name has one address"
