# SPDX-License-Identifier: Apache-2.0
"""Truth tables of nets, and halves of a CCU2C as two of them.

Half of a CCU2C is a look-up table of four inputs p, a carry that goes through where p is 1, and a second table g of the
inputs A and B that gives the carry where p is 0; its sum output is p xor the carry that comes in.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations, product
from typing import Any, Union

Bit = Union[int, str]  # a net of yosys's netlist, or "0", "1", "x"
Cell = dict[str, Any]
PINS = "ABCD"


@dataclass(frozen=True)
class Table:
    """A function of nets: bit i of `ones` is its value where the nets have the bits of i, the first the lowest."""

    nets: tuple[Bit, ...]
    ones: int

    def at(self, values: dict[Bit, int]) -> int:
        return self.ones >> sum(values[net] << place for place, net in enumerate(self.nets)) & 1


def tabulate(nets: tuple[Bit, ...], function: Any) -> Table:
    """The table of function({net: value}), without the nets that it does not depend on."""
    for net in nets:
        rest = tuple(n for n in nets if n != net)
        if all(function(v | {net: 0}) == function(v | {net: 1}) for v in assignments(rest)):
            return tabulate(rest, lambda v, net=net: function(v | {net: 0}))
    return Table(nets, sum(function(v) << i for i, v in enumerate(assignments(nets))))


def assignments(nets: tuple[Bit, ...]) -> Iterator[dict[Bit, int]]:
    for values in product((0, 1), repeat=len(nets)):
        yield dict(zip(nets, reversed(values)))


def look_up(cell: Cell, init: str, pins: tuple[str, ...]) -> Table:
    """What a look-up table of a cell says; pins that are not connected count as 1."""
    ones = int(cell["parameters"][init], 2)
    bits = [cell["connections"].get(pin, ["1"]) or ["1"] for pin in pins]
    held = [bit[0] for bit in bits]
    nets = tuple(dict.fromkeys(bit for bit in held if isinstance(bit, int)))

    def value(values: dict[Bit, int]) -> int:
        known = {"0": 0, "1": 1, "x": 0} | values
        return ones >> sum(known[bit] << place for place, bit in enumerate(held)) & 1

    return tabulate(nets, value)


@dataclass(frozen=True)
class Half:
    """`carry` counts only where `through` is 0, and is None where no carry is needed; `out` is None where nobody reads
    the sum."""

    through: Table
    carry: Table | None
    out: Bit | None

    @property
    def nets(self) -> tuple[Bit, ...]:
        return tuple(dict.fromkeys(self.through.nets + (self.carry.nets if self.carry else ())))

    def fit(self) -> tuple[list[Bit], int] | None:
        """(nets of A, B, C, D; INIT) of a half that does this, or None. INIT's lowest four bits are the table of the
        carry, and also that of `through` where C and D are 0: so with two or three nets D is 1."""
        nets = self.nets
        if len(nets) > 4:
            return None
        for generate in combinations(nets, min(2, len(nets))):
            others = [net for net in nets if net not in generate]
            pins: list[Bit] = [*generate, *["1"] * (2 - len(generate)), *others, *["1"] * (2 - len(others))]
            init = self._init(pins)
            if init is not None:
                return pins, init
        return None

    def _init(self, pins: list[Bit]) -> int | None:
        table: list[int | None] = [None] * 16
        for values in assignments(self.nets):
            row = sum((1 if pin == "1" else values[pin]) << place for place, pin in enumerate(pins))
            through = self.through.at(values)
            carry = [] if through or self.carry is None else [(row & 3, self.carry.at(values))]
            for place, wanted in [(row, through), *carry]:
                if table[place] not in (None, wanted):
                    return None
                table[place] = wanted
        return sum((bit or 0) << place for place, bit in enumerate(table))


def constant(value: int) -> Table:
    return Table((), value)


def identity(net: Bit) -> Table:
    return constant(int(net == "1")) if isinstance(net, str) else Table((net,), 2)


def with_input(table: Table, net: Bit, inner: Table) -> Table:
    """The table with another one in the place of a net."""
    if net not in table.nets:
        return table
    nets = tuple(dict.fromkeys([n for n in table.nets if n != net] + list(inner.nets)))
    return tabulate(nets, lambda values: table.at(values | {net: inner.at(values)}))


def first_carry(half: Half, start: Bit) -> Table:
    """The carry out of the lowest half."""
    known = {"0": 0, "1": 1, "x": 0}
    nets = half.nets if isinstance(start, str) else tuple(dict.fromkeys((*half.nets, start)))

    def value(values: dict[Bit, int]) -> int:
        if half.through.at(values):
            return known[start] if isinstance(start, str) else values[start]
        return half.carry.at(values) if half.carry else 0

    return tabulate(nets, value)


def opposite(table: Table) -> Table:
    return Table(table.nets, ~table.ones & ((1 << (1 << len(table.nets))) - 1))


def with_opposite_carry(half: Half) -> Half:
    """The half in a chain where each carry is the opposite. What it gives out stays."""
    through = half.through if half.out is None else opposite(half.through)
    return Half(through, opposite(half.carry) if half.carry else None, half.out)
