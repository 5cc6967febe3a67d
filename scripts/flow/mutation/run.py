# SPDX-License-Identifier: Apache-2.0
"""Mutation run: do the tests notice single faults in the VHDL? Each mutant goes through stages of tests, cheap ones first,
until one of them fails."""

import hashlib
import json
import random
import shutil
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from ..base.configurations import configuration
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import GENERATED_RTL, ROOT, find_ghdl, find_stereo_hls, run
from ..cosim import checker, simulators, vectors
from ..cosim.simulators import GHDL_STANDARD, Ghdl
from ..shell import broken, cocotb_runs, contract, design, formal, pool, script
from ..synthesis import manifest
from . import mutants

CONFIG = "tiny"
WORK = ROOT / "build" / "mutation"
EXPLANATIONS = ROOT / "hls_tb" / "mutation" / "equivalent.json"
WATCHDOG_SECONDS = 120
# (grey levels, distance between them, bubbles in percent) of the co-simulations of the core alone, two frames each
CORE_RUNS = ((4, 85, 10), (4, 1, 20), (256, 1, 0), (2, 255, 50))
CONFIG_OF_SHORT_FRAMES = "tiny_all_p4"  # shorter than their way through the core: a third frame has to wait
# (configuration, module, tests or None for all, generics that differ) of the stages of the shell
SHELL_STAGES = (
    (CONFIG, "test_stereo_ip", ["full_speed", "stalls_30_30"], {}),
    (CONFIG, "test_registers", None, {}),
    (CONFIG, "test_stereo_ip", None, {}),
    (CONFIG, "test_stereo_ip", ["full_speed", "gaps_of_all_lengths", "mixture"], {"gap_groups": 33}),
    (
        CONFIG,
        "test_stereo_ip",
        ["full_speed", "gaps_of_all_lengths", "mixture"],
        {"gap_groups": 40, "flush_groups": 60},
    ),
    (CONFIG, "test_generics", ["wrong_latency"], {"latency_clocks": 14}),
    (CONFIG, "test_generics", ["wrong_latency"], {"latency_clocks": 16}),
    (CONFIG, "test_generics", ["starts_disabled"], {"enabled_at_reset": "false"}),
    (CONFIG_OF_SHORT_FRAMES, "test_stereo_ip", ["stalls_0_10", "mixture"], {}),
)
# What the co-simulation of the core alone does not do: more flush groups than needed, resets, frames that join a flush.
CORE_STAGES = (
    (CONFIG, "test_stereo_ip", ["full_speed"], {"gap_groups": 40, "flush_groups": 60}),
    (CONFIG, "test_stereo_ip", ["reset_at_any_clock", "gaps_of_all_lengths", "mixture"], {}),
)


@dataclass
class Verdict:
    mutant: mutants.Mutant
    outcome: str  # killed, survived, or invalid: it does not compile
    by: str = ""  # what noticed it
    seconds: float = 0.0


def core_files():
    return manifest.vhdl_files(GENERATED_RTL / CONFIG)


def compiles(files, folder):
    try:
        run([find_ghdl(), "-a", GHDL_STANDARD, *files], cwd=folder, log=folder / "compile.log")
    except FlowError:
        return False
    return True


class Core:
    """Mutants of the core: co-simulation with the C++ core, then inside the shell."""

    def __init__(self):
        self.parameters = configuration(CONFIG)
        self.runs = []
        for number, (levels, distance, stalls) in enumerate(CORE_RUNS):
            folder = WORK / f"vectors_{number}"
            folder.mkdir(parents=True, exist_ok=True)
            generator = random.Random(number)
            for side in ("left", "right"):
                pool.write_noise(folder / f"{side}.pgm", self.parameters, generator, levels, distance)
            run(
                [
                    find_stereo_hls(),
                    "vectors",
                    "--config",
                    CONFIG,
                    "--left",
                    folder / "left.pgm",
                    "--right",
                    folder / "right.pgm",
                    "--frames",
                    2,
                    "--stall-percent",
                    stalls,
                    "--out",
                    folder,
                ],
                passes_errors=True,
            )
            self.runs.append(
                (
                    folder,
                    len(vectors.read_stimulus(folder / "stimulus.txt")),
                    vectors.read_expected(folder / "expected.txt")[0],
                )
            )

    def noticed(self, files, folder):
        simulator = Ghdl(files, folder / "core", self.parameters["pixels_per_clock"], self.parameters["disparity_bits"])
        simulator.build()
        for number, (vector_folder, clocks, expected) in enumerate(self.runs):
            observed_path = folder / "observed.txt"
            try:
                simulator.run(vector_folder / "stimulus.txt", observed_path, lambda clock: None, WATCHDOG_SECONDS)
                observed, simulated = vectors.read_observed(observed_path)
            except FlowError as error:
                return f"co-simulation {number}: {error}"
            verdict = checker.compare(expected, observed, self.parameters["disparity_bits"])
            if not verdict.passed or simulated != clocks:
                return f"co-simulation {number}: {verdict.first_mismatch}"
        return ""


def refuted(mutant, folder):
    """The proof that a mutant of the memory cell or of a stream block breaks."""
    for number, proof in enumerate(formal.PROOFS):
        if mutant.file.stem == proof.block:
            try:
                outcome, clock = formal.prove(proof, folder / f"proof_{number}", folder / "rtl")
            except FlowError:
                return f"proof {proof.name}: its synthesis fails"
            if outcome != "proved":
                return f"proof {proof.name}: clock {clock}"
    return ""


class Shell:
    """Mutants of the shell, and of the core where the core alone shows nothing: the cocotb tests."""

    def __init__(self, stages=SHELL_STAGES):
        self.stages = stages
        self.pools = {config: WORK / f"pool_{config}" for config, *_ in stages}
        for config, path in self.pools.items():
            pool.make_pool(config, configuration(config), cocotb_runs.PAIRS, 1, path)

    def noticed(self, core, shell, folder):
        """`core`: the files of CONFIG's core."""
        for number, (config, module, tests, generics) in enumerate(self.stages):
            cores = core if config == CONFIG else manifest.vhdl_files(GENERATED_RTL / config)
            simulation = cocotb_runs.Ghdl(config, folder / f"shell_{config}", [*cores, *shell], generics)
            simulation.build()
            try:
                results = simulation.run(
                    module,
                    1,
                    folder / f"stage_{number}",
                    tests,
                    watchdog_seconds=WATCHDOG_SECONDS,
                    pool_folder=self.pools[config],
                    stop_at_failure=True,
                )
            except FlowError as error:
                return f"{module}: {str(error).rpartition(' / ')[2]}"
            failed = [result.name for result in results if not result.passed]
            if failed:
                return f"{module}: {failed[0]}"
        return ""


class EarlierVerdicts:
    """Verdicts of earlier runs on the same sources and tests, so that an interrupted run goes on where it was."""

    def __init__(self):
        judges = (broken, checker, cocotb_runs, contract, formal, mutants, pool, script, simulators, vectors)
        tests = [
            *sorted((ROOT / "hls_tb" / "axi").glob("*.py")),
            *sorted((ROOT / "hls_tb" / "formal").iterdir()),
            *(Path(module.__file__) for module in judges),
        ]
        others = manifest.vhdl_files(GENERATED_RTL / CONFIG_OF_SHORT_FRAMES)
        sources = [
            *core_files(),
            *design.shell_files(),
            *others,
            Path(__file__),
            *(path for path in tests if path.name != "diagrams.py"),
        ]
        digest = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
        WORK.mkdir(parents=True, exist_ok=True)
        self.path = WORK / f"verdicts_{digest}.jsonl"
        lines = self.path.read_text().splitlines() if self.path.is_file() else []
        self.known = {entry["key"]: entry for entry in map(json.loads, lines)}

    def recall(self, mutant):
        entry = self.known.get(mutant.key)
        return Verdict(mutant, entry["outcome"], entry["by"], entry["seconds"]) if entry else None

    def keep(self, verdict):
        entry = {
            "key": verdict.mutant.key,
            "outcome": verdict.outcome,
            "by": verdict.by,
            "seconds": round(verdict.seconds, 1),
        }
        with self.path.open("a") as file:
            file.write(json.dumps(entry) + "\n")


class Run:
    """A number of mutants of the core and of the shell, some at a time."""

    def __init__(self, seed, core_count, shell_count, jobs=2, say=print):
        self.seed, self.counts, self.jobs, self.say = seed, (core_count, shell_count), jobs, say
        self.core, self.shell, self.core_in_shell = Core(), Shell(), Shell(CORE_STAGES)
        self.explanations = json.loads(EXPLANATIONS.read_text())
        self.earlier = EarlierVerdicts()
        self.verdicts = []
        self.lock = threading.Lock()

    def judge(self, mutant, is_core, number):
        folder = WORK / "mutants" / f"{'core' if is_core else 'shell'}_{number}"
        shutil.rmtree(folder, ignore_errors=True)
        changed = mutants.write(mutant, folder / "rtl")
        core, shell = (
            [changed if path.name == changed.name else path for path in files]
            for files in (core_files(), design.shell_files())
        )
        (folder / "compile").mkdir()
        started = time.monotonic()
        if not compiles([*core, *shell], folder / "compile"):
            return Verdict(mutant, "invalid")
        if is_core:
            by = (
                refuted(mutant, folder)
                or self.core.noticed(core, folder)
                or self.core_in_shell.noticed(core, shell, folder)
            )
        else:
            by = refuted(mutant, folder) or self.shell.noticed(core, shell, folder)
        shutil.rmtree(folder, ignore_errors=True)
        return Verdict(mutant, "killed" if by else "survived", by, time.monotonic() - started)

    def _next(self, stream, is_core, count):
        """Judges mutants from a stream until `count` of them compiled; runs in several threads."""
        while True:
            with self.lock:
                if self.started[is_core] >= count:
                    return
                mutant = next(stream, None)
                if mutant is None:
                    return
                self.started[is_core] += 1
                self.number += 1
                number = self.number
            verdict = self.earlier.recall(mutant)
            fresh = verdict is None
            verdict = verdict or self.judge(mutant, is_core, number)
            with self.lock:
                if fresh:
                    self.earlier.keep(verdict)
                if verdict.outcome == "invalid":
                    self.started[is_core] -= 1
                    continue
                self.verdicts.append(verdict)
                if verdict.outcome == "survived":
                    known = " (explained as equivalent)" if mutant.key in self.explanations else ""
                    self.say(f"survived{known}: {mutant.key}")
                elif len(self.verdicts) % 10 == 0:
                    self.say(f"{len(self.verdicts)} mutants ...")

    def run(self):
        self.number, self.started = 0, {True: 0, False: 0}
        for is_core, files, count in (
            (True, core_files(), self.counts[0]),
            (False, design.shell_files(), self.counts[1]),
        ):
            stream = mutants.shuffled(files, self.seed)
            with ThreadPoolExecutor(self.jobs) as workers:
                for future in [workers.submit(self._next, stream, is_core, count) for _ in range(self.jobs)]:
                    future.result()
        return self

    def report(self, out):
        """Writes report.json, prints the summary; returns (score in percent, survivors without explanation)."""
        if not self.verdicts:
            raise FlowError("no mutant compiled", EXIT_TOOL_FAILED)
        survived = [v.mutant.key for v in self.verdicts if v.outcome == "survived"]
        open_ones = sorted(key for key in survived if key not in self.explanations)
        wrong = sorted(
            v.mutant.key for v in self.verdicts if v.outcome == "killed" and v.mutant.key in self.explanations
        )
        killed = len(self.verdicts) - len(survived)
        counted = killed + len(open_ones)
        score = 100 * killed / counted if counted else 0.0
        result = {
            "seed": self.seed,
            "mutants": len(self.verdicts),
            "killed": killed,
            "equivalent": len(survived) - len(open_ones),
            "survivors": open_ones,
            "explained_but_killed": wrong,
            "score_percent": round(score, 2),
            "kinds": {
                kind: sum(v.mutant.kind == kind for v in self.verdicts)
                for kind in sorted({v.mutant.kind for v in self.verdicts})
            },
            "verdicts": [
                {
                    "key": v.mutant.key,
                    "kind": v.mutant.kind,
                    "outcome": v.outcome,
                    "by": v.by,
                    "seconds": round(v.seconds, 1),
                }
                for v in self.verdicts
            ],
        }
        Path(out).mkdir(parents=True, exist_ok=True)
        (Path(out) / "report.json").write_text(json.dumps(result, indent=2) + "\n")
        for key in wrong:
            self.say(f"explained as equivalent, but killed: {key}")
        self.say(
            f"{len(self.verdicts)} mutants, {killed} killed, {result['equivalent']} equivalent, {len(open_ones)} survived: score {score:.2f} %; "
            f"seed {self.seed}; {Path(out) / 'report.json'}"
        )
        return score, open_ones + wrong
