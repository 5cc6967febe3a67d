# SPDX-License-Identifier: Apache-2.0
"""A camera_system in Verilator or GHDL: tables and two cameras' streams in, frames of depths out."""

from __future__ import annotations

import random
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from ..base import rtl
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import ROOT, Word
from ..shell.template import lane_bits
from ..simulation import simulation, simulators
from ..simulation.simulators import Design
from . import pipeline
from .pipeline import Image, Table
from .template import System, beside_of, vhdl_files

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


class Simulation(simulation.Simulation):
    """A system, built once and played any number of times."""

    in_simulator: simulators.Simulator
    options: Sequence[Word] = ()

    def __init__(self, system: System, files: list[Path] | None = None) -> None:
        self.system = system
        self._pixel_bits = rtl.pixel_bits_of(pipeline.rows_of(system)[1])
        self._lane_bits = lane_bits(self._pixel_bits)
        folder = WORK / type(self).__name__.lower() / system.name
        super().__init__(self.in_simulator, self._design(system, files or vhdl_files(system)), folder)
        self.build()

    def _design(self, system: System, files: list[Path]) -> Design:
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
        lines = [f"t {address:02x} {data:08x}" for address, data in writes] + [f"s {sink[0]} {sink[1]}"]
        lines += self._camera_lines("l", left) + self._camera_lines("r", right)
        stream.write_text("\n".join(lines) + "\n")
        given = {"stream_file": stream.resolve(), "observed_file": observed.resolve()}
        self.run_bench(given, WATCHDOG_SECONDS, options=self.options, writes=observed)
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
    in_simulator = simulators.SIMULATORS["verilator"]

    def _design(self, system: System, files: list[Path]) -> Design:
        return Design(system.entity, files, [BENCHES / "camera_bench.cpp"])


class InGhdl(Simulation):
    in_simulator = simulators.SIMULATORS["ghdl"]
    options = ("--ieee-asserts=disable-at-0",)

    def _design(self, system: System, files: list[Path]) -> Design:
        bench = BENCHES / "tb_camera_system.vhd"
        text = bench.read_text().replace("camera_system_NAME", system.entity)
        for name, value in (("lane_bits", self._lane_bits), ("map_bits", beside_of(system).beat_bits)):
            text = re.sub(rf"(?<=constant {name} : positive := )\d+", str(value), text)
        return Design(bench.stem, files, texts={bench.name: text})


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
