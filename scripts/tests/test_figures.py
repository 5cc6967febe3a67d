# SPDX-License-Identifier: Apache-2.0
"""What is worked out from a configuration alone."""

import pytest

from flow.base.configurations import configurations
from flow.cosim.job import middle_rows
from flow.implementation import figures

PAPER_P2 = {"width_px": 320, "height_px": 240, "disparities": 100, "pixels_per_clock": 2, "gap_groups": 0}
PAPER_P2 |= {"output_width_px": 220, "output_height_px": 240}


def test_a_frame_takes_a_clock_for_each_group():
    assert figures.clocks_per_frame(PAPER_P2) == 38_400
    assert figures.evaluations_per_clock(PAPER_P2) == 200


def test_recursive_sums_need_a_gap_between_frames():
    table = configurations()
    assert figures.clocks_per_frame(table["study_w7"]) == 320 * 64
    assert figures.clocks_per_frame(table["study_w7_recursive"]) == 320 * (64 + 3)


def test_speed_follows_from_the_clock():
    speed = figures.speed(PAPER_P2, 100.0, 20_000)
    assert speed["frames_per_second"] == pytest.approx(2604.17, abs=0.01)
    assert speed["mde_per_second"] == pytest.approx(20_000)
    assert speed["output_mde_per_second"] == pytest.approx(20_000 * 220 / 320)
    assert speed["evaluations_per_second_per_lut"] == pytest.approx(1e6)


def test_one_seed_is_no_median():
    assert [figures.counted(seeds) for seeds in (1, 2, 3)] == ["one seed", "median of 2", "median of 3"]
    assert figures.counted(1, "router1") == "one seed"
    assert figures.counted(3, "router2") == "median of 3, router2"


# (pixels a clock, groups to the first output, least rows wanted, result) of an image of 32x12
@pytest.mark.parametrize(
    "lanes, first, least, rows",
    [
        (1, 43, 8, "2:10"),
        (1, 43, 1, "5:7"),
        (2, 43, 3, "4:8"),
        (1, 32, 1, "5:6"),
        (1, 33, 1, "5:7"),
        (1, 352, 4, "0:11"),
        (1, 353, 4, None),
        (4, 65, 1, None),
        (1, 43, 12, None),
        (1, 43, 100, None),
    ],
)
def test_the_middle_rows_give_an_output(lanes, first, least, rows):
    parameters = {"width_px": 32, "height_px": 12, "pixels_per_clock": lanes, "groups_to_first_output": first}
    assert middle_rows(parameters, least) == rows


@pytest.mark.parametrize("name, parameters", configurations().items())
def test_the_middle_rows_of_every_configuration_give_an_output(name, parameters):
    rows = middle_rows(parameters, 8)
    first, end = map(int, rows.split(":")) if rows else (0, parameters["height_px"])
    assert 0 <= first < end <= parameters["height_px"] and (end - first) % parameters["pixels_per_clock"] == 0
    groups = (end - first) // parameters["pixels_per_clock"] * parameters["width_px"]
    assert groups >= parameters["groups_to_first_output"] or rows is None
