# SPDX-License-Identifier: Apache-2.0
"""Registers of a mapped ECP5 netlist that enable very many others, in copies.

A core waits in bubbles, so one register enables nearly all others. Its way over the device takes longer than a clock.
Each copy enables registers that hang together, which a placer puts side by side.
"""

from collections import deque
from typing import Any

from .ecp5_half import Bit, Cell

# Below this the one register gets along: `sgm_450` has 11,537 readers and routes above its aim. `sgm_640` has 22,722.
LARGEST_ENABLE = 16_384
READERS_OF_A_COPY = 1_024
# A net of more readers says nothing about which of them belong together.
LARGEST_NEIGHBOURHOOD = 8


def copy_wide_enables(
    module: dict[str, Any], largest: int = LARGEST_ENABLE, readers_of_a_copy: int = READERS_OF_A_COPY
) -> int:
    """Returns how many registers were added. Only clock enables of registers change to a copy."""
    cells: dict[str, Cell] = module["cells"]
    enabled: dict[Bit, list[str]] = {}
    for name, cell in cells.items():
        if cell["type"] == "TRELLIS_FF":
            for bit in cell["connections"].get("CE", []):
                enabled.setdefault(bit, []).append(name)
    drivers = {cell["connections"]["Q"][0]: name for name, cell in cells.items() if cell["type"] == "TRELLIS_FF"}
    added = 0
    for net, readers in enabled.items():
        if len(readers) > largest and net in drivers:
            for number, cluster in enumerate(_clusters(cells, readers, readers_of_a_copy)):
                _copy(module, drivers[net], net, cluster, number)
                added += 1
    return added


def _copy(module: dict[str, Any], driver: str, net: Bit, readers: list[str], number: int) -> None:
    cells: dict[str, Cell] = module["cells"]
    bit = 1 + max(
        b for cell in cells.values() for bits in cell["connections"].values() for b in bits if isinstance(b, int)
    )
    original = cells[driver]
    cells[f"{driver}_copy_{number}"] = original | {"connections": original["connections"] | {"Q": [bit]}}
    module["netnames"][f"{driver}_copy_{number}_Q"] = {"hide_name": 0, "bits": [bit], "attributes": {}}
    for reader in readers:
        cells[reader]["connections"]["CE"] = [bit]


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
