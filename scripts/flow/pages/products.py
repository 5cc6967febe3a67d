# SPDX-License-Identifier: Apache-2.0
"""The table of README.md: some configurations with their speed, area and quality."""

from __future__ import annotations

from typing import NamedTuple

from ..base.errors import FlowError
from ..base.markdown import UNKNOWN, code, number, replaced, table
from ..base.tools import ROOT
from ..implementation import figures
from ..implementation.results import Configuration
from . import quality

PAGE = ROOT / "README.md"
BEGIN, END = "<!-- products: made by scripts/performance.py -->", "<!-- end of products -->"
PAIRS = {
    "KITTI 2015, a road": "wrong pixels, a road (KITTI 2015)",
    "Middlebury 2003, a room": "a room (Middlebury 2003)",
}


class Product(NamedTuple):
    configuration: str
    algorithm: str
    measured_as: str  # the row of docs/quality.md with this algorithm


PRODUCTS = [
    Product("ambrosch2007", "block matching, SAD 3x3, as the 2007 paper", "SAD 3x3, the paper's, left reference"),
    Product("census_450", "block matching, census, 9x9, median, subpixel", "block matching, `census_450`"),
    Product("sgm_450", "semi-global, census, 3x3", "semi-global, `sgm_450`"),
    Product(
        "sgm_640_64_f8_road", "as `sgm_450`, P2 the same everywhere, 8 clocks a pixel pair", "P2 the same everywhere"
    ),
    Product("sgm_1242_f8", "as `sgm_450`, 8 clocks a pixel pair", "semi-global, `sgm_450`"),
    Product("trellis_1300", "trellis", "trellis, `trellis_1300`, not of full width"),
]
IN_SOFTWARE = [
    ("OpenCV's StereoBM", "StereoBM"),
    ("OpenCV's StereoSGBM", "StereoSGBM"),
]


def measured(text: str) -> dict[str, list[str]]:
    """{row of the table "D1, dense" in docs/quality.md: its numbers for PAIRS}"""
    lines = text.splitlines()
    head = next((line for line in lines if line.startswith("| D1, dense |")), "")
    names = [name.strip() for name in head.strip("| ").split("|")]
    if not set(PAIRS) <= set(names):
        raise FlowError(f"{quality.PAGE.name} has no table 'D1, dense' with the columns {', '.join(PAIRS)}")
    columns, rows = [names.index(pair) for pair in PAIRS], {}
    for line in lines[lines.index(head) + 2 :]:
        if not line.startswith("|"):
            break
        cells = [cell.strip() for cell in line.strip("| ").split("|")]
        rows[cells[0]] = [f"{cells[column]} %" for column in columns]
    return rows


def products(text: str) -> str:
    """`text`: that of docs/quality.md."""
    found = measured(text)
    rows = []
    for name, algorithm, measured_as in PRODUCTS:
        c = Configuration(name)
        clock = c.clock()
        size = f"{c.parameters['width_px']}x{c.parameters['height_px']}, {c.parameters['disparities']} disparities"
        speed = number(clock["frames_per_second"]) if clock else UNKNOWN
        luts = number(figures.lut_count(c.targets["ecp5"])) if "ecp5" in c.targets else UNKNOWN
        rows.append([code(name), size, algorithm, speed, luts, *found[measured_as]])
    for name, measured_as in IN_SOFTWARE:
        rows.append([name, UNKNOWN, "software", UNKNOWN, UNKNOWN, *found[measured_as]])
    head = ["configuration", "size", "algorithm", "frames a second", "look-up tables", *PAIRS.values()]
    return table(head, rows)


def page() -> str:
    """README.md with its table made anew."""
    return replaced(PAGE, BEGIN, END, products(quality.PAGE.read_text()))
