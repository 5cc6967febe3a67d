# SPDX-License-Identifier: Apache-2.0
"""docs/images/clock_logic.svg: clock against logic of every routed configuration."""

from collections.abc import Iterable
from typing import NamedTuple

from ..base import committed
from ..base.tools import ROOT
from ..implementation import figures
from ..implementation.results import Configuration
from ..rendering.plots import Axis, svg

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
            family = committed.folder(c.name).parent.name
            found.append(Point(c.name, family, c.manifest["use"], luts, clock["median"]))
    return sorted(found)


def picture(shown: list[Point]) -> str:
    """The SVG."""
    return svg("clock_logic", (9, 6), shown, lambda axis: _draw(axis, shown))


def _draw(axis: Axis, shown: list[Point]) -> None:
    from matplotlib import ticker

    families = sorted({p.family for p in shown})
    for number, (family, use) in enumerate(sorted({(p.family, p.use) for p in shown})):
        members = [p for p in shown if (p.family, p.use) == (family, use)]
        axis.scatter(
            [p.luts for p in members],
            [p.mhz for p in members],
            s=18,
            marker=MARKERS[families.index(family) % len(MARKERS)],
            color=f"C{number % 10}",
            label=f"{family}, {use}",
        )
    for p in shown:
        axis.annotate(p.name, (p.luts, p.mhz), textcoords="offset points", xytext=(3, 3), fontsize=5)
    axis.set_xscale("log")
    axis.xaxis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
    axis.xaxis.set_major_formatter(ticker.StrMethodFormatter("{x:,.0f}"))
    axis.xaxis.set_minor_formatter(ticker.NullFormatter())
    axis.set_xlabel("look-up tables (LUT4, a carry cell is 2)")
    axis.set_ylabel("MHz after place and route, LFE5U-85F grade 8")
    axis.grid(True, alpha=0.3)
    if shown:
        axis.legend(loc="upper right")
