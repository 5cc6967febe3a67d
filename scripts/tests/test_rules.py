# SPDX-License-Identifier: Apache-2.0
"""Each lowering rule against bit-vector arithmetic as VHDL's numeric_std defines it, exhaustively for small widths."""

import itertools

import pytest

from flow.base.errors import FlowError
from flow.synthesis.lowering import expressions as n, netlist
from flow.synthesis.lowering.evaluate import compile_step
from flow.synthesis.lowering.rules import RULES, Cell, apply_rule


def resized(value, width, signed):
    """The number that the lowest `width` bits of a two's complement value mean."""
    bits = value % (1 << width)
    return bits - (1 << width) if signed and bits >= 1 << (width - 1) else bits


def lookup(i):
    index = sum(i[f"in{k}"] << (k - 2) for k in range(2, 10))
    return i["in1"] >> index & 1


def comparison(operation):
    return lambda i, g: int(operation(i["in1"], i["in2"]))


# kind without prefix -> (number of inputs, what the output is before it is cut to its width)
EITHER = {
    "plus": (2, lambda i, g: i["in1"] + i["in2"]),
    "pointer_plus": (2, lambda i, g: i["in1"] + i["in2"]),
    "minus": (2, lambda i, g: i["in1"] - i["in2"]),
    "mult": (2, lambda i, g: i["in1"] * i["in2"]),
    "ternary_plus": (3, lambda i, g: i["in1"] + i["in2"] + i["in3"]),
    "ternary_pm": (3, lambda i, g: i["in1"] + i["in2"] - i["in3"]),
    "ternary_mp": (3, lambda i, g: i["in1"] - i["in2"] + i["in3"]),
    "ternary_mm": (3, lambda i, g: i["in1"] - i["in2"] - i["in3"]),
    "negate": (1, lambda i, g: -i["in1"]),
    "bit_not": (1, lambda i, g: ~i["in1"]),
    "bit_and": (2, lambda i, g: i["in1"] & i["in2"]),
    "bit_ior": (2, lambda i, g: i["in1"] | i["in2"]),
    "bit_xor": (2, lambda i, g: i["in1"] ^ i["in2"]),
    "lt": (2, comparison(lambda a, b: a < b)),
    "le": (2, comparison(lambda a, b: a <= b)),
    "gt": (2, comparison(lambda a, b: a > b)),
    "ge": (2, comparison(lambda a, b: a >= b)),
    "eq": (2, comparison(lambda a, b: a == b)),
    "ne": (2, comparison(lambda a, b: a != b)),
    "cond": (3, lambda i, g: i["in2"] if i["in1"] != 0 else i["in3"]),
    "min": (2, lambda i, g: min(i["in1"], i["in2"])),
    "max": (2, lambda i, g: max(i["in1"], i["in2"])),
}
CONSTANT_SECOND = {
    "lshift": lambda i, g: i["in1"] << (i["in2"] % g["PRECISION"]),
    "rshift": lambda i, g: i["in1"] >> (i["in2"] % g["PRECISION"]),
    "extract_bit": lambda i, g: i["in1"] >> i["in2"] & 1,
}
SAME = (
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
OTHER = {
    "ui_fshl_expr_FU",
    "__builtin_abs",
    "MUX_GATE",
    "lut_expr_FU",
    "truth_and_expr_FU",
    "truth_or_expr_FU",
    "truth_not_expr_FU",
    "bit_ior_concat_expr_FU",
    "ui_bit_ior_concat_expr_FU",
}


def check(kind, inputs, out_width, signed, expected, generics=None, rng=None):
    """`inputs`: port -> (width, signed) or a constant. All values, or 400 random ones where there are more."""
    generics = generics or {}
    leaves = {p: n.leaf("input", p, *w) if isinstance(w, tuple) else n.const(w) for p, w in inputs.items()}
    cell = Cell(kind, {k: str(v) for k, v in generics.items()}, leaves, "under_test")
    node = n.wrap(apply_rule(cell), out_width, signed)
    free = {p: w for p, w in inputs.items() if isinstance(w, tuple)}
    step = compile_step(netlist.Netlist({p: leaves[p] for p in free}, {"out": node}))
    ranges = [range(-(1 << w - 1), 1 << w - 1) if s else range(1 << w) for w, s in free.values()]
    total = 1
    for values in ranges:
        total *= len(values)
    cases = itertools.product(*ranges) if total <= 5000 else ([rng.choice(r) for r in ranges] for _ in range(400))
    compared = 0
    for values in cases:
        given = {p: v for p, v in inputs.items() if not isinstance(v, tuple)} | dict(zip(free, values))
        want = resized(expected(given, generics), out_width, signed)
        got = step(dict(zip(free, values)), [], [])["out"]
        assert got == want, f"{kind} of {given}: expected {want}, got {got}"
        compared += 1
    assert compared > 0


@pytest.mark.parametrize("prefix,signed", [("", True), ("ui_", False)])
@pytest.mark.parametrize("name", EITHER)
def test_operator(name, prefix, signed, rng):
    count, expected = EITHER[name]
    for width, out_width in ((3, 3), (3, 5), (4, 2), (12, 12), (12, 14)):
        inputs = {f"in{k + 1}": (width, signed) for k in range(count)}
        check(
            f"{prefix}{name}_expr_FU",
            inputs,
            out_width,
            signed and name not in ("lt", "le", "gt", "ge", "eq", "ne"),
            expected,
            rng=rng,
        )


@pytest.mark.parametrize("prefix,signed", [("", True), ("ui_", False)])
@pytest.mark.parametrize("name", CONSTANT_SECOND)
@pytest.mark.parametrize("amount", [0, 1, 3, 7, 11])
def test_operator_with_constant(name, prefix, signed, amount, rng):
    out = (1, False) if name == "extract_bit" else (10, signed)
    check(
        f"{prefix}{name}_expr_FU",
        {"in1": (8, signed), "in2": amount},
        *out,
        CONSTANT_SECOND[name],
        {"PRECISION": 8},
        rng,
    )


@pytest.mark.parametrize("kind", SAME)
def test_conversion(kind, rng):
    for signed_in, signed_out in itertools.product((False, True), repeat=2):
        for out_width in (3, 6, 9):
            check(kind, {"in1": (6, signed_in)}, out_width, signed_out, lambda i, g: i["in1"], rng=rng)


def test_absolute(rng):
    check("__builtin_abs", {"in1": (9, True)}, 9, True, lambda i, g: abs(i["in1"]), rng=rng)


def test_multiplexer(rng):
    check(
        "MUX_GATE",
        {"sel": (1, False), "in1": (4, False), "in2": (4, False)},
        4,
        False,
        lambda i, g: i["in1"] if i["sel"] else i["in2"],
        rng=rng,
    )


@pytest.mark.parametrize("inputs", [1, 2, 3, 4])
def test_look_up_table(inputs, rng):
    tables = range(1 << (1 << inputs)) if inputs < 4 else [rng.randrange(1 << 16) for _ in range(200)]
    for table in tables:
        ports = {f"in{k}": (1, False) if k - 2 < inputs else 0 for k in range(2, 10)}
        check("lut_expr_FU", {"in1": table, **ports}, 1, False, lambda i, g: lookup(i), rng=rng)


@pytest.mark.parametrize("name", ["and", "or", "not"])
def test_truth_operator(name, rng):
    expected = {
        "and": lambda i, g: int(bool(i["in1"]) and bool(i["in2"])),
        "or": lambda i, g: int(bool(i["in1"]) or bool(i["in2"])),
        "not": lambda i, g: int(not i["in1"]),
    }[name]
    ports = {"in1": (2, False)} if name == "not" else {"in1": (2, False), "in2": (2, False)}
    check(f"truth_{name}_expr_FU", ports, 1, False, expected, rng=rng)


@pytest.mark.parametrize("prefix", ["", "ui_"])
@pytest.mark.parametrize("offset", [1, 3, 5])
def test_concatenation(prefix, offset, rng):
    def expected(i, g):
        return (i["in1"] >> offset << offset) | (i["in2"] & ((1 << offset) - 1))

    check(
        f"{prefix}bit_ior_concat_expr_FU",
        {"in1": (8, False), "in2": (6, False), "in3": offset},
        8,
        False,
        expected,
        {"OFFSET_PARAMETER": offset},
        rng,
    )


@pytest.mark.parametrize("amount", [1, 3, 6, 7])
def test_funnel_shift(amount, rng):
    def expected(i, g):
        return (i["in1"] << 8 | i["in2"]) << amount >> 8

    check(
        "ui_fshl_expr_FU",
        {"in1": (6, False), "in2": (8, False), "in3": amount},
        8,
        False,
        expected,
        {"PRECISION": 8},
        rng,
    )


def test_every_rule_is_tested():
    tested = set(SAME) | OTHER | {f"{p}{name}_expr_FU" for p in ("", "ui_") for name in [*EITHER, *CONSTANT_SECOND]}
    assert tested == set(RULES)


def test_unknown_kind_is_named():
    with pytest.raises(FlowError, match="no lowering rule for instance kind 'mystery_FU' .instance m0."):
        apply_rule(Cell("mystery_FU", {}, {}, "m0"))


def test_a_shift_by_a_signal_is_refused():
    with pytest.raises(FlowError, match="needs a constant on in2"):
        apply_rule(
            Cell(
                "lshift_expr_FU",
                {"PRECISION": "8"},
                {"in1": n.leaf("input", "a", 4), "in2": n.leaf("input", "b", 2)},
                "s0",
            )
        )
