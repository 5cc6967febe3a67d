# SPDX-License-Identifier: Apache-2.0
"""Words of VHDL, and their text again."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

Words = tuple[str, ...]
WORD = re.compile(r"--[^\n]*|\*\*|:=|<=|>=|/=|=>|'[01]'|\"[^\"]*\"|\w+(?:\.\w+)?|\S")
LINE = 120
_OPERATORS = {"not", "and", "or", "xor", "mod", "if", "then", "downto", "to", "in", "when", "else"}


def split(text: str) -> list[str]:
    return WORD.findall(text)


def is_name(word: str) -> bool:
    return (word[0].isalpha() or word[0] == "_") and word not in _OPERATORS


def joined(words: Iterable[str]) -> str:
    """Spaced as the lowering does it."""
    text: list[str] = []
    before, unary = "", False
    for word in words:
        glued = before in ("", "(") or word in (")", ",", ";") or unary or (word == "(" and is_callable(before))
        text.append(word if glued else f" {word}")
        unary = word == "-" and before in ("", "(", ",")
        before = word
    return "".join(text)


def is_callable(word: str) -> bool:
    """Whether a parenthesis behind it holds arguments or indices."""
    return word == ")" or is_name(word)


def folded(line: str) -> list[str]:
    """A long statement on several lines, broken at blanks."""
    lines = []
    indent = " " * (len(line) - len(line.lstrip(" ")) + 2)
    while len(line) > LINE and " " in line[len(indent) + 8 : LINE]:
        at = line.rindex(" ", 0, LINE)
        lines.append(line[:at])
        line = indent + line[at + 1 :]
    return [*lines, line]


def wrapped(start: str, names: Sequence[str], end: str) -> list[str]:
    """A declaration of many names, in as few lines as fit."""
    lines: list[str] = []
    line: list[str] = []
    for name in names:
        if line and len(start) + len(", ".join([*line, name])) + len(end) > LINE:
            lines.append(start + ", ".join(line) + end)
            line = []
        line.append(name)
    return [*lines, start + ", ".join(line) + end]


def is_flag(words: Words) -> bool:
    return words in (("false",), ("true",))


def others(value: Words, dimensions: int) -> Words:
    """All elements of an array, or all fields of a record."""
    for _ in range(dimensions):
        value = ("(", "others", "=>", *value, ")")
    return value


def sign_of(words: Words) -> int:
    """The place of `<=` or `:=` in an assignment."""
    return next(at for at, word in enumerate(words) if word in ("<=", ":="))


def arguments(words: Words) -> list[Words]:
    """What stands between the commas of a list."""
    found: list[Words] = []
    depth, start = 0, 0
    for at, word in enumerate(words):
        depth += {"(": 1, ")": -1}.get(word, 0)
        if word == "," and depth == 0:
            found.append(words[start:at])
            start = at + 1
    return [*found, words[start:]]


def bare(value: Words) -> Words:
    """Without the parentheses around all of it."""
    if value[0] != "(":
        return value
    depth = 0
    for at, word in enumerate(value):
        depth += {"(": 1, ")": -1}.get(word, 0)
        if depth == 0:
            return value[1:-1] if at == len(value) - 1 else value
    return value


def in_parentheses(value: Words) -> Words:
    """Where it is no name or call."""
    is_call = len(value) > 1 and value[0] != "not" and value[1] == "(" and bare(value[1:]) != value[1:]
    return value if len(value) == 1 or is_call else ("(", *value, ")")
