# SPDX-License-Identifier: Apache-2.0
"""cosimulation.json beside the VHDL of a configuration: what its co-simulations gave, for the pages and for the tests,
which do not repeat all of them."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Literal, TypedDict, get_args, get_type_hints

from ..base import committed, json_files
from ..base.errors import EXIT_MISMATCH, FlowError
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


def design(config: str) -> manifest.Digests:
    """Of the VHDL that is there now: to be asked before a run whose result is kept."""
    return manifest.design(manifest.read(committed.folder(config)))


def keep(reports: Iterable[tuple[Report, manifest.Digests]], stimulus: Stimulus = "runs") -> None:
    """Adds reports of job.run_job, each of another configuration and with its `design` of before; the last one of each
    simulator stays."""
    changes, changed = [], []
    for report, simulated in reports:
        directory = committed.folder(report["config"])
        entry = manifest.read(directory)
        if manifest.design(entry) == simulated:
            changes.append(_change(report, stimulus, directory, entry))
        else:
            changed.append(report["config"])
    committed.keep(changes)
    if changed:
        raise FlowError(
            f"the VHDL of {', '.join(changed)} changed in the meantime; nothing recorded of it", EXIT_MISMATCH
        )


def _change(report: Report, stimulus: Stimulus, directory: Path, entry: manifest.Manifest) -> committed.Change:
    runs = {one: read(directory, entry, one) for one in get_args(Stimulus)}
    run = {key: value for key, value in report.items() if key in _KEPT}
    content = {
        "format": FORMAT,
        "configuration": report["config"],
        "design": manifest.design(entry),
        **{one: of_one for one, of_one in runs.items() if of_one},
        stimulus: {**runs[stimulus], report["simulator"]: run},
    }
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
