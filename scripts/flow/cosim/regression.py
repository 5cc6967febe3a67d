# SPDX-License-Identifier: Apache-2.0
"""Many co-simulations as one regression: some at a time, each a command of its own; one line each, one summary.json,
one junit.xml."""

from __future__ import annotations

import fnmatch
import hashlib
import json
import os
import threading
import time
import xml.etree.ElementTree as xml
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from ..base import committed, facts, farm, files, json_files, locks, places, rtl
from ..base.configurations import configuration, designs
from ..base.errors import EXIT_INTERRUPTED, EXIT_MISMATCH, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, find_stereo_hls
from . import overview, record, report
from .simulators import BENCH, SIMULATORS

FORMAT = "stereo-hls regression 1"
ALL = "all"
INTERRUPTED = "interrupted"
RESULTS = ("summary.json", "junit.xml", overview.NAME)  # in the folder of all
Outcome = Literal["pass", "FAIL", "ERROR", "unchanged", "not run"]


def is_pattern(word: str) -> bool:
    return word == ALL or any(sign in word for sign in "*?[")


def select(words: Iterable[str]) -> list[str]:
    """The configurations that names and patterns mean, each once. Patterns are of those whose VHDL was made."""
    table, made = designs(), committed.known_designs()
    chosen: list[str] = []
    for word in words:
        found = fnmatch.filter(made, "*" if word == ALL else word) if is_pattern(word) else [word]
        if not found:
            raise FlowError(f"no configuration with VHDL matches '{word}'; known are: {', '.join(made)}")
        chosen += found
    unknown = [name for name in chosen if name not in table]
    if unknown:
        configuration(unknown[0], table)  # refuses it
    return list(dict.fromkeys(chosen))


@dataclass
class Entry:
    """One configuration of a regression."""

    config: str
    outcome: Outcome = "not run"
    text: str = ""  # why
    seconds: float = 0
    exit_code: int | None = None
    inputs: str = ""  # digest of all that decides the result
    design: Mapping[str, str] = field(default_factory=dict)  # of the VHDL, where the result is kept beside it
    report: dict[str, Any] = field(default_factory=dict)

    def line(self) -> str:
        return f"{self.outcome:9}  {self.config:26}  {self.text}"


@dataclass
class Regression:
    configs: Sequence[str]
    simulator: str
    options: Sequence[str]  # of each command
    inputs: Sequence[Path]  # files that the options name
    out: Path
    farm: farm.Farm
    fails_fast: bool = False
    only_changed: bool = False
    recorded: record.Stimulus | None = None  # as what results go beside the VHDL, all at the end: many share an archive
    _stopped: str = ""  # why no more are started

    def run(self) -> int:
        """Returns the exit code: 1 when anything differs, else the highest of all. What an interruption leaves is
        written before it goes on."""
        places.results_folder(self.out, RESULTS)
        with locks.exclusive(self.out):
            return self._run()

    def _run(self) -> int:
        started = time.monotonic()
        earlier = self._earlier() if self.only_changed else {}
        for name in RESULTS:
            (self.out / name).unlink(missing_ok=True)
        entries = [Entry(config) for config in self.configs]
        lock = threading.Lock()

        def one(entry: Entry) -> None:
            if not self._stopped:
                self._one(entry, earlier)
                if self.fails_fast and entry.outcome in ("FAIL", "ERROR"):
                    self._stopped = self._stopped or "an earlier one failed (--fail-fast)"
            entry.text = entry.text or self._stopped
            with lock:
                print(entry.line(), flush=True)

        with ThreadPoolExecutor(self.farm.threads) as workers:
            try:
                list(workers.map(one, entries))
            except KeyboardInterrupt:
                self._stopped = INTERRUPTED
                self.farm.stop()
                workers.shutdown()
                for entry in entries:
                    entry.text = entry.text or self._stopped
                self._write(entries, EXIT_INTERRUPTED, time.monotonic() - started)
                self._record(entries)
                raise
        code = exit_code(entries)
        self._write(entries, code, time.monotonic() - started)
        self._record(entries)
        return code

    def _record(self, entries: Iterable[Entry]) -> None:
        if self.recorded:
            judged = [(entry.report, entry.design) for entry in entries if entry.outcome in ("pass", "FAIL")]
            record.keep(judged, self.recorded)  # type: ignore[arg-type]

    def _one(self, entry: Entry, earlier: dict[str, Any]) -> None:
        folder = self.out / f"{entry.config}-{self.simulator}"
        try:
            entry.inputs = self._digest(entry.config)
            entry.design = record.design(entry.config) if self.recorded else {}
        except FlowError as error:
            entry.text, entry.outcome, entry.exit_code = str(error), "ERROR", error.exit_code
            return
        before = earlier.get(entry.config, {})
        if before.get("inputs") == entry.inputs and before.get("outcome") in ("pass", "unchanged"):
            entry.outcome, entry.exit_code, entry.text = "unchanged", EXIT_OK, "passed before with the same inputs"
            return
        command = [str(ROOT / "scripts" / "cosim.py"), "--config", entry.config, *self.options]
        command += ["--simulator", self.simulator, "--out", str(folder)]
        (folder / "report.json").unlink(missing_ok=True)
        started = time.monotonic()
        try:
            code = self.farm.call(farm.run_logged, command, folder / "log.txt")
        except FlowError as error:
            if self._stopped != INTERRUPTED:
                entry.text, entry.outcome, entry.exit_code = str(error), "ERROR", error.exit_code
            return
        entry.seconds = time.monotonic() - started
        if self._stopped != INTERRUPTED:
            self._judge(entry, folder, code)

    def _judge(self, entry: Entry, folder: Path, code: int) -> None:
        """The report must say what the exit code says."""
        try:
            entry.report = json_files.load(folder / "report.json")
            says = entry.report["error"]["exit_code"] if "error" in entry.report else report.judged(entry.report)
        except (OSError, ValueError, KeyError, TypeError):
            says = None
        entry.exit_code = code
        if code < 0:  # the kernel's, where memory is short
            entry.outcome, entry.exit_code, entry.text = "ERROR", EXIT_TOOL_FAILED, f"killed by signal {-code}"
        elif code not in (EXIT_OK, EXIT_MISMATCH):
            entry.outcome = "ERROR"
            entry.text = entry.report["error"]["message"] if says == code else _last_line(folder / "log.txt")
        elif says != code:
            entry.outcome, entry.exit_code = "ERROR", EXIT_TOOL_FAILED
            entry.text = f"exit code {code}, but {folder / 'report.json'} does not say so"
        else:
            entry.outcome, entry.text = ("pass" if code == EXIT_OK else "FAIL"), _counted(entry.report)

    def _digest(self, config: str) -> str:
        """Of all that decides the result."""
        program = Path(find_stereo_hls())
        core = Path(os.environ.get("STEREO_CORES") or program.parent / "cores") / f"{config}.so"
        flow = ROOT / "scripts" / "flow"
        folders = (BENCH, flow / "cosim", flow / "simulation", flow / "base")
        sources = [path for folder in folders for path in sorted(folder.iterdir()) if path.is_file()]
        design = [path for path in sorted(committed.folder(config).iterdir()) if path.suffix in (".vhd", ".vhdl")]
        design.append(committed.folder(config) / "manifest.json")
        key = hashlib.sha256(repr((config, list(self.options), SIMULATORS[self.simulator].tools())).encode())
        modules = sorted(program.parent.glob(f"{program.name}_*.so"))  # what it loads, as the readers of images
        for path in [program, *modules, core, rtl.MEMORY_CELL, *design, *sources, *self.inputs]:
            if path.is_file():
                key.update(hashlib.sha256(path.read_bytes()).digest())
        return key.hexdigest()

    def _earlier(self) -> dict[str, Any]:
        """{configuration: entry} of the summary that stands there."""
        content = json_files.load_result(self.out / "summary.json", FORMAT)
        runs = content.get("runs") if content else []
        if not isinstance(runs, list) or not all(isinstance(run, dict) and "config" in run for run in runs):
            raise json_files.damaged(self.out / "summary.json", FORMAT)
        return {run["config"]: run for run in runs if run.get("simulator") == self.simulator}

    def _write(self, entries: list[Entry], code: int, seconds: float) -> None:
        counts = {one: sum(entry.outcome == one for entry in entries) for one in Outcome.__args__}  # type: ignore[attr-defined]
        summary = {
            "format": FORMAT,
            "passed": code == EXIT_OK,
            "exit_code": code,
            "counts": counts,
            "expected": sum(entry.report.get("expected", 0) for entry in entries),
            "compared": sum(entry.report.get("compared", 0) for entry in entries),
            "mismatches": sum(entry.report.get("mismatches", 0) for entry in entries),
            "seconds": round(seconds, 1),
            "environment": facts.facts(),
            "runs": [self._content(entry) for entry in entries],
        }
        files.write(self.out / "summary.json", json.dumps(summary, indent=2) + "\n")
        files.write(self.out / "junit.xml", report.junit([self._case(entry) for entry in entries]))
        missing = overview.write(self.out, summary)
        print(_table(entries))
        if missing:
            print(missing)
        said = ", ".join(f"{count} {outcome}" for outcome, count in counts.items() if count)
        outputs = f"{summary['compared']:,} of {summary['expected']:,} outputs compared"
        outputs += f", {summary['mismatches']:,} mismatches"
        if all(entry.outcome == "unchanged" for entry in entries):
            outputs = "nothing compared, as nothing has changed"
        print(
            f"{'PASS' if code == EXIT_OK else 'FAIL'}: {said}; {outputs}; {seconds:.1f} s; {self.out / 'summary.json'}"
        )

    def _content(self, entry: Entry) -> dict[str, Any]:
        content = {key: getattr(entry, key) for key in ("config", "outcome", "text", "exit_code", "inputs", "report")}
        return content | {"simulator": self.simulator, "seconds": round(entry.seconds, 2)}

    def _case(self, entry: Entry) -> xml.Element:
        if entry.outcome in ("unchanged", "not run"):
            return report.case_not_run(entry.config, self.simulator, entry.text)
        if entry.outcome == "ERROR":
            error = {"exit_code": entry.exit_code, "message": entry.text}
            made = {"command": "", "seed": "", **entry.report, "config": entry.config, "simulator": self.simulator}
            return report.case_of_failure({**made, "error": error})  # type: ignore[typeddict-item]
        return report.case_of(entry.report)  # type: ignore[arg-type]


def exit_code(entries: Iterable[Entry]) -> int:
    codes = [entry.exit_code for entry in entries if entry.exit_code is not None]
    return EXIT_MISMATCH if EXIT_MISMATCH in codes else max(codes, default=EXIT_OK)


def _counted(content: dict[str, Any]) -> str:
    marks = ", EDITED VHDL" if content.get("edited") else ""
    marks += ", simulation cached" if content.get("is_cached") else ""
    if "coverage" in content:
        marks += f", {len(content['coverage']['never_moved'])} register bits never moved"
    first = f"; {content['first_mismatch']}" if content["first_mismatch"] else ""
    counts = f"{content['compared']:,} of {content['expected']:,} outputs, {content['mismatches']:,} mismatches"
    return f"{counts}, {content['simulation_seconds']:.1f} s{marks}{first}"


def _last_line(path: Path) -> str:
    return (path.read_text(errors="replace").strip().splitlines() or ["no message"])[-1]


def _table(entries: Sequence[Entry]) -> str:
    rows = [("configuration", "outcome", "compared", "expected", "mismatches", "clocks", "seconds")]
    for entry in entries:
        numbers = [entry.report.get(key) for key in ("compared", "expected", "mismatches", "clocks")]
        shown = [f"{value:,}" if isinstance(value, int) else "" for value in numbers]
        rows.append((entry.config, entry.outcome, *shown, f"{entry.seconds:.1f}"))  # type: ignore[arg-type]
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    lines = [
        "  ".join(cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
        for row in rows
    ]
    return "\n".join(["", *(line.rstrip() for line in lines), ""])
