# SPDX-License-Identifier: Apache-2.0
"""Proofs about a design: yosys makes an and-inverter graph (AIGER) of its Verilog, and yosys-abc reasons about that."""

from pathlib import Path

from .tools import find_tool, find_yosys, run


def find_abc() -> str:
    return find_tool("yosys-abc", "YOSYS_ABC", "on Debian: apt-get install yosys")


def write(verilog: str, top: str, work: Path, starts_at_zero: bool = False) -> Path:
    """The graph of the module `top`. Registers and memories without an initial value start with any, as if inputs
    gave it, or with `starts_at_zero` at 0. What the text leaves undefined is 0: yosys must not choose."""
    work.mkdir(parents=True, exist_ok=True)
    (work / "design.v").write_text(verilog)
    script = (
        f"read_verilog -sv design.v; prep -flatten -top {top}; memory_map; "
        f"setundef -undriven -zero{' -init' if starts_at_zero else ''}; opt -full; "
        "techmap; setundef -undriven -zero; opt; dffunmap; simplemap; aigmap; setundef -zero; opt_clean; "
        "write_aiger -zinit -symbols design.aig"
    )
    run([find_yosys(), "-p", script], cwd=work, log=work / "yosys.log")
    return work / "design.aig"


def ask(script: str, work: Path) -> str:
    """What yosys-abc says to its commands; also in abc.log."""
    run([find_abc(), "-c", script], cwd=work, log=work / "abc.log")
    return (work / "abc.log").read_text()
