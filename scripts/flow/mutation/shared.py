# SPDX-License-Identifier: Apache-2.0
"""Two versions of a design as one with few registers more (speculative reduction, as model checkers know it).

Random inputs show in which registers the versions ever differ. All others are made once and serve both versions; only
those that differ are there twice. The graph's output is 1 when an output differs, or when the two versions would give a
register that serves both different values. Both start at 0, so where that never happens the registers are the same in
each clock, by induction, and the versions show the same for ever. A register that random inputs called the same by
mistake makes the output 1: that costs a proof and never gives a false one.

What differs is often a counter and some tags, so a proof has some dozens of registers instead of thousands."""

from __future__ import annotations

from .differences import Builder, Graph, at, random_runs, registers_of

CLOCKS, RUNS = 500, 512


def in_which_they_differ(original: Graph, changed: Graph, of_original: list[int]) -> set[int]:
    """Numbers of the original's registers. `of_original`: for each of the changed version's the same one there."""
    count = len(original.registers)
    made = Builder(original.inputs, 2 * count)
    inputs = [2 * node for node in range(1 + len(original.inputs))]
    before = made.values(original, [*inputs, *(made.register(number) for number in range(count))])
    after = made.values(changed, [*inputs, *(made.register(count + number) for number in of_original)])
    made.graph.registers[:count] = [at(before, edge) for edge in original.registers]
    for number, edge in zip(of_original, changed.registers):
        made.graph.registers[count + number] = at(after, edge)
    differ: set[int] = set()
    for registers in random_runs(made.graph, CLOCKS, RUNS):
        if registers[:count] != registers[count:]:
            differ.update(number for number in range(count) if registers[number] != registers[count + number])
    return differ


def shared(original: Graph, changed: Graph) -> Graph | None:
    """None where not all registers have one of the same name in the other version."""
    of_original = registers_of(original, changed)
    if of_original is None:
        return None
    count = len(original.registers)
    twice = sorted(in_which_they_differ(original, changed, of_original))
    made = Builder(original.inputs, count + len(twice))
    of_changed = {number: made.register(count + place) for place, number in enumerate(twice)}
    inputs = [2 * node for node in range(1 + len(original.inputs))]
    before = made.values(original, [*inputs, *(made.register(number) for number in range(count))])
    after = made.values(changed, [*inputs, *(of_changed.get(number, made.register(number)) for number in of_original)])
    made.graph.registers[:count] = [at(before, edge) for edge in original.registers]
    pairs = [(at(before, edge), at(after, other)) for edge, other in zip(original.outputs, changed.outputs)]
    place_of = {number: count + place for place, number in enumerate(twice)}
    for number, edge in zip(of_original, changed.registers):
        if number in place_of:
            made.graph.registers[place_of[number]] = at(after, edge)
        else:
            pairs.append((made.graph.registers[number], at(after, edge)))
    made.graph.outputs = [made.any(*(made.differ(one, other) for one, other in pairs))]
    return made.graph
