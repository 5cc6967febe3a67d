# SPDX-License-Identifier: Apache-2.0
"""The instantiation of stereo_ip for one configuration, as VHDL text."""

import re

from ..base.tools import GENERATED_RTL, ROOT
from ..synthesis import manifest
from . import design, registers


def ports():
    """[(name, direction, type)] of stereo_ip, in order."""
    text = (design.RTL / "stereo_ip.vhd").read_text()
    declaration = text[text.index("  port (") : text.index("end entity;")]
    return re.findall(r"^    (\w+) : (in|out) (.*?);?(?:  --.*)?$", declaration, re.MULTILINE)


def widths(values):
    """The types of the ports with numbers instead of generics."""
    numbers = {
        "16 * pixels_per_clock - 1": 16 * values["pixels_per_clock"] - 1,
        "address_bits - 1": registers.address_bits() - 1,
        "disparity_bits * pixels_per_clock + 7": values["disparity_bits"] * values["pixels_per_clock"] + 7,
    }

    def plain(kind):
        for text, number in numbers.items():
            kind = kind.replace(text, str(number))
        return kind

    return [(name, direction, plain(kind)) for name, direction, kind in ports()]


def entity(config, values):
    """A wrapper with plain ports and no generics: stereo_ip_CONFIG."""
    name = f"stereo_ip_{config}"
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        f"-- stereo_ip for configuration {config}, with plain ports. Made by scripts/instantiate.py --config {config}. Compile before it:",
        *(
            f"--   {path.relative_to(ROOT)}"
            for path in [*manifest.vhdl_files(GENERATED_RTL / config), *design.shell_files()]
        ),
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        f"entity {name} is",
        "  port (",
    ]
    plain = widths(values)
    lines += [
        f"    {port} : {direction} {kind}{';' if place < len(plain) - 1 else ''}"
        for place, (port, direction, kind) in enumerate(plain)
    ]
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


def instance(values, label):
    generics = ",\n".join(f"      {name} => {values[name]}" for name in design.GENERICS)
    connections = ",\n".join(f"      {name} => {name}" for name, _, _ in ports())
    return f"  {label} : entity work.stereo_ip\n    generic map (\n{generics})\n    port map (\n{connections});"
