# SPDX-License-Identifier: Apache-2.0
"""A failed co-simulation to look at: the expected and the actual map, the first pixel that differs, and the signals around it.

Everything is read from the folder that scripts/cosim.py writes: report.json, expected.txt, observed.txt, and failure.vcd where
a waveform could be made."""

import json
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from ..base import files
from ..base.errors import FlowError
from ..rendering import page, pictures
from . import checker, vectors, waveform

PAGE, DUMP, SAVE = "failure.html", "failure.vcd", "failure.gtkw"
FILES = (PAGE, DUMP, SAVE)
COLUMNS_AROUND, ROWS_AROUND = 4, 2
SAME, DIFFERS = "#e6f0f7", "#c2182b"


@dataclass(frozen=True)
class Failure:
    report: dict
    sentence: str
    notes: list
    pictures: list
    around: Optional[dict]
    wave: Optional[waveform.Table]

    @property
    def simulator(self):
        return self.report["simulator"]


class Frame:
    """The expected and the actual map of one frame. Values are disparities as they come, -1 where nothing or no number came."""

    def __init__(self, expected, observed, frame, lanes, bits):
        numpy, _ = pictures.libraries()
        members = [(e, observed[i] if i < len(observed) else None) for i, e in enumerate(expected) if e.frame == frame]
        self.frame, self.lanes, self.bits = frame, lanes, bits
        shape = max(e.y for e, _ in members) + lanes, max(e.x for e, _ in members) + 1
        self.expected, self.got = numpy.full(shape, -1), numpy.full(shape, -1)
        self.expected_valid, self.got_valid = numpy.ones(shape, bool), numpy.ones(shape, bool)
        self.wrong = numpy.zeros(shape, bool)
        self.clocks = {}  # (x, y) of outputs that came in another clock
        for e, o in members:
            for lane in range(lanes):
                self._place(e, o, lane)

    def _place(self, e, o, lane):
        at = e.y + lane, e.x
        self.expected[at], self.expected_valid[at] = self._value(e.disparity, lane), e.flags >> (2 + lane) & 1
        if o is None or o.disparity == "X":
            self.wrong[at] = True
            return
        self.got[at], self.got_valid[at] = self._value(o.disparity, lane), o.flags >> (2 + lane) & 1
        if o.clock != e.clock:
            self.clocks[e.x, e.y + lane] = o.clock
        group_differs = o.clock != e.clock or (o.flags ^ e.flags) & 3
        self.wrong[at] = (
            group_differs or self.got[at] != self.expected[at] or self.got_valid[at] != self.expected_valid[at]
        )

    def _value(self, word, lane):
        return word >> (self.bits * lane) & ((1 << self.bits) - 1)

    def text(self, x, y, got):
        value, valid = (
            (self.got[y, x], self.got_valid[y, x]) if got else (self.expected[y, x], self.expected_valid[y, x])
        )
        if value < 0:
            return "nothing"
        number = f"{value / 16:g}" if self.bits == 16 else str(value)
        late = f" in clock {self.clocks[x, y]}" if got and (x, y) in self.clocks else ""
        return (number if valid else f"({number})") + late

    def around(self, x, y):
        """The table around a pixel: expected values, and got ones where they differ."""
        height, width = self.wrong.shape
        columns = range(max(x - COLUMNS_AROUND, 0), min(x + COLUMNS_AROUND + 1, width))
        rows = range(max(y - ROWS_AROUND, 0), min(y + ROWS_AROUND + 1, height))
        return {
            "columns": columns,
            "rows": [
                {
                    "y": row,
                    "cells": [
                        {
                            "expected": self.text(column, row, False),
                            "got": self.text(column, row, True),
                            "wrong": bool(self.wrong[row, column]),
                            "first": (column, row) == (x, y),
                        }
                        for column in columns
                    ],
                }
                for row in rows
            ],
        }


def _pictures(frame, parameters, simulator, mark):
    numpy, _ = pictures.libraries()
    height, width = frame.wrong.shape
    steps, low = (16 if frame.bits == 16 else 1), parameters["min_disparity"]
    high = low + parameters["disparities"] - 1

    def picture(title, values, valid, caption):
        colors = pictures.disparity_colors(low + values / steps, low, high)
        colors[~valid] = pictures.rgb(pictures.REJECTED)
        colors = numpy.where((values < 0)[..., None], pictures.blank(width, height), colors)
        legend = [(pictures.REJECTED, "pixel_valid is 0", None)] if not valid.all() else []
        legend += [(pictures.NO_RANGE[1], "nothing, or no number", None)] if (values < 0).any() else []
        return pictures.Picture(
            title,
            pictures.png(colors.astype(numpy.uint8)),
            caption,
            width,
            height,
            pictures.scale_labels(low, high),
            tuple(legend),
            mark,
        )

    difference = numpy.where(frame.wrong[..., None], pictures.rgb(DIFFERS), pictures.rgb(SAME)).astype(numpy.uint8)
    share = page.percent(int(frame.wrong.sum()), frame.wrong.size)
    legend = (
        (DIFFERS, f"differs, {int(frame.wrong.sum()):,} of {frame.wrong.size:,} pixels", share),
        (SAME, "the same", 100 - share),
    )
    return [
        picture("Expected", frame.expected, frame.expected_valid, f"The C++ core, frame {frame.frame}."),
        picture("Got", frame.got, frame.got_valid, f"The VHDL in {simulator}."),
        pictures.Picture(
            "Difference", pictures.png(difference), "Disparity, flags or clock.", width, height, (), legend, mark
        ),
    ]


def _place(first):
    """(x, y) of the first mismatch, or None for a surplus output."""
    return (first.expected.x, first.expected.y + first.wrong_row()) if first.expected else None


def read(folder, parameters):
    """The Failure of a folder, or None when the folder has no outputs to compare or they all agree."""
    folder = Path(folder)
    if not all((folder / name).is_file() for name in ("expected.txt", "observed.txt")):
        return None
    report = json.loads((folder / "report.json").read_text())
    expected, _ = vectors.read_expected(folder / "expected.txt")
    observed, clocks = vectors.read_observed(folder / "observed.txt")
    bits = parameters["disparity_bits"]
    first = checker.compare(expected, observed, bits).first_mismatch
    if first is None:
        return None
    place = _place(first)
    frame = Frame(
        expected,
        observed,
        first.expected.frame if first.expected else expected[-1].frame,
        parameters["pixels_per_clock"],
        bits,
    )
    mark = None
    if place:
        mark = 100 * (place[0] + 0.5) / frame.wrong.shape[1], 100 * (place[1] + 0.5) / frame.wrong.shape[0]
    wave, notes = (
        None,
        ["In brackets: pixel_valid is 0."] if not (frame.expected_valid.all() and frame.got_valid.all()) else [],
    )
    if (folder / DUMP).is_file():
        wave, note = _wave(folder, report, first)
        notes += note
    return Failure(
        report,
        str(first),
        notes,
        _pictures(frame, parameters, report["simulator"], mark),
        frame.around(*place) if place else None,
        wave,
    )


def window(clock, clocks, before, after):
    """First and last clock to dump around one of `clocks` clocks."""
    return max(clock - before, 0), min(clock + after, clocks)


def _wave(folder, report, first):
    """(table of the dump, notes)"""
    begin, end = report["wave_clocks"]
    command = shlex.join(["gtkwave", str(folder / DUMP), str(folder / SAVE)])
    simulator = "original" if report["simulator"] == "original" else "ghdl"
    notes = []
    if report["simulator"] == "verilator":
        notes.append("The waveform is GHDL's, of the same VHDL and stimulus.")
        if first.expected and waveform.output(folder / DUMP, first.clock) == (1, first.expected.disparity):
            notes.append("In GHDL the disparity in that clock is as expected: the two simulators differ.")
    return waveform.table(folder / DUMP, first.clock, simulator, command, begin, end), notes


def write_page(folder, parameters):
    """failure.html and failure.gtkw of a folder; the page's path, or None when there is nothing to show."""
    folder = Path(folder)
    failure = read(folder, parameters)
    if failure is None:
        return None
    if failure.wave:
        files.write(folder / SAVE, waveform.save_file(folder / DUMP, failure.wave.clock))
    files.write(
        folder / PAGE,
        page.render("failure.html.j2", failure=failure, report=failure.report, scale=pictures.scale_png()),
    )
    return folder / PAGE


def explain(folder, parameters, first, clocks, dump, before, after):
    """Makes waveform and page of a failed co-simulation as far as possible; returns the lines to print about them.
    `dump(path, window)` simulates again and writes the waveform."""
    lines, report_path = [], folder / "report.json"
    try:
        clocks_shown = window(first.clock, clocks, before, after)
        dump(folder / DUMP, clocks_shown)
        report = json.loads(report_path.read_text()) | {"wave_clocks": clocks_shown}
        report_path.write_text(json.dumps(report, indent=2) + "\n")
    except FlowError as error:
        (folder / DUMP).unlink(missing_ok=True)
        lines.append(f"  no waveform of the mismatch: {error}")
    try:
        write_page(folder, parameters)
    except FlowError as error:
        return [*lines, f"  no page of the mismatch: {error}"]
    if (folder / SAVE).is_file():
        lines.append(
            f"  waveform around the mismatch: {shlex.join(['gtkwave', str(folder / DUMP), str(folder / SAVE)])}"
        )
    return [*lines, f"  both maps, the first pixel that differs and its signals: {folder / PAGE}"]
