# SPDX-License-Identifier: Apache-2.0
"""Plain least squares of a few unknowns."""

from __future__ import annotations

from collections.abc import Sequence

Row = Sequence[float]


def fit(rows: Sequence[Row], values: Row) -> list[float]:
    """The x that makes the sum of the squares of rows * x - values smallest. A column that is 0 everywhere, or that
    says nothing beside the columns before it, gets 0. Nothing of no rows."""
    count = len(rows[0]) if rows else 0
    matrix = [
        [sum(row[i] * row[j] for row in rows) for j in range(count)]
        + [sum(row[i] * value for row, value in zip(rows, values))]
        for i in range(count)
    ]
    scale = [matrix[i][i] for i in range(count)]
    kept = []
    for i in range(count):
        if matrix[i][i] <= 1e-9 * scale[i]:
            continue
        kept.append(i)
        for j in range(count):
            if j != i:
                factor = matrix[j][i] / matrix[i][i]
                matrix[j] = [a - factor * b for a, b in zip(matrix[j], matrix[i])]
    return [matrix[i][count] / matrix[i][i] if i in kept else 0.0 for i in range(count)]
