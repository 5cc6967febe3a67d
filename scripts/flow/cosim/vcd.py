# SPDX-License-Identifier: Apache-2.0
"""Value change dumps: cut a stretch out of GHDL's while it writes it, and read the values of a short one.

GHDL always dumps from the start of a simulation and in femtoseconds. What `cut` writes begins at the first time that
was asked for, with the value of every signal, and counts in nanoseconds."""

from __future__ import annotations

import bisect
import re
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from ..base import files
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from .vectors import Seen

FEMTOSECONDS = 1_000_000  # in a nanosecond


def cut(lines: Iterator[str], write: Callable[[str], object], first_ns: int, last_ns: int) -> None:
    """Copies the dump of `lines` from `first_ns` to `last_ns`. Reads all lines, so that their writer never waits."""
    values: dict[str, str] = {}
    now, begun = 0, False
    _copy_header(lines, write)
    for line in lines:
        kind = line[0]
        if kind == "#":
            now = int(line[1:]) // FEMTOSECONDS
            if not begun and now >= first_ns:
                begun = True
                write(f"#{first_ns}\n$dumpvars\n{''.join(values.values())}$end\n")
            if begun and first_ns < now <= last_ns:
                write(f"#{now}\n")
        elif kind != "$":
            if now < first_ns or not begun:
                values[line[1:] if kind not in "bBrR" else line.rpartition(" ")[2]] = line
            elif now <= last_ns:
                write(line)


def _copy_header(lines: Iterator[str], write: Callable[[str], object]) -> None:
    """Up to the end of the definitions, without the empty scopes of packages."""
    pending = ""
    for line in lines:
        if line.startswith("$scope"):
            write(pending)
            pending = line
        elif line.startswith("$upscope") and pending:
            pending = ""
        elif line.startswith("$timescale"):
            write("$timescale\n  1 ns\n")
            next(lines)
        else:
            write(pending + _viewable(line))
            pending = ""
        if line.startswith("$enddefinitions"):
            return


def _viewable(line: str) -> str:
    """GTKWave finds an integer by the name in a save file only as a vector with a range, a vector of one bit only
    without."""
    line = re.sub(r"^\$var integer 32 (\S+) (\w+) ", r"$var reg 32 \1 \2[31:0] ", line)
    return re.sub(r"^(\$var reg 1 \S+ \w+)\[\d+:\d+\]", r"\1", line)


def add(path: Path, scope: str, signals: Mapping[str, tuple[int, Mapping[int, int]]]) -> None:
    """Adds a scope of signals to a short dump: {name: (bits, {ns: value})}. Where the dump has no such time, a value is
    left out."""
    names = {name: f"{scope}{number}" for number, name in enumerate(signals)}  # short ones, of this file
    definitions = [f"$scope module {scope} $end"]
    changes: dict[int, list[str]] = {}
    for name, (bits, values) in signals.items():
        ending = f"[{bits - 1}:0]" if bits > 1 else ""
        definitions.append(f"$var reg {bits} {names[name]} {name}{ending} $end")
        for time, value in values.items():
            changes.setdefault(time, []).append(f"b{value % (1 << bits):b} {names[name]}")
    definitions.append("$upscope $end")
    lines: list[str] = []
    for line in path.read_text(encoding="ascii").splitlines():
        lines += [*definitions, line] if line.startswith("$enddefinitions") else [line]
        if line.startswith("#"):
            lines += changes.pop(int(line[1:]), [])
    files.write(path, "\n".join(lines) + "\n")


class Values:
    """What a short dump says: `names` of all signals, and the value of one at a time."""

    def __init__(self, path: Path) -> None:
        self.names: dict[str, tuple[str, str, int]] = {}  # (key in the dump, name with its range, bits)
        self._times: dict[str, list[int]] = {}  # by key
        self._values: dict[str, list[str]] = {}
        try:
            lines = path.read_text(encoding="ascii").splitlines()
        except (OSError, UnicodeDecodeError) as error:
            raise FlowError(
                f"{path}: {getattr(error, 'strerror', None) or 'not a value change dump'}", EXIT_TOOL_FAILED
            ) from None
        body = self._read_names(lines)
        now = 0
        for line in lines[body:]:
            if line.startswith("#"):
                now = int(line[1:])
            elif line and line[0] in "bB":
                value, key = line[1:].split()
                self._add(key, now, value)
            elif line and line[0] != "$":
                self._add(line[1:], now, line[0])

    def _read_names(self, lines: list[str]) -> int:
        """The place behind the definitions."""
        scopes: list[str] = []
        for number, line in enumerate(lines):
            words = line.split()
            if line.startswith("$scope"):
                scopes.append(words[2])
            elif line.startswith("$upscope"):
                scopes.pop()
            elif line.startswith("$var"):
                self.names[".".join([*scopes, words[4].partition("[")[0]])] = (words[3], words[4], int(words[2]))
            elif line.startswith("$enddefinitions"):
                return number + 1
        return len(lines)

    def _add(self, key: str, time: int, value: str) -> None:
        self._times.setdefault(key, []).append(time)
        self._values.setdefault(key, []).append(value)

    def label(self, name: str) -> str:
        """The name as a viewer has it, with the range of a vector."""
        return name.rpartition(".")[0] + "." + self.names[name][1]

    def bits(self, name: str) -> int:
        return self.names[name][2]

    def at(self, name: str, time: int) -> Seen | None:
        """The number at a time, "X" where a bit is neither 0 nor 1, None before the first value."""
        if name not in self.names:
            raise FlowError(f"the waveform has no signal {name}", EXIT_TOOL_FAILED)
        key = self.names[name][0]
        place = bisect.bisect_right(self._times.get(key, []), time) - 1
        if place < 0:
            return None
        value = self._values[key][place]
        return int(value, 2) if re.fullmatch("[01]+", value) else "X"
