# SPDX-License-Identifier: Apache-2.0
"""Times the steps that a developer repeats after a change of the C++, those that can run side by side at once."""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from .base import committed
from .base.configurations import Configuration, configuration, designs
from .base.errors import FlowError
from .base.tools import ROOT, Word, find_bambu, find_ghdl, find_verilator, run
from .synthesis import bambu

SCRIPTS = ROOT / "scripts"
WORK = ROOT / "build" / "dev_loop"
ORIGINAL_ROWS = 3  # or as few as give an output: Bambu's own VHDL takes about a second for 100 clocks
BAMBU_PROCESSORS = 1


Step = Callable[[], str]  # gives a note


@dataclass
class Timing:
    step: str
    started: float = 0.0  # seconds after the edit
    seconds: float = 0.0
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
        committed.folder(config)
        os.environ["STEREO_HLS"] = str(self.build / "stereo_hls")  # for the commands called below

    def run(self, done: Callable[[Timing], object]) -> float:
        """All steps; `done` is called after each. Returns the seconds from the edit to a whole frame that both
        simulators have played."""
        edited = time.monotonic()

        def lane(*steps: tuple[str, Step]) -> None:
            for name, step in steps:
                done(self._measure(edited, name, step))

        row = configuration(self.config, designs())  # of the program that is built again below
        # Bambu needs one processor and most of the time. The lowering takes the names of the registers from the C++
        # core, so it waits for the one that is new.
        with ThreadPoolExecutor() as pool:
            native = pool.submit(
                lane,
                (f"hls/{self.header.relative_to(ROOT / 'hls')} changed: its unit test", self.unit_test),
                ("the clocked core of a pair", self.clocked_core),
            )
            lane(("Bambu", lambda: self.bambu(row)))
            native.result()
            lane(("lowering, VHDL", self.lowering))
            crop, whole = f"VHDL in GHDL, {self.crop_rows} rows", "VHDL in GHDL, whole frame"
            verilator = pool.submit(lane, ("VHDL in Verilator, whole frame", lambda: self.cosim("verilator")))
            lane((crop, lambda: self.cosim("ghdl", self.crop_rows)), (whole, lambda: self.cosim("ghdl")))
            verilator.result()
        proven = time.monotonic() - edited
        lane((f"Bambu's own VHDL in GHDL, {ORIGINAL_ROWS} rows", lambda: self.cosim("original", ORIGINAL_ROWS)))
        return proven

    def _measure(self, edited: float, name: str, step: Step) -> Timing:
        timing = Timing(name, time.monotonic() - edited)
        try:
            timing.note = step()
        except Skipped as reason:
            timing.skipped = str(reason)
        except FlowError as error:
            timing.failed = str(error)
        timing.seconds = time.monotonic() - edited - timing.started
        return timing

    def prepare(self) -> None:
        """What must be there before the first step is timed: an up-to-date build and a pair of images."""
        WORK.mkdir(parents=True, exist_ok=True)
        # Without a compiler cache: a touched header has the same content.
        command: list[Word] = ["cmake", "-S", ROOT, "-B", self.build, "-G", "Ninja", "-DSTEREO_COMPILER_CACHE="]
        run(command, log=WORK / "configure.log")
        self._make("stereo_hls", f"core_{self.config}", *([self._test()] if self._has_test() else []))
        run(
            [os.environ["STEREO_HLS"], "scene", "--config", self.config, "--seed", 7, "--out", WORK / "scene"],
            passes_errors=True,
        )
        shutil.rmtree(WORK / "rtl", ignore_errors=True)
        for simulator in ("ghdl", "verilator", "original"):  # built anew, as after a change
            shutil.rmtree(ROOT / "build" / "cosim" / "simulators" / f"{self.config}-{simulator}", ignore_errors=True)
        os.utime(self.header)

    def _make(self, *targets: str, spare: int = 0) -> None:
        """`spare`: processors that are left to others."""
        jobs = max((os.cpu_count() or 1) - spare, 1)
        run(["cmake", "--build", self.build, "--parallel", jobs, "--target", *targets], log=WORK / "build.log")

    def _test(self) -> str:
        return f"blocks_{self.block}_test"

    def _has_test(self) -> bool:
        return f"{self._test()}:" in run(["cmake", "--build", self.build, "--target", "help"])

    def unit_test(self) -> str:
        if not self._has_test():
            raise Skipped(f"there is no test {self._test()}")
        self._make(self._test(), spare=BAMBU_PROCESSORS)
        output = run([self.build / "tests" / self._test()], log=WORK / "unit.log")
        return next((line.strip("[] ") for line in output.splitlines() if "PASSED" in line), "")

    def clocked_core(self) -> str:
        self._make("stereo_hls", f"core_{self.config}", spare=BAMBU_PROCESSORS)
        pair: list[Word] = ["--left", WORK / "scene" / "left.png", "--right", WORK / "scene" / "right.png"]
        options: list[Word] = ["--config", self.config, "--engine", "clocked", "--out", WORK / "match"]
        run([os.environ["STEREO_HLS"], "match", *pair, *options], passes_errors=True)
        return ""

    def bambu(self, row: Configuration) -> str:
        need(find_bambu)
        # Else the tool's last run would be taken, as a touched header has the same content.
        (bambu.WORK / self.config / "inputs.json").unlink(missing_ok=True)
        bambu.synthesize(self.config, row)
        return ""

    def lowering(self) -> str:
        """Finds what Bambu has made, unless the new program says that the configuration is another one."""
        need(find_bambu)
        command: list[Word] = [SCRIPTS / "synthesize.py", "--config", self.config, "--out", WORK / "rtl"]
        run(command, log=WORK / "synthesis.log", passes_errors=True)
        return "into build/"

    def cosim(self, simulator: str, rows: int | None = None) -> str:
        need(find_verilator if simulator == "verilator" else find_ghdl)
        if simulator == "original":
            need(find_bambu)
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


class Skipped(Exception):
    pass


def need(find: Callable[[], str]) -> None:
    """Turns a missing tool into a skipped step."""
    try:
        find()
    except FlowError as error:
        raise Skipped(str(error)) from None
