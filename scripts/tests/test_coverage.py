# SPDX-License-Identifier: Apache-2.0
"""Which bits of registers are proved to stay as they are, and what the default stream moves."""

import json

from conftest import need
from flow.cosim import coverage
from flow_commands import call

# `low` takes its two lower bits from a port, `count` ends at 5, `late` is set once and for ever, behind a reset. One
# bit of `ring` is set, so `both` stays: only the states that can be reached show that.
TOY = """\
module toy (
  input  clock,
  input  reset,
  input  [1:0] from,
  output [3:0] shown);
  reg [3:0] low;
  reg [3:0] count;
  reg late;
  reg [2:0] ring;
  reg both;
  assign shown = low ^ count;
  always @(posedge clock) begin
    low <= reset ? 4'b0000 : {2'b00, from};
    count <= reset ? 4'b0000 : count == 5 ? 4'b0101 : count + 1;
    ring <= reset ? 3'b001 : from == 0 ? {ring[1:0], ring[2]} : ring;
    both <= reset ? 1'b0 : both | (ring[0] & ring[1]);
    late <= reset ? 1'b0 : late | (count == 5);
  end
endmodule
"""


def test_bits_that_cannot_move_are_proved_and_no_others(tmp_path):
    need("yosys-abc", "YOSYS_ABC")
    bits = [f"{name}[{bit}]" for name in ("low", "count") for bit in range(4)] + ["late", "both"]
    proved = coverage._that_stay(TOY, "toy", bits, tmp_path)
    assert proved == {"low[2]", "low[3]", "count[3]", "both"}


def test_without_a_bit_nothing_is_asked(tmp_path):
    assert coverage._that_stay(TOY, "toy", [], tmp_path) == set()
    assert not list(tmp_path.iterdir())


def test_the_default_stream_moves_what_can_move(ghdl, tmp_path):
    need("verilator", "VERILATOR")
    need("yosys-abc", "YOSYS_ABC")
    result = call("cosim.py", "--config", "tiny", "--coverage", "--out", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    found = json.loads((tmp_path / "out" / "coverage.json").read_text())
    assert found["register_bits"] > 1000
    assert found["never_moved"] == []
    assert found["never_both_ways"] == []
