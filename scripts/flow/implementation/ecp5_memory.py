# SPDX-License-Identifier: Apache-2.0
"""Block RAMs of a mapped ECP5 netlist, with the register behind them inside.

A block RAM's output comes late in the clock, and the way to a register behind it takes what is left. The RAM has such a
register of its own, which yosys does not infer.
"""

from typing import Any

from .ecp5_carry import Bit, Cell

# Port of a DP16KD: the names of its outputs begin so.
OUTPUTS = {"A": "DOA", "B": "DOB"}


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
    changed = 0
    for cell in [cell for cell in cells.values() if cell["type"] == "DP16KD"]:
        for side, start in OUTPUTS.items():
            outputs = {p: bits[0] for p, bits in cell["connections"].items() if p.startswith(start) and bits}
            read = {p: readers[bit] for p, bit in outputs.items() if readers.get(bit)}
            if (
                cell["parameters"][f"REGMODE_{side}"] != "NOREG"
                or cell["connections"][f"OCE{side}"] != ["1"]
                or not read
            ):
                continue
            if not all(len(r) == 1 and _is_plain(cells.get(r[0][0]), cell, side, r[0][1]) for r in read.values()):
                continue
            for port, ((register, _),) in read.items():
                cell["connections"][port] = cells.pop(register)["connections"]["Q"]
            cell["parameters"][f"REGMODE_{side}"] = "OUTREG"
            changed += 1
    return changed


def _is_plain(reader: Cell | None, memory: Cell, side: str, port: str) -> bool:
    """Whether a cell that reads an output is a register as the RAM has one."""
    if reader is None or reader["type"] != "TRELLIS_FF" or port not in ("DI", "M"):
        return False
    connections, parameters = reader["connections"], reader["parameters"]
    return bool(
        connections["CLK"] == memory["connections"][f"CLK{side}"]
        and parameters["CLKMUX"] == "CLK"
        and parameters["CEMUX"].strip() == "1"
        and connections.get("LSR", ["0"]) == ["0"]
        and parameters["REGSET"] == "RESET"
    )
