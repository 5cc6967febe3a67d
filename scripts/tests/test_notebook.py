# SPDX-License-Identifier: Apache-2.0
"""The notebook of the examples runs, from a generated pair to a front; it is committed without its results."""

import json
import subprocess
import sys

import pytest

from flow.base.errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED
from flow.base.tools import ROOT
from flow_commands import call, refused

NOTEBOOK = ROOT / "examples" / "notebook" / "quality_cost.ipynb"


def notebook(*arguments):
    process = call("notebook.py", *arguments)
    if process.returncode == EXIT_MISSING_TOOL:
        pytest.skip(f"SKIP: {process.stderr.strip()}")
    return process


def test_it_is_committed_without_results():
    cells = json.loads(NOTEBOOK.read_text())["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert len(code) > 4
    for cell in code:
        assert cell["outputs"] == [] and cell["execution_count"] is None


def test_it_runs(tmp_path):
    process = notebook("--out", tmp_path / "out")
    assert process.returncode == 0, process.stdout + process.stderr
    pictures = sorted((tmp_path / "out").glob("*.png"))
    assert [path.name for path in pictures] == [f"quality_cost_{n}.png" for n in (1, 2, 3)]
    assert all(path.stat().st_size > 5000 for path in pictures)
    cells = json.loads((tmp_path / "out" / "quality_cost.ipynb").read_text())["cells"]
    *_, text = ("".join(output["text"]) for cell in cells for output in cell.get("outputs", []) if "text" in output)
    rows = [line.split() for line in text.splitlines()]
    costs, errors = [float(row[1]) for row in rows], [float(row[5]) for row in rows]
    assert len(rows) >= 3 and costs == sorted(costs) and errors == sorted(errors, reverse=True)


def test_a_notebook_that_fails(tmp_path):
    content = json.loads(NOTEBOOK.read_text())
    content["cells"] = [{**content["cells"][1], "source": ["import stereo_hls\n", "stereo_hls.trace('nope')"]}]
    (tmp_path / "bad.ipynb").write_text(json.dumps(content))
    process = notebook(tmp_path / "bad.ipynb", "--out", tmp_path / "out")
    refused(process, EXIT_TOOL_FAILED, "bad.ipynb", "bad.log")
    assert not list((tmp_path / "out").glob("bad*.ipynb"))
    assert "nope: there is no such configuration" in (tmp_path / "out" / "bad.log").read_text()


def test_no_notebook(tmp_path):
    refused(notebook(tmp_path / "none.ipynb"), 2, "none.ipynb: there is no such file")


def test_help():
    words = [sys.executable, ROOT / "scripts" / "notebook.py", "--help"]
    assert "quality_cost.ipynb" in subprocess.run(words, capture_output=True, text=True).stdout
