# SPDX-License-Identifier: Apache-2.0
"""A plan as text and as JSON."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from ..base.markdown import UNKNOWN
from .candidates import Camera, row_text
from .compared import compare, size_of
from .model import Implemented
from .search import MEASURED, Number, Place, Planned

FORMAT = "stereo-hls plan 1"


@dataclass(frozen=True)
class Row:
    """What is to be done for a plan. text: the row to add, empty where it is there."""

    number: int  # of the plan
    name: str
    text: str
    file: str
    commands: tuple[str, ...]

    @classmethod
    def of(cls, number: int, planned: Planned, place: Place, name: str | None) -> Row:
        c = planned.candidate
        o = c.options
        name = planned.row or name or _name(planned)
        row = "" if planned.row else row_text(name, c)
        images = f"--left build/scenes/{name}/left.png --right build/scenes/{name}/right.png"
        commands = (
            f"scripts/setup.sh --core {name}",
            f"BAMBU=/path/to/bambu.AppImage scripts/synthesize.py --config {name}",
            f"build/release/stereo_hls scene --config {name} --seed 1 --out build/scenes/{name}",
            f"scripts/cosim.py --config {name} {images} --rows 16",
            f"scripts/implement.py --config {name} --target {place.target}",
        )
        return cls(number, name, row, f"hls/{o['family']}/configurations.hpp", commands)


def _name(planned: Planned) -> str:
    o = planned.candidate.options
    clocks, pixels = o["clocks_per_pixel"], o["pixels_per_clock"]
    suffix = f"_f{clocks}" if clocks > 1 else f"_p{pixels}" if pixels > 1 else ""
    return f"my_{planned.candidate.algorithm.config.split('_')[0]}_{o['width_px']}_{o['disparities']}{suffix}"


def speed(planned: Planned) -> str:
    """Clocks a pixel pair, or pixel pairs a clock, in a few letters."""
    o = planned.candidate.options
    return f"P={o['pixels_per_clock']}" if o["pixels_per_clock"] > 1 else f"F={o['clocks_per_pixel']}"


def _shown(number: Number | None) -> str:
    if number is None:
        return UNKNOWN
    return f"{number.value:,.0f}{'' if number.kind == MEASURED else '*'}"


def head(planned: Planned) -> list[str]:
    return [
        "algorithm",
        "from",
        "speed",
        "clocks a frame",
        "MHz needed",
        "MHz expected",
        "LUTs",
        "LUT sites",
        "flip-flops",
        "flip-flop sites",
        "block RAMs",
        *(f"wrong, {pair}" for pair in planned.candidate.algorithm.wrong),
        "is there as",
    ]


def cells(planned: Planned) -> list[str]:
    c = planned.candidate
    return [
        c.algorithm.title,
        c.algorithm.config,
        speed(planned),
        f"{c.clocks_a_frame:,}",
        f"{planned.needed_mhz:.1f}",
        _shown(planned.numbers.mhz),
        _shown(planned.numbers.luts),
        _shown(planned.numbers.lut_sites),
        _shown(planned.numbers.flip_flops),
        _shown(planned.numbers.flip_flop_sites),
        _shown(planned.numbers.block_rams),
        *c.algorithm.wrong.values(),
        planned.row or UNKNOWN,
    ]


def _aligned(lines: Sequence[Sequence[str]]) -> str:
    widths = [max(len(cell) for cell in column) for column in zip(*lines)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines)


def _camera(camera: Camera, place: Place) -> str:
    wishes = [*camera.checks, *(f"{name}={value}" for name, value in camera.settings.items())]
    beside = f", with {', '.join(wishes)}" if wishes else ""
    logic = f"{place.device.lut_sites:,} LUT sites and {place.device.flip_flops:,} flip-flops, of them {place.fill:g} %"
    device = f"{logic}, {place.device.block_rams} block RAMs"
    return (
        f"{camera.width_px}x{camera.height_px}, {camera.frames_per_second:g} frames a second, "
        f"{camera.disparities} disparities{beside}, on {place.target}: {device}"
    )


def accuracy(known: Sequence[Implemented]) -> str:
    """One sentence."""
    found = compare(known)
    luts, mhz = size_of(c.luts_error for c in found), size_of(c.mhz_error for c in found)
    flip_flops = size_of(c.flip_flops_error for c in found)
    if luts is None or mhz is None or flip_flops is None:
        return "* an estimate; no core is measured beside it."
    return (
        f"* an estimate: half of the routed cores, each left out of its own estimate, differ by less than "
        f"{100 * luts:.0f} % in LUTs, {100 * flip_flops:.0f} % in flip-flops and "
        f"{100 * mhz:.0f} % in clock (docs/plan.md)."
    )


def text(
    camera: Camera,
    place: Place,
    shown: Sequence[Planned],
    closest: Sequence[Planned],
    row: Row | None,
    known: Sequence[Implemented],
) -> str:
    parts = [_camera(camera, place)]
    if shown:
        numbered = [["", *head(shown[0])], *([str(i), *cells(planned)] for i, planned in enumerate(shown, 1))]
        parts.append(_aligned(numbered))
        parts.append(
            accuracy(known)
            + "\nF: clocks a pixel pair; P: pixel pairs a clock. Wrong pixels are those of the algorithm "
            "with a map of full width, where it has one, on whole images (docs/quality.md)."
        )
    else:
        parts.append("Nothing fits.")
    if closest:
        lines = [[planned.candidate.algorithm.title, speed(planned), "; ".join(planned.reasons)] for planned in closest]
        parts.append("Does not fit, of each the nearest:\n" + _aligned(lines))
    if row:
        add = f"add this row to {row.file}:\n  {row.text}" if row.text else f"its row is there: {row.name}."
        parts.append(f"For number {row.number} {add}\nThen:\n" + "\n".join(f"  {command}" for command in row.commands))
    return "\n\n".join(parts)


def _json(planned: Planned) -> dict[str, Any]:
    c = planned.candidate
    found: dict[str, Any] = {
        "algorithm": c.algorithm.title,
        "base": c.algorithm.config,
        "family": c.family,
        "changes": c.changes,
        "clocks_per_pixel": c.options["clocks_per_pixel"],
        "pixels_per_clock": c.options["pixels_per_clock"],
        "row": planned.row,
        "needed_mhz": round(planned.needed_mhz, 2),
        "wrong_percent": {pair: float(value.split()[0]) for pair, value in c.algorithm.wrong.items()},
        "reasons": list(planned.reasons),
    }
    if not c.problem:
        found["clocks_a_frame"] = c.clocks_a_frame
    numbers = {
        "mhz": planned.numbers.mhz,
        "luts": planned.numbers.luts,
        "lut_sites": planned.numbers.lut_sites,
        "flip_flops": planned.numbers.flip_flops,
        "flip_flop_sites": planned.numbers.flip_flop_sites,
        "block_rams": planned.numbers.block_rams,
    }
    return found | {name: value and value.as_json() for name, value in numbers.items()}


def as_json(
    camera: Camera, place: Place, shown: Iterable[Planned], closest: Iterable[Planned], row: Row | None
) -> dict[str, Any]:
    return {
        "format": FORMAT,
        "camera": {
            "width_px": camera.width_px,
            "height_px": camera.height_px,
            "frames_per_second": camera.frames_per_second,
            "disparities": camera.disparities,
            "with": list(camera.checks),
            "settings": camera.settings,
        },
        "device": {
            "target": place.target,
            "lut_sites": place.device.lut_sites,
            "flip_flops": place.device.flip_flops,
            "block_rams": place.device.block_rams,
            "fill_percent": place.fill,
            "margin_percent": place.margin,
        },
        "fits": [_json(planned) for planned in shown],
        "does_not_fit": [_json(planned) for planned in closest],
        "add": row
        and {"number": row.number, "name": row.name, "row": row.text, "file": row.file, "commands": list(row.commands)},
    }
