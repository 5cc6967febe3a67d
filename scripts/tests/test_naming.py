# SPDX-License-Identifier: Apache-2.0
"""Registers get the names of the C++ members that show the same values, and a netlist that differs is refused."""

import pytest

from flow.base.errors import FlowError
from flow.synthesis.lowering import expressions as n, netlist
from flow.synthesis.lowering.cleanup import merge_twins
from flow.synthesis.lowering.naming import adopt_cpp_values, count_named, name_registers, read_trace

VALID = (1, 0, 1, 1, 0, 1)


def design():
    """A counter of `valid` that starts at 5, the inverse of `valid` one clock late, and a twin of the counter."""
    valid = n.leaf("input", "valid", 1)
    counter, twin = (netlist.Register(name, n.leaf("register", name, 8), 5) for name in ("reg_7", "reg_8"))
    inverse = netlist.Register("reg_9", n.leaf("register", "reg_9", 1), 1, n.bit_not(valid))
    counter.next = n.wrap(n.add(counter.value, valid), 8)
    twin.next = counter.next
    outputs = {"disparity": n.add(counter.value, n.const(0)), "disparity_valid": n.bit_not(inverse.value)}
    return netlist.Netlist({"valid": valid}, outputs, [counter, twin, inverse])


def trace_text(change=None):
    rows, counter, late = [], 5, 0
    for clock, valid in enumerate(VALID):
        shown = counter + (1 if clock == change else 0)
        rows.append(f"{valid:x} {shown:x} {late:x} {counter:x} {late:x} 0")
        counter, late = counter + valid, valid
    names = "in_valid out_disparity out_disparity_valid count_value tag_valid never_seen"
    return "\n".join([f"stereo-hls trace 1 config=test clocks={len(rows)}", names, *rows]) + "\n"


def trace(tmp_path, text):
    path = tmp_path / "trace.txt"
    path.write_text(text)
    return read_trace(path)


def named(netlist, values):
    """The passes that compare with the C++; how many registers have found their name."""
    adopt_cpp_values(netlist, values)
    merge_twins(netlist)
    name_registers(netlist, values)
    return count_named(netlist)


def test_names_inverses_and_twins(tmp_path):
    netlist = design()
    assert named(netlist, trace(tmp_path, trace_text())) == 2
    assert [r.name for r in netlist.registers] == ["count_value", "tag_valid"]
    tag = netlist.registers[1]
    assert (tag.initial, tag.next) == (0, netlist.inputs["valid"])
    assert netlist.outputs["disparity_valid"] is tag.value


def test_a_register_without_counterpart_gets_a_plain_name(tmp_path):
    text = trace_text().replace("count_value", "in_count").replace("tag_valid", "in_tag")
    netlist = design()
    assert named(netlist, trace(tmp_path, text)) == 0
    assert sorted(r.name for r in netlist.registers) == ["other_0", "other_1"], (
        "the twin is merged, the others are not found"
    )


def test_a_netlist_that_differs_from_the_core_is_refused(tmp_path):
    with pytest.raises(FlowError, match="clock 3, disparity: expected 8, got 7") as caught:
        named(design(), trace(tmp_path, trace_text(change=3)))
    assert caught.value.exit_code == 4


@pytest.mark.parametrize(
    "damage", [lambda t: "", lambda t: t.replace("trace 1", "trace 2"), lambda t: t.rsplit("\n", 2)[0] + "\n"]
)
def test_damaged_trace_files_are_refused(tmp_path, damage):
    with pytest.raises(FlowError, match="not a complete 'trace' file"):
        trace(tmp_path, damage(trace_text()))


def test_among_registers_with_one_trace_those_around_decide(tmp_path):
    """Two flags that never rise: one follows the counter, one the late `valid`. A third has nothing around it."""
    netlist_ = design()
    counter, _, inverse = netlist_.registers

    def never(source):
        flag = netlist.Register(f"never_{source.name}", n.leaf("register", f"never_{source.name}", 1), 0)
        flag.next = n.bit_and(flag.value, n.equal(source.value, n.const(1)))
        return flag

    flags = [never(inverse), never(counter)]
    alone = netlist.Register("alone", n.leaf("register", "alone", 1), 0, n.const(0))
    netlist_.registers += [*flags, alone]
    still = (0,) * len(VALID)
    named(netlist_, trace(tmp_path, trace_text()) | {"count_never": still, "tag_never": still, "x_never": still})
    assert flags[0].name == "tag_never" and flags[1].name == "count_never"
    assert alone.name.startswith("other_")


def test_a_small_negative_number_is_signed_even_if_the_trace_has_none(tmp_path):
    """Its register would else have numbers for which VHDL has no integer."""
    core = design()
    counter = core.registers[0]
    difference = netlist.Register("reg_10", n.leaf("register", "reg_10", 32), 0)
    difference.next = n.wrap(n.sub(counter.value, core.registers[1].value), 32)
    core.registers.append(difference)
    core.outputs["disparity_valid"] = n.bit_and(
        core.outputs["disparity_valid"], n.less(n.wrap(difference.value, 32, signed=True), n.const(1))
    )
    adopt_cpp_values(core, trace(tmp_path, trace_text()))
    assert (difference.value.low, difference.value.high) == (-(1 << 31), (1 << 31) - 1)
    assert difference.next.op == "sub", "nothing is left to wrap"
