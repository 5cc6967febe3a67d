# SPDX-License-Identifier: Apache-2.0
"""Comparisons that the tool has split into steps of one bit, `choice_3 := carry(choice_2, not is_set(a, 6), is_set(b,
6))` and so on, as one call, and back. The variables of the steps are gone in between."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from typing import NamedTuple

from . import bits, carries, choices
from .tree import Assign, Statement, all_words
from .words import Words, arguments, bare, in_parentheses

NAME = "is_larger"
CALLED = (bits.NAME, carries.NAME)
KIND = "boolean"  # of the variables of the steps
FUNCTION = f"""\
  -- whether a > b, of bits `low` to `high`; of equal ones, `before`: bit by bit, as the tool has split it
  function {NAME}(a : natural; b : natural; low : natural; high : natural; before : boolean) return boolean is
    variable is_not : boolean := not before;
  begin
    for place in low to high loop
      is_not := {carries.NAME}(is_not, not {bits.NAME}(a, place), {bits.NAME}(b, place));
    end loop;
    return not is_not;
  end function;

"""
_FEWEST = 2  # steps of a comparison
_TARGET = re.compile(r"(\w+_choice)(?:_(\d+))?")
_FLAGS = (("false",), ("true",))  # before the first bit: its first two steps have forms of their own


class _Bit(NamedTuple):
    name: str
    place: int
    is_of_word: bool  # of bits, not a number


@dataclass(frozen=True)
class _Operand:
    name: str
    first: int | None = None  # of a word: the place of its bit 0

    def bit(self, place: int) -> Words:
        if self.first is None:
            return (bits.NAME, "(", self.name, ",", str(place), ")")
        return (self.name, "(", str(self.first + place), ")", "=", "'1'")

    def part(self, last: int) -> Words:
        """Bits 0 to `last`, as a number."""
        if self.first is None:
            return ("(", self.name, "mod", str(2 << last), ")")
        return ("to_integer", "(", self.name, "(", str(self.first + last), "downto", str(self.first), ")", ")")

    def words(self, high: int) -> Words:
        return (self.name,) if self.first is None else self.part(high)


def _operand(words: Words) -> _Operand:
    return _Operand(words[0]) if len(words) == 1 else _Operand(words[2], int(words[6]))


@dataclass(frozen=True)
class _Comparison:
    a: _Operand
    b: _Operand
    low: int
    high: int
    before: Words
    is_larger: bool  # or the complement

    def value(self) -> Words:
        places = (str(self.low),), (str(self.high),)
        call = _call(NAME, self.a.words(self.high), self.b.words(self.high), *places, self.before)
        return call if self.is_larger else ("not", *call)

    @property
    def steps(self) -> int:
        return self.high - self.low + 1


def _read(one: Assign) -> _Comparison:
    value = one.words[2:]
    is_larger = value[0] == NAME
    a, b, low, high, before = arguments(value[2:-1] if is_larger else value[3:-1])
    return _Comparison(_operand(a), _operand(b), int(low[0]), int(high[0]), before, is_larger)


@dataclass
class _Known:
    """Variables that have got their values."""

    variables: Container[str]
    of_value: dict[Words, str] = field(default_factory=dict)
    values: dict[str, Words] = field(default_factory=dict)

    def with_more(self, others: Iterable[Statement]) -> _Known:
        more = _Known(self.variables, dict(self.of_value), dict(self.values))
        for one in others:
            more.add(one)
        return more

    def add(self, one: Statement) -> None:
        if words := _of_variable(one):
            self.of_value.setdefault(words[2:], words[0])
            self.values[words[0]] = words[2:]

    def said(self, value: Words) -> Words:
        """A name, where there is a variable of this value."""
        name = self.of_value.get(value)
        return (name,) if name else value

    def bit(self, words: Words) -> _Bit | None:
        """That this says or stands for."""
        if len(words) == 1:
            words = self.values.get(words[0], words)
        if words[:1] == ("not",):
            return None
        words = bare(words)
        if len(words) != 6:
            return None
        if words[0] == bits.NAME:
            return _Bit(words[2], int(words[4]), False)
        return _Bit(words[0], int(words[2]), True) if words[5] == "'1'" and words[2].isdigit() else None


# --- there ------------------------------------------------------------------------------------------------------------


def made(statements: Sequence[Statement], variables: Container[str]) -> tuple[Statement, ...]:
    """Of the statements of a clock."""
    uses = Counter(chain.from_iterable(all_words(statements)))
    known = _Known(variables)
    found: list[Statement] = []
    start = at = 0  # in `found`, of the run of assignments behind the last comparison; in `statements`
    while at < len(statements):
        size = _folded(statements, at, found, start, known, uses)
        if size:
            start = len(found)
            at += size
            continue
        known.add(statements[at])
        found.append(statements[at])
        at += 1
    return tuple(found)


def _folded(
    statements: Sequence[Statement], at: int, found: list[Statement], start: int, known: _Known, uses: Mapping[str, int]
) -> int:
    """How many statements from this one on were added to `found` as one comparison and what its steps read; `start`: of
    those in `found` that `unmade` may move."""
    guesses = _guesses(statements[at], known)
    if not guesses:
        return 0
    steps = _linked(statements, at, uses)
    for count in range(len(steps), _FEWEST - 1, -1):
        region = statements[at : steps[count - 1] + 1]
        if any(_written(guess, region, count, found, start, known) for guess in guesses):
            return len(region)
    return 0


def _linked(statements: Sequence[Statement], at: int, uses: Mapping[str, int]) -> list[int]:
    """Places of assignments that are read by the next one of them only, with no others between them than of
    variables."""
    steps = [at]
    for place in range(at + 1, len(statements)):
        words, (before, *_) = _of_variable(statements[place]), _of_variable(statements[steps[-1]])
        if not words:
            break
        if _TARGET.fullmatch(words[0]):
            if before not in words or uses[before] != 2:  # there and where it is assigned
                break
            steps.append(place)
    return steps


def _written(
    guess: _Comparison, region: Sequence[Statement], count: int, found: list[Statement], start: int, known: _Known
) -> bool:
    """Adds the comparison of so many steps where it is undone to what was there."""
    last = region[-1]
    assert isinstance(last, Assign)
    names = _names(last.words[0], count)
    others = [one for one in region if isinstance(one, Assign) and one.words[0] not in names]
    more, run = known.with_more(others), _run(found, start)
    for is_larger in (True, False):
        said = _Comparison(guess.a, guess.b, guess.low, guess.low + count - 1, guess.before, is_larger)
        one = Assign((*last.words[:2], *said.value()))
        if _undone([*run, *others], one, more) == [*run, *region]:
            found += [*others, one]
            for other in others:
                known.add(other)
            return True
    return False


def _guesses(one: Statement, known: _Known) -> list[_Comparison]:
    """What this may be the first step of."""
    words = _of_variable(one)
    if words[3:4] != ("(",) or not _TARGET.fullmatch(words[0]):
        return []
    kind, terms = words[2], arguments(words[4:-1])
    if kind == choices.NAME and (a := known.bit(terms[0])):
        yes, no = (known.bit(_complement(terms[at])) for at in (1, 2))
        return [
            _comparison(a, b._replace(place=b.place - 1), 0, before)
            for b, before in ((no, _FLAGS[0]), (yes, _FLAGS[1]))
            if b
        ]
    if kind not in (carries.NAME, carries.INVERTED):
        return []
    b = known.bit(terms[2])
    if kind == carries.INVERTED and b and (a := known.bit(terms[0])):
        return [_comparison(a, b, _low(a, b), _complement(terms[1]))]
    a = known.bit(_complement(terms[1]))
    if a is None or b is None or len(terms[0]) != 1:
        return []
    return [_comparison(a, b, _low(a, b), terms[0] if kind == carries.INVERTED else ("not", *terms[0]))]


def _low(a: _Bit, b: _Bit) -> int:
    return next((one.place for one in (a, b) if not one.is_of_word), 0)


def _comparison(a: _Bit, b: _Bit, low: int, before: Words) -> _Comparison:
    """From this bit on, which is bit `low` of both."""
    first, second = (_Operand(one.name, one.place - low if one.is_of_word else None) for one in (a, b))
    return _Comparison(first, second, low, low, before, True)


# --- and back ---------------------------------------------------------------------------------------------------------


def unmade(statements: Sequence[Statement], variables: Container[str]) -> tuple[tuple[Statement, ...], list[str]]:
    """(the statements of a clock, the variables of the steps)"""
    known = _Known(variables)
    found: list[Statement] = []
    names: list[str] = []
    start = 0
    for one in statements:
        if not isinstance(one, Assign) or NAME not in one.words:
            known.add(one)
            found.append(one)
            continue
        run = _run(found, start)
        del found[len(found) - len(run) :]
        found += _undone(run, one, known)
        names += _names(one.words[0], _read(one).steps)[:-1]
        start = len(found)
    return tuple(found), names


def _run(found: Sequence[Statement], start: int) -> list[Statement]:
    """The assignments of variables at the end."""
    at = len(found)
    while at > start and _of_variable(found[at - 1]):
        at -= 1
    return list(found[at:])


def _of_variable(one: Statement) -> Words:
    """The words of an assignment to a variable, none of other statements."""
    return one.words if isinstance(one, Assign) and one.words[1:2] == (":=",) else ()


def _names(target: str, count: int) -> list[str]:
    """Of the variables of so many steps, the last one is `target`."""
    match = _TARGET.fullmatch(target)
    if match is None:
        raise ValueError(f"{target} is no variable of a comparison")
    last = int(match[2] or 1)
    return [match[1] + (f"_{number}" if number > 1 else "") for number in range(last - count + 1, last + 1)]


def _undone(run: Sequence[Statement], one: Assign, known: _Known) -> list[Statement]:
    """The steps behind the assignments that stand before them. Those which only a later step reads go there."""
    said = _read(one)
    names = _names(one.words[0], said.steps)
    steps = [Assign((name, ":=", *value)) for name, value in zip(names, _values(said, names, known))]
    # Of a name: the first step that reads it. The lowering writes what the second one tests before the first one.
    reader = {known.said(said.a.bit(1))[0]: 0} if said.before in _FLAGS else {}
    for number, step in enumerate(steps):
        for word in step.words[2:]:
            reader.setdefault(word, number)
    found: list[Statement] = []
    before: list[list[Statement]] = [[] for _ in steps]
    for other in run:
        assert isinstance(other, Assign)
        number = reader.get(other.words[0], 0)
        (before[number] if number else found).append(other)
    for others, step in zip(before, steps):
        found += [*others, step]
    return found


def _values(one: _Comparison, names: Sequence[str], known: _Known) -> Iterable[Words]:
    """Of the steps."""
    of_pair = one.before in _FLAGS
    for number, place in enumerate(range(one.low, one.high + 1)):
        a, b = known.said(one.a.bit(place)), known.said(one.b.bit(place))
        before = (names[number - 1],) if number else one.before
        if of_pair and number < 2:
            yield _of_pair(one, number, before, known)
        elif number and place == one.high and one.is_larger:
            yield _call(carries.NAME if of_pair and number == 2 else carries.INVERTED, before, a, _not(b))
        elif number == 0 and before[0] != "not" and before[0] not in known.variables:
            yield _call(carries.INVERTED, a, _not(before), b)
        elif number == 0 and before[0] == "not":
            yield _call(carries.NAME, before[1:], _not(a), b)
        else:
            inverts = number == 0 or (of_pair and number == 2)
            yield _call(carries.INVERTED if inverts else carries.NAME, before, _not(a), b)


def _of_pair(one: _Comparison, number: int, before: Words, known: _Known) -> Words:
    """The steps of the lowest two bits, `a > b` or `a >= b`."""
    (a, below), (b, above) = ([known.said(term.bit(place)) for place in (0, 1)] for term in (one.a, one.b))
    none = known.said((*one.b.part(1), "=", "0"))
    not_all = (*in_parentheses(_not(above)), "or", *in_parentheses(_not(b)))
    if one.before == _FLAGS[0]:
        if number == 0:
            return _call(choices.NAME, a, known.said(not_all), _not(above))
        return _call(choices.NAME, below, before, (*in_parentheses(a), "and", *in_parentheses(none)))
    if number == 0:
        return _call(choices.NAME, a, _not(above), none)
    return _call(choices.NAME, below, (*in_parentheses(a), "or", *not_all), before)


def _not(value: Words) -> Words:
    return ("not", *in_parentheses(value))


def _complement(value: Words) -> Words:
    return bare(value[1:]) if value[:1] == ("not",) else ("not", *value)


def _call(name: str, *terms: Words) -> Words:
    words = [word for term in terms for word in (*term, ",")]
    return (name, "(", *words[:-1], ")")
