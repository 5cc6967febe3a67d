# SPDX-License-Identifier: Apache-2.0
"""Where the words of a presented core stand: declarations of one type together, comments that say where the indices
are, statements of one line, the wait for the clock. All of it reads as the same words again."""

import pytest

from flow.base.errors import FlowError
from flow.synthesis.presentation import arrays, core, layout, tree
from flow.synthesis.presentation.core import Names
from flow.synthesis.presentation.words import LINE, split

STATEMENTS = {
    "constants side by side": (
        "x <= 0; y <= false; a := (others => '0'); z <= to_unsigned(0, 4); b <= c; d <= 1;",
        ["x <= 0; y <= false; a := (others => '0'); z <= to_unsigned(0, 4);", "b <= c;", "d <= 1;"],
    ),
    "a loop of one statement": (
        "for i in 0 to 3 loop a(i) <= b(i); end loop;",
        ["for i in 0 to 3 loop a(i) <= b(i); end loop;"],
    ),
    "an `if` of one statement": ("if c then a <= b; end if;", ["if c then a <= b; end if;"]),
    "of two": (
        "if c then a <= b; d <= e; end if;",
        ["if c then", "  a <= b;", "  d <= e;", "end if;"],
    ),
    "with another branch": (
        "if c then a <= b; else a <= 0; end if;",
        ["if c then", "  a <= b;", "else", "  a <= 0;", "end if;"],
    ),
    "a loop in a loop": (
        "for i in 0 to 3 loop for j in 0 to 1 loop a(i, j) <= b(j); end loop; end loop;",
        ["for i in 0 to 3 loop", "  for j in 0 to 1 loop a(i, j) <= b(j); end loop;", "end loop;"],
    ),
    "a comment": ("x <= 0;\n-- next\ny <= 0;", ["x <= 0;", "-- next", "y <= 0;"]),
}


@pytest.mark.parametrize("case", STATEMENTS)
def test_statements(case):
    text, lines = STATEMENTS[case]
    statements = tree.read(split(text))
    assert list(layout.lines(statements, "")) == lines
    assert tree.read(split("\n".join(lines))) == statements


def test_lines_are_no_longer_than_elsewhere():
    constants = tree.read(split("\n".join(f"a_register_of_some_length_{number} <= 0;" for number in range(20))))
    long = tree.read(split(f"if {' and '.join(['condition'] * 9)} then a_register <= another_one; end if;"))
    lines = list(layout.lines([*constants, *long], "      "))
    assert max(map(len, lines)) <= LINE and len(lines) == 7 + 4
    assert tree.read(split("\n".join(lines))) == (*constants, *long)


REMARKS = {  # name of an array: (pattern of its elements, what the comment says)
    "a_valid": ("a_#_valid", "_#_valid"),
    "a_1_valid": ("a_1_#_valid", "_#_valid"),
    "a_count_2": ("a_#_count_2", "_#_count_2"),
    "a_count": ("a_#_#_count_#", "_#_#_count_#"),
    "column": ("column_2#", "_2#"),
    "a_choices": ("a_choice_#", "_choice_#"),
    "a_values_from_4": ("a_value_#", "_value_#"),
    "values_2": ("value_#", "value_#"),
    "a_place_0": ("a_place_0_2#", "_2#"),
}


@pytest.mark.parametrize("name", REMARKS)
def test_what_a_comment_says_of_indices(name):
    pattern, remark = REMARKS[name]
    assert arrays.shortened(name, pattern) == remark
    assert arrays.lengthened(name, remark) == arrays.lengthened(name, pattern) == pattern


def test_a_comment_of_another_name_is_refused():
    with pytest.raises(FlowError, match="a_ready does not end as its elements do"):
        arrays.lengthened("a_ready", "_#_valid")


def test_variables_of_one_type_stand_together():
    byte = "natural range 0 to 255"
    there = [Names("boolean", ["a"]), Names(byte, ["b"]), Names("boolean", ["c"])]
    assert list(core.grouped(there)) == [Names("boolean", ["a", "c"]), Names(byte, ["b"])]
    assert [one.names for one in there] == [["a"], ["b"], ["c"]]


CORE = """library ieee;
entity e is
end entity;

architecture rtl of e is
  type natural_255_1d is array (natural range <>) of natural range 0 to 255;
  signal a : boolean;
{declarations}
begin
  process
  begin
    wait until rising_edge(clock);
    a <= b;
    if reset = '1' then a <= false; end if;
  end process;
end architecture;
"""


def test_a_long_declaration_on_several_lines():
    names = [f"a_name_of_some_length_{number}" for number in range(9)]
    byte = Names("natural range 0 to 255", names)
    array = arrays.Array("pixels", "pixel_#", ("natural range 0 to 255", ""), ((0, 2),))
    lines = core._declared("  signal ", core.grouped([byte, array]), True)
    assert max(map(len, lines)) <= LINE and lines[-1] == "  signal pixels : natural_255_1d(0 to 2);  -- pixel_#"
    assert not any(line.lstrip().startswith(("range", "0 to")) for line in lines), "a type on two lines"
    read = core.read(CORE.format(declarations="\n".join(lines)))
    assert read.declarations == [Names("boolean", ["a"]), byte, array]


def test_signals_keep_their_order():
    """Synthesis numbers them as they are declared: another order gives another netlist of the same size, or nearly."""
    order = "  signal a, b : boolean;\n  signal c : natural range 0 to 255;\n  signal d : boolean;"
    read = core.read(CORE.replace("  signal a : boolean;\n{declarations}", order))
    assert core.text(read, True).count(order) == core.text(read).count(order) == 1


def test_a_core_waits_for_its_clock():
    read = core.read(CORE.format(declarations=""))
    (clocked,) = read.body
    assert clocked.test == ("rising_edge", "(", "clock", ")") and len(clocked.then) == 2
    assert core.text(read, True).replace(core.MARK + core._ENDS, "").count("    wait until rising_edge(clock);\n") == 1
    with_if = core.text(read)
    assert "  process (clock)\n  begin\n    if rising_edge(clock) then\n      a <= b;\n" in with_if
    assert core.read(with_if).body == read.body
