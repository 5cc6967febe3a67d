# SPDX-License-Identifier: Apache-2.0
"""Pieces of the pages that commands write."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from .errors import FlowError

UNKNOWN = "-"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value: float | None, digits: int = 0) -> str:
    return UNKNOWN if value is None else f"{value:,.{digits}f}"


def code(command: str) -> str:
    return f"`{command}`"


def replaced(page: Path, begin: str, end: str, inside: str) -> str:
    """The text of a page with what stands between its two marks made anew."""
    before, first, rest = page.read_text().partition(begin)
    _, second, after = rest.partition(end)
    if not first or not second:
        raise FlowError(f"{page.name} has no place for what belongs between '{begin}' and '{end}'")
    return f"{before}{begin}\n{inside}\n{end}{after}"
