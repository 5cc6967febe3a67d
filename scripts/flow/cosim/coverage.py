# SPDX-License-Identifier: Apache-2.0
"""What a stream has moved in a core: which bits of its registers took both values, and which `if` of the VHDL went both
ways, by Verilator's toggle coverage of GHDL's Verilog. Names are those of the C++ core, lines those of the VHDL.

A bit that never moved is a hole of the stream, or it cannot move: yosys-abc is asked to prove that, over all inputs,
resets and broken streams too."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TypedDict

from ..base import aiger, files
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Word, find_tool, run

DATA = "coverage.dat"  # that Verilator's program writes
FILES = (DATA, "coverage.json", "coverage.info", "coverage")
MERGING_SECONDS = 600  # for the merging of registers, which proves most of them at once
SECONDS = 5  # for the proof of one of the others
_UNNAMED = re.compile(r"n\d+_\w+")
_DECLARED = re.compile(r"^  (?:wire|reg) (?:\[\d+:0\] )?(\w+) *;.*$", re.MULTILINE)
# What decides a choice, below the place of its `if`.
_CHOICE = re.compile(r"/\* (?:.*/)?(.*):(\d+):\d+ +\*/\n  assign \w+ = (\w+) \? ")
_NO_REGISTER = re.compile(r"in_\w+|\w+_(read_enable|read_address|write_address|write_data)")
_POINT = re.compile(r"^C '(.*)' (\d+)$", re.MULTILINE)


class Coverage(TypedDict):
    """coverage.json"""

    register_bits: int
    never_moved: list[str]  # NAME(BIT) that the stream has left as it was and that might move
    cannot_move: list[str]  # those that are proved to stay as they are
    branches: int
    never_both_ways: list[str]  # the line of the VHDL of each `if` that went one way only


def _module(verilog: str, top: str) -> int:
    """Where the module of the core begins; those of its memories come before it."""
    match = re.search(rf"^module {top}\b", verilog, re.MULTILINE)
    if not match:
        raise FlowError(f"ghdl --synth did not write a module {top}", EXIT_TOOL_FAILED)
    return match.start()


def marked(verilog: str, top: str) -> str:
    """The same design, of which Verilator counts only what `read` looks at: all else would take three times as long."""
    start = _module(verilog, top)
    body = verilog[start:]
    looked_at = {match[3] for match in _CHOICE.finditer(body)}

    def declaration(match: re.Match[str]) -> str:
        if match[1] in looked_at or not _UNNAMED.fullmatch(match[1]):
            return match[0]
        return f"/*verilator coverage_off*/\n{match[0]}\n/*verilator coverage_on*/"

    memories = f"/*verilator coverage_off*/\n{verilog[:start]}/*verilator coverage_on*/\n"
    return memories + _DECLARED.sub(declaration, body)


def _toggles(data: str, top: str) -> dict[str, int]:
    """{NAME or NAME[BIT] of the core: how often it has changed}"""
    counts: dict[str, int] = {}
    for point in _POINT.finditer(data):
        fields = dict(field.split("\2", 1) for field in point[1].split("\1") if "\2" in field)
        if fields.get("h", "").endswith(top) and "toggle" in fields.get("page", ""):
            # Newer releases count rises and falls apart, as NAME:0->1.
            name = fields["o"].partition(":")[0]
            counts[name] = counts.get(name, 0) + int(point[2])
    return counts


def _that_stay(verilog: str, top: str, bits: list[str], work: Path) -> set[str]:
    """Those of some bits that are proved to stay what they are from the second clock on, behind the first reset."""
    if not bits:
        return set()
    start, count = _module(verilog, top), len(bits)
    header = re.compile(rf"module {top}\s*\((.*?)\);", re.DOTALL).search(verilog, start)
    assert header is not None
    inputs = ", ".join(" ".join(port) for port in re.findall(r"(input)\s+(\[\d+:0\])?\s*(\w+)", header[1]))
    outputs = "\n".join(
        f"  wire {width} {name};" for width, name in re.findall(r"output\s+(\[\d+:0\])?\s*(\w+)", header[1])
    )
    inputs = inputs.replace(" reset", " any_reset")
    looks = (
        f"  reg [1:0] age = 0;\n  reg [{count - 1}:0] before = 0;\n  wire reset = any_reset | (age == 0);\n"
        f"  wire [{count - 1}:0] now = {{{', '.join(reversed(bits))}}};\n"
        "  always @(posedge clock) begin before <= now; if (age != 2) age <= age + 1; end\n"
        f"  assign moved = (now ^ before) & {{{count}{{age == 2}}}};\n"
    )
    body, _, rest = verilog[header.end() :].partition("endmodule")
    ports = f"{inputs}, output [{count - 1}:0] moved"
    made = f"{verilog[:start]}module moves({ports});\n{outputs}\n{body}{looks}endmodule{rest}"
    aiger.write(made, "moves", work, starts_at_zero=True)

    # First by the merging of equal registers, which leaves a constant where a bit stays; scorr takes minutes.
    proved: set[int] = set()
    graph = "design"
    for merging in ("lcorr", "scorr"):
        if len(proved) == count or not aiger.ask(
            f"read {graph}.aig; scleanup; {merging}; write {merging}.aig", work, MERGING_SECONDS
        ):
            break
        graph = merging
        proved = {number for number, edge in enumerate(aiger.outputs(work / f"{graph}.aig")) if edge == 0}
    for number in sorted(set(range(count)) - proved):
        if aiger.prove(f"read {graph}.aig; cone -s -O {number}; scleanup", work, SECONDS, MERGING_SECONDS).proved:
            proved.add(number)
    return {bits[number] for number in proved}


def read(data: Path, verilog: Path, vhdl: Mapping[str, str], top: str, work: Path) -> Coverage:
    """`vhdl`: {file name: text} of the core's files. `work`: a folder for the proofs."""
    try:
        counts = _toggles(data.read_text(encoding="latin1"), top)
    except (OSError, ValueError) as error:
        raise FlowError(f"cannot read Verilator's coverage {data}: {error}", EXIT_TOOL_FAILED) from None
    text = verilog.read_text()
    bits = {
        name: count
        for name, count in counts.items()
        if not _UNNAMED.match(name) and not _NO_REGISTER.fullmatch(name.partition("[")[0])
    }
    declared = {match[1] for match in _DECLARED.finditer(text, _module(text, top))}
    bits = {name: count for name, count in bits.items() if name.partition("[")[0] in declared}  # no ports
    if not bits:
        raise FlowError(f"Verilator's coverage {data} counts no register of {top}", EXIT_TOOL_FAILED)
    still = [name for name, count in bits.items() if count == 0]
    proved = _that_stay(text, top, still, work)
    branches: dict[tuple[str, int], bool] = {}  # went both ways
    for file, line, decides in _CHOICE.findall(text[_module(text, top) :]):
        if file in vhdl and decides in counts:
            place = (file, int(line))
            branches[place] = branches.get(place, True) and counts[decides] > 0
    one_way = [
        f"{file}:{line}: {vhdl[file].splitlines()[line - 1].strip()}"
        for (file, line), both in sorted(branches.items())
        if not both and vhdl[file].splitlines()[line - 1].lstrip().startswith(("if", "elsif"))
    ]
    return {
        "register_bits": len(bits),
        "never_moved": [_vhdl_name(name) for name in still if name not in proved],
        "cannot_move": [_vhdl_name(name) for name in still if name in proved],
        "branches": len(branches),
        "never_both_ways": one_way,
    }


def _vhdl_name(bit: str) -> str:
    return bit.replace("[", "(").replace("]", ")")


def summary(coverage: Coverage) -> list[str]:
    """The lines for the terminal."""
    held = len(coverage["never_moved"]) + len(coverage["cannot_move"])
    lines = [
        f"  coverage: {coverage['register_bits'] - held:,} of {coverage['register_bits']:,} register bits took both "
        f"values, "
        f"{len(coverage['cannot_move'])} are proved to stay as they are, {len(coverage['never_moved'])} might move"
    ]
    lines += [f"    never moved: {', '.join(coverage['never_moved'])}"] if coverage["never_moved"] else []
    one_way = coverage["never_both_ways"]
    lines.append(
        f"  coverage: {coverage['branches'] - len(one_way):,} of {coverage['branches']:,} branches went both ways"
    )
    return lines + [f"    one way only: {line}" for line in one_way]


def write(folder: Path, coverage: Coverage, data: Path) -> None:
    """coverage.json, coverage.info for lcov, and with genhtml its pages in coverage/."""
    folder, data = folder.absolute(), data.absolute()  # the programs run in another folder
    files.write(folder / "coverage.json", json.dumps(coverage, indent=2) + "\n")
    info = folder / "coverage.info"
    run([find_tool("verilator_coverage"), "--write-info", info, data], cwd=data.parent)
    try:
        genhtml: list[Word] = [find_tool("genhtml", hint="on Debian: apt-get install lcov")]
    except FlowError as error:
        print(f"  no pages of the coverage: {error}")
        return
    run([*genhtml, "--quiet", "--output-directory", folder / "coverage", info], cwd=data.parent)
    print(f"  pages of the coverage: {folder / 'coverage' / 'index.html'}")
