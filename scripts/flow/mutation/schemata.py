# SPDX-License-Identifier: Apache-2.0
"""Many mutants in one VHDL text: an input `mutant_number` chooses the one whose fault is there, 0 none. So one build of
a simulation, and one graph for proofs, serves hundreds.

What can be chosen so are the statements of the architecture: assignments and conditions. Faults in declarations,
functions and instances stay outside, and are judged one by one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..base.errors import FlowError
from .mutants import Mutant

INPUT, BITS = "mutant_number", 16
_ASSIGNMENT = re.compile(r"^\s*\w+(?:\([\w ]+\))? (?:<=|:=) .*;$", re.DOTALL)
_CONDITION = re.compile(r"^(\s*)(if|elsif) (.*) then$", re.DOTALL)


@dataclass
class _Statement:
    first: int  # line, from 0
    lines: list[str]
    in_process: bool
    mutants: list[tuple[int, str]] = field(default_factory=list)  # (number, the statement with its fault)

    @property
    def text(self) -> str:
        return "\n".join(self.lines)


def _code(line: str) -> str:
    return line.partition("--")[0].rstrip()


def _statements(lines: list[str]) -> list[_Statement]:
    """The assignments and conditions of the architecture."""
    start = next(number for number, line in enumerate(lines) if line.startswith("architecture"))
    at = next(number for number, line in enumerate(lines) if number > start and line.startswith("begin")) + 1
    found: list[_Statement] = []
    sequential = False
    while at < len(lines):
        code = _code(lines[at])
        if re.match(r"\s*process\b|\s*\w+ : process\b", code):
            at = next(number for number in range(at, len(lines)) if re.fullmatch(r"\s+begin", _code(lines[number])))
            sequential = True
        elif re.match(r"\s*end process", code):
            sequential = False
        elif code and not re.match(r"\s*(end\b|else$|null;|case\b|when\b|for\b|begin$)", code):
            last = at
            while not re.search(r";$| then$", _code(lines[last])) and last + 1 < len(lines):
                last += 1
            statement = _Statement(at, [_code(line) for line in lines[at : last + 1]], sequential)
            is_condition = sequential and _CONDITION.match(statement.text)
            if (is_condition and "rising_edge" not in statement.text) or _ASSIGNMENT.match(statement.text):
                found.append(statement)
            at = last
        at += 1
    return found


@dataclass
class Text:
    """A file with faults to choose from."""

    text: str
    line_of: Mapping[int, int]  # {line of it, from 1: the number of the mutant that stands there}
    outside: list[int]  # numbers of the mutants that cannot stand in it


def with_mutants(path: Path, mutants: Mapping[int, Mutant]) -> Text:
    """`mutants`: {number: one of the file}."""
    lines = path.read_text().splitlines()
    statement_of = {
        number: statement
        for statement in _statements(lines)
        for number in range(statement.first, statement.first + len(statement.lines))
    }
    outside = []
    for number, mutant in mutants.items():
        statement = statement_of.get(mutant.line)
        if statement is None or (not statement.in_process and mutant.kind == "dropped"):
            outside.append(number)
            continue
        changed = list(statement.lines)
        changed[mutant.line - statement.first] = mutant.text
        statement.mutants.append((number, "\n".join(changed)))
    made: list[str] = []
    line_of: dict[int, int] = {}
    at = 0
    while at < len(lines):
        statement = statement_of.get(at)
        if statement is None or not statement.mutants:
            made.append(lines[at])
            at += 1
            continue
        for number, text in _chosen(statement):
            for line in text.splitlines():
                made.append(line)
                if number:
                    line_of[len(made)] = number
        at += len(statement.lines)
    return Text(*_with_input(made, line_of), outside)


def _chosen(statement: _Statement) -> Iterable[tuple[int, str]]:
    """(the number of a mutant or 0, lines) that stand for a statement."""
    condition = _CONDITION.match(statement.text)
    if condition:
        indent, word, original = condition.groups()
        yield 0, f"{indent}{word}"
        for number, text in statement.mutants:
            changed = _CONDITION.match(text)
            if changed is None:
                raise FlowError(f"mutant {number} is no condition: {text}")
            yield number, f"{indent}  (mutant_chosen = {number} and ({changed[3]})) or"
        others = " and ".join(f"mutant_chosen /= {number}" for number, _ in statement.mutants)
        yield 0, f"{indent}  ({others} and ({original})) then"
    elif statement.in_process:
        word = "if"
        for number, text in statement.mutants:
            yield 0, f"{word} mutant_chosen = {number} then"
            yield number, text
            word = "elsif"
        yield 0, f"else\n{statement.text}\nend if;"
    else:
        target, _, rest = statement.text.partition(" <= ")
        yield 0, f"{target} <="
        for number, text in statement.mutants:
            yield number, _guarded(text.partition(" <= ")[2].removesuffix(";"), number)
        yield 0, rest


def _guarded(value: str, number: int) -> str:
    """VALUE when THIS else, of a value that may have choices itself."""
    made = []
    for part in re.split(r"\belse\b", value):
        chosen, _, condition = part.partition(" when ")
        also = f" and ({condition.strip()})" if condition else ""
        made.append(f"{chosen.strip()} when mutant_chosen = {number}{also} else")
    return " ".join(made)


def _with_input(lines: list[str], line_of: Mapping[int, int]) -> tuple[str, dict[int, int]]:
    """The text with the input, and the numbers of its lines."""
    port = next(number for number, line in enumerate(lines) if line.strip() == "port (")
    start = next(number for number, line in enumerate(lines) if line.startswith("architecture"))
    begin = next(number for number, line in enumerate(lines) if number > start and line.startswith("begin"))
    added = {
        port: [f"    {INPUT} : in std_logic_vector({BITS - 1} downto 0);"],
        begin - 1: [f"  signal mutant_chosen : natural range 0 to {(1 << BITS) - 1};"],
        begin: [f"  mutant_chosen <= to_integer(unsigned({INPUT}));"],
    }
    made: list[str] = []
    moved: dict[int, int] = {}
    for number, line in enumerate(lines):
        made.append(line)
        if number + 1 in line_of:
            moved[len(made)] = line_of[number + 1]
        made += added.get(number, [])
    return "\n".join(made) + "\n", moved
