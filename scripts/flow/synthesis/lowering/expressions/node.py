# SPDX-License-Identifier: Apache-2.0
"""The node of an expression, constants and leaves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Union

# What an operation has beside its arguments: the number of a constant, the name of a leaf, the places of a shift,
# (width, signed) of a wrap, the width of a bit operation on words. None of a bit operation on single bits, and of all
# others.
Parameter = Union[int, str, tuple[int, bool], None]


class Node:
    __slots__ = ("args", "high", "low", "ones", "op", "param")

    def __init__(
        self, op: str, args: tuple[Node, ...], param: Parameter, low: int, high: int, ones: int | None
    ) -> None:
        self.op, self.args, self.param = op, args, param
        self.low, self.high = low, high  # least and greatest value
        self.ones = ones  # bits that can be 1, for values that are never negative

    @property
    def is_bit(self) -> bool:
        return self.low >= 0 and self.high <= 1

    @property
    def width(self) -> int:
        """Bits of the value, including the sign bit where it can be negative."""
        if self.low >= 0:
            return max(self.high.bit_length(), 1)
        return max(self.high.bit_length(), (-self.low - 1).bit_length()) + 1

    @property
    def number(self) -> int:
        """The value of a constant, or the places of a shift."""
        assert isinstance(self.param, int), f"{self.op} has no number"
        return self.param

    @property
    def wrapping(self) -> tuple[int, bool]:
        """(width, signed) of a wrap."""
        assert isinstance(self.param, tuple), f"{self.op} wraps nothing"
        return self.param

    def __repr__(self) -> str:
        inner = ", ".join([repr(a) for a in self.args] + ([str(self.param)] if self.param is not None else []))
        return f"{self.op}({inner})"


_interned: dict[tuple[str, tuple[int, ...], Parameter, int, int], Node] = {}


def make_node(op: str, args: Sequence[Node], param: Parameter, low: int, high: int, ones: int | None = None) -> Node:
    """The one node of an operation on these arguments. `ones` None: any bit up to the highest of `high`."""
    key = (op, tuple(id(a) for a in args), param, low, high)
    found = _interned.get(key)
    if found is None:
        if ones is None:
            ones = (1 << high.bit_length()) - 1 if low >= 0 else None
        found = _interned[key] = Node(op, tuple(args), param, low, high, ones)
    return found


def const(value: int) -> Node:
    return make_node("const", (), value, value, value, value if value >= 0 else None)


def interval(width: int, signed: bool) -> tuple[int, int]:
    """(least, greatest) number of so many bits."""
    return (-(1 << (width - 1)), (1 << (width - 1)) - 1) if signed else (0, (1 << width) - 1)


def leaf(op: str, name: str, width: int, signed: bool = False) -> Node:
    """An input, a register's current value or a memory's read data."""
    return make_node(op, (), name, *interval(width, signed))


def is_const(node: Node, value: int | None = None) -> bool:
    return node.op == "const" and (value is None or node.param == value)
