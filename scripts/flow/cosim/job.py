# SPDX-License-Identifier: Apache-2.0
"""Co-simulation: the C++ core makes stimulus and expectation, a simulator runs the VHDL, the checker compares."""

from __future__ import annotations

import dataclasses
import re
import shlex
import tempfile
import time
from pathlib import Path

from ..base import committed, files, locks, progress, rtl
from ..base.configurations import Parameters, configuration, designs
from ..base.errors import EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.facts import facts
from ..base.places import build_folder, results_folder
from ..base.tools import Word, find_stereo_hls, run
from ..synthesis import generate, manifest
from ..synthesis.bambu import original_files
from ..synthesis.lowering.naming import Trace, read_trace
from ..synthesis.presentation import scalars
from . import checker, coverage, mismatch, registers, report, vectors
from .report import Report, summary
from .simulators import IN_GHDL, SIMULATORS, Clocks, CoreSimulation, Covered, Ghdl

AUTOMATIC_WAVE_CLOCKS = 100_000  # later mismatches would take GHDL minutes
STAGE_DISPARITIES = 16  # of the scene that a stage gets

OF_LAST_RUN = ("report.json", "junit.xml", *mismatch.FILES)  # a run that breaks off leaves none of them
RESULTS = (*OF_LAST_RUN, "stimulus.txt", "expected.txt", "observed.txt", *coverage.FILES)


@dataclasses.dataclass(frozen=True)
class Job:
    config: str
    stress: bool = True  # the stream that is made to find faults; the images' stream comes behind it
    stress_clocks: int | None = None  # at least so many of it; None: what the program sends
    left: Path | None = None  # None: a generated scene, where its stream is wanted
    right: Path | None = None
    stimulus: Path | None = None  # vectors of one's own instead of images
    expected: Path | None = None
    rows: str | None = None  # "A:B", image rows A ... B-1 only; "N": middle_rows
    frames: int = 1
    broken: int = 0  # faults of a stream instead of frames
    stall_percent: int = 0
    seed: int = 1
    fit: str = "none"
    simulator: str = "ghdl"
    rtl: Path | None = None  # default: that of the committed VHDL
    allow_edited: bool = False  # VHDL that differs from its manifest
    out: Path | None = None  # default: build/cosim/CONFIG-SIMULATOR
    wave: Path | None = None
    coverage: bool = False  # count what the stream moves
    watchdog_seconds: float = 300.0

    @property
    def has_images(self) -> bool:
        """Whether the stream of a pair is sent: with --stimulus scene, or where an option says something of it."""
        said = self.left or self.rows or self.frames != 1 or self.broken or self.stall_percent
        return not self.stimulus and (not self.stress or bool(said))

    def out_directory(self) -> Path:
        return self.out or build_folder() / "cosim" / f"{self.config}-{self.simulator}"

    def command(self) -> str:
        """The words that run it again."""
        words: list[Word] = ["scripts/cosim.py", "--config", self.config]
        for option, value, default in (
            ("--left", self.left, None),
            ("--right", self.right, None),
            ("--stimulus", self.stimulus or (None if self.stress else "scene"), None),
            ("--stress-clocks", self.stress_clocks, None),
            ("--expected", self.expected, None),
            ("--rows", self.rows, None),
            ("--frames", self.frames, 1),
            ("--broken", self.broken, 0),
            ("--stall-percent", self.stall_percent, 0),
            ("--fit", self.fit, "none"),
            ("--rtl", self.rtl, None),
        ):
            if value is not None and value != default:
                words += [option, value]
        words += ["--allow-edited"] if self.allow_edited else []
        words += ["--coverage"] if self.coverage else []
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


def make_vectors(job: Job, directory: Path, parameters: Parameters) -> tuple[Path, Path, int | None]:
    """(stimulus, expectation, clock in which the images' stream begins; None where there is none)"""
    stimulus, expected = directory / "stimulus.txt", directory / "expected.txt"
    if job.stimulus is not None and job.expected is not None:
        for path, copy in ((job.stimulus, stimulus), (job.expected, expected)):
            _copy(path, copy)
        return stimulus, expected, None
    words = _stream(job, directory, parameters)
    said = run([find_stereo_hls(), "vectors", *words, "--out", directory], passes_errors=True)
    print(said, end="")
    if not job.has_images:
        return stimulus, expected, None
    begin = re.search(r"the images begin at clock (\d+)", said)
    return stimulus, expected, int(begin[1]) if begin else 0


def _stream(job: Job, directory: Path, parameters: Parameters) -> list[Word]:
    """The words of `vectors` and `trace` that say which stream is sent."""
    words: list[Word] = ["--config", job.config, "--seed", job.seed, *(["--stress"] if job.stress else [])]
    if job.stress and job.stress_clocks is not None:
        words += ["--stress-clocks", job.stress_clocks]
    if not job.has_images:
        return words
    left, right = _pair(job, directory, parameters)
    words += ["--left", left, "--right", right, "--stall-percent", job.stall_percent, "--fit", job.fit]
    words += ["--broken", job.broken] if job.broken else ["--frames", job.frames]
    return words + (["--rows", job.rows] if job.rows is not None else [])


def _copy(path: Path, copy: Path) -> None:
    try:
        files.write(copy, path.read_bytes())
    except OSError as error:
        raise FlowError(f"cannot read vector file {path}: {error.strerror}") from None


def _pair(job: Job, directory: Path, parameters: Parameters) -> tuple[Path, Path]:
    """The images; a generated scene is made."""
    if job.left is not None and job.right is not None:
        return job.left, job.right
    scene = directory / "scene"
    command: list[Word] = [find_stereo_hls(), "scene", "--seed", job.seed, "--out", scene]
    if not rtl.is_stage(parameters):
        command += ["--config", job.config]
    else:
        command += ["--width", parameters["width_px"], "--height", parameters["height_px"]]
        command += ["--disparities", min(STAGE_DISPARITIES, parameters["width_px"] // 2)]
        command += ["--pixel-bits", rtl.pixel_bits_of(parameters)]
    run(command, passes_errors=True)
    return scene / "left.png", scene / "right.png"


def run_job(job: Job) -> Report:
    """Runs one co-simulation, writes report.json and junit.xml, prints the summary. Returns the report. An error is
    written, too."""
    if job.out is None and not re.fullmatch(r"\w+", job.config):
        configuration(job.config, designs())  # no name of a folder
    out = results_folder(job.out_directory(), RESULTS)
    with locks.exclusive(out):
        for stale in OF_LAST_RUN:
            (out / stale).unlink(missing_ok=True)
        try:
            return _run(job, out)
        except FlowError as error:
            report.write_failure(out, job.config, job.command(), job.simulator, job.seed, error)
            raise


def _run(job: Job, out: Path) -> Report:
    parameters = configuration(job.config, designs())
    kind = rtl.kind_of(parameters)
    if job.rows is not None and re.fullmatch("[1-9][0-9]*", job.rows):
        job = dataclasses.replace(job, rows=middle_rows(parameters, int(job.rows)) or f"0:{parameters['height_px']}")
    _check_wave(job)
    design, edited = _vhdl_files(job, parameters)
    stimulus_path, expected_path, images_from = make_vectors(job, out, parameters)
    given = (job.stimulus or stimulus_path, job.expected or expected_path)  # the user's own name in a message
    stimulus = vectors.read_stimulus(given[0], kind)
    expected, _ = vectors.read_expected(given[1])
    if not expected:
        raise FlowError(f"{given[1]} has no outputs: there is nothing to compare")
    for path in given:
        vectors.check_fits(path, job.config, parameters)

    simulation = _simulation(job, design, parameters)
    started = time.monotonic()
    print(f"{job.config}: building the {job.simulator} simulation ...", flush=True)
    is_new = simulation.build()
    build_seconds = time.monotonic() - started

    seconds = _simulate(job, simulation, stimulus_path, out / "observed.txt", len(stimulus))
    observed, clocks = vectors.read_observed(out / "observed.txt")
    if clocks != len(stimulus):
        raise FlowError(f"the simulation ran {clocks} of {len(stimulus)} clocks", EXIT_TOOL_FAILED)

    verdict = checker.compare(expected, observed, vectors.row_bits(parameters), " and ".join(reversed(kind.word)))
    if images_from is None or job.broken:
        timing = checker.count_frames(observed)  # its frames have no common length
    else:
        timing = checker.measure(*checker.part_from(images_from, stimulus, observed), parameters)
    result = make_report(job, verdict, timing, clocks, seconds, build_seconds)
    result["is_cached"] = not is_new
    result["tools"] = simulation.simulator.tools()
    result["environment"] = facts()
    if edited:
        result["edited"] = edited
    if job.coverage:
        result["coverage"] = _coverage(simulation, out)
    if job.wave is not None:
        result["wave"] = _dump_wave(job.wave, job, simulation, verdict, clocks)
    report.write(out, result)
    print(summary(result))
    if verdict.first_mismatch:
        _explain(job, parameters, simulation, verdict.first_mismatch, clocks)
    return result


def _coverage(simulation: CoreSimulation, out: Path) -> coverage.Coverage:
    print(f"{simulation.config}: what has never moved is given to yosys-abc ...", flush=True)
    texts = {path.name: path.read_text() for path in simulation.vhdl_files}
    with tempfile.TemporaryDirectory() as work:
        verilog = Covered.verilog(simulation.work, simulation.design.top)
        found = coverage.read(out / coverage.DATA, verilog, texts, simulation.design.top, Path(work))
    coverage.write(out, found, out / coverage.DATA)
    return found


def exit_code(result: Report) -> int:
    return EXIT_OK if result["passed"] else EXIT_MISMATCH


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


def _simulations() -> Path:
    """What was built for any run."""
    return build_folder() / "cosim" / "simulators"


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


def _vhdl_files(job: Job, parameters: Parameters) -> tuple[list[Path], list[str]]:
    """(in compile order, those that are not what their manifest says)"""
    if job.simulator == "original":
        if rtl.is_stage(parameters):
            raise FlowError(f"--simulator original is for matching cores; {job.config} is a stage")
        return original_files(job.config), []
    folder = job.rtl.resolve() if job.rtl else committed.folder(job.config)
    entry = manifest.read(folder)
    if entry["configuration"] != job.config:
        raise FlowError(f"--rtl {job.rtl} is the VHDL of {entry['configuration']}, not of {job.config}")
    if job.allow_edited:
        edited = manifest.edited_files(folder)
        said = [f"{folder / 'manifest.json'}: {reason}" for reason in manifest.edit_reasons(folder)]
        return manifest.vhdl_files(folder, allow_edited=True), edited or said
    made = manifest.vhdl_files(folder)
    for reason in manifest.edit_reasons(folder):
        raise FlowError(f"{folder}: {reason}; --allow-edited takes it, for experiments")
    return made, []


def _simulation(job: Job, design: list[Path], parameters: Parameters) -> CoreSimulation:
    simulator = Covered() if job.coverage else SIMULATORS[job.simulator]
    name = f"{job.config}-coverage" if job.coverage else f"{job.config}-{job.simulator}{'-trace' if job.wave else ''}"
    lanes, bits, kind = parameters["pixels_per_clock"], vectors.row_bits(parameters), rtl.kind_of(parameters)
    folder = _simulations() / name
    if job.wave or job.coverage:
        design = scalars.files(design)
    return CoreSimulation(simulator, job.config, design, folder, lanes, bits, job.wave is not None, kind)


def _simulate(job: Job, simulation: CoreSimulation, stimulus: Path, observed: Path, clocks: int) -> float:
    """The seconds that it took."""
    with progress.bar(f"{job.config} in {job.simulator}", clocks, "clocks") as bar:
        seconds = simulation.run(stimulus, observed, bar.show, job.watchdog_seconds)
        bar.show(clocks)
    return seconds


def _rerun(job: Job, simulation: CoreSimulation, wave: Path, window: Clocks) -> None:
    """Simulates again, for a waveform."""
    out = job.out_directory()
    observed = out / "observed_wave.txt"
    simulation.run(out / "stimulus.txt", observed, lambda clock: None, job.watchdog_seconds, wave.resolve(), window)
    observed.unlink(missing_ok=True)


def _dump_wave(wave: Path, job: Job, simulation: CoreSimulation, verdict: checker.Verdict, clocks: int) -> str:
    """Around the first mismatch, or the first clocks when there is none."""
    around = verdict.first_mismatch.clock if verdict.first_mismatch else mismatch.CLOCKS_BEFORE
    _rerun(job, simulation, wave, mismatch.window(around, clocks))
    return str(wave.resolve())


def _explain(
    job: Job, parameters: Parameters, simulation: CoreSimulation, first: checker.Mismatch, clocks: int
) -> None:
    """Waveform and page of the first mismatch. After a run in another simulator, or of arrays, GHDL runs the same VHDL
    for it with a signal for each register."""

    def dump(path: Path, window: Clocks) -> None:
        if first.clock > AUTOMATIC_WAVE_CLOCKS:
            raise FlowError(f"it lies beyond clock {AUTOMATIC_WAVE_CLOCKS:,}; --wave FILE makes one")
        source, design = simulation, scalars.files(simulation.vhdl_files)
        if job.simulator not in IN_GHDL or design != simulation.vhdl_files:
            folder = _simulations() / f"{job.config}-ghdl"
            lanes, bits = simulation.pixels, simulation.disparity_bits
            source = Ghdl(job.config, design, folder, lanes, bits, kind=simulation.kind)
            source.build()
        _rerun(job, source, path, window)

    has_names = job.simulator != "original" and not job.stimulus
    trace = _CppTrace(job, parameters, scalars.files(simulation.vhdl_files)) if has_names else None
    for line in mismatch.explain(job.out_directory(), parameters, first, clocks, dump, trace):
        print(line)


@dataclasses.dataclass(frozen=True)
class _CppTrace:
    """mismatch.CppTrace of a job."""

    job: Job
    parameters: Parameters
    design: list[Path]

    def of(self, clocks: Clocks) -> Trace:
        first, last = clocks
        words = _stream(self.job, self.job.out_directory(), self.parameters)
        words += ["--first-clock", first, "--clocks", max(last - first + 1, 10)]
        with tempfile.TemporaryDirectory() as folder:
            run([find_stereo_hls(), "trace", *words, "--out", folder], passes_errors=True)
            return read_trace(Path(folder) / "trace.txt")

    def sure_names(self) -> set[str]:
        """Those that change in the trace that gave them."""
        with tempfile.TemporaryDirectory() as folder:
            trace = generate._cpp_trace(self.job.config, designs()[self.job.config], Path(folder))
        return {name for name, values in trace.items() if len(set(values)) > 1}

    def reset_names(self) -> set[str]:
        return set().union(*(registers.reset_in(path.read_text()) for path in self.design))
