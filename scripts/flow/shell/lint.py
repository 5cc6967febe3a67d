# SPDX-License-Identifier: Apache-2.0
"""Checks of the hand-written VHDL: GHDL's warnings, what only shows in the synthesised netlist, and the layout of the
text."""

from __future__ import annotations

import contextlib
import re
import shutil
from collections.abc import Iterable
from pathlib import Path

from ..base import ghdl, rtl
from ..base.errors import FlowError
from ..base.tools import ROOT, Say, find_ghdl, find_verilator, find_yosys, run
from ..synthesis import manifest
from . import board_vhdl, design, template

GHDL_WARNINGS = (
    *("binding", "reserved", "nested-comment", "parenthesis", "delayed-checks", "body", "specs", "universal", "port"),
    *("runtime-error", "shared", "hide", "unused", "others", "pure", "static", "error"),
)
NETLIST_WARNINGS = ("LATCH", "MULTIDRIVEN", "SELRANGE", "UNDRIVEN", "IMPLICIT", "PINMISSING")
CAMERA_TABLES, CAMERA_DEPTH, CAMERA_IMAGE = (
    ROOT / "examples" / "camera_system" / f"camera_{name}.vhd" for name in ("tables", "depth", "image")
)
IMAGE_SIZES = {"width_px": 640, "output_width_px": 638, "first_column": 1, "kept": 6000, "address_bits": 13}
LONGEST_LINE = 128
LONGEST_FILE = 400
FIRST_LINE = "-- SPDX-License-Identifier: Apache-2.0"


def layout(path: Path) -> list[str]:
    """Sentences about the text of one file."""
    lines = path.read_text().splitlines()
    found = [] if lines and lines[0] == FIRST_LINE else [f"line 1 is not '{FIRST_LINE}'"]
    if len(lines) > LONGEST_FILE:
        found.append(f"{len(lines)} lines, at most {LONGEST_FILE}")
    for number, line in enumerate(lines, 1):
        code = re.sub(r'"[^"]*"', '""', line.partition("--")[0])
        found += [
            f"line {number}: {what}"
            for what, wrong in (
                (f"longer than {LONGEST_LINE} characters", len(line) > LONGEST_LINE),
                ("a tab", "\t" in line),
                ("blanks at the end", line != line.rstrip()),
                ("a capital letter in the code", bool(re.search("[A-Z]", code))),
                (
                    "a signal assigned to itself, whose conditions GHDL's synthesis can lose",
                    bool(re.search(r"\b(\w+) <= \1;", code)),
                ),
                ("an odd indentation", (len(line) - len(line.lstrip())) % 2 == 1),
            )
            if wrong
        ]
    return [f"{path.name}: {sentence}" for sentence in found]


def analysis(files: Iterable[Path], work: Path) -> list[str]:
    """GHDL's warnings about the files, each after those it needs."""
    log = work / "analyse.log"
    warnings = [f"--warn-{name}" for name in GHDL_WARNINGS]
    with contextlib.suppress(FlowError):  # its sentences are in the log, too
        run([find_ghdl(), "-a", ghdl.STANDARD, *warnings, *files], cwd=work, log=log)
    return [line for line in log.read_text().splitlines() if re.search(r":\d+:\d+:", line)]


def netlist(files: Iterable[Path], top: str, work: Path, generics: ghdl.Generics | None = None) -> list[str]:
    """What shows in the synthesised design only: names that Verilog reserves and two drivers of one signal (Verilator),
    latches and loops (yosys)."""
    verilog, log = work / f"{top}.v", work / "verilator.log"
    text = ghdl.to_verilog(files, work, top, generics)
    verilog.write_text(text)
    # What GHDL writes for a signal that keeps its value outside a clocked process, or has none.
    found = [
        f"latch, or no value: {name}"
        for name in re.findall(r"^ *assign (\S+) = \d+'b[xX]+; // \(signal\)$", text, re.MULTILINE)
    ]
    warnings = [f"-Wwarn-{name}" for name in NETLIST_WARNINGS]
    run([find_verilator(), "--lint-only", "-Wno-fatal", *warnings, "--top-module", top, verilog], log=log)
    found += [
        line
        for line in log.read_text().splitlines()
        if re.match(rf"%(Error|Warning-({'|'.join(NETLIST_WARNINGS)}))", line)
    ]
    script = f"read_verilog {verilog}; hierarchy -top {top}; proc; flatten; check; select -count t:$dlatch t:$dlatchsr"
    run([find_yosys(), "-p", script], log=log.with_name("yosys.log"))
    said = log.with_name("yosys.log").read_text()
    found += re.findall(r"^Warning: (?:found logic loop|multiple conflicting drivers).*$", said, re.MULTILINE)
    return found + [
        f"{count} latches" for count in re.findall(r"^(\d+) objects\.$", said, re.MULTILINE) if count != "0"
    ]


def check(config: str, work: Path, shell: Path | None = None, say: Say = print) -> int:
    """All checks of the shell around one configuration's core, of the joiner and of the example, in a folder of their
    own. Returns the number of findings. `shell`: a folder with another shell and joiner."""
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    memory, shared, joiner = rtl.MEMORY_CELL, design.shell_files(shell), design.joiner_files(shell)
    written = [*shared, template.path(config)]
    core = [path for path in manifest.core_files(config) if path != memory]
    examples = [*board_vhdl.COMMITTED, board_vhdl.BENCH, CAMERA_TABLES, CAMERA_DEPTH, CAMERA_IMAGE]
    found = [sentence for path in (memory, *written, *joiner, *examples) for sentence in layout(path)]
    found += analysis([memory], work)
    ghdl.analyse(core, work, "core.log")
    found += analysis([*written, *joiner, *examples], work)
    if not found:
        found += netlist([memory, *core, *written], rtl.ip_entity(config), work)
        for bits in (rtl.PIXEL_BITS, 12):
            sizes = {"width_px": 640, "height_px": 480, "depth": 1024}
            lanes = {"pixel_bits": bits, "lane_bits": template.lane_bits(bits)}
            found += netlist([memory, *shared, *joiner], "stereo_joiner", work, sizes | lanes)
        found += netlist([memory, *core, *written, *board_vhdl.COMMITTED], board_vhdl.TOP, work)
        nodes: ghdl.Generics = {"table_columns": 41, "table_rows": 31, "depth_entries": 1024, "subpixel": "true"}
        found += netlist([CAMERA_TABLES], "camera_tables", work, nodes)
        found += netlist([memory, CAMERA_DEPTH], "camera_depth", work, {"place_bits": 10, "disparity_bits": 16})
        found += netlist([memory, CAMERA_IMAGE], "camera_image", work, IMAGE_SIZES | {"pixel_bits": 8})
    for sentence in found:
        say(sentence)
    return len(found)
