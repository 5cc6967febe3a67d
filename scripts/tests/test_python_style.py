# SPDX-License-Identifier: Apache-2.0
"""Layout, lint and types of the Python files, as pyproject.toml asks for them; and that each of the three tools refuses
what is wrong."""

import subprocess

import pytest

from conftest import where_reachable
from flow.base import venv
from flow.base.tools import ROOT

CONFIGURATION = ROOT / "pyproject.toml"
REQUIREMENTS = ROOT / "scripts" / "requirements-style.txt"
CHECKS = {
    "lint": ("ruff", "check", "--config", CONFIGURATION),
    "layout": ("ruff", "format", "--check", "--diff", "--config", CONFIGURATION),
    "types": ("mypy", "--config-file", CONFIGURATION),
}
BAD_FILES = [
    ("lint", "import os\n", "F401"),
    ("lint", "def text(words=[]):\n    return words\n", "B006"),
    ("lint", f'TEXT = "{120 * "x"}"\n', "E501"),
    ("layout", "x = { 'a':1 }\n", 'x = {"a": 1}'),
    ("types", "def double(number):\n    return 2 * number\n", "no-untyped-def"),
    ("types", 'def double(number: int) -> int:\n    return "2" * number\n', "return-value"),
    ("types", "def first(words: list[str] = None) -> str:\n    return words[0]\n", "assignment"),
]


@pytest.fixture(scope="module")
def check():
    """Runs the tool of one of the CHECKS; without files on all that pyproject.toml names."""
    programs = where_reachable(lambda: venv.ensure("venv-style", REQUIREMENTS, "the style checker (ruff, mypy)"))

    def run(kind, *files):
        program, *options = CHECKS[kind]
        return subprocess.run([programs / program, *options, *files], cwd=ROOT, capture_output=True, text=True)

    return run


@pytest.mark.parametrize("kind", CHECKS)
def test_every_file_is_right(check, kind):
    process = check(kind)
    assert process.returncode == 0, process.stdout + process.stderr


@pytest.mark.parametrize("kind, text, word", BAD_FILES)
def test_a_bad_file_is_refused(check, tmp_path, kind, text, word):
    (tmp_path / "bad.py").write_text(text)
    process = check(kind, tmp_path / "bad.py")
    assert process.returncode == 1 and word in process.stdout, process.stdout + process.stderr


@pytest.mark.parametrize("folder", ["scripts", "scripts/flow/base", "scripts/tests", "hls_tb", "cmake"])
def test_all_folders_are_looked_at(check, folder):
    shown = check("lint", "--show-files").stdout
    assert f"{ROOT / folder}/" in shown
