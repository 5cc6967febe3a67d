# SPDX-License-Identifier: Apache-2.0
"""The FPGA families beside ECP5: what each of them adds to the flow, with stand-ins for the tools and, for the area of
`tiny`, with yosys."""

import json
import re
import shutil

import pytest

import implementation_stand_ins as stand_ins
from conftest import where_reachable
from cover import with_slow
from flow.base import committed, ghdl as ghdl_flow, rtl, venv
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.implementation import nextpnr, pins, record, yosys
from flow.implementation.families.ecp5 import Ecp5FewPins
from flow.implementation.families.family import TOP, RoutedFamily
from flow.implementation.results import Configuration
from flow.implementation.targets import ECP5, TARGETS
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars
from flow_commands import call, refused

TINY = committed.folder("tiny").relative_to(ROOT)
ROUTED = {t.family.name: t.family for t in TARGETS.values() if isinstance(t.family, RoutedFamily)}
OTHERS = {name: family for name, family in ROUTED.items() if family is not ECP5}
# {target: (cells of the core, LUTs in them, cells around it, nextpnr's utilization, LUT sites, words of its command)}
CASES = {
    "gw2ar_18": (
        {"LUT2": 1, "LUT4": 2, "ALU": 4, "MUX2_LUT5": 8, "RAM16SDP4": 2, "DFFRE": 3, "SDPX9B": 1},
        1 + 2 + 4 + 12,
        {"LUT2": 5, "DFF": 9},
        {"LUT4": 20, "ALU": 6, "RAM16SDP4": 2, "MUX2_LUT5": 8},
        20 + 6 + 12,
        ("--device GW2AR-LV18QN88C8/I7", "--vopt family=GW2A-18C", "--vopt cst=constraints.txt", "--router router1"),
    ),
    "up5k": (
        {"SB_LUT4": 11, "SB_CARRY": 5, "SB_DFFESR": 3, "SB_RAM40_4K": 1},
        11,
        {"SB_LUT4": 5, "SB_DFF": 9},
        {"ICESTORM_LC": 30, "ICESTORM_RAM": 1},
        30,
        ("--up5k", "--package sg48", "--pcf-allow-unconstrained"),
    ),
    "lifcl_40": (
        {"LUT4": 11, "INV": 1, "CCU2": 2, "WIDEFN9": 1, "DPR16X4": 1, "FD1P3IX": 3, "PDPSC16K": 1},
        11 + 1 + 4 + 2 + 6,
        {"LUT4": 5, "FD1P3IX": 9},
        {"OXIDE_COMB": 30, "OXIDE_FF": 12},
        30,
        ("--device LIFCL-40-9BG400C", "--pdc constraints.txt"),
    ),
    "ccgm1a1": (
        {"CC_LUT1": 1, "CC_L2T4": 2, "CC_ADDF": 3, "CC_MX2": 1, "CC_MX4": 1, "CC_DFF": 3, "CC_BRAM_20K": 1},
        1 + 2 + 3 + 1 + 2,
        {"CC_LUT2": 5, "CC_DFF": 9},
        {"CPE_LT": 20, "CPE_ADDF2": 4, "CPE_FF": 12, "CPE_CPLINES": 7, "CPE_RAMIO": 8},
        24,
        ("--device CCGM1A1", "--vopt allow-unconstrained", "--router router2"),
    ),
}


@pytest.fixture
def build(tmp_path, monkeypatch):
    """A flow of its own, as in test_implement_command.py."""
    project = tmp_path / "project"
    shutil.copytree(ROOT / "scripts", project / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(committed.folder("tiny"), project / TINY)
    (project / TINY / "implementation.json").unlink(missing_ok=True)
    shutil.copytree(rtl.HAND_WRITTEN, project / "hls" / "rtl")
    monkeypatch.setattr("flow_commands.ROOT", project)
    return project


def run(tools, target, nextpnr_body=None, **of_yosys):
    cells, _, around, utilization, _, _ = CASES[target]
    family = TARGETS[target].family
    register = next(cell for cell in cells if cell.startswith(family.ffs))
    netlist = stand_ins.netlist(register, pins.ENTITY, f"{pins.CORE}.")
    used = {cell: {"used": count, "available": 9999} for cell, count in utilization.items()}
    names = ("a_DFFLC", "b_DFFLC") if family.name == "ice40" else "ab"
    environment = stand_ins.environment(
        tools,
        stand_ins.yosys_body(**{"cells": cells, "around": around, "netlist": netlist} | of_yosys),
        nextpnr_body or stand_ins.nextpnr_body({1: 50.5}, utilization=used, cells=names),
        family=family.name,
    )
    return call("implement.py", "--config", "tiny", "--target", target, "--seeds", 1, environment=environment)


def result_of(project, target):
    return json.loads((project / TINY / "implementation.json").read_text())["targets"][target]


@pytest.mark.parametrize("target", CASES)
def test_a_device_of_each_family(build, tmp_path, target):
    cells, luts, _, _, sites, words = CASES[target]
    tools, family = tmp_path / "tools", TARGETS[target].family
    process = run(tools, target)
    assert process.returncode == 0, process.stderr
    result = result_of(build, target)
    assert (result["luts"], result["ffs"], result["block_rams"]) == (luts, 3, 1)
    assert result["around"] == {"luts": 5, "ffs": 9}, "is not the core's"
    assert (result["lut_sites"], result["device"]) == (sites, TARGETS[target].device)
    assert result["cells"] == cells and result["synthesis"].endswith(f"-top {pins.ENTITY}")
    assert result["critical_path"] == {"from": "raster_left", "to": "slice0cost_column_0", "block": "slice0cost"}
    assert f"on {target}: {luts} {family.lut_name}, 3 flip-flops" in process.stdout
    (routed,) = (line for line in stand_ins.calls(tools, family.variable.lower()) if "--seed" in line)
    assert all(word in routed for word in words), routed
    assert not [word for word in routed.split() if word.startswith("/")], "it may see other folders"
    work = build / "build/implementation/stereo_core_tiny" / family.name
    assert f"module {pins.ENTITY}" in (work / f"{TOP}.v").read_text()
    bound = work / target / nextpnr.CONSTRAINTS
    assert bound.is_file() == bool(TARGETS[target].pins)
    assert all(pin in bound.read_text() for pin in TARGETS[target].pins)


def test_other_pins_are_another_result(tmp_path, monkeypatch):
    """They are in a file, which is no option."""
    monkeypatch.setattr(nextpnr, "KEPT", tmp_path / "kept")
    (tmp_path / "netlist.json").write_text("{}")
    used = {cell: {"used": 1, "available": 2} for cell in ("LUT4", "ALU", "RAM16SDP4")}
    routed = []

    def stand_in(command, cwd, log):
        routed.append((cwd / nextpnr.CONSTRAINTS).read_text())
        (cwd / "report_1.json").write_text(json.dumps(stand_ins.report(50.0, used)))

    monkeypatch.setattr(nextpnr, "run", stand_in)
    device = TARGETS["gw2ar_18"]
    other = type(device)(device.name, device.family, device.device, device.options, ("9", "8", "7"))
    for target in (device, device, other):
        nextpnr.route("nextpnr", "of a test", target, 1, tmp_path / "netlist.json", tmp_path)
    assert len(routed) == 2 and 'IO_LOC "clock" 9;' in routed[1]


def test_a_device_with_too_few_block_rams(build, tmp_path):
    log = "Info: \t        ICESTORM_RAM:      33/     30   110%\nERROR: Unable to place cell"
    body = f"case \"$*\" in --version) echo '(Version nextpnr-0.0)' >&2;; *) echo '{log}' >&2; exit 125;; esac"
    process = run(tmp_path / "tools", "up5k", body)
    assert process.returncode == 0, process.stderr
    assert "does not fit on iCE40UP5K-SG48: 33 of 30 block RAMs" in process.stdout
    assert result_of(build, "up5k")["does_not_fit"] == {"ICESTORM_RAM": {"used": 33, "available": 30}}


def memory(name, bits):
    return f"  cell $mem_v2 \\{name}\n    parameter \\SIZE {bits}\n    parameter \\WIDTH 1\n"


LARGEST = [("up5k", 256), ("gw2ar_18", 0), ("ccgm1a1", 256), ("lifcl_40", 0)]


@pytest.mark.parametrize("target, most", with_slow(LARGEST, LARGEST[:2]))
def test_only_small_memories_become_flip_flops(build, tmp_path, target, most):
    large = memory("rows", 5120)
    if most:
        small = memory("ring", most)
        process = run(tmp_path / "small", target, memory=small + large, lost=small)
        assert process.returncode == 0, process.stderr
        result = result_of(build, target)
        assert (result["memory_bits"], result["small_memory_bits"]) == (5120, most)
        assert result["memory_in_flip_flops"] is False
    lost = memory("ring", most + 1)
    process = run(tmp_path / "larger", target, memory=lost + large, lost=lost)
    refused(process, 1, f"a memory became flip-flops instead of RAM: ring on {target}")
    assert result_of(build, target)["memory_in_flip_flops"] is True


def test_a_flip_flop_behind_a_look_up_table_is_in_its_logic_cell():
    lut = {"type": "SB_LUT4", "port_directions": {"O": "output"}, "connections": {"O": [15]}}
    module = stand_ins.netlist("SB_DFFE", cells={"lut": lut})["modules"][TOP]
    assert TARGETS["up5k"].family.registers(module) == {"a_DFFLC": 5, "lut_LC": 5, "b_DFFLC": 6}


def test_chains_begin_with_an_open_carry():
    cells = {
        "zero": {"type": "VLO", "connections": {"Z": [9]}},
        "first": {"type": "CCU2", "connections": {"CIN": [9], "COUT": [7]}},
        "second": {"type": "CCU2", "connections": {"CIN": [7], "COUT": [8]}},
        "constant": {"type": "CCU2", "connections": {"CIN": ["0"]}},
        "one": {"type": "CCU2", "connections": {"CIN": ["1"]}},
    }
    TARGETS["lifcl_40"].family.improve({"cells": cells})
    carries = {name: cell["connections"]["CIN"] for name, cell in cells.items() if name != "zero"}
    assert carries == {"first": [], "second": [7], "constant": [], "one": ["1"]}


PORTS = "(input  clock,\n   input  [7:0] left,\n   input  valid,\n   output [6:0] disparity,\n   output last);"


def test_registers_around_a_core():
    text = pins.around(f"module {TOP}\n  {PORTS}\n  wire n1;\nendmodule\n")
    for words in (".clock(clock)", ".left(given[7:0])", ".valid(given[8:8])", ".disparity(taken[6:0])"):
        assert words in text
    assert ".last(taken[7:7])" in text and "reg [8:0] given" in text and "scan_out = added[7]" in text


@pytest.mark.parametrize("lost", ["input  clock,", "output [6:0] disparity,\n   output last", "module"])
def test_a_core_whose_ports_cannot_be_read_is_refused(lost):
    with pytest.raises(FlowError, match="has no clock, inputs and outputs"):
        pins.around(
            f"module {TOP}\n  {PORTS}\nendmodule\n".replace(lost, "input  other" if "module" not in lost else "")
        )


def test_the_clock_of_the_shell_is_known():
    assert ".aclk(clock)" in pins.around(f"module {TOP}\n  {PORTS}\n".replace("clock", "aclk"))


@pytest.mark.parametrize("family", ROUTED.values(), ids=ROUTED)
def test_each_family_pins_its_own_tool(family):
    """Of the same release as that of ECP5. A user of one family installs no other one."""
    line = venv.pinned(family.requirements, family.package)
    assert line.split("==")[1] == venv.pinned(ECP5.requirements, ECP5.package).split("==")[1]
    named = re.findall(r"^yowasp\S+==", family.requirements.read_text(), re.MULTILINE)
    assert named == [f"{family.package}=="]
    assert len({other.environment for other in ROUTED.values()}) == len(ROUTED)


def test_nothing_else_knows_a_family_by_name():
    """A new family is a class and a row; for plan.py also the shapes of its RAM."""
    known = re.compile(rf"\b({'|'.join([*OTHERS, *(f.package for f in OTHERS.values())])})\b", re.IGNORECASE)
    files = [*(ROOT / "scripts").glob("*.py"), *(ROOT / "scripts" / "flow").rglob("*.py")]
    knowing = {path.name for path in files if known.search(path.read_text())}
    assert knowing == {f"{name}.py" for name in OTHERS} | {"targets.py", "ram.py"}


FEW_PINS = {**OTHERS, "ecp5": Ecp5FewPins()}


@pytest.mark.parametrize("family", FEW_PINS.values(), ids=FEW_PINS)
def test_a_core_is_the_same_with_registers_around_it(tmp_path, family):
    """Its cells are those that yosys makes of it alone."""
    where_reachable(yosys.find_yosys)
    alone = type("Alone", (type(family),), {"few_pins": False, "buffers": ""})()
    ports = "(input clock, input [7:0] left, input valid, output [7:0] disparity)"
    body = "assign disparity = {left[0] & valid, 7'd0};"
    verilog = f"module {TOP} {ports};\n{body}\nendmodule\n"
    found = []
    for number, one in enumerate((family, alone)):
        work = tmp_path / str(number)
        work.mkdir()
        found.append(yosys.synthesize(one, verilog, work).area)
    assert found[0] == found[1] and found[0]["luts"] > 0


def test_a_core_that_is_mixed_with_its_registers_is_not_counted(tmp_path, monkeypatch):
    where_reachable(yosys.find_yosys)
    script = yosys.script
    monkeypatch.setattr(yosys, "script", lambda *given: script(*given).replace("-set keep_hierarchy 1", "-set none 1"))
    ports = "(input clock, input [7:0] left, input valid, output [7:0] disparity)"
    with pytest.raises(FlowError, match="no usable statistics"):
        yosys.synthesize(
            TARGETS["up5k"].family, f"module {TOP} {ports};\nassign disparity = left;\nendmodule\n", tmp_path
        )


def kept(config, target):
    return record.read(committed.folder(config))["targets"].get(target)


def test_the_paper_s_system_is_routed_on_each_device():
    """And on the smallest one faster than cameras are."""
    devices = [target for target in TARGETS.values() if target.family in OTHERS.values()]
    assert all("fmax_mhz" in kept("ambrosch2007_f10", target.name) for target in devices)
    assert Configuration("ambrosch2007_f5").clock("up5k")["frames_per_second"] >= 60


def test_semi_global_matching_is_routed_where_nextpnr_ends():
    """30 frames a second or more; where it does not fit, the record says what is too small."""
    for name in ("gw2ar_18", "lifcl_40"):
        assert Configuration("sgm_320_64_f16").clock(name)["frames_per_second"] >= 30
    assert Configuration("sgm_320_32_f16").clock("gw1nr_9")["frames_per_second"] >= 30
    assert all("does_not_fit" in kept("sgm_320_64_f16", name) for name in ("up5k", "hx8k"))
    assert Configuration("sgm_512_64_f16").clock("gw2ar_18")["frames_per_second"] >= 30
    assert "does_not_fit" in kept("sgm_640_64_f8_road", "gw2ar_18"), "the page says so"


@pytest.mark.parametrize("target", with_slow([target for target in CASES if kept("tiny", target)], ["up5k"]))
def test_yosys_gives_the_committed_area_of_tiny(ghdl, tmp_path, target):
    where_reachable(yosys.find_yosys)
    family, expected = TARGETS[target].family, kept("tiny", target)
    entity = committed.entity("tiny")
    files = scalars.files(manifest.vhdl_files(committed.folder("tiny")))  # of which records are
    verilog = ghdl_flow.to_verilog(files, tmp_path, entity)
    verilog = re.sub(rf"\bmodule {entity}\b", f"module {TOP}", verilog)
    made = yosys.synthesize(family, verilog, tmp_path, yosys.memories_without_bypass({"family": "block_matching"}))
    tools = {"ghdl": ghdl_flow.version(), "yosys": yosys.version()}
    if tools != {name: expected["tools"][name] for name in tools}:
        pytest.skip(f"SKIP: the committed numbers are of {expected['tools']}, installed are {tools}")
    assert made.area == {name: expected[name] for name in made.area} and not made.lost
    assert made.around == expected["around"]
    # Each bit of an input has a register, each bit of an output two.
    ports = re.search(rf"module {TOP}\s*\((.*?)\);", verilog, re.DOTALL)[1]
    bits = dict.fromkeys(("input", "output"), 0)
    for side, high in re.findall(r"(input|output)\s+(?:\[(\d+):0\])?", ports):
        bits[side] += int(high or 0) + 1
    assert made.around["ffs"] == bits["input"] - 1 + 2 * bits["output"]
