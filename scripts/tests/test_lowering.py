# SPDX-License-Identifier: Apache-2.0
"""From the tool's VHDL to a netlist: what is read, what the controller becomes, and what is refused."""

import re

import pytest

from design_text import DESIGN
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.synthesis.lowering.cleanup import remove_unused
from flow.synthesis.lowering.control import remove_control
from flow.synthesis.lowering.evaluate import compile_step, initial_state
from flow.synthesis.lowering.lower import lower
from flow.synthesis.lowering.passes import PASSES
from flow.synthesis.lowering.vhdl_reader import read_design


def lowered(tmp_path, *changes):
    text = DESIGN
    for old, new in changes:
        assert old in text, f"the design has no '{old}'"
        text = text.replace(old, new)
    path = tmp_path / "design.vhd"
    path.write_text(text)
    design = read_design(path)
    netlist = lower(design)
    remove_control(netlist, design)
    remove_unused(netlist)
    return netlist


def run(netlist, valid):
    step = compile_step(netlist)
    registers, memories = initial_state(netlist)
    return [step({"valid": bit}, registers, memories)["disparity"] for bit in valid]


def test_start_values_come_from_the_startup_state_and_control_is_gone(tmp_path):
    netlist = lowered(tmp_path)
    assert list(netlist.inputs) == ["valid"]
    (register,) = netlist.registers
    assert register.initial == 5
    assert "control" not in repr(register.next)
    assert run(netlist, [1, 0, 1, 1]) == [8, 9, 9, 10]


def test_a_register_that_the_loop_never_writes_is_a_constant(tmp_path):
    netlist = lowered(tmp_path, ("selector_MUX_0 <= '1';\n        wrenable_reg_0 <= '1';", "selector_MUX_0 <= '1';"))
    assert netlist.registers == []
    assert run(netlist, [1, 1]) == [8, 8]


def test_parts_of_signals_are_read(tmp_path):
    netlist = lowered(
        tmp_path, ("in2 => std_logic_vector(out_sum));", "in2 => std_logic_vector(out_sum(2 downto 1)));")
    )
    assert run(netlist, [1, 0, 1, 1]) == [8 >> 1 & 3, 9 >> 1 & 3, 9 >> 1 & 3, 10 >> 1 & 3]


@pytest.mark.parametrize(
    "changes,message",
    [
        (
            [
                (
                    "ui_plus_expr_FU generic map(BITSIZE_in1=>8,\n    BITSIZE_in2=>2",
                    "ui_mystery_expr_FU generic map(BITSIZE_in1=>8,\n    BITSIZE_in2=>2",
                )
            ],
            "no lowering rule for instance kind 'ui_mystery_expr_FU'",
        ),
        (
            [("        next_state <= S_0;\n      when others", "        next_state <= S_1;\n      when others")],
            "the loop takes 2 states, not one",
        ),
        (
            [
                (
                    "in1 => unsigned(out_reg_0),\n    in2 => unsigned(out_const_1)",
                    "in1 => unsigned(out_nowhere),\n    in2 => unsigned(out_const_1)",
                )
            ],
            "undeclared signal out_nowhere",
        ),
        (
            [("  const_1 : constant_value", "  out_const_0 <= out_const_1;\n  const_1 : constant_value")],
            "a statement that is no instance",
        ),
        (
            [
                (
                    "        selector_MUX_0 <= '1';\n        wrenable",
                    "        if(other = '1') then\n        end if;\n        wrenable",
                )
            ],
            "state S_0 has a condition",
        ),
        ([('value=>"11"', "value=>SOMETHING")], "constant const_1 has an unknown value SOMETHING"),
        ([("end datapath_stereo_core_arch;", "")], "no part from"),
        ([("(reset='0')", "(reset='1')")], "no reset state"),
    ],
)
def test_what_is_not_understood_is_named(tmp_path, changes, message):
    with pytest.raises(FlowError, match=message) as caught:
        lowered(tmp_path, *changes)
    assert caught.value.exit_code == 4


def test_a_missing_file_is_said(tmp_path):
    with pytest.raises(FlowError, match="cannot read the tool's VHDL"):
        read_design(tmp_path / "nothing.vhd")


def test_the_page_has_the_passes_in_their_order():
    page = (ROOT / "docs" / "lowering.md").read_text()
    table = page.partition("| pass | file | test |\n|---|---|---|\n")[2].partition("\n\n")[0]
    assert re.findall(r"^\| (.+?) \|", table, re.MULTILINE) == [step.name for step in PASSES]
