# SPDX-License-Identifier: Apache-2.0
"""The text of a core with arrays, loops and tests of bits, and the inverse, which gives back every word."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from ...base.errors import FlowError
from . import (
    arrays,
    bits,
    choices,
    comparisons,
    core,
    defaults,
    differences,
    functions,
    loops,
    memories,
    records,
    slices,
    tree,
    widths,
)
from .arrays import Array, Places
from .core import Core, Names
from .records import Record
from .words import Words, joined, split

_READ_DATA = re.compile(r"\bread_data => (\w+)")
_REFERENCE = re.compile(r"\b(\w+)(?:\(\d+(?:, \d+)*\)|\.\w+)")
_JOINED = re.compile(r"std_logic_vector\((.* & .*)\);$")
_QUALIFIED = re.compile(r"std_logic_vector\(unsigned'\((.*)\)\);$")
_NAME = re.compile(r"\b[a-z]\w*\b")


def present(text: str) -> str:
    """Of what the lowering writes. The same again of what is presented already."""
    scalar = _in_order_of_use(core.read(expand(text)))
    presented = core.text(_folded(scalar), True)
    if _content(core.read(expand(presented))) != _content(scalar):
        raise FlowError("the presented VHDL does not expand to what was written")
    return presented


def expand(text: str) -> str:
    """With a signal for each element, as the lowering writes it."""
    if not is_presented(text):
        return text
    try:
        return core.text(_expanded(core.read(text)))
    except (ValueError, LookupError) as error:  # edited by hand
        raise FlowError(f"unknown form of VHDL: {error}") from None


def is_presented(text: str) -> bool:
    return core.MARK in text


def _in_order_of_use(scalar: Core) -> Core:
    """Its variables in the order in which statements name them, whatever the order of their declarations: that which
    the lowering wrote is lost where presented VHDL is presented again."""
    used = dict.fromkeys(word for words in tree.all_words(scalar.body) for word in words)
    kinds = _kinds(scalar.variables)
    ordered = [name for name in used if name in kinds] + sorted(kinds.keys() - used.keys())
    return replace(scalar, variables=[Names(kinds[name], [name]) for name in ordered])


def _content(scalar: Core) -> object:
    """All but the order and the layout of declarations."""
    declared = [(one.kind, name) for one in scalar.declarations if isinstance(one, Names) for name in one.names]
    variables = [(one.kind, name) for one in scalar.variables if isinstance(one, Names) for name in one.names]
    comments = [one for one in scalar.declarations if isinstance(one, str)]
    return (
        [scalar.head, comments, scalar.concurrent, scalar.end, scalar.body],
        sorted(declared),
        sorted(variables),
    )


# --- there ------------------------------------------------------------------------------------------------------------


def _kinds(declarations: Iterable[str | Names | Array]) -> dict[str, str]:
    return {name: one.kind for one in declarations if isinstance(one, Names) for name in one.names}


def _folded(scalar: Core) -> Core:
    ports, cells = memories.read(scalar.concurrent, _kinds(scalar.declarations))
    own = {f"{cell.label}_{name}" for cell in cells for name in cell.types()}
    signals = {name: kind for name, kind in _kinds(scalar.declarations).items() if name not in own}
    kinds = signals | _kinds(scalar.variables)
    compared = _with_comparisons(scalar, kinds)
    kinds = signals | _kinds(compared.variables)
    of_memories = set(_READ_DATA.findall("\n".join(scalar.concurrent)))
    taken = set(_NAME.findall("\n".join(scalar.head + ports))) | kinds.keys() | memories.LOCAL | functions.NAMES
    made = _of_signals(scalar, signals, of_memories, taken)
    made += _of_variables(compared, taken | {array.name for array in made})
    places = {
        name: (array, indices)
        for array in made
        for name, indices in array.elements()
        if not array.is_variable or kinds.get(name) == array.kind[0]
    }
    known = {array.name: array for array in made}
    reserved = taken | kinds.keys() | known.keys()
    tags = records.found_in({name: kind for name, kind in signals.items() if name not in places}, reserved)
    fields = records.members(tags)

    def shown(words: Words) -> Words:
        return _renamed(_with_arrays(words, places), fields)

    body = records.made(slices.made(_mapped(compared.body, shown), known), tags)
    filled = Counter(array.name for array, _ in places.values())
    sparse = [array for array in made if array.is_variable and 0 < filled[array.name] < array.size]
    sparse.sort(key=lambda array: array.name)
    shown_cells = [memories.in_words(cell, lambda words: shown(_with_bits(words, kinds))) for cell in cells]
    types = kinds | {field: kinds[name] for name, field in fields.items()}
    chosen = {known[words[0]].kind[0] if words[0] in known else types[words[0]] for words in _choices(body)}
    used = {word for words in [*tree.all_words(body), *(cell.words for cell in shown_cells)] for word in words}
    return Core(
        scalar.head,
        _grouped(_in_records(_without(scalar.declarations, own), tags, fields), places),
        [_NAME.sub(lambda match: _reference(match[0], places, fields), _qualified(line)) for line in ports]
        + memories.presented(shown_cells, loops.variables(reserved)[0], known, reserved | tags.keys()),
        [one for one in _grouped(compared.variables, places) if not isinstance(one, str)],
        loops.fold(defaults.made(body, sparse), reserved),
        scalar.end,
        functions.needed(used, chosen),
        known,
        tags,
    )


def _with_comparisons(scalar: Core, kinds: Mapping[str, str]) -> Core:
    """With bits, choices and comparisons, and without the variables that these make needless."""
    (clocked,) = choices.made(_mapped(scalar.body, lambda words: _with_bits(words, kinds)))
    assert isinstance(clocked, tree.If)
    then = differences.made(comparisons.made(clocked.then, _kinds(scalar.variables)), kinds)
    body = (tree.If(clocked.test, then, clocked.otherwise),)
    gone = _kinds(scalar.variables).keys() - {word for words in tree.all_words(body) for word in words}
    variables = [one for one in _without(scalar.variables, gone) if not isinstance(one, str)]
    return replace(scalar, variables=variables, body=body)


def _renamed(words: Words, names: Mapping[str, str]) -> Words:
    return tuple(names.get(word, word) for word in words)


def _in_records(
    declarations: Iterable[str | Names | Array], tags: Mapping[str, Record], fields: Mapping[str, str]
) -> Iterable[str | Names | Array]:
    """Tags where their first fields stood."""
    there: set[str] = set()
    for one in declarations:
        if not isinstance(one, Names):
            yield one
            continue
        for name in one.names:
            tag, _, _ = fields.get(name, "").partition(".")
            if not tag:
                yield Names(one.kind, [name])
            elif tag not in there:
                there.add(tag)
                yield Names(tags[tag].name, [tag])


def _of_signals(scalar: Core, signals: Mapping[str, str], of_memories: set[str], taken: set[str]) -> list[Array]:
    clocked = _assigned(scalar.body)
    in_arrays = {
        name: (kind, "memory" if name in of_memories else "process")
        for name, kind in signals.items()
        if name in of_memories or name in clocked
    }
    selections = widths.selections(scalar.body, {**signals, **_kinds(scalar.variables)})
    return arrays.found_in(in_arrays, taken, selections)


def _of_variables(compared: Core, taken: set[str]) -> list[Array]:
    variables = _kinds(compared.variables)
    early = defaults.read_first(compared.body, variables)
    return arrays.of_variables({name: (kind, "variable") for name, kind in variables.items()}, taken, early)


def _without(declarations: Iterable[str | Names | Array], names: set[str]) -> Iterable[str | Names | Array]:
    for one in declarations:
        if not isinstance(one, Names):
            yield one
        elif left := [name for name in one.names if name not in names]:
            yield Names(one.kind, left)


def _choices(statements: Iterable[tree.Statement]) -> Iterable[Words]:
    for words in tree.all_words(statements):
        if any(sign in words and words[words.index(sign) + 1] == choices.NAME for sign in ("<=", ":=")):
            yield words


def _assigned(statements: Iterable[tree.Statement]) -> set[str]:
    return {words[0] for words in tree.all_words(statements) if words[1:2] in (("<=",), (":=",))}


def _mapped(statements: Iterable[tree.Statement], change: Callable[[Words], Words]) -> tuple[tree.Statement, ...]:
    """With all assignments and tests changed."""
    found: list[tree.Statement] = []
    for one in statements:
        if isinstance(one, tree.Assign):
            found.append(tree.Assign(change(one.words)))
        elif isinstance(one, tree.If):
            otherwise = None if one.otherwise is None else _mapped(one.otherwise, change)
            found.append(tree.If(change(one.test), _mapped(one.then, change), otherwise))
        else:
            found.append(one)
    return tuple(found)


def _value(words: Words, change: Callable[[Words, Mapping[str, str]], Words], kinds: Mapping[str, str]) -> Words:
    """Changes the value of an assignment to a plain name, or a test."""
    if words[1:2] in ((":=",), ("<=",)) and len(words) > 2:
        return words[:2] + change(words[2:], kinds)
    return change(words, kinds)


def _with_bits(words: Words, kinds: Mapping[str, str]) -> Words:
    return _value(words, bits.named, kinds)


def _with_arrays(words: Words, places: Mapping[str, tuple[Array, Places]]) -> Words:
    found: list[str] = []
    for word in words:
        if word in places:
            array, indices = places[word]
            found += [array.name, "("]
            for index in indices:
                found += [str(index), ","]
            found[-1] = ")"
        else:
            found.append(word)
    return tuple(found)


def _qualified(line: str) -> str:
    """An `&` of words may make an array of two words as well, where there are arrays of words."""
    return _JOINED.sub(r"std_logic_vector(unsigned'(\1));", line)


def _reference(word: str, places: Mapping[str, tuple[Array, Places]], fields: Mapping[str, str]) -> str:
    if word not in places:
        return fields.get(word, word)
    array, indices = places[word]
    return f"{array.name}({', '.join(map(str, indices))})"


def _grouped(
    declarations: Iterable[str | Names | Array], places: Mapping[str, tuple[Array, Places]]
) -> list[str | Names | Array]:
    """Arrays where their first elements stood."""
    found: list[str | Names | Array] = []
    there: set[str] = set()
    for one in declarations:
        if not isinstance(one, Names):
            found.append(one)
            continue
        for name in one.names:
            if name in places:
                array, _ = places[name]
                if array.name not in there:
                    there.add(array.name)
                    found.append(array)
            elif found and isinstance(found[-1], Names) and found[-1].kind == one.kind:
                found[-1].names.append(name)
            else:
                found.append(Names(one.kind, [name]))
    return found


# --- and back ---------------------------------------------------------------------------------------------------------


def _expanded(presented: Core) -> Core:
    known = presented.arrays
    ports, cells = memories.back(presented.concurrent)
    names = {field: name for name, field in records.members(presented.records).items()}
    there: set[tuple[str, str]] = set()  # (array, element) that are named; one of variables may have places for more

    def without_arrays(words: Words) -> Words:
        return _renamed(_without_arrays(words, known, there), names)

    def name(match: re.Match[str]) -> str:
        is_known = match[1] in known or match[0] in names
        return joined(without_arrays(tuple(split(match[0])))) if is_known else match[0]

    lines = [_REFERENCE.sub(name, _QUALIFIED.sub(r"std_logic_vector(\1);", line)) for line in ports]
    with_defaults = loops.unroll(presented.body)
    sparse, body = defaults.names(with_defaults, known), defaults.unmade(with_defaults, known)
    by_fields = records.unmade(slices.unmade(body, known), presented.records)
    with_elements = _mapped(by_fields, without_arrays)
    cells = [memories.in_words(cell, without_arrays) for cell in cells]
    declarations = _single(_by_fields(presented), there, sparse)
    variables = [one for one in _single(presented.variables, there, sparse) if not isinstance(one, str)]
    with_steps, steps = _with_own_variables(with_elements, _kinds(variables), _kinds(declarations))
    variables += [Names(comparisons.KIND, steps)] if steps else []
    kinds = _kinds([*declarations, *variables])
    cells = [memories.in_words(cell, lambda words: bits.arithmetic(words, kinds)) for cell in cells]
    own = [Names(kind, [f"{cell.label}_{name}"]) for cell in cells for name, kind in cell.types().items()]
    return Core(
        presented.head,
        [*declarations, *own],
        memories.written(lines, cells),
        variables,
        _mapped(choices.unmade(with_steps), lambda words: _value(words, bits.arithmetic, kinds)),
        presented.end,
    )


def _with_own_variables(
    body: tuple[tree.Statement, ...], variables: Mapping[str, str], signals: Mapping[str, str]
) -> tuple[tuple[tree.Statement, ...], list[str]]:
    """(the statements without comparisons and counts of bits, the variables of these)"""
    (clocked,) = body
    if not isinstance(clocked, tree.If):
        raise ValueError("no clock")
    counted, values = differences.unmade(clocked.then, {**signals, **variables})
    then, steps = comparisons.unmade(counted, {**variables, **dict.fromkeys(values, differences.KIND)})
    return (tree.If(clocked.test, then, clocked.otherwise),), [*values, *steps]


def _by_fields(presented: Core) -> Iterable[str | Names | Array]:
    for one in presented.declarations:
        if isinstance(one, Names) and one.names[0] in presented.records:
            for tag in one.names:
                yield Names("boolean", [f"{tag}_{name}" for name in presented.records[tag].fields])
        else:
            yield one


def _single(
    declarations: Iterable[str | Names | Array], there: set[tuple[str, str]], sparse: set[str]
) -> list[str | Names | Array]:
    found: list[str | Names | Array] = []
    for one in declarations:
        if not isinstance(one, Array):
            found.append(one)
            continue
        used = {name for name, _ in one.elements() if (one.name, name) in there}
        if one.name in sparse and not one.is_spanned_by(used):
            raise FlowError(f"unknown form of VHDL: nothing needs all of {one.name}")
        found += [Names(kind, [name]) for name, kind in one.own_kinds() if one.name not in sparse or name in used]
    return found


def _without_arrays(words: Words, known: Mapping[str, Array], there: set[tuple[str, str]]) -> Words:
    """`there` gets the elements, with the names of their arrays."""
    found: list[str] = []
    at = 0
    while at < len(words):
        array = known.get(words[at])
        if array is None:
            found.append(words[at])
            at += 1
            continue
        end = words.index(")", at)
        found.append(array.element([int(word) for word in words[at + 2 : end] if word != ","]))
        there.add((array.name, found[-1]))
        at = end + 1
    return tuple(found)
