# SPDX-License-Identifier: Apache-2.0
"""stereo_ip in GHDL under cocotb."""

import dataclasses
import functools
import json
import os
import xml.etree.ElementTree as xml
from pathlib import Path

from ..base import venv
from ..base.configurations import configuration
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, find_ghdl, run, run_with_progress
from ..cosim import vectors
from ..cosim.simulators import GHDL_STANDARD, build_once
from . import design, pool

TESTS = ROOT / "hls_tb" / "axi"
REQUIREMENTS = ROOT / "scripts" / "requirements-axi.txt"
PAIRS = 4  # of images, of each kind of noise one


@dataclasses.dataclass
class Result:
    """One test of a module."""

    name: str
    seconds: float
    passed: bool
    message: str = ""


@functools.lru_cache(maxsize=None)
def library_paths(programs):
    """(cocotb's library for GHDL, that of Python)"""
    return run([programs / "cocotb-config", "--lib-name-path", "vpi", "ghdl"]).strip(), run(
        [programs / "find_libpython"]
    ).strip()


def environment_folder(say=print):
    return venv.ensure("venv-axi", REQUIREMENTS, "cocotb", say)


class Ghdl:
    """stereo_ip of one configuration, analysed once in its folder. `generics` replace those of the configuration."""

    def __init__(self, config, work, files=None, generics=None, say=print):
        self.config = config
        self.parameters = configuration(config)
        self.files = files or design.vhdl_files(config)
        self.generics = design.generics(config) | (generics or {})
        self.work = Path(work).resolve()
        self.bin = environment_folder(say)

    def build(self):
        build_once(self.work, self.files, None, self._analyse)

    def _analyse(self):
        run([find_ghdl(), "-a", GHDL_STANDARD, *self.files], cwd=self.work, log=self.work / "analyse.log")

    def run(
        self, module, seed, out, tests=None, pairs=PAIRS, watchdog_seconds=300, pool_folder=None, stop_at_failure=False
    ):
        """Runs a module of hls_tb/axi, all its tests or those named; returns the Results. `pool_folder`: a folder that
        make_pool has filled with the same pairs and seed. `stop_at_failure`: the tests after the first failed one fail, too."""
        out = Path(out).resolve()
        out.mkdir(parents=True, exist_ok=True)
        self._write_pool(out, pool_folder, pairs, seed)
        results = out / f"{module}.xml"
        results.unlink(missing_ok=True)
        interface, python = library_paths(self.bin)
        environment = {
            "MODULE": module,
            "TOPLEVEL": "stereo_ip",
            "TOPLEVEL_LANG": "vhdl",
            "COCOTB_RESULTS_FILE": str(results),
            "RANDOM_SEED": str(seed),
            "STEREO_AXI_POOL": str(out / "pool.json"),
            "COCOTB_LOG_LEVEL": "INFO",
            "COCOTB_ANSI_OUTPUT": "0",
            "PYTHONPATH": os.pathsep.join(map(str, (TESTS, ROOT / "scripts"))),
            "PYTHONDONTWRITEBYTECODE": "1",
            "LIBPYTHON_LOC": python,
            "VIRTUAL_ENV": str(self.bin.parent),
            "PATH": f"{self.bin}{os.pathsep}{os.environ['PATH']}",
        }
        if stop_at_failure:
            environment["STEREO_AXI_STOP_AT_FAILURE"] = "1"
        if tests:
            environment["TESTCASE"] = ",".join(tests)
        values = [f"-g{name}={value}" for name, value in self.generics.items()]
        command = [
            "env",
            *(f"{name}={value}" for name, value in environment.items()),
            find_ghdl(),
            "-r",
            GHDL_STANDARD,
            "stereo_ip",
            *values,
            f"--vpi={interface}",
            "--ieee-asserts=disable-at-0",
        ]
        log = out / f"{module}.log"
        with log.open("w") as text:
            run_with_progress(command, lambda line: text.write(line + "\n"), watchdog_seconds, cwd=self.work)
        return read_results(results, log)

    def _write_pool(self, out, folder, pairs, seed):
        reuse, folder = folder is not None, folder or out / "pool"
        frames = pool.make_pool(self.config, self.parameters, pairs, seed, folder, reuse)
        content = {
            "frames": [dataclasses.asdict(frame) for frame in frames],
            "seed": seed,
            "parameters": self.parameters | self.generics | {"clocks_of_one_frame": clocks_of_one_frame(Path(folder))},
        }
        (out / "pool.json").write_text(json.dumps(content))


def clocks_of_one_frame(folder):
    """From the first pair in to the last disparity out, both counted, in the C++ core when a flush follows: frame 1."""
    stimulus = vectors.read_stimulus(folder / "vectors_0" / "stimulus.txt")
    expected, _ = vectors.read_expected(folder / "vectors_0" / "expected.txt")
    return expected[-1].clock - [clock for clock, (_, start) in enumerate(stimulus) if start][1] + 1


def read_results(path, log):
    """The Results in cocotb's JUnit file; a simulation that ended without it has failed."""
    try:
        cases = list(xml.parse(path).getroot().iter("testcase"))
    except (OSError, xml.ParseError):
        raise FlowError(f"cocotb wrote no results; see {log}", EXIT_TOOL_FAILED) from None
    if not cases:
        raise FlowError(f"cocotb ran no test; see {log}", EXIT_TOOL_FAILED)
    results = []
    for case in cases:
        failure = case.find("failure")
        skipped = case.find("skipped") is not None
        if not skipped:
            results.append(
                Result(case.get("name"), float(case.get("time")), failure is None, "" if failure is None else str(log))
            )
    return results
