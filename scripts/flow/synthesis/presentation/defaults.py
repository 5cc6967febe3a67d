# SPDX-License-Identifier: Apache-2.0
"""Arrays of variables with places that nothing is made of: all get a value first, so that no bit is without one. Each
variable in them gets its own before anything reads it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from itertools import takewhile

from .arrays import Array
from .tree import Assign, Comment, If, Statement
from .words import Words, others, sign_of

REMARK = "no bit without a value, where an array has places for more"
_RANGE = re.compile(r"(?:natural|integer) range (-?\d+) to (-?\d+)")


def read_first(statements: Sequence[Statement], variables: Iterable[str]) -> set[str]:
    """Those that may be read before they have got a value in this clock."""
    names, found = set(variables), set[str]()

    def look(words: Words, defined: set[str]) -> None:
        found.update(word for word in words if word in names and word not in defined)

    def walk(part: Iterable[Statement], defined: set[str]) -> set[str]:
        for one in part:
            if isinstance(one, Assign):
                look(one.words[sign_of(one.words) :], defined)
                defined = defined | {one.words[0]} if one.words[0] in names else defined
            elif isinstance(one, If):
                look(one.test, defined)
                defined = walk(one.then, defined) & walk(one.otherwise or (), defined)
        return defined

    walk(statements, set())
    return found


def made(statements: tuple[Statement, ...], sparse: Sequence[Array]) -> tuple[Statement, ...]:
    """At the beginning of the clocked statements."""
    if not sparse:
        return statements
    (clocked,) = statements
    assert isinstance(clocked, If)
    first = [Assign((array.name, ":=", *_value(array))) for array in sparse]
    return (If(clocked.test, (Comment(REMARK), *first, *clocked.then), clocked.otherwise),)


def unmade(statements: tuple[Statement, ...], known: Mapping[str, Array]) -> tuple[Statement, ...]:
    clocked = statements[0] if statements else None
    count = len(names(statements, known))
    if count == 0 or not isinstance(clocked, If):
        return statements
    return (If(clocked.test, clocked.then[1 + count :], clocked.otherwise), *statements[1:])


def names(statements: tuple[Statement, ...], known: Mapping[str, Array]) -> set[str]:
    """Of the arrays that get a value first."""
    clocked = statements[0] if statements else None
    if not isinstance(clocked, If) or clocked.then[:1] != (Comment(REMARK),):
        return set()
    defaults = takewhile(lambda one: _is_default(one, known), clocked.then[1:])
    return {one.words[0] for one in defaults if isinstance(one, Assign)}


def _is_default(one: Statement, known: Mapping[str, Array]) -> bool:
    if not isinstance(one, Assign) or one.words[0] not in known:
        return False
    array = known[one.words[0]]
    return one.words == (array.name, ":=", *_value(array))


def _value(array: Array) -> Words:
    kind = array.kind[0]
    bounds = _RANGE.fullmatch(kind)
    value: Words = ("false",) if kind == "boolean" else others(("'0'",), 1)
    if bounds:
        number = min(max(0, int(bounds[1])), int(bounds[2]))
        value = (str(number),) if number >= 0 else ("-", str(-number))
    return others(value, len(array.ranges))
