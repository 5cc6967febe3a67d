# SPDX-License-Identifier: Apache-2.0
"""Mutation run: do the tests notice single faults in the VHDL? Each mutant goes through stages of tests, cheap ones
first, until one of them fails. What passes the cheap ones may be no fault at all: a proof of that ends the tests."""

from __future__ import annotations

import hashlib
import json
import shutil
import threading
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base import aiger, files, ghdl, json_lines
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Say
from ..cosim import bench, checker, simulators, vectors
from ..shell import broken, cocotb_runs, contract, design, formal, pool, script, selections
from ..simulation import simulation, simulators as programs
from ..synthesis import manifest
from ..synthesis.presentation import scalars
from . import arguments, batch, differences, equivalence, judges, memories, mutants, record, schemata, shared
from .batch import Batch
from .equivalence import Design, NotSynthesizedError, Prover
from .judges import CONFIG_OF_SHORT_FRAMES, WORK, Core, Shell, compiles, refuted, shell_stages


@dataclass
class Verdict:
    mutant: mutants.Mutant
    outcome: str  # killed, equivalent, argued, survived, or invalid: it does not compile
    by: str = ""  # what noticed it; of a survivor why it may show
    seconds: float = 0.0

    def entry(self) -> dict[str, Any]:
        """As it stands in files."""
        return {
            "key": self.mutant.key,
            "kind": self.mutant.kind,
            "outcome": self.outcome,
            "by": self.by,
            "seconds": round(self.seconds, 1),
        }


class EarlierVerdicts:
    """Verdicts of earlier runs on the same sources and tests, so that an interrupted run goes on where it was. A proof
    holds with any stimulus. What has survived or is argued is judged again."""

    def __init__(self, config: str, stimuli: list[Path]) -> None:
        """`stimuli`: of the core's co-simulation."""
        self.stimulus = _digest(stimuli)
        WORK.mkdir(parents=True, exist_ok=True)
        self.path = WORK / f"verdicts_{_digest(self._sources(config))}.jsonl"
        kept = {entry.get("key", ""): entry for entry in json_lines.read(self.path)}
        fields = {"outcome", "by", "seconds", "stimulus"}
        self.known = {key: entry for key, entry in kept.items() if fields <= entry.keys()}

    @staticmethod
    def _sources(config: str) -> list[Path]:
        """Everything that decides a verdict."""
        of_base = (aiger, ghdl, simulation, programs)
        of_shell = (broken, cocotb_runs, contract, design, formal, pool, script, selections)
        of_cosim = (bench, checker, simulators, vectors)
        of_mutation = (batch, differences, equivalence, judges, memories, mutants, schemata, shared)
        modules = (*of_base, *of_shell, *of_cosim, *of_mutation)
        benches = sorted((ROOT / "hls_tb" / "shell").glob("*.py"))
        return [
            *manifest.core_files(config),
            *design.shell_files(),
            *manifest.core_files(CONFIG_OF_SHORT_FRAMES),
            *manifest.core_files(selections.SETTINGS.config),
            *(path for path in benches if path.name != "diagrams.py"),
            *sorted((ROOT / "hls_tb" / "formal").iterdir()),
            *(Path(str(module.__file__)) for module in modules),
            batch.BENCH,
            bench.CPP_SHARED,
            Path(__file__),
        ]

    def recall(self, mutant: mutants.Mutant) -> Verdict | None:
        entry = self.known.get(mutant.key)
        if entry is None or entry["outcome"] not in ("killed", "equivalent", "invalid"):
            return None
        if entry["outcome"] == "killed" and entry["stimulus"] != self.stimulus:
            return None
        return Verdict(mutant, entry["outcome"], entry["by"], entry["seconds"])

    def keep(self, verdict: Verdict) -> None:
        json_lines.append(self.path, {**verdict.entry(), "stimulus": self.stimulus})


def _digest(paths: list[Path]) -> str:
    return hashlib.sha256(b"".join(path.read_bytes() for path in paths)).hexdigest()[:16]


class Run:
    """A number of mutants of the core and of the shell, some at a time."""

    def __init__(
        self,
        seeds: Sequence[int],
        core_count: int,
        shell_count: int,
        jobs: int = 2,
        say: Say = print,
        config: str = "tiny",
        together: bool = False,
        others: int = 0,
    ) -> None:
        """So many of the core and of the shell for each seed. `together`: those of the core in one build; then streams
        of `others` other seeds look for what the default one does not show."""
        self.others = others
        self.core_files = scalars.files(manifest.core_files(config))  # a fault in one register, not in all of a loop
        self.seeds, self.counts, self.jobs, self.say = seeds, (core_count, shell_count), jobs, say
        self.batch: Batch | None = None
        # Each for mutants of the core and for those of the shell.
        self.short: dict[bool, Core | Shell] = {}
        self.provers: dict[bool, Prover] = {}
        if core_count:
            self.core = Core(config)
            self.short[True] = self.core
            if together:
                streams = mutants.samples(self.core_files, seeds)
                self.batch = Batch(self.core, self.core_files, streams, core_count, WORK / f"together_{config}")
            self._prove_with(True, config, [Design(config, True)])
        if shell_count:
            short, thorough = shell_stages(config)
            self.short[False] = Shell(config, short)
            self.thorough = Shell(config, thorough)
            variants = {(stage.config, *stage.generics.items()): stage for stage in (*short, *thorough)}
            self._prove_with(False, config, [Design(one.config, False, one.generics) for one in variants.values()])
        stimuli = [self.core.stimulus] if core_count else []
        self.config, self.earlier, self.began = config, EarlierVerdicts(config, stimuli), time.monotonic()
        self.verdicts: list[Verdict] = []
        self.number, self.started = 0, {True: 0, False: 0}  # of mutants, of those of the core and of the shell
        self.lock = threading.Lock()

    def _prove_with(self, is_core: bool, config: str, designs: list[Design]) -> None:
        work = WORK / f"originals_{config}_{is_core}"
        self.provers[is_core] = Prover(designs, self.core_files, design.shell_files(), work)

    def judge(self, mutant: mutants.Mutant, is_core: bool, number: int) -> Verdict:
        folder = WORK / "mutants" / f"{self.config}_{'core' if is_core else 'shell'}_{number}"
        shutil.rmtree(folder, ignore_errors=True)
        if is_core and self.batch and mutant.key in self.batch.known:
            folder.mkdir(parents=True)
            return self._of_batch(self.batch, mutant, folder)
        changed = mutants.write(mutant, folder / "rtl")
        core, shell = (
            [changed if path.name == changed.name else path for path in files]
            for files in (self.core_files, design.shell_files())
        )
        (folder / "compile").mkdir()
        started = time.monotonic()
        if not compiles([*core, *shell], folder / "compile"):
            return Verdict(mutant, "invalid")
        by = refuted(mutant, folder) or self.short[is_core].noticed(core, shell, folder)
        try:
            objection = by or self.provers[is_core].objection(core, shell, folder)
        except NotSynthesizedError as error:
            by = objection = f"synthesis: {error}"
        if objection and not by and not is_core:
            by = self.thorough.noticed(core, shell, folder)
        outcome = "killed" if by else "survived" if objection else "equivalent"
        shutil.rmtree(folder, ignore_errors=True)
        return Verdict(mutant, outcome, objection if outcome == "survived" else by, time.monotonic() - started)

    def _of_batch(self, batch: Batch, mutant: mutants.Mutant, folder: Path) -> Verdict:
        """GHDL, which is slow, runs only what is neither shown in Verilator nor proved: it sees values outside their
        ranges, too."""
        started = time.monotonic()
        if mutant in batch.invalid:
            return Verdict(mutant, "invalid")
        by = batch.shown.get(mutant.key, "")
        is_shown = bool(by) or mutant.key in batch.elsewhere
        if not is_shown and (argument := arguments.of(mutant)):  # because the prover gives up on it, after minutes
            shutil.rmtree(folder, ignore_errors=True)
            return Verdict(mutant, "argued", f"{argument.reason}; {argument.test}", time.monotonic() - started)
        objection = by or batch.objection(mutant, folder)
        if objection and not is_shown:
            changed = mutants.write(mutant, folder / "rtl")
            core = [changed if path.name == changed.name else path for path in self.core_files]
            by = self.short[True].noticed(core, [], folder)
        outcome = "killed" if by else "survived" if objection else "equivalent"
        shutil.rmtree(folder, ignore_errors=True)
        return Verdict(mutant, outcome, by or objection, time.monotonic() - started)

    def _next(self, stream: Iterator[mutants.Mutant], is_core: bool, count: int) -> None:
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
                self._show(verdict)

    def _show(self, verdict: Verdict) -> None:
        if verdict.outcome != "killed":
            reason = f" ({verdict.by})" if verdict.by else ""
            self.say(f"{verdict.outcome}{reason}: {verdict.mutant.key}")
        if len(self.verdicts) % 10 == 0:
            every = len(self.seeds) * sum(self.counts)
            self.say(f"{len(self.verdicts)} of {every} mutants, {time.monotonic() - self.began:.0f} s ...")

    def run(self) -> Run:
        if self.batch and any(self.earlier.recall(mutant) is None for mutant in self.batch.inside.values()):
            self.batch.judge(self.others)
            shown, inside = len(self.batch.shown), len(self.batch.inside)
            elsewhere = f", {len(self.batch.elsewhere)} more by other seeds" if self.others else ""
            self.say(f"{shown} of {inside} shown{elsewhere}, {time.monotonic() - self.began:.0f} s ...")
        for is_core, sources, count in (
            (True, self.core_files, self.counts[0]),
            (False, design.shell_files(), self.counts[1]),
        ):
            for number, stream in enumerate(mutants.samples(sources, self.seeds), 1):
                with ThreadPoolExecutor(self.jobs) as workers:
                    for future in [
                        workers.submit(self._next, stream, is_core, number * count) for _ in range(self.jobs)
                    ]:
                        future.result()
        return self

    def report(self, out: Path, is_kept: bool = False) -> int:
        """Writes report.json, prints the summary; returns how many have survived. With `is_kept` the result goes
        beside the VHDL of the core, too."""
        if not self.verdicts:
            raise FlowError("no mutant compiled", EXIT_TOOL_FAILED)
        keys = {
            outcome: [verdict.mutant.key for verdict in self.verdicts if verdict.outcome == outcome]
            for outcome in ("killed", "equivalent", "argued", "survived")
        }
        killed, equivalent, argued, survived = (len(found) for found in keys.values())
        score = 100 * (len(self.verdicts) - survived) / len(self.verdicts)
        seconds = time.monotonic() - self.began
        kinds = [verdict.mutant.kind for verdict in self.verdicts]
        result = {
            "config": self.config,
            "seeds": list(self.seeds),
            "mutants": len(self.verdicts),
            "killed": killed,
            "equivalent": equivalent,
            "argued": argued,
            "survivors": sorted(keys["survived"]),
            "score_percent": round(score, 2),
            "seconds": round(seconds, 1),
            "kinds": {kind: kinds.count(kind) for kind in sorted(set(kinds))},
            "verdicts": [verdict.entry() for verdict in self.verdicts],
        }
        files.write(out / "report.json", json.dumps(result, indent=2) + "\n")
        if is_kept:
            seeds = " ".join(map(str, self.seeds))
            command = f"scripts/mutate.py --config {self.config} --core {self.counts[0]} --shell 0 --seed {seeds}"
            record.keep(self.config, {**result, "command": command})
        self.say(
            f"{self.config}, seed {' '.join(map(str, self.seeds))}: {len(self.verdicts)} mutants, {killed} killed, "
            f"{equivalent} proved equivalent, {argued} argued, {survived} survived: "
            f"score {score:.2f} %, {seconds:.0f} s; {out / 'report.json'}"
        )
        return survived
