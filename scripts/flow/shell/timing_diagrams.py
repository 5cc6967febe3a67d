# SPDX-License-Identifier: Apache-2.0
"""The timing diagrams of docs/integration.md, from a simulation of stereo_ip, configuration tiny."""

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT
from . import cocotb_runs, wave_svg

IMAGES = ROOT / "docs" / "images"
WORK = ROOT / "build" / "axi"
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


Recording = list[dict[str, str]]  # {signal: bits} of each clock


class Window(NamedTuple):
    """What one picture shows."""

    rows: Recording
    first: int
    last: int
    lines: tuple[str, ...]  # signals of one bit
    words: dict[str, str]  # {signal: the one whose '1' gives it a meaning}


def _first(rows: Recording, condition: Callable[[dict[str, str]], bool], start: int = 0) -> int:
    return next(clock for clock in range(start, len(rows)) if condition(rows[clock]))


def _starts(row: dict[str, str]) -> bool:
    return row["s_axis_tvalid"] == "1" and row["s_axis_tuser"] == "1"


def windows(recordings: dict[str, Recording]) -> dict[str, Window]:
    """By the name of the picture."""
    start, pressure, broken, access = (
        recordings[name] for name in ("start_of_frame", "back_pressure", "broken_frame", "register_access")
    )
    begin = _first(start, _starts)
    out = _first(pressure, lambda row: row["m_axis_tvalid"] == "1")
    frame = _first(broken, _starts)
    cut = _first(broken, _starts, frame + 2)
    error = _first(broken, lambda row: row["m_axis_tvalid"] == "1" and row["m_axis_tuser"][0] == "1")
    write = _first(access, lambda row: row["s_axil_awvalid"] == "1")
    inputs = tuple(name for name in LINES if name.startswith("s_axis"))
    input_words = {"s_axis_tdata": "s_axis_tvalid"}
    return {
        "axi_start_of_frame": Window(start, begin - 4, begin + 16, ("aresetn", *inputs), input_words),
        "axi_back_pressure": Window(pressure, out - 3, out + 14, LINES, WORDS),
        "axi_broken_frame": Window(broken, min(cut, error) - 4, min(cut, error) + 18, LINES, WORDS),
        "axi_registers": Window(access, write - 1, write + 14, REGISTER_LINES, REGISTER_WORDS),
    }


def record(out: Path) -> dict[str, Recording]:
    """What hls_tb/axi/diagrams.py writes down, by the name of its test."""
    out.mkdir(parents=True, exist_ok=True)
    os.environ["STEREO_AXI_DIAGRAMS"] = str(out)
    simulation = cocotb_runs.Ghdl("tiny", WORK / "ghdl")
    simulation.build()
    results = simulation.run("diagrams", 1, out)
    failed = [result for result in results if not result.passed]
    if failed:
        raise FlowError(f"the recording {failed[0].name} failed; see {failed[0].message}", EXIT_TOOL_FAILED)
    return {result.name: json.loads((out / f"{result.name}.json").read_text()) for result in results}


def made_files() -> dict[Path, str]:
    """{path: text that belongs there}"""
    return {
        IMAGES / f"{name}.svg": wave_svg.cut(*window) for name, window in windows(record(WORK / "diagrams")).items()
    }
