# SPDX-License-Identifier: Apache-2.0
"""All VHDL that goes into a user's design is valid as VHDL-93 and as VHDL-2008 and elaborates in both. Benches are
VHDL-2008."""

import shutil

import pytest

import kits
from cover import simulated, with_slow
from flow.base import committed, ghdl as ghdl_flow, rtl
from flow.base.configurations import designs
from flow.base.errors import FlowError
from flow.release import user_vhdl
from flow.shell import board_vhdl, design
from flow.system import template as systems
from flow_commands import call, refused

STANDARDS = ("--std=93", "--std=08")
TABLE = designs()


def those(in_short):
    """Configurations: all, or what people take, the parts of the systems, and as few others as have
    every option."""
    made = committed.known_designs()
    parts = {name for system in systems.SYSTEMS.values() for name in (system.rectification, system.matching)}
    wanted = simulated() | parts
    short = [name for name in made if name in wanted or TABLE[name]["use"] in committed.TAKEN]
    return short if in_short else made


def test_no_file_is_forgotten():
    folders = [committed.GENERATED_RTL, rtl.HAND_WRITTEN, systems.FOLDER, board_vhdl.FOLDER]
    folders += map(committed.folder, committed.known_designs())
    there = {file for folder in folders for file in folder.rglob("*.vhd") if not file.name.startswith("tb_")}
    assert there == set(user_vhdl.files(those(in_short=False)))


# All other tests take VHDL-2008.
CASES = [(standard, in_short) for standard in STANDARDS for in_short in (True, False)]


@pytest.mark.parametrize("standard, in_short", with_slow(CASES, CASES[:1]))
def test_every_file_compiles_and_every_design_elaborates(ghdl, tmp_path, standard, in_short):
    names = those(in_short)
    ghdl_flow.analyse(user_vhdl.files(names), tmp_path, standard=standard)
    tops = user_vhdl.tops(names)
    assert len(tops) > 2 * len(user_vhdl.with_shell(names)) > 80
    for top in tops:
        ghdl_flow.elaborate(tmp_path, top, standard)


@pytest.mark.parametrize("kit", kits.KITS)
@pytest.mark.parametrize("standard", with_slow(STANDARDS, STANDARDS[:1]))
def test_a_kit(ghdl, tmp_path, kit, standard):
    made = kits.make(tmp_path / "kit", kit, "tiny_size_all")
    ghdl_flow.analyse(made.sources(), tmp_path, standard=standard)
    ghdl_flow.elaborate(tmp_path, made.top, standard)


FAULTS = {  # (standard that does not have it, file, text, instead)
    "a conditional assignment in a process": (
        "--std=93",
        "stream_fifo",
        "      waits <= '0';\n",
        "      waits <= '1' when leaves else '0';\n",
    ),
    "a process that waits for all": ("--std=93", "stream_fifo", "process (clock)", "process (all)"),
    "a reduction": ("--std=93", "stereo_axis", "not core_in_reset(1)", "not (or core_in_reset)"),
    "an output that is read": ("--std=93", "stream_fifo", "waits = '1' and (shows", "waits = '1' and (out_valid"),
    "an expression in a port map": (
        "--std=93",
        "stereo_axis",
        "start_slot => start_slot",
        "start_slot => not entering",
    ),
    "a name that VHDL-2008 reserves": ("--std=08", "stream_fifo", "leaves", "force"),
    "a part that is nowhere": ("--std=93", "stereo_axis", "entity work.stream_fifo", "entity work.stream_queue"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_is_found(ghdl, tmp_path, fault):
    standard, name, old, new = FAULTS[fault]
    for file in design.shell_files():
        shutil.copy(file, tmp_path)
    ghdl_flow.analyse(design.shell_files(tmp_path), tmp_path, standard=standard)
    text = (tmp_path / f"{name}.vhd").read_text()
    assert old in text
    (tmp_path / f"{name}.vhd").write_text(text.replace(old, new))
    with pytest.raises(FlowError, match=f"{name}.vhd"):
        ghdl_flow.analyse(design.shell_files(tmp_path), tmp_path, standard=standard)


@pytest.mark.slow
@pytest.mark.parametrize("way", user_vhdl.WAYS["nvc"], ids=lambda way: way.standard)
def test_nvc_takes_every_design(nvc, tmp_path, way):
    """The largest core needs more memory than NVC gives by itself."""
    assert user_vhdl.refusals(way, committed.known_designs(), tmp_path / "work", 2) == {}


def test_command_counts_what_a_tool_takes(ghdl, tmp_path):
    said = call("try_tools.py", "--config", "tiny", "--out", tmp_path / "out")
    assert said.returncode == 0, said.stderr
    assert said.stdout.count(": 4 of 4 designs\n") == len(said.stdout.splitlines()) == 3
    without_the_example = call("try_tools.py", "--config", "tiny_p2", "--out", tmp_path / "out")
    assert without_the_example.stdout.count(": 3 of 3 designs\n") == 3, without_the_example.stderr
    refused(call("try_tools.py", "--config", "nobody"), 2, "nobody")


def test_design_that_a_tool_refuses_is_named(ghdl, tmp_path, monkeypatch):
    made = user_vhdl.tops(["tiny"])
    monkeypatch.setattr(user_vhdl, "tops", lambda names: [*made, "nobody"])
    found = user_vhdl.refusals(user_vhdl.Elaborated("--std=93"), ["tiny"], tmp_path / "work", 2)
    assert list(found) == ["nobody"] and "nobody" in found["nobody"]
