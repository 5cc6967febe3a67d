# SPDX-License-Identifier: Apache-2.0
"""The smaller of two numbers: `choice((a - b) < 0, a, b)` as `smaller(a, b)`, and back."""

from __future__ import annotations

from .words import Words, arguments

NAME = "smaller"
FUNCTION = f"""\
  function {NAME}(a : integer; b : integer) return integer is
  begin
    if (a - b) < 0 then
      return a;
    end if;
    return b;
  end function;

"""


def made(test: Words, yes: Words, no: Words) -> Words:
    """In place of a choice; nothing where it is another one."""
    return (NAME, "(", *yes, ",", *no, ")") if test == ("(", *yes, "-", *no, ")", "<", "0") else ()


def unmade(value: Words) -> tuple[Words, Words, Words] | None:
    """(test, value if so, value if not) of a smaller number."""
    if value[:2] != (NAME, "("):
        return None
    yes, no = arguments(value[2:-1])
    return ("(", *yes, "-", *no, ")", "<", "0"), yes, no
