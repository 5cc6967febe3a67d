# SPDX-License-Identifier: Apache-2.0
"""VHDL through NVC, where it is installed."""

from __future__ import annotations

from . import ghdl
from .tools import Word, find_nvc, tool_version

# NVC gives a design unit 16 MiB by itself; a core of 640x480 with 128 disparities needs more.
UNIT_MEMORY = "512m"


def version() -> str:
    return tool_version(find_nvc())


def start(standard: str = ghdl.STANDARD) -> list[Word]:
    """How its commands begin."""
    return [find_nvc(), standard, "-M", UNIT_MEMORY]
