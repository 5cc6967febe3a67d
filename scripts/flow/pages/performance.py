# SPDX-License-Identifier: Apache-2.0
"""docs/performance.md: tables made from committed files only, so that anyone gets the same page."""

from collections.abc import Callable, Iterable
from pathlib import Path

from ..base import rtl
from ..base.markdown import UNKNOWN, code, number, table
from ..base.tools import ROOT
from ..cosim.record import Run
from ..implementation import figures
from ..implementation.results import Configuration
from ..implementation.yosys import TARGETS
from ..synthesis.manifest import with_use
from .published import PAPER, PUBLISHED, SYSTEMS

PAGE = ROOT / "docs" / "performance.md"
TEXT = Path(__file__).parent / "texts" / "performance.md"

Grid = tuple[list[str], list[list[str]]]  # (head, rows)


def page() -> str:
    """The paper's core and its small twins; the others have pages of their own."""
    shown = [Configuration(name) for name in with_use("paper", "tiny")]
    return TEXT.read_text().format(
        per_clock=per_clock_table(shown),
        speed=speed_table(shown),
        area=area_table(shown),
        comparison=table(*comparison(shown)),
        systems=table(*systems()),
    )


def per_clock_table(configurations: Iterable[Configuration]) -> str:
    head = ["configuration", "size", "clocks a frame", "latency, clocks", "evaluations a clock"]
    head += ["register bits", "memory bits", "printed by"]
    rows = [
        [
            code(c.name),
            c.size(),
            number(figures.clocks_per_frame(c.parameters)),
            number(c.parameters["latency_clocks"]),
            number(figures.evaluations_per_clock(c.parameters)),
            number(c.manifest["tool_report"]["register_bits"]),
            number(c.manifest["tool_report"]["memory_bits"]),
            code(f"scripts/performance.py --config {c.name}"),
        ]
        for c in configurations
    ]
    return table(head, rows)


def area_table(configurations: Iterable[Configuration]) -> str:
    rows = []
    for c in configurations:
        for name in TARGETS:
            result = c.targets.get(name)
            values = [UNKNOWN] * 3
            if result:
                luts = f"{number(figures.lut_count(result))} {TARGETS[name].lut_name}"
                values = [luts, number(result["ffs"]), number(result["block_rams"])]
            rows.append([code(c.name), name, *values, code(f"scripts/implement.py --config {c.name} --target {name}")])
    return table(["configuration", "family", "look-up tables", "flip-flops", "block RAMs", "printed by"], rows)


def speed_table(configurations: Iterable[Configuration]) -> str:
    head = ["configuration", "MHz, median", "MHz, best seed", "frames a second", "Mde/s"]
    head += ["thousand evaluations/s per LUT", "slowest path", "printed by"]
    rows = []
    for c in configurations:
        clock, values = c.clock(), [UNKNOWN] * 6
        if clock:
            values = [
                number(clock["median"], 1),
                number(clock["best"], 1),
                number(clock["frames_per_second"]),
                number(clock["mde_per_second"]),
                number(clock["evaluations_per_second_per_lut"] / 1e3),
                f"{code(clock['path']['from'])} to {code(clock['path']['to'])}",
            ]
        rows.append([code(c.name), *values, code(f"scripts/implement.py --config {c.name} --target ecp5")])
    return table(head, rows)


def comparison(configurations: Iterable[Configuration]) -> Grid:
    """The published systems, and those of the configurations that have the paper's size."""
    head = [
        "system",
        "clocks a frame",
        "evaluations a clock",
        "frames a second",
        "Mde/s",
        "ALUTs",
        "memory bits",
        "from",
    ]
    evaluations = figures.evaluations_per_frame(PAPER)
    rows = []
    for other in PUBLISHED:
        clocks, fps = other.clocks_per_frame, other.frames_per_second
        speed = other.mde_per_second or (fps and fps * evaluations / 1e6)
        rows.append(
            [
                other.system,
                number(clocks),
                number(clocks and evaluations / clocks, 1),
                number(fps),
                number(speed),
                number(other.aluts),
                number(other.memory_bits),
                other.source,
            ]
        )
    for c in configurations:
        if not c.has(PAPER):
            continue
        rows.append(
            [
                f"this core, {code(c.name)}",
                number(figures.clocks_per_frame(c.parameters)),
                number(figures.evaluations_per_clock(c.parameters), 1),
                *_routed_speed(c),
                _aluts(c),
                number(c.manifest["tool_report"]["memory_bits"]),
                code(f"scripts/implement.py --config {c.name}"),
            ]
        )
    return head, rows


def _routed_speed(c: Configuration) -> tuple[str, str]:
    """(frames a second, million evaluations a second) on ECP5."""
    clock = c.clock()
    if not clock:
        return UNKNOWN, UNKNOWN
    return number(clock["frames_per_second"]), number(clock["mde_per_second"])


def _aluts(c: Configuration) -> str:
    cyclone = c.targets.get("cyclonev")
    return number(cyclone["aluts"]) if cyclone else UNKNOWN


def compared(run: Run | None) -> str:
    """Of one simulator, as cosim.record keeps it."""
    return UNKNOWN if run is None else f"{run['compared']:,} of {run['expected']:,}, {run['mismatches']:,} differ"


def systems(make: Callable[[str], Configuration] = Configuration) -> Grid:
    """The systems that the paper compares itself with, and this core as they were. `make`: configuration of a name."""
    head = ["system", "platform", "point", "its frames a second", "published in", "this core", "clocks a frame"]
    head += ["register bits", "memory bits", "compared in GHDL", "compared in Verilator", "LUT4", "ALUTs"]
    head.append("frames a second on ECP5")
    rows = []
    for system in SYSTEMS:
        name, fps = system.configuration, system.frames_per_second
        start = [system.name, system.platform, system.point, UNKNOWN if fps is None else f"{fps:g}", system.source]
        start.append(code(name) if name else "not done yet")
        if name is None or name not in rtl.known_configurations():
            rows.append([*start, *[UNKNOWN] * 8])
            continue
        c = make(name)
        area = c.targets.get("ecp5")
        rows.append(
            [
                *start,
                number(figures.clocks_per_frame(c.parameters)),
                number(c.manifest["tool_report"]["register_bits"]),
                number(c.manifest["tool_report"]["memory_bits"]),
                *(compared(c.cosimulations.get(simulator)) for simulator in ("ghdl", "verilator")),
                number(figures.lut_count(area)) if area else UNKNOWN,
                _aluts(c),
                _routed_speed(c)[0],
            ]
        )
    return head, rows
