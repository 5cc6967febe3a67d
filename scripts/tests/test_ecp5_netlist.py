# SPDX-License-Identifier: Apache-2.0
"""Netlists whose carry chains were packed again do the same: yosys proves it, and notices a single wrong bit."""

import copy
import json
import re
from pathlib import Path
from typing import Any

import pytest

from cover import with_slow
from flow.base import committed, rtl
from flow.base.errors import FlowError
from flow.base.ghdl import to_verilog
from flow.base.tools import find_yosys, run
from flow.implementation import ecp5_carry, ecp5_fanout, ecp5_half, ecp5_memory, ecp5_reset

# What the cores do with numbers: magnitudes, sums with a carry, comparisons, among them of numbers of which one of two
# is 0; all without registers, so that a proof needs no time.
SOURCE = """
module top(input [7:0] a, b, c, d, input [11:0] v, w, x, y, input s, t,
           output [8:0] difference, output [8:0] pair, output [7:0] magnitude, output [9:0] column,
           output less, not_less, less_of_either, output [8:0] with_carry_in, output carry_only, output [3:0] narrow,
           output [8:0] turned);
  assign difference = a - b;
  wire [7:0] folded_a = s ? ~a : a, folded_b = t ? ~b : b;
  assign pair = folded_a + folded_b + s;
  assign magnitude = folded_a + s;
  assign column = {1'b0, c, d[0]} + folded_b + t;
  wire [12:0] v_w = v - w, either = (v | w) - (x | y);
  assign less = v_w[12];
  wire [12:0] x_w = x - w;
  assign not_less = !x_w[12];
  assign less_of_either = either[12];
  assign with_carry_in = c + d + (a[0] & b[0]);
  wire [8:0] sum = c + d;
  assign carry_only = sum[8];
  assign narrow = a[2:0] - b[2:0];
  assign turned = (s ? b : a) - (s ? a : b);
endmodule
"""
# The cells as Lattice describes them, apart from yosys's own models.
CELLS = """
module LUT4(input A, B, C, D, output Z);
  parameter [15:0] INIT = 0;
  assign Z = INIT[{D, C, B, A}];
endmodule
module PFUMX(input ALUT, BLUT, C0, output Z);
  assign Z = C0 ? ALUT : BLUT;
endmodule
module L6MUX21(input D0, D1, SD, output Z);
  assign Z = SD ? D1 : D0;
endmodule
module CCU2C(input CIN, A0, B0, C0, D0, A1, B1, C1, D1, output S0, S1, COUT);
  parameter [15:0] INIT0 = 0, INIT1 = 0;
  parameter INJECT1_0 = "NO", INJECT1_1 = "NO";
  wire through_0 = INIT0[{D0, C0, B0, A0}], through_1 = INIT1[{D1, C1, B1, A1}];
  wire carry = through_0 ? CIN : INIT0[{2'b00, B0, A0}];
  assign S0 = through_0 ^ CIN, S1 = through_1 ^ carry, COUT = through_1 ? carry : INIT1[{2'b00, B1, A1}];
endmodule
"""


@pytest.fixture(scope="module")
def netlist(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    work = tmp_path_factory.mktemp("ecp5")
    (work / "top.v").write_text(SOURCE)
    commands = "read_verilog top.v; synth_ecp5 -abc9 -top top; write_json top.json"
    run([find_yosys(), "-p", commands], cwd=work, log=work / "synthesis.log")
    content: dict[str, Any] = json.loads((work / "top.json").read_text())
    for module in content["modules"].values():
        module["cells"] = {n: c for n, c in module["cells"].items() if not c["type"].startswith("$")}
    return {"modules": {"top": content["modules"]["top"]}}


def packed(netlist: dict[str, Any]) -> dict[str, Any]:
    result = copy.deepcopy(netlist)
    ecp5_carry.CarryPacker(result["modules"]["top"]).run()
    return result


def look_up_tables(netlist: dict[str, Any]) -> int:
    types = [cell["type"] for cell in netlist["modules"]["top"]["cells"].values()]
    return types.count("LUT4") + 2 * types.count("CCU2C")


def prove_equal(before: dict[str, Any], after: dict[str, Any], work: Path) -> None:
    """Raises where the two differ for any input."""
    (work / "cells.v").write_text(CELLS)
    for name, content in (("before", before), ("after", copy.deepcopy(after))):
        for cell in content["modules"]["top"]["cells"].values():  # nextpnr's way to say that an output goes nowhere
            for port, bits in cell["connections"].items():
                if cell["port_directions"][port] == "output" and bits == ["x"]:
                    cell["connections"][port] = []
        renamed = {"modules": {name: content["modules"]["top"] | {"attributes": {}}}}  # none of them the top
        (work / f"{name}.json").write_text(json.dumps(renamed))
    commands = [
        "read_json before.json; read_json after.json; read_verilog cells.v",
        "hierarchy -check; proc; flatten; opt_clean",
        "miter -equiv -make_outputs -flatten before after miter; hierarchy -top miter; opt -full",
        "sat -verify -prove trigger 0 miter",
    ]
    run([find_yosys(), "-p", "; ".join(commands)], cwd=work, log=work / "proof.log")


def test_packed_chains_are_proven_equal_and_smaller(netlist: dict[str, Any], tmp_path: Path) -> None:
    after = packed(netlist)
    prove_equal(netlist, after, tmp_path)
    assert look_up_tables(after) < 0.75 * look_up_tables(netlist)


def logic_only(netlist: dict[str, Any]) -> dict[str, Any]:
    """The netlist without registers and memories: what they give becomes an input, what they take an output."""
    module = netlist["modules"]["top"]
    ports = dict(module["ports"])
    for name in [n for n, c in module["cells"].items() if c["type"] not in ("LUT4", "CCU2C", "PFUMX", "L6MUX21")]:
        cell = module["cells"].pop(name)
        for port, bits in cell["connections"].items():
            nets = [bit for bit in bits if isinstance(bit, int)]  # constants stay
            direction = "input" if cell["port_directions"][port] == "output" else "output"
            if nets:
                ports[re.sub(r"\W", "_", name) + "_" + port] = {"direction": direction, "bits": nets}
    return {"modules": {"top": {"ports": ports, "cells": module["cells"], "netnames": {}}}}


@pytest.mark.slow
def test_a_whole_core_is_proven_equal(ghdl: str, tmp_path: Path) -> None:
    """The committed `tiny`. Registers and memories are the same before and after, so the logic between them decides."""
    entity = rtl.core_entity("tiny")
    verilog = to_verilog([rtl.MEMORY_CELL, committed.folder("tiny") / f"{entity}.vhd"], tmp_path, entity)
    (tmp_path / "top.v").write_text(re.sub(rf"\bmodule {entity}\b", "module top", verilog))
    commands = "read_verilog top.v; hierarchy -top top; proc; flatten; opt -full; synth_ecp5 -abc9 -top top"
    run([find_yosys(), "-p", f"{commands}; write_json top.json"], cwd=tmp_path, log=tmp_path / "synthesis.log")
    before = {"modules": {"top": json.loads((tmp_path / "top.json").read_text())["modules"]["top"]}}
    after = packed(before)
    assert look_up_tables(after) < look_up_tables(before)
    prove_equal(logic_only(before), logic_only(after), tmp_path)


@pytest.mark.parametrize("which", with_slow(range(4), [0]))
def test_the_proof_notices_a_wrong_bit(netlist: dict[str, Any], tmp_path: Path, which: int) -> None:
    after = packed(netlist)
    cells = [cell for cell in after["modules"]["top"]["cells"].values() if cell["type"] == "CCU2C"]
    parameters = cells[which * (len(cells) - 1) // 3]["parameters"]
    # The one bit of a half that is used with every one of its inputs at 1.
    wrong = parameters["INIT0"]
    parameters["INIT0"] = ("0" if wrong[0] == "1" else "1") + wrong[1:]
    with pytest.raises(FlowError):
        prove_equal(netlist, after, tmp_path)


def test_an_inner_table_takes_the_place_of_its_net() -> None:
    both = ecp5_half.Table((1, 2), 0b1000)
    either = ecp5_half.Table((3, 4), 0b1110)
    inserted = ecp5_half.with_input(both, 2, either)
    for values in ecp5_half.assignments((1, 3, 4)):
        assert inserted.at(values) == (values[1] & (values[3] | values[4]))


def test_a_half_that_needs_more_than_its_tables_does_not_fit() -> None:
    sum_of_four = ecp5_half.tabulate((1, 2, 3, 4), lambda v: (v[1] + v[2] + v[3] + v[4]) & 1)
    fits = ecp5_half.Half(sum_of_four, ecp5_half.tabulate((1, 2), lambda v: v[1] ^ v[2]), 9)
    assert fits.fit() is not None
    majority = ecp5_half.tabulate((1, 2, 3), lambda v: int(v[1] + v[2] + v[3] > 1))
    assert ecp5_half.Half(ecp5_half.constant(0), majority, None).fit() is None


def memory(register: dict[str, Any], width: int = 18) -> dict[str, Any]:
    """A RAM with one output that is read, and what reads it."""
    ram = {
        "type": "DP16KD",
        "parameters": {"REGMODE_A": "NOREG", "REGMODE_B": "NOREG", "DATA_WIDTH_B": f"{width:b}"},
        "port_directions": dict.fromkeys(("CLKA", "CLKB", "OCEA", "OCEB"), "input")
        | dict.fromkeys(("DOB0", "DOB1"), "output"),
        "connections": {"CLKA": [2], "CLKB": [2], "OCEA": ["0"], "OCEB": ["1"], "DOB0": [10], "DOB1": [11]},
    }
    plain = {
        "type": "TRELLIS_FF",
        "parameters": {"CEMUX": "1 ", "CLKMUX": "CLK", "REGSET": "RESET"},
        "port_directions": {"CLK": "input", "DI": "input", "LSR": "input", "Q": "output"},
        "connections": {"CLK": [2], "DI": [10], "LSR": ["0"], "Q": [20]},
    }
    for key, value in register.items():
        plain[key] = plain[key] | value
    return {"ports": {"out": {"bits": [20]}}, "cells": {"ram": ram, "register": plain}}


def test_a_register_behind_a_memory_moves_into_it() -> None:
    module = memory({})
    assert ecp5_memory.use_output_registers(module) == 1
    assert list(module["cells"]) == ["ram"]
    ram = module["cells"]["ram"]
    assert (ram["parameters"]["REGMODE_A"], ram["parameters"]["REGMODE_B"]) == ("NOREG", "OUTREG")
    assert ram["connections"]["DOB0"] == [20]


def test_both_ports_of_a_wide_memory_take_their_registers_in_together() -> None:
    module = memory({}, width=36)
    assert ecp5_memory.use_output_registers(module) == 1
    ram = module["cells"]["ram"]
    assert (ram["parameters"]["REGMODE_A"], ram["parameters"]["REGMODE_B"]) == ("OUTREG", "OUTREG")
    assert ram["connections"]["OCEA"] == ram["connections"]["OCEB"] == ["1"]


@pytest.mark.parametrize(
    "register",
    [
        {"connections": {"CLK": [3]}},
        {"connections": {"LSR": [4]}},
        {"parameters": {"CEMUX": "CE"}},
        {"parameters": {"REGSET": "SET"}},
        {"parameters": {"CLKMUX": "INV"}},
    ],
)
def test_other_registers_stay(register: dict[str, Any]) -> None:
    module = memory(register)
    assert ecp5_memory.use_output_registers(module) == 0
    assert set(module["cells"]) == {"ram", "register"}


def test_a_memory_of_which_something_else_is_read_stays() -> None:
    module = memory({})
    module["ports"]["other"] = {"bits": [10]}
    assert ecp5_memory.use_output_registers(module) == 0


# Two rows of registers, all enabled by one register that is reset, or all reset by one.
ROWS = """
module top(input clock, reset, control, input [7:0] a, b, output reg [7:0] x, y, output reg controls);
  reg [7:0] first, other;
  always @(posedge clock) begin
    controls <= reset ? 1'b0 : control;
    ROWS
  end
endmodule
"""
SHIFTS = "begin first <= a; x <= first; other <= b; y <= other ^ first; end"
CONTROLS = {
    "CE": f"if (controls) {SHIFTS}",
    "LSR": f"if (controls) begin first <= 0; x <= 0; other <= 0; y <= 0; end else {SHIFTS}",
}
REGISTER = """
module TRELLIS_FF(input CLK, LSR, CE, DI, M, output reg Q = 0);
  parameter GSR = "DISABLED", CEMUX = "1", CLKMUX = "CLK", LSRMUX = "LSR", SRMODE = "LSR_OVER_CE", REGSET = "RESET";
  always @(posedge CLK)
    if (LSRMUX == "INV" ? !LSR : LSR) Q <= REGSET == "SET";
    else if (CE || CEMUX != "CE") Q <= DI;
endmodule
"""


@pytest.fixture(scope="module", params=CONTROLS)
def controlled(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, dict[str, Any]]:
    """(pin, netlist)"""
    work = tmp_path_factory.mktemp("controlled")
    (work / "top.v").write_text(ROWS.replace("ROWS", CONTROLS[request.param]))
    commands = "read_verilog top.v; synth_ecp5 -abc9 -top top; write_json top.json"
    run([find_yosys(), "-p", commands], cwd=work, log=work / "synthesis.log")
    module = json.loads((work / "top.json").read_text())["modules"]["top"]
    module["cells"] = {n: c for n, c in module["cells"].items() if not c["type"].startswith("$")}
    return request.param, {"modules": {"top": module}}


def prove_equal_in_time(before: dict[str, Any], after: dict[str, Any], work: Path) -> None:
    """Raises where outputs differ after any inputs."""
    (work / "cells.v").write_text(CELLS + REGISTER)
    for name, content in (("before", before), ("after", after)):
        (work / f"{name}.json").write_text(
            json.dumps({"modules": {name: content["modules"]["top"] | {"attributes": {}}}})
        )
    commands = [
        "read_json before.json; read_json after.json; read_verilog cells.v",
        "hierarchy -check; proc; flatten; opt_clean",
        "miter -equiv -flatten before after miter; hierarchy -top miter; opt_clean",
        "sat -verify -tempinduct -prove trigger 0 -seq 1 -maxsteps 10 miter",
    ]
    run([find_yosys(), "-p", "; ".join(commands)], cwd=work, log=work / "proof.log")


Controlled = tuple[str, dict[str, Any]]
WIDE = {"CE": 16, "LSR": 16}


def test_copies_are_proven_equal(controlled: Controlled, tmp_path: Path) -> None:
    pin, before = controlled
    after = copy.deepcopy(before)
    assert ecp5_fanout.copy_wide_controls(after["modules"]["top"], largest=WIDE, readers_of_a_copy=10) == 4
    readers: dict[int, int] = {}
    for cell in after["modules"]["top"]["cells"].values():
        for bit in cell["connections"].get(pin, []):
            readers[bit] = readers.get(bit, 0) + 1
    assert sorted(readers.values())[-3:] == [10, 10, 10]
    prove_equal_in_time(before, after, tmp_path)
    assert ecp5_fanout.copy_wide_controls(after["modules"]["top"], largest=WIDE) == 0, "no copy is wide"


def enabled_by_one(readers: int, others: int) -> dict[str, Any]:
    """A netlist in which one register enables `readers` others, beside `others`."""
    driver = {"type": "TRELLIS_FF", "connections": {"Q": [2], "DI": ["0"]}}
    enabled = {f"enabled_{i}": {"type": "TRELLIS_FF", "connections": {"Q": [3 + i], "CE": [2]}} for i in range(readers)}
    free = {f"free_{i}": {"type": "TRELLIS_FF", "connections": {"Q": [3 + readers + i]}} for i in range(others)}
    return {"cells": {"driver": driver} | enabled | free, "netnames": {}}


@pytest.mark.parametrize(
    "readers, others, copies",
    [(9_000, 23_767, 0), (9_000, 23_768, 9), (8_192, 30_000, 0), (16_384, 1_000, 0), (16_385, 1_000, 17)],
)
def test_a_large_design_has_copies_for_fewer_readers(readers: int, others: int, copies: int) -> None:
    """32,768 registers are no large design yet, 32,769 are."""
    assert ecp5_fanout.copy_wide_controls(enabled_by_one(readers, others)) == copies


def test_registers_that_hang_together_have_one_copy(controlled: Controlled) -> None:
    """A wide row behind each bit: the copy of a register is that of the one before it, for nearly all."""
    pin, before = controlled
    module = copy.deepcopy(before)["modules"]["top"]
    ecp5_fanout.copy_wide_controls(module, largest=WIDE, readers_of_a_copy=8)
    cells = [c for c in module["cells"].values() if c["type"] == "TRELLIS_FF" and c["connections"].get(pin)]
    copy_of = {cell["connections"]["Q"][0]: cell["connections"][pin][0] for cell in cells}
    pairs = [(cell["connections"]["DI"][0], cell["connections"]["Q"][0]) for cell in cells]
    together = [copy_of[first] == copy_of[second] for first, second in pairs if first in copy_of]
    assert together and sum(together) >= 0.7 * len(together)


def test_the_proof_notices_a_copy_of_something_else(controlled: Controlled, tmp_path: Path) -> None:
    pin, before = controlled
    after = copy.deepcopy(before)
    module = after["modules"]["top"]
    ecp5_fanout.copy_wide_controls(module, largest=WIDE, readers_of_a_copy=10)
    wrong = next(cell for name, cell in module["cells"].items() if name.endswith(f"_{pin}_copy_0"))
    wrong["connections"] = wrong["connections"] | {"DI": ["1"]}
    with pytest.raises(FlowError):
        prove_equal_in_time(before, after, tmp_path)


# Registers that a comparison resets or sets, one of them with an enable, and one that a port resets.
RESETS = """
module top(input clock, reset, enable, input [3:0] a, b, input [2:0] i, j, input k,
           output reg [3:0] index, output reg [2:0] chosen, kept, outer, output reg [1:0] least, output reg [8:0] sum,
           output reg [3:0] far);
  wire less = a < b, of_four = (i[0] & i[1]) ^ (j[0] | j[1]);
  always @(posedge clock) begin
    index <= less ? {1'b0, i} : {1'b1, j};
    chosen <= less ? 3'd0 : i ^ j;
    if (a == b) sum <= 0; else sum <= {a, i} + {b, j};
    far <= of_four ? 4'd0 : a + b;
    least <= (i == j) ? 2'b11 : {k ^ a[0], k};
    if (less) kept <= 0; else if (enable) kept <= j;
    outer <= reset ? 3'd0 : i;
  end
endmodule
"""


@pytest.fixture(scope="module")
def reset_by_logic(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    work = tmp_path_factory.mktemp("resets")
    (work / "top.v").write_text(RESETS)
    commands = "read_verilog top.v; synth_ecp5 -abc9 -top top; write_json top.json"
    run([find_yosys(), "-p", commands], cwd=work, log=work / "synthesis.log")
    module = json.loads((work / "top.json").read_text())["modules"]["top"]
    module["cells"] = {n: c for n, c in module["cells"].items() if not c["type"].startswith("$")}
    return {"modules": {"top": module}}


def resets_of(netlist: dict[str, Any]) -> list[int]:
    """Of each register that has one."""
    registers = [c for c in netlist["modules"]["top"]["cells"].values() if c["type"] == "TRELLIS_FF"]
    return [bit for c in registers for bit in c["connections"].get("LSR", []) if isinstance(bit, int)]


def test_resets_as_logic_are_proven_equal(reset_by_logic: dict[str, Any], tmp_path: Path) -> None:
    after = copy.deepcopy(reset_by_logic)
    changed = ecp5_reset.resets_to_logic(after["modules"]["top"], smallest=0)
    assert changed > 10 and changed == len(resets_of(reset_by_logic)) - len(resets_of(after))
    (port,) = reset_by_logic["modules"]["top"]["ports"]["reset"]["bits"]
    kept = [bit for bit in resets_of(after) if bit != port]
    assert resets_of(after).count(port) == 3 and len(kept) == 3 and len(set(kept)) == 1, "the one with an enable"
    prove_equal_in_time(reset_by_logic, after, tmp_path)


def test_resets_of_many_registers_and_of_small_designs_stay(reset_by_logic: dict[str, Any]) -> None:
    module = copy.deepcopy(reset_by_logic)["modules"]["top"]
    assert ecp5_reset.resets_to_logic(module) == 0
    assert ecp5_reset.resets_to_logic(module, smallest=0, most_readers=0) == 0
    assert module == reset_by_logic["modules"]["top"]


def test_the_proof_notices_a_wrong_reset(reset_by_logic: dict[str, Any], tmp_path: Path) -> None:
    after = copy.deepcopy(reset_by_logic)
    module = after["modules"]["top"]
    ecp5_reset.resets_to_logic(module, smallest=0)
    wrong = next(cell for name, cell in module["cells"].items() if name.startswith("reset_as_logic_"))
    wrong["parameters"]["INIT"] = "".join("10"[int(bit)] for bit in wrong["parameters"]["INIT"])
    with pytest.raises(FlowError):
        prove_equal_in_time(reset_by_logic, after, tmp_path)
