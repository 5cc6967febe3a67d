# SPDX-License-Identifier: Apache-2.0
"""The quality-cost front of a parameter study: as a picture and as a short table."""

import io

from rich.table import Table

from ..rendering import pictures
from . import explore, hardware_cost

_COLORS = {"sad": "#1f5fa8", "ssd": "#c05a00", "census": "#2b7a3d"}
ABSENT_SHOWN = 5


def _scatter(axis, rows, key):
    """Measured points are filled, estimated ones hollow, one colour for each cost."""
    for cost, color in _COLORS.items():
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


def _label(row):
    return row["title"].replace("left_right", "L/R").replace(" left", " left ref.")


def _annotate(axis, members, key):
    """Names of the points of the front, stepping upwards to the right so that they do not cover each other."""
    for number, row in enumerate(members):
        axis.annotate(
            _label(row),
            (row["luts"], row[key]),
            textcoords="offset points",
            xytext=(8, 8 + 9 * (number % 2)),
            fontsize=8,
            color="#333333",
            zorder=4,
        )


def draw(table, key, title, luts_title):
    """PNG: one panel for each range."""
    pictures.libraries()
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot, ticker

    ranges = sorted({row["disparities"] for row in table})
    figure, axes = pyplot.subplots(
        len(ranges), 1, figsize=(9, 5.6 * len(ranges)), dpi=120, squeeze=False, layout="constrained"
    )
    for axis, disparities in zip(axes[:, 0], ranges):
        rows = [row for row in table if row["disparities"] == disparities]
        _scatter(axis, rows, key)
        members = explore.front(table, disparities)
        axis.step(
            [row["luts"] for row in members],
            [row[key] for row in members],
            where="post",
            color="#777777",
            linewidth=1,
            zorder=2,
        )
        _annotate(axis, members, key)
        absent = [row[key] for row in rows if row["luts"] is None]
        if absent:
            axis.plot(
                [0.985] * len(absent),
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
        axis.set_yscale("log")
        for which in (axis.yaxis.set_major_formatter, axis.yaxis.set_minor_formatter):
            which(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:,.0f}"))
        axis.tick_params(axis="y", which="minor", labelsize=8)
        axis.set_xlabel(luts_title(disparities))
        axis.set_ylabel(title)
        axis.set_title(f"{disparities} disparities", loc="left", fontsize=11)
        axis.grid(True, which="both", color="#e8e8e8", linewidth=0.7, zorder=0)
        axis.margins(x=0.14, y=0.12)
        axis.legend(fontsize=8, frameon=True)
    data = io.BytesIO()
    figure.savefig(data, format="png")
    pyplot.close(figure)
    return data.getvalue()


def tables(table, key, title):
    """rich tables: the front of each range, and the best choices whose cost is not known."""
    made = []
    for disparities in sorted({row["disparities"] for row in table}):
        members = explore.front(table, disparities)
        front = _table(
            f"Worth their LUTs, {disparities} disparities: any better one costs more. {title}",
            "LUT4",
            "they are",
            "better for each 1,000 LUT4",
        )
        for number, row in enumerate(members):
            before = members[number - 1] if number else None
            gain = f"{1000 * (before[key] - row[key]) / (row['luts'] - before['luts']):.2f}" if before else "-"
            front.add_row(
                row["title"],
                f"{row[key]:.2f}",
                f"{row['density_percent']:.1f}",
                f"{row['luts']:,}",
                row["luts_are"],
                gain,
            )
        made.append(front)
    absent = sorted((row for row in table if row["luts"] is None), key=lambda row: row[key])
    if absent:
        best = _table(
            f"The best {min(len(absent), ABSENT_SHOWN)} of {len(absent)} choices whose cost is absent",
            "D",
            "not measured",
            None,
        )
        for row in absent[:ABSENT_SHOWN]:
            best.add_row(
                row["title"],
                f"{row[key]:.2f}",
                f"{row['density_percent']:.1f}",
                str(row["disparities"]),
                ", ".join(row["luts_missing"]),
            )
        made.append(best)
    return made


def _table(heading, *columns):
    made = Table(title=heading, title_justify="left", title_style="bold")
    for column in ("options", "%", "density", *columns):
        if column:
            made.add_column(
                column,
                justify="left" if column in ("options", "they are", "not measured") else "right",
                overflow="fold",
            )
    return made
