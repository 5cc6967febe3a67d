# SPDX-License-Identifier: Apache-2.0
"""The instantiation of stereo_ip for one configuration, as VHDL text."""

import re
from typing import NamedTuple

from ..base.tools import ROOT
from . import design, registers


class Port(NamedTuple):
    name: str
    direction: str
    kind: str


def ports() -> list[Port]:
    """Those of stereo_ip, in order."""
    text = (design.RTL / "stereo_ip.vhd").read_text()
    declaration = text[text.index("  port (") : text.index("end entity;")]
    found = re.findall(r"^    (\w+) : (in|out) (.*?);?(?:  --.*)?$", declaration, re.MULTILINE)
    return [Port(*port) for port in found]


def plain_ports(values: dict[str, int]) -> list[Port]:
    """The ports with numbers instead of generics in their types."""
    numbers = {
        "16 * pixels_per_clock - 1": 16 * values["pixels_per_clock"] - 1,
        "address_bits - 1": registers.address_bits() - 1,
        "disparity_bits * pixels_per_clock + 7": values["disparity_bits"] * values["pixels_per_clock"] + 7,
    }

    def plain(kind: str) -> str:
        for text, number in numbers.items():
            kind = kind.replace(text, str(number))
        return kind

    return [port._replace(kind=plain(port.kind)) for port in ports()]


def entity(config: str, values: dict[str, int]) -> str:
    """A wrapper with plain ports and no generics: stereo_ip_CONFIG."""
    name = f"stereo_ip_{config}"
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- stereo_ip for configuration {config}, with plain ports. "
        f"Made by scripts/instantiate.py --config {config}. Compile before it:",
        *(f"--   {path.relative_to(ROOT)}" for path in design.vhdl_files(config)),
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        f"entity {name} is",
        "  port (",
    ]
    lines.append(";\n".join(f"    {port.name} : {port.direction} {port.kind}" for port in plain_ports(values)))
    lines += [
        "  );",
        "end entity;",
        "",
        f"architecture wrapper of {name} is",
        "begin",
        instance(values, "ip"),
        "end architecture;",
        "",
    ]
    return "\n".join(lines)


def instance(values: dict[str, int], label: str) -> str:
    generics = ",\n".join(f"      {name} => {value}" for name, value in values.items())
    connections = ",\n".join(f"      {port.name} => {port.name}" for port in ports())
    return f"  {label} : entity work.stereo_ip\n    generic map (\n{generics})\n    port map (\n{connections});"
