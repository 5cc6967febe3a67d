# SPDX-License-Identifier: Apache-2.0
"""Tools that say they are done and have done nothing, simulations that have lost their program, VHDL whose manifest was
made to fit: none of them is a pass."""

import json
import os
import stat
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

from cover import with_slow
from flow.base import committed
from flow.base.farm import Farm
from flow.base.tools import find_ghdl
from flow.cosim.job import _simulations
from flow.synthesis import manifest
from flow_commands import call, refused, report

ENDS = 'for a in "$@"; do case $a in -g{}_file=*) {}=${{a#*=}};; esac; done\n'


def stand_in(folder, does):
    """A GHDL that builds as it should, and instead of the simulation does something else."""
    program = folder / "ghdl"
    files = ENDS.format("stimulus", "stimulus") + ENDS.format("observed", "observed")
    program.write_text(f'#!/bin/sh\nif [ "$1" = -r ]; then\n{files}{does}\nexit 0\nfi\nexec {find_ghdl()} "$@"\n')
    program.chmod(0o755)
    return {"GHDL": str(program)}


RARE = "tiny_ties"  # whose simulations no other test has, or the same ones


def cosim_tiny(out, *options, environment=None, config="tiny"):
    return call("cosim.py", "--config", config, "--out", out, *options, environment=environment)


def test_a_simulator_that_does_nothing(ghdl, tmp_path):
    process = cosim_tiny(tmp_path / "out", environment=stand_in(tmp_path, ":"))
    refused(process, 4, "ghdl ended with exit code 0 but has simulated nothing")
    assert xml.parse(tmp_path / "out" / "junit.xml").getroot().find("testcase/error") is not None


@pytest.mark.parametrize("stimulus", ["stress", "scene"])
def test_a_simulator_that_writes_only_its_last_line(ghdl, tmp_path, stimulus):
    last_line = 'echo "end $(($(wc -l < "$stimulus") - 1))" > "$observed"'
    process = cosim_tiny(tmp_path / "out", "--stimulus", stimulus, environment=stand_in(tmp_path, last_line))
    assert process.returncode == 1 and "Traceback" not in process.stderr, process.stderr
    result = report(tmp_path / "out")
    assert result["compared"] == 0 < result["mismatches"] == result["expected"]


def test_an_expectation_of_nothing(ghdl, tmp_path):
    (tmp_path / "stimulus.txt").write_text("stereo-hls stimulus 2 config=tiny pixels=1 clocks=2\n0 00 00\n0 00 00\n")
    (tmp_path / "expected.txt").write_text(
        "stereo-hls expected 2 config=tiny pixels=1 disparity_bits=8 outputs=0 latency=16\n"
    )
    words = ["--stimulus", tmp_path / "stimulus.txt", "--expected", tmp_path / "expected.txt"]
    refused(cosim_tiny(tmp_path / "out", *words), 2, "expected.txt has no outputs", "nothing to compare")


def kept_simulations(name):
    return sorted((_simulations() / name).glob("*/built"), key=lambda path: path.stat().st_mtime)


DAMAGES = [(simulator, damage) for simulator in ("ghdl", "verilator") for damage in ("empty", "gone", "no x bit")]


@pytest.mark.parametrize("simulator, damage", with_slow(DAMAGES, [*DAMAGES[:3], ("verilator", "no x bit")]))
def test_a_damaged_simulation_is_built_again(request, tmp_path, simulator, damage):
    request.getfixturevalue(simulator)
    options = ["--simulator", simulator, "--stimulus", "scene"]
    assert cosim_tiny(tmp_path, *options, config=RARE).returncode == 0
    made = max(kept_simulations(f"{RARE}-{simulator}"), key=os.path.getmtime)
    programs = [made.parent / name for name in json.loads(made.read_text()) if not name.startswith("sources/")]
    runnable = [path for path in programs if path.stat().st_mode & stat.S_IXUSR] or programs
    target = max(runnable, key=lambda path: path.stat().st_size)
    if damage == "empty":
        target.write_bytes(b"")
    elif damage == "gone":
        target.unlink()
    else:
        target.chmod(0o600)
    assert cosim_tiny(tmp_path, *options, config=RARE).returncode == 0
    assert report(tmp_path)["is_cached"] is False
    assert cosim_tiny(tmp_path, *options, config=RARE).returncode == 0
    assert report(tmp_path)["is_cached"] is True


def copy_of(folder, edit):
    """The VHDL of tiny, edited."""
    folder.mkdir()
    for path in committed.folder("tiny").iterdir():
        (folder / path.name).write_bytes(path.read_bytes())
    core = folder / "stereo_core_tiny.vhd"
    core.write_text(edit(core.read_text()))
    return folder


def inverted(text):
    return text.replace("if rows_ready_tag.valid then", "if not rows_ready_tag.valid then", 1)


@pytest.mark.parametrize("keeps_seal", [True, False])
def test_edited_vhdl_with_an_edited_digest(ghdl, tmp_path, keeps_seal):
    """The seal does not fit any more; with a new seal, the structure does not."""
    folder = copy_of(tmp_path / "tiny", inverted)
    entry = json.loads((folder / "manifest.json").read_text())
    entry["files"] = {"stereo_core_tiny.vhd": manifest.digest(folder / "stereo_core_tiny.vhd")}
    if keeps_seal:
        (folder / "manifest.json").write_text(json.dumps(entry))
    else:
        manifest.write(folder, entry)
    said = "manifest.json was edited" if keeps_seal else "is not the design that was made"
    refused(cosim_tiny(tmp_path / "out", "--rtl", folder), 2, said, "--allow-edited")
    process = cosim_tiny(tmp_path / "out", "--rtl", folder, "--allow-edited")
    assert process.returncode == 1 and "EDITED" in process.stdout


def test_a_damaged_manifest_is_a_change(ghdl, tmp_path, monkeypatch):
    from flow.cosim import regression

    made = regression.Regression(["tiny"], "ghdl", [], [], tmp_path, Farm(1))
    before = made._digest("tiny")
    copy = copy_of(tmp_path / "tiny", lambda text: text)
    monkeypatch.setattr(committed, "folder", lambda config: Path(copy))
    assert made._digest("tiny") == before
    (copy / "manifest.json").write_text("{}")
    assert made._digest("tiny") != before
