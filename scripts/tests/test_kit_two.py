# SPDX-License-Identifier: Apache-2.0
"""Two kits in one design: one library, one netlist in Verilog, one program."""

import re
import subprocess

import pytest

import kits
from conftest import need
from flow.base import ghdl as vhdl
from flow.base.tools import ROOT
from flow.kit import naming
from flow.shell import template
from flow.simulation.simulators import Design, Verilator

CONFIGURATIONS = ("tiny", "tiny_sgm")
BENCH = ROOT / "hls_tb" / "kit" / "two_cores_bench.cpp"
TOP = "two_cores"
SHARED = ("aclk", "aresetn")


@pytest.fixture
def pair(tmp_path):
    return [kits.make(tmp_path / config, "vivado", config) for config in CONFIGURATIONS]


def top(pair):
    """Both cores side by side: the ports of the first begin with a_, those of the second with b_."""
    ports, instances = dict.fromkeys(SHARED, "in std_logic"), []
    for letter, kit in zip("ab", pair):
        joined = {name: name if name in SHARED else f"{letter}_{name}" for name in kits.entity(kit.sources()[-1]).ports}
        for name, (way, bits) in kits.entity(kit.sources()[-1]).ports.items():
            kind = "std_logic" if bits is None else f"std_logic_vector({bits - 1} downto 0)"
            ports[joined[name]] = f"{way} {kind}"
        instances.append(template.instance(f"core_{letter}", kit.top, {}, joined))
    listed = ";\n".join(f"    {name} : {kind}" for name, kind in ports.items())
    return "\n".join(
        [
            f"library ieee;\nuse ieee.std_logic_1164.all;\nentity {TOP} is\n  port (\n{listed});\nend entity;",
            f"architecture rtl of {TOP} is\nbegin",
            *instances,
            "end architecture;\n",
        ]
    )


def design(pair, folder):
    """The files of one kit after the other, as two projects' scripts compile them into one library."""
    (folder / f"{TOP}.vhd").write_text(top(pair))
    return [path for kit in pair for path in kit.sources()] + [folder / f"{TOP}.vhd"]


def test_one_library(ghdl, pair, tmp_path):
    for path in design(pair, tmp_path):
        vhdl.analyse([path], tmp_path)
    vhdl.elaborate(tmp_path, TOP)
    units = [naming.units(path.read_text() for path in kit.sources()) for kit in pair]
    assert len(units[0]) == 14 and not units[0] & units[1]
    assert not {path.name for path in pair[0].sources()} & {path.name for path in pair[1].sources()}


def modules(kit, folder):
    """{name} in the Verilog that GHDL makes of a kit, and the file."""
    folder.mkdir()
    path = folder / f"{kit.top}.v"
    path.write_text(vhdl.to_verilog(kit.sources(), folder, kit.top))
    return set(re.findall(r"^module (\S+)", path.read_text(), re.MULTILINE)), path


def test_netlists_in_verilog(ghdl, yosys, pair, tmp_path):
    """Made one by one, then read together."""
    (first, a), (second, b) = (modules(kit, tmp_path / f"{kit.config}_v") for kit in pair)
    assert len(first) > 5 and not first & second
    read = subprocess.run(
        [yosys, "-q", "-p", f"read_verilog {a} {b}; hierarchy -check"], capture_output=True, text=True
    )
    assert read.returncode == 0, read.stdout + read.stderr


def drivers(pair, folder):
    """The object files of both, and the options of what includes their headers."""
    made = []
    for kit in pair:
        source = kit.folder / "software" / naming.of_c(kit.config, "stereo_driver.c")
        made.append(folder / f"{source.stem}.o")
        command = [need("gcc"), "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-c", source, "-o", made[-1]]
        subprocess.run(command, check=True)
    return made, [word for kit in pair for word in ("-CFLAGS", f"-I{kit.folder / 'software'}")]


@pytest.mark.slow
def test_one_program_drives_both(ghdl, verilator, pair, tmp_path):
    files, (objects, options) = design(pair, tmp_path), drivers(pair, tmp_path)
    Verilator().build(tmp_path, Design(TOP, files, [BENCH, *objects], options=options))
    bench = Verilator.program(tmp_path)
    process = subprocess.run([bench], capture_output=True, text=True)
    assert process.returncode == 0 and process.stdout == "0 wrong\n", process.stdout

    header = pair[0].folder / "software" / "stereo_tiny_registers.h"
    header.write_text(re.sub(r"(CORE_VALUE 0x)\w{8}", r"\g<1>00000000", header.read_text()))
    drivers(pair, tmp_path)
    bench.unlink()
    subprocess.run(["make", "-C", bench.parent, "-f", "Vdesign.mk"], check=True, capture_output=True)
    process = subprocess.run([bench], capture_output=True, text=True)
    assert process.returncode == 1 and "the first core is not its own" in process.stdout, process.stdout


def test_a_name_that_both_have_is_noticed(ghdl, pair, tmp_path):
    """The check itself: the files that the kits are made of."""
    for kit in pair:
        for path in kit.sources():
            path.write_text(re.sub(r"\b(\w+?)_(?:tiny_sgm|tiny)\b", r"\1", path.read_text()))
    assert naming.units(path.read_text() for path in pair[0].sources()) & naming.units(
        path.read_text() for path in pair[1].sources()
    )
