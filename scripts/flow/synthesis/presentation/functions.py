# SPDX-License-Identifier: Apache-2.0
"""The functions that presented VHDL has besides those of the lowering."""

from __future__ import annotations

from collections.abc import Iterable

from . import bits, choices

_OF_CHOICES = {kind: choices.function(kind) for kind in ("boolean", "integer", "unsigned")}
ALL = (bits.FUNCTION, *_OF_CHOICES.values())


def without(text: str) -> str:
    for function in ALL:
        text = text.replace(function, "", 1)
    return text


def needed(has_bits: bool, kinds_of_choices: Iterable[str]) -> str:
    """`kinds_of_choices`: types of their targets."""
    bases = {"unsigned" if kind.startswith("unsigned") else kind for kind in kinds_of_choices}
    used = {base if base in _OF_CHOICES else "integer" for base in bases}
    return (bits.FUNCTION if has_bits else "") + "".join(_OF_CHOICES[kind] for kind in sorted(used))
