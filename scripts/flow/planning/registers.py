# SPDX-License-Identifier: Apache-2.0
"""How many bits of each kind of register a core has: what its flip-flops are for. Counted from the blocks in hls/, as
far as a register is there for each disparity, each tap or each word of a memory; the model has constants for those
that are there once. Bits that never change fall away in synthesis, and a RAM may take the register at its output."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

from .path_shape import PathShape
from .window_memories import Memory
from .window_shape import WindowShape, bits_for

_MOST_GATED = 8  # hls/block_matching/disparity_slice.hpp
_SOBEL = 18  # pixels around one, and sums of them
_SORTED = 32  # numbers of a median of 3x3, in all of its clocks
_DIVISION = 12  # clocks of the subpixel division, each with a divisor and a rest


class Registers(NamedTuple):
    costs: int  # shifted pixels, costs of pairs of pixels
    sums: int  # of columns and windows
    winners: int  # the trees that find the smallest cost, and what the checks keep beside
    paths: int
    words: int  # of memories, and what follows the pixels in front of the disparities


def _shift(shape: WindowShape) -> int:
    """Searched pixels of each disparity; of each slice the reference and the pixel that leaves."""
    return shape.taps * shape.feature_bits * (shape.lanes + 2 * len(shape.slices))


def _costs(shape: WindowShape) -> int:
    """Of a disparity: differences, and what stands before the column sum."""
    s, o = shape, shape.options
    pairs = (s.taps - 1) // 2
    alone = sum((p % 2 == 0) + ((p + s.window) % 2 == 0) for p in range(s.pixels))
    difference = 2 * -(-s.feature_bits // 3) if s.is_census else s.feature_bits + 1
    if s.recursive:
        return s.taps * (difference + s.pixel_cost_bits)
    if o["cost"] == "sad":
        deferred = (pairs + alone) * (s.pixel_cost_bits + 1) + pairs
        known = (s.taps - s.pixels) * 3 if o.get("sign_memory", False) else 0  # signs as they come, and as they go
        return (s.taps * difference if o["cost_clocks"] > 1 else 0) + (deferred if o["cost_clocks"] > 2 else 0) + known
    return s.taps * (difference + s.pixel_cost_bits) + pairs * (s.pixel_cost_bits + 1) + alone * s.pixel_cost_bits


def _sums(shape: WindowShape) -> int:
    """Of a disparity: the column, and the windows that it is part of."""
    s = shape
    if s.recursive:
        return s.pixels * (s.pixel_cost_bits + 3 * s.column_bits + 2 + s.window_bits)
    partial = sum(bits_for(s.largest_column_cost * columns) for columns in range(1, s.window))
    return s.pixels * (s.column_bits + partial + s.window_bits)


def _tree(candidates: int, group: int, cost_bits: int) -> int:
    """Costs and places of the winners of each level."""
    bits, span = 0, 1
    while candidates > 1:
        candidates, span = -(-candidates // group), span * group
        bits += candidates * (cost_bits + bits_for(span - 1))
    return bits


def _is_gated(shape: WindowShape) -> bool:
    """Losers are cleared, in three registers for each four candidates instead of two (hls/winner/gated_tree.hpp)."""
    s = shape
    if s.options["winner_group"] != 2 or s.subpixel or s.has_second:
        return False
    if isinstance(s, PathShape):
        return not s.is_folded
    return max(s.slices) * s.pixels <= _MOST_GATED


def _winners(shape: WindowShape, cost_bits: int) -> int:
    s = shape
    slices = [s.lanes] if isinstance(s, PathShape) else s.slices
    trees = sum(_tree(lanes, s.options["winner_group"], cost_bits) for lanes in slices)
    best = len(slices) * (cost_bits + s.disparity_bits)
    beside = (4 * s.subpixel + 3 * s.has_second) * (s.lanes + len(slices)) * cost_bits  # neighbours, runners-up
    cleared = 2 * s.lanes * cost_bits if _is_gated(s) else 0
    other = s.lanes * (cost_bits + s.disparity_bits) if s.left_right else 0
    return s.pixels * (trees + best + beside + cleared + other)


def _paths(shape: PathShape) -> int:
    s = shape
    of_rows = s.rows_paths * (7 if s.is_folded else 5) * s.row_path_bits  # K, A, what they become, a tree
    above = 7 * s.above_bits if s.above else 0  # total, K, what the row below gets, a tree
    return s.lanes * (of_rows + above + s.forward_bits + s.sum_bits + 3 * s.cost_bits)


def _words(shape: WindowShape, memories: Sequence[Memory], cost_bits: int) -> int:
    s = shape
    found = 2 * sum(memory.width for memory in memories)  # one that was read, one to be written
    # Two addresses of each bank: memories of one depth behind each other.
    found += 2 * sum(bits_for(depth - 1) for depth, _ in groupby(memory.depth for memory in memories))
    if s.is_census:
        o = s.options
        found += 2 * o["census_width_px"] * o["census_height_px"] * s.pixels * s.pixel_bits + 2 * s.feature_bits
    elif s.has_transform:
        found += 2 * _SOBEL * s.pixels * s.pixel_bits
    if s.median:
        found += _SORTED * s.pixels * (s.disparity_bits + 4 * s.subpixel + 1)
    if s.subpixel:
        found += s.pixels * 2 * _DIVISION * cost_bits
    return found


def registers_of(shape: WindowShape, memories: Sequence[Memory]) -> Registers:
    s = shape
    cost_bits = s.sum_bits if isinstance(s, PathShape) else s.window_bits
    return Registers(
        costs=_shift(s) + s.lanes * _costs(s),
        sums=s.lanes * _sums(s),
        winners=_winners(s, cost_bits),
        paths=_paths(s) if isinstance(s, PathShape) else 0,
        words=_words(s, memories, cost_bits),
    )
