# SPDX-License-Identifier: Apache-2.0
"""The page about one demo: what the disparity map, the co-simulations and the synthesis gave, and how to get it again.

A demo folder holds
    match/            overview.png, match.json (stereo_hls match)
    cosim-ghdl/       report.json (scripts/cosim.py)
    cosim-verilator/  report.json
"""

import base64
import os
import re
import shlex
import tempfile
from dataclasses import dataclass
from pathlib import Path

import jinja2

from . import json_files, manifest
from .errors import FlowError
from .tools import GENERATED_RTL

TEMPLATE = Path(__file__).with_name("report.html.j2")
PROGRAM = "build/release/stereo_hls"
PICTURE = Path("match/overview.png")
COSIMS = ("cosim-ghdl", "cosim-verilator")
MATCH_FORMAT = "stereo-hls match 1"
LARGEST = 1e18  # beyond it no number of a demo lies
# "Hardware implementation of an SAD based stereo vision algorithm", 2007.
PAPER = {
    "size": {"width_px": 320, "height_px": 240, "disparities": 100, "window_px": 3},
    "clocks_per_frame": 153120,
    "memory_bits": 884736,
}

_MATCH_KEYS = {
    "config": str, "engine": str, "left": str, "right": str, "fit": str, "width_px": int, "height_px": int, "disparities": int,
    "window_px": int, "output_width_px": int, "output_height_px": int, "milliseconds": (int, float),
}
_TRUTH_KEYS = {"disparity": str, "visible": str, "tolerance_px": int, "compared_px": int, "bad_px": int}
_COSIM_KEYS = {
    "config": str, "simulator": str, "rows": (str, type(None)), "stall_percent": int, "seed": int, "passed": bool, "expected": int,
    "compared": int, "mismatches": int, "first_mismatch": (str, type(None)), "frames": int, "clocks": int,
    "clocks_per_frame": (int, type(None)), "initiation_interval": (dict, type(None)), "latency_clocks": (int, type(None)),
    "clocks_per_second": (int, float), "build_seconds": (int, float), "simulation_seconds": (int, float),
}
_INTERVAL_KEYS = {"min": int, "avg": (int, float), "max": int}
_TOOL_KEYS = {"states": int, "loop_states": int, "registers": int, "registers_named": int, "register_bits": int, "memory_bits": int}


@dataclass(frozen=True)
class Demo:
    match: dict
    cosims: list  # in the order of COSIMS
    manifest: dict
    picture: bytes  # PNG

    @property
    def passed(self):
        return all(cosim["passed"] for cosim in self.cosims)

    @property
    def whole_frames(self):
        """The co-simulation that measured clocks a frame, or None."""
        return next((cosim for cosim in self.cosims if cosim["clocks_per_frame"] is not None), None)

    @property
    def is_papers_size(self):
        return all(self.manifest["parameters"].get(key) == value for key, value in PAPER["size"].items())


# --- reading ----------------------------------------------------------------------------------------------------------


def read_demo(folder):
    folder = Path(folder)
    if not folder.is_dir():
        raise FlowError(f"{folder}: there is no such folder; make it with scripts/demo.sh")
    match = _read_json(folder / "match" / "match.json", _MATCH_KEYS)
    if match.get("format") != MATCH_FORMAT:
        raise FlowError(f"{folder / 'match' / 'match.json'}: format {match.get('format')!r} instead of '{MATCH_FORMAT}'")
    if not re.fullmatch(r"\w{1,100}", match["config"]):
        raise FlowError(f"{folder / 'match' / 'match.json'} is damaged: unusable 'config'")
    if "truth" in match:
        _check(folder / "match" / "match.json", match["truth"], _TRUTH_KEYS)
    cosims = [_read_cosim(folder / name / "report.json", match["config"]) for name in COSIMS]
    return Demo(match, cosims, _read_manifest(match["config"]), _read_picture(folder / PICTURE))


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


def _read_manifest(config):
    content = manifest.read(GENERATED_RTL / config)
    _check(GENERATED_RTL / config / "manifest.json", content["tool_report"], _TOOL_KEYS)
    return content


def _read_picture(path):
    try:
        picture = path.read_bytes()
    except OSError as error:
        raise FlowError(f"{path}: {error.strerror}; make it with scripts/demo.sh") from None
    if not picture.startswith(b"\x89PNG\r\n"):
        raise FlowError(f"{path} is damaged: not a PNG image; make it again with scripts/demo.sh")
    return picture


# --- commands ---------------------------------------------------------------------------------------------------------


def _command(*words):
    return " ".join(shlex.quote(str(word)) for word in words)


def _pair_options(match):
    fit = [] if match["fit"] == "none" else ["--fit", match["fit"]]
    return ["--config", match["config"], "--left", match["left"], "--right", match["right"], *fit]


def match_commands(demo):
    """How the pair and its disparity map were made; a pair with ground truth is a generated scene."""
    match, commands, truth = demo.match, [], []
    if "truth" in match:
        scene = Path(match["left"]).parent
        commands.append(_command(PROGRAM, "scene", "--config", match["config"], "--seed", demo.cosims[0]["seed"], "--out", scene))
        truth = ["--truth", match["truth"]["disparity"], "--visible", match["truth"]["visible"]]
    commands.append(_command(PROGRAM, "match", *_pair_options(match), *truth, "--out", "build/match"))
    return commands


def cosim_command(match, cosim):
    words = ["scripts/cosim.py", *_pair_options(match)]
    if cosim["rows"] is not None:
        words += ["--rows", cosim["rows"]]
    if cosim["frames"] > 1:
        words += ["--frames", cosim["frames"]]
    if cosim["stall_percent"]:
        words += ["--stall-percent", cosim["stall_percent"]]
    return _command(*words, "--seed", cosim["seed"], "--simulator", cosim["simulator"])


# --- writing ----------------------------------------------------------------------------------------------------------


def number(value):
    """12345 as 12,345; nothing as a dash."""
    return "–" if value is None else f"{value:,}"


def bad_percent(truth):
    return 100 * truth["bad_px"] / max(truth["compared_px"], 1)


def render(demo):
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATE.parent), autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["number"] = number
    return environment.get_template(TEMPLATE.name).render(
        demo=demo, match=demo.match, truth=demo.match.get("truth"), tool=demo.manifest["tool_report"], paper=PAPER,
        picture=base64.b64encode(demo.picture).decode(), match_commands=match_commands(demo),
        cosims=[(cosim, cosim_command(demo.match, cosim)) for cosim in demo.cosims], bad_percent=bad_percent,
    )


def write_page(path, text):
    """The whole page or none."""
    path = Path(path)
    temporary = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("w", dir=path.parent, prefix=f".{path.name}.", delete=False, encoding="utf-8") as file:
            temporary = Path(file.name)
            file.write(text)
        temporary.chmod(0o644)
        os.replace(temporary, path)
    except OSError as error:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
        raise FlowError(f"cannot write {path}: {error.strerror}") from None


def summary(demo):
    """The key facts in a few lines of text."""
    parts = [f"{cosim['compared']:,} of {cosim['expected']:,} outputs in {cosim['simulator']}" for cosim in demo.cosims]
    mismatches = sum(cosim["mismatches"] for cosim in demo.cosims)
    lines = [f"{'PASS' if demo.passed else 'FAIL'}: VHDL against C++ core, {demo.match['config']}: {', '.join(parts)}; {mismatches:,} mismatches"]
    beside = (lambda key: f" (2007 paper: {PAPER[key]:,})") if demo.is_papers_size else (lambda key: "")
    facts, tool = [], demo.manifest["tool_report"]
    if demo.whole_frames is not None:
        facts.append(f"{demo.whole_frames['clocks_per_frame']:,} clocks a frame{beside('clocks_per_frame')}")
        facts.append(f"latency {number(demo.whole_frames['latency_clocks'])} clocks")
    if "truth" in demo.match:
        facts.append(f"{bad_percent(demo.match['truth']):.2f} % bad pixels against the ground truth")
    lines += [", ".join(facts)] if facts else []
    return "\n".join([*lines, f"{tool['memory_bits']:,} memory bits{beside('memory_bits')}, {tool['register_bits']:,} register bits"])
