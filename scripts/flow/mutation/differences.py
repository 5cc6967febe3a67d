# SPDX-License-Identifier: Apache-2.0
"""Where two versions of a design may differ, as a design of its own.

Each register gets a bit that says whether its value may differ between the versions. The graph that is made runs the
original and these bits, which follow from it:

- A gate may differ if an input of it may, unless its other input is 0 in both. The other input's value counts only where
  it follows from inputs of one bit. Pixels and costs stay out of the proof so.
- A register may differ in the next clock if what its changed version takes may, or if both versions take another value
  from the same state.

Its output is 1 when an output may differ. Where that never happens the versions show the same for ever; where it happens
they need not differ. A fault in a reset value or in a mask is proved so in a second: the data that it touches differs for
some clocks, and nobody sees them."""

import re
from dataclasses import dataclass, field
from pathlib import Path

INPUT_BIT = re.compile(r"(\w+)\[\d+\]")


@dataclass
class Graph:
    """An and-inverter graph with registers that start at 0. A node is a number: 0 the constant, then inputs, registers and
    gates. An edge is twice the number of its node, and 1 more where it is inverted."""

    inputs: list[str]  # names; "" without one
    registers: list[int] = field(default_factory=list)  # edge that each takes
    outputs: list[int] = field(default_factory=list)
    gates: list[tuple[int, int]] = field(default_factory=list)

    @property
    def first_gate(self) -> int:
        return 1 + len(self.inputs) + len(self.registers)


def read(path: Path) -> Graph:
    """A binary AIGER file."""
    content = path.read_bytes()
    lines = content.split(b"\n", 1)[0].split()
    inputs, registers, outputs, gates = (int(word) for word in lines[2:6])
    place = content.index(b"\n") + 1
    edges = []
    for _ in range(registers + outputs):
        end = content.index(b"\n", place)
        edges.append(int(content[place:end]))
        place = end + 1

    def number() -> int:
        nonlocal place
        value = shift = 0
        while True:
            byte = content[place]
            place += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                return value

    graph = Graph([""] * inputs, edges[:registers], edges[registers:])
    for node in range(graph.first_gate, graph.first_gate + gates):
        first = 2 * node - number()
        graph.gates.append((first, first - number()))
    for match in re.finditer(rb"^i(\d+) (\S+)", content[place:], re.MULTILINE):
        graph.inputs[int(match[1])] = match[2].decode()
    return graph


def write(graph: Graph, path: Path) -> None:
    def number(value: int) -> bytes:
        digits = bytearray()
        while value > 127:
            digits.append(value & 127 | 128)
            value >>= 7
        return bytes([*digits, value])

    counts = len(graph.inputs), len(graph.registers), len(graph.outputs), len(graph.gates)
    head = " ".join(str(count) for count in (graph.first_gate - 1 + len(graph.gates), *counts))
    text = "".join(f"{edge}\n" for edge in (*graph.registers, *graph.outputs))
    body = b"".join(
        number(2 * node - first) + number(first - second) for node, (first, second) in enumerate(graph.gates, graph.first_gate)
    )
    path.write_bytes(f"aig {head}\n{text}".encode() + body)


class _Builder:
    """Gates that are made one by one; the same one never twice."""

    def __init__(self, inputs: list[str], registers: int) -> None:
        self.graph = Graph(inputs, [0] * registers)
        self.known: dict[tuple[int, int], int] = {}

    def both(self, first: int, second: int) -> int:
        first, second = max(first, second), min(first, second)
        if second == 0 or first == second ^ 1:
            return 0
        if second == 1 or first == second:
            return first
        if (first, second) not in self.known:
            self.known[first, second] = 2 * (self.graph.first_gate + len(self.graph.gates))
            self.graph.gates.append((first, second))
        return self.known[first, second]

    def any(self, *edges: int) -> int:
        found = 0
        for edge in edges:
            found = self.both(found ^ 1, edge ^ 1) ^ 1
        return found

    def differ(self, first: int, second: int) -> int:
        return self.any(self.both(first, second ^ 1), self.both(first ^ 1, second))

    def copied(self, graph: Graph) -> list[int]:
        """For each node of a graph with the same inputs and first registers the edge that stands for it."""
        edges = [2 * node for node in range(graph.first_gate)]
        for first, second in graph.gates:
            edges.append(self.both(at(edges, first), at(edges, second)))
        return edges


def at(edges: list[int], edge: int) -> int:
    """The edge that stands for another one."""
    return edges[edge >> 1] ^ (edge & 1)


def follow_from_bits(graph: Graph) -> list[bool]:
    """For each node whether it follows, through registers too, from inputs of one bit alone."""
    words = [match[1] for name in graph.inputs if (match := INPUT_BIT.fullmatch(name))]
    of_words = [bool(match := INPUT_BIT.fullmatch(name)) and words.count(match[1]) > 1 for name in graph.inputs]
    data = [False, *of_words, *[False] * len(graph.registers)]
    while True:
        nodes = list(data)
        for first, second in graph.gates:
            nodes.append(nodes[first >> 1] or nodes[second >> 1])
        taken = [nodes[edge >> 1] for edge in graph.registers]
        before = len(graph.inputs) + 1
        if taken == data[before:]:
            return [not node for node in nodes]
        data[before:] = [now or then for now, then in zip(taken, data[before:])]


def differences(original: Graph, changed: Graph) -> Graph | None:
    """None where the versions do not have equally many registers, which are taken for the same ones in their order. Were
    they others, a proof would hold none the less: the order only decides whether there is one."""
    count = len(original.registers)
    if (original.inputs, count, len(original.outputs)) != (changed.inputs, len(changed.registers), len(changed.outputs)):
        return None
    made = _Builder(original.inputs, 2 * count)
    before, after = made.copied(original), made.copied(changed)
    known = follow_from_bits(changed)
    may = [0] * (1 + len(original.inputs)) + [2 * (original.first_gate + number) for number in range(count)]
    for first, second in changed.gates:
        one, other = may[first >> 1], may[second >> 1]
        value, other_value = (at(after, edge) if known[edge >> 1] else 1 for edge in (first, second))
        may.append(made.any(made.both(one, other_value), made.both(other, value), made.both(one, other)))

    def may_differ(edge: int, changed_edge: int) -> int:
        return made.any(may[changed_edge >> 1], made.differ(at(before, edge), at(after, changed_edge)))

    bits = [may_differ(*edges) for edges in zip(original.registers, changed.registers)]
    made.graph.registers = [*(at(before, edge) for edge in original.registers), *bits]
    made.graph.outputs = [made.any(*(may_differ(*edges) for edges in zip(original.outputs, changed.outputs)))]
    return made.graph
