# SPDX-License-Identifier: Apache-2.0
"""A short mutation run with a fixed seed: the tests notice every fault of it."""

import json

import pytest

from flow.base.errors import FlowError
from flow.shell import cocotb_runs
from flow_commands import call


def test_short_run(ghdl, yosys, tmp_path):
    try:
        cocotb_runs.environment_folder()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")
    process = call("mutate.py", "--core", 8, "--shell", 4, "--seed", 1, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["mutants"] == 12 and report["score_percent"] >= 98 and report["survivors"] == []
