# SPDX-License-Identifier: Apache-2.0
"""What the devices hold."""

from __future__ import annotations

from typing import NamedTuple

from ..implementation.targets import ROUTED, TARGETS


class Device(NamedTuple):
    lut_sites: int  # as the router counts them
    block_rams: int


# By the beginning of a target's device. A target whose device is not here needs both numbers from the user.
DEVICES = {
    "LFE5U-25F": Device(24_288, 56),
    "LFE5U-85F": Device(83_640, 208),
}


def netlist_of(target: str) -> str:
    """The target whose netlist it takes: that of its family."""
    return TARGETS[target].family or target


def netlists() -> list[str]:
    """The targets with a netlist of their own: one of each family."""
    return [target for target in TARGETS if netlist_of(target) == target]


def title_of(target: str) -> str:
    """For tables."""
    return TARGETS[target].short or target


def lut_name(target: str) -> str:
    return TARGETS[target].lut_name


def device_of(target: str) -> Device | None:
    device = TARGETS[target].device or ""
    return next((held for part, held in DEVICES.items() if device.startswith(part)), None)


def every_target() -> list[str]:
    return list(TARGETS)


def targets() -> list[str]:
    """Those that a core is placed and routed on."""
    return list(ROUTED)
