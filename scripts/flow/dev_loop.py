# SPDX-License-Identifier: Apache-2.0
"""Times the steps that a developer repeats after a change of the C++."""

import json
import os
import resource
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from .base import rtl
from .base.errors import FlowError
from .base.tools import ROOT, Word, find_bambu, find_ghdl, find_verilator, run
from .synthesis import bambu

SCRIPTS = ROOT / "scripts"
WORK = ROOT / "build" / "dev_loop"
ORIGINAL_ROWS = 3  # or as few as give an output: Bambu's own VHDL takes about a second for 100 clocks


Step = Callable[[], str]  # gives a note


@dataclass
class Timing:
    step: str
    seconds: float = 0.0
    processor_seconds: float = 0.0
    note: str = ""
    skipped: str = ""  # why, when it did not run
    failed: str = ""  # how, when it did not succeed


class DevLoop:
    def __init__(self, config: str, header: str, crop_rows: int) -> None:
        self.config, self.crop_rows = config, crop_rows
        self.header = ROOT / "hls" / header
        self.block = Path(header).with_suffix("").as_posix().replace("/", "_")  # as its test is called
        self.build = WORK / "native"
        if not self.header.is_file():
            raise FlowError(f"there is no hls/{header}")
        rtl.folder(config)
        os.environ["STEREO_HLS"] = str(self.build / "stereo_hls")  # for the commands called below

    def steps(self) -> list[tuple[str, Step]]:
        """With their names, in the order of a developer's day."""
        return [
            (f"hls/{self.header.relative_to(ROOT / 'hls')} changed: its unit test", self.unit_test),
            ("the clocked core of a pair", self.clocked_core),
            ("Bambu, lowering, VHDL", self.synthesis),
            (f"VHDL in GHDL, {self.crop_rows} rows", lambda: self.cosim("ghdl", self.crop_rows)),
            ("VHDL in GHDL, whole frame", lambda: self.cosim("ghdl")),
            ("VHDL in Verilator, whole frame", lambda: self.cosim("verilator")),
            (f"Bambu's own VHDL in GHDL, {ORIGINAL_ROWS} rows", lambda: self.cosim("original", ORIGINAL_ROWS)),
        ]

    def measure(self, name: str, step: Step) -> Timing:
        started, before = time.monotonic(), processor_seconds()
        timing = Timing(name)
        try:
            timing.note = step()
        except Skipped as reason:
            return Timing(name, skipped=str(reason))
        except FlowError as error:
            timing.failed = str(error)
        timing.seconds, timing.processor_seconds = time.monotonic() - started, processor_seconds() - before
        return timing

    def prepare(self) -> None:
        """What must be there before the first step is timed: an up-to-date build and a pair of images."""
        WORK.mkdir(parents=True, exist_ok=True)
        # Without a compiler cache: a touched header has the same content.
        command: list[Word] = ["cmake", "-S", ROOT, "-B", self.build, "-G", "Ninja", "-DSTEREO_COMPILER_CACHE="]
        run(command, log=WORK / "configure.log")
        self._make("stereo_hls", f"core_{self.config}")
        if self._has_test():
            self._make(self._test())
        run(
            [os.environ["STEREO_HLS"], "scene", "--config", self.config, "--seed", 7, "--out", WORK / "scene"],
            passes_errors=True,
        )
        shutil.rmtree(WORK / "rtl", ignore_errors=True)
        os.utime(self.header)

    def _make(self, *targets: str) -> None:
        run(["cmake", "--build", self.build, "--target", *targets], log=WORK / "build.log")

    def _test(self) -> str:
        return f"blocks_{self.block}_test"

    def _has_test(self) -> bool:
        return f"{self._test()}:" in run(["cmake", "--build", self.build, "--target", "help"])

    def unit_test(self) -> str:
        if not self._has_test():
            raise Skipped(f"there is no test {self._test()}")
        self._make(self._test())
        output = run([self.build / "tests" / self._test()], log=WORK / "unit.log")
        return next((line.strip("[] ") for line in output.splitlines() if "PASSED" in line), "")

    def clocked_core(self) -> str:
        self._make("stereo_hls", f"core_{self.config}")
        pair: list[Word] = ["--left", WORK / "scene" / "left.png", "--right", WORK / "scene" / "right.png"]
        options: list[Word] = ["--config", self.config, "--engine", "clocked", "--out", WORK / "match"]
        run([os.environ["STEREO_HLS"], "match", *pair, *options], passes_errors=True)
        return ""

    def synthesis(self) -> str:
        need(find_bambu)
        # Else the tool's last run would be taken, as a touched header has the same content.
        (bambu.WORK / self.config / "inputs.json").unlink(missing_ok=True)
        command: list[Word] = [SCRIPTS / "synthesize.py", "--config", self.config, "--out", WORK / "rtl"]
        run(command, log=WORK / "synthesis.log", passes_errors=True)
        return "into build/"

    def cosim(self, simulator: str, rows: int | None = None) -> str:
        need(find_verilator if simulator == "verilator" else find_ghdl)
        if simulator == "original":
            need(find_bambu)
        # From scratch, as after a change.
        shutil.rmtree(ROOT / "build" / "cosim" / "simulators" / f"{self.config}-{simulator}", ignore_errors=True)
        name, new_rtl = f"{simulator}{'-crop' if rows else ''}", WORK / "rtl" / self.config
        command: list[Word] = [
            SCRIPTS / "cosim.py",
            "--config",
            self.config,
            "--simulator",
            simulator,
            "--out",
            WORK / name,
        ]
        command += ["--left", WORK / "scene" / "left.png", "--right", WORK / "scene" / "right.png"]
        if rows:
            command += ["--rows", rows]
        if new_rtl.is_dir():
            command += ["--rtl", new_rtl]
        run(command, log=WORK / f"{name}.log", passes_errors=True)
        report = json.loads((WORK / name / "report.json").read_text())
        times = f"build {report['build_seconds']:.1f} s, run {report['simulation_seconds']:.2f} s"
        return f"{times}, {report['clocks_per_second']:,.0f} clocks/s"


def processor_seconds() -> float:
    """Of all programs that were called and have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Skipped(Exception):
    pass


def need(find: Callable[[], str]) -> None:
    """Turns a missing tool into a skipped step."""
    try:
        find()
    except FlowError as error:
        raise Skipped(str(error)) from None
