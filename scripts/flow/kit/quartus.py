# SPDX-License-Identifier: Apache-2.0
"""A kit for Intel's Quartus: a component of Platform Designer, and a list of files for projects without it."""

from ..shell.template import Port
from .fill import fill
from .subject import GENERIC, STREAM, Interface, Subject, width

# Quartus takes VHDL-93 unless told otherwise, and a component of Platform Designer has no other way to tell it. The
# files are valid as either.
DIRECTIVE = "-- synthesis VHDL_INPUT_VERSION VHDL_2008\n"
TYPES = {(STREAM, True): "axi4stream start", (STREAM, False): "axi4stream end"}


def _port(interface: Interface, role: str, port: Port) -> list[str]:
    """A vector of one bit is no std_logic, which Platform Designer would take it for."""
    bits = width(port)
    direction = "Input" if port.direction == "in" else "Output"
    kind = "STD_LOGIC" if bits is None else "STD_LOGIC_VECTOR"
    return [
        f"add_interface_port {interface.name} {port.name} {role} {direction} {bits or 1}",
        f"set_port_property {port.name} VHDL_TYPE {kind}",
    ]


def _interface(interface: Interface) -> list[str]:
    lines = [
        f"add_interface {interface.name} {TYPES.get((interface.bus, interface.is_master), 'axi4lite end')}",
        f"set_interface_property {interface.name} associatedClock clock",
        f"set_interface_property {interface.name} associatedReset reset",
    ]
    for role, port in interface.signals.items():
        lines += _port(interface, role, port)
    return [*lines, ""]


def component(subject: Subject, sources: list[str]) -> str:
    """TOP_hw.tcl. `sources`: in compile order, the top last."""

    def added(name: str) -> str:
        last = " TOP_LEVEL_FILE" if name == sources[-1] else ""
        return f"  add_fileset_file {name.rpartition('/')[2]} VHDL PATH {name}{last}"

    return fill(
        "component_hw.tcl",
        config=subject.config,
        top=subject.top,
        version=subject.version,
        generic=GENERIC,
        files="\n".join(map(added, sources)),
        interfaces="\n".join(line for interface in subject.interfaces for line in _interface(interface)),
    )


def file_list(subject: Subject, sources: list[str]) -> str:
    """TOP.qip."""
    named = (
        f'set_global_assignment -name VHDL_FILE [file join $::quartus(qip_path) "{name}"] -hdl_version VHDL_2008'
        for name in sources
    )
    return fill("files.qip", config=subject.config, files="\n".join(named))
