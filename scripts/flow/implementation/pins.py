# SPDX-License-Identifier: Apache-2.0
"""Registers around a core that has more ports than a device has pins: clock, scan_in and scan_out are enough.

A shift register feeds the inputs; the outputs go into registers, and from there into a shift register that adds them
up. So all paths of the core stand between registers, as in a design that holds it, and none of it falls away.
"""

from __future__ import annotations

import re

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from .families.family import TOP

ENTITY = "stereo_pins"
CORE = "core"  # the instance
CLOCKS = ("clock", "aclk")


def around(verilog: str) -> str:
    """The module with the three pins, for Verilog of `ghdl --synth` whose top is TOP."""
    head = re.search(rf"\bmodule {TOP}\s*\((.*?)\);", verilog, re.DOTALL)
    declared = re.findall(r"(input|output)\s+(?:\[(\d+):0\]\s+)?(\w+)", head[1]) if head else []
    ports = [(direction, int(high or 0) + 1, name) for direction, high, name in declared]
    clock = next((name for _, _, name in ports if name in CLOCKS), None)
    sides = {side: [(n, w) for d, w, n in ports if d == side and n != clock] for side in ("input", "output")}
    if clock is None or not all(sides.values()):
        raise FlowError(f"the Verilog of {TOP} has no clock, inputs and outputs", EXIT_TOOL_FAILED)
    inputs, outputs = (sum(width for _, width in side) for side in sides.values())
    connections = [f".{clock}(clock)", *_slices(sides["input"], "given"), *_slices(sides["output"], "taken")]
    return f"""
module {ENTITY} (input clock, input scan_in, output scan_out);
  reg [{inputs - 1}:0] given;
  wire [{outputs - 1}:0] taken;
  reg [{outputs - 1}:0] held, added;
  always @(posedge clock) begin
    given <= {{given, scan_in}};
    held <= taken;
    added <= {{added, 1'b0}} ^ held;
  end
  assign scan_out = added[{outputs - 1}];
  {TOP} {CORE} (
    {f",{chr(10)}    ".join(connections)});
endmodule
"""


def _slices(ports: list[tuple[str, int]], register: str) -> list[str]:
    found, low = [], 0
    for name, width in ports:
        found.append(f".{name}({register}[{low + width - 1}:{low}])")
        low += width
    return found
