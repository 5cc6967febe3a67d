# SPDX-License-Identifier: Apache-2.0
"""A kit for AMD's Vivado: a script that packages the core for its IP catalogue."""

from ..shell import registers
from . import access
from .fill import fill
from .subject import INTERRUPT, LIBRARY, VENDOR, Subject


def _register_calls(subject: Subject) -> list[str]:
    """Calls of the script's procedures `register` and `field`."""
    calls = []
    for entry in subject.registers:
        calls.append(f"register {entry['name']} 0x{entry['offset']:02X}")
        for field in access.fields(entry):
            allowed = access.of(entry, field)
            modified = "oneToClear" if allowed == access.CLEAR else ""
            may = access.READ if allowed == access.READ else access.WRITE
            words = [field["name"], field["low"], access.bits(field), may, f"{{{modified}}}", _quoted(field["text"])]
            calls.append("field " + " ".join(map(str, words)))
    return calls


def _quoted(text: str) -> str:
    """As one word of Tcl that means itself."""
    for character in '\\"[]$':
        text = text.replace(character, f"\\{character}")
    return f'"{text.replace("`", "")}"'


def script(subject: Subject, sources: list[str]) -> str:
    """package_ip.tcl. `sources`: in compile order, the top last."""
    return fill(
        "package_ip.tcl",
        config=subject.config,
        top=subject.top,
        vendor=VENDOR,
        library=LIBRARY,
        version=".".join(subject.version.split(".")[:2]),  # Vivado takes two numbers
        sources="\n".join(f"  {name}" for name in sources),
        buses=" ".join(interface.name for interface in subject.interfaces),
        range=str(1 << registers.address_bits()),
        interrupt=INTERRUPT,
        registers="\n".join(_register_calls(subject)),
    )
