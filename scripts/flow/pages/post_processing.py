# SPDX-License-Identifier: Apache-2.0
"""docs/post_processing.md: what each stage of the post-processing does to a map, measured by `stereo_hls evaluate`."""

from __future__ import annotations

import base64
import hashlib
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from ..base.files import drawn_from
from ..base.markdown import number, table
from ..base.tools import ROOT, Word, find_stereo_hls, run
from ..quality.evaluation import SCENE_SIZE, Measures, Method, evaluate
from ..quality.pairs import OWN_LIST, Pair, read_pairs
from ..rendering import pictures
from .quality import pair_images, percent

PAGE = ROOT / "docs" / "post_processing.md"
PICTURE = ROOT / "docs" / "images" / "post_processing.svg"
TEXT = Path(__file__).parent / "texts" / "post_processing.md"
DISPARITIES = 64
SCENE_SEEDS, SCENE_NOISE = (1, 2, 3, 4), 2
SUREST_PERCENT, SURE = 80, 128

# The stages of the rows with all of them, off.
_UNCHECKED = ("left_right_threshold=-1",)
_UNFILTERED = ("support_threshold=0", "confidence=false")
_UNFILLED = ("fill_holes=false",)
_NO_BORDER = ("border_cost=-1",)
_WINNERS = (*_UNCHECKED, *_UNFILTERED, *_UNFILLED)
_CENSUS = ("census_height_px=3", "census_pattern=all", f"disparities={DISPARITIES}")


class Row(NamedTuple):
    title: str
    config: str
    settings: tuple[str, ...]


SEMI_GLOBAL = (
    Row("winners", "sgm_450_dense", (*_NO_BORDER, *_WINNERS)),
    Row("left/right check", "sgm_450_dense", (*_NO_BORDER, *_UNFILTERED, *_UNFILLED)),
    Row("border cost", "sgm_450_dense", _WINNERS),
    Row("border cost, check, holes filled", "sgm_450_dense", _UNFILTERED),
    Row("border cost, check, support", "sgm_450_dense", _UNFILLED),
    Row("all stages", "sgm_450_dense", ()),
)
BLOCK_MATCHING = (
    Row("winners", "census_450_dense", (*_CENSUS, *_WINNERS)),
    Row("left/right check", "census_450_dense", (*_CENSUS, *_UNFILTERED, *_UNFILLED)),
    Row("check, holes filled", "census_450_dense", (*_CENSUS, *_UNFILTERED)),
    Row("check, support", "census_450_dense", (*_CENSUS, *_UNFILLED)),
    Row("all stages", "census_450_dense", _CENSUS),
)
OUTDOORS = (
    Row("winners of `sgm_450`", "sgm_450", ("full_width=true", "subpixel=true")),
    Row("winners of `sgm_450_dense`", "sgm_450_dense", (*_NO_BORDER, *_WINNERS)),
    Row("all stages", "sgm_450_dense", ()),
)
FAMILIES = {"semi-global matching": SEMI_GLOBAL, "block matching, census 9x3, window 9x9": BLOCK_MATCHING}


def words_of(row: Row) -> list[Word]:
    return ["--config", row.config, *(word for setting in row.settings for word in ("--set", setting))]


def measure(images: Sequence[Word], row: Row, *more: Word) -> Method:
    (method,) = evaluate(*images, *words_of(row), *more)
    return method


def scene(seed: int, folder: Path) -> list[Word]:
    """Options of `evaluate`."""
    command: list[Word] = [find_stereo_hls(), "scene", *SCENE_SIZE, "--disparities", DISPARITIES, "--seed", seed]
    run([*command, "--noise", SCENE_NOISE, "--out", folder], passes_errors=True)
    names = {"--left": "left", "--right": "right", "--truth-left": "disparity_left", "--truth-right": "disparity_right"}
    return [word for option, name in names.items() for word in (option, folder / f"{name}.png")]


def _mean(values: Iterable[float]) -> float:
    known = list(values)
    return sum(known) / len(known)


def _both(masks: Sequence[Measures], share: str) -> str:
    """Bad 1 and bad 2."""
    return " / ".join(percent(_mean(mask[bad][share] for mask in masks)) for bad in ("bad_1", "bad_2"))


def stages_table(rows: Sequence[Row], runs: Sequence[Sequence[Word]]) -> str:
    """Means over the runs; a run is the options of a pair."""
    lines = []
    for row in rows:
        methods = [measure(images, row) for images in runs]
        everywhere, seen = ([m["masks"][mask] for m in methods] for mask in ("all", "non_occluded"))
        density = percent(_mean(mask["density"] for mask in everywhere))
        cells = [density, _both(everywhere, "invalid_bad"), _both(everywhere, "valid_only"), _both(seen, "invalid_bad")]
        lines.append([row.title, *cells])
    heads = ("all pixels", "all pixels of those that have a value", "non-occluded pixels")
    return table(["map", "density", *(f"bad 1 / bad 2, {head}" for head in heads)], lines)


def confidence_table(runs: Sequence[Sequence[Word]]) -> str:
    """What the confidence says of measured pixels."""
    lines = []
    for family, rows in FAMILIES.items():
        dense = rows[-1]
        for title, words in (
            ("measured pixels", ("--measured-only",)),
            (f"confidence {SURE} or more", ("--least-confidence", SURE)),
            (f"the surest {SUREST_PERCENT} %", ("--surest", SUREST_PERCENT)),
        ):
            masks = [measure(images, dense, *words)["masks"]["all"] for images in runs]
            density = percent(_mean(mask["density"] for mask in masks))
            lines.append([family, title, density, _both(masks, "valid_only")])
    return table(["matcher", "pixels", "density", "bad 1 / bad 2 of them"], lines)


def outdoors_table(pairs: Sequence[Pair]) -> str:
    """Whole images; the truth of such a pair has no mask of occluded pixels."""
    lines = []
    for row in OUTDOORS:
        masks = [
            measure(pair.images, row, "--border", 0, "--set", f"disparities={pair.disparities}")["masks"]["all"]
            for pair in pairs
        ]
        cells = (" / ".join(percent(mask[bad]["invalid_bad"]) for bad in ("d1", "bad_1", "bad_2")) for mask in masks)
        lines.append([row.title, *cells])
    return table(["D1 / bad 1 / bad 2", *(pair.title for pair in pairs)], lines)


def outdoor_pairs() -> list[Pair]:
    """Of the project's own list."""
    return [pair for pair in read_pairs(OWN_LIST) if pair.name != "teddy"]


class Shown(NamedTuple):
    """A picture of the page."""

    title: str
    png: Path
    digest: str  # of what it shows


def _shown(row: Row, images: Sequence[Word], folder: Path) -> list[Shown]:
    command: list[Word] = [find_stereo_hls(), "match", *images[:4], *words_of(row), "--out", folder]
    run(command, passes_errors=True)
    found = [Shown(row.title, folder / "disparity_color.png", _digest(folder, ("disparity.png", "valid.png")))]
    if row is SEMI_GLOBAL[-1]:
        found.append(Shown("confidence", folder / "confidence.png", _digest(folder, ("confidence.png",))))
    return found


def _digest(folder: Path, names: Iterable[str]) -> str:
    data = b"".join(pictures.load(folder / name).tobytes() for name in names if (folder / name).is_file())
    return hashlib.sha256(data).hexdigest()[:16]


def picture() -> str:
    """The SVG: the left image and the map behind each stage, on a generated scene."""
    with tempfile.TemporaryDirectory() as work:
        images = scene(SCENE_SEEDS[0], Path(work) / "scene")
        left = Path(str(images[1]))
        shown = [Shown("left image", left, _digest(left.parent, (left.name,)))]
        for number_of, row in enumerate(SEMI_GLOBAL):
            shown += _shown(row, images, Path(work) / str(number_of))
        return _svg(shown)


def _smaller(path: Path, width: int, height: int) -> bytes:
    numpy, pil = pictures.libraries()
    image = pil.fromarray(pictures.load(path)).resize((width, height), pil.Resampling.NEAREST)
    return pictures.png(numpy.asarray(image))


def _svg(shown: Sequence[Shown], columns: int = 4, width: int = 225, height: int = 188, head: int = 16) -> str:
    rows = -(-len(shown) // columns)
    size = f"{columns * (width + 6)} {rows * (height + head + 6)}"
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size}" font-family="sans-serif" font-size="11">']
    parts.append(drawn_from(" ".join(f"{one.title.replace(' ', '_')}={one.digest}" for one in shown)))
    for place, one in enumerate(shown):
        x, y = place % columns * (width + 6), place // columns * (height + head + 6)
        data = base64.b64encode(_smaller(one.png, width, height)).decode()
        parts.append(f'<text x="{x}" y="{y + 12}">{one.title}</text>')
        parts.append(
            f'<image x="{x}" y="{y + head}" width="{width}" height="{height}" href="data:image/png;base64,{data}"/>'
        )
    return "\n".join([*parts, "</svg>", ""])


def pages(pair: Path, outdoors: Sequence[Pair]) -> dict[Path, str]:
    with tempfile.TemporaryDirectory() as work:
        scenes = [scene(seed, Path(work) / str(seed)) for seed in SCENE_SEEDS]
        runs = {"teddy": [pair_images(pair)], "scenes": scenes}
        parts = {}
        for name, of_runs in runs.items():
            for family, rows in zip(("sgm", "census"), FAMILIES.values()):
                parts[f"{name}_{family}"] = stages_table(rows, of_runs)
            parts[f"{name}_confidence"] = confidence_table(of_runs)
    parts["outdoors"] = outdoors_table(outdoors)
    seeds = f"{SCENE_SEEDS[0]} to {SCENE_SEEDS[-1]}"
    text = TEXT.read_text().format(
        disparities=DISPARITIES, seeds=seeds, noise=number(SCENE_NOISE, 0), sure=SURE, surest=SUREST_PERCENT, **parts
    )
    return {PAGE: text, PICTURE: picture()}
