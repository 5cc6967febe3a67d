# SPDX-License-Identifier: Apache-2.0
"""docs/features.md: what each option of the algorithm and of the pipeline costs, from committed files only."""

from ..base.markdown import code, number, table
from ..base.tools import ROOT
from ..implementation import figures, job as implement
from ..implementation.results import Configuration

PAGE = ROOT / "docs" / "features.md"
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
DEPTHS = ["study", "study_cost2", "study_cost1", "study_group4", "study_slice4", "study_slice16"]

TEXT = """\
# Features and what they cost

Made by `scripts/features.py` from the manifest.json and implementation.json of the folders in `generated_rtl/`. Do not edit.
A dash is a number that is not measured yet.

[algorithm.md](algorithm.md) defines each option. All rows: {size} on the LFE5U-85F, speed grade 8, look-up tables by yosys
(LUT RAM counts as look-up tables), clock after place and route by nextpnr, one seed: differences of some per cent are noise.
Clocks a frame: when frames follow each other as closely as they may. Latency: from the last group of pixels that a disparity
needs to the disparity; a left/right check needs D-1 more columns, a median and a prefilter a row and a column, a census
transform as many rows and columns as its window reaches.

{options}

Printed again by `scripts/synthesize.py --config NAME`, `scripts/implement.py --config NAME --target ecp5 --seeds 1` and
`scripts/features.py`.

## Direct or recursive sums

Direct sums add all rows of a window in each clock. Recursive sums add the row that enters the window and subtract the one that
leaves it, and need a memory for the sums of all columns, and a gap of as many rows as the window reaches down between frames.
{crossover}

## Pipeline depth

The same core with other parameters of its blocks (`cost_clocks`, `winner_group`, `slice_disparities`).

{depths}
"""


def _result(name):
    """(configuration, its ECP5 result or None)"""
    configuration = Configuration(name)
    return configuration, configuration.targets.get("ecp5")


def _known(name):
    return name in implement.known_configurations()


def options_table():
    base = _result(BASE)[1] if _known(BASE) else None
    rows = []
    for heading, members in OPTIONS:
        for name, what in members:
            if not _known(name):
                rows.append([heading, what, *["-"] * 9])
                continue
            configuration, result = _result(name)
            p, tool = configuration.parameters, configuration.manifest["tool_report"]
            luts = figures.lut_count(result) if result else None
            extra = f"{luts - figures.lut_count(base):+,}" if result and base and name != BASE else "-"
            rows.append(
                [
                    heading,
                    what,
                    number(figures.clocks_per_frame(p)),
                    number(p["latency_clocks"]),
                    number(luts),
                    extra,
                    number(result and result["ffs"]),
                    number(tool["memory_bits"]),
                    number(result and result["block_rams"]),
                    number(result and result["fmax_mhz"]["median"], 1),
                    code(name),
                ]
            )
    return table(
        [
            "",
            "option",
            "clocks a frame",
            "latency",
            "LUT4",
            "more LUT4",
            "flip-flops",
            "memory bits",
            "block RAMs",
            "MHz",
            "configuration",
        ],
        rows,
    )


def depths_table():
    rows = []
    for name in DEPTHS:
        if not _known(name):
            continue
        configuration, result = _result(name)
        p = configuration.parameters
        rows.append(
            [
                *[str(p[key]) for key in ("cost_clocks", "winner_group", "slice_disparities", "latency_clocks")],
                number(result and figures.lut_count(result)),
                number(result and result["ffs"]),
                number(result and result["fmax_mhz"]["median"], 1),
                code(name),
            ]
        )
    return table(
        [
            "cost_clocks",
            "winner_group",
            "slice_disparities",
            "latency, clocks",
            "LUT4",
            "flip-flops",
            "MHz",
            "configuration",
        ],
        rows,
    )


def crossover():
    """For each window that was built both ways, which takes fewer look-up tables."""
    sentences = []
    for window, direct, recursive in (
        (3, "study_w3", "study_w3_recursive"),
        (5, "study", "study_recursive"),
        (7, "study_w7", "study_w7_recursive"),
        (9, "study_w9", "study_w9_recursive"),
    ):
        if not (_known(direct) and _known(recursive)):
            continue
        results = [_result(name)[1] for name in (direct, recursive)]
        if all(results):
            luts = [figures.lut_count(result) for result in results]
            better = "direct" if luts[0] < luts[1] else "recursive"
            sentences.append(f"{window}x{window}: {luts[0]:,} LUT4 direct, {luts[1]:,} recursive: {better}.")
    return "\n".join(f"- {sentence}" for sentence in sentences)


def page():
    p = Configuration(BASE).parameters
    size = f"{p['width_px']}x{p['height_px']}, D = {p['disparities']}"
    return TEXT.format(size=size, options=options_table(), crossover="\n" + crossover(), depths=depths_table())
