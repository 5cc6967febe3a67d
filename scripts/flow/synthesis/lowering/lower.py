# SPDX-License-Identifier: Apache-2.0
"""Turns the tool's instances into a netlist of expressions, registers and memories.

Control signals are leaves of the operation `control` in it, until the pass of control.py takes them away.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from ...base import rtl
from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .control import startup_and_loop
from .expressions import Node, add, const, is_const, leaf, mux, shift_left, shift_right, wrap
from .netlist import Memory, Netlist, Register
from .rules import Cell, apply_rule
from .vhdl_reader import Actual, Design, Instance, Part, Signal

REGISTERS = ("register_SE", "register_STD")
MEMORY = "ARRAY_1D_STD_DISTRAM_NN_SDS"
READ_PORT = re.compile(r"(\w+)_bambu_artificial_ParmMgr_Read_none_modgen")
WRITE_PORT = re.compile(r"(\w+)_bambu_artificial_ParmMgr_Write_none_modgen")
# A signal, a part of it, or either one converted.
_REFERENCE = re.compile(r"(?:(std_logic_vector|unsigned|signed)\()?(\w+|\\[^\\]+\\)(?:\((\d+)(?: downto (\d+))?\))?\)?")


def lower(design: Design, kind: rtl.Kind = rtl.CORE, port_bits: Mapping[str, int] | None = None) -> Netlist:
    """`port_bits`: {input: its bits} of those that may have fewer than the tool's, which are as wide as a C++ type."""
    return _Lowering(design, kind, port_bits or {}).netlist()


class _Lowering:
    def __init__(self, design: Design, kind: rtl.Kind, port_bits: Mapping[str, int]) -> None:
        self.design, self.kind, self.port_bits = design, kind, port_bits
        self.drivers = {}  # signal -> instance that drives it
        for instance in design.instances:
            driven = instance.ports.get("out1")
            if isinstance(driven, str):
                self.drivers[_bare(driven)] = instance
        self.values: dict[str, Node] = {}  # of signals
        self.inputs: dict[str, Node] = {}

    def netlist(self) -> Netlist:
        registers = [(self._declared_register(i), i) for i in self.design.instances if i.kind in REGISTERS]
        memories = [(self._declared_memory(i), i) for i in self.design.instances if i.kind == MEMORY]
        for register, instance in registers:
            self._connect_register(register, instance)
        for memory, instance in memories:
            self._connect_memory(memory, instance)
        outputs = {}
        for instance in self.design.instances:
            port = WRITE_PORT.fullmatch(instance.kind)
            if port:
                outputs[port.group(1)] = self.actual(instance.ports["in2"])
        return Netlist(
            self.inputs,
            outputs,
            [register for register, _ in registers],
            [memory for memory, _ in memories],
            self.kind.words,
            self.kind.valid,
            self.kind.held,
        )

    # --- expressions --------------------------------------------------------------------------------------------------

    def actual(self, actual: Actual) -> Node:
        """The value of what is connected to a port: a signal, a converted signal, a literal, or several in parts."""
        if not isinstance(actual, str):
            return add(*[shift_left(self.actual(part), low) for _, low, part in actual])
        if re.fullmatch(r"'[01]'|\"[01]+\"", actual):
            return const(int(actual.strip("'\""), 2))
        conversion, name, high, low = _reference(actual).groups()
        value, width, signed = self.signal(_bare(name)), self._signal(name).width, self._signal(name).signed
        if high is not None:
            lowest = int(low or high)
            value, width, signed = shift_right(value, lowest), int(high) - lowest + 1, False
        return wrap(value, width, signed if conversion is None else conversion == "signed")

    def _signal(self, name: str) -> Signal:
        signal = self.design.signals.get(_bare(name))
        if signal is None:
            raise FlowError(f"the tool's VHDL uses an undeclared signal {name}", EXIT_TOOL_FAILED)
        return signal

    def signal(self, name: str) -> Node:
        """The value of a signal; walks back through its drivers without recursion, as chains can be long."""
        stack = [name]
        while stack:
            top = stack[-1]
            if top in self.values:
                stack.pop()
                continue
            missing = [s for s in self._sources(top) if s not in self.values]
            if missing:
                stack.extend(missing)
            else:
                self.values[top] = self._compute(top)
                stack.pop()
        return self.values[name]

    def _sources(self, name: str) -> list[str]:
        instance = self.drivers.get(name)
        if instance is None or READ_PORT.fullmatch(instance.kind):
            return []
        actuals: list[str] = []
        for actual in _inputs(instance).values():
            actuals += [actual] if isinstance(actual, str) else [part for _, _, part in actual]
        return [_bare(_reference(actual).group(2)) for actual in actuals if actual[0] not in "'\""]

    def _compute(self, name: str) -> Node:
        signal = self._signal(name)
        instance = self.drivers.get(name)
        if instance is None:
            if name not in self.design.states[self.design.reset_state].outputs:
                raise FlowError(f"nothing drives signal {name} of the tool's VHDL", EXIT_TOOL_FAILED)
            return leaf("control", name, 1)
        port = READ_PORT.fullmatch(instance.kind)
        if port:
            input_name = port.group(1)
            width = min(signal.width, self.port_bits.get(input_name, signal.width))
            return self.inputs.setdefault(input_name, leaf("input", input_name, width, signal.signed))
        if instance.kind == "constant_value":
            return const(_constant(instance))
        inputs = {port: self.actual(actual) for port, actual in _inputs(instance).items()}
        result = apply_rule(Cell(instance.kind, instance.generics, inputs, instance.name))
        return wrap(result, signal.width, signal.signed)

    # --- registers and memories ---------------------------------------------------------------------------------------

    def _declared_register(self, instance: Instance) -> Register:
        name = _bare(_whole(instance, "out1"))
        signal = self._signal(name)
        self.values[name] = leaf("register", name, signal.width, signal.signed)
        return Register(name, self.values[name])

    def _connect_register(self, register: Register, instance: Instance) -> None:
        register.next = self.actual(instance.ports["in1"])
        if instance.kind == "register_SE":
            register.next = mux(self.actual(instance.ports["wenable"]), register.next, register.value)

    def _declared_memory(self, instance: Instance) -> Memory:
        depth, width = int(instance.generics["n_elements"]), int(instance.generics["data_size"])
        data = leaf("memory", instance.name, width)
        for high, low, actual in _parts(instance, "out1"):
            name = _bare(actual)
            if not name.startswith("null_"):
                self.values[name] = wrap(data, high - low + 1)
        return Memory(instance.name, depth, width, data)

    def _connect_memory(self, memory: Memory, instance: Instance) -> None:
        """The port that loads and the port that stores in the loop state; addresses count bytes from a base that is a
        multiple of the memory's size, so the base falls away."""
        byte_shift = (int(instance.generics["ALIGNMENT"]) // 8).bit_length() - 1
        loads = self._active_ports(instance, "sel_LOAD", "in4r")
        stores = self._active_ports(instance, "sel_STORE", "in4w")
        if len(loads) != 1 or len(stores) != 1:
            raise FlowError(
                f"memory {memory.name} has {len(loads)} reads and {len(stores)} writes a clock, not one each",
                EXIT_TOOL_FAILED,
            )
        address_bits = (memory.depth - 1).bit_length()

        def word_address(port: str, number: int) -> Node:
            return wrap(shift_right(self._part(instance, port, number), byte_shift), address_bits)

        memory.read_address = word_address("in2r", loads[0])
        memory.write_address = word_address("in2w", stores[0])
        memory.write_data = wrap(self._part(instance, "in1", stores[0]), memory.width)

    def _active_ports(self, instance: Instance, select: str, enable: str) -> list[int]:
        _, loop = startup_and_loop(self.design)
        active = []
        for number in range(int(instance.generics[f"PORTSIZE_{select}"])):
            control = _bare(_part_text(instance, select, number))
            if loop.outputs.get(control) and is_const(self._part(instance, enable, number), 1):
                active.append(number)
        return active

    def _part(self, instance: Instance, port: str, number: int) -> Node:
        return self.actual(_part_text(instance, port, number))


# --- ports of an instance ---------------------------------------------------------------------------------------------


def _inputs(instance: Instance) -> dict[str, Actual]:
    return {port: actual for port, actual in instance.ports.items() if port.startswith(("in", "sel"))}


def _whole(instance: Instance, port: str) -> str:
    actual = instance.ports[port]
    if not isinstance(actual, str):
        raise FlowError(f"port {port} of instance {instance.name} is connected in parts", EXIT_TOOL_FAILED)
    return actual


def _parts(instance: Instance, port: str) -> list[Part]:
    actual = instance.ports[port]
    if isinstance(actual, str):
        raise FlowError(f"port {port} of instance {instance.name} is not connected in parts", EXIT_TOOL_FAILED)
    return actual


def _part_text(instance: Instance, port: str, number: int) -> str:
    """The actual of element `number` of a port that holds several."""
    return sorted(_parts(instance, port), key=lambda part: part[1])[number][2]


def _reference(actual: str) -> re.Match[str]:
    """The groups of _REFERENCE in what is connected to a port."""
    match = _REFERENCE.fullmatch(actual)
    if match is None:
        raise FlowError(f"the tool's VHDL connects '{actual}', which is no signal and no part of one", EXIT_TOOL_FAILED)
    return match


def _bare(text: str) -> str:
    return text.strip().strip("\\")


def _constant(instance: Instance) -> int:
    """A literal, or the base address of a memory, which counts as 0."""
    text = instance.generics["value"]
    literal = re.fullmatch(r'"([01]+)"', text)
    if literal:
        return int(literal.group(1), 2)
    if re.search(r"\bMEM_var_\w+", text):
        return 0
    raise FlowError(f"constant {instance.name} has an unknown value {text}", EXIT_TOOL_FAILED)
