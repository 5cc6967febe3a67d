# SPDX-License-Identifier: Apache-2.0
"""The part of docs/quality.md on roads, rooms and a yard: our rows and OpenCV's on pairs of a list, whole images."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from ..base.markdown import table
from ..quality import error_picture
from ..quality.evaluation import Method, evaluate
from ..quality.pairs import OWN_LIST, Pair, read_pairs
from .quality import TEXTS, percent

OPENCV = ("bm", "sgbm", "sgbm_3way", "sgbm_hh")
_FULL = ("full_width=true",)
# What semi-global matching had before it was chosen on roads, too; the later rows change one thing of `sgm_450`.
_FIRST = (
    *("census_width_px=5", "census_pattern=all", "cost_shift=4", "cost_cap=4095", "p1=5", "p2=22"),
    *("p2_least=-1", "above_p1=-1", "above_p2=-1"),
)


class Row(NamedTuple):
    title: str
    config: str
    settings: tuple[str, ...] = ()


ROWS = (
    Row("semi-global, `sgm_450`", "sgm_450", _FULL),
    Row("P2 the same everywhere", "sgm_450", (*_FULL, "p2_least=-1")),
    Row("the rows' penalties from above", "sgm_450", (*_FULL, "above_p1=-1", "above_p2=-1")),
    Row("cap 15 instead of 5", "sgm_450", (*_FULL, "cost_cap=15")),
    Row(
        "census 9x5, checkerboard: 22 bits instead of 14",
        "sgm_450",
        (*_FULL, "census_pattern=checkerboard", "cost_shift=4"),
    ),
    Row("census 9x5, all 44 bits", "sgm_450", (*_FULL, "census_pattern=all", "cost_shift=5")),
    Row("census 5x5, 24 bits, P1 5, P2 22: the first parameters", "sgm_450", (*_FULL, *_FIRST)),
    Row("semi-global, single pixels, `sgm_640`, not of full width", "sgm_640"),
    Row("block matching, `census_450`", "census_450", _FULL),
    Row("census 9x3, all 26 bits", "census_450", (*_FULL, "census_height_px=3", "census_pattern=all")),
    Row("census 9x7, even columns: 34 bits", "census_450", (*_FULL, "census_height_px=7")),
    Row("SAD 3x3, the paper's, left reference", "ambrosch2007", (*_FULL, "reference=left")),
    Row("trellis, `trellis_1300`, not of full width", "trellis_1300", ("mark_occluded=false",)),
    Row("phase correlation, 2 scales, left reference", "parts_320", (*_FULL, "reference=left")),
)

Measured = dict[str, Method]  # by title, OpenCV's first


def measure(pair: Pair) -> Measured:
    images = [*pair.images, "--border", 0]
    matchers = [word for name in OPENCV for word in ("--opencv", name)]
    found = {
        method["name"]: method for method in evaluate(*images, *matchers, "--opencv-disparities", pair.disparities)
    }
    for row in ROWS:
        settings = (*row.settings, f"disparities={pair.disparities}")
        words = [word for setting in settings for word in ("--set", setting)]
        (found[row.title],) = evaluate(*images, "--config", row.config, *words)
    return found


def dense_d1(method: Method) -> float:
    """Fraction of the pixels with truth; what has no disparity is wrong."""
    fraction: float = method["masks"]["all"]["d1"]["invalid_bad"]
    return fraction


def overview_table(pairs: Sequence[Pair], results: Sequence[Measured]) -> str:
    rows = [[title, *(percent(dense_d1(result[title])) for result in results)] for title in results[0]]
    return table(["D1, dense", *(pair.title for pair in pairs)], rows)


def pair_table(result: Measured) -> str:
    rows = []
    for title, method in result.items():
        mask = method["masks"]["all"]
        dense = (percent(mask[name]["invalid_bad"]) for name in ("d1", "bad_1", "bad_2"))
        valid = (percent(mask[name]["valid_only"]) for name in ("d1", "bad_1", "bad_2"))
        rows.append([title, *dense, *valid, percent(mask["density"])])
    titles = ("D1", "bad 1", "bad 2")
    return table(["method", *titles, *(f"{title} of valid" for title in titles), "density"], rows)


def tables(pairs: Sequence[Pair]) -> tuple[str, str]:
    """D1 of all pairs side by side, and what each pair shows in full."""
    results = [measure(pair) for pair in pairs]
    parts = [f"### {pair.title}\n\n{pair_table(result)}" for pair, result in zip(pairs, results)]
    return overview_table(pairs, results), "\n\n".join(parts)


def text(pairs: Sequence[Pair]) -> str:
    overview, parts = tables(pairs)
    return (TEXTS / "quality_pairs.md").read_text().format(overview=overview, pairs=parts).rstrip()


def draw_pictures(pairs: Iterable[Pair], folder: Path) -> None:
    for pair in pairs:
        for row in (ROWS[0], next(row for row in ROWS if row.config == "census_450")):
            path = folder / f"{pair.name}_{row.config}.png"
            error_picture.draw(pair, row.config, (*row.settings, f"disparities={pair.disparities}"), path)
            print(path)


def own_pairs() -> list[Pair]:
    return read_pairs(OWN_LIST)
