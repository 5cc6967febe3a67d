# SPDX-License-Identifier: Apache-2.0
"""Makes generated_rtl/NAME/ from the C++: Bambu, lowering, naming, VHDL, manifest."""

import shutil
import tempfile
import textwrap
from collections.abc import Callable
from pathlib import Path

from ..base.configurations import Parameters, configuration
from ..base.tools import GENERATED_RTL, ROOT, find_stereo_hls, run
from . import bambu, manifest
from .lowering.control import state_sequence
from .lowering.lower import lower
from .lowering.naming import Trace, count_named, read_trace
from .lowering.passes import run_passes
from .lowering.vhdl_reader import read_design
from .lowering.vhdl_writer import VhdlWriter

TRACE_ROWS = 4  # that the naming trace covers at least, so that the rules at the upper border show


def header(config: str, parameters: Parameters, tool: str) -> str:
    """`tool`: its name and version."""
    window = parameters["window_px"]
    size = (
        f"{parameters['width_px']}x{parameters['height_px']}, {parameters['disparities']} disparities, "
        f"{window}x{window} window, {parameters['pixels_per_clock']} pixel pairs a clock"
    )
    return "\n".join(
        [
            "-- SPDX-License-Identifier: Apache-2.0",
            f"-- Stereo block-matching core, configuration {config}: {size}.",
            *_options(parameters),
            f"-- Made from hls/stereo_top.cpp by {tool} and scripts/synthesize.py. Do not edit:",
            f"--   scripts/synthesize.py --config {config}",
            "-- Names are those of the C++ core: BLOCK_MEMBER_INDEX, blocks in data-flow order.",
        ]
    )


def _options(parameters: Parameters) -> list[str]:
    """Lines that name what the configuration has beyond the plain core."""
    parts = [f"{parameters['reference']} reference, {parameters['cost']} cost, {parameters['aggregation']} sums"]
    if parameters["cost"] == "census":
        parts.append(f"census {parameters['census_width_px']}x{parameters['census_height_px']}")
    if parameters["prefilter"] != "none":
        parts.append(f"prefilter {parameters['prefilter']} with cap {parameters['prefilter_cap']}")
    if parameters["min_disparity"] != 0:
        parts.append(f"lowest disparity {parameters['min_disparity']}")
    if parameters["left_right_threshold"] != -1:
        parts.append(f"left/right check, threshold {parameters['left_right_threshold']}")
    if parameters["uniqueness_percent"] != 0:
        parts.append(f"uniqueness check, percent {parameters['uniqueness_percent']}")
    if parameters["texture_threshold"] != 0:
        parts.append(f"texture check, threshold {parameters['texture_threshold']}")
    if parameters["subpixel"]:
        parts.append("subpixel")
    if parameters["median"]:
        parts.append("median")
    return textwrap.wrap(", ".join(parts) + ".", 110, initial_indent="-- Options: ", subsequent_indent="--   ")


def _cpp_trace(config: str, parameters: Parameters, work: Path) -> Trace:
    """What the registers of the C++ core hold, over as many clocks as tell them apart."""
    width, first_output = parameters["width_px"], parameters["groups_to_first_output"]
    groups = -(-2 * parameters["window_px"] // parameters["pixels_per_clock"])  # until every stored row holds pixels
    clocks = max(
        max(TRACE_ROWS, groups + 2) * width + first_output % width,
        first_output + parameters["latency_clocks"] + 2 * width,
    )
    run([find_stereo_hls(), "trace", "--config", config, "--clocks", clocks, "--out", work], passes_errors=True)
    return read_trace(work / "trace.txt")


def generate(config: str, say: Callable[[str], None] = print, out: Path | None = None) -> manifest.Manifest:
    """Writes the folder of one configuration, all of it or nothing. Returns its manifest."""
    parameters = configuration(config)
    say(f"{config}: Bambu ...")
    tool_run = bambu.synthesize(config, parameters)
    say(f"{config}: lowering ...")
    design = read_design(tool_run.vhdl)
    netlist = lower(design)
    trace = _cpp_trace(config, parameters, tool_run.vhdl.parent)
    run_passes(netlist, design, trace)
    text = VhdlWriter(netlist, header(config, parameters, tool_run.version), parameters["disparity_bits"]).write()
    report: manifest.ToolReport = {
        **tool_run.report,
        "loop_states": len(state_sequence(design)[1]),
        "registers": len(netlist.registers),
        "registers_named": count_named(netlist, trace),
        "register_bits": sum(r.value.width for r in netlist.registers),
        "memory_bits": sum(m.depth * m.width for m in netlist.memories),
    }
    files = {"line_memory.vhd": (ROOT / "hls" / "rtl" / "line_memory.vhd").read_text(), "stereo_core.vhd": text}
    return _write(out or GENERATED_RTL / config, config, parameters, files, tool_run, report)


def _write(
    target: Path,
    config: str,
    parameters: Parameters,
    files: dict[str, str],
    tool_run: bambu.ToolRun,
    report: manifest.ToolReport,
) -> manifest.Manifest:
    """Files and manifest together, or nothing."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=target.parent) as name:
        temporary = Path(name)
        for file, text in files.items():
            (temporary / file).write_text(text)
        result: manifest.Manifest = {
            "format": manifest.FORMAT,
            "configuration": config,
            "parameters": parameters,
            "sources": manifest.source_digests(),
            "files": {file: manifest.digest(temporary / file) for file in files},
            "tool": tool_run.version,
            "command": tool_run.command,
            "tool_report": report,
        }
        manifest.write(temporary, result)
        target.mkdir(exist_ok=True)
        for file in [*files, "manifest.json"]:
            shutil.move(temporary / file, target / file)
    return result
