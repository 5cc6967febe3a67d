# SPDX-License-Identifier: Apache-2.0
"""The devices and families that a plan is made for."""

from __future__ import annotations

from ..implementation.families.family import Family
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
    return _family(netlist).lut_name


def covered_ffs(netlist: str) -> dict[str, int]:
    """{cell: flip-flops of the device that it leaves no place for}"""
    return _family(netlist).covered_ffs


def logic_cell(netlist: str) -> str:
    """What a LUT and a flip-flop share, or each of them takes alone; "" where flip-flops have places of their own."""
    return _family(netlist).logic_cell


def _family(netlist: str) -> Family:
    return next(target.family for name, target in TARGETS.items() if netlist_of(name) == netlist)


def device_of(target: str) -> Device | None:
    return TARGETS[target].holds


def every_target() -> list[str]:
    return list(TARGETS)


def targets() -> list[str]:
    """Those that a core is placed and routed on."""
    return list(ROUTED)
