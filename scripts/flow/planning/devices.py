# SPDX-License-Identifier: Apache-2.0
"""The devices and families that a plan is made for."""

from __future__ import annotations

from ..implementation.targets import ROUTED, TARGETS, Device


def netlist_of(target: str) -> str:
    """The family whose netlist it takes."""
    return TARGETS[target].family.name


def netlists() -> list[str]:
    """One of each family."""
    return list(dict.fromkeys(netlist_of(target) for target in TARGETS))


def title_of(target: str) -> str:
    """For tables."""
    return TARGETS[target].short or target


def lut_name(netlist: str) -> str:
    return next(target.family.lut_name for name, target in TARGETS.items() if netlist_of(name) == netlist)


def covered_ffs(netlist: str) -> dict[str, int]:
    """{cell: flip-flops of the device that it leaves no place for}"""
    return next(target.family.covered_ffs for name, target in TARGETS.items() if netlist_of(name) == netlist)


def device_of(target: str) -> Device | None:
    return TARGETS[target].holds


def every_target() -> list[str]:
    return list(TARGETS)


def targets() -> list[str]:
    """Those that a core is placed and routed on."""
    return list(ROUTED)
