# SPDX-License-Identifier: Apache-2.0
"""Gives the registers of the netlist the names they have in C++.

The tool drops the names. But the netlist and the clocked C++ core show the same values clock for clock, so a register is
recognised by its trace: the netlist runs in Python on the stimulus with which `stereo_hls trace` traced the core. The
same run compares the outputs: a netlist that differs from the C++ in one bit of one clock never becomes VHDL.
"""

from pathlib import Path

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .evaluate import compile_step, initial_state
from .expressions import bit_not, leaf, walk, wrap
from .netlist import merge_twins


def read_trace(path):
    """{name: values}, one value a clock, of the inputs, outputs and registers of the C++ core.

    File: "stereo-hls trace 1 config=NAME clocks=N", a line of names, then N lines of hexadecimal values.
    """
    lines = Path(path).read_text().splitlines()
    if (
        len(lines) < 3
        or not lines[0].startswith("stereo-hls trace 1 ")
        or f"clocks={len(lines) - 2}" not in lines[0].split()
    ):
        raise FlowError(f"{path}: not a complete 'trace' file of format 1", EXIT_TOOL_FAILED)
    rows = [[int(value, 16) for value in line.split()] for line in lines[2:]]
    return dict(zip(lines[1].split(), zip(*rows)))


def trace_netlist(netlist, trace):
    """Values of each register of the netlist, in the same clocks; checks the outputs against the trace."""
    step = compile_step(netlist)
    registers, memories = initial_state(netlist)
    history = []
    for clock in range(len(trace["in_valid"])):
        history.append(tuple(registers))
        outputs = step({name: trace[f"in_{name}"][clock] for name in netlist.inputs}, registers, memories)
        for name, value in outputs.items():
            if value != trace[f"out_{name}"][clock] and (
                name not in ("disparity", "pixel_valid") or trace["out_disparity_valid"][clock]
            ):
                raise FlowError(
                    f"the lowered netlist differs from the C++ core: clock {clock}, {name}: expected "
                    f"{trace[f'out_{name}'][clock]}, got {value}",
                    EXIT_TOOL_FAILED,
                )
    return list(zip(*history))


def _as_in_cpp(netlist, trace, by_values):
    """Where the tool keeps the complement of a C++ bit, or a negative number as a large positive one, keeps what C++ has."""
    replacement = {}
    for register, values in zip(netlist.registers, trace_netlist(netlist, trace)):
        if values in by_values:
            continue
        old, width = register.value, register.value.width
        half = 1 << (width - 1)
        if old.is_bit and tuple(1 - v for v in values) in by_values:
            register.value, register.initial = leaf("register", f"{register.name}_inverted", 1), 1 - register.initial
            register.next = bit_not(register.next)
            replacement[id(old)] = bit_not(register.value)
        elif old.low == 0 and tuple(v - 2 * half if v >= half else v for v in values) in by_values:
            register.value = leaf("register", f"{register.name}_signed", width, signed=True)
            register.next = wrap(register.next, width, signed=True)
            replacement[id(old)] = wrap(register.value, width)
    netlist.substitute(replacement)
    merge_twins(netlist)


def name_registers(netlist, trace):
    """Renames and orders the registers after the C++ core. Returns how many found their name."""
    by_values = {}
    order = {}
    for name, values in trace.items():
        if not name.startswith(("in_", "out_")):
            order[name] = len(order)
            by_values.setdefault(values, []).append(name)
    _as_in_cpp(netlist, trace, by_values)
    named = 0
    for register, values in zip(netlist.registers, trace_netlist(netlist, trace)):
        candidates = by_values.get(values, [])
        register.name = candidates.pop(0) if candidates else ""
        named += register.name != ""
    for number, register in enumerate(r for r in netlist.registers if not r.name):
        register.name = f"other_{number}"
        order[register.name] = len(order)
    netlist.registers.sort(key=lambda r: order[r.name])
    for memory in netlist.memories:
        reader = next(
            (r.name for r in netlist.registers if any(node is memory.data for node in walk([r.next]))), memory.name
        )
        memory.name = f"{reader}_memory"
    return named
