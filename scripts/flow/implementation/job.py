# SPDX-License-Identifier: Apache-2.0
"""Implementation: VHDL to area on each FPGA family and, where a router is free, to a clock; into
implementation.json."""

import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

from ..base import ghdl, rtl
from ..base.configurations import Parameters
from ..base.errors import EXIT_MISMATCH, EXIT_OK, FlowError
from ..base.tools import ROOT
from ..synthesis import manifest
from . import figures, nextpnr, record, yosys

WORK = ROOT / "build" / "implementation"


@dataclass(frozen=True)
class Job:
    config: str
    vhdl: Path  # folder with manifest.json and VHDL
    out: Path  # folder for implementation.json
    targets: list[str]
    seeds: list[int]


def check_writable(out: Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create {out}: {error.strerror}") from None


def implement_target(
    job: Job, target: yosys.Target, vhdl: list[Path], progress: Progress
) -> tuple[record.Result, list[str]]:
    """Area and, where there is a router, clock on one family. Returns (result, memories that became flip-flops)."""
    work = WORK / job.config / target.name
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    router = nextpnr.find_nextpnr(progress.console.print) if target.device else None
    seeds = job.seeds if target.device else []
    task = progress.add_task("", total=2 + len(seeds))

    def stage(name: str, done: int) -> None:
        progress.update(task, description=f"{job.config} {target.name}: {name}", completed=done)

    stage("ghdl --synth", 0)
    entity = rtl.core_entity(job.config)
    verilog = re.sub(rf"\bmodule {entity}\b", f"module {yosys.TOP}", ghdl.to_verilog(vhdl, work, entity))
    stage("yosys", 1)
    area, lost = yosys.synthesize(target, verilog, work)
    tools = {"ghdl": ghdl.version(), "yosys": yosys.version()}
    result: record.Result = {**area, "synthesis": target.synthesis, "tools": tools}
    if router is not None and target.device is not None:
        reports = {}
        for number, seed in enumerate(seeds):
            stage(f"nextpnr, seed {seed}", 2 + number)
            reports[seed] = nextpnr.route(router, seed, work)
        tools["nextpnr"] = nextpnr.version(router, work)
        names = nextpnr.register_names(verilog, json.loads((work / "netlist.json").read_text()))
        result |= {"device": target.device, "target_mhz": nextpnr.FREQUENCY_MHZ, **nextpnr.clocks(reports, names)}
    stage("done", 2 + len(seeds))
    return result, lost


def run_job(job: Job) -> int:
    """Implements one configuration on its targets. Returns the exit code."""
    vhdl, entry = manifest.vhdl_files(job.vhdl), manifest.read(job.vhdl)
    check_writable(job.out)
    all_lost = []
    columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, TextColumn("steps"), TimeElapsedColumn()) as bar:
        for name in job.targets:
            result, lost = implement_target(job, yosys.TARGETS[name], vhdl, bar)
            record.merge(job.out, entry, name, result)
            bar.console.print(summary(job.config, name, entry["parameters"], result), highlight=False, soft_wrap=True)
            all_lost += [f"{memory} on {name}" for memory in lost]
    if all_lost:
        raise FlowError(
            f"{job.config}: a memory became flip-flops instead of RAM: {', '.join(all_lost)}", EXIT_MISMATCH
        )
    return EXIT_OK


def summary(config: str, target: str, parameters: Parameters, result: record.Result) -> str:
    luts, name = figures.lut_count(result), yosys.TARGETS[target].lut_name
    text = [
        f"{config} on {target}: {luts} {name}, {result['ffs']} flip-flops, {result['memory_bits']} memory bits in "
        f"{result['block_rams']} block RAMs and LUT RAM",
        f"  {figures.clocks_per_frame(parameters)} clocks a frame, "
        f"{figures.evaluations_per_clock(parameters):g} disparity evaluations a clock",
    ]
    if "fmax_mhz" in result:
        fmax, path = result["fmax_mhz"], result["critical_path"]
        seeds = ", ".join(f"{seed}: {mhz}" for seed, mhz in fmax["by_seed"].items())
        speed = figures.speed(parameters, fmax["median"], luts)
        text += [
            f"  {fmax['median']} MHz routed (median of seeds {seeds}) on {result['device']}, "
            f"{result['lut_sites']} LUT sites",
            f"  slowest path: {path['from']} to {path['to']}, block {path['block']}",
            f"  {speed['frames_per_second']:.1f} frames a second, "
            f"{speed['mde_per_second']:.0f} million disparity evaluations a second, "
            f"{speed['evaluations_per_second_per_lut'] / 1e3:.0f} thousand evaluations a second per LUT",
        ]
    return "\n".join(text)
