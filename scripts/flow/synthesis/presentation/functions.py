# SPDX-License-Identifier: Apache-2.0
"""The functions that presented VHDL has besides those of the lowering."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable

from ...base.errors import FlowError
from . import bits, carries, choices, comparisons, differences, extremes

_NAMED = {
    bits.NAME: bits.FUNCTION,
    carries.NAME: carries.FUNCTION,
    carries.INVERTED: carries.INVERTED_FUNCTION,
    comparisons.NAME: comparisons.FUNCTION,
    extremes.NAME: extremes.FUNCTION,
    **differences.FUNCTIONS,
}
_OF_CHOICES = {kind: choices.function(kind) for kind in ("boolean", "integer", "unsigned")}
NAMES = {*_NAMED, choices.NAME}
ALL = (*_NAMED.values(), *_OF_CHOICES.values())
_OWN = re.compile(rf"^\s*function ({'|'.join(sorted(NAMES))})\b", re.MULTILINE)


def without(text: str) -> str:
    for function in ALL:
        text = text.replace(function, "", 1)
    if match := _OWN.search(text):
        raise FlowError(f"unknown form of VHDL: the function {match[1]} was edited")
    return text


def needed(words: Collection[str], kinds_of_choices: Iterable[str]) -> str:
    """`words`: all of the text; `kinds_of_choices`: types of their targets."""
    bases = {"unsigned" if kind.startswith("unsigned") else kind for kind in kinds_of_choices}
    used = {base if base in _OF_CHOICES else "integer" for base in bases}
    names = {*words, *(comparisons.CALLED if comparisons.NAME in words else ())}
    names |= {bits.NAME} if differences.OF_NUMBERS in words else set()
    named = "".join(text for name, text in _NAMED.items() if name in names)
    return named + "".join(_OF_CHOICES[kind] for kind in sorted(used))
