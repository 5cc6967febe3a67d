# SPDX-License-Identifier: Apache-2.0
"""Proofs that a fault changes nothing that can be seen from outside.

The design with the fault and the design without run side by side, in yosys-abc. It merges the registers that are equal
in both (induction over all of them at once: lcorr, scorr), runs what is left with random inputs (sim3), and proves it
with invariants that it finds by itself (property directed reachability: pdr). First it tries the same with where the
two may differ instead of what they do (differences.py), which leaves the arithmetic out, and with registers that serve
both (shared.py).

Assumed: registers and memories start at 0, as in an FPGA, and the first clock is one of reset. From then on every input
is free in every clock, resets and broken streams too. Compared: all outputs in every clock, those that go with a valid
bit while it is '1'. The shell is proved for any core: what it gives the core is an output, what the core answers is an
input."""

from __future__ import annotations

import re
import threading
from pathlib import Path
from typing import NamedTuple

from ..base import aiger, committed, ghdl, rtl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..shell import template
from ..synthesis import manifest
from ..synthesis.presentation import scalars
from . import differences, shared

SECONDS = 30  # for what is left after the merging of registers
SIMULATED_SECONDS = 3
MERGING_SECONDS = 120  # for the merging of registers
SHORT_SECONDS, LONG_SECONDS = 10, 200  # the same of where the versions may differ, at first and at last
MOST_LEFT_OVER = 600  # registers of a proof with registers that serve both versions, for a long one
MOST_FOR_ALL_STATES = 100  # registers of a proof by the set of all states
MOST_ALONE = 40  # registers of which each is proved to stay 0, where all at once are not
VALID = {  # bit: the outputs that say something while it is '1'
    "rectified_valid": ("rectified_left", "rectified_right", "rectified_start_of_frame"),
    "disparity_valid": ("disparity", "pixel_valid", "disparity_start_of_frame", "disparity_end_of_line"),
    "m_axis_tvalid": ("m_axis_tdata", "m_axis_tuser", "m_axis_tlast"),
    "s_axil_bvalid": ("s_axil_bresp",),
    "s_axil_rvalid": ("s_axil_rdata", "s_axil_rresp"),
}
CLOCKS = ("clock", "aclk")
IN_RESET = {"reset": "reset | first", "aresetn": "aresetn & ~first"}


class Design(NamedTuple):
    """What two versions of are compared."""

    config: str
    is_core: bool  # or the shell
    generics: ghdl.Generics = {}  # of the shell, that are not those of the configuration


def observed(verilog: str, module: str) -> str:
    """`verilog` and around its module, whose name may go on with the values of generics, a module `observed`, which has
    its ports: a reset in the first clock, outputs 0 while their valid bit is."""
    match = re.search(rf"^module ({module}\w*)\s*\((.*?)\);", verilog, re.MULTILINE | re.DOTALL)
    if not match:
        raise FlowError(f"ghdl --synth did not write a module {module}", EXIT_TOOL_FAILED)
    ports = re.findall(r"(input|output)\s+(\[\d+:0\])?\s*(\w+)", match.group(2))
    valid_of = {name: bit for bit, names in VALID.items() for name in names}
    clock = next(name for _, _, name in ports if name in CLOCKS)
    inner = {name: IN_RESET.get(name, name) if direction == "input" else f"of_{name}" for direction, _, name in ports}
    lines = [
        f"module observed ({', '.join(' '.join(port) for port in ports)});",
        "reg first = 1;",
        f"always @(posedge {clock}) first <= 0;",
        *(f"wire {width} {inner[name]};" for direction, width, name in ports if direction == "output"),
        f"{match.group(1)} inner ({', '.join(f'.{name}({word})' for name, word in inner.items())});",
    ]
    for direction, _, name in ports:
        if direction == "output":
            seen = f"{inner[valid_of[name]]} ? {inner[name]} : 0" if name in valid_of else inner[name]
            lines.append(f"assign {name} = {seen};")
    return verilog + "\n".join([*lines, "endmodule", ""])


class NotSynthesizedError(FlowError):
    """A version that GHDL's synthesis refuses, as `scripts/lint.py` and the tests of the area do."""


def graph(design: Design, core: list[Path], shell: list[Path], work: Path) -> Path:
    """The and-inverter graph of a design made of these files: of a core from `core`, of a shell from `shell`. Raises
    NotSynthesizedError where GHDL's synthesis does not take them."""
    work.mkdir(parents=True, exist_ok=True)
    name = design.config
    options: dict[str, int | str] = {}
    if design.is_core:
        files, top = core, committed.entity(name)
        compared = top
    else:
        generics = dict(design.generics)
        enabled = generics.pop("enabled_at_reset", None)  # the only one that a user of the stereo_ip chooses
        wrapper = work / f"{rtl.ip_entity(name)}.vhd"
        wrapper.write_text(template.entity(name, manifest.read(committed.folder(name)), generics))
        options = {} if enabled is None else {"enabled_at_reset": enabled}
        files, top, compared = (
            [*scalars.files(manifest.core_files(name)), *shell, wrapper],
            rtl.ip_entity(name),
            "stereo_shell",
        )
    try:
        verilog = ghdl.to_verilog(files, work, top, options)
    except FlowError as error:
        raise NotSynthesizedError(str(error)) from None
    return aiger.write(observed(verilog, compared), "observed", work, starts_at_zero=True)


def compare(original: Path, changed: Path, work: Path) -> str:
    """Nothing when both show the same for ever; else in which clock they differ, or that the proof came to no end."""
    is_proved, differs = _differences(differences.read(original), differences.read(changed), work)
    if is_proved:
        return ""
    both = f"miter {original} {changed}; scleanup"
    merged = "read both.aig"
    if not aiger.ask(f"{both}; lcorr; scorr; write both.aig", work, MERGING_SECONDS):
        aiger.ask(f"{both}; write both.aig", work)
    answer = aiger.simulate(merged, work, SIMULATED_SECONDS)
    if not answer.clock:
        answer = aiger.prove(merged, work, SECONDS)
    if answer.clock:
        return f"differs in clock {answer.clock}"
    is_proved = answer.proved or bool(differs and differs.never_with_lemmas())
    return "" if is_proved else f"no proof in {SECONDS} s"


def are_the_same(original: Path, changed: Path, work: Path) -> bool:
    """Whether it is proved that both, whose memories are left out (memories.py), show the same for ever."""
    graphs = differences.read(original), differences.read(changed)
    is_proved, differs = _differences(*graphs, work)
    if is_proved or _with_shared_registers(*graphs, work) or (differs and differs.never_with_lemmas()):
        return True
    merged = aiger.ask(f"miter {original} {changed}; scleanup; lcorr; scorr; write both.aig", work, MERGING_SECONDS)
    return bool(merged) and aiger.prove("read both.aig", work, SECONDS).proved


def _with_shared_registers(original: differences.Graph, changed: differences.Graph, work: Path) -> bool:
    """The proof with registers that serve both versions (shared.py). Where few are left it takes the set of all states,
    then predictions."""
    both = shared.shared(original, changed)
    if both is None:
        return False
    differences.write(both, work / "shared.aig")
    (work / "left_over.aig").unlink(missing_ok=True)
    commands = "read shared.aig; scleanup; lcorr; scorr; write left_over.aig"
    answer = aiger.prove(commands, work, SHORT_SECONDS, MERGING_SECONDS)
    if answer.proved or answer.clock or not (work / "left_over.aig").is_file():
        return answer.proved
    graph = differences.read(work / "left_over.aig")
    if len(graph.registers) > MOST_LEFT_OVER:
        return False
    if len(graph.registers) <= MOST_FOR_ALL_STATES:
        answer = aiger.prove_by_all_states("read left_over.aig; strash; dc2", work, SECONDS)
        if answer.proved or answer.clock:
            return answer.proved
    differences.write(differences.with_predictions(graph), work / "shared.aig")
    return aiger.prove("read shared.aig; strash", work, LONG_SECONDS).proved


def _differences(
    original: differences.Graph, changed: differences.Graph, work: Path
) -> tuple[bool, Differences | None]:
    """(whether the short proofs show that both are the same, where they may differ)"""
    if _same_in_each_clock(original, changed, work):
        return True, None
    where = differences.differences(original, changed)
    differs = Differences(where, work) if where else None
    return bool(differs and differs.never()), differs


def _same_in_each_clock(original: differences.Graph, changed: differences.Graph, work: Path) -> bool:
    """Whether the same state leads to the same one, as where `<` and `<=` choose between equal values."""
    both = differences.one_clock(original, changed)
    if both is None:
        return False
    differences.write(both, work / "asked.aig")
    return aiger.prove("read asked.aig; fraig", work, SHORT_SECONDS, SHORT_SECONDS).proved


class Differences:
    """Where two versions may differ: proofs that nobody sees it."""

    def __init__(self, where: differences.Graph, work: Path) -> None:
        self.where, self.work = where, work
        self.may_be = True  # that nobody sees it

    def _proof(self, graph: differences.Graph, commands: str, seconds: int) -> aiger.Answer:
        differences.write(graph, self.work / "asked.aig")
        return aiger.prove(f"read asked.aig; {commands}", self.work, seconds, MERGING_SECONDS)

    def never(self) -> bool:
        (self.work / "merged.aig").unlink(missing_ok=True)
        answer = self._proof(self.where, "scleanup; lcorr; scorr; write merged.aig", SHORT_SECONDS)
        self.may_be = not answer.clock and (self.work / "merged.aig").is_file()
        return answer.proved

    def _that_stay(self, graph: differences.Graph, numbers: list[int]) -> list[int]:
        """Those of the registers that are proved to stay 0: all of them at once, or one by one."""

        def stays(some: list[int], seconds: int) -> bool:
            return self._proof(differences.asked_for(graph, some), "scleanup", seconds).proved

        if stays(numbers, SECONDS):
            return numbers
        return [number for number in numbers[:MOST_ALONE] if stays([number], 1)]

    def never_with_lemmas(self) -> bool:
        """First that some registers stay 0, then with them and with predictions the rest."""
        if not self.may_be:
            return False
        if not aiger.ask("read merged.aig; scorr -F 4; write merged.aig", self.work, MERGING_SECONDS):
            return False
        graph = differences.read(self.work / "merged.aig")
        numbers = self._that_stay(graph, differences.quiet(graph))
        if numbers:
            differences.write(differences.without(graph, numbers), self.work / "asked.aig")
            if not aiger.ask("read asked.aig; scleanup; scorr -F 2; write merged.aig", self.work, MERGING_SECONDS):
                return False
            graph = differences.read(self.work / "merged.aig")
        return self._proof(differences.with_predictions(graph), "strash", LONG_SECONDS).proved


class Prover:
    """Compares versions of some designs with their originals."""

    def __init__(self, designs: list[Design], core: list[Path], shell: list[Path], work: Path) -> None:
        self.designs, self.core, self.shell, self.work = designs, core, shell, work
        self.originals: dict[int, Path] = {}
        self.lock = threading.Lock()

    def objection(self, core: list[Path], shell: list[Path], folder: Path) -> str:
        """Why the version made of these files may show something else; "" when none of the designs does. Raises
        NotSynthesizedError where GHDL's synthesis does not take it."""
        for number, design in enumerate(self.designs):
            with self.lock:
                if number not in self.originals:
                    self.originals[number] = self._original(design, self.work / f"original_{number}")
            try:
                changed = graph(design, core, shell, folder / f"design_{number}")
            except NotSynthesizedError:
                raise
            except FlowError as error:
                return str(error)
            said = compare(self.originals[number], changed, folder)
            if said:
                return said
        return ""

    def _original(self, design: Design, work: Path) -> Path:
        try:
            return graph(design, self.core, self.shell, work)
        except NotSynthesizedError as error:  # says nothing of a fault
            raise FlowError(str(error), EXIT_TOOL_FAILED) from None
