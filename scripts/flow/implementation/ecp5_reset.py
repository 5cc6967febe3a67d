# SPDX-License-Identifier: Apache-2.0
"""Resets of a few registers in a mapped ECP5 netlist, as logic in front of these registers.

yosys gives a register a reset of its own where its input is a choice between something and 0, as for an index whose
losing candidate has a 0 there. nextpnr puts registers of different resets into different tiles: in a large design the
few of such a reset stand far from the logic around them.
"""

from typing import Any

from .ecp5_cells import remove_unread_luts
from .ecp5_half import PINS, Bit, Cell, Table, identity, look_up, tabulate, with_input

# Registers of a design in which that counts: in a smaller one a tile is never far.
SMALLEST_DESIGN = 32_768
# Registers of such a reset. A tile has eight, of two resets at most.
MOST_READERS = 16


def resets_to_logic(module: dict[str, Any], smallest: int = SMALLEST_DESIGN, most_readers: int = MOST_READERS) -> int:
    """Returns how many registers lost their reset. Those with a clock enable keep it, and those that a port resets."""
    cells: dict[str, Cell] = module["cells"]
    registers = [cell for cell in cells.values() if cell["type"] == "TRELLIS_FF"]
    if len(registers) < smallest:
        return 0
    luts = {cell["connections"]["Z"][0]: cell for cell in cells.values() if cell["type"] == "LUT4"}
    ports = {bit for port in module["ports"].values() for bit in port["bits"]}
    used = (b for cell in cells.values() for bits in cell["connections"].values() for b in bits if isinstance(b, int))
    next_net = 1 + max(used)
    resets: dict[Bit, list[Cell]] = {}
    for register in registers:
        for bit in register["connections"].get("LSR", []):
            if isinstance(bit, int) and bit not in ports:
                resets.setdefault(bit, []).append(register)
    changed = 0
    for reset, held in resets.items():
        if len(held) > most_readers:
            continue
        for register in filter(_is_always_enabled, held):
            _add_lut(module, next_net, _with_reset(register, reset, luts))
            register["connections"] |= {"DI": [next_net], "LSR": ["0"]}
            register["parameters"] |= {"LSRMUX": "LSR", "REGSET": "RESET"}
            next_net += 1
            changed += 1
    remove_unread_luts(module)
    return changed


def _is_always_enabled(register: Cell) -> bool:
    return "DI" in register["connections"] and register["parameters"]["CEMUX"].strip() == "1"


def _table(net: Bit, luts: dict[Bit, Cell]) -> Table:
    """Of the look-up table that makes it, or of the net itself."""
    return look_up(luts[net], "INIT", tuple(PINS)) if net in luts else identity(net)


def _with_reset(register: Cell, reset: Bit, luts: dict[Bit, Cell]) -> Table:
    """What comes into the register: one look-up table behind what came in before and what reset it, or in the place of
    theirs if four inputs are enough."""
    parameters, (data,) = register["parameters"], register["connections"]["DI"]
    active, value = int(parameters["LSRMUX"] != "INV"), int(parameters["REGSET"] == "SET")
    known = {"0": 0, "1": 1, "x": 0}

    def held(values: dict[Bit, int]) -> int:
        return value if values[reset] == active else known[data] if isinstance(data, str) else values[data]

    nets = dict.fromkeys([*([data] if isinstance(data, int) else []), reset])
    behind = tabulate(tuple(nets), held)
    of_reset = with_input(behind, reset, _table(reset, luts))
    choices = (with_input(of_reset, data, _table(data, luts)), of_reset)
    return next((table for table in choices if len(table.nets) <= len(PINS)), behind)


def _add_lut(module: dict[str, Any], output: Bit, table: Table) -> None:
    unused = len(PINS) - len(table.nets)
    rows = 1 << len(table.nets)
    ones = sum(table.ones << rows * copy for copy in range(1 << unused))
    name = f"reset_as_logic_{output}"
    module["netnames"][f"{name}_Z"] = {"hide_name": 0, "bits": [output], "attributes": {}}
    module["cells"][name] = {
        "hide_name": 0,
        "type": "LUT4",
        "parameters": {"INIT": f"{ones:016b}"},
        "attributes": {},
        "port_directions": {**dict.fromkeys(PINS, "input"), "Z": "output"},
        "connections": {**{pin: [net] for pin, net in zip(PINS, (*table.nets, *["0"] * unused))}, "Z": [output]},
    }
