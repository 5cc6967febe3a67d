# SPDX-License-Identifier: Apache-2.0
"""Short mutation runs on a core of each family. A survivor's proof may take many minutes in the larger ones."""

import json

import pytest

from conftest import need
from flow_commands import call


@pytest.mark.parametrize("config", ["tiny_sgm", "tiny_trellis", "tiny_phase", "tiny_dynamic"])
def test_core_of_each_family(ghdl, yosys, tmp_path, config):
    need("yosys-abc", "YOSYS_ABC")
    process = call("mutate.py", "--config", config, "--core", 2, "--shell", 0, "--seed", 1, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert (report["config"], report["mutants"], report["survivors"]) == (config, 2, [])
