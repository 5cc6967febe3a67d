# SPDX-License-Identifier: Apache-2.0
"""The pass that takes the controller away.

The core is one loop in one state that runs forever, after start-up states that load the first values of the registers.
So the controller is played through here: what the start-up states load becomes the registers' initial values, and the
registers' next values are those of the loop state, in which every control signal is a constant.
"""

from collections.abc import Mapping

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import Node, const, is_const, rebuild, walk, wrap
from .netlist import Netlist
from .vhdl_reader import Design, State


def state_sequence(design: Design) -> tuple[list[State], list[State]]:
    """(states that are passed once, states of the endless loop), in order."""
    names = [design.reset_state]
    while design.states[names[-1]].next not in names:
        names.append(design.states[names[-1]].next)
    first = names.index(design.states[names[-1]].next)
    states = [design.states[name] for name in names]
    return states[:first], states[first:]


def startup_and_loop(design: Design) -> tuple[list[State], State]:
    """The start-up states in order, and the loop state that follows itself."""
    startup, loop = state_sequence(design)
    if len(loop) != 1:
        raise FlowError(
            f"the loop takes {len(loop)} states, not one: look for array_ref_*.mem files, they betray arrays in memory",
            EXIT_TOOL_FAILED,
        )
    return startup, loop[0]


class _InState:
    """What nodes are in a state: its control signals are constants, and so are the registers in `known`."""

    def __init__(self, state: State, controls: list[Node], known: Mapping[int, Node]) -> None:
        self._replacement = {id(node): const(state.outputs[str(node.param)]) for node in controls} | dict(known)
        self._done: dict[int, Node] = {}

    def form(self, node: Node) -> Node:
        return rebuild(node, self._replacement, self._done)


def remove_control(netlist: Netlist, design: Design) -> None:
    startup, loop = startup_and_loop(design)
    controls = [node for node in walk(netlist.roots()) if node.op == "control"]
    known: dict[int, Node] = {}
    for state in startup:
        now = _InState(state, controls, known)
        values = {id(r.value): now.form(r.next) for r in netlist.registers}
        known = {key: value for key, value in values.items() if is_const(value)}
    now = _InState(loop, controls, {})
    netlist.outputs = {name: now.form(node) for name, node in netlist.outputs.items()}
    for register in netlist.registers:
        register.next = now.form(register.next)
        register.initial = known[id(register.value)].number if id(register.value) in known else 0
    for memory in netlist.memories:
        memory.read_address, memory.write_address = now.form(memory.read_address), now.form(memory.write_address)
        memory.write_data = now.form(memory.write_data)
    # A register that the loop never writes is a constant.
    constants = {id(r.value): const(r.initial) for r in netlist.registers if r.next is r.value}
    netlist.registers = [r for r in netlist.registers if r.next is not r.value]
    netlist.substitute(constants)
    for memory in netlist.memories:
        bits = (memory.depth - 1).bit_length()
        memory.read_address = wrap(memory.read_address, bits)
        memory.write_address = wrap(memory.write_address, bits)
