# SPDX-License-Identifier: Apache-2.0
"""The devices that a design is implemented on. A new device of a family that is there is a row."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from .families.area_only import CycloneV, Series7
from .families.ecp5 import Ecp5
from .families.family import Family
from .families.gatemate import GateMate
from .families.gowin import Gowin
from .families.ice40 import Ice40
from .families.nexus import Nexus


class Device(NamedTuple):
    """What a device holds, as nextpnr counts it: its log and its report name the cells that are available, those of
    flip-flops TRELLIS_FF (LFE5U), DFF (Gowin), OXIDE_FF (LIFCL) and CPE_FF (GateMate). On iCE40 each logic cell has one
    (ICESTORM_LC); that of the LFE5U-45F follows from its siblings, two in a slice of two LUTs."""

    lut_sites: int
    flip_flops: int
    block_rams: int  # on GateMate of 20 kbit, two of which can be one


@dataclass(frozen=True)
class Target:
    """One device, or a family whose area alone is known. All devices of a family share its netlist."""

    name: str
    family: Family
    device: str | None = None  # this and the next only where the result is placed and routed
    options: tuple[str, ...] = ()  # of nextpnr
    pins: tuple[str, ...] = ()  # of clock, scan_in and scan_out, where the family wants them bound
    short: str = ""  # device and speed grade, for tables
    holds: Device | None = None  # None: plan.py needs both numbers from the user


ECP5 = Ecp5()
_GOWIN, _ICE40, _NEXUS, _GATEMATE = Gowin(), Ice40(), Nexus(), GateMate()
TARGETS = {
    target.name: target
    for target in (
        Target(
            "ecp5",
            ECP5,
            "LFE5U-85F-8BG756",
            ("--85k", "--package", "CABGA756", "--speed", "8"),
            short="85F, grade 8",
            holds=Device(83_640, 83_640, 208),
        ),
        Target("cyclonev", CycloneV()),
        Target("xc7", Series7()),
        Target(
            "ecp5_grade6",
            ECP5,
            "LFE5U-85F-6BG756",
            ("--85k", "--package", "CABGA756", "--speed", "6"),
            short="85F, grade 6",
            holds=Device(83_640, 83_640, 208),
        ),
        Target(
            "ecp5_25f_grade6",
            ECP5,
            "LFE5U-25F-6BG381",
            ("--25k", "--package", "CABGA381", "--speed", "6"),
            short="25F, grade 6",
            holds=Device(24_288, 24_288, 56),
        ),
        Target(
            "ecp5_45f_grade6",
            ECP5,
            "LFE5U-45F-6BG381",
            ("--45k", "--package", "CABGA381", "--speed", "6"),
            short="45F, grade 6",
            holds=Device(43_848, 43_848, 108),
        ),
        # The Tang Nano 20K and 9K.
        Target(
            "gw2ar_18",
            _GOWIN,
            "GW2AR-LV18QN88C8/I7",
            ("--device", "GW2AR-LV18QN88C8/I7", "--vopt", "family=GW2A-18C"),
            ("4", "25", "26"),
            "GW2AR-18",
            Device(20_736, 15_552, 46),
        ),
        Target(
            "gw1nr_9",
            _GOWIN,
            "GW1NR-LV9QN88PC6/I5",
            ("--device", "GW1NR-LV9QN88PC6/I5", "--vopt", "family=GW1N-9C"),
            ("52", "25", "26"),
            "GW1NR-9",
            Device(8_640, 6_480, 26),
        ),
        Target(
            "up5k",
            _ICE40,
            "iCE40UP5K-SG48",
            ("--up5k", "--package", "sg48"),
            short="iCE40 UP5K",
            holds=Device(5_280, 5_280, 30),
        ),
        Target(
            "hx8k",
            _ICE40,
            "iCE40HX8K-CT256",
            ("--hx8k", "--package", "ct256"),
            short="iCE40 HX8K",
            holds=Device(7_680, 7_680, 32),
        ),
        Target(
            "lifcl_40",
            _NEXUS,
            "LIFCL-40-9BG400C",
            ("--device", "LIFCL-40-9BG400C"),
            ("L13", "G14", "E17"),
            "LIFCL-40, grade 9",
            Device(32_256, 32_256, 84),
        ),
        Target(
            "ccgm1a1", _GATEMATE, "CCGM1A1", ("--device", "CCGM1A1"), short="CCGM1A1", holds=Device(40_960, 40_960, 64)
        ),
    )
}
USUAL = ("ecp5", "cyclonev", "xc7")  # what implement.py takes when no target is named
ROUTED = [name for name, target in TARGETS.items() if target.device]
