# SPDX-License-Identifier: Apache-2.0
"""Hundreds of mutants of a core in one build: Verilator runs the stress stream once for each, up to its first wrong
output, and one graph serves the proofs of those that show nothing."""

from __future__ import annotations

import re
import shutil
import threading
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from pathlib import Path

from ..base import aiger, ghdl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Word, run_with_progress
from ..cosim import bench, checker, vectors
from ..simulation.simulators import SIMULATORS, Design
from . import differences, equivalence, schemata
from .judges import WATCHDOG_SECONDS, Core
from .memories import OPENED, memories, opened
from .mutants import Mutant

BENCH = bench.FOLDER / "mutants_bench.cpp"
MOST_REGISTERS = 5000  # of a graph with memories. Of larger ones yosys-abc merges two in ten minutes or more
_PLACE = re.compile(r"(?:^|error: )(\S+\.vhd):(\d+):\d+:(?!warning)", re.MULTILINE)


class Batch:
    """Mutants of a core: which of them do not compile, which the stress stream shows, and proofs for the rest. Those in
    `outside` cannot stand in one text with others; nothing is known of them."""

    def __init__(
        self, core: Core, core_files: list[Path], streams: Iterable[Iterator[Mutant]], count: int, work: Path
    ) -> None:
        """Takes mutants from each stream until `count` of them compiled, as far as the text shows that."""
        self.core, self.work = core, work
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        *self.others, self.file = core_files
        self.inside: dict[int, Mutant] = {}
        self.outside: list[Mutant] = []
        self.invalid: list[Mutant] = []
        self.last = 0  # number of a mutant
        for stream in streams:
            before = len(self.inside) + len(self.outside)
            while more := list(islice(stream, before + count - len(self.inside) - len(self.outside))):
                self._take(more)
        self.known = {mutant.key for mutant in (*self.inside.values(), *self.invalid)}
        self.number_of = {mutant.key: number for number, mutant in self.inside.items()}
        self.shown: dict[str, str] = {}  # {key: where}
        self.elsewhere: dict[str, str] = {}  # the same of those that only streams of other seeds show
        self.graphs: Graphs | None = None

    def _take(self, mutants: list[Mutant]) -> None:
        for mutant in mutants:
            if mutant.file == self.file:
                self.last += 1
                self.inside[self.last] = mutant
            else:
                self.outside.append(mutant)
        while refused := self._refused(ghdl.analyse):
            self.invalid += [self.inside.pop(number) for number in refused]
        while refused := self._refused(self._to_verilog):  # of constants outside a range
            self.outside += [self.inside.pop(number) for number in refused]

    def _write(self, numbers: Iterable[int]) -> list[Path]:
        """The files of the core with these mutants to choose from."""
        text = schemata.with_mutants(self.file, {number: self.inside[number] for number in numbers})
        self.line_of = text.line_of
        self.outside += [self.inside.pop(number) for number in text.outside]
        changed = self.work / self.file.name
        changed.write_text(text.text)
        return [*self.others, changed]

    def _refused(self, step: Callable[[list[Path], Path], object]) -> list[int]:
        """The numbers of the mutants that a step of GHDL does not take."""
        made = self._write(list(self.inside))
        try:
            step(made, self.work)
            return []
        except FlowError as error:
            logs = [self.work / "analyse.log", self.work / "synth" / "synth.log"]
            said = "\n".join([str(error), *(log.read_text() for log in logs if log.is_file())])
        lines = {int(line) for path, line in _PLACE.findall(said) if Path(path).name == self.file.name}
        found = {self.line_of[line] for line in lines if line in self.line_of}
        if not found:
            raise FlowError(f"GHDL refuses {made[-1]}, for no mutant: {said[:500]}", EXIT_TOOL_FAILED)
        return sorted(found)

    def _to_verilog(self, made: list[Path], work: Path) -> str:
        return ghdl.to_verilog(made, work, self.core.entity)

    def judge(self, others: int = 0) -> None:
        """What the stress stream shows; of the rest what streams of `others` other seeds show, and the graph for
        proofs. The text without a fault must show what is expected."""
        core, ports = self.core, bench.Ports(self.core.kind, self.core.lanes, self.core.bits)
        made, verilator = self._write(list(self.inside)), SIMULATORS["verilator"]
        verilator.build(self.work, Design(core.entity, made, [BENCH], ports.cpp()))
        for number, clock in self._shown_by(core.stimulus, core.expected, list(self.inside)):
            self.shown[self.inside[number].key] = f"co-simulation: clock {clock}"
        for seed in range(2, 2 + others):
            for number, clock in self._shown_by(*core.stream(seed), self._left(self.elsewhere)):
                self.elsewhere[self.inside[number].key] = (
                    f"only the stress stream of seed {seed} shows it, clock {clock}"
                )
        if left := self._left({}):
            verilog = self._to_verilog(self._write(left), self.work)
            self.graphs = Graphs(equivalence.observed(verilog, core.entity), self.work)

    def _left(self, also_shown: dict[str, str]) -> list[int]:
        known = self.shown.keys() | also_shown.keys()
        return [number for number, mutant in self.inside.items() if mutant.key not in known]

    def _shown_by(self, stimulus: Path, expected: list[vectors.Expected], numbers: list[int]) -> list[tuple[int, int]]:
        """(number, clock of the first wrong output) of those of some mutants that a stream shows."""
        core = self.core
        observed, result, mutants = (self.work / f"{name}.txt" for name in ("observed", "result", "mutants"))
        mutants.write_text("".join(f"{number}\n" for number in numbers))
        given: dict[str, Word] = {"stimulus": stimulus, "observed": observed, "result": result, "mutants": mutants}
        command = SIMULATORS["verilator"].command(self.work, core.entity, given)
        run_with_progress(command, lambda line: None, WATCHDOG_SECONDS, cwd=self.work)
        verdict = checker.compare(expected, vectors.read_observed(observed)[0], core.bits)
        if not verdict.passed:
            raise FlowError(f"{self.file} differs without a mutant: {verdict.first_mismatch}", EXIT_TOOL_FAILED)
        pairs = (line.split() for line in result.read_text().splitlines())
        return [(int(number), int(clock)) for number, clock in pairs if int(number) in self.inside]

    def objection(self, mutant: Mutant, folder: Path) -> str:
        """Why one that was not shown may show something else all the same; "" where it is proved that it does not."""
        if mutant.key in self.elsewhere:
            return self.elsewhere[mutant.key]
        assert self.graphs is not None
        return self.graphs.objection(self.number_of[mutant.key], folder)


class Graphs:
    """The graphs of all, and what becomes of them when one is chosen: without line memories, where most proofs are
    short, and with them, which is made when it is asked for."""

    def __init__(self, verilog: str, work: Path) -> None:
        self.verilog, self.work = verilog, work
        self.lock = threading.Lock()
        self.opened, self.whole = work / "opened", work / "whole"
        self.graphs: dict[Path, differences.Graph] = {}  # {folder: its graph}

    def _graph(self, folder: Path) -> differences.Graph:
        with self.lock:
            if folder not in self.graphs:
                text, at = (self.verilog, None) if folder == self.whole else (opened(self.verilog), OPENED)
                path = aiger.write(text, "observed", folder, starts_at_zero=True, opened=at)
                self.graphs[folder] = differences.read(path)
                self._write(self.graphs[folder], 0, folder / "original.aig")
            return self.graphs[folder]

    @staticmethod
    def _write(graph: differences.Graph, number: int, path: Path) -> None:
        known = {f"{schemata.INPUT}[{bit}]": number >> bit & 1 for bit in range(schemata.BITS)}
        differences.write(differences.with_inputs(graph, known), path)

    def _registers_of_all(self) -> int:
        graph = self._graph(self.opened)
        return len(graph.registers) + sum(memory.bits for memory in memories(graph.inputs, graph.output_names))

    def objection(self, number: int, folder: Path) -> str:
        changed = folder / "changed.aig"
        self._write(self._graph(self.opened), number, changed)
        if equivalence.are_the_same(self.opened / "original.aig", changed, folder):
            return ""
        registers = self._registers_of_all()
        if registers > MOST_REGISTERS:
            return f"no proof without its memories; with them it has up to {registers} registers, too many"
        self._write(self._graph(self.whole), number, changed)
        return equivalence.compare(self.whole / "original.aig", changed, folder)
