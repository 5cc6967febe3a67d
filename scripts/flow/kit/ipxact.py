# SPDX-License-Identifier: Apache-2.0
"""The description of a kit's top in IP-XACT, IEEE 1685-2014: component.xml."""

from __future__ import annotations

import xml.etree.ElementTree as xml
from collections.abc import Iterable
from pathlib import Path

from ..shell import registers
from ..shell.registers import Field, Register
from ..shell.template import Port
from . import access
from .subject import CLOCK, GENERIC, INTERRUPT, LIBRARY, REGISTERS, RESET, STREAM, VENDOR, Interface, Subject, width

SPACE = "http://www.accellera.org/XMLSchema/IPXACT/1685-2014"
# Arm's names of the buses: (name, version) of a bus definition; its abstraction is NAME_rtl.
BUSES = {STREAM: ("AXI4Stream", "r0p0_1"), REGISTERS: ("AXI4-Lite", "r0p0_0")}
# A signal of its own, by the name that catalogues know it by; it is level high.
SIGNAL = {"vendor": "xilinx.com", "library": "signal", "version": "1.0"}
CLOCK_AND_RESET = {"ACLK": CLOCK, "ARESETn": RESET}  # in Arm's definitions part of each bus: so they are associated
MAP, FILES, VIEW = "registers", "rtl", "implementation"


def _element(tag: str, *inside: xml.Element | str | int, **attributes: str) -> xml.Element:
    element = xml.Element(f"{{{SPACE}}}{tag}", attributes)
    for part in inside:
        if isinstance(part, xml.Element):
            element.append(part)
        else:
            element.text = str(part)
    return element


def _list(tag: str, elements: Iterable[xml.Element]) -> xml.Element:
    return _element(tag, *elements)


def component(subject: Subject, sources: Iterable[Path], constraints: Iterable[Path]) -> str:
    """`sources`, `constraints`: of the kit, in compile order, from the folder of component.xml on."""
    name = f"Stereo matching, configuration {subject.config}"
    root = _element(
        "component",
        _element("vendor", VENDOR),
        _element("library", LIBRARY),
        _element("name", subject.top),
        _element("version", subject.version),
        _list("busInterfaces", [*map(_bus_interface, subject.interfaces), _interrupt()]),
        _list("memoryMaps", [_memory_map(subject)]),
        _model(subject),
        _list("fileSets", [_file_set(subject, sources, constraints)]),
        _element("description", name),
        _list("parameters", [_parameter()]),
    )
    xml.register_namespace("ipxact", SPACE)
    xml.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + xml.tostring(root, encoding="unicode") + "\n"


def _bus_interface(interface: Interface) -> xml.Element:
    name, version = BUSES[interface.bus]
    what = {"vendor": "amba.com", "library": "AMBA4", "version": version}
    ports = CLOCK_AND_RESET | {signal.upper(): port.name for signal, port in interface.signals.items()}
    abstraction = _element(
        "abstractionType",
        _element("abstractionRef", **what, name=f"{name}_rtl"),
        _list("portMaps", (_port_map(logical, physical) for logical, physical in ports.items())),
    )
    mode = _element("master") if interface.is_master else _element("slave")
    if interface.bus == REGISTERS:
        mode.append(_element("memoryMapRef", memoryMapRef=MAP))
    return _element(
        "busInterface",
        _element("name", interface.name),
        _element("busType", **what, name=name),
        _element("abstractionTypes", abstraction),
        mode,
    )


def _interrupt() -> xml.Element:
    abstraction = _element(
        "abstractionType",
        _element("abstractionRef", **SIGNAL, name="interrupt_rtl"),
        _list("portMaps", [_port_map("INTERRUPT", INTERRUPT)]),
    )
    level = _element(
        "parameter",
        _element("name", "SENSITIVITY"),
        _element("value", "LEVEL_HIGH"),
        parameterId="IRQ_SENSITIVITY",
        type="string",
    )
    return _element(
        "busInterface",
        _element("name", INTERRUPT),
        _element("busType", **SIGNAL, name="interrupt"),
        _element("abstractionTypes", abstraction),
        _element("master"),
        _list("parameters", [level]),
    )


def _port_map(logical: str, physical: str) -> xml.Element:
    def named(tag: str, name: str) -> xml.Element:
        return _element(tag, _element("name", name))

    return _element("portMap", named("logicalPort", logical), named("physicalPort", physical))


def _memory_map(subject: Subject) -> xml.Element:
    values = subject.register_values()
    block = _element(
        "addressBlock",
        _element("name", "block"),
        _element("baseAddress", 0),
        _element("range", 1 << registers.address_bits()),
        _element("width", 32),
        _element("usage", "register"),
        *(_register(register, values.get(register["name"])) for register in subject.registers),
    )
    return _element("memoryMap", _element("name", MAP), block, _element("addressUnitBits", 8))


def _register(register: Register, value: int | None) -> xml.Element:
    return _element(
        "register",
        _element("name", register["name"]),
        _element("addressOffset", f"'h{register['offset']:02X}"),
        _element("size", 32),
        _element("volatile", "false" if value is not None else "true"),
        *(_field(register, field, value) for field in access.fields(register)),
    )


def _field(register: Register, field: Field, value: int | None) -> xml.Element:
    allowed = access.of(register, field)
    element = _element(
        "field",
        _element("name", field["name"]),
        _element("description", field["text"].replace("`", "")),
        _element("bitOffset", field["low"]),
    )
    if value is not None:
        reset = (value & access.mask(field)) >> field["low"]
        element.append(_list("resets", [_element("reset", _element("value", f"'h{reset:X}"))]))
    element.append(_element("bitWidth", access.bits(field)))
    element.append(_element("access", access.READ if allowed == access.READ else access.WRITE))
    if allowed == access.CLEAR:
        element.append(_element("modifiedWriteValue", "oneToClear"))
    return element


def _model(subject: Subject) -> xml.Element:
    view = _element(
        "view",
        _element("name", VIEW),
        _element("envIdentifier", ":*Synthesis:"),
        _element("envIdentifier", ":*Simulation:"),
        _element("componentInstantiationRef", VIEW),
    )
    generic = _element(
        "moduleParameter", _element("name", GENERIC), _element("value", GENERIC), dataType="natural", type="int"
    )
    instantiation = _element(
        "componentInstantiation",
        _element("name", VIEW),
        _element("language", "VHDL"),
        _element("libraryName", "work"),
        _element("moduleName", subject.top),
        _element("architectureName", "rtl"),
        _list("moduleParameters", [generic]),
        _element("fileSetRef", _element("localName", FILES)),
    )
    return _element(
        "model",
        _list("views", [view]),
        _list("instantiations", [instantiation]),
        _list("ports", (_port(port) for port in subject.ports)),
    )


def _port(port: Port) -> xml.Element:
    wire = _element("wire", _element("direction", port.direction))
    bits = width(port)
    if bits is not None:
        wire.append(_list("vectors", [_element("vector", _element("left", bits - 1), _element("right", 0))]))
    kind = "std_logic" if bits is None else "std_logic_vector"
    types = _element(
        "wireTypeDef",
        _element("typeName", kind),
        _element("typeDefinition", "ieee.std_logic_1164.all"),
        _element("viewRef", VIEW),
    )
    wire.append(_list("wireTypeDefs", [types]))
    return _element("port", _element("name", port.name), wire)


def _file_set(subject: Subject, sources: Iterable[Path], constraints: Iterable[Path]) -> xml.Element:
    """1685-2014 has no name for VHDL-2008."""

    def file(path: Path) -> xml.Element:
        if path.stem == subject.top:
            kind = _element("fileType", "vhdlSource-93")
        elif path.suffix == ".vhd":
            kind = _element("fileType", "user", user="vhdlSource-2008")
        elif path.suffix == ".sdc":
            kind = _element("fileType", "SDC")
        else:
            kind = _element("fileType", "user", user=path.suffix[1:])
        return _element("file", _element("name", path.as_posix()), kind)

    return _element("fileSet", _element("name", FILES), *map(file, [*sources, *constraints]))


def _parameter() -> xml.Element:
    return _element(
        "parameter",
        _element("name", GENERIC),
        _element("description", "1: takes frames after reset; 0: waits for a processor"),
        _element("value", 1),
        parameterId=GENERIC,
        type="int",
        resolve="user",
        minimum="0",
        maximum="1",
    )
