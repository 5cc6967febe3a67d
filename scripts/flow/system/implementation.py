# SPDX-License-Identifier: Apache-2.0
"""Area and clock of a whole camera_system, by the tools that implement the cores."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ..base import committed
from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.tools import find_ghdl
from ..implementation import job, yosys
from ..implementation.families.ecp5 import Ecp5, Ecp5FewPins
from ..implementation.record import Result
from ..implementation.targets import TARGETS, Target
from ..synthesis import manifest
from .template import CORE, System, vhdl_files


def design(system: System, seeds: list[int], router: str | None) -> job.Design:
    """`bypasses` stay around the memories outside the matching core."""
    files: list[Path] = vhdl_files(system)
    parameters = manifest.read(committed.folder(system.matching))["parameters"]
    without_bypass = yosys.memories_without_bypass(parameters, f"{CORE}.")
    return job.Design(system.entity, files, seeds, router, without_bypass)


def target_of(system: System, name: str) -> Target:
    target = TARGETS[name]
    return replace(target, family=Ecp5FewPins()) if system.few_pins and isinstance(target.family, Ecp5) else target


def implement(system: System, seeds: list[int], router: str | None, target: str) -> dict[str, Result]:
    """{target: result}; prints what it found. Without a router it is that of the target's family."""
    find_ghdl()
    yosys.find_yosys()
    result, lost = job.implement_target(design(system, seeds, router), target_of(system, target), {})
    print("\n".join(job.area_and_clock(system.entity, target, result)), flush=True)
    if lost:
        raise FlowError(f"{system.entity}: a memory became flip-flops instead of RAM: {', '.join(lost)}", EXIT_MISMATCH)
    return {target: result}
