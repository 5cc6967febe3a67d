# SPDX-License-Identifier: Apache-2.0
"""Block RAMs of a mapped ECP5 netlist, with the register behind them inside.

A block RAM's output comes late in the clock, and the way to a register behind it takes what is left. The RAM has such a
register of its own, which yosys does not infer.
"""

from __future__ import annotations

from typing import Any

from .ecp5_half import Bit, Cell


def use_output_registers(module: dict[str, Any]) -> int:
    """Returns how many ports of RAMs took their registers in. A port does where each of its outputs that is read goes
    to one register, of the same clock, always enabled and never set or reset."""
    cells: dict[str, Cell] = module["cells"]
    readers: dict[Bit, list[tuple[str, str]]] = {}
    for name, cell in cells.items():
        for port, bits in cell["connections"].items():
            if cell["port_directions"][port] != "output":
                for bit in bits:
                    readers.setdefault(bit, []).append((name, port))
    for port in module["ports"].values():
        for bit in port["bits"]:
            readers.setdefault(bit, []).append(("", ""))
    return sum(_take_in(cell, sides, cells, readers) for cell in list(cells.values()) for sides in _ports_of(cell))


def _ports_of(cell: Cell) -> list[str]:
    """The ports of a RAM that are read apart: words of 36 bits come out of both together."""
    if cell["type"] != "DP16KD":
        return []
    return ["AB"] if int(cell["parameters"]["DATA_WIDTH_B"], 2) == 36 else ["A", "B"]


def _take_in(memory: Cell, sides: str, cells: dict[str, Cell], readers: dict[Bit, list[tuple[str, str]]]) -> bool:
    parameters, connections = memory["parameters"], memory["connections"]
    if any(parameters[f"REGMODE_{side}"] != "NOREG" for side in sides):
        return False
    read = {
        port: (side, readers[bits[0]])
        for side in sides
        for port, bits in connections.items()
        if port.startswith(f"DO{side}") and bits and readers.get(bits[0])
    }
    plain = (len(r) == 1 and _is_plain(cells.get(r[0][0]), memory, sides, r[0][1]) for _, r in read.values())
    if not read or not all(plain):
        return False
    for port, (_, ((register, _),)) in read.items():
        connections[port] = cells.pop(register)["connections"]["Q"]
    for side in sides:
        parameters[f"REGMODE_{side}"] = "OUTREG"
        connections[f"OCE{side}"] = ["1"]
    return True


def _is_plain(reader: Cell | None, memory: Cell, sides: str, port: str) -> bool:
    """Whether a cell that reads an output is a register as the RAM has one."""
    if reader is None or reader["type"] != "TRELLIS_FF" or port not in ("DI", "M"):
        return False
    connections, parameters = reader["connections"], reader["parameters"]
    return bool(
        all(connections["CLK"] == memory["connections"][f"CLK{side}"] for side in sides)
        and parameters["CLKMUX"] == "CLK"
        and parameters["CEMUX"].strip() == "1"
        and connections.get("LSR", ["0"]) == ["0"]
        and parameters["REGSET"] == "RESET"
    )
