# SPDX-License-Identifier: Apache-2.0
"""The signals `a_tag_valid`, `a_tag_end_of_line` ... of one tag as a record, `a_tag.valid`, copies of all its fields as
`a_tag <= b_tag;`, and back."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass

from .tree import Assign, If, Statement, inside
from .words import Words, is_flag, others, wrapped

FEWEST = 2  # fields of a record
_MEMBER = re.compile(r"(\w+_tag)_([a-z]\w*)")
_KIND = "boolean"  # of all fields
_TYPE = re.compile(rf"  type (\w+) is record\n((?:    [\w, ]+ : {_KIND};\n)+)  end record;\n")


@dataclass(frozen=True)
class Record:
    name: str  # of its type
    fields: tuple[str, ...]

    def lines(self) -> list[str]:
        return [f"  type {self.name} is record", *wrapped("    ", self.fields, f" : {_KIND};"), "  end record;"]


def found_in(kinds: Mapping[str, str], taken: Container[str]) -> dict[str, Record]:
    """{tag: its record} of signals. `kinds`: of their names, in the order of their declarations; `taken`: names that
    neither a tag nor a type can have."""
    tags: dict[str, list[str]] = {}
    others = set()
    for name, kind in kinds.items():
        match = _MEMBER.fullmatch(name)
        if match and kind == _KIND:
            tags.setdefault(match[1], []).append(match[2])
        elif match:
            others.add(match[1])
    types: dict[frozenset[str], Record] = {}
    found = {}
    for tag, fields in tags.items():
        if tag in others or tag in taken or len(fields) < FEWEST:
            continue
        if frozenset(fields) not in types:
            used = {one.name for one in types.values()}
            names = [f"tag_{len(fields)}", *(f"tag_{len(fields)}_{letter}" for letter in "bcdefghijklmnopqrstuvwxyz")]
            free = [name for name in names if name not in used and name not in taken]
            types[frozenset(fields)] = Record(free[0], tuple(fields))
        found[tag] = types[frozenset(fields)]
    return found


def members(records: Mapping[str, Record]) -> dict[str, str]:
    """{name of a signal of its own: name as a field}"""
    return {f"{tag}_{name}": f"{tag}.{name}" for tag, record in records.items() for name in record.fields}


def types_of(records: Mapping[str, Record]) -> list[str]:
    return [line for record in dict.fromkeys(records.values()) for line in record.lines()]


def read(text: str) -> tuple[str, dict[str, Record]]:
    """(text without the types of records, {type: record})"""
    found = {}
    for name, lines in _TYPE.findall(text):
        found[name] = Record(name, tuple(re.findall(r"\w+", lines.replace(f" : {_KIND};", ""))))
    return _TYPE.sub("", text), found


def made(statements: Sequence[Statement], records: Mapping[str, Record]) -> tuple[Statement, ...]:
    found: list[Statement] = []
    at = 0
    while at < len(statements):
        one = statements[at]
        if isinstance(one, If):
            one = inside(one, lambda branch: made(branch, records))
        size, whole = _whole(statements, at, records)
        found.append(whole or one)
        at += size
    return tuple(found)


def _whole(statements: Sequence[Statement], at: int, records: Mapping[str, Record]) -> tuple[int, Assign | None]:
    """(statements, the one in their place)"""
    one = statements[at]
    if not isinstance(one, Assign):
        return 1, None
    tag, _, name = one.words[0].partition(".")
    record = records.get(tag)
    if record is None or name != record.fields[0]:
        return 1, None
    value = one.words[2:]
    source, _, _ = value[0].partition(".")
    if len(value) == 1 and value[0] == f"{source}.{name}" and records.get(source) == record:
        said: Words = (source,)
    elif is_flag(value):
        said = others(value, 1)
    else:
        return 1, None
    whole = Assign((tag, one.words[1], *said))
    size = len(record.fields)
    return (size, whole) if tuple(statements[at : at + size]) == _fields_of(whole, records) else (1, None)


def _fields_of(one: Assign, records: Mapping[str, Record]) -> tuple[Statement, ...]:
    """Field by field."""
    tag, sign, *value = one.words
    found = []
    for name in records[tag].fields:
        said = [value[3]] if value[0] == "(" else [f"{value[0]}.{name}"]
        found.append(Assign((f"{tag}.{name}", sign, *said)))
    return tuple(found)


def unmade(statements: Iterable[Statement], records: Mapping[str, Record]) -> tuple[Statement, ...]:
    found: list[Statement] = []
    for one in statements:
        if isinstance(one, If):
            found.append(inside(one, lambda branch: unmade(branch, records)))
        elif isinstance(one, Assign) and one.words[0] in records:
            found += _fields_of(one, records)
        else:
            found.append(one)
    return tuple(found)
