# SPDX-License-Identifier: Apache-2.0
"""The registers in C, and the driver on top of them."""

from . import access, naming
from .fill import TEMPLATES, fill
from .subject import Subject

DRIVER = ("stereo_driver.h", "stereo_driver.c")  # the same for every configuration but for their names


def header(subject: Subject) -> str:
    """stereo_registers.h, before its names are the configuration's own."""
    lines = []
    for register in subject.registers:
        name = register["name"].upper()
        lines += ["", f"#define STEREO_{name}_OFFSET 0x{register['offset']:02x}u"]
        for field in register.get("fields", []):
            prefix = f"STEREO_{name}_{field['name'].upper()}"
            lines.append(f"#define {prefix}_MASK 0x{access.mask(field):08x}u")
            lines.append(f"#define {prefix}_SHIFT {field['low']}")
        cleared = sum(access.mask(f) for f in access.fields(register) if access.of(register, f) == access.CLEAR)
        if cleared:
            lines.append(f"#define STEREO_{name}_CLEARED_BY_1 0x{cleared:08x}u")
    constants = [f"#define STEREO_{name.upper()}_VALUE 0x{v:08x}u" for name, v in subject.register_values().items()]
    return fill(
        "stereo_registers.h", config=subject.config, registers="\n".join(lines[1:]), constants="\n".join(constants)
    )


def files(subject: Subject) -> dict[str, str]:
    """{name: text}"""
    texts = {"stereo_registers.h": header(subject)} | {name: (TEMPLATES / name).read_text() for name in DRIVER}
    return {naming.of_c(subject.config, name): naming.of_c(subject.config, text) for name, text in texts.items()}
