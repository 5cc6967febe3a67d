# SPDX-License-Identifier: Apache-2.0
"""Proofs about designs without their line memories hold for the designs with them."""

import random

import pytest

from conftest import need
from cover import with_slow
from flow.base import aiger, ghdl
from flow.mutation import differences, equivalence
from flow.mutation.differences import Graph
from flow.mutation.memories import OPENED, memories, opened
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars
from test_differences import differing, reached, with_fault

# A memory of two words of a bit: nodes 1 to 3 are inputs, 4 to 7 registers, 8 and 9 gates that its ports need.
INPUTS = ["reset", "pixel", "memory.any_word"]
OUTPUTS = ["shown", "memory.asked_to_read", "memory.asked_at", "memory.given_at", "memory.given"]
ENABLE, ADDRESS, GIVEN_AT, WORD, READ, ASKED_AT = 4, 5, 6, 7, 8, 9


def random_design(generator, gates=8):
    """Registers: whether a memory is read, where, where it is written, and the word read last."""
    graph = Graph(list(INPUTS), [0] * 4, output_names=list(OUTPUTS))
    graph.gates = [(2 * ENABLE, 2 * 3), (2 * ADDRESS, 2 * ENABLE)]

    def edge(before):
        return generator.choice([number for number in range(2, 2 * before) if number >> 1 != 3])

    for node in range(10, 10 + gates):
        graph.gates.append(tuple(sorted((edge(node), edge(node)), reverse=True)))
    nodes = 10 + gates
    graph.registers = [edge(nodes) for _ in range(3)] + [2 * READ]
    graph.outputs = [2 * (nodes - 1), 2 * ENABLE, 2 * ASKED_AT, 2 * GIVEN_AT, edge(nodes)]
    return graph


def closed(graph):
    """The same with its memory, as two registers more, which shows only what is seen from outside."""
    made = differences.Builder(["reset", "pixel"], 6)
    words = [made.register(4), made.register(5)]
    at = made.register(1)
    read = made.any(made.both(at ^ 1, words[0]), made.both(at, words[1]))
    edges = made.values(graph, [0, 2, 4, read, *(made.register(number) for number in range(4))])
    made.graph.registers[:4] = [differences.at(edges, edge) for edge in graph.registers]
    shown, *_, given = (differences.at(edges, edge) for edge in graph.outputs)
    here = made.register(2)
    for number, chosen in enumerate((here ^ 1, here)):
        kept = made.both(words[number], chosen ^ 1)
        made.graph.registers[4 + number] = made.any(kept, made.both(chosen, given))
    made.graph.outputs = [shown]
    return made.graph


def test_what_is_proved_without_memories_never_shows():
    """Of random pairs: by equal outputs and by what may differ; some of each are proved that do differ inside."""
    generator = random.Random(2)
    counts = {"same": 0, "by equal outputs": 0, "by differences": 0, "by differences alone": 0}
    for _ in range(500):
        original = random_design(generator)
        changed = with_fault(generator, original)
        changed.gates[:2] = original.gates[:2]  # the memory's own
        changed.registers[3] = original.registers[3]
        changed.output_names = original.output_names
        same = not differing(reached([closed(original), closed(changed)]))
        is_equal = not differing(reached([original, changed]))
        may_differ = ((1,),) in reached([differences.differences(original, changed)])
        assert same or (not is_equal and may_differ)
        counts["same"] += same
        counts["by equal outputs"] += is_equal
        counts["by differences"] += not may_differ
        counts["by differences alone"] += not may_differ and not is_equal
    assert min(counts.values()) >= 5 and counts["same"] < 450, counts


def test_ports_of_memories_by_their_names():
    (one, other) = memories(
        ["reset", "a.any_word[1]", "a.any_word[0]", "b.any_word"],
        ["b.given", "b.asked_to_read", "a.given[0]", "a.given[1]", "x.taken", "a.given_at[0]", "b.given_at[0]"],
    )
    assert (one.read, one.given, one.given_at) == ([2, 1], [2, 3], [5])
    assert (other.read, other.given, other.asked_to_read, other.given_at) == ([3], [0], [1], [6])
    assert (one.bits, other.bits) == (4, 2)


PORT = "rows_search_rows_read_words_0_memory"
CHANGES = {
    "a reset value that counts only with its valid bit": (
        "        slice0_best_tag_start_of_frame <= false;",
        "        slice0_best_tag_start_of_frame <= true;",
        True,
    ),
    "a number that is never reached": ("mod 2)) < 12;", "mod 2)) <= 12;", True),
    "another place to write": (f"{PORT}_write_address <= to_unsigned(rows_write_column", None, False),
    "another place to read": (f"{PORT}_read_address <= to_unsigned(delay_column", None, False),
    "another word": (f"{PORT}_write_data <= to_unsigned(rows_search_rows_write_words_0", None, False),
    "one column less": (">= 7) and (raster", ">= 8) and (raster", False),
}


@pytest.fixture(scope="module")
def core(tmp_path_factory):
    for tool, variable in (("ghdl", "GHDL"), ("yosys", "YOSYS"), ("yosys-abc", "YOSYS_ABC")):
        need(tool, variable)
    *others, file = scalars.files(manifest.core_files("tiny"))

    def graph(text, folder):
        folder.mkdir(exist_ok=True)
        (folder / file.name).write_text(text)
        verilog = equivalence.observed(ghdl.to_verilog([*others, folder / file.name], folder, file.stem), file.stem)
        return aiger.write(opened(verilog), "observed", folder, starts_at_zero=True, opened=OPENED)

    return file.read_text(), graph, graph(file.read_text(), tmp_path_factory.mktemp("original"))


@pytest.mark.parametrize("change", with_slow(CHANGES, ["a number that is never reached", "another word"]))
def test_core_without_its_memories(core, tmp_path, change):
    text, graph, original = core
    old, new, is_the_same = CHANGES[change]
    if new is None:
        new = old.replace("to_unsigned(", "to_unsigned(1 - ")
    assert old in text
    changed = graph(text.replace(old, new, 1), tmp_path / "changed")
    assert equivalence.are_the_same(original, changed, tmp_path) == is_the_same


@pytest.mark.slow
def test_words_of_memories_are_not_in_the_graph(core, tmp_path):
    _, _, original = core
    graph = differences.read(original)
    files = scalars.files(manifest.core_files("tiny"))
    verilog = equivalence.observed(ghdl.to_verilog(files, tmp_path, files[-1].stem), files[-1].stem)
    whole = differences.read(aiger.write(verilog, "observed", tmp_path, starts_at_zero=True))
    found = memories(graph.inputs, graph.output_names)
    assert len(found) > 2 and not memories(whole.inputs, whole.output_names)
    assert len(whole.registers) - len(graph.registers) == sum(memory.bits for memory in found) > 1000
