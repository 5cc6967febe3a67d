# SPDX-License-Identifier: Apache-2.0
"""Sums, products, magnitudes and left shifts."""

from __future__ import annotations

from collections.abc import Sequence

from .node import Node, const, is_const, make_node


def add(*terms: Node) -> Node:
    flat, constant = [], 0
    for term in terms:
        for t in term.args if term.op == "add" else (term,):
            if is_const(t):
                constant += t.number
            else:
                flat.append(t)
    if constant or not flat:
        flat.append(const(constant))
    if len(flat) == 1:
        return flat[0]
    low, high = sum(t.low for t in flat), sum(t.high for t in flat)
    return make_node("add", flat, None, low, high, disjoint_ones(flat))


def disjoint_ones(terms: Sequence[Node]) -> int | None:
    """The union of the bits of terms that never have a one in the same place, else None."""
    union = 0
    for t in terms:
        if t.ones is None or union & t.ones:
            return None
        union |= t.ones
    return union


def sub(a: Node, b: Node) -> Node:
    if is_const(b):
        return add(a, const(-b.number))
    if a is b:
        return const(0)
    if b.op == "sub" and is_const(a, 0):
        return sub(b.args[1], b.args[0])
    if a.op == "shl" and a.args[0] is b:
        return mul(b, const((1 << a.number) - 1))
    magnitude = _as_absolute(a, b)
    return magnitude or make_node("sub", (a, b), None, a.low - b.high, a.high - b.low)


def _as_absolute(a: Node, b: Node) -> Node | None:
    """(d xor s) - s with s the sign of d, as -1 or 0, is |d|."""
    if b.low == -1 and b.high == 0 and a.op == "xor" and b in a.args:
        d = a.args[0] if a.args[1] is b else a.args[1]
        if _is_sign_of(b, d):
            return absolute(d)
    return None


def _is_sign_of(sign: Node, d: Node) -> bool:
    return sign.op == "shr" and sign.args[0] is d and (1 << sign.number) > max(d.high, -d.low - 1)


def absolute(a: Node) -> Node:
    if is_const(a):
        return const(abs(a.number))
    if a.low >= 0:
        return a
    return make_node("abs", (a,), None, 0 if a.high >= 0 else -a.high, max(-a.low, a.high))


def folded(a: Node) -> Node:
    """a, or its complement -1-a where it is negative."""
    if is_const(a):
        return const(a.number if a.number >= 0 else -1 - a.number)
    if a.low >= 0:
        return a
    return make_node("folded", (a,), None, 0, max(a.high, -a.low - 1))


def positive(a: Node) -> Node:
    """a, or 0 where it is negative."""
    if a.low >= 0:
        return a
    return const(0) if a.high <= 0 else make_node("positive", (a,), None, 0, a.high)


def mul(a: Node, b: Node) -> Node:
    if is_const(a):
        a, b = b, a
    if is_const(a):
        return const(a.number * b.number)
    if is_const(b):
        if b.number == 0:
            return b
        if b.number > 0 and b.number & (b.number - 1) == 0:
            return shift_left(a, b.number.bit_length() - 1)
    ends = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
    return make_node("mul", (a, b), None, 0 if a is b and min(ends) < 0 else min(ends), max(ends))


def shift_left(a: Node, count: int) -> Node:
    if count == 0 or is_const(a, 0):
        return a
    if is_const(a):
        return const(a.number << count)
    if a.op == "shl":
        return shift_left(a.args[0], a.number + count)
    return make_node("shl", (a,), count, a.low << count, a.high << count, None if a.ones is None else a.ones << count)
