# SPDX-License-Identifier: Apache-2.0
"""The software pipeline of a camera_system: the frames that must come out, made by other means than its VHDL."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..base import files, rtl
from ..base.configurations import Configuration, clocks_per_pixel, configuration, designs, option
from ..base.tools import Word, find_stereo_hls, run
from ..cosim import vectors
from .template import System, beside_of, depths_of

LARGEST_MM = 65535
Image = Sequence[Sequence[int]]  # rows of grey values


class Node(NamedTuple):
    """Offsets in 2^-offset_fraction_bits pixels."""

    x: int
    y: int


Table = Sequence[Sequence[Node]]  # rows of nodes


def depth_table(system: System, focal_baseline: int, offset: int = 0) -> list[int]:
    """As examples/camera_system/README.md says. `focal_baseline`: in sixteenths of pixels times millimetres; `offset`:
    in sixteenths of pixels."""
    table, depths = depths_of(rows_of(system)[1]), []
    for entry in range(table.entries):
        parallax = (entry if table.subpixel else 16 * entry) - offset
        depth = (2 * focal_baseline + parallax) // (2 * parallax) if parallax > 0 else 0
        depths.append(depth if depth <= LARGEST_MM else 0)
    return depths


def rectified(image: Image, table: Table, row: Configuration) -> list[list[int]]:
    """docs/rectification.md, word by word."""
    grid, fraction, weight = (option(row, f"{name}") for name in ("grid_px", "offset_fraction_bits", "weight_bits"))
    above, below, unit = option(row, "rows_above"), option(row, "rows_below"), 1 << weight
    height, width = len(image), len(image[0])

    def rounded(numerator: int, denominator: int) -> int:
        return (2 * numerator + denominator) // (2 * denominator)

    def pixel(x: int, y: int) -> int:
        i, u, j, v = x // grid, x % grid, y // grid, y % grid
        corners = (
            (table[j][i], (grid - u) * (grid - v)),
            (table[j][i + 1], u * (grid - v)),
            (table[j + 1][i], (grid - u) * v),
            (table[j + 1][i + 1], u * v),
        )
        divisor = grid * grid << fraction
        at_x = x * unit + rounded(unit * sum(node.x * share for node, share in corners), divisor)
        at_y = y * unit + rounded(unit * sum(node.y * share for node, share in corners), divisor)
        c, a, r, b = at_x // unit, at_x % unit, at_y // unit, at_y % unit

        def tap(column: int, line: int) -> int:
            inside = 0 <= column < width and 0 <= line < height and y - above <= line <= y + below
            return image[line][column] if inside else 0

        upper = (unit - a) * tap(c, r) + a * tap(c + 1, r)
        lower = (unit - a) * tap(c, r + 1) + a * tap(c + 1, r + 1)
        return rounded((unit - b) * upper + b * lower, unit * unit)

    return [[pixel(x, y) for x in range(width)] for y in range(height)]


def write_pgm(path: Path, image: Image, pixel_bits: int = rtl.PIXEL_BITS) -> Path:
    """Of 16 bits where grey values have more than 8."""
    width, height, pixels = len(image[0]), len(image), [value for row in image for value in row]
    deep = pixel_bits > rtl.PIXEL_BITS
    path.write_bytes(files.deep_pgm(width, height, pixels) if deep else files.pgm(width, height, bytes(pixels)))
    return path


def depth_frame(system: System, left: Path, right: Path, depths: Sequence[int], work: Path, image: Image) -> list[int]:
    """The beats of m_axis for a rectified pair, as examples/camera_system/README.md says. `image`: the left one."""
    command: list[Word] = [
        find_stereo_hls(),
        "vectors",
        "--config",
        system.matching,
        "--left",
        left,
        "--right",
        right,
        "--out",
        work,
    ]
    run(command, passes_errors=True)
    more, beats = beside_of(system), []
    first = rows_of(system)[1]["output_first_column"]
    for output in vectors.read_expected(work / "expected.txt")[0]:
        pixel = image[output.y][first + output.x] if system.left_image else 0
        beats.append(more.beat(output.disparity, output.flags >> 2 & 1, depths, pixel))
    return beats


def read_table(path: Path, row: Configuration) -> list[list[Node]]:
    """A *_table.hex of `stereo_hls rectify`."""
    bits = option(row, "offset_bits")

    def signed(value: int) -> int:
        value &= (1 << bits) - 1
        return value - (1 << bits) if value >> (bits - 1) else value

    words = [int(line, 16) for line in re.findall(r"\w+", path.read_text())]
    nodes = [Node(signed(word), signed(word >> bits)) for word in words]
    columns = option(row, "table_columns")
    return [nodes[at : at + columns] for at in range(0, len(nodes), columns)]


def line_clocks(system: System) -> int:
    """That a camera's line takes at least, with its pause: as many as the core takes for its pairs."""
    core = rows_of(system)[1]
    return core["width_px"] * clocks_per_pixel(core)


def pause_clocks(system: System) -> int:
    """Between two frames, for a frame that a camera damages to cost no other: the last rows come out, and two lines'
    time makes up what is late."""
    stage, core = rows_of(system)
    return (stage["flush_groups"] + core["flush_groups"] + 2 * core["width_px"]) * clocks_per_pixel(core)


def rows_of(system: System) -> tuple[Configuration, Configuration]:
    """(rectification, matching)"""
    table = designs()
    return configuration(system.rectification, table), configuration(system.matching, table)
