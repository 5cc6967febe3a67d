# SPDX-License-Identifier: Apache-2.0
"""A failed co-simulation to look at: the expected and the actual map, the first pixel that differs, and the signals
around it.

Everything is read from the folder that scripts/cosim.py writes: report.json, expected.txt, observed.txt, and
failure.vcd where a waveform could be made."""

from __future__ import annotations

import json
import shlex
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ..base import files, rtl
from ..base.configurations import Parameters
from ..base.errors import FlowError
from ..rendering import page, pictures
from ..synthesis.lowering.naming import Trace
from . import checker, registers, vcd, vectors, waveform
from .frame_maps import Around, FrameMaps
from .report import Report
from .simulators import IN_GHDL, Clocks
from .vcd import Values

PAGE, DUMP, SAVE = "failure.html", "failure.vcd", "failure.gtkw"
FILES = (PAGE, DUMP, SAVE)
CLOCKS_BEFORE, CLOCKS_AFTER = 64, 16  # in a waveform
CLOCKS_BACK = 1024  # some rows: to the first register that differs, where that is earlier
MOST_VALUES = 5_000_000  # registers times clocks that are compared: some seconds
MOST_DIFFER = 8  # registers that the page shows


class CppTrace(Protocol):
    """Of the C++ core on the stimulus that was simulated."""

    def of(self, clocks: Clocks) -> Trace:
        """Its registers in these clocks, the last one included."""

    def sure_names(self) -> set[str]:
        """The registers whose names in the VHDL are no guess."""

    def reset_names(self) -> set[str]:
        """Those that the VHDL resets."""


@dataclass(frozen=True)
class Failure:
    report: Report
    sentence: str
    notes: list[str]
    pictures: list[pictures.Picture]
    around: Around | None  # None: a surplus output has no place
    wave: waveform.Table | None

    @property
    def simulator(self) -> str:
        return self.report["simulator"]


def read(folder: Path, parameters: Parameters) -> Failure | None:
    """The Failure of a folder, or None when the folder has no outputs to compare or they all agree."""
    if not all((folder / name).is_file() for name in ("expected.txt", "observed.txt")):
        return None
    report: Report = json.loads((folder / "report.json").read_text())
    expected, _ = vectors.read_expected(folder / "expected.txt")
    observed, _ = vectors.read_observed(folder / "observed.txt")
    first = checker.compare(expected, observed, parameters["disparity_bits"]).first_mismatch
    if first is None:
        return None
    pixel = (first.expected.x, first.expected.y + first.wrong_row()) if first.expected else None
    maps = FrameMaps(expected, observed, (first.expected or expected[-1]).frame, parameters)
    wave, notes = None, [] if maps.all_valid else ["In brackets: pixel_valid is 0."]
    if (folder / DUMP).is_file():
        wave = _wave(folder, report, first)
        notes += _notes(folder, report, first)
    around = maps.around(*pixel) if pixel else None
    return Failure(report, str(first), notes, maps.pictures(report["simulator"], pixel), around, wave)


def _gtkwave(folder: Path) -> str:
    """The command that shows the waveform."""
    return shlex.join(["gtkwave", str(folder / DUMP), str(folder / SAVE)])


def _wave(folder: Path, report: Report, first: checker.Mismatch) -> waveform.Table:
    begin, end = report["wave_clocks"]
    simulator = "original" if report["simulator"] == "original" else "ghdl"
    return waveform.table(folder / DUMP, first.clock, simulator, _gtkwave(folder), begin, end, _differ(report))


def _differ(report: Report) -> list[str]:
    return report.get("first_registers", [])[:MOST_DIFFER]


def _notes(folder: Path, report: Report, first: checker.Mismatch) -> list[str]:
    """About what differs first, and about a waveform of another simulator."""
    notes = [f"{report['first_register'].capitalize()}."] if "first_register" in report else []
    if report["simulator"] in IN_GHDL:
        return notes
    notes += ["The waveform is GHDL's, of the same VHDL and stimulus."]
    if first.expected and waveform.output(folder / DUMP, first.expected.clock) == (1, first.expected.disparity):
        notes.append("In GHDL the disparity in that clock is as expected: the two simulators differ.")
    return notes


def window(clock: int, clocks: int) -> Clocks:
    """What to dump around one of `clocks` clocks."""
    return max(clock - CLOCKS_BEFORE, 0), min(clock + CLOCKS_AFTER, clocks)


def write_page(folder: Path, parameters: Parameters) -> Path | None:
    """failure.html and failure.gtkw of a folder; the page's path, or None when there is nothing to show."""
    failure = read(folder, parameters)
    if failure is None:
        return None
    if failure.wave:
        files.write(folder / SAVE, waveform.save_file(folder / DUMP, failure.wave.clock, _differ(failure.report)))
    text = page.render("failure.html.j2", failure=failure, report=failure.report, scale=pictures.scale_png())
    files.write(folder / PAGE, text)
    return folder / PAGE


def explain(
    folder: Path,
    parameters: Parameters,
    first: checker.Mismatch,
    clocks: int,
    dump: Callable[[Path, Clocks], None],
    trace: CppTrace | None,
) -> list[str]:
    """Makes waveform and page of a failed co-simulation as far as possible; returns the lines to print about them.
    `dump(path, window)` simulates again and writes the waveform."""
    lines, report_path = [], folder / "report.json"
    try:
        clocks_shown = window(first.clock, clocks)
        dump(folder / DUMP, clocks_shown)
        report = json.loads(report_path.read_text()) | {"wave_clocks": clocks_shown}
        if trace and (found := _first_difference(folder, parameters, first.clock, clocks_shown, dump, trace)):
            names = [name for name, _, _ in found.registers]
            report |= {"first_register": str(found), "first_registers": names}
            lines.append(f"  {found}")
        files.write(report_path, json.dumps(report, indent=2) + "\n")
    except FlowError as error:
        if not (folder / DUMP).is_file() or "wave_clocks" not in json.loads(report_path.read_text()):
            (folder / DUMP).unlink(missing_ok=True)
        lines.append(f"  no waveform of the mismatch: {error}")
    if rtl.is_stage(parameters):  # a page shows maps
        if (folder / DUMP).is_file():
            names = _differ(json.loads(report_path.read_text()))
            files.write(folder / SAVE, waveform.save_file(folder / DUMP, first.clock, names))
            lines.append(f"  waveform around the mismatch: {_gtkwave(folder)}")
        return lines
    try:
        write_page(folder, parameters)
    except FlowError as error:
        return [*lines, f"  no page of the mismatch: {error}"]
    if (folder / SAVE).is_file():
        lines.append(f"  waveform around the mismatch: {_gtkwave(folder)}")
    return [*lines, f"  both maps, the first pixel that differs and its signals: {folder / PAGE}"]


def _first_difference(
    folder: Path,
    parameters: Parameters,
    clock: int,
    shown: Clocks,
    dump: Callable[[Path, Clocks], None],
    trace: CppTrace,
) -> registers.Divergence | None:
    """Adds the C++ core's registers to the waveform, and says which one of the VHDL differs first; where that is before
    the waveform, in a longer one."""
    sure, reset, settled = trace.sure_names(), trace.reset_names(), parameters["latency_clocks"]
    here = registers.Registers(Values(folder / DUMP), trace.of(shown), shown[0], sure, reset)
    vcd.add(folder / DUMP, waveform.CPP, here.cpp_signals())
    found = here.divergence(settled)
    for back in (CLOCKS_BACK, clock):  # the whole run for what is reset: else its state could be wrong for long
        if found is None or found.is_first or back * len(here.names) > MOST_VALUES:
            break
        earlier = (max(clock - back, 0), clock)
        with tempfile.TemporaryDirectory() as temporary:
            dump(Path(temporary) / DUMP, earlier)
            values = Values(Path(temporary) / DUMP)
        seen = registers.Registers(values, trace.of(earlier), earlier[0], sure, reset)
        found = seen.divergence(settled, only_reset=back > CLOCKS_BACK) or found
    return found
