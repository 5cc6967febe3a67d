# SPDX-License-Identifier: Apache-2.0
"""Runs Bambu on the hardware top and reads what it reports."""

import json
import re
import shlex
import shutil
from dataclasses import dataclass
from pathlib import Path

from ..base import rtl
from ..base.configurations import Configuration, parameters_of
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, find_bambu, run
from .manifest import Estimate, compiler_options, hardware_digests

WORK = ROOT / "build" / "synthesis"
DEVICE = "LFE5U85F8BG756C"
# The clock period only bounds what may share a state; a generous one keeps the whole loop body in one. The clock that
# counts is the one after place and route.
OPTIONS = [
    "--generate-interface=INFER",
    "-wH",
    "--generate-components-library",
    # Nothing can be shared inside one state; looking for sharing would take minutes.
    "--module-binding=UNIQUE",
    "--register-allocation=UNIQUE_BINDING",
    f"--device-name={DEVICE}",
    "--clock-period=400",
    "--distram-threshold=100000",
    "-O3",
    "-fno-slp-vectorize",
    # With more than 100 memories, as recursive sums have for many disparities, the front end would give up to look for
    # what a read depends on, take it to depend on another memory's write, and need a second state.
    "--extra-gcc-options=-mllvm -memssa-check-limit=1000000",
]


@dataclass(frozen=True)
class ToolRun:
    vhdl: Path  # the design
    version: str
    command: str  # as a user would type it in the project's root
    report: Estimate


def synthesize(config: str, row: Configuration) -> ToolRun:
    """Synthesises one configuration in an empty working directory, unless the last run there had the same inputs."""
    bambu = find_bambu()
    directory, kind = WORK / config, rtl.kind_of(row)
    options = compiler_options(config, row)
    options += ["--compiler=I386_CLANG16", f"--top-fname={kind.function}", *OPTIONS]
    command = shlex.join(["bambu", *options])
    version = tool_version(bambu)
    inputs = json.dumps([version, command, parameters_of(row), hardware_digests(row)], indent=1, sort_keys=True)
    stamp, log = directory / "inputs.json", directory / "bambu.log"
    if not stamp.is_file() or stamp.read_text() != inputs:
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        for folder in dict.fromkeys(("hls", row["source_folder"])):
            shutil.copytree(ROOT / folder, directory / folder, ignore=shutil.ignore_patterns("rtl"))
        run([bambu, *options], cwd=directory, log=log)
        if not (directory / f"{kind.function}.vhd").is_file():
            raise FlowError(f"Bambu wrote no {kind.function}.vhd; see {log}", EXIT_TOOL_FAILED)
        stamp.write_text(inputs)
    return ToolRun(
        vhdl=directory / f"{kind.function}.vhd", version=version, command=command, report=read_log(log.read_text())
    )


def tool_version(bambu: str) -> str:
    text = run([bambu, "--version"])
    match = re.search(r"Version: PandA (\S+) - Revision (\w+)", text)
    if not match:
        raise FlowError(f"{bambu} does not say its version as Bambu does", EXIT_TOOL_FAILED)
    return f"PandA Bambu {match.group(1)} revision {match.group(2)[:9]}"


def read_log(text: str) -> Estimate:
    """The tool's own estimate."""
    states = _last_number(r"Number of states: (\d+)", text)
    flip_flops = _last_number(r"Total number of flip-flops in function \w+: (\d+)", text)
    mhz = _last_number(r"Estimated max frequency \(MHz\): ([\d.]+)", text)
    return {
        "states": int(states),
        "flip_flops": int(flip_flops),
        "mhz": round(float(mhz), 2) if "." in mhz else int(mhz),
    }


def _last_number(pattern: str, text: str) -> str:
    found: list[str] = re.findall(pattern, text)
    if not found:
        raise FlowError(f"the tool's log has no line '{pattern}'", EXIT_TOOL_FAILED)
    return found[-1]


def original_files(config: str) -> list[Path]:
    """The VHDL and memory images of the last run for a matching core, the tool's components included: for co-simulation
    only, not for the repo."""
    directory = WORK / config
    components, memories = (directory / "bambu_lib" / "VHDL").glob("*.vhd"), directory.glob("*.mem")
    files = [directory / f"{rtl.CORE.function}.vhd", *sorted(components), *sorted(memories)]
    if len(files) < 2:
        raise FlowError(f"no output of Bambu in {directory}; run scripts/synthesize.py --config {config}")
    return files
