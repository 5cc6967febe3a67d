# SPDX-License-Identifier: Apache-2.0
"""The folder that scripts/demo.sh fills, read and checked.

match/            disparity.png, valid.png with a check, match.json (stereo_hls match)
cosim-ghdl/       report.json (scripts/cosim.py)
cosim-verilator/  report.json
"""

import re
from dataclasses import dataclass
from pathlib import Path

from ..base import json_files
from ..base.errors import FlowError
from ..base.tools import GENERATED_RTL
from ..implementation.results import Configuration
from . import performance

PICTURE = Path("match/overview.png")
MAP = Path("match/disparity.png")
VALID = Path("match/valid.png")
COSIMS = ("cosim-ghdl", "cosim-verilator")
MATCH_FORMAT = "stereo-hls match 1"
LARGEST = 1e18  # beyond it no number of a demo lies

_MATCH_KEYS = {
    "config": str,
    "engine": str,
    "left": str,
    "right": str,
    "fit": str,
    "width_px": int,
    "height_px": int,
    "disparities": int,
    "window_px": int,
    "output_width_px": int,
    "output_height_px": int,
    "output_first_column": int,
    "disparity_steps_per_px": int,
    "min_disparity": int,
    "reference": str,
    "milliseconds": (int, float),
}
_TRUTH_KEYS = {"disparity": str, "visible": str, "tolerance_px": int, "compared_px": int, "bad_px": int}
_COSIM_KEYS = {
    "config": str,
    "command": str,
    "simulator": str,
    "rows": (str, type(None)),
    "stall_percent": int,
    "seed": int,
    "passed": bool,
    "expected": int,
    "compared": int,
    "mismatches": int,
    "first_mismatch": (str, type(None)),
    "frames": int,
    "clocks": int,
    "clocks_per_frame": (int, type(None)),
    "initiation_interval": (dict, type(None)),
    "latency_clocks": (int, type(None)),
    "clocks_per_second": (int, float),
    "build_seconds": (int, float),
    "simulation_seconds": (int, float),
}
_INTERVAL_KEYS = {"min": int, "avg": (int, float), "max": int}
_TOOL_KEYS = {
    "states": int,
    "loop_states": int,
    "registers": int,
    "registers_named": int,
    "register_bits": int,
    "memory_bits": int,
}


@dataclass(frozen=True)
class Demo:
    folder: Path
    match: dict
    cosims: list  # in the order of COSIMS
    core: Configuration
    has_checks: bool

    @property
    def passed(self):
        return all(cosim["passed"] for cosim in self.cosims)

    @property
    def tool(self):
        return self.core.manifest["tool_report"]

    @property
    def whole_frames(self):
        """The co-simulation that measured clocks a frame, or None."""
        return next((cosim for cosim in self.cosims if cosim["clocks_per_frame"] is not None), None)

    @property
    def is_papers_size(self):
        wanted = {**performance.PAPER, "window_px": performance.PAPER_WINDOW_PX}
        return all(self.core.parameters.get(key) == value for key, value in wanted.items())


def read_demo(folder):
    folder = Path(folder)
    if not folder.is_dir():
        raise FlowError(f"{folder}: there is no such folder; make it with scripts/demo.sh")
    match = _read_json(folder / "match" / "match.json", _MATCH_KEYS)
    if match.get("format") != MATCH_FORMAT:
        raise FlowError(
            f"{folder / 'match' / 'match.json'}: format {match.get('format')!r} instead of '{MATCH_FORMAT}'"
        )
    if not re.fullmatch(r"\w{1,100}", match["config"]):
        raise FlowError(f"{folder / 'match' / 'match.json'} is damaged: unusable 'config'")
    if "truth" in match:
        _check(folder / "match" / "match.json", match["truth"], _TRUTH_KEYS)
    cosims = [_read_cosim(folder / name / "report.json", match["config"]) for name in COSIMS]
    core = _read_core(match["config"])
    p = core.parameters
    has_checks = p["left_right_threshold"] >= 0 or p["uniqueness_percent"] > 0 or p["texture_threshold"] > 0
    for name in (MAP, VALID) if has_checks else (MAP,):
        _check_png(folder / name)
    return Demo(folder, match, cosims, core, has_checks)


def _read_json(path, keys):
    try:
        content = json_files.load(path)
    except OSError as error:
        raise FlowError(f"{path}: {error.strerror}; make it with scripts/demo.sh") from None
    except ValueError as error:
        raise FlowError(f"{path} is damaged: {error}; make it again with scripts/demo.sh") from None
    _check(path, content, keys)
    return content


def _check(path, content, keys):
    """Every key is there with a value of its type; a flag is no number."""
    if not isinstance(content, dict):
        raise FlowError(f"{path} is damaged: not an object with keys")
    for key, kinds in keys.items():
        if key not in content or not _is_usable(content[key], kinds):
            raise FlowError(f"{path} is damaged: {'no' if key not in content else 'unusable'} '{key}'")


def _is_usable(value, kinds):
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return isinstance(value, kinds) and (not isinstance(value, bool) or kinds is bool)
    return isinstance(value, kinds) and abs(value) < LARGEST


def _read_cosim(path, config):
    content = _read_json(path, _COSIM_KEYS)
    if content["initiation_interval"] is not None:
        _check(path, content["initiation_interval"], _INTERVAL_KEYS)
    if content["config"] != config:
        raise FlowError(f"{path} is of configuration {content['config']!r}, but the disparity map is of {config}")
    return content


def _read_core(config):
    core = Configuration(config, stale_is_none=True)
    _check(GENERATED_RTL / config / "manifest.json", core.manifest["tool_report"], _TOOL_KEYS)
    return core


def _check_png(path):
    try:
        start = path.read_bytes()[:6]
    except OSError as error:
        raise FlowError(f"{path}: {error.strerror}; make it with scripts/demo.sh") from None
    if start != b"\x89PNG\r\n":
        raise FlowError(f"{path} is damaged: not a PNG image; make it again with scripts/demo.sh")
