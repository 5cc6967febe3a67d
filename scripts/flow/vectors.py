# SPDX-License-Identifier: Apache-2.0
"""The text files between the C++ core, the simulators and the checker.

stimulus.txt   stereo-hls stimulus 1 config=NAME clocks=N      then N lines  "F LL RR", hexadecimal, one a clock;
               F bit 0 valid, bit 1 start of frame; LL, RR left and right pixel
expected.txt   stereo-hls expected 1 config=NAME outputs=N latency=CLOCKS
               then N lines "clock x y frame disparity flags", decimal, one for each valid output of the C++ core
observed.txt   "clock disparity flags" for each valid output of the simulated VHDL, then "end CLOCKS";
               "clock X X" where an output was neither 0 nor 1

flags: bit 0 start of frame, bit 1 end of line. Clocks count from 0, the first clock after reset.
"""

import re
from dataclasses import dataclass
from pathlib import Path

from .errors import EXIT_TOOL_FAILED, FlowError


@dataclass(frozen=True)
class Expected:
    clock: int
    x: int
    y: int
    frame: int
    disparity: int
    flags: int


@dataclass(frozen=True)
class Observed:
    clock: int
    disparity: object  # int, or "X" where the simulator saw no number
    flags: object


def _read_lines(path):
    try:
        return Path(path).read_text(encoding="ascii").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise FlowError(f"cannot read vector file {path}: {getattr(error, 'strerror', None) or 'not a text file'}") from None


def _read_header(path, lines, kind, count_key):
    match = re.fullmatch(rf"stereo-hls {kind} 1 ((?:\w+=\S+ ?)+)", lines[0]) if lines else None
    if not match:
        raise FlowError(f"{path}, line 1: not a '{kind}' vector file of format 1")
    header = dict(item.split("=", 1) for item in match.group(1).split())
    try:
        count = int(header[count_key])
    except (KeyError, ValueError):
        raise FlowError(f"{path}, line 1: no number {count_key}=") from None
    if len(lines) - 1 != count:
        raise FlowError(f"{path}: the first line promises {count} lines, but {len(lines) - 1} follow")
    return header


def read_stimulus(path):
    """The stimulus as a list of (valid, start_of_frame), one a clock."""
    lines = _read_lines(path)
    _read_header(path, lines, "stimulus", "clocks")
    for number, line in enumerate(lines[1:], 2):
        if not re.fullmatch(r"[0-3] [0-9a-f]{2} [0-9a-f]{2}", line):
            raise FlowError(f"{path}, line {number}: '{line}' is not 'F LL RR'")
    return [(line[0] in "13", line[0] in "23") for line in lines[1:]]


def read_expected(path):
    """(expected outputs, latency of the C++ core in clocks)"""
    lines = _read_lines(path)
    header = _read_header(path, lines, "expected", "outputs")
    outputs = []
    for number, line in enumerate(lines[1:], 2):
        if not re.fullmatch(r"\d+( \d+){5}", line):
            raise FlowError(f"{path}, line {number}: '{line}' is not 'clock x y frame disparity flags'")
        outputs.append(Expected(*map(int, line.split())))
    if not re.fullmatch(r"\d+", header.get("latency", "")):
        raise FlowError(f"{path}, line 1: no number latency=")
    return outputs, int(header["latency"])


def read_observed(path):
    """(observed outputs, simulated clocks). A file without its last line comes from a simulation that did not end."""
    lines = _read_lines(path)
    if not lines or not re.fullmatch(r"end \d+", lines[-1]):
        raise FlowError(f"{path}: the simulation did not write its last line, so it did not finish", EXIT_TOOL_FAILED)
    outputs = []
    for number, line in enumerate(lines[:-1], 1):
        if not re.fullmatch(r"\d+ (\d+ \d+|X X)", line):
            raise FlowError(f"{path}, line {number}: '{line}' is not 'clock disparity flags'", EXIT_TOOL_FAILED)
        clock, disparity, flags = line.split()
        known = disparity != "X"
        outputs.append(Observed(int(clock), int(disparity) if known else "X", int(flags) if known else "X"))
    return outputs, int(lines[-1].split()[1])
