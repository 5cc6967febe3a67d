# SPDX-License-Identifier: Apache-2.0
"""Words and conditions: wrapping, right shifts, choices, comparisons and bit operations. They stand in one file because
each simplifies with the help of the others."""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable
from typing import NamedTuple

from .arithmetic import add, disjoint_ones, folded, mul, positive, shift_left, sub
from .node import Node, const, interval, is_const, make_node

LONG = 1 << 31  # no integer of VHDL
# Operations whose lowest bits follow from the lowest bits of their arguments.
_SUMS: dict[str, Callable[..., Node]] = {"add": add, "sub": sub, "mul": mul}


def wrap(a: Node, width: int, signed: bool = False) -> Node:
    """The value that remains in `width` bits."""
    low, high = interval(width, signed)
    if low <= a.low and a.high <= high:
        return a
    if a.op == "wrap" and a.wrapping[0] >= width:
        return wrap(a.args[0], width, signed)
    if is_const(a):
        value = a.number & ((1 << width) - 1)
        return const(value - (1 << width) if signed and value >> (width - 1) else value)
    if a.low == -1 and a.high == 0 and not signed:
        return mux(less(a, const(0)), const((1 << width) - 1), const(0))
    if a.op in ("and", "or", "xor") and a.param is not None and not signed:
        return bitwise(a.op, wrap(a.args[0], width), wrap(a.args[1], width))
    if a.op == "mux":
        return mux(a.args[0], wrap(a.args[1], width, signed), wrap(a.args[2], width, signed))
    if a.op == "shl" and not signed:
        return shift_left(wrap(a.args[0], width - a.number), a.number) if a.number < width else const(0)
    if a.op in _SUMS:
        terms = [_of_width(term, width) for term in a.args]
        if any(new is not old for new, old in zip(terms, a.args)):
            return wrap(_SUMS[a.op](*terms), width, signed)
    if a.op == "add" and not signed and disjoint_ones(a.args) is not None:
        return add(*[wrap(term, width) for term in a.args])
    if a.op == "add" and not signed:
        kept = [term for term in a.args if not _multiple_of(term, width)]
        if len(kept) < len(a.args):
            return wrap(add(*kept), width)
    ones = a.ones & high if not signed and a.ones is not None else None
    if ones is not None:
        high = min(high, ones)
    return make_node("wrap", (a,), (width, signed), low, high, ones)


def _of_width(node: Node, width: int) -> Node:
    """A term of a sum or product of which only the lowest `width` bits count: without a wrapping to more bits, and not
    longer than an integer where that can be avoided."""
    inner = node.args[0] if node.op == "wrap" and node.wrapping[0] >= width else node
    if inner.low >= -LONG and inner.high < LONG:
        return inner
    return wrap(inner, width) if 1 << width < LONG else node


def _fits_signed(a: Node, width: int) -> bool:
    low, high = interval(width, signed=True)
    return low <= a.low and a.high <= high


def _multiple_of(node: Node, width: int) -> bool:
    return node.op == "shl" and node.number >= width


def shift_right(a: Node, count: int) -> Node:
    """Division by 2**count, rounded down."""
    if count == 0:
        return a
    if is_const(a):
        return const(a.number >> count)
    if a.low >= 0 and a.high >> count == 0:
        return const(0)
    if a.op == "shr":
        return shift_right(a.args[0], a.number + count)
    if a.op == "wrap" and a.param == (count + 1, False) and _fits_signed(a.args[0], count + 1):
        return less(a.args[0], const(0))
    if a.op == "wrap" and a.high >= LONG and not a.wrapping[1]:
        return wrap(shift_right(a.args[0], count), a.wrapping[0] - count)
    if a.op == "shl" and a.number >= count:
        return shift_left(a.args[0], a.number - count)
    if a.op == "add" and disjoint_ones(a.args) is not None:
        return add(*[shift_right(t, count) for t in a.args])
    return make_node("shr", (a,), count, a.low >> count, a.high >> count, None if a.ones is None else a.ones >> count)


def mux(condition: Node, yes: Node, no: Node) -> Node:
    if is_const(condition):
        return yes if condition.number else no
    if yes is no:
        return yes
    if condition.op == "not":
        return mux(condition.args[0], no, yes)
    if yes.op == "mux" and yes.args[0] is condition:
        yes = yes.args[1]
    if no.op == "mux" and no.args[0] is condition:
        no = no.args[2]
    if yes.is_bit and no.is_bit:
        held = _held_bit(yes, no)
        if held is not None:
            return mux(held[0], condition, held[1])
        if yes is bit_not(no):
            return bit_xor(condition, no)
        if is_const(yes, 1):
            return bit_or(condition, no)
        if is_const(no, 0):
            return bit_and(condition, yes)
        if is_const(yes, 0):
            return bit_and(bit_not(condition), no)
        if is_const(no, 1):
            return bit_or(bit_not(condition), yes)
    if condition.op == "lt" and is_const(condition.args[1], 0):
        a = condition.args[0]
        if no.op == "wrap" and no.args[0] is a and a.high >> no.wrapping[0] == 0:
            no = positive(a)
        if no is positive(a) and yes.op == "sub" and _is_complement(yes, a):
            return folded(a)
    ones = None if yes.ones is None or no.ones is None else yes.ones | no.ones
    return make_node("mux", (condition, yes, no), None, min(yes.low, no.low), max(yes.high, no.high), ones)


def _is_complement(node: Node, a: Node) -> bool:
    """2**w - 1 - (a modulo 2**w), which is -1-a for the negative values that w bits hold."""
    top, low_bits = node.args
    if not is_const(top) or low_bits.op != "wrap" or low_bits.args[0] is not a:
        return False
    width, signed = low_bits.wrapping
    return not signed and top.number == (1 << width) - 1 and a.low >= -(1 << width)


def _held_bit(yes: Node, no: Node) -> tuple[Node, Node] | None:
    """(take, a) where a choice of `a or take` or `a and not take` gives its condition when `take`, else a."""
    of_bits = yes.op == "or" and no.op == "and" and yes.param is None and no.param is None
    if of_bits and len(yes.args) == len(no.args) == 2:
        for a, take in (yes.args, yes.args[::-1]):
            if a in no.args and bit_not(take) in no.args:
                return take, a
    return None


def bit_not(a: Node) -> Node:
    opposite = {"lt": "ge", "ge": "lt", "eq": "ne", "ne": "eq"}
    if is_const(a):
        return const(1 - a.number)
    if a.op == "not":
        return a.args[0]
    if a.op in opposite:
        return make_node(opposite[a.op], a.args, None, 0, 1)
    return make_node("not", (a,), None, 0, 1)


def bit_and(*args: Node) -> Node:
    node = _associative("and", args, neutral=1)
    return _joined_bits(node) if node.op == "and" else node


class _Field(NamedTuple):
    """A test of some neighbouring bits of a word."""

    word: Node
    low: int  # the lowest bit
    width: int
    wanted: int

    @property
    def end(self) -> int:
        return self.low + self.width


def _tested_field(node: Node) -> _Field | None:
    if node.op == "eq" and is_const(node.args[1]):
        part, wanted = node.args[0], node.args[1].number
    else:
        part, wanted = (node.args[0], 0) if node.op == "not" else (node, 1)
        if not part.is_bit:
            return None
    if part.low < 0 or part.op not in ("wrap", "shr") or (part.op == "wrap" and part.wrapping[1]):
        return None
    word = part.args[0] if part.op == "wrap" else part
    base, low = (word.args[0], word.number) if word.op == "shr" else (word, 0)
    return _Field(base, low, part.width, wanted)


def _joined_bits(node: Node) -> Node:
    """Tests of neighbouring bits of one word become one comparison: the tool splits comparisons with constants into
    bits."""
    words: dict[int, list[tuple[_Field, Node]]] = {}
    others = []
    for a in node.args:
        tested = _tested_field(a)
        if tested is None:
            others.append(a)
        else:
            words.setdefault(id(tested.word), []).append((tested, a))
    joined = False
    for tests in words.values():
        tests.sort(key=lambda test: test[0].low)
        fields = [field for field, _ in tests]
        if len(fields) > 1 and all(a.end == b.low for a, b in zip(fields, fields[1:])):
            others.append(_equals_all(fields))
            joined = True
        else:
            others += [a for _, a in tests]
    return _associative("and", others, neutral=1) if joined else node


def _equals_all(fields: list[_Field]) -> Node:
    """One comparison for fields that follow one another in a word."""
    word, low = fields[0].word, fields[0].low
    wanted = sum(field.wanted << (field.low - low) for field in fields)
    return equal(wrap(shift_right(word, low), fields[-1].end - low), const(wanted))


def bit_or(*args: Node) -> Node:
    return _associative("or", args, neutral=0)


def _associative(op: str, args: Iterable[Node], neutral: int) -> Node:
    flat = []
    for a in args:
        for b in a.args if a.op == op else (a,):
            if is_const(b, 1 - neutral):
                return b
            if not is_const(b) and b not in flat:
                flat.append(b)
    if not flat:
        return const(neutral)
    return flat[0] if len(flat) == 1 else make_node(op, flat, None, 0, 1)


def bit_xor(a: Node, b: Node) -> Node:
    if is_const(a):
        a, b = b, a
    if is_const(b):
        return bit_not(a) if b.number else a
    return const(0) if a is b else make_node("ne", (a, b), None, 0, 1)


def less(a: Node, b: Node) -> Node:
    if a.op == "shr" and is_const(b, 0):
        return less(a.args[0], b)
    if a.high < b.low:
        return const(1)
    if a.low >= b.high:
        return const(0)
    start = _start_of_range(a, b)
    if start is not None:  # start <= x < start + b
        x = a.args[0].args[0]
        return bit_and(bit_not(less(x, const(start))), less(x, const(start + b.number)))
    if _wraps_negatives_beyond(a, b):  # 0 <= x < b
        return bit_and(bit_not(less(a.args[0], const(0))), less(a.args[0], b))
    if _wraps_negatives_beyond(b, a):  # x < 0 or a < x
        return bit_or(less(b.args[0], const(0)), less(a, b.args[0]))
    return make_node("lt", (a, b), None, 0, 1)


def _start_of_range(node: Node, end: Node) -> int | None:
    """Where (x - start) modulo 2**w < end, with `start` added as 2**w - start, is a range check of x."""
    if node.op != "wrap" or node.wrapping[1] or node.args[0].op != "add" or not is_const(end):
        return None
    modulus, terms = 1 << node.wrapping[0], node.args[0].args
    if len(terms) != 2 or not is_const(terms[1]) or not end.number <= terms[1].number < modulus:
        return None
    return modulus - terms[1].number if terms[0].low >= 0 and terms[0].high < modulus else None


def _wraps_negatives_beyond(node: Node, other: Node) -> bool:
    """An unsigned comparison whose negative numbers count as more than any value of `other`: a range check."""
    if node.op != "wrap" or node.wrapping[1] or node.args[0].low >= 0 or other.low < 0:
        return False
    inner, modulus = node.args[0], 1 << node.wrapping[0]
    return inner.high < modulus and inner.low + modulus > other.high


def equal(a: Node, b: Node) -> Node:
    if a is b:
        return const(1)
    if a.high < b.low or b.high < a.low:
        return const(0)
    if is_const(a):
        a, b = b, a
    if a.is_bit and is_const(b):
        return a if b.number else bit_not(a)
    return make_node("eq", (a, b), None, 0, 1)


_OF_BITS: dict[str, Callable[[Node, Node], Node]] = {"and": bit_and, "or": bit_or, "xor": bit_xor}
_OF_NUMBERS: dict[str, Callable[[int, int], int]] = {"and": operator.and_, "or": operator.or_, "xor": operator.xor}


def bitwise(op: str, a: Node, b: Node) -> Node:
    """and, or, xor of whole numbers in two's complement."""
    if a.is_bit and b.is_bit:
        return _OF_BITS[op](a, b)
    if is_const(a):
        a, b = b, a
    if is_const(a) and is_const(b):
        return const(_OF_NUMBERS[op](a.number, b.number))
    if op == "and" and is_const(b) and b.number >= 0:
        return _masked(a, b.number)
    if op in ("or", "xor"):
        if is_const(b, 0):
            return a
        if disjoint_ones((a, b)) is not None:
            return add(a, b)
    if op == "xor":
        for choice, other in ((a, b), (b, a)):
            if choice.op == "mux" and is_const(choice.args[1]) and is_const(choice.args[2]):
                return mux(choice.args[0], *[bitwise("xor", other, arm) for arm in choice.args[1:]])
        if is_const(b) and a.ones is not None and b.number & (b.number + 1) == 0 and a.ones <= b.number:
            return sub(b, a)
    if a.low >= 0 and b.low >= 0:
        bits = max(a.width, b.width)
        return make_node(op, (a, b), bits, 0, (1 << bits) - 1)
    bits = max(a.width, b.width) + 1
    return make_node(op, (a, b), bits, -(1 << (bits - 1)), (1 << (bits - 1)) - 1)


def _masked(a: Node, mask: int) -> Node:
    """The bits of `a` under a mask, as a sum of its runs of ones."""
    runs, at = [], 0
    while mask >> at:
        if not mask >> at & 1:
            at += 1
            continue
        length = ((mask >> at) + 1 & -((mask >> at) + 1)).bit_length() - 1
        runs.append(shift_left(wrap(shift_right(a, at), length), at))
        at += length
    return add(*runs)
