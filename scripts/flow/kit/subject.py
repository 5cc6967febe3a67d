# SPDX-License-Identifier: Apache-2.0
"""What a kit is about: one configuration, its top and the bus interfaces of that, all from manifest.json."""

from __future__ import annotations

import re
from typing import NamedTuple

from ..base import committed, rtl
from ..base.errors import FlowError
from ..shell import design, registers, template
from ..shell.template import Port
from ..synthesis import manifest

CLOCK, RESET = "aclk", "aresetn"
INTERRUPT = "irq"
MAP_DATA = "m_axis_tdata"
GENERIC = "enabled_at_reset"
STREAM, REGISTERS = "AXI4-Stream", "AXI4-Lite"
_INTERFACES = {"s_axis": (STREAM, False), "m_axis": (STREAM, True), "s_axil": (REGISTERS, False)}
VENDOR, LIBRARY = "stereo_hls", "stereo"


class Interface(NamedTuple):
    name: str  # what the names of its ports begin with
    bus: str  # STREAM or REGISTERS
    is_master: bool
    signals: dict[str, Port]  # by what follows that


class Subject:
    """One configuration."""

    def __init__(self, config: str, pads_map: bool = False) -> None:
        """`pads_map`: with zeros above the map in m_axis_tdata, up to a power of two, as DMA engines want it."""
        folder = committed.folder(config)
        self.config = config
        self.entry = manifest.read(folder)
        self.manifest_file = folder / "manifest.json"
        self.generics = design.generics(self.entry)
        self.top = f"stereo_plain_{config}"
        self.own_units = {rtl.core_entity(config), rtl.ip_entity(config), self.top}  # no other configuration has them
        self.pixel_bits = rtl.pixel_bits_of(self.entry["parameters"])
        self.inner_ports = template.ports(self.generics, self.pixel_bits)  # of the stereo_ip
        self.ports = [_padded(port) if pads_map and port.name == MAP_DATA else port for port in self.inner_ports]
        self.interfaces = _interfaces(self.ports)
        self.sources = design.vhdl_files(config)  # below the top
        self.registers = registers.description_of(self.entry["parameters"]["family"])
        self.version = ".".join(map(str, registers.VERSION))  # as the register says

    def register_values(self) -> dict[str, int]:
        """{register: what it always reads}: those that say which core stands here."""
        values = {"id": registers.ID, "version": registers.version_value()}
        values["core"] = int(template.core_id(self.entry), 16)
        for register in self.registers:
            fields = register.get("fields", [])
            if fields and all(field["name"] in self.generics for field in fields):
                values[register["name"]] = sum(self.generics[field["name"]] << field["low"] for field in fields)
        return values


def _interfaces(ports: list[Port]) -> list[Interface]:
    """Every port belongs to one, but for clock, reset and interrupt."""
    found = {name: Interface(name, *what, {}) for name, what in _INTERFACES.items()}
    for port in ports:
        name, _, signal = port.name.rpartition("_")
        if name in found:
            found[name].signals[signal] = port
        elif port.name not in (CLOCK, RESET, INTERRUPT):
            raise FlowError(f"a kit does not know to which interface the port {port.name} belongs")
    return list(found.values())


def width(port: Port) -> int | None:
    """In bits; None of a port that is no vector."""
    vector = re.fullmatch(r"std_logic_vector\((\d+) downto 0\)", port.kind)
    return int(vector.group(1)) + 1 if vector else None


def _padded(port: Port) -> Port:
    bits = width(port) or 1
    return port._replace(kind=f"std_logic_vector({(1 << (bits - 1).bit_length()) - 1} downto 0)")


def wrapper_file(subject: Subject) -> str:
    """Within the folder rtl of a kit."""
    return f"{subject.top}.vhd"


def _slice(port: Port, outer: Port) -> str:
    return port.name if outer == port else f"{port.name}({(width(port) or 1) - 1} downto 0)"


def wrapper(subject: Subject) -> str:
    """The top for packagers. AMD's takes VHDL-93 or Verilog with plain ports (UG1118), and a system in Verilog cannot
    set a generic that is boolean."""
    inside = template.instance(
        "ip",
        rtl.ip_entity(subject.config),
        {GENERIC: f"{GENERIC} = 1"},
        {port.name: _slice(port, outer) for port, outer in zip(subject.inner_ports, subject.ports)},
    )
    zeros = [
        f"  {outer.name}({(width(outer) or 1) - 1} downto {width(port)}) <= (others => '0');"
        for port, outer in zip(subject.inner_ports, subject.ports)
        if outer != port
    ]
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- {rtl.ip_entity(subject.config)} as packagers take it: VHDL-93, plain ports, and a number as its generic.",
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        f"entity {subject.top} is",
        f"  generic ({GENERIC} : natural range 0 to 1 := 1);  -- 0: waits for a processor",
        "  port (",
        ";\n".join(f"    {port.name} : {port.direction} {port.kind}" for port in subject.ports),
        "  );",
        "end entity;",
        "",
        f"architecture rtl of {subject.top} is",
        "begin",
        inside,
        *zeros,
        "end architecture;",
        "",
    ]
    return "\n".join(lines)
