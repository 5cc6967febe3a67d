# SPDX-License-Identifier: Apache-2.0
"""Area of the core on an FPGA family, by yosys."""

import json
import os
import re
from pathlib import Path
from typing import Any

from ..base import venv
from ..base.configurations import configuration
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Say, Word, find_tool, run
from . import ecp5_netlist
from .record import Area
from .targets import REQUIREMENTS, TOP, Target

PACKAGE = "pyosys"
PROGRAM = Path(__file__).with_name("yosys_program.py")


def find_yosys(say: Say = print) -> list[Word]:
    """The command: YOSYS if set, else the pinned one, which is installed when it is not there yet."""
    if os.environ.get("YOSYS"):
        return [find_tool("yosys", "YOSYS")]
    return [venv.ensure("venv", REQUIREMENTS, PACKAGE, say) / "python3", "-P", PROGRAM]


def version() -> str:
    text = run([*find_yosys(), "-V"])
    match = re.match(r"Yosys \S+", text)
    if not match:
        raise FlowError("yosys -V prints no version", EXIT_TOOL_FAILED)
    return match.group() if os.environ.get("YOSYS") else f"{match.group()} ({venv.pinned(REQUIREMENTS, PACKAGE)})"


# The memories of the cell line_memory.vhd, as ghdl names them. Some cores look at no word that is read in the clock in
# which it is written (test_memory_collisions.py): without a bypass around the RAM, its output register is the RAM's own.
LINE_MEMORIES = "*column_n*_memory"
def memories_without_bypass(config: str, core: str = "") -> str:
    """For `script`, of the core of that configuration; `core`: what the names begin with that stand in it."""
    return f"m:{core}{LINE_MEMORIES}" if looks_at_no_word_being_written(configuration(config)) else ""


def looks_at_no_word_being_written(row: dict[str, Any]) -> bool:
    return row["family"] == "block_matching" or (row["family"] == "semi_global" and row["clocks_per_pixel"] > 1)


def script(target: Target, without_bypass: str = "") -> str:
    """The commands: synthesis with two looks at the memories that are not mapped yet, before and after their
    mapping. without_bypass: memories of which no word counts that is read in the clock in which it is written."""
    synthesis = target.synthesis
    # Only nextpnr reads a netlist.
    netlist = "; write_json netlist.json" if target.device else ""
    lines = [
        f"read_verilog {TOP}.v",
        target.prepare,
        *([f"setattr -set no_rw_check 1 {without_bypass}"] if without_bypass else []),
        f"{synthesis} -run begin:{target.map_memories}",
        "tee -q -o memories.txt dump t:$mem_v2",
        f"{synthesis} -run {target.map_memories}:map_ffram",
        "tee -q -o unmapped.txt dump t:$mem_v2",
        f"{synthesis} -run map_ffram:",
        f"tee -q -o stat.json stat -json{netlist}",
    ]
    return "\n".join(lines) + "\n"


def synthesize(target: Target, verilog: str, work: Path, without_bypass: str = "") -> tuple[Area, list[str]]:
    """Runs yosys in the folder `work`. Returns the area, and the names of memories that became flip-flops."""
    (work / f"{TOP}.v").write_text(verilog)
    (work / "synthesis.ys").write_text(script(target, without_bypass))
    run([*find_yosys(), "-s", "synthesis.ys"], cwd=work, log=work / "yosys.log")
    try:
        cells = json.loads((work / "stat.json").read_text())["modules"]["\\" + TOP]["num_cells_by_type"]
        memories = read_memories((work / "memories.txt").read_text())
        lost = read_memories((work / "unmapped.txt").read_text())
        if target.device:
            change = ecp5_netlist.improve(work / "netlist.json", TOP)
            cells = {n: count for n in cells if (count := cells[n] + change.get(n, 0))}
    except (OSError, ValueError, KeyError) as error:
        raise FlowError(
            f"yosys wrote no usable statistics ({error}); see {work / 'yosys.log'}", EXIT_TOOL_FAILED
        ) from None
    # Those with a $ say where instances were, no more.
    cells = {name: count for name, count in cells.items() if not name.startswith("$")}
    return area(target, cells, sum(memories.values()), bool(lost)), sorted(lost)


def area(target: Target, cells: dict[str, int], memory_bits: int, memory_in_flip_flops: bool) -> Area:
    def total(weights: dict[str, int]) -> int:
        # The longest beginning that fits counts: MISTRAL_ALUT also stands for MISTRAL_ALUT2 ... 6 and _ARITH.
        return sum(
            count * weight
            for name, count in cells.items()
            for start, weight in weights.items()
            if name.startswith(start)
        )

    found: Area = {
        "ffs": total(dict.fromkeys(target.ffs, 1)),
        "memory_bits": memory_bits,
        "block_rams": total(dict.fromkeys(target.block_rams, 1)),
        "memory_in_flip_flops": memory_in_flip_flops,
        "cells": dict(sorted(cells.items())),
    }
    found["aluts" if target.lut_name == "ALUT" else "luts"] = total(target.luts)
    return found


def read_memories(dump: str) -> dict[str, int]:
    """{name: bits} of the memories in a dump of $mem_v2 cells; ValueError where one has no size."""
    found = {}
    for cell in re.split(r"^  cell \$mem_v2 ", dump, flags=re.MULTILINE)[1:]:
        name = cell.split(None, 1)[0].removeprefix("\\")
        found[name] = _parameter(cell, "SIZE") * _parameter(cell, "WIDTH")
    return found


def _parameter(cell: str, key: str) -> int:
    match = re.search(rf"parameter (?:signed )?\\{key} (\d+)$", cell, re.MULTILINE)
    if match is None:
        raise ValueError(f"a memory has no {key}")
    return int(match.group(1))
