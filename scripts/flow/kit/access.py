# SPDX-License-Identifier: Apache-2.0
"""Who may do what with a field of a register, from the words of hls/rtl/registers.json."""

from ..base.errors import FlowError
from ..shell.registers import Field, Register

READ, WRITE, CLEAR = "read-only", "read-write", "write 1 to clear"
_OF_REGISTER = {"read": READ, "read, write": WRITE}
_ERRORS_CLEAR = "read; errors: write 1 to clear"


def fields(register: Register) -> list[Field]:
    """A register without fields is one field."""
    whole: Field = {"name": "value", "low": 0, "high": 31, "text": register.get("text", "")}
    return register.get("fields", [whole])


def of(register: Register, field: Field) -> str:
    if register["access"] == _ERRORS_CLEAR:
        return CLEAR if field["text"].startswith("error:") else READ
    try:
        return _OF_REGISTER[register["access"]]
    except KeyError:
        raise FlowError(f"register {register['name']}: a kit does not know the access '{register['access']}'") from None


def bits(field: Field) -> int:
    return field["high"] - field["low"] + 1


def mask(field: Field) -> int:
    """In place."""
    return ((1 << bits(field)) - 1) << field["low"]
