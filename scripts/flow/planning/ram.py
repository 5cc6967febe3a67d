# SPDX-License-Identifier: Apache-2.0
"""What a family's RAMs a memory becomes: the choice of yosys' memory_libmap among the shapes of a family, for the one
kind of memory that cores have, with a read and a write a clock (hls/rtl/line_memory.vhd)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache

from .devices import netlist_of
from .window_memories import Memory

_COLUMN_BITS = 36  # line_memory.vhd divides wider words into equal columns
# yosys weighs a multiplexer's or an address decoder's bit with a half, a flip-flop with one, and each point of logic
# around a RAM with 8: one for a port that only reads, three for each of the two halves of a bypass where a read must
# show the word before.
_BIT, _POINT, _READ_PORT, _BYPASS = 0.5, 8, 1, 6


@dataclass(frozen=True)
class Shape:
    """A RAM of 2 ** address_bits times its narrowest width, which trades addresses for width."""

    address_bits: int
    widths: tuple[int, ...]
    cost: int  # as yosys weighs it
    byte: int = 0  # widths come in multiples of this; 0: of the whole width
    needs_bypass: bool = True  # where a read must show the word before a write of the same clock
    by_width: bool = False  # a part of its width costs a part
    units: int = 1  # that it takes of the device's block RAMs


@dataclass(frozen=True)
class Family:
    """The shapes of brams.txt and lutrams.txt in yosys that a memory with a read and a write port can take."""

    blocks: tuple[Shape, ...]
    lut: Shape | None  # LUT RAM
    luts: int = 0  # that one takes
    lut_cell: str = ""  # its name in a netlist, where it leaves no place for flip-flops


_LUT_RAM = Shape(4, (4,), 4, needs_bypass=False)
_LATTICE_WIDTHS = (1, 2, 4, 9, 18, 36)
# By the names of the targets, or of what their netlists are made for.
FAMILIES = {
    "ecp5": Family((Shape(14, _LATTICE_WIDTHS, 128, 9),), _LUT_RAM, 6),
    "nexus": Family((Shape(14, _LATTICE_WIDTHS, 128, 9, needs_bypass=False),), _LUT_RAM, 6),
    "gowin": Family((Shape(14, _LATTICE_WIDTHS, 128, 9),), replace(_LUT_RAM, by_width=True), 6, "RAM16SDP4"),
    "ice40": Family((Shape(11, (2, 4, 8, 16), 64, 1),), None),
    # Of 20 kbit, and two of them as one.
    "gatemate": Family(
        (Shape(14, (1, 2, 5, 10, 20, 40), 129, 1), Shape(15, (1, 2, 5, 10, 20, 40, 80), 257, 1, units=2)), None
    ),
}


@dataclass(frozen=True)
class Mapped:
    """What memories take of a device."""

    block_rams: int = 0
    block_units: int = 0  # the same as the device counts them
    lut_rams: int = 0
    choice_bits: int = 0  # that are chosen among RAMs behind each other, one bit for each RAM more

    def __add__(self, other: Mapped) -> Mapped:
        return Mapped(
            self.block_rams + other.block_rams,
            self.block_units + other.block_units,
            self.lut_rams + other.lut_rams,
            self.choice_bits + other.choice_bits,
        )


def family_of(target: str) -> Family | None:
    """None where nothing is known of the RAMs."""
    return FAMILIES.get(netlist_of(target))


def _columns(width: int) -> list[int]:
    count = -(-width // _COLUMN_BITS)
    bits = -(-width // count)
    return [min(bits, width - column * bits) for column in range(count)]


def _choices(shape: Shape, memory: Memory, is_block: bool, shows_word_before: bool) -> Iterator[tuple[float, Mapped]]:
    """(its cost, what a memory becomes) with each width of a RAM."""
    points = _READ_PORT + (_BYPASS if shows_word_before and shape.needs_bypass else 0)
    for halvings, width in enumerate(shape.widths):
        byte = shape.byte if 0 < shape.byte <= width else width
        deep = -(-memory.depth // (1 << (shape.address_bits - halvings)))
        rams = -(-deep * (-(-memory.width // byte) * byte) // width)
        choice_bits = (deep - 1) * memory.width
        decoder_bits = deep if deep > 1 else 0
        paid = deep * memory.width / width if shape.by_width else rams
        cost = shape.cost * paid + _BIT * (choice_bits + decoder_bits) + _POINT * points
        if is_block:
            yield cost, Mapped(rams, rams * shape.units, 0, choice_bits)
        else:
            yield cost, Mapped(0, 0, rams, choice_bits)


def mapped(memories: Iterable[Memory], family: Family, shows_word_before: bool) -> Mapped:
    """shows_word_before: that of a collision counts, as it does where yosys is not told that none does. Where nothing
    is cheaper, a memory becomes flip-flops."""
    total = Mapped()
    for whole in memories:
        for width in _columns(whole.width):
            total += _column(Memory(whole.depth, width), family, shows_word_before)
    return total


@cache
def _column(memory: Memory, family: Family, shows_word_before: bool) -> Mapped:
    choices = [(float(memory.depth * memory.width), Mapped())]
    if family.lut:
        choices += _choices(family.lut, memory, False, shows_word_before)
    for shape in family.blocks:
        choices += _choices(shape, memory, True, shows_word_before)
    return min(choices, key=lambda choice: choice[0])[1]
