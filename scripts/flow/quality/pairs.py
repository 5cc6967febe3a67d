# SPDX-License-Identifier: Apache-2.0
"""Lists of rectified pairs with ground truth: a JSON file that people write for their own pairs."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import NamedTuple

from ..base.errors import FlowError
from ..base.tools import ROOT, Word

OWN_LIST = Path(__file__).parent / "pairs.json"
_TEXTS = ("name", "title", "left", "right", "truth_left")


class Pair(NamedTuple):
    name: str  # of files made for it
    title: str
    left: Path
    right: Path
    truth_left: Path
    truth_scale: float  # values of the truth a pixel
    disparities: int  # that are searched

    @property
    def images(self) -> list[Word]:
        """Options of `stereo_hls evaluate`."""
        words: list[Word] = ["--left", self.left, "--right", self.right, "--truth-left", self.truth_left]
        return [*words, "--truth-scale", self.truth_scale]

    @property
    def missing(self) -> list[Path]:
        return [path for path in (self.left, self.right, self.truth_left) if not path.is_file()]


def data_folder() -> Path:
    """Where the pairs of the project's own list lie."""
    return Path(os.environ.get("STEREO_DATA") or ROOT.parent / "shared" / "data" / "stereo")


def read_pairs(path: Path) -> list[Pair]:
    """Paths in the project's own list are below data_folder(), in another list beside it."""
    folder = data_folder() if path.resolve() == OWN_LIST.resolve() else path.parent
    try:
        entries = json.loads(path.read_text())
    except (OSError, ValueError) as error:
        raise FlowError(f"{path} cannot be read as a list of pairs: {error}") from error
    if not isinstance(entries, list) or not entries:
        raise FlowError(f"{path} must be a list of pairs, as {OWN_LIST.relative_to(ROOT)} is")
    return [_pair(path, folder, entry) for entry in entries]


def _pair(path: Path, folder: Path, entry: object) -> Pair:
    if not isinstance(entry, dict) or set(entry) != set(Pair._fields):
        raise FlowError(f"{path}: a pair has the entries {', '.join(Pair._fields)}, and no others")
    bad = [name for name in _TEXTS if not isinstance(entry[name], str) or not entry[name]]
    if bad:
        raise FlowError(f"{path}: {bad[0]} of a pair must be a text")
    scale, disparities = entry["truth_scale"], entry["disparities"]
    if isinstance(scale, bool) or not isinstance(scale, (int, float)) or not scale > 0:
        raise FlowError(f"{path}: truth_scale of {entry['name']} must be a number above 0")
    if isinstance(disparities, bool) or not isinstance(disparities, int) or not 2 <= disparities <= 256:
        raise FlowError(f"{path}: disparities of {entry['name']} must be 2 ... 256")
    if Path(entry["name"]).name != entry["name"]:
        raise FlowError(f"{path}: the name {entry['name']} must be that of a file")
    left, right, truth = (folder / entry[name] for name in ("left", "right", "truth_left"))
    return Pair(entry["name"], entry["title"], left, right, truth, float(scale), disparities)
