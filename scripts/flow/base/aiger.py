# SPDX-License-Identifier: Apache-2.0
"""Proofs about a design: yosys makes an and-inverter graph (AIGER) of its Verilog, and yosys-abc reasons about that."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

from .errors import EXIT_TOOL_FAILED, FlowError
from .tools import find_tool, find_yosys, run


def find_abc() -> str:
    return find_tool("yosys-abc", "YOSYS_ABC", "on Debian: apt-get install yosys")


class Opened(NamedTuple):
    """Wires inside of a design, as yosys selects them."""

    inputs: str  # those that become inputs
    outputs: str  # and those that become outputs


def write(verilog: str, top: str, work: Path, starts_at_zero: bool = False, opened: Opened | None = None) -> Path:
    """The graph of the module `top`. Registers and memories without an initial value start with any, as if inputs
    gave it, or with `starts_at_zero` at 0. What the text leaves undefined is 0: yosys must not choose."""
    work.mkdir(parents=True, exist_ok=True)
    (work / "design.v").write_text(verilog)
    # Before anything is optimised: a wire without a driver would be lost.
    expose = f"expose -input {opened.inputs}; expose {opened.outputs}; " if opened else ""
    script = (
        f"read_verilog -sv design.v; hierarchy -top {top}; proc; flatten; {expose}"
        f"prep -flatten -top {top}; memory_map; "
        f"setundef -undriven -zero{' -init' if starts_at_zero else ''}; opt -full; "
        "techmap; setundef -undriven -zero; opt; dffunmap; simplemap; aigmap; setundef -zero; opt_clean; "
        "write_aiger -zinit -symbols design.aig"
    )
    run([find_yosys(), "-p", script], cwd=work, log=work / "yosys.log")
    return work / "design.aig"


def ask(script: str, work: Path, seconds: int | None = None) -> str:
    """What yosys-abc says to its commands; also in abc.log. Nothing where it has not ended in so many seconds."""
    log = work / "abc.log"
    if seconds is None:
        run([find_abc(), "-c", script], cwd=work, log=log)
        return log.read_text()
    with log.open("w") as said:
        try:
            command = [find_abc(), "-c", script]
            subprocess.run(command, cwd=work, stdout=said, stderr=subprocess.STDOUT, timeout=seconds, check=True)
        except subprocess.TimeoutExpired:
            return ""
        except subprocess.CalledProcessError:
            raise FlowError(f"yosys-abc failed; see {log}", EXIT_TOOL_FAILED) from None
    return log.read_text()


class Answer(NamedTuple):
    """Whether an output is 0 for ever. Neither, where the proof came to no end."""

    proved: bool
    clock: str = ""  # in which it is 1, where it is refuted


def prove(commands: str, work: Path, seconds: int | None = None, before: int | None = None) -> Answer:
    """Whether the output of what `commands` leave behind is 0 for ever, by property directed reachability in so many
    seconds, after `before` seconds for the commands."""
    limit = f" -T {seconds}" if seconds else ""
    said = ask(f"{commands}; write left.aig; pdr{limit}", work, (seconds or 0) + before if before else None)
    if not said:
        return Answer(False)
    # Where nothing but a constant is left, a newer yosys-abc (that of yosys 0.52) calls it undecided.
    left = outputs(work / "left.aig")
    if left == [0] or "Property proved" in said:
        return Answer(True)
    return Answer(False, "0" if left == [1] else _refuted(said))


def prove_by_all_states(commands: str, work: Path, seconds: int) -> Answer:
    """The same by the set of all states that can be reached, as a binary decision diagram. Of few registers it
    is small, and a counter of many steps costs no more than one of few."""
    said = ask(f"{commands}; reach -r -T {seconds}", work, 2 * seconds)  # it looks at the time between two steps only
    return Answer("proved unreachable" in said, _refuted(said))


def simulate(commands: str, work: Path, seconds: int) -> Answer:
    """The same by random inputs alone, which proves nothing, but finds in a moment what shows after some hundreds of
    clocks, where the search of `prove` may come to no end."""
    return Answer(False, _refuted(ask(f"{commands}; sim3 -F 200 -T {seconds}", work)))


def _refuted(said: str) -> str:
    """In which clock, or nothing. yosys-abc's `reach` calls the first one -1."""
    match = re.search(r"asserted in frame (-?\d+)", said)
    return str(max(0, int(match[1]))) if match else ""


def outputs(path: Path) -> list[int]:
    """The edges that drive the outputs of a binary AIGER file: 0 and 1 are constants."""
    with path.open("rb") as file:
        registers, count = (int(word) for word in file.readline().split()[3:5])
        lines = [file.readline() for _ in range(registers + count)]
    return [int(line) for line in lines[registers:]]
