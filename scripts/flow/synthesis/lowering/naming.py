# SPDX-License-Identifier: Apache-2.0
"""Gives the registers of the netlist the names they have in C++.

The tool drops the names. But the netlist and the clocked C++ core show the same values clock for clock, so a register
is recognised by its trace: the netlist runs in Python on the stimulus with which `stereo_hls trace` traced the core.
Registers of C++ that always agree are as good as one another. Those that never change in the trace, such as a flag that
never rises, may yet differ elsewhere: for them the registers around decide.
The same run compares the outputs: a netlist that differs from the C++ in one bit of one clock never becomes VHDL.
"""

from __future__ import annotations

from itertools import takewhile
from pathlib import Path

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .evaluate import compile_step, initial_state
from .expressions import LONG, bit_not, leaf, walk, wrap
from .netlist import Netlist, Register

_UNNAMED = "other_"  # start of the names of registers that hold nothing of the C++ core
Values = tuple[int, ...]  # one a clock
Trace = dict[str, Values]  # of the inputs ("in_..."), outputs ("out_...") and registers of the C++ core


def read_trace(path: Path) -> Trace:
    """File: "stereo-hls trace 1 config=NAME clocks=N", a line of names, then N lines of hexadecimal values."""
    lines = path.read_text().splitlines()
    if (
        len(lines) < 3
        or not lines[0].startswith("stereo-hls trace 1 ")
        or f"clocks={len(lines) - 2}" not in lines[0].split()
    ):
        raise FlowError(f"{path}: not a complete 'trace' file of format 1", EXIT_TOOL_FAILED)
    names = lines[1].split()
    if len(set(names)) != len(names):
        raise FlowError(f"{path}: two registers or ports have one name", EXIT_TOOL_FAILED)
    rows = [[int(value, 16) for value in line.split()] for line in lines[2:]]
    return dict(zip(names, zip(*rows)))


def trace_netlist(netlist: Netlist, trace: Trace) -> list[Values]:
    """Values of each register of the netlist, in the same clocks; checks the outputs against the trace."""
    step = compile_step(netlist)
    registers, memories = initial_state(netlist)
    history = []
    for clock in range(len(trace["in_valid"])):
        history.append(tuple(registers))
        outputs = step({name: trace[f"in_{name}"][clock] for name in netlist.inputs}, registers, memories)
        for name, value in outputs.items():
            expected = trace[f"out_{name}"][clock]
            if value != expected and (name not in netlist.words or trace[f"out_{netlist.valid}"][clock]):
                raise FlowError(
                    f"the lowered netlist differs from the C++ core: clock {clock}, {name}: expected {expected}, "
                    f"got {value}",
                    EXIT_TOOL_FAILED,
                )
    return list(zip(*history))


def _names_by_values(trace: Trace) -> dict[Values, list[str]]:
    """The registers of the C++ core, in their order."""
    found: dict[Values, list[str]] = {}
    for name, values in trace.items():
        if not name.startswith(("in_", "out_")):
            found.setdefault(values, []).append(name)
    return found


def _packed(trace: Trace) -> dict[str, list[Values]]:
    """The arrays of registers of the C++ core: {name without the index: values of the elements}."""
    arrays: dict[str, list[Values]] = {}
    for name, values in trace.items():
        array, _, index = name.rpartition("_")
        if index.isdigit() and not name.startswith(("in_", "out_")):
            arrays.setdefault(array, []).append(values)
    return arrays


def _packed_name(arrays: dict[str, list[Values]], values: Values, width: int) -> str | None:
    """The array that a register holds as one word, element 0 in the lowest bits."""
    for name, elements in arrays.items():
        bits, rest = divmod(width, len(elements))
        if rest == 0 and all(
            value == sum(element << bits * lane for lane, element in enumerate(lanes))
            for value, lanes in zip(values, zip(*elements))
        ):
            return name
    return None


def adopt_cpp_values(netlist: Netlist, trace: Trace) -> None:
    """Where the tool keeps the complement of a C++ bit, or a negative number as a large positive one, keeps what C++
    has."""
    known = _names_by_values(trace)
    replacement = {}
    for register, values in zip(netlist.registers, trace_netlist(netlist, trace)):
        old, width = register.value, register.value.width
        half = 1 << (width - 1)
        if values in known and not _holds_long_negatives(register):
            continue
        if old.is_bit and tuple(1 - v for v in values) in known:
            register.value, register.initial = leaf("register", f"{register.name}_inverted", 1), 1 - register.initial
            register.next = bit_not(register.next)
            replacement[id(old)] = bit_not(register.value)
        elif old.low == 0 and (
            _holds_long_negatives(register) or tuple(v - 2 * half if v >= half else v for v in values) in known
        ):
            register.value = leaf("register", f"{register.name}_signed", width, signed=True)
            register.next = wrap(register.next, width, signed=True)
            replacement[id(old)] = wrap(register.value, width)
    netlist.substitute(replacement)


def _holds_long_negatives(register: Register) -> bool:
    """It has numbers that no integer of VHDL has, for small negative ones, even if none comes in the trace."""
    old, following = register.value, register.next
    if old.low < 0 or old.high <= LONG or following.op != "wrap":
        return False
    limit = 1 << (old.width - 1)
    return -limit <= following.args[0].low < 0 and following.args[0].high < limit


def _beside(netlist: Netlist) -> dict[int, list[Register]]:
    """{id of a register: the registers that it takes its value from, and those that take theirs from it}"""
    holder = {id(register.value): register for register in netlist.registers}
    beside: dict[int, list[Register]] = {id(register): [] for register in netlist.registers}
    for register in netlist.registers:
        for node in walk([register.next]):
            source = holder.get(id(node))
            if source is not None and source is not register:
                beside[id(register)].append(source)
                beside[id(source)].append(register)
    return beside


def _common_words(one: str, other: str) -> int:
    """How many words two names have in common at their beginnings: 2 for rows_tag_valid and rows_tag_column."""
    pairs = zip(one.split("_"), other.split("_"))
    return len(list(takewhile(lambda pair: pair[0] == pair[1], pairs)))


def _choose(registers: list[Register], names: list[str], beside: dict[int, list[Register]]) -> dict[int, str]:
    """{id of a register: its name} for registers and names that never change, the clearest pair first. A register gets
    none when nothing around it has a name of the same block."""

    def likeness(register: Register, name: str) -> int:
        return sum(_common_words(name, neighbour.name) for neighbour in beside[id(register)])

    chosen: dict[int, str] = {}
    pairs = [
        (likeness(register, name), -place, register, name) for register in registers for place, name in enumerate(names)
    ]
    for score, _, register, name in sorted(pairs, key=lambda pair: pair[:2], reverse=True):
        if score > 0 and id(register) not in chosen and name not in chosen.values():
            chosen[id(register)] = name
    return chosen


def name_registers(netlist: Netlist, trace: Trace) -> None:
    """Renames and orders the registers after the C++ core, and memories after the registers that take their data."""
    names = _names_by_values(trace)
    order = {name: place for place, name in enumerate(trace)}
    arrays = _packed(trace)
    others = 0
    alike: dict[Values, list[Register]] = {}
    history = trace_netlist(netlist, trace)
    for register, values in zip(netlist.registers, history):
        alike.setdefault(values, []).append(register)
    still = [values for values in alike if len(set(values)) == 1]
    chosen = {
        id(register): name
        for values, registers in alike.items()
        if values not in still
        for register, name in zip(registers, names.get(values, []))
    }
    for register in netlist.registers:
        register.name = chosen.get(id(register), "")
    beside = _beside(netlist)
    for values in still:
        chosen |= _choose(alike[values], names.get(values, []), beside)
    for register, values in zip(netlist.registers, history):
        if id(register) in chosen:
            register.name = chosen[id(register)]
        elif array := _packed_name(arrays, values, register.value.width):
            register.name = array
            order[array] = order[f"{array}_0"]
            del arrays[array]
        else:
            register.name = f"{_UNNAMED}{others}"
            order[register.name] = len(order)
            others += 1
    netlist.registers.sort(key=lambda r: order[r.name])
    for memory in netlist.memories:
        reader = next((r.name for r in netlist.registers if memory.data in walk([r.next])), memory.name)
        memory.name = f"{reader}_memory"


def count_named(netlist: Netlist) -> int:
    """How many registers have found their name."""
    return sum(not register.name.startswith(_UNNAMED) for register in netlist.registers)
