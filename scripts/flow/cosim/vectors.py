# SPDX-License-Identifier: Apache-2.0
"""The text files between the C++ core, the simulators and the checker.

stimulus.txt, expected.txt   what the C++ core makes: hls_tb/cosim/vector_files.hpp defines them
observed.txt                 "clock DISPARITY flags" for each valid output of the simulated VHDL, with the word and the
                             flags of expected.txt, then "end CLOCKS"; "clock X X" where an output was neither 0 nor 1

Clocks count from 0, the first clock after reset.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Union

from ..base import rtl
from ..base.configurations import Parameters, option
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from .bench import Ports

FORMATS = {"stimulus": 2, "expected": 2}
NUMBER = r"\d{1,18}"  # decimal; longer ones count nothing that exists


@dataclass(frozen=True)
class Expected:
    clock: int
    x: int
    y: int  # of the upper row
    frame: int
    disparity: int  # port word
    flags: int


Seen = Union[int, Literal["X"]]  # "X" where the simulator saw no number


@dataclass(frozen=True)
class Observed:
    clock: int
    disparity: Seen  # port word
    flags: Seen


def read_lines(path: Path) -> list[str]:
    """The lines of a text file of a simulation."""
    try:
        return path.read_text(encoding="ascii").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise FlowError(
            f"cannot read vector file {path}: {getattr(error, 'strerror', None) or 'not a text file'}"
        ) from None


def _read_header(path: Path, lines: list[str], kind: str, count_key: str) -> tuple[dict[str, str], int]:
    """(what the first line says, digits of a word of pixels)"""
    match = re.fullmatch(rf"stereo-hls {kind} {FORMATS[kind]} ((?:\w+=\S+ ?)+)", lines[0]) if lines else None
    if not match:
        raise FlowError(f"{path}, line 1: not a '{kind}' vector file of format {FORMATS[kind]}")
    header = dict(item.split("=", 1) for item in match.group(1).split())
    if header.get("pixels") not in ("1", "2", "4"):
        raise FlowError(f"{path}, line 1: pixels= must be 1, 2 or 4")
    if not re.fullmatch(NUMBER, header.get(count_key, "")):
        raise FlowError(f"{path}, line 1: no number {count_key}=")
    if len(lines) - 1 != int(header[count_key]):
        raise FlowError(f"{path}: the first line promises {header[count_key]} lines, but {len(lines) - 1} follow")
    return header, 2 * int(header["pixels"])


def row_bits(parameters: Parameters) -> int:
    """Of what a row shows in the word of an output, disparity_bits= in the files."""
    kind = rtl.kind_of(parameters)
    ports = [port for port in kind.ports if port.name in kind.word]
    return sum(port.lane_bits or option(parameters, "disparity_bits") for port in ports)


def check_fits(path: Path, config: str, parameters: Parameters) -> None:
    """Refuses a vector file, read before, whose first line says that it is for another core."""
    header = dict(item.split("=", 1) for item in read_lines(path)[0].split()[3:])
    known = {"config": config, "pixels": parameters["pixels_per_clock"], "disparity_bits": row_bits(parameters)}
    known["pixel_bits"] = rtl.pixel_bits_of(parameters)
    for key, value in known.items():
        if header.get(key, str(value)) != str(value):
            raise FlowError(f"{path}, line 1: {key}={header[key]}, but the core is {config} with {key}={value}")


# (valid, start_of_frame) of each clock.
Stimulus = list[tuple[bool, bool]]


def read_stimulus(path: Path, kind: rtl.Kind = rtl.CORE) -> Stimulus:
    lines = read_lines(path)
    _, digits = _read_header(path, lines, "stimulus", "clocks")
    ports = Ports(kind, digits // 2, 0)
    pattern, flags_end = re.compile(ports.line_pattern()), 1 << len(ports.flags)
    clocks = []
    for number, line in enumerate(lines[1:], 2):
        match = pattern.fullmatch(line)
        flags = int(match[1], 16) if match else flags_end
        if flags >= flags_end:
            raise FlowError(f"{path}, line {number}: '{line}' is not {ports.line()}")
        taken = not flags & 4  # nothing is taken in a clock with reset
        clocks.append((bool(flags & 1 and taken), bool(flags & 2 and taken)))
    return clocks


def read_expected(path: Path) -> tuple[list[Expected], int]:
    """(expected outputs, latency of the C++ core in clocks)"""
    lines = read_lines(path)
    header, digits = _read_header(path, lines, "expected", "outputs")
    if header.get("disparity_bits") not in ("8", "16", "20", "24"):
        raise FlowError(f"{path}, line 1: disparity_bits= must be 8 or 16, or 20 or 24 of a stage")
    digits = digits * int(header["disparity_bits"]) // 8
    pattern = re.compile(rf"({NUMBER}) ({NUMBER}) ({NUMBER}) ({NUMBER}) ([0-9a-f]{{{digits}}}) (\d{{1,3}})")
    outputs = []
    for number, line in enumerate(lines[1:], 2):
        match = pattern.fullmatch(line)
        if not match:
            raise FlowError(
                f"{path}, line {number}: '{line}' is not 'clock x y frame DISPARITY flags' with {digits} digits"
            )
        clock, x, y, frame, disparity, flags = match.groups()
        outputs.append(Expected(int(clock), int(x), int(y), int(frame), int(disparity, 16), int(flags)))
    if not re.fullmatch(NUMBER, header.get("latency", "")):
        raise FlowError(f"{path}, line 1: no number latency=")
    return outputs, int(header["latency"])


def read_observed(path: Path) -> tuple[list[Observed], int]:
    """(observed outputs, simulated clocks). A file without its last line comes from a simulation that did not end."""
    lines = read_lines(path)
    if not lines or not re.fullmatch(f"end {NUMBER}", lines[-1]):
        raise FlowError(f"{path}: the simulation did not write its last line, so it did not finish", EXIT_TOOL_FAILED)
    outputs = []
    for number, line in enumerate(lines[:-1], 1):
        if not re.fullmatch(rf"{NUMBER} ([0-9A-Fa-f]{{1,16}} \d{{1,3}}|X X)", line):
            raise FlowError(f"{path}, line {number}: '{line}' is not 'clock DISPARITY flags'", EXIT_TOOL_FAILED)
        clock, disparity, flags = line.split()
        known = disparity != "X"
        outputs.append(Observed(int(clock), int(disparity, 16) if known else "X", int(flags) if known else "X"))
    return outputs, int(lines[-1].split()[1])
