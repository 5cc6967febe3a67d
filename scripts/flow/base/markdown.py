# SPDX-License-Identifier: Apache-2.0
"""Pieces of the pages that commands write."""

from collections.abc import Iterable, Sequence

UNKNOWN = "-"


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value: float | None, digits: int = 0) -> str:
    return UNKNOWN if value is None else f"{value:,.{digits}f}"


def code(command: str) -> str:
    return f"`{command}`"
