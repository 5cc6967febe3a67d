# SPDX-License-Identifier: Apache-2.0
"""Designs whose line memories are left out: what a memory reads is an input, what it is asked and given are outputs.

As long as two versions ask and give their memories the same, they read the same. So versions that show the same
outputs, these among them, for all that such inputs may be, are the same with their memories. A graph has thousands of
registers less then: most of a semi-global core are the words of its rows."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

from ..base.aiger import Opened

READ, ASKED = "any_word", ("asked_to_read", "asked_at", "given_at", "given")
OPENED = Opened(f"w:*.{READ}", " ".join(f"w:*.{name}" for name in ASKED))
_MODULE = re.compile(r"^module (line_memory\w*)\s*\((.*?)\);.*?^endmodule\n", re.MULTILINE | re.DOTALL)
_BIT = re.compile(rf"^(.+)\.({'|'.join((READ, *ASKED))})(?:\[(\d+)\])?$")


def opened(verilog: str) -> str:
    """GHDL's Verilog of a design, with wires in each of its line memories that become inputs and outputs. Where a
    memory is not read, its address does not count."""

    def module(match: re.Match[str]) -> str:
        name, ports = match.groups()
        widths = {port: width for width, port in re.findall(r"\[(\d+):0\] (\w+)", ports)}
        data, address = widths["write_data"], widths["read_address"]
        to_read, at, given_at, given = ASKED
        return "\n".join(
            [
                f"module {name} ({ports});",
                f"wire [{data}:0] {READ};",
                f"reg [{data}:0] word = 0;",
                f"always @(posedge clock) if (read_enable) word <= {READ};",
                "assign read_data = word;",
                f"wire {to_read} = read_enable;",
                f"wire [{address}:0] {at} = read_enable ? read_address : 0;",
                f"wire [{address}:0] {given_at} = write_address;",
                f"wire [{data}:0] {given} = write_data;",
                "endmodule\n",
            ]
        )

    return _MODULE.sub(module, verilog)


@dataclass
class Memory:
    """Numbers of a graph's inputs and outputs, lowest bits first."""

    read: list[int] = field(default_factory=list)  # inputs; all others are outputs
    asked_to_read: list[int] = field(default_factory=list)
    asked_at: list[int] = field(default_factory=list)
    given_at: list[int] = field(default_factory=list)
    given: list[int] = field(default_factory=list)

    @property
    def bits(self) -> int:
        """At most: a memory may have fewer words than addresses."""
        return len(self.given) << len(self.given_at)


def memories(inputs: Iterable[str], outputs: Iterable[str]) -> list[Memory]:
    """Those of a graph with such names."""
    bits: dict[tuple[str, str], dict[int, int]] = {}
    for names in (inputs, outputs):
        for number, name in enumerate(names):
            if match := _BIT.match(name):
                memory, word, bit = match.groups()
                bits.setdefault((memory, "read" if word == READ else word), {})[int(bit or 0)] = number
    found: dict[str, Memory] = {}
    for (memory, word), numbers in bits.items():
        getattr(found.setdefault(memory, Memory()), word).extend(number for _, number in sorted(numbers.items()))
    return list(found.values())
