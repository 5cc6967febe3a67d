# SPDX-License-Identifier: Apache-2.0
"""The design between reading and writing: inputs, outputs, registers and memories, joined by expressions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from ...base import rtl
from .expressions import Node, const, rebuild


class Register:
    """Takes `next` at every clock edge; starts with `initial`. Keeps its value until it is connected."""

    def __init__(self, name: str, value: Node, initial: int = 0, next: Node | None = None) -> None:
        self.name, self.value, self.initial = name, value, initial
        self.next = value if next is None else next


@dataclass(eq=False)
class Memory:
    """`depth` words of `width` bits, all 0 at start. One read and one write a clock, each from a register; the read
    data is the leaf `data`, and a read sees what the word was before a write of the same clock."""

    name: str
    depth: int
    width: int
    data: Node
    read_address: Node = field(default_factory=lambda: const(0))  # until it is connected
    write_address: Node = field(default_factory=lambda: const(0))
    write_data: Node = field(default_factory=lambda: const(0))


@dataclass
class Netlist:
    inputs: dict[str, Node] = field(default_factory=dict)
    outputs: dict[str, Node] = field(default_factory=dict)
    registers: list[Register] = field(default_factory=list)
    memories: list[Memory] = field(default_factory=list)
    # Outputs that are words count only where another one says valid.
    words: tuple[str, ...] = rtl.CORE.words
    valid: str = rtl.CORE.valid
    held: tuple[str, ...] = ()  # inputs that change in a reset only

    def roots(self) -> Iterator[Node]:
        """Every expression that leads somewhere."""
        yield from self.outputs.values()
        for register in self.registers:
            yield register.next
        for memory in self.memories:
            yield from (memory.read_address, memory.write_address, memory.write_data)

    def substitute(self, replacement: Mapping[int, Node]) -> None:
        """Replaces leaves (id of the leaf -> node) in every expression."""
        done: dict[int, Node] = {}

        def again(node: Node) -> Node:
            return rebuild(node, replacement, done)

        self.outputs = {name: again(node) for name, node in self.outputs.items()}
        for register in self.registers:
            register.next = again(register.next)
        for memory in self.memories:
            memory.read_address, memory.write_address = again(memory.read_address), again(memory.write_address)
            memory.write_data = again(memory.write_data)
