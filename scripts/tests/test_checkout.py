# SPDX-License-Identifier: Apache-2.0
"""What git keeps: the same bytes whatever it is told about line ends, as digests are of them, and nothing that a
program makes."""

import shutil
import subprocess

import pytest

from conftest import need
from flow.base.tools import ROOT

FOLDERS = ("generated_rtl/block_matching/tiny", "hls/rtl", "scripts", "hls_tb/fuzz/corpus")


def git(*words, folder=ROOT, **options):
    return subprocess.run(["git", "-C", folder, *map(str, words)], capture_output=True, **options)


@pytest.fixture
def checkout():
    need("git")
    if git("rev-parse", "--show-toplevel").stdout.strip().decode() != str(ROOT):
        pytest.skip("SKIP: this is no checkout of git")


def changed(source, tmp_path):
    """Files of the index of `source` that a checkout with `core.autocrlf` would change."""
    out = tmp_path / "out"
    names = git("ls-files", "-z", *FOLDERS, folder=source, check=True).stdout.decode().split("\0")[:-1]
    assert names
    words = ["-c", "core.autocrlf=true", "checkout-index", f"--prefix={out}/", "-z", "--stdin"]
    git(*words, folder=source, check=True, input="\0".join(names).encode())
    shown = git("cat-file", "--batch", folder=source, check=True, input="".join(f":{n}\n" for n in names).encode())
    return [name for name in names if (out / name).read_bytes() not in shown.stdout]


def test_no_line_end_changes(checkout, tmp_path):
    assert changed(ROOT, tmp_path) == []


def test_it_would_without_attributes(checkout, tmp_path):
    """The check itself: git does change a text that no attribute protects."""
    copy = tmp_path / "copy"
    shutil.copytree(ROOT / "hls" / "rtl", copy / "hls" / "rtl")
    git("init", "-q", folder=copy, check=True)
    git("add", ".", folder=copy, check=True)
    assert "hls/rtl/line_memory.vhd" in changed(copy, tmp_path)


def made_by_programs(names):
    """Compiled files and those of build folders, wherever a program was started."""
    return [name for name in names if name.endswith(".pyc") or {"build", "__pycache__"} & set(name.split("/")[:-1])]


def test_nothing_that_a_program_makes_is_kept(checkout):
    assert made_by_programs(["scripts/build/pycache/a.py", "a/__pycache__/b", "c.pyc", "scripts/build.py"]) == [
        "scripts/build/pycache/a.py",
        "a/__pycache__/b",
        "c.pyc",
    ]
    assert made_by_programs(git("ls-files", "-z", check=True).stdout.decode().split("\0")) == []
