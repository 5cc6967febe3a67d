# SPDX-License-Identifier: Apache-2.0
"""What simulations, proofs and implementations have in common: VHDL through GHDL."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Union

from .errors import EXIT_TOOL_FAILED, FlowError
from .tools import find_ghdl, run, tool_version

STANDARD = "--std=08"
Generics = Mapping[str, Union[int, str]]  # of a top


def version() -> str:
    match = re.match(r"GHDL \S+", run([find_ghdl(), "--version"]))
    if not match:
        raise FlowError("ghdl --version prints no version", EXIT_TOOL_FAILED)
    return match.group()


def full_version() -> str:
    """With the code generator: what one has made cannot run on another."""
    return _full_version(find_ghdl())


@cache
def _full_version(program: str) -> str:
    generator = re.search(r"^ *(\S.* code generator)$", run([program, "--version"]), re.MULTILINE)
    return tool_version(program) + (f", {generator[1]}" if generator else "")


def analyse(files: Iterable[Path], work: Path, log: str = "analyse.log", standard: str = STANDARD) -> None:
    """`ghdl -a` of the files, in compile order, in the folder `work`."""
    run([find_ghdl(), "-a", standard, *files], cwd=work, log=work / log)


def elaborate(work: Path, top: str, standard: str = STANDARD, log: str = "elaborate.log") -> None:
    """`ghdl -e` of what was analysed in the folder `work`. By itself GHDL only warns of a component without its
    entity, whose outputs nothing drives then."""
    run([find_ghdl(), "-e", standard, "-Werror=binding", top], cwd=work, log=work / log)


def options_of(generics: Generics | None) -> list[str]:
    return [f"-g{name}={value}" for name, value in (generics or {}).items()]


def to_verilog(files: Iterable[Path], work: Path, top: str, generics: Generics | None = None) -> str:
    """The design as Verilog text, by `ghdl --synth`."""
    folder = work / "synth"
    folder.mkdir(parents=True, exist_ok=True)
    analyse(files, folder)
    log = folder / "synth.log"
    command = [find_ghdl(), "--synth", STANDARD, *options_of(generics), "--out=verilog", top]
    verilog = run(command, cwd=folder, log=log)
    lost = re.search(r".*warning: no assignment for offset.*", log.read_text())
    if lost:
        raise FlowError(f"ghdl --synth leaves bits without a value: {lost.group()}", EXIT_TOOL_FAILED)
    if f"module {top}" not in verilog:
        raise FlowError(f"ghdl --synth did not write a module {top}", EXIT_TOOL_FAILED)
    return verilog
