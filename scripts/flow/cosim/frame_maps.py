# SPDX-License-Identifier: Apache-2.0
"""The expected and the actual map of one frame, as numbers, as a table around a pixel and as pictures."""

from __future__ import annotations

from typing import TypedDict

from ..base.configurations import Parameters, option
from ..rendering import page, pictures
from ..rendering.pictures import Array, LegendEntry, Picture
from .vectors import Expected, Observed

COLUMNS_AROUND, ROWS_AROUND = 4, 2
SAME, DIFFERS = "#e6f0f7", "#c2182b"


class Cell(TypedDict):
    expected: str
    got: str
    wrong: bool
    first: bool  # the pixel that the table stands around


class Row(TypedDict):
    y: int
    cells: list[Cell]


class Around(TypedDict):
    columns: range
    rows: list[Row]


class FrameMaps:
    """Values are disparities as they come, -1 where nothing or no number came."""

    def __init__(self, expected: list[Expected], observed: list[Observed], frame: int, parameters: Parameters) -> None:
        numpy, _ = pictures.libraries()
        members = [(e, observed[i] if i < len(observed) else None) for i, e in enumerate(expected) if e.frame == frame]
        self.frame, self.parameters = frame, parameters
        self.lanes, self.bits = parameters["pixels_per_clock"], parameters["disparity_bits"]
        # Of a lane, what stands above the disparity is compared, and not shown.
        confidence, filled = option(parameters, "confidence"), option(parameters, "fill_holes")
        self.shown_bits = self.bits - (8 if confidence else 0) - (1 if filled else 0)
        whole = not option(parameters, "subpixel") and (confidence or filled or self.bits == 8)
        self.steps = 1 if whole else 16
        shape = max(e.y for e, _ in members) + self.lanes, max(e.x for e, _ in members) + 1
        self.height, self.width = shape
        self.expected: Array = numpy.full(shape, -1)
        self.got: Array = numpy.full(shape, -1)
        self.expected_valid: Array = numpy.ones(shape, bool)
        self.got_valid: Array = numpy.ones(shape, bool)
        self.wrong: Array = numpy.zeros(shape, bool)
        self.clocks: dict[tuple[int, int], int] = {}  # by (x, y), of outputs that came in another clock
        for e, o in members:
            for lane in range(self.lanes):
                self._place(e, o, lane)

    def _place(self, e: Expected, o: Observed | None, lane: int) -> None:
        at = e.y + lane, e.x
        self.expected[at], self.expected_valid[at] = self._value(e.disparity, lane), e.flags >> (2 + lane) & 1
        if o is None or not isinstance(o.disparity, int) or not isinstance(o.flags, int):
            self.wrong[at] = True
            return
        self.got[at], self.got_valid[at] = self._value(o.disparity, lane), o.flags >> (2 + lane) & 1
        if o.clock != e.clock:
            self.clocks[e.x, e.y + lane] = o.clock
        group_differs = o.clock != e.clock or (o.flags ^ e.flags) & 3
        lane_differs = self._lane(o.disparity, lane) != self._lane(e.disparity, lane)
        self.wrong[at] = group_differs or lane_differs or self.got_valid[at] != self.expected_valid[at]

    def _lane(self, word: int, lane: int) -> int:
        return word >> (self.bits * lane) & ((1 << self.bits) - 1)

    def _value(self, word: int, lane: int) -> int:
        return self._lane(word, lane) & ((1 << self.shown_bits) - 1)

    @property
    def all_valid(self) -> bool:
        return bool(self.expected_valid.all() and self.got_valid.all())

    def _text(self, value: int, valid: bool) -> str:
        if value < 0:
            return "nothing"
        number = f"{value / self.steps:g}"
        return number if valid else f"({number})"

    def _cell(self, x: int, y: int, first: bool) -> Cell:
        late = f" in clock {self.clocks[x, y]}" if (x, y) in self.clocks else ""
        return {
            "expected": self._text(self.expected[y, x], self.expected_valid[y, x]),
            "got": self._text(self.got[y, x], self.got_valid[y, x]) + late,
            "wrong": bool(self.wrong[y, x]),
            "first": first,
        }

    def around(self, x: int, y: int) -> Around:
        """The table around a pixel: expected values, and got ones where they differ."""
        columns = range(max(x - COLUMNS_AROUND, 0), min(x + COLUMNS_AROUND + 1, self.width))
        rows = range(max(y - ROWS_AROUND, 0), min(y + ROWS_AROUND + 1, self.height))
        return {
            "columns": columns,
            "rows": [
                {"y": row, "cells": [self._cell(column, row, (column, row) == (x, y)) for column in columns]}
                for row in rows
            ],
        }

    def pictures(self, simulator: str, pixel: tuple[int, int] | None) -> list[Picture]:
        """Expected, got, and where they differ, with a mark around a pixel."""
        mark = None
        if pixel:
            mark = 100 * (pixel[0] + 0.5) / self.width, 100 * (pixel[1] + 0.5) / self.height
        core = f"The C++ core, frame {self.frame}."
        return [
            self._map_picture("Expected", self.expected, self.expected_valid, core, mark),
            self._map_picture("Got", self.got, self.got_valid, f"The VHDL in {simulator}.", mark),
            self._difference_picture(mark),
        ]

    def _map_picture(
        self, title: str, values: Array, valid: Array, caption: str, mark: tuple[float, float] | None
    ) -> Picture:
        numpy, _ = pictures.libraries()
        steps, low = self.steps, option(self.parameters, "min_disparity") or 0
        high = low + self.parameters["disparities"] - 1
        colors = pictures.disparity_colors(low + values / steps, low, high)
        colors[~valid] = pictures.rgb(pictures.REJECTED)
        colors = numpy.where((values < 0)[..., None], pictures.blank(self.width, self.height), colors)
        legend: list[LegendEntry] = []
        if not valid.all():
            legend.append((pictures.REJECTED, "pixel_valid is 0", None))
        if (values < 0).any():
            legend.append((pictures.NO_RANGE[1], "nothing, or no number", None))
        png, scale = pictures.png(colors.astype(numpy.uint8)), pictures.scale_labels(low, high)
        return Picture(title, png, caption, self.width, self.height, scale, tuple(legend), mark)

    def _difference_picture(self, mark: tuple[float, float] | None) -> Picture:
        numpy, _ = pictures.libraries()
        colors = numpy.where(self.wrong[..., None], pictures.rgb(DIFFERS), pictures.rgb(SAME)).astype(numpy.uint8)
        wrong, pixels = int(self.wrong.sum()), self.wrong.size
        share = page.percent(wrong, pixels)
        legend = ((DIFFERS, f"differs, {wrong:,} of {pixels:,} pixels", share), (SAME, "the same", 100 - share))
        caption, size = "Disparity, flags or clock.", (self.width, self.height)
        return Picture("Difference", pictures.png(colors), caption, *size, (), legend, mark)
