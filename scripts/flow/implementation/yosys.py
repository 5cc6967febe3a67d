# SPDX-License-Identifier: Apache-2.0
"""Area of the core on an FPGA family, by yosys."""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base import venv
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Say, Word, find_tool, run
from . import pins
from .families.family import TOP, Family, RoutedFamily
from .record import Area
from .targets import ECP5

PACKAGE = "pyosys"
REQUIREMENTS = ECP5.requirements
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
# which it is written (test_memory_collisions.py): without a bypass around a RAM, its output register is the RAM's own.
LINE_MEMORIES = "*column_n*_memory"


def memories_without_bypass(parameters: Mapping[str, Any], core: str = "") -> str:
    """For `script`, of a core with those parameters in its manifest; `core`: what the names begin with that stand in
    it."""
    return f"m:{core}{LINE_MEMORIES}" if looks_at_no_word_being_written(parameters) else ""


def looks_at_no_word_being_written(parameters: Mapping[str, Any]) -> bool:
    family = parameters.get("family")  # a stage in front of a core has none
    return family == "block_matching" or (family == "semi_global" and parameters["clocks_per_pixel"] > 1)


def top(family: Family) -> str:
    return pins.ENTITY if isinstance(family, RoutedFamily) and family.few_pins else TOP


def command(family: Family) -> str:
    """yosys's, for a design of the family."""
    return _of_top(family, family.synthesis)


def _of_top(family: Family, commands: str) -> str:
    return commands.replace(f"-top {TOP}", f"-top {top(family)}")


def script(family: Family, without_bypass: str = "") -> str:
    """The commands: synthesis with two looks at the memories that are not mapped yet, before and after their
    mapping. without_bypass: memories of which no word counts that is read in the clock in which it is written."""
    synthesis = command(family)
    # A core between registers stays a module of its own until it is counted.
    apart = top(family) != TOP
    lines = [
        f"read_verilog {TOP}.v",
        *([f"setattr -mod -set keep_hierarchy 1 {TOP}"] if apart else []),
        _of_top(family, family.prepare),
        *([f"setattr -set no_rw_check 1 {without_bypass}"] if without_bypass else []),
        f"{synthesis} -run begin:{family.map_memories}",
        "tee -q -o memories.txt dump t:$mem_v2",
        f"{synthesis} -run {family.map_memories}:map_ffram",
        "tee -q -o unmapped.txt dump t:$mem_v2",
        f"{synthesis} -run map_ffram:",
    ]
    # Only nextpnr reads a netlist.
    netlist = "; write_json netlist.json" if isinstance(family, RoutedFamily) else ""
    if apart and isinstance(family, RoutedFamily):
        lines.append("tee -q -o stat.json stat -json")
        lines.append(f"setattr -mod -unset keep_hierarchy {TOP}; flatten; opt_clean")
        lines.append(f"{family.buffers or 'opt_clean'}{netlist}")
    else:
        lines.append(f"tee -q -o stat.json stat -json{netlist}")
    return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Synthesis:
    """What yosys made of a design."""

    area: Area
    lost: list[str]  # memories that became flip-flops and should not
    around: dict[str, int]  # {"luts": ..., "ffs": ...} of the registers around a core; none where there are none


def synthesize(family: Family, verilog: str, work: Path, without_bypass: str = "") -> Synthesis:
    """Runs yosys in the folder `work`."""
    apart = top(family) != TOP
    (work / f"{TOP}.v").write_text(verilog + pins.around(verilog) if apart else verilog)
    (work / "synthesis.ys").write_text(script(family, without_bypass))
    run([*find_yosys(), "-s", "synthesis.ys"], cwd=work, log=work / "yosys.log")
    try:
        modules = json.loads((work / "stat.json").read_text())["modules"]
        cells = modules["\\" + TOP]["num_cells_by_type"]
        around = _area(family, modules["\\" + pins.ENTITY]["num_cells_by_type"]) if apart else {}
        memories = read_memories((work / "memories.txt").read_text())
        unmapped = read_memories((work / "unmapped.txt").read_text())
        if isinstance(family, RoutedFamily):
            change = _improve(family, work / "netlist.json")
            cells = {n: count for n in cells if (count := cells[n] + change.get(n, 0))}
    except (OSError, ValueError, KeyError) as error:
        raise FlowError(
            f"yosys wrote no usable statistics ({error}); see {work / 'yosys.log'}", EXIT_TOOL_FAILED
        ) from None
    # Those with a $ say where instances were, no more.
    cells = {name: count for name, count in cells.items() if not name.startswith("$")}
    return Synthesis(area(family, cells, memories, unmapped), sorted(_lost(family, unmapped)), around)


def _improve(family: RoutedFamily, path: Path) -> dict[str, int]:
    """Rewrites the netlist. Returns {cell type: how many more it has}."""
    netlist = json.loads(path.read_text())
    module = netlist["modules"][top(family)]
    before = _types(module)
    family.improve(module)
    path.write_text(json.dumps(netlist))
    after = _types(module)
    return {name: after[name] - before[name] for name in before}


def _types(module: dict[str, Any]) -> Counter[str]:
    return Counter(cell["type"] for cell in module["cells"].values())


def _area(family: Family, cells: dict[str, int]) -> dict[str, int]:
    def total(weights: dict[str, int]) -> int:
        # The longest beginning that fits counts: MISTRAL_ALUT also stands for MISTRAL_ALUT2 ... 6 and _ARITH.
        return sum(
            count * weight
            for name, count in cells.items()
            for start, weight in weights.items()
            if name.startswith(start)
        )

    return {"luts": total(family.luts), "ffs": total(dict.fromkeys(family.ffs, 1))}


def _lost(family: Family, unmapped: dict[str, int]) -> dict[str, int]:
    return {name: bits for name, bits in unmapped.items() if bits > family.most_bits_in_flip_flops}


def area(family: Family, cells: dict[str, int], memories: dict[str, int], unmapped: dict[str, int]) -> Area:
    """`memories`: {name: bits}, of which those `unmapped` became flip-flops."""
    counted = _area(family, cells)
    found: Area = {
        "ffs": counted["ffs"],
        "memory_bits": sum(memories.values()),
        "block_rams": sum(count for name, count in cells.items() if name.startswith(family.block_rams)),
        "memory_in_flip_flops": bool(_lost(family, unmapped)),
        "cells": dict(sorted(cells.items())),
    }
    if family.most_bits_in_flip_flops:
        found["small_memory_bits"] = sum(unmapped.values()) - sum(_lost(family, unmapped).values())
        found["memory_bits"] -= found["small_memory_bits"]
    found["aluts" if family.lut_name == "ALUT" else "luts"] = counted["luts"]
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
