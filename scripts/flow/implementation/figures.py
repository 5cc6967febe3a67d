# SPDX-License-Identifier: Apache-2.0
"""What a configuration does in a clock and in a second."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypedDict

from ..base.configurations import Parameters, Size, clocks_per_pixel
from .record import Area, Fill
from .targets import TARGETS

_CELLS = {cell: word for target in TARGETS.values() for cell, word in target.family.words.items()}


class Speed(TypedDict):
    frames_per_second: float
    mde_per_second: float  # million disparity evaluations, W*H*D each frame
    output_mde_per_second: float  # of the columns and rows with an output only
    evaluations_per_second_per_lut: float


def clocks_per_frame(parameters: Parameters) -> int:
    """Frames as close to each other as they may be take a clock, or as many as the core needs, for each group of pixel
    pairs and, with recursive sums, for each group of the gap between them; co-simulation measures the same."""
    groups = parameters["width_px"] * parameters["height_px"] // parameters["pixels_per_clock"]
    return (groups + parameters["gap_groups"]) * clocks_per_pixel(parameters)


def evaluations_per_frame(size: Size) -> int:
    """Disparity evaluations as publications count them: W*H*D."""
    return size["width_px"] * size["height_px"] * size["disparities"]


def output_evaluations_per_frame(parameters: Parameters) -> int:
    """Of the pixels that the map has."""
    return parameters["output_width_px"] * parameters["output_height_px"] * parameters["disparities"]


def evaluations_per_clock(parameters: Parameters) -> float:
    return evaluations_per_frame(parameters) / clocks_per_frame(parameters)


def frames_per_second(parameters: Parameters, fmax_mhz: float) -> float:
    return fmax_mhz * 1e6 / clocks_per_frame(parameters)


def speed(parameters: Parameters, fmax_mhz: float, luts: int) -> Speed:
    frames = frames_per_second(parameters, fmax_mhz)
    evaluations = frames * evaluations_per_frame(parameters)
    return {
        "frames_per_second": frames,
        "mde_per_second": evaluations / 1e6,
        "output_mde_per_second": frames * output_evaluations_per_frame(parameters) / 1e6,
        "evaluations_per_second_per_lut": evaluations / luts,
    }


def counted(seeds: int, router: str | None = None) -> str:
    """What a clock of so many seeds is. nextpnr's usual router is not named."""
    of = "one seed" if seeds == 1 else f"median of {seeds}"
    return of if router in (None, "router1") else f"{of}, {router}"


def overfull(cells: Mapping[str, Fill]) -> str:
    """The figures that show that a device is too small."""
    return ", ".join(f"{fill['used']} of {fill['available']} {_CELLS.get(cell, cell)}" for cell, fill in cells.items())


def lut_count(area: Area) -> int:
    """LUTs or ALUTs."""
    return area["aluts"] if "aluts" in area else area["luts"]
