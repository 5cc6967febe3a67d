# SPDX-License-Identifier: Apache-2.0
"""Passes that give each memory whole words, no wider than what is read, and one register that takes them."""

from __future__ import annotations

from .expressions import Node, leaf, shift_right, wrap
from .netlist import Netlist, Register
from .readers import read_width, readers_of


def narrow_memories(netlist: Netlist) -> None:
    """Drops the upper bits of memory words that nobody reads."""
    readers = readers_of(netlist)
    for memory in netlist.memories:
        width = read_width(readers, memory.data)
        if width is not None and width < memory.width:
            narrow = leaf("memory", memory.name, width)
            netlist.substitute({id(memory.data): narrow})
            memory.data, memory.width, memory.write_data = narrow, width, wrap(memory.write_data, width)


def join_memory_slices(netlist: Netlist) -> None:
    """Where registers take parts of a memory's data, one register takes the whole word and they become parts of it."""
    for memory in netlist.memories:
        parts = {}
        for register in netlist.registers:
            place = _slice_of(register.next, memory.data)
            if place is not None:
                parts[id(register.value)] = (register, place)
        if not parts or all(register.next is memory.data for register, _ in parts.values()):
            continue
        initial = 0
        for register, low in parts.values():
            initial |= register.initial << low
        name = f"{memory.name}_word"
        whole = Register(name, leaf("register", name, memory.width), initial, memory.data)
        netlist.registers = [r for r in netlist.registers if id(r.value) not in parts] + [whole]
        netlist.substitute(
            {key: wrap(shift_right(whole.value, low), part.value.width) for key, (part, low) in parts.items()}
        )


def _slice_of(node: Node, word: Node) -> int | None:
    """The lowest bit of the part of `word` that the node is, else None."""
    if node.op == "wrap" and not node.wrapping[1]:
        node = node.args[0]
    if node is word:
        return 0
    return node.number if node.op == "shr" and node.args[0] is word else None
