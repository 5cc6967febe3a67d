# SPDX-License-Identifier: Apache-2.0
"""The text of a core in its parts, as the lowering writes it or as it is presented."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from ...base.errors import FlowError
from . import functions, records, tree, widths
from .arrays import Array, types_of
from .records import Record
from .words import split, wrapped

MARK = "-- Where a comment behind a declaration has #, the C++ has the indices.\n"
_DECLARATION = re.compile(r"(signal|variable) ([\w, ]+) : ([^;]+);(?:  -- ([\w#]+)(?: up to (.+))?)?")
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
    text, types = records.read(functions.without(text).replace(MARK, "", 1))
    lines = text.splitlines()
    try:
        start = next(at for at, line in enumerate(lines) if line.startswith(("  signal ", "  type ")))
        begin = lines.index("begin", start)
        process = lines.index("  process (clock)", begin)
        body = lines.index("  begin", process)
        end = lines.index("  end process;", body)
    except (StopIteration, ValueError):
        raise FlowError("unknown form of VHDL: no core of this project") from None
    kinds = {match[1]: match[2] for line in lines[start:begin] if (match := _TYPE.fullmatch(line))}
    declared = [line for line in lines[start:begin] if not _TYPE.fullmatch(line)]
    core = Core(
        lines[:start],
        _declarations(declared, kinds),
        lines[begin + 1 : process],
        [one for one in _declarations(lines[process + 1 : body], kinds, True) if not isinstance(one, str)],
        tree.read(split("\n".join(lines[body + 1 : end]))),
        lines[end:],
    )
    both = [*core.declarations, *core.variables]
    core.arrays = {one.name: one for one in both if isinstance(one, Array)}
    kept = [one for one in core.declarations if isinstance(one, Names) and one.kind in types]
    core.records = {name: types[one.kind] for one in kept for name in one.names}
    return core


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
            places = pattern or name + "_#" * len(ranges)
            own = widths.read(tops) if tops else ()
            found.append(Array(name, places, (kinds[array[1]], ""), ranges, is_variable, own))
    return found


def text(core: Core, is_presented: bool = False) -> str:
    lines = list(core.head)
    if is_presented:
        lines.insert(lines.index("library ieee;"), MARK.rstrip())
    lines += core.functions.splitlines()
    lines += [*(f"  {one}" for one in types_of(core.arrays.values())), *records.types_of(core.records)]
    lines += _declared("  signal ", core.declarations)
    lines += ["", "begin", *core.concurrent, "  process (clock)"]
    lines += [*_declared("    variable ", core.variables), "  begin"]
    lines += [*tree.lines(core.body, "    "), *core.end]
    return "\n".join(lines) + "\n"


def _declared(start: str, declarations: Iterable[str | Names | Array]) -> list[str]:
    lines: list[str] = []
    for one in joined(declarations):
        if isinstance(one, str):
            lines.append(f"  -- {one}")
        elif isinstance(one, Names):
            lines += wrapped(start, one.names, f" : {one.kind};")
        else:
            lines.append(f"{start}{one.name} : {one.type_name}({one.constraint});  -- {one.remark}")
    return lines


def joined(declarations: Iterable[str | Names | Array]) -> Iterator[str | Names | Array]:
    """Neighbours of one type together."""
    open_names: Names | None = None
    for one in declarations:
        kind, names = "", []
        if isinstance(one, Names):
            kind, names = one.kind, one.names
        elif isinstance(one, Array) and one.is_plain:
            kind, names = f"{one.type_name}({one.constraint})", [one.name]
        if open_names and open_names.kind != kind:
            yield open_names
            open_names = None
        if not kind:
            yield one
        elif open_names:
            open_names.names += names
        else:
            open_names = Names(kind, list(names))
    if open_names:
        yield open_names
