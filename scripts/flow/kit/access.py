# SPDX-License-Identifier: Apache-2.0
"""Who may do what with a field of a register, from the words of hls/rtl/registers.json."""

from ..base.errors import FlowError
from ..shell.registers import Field, Register

READ, WRITE, CLEAR = "read-only", "read-write", "write 1 to clear"
_WORDS = {"read": READ, "read, write": WRITE, "write 1 to clear": CLEAR}


def fields(register: Register) -> list[Field]:
    """A register without fields is one field."""
    whole: Field = {"name": "value", "low": 0, "high": 31, "text": register.get("text", "")}
    return register.get("fields", [whole])


def of(register: Register, field: Field) -> str:
    """The access of the register, then "; NAME: access" for each field that has another; `errors`: all of them."""
    words, *others = register["access"].split("; ")
    for other in others:
        name, _, of_these = other.partition(": ")
        if name == field["name"] or (name == "errors" and field["text"].startswith("error:")):
            words = of_these
    try:
        return _WORDS[words]
    except KeyError:
        raise FlowError(f"register {register['name']}: a kit does not know the access '{register['access']}'") from None


def bits(field: Field) -> int:
    return field["high"] - field["low"] + 1


def mask(field: Field) -> int:
    """In place."""
    return ((1 << bits(field)) - 1) << field["low"]
