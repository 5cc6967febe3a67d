# SPDX-License-Identifier: Apache-2.0
"""Walking through expressions, and building them again with other leaves."""

from collections.abc import Callable, Iterable, Mapping

from .arithmetic import absolute, add, folded, mul, positive, shift_left, sub
from .bits import bit_and, bit_not, bit_or, bitwise, equal, less, mux, shift_right, wrap
from .node import Node

_MAKE: dict[str, Callable[..., Node]] = {
    "add": add,
    "sub": sub,
    "mul": mul,
    "abs": absolute,
    "folded": folded,
    "positive": positive,
    "mux": mux,
    "not": bit_not,
    "lt": less,
    "ge": lambda a, b: bit_not(less(a, b)),
    "eq": equal,
    "ne": lambda a, b: bit_not(equal(a, b)),
}
_MAKE_OF_BITS = {"and": bit_and, "or": bit_or}


def walk(roots: Iterable[Node]) -> list[Node]:
    """Each node once, arguments before users."""
    seen, order = set(), []
    for root in roots:
        stack = [(root, False)]
        while stack:
            node, ready = stack.pop()
            if ready:
                order.append(node)
            elif id(node) not in seen:
                seen.add(id(node))
                stack.append((node, True))
                stack.extend((argument, False) for argument in reversed(node.args))
    return order


def rebuild(node: Node, replacement: Mapping[int, Node], done: dict[int, Node]) -> Node:
    """The same expression with some leaves replaced (id of the leaf -> node), simplified again. `done` caches
    results."""
    for n in walk([node]):
        if id(n) in done:
            continue
        if id(n) in replacement:
            done[id(n)] = replacement[id(n)]
        else:
            done[id(n)] = _again(n, [done[id(a)] for a in n.args])
    return done[id(node)]


def _again(node: Node, args: list[Node]) -> Node:
    """The operation of a node on other arguments."""
    if not args:
        return node
    if node.op == "wrap":
        return wrap(args[0], *node.wrapping)
    if node.op == "shl":
        return shift_left(args[0], node.number)
    if node.op == "shr":
        return shift_right(args[0], node.number)
    if node.op in _MAKE:
        return _MAKE[node.op](*args)
    if node.param is None:
        return _MAKE_OF_BITS[node.op](*args)
    return bitwise(node.op, *args)
