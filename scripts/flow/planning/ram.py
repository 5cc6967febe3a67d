# SPDX-License-Identifier: Apache-2.0
"""What a family's RAMs a memory becomes: the choice of yosys' memory_libmap among the shapes of a family, for the one
kind of memory that cores have, with a read and a write a clock (hls/rtl/line_memory.vhd)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .devices import netlist_of
from .window_memories import Memory

_COLUMN_BITS = 36  # line_memory.vhd divides wider words into equal columns
# yosys weighs a multiplexer's or an address decoder's bit with a half, and each point of logic around a RAM with 8: one
# for a port that only reads, three for each of the two halves of a bypass where a read must show the word before.
_BIT, _POINT, _READ_PORT, _BYPASS = 0.5, 8, 1, 6


@dataclass(frozen=True)
class Shape:
    """A RAM of 2 ** address_bits times its narrowest width, which trades addresses for width."""

    address_bits: int
    widths: tuple[int, ...]
    cost: int  # as yosys weighs it
    byte: int = 0  # widths come in multiples of this; 0: of the whole width
    needs_bypass: bool = False  # where a read must show the word before a write of the same clock


@dataclass(frozen=True)
class Family:
    block: Shape
    lut: Shape
    luts: int  # of a LUT RAM


FAMILIES = {
    "ecp5": Family(Shape(14, (1, 2, 4, 9, 18, 36), 128, 9, needs_bypass=True), Shape(4, (4,), 4), 6),
}


@dataclass(frozen=True)
class Mapped:
    """What memories take of a device."""

    block_rams: int = 0
    lut_rams: int = 0
    choice_bits: int = 0  # that are chosen among RAMs behind each other, one bit for each RAM more

    def __add__(self, other: Mapped) -> Mapped:
        return Mapped(
            self.block_rams + other.block_rams,
            self.lut_rams + other.lut_rams,
            self.choice_bits + other.choice_bits,
        )


@dataclass(frozen=True)
class _Choice:
    cost: float
    rams: int
    choice_bits: int


def family_of(target: str) -> Family | None:
    """None where nothing is known of the RAMs."""
    return FAMILIES.get(netlist_of(target))


def _columns(width: int) -> list[int]:
    count = -(-width // _COLUMN_BITS)
    bits = -(-width // count)
    return [min(bits, width - column * bits) for column in range(count)]


def _cheapest(shape: Shape, memory: Memory, points: int) -> _Choice:
    found = []
    for halvings, width in enumerate(shape.widths):
        byte = shape.byte if 0 < shape.byte <= width else width
        deep = -(-memory.depth // (1 << (shape.address_bits - halvings)))
        rams = -(-deep * (-(-memory.width // byte) * byte) // width)
        choice_bits = (deep - 1) * memory.width
        decoder_bits = deep if deep > 1 else 0
        cost = shape.cost * rams + _BIT * (choice_bits + decoder_bits) + _POINT * points
        found.append(_Choice(cost, rams, choice_bits))
    return min(found, key=lambda choice: choice.cost)


def mapped(memories: Iterable[Memory], family: Family, shows_word_before: bool) -> Mapped:
    """shows_word_before: that of a collision counts, as it does where yosys is not told that none does."""
    total = Mapped()
    for whole in memories:
        for width in _columns(whole.width):
            memory = Memory(whole.depth, width)
            bypass = _BYPASS if shows_word_before and family.block.needs_bypass else 0
            block = _cheapest(family.block, memory, _READ_PORT + bypass)
            lut = _cheapest(family.lut, memory, _READ_PORT)
            if block.cost < lut.cost:
                total += Mapped(block.rams, 0, block.choice_bits)
            else:
                total += Mapped(0, lut.rams, lut.choice_bits)
    return total
