# SPDX-License-Identifier: Apache-2.0
"""cosimulation.json beside the VHDL of a configuration: what its co-simulations gave, for the pages."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TypedDict, get_type_hints

from ..base import committed, json_files
from ..synthesis import manifest
from .report import Report

FILE = "cosimulation.json"
FORMAT = "stereo-hls cosimulation 2"


class Run(TypedDict):
    """What is kept of a report. Times are not: they differ from machine to machine."""

    command: str
    passed: bool
    expected: int
    compared: int
    mismatches: int
    frames: int
    clocks: int


_KEPT = get_type_hints(Run)


def keep(report: Report) -> None:
    """Adds a report of job.run_job; the last one of each simulator stays."""
    directory = committed.folder(report["config"])
    entry = manifest.read(directory)
    runs: dict[str, Mapping[str, object]] = {**read(directory, entry)}
    runs[report["simulator"]] = {key: value for key, value in report.items() if key in _KEPT}
    content = {"format": FORMAT, "configuration": report["config"], "design": manifest.design(entry), "runs": runs}
    text = json.dumps(content, indent=2, sort_keys=True) + "\n"
    committed.keep([manifest.change(entry, {FILE: text})])


def read(directory: Path, entry: manifest.Manifest) -> dict[str, Run]:
    """The last run of each simulator with the VHDL that the manifest `entry` describes; those of other VHDL do not
    count."""
    path = directory / FILE
    content = json_files.load_result(path, FORMAT)
    if content is None:
        return {}
    runs = content.get("runs")
    if not isinstance(runs, dict) or not all(_is_run(run) for run in runs.values()):
        raise json_files.damaged(path, FORMAT)
    return runs if content.get("design") == manifest.design(entry) else {}


def _is_run(run: object) -> bool:
    return isinstance(run, dict) and all(isinstance(run.get(key), kind) for key, kind in _KEPT.items())
