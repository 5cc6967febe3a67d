# SPDX-License-Identifier: Apache-2.0
"""Where two versions of a design may differ, compared with all that small designs can do."""

import itertools
import random

import pytest

from conftest import need
from flow.base import aiger
from flow.mutation import differences
from flow.mutation.differences import Graph
from flow.mutation.equivalence import Differences

NAMES = ["reset", "word[0]", "word[1]"]


def step(graph, state, inputs):
    """(next state, outputs)"""
    values = [0, *inputs, *state]

    def at(edge):
        return values[edge >> 1] ^ (edge & 1)

    for first, second in graph.gates:
        values.append(at(first) & at(second))
    return tuple(at(edge) for edge in graph.registers), tuple(at(edge) for edge in graph.outputs)


def reached(graphs):
    """All outputs that graphs can show side by side: a set of tuples."""
    start = tuple((0,) * len(graph.registers) for graph in graphs)
    waiting, known, shown = [start], {start}, set()
    while waiting:
        states = waiting.pop()
        for inputs in itertools.product((0, 1), repeat=len(graphs[0].inputs)):
            steps = [step(graph, state, inputs) for graph, state in zip(graphs, states)]
            shown.add(tuple(outputs for _, outputs in steps))
            after = tuple(state for state, _ in steps)
            if after not in known:
                known.add(after)
                waiting.append(after)
    return shown


def differing(shown):
    return any(one != other for one, other in shown)


def random_graph(generator, registers=3, gates=9):
    graph = Graph(list(NAMES), [0] * registers)

    def edge(before):
        return generator.randrange(2, 2 * before)

    for node in range(graph.first_gate, graph.first_gate + gates):
        graph.gates.append(tuple(sorted((edge(node), edge(node)), reverse=True)))
    nodes = graph.first_gate + gates
    graph.registers = [edge(nodes) for _ in range(registers)]
    graph.outputs = [2 * (nodes - 1), edge(nodes)]
    return graph


def with_fault(generator, graph):
    changed = Graph(graph.inputs, list(graph.registers), list(graph.outputs), list(graph.gates))
    place = generator.randrange(len(graph.gates) + len(graph.registers))
    if place < len(graph.gates):
        first, second = graph.gates[place]
        changed.gates[place] = (first ^ 1, second)
    else:
        changed.registers[place - len(graph.gates)] ^= 1
    return changed


def test_what_is_proved_never_shows():
    """Of random pairs of small designs: no output differs where the graph of differences says that none may, and it
    says so of some of those with another behaviour inside."""
    generator, counts = random.Random(5), {"proved": 0, "equal": 0, "different": 0}
    for _ in range(400):
        original = random_graph(generator)
        changed = with_fault(generator, original)
        differs = differing(reached([original, changed]))
        may_differ = ((1,),) in reached([differences.differences(original, changed)])
        assert may_differ or not differs
        counts["different" if differs else "equal"] += 1
        counts["proved"] += not may_differ
    assert counts["different"] > 50 and counts["proved"] > counts["equal"] / 2, counts


def exchanged(graph):
    """The same with its first two registers exchanged."""
    place = {node: node for node in range(graph.first_gate + len(graph.gates))} | {4: 5, 5: 4}

    def moved(edge):
        return 2 * place[edge >> 1] + (edge & 1)

    gates = [tuple(sorted(map(moved, gate), reverse=True)) for gate in graph.gates]
    registers = [moved(graph.registers[number]) for number in (1, 0, 2)]
    return Graph(graph.inputs, registers, [moved(edge) for edge in graph.outputs], gates)


def test_registers_are_the_same_by_their_names():
    """In another order, and with another number of GHDL's in the names: nothing may differ. Without names some may."""
    generator, unnamed = random.Random(9), 0
    for _ in range(50):
        graph = random_graph(generator)
        other = exchanged(graph)
        assert not differing(reached([graph, other]))
        unnamed += ((1,),) in reached([differences.differences(graph, other)])
        graph.names, other.names = ["core.n8_q[0]", "core.n11_q[0]", "tag"], ["core.n12_q[0]", "core.n9_q[0]", "tag"]
        assert reached([differences.differences(graph, other)]) == {((0,),)}
    assert unnamed > 5


def test_other_registers_have_no_such_graph():
    generator = random.Random(1)
    one, other = random_graph(generator, 3), random_graph(generator, 3)
    assert differences.differences(one, random_graph(generator, 4)) is None
    one.names, other.names = ["a", "b", "n4_o"], ["b", "c", "n5_o"]
    assert differences.differences(one, other) is None
    other.names[1] = "n9_o a"
    assert differences.differences(one, other) is not None


def test_what_follows_from_control_and_what_from_pixels():
    graph = Graph(list(NAMES), [2, 2 * 4, 2 * 3, 2 * 7], [2], [(2 * 6, 2 * 5), (2 * 4, 2 * 1 + 1)])
    # registers: 4 <- reset, 5 <- 4, 6 <- word[1], 7 <- itself; gates: 8 of 6 and 5, 9 of 4 and reset
    assert differences.follow_from_control(graph) == [True, True, False, False, True, True, False, True, False, True]
    graph.inputs = [name.replace("word", "s_axil_wdata") for name in graph.inputs]
    assert all(differences.follow_from_control(graph)), "what is written into registers decides"


def test_files_are_read_as_they_were_written(tmp_path):
    graph = random_graph(random.Random(3), 5, 300)
    graph.names, graph.output_names = ["", "place[0]", "", "place[1]", ""], ["", "memory.given[1]"]
    differences.write(graph, tmp_path / "graph.aig")
    assert differences.read(tmp_path / "graph.aig") == graph


def test_the_prover_takes_the_file_for_the_same(tmp_path):
    """yosys-abc names the same first clock in which an output may be 1."""
    need("yosys-abc", "YOSYS_ABC")
    # A counter of two bits that says when it is 3: in clock 3.
    graph = Graph(list(NAMES), [2 * 4 + 1, 2 * 8 + 1], [2 * 9], [])
    graph.gates = [(2 * 5, 2 * 4), (2 * 5 + 1, 2 * 4 + 1), (2 * 7 + 1, 2 * 6 + 1)]
    graph.registers = [2 * 4 + 1, 2 * 8]
    graph.outputs = [2 * 6]
    clock, state = 0, (0, 0)
    while True:
        state, (output, *_) = step(graph, state, (0, 0, 0))
        if output:
            break
        clock += 1
    differences.write(graph, tmp_path / "graph.aig")
    assert aiger.prove("read graph.aig", tmp_path) == (False, str(clock))
    assert clock == 3


def test_random_inputs_find_what_shows_and_prove_nothing(held, tmp_path):
    need("yosys-abc", "YOSYS_ABC")
    assert aiger.simulate("read x.aig", _written(held, tmp_path), 1) == (False, "")
    shown = Graph(held.inputs, [2, *held.registers[1:]], held.outputs, held.gates)
    answer = aiger.simulate("read x.aig", _written(shown, tmp_path), 1)
    assert not answer.proved and int(answer.clock) >= 2


@pytest.mark.parametrize("edge, answer", [(0, (True, "")), (1, (False, "0"))])
@pytest.mark.parametrize("commands", ["strash", "scleanup; lcorr; scorr"])
def test_a_constant_is_an_answer(tmp_path, edge, answer, commands):
    """Merging of registers may leave nothing else, of which not every yosys-abc says that it is proved."""
    need("yosys-abc", "YOSYS_ABC")
    differences.write(Graph(list(NAMES), [2 * 5, 2 * 4], [edge]), tmp_path / "graph.aig")
    assert aiger.prove(f"read graph.aig; {commands}", tmp_path, 10) == answer
    assert aiger.simulate(f"read graph.aig; {commands}", tmp_path, 1).clock in ("", answer[1])


@pytest.fixture(name="held")
def a_register_that_is_never_set():
    """Registers: 4 a bit that only reset sets, after it was set; 5 follows it; 6 toggles. Output: 5 and word[0]."""
    return Graph(list(NAMES), [2 * 7, 2 * 4, 2 * 6 + 1], [2 * 8], [(2 * 4, 2), (2 * 5, 4)])


def test_registers_that_stay(held):
    assert differences.quiet(held) == [0, 1]
    asked = differences.asked_for(held, [0, 1])
    assert reached([asked]) == {((0,),)}
    assert ((1,),) in reached([differences.asked_for(held, [2])])
    assert reached([differences.without(held, [0, 1])]) == {((0,),)}


def test_predictions_change_nothing():
    """The graph with them shows the same, and each holds what its gate says."""
    generator, held = random.Random(7), 0
    for _ in range(50):
        graph = random_graph(generator)
        more = differences.with_predictions(graph)
        assert not differing(reached([graph, more]))
        held += len(more.registers) - len(graph.registers)
    assert held > 50


def test_proofs_with_lemmas(held, tmp_path):
    need("yosys-abc", "YOSYS_ABC")
    assert aiger.prove("read x.aig", _written(held, tmp_path)).proved
    differs = Differences(held, tmp_path)
    assert differs.never() and differs.never_with_lemmas()
    shown = Graph(held.inputs, [2, *held.registers[1:]], held.outputs, held.gates)
    differs = Differences(shown, tmp_path)
    assert not differs.never() and not differs.never_with_lemmas()
    differs.may_be = True
    assert not differs.never_with_lemmas()


def _written(graph, folder):
    differences.write(graph, folder / "x.aig")
    return folder


@pytest.mark.parametrize("seed", range(200))
def test_one_clock_says_in_which_states_the_versions_differ(seed):
    generator = random.Random(seed)
    original = random_graph(generator)
    original.names = ["one", "two", "three"]
    changed = Graph(
        original.inputs, list(original.registers), list(original.outputs), list(original.gates), original.names
    )
    if seed % 4:  # else the same
        place = generator.randrange(len(changed.gates))
        first, second = changed.gates[place]
        changed.gates[place] = (first ^ 1, second) if seed % 2 else (first, second ^ 1)
    both = differences.one_clock(original, changed)
    assert not both.registers
    for values in itertools.product((0, 1), repeat=len(both.inputs)):
        inputs, state = values[: len(NAMES)], values[len(NAMES) :]
        differ = step(original, state, inputs) != step(changed, state, inputs)
        assert step(both, (), values)[1] == (differ,)
    changed.names = ["one", "two", "four"]
    assert differences.one_clock(original, changed) is None
