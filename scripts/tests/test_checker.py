# SPDX-License-Identifier: Apache-2.0
"""The judge of all simulators: it must not pass what it did not see."""

import pytest

from flow.cosim import checker
from flow.cosim.vectors import Expected, Observed

CONFIGURATION = {
    "width_px": 6,
    "height_px": 3,
    "disparities": 3,
    "window_px": 3,
    "output_width_px": 3,
    "output_height_px": 3,
    "pixels_per_clock": 1,
    "groups_to_first_output": 6 + 3 - 1 + 1 + 1,
}


def expected_frame(frames=1, start=20):
    """`frames` whole 3x3 maps; the first output of a row 3 clocks after the last of the row before."""
    outputs = []
    for frame in range(frames):
        for y in range(3):
            for x in range(3):
                clock = start + 18 * frame + 6 * y + x
                outputs.append(Expected(clock, x, y, frame, (x + y) % 3, (x == 0 and y == 0) | (x == 2) << 1))
    return outputs


def seen(expected):
    return [Observed(e.clock, e.disparity, e.flags) for e in expected]


def test_equal_passes():
    expected = expected_frame(2)
    verdict = checker.compare(expected, seen(expected))
    assert verdict.passed
    assert (verdict.expected, verdict.compared, verdict.mismatches, verdict.first_mismatch) == (18, 18, 0, None)


@pytest.mark.parametrize("change", [{"disparity": 9}, {"flags": 1}, {"clock": 1000}, {"disparity": "X", "flags": "X"}])
def test_one_difference_is_found(change):
    expected = expected_frame()
    observed = seen(expected)
    observed[4] = Observed(**{**observed[4].__dict__, **change})
    verdict = checker.compare(expected, observed)
    assert not verdict.passed
    assert verdict.mismatches == 1
    text = str(verdict.first_mismatch)
    for part in ("clock 27", "x 1", "y 1", "expected disparity 2 flags 0", f"got disparity {observed[4].disparity}"):
        assert part in text


@pytest.mark.parametrize("place", [999, 1000, 4096, 20_000, -1])
def test_the_last_of_many_outputs_counts_as_the_first(place):
    expected = expected_frame(5000)
    observed = seen(expected)
    observed[place] = Observed(observed[place].clock, 9, observed[place].flags)
    verdict = checker.compare(expected, observed)
    assert not verdict.passed and verdict.mismatches == 1 and verdict.compared == 45_000


def test_missing_outputs_are_mismatches():
    expected = expected_frame()
    verdict = checker.compare(expected, seen(expected)[:-2])
    assert not verdict.passed
    assert (verdict.compared, verdict.mismatches) == (7, 2)
    assert "got nothing" in str(verdict.first_mismatch)


def test_surplus_outputs_are_mismatches():
    expected = expected_frame()
    verdict = checker.compare(expected, [*seen(expected), Observed(99, 1, 0)])
    assert not verdict.passed
    assert verdict.mismatches == 1
    assert "clock 99: surplus output" in str(verdict.first_mismatch)


@pytest.mark.parametrize("observed", [[], [Observed(1, 0, 0)]])
def test_nothing_expected_is_no_pass(observed):
    assert not checker.compare([], observed).passed


def test_nothing_observed_is_no_pass():
    verdict = checker.compare(expected_frame(), [])
    assert not verdict.passed
    assert verdict.mismatches == 9


def test_the_row_that_differs_is_named():
    expected = [Expected(7, 4, 6, 1, 0x0A0B0C0D, 0)]
    verdict = checker.compare(expected, [Observed(7, 0x0AFF0C0D, 0)])
    assert "x 4, y 8: expected disparity 11 flags 0, got disparity 255" in str(verdict.first_mismatch)


def stimulus(frames=1, bubbles_after=None):
    """3 bubbles, then the pixel pairs of the frames and a flush row."""
    pairs = [(True, pair % 18 == 0 and pair < 18 * frames) for pair in range(18 * frames + 6)]
    clocks = [(False, False)] * 3 + pairs + [(False, False)] * 20
    if bubbles_after is not None:
        clocks[bubbles_after:bubbles_after] = [(False, False)] * 5
    return clocks


def test_timing_of_frames_back_to_back():
    timing = checker.measure(stimulus(2), seen(expected_frame(2)), CONFIGURATION)
    assert timing.frames == 2
    assert timing.clocks_per_frame == 18
    assert timing.initiation_interval == {"min": 1, "avg": 1.0, "max": 1}
    assert timing.latency_clocks == 20 - (3 + 6 + 3 - 1 + 1)


def test_timing_of_a_single_frame_counts_from_first_in_to_last_out():
    assert checker.measure(stimulus(), seen(expected_frame()), CONFIGURATION).clocks_per_frame == 20 + 12 + 2 - 3 + 1


def test_latency_is_counted_from_the_pair_that_completes_the_window():
    measured = checker.measure(stimulus(1, bubbles_after=5), seen(expected_frame(1, start=25)), CONFIGURATION)
    assert measured.latency_clocks == 8


def test_timing_of_no_output():
    timing = checker.measure(stimulus(), [], CONFIGURATION)
    assert (timing.frames, timing.clocks_per_frame, timing.initiation_interval, timing.latency_clocks) == (
        0,
        None,
        None,
        None,
    )
