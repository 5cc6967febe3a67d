# SPDX-License-Identifier: Apache-2.0
"""What is printed of a system's results."""

from __future__ import annotations

from ..base.configurations import clocks_per_pixel
from ..implementation import figures, job
from . import pipeline, record
from .template import System


def of_record(system: System) -> list[str]:
    """All that is recorded and fresh."""
    found = record.read(system)
    if found is None:
        return [f"{system.entity}: nothing recorded of this design"]
    lines: list[str] = []
    for target, result in found.get("implementation", {}).items():
        lines += job.area_and_clock(system.entity, target, result)
        if "fmax_mhz" in result:
            core = pipeline.rows_of(system)[1]
            mhz = result["fmax_mhz"]["median"]
            lines.append(f"  {figures.frames_per_second(core, mhz):.1f} frames a second at most")
            if clocks_per_pixel(core) > 1:
                lines.append(of_cameras(system, mhz))
    if "frame" in found:
        lines += of_frame(system, found["frame"])
    if "streams" in found:
        lines.append(of_streams(system, found["streams"]))
    return lines


def of_cameras(system: System, mhz: float) -> str:
    """What the cameras of a system may send at most."""
    line, pause = pipeline.line_clocks(system), pipeline.pause_clocks(system)
    frames = mhz * 1e6 / (line * pipeline.rows_of(system)[1]["height_px"] + pause)
    return f"  {frames:.1f} with a line in {line} clocks and {pause} clocks, {pause / line:.1f} lines, between frames"


def of_frame(system: System, seen: record.Frame) -> list[str]:
    line_clocks = pipeline.line_clocks(system)
    filled = f"{seen['filled']} filled, " if "filled" in seen else ""
    lines = [
        f"{system.entity}, {seen['scene']}: {seen['depths']} depths, {seen['known']} of them known, {filled}"
        f"{seen['mismatches']} mismatches, {seen['clocks']} clocks"
    ]
    mhz = routed_mhz(system)
    for which, clocks in (("first", seen["latency"]["first_clocks"]), ("last", seen["latency"]["last_clocks"])):
        at_clock = f", {clocks / mhz:.1f} us at {mhz} MHz" if mhz else ""
        took = f"{clocks} clocks, {clocks / line_clocks:.2f} lines{at_clock}"
        lines.append(f"  from a row's last pixel to its {which} depth: {took}")
    return lines


def of_streams(system: System, played: record.Streams) -> str:
    return (
        f"{system.entity}: {played['frames']} frames sent, {played['broken']} of them broken, {played['exact']} exact, "
        f"{played['mismatches']} mismatches, {played['hangs']} hangs"
    )


def routed_mhz(system: System) -> float | None:
    """Of the recorded place and route, where there is one of this design."""
    found = record.read(system)
    for result in found.get("implementation", {}).values() if found else ():
        if "fmax_mhz" in result:
            return float(result["fmax_mhz"]["median"])
    return None
