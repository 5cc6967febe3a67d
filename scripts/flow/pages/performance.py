# SPDX-License-Identifier: Apache-2.0
"""docs/performance.md: tables made from committed files only, so that anyone gets the same page."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from ..base import committed
from ..base.markdown import UNKNOWN, code, number, table
from ..base.tools import ROOT
from ..cosim.record import Run
from ..implementation import figures
from ..implementation.results import Configuration
from ..implementation.targets import ECP5, ROUTED, TARGETS, USUAL, Target
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
        devices=device_table(),
        shell=shell_table(Configuration(name, stale_is_none=True) for name in with_use("paper", "tiny", "system")),
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
        for name in USUAL:
            result = c.targets.get(name)
            values = [UNKNOWN] * 4
            if result:
                luts = f"{number(figures.lut_count(result))} {TARGETS[name].family.lut_name}"
                values = [luts, number(result.get("lut_sites")), number(result["ffs"]), number(result["block_rams"])]
            rows.append([code(c.name), name, *values, code(f"scripts/implement.py --config {c.name} --target {name}")])
    head = ["configuration", "family", "look-up tables", "LUT sites, routed", "flip-flops", "block RAMs", "printed by"]
    return table(head, rows)


def speed_table(configurations: Iterable[Configuration]) -> str:
    head = ["configuration", "device", "MHz", "of", "MHz, best seed", "frames a second", "Mde/s", "Mde/s, outputs only"]
    head += ["thousand evaluations/s per LUT", "slowest path", "printed by"]
    rows = []
    for c in configurations:
        for target in ROUTED:
            if TARGETS[target].family is not ECP5:
                continue
            clock, values = c.clock(target), [UNKNOWN] * 8
            if clock:
                values = [
                    number(clock["median"], 1),
                    clock["of"],
                    number(clock["best"], 1),
                    number(clock["frames_per_second"]),
                    number(clock["mde_per_second"]),
                    number(clock["output_mde_per_second"]),
                    number(clock["evaluations_per_second_per_lut"] / 1e3),
                    f"{code(clock['path']['from'])} to {code(clock['path']['to'])}",
                ]
            elif target != "ecp5":
                continue
            command = f"scripts/implement.py --config {c.name} --target {target}"
            rows.append([code(c.name), TARGETS[target].short, *values, code(command)])
    return table(head, rows)


def device_table(configurations: Iterable[Configuration] | None = None) -> str:
    """Clock and area on the devices of other families than ECP5, by device; of all configurations that were tried
    there, or of some."""
    if configurations is None:
        configurations = [Configuration(name, stale_is_none=True) for name in committed.known_configurations()]
    shown = list(configurations)
    head = ["device", "configuration", "size", "MHz", "of", "frames a second", "look-up tables", "LUT sites, routed"]
    head += ["flip-flops", "block RAMs", "slowest path", "printed by"]
    others = [target for target in (TARGETS[name] for name in ROUTED) if target.family is not ECP5]
    rows = [_device_row(target, c) for target in others for c in shown if target.name in c.targets]
    return table(head, rows) if rows else "Not measured yet."


def _device_row(target: Target, c: Configuration) -> list[str]:
    result, clock = c.targets[target.name], c.clock(target.name)
    if clock:
        speed = [number(clock["median"], 1), clock["of"], number(clock["frames_per_second"])]
        path = f"{code(clock['path']['from'])} to {code(clock['path']['to'])}"
    else:
        speed = [UNKNOWN, f"does not fit: {figures.overfull(result.get('does_not_fit', {}))}", UNKNOWN]
        path = UNKNOWN
    return [
        target.short,
        code(c.name),
        c.size(),
        *speed,
        f"{number(figures.lut_count(result))} {target.family.lut_name}",
        number(result.get("lut_sites")),
        number(result["ffs"]),
        number(result["block_rams"]),
        path,
        code(f"scripts/implement.py --config {c.name} --target {target.name}"),
    ]


def shell_table(configurations: Iterable[Configuration]) -> str:
    """The core alone and in its AXI shell, where both were routed."""
    head = ["configuration", "device", "MHz, core", "of", "MHz, shell", "of", "shell to core", "frames a second, core"]
    head += ["frames a second, shell", "LUT4, core", "LUT4, shell", "printed by"]
    rows = []
    for c in configurations:
        for target in ROUTED:
            core, shell = c.clock(target), c.clock(target, shell=True)
            if not core or not shell:
                continue
            rows.append(
                [
                    code(c.name),
                    TARGETS[target].short,
                    number(core["median"], 1),
                    core["of"],
                    number(shell["median"], 1),
                    shell["of"],
                    f"{100 * shell['median'] / core['median']:.0f} %",
                    number(core["frames_per_second"]),
                    number(shell["frames_per_second"]),
                    number(figures.lut_count(c.targets[target])),
                    number(figures.lut_count(c.shell_targets[target])),
                    code(f"scripts/implement.py --config {c.name} --shell --target {target}"),
                ]
            )
    return table(head, rows) if rows else "Not measured yet."


def routed_configurations() -> list[Configuration]:
    """All with a clock on ECP5, grade 8."""
    every = (Configuration(name, stale_is_none=True) for name in committed.known_configurations())
    return [c for c in every if c.clock()]


def one_number_table(configurations: Iterable[Configuration]) -> str:
    """One number for all: evaluations a second per LUT, W*H*D each frame."""
    head = ["configuration", "MHz", "of", "LUT4", "LUT sites", "evaluations/s per LUT", "outputs only"]
    rows = []
    for c in configurations:
        clock, area = c.clock(), c.targets["ecp5"]
        if not clock:
            continue
        luts = figures.lut_count(area)
        rows.append(
            [
                code(c.name),
                number(clock["median"], 1),
                clock["of"],
                number(luts),
                number(area["lut_sites"]),
                number(clock["evaluations_per_second_per_lut"]),
                number(clock["output_mde_per_second"] * 1e6 / luts),
            ]
        )
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
    head += ["register bits", "memory bits", "compared in GHDL", "compared in Verilator", "LUT4", "LUT sites", "ALUTs"]
    head += ["frames a second on ECP5", "of"]
    rows = []
    for system in SYSTEMS:
        name, fps = system.configuration, system.frames_per_second
        start = [system.name, system.platform, system.point, UNKNOWN if fps is None else f"{fps:g}", system.source]
        start.append(code(name) if name else "not done yet")
        if name is None or name not in committed.known_configurations():
            rows.append([*start, *[UNKNOWN] * 10])
            continue
        c = make(name)
        area, clock = c.targets.get("ecp5"), c.clock()
        rows.append(
            [
                *start,
                number(figures.clocks_per_frame(c.parameters)),
                number(c.manifest["tool_report"]["register_bits"]),
                number(c.manifest["tool_report"]["memory_bits"]),
                *(compared(c.cosimulations.get(simulator)) for simulator in ("ghdl", "verilator")),
                number(figures.lut_count(area)) if area else UNKNOWN,
                number(area.get("lut_sites")) if area else UNKNOWN,
                _aluts(c),
                figures.overfull(area["does_not_fit"]) if area and "does_not_fit" in area else _routed_speed(c)[0],
                clock["of"] if clock else "does not fit" if area and "does_not_fit" in area else UNKNOWN,
            ]
        )
    return head, rows
