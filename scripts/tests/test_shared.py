# SPDX-License-Identifier: Apache-2.0
"""Two versions of a design with registers that serve both, compared with all that small designs can do."""

import random

import pytest

from conftest import need
from flow.base import aiger
from flow.mutation import differences, equivalence, shared
from test_differences import differing, random_graph, reached, with_fault


def test_what_is_proved_never_shows(monkeypatch):
    """No output differs where the graph says so; it says so of most pairs that are equal, of some with registers that
    differ. So too where random inputs are too short to tell registers apart."""
    generator, counts = random.Random(5), {"proved": 0, "equal": 0, "different": 0, "apart": 0}
    monkeypatch.setattr(shared, "RUNS", 16)
    for number in range(400):
        monkeypatch.setattr(shared, "CLOCKS", (40, 1)[number % 4 == 0])
        original = random_graph(generator)
        changed = with_fault(generator, original)
        both = shared.shared(original, changed)
        differs = differing(reached([original, changed]))
        is_proved = ((1,),) not in reached([both])
        assert not (is_proved and differs), number
        counts["different" if differs else "equal"] += 1
        counts["proved"] += is_proved
        counts["apart"] += is_proved and len(both.registers) > len(original.registers)
    assert counts["different"] > 50 and counts["proved"] > 0.8 * counts["equal"] and counts["apart"] > 5, counts


def test_other_registers_have_no_such_graph():
    generator = random.Random(1)
    assert shared.shared(random_graph(generator, 3), random_graph(generator, 4)) is None


@pytest.mark.parametrize("most", [0, equivalence.MOST_LEFT_OVER])
def test_the_prover_says_the_same(tmp_path, monkeypatch, most):
    need("yosys-abc", "YOSYS_ABC")
    monkeypatch.setattr(equivalence, "MOST_LEFT_OVER", most)
    generator, proved = random.Random(8), 0
    for _ in range(20):
        original = random_graph(generator)
        changed = with_fault(generator, original)
        found = equivalence._with_shared_registers(original, changed, tmp_path)
        assert not (found and differing(reached([original, changed])))
        proved += found
    assert proved > 2


@pytest.mark.parametrize("bits, answer", [(9, (True, "")), (8, (False, "256"))])
def test_all_states_of_a_long_counter(tmp_path, bits, answer):
    """A counter of 256 steps that stops at its last one, and one that does not: whether the bit above is ever 1."""
    need("yosys-abc", "YOSYS_ABC")
    made = differences.Builder(["go"], 9)
    carry = 1 if bits == 8 else made.any(*(made.register(number) ^ 1 for number in range(8)))
    for number in range(9):
        place = made.register(number)
        made.graph.registers[number] = made.differ(place, carry)
        carry = made.both(carry, place)
    made.graph.outputs = [made.register(8)]
    differences.write(made.graph, tmp_path / "counter.aig")
    assert aiger.prove_by_all_states("read counter.aig; strash", tmp_path, 20) == answer


def test_all_states_of_random_designs(tmp_path):
    """The answer is the right one, and there is one; the clock is that of the other prover."""
    need("yosys-abc", "YOSYS_ABC")
    proved = []
    for number in range(20):
        graph = random_graph(random.Random(number))
        graph.outputs = graph.outputs[:1]
        differences.write(graph, tmp_path / "graph.aig")
        answer = aiger.prove_by_all_states("read graph.aig; strash; dc2", tmp_path, 20)
        proved.append(((1,),) not in reached([graph]))
        assert (answer.proved, bool(answer.clock)) == (proved[-1], not proved[-1]), number
        assert answer == aiger.prove("read graph.aig; strash", tmp_path, 20), number
    assert 2 < sum(proved) < 18
