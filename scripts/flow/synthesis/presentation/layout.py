# SPDX-License-Identifier: Apache-2.0
"""The lines of presented statements: a loop or an `if` of one statement on one line, constants side by side."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from .tree import Assign, Comment, For, If, Statement
from .words import LINE, Words, folded, is_flag, joined, sign_of


def lines(statements: Sequence[Statement], indent: str) -> Iterator[str]:
    row = ""  # of constants
    for one in statements:
        text = _of_constant(one)
        if row and (not text or len(f"{row} {text}") > LINE):
            yield row
            row = ""
        if text:
            row = f"{row} {text}" if row else indent + text
        else:
            yield from _lines(one, indent)
    if row:
        yield row


def _of_constant(one: Statement) -> str:
    """Of an assignment of a constant."""
    return (
        f"{joined(one.words)};" if isinstance(one, Assign) and _is_constant(one.words[sign_of(one.words) + 1 :]) else ""
    )


def _is_constant(value: Words) -> bool:
    is_word = value[:1] == ("to_unsigned",) and len(value) == 6 and value[2].isdigit()
    return is_flag(value) or (len(value) == 1 and value[0].isdigit()) or value[:2] == ("(", "others") or is_word


def _lines(one: Statement, indent: str) -> Iterator[str]:
    if isinstance(one, Comment):
        yield f"{indent}-- {one.text}"
    elif isinstance(one, Assign):
        yield from folded(f"{indent}{joined(one.words)};")
    elif isinstance(one, If):
        yield from _framed(f"{indent}if {joined(one.test)} then", one.then, one.otherwise, f"{indent}end if;")
    elif isinstance(one, For):
        head = f"{indent}for {one.variable} in {one.first} to {one.last} loop"
        yield from _framed(head, one.body, None, f"{indent}end loop;")


def _framed(head: str, body: Sequence[Statement], otherwise: Sequence[Statement] | None, end: str) -> Iterator[str]:
    indent = end[: len(end) - len(end.lstrip(" "))]
    if otherwise is None and len(body) == 1 and isinstance(body[0], Assign):
        line = f"{head} {joined(body[0].words)}; {end.lstrip(' ')}"
        if len(line) <= LINE:
            yield line
            return
    yield from folded(head)
    yield from lines(body, indent + "  ")
    if otherwise is not None:
        yield f"{indent}else"
        yield from lines(otherwise, indent + "  ")
    yield end
