# SPDX-License-Identifier: Apache-2.0
"""implementation.json beside the VHDL of a configuration: its area and clock on each FPGA family, and those of the AXI
shell around it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TypedDict, cast

from ..base import json_files
from ..base.newer_python import NotRequired
from ..synthesis.manifest import Digests, Manifest, design

FORMAT = "stereo-hls implementation 3"
FILE = "implementation.json"


class Area(TypedDict):
    luts: NotRequired[int]
    aluts: NotRequired[int]  # where the family has these instead
    ffs: int
    memory_bits: int
    block_rams: int
    memory_in_flip_flops: bool
    # Of memories that are too small for a block RAM, where the family has no LUT RAM: flip-flops, not in memory_bits.
    small_memory_bits: NotRequired[int]
    cells: dict[str, int]


class Fmax(TypedDict):
    median: float
    best: float
    by_seed: dict[str, float]


# Of the slowest path between registers.
CriticalPath = TypedDict("CriticalPath", {"from": str, "to": str, "block": str})


class Routed(TypedDict):
    """What place and route adds."""

    seeds: list[int]
    fmax_mhz: Fmax
    lut_sites: int
    critical_path: CriticalPath


class Fill(TypedDict):
    """How many cells of a kind a netlist needs, and how many the device has."""

    used: int
    available: int


class Result(Area):
    """One family."""

    synthesis: str
    tools: dict[str, str]  # their versions
    device: NotRequired[str]  # only where there is a router
    around: NotRequired[dict[str, int]]  # LUTs and flip-flops around a core on few pins: in lut_sites, not above
    does_not_fit: NotRequired[dict[str, Fill]]  # {cell: ...} of which the device has too few
    # The rest only where it was placed and routed.
    target_mhz: NotRequired[float]
    router: NotRequired[str]  # of nextpnr; not in older results: its first one
    seeds: NotRequired[list[int]]
    fmax_mhz: NotRequired[Fmax]
    lut_sites: NotRequired[int]
    critical_path: NotRequired[CriticalPath]


class Shell(TypedDict):
    """stereo_ip_NAME."""

    design: Digests  # of the shell's own VHDL
    targets: dict[str, Result]


class Record(TypedDict):
    format: str
    configuration: str
    design: Digests  # of the core
    targets: dict[str, Result]
    shell: NotRequired[Shell]


def read(directory: Path) -> Record | None:
    """implementation.json of a folder, or None when there is none."""
    path = directory / FILE
    content = json_files.load_result(path, FORMAT)
    if content is None:
        return None
    if not json_files.fits(content, Record):
        raise json_files.damaged(path, FORMAT)
    return cast(Record, content)


def is_fresh(record: Record, entry: Manifest) -> bool:
    """Whether a record was made from the VHDL that the manifest `entry` describes."""
    return record["design"] == design(entry)


def shell_results(record: Record, shell: Digests) -> dict[str, Result]:
    """Those of stereo_ip_NAME by target; none when they are of a shell other than `shell`."""
    kept = record.get("shell")
    return kept["targets"] if kept and kept["design"] == shell else {}


def merged(out: Path, entry: Manifest, target: str, result: Result, shell: Digests | None = None) -> str:
    """The text of the implementation.json in a folder with one more target's result: of the core, or with `shell` of
    the shell of these digests around it. Results of other targets stay when they are of the same VHDL."""
    record = read(out)
    if record is None or not is_fresh(record, entry):
        record = {
            "format": FORMAT,
            "configuration": entry["configuration"],
            "design": design(entry),
            "targets": {},
        }
    if shell is None:
        record["targets"][target] = result
    else:
        record["shell"] = {"design": shell, "targets": shell_results(record, shell) | {target: result}}
    return json.dumps(record, indent=2, sort_keys=True) + "\n"
