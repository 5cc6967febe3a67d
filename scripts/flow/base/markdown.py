# SPDX-License-Identifier: Apache-2.0
"""Pieces of the pages that commands write."""

UNKNOWN = "-"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def number(value, digits=0):
    return UNKNOWN if value is None else f"{value:,.{digits}f}"


def code(command):
    return f"`{command}`"
