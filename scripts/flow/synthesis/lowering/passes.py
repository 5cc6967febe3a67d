# SPDX-License-Identifier: Apache-2.0
"""What is done to the netlist between reading and writing, one pass after the other. docs/lowering.md explains each."""

from collections.abc import Callable
from typing import NamedTuple

from .cleanup import merge_twins, remove_unused
from .control import remove_control
from .memories import join_memory_slices, narrow_memories
from .naming import Trace, adopt_cpp_values, name_registers
from .netlist import Netlist
from .ranges import narrow_registers
from .vhdl_reader import Design


class Given(NamedTuple):
    """What passes know beside the netlist."""

    design: Design  # of the tool
    trace: Trace  # of the C++ core


class Pass(NamedTuple):
    name: str
    run: Callable[[Netlist, Given], None]


PASSES = (
    Pass("remove control", lambda netlist, given: remove_control(netlist, given.design)),
    Pass("remove unused", lambda netlist, given: remove_unused(netlist)),
    Pass("narrow memories", lambda netlist, given: narrow_memories(netlist)),
    Pass("join memory slices", lambda netlist, given: join_memory_slices(netlist)),
    Pass("adopt C++ values", lambda netlist, given: adopt_cpp_values(netlist, given.trace)),
    Pass("merge twins", lambda netlist, given: merge_twins(netlist)),
    Pass("name registers", lambda netlist, given: name_registers(netlist, given.trace)),
    Pass("narrow registers", lambda netlist, given: narrow_registers(netlist)),
)


def run_passes(netlist: Netlist, design: Design, trace: Trace) -> None:
    for step in PASSES:
        step.run(netlist, Given(design, trace))
