# SPDX-License-Identifier: Apache-2.0
"""Sizes that follow from the options of block matching, as hls/block_matching/config.hpp derives them. The window costs
of semi-global matching have the same ones. test_plan.py compares what follows from them with every committed core."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

CENSUS = {
    "all": lambda dx, dy: True,
    "even_columns": lambda dx, dy: dx % 2 == 0,
    "checkerboard": lambda dx, dy: (dx + dy) % 2 == 0,
    "sparse": lambda dx, dy: dx % 2 == 0 and dy % 2 == 0,
}
MARGIN_BITS = 6  # hls/winner/winners.hpp
SUPPORT_ROWS = 2  # above and below, hls/postprocessing/limits.hpp


def bits_for(largest: int) -> int:
    """Bits that hold 0 ... largest."""
    return max(1, largest.bit_length())


@cache
def census_bits(width_px: int, height_px: int, pattern: str) -> int:
    has_bit = CENSUS[pattern]
    rows, columns = range(-(height_px // 2), height_px // 2 + 1), range(-(width_px // 2), width_px // 2 + 1)
    return sum((dx, dy) != (0, 0) and has_bit(dx, dy) for dy in rows for dx in columns)


class WindowShape:
    """`options`: as in the table of configurations; of what stands there nothing is read that follows from others."""

    def __init__(self, options: Mapping[str, Any]) -> None:
        o = options
        self.options = o
        self.width: int = o["width_px"]
        self.height: int = o["height_px"]
        self.disparities: int = o["disparities"]
        self.window: int = o["window_px"]
        self.pixels: int = o["pixels_per_clock"]
        self.passes: int = o.get("clocks_per_pixel", 1)
        self.is_folded = self.passes > 1
        self.lanes: int = self.disparities // self.passes
        self.recursive: bool = o["aggregation"] == "recursive"
        self.is_census: bool = o["cost"] == "census"
        self.full_width: bool = o.get("full_width", False)
        self.subpixel: bool = o.get("subpixel", False)
        self.median: bool = o.get("median", False)
        self.left_right: bool = o.get("left_right_threshold", -1) >= 0
        self.confidence: bool = o.get("confidence", False)
        self.unique: bool = o.get("uniqueness_percent", 0) > 0 or o.get("uniqueness_distance", 0) > 0
        self.texture: bool = o.get("texture_threshold", 0) > 0
        self.fills: bool = o.get("fill_holes", False)
        self.supports: bool = o.get("support_threshold", 0) > 0 or self.confidence
        self.has_transform: bool = self.is_census or o["prefilter"] != "none"

    # The window around a pixel, and the offset between the images.
    @property
    def rows_below(self) -> int:
        return (self.window - 1) // 2

    @property
    def rows_above(self) -> int:
        return self.window // 2

    @property
    def is_right(self) -> bool:
        return bool(self.options["reference"] == "right")

    @property
    def columns_after(self) -> int:
        return self.rows_below if self.is_right else self.rows_above

    @property
    def columns_before(self) -> int:
        return self.window - 1 - self.columns_after

    @property
    def offset(self) -> int:
        least: int = self.options["min_disparity"]
        return self.disparities - 1 + least if self.is_right else -least

    @property
    def delay(self) -> int:
        """Columns by which one of the images is held back."""
        return abs(self.offset)

    @property
    def first_cost_column(self) -> int:
        reference = max(0, self.offset)
        return reference if self.full_width else max(reference, self.disparities - 1 + max(0, -self.offset))

    @property
    def cost_columns(self) -> int:
        return self.width if self.full_width else self.width - self.first_cost_column

    @property
    def output_width(self) -> int:
        return self.cost_columns - (self.window - 1 if self.full_width else 1)

    # Rows travel in groups of as many pixels as come in a clock.
    @property
    def delay_groups(self) -> int:
        return -(-self.rows_below // self.pixels)

    @property
    def stored_rows(self) -> int:
        return self.delay_groups * self.pixels + self.rows_above + self.recursive

    @property
    def taps(self) -> int:
        return 2 * self.pixels if self.recursive else self.pixels + self.window - 1

    @property
    def transform_rows(self) -> int:
        rows: int = self.options["census_height_px"] // 2 if self.is_census else 1
        return rows

    @property
    def transform_groups(self) -> int:
        return -(-self.transform_rows // self.pixels)

    @property
    def gap_groups(self) -> int:
        """Between two frames."""
        gap = self.delay_groups * self.width if self.recursive else 0
        if gap and self.has_transform:
            gap = max(gap, self.transform_groups * self.width)
        if gap and self.supports:
            gap = max(gap, -(-SUPPORT_ROWS // self.pixels) * self.width)
        return gap

    # Bits of numbers.
    @property
    def census_bits(self) -> int:
        o = self.options
        return census_bits(o["census_width_px"], o["census_height_px"], o["census_pattern"])

    @property
    def pixel_bits(self) -> int:
        bits: int = self.options["pixel_bits"]
        return bits

    @property
    def feature_bits(self) -> int:
        """Of what is compared."""
        if self.is_census:
            return self.census_bits
        return self.pixel_bits - 1 if self.options["prefilter"] == "xsobel" else self.pixel_bits

    @property
    def largest_pixel_cost(self) -> int:
        if self.is_census:
            return self.census_bits
        x_sobel = self.options["prefilter"] == "xsobel"
        difference: int = 2 * self.options["prefilter_cap"] if x_sobel else (1 << self.pixel_bits) - 1
        return difference * difference if self.options["cost"] == "ssd" else difference

    @property
    def pixel_cost_bits(self) -> int:
        return bits_for(self.largest_pixel_cost)

    @property
    def largest_column_cost(self) -> int:
        return self.largest_pixel_cost * self.window

    @property
    def column_bits(self) -> int:
        return bits_for(self.largest_column_cost)

    @property
    def largest_window_cost(self) -> int:
        return self.largest_column_cost * self.window

    @property
    def window_bits(self) -> int:
        return bits_for(self.largest_window_cost)

    @property
    def disparity_bits(self) -> int:
        return bits_for(self.disparities - 1)

    @property
    def has_second(self) -> bool:
        """The runner-up's cost is looked for."""
        return self.unique or self.confidence

    @property
    def map_bits(self) -> int:
        """Of a disparity behind the checks: whole, or in sixteenths."""
        return 12 if self.subpixel else 8

    # Slices of disparities work one clock behind each other.
    @property
    def slices(self) -> list[int]:
        sizes, rest, most = [], self.lanes, self.options["slice_disparities"]
        while rest:
            size = rest if rest <= most + 1 else most
            sizes.append(size)
            rest -= size
        return sizes

    # Several clocks a pixel: a row is matched in as many passes.
    @property
    def pass_columns(self) -> int:
        return max(self.lanes - 1, self.columns_before) + self.cost_columns + self.columns_after

    @property
    def passes_columns(self) -> int:
        return self.passes * self.pass_columns + (self.lanes - 1 if self.left_right else 0)

    @property
    def passes_fit(self) -> bool:
        """Whether a row's passes end before the next row is there, and a pass finds what the one before it wrote."""
        lag = 0 if not self.left_right else (self.lanes if self.is_right else self.disparities) - 1
        before = max(self.lanes - 1, self.columns_before)
        waits = 40 + self.disparities // self.options["slice_disparities"]
        first = (self.passes - 1) * self.pass_columns + before + self.columns_after + lag + waits
        clocks = self.width * self.passes
        sooner = self.lanes if self.left_right and self.is_right else 0
        apart = self.pass_columns >= 5 and (not sooner or self.pass_columns - sooner >= 4)
        return self.passes_columns <= clocks - 2 and first <= clocks and apart
