# SPDX-License-Identifier: Apache-2.0
"""Registers of a mapped ECP5 netlist that enable or reset very many others, in copies.

A core waits in bubbles, so one register enables nearly all others; in a shell, one resets them. Its way over the device
takes longer than a clock, and nextpnr gives global nets to clocks alone. Each copy drives registers that hang together,
which a placer puts side by side.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import Any

from .ecp5_half import Bit, Cell

# Up to this the one register gets along: that of `sgm_450` enables 11,537 and routes above its aim. In `sgm_640` it is
# 22,722. The reset of `vga_64` in its shell has 13,844 readers.
LARGEST_CONTROLS = {"CE": 16_384, "LSR": 12_288}
# In a larger design the readers stand further apart: `sgm_450_dense` has 34,872 registers, and one enables 11,724.
LARGE_DESIGN = 32_768
LARGEST_CONTROLS_THERE = LARGEST_CONTROLS | {"CE": 8_192}
READERS_OF_A_COPY = 1_024
# A net of more readers says nothing about which of them belong together.
LARGEST_NEIGHBOURHOOD = 8


def largest_controls(registers: int) -> Mapping[str, int]:
    """{pin: readers up to which one register is enough}, of a design with so many registers."""
    return LARGEST_CONTROLS_THERE if registers > LARGE_DESIGN else LARGEST_CONTROLS


def copy_wide_controls(
    module: dict[str, Any],
    largest: Mapping[str, int] | None = None,
    readers_of_a_copy: int = READERS_OF_A_COPY,
) -> int:
    """Returns how many registers were added. Only clock enables and resets of registers change to a copy. `largest`:
    {pin: readers up to which there is no copy}, by itself those of a design of that size."""
    cells: dict[str, Cell] = module["cells"]
    registers = {name: cell for name, cell in cells.items() if cell["type"] == "TRELLIS_FF"}
    largest = largest_controls(len(registers)) if largest is None else largest
    drivers = {cell["connections"]["Q"][0]: name for name, cell in registers.items()}
    used = (b for cell in cells.values() for bits in cell["connections"].values() for b in bits if isinstance(b, int))
    first_free = 1 + max(used)
    added = 0
    for pin in largest:
        driven: dict[Bit, list[str]] = {}
        for name, cell in registers.items():
            for bit in cell["connections"].get(pin, []):
                driven.setdefault(bit, []).append(name)
        for net, readers in driven.items():
            if len(readers) > largest[pin] and net in drivers:
                for number, cluster in enumerate(_clusters(cells, readers, readers_of_a_copy)):
                    _copy(module, f"{drivers[net]}_{pin}_copy_{number}", drivers[net], pin, cluster, first_free + added)
                    added += 1
    return added


def _copy(module: dict[str, Any], name: str, driver: str, pin: str, readers: list[str], bit: Bit) -> None:
    """Adds the register `name`, a copy of `driver` that shows `bit` to the readers."""
    cells: dict[str, Cell] = module["cells"]
    original = cells[driver]
    cells[name] = original | {"connections": original["connections"] | {"Q": [bit]}}
    module["netnames"][f"{name}_Q"] = {"hide_name": 0, "bits": [bit], "attributes": {}}
    for reader in readers:
        cells[reader]["connections"][pin] = [bit]


def _clusters(cells: dict[str, Cell], readers: list[str], size: int) -> list[list[str]]:
    """The readers in sets of at most `size`, each grown from one of them over its neighbours."""
    neighbours = _neighbours(cells)
    left = dict.fromkeys(readers)
    clusters = []
    start = readers[0]
    while left:
        cluster: list[str] = []
        waiting, seen = deque([start]), {start}
        while left and len(cluster) < size:
            if not waiting:  # the small remainders form the last ones together
                waiting.append(next(iter(left)))
                seen.add(waiting[0])
            name = waiting.popleft()
            if name in left:
                del left[name]
                cluster.append(name)
            fresh = [other for other in neighbours.get(name, ()) if other not in seen]
            seen.update(fresh)
            waiting.extend(fresh)
        clusters.append(cluster)
        # The next one begins where this one ended, so that fewer remainders stay.
        start = next((name for name in waiting if name in left), next(iter(left), ""))
    return clusters


def _neighbours(cells: dict[str, Cell]) -> dict[str, list[str]]:
    """{cell: those that a net of few cells joins with it}."""
    joined: dict[Bit, dict[str, None]] = {}
    for name, cell in cells.items():
        for bits in cell["connections"].values():
            for bit in bits:
                if isinstance(bit, int):
                    joined.setdefault(bit, {})[name] = None
    result: dict[str, list[str]] = {}
    for names in joined.values():
        if len(names) <= LARGEST_NEIGHBOURHOOD:
            for name in names:
                result.setdefault(name, []).extend(other for other in names if other != name)
    return result
