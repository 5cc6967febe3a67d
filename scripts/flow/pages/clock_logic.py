# SPDX-License-Identifier: Apache-2.0
"""docs/images/clock_logic.svg: clock against logic of every routed configuration.
The same results give the same file."""

import io
from collections.abc import Iterable
from typing import NamedTuple

from ..base import rtl
from ..base.errors import EXIT_MISSING_TOOL, FlowError
from ..base.tools import ROOT
from ..implementation import figures
from ..implementation.results import Configuration

PICTURE = ROOT / "docs" / "images" / "clock_logic.svg"
MARKERS = "os^Dv*"  # of the families, in the order of their names


class Point(NamedTuple):
    name: str
    family: str
    use: str  # of the configuration
    luts: int
    mhz: float


def points(configurations: Iterable[Configuration]) -> list[Point]:
    found = []
    for c in configurations:
        clock = c.clock()
        if clock:
            luts = figures.lut_count(c.targets["ecp5"])
            family = rtl.folder(c.name).parent.name
            found.append(Point(c.name, family, c.manifest["use"], luts, clock["median"]))
    return sorted(found)


def picture(shown: list[Point]) -> str:
    """The SVG."""
    try:
        import matplotlib
    except ImportError:
        raise FlowError(
            "the Python package matplotlib is missing; on Debian: apt-get install python3-matplotlib",
            EXIT_MISSING_TOOL,
        ) from None
    matplotlib.use("Agg")
    from matplotlib import pyplot, ticker

    # Text stays text and names of parts follow from a constant, so that the file is the same everywhere.
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": "clock_logic", "font.size": 8}):
        figure, axes = pyplot.subplots(figsize=(9, 6), layout="none")
        for number, (family, use) in enumerate(sorted({(p.family, p.use) for p in shown})):
            members = [p for p in shown if (p.family, p.use) == (family, use)]
            axes.scatter(
                [p.luts for p in members],
                [p.mhz for p in members],
                s=18,
                marker=MARKERS[sorted({p.family for p in shown}).index(family) % len(MARKERS)],
                color=f"C{number % 10}",
                label=f"{family}, {use}",
            )
        for p in shown:
            axes.annotate(p.name, (p.luts, p.mhz), textcoords="offset points", xytext=(3, 3), fontsize=5)
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axes.xaxis.set_major_formatter(ticker.StrMethodFormatter("{x:,.0f}"))
        axes.xaxis.set_minor_formatter(ticker.NullFormatter())
        axes.set_xlabel("look-up tables (LUT4, a carry cell is 2)")
        axes.set_ylabel("MHz after place and route, LFE5U-85F grade 8")
        axes.grid(True, alpha=0.3)
        if shown:
            axes.legend(loc="upper right")
        output = io.StringIO()
        figure.savefig(output, format="svg", metadata={"Date": None, "Creator": None})
        pyplot.close(figure)
    return "\n".join(line.rstrip() for line in output.getvalue().splitlines()) + "\n"
