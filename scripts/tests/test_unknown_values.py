# SPDX-License-Identifier: Apache-2.0
"""What is not known stays where it does not count: at outputs from the reset on, in numbers while inputs are idle, and
in a simulator of four values."""

import os
import re
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT, need, where_reachable
from cover import with_slow
from flow.base import ghdl as ghdl_flow, venv
from flow.shell import design
from flow.simulation.simulation import Simulation
from flow.simulation.simulators import Design, Icarus

BENCHES = ROOT / "hls_tb" / "shell"
TRAFFIC = BENCHES / "idle_traffic.vhd"
FRAMES, MAP_PX = 3, 24 * 12


def altered(folder, *changes):
    """The files of stereo_ip_tiny. `changes`: (file, text, instead)."""
    files = []
    for path in design.vhdl_files("tiny"):
        text = path.read_text()
        for _, old, new in (change for change in changes if change[0] == path.stem):
            assert old in text
            text = text.replace(old, new)
        files.append(folder / path.name)
        files[-1].write_text(text)
    return files


def warnings_of_idle_inputs(ghdl, work, files):
    """How often a number is made of what is not known while three frames pass."""
    ghdl_flow.analyse([*files, TRAFFIC, BENCHES / "tb_idle_inputs.vhd"], work)
    ghdl_flow.elaborate(work, "tb_idle_inputs")
    process = subprocess.run(
        [ghdl, "-r", ghdl_flow.STANDARD, "tb_idle_inputs"], cwd=work, capture_output=True, text=True
    )
    said = process.stdout + process.stderr
    assert process.returncode == 0 and f"idle_traffic passed: {FRAMES} frames" in said, said
    return said.count("metavalue detected")


def test_idle_inputs_become_no_numbers(ghdl, tmp_path):
    assert warnings_of_idle_inputs(ghdl, tmp_path, design.vhdl_files("tiny")) == 0


def test_a_number_of_an_idle_input_is_noticed(ghdl, tmp_path):
    """Two fences stand before it: the shell keeps the last group, and the core takes bits."""
    passes = ("stereo_framing", "if in_valid = '1' then\n        out_data", "if true then\n        out_data")
    takes = ("stereo_core_tiny", "to_stdlogicvector(to_bitvector(left_pixel))", "left_pixel")
    assert warnings_of_idle_inputs(ghdl, tmp_path, altered(tmp_path, passes, takes)) > 100


@pytest.fixture(scope="module")
def vunit():
    requirements = ROOT / "scripts" / "requirements-vunit.txt"
    return where_reachable(lambda: venv.ensure("venv-vunit", requirements, "VUnit"))


def under_vunit(vunit, ghdl, work, files):
    environment = {**os.environ, "VUNIT_SIMULATOR": "ghdl", "VUNIT_GHDL_PATH": str(Path(ghdl).resolve().parent)}
    if Path(ghdl).name != "ghdl":  # VUnit asks for a program of this name
        (work / "bin").mkdir()
        (work / "bin" / "ghdl").symlink_to(Path(ghdl).resolve())
        environment["VUNIT_GHDL_PATH"] = str(work / "bin")
    command = [vunit / "python3", BENCHES / "run_vunit.py", "--no-color", "--output-path", work / "vunit", "--vhdl"]
    command += [*files, TRAFFIC, BENCHES / "tb_stream_protocol.vhd"]
    return subprocess.run(command, cwd=work, capture_output=True, text=True, env=environment)


def test_maps_keep_the_protocol(ghdl, vunit, tmp_path):
    process = under_vunit(vunit, ghdl, tmp_path, design.vhdl_files("tiny"))
    assert process.returncode == 0 and "pass 1 of 1" in process.stdout, process.stdout + process.stderr


FAULTS = {  # the rule that is broken: (file, text, instead)
    "rule 10": ("stream_fifo", " := (others => '0')\n", "\n"),
    "rule 1": ("stream_fifo", "(shows = '0' or out_ready = '1')", "true"),
}


@pytest.mark.parametrize("rule", with_slow(FAULTS, ["rule 1"]))
def test_a_broken_rule_is_noticed(ghdl, vunit, tmp_path, rule):
    process = under_vunit(vunit, ghdl, tmp_path, altered(tmp_path, FAULTS[rule]))
    assert process.returncode != 0 and f"m_axis:{rule}" in process.stdout, process.stdout + process.stderr


def unknown_in_four_values(work, files):
    """(disparities, unknown ones, clocks with unknown flags) of GHDL's Verilog in Icarus."""
    need("iverilog")
    design_with_bench = Design("stereo_ip_tiny", files, [BENCHES / "tb_unknown.v"])
    simulation, said = Simulation(Icarus(), design_with_bench, work / "icarus"), []
    simulation.build()
    simulation.run_bench({}, 60, said.append)
    found = re.search(r"(\d+) disparities, (\d+) unknown, (\d+) clocks with unknown flags", "\n".join(said))
    assert found, said
    return tuple(map(int, found.groups()))


@pytest.mark.xfail(strict=True, reason="the registers of a core have no start values: 72 of 864")
def test_nothing_is_unknown_for_ever(ghdl, tmp_path):
    assert unknown_in_four_values(tmp_path, design.vhdl_files("tiny")) == (FRAMES * MAP_PX, 0, 0)


def test_a_memory_without_start_values_is_noticed(ghdl, tmp_path):
    change = ("line_memory", "signal memory : words := (others => (others => '0'));", "signal memory : words;")
    assert unknown_in_four_values(tmp_path, altered(tmp_path, change))[1] > FRAMES * MAP_PX / 2
