# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in Verilator: for thousands of frames."""

import hashlib
import os
import re
import shutil
from dataclasses import dataclass, field
from pathlib import Path

from .. import vectors
from ..errors import EXIT_TOOL_FAILED, FlowError
from ..simulators import to_verilog
from ..tools import ROOT, find_verilator, run, run_with_progress
from . import design, script

BENCH = ROOT / "hls_tb" / "axi" / "verilator_axi_bench.cpp"


@dataclass
class Observation:
    """What a bench wrote down: the beats of m_axis between resets, each (data, flags, clock)."""

    segments: list = field(default_factory=list)
    breaches: list = field(default_factory=list)
    clocks: int = 0
    hangs: bool = False


class Verilated:
    """One configuration, built once in its folder."""

    def __init__(self, config, work, files=None, generics=None, trace=False):
        self.files = files or design.vhdl_files(config)
        self.generics = generics or design.generics(config)
        self.work = Path(work)
        self.trace = trace

    def build(self):
        """Does nothing when the same sources were built here before."""
        key = hashlib.sha256(repr((self.trace, self.generics)).encode())
        for path in [*self.files, BENCH, Path(__file__)]:
            key.update(Path(path).read_bytes())
        stamp = self.work / "built"
        if stamp.is_file() and stamp.read_text() == key.hexdigest():
            return
        verilator = find_verilator()
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        verilog = self.work / "stereo_ip.v"
        verilog.write_text(to_verilog(self.files, self.work, "stereo_ip", self.generics))
        trace = ["--trace-fst"] if self.trace else []
        run(
            [verilator, "--cc", "--exe", "--build", "-j", os.cpu_count() or 1, "-O3", "--x-assign", "fast", "--output-split", "20000",
             "-Wno-fatal", *trace, "-CFLAGS", "-O2", "--top-module", "stereo_ip", "--Mdir", self.work / "model", "-o", "bench",
             verilog, BENCH],
            cwd=self.work, log=self.work / "verilator.log",
        )
        stamp.write_text(key.hexdigest())

    def play(self, steps, seed, out, watchdog_seconds=300, wave=None, on_clock=lambda clock: None):
        """Plays the steps and returns the Observation. `wave`: (file, first clock, last clock)."""
        out = Path(out).resolve()
        out.mkdir(parents=True, exist_ok=True)
        stream, observed = out / "stream.txt", out / "observed.txt"
        stream.write_text(script.as_text(steps, seed))
        observed.unlink(missing_ok=True)

        def on_line(line):
            if line.startswith("progress "):
                on_clock(int(line.split()[1]))

        run_with_progress([self.work / "model" / "bench", stream, observed, *(wave or ())], on_line, watchdog_seconds, cwd=out)
        return read_observation(observed)


def read_observation(path):
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
