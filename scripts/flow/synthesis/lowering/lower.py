# SPDX-License-Identifier: Apache-2.0
"""Turns the tool's instances and states into a netlist of expressions, registers and memories without any control.

The core is one loop in one state that runs forever, after start-up states that load the first values of the registers. So
the controller is played through here: what the start-up states load becomes the registers' initial values, and the
registers' next values are those of the loop state. Nothing of the controller is left.
"""

import re

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import add, const, is_const, leaf, mux, rebuild, shift_left, shift_right, wrap
from .netlist import Memory, Netlist, Register, remove_unused
from .rules import Cell, apply_rule

REGISTERS = ("register_SE", "register_STD")
MEMORY = "ARRAY_1D_STD_DISTRAM_NN_SDS"
READ_PORT = re.compile(r"(\w+)_bambu_artificial_ParmMgr_Read_none_modgen")
WRITE_PORT = re.compile(r"(\w+)_bambu_artificial_ParmMgr_Write_none_modgen")
# A signal, a part of it, or either one converted.
_REFERENCE = re.compile(r"(?:(std_logic_vector|unsigned|signed)\()?(\w+|\\[^\\]+\\)(?:\((\d+)(?: downto (\d+))?\))?\)?")


def state_sequence(design):
    """(states that are passed once, states of the endless loop), in order."""
    names = [design.reset_state]
    while design.states[names[-1]].next not in names:
        names.append(design.states[names[-1]].next)
    first = names.index(design.states[names[-1]].next)
    states = [design.states[name] for name in names]
    return states[:first], states[first:]


def lower(design):
    return _Lowering(design).netlist()


class _Lowering:
    def __init__(self, design):
        self.design = design
        self.drivers = {}  # signal -> instance that drives it
        for instance in design.instances:
            for port, actual in instance.ports.items():
                if port in ("out1",) and isinstance(actual, str):
                    self.drivers[_bare(actual)] = instance
        self.values = {}  # signal -> Node
        self.controls = {}  # control signal -> leaf
        self.inputs, self.registers, self.memories, self.writes = {}, [], [], []

    def netlist(self):
        registers = [i for i in self.design.instances if i.kind in REGISTERS]
        for instance in registers:
            self._declare_register(instance)
        for instance in self.design.instances:
            if instance.kind == MEMORY:
                self._declare_memory(instance)
        for instance in registers:
            self._connect_register(instance)
        for number, instance in enumerate(i for i in self.design.instances if i.kind == MEMORY):
            self._connect_memory(self.memories[number], instance)
        outputs = {}
        for instance in self.design.instances:
            match = WRITE_PORT.fullmatch(instance.kind)
            if match:
                outputs[match.group(1)] = self.actual(instance.ports["in2"])
        return self._without_control(outputs)

    # --- expressions --------------------------------------------------------------------------------------------------

    def actual(self, text):
        """The value of what is connected to a port: a signal, a converted signal or a literal."""
        if isinstance(text, list):
            return self._sliced(text)
        if re.fullmatch(r"'[01]'|\"[01]+\"", text):
            return const(int(text.strip("'\""), 2))
        conversion, name, high, low = _REFERENCE.fullmatch(text).groups()
        value, width, signed = self.signal(_bare(name)), self._signal(name).width, self._signal(name).signed
        if high is not None:
            low = int(low or high)
            value, width, signed = shift_right(value, low), int(high) - low + 1, False
        return wrap(value, width, signed if conversion is None else conversion == "signed")

    def _sliced(self, slices):
        return add(*[shift_left(self.actual(actual), low) for _, low, actual in slices])

    def _signal(self, name):
        signal = self.design.signals.get(_bare(name))
        if signal is None:
            raise FlowError(f"the tool's VHDL uses an undeclared signal {name}", EXIT_TOOL_FAILED)
        return signal

    def signal(self, name):
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

    def _sources(self, name):
        instance = self.drivers.get(name)
        if instance is None or READ_PORT.fullmatch(instance.kind):
            return []
        actuals = []
        for port, actual in instance.ports.items():
            if port.startswith(("in", "sel")):
                actuals += [a for _, _, a in actual] if isinstance(actual, list) else [actual]
        references = (_REFERENCE.fullmatch(a) for a in actuals if a[0] not in "'\"")
        return [_bare(reference.group(2)) for reference in references]

    def _compute(self, name):
        signal = self._signal(name)
        instance = self.drivers.get(name)
        if instance is None:
            if name not in self.design.states[self.design.reset_state].outputs:
                raise FlowError(f"nothing drives signal {name} of the tool's VHDL", EXIT_TOOL_FAILED)
            return self.controls.setdefault(name, leaf("control", name, 1))
        port = READ_PORT.fullmatch(instance.kind)
        if port:
            return self.inputs.setdefault(port.group(1), leaf("input", port.group(1), signal.width, signal.signed))
        if instance.kind == "constant_value":
            return const(_constant(instance))
        inputs = {p: self.actual(a) for p, a in instance.ports.items() if p.startswith(("in", "sel"))}
        result = apply_rule(Cell(instance.kind, instance.generics, inputs, instance.name))
        return wrap(result, signal.width, signal.signed)

    # --- registers and memories ---------------------------------------------------------------------------------------

    def _declare_register(self, instance):
        name = _bare(instance.ports["out1"])
        signal = self._signal(name)
        self.values[name] = leaf("register", name, signal.width, signal.signed)
        self.registers.append(Register(name, self.values[name]))

    def _connect_register(self, instance):
        register = next(r for r in self.registers if r.name == _bare(instance.ports["out1"]))
        register.next = self.actual(instance.ports["in1"])
        if instance.kind == "register_SE":
            register.next = mux(self.actual(instance.ports["wenable"]), register.next, register.value)

    def _declare_memory(self, instance):
        depth, width = int(instance.generics["n_elements"]), int(instance.generics["data_size"])
        data = leaf("memory", instance.name, width)
        for high, low, actual in instance.ports["out1"]:
            name = _bare(actual)
            if not name.startswith("null_"):
                self.values[name] = wrap(data, high - low + 1)
        self.memories.append(Memory(instance.name, depth, width, data))

    def _connect_memory(self, memory, instance):
        """The port that loads and the port that stores in the loop state; addresses count bytes from a base that is a multiple
        of the memory's size, so the base falls away."""
        byte_shift = (int(instance.generics["ALIGNMENT"]) // 8).bit_length() - 1
        loads = self._active_ports(instance, "sel_LOAD", "in4r")
        stores = self._active_ports(instance, "sel_STORE", "in4w")
        if len(loads) != 1 or len(stores) != 1:
            raise FlowError(
                f"memory {memory.name} has {len(loads)} reads and {len(stores)} writes a clock, not one each",
                EXIT_TOOL_FAILED,
            )
        address_bits = (memory.depth - 1).bit_length()

        def word_address(port, number):
            return wrap(shift_right(self._port_part(instance, port, number), byte_shift), address_bits)

        memory.read_address = word_address("in2r", loads[0])
        memory.write_address = word_address("in2w", stores[0])
        memory.write_data = wrap(self._port_part(instance, "in1", stores[0]), memory.width)

    def _active_ports(self, instance, select, enable):
        loop = self._loop_state().outputs
        active = []
        for number in range(int(instance.generics[f"PORTSIZE_{select}"])):
            control = _bare(self._slice(instance, select, number))
            if loop.get(control) and is_const(self._port_part(instance, enable, number), 1):
                active.append(number)
        return active

    @staticmethod
    def _slice(instance, port, number):
        """The actual of element `number` of a port that holds several."""
        slices = sorted(instance.ports[port], key=lambda part: part[1])
        return slices[number][2]

    def _port_part(self, instance, port, number):
        return self.actual(self._slice(instance, port, number))

    # --- control ------------------------------------------------------------------------------------------------------

    def _startup(self):
        """The start-up states in order, and the loop state that follows itself."""
        startup, loop = state_sequence(self.design)
        if len(loop) != 1:
            raise FlowError(
                f"the loop takes {len(loop)} states, not one: look for array_ref_*.mem files, they betray arrays in memory",
                EXIT_TOOL_FAILED,
            )
        return startup, loop[0]

    def _loop_state(self):
        return self._startup()[1]

    def _in_state(self, state, known):
        """A function that gives a node its form in a state: controls are constants, and so are registers in `known`."""
        replacement = {id(node): const(state.outputs[name]) for name, node in self.controls.items()}
        replacement.update(known)
        done = {}
        return lambda node: rebuild(node, replacement, done)

    def _without_control(self, outputs):
        startup, loop = self._startup()
        known = {}
        for state in startup:
            form = self._in_state(state, known)
            values = {id(r.value): form(r.next) for r in self.registers}
            known = {key: value for key, value in values.items() if is_const(value)}
        form = self._in_state(loop, {})
        result = Netlist(dict(self.inputs), {name: form(node) for name, node in outputs.items()}, [], self.memories)
        constants = {}
        for register in self.registers:
            register.next = form(register.next)
            register.initial = known[id(register.value)].param if id(register.value) in known else 0
            if register.next is register.value:
                constants[id(register.value)] = const(register.initial)
            else:
                result.registers.append(register)
        for memory in self.memories:
            memory.read_address, memory.write_address = form(memory.read_address), form(memory.write_address)
            memory.write_data = form(memory.write_data)
        result.substitute(constants)
        for memory in self.memories:
            bits = (memory.depth - 1).bit_length()
            memory.read_address, memory.write_address = (
                wrap(memory.read_address, bits),
                wrap(memory.write_address, bits),
            )
        remove_unused(result)
        return result


def _bare(text):
    return text.strip().strip("\\")


def _constant(instance):
    """A literal, or the base address of a memory, which counts as 0."""
    text = instance.generics["value"]
    literal = re.fullmatch(r'"([01]+)"', text)
    if literal:
        return int(literal.group(1), 2)
    if re.search(r"\bMEM_var_\w+", text):
        return 0
    raise FlowError(f"constant {instance.name} has an unknown value {text}", EXIT_TOOL_FAILED)
