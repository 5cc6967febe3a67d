# SPDX-License-Identifier: Apache-2.0
"""The pictures of a disparity map on the page of a demo: the map, its errors, what the checks rejected."""

from __future__ import annotations

import math

from ..base.errors import FlowError
from ..rendering.page import percent
from ..rendering.pictures import (
    NO_RANGE,
    REJECTED,
    Array,
    LegendEntry,
    Picture,
    blank,
    disparity_colors,
    libraries,
    png,
    rgb,
    scale_labels,
)
from .demo_folder import Match

HIDDEN = "#b9b9b9"
GOOD, TOO_STRICT, MISSED = "#2b7bba", "#e69f00", "#c2182b"
# (largest error in pixels, colour)
ERRORS = [(0.5, "#e6f0f7"), (1, "#a6cbe3"), (2, "#fdc57b"), (4, "#ee7a22"), (math.inf, "#a01018")]


class Geometry:
    """Where the map stands in the reference image."""

    def __init__(self, match: Match) -> None:
        self.width, self.height = match["width_px"], match["height_px"]
        self.first = match["output_first_column"]
        self.map_width, self.map_height = match["output_width_px"], match["output_height_px"]

    def cut(self, image: Array) -> Array:
        """The part of a reference image's array that the map covers."""
        return image[: self.map_height, self.first : self.first + self.map_width]

    def framed(self, colors: Array) -> Array:
        """The reference image's size, with stripes where there is no map."""
        whole = blank(self.width, self.height)
        self.cut(whole)[...] = colors
        return whole


def fitted(image: Array, match: Match) -> Array:
    """The image at the size that was matched: as it is, its centre, or resized."""
    numpy, pil = libraries()
    width, height = match["width_px"], match["height_px"]
    if match["fit"] == "resize":
        resized: Array = numpy.asarray(pil.fromarray(image).resize((width, height)))
        return resized
    rows, columns = image.shape[:2]
    x, y = (columns - width) // 2, (rows - height) // 2
    if x < 0 or y < 0:
        raise FlowError(f"it is {columns}x{rows}, smaller than the {width}x{height} that were matched")
    return image[y : y + height, x : x + width]


def of_map(match: Match, values: Array, valid: Array) -> Picture:
    """The disparity map, in pixels."""
    geometry = Geometry(match)
    low, high = match["min_disparity"], match["min_disparity"] + match["disparities"] - 1
    colors = disparity_colors(values, low, high)
    colors[~valid] = rgb(REJECTED)
    legend: list[LegendEntry] = []
    if not valid.all():
        legend.append((REJECTED, "rejected by a check", percent((~valid).sum(), valid.size)))
    if geometry.map_width < geometry.width:
        legend.append((NO_RANGE[1], "no complete disparity range", None))
    return Picture(
        "Disparity",
        png(geometry.framed(colors)),
        f"Distance in columns between the {match['reference']} image's pixel and its match; near is red.",
        geometry.width,
        geometry.height,
        scale_labels(low, high),
        tuple(legend),
    )


def of_errors(match: Match, values: Array, valid: Array, truth: Array, visible: Array) -> tuple[Picture, int]:
    """(picture, visible and valid pixels off by more than 1 px)"""
    numpy, _ = libraries()
    geometry = Geometry(match)
    visible = geometry.cut(visible) != 0
    counted = visible & valid
    error = numpy.abs(values - geometry.cut(truth))
    colors = numpy.zeros((*error.shape, 3), numpy.uint8)
    legend: list[LegendEntry] = []
    low = -1.0
    for high, color in ERRORS:
        members = (error > low) & (error <= high)
        colors[members] = rgb(color)
        legend.append((color, _error_label(low, high), percent((members & counted).sum(), counted.sum())))
        low = high
    colors[~valid] = rgb(REJECTED)
    colors[~visible] = rgb(HIDDEN)
    if not valid.all():
        legend.append((REJECTED, "rejected by a check", None))
    legend.append((HIDDEN, "hidden in the other image, not counted", None))
    picture = Picture(
        "Error against the ground truth",
        png(geometry.framed(colors)),
        "Per cent of the pixels that count: visible in both images and not rejected.",
        geometry.width,
        geometry.height,
        (),
        tuple(legend),
    )
    return picture, int((counted & (error > 1)).sum())


def _error_label(low: float, high: float) -> str:
    if low < 0:
        return f"{high:g} px or less"
    return f"up to {high:g} px" if high < math.inf else f"more than {low:g} px"


def of_rejections(
    match: Match, reference: Array, values: Array, valid: Array, known: tuple[Array, Array] | None
) -> Picture:
    """What the checks threw out, over the reference image; with ground truth, whether they were right. `known`: true
    disparities, and which pixels the other image shows."""
    numpy, _ = libraries()
    geometry = Geometry(match)
    gray = 150 + geometry.cut(reference).astype(float) * 105 / 255
    colors = numpy.repeat(gray[..., None], 3, axis=2).round().astype(numpy.uint8)
    if known is None:
        classes = [(MISSED, "rejected", ~valid)]
    else:
        truth, visible = known
        wrong = (geometry.cut(visible) == 0) | (numpy.abs(values - geometry.cut(truth)) > 1)
        classes = [
            (GOOD, "rejected, and hidden or off by more than 1 px", ~valid & wrong),
            (TOO_STRICT, "rejected, but right", ~valid & ~wrong),
            (MISSED, "passed, but hidden or off by more than 1 px", valid & wrong),
        ]
    for color, _, members in classes:
        colors[members] = rgb(color)
    legend = tuple((color, label, percent(members.sum(), members.size)) for color, label, members in classes)
    return Picture(
        "Rejections",
        png(geometry.framed(colors)),
        "What left/right, uniqueness or texture checks rejected. Per cent of the map's pixels.",
        geometry.width,
        geometry.height,
        (),
        legend,
    )
