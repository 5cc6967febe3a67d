# SPDX-License-Identifier: Apache-2.0
"""The memories of a block-matching core, and those that other families share with it: depth and width of each, as the
blocks in hls/ have them. test_plan.py compares them with the VHDL of every committed core."""

from __future__ import annotations

from typing import NamedTuple

from .window_shape import MARGIN_BITS, SUPPORT_ROWS, WindowShape, bits_for

DISPARITY_BITS = 8  # as the C++ holds a disparity where nothing says that fewer are enough


class Memory(NamedTuple):
    depth: int
    width: int


def packed(lane_bits: int, lanes: int, top_bits: int | None = None, word_bits: int = 32) -> list[int]:
    """Widths of the words that hold so many numbers (hls/support/packed.hpp). top_bits: those that the highest number
    in a word really has, as the tools take away what is never set."""
    top_bits = lane_bits if top_bits is None else top_bits
    fitting = word_bits // lane_bits if lane_bits <= word_bits else 1
    per_word = min(fitting, lanes)
    counts = [min(per_word, lanes - first) for first in range(0, lanes, per_word)]
    return [lane_bits * (count - 1) + top_bits for count in counts]


def word_bits_of(words: int, wished: int) -> int:
    """Of a memory with so many words (hls/support/packed.hpp)."""
    return wished if wished == 8 or words * wished <= 100_000 else word_bits_of(words, wished // 2)


def bank(depth: int, widths: list[int]) -> list[Memory]:
    return [Memory(depth, width) for width in widths]


def front_end(shape: WindowShape, delays: bool = True) -> list[Memory]:
    """The rows of both images in front of the transform, the image that is held back, the rows of the windows."""
    s, found = shape, []
    if s.has_transform:
        stored = s.transform_groups * s.pixels + s.transform_rows
        found += 2 * bank(s.width, packed(s.pixel_bits, stored))
    if delays and s.delay > 0:
        found += bank(s.delay + 1, packed(s.feature_bits, s.pixels))
    if s.stored_rows:
        found += 2 * bank(s.width, packed(s.feature_bits, s.stored_rows))
    return found


def column_and_window(shape: WindowShape, lanes: int, columns: int, column_bits: int) -> list[Memory]:
    """Of recursive sums of so many disparities: a row of column costs, and a ring of the window's columns."""
    ring = packed(column_bits, shape.pixels * lanes)
    above = packed(column_bits, lanes, word_bits=word_bits_of(columns, 32))
    return bank(columns, above) + bank(shape.window + 1, ring)


def slices(shape: WindowShape) -> list[Memory]:
    s, found = shape, []
    columns = s.passes_columns if s.is_folded else s.width
    for lanes in s.slices:
        if s.recursive:
            found += column_and_window(s, lanes, columns, s.column_bits)
        elif s.options.get("sign_memory", False) and s.options["cost"] == "sad":
            found += (s.taps - s.pixels) * bank(s.width, packed(1, lanes))
    return found


def texture(shape: WindowShape) -> list[Memory]:
    if not (shape.texture and shape.recursive):
        return []
    columns = shape.passes_columns if shape.is_folded else shape.width
    return column_and_window(shape, 1, columns, bits_for(2 * shape.options["prefilter_cap"] * shape.window))


def left_right_check(shape: WindowShape) -> list[Memory]:
    """The winners until the other image's pixel is known, and that image's winners."""
    s = shape
    winner = s.pixels * (9 + (5 if s.subpixel else 0)) + 4
    found = bank(s.disparities, [winner, *([s.pixels * MARGIN_BITS] if s.confidence else [])])
    other = DISPARITY_BITS if s.is_folded else s.disparity_bits
    return found + s.pixels * [Memory(1 << bits_for(s.disparities + 3), other)]


def post_processing(shape: WindowShape, value_bits: int) -> list[Memory]:
    """value_bits: of a whole disparity as it comes."""
    s, found = shape, []
    if s.supports:
        groups = -(-SUPPORT_ROWS // s.pixels)
        found += bank(s.output_width, packed(s.disparity_bits + 1, groups * s.pixels + SUPPORT_ROWS))
        rest = (4 if s.subpixel else 0) + (MARGIN_BITS if s.confidence else 0)
        if rest:
            found += bank(s.output_width, packed(rest, groups * s.pixels))
    of_map = s.disparity_bits + 4 if s.subpixel else s.disparity_bits
    if s.fills:
        found += bank(s.output_width, packed(of_map + 1 + (8 if s.confidence else 0), s.pixels))
        found += s.pixels * [Memory(s.output_width // 2 + 4, of_map + bits_for(s.output_width - 1) + 1)]
        value_bits = 8 if of_map <= 8 else 16
        found.append(Memory(s.output_width, value_bits))
    if s.median:
        lane = s.map_bits + 1
        top = lane if s.subpixel and not s.fills else min(lane, value_bits + 1)
        found += bank(s.output_width, packed(lane, s.pixels + 1, top))
        beside = (8 if s.confidence else 0) + (1 if s.fills else 0)
        if beside:
            found += bank(s.output_width, packed(beside, s.pixels))
    return found


def two_rows(shape: WindowShape) -> int:
    """Places of one row, a power of two."""
    return 1 << bits_for(shape.width - 1)


def passes(shape: WindowShape) -> list[Memory]:
    """Of a folded core: the rows that are shown again, the best so far, the winners, the other image's."""
    s = shape
    columns = two_rows(s)
    found = 2 * bank(2 * columns, packed(s.feature_bits, s.taps))
    lane = max(s.window_bits, s.disparity_bits)
    best = packed(lane, 5 if s.subpixel else 2)
    if best[0] == 2 * lane:  # a disparity is the highest number in its word
        best[0] = lane + min(lane, DISPARITY_BITS)
    found += bank(columns, best)
    if s.has_second:
        found += bank(columns, packed(bits_for((1 << s.window_bits) - 1), 2))
    has_check = s.left_right or s.unique or s.texture or s.supports
    beside = (5 if s.subpixel else 0) + (MARGIN_BITS if s.confidence else 0)
    found.append(Memory(2 * columns, s.disparity_bits + beside + has_check))
    if s.left_right:
        found += bank(columns, packed(lane, 2, min(lane, DISPARITY_BITS))) + [Memory(2 * columns, DISPARITY_BITS)]
    return found


def block_matching(shape: WindowShape) -> list[Memory]:
    s = shape
    found = front_end(s, delays=not s.is_folded) + slices(s) + texture(s)
    if s.is_folded:
        found += passes(s)
    elif s.left_right:
        found += left_right_check(s)
    return found + post_processing(s, s.disparity_bits)
