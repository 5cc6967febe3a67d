# SPDX-License-Identifier: Apache-2.0
"""The sizes and memories of a core: of the families whose options say them, or of any committed one by its VHDL."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from ..base import committed
from ..implementation import yosys
from ..synthesis.presentation import scalars
from .path_memories import semi_global
from .path_shape import PathShape
from .window_memories import Memory, block_matching
from .window_shape import WindowShape

_Shapes = Mapping[str, tuple[Callable[[Mapping[str, Any]], Any], Callable[[Any], list[Memory]]]]
FAMILIES: _Shapes = {
    "block_matching": (WindowShape, block_matching),
    "semi_global": (PathShape, semi_global),
}
_MEMORY = re.compile(r"entity work\.line_memory\s+generic map \(depth => (\d+), width => (\d+)")


def shape_of(options: Mapping[str, Any]) -> WindowShape:
    """Of one of FAMILIES."""
    shape: WindowShape = FAMILIES[options["family"]][0](options)
    return shape


def memories_of(shape: WindowShape) -> list[Memory]:
    return FAMILIES[shape.options["family"]][1](shape)


def memories_in_vhdl(config: str) -> list[Memory]:
    """Of a committed core of any family."""
    (core,) = scalars.files([committed.folder(config) / f"{committed.entity(config)}.vhd"])
    text = core.read_text()
    return [Memory(int(depth), int(width)) for depth, width in _MEMORY.findall(text)]


def shows_word_before(options: Mapping[str, Any]) -> bool:
    """Whether a read must show the word before a write of the same clock; else that is left to the RAM."""
    return not yosys.looks_at_no_word_being_written(options)
