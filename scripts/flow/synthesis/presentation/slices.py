# SPDX-License-Identifier: Apache-2.0
"""Neighbouring elements that get neighbouring elements of another array of the same type, or all the same constant, as
one assignment, `a <= b;`, `a(0 to 23) <= a(1 to 24);`, `a <= (others => 0);`, and back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product

from ...base.errors import FlowError
from .arrays import Array, Places
from .tree import Assign, If, Statement, inside
from .words import Words, is_flag, joined, others, sign_of

_Element = tuple[Array, Places]


def made(statements: Sequence[Statement], known: Mapping[str, Array]) -> tuple[Statement, ...]:
    found: list[Statement] = []
    at = 0
    while at < len(statements):
        one = statements[at]
        if isinstance(one, If):
            one = inside(one, lambda branch: made(branch, known))
        elif isinstance(one, Assign):
            size, whole = _run(statements, at, known)
            if whole is not None:
                found.append(whole)
                at += size
                continue
        found.append(one)
        at += 1
    return tuple(found)


def _element(words: Words, known: Mapping[str, Array]) -> _Element | None:
    """Of an array, where that is all that the words say."""
    array = known.get(words[0])
    if array is None or len(words) != 2 + 2 * len(array.ranges) or not all(word.isdigit() for word in words[2::2]):
        return None
    return array, tuple(map(int, words[2::2]))


def _is_constant(words: Words) -> bool:
    return is_flag(words) or (len(words) == 1 and words[0].isdigit())


def _run(statements: Sequence[Statement], at: int, known: Mapping[str, Array]) -> tuple[int, Assign | None]:
    """(statements, the one in their place)"""
    first = _parts(statements[at], known)
    if first is None:
        return 0, None
    (array, places), sign, value = first
    source = None if _is_constant(value) else _element(value, known)
    if not _is_constant(value) and (source is None or not _may_copy(array, source[0], sign)):
        return 0, None
    size = _size(statements, at, first, source, known)
    is_whole = size == array.size and places == array.first
    shown = _shown(value, source, size, array)
    if size < 2 or not shown or not (is_whole or len(array.ranges) == 1):
        return 0, None
    target = (array.name,) if is_whole else _reference(array, places[0], size)
    return size, Assign((*target, sign, *shown))


def _parts(one: Statement, known: Mapping[str, Array]) -> tuple[_Element, str, Words] | None:
    """(target, sign, value) of an assignment to an element"""
    if not isinstance(one, Assign) or one.words[0] not in known:
        return None
    middle = sign_of(one.words)
    target = _element(one.words[:middle], known)
    return target and (target, one.words[middle], one.words[middle + 1 :])


def _may_copy(array: Array, source: Array, sign: str) -> bool:
    return source.type_name == array.type_name and (sign == "<=" or source is not array)


def _size(
    statements: Sequence[Statement],
    at: int,
    first: tuple[_Element, str, Words],
    source: _Element | None,
    known: Mapping[str, Array],
) -> int:
    """How many assignments from the first one on go on as it begins."""
    (array, places), _, value = first
    for size in range(1, len(statements) - at):
        places = _next(array, places)
        if source:
            source = source[0], _next(*source)
        parts = _parts(statements[at + size], known)
        if parts is None or parts[0] != (array, places):
            return size
        if parts[2] != value if source is None else _element(parts[2], known) != source:
            return size
    return len(statements) - at


def _next(array: Array, places: Places) -> Places:
    """Of the element behind this one, the last index first."""
    found = list(places)
    for at in range(len(found) - 1, -1, -1):
        found[at] += 1
        if found[at] <= array.ranges[at][1]:
            return tuple(found)
        found[at] = array.ranges[at][0]
    return ()


def _shown(value: Words, source: _Element | None, size: int, target: Array) -> Words:
    """What so many elements get; nothing where that has no short form."""
    if source is None:
        return others(value, len(target.ranges))
    array, places = source
    if size == array.size and places == array.first:
        shapes = [[last - low for low, last in one.ranges] for one in (array, target)]
        return (array.name,) if shapes[0] == shapes[1] else ()
    return _reference(array, places[0], size) if len(array.ranges) == 1 else ()


def _reference(array: Array, first: int, size: int) -> Words:
    return array.name, "(", str(first), "to", str(first + size - 1), ")"


# --- and back ---------------------------------------------------------------------------------------------------------


def unmade(statements: Iterable[Statement], known: Mapping[str, Array]) -> tuple[Statement, ...]:
    return tuple(_single(statements, known))


def _single(statements: Iterable[Statement], known: Mapping[str, Array]) -> Iterator[Statement]:
    for one in statements:
        if isinstance(one, If):
            yield inside(one, lambda branch: unmade(branch, known))
        elif isinstance(one, Assign):
            yield from _elements_of(one, known)
        else:
            yield one


def _elements_of(one: Assign, known: Mapping[str, Array]) -> Iterator[Statement]:
    middle = sign_of(one.words)
    targets, value = _elements(one.words[:middle], known), one.words[middle + 1 :]
    if targets is None:
        yield one
        return
    if value[:2] == ("(", "others"):
        dimensions = value.count("others")
        sources = [value[3 * dimensions : -dimensions]] * len(targets)
    else:
        sources = _elements(value, known) or []
    if len(sources) != len(targets):  # edited by hand
        raise FlowError(f"unknown form of VHDL: '{joined(one.words)}'")
    for target, source in zip(targets, sources):
        yield Assign((*target, one.words[middle], *source))


def _elements(words: Words, known: Mapping[str, Array]) -> list[Words] | None:
    """Of an array or of a slice, one by one."""
    array = known.get(words[0])
    if array is None or not (len(words) == 1 or words[3:4] == ("to",)):
        return None
    ranges = array.ranges if len(words) == 1 else ((int(words[2]), int(words[4])),)
    return [array.reference(places) for places in product(*(range(low, last + 1) for low, last in ranges))]
