# SPDX-License-Identifier: Apache-2.0
"""Makes the VHDL of a configuration from the C++: Bambu, lowering, naming, VHDL, manifest."""

from __future__ import annotations

import shutil
import tempfile
import textwrap
from collections.abc import Callable
from pathlib import Path

from ..base import rtl
from ..base.configurations import Configuration, configuration, designs, option, parameters_of
from ..base.tools import find_stereo_hls, run
from . import bambu, manifest, sources
from .lowering.control import state_sequence
from .lowering.lower import lower
from .lowering.naming import Trace, count_named, read_trace
from .lowering.passes import run_passes
from .lowering.vhdl_reader import read_design
from .lowering.vhdl_writer import Entity, VhdlWriter
from .structure import structure_digest

# Every stored row holds pixels of the frame, and rules at the upper border show: so many rows of groups beyond those
# that the first output waits for.
TRACE_ROWS = 4


def header(config: str, row: Configuration, tool: str) -> str:
    """`tool`: its name and version."""
    family, kind = row["family"].replace("_", " "), rtl.kind_of(row)
    pairs = row["pixels_per_clock"]
    what = f"{row['description']}, {pairs} pixel pair{'s' if pairs > 1 else ''} a clock"
    options = ", ".join(row["options"]) or "none"
    return "\n".join(
        [
            "-- SPDX-License-Identifier: Apache-2.0",
            f"-- {kind.title}, {family}, configuration {config}: {what}.",
            *textwrap.wrap(options + ".", 110, initial_indent="-- Options: ", subsequent_indent="--   "),
            f"-- Made from {kind.top} by {tool} and scripts/synthesize.py. Do not edit:",
            f"--   scripts/synthesize.py --config {config}",
            "-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.",
        ]
    )


def _cpp_trace(config: str, row: Configuration, work: Path) -> Trace:
    """What the registers of the C++ core hold, over as many clocks as tell them apart."""
    # The first output is that of a window's centre: as many rows again stand below it. A fifth of the clocks are
    # bubbles.
    groups = 2 * row["groups_to_first_output"] + TRACE_ROWS * row["width_px"]
    clocks = row["latency_clocks"] + groups * 5 // 4
    run([find_stereo_hls(), "trace", "--config", config, "--clocks", clocks, "--out", work], passes_errors=True)
    return read_trace(work / "trace.txt")


def generate(config: str, out: Path, say: Callable[[str], None] = print) -> manifest.Manifest:
    """Writes the VHDL and the manifest of one configuration into a folder, both or nothing. Returns the manifest."""
    row = configuration(config, designs())
    kind = rtl.kind_of(row)
    say(f"{config}: Bambu ...")
    tool_run = bambu.synthesize(config, row)
    say(f"{config}: lowering ...")
    design = read_design(tool_run.vhdl)
    entity = Entity(kind.entity(config), {name: option(row, name) for name in kind.generics}, kind)
    netlist = lower(design, kind, {port.name: entity.bits(port) for port in kind.ports if not port.is_flag})
    trace = _cpp_trace(config, row, tool_run.vhdl.parent)
    run_passes(netlist, design, trace)
    text = VhdlWriter(netlist, header(config, row, tool_run.version), entity).write()
    report: manifest.ToolReport = {
        **tool_run.report,
        "loop_states": len(state_sequence(design)[1]),
        "registers": len(netlist.registers),
        "registers_named": count_named(netlist),
        "register_bits": sum(r.value.width for r in netlist.registers),
        "memory_bits": sum(m.depth * m.width for m in netlist.memories),
    }
    return _write(out, config, row, text, tool_run, report)


def _write(
    target: Path, config: str, row: Configuration, text: str, tool_run: bambu.ToolRun, report: manifest.ToolReport
) -> manifest.Manifest:
    """VHDL and manifest together, or nothing."""
    file = f"{rtl.kind_of(row).entity(config)}.vhd"
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as name:
        temporary = Path(name)
        (temporary / file).write_text(text)
        result: manifest.Manifest = {
            "format": manifest.FORMAT,
            "configuration": config,
            "use": row["use"],
            "parameters": parameters_of(row),
            "sources": manifest.source_digests(row),
            "code": sources.code(manifest.compiler_options(config, row)),
            "cells": manifest.cell_digests(),
            "files": {file: manifest.digest(temporary / file)},
            "structure": structure_digest(text),
            "tool": tool_run.version,
            "command": tool_run.command,
            "tool_report": report,
        }
        manifest.write(temporary, result)
        target.mkdir(exist_ok=True)
        for made in (file, "manifest.json"):
            shutil.move(temporary / made, target / made)
    return result
