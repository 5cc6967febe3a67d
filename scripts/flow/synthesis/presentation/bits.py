# SPDX-License-Identifier: Apache-2.0
"""Tests of a bit: `((x / 8) mod 2) = 1` as `is_set(x, 3)`, `to_integer(w(3 downto 3)) = 1` as `w(3) = '1'`, and
back."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from .words import Words, is_callable

FUNCTION = """\
  -- whether the bit of this place is 1
  function is_set(value : natural; place : natural) return boolean is
  begin
    return (value / 2 ** place) mod 2 = 1;
  end function;

"""
NAME = "is_set"
_MOD = (")", "mod", "2", ")", "=", "1")
_WORD = re.compile(r"unsigned\((\d+) downto 0\)")
_NUMBER = re.compile(r"(?:natural|integer) range (-?\d+) to (\d+)")


def top(kind: str) -> int:
    """The highest bit of a natural type or of a word, -1 of others."""
    if match := _WORD.fullmatch(kind):
        return int(match[1])
    match = _NUMBER.fullmatch(kind)
    return int(match[2]).bit_length() - 1 if match and int(match[1]) >= 0 else -1


def named(words: Words, kinds: Mapping[str, str]) -> Words:
    """`words`: one value or condition; `kinds`: of the names."""
    found: list[str] = []
    at = 0
    while at < len(words):
        size, test = _test(words, at, kinds)
        if size == 0:
            found.append(words[at])
            at += 1
            continue
        is_enclosed = found[-1:] == ["("] and words[at + size : at + size + 1] == (")",)
        if test[0] == NAME and is_enclosed and not (len(found) > 1 and is_callable(found[-2])):
            found.pop()
            size += 1
        found += test
        at += size
    made = tuple(found)
    return made if arithmetic(made, kinds) == words else words


def _test(words: Words, at: int, kinds: Mapping[str, str]) -> tuple[int, list[str]]:
    """(words of the test of a bit that begins here, what to write), (0, []) where none does."""
    if words[at] == "(":
        if words[at + 1 : at + 2] == ("(",) and words[at + 3 : at + 4] == ("/",) and words[at + 5 : at + 11] == _MOD:
            return _set(11, words[at + 2], words[at + 4])
        if words[at + 2 : at + 7] == ("mod", "2", ")", "=", "1"):
            return _set(7, words[at + 1], "1")
        if words[at + 2 : at + 3] == ("/",) and words[at + 4 : at + 7] == (")", "=", "1"):
            size, test = _set(7, words[at + 1], words[at + 3])
            return (size, test) if size and int(test[4]) == top(kinds.get(words[at + 1], "")) else (0, [])
    if words[at] == "to_integer" and words[at + 1 : at + 2] == ("(",) and words[at + 3 : at + 4] == ("(",):
        place = words[at + 4]
        if words[at + 5 : at + 11] == ("downto", place, ")", ")", "=", "1"):
            return 11, [words[at + 2], "(", place, ")", "=", "'1'"]
    return 0, []


def _set(size: int, name: str, factor: str) -> tuple[int, list[str]]:
    if not factor.isdigit() or int(factor) & (int(factor) - 1) or not name[0].isalpha():
        return 0, []
    return size, [NAME, "(", name, ",", str(int(factor).bit_length() - 1), ")"]


def arithmetic(words: Words, kinds: Mapping[str, str]) -> Words:
    """The inverse of `named`."""
    found: list[str] = []
    at = 0
    while at < len(words):
        if words[at] == NAME:
            test = _arithmetic(words[at + 2], int(words[at + 4]), kinds)
            found += test if len(words) == 6 else ["(", *test, ")"]
            at += 6
        elif words[at + 1 : at + 2] == ("(",) and words[at + 3 : at + 6] == (")", "=", "'1'"):
            name, place = words[at], words[at + 2]
            found += ["to_integer", "(", name, "(", place, "downto", place, ")", ")", "=", "1"]
            at += 6
        else:
            found.append(words[at])
            at += 1
    return tuple(found)


def _arithmetic(name: str, place: int, kinds: Mapping[str, str]) -> Sequence[str]:
    if place == top(kinds.get(name, "")):
        return "(", name, "/", str(1 << place), ")", "=", "1"
    inner = (name,) if place == 0 else ("(", name, "/", str(1 << place), ")")
    return "(", *inner, "mod", "2", ")", "=", "1"
