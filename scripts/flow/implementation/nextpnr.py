# SPDX-License-Identifier: Apache-2.0
"""Clock after place and route, by the nextpnr of a family from PyPI, in a virtual environment of the project's own."""

from __future__ import annotations

import hashlib
import json
import os
import re
import statistics
from pathlib import Path
from typing import Any

from ..base import files, venv
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Say, Word, find_tool, run
from . import pins, yosys
from .families.family import RoutedFamily
from .record import CriticalPath, Fill, Routed
from .targets import Target

FREQUENCY_MHZ = 150  # what the router aims at; it may miss it
# The first one gives shorter clocks. In large designs it may circle for hours around a few nets; the other one ends.
ROUTERS = ("router1", "router2")
CONSTRAINTS = "constraints.txt"
KEPT = ROOT / "build" / "implementation" / "kept"  # reports of nextpnr, by what they are of

Report = dict[str, Any]  # as nextpnr writes it


class DoesNotFitError(FlowError):
    """The device has too few of these cells."""

    def __init__(self, cells: dict[str, Fill], error: FlowError) -> None:
        super().__init__(str(error), error.exit_code)
        self.cells = cells


def find_nextpnr(family: RoutedFamily, say: Say = print) -> str:
    """That of the family: NEXTPNR_FAMILY if set, else the pinned one, which is installed when it is not there yet."""
    if os.environ.get(family.variable):
        return find_tool(family.tool, family.variable)
    return str(venv.ensure(family.environment, family.requirements, family.package, say) / family.package)


def version(family: RoutedFamily, nextpnr: str, work: Path) -> str:
    log = work / "version.txt"
    run([nextpnr, "--version"], log=log)
    match = re.search(r"Version (\S+?)\)", log.read_text())
    if not match:
        raise FlowError(f"{nextpnr} --version prints no version of nextpnr", EXIT_TOOL_FAILED)
    name = match.group(1)
    if os.environ.get(family.variable):
        return name
    return f"{name} ({venv.pinned(family.requirements, family.package)})"


def route(
    nextpnr: str, tool_version: str, target: Target, seed: int, netlist: Path, work: Path, router: str = ROUTERS[0]
) -> Report:
    """Places and routes a netlist in the folder `work` with one seed. Returns nextpnr's report, that of an earlier run
    where all that it depends on is the same: a seed may take an hour, and a run of several may break off. Raises
    DoesNotFitError where the device is too small."""
    family = target.family
    assert isinstance(family, RoutedFamily)
    report, log = work / f"report_{seed}.json", work / f"nextpnr_{seed}.log"
    options: list[Word] = [*target.options, *family.options, "--timing-allow-fail", "--seed", seed]
    options += ["--freq", FREQUENCY_MHZ, "--router", router]
    constraints = family.constraints(target.pins)
    if constraints:
        (work / CONSTRAINTS).write_text(constraints)
        options += family.constraint_options(CONSTRAINTS)
    content = constraints.encode() + netlist.read_bytes().replace(os.fsencode(ROOT), b"")  # it names files of yosys
    inputs = json.dumps([tool_version, [str(option) for option in options]]).encode() + content
    kept = KEPT / f"{hashlib.sha256(inputs).hexdigest()}.json"
    if kept.is_file():
        return check(family, json.loads(kept.read_text()))
    try:
        # Relative: that of PyPI is WebAssembly with a folder /tmp of its own, and sees nothing of the machine's.
        files_of_run: list[Word] = ["--json", os.path.relpath(netlist, work), "--report", report.name]
        run([nextpnr, *options, *files_of_run], cwd=work, log=log)
    except FlowError as error:
        if cells := overfull(log.read_text()):
            raise DoesNotFitError(cells, error) from None
        raise
    try:
        found = check(family, json.loads(report.read_text()))
    except (OSError, ValueError, KeyError) as error:
        raise FlowError(f"nextpnr wrote no usable report ({error}); see {log}", EXIT_TOOL_FAILED) from None
    files.write(kept, report.read_bytes())
    return found


def overfull(log: str) -> dict[str, Fill]:
    """The cells of which nextpnr's log counts more than the device has."""
    lines = re.findall(r"^Info:\s+(\w+):\s+(\d+)/\s*(\d+)\s+\d+%$", log, re.MULTILINE)
    return {
        cell: {"used": int(used), "available": int(available)}
        for cell, used, available in lines
        if int(used) > int(available)
    }


def check(family: RoutedFamily, report: Report) -> Report:
    """The report, if it has what is read from it."""
    if len(report["fmax"]) != 1:
        raise ValueError(f"{len(report['fmax'])} clocks instead of 1")
    family.lut_sites(report["utilization"])
    return report


def fmax_mhz(report: Report) -> float:
    achieved: float = next(iter(report["fmax"].values()))["achieved"]
    return round(achieved, 2)


def clocks(family: RoutedFamily, reports: dict[int, Report], names: dict[str, str]) -> Routed:
    """What goes into implementation.json, from {seed: report}."""
    by_seed = {seed: fmax_mhz(report) for seed, report in reports.items()}
    typical = sorted(by_seed, key=lambda seed: by_seed[seed])[(len(by_seed) - 1) // 2]
    return {
        "seeds": sorted(by_seed),
        "fmax_mhz": {
            "median": round(statistics.median(by_seed.values()), 2),
            "best": max(by_seed.values()),
            "by_seed": {str(seed): value for seed, value in sorted(by_seed.items())},
        },
        "lut_sites": family.lut_sites(reports[typical]["utilization"]),
        "critical_path": critical_path(reports[typical], names),
    }


def register_names(family: RoutedFamily, verilog: str, netlist: dict[str, Any]) -> dict[str, str]:
    """{cell as nextpnr names it: register of the VHDL that it holds}, with the instances above it.

    yosys names a flip-flop after any wire that it drives, so the way back goes over its output: ghdl's Verilog says
    `assign NAME = n123_q` for each register of the VHDL, `assign n124_o = NAME`, `{30'b0, NAME}` or `NAME[3]` where it
    is read, and the netlist still knows the bits of one of these wires.
    """
    module = netlist["modules"][yosys.top(family)]
    instance = f"{pins.CORE}." if family.few_pins else ""
    named = {register: name for name, register in re.findall(r"^  assign (\w+) = (n\d+_q);", verilog, re.MULTILINE)}
    reader = r"^  assign (n\d+_o) = (?:\{\d+'b0, )?(\w+)(?:\[[\d:]+\])?\}?;"
    registers = set(named.values())
    named |= {wire: name for wire, name in re.findall(reader, verilog, re.MULTILINE) if name in registers}
    wires = module["netnames"]
    owner: dict[int | str, str] = {}
    for wire, content in wires.items():
        path, dot, last = wire.rpartition(".")
        if last in named:
            name = path + dot + named[last]
            for bit in [*wires.get(name, {"bits": []})["bits"], *content["bits"]]:
                owner.setdefault(bit, name)
    # Where yosys kept the register's own name only.
    for wire, content in wires.items():
        if wire.rpartition(".")[2] in registers:
            for bit in content["bits"]:
                owner.setdefault(bit, wire)
    flip_flops = family.registers(module)
    return {name: owner[bit].removeprefix(instance) for name, bit in flip_flops.items() if bit in owner}


def critical_path(report: Report, names: dict[str, str]) -> CriticalPath:
    """{from, to, block} of the slowest path between registers, with the VHDL's names."""
    for path in report["critical_paths"]:
        if path["from"] == path["to"] and path["path"]:
            first, last = (vhdl_name(path["path"][i][side]["cell"], names) for i, side in ((0, "from"), (-1, "to")))
            return {"from": first, "to": last, "block": last.split("_")[0]}
    return {"from": "unknown", "to": "unknown", "block": "unknown"}


def vhdl_name(cell: str, names: dict[str, str]) -> str:
    """The register or memory of the VHDL that a cell of the netlist belongs to."""
    instance, dot, _ = cell.removeprefix(f"{pins.CORE}.").partition(".")
    return names.get(cell) or (instance if dot else "unknown")
