# SPDX-License-Identifier: Apache-2.0
"""One rule for each kind of combinational instance that Bambu writes: what it computes, as a netlist expression.

A rule gets a Cell and returns a whole number; the caller wraps it to the width of the output. Signedness comes from the
types of the connected signals, so a rule serves the signed and the unsigned variant ("ui_" prefix) alike.
"""

from collections.abc import Callable
from dataclasses import dataclass

from ...base.errors import EXIT_TOOL_FAILED, FlowError
from .expressions import (
    Node,
    absolute,
    add,
    bit_and,
    bit_not,
    bit_or,
    bitwise,
    const,
    equal,
    is_const,
    less,
    mul,
    mux,
    shift_left,
    shift_right,
    sub,
    wrap,
)


@dataclass(frozen=True)
class Cell:
    """One instance with its inputs as nodes."""

    kind: str
    generics: dict[str, str]
    inputs: dict[str, Node]
    name: str = ""

    def __getitem__(self, port: str) -> Node:
        if port not in self.inputs:
            raise FlowError(f"instance {self.name} ({self.kind}) has no port {port}", EXIT_TOOL_FAILED)
        return self.inputs[port]

    def constant(self, port: str) -> int:
        node = self[port]
        if not is_const(node):
            raise FlowError(f"instance {self.name} ({self.kind}) needs a constant on {port}", EXIT_TOOL_FAILED)
        return node.number

    def generic(self, name: str) -> int:
        try:
            return int(self.generics[name])
        except (KeyError, ValueError):
            raise FlowError(f"instance {self.name} ({self.kind}) has no number {name}", EXIT_TOOL_FAILED) from None


Rule = Callable[[Cell], Node]


def _nonzero(node: Node) -> Node:
    return bit_not(equal(node, const(0)))


def _look_up(table: int, inputs: list[Node]) -> Node:
    """Bit number (..., in3, in2) of a truth table, as multiplexers over the inputs from the last to the first."""
    if not inputs:
        return const(table & 1)
    half = 1 << (len(inputs) - 1)
    mask = (1 << half) - 1
    return mux(inputs[-1], _look_up(table >> half & mask, inputs[:-1]), _look_up(table & mask, inputs[:-1]))


def _lut(cell: Cell) -> Node:
    return _look_up(cell.constant("in1"), [cell[f"in{n}"] for n in range(2, 10)])


def _shift_amount(cell: Cell) -> int:
    return cell.constant("in2") % cell.generic("PRECISION")


def _funnel_left(cell: Cell) -> Node:
    """The upper word of in1:in2 shifted left by in3."""
    count = cell.constant("in3") % cell.generic("PRECISION")
    return bitwise("or", shift_left(cell["in1"], count), shift_right(cell["in2"], cell.generic("PRECISION") - count))


def _concat(cell: Cell) -> Node:
    offset = cell.generic("OFFSET_PARAMETER")
    return add(shift_left(shift_right(cell["in1"], offset), offset), wrap(cell["in2"], offset))


# Kinds that give what comes in.
_SAME = (
    "UUdata_converter_FU",
    "UIdata_converter_FU",
    "IUdata_converter_FU",
    "IIdata_converter_FU",
    "addr_expr_FU",
    "ASSIGN_UNSIGNED_FU",
    "ASSIGN_SIGNED_FU",
    "view_convert_expr_FU",
    "ui_view_convert_expr_FU",
)
# Kinds with a signed and an unsigned variant: NAME_expr_FU and ui_NAME_expr_FU.
_EITHER: dict[str, Rule] = {
    "plus": lambda c: add(c["in1"], c["in2"]),
    "minus": lambda c: sub(c["in1"], c["in2"]),
    "mult": lambda c: mul(c["in1"], c["in2"]),
    "pointer_plus": lambda c: add(c["in1"], c["in2"]),
    "ternary_plus": lambda c: add(c["in1"], c["in2"], c["in3"]),
    "ternary_pm": lambda c: sub(add(c["in1"], c["in2"]), c["in3"]),
    "ternary_mp": lambda c: add(sub(c["in1"], c["in2"]), c["in3"]),
    "ternary_mm": lambda c: sub(sub(c["in1"], c["in2"]), c["in3"]),
    "negate": lambda c: sub(const(0), c["in1"]),
    "bit_not": lambda c: sub(const(-1), c["in1"]),
    "bit_and": lambda c: bitwise("and", c["in1"], c["in2"]),
    "bit_ior": lambda c: bitwise("or", c["in1"], c["in2"]),
    "bit_xor": lambda c: bitwise("xor", c["in1"], c["in2"]),
    "bit_ior_concat": _concat,
    "lt": lambda c: less(c["in1"], c["in2"]),
    "gt": lambda c: less(c["in2"], c["in1"]),
    "le": lambda c: bit_not(less(c["in2"], c["in1"])),
    "ge": lambda c: bit_not(less(c["in1"], c["in2"])),
    "eq": lambda c: equal(c["in1"], c["in2"]),
    "ne": lambda c: bit_not(equal(c["in1"], c["in2"])),
    "cond": lambda c: mux(_nonzero(c["in1"]), c["in2"], c["in3"]),
    "min": lambda c: mux(less(c["in1"], c["in2"]), c["in1"], c["in2"]),
    "max": lambda c: mux(less(c["in1"], c["in2"]), c["in2"], c["in1"]),
    "lshift": lambda c: shift_left(c["in1"], _shift_amount(c)),
    "rshift": lambda c: shift_right(c["in1"], _shift_amount(c)),
    "extract_bit": lambda c: wrap(shift_right(c["in1"], c.constant("in2")), 1),
}
RULES: dict[str, Rule] = {
    **dict.fromkeys(_SAME, lambda c: c["in1"]),
    **{f"{prefix}{name}_expr_FU": rule for name, rule in _EITHER.items() for prefix in ("", "ui_")},
    "__builtin_abs": lambda c: absolute(c["in1"]),
    "MUX_GATE": lambda c: mux(c["sel"], c["in1"], c["in2"]),
    "lut_expr_FU": _lut,
    "ui_fshl_expr_FU": _funnel_left,
    "truth_and_expr_FU": lambda c: bit_and(_nonzero(c["in1"]), _nonzero(c["in2"])),
    "truth_or_expr_FU": lambda c: bit_or(_nonzero(c["in1"]), _nonzero(c["in2"])),
    "truth_not_expr_FU": lambda c: equal(c["in1"], const(0)),
}


def apply_rule(cell: Cell) -> Node:
    rule = RULES.get(cell.kind)
    if rule is None:
        raise FlowError(f"no lowering rule for instance kind '{cell.kind}' (instance {cell.name})", EXIT_TOOL_FAILED)
    return rule(cell)
