# SPDX-License-Identifier: Apache-2.0
"""summary.html: what a regression gave, one row a configuration, with links to the files of each."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..base import files
from ..rendering import page

NAME = "summary.html"
LINKED = ("failure.html", "report.json", "log.txt")


def write(folder: Path, summary: Mapping[str, Any]) -> str:
    """Writes the page into the folder of the regression. Returns why it did not, where the Python lacks jinja2."""
    kept = {}
    for run in summary["runs"]:
        name = f"{run['config']}-{run['simulator']}"
        kept[run["config"]] = [f"{name}/{file}" for file in LINKED if (folder / name / file).is_file()]
    try:
        files.write(folder / NAME, page.render("regression.html.j2", summary=_defined(summary), files=kept))
    except ModuleNotFoundError as error:
        return f"no {NAME}: the Python package {error.name} is missing"
    return ""


def _defined(summary: Mapping[str, Any]) -> dict[str, Any]:
    """With the members that the template asks for, where a run came to no result."""
    empty = {"initiation_interval": None, "first_register": None, "first_mismatch": None}
    return {**summary, "runs": [{**run, "report": {**empty, **run["report"]}} for run in summary["runs"]]}
