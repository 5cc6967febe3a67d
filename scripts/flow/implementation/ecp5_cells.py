# SPDX-License-Identifier: Apache-2.0
"""What cells of a mapped ECP5 netlist read, and those that nobody reads."""

from collections.abc import Iterator
from typing import Any

from .ecp5_half import Bit, Cell


def remove_unread_luts(module: dict[str, Any]) -> None:
    """Look-up tables that nobody reads, and those that only they read."""
    cells: dict[str, Cell] = module["cells"]
    outside = {bit for port in module["ports"].values() for bit in port["bits"]}
    luts = {name: cell["connections"]["Z"][0] for name, cell in cells.items() if cell["type"] == "LUT4"}
    while True:
        read = outside | {bit for cell in cells.values() for bit in inputs(cell)}
        unread = [name for name, output in luts.items() if output not in read]
        if not unread:
            return
        for name in unread:
            del cells[name], luts[name]


def inputs(cell: Cell) -> Iterator[Bit]:
    for port, bits in cell["connections"].items():
        if cell["port_directions"][port] != "output":
            yield from (bit for bit in bits if isinstance(bit, int))
