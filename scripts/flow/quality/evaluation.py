# SPDX-License-Identifier: Apache-2.0
"""`stereo_hls evaluate` and `stereo_hls scene`, called for their numbers."""

import json
import tempfile
from pathlib import Path

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from ..base.tools import find_stereo_hls, run

FORMAT = "stereo-hls evaluation 1"
MASKS = ("non_occluded", "all", "discontinuity", "textureless")
MEASURES = ("bad_0_5", "bad_1", "bad_2", "bad_4", "d1")
SCENE_SIZE = ("--width", 450, "--height", 375)


def evaluate(*words):
    """The methods that one call measured, as evaluate_command.cpp writes them."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "evaluation.json"
        run([find_stereo_hls(), "evaluate", *words, "--json", path], passes_errors=True)
        text = path.read_text()
    try:
        content = json.loads(text)
        if content["format"] == FORMAT and content["methods"]:
            return content["methods"]
    except (ValueError, KeyError, TypeError):
        pass
    raise FlowError(f"stereo_hls evaluate gave something else than '{FORMAT}': {text[:80].strip()}", EXIT_TOOL_FAILED)


def scene(seed, disparities, folder):
    """A generated pair of the size of Teddy: {option of `evaluate`: path}. `disparities`: the largest that it shows, and one."""
    run(
        [find_stereo_hls(), "scene", *SCENE_SIZE, "--disparities", disparities, "--seed", seed, "--out", folder],
        passes_errors=True,
    )
    names = {"--left": "left", "--right": "right", "--truth-left": "disparity_left", "--truth-right": "disparity_right"}
    return {option: Path(folder) / f"{name}.png" for option, name in names.items()}
