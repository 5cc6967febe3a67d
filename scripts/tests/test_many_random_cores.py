# SPDX-License-Identifier: Apache-2.0
"""Hundreds of random configurations; tens of minutes."""

import pytest

from flow_commands import call


@pytest.mark.parametrize(
    "family, count", [("block_matching", 500), ("phase_correlation", 100), ("absolute_difference", 50)]
)
def test_random_configurations_are_exact(family, count):
    process = call("random_configurations.py", "--family", family, "--count", count)
    assert process.returncode == 0, process.stdout + process.stderr
    assert f"{count} of {count} configurations exact" in process.stdout
