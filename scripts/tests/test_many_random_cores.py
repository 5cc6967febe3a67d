# SPDX-License-Identifier: Apache-2.0
"""Many random configurations, other ones on each run; minutes. Env STEREO_RANDOM_CORES: how many of block matching, the
other families' follow from it."""

import os

import pytest

from flow_commands import call

CORES = int(os.environ.get("STEREO_RANDOM_CORES", "40"))
PARTS = {"block_matching": 1, "phase_correlation": 5, "dynamic_range": 10, "absolute_difference": 10}


@pytest.mark.parametrize("family", PARTS)
def test_random_configurations_are_exact(family):
    count = max(1, CORES // PARTS[family])
    process = call("random_configurations.py", "--family", family, "--count", count)
    assert process.returncode == 0, process.stdout + process.stderr
    assert f"{count} of {count} configurations exact" in process.stdout
