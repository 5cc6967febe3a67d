# SPDX-License-Identifier: Apache-2.0
"""Elements with ranges of their own in one array of the widest, where their upper bits cost nothing: all have the same
width, or what the narrow ones take are numbers and narrow names. A comment says their ranges."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping, Sequence

from .tree import Assign, If, Statement

# Of a kind and of what drives it: a process that drives one element drives the whole array.
Kind = tuple[str, str]
_NATURAL = re.compile(r"natural range 0 to (\d+)")
_LONGEST = 60  # characters of what is said of the ranges
_RUN = 4  # numbers with a constant step that are said by their first two and the last


def top(kind: str) -> int | None:
    """The highest number of a natural type from 0 on."""
    match = _NATURAL.fullmatch(kind)
    return int(match[1]) if match else None


def kind_of(top: int) -> str:
    return f"natural range 0 to {top}"


def common(members: Mapping[str, Kind], selections: Container[str]) -> dict[str, Kind]:
    """{name: type it may have} of the names of one family that may share a type."""
    tops = {name: high for name, (kind, _) in members.items() if (high := top(kind)) is not None}
    if len({members[name][1] for name in tops}) != 1:
        return {}
    widest = max(tops.values())
    narrow = [name for name, high in tops.items() if high.bit_length() < widest.bit_length()]
    if not all(name in selections for name in narrow):
        return {}
    return {name: (kind_of(widest), members[name][1]) for name in tops}


def joined(kinds: Sequence[str]) -> tuple[str, tuple[int, ...]]:
    """(type of an array with elements of these types, their own highest numbers where they differ)"""
    if len(set(kinds)) == 1:
        return kinds[0], ()
    tops = tuple(int(kind.rpartition(" ")[2]) for kind in kinds)
    return kind_of(max(tops)), tops


def selections(statements: Iterable[Statement], kinds: Mapping[str, str]) -> set[str]:
    """Names that take nothing but numbers, bits and names that are no wider."""
    targets: set[str] = set()
    others: set[str] = set()

    def look(part: Iterable[Statement]) -> None:
        for one in part:
            if isinstance(one, If):
                look(one.then)
                look(one.otherwise or ())
            elif isinstance(one, Assign):
                name, *_ = one.words
                (targets if _is_narrow(one.words[2:], top(kinds.get(name, "")), kinds) else others).add(name)

    look(statements)
    return targets - others


def _is_narrow(value: Sequence[str], most: int | None, kinds: Mapping[str, str]) -> bool:
    if most is None:
        return False
    if len(value) == 1:
        known = int(value[0]) if value[0].isdigit() else top(kinds.get(value[0], ""))
        return known is not None and known <= most
    return len(value) == 4 and value[0] == "as_number" and value[2] in kinds


# --- what the comment says --------------------------------------------------------------------------------------------


def said(tops: Sequence[int]) -> str:
    """`3, 5 .. 23, 24`, `3 x 224, 2 x 16`"""
    parts: list[str] = []
    at = 0
    while at < len(tops):
        size, step = _run(tops[at:])
        if size < _RUN:
            size = 1
            parts.append(str(tops[at]))
        elif step == 0:
            parts.append(f"{tops[at]} x {size}")
        else:
            parts.append(f"{tops[at]}, {tops[at + 1]} .. {tops[at + size - 1]}")
        at += size
    return ", ".join(parts)


def _run(tops: Sequence[int]) -> tuple[int, int]:
    """(how many from the first one on have a constant step, this step, 0 or more)"""
    if len(tops) < 2 or tops[1] < tops[0]:
        return 1, 0
    size, step = 2, tops[1] - tops[0]
    while size < len(tops) and tops[size] - tops[size - 1] == step:
        size += 1
    return size, step


def read(text: str) -> tuple[int, ...]:
    found: list[int] = []
    for part in text.split(", "):
        numbers = [int(word) for word in re.findall(r"\d+", part)]
        if " x " in part:
            found += [numbers[0]] * numbers[1]
        elif ".." in part:
            step = numbers[0] - found[-1]
            found += range(numbers[0], numbers[1] + 1, step)
        else:
            found += numbers
    return tuple(found)


def is_one(tops: Sequence[int]) -> bool:
    """Whether these elements have one width."""
    return len({top.bit_length() for top in tops}) < 2


def is_sayable(tops: Sequence[int]) -> bool:
    return len(said(tops)) <= _LONGEST
