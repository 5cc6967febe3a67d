# SPDX-License-Identifier: Apache-2.0
"""Makes generated_rtl/NAME/ from the C++: Bambu, lowering, naming, VHDL, manifest."""

import shutil
import tempfile
import textwrap
from pathlib import Path

from ..base.tools import GENERATED_RTL, ROOT, configuration, find_stereo_hls, run
from . import bambu, manifest
from .lowering.lower import lower, state_sequence
from .lowering.naming import name_registers, read_trace
from .lowering.netlist import join_memory_slices
from .lowering.ranges import narrow_memories, narrow_registers
from .lowering.vhdl_reader import read_design
from .lowering.vhdl_writer import VhdlWriter

TRACE_ROWS = 4  # that the naming trace covers at least, so that the rules at the upper border show


def header(config, parameters, tool_run):
    size = f"{parameters['width_px']}x{parameters['height_px']}, {parameters['disparities']} disparities, {parameters['window_px']}x{parameters['window_px']} window, {parameters['pixels_per_clock']} pixel pairs a clock"
    return "\n".join(
        [
            "-- SPDX-License-Identifier: Apache-2.0",
            f"-- Stereo block-matching core, configuration {config}: {size}.",
            *_options(parameters),
            f"-- Made from hls/stereo_top.cpp by {tool_run.version} and scripts/synthesize.py. Do not edit:",
            f"--   scripts/synthesize.py --config {config}",
            "-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.",
        ]
    )


def _options(parameters):
    """Lines that name what the configuration has beyond the plain core."""
    parts = [f"{parameters['reference']} reference, {parameters['cost']} cost, {parameters['aggregation']} sums"]
    if parameters["cost"] == "census":
        parts.append(f"census {parameters['census_width_px']}x{parameters['census_height_px']}")
    if parameters["prefilter"] != "none":
        parts.append(f"prefilter {parameters['prefilter']} with cap {parameters['prefilter_cap']}")
    parts += [
        f"{text} {parameters[key]}"
        for key, text, off in (
            ("min_disparity", "lowest disparity", 0),
            ("left_right_threshold", "left/right check, threshold", -1),
            ("uniqueness_percent", "uniqueness check, percent", 0),
            ("texture_threshold", "texture check, threshold", 0),
        )
        if parameters[key] != off
    ]
    parts += [key for key in ("subpixel", "median") if parameters[key]]
    return textwrap.wrap(", ".join(parts) + ".", 110, initial_indent="-- Options: ", subsequent_indent="--   ")


def netlist_of(config, parameters, design, work):
    """The tool's design, lowered, checked against the C++ core and named after it."""
    netlist = lower(design)
    width, first_output = parameters["width_px"], parameters["groups_to_first_output"]
    groups = -(-2 * parameters["window_px"] // parameters["pixels_per_clock"])  # until every stored row holds pixels
    clocks = max(
        max(TRACE_ROWS, groups + 2) * width + first_output % width,
        first_output + parameters["latency_clocks"] + 2 * width,
    )
    narrow_memories(netlist)
    join_memory_slices(netlist)
    run([find_stereo_hls(), "trace", "--config", config, "--clocks", clocks, "--out", work], passes_errors=True)
    named = name_registers(netlist, read_trace(work / "trace.txt"))
    narrow_registers(netlist)
    return netlist, named


def generate(config, say=print, out=None):
    """Writes the folder of one configuration, all of it or nothing. Returns its manifest."""
    parameters = configuration(config)
    say(f"{config}: Bambu ...")
    tool_run = bambu.synthesize(config, parameters)
    say(f"{config}: lowering ...")
    design = read_design(tool_run.vhdl)
    netlist, named = netlist_of(config, parameters, design, tool_run.vhdl.parent)
    files = {
        "line_memory.vhd": (ROOT / "hls" / "rtl" / "line_memory.vhd").read_text(),
        "stereo_core.vhd": VhdlWriter(
            netlist, header(config, parameters, tool_run), parameters["disparity_bits"]
        ).write(),
    }
    report = dict(
        tool_run.report,
        loop_states=len(state_sequence(design)[1]),
        registers=len(netlist.registers),
        registers_named=named,
        register_bits=sum(r.value.width for r in netlist.registers),
        memory_bits=sum(m.depth * m.width for m in netlist.memories),
    )
    target = Path(out) if out else GENERATED_RTL / config
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as temporary:
        for name, text in files.items():
            (Path(temporary) / name).write_text(text)
        result = {
            "format": manifest.FORMAT,
            "configuration": config,
            "parameters": parameters,
            "sources": manifest.source_digests(),
            "files": {name: manifest.digest(Path(temporary) / name) for name in files},
            "tool": tool_run.version,
            "command": tool_run.command,
            "tool_report": report,
        }
        manifest.write(temporary, result)
        target.mkdir(exist_ok=True)
        for name in [*files, "manifest.json"]:
            shutil.move(Path(temporary) / name, target / name)
    return result
