# SPDX-License-Identifier: Apache-2.0
"""Random netlists, written as VHDL and run in GHDL, against the same netlists run in Python."""

import re

import pytest

from flow.base import rtl
from flow.base.errors import FlowError
from flow.base.ghdl import to_verilog
from flow.cosim import vectors
from flow.cosim.simulators import Ghdl
from flow.synthesis.lowering import expressions as n, netlist
from flow.synthesis.lowering.cleanup import remove_unused
from flow.synthesis.lowering.evaluate import compile_step, initial_state
from flow.synthesis.lowering.ranges import narrow_registers
from flow.synthesis.lowering.reset import control_registers, split_hold
from flow.synthesis.lowering.vhdl_writer import Entity, VhdlWriter

INPUTS = {"left_pixel": 8, "right_pixel": 8, "start_of_frame": 1, "valid": 1}
CLOCKS = 300
GENERICS = dict.fromkeys(rtl.GENERICS, 1) | {"pixels_per_clock": 1, "disparity_bits": 8}
ENTITY = Entity(rtl.core_entity("test"), GENERICS)


def random_netlist(rng, registers=40):
    """Registers of some widths whose next values are random expressions of the inputs and of each other."""
    design = netlist.Netlist({name: n.leaf("input", name, w) for name, w in INPUTS.items()})
    for k in range(registers):
        width = rng.choice((1, 1, 4, 8, 8, 12))
        design.registers.append(
            netlist.Register(f"block{k // 10}_r{k}", n.leaf("register", f"block{k // 10}_r{k}", width))
        )
    words = [r.value for r in design.registers if not r.value.is_bit] + [
        design.inputs["left_pixel"],
        design.inputs["right_pixel"],
    ]
    bits = [r.value for r in design.registers if r.value.is_bit] + [
        design.inputs["start_of_frame"],
        design.inputs["valid"],
    ]
    for register in design.registers:
        make = random_bit if register.value.is_bit else random_word
        value = n.wrap(make(rng, words, bits, 3), register.value.width)
        register.next = n.mux(rng.choice(bits), value, register.value) if rng.random() < 0.3 else value
    design.outputs = {
        "disparity": n.wrap(n.add(*[r.value for r in design.registers]), 8),
        "disparity_valid": n.const(1),
        "pixel_valid": bits[0],
        "disparity_start_of_frame": n.bit_or(*bits[: len(bits) // 2]),
        "disparity_end_of_line": n.bit_and(bits[0], n.bit_not(n.less(words[0], words[1]))),
    }
    return design


def random_word(rng, words, bits, depth):
    if depth == 0:
        return rng.choice(words) if rng.random() < 0.8 else n.const(rng.randrange(256))
    x, y = (random_word(rng, words, bits, depth - 1) for _ in range(2))
    bit = random_bit(rng, words, bits, depth - 1)
    return rng.choice(
        (
            lambda: n.add(x, y),
            lambda: n.sub(x, y),
            lambda: n.absolute(n.sub(x, y)),
            lambda: n.mux(bit, x, y),
            lambda: n.add(x, bit),
            lambda: n.wrap(n.mul(n.wrap(x, 6), y), 12),
            lambda: n.bitwise(rng.choice(("and", "or", "xor")), n.wrap(x, 8), n.wrap(y, 8)),
            lambda: n.wrap(n.shift_left(x, rng.randrange(4)), 10),
            lambda: n.shift_right(n.wrap(x, 9), rng.randrange(5)),
            lambda: n.wrap(x, rng.randrange(1, 9)),
            lambda: n.wrap(x, 6, signed=True),
            lambda: n.add(x, n.const(-rng.randrange(9))),
        )
    )()


def random_bit(rng, words, bits, depth):
    if depth == 0:
        return rng.choice(bits)
    x, y = (random_word(rng, words, bits, depth - 1) for _ in range(2))
    p, q = (random_bit(rng, words, bits, depth - 1) for _ in range(2))
    return rng.choice(
        (
            lambda: n.less(x, y),
            lambda: n.equal(x, y),
            lambda: n.bit_not(n.equal(x, n.const(7))),
            lambda: n.bit_and(p, q),
            lambda: n.bit_or(p, q),
            lambda: n.bit_not(p),
            lambda: n.bit_xor(p, q),
            lambda: n.mux(p, q, n.less(x, n.const(50))),
            lambda: n.wrap(x, 1),
        )
    )()


def run_in_python(design, stimulus):
    """Outputs clock by clock, after two clocks of reset with all inputs 0, as the bench has them."""
    step = compile_step(design)
    registers, memories = initial_state(design)
    control = control_registers(design)
    for _ in range(2):
        step(dict.fromkeys(INPUTS, 0), registers, memories)
        for k, r in enumerate(design.registers):
            if id(r.value) in control:
                registers[k] = r.initial
    for clock, inputs in enumerate(stimulus):
        out = step(inputs, registers, memories)
        flags = out["disparity_start_of_frame"] | out["disparity_end_of_line"] << 1 | out["pixel_valid"] << 2
        yield vectors.Observed(clock, out["disparity"], flags)


@pytest.mark.parametrize("part", range(6))
def test_random_netlists_run_alike_in_ghdl_and_python(ghdl, rng, tmp_path, part):
    design = random_netlist(rng)
    narrow_registers(design)
    remove_unused(design)
    assert_alike(design, rng, tmp_path)


def assert_alike(design, rng, tmp_path):
    """GHDL and Python on the same stimulus; and GHDL's synthesis takes the VHDL, too."""
    (tmp_path / "core.vhd").write_text(VhdlWriter(design, "-- netlist of a test", ENTITY).write())
    stimulus = [{name: rng.randrange(1 << w) for name, w in INPUTS.items()} for _ in range(CLOCKS)]
    lines = [
        f"{s['valid'] | s['start_of_frame'] << 1:x} {s['left_pixel']:02x} {s['right_pixel']:02x}" for s in stimulus
    ]
    (tmp_path / "stimulus.txt").write_text("\n".join(["header", *lines]) + "\n")
    simulator = Ghdl("test", [tmp_path / "core.vhd"], tmp_path / "sim")
    simulator.build()
    simulator.run(tmp_path / "stimulus.txt", tmp_path / "observed.txt", lambda clock: None, 60)
    observed, clocks = vectors.read_observed(tmp_path / "observed.txt")
    assert clocks == CLOCKS
    for expected, got in zip(run_in_python(design, stimulus), observed, strict=True):
        assert got == expected
    assert f"module {ENTITY.name}" in to_verilog([tmp_path / "core.vhd"], tmp_path, ENTITY.name)


def test_only_a_sum_of_terms_that_share_no_bit_becomes_a_concatenation(ghdl, rng, tmp_path):
    """As words they are operands of a bit operation: sums that share no bit, that carry, and that subtract."""
    inputs = {name: n.leaf("input", name, w) for name, w in INPUTS.items()}
    left, right = inputs["left_pixel"], inputs["right_pixel"]
    low, high = n.wrap(left, 4), n.wrap(right, 3)
    for number, total in enumerate(
        (
            n.add(low, n.shift_left(high, 4)),
            n.add(low, high),
            n.add(low, n.shift_left(high, 2), n.const(9)),
            n.add(n.mux(inputs["valid"], n.const(20), n.const(30)), low, n.const(-20)),
        )
    ):
        register = netlist.Register("r", n.leaf("register", "r", 8), next=n.bitwise("xor", total, right))
        outputs = {
            "disparity": register.value,
            **dict.fromkeys(("disparity_valid", "pixel_valid"), n.const(1)),
            **dict.fromkeys(("disparity_start_of_frame", "disparity_end_of_line"), n.const(0)),
        }
        (tmp_path / str(number)).mkdir()
        assert_alike(netlist.Netlist(inputs, outputs, [register]), rng, tmp_path / str(number))


@pytest.mark.parametrize("low", [3, 13, 35])
def test_a_word_may_hold_a_word(ghdl, rng, tmp_path, low):
    """A wide register takes a pixel and, above it, a word of 40 bits that has no name of its own."""
    left, right = n.leaf("input", "left_pixel", 8), n.leaf("input", "right_pixel", 8)
    inner = n.add(right, n.shift_left(left, 16), n.shift_left(n.bitwise("xor", left, right), 32))
    held = netlist.Register("word_held", n.leaf("register", "word_held", 50))
    held.next = n.add(left, n.shift_left(inner, 10))
    assert n.disjoint_ones(held.next.args) is not None
    design = netlist.Netlist({name: n.leaf("input", name, w) for name, w in INPUTS.items()})
    design.inputs.update({"left_pixel": left, "right_pixel": right})
    design.registers = [held]
    design.outputs = {
        "disparity": n.wrap(n.shift_right(held.value, low), 8),
        "disparity_valid": n.const(1),
        **dict.fromkeys(("pixel_valid", "disparity_start_of_frame", "disparity_end_of_line"), n.const(0)),
    }
    assert_alike(design, rng, tmp_path)


def test_ranges_follow_a_pipeline_and_leave_counters_alone():
    pixel = n.leaf("input", "left_pixel", 8)
    difference, total = (netlist.Register(name, n.leaf("register", name, 16)) for name in ("difference", "total"))
    counter = netlist.Register("counter", n.leaf("register", "counter", 7), 3)
    difference.next = n.absolute(n.sub(pixel, n.leaf("input", "right_pixel", 8)))
    total.next = n.wrap(n.add(difference.value, difference.value, difference.value), 16)
    counter.next = n.wrap(n.add(counter.value, n.const(1)), 7)
    design = netlist.Netlist({}, {"out": total.value, "count": counter.value}, [difference, total, counter])
    narrow_registers(design)
    assert [(r.value.low, r.value.high) for r in design.registers] == [(0, 255), (0, 765), (0, 127)]
    assert total.next.op == "add", "the wrap is proved away"


def test_hold_is_found():
    enable, pixel = n.leaf("input", "valid", 1), n.leaf("input", "left_pixel", 8)
    register = netlist.Register("r", n.leaf("register", "r", 8))
    register.next = n.mux(enable, pixel, register.value)
    assert split_hold(register) == (enable, pixel)
    register.next = n.mux(enable, register.value, pixel)
    assert split_hold(register) == (n.bit_not(enable), pixel)
    register.next = pixel
    assert split_hold(register) == (None, pixel)


def memory_design():
    address, word = (
        netlist.Register("m_address", n.leaf("register", "m_address", 3)),
        netlist.Register("m_word", n.leaf("register", "m_word", 8)),
    )
    memory = netlist.Memory(
        "m_memory",
        8,
        8,
        n.leaf("memory", "m_memory", 8),
        address.value,
        address.value,
        n.leaf("input", "left_pixel", 8),
    )
    address.next, word.next = n.wrap(n.add(address.value, n.const(1)), 3), memory.data
    outputs = {
        "disparity": word.value,
        "pixel_valid": n.const(1),
        "disparity_valid": n.const(1),
        "disparity_start_of_frame": n.const(0),
        "disparity_end_of_line": n.const(0),
    }
    return netlist.Netlist({"left_pixel": n.leaf("input", "left_pixel", 8)}, outputs, [address, word], [memory])


def test_choices_become_if_statements():
    """One for all registers of a condition: VHDL-93 has no conditional assignment in a process."""
    design = memory_design()
    pixel = design.inputs["left_pixel"]
    first, second, third = (netlist.Register(name, n.leaf("register", name, 8)) for name in ("b_a", "b_b", "b_c"))
    small = n.less(pixel, n.const(9))
    first.next, second.next = n.mux(small, pixel, n.const(1)), n.mux(small, n.const(2), pixel)
    third.next = n.mux(n.equal(pixel, n.const(50)), n.const(3), pixel)
    design.registers += [first, second, third]
    design.outputs["disparity"] = n.wrap(n.add(first.value, second.value, third.value), 8)
    text = " ".join(VhdlWriter(design, "-- choices", ENTITY).write().split())
    shared = "b_a <= in_left_pixel; b_b <= 2; else b_a <= 1; b_b <= in_left_pixel; end if;"
    assert f"b_a_is_less := in_left_pixel < 9; if b_a_is_less then {shared}" in text
    assert "if in_left_pixel = 50 then b_c <= 3; else b_c <= in_left_pixel; end if;" in text
    assert " when " not in text


def test_a_register_may_be_held_by_a_choice():
    """The condition of its `if` is a choice between bits."""
    design = memory_design()
    pixel = design.inputs["left_pixel"]
    held = netlist.Register("b_held", n.leaf("register", "b_held", 8))
    small, odd, late = n.less(pixel, n.const(9)), n.equal(pixel, n.const(3)), n.less(n.const(99), pixel)
    held.next = n.mux(n.mux(small, odd, late), pixel, held.value)
    design.registers.append(held)
    design.outputs["disparity"] = held.value
    text = " ".join(VhdlWriter(design, "-- a choice holds", ENTITY).write().split())
    choice = "b_held_choice := in_left_pixel = 3; else b_held_choice := 99 < in_left_pixel; end if;"
    assert choice in text, text
    assert "if b_held_choice then b_held <= in_left_pixel; end if;" in text


def test_reset_reaches_flags_through_a_memory():
    """The word has a flag in bit 0 and data above it: a reset must set what the flag depends on, and leave the data
    alone."""
    design = memory_design()
    flag, data = (netlist.Register(name, n.leaf("register", name, width)) for name, width in (("flag", 1), ("data", 7)))
    flag.next, data.next = n.wrap(design.inputs["left_pixel"], 1), n.wrap(design.inputs["left_pixel"], 7)
    design.registers += [flag, data]
    memory, word = design.memories[0], design.registers[1]
    memory.write_data = n.add(flag.value, n.shift_left(data.value, 1))
    names = [r.name for r in control_registers(design).values()]
    assert names == ["m_address"]
    design.outputs["disparity_valid"] = n.wrap(word.value, 1)
    assert sorted(r.name for r in control_registers(design).values()) == ["flag", "m_address"]
    design.outputs["disparity_valid"] = n.wrap(n.shift_right(word.value, 3), 1)
    assert sorted(r.name for r in control_registers(design).values()) == ["data", "m_address"]
    design.outputs["disparity_valid"] = n.equal(word.value, n.const(5))
    assert sorted(r.name for r in control_registers(design).values()) == ["data", "flag", "m_address"]


def test_reset_leaves_addresses_alone_that_follow_from_pixels():
    """A winner's column is an address that no flag announces. Where a flag depends on the word that is read there, it
    must start anew all the same, and so must what counts."""
    design = memory_design()
    count, word = design.registers
    place = netlist.Register("place", n.leaf("register", "place", 3))
    place.next = n.wrap(n.add(count.value, design.inputs["left_pixel"]), 3)
    design.registers.append(place)
    memory = design.memories[0]
    memory.read_address = place.value
    assert [r.name for r in control_registers(design).values()] == ["m_address"], "the write address counts"
    memory.write_address = place.value
    assert not control_registers(design)
    design.outputs["disparity_valid"] = n.wrap(word.value, 1)
    assert sorted(r.name for r in control_registers(design).values()) == ["m_address", "place"]


def test_numbers_are_compared_by_their_difference_and_constants_are_not():
    design = memory_design()
    x, y = n.leaf("input", "left_pixel", 8), n.leaf("input", "right_pixel", 8)
    design.inputs |= {"left_pixel": x, "right_pixel": y}
    design.outputs["disparity_valid"] = n.less(x, y)
    design.outputs["disparity_end_of_line"] = n.less(x, n.const(7))
    text = VhdlWriter(design, "-- comparisons", ENTITY).write()
    assert "disparity_valid <= as_bit((in_left_pixel - in_right_pixel) < 0);" in text
    assert "disparity_end_of_line <= as_bit(in_left_pixel < 7);" in text


def test_memories_become_the_cell():
    text = VhdlWriter(memory_design(), "-- memory", ENTITY).write()
    assert re.search(
        r"m_memory : entity work\.line_memory\s+generic map \(depth => 8, width => 8, address_bits => 3\)", text
    )
    assert "m_memory_read_address <= to_unsigned(m_address, 3);" in text
    assert "m_word <=" not in text, "the cell's read register takes its place"


def test_a_memory_that_is_read_without_a_register_is_refused():
    design = memory_design()
    design.outputs["disparity"] = design.memories[0].data
    with pytest.raises(FlowError, match="read data of memory m_memory"):
        VhdlWriter(design, "", ENTITY)


def test_an_operation_without_vhdl_is_refused():
    design = memory_design()
    design.outputs["disparity"] = n.wrap(
        n.shift_right(n.sub(design.registers[1].value, n.leaf("input", "right_pixel", 8)), 1), 8
    )
    design.inputs["right_pixel"] = n.leaf("input", "right_pixel", 8)
    with pytest.raises(FlowError, match="no VHDL for an arithmetic right shift"):
        VhdlWriter(design, "", ENTITY).write()


@pytest.mark.parametrize("constant", [0x10, 0x11, 0x70, 0x90, 0xF0])
def test_constants_in_a_concatenation_keep_their_place(ghdl, tmp_path, constant):
    """An 8-bit word of two registers of 1 bit (bits 1 and 3) and of constant ones around them, through a memory and
    back."""
    design = memory_design()
    pixel = design.inputs["left_pixel"]
    ones = n.const(constant)
    bits = n.add(ones, n.shift_left(n.wrap(pixel, 1), 1), n.shift_left(n.wrap(n.shift_right(pixel, 1), 1), 3))
    assert n.disjoint_ones(bits.args) is not None
    design.memories[0].write_data = bits
    (tmp_path / "core.vhd").write_text(VhdlWriter(design, "-- constants", ENTITY).write())
    stimulus = [{"left_pixel": k % 4, "right_pixel": 0, "start_of_frame": 0, "valid": 1} for k in range(40)]
    lines = [f"1 {s['left_pixel']:02x} 00" for s in stimulus]
    (tmp_path / "stimulus.txt").write_text("\n".join(["header", *lines]) + "\n")
    simulator = Ghdl("test", [rtl.MEMORY_CELL, tmp_path / "core.vhd"], tmp_path / "sim")
    simulator.build()
    simulator.run(tmp_path / "stimulus.txt", tmp_path / "observed.txt", lambda clock: None, 60)
    observed, _ = vectors.read_observed(tmp_path / "observed.txt")
    late = [o.disparity for o in observed if o.clock > 20]
    assert late and all(word & ~0b1010 == constant & ~0b1010 for word in late)
    assert {word & 0b1010 for word in late} == {0, 2, 8, 10}


def test_reset_reaches_an_address_that_follows_from_a_held_size():
    """An address that follows from pixels needs no reset; one that counts up to the size of the images does."""
    design = memory_design()
    design.inputs["image_width"] = n.leaf("input", "image_width", 3)
    address = design.registers[0]
    address.next = n.wrap(n.add(address.value, design.inputs["image_width"]), 3)
    assert control_registers(design) == {}
    design.held = ("image_width",)
    assert [r.name for r in control_registers(design).values()] == ["m_address"]
