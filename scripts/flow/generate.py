# SPDX-License-Identifier: Apache-2.0
"""Makes generated_rtl/NAME/ from the C++: Bambu, lowering, naming, VHDL, manifest."""

import shutil
import tempfile
from pathlib import Path

from . import bambu, manifest
from .rtl.lowering import lower, state_sequence
from .rtl.netlist import join_memory_slices
from .rtl.naming import name_registers, read_trace
from .rtl.ranges import narrow_memories, narrow_registers
from .rtl.vhdl_reader import read_design
from .rtl.vhdl_writer import VhdlWriter
from .tools import GENERATED_RTL, ROOT, configuration, find_stereo_hls, run

TRACE_ROWS = 4  # that the naming trace covers, so that the rules at the upper border show


def header(config, parameters, tool_run):
    size = f"{parameters['width_px']}x{parameters['height_px']}, {parameters['disparities']} disparities, {parameters['window_px']}x{parameters['window_px']} window, {parameters['pixels_per_clock']} pixel pairs a clock"
    return "\n".join([
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- Stereo block-matching core, configuration {config}: {size}.",
        f"-- Made from hls/stereo_top.cpp by {tool_run.version} and scripts/synthesize.py. Do not edit:",
        f"--   scripts/synthesize.py --config {config}",
        "-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.",
    ])


def netlist_of(config, parameters, design, work):
    """The tool's design, lowered, checked against the C++ core and named after it."""
    netlist = lower(design)
    clocks = TRACE_ROWS * parameters["width_px"]
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
        "stereo_core.vhd": VhdlWriter(netlist, header(config, parameters, tool_run), parameters["disparity_bits"]).write(),
    }
    report = dict(tool_run.report, loop_states=len(state_sequence(design)[1]), registers=len(netlist.registers), registers_named=named,
                  register_bits=sum(r.value.width for r in netlist.registers),
                  memory_bits=sum(m.depth * m.width for m in netlist.memories))
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
