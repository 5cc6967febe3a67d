# SPDX-License-Identifier: Apache-2.0
"""Co-simulation: the C++ core makes stimulus and expectation, a simulator runs the VHDL, the checker compares."""

import dataclasses
import json
import re
import shlex
import time
import xml.etree.ElementTree as xml
from pathlib import Path
from typing import Optional

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from ..base.configurations import configuration
from ..base.errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.tools import GENERATED_RTL, ROOT, find_stereo_hls, run
from ..implementation import figures
from ..synthesis import manifest
from ..synthesis.bambu import original_files
from . import checker, mismatch, vectors
from .simulators import SIMULATORS, Ghdl

WAVE_CLOCKS_BEFORE = 64
WAVE_CLOCKS_AFTER = 16
AUTOMATIC_WAVE_CLOCKS = 100_000  # later mismatches would take GHDL minutes
SIMULATIONS = ROOT / "build" / "cosim" / "simulators"


@dataclasses.dataclass(frozen=True)
class Job:
    config: str
    left: Path
    right: Path
    rows: Optional[str] = None  # "A:B", image rows A ... B-1 only; "N": figures.middle_rows
    frames: int = 1
    stall_percent: int = 0
    seed: int = 1
    fit: str = "none"
    simulator: str = "ghdl"
    rtl: Optional[Path] = None  # default: generated_rtl/CONFIG
    out: Optional[Path] = None  # default: build/cosim/CONFIG-SIMULATOR
    wave: Optional[Path] = None
    watchdog_seconds: float = 300.0

    def out_directory(self):
        return Path(self.out) if self.out else ROOT / "build" / "cosim" / f"{self.config}-{self.simulator}"


def make_vectors(job, directory):
    command = [
        find_stereo_hls(),
        "vectors",
        "--config",
        job.config,
        "--left",
        job.left,
        "--right",
        job.right,
        "--frames",
        job.frames,
        "--stall-percent",
        job.stall_percent,
        "--seed",
        job.seed,
        "--fit",
        job.fit,
        "--out",
        directory,
    ]
    if job.rows is not None:
        command += ["--rows", job.rows]
    notices = run(command, passes_errors=True)
    print(notices, end="")
    return directory / "stimulus.txt", directory / "expected.txt"


def run_job(job):
    """Runs one co-simulation, writes report.json and junit.xml, prints the summary. Returns the report."""
    parameters = configuration(job.config)
    if job.rows is not None and re.fullmatch("[1-9][0-9]*", job.rows):
        job = dataclasses.replace(job, rows=figures.middle_rows(parameters, int(job.rows)))
    _check_wave(job)
    files = (
        original_files(job.config)
        if job.simulator == "original"
        else manifest.vhdl_files(job.rtl or GENERATED_RTL / job.config)
    )
    out = job.out_directory()
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create {out}: {error.strerror}") from None
    for stale in ("report.json", "junit.xml", *mismatch.FILES):
        (out / stale).unlink(missing_ok=True)
    stimulus_path, expected_path = make_vectors(job, out)
    stimulus = vectors.read_stimulus(stimulus_path)
    expected, _ = vectors.read_expected(expected_path)

    build_folder = SIMULATIONS / f"{job.config}-{job.simulator}{'-trace' if job.wave else ''}"
    simulator = SIMULATORS[job.simulator](
        files, build_folder, parameters["pixels_per_clock"], parameters["disparity_bits"], trace=job.wave is not None
    )
    started = time.monotonic()
    print(f"{job.config}: building the {job.simulator} simulation ...", flush=True)
    simulator.build()
    build_seconds = time.monotonic() - started

    observed_path = out / "observed.txt"
    with Progress(
        TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TextColumn("clocks"), TimeRemainingColumn()
    ) as bar:
        task = bar.add_task(f"{job.config} in {job.simulator}", total=len(stimulus))
        seconds = simulator.run(
            stimulus_path, observed_path, lambda clock: bar.update(task, completed=clock), job.watchdog_seconds
        )
        bar.update(task, completed=len(stimulus))
    observed, clocks = vectors.read_observed(observed_path)
    if clocks != len(stimulus):
        raise FlowError(f"the simulation ran {clocks} of {len(stimulus)} clocks", EXIT_TOOL_FAILED)

    verdict = checker.compare(expected, observed, parameters["disparity_bits"])
    timing = checker.measure(stimulus, observed, parameters)
    report = make_report(job, verdict, timing, len(stimulus), seconds, build_seconds)
    if job.wave is not None:
        report["wave"] = _dump_wave(job, simulator, stimulus_path, out, verdict, len(stimulus))
    (out / "report.json").write_text(json.dumps(report, indent=2) + "\n")
    write_junit(out / "junit.xml", report, seconds)
    print(summary(report))
    if verdict.first_mismatch:
        _explain(job, parameters, simulator, files, verdict.first_mismatch, len(stimulus))
    return report


def exit_code(report):
    return EXIT_OK if report["passed"] else EXIT_MISMATCH


def _explain(job, parameters, simulator, files, first, clocks):
    """Waveform and page of the first mismatch. A model of Verilator has no waveform built in: GHDL runs the same VHDL for it."""
    out = job.out_directory()

    def dump(path, window):
        if first.clock > AUTOMATIC_WAVE_CLOCKS:
            raise FlowError(f"it lies beyond clock {AUTOMATIC_WAVE_CLOCKS:,}; --wave FILE makes one")
        source = simulator
        if not isinstance(simulator, Ghdl):
            source = Ghdl(
                files, SIMULATIONS / f"{job.config}-ghdl", parameters["pixels_per_clock"], parameters["disparity_bits"]
            )
            source.build()
        source.run(
            out / "stimulus.txt",
            out / "observed_wave.txt",
            lambda clock: None,
            job.watchdog_seconds,
            path.resolve(),
            window,
        )
        (out / "observed_wave.txt").unlink(missing_ok=True)

    for line in mismatch.explain(out, parameters, first, clocks, dump, WAVE_CLOCKS_BEFORE, WAVE_CLOCKS_AFTER):
        print(line)


def command(job):
    """The words that run a job again."""
    words = ["scripts/cosim.py", "--config", job.config, "--left", job.left, "--right", job.right]
    for option, value, default in (
        ("--rows", job.rows, None),
        ("--frames", job.frames, 1),
        ("--stall-percent", job.stall_percent, 0),
        ("--fit", job.fit, "none"),
        ("--rtl", job.rtl, None),
    ):
        words += [option, value] if value != default else []
    return shlex.join(str(word) for word in [*words, "--seed", job.seed, "--simulator", job.simulator])


def make_report(job, verdict, timing, clocks, seconds, build_seconds):
    first = verdict.first_mismatch
    return {
        "config": job.config,
        "command": command(job),
        "simulator": job.simulator,
        "rows": job.rows,
        "stall_percent": job.stall_percent,
        "seed": job.seed,
        "passed": verdict.passed,
        "expected": verdict.expected,
        "compared": verdict.compared,
        "mismatches": verdict.mismatches,
        "first_mismatch": str(first) if first else None,
        "frames": timing.frames,
        "clocks": clocks,
        "clocks_per_frame": timing.clocks_per_frame,
        "initiation_interval": timing.initiation_interval,
        "latency_clocks": timing.latency_clocks,
        "clocks_per_second": round(clocks / seconds, 1),
        "build_seconds": round(build_seconds, 2),
        "simulation_seconds": round(seconds, 2),
    }


def summary(report):
    interval = report["initiation_interval"]
    text = [
        f"{'PASS' if report['passed'] else 'FAIL'}: {report['config']} in {report['simulator']}: "
        f"{report['compared']} of {report['expected']} outputs compared, {report['mismatches']} mismatches"
    ]
    if report["first_mismatch"]:
        text.append(f"  first mismatch: {report['first_mismatch']}")
    if interval:
        text.append(
            f"  initiation interval min/avg/max {interval['min']}/{interval['avg']:.2f}/{interval['max']} clocks"
        )
    if report["latency_clocks"] is not None:
        text.append(f"  latency {report['latency_clocks']} clocks from a window's last pixel pair to its disparity")
    if report["clocks_per_frame"]:
        text.append(f"  {report['clocks_per_frame']} clocks a frame")
    text.append(
        f"  {report['clocks']} clocks in {report['simulation_seconds']} s ({report['clocks_per_second']:.0f} clocks/s), "
        f"built in {report['build_seconds']} s"
    )
    if "wave" in report:
        text.append(f"  waveform: {report['wave']}")
    return "\n".join(text)


def write_junit(path, report, seconds):
    suite = xml.Element(
        "testsuite", name="cosim", tests="1", failures="0" if report["passed"] else "1", time=f"{seconds:.3f}"
    )
    case = xml.SubElement(
        suite, "testcase", classname=f"cosim.{report['simulator']}", name=report["config"], time=f"{seconds:.3f}"
    )
    if not report["passed"]:
        message = report["first_mismatch"] or "nothing was compared"
        xml.SubElement(case, "failure", message=message).text = summary(report)
    xml.ElementTree(suite).write(path, encoding="utf-8", xml_declaration=True)


def _check_wave(job):
    allowed = SIMULATORS[job.simulator].wave_suffixes
    if job.wave is not None and Path(job.wave).suffix not in allowed:
        raise FlowError(
            f"--wave with {job.simulator} takes a name that ends in {' or '.join(allowed)}, not {Path(job.wave).name}"
        )
    if job.wave is not None:
        try:
            Path(job.wave).resolve().parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FlowError(f"cannot create the folder of --wave {job.wave}: {error.strerror}") from None


def _dump_wave(job, simulator, stimulus_path, out, verdict, clocks):
    """Second run with a dump: around the first mismatch, or the first clocks when there is none."""
    first = verdict.first_mismatch
    window = mismatch.window(
        first.clock if first else WAVE_CLOCKS_BEFORE, clocks, WAVE_CLOCKS_BEFORE, WAVE_CLOCKS_AFTER
    )
    wave = Path(job.wave).resolve()
    simulator.run(stimulus_path, out / "observed_wave.txt", lambda clock: None, job.watchdog_seconds, wave, window)
    (out / "observed_wave.txt").unlink()
    return str(wave)
