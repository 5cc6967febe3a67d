# SPDX-License-Identifier: Apache-2.0
"""stereo_ip_NAME: the shell around the core of one configuration, with plain ports, as VHDL text. It stands beside the
core and follows from the core's manifest: no synthesis tool is needed to make it."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, Union

from ..base import committed, files, rtl
from ..base.configurations import clocks_per_pixel
from ..cosim.bench import SETTING_BITS
from ..synthesis import manifest
from . import design, registers

Generics = Mapping[str, Union[int, str]]


class Port(NamedTuple):
    name: str
    direction: str
    kind: str


def _shell_ports() -> list[Port]:
    """Those of stereo_shell, in order."""
    text = (design.RTL / "stereo_shell.vhd").read_text()
    declaration = text[text.index("  port (") : text.index("end entity;")]
    found = re.findall(r"^    (\w+) : (in|out) (.*?);?(?:  --.*)?$", declaration, re.MULTILINE)
    return [Port(*port) for port in found]


def lane_bits(pixel_bits: int) -> int:
    """Of s_axis_tdata for a pixel: whole bytes, and of one width for all that do not fit one."""
    return 8 if pixel_bits <= 8 else 16


def pixel_generics(pixel_bits: int) -> dict[str, int]:
    """Of a shell or a joiner; none where they are those that it has by itself."""
    return {"pixel_bits": pixel_bits, "lane_bits": lane_bits(pixel_bits)} if pixel_bits > rtl.PIXEL_BITS else {}


def pace_generics(parameters: Mapping[str, Any]) -> dict[str, int]:
    """Of a shell around a core that takes a pair in several clocks."""
    clocks = clocks_per_pixel(parameters)
    return {"clocks_per_group": clocks} if clocks > 1 else {}


def ports(values: Mapping[str, int], pixel_bits: int = rtl.PIXEL_BITS) -> list[Port]:
    """Those of a stereo_ip, with numbers instead of generics in their types."""
    numbers = {
        "2 * lane_bits * pixels_per_clock - 1": 2 * lane_bits(pixel_bits) * values["pixels_per_clock"] - 1,
        "address_bits - 1": registers.address_bits() - 1,
        "disparity_bits * pixels_per_clock + 7": values["disparity_bits"] * values["pixels_per_clock"] + 7,
    }

    def plain(kind: str) -> str:
        for text, number in numbers.items():
            kind = kind.replace(text, str(number))
        return kind

    return [port._replace(kind=plain(port.kind)) for port in _shell_ports() if not port.name.startswith("core_")]


def _values(settings: Sequence[rtl.Setting], what: str) -> str:
    """Of all words for settings, as VHDL."""
    words = registers.setting_words()
    values = [0] * (max(words.values()) + 1)
    for setting in settings:
        values[words[setting.name]] = getattr(setting, what)
    return f"({', '.join(map(str, values))})"


def core_id(entry: manifest.Manifest) -> str:
    """What the register `core` says: the first digits of the digest of the core's structure, which names and comments
    in its VHDL leave as it is."""
    return entry["structure"][:8]


def entity(config: str, entry: manifest.Manifest, of_the_shell: Generics | None = None) -> str:
    """The text of stereo_ip_CONFIG. `of_the_shell`: generics that are not those of the core, for tests."""
    values = design.generics(entry)
    pixel_bits = rtl.pixel_bits_of(entry["parameters"])
    name, outside = rtl.ip_entity(config), ports(values, pixel_bits)
    settings = rtl.settings_of(entry["parameters"])
    widths = {
        port.name: rtl.port_type(port, values["pixels_per_clock"], values["disparity_bits"])
        for port in rtl.ports_of(entry["parameters"])
    }
    of_the_core = {"reset", *widths} | ({"settings"} if settings else set())
    to_core = [port for port in _shell_ports() if port.name.removeprefix("core_") in of_the_core]
    shell = {
        **values,
        "core_id": f'x"{core_id(entry)}"',
        "enabled_at_reset": "enabled_at_reset",
        **({f"settings_{what}": _values(settings, what) for what in ("largest", "start")} if settings else {}),
        **({"settings_least": _values(settings, "least")} if any(setting.least for setting in settings) else {}),
        **pixel_generics(pixel_bits),
        **pace_generics(entry["parameters"]),
        **(of_the_shell or {}),
    }
    inside = {port.name: port.name.removeprefix("core_") for port in to_core}
    core_ports = {"clock": "aclk"} | {name: name for name in inside.values() if name != "settings"}
    for setting in settings:
        word = f"settings({registers.setting_words()[setting.name]})"
        core_ports[setting.name] = word if setting.bits == SETTING_BITS else f"{word}({setting.bits - 1} downto 0)"
    widths["settings"] = "work.stereo_register_map.setting_words"
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- The core {rtl.core_entity(config)} between AXI4-Streams: docs/integration.md. Do not edit; made by",
        f"--   scripts/instantiate.py --config {config}",
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        f"entity {name} is",
        "  generic (enabled_at_reset : boolean := true);  -- false: waits for a processor",
        "  port (",
        ";\n".join(f"    {port.name} : {port.direction} {port.kind}" for port in outside),
        "  );",
        "end entity;",
        "",
        f"architecture rtl of {name} is",
        *(f"  signal {name} : {widths.get(name, 'std_logic')};" for name in inside.values()),
        "begin",
        instance("shell", "stereo_shell", shell, {**{port.name: port.name for port in outside}, **inside}),
        "",
        instance("core", rtl.core_entity(config), values, core_ports),
        "end architecture;",
        "",
    ]
    return "\n".join(lines)


def instance(label: str, of: str, generics: Generics, connections: Mapping[str, str]) -> str:
    def listed(pairs: Mapping[str, int | str]) -> str:
        return ",\n".join(f"      {name} => {value}" for name, value in pairs.items())

    head = f"  {label} : entity work.{of}\n"
    with_generics = f"    generic map (\n{listed(generics)})\n" if generics else ""
    return f"{head}{with_generics}    port map (\n{listed(connections)});"


def user_instance(config: str, entry: manifest.Manifest) -> str:
    """An instance of stereo_ip_CONFIG, to be pasted, with the files to compile before it."""
    outside = ports(design.generics(entry), rtl.pixel_bits_of(entry["parameters"]))
    names = {port.name: port.name for port in outside}
    compiled = (f"  -- {files.shown(path)}" for path in design.vhdl_files(config))
    return "\n".join([*compiled, instance("stereo", rtl.ip_entity(config), {}, names), ""])


def file(config: str, entry: manifest.Manifest) -> dict[str, str]:
    """{its name: its text}"""
    return {f"{rtl.ip_entity(config)}.vhd": entity(config, entry)}


def path(config: str) -> Path:
    return committed.folder(config) / f"{rtl.ip_entity(config)}.vhd"


def is_fresh(config: str, entry: manifest.Manifest) -> bool:
    """Whether the file that is committed follows from the manifest."""
    return path(config).is_file() and path(config).read_text() == entity(config, entry)
