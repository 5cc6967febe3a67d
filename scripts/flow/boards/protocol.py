# SPDX-License-Identifier: Apache-2.0
"""What goes over the serial line: examples/boards/README.md."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from ..base.errors import EXIT_TOOL_FAILED, FlowError

LETTERS = b"SP"
BYTES = 2  # of a pair, and of a disparity
QUIET_SECONDS = 0.25  # after so long the board waits for a frame's letters: twice quiet_ms of board_top
VALID, START, END, ERROR = 1, 2, 4, 8
MARK = 0xA0


class Map(NamedTuple):
    """Row by row."""

    disparities: bytes
    valid: list[bool]


def frame(left: bytes, right: bytes) -> bytes:
    """A pair, of grey values row by row."""
    pixels = bytearray(BYTES * len(left))
    pixels[0::2], pixels[1::2] = left, right
    return LETTERS + bytes(pixels)


def answer_bytes(sizes: Mapping[str, int]) -> int:
    return BYTES * sizes["output_width_px"] * sizes["height_px"]


def read_map(answer: Sequence[int], sizes: Mapping[str, int]) -> Map:
    """The map that came back. Raises FlowError where it is not whole, or not a map of this size."""
    width, expected = sizes["output_width_px"], answer_bytes(sizes)
    for place in range(0, len(answer) - 1, BYTES):
        flags, number = answer[place + 1], place // BYTES
        x, y = number % width, number // width
        wanted = MARK | (START if number == 0 else 0) | (END if x == width - 1 else 0)
        if flags & ~VALID != wanted:
            what = "marks an incomplete frame" if flags & ~VALID == wanted | ERROR else "belongs to another place"
            raise FlowError(
                f"the answer is no map of {width}x{sizes['height_px']}: disparity {number} (x {x}, y {y}) has the "
                f"flags {flags:#04x}, which {what}",
                EXIT_TOOL_FAILED,
            )
    if len(answer) != expected:
        raise FlowError(f"the board answered {len(answer)} bytes instead of {expected}", EXIT_TOOL_FAILED)
    return Map(bytes(answer[0::BYTES]), [bool(flags & VALID) for flags in answer[1::BYTES]])
