# SPDX-License-Identifier: Apache-2.0
"""Names of a kit's own: two kits in one library, one netlist or one program must not call different things alike."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

_UNIT = re.compile(r"^(?:entity|package) (\w+) is$", re.MULTILINE)
# In C, but for the word stereo_ip, which is what it is called in sentences.
_C_NAME = re.compile(r"\b(stereo|STEREO)_(?!ip\b|ip_)")


def units(texts: Iterable[str]) -> set[str]:
    """Entities and packages of VHDL files."""
    return {name for text in texts for name in _UNIT.findall(text)}


def of_vhdl(config: str, own: set[str], texts: Mapping[str, str]) -> dict[str, str]:
    """{file name: text} of all VHDL of a kit. Units that other configurations have, too, get this one's name behind
    theirs, and so do their files. `own`: units that have it already."""
    shared = units(texts.values()) - own
    word = re.compile(rf"\b({'|'.join(sorted(shared))})\b")
    return {word.sub(rf"\1_{config}", name): word.sub(rf"\1_{config}", text) for name, text in texts.items()}


def of_c(config: str, text: str) -> str:
    """What begins with stereo_ or STEREO_ gets the configuration's name behind that: functions, types, macros."""
    return _C_NAME.sub(lambda found: f"{found[1]}_{config if found[1].islower() else config.upper()}_", text)
