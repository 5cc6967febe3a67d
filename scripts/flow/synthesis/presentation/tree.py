# SPDX-License-Identifier: Apache-2.0
"""Statements of the clocked process of a core."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Union

from ...base.errors import FlowError
from .words import Words, folded, joined


@dataclass(frozen=True)
class Comment:
    text: str


@dataclass(frozen=True)
class Assign:
    words: Words  # target, sign, value


@dataclass(frozen=True)
class If:
    test: Words
    then: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] | None


@dataclass(frozen=True)
class For:
    variable: str
    first: int
    last: int
    body: tuple[Statement, ...]


Statement = Union[Comment, Assign, If, For]


def inside(one: If, change: Callable[[tuple[Statement, ...]], tuple[Statement, ...]]) -> If:
    """The same with its branches changed."""
    return If(one.test, change(one.then), None if one.otherwise is None else change(one.otherwise))


def all_words(statements: Iterable[Statement]) -> Iterator[Words]:
    """Of each assignment and test."""
    for one in statements:
        if isinstance(one, Assign):
            yield one.words
        elif isinstance(one, If):
            yield one.test
            yield from all_words([*one.then, *(one.otherwise or ())])
        elif isinstance(one, For):
            yield from all_words(one.body)


def read(words: Sequence[str]) -> tuple[Statement, ...]:
    """All statements of a list of words."""
    statements, at = _read(words, 0)
    if at != len(words):
        raise FlowError(f"unknown form of VHDL: '{words[at]}' closes nothing")
    return statements


def _read(words: Sequence[str], at: int) -> tuple[tuple[Statement, ...], int]:
    """Up to an `else` or `end`, which is left."""
    found: list[Statement] = []
    while at < len(words) and words[at] not in ("else", "end"):
        word = words[at]
        if word.startswith("--"):
            found.append(Comment(word[2:].strip()))
            at += 1
        elif word == "if":
            then = _index(words, "then", at)
            branch, end = _read(words, then + 1)
            otherwise = None
            if words[end : end + 1] == ["else"]:
                otherwise, end = _read(words, end + 1)
            found.append(If(tuple(words[at + 1 : then]), branch, otherwise))
            at = _closed(words, end, "if")
        elif word == "for":
            loop = _index(words, "loop", at)
            variable, _, first, _, last = words[at + 1 : loop]
            body, end = _read(words, loop + 1)
            found.append(For(variable, int(first), int(last), body))
            at = _closed(words, end, "loop")
        else:
            end = _index(words, ";", at)
            found.append(Assign(tuple(words[at:end])))
            at = end + 1
    return tuple(found), at


def _index(words: Sequence[str], word: str, at: int) -> int:
    try:
        return words.index(word, at)
    except ValueError:
        raise FlowError(f"unknown form of VHDL: no '{word}' behind '{words[at]}'") from None


def _closed(words: Sequence[str], at: int, kind: str) -> int:
    if list(words[at : at + 3]) != ["end", kind, ";"]:
        raise FlowError(f"unknown form of VHDL: no 'end {kind}'")
    return at + 3


def lines(statements: Sequence[Statement], indent: str) -> Iterator[str]:
    for one in statements:
        if isinstance(one, Comment):
            yield f"{indent}-- {one.text}"
        elif isinstance(one, Assign):
            yield from folded(f"{indent}{joined(one.words)};")
        elif isinstance(one, If):
            yield from folded(f"{indent}if {joined(one.test)} then")
            yield from lines(one.then, indent + "  ")
            if one.otherwise is not None:
                yield f"{indent}else"
                yield from lines(one.otherwise, indent + "  ")
            yield f"{indent}end if;"
        else:
            yield f"{indent}for {one.variable} in {one.first} to {one.last} loop"
            yield from lines(one.body, indent + "  ")
            yield f"{indent}end loop;"
