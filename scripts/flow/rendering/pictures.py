# SPDX-License-Identifier: Apache-2.0
"""Maps and images as PNG of one pixel a pixel; the page enlarges them and writes scales and legends as text."""

import io
from dataclasses import dataclass
from typing import Optional

from ..base.errors import EXIT_MISSING_TOOL, FlowError
from .page import percent

COLORS = "turbo"  # of disparities
NO_RANGE = ("#f7f7f4", "#e3e3dd")  # stripes: columns that the map does not have
REJECTED = "#262626"
HIDDEN = "#b9b9b9"
GOOD, TOO_STRICT, MISSED = "#2b7bba", "#e69f00", "#c2182b"
# (largest error in pixels, colour); the last one is everything above
ERRORS = [(0.5, "#e6f0f7"), (1, "#a6cbe3"), (2, "#fdc57b"), (4, "#ee7a22"), (None, "#a01018")]


@dataclass(frozen=True)
class Picture:
    title: str
    png: bytes
    caption: str
    width: int  # pixels of the image, for the space it takes on the page
    height: int
    scale: tuple = ()  # labels of the colour scale, from left to right
    legend: tuple = ()  # (colour, label, percent or None)
    mark: Optional[tuple] = None  # where to draw a ring: per cent of width and height


def libraries():
    """(numpy, PIL.Image), which come with matplotlib."""
    try:
        import matplotlib  # noqa: F401
        import numpy
        from PIL import Image
    except ImportError as error:
        raise FlowError(
            f"the Python package {error.name} is missing; on Debian: apt-get install python3-matplotlib",
            EXIT_MISSING_TOOL,
        ) from None
    return numpy, Image


def load(path, gray=False):
    """An image as an array; with `gray`, 8 bits."""
    numpy, image = libraries()
    try:
        with image.open(path) as file:
            return numpy.asarray(file.convert("L") if gray else file)
    except (OSError, ValueError, SyntaxError) as error:
        reason = getattr(error, "strerror", None) or "not a readable image"
        raise FlowError(f"{path}: {reason}") from None


def png(array):
    _, image = libraries()
    data = io.BytesIO()
    image.fromarray(array).save(data, "PNG")
    return data.getvalue()


def rgb(color):
    return tuple(int(color[i : i + 2], 16) for i in (1, 3, 5))


def disparity_colors(values, low, high):
    """RGB of disparities in pixels."""
    numpy, _ = libraries()
    from matplotlib import colormaps

    share = (numpy.asarray(values, float) - low) / max(high - low, 1)
    return (numpy.asarray(colormaps[COLORS](numpy.clip(share, 0, 1)))[..., :3] * 255).round().astype(numpy.uint8)


def scale_png():
    numpy, _ = libraries()
    return png(disparity_colors(numpy.arange(256)[None, :], 0, 255))


def scale_labels(low, high):
    middle = (low + high) / 2
    return f"{low} px", f"{middle:g}", f"{high} px"


def blank(width, height):
    """The stripes of an image without a map."""
    numpy, _ = libraries()
    stripes = (numpy.add.outer(numpy.arange(height), numpy.arange(width)) // 4 % 2).astype(bool)
    return numpy.where(stripes[..., None], rgb(NO_RANGE[0]), rgb(NO_RANGE[1])).astype(numpy.uint8)


class Geometry:
    """Where the map stands in the reference image."""

    def __init__(self, match):
        self.width, self.height = match["width_px"], match["height_px"]
        self.first = match["output_first_column"]
        self.map_width, self.map_height = match["output_width_px"], match["output_height_px"]

    def cut(self, image):
        """The part of a reference image's array that the map covers."""
        return image[: self.map_height, self.first : self.first + self.map_width]

    def framed(self, colors):
        page = blank(self.width, self.height)
        self.cut(page)[...] = colors
        return page


def fitted(image, match):
    """The image at the size that was matched: as it is, its centre, or resized."""
    numpy, pil = libraries()
    width, height = match["width_px"], match["height_px"]
    if match["fit"] == "resize":
        return numpy.asarray(pil.fromarray(image).resize((width, height)))
    x, y = (image.shape[1] - width) // 2, (image.shape[0] - height) // 2
    if x < 0 or y < 0:
        raise FlowError(f"it is {image.shape[1]}x{image.shape[0]}, smaller than the {width}x{height} that were matched")
    return image[y : y + height, x : x + width]


def of_map(match, values, valid):
    """The disparity map, in pixels."""
    geometry = Geometry(match)
    low, high = match["min_disparity"], match["min_disparity"] + match["disparities"] - 1
    colors = disparity_colors(values, low, high)
    colors[~valid] = rgb(REJECTED)
    legend = [] if valid.all() else [(REJECTED, "rejected by a check", percent((~valid).sum(), valid.size))]
    legend += [(NO_RANGE[1], "no complete disparity range", None)] if geometry.map_width < geometry.width else []
    return Picture(
        "Disparity",
        png(geometry.framed(colors)),
        f"Distance in columns between the {match['reference']} image's pixel and its match; near is red.",
        geometry.width,
        geometry.height,
        scale_labels(low, high),
        tuple(legend),
    )


def of_errors(match, values, valid, truth, visible):
    """(picture, visible and valid pixels off by more than 1 px)"""
    numpy, _ = libraries()
    geometry = Geometry(match)
    visible = geometry.cut(visible) != 0
    counted = visible & valid
    error = numpy.abs(values - geometry.cut(truth))
    colors = numpy.zeros((*error.shape, 3), numpy.uint8)
    legend, low = [], -1.0
    for high, color in ERRORS:
        members = (error > low) & (error <= high) if high else error > low
        colors[members] = rgb(color)
        legend.append(
            (
                color,
                f"{high:g} px or less" if low < 0 else f"up to {high:g} px" if high else f"more than {low:g} px",
                percent((members & counted).sum(), counted.sum()),
            )
        )
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


def of_rejections(match, reference, values, valid, truth=None, visible=None):
    """What the checks threw out, over the reference image; with ground truth, whether they were right."""
    numpy, _ = libraries()
    geometry = Geometry(match)
    gray = 150 + geometry.cut(reference).astype(float) * 105 / 255
    colors = numpy.repeat(gray[..., None], 3, axis=2).round().astype(numpy.uint8)
    if truth is None:
        classes = [(MISSED, "rejected", ~valid)]
    else:
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
