# SPDX-License-Identifier: Apache-2.0
"""docs/performance.md: tables made from committed files only, so that anyone gets the same page."""

from typing import NamedTuple, Optional

from ..base.families import PAPER as PAPER_FAMILY, TINY, family
from ..base.markdown import UNKNOWN, code, number, table
from ..base.tools import ROOT
from ..implementation import figures, job as implement
from ..implementation.results import Configuration
from ..implementation.yosys import TARGETS

PAGE = ROOT / "docs" / "performance.md"
PAPER = {"width_px": 320, "height_px": 240, "disparities": 100}


class Published(NamedTuple):
    """What others say of their systems; None where they do not."""

    system: str
    clocks_per_frame: Optional[int]  # of 320x240 with 100 disparities
    frames_per_second: Optional[int]
    aluts: Optional[int]
    memory_bits: Optional[int]
    mde_per_second: Optional[int]
    source: str


PAPER_WINDOW_PX = 3
PAPER_MHZ = 65
PUBLISHED = [
    Published(*row)
    for row in (
        (
            f"Ambrosch et al. 2007, 3x3, Stratix II, {PAPER_MHZ} MHz",
            153_120,
            425,
            15_616,
            884_736,
            None,
            "the paper, section 4",
        ),
        ("Vitis Vision StereoBM, 100 units, 5x5", 79_056, None, None, None, None, "its loop bounds"),
        ("Strother dlsc SAD core, 2 rows at once, 5x5", 27_000, None, None, None, None, "its header; about"),
        (
            "best FPGA row found: SGM 3840x2160x64 at 30 frames a second",
            None,
            None,
            None,
            None,
            15_925,
            "its publication",
        ),
    )
]
PAPER_SYSTEM = PUBLISHED[0]  # "Hardware implementation of an SAD based stereo vision algorithm", 2007

_SURVEY = "table 1 of doi 10.1155/2014/945926"
# (system of the paper's comparison or of ours, point, frames a second where a public source gives them, that source, configuration)
SYSTEMS = [
    ("Niitsuma and Maruyama", "640x480, D=27, 7x7", None, "", "niitsuma_640"),
    ("Niitsuma and Maruyama", "320x240, D=121, 7x7", None, "", "niitsuma_320"),
    ("Lee et al.", "320x240, D=64, 16x16", None, "", "lee_320"),
    ("Miyajima and Maruyama", "640x480, D=200, 7x7", None, "", "miyajima_640"),
    ("Yi et al.", "270x270, D=34, window not stated: 9x9 here", None, "", "yi_270"),
    ("Han et al.", "640x480, D=128, window not stated: 9x9 here", None, "", "han_640"),
    ("DeepSea (Tyzx)", "512x480, D=52, census", 200, _SURVEY, "deepsea_512"),
    ("OpenCV StereoBM, block 15", "450x375, D=64, checks, subpixel", None, "", "opencv_bm"),
    ("best trade-off in quality.md", "450x375, D=48, census 9x3, 9x9", None, "", "census_450"),
    ("Kim et al.: trellis", "320x240, D=128", 30, _SURVEY, None),
    ("PARTS, Masrani and MacLean: local weighted phase correlation", "640x480, D=36 (Masrani)", 30, _SURVEY, None),
    ("Masrani and MacLean: dynamic range", "", None, "", None),
]


def per_clock_table(configurations):
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
    return table(
        [
            "configuration",
            "size",
            "clocks a frame",
            "latency, clocks",
            "evaluations a clock",
            "register bits",
            "memory bits",
            "printed by",
        ],
        rows,
    )


def area_table(configurations):
    rows = []
    for c in configurations:
        for name in TARGETS:
            result = c.targets.get(name)
            values = (
                [
                    number(figures.lut_count(result)) + " " + TARGETS[name].lut_name,
                    number(result["ffs"]),
                    number(result["block_rams"]),
                ]
                if result
                else [UNKNOWN] * 3
            )
            rows.append([code(c.name), name, *values, code(f"scripts/implement.py --config {c.name} --target {name}")])
    return table(["configuration", "family", "look-up tables", "flip-flops", "block RAMs", "printed by"], rows)


def speed_table(configurations):
    rows = []
    for c in configurations:
        clock = c.clock()
        path = clock.get("path")
        rows.append(
            [
                code(c.name),
                number(clock.get("median"), 1),
                number(clock.get("best"), 1),
                number(clock.get("frames_per_second")),
                number(clock.get("mde_per_second")),
                number(clock["evaluations_per_second_per_lut"] / 1e3) if clock else UNKNOWN,
                f"{code(path['from'])} to {code(path['to'])}" if path else UNKNOWN,
                code(f"scripts/implement.py --config {c.name} --target ecp5"),
            ]
        )
    return table(
        [
            "configuration",
            "MHz, median",
            "MHz, best seed",
            "frames a second",
            "Mde/s",
            "thousand evaluations/s per LUT",
            "slowest path",
            "printed by",
        ],
        rows,
    )


def comparison(configurations):
    """(head, rows): the published systems, and those of the configurations that have the paper's size."""
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
        if any(c.parameters[key] != value for key, value in PAPER.items()):
            continue
        clock, cyclone = c.clock(), c.targets.get("cyclonev")
        rows.append(
            [
                f"this core, {code(c.name)}",
                number(figures.clocks_per_frame(c.parameters)),
                number(figures.evaluations_per_clock(c.parameters), 1),
                number(clock.get("frames_per_second")),
                number(clock.get("mde_per_second")),
                number(cyclone and cyclone["aluts"]),
                number(c.manifest["tool_report"]["memory_bits"]),
                code(f"scripts/implement.py --config {c.name}"),
            ]
        )
    return [
        "system",
        "clocks a frame",
        "evaluations a clock",
        "frames a second",
        "Mde/s",
        "ALUTs",
        "memory bits",
        "from",
    ], rows


TEXT = """\
# Performance

Made by `scripts/performance.py` from the manifest.json, cosimulation.json and implementation.json of the folders in `generated_rtl/`. Do not
edit. A dash is a number that is not published or not measured yet.

W, H: image size; D: disparities; P: pixel pairs a clock; Mde/s: million disparity evaluations, W\\*H\\*D each frame, a second.

## In clocks

A frame takes W\\*H/P clocks when frames follow each other; the co-simulation measures the same.

{per_clock}

## Clock and speed on ECP5

LFE5U-85F, speed grade 8, after place and route by nextpnr; the median of the seeds counts. Paths from and to pins are not
constrained.

{speed}

## Area

By yosys. LUT RAM counts as look-up tables: on ECP5 a 16x4 RAM as 6 and a carry cell as 2 (nextpnr counts the same), on
Cyclone V a 32x1 MLAB bit and an inverter as 1, on 7 series a RAM32M as 4 and an inverter or SRL as 1. Multiplexers and
carry cells that stand beside the look-up tables are not counted; implementation.json lists every kind of cell.

{area}

## Beside published numbers

Evaluations a clock are for 320x240 and D = 100. ALUTs of this core are those of Cyclone V by yosys; the paper's are of
Stratix II by Altera's tools. The frames a second of this core are those of ECP5.

{comparison}

The systems that the paper compares itself with, and two more, as configurations of this core. "Compared": outputs of the VHDL
that the co-simulation compared with those of the C++ core, of some rows in GHDL and of a whole frame in Verilator:

```sh
build/release/stereo_hls scene --config NAME --seed 1 --out build/scenes/NAME
scripts/cosim.py --config NAME --left build/scenes/NAME/left.png --right build/scenes/NAME/right.png --rows 16 --record
scripts/cosim.py --config NAME --left build/scenes/NAME/left.png --right build/scenes/NAME/right.png --simulator verilator --record
scripts/implement.py --config NAME --target ecp5 --target cyclonev --seeds 1
```

{systems}

[features.md](features.md) shows what each option, each window and each depth of the pipeline costs.
"""


def compared(run):
    """Of one simulator, as cosim_record keeps it."""
    return UNKNOWN if run is None else f"{run['compared']:,} of {run['expected']:,}, {run['mismatches']:,} differ"


def systems(make=Configuration):
    """(head, rows): the systems that the paper compares itself with, and this core as they were. `make`: configuration of a name."""
    rows = []
    for system, what, published, source, name in SYSTEMS:
        if name is None or name not in implement.known_configurations():
            rows.append(
                [system, what, number(published), source, code(name) if name else "not done yet", *[UNKNOWN] * 8]
            )
            continue
        c = make(name)
        clock, area = c.clock(), c.targets.get("ecp5")
        cyclone = c.targets.get("cyclonev")
        rows.append(
            [
                system,
                what,
                number(published),
                source,
                code(name),
                number(figures.clocks_per_frame(c.parameters)),
                number(c.manifest["tool_report"]["register_bits"]),
                number(c.manifest["tool_report"]["memory_bits"]),
                *(compared(c.cosimulations.get(simulator)) for simulator in ("ghdl", "verilator")),
                number(figures.lut_count(area)) if area else UNKNOWN,
                number(cyclone and cyclone["aluts"]),
                number(clock.get("frames_per_second")),
            ]
        )
    head = [
        "system",
        "point",
        "its frames a second",
        "published in",
        "this core",
        "clocks a frame",
        "register bits",
        "memory bits",
        "compared in GHDL",
        "compared in Verilator",
        "LUT4",
        "ALUTs",
        "frames a second on ECP5",
    ]
    return head, rows


def page():
    """The paper's core and its small twins; other families have pages of their own."""
    configurations = [
        Configuration(name) for name in implement.known_configurations() if family(name) in (PAPER_FAMILY, TINY)
    ]
    return TEXT.format(
        per_clock=per_clock_table(configurations),
        speed=speed_table(configurations),
        area=area_table(configurations),
        comparison=table(*comparison(configurations)),
        systems=table(*systems()),
    )
