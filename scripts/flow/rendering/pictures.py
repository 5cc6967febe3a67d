# SPDX-License-Identifier: Apache-2.0
"""Maps and images as PNG of one pixel a pixel; the page enlarges them and writes scales and legends as text."""

from __future__ import annotations

import io
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Optional

from ..base.errors import EXIT_MISSING_TOOL, FlowError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[Any]
else:
    Array = object  # numpy may be missing: libraries()

COLORS = "turbo"  # of disparities
NO_RANGE = ("#f7f7f4", "#e3e3dd")  # stripes: columns that the map does not have
REJECTED = "#262626"

LegendEntry = tuple[str, str, Optional[float]]  # (colour, label, percent)


@dataclass(frozen=True)
class Picture:
    title: str
    png: bytes
    caption: str
    width: int  # pixels of the image, for the space it takes on the page
    height: int
    scale: tuple[str, ...] = ()  # labels of the colour scale, from left to right
    legend: tuple[LegendEntry, ...] = ()
    mark: tuple[float, float] | None = None  # where to draw a ring: per cent of width and height


def libraries() -> tuple[ModuleType, ModuleType]:
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


def load(path: Path, gray: bool = False) -> Array:
    """An image as an array; with `gray`, 8 bits."""
    numpy, image = libraries()
    try:
        with image.open(path) as file:
            pixels: Array = numpy.asarray(file.convert("L") if gray else file)
    except (OSError, ValueError, SyntaxError) as error:
        reason = getattr(error, "strerror", None) or "not a readable image"
        raise FlowError(f"{path}: {reason}") from None
    return pixels


def png(array: Array) -> bytes:
    _, image = libraries()
    data = io.BytesIO()
    image.fromarray(array).save(data, "PNG")
    return data.getvalue()


def rgb(color: str) -> tuple[int, int, int]:
    """Of "#rrggbb"."""
    return int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)


def disparity_colors(values: Array, low: float, high: float) -> Array:
    """RGB of disparities in pixels."""
    numpy, _ = libraries()
    from matplotlib import colormaps

    share = (numpy.asarray(values, float) - low) / max(high - low, 1)
    shown = numpy.asarray(colormaps[COLORS](numpy.clip(share, 0, 1)))[..., :3]
    colors: Array = (shown * 255).round().astype(numpy.uint8)
    return colors


def scale_png() -> bytes:
    numpy, _ = libraries()
    return png(disparity_colors(numpy.arange(256)[None, :], 0, 255))


def scale_labels(low: int, high: int) -> tuple[str, str, str]:
    middle = (low + high) / 2
    return f"{low} px", f"{middle:g}", f"{high} px"


def blank(width: int, height: int) -> Array:
    """The stripes of an image without a map."""
    numpy, _ = libraries()
    stripes = (numpy.add.outer(numpy.arange(height), numpy.arange(width)) // 4 % 2).astype(bool)
    colors: Array = numpy.where(stripes[..., None], rgb(NO_RANGE[0]), rgb(NO_RANGE[1])).astype(numpy.uint8)
    return colors
