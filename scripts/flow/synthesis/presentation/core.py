# SPDX-License-Identifier: Apache-2.0
"""The text of a core in its parts, as the lowering writes it or as it is presented."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from ...base.errors import FlowError
from . import functions, layout, records, tree, widths
from .arrays import Array, lengthened, types_of
from .records import Record
from .words import folded, joined as words_joined, split, wrapped

MARK = "-- Where a comment behind a declaration has #, the C++ has the indices.\n"
_ENDS = "-- One that begins with _ says the ends of the names: `a_valid` with `_#_valid` is a_INDEX_valid there.\n"
_DECLARATION = re.compile(r"(signal|variable) ([\w, ]+) : ([^;]+);(?:  -- ([\w#]+)?(?: ?up to (.+))?)?")
_OPEN = re.compile(r" *(signal|variable) [^;]*$")
_REMARK = "  -- "
_PROCESS, _OF_CLOCK = "  process", "  process (clock)"
_WAIT = ("wait", "until")
_NO_BREAK = "\0"
_ARRAY = re.compile(r"(\w+_\dd)\((.*)\)")
_TYPE = re.compile(r"  type (\w+) is array \([^)]*\) of (.*);")


@dataclass
class Names:
    """Of one type, declared together."""

    kind: str
    names: list[str]


@dataclass
class Core:
    head: list[str]  # lines up to the declarations
    declarations: list[str | Names | Array]  # a text: a comment
    concurrent: list[str]  # lines between `begin` and the process
    variables: list[Names | Array]
    body: tuple[tree.Statement, ...]
    end: list[str]
    functions: str = ""  # their text, besides those of the lowering
    arrays: dict[str, Array] = field(default_factory=dict)
    records: dict[str, Record] = field(default_factory=dict)  # of signals


def read(text: str) -> Core:
    text, types = records.read(functions.without(text).replace(MARK, "", 1).replace(_ENDS, "", 1))
    lines = text.splitlines()
    try:
        start = next(at for at, line in enumerate(lines) if line.startswith(("  signal ", "  type ")))
        begin = lines.index("begin", start)
        process = next(at for at, line in enumerate(lines) if at > begin and line in (_PROCESS, _OF_CLOCK))
        body = lines.index("  begin", process)
        end = lines.index("  end process;", body)
    except (StopIteration, ValueError):
        raise FlowError("unknown form of VHDL: no core of this project") from None
    kinds = {match[1]: match[2] for line in lines[start:begin] if (match := _TYPE.fullmatch(line))}
    declared = _unfolded(line for line in lines[start:begin] if not _TYPE.fullmatch(line))
    core = Core(
        lines[:start],
        _declarations(declared, kinds),
        lines[begin + 1 : process],
        [one for one in _declarations(_unfolded(lines[process + 1 : body]), kinds, True) if not isinstance(one, str)],
        _of_clock(tree.read(split("\n".join(lines[body + 1 : end])))),
        lines[end:],
    )
    both = [*core.declarations, *core.variables]
    core.arrays = {one.name: one for one in both if isinstance(one, Array)}
    kept = [one for one in core.declarations if isinstance(one, Names) and one.kind in types]
    core.records = {name: types[one.kind] for one in kept for name in one.names}
    return core


def _unfolded(lines: Iterable[str]) -> list[str]:
    """Each declaration on one line."""
    found: list[str] = []
    for line in lines:
        if found and _OPEN.match(found[-1]):
            found[-1] += f" {line.strip()}"
        else:
            found.append(line)
    return found


def _declarations(lines: list[str], kinds: dict[str, str], is_variable: bool = False) -> list[str | Names | Array]:
    found: list[str | Names | Array] = []
    for line in lines:
        match = _DECLARATION.fullmatch(line.strip())
        if not line.strip():
            continue
        if match is None:
            if not line.strip().startswith("--"):
                raise FlowError(f"unknown form of VHDL: '{line.strip()}'")
            found.append(line.strip()[2:].strip())
            continue
        _, names, kind, pattern, tops = match.groups()
        array = _ARRAY.fullmatch(kind)
        if array is None:
            found.append(Names(kind, names.split(", ")))
            continue
        if array[1] not in kinds:
            raise FlowError(f"unknown form of VHDL: no type {array[1]}")
        ranges = tuple((int(low), int(high)) for low, high in re.findall(r"(\d+) to (\d+)", array[2]))
        for name in names.split(", "):
            places = lengthened(name, pattern) if pattern else name + "_#" * len(ranges)
            own = widths.read(tops) if tops else ()
            found.append(Array(name, places, (kinds[array[1]], ""), ranges, is_variable, own))
    return found


def text(core: Core, is_presented: bool = False) -> str:
    lines = list(core.head)
    if is_presented:
        at = lines.index("library ieee;")
        lines[at:at] = (MARK + _ENDS).splitlines()
    lines += core.functions.splitlines()
    lines += [*(f"  {one}" for one in types_of(core.arrays.values())), *records.types_of(core.records)]
    # The order of signals decides what synthesis makes of ties, that of variables nothing.
    lines += _declared("  signal ", joined(core.declarations), is_presented)
    lines += ["", "begin", *core.concurrent, _PROCESS if is_presented else _OF_CLOCK]
    lines += [
        *_declared("    variable ", (grouped if is_presented else joined)(core.variables), is_presented),
        "  begin",
    ]
    lines += [*(_with_wait(core.body) if is_presented else tree.lines(core.body, "    ")), *core.end]
    return "\n".join(lines) + "\n"


def _with_wait(body: tuple[tree.Statement, ...]) -> Iterator[str]:
    """The clocked statements behind a wait for the clock."""
    (clocked,) = body
    assert isinstance(clocked, tree.If)
    yield f"    wait until {words_joined(clocked.test)};"
    yield from layout.lines(clocked.then, "    ")


def _of_clock(body: tuple[tree.Statement, ...]) -> tuple[tree.Statement, ...]:
    """The inverse of `_with_wait`."""
    first = body[0] if body else None
    if not isinstance(first, tree.Assign) or first.words[:2] != _WAIT:
        return body
    return (tree.If(first.words[2:], body[1:], None),)


def _declared(start: str, declarations: Iterable[str | Names], is_folded: bool) -> list[str]:
    lines: list[str] = []
    for one in declarations:
        if isinstance(one, str):
            lines.append(f"  -- {one}")
            continue
        kind, _, remark = one.kind.partition(_REMARK)
        end = f" : {kind};"
        shown = _folded(start + ", ".join(one.names), end) if is_folded else wrapped(start, one.names, end)
        lines += [*shown[:-1], shown[-1] + (_REMARK + remark if remark else "")]
    return lines


def _folded(names: str, end: str) -> list[str]:
    """Broken between names."""
    return [line.replace(_NO_BREAK, " ") for line in folded(names + end.replace(" ", _NO_BREAK))]


def joined(declarations: Iterable[str | Names | Array]) -> Iterator[str | Names]:
    """Neighbours of one type together."""
    open_names: Names | None = None
    for one in map(_said, declarations):
        if open_names and isinstance(one, Names) and one.kind == open_names.kind:
            open_names.names += one.names
            continue
        if open_names:
            yield open_names
        open_names = one if isinstance(one, Names) else None
        if isinstance(one, str):
            yield one
    if open_names:
        yield open_names


def grouped(declarations: Iterable[str | Names | Array]) -> Iterator[Names]:
    """All of one type together."""
    groups: dict[str, Names] = {}
    for one in map(_said, declarations):
        assert isinstance(one, Names)
        groups.setdefault(one.kind, Names(one.kind, [])).names += one.names
    yield from groups.values()


def _said(one: str | Names | Array) -> str | Names:
    """With what stands behind the names as its type."""
    if isinstance(one, Array):
        return Names(f"{one.type_name}({one.constraint})" + (_REMARK + one.remark if one.remark else ""), [one.name])
    return Names(one.kind, list(one.names)) if isinstance(one, Names) else one
