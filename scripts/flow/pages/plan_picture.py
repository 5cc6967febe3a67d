# SPDX-License-Identifier: Apache-2.0
"""docs/images/plan.svg: the committed configurations over the devices."""

from __future__ import annotations

from typing import Any, NamedTuple

from ..base.configurations import configurations
from ..base.markdown import UNKNOWN
from ..base.tools import ROOT
from ..implementation import figures
from ..planning import cores, search
from ..planning.devices import Device, device_of, targets, title_of
from ..rendering.plots import Axis, svg

PICTURE = ROOT / "docs" / "images" / "plan.svg"
USES = ("paper", "system", "planned")  # of the configurations that stand in it
FITS, FULL, TOO_LARGE, NOT_KNOWN = "#d7ecd9", "#fdf3c8", "#f6d2cd", "#eeeeee"
_FULL_FROM = 0.85  # of a device


class Cell(NamedTuple):
    target: str
    name: str
    text: str
    color: str


def cells(planner: search.Planner) -> list[Cell]:
    """Of every configuration on every device whose size is known."""
    rows = {name: row for name, row in configurations().items() if row["use"] in USES}
    found = []
    for name, row in sorted(rows.items()):
        for target in targets():
            device = device_of(target)
            if device:
                found.append(_cell(planner, name, dict(row), target, device))
    return found


def _cell(planner: search.Planner, name: str, row: dict[str, Any], target: str, device: Device) -> Cell:
    of_name = {core.target: core for core in planner.known if core.name == name}
    if row["family"] not in cores.FAMILIES and not of_name:
        return Cell(target, name, UNKNOWN, NOT_KNOWN)
    numbers = planner.numbers(row if row["family"] in cores.FAMILIES else None, target, of_name)
    sites = numbers.lut_sites or numbers.luts
    registers = numbers.flip_flop_sites
    taken = (
        (sites.value if sites else None, device.lut_sites),
        (registers.value if registers else None, device.flip_flops),
        (numbers.blocks, device.block_rams),
    )
    shares = [part / there for part, there in taken if part is not None]
    if not shares:
        return Cell(target, name, UNKNOWN, NOT_KNOWN)
    load = max(shares)
    color = TOO_LARGE if load > 1 else FULL if load > _FULL_FROM else FITS
    taken_text = ", ".join(f"{100 * share:.0f} %" for share in shares)
    parameters: Any = row
    frames = figures.frames_per_second(parameters, numbers.mhz.value) if numbers.mhz and load <= 1 else None
    guessed = "" if all(n is None or n.of for n in (numbers.mhz, numbers.luts)) else "*"
    text = taken_text if frames is None else f"{frames:,.0f}{guessed} a second; {taken_text}"
    return Cell(target, name, text, color)


def picture(planner: search.Planner) -> str:
    """The SVG."""
    shown = cells(planner)
    names = sorted({cell.name for cell in shown})
    columns = [target for target in targets() if any(cell.target == target for cell in shown)]
    size = (2.6 + 2.6 * len(columns), 1.0 + 0.26 * len(names))
    return svg(
        "plan", size, [list(cell) for cell in shown], lambda axis: _draw(axis, shown, names, columns), "constrained"
    )


def _draw(axis: Axis, shown: list[Cell], names: list[str], columns: list[str]) -> None:
    for cell in shown:
        x, y = columns.index(cell.target), names.index(cell.name)
        axis.add_patch(_square(x, y, cell.color))
        axis.text(x, y, cell.text, ha="center", va="center", fontsize=7)
    axis.set_xlim(-0.5, len(columns) - 0.5)
    axis.set_ylim(len(names) - 0.5, -0.5)
    axis.set_xticks(range(len(columns)), [title_of(target) for target in columns])
    axis.xaxis.tick_top()
    axis.set_yticks(range(len(names)), names)
    axis.tick_params(length=0)
    for side in axis.spines.values():
        side.set_visible(False)


def _square(x: int, y: int, color: str) -> Any:
    from matplotlib.patches import Rectangle

    return Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=color, edgecolor="white", linewidth=1.5)
