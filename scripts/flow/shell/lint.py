# SPDX-License-Identifier: Apache-2.0
"""Checks of the hand-written VHDL: GHDL's warnings, what only shows in the synthesised netlist, and the layout of the text."""

import re
import shutil
from pathlib import Path

from ..base.errors import FlowError
from ..base.tools import GENERATED_RTL, find_ghdl, find_verilator, run
from ..cosim.simulators import GHDL_STANDARD, to_verilog
from ..implementation.yosys import find_yosys
from ..synthesis import manifest
from . import design, example

GHDL_WARNINGS = (
    "binding",
    "reserved",
    "nested-comment",
    "parenthesis",
    "delayed-checks",
    "body",
    "specs",
    "universal",
    "port",
    "runtime-error",
    "shared",
    "hide",
    "unused",
    "others",
    "pure",
    "static",
    "error",
)
NETLIST_WARNINGS = ("LATCH", "MULTIDRIVEN", "SELRANGE", "UNDRIVEN", "IMPLICIT", "PINMISSING")
LONGEST_LINE = 128
LONGEST_FILE = 400
FIRST_LINE = "-- SPDX-License-Identifier: Apache-2.0"


def layout(path):
    """Sentences about the text of one file."""
    lines = Path(path).read_text().splitlines()
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
                ("an odd indentation", (len(line) - len(line.lstrip())) % 2 == 1),
            )
            if wrong
        ]
    return [f"{Path(path).name}: {sentence}" for sentence in found]


def analysis(files, work):
    """GHDL's warnings about the files, each after those it needs."""
    log = Path(work) / "analyse.log"
    command = [find_ghdl(), "-a", GHDL_STANDARD, *(f"--warn-{name}" for name in GHDL_WARNINGS), *files]
    try:
        run(command, cwd=work, log=log)
    except FlowError:
        pass  # its sentences are in the log, too
    return [line for line in log.read_text().splitlines() if re.search(r":\d+:\d+:", line)]


def netlist(files, generics, work):
    """What shows in the synthesised design only: names that Verilog reserves and two drivers of one signal (Verilator),
    latches and loops (yosys)."""
    verilog, log = Path(work) / "stereo_ip.v", Path(work) / "verilator.log"
    text = to_verilog(files, work, "stereo_ip", generics)
    verilog.write_text(text)
    # What GHDL writes for a signal that keeps its value outside a clocked process, or has none.
    found = [
        f"latch, or no value: {name}"
        for name in re.findall(r"^ *assign (\S+) = \d+'b[xX]+; // \(signal\)$", text, re.MULTILINE)
    ]
    run(
        [
            find_verilator(),
            "--lint-only",
            "-Wno-fatal",
            *(f"-Wwarn-{name}" for name in NETLIST_WARNINGS),
            "--top-module",
            "stereo_ip",
            verilog,
        ],
        log=log,
    )
    found += [
        line
        for line in log.read_text().splitlines()
        if re.match(rf"%(Error|Warning-({'|'.join(NETLIST_WARNINGS)}))", line)
    ]
    script = (
        f"read_verilog {verilog}; hierarchy -top stereo_ip; proc; flatten; check; select -count t:$dlatch t:$dlatchsr"
    )
    run([find_yosys(), "-p", script], log=log.with_name("yosys.log"))
    said = log.with_name("yosys.log").read_text()
    found += re.findall(r"^Warning: (?:found logic loop|multiple conflicting drivers).*$", said, re.MULTILINE)
    return found + [
        f"{count} latches" for count in re.findall(r"^(\d+) objects\.$", said, re.MULTILINE) if count != "0"
    ]


def check(config, generics, work, shell=None, say=print):
    """All checks of the shell around one configuration's core and of the example, in a folder of their own. Returns the number
    of findings."""
    work = Path(work)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    memory, written = design.RTL / "line_memory.vhd", design.shell_files(shell)
    core = [path for path in manifest.vhdl_files(GENERATED_RTL / config) if path.name != memory.name]
    examples = [example.FOLDER / f"{name}.vhd" for name in (*example.SOURCES, "tb_example_top")]
    found = [sentence for path in (memory, *written, *examples) for sentence in layout(path)]
    found += analysis([memory], work)
    run([find_ghdl(), "-a", GHDL_STANDARD, *core], cwd=work, log=work / "core.log")
    found += analysis([*written, *examples], work)
    if not found:
        found += netlist([memory, *core, *written], generics, work)
    for sentence in found:
        say(sentence)
    return len(found)
