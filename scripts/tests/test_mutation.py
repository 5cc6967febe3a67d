# SPDX-License-Identifier: Apache-2.0
"""A short mutation run with a fixed seed: the tests notice every fault, or it is proved to change nothing."""

import json

import pytest

from conftest import need, where_reachable
from cover import with_slow
from flow.mutation import judges, mutants
from flow.mutation.batch import Batch
from flow.shell import cocotb_runs
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars
from flow_commands import call


@pytest.fixture(autouse=True)
def tools(ghdl, yosys):
    need("yosys-abc", "YOSYS_ABC")
    where_reachable(cocotb_runs.environment_folder)


@pytest.mark.parametrize("core, shell", with_slow([(2, 1), (12, 4)], [(2, 1)]))
def test_short_run(tmp_path, core, shell):
    process = call("mutate.py", "--core", core, "--shell", shell, "--seed", 1, "--out", tmp_path)
    assert process.returncode == 0, process.stdout + process.stderr
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["mutants"] == core + shell and report["score_percent"] >= 98 and report["survivors"] == []


@pytest.mark.slow
def test_many_in_one_build_are_judged_as_alone(tmp_path):
    """By Verilator as by GHDL."""
    core, files = judges.Core("tiny"), scalars.files(manifest.core_files("tiny"))
    made = Batch(core, files, mutants.samples(files, [1]), 14, tmp_path / "batch")
    made.judge()
    assert 0 < len(made.shown) < len(made.inside)
    for number, mutant in made.inside.items():
        folder = tmp_path / str(number)
        changed = mutants.write(mutant, folder / "rtl")
        alone = core.noticed([*files[:-1], changed], [], folder)
        assert bool(alone) == (mutant.key in made.shown), f"{mutant.key}: {alone}"


@pytest.mark.slow
def test_other_streams_show_what_the_default_one_does_not(tmp_path):
    """A default stream that ends after some clocks has holes."""
    core, files = judges.Core("tiny"), scalars.files(manifest.core_files("tiny"))
    head, *lines = core.stimulus.read_text().splitlines()
    core.stimulus = tmp_path / "short.txt"
    core.stimulus.write_text("\n".join([head, *lines[:1000]]) + "\n")
    core.expected = [output for output in core.expected if output.clock < 1000]
    made = Batch(core, files, mutants.samples(files, [1]), 60, tmp_path / "batch")
    made.judge(2)
    assert made.elsewhere and not made.elsewhere.keys() & made.shown.keys()
    [mutant, *_] = [mutant for mutant in made.inside.values() if mutant.key in made.elsewhere]
    assert made.objection(mutant, tmp_path).startswith("only the stress stream of seed")
