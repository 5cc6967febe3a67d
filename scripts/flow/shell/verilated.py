# SPDX-License-Identifier: Apache-2.0
"""A stereo_ip in Verilator: for thousands of frames."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from ..base import rtl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT
from ..cosim import vectors
from ..simulation.simulation import Simulation
from ..simulation.simulators import Design, Verilator
from . import design
from .script import Step, as_text

WATCHDOG_SECONDS = 300  # the bench says every 20,000 clocks that it goes on
BENCH = ROOT / "hls_tb" / "shell" / "verilator_axi_bench.cpp"


@dataclass
class Observation:
    """What a bench wrote down: the beats of m_axis between resets, each (data, flags, clock)."""

    segments: list[list[tuple[int, int, int]]] = field(default_factory=list)
    breaches: list[str] = field(default_factory=list)
    clocks: int = 0
    hangs: bool = False


class Verilated(Simulation):
    """One configuration."""

    def __init__(self, config: str, work: Path, files: list[Path] | None = None) -> None:
        built = Design(rtl.ip_entity(config), files or design.vhdl_files(config), [BENCH])
        super().__init__(Verilator(), built, work)

    def play(self, steps: Iterable[Step], seed: int, out: Path) -> Observation:
        out = out.resolve()
        out.mkdir(parents=True, exist_ok=True)
        stream, observed = out / "stream.txt", out / "observed.txt"
        stream.write_text(as_text(steps, seed))
        self.run_bench({"stream_file": stream, "observed_file": observed}, WATCHDOG_SECONDS, writes=observed)
        return read_observation(observed)


def read_observation(path: Path) -> Observation:
    """The file that verilator_axi_bench.cpp writes; its last line says how the simulation ended."""
    seen = Observation()
    lines = vectors.read_lines(path)
    end = re.fullmatch(rf"(end|hang) ({vectors.NUMBER})", lines[-1]) if lines else None
    if not end:
        raise FlowError(f"{path}: the simulation did not write its last line, so it did not finish", EXIT_TOOL_FAILED)
    for line in lines[:-1]:
        beat = re.fullmatch(rf"o ([0-9a-f]{{1,32}}) ({vectors.NUMBER}) ({vectors.NUMBER})", line)
        if beat and seen.segments:
            data, flags, clock = beat.groups()
            seen.segments[-1].append((int(data, 16), int(flags), int(clock)))
        elif line == "r":
            seen.segments.append([])
        elif line.startswith("p "):
            seen.breaches.append(line[2:])
        else:
            raise FlowError(f"{path}: '{line}' is no line of an observation", EXIT_TOOL_FAILED)
    seen.hangs, seen.clocks = end.group(1) == "hang", int(end.group(2))
    return seen
