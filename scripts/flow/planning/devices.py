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


def device_of(target: str) -> Device | None:
    device = TARGETS[target].device or ""
    return next((held for part, held in DEVICES.items() if device.startswith(part)), None)


def targets() -> list[str]:
    """Those that a core is placed and routed on."""
    return list(ROUTED)
