# SPDX-License-Identifier: Apache-2.0
"""Implementation: VHDL to area on each FPGA family and, where a router is free, to a clock; into
implementation.json."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ..base import committed, files, ghdl, progress, rtl
from ..base.configurations import Parameters
from ..base.errors import EXIT_MISMATCH, EXIT_OK, FlowError
from ..base.tools import ROOT
from ..shell import design
from ..synthesis import manifest
from ..synthesis.presentation import scalars
from . import figures, nextpnr, record, yosys
from .families.family import TOP, RoutedFamily
from .targets import TARGETS, Target

WORK = ROOT / "build" / "implementation"


@dataclass(frozen=True)
class Design:
    """What goes through the tools."""

    entity: str
    files: list[Path]  # in compile order
    seeds: list[int]
    router: str | None  # None: that of the family
    without_bypass: str  # of yosys.script


@dataclass(frozen=True)
class Job:
    config: str
    vhdl: Path  # folder with manifest.json and VHDL
    out: Path | None  # folder for implementation.json; None: beside the committed VHDL
    targets: list[str]
    seeds: list[int]
    shell: bool = False  # stereo_ip_CONFIG instead of the core alone
    router: str | None = None

    @property
    def entity(self) -> str:
        return rtl.ip_entity(self.config) if self.shell else committed.entity(self.config)

    def design(self) -> Design:
        files = design.vhdl_files(self.config) if self.shell else manifest.vhdl_files(self.vhdl)
        without_bypass = yosys.memories_without_bypass(manifest.read(self.vhdl)["parameters"])
        return Design(self.entity, scalars.files(files), self.seeds, self.router, without_bypass)


@dataclass(frozen=True)
class Netlist:
    """What yosys made for a family: the same for each of its devices."""

    work: Path  # with netlist.json
    area: record.Area
    lost: list[str]  # memories that became flip-flops
    around: dict[str, int]  # as yosys.Synthesis has it
    names: dict[str, str]  # of registers


def tools() -> dict[str, str]:
    """{name: version}"""
    return {"ghdl": ghdl.version(), "yosys": yosys.version()}


def check_writable(out: Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create {out}: {error.strerror}") from None


def synthesize(job: Design, target: Target, stage: Callable[[str], None]) -> Netlist:
    family = target.family
    work = WORK / job.entity / family.name
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    stage("ghdl --synth")
    verilog = re.sub(rf"\bmodule {job.entity}\b", f"module {TOP}", ghdl.to_verilog(job.files, work, job.entity))
    stage("yosys")
    made = yosys.synthesize(family, verilog, work, job.without_bypass)
    names = {}
    if isinstance(family, RoutedFamily):
        names = nextpnr.register_names(family, verilog, json.loads((work / "netlist.json").read_text()))
    return Netlist(work, made.area, made.lost, made.around, names)


def implement_target(job: Design, target: Target, made: dict[str, Netlist]) -> tuple[record.Result, list[str]]:
    """Area and, where there is a router, clock on one target. `made`: the netlists of the families so far. Returns
    (result, memories that became flip-flops)."""
    steps = 2 + (len(job.seeds) if target.device else 0)
    with progress.bar(f"{job.entity} {target.name}", steps, "steps") as bar:
        return _implement(job, target, made, bar)


def _implement(
    job: Design, target: Target, made: dict[str, Netlist], bar: progress.Bar
) -> tuple[record.Result, list[str]]:
    family = target.family
    tool = nextpnr.find_nextpnr(family, bar.say) if isinstance(family, RoutedFamily) else None
    seeds = job.seeds if tool else []
    begun: list[str] = []

    def stage(name: str) -> None:
        begun.append(name)
        bar.show(len(begun), f"{job.entity} {target.name}: {name}")

    if family.name not in made:
        made[family.name] = synthesize(job, target, stage)
    netlist = made[family.name]
    versions = tools()
    result: record.Result = {**netlist.area, "synthesis": yosys.command(family), "tools": versions}
    if isinstance(family, RoutedFamily) and tool is not None and target.device is not None:
        work = netlist.work / target.name
        work.mkdir()
        reports = {}
        router = job.router or family.router
        versions["nextpnr"] = nextpnr.version(family, tool, work)
        result["device"] = target.device
        if netlist.around:
            result["around"] = netlist.around
        try:
            for seed in seeds:
                stage(f"nextpnr, seed {seed}")
                reports[seed] = nextpnr.route(
                    tool, versions["nextpnr"], target, seed, netlist.work / "netlist.json", work, router
                )
        except nextpnr.DoesNotFitError as error:
            result["does_not_fit"] = error.cells
        else:
            routed = nextpnr.clocks(family, reports, netlist.names)
            result |= {"target_mhz": nextpnr.FREQUENCY_MHZ, "router": router, **routed}
    bar.show(2 + len(seeds), f"{job.entity} {target.name}: done")
    return result, netlist.lost


def checked_manifest(job: Job) -> manifest.Manifest:
    """That of the job's VHDL, which must be that of its configuration, as it was made."""
    entry = manifest.read(job.vhdl)
    if entry["configuration"] != job.config:
        raise FlowError(f"{job.vhdl} holds the VHDL of {entry['configuration']}, not of {job.config}")
    manifest.vhdl_files(job.vhdl)
    return entry


def run_job(job: Job) -> int:
    """Implements one configuration on its targets. Returns the exit code."""
    entry = checked_manifest(job)
    if job.out is not None:
        check_writable(job.out)
    all_lost: list[str] = []
    made: dict[str, Netlist] = {}
    shell = design.digests() if job.shell else None
    for name in job.targets:
        result, lost = implement_target(job.design(), TARGETS[name], made)
        _keep(job, entry, name, result, shell)
        print(summary(job.entity, name, entry["parameters"], result), flush=True)
        all_lost += [f"{memory} on {name}" for memory in lost]
    if all_lost:
        raise FlowError(
            f"{job.config}: a memory became flip-flops instead of RAM: {', '.join(all_lost)}", EXIT_MISMATCH
        )
    return EXIT_OK


def _keep(
    job: Job, entry: manifest.Manifest, target: str, result: record.Result, shell: manifest.Digests | None
) -> None:
    if job.out is not None:
        files.write(job.out / record.FILE, record.merged(job.out, entry, target, result, shell))
        return
    text = record.merged(committed.folder(job.config), entry, target, result, shell)
    committed.keep([manifest.change(entry, {record.FILE: text})])


def summary(entity: str, target: str, parameters: Parameters, result: record.Result) -> str:
    matches = not rtl.is_stage(parameters)  # a stage has no disparities
    evaluations = f", {figures.evaluations_per_clock(parameters):g} disparity evaluations a clock" if matches else ""
    text = area_and_clock(entity, target, result)
    text.insert(1, f"  {figures.clocks_per_frame(parameters)} clocks a frame{evaluations}")
    if "fmax_mhz" in result:
        fmax = result["fmax_mhz"]["median"]
        text.append(f"  {figures.frames_per_second(parameters, fmax):.1f} frames a second")
        if matches:
            speed = figures.speed(parameters, fmax, figures.lut_count(result))
            text[-1] += (
                f", {speed['mde_per_second']:.0f} million disparity evaluations a second, "
                f"{speed['evaluations_per_second_per_lut'] / 1e3:.0f} thousand evaluations a second per LUT"
            )
    return "\n".join(text)


def area_and_clock(entity: str, target: str, result: record.Result) -> list[str]:
    """Lines of a summary that any design has."""
    family = TARGETS[target].family
    lut_ram = "" if family.most_bits_in_flip_flops else " and LUT RAM"
    text = [
        f"{entity} on {target}: {figures.lut_count(result)} {family.lut_name}, {result['ffs']} flip-flops, "
        f"{result['memory_bits']} memory bits in {result['block_rams']} block RAMs{lut_ram}"
    ]
    if "does_not_fit" in result:
        text.append(f"  does not fit on {result['device']}: {figures.overfull(result['does_not_fit'])}")
    if "fmax_mhz" in result:
        fmax, path = result["fmax_mhz"], result["critical_path"]
        seeds = ", ".join(f"{seed}: {mhz}" for seed, mhz in fmax["by_seed"].items())
        of = figures.counted(len(fmax["by_seed"]), result.get("router"))
        text += [
            f"  {fmax['median']} MHz routed ({of}; by seed {seeds}) on "
            f"{result['device']}, {result['lut_sites']} LUT sites",
            f"  slowest path: {path['from']} to {path['to']}, block {path['block']}",
        ]
    return text
