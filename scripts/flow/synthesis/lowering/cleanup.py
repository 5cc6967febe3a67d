# SPDX-License-Identifier: Apache-2.0
"""Passes after which a netlist has less of the same: no register twice, nothing that no output needs."""

from __future__ import annotations

from .expressions import Node, walk
from .netlist import Memory, Netlist, Register


def remove_unused(netlist: Netlist) -> None:
    """Drops registers and memories that no output depends on."""
    owners: dict[int, Register | Memory] = {id(r.value): r for r in netlist.registers}
    owners |= {id(m.data): m for m in netlist.memories}
    alive, frontier = set(), list(netlist.outputs.values())
    while frontier:
        found: list[Node] = []
        for node in walk(frontier):
            owner = owners.get(id(node))
            if owner is not None and id(owner) not in alive:
                alive.add(id(owner))
                if isinstance(owner, Register):
                    found.append(owner.next)
                else:
                    found += [owner.read_address, owner.write_address, owner.write_data]
        frontier = found
    netlist.registers = [r for r in netlist.registers if id(r) in alive]
    netlist.memories = [m for m in netlist.memories if id(m) in alive]


def merge_twins(netlist: Netlist) -> None:
    """Makes one register of those that always hold the same value because they start and continue alike."""
    while True:
        first: dict[tuple[int, int], Register] = {}
        twins = {}
        for register in netlist.registers:
            keeper = first.setdefault((register.initial, id(register.next)), register)
            if keeper is not register:
                twins[id(register.value)] = keeper.value
        if not twins:
            return
        netlist.registers = [r for r in netlist.registers if id(r.value) not in twins]
        netlist.substitute(twins)
