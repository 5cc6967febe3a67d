# SPDX-License-Identifier: Apache-2.0
"""The JSON of co-simulations is as docs/schemas describes it: of runs that pass, differ, fail and do not run."""

import copy
import json
import subprocess
import typing

import pytest

from conftest import need, where_reachable
from flow.base import venv
from flow.base.tools import ROOT
from flow.cosim import regression
from flow.cosim.report import Failure, Report
from flow_commands import altered_rtl, call, cosim, random_pair

SCHEMAS = ROOT / "docs" / "schemas"
REQUIREMENTS = ROOT / "scripts" / "requirements-samples.txt"
WINNER = (r"(slice2_best_index_0_0 <= )slice1_best_index_0_0;", r"\g<1>slice1_best_index_0_0 / 2;")


@pytest.fixture(scope="module")
def complaint():
    """What the checker of a schema says of a file; nothing where it fits."""
    programs = where_reachable(lambda: venv.ensure("venv-samples", REQUIREMENTS, "the checker of JSON schemas"))

    def check(schema, path):
        words = [programs / "check-jsonschema", "--schemafile", SCHEMAS / f"{schema}.schema.json", path]
        process = subprocess.run(words, capture_output=True, text=True)
        return process.stdout + process.stderr if process.returncode else ""

    return check


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A regression of two configurations, a run that differs, and one that fails."""
    need("ghdl", "GHDL")
    folder = tmp_path_factory.mktemp("runs")
    process = call("cosim.py", "--config", "tiny", "tiny_p2", "--rows", "8", "--out", folder / "regression")
    assert process.returncode == 0, process.stdout + process.stderr
    pair = random_pair(folder / "pair", "tiny", levels=4)
    faulty = altered_rtl(folder / "rtl", "tiny", *WINNER)
    assert cosim("tiny", pair, folder / "differs", "--rtl", faulty).returncode == 1
    assert cosim("tiny", ("none.png", pair[1]), folder / "fails").returncode == 2
    return folder


def test_a_regression(complaint, folder):
    assert complaint("regression", folder / "regression" / "summary.json") == ""


@pytest.mark.parametrize("run", ["regression/tiny-ghdl", "differs", "fails"])
def test_a_run(complaint, folder, run):
    assert complaint("report", folder / run / "report.json") == ""


def changed(content, path, value):
    """A copy with the member at `path` set, or left out."""
    content = copy.deepcopy(content)
    *parents, last = path
    place = content
    for name in parents:
        place = place[name]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return content


@pytest.mark.parametrize(
    "path, value",
    [
        (["counts", "passed"], 1),
        (["format"], "stereo-hls regression 2"),
        (["runs", 0, "outcome"], "perhaps"),
        (["runs", 0, "report", "latency_clocks"], "16"),
        (["runs", 0, "report", "initiation_interval"], {"min": 1}),
        (["runs", 0, "report", "mismatches"], None),
        (["runs", 1, "exit_code"], None),
        (["environment", "commit"], None),
    ],
)
def test_a_fault_of_the_summary_is_noticed(complaint, folder, tmp_path, path, value):
    content = json.loads((folder / "regression" / "summary.json").read_text())
    (tmp_path / "summary.json").write_text(json.dumps(changed(content, path, value)))
    assert complaint("regression", tmp_path / "summary.json")


def test_a_failure_is_no_result(complaint, folder, tmp_path):
    content = json.loads((folder / "fails" / "report.json").read_text())
    for path, value in ((["passed"], True), (["error", "exit_code"], 1), (["error"], None)):
        (tmp_path / "report.json").write_text(json.dumps(changed(content, path, value)))
        assert complaint("report", tmp_path / "report.json")


@pytest.mark.parametrize("definition, kind", [("result", Report), ("failure", Failure)])
def test_the_schema_has_every_member(definition, kind):
    """So that a new one is not forgotten."""
    described = json.loads((SCHEMAS / "report.schema.json").read_text())["$defs"][definition]
    assert described["properties"].keys() == typing.get_type_hints(kind).keys()
    assert set(described["required"]) <= described["properties"].keys()


def test_the_schema_has_the_format_and_the_outcomes():
    described = json.loads((SCHEMAS / "regression.schema.json").read_text())
    assert described["properties"]["format"]["const"] == regression.FORMAT
    assert described["$defs"]["outcome"]["enum"] == list(regression.Outcome.__args__)
