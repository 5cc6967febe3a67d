# SPDX-License-Identifier: Apache-2.0
"""What a co-simulation gave: report.json, junit.xml and the lines on the terminal."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as xml
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypedDict

from ..base import files
from ..base.errors import EXIT_MISMATCH, EXIT_OK, FlowError
from ..base.facts import Facts, facts
from ..base.newer_python import NotRequired
from . import coverage
from .checker import Interval

_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


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
    is_cached: NotRequired[bool]  # the simulation was built by an earlier run, from the same contents
    edited: NotRequired[list[str]]  # VHDL that is not what its manifest says
    tools: NotRequired[dict[str, str]]  # {name: version}
    environment: NotRequired[Facts]
    coverage: NotRequired[coverage.Coverage]
    wave: NotRequired[str]  # the file that --wave asked for
    wave_clocks: NotRequired[tuple[int, int]]  # first and last in failure.vcd
    first_register: NotRequired[str]  # which register of the VHDL differs first from the C++ core's, and when
    first_registers: NotRequired[list[str]]  # all that do so in that clock


class Error(TypedDict):
    exit_code: int
    message: str


class Failure(TypedDict):
    """report.json of a co-simulation that came to no result."""

    config: str
    command: str
    simulator: str
    seed: int
    passed: bool  # False
    error: Error
    environment: Facts


def counts_agree(content: Mapping[str, Any]) -> bool:
    """What the counts of a report say, whatever its `passed` claims."""
    return bool(0 < content["expected"] == content["compared"] and content["mismatches"] == 0)


def judged(content: Mapping[str, Any]) -> int:
    """The exit code of a report: the counts and `passed` must both say that nothing differs."""
    return EXIT_OK if counts_agree(content) and content["passed"] else EXIT_MISMATCH


def summary(report: Report) -> str:
    interval = report["initiation_interval"]
    text = [
        f"{'PASS' if report['passed'] else 'FAIL'}: {report['config']} in {report['simulator']}: "
        f"{report['compared']} of {report['expected']} outputs compared, {report['mismatches']} mismatches"
    ]
    if report.get("edited"):
        text.append(f"  EDITED VHDL, not what its manifest says: {', '.join(report['edited'])}")
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
        f"({report['clocks_per_second']:.0f} clocks/s), "
        + ("simulation cached" if report.get("is_cached") else f"built in {report['build_seconds']} s")
    )
    if "coverage" in report:
        text += coverage.summary(report["coverage"])
    if "wave" in report:
        text.append(f"  waveform: {report['wave']}")
    return "\n".join(text)


def write(folder: Path, report: Report) -> None:
    """report.json and junit.xml"""
    files.write(folder / "report.json", json.dumps(report, indent=2) + "\n")
    files.write(folder / "junit.xml", junit([case_of(report)]))


def write_failure(folder: Path, config: str, command: str, simulator: str, seed: int, error: FlowError) -> None:
    """The same of a co-simulation that came to no result."""
    report: Failure = {
        "config": config,
        "command": command,
        "simulator": simulator,
        "seed": seed,
        "passed": False,
        "error": {"exit_code": error.exit_code, "message": str(error)},
        "environment": facts(),
    }
    files.write(folder / "report.json", json.dumps(report, indent=2) + "\n")
    files.write(folder / "junit.xml", junit([case_of_failure(report)]))


# --- JUnit ------------------------------------------------------------------------------------------------------------


def _case(config: str, simulator: str, seconds: float, properties: dict[str, object]) -> xml.Element:
    case = xml.Element("testcase", classname=f"cosim.{simulator}", name=config, time=f"{seconds:.3f}")
    entries = xml.SubElement(case, "properties")
    for name, value in properties.items():
        if value is not None:
            xml.SubElement(entries, "property", name=name, value=str(value))
    return case


def case_of(report: Report) -> xml.Element:
    properties: dict[str, object] = {key: report.get(key) for key in ("command", "seed", "compared", "clocks")}
    properties["edited"] = ", ".join(report.get("edited", [])) or None
    properties |= {f"tool.{name}": version for name, version in report.get("tools", {}).items()}
    case = _case(report["config"], report["simulator"], report["simulation_seconds"], properties)
    if not report["passed"]:
        message = report["first_mismatch"] or "nothing was compared"
        xml.SubElement(case, "failure", message=message).text = summary(report)
    return case


def case_of_failure(report: Failure) -> xml.Element:
    case = _case(report["config"], report["simulator"], 0, {"command": report["command"], "seed": report["seed"]})
    error = report["error"]
    xml.SubElement(case, "error", message=error["message"], type=f"exit code {error['exit_code']}")
    return case


def case_not_run(config: str, simulator: str, reason: str) -> xml.Element:
    case = _case(config, simulator, 0, {})
    xml.SubElement(case, "skipped", message=reason)
    return case


def junit(cases: list[xml.Element]) -> bytes:
    """A JUnit file of these cases; its numbers are counted from them."""
    counts = {tag + "s": str(sum(case.find(tag) is not None for case in cases)) for tag in ("failure", "error")}
    counts["skipped"] = str(sum(case.find("skipped") is not None for case in cases))
    seconds = sum(float(case.attrib["time"]) for case in cases)
    suite = xml.Element("testsuite", name="cosim", tests=str(len(cases)), time=f"{seconds:.3f}")
    suite.attrib.update(counts)
    properties = xml.SubElement(suite, "properties")
    for name, value in facts().items():
        xml.SubElement(properties, "property", name=name, value=str(value))
    suite.extend(cases)
    for element in suite.iter():  # a tool's message may hold colours, which no XML file can
        element.attrib.update({name: _NO_XML.sub("?", value) for name, value in element.items()})
        element.text = element.text and _NO_XML.sub("?", element.text)
    text: bytes = xml.tostring(suite, encoding="utf-8", xml_declaration=True)
    return text + b"\n"
