# SPDX-License-Identifier: Apache-2.0
"""Each step of the presentation by itself: what it makes, that it goes back, and where it must leave the text alone."""

import pytest

from flow.base import committed
from flow.base.errors import FlowError
from flow.synthesis.lowering.vhdl_text import type_of
from flow.synthesis.presentation import (
    arrays,
    carries,
    choices,
    defaults,
    extremes,
    loops,
    memories,
    records,
    scalars,
    slices,
    tree,
    widths,
)
from flow.synthesis.presentation.present import expand, present
from flow.synthesis.presentation.words import joined, split

FLAG, BYTE = type_of(0, 1), type_of(0, 255)


def read(text):
    return tree.read(split(text))


def written(statements):
    return [line.strip() for line in tree.lines(statements, "")]


@pytest.fixture
def text_of_tiny():
    return (committed.folder("tiny") / f"{committed.entity('tiny')}.vhd").read_text()


# --- choices and carries ----------------------------------------------------------------------------------------------

CHOICES = {
    "a register": ("if c then x <= a; else x <= b + 1; end if;", ["x <= choice(c, a, b + 1);"]),
    "a variable": ("if not c then x := a; else x := b; end if;", ["x := choice(not c, a, b);"]),
    "two registers": (
        "if c then x <= a; y <= 1; else x <= b; y <= 2; end if;",
        ["x <= choice(c, a, b);", "y <= choice(c, 1, 2);"],
    ),
    "inside of another": (
        "if c then if d then x <= a; else x <= b; end if; end if;",
        ["if c then", "x <= choice(d, a, b);", "end if;"],
    ),
    "the smaller number": ("if (a(1) - b) < 0 then x <= a(1); else x <= b; end if;", ["x <= smaller(a(1), b);"]),
    "the larger number": (
        "if (b - a) < 0 then x <= a; else x <= b; end if;",
        ["x <= choice((b - a) < 0, a, b);"],
    ),
    "another number than the smaller": (
        "if (a - b) < 0 then x <= a mod 8; else x <= b; end if;",
        ["x <= choice((a - b) < 0, a mod 8, b);"],
    ),
    "a carry": ("if c then x := a or y(3); else x := a and y(3); end if;", ["x := carry(c, a, y(3));"]),
    "a carry of a negation": (
        "if c then x := (not f(a, 1)) and b; else x := (not f(a, 1)) or b; end if;",
        ["x := inverted_carry(c, not f(a, 1), b);"],
    ),
    "a carry of sums of products": (
        "if c then x := (a and b) or (d); else x := (a and b) and (d); end if;",
        ["x := choice(c, (a and b) or (d), (a and b) and (d));"],  # parentheses around a name would be lost
    ),
    "other operands": (
        "if c then x := a or b; else x := a and d; end if;",
        ["x := choice(c, a or b, a and d);"],
    ),
    "the same operation": ("if c then x := a or b; else x := a or b; end if;", ["x := choice(c, a or b, a or b);"]),
    "three operands": (
        "if c then x := a or b or d; else x := a and b and d; end if;",
        ["x := choice(c, a or b or d, a and b and d);"],
    ),
}


@pytest.mark.parametrize("case", CHOICES)
def test_a_choice(case):
    before, after = CHOICES[case]
    made = choices.made(read(before))
    assert written(made) == after
    assert choices.unmade(read("\n".join(written(made)))) == read(before)


@pytest.mark.parametrize(
    "text",
    [
        "if c then x <= a; end if;",
        "if c then x <= a; else y <= a; end if;",
        "if c then x <= a; y <= a; else y <= b; x <= b; end if;",
        "if c then x <= a; else x <= b; y <= b; end if;",
        "if c then x := a; y := x; else x := b; y := x; end if;",  # the first may change the condition
        "if c then x <= a; else if d then x <= b; end if; end if;",
        "if n >= 0 then x <= to_unsigned(n, 8); else x <= y; end if;",  # refuses what the condition keeps from it
    ],
)
def test_what_is_no_choice_stays(text):
    assert choices.made(read(text)) == read(text)


def test_choices_that_stood_apart_stay_apart():
    """Of variables, and of conditions that a variable between them may change."""
    text = """if c then x := a; else x := b; end if; if c then y := a; else y := b; end if;
        if c then p <= a; else p <= b; end if; c := d; if c then q <= a; else q <= b; end if;"""
    assert choices.unmade(choices.made(read(text))) == read(text)


def random_operand(rng, depth=1):
    if depth == 0 or rng.random() < 0.5:
        return split(rng.choice(["a", "b_1", "is_set(x, 3)", "y(2)", "w(3) = '1'"]))
    operator = rng.choice(["and", "or"])
    inner = [*random_operand(rng, depth - 1), operator, *random_operand(rng, depth - 1)]
    return ["(", *(["not", "(", *inner, ")"] if rng.random() < 0.3 else inner), ")"]


def test_carries_go_back_word_for_word(rng):
    found = 0
    for _ in range(300):
        a, b = tuple(random_operand(rng)), tuple(random_operand(rng))
        first, second = rng.sample(["and", "or"], 2)
        yes, no = (*a, first, *b), (*a, second, *b)
        made = carries.made(("c",), yes, no)
        assert not made or carries.unmade(made) == (("c",), yes, no)
        found += bool(made)
    assert found > 50


# --- slices -----------------------------------------------------------------------------------------------------------


def array(name, *ranges, kind=BYTE):
    return arrays.Array(name, name + "_#" * len(ranges), (kind, ""), ranges)


KNOWN = {
    one.name: one for one in (array("a", (0, 3)), array("b", (0, 3)), array("c", (1, 4)), array("d", (0, 1), (0, 1)))
} | {"e": array("e", (0, 1), (0, 1)), "wide": array("wide", (0, 3), kind=type_of(0, 511))}


def copies(target, source, sign="<="):
    return " ".join(f"{target.format(i)} {sign} {source.format(i, i + 1, 3 - i)};" for i in range(4))


SLICES = {
    "all": (copies("a({0})", "b({0})"), ["a <= b;"]),
    "all, by other indices": (copies("a({0})", "c({1})"), ["a <= c;"]),
    "a shift": ("a(0) <= a(1); a(1) <= a(2); a(2) <= a(3);", ["a(0 to 2) <= a(1 to 3);"]),
    "a constant": (copies("a({0})", "0"), ["a <= (others => 0);"]),
    "two dimensions": ("d(0,0)<=e(0,0); d(0,1)<=e(0,1); d(1,0)<=e(1,0); d(1,1)<=e(1,1);", ["d <= e;"]),
}
NO_SLICES = {
    "another type": copies("a({0})", "wide({0})"),
    "backwards": copies("a({0})", "b({2})"),
    "values": copies("a({0})", "x"),
    "a variable that shifts": "a(0) := a(1); a(1) := a(2); a(2) := a(3);",
    "a part of two dimensions": "d(0,0)<=e(0,0); d(0,1)<=e(0,1);",
    "one": "a(0) <= b(0);",
    "a gap": "a(0) <= b(0); a(2) <= b(2);",
}


@pytest.mark.parametrize("case", SLICES)
def test_a_slice(case):
    before, after = SLICES[case]
    made = slices.made(read(before), KNOWN)
    assert written(made) == after
    assert slices.unmade(read("\n".join(written(made))), KNOWN) == read(before)


@pytest.mark.parametrize("case", NO_SLICES)
def test_what_is_no_slice_stays(case):
    assert slices.made(read(NO_SLICES[case]), KNOWN) == read(NO_SLICES[case])


# --- records ----------------------------------------------------------------------------------------------------------

TAGS = {f"{block}_tag_{name}": FLAG for block in ("p", "q") for name in ("valid", "last")}


def test_tags_are_records():
    found = records.found_in(TAGS, set())
    assert {tag: record.name for tag, record in found.items()} == {"p_tag": "tag_2", "q_tag": "tag_2"}
    text = "p_tag.valid <= q_tag.valid; p_tag.last <= q_tag.last; q_tag.valid <= false; q_tag.last <= false;"
    made = records.made(read(text), found)
    assert written(made) == ["p_tag <= q_tag;", "q_tag <= (others => false);"]
    assert records.unmade(read("\n".join(written(made))), found) == read(text)


@pytest.mark.parametrize(
    "text",
    [
        "p_tag.last <= q_tag.last; p_tag.valid <= q_tag.valid;",
        "p_tag.valid <= q_tag.valid; p_tag.last <= q_tag.valid;",
        "p_tag.valid <= q_tag.valid;",
        "p_tag.valid <= false; p_tag.last <= true;",
        "p_tag.valid <= x; p_tag.last <= x;",
    ],
)
def test_what_is_no_copy_of_a_tag_stays(text):
    assert records.made(read(text), records.found_in(TAGS, set())) == read(text)


def test_what_is_no_tag():
    assert not records.found_in({**TAGS, "p_tag_number": BYTE}, {"q_tag"})
    assert not records.found_in({"p_tag_valid": FLAG, "p_valid": FLAG, "q_label_a": FLAG, "q_label_b": FLAG}, set())
    two = records.found_in({**TAGS, "q_tag_first": FLAG, "r_tag_valid": FLAG, "r_tag_end": FLAG}, {"tag_3"})
    assert {tag: record.name for tag, record in two.items()} == {
        "p_tag": "tag_2",
        "q_tag": "tag_3_b",
        "r_tag": "tag_2_b",
    }


# --- ranges of their own ----------------------------------------------------------------------------------------------


def members(*tops, by="process"):
    return {f"x_{place}": (widths.kind_of(top), by) for place, top in enumerate(tops)}


def test_elements_of_one_width_share_a_type():
    assert set(widths.common(members(4, 5, 7), ()).values()) == {(widths.kind_of(7), "process")}
    found = arrays.found_in(members(4, 5, 7), set())
    assert [(one.name, one.kind[0], one.tops) for one in found] == [("x", widths.kind_of(7), (4, 5, 7))]
    assert found[0].remark == "_# up to 4, 5, 7"


def test_a_wider_type_costs_nothing_or_is_not_taken():
    assert widths.common(members(3, 5, 7), ()) == {}
    assert widths.common(members(3, 5, 7), {"x_0"}) != {}
    assert arrays.found_in(members(3, 5, 9), {"x"}, {"x_0", "x_1"})[0].tops == (3, 5, 9)
    assert arrays.found_in(members(3, 3, 9, 9), set(), {"x_0", "x_1"})[0].tops == ()  # arrays of their own
    assert widths.common({**members(3), "x_1": (widths.kind_of(3), "memory")}, ()) == {}


def test_selections():
    kinds = {"x": widths.kind_of(3), "y": widths.kind_of(3), "z": widths.kind_of(7), "flag": FLAG, "s": type_of(-1, 3)}

    def found(text):
        return widths.selections(read(text), kinds)

    assert found("if c then x <= 2; else x <= y; end if; z <= as_number(flag);") == {"x", "z"}
    for value in ("z", "y + 1", "s", "as_number(a and b)", "8"):
        assert found(f"if c then x <= 2; else x <= {value}; end if;") == set()


def test_what_is_said_of_ranges(rng):
    assert widths.said((3, 5, 7, 9, 24)) == "3, 5 .. 9, 24"
    assert widths.said((3,) * 9 + (2, 2)) == "3 x 9, 2, 2"
    for _ in range(300):
        tops = tuple(rng.randint(1, 4) for _ in range(rng.randint(1, 12)))
        tops += tuple(range(rng.randint(1, 9), rng.randint(10, 40), rng.randint(1, 3)))
        assert widths.read(widths.said(tops)) == tops
    assert not widths.is_sayable([rng.randint(1, 1000) ** 2 for _ in range(40)])


def test_arrays_of_variables_may_have_places_for_more():
    kinds = {"x_choice": (FLAG, "v"), "x_choice_3": (FLAG, "v"), "x_choice_2": (BYTE, "v"), "x_choice_4": (BYTE, "v")}
    found = {one.kind[0]: dict(one.elements()) for one in arrays.of_variables(kinds, set())}
    assert found[FLAG] == {"x_choice": (1,), "x_choice_2": (2,), "x_choice_3": (3,)}
    assert found[BYTE].keys() == {"x_choice_2", "x_choice_3", "x_choice_4"}
    far = {"x_1": (FLAG, "v"), "x_2": (FLAG, "v"), "x_90": (FLAG, "v")}
    assert [one.ranges for one in arrays.of_variables(far, set())] == [((1, 2),)]


# --- places that nothing is made of -----------------------------------------------------------------------------------


def test_places_for_more_get_a_value():
    kinds = {
        "n": "natural range 1 to 7",
        "s": "integer range -4 to 3",
        "m": "integer range -4 to -2",
        "w": type_of(0, 1 << 40),
    }
    sparse = [array("x", (1, 4), kind=FLAG), *(array(name, (0, 1), (0, 2), kind=kind) for name, kind in kinds.items())]
    body = read("if rising_edge(clock) then x(1) := a; b <= x(1); end if;")
    made = defaults.made(body, sparse)
    values = {"n": "1", "s": "0", "m": "- 2", "w": "(others => '0')"}
    said = [
        "x := (others => false);",
        *(f"{name} := (others => (others => {value}));" for name, value in values.items()),
    ]
    assert written(made)[2:7] == said
    known = {one.name: one for one in sparse}
    assert defaults.unmade(read("\n".join(written(made))), known) == body
    assert defaults.made(body, []) == defaults.unmade(body, known) == body


def test_what_keeps_its_value_is_in_no_such_array():
    """Neither is what a branch only gives a value."""
    text = "p := a; if p then q := a; r := a; else q := b; s <= t; end if; u <= q and r; t := a;"
    assert defaults.read_first(read(text), "pqrt") == {"r", "t"}
    kinds = {f"x_{n}": (FLAG, "v") for n in (1, 2, 4)}
    assert [one.ranges for one in arrays.of_variables(kinds, set())] == [((1, 4),)]
    assert [one.ranges for one in arrays.of_variables(kinds, set(), {"x_2"})] == [((1, 2),)]


# --- loops ------------------------------------------------------------------------------------------------------------


def test_two_turns_by_chance_are_no_loop():
    """The end of one turn and the start of the next, as `24 - 24 * i`."""
    text = "".join(
        f"a({i}, {j}) <= {'b' if j in (0, 9) else 'c'}({i}, {j}) + long_name;" for i in (0, 1) for j in range(10)
    )
    folded = written(loops.fold(read(text), set()))
    assert folded[0] == "for i in 0 to 1 loop" and not any("*" in line for line in folded)


# --- all of it --------------------------------------------------------------------------------------------------------


def test_a_changed_function_is_no_presented_core(text_of_tiny, tmp_path):
    """What the functions do counts: they are taken out word for word. So tools see the file as it is."""
    assert present(expand(text_of_tiny)) == text_of_tiny
    changed = text_of_tiny.replace("      return yes;\n", "      return no;\n", 1)
    assert changed != text_of_tiny
    with pytest.raises(FlowError, match="unknown form of VHDL: the function choice was edited"):
        expand(changed)
    edited = tmp_path / "edited.vhd"
    edited.write_text(changed)
    assert scalars.files([edited]) == [edited]


def test_a_slice_of_another_length_is_refused():
    with pytest.raises(FlowError, match=r"unknown form of VHDL: 'a\(0 to 3\) <= b\(1 to 2\)'"):
        slices.unmade(read("a(0 to 3) <= b(1 to 2);"), KNOWN)


def with_fault(fault):
    """(module, function, a wrong one in its place) of one step"""

    def of(module, name, change):
        right = getattr(module, name)
        return module, name, lambda *given: change(right, *given)

    return {
        "choices": of(
            choices, "_chosen", lambda right, one: right(tree.If(one.test, one.otherwise or one.then, one.then))
        ),
        "carries": of(
            carries, "made", lambda right, *given: tuple(carries.INVERTED if w == "carry" else w for w in right(*given))
        ),
        "extremes": of(
            extremes,
            "made",
            lambda right, test, yes, no: right(test, yes, no) and ("smaller", "(", *no, ",", *yes, ")"),
        ),
        "remarks": of(arrays, "shortened", lambda right, name, pattern: right(name, pattern).replace("_#", "_2#", 1)),
        "slices": of(slices, "_reference", lambda right, one, first, size: right(one, first + 1, size)),
        "records": of(records, "_whole", lambda right, *given: itself(*right(*given))),
        "ranges": of(widths, "said", lambda right, tops: right([top + 1 for top in tops])),
        "memories": of(memories, "_generated", lambda right, *given: shorter(right(*given))),
        "loops": of(loops, "_loop", lambda right, body, turns, steps: right(body, turns - 1, steps)),
    }[fault]


def itself(size, whole):
    return size, whole and tree.Assign((*whole.words[:2], whole.words[0]))


def shorter(generated):
    return generated and (generated[0].replace(" downto 0", " downto 1"), generated[1])


@pytest.mark.parametrize(
    "fault",
    ["choices", "carries", "extremes", "slices", "records", "remarks", "ranges", "memories", "loops"],
)
def test_a_fault_in_a_step_is_refused(fault, monkeypatch):
    name = "tiny_sgm"
    scalar = expand((committed.folder(name) / f"{committed.entity(name)}.vhd").read_text())
    assert present(scalar)
    monkeypatch.setattr(*with_fault(fault))
    with pytest.raises(FlowError, match=r"does not expand to what was written|unknown form of VHDL"):
        present(scalar)


def test_words_of_records_are_one():
    assert split("a_tag.valid <= b_tag.valid;") == ["a_tag.valid", "<=", "b_tag.valid", ";"]
    assert joined(["a", "(", "0", "to", "3", ")"]) == "a(0 to 3)"
