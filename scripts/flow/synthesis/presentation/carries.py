# SPDX-License-Identifier: Apache-2.0
"""The steps of a comparison, bit by bit: `choice(c, a or b, a and b)` as `carry(c, a, b)`, and back."""

from __future__ import annotations

from .words import Words, arguments, bare, in_parentheses

NAME = "carry"
INVERTED = "inverted_carry"
_OPERATORS = ("or", "and")

FUNCTION = """\
  -- the majority: a comparison or a sum as a chain of its bits
  function carry(before : boolean; a : boolean; b : boolean) return boolean is
  begin
    if before then
      return a or b;
    end if;
    return a and b;
  end function;

"""
INVERTED_FUNCTION = """\
  function inverted_carry(before : boolean; a : boolean; b : boolean) return boolean is
  begin
    if before then
      return a and b;
    end if;
    return a or b;
  end function;

"""


def made(test: Words, yes: Words, no: Words) -> Words:
    """In place of a choice; nothing where it is no carry."""
    for name, (first, second) in ((NAME, _OPERATORS), (INVERTED, _OPERATORS[::-1])):
        of_yes, of_no = _operands(yes, first), _operands(no, second)
        if of_yes and of_yes == of_no:
            a, b = map(bare, of_yes)
            found = (name, "(", *test, ",", *a, ",", *b, ")")
            if unmade(found) == (test, yes, no):
                return found
    return ()


def unmade(value: Words) -> tuple[Words, Words, Words] | None:
    """(test, value if so, value if not) of a carry."""
    if value[:1] not in ((NAME,), (INVERTED,)) or value[1:2] != ("(",):
        return None
    test, a, b = arguments(value[2:-1])
    first, second = _OPERATORS if value[0] == NAME else _OPERATORS[::-1]
    a, b = in_parentheses(a), in_parentheses(b)
    return test, (*a, first, *b), (*a, second, *b)


def _operands(words: Words, operator: str) -> tuple[Words, Words] | None:
    """Of a value that is this operation on two operands."""
    depth = 0
    places = []
    for at, word in enumerate(words):
        depth += {"(": 1, ")": -1}.get(word, 0)
        if depth == 0 and word in _OPERATORS:
            places.append(at)
    if len(places) != 1 or words[places[0]] != operator:
        return None
    return words[: places[0]], words[places[0] + 1 :]
