# SPDX-License-Identifier: Apache-2.0
"""Who reads a leaf, and how much of it; the pass that drops the bits of registers that nobody reads."""

from __future__ import annotations

from typing import Optional

from .expressions import Node, leaf, walk, wrap
from .netlist import Netlist

Readers = dict[int, list[Optional[Node]]]  # of a leaf's id: the expressions around it, None where it stands alone


def readers_of(netlist: Netlist) -> Readers:
    found: Readers = {}
    for root in netlist.roots():
        found.setdefault(id(root), []).append(None)
    for node in walk(netlist.roots()):
        for argument in node.args:
            found.setdefault(id(argument), []).append(node)
    return found


def read_width(readers: Readers, value: Node) -> int | None:
    """How many of the lowest bits of a leaf are read; None where it is read whole."""
    widths = [
        node.wrapping[0] if node is not None and node.op == "wrap" and not node.wrapping[1] else None
        for node in readers.get(id(value), [None])
    ]
    return None if None in widths else max(width for width in widths if width is not None)


def narrow_to_read_bits(netlist: Netlist) -> None:
    """Drops the upper bits of registers that nobody reads."""
    readers = readers_of(netlist)
    replacement = {}
    for register in netlist.registers:
        width = read_width(readers, register.value)
        if width is not None and register.value.low >= 0 and width < register.value.width:
            old = register.value
            register.value, register.initial = leaf("register", register.name, width), register.initial % (1 << width)
            register.next = wrap(register.next, width)
            replacement[id(old)] = register.value
    netlist.substitute(replacement)
