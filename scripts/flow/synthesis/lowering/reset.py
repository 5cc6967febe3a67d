# SPDX-License-Identifier: Apache-2.0
"""Which registers a reset must set."""

from __future__ import annotations

from collections.abc import Mapping

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import Node, bit_not, disjoint_ones, walk
from .netlist import Memory, Netlist, Register


def split_hold(register: Register) -> tuple[Node | None, Node]:
    """(condition, value): the register takes value when the condition holds; condition None: always."""
    node = register.next
    if node.op == "mux":
        condition, yes, no = node.args
        if no is register.value:
            return condition, yes
        if yes is register.value:
            return bit_not(condition), no
    return None, node


def memory_read_register(netlist: Netlist, memory: Memory) -> tuple[Register, Node | None]:
    """(register, enable) that takes a memory's data and nothing else does, as a synchronous read port needs it."""
    users = [n for n in walk(netlist.roots()) if memory.data in n.args]
    takers = [r for r in netlist.registers if split_hold(r)[1] is memory.data]
    direct = sum(1 for root in netlist.roots() if root is memory.data)
    if len(takers) != 1 or len(users) + direct != 1:
        raise FlowError(
            f"the read data of memory {memory.name} must go into one register and nowhere else", EXIT_TOOL_FAILED
        )
    return takers[0], split_hold(takers[0])[0]


def control_registers(netlist: Netlist) -> dict[int, Register]:
    """The registers that a reset must set: all that flags, enables and the addresses of counters depend on, through
    memories too.

    The others hold pixels and costs, which no flag announces before new ones have replaced them. So do addresses that
    follow from an input word, as that of a winner's column does: what they write counts no more than the word itself.
    {id of the value: register}
    """
    by_value = {id(r.value): r for r in netlist.registers}
    words = {id(memory_read_register(netlist, m)[0].value): m for m in netlist.memories}
    from_words = _follow_from_words(netlist)
    addresses = [address for m in netlist.memories for address in (m.read_address, m.write_address)]
    frontier = [node for name, node in netlist.outputs.items() if name not in netlist.words]
    frontier += [node for node in addresses if id(node) not in from_words]
    frontier += [c for c in (split_hold(r)[0] for r in netlist.registers) if c is not None]
    found: dict[int, Register] = {}
    known_bits = dict.fromkeys(words, 0)
    while frontier:
        nodes, used = walk(frontier), _used_bits(frontier, words)
        frontier = []
        for key in dict.fromkeys(id(node) for node in nodes):
            if key in by_value and key not in words and key not in found:
                found[key] = by_value[key]
                frontier.append(by_value[key].next)
        for key, bits in used.items():
            frontier += _parts(words[key].write_data, bits & ~known_bits[key])
            if bits & ~known_bits[key]:
                frontier += [words[key].read_address, words[key].write_address]
            known_bits[key] |= bits
    return found


def _follow_from_words(netlist: Netlist) -> set[int]:
    """The values that an input of more than one bit reaches, through registers and memories. {id} Not those of a size
    that is held: the counters of columns follow from it."""
    reached = {id(node) for name, node in netlist.inputs.items() if node.high > 1 and name not in netlist.held}
    steps = [(r.value, [r.next]) for r in netlist.registers]
    steps += [(m.data, [m.read_address, m.write_address, m.write_data]) for m in netlist.memories]
    waiting = [(value, {id(node) for node in walk(roots)}) for value, roots in steps]
    while reaching := [value for value, cone in waiting if not cone.isdisjoint(reached)]:
        reached.update(id(value) for value in reaching)
        waiting = [(value, cone) for value, cone in waiting if id(value) not in reached]
    return reached


def _used_bits(roots: list[Node], words: Mapping[int, Memory]) -> dict[int, int]:
    """{id of a memory's word: mask of its bits that the expressions depend on}"""
    used: dict[int, int] = {}

    def use(key: int, bits: int) -> None:
        used[key] = used.get(key, 0) | bits

    for root in roots:
        word, low = (root.args[0], root.number) if root.op == "shr" else (root, 0)
        if id(word) in words:
            use(id(word), -1 << low)
    for node in walk(roots):
        for argument in node.args:
            shifted = argument.op == "shr" and id(argument.args[0]) in words
            word, low = (argument.args[0], argument.number) if shifted else (argument, 0)
            if id(word) not in words or (node.op == "shr" and not shifted):
                continue  # no word, or the shift that the next user looks through
            use(id(word), ((1 << node.wrapping[0]) - 1) << low if node.op == "wrap" else -1 << low)
    return used


def _parts(word: Node, bits: int) -> list[Node]:
    """The parts of a concatenation that hold some of the bits; the whole word where it is none."""
    if word.op == "add" and disjoint_ones(word.args) is not None:
        return [part for part in word.args if part.ones is not None and part.ones & bits]
    return [word] if bits else []
