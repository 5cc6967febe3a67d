# SPDX-License-Identifier: Apache-2.0
"""The registers of stereo_ip. One description, hls/rtl/registers.json, becomes the VHDL package of their addresses and
the table in docs/integration.md."""

from pathlib import Path
from typing import Any, TypedDict

from ..base import files, json_files, markdown
from ..base.errors import FlowError
from ..base.newer_python import NotRequired
from ..base.tools import ROOT

DESCRIPTION = ROOT / "hls" / "rtl" / "registers.json"
PACKAGE = ROOT / "hls" / "rtl" / "stereo_register_map.vhd"
DOCUMENT = ROOT / "docs" / "integration.md"
TABLE_BEGIN, TABLE_END = "<!-- registers: made by scripts/registers.py -->", "<!-- end of registers -->"
ID = 0x53544552  # "STER"
VERSION = (1, 4, 0)
PLAIN = "block_matching"  # whose names the settings have in a family without names of its own


class Field(TypedDict):
    name: str
    low: int
    high: int
    text: str


class Register(TypedDict):
    name: str
    offset: int
    access: str
    family: NotRequired[str]  # the word has this name in cores of this family only
    text: NotRequired[str]  # of one without fields
    fields: NotRequired[list[Field]]


def description() -> list[Register]:
    """Of all families. Two names of a word are two registers. Raises FlowError where the file is damaged."""
    try:
        content = json_files.load(DESCRIPTION)
        registers: list[Register] = content["registers"]
        is_whole = _is_register_map(registers)
    except ValueError as error:
        raise FlowError(f"damaged {files.shown(DESCRIPTION)}: {error}") from None
    except (KeyError, TypeError):
        is_whole = False
    if not is_whole:
        raise FlowError(f"damaged {files.shown(DESCRIPTION)}: it does not describe the registers of stereo_ip")
    return registers


def _is_register_map(registers: list[Register]) -> bool:
    """Whether all is there, and each register of a family has a word of its own."""
    if not registers or not json_files.fits(registers, list[Register]):
        return False
    for family in {PLAIN, *(one["family"] for one in registers if "family" in one)}:
        offsets = [one["offset"] for one in registers if one.get("family", family) == family]
        if len(set(offsets)) < len(offsets) or any(offset % 4 or offset < 0 for offset in offsets):
            return False
    return True


def description_of(family: str) -> list[Register]:
    """Those of a family's cores, in the order of their addresses."""
    known = {register["family"] for register in description() if "family" in register}
    named = family if family in known else PLAIN
    found = [register for register in description() if register.get("family", named) == named]
    return sorted(found, key=lambda register: register["offset"])


def by_name() -> dict[str, dict[str, Any]]:
    """{register: the same with its fields as {name: field}}"""
    return {
        entry["name"]: {**entry, "fields": {field["name"]: field for field in entry.get("fields", [])}}
        for entry in description()
    }


def address_bits() -> int:
    return max(register["offset"] for register in description()).bit_length()


def version_value() -> int:
    """What the register says."""
    major, minor, patch = VERSION
    return major << 16 | minor << 8 | patch


def settings() -> list[str]:
    """The registers that hold a setting of a core."""
    return [
        register["name"]
        for register in description()
        if any(f["name"] == "largest" for f in register.get("fields", []))
    ]


def setting_words() -> dict[str, int]:
    """{setting: which of the words for settings it has}; these words follow one another."""
    offset = {register["name"]: register["offset"] for register in description()}
    first = min(offset[name] for name in settings())
    return {name: (offset[name] - first) // 4 for name in settings()}


def vhdl_package() -> str:
    lines = [
        "-- SPDX-License-Identifier: Apache-2.0",
        "-- Addresses, in words of 4 bytes, and fields of the registers of stereo_ip: of a field of one bit its place, "
        "of a wider",
        "-- one its width. Made by scripts/registers.py from hls/rtl/registers.json; do not edit.",
        "library ieee;",
        "use ieee.std_logic_1164.all;",
        "",
        "package stereo_register_map is",
        f"  constant address_bits : positive := {address_bits()};  -- of addresses in bytes",
        f'  constant id_value : std_logic_vector(31 downto 0) := x"{ID:08x}";',
        f'  constant version_value : std_logic_vector(31 downto 0) := x"{version_value():08x}";',
    ]
    for register in description():
        name = register["name"]
        lines.append(f"  constant {name}_word : natural := {register['offset'] // 4};")
        for field in register.get("fields", []):
            bits = field["high"] - field["low"] + 1
            if bits == 1:
                lines.append(f"  constant {name}_{field['name']} : natural := {field['low']};")
            else:
                lines.append(f"  constant {name}_{field['name']}_bits : positive := {bits};")
    words = setting_words()
    lines += [
        f"  constant setting_count : positive := {max(words.values()) + 1};",
        f"  constant first_setting_word : natural := {min(words, key=words.__getitem__)}_word;",
        "  type setting_words is array (0 to setting_count - 1) of std_logic_vector(15 downto 0);",
        "  type setting_values is array (0 to setting_count - 1) of natural;",
    ]
    return "\n".join([*lines, "end package;", ""])


def table() -> str:
    rows = ["| address | register | bits | field | access | meaning |", "|---|---|---|---|---|---|"]
    for register in sorted(description(), key=lambda register: register["offset"]):
        of_family = f", {register['family']}" if "family" in register else ""
        head = f"| `0x{register['offset']:02X}` | `{register['name']}`{of_family} "
        access = register["access"]
        whole: Field = {"name": "", "high": 31, "low": 0, "text": register.get("text", "")}
        for field in register.get("fields", [whole]):
            bits = str(field["low"]) if field["high"] == field["low"] else f"{field['high']} ... {field['low']}"
            name = f"`{field['name']}`" if field["name"] else ""
            rows.append(f"{head}| {bits} | {name} | {access} | {field['text']} |")
            head, access = "| | ", ""
    return "\n".join(rows)


def require_in_step() -> None:
    """Raises FlowError where the VHDL has other addresses than the description."""
    if not PACKAGE.is_file() or PACKAGE.read_text() != vhdl_package():
        raise FlowError(f"{files.shown(PACKAGE)} does not follow from {DESCRIPTION.name}; run scripts/registers.py")


def made_files() -> dict[Path, str]:
    """{path: text that belongs there}"""
    made = {PACKAGE: vhdl_package()}
    if DOCUMENT.is_file():
        made[DOCUMENT] = markdown.replaced(DOCUMENT, TABLE_BEGIN, TABLE_END, table())
    return made
