# SPDX-License-Identifier: Apache-2.0
"""What the devices hold."""

from __future__ import annotations

from typing import NamedTuple

from ..implementation.targets import ROUTED, TARGETS


class Device(NamedTuple):
    """As nextpnr counts them."""

    lut_sites: int
    block_rams: int  # on GateMate of 20 kbit, two of which can be one


# By the beginning of a target's device. A target whose device is not here needs both numbers from the user.
DEVICES = {
    "LFE5U-25F": Device(24_288, 56),
    "LFE5U-85F": Device(83_640, 208),
    "GW1NR-LV9": Device(8_640, 26),
    "GW2AR-LV18": Device(20_736, 46),
    "iCE40UP5K": Device(5_280, 30),
    "iCE40HX8K": Device(7_680, 32),
    "LIFCL-40": Device(32_256, 84),
    "CCGM1A1": Device(40_960, 64),
}


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


def device_of(target: str) -> Device | None:
    device = TARGETS[target].device or ""
    return next((held for part, held in DEVICES.items() if device.startswith(part)), None)


def every_target() -> list[str]:
    return list(TARGETS)


def targets() -> list[str]:
    """Those that a core is placed and routed on."""
    return list(ROUTED)
