# SPDX-License-Identifier: Apache-2.0
"""Mutation run: do the tests notice single faults in the VHDL? Each mutant goes through stages of tests, cheap ones
first, until one of them fails."""

import hashlib
import json
import shutil
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base import ghdl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Say
from ..cosim import checker, simulators, vectors
from ..shell import broken, cocotb_runs, contract, design, formal, pool, script
from ..synthesis import manifest
from . import judges, mutants
from .judges import CONFIG_OF_SHORT_FRAMES, WORK, Core, Shell, compiles, core_stages, refuted, shell_stages

EXPLANATIONS = ROOT / "hls_tb" / "mutation" / "equivalent.json"


@dataclass
class Verdict:
    mutant: mutants.Mutant
    outcome: str  # killed, survived, or invalid: it does not compile
    by: str = ""  # what noticed it
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
    """Verdicts of earlier runs on the same sources and tests, so that an interrupted run goes on where it was."""

    def __init__(self, config: str) -> None:
        digest = hashlib.sha256(b"".join(path.read_bytes() for path in self._sources(config))).hexdigest()[:16]
        WORK.mkdir(parents=True, exist_ok=True)
        self.path = WORK / f"verdicts_{digest}.jsonl"
        lines = self.path.read_text().splitlines() if self.path.is_file() else []
        self.known: dict[str, dict[str, Any]] = {entry["key"]: entry for entry in map(json.loads, lines)}

    @staticmethod
    def _sources(config: str) -> list[Path]:
        """Everything that decides a verdict."""
        modules = (broken, checker, cocotb_runs, contract, formal, ghdl, judges, mutants, pool, script)
        benches = sorted((ROOT / "hls_tb" / "shell").glob("*.py"))
        return [
            *manifest.core_files(config),
            *design.shell_files(),
            *manifest.core_files(CONFIG_OF_SHORT_FRAMES),
            *(path for path in benches if path.name != "diagrams.py"),
            *sorted((ROOT / "hls_tb" / "formal").iterdir()),
            *(Path(str(module.__file__)) for module in (*modules, simulators, vectors)),
            Path(__file__),
        ]

    def recall(self, mutant: mutants.Mutant) -> Verdict | None:
        entry = self.known.get(mutant.key)
        return Verdict(mutant, entry["outcome"], entry["by"], entry["seconds"]) if entry else None

    def keep(self, verdict: Verdict) -> None:
        with self.path.open("a") as file:
            file.write(json.dumps(verdict.entry()) + "\n")


class Run:
    """A number of mutants of the core and of the shell, some at a time."""

    def __init__(
        self, seed: int, core_count: int, shell_count: int, jobs: int = 2, say: Say = print, config: str = "tiny"
    ) -> None:
        self.core_files = manifest.core_files(config)
        self.seed, self.counts, self.jobs, self.say = seed, (core_count, shell_count), jobs, say
        self.core, self.shell = Core(config), Shell(config, shell_stages(config))
        self.core_in_shell = Shell(config, core_stages(config))
        self.explanations: dict[str, str] = json.loads(EXPLANATIONS.read_text())
        self.earlier = EarlierVerdicts(config)
        self.verdicts: list[Verdict] = []
        self.number, self.started = 0, {True: 0, False: 0}  # of mutants, of those of the core and of the shell
        self.lock = threading.Lock()

    def judge(self, mutant: mutants.Mutant, is_core: bool, number: int) -> Verdict:
        folder = WORK / "mutants" / f"{'core' if is_core else 'shell'}_{number}"
        shutil.rmtree(folder, ignore_errors=True)
        changed = mutants.write(mutant, folder / "rtl")
        core, shell = (
            [changed if path.name == changed.name else path for path in files]
            for files in (self.core_files, design.shell_files())
        )
        (folder / "compile").mkdir()
        started = time.monotonic()
        if not compiles([*core, *shell], folder / "compile"):
            return Verdict(mutant, "invalid")
        by = refuted(mutant, folder)
        if is_core:
            by = by or self.core.noticed(core, folder) or self.core_in_shell.noticed(core, shell, folder)
        else:
            by = by or self.shell.noticed(core, shell, folder)
        shutil.rmtree(folder, ignore_errors=True)
        return Verdict(mutant, "killed" if by else "survived", by, time.monotonic() - started)

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
                if verdict.outcome == "survived":
                    known = " (explained as equivalent)" if mutant.key in self.explanations else ""
                    self.say(f"survived{known}: {mutant.key}")
                elif len(self.verdicts) % 10 == 0:
                    self.say(f"{len(self.verdicts)} mutants ...")

    def run(self) -> "Run":
        for is_core, files, count in (
            (True, self.core_files, self.counts[0]),
            (False, design.shell_files(), self.counts[1]),
        ):
            stream = mutants.shuffled(files, self.seed)
            with ThreadPoolExecutor(self.jobs) as workers:
                for future in [workers.submit(self._next, stream, is_core, count) for _ in range(self.jobs)]:
                    future.result()
        return self

    def report(self, out: Path) -> tuple[float, list[str]]:
        """Writes report.json, prints the summary; returns (score in percent, survivors without explanation)."""
        if not self.verdicts:
            raise FlowError("no mutant compiled", EXIT_TOOL_FAILED)
        survived = [v.mutant.key for v in self.verdicts if v.outcome == "survived"]
        killed = [v.mutant.key for v in self.verdicts if v.outcome == "killed"]
        open_ones = sorted(key for key in survived if key not in self.explanations)
        wrong = sorted(key for key in killed if key in self.explanations)
        equivalent = len(survived) - len(open_ones)
        counted = len(killed) + len(open_ones)
        score = 100 * len(killed) / counted if counted else 0.0
        kinds = [v.mutant.kind for v in self.verdicts]
        result = {
            "seed": self.seed,
            "mutants": len(self.verdicts),
            "killed": len(killed),
            "equivalent": equivalent,
            "survivors": open_ones,
            "explained_but_killed": wrong,
            "score_percent": round(score, 2),
            "kinds": {kind: kinds.count(kind) for kind in sorted(set(kinds))},
            "verdicts": [verdict.entry() for verdict in self.verdicts],
        }
        out.mkdir(parents=True, exist_ok=True)
        (out / "report.json").write_text(json.dumps(result, indent=2) + "\n")
        for key in wrong:
            self.say(f"explained as equivalent, but killed: {key}")
        self.say(
            f"{len(self.verdicts)} mutants, {len(killed)} killed, {equivalent} equivalent, {len(open_ones)} survived: "
            f"score {score:.2f} %; seed {self.seed}; {out / 'report.json'}"
        )
        return score, open_ones + wrong
