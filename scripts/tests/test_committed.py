# SPDX-License-Identifier: Apache-2.0
"""The VHDL of configurations in folders and in archives: found, kept, moved, and refused where it is damaged."""

import subprocess
import sys

import pytest

from flow.base import archive, committed
from flow.base.errors import FlowError
from flow.base.tools import ROOT

FILES = {"one/a.vhd": b"entity a\n" * 100, "two/b.json": b"{}"}
MANIFEST = {committed.MANIFEST: "{}"}


@pytest.fixture
def places(tmp_path, monkeypatch):
    """Empty ones: (folders, archives)"""
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path / "generated_rtl")
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    monkeypatch.setattr(committed, "build_folder", lambda: tmp_path / "build")
    return committed.GENERATED_RTL, committed.EVIDENCE


def content(config):
    return {path.name: path.read_text() for path in committed.folder(config).iterdir()}


def test_the_same_files_are_the_same_bytes(tmp_path):
    archive.write(tmp_path / "a", FILES)
    archive.write(tmp_path / "b", dict(reversed(FILES.items())))
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    assert archive.read(tmp_path / "a") == FILES


def test_the_use_decides_the_place(places):
    folders, archives = places
    committed.keep([committed.Change("family", "taken", "system", MANIFEST)])
    committed.keep([committed.Change("family", name, "option", MANIFEST | {"n": name}) for name in ("x", "y")])
    assert [path.parent.name for path in folders.rglob("*.json")] == ["taken"]
    assert [path.name for path in archives.iterdir()] == ["family.tar.xz"]
    assert committed.known_designs() == ["taken", "x", "y"]
    assert content("x") == {**MANIFEST, "n": "x"} and committed.folder("x").parent.name == "family"
    assert committed.folder("taken") == folders / "family" / "taken"


def test_a_file_is_replaced_and_the_others_stay(places):
    for contents in (MANIFEST | {"a": "1", "b": "1"}, {"a": "2"}):
        committed.keep([committed.Change("family", "x", "option", contents)])
    assert content("x") == {**MANIFEST, "a": "2", "b": "1"}


@pytest.mark.parametrize("uses", [("option", "system"), ("system", "option")])
def test_another_use_moves_all_files(places, uses):
    committed.keep([committed.Change("family", "x", uses[0], MANIFEST | {"a": "1", "b": "1"})])
    committed.keep([committed.Change("family", "x", uses[1], {"a": "2"})])
    assert content("x") == {**MANIFEST, "a": "2", "b": "1"} and committed.known_designs() == ["x"]
    assert committed.folder("x").is_relative_to(committed.GENERATED_RTL) == (uses[1] == "system")


def test_what_is_not_there_is_said(places):
    with pytest.raises(FlowError, match="no generated VHDL for 'nonsense'"):
        committed.folder("nonsense")


def damaged(tmp_path, name):
    path = tmp_path / name
    archive.write(path, FILES)
    return path


def test_damage_is_said(tmp_path):
    path = damaged(tmp_path, "broken_off")
    path.write_bytes(path.read_bytes()[:-20])
    with pytest.raises(FlowError, match="^damaged "):
        archive.read(path)
    for name in ("../up/a", "a", "/root/a", "a/b/c"):
        archive.write(path, {name: b""})
        with pytest.raises(FlowError, match="something other than FOLDER/FILE"):
            archive.read(path)
    with pytest.raises(FlowError, match="^cannot read "):
        archive.read(tmp_path / "nowhere")


def test_two_that_keep_at_once_lose_nothing(places, tmp_path):
    """Processes, as those of a farm."""
    code = """
import sys
sys.path.insert(0, sys.argv[1])
from pathlib import Path
from flow.base import committed
committed.GENERATED_RTL, committed.EVIDENCE = Path(sys.argv[2]) / "generated_rtl", Path(sys.argv[2]) / "evidence"
for number in range(10):
    committed.keep([committed.Change("family", f"{sys.argv[3]}{number}", "option", {"manifest.json": "{}"})])
"""
    words = [sys.executable, "-c", code, ROOT / "scripts", tmp_path]
    processes = [subprocess.Popen([*words, name]) for name in ("x", "y")]
    assert [process.wait() for process in processes] == [0, 0]
    assert len(committed.known_designs()) == 20
