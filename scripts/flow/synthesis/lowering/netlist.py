# SPDX-License-Identifier: Apache-2.0
"""The design between reading and writing: inputs, outputs, registers and memories, joined by expressions (expressions.py)."""

from dataclasses import dataclass, field
from typing import Optional

from .expressions import Node, leaf, rebuild, shift_right, walk, wrap


@dataclass
class Register:
    """Takes `next` at every clock edge; starts with `initial`."""

    name: str
    value: Node
    initial: int = 0
    next: Optional[Node] = None


@dataclass
class Memory:
    """`depth` words of `width` bits, all 0 at start. One read and one write a clock, each from a register; the read data is
    the leaf `data`, and a read sees what the word was before a write of the same clock."""

    name: str
    depth: int
    width: int
    data: Node
    read_address: Optional[Node] = None
    write_address: Optional[Node] = None
    write_data: Optional[Node] = None


@dataclass
class Netlist:
    inputs: dict = field(default_factory=dict)  # name -> Node
    outputs: dict = field(default_factory=dict)  # name -> Node
    registers: list = field(default_factory=list)
    memories: list = field(default_factory=list)

    def roots(self):
        """Every expression that leads somewhere."""
        yield from self.outputs.values()
        for register in self.registers:
            yield register.next
        for memory in self.memories:
            yield from (memory.read_address, memory.write_address, memory.write_data)

    def substitute(self, replacement):
        """Replaces leaves (id of the leaf -> node) in every expression."""
        done = {}

        def again(node):
            return rebuild(node, replacement, done)

        self.outputs = {name: again(node) for name, node in self.outputs.items()}
        for register in self.registers:
            register.next = again(register.next)
        for memory in self.memories:
            memory.read_address, memory.write_address = again(memory.read_address), again(memory.write_address)
            memory.write_data = again(memory.write_data)


def join_memory_slices(netlist):
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
        whole = Register(
            f"{memory.name}_word", leaf("register", f"{memory.name}_word", memory.width), initial, memory.data
        )
        netlist.registers = [r for r in netlist.registers if id(r.value) not in parts] + [whole]
        netlist.substitute(
            {key: wrap(shift_right(whole.value, low), register.value.width) for key, (register, low) in parts.items()}
        )


def _slice_of(node, word):
    """The lowest bit of the part of `word` that the node is, else None."""
    if node.op == "wrap" and not node.param[1]:
        node = node.args[0]
    if node is word:
        return 0
    return node.param if node.op == "shr" and node.args[0] is word else None


def merge_twins(netlist):
    """Makes one register of those that always hold the same value because they start and continue alike."""
    while True:
        first, twins = {}, {}
        for register in netlist.registers:
            key = (register.initial, id(register.next))
            keeper = first.setdefault(key, register)
            if keeper is not register:
                twins[id(register.value)] = keeper.value
        if not twins:
            return
        netlist.registers = [r for r in netlist.registers if id(r.value) not in twins]
        netlist.substitute(twins)


def remove_unused(netlist):
    """Drops registers and memories that no output depends on."""
    by_value = {id(r.value): r for r in netlist.registers}
    by_data = {id(m.data): m for m in netlist.memories}
    alive, frontier = set(), list(netlist.outputs.values())
    while frontier:
        found = []
        for node in walk(frontier):
            owner = by_value.get(id(node)) or by_data.get(id(node))
            if owner is not None and id(owner) not in alive:
                alive.add(id(owner))
                found += (
                    [owner.next]
                    if isinstance(owner, Register)
                    else [owner.read_address, owner.write_address, owner.write_data]
                )
        frontier = found
    netlist.registers = [r for r in netlist.registers if id(r) in alive]
    netlist.memories = [m for m in netlist.memories if id(m) in alive]
