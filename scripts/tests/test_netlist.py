# SPDX-License-Identifier: Apache-2.0
"""Every simplification of the netlist builders keeps the value: random expressions against plain Python arithmetic."""

import pytest

from flow.synthesis.lowering import expressions as n, netlist
from flow.synthesis.lowering.cleanup import merge_twins, remove_unused
from flow.synthesis.lowering.evaluate import compile_step
from flow.synthesis.lowering.memories import join_memory_slices, narrow_memories
from flow.synthesis.lowering.readers import narrow_to_read_bits

WIDTHS = {"a": 8, "b": 8, "c": 3, "s": 1, "t": 1}


def wrapped(value, width, signed):
    value &= (1 << width) - 1
    return value - (1 << width) if signed and value >> (width - 1) else value


def random_expression(rng, depth):
    """(node, function of the inputs that computes the same the plain way)"""
    if depth == 0 or rng.random() < 0.1:
        if rng.random() < 0.3:
            value = rng.choice((0, 1, 2, 3, 7, 15, 128, 255, rng.randrange(256)))
            return n.const(value), lambda i: value
        name = rng.choice(list(WIDTHS))
        return n.leaf("input", name, WIDTHS[name]), lambda i: i[name]
    x, fx = random_expression(rng, depth - 1)
    y, fy = random_expression(rng, depth - 1)
    kind = rng.choice(
        (
            "add",
            "sub",
            "wrap",
            "shl",
            "shr",
            "mux",
            "lt",
            "eq",
            "not",
            "abs",
            "and",
            "or",
            "xor",
            "bits",
            "held",
            "differs",
            "mul",
        )
    )
    if kind == "add":
        return n.add(x, y), lambda i: fx(i) + fy(i)
    if kind == "sub":
        return n.sub(x, y), lambda i: fx(i) - fy(i)
    if kind == "mul":
        return n.mul(x, y), lambda i: fx(i) * fy(i)
    if kind == "wrap":
        width, signed = rng.randrange(1, 12), rng.random() < 0.3
        return n.wrap(x, width, signed), lambda i: wrapped(fx(i), width, signed)
    if kind == "shl":
        count = rng.randrange(6)
        return n.shift_left(x, count), lambda i: fx(i) << count
    if kind == "shr":
        count = rng.randrange(9)
        return n.shift_right(x, count), lambda i: fx(i) >> count
    if kind == "mux":
        bit, fbit = random_bit(rng, depth - 1)
        return n.mux(bit, x, y), lambda i: fx(i) if fbit(i) else fy(i)
    if kind == "lt":
        return n.less(x, y), lambda i: int(fx(i) < fy(i))
    if kind == "eq":
        return n.equal(x, y), lambda i: int(fx(i) == fy(i))
    if kind == "abs":
        return n.absolute(x), lambda i: abs(fx(i))
    if kind in ("and", "or", "xor"):
        operation = {"and": int.__and__, "or": int.__or__, "xor": int.__xor__}[kind]
        return n.bitwise(kind, x, y), lambda i: operation(fx(i), fy(i))
    if kind == "held":
        bit, fbit = random_bit(rng, depth - 1)
        take, ftake = random_bit(rng, depth - 1)
        a, fa = random_bit(rng, depth - 1)
        return (
            n.mux(bit, n.bit_or(a, take), n.bit_and(a, n.bit_not(take))),
            lambda i: (fa(i) | ftake(i)) if fbit(i) else (fa(i) & (1 - ftake(i))),
        )
    if kind == "differs":
        (bit, fbit), (a, fa) = random_bit(rng, depth - 1), random_bit(rng, depth - 1)
        yes, no = (a, n.bit_not(a)) if rng.random() < 0.5 else (n.bit_not(a), a)
        return n.mux(bit, yes, no), lambda i: fa(i) ^ (not fbit(i)) if yes is a else fa(i) ^ fbit(i)
    return random_bit(rng, depth)


def random_bit(rng, depth):
    """Bits of words, their inverses and their conjunctions: what comparisons look like after the tool split them."""
    count = rng.randrange(1, 5)
    node, functions = n.const(1), []
    name = rng.choice("abc")
    word = n.leaf("input", name, WIDTHS[name])
    for _ in range(count):
        place, inverted = rng.randrange(WIDTHS[name]), rng.random() < 0.5
        bit = n.wrap(n.shift_right(word, place), 1)
        node = n.bit_and(node, n.bit_not(bit) if inverted else bit)
        functions.append(lambda i, place=place, inverted=inverted: (i[name] >> place & 1) ^ inverted)
    return node, lambda i: int(all(f(i) for f in functions))


def evaluate(node, inputs):
    step = compile_step(netlist.Netlist({k: n.leaf("input", k, w) for k, w in WIDTHS.items()}, {"out": node}))
    return step(inputs, [], [])["out"]


@pytest.mark.parametrize("part", range(4))
def test_simplified_expressions_keep_their_value(rng, part):
    for number in range(1500):
        node, plain = random_expression(rng, 1 + number % 5)
        step = compile_step(netlist.Netlist({k: n.leaf("input", k, w) for k, w in WIDTHS.items()}, {"out": node}))
        for _ in range(12):
            inputs = {name: rng.choice((0, (1 << w) - 1, rng.randrange(1 << w))) for name, w in WIDTHS.items()}
            got, expected = step(inputs, [], [])["out"], plain(inputs)
            assert got == expected, f"{node!r} of {inputs}: expected {expected}, got {got}"
            assert node.low <= got <= node.high, f"{node!r} of {inputs}: {got} is outside {node.low} ... {node.high}"
            assert node.ones is None or got & ~node.ones == 0, (
                f"{node!r} of {inputs}: {got} has a bit outside {node.ones:b}"
            )


def test_rebuilding_with_constants_equals_evaluating_with_them(rng):
    for _ in range(500):
        node, plain = random_expression(rng, 4)
        inputs = {name: rng.randrange(1 << w) for name, w in WIDTHS.items()}
        replacement = {id(n.leaf("input", k, w)): n.const(inputs[k]) for k, w in WIDTHS.items()}
        assert n.rebuild(node, replacement, {}).param == plain(inputs)


def test_known_simplifications():
    a, b = n.leaf("input", "a", 8), n.leaf("input", "b", 8)
    difference = n.sub(a, b)
    sign = n.shift_right(difference, 15)
    assert n.sub(n.bitwise("xor", difference, sign), sign) is n.absolute(difference)
    assert n.wrap(n.add(a, b), 9) is n.add(a, b)
    assert n.wrap(difference, 16, signed=True) is difference
    assert n.mux(n.bit_not(n.leaf("input", "s", 1)), a, b) is n.mux(n.leaf("input", "s", 1), b, a)
    bits = [n.wrap(n.shift_right(a, k), 1) for k in range(8)]
    assert n.mux(bits[0], n.bit_not(bits[1]), bits[1]) is n.bit_xor(bits[0], bits[1])
    assert n.bit_and(*[bit if 0x5A >> k & 1 else n.bit_not(bit) for k, bit in enumerate(bits)]) is n.equal(
        a, n.const(0x5A)
    )


def test_a_range_check_becomes_two_comparisons():
    """As the tool writes `5 <= x < 9`: x - 5 modulo a power of two, then less than 4."""
    x = n.leaf("input", "c", 3)
    for start in range(1, 8):
        for count in range(1, 17 - start):
            check = n.less(n.wrap(n.add(x, n.const(16 - start)), 4), n.const(count))
            assert not any(node.op == "wrap" for node in n.walk([check])) or count > 16 - start
            for value in range(8):
                inputs = dict.fromkeys(WIDTHS, 0) | {"c": value}
                assert evaluate(check, inputs) == ((value - start) % 16 < count), f"{value} from {start}, {count}"


def test_twins_are_merged_and_unused_registers_dropped():
    a = n.leaf("input", "a", 8)
    one, two = (netlist.Register(name, n.leaf("register", name, 8), 0, a) for name in ("one", "two"))
    after = netlist.Register("after", n.leaf("register", "after", 8), 0, two.value)
    alone = netlist.Register("alone", n.leaf("register", "alone", 8), 1, a)
    design = netlist.Netlist({"a": a}, {"out": n.add(one.value, after.value)}, [one, two, after, alone])
    merge_twins(design)
    remove_unused(design)
    assert [r.name for r in design.registers] == ["one", "after"]
    assert after.next is one.value


def test_wraps_inside_a_sum_that_is_wrapped_anyway_fall_away():
    a, b = n.leaf("input", "a", 8), n.leaf("input", "b", 8)
    assert n.wrap(n.add(n.wrap(n.sub(a, b), 32), b), 8) is n.wrap(n.add(n.sub(a, b), b), 8)
    assert n.sub(n.shift_left(a, 4), a).op == "mul", "15 a, which is never negative"


def test_the_pieces_of_a_word_behind_a_memory_become_one_register():
    """8 bits of memory, of which two registers take 3 and 5 bits; the word starts as they do."""
    address = netlist.Register("address", n.leaf("register", "address", 2))
    data = n.leaf("memory", "m", 8)
    low, high = (
        netlist.Register("low", n.leaf("register", "low", 3), 5),
        netlist.Register("high", n.leaf("register", "high", 5), 1),
    )
    address.next = n.wrap(n.add(address.value, n.const(1)), 2)
    low.next, high.next = n.wrap(data, 3), n.shift_right(data, 3)
    memory = netlist.Memory("m", 4, 8, data, address.value, address.value, n.leaf("input", "a", 8))
    design = netlist.Netlist(
        {"a": n.leaf("input", "a", 8)}, {"low": low.value, "high": high.value}, [address, low, high], [memory]
    )
    join_memory_slices(design)
    assert [r.name for r in design.registers] == ["address", "m_word"]
    word = design.registers[1]
    assert word.next is data and word.initial == 5 | 1 << 3
    assert design.outputs == {"low": n.wrap(word.value, 3), "high": n.shift_right(word.value, 3)}


def test_bits_of_a_memory_that_nobody_reads_are_dropped():
    address = netlist.Register("address", n.leaf("register", "address", 2))
    data, written = n.leaf("memory", "m", 8), n.leaf("input", "a", 8)
    word = netlist.Register("word", n.leaf("register", "word", 5), 0, n.wrap(data, 5))
    memory = netlist.Memory("m", 4, 8, data, address.value, address.value, written)
    design = netlist.Netlist({"a": written}, {"out": word.value}, [address, word], [memory])
    narrow_memories(design)
    assert (memory.width, memory.write_data) == (5, n.wrap(written, 5))
    assert word.next is memory.data is n.leaf("memory", "m", 5)


def test_bits_of_registers_that_nobody_reads_are_dropped():
    """Two copies of a flag that start with different upper bits become one; a register that is read whole stays."""
    valid = n.leaf("input", "valid", 1)
    copies = [netlist.Register(f"r{i}", n.leaf("register", f"r{i}", 8), 2 * i, valid) for i in range(2)]
    whole = netlist.Register("r2", n.leaf("register", "r2", 8), 6, valid)
    outputs = {f"o{i}": n.wrap(copy.value, 1) for i, copy in enumerate(copies)} | {"o2": whole.value}
    design = netlist.Netlist({"valid": valid}, outputs, [*copies, whole])
    narrow_to_read_bits(design)
    assert [r.value.width for r in design.registers] == [1, 1, 8]
    assert [r.initial for r in design.registers] == [0, 0, 6]
    merge_twins(design)
    assert len(design.registers) == 2 and design.outputs["o0"] is design.outputs["o1"]
