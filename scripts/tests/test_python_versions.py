# SPDX-License-Identifier: Apache-2.0
"""The commands run with the oldest Python that scripts/flow/__init__.py names, without any package; an older one, or a
package that is missing, is told in one sentence."""

import functools
import os
import shutil
import subprocess
import sys

import pytest

import flow
from conftest import where_reachable
from flow.base import committed, venv
from flow.base.errors import FlowError
from flow.base.tools import ROOT, find_stereo_hls
from flow_commands import refused

COMMANDS = sorted((ROOT / "scripts").glob("*.py"))
OLDEST = ".".join(map(str, flow.OLDEST_PYTHON))
TOLD_ONLY = ("3.6", "3.7", "3.8")  # too old: they say so
PACKAGES = ("rich", "jinja2", "numpy", "matplotlib")
# What newer Pythons have and a command asks for itself: base/newer_python.py.
GUARDED = ("typing.NotRequired", "typing.is_typeddict")


@functools.cache
def python(version):
    """A Python of this version: one that STEREO_PYTHONS names, else that of PATH."""
    named = os.environ.get("STEREO_PYTHONS", "").split(os.pathsep)
    for candidate in [*filter(None, named), shutil.which(f"python{version}")]:
        if candidate and says(candidate) == version:
            return candidate
    pytest.skip(f"SKIP: python{version} is not installed")


def says(program):
    shown = subprocess.run(
        [program, "-c", "import sys; print('%d.%d' % sys.version_info[:2])"], capture_output=True, text=True
    )
    return shown.stdout.strip()


def call(program, command, *words, environment=None):
    """A command under that Python, without site packages."""
    words = [program, "-E", "-s", "-S", str(ROOT / "scripts" / command), *map(str, words)]
    return subprocess.run(words, capture_output=True, text=True, env={**os.environ, **(environment or {})})


def test_commands_take_the_python_of_the_path():
    assert {path.read_text().partition("\n")[0] for path in COMMANDS} == {"#!/usr/bin/env python3"}


@pytest.mark.parametrize("command", [path.name for path in COMMANDS])
@pytest.mark.parametrize("version", [OLDEST, "3.10"])
def test_a_command_runs_or_names_the_package(command, version):
    process = call(python(version), command, "--help")
    if process.returncode == 0:
        assert "exit codes: 0 done" in " ".join(process.stdout.split())
    else:
        [package] = [name for name in PACKAGES if f"the Python package {name} is missing" in process.stderr]
        refused(process, 3, python(version), "apt-get install", f"pip install {package}")


@pytest.mark.parametrize("command", [path.name for path in COMMANDS])
@pytest.mark.parametrize("version", TOLD_ONLY)
def test_an_older_python_is_told(command, version):
    refused(
        call(python(version), command, "--help"), 3, f"{command}: needs Python {OLDEST} or later", f" is {version}."
    )


@pytest.mark.parametrize("kit", ["vivado", "quartus", "fusesoc"])
def test_a_kit_is_the_same(tmp_path, kit):
    for name, program in (("old", python(OLDEST)), ("new", sys.executable)):
        process = call(program, "instantiate.py", "--kit", kit, "--config", "tiny", "--out", tmp_path / name)
        assert process.returncode == 0, process.stderr
    folders = [tmp_path / name for name in ("old", "new")]
    written = [{path.relative_to(f): path.read_bytes() for path in f.rglob("*.*") if path.is_file()} for f in folders]
    assert written[0] == written[1] and written[0]


def test_the_committed_wrapper():
    process = call(python(OLDEST), "instantiate.py", "--config", "tiny")
    assert process.returncode == 0 and process.stdout == (committed.folder("tiny") / "stereo_ip_tiny.vhd").read_text()


@pytest.fixture
def program():
    try:
        return find_stereo_hls()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")


@pytest.mark.parametrize("configs", [["tiny"], ["tiny", "tiny_p2"]])
def test_cosimulation(program, ghdl, tmp_path, configs):
    """Of one, and as a regression."""
    process = call(python(OLDEST), "cosim.py", "--config", *configs, "--rows", 4, "--out", tmp_path)
    assert process.returncode == 0 and "PASS" in process.stdout, process.stdout + process.stderr


def test_a_co_simulation_that_fails_is_explained(program, ghdl, tmp_path):
    """The trace of the C++, the first register and the page need nothing newer either."""
    from flow_commands import altered_rtl

    edited = altered_rtl(tmp_path, "tiny", r"disparity <= (.*);", r"disparity <= not (\1);")
    words = ["--config", "tiny", "--rtl", edited, "--allow-edited", "--out", tmp_path / "out"]
    process = call(python(OLDEST), "cosim.py", *words)
    assert process.returncode == 1 and "Traceback" not in process.stderr, process.stdout + process.stderr


@pytest.fixture(scope="module")
def vermin():
    requirements = ROOT / "scripts" / "requirements-style.txt"
    return where_reachable(lambda: venv.ensure("venv-style", requirements, "the style checker")) / "vermin"


def newer(vermin, *paths):
    """What vermin finds that the oldest Python does not have."""
    excluded = [word for name in GUARDED for word in ("--exclude", name)]
    words = [vermin, f"-t={OLDEST}-", "--no-tips", "--violations", *excluded, *paths]
    process = subprocess.run(words, capture_output=True, text=True)
    return process.returncode, process.stdout


def test_nothing_newer_is_used(vermin):
    code, said = newer(vermin, ROOT / "scripts" / "flow", *COMMANDS)
    assert code == 0, said


@pytest.mark.parametrize(
    "text, word",
    [
        ("from itertools import pairwise\n", "itertools.pairwise"),
        ("match 1:\n    case 1:\n        pass\n", "pattern matching"),
        ("print(list(zip([1], [2], strict=True)))\n", "zip(strict)"),
    ],
)
def test_what_is_newer_is_found(vermin, tmp_path, text, word):
    (tmp_path / "new.py").write_text(text)
    code, said = newer(vermin, tmp_path / "new.py")
    assert code != 0 and word in said, said
