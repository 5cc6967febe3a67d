# SPDX-License-Identifier: Apache-2.0
"""Names at points of a plot that cover neither each other nor a point."""

from collections.abc import Sequence
from typing import Any

from . import plots

Place = tuple[float, float]
Box = Any  # matplotlib's Bbox
_SIZE, _CLEAR_PX = 8, 6  # points; half the side of what is kept clear around a point
# Where a name may stand: first close to its point, then further away, with a thin line.
_DISTANCES = (6, 14, 24, 36, 50, 66, 84, 104, 126, 150)
_SIDES = ((1, 1), (1, -1), (-1, 1), (-1, -1), (0, 1), (0, -1))
_ALIGNED = {1: "left", 0: "center", -1: "right"}


def place(axis: plots.Axis, names: Sequence[tuple[str, Place]], points: Sequence[Place]) -> None:
    """names: with where their points are in the plot. points: all that is to be kept clear, in pixels. The layout must
    be done: what changes it moves the points."""
    from matplotlib.transforms import Bbox

    panel = axis.get_window_extent()
    taken = [Bbox.from_extents(x - _CLEAR_PX, y - _CLEAR_PX, x + _CLEAR_PX, y + _CLEAR_PX) for x, y in points]
    if axis.get_legend():
        taken.append(axis.get_legend().get_window_extent())
    for name, point in names:
        taken.append(_place_one(axis, name, point, panel, taken))


def _place_one(axis: plots.Axis, name: str, point: Place, panel: Box, taken: list[Box]) -> Box:
    label = axis.annotate(
        name,
        point,
        textcoords="offset points",
        xytext=(0, 0),
        fontsize=_SIZE,
        color="#333333",
        zorder=4,
        arrowprops={"arrowstyle": "-", "color": "#999999", "linewidth": 0.6, "shrinkA": 0, "shrinkB": 4},
    )
    label.set_in_layout(False)
    places = [(side, distance) for distance in _DISTANCES for side in _SIDES]
    for (right, up), distance in places:
        box = _move(label, right, up, distance)
        inside = panel.x0 <= box.x0 and box.x1 <= panel.x1 and panel.y0 <= box.y0 and box.y1 <= panel.y1
        if inside and not any(box.overlaps(other) for other in taken):
            return box
    return _move(label, 1, 1, _DISTANCES[0])  # no place is free


def _move(label: Any, right: int, up: int, distance: int) -> Box:
    """The label's box, without its line."""
    from matplotlib.text import Text

    label.set_position((right * distance, up * distance))
    label.set_horizontalalignment(_ALIGNED[right])
    label.set_verticalalignment("bottom" if up > 0 else "top")
    label.update_positions(label.figure.canvas.get_renderer())
    return Text.get_window_extent(label).padded(1)
