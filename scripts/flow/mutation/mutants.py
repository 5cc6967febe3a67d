# SPDX-License-Identifier: Apache-2.0
"""Single faults in VHDL text: every place where a rule fits is one mutant."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path



def _other_number(match: re.Match[str]) -> str:
    """One more. Of a power of two by which bits are chosen, the next one: another bit, another width."""
    value, before = int(match.group()), match.string[: match.start()]
    if value < 2 or value & (value - 1) or not before.endswith(("/ ", "mod ")):
        return str(value + 1)
    return str(value // 2 if before.endswith("mod ") and value > 2 else 2 * value)


# (kind, pattern of what is replaced, replacement). The pattern sees code without comments.
RULES: tuple[tuple[str, str, str | Callable[[re.Match[str]], str]], ...] = (
    ("relation", r"(?<= )= (?!>)", "/= "),
    ("relation", r"(?<= )/= ", "= "),
    ("relation", r"(?<= )< (?!=)", "<= "),
    ("relation", r"(?<= )> ", ">= "),
    ("arithmetic", r"(?<= )\+ ", "- "),
    ("arithmetic", r"(?<=\w )- ", "+ "),
    ("logic", r"\band ", "or "),
    ("logic", r"(?<= )or (?!flight)", "and "),
    ("logic", r"\bxor ", "or "),
    ("inversion", r"\bnot ", ""),
    ("inversion", r"(?<=\bif )(.+)(?= then$)", r"not (\1)"),
    ("inversion", r"(?<= when )([^;]+?)(?= else)", r"not (\1)"),
    ("constant", r"(?<![\w\"'.])(\d+)(?![\w\"'.])", _other_number),
    ("constant", r"'0'", "'1'"),
    ("constant", r"'1'", "'0'"),
    ("constant", r"\btrue\b", "false"),
    ("constant", r"\bfalse\b", "true"),
)
ASSIGNMENT = re.compile(r"^ +\w+(\([\w ]+\))? (<=|:=) [^;]+;$")
SKIPPED = re.compile(
    r"^ *(--|library|use |entity|end|port|generic|signal .*;|subtype|type |for |procedure)"
    r"|: (in|out) |return (natural|std_logic)"
)


@dataclass(frozen=True)
class Mutant:
    file: Path
    line: int  # from 0
    text: str  # of the whole line after the change
    kind: str
    key: str  # file | line as it was | what changed | which of several equal ones: names it while other lines change


def _sibling_indices(line: str, names: set[str]) -> Iterator[tuple[str, str, str]]:
    """Changes of one register's name into its neighbour's, on the right of an assignment."""
    left, arrow, right = line.partition("<=")
    if not arrow:
        return
    for match in re.finditer(r"\b([a-z]\w*_)(\d+)\b", right):
        neighbour = f"{match.group(1)}{int(match.group(2)) + 1}"
        if neighbour in names:
            yield match.group(), neighbour, left + arrow + right[: match.start()] + neighbour + right[match.end() :]


def _changes(line: str, names: set[str]) -> Iterator[tuple[str, str, str]]:
    """(kind, what changed, new line) for each rule at each place of a line."""
    code = line.partition("--")[0].rstrip()
    for kind, pattern, replacement in RULES:
        for match in re.finditer(pattern, code):
            new = match.expand(replacement) if isinstance(replacement, str) else replacement(match)
            what = f"column {match.start()}: {match.group().strip()} -> {new.strip()}"
            yield kind, what, code[: match.start()] + new + code[match.end() :]
    for old, new, text in _sibling_indices(code, names):
        yield "index", f"{old} -> {new}", text
    if ASSIGNMENT.match(code) and " when " not in code:
        indent = " " * (len(code) - len(code.lstrip()))
        yield "dropped", "assignment dropped", f"{indent}null;"


def mutants_of(path: Path) -> Iterator[Mutant]:
    """All mutants of a file, in the order of its lines. Dropped assignments outside a process do not compile."""
    lines = path.read_text().splitlines()
    names = set(re.findall(r"\b[a-z]\w*\b", "\n".join(lines)))
    start = next((i for i, line in enumerate(lines) if line.startswith(("architecture", "package"))), 0)
    seen: dict[str, int] = {}
    for number, line in enumerate(lines[start:], start):
        if SKIPPED.search(line.partition("--")[0] or "--"):
            continue
        for kind, what, text in _changes(line, names):
            name = f"{path.name} | {line.strip()} | {what}"
            seen[name] = seen.get(name, 0) + 1
            key = name if seen[name] == 1 else f"{name} | {seen[name]}"
            yield Mutant(path, number, text, kind, key)


def write(mutant: Mutant, folder: Path) -> Path:
    """A copy of the mutant's file with the fault in it."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = mutant.file.read_text().splitlines()
    lines[mutant.line] = mutant.text
    target = folder / mutant.file.name
    target.write_text("\n".join(lines) + "\n")
    return target


def shuffled(paths: Iterable[Path], seed: int) -> Iterator[Mutant]:
    """The mutants of some files in random order, the kinds in turn, so that a small sample has some of each."""
    rng = random.Random(f"mutants {seed}")
    by_kind: dict[str, list[Mutant]] = {}
    for path in paths:
        for mutant in mutants_of(path):
            by_kind.setdefault(mutant.kind, []).append(mutant)
    for mutants in by_kind.values():
        rng.shuffle(mutants)
    while any(by_kind.values()):
        for kind in sorted(by_kind):
            if by_kind[kind]:
                yield by_kind[kind].pop()


def samples(paths: Iterable[Path], seeds: Iterable[int]) -> Iterator[Iterator[Mutant]]:
    """For each seed its mutants without those that an earlier one gave."""
    paths, given = list(paths), set[str]()

    def new(seed: int) -> Iterator[Mutant]:
        for mutant in shuffled(paths, seed):
            if mutant.key not in given:
                given.add(mutant.key)
                yield mutant

    return (new(seed) for seed in seeds)
