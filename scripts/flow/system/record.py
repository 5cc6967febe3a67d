# SPDX-License-Identifier: Apache-2.0
"""examples/camera_system/camera_system_NAME.json: what a system was measured with, and what it gave."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TypedDict, cast

from ..base import committed, files, json_files
from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.newer_python import NotRequired
from ..base.tools import ROOT
from ..implementation.record import Result
from ..synthesis import manifest
from .template import FOLDER, System, own_files

FORMAT = "stereo-hls camera system 1"
SECTIONS = ("implementation", "frame", "streams")


class Latency(TypedDict):
    """From the clock in which a camera sends the last pixel of a row to the one in which that row's depths leave."""

    first_clocks: int  # the first depth of the row
    last_clocks: int  # the last one


class Frame(TypedDict):
    """A whole frame in Verilator."""

    command: str
    scene: str  # what was seen
    depths: int
    known: int  # of them: measured
    filled: NotRequired[int]  # of a core that fills holes
    mismatches: int
    clocks: int
    latency: Latency


class Streams(TypedDict):
    """Frames of random streams in Verilator."""

    command: str
    frames: int  # sent
    broken: int  # of them: with a fault
    exact: int
    mismatches: int
    hangs: int


class Record(TypedDict):
    format: str
    system: str
    design: manifest.Digests
    implementation: NotRequired[dict[str, Result]]  # by target
    frame: NotRequired[Frame]
    streams: NotRequired[Streams]


def path(system: System) -> Path:
    return FOLDER / f"{system.entity}.json"


def design(system: System) -> manifest.Digests:
    """What the figures depend on. Of generated cores the structure, not the names in it."""
    found = {file.relative_to(ROOT).as_posix(): manifest.digest(file) for file in own_files(system)}
    for name in (system.rectification, system.matching):
        found |= {
            key if "/" in key else f"{name}: {key}": value
            for key, value in manifest.design(manifest.read(committed.folder(name))).items()
        }
    return found


def read(system: System) -> Record | None:
    """None when there is no record, or one of another design."""
    content = json_files.load_result(path(system), FORMAT)
    if content is None:
        return None
    if not json_files.fits(content, Record):
        raise json_files.damaged(path(system), FORMAT)
    return cast(Record, content) if content["design"] == design(system) else None


def keep(system: System, section: str, content: object, made_of: manifest.Digests) -> None:
    """Adds a section; the others stay when they are of the same design. `made_of`: design() when it was begun."""
    if made_of != design(system):
        raise FlowError(f"the VHDL of {system.entity} changed in the meantime; nothing recorded", EXIT_MISMATCH)
    record = read(system) or {"format": FORMAT, "system": system.name, "design": made_of}
    merged = {**record, section: content}
    files.write(path(system), json.dumps(merged, indent=2, sort_keys=True) + "\n")
