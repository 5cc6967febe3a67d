# SPDX-License-Identifier: Apache-2.0
"""What a camera's clock makes of a core: frames a second and latency, from the manifests."""

from collections.abc import Iterable

from ..base.configurations import clocks_per_pixel
from ..base.markdown import code, number, replaced, table
from ..base.tools import ROOT
from ..implementation import figures
from ..implementation.results import Configuration

PAGE = ROOT / "docs" / "integration.md"
BEGIN, END = "<!-- camera: made by scripts/performance.py -->", "<!-- end of camera -->"
EXAMPLES = ("ambrosch2007", "niitsuma_640", "vga_64", "han_640", "census_450", "sgm_450")
MHZ = 27.0
SHELL_CLOCKS = 5  # of stereo_ip beside those of its core; test_kit_vhdl.py measures them


def clocks_to_first(configuration: Configuration) -> int:
    """From the first pair of a frame that s_axis takes to its first disparity on m_axis, when nothing waits."""
    p = configuration.parameters
    return (p["groups_to_first_output"] - 1) * clocks_per_pixel(p) + p["latency_clocks"] + SHELL_CLOCKS


def clocks_after_last(configuration: Configuration) -> int:
    """From the last pair of a frame to its last disparity, when no next frame follows."""
    p = configuration.parameters
    return p["flush_groups"] * clocks_per_pixel(p) + p["latency_clocks"] + SHELL_CLOCKS


def camera_table(configurations: Iterable[Configuration], mhz: float) -> str:
    """One group a clock, or as many clocks as the core needs, at `mhz`."""
    head = ["configuration", "size", "frames a second, at most", "a frame, ms", "first pair to first disparity, lines"]
    head += ["the same, ms", "last pair to last disparity, ms", "blanking or FIFO, clocks", "printed by"]
    rows = []
    for c in configurations:
        clocks, first = figures.clocks_per_frame(c.parameters), clocks_to_first(c)
        rows.append(
            [
                code(c.name),
                c.size(),
                number(mhz * 1e6 / clocks, 1),
                number(clocks / mhz / 1e3, 3),
                number(first / c.parameters["width_px"] / clocks_per_pixel(c.parameters), 1),
                number(first / mhz / 1e3, 3),
                number(clocks_after_last(c) / mhz / 1e3, 3),
                number(c.parameters["flush_groups"] * clocks_per_pixel(c.parameters)),
                code(f"scripts/performance.py --config {c.name} --mhz {mhz:g}"),
            ]
        )
    return table(head, rows)


def page() -> str:
    """docs/integration.md with its table made anew."""
    shown = camera_table((Configuration(name, stale_is_none=True) for name in EXAMPLES), MHZ)
    return replaced(PAGE, BEGIN, END, shown)
