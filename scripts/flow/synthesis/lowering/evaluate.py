# SPDX-License-Identifier: Apache-2.0
"""Runs a netlist in Python, clock by clock: the check and the traces that naming needs, before any VHDL exists."""

from collections.abc import Callable, Iterable, Mapping

from .expressions import Node, walk
from .netlist import Netlist

_TEXT = {
    "sub": "({0} - {1})",
    "abs": "abs({0})",
    "folded": "({0} if {0} >= 0 else -1 - {0})",
    "positive": "max({0}, 0)",
    "mux": "({1} if {0} else {2})",
    "lt": "int({0} < {1})",
    "ge": "int({0} >= {1})",
    "eq": "int({0} == {1})",
    "ne": "int({0} != {1})",
    "not": "(1 - {0})",
    "shl": "({0} << {p})",
    "shr": "({0} >> {p})",
}
_JOIN = {"add": " + ", "mul": " * ", "and": " & ", "or": " | ", "xor": " ^ "}


def _text(node: Node, names: Mapping[int, str]) -> str:
    arguments = [names[id(a)] for a in node.args]
    if node.op == "const":
        return str(node.param)
    if node.op == "wrap":
        width, signed = node.wrapping
        half = 1 << (width - 1)
        mask = (1 << width) - 1
        return f"((({arguments[0]} + {half}) & {mask}) - {half})" if signed else f"({arguments[0]} & {mask})"
    if node.op in _JOIN:
        return f"({_JOIN[node.op].join(arguments)})"
    return _TEXT[node.op].format(*arguments, p=node.param)


# (inputs, registers, memories) -> outputs. Updates registers and memories in place; the outputs are those before the
# edge.
Step = Callable[[Mapping[str, int], list[int], list[list[int]]], dict[str, int]]


def compile_step(netlist: Netlist) -> Step:
    """One clock of the netlist."""
    lines = ["def step(inputs, registers, memories):"]
    names: dict[int, str] = {}
    for name, node in netlist.inputs.items():
        names[id(node)] = f"i_{name}"
        lines.append(f" i_{name} = inputs['{name}']")
    for number, register in enumerate(netlist.registers):
        names[id(register.value)] = f"r{number}"
    if netlist.registers:
        lines.append(f" ({', '.join(f'r{n}' for n in range(len(netlist.registers)))},) = registers")

    def compute(roots: Iterable[Node]) -> None:
        for node in walk(roots):
            if id(node) not in names:
                names[id(node)] = f"n{len(names)}"
                lines.append(f" {names[id(node)]} = {_text(node, names)}")

    compute([m.read_address for m in netlist.memories])
    for number, memory in enumerate(netlist.memories):
        names[id(memory.data)] = f"d{number}"
        lines.append(f" d{number} = memories[{number}][{names[id(memory.read_address)]}]")
    compute(netlist.roots())
    for number, memory in enumerate(netlist.memories):
        lines.append(f" memories[{number}][{names[id(memory.write_address)]}] = {names[id(memory.write_data)]}")
    lines.append(
        f" registers[:] = ({', '.join(names[id(r.next)] for r in netlist.registers)}{',' if netlist.registers else ''})"
    )
    lines.append(f" return {{{', '.join(f'{n!r}: {names[id(node)]}' for n, node in netlist.outputs.items())}}}")
    scope: dict[str, Step] = {}
    exec("\n".join(lines), scope)  # the text is ours, made from the netlist above
    return scope["step"]


def initial_state(netlist: Netlist) -> tuple[list[int], list[list[int]]]:
    """(registers, memories)"""
    return [r.initial for r in netlist.registers], [[0] * m.depth for m in netlist.memories]
