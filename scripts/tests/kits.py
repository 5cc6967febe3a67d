# SPDX-License-Identifier: Apache-2.0
"""Kits for the tests, and what their VHDL says of itself."""

import re
from pathlib import Path
from typing import NamedTuple

from flow.kit import write
from flow.kit.contents import ORDER, TOOLS

KITS = tuple(TOOLS)


class Kit(NamedTuple):
    folder: Path
    config: str

    @property
    def top(self):
        return f"stereo_plain_{self.config}"

    def sources(self):
        """In compile order."""
        return [self.folder / name for name in (self.folder / ORDER).read_text().split()]


def make(folder, kit, config):
    write.write(kit, config, folder, 100)
    return Kit(folder, config)


class Entity(NamedTuple):
    generics: set  # names
    ports: dict  # name -> (direction, bits or None)


def entity(path):
    return entity_of(path.read_text())


def entity_of(text):
    """The only one of a VHDL file."""
    text = text[text.index("entity ") : text.index("end entity")]
    head, _, ports = text.partition("port (")
    found = re.findall(r"^    (\w+) : (in|out) std_logic(?:_vector\((\d+) downto 0\))?;?$", ports, re.MULTILINE)
    assert len(found) == ports.count(" : ")
    generics = set(re.findall(r"\(?(\w+) : ", head))
    return Entity(generics, {name: (way, int(high) + 1 if high else None) for name, way, high in found})
