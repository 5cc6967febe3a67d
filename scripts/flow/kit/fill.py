# SPDX-License-Identifier: Apache-2.0
"""Templates with @{names}: `$`, braces and brackets mean something in Tcl."""

import string
from pathlib import Path

TEMPLATES = Path(__file__).parent / "templates"


class _Text(string.Template):
    delimiter = "@"


def fill(template: str, /, **values: str) -> str:
    """A file of templates/, each of its names replaced."""
    return _Text((TEMPLATES / template).read_text()).substitute(values)
