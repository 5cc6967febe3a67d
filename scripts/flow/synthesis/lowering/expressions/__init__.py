# SPDX-License-Identifier: Apache-2.0
"""Expressions over whole numbers.

A node is a mathematical integer with the interval of its possible values, not a bit vector: wrapping is an operation of
its own (`wrap`), and disappears where the interval proves that nothing can wrap. Nodes are built by the functions
below, which simplify locally and give the same object for the same expression; so structural equality is identity.
"""

from .arithmetic import absolute, add, disjoint_ones, folded, mul, positive, shift_left, sub
from .bits import LONG, bit_and, bit_not, bit_or, bit_xor, bitwise, equal, less, mux, shift_right, wrap
from .node import Node, const, is_const, leaf
from .traversal import rebuild, walk

__all__ = [
    "LONG",
    "Node",
    "absolute",
    "add",
    "bit_and",
    "bit_not",
    "bit_or",
    "bit_xor",
    "bitwise",
    "const",
    "disjoint_ones",
    "equal",
    "folded",
    "is_const",
    "leaf",
    "less",
    "mul",
    "mux",
    "positive",
    "rebuild",
    "shift_left",
    "shift_right",
    "sub",
    "walk",
    "wrap",
]
