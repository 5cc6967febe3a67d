# SPDX-License-Identifier: Apache-2.0
"""hls/ has none of the constructs of docs/tool_cpp.md that a program can find: loops that stay loops, functions that
become modules, and run-time choices between elements of arrays."""

import re

import pytest

from flow.base.tools import ROOT

HEADERS = sorted((ROOT / "hls").rglob("*.hpp"))
HEAD = re.compile(
    r"^\s*(?!return\b|else\b|\}|:|,)[\w:<>,&*\s\[\]]*[\w>&*]\s+~?(\w+|operator\S+)\(.*\)( const)?( -> .*)? \{"
)
COMPILED_AWAY = ("constexpr", "consteval")
KEYWORDS = ("if", "for", "while", "switch", "return", "catch")


def without_comments(text):
    return [re.sub(r"//.*", "", line) for line in text.splitlines()]


def head_of(lines, place):
    """The line that begins the function around a line."""
    depth = 0
    for line in reversed(lines[:place]):
        depth += line.count("}") - line.count("{")
        if depth < 0:
            depth = 0
            if re.search(r"\)( const)?( -> .*)? \{\s*$|\[[&=]?\](\(.*\))? \{\s*$", line) and not re.match(
                rf"\s*(\}} )?({'|'.join(KEYWORDS)}|else)\b", line
            ):
                return line
    return ""


def loops(lines):
    """Loops of the hardware that are not unrolled."""
    for number, line in enumerate(lines):
        is_loop = re.match(r"\s*(for|while) \(", line)
        unrolled = number and re.search(r"HLS_UNROLL|pragma|nounroll", lines[number - 1])
        if is_loop and not unrolled and not any(word in head_of(lines, number) for word in COMPILED_AWAY):
            yield number + 1


def functions(lines):
    """Functions that begin and have their name in one line, without HLS_INLINE."""
    for number, line in enumerate(lines):
        match = HEAD.match(line)
        before = lines[number - 1] if number else ""
        if not match or match[1] in KEYWORDS or "HLS_INLINE" in line + before:
            continue
        if not any(word in line for word in (*COMPILED_AWAY, "struct ", "namespace ", "operator", "static auto")):
            yield number + 1


def choices(lines):
    """`condition ? a[i] : b[j]` whose condition has no constant of the configuration."""
    for number, line in enumerate(lines):
        match = re.search(r"(.*)\?[^:?]*\w\[[^\]]*\](?:\.\w+)* :[^:]*\w\[[^\]]*\]", line)
        condition = re.split(r" = |\breturn ", match[1])[-1] if match else ""
        if match and not re.search(r"\bC\.|\bk[A-Z]", condition):
            yield number + 1


RULES = {"loop": loops, "function": functions, "choice": choices}
FAULTS = [
    ("loop", "HLS_INLINE void f() {\n   for (int i = 0; i < 4; ++i) a[i] = 0;\n}\n", 2),
    ("loop", "HLS_INLINE void f() {\n   if (x) {\n      y = 1;\n   }\n   while (x) --x;\n}\n", 5),
    ("function", "struct A {\n   int f(int x) const {\n      return x;\n   }\n};\n", 2),
    ("function", "void f() {\n}\n", 1),
    ("choice", "HLS_INLINE int f() const { return x > 1 ? a[0] : b[1]; }\n", 1),
    ("choice", "const int y = first ? a[i].cost : b[j].cost;\n", 1),
]
RIGHT = """\
HLS_INLINE void f() {
   HLS_UNROLL
   for (int i = 0; i < 4; ++i) a[i] = C.left ? b[i] : c[i];
   const int y = select(first, a[i], b[j]);
   const int z = kWide ? a[0] : b[0];
   if (x) {
      y = 1;
   }
}
static constexpr int bits(int largest) {
   while (largest > 1) largest /= 2;
   return largest;
}
"""


@pytest.mark.parametrize("rule", RULES)
def test_the_hardware_has_none(rule):
    found = [
        f"{path.relative_to(ROOT)}:{number}"
        for path in HEADERS
        for number in RULES[rule](without_comments(path.read_text()))
    ]
    assert len(HEADERS) > 80 and found == []


@pytest.mark.parametrize("rule, text, number", FAULTS)
def test_a_fault_is_found(rule, text, number):
    assert list(RULES[rule](without_comments(text))) == [number]


@pytest.mark.parametrize("rule", RULES)
def test_what_is_right_is_not_found(rule):
    assert list(RULES[rule](without_comments(RIGHT))) == []
