# SPDX-License-Identifier: Apache-2.0
"""What a co-simulation gave: report.json, junit.xml and the lines on the terminal."""

import xml.etree.ElementTree as xml
from pathlib import Path
from typing import NotRequired, TypedDict

from .checker import Interval


class Report(TypedDict):
    """report.json"""

    config: str
    command: str  # that runs it again
    simulator: str
    rows: str | None
    stall_percent: int
    seed: int
    passed: bool
    expected: int
    compared: int
    mismatches: int
    first_mismatch: str | None
    frames: int
    clocks: int
    clocks_per_frame: int | None
    initiation_interval: Interval | None
    latency_clocks: int | None
    clocks_per_second: float
    build_seconds: float
    simulation_seconds: float
    wave: NotRequired[str]  # the file that --wave asked for
    wave_clocks: NotRequired[tuple[int, int]]  # first and last in failure.vcd


def summary(report: Report) -> str:
    interval = report["initiation_interval"]
    text = [
        f"{'PASS' if report['passed'] else 'FAIL'}: {report['config']} in {report['simulator']}: "
        f"{report['compared']} of {report['expected']} outputs compared, {report['mismatches']} mismatches"
    ]
    if report["first_mismatch"]:
        text.append(f"  first mismatch: {report['first_mismatch']}")
    if interval:
        text.append(
            f"  initiation interval min/avg/max {interval['min']}/{interval['avg']:.2f}/{interval['max']} clocks"
        )
    if report["latency_clocks"] is not None:
        text.append(f"  latency {report['latency_clocks']} clocks from a window's last pixel pair to its disparity")
    if report["clocks_per_frame"]:
        text.append(f"  {report['clocks_per_frame']} clocks a frame")
    text.append(
        f"  {report['clocks']} clocks in {report['simulation_seconds']} s "
        f"({report['clocks_per_second']:.0f} clocks/s), built in {report['build_seconds']} s"
    )
    if "wave" in report:
        text.append(f"  waveform: {report['wave']}")
    return "\n".join(text)


def write_junit(path: Path, report: Report, seconds: float) -> None:
    name, time = f"cosim.{report['simulator']}", f"{seconds:.3f}"
    failures = "0" if report["passed"] else "1"
    suite = xml.Element("testsuite", name="cosim", tests="1", failures=failures, time=time)
    case = xml.SubElement(suite, "testcase", classname=name, name=report["config"], time=time)
    if not report["passed"]:
        message = report["first_mismatch"] or "nothing was compared"
        xml.SubElement(case, "failure", message=message).text = summary(report)
    xml.ElementTree(suite).write(path, encoding="utf-8", xml_declaration=True)
