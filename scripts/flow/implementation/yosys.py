# SPDX-License-Identifier: Apache-2.0
"""Area of the core on an FPGA family, by yosys."""

import json
import re
from dataclasses import dataclass
from pathlib import Path

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import find_yosys, run
from . import ecp5_netlist
from .record import Area

TOP = "stereo_core"  # of every configuration: names can move the figures
# Before each target's own script, which looks at the design module by module and turns `-1 - x` into a carry chain;
# constants folded first make it an inverter. On `tiny` this took 293 of 1,315 MISTRAL_ALUT_ARITH away; on the
# other families, with -abc9, it changes next to nothing.
GENERIC = f"hierarchy -top {TOP}; proc; flatten; opt -full"

# Cyclone V's own script folds constants of adders less well: this took another sixth of the carry cells of
# ambrosch2007.
FOLDED = f"{GENERIC}; wreduce; peepopt; opt_clean; alumacc; opt_expr -fine; opt_clean"


@dataclass(frozen=True)
class Target:
    """One FPGA family. `luts`: how many look-up tables a cell takes, by the beginning of its name."""

    name: str
    synthesis: str
    map_memories: str  # the step of the synthesis that turns memories into RAM; map_ffram makes flip-flops of the rest
    lut_name: str
    luts: dict[str, int]
    ffs: tuple[str, ...]
    block_rams: tuple[str, ...]
    device: str | None = None  # only where the result is placed and routed
    prepare: str = GENERIC


TARGETS = {
    target.name: target
    for target in (
        # A carry cell takes both LUTs of its half slice. A 16x4 RAM takes 4 LUTs in two slices for its data and the 2
        # LUTs of a third slice for its write port; nextpnr counts the same ("RAM LUTs", "RAMW LUTs"). PFUMX and L6MUX21
        # are multiplexers beside the LUTs.
        Target(
            "ecp5",
            f"synth_ecp5 -abc9 -top {TOP}",
            "map_ram",
            "LUT4",
            {"LUT4": 1, "CCU2C": 2, "TRELLIS_DPR16X4": 6},
            ("TRELLIS_FF",),
            ("DP16KD",),
            "LFE5U-85F-8BG756",
        ),
        # An inverter that is left over takes an ALUT. One MISTRAL_MLAB is 32x1 bits, the memory of one ALUT.
        Target(
            "cyclonev",
            f"synth_intel_alm -family cyclonev -top {TOP}",
            "map_bram",
            "ALUT",
            {"MISTRAL_ALUT": 1, "MISTRAL_NOT": 1, "MISTRAL_MLAB": 1},
            ("MISTRAL_FF",),
            ("MISTRAL_M10K",),
            prepare=FOLDED,
        ),
        # LUT6. CARRY4 and MUXF7/8 stand beside the LUTs. INV is counted, though a later tool may fold some of them.
        Target(
            "xc7",
            f"synth_xilinx -abc9 -family xc7 -top {TOP} -flatten",
            "map_memory",
            "LUT6",
            {"LUT": 1, "INV": 1, "RAM32M": 4, "RAM64M": 4, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1D": 4, "SRL": 1},
            ("FDRE", "FDSE", "FDCE", "FDPE"),
            ("RAMB18E1", "RAMB36E1"),
        ),
    )
}


def version() -> str:
    text = run([find_yosys(), "-V"])
    match = re.match(r"Yosys \S+", text)
    if not match:
        raise FlowError("yosys -V does not say its version as yosys does", EXIT_TOOL_FAILED)
    return match.group()


def script(target: Target) -> str:
    """The commands: synthesis with two looks at the memories that are not mapped yet, before and after their
    mapping."""
    synthesis = target.synthesis
    # Only nextpnr reads a netlist.
    netlist = "; write_json netlist.json" if target.device else ""
    lines = [
        f"read_verilog {TOP}.v",
        target.prepare,
        f"{synthesis} -run begin:{target.map_memories}",
        "tee -q -o memories.txt dump t:$mem_v2",
        f"{synthesis} -run {target.map_memories}:map_ffram",
        "tee -q -o unmapped.txt dump t:$mem_v2",
        f"{synthesis} -run map_ffram:",
        f"tee -q -o stat.json stat -json{netlist}",
    ]
    return "\n".join(lines) + "\n"


def synthesize(target: Target, verilog: str, work: Path) -> tuple[Area, list[str]]:
    """Runs yosys in the folder `work`. Returns the area, and the names of memories that became flip-flops."""
    (work / f"{TOP}.v").write_text(verilog)
    (work / "synthesis.ys").write_text(script(target))
    run([find_yosys(), "-s", "synthesis.ys"], cwd=work, log=work / "yosys.log")
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
