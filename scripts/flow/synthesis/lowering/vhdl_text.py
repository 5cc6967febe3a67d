# SPDX-License-Identifier: Apache-2.0
"""Netlist nodes as VHDL text.

Single bits are boolean, numbers of up to 31 bits are integers of a declared range (GHDL runs them more than ten times
as fast as bit vectors, and a range that is left is an error instead of a silent wrap), wider words are `unsigned`.
"""

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import Node, const, disjoint_ones

COMPARISONS = {"lt": "<", "ge": ">=", "eq": "=", "ne": "/="}

FUNCTIONS = {"abs": "magnitude", "folded": "folded", "positive": "positive_part"}


def without_outer_parentheses(text: str) -> str:
    """The same text without the parentheses that enclose the whole."""
    if not text.startswith("("):
        return text
    depth = 0
    for at, character in enumerate(text):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if depth == 0:
            return text[1:-1] if at == len(text) - 1 else text
    return text


def is_wide(node: Node) -> bool:
    return node.high >= 1 << 31 or node.low < -(1 << 31)


def type_of(low: int, high: int) -> str:
    if low >= 0 and high <= 1:
        return "boolean"
    if high >= 1 << 31:
        return f"unsigned({high.bit_length() - 1} downto 0)"
    return f"{'natural' if low >= 0 else 'integer'} range {low} to {high}"


def _placed(term: Node) -> list[tuple[int, Node]]:
    """(lowest bit, value) of a term of a concatenation; a constant gives one for each run of its ones."""
    if term.op == "shl":
        return [(term.number, term.args[0])]
    if term.op != "const" or not term.number:
        return [(0, term)]
    places, rest = [], term.number
    while rest:
        low = (rest & -rest).bit_length() - 1
        length = (~(rest >> low) & (rest >> low) + 1).bit_length() - 1
        places.append((low, const((1 << length) - 1)))
        rest &= ~(((1 << length) - 1) << low)
    return places


def _has_safe_difference(a: Node, b: Node) -> bool:
    """Whether two numbers are better compared by the sign of their difference: a subtraction becomes one carry chain
    everywhere, a comparison only in some tools. Tests against constants are smaller as they are."""
    limit = 1 << 30
    return not any(n.op == "const" or n.low < -limit or n.high >= limit for n in (a, b))


# {id(node): (name, wide)} of nodes that have one.
Names = dict[int, tuple[str, bool]]


class Writer:
    """Writes expressions; `names` may grow while it writes."""

    def __init__(self, names: Names) -> None:
        self.names = names

    def _name(self, node: Node) -> str:
        name, _ = self.names[id(node)]
        return name

    def condition(self, node: Node) -> str:
        """A boolean expression, with parentheses where a neighbour could bind to it."""
        if id(node) in self.names:
            return self._name(node)
        if node.op == "const":
            return "true" if node.number else "false"
        if node.op in COMPARISONS:
            a, b = node.args
            if a.is_bit and b.is_bit:
                return f"({self.condition(a)} {COMPARISONS[node.op]} {self.condition(b)})"
            if node.op in ("lt", "ge") and _has_safe_difference(a, b):
                return f"(({self.number(a)} - {self.number(b)}) {COMPARISONS[node.op]} 0)"
            return f"({self.number(a)} {COMPARISONS[node.op]} {self.number(b)})"
        if node.op in ("and", "or") and node.param is None:
            return "(" + f" {node.op} ".join(self.condition(a) for a in node.args) + ")"
        if node.op == "not":
            return f"(not {self.condition(node.args[0])})"
        return f"({self.number(node)} = 1)"

    def number(self, node: Node) -> str:
        """An integer expression."""
        if node.op == "const":
            return str(node.number) if node.number >= 0 else f"({node.number})"
        if id(node) in self.names:
            name, wide = self.names[id(node)]
            if node.is_bit and not wide:
                return f"as_number({name})"
            return f"to_integer({name})" if wide else name
        if node.is_bit and (node.op in COMPARISONS or node.op in ("and", "or", "not") and node.param is None):
            return f"as_number({self.condition(node)})"
        if is_wide(node):
            raise FlowError(f"no integer for a value of {node.width} bits: {node.op}", EXIT_TOOL_FAILED)
        return self._arithmetic(node)

    def _arithmetic(self, node: Node) -> str:
        if node.op == "add":
            # negative constants as subtractions, last
            terms = sorted(node.args, key=lambda t: t.op == "const")
            text = self.number(terms[0])
            for term in terms[1:]:
                negative = term.op == "const" and term.number < 0
                text += f" - {-term.number}" if negative else f" + {self.number(term)}"
            return f"({text})"
        if node.op == "sub":
            return f"({self.number(node.args[0])} - {self.number(node.args[1])})"
        if self._is_bitwise(node):
            return f"to_integer({self._bitwise(node, node.width)})"
        if node.op == "mul":
            return f"({self.number(node.args[0])} * {self.number(node.args[1])})"
        if node.op in FUNCTIONS:
            return f"{FUNCTIONS[node.op]}({without_outer_parentheses(self.number(node.args[0]))})"
        if node.op == "shl":
            return f"({self.number(node.args[0])} * {1 << node.number})"
        if node.op == "wrap":
            return self._wrapped(node)
        if node.op == "shr":
            return self._shifted(node)
        raise FlowError(f"no VHDL for the operation '{node.op}' on {node.width} bits", EXIT_TOOL_FAILED)

    @staticmethod
    def _is_bitwise(node: Node) -> bool:
        """Word by word, not a condition, on numbers that are never negative."""
        return node.op in ("and", "or", "xor") and node.param is not None and all(a.low >= 0 for a in node.args)

    def _bitwise(self, node: Node, width: int) -> str:
        a, b = (self.word(argument, width) for argument in node.args)
        return f"(({a}) {node.op} ({b}))"

    def _wrapped(self, node: Node) -> str:
        (a,), (width, signed) = node.args, node.wrapping
        base, low = (a.args[0], a.number) if a.op == "shr" else (a, 0)
        if self._is_wide_name(base) and not signed:
            return f"to_integer({self._name(base)}({low + width - 1} downto {low}))"
        if signed:
            half = 1 << (width - 1)
            return f"((({self.number(a)} + {half}) mod {2 * half}) - {half})"
        return f"({self.number(a)} mod {1 << width})"

    def _shifted(self, node: Node) -> str:
        (a,), low = node.args, node.number
        if self._is_wide_name(a):
            return f"to_integer({self._name(a)}({a.width - 1} downto {low}))"
        if a.low < 0:
            raise FlowError("no VHDL for an arithmetic right shift of a negative number", EXIT_TOOL_FAILED)
        return f"({self.number(a)} / {1 << low})"

    def _is_wide_name(self, node: Node) -> bool:
        return id(node) in self.names and self.names[id(node)][1]

    def word(self, node: Node, width: int) -> str:
        """An `unsigned(width-1 downto 0)` expression."""
        if id(node) in self.names and self.names[id(node)][1]:
            name = self._name(node)
            return name if node.width == width else f"resize({name}, {width})"
        if self._is_bitwise(node):
            return self._bitwise(node, width)
        if is_wide(node) or node.op in ("add", "shl"):
            return self._concatenated(node, width)
        return f"to_unsigned({self.number(node)}, {width})"

    def _concatenated(self, node: Node, width: int) -> str:
        """A sum of terms that share no bit, from the highest to the lowest."""
        terms = node.args if node.op == "add" else (node,)
        parts = []
        if disjoint_ones(terms) is not None:
            parts = sorted((part for t in terms for part in _placed(t)), key=lambda part: -part[0])
        if not parts or (len(parts) == 1 and parts[0][0] == 0):
            if is_wide(node):
                raise FlowError(f"no VHDL for the operation '{node.op}' on {node.width} bits", EXIT_TOOL_FAILED)
            return f"to_unsigned({self.number(node)}, {width})"
        texts, top = [], width
        for offset, term in parts:
            texts.append(self._slice(term, top - offset))
            top = offset
        if top:
            texts.append(f"to_unsigned(0, {top})")
        return " & ".join(texts)

    def _slice(self, node: Node, width: int) -> str:
        """`node`, known to fit, as a vector of `width` bits; slices of words stay slices, words within words words."""
        base, high, low = node, node.width - 1, 0
        if node.op == "wrap":
            base, high = node.args[0], node.wrapping[0] - 1
        if base.op == "shr":
            low = base.number
            high, base = high + low if node.op == "wrap" else base.args[0].width - 1, base.args[0]
        if self._is_wide_name(base) and high - low + 1 == width:
            return f"{self._name(base)}({high} downto {low})"
        if is_wide(node):
            return self.word(node, width)
        return f"to_unsigned({self.number(node)}, {width})"
