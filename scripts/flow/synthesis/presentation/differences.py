# SPDX-License-Identifier: Apache-2.0
"""Counts of bits that differ, `as_number((is_set(a, 3) /= is_set(b, 3))) + ...` as `differing(a, b, 3, 5, 4)`, and
back. Variables for bits that several of them take are gone in between."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator, Mapping, Sequence
from typing import NamedTuple, Union

from . import bits
from .tree import Assign, Comment, Statement, all_words
from .words import Words, arguments

OF_NUMBERS, OF_WORDS = "differing", "differing_bits"
KIND = "boolean"  # of the variables
_AT_ONCE = 3  # bits that one call counts, besides calls for one
_OPEN = ("as_number", "(", "(")
_VALUE = "_value"


def _function(name: str, kind: str, is_set: str) -> str:
    return f"""\
  -- 1 where this bit differs
  function {name}(a : {kind}; b : {kind}; place : natural) return natural is
  begin
    return as_number({is_set.format("a")} /= {is_set.format("b")});
  end function;

  function {name}(a : {kind}; b : {kind}; p : natural; q : natural; r : natural) return natural is
  begin
    return {name}(a, b, p) + {name}(a, b, q) + {name}(a, b, r);
  end function;

"""


FUNCTIONS = {
    OF_NUMBERS: _function(OF_NUMBERS, "natural", f"{bits.NAME}({{}}, place)"),
    OF_WORDS: _function(OF_WORDS, "unsigned", "({}(place) = '1')"),
}


class _Bit(NamedTuple):
    name: str
    place: int
    is_of_word: bool  # of bits, not a number

    def words(self) -> Words:
        if self.is_of_word:
            return self.name, "(", str(self.place), ")", "=", "'1'"
        return bits.NAME, "(", self.name, ",", str(self.place), ")"


class _Term(NamedTuple):
    """1 where two bits of one place differ."""

    a: str
    b: str
    place: int
    is_of_words: bool

    def bits(self) -> tuple[_Bit, _Bit]:
        return _Bit(self.a, self.place, self.is_of_words), _Bit(self.b, self.place, self.is_of_words)


_Parts = list[Union[str, _Term]]  # of a value


# --- there ------------------------------------------------------------------------------------------------------------


def made(statements: Sequence[Statement], kinds: Mapping[str, str]) -> tuple[Statement, ...]:
    """Section by section."""
    found: list[Statement] = []
    for section in _sections(statements):
        called = _called(section, kinds)
        found += called if called and unmade(called, kinds)[0] == tuple(section) else section
    return tuple(found)


def _sections(statements: Sequence[Statement]) -> Iterator[Sequence[Statement]]:
    """Each begins with its comment."""
    starts = [at for at, one in enumerate(statements) if isinstance(one, Comment)]
    for first, last in zip([0, *starts], [*starts, len(statements)]):
        if first < last:
            yield statements[first:last]


def _called(section: Sequence[Statement], kinds: Mapping[str, str]) -> tuple[Statement, ...]:
    """Nothing where no bits are counted."""
    known = {}
    for one in section:
        if isinstance(one, Assign) and one.words[1] == ":=" and kinds.get(one.words[0]) == KIND:
            bit = _bit(one.words[2:])
            if bit and one.words[0].partition(_VALUE)[1]:
                known[one.words[0]] = bit
    found: list[Statement] = []
    for one in section:
        found.append(one)
        if isinstance(one, Assign) and one.words[1] == "<=":
            parts = _parts(one.words[2:], known)
            if len(parts) < len(one.words) - 2:
                found[-1] = Assign(one.words[:2] + _shown(parts))
    if found == list(section):
        return ()
    read = {word for words in all_words(found) for word in words[1:]}
    return tuple(one for one in found if not (isinstance(one, Assign) and _is_needless(one.words[0], known, read)))


def _is_needless(name: str, known: Container[str], read: Container[str]) -> bool:
    return name in known and name not in read


def _bit(words: Words) -> _Bit | None:
    """That these words test."""
    if words[:2] == (bits.NAME, "(") and len(words) == 6 and words[4].isdigit():
        return _Bit(words[2], int(words[4]), False)
    if len(words) == 6 and words[1] == "(" and words[2].isdigit() and words[3:] == (")", "=", "'1'"):
        return _Bit(words[0], int(words[2]), True)
    return None


def _parts(value: Words, known: Mapping[str, _Bit]) -> _Parts:
    """The words with a term in place of those that say it."""
    found: _Parts = []
    at = 0
    while at < len(value):
        size, term = _term(value, at, known)
        found.append(term or value[at])
        at += size
    return found


def _term(value: Words, at: int, known: Mapping[str, _Bit]) -> tuple[int, _Term | None]:
    """(words, the term) that begins here"""
    if value[at : at + 3] != _OPEN:
        return 1, None
    place, operands = at + 3, []
    for end in ("/=", ")"):
        size, bit = _operand(value, place, known)
        place += size
        if bit is None or value[place : place + 1] != (end,):
            return 1, None
        operands.append(bit)
        place += 1
    a, b = operands
    if value[place : place + 1] != (")",) or a[1:] != b[1:]:
        return 1, None
    return place + 1 - at, _Term(a.name, b.name, a.place, a.is_of_word)


def _operand(value: Words, at: int, known: Mapping[str, _Bit]) -> tuple[int, _Bit | None]:
    if value[at] in known:
        return 1, known[value[at]]
    if value[at] == bits.NAME:
        return 6, _bit(value[at : at + 6])
    if value[at] == "(" and value[at + 7 : at + 8] == (")",):
        return 8, _bit(value[at + 1 : at + 7])
    return 1, None


def _shown(parts: _Parts) -> Words:
    found: list[str] = []
    at = 0
    while at < len(parts):
        one = parts[at]
        if isinstance(one, str):
            found.append(one)
            at += 1
            continue
        size = _AT_ONCE if found[-1:] != ["+"] and _are_together(parts[at : at + 2 * _AT_ONCE - 1]) else 1
        places = [term.place for term in parts[at : at + 2 * size - 1 : 2] if isinstance(term, _Term)]
        found += [OF_WORDS if one.is_of_words else OF_NUMBERS, "(", one.a, ",", one.b]
        for place in places:
            found += [",", str(place)]
        found.append(")")
        at += 2 * size - 1
    return tuple(found)


def _are_together(parts: _Parts) -> bool:
    """So many terms of the same operands, and their sum."""
    terms = [one for one in parts[::2] if isinstance(one, _Term)]
    is_sum = len(terms) == _AT_ONCE and all(one == "+" for one in parts[1::2])
    return is_sum and len({(one.a, one.b, one.is_of_words) for one in terms}) == 1


# --- and back ---------------------------------------------------------------------------------------------------------


def unmade(statements: Sequence[Statement], kinds: Mapping[str, str]) -> tuple[tuple[Statement, ...], list[str]]:
    """(the statements, the variables)"""
    found: list[Statement] = []
    names: list[str] = []
    for section in _sections(statements):
        values = [_terms(one.words[2:]) if isinstance(one, Assign) else [] for one in section]
        if not any(isinstance(part, _Term) for parts in values for part in parts):
            found += section
            continue
        variables = _variables(section, values, kinds)
        names += variables.values()
        start = 1 if isinstance(section[0], Comment) else 0
        found += section[:start]
        found += [Assign((name, ":=", *bit.words())) for bit, name in variables.items()]
        for one, parts in list(zip(section, values))[start:]:
            is_changed = isinstance(one, Assign) and any(isinstance(part, _Term) for part in parts)
            found.append(Assign(one.words[:2] + _written(parts, variables)) if is_changed else one)  # type: ignore
    return tuple(found), names


def _terms(value: Words) -> _Parts:
    """The inverse of `_shown`."""
    found: _Parts = []
    at = 0
    while at < len(value):
        if value[at] not in FUNCTIONS:
            found.append(value[at])
            at += 1
            continue
        end = value.index(")", at)
        (a,), (b,), *places = arguments(value[at + 2 : end])
        for (place,) in places:
            found += ["+", _Term(a, b, int(place), value[at] == OF_WORDS)]
        del found[-2 * len(places)]
        at = end + 1
    return found


def _variables(section: Sequence[Statement], values: Sequence[_Parts], kinds: Mapping[str, str]) -> dict[_Bit, str]:
    """Of bits that are taken more than once, in the order of their use, with names of their first users."""
    terms = [part for parts in values for part in parts if isinstance(part, _Term)]
    uses = Counter(bit for term in terms for bit in term.bits())
    found: dict[_Bit, str] = {}
    for one, parts in zip(section, values):
        count = 0
        for bit in (bit for part in parts if isinstance(part, _Term) for bit in part.bits()):
            if uses[bit] > 1 and bit not in found and bit.place not in (0, bits.top(kinds.get(bit.name, ""))):
                count += 1
                assert isinstance(one, Assign)
                found[bit] = one.words[0] + _VALUE + (f"_{count}" if count > 1 else "")
    return found


def _written(parts: _Parts, variables: Mapping[_Bit, str]) -> Words:
    found: list[str] = []
    for one in parts:
        if isinstance(one, str):
            found.append(one)
            continue
        a, b = ((variables[bit],) if bit in variables else _enclosed(bit) for bit in one.bits())
        found += [*_OPEN, *a, "/=", *b, ")", ")"]
    return tuple(found)


def _enclosed(bit: _Bit) -> Words:
    return ("(", *bit.words(), ")") if bit.is_of_word else bit.words()
