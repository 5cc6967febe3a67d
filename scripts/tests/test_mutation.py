# SPDX-License-Identifier: Apache-2.0
"""Short mutation runs with a fixed seed: the tests notice every fault of them."""

import json

import pytest

from conftest import need
from flow.base.errors import FlowError
from flow.shell import cocotb_runs
from flow_commands import call


@pytest.fixture(autouse=True)
def tools(ghdl, yosys):
    need("yosys-abc", "YOSYS_ABC")
    try:
        cocotb_runs.environment_folder()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")


def report_of(folder, *options):
    process = call("mutate.py", *options, "--seed", 1, "--out", folder)
    assert process.returncode == 0, process.stdout + process.stderr
    return json.loads((folder / "report.json").read_text())


def test_short_run(tmp_path):
    report = report_of(tmp_path, "--core", 8, "--shell", 4)
    assert report["mutants"] == 12 and report["score_percent"] >= 98 and report["survivors"] == []


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis", "tiny_phase", "tiny_dynamic"])
def test_core_of_each_family(tmp_path, config):
    report = report_of(tmp_path, "--config", config, "--core", 2, "--shell", 0)
    assert (report["config"], report["mutants"], report["killed"]) == (config, 2, 2)
