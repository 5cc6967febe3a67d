# SPDX-License-Identifier: Apache-2.0
"""Runs Bambu on the hardware top and reads what it reports."""

import re
import shutil
from dataclasses import dataclass
from pathlib import Path

from .errors import EXIT_TOOL_FAILED, FlowError
from .tools import ROOT, find_bambu, run

TOP = "stereo_core"
DEVICE = "LFE5U85F8BG756C"
# The clock period only bounds what may share a state; a generous one keeps the whole loop body in one. The clock that
# counts is the one after place and route.
OPTIONS = [
    "--compiler=I386_CLANG16", f"--top-fname={TOP}", "--generate-interface=INFER", "-wH", "--generate-components-library",
    f"--device-name={DEVICE}", "--clock-period=400", "--distram-threshold=100000", "-O3", "-fno-slp-vectorize",
]


@dataclass(frozen=True)
class ToolRun:
    vhdl: Path  # the design
    library: Path  # the tool's component library, never copied into the project
    version: str
    command: str  # as a user would type it in the project's root
    report: dict


def synthesize(config, directory):
    """Synthesises one configuration in an empty working directory."""
    bambu = find_bambu()
    directory = Path(directory)
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    shutil.copytree(ROOT / "hls", directory / "hls", ignore=shutil.ignore_patterns("rtl"))
    options = ["hls/stereo_top.cpp", "-Ihls", f"-DSTEREO_CONFIGURATION={config}", *OPTIONS]
    log = directory / "bambu.log"
    run([bambu, *options], cwd=directory, log=log)
    return ToolRun(
        vhdl=_one(directory, f"{TOP}.vhd"),
        library=_one(directory, "*library*.vhd"),
        version=tool_version(bambu),
        command=" ".join(["bambu", *options]),
        report=read_log(log.read_text()),
    )


def tool_version(bambu):
    text = run([bambu, "--version"])
    match = re.search(r"Version: PandA (\S+) - Revision (\w+)", text)
    if not match:
        raise FlowError(f"{bambu} does not say its version as Bambu does", EXIT_TOOL_FAILED)
    return f"PandA Bambu {match.group(1)} revision {match.group(2)[:9]}"


def read_log(text):
    """States, flip-flops and clock of the tool's own estimate."""
    found = {}
    for key, pattern in {
        "states": r"Number of control steps: (\d+)", "flip_flops": r"Total number of flip-flops in function \w+: (\d+)",
        "mhz": r"Estimated max frequency \(MHz\): ([\d.]+)",
    }.items():
        matches = re.findall(pattern, text)
        found[key] = float(matches[-1]) if matches else None
    return found


def _one(directory, pattern):
    files = [path for path in directory.rglob(pattern) if "hls" not in path.relative_to(directory).parts]
    if len(files) != 1:
        raise FlowError(f"Bambu wrote {len(files)} files {pattern} in {directory}, expected one", EXIT_TOOL_FAILED)
    return files[0]
