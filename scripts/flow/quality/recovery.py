# SPDX-License-Identifier: Apache-2.0
"""How fast a search window that follows the scene finds what is new: bad pixels of each frame of a moving scene, beside
a search of the whole range. The 2007 paper rejects such systems for the frames that they need."""

import tempfile
from collections.abc import Iterable
from pathlib import Path

from ..base.markdown import number, replaced, table
from ..base.tools import ROOT, Word, find_stereo_hls, run
from ..rendering.plots import Axis, svg
from .evaluation import evaluate

PAGE = ROOT / "docs" / "dynamic_range.md"
PICTURE = ROOT / "docs" / "images" / "recovery.svg"
BEGIN, END = "<!-- scripts/recovery.py writes this -->", "<!-- as far as here -->"
SIZE = ("--width", 640, "--height", 480, "--disparities", 128)
SEEDS = (1, 2, 3)
FRAMES = 12
NEW_OBJECTS = (5, 10)  # frames in which the scene has another object
# Both compare phase codes of two scales in windows of 9x9.
METHODS: dict[str, tuple[Word, ...]] = {
    "windows that follow the scene": ("--config", "masrani_640"),
    "the whole range": ("--config", "parts_320", "--set", "disparities=128"),
}

Runs = dict[str, list[list[float]]]  # method -> [seed][frame] percent bad


def bad_percent(scene: Path, frame: int, words: Iterable[Word]) -> float:
    """Of one frame and method: off by more than 1 pixel, of the pixels that both cameras see."""
    names = {"--left": "left", "--right": "right", "--truth-left": "disparity_left", "--truth-right": "disparity_right"}
    files: list[Word] = [word for option, name in names.items() for word in (option, scene / name / f"{frame:05}.png")]
    (method,) = evaluate(*files, *words)
    bad: float = method["masks"]["non_occluded"]["bad_1"]["valid_only"]
    return 100 * bad


def measure() -> Runs:
    runs: Runs = {name: [] for name in METHODS}
    for seed in SEEDS:
        with tempfile.TemporaryDirectory() as folder:
            command: list[Word] = [find_stereo_hls(), "scene", *SIZE, "--seed", seed, "--frames", FRAMES]
            run([*command, "--out", folder], passes_errors=True)
            for name, words in METHODS.items():
                runs[name].append([bad_percent(Path(folder), frame, words) for frame in range(FRAMES)])
            print(f"seed {seed}: {FRAMES} frames", flush=True)
    return runs


def means(by_seed: list[list[float]]) -> list[float]:
    return [sum(values) / len(values) for values in zip(*by_seed)]


def text(runs: Runs) -> str:
    head = ["frame", *(f"**{frame}**" if frame in NEW_OBJECTS else str(frame) for frame in range(FRAMES))]
    rows = [[name, *(number(value, 2) for value in means(by_seed))] for name, by_seed in runs.items()]
    return table(head, rows)


def picture(runs: Runs) -> str:
    """The SVG."""
    shown = {name: [round(value, 2) for value in means(by_seed)] for name, by_seed in runs.items()}
    return svg("recovery", (7, 3), shown, lambda axis: _draw(axis, runs), layout="constrained")


def _draw(axis: Axis, runs: Runs) -> None:
    for name, by_seed in runs.items():
        axis.plot(range(FRAMES), means(by_seed), marker="o", markersize=3, label=name)
    for frame in NEW_OBJECTS:
        axis.axvline(frame, color="0.7", linestyle="--", zorder=0)
    axis.set(xlabel="frame (dashed: a new object)", ylabel="bad pixels, %", ylim=(0, None), xticks=range(FRAMES))
    axis.legend()


def pages() -> dict[Path, str]:
    runs = measure()
    return {PAGE: replaced(PAGE, BEGIN, END, text(runs)), PICTURE: picture(runs)}
