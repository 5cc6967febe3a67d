# SPDX-License-Identifier: Apache-2.0
"""Where two versions of a design may differ, as a design of its own.

Each register gets a bit that says whether its value may differ between the versions. The graph that is made runs the
original and these bits, which follow from it:

- An and gate may differ if an input of it may, unless the other one is 0 in both. Its value counts only where it
  follows from inputs of one bit and from what is written into registers: pixels and costs stay out of the proof.
- A register may differ in the next clock if what it takes in the changed version may, or if the two versions take
  different values from the same state.
- A word of a line memory may differ if one was written there that might. Where and whether a memory is read and where
  it is written must be the same (memories.py).

The graph's output is 1 when an output may differ. Where that never happens the versions show the same for ever; where
it happens they need not differ. A fault in a reset value or in a mask is proved so: the data that it touches differs
for some clocks, and nobody sees them."""

from __future__ import annotations

import random
import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from .memories import Memory, memories

INPUT_BIT = re.compile(r"^(.+)\[\d+\]$")
OF_REGISTERS = "s_axil_"  # how the names of their inputs begin. What is written there decides: a soft reset, a size
NUMBERED = re.compile(r"\bn(\d+)_")  # GHDL's names of what has none: the number may be another one in another version


@dataclass
class Graph:
    """An and-inverter graph with registers that start at 0. A node is a number: 0 the constant, then inputs, registers
    and gates. An edge is twice the number of its node, and 1 more where it is inverted."""

    inputs: list[str]  # names; "" without one
    registers: list[int] = field(default_factory=list)  # edge that each takes
    outputs: list[int] = field(default_factory=list)
    gates: list[tuple[int, int]] = field(default_factory=list)
    names: list[str] = field(default_factory=list)  # of the registers, or none
    output_names: list[str] = field(default_factory=list)  # or none

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
    graph.names, graph.output_names = [""] * registers, [""] * outputs
    names_of = {b"i": graph.inputs, b"l": graph.names, b"o": graph.output_names}
    for match in re.finditer(rb"^([ilo])(\d+) (.+)", content[place:], re.MULTILINE):
        names_of[match[1]][int(match[2])] = match[3].decode()
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
        number(2 * node - first) + number(first - second)
        for node, (first, second) in enumerate(graph.gates, graph.first_gate)
    )
    symbols = [f"i{number} {name}\n" for number, name in enumerate(graph.inputs) if name]
    symbols += [f"l{number} {name}\n" for number, name in enumerate(graph.names) if name]
    symbols += [f"o{number} {name}\n" for number, name in enumerate(graph.output_names) if name]
    path.write_bytes(f"aig {head}\n{text}".encode() + body + "".join(symbols).encode())


class Builder:
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

    def register(self, number: int) -> int:
        return 2 * (1 + len(self.graph.inputs) + number)

    def differ(self, first: int, second: int) -> int:
        return self.any(self.both(first, second ^ 1), self.both(first ^ 1, second))

    def values(self, graph: Graph, edges: list[int]) -> list[int]:
        """For each node of a graph the edge that stands for it, from those of its inputs and registers."""
        edges = list(edges)
        for first, second in graph.gates:
            edges.append(self.both(at(edges, first), at(edges, second)))
        return edges

    def copied(self, graph: Graph, zeros: Collection[int] = ()) -> list[int]:
        """The same of a graph with the same inputs and first registers, where some registers count as 0."""
        registers = (0 if number in zeros else self.register(number) for number in range(len(graph.registers)))
        return self.values(graph, [*(2 * node for node in range(1 + len(graph.inputs))), *registers])


def at(edges: list[int], edge: int) -> int:
    """The edge that stands for another one."""
    return edges[edge >> 1] ^ (edge & 1)


def follow_from_control(graph: Graph) -> list[bool]:
    """For each node whether it follows, through registers too, from inputs of one bit and those of registers alone."""
    words = [INPUT_BIT.sub(r"\1", name) for name in graph.inputs]
    of_words = [words.count(word) > 1 and not word.startswith(OF_REGISTERS) for word in words]
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


def _known_name(names: str) -> tuple[str, list[int]]:
    """(one of a register's names, without GHDL's numbers; these numbers): one without a number if there is one."""
    numbers = {name: [int(number) for number in NUMBERED.findall(name)] for name in names.split(" ")}
    chosen = min(numbers, key=lambda name: (bool(numbers[name]), name))
    return NUMBERED.sub("n_", chosen), numbers[chosen]


def registers_of(original: Graph, changed: Graph) -> list[int] | None:
    """For each register of the changed version the original's that it is; None where not all have one of the same name
    in the other version."""
    names, of_changed = (
        sorted((*_known_name(name), number) for number, name in enumerate(graph.names or [""] * len(graph.registers)))
        for graph in (original, changed)
    )
    if original.inputs != changed.inputs or [name for name, _, _ in names] != [name for name, _, _ in of_changed]:
        return None
    # Were it another one, a proof would still hold.
    return [same for _, same in sorted((other[2], one[2]) for one, other in zip(names, of_changed))]


def one_clock(original: Graph, changed: Graph) -> Graph | None:
    """A graph without registers whose output is 1 where the versions differ in one clock from the same state: in what
    the registers take or in an output. None where the registers have no partners."""
    of_original = registers_of(original, changed)
    if of_original is None:
        return None
    count = len(original.registers)
    made = Builder([*original.inputs, *[""] * count], 0)
    state = [2 * node for node in range(1 + len(original.inputs) + count)]
    at_first = 1 + len(original.inputs)
    before = made.values(original, state)
    after = made.values(changed, [*state[:at_first], *(state[at_first + number] for number in of_original)])
    pairs = [(at(before, original.registers[number]), edge) for number, edge in zip(of_original, changed.registers)]
    pairs += [(at(before, edge), other) for edge, other in zip(original.outputs, changed.outputs)]
    made.graph.outputs = [made.any(*(made.differ(edge, at(after, other)) for edge, other in pairs))]
    return made.graph


def differences(original: Graph, changed: Graph) -> Graph | None:
    """None where not all registers have one of the same name in the other version."""
    of_original = registers_of(original, changed)
    if of_original is None:
        return None
    count = len(original.registers)
    opened = memories(original.inputs, original.output_names)
    made = Builder(original.inputs, 2 * count + sum(1 << len(memory.given_at) for memory in opened))
    inputs = [2 * node for node in range(1 + len(original.inputs))]
    before, after = made.copied(original), made.values(changed, [*inputs, *(made.register(n) for n in of_original)])
    known = follow_from_control(changed)
    may = [0] * len(inputs) + [made.register(count + number) for number in of_original]
    words = _Words(made, 2 * count, opened, [at(before, edge) for edge in original.outputs])
    for memory, read in zip(opened, words.read):
        for number in memory.read:
            may[1 + number] = read
    for first, second in changed.gates:
        one, other = may[first >> 1], may[second >> 1]
        value, other_value = (at(after, edge) if known[edge >> 1] else 1 for edge in (first, second))
        may.append(made.any(made.both(one, other_value), made.both(other, value), made.both(one, other)))

    def may_differ(edge: int, changed_edge: int) -> int:
        return made.any(may[changed_edge >> 1], made.differ(at(before, edge), at(after, changed_edge)))

    made.graph.registers[:count] = [at(before, edge) for edge in original.registers]
    for number, edge in zip(of_original, changed.registers):
        made.graph.registers[count + number] = may_differ(original.registers[number], edge)
    outputs = [may_differ(*edges) for edges in zip(original.outputs, changed.outputs)]
    words.write(outputs)
    data = {number for memory in opened for number in memory.given}
    made.graph.outputs = [made.any(*(edge for number, edge in enumerate(outputs) if number not in data))]
    return made.graph


class _Words:
    """For each word of each memory a register: whether it may differ."""

    def __init__(self, made: Builder, first: int, opened: list[Memory], asked: list[int]) -> None:
        """`first`: number of the first of these registers. `asked`: the outputs of the original."""
        self.made, self.opened, self.asked = made, opened, asked
        self.first: list[int] = []  # of each memory
        for memory in opened:
            self.first.append(first)
            first += 1 << len(memory.given_at)
        self.read = [self._read(*both) for both in zip(opened, self.first)]  # whether the word read may differ

    def _chosen(self, address: list[int]) -> list[int]:
        """For each word an edge: whether the address is its own."""
        found = [1]
        for number in reversed(address):  # of the outputs
            bit = self.asked[number]
            found = [self.made.both(edge, value) for edge in found for value in (bit ^ 1, bit)]
        return found

    def _read(self, memory: Memory, first: int) -> int:
        made, chosen = self.made, self._chosen(memory.asked_at)
        return made.any(*(made.both(edge, made.register(first + word)) for word, edge in enumerate(chosen)))

    def write(self, outputs: list[int]) -> None:
        """`outputs`: whether each may differ."""
        made = self.made
        for memory, first in zip(self.opened, self.first):
            given = made.any(*(outputs[number] for number in memory.given))
            for word, edge in enumerate(self._chosen(memory.given_at)):
                kept = made.both(made.register(first + word), edge ^ 1)
                made.graph.registers[first + word] = made.any(kept, made.both(edge, given))


CLOCKS, RUNS = 1500, 512
MOST_REGISTERS = 5  # that a predicted gate follows from


def random_runs(graph: Graph, clocks: int, runs: int) -> Iterator[list[int]]:
    """For each clock a word for each register, with a bit for each run: what it holds after that clock. In each run an
    input is 1 at its own rate: 1, 16, 112 or 127 in 128."""
    generator, every = random.Random(1), (1 << runs) - 1
    masks = [[generator.getrandbits(runs) for _ in range(2)] for _ in graph.inputs]
    registers = [0] * len(graph.registers)
    for _ in range(clocks):
        values = [0]
        for is_often, is_extreme in masks:
            some = generator.getrandbits(runs)
            for number in range(1, 7):
                some &= generator.getrandbits(runs) | (0 if number < 3 else every ^ is_extreme)
            values.append(some ^ is_often)
        values += registers
        for first, second in graph.gates:
            values.append((values[first >> 1] ^ every * (first & 1)) & (values[second >> 1] ^ every * (second & 1)))
        registers = [values[edge >> 1] ^ every * (edge & 1) for edge in graph.registers]
        yield registers


def quiet(graph: Graph) -> list[int]:
    """The registers that stay 0 in random runs."""
    left = set(range(len(graph.registers)))
    for registers in random_runs(graph, CLOCKS, RUNS):
        left = {number for number in left if not registers[number]}
    return sorted(left)


def asked_for(graph: Graph, numbers: list[int]) -> Graph:
    """The same with another output: that one of these registers is 1."""
    made = Builder(graph.inputs, len(graph.registers))
    edges = made.copied(graph)
    made.graph.registers = [at(edges, edge) for edge in graph.registers]
    made.graph.outputs = [made.any(*(made.register(number) for number in numbers))]
    return made.graph


def without(graph: Graph, numbers: list[int]) -> Graph:
    """The same where these registers are known to stay 0."""
    made = Builder(graph.inputs, len(graph.registers))
    edges = made.copied(graph, set(numbers))
    made.graph.registers = [0 if number in numbers else at(edges, edge) for number, edge in enumerate(graph.registers)]
    made.graph.outputs = [at(edges, edge) for edge in graph.outputs]
    return made.graph


def with_inputs(graph: Graph, known: Mapping[str, int]) -> Graph:
    """The same where these inputs have these values."""
    made = Builder(graph.inputs, len(graph.registers))
    inputs = [known.get(name, 2 * node) for node, name in enumerate(graph.inputs, 1)]
    edges = made.values(graph, [0, *inputs, *map(made.register, range(len(graph.registers)))])
    made.graph.registers = [at(edges, edge) for edge in graph.registers]
    made.graph.outputs = [at(edges, edge) for edge in graph.outputs]
    made.graph.names, made.graph.output_names = graph.names, graph.output_names
    return made.graph


def with_predictions(graph: Graph) -> Graph:
    """The same with a register for each gate that follows from few registers, which holds what the gate says. Proofs
    look for invariants made of registers. These are shorter with one that says that a counter has reached a number."""
    behind_inputs = 1 + len(graph.inputs)
    support: list[frozenset[int]] = [frozenset([node] if node else []) for node in range(graph.first_gate)]
    for first, second in graph.gates:
        support.append(support[first >> 1] | support[second >> 1])
    chosen = [
        node
        for node in range(graph.first_gate, len(support))
        if 2 <= len(support[node]) <= MOST_REGISTERS and min(support[node]) >= behind_inputs
    ]
    made = Builder(graph.inputs, len(graph.registers) + len(chosen))
    now = made.copied(graph)
    made.graph.registers = [at(now, edge) for edge in graph.registers]
    made.graph.outputs = [at(now, edge) for edge in graph.outputs]
    next_clock = made.values(graph, [*now[:behind_inputs], *made.graph.registers])
    at_start = Builder([], 0).values(graph, [0] * graph.first_gate)
    # One that is 1 at the start is held inverted, as registers start at 0.
    made.graph.registers += [next_clock[node] ^ at_start[node] for node in chosen]
    return made.graph
