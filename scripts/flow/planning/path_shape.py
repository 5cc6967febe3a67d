# SPDX-License-Identifier: Apache-2.0
"""Sizes that follow from the options of semi-global matching, as hls/semi_global/config.hpp derives them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .window_shape import WindowShape, bits_for


class PathShape(WindowShape):
    def __init__(self, options: Mapping[str, Any]) -> None:
        super().__init__(options)
        o = options
        self.left: bool = o["path_left"]
        self.right: bool = o["path_right"]
        self.above: bool = o["path_above"]
        self.rows_paths: int = self.left + self.right
        self.p1: int = o["p1"]
        self.p2: int = o["p2"]
        self.p2_above: int = self.p2 if o["above_p2"] < 0 else o["above_p2"]

    @property
    def output_width(self) -> int:
        return super().output_width if self.full_width else self.cost_columns

    @property
    def slices(self) -> list[int]:
        """Of the window costs, which are there for all disparities at once where they are not folded."""
        return [self.lanes] if self.is_folded else super().slices

    @property
    def levels(self) -> int:
        """Of the tree that finds the smallest cost of all that come at once."""
        return (self.lanes - 1).bit_length()

    @property
    def largest_relief(self) -> int:
        least: int = self.options["p2_least"]
        return 0 if least < 0 or least >= self.p2 or not self.rows_paths else self.p2 - least

    @property
    def adds_next_relief(self) -> bool:
        return self.largest_relief > 0 and not self.is_folded

    @property
    def relief_bits(self) -> int:
        return bits_for(self.largest_relief)

    @property
    def largest_cost(self) -> int:
        cap: int = self.options["cost_cap"]
        shift: int = self.options["cost_shift"]
        return min(self.largest_window_cost >> shift, cap)

    @property
    def cost_bits(self) -> int:
        return bits_for(self.largest_cost)

    @property
    def row_path_bits(self) -> int:
        highest = 2 * self.largest_cost + self.p1 + (self.largest_relief if self.adds_next_relief else 0)
        lowest = self.p2 + max(0, self.largest_cost - self.p1)
        bits = 2
        while 1 << (bits - 1) <= highest or 1 << (bits - 1) < lowest:
            bits += 1
        return bits

    @property
    def _row_path_sum(self) -> int:
        """The largest number that a path along a row adds to the sum, its bias with it."""
        relief = self.largest_relief if self.adds_next_relief and not self.left_right else 0
        return (1 << (self.row_path_bits - 1)) + self.largest_cost + relief

    @property
    def largest_path_above(self) -> int:
        return self.p2_above + self.largest_cost

    @property
    def above_bits(self) -> int:
        return bits_for(self.largest_path_above)

    @property
    def largest_forward_sum(self) -> int:
        return (self._row_path_sum if self.left else 0) + (self.largest_path_above if self.above else 0)

    @property
    def forward_bits(self) -> int:
        return bits_for(self.largest_forward_sum)

    @property
    def sum_bits(self) -> int:
        return bits_for(self.largest_forward_sum + (self._row_path_sum if self.right else 0))
