# SPDX-License-Identifier: Apache-2.0
"""A seed is one scene with every compiler: no two random draws stand in one argument list or on both sides of an
operator, where C++ leaves their order open. Between braces it is fixed."""

import hashlib
import re
import subprocess
from bisect import bisect_left

import pytest

from conftest import need
from flow.base.tools import ROOT

SOURCES = sorted(path for folder in ("hls", "hls_tb") for path in (ROOT / folder).rglob("*.[ch]pp"))
# A method of scene/random.hpp, or a call of a generator of the standard library.
DRAW = r"\.\s*(?:below|bits|byte|percent|between)\s*\(|\b(?:random|rng|generator)_?\s*\(\s*\)"
# Who is given a generator by reference draws from it.
DRAWING = re.compile(r"\b(\w+)\s*\([^(){};]*\b(?:Random|std::mt19937(?:_64)?)\s*&")
NO_CALLS = {"if", "while", "for", "switch", "return", "catch"}
ORDERED = re.compile(r"&&|\|\||<<|>>|[-+*/%&|^]=|(?<![<>=!])=(?!=)|->|[?:;,]")
BRACKET = re.compile(r"[(\[{)\]}]")
COMMA = re.compile(",")
UNORDERED = re.compile(r"[<>=!]=|[-+*/%&|^<>]")


def plain(text):
    """Without comments and the contents of strings; lines stay."""

    def blank(match):
        word = match.group()
        return '""' if word[0] in "\"'" else re.sub(r"[^\n]", " ", word)

    return re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<!\d)'(?:\\.|[^'\\\n])'", blank, text, flags=re.DOTALL)


def groups(text):
    """(start, end) of what stands in each pair of brackets."""
    opened = []
    for match in BRACKET.finditer(text):
        if match.group() in "([{":
            opened.append(match.end())
        elif opened:
            yield opened.pop(), match.start()
    yield 0, len(text)


def split(text, start, end, signs):
    """[(start, end)] between the signs that stand in no bracket. A block of statements ends like a statement."""
    opened, hidden, last = [], [], start
    for match in BRACKET.finditer(text, start, end):
        place = match.start()
        hidden.append(" " * (place - last) if opened else text[last:place])
        begin = opened.pop() if match.group() in ")]}" and opened else None
        is_block = match.group() == "}" and begin is not None and ";" in text[begin:place]
        hidden.append(";" if is_block and not opened else " ")
        if match.group() in "([{":
            opened.append(place)
        last = place + 1
    hidden.append(text[last:end])
    signs_found = [(start + match.start(), start + match.end()) for match in signs.finditer("".join(hidden))]
    begins = [start, *(after for _, after in signs_found)]
    return list(zip(begins, [*(before for before, _ in signs_found), end]))


def without_blocks(text):
    """Statements in braces, as of a lambda, are no part of the expression around them."""
    while True:
        shorter = re.sub(r"\{[^{}]*;[^{}]*\}", "", text)
        if shorter == text:
            return text
        text = shorter


def places(text, drawing=frozenset()):
    """Lines with two draws whose order is open. `drawing`: functions that draw."""
    text = plain(text)
    draw = re.compile(rf"{DRAW}|\b(?:{'|'.join(drawing) or '$.'})\s*\(")
    draws = [match.start() for match in draw.finditer(text)]
    found = set()
    for start, end in groups(text):
        if bisect_left(draws, end) - bisect_left(draws, start) < 2:
            continue
        called = (
            re.search(r"(\w+|>)\s*$", text[max(start - 80, 0) : start - 1]) if text[start - 1 : start] == "(" else None
        )
        lists = [split(text, start, end, COMMA)] if called and called[1] not in NO_CALLS else []
        lists += [split(text, *piece, UNORDERED) for piece in split(text, start, end, ORDERED)]
        for parts in lists:
            drawn = [draw.search(without_blocks(text[begin:stop])) for begin, stop in parts if len(parts) > 1]
            if sum(map(bool, drawn)) > 1:
                found.add(text.count("\n", 0, parts[0][0]) + 1)
    return sorted(found)


@pytest.fixture(scope="module")
def drawing():
    found = {name for path in SOURCES for name in DRAWING.findall(plain(path.read_text()))}
    assert len(found) > 3
    return frozenset(found - {"Motion", "explicit"})


def test_no_order_is_open(drawing):
    found = [f"{path.relative_to(ROOT)}:{line}" for path in SOURCES for line in places(path.read_text(), drawing)]
    assert not found, found


@pytest.mark.parametrize(
    "text",
    [
        "f(random.below(2), random.bits());",
        "const Pair pair(random_.byte(),\n                random_.byte());",
        "x = random.below(2) - random.below(3);",
        "if (f(1, g(random.below(3)), random.percent(4))) {}",
        "f(pixel(random), its.percent(4));",
        "add([&] { int i = 1; return i; }, random.below(2), random.below(3));",
    ],
)
def test_an_open_order_is_noticed(text):
    assert places(text, {"pixel"}) == [1]


@pytest.mark.parametrize(
    "text",
    [
        "const Pair pair{random.byte(), random.byte()};",
        "const int a = random.below(2), b = random.below(3);",
        "random.below(random.percent(50) ? 2 : random.below(9));",
        "if (random.percent(50) && random.percent(20)) x = random.below(2);",
        "for (int i = random.below(2); i < random.below(3); ++i) {}",
        "int f(Random& random) { return random.below(2); }\nint g(Random& random) { return random.below(3); }",
        "f(1, random.below(2));  // random.below(3), random.below(4)",
    ],
)
def test_a_fixed_order_is_none(text):
    assert places(text) == []


PROGRAM = """\
#include <cstdio>
#include "scene/scene.hpp"
int main() {
   for (const stereo::SceneOptions& options :
        {stereo::SceneOptions{.width = 32, .height = 12, .disparities = 8, .seed = 7},
         {.width = 320, .height = 240, .disparities = 100, .seed = 2007},
         {.width = 320, .height = 240, .disparities = 100, .seed = 1, .frame = 9}}) {
      const stereo::Scene scene = stereo::make_scene(options);
      for (const stereo::GrayImage* image : {&scene.images.left, &scene.images.right, &scene.disparity, &scene.visible,
                                             &scene.left_disparity, &scene.left_visible})
         std::fwrite(image->pixels.data(), 1, image->pixels.size(), stdout);
   }
}
"""
DIGEST = "67d38147f39deafb09b9eb34c0060783221e3708b59657a28afa7518c508b68e"  # of what it writes


@pytest.mark.parametrize("compiler", ["g++", "clang++-16"])
def test_a_seed_is_one_scene(tmp_path, compiler):
    (tmp_path / "scenes.cpp").write_text(PROGRAM)
    folder = ROOT / "hls_tb" / "scene"
    sources = [tmp_path / "scenes.cpp", folder / "scene.cpp", folder / "scene_surfaces.cpp"]
    options = ["-std=c++20", "-O1", "-I", ROOT / "hls", "-I", ROOT / "hls_tb", "-o", tmp_path / "scenes"]
    subprocess.run([need(compiler), *options, *sources], check=True)
    pixels = subprocess.run([tmp_path / "scenes"], capture_output=True, check=True).stdout
    assert len(pixels) == 6 * (32 * 12 + 2 * 320 * 240)
    assert hashlib.sha256(pixels).hexdigest() == DIGEST
