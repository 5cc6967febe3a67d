# SPDX-License-Identifier: Apache-2.0
"""Choices between two values, `if c then x <= a; else x <= b; end if;`, as `x <= choice(c, a, b);`, and back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from . import carries, extremes
from .tree import Assign, For, If, Statement, inside
from .words import arguments, sign_of

NAME = "choice"
_MOST = 60  # characters of a condition that stands in more than two statements
# Both values of a choice are evaluated: no calls that refuse a number which an `if` may keep from them.
_STRICT = ("to_unsigned", "resize")


def function(kind: str) -> str:
    """Of one type of values."""
    return f"""\
  function {NAME}(test : boolean; yes : {kind}; no : {kind}) return {kind} is
  begin
    if test then
      return yes;
    end if;
    return no;
  end function;

"""


def made(statements: Iterable[Statement]) -> tuple[Statement, ...]:
    found: list[Statement] = []
    for one in statements:
        if not isinstance(one, If):
            found.append(one)
        elif (chosen := _chosen(one)) is not None:
            found += chosen
        else:
            found.append(inside(one, made))
    return tuple(found)


def _chosen(one: If) -> list[Assign] | None:
    if one.otherwise is None or len(one.then) != len(one.otherwise):
        return None
    if len(one.then) > 2 and sum(map(len, one.test)) > _MOST:
        return None
    found = []
    for yes, no in zip(one.then, one.otherwise):
        if not isinstance(yes, Assign) or not isinstance(no, Assign):
            return None
        sign = sign_of(yes.words)
        if yes.words[: sign + 1] != no.words[: sign + 1] or (yes.words[sign] == ":=" and len(one.then) > 1):
            return None
        values = yes.words[sign + 1 :], no.words[sign + 1 :]
        if any(word in _STRICT for value in values for word in value):
            return None
        said = carries.made(one.test, *values) or extremes.made(one.test, *values)
        said = said or (NAME, "(", *one.test, ",", *values[0], ",", *values[1], ")")
        found.append(Assign(yes.words[: sign + 1] + said))
    return found


def unmade(statements: Iterable[Statement]) -> tuple[Statement, ...]:
    """Neighbours of one condition share an `if`, but for variables, as the lowering writes them."""
    return tuple(_joined(_single(statements)))


def _single(statements: Iterable[Statement]) -> Iterator[Statement]:
    for one in statements:
        if isinstance(one, Assign):
            yield _if(one)
        elif isinstance(one, If):
            yield inside(one, unmade)
        else:
            assert not isinstance(one, For)
            yield one


def _if(one: Assign) -> Statement:
    start = sign_of(one.words) + 1
    head, value = one.words[:start], one.words[start:]
    parts = carries.unmade(value) or extremes.unmade(value)
    if parts is None and value[:2] == (NAME, "("):
        test, yes, no = arguments(value[2:-1])
        parts = test, yes, no
    if parts is None:
        return one
    test, yes, no = parts
    return If(test, (Assign(head + yes),), (Assign(head + no),))


def _joined(statements: Iterable[Statement]) -> list[Statement]:
    found: list[Statement] = []
    open_branches: tuple[tuple[Statement, ...], tuple[Statement, ...]] | None = None  # of a choice that stands last
    for one in statements:
        branches = _branches(one)
        before = found[-1] if found else None
        if branches and open_branches and isinstance(one, If) and isinstance(before, If) and before.test == one.test:
            open_branches = open_branches[0] + branches[0], open_branches[1] + branches[1]
            found[-1] = If(one.test, *open_branches)
        else:
            open_branches = branches
            found.append(one)
    return found


def _branches(one: Statement) -> tuple[tuple[Statement, ...], tuple[Statement, ...]] | None:
    """Of a choice of registers."""
    if not isinstance(one, If) or one.otherwise is None:
        return None
    is_choice = all(isinstance(part, Assign) and part.words[sign_of(part.words)] == "<=" for part in one.then)
    return (one.then, one.otherwise) if is_choice else None
