# SPDX-License-Identifier: Apache-2.0
"""A pair, what was found and how wrong it is, in one picture. Needs matplotlib, and Pillow, which comes with it."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..base.errors import FlowError
from ..base.tools import Word, find_stereo_hls, run
from .pairs import Pair

# Errors in pixels and their colours; grey: no truth, black: no disparity.
_STEPS = (
    (0, "#313695"),
    (0.5, "#4575b4"),
    (1, "#abd9e9"),
    (2, "#fee090"),
    (3, "#fdae61"),
    (5, "#f46d43"),
    (10, "#a50026"),
)
_NO_TRUTH, _NO_DISPARITY = (0.75, 0.75, 0.75), (0.0, 0.0, 0.0)


def read_pfm(path: Path) -> Any:
    """Rows from the top; what is unknown is infinite."""
    import numpy

    with path.open("rb") as file:
        if file.readline().strip() != b"Pf":
            raise ValueError(f"{path} is no PFM of one channel")
        width, height = map(int, file.readline().split())
        order = "<" if float(file.readline()) < 0 else ">"
        pixels = numpy.frombuffer(file.read(4 * width * height), dtype=f"{order}f4")
    return pixels.reshape(height, width)[::-1]


def read_truth(pair: Pair) -> Any:
    """In pixels; not finite where it is unknown. A format that evaluate takes and this does not is refused."""
    import numpy
    from PIL import Image

    try:
        if pair.truth_left.suffix == ".pfm":
            return read_pfm(pair.truth_left) / pair.truth_scale
        loaded = numpy.load(pair.truth_left) if pair.truth_left.suffix == ".npy" else Image.open(pair.truth_left)
        values = numpy.asarray(loaded).astype(float)
        if values.ndim != 2:
            raise ValueError("it has more than one channel")
    except (OSError, ValueError) as error:
        raise FlowError(f"{pair.truth_left} cannot be drawn: {error}") from error
    return numpy.where(values > 0, values / pair.truth_scale, numpy.inf)


def error_colors(disparity: Any, truth: Any) -> Any:
    """RGB, 0 ... 1."""
    import numpy
    from matplotlib.colors import to_rgb

    known, found = numpy.isfinite(truth), numpy.isfinite(disparity)
    error = numpy.abs(numpy.where(known & found, disparity, 0) - numpy.where(known & found, truth, 0))
    colors = numpy.empty((*truth.shape, 3))
    colors[:] = _NO_TRUTH
    for least, color in _STEPS:
        colors[known & found & (error >= least)] = to_rgb(color)
    colors[known & ~found] = _NO_DISPARITY
    return colors


def draw(pair: Pair, config: str, settings: Sequence[str], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy
    from matplotlib.patches import Patch

    with tempfile.TemporaryDirectory() as folder:
        words: list[Word] = [word for setting in settings for word in ("--set", setting)]
        images: list[Word] = ["--left", pair.left, "--right", pair.right]
        run([find_stereo_hls(), "match", *images, "--config", config, *words, "--write", "pfm", "--out", folder])
        disparity = read_pfm(Path(folder) / "disparity.pfm")
    truth = read_truth(pair)
    width = 12.0
    figure, axes = plt.subplots(3, 1, figsize=(width, 3 * width * truth.shape[0] / truth.shape[1] + 1.4))
    axes[0].imshow(plt.imread(pair.left), cmap="gray")
    axes[1].imshow(numpy.where(numpy.isfinite(disparity), disparity, numpy.nan), cmap="turbo")
    axes[2].imshow(error_colors(disparity, truth), interpolation="nearest")
    for axis, title in zip(axes, (f"{pair.title}: left image", f"disparity, {config}", "error")):
        axis.set_title(title, loc="left")
        axis.axis("off")
    patches = [Patch(color=color, label=f"{least:g} px or more") for least, color in _STEPS]
    patches += [Patch(color=_NO_TRUTH, label="no truth"), Patch(color=_NO_DISPARITY, label="no disparity")]
    figure.legend(handles=patches, ncol=len(patches) // 2 + 1, loc="lower center", frameon=False)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=100)
    plt.close(figure)
