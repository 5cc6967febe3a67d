# SPDX-License-Identifier: Apache-2.0
"""cosimulation.json beside the VHDL of a configuration: what its co-simulations gave, for the pages and for the tests,
which do not repeat all of them."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Literal, TypedDict, get_type_hints

from ..base import committed, json_files
from ..synthesis import manifest
from .report import Report

FILE = "cosimulation.json"
FORMAT = "stereo-hls cosimulation 2"
Stimulus = Literal["runs", "stress"]  # the keys of the file: images, and the stress stream


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


def keep(reports: Iterable[Report], stimulus: Stimulus = "runs") -> None:
    """Adds reports of job.run_job, each of another configuration; the last one of each simulator stays."""
    committed.keep([_change(report, stimulus) for report in reports])


def _change(report: Report, stimulus: Stimulus) -> committed.Change:
    directory = committed.folder(report["config"])
    entry = manifest.read(directory)
    content: dict[str, object] = {
        "format": FORMAT,
        "configuration": report["config"],
        "design": manifest.design(entry),
        **{one: runs for one in ("runs", "stress") if (runs := read(directory, entry, one))},
    }
    run = {key: value for key, value in report.items() if key in _KEPT}
    content[stimulus] = {**read(directory, entry, stimulus), report["simulator"]: run}
    return manifest.change(entry, {FILE: json.dumps(content, indent=2, sort_keys=True) + "\n"})


def read(directory: Path, entry: manifest.Manifest, stimulus: Stimulus = "runs") -> dict[str, Run]:
    """The last run of each simulator with the VHDL that the manifest `entry` describes; those of other VHDL do not
    count."""
    path = directory / FILE
    content = json_files.load_result(path, FORMAT)
    if content is None:
        return {}
    runs = content.get(stimulus, {})
    if not isinstance(runs, dict) or not all(_is_run(run) for run in runs.values()):
        raise json_files.damaged(path, FORMAT)
    return runs if content.get("design") == manifest.design(entry) else {}


def _is_run(run: object) -> bool:
    return isinstance(run, dict) and all(isinstance(run.get(key), kind) for key, kind in _KEPT.items())
