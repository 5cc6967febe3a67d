# SPDX-License-Identifier: Apache-2.0
"""A stereo_ip in GHDL under cocotb."""

from __future__ import annotations

import dataclasses
import functools
import json
import os
import xml.etree.ElementTree as xml
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..base import committed, ghdl, rtl, venv
from ..base.configurations import configuration
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Say, run
from ..cosim import vectors
from ..simulation import simulators
from ..simulation.simulation import Simulation
from ..synthesis import manifest
from . import design, pool, template

TESTS = ROOT / "hls_tb" / "shell"
REQUIREMENTS = ROOT / "scripts" / "requirements-axi.txt"
PAIRS = 4  # of images, of each kind of noise one


class Selection(NamedTuple):
    """Which tests run on what."""

    config: str
    module: str  # of hls_tb/shell
    tests: tuple[str, ...] | None = None  # None: all
    generics: ghdl.Generics = {}  # that are not those of the configuration
    what: str = ""  # differs


@dataclasses.dataclass
class Result:
    """One test of a module."""

    name: str
    seconds: float
    passed: bool
    message: str = ""


@functools.cache
def library_paths(programs: Path) -> tuple[str, str]:
    """(cocotb's library for GHDL, that of Python)"""
    interface = run([programs / "cocotb-config", "--lib-name-path", "vpi", "ghdl"])
    return interface.strip(), run([programs / "find_libpython"]).strip()


def environment_folder(say: Say = print) -> Path:
    return venv.ensure("venv-axi", REQUIREMENTS, "cocotb", say)


class Ghdl(Simulation):
    """The stereo_ip of one configuration. `files`: others for the core and the shell;
    `generics`: of the shell, that are not those of its core, and enabled_at_reset."""

    def __init__(
        self,
        config: str,
        work: Path,
        files: list[Path] | None = None,
        generics: ghdl.Generics | None = None,
        say: Say = print,
    ) -> None:
        self.config = config
        self.parameters = configuration(config)
        self.generics = dict(generics or {})
        enabled = self.generics.pop("enabled_at_reset", None)  # the only one that a user of the stereo_ip chooses
        self.given = {} if enabled is None else {"enabled_at_reset": enabled}
        names = [f"{name}_{value}" for name, value in self.generics.items()]
        top = rtl.ip_entity(config)
        texts = {f"{top}.vhd": template.entity(config, manifest.read(committed.folder(config)), self.generics)}
        own = simulators.Design(top, files or [*manifest.core_files(config), *design.shell_files()], texts=texts)
        # Analysed only: the run elaborates, and what fails there fails the tests.
        super().__init__(simulators.Ghdl(elaborates=False), own, work.resolve().joinpath("-".join([config, *names])))
        self.bin = environment_folder(say)

    def run(
        self,
        module: str,
        seed: int,
        out: Path,
        tests: Sequence[str] | None = None,
        watchdog_seconds: float = 300,
        pool_folder: Path | None = None,
        stop_at_failure: bool = False,
    ) -> list[Result]:
        """Runs a module of hls_tb/shell, all its tests or those named; returns the Results. `pool_folder`: a folder
        that make_pool has filled with PAIRS and the same seed. `stop_at_failure`: the tests after the first failed one
        fail, too."""
        out = out.resolve()
        out.mkdir(parents=True, exist_ok=True)
        self._write_pool(out, pool_folder, seed)
        results = out / f"{module}.xml"
        results.unlink(missing_ok=True)
        environment = self._environment(module, seed, results, out / "pool.json")
        if stop_at_failure:
            environment["STEREO_AXI_STOP_AT_FAILURE"] = "1"
        if tests:
            environment["TESTCASE"] = ",".join(tests)
        log = out / f"{module}.log"
        with log.open("w") as text:
            self.run_bench(
                self.given,
                watchdog_seconds,
                lambda line: text.write(line + "\n"),
                [f"--vpi={library_paths(self.bin)[0]}", "--ieee-asserts=disable-at-0"],
                environment=environment,
            )
        return read_results(results, log)

    def _environment(self, module: str, seed: int, results: Path, pool_file: Path) -> dict[str, str]:
        _, python = library_paths(self.bin)
        return {
            "MODULE": module,
            "TOPLEVEL": self.design.top,
            "TOPLEVEL_LANG": "vhdl",
            "COCOTB_RESULTS_FILE": str(results),
            "RANDOM_SEED": str(seed),
            "STEREO_AXI_POOL": str(pool_file),
            "COCOTB_LOG_LEVEL": "INFO",
            "COCOTB_ANSI_OUTPUT": "0",
            "PYTHONPATH": os.pathsep.join(map(str, (TESTS, ROOT / "scripts"))),
            "PYTHONDONTWRITEBYTECODE": "1",
            "LIBPYTHON_LOC": python,
            "VIRTUAL_ENV": str(self.bin.parent),
            "PATH": f"{self.bin}{os.pathsep}{os.environ['PATH']}",
        }

    def _write_pool(self, out: Path, filled: Path | None, seed: int) -> None:
        folder = filled or out / "pool"
        frames = pool.make_pool(self.config, self.parameters, PAIRS, seed, folder, reuse=filled is not None)
        clocks = clocks_of_one_frame(folder, rtl.kind_of(self.parameters))
        content = {
            "frames": [dataclasses.asdict(frame) for frame in frames],
            "seed": seed,
            "parameters": {**self.parameters, **self.generics, "clocks_of_one_frame": clocks},
        }
        (out / "pool.json").write_text(json.dumps(content))


def clocks_of_one_frame(folder: Path, kind: rtl.Kind) -> int:
    """From the first pair in to the last disparity out, both counted, in the C++ core when a flush follows: frame 1."""
    stimulus = vectors.read_stimulus(folder / "vectors_0" / "stimulus.txt", kind)
    expected, _ = vectors.read_expected(folder / "vectors_0" / "expected.txt")
    return expected[-1].clock - [clock for clock, (_, start) in enumerate(stimulus) if start][1] + 1


def read_results(path: Path, log: Path) -> list[Result]:
    """The Results in cocotb's JUnit file; a simulation that ended without it has failed."""
    try:
        cases = list(xml.parse(path).getroot().iter("testcase"))
    except (OSError, xml.ParseError):
        raise FlowError(f"cocotb wrote no results; see {log}", EXIT_TOOL_FAILED) from None
    if not cases:
        raise FlowError(f"cocotb ran no test; see {log}", EXIT_TOOL_FAILED)
    results = []
    for case in cases:
        if case.find("skipped") is None:
            passed = case.find("failure") is None
            results.append(Result(case.attrib["name"], float(case.attrib["time"]), passed, "" if passed else str(log)))
    return results
