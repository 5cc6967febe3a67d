# SPDX-License-Identifier: Apache-2.0
"""The quality-cost front of a parameter study: as a picture and as a short table."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import TYPE_CHECKING

from ..base.markdown import number
from ..rendering import labels, plots
from . import explore, hardware_cost
from .explore import Row

if TYPE_CHECKING:
    from rich.table import Table

_COLORS = {"sad": "#1f5fa8", "ssd": "#c05a00", "census": "#2b7a3d"}
_OTHER_COLOR = "#8a2be2"  # of other families
ABSENT_SHOWN = 5
_ABSENT_PLACE = 0.985  # of the panel's width


def draw(table: list[Row], key: str, title: str, luts_title: Callable[[int], str]) -> bytes:
    """PNG: one panel for each range."""
    figure = panels(table, key, title, luts_title)
    data = io.BytesIO()
    figure.savefig(data, format="png")
    plots.pyplot().close(figure)
    return data.getvalue()


def panels(table: list[Row], key: str, title: str, luts_title: Callable[[int], str]) -> plots.Figure:
    pyplot = plots.pyplot()
    ranges = sorted({row["disparities"] for row in table})
    figure, axes = pyplot.subplots(
        len(ranges), 1, figsize=(9, 5.6 * len(ranges)), dpi=120, squeeze=False, layout="constrained"
    )
    for axis, disparities in zip(axes[:, 0], ranges):
        _points(axis, table, key, disparities)
        _frame(axis)
        axis.set_xlabel(luts_title(disparities))
        axis.set_ylabel(title)
        axis.set_title(f"{disparities} disparities", loc="left", fontsize=11)
        axis.legend(fontsize=8, frameon=True)
    figure.draw_without_rendering()  # makes the layout, in which the names find their places
    for axis, disparities in zip(axes[:, 0], ranges):
        _name_front(axis, table, key, disparities)
    return figure


def _points(axis: plots.Axis, table: list[Row], key: str, disparities: int) -> None:
    """The choices of one range, the front as a line, and at the right border those whose cost is absent."""
    rows = [row for row in table if row["disparities"] == disparities and row[key] is not None]
    _scatter(axis, rows, key)
    members = explore.front(table, disparities)
    luts, values = [row["luts"] for row in members], [row[key] for row in members]
    axis.step(luts, values, where="post", color="#777777", linewidth=1, zorder=2)
    absent = [row[key] for row in rows if row["luts"] is None]
    if absent:
        axis.plot(
            [_ABSENT_PLACE] * len(absent),
            absent,
            marker="_",
            linestyle="none",
            color="#888888",
            markersize=16,
            alpha=0.6,
            transform=axis.get_yaxis_transform(),
            label=f"cost absent ({len(absent)})",
            zorder=3,
        )


def _scatter(axis: plots.Axis, rows: list[Row], key: str) -> None:
    """Measured points are filled, estimated ones hollow, one colour for each cost."""
    for cost in dict.fromkeys([*_COLORS, *(row["cost"] for row in rows)]):
        color = _COLORS.get(cost, _OTHER_COLOR)
        for kind, face in ((hardware_cost.MEASURED, color), (hardware_cost.ESTIMATE, "none")):
            members = [row for row in rows if row["cost"] == cost and row["luts_are"] == kind]
            if members:
                axis.scatter(
                    [row["luts"] for row in members],
                    [row[key] for row in members],
                    s=34,
                    facecolors=face,
                    edgecolors=color,
                    linewidths=1.2,
                    label=f"{cost}, {kind}",
                    zorder=3,
                )


def _name_front(axis: plots.Axis, table: list[Row], key: str, disparities: int) -> None:
    """Names at the points of the front, clear of each other, of all points and of the legend."""
    rows = [row for row in table if row["disparities"] == disparities and row[key] is not None]
    shown = axis.transData.transform([(row["luts"], row[key]) for row in rows if row["luts"] is not None] or [(0, 1)])
    border = axis.get_yaxis_transform()
    shown = [*shown, *(border.transform((_ABSENT_PLACE, row[key])) for row in rows if row["luts"] is None)]
    names = [
        (row["title"].replace("left_right", "L/R").replace(" left", " left ref."), (row["luts"], row[key]))
        for row in explore.front(table, disparities)
    ]
    labels.place(axis, names, [(x, y) for x, y in shown])


def _frame(axis: plots.Axis) -> None:
    from matplotlib import ticker

    axis.set_yscale("log")
    for which in (axis.yaxis.set_major_formatter, axis.yaxis.set_minor_formatter):
        which(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
    axis.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:,.0f}"))
    axis.tick_params(axis="y", which="minor", labelsize=8)
    axis.grid(True, which="both", color="#e8e8e8", linewidth=0.7, zorder=0)
    axis.margins(x=0.14, y=0.12)


def tables(table: list[Row], key: str, title: str) -> list[Table]:
    """The front of each range, and the best choices whose cost is not known."""
    made = [_front_table(table, key, title, disparities) for disparities in sorted({r["disparities"] for r in table})]
    absent = sorted((row for row in table if row["luts"] is None), key=lambda row: _worst_last(row[key]))
    if absent:
        heading = f"The best {min(len(absent), ABSENT_SHOWN)} of {len(absent)} choices whose cost is absent"
        best = _table(heading, "D", "not measured")
        for row in absent[:ABSENT_SHOWN]:
            best.add_row(*_start(row, key), str(row["disparities"]), ", ".join(row["luts_missing"]))
        made.append(best)
    return made


def _front_table(table: list[Row], key: str, title: str, disparities: int) -> Table:
    heading = f"Worth their LUTs, {disparities} disparities: any better one costs more. {title}"
    made = _table(heading, "LUT4", "they are", "better for each 1,000 LUT4")
    before = None
    for row in explore.front(table, disparities):
        gain = f"{1000 * (before[key] - row[key]) / (row['luts'] - before['luts']):.2f}" if before else "-"
        made.add_row(*_start(row, key), f"{row['luts']:,}", row["luts_are"], gain)
        before = row
    return made


def _worst_last(value: float | None) -> float:
    return float("inf") if value is None else value


def _start(row: Row, key: str) -> tuple[str, str, str]:
    """The cells that every table begins with."""
    return row["title"], number(row[key], 2), number(row["density_percent"], 1)


def _table(heading: str, *columns: str) -> Table:
    from rich.table import Table

    made = Table(title=heading, title_justify="left", title_style="bold")
    for column in ("options", "%", "density", *columns):
        is_text = column in ("options", "they are", "not measured")
        made.add_column(column, justify="left" if is_text else "right", overflow="fold")
    return made
