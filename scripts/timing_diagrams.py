#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the timing diagrams of docs/integration.md from a simulation of stereo_ip, configuration tiny."""

import json
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base import files
from flow.base.errors import EXIT_TOOL_FAILED, ArgumentParser, FlowError, run_command
from flow.base.tools import ROOT
from flow.shell import cocotb_runs, timing_diagrams as timing

IMAGES = ROOT / "docs" / "images"
LINES = (
    "s_axis_tvalid",
    "s_axis_tready",
    "s_axis_tuser",
    "s_axis_tlast",
    "m_axis_tvalid",
    "m_axis_tready",
    "m_axis_tlast",
)
WORDS = {"s_axis_tdata": "s_axis_tvalid", "m_axis_tdata": "m_axis_tvalid", "m_axis_tuser": "m_axis_tvalid"}
REGISTER_LINES = tuple(
    f"s_axil_{channel}{end}" for channel in ("aw", "w", "b", "ar", "r") for end in ("valid", "ready")
)
REGISTER_WORDS = {
    f"s_axil_{channel}{name}": f"s_axil_{channel}valid"
    for channel, name in (("aw", "addr"), ("w", "data"), ("ar", "addr"), ("r", "data"))
}


def first(rows, condition, start=0):
    return next(clock for clock in range(start, len(rows)) if condition(rows[clock]))


def windows(recordings):
    """{picture: (rows, first clock, last clock, lines, words)}"""
    start, pressure, broken, access = (
        recordings[name] for name in ("start_of_frame", "back_pressure", "broken_frame", "register_access")
    )
    begin = first(start, lambda row: row["s_axis_tvalid"] == "1" and row["s_axis_tuser"] == "1")
    out = first(pressure, lambda row: row["m_axis_tvalid"] == "1")
    frame = first(broken, lambda row: row["s_axis_tvalid"] == "1" and row["s_axis_tuser"] == "1")
    cut = first(broken, lambda row: row["s_axis_tvalid"] == "1" and row["s_axis_tuser"] == "1", frame + 2)
    error = first(broken, lambda row: row["m_axis_tvalid"] == "1" and row["m_axis_tuser"][0] == "1")
    write = first(access, lambda row: row["s_axil_awvalid"] == "1")
    inputs = tuple(name for name in LINES if name.startswith("s_axis")), {"s_axis_tdata": "s_axis_tvalid"}
    return {
        "axi_start_of_frame": (start, begin - 4, begin + 16, ("aresetn", *inputs[0]), inputs[1]),
        "axi_back_pressure": (pressure, out - 3, out + 14, LINES, WORDS),
        "axi_broken_frame": (broken, min(cut, error) - 4, min(cut, error) + 18, LINES, WORDS),
        "axi_registers": (access, write - 1, write + 14, REGISTER_LINES, REGISTER_WORDS),
    }


def record(out):
    out.mkdir(parents=True, exist_ok=True)
    os.environ["STEREO_AXI_DIAGRAMS"] = str(out)
    simulation = cocotb_runs.Ghdl("tiny", ROOT / "build" / "axi" / "ghdl" / "tiny")
    simulation.build()
    results = simulation.run("diagrams", 1, out)
    failed = [result for result in results if not result.passed]
    if failed:
        raise FlowError(f"the recording {failed[0].name} failed; see {failed[0].message}", EXIT_TOOL_FAILED)
    return {result.name: json.loads((out / f"{result.name}.json").read_text()) for result in results}


def main():
    parser = ArgumentParser(prog="timing_diagrams.py", description=__doc__)
    parser.add_argument(
        "--check",
        action="store_true",
        help="write nothing; exit code 1 when a picture is not what the simulation gives",
    )
    check = parser.parse_args().check
    pictures = {
        IMAGES / f"{name}.svg": timing.cut(*window)
        for name, window in windows(record(ROOT / "build" / "axi" / "diagrams")).items()
    }
    return files.update(pictures, check, "scripts/timing_diagrams.py")


if __name__ == "__main__":
    run_command(main)
