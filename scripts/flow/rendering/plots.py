# SPDX-License-Identifier: Apache-2.0
"""Diagrams by matplotlib."""

import io
import json
from collections.abc import Callable
from typing import Any

from ..base import files
from ..base.errors import EXIT_MISSING_TOOL, FlowError

Axis = Any  # of matplotlib, which has no types
Figure = Any


def pyplot() -> Any:
    """matplotlib's, without a screen."""
    try:
        import matplotlib
    except ImportError:
        raise FlowError(
            "the Python package matplotlib is missing; on Debian: apt-get install python3-matplotlib",
            EXIT_MISSING_TOOL,
        ) from None
    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot


def svg(name: str, size: tuple[float, float], data: Any, draw: Callable[[Axis], None], layout: str = "none") -> str:
    """A diagram. One version of matplotlib draws the same file everywhere: text stays text, and the names of its parts
    follow from `name`. Another version draws other curves, so the file also says what it shows: `data`, as JSON."""
    plots = pyplot()
    with plots.rc_context({"svg.fonttype": "none", "svg.hashsalt": name, "font.size": 8}):
        figure, axis = plots.subplots(figsize=size, layout=layout)
        draw(axis)
        output = io.StringIO()
        figure.savefig(output, format="svg", metadata={"Date": None, "Creator": None})
        plots.close(figure)
    lines = [line.rstrip() for line in output.getvalue().splitlines()]
    return "\n".join([*lines, files.drawn_from(json.dumps(data)), ""])
