# SPDX-License-Identifier: Apache-2.0
"""HTML pages that stand alone: templates in templates/, pictures inside, no network."""

from __future__ import annotations

import base64
import re
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from markupsafe import Markup

TEMPLATES = Path(__file__).with_name("templates")


def number(value: float | None, digits: int = 0) -> str:
    """12345 as 12,345; nothing as a dash."""
    return "–" if value is None else f"{value:,.{digits}f}"


def percent(part: float, whole: float) -> float:
    return 100 * part / max(whole, 1)


def png_uri(png: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(png).decode()


def cell(text: str) -> Markup:
    """A table's cell as the pages in docs/ write it: `code` in back quotes, - for a number that is not known."""
    from markupsafe import Markup, escape

    if text == "-":
        return Markup("–")
    return Markup(re.sub(r"`([^`]*)`", r"<code>\1</code>", str(escape(text))))


def is_number(text: str) -> bool:
    """Whether a cell belongs to a column of numbers."""
    return re.fullmatch(r"[-–]|[-+]?[\d,]+(\.\d+)?", text) is not None


def render(template: str, **values: object) -> str:
    import jinja2  # here, as most commands render nothing

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"number": number, "cell": cell, "png_uri": png_uri}
    environment.tests["numeric"] = is_number
    return environment.get_template(template).render(**values, percent=percent)
