# SPDX-License-Identifier: Apache-2.0
"""The algorithms that plan.py plans with: rows of docs/quality.md, with what is measured there."""

from __future__ import annotations

from ..base.configurations import configuration, configurations
from ..planning import cores
from ..planning.candidates import Algorithm, value_of
from . import products, quality, quality_pairs


def algorithms() -> list[Algorithm]:
    """Those whose families' cores are modelled. A row's full width is no part of an algorithm."""
    table, measured = configurations(), products.measured(quality.PAGE.read_text())
    found = []
    for row in quality_pairs.ROWS:
        if configuration(row.config, table)["family"] not in cores.FAMILIES or row.title not in measured:
            continue
        settings = {name: value_of(text) for name, _, text in (setting.partition("=") for setting in row.settings)}
        settings.pop("full_width", None)
        found.append(Algorithm(row.title, row.config, settings, dict(zip(products.PAIRS, measured[row.title]))))
    return found
