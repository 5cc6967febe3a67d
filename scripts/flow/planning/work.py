# SPDX-License-Identifier: Apache-2.0
"""How much of each kind of work a core does in a clock, in bits: what its look-up tables are for. Counted from the
blocks in hls/, before any tool: a bit of an adder, a comparison or a choice counts as one."""

from __future__ import annotations

from typing import NamedTuple

from .path_shape import PathShape
from .window_shape import WindowShape, bits_for

_SORTED = 19  # comparisons of a median of 3x3
_DIVISION = 12  # steps of the subpixel division: comparisons and subtractions
_SOBEL = 8  # sums of an x-Sobel


class Work(NamedTuple):
    costs: int  # of pairs of pixels
    sums: int  # of columns and windows
    winners: int  # the smallest cost, its disparity, what the checks ask about it
    paths: int
    beside: int  # what there is once, however many disparities are compared: transforms, refinement, median, passes


def _pixel_cost(shape: WindowShape) -> int:
    """Of a tap and a disparity. SAD in three clocks leaves the sign of a difference to the adders behind it; with a
    sign memory even the comparison."""
    s, o = shape, shape.options
    if s.is_census:
        return 3 * s.feature_bits  # to compare, and to count in adders of two look-up tables
    if o["cost"] == "sad" and not s.recursive:
        return s.feature_bits * (1 if o.get("sign_memory", False) else 5 if o["cost_clocks"] < 3 else 2)
    return 2 * s.feature_bits


def _sums(shape: WindowShape) -> int:
    """Of a disparity."""
    s = shape
    if s.recursive:
        return s.pixels * (s.pixel_cost_bits + 3 * s.column_bits + 2 * s.window_bits)
    if s.window == 1:
        return 0
    pairs = (s.taps - 1) // 2 * (s.pixel_cost_bits + 1)
    return pairs + s.pixels * (s.window // 2 * s.column_bits + (s.window - 1) * s.window_bits)


def _winners(shape: WindowShape, cost_bits: int) -> int:
    s = shape
    chosen = 2 * cost_bits + s.disparity_bits
    beside = 4 * cost_bits * (s.subpixel + s.has_second)
    both = (s.lanes - 1) * (chosen + beside) + (s.lanes * chosen if s.left_right else 0)
    return s.pixels * both


def _beside(shape: WindowShape, cost_bits: int) -> int:
    s, bits = shape, 2 * shape.taps * shape.feature_bits
    if s.is_census:
        bits += 2 * s.pixels * s.feature_bits * s.pixel_bits
    elif s.has_transform:
        bits += 2 * s.pixels * _SOBEL * s.pixel_bits
    if s.texture:
        bits += s.taps * s.feature_bits + 4 * s.column_bits
    if s.subpixel:
        bits += s.pixels * _DIVISION * cost_bits
    if s.unique:
        bits += s.pixels * 4 * cost_bits
    if s.median:
        bits += s.pixels * _SORTED * 2 * (s.disparity_bits + 4 * s.subpixel)
    if s.is_folded:  # ten counters and addresses; the winner so far
        bits += 10 * bits_for(s.width - 1) + 2 * (2 * cost_bits + s.disparity_bits)
    return bits


def _paths(shape: PathShape) -> int:
    s = shape
    of_rows = s.rows_paths * 8 * s.row_path_bits  # neighbours, penalties, the fresh start
    above = 6 * s.above_bits if s.above else 0
    folded = 0
    if s.is_folded and s.largest_relief:  # K and A against the fresh start
        folded += s.rows_paths * 2 * s.row_path_bits
    if s.is_folded and s.full_width:  # the column that a lane leads to against both ends, for costs and for sums
        folded += 2 * 2 * bits_for(s.width)
    return s.lanes * (of_rows + above + 2 * s.forward_bits + 3 * s.cost_bits + folded)


def work_of(shape: WindowShape) -> Work:
    s = shape
    cost_bits = s.sum_bits if isinstance(s, PathShape) else s.window_bits
    return Work(
        costs=s.lanes * s.taps * _pixel_cost(s),
        sums=s.lanes * _sums(s),
        winners=_winners(s, cost_bits),
        paths=_paths(s) if isinstance(s, PathShape) else 0,
        beside=_beside(s, cost_bits),
    )
