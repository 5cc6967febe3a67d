# SPDX-License-Identifier: Apache-2.0
"""A camera_system in Verilator or GHDL: tables and two cameras' streams in, frames of depths out."""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from ..base import builds, ghdl, rtl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Word, find_ghdl, run_with_progress
from ..cosim import simulators
from ..shell.template import lane_bits
from . import pipeline
from .pipeline import Image, Table
from .template import System, vhdl_files

BENCHES = ROOT / "hls_tb" / "system"
WORK = ROOT / "build" / "camera_system"
WATCHDOG_SECONDS = 300
NODE_PLACE, NODE_OFFSETS, DEPTH = 0x00, 0x04, 0x08
OKAY = 0


class Beat(NamedTuple):
    gap: int  # clocks since the one before
    pixel: int
    flags: int  # 1 start of frame, 2 end of line


@dataclass
class Frame:
    words: list[int] = field(default_factory=list)
    error: bool = False  # as its last beat says
    start: int = 0  # clocks
    line_starts: list[int] = field(default_factory=list)
    line_ends: list[int] = field(default_factory=list)


@dataclass
class Observation:
    responses: list[int]
    frames: list[Frame]
    line_ends: tuple[list[int], list[int]]  # clocks, of each camera
    clocks: int


def table_writes(tables: Sequence[Table], depths: Sequence[int]) -> list[tuple[int, int]]:
    """(address, data) of all that a system is loaded with; `tables`: left and right."""
    writes = []
    for right, table in enumerate(tables):
        for row, nodes in enumerate(table):
            for column, node in enumerate(nodes):
                writes.append((NODE_PLACE, right << 31 | row << 16 | column))
                writes.append((NODE_OFFSETS, (node.y & 0xFFFF) << 16 | node.x & 0xFFFF))
    return writes + [(DEPTH, disparity << 16 | mm) for disparity, mm in enumerate(depths)]


def beats(image: Image, line_clocks: int = 0) -> list[Beat]:
    """A frame of one camera, each line at full speed and `line_clocks` or more after the one before."""
    width = len(image[0])
    pause = max(line_clocks - width, 0)
    return [
        Beat(pause if x == 0 < y else 0, pixel, (y == 0 and x == 0) + 2 * (x == width - 1))
        for y, row in enumerate(image)
        for x, pixel in enumerate(row)
    ]


class Simulation:
    """A system, built once and played any number of times."""

    bench = BENCHES / "camera_bench.cpp"

    def __init__(self, system: System, files: list[Path] | None = None) -> None:
        self.system, self.files = system, files or vhdl_files(system)
        self._pixel_bits = rtl.pixel_bits_of(pipeline.rows_of(system)[1])
        self._lane_bits = lane_bits(self._pixel_bits)
        makers = [self.bench, *(Path(module) for module in (__file__, simulators.__file__, ghdl.__file__))]
        folder = WORK / type(self).__name__.lower() / system.name
        self._built = builds.build_once(folder, self.files, makers, self._tools(), self._build)

    @staticmethod
    def _tools() -> dict[str, str]:
        raise NotImplementedError

    def _build(self, work: Path, files: list[Path]) -> None:
        raise NotImplementedError

    def _command(self, stream: Path, observed: Path) -> list[Word]:
        raise NotImplementedError

    def play(
        self,
        writes: Iterable[tuple[int, int]],
        left: Iterable[Beat],
        right: Iterable[Beat],
        out: Path,
        sink: tuple[int, int] = (0, 1),
    ) -> Observation:
        """`sink`: how often it waits in percent, and the seed."""
        out.mkdir(parents=True, exist_ok=True)
        stream, observed = out / "stream.txt", out / "observed.txt"
        observed.unlink(missing_ok=True)
        lines = [f"t {address:02x} {data:08x}" for address, data in writes] + [f"s {sink[0]} {sink[1]}"]
        lines += self._camera_lines("l", left) + self._camera_lines("r", right)
        stream.write_text("\n".join(lines) + "\n")
        command = self._command(stream.resolve(), observed.resolve())
        run_with_progress(command, lambda line: None, WATCHDOG_SECONDS, cwd=self._built.folder)
        return read(observed)

    def _camera_lines(self, camera: str, beats: Iterable[Beat]) -> list[str]:
        """With garbage in the bits of a lane above the pixel."""
        digits, above = self._lane_bits // 4, self._lane_bits - self._pixel_bits
        garbage = random.Random(camera)
        return [
            f"{camera} {b.gap} {garbage.getrandbits(above) << self._pixel_bits | b.pixel:0{digits}x} {b.flags}"
            for b in beats
        ]


class Verilated(Simulation):
    @staticmethod
    def _tools() -> dict[str, str]:
        return simulators.Verilator.tools()

    def _build(self, work: Path, files: list[Path]) -> None:
        simulators.verilate(work, files, self.system.entity, [self.bench])

    def _command(self, stream: Path, observed: Path) -> list[Word]:
        return [simulators.verilated_bench(self._built.folder), stream, observed]


class InGhdl(Simulation):
    bench = BENCHES / "tb_camera_system.vhd"

    @staticmethod
    def _tools() -> dict[str, str]:
        return simulators.Ghdl.tools()

    def _build(self, work: Path, files: list[Path]) -> None:
        copy = work / self.bench.name
        text = self.bench.read_text().replace("camera_system_NAME", self.system.entity)
        copy.write_text(text.replace("lane_bits : positive := 8", f"lane_bits : positive := {self._lane_bits}"))
        ghdl.analyse([*files, copy], work)
        ghdl.elaborate(work, self.bench.stem)

    def _command(self, stream: Path, observed: Path) -> list[Word]:
        generics = ghdl.options_of({"stream_file": str(stream), "observed_file": str(observed)})
        return [find_ghdl(), "-r", ghdl.STANDARD, self.bench.stem, *generics, "--ieee-asserts=disable-at-0"]


def read(path: Path) -> Observation:
    lines = path.read_text().splitlines()
    if not lines or not lines[-1].startswith("end "):
        raise FlowError(f"{path}: the simulation did not write its last line, so it did not finish", EXIT_TOOL_FAILED)
    seen = Observation([], [], ([], []), int(lines[-1].split()[1]))
    new_line = True
    for line in lines[:-1]:
        kind, *words = line.split()
        if kind == "t":
            seen.responses.append(int(words[0]))
        elif kind == "e":
            seen.line_ends[int(words[0])].append(int(words[1]))
        else:
            data, flags, clock = int(words[0], 16), int(words[1]), int(words[2])
            if flags & 1:
                seen.frames.append(Frame(start=clock))
            if not seen.frames:
                raise FlowError(f"{path}: a beat before the first start of frame", EXIT_TOOL_FAILED)
            frame = seen.frames[-1]
            if new_line:
                frame.line_starts.append(clock)
            new_line = bool(flags & 4)
            if new_line:
                frame.line_ends.append(clock)
            frame.words.append(data)
            frame.error = bool(flags & 2)
    return seen
