# SPDX-License-Identifier: Apache-2.0
"""`stereo_hls evaluate` and `stereo_hls scene`, called for their numbers."""

import json
import tempfile
from pathlib import Path
from typing import Any, TypedDict

from ..base.configurations import Parameters
from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import Word, find_stereo_hls, run

FORMAT = "stereo-hls evaluation 1"
MASKS = ("non_occluded", "searchable", "all", "discontinuity", "textureless")
MEASURES = ("bad_0_5", "bad_1", "bad_2", "bad_4", "d1")
SCENE_SIZE = ("--width", 450, "--height", 375)

# Of the pixels of one mask: density, avg_px, rms_px, and {"invalid_bad", "valid_only"} of each of MEASURES; None where
# no pixel counts.
Measures = dict[str, Any]


class Method(TypedDict):
    """One method on one pair, as evaluation.cpp writes it."""

    name: str
    kind: str  # core or opencv
    reference: str
    parameters: Parameters
    milliseconds: float
    masks: dict[str, Measures]
    remarks: list[str]  # on truth that does not fit


def evaluate(*words: Word) -> list[Method]:
    """What one call measured."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "evaluation.json"
        run([find_stereo_hls(), "evaluate", *words, "--json", path], passes_errors=True)
        text = path.read_text()
    methods: list[Method] = []
    try:
        content = json.loads(text)
        if content["format"] == FORMAT:
            methods = content["methods"]
    except (ValueError, KeyError, TypeError):
        pass  # the same sentence
    if not methods:
        start = text[:80].strip()
        raise FlowError(f"stereo_hls evaluate gave something else than '{FORMAT}': {start}", EXIT_TOOL_FAILED)
    return methods


def scene(seed: int, disparities: int, folder: Path) -> dict[str, Path]:
    """A generated pair of the size of Teddy: {option of `evaluate`: path}. `disparities`: the largest that it shows,
    and one."""
    command: list[Word] = [find_stereo_hls(), "scene", *SCENE_SIZE, "--disparities", disparities, "--seed", seed]
    run([*command, "--out", folder], passes_errors=True)
    names = {"--left": "left", "--right": "right", "--truth-left": "disparity_left", "--truth-right": "disparity_right"}
    return {option: folder / f"{name}.png" for option, name in names.items()}
