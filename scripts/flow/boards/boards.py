# SPDX-License-Identifier: Apache-2.0
"""The boards that examples/boards is made for. A new board is a row and a file of constraints."""

from __future__ import annotations

from dataclasses import dataclass

from ..base.errors import FlowError
from ..implementation.targets import ECP5, TARGETS, Device, Target


@dataclass(frozen=True)
class Board:
    name: str
    title: str
    target: Target
    constraints: str  # file in examples/boards
    clock_mhz: int
    config: str  # the core that it gets where the user names none
    leds: int
    leds_active_low: bool = False
    button_active_low: bool = False
    baud: int = 1_000_000  # clock_mhz is a multiple of it
    held_high: tuple[str, ...] = ()  # pins that give a 1, beside those of board_top

    def generics(self) -> dict[str, int | str]:
        """Of board_top."""
        return {
            "clock_hz": self.clock_mhz * 1_000_000,
            "baud": self.baud,
            "leds": self.leds,
            "leds_active_low": str(self.leds_active_low).lower(),
            "button_active_low": str(self.button_active_low).lower(),
        }


BOARDS = {
    board.name: board
    for board in (
        Board(
            "ulx3s_85f",
            "ULX3S with an LFE5U-85F",
            Target(
                "ulx3s_85f",
                ECP5,
                "LFE5U-85F-6BG381",
                ("--85k", "--package", "CABGA381", "--speed", "6"),
                holds=Device(83_640, 83_640, 208),
            ),
            "ulx3s.lpf",
            25,
            "sgm_640_64_f8_road",
            8,
            held_high=("esp32_gpio0",),
        ),
        Board(
            "ulx3s_25f",
            "ULX3S with an LFE5U-25F",
            TARGETS["ecp5_25f_grade6"],
            "ulx3s.lpf",
            25,
            "sgm_320_64_f16",
            8,
            held_high=("esp32_gpio0",),
        ),
        Board(
            "tang_nano_20k",
            "Tang Nano 20K",
            TARGETS["gw2ar_18"],
            "tang_nano_20k.cst",
            27,
            "sgm_320_64_f16",
            6,
            leds_active_low=True,
        ),
        Board(
            "icebreaker",
            "iCEBreaker",
            TARGETS["up5k"],
            "icebreaker.pcf",
            12,
            "ambrosch2007_f20",
            2,
            leds_active_low=True,
            button_active_low=True,
        ),
    )
}
FIRST = "ulx3s_85f"  # of a command that is told no board


def named(name: str) -> Board:
    if name not in BOARDS:
        raise FlowError(f"unknown board '{name}'; known are: {', '.join(BOARDS)}")
    return BOARDS[name]
