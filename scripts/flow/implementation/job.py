# SPDX-License-Identifier: Apache-2.0
"""Implementation: VHDL to area on each FPGA family and, where a router is free, to a clock; into implementation.json."""

import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

from ..base import files, json_files
from ..base.errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.tools import GENERATED_RTL, ROOT, find_ghdl, run
from ..cosim.simulators import to_verilog
from ..synthesis import manifest
from . import figures, nextpnr, yosys

WORK = ROOT / "build" / "implementation"
FORMAT = "stereo-hls implementation 1"
FILE = "implementation.json"


@dataclass(frozen=True)
class Job:
    config: str
    rtl: Path  # folder with manifest.json and VHDL
    out: Path  # folder for implementation.json
    targets: list
    seeds: list


def known_configurations():
    """The folders with a manifest. Some may lack the VHDL, which the repository does not keep of all."""
    return sorted(path.parent.name for path in GENERATED_RTL.glob("*/manifest.json"))


def has_vhdl(name):
    return all((GENERATED_RTL / name / file).is_file() for file in manifest.read(GENERATED_RTL / name)["files"])


def read(directory):
    """implementation.json of a folder, or None when there is none."""
    path = Path(directory) / FILE
    result = json_files.load_result(path, FORMAT)
    if result is not None and not all(isinstance(result.get(key), dict) for key in ("targets", "vhdl_digest")):
        raise json_files.damaged(path, FORMAT)
    return result


def is_fresh(result, entry):
    """Whether a result was made from the VHDL that the manifest `entry` describes."""
    return result["vhdl_digest"] == entry["files"]


def merge(out, entry, target, result):
    """Adds one target's result to implementation.json. Results of other targets stay when they are of the same VHDL."""
    before = read(out)
    if before is None or not is_fresh(before, entry):
        before = {
            "format": FORMAT,
            "configuration": entry["configuration"],
            "vhdl_digest": entry["files"],
            "targets": {},
        }
    before["targets"][target] = result
    files.write(Path(out) / FILE, json.dumps(before, indent=2, sort_keys=True) + "\n")


def check_writable(out):
    try:
        Path(out).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create {out}: {error.strerror}") from None


def ghdl_version():
    match = re.match(r"GHDL \S+", run([find_ghdl(), "--version"]))
    if not match:
        raise FlowError("ghdl --version does not say its version as GHDL does", EXIT_TOOL_FAILED)
    return match.group()


def implement_target(job, target, files, progress):
    """Area and, where there is a router, clock on one family. Returns (result, memories that became flip-flops)."""
    work = WORK / job.config / target.name
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    program = nextpnr.find_nextpnr(progress.console.print) if target.device else None
    seeds = job.seeds if target.device else []
    task = progress.add_task("", total=2 + len(seeds))

    def stage(name, done):
        progress.update(task, description=f"{job.config} {target.name}: {name}", completed=done)

    stage("ghdl --synth", 0)
    verilog = to_verilog(files, work)
    stage("yosys", 1)
    result, lost = yosys.synthesize(target, verilog, work)
    tools = {"ghdl": ghdl_version(), "yosys": yosys.version()}
    reports = {}
    for number, seed in enumerate(seeds):
        stage(f"nextpnr, seed {seed}", 2 + number)
        reports[seed] = nextpnr.route(program, seed, work)
    if reports:
        tools["nextpnr"] = nextpnr.version(program, work)
        names = nextpnr.register_names(verilog, json.loads((work / "netlist.json").read_text()))
        result |= {"device": target.device, "target_mhz": nextpnr.FREQUENCY_MHZ, **nextpnr.clocks(reports, names)}
    stage("done", 2 + len(seeds))
    return result | {"synthesis": target.synthesis, "tools": tools}, lost


def run_job(job):
    """Implements one configuration on its targets. Returns the exit code."""
    files, entry = manifest.vhdl_files(job.rtl), manifest.read(job.rtl)
    check_writable(job.out)
    all_lost = []
    with Progress(
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("steps"),
        TimeElapsedColumn(),
    ) as bar:
        for name in job.targets:
            result, lost = implement_target(job, yosys.TARGETS[name], files, bar)
            merge(job.out, entry, name, result)
            bar.console.print(summary(job.config, name, entry["parameters"], result), highlight=False, soft_wrap=True)
            all_lost += [f"{memory} on {name}" for memory in lost]
    if all_lost:
        raise FlowError(
            f"{job.config}: a memory became flip-flops instead of RAM: {', '.join(all_lost)}", EXIT_MISMATCH
        )
    return EXIT_OK


def summary(config, target, parameters, result):
    luts, name = figures.lut_count(result), yosys.TARGETS[target].lut_name
    text = [
        f"{config} on {target}: {luts} {name}, {result['ffs']} flip-flops, {result['memory_bits']} memory bits in "
        f"{result['block_rams']} block RAMs and LUT RAM",
        f"  {figures.clocks_per_frame(parameters)} clocks a frame, {figures.evaluations_per_clock(parameters):g} disparity evaluations a clock",
    ]
    if "fmax_mhz" in result:
        fmax, path = result["fmax_mhz"], result["critical_path"]
        speed = figures.speed(parameters, fmax["median"], luts)
        text += [
            f"  {fmax['median']} MHz routed (median of seeds {', '.join(f'{s}: {mhz}' for s, mhz in fmax['by_seed'].items())}) on {result['device']}, "
            f"{result['lut_sites']} LUT sites",
            f"  slowest path: {path['from']} to {path['to']}, block {path['block']}",
            f"  {speed['frames_per_second']:.1f} frames a second, {speed['mde_per_second']:.0f} million disparity evaluations a second, "
            f"{speed['evaluations_per_second_per_lut'] / 1e3:.0f} thousand evaluations a second per LUT",
        ]
    return "\n".join(text)
