# SPDX-License-Identifier: Apache-2.0
"""docs/features.md: what each option of the algorithm and of the pipeline costs, from committed files only."""

from __future__ import annotations

from pathlib import Path

from ..base import committed, rtl
from ..base.configurations import clocks_per_pixel, option
from ..base.markdown import UNKNOWN, code, number, table
from ..base.tools import ROOT
from ..implementation import figures
from ..implementation.record import Result
from ..implementation.results import Configuration

PAGE = ROOT / "docs" / "features.md"
TEXT = Path(__file__).parent / "texts" / "features.md"
BASE = "study"

# What stands in the table, in its order: (heading of the group, [(configuration, what it has)])
OPTIONS = [
    ("the plain core", [("study", "5x5 SAD, right reference, direct sums")]),
    ("pixel pairs a clock", [("study_p2", "P = 2"), ("study_p4", "P = 4")]),
    ("window, direct sums", [("study_w3", "3x3"), ("study_w7", "7x7"), ("study_w9", "9x9")]),
    (
        "window, recursive sums",
        [
            ("study_w3_recursive", "3x3"),
            ("study_recursive", "5x5"),
            ("study_w7_recursive", "7x7"),
            ("study_w9_recursive", "9x9"),
            ("study_w15_recursive", "15x15"),
            ("study_w21_recursive", "21x21"),
        ],
    ),
    ("images", [("study_left", "left reference"), ("study_min8", "min_disparity 8")]),
    ("bits of a pixel", [("study_10bit", "10"), ("study_12bit", "12")]),
    ("cost", [("study_ssd", "SSD"), ("study_census", "census 5x5")]),
    ("prefilter", [("study_xsobel", "x-Sobel")]),
    (
        "checks",
        [
            ("study_left_right", "left/right"),
            ("study_uniqueness", "uniqueness"),
            ("study_texture", "texture, with the x-Sobel"),
        ],
    ),
    ("after the winner", [("study_subpixel", "subpixel"), ("study_median", "median 3x3")]),
    ("together", [("study_all", "x-Sobel, all checks, subpixel, median")]),
]
SMALL_TARGET = "ecp5_25f_grade6"
# Cores of one map, that of a clock a pixel pair first.
FOLDED = (
    "ambrosch2007",
    "ambrosch2007_f5",
    "ambrosch2007_f10",
    "ambrosch2007_f20",
    "miyajima_640",
    "miyajima_640_f5",
    "vga_64",
    "census_640_f8",
    "sgm_640",
    "sgm_640_f8",
    "sgm_640_f16",
    "sgm_640_64_f4",
    "sgm_640_64_f8",
    "sgm_640_64_f8_road",
    "sgm_640_64_f8_lr",
    "sgm_640_64_f8_dense",
    "sgm_512_64_f16",
    "sgm_320_64_f16",
)
# Pairs that differ in the bits of a pixel alone: (configuration of 8 bits, the deeper one)
DEEPER = [
    ("tiny", "tiny_10bit"),
    ("tiny_sgm", "tiny_sgm_10bit"),
    ("tiny_phase", "tiny_phase_10bit"),
    ("tiny_phase_three_scales", "tiny_phase_12bit"),
    ("tiny_dynamic_census", "tiny_dynamic_10bit"),
    ("tiny_dynamic", "tiny_dynamic_12bit"),
    ("rectify_tiny", "rectify_tiny_12bit"),
]
DEPTHS = ["study", "study_cost2", "study_cost1", "study_group4", "study_slice4", "study_slice16"]


def page() -> str:
    p = Configuration(BASE).parameters
    size = f"{p['width_px']}x{p['height_px']}, D = {p['disparities']}"
    return TEXT.read_text().format(
        size=size,
        options=options_table(),
        crossover="\n" + crossover(),
        pixel_bits=pixel_bits_table(),
        folded=folded_table(),
        depths=depths_table(),
    )


def _known(name: str) -> bool:
    return name in committed.known_configurations()


def _routed(name: str, target: str = "ecp5") -> Result | None:
    return Configuration(name).targets.get(target)


def _slowest_path(result: Result | None) -> str:
    if result is None:
        return UNKNOWN
    path = result["critical_path"]
    return f"{code(path['from'])} to {code(path['to'])}"


def options_table() -> str:
    head = ["", "option", "clocks a frame", "latency", "LUT4", "more LUT4", "flip-flops", "memory bits", "block RAMs"]
    base = _routed(BASE) if _known(BASE) else None
    rows = []
    for heading, members in OPTIONS:
        for name, what in members:
            if not _known(name):
                rows.append([heading, what, *[UNKNOWN] * 10])
                continue
            configuration, result = Configuration(name), _routed(name)
            p, tool = configuration.parameters, configuration.manifest["tool_report"]
            luts = figures.lut_count(result) if result else None
            more = luts - figures.lut_count(base) if luts is not None and base and name != BASE else None
            rows.append(
                [
                    heading,
                    what,
                    number(figures.clocks_per_frame(p)),
                    number(p["latency_clocks"]),
                    number(luts),
                    UNKNOWN if more is None else f"{more:+,}",
                    number(result["ffs"] if result else None),
                    number(tool["memory_bits"]),
                    number(result["block_rams"] if result else None),
                    number(result["fmax_mhz"]["median"] if result else None, 1),
                    code(name),
                    _slowest_path(result),
                ]
            )
    return table([*head, "MHz", "configuration", "slowest path"], rows)


def pixel_bits_table() -> str:
    """Of rows that are too small to be placed and routed: what their VHDL holds."""
    rows = []
    for names in DEEPER:
        if not set(names) <= set(committed.known_designs()):
            continue
        narrow, deep = (Configuration(name) for name in names)
        cells = [deep.parameters["family"], str(rtl.pixel_bits_of(deep.parameters))]
        for kind in ("register_bits", "memory_bits"):
            before, now = (c.manifest["tool_report"][kind] for c in (narrow, deep))
            cells += [number(now), number(before), f"{100 * (now / before - 1):+.1f} %"]
        rows.append([*cells, code(names[1]), code(names[0])])
    head = ["family", "bits of a pixel", "register bits", "before", "more", "memory bits", "before", "more"]
    return table([*head, "configuration", "before: 8 bits"], rows)


def folded_table() -> str:
    """Cores of several clocks a pixel pair below those that they give the map of."""
    rows = []
    for name in filter(_known, FOLDED):
        configuration, result = Configuration(name), _routed(name)
        p, tool = configuration.parameters, configuration.manifest["tool_report"]
        clock = result["fmax_mhz"]["median"] if result and "fmax_mhz" in result else None
        rates = figures.speed(p, clock, figures.lut_count(result)) if result and clock else None
        rows.append(
            [
                code(name),
                str(clocks_per_pixel(p)),
                number(figures.clocks_per_frame(p)),
                number(figures.lut_count(result) if result else None),
                number(result["ffs"] if result else None),
                number(tool["memory_bits"]),
                number(result["block_rams"] if result else None),
                number(clock, 1),
                number(rates["frames_per_second"] if rates else None),
                number(rates["evaluations_per_second_per_lut"] / 1e3 if rates else None),
                _small_device(name),
            ]
        )
    head = ["configuration", "clocks a pixel pair", "clocks a frame", "LUT4", "flip-flops", "memory bits", "block RAMs"]
    more = ["MHz", "frames a second", "thousand evaluations a second and LUT4", "25F, grade 6: MHz, frames a second"]
    return table([*head, *more], rows)


def _small_device(name: str) -> str:
    result = _routed(name, SMALL_TARGET)
    if not result or "fmax_mhz" not in result:
        return "-"
    clock = result["fmax_mhz"]["median"]
    rates = figures.speed(Configuration(name).parameters, clock, figures.lut_count(result))
    return f"{number(clock, 1)}, {number(rates['frames_per_second'])}"


def depths_table() -> str:
    rows = []
    for name in filter(_known, DEPTHS):
        p, result = Configuration(name).parameters, _routed(name)
        rows.append(
            [
                str(option(p, "cost_clocks")),
                str(option(p, "winner_group")),
                str(option(p, "slice_disparities")),
                str(p["latency_clocks"]),
                number(figures.lut_count(result) if result else None),
                number(result["ffs"] if result else None),
                number(result["fmax_mhz"]["median"] if result else None, 1),
                code(name),
            ]
        )
    head = ["cost_clocks", "winner_group", "slice_disparities", "latency, clocks", "LUT4", "flip-flops", "MHz"]
    return table([*head, "configuration"], rows)


def crossover() -> str:
    """For each window that was built both ways, which takes fewer look-up tables."""
    sentences = []
    for window, direct, recursive in (
        (3, "study_w3", "study_w3_recursive"),
        (5, "study", "study_recursive"),
        (7, "study_w7", "study_w7_recursive"),
        (9, "study_w9", "study_w9_recursive"),
    ):
        results = [_routed(name) for name in (direct, recursive) if _known(name)]
        luts = [figures.lut_count(result) for result in results if result]
        if len(luts) == 2:
            better = "direct" if luts[0] < luts[1] else "recursive"
            sentences.append(f"{window}x{window}: {luts[0]:,} LUT4 direct, {luts[1]:,} recursive: {better}.")
    return "\n".join(f"- {sentence}" for sentence in sentences)
