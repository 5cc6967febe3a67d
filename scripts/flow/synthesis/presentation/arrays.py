# SPDX-License-Identifier: Apache-2.0
"""Names that differ in their numbers only, and are of one type, as one array with these numbers as indices."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, product
from math import gcd, prod

from ...base.errors import FlowError
from . import widths
from .widths import Kind
from .words import Words

FEWEST = 2  # elements of an array
_NUMBER = re.compile(r"(?<=_)(0|[1-9]\d*)(?=_|$)")
_INDEX = re.compile(r"(\d*)#")
_BEFORE_INDEX = re.compile(r"_\d*#")
_PLURAL = r"(?:s(?:_from_\d+|_\d+)?)?"  # what the name of an array may end in besides
_RANGE = re.compile(r"(natural|integer) range (-?)(\d+) to (\d+)")
_UNSIGNED = re.compile(r"unsigned\((\d+) downto 0\)")
# Of VHDL-93 and VHDL-2008: no name of an array.
RESERVED = frozenset(
    """abs access after alias all and architecture array assert assume assume_guarantee attribute begin block
    body buffer bus case component configuration constant context cover default disconnect downto else elsif end
    entity exit fairness file for force function generate generic group guarded if impure in inertial inout is
    label library linkage literal loop map mod nand new next nor not null of on open or others out package
    parameter port postponed procedure process property protected pure range record register reject release rem
    report restrict restrict_guarantee return rol ror select sequence severity shared signal sla sll sra srl
    strong subtype then to transport type unaffected units until use variable vmode vprop vunit wait when while
    with xnor xor""".split()
)
# The lowering counts variables of the same name: `choice`, `choice_2`, ...
_COUNTED = "_#"
_FEWEST_WITH_STEP = 3  # indices of which only each second, third ... is there
_FILLED = 8  # of variables: their array has at most so many places for each, as of a comparison of 8 steps one is left
Places = tuple[int, ...]


@dataclass(frozen=True)
class Array:
    name: str
    pattern: str  # of the names of its elements, # for an index, 2# for twice the index
    kind: Kind
    ranges: tuple[tuple[int, int], ...]
    is_variable: bool = False
    tops: tuple[int, ...] = ()  # of the elements' own ranges, where those are narrower; in their order

    @property
    def type_name(self) -> str:
        return f"{_type_name(self.kind[0])}_{len(self.ranges)}d"

    @property
    def type_text(self) -> str:
        indices = ", ".join(["natural range <>"] * len(self.ranges))
        return f"type {self.type_name} is array ({indices}) of {self.kind[0]};"

    @property
    def constraint(self) -> str:
        return ", ".join(f"{first} to {last}" for first, last in self.ranges)

    @property
    def first(self) -> Places:
        return tuple(low for low, _ in self.ranges)

    @property
    def size(self) -> int:
        return prod(last - low + 1 for low, last in self.ranges)

    def reference(self, places: Places) -> Words:
        """To an element, in words of VHDL."""
        words = [word for place in places for word in (",", str(place))]
        return self.name, "(", *words[1:], ")"

    def is_spanned_by(self, names: Container[str]) -> bool:
        """Whether these elements reach its bounds in each dimension."""
        places = [indices for name, indices in self.elements() if name in names]
        return tuple((min(one), max(one)) for one in zip(*places)) == self.ranges

    @property
    def remark(self) -> str:
        """What its name and its type do not say; empty where its indices are behind its name."""
        is_plain = self.pattern == self.name + "_#" * len(self.ranges)
        said = "" if is_plain and not self.tops else shortened(self.name, self.pattern)
        return said + (f" up to {widths.said(self.tops)}" if self.tops else "")

    def own_kinds(self) -> Iterable[tuple[str, str]]:
        """(element, its type)"""
        for at, (name, _) in enumerate(self.elements()):
            yield name, widths.kind_of(self.tops[at]) if self.tops else self.kind[0]

    def element(self, indices: Sequence[int]) -> str:
        parts = iter(indices)
        name = _INDEX.sub(lambda match: str(next(parts) * int(match[1] or 1)), self.pattern)
        is_first = self.is_variable and self.pattern.endswith(_COUNTED) and indices[-1] == 1
        return name.removesuffix("_1") if is_first else name

    def elements(self) -> Iterable[tuple[str, Places]]:
        for indices in product(*(range(first, last + 1) for first, last in self.ranges)):
            yield self.element(indices), indices


def shortened(name: str, pattern: str) -> str:
    """From the word before the first index on that the name has as well: `_#_choice` of `a_#_choice`."""
    start = pattern.index("#")
    start = pattern.rindex("_", 0, start)
    for at in (start, pattern.rfind("_", 0, start)):
        if at > 0 and lengthened(name, pattern[at:]) == pattern:
            return pattern[at:]
    return pattern


def lengthened(name: str, remark: str) -> str:
    """The inverse of `shortened`."""
    end = _BEFORE_INDEX.sub("", remark)
    if not remark.startswith("_"):
        return remark
    match = re.fullmatch(rf"(.+){end}{_PLURAL if end else ''}", name)
    if match is None:
        raise FlowError(f"unknown form of VHDL: {name} does not end as its elements do")
    return match[1] + remark


def _type_name(kind: str) -> str:
    match = _RANGE.fullmatch(kind)
    if match:
        low = "" if match[1] == "natural" and match[3] == "0" else f"{'minus_' if match[2] else ''}{match[3]}_to_"
        return f"{match[1]}_{low}{match[4]}"
    wide = _UNSIGNED.fullmatch(kind)
    return f"unsigned_{int(wide[1]) + 1}" if wide else kind


def found_in(kinds: Mapping[str, Kind], taken: set[str], selections: Container[str] = ()) -> list[Array]:
    """Of signals. `kinds`: of names, in the order of their declarations; `taken`: names that an array cannot have;
    `selections`: names whose upper bits cost nothing in a wider type."""
    families: dict[str, dict[str, Kind]] = {}
    for name, kind in kinds.items():
        key = _NUMBER.sub("#", name)
        if key != name:
            families.setdefault(key, {})[name] = kind
    arrays = []
    used = taken | RESERVED
    for key, members in families.items():
        found = _of_family(key, members, {}, used)
        wide = _of_family(key, members, widths.common(members, selections), used)
        single = len(members) - sum(array.size for array in found)
        tops = [array.tops for array in wide]
        is_better = len(wide) < len(found) + single and (single > 0 or all(map(widths.is_one, tops)))
        if is_better and all(map(widths.is_sayable, tops)):
            found = wide
        arrays += found
        used |= {array.name for array in found}
    return arrays


def _of_family(key: str, members: Mapping[str, Kind], common: Mapping[str, Kind], used: set[str]) -> list[Array]:
    """`common`: types in place of their own."""
    numbers = {name: tuple(map(int, _NUMBER.findall(name))) for name in members}
    steps = _steps(list(numbers.values()))
    places = {_divided(numbers[name], steps): common.get(name, kind) for name, kind in members.items()}
    arrays: list[Array] = []
    for kind, ranges in sorted(_boxes(places), key=lambda box: box[1]):
        array = _named(key, kind, ranges, steps, used | {one.name for one in arrays})
        joined, tops = widths.joined([members[name][0] for name, _ in array.elements()])
        arrays.append(replace(array, kind=(joined, kind[1]), tops=tops))
    return arrays


def of_variables(kinds: Mapping[str, Kind], taken: set[str], kept: Container[str] = ()) -> list[Array]:
    """Those may have places for variables that do not exist, which get a value and are not read (defaults.py). `kept`:
    names that are in no such array."""
    families: dict[tuple[str, Kind], list[Places]] = {}
    keys = {_NUMBER.sub("#", name) for name in kinds}
    full: set[tuple[str, Kind]] = set()
    for name, kind in kinds.items():
        counted = f"{name}_1" if _NUMBER.sub("#", name) + _COUNTED in keys else name
        key = _NUMBER.sub("#", counted)
        if key != counted:
            families.setdefault((key, kind), []).append(tuple(map(int, _NUMBER.findall(counted))))
            if name in kept:
                full.add((key, kind))
    arrays = []
    used = taken | RESERVED
    for (key, kind), members in families.items():
        steps = _steps(members)
        divided = [_divided(one, steps) for one in members]
        for ranges in _frames(divided, 1 if (key, kind) in full else _FILLED, key.endswith(_COUNTED)):
            own = (
                (key.removesuffix(_COUNTED), kind, ranges[:-1])
                if _is_first(key, ranges, steps)
                else (key, kind, ranges)
            )
            arrays.append(replace(_named(*own, steps, used), is_variable=True))
            used.add(arrays[-1].name)
    return arrays


def _steps(members: Sequence[Places]) -> Places:
    """Of each index: the number of which all are multiples, as where a window has each second column."""
    indices = [set(one) for one in zip(*members)]
    return tuple(max(gcd(*one), 1) if len(one) >= _FEWEST_WITH_STEP else 1 for one in indices)


def _divided(places: Places, steps: Places) -> Places:
    return tuple(place // step for place, step in zip(places, steps))


def _frames(members: Sequence[Places], most: int, is_counted: bool) -> list[tuple[tuple[int, int], ...]]:
    """Bounds of arrays that have no more than `most` places for each of these."""
    bounds = tuple((min(one), max(one)) for one in zip(*members))
    if len(members) < FEWEST:
        return []
    if prod(last - low + 1 for low, last in bounds) <= most * len(members):
        return [bounds]
    full = [ranges for _, ranges in _boxes(dict.fromkeys(members, ("", "")))]
    first = [one for one in members if one[-1] == 1]
    if is_counted and len(bounds) > 1 and 0 < len(first) < len(members):
        others = [one for one in members if one[-1] > 1]
        parts = _frames(first, most, False) + _frames(others, most, False)
        if _declarations(members, parts) < _declarations(members, full):
            return parts
    return full


def _declarations(members: Sequence[Places], frames: Sequence[tuple[tuple[int, int], ...]]) -> int:
    """Of arrays, and of those in none of them."""
    single = [one for one in members if not any(_is_inside(one, ranges) for ranges in frames)]
    return len(frames) + len(single)


def _is_inside(places: Places, ranges: tuple[tuple[int, int], ...]) -> bool:
    return all(first <= place <= last for place, (first, last) in zip(places, ranges))


def _is_first(key: str, ranges: tuple[tuple[int, int], ...], steps: Places) -> bool:
    """Of variables without a count behind their names."""
    return key.endswith(_COUNTED) and ranges[-1] == (1, 1) and steps[-1] == 1


_Box = tuple[Kind, tuple[tuple[int, int], ...]]


def _boxes(members: Mapping[Places, Kind]) -> list[_Box]:
    """As few as are found, each of one kind and without a hole; names that are in none stay single."""
    return _split(tuple(sorted(members.items())))[1]


def _split(members: tuple[tuple[Places, Kind], ...]) -> tuple[int, list[_Box]]:
    """(declarations that are needed, boxes)"""
    dimensions = len(members[0][0])
    values = [sorted({places[at] for places, _ in members}) for at in range(dimensions)]
    kinds = {kind for _, kind in members}
    size = 1
    for one in values:
        size *= len(one)
    if len(kinds) == 1 and size == len(members) and all(one[-1] - one[0] + 1 == len(one) for one in values):
        if size < FEWEST:
            return size, []
        return 1, [(members[0][1], tuple((one[0], one[-1]) for one in values))]
    best: tuple[int, list[_Box]] = (len(members), [])
    for at in range(dimensions):
        if len(values[at]) == 1:
            continue
        parts = _slabs(members, at, values[at])
        if len(parts) == 1:
            continue
        results = [_split(part) for part in parts]
        cost = sum(needed for needed, _ in results)
        if cost < best[0]:
            best = cost, [box for _, boxes in results for box in boxes]
    return best


def _slabs(
    members: tuple[tuple[Places, Kind], ...], at: int, values: Sequence[int]
) -> list[tuple[tuple[Places, Kind], ...]]:
    """The members by their index at one place: neighbours of the same form together."""
    of_value: dict[int, list[tuple[Places, Kind]]] = {value: [] for value in values}
    for places, kind in members:
        of_value[places[at]].append((places, kind))

    def form(value: int) -> object:
        return [(places[:at] + places[at + 1 :], kind) for places, kind in of_value[value]]

    runs: list[list[int]] = []
    for value in values:
        if runs and runs[-1][-1] + 1 == value and form(runs[-1][-1]) == form(value):
            runs[-1].append(value)
        else:
            runs.append([value])
    return [tuple(sorted(one for value in run for one in of_value[value])) for run in runs]


def _named(key: str, kind: Kind, ranges: tuple[tuple[int, int], ...], steps: Places, used: set[str]) -> Array:
    """An index that all have stays in the name."""
    first, *rest = key.split("#")
    pattern = first
    for part, (low, high), step in zip(rest, ranges, steps):
        pattern += (str(low * step) if low == high else "#" if step == 1 else f"{step}#") + part
    varying = tuple(bound for bound in ranges if bound[0] != bound[1])
    base = _BEFORE_INDEX.sub("", pattern)
    # `choice` beside `choice_2` ..., and indices in two parts, as something between them is missing.
    names = [base, f"{base}s", f"{base}s_from_{varying[0][0]}", *(f"{base}s_{number}" for number in range(2, 1000))]
    name = next(one for one in names if one not in used)
    return Array(name, pattern, kind, varying)


def types_of(arrays: Iterable[Array]) -> list[str]:
    """Their declarations, each once."""
    texts = sorted({(array.type_name, array.type_text) for array in arrays})
    return [text for _, group in groupby(texts, key=lambda one: one[0]) for _, text in list(group)[:1]]
