# SPDX-License-Identifier: Apache-2.0
"""Co-simulation: the C++ core makes stimulus and expectation, a simulator runs the VHDL, the checker compares."""

import dataclasses
import json
import re
import shlex
import time
from pathlib import Path

from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from ..base.configurations import Parameters, configuration
from ..base.errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Word, find_stereo_hls, run
from ..synthesis import manifest
from ..synthesis.bambu import original_files
from . import checker, mismatch, vectors
from .report import Report, summary, write_junit
from .simulators import SIMULATORS, Clocks, Ghdl, Simulator

AUTOMATIC_WAVE_CLOCKS = 100_000  # later mismatches would take GHDL minutes
SIMULATIONS = ROOT / "build" / "cosim" / "simulators"


@dataclasses.dataclass(frozen=True)
class Job:
    config: str
    left: Path
    right: Path
    rows: str | None = None  # "A:B", image rows A ... B-1 only; "N": middle_rows
    frames: int = 1
    broken: int = 0  # faults of a stream instead of frames
    stall_percent: int = 0
    seed: int = 1
    fit: str = "none"
    simulator: str = "ghdl"
    rtl: Path | None = None  # default: generated_rtl/FAMILY/CONFIG
    out: Path | None = None  # default: build/cosim/CONFIG-SIMULATOR
    wave: Path | None = None
    watchdog_seconds: float = 300.0

    def out_directory(self) -> Path:
        return self.out or ROOT / "build" / "cosim" / f"{self.config}-{self.simulator}"

    def command(self) -> str:
        """The words that run it again."""
        words: list[Word] = ["scripts/cosim.py", "--config", self.config, "--left", self.left, "--right", self.right]
        for option, value, default in (
            ("--rows", self.rows, None),
            ("--frames", self.frames, 1),
            ("--broken", self.broken, 0),
            ("--stall-percent", self.stall_percent, 0),
            ("--fit", self.fit, "none"),
            ("--rtl", self.rtl, None),
        ):
            if value is not None and value != default:
                words += [option, value]
        return shlex.join(str(word) for word in [*words, "--seed", self.seed, "--simulator", self.simulator])


def middle_rows(parameters: Parameters, least: int) -> str | None:
    """The fewest rows around the middle, `least` or more, that give an output, as "A:B"; None when only the whole frame
    does."""
    lanes, height = parameters["pixels_per_clock"], parameters["height_px"]
    groups = max(-(-least // lanes), -(-parameters["groups_to_first_output"] // parameters["width_px"]))
    rows = groups * lanes
    if rows >= height:
        return None
    first = (height - rows) // 2
    return f"{first}:{first + rows}"


def make_vectors(job: Job, directory: Path) -> tuple[Path, Path]:
    """(stimulus, expectation)"""
    command: list[Word] = [find_stereo_hls(), "vectors", "--config", job.config, "--left", job.left]
    command += ["--right", job.right, "--stall-percent", job.stall_percent]
    command += ["--broken", job.broken] if job.broken else ["--frames", job.frames]
    command += ["--seed", job.seed, "--fit", job.fit, "--out", directory]
    if job.rows is not None:
        command += ["--rows", job.rows]
    notices = run(command, passes_errors=True)
    print(notices, end="")
    return directory / "stimulus.txt", directory / "expected.txt"


def run_job(job: Job) -> Report:
    """Runs one co-simulation, writes report.json and junit.xml, prints the summary. Returns the report."""
    parameters = configuration(job.config)
    if job.rows is not None and re.fullmatch("[1-9][0-9]*", job.rows):
        job = dataclasses.replace(job, rows=middle_rows(parameters, int(job.rows)))
    _check_wave(job)
    files = _vhdl_files(job)
    out = _empty_folder(job)
    stimulus_path, expected_path = make_vectors(job, out)
    stimulus = vectors.read_stimulus(stimulus_path)
    expected, _ = vectors.read_expected(expected_path)

    simulator = _simulator(job, files, parameters)
    started = time.monotonic()
    print(f"{job.config}: building the {job.simulator} simulation ...", flush=True)
    simulator.build()
    build_seconds = time.monotonic() - started

    seconds = _simulate(job, simulator, stimulus_path, out / "observed.txt", len(stimulus))
    observed, clocks = vectors.read_observed(out / "observed.txt")
    if clocks != len(stimulus):
        raise FlowError(f"the simulation ran {clocks} of {len(stimulus)} clocks", EXIT_TOOL_FAILED)

    verdict = checker.compare(expected, observed, parameters["disparity_bits"])
    timing = checker.count_frames(observed) if job.broken else checker.measure(stimulus, observed, parameters)
    report = make_report(job, verdict, timing, clocks, seconds, build_seconds)
    if job.wave is not None:
        report["wave"] = _dump_wave(job.wave, job, simulator, verdict, clocks)
    (out / "report.json").write_text(json.dumps(report, indent=2) + "\n")
    write_junit(out / "junit.xml", report, seconds)
    print(summary(report))
    if verdict.first_mismatch:
        _explain(job, parameters, simulator, verdict.first_mismatch, clocks)
    return report


def exit_code(report: Report) -> int:
    return EXIT_OK if report["passed"] else EXIT_MISMATCH


def make_report(
    job: Job,
    verdict: checker.Verdict,
    timing: checker.Timing,
    clocks: int,
    seconds: float,
    build_seconds: float,
) -> Report:
    first = verdict.first_mismatch
    return {
        "config": job.config,
        "command": job.command(),
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


# --- steps of run_job -------------------------------------------------------------------------------------------------


def _check_wave(job: Job) -> None:
    if job.wave is None:
        return
    allowed = SIMULATORS[job.simulator].wave_suffixes
    if job.wave.suffix not in allowed:
        raise FlowError(
            f"--wave with {job.simulator} takes a name that ends in {' or '.join(allowed)}, not {job.wave.name}"
        )
    try:
        job.wave.resolve().parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create the folder of --wave {job.wave}: {error.strerror}") from None


def _vhdl_files(job: Job) -> list[Path]:
    if job.simulator == "original":
        return original_files(job.config)
    return manifest.vhdl_files(job.rtl) if job.rtl else manifest.core_files(job.config)


def _empty_folder(job: Job) -> Path:
    """The folder for the results, without those of an earlier run."""
    out = job.out_directory()
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FlowError(f"cannot create {out}: {error.strerror}") from None
    for stale in ("report.json", "junit.xml", *mismatch.FILES):
        (out / stale).unlink(missing_ok=True)
    return out


def _simulator(job: Job, files: list[Path], parameters: Parameters) -> Simulator:
    folder = SIMULATIONS / f"{job.config}-{job.simulator}{'-trace' if job.wave else ''}"
    lanes, bits = parameters["pixels_per_clock"], parameters["disparity_bits"]
    return SIMULATORS[job.simulator](job.config, files, folder, lanes, bits, trace=job.wave is not None)


def _simulate(job: Job, simulator: Simulator, stimulus: Path, observed: Path, clocks: int) -> float:
    """The seconds that it took."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TextColumn("clocks"))
    with Progress(*columns, TimeRemainingColumn()) as bar:
        task = bar.add_task(f"{job.config} in {job.simulator}", total=clocks)
        seconds = simulator.run(
            stimulus, observed, lambda clock: bar.update(task, completed=clock), job.watchdog_seconds
        )
        bar.update(task, completed=clocks)
    return seconds


def _rerun(job: Job, simulator: Simulator, wave: Path, window: Clocks) -> None:
    """Simulates again, for a waveform."""
    out = job.out_directory()
    observed = out / "observed_wave.txt"
    simulator.run(out / "stimulus.txt", observed, lambda clock: None, job.watchdog_seconds, wave.resolve(), window)
    observed.unlink(missing_ok=True)


def _dump_wave(wave: Path, job: Job, simulator: Simulator, verdict: checker.Verdict, clocks: int) -> str:
    """Around the first mismatch, or the first clocks when there is none."""
    around = verdict.first_mismatch.clock if verdict.first_mismatch else mismatch.CLOCKS_BEFORE
    _rerun(job, simulator, wave, mismatch.window(around, clocks))
    return str(wave.resolve())


def _explain(job: Job, parameters: Parameters, simulator: Simulator, first: checker.Mismatch, clocks: int) -> None:
    """Waveform and page of the first mismatch. A model of Verilator has no waveform built in: GHDL runs the same VHDL
    for it."""

    def dump(path: Path, window: Clocks) -> None:
        if first.clock > AUTOMATIC_WAVE_CLOCKS:
            raise FlowError(f"it lies beyond clock {AUTOMATIC_WAVE_CLOCKS:,}; --wave FILE makes one")
        source = simulator
        if not isinstance(simulator, Ghdl):
            folder = SIMULATIONS / f"{job.config}-ghdl"
            source = Ghdl(job.config, simulator.vhdl_files, folder, simulator.pixels, simulator.disparity_bits)
            source.build()
        _rerun(job, source, path, window)

    for line in mismatch.explain(job.out_directory(), parameters, first, clocks, dump):
        print(line)
