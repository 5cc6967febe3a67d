# SPDX-License-Identifier: Apache-2.0
"""The memories of a semi-global core, as the blocks in hls/semi_global have them."""

from __future__ import annotations

from .path_shape import PathShape
from .window_memories import (
    DISPARITY_BITS,
    Memory,
    bank,
    front_end,
    left_right_check,
    packed,
    post_processing,
    slices,
    word_bits_of,
)
from .window_shape import MARGIN_BITS, bits_for

_BANK_WORDS = 4096  # hls/semi_global/phase_memory.hpp
_LOW_PLACES = 16  # hls/semi_global/phase_row_path.hpp


def _dense(lane_bits: int, lanes: int, word_bits: int) -> list[int]:
    """Widths of the words that hold so many numbers without a gap (hls/support/dense_packed.hpp)."""
    whole, rest = divmod(lane_bits * lanes, word_bits)
    return [word_bits] * whole + ([rest] if rest else [])


def _deep(words: int, lane_bits: int, lanes: int, bank_words: int = _BANK_WORDS) -> list[Memory]:
    """A row of the map with several words a column (phases.hpp, phase_memory.hpp)."""
    word_bits = word_bits_of(words, 16)
    widths = (_dense if lane_bits <= word_bits else packed)(lane_bits, lanes, word_bits=word_bits)
    found, left = [], words
    while left > bank_words:
        found += bank(bank_words, widths)
        left -= bank_words
    return found + bank(1 << bits_for(left - 1) if found else left, widths)


def _at_once(shape: PathShape) -> list[Memory]:
    """Paths of all disparities in a clock."""
    s, found = shape, []
    moves = s.levels + 1
    if s.rows_paths:
        found += bank(moves, packed(s.cost_bits, s.lanes))
    if s.above:
        found += bank(s.output_width, packed(bits_for(s.p2_above), s.lanes))
        found += bank(moves, packed(s.above_bits, s.lanes))
    if s.right:
        if s.left or s.above:
            found += bank(s.output_width, packed(s.forward_bits, s.lanes))
            found += bank(4, packed(s.forward_bits, s.lanes))
        found += bank(s.output_width, packed(s.cost_bits, s.lanes))
        found.append(Memory(s.output_width, s.cost_bits + (s.relief_bits if s.largest_relief else 0)))
    return found


def _relief(shape: PathShape) -> list[Memory]:
    s, found = shape, []
    if not s.largest_relief:
        return []
    if s.offset > 0:
        found.append(Memory(s.offset + 1, s.relief_bits))
    if s.delay_groups:
        found += bank(s.width, packed(s.relief_bits, s.delay_groups))
    if s.is_folded and s.right:
        found.append(Memory(s.output_width + 1, s.relief_bits))
    return found


def _in_phases(shape: PathShape) -> list[Memory]:
    """Paths of some disparities in a clock, all of them one phase behind the other."""
    s = shape
    phases, words, waits = s.passes, s.output_width * s.passes, s.passes + s.levels + 1
    found = bank(phases, packed(s.feature_bits, s.taps * s.lanes))
    if s.window > 1:
        partial = bits_for(s.largest_column_cost * (s.window - 1))
        found += bank(phases, packed(partial, (s.window - 1) * s.lanes))
    if s.rows_paths:
        found += bank(waits, packed(s.cost_bits, s.lanes))
    for _ in range(s.rows_paths):
        found += bank(phases, packed(s.row_path_bits, 2 * s.lanes))
        found += [Memory(phases, s.row_path_bits), Memory(_LOW_PLACES, s.row_path_bits)]
    if s.above:
        found += _deep(words, bits_for(s.p2_above), s.lanes) + bank(waits, packed(s.above_bits, s.lanes))
    if s.right:
        bank_words = 1 << 16 if phases == 4 else _BANK_WORDS
        if s.left or s.above:
            found += _deep(words, s.forward_bits, s.lanes, bank_words)
        found += _deep(words, s.cost_bits, s.lanes, bank_words) + [Memory(s.output_width + 1, s.cost_bits)]
    if s.left_right:
        lane = max(s.sum_bits, s.disparity_bits)
        found += bank(phases, packed(lane, 2 * s.lanes))
    return found


def semi_global(shape: PathShape) -> list[Memory]:
    s = shape
    found = front_end(s)
    found += _in_phases(s) if s.is_folded else slices(s) + _at_once(s)
    found += _relief(s)
    if s.left_right:
        found += left_right_check(s)
    if s.right:
        fraction, margin = (5 if s.subpixel else 0), (MARGIN_BITS if s.confidence else 0)
        found.append(Memory(s.output_width + s.is_folded, 9 + fraction + margin))
    return found + post_processing(s, DISPARITY_BITS if s.is_folded else s.disparity_bits)
