# SPDX-License-Identifier: Apache-2.0
"""Where the project may stand: in a folder that its user may not write, under a name with blanks, owned by somebody
else."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from conftest import need
from flow.base import committed, facts, places
from flow.base.errors import FlowError
from flow.base.tools import ROOT, find_stereo_hls

NEEDED = ("scripts/flow", "scripts/cosim.py", "hls/rtl", "hls_tb/cosim")


@pytest.fixture
def program():
    try:
        return find_stereo_hls()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")


def tree(folder):
    """What a co-simulation of `tiny` reads of the project."""
    for name in (*NEEDED, committed.folder("tiny").relative_to(ROOT)):
        source = ROOT / name
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if source.is_dir() else shutil.copy)(source, folder / name)
    return folder


def cosim(folder, program, *words, before=(sys.executable,), **environment):
    command = [*before, folder / "scripts" / "cosim.py", "--config", "tiny", "--rows", "4", *words]
    variables = {**os.environ, "STEREO_HLS": program, "PYTHONDONTWRITEBYTECODE": "1", **environment}
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, env=variables)


@pytest.mark.parametrize("simulator", ["ghdl", "verilator"])
def test_a_name_with_blanks(program, ghdl, verilator, tmp_path, simulator):
    folder = tree(tmp_path / "two words" / "main")
    process = cosim(folder, program, "--simulator", simulator)
    assert process.returncode == 0 and "PASS" in process.stdout, process.stdout + process.stderr
    assert (folder / "build" / "cosim" / f"tiny-{simulator}" / "report.json").is_file()


@pytest.fixture
def as_nobody():
    """The words before a command that a user runs who may write nothing here."""
    if os.getuid() != 0 or shutil.which("setpriv") is None:
        pytest.skip("SKIP: needs root and setpriv")
    return ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]


@pytest.fixture
def open_folder():
    """That others reach: the folders of pytest are closed to others again whenever another pytest begins."""
    with tempfile.TemporaryDirectory() as name:
        yield Path(name)


def reachable(path):
    """For everybody, as /opt is."""
    for folder in [path, *path.parents]:
        if folder.stat().st_uid == os.getuid() and folder.stat().st_mode & 0o055 != 0o055:
            folder.chmod(folder.stat().st_mode | 0o055)


def python_of(as_nobody, program):
    """One that this user can start, as the program."""

    def starts(path):
        # From a process of that user: setpriv itself still may what root may.
        return subprocess.run([*as_nobody, "env", path, "--version"], capture_output=True).returncode == 0

    found = [path for path in (sys.executable, "/usr/bin/python3") if starts(path)]
    if not found or not starts(program):
        pytest.skip("SKIP: another user can start no Python here, or not the native program")
    return found[0]


def test_a_tree_that_cannot_be_written(program, ghdl, as_nobody, open_folder):
    before = [*as_nobody, python_of(as_nobody, program)]
    folder = tree(open_folder / "opt")
    reachable(folder)
    cache = open_folder / "cache"
    cache.mkdir()
    cache.chmod(0o777)
    files = sorted(folder.rglob("*"))
    for words in ([], ["--out", cache / "out"]):
        process = cosim(folder, program, *words, before=before, XDG_CACHE_HOME=str(cache))
        assert process.returncode == 0 and "PASS" in process.stdout, process.stdout + process.stderr
    assert sorted(folder.rglob("*")) == files
    reports = sorted(path.parent.name for path in cache.rglob("report.json"))
    assert reports == ["out", "tiny-ghdl"]
    process = cosim(folder, program, before=before, XDG_CACHE_HOME="", HOME="/nonexistent")
    assert process.returncode == 2 and process.stderr.count("\n") == 1, process.stderr
    assert "cannot be written" in process.stderr and "XDG_CACHE_HOME" in process.stderr


def test_the_folder_in_the_cache(tmp_path, monkeypatch):
    assert places.build_folder() == ROOT / "build"
    writable = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: not str(path).startswith(str(ROOT)) and writable(path, mode))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert places.build_folder().parent == tmp_path / "stereo_hls"
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    assert places.build_folder().parent == tmp_path / "home" / ".cache" / "stereo_hls"
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("HOME", str(tmp_path / "file"))
    places._cached.cache_clear()
    with pytest.raises(FlowError, match="XDG_CACHE_HOME"):
        places.build_folder()


def test_a_checkout_of_another_owner_says_why_there_is_no_commit(program, ghdl, as_nobody, open_folder):
    need("git")
    before = [*as_nobody, python_of(as_nobody, program)]
    folder = tree(open_folder / "tree")
    for words in (["init", "-q"], ["add", "scripts/cosim.py"]):
        subprocess.run(["git", "-C", folder, *words], check=True)
    reachable(folder)
    out = open_folder / "out"
    out.mkdir()
    out.chmod(0o777)
    process = cosim(folder, program, "--out", out, before=before, XDG_CACHE_HOME=str(out), HOME="/nonexistent")
    assert process.returncode == 0, process.stdout + process.stderr
    [said] = [json.loads((out / "report.json").read_text())["environment"]["commit"]]
    assert said.startswith("unknown: git says: ") and "dubious ownership" in said
    assert 'name="commit" value="unknown: git says' in (out / "junit.xml").read_text()


def test_no_git_is_a_reason(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert facts._commit() == "unknown: git is not installed"
