# SPDX-License-Identifier: Apache-2.0
"""Random configurations from the whole space of options, other ones on each run: their cores against the definition."""

import re
import shutil

import pytest

from cover import with_slow
from flow.base.tools import ROOT
from flow.cosim import random_cores
from flow_commands import call, refused

# A census that reaches further down than the window: its last rows need a longer gap than the window does.
TALL_CENSUS = (
    "STEREO_ROW(tall_census, random, Config(), width_px = 32, height_px = 12, disparities = 8, cost = Cost::census, "
    "aggregation = Aggregation::recursive, slice_disparities = 3);"
)

# Remembered signs of candidates outside of the image are those of other pixels.
MASKED_SIGNS = (
    "STEREO_ROW(masked_signs, random, Config(), width_px = 63, height_px = 18, disparities = 25, window_px = 2, "
    "pixel_bits = 10, subpixel = true, full_width = true, sign_memory = true);"
)


# A core with a dynamic range takes long to compile.
FAST = [("block_matching", 2), ("phase_correlation", 1), ("absolute_difference", 1)]


@pytest.mark.parametrize("family, count", with_slow([*FAST, ("dynamic_range", 1)], FAST))
def test_new_random_configurations_are_exact(family, count):
    process = call("random_configurations.py", "--family", family, "--count", count)
    assert process.returncode == 0, process.stdout + process.stderr
    assert re.search(rf"^{count} of {count} configurations exact in \d+ maps$", process.stdout, re.MULTILINE)


@pytest.mark.parametrize("row", [TALL_CENSUS, MASKED_SIGNS], ids=["a census taller than its window", "masked signs"])
def test_a_rare_configuration_is_exact(row):
    process = call("random_configurations.py", "--row", row, "--seed", 1)
    assert process.returncode == 0, process.stdout + process.stderr


FAULTS = {
    "the gap counts the window only": (
        "hls/block_matching/config.hpp",
        r"return has_transform\(\) && transform > window_rows \? transform : window_rows;",
        "return window_rows;",
        TALL_CENSUS,
    ),
    "one flush group less": (
        "hls/support/schedule.hpp",
        r"left < 0 \? 0 : left, gap_groups",
        "left < 1 ? 0 : left - 1, gap_groups",
        TALL_CENSUS,
    ),
    "masked sums keep their high bits": (
        "hls/winner/candidate_mask.hpp",
        r"if constexpr \(kRemembersSigns\) shown.*;",
        "",
        MASKED_SIGNS,
    ),
}


@pytest.mark.parametrize("fault", with_slow(FAULTS, ["one flush group less"]))
def test_the_check_finds_a_fault(tmp_path, fault):
    """In a copy of the sources."""
    for folder in ("hls", "hls_tb"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    path, pattern, replacement, row = FAULTS[fault]
    text, count = re.subn(pattern, replacement, (tmp_path / path).read_text())
    assert count == 1, f"{path} has no {pattern}"
    (tmp_path / path).write_text(text)
    checker = random_cores.Checker("block_matching", 1, tmp_path, tmp_path)
    assert not checker.check(random_cores.core_of(row)).exact
    (tmp_path / path).write_text((ROOT / path).read_text())
    assert checker.check(random_cores.core_of(row)).exact, "the copy without the fault"


@pytest.mark.parametrize("differing", [["clocks_per_pixel"], ["cost", "full_width"], ["front_clocks"]])
def test_rows_differ_in_what_was_asked_for(differing):
    """And are those that the seed gives without the wish."""
    chosen = random_cores.draw("block_matching", 4, 5, differing)
    defaults = {"clocks_per_pixel": "1", "cost": "Cost::sad", "full_width": "false", "front_clocks": "1"}
    assert len({core.name for core in chosen}) == 4
    for core in chosen:
        assert all(f"{name} = " in core.row and f"{name} = {defaults[name]}," not in core.row for name in differing)
    every = {core.row for core in random_cores.draw("block_matching", 256, 5)}
    assert every.issuperset(core.row for core in chosen) and len(every) == 256


def test_bad_options():
    refused(call("random_configurations.py", "--differs", "nobody"), 2, "block_matching has no option 'nobody'")
    refused(
        call("random_configurations.py", "--row", TALL_CENSUS, "--differs", "cost"),
        2,
        "--differs has no effect beside --row",
    )
    refused(call("random_configurations.py", "--count", 0), 2, "--count: '0' is no whole number, 1 or more")
    refused(call("random_configurations.py", "--family", "nonsense"), 2, "nonsense")
    refused(call("random_configurations.py", "--row", "tiny"), 2, "'tiny' is no row of a configuration")
