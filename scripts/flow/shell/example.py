# SPDX-License-Identifier: Apache-2.0
"""The example for an ECP5 board, from VHDL to a bit stream: `ghdl --synth`, yosys, nextpnr, ecppack."""

import json
import shutil
from pathlib import Path
from typing import TypedDict

from ..base import ghdl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Say, find_tool, find_yosys, run
from ..implementation import nextpnr
from ..implementation.targets import ECP5
from . import design

FOLDER = ROOT / "examples" / "ecp5"
SOURCES = ("pattern_source", "map_check", "example_top")
CONFIG = "tiny"
DEVICE_OPTIONS = ["--85k", "--package", "CABGA381", "--speed", "6"]  # the ULX3S board's LFE5U-85F-6BG381C
CLOCK_MHZ = 25


class Example(TypedDict):
    """What was made."""

    luts: int
    flip_flops: int
    fmax_mhz: float
    bit_stream: Path


def find_ecppack(router: str) -> str:
    """ecppack beside the router, as PyPI installs it, or in PATH."""
    beside = Path(router).with_name(Path(router).name.replace("nextpnr-ecp5", "ecppack"))
    return str(beside) if beside.is_file() else find_tool("ecppack", "ECPPACK", "on Debian: apt-get install prjtrellis")


def build(work: Path, seed: int = 1, say: Say = print) -> Example:
    """Makes example.bit in the folder `work`."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    router = nextpnr.find_nextpnr(ECP5, say)
    say("ghdl --synth ...")
    files = design.vhdl_files(CONFIG) + [FOLDER / f"{name}.vhd" for name in SOURCES]
    (work / "example_top.v").write_text(ghdl.to_verilog(files, work, "example_top"))
    say("yosys ...")
    script = "read_verilog example_top.v; synth_ecp5 -abc9 -top example_top -json netlist.json"
    run([find_yosys(), "-p", script], cwd=work, log=work / "yosys.log")
    say("nextpnr ...")
    shutil.copy(FOLDER / "ulx3s.lpf", work)
    files_in = ["--json", "netlist.json", "--lpf", "ulx3s.lpf"]
    files_out = ["--report", "report.json", "--textcfg", "example.config"]
    run([router, *DEVICE_OPTIONS, *files_in, "--seed", seed, *files_out], cwd=work, log=work / "nextpnr.log")
    run([find_ecppack(router), "example.config", "example.bit"], cwd=work, log=work / "ecppack.log")
    try:
        report = json.loads((work / "report.json").read_text())
        used = report["utilization"]
        return {
            "luts": used["TRELLIS_COMB"]["used"],
            "flip_flops": used["TRELLIS_FF"]["used"],
            "fmax_mhz": nextpnr.fmax_mhz(report),
            "bit_stream": work / "example.bit",
        }
    except (OSError, ValueError, KeyError) as error:
        raise FlowError(
            f"nextpnr wrote no usable report ({error}); see {work / 'nextpnr.log'}", EXIT_TOOL_FAILED
        ) from None
