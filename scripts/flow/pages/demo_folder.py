# SPDX-License-Identifier: Apache-2.0
"""The folder that scripts/demo.sh fills, read and checked.

match/            disparity.png, valid.png with a check, match.json (stereo_hls match)
cosim-ghdl/       report.json (scripts/cosim.py)
cosim-verilator/  report.json
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict, get_args, get_origin, get_type_hints

from ..base import committed, json_files
from ..base.configurations import option
from ..base.errors import FlowError
from ..base.newer_python import NotRequired, need_python
from ..cosim.checker import Interval
from ..cosim.report import Report, counts_agree
from ..implementation.results import Configuration
from ..synthesis.manifest import ToolReport
from .published import PAPER, PAPER_WINDOW_PX

PICTURE = Path("match/overview.png")
MAP = Path("match/disparity.png")
VALID = Path("match/valid.png")
COSIMS = ("cosim-ghdl", "cosim-verilator")
MATCH_FORMAT = "stereo-hls match 1"
LARGEST = 1e18  # beyond it no number of a demo lies


class Truth(TypedDict):
    """How the map compares with the ground truth of a generated scene."""

    disparity: str
    visible: str
    tolerance_px: int
    compared_px: int
    bad_px: int


class Match(TypedDict):
    """What is read of match.json."""

    config: str
    engine: str
    left: str
    right: str
    fit: str
    width_px: int
    height_px: int
    disparities: int
    window_px: int
    output_width_px: int
    output_height_px: int
    output_first_column: int
    disparity_steps_per_px: int
    min_disparity: int
    reference: str
    milliseconds: float
    truth: NotRequired[Truth]


@dataclass(frozen=True)
class Demo:
    folder: Path
    match: Match
    cosims: list[Report]  # in the order of COSIMS
    core: Configuration
    has_checks: bool

    @property
    def passed(self) -> bool:
        return all(cosim["passed"] for cosim in self.cosims)

    @property
    def tool(self) -> ToolReport:
        return self.core.manifest["tool_report"]

    @property
    def whole_frames(self) -> Report | None:
        """The co-simulation that measured clocks a frame, or None."""
        return next((cosim for cosim in self.cosims if cosim["clocks_per_frame"] is not None), None)

    @property
    def is_papers_size(self) -> bool:
        return self.core.has(PAPER) and option(self.core.parameters, "window_px") == PAPER_WINDOW_PX


def read_demo(folder: Path) -> Demo:
    need_python((3, 11), "the check of a demo's folder")
    if not folder.is_dir():
        raise FlowError(f"{folder}: there is no such folder; make it with scripts/demo.sh")
    path = folder / "match" / "match.json"
    match = _read_json(path, Match)
    if match.get("format") != MATCH_FORMAT:
        raise FlowError(f"{path}: format {match.get('format')!r} instead of '{MATCH_FORMAT}'")
    if not re.fullmatch(r"\w{1,100}", match["config"]):
        raise FlowError(f"{path} is damaged: unusable 'config'")
    if "truth" in match:
        _check(path, match["truth"], Truth)
    cosims = [_read_cosim(folder / name / "report.json", match["config"]) for name in COSIMS]
    core = _read_core(match["config"])
    has_checks = (folder / VALID).is_file()
    for name in (MAP, VALID) if has_checks else (MAP,):
        _check_png(folder / name)
    return Demo(folder, match, cosims, core, has_checks)


def _read_json(path: Path, shape: type) -> Any:
    try:
        content = json_files.load(path)
    except OSError as error:
        raise FlowError(f"{path}: {error.strerror}; make it with scripts/demo.sh") from None
    except ValueError as error:
        raise FlowError(f"{path} is damaged: {error}; make it again with scripts/demo.sh") from None
    _check(path, content, shape)
    return content


def _check(path: Path, content: object, shape: type) -> None:
    """Every key that the TypedDict requires is there with a value of its type."""
    if not isinstance(content, dict):
        raise FlowError(f"{path} is damaged: not an object with keys")
    for key, kind in get_type_hints(shape, include_extras=True).items():
        if get_origin(kind) is NotRequired:
            continue
        if key not in content or not _is_usable(content[key], kind):
            raise FlowError(f"{path} is damaged: {'no' if key not in content else 'unusable'} '{key}'")


def _is_usable(value: object, kind: Any) -> bool:
    """Whether a value has the type of an annotation. A flag is no number, and a whole number is a float, too."""
    from typing import is_typeddict  # not in the oldest Python

    if get_args(kind):
        return any(_is_usable(value, one) for one in get_args(kind))
    if is_typeddict(kind):
        return isinstance(value, dict)
    if kind in (int, float):
        kinds = (int, float) if kind is float else int
        return isinstance(value, kinds) and not isinstance(value, bool) and abs(value) < LARGEST
    return isinstance(value, kind)


def _read_cosim(path: Path, config: str) -> Report:
    report: Report = _read_json(path, Report)
    if report["initiation_interval"] is not None:
        _check(path, report["initiation_interval"], Interval)
    if report["passed"] != counts_agree(report):
        raise FlowError(f"{path} is damaged: its numbers do not say what its 'passed' says")
    if report["config"] != config:
        raise FlowError(f"{path} is of configuration {report['config']!r}, but the disparity map is of {config}")
    return report


def _read_core(config: str) -> Configuration:
    core = Configuration(config, stale_is_none=True)
    _check(committed.folder(config) / "manifest.json", core.manifest["tool_report"], ToolReport)
    return core


def _check_png(path: Path) -> None:
    try:
        start = path.read_bytes()[:6]
    except OSError as error:
        raise FlowError(f"{path}: {error.strerror}; make it with scripts/demo.sh") from None
    if start != b"\x89PNG\r\n":
        raise FlowError(f"{path} is damaged: not a PNG image; make it again with scripts/demo.sh")
