# SPDX-License-Identifier: Apache-2.0
"""Runs of statements that differ by a constant step in their indices, as loops, and back."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Union

from .tree import Assign, Comment, For, If, Statement
from .words import Words, is_callable

LONGEST = 96  # statements of one turn
VARIABLES = ("i", "j", "k", "l")
_WIDTHS = ("to_unsigned", "resize")  # their second argument stays a number
_FIXED = ("mod", "/", "*", "**")  # so does what is behind them
_BETWEEN = ("downto", "to")
_DELIMITERS = ("(", ",", *_BETWEEN, ")")
_shapes: dict[Any, int] = {}


@dataclass(frozen=True)
class _Shape:
    """Of a statement or a loop: what is left when the numbers are taken out."""

    number: int
    lines: int
    depth: int  # of loops in it
    ties: tuple[tuple[int, int], ...] = ()  # numbers that have the same step: the ends of a slice


@dataclass(frozen=True)
class _Plain:
    shape: _Shape
    numbers: tuple[int, ...]
    words: Sequence[str | None]  # None: a number


@dataclass(frozen=True)
class _Choice:
    shape: _Shape
    numbers: tuple[int, ...]
    test: _Plain
    then: list[_Node]
    otherwise: list[_Node] | None


@dataclass(frozen=True)
class _Loop:
    shape: _Shape
    numbers: tuple[int, ...]  # of the first turn
    steps: tuple[int, ...]
    turns: int
    body: list[_Node]


@dataclass(frozen=True)
class _Note:
    shape: _Shape
    numbers: tuple[int, ...]
    text: str


_Node = Union[_Plain, _Choice, _Loop, _Note]


def fold(statements: Sequence[Statement], reserved: set[str]) -> tuple[Statement, ...]:
    """`reserved`: names that no loop may take."""
    free = variables(reserved)
    nodes = _folded([_node(one) for one in statements], len(free))
    return tuple(_statements(nodes, [(number, {}) for number in _numbers(nodes)], free))


def variables(reserved: set[str]) -> list[str]:
    return [name for name in VARIABLES if name not in reserved]


# --- from statements to nodes -----------------------------------------------------------------------------------------


def _number(key: Any) -> int:
    return _shapes.setdefault(key, len(_shapes))


def _node(statement: Statement, most: int = len(VARIABLES)) -> _Node:
    if isinstance(statement, Comment):
        return _Note(_Shape(_number(object()), 1, 0), (), statement.text)
    if isinstance(statement, Assign):
        return _plain(statement.words)
    assert isinstance(statement, If)
    test = _plain(statement.test)
    then = _folded([_node(one) for one in statement.then], most)
    otherwise = None if statement.otherwise is None else _folded([_node(one) for one in statement.otherwise], most)
    children: list[_Node] = [test, *then, *(otherwise or [])]
    key = ("if", test.shape.number, _key(then), None if otherwise is None else _key(otherwise))
    rows = sum(child.shape.lines for child in children) + (1 if otherwise is None else 2)
    shape = _Shape(_number(key), rows, max(child.shape.depth for child in children), _ties(children))
    return _Choice(shape, _numbers(children), test, then, otherwise)


def _plain(words: Words) -> _Plain:
    shown: list[str | None] = []
    numbers: list[int] = []
    ties = []
    calls: list[str] = []
    before = ""
    for word in words:
        if word == "(":
            calls.append(before if before and is_callable(before) else "")
        elif word == ")":
            calls.pop()
        is_width = before == "," and calls and calls[-1] in _WIDTHS
        if word.isdigit() and before not in _FIXED and not is_width:
            if before in _BETWEEN:
                ties.append((len(numbers) - 1, len(numbers)))
            numbers.append(int(word))
            shown.append(None)
        else:
            shown.append(word)
        before = word
    shape = _Shape(_number(tuple(shown)), 1 + sum(map(len, words)) // 90, 0, tuple(ties))
    return _Plain(shape, tuple(numbers), shown)


def _key(nodes: Sequence[_Node]) -> tuple[int, ...]:
    return tuple(node.shape.number for node in nodes)


def _numbers(nodes: Sequence[_Node]) -> tuple[int, ...]:
    return tuple(number for node in nodes for number in node.numbers)


def _ties(nodes: Sequence[_Node]) -> tuple[tuple[int, int], ...]:
    found, start = [], 0
    for node in nodes:
        found += [(start + first, start + second) for first, second in node.shape.ties]
        start += len(node.numbers)
    return tuple(found)


# --- folding ----------------------------------------------------------------------------------------------------------


def _folded(nodes: list[_Node], most: int) -> list[_Node]:
    """Two turns may be so by chance: what has more comes first, and of two turns the longest."""
    nodes = _all_runs(nodes, range(1, LONGEST + 1), most, 3)
    return _all_runs(nodes, range(LONGEST, 0, -1), most, 2)


def _all_runs(nodes: list[_Node], periods: Sequence[int], most: int, least: int) -> list[_Node]:
    """`least`: turns of a loop."""
    before = -1
    while before != len(nodes):
        before = len(nodes)
        for period in periods:
            if least * period <= len(nodes):
                nodes = _runs(nodes, period, most, least)
    return nodes


def _runs(nodes: list[_Node], period: int, most: int, least: int) -> list[_Node]:
    alike = [0] * (len(nodes) + 1)  # how many from here on are as those one period later
    for at in range(len(nodes) - period - 1, -1, -1):
        alike[at] = alike[at + 1] + 1 if nodes[at].shape.number == nodes[at + period].shape.number else 0
    if max(alike) < period:
        return nodes
    found: list[_Node] = []
    at = 0
    while at < len(nodes):
        if alike[at] >= period:
            turns, steps = _turns(nodes, at, period, most)
            rows = sum(node.shape.lines for node in nodes[at : at + period])
            if turns >= least and rows * (turns - 1) >= 4:
                found.append(_loop(nodes[at : at + period], turns, steps))
                at += period * turns
                continue
        found.append(nodes[at])
        at += 1
    return found


def _turns(nodes: list[_Node], at: int, period: int, most: int) -> tuple[int, tuple[int, ...]]:
    first = nodes[at : at + period]
    if any(node.shape.depth >= most or isinstance(node, _Note) for node in first):
        return 0, ()
    last = _numbers(first)
    second = _numbers(nodes[at + period : at + 2 * period])
    steps = tuple(b - a for a, b in zip(last, second))
    if not any(steps) or any(steps[a] != steps[b] for a, b in _ties(first)):
        return 0, ()
    kinds, turns, last = _key(first), 2, second
    while True:
        place = at + turns * period
        block = nodes[place : place + period]
        if len(block) < period or _key(block) != kinds:
            break
        numbers = _numbers(block)
        if any(b - a != step for a, b, step in zip(last, numbers, steps)):
            break
        last, turns = numbers, turns + 1
    return turns, steps


def _loop(body: list[_Node], turns: int, steps: tuple[int, ...]) -> _Loop:
    key = ("for", turns, steps, _key(body))
    rows = sum(node.shape.lines for node in body) + 2
    shape = _Shape(_number(key), rows, 1 + max(node.shape.depth for node in body), _ties(body))
    return _Loop(shape, _numbers(body), steps, turns, body)


# --- from nodes to statements -----------------------------------------------------------------------------------------

_Value = tuple[int, dict[str, int]]  # a constant and the steps of loop variables


def _statements(nodes: Sequence[_Node], values: Sequence[_Value], variables: Sequence[str]) -> list[Statement]:
    found: list[Statement] = []
    start = 0
    for node in nodes:
        own = values[start : start + len(node.numbers)]
        start += len(node.numbers)
        if isinstance(node, _Note):
            found.append(Comment(node.text))
        elif isinstance(node, _Plain):
            found.append(Assign(_filled(node, own)))
        elif isinstance(node, _Choice):
            split = len(node.test.numbers)
            middle = split + len(_numbers(node.then))
            then = _statements(node.then, own[split:middle], variables)
            rest = None if node.otherwise is None else tuple(_statements(node.otherwise, own[middle:], variables))
            found.append(If(_filled(node.test, own[:split]), tuple(then), rest))
        else:
            found.append(_for(node, own, variables))
    return found


def _for(node: _Loop, values: Sequence[_Value], variables: Sequence[str]) -> For:
    variable = variables[0]
    plain = [number for (number, others), step in zip(values, node.steps) if step == 1 and not others]
    any_step = [number for (number, _), step in zip(values, node.steps) if step == 1]
    first = next((number for number in [*plain, *any_step] if number >= 0), 0)
    shown = [
        (number - step * first, {**others, variable: step} if step else others)
        for (number, others), step in zip(values, node.steps)
    ]
    return For(variable, first, first + node.turns - 1, tuple(_statements(node.body, shown, variables[1:])))


def _filled(node: _Plain, values: Sequence[_Value]) -> Words:
    words: list[str] = []
    left = iter(values)
    for at, word in enumerate(node.words):
        if word is not None:
            words.append(word)
            continue
        text = _affine(*next(left))
        before = node.words[at - 1] if at else None
        behind = node.words[at + 1] if at + 1 < len(node.words) else None
        is_alone = before in _DELIMITERS and behind in _DELIMITERS
        words += text if len(text) == 1 or is_alone else ["(", *text, ")"]
    return tuple(words)


def _affine(number: int, steps: dict[str, int]) -> list[str]:
    """`2 * i + j - 1`, `24 - i`"""
    rising = [(name, step) for name, step in steps.items() if step > 0]
    words: list[str] = []
    for name, step in rising:
        words += ["+", *_product(step, name)]
    if number or not words:
        words += ["+" if number >= 0 else "-", str(abs(number))]
    for name, step in steps.items():
        if step < 0:
            words += ["-", *_product(-step, name)]
    return words[1:]


def _product(step: int, name: str) -> list[str]:
    return [name] if step == 1 else [str(step), "*", name]


# --- lists of words alone ---------------------------------------------------------------------------------------------


def longest(lists: Sequence[Words]) -> tuple[int, tuple[int, ...]]:
    """(how many from the first one on, steps of their numbers) of which a loop could be made"""
    nodes: list[_Node] = [_plain(words) for words in lists]
    if len(nodes) < 2 or nodes[0].shape.number != nodes[1].shape.number:
        return 1, ()
    return _turns(nodes, 0, 1, 1)


def numbers_of(words: Words) -> tuple[int, ...]:
    return _plain(words).numbers


def with_numbers(words: Words, values: Sequence[_Value]) -> Words:
    return _filled(_plain(words), values)


# --- and back ---------------------------------------------------------------------------------------------------------


def unroll(statements: Sequence[Statement], values: dict[str, int] | None = None) -> tuple[Statement, ...]:
    """`values`: of loop variables."""
    known = values or {}
    found: list[Statement] = []
    for one in statements:
        if isinstance(one, For):
            for number in range(one.first, one.last + 1):
                found += unroll(one.body, {**known, one.variable: number})
        elif isinstance(one, Assign):
            found.append(Assign(evaluated(one.words, known)))
        elif isinstance(one, If):
            otherwise = None if one.otherwise is None else unroll(one.otherwise, known)
            found.append(If(evaluated(one.test, known), unroll(one.then, known), otherwise))
        else:
            found.append(one)
    return tuple(found)


def evaluated(words: Words, values: dict[str, int]) -> Words:
    """With numbers in place of loop variables."""
    if not values or not any(word in values for word in words):
        return words
    found: list[str] = []
    at = 0
    while at < len(words):
        end = at
        if found and found[-1] in _DELIMITERS[:-1]:
            while end < len(words) and (words[end] in values or words[end].isdigit() or words[end] in "+-*"):
                end += 1
        is_sum = end > at and words[end] in _DELIMITERS[1:] and any(w in values for w in words[at:end])
        if is_sum:
            number = str(_sum(words[at:end], values))
            is_in_parentheses = found[-1] == "(" and words[end] == ")" and not any(map(is_callable, found[-2:-1]))
            if is_in_parentheses and end - at > 1:
                found[-1] = number
                end += 1
            else:
                found.append(number)
            at = end
        else:
            found.append(str(values[words[at]]) if words[at] in values else words[at])
            at += 1
    return tuple(found)


def _sum(words: Sequence[str], values: dict[str, int]) -> int:
    total, sign, product = 0, 1, 1
    for word in [*words, "+"]:
        if word in ("+", "-"):
            total += sign * product
            sign, product = (1 if word == "+" else -1), 1
        elif word != "*":
            product *= values[word] if word in values else int(word)
    return total
